// What all stages share: structures and buffers. Structures are checked against src/gpu/layout.rs, buffers against the
// table of stages in src/gpu/stage.rs. A buffer has the same binding everywhere.
//
// Spaces: samples and points in world units [x, y, z, width]; vertices in pixels [x, y, radius], y down, centres at +.5.
// Arrays over views are view by view.

const NONE: u32 = 0xffffffffu;
const MOST_VIEWS: u32 = 64u;
const MOST_LEVELS: u32 = 16u;
const RINGS: u32 = 35u;

/// One unit of coverage in the integer sums: 2^20 steps, shifted by one bit to leave room for `TOUCHED`.
const UNIT: i32 = 2097152;
/// Bit 0 of a pixel's sum: some outline runs through it. All addends are even.
const TOUCHED: i32 = 1;

/// The numbers of one iteration.
struct Step {
    rates: vec4f,
    width_bounds: vec2f,
    level_ratio: f32,
    jerk_position: f32,
    jerk_width: f32,
    length: f32,
    beta1: f32,
    beta2: f32,
    correction1: f32,
    correction2: f32,
    epsilon: f32,
    /// 1 where a position's components share their second moment.
    per_point: u32,
    /// Which row of terms this iteration writes.
    row: u32,
    /// Factor that makes image losses comparable over the run.
    loss_scale: f32,
    /// This iteration's share in the running means of gradients.
    gradient_share: f32,
    surface: f32,
    texture: f32,
    /// What bending costs, then clearance; the weights are 0 where a term is off.
    bending: f32,
    cusp_radius: f32,
    tightness: f32,
    least_radius: f32,
    least_diameters: f32,
    evenness: f32,
    even_speed: f32,
    /// Below it curvature is taken for less than it is.
    standstill: f32,
    clearance: f32,
    clearance_diameters: f32,
    least_clearance: f32,
    mean_speed: f32,
    /// 1 where the last points are the best ones.
    keeps_last: u32,
}

struct View {
    /// Affine rows from world to camera axes.
    right: vec4f,
    down: vec4f,
    forward: vec4f,
    centre_px: vec2f,
    /// Pixels per world unit, or focal length in pixels.
    scale: f32,
    perspective: u32,
    width: u32,
    height: u32,
    /// Where its pixels begin among those of all views, and its rows.
    first_pixel: u32,
    first_row: u32,
    /// Where its cells begin.
    first_cell: u32,
    columns: u32,
    rows: u32,
    levels: u32,
    weight: f32,
    /// Its loss among the partial sums, and that it is one.
    first_partial: u32,
    partials: u32,
    /// Levels made a pass each. A single workgroup makes the coarser ones.
    fine_levels: u32,
    /// How sharply and how far behind the surface strands vanish; 0 where nothing hides any.
    steepness: f32,
    bias_world: f32,
}

struct Scene {
    points: u32,
    samples: u32,
    views: u32,
    spans: u32,
    /// Pixels and cells of all views.
    pixels: u32,
    cells: u32,
    /// How many cell entries there is room for.
    entries: u32,
    /// 1 where the pyramid is Gaussian.
    gaussian: u32,
    /// Where the pull to the surface lies among the partial sums, and how many planes there are: one a sample, or none.
    surface_partial: u32,
    planes: u32,
    /// Where the texture's losses lie among the partial sums, and how many levels of it each view has.
    texture_partial: u32,
    texture_levels: u32,
    /// Where the nodes' losses lie among the partial sums, four a workgroup, and how many nodes there are.
    node_partial: u32,
    nodes: u32,
    /// Regular polygons: first normal, sides, circumscribed over inscribed radius, tangent of half a side's angle.
    rings: array<vec4f, 35>,
    view: array<View, 64>,
}

/// Which level a pass of the pyramid makes.
struct Pass {
    level: u32,
}

/// A row of a banded map.
struct Row {
    first: u32,
    weights: array<f32, 4>,
}

/// A row of the transposed map is a list of these.
struct Term {
    row: u32,
    weight: f32,
}

/// One level of one view's pyramid.
struct Level {
    offset: u32,
    width: u32,
    height: u32,
    first_partial: u32,
}

/// One level of one view's texture: where in `texture` what of it begins. Without a size there is none.
struct TextureLevel {
    width: u32,
    height: u32,
    /// How many times the view is halved before it.
    halvings: u32,
    /// Its share in the loss.
    share: f32,
    picture: u32,
    /// Features, at half its size, and the gradient to them.
    maps: u32,
    d_maps: u32,
    /// Derivatives, then the gradient to them.
    jets: u32,
    d_picture: u32,
    numbers: u32,
    /// Where in `texture_given` its weights and statistics begin.
    weights: u32,
    wanted: u32,
    /// One over the weights' sum, 0 where nothing counts, and over the sum of their products at each shift.
    inverse_weight: f32,
    inverse_pairs: array<f32, 5>,
}

/// A place where integrals along the curve are taken: how it and the curve's derivatives there come from four control
/// points, and how much of the parameter it stands for.
struct Node {
    place: vec4f,
    first_derivative: vec4f,
    second_derivative: vec4f,
    first: u32,
    step: f32,
}

/// How a node's two pieces meet. Index 0 is the side with the axis turned from x to y, index 1 the other.
struct Joint {
    before: array<vec2f, 2>,
    after: array<vec2f, 2>,
    extension: vec2f,
    kind: u32,
    /// Bit i: the two pieces meet in one point on side i.
    shared_sides: u32,
    /// The nodes joined to this one, or NONE.
    previous: u32,
    next: u32,
}

/// A node's quad (two sides, then the two end lines) and the regular polygon round it.
struct Shape {
    normal_x: vec4f,
    normal_y: vec4f,
    offset: vec4f,
    /// Boxes as [x_min, y_min, -x_max, -y_max].
    quad_box: vec4f,
    polygon_box: vec4f,
    origin: vec2f,
    /// 1 where the first and last end line are drawn.
    drawn: vec2f,
    radius: f32,
    /// Place in `rings`, or NONE.
    ring: u32,
    has_sides: u32,
    padding: u32,
}

@group(0) @binding(0) var<uniform> now: Step;
@group(0) @binding(1) var<uniform> scene: Scene;
@group(0) @binding(2) var<uniform> pyramid_pass: Pass;

@group(0) @binding(3) var<storage, read> sampling_rows: array<Row>;
@group(0) @binding(4) var<storage, read> sampling_starts: array<u32>;
@group(0) @binding(5) var<storage, read> sampling_terms: array<Term>;
/// Previous and next sample along the stroke, or NONE; both itself where a sample is in no stroke.
@group(0) @binding(6) var<storage, read> links: array<vec2u>;
@group(0) @binding(7) var<storage, read> jerk_rows: array<Row>;
@group(0) @binding(8) var<storage, read> jerk_starts: array<u32>;
@group(0) @binding(9) var<storage, read> jerk_terms: array<Term>;
@group(0) @binding(10) var<storage, read> levels: array<Level>;
/// Unit normals of the regular polygons.
@group(0) @binding(11) var<storage, read> circles: array<vec2f>;
@group(0) @binding(12) var<storage, read> target_ink: array<f32>;
/// Depth of what hides strands in each pixel, views as in `target_ink`.
@group(0) @binding(13) var<storage, read> occluder_depth: array<f32>;
/// Unit normal and offset of the plane that each sample is pulled to.
@group(0) @binding(14) var<storage, read> planes: array<vec4f>;
@group(0) @binding(15) var<storage, read> texture_levels: array<TextureLevel>;
/// Filters, wanted statistics and weights of the texture; see texture.wgsl.
@group(0) @binding(16) var<storage, read> texture_given: array<f32>;
@group(0) @binding(17) var<storage, read> nodes: array<Node>;
/// Which nodes each control point has a part in: where their lists begin and the last one ends, then the lists.
@group(0) @binding(18) var<storage, read> point_nodes: array<u32>;
/// Which nodes may come too near each node, likewise.
@group(0) @binding(19) var<storage, read> neighbours: array<u32>;

/// Control points, then their first moments, then their second.
@group(0) @binding(20) var<storage, read_write> state: array<vec4f>;
/// The lowest image loss so far and 1 where this iteration has it; then the points that have it.
@group(0) @binding(21) var<storage, read_write> best: array<vec4f>;
/// Running means of the length of the image gradient to each point's position.
@group(0) @binding(22) var<storage, read_write> gradient_norms: array<f32>;
@group(0) @binding(23) var<storage, read_write> samples: array<vec4f>;
/// x, y and radius in pixels, and 1 where it is drawn.
@group(0) @binding(24) var<storage, read_write> vertices: array<vec4f>;
@group(0) @binding(25) var<storage, read_write> joints: array<Joint>;
@group(0) @binding(26) var<storage, read_write> shapes: array<Shape>;
/// See cells.wgsl.
@group(0) @binding(27) var<storage, read_write> cells: array<atomic<u32>>;
/// The same to those that come after and only read: atomic reads would pass caches by.
@group(0) @binding(27) var<storage, read_write> filled: array<u32>;
/// Area sums of all pixels, then what is visible of the left border, row by row.
@group(0) @binding(28) var<storage, read_write> sums: array<atomic<i32>>;
/// The same once they are complete.
@group(0) @binding(28) var<storage, read_write> summed: array<i32>;
@group(0) @binding(29) var<storage, read_write> coverage: array<f32>;
/// Level 0 of all views, then the coarser ones: first the difference, then the gradient.
@group(0) @binding(30) var<storage, read_write> pyramid: array<f32>;
@group(0) @binding(31) var<storage, read_write> partials: array<f32>;
/// Three entries a node: adjoint of its piece's start and end disc by the straight edges, and of itself by its polygon.
@group(0) @binding(32) var<storage, read_write> d_pieces: array<vec4f>;
@group(0) @binding(33) var<storage, read_write> d_vertices: array<vec4f>;
@group(0) @binding(34) var<storage, read_write> d_samples: array<vec4f>;
@group(0) @binding(35) var<storage, read_write> d_points_image: array<vec4f>;
@group(0) @binding(36) var<storage, read_write> d_points: array<vec4f>;
/// A row an iteration: total, views, jerk, length, surface, texture, bending, tightness, evenness, clearance, and how many
/// cell entries were wanted.
@group(0) @binding(37) var<storage, read_write> terms: array<f32>;
/// Four entries a node: the visible interval of each straight edge, from and to 0 if there is none, from 1 to 0 if there
/// are several.
@group(0) @binding(38) var<storage, read_write> visible: array<vec2f>;
/// What the texture's stages keep, level by level.
@group(0) @binding(39) var<storage, read_write> texture: array<f32>;
/// Adjoints of each node's place, first and second derivative.
@group(0) @binding(40) var<storage, read_write> d_nodes: array<vec4f>;
