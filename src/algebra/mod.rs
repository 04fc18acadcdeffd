//! Exact algebra: numbers, polynomials, fractions, rings with relations, matrices, differentials.

#![deny(clippy::float_arithmetic)]

pub mod angle;
pub mod arithmetic;
pub mod budget;
mod coefficient;
mod constituent;
mod degrees;
pub mod determinant;
pub mod differential;
mod division;
mod elimination;
pub mod error;
pub mod expansion;
pub mod factor;
mod field;
pub mod fraction;
mod gcd;
pub mod generator;
mod image;
pub mod interval;
pub mod linear_system;
pub mod matrix;
pub mod modular;
pub mod monomial;
pub mod number;
mod packing;
pub mod polynomial;
pub mod presentation;
mod product;
pub mod ring;
mod root;
mod series;
pub mod sign;
pub mod substitution;
pub mod symbol;
pub mod trigonometric_sum;
mod trigonometry;
pub mod univariate;
