//! What reads the files of a language.

use sextic_codegen::language::File;

use super::body::{Door, Reading, Unreadable};
use super::names::Names;

/// A reader of a language: one constant in the file of each.
pub(super) struct Reader {
    /// The ending of the file with the function.
    pub ending: &'static str,
    /// The bodies, and the function that takes angles.
    pub read: fn(&Texts, &mut Names) -> Result<Found, Placed<Unreadable>>,
}

/// Bodies, and a function that takes angles.
pub(super) type Found = (Vec<Placed<Reading>>, Placed<Door>);

/// Something, behind its place in words.
pub(super) type Placed<T> = (String, T);

/// The files of an evaluator, whose function has this name.
pub(super) struct Texts<'a> {
    pub files: &'a [File],
    pub function: &'a str,
}

impl<'a> Texts<'a> {
    /// What a reader makes of the file with this ending.
    pub fn read<T>(
        &self,
        ending: &str,
        read: impl FnOnce(&'a str) -> Result<T, Unreadable>,
    ) -> Result<T, Placed<Unreadable>> {
        let path = self.path(ending);
        let text = match self.files.iter().find(|file| file.path == path) {
            Some(file) => Ok(file.text.as_str()),
            None => Err(Unreadable {
                line: 1,
                reason: "the file is missing".to_string(),
            }),
        };
        text.and_then(read).map_err(|unreadable| (path, unreadable))
    }

    fn path(&self, ending: &str) -> String {
        format!("{}.{ending}", self.function)
    }

    /// The place of a function of a file, whose name ends so.
    pub fn place(&self, ending: &str, suffix: &str) -> String {
        format!("{}, `{}{suffix}`", self.path(ending), self.function)
    }
}
