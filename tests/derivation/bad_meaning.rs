//! Every mistake in `tests/data/bad/meaning` has a message that a person can act on.

use sextic::language::diagnostic::SourceFile;

use super::{Folder, audit_in, data};

#[test]
fn every_message_is_as_agreed() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/snapshots/bad/meaning"
    ));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        insta::glob!("../data/bad/meaning", "*.md", |path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let text = std::fs::read_to_string(path).expect("the document can be read");
            let outcome = audit_in(
                &SourceFile::new(name.clone(), text),
                &Folder(data("bad/meaning")),
            );
            let messages = match outcome {
                Err(messages) => {
                    for part in [":", "│ ", "Help: "] {
                        assert!(
                            messages.contains(part),
                            "{name} has no `{part}`:\n{messages}"
                        );
                    }
                    messages
                }
                // Some documents are well, but not what they assert.
                Ok(audit) => {
                    assert!(!audit.as_expected(), "{name} has no mistake");
                    let claims = audit.claims.iter().map(|claim| {
                        let reason = claim.reason.clone().unwrap_or_default();
                        format!("{}: {} ({reason})", claim.label.text, claim.verdict.text())
                    });
                    claims.collect::<Vec<_>>().join("\n")
                }
            };
            insta::assert_snapshot!(messages);
        });
    });
}
