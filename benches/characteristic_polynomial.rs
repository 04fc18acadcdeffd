//! The coefficients of |λ²M + λC + K| by the power of λ, expanded.
#![allow(missing_docs, clippy::unwrap_used)]

mod pencil;

use divan::{Bencher, black_box};
use pencil::{Circle, Pencil};

fn main() {
    println!(
        "terms with the section's 25 parameters: {}",
        Pencil::section(Circle::Free).terms()
    );
    println!(
        "the same with sin² + cos² = 1: {}",
        Pencil::section(Circle::Folded).terms()
    );
    let terms: Vec<usize> = SIZES.map(|size| Pencil::symbolic(size).terms()).to_vec();
    println!("terms with a symbol in every entry, 2 to 6 degrees of freedom: {terms:?}");
    divan::main();
}

const SIZES: [usize; 5] = [2, 3, 4, 5, 6];

/// The seven coefficients of the paper's section with all 25 parameters symbolic.
#[divan::bench]
fn section(bencher: Bencher) {
    let pencil = Pencil::section(Circle::Free);
    bencher.bench_local(|| black_box(&pencil).coefficients());
}

/// The same as documents compute it: every product folded by sin² + cos² = 1.
#[divan::bench]
fn section_folded(bencher: Bencher) {
    let pencil = Pencil::section(Circle::Folded);
    bencher.bench_local(|| black_box(&pencil).coefficients());
}

/// A symbol in every entry of M, C and K.
#[divan::bench(args = SIZES)]
fn symbolic(bencher: Bencher, size: usize) {
    let pencil = Pencil::symbolic(size);
    bencher.bench_local(|| black_box(&pencil).coefficients());
}
