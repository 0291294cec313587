//! What has come through the lens so far, and the picture that it makes.

use crate::lens::{Camera, Lens};
use crate::paths::{Light, light};
use crate::sampler::Sampler;
use crate::setting::Setting;
use glam::{Vec3, Vec4};
use wire4d_core::{Error, Result, parallel};

/// How light becomes a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Develop {
    /// Stops of exposure: each doubles the light.
    pub exposure: f32,
    /// Whether indirect light is mixed with that of pixels nearby: without, it is there at once, with all its noise.
    pub calmed: bool,
}

impl Default for Develop {
    fn default() -> Develop {
        Develop { exposure: 1.0, calmed: true }
    }
}

/// How far light is mixed with that of other pixels after one pass, px.
const REACH_PX: f32 = 12.0;
/// Surfaces whose normals differ by this are still alike, and how far the wire is from all others by the same measure.
const ALIKE: f32 = 0.12;
const WIRE_APART: f32 = 2.0;

/// Largest side of a picture, px.
pub const MOST_PX: usize = 8192;

/// A picture that gets better with every pass.
pub struct Film {
    camera: Camera,
    width: usize,
    height: usize,
    seed: u32,
    passes: u32,
    sums: Vec<Light>,
}

impl Film {
    /// Nothing on it yet.
    ///
    /// # Errors
    /// [`Error::Setting`] for a size or a lens out of range.
    pub fn new(lens: &Lens, [width, height]: [usize; 2], seed: u32) -> Result<Film> {
        if !(1..=MOST_PX).contains(&width) || !(1..=MOST_PX).contains(&height) {
            return Err(Error::setting(
                "size",
                format!("{width} x {height} px"),
                format!("give 1 to {MOST_PX} px a side"),
            ));
        }
        let camera = Camera::new(lens, [width, height])?;
        Ok(Film { camera, width, height, seed, passes: 0, sums: vec![Light::default(); width * height] })
    }

    /// Width and height, px.
    pub fn size(&self) -> [usize; 2] {
        [self.width, self.height]
    }

    /// Samples a pixel so far.
    pub fn passes(&self) -> u32 {
        self.passes
    }

    /// One more sample of every pixel.
    pub fn expose(&mut self, setting: &Setting) {
        let Film { camera, width, seed, passes, .. } = self;
        let (camera, width, seed, pass) = (&*camera, *width, *seed, *passes);
        let mut rows: Vec<&mut [Light]> = self.sums.chunks_exact_mut(width).collect();
        parallel::each_mut(&mut rows, 1, |y, row| {
            for (x, sum) in row.iter_mut().enumerate() {
                let mut sampler = Sampler::new(seed, (y * width + x) as u32, pass);
                let ([dx, dy], lens) = (sampler.pair(), sampler.pair());
                let [origin, along] = camera.ray([x as f32 + dx, y as f32 + dy], lens);
                let seen = light(setting, origin, along, &mut sampler);
                sum.direct += seen.direct;
                sum.indirect += seen.indirect;
                sum.normal += seen.normal;
                sum.wire += seen.wire;
            }
        });
        self.passes += 1;
    }

    /// The mean light of each pixel, linear, rows from the top.
    pub fn light(&self) -> Vec<Vec3> {
        let share = 1.0 / self.passes.max(1) as f32;
        self.sums.iter().map(|sum| share * (sum.direct + sum.indirect)).collect()
    }

    /// As a picture: RGB, 3 bytes a pixel, sRGB, rows from the top.
    pub fn developed(&self, how: Develop) -> Vec<u8> {
        let gain = how.exposure.exp2();
        let share = 1.0 / self.passes.max(1) as f32;
        let indirect = match how.calmed {
            true => self.calmed(),
            false => self.sums.iter().map(|sum| share * sum.indirect).collect(),
        };
        let light = self.sums.iter().zip(&indirect).map(|(sum, indirect)| share * sum.direct + *indirect);
        light.flat_map(|light| encoded(filmic(gain * light))).collect()
    }

    /// The indirect light, with that of pixels nearby that see the same surface: it changes slowly along one, and has nearly all
    /// the noise. Two rounds, the second with gaps (Dammertz et al. 2010).
    fn calmed(&self) -> Vec<Vec3> {
        let share = 1.0 / self.passes.max(1) as f32;
        let seen: Vec<Vec4> = self.sums.iter().map(|sum| share * sum.normal.extend(sum.wire * WIRE_APART)).collect();
        // Noise falls with the root of the passes, and so may the reach.
        let reach = (REACH_PX / (self.passes.max(1) as f32).powf(0.25)).clamp(1.0, REACH_PX);
        let mut light: Vec<Vec3> = self.sums.iter().map(|sum| share * sum.indirect).collect();
        for step in [1, 3] {
            light = self.mixed(&light, &seen, reach, step);
        }
        light
    }

    fn mixed(&self, light: &[Vec3], seen: &[Vec4], reach: f32, step: usize) -> Vec<Vec3> {
        let (width, height) = (self.width, self.height);
        let taps = reach.ceil() as isize;
        let bell = |k: isize| (-0.5 * (2.0 * k as f32 / reach).powi(2)).exp();
        let rows: Vec<usize> = (0..height).collect();
        let made = parallel::map(&rows, 1, |&y| {
            let pixel = |x: usize| {
                let here = seen[y * width + x];
                let (mut sum, mut weights) = (Vec3::ZERO, 0.0);
                for (dy, dx) in (-taps..=taps).flat_map(|dy| (-taps..=taps).map(move |dx| (dy, dx))) {
                    let [at_y, at_x] = [y as isize + dy * step as isize, x as isize + dx * step as isize];
                    if at_y < 0 || at_x < 0 || at_y >= height as isize || at_x >= width as isize {
                        continue;
                    }
                    let other = at_y as usize * width + at_x as usize;
                    let apart = (seen[other] - here).length_squared();
                    let weight = bell(dy) * bell(dx) * (-apart / (2.0 * ALIKE * ALIKE)).exp();
                    (sum, weights) = (sum + weight * light[other], weights + weight);
                }
                sum / weights
            };
            (0..width).map(pixel).collect::<Vec<Vec3>>()
        });
        made.concat()
    }
}

/// A curve with a foot and a shoulder (Narkowicz's fit of ACES, 2016).
fn filmic(light: Vec3) -> Vec3 {
    let x = light.max(Vec3::ZERO);
    let y = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    y.clamp(Vec3::ZERO, Vec3::ONE)
}

fn encoded(linear: Vec3) -> [u8; 3] {
    linear.to_array().map(|value| {
        let curve = if value <= 0.003_130_8 { 12.92 * value } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 };
        (255.0 * curve + 0.5) as u8
    })
}
