//! One file: read as text within a limit, and written whole or not at all.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::stability::input::shortened;

use super::Outcome;
use super::folder::stage;
use super::output::{reason, wrong};
use crate::disk::regular_file;

/// Larger files are no case and no table.
const LARGEST: u64 = 64 << 20;

/// The text of a file, or the outcome after what is wrong with it was written to standard error.
pub fn read_text(path: &Path, what: &str) -> Result<String, Outcome> {
    let bytes = read_bytes(path, what)?;
    String::from_utf8(bytes)
        .map_err(|_| unreadable(path, what, "it is not in UTF-8: save it as such"))
}

/// The text of a file that another program wrote: in UTF-8, in UTF-16 with a byte-order mark, or else in Latin-1; and
/// how it was read where that is not UTF-8.
///
/// # Errors
///
/// The outcome, after what is wrong was written; `what` says what the file is.
pub fn read_foreign_text(
    path: &Path,
    what: &str,
) -> Result<(String, Option<&'static str>), Outcome> {
    let bytes = read_bytes(path, what)?;
    let sixteen = |rest: &[u8], unit: fn([u8; 2]) -> u16| {
        let units = rest.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
        char::decode_utf16(units).collect::<Result<String, _>>()
    };
    // How the files of spreadsheets begin: archives, and what was written before these.
    if bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"\xd0\xcf\x11\xe0") {
        return Err(wrong(
            &format!("`{}` is a spreadsheet and no text", shown(path)),
            "save its sheet as CSV, and name that file",
        ));
    }
    let decoded = match bytes.as_slice() {
        [0xff, 0xfe, rest @ ..] => Some(sixteen(rest, u16::from_le_bytes)),
        [0xfe, 0xff, rest @ ..] => Some(sixteen(rest, u16::from_be_bytes)),
        _ => None,
    };
    match decoded {
        Some(Ok(text)) => Ok((text, Some("UTF-16"))),
        Some(Err(_)) => Err(unreadable(path, what, "it is no text in UTF-16")),
        None => Ok(match String::from_utf8(bytes) {
            Ok(text) => (text, None),
            // Every byte is a character of Latin-1.
            Err(error) => {
                let text = error.as_bytes().iter().copied().map(char::from).collect();
                (text, Some("Latin-1"))
            }
        }),
    }
}

fn read_bytes(path: &Path, what: &str) -> Result<Vec<u8>, Outcome> {
    let read = regular_file::bytes(path, LARGEST + 1);
    let bytes = read.map_err(|error| unreadable(path, what, &reason(&error)))?;
    match bytes.len() as u64 > LARGEST {
        true => Err(unreadable(path, what, "it is larger than 64 MiB")),
        false => Ok(bytes),
    }
}

fn unreadable(path: &Path, what: &str, reason: &str) -> Outcome {
    wrong(
        &format!("`{}` cannot be read: {reason}", shown(path)),
        &format!("name {what}"),
    )
}

/// A path as messages show it.
fn shown(path: &Path) -> String {
    shortened(&path.to_string_lossy())
}

/// Refuses an output that is one of the files that were read, by whatever name or link.
pub fn spare(output: &Path, read: &[&Path]) -> Result<(), Outcome> {
    match read.iter().find(|own| is_one_file(output, own)) {
        None => Ok(()),
        Some(own) => Err(wrong(
            &format!("`{}` is `{}`, which is read", shown(output), shown(own)),
            "name another file: nothing was written",
        )),
    }
}

/// Whether two paths lead to one regular file that is there.
pub fn is_one_file(one: &Path, other: &Path) -> bool {
    let (Ok(known), Ok(beside)) = (fs::metadata(one), fs::metadata(other)) else {
        return false;
    };
    if !known.is_file() {
        return false;
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        (known.dev(), known.ino()) == (beside.dev(), beside.ino())
    }
    #[cfg(not(unix))]
    {
        let _ = beside;
        matches!((fs::canonicalize(one), fs::canonicalize(other)), (Ok(one), Ok(other)) if one == other)
    }
}

/// Writes a file: whole, or not at all. What is no regular file, such as a pipe, is written to.
///
/// # Errors
///
/// If the folder is not there or cannot be written to, or the disk is full.
pub fn write_whole(path: &Path, content: impl AsRef<[u8]>) -> io::Result<()> {
    match fs::metadata(path) {
        Ok(known) if !known.is_file() => return fs::write(path, content),
        _ => {}
    }
    // Behind a link it is the file that is replaced.
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let file = stage(folder, content.as_ref())?;
    file.persist(&path).map_err(|error| error.error)?;
    Ok(())
}

/// Writes what was made; the outcome is that after what is wrong was written to standard error.
pub fn write_made(path: &Path, made: Result<impl AsRef<[u8]>, String>) -> Result<(), Outcome> {
    let written = made.and_then(|own| write_whole(path, own).map_err(|error| reason(&error)));
    written.map_err(|reason| {
        wrong(
            &format!("`{}` cannot be written: {reason}", shown(path)),
            "name a file in a folder that is there and that you may write to",
        )
    })
}

/// A path that does not promise another kind of file.
pub fn promising(kind: &str, path: PathBuf) -> Result<PathBuf, String> {
    match path.extension() {
        Some(other) if !other.eq_ignore_ascii_case(kind) => {
            let message = format!(
                "it is {}: give it a name that ends in .{kind}",
                kind.to_uppercase()
            );
            Err(message)
        }
        _ => Ok(path),
    }
}
