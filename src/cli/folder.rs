//! A folder of generated files: all of them are written, or none.

use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use sextic_codegen::language::{File, MARK};
use tempfile::NamedTempFile;

use crate::disk::regular_file;

/// What a line of a comment begins with.
const COMMENT: [char; 8] = ['/', '*', '!', '#', '"', '(', '%', ' '];

/// What the names of files begin with that have not got their own yet.
const STAGED: &str = ".sextic-";

/// Who is not done by then was interrupted.
const LONGEST_RUN: Duration = Duration::from_secs(3600);

/// The mark of a generated file stands within so many bytes.
const HEAD: u64 = 4096;

/// Why nothing was written.
#[derive(Debug)]
pub enum Trouble {
    /// Something in the folder cannot be read or written.
    Disk(PathBuf, io::Error),
    /// These files were not generated.
    Foreign(Vec<PathBuf>),
}

/// What became of a folder.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// How many files were new or different.
    pub changed: usize,
    /// How many were there already, word for word.
    pub unchanged: usize,
    /// Generated files that no evaluator belongs to any more.
    pub stale: Vec<String>,
}

/// How a file stands to what would be generated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum State {
    /// It is the same, word for word.
    Same,
    /// It is there with another text.
    Different(String),
    /// It is not there.
    Missing,
}

/// Writes files below a folder, which is made if need be.
///
/// Every text is on the disk under another name before the first file gets its own: a full disk
/// changes nothing.
///
/// # Errors
///
/// [`Trouble`]: a file that was not generated is overwritten only if `force`.
pub fn write(folder: &Path, files: &[File], force: bool) -> Result<Written, Trouble> {
    let at = |path: &Path| {
        let path = path.to_owned();
        move |error| Trouble::Disk(path, error)
    };
    let mut written = Written::default();
    let (mut changed, mut foreign) = (Vec::new(), Vec::new());
    for file in files {
        let path = folder.join(&file.path);
        match state(&path, &file.text).map_err(at(&path))? {
            State::Same => written.unchanged += 1,
            State::Different(_) if !force && !is_generated(&path).map_err(at(&path))? => {
                foreign.push(path);
            }
            State::Different(_) | State::Missing => changed.push((path, &file.text)),
        }
    }
    if !foreign.is_empty() {
        return Err(Trouble::Foreign(foreign));
    }
    fs::create_dir_all(folder).map_err(at(folder))?;
    forget_interrupted(folder);
    let mut staged = Vec::new();
    for (path, text) in changed {
        staged.push((stage(folder, text.as_bytes()).map_err(at(folder))?, path));
    }
    for (text, path) in staged {
        text.persist(&path)
            .map_err(|error| Trouble::Disk(path, error.error))?;
        written.changed += 1;
    }
    written.stale = others(folder, files).map_err(at(folder))?.stale;
    Ok(written)
}

/// How a file stands to the text that it should have.
///
/// # Errors
///
/// If it cannot be read.
pub fn state(path: &Path, text: &str) -> io::Result<State> {
    match regular_file::bytes(path, u64::MAX) {
        Ok(found) if found == text.as_bytes() => Ok(State::Same),
        Ok(found) => Ok(State::Different(
            String::from_utf8_lossy(&found).into_owned(),
        )),
        Err(error) if error.kind() == ErrorKind::NotFound && !path.is_symlink() => {
            Ok(State::Missing)
        }
        Err(error) => Err(error),
    }
}

/// What else is in a folder of generated files.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Others {
    /// Generated files that are none of these.
    pub stale: Vec<String>,
    /// What was not generated, and is called like one of these but for its ending: a folder
    /// `closed_form` is preferred to `closed_form.py`, and `closed_form.h.gch` to `closed_form.h`.
    pub namesakes: Vec<String>,
}

/// What else is in a folder than these files.
///
/// # Errors
///
/// If the folder cannot be read.
pub fn others(folder: &Path, files: &[File]) -> io::Result<Others> {
    let mut others = Others::default();
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(others),
        entries => entries?,
    };
    let stem = |name: &str| name.split('.').next().map(str::to_string);
    for entry in entries {
        let entry = entry?;
        let Ok(name) = entry.file_name().into_string() else {
            continue;
        };
        if name.starts_with(STAGED) || files.iter().any(|file| file.path == name) {
            continue;
        }
        if entry.file_type()?.is_file() && is_generated(&entry.path())? {
            others.stale.push(name);
        } else if files.iter().any(|file| stem(&file.path) == stem(&name)) {
            others.namesakes.push(name);
        }
    }
    others.stale.sort();
    others.namesakes.sort();
    Ok(others)
}

/// Removes what an interrupted run left; if that cannot be, it stays.
fn forget_interrupted(folder: &Path) {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    for entry in entries {
        let is_staged = entry.file_name().to_string_lossy().starts_with(STAGED);
        let age = entry.metadata().and_then(|known| known.modified());
        let age = age.ok().and_then(|time| time.elapsed().ok());
        if is_staged && age.is_some_and(|age| age > LONGEST_RUN) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// What a file holds, on the disk without a name yet.
///
/// # Errors
///
/// If the folder cannot be written to, or the disk is full.
pub fn stage(folder: &Path, content: &[u8]) -> io::Result<NamedTempFile> {
    let mut file = staged(folder)?;
    file.write_all(content)?;
    file.as_file().sync_all()?;
    Ok(file)
}

/// An empty file in a folder that has not got its own name yet.
pub fn staged(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(STAGED);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As any other file, rather than for the user alone.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}

fn is_generated(path: &Path) -> io::Result<bool> {
    let head = regular_file::bytes(path, HEAD)?;
    // A comment that begins with it, not one that quotes it.
    let text = String::from_utf8_lossy(&head);
    let mut lines = text.lines().map(|line| line.trim_start_matches(COMMENT));
    Ok(lines.any(|line| line.starts_with(MARK)))
}
