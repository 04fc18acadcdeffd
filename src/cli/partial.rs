//! A file that is written row by row, and can be gone on with after an interruption.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::folder::staged;

/// Rows on their way to a file.
///
/// They stand in a file beside it, whose name holds what tells the computation: `sweep.csv.1f0a….part`.
/// When all are there it gets the name of the other one. A pipe or device is written to directly.
#[derive(Debug)]
pub struct Partial {
    file: File,
    /// The file beside the target; `None` for what is no regular file.
    path: Option<PathBuf>,
    target: PathBuf,
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
        let target = fs::canonicalize(target).unwrap_or_else(|_| target.to_owned());
        if fs::metadata(&target).is_ok_and(|known| !known.is_file()) {
            let file = OpenOptions::new().write(true).open(&target)?;
            let mut partial = Partial {
                file,
                path: None,
                target,
            };
            partial.write(heading)?;
            return Ok((partial, Left::Nothing));
        }
        let path = beside(&target, identity)?;
        let file = locked(&path)?;
        let mut partial = Partial {
            file,
            path: Some(path),
            target,
        };
        let left = match partial.whole_rows(heading)? {
            Some(found) if row(found.rows - 1).as_ref() == Some(&found.last) => {
                Left::Rows(found.rows)
            }
            Some(found) => Left::Useless(found.rows),
            None => Left::Nothing,
        };
        if !matches!(left, Left::Rows(_)) {
            partial.file.set_len(0)?;
            partial.file.rewind()?;
            partial.write(heading)?;
        }
        Ok((partial, left))
    }

    /// The rows that are whole, with what follows them cut off.
    fn whole_rows(&mut self, heading: &str) -> io::Result<Option<Found>> {
        let mut reader = BufReader::new(&self.file);
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
        self.file.set_len(whole)?;
        self.file.seek(SeekFrom::End(0))?;
        let last = String::from_utf8_lossy(&last).into_owned();
        Ok((rows > 0).then_some(Found { rows, last }))
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
            is_part && self.path.as_ref() != Some(path)
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

    /// Adds whole rows.
    pub fn write(&mut self, rows: &str) -> io::Result<()> {
        self.file.write_all(rows.as_bytes())
    }

    /// The rows get the name of the target, as they are or as `convert` writes them to another file.
    pub fn finish(self, convert: Option<Conversion>) -> io::Result<()> {
        let Some(path) = self.path else {
            return Ok(());
        };
        self.file.sync_all()?;
        let Some(convert) = convert else {
            return fs::rename(&path, &self.target);
        };
        let folder = folder(&self.target);
        let staged = staged(folder)?;
        convert(&path, staged.as_file())?;
        staged.as_file().sync_all()?;
        staged.persist(&self.target).map_err(|error| error.error)?;
        fs::remove_file(&path)
    }
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

/// Writes the rows of a file in another format.
pub type Conversion = fn(&Path, &File) -> io::Result<()>;

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
