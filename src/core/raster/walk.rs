//! Visible outline to pixels: each edge is cut where it crosses a pixel border, and each cut piece, a sub-edge, says
//! which area it closes off (forward) and how much outline lies in its pixel (backward).

use super::extremes::{least, most};
use wide::f32x4;

/// One unit of coverage in the integer sums: 2^20 steps, shifted by one bit to leave room for [`TOUCHED`].
pub(super) const UNIT: i32 = 1 << 21;
/// Bit 0 of a pixel's sum: some outline runs through it. All addends are even.
pub(super) const TOUCHED: i32 = 1;

/// The part of an edge inside one pixel.
#[derive(Debug, Clone, Copy)]
pub(super) struct SubEdge {
    pub pixel: u32,
    /// Signed area to its right within the pixel, in steps.
    pub area: i32,
    /// What is left of its height, for all pixels further right.
    pub rest: i32,
    pub length_px: f32,
    /// Its middle as a parameter of the piece: 0 and 1 at the two tangent points.
    pub u: f32,
}

/// A straight, visible stretch of outline inside the picture.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    pub start: [f32; 2],
    pub step: [f32; 2],
    /// Parameter along the piece at the start, and its change.
    pub u: [f32; 2],
}

/// The parameter interval of the segment that lies inside `[0, width] x [0, height]`, if any.
#[inline(always)]
pub(super) fn clip(start: [f32; 2], step: [f32; 2], width: f32, height: f32) -> Option<[f32; 2]> {
    let (mut from, mut to) = (0.0f32, 1.0f32);
    for (p, d, limit) in [(start[0], step[0], width), (start[1], step[1], height)] {
        let (low, high) = (least(p, p + d), most(p, p + d));
        if low >= 0.0 && high <= limit {
            continue;
        }
        // Also true for NaN.
        if !(high >= 0.0 && low <= limit) || d == 0.0 {
            return None;
        }
        let (t, u) = (-p / d, (limit - p) / d);
        from = most(from, least(t, u));
        to = least(to, most(t, u));
    }
    (from < to).then_some([from, to])
}

/// Walks a stretch through the pixels and appends its sub-edges.
#[inline]
pub(super) fn walk(width: usize, height: usize, stretch: &Stretch, sub_edges: &mut Vec<SubEdge>) {
    let ([x0, y0], [dx, dy], [u, du]) = (stretch.start, stretch.step, stretch.u);
    let length = (dx * dx + dy * dy).sqrt();
    let (columns, rows) = (width as i32, height as i32);
    // Four at once: one by one, casts must mind what no i32 holds.
    let [first_column, first_row, last_column, last_row] =
        f32x4::new([x0, y0, x0 + dx, y0 + dy]).fast_trunc_int().to_array();
    let mut column = first_column.min(columns - 1);
    let mut row = first_row.min(rows - 1);
    let cut = |column: i32, row: i32, from: f32, to: f32| {
        let share = most(to - from, 0.0);
        let middle = 0.5 * (from + to);
        let into_pixel = (x0 + dx * middle - column as f32).clamp(0.0, 1.0);
        let steps = dy * share * (UNIT / 2) as f32;
        let [whole, rest, ..] = f32x4::new([steps, steps * into_pixel, 0.0, 0.0]).fast_trunc_int().to_array();
        SubEdge {
            pixel: (row * columns + column) as u32,
            area: (whole - rest) * 2,
            rest: if column + 1 < columns { rest * 2 } else { 0 },
            length_px: length * share,
            u: u + du * middle,
        }
    };
    if column == last_column && row == last_row {
        sub_edges.push(cut(column, row, 0.0, 1.0));
        return;
    }
    // Parameter of the next vertical and horizontal pixel border.
    let (mut next_x, pace_x, step_x) = pace(x0, dx, column);
    let (mut next_y, pace_y, step_y) = pace(y0, dy, row);
    let mut t = 0.0f32;
    loop {
        let until = least(least(next_x, next_y), 1.0);
        sub_edges.push(cut(column, row, t, until));
        if until >= 1.0 {
            break;
        }
        t = until;
        if next_x < next_y {
            column += step_x;
            next_x += pace_x;
        } else {
            row += step_y;
            next_y += pace_y;
        }
        if column as u32 >= columns as u32 || row as u32 >= rows as u32 {
            break;
        }
    }
}

#[inline(always)]
fn pace(start: f32, step: f32, cell: i32) -> (f32, f32, i32) {
    let pace = 1.0 / step;
    if step > 0.0 {
        ((cell as f32 + 1.0 - start) * pace, pace, 1)
    } else if step < 0.0 {
        ((cell as f32 - start) * pace, -pace, -1)
    } else {
        (f32::INFINITY, f32::INFINITY, 0)
    }
}
