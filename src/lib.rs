//! Derives, audits and compiles closed-form stability criteria, exactly.
//!
//! A derivation is a Markdown document. Its equations are judged by exact algebra, and what it derives becomes
//! programs: text in Rust, C, Python or Octave that is proven, and numbers.
//!
//! ```
//! use sextic::compile::generation::{Order, generate};
//! use sextic::documents::ShippedLibrary;
//! use sextic::language::diagnostic::SourceFile;
//! use sextic::verdict::audit::audit;
//! use sextic_codegen::language::Language;
//!
//! let text = "# A spring\n\n```sextic\n\
//!     parameter m : kg > 0\n\
//!     parameter k : N/m > 0\n\
//!     ω := sqrt(k/m)\n\
//!     claim (1): m*ω^2 == k\n\
//!     evaluator (1) frequency: omega = ω\n\
//!     domain m = [1, 2], k = [1, 2]\n```\n";
//! let document = SourceFile::new("spring.md", text);
//!
//! let audit = audit(&document, &ShippedLibrary)?;
//! assert_eq!(audit.claims[0].verdict.text(), "holds");
//!
//! let order = Order { points: 100, ..Order::of_all(Language::Rust) };
//! let generated = generate(&[audit], &order, &mut |_| {})?;
//! assert!(generated.files.iter().any(|file| file.path == "frequency.rs"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | module | what it does |
//! |---|---|
//! | [`algebra`] | exact numbers, polynomials, fractions, matrices, the ring with its relations |
//! | [`language`] | what a document says: Markdown, grammar, names, units, mistakes with their places |
//! | [`derivation`] | the first route: expressions become elements of the ring |
//! | [`points`] | the second route: the same expressions at assignments |
//! | [`verdict`] | where the routes meet: verdicts and audits |
//! | [`certificate`] | claims as theorems that Coq checks |
//! | [`compile`] | what is derived becomes programs, and their text is proven |
//! | `stability` | systems and sections in numbers: modes with bounds, verdicts, critical values |
//! | [`report`] | what was found, for people and programs |
//! | `cli` | the command |
//! | [`documents`] | the documents that come with it |
//! | [`disk`] | those on the disk |
#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod algebra;
pub mod certificate;
#[cfg(feature = "command")]
pub mod cli;
pub mod compile;
pub mod derivation;
pub mod disk;
pub mod documents;
pub mod language;
pub mod points;
pub mod report;
#[cfg(feature = "stability")]
pub mod stability;
pub mod verdict;
