//! Numbers that fill a square evenly at every count: Sobol's first two dimensions under Owen's scrambling, which a hash does
//! (Burley 2020); each use of a pixel has a scrambling and an order of its own.

/// The numbers of one sample of one pixel.
#[derive(Debug, Clone)]
pub struct Sampler {
    index: u32,
    stream: u32,
}

impl Sampler {
    /// For the `index`th sample of pixel `pixel`.
    pub fn new(seed: u32, pixel: u32, index: u32) -> Sampler {
        Sampler { index, stream: mixed(seed ^ mixed(pixel)) }
    }

    /// The next two numbers, each in [0, 1).
    pub fn pair(&mut self) -> [f32; 2] {
        self.stream = mixed(self.stream.wrapping_add(0x9e37_79b9));
        let index = scrambled(self.index, self.stream);
        let [x, y] = sobol(index);
        [scrambled(x, mixed(self.stream ^ 0x1)), scrambled(y, mixed(self.stream ^ 0x2))].map(unit)
    }

    /// The next one.
    pub fn one(&mut self) -> f32 {
        self.pair()[0]
    }
}

/// The 24 highest bits as a number in [0, 1).
fn unit(bits: u32) -> f32 {
    (bits >> 8) as f32 / 16_777_216.0
}

fn sobol(index: u32) -> [u32; 2] {
    let (mut second, mut direction) = (0u32, 1u32 << 31);
    let mut rest = index;
    while rest != 0 {
        if rest & 1 == 1 {
            second ^= direction;
        }
        direction ^= direction >> 1;
        rest >>= 1;
    }
    [index.reverse_bits(), second]
}

/// Each bit is turned or not as those above it say.
fn scrambled(bits: u32, seed: u32) -> u32 {
    let mut x = bits.reverse_bits();
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul((seed >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^= x.wrapping_mul(0x53a2_2864);
    x.reverse_bits()
}

/// A hash of 32 bits.
fn mixed(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_elementary_box_holds_one_sample() {
        for (seed, pixel, uses) in [(0, 0, 0), (7, 12_345, 3), (1, 1 << 20, 11)] {
            let samples: Vec<[f32; 2]> = (0..64)
                .map(|index| {
                    let mut sampler = Sampler::new(seed, pixel, index);
                    (0..uses).for_each(|_| {
                        sampler.pair();
                    });
                    sampler.pair()
                })
                .collect();
            for split in 0..=6 {
                let (across, down) = (1usize << split, 64usize >> split);
                let mut held = [0; 64];
                for [x, y] in &samples {
                    held[(x * across as f32) as usize * down + (y * down as f32) as usize] += 1;
                }
                assert_eq!(held, [1; 64], "{across} x {down}");
            }
        }
    }

    #[test]
    fn uses_and_pixels_have_nothing_to_do_with_each_other() {
        let pairs = |pixel: u32, which: usize| -> Vec<[f32; 2]> {
            (0..1024)
                .map(|index| {
                    let mut sampler = Sampler::new(5, pixel, index);
                    (0..which).for_each(|_| {
                        sampler.pair();
                    });
                    sampler.pair()
                })
                .collect()
        };
        let first = pairs(9, 0);
        for other in [pairs(9, 1), pairs(10, 0)] {
            let together: f32 =
                first.iter().zip(&other).map(|(a, b)| (a[0] - 0.5) * (b[0] - 0.5)).sum::<f32>() / 1024.0;
            assert!(together.abs() < 0.01, "{together}");
        }
    }
}
