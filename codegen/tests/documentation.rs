//! What emitted text says of itself.

use sextic_codegen::evaluator::Quantity;
use sextic_codegen::language::documentation::{Comments, field};

#[test]
fn fields_are_sentences_and_symbols_stay() {
    let comments = Comments {
        prose: str::to_owned,
        code: str::to_owned,
        heading: str::to_owned,
        constants: "",
        shows_fields: false,
    };
    for (name, symbol, unit, description, expected) in [
        (
            "m",
            "m",
            "kg",
            "mass of the rod",
            "Mass of the rod, in `kg`.",
        ),
        ("rho", "ρ", "kg/m³", "density.", "Density (ρ), in `kg/m³`."),
        ("rho", "ρ", "1", "", "ρ, dimensionless."),
        ("c", "c", "1", "", "Dimensionless."),
        ("c", "c", "", "", "No unit."),
        ("c", "c", "m", "", "In `m`."),
        ("c", "φ", "", "", "φ."),
        ("c", "c", "1", "ω_n of it", "ω_n of it, dimensionless."),
        ("c", "c", "1", "c_0 of it", "c_0 of it, dimensionless."),
        ("c", "c", "1", "x-axis", "x-axis, dimensionless."),
        (
            "c",
            "c",
            "1",
            "cos(α) of it",
            "cos(α) of it, dimensionless.",
        ),
        ("c", "c", "1", "a half", "A half, dimensionless."),
        (
            "c",
            "c",
            "1",
            "He & Macdonald",
            "He & Macdonald, dimensionless.",
        ),
        ("c", "c", "1", "well-known", "Well-known, dimensionless."),
    ] {
        let quantity = Quantity {
            name: name.into(),
            symbol: symbol.into(),
            unit: unit.into(),
            description: description.into(),
        };
        assert_eq!(field(&quantity, name, &comments), [expected]);
    }
}
