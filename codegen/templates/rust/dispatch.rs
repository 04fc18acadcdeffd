//! Which instructions a batch uses.
//!
//! With the feature `std` the choice is made when the program runs, without it when it is built.
// The only unsafe code: a function for which instructions are enabled may run only where they exist.
#![allow(unsafe_code)]

use core::fmt;

/// How a batch rounds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Every operation is rounded: the same bits on every machine, in every lane, and as the scalar
    /// function gives.
    #[default]
    Strict,
    /// Products and sums are rounded once together where the machine can (and the feature `std` is on):
    /// faster and more accurate, but the bits depend on the machine.
    Fused,
}

/// The slices of a batch do not have the same length; nothing was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthMismatch {
    /// Which slice differs from the first one.
    pub name: &'static str,
    /// The length of the first slice.
    pub expected: usize,
    /// The length of this slice.
    pub found: usize,
}

impl LengthMismatch {
    /// Compares the length of a slice with that of the first one.
    ///
    /// # Errors
    ///
    /// If they differ.
    pub const fn check(name: &'static str, expected: usize, found: usize) -> Result<(), Self> {
        if expected == found {
            return Ok(());
        }
        Err(LengthMismatch {
            name,
            expected,
            found,
        })
    }
}

impl fmt::Display for LengthMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the slice {} has {} values where {} are needed",
            self.name, self.found, self.expected
        )
    }
}

impl core::error::Error for LengthMismatch {}

/// A loop over points in lanes.
pub trait Kernel {
    /// Runs it; `#[inline(always)]` in every kernel, so that it becomes part of the function for which
    /// instructions are enabled.
    fn run<const N: usize, const FUSED: bool>(self);
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Instructions {
    Baseline,
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    Avx2,
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    Avx512,
}

/// Instructions that this machine has: there is no level that it lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Level(Instructions);

impl Level {
    /// What every machine has for which the program was built.
    pub const BASELINE: Level = Level(Instructions::Baseline);

    /// AVX2 with fused multiply-add, if this machine has them.
    pub fn avx2() -> Option<Level> {
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        if std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma") {
            return Some(Level(Instructions::Avx2));
        }
        None
    }

    /// AVX-512 (F, DQ and VL), if this machine has it.
    pub fn avx512() -> Option<Level> {
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        if Level::avx2().is_some()
            && std::is_x86_feature_detected!("avx512f")
            && std::is_x86_feature_detected!("avx512dq")
            && std::is_x86_feature_detected!("avx512vl")
        {
            return Some(Level(Instructions::Avx512));
        }
        None
    }

    /// All levels of this machine, the fastest last.
    pub fn available() -> impl Iterator<Item = Level> {
        let levels = [Some(Level::BASELINE), Level::avx2(), Level::avx512()];
        levels.into_iter().flatten()
    }

    /// The fastest level of this machine.
    pub fn best() -> Level {
        Level::avx512()
            .or_else(Level::avx2)
            .unwrap_or(Level::BASELINE)
    }

    /// What it is called.
    pub const fn name(self) -> &'static str {
        match self.0 {
            Instructions::Baseline => "baseline",
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            Instructions::Avx2 => "avx2",
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            Instructions::Avx512 => "avx512",
        }
    }

    /// Runs a kernel with these instructions.
    pub fn run<K: Kernel>(self, mode: Mode, kernel: K) {
        match self.0 {
            Instructions::Baseline => baseline(mode, kernel),
            // SAFETY: this level exists only where `Level::avx2` has found AVX2 and FMA.
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            Instructions::Avx2 => unsafe { avx2(mode, kernel) },
            // SAFETY: this level exists only where `Level::avx512` has found these instructions.
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            Instructions::Avx512 => unsafe { avx512(mode, kernel) },
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// With the instructions that the whole program is built for.
fn baseline<K: Kernel>(mode: Mode, kernel: K) {
    // Without an instruction for it, a fused multiply-add is a call of a slow routine.
    const FUSES: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));
    match mode {
        Mode::Fused if FUSES => kernel.run::<LANES, true>(),
        Mode::Fused | Mode::Strict => kernel.run::<LANES, false>(),
    }
}

/// As many doubles as the registers of the build hold, two at least.
const LANES: usize = if cfg!(target_feature = "avx512f") {
    8
} else if cfg!(target_feature = "avx") {
    4
} else {
    2
};

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx2,fma")]
unsafe fn avx2<K: Kernel>(mode: Mode, kernel: K) {
    match mode {
        Mode::Strict => kernel.run::<4, false>(),
        Mode::Fused => kernel.run::<4, true>(),
    }
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx2,fma,avx512f,avx512dq,avx512vl")]
unsafe fn avx512<K: Kernel>(mode: Mode, kernel: K) {
    match mode {
        Mode::Strict => kernel.run::<8, false>(),
        Mode::Fused => kernel.run::<8, true>(),
    }
}
