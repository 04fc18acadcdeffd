//! One operation over many doubles, with the widest registers of the machine.
// A function for which instructions are enabled may run only where they exist.
#![allow(unsafe_code)]

/// What is done with two numbers.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// a + b
    Sum,
    /// a − b
    Difference,
    /// a·b
    Product,
    /// a/b
    Quotient,
    /// −a
    Negative,
    /// √a
    Root,
}

impl Kind {
    /// The result for two numbers.
    pub fn of(self, a: f64, b: f64) -> f64 {
        match self {
            Kind::Sum => a + b,
            Kind::Difference => a - b,
            Kind::Product => a * b,
            Kind::Quotient => a / b,
            Kind::Negative => -a,
            Kind::Root => a.sqrt(),
        }
    }
}

/// What an operation takes at some points.
#[derive(Clone, Copy)]
pub enum Values<'a> {
    /// The same everywhere.
    One(f64),
    /// One for each point, and perhaps more.
    Many(&'a [f64]),
}

/// An operation at all points that there is room for.
pub type Apply = fn(Kind, &mut [f64], [Values<'_>; 2]);

/// The operation with the widest registers of this machine; all of them round alike.
pub fn widest() -> Apply {
    #[cfg(target_arch = "x86_64")]
    {
        if is_x86_feature_detected!("avx512f") {
            // SAFETY: AVX-512 was found.
            return |kind, room, operands| unsafe { in_avx512(kind, room, operands) };
        }
        if is_x86_feature_detected!("avx2") {
            // SAFETY: AVX2 was found.
            return |kind, room, operands| unsafe { in_avx2(kind, room, operands) };
        }
    }
    apply
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f")]
fn in_avx512(kind: Kind, room: &mut [f64], operands: [Values<'_>; 2]) {
    apply(kind, room, operands);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn in_avx2(kind: Kind, room: &mut [f64], operands: [Values<'_>; 2]) {
    apply(kind, room, operands);
}

#[inline(always)]
fn apply(kind: Kind, room: &mut [f64], [a, b]: [Values<'_>; 2]) {
    match kind {
        Kind::Sum => each(room, a, b, |a, b| a + b),
        Kind::Difference => each(room, a, b, |a, b| a - b),
        Kind::Product => each(room, a, b, |a, b| a * b),
        Kind::Quotient => each(room, a, b, |a, b| a / b),
        Kind::Negative => each(room, a, Values::One(0.0), |a, _| -a),
        Kind::Root => each(room, a, Values::One(0.0), |a, _| a.sqrt()),
    }
}

#[inline(always)]
fn each(room: &mut [f64], a: Values<'_>, b: Values<'_>, operation: impl Fn(f64, f64) -> f64) {
    match (a, b) {
        (Values::Many(a), Values::Many(b)) => {
            let pairs = a.iter().zip(b);
            let places = room.iter_mut().zip(pairs);
            places.for_each(|(own, (a, b))| *own = operation(*a, *b));
        }
        (Values::Many(a), Values::One(b)) => {
            let places = room.iter_mut().zip(a);
            places.for_each(|(own, a)| *own = operation(*a, b));
        }
        (Values::One(a), Values::Many(b)) => {
            let places = room.iter_mut().zip(b);
            places.for_each(|(own, b)| *own = operation(a, *b));
        }
        (Values::One(a), Values::One(b)) => room.fill(operation(a, b)),
    }
}
