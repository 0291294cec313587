//! Black bars beside a picture, as frames of films have: no part of what was photographed.

use crate::picture::photo::Photo;

/// Darker than this, with no more hue than that, is black also after lossy compression; units of [`Photo::lab`].
const BLACK: f32 = 12.0;
const HUE: f32 = 8.0;
/// Share of a bar's lines that is black, and of the line next to it that is not: a bar ends all at once, while an object
/// before black ground begins with a few pixels.
const MOST: f64 = 0.98;
const ENDS: f64 = 0.5;
/// Narrowest bar, share of the side, px at least.
const LEAST: f64 = 0.02;
const LEAST_PX: usize = 3;

/// The picture without bars: first column and row, and one past the last. Bars come in pairs, on opposite sides.
pub fn without_bars(photo: &Photo) -> [usize; 4] {
    let (width, height) = (photo.width, photo.height);
    let is_black = |x: usize, y: usize| {
        let [l, a, b] = photo.lab[y * width + x];
        l < BLACK && a.abs() < HUE && b.abs() < HUE
    };
    let [mut frame_x, mut frame_y] = [[0, width], [0, height]];
    let of_column = |x: usize| (0..height).filter(|&y| is_black(x, y)).count() as f64 / height as f64;
    if let Some(between) = between_bars(width, of_column) {
        frame_x = between;
    }
    let wide = (frame_x[1] - frame_x[0]) as f64;
    let of_row = |y: usize| (frame_x[0]..frame_x[1]).filter(|&x| is_black(x, y)).count() as f64 / wide;
    if let Some(between) = between_bars(height, of_row) {
        frame_y = between;
    }
    [frame_x[0], frame_y[0], frame_x[1], frame_y[1]]
}

/// What is left of `side` lines between two bars, by how much of each line is black.
fn between_bars(side: usize, black: impl Fn(usize) -> f64) -> Option<[usize; 2]> {
    let first = (0..side).find(|&k| black(k) < MOST)?;
    let last = (0..side).rfind(|&k| black(k) < MOST)?;
    let least = LEAST_PX.max((LEAST * side as f64) as usize);
    // The very border may be half black, as pictures are scaled down.
    let ends = |edge: usize, inner: usize| black(edge).min(black(inner)) <= 1.0 - ENDS;
    let both = first >= least && side - 1 - last >= least && last > first + 2;
    (both && ends(first, first + 1) && ends(last, last - 1)).then(|| {
        let half = |edge: usize, inner: usize| usize::from(black(edge) > black(inner) + 0.1);
        [first + half(first, first + 1), last + 1 - half(last, last - 1)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn photo(width: usize, height: usize, lightness: impl Fn(usize, usize) -> f32) -> Photo {
        let lab = (0..width * height).map(|i| [lightness(i % width, i / width), 0.0, 0.0]).collect();
        Photo { name: "frame".to_owned(), width, height, lab, scale: 1.0 }
    }

    #[test]
    fn bars_are_left_out_on_two_sides_or_four() {
        let wide = photo(120, 90, |_, y| if (12..78).contains(&y) { 40.0 } else { 1.0 });
        assert_eq!(without_bars(&wide), [0, 12, 120, 78]);
        let both = photo(120, 90, |x, y| if (12..78).contains(&y) && (9..111).contains(&x) { 40.0 } else { 1.0 });
        assert_eq!(without_bars(&both), [9, 12, 111, 78]);
    }

    #[test]
    fn black_ground_is_no_bar_nor_is_one_side_or_a_black_picture() {
        let disc = photo(90, 90, |x, y| if (x as f32 - 45.0).hypot(y as f32 - 45.0) < 20.0 { 60.0 } else { 1.0 });
        let floor = photo(90, 90, |_, y| if y < 70 { 60.0 } else { 1.0 });
        for photo in [disc, floor, photo(90, 90, |_, _| 1.0), photo(1, 1, |_, _| 1.0), photo(1, 300, |_, _| 50.0)] {
            assert_eq!(without_bars(&photo), [0, 0, photo.width, photo.height]);
        }
    }
}
