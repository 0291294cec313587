//! The less and the greater of two numbers, by a comparison: `f32::min` and `f32::max` look for NaN as well, which is a
//! few instructions more, and in wasm a call. Of NaN and a number these give the second.

#[inline(always)]
pub(super) fn least(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

#[inline(always)]
pub(super) fn most(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
