//! Regular files, the only ones that are read.

use std::fs;
use std::io::{self, Read};
use std::path::Path;

/// Opens a file to read it, if it is a regular one: a pipe would be waited for until somebody writes to
/// it, and a device has no end.
fn open(path: &Path) -> io::Result<fs::File> {
    let kind = fs::metadata(path)?.file_type();
    if kind.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    if !kind.is_file() {
        let message = format!("it is {}, and only regular files are read", special(kind));
        return Err(io::Error::other(message));
    }
    fs::File::open(path)
}

/// What a file is that is neither a regular one nor a folder.
#[cfg(unix)]
fn special(kind: fs::FileType) -> &'static str {
    use std::os::unix::fs::FileTypeExt;
    match kind {
        _ if kind.is_fifo() => "a pipe",
        _ if kind.is_socket() => "a socket",
        _ => "a device",
    }
}

#[cfg(not(unix))]
fn special(_: fs::FileType) -> &'static str {
    "a device"
}

/// The bytes of a file, so many at most.
///
/// # Errors
///
/// If there is no such file or it may not be read, or it is something else.
pub fn bytes(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    open(path)?.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}
