//! Which documents something was derived in.

use sha2::{Digest, Sha256};

use crate::language::diagnostic::SourceFile;

/// The SHA-256 of documents one behind the other, in hexadecimal digits; of a single one it is that of
/// the file.
pub fn fingerprint(sources: &[SourceFile]) -> String {
    let mut hash = Sha256::new();
    for source in sources {
        hash.update(source.text.as_bytes());
    }
    let bytes = hash.finalize();
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_that_of_the_standard() {
        let abc = SourceFile::new("a.md", "abc");
        assert_eq!(
            fingerprint(&[abc]),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
        );
    }
}
