//! Any text as a case.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sextic::stability::case::Case;

fuzz_target!(|text: &str| {
    if let Ok(case) = Case::read("case.toml", text) {
        let _ = case.remarks();
    }
});
