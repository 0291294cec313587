//! The stages of an iteration in order: their shaders, which buffers they use, and over what they spread.

use crate::objective::packed_texture::{BUNDLES, FEATURES};
use crate::optimize::{Term, term_count};

macro_rules! slots {
    ($($name:ident,)*) => {
        /// A buffer, by its binding in every shader; see `shaders/layout.wgsl` for what is in it.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        #[repr(u32)]
        #[allow(missing_docs, reason = "shaders/layout.wgsl describes each")]
        pub enum Slot {
            $($name,)*
        }

        /// All of them, by binding.
        pub(super) const SLOTS: &[Slot] = &[$(Slot::$name,)*];
    };
}
slots! {
    Step,
    Scene,
    Pass,
    SamplingRows,
    SamplingStarts,
    SamplingTerms,
    Links,
    JerkRows,
    JerkStarts,
    JerkTerms,
    Levels,
    Circles,
    TargetInk,
    OccluderDepth,
    Planes,
    TextureLevels,
    TextureGiven,
    Nodes,
    PointNodes,
    Neighbours,
    State,
    Best,
    GradientNorms,
    Samples,
    Vertices,
    Joints,
    Shapes,
    Cells,
    Sums,
    Coverage,
    Pyramid,
    Partials,
    DPieces,
    DVertices,
    DSamples,
    DPointsImage,
    DPoints,
    Terms,
    Visible,
    Texture,
    DNodes,
}

/// What a buffer is to a shader.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Access {
    /// A uniform of which each dispatch sees one of several.
    UniformOfMany,
    Uniform,
    Read,
    ReadWrite,
}

impl Slot {
    pub(super) fn access(self) -> Access {
        match self {
            Slot::Step | Slot::Pass => Access::UniformOfMany,
            Slot::Scene => Access::Uniform,
            slot if (slot as u32) < Slot::State as u32 => Access::Read,
            _ => Access::ReadWrite,
        }
    }
}

/// What a stage spreads over, hence how many workgroups it takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Over {
    /// Threads over control points.
    Points,
    /// A workgroup a control point.
    EachPoint,
    /// Threads over samples.
    Samples,
    /// Threads over the curve's nodes, 256 a workgroup.
    Nodes,
    /// Threads over control points where there are nodes, else none.
    PointsOfNodes,
    /// So many threads a sample and view.
    SamplesAndViews(u32),
    /// Workgroups over straight edges, polygons and, if so, the border, and views.
    Outline { border: bool },
    /// Threads over the pixels of a fine level and views: a pass a level, the finest first or last.
    Levels { finest_first: bool },
    /// A workgroup a view.
    Views,
    /// A workgroup a row of pixels and view.
    Rows,
    /// A single workgroup.
    Once,
    /// A single workgroup where there are planes, else none.
    Planes,
    /// Threads over a texture level's pixels, and levels.
    TexturePixels,
    /// Threads over its features' pixels, a quarter as many, and levels.
    TextureFeatures,
    /// So many workgroups, and levels.
    TextureGroups(usize),
    /// Threads over the pixels of views that have a texture, and views.
    TextureViews,
}

/// Nodes whose straight edges a workgroup traces, as in `shaders/outline.wgsl`.
pub(super) const NODES: usize = 16;

/// Workgroups that trace one view's outline: a thread a straight edge, then those that share the polygons, then a thread
/// for each eight of `rows` along the border.
pub(super) fn outline_groups(samples: usize, rows: usize) -> usize {
    samples.div_ceil(NODES) + samples.div_ceil(8) + rows.div_ceil(8 * 64)
}

/// One compute shader.
#[derive(Debug, Clone, Copy)]
pub struct Stage {
    /// Its entry point.
    pub name: &'static str,
    /// Its text, without the constants of [`Stage::source`].
    pub(super) texts: &'static [&'static str],
    /// The buffers it uses.
    pub slots: &'static [Slot],
    pub(super) over: Over,
}

/// A shader's text as it is shipped: see [`bare`].
macro_rules! text {
    ($name:literal) => {{
        const WHOLE: &[u8] = include_bytes!(concat!("../../shaders/", $name, ".wgsl"));
        const BARE: [u8; bare_length(WHOLE)] = bare(WHOLE);
        match std::str::from_utf8(&BARE) {
            Ok(text) => text,
            Err(_) => panic!("shaders are UTF-8"),
        }
    }};
}

/// How many bytes [`bare`] leaves.
const fn bare_length(whole: &[u8]) -> usize {
    let (mut at, mut length) = (0, 0);
    while at < whole.len() {
        let (from, to, next) = line(whole, at);
        length += if to > from { to - from + 1 } else { 0 };
        at = next;
    }
    length
}

/// A shader's lines without indentation, comments (`//` to the end of the line) and blank ones: visitors would only wait
/// for those.
const fn bare<const LENGTH: usize>(whole: &[u8]) -> [u8; LENGTH] {
    let mut text = [b'\n'; LENGTH];
    let (mut at, mut length) = (0, 0);
    while at < whole.len() {
        let (mut from, to, next) = line(whole, at);
        while from < to {
            text[length] = whole[from];
            (from, length) = (from + 1, length + 1);
            if from == to {
                length += 1;
            }
        }
        at = next;
    }
    text
}

/// Of the line at `at`: where its code starts and ends, and where the next line is.
const fn line(whole: &[u8], at: usize) -> (usize, usize, usize) {
    let mut from = at;
    while from < whole.len() && whole[from] == b' ' {
        from += 1;
    }
    let mut to = from;
    while to < whole.len()
        && whole[to] != b'\n'
        && !(whole[to] == b'/' && to + 1 < whole.len() && whole[to + 1] == b'/')
    {
        to += 1;
    }
    let mut next = to;
    while next < whole.len() && whole[next] != b'\n' {
        next += 1;
    }
    (from, to, next + 1)
}

impl Stage {
    /// The whole shader.
    pub fn source(&self) -> String {
        let terms =
            Term::ALL.map(|term| format!("const TERM_{}: u32 = {}u;\n", term.name().to_ascii_uppercase(), term.at(0)));
        let constants = crate::raster::constants().map(|(name, value)| format!("const {name}: f32 = {value:e};\n"));
        let count = format!("const TERMS: u32 = {}u;\n", term_count(0));
        constants.concat() + &terms.concat() + &count + &self.texts.join("\n")
    }

    /// The stage of that name.
    ///
    /// # Panics
    /// If there is none.
    pub fn index(name: &str) -> usize {
        STAGES.iter().position(|stage| stage.name == name).unwrap_or_else(|| panic!("no stage {name}"))
    }
}

const LAYOUT: &str = text!("layout");
const PIECES: &str = text!("pieces");
const CELLS: &str = text!("cells");
const HIDDEN: &str = text!("hidden");
const OUTLINE: &str = text!("outline");
const WALK: &str = text!("walk");
const VISIBILITY: &str = text!("visibility");
const TEXTURE: &str = text!("texture");
/// Sums of a workgroup of 256.
const SUM: &str = text!("sum");

/// All stages, in the order of an iteration.
pub const STAGES: &[Stage] = &[
    Stage {
        name: "sample",
        texts: &[LAYOUT, text!("length"), text!("surface"), text!("sampling")],
        slots: &[Slot::Scene, Slot::SamplingRows, Slot::State, Slot::Samples],
        over: Over::Samples,
    },
    Stage {
        name: "project",
        texts: &[LAYOUT, VISIBILITY, text!("project")],
        slots: &[Slot::Scene, Slot::Links, Slot::OccluderDepth, Slot::Samples, Slot::Vertices],
        over: Over::SamplesAndViews(1),
    },
    Stage {
        name: "join_pieces",
        texts: &[LAYOUT, PIECES, text!("joints")],
        slots: &[Slot::Scene, Slot::Links, Slot::Vertices, Slot::Joints],
        over: Over::SamplesAndViews(1),
    },
    Stage {
        name: "shape_nodes",
        texts: &[LAYOUT, PIECES, CELLS, text!("shapes")],
        slots: &[Slot::Scene, Slot::Vertices, Slot::Joints, Slot::Shapes, Slot::Cells],
        over: Over::SamplesAndViews(1),
    },
    Stage {
        name: "fill_cells",
        texts: &[LAYOUT, PIECES, CELLS, text!("fill_cells")],
        slots: &[Slot::Scene, Slot::Vertices, Slot::Joints, Slot::Shapes, Slot::Cells],
        over: Over::SamplesAndViews(2),
    },
    Stage {
        name: "trace",
        texts: &[LAYOUT, PIECES, CELLS, HIDDEN, OUTLINE, WALK, text!("trace")],
        slots: &[
            Slot::Scene,
            Slot::Circles,
            Slot::Vertices,
            Slot::Joints,
            Slot::Shapes,
            Slot::Cells,
            Slot::Sums,
            Slot::Visible,
        ],
        over: Over::Outline { border: true },
    },
    Stage {
        name: "finish_rows",
        texts: &[LAYOUT, text!("rows")],
        slots: &[Slot::Scene, Slot::Sums, Slot::Coverage],
        over: Over::Rows,
    },
    Stage {
        name: "compare",
        texts: &[LAYOUT, text!("multiscale_mse")],
        slots: &[
            Slot::Step,
            Slot::Scene,
            Slot::Pass,
            Slot::Levels,
            Slot::TargetInk,
            Slot::Coverage,
            Slot::Pyramid,
            Slot::Partials,
        ],
        over: Over::Levels { finest_first: true },
    },
    Stage {
        name: "compare_coarse",
        texts: &[LAYOUT, text!("multiscale_mse")],
        slots: &[Slot::Step, Slot::Scene, Slot::Levels, Slot::Pyramid, Slot::Partials],
        over: Over::Views,
    },
    Stage {
        name: "compare_vjp",
        texts: &[LAYOUT, text!("multiscale_mse")],
        slots: &[Slot::Step, Slot::Scene, Slot::Pass, Slot::Levels, Slot::Pyramid],
        over: Over::Levels { finest_first: false },
    },
    Stage {
        name: "texture_floors",
        texts: &[LAYOUT, TEXTURE, text!("texture_features")],
        slots: &[Slot::Scene, Slot::TextureLevels, Slot::Coverage, Slot::Texture],
        over: Over::TexturePixels,
    },
    Stage {
        name: "texture_features",
        texts: &[LAYOUT, TEXTURE, text!("texture_features")],
        slots: &[Slot::TextureLevels, Slot::TextureGiven, Slot::Texture],
        over: Over::TextureFeatures,
    },
    Stage {
        name: "texture_means",
        texts: &[LAYOUT, TEXTURE, SUM, text!("texture_statistics")],
        slots: &[Slot::TextureLevels, Slot::TextureGiven, Slot::Texture],
        over: Over::TextureGroups(FEATURES),
    },
    Stage {
        name: "texture_grams",
        texts: &[LAYOUT, TEXTURE, SUM, text!("texture_statistics")],
        slots: &[Slot::TextureLevels, Slot::TextureGiven, Slot::Texture],
        over: Over::TextureGroups(BUNDLES),
    },
    Stage {
        name: "texture_distance",
        texts: &[LAYOUT, TEXTURE, SUM, text!("texture_statistics")],
        slots: &[Slot::Step, Slot::Scene, Slot::TextureLevels, Slot::TextureGiven, Slot::Partials, Slot::Texture],
        over: Over::TextureGroups(1),
    },
    Stage {
        name: "texture_pull",
        texts: &[LAYOUT, TEXTURE, SUM, text!("texture_gradient")],
        slots: &[Slot::TextureLevels, Slot::TextureGiven, Slot::Texture],
        over: Over::TextureFeatures,
    },
    Stage {
        name: "texture_pull_means",
        texts: &[LAYOUT, TEXTURE, SUM, text!("texture_gradient")],
        slots: &[Slot::TextureLevels, Slot::Texture],
        over: Over::TextureGroups(FEATURES),
    },
    Stage {
        name: "texture_jets",
        texts: &[LAYOUT, TEXTURE, SUM, text!("texture_gradient")],
        slots: &[Slot::TextureLevels, Slot::TextureGiven, Slot::Texture],
        over: Over::TexturePixels,
    },
    Stage {
        name: "texture_gather",
        texts: &[LAYOUT, TEXTURE, SUM, text!("texture_gradient")],
        slots: &[Slot::TextureLevels, Slot::TextureGiven, Slot::Texture],
        over: Over::TexturePixels,
    },
    Stage {
        name: "texture_add",
        texts: &[LAYOUT, TEXTURE, SUM, text!("texture_gradient")],
        slots: &[Slot::Scene, Slot::TextureLevels, Slot::TextureGiven, Slot::Pyramid, Slot::Texture],
        over: Over::TextureViews,
    },
    Stage {
        name: "pull_back",
        texts: &[LAYOUT, PIECES, CELLS, HIDDEN, OUTLINE, WALK, text!("pull_back")],
        slots: &[
            Slot::Scene,
            Slot::Circles,
            Slot::Vertices,
            Slot::Joints,
            Slot::Shapes,
            Slot::Cells,
            Slot::Pyramid,
            Slot::DPieces,
            Slot::Visible,
        ],
        over: Over::Outline { border: false },
    },
    Stage {
        name: "gather_pulls",
        texts: &[LAYOUT, CELLS, text!("gather")],
        slots: &[Slot::Scene, Slot::Joints, Slot::Shapes, Slot::DPieces, Slot::DVertices],
        over: Over::SamplesAndViews(1),
    },
    Stage {
        name: "project_vjp",
        texts: &[LAYOUT, VISIBILITY, text!("project")],
        slots: &[Slot::Scene, Slot::OccluderDepth, Slot::Samples, Slot::DVertices, Slot::DSamples],
        over: Over::Samples,
    },
    Stage {
        name: "sample_transpose",
        texts: &[LAYOUT, text!("length"), text!("surface"), text!("sampling")],
        slots: &[
            Slot::Step,
            Slot::Scene,
            Slot::SamplingStarts,
            Slot::SamplingTerms,
            Slot::Links,
            Slot::Planes,
            Slot::Samples,
            Slot::DSamples,
            Slot::DPointsImage,
            Slot::DPoints,
        ],
        over: Over::EachPoint,
    },
    Stage {
        name: "jerk_gradient",
        texts: &[LAYOUT, text!("jerk"), text!("jerk_gradient")],
        slots: &[
            Slot::Step,
            Slot::Scene,
            Slot::JerkRows,
            Slot::JerkStarts,
            Slot::JerkTerms,
            Slot::State,
            Slot::DPoints,
        ],
        over: Over::Points,
    },
    Stage {
        name: "pull_nodes",
        texts: &[LAYOUT, SUM, text!("nodes")],
        slots: &[Slot::Step, Slot::Scene, Slot::Nodes, Slot::Neighbours, Slot::State, Slot::Partials, Slot::DNodes],
        over: Over::Nodes,
    },
    Stage {
        name: "gather_nodes",
        texts: &[LAYOUT, text!("gather_nodes")],
        slots: &[Slot::Scene, Slot::Nodes, Slot::PointNodes, Slot::DPoints, Slot::DNodes],
        over: Over::PointsOfNodes,
    },
    Stage {
        name: "measure_surface",
        texts: &[LAYOUT, text!("surface"), SUM, text!("measure_surface")],
        slots: &[Slot::Step, Slot::Scene, Slot::Planes, Slot::Samples, Slot::Partials],
        over: Over::Planes,
    },
    Stage {
        name: "add_terms",
        texts: &[LAYOUT, text!("length"), text!("jerk"), SUM, text!("terms")],
        slots: &[
            Slot::Step,
            Slot::Scene,
            Slot::Links,
            Slot::JerkRows,
            Slot::State,
            Slot::Best,
            Slot::Samples,
            Slot::Cells,
            Slot::Partials,
            Slot::Terms,
        ],
        over: Over::Once,
    },
    Stage {
        name: "adam",
        texts: &[LAYOUT, text!("adam")],
        slots: &[
            Slot::Step,
            Slot::Scene,
            Slot::State,
            Slot::Best,
            Slot::GradientNorms,
            Slot::DPointsImage,
            Slot::DPoints,
        ],
        over: Over::Points,
    },
];
