// Which polygons may touch a square cell. Twin of src/core/raster/cells.rs; lists instead of a counting sort, as the order
// within a cell changes nothing.
//
// `cells` holds: how many entries were wanted; how many large polygons each view has; how many polygons round nodes it
// shows; for each cell its first entry plus one, or 0; each view's large polygons; the nodes whose polygons it shows;
// the entries, two numbers each: the polygon's place in the total order, and the next entry plus one.

const LARGE_COUNTS: u32 = 1u;
const SHOWN_COUNTS: u32 = LARGE_COUNTS + MOST_VIEWS;
const HEADS: u32 = SHOWN_COUNTS + MOST_VIEWS;
/// A polygon over more cells than this goes to the list of large ones.
const MOST_CELLS: u32 = 64u;

fn first_large(view: u32) -> u32 {
    return HEADS + scene.cells + view * 2u * scene.samples;
}

fn first_shown(view: u32) -> u32 {
    return first_large(scene.views) + view * scene.samples;
}

/// Where an entry, given plus one, lies.
fn entry_at(entry: u32) -> u32 {
    return first_shown(scene.views) + 2u * (entry - 1u);
}

/// The first entry of a cell, plus one.
fn head_at(view: u32, column: u32, row: u32) -> u32 {
    return HEADS + scene.view[view].first_cell + row * scene.view[view].columns + column;
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

/// Empties all lists; every thread of a stage has its share.
fn empty_cells(thread: u32, threads: u32) {
    for (var i = thread; i < HEADS + scene.cells; i += threads) {
        atomicStore(&cells[i], 0u);
    }
}

/// The cells a box touches: first and last column, first and last row. What sticks out counts to the border.
fn cells_of(view: u32, bounds: vec4f) -> vec4u {
    let last = vec2f(f32(scene.view[view].columns - 1u), f32(scene.view[view].rows - 1u));
    let low = clamp(floor(bounds.xy / CELL_PX), vec2f(), last);
    let high = clamp(floor(-bounds.zw / CELL_PX), vec2f(), last);
    return vec4u(u32(low.x), u32(high.x), u32(low.y), u32(high.y));
}

fn picture_of(view: u32) -> vec4f {
    return vec4f(0.0, 0.0, -f32(scene.view[view].width), -f32(scene.view[view].height));
}

fn is_shown(view: u32, order: u32) -> bool {
    return boxes_touch(box_of(view, order), picture_of(view));
}
