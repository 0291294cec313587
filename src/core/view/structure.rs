//! Which way the strokes of a picture run.

use super::Image;

/// The structure tensor of a picture: outer products of its gradients, averaged over a Gaussian window (Förstner & Gülch
/// 1987, Bigün & Granlund 1987). All of the picture's size.
#[derive(Debug, Clone, PartialEq)]
pub struct StructureTensor {
    /// Mean square of the gradient along x.
    pub xx: Image,
    /// Mean product of the gradient along x and y.
    pub xy: Image,
    /// Mean square of the gradient along y.
    pub yy: Image,
}

impl StructureTensor {
    /// Of a picture of `width` x `height` px whose channels have the `gradients` at a column and row, over a window with a
    /// standard deviation of `sigma_px`.
    pub fn new<const CHANNELS: usize>(
        [width, height]: [usize; 2],
        sigma_px: f64,
        gradients: impl Fn(usize, usize) -> [[f64; 2]; CHANNELS],
    ) -> StructureTensor {
        let mut products = [(); 3].map(|()| Image::new(width, height));
        for y in 0..height {
            for x in 0..width {
                for [dx, dy] in gradients(x, y) {
                    for (image, product) in products.iter_mut().zip([dx * dx, dx * dy, dy * dy]) {
                        image.data[y * width + x] += product as f32;
                    }
                }
            }
        }
        let [xx, xy, yy] = products.map(|image| image.blurred(sigma_px));
        StructureTensor { xx, xy, yy }
    }

    /// The gradients' mean square, direction (radians from x towards y, where they are strongest) and coherence, from 0
    /// (all ways alike) to 1 (one way only), at entry `i` of the pictures.
    pub fn at(&self, i: usize) -> (f64, f64, f64) {
        let [xx, xy, yy] = [&self.xx, &self.xy, &self.yy].map(|image| f64::from(image.data[i]));
        let (trace, spread) = (xx + yy, (xx - yy).hypot(2.0 * xy));
        (trace, 0.5 * (2.0 * xy).atan2(xx - yy), if trace > 0.0 { spread / trace } else { 0.0 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stripes_have_one_direction_and_a_plain_corner_has_two() {
        let angle = 0.4f64;
        let (sin, cos) = angle.sin_cos();
        let stripes = |x: usize, y: usize| {
            let slope = (0.9 * (x as f64 * cos + y as f64 * sin)).cos();
            [[slope * cos, slope * sin]]
        };
        let (trace, direction, coherence) = StructureTensor::new([48, 48], 4.0, stripes).at(24 * 48 + 24);
        assert!(trace > 0.2 && (direction - angle).abs() < 1e-3 && coherence > 0.999, "{direction} {coherence}");
        // Two channels that disagree everywhere.
        let crossed = |x: usize, y: usize| {
            let [[dx, dy]] = stripes(x, y);
            [[dx, dy], [-dy, dx]]
        };
        let (_, _, coherence) = StructureTensor::new([48, 48], 4.0, crossed).at(24 * 48 + 24);
        assert!(coherence < 1e-6, "{coherence}");
        assert_eq!(StructureTensor::new([8, 8], 1.0, |_, _| [[0.0; 2]]).at(0).2, 0.0);
    }
}
