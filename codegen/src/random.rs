//! Numbers that look random and are the same everywhere.

/// An arbitrary but fixed number for each place, by SplitMix64.
pub fn mixed(place: u64) -> u64 {
    scrambled(place.wrapping_mul(0x9e37_79b9_7f4a_7c15))
}

/// Bits that depend on all bits of a number, by the mixing function of SplitMix64.
pub(crate) fn scrambled(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}
