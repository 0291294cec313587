//! Area sums to coverage: a running sum along each row.

use super::walk::{SubEdge, TOUCHED, UNIT};

/// Adds sub-edges to the pixels' sums. Integers, so that the order of the edges does not matter.
pub(super) fn add(sub_edges: &[SubEdge], sums: &mut [i32]) {
    for edge in sub_edges {
        let pixel = edge.pixel as usize;
        sums[pixel] = sums[pixel].wrapping_add(edge.area) | TOUCHED;
        sums[pixel + 1] = sums[pixel + 1].wrapping_add(edge.rest);
    }
}

/// Adds the sums of other edges.
pub(super) fn add_sums(others: &[i32], sums: &mut [i32]) {
    for (sum, other) in sums.iter_mut().zip(others) {
        *sum = sum.wrapping_add(other & !TOUCHED) | (other & TOUCHED);
    }
}

/// Turns one row of sums into coverage and clears the sums. `left` is the row's sum left of the picture.
///
/// A pixel no outline runs through is wholly in or out, so the running sum becomes one or the other there: what two
/// edges that should meet are apart by rounding, or an edge that counts twice because two polygons reach equally far,
/// never leaks further than to the next such pixel.
pub(super) fn finish(sums: &mut [i32], left: i32, coverage: &mut [f32]) {
    const GROUP: usize = 8;
    let mut running = left;
    let (groups, last_sums) = sums.as_chunks_mut::<GROUP>();
    let (outputs, last_coverage) = coverage.as_chunks_mut::<GROUP>();
    for (sums, coverage) in groups.iter_mut().zip(outputs) {
        if sums.iter().fold(0, |all, &sum| all | sum) == 0 {
            running = whole(running);
            *coverage = [shade(running); GROUP];
        } else {
            finish_pixels(sums, &mut running, coverage);
        }
    }
    finish_pixels(last_sums, &mut running, last_coverage);
}

#[inline(always)]
fn finish_pixels(sums: &mut [i32], running: &mut i32, coverage: &mut [f32]) {
    for (sum, coverage) in sums.iter_mut().zip(coverage) {
        *running = running.wrapping_add(*sum & !TOUCHED);
        if *sum & TOUCHED == 0 {
            *running = whole(*running);
        }
        *coverage = shade(*running);
        *sum = 0;
    }
}

/// In or out, whichever is nearer.
#[inline(always)]
fn whole(sum: i32) -> i32 {
    if sum >= UNIT / 2 { UNIT } else { 0 }
}

#[inline(always)]
fn shade(sum: i32) -> f32 {
    (sum as f32 * (1.0 / UNIT as f32)).clamp(0.0, 1.0)
}
