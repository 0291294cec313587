//! What is photographed: the wire, what it throws its shadows on, and what lights it.

use crate::lamp::Lamp;
use crate::matter::{Matter, Rough};
use crate::strands::Strands;
use glam::{Mat3A, Vec3, Vec3A};
use wire4d_core::view::View;
use wire4d_core::wire::Wire;
use wire4d_core::{Error, Result};

/// A flat rectangle that is there from its front alone: lamps behind it shine through, and nobody sees its back.
#[derive(Debug, Clone, Copy)]
pub struct Wall {
    /// Its middle.
    pub place: Vec3A,
    /// From its middle to two of its sides, at right angles.
    pub sides: [Vec3A; 2],
    /// What it is made of.
    pub matter: Matter,
}

impl Wall {
    /// Outward, of length 1.
    pub fn normal(&self) -> Vec3A {
        self.sides[0].cross(self.sides[1]).normalize()
    }

    /// How far along a ray it is; `None` beside it, behind the ray or from its back.
    fn distance(&self, origin: Vec3A, along: Vec3A) -> Option<f32> {
        let normal = self.normal();
        let towards = -normal.dot(along);
        if towards <= 0.0 {
            return None;
        }
        let distance = normal.dot(origin - self.place) / towards;
        let off = origin + distance * along - self.place;
        let inside = self.sides.iter().all(|side| side.dot(off).abs() <= side.length_squared());
        (distance > 0.0 && inside).then_some(distance)
    }
}

/// Where the shadows fall.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Place {
    /// On the walls of a room's corner, of a front, a side and a top.
    #[default]
    Room,
    /// On a screen for each view, with a lamp of its own.
    Screens,
    /// On a wide floor, under three large lamps of a photographer: the key from the left, warm; a cooler one to fill; and one from
    /// behind for the rim.
    Studio,
}

impl Place {
    /// A room where the wire was made to be seen from its sides, else screens.
    pub fn fitting(views: &[View]) -> Place {
        let is_of_room = |view: &View| AXES.iter().any(|axis| eye_and_up(view)[0].dot(*axis) > 0.999);
        if views.first().is_none_or(is_of_room) { Place::Room } else { Place::Screens }
    }

    /// How far its walls or screens are from the middle, world units: screens so far that none cuts through another.
    pub fn away(self, views: &[View]) -> f32 {
        let eyes: Vec<Vec3A> = views.iter().map(|view| eye_and_up(view)[0]).collect();
        let pairs = eyes.iter().enumerate().flat_map(|(i, a)| eyes[..i].iter().map(move |b| a.dot(*b)));
        let closest = match self {
            Place::Room | Place::Studio => 0.0,
            Place::Screens => pairs.fold(0.0f32, f32::max),
        };
        // Discs of radius r round the squares, at a distance d, meet at an angle θ where tan(θ/2) = r/d.
        let tan = ((1.0 - closest) / (1.0 + closest)).max(0.0).sqrt();
        (std::f32::consts::SQRT_2 * SCREEN_HALF / tan.max(1e-3)).clamp(WALL_AWAY, FARTHEST)
    }
}

/// Of what the wire is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Finish {
    /// Bare metal.
    #[default]
    Metal,
    /// Painted.
    Matte,
}

/// How it is set up. Lengths in world units; the wire lies in a box of about 2.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrangement {
    /// Where the shadows fall.
    pub place: Place,
    /// Of what the wire is.
    pub finish: Finish,
    /// Its colour, linear, 0 to 1.
    pub colour: Vec3,
    /// Of metal, 0 to 1.
    pub roughness: f32,
    /// Radius of the lamps; 0 for points.
    pub lamp_radius: f32,
    /// How far each lamp is from the middle of its view, 3 to 1,000.
    pub lamp_distance: f32,
    /// Light from all round, as a share of a lamp's, 0 to 1.
    pub surround: f32,
    /// How it comes.
    pub sky: Sky,
}

/// How light from all round comes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Sky {
    /// As in a bright room: a little more of it from above.
    #[default]
    Soft,
    /// The same from everywhere.
    Even,
    /// As on a grey day: the CIE's overcast sky (Moon and Spencer 1942), three times as bright above as at the horizon, and ground
    /// below that sends back a fifth.
    Overcast,
}

impl Sky {
    /// Towards a height above the horizon, as its sine, by what falls from it on level ground.
    fn brightness(self, sine: f32) -> f32 {
        match self {
            Sky::Soft => 0.75 + 0.25 * sine,
            Sky::Even => 1.0,
            // The mean of (1 + 2 sin) / 3 over the hemisphere, weighted with the sine, is 7/9.
            Sky::Overcast if sine >= 0.0 => (1.0 + 2.0 * sine) * (3.0 / 7.0),
            Sky::Overcast => GROUND,
        }
    }
}

/// What the ground sends back.
const GROUND: f32 = 0.2;

impl Default for Arrangement {
    fn default() -> Arrangement {
        Arrangement {
            place: Place::Room,
            finish: Finish::Metal,
            colour: Vec3::new(0.93, 0.52, 0.33),
            roughness: 0.42,
            lamp_radius: 0.16,
            lamp_distance: 24.0,
            surround: 0.04,
            sky: Sky::default(),
        }
    }
}

/// From the middle to walls and screens: beyond any wire, as near as may be.
pub const WALL_AWAY: f32 = 1.22;
/// Views that are nearly the same share their screens' places.
const FARTHEST: f32 = 6.0;
/// Half a screen's side, how far a lamp shines round its axis, and how far a room's walls reach.
const SCREEN_HALF: f32 = 1.2;
const BEAM: f32 = 2.7;
const REACH: f32 = 9.0;
/// Of plaster and paper.
const WALL_COLOUR: Vec3 = Vec3::new(0.58, 0.565, 0.54);
const PAPER_COLOUR: Vec3 = Vec3::new(0.66, 0.645, 0.62);
const SAMPLES_PER_SPAN: usize = 6;
/// Of the lamps of a room, from the front, the side and above: warm, warmer, and as if from a window.
const ROOM_TINTS: [Vec3; 3] = [Vec3::new(1.0, 0.965, 0.91), Vec3::new(1.0, 0.945, 0.87), Vec3::new(0.93, 0.965, 1.0)];
/// Where the lamps of a studio are, and their light: key, fill and rim. They are so much larger and nearer than those of a room.
const STUDIO: [([f32; 3], Vec3); 3] = [
    ([-0.35, 1.0, 0.9], Vec3::new(1.25, 1.17, 1.05)),
    ([1.0, 0.5, 0.6], Vec3::new(0.26, 0.29, 0.34)),
    ([0.3, 0.8, -1.0], Vec3::new(0.62, 0.6, 0.56)),
];
const SOFTBOX: f32 = 5.0;
const SOFTBOX_NEAR: f32 = 0.3;
const STUDIO_BEAM: f32 = 40.0;
const STUDIO_FLOOR: f32 = 60.0;

/// Everything that light meets.
pub struct Setting {
    pub(crate) strands: Strands,
    pub(crate) wire: Matter,
    /// The same where light comes from something matt: what a mirror throws onto a wall is blurred, or single paths outshine
    /// all others.
    pub(crate) blurred: Matter,
    pub(crate) walls: Vec<Wall>,
    pub(crate) lamps: Vec<Lamp>,
    pub(crate) surround: Surround,
}

/// Light from all round.
pub(crate) struct Surround {
    pub light: Vec3,
    pub sky: Sky,
}

/// Rougher than this seen by what is matt.
const BLURRED: f32 = 0.6;

impl Setting {
    /// `wire`, and for each of `views` (or of a room's three sides) a lamp at its eye's side with a screen or a wall behind.
    ///
    /// # Errors
    /// [`Error::Setting`] for what is out of range.
    pub fn new(wire: &Wire, views: &[View], arrangement: &Arrangement) -> Result<Setting> {
        let Arrangement { place, finish, colour, roughness, lamp_radius, lamp_distance, surround, sky } = arrangement;
        check("lamp-distance", *lamp_distance, [3.0, 1000.0])?;
        check("lamp-radius", *lamp_radius, [0.0, 2.0])?;
        check("roughness", *roughness, [0.0, 1.0])?;
        check("surround", *surround, [0.0, 1.0])?;
        let strands = Strands::new(wire, SAMPLES_PER_SPAN);
        let wall = Matter::Matte(WALL_COLOUR);
        let lamp = |eye: Vec3A, tint: Vec3| Lamp {
            place: *lamp_distance * eye,
            aim: Vec3A::ZERO,
            radius: *lamp_radius,
            beam: BEAM,
            light: tint,
        };
        let (walls, lamps): (Vec<Wall>, Vec<Lamp>) = match place {
            Place::Room => (0..3).map(|k| (wall_of_room(k, wall), lamp(AXES[k], ROOM_TINTS[k]))).unzip(),
            Place::Screens => {
                let away = place.away(views);
                views.iter().map(|view| (screen(view, away, wall), lamp(eye_and_up(view)[0], ROOM_TINTS[0]))).unzip()
            }
            Place::Studio => {
                let softbox = |(towards, light): ([f32; 3], Vec3)| Lamp {
                    radius: SOFTBOX * lamp_radius,
                    beam: STUDIO_BEAM,
                    ..lamp(SOFTBOX_NEAR * Vec3A::from_array(towards).normalize(), light)
                };
                (vec![floor(strands.bounds()[0].y.max(-WALL_AWAY))], STUDIO.map(softbox).to_vec())
            }
        };
        let reach = strands.bounds().map(|corner| corner.abs().max_element()).into_iter().fold(0.0, f32::max);
        if let Some(lamp) = lamps.iter().find(|lamp| lamp.place.abs().max_element() < reach + lamp.radius) {
            return Err(Error::setting(
                "lamp-distance",
                format!("puts a lamp {:.1} from the middle, inside the wire or against it", lamp.place.length()),
                format!("the wire reaches {reach:.1} far: give more, or a smaller lamp"),
            ));
        }
        let [matter, blurred] = [*roughness, roughness.max(BLURRED)].map(|roughness| match finish {
            Finish::Metal => Matter::Metal(*colour, Rough::new(roughness)),
            Finish::Matte => Matter::Matte(*colour),
        });
        Ok(Setting {
            strands,
            wire: matter,
            blurred,
            walls,
            lamps,
            surround: Surround { light: *surround * Vec3::new(0.92, 0.97, 1.06), sky: *sky },
        })
    }

    /// What a ray meets first, and where.
    pub(crate) fn meets(&self, origin: Vec3A, along: Vec3A) -> Option<Met<'_>> {
        let walls = self.walls.iter().enumerate();
        let nearest =
            walls.filter_map(|(i, wall)| Some((wall.distance(origin, along)?, i))).min_by(|a, b| a.0.total_cmp(&b.0));
        let most = nearest.map_or(f32::INFINITY, |(distance, _)| distance);
        let met =
            |distance: f32, normal, matter, is_wire| Met { place: origin + distance * along, normal, matter, is_wire };
        match self.strands.entry(origin, along, most) {
            Some(entry) => Some(met(entry.distance, entry.normal, &self.wire, true)),
            None => nearest.map(|(distance, i)| met(distance, self.walls[i].normal(), &self.walls[i].matter, false)),
        }
    }

    /// Whether nothing lies between two places that see each other along `along`.
    pub(crate) fn is_clear(&self, origin: Vec3A, along: Vec3A, distance: f32) -> bool {
        let in_front = |wall: &Wall| wall.distance(origin, along).is_some_and(|far| far < distance);
        !self.walls.iter().any(in_front) && !self.strands.blocks(origin, along, distance)
    }

    /// Light from all round.
    pub(crate) fn surround(&self, along: Vec3A) -> Vec3 {
        self.surround.light * self.surround.sky.brightness(along.y)
    }
}

/// What a ray meets.
pub(crate) struct Met<'a> {
    pub place: Vec3A,
    pub normal: Vec3A,
    pub matter: &'a Matter,
    pub is_wire: bool,
}

impl Met<'_> {
    /// The frame of which the normal is z.
    pub fn frame(&self) -> Mat3A {
        let (x, y) = self.normal.any_orthonormal_pair();
        Mat3A::from_cols(x, y, self.normal)
    }
}

/// Where a view is seen from, of length 1, and what is up there.
fn eye_and_up(view: &View) -> [Vec3A; 2] {
    let camera = view.camera::<f32>();
    let [forward, down] = [camera.forward, camera.down].map(|row| Vec3A::new(row[0], row[1], row[2]));
    [-forward.normalize(), -down.normalize()]
}

/// Behind the middle of a view, facing it.
fn screen(view: &View, away: f32, matter: Matter) -> Wall {
    let [eye, up] = eye_and_up(view);
    Wall { place: -away * eye, sides: [SCREEN_HALF * up.cross(eye).normalize(), SCREEN_HALF * up], matter }
}

/// A room's walls face the front, the side and the top.
const AXES: [Vec3A; 3] = [Vec3A::Z, Vec3A::X, Vec3A::Y];

/// From the room's corner far out.
fn wall_of_room(k: usize, matter: Matter) -> Wall {
    let [normal, across, up] = [AXES[k], AXES[(k + 1) % 3], AXES[(k + 2) % 3]];
    let (middle, half) = (0.5 * (REACH - WALL_AWAY), 0.5 * (REACH + WALL_AWAY));
    Wall { place: -WALL_AWAY * normal + middle * (across + up), sides: [half * across, half * up], matter }
}

/// At a height, wide and level.
fn floor(height: f32) -> Wall {
    let half = STUDIO_FLOOR;
    Wall { place: height * Vec3A::Y, sides: [half * Vec3A::Z, half * Vec3A::X], matter: Matter::Matte(PAPER_COLOUR) }
}

fn check(name: &str, value: f32, [least, most]: [f32; 2]) -> Result<()> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(Error::setting(name, format!("{value} is out of range"), format!("give {least} to {most}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paths::light;
    use crate::sampler::Sampler;
    use wire4d_core::raster::{ExactRaster, Raster};
    use wire4d_core::view::Projection;

    /// A wire that winds.
    fn wire() -> Wire {
        let point = |i: usize| {
            let (t, turn) = (i as f64 / 23.0, 0.8 * i as f64);
            [0.6 * turn.cos(), 1.4 * t - 0.7, 0.6 * turn.sin(), 0.03 + 0.02 * t]
        };
        Wire::open_uniform((0..24).map(point).collect()).unwrap()
    }

    fn arranged(arrangement: &Arrangement) -> Setting {
        Setting::new(&wire(), &View::canonical(2.2, 256), arrangement).unwrap()
    }

    #[test]
    fn a_sky_is_as_bright_as_it_says_and_white_ground_under_it_too() {
        for sky in [Sky::Even, Sky::Overcast] {
            let steps = 10_000;
            let sine = |i: usize| (i as f32 + 0.5) / steps as f32;
            // Light on level ground, over that of a sky of 1: the mean over the sine's square.
            let falls: f32 = (0..steps).map(|i| sky.brightness(sine(i)) * 2.0 * sine(i)).sum::<f32>() / steps as f32;
            assert!((falls - 1.0).abs() < 0.001, "{sky:?}: {falls}");
            let setting = Setting {
                walls: vec![Wall { matter: Matter::Matte(Vec3::ONE), ..floor(-WALL_AWAY) }],
                lamps: vec![],
                surround: Surround { light: Vec3::ONE, sky },
                ..arranged(&Arrangement::default())
            };
            let origin = Vec3A::new(40.0, 3.0, 40.0);
            let seen = |i: u32| light(&setting, origin, Vec3A::NEG_Y, &mut Sampler::new(1, 0, i));
            let mean = (0..16_384).map(|i| f64::from(seen(i).indirect.y)).sum::<f64>() / 16_384.0;
            assert!((mean - 1.0).abs() < 0.005, "{sky:?}: {mean}");
        }
        assert!((Sky::Overcast.brightness(1.0) / Sky::Overcast.brightness(0.0) - 3.0).abs() < 1e-5);
    }

    #[test]
    fn a_lamp_inside_the_wire_is_named() {
        let far = Wire::open_uniform((0..8).map(|i| [f64::from(i) - 3.5, 0.2, 0.0, 0.05]).collect()).unwrap();
        let arrangement = Arrangement { lamp_distance: 3.0, ..Arrangement::default() };
        let refused = Setting::new(&far, &View::canonical(2.2, 256), &arrangement).err().expect("it reaches the lamp");
        assert!(refused.to_string().contains("inside the wire"), "{refused}");
    }

    #[test]
    fn a_white_wire_in_even_light_cannot_be_seen() {
        for matter in [Matter::Matte(Vec3::ONE), Matter::Metal(Vec3::ONE, Rough::new(0.4))] {
            let surround = Surround { light: Vec3::ONE, sky: Sky::Even };
            let setting = Setting {
                wire: matter,
                blurred: matter,
                walls: vec![],
                lamps: vec![],
                surround,
                ..arranged(&Arrangement::default())
            };
            let (mut sum, mut met) = (0.0, 0);
            for i in 0..60_000 {
                let mut sampler = Sampler::new(1, i, 0);
                let [x, y] = sampler.pair();
                let origin = Vec3A::new(1.6 * x - 0.8, 1.6 * y - 0.8, 4.0);
                if setting.meets(origin, Vec3A::NEG_Z).is_some() {
                    let seen = light(&setting, origin, Vec3A::NEG_Z, &mut sampler);
                    (sum, met) = (sum + f64::from((seen.direct + seen.indirect).y), met + 1);
                }
            }
            let mean = sum / f64::from(met);
            assert!(met > 2000 && (mean - 1.0).abs() < 0.005, "{matter:?}: {mean} of {met}");
        }
    }

    /// Share of the back wall's places that are dark or lit other than where a camera at the lamp's place sees the wire, among those
    /// where it sees nothing but the wire or nothing of it.
    fn wrong(lamp: Vec3A) -> f64 {
        let setting = arranged(&Arrangement { lamp_radius: 0.0, lamp_distance: 24.0, ..Arrangement::default() });
        let (side, half) = (400, 1.0f32);
        let distance = f64::from(24.0 + WALL_AWAY);
        let view = View {
            projection: Projection::Perspective { fov_y_rad: 2.0 * (f64::from(half) / distance).atan() },
            eye: [0.0, 0.0, 24.0],
            ..View::canonical(2.2, side)[0].clone()
        };
        let (map, strokes) = wire().sampling_map::<f32>(SAMPLES_PER_SPAN, false);
        let points: Vec<[f32; 4]> = wire().control_points().iter().map(|point| point.map(|c| c as f32)).collect();
        let mut samples = Vec::new();
        map.apply(&points, &mut samples);
        let camera = view.camera::<f32>();
        let vertices: Vec<[f32; 3]> = samples.iter().map(|sample| camera.project(sample)).collect();
        let mut raster = ExactRaster::new();
        let shown = raster.forward(side, side, &vertices, &strokes);
        let (mut wrong, mut clear) = (0, 0);
        for (i, &covered) in shown.iter().enumerate() {
            let at = |k: usize| (k as f32 + 0.5) / side as f32 * 2.0 - 1.0;
            let place = Vec3A::new(half * at(i % side), -half * at(i / side), -WALL_AWAY);
            let way = lamp - place;
            if !(0.02..0.98).contains(&covered) {
                clear += 1;
                let is_lit = setting.is_clear(place, way.normalize(), way.length());
                wrong += usize::from(is_lit != (covered < 0.5));
            }
        }
        assert!(clear < shown.len(), "some of the places lie at a shadow's border");
        wrong as f64 / clear as f64
    }

    #[test]
    fn shadows_of_a_point_are_what_a_camera_there_sees_within_half_a_pixel() {
        assert_eq!(wrong(Vec3A::new(0.0, 0.0, 24.0)), 0.0);
        assert!(wrong(Vec3A::new(0.4, 0.0, 24.0)) > 0.005, "a shifted lamp would be noticed");
    }

    #[test]
    fn screens_keep_clear_of_each_other_and_what_is_out_of_range_is_named() {
        let views =
            [[0.0, 0.0], [0.6, 0.1], [2.4, -0.2], [4.0, 0.5]].map(|[a, e]| View::orthographic("v", a, e, 2.2, 256));
        let walls = arranged(&Arrangement::default()).walls;
        assert_eq!(walls.len(), 3, "a room has three, whatever the views");
        let setting =
            Setting::new(&wire(), &views, &Arrangement { place: Place::Screens, ..Arrangement::default() }).unwrap();
        assert_eq!((setting.walls.len(), setting.lamps.len()), (4, 4));
        for (i, a) in setting.walls.iter().enumerate() {
            let corner = |[x, y]: [f32; 2]| a.place + x * a.sides[0] + y * a.sides[1];
            for b in &setting.walls[i + 1..] {
                let beside =
                    |p: Vec3A| b.sides.iter().any(|side| side.dot(p - b.place).abs() > side.length_squared() * 0.999);
                let before = |p: Vec3A| b.normal().dot(p - b.place);
                let crosses = (0..=40).any(|k| {
                    let t = k as f32 / 20.0 - 1.0;
                    [[[t, -1.0], [t, 1.0]], [[-1.0, t], [1.0, t]]].iter().any(|ends| {
                        let [p, q] = ends.map(corner);
                        let [u, v] = [before(p), before(q)];
                        u * v < 0.0 && !beside(p.lerp(q, u / (u - v)))
                    })
                });
                assert!(!crosses, "{i}");
            }
        }
        for bad in [
            Arrangement { lamp_distance: 1.0, ..Arrangement::default() },
            Arrangement { lamp_radius: f32::NAN, ..Arrangement::default() },
            Arrangement { roughness: 2.0, ..Arrangement::default() },
        ] {
            let refused = Setting::new(&wire(), &views, &bad).err().expect("out of range");
            assert!(refused.to_string().contains("give"), "{refused}");
        }
    }
}
