//! README and the guides under `docs`: their commands run in a copy of what they speak of, and print
//! what the pages show.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use super::page::{Page, read, root};
use super::steps::{Step, difference, steps};

/// Pages under `docs` that say what is so, and have no commands.
const WITHOUT_COMMANDS: [&str; 3] = ["docs/adversary.md", "docs/meaning.md", "docs/python.md"];

/// Pages beside the documents, whose commands are run as those of guides are.
const BESIDE_DOCUMENTS: [&str; 2] = ["derivations/README.md", "derivations/cases/README.md"];

/// What some page shows with its output.
const COMMANDS: [&str; 16] = [
    "audit",
    "match",
    "certify",
    "generate",
    "evaluate",
    "stability",
    "sweep",
    "speeds",
    "modes",
    "compare",
    "validity",
    "figures",
    "report",
    "new",
    "show",
    "mutate",
];

/// The languages that a fence of README or a guide may have; `python/tests` runs what is Python.
const LANGUAGES: [&str; 8] = [
    "c", "console", "markdown", "matlab", "python", "sextic", "sh", "toml",
];

/// Programs that a machine may lack. What needs them is skipped there.
const OTHER_PROGRAMS: [&str; 3] = ["coqc", "gcc", "octave-cli"];

/// The command line that runs all tests, in README as in `.ci/run`.
const TESTS: &str = "cargo test --workspace --features parquet";

/// What stands before every command of a page.
const PREAMBLE: &str = r#"
set -o pipefail
cargo() {
    case "$*" in
        "run --release -- "*) shift 3; sextic "$@" ;;
        "test --workspace --features parquet") ;; # These are the tests.
        *) echo "a test cannot run: cargo $*" >&2; return 1 ;;
    esac
}
"#;

/// The pages under `docs`, in order.
pub fn docs() -> Vec<String> {
    let entries = fs::read_dir(root().join("docs")).expect("a folder");
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut pages: Vec<String> = names.map(|name| format!("docs/{name}")).collect();
    pages.sort();
    pages
}

/// README and all of `docs`.
fn pages() -> Vec<String> {
    [vec!["README.md".to_owned()], docs()].concat()
}

/// All pages whose commands are run.
fn pages_with_commands() -> Vec<String> {
    [pages(), BESIDE_DOCUMENTS.map(str::to_owned).into()].concat()
}

/// The folder in which the commands of a page run: a copy of what a clone has for them.
struct Place {
    folder: PathBuf,
}

impl Place {
    fn new(page: &str) -> Place {
        let name = page.replace(['/', '.'], "-");
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
        if folder.exists() {
            fs::remove_dir_all(&folder).expect("an old folder goes");
        }
        for part in ["README.md", "derivations"] {
            copy(&root().join(part), &folder.join(part));
        }
        Place { folder }
    }

    fn run(&self, script: &str) -> Output {
        let command = Path::new(env!("CARGO_BIN_EXE_sextic"));
        let own = command.parent().expect("the command is in a folder");
        let path = std::env::var("PATH").unwrap_or_default();
        Command::new("bash")
            .args(["-c", &format!("{PREAMBLE}{script}")])
            .env("PATH", format!("{}:{path}", own.display()))
            .env("NO_COLOR", "1")
            .current_dir(&self.folder)
            .output()
            .expect("a shell")
    }
}

fn copy(from: &Path, to: &Path) {
    if from.is_dir() {
        for entry in fs::read_dir(from).expect("a folder") {
            let name = entry.unwrap().file_name();
            copy(&from.join(&name), &to.join(&name));
        }
    } else {
        fs::create_dir_all(to.parent().expect("a folder")).expect("a folder");
        fs::copy(from, to).expect("a file is copied");
    }
}

/// A program that commands need and that is not there.
fn missing(script: &str) -> Option<&'static str> {
    let is_needed = |program: &&str| {
        let mut words = script.lines().filter_map(|line| line.split(' ').next());
        words.any(|word| word == *program)
    };
    let mut needed = OTHER_PROGRAMS.into_iter().filter(is_needed);
    needed.find(|program| Command::new(program).arg("--version").output().is_err())
}

/// What is not as a page says.
fn faults(path: &str) -> Vec<String> {
    let place = Place::new(path);
    let mut faults = Vec::new();
    for step in steps(&Page::of(path)) {
        let (script, shown) = match &step {
            Step::File { name, text } => {
                let file = place.folder.join(name);
                fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
                fs::write(file, text).expect("a file");
                continue;
            }
            Step::Commands(commands) => (format!("set -e\n{commands}"), None),
            Step::Shown { command, output } => (command.clone(), Some(output)),
        };
        if let Some(program) = missing(&script) {
            eprintln!("the rest of {path} is skipped: there is no {program}");
            break;
        }
        let output = place.run(&script);
        let [out, err] = [&output.stdout, &output.stderr].map(|own| String::from_utf8_lossy(own));
        if !output.status.success() {
            faults.push(format!("{path}: {script}\n{}\n{out}{err}", output.status));
        }
        let differs = shown.and_then(|shown| difference(shown, &out));
        faults.extend(differs.map(|what| format!("{path}: $ {script}\n{what}")));
    }
    faults
}

#[test]
fn commands_print_what_the_pages_show() {
    let pages = pages_with_commands();
    let found: Vec<String> = std::thread::scope(|scope| {
        let running = pages.iter().map(|path| scope.spawn(move || faults(path)));
        let running: Vec<_> = running.collect();
        let ended = running.into_iter();
        ended
            .flat_map(|own| own.join().expect("a page is read"))
            .collect()
    });
    assert!(found.is_empty(), "{}", found.join("\n\n"));
}

/// The commands that a page shows with their output, without the name of the program.
fn shown(path: &str) -> Vec<String> {
    let shown = steps(&Page::of(path)).into_iter().filter_map(|step| {
        let Step::Shown { command, output } = step else {
            return None;
        };
        let own = ["sextic ", "cargo run --release -- "];
        let own = own.iter().find_map(|prefix| command.strip_prefix(prefix))?;
        (!output.is_empty()).then(|| own.to_owned())
    });
    shown.collect()
}

#[test]
fn every_guide_shows_what_a_command_prints() {
    for path in pages() {
        let is_guide = !WITHOUT_COMMANDS.contains(&&*path);
        assert_eq!(!shown(&path).is_empty(), is_guide, "{path}");
    }
}

#[test]
fn every_command_is_shown() {
    let shown: BTreeSet<String> = pages()
        .iter()
        .flat_map(|path| shown(path))
        .filter_map(|command| command.split(' ').next().map(str::to_owned))
        .collect();
    let expected: BTreeSet<String> = COMMANDS.map(str::to_owned).into();
    assert_eq!(shown, expected);
}

/// A command stands in a fenced block, where it is run.
#[test]
fn no_command_stands_where_it_is_not_run() {
    for path in pages_with_commands() {
        let page = Page::of(&path);
        for block in &page.blocks {
            assert!(
                LANGUAGES.contains(&&*block.language),
                "{path}: a block of {:?} is not run:\n{}",
                block.language,
                block.text
            );
        }
        for line in page.indented.iter().flat_map(|text| text.lines()) {
            let is_own = line.starts_with("sextic ") || line.starts_with("cargo run");
            assert!(!is_own, "{path}: indented, and so not run: {line}");
        }
    }
}

#[test]
fn the_readme_is_a_front_page() {
    let (text, page) = (read("README.md"), Page::of("README.md"));
    assert!(
        text.lines().count() <= 200,
        "README has more than 200 lines"
    );
    assert_eq!(page.pictures.len(), 1, "{:?}", page.pictures);
    assert!(shown("README.md").len() >= 3);
    for path in docs() {
        assert!(page.links.contains(&path), "README does not lead to {path}");
    }
    assert!(
        text.lines().any(|line| line.trim() == TESTS),
        "README lacks {TESTS}"
    );
    assert!(
        read(".ci/run").contains(&format!("step {TESTS}\n")),
        ".ci/run lacks {TESTS}"
    );
}
