//! Drawn lines as ink.

use super::Line;
use crate::raster::{ExactRaster, Raster};
use crate::view::Image;
use crate::wire::Stroke;

/// The ink of lines, 0 to 1, in a picture as large as the photograph they were drawn of.
pub fn ink(lines: &[Line], width: usize, height: usize) -> Image {
    let (mut vertices, mut strokes) = (Vec::new(), Vec::new());
    for line in lines {
        strokes.push(Stroke { start: vertices.len(), count: line.points.len(), closed: false });
        vertices.extend(line.points.iter().map(|&[x, y]| [x, y, 0.5 * line.width_px]));
    }
    Image { width, height, data: ExactRaster::default().forward(width, height, &vertices, &strokes).to_vec() }
}

#[cfg(test)]
mod tests {
    use super::super::Kind;
    use super::*;

    #[test]
    fn a_line_is_as_wide_and_long_as_it_says() {
        let points = (0..=40).map(|i| [12.0 + i as f32, 32.0]).collect();
        let line = Line { points, width_px: 4.0, importance: 1.0, kind: Kind::Inner };
        let ink = ink(&[line], 64, 64);
        let sum: f32 = ink.data.iter().sum();
        assert!((sum - (160.0 + std::f32::consts::PI * 4.0)).abs() < 0.5, "{sum}");
        assert_eq!((ink.at(30, 32), ink.at(30, 40)), (1.0, 0.0));
    }
}
