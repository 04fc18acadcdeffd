//! Where numbers lie in memory.

use std::ops::{Deref, DerefMut};

/// Numbers that begin with a cache line. Columns of 4096 numbers would all begin at the same place of a
/// page if they were allocated as they come, and a cache keeps few lines of the same place.
pub struct Column {
    storage: Vec<f64>,
    start: usize,
    points: usize,
}

/// Numbers of a cache line.
const LINE: usize = 8;

impl Column {
    /// Zeros; the columns of different places begin at different places of a page.
    pub fn zeros(points: usize, place: usize) -> Self {
        let shift = place % 32 * 2 * LINE;
        let storage = vec![0.0; points + shift + LINE];
        let start = storage.as_ptr().align_offset(LINE * size_of::<f64>()) + shift;
        Column {
            storage,
            start,
            points,
        }
    }
}

impl Deref for Column {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        &self.storage[self.start..self.start + self.points]
    }
}

impl DerefMut for Column {
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.storage[self.start..self.start + self.points]
    }
}
