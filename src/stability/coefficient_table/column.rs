//! A column of a table that has a curve.

use super::row::Row;

/// What is read in a row.
#[derive(Clone, Copy, Debug)]
pub(in crate::stability) struct Column {
    /// Its usual name.
    pub name: &'static str,
    number: fn(&Row) -> f64,
}

impl Column {
    pub const DRAG: Column = Column::new("CD", |row| row.drag);
    pub const LIFT: Column = Column::new("CL", |row| row.lift);
    pub const MOMENT: Column = Column::new("CM", |row| row.moment);

    /// C_D, C_L and C_M.
    pub const COEFFICIENTS: [Column; 3] = [Column::DRAG, Column::LIFT, Column::MOMENT];

    /// Their derivatives per radian that a table gives.
    pub const SLOPES: [Column; 3] = [
        Column::new("dCD", |row| row.slopes[0].unwrap_or_default()),
        Column::new("dCL", |row| row.slopes[1].unwrap_or_default()),
        Column::new("dCM", |row| row.slopes[2].unwrap_or_default()),
    ];

    const fn new(name: &'static str, number: fn(&Row) -> f64) -> Self {
        Column { name, number }
    }

    /// The number of a row.
    pub fn of(&self, row: &Row) -> f64 {
        (self.number)(row)
    }
}
