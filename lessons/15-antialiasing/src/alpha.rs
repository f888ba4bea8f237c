//! Alpha as coverage: what lets through half the light covers half the samples.

// ANCHOR: alpha_to_coverage
/// The samples, of so many up to 32, that a fragment of that alpha covers: alpha's share of them, rounded to nearest, the
/// first ones of the pattern.
///
/// Which ones is up to whoever draws (Vulkan 1.3, *Multisample Coverage*). Here what covers more covers all that less would:
/// two leaves of one alpha, one behind the other, cover the same samples, and the farther is not seen at all. Hardware may
/// choose other samples at other pixels.
#[inline]
#[must_use]
pub fn alpha_to_coverage(alpha: u8, samples: u32) -> u32 {
    let covered = (u32::from(alpha) * samples + 127) / 255;
    ((1_u64 << covered) - 1) as u32
}
// ANCHOR_END: alpha_to_coverage
