//! A plate for a printed wire to stand on, with its name.

use crate::body::{self, Body};
use crate::letters::Line;
use crate::strands::{Cone, Strands};
use glam::DVec2;
use wire4d_core::Result;

/// What stands under a printed wire.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Plate {
    name: Option<Line>,
}

const THICKNESS_MM: f64 = 3.0;
/// From the plate to the wire's lowest point.
const AIR_MM: f64 = 5.0;
/// From posts and letters to the plate's edge.
const MARGIN_MM: f64 = 5.0;
const RAISED_MM: f64 = 1.0;
const LETTER_MM: [f64; 2] = [5.0, 12.0];
/// Posts are no thinner than this at their foot.
const FOOT_RADIUS_MM: f64 = 1.4;
const MOST_POSTS: usize = 6;
/// Posts reach up to this share of the wire's height, and stand this share of its longest side apart.
const REACH: f64 = 0.35;
const APART: f64 = 0.15;
/// The plate is at least this share of what the wire covers, so that nothing topples.
const STANCE: f64 = 0.55;

impl Plate {
    /// With raised letters along the front, small ones as capitals.
    ///
    /// # Errors
    /// [`Error::Setting`](wire4d_core::Error::Setting) for an empty or very long name, or a letter that there is not.
    pub fn with_name(name: &str) -> Result<Plate> {
        Ok(Plate { name: Some(Line::new("--name", name)?) })
    }

    /// Posts, which become one with the wire, from the plate to where the wire comes nearest.
    pub(crate) fn posts(&self, strands: &Strands) -> Vec<Cone> {
        let [low, high] = strands.bounds();
        let mut lows: Vec<_> = strands.cones.iter().map(|cone| (cone.ends[0], cone.radii[0])).collect();
        lows.sort_by(|a, b| a.0.z.total_cmp(&b.0.z));
        let mut chosen: Vec<(glam::DVec3, f64)> = Vec::new();
        for (end, radius) in lows {
            let apart =
                chosen.iter().all(|(other, _)| (other - end).truncate().length() > APART * (high - low).max_element());
            let reached = end.z - low.z <= REACH * (high.z - low.z) || chosen.is_empty();
            if apart && reached && chosen.len() < MOST_POSTS {
                chosen.push((end, radius));
            }
        }
        let post = |(end, radius): &(glam::DVec3, f64)| Cone {
            ends: [end.with_z(-AIR_MM - 0.5 * THICKNESS_MM), *end],
            radii: [FOOT_RADIUS_MM.max(*radius).min(0.49 * THICKNESS_MM), radius.min(FOOT_RADIUS_MM)],
        };
        chosen.iter().map(post).collect()
    }

    /// The plate, and its letters.
    pub(crate) fn body(&self, strands: &Strands, posts: &[Cone]) -> Body {
        let [low, high] = strands.bounds().map(|corner| corner.truncate());
        let middle = 0.5 * (low + high);
        let half = 0.5 * STANCE * (high - low);
        let feet = posts.iter().map(|post| post.ends[0].truncate());
        let [mut low, mut high] =
            feet.fold([middle - half, middle + half], |[low, high], foot| [low.min(foot), high.max(foot)]);
        low -= MARGIN_MM;
        high += MARGIN_MM;
        let top = -AIR_MM;
        let mut bodies = Vec::new();
        if let Some(line) = &self.name {
            let height = ((high.x - low.x - 2.0 * MARGIN_MM) / line.aspect()).clamp(LETTER_MM[0], LETTER_MM[1]);
            let width = height * line.aspect();
            let wider = 0.5 * (width + 2.0 * MARGIN_MM - (high.x - low.x)).max(0.0);
            low.x -= wider;
            high.x += wider;
            low.y -= height + MARGIN_MM;
            let corner = DVec2::new(0.5 * (low.x + high.x - width), low.y + MARGIN_MM);
            bodies = line.bodies(corner, height, [top - RAISED_MM, top + RAISED_MM]);
        }
        bodies.push(Body::prism(&body::rounded([low, high], MARGIN_MM), [top - THICKNESS_MM, top]));
        Body::union(bodies)
    }
}
