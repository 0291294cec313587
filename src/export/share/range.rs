//! Adaptive binary range coding (Martin 1979, with carries held back), and numbers made of such bits.
//!
//! [`Coder`] has one set of methods for both directions: an [`Encoder`] writes the value it is given and returns it, a
//! [`Decoder`] ignores the value and returns what it reads. So a format is written down once and cannot differ.

/// The code says something no wire has.
#[derive(Debug)]
pub struct Nonsense;

/// Probability that a bit is 1, learned as it goes.
#[derive(Debug, Clone, Copy)]
pub struct Model {
    /// In 65536ths.
    one: u16,
    /// Bits seen, up to a limit: the first ones count most.
    seen: u8,
}

/// A model never moves by less than about 1 in this many.
const SLOWEST: u8 = 40;

impl Default for Model {
    fn default() -> Self {
        Model { one: 1 << 15, seen: 0 }
    }
}

impl Model {
    /// In 4096ths, never 0 or 1.
    fn probability(&self) -> u32 {
        u32::from(self.one >> 4).clamp(24, 4096 - 24)
    }

    fn learn(&mut self, bit: bool) {
        let target = if bit { 65_535 } else { 0 };
        let step = (target - i32::from(self.one)) * 2 / (2 * i32::from(self.seen) + 3);
        self.one = (i32::from(self.one) + step).clamp(0, 65_535) as u16;
        self.seen = (self.seen + 1).min(SLOWEST);
    }
}

/// Writes or reads bits; see the module.
pub trait Coder {
    /// A bit that is 1 with a probability of `one` in 2^`precision`, neither never nor always; `precision` is at most 16.
    fn split(&mut self, bit: bool, one: u32, precision: u32) -> bool;

    /// A bit whose probability is learned.
    fn bit(&mut self, bit: bool, model: &mut Model) -> bool {
        let bit = self.split(bit, model.probability(), 12);
        model.learn(bit);
        bit
    }

    /// Whether more was read than there is.
    fn exhausted(&self) -> bool {
        false
    }

    /// A bit as likely as not.
    fn flag(&mut self, bit: bool) -> bool {
        self.bit(bit, &mut Model::default())
    }

    /// The low `count` bits of a value, all as likely as not. `count` is at most 64.
    fn bits(&mut self, value: u64, count: u32) -> u64 {
        (0..count).rev().fold(0, |read, k| read << 1 | u64::from(self.flag(value >> k & 1 == 1)))
    }

    /// Any number, its length first.
    fn whole(&mut self, value: u64) -> u64 {
        let length = self.bits(u64::from(u64::BITS - value.leading_zeros()), 7).min(64) as u32;
        self.bits(value, length)
    }

    /// A number that is often small, below 2^31; `models` learn how small.
    fn number(&mut self, value: i64, models: &mut NumberModels) -> i64 {
        let magnitude = value.unsigned_abs();
        let length = self.tree(u64::BITS - magnitude.leading_zeros(), &mut models.length);
        if length == 0 {
            return 0;
        }
        let high = &mut models.high[length as usize];
        let mut read = 1u64;
        for k in (0..length - 1).rev() {
            let bit = magnitude >> k & 1 == 1;
            // The two bits after the leading one still have a shape; what follows is noise.
            let bit = match length - 2 - k {
                0 => self.bit(bit, &mut high[0]),
                1 => self.bit(bit, &mut high[1 + (read & 1) as usize]),
                _ => self.flag(bit),
            };
            read = read << 1 | u64::from(bit);
        }
        if self.bit(value < 0, &mut models.sign) { -(read as i64) } else { read as i64 }
    }

    /// A number below 32 as five learned bits.
    fn tree(&mut self, value: u32, models: &mut [Model; 32]) -> u32 {
        let mut node = 1usize;
        for k in (0..5).rev() {
            let bit = self.bit(value >> k & 1 == 1, &mut models[node]);
            node = node << 1 | usize::from(bit);
        }
        node as u32 & 31
    }
}

/// What [`Coder::number`] learns.
#[derive(Debug, Clone)]
pub struct NumberModels {
    length: [Model; 32],
    high: [[Model; 3]; 32],
    sign: Model,
}

impl Default for NumberModels {
    fn default() -> Self {
        let model = Model::default();
        NumberModels { length: [model; 32], high: [[model; 3]; 32], sign: model }
    }
}

const LEAST_RANGE: u32 = 1 << 24;

/// Writes.
#[derive(Debug)]
pub struct Encoder {
    bytes: Vec<u8>,
    low: u64,
    range: u32,
    /// The last byte, held back with the 0xff bytes after it until no carry can change them.
    held: Option<u8>,
    held_ones: usize,
}

impl Encoder {
    /// Nothing written yet.
    pub fn new() -> Encoder {
        Encoder { bytes: Vec::new(), low: 0, range: u32::MAX, held: None, held_ones: 0 }
    }

    /// The bytes. Zeros at the end are left out: a [`Decoder`] reads zeros beyond the end.
    pub fn finish(mut self) -> Vec<u8> {
        // Of the numbers in the interval, the one with the most zeros at its end.
        let high = self.low + u64::from(self.range) - 1;
        let rounded = (0..32).rev().map(|zeros| high >> zeros << zeros).find(|&rounded| rounded >= self.low);
        self.low = rounded.unwrap_or(self.low);
        for _ in 0..6 {
            self.shift();
        }
        while self.bytes.last() == Some(&0) {
            self.bytes.pop();
        }
        self.bytes
    }

    fn shift(&mut self) {
        let carry = (self.low >> 32) as u8;
        let byte = (self.low >> 24) as u8;
        if carry != 0 || byte != 0xff {
            if let Some(held) = self.held {
                self.bytes.push(held.wrapping_add(carry));
            }
            self.bytes.extend(std::iter::repeat_n(0xff_u8.wrapping_add(carry), self.held_ones));
            self.held = Some(byte);
            self.held_ones = 0;
        } else {
            self.held_ones += 1;
        }
        self.low = (self.low & 0x00ff_ffff) << 8;
    }
}

impl Coder for Encoder {
    fn split(&mut self, bit: bool, one: u32, precision: u32) -> bool {
        let bound = (self.range >> precision) * one;
        if bit {
            self.range = bound;
        } else {
            self.low += u64::from(bound);
            self.range -= bound;
        }
        while self.range < LEAST_RANGE {
            self.range <<= 8;
            self.shift();
        }
        bit
    }
}

/// Reads what an [`Encoder`] wrote; anything else gives nonsense but never fails.
#[derive(Debug)]
pub struct Decoder<'a> {
    bytes: &'a [u8],
    next: usize,
    code: u32,
    range: u32,
}

impl<'a> Decoder<'a> {
    /// From the start.
    pub fn new(bytes: &'a [u8]) -> Decoder<'a> {
        let mut decoder = Decoder { bytes, next: 0, code: 0, range: u32::MAX };
        for _ in 0..4 {
            decoder.shift();
        }
        decoder
    }

    fn shift(&mut self) {
        let byte = self.bytes.get(self.next).copied().unwrap_or(0);
        self.next += 1;
        self.code = self.code << 8 | u32::from(byte);
    }
}

impl Coder for Decoder<'_> {
    fn split(&mut self, _: bool, one: u32, precision: u32) -> bool {
        let bound = (self.range >> precision) * one;
        let bit = self.code < bound;
        if bit {
            self.range = bound;
        } else {
            self.code -= bound;
            self.range -= bound;
        }
        while self.range < LEAST_RANGE {
            self.range <<= 8;
            self.shift();
        }
        bit
    }

    fn exhausted(&self) -> bool {
        // Four bytes are read ahead, and zeros at the end were left out: a few more are no proof.
        self.next > self.bytes.len() + 64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn what_is_written_is_read() {
        for seed in 0..200 {
            let mut rng = Rng::new(seed, 5);
            let scale = 2f64.powf(rng.range(0.0, 30.0));
            let values: Vec<i64> = (0..rng.below(300)).map(|_| rng.range(-scale, scale) as i64).collect();
            let mut encoder = Encoder::new();
            let mut models = NumberModels::default();
            for &value in &values {
                encoder.number(value, &mut models);
            }
            encoder.whole(u64::MAX - seed);
            encoder.bits(5, 3);
            let bytes = encoder.finish();
            let mut decoder = Decoder::new(&bytes);
            let mut models = NumberModels::default();
            for &value in &values {
                assert_eq!(decoder.number(0, &mut models), value, "seed {seed}");
            }
            assert_eq!((decoder.whole(0), decoder.bits(0, 3)), (u64::MAX - seed, 5));
            assert!(!decoder.exhausted());
        }
    }

    #[test]
    fn likely_bits_are_cheap_and_random_ones_cost_a_bit() {
        let mut rng = Rng::new(1, 1);
        let mut size = |likely: f64| {
            let (mut encoder, mut model) = (Encoder::new(), Model::default());
            for _ in 0..8000 {
                encoder.bit(rng.unit() < likely, &mut model);
            }
            encoder.finish().len()
        };
        assert!((990..1030).contains(&size(0.5)));
        assert!(size(0.98) < 180, "the entropy is 141 bytes");
    }
}
