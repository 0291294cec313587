//! What kind of picture it is: a photograph, or something that was drawn.

use super::spread::quantile;
use super::{Mask, Photo, Picture};
use crate::view::Image;

/// Steps of colour from the border's on which something is no ground.
const APART: f32 = 8.0;
/// How far inside of something its edges no longer reach, px of the [`Photo`].
const INSIDE_PX: f32 = 3.0;
/// Least share of the picture that is inside of something, for it to say anything.
const LEAST_INSIDE: f64 = 0.02;
/// Slopes that are neither flat nor an edge, steps of colour a pixel, and the share of them from which things are shaded.
const SHADED_SLOPES: [f32; 2] = [0.15, 4.0];
const SHADED: f64 = 0.45;
/// Noise or texture that no renderer makes, levels of 255, and what a clean ground may have.
const NOISE: f32 = 0.3;
const CLEAN: f32 = 0.15;
/// Pixels of the small picture in which paper is looked for, how far it reaches beneath what is on it, and its smoothing.
const PAPER_SIDE: usize = 128;
const BENEATH_PX: usize = 15;
const PAPER_SIGMA_PX: f64 = 5.0;
/// Paper is light, changes slowly, is of one colour, and is seen in more than half of the picture.
const PAPER_LIGHTNESS: f32 = 50.0;
const PAPER_SLOPE: f32 = 1.8;
const PAPER_COLOURS: f32 = 12.0;
const MOST_ON_PAPER: f64 = 0.4;
/// How far inside of marks their edges no longer reach, px of that picture, and how uneven ink is there at most.
const INSIDE_MARKS_PX: f32 = 1.5;
const UNEVEN: f32 = 0.14;
/// As a share of the paper's lightness, what is darker is on it and what is lighter is paper.
const ON_PAPER: f32 = 0.85;
const CLEAR: f32 = 0.92;

/// Whether a picture is a photograph of something, and neither a drawing, nor a photograph of one, nor a clean rendering.
///
/// In a drawing areas are of one colour; in renderings they are shaded without noise (the least of Laplacians that do not
/// see slopes; Immerkær 1996). On a photographed sheet a light ground of one colour, noisy itself, is seen nearly
/// everywhere once what is darker is closed.
pub fn is_photograph(picture: &Picture) -> bool {
    let photo = Photo::of(picture);
    let (width, height) = (photo.width, photo.height);
    if width < 16 || height < 16 {
        return false;
    }
    let on_border =
        |i: usize| i.is_multiple_of(width) || i % width + 1 == width || i / width == 0 || i / width + 1 == height;
    let border: Vec<usize> = (0..width * height).filter(|&i| on_border(i)).collect();
    let middle =
        [0, 1, 2].map(|c: usize| quantile(&mut border.iter().map(|&i| photo.lab[i][c]).collect::<Vec<_>>(), 0.5));
    let something = |i: usize| apart(photo.lab[i], middle) > APART;
    let something = Mask { width, height, data: (0..width * height).map(something).collect() };
    let inside = |mask: &Mask| -> Vec<bool> {
        mask.inverted().distance_px().data.iter().map(|&distance| distance > INSIDE_PX).collect()
    };
    let (within, ground) = (inside(&something), inside(&something.inverted()));
    let count = within.iter().filter(|&&within| within).count();
    if (count as f64) < LEAST_INSIDE * within.len() as f64 {
        return false;
    }
    let slope = |i: usize| {
        let (x, y) = (i % width, i / width);
        let between = |a: usize, b: usize| 0.5 * apart(photo.lab[a], photo.lab[b]);
        let across = between(y * width + x.saturating_sub(1), y * width + (x + 1).min(width - 1));
        let down = between(y.saturating_sub(1) * width + x, (y + 1).min(height - 1) * width + x);
        across.hypot(down)
    };
    let [least, most] = SHADED_SLOPES;
    let shaded = (0..within.len()).filter(|&i| within[i] && (least..most).contains(&slope(i))).count();
    if (shaded as f64) < SHADED * count as f64 || noise(picture, &photo, &within) < NOISE {
        return false;
    }
    let is_clean = noise(picture, &photo, &ground) < CLEAN;
    is_clean || !is_sheet(&photo)
}

fn apart(a: [f32; 3], b: [f32; 3]) -> f32 {
    (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f32>().sqrt()
}

/// The usual strength of what neither slopes nor is smooth, levels of 255, in the picture's own pixels where the photograph's
/// are `on`; 0 where none is.
fn noise(picture: &Picture, photo: &Photo, on: &[bool]) -> f32 {
    let (width, height) = (picture.width(), picture.height());
    let luma = |x: usize, y: usize| {
        picture.rgba()[4 * (y * width + x)..][..3].iter().map(|&v| f32::from(v)).sum::<f32>() / 3.0
    };
    let mut found = Vec::new();
    for y in 1..height.saturating_sub(1) {
        for x in 1..width.saturating_sub(1) {
            let small = |place: usize, side: usize| (((place as f64 + 0.5) * photo.scale) as usize).min(side - 1);
            if !on[small(y, photo.height) * photo.width + small(x, photo.width)] {
                continue;
            }
            let row = |y: usize, [a, b]: [f32; 2]| a * (luma(x - 1, y) + luma(x + 1, y)) + b * luma(x, y);
            let response = row(y - 1, [1.0, -2.0]) + row(y, [-2.0, 4.0]) + row(y + 1, [1.0, -2.0]);
            found.push(response.abs() / 6.0);
        }
    }
    // Mean absolute deviation of a normal distribution, from its median.
    if found.is_empty() { 0.0 } else { 1.4826 * quantile(&mut found, 0.5) }
}

/// Whether most of it is a sheet of light paper.
fn is_sheet(photo: &Photo) -> bool {
    let scale = PAPER_SIDE as f64 / photo.width.max(photo.height) as f64;
    let [width, height] = [photo.width, photo.height].map(|side| ((side as f64 * scale).round() as usize).max(1));
    let [light, a, b] = [0, 1, 2].map(|c| photo.channel(c).resized(width, height));
    let closed = extremes(&extremes(&light, f32::max), f32::min);
    let paper = closed.blurred(PAPER_SIGMA_PX);
    // A blur sees ground outside: what the weights came to there is put back.
    let weights = Image { data: vec![1.0; width * height], ..light.clone() }.blurred(PAPER_SIGMA_PX);
    let paper: Vec<f32> =
        paper.data.iter().zip(&weights.data).map(|(paper, weight)| paper / weight.max(1e-6)).collect();
    let share = |i: usize| light.data[i] / paper[i].max(1.0);
    let marks = Mask { width, height, data: (0..paper.len()).map(|i| share(i) < ON_PAPER).collect() };
    let dark = marks.count();
    // Ink is thin or even; things on a table are neither.
    let beyond = marks.inverted().distance_px();
    let mut inside: Vec<f32> = (0..paper.len()).filter(|&i| beyond.data[i] > INSIDE_MARKS_PX).map(share).collect();
    let spread = quantile(&mut inside, 0.9) - quantile(&mut inside, 0.1);
    if inside.len() as f64 > LEAST_INSIDE * paper.len() as f64 && spread > UNEVEN {
        return false;
    }
    let clear: Vec<usize> = (0..paper.len()).filter(|&i| share(i) > CLEAR).collect();
    if dark as f64 > MOST_ON_PAPER * paper.len() as f64 || clear.is_empty() {
        return false;
    }
    let [middle_a, middle_b] =
        [&a, &b].map(|channel| quantile(&mut clear.iter().map(|&i| channel.data[i]).collect::<Vec<_>>(), 0.5));
    let off = |&i: &usize| (a.data[i] - middle_a).abs() + (b.data[i] - middle_b).abs();
    let colours = quantile(&mut clear.iter().map(off).collect::<Vec<_>>(), 0.9);
    let slope = |i: usize| {
        let right = if i % width + 1 < width { i + 1 } else { i };
        let below = if i + width < paper.len() { i + width } else { i };
        (paper[right] - paper[i]).hypot(paper[below] - paper[i])
    };
    let steep = quantile(&mut (0..paper.len()).map(slope).collect::<Vec<_>>(), 0.9);
    let darkest = quantile(&mut paper.clone(), 0.05);
    darkest > PAPER_LIGHTNESS && steep < PAPER_SLOPE && colours < PAPER_COLOURS
}

/// The extreme value within [`BENEATH_PX`] of each pixel, along rows and columns.
fn extremes(image: &Image, extreme: impl Fn(f32, f32) -> f32) -> Image {
    let (width, height) = (image.width, image.height);
    let pass = |data: &[f32], at: &dyn Fn(usize, usize) -> usize, lines: usize, count: usize| {
        let mut out = vec![0.0; data.len()];
        for line in 0..lines {
            for k in 0..count {
                let reach = k.saturating_sub(BENEATH_PX)..(k + BENEATH_PX + 1).min(count);
                let value = reach.map(|n| data[at(line, n)]).reduce(&extreme);
                out[at(line, k)] = value.unwrap_or_default();
            }
        }
        out
    };
    let rows = pass(&image.data, &|line, k| line * width + k, height, width);
    Image { data: pass(&rows, &|line, k| k * width + line, width, height), ..*image }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    const SIDE: usize = 200;

    /// From shades at a place, 0 to 1, with so much noise.
    fn picture(noise: f64, shade: impl Fn(f64, f64) -> f64) -> Picture {
        let mut rng = Rng::new(4, 0);
        let mut pixel = |i: usize| {
            let value = shade((i % SIDE) as f64, (i / SIDE) as f64) + noise * (rng.unit() + rng.unit() - 1.0);
            let value = (255.0 * value.clamp(0.0, 1.0)).round() as u8;
            [value, value, value, 255]
        };
        Picture::new("any", SIDE, SIDE, (0..SIDE * SIDE).flat_map(&mut pixel).collect()).unwrap()
    }

    fn ball(x: f64, y: f64) -> Option<f64> {
        let (u, v) = ((x - 100.0) / 70.0, (y - 100.0) / 70.0);
        let depth = 1.0 - u * u - v * v;
        (depth > 0.0).then(|| 0.1 + 0.6 * (0.5 * depth.sqrt() - 0.5 * u - 0.5 * v).clamp(0.0, 1.0))
    }

    fn stroke(x: f64, y: f64) -> bool {
        ((x - 100.0).hypot(y - 100.0) - 60.0).abs() < 4.0 || (x - 100.0).abs() < 4.0 && (y - 100.0).abs() < 60.0
    }

    #[test]
    fn a_noisy_ball_is_photographed_a_clean_one_rendered() {
        let ball_on = |noise: f64, ground: f64| picture(noise, |x, y| ball(x, y).unwrap_or(ground));
        assert!(is_photograph(&ball_on(0.03, 0.9)) && is_photograph(&ball_on(0.03, 0.3)));
        assert!(!is_photograph(&ball_on(0.0, 0.9)) && !is_photograph(&ball_on(0.0, 0.3)));
        // Cut out and laid on white.
        let mut rng = Rng::new(5, 0);
        let noisy: Vec<f64> = (0..SIDE * SIDE).map(|_| 0.04 * (rng.unit() - 0.5)).collect();
        let cut_out =
            picture(0.0, |x, y| ball(x, y).map_or(1.0, |shade| shade + noisy[y as usize * SIDE + x as usize]));
        assert!(is_photograph(&cut_out));
    }

    #[test]
    fn drawings_are_none_nor_are_photographs_of_them() {
        let drawn = |x: f64, y: f64| if stroke(x, y) { 0.1 } else { 0.95 };
        assert!(!is_photograph(&picture(0.0, drawn)));
        assert!(!is_photograph(&picture(0.04, drawn)), "scanned");
        let lit = |x: f64, y: f64| drawn(x, y) * (0.6 + 0.3 * x / SIDE as f64);
        assert!(!is_photograph(&picture(0.04, lit)), "photographed in uneven light");
        // The check can fail: what is not light all over is no sheet.
        let dark = |x: f64, y: f64| if x < 90.0 { 0.15 + 0.1 * y / SIDE as f64 } else { lit(x, y) };
        assert!(is_photograph(&picture(0.04, dark)));
        assert!(!is_photograph(&picture(0.0, |_, _| 1.0)));
        assert!(!is_photograph(&Picture::new("tiny", 1, 1, vec![9; 4]).unwrap()));
    }
}
