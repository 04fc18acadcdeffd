//! One step over many doubles, with the widest registers of the machine.
// A function for which instructions are enabled may run only where they exist.
#![allow(unsafe_code)]

/// What is done with numbers a, b and c.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    /// a·b + c, each operation rounded
    ProductPlus,
    /// a·b − c, each operation rounded
    ProductMinus,
    /// c − a·b, each operation rounded
    MinusProduct,
}

impl Kind {
    /// The result for three numbers, of which most kinds take fewer.
    #[inline(always)]
    pub fn of(self, a: f64, b: f64, c: f64) -> f64 {
        match self {
            Kind::Sum => a + b,
            Kind::Difference => a - b,
            Kind::Product => a * b,
            Kind::Quotient => a / b,
            Kind::Negative => -a,
            Kind::Root => a.sqrt(),
            Kind::ProductPlus => a * b + c,
            Kind::ProductMinus => a * b - c,
            Kind::MinusProduct => c - a * b,
        }
    }

    /// How many numbers it takes.
    pub fn count(self) -> usize {
        match self {
            Kind::Negative | Kind::Root => 1,
            Kind::Sum | Kind::Difference | Kind::Product | Kind::Quotient => 2,
            Kind::ProductPlus | Kind::ProductMinus | Kind::MinusProduct => 3,
        }
    }
}

/// How many points a step takes: what a program remembers of them stays in the cache next to the processor, and a loop
/// whose length is known needs nothing for a rest.
pub const POINTS: usize = 512;

/// Numbers at as many points.
pub type Points = [f64; POINTS];

/// Where a step leaves its numbers: as registers like to have them.
#[derive(Clone)]
#[repr(align(64))]
pub struct Slot(pub Points);

/// What an operation takes.
#[derive(Clone, Copy)]
pub enum Values<'a> {
    /// The same everywhere.
    One(f64),
    /// One for each point.
    Many(&'a Points),
}

/// A step at all points.
pub type Apply = fn(Kind, &mut Points, [Values<'_>; 3]);

/// The step with the widest registers of this machine; all of them round alike.
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
fn in_avx512(kind: Kind, room: &mut Points, operands: [Values<'_>; 3]) {
    apply(kind, room, operands);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn in_avx2(kind: Kind, room: &mut Points, operands: [Values<'_>; 3]) {
    apply(kind, room, operands);
}

/// Each kind has a loop of its own, in which it is known.
#[inline(always)]
fn apply(kind: Kind, room: &mut Points, [a, b, c]: [Values<'_>; 3]) {
    match kind {
        Kind::Sum => two(Kind::Sum, room, a, b),
        Kind::Difference => two(Kind::Difference, room, a, b),
        Kind::Product => two(Kind::Product, room, a, b),
        Kind::Quotient => two(Kind::Quotient, room, a, b),
        Kind::Negative => one(Kind::Negative, room, a),
        Kind::Root => one(Kind::Root, room, a),
        Kind::ProductPlus => three(Kind::ProductPlus, room, a, b, c),
        Kind::ProductMinus => three(Kind::ProductMinus, room, a, b, c),
        Kind::MinusProduct => three(Kind::MinusProduct, room, a, b, c),
    }
}

#[inline(always)]
fn one(kind: Kind, room: &mut Points, a: Values<'_>) {
    match a {
        Values::One(a) => each(kind, room, |_| [a, a, a]),
        Values::Many(a) => each(kind, room, |place| [a[place]; 3]),
    }
}

#[inline(always)]
fn two(kind: Kind, room: &mut Points, a: Values<'_>, b: Values<'_>) {
    three(kind, room, a, b, Values::One(0.0));
}

#[inline(always)]
fn three(kind: Kind, room: &mut Points, a: Values<'_>, b: Values<'_>, c: Values<'_>) {
    match c {
        Values::One(c) => with(kind, room, a, b, |_| c),
        Values::Many(c) => with(kind, room, a, b, |place| c[place]),
    }
}

#[inline(always)]
fn with(kind: Kind, room: &mut Points, a: Values<'_>, b: Values<'_>, c: impl Fn(usize) -> f64) {
    match (a, b) {
        (Values::Many(a), Values::Many(b)) => {
            each(kind, room, |place| [a[place], b[place], c(place)]);
        }
        (Values::Many(a), Values::One(b)) => each(kind, room, |place| [a[place], b, c(place)]),
        (Values::One(a), Values::Many(b)) => each(kind, room, |place| [a, b[place], c(place)]),
        (Values::One(a), Values::One(b)) => each(kind, room, |place| [a, b, c(place)]),
    }
}

#[inline(always)]
fn each(kind: Kind, room: &mut Points, operands: impl Fn(usize) -> [f64; 3]) {
    for (place, value) in room.iter_mut().enumerate() {
        let [a, b, c] = operands(place);
        *value = kind.of(a, b, c);
    }
}
