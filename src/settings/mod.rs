//! Every setting there is, once: name, group, unit, range, default and one line of help. The command line's flags, the
//! page's controls, the saved file and the link are all made from [`TABLE`], so they cannot drift apart.

mod task;

pub use task::Task;

use crate::{Error, Result, picture::Polarity, start, wire::Form};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;

/// Where a control is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Group {
    /// What is run.
    Run,
    /// The wire's form and width.
    Wire,
    /// How the drawings are read and arranged.
    Views,
    /// How the wire is fitted.
    Fit,
    /// One picture: the solid behind it and what the wire draws of it.
    Stroke,
    /// A mesh: how the wire covers it, and in which style.
    Surface,
    /// For people who know the method.
    Expert,
}

/// What values a setting takes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Kind {
    /// A whole number in `min..=max`.
    Integer {
        /// Smallest value.
        min: u64,
        /// Largest value.
        max: u64,
    },
    /// A number in `min..=max`.
    Number {
        /// Smallest value.
        min: f64,
        /// Largest value.
        max: f64,
    },
    /// One of a few words.
    Choice {
        /// The words.
        choices: &'static [&'static str],
    },
    /// On or off.
    Switch,
}

/// One row of the table.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Setting {
    /// Snake case; the flag is the same with dashes.
    pub name: &'static str,
    /// Where it is shown.
    pub group: Group,
    /// Unit for people, empty where there is none.
    pub unit: &'static str,
    /// One line of help.
    pub help: &'static str,
    /// Range or choices.
    #[serde(flatten)]
    pub kind: Kind,
}

impl Setting {
    fn impossible(&self, name: &str, text: &str) -> Error {
        Error::setting(name, format!("{text:?} is not a possible value"), format!("give {}", self.kind.words()))
    }
}

macro_rules! choices {
    ($($(#[$doc:meta])* $name:ident { $($(#[$variant_doc:meta])* $variant:ident = $word:literal),* $(,)? })*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
        pub enum $name { $($(#[$variant_doc])* #[serde(rename = $word)] $variant),* }
        impl $name {
            /// All of them.
            pub const ALL: &'static [$name] = &[$($name::$variant),*];
            /// The words people type, in the same order.
            pub const WORDS: &'static [&'static str] = &[$($word),*];
        }
    )*};
}

choices! {
    /// A bundle of defaults.
    Preset {
        /// The best wire in about ten seconds.
        Best = "best",
        /// Recognisable in about two seconds.
        Fast = "fast",
        /// The paper's own settings as far as they are known.
        Paper = "paper",
    }
    /// What computes the fit.
    Backend {
        /// The best there is.
        Auto = "auto",
        /// The processor.
        Cpu = "cpu",
        /// The graphics card.
        Gpu = "gpu",
    }
    /// Where the first wire comes from.
    Start {
        /// A tree grown through the drawings and a closed circuit round it that goes no way twice but where it must.
        Circuit = "circuit",
        /// A tree grown through the drawings, walked there and back: one connected wire.
        Tree = "tree",
        /// Along the outline and inwards, line by line, on the front and back of the solid behind one picture.
        Contour = "contour",
        /// Points inside what all pictures allow, joined by a short tour.
        Hull = "hull",
        /// Points in a ball, joined by a short tour (the paper's).
        Ball = "ball",
        /// Parallel lines over a mesh, stitched into one.
        Stripes = "stripes",
        /// Points spread over a mesh, joined by a short tour.
        Tour = "tour",
    }
    /// What the front of one picture's wire should show.
    Shading {
        /// Lines as wide as the picture is dark.
        Lines = "lines",
        /// The picture's own greys.
        Grey = "grey",
    }
    /// Which way the lines run that fill one picture's object.
    Hatching {
        /// Slices, or contours where the object winds like a ring or a letter.
        Auto = "auto",
        /// Along its outline, one inside the other.
        Contours = "contours",
        /// Across it: each goes round the solid like the edge of a slice.
        Slices = "slices",
    }
    /// Which way the lines run that cover a mesh.
    Flow {
        /// Wherever they stay parallel best.
        Smooth = "smooth",
        /// Up and down.
        Along = "along",
        /// Round it.
        Across = "across",
        /// Along the strokes of the style's picture.
        Style = "style",
    }
    /// How a picture is laid on a mesh.
    Motif {
        /// Not at all.
        Off = "off",
        /// From six sides, repeated.
        Box = "box",
        /// Once, from the front.
        Front = "front",
    }
    /// From where a mesh is looked at during the fit.
    Looks {
        /// From five sides, each a little turned every time.
        Sides = "sides",
        /// From anywhere.
        Sphere = "sphere",
    }
    /// How far the drawings may bend to agree with each other.
    Bend {
        /// Not at all.
        None = "none",
        /// A pixel or two, during the fit.
        Little = "little",
        /// As much as it takes, before and during the fit.
        Free = "free",
    }
    /// What is ink in a picture.
    Ink {
        /// Guessed from the border.
        Auto = "auto",
        /// Dark on light ground.
        Dark = "dark",
        /// Light on dark ground.
        Light = "light",
    }
    /// Whether the wire is as thick everywhere.
    Width {
        /// It is, as most wire that one can buy.
        Constant = "constant",
        /// It gets thicker and thinner as the pictures ask.
        Varying = "varying",
    }
    /// Which views may be turned by quarters while arranging.
    Turn {
        /// None.
        None = "none",
        /// Only the top view.
        Top = "top",
    }
    /// On or off, for the flags that say so.
    OnOff {
        /// Yes.
        On = "on",
        /// No.
        Off = "off",
    }
    /// How pictures are made coarser for the loss.
    Pyramid {
        /// Gaussian blur, then every other pixel.
        Gaussian = "gaussian",
        /// Averages of 2 x 2 pixels.
        Average = "average",
    }
    /// Where re-initialised control points go.
    NewPoint {
        /// Where a drawing still lacks ink.
        Lacking = "lacking",
        /// Anywhere in the object's volume (the paper's text).
        Random = "random",
        /// Between the two neighbours.
        Midpoint = "midpoint",
    }
}

impl From<Ink> for Polarity {
    fn from(ink: Ink) -> Polarity {
        match ink {
            Ink::Auto => Polarity::Auto,
            Ink::Dark => Polarity::DarkInk,
            Ink::Light => Polarity::LightInk,
        }
    }
}

impl From<Hatching> for start::Hatching {
    fn from(hatching: Hatching) -> start::Hatching {
        match hatching {
            Hatching::Auto => start::Hatching::Auto,
            Hatching::Contours => start::Hatching::Contours,
            Hatching::Slices => start::Hatching::Slices,
        }
    }
}

const FORMS: &[&str] = &["wire", "chain", "bag"];

mod form_word {
    use super::*;
    use serde::{Deserializer, Serializer, de::Error as _};
    pub fn serialize<S: Serializer>(form: &Form, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(match form {
            Form::Spline => "wire",
            Form::Chain => "chain",
            Form::Bag => "bag",
        })
    }
    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Form, D::Error> {
        match String::deserialize(deserializer)?.as_str() {
            "wire" => Ok(Form::Spline),
            "chain" => Ok(Form::Chain),
            "bag" => Ok(Form::Bag),
            _ => Err(D::Error::custom("wire, chain or bag")),
        }
    }
}

macro_rules! settings {
    ($($group:ident $(#[doc = $help:literal])+ $(#[serde($serde:meta)])? $name:ident: $type:ty = $default:expr, $unit:literal, $kind:expr;)*) => {
        /// Values for every row of [`TABLE`]. `Default` is the preset `best`.
        #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
        #[serde(deny_unknown_fields, default)]
        pub struct Settings {
            $($(#[doc = $help])+ $(#[serde($serde)])? pub $name: $type,)*
        }
        impl Default for Settings {
            fn default() -> Self {
                Settings { $($name: $default,)* }
            }
        }
        /// Every setting in the order people should see them.
        pub const TABLE: &[Setting] = &[$(Setting {
            name: stringify!($name),
            group: Group::$group,
            unit: $unit,
            help: concat!($($help),+).trim_ascii_start(),
            kind: $kind,
        }),*];
    };
}

use Kind::{Choice, Integer, Number, Switch};

settings! {
    Run /// A bundle of defaults: best, fast or the paper's.
    preset: Preset = Preset::Best, "", Choice { choices: Preset::WORDS };
    Run /// The same seed and pictures give the same wire.
    seed: u64 = 0, "", Integer { min: 0, max: 9_007_199_254_740_991 };
    Run /// What computes the fit.
    backend: Backend = Backend::Auto, "", Choice { choices: Backend::WORDS };
    Run /// How many steps the fit takes in all.
    iterations: usize = 1000, "steps", Integer { min: 1, max: 100_000 };
    Run /// Side of the square pictures the wire is fitted to.
    size: usize = 256, "px", Integer { min: 32, max: 2048 };

    Wire /// One spline, a chain of Béziers with corners, or loose Béziers (the last two to compare with).
    #[serde(with = "form_word")]
    form: Form = Form::Spline, "", Choice { choices: FORMS };
    Wire /// Keep the wire a wire: soft bends, nowhere through itself; off follows every line of the pictures.
    smooth: OnOff = OnOff::On, "", Choice { choices: OnOff::WORDS };
    Wire /// The least bend radius while fitting, where the wire is kept smooth.
    bend_radius: f64 = 1.5, "diameters", Number { min: 0.0, max: 20.0 };
    Wire /// Thicker and thinner as the pictures ask, or the same width everywhere.
    width: Width = Width::Varying, "", Choice { choices: Width::WORDS };
    Wire /// Control points of the first wire; 0 lets the start choose.
    control_points: usize = 0, "points", Integer { min: 0, max: 20_000 };
    Wire /// Distance between control points where the start chooses their number.
    spacing: f64 = 5.0, "px at 256", Number { min: 0.5, max: 64.0 };
    Wire /// Make the first wire shorter: cross over inside strokes instead of walking branches there and back.
    shorter: bool = false, "", Switch;
    Wire /// Thinnest the wire may get, as seen in a picture of 256 px.
    min_width: f64 = 1.5, "px at 256", Number { min: 0.0, max: 64.0 };
    Wire /// Thickest the wire may get, as seen in a picture of 256 px.
    max_width: f64 = 8.0, "px at 256", Number { min: 0.1, max: 128.0 };

    Views /// Try which drawing goes where, mirrored or turned, and keep what agrees best.
    arrange: OnOff = OnOff::On, "", Choice { choices: OnOff::WORDS };
    Views /// Drawings may change places while arranging.
    may_swap: bool = true, "", Switch;
    Views /// Drawings may be mirrored while arranging.
    may_mirror: bool = true, "", Switch;
    Views /// Which views may be turned by quarters while arranging.
    may_turn: Turn = Turn::Top, "", Choice { choices: Turn::WORDS };
    Views /// How far the drawings may bend to agree with each other.
    bend: Bend = Bend::Little, "", Choice { choices: Bend::WORDS };
    Views /// What is ink in the pictures.
    ink: Ink = Ink::Auto, "", Choice { choices: Ink::WORDS };
    Views /// Lines thinner than this are thickened to it before the fit; 0 leaves them alone.
    min_stroke: f64 = 4.0, "px at 256", Number { min: 0.0, max: 32.0 };
    Views /// The most a drawing may be stretched so that views agree along shared axes.
    max_stretch: f64 = 1.35, "times", Number { min: 1.0, max: 4.0 };

    Fit /// Where the first wire comes from.
    start: Start = Start::Circuit, "", Choice { choices: Start::WORDS };
    Fit /// Move control points whose width has vanished to where they are needed.
    reinit: bool = false, "", Switch;
    Fit /// Add control points where the pictures pull hardest.
    refine: bool = false, "", Switch;
    Fit /// How calm the wire is: weight of its bending, or of the jerk of positions where it is not kept smooth.
    smoothness: f64 = 1.0, "times", Number { min: 0.0, max: 1000.0 };

    Stroke /// Which of several objects, the largest first.
    object: usize = 1, "", Integer { min: 1, max: 999 };
    Stroke /// What the front should show: lines as wide as the picture is dark, or its own greys.
    shading: Shading = Shading::Lines, "", Choice { choices: Shading::WORDS };
    Stroke /// Lines that fill run along the outline, or round the solid like slices; auto takes what suits its shape.
    hatching: Hatching = Hatching::Auto, "", Choice { choices: Hatching::WORDS };
    Stroke /// From line to line where areas are filled; wider is more abstract.
    hatch: f64 = 11.0, "px at 256", Number { min: 2.0, max: 128.0 };
    Stroke /// Width of the outline and of inner edges.
    outline: f64 = 3.0, "px at 256", Number { min: 0.5, max: 32.0 };
    Stroke /// How much more ink darker parts get: 0 none, 1 from hair lines to filled.
    tone: f64 = 1.0, "of 1", Number { min: 0.0, max: 1.0 };
    Stroke /// How readily inner edges are drawn: 0 not at all, 1 the clear ones, more the faint ones too.
    edges: f64 = 1.0, "times", Number { min: 0.0, max: 8.0 };
    Stroke /// How readily parts that catch the eye get closer and finer lines and the rest sparser ones: 0 not at all.
    saliency: f64 = 0.0, "of 1", Number { min: 0.0, max: 1.0 };
    Stroke /// Material: how readily highlights stay blank with a line round them; 0 is matte.
    gloss: f64 = 0.0, "of 1", Number { min: 0.0, max: 1.0 };
    Stroke /// Thickness of the solid: 1 makes a ball of a disc, 0 nearly a sheet.
    roundness: f64 = 0.9, "times", Number { min: 0.0, max: 2.0 };
    Stroke /// Largest half thickness, as a share of half the object's smaller side.
    most_depth: f64 = 1.0, "times", Number { min: 0.01, max: 4.0 };
    Stroke /// How far light parts come forward and dark ones go back, as a share of the solid's thickness.
    relief: f64 = 0.0, "of 1", Number { min: 0.0, max: 1.0 };
    Stroke /// From how many more sides, drawn from the seed, the wire is held against the solid.
    side_views: usize = 6, "views", Integer { min: 0, max: 24 };
    Stroke /// After how many steps other sides are drawn; 0 keeps to those that are measured in the end.
    new_sides: usize = 50, "steps", Integer { min: 0, max: 100_000 };
    Stroke /// How strongly sides ask for a line where the solid's outline or a crease lies: 0 not at all.
    creases: f64 = 0.3, "of 1", Number { min: 0.0, max: 1.0 };
    Stroke /// Weight of all those sides together; the front's is 1.
    side_weight: f64 = 0.4, "times", Number { min: 0.0, max: 16.0 };

    Surface /// From line to line on the surface; the shape fits a ball of radius 1 world unit.
    curve_spacing: f64 = 0.06, "world units", Number { min: 0.02, max: 0.2 };
    Surface /// Which way the lines run: smooth, along the upright, across it, or along the style's strokes.
    flow: Flow = Flow::Style, "", Choice { choices: Flow::WORDS };
    Surface /// How much of the surface is ink.
    density: f64 = 0.5, "of 1", Number { min: 0.1, max: 1.0 };
    Surface /// How strongly the style bends and thickens the wire: 0 not at all.
    style_strength: f64 = 0.6, "of 1", Number { min: 0.0, max: 1.0 };
    Surface /// Side of the style's picture on the surface, which fits a ball of radius 1 world unit.
    style_size: f64 = 1.2, "world units", Number { min: 0.1, max: 4.0 };
    Surface /// How the style's picture is laid on the surface: box from six sides, front once; off only asks for its texture.
    motif: Motif = Motif::Box, "", Choice { choices: Motif::WORDS };
    Surface /// Draw lines on the far side too.
    hidden_lines: bool = false, "", Switch;
    Surface /// From where the wire is looked at: five sides a little turned each time, or anywhere.
    looks: Looks = Looks::Sides, "", Choice { choices: Looks::WORDS };
    Surface /// How many views each step looks through.
    views_at_once: usize = 1, "views", Integer { min: 1, max: 16 };
    Surface /// How far each look may turn from its side.
    jitter: f64 = 20.0, "degrees", Number { min: 0.0, max: 45.0 };
    Surface /// How suddenly a line vanishes behind the surface.
    visibility: f64 = 60.0, "a world unit", Number { min: 1.0, max: 1000.0 };
    Surface /// How far behind the surface a line is half seen.
    visibility_bias: f64 = 0.05, "world units", Number { min: 0.0, max: 0.5 };
    Surface /// How strongly the wire is held to the surface.
    surface_pull: f64 = 1.0, "times", Number { min: 0.0, max: 1000.0 };

    Expert /// How far the finished curve may move so that control points can go that it does without; 0 keeps them all.
    thin: f64 = 0.0, "px at 256", Number { min: 0.0, max: 8.0 };
    Expert /// How strongly strands push each other away, where the wire is kept smooth.
    clearance: f64 = 1.0, "times", Number { min: 0.0, max: 1000.0 };
    Expert /// How strongly bends that are too tight open, where the wire is kept smooth.
    tightness: f64 = 1.0, "times", Number { min: 0.0, max: 1000.0 };
    Expert /// Step size for positions, in pixels of a 128 px picture.
    position_rate: f64 = 0.6, "px at 128", Number { min: 1e-4, max: 10.0 };
    Expert /// Step size for widths, in pixels of a 128 px picture.
    width_rate: f64 = 0.075, "px at 128", Number { min: 0.0, max: 10.0 };
    Expert /// How pictures are made coarser for the loss.
    pyramid: Pyramid = Pyramid::Average, "", Choice { choices: Pyramid::WORDS };
    Expert /// Weight of each coarser level of the loss relative to the finer one, at the start.
    level_weight: f64 = 0.5, "times", Number { min: 0.0, max: 16.0 };
    Expert /// Share of the iterations at half size, where each costs a quarter.
    coarse_share: f64 = 0.5, "of 1", Number { min: 0.0, max: 1.0 };
    Expert /// Exact points on each span of the wire while fitting.
    samples: usize = 3, "a span", Integer { min: 1, max: 32 };
    Expert /// Where re-initialised control points go.
    new_point: NewPoint = NewPoint::Lacking, "", Choice { choices: NewPoint::WORDS };
    Expert /// Voxels along each side of the grid in which the first wire grows.
    grid: usize = 128, "voxels", Integer { min: 16, max: 160 };
}

impl Preset {
    /// Whether its wire is kept smooth unless one says otherwise.
    pub fn smooth(self) -> OnOff {
        if self == Preset::Paper { OnOff::Off } else { OnOff::On }
    }
}

impl Settings {
    /// The settings of a preset.
    pub fn preset(preset: Preset) -> Settings {
        Settings::drawings(preset, preset.smooth())
    }

    /// The settings of a preset for drawings, with the wire kept smooth or not.
    fn drawings(preset: Preset, smooth: OnOff) -> Settings {
        let best = match smooth {
            OnOff::On => Settings::default(),
            OnOff::Off => Settings {
                smooth,
                start: Start::Tree,
                iterations: 1100,
                spacing: 2.0,
                min_width: 1.0,
                max_width: 20.0,
                position_rate: 0.8,
                width_rate: 0.24,
                coarse_share: 0.55,
                samples: 2,
                ..Settings::default()
            },
        };
        match (preset, smooth) {
            (Preset::Best, _) => best,
            (Preset::Fast, OnOff::On) => Settings { preset, iterations: 200, coarse_share: 0.8, grid: 64, ..best },
            (Preset::Fast, OnOff::Off) => {
                Settings { preset, iterations: 220, coarse_share: 0.8, grid: 64, spacing: 3.5, ..best }
            }
            (Preset::Paper, _) => Settings {
                preset,
                smooth,
                iterations: 900,
                control_points: 220,
                arrange: OnOff::Off,
                min_stroke: 0.0,
                min_width: 0.0,
                max_width: 5.0,
                start: Start::Ball,
                bend: Bend::None,
                reinit: true,
                refine: true,
                samples: 8,
                pyramid: Pyramid::Gaussian,
                level_weight: 1.0,
                position_rate: 0.25,
                width_rate: 0.03,
                coarse_share: 0.0,
                new_point: NewPoint::Random,
                ..Settings::drawings(Preset::Best, OnOff::Off)
            },
        }
    }

    /// What one picture and one mesh share: there is nothing to agree with.
    fn one_thing(preset: Preset, smooth: OnOff) -> Settings {
        Settings { smooth, bend: Bend::None, arrange: OnOff::Off, ..Settings::drawings(preset, OnOff::Off) }
    }

    /// The settings of a preset for one picture.
    pub fn stroke_preset(preset: Preset) -> Settings {
        Settings::picture(preset, preset.smooth())
    }

    fn picture(preset: Preset, smooth: OnOff) -> Settings {
        let several = Settings { start: Start::Contour, ..Settings::one_thing(preset, smooth) };
        // The first wire lies along the lines already: small steps keep it there, but for the ends of lines that must open.
        let (iterations, position_rate) = if smooth == OnOff::On { (400, 0.5) } else { (320, 0.2) };
        let best = Settings {
            iterations,
            spacing: 4.0,
            position_rate,
            width_rate: 0.08,
            coarse_share: 0.3,
            ..several.clone()
        };
        match preset {
            Preset::Best => best,
            Preset::Fast => Settings { iterations: 120, spacing: 6.0, hatch: 16.0, side_views: 4, ..best },
            // Refined once, 120 control points become 220.
            Preset::Paper => Settings { control_points: 120, start: Start::Hull, shading: Shading::Grey, ..several },
        }
    }

    /// The settings of a preset for covering a mesh.
    pub fn fill_preset(preset: Preset) -> Settings {
        Settings::mesh(preset, preset.smooth())
    }

    fn mesh(preset: Preset, smooth: OnOff) -> Settings {
        let several = Settings { start: Start::Stripes, ..Settings::one_thing(preset, smooth) };
        // Lines lie evenly on the surface already; they are to be bent a little and made thicker and thinner.
        let best = Settings {
            iterations: 300,
            min_width: 0.6,
            max_width: 7.0,
            position_rate: 0.2,
            width_rate: 0.1,
            smoothness: if smooth == OnOff::On { 1.0 } else { 6.0 },
            coarse_share: 0.0,
            level_weight: 1.0,
            ..several.clone()
        };
        match preset {
            Preset::Best => best,
            Preset::Fast => Settings { iterations: 100, size: 192, ..best },
            Preset::Paper => Settings {
                iterations: 251,
                control_points: 1100,
                density: 0.6,
                min_width: 0.0,
                max_width: 8.7,
                motif: Motif::Off,
                flow: Flow::Smooth,
                position_rate: 0.25,
                reinit: false,
                refine: false,
                ..several
            },
        }
    }

    /// The preset asked for (`preset` among the pairs, else `best`) with every other pair laid over it in order.
    ///
    /// # Errors
    /// As [`Settings::set`] and [`Settings::check`].
    pub fn from_pairs<'a>(pairs: impl IntoIterator<Item = (&'a str, &'a str)> + Clone) -> Result<Settings> {
        let settings = Settings::from_pairs_over(Settings::drawings, pairs)?;
        settings.check()?;
        Ok(settings)
    }

    /// [`Settings::from_pairs`] with a task's own presets, not yet checked. Whether the wire is kept smooth chooses among them, too.
    fn from_pairs_over<'a>(
        presets: fn(Preset, OnOff) -> Settings,
        pairs: impl IntoIterator<Item = (&'a str, &'a str)> + Clone,
    ) -> Result<Settings> {
        let mut settings = presets(Preset::Best, OnOff::On);
        let (mut preset, mut smooth) = (Preset::Best, None);
        for (name, text) in pairs.clone() {
            match &*name.replace('-', "_") {
                "preset" => {
                    settings.set(name, text)?;
                    preset = settings.preset;
                }
                "smooth" => {
                    settings.set(name, text)?;
                    smooth = Some(settings.smooth);
                }
                _ => {}
            }
        }
        settings = presets(preset, smooth.unwrap_or(preset.smooth()));
        for (name, text) in pairs {
            settings.set(name, text)?;
        }
        Ok(settings)
    }

    /// Sets one value from text. Dashes and underscores are the same.
    ///
    /// # Errors
    /// [`Error::Setting`] when the name is unknown, or the value is not of its kind or out of range.
    pub fn set(&mut self, name: &str, text: &str) -> Result<()> {
        let key = name.replace('-', "_");
        let Some(row) = TABLE.iter().find(|row| row.name == key) else {
            let nearest = nearest_name(&key);
            return Err(Error::setting(name, "there is no such setting", format!("did you mean {nearest}?")));
        };
        let value = row.kind.parse(text).ok_or_else(|| row.impossible(name, text))?;
        let mut all = serde_json::to_value(&*self).map_err(|_| row.impossible(name, text))?;
        all[row.name] = value;
        *self = serde_json::from_value(all).map_err(|_| row.impossible(name, text))?;
        Ok(())
    }

    /// Checks every range, and what single ranges cannot say.
    ///
    /// # Errors
    /// [`Error::Setting`] for a value out of its range, and when settings contradict each other.
    pub fn check(&self) -> Result<()> {
        let texts = self.to_texts();
        for row in TABLE {
            let text = texts.get(row.name).map_or("", String::as_str);
            row.kind.parse(text).ok_or_else(|| row.impossible(row.name, text))?;
        }
        if self.min_width > self.max_width {
            return Err(Error::setting(
                "min_width",
                format!("{} is more than max_width {}", self.min_width, self.max_width),
                "lower it or raise max_width",
            ));
        }
        if (1..4).contains(&self.control_points) {
            return Err(Error::setting(
                "control_points",
                format!("a wire needs at least 4, not {}", self.control_points),
                "give 4 to 20000, or 0 to let the start choose",
            ));
        }
        Ok(())
    }

    /// For a wire of constant width: of least and greatest width one given stands for both.
    fn one_width(&mut self, given: &[&str]) -> Result<()> {
        let is_given = |name: &str| given.iter().any(|given| given.replace('-', "_") == name);
        match (is_given("min_width"), is_given("max_width")) {
            (true, true) if self.min_width != self.max_width => {
                let problem = format!("constant, but from {} to {}", self.min_width, self.max_width);
                Err(Error::setting("width", problem, "give one of min_width and max_width, both the same, or neither"))
            }
            (true, false) => {
                self.max_width = self.min_width;
                Ok(())
            }
            (false, true) => {
                self.min_width = self.max_width;
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Every value by name, for files and reports.
    pub fn to_map(&self) -> serde_json::Map<String, Value> {
        match serde_json::to_value(self) {
            Ok(Value::Object(map)) => map,
            _ => serde_json::Map::new(),
        }
    }

    /// Every value by name as the text that [`Settings::set`] takes.
    pub fn to_texts(&self) -> BTreeMap<String, String> {
        let text = |value: Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        let mut texts = BTreeMap::new();
        texts.extend(self.to_map().into_iter().map(|(name, value)| (name, text(value))));
        texts
    }
}

impl Kind {
    /// Whether there is more than one value to choose from: what leaves no choice is not shown to people.
    pub fn leaves_choice(&self) -> bool {
        !matches!(self, Choice { choices: [_] })
    }

    fn parse(&self, text: &str) -> Option<Value> {
        match *self {
            Kind::Integer { min, max } => {
                text.trim().parse::<u64>().ok().filter(|n| (min..=max).contains(n)).map(Value::from)
            }
            Kind::Number { min, max } => {
                text.trim().parse::<f64>().ok().filter(|x| (min..=max).contains(x)).map(Value::from)
            }
            Kind::Choice { choices } => choices.contains(&text.trim()).then(|| Value::from(text.trim())),
            Kind::Switch => match text.trim() {
                "on" | "true" | "yes" | "1" => Some(Value::from(true)),
                "off" | "false" | "no" | "0" => Some(Value::from(false)),
                _ => None,
            },
        }
    }

    /// The possible values in words.
    pub fn words(&self) -> String {
        match *self {
            Kind::Integer { min, max } => format!("a whole number from {min} to {max}"),
            Kind::Number { min, max } => format!("a number from {min} to {max}"),
            Kind::Choice { choices } => choices.join(", "),
            Kind::Switch => "on or off".to_owned(),
        }
    }
}

/// The setting whose name shares the most letter pairs with `name`.
fn nearest_name(name: &str) -> &'static str {
    let pairs = |s: &str| s.as_bytes().windows(2).map(<[u8]>::to_vec).collect::<Vec<_>>();
    let given = pairs(name);
    TABLE
        .iter()
        .max_by_key(|row| {
            let shared = pairs(row.name).iter().filter(|pair| given.contains(pair)).count();
            (shared * 100).checked_div(row.name.len() + name.len()).unwrap_or(0)
        })
        .map_or("preset", |row| row.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn table_and_struct_name_the_same_settings_and_defaults_are_in_range() {
        for &preset in Preset::ALL {
            let texts = Settings::preset(preset).to_texts();
            assert_eq!(texts.len(), TABLE.len());
            let pairs = texts.iter().map(|(name, text)| (name.as_str(), text.as_str()));
            assert_eq!(Settings::from_pairs(pairs), Ok(Settings::preset(preset)), "texts say it all");
            for row in TABLE {
                let text = &texts[row.name];
                assert!(row.kind.parse(text).is_some(), "{}: {text} is outside {}", row.name, row.kind.words());
                assert!(!row.help.is_empty() && row.help.ends_with('.'), "{} needs a line of help", row.name);
            }
        }
    }

    #[test]
    fn pairs_lie_over_the_preset_whatever_their_order() {
        let settings = Settings::from_pairs([("iterations", "7"), ("preset", "paper"), ("min-width", "0.5")]).unwrap();
        assert_eq!((settings.iterations, settings.start, settings.min_width), (7, Start::Ball, 0.5));
    }

    #[test]
    fn nonsense_is_refused_with_the_name_and_a_remedy() {
        for (name, text) in [
            ("itterations", "5"),
            ("iterations", "-1"),
            ("iterations", "NaN"),
            ("min-width", "inf"),
            ("bend", "lots"),
            ("control-points", "3"),
            ("control-points", "20001"),
            ("reinit", "perhaps"),
        ] {
            let error = Settings::from_pairs([(name, text)]).unwrap_err();
            assert!(matches!(error, Error::Setting { .. }), "{name}={text} gave {error:?}");
        }
        let error = Settings::from_pairs([("itterations", "5")]).unwrap_err().to_string();
        assert!(error.contains("did you mean iterations?"), "{error}");
        assert!(Settings::from_pairs([("min-width", "9"), ("max-width", "2")]).is_err());
    }

    #[test]
    fn what_was_set_by_hand_is_held_to_the_same_ranges() {
        assert_eq!(Settings::default().check(), Ok(()));
        for (name, settings) in [
            ("size", Settings { size: 0, ..Settings::default() }),
            ("smoothness", Settings { smoothness: f64::NAN, ..Settings::default() }),
            ("smoothness", Settings { smoothness: -1.0, ..Settings::default() }),
            ("max_width", Settings { max_width: f64::INFINITY, ..Settings::default() }),
        ] {
            let line = settings.check().unwrap_err().to_string();
            assert!(line.starts_with(name) && line.contains("give a"), "{line}");
        }
    }
}
