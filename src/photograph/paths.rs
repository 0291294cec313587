//! Light that comes along a ray: followed backwards from meeting to meeting (Kajiya 1986), asking at each of them what the lamps
//! send there.

use crate::sampler::Sampler;
use crate::setting::{Met, Setting};
use glam::{Vec3, Vec3A};
use std::ops::AddAssign;

/// After this many meetings light is as good as lost.
const MOST_MEETINGS: usize = 24;
/// From here on paths are followed as likely as they matter (Russian roulette).
const SURE_MEETINGS: usize = 3;
/// What starts at a surface starts this far above it.
const ABOVE: f32 = 2e-4;

/// What of the light along a ray is there: straight from the lamps to what it meets, and all else.
#[derive(Debug, Clone, Copy, Default)]
pub struct Light {
    /// From lamps to what is met first, and to the eye.
    pub direct: Vec3,
    /// By any other way.
    pub indirect: Vec3,
    /// What is met first: its normal (nothing where nothing is), and whether it is the wire.
    pub normal: Vec3,
    /// See there.
    pub wire: f32,
}

impl Light {
    /// As ten numbers.
    pub fn to_array(self) -> [f32; 10] {
        let [[a, b, c], [d, e, f], [g, h, i]] = [self.direct, self.indirect, self.normal].map(|each| each.to_array());
        [a, b, c, d, e, f, g, h, i, self.wire]
    }

    /// From what [`Light::to_array`] gave.
    pub fn from_array(&[a, b, c, d, e, f, g, h, i, wire]: &[f32; 10]) -> Light {
        Light { direct: Vec3::new(a, b, c), indirect: Vec3::new(d, e, f), normal: Vec3::new(g, h, i), wire }
    }
}

impl AddAssign for Light {
    fn add_assign(&mut self, other: Light) {
        self.direct += other.direct;
        self.indirect += other.indirect;
        self.normal += other.normal;
        self.wire += other.wire;
    }
}

/// The light that comes to `origin` against `along` (length 1).
pub(crate) fn light(setting: &Setting, mut origin: Vec3A, mut along: Vec3A, sampler: &mut Sampler) -> Light {
    let mut light = Light::default();
    let mut share = Vec3::ONE;
    let mut was_matt = false;
    for meeting in 0..MOST_MEETINGS {
        let Some(mut met) = setting.meets(origin, along) else {
            light.indirect += share * setting.surround(along);
            break;
        };
        if met.is_wire && was_matt {
            met.matter = &setting.blurred;
        }
        if meeting == 0 {
            (light.normal, light.wire) = (met.normal.into(), f32::from(met.is_wire));
        }
        let frame = met.frame();
        let to_eye = frame.transpose() * -along;
        let from = met.place + ABOVE * met.normal;
        let sent = share * from_lamps(setting, &met, from, to_eye, meeting, sampler);
        if meeting == 0 {
            light.direct += sent
        } else {
            light.indirect += sent
        }
        let Some(bounce) = met.matter.bounce(to_eye, sampler.pair()) else { break };
        share *= bounce.weight;
        if meeting + 1 >= SURE_MEETINGS {
            let likely = share.max_element().min(1.0);
            if sampler.one() >= likely {
                break;
            }
            share /= likely;
        }
        was_matt = !met.is_wire;
        (origin, along) = (from, frame * bounce.along);
    }
    light
}

/// What of the lamps' light goes on to the eye: of all of them where a path begins, of one of them for all later.
fn from_lamps(setting: &Setting, met: &Met, from: Vec3A, to_eye: Vec3A, meeting: usize, sampler: &mut Sampler) -> Vec3 {
    let to_frame = met.frame().transpose();
    let count = setting.lamps.len();
    let mut sum = Vec3::ZERO;
    let (lamps, times) = match meeting {
        _ if count == 0 => (&setting.lamps[..], 1.0),
        0 => (&setting.lamps[..], 1.0),
        _ => {
            let one = ((sampler.one() * count as f32) as usize).min(count - 1);
            (&setting.lamps[one..=one], count as f32)
        }
    };
    for lamp in lamps {
        let Some(shine) = lamp.shine(met.place, sampler.pair()) else { continue };
        let reflects = met.matter.reflects(to_eye, to_frame * shine.to_lamp);
        if reflects != Vec3::ZERO && setting.is_clear(from, shine.to_lamp, shine.distance) {
            sum += times * shine.light * reflects;
        }
    }
    sum
}
