// Which polygons may touch a square cell. Twin of src/raster/cells.rs; lists instead of a counting sort, as the order
// within a cell changes nothing.
//
// `cells` holds: how many entries were wanted; how many large polygons each view has; for each cell its first entry
// plus one, or 0; each view's large polygons; the entries, two numbers each: the polygon's place in the total order,
// and the next entry plus one.

const LARGE_COUNTS: u32 = 1u;
const HEADS: u32 = LARGE_COUNTS + MOST_VIEWS;
/// A polygon over more cells than this goes to the list of large ones.
const MOST_CELLS: u32 = 64u;

fn first_large(view: u32) -> u32 {
    return HEADS + scene.cells + view * 2u * scene.samples;
}

/// Where an entry, given plus one, lies.
fn entry_at(entry: u32) -> u32 {
    return first_large(scene.views) + 2u * (entry - 1u);
}

fn box_of(view: u32, order: u32) -> vec4f {
    let s = view * scene.samples + order / 2u;
    if order % 2u == 0u {
        return shapes[s].polygon_box;
    }
    return shapes[s].quad_box;
}

/// Boxes are [x_min, y_min, -x_max, -y_max].
fn boxes_touch(a: vec4f, b: vec4f) -> bool {
    return all(a.xy <= -b.zw) && all(b.xy <= -a.zw);
}

fn is_long(bounds: vec4f) -> bool {
    return max(-bounds.z - bounds.x, -bounds.w - bounds.y) > 2.0 * PART_PX;
}

/// The cells a box touches: first and last column, first and last row. What sticks out counts to the border.
fn cells_of(view: u32, bounds: vec4f) -> vec4u {
    let last = vec2f(f32(scene.view[view].columns - 1u), f32(scene.view[view].rows - 1u));
    let low = clamp(floor(bounds.xy / CELL_PX), vec2f(), last);
    let high = clamp(floor(-bounds.zw / CELL_PX), vec2f(), last);
    return vec4u(u32(low.x), u32(high.x), u32(low.y), u32(high.y));
}
