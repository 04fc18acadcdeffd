//! `sextic report` as a user runs it: one file, complete, well formed, and on its own.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use roxmltree::{Document, Node, ParsingOptions};
use serde_json::Value;

use super::{block, document, sextic, warnings};

fn out(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("reports");
    std::fs::create_dir_all(&folder).expect("a folder for reports");
    let path = folder.join(name);
    let _ = std::fs::remove_file(&path);
    path
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a path")
}

/// The exit status, standard error, and the page if there is one.
fn report(arguments: &[&str], out: &Path) -> (Option<i32>, String, Option<String>) {
    let output = sextic(&[&["report", "--out", text(out)], arguments].concat());
    let errors = String::from_utf8(output.stderr).expect("UTF-8");
    (
        output.status.code(),
        errors,
        std::fs::read_to_string(out).ok(),
    )
}

fn parse(page: &str) -> Document<'_> {
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(page, options).expect("a well-formed page")
}

fn words(node: Node) -> String {
    let texts = node
        .descendants()
        .filter_map(|own| own.text().filter(|_| own.is_text()));
    texts.collect()
}

/// Nothing is loaded, nothing runs, every anchor is there, and no identifier twice.
fn stands_alone(page: &Document) {
    let mut identifiers = BTreeSet::new();
    for node in page.descendants() {
        let identifier = node.attribute("id");
        assert!(
            identifier.is_none_or(|id| identifiers.insert(id)),
            "{identifier:?} twice"
        );
    }
    for node in page.descendants().filter(Node::is_element) {
        let name = node.tag_name().name();
        let forbidden = [
            "script", "link", "iframe", "object", "embed", "base", "img", "image", "use",
        ];
        assert!(!forbidden.contains(&name), "<{name}>");
        for attribute in node.attributes() {
            let (key, value) = (attribute.name(), attribute.value());
            assert!(
                !key.starts_with("on") && key != "src" && key != "srcset",
                "{key}={value}"
            );
            if key == "href" {
                assert_eq!(name, "a", "{value}");
                let is_anchor = value
                    .strip_prefix('#')
                    .is_some_and(|id| identifiers.contains(id));
                let is_address = ["https://", "http://", "mailto:"]
                    .iter()
                    .any(|scheme| value.starts_with(scheme));
                assert!(is_anchor || is_address, "{value}");
            }
            assert!(!value.contains("url("), "{value}");
        }
        if name == "style" {
            let sheet = words(node);
            assert!(!sheet.contains("url(") && !sheet.contains("@import"));
        }
    }
}

fn case() -> String {
    format!(
        "{}/derivations/cases/tuned.toml",
        env!("CARGO_MANIFEST_DIR")
    )
}

#[test]
fn the_report_is_whole_and_refers_to_nothing_outside_of_itself() {
    let (first, second) = (out("first.html"), out("second.html"));
    let case = case();
    let (status, errors, page) = report(&["--case", &case], &first);
    assert_eq!(
        (status, warnings(&errors)),
        (Some(0), String::new()),
        "{errors}"
    );
    let page = page.expect("a page");
    assert_eq!(Some(&page), report(&["--case", &case], &second).2.as_ref());

    let page = parse(&page);
    stands_alone(&page);
    let root = page.root_element();
    assert_eq!(root.attribute("lang"), Some("en"));
    let of = |name: &'static str| root.descendants().filter(move |own| own.has_tag_name(name));
    assert_eq!(of("h1").count(), 1);
    assert_eq!(of("merror").count(), 0, "every formula is understood");
    assert!(of("math").count() > 500);
    let scripts = of("msup").chain(of("msub")).chain(of("mfrac"));
    for own in scripts {
        let parts = own.children().filter(Node::is_element).count();
        assert_eq!(parts, 2, "{}", words(own));
    }
    assert!(of("table").all(|table| {
        table
            .descendants()
            .any(|own| own.attribute("scope") == Some("col"))
    }));
    let figure = of("svg").next().expect("the curves");
    assert!(
        figure
            .children()
            .any(|own| own.has_tag_name((figure.tag_name().namespace().unwrap_or(""), "title")))
    );

    let audit = sextic(&["audit", "--format", "json"]);
    let audit: Value = serde_json::from_slice(&audit.stdout).expect("JSON");
    for claim in audit["documents"][0]["claims"].as_array().expect("claims") {
        let id = format!("document-1-claim-{}", claim["id"].as_str().expect("an id"));
        let own = root
            .descendants()
            .find(|own| own.attribute("id") == Some(&*id));
        let said = words(own.unwrap_or_else(|| panic!("there is no {id}")));
        for key in ["verdict", "label", "description"] {
            let expected = claim[key].as_str().unwrap_or_default();
            assert!(said.contains(expected), "{id}: {key} {expected} in {said}");
        }
        for (key, keyword) in [
            ("conditions", "where"),
            ("neglected", "neglects"),
            ("witness", "at"),
        ] {
            let given = &claim[key];
            if given.is_object() || given.as_array().is_some_and(|all| !all.is_empty()) {
                let terms = own.into_iter().flat_map(|own| own.descendants());
                let mut terms = terms.filter(|own| own.has_tag_name("dt"));
                assert!(terms.any(|own| words(own) == keyword), "{id}: {keyword}");
            }
        }
    }
    let said = words(root);
    for expected in [
        "The coefficients, power by power",
        "Where the section is unstable",
        "21° to 180°",
        "1, mostly theta",
        "by more than its error",
        "each verdict is proven",
        "How the methods agree",
        "from the lowest wind speeds on: 0° to",
        "Where the closed forms may be trusted",
        "sextic speeds",
        "sextic validity",
        "sextic audit --explain ID",
        "sextic match",
        "formulas.csv",
    ] {
        assert!(said.contains(expected), "{expected}");
    }
}

#[test]
fn what_does_not_apply_to_a_case_is_said_in_its_report() {
    let folder = super::folder("held_report");
    let path = folder.join("tuned.toml");
    let case = std::fs::read_to_string(&path).expect("a case");
    let held = case
        .replace("step = 0.5", "step = 20")
        .replace("[structure]", "[structure]\nfree = [\"x\", \"y\"]");
    std::fs::write(&path, held).expect("a case");
    let (status, errors, page) = report(&["--case", text(&path)], &out("held.html"));
    assert_eq!(
        (status, warnings(&errors)),
        (Some(0), String::new()),
        "{errors}"
    );
    let page = page.expect("a page");
    let page = parse(&page);
    stands_alone(&page);
    let said = words(page.root_element());
    for expected in ["No map of the errors of the closed forms", "sextic speeds"] {
        assert!(said.contains(expected), "{expected}");
    }
    assert!(!said.contains("sextic validity"));
}

#[test]
fn hostile_text_is_shown_and_not_obeyed() {
    let hostile = "# A &lt;script>alert('title')&lt;/script> & \"quotes\"\n\n\
        &lt;script>alert(1)&lt;/script>\n\nInline `<img src=\"https://nowhere.example/x.png\">` and &amp; \
        ![picture](https://nowhere.example/y.png) [run](javascript:alert(2)) [file](other.md)\n\n\
        ```sextic\nparameter a, b : m \"<b onclick='x'>bold</b> & {{ 1 + 1 }}\"\n\
        claim [one]: a + b == b + a \"</p><script>alert(3)</script>\"\n```\n";
    let path = document("hostile.md", hostile);
    let (status, errors, page) = report(&[text(&path)], &out("hostile.html"));
    assert_eq!(
        (status, warnings(&errors)),
        (Some(0), String::new()),
        "{errors}"
    );
    let page = page.expect("a page");
    let page = parse(&page);
    stands_alone(&page);
    let said = words(page.root_element());
    for expected in [
        "A <script>alert('title')</script> & \"quotes\"",
        "<script>alert(1)</script>",
        "<b onclick='x'>bold</b> & {{ 1 + 1 }}",
        "</p><script>alert(3)</script>",
        "picture run file",
    ] {
        assert!(said.contains(expected), "{expected} in {said}");
    }
}

#[test]
fn a_verdict_that_differs_is_reported_with_status_1() {
    let path = document("differs.md", &block("claim [one]: a == b"));
    let (status, errors, page) = report(&[text(&path)], &out("differs.html"));
    assert_eq!(status, Some(1));
    assert!(
        errors.contains("1 of 1 verdicts is NOT as the document expects"),
        "{errors}"
    );
    let page = page.expect("a page");
    let said = words(parse(&page).root_element());
    assert!(said.contains("NOT AS EXPECTED: the document expects “holds”"));
    assert!(said.contains("Verdicts that differ"));
}

#[test]
fn a_mistake_is_shown_in_the_report() {
    let wrong = document(
        "mistake.md",
        &block("K := a + c\nclaim [one]: K == a\nclaim [two]: a == a"),
    );
    let (status, errors, page) = report(&[text(&wrong)], &out("mistake.html"));
    assert_eq!(status, Some(2));
    assert!(errors.contains("mistake.md:5:"), "{errors}");
    let page = page.expect("a page");
    let said = words(parse(&page).root_element());
    for expected in ["is not known here", "skipped", "holds"] {
        assert!(said.contains(expected), "{expected} in {said}");
    }
}

#[test]
fn wrong_input_leaves_no_report() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let path = out("none.html");
    for (arguments, path, message) in [
        (
            &["no-such-document.md"][..],
            path.clone(),
            "there is no such file",
        ),
        (
            &["--case", "none.toml"],
            path.clone(),
            "there is no such file",
        ),
        (&[], folder.join("none").join("r.html"), "cannot be written"),
        (&[], folder, "it is a folder"),
    ] {
        let (status, errors, page) = report(arguments, &path);
        assert_eq!((status, page), (Some(2), None), "{errors}");
        assert!(errors.contains(message), "{errors}");
    }
}

#[test]
fn a_page_may_be_about_a_case_alone() {
    let case = format!(
        "{}/derivations/cases/scattered.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    let path = out("case.html");
    let arguments = ["--case", &case, "--only-case", "--set", "U=14"];
    let (status, _, page) = report(&arguments, &path);
    assert_eq!(status, Some(0));
    let page = page.expect("a page");
    let page = parse(&page);
    stands_alone(&page);
    let text = words(page.root_element());
    for said in [
        "Stability of scattered.toml",
        "Within the errors of the coefficients",
        "Wind speeds up to 100\u{202F}m/s, by the angle",
        "--only-case --set U=14",
    ] {
        assert!(text.contains(said), "{said}");
    }
    assert!(!text.contains("He & Macdonald (2017)") && !text.contains("sextic audit"));
    let (status, ..) = report(&["--only-case"], &path);
    assert_eq!(status, Some(2));
}
