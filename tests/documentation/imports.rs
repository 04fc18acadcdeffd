//! Imports run one way: between the rooms of the house, and between files.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use syn::{Item, UseTree};

use super::page::root;
use super::sources::rust_files;

/// The path of a file in the crate: `stability`, `case`, `keys`.
type Module = Vec<String>;

/// The rooms, each above those that it may import; `derivation` and `points` do not know each other, and neither do
/// `compile`, `certificate` and `stability`, but for how a system is named.
const ROOMS: [(&str, &[&str]); 10] = [
    ("algebra", &[]),
    ("language", &["algebra"]),
    ("derivation", &["algebra", "language"]),
    ("points", &["algebra", "language"]),
    ("verdict", &["algebra", "language", "derivation", "points"]),
    ("compile", &["algebra", "language", "derivation", "verdict"]),
    (
        "certificate",
        &["algebra", "language", "derivation", "verdict", "compile"],
    ),
    ("stability", &["algebra"]),
    (
        "report",
        &[
            "algebra",
            "language",
            "derivation",
            "verdict",
            "compile",
            "certificate",
            "stability",
        ],
    ),
    (
        "cli",
        &[
            "algebra",
            "language",
            "derivation",
            "verdict",
            "compile",
            "certificate",
            "stability",
            "report",
            "disk",
            "documents",
        ],
    ),
];

/// The files and what each imports.
fn imports() -> BTreeMap<Module, BTreeSet<Module>> {
    let source = root().join("src");
    let files: BTreeMap<Module, String> = rust_files(&source)
        .iter()
        .map(|path| {
            let text = std::fs::read_to_string(path).expect("a source can be read");
            (module(path.strip_prefix(&source).expect("a source")), text)
        })
        .collect();
    let imports = |(own, text): (&Module, &String)| {
        let imported = imported(own, text);
        let found = imported.iter().filter_map(|path| file(path, &files));
        (own.clone(), found.filter(|file| file != own).collect())
    };
    files.iter().map(imports).collect()
}

fn module(path: &Path) -> Module {
    let path = path.with_extension("");
    let mut parts: Module = path
        .iter()
        .map(|own| own.to_string_lossy().into())
        .collect();
    parts.retain(|own| own != "mod" && own != "lib");
    parts
}

/// The longest beginning of a path that is a file.
fn file(path: &Module, files: &BTreeMap<Module, String>) -> Option<Module> {
    let lengths = (0..=path.len()).rev();
    let mut beginnings = lengths.map(|length| path[..length].to_vec());
    beginnings.find(|beginning| files.contains_key(beginning))
}

/// The paths in the crate that a file uses outside of its tests.
fn imported(own: &Module, text: &str) -> BTreeSet<Module> {
    let parsed = syn::parse_file(text).expect("Rust");
    let mut paths = BTreeSet::new();
    for item in parsed.items {
        if let Item::Use(item) = item {
            collect(&item.tree, Vec::new(), &mut paths);
        }
    }
    paths
        .iter()
        .filter_map(|path| resolved(own, path))
        .collect()
}

fn collect(tree: &UseTree, mut path: Module, paths: &mut BTreeSet<Module>) {
    match tree {
        UseTree::Path(own) => {
            path.push(own.ident.to_string());
            collect(&own.tree, path, paths);
        }
        UseTree::Name(own) => {
            path.push(own.ident.to_string());
            paths.insert(path);
        }
        UseTree::Rename(own) => {
            path.push(own.ident.to_string());
            paths.insert(path);
        }
        UseTree::Glob(_) => {
            paths.insert(path);
        }
        UseTree::Group(own) => {
            for tree in &own.items {
                collect(tree, path.clone(), paths);
            }
        }
    }
}

/// A path from the root of the crate; nothing for one of another crate.
fn resolved(own: &Module, path: &[String]) -> Option<Module> {
    let (mut base, mut rest) = match path.first()?.as_str() {
        "crate" => (Module::new(), &path[1..]),
        "self" | "super" => (own.clone(), path),
        _ => return None,
    };
    while let Some(("super" | "self", others)) = rest
        .split_first()
        .map(|(first, others)| (first.as_str(), others))
    {
        if rest[0] == "super" {
            base.pop();
        }
        rest = others;
    }
    base.extend(rest.iter().cloned());
    Some(base)
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    let mut left = imports();
    assert!(left.len() > 200, "{} files", left.len());
    // What is in no circle is taken away: it imports nothing that is left, or nothing that is left imports it.
    loop {
        let used: BTreeSet<Module> = left.values().flatten().cloned().collect();
        let ends = |own: &Module, imported: &BTreeSet<Module>| {
            !used.contains(own) || !imported.iter().any(|other| left.contains_key(other))
        };
        let gone = left.iter().filter(|(own, imported)| ends(own, imported));
        let gone: Vec<Module> = gone.map(|(own, _)| own.clone()).collect();
        if gone.is_empty() {
            break;
        }
        gone.iter().for_each(|own| drop(left.remove(own)));
    }
    let names: Vec<String> = left.keys().map(|own| own.join("/")).collect();
    assert!(names.is_empty(), "these files import each other: {names:?}");
}

#[test]
fn rooms_import_downwards() {
    let imports = imports();
    for (room, below) in ROOMS {
        let inside = |own: &Module| own.first().is_some_and(|first| first == room);
        assert!(imports.keys().any(inside), "no files in {room}");
        for (own, imported) in imports.iter().filter(|(own, _)| inside(own)) {
            for other in imported.iter().filter_map(|path| path.first()) {
                assert!(
                    other == room || below.contains(&other.as_str()),
                    "{} imports {other}",
                    own.join("/")
                );
            }
        }
    }
}
