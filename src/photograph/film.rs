//! What has come through the lens so far, and the picture that it makes.

use crate::lens::{Camera, Lens};
use crate::paths::{Light, light};
use crate::sampler::Sampler;
use crate::setting::Setting;
use glam::{Vec3, Vec4};
use std::ops::Mul;
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
    rows: Vec<Row>,
}

/// What of a picture's row has come so far; no room is taken for one that nobody exposes.
#[derive(Clone, Default)]
struct Row {
    passes: u32,
    sums: Vec<Light>,
}

impl Row {
    /// Of what each pass was.
    fn share(&self) -> f32 {
        1.0 / self.passes.max(1) as f32
    }
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
        Ok(Film { camera, width, height, seed, rows: vec![Row::default(); height] })
    }

    /// Width and height, px.
    pub fn size(&self) -> [usize; 2] {
        [self.width, self.height]
    }

    /// Samples that every pixel has so far.
    pub fn passes(&self) -> u32 {
        self.rows.iter().map(|row| row.passes).min().unwrap_or(0)
    }

    /// One more sample of every pixel.
    pub fn expose(&mut self, setting: &Setting) {
        let Film { camera, width, seed, rows, .. } = self;
        let (camera, width, seed) = (&*camera, *width, *seed);
        parallel::each_mut(rows, 1, |y, row| expose(camera, setting, width, seed, y, row));
    }

    /// One more sample of each pixel of row `y`, from the top; below the picture nothing happens. Rows exposed one by one, in any
    /// order and on any machine, make the same picture.
    pub fn expose_row(&mut self, setting: &Setting, y: usize) {
        if let Some(row) = self.rows.get_mut(y) {
            expose(&self.camera, setting, self.width, self.seed, y, row);
        }
    }

    /// What came to row `y`, to be put on another film of the same lens and size.
    pub fn row(&self, y: usize) -> Vec<f32> {
        let lights = self.rows.get(y).map_or(&[][..], |row| &row.sums);
        lights.iter().flat_map(|light| light.to_array()).collect()
    }

    /// Takes over what came to row `y` in `passes` on another film, in place of what is there.
    ///
    /// # Errors
    /// [`Error::Setting`] where it is no row of this film.
    pub fn put_row(&mut self, y: usize, passes: u32, light: &[f32]) -> Result<()> {
        let (lights, rest) = light.as_chunks();
        match self.rows.get_mut(y) {
            Some(row) if lights.len() == self.width && rest.is_empty() => {
                *row = Row { passes, sums: lights.iter().map(Light::from_array).collect() };
                Ok(())
            }
            _ => Err(Error::setting("row", "is of another picture", "give one of the same size")),
        }
    }

    /// The mean light of each pixel, linear, rows from the top.
    pub fn light(&self) -> Vec<Vec3> {
        self.each(|sum| sum.direct + sum.indirect)
    }

    /// As a picture: RGB, 3 bytes a pixel, sRGB, rows from the top.
    pub fn developed(&self, how: Develop) -> Vec<u8> {
        let gain = how.exposure.exp2();
        let direct = self.each(|sum| sum.direct);
        let indirect = if how.calmed { self.calmed() } else { self.each(|sum| sum.indirect) };
        direct
            .iter()
            .zip(&indirect)
            .flat_map(|(direct, indirect)| encoded(filmic(gain * (*direct + *indirect))))
            .collect()
    }

    /// Row `y` as it is, with its noise, in an instant; bytes as of `developed`, nothing before its first pass.
    pub fn glimpse(&self, y: usize, how: Develop) -> Vec<u8> {
        let Some(row) = self.rows.get(y) else { return vec![] };
        let gain = row.share() * how.exposure.exp2();
        row.sums.iter().flat_map(|sum| encoded(filmic(gain * (sum.direct + sum.indirect)))).collect()
    }

    /// The mean of something of each pixel, rows from the top.
    fn each<T: Copy + Default + Mul<f32, Output = T>>(&self, what: impl Fn(&Light) -> T) -> Vec<T> {
        let mut all = vec![T::default(); self.width * self.height];
        for (row, means) in self.rows.iter().zip(all.chunks_exact_mut(self.width)) {
            for (sum, mean) in row.sums.iter().zip(means) {
                *mean = what(sum) * row.share();
            }
        }
        all
    }

    /// The indirect light, with that of pixels nearby that see the same surface: it changes slowly along one, and has nearly all
    /// the noise. Two rounds, the second with gaps (Dammertz et al. 2010).
    fn calmed(&self) -> Vec<Vec3> {
        let seen = self.each(|sum| sum.normal.extend(sum.wire * WIRE_APART));
        // Noise falls with the root of the passes, and so may the reach.
        let reach = (REACH_PX / (self.passes().max(1) as f32).powf(0.25)).clamp(1.0, REACH_PX);
        let mut light = self.each(|sum| sum.indirect);
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

fn expose(camera: &Camera, setting: &Setting, width: usize, seed: u32, y: usize, row: &mut Row) {
    row.sums.resize(width, Light::default());
    for (x, sum) in row.sums.iter_mut().enumerate() {
        let mut sampler = Sampler::new(seed, (y * width + x) as u32, row.passes);
        let ([dx, dy], lens) = (sampler.pair(), sampler.pair());
        let [origin, along] = camera.ray([x as f32 + dx, y as f32 + dy], lens);
        *sum += light(setting, origin, along, &mut sampler);
    }
    row.passes += 1;
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setting::Arrangement;
    use wire4d_core::view::View;
    use wire4d_core::wire::Wire;

    #[test]
    fn rows_exposed_elsewhere_make_the_same_picture() {
        let points =
            (0..12).map(|i| [0.8 * f64::from(i).cos(), 0.12 * f64::from(i) - 0.7, 0.8 * f64::from(i).sin(), 0.06]);
        let wire = Wire::open_uniform(points.collect()).unwrap();
        let setting = Setting::new(&wire, &View::canonical(2.2, 64), &Arrangement::default()).unwrap();
        let film = || Film::new(&Lens::default(), [48, 27], 5).unwrap();
        let (mut whole, mut developing, mut parts) = (film(), film(), [film(), film()]);
        (0..3).for_each(|_| whole.expose(&setting));
        for y in (0..27).rev() {
            let part = &mut parts[y % 2];
            (0..3).for_each(|_| part.expose_row(&setting, y));
            developing.put_row(y, 3, &part.row(y)).unwrap();
        }
        let how = Develop::default();
        assert_eq!(developing.passes(), 3);
        assert_eq!(developing.developed(how), whole.developed(how));
        let rough = Develop { calmed: false, ..how };
        assert_eq!(parts[1].glimpse(13, rough), whole.developed(rough)[13 * 48 * 3..14 * 48 * 3]);
        assert_eq!(parts[1].glimpse(12, rough), []);
        assert!(developing.put_row(27, 3, &parts[0].row(0)).is_err() && developing.put_row(0, 3, &[0.0; 30]).is_err());
    }
}
