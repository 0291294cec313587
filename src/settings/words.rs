//! The words of settings that are a choice.

use crate::picture::Polarity;
use crate::start;
use crate::wire::Form;
use serde::{Deserialize, Serialize};

macro_rules! choices {
    ($($(#[$doc:meta])* $name:ident { $($(#[$variant_doc:meta])* $variant:ident = $word:literal),* $(,)? })*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
        #[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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
    /// What of a picture is drawn.
    Read {
        /// Whatever suits it: the lines of a photograph; of anything else what it was made for.
        Auto = "auto",
        /// Its ink: it is a drawing.
        Ink = "ink",
        /// The lines that a draughtsman would draw: it is a photograph.
        Lines = "lines",
        /// Its shades, as the widths of lines that fill the object.
        Tone = "tone",
    }
    /// How much of a photograph's tone its lines show.
    Shade {
        /// None: lines of one width.
        None = "none",
        /// Lines are wider where the picture is strong.
        Accent = "accent",
        /// All: the object is filled with lines.
        Full = "full",
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

pub(super) const FORMS: &[&str] = &["wire", "chain", "bag"];

/// A wire's form as a word.
pub(super) mod form_word {
    use super::Form;
    use serde::{Deserialize, Deserializer, Serializer, de::Error as _};
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

impl Preset {
    /// Whether its wire is kept smooth unless one says otherwise.
    pub fn smooth(self) -> OnOff {
        if self == Preset::Paper { OnOff::Off } else { OnOff::On }
    }
}
