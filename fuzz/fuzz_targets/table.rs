//! Any text as a table of coefficients.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sextic::stability::coefficient_table::CoefficientTable;

fuzz_target!(|text: &str| {
    if let Ok(table) = CoefficientTable::read("table.csv", text) {
        let _ = (table.is_circle(), table.is_closed(), table.has_a_jump_at_its_end());
        let _ = sextic::stability::coefficient_table::remarks::remarks(&table);
    }
});
