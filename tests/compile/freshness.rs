//! What is checked in is what the documents give now.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use sextic::compile::generation::{Order, generate};
use sextic::report::text::difference;
use sextic_codegen::language::Language;

use super::audits;

/// What makes them anew.
const MEND: &str = "cargo run --release --no-default-features -- generate --out codegen/evaluators/src --language rust";

fn checked_in() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("codegen/evaluators/src")
}

#[test]
fn what_emitted_files_run_on_exists_once() {
    let support = checked_in().join("../../support");
    for entry in fs::read_dir(&support).expect("the folder of the support") {
        let name = entry.expect("an entry").file_name();
        let path = checked_in().join(&name);
        let is_rust = name.to_string_lossy().ends_with(".rs");
        let mend = format!("ln -sf ../../support/{0} {0}", name.to_string_lossy());
        assert!(
            !is_rust || path.is_symlink(),
            "{} is no link to codegen/support; mend it there with\n  {mend}\n",
            path.display()
        );
    }
}

#[test]
fn the_evaluators_that_are_checked_in_are_fresh() {
    let order = Order::of_all(Language::Rust);
    let generated = generate(&audits(), &order, &mut |_| ()).expect("they are generated");
    let wanted = generated
        .files
        .into_iter()
        .map(|file| (file.path, file.text));
    let wanted: BTreeMap<String, String> = wanted.collect();

    let folder = checked_in();
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(&folder).expect("the folder of the evaluators") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().and_then(|name| name.to_str());
        let name = name.expect("a name in UTF-8").to_owned();
        found.insert(name, fs::read_to_string(path).expect("a text"));
    }

    let mut complaints = String::new();
    for (path, text) in &wanted {
        match found.get(path) {
            None => complaints.push_str(&format!("{path} is missing\n")),
            Some(old) if old != text => complaints.push_str(&difference(path, old, text)),
            Some(_) => {}
        }
    }
    for path in found.keys().filter(|path| !wanted.contains_key(*path)) {
        complaints.push_str(&format!("{path} is generated no more\n"));
    }
    assert!(
        complaints.is_empty(),
        "\n{complaints}mend it with\n  {MEND}\n"
    );
}
