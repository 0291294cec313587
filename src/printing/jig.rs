//! A jig: numbered posts with a groove each, on a base in parts that fit a printer's bed. Real wire that is bent along the
//! numbers lies in the grooves.
//!
//! A post is cut by all that lies in or above the wire near it, so a groove is open at the top, the wire lifts out, and
//! what is left of the post is a field of heights: it hangs together.

use crate::body::{self, Body};
use crate::letters::Line;
use crate::mesh::Part;
use crate::strands::{CHORD_SHARE, Cone, Strands};
use glam::{DVec2, DVec3};
use wire4d_core::{Error, Result};

/// What a printer can make, and how exactly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Printer {
    /// Width, depth and height that fit it, mm.
    bed_mm: [f64; 3],
    /// Air between wire and groove all round, mm.
    tolerance_mm: f64,
}

impl Default for Printer {
    fn default() -> Self {
        Printer { bed_mm: [220.0, 220.0, 250.0], tolerance_mm: 0.2 }
    }
}

impl Printer {
    /// One whose bed and height are these, mm.
    ///
    /// # Errors
    /// [`Error::Setting`] for a side that no printer has.
    pub fn with_bed(bed_mm: [f64; 3]) -> Result<Printer> {
        let [least, most] = BED_MM;
        match bed_mm.iter().find(|side| !(least..=most).contains(*side)) {
            Some(side) => {
                let remedy = format!("give {least} to {most} mm a side");
                Err(Error::setting("--bed-mm", format!("{side} mm is no printer's bed"), remedy))
            }
            None => Ok(Printer { bed_mm, ..Printer::default() }),
        }
    }
}

/// A jig's parts.
#[derive(Debug, Clone, PartialEq)]
pub struct Jig {
    /// `jig-1`, `jig-2` and so on from the left front, row by row; edge to edge they are the whole stand.
    pub parts: Vec<Part>,
    /// How many posts carry the wire.
    pub posts: usize,
}

const BED_MM: [f64; 2] = [60.0, 2000.0];
/// A bed is not used up to its rim, mm.
const RIM_MM: f64 = 5.0;
const BASE_MM: f64 = 3.0;
/// From the base to the wire's lowest point: room for a finger and the numbers.
const AIR_MM: f64 = 8.0;
const NUMBER_MM: f64 = 4.5;
const RAISED_MM: f64 = 0.8;
/// What stands of a post on either side of its groove.
const WALL_MM: f64 = 1.6;
/// A groove's sides reach up to this many radii above the wire's middle.
const SIDES: f64 = 0.8;
/// A post widens so much towards its foot, as a share of its height.
const SPREAD: f64 = 0.02;
/// At most about so many posts, and no nearer along the wire than this, mm.
const MOST_POSTS: f64 = 80.0;
const LEAST_SPACING_MM: f64 = 20.0;
/// Steeper wire has no post: its groove would be a slit. The sine of 45°.
const STEEPEST: f64 = 0.71;
/// Between posts' feet and from them to an edge.
const GAP_MM: f64 = 1.0;

/// Where a post can stand.
#[derive(Debug, Clone, Copy)]
struct Post {
    /// Middle of the wire in its groove.
    place: DVec3,
    radius: f64,
    top: f64,
    top_radius: f64,
    foot_radius: f64,
}

impl Post {
    fn at(place: DVec3, radius: f64, printer: &Printer) -> Post {
        let top_radius = radius + printer.tolerance_mm + WALL_MM;
        let top = place.z + SIDES * radius;
        Post { place, radius, top, top_radius, foot_radius: top_radius + SPREAD * (top + AIR_MM) }
    }

    /// Whether no strand passes below the groove through the post.
    fn is_free(&self, cones: &[Cone], printer: &Printer) -> bool {
        let below = self.place.z - 1.5 * self.radius;
        !cones.iter().any(|cone| {
            let reach = self.foot_radius + cone.radii[0].max(cone.radii[1]) + printer.tolerance_mm;
            near(cone, self.place.truncate(), reach).is_some_and(|ends| ends[0].z.min(ends[1].z) < below)
        })
    }

    /// The post less all that the wire needs.
    fn body(&self, cones: &[Cone], printer: &Printer) -> Body {
        let middle = self.place.truncate();
        let circle = |radius, z: f64| body::round(middle, radius, 24).into_iter().map(move |p| p.extend(z));
        let post = circle(self.foot_radius, -AIR_MM - 0.5 * BASE_MM).chain(circle(self.top_radius, self.top));
        let grooves = cones.iter().filter_map(|cone| {
            // Chords leave the wire by a little.
            let radius = (1.0 + 2.0 * CHORD_SHARE) * cone.radii[0].max(cone.radii[1]) + printer.tolerance_mm;
            let reach = 1.1 * (self.foot_radius + radius);
            let ends = near(cone, middle, reach)?;
            (ends[0].z.min(ends[1].z) - 1.1 * radius < self.top).then(|| groove(ends, radius, self.top + 1.0))
        });
        let grooves = grooves.collect::<Vec<_>>();
        Body::hull(&post.collect::<Vec<_>>()).without(&Body::union(grooves))
    }
}

/// The stretch of a cone's axis that is near an upright line.
fn near(cone: &Cone, middle: DVec2, reach: f64) -> Option<[DVec3; 2]> {
    let [a, b] = cone.ends;
    let (from, axis) = (a.truncate() - middle, (b - a).truncate());
    let (square, half, rest) = (axis.length_squared(), from.dot(axis), from.length_squared() - reach * reach);
    if square < 1e-12 {
        return (rest < 0.0).then_some([a, b]);
    }
    let under = half * half - square * rest;
    if under <= 0.0 {
        return None;
    }
    let [first, last] = [-1.0, 1.0].map(|sign| ((-half + sign * under.sqrt()) / square).clamp(0.0, 1.0));
    (first < last).then(|| [a.lerp(b, first), a.lerp(b, last)])
}

/// All that is in or above a stretch of wire, up to a height: the hull of round bottoms that hold the wire's.
fn groove(ends: [DVec3; 2], radius: f64, top: f64) -> Body {
    const SIDES: usize = 16;
    const RINGS: usize = 4;
    let step = std::f64::consts::FRAC_PI_2 / RINGS as f64;
    // Facets touch the ball from outside.
    let outside = radius / (0.5 * step).cos();
    let bottom = ends.iter().flat_map(|&end| {
        let ring = move |i: usize| {
            let (sin, cos) = (step * i as f64).sin_cos();
            body::round(end.truncate(), outside * cos, SIDES).into_iter().map(move |p| p.extend(end.z - outside * sin))
        };
        let rim = ring(0).map(move |p| p.with_z(top.max(end.z + outside)));
        (0..RINGS).flat_map(ring).chain([end - DVec3::Z * outside]).chain(rim)
    });
    Body::hull(&bottom.collect::<Vec<_>>())
}

/// Posts along the wire on a base under it.
///
/// # Errors
/// [`Error::Setting`] for a wire that no post can carry.
pub fn jig(strands: &Strands, printer: &Printer) -> Result<Jig> {
    let [low, high] = strands.bounds().map(|corner| corner.truncate());
    // Numbers stand beside posts.
    let margin = DVec2::new(3.0, 1.5) * NUMBER_MM;
    let tiles = Tiles::new([low - margin, high + margin], printer);
    let posts = posts(strands, printer, &tiles);
    if posts.is_empty() {
        return Err(Error::setting(
            "--bed-mm",
            "no post that fits the printer reaches this wire",
            "give a smaller --size-mm or a larger --bed-mm",
        ));
    }
    let count = tiles.count[0] * tiles.count[1];
    let mut parts: Vec<Vec<Body>> = (0..count).map(|_| Vec::new()).collect();
    for (i, post) in posts.iter().enumerate() {
        let tile = tiles.of(post.place.truncate());
        parts[tile].push(post.body(&strands.cones, printer));
        let number = Line::new("number", &(i + 1).to_string())?;
        let levels = [-AIR_MM - 0.5, -AIR_MM + RAISED_MM];
        parts[tile].extend(number.bodies(tiles.beside(post, NUMBER_MM * number.aspect()), NUMBER_MM, levels));
    }
    let part = |(i, mut bodies): (usize, Vec<Body>)| {
        let name = format!("jig-{}", i + 1);
        bodies.push(Body::prism(&body::rounded(tiles.bounds(i), 1.0), [-AIR_MM - BASE_MM, -AIR_MM]));
        Part { name, mesh: Body::union(bodies).mesh() }
    };
    Ok(Jig { parts: parts.into_iter().enumerate().map(part).collect(), posts: posts.len() })
}

/// The base in parts.
struct Tiles {
    low: DVec2,
    side: DVec2,
    count: [usize; 2],
}

impl Tiles {
    fn new([low, high]: [DVec2; 2], printer: &Printer) -> Tiles {
        let [x, y, _] = printer.bed_mm;
        let count = ((high - low) / (DVec2::new(x, y) - 2.0 * RIM_MM)).ceil();
        Tiles { low, side: (high - low) / count, count: [count.x as usize, count.y as usize] }
    }

    fn of(&self, place: DVec2) -> usize {
        let at = ((place - self.low) / self.side).floor();
        let [x, y] = [at.x, at.y].map(|c| c.max(0.0) as usize);
        y.min(self.count[1] - 1) * self.count[0] + x.min(self.count[0] - 1)
    }

    fn bounds(&self, tile: usize) -> [DVec2; 2] {
        let at = DVec2::new((tile % self.count[0]) as f64, (tile / self.count[0]) as f64);
        [self.low + at * self.side, self.low + (at + 1.0) * self.side]
    }

    fn holds(&self, post: &Post) -> bool {
        let place = post.place.truncate();
        let [low, high] = self.bounds(self.of(place));
        let room = (place - low).min(high - place).min_element();
        room > post.foot_radius + GAP_MM
    }

    /// Where its number stands: to its right, or to its left where the part ends there.
    fn beside(&self, post: &Post, width: f64) -> DVec2 {
        let place = post.place.truncate();
        let [_, high] = self.bounds(self.of(place));
        let away = post.foot_radius + GAP_MM;
        let right = place.x + away;
        let x = if right + width + GAP_MM < high.x { right } else { place.x - away - width };
        DVec2::new(x, place.y - 0.5 * NUMBER_MM)
    }
}

/// About evenly along the wire, each at the flattest free place of its stretch.
fn posts(strands: &Strands, printer: &Printer, tiles: &Tiles) -> Vec<Post> {
    let length: f64 = strands.cones.iter().map(|cone| cone.ends[0].distance(cone.ends[1])).sum();
    let spacing = (length / MOST_POSTS).max(LEAST_SPACING_MM);
    let highest = printer.bed_mm[2] - AIR_MM - BASE_MM;
    let mut chosen: Vec<Post> = Vec::new();
    let mut best: Option<(f64, Post)> = None;
    let (mut along, mut stretch) = (0.0, 0);
    for cone in &strands.cones {
        let axis = cone.ends[1] - cone.ends[0];
        if along > spacing * f64::from(stretch + 1) {
            chosen.extend(best.take().map(|(_, post)| post));
            stretch = (along / spacing) as u32;
        }
        // Long straight stretches are as good in between as at their ends.
        let steps = (axis.length() / (0.25 * spacing)).ceil().max(1.0) as usize;
        let steep = axis.try_normalize().map_or(1.0, |axis| axis.z.abs());
        // In the middle of its stretch rather than where two meet.
        let early = ((along / spacing).fract() - 0.5).abs();
        along += axis.length();
        let worth = steep + 0.5 * early;
        if steep > STEEPEST || best.is_some_and(|(least, _)| least <= worth) {
            continue;
        }
        for step in 0..steps {
            let share = (step as f64 + 0.5) / steps as f64;
            let radius = cone.radii[0] + (cone.radii[1] - cone.radii[0]) * share;
            let post = Post::at(cone.ends[0] + axis * share, radius, printer);
            let apart = chosen.iter().all(|other| {
                let between = (other.place - post.place).truncate().length();
                between > other.foot_radius + post.foot_radius + GAP_MM + 2.0 * NUMBER_MM
            });
            if apart && post.top < highest && tiles.holds(&post) && post.is_free(&strands.cones, printer) {
                best = Some((worth, post));
                break;
            }
        }
    }
    chosen.extend(best.map(|(_, post)| post));
    chosen
}
