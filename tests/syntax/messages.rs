//! Every mistake in `tests/data/bad/syntax` has a message that a person can act on.

use sextic::language::diagnostic::{SourceFile, render};
use sextic::language::document::parse_document;

/// What is printed for a document.
fn messages(path: &str, bytes: &[u8]) -> String {
    let source = match SourceFile::from_bytes(path, bytes) {
        Ok(source) => source,
        Err(error) => return render(&error, &SourceFile::from_bytes_lossy(path, bytes), false),
    };
    let errors = parse_document(&source).err().unwrap_or_default();
    let rendered: Vec<_> = errors
        .iter()
        .map(|error| render(error, &source, false))
        .collect();
    rendered.join("\n")
}

#[test]
fn every_message_is_as_agreed() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots/bad/syntax"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        insta::glob!(
            concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data"),
            "bad/syntax/*.md",
            |path| {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                let bytes = std::fs::read(path).expect("the document can be read");
                let messages = messages(&name, &bytes);
                assert!(!messages.is_empty(), "{name} has no mistake");
                insta::assert_snapshot!(messages);
            }
        );
    });
}
