//! ARCHITECTURE.md: the map names every file, the invariants name tests that exist.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::page::{Page, root};
use super::sources::rust_files;

#[test]
fn every_invariant_names_its_tests() {
    let sources = ["src", "tests"].map(|folder| rust_files(&root().join(folder)));
    let text: String = sources
        .iter()
        .flatten()
        .map(|path| std::fs::read_to_string(path).expect("a source can be read"))
        .collect();
    let page = Page::of("ARCHITECTURE.md");
    let invariants = page.table(&["", "what is always so", "held by"]);
    for (number, row) in (1..).zip(invariants) {
        assert_eq!(row[0].text, number.to_string());
        assert!(
            !row[2].code.is_empty(),
            "invariant {number} is held by no test"
        );
        for test in &row[2].code {
            let function = format!("fn {test}(");
            let lines: Vec<&str> = text.lines().map(str::trim).collect();
            let is_test = |pair: &[&str]| pair[0] == "#[test]" && pair[1].starts_with(&function);
            assert!(
                lines.windows(2).any(is_test),
                "invariant {number}: there is no test `{test}`"
            );
        }
    }
}

#[test]
fn the_map_names_every_file() {
    let page = Page::of("ARCHITECTURE.md");
    let (mut folder, mut named) = (root(), BTreeSet::new());
    for row in page.table(&["file", "what it holds"]) {
        for name in &row[0].code {
            let path = match name.strip_suffix('/') {
                // Bold rows are folders of the project, other ones are parts of such.
                Some(path) if root().join(path).is_dir() => {
                    folder = root().join(path);
                    folder.clone()
                }
                _ if root().join(name).is_file() => root().join(name),
                _ => folder.join(name.trim_end_matches('/')),
            };
            assert!(
                path.exists(),
                "the map names {name}, which is not in {}",
                folder.display()
            );
            named.insert(path);
        }
        // Parts that are named beside what they hold stand in the folder of one of these.
        let folders: Vec<PathBuf> = row[0]
            .code
            .iter()
            .map(|name| folder.join(name.trim_end_matches('/')).with_extension(""))
            .collect();
        for part in row[1].code.iter().filter(|code| code.ends_with(".rs")) {
            let parts = folders.iter().filter(|folder| folder.is_dir());
            let is_there = parts
                .flat_map(|folder| rust_files(folder))
                .any(|path| path.ends_with(part));
            assert!(
                is_there,
                "the map names {part}, which is not in {folders:?}"
            );
        }
    }
    // Parts of a file stand in a folder of its name; a list of modules has nothing to say.
    let is_known = |path: &Path| {
        let mut parents = path.ancestors();
        path.ends_with("mod.rs")
            || parents.any(|parent| {
                let is_folder = parent.is_dir() && parent.parent() != Some(&root().join("src"));
                named.contains(&parent.with_extension("rs")) || is_folder && named.contains(parent)
            })
    };
    let unknown: Vec<PathBuf> = rust_files(&root().join("src"))
        .into_iter()
        .filter(|path| !is_known(path))
        .collect();
    assert!(unknown.is_empty(), "the map does not name {unknown:?}");
}
