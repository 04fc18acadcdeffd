//! What is certified, for a person.

use std::collections::BTreeMap;

use crate::certificate::document::Certificate;

/// How many claims of each kind are certified, and which are withheld and why.
pub fn ledger(certificates: &[Certificate], is_checked: bool) -> String {
    let mut text = String::new();
    let (mut certified, mut holding) = (0, 0);
    for own in certificates {
        let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
        for entry in &own.entries {
            let holds = entry.subject.holds();
            holding += usize::from(holds);
            if let Ok(kind) = &entry.certificate {
                *kinds.entry(kind.text()).or_default() += 1;
                certified += usize::from(holds);
            }
        }
        text += &format!("{}\n", own.path);
        for (kind, count) in &kinds {
            text += &format!("  {count:>4}  {kind}\n");
        }
        let withheld = own
            .entries
            .iter()
            .filter_map(|entry| Some((entry, entry.certificate.as_ref().err()?)));
        for (entry, reason) in withheld {
            text += &format!(
                "  withheld  {} ({}): {reason}\n",
                entry.label,
                entry.subject.text()
            );
        }
        text.push('\n');
    }
    let controls: usize = certificates.iter().map(|own| own.controls().count()).sum();
    if is_checked {
        text += &format!("{controls} statements that do not hold were tried as well.\n");
    }
    let how = match is_checked {
        true => "checked by Coq",
        false => "written; Coq checks them with --check",
    };
    text + &format!("{certified} of {holding} verdicts `holds` are certified: {how}.\n")
}
