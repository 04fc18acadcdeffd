//! A file that is written row by row, and can be gone on with after an interruption.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// The place beside a file where rows on their way to it are left: `sweep.csv.1f0a….part`, with what tells the
/// computation in its name. No other process writes there as long as this value lives.
#[derive(Debug)]
pub struct Reserved {
    file: File,
    path: PathBuf,
    target: PathBuf,
}

impl Reserved {
    /// The place for a file; `identity` tells its computation from others.
    ///
    /// # Errors
    ///
    /// If the folder cannot be written to, or another process is at it.
    pub fn new(target: &Path, identity: &str) -> io::Result<Self> {
        let target = fs::canonicalize(target).unwrap_or_else(|_| target.to_owned());
        let path = beside(&target, identity)?;
        let file = locked(&path)?;
        Ok(Reserved { file, path, target })
    }

    /// What an earlier run left; empty at first.
    #[cfg(feature = "parquet")]
    pub fn file(&self) -> &File {
        &self.file
    }

    /// The folder of the target.
    #[cfg(feature = "parquet")]
    pub fn folder(&self) -> &Path {
        folder(&self.target)
    }

    /// Another file gets the name of the target, and nothing is left.
    #[cfg(feature = "parquet")]
    pub fn finish(self, file: tempfile::NamedTempFile) -> io::Result<()> {
        file.as_file().sync_all()?;
        file.persist(&self.target).map_err(|error| error.error)?;
        fs::remove_file(&self.path)
    }

    /// Another file stands for what is left.
    #[cfg(feature = "parquet")]
    pub fn leave(self, file: tempfile::NamedTempFile) -> io::Result<()> {
        file.as_file().sync_all()?;
        file.persist(&self.path).map_err(|error| error.error)?;
        Ok(())
    }

    /// The rows of other computations beside the target, and whether they are being written: else they are left
    /// of a run that was interrupted.
    pub fn others(&self) -> Vec<(PathBuf, bool)> {
        let name = |path: &Path| {
            path.file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned()
        };
        let target = name(&self.target);
        let is_other = |path: &PathBuf| {
            let is_part =
                name(path).starts_with(&format!("{target}.")) && name(path).ends_with(".part");
            is_part && self.path != *path
        };
        let entries = fs::read_dir(folder(&self.target))
            .into_iter()
            .flatten()
            .flatten();
        let own = |entry: fs::DirEntry| self.target.with_file_name(entry.file_name());
        let mut others: Vec<PathBuf> = entries.map(own).filter(is_other).collect();
        others.sort();
        let found = others.into_iter().map(|path| {
            let is_written = is_locked(&path);
            (path, is_written)
        });
        found.collect()
    }
}

impl Drop for Reserved {
    /// What is empty is not left.
    fn drop(&mut self) {
        let is_empty = self.file.metadata().is_ok_and(|known| known.len() == 0);
        if is_empty && is_at(&self.file, &self.path) {
            // Where it cannot be removed an empty file stays, which is not gone on with.
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// Rows of text on their way to a file: all of them get its name when the last one is there. A pipe or device is
/// written to directly.
#[derive(Debug)]
pub enum Partial {
    /// To a regular file.
    Beside(Reserved),
    /// To something else.
    Directly(File),
}

/// No row has so many bytes.
const LONGEST: u64 = 1 << 16;

/// What an earlier run left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Left {
    /// No rows.
    Nothing,
    /// So many rows, to go on from.
    Rows(u64),
    /// So many rows that are not those of this program.
    Useless(u64),
}

/// Rows that are whole.
#[derive(Debug)]
struct Found {
    /// How many, without the heading.
    rows: u64,
    /// The last one of them.
    last: String,
}

impl Partial {
    /// Rows for a file, and what an earlier run left of them; `identity` tells its computation from others.
    /// The last row that is there must be the one that is to stand there, or all begins anew.
    ///
    /// # Errors
    ///
    /// If the folder cannot be written to, or another process is at it.
    pub fn open(
        target: &Path,
        identity: &str,
        heading: &str,
        row: impl Fn(u64) -> Option<String>,
    ) -> io::Result<(Self, Left)> {
        if fs::metadata(target).is_ok_and(|known| !known.is_file()) {
            let mut partial = Partial::Directly(OpenOptions::new().write(true).open(target)?);
            partial.write(heading)?;
            return Ok((partial, Left::Nothing));
        }
        let mut reserved = Reserved::new(target, identity)?;
        let left = match whole_rows(&mut reserved.file, heading)? {
            Some(found) if row(found.rows - 1).as_ref() == Some(&found.last) => {
                Left::Rows(found.rows)
            }
            Some(found) => Left::Useless(found.rows),
            None => Left::Nothing,
        };
        if !matches!(left, Left::Rows(_)) {
            reserved.file.set_len(0)?;
            reserved.file.rewind()?;
            reserved.file.write_all(heading.as_bytes())?;
        }
        Ok((Partial::Beside(reserved), left))
    }

    /// The place where rows are left, if there is one.
    pub fn reserved(&self) -> Option<&Reserved> {
        match self {
            Partial::Beside(reserved) => Some(reserved),
            Partial::Directly(_) => None,
        }
    }

    /// Adds whole rows.
    pub fn write(&mut self, rows: &str) -> io::Result<()> {
        let file = match self {
            Partial::Beside(reserved) => &mut reserved.file,
            Partial::Directly(file) => file,
        };
        file.write_all(rows.as_bytes())
    }

    /// The rows get the name of the target.
    pub fn finish(self) -> io::Result<()> {
        let Partial::Beside(reserved) = self else {
            return Ok(());
        };
        reserved.file.sync_all()?;
        fs::rename(&reserved.path, &reserved.target)
    }
}

/// The rows that are whole, with what follows them cut off.
fn whole_rows(file: &mut File, heading: &str) -> io::Result<Option<Found>> {
    let mut reader = BufReader::new(&*file);
    let (mut whole, mut rows) = (0, 0);
    let (mut line, mut last) = (Vec::new(), Vec::new());
    // What is longer than any row is no row.
    let mut next = |line: &mut Vec<u8>| (&mut reader).take(LONGEST).read_until(b'\n', line);
    while next(&mut line)? > 0 && line.ends_with(b"\n") {
        if whole == 0 && line != heading.as_bytes() {
            return Ok(None);
        }
        rows += u64::from(whole > 0);
        whole += line.len() as u64;
        std::mem::swap(&mut last, &mut line);
        line.clear();
    }
    file.set_len(whole)?;
    file.seek(SeekFrom::End(0))?;
    let last = String::from_utf8_lossy(&last).into_owned();
    Ok((rows > 0).then_some(Found { rows, last }))
}

/// A file of rows, locked as long as it is open: made if need be.
fn locked(path: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true).write(true).create(true).truncate(false);
    for _ in 0..ATTEMPTS {
        let file = options.open(path)?;
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => {
                return Err(io::Error::other("another process is writing it"));
            }
            // Where files cannot be locked two runs may be in each other's way, which a lock would tell.
            Err(TryLockError::Error(_)) | Ok(()) => {}
        }
        // Who held the lock before may have been through, and the file has got the name of the target.
        if is_at(&file, path) {
            return Ok(file);
        }
    }
    Err(io::Error::other("another process is writing it"))
}

/// So often a file is opened anew that was renamed before it was locked.
const ATTEMPTS: usize = 8;

/// Whether a file that is open is still the one with this path.
fn is_at(file: &File, path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let place = |known: fs::Metadata| (known.dev(), known.ino());
        let pair = (file.metadata().map(place), fs::metadata(path).map(place));
        matches!(pair, (Ok(own), Ok(named)) if own == named)
    }
    #[cfg(not(unix))]
    {
        let _ = file;
        path.exists()
    }
}

/// Whether another process, or this one, holds the lock of a file.
fn is_locked(path: &Path) -> bool {
    let file = OpenOptions::new().read(true).write(true).open(path);
    file.is_ok_and(|file| matches!(file.try_lock(), Err(TryLockError::WouldBlock)))
}

fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// `sweep.csv.1f0a….part` for `sweep.csv`.
fn beside(target: &Path, identity: &str) -> io::Result<PathBuf> {
    let name = target.file_name().ok_or(ErrorKind::IsADirectory)?;
    let mut name = name.to_os_string();
    name.push(format!(".{identity}.part"));
    Ok(target.with_file_name(name))
}
