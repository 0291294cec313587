// Filling the lists. Entries are taken from a common pool, a workgroup's at once: all views count up the same number.

const NO_CELLS: vec4u = vec4u(1u, 0u, 1u, 0u);

var<workgroup> wanted: atomic<u32>;
var<workgroup> first_entry: u32;

fn cell_count(range: vec4u) -> u32 {
    return (range.y - range.x + 1u) * (range.w - range.z + 1u);
}

fn add_large(view: u32, order: u32) {
    let at = atomicAdd(&cells[LARGE_COUNTS + view], 1u);
    atomicStore(&cells[first_large(view) + at], order);
}

fn add_to_cells(view: u32, order: u32, range: vec4u, before: u32) {
    var entry = before;
    for (var y = range.z; y <= range.w; y++) {
        for (var x = range.x; x <= range.y; x++) {
            entry++;
            // The processor sees how many were wanted, makes room and starts again.
            if entry <= scene.entries {
                atomicStore(&cells[entry_at(entry)], order);
                atomicStore(&cells[entry_at(entry) + 1u], atomicExchange(&cells[head_at(view, x, y)], entry));
            }
        }
    }
}

/// Enters a long piece as the boxes of short stretches of it, as far as they touch the picture.
fn add_in_parts(view: u32, order: u32, bounds: vec4f) {
    let a = vertex_of(view, order / 2u);
    let b = vertex_of(view, joints[view * scene.samples + order / 2u].next);
    let picture = picture_of(view);
    // Mitres reach past the discs by less than 4%.
    let widest = max(a.z, b.z) * 1.05 + 0.01;
    var first = 0.0;
    var last = 1.0;
    for (var c = 0u; c < 2u; c++) {
        let along = b[c] - a[c];
        if along != 0.0 {
            let t = (-widest - a[c]) / along;
            let u = (-picture[c + 2u] + widest - a[c]) / along;
            first = max(first, min(t, u));
            last = min(last, max(t, u));
        }
    }
    if first >= last {
        return;
    }
    let parts = max(ceil(distance(a.xy, b.xy) * (last - first) / PART_PX), 1.0);
    for (var i = 0.0; i < parts; i += 1.0) {
        let begin = mix(a, b, first + (last - first) * i / parts);
        let to = mix(a, b, first + (last - first) * (i + 1.0) / parts);
        var part = min(disc_box(begin.xy, begin.z * 1.05 + 0.01), disc_box(to.xy, to.z * 1.05 + 0.01));
        part = max(part, bounds);
        if boxes_touch(part, picture) {
            let range = cells_of(view, part);
            if cell_count(range) > MOST_CELLS {
                add_large(view, order);
                return;
            }
            add_to_cells(view, order, range, atomicAdd(&cells[0], cell_count(range)));
        }
    }
}

/// Enters what is large or long; of the rest gives the cells to enter it in.
fn cells_left(view: u32, order: u32) -> vec4u {
    if order >= 2u * scene.samples || !is_shown(view, order) {
        return NO_CELLS;
    }
    if order % 2u == 0u {
        let at = atomicAdd(&cells[SHOWN_COUNTS + view], 1u);
        atomicStore(&cells[first_shown(view) + at], order / 2u);
    }
    let bounds = box_of(view, order);
    if is_long(bounds) && order % 2u == 1u {
        add_in_parts(view, order, bounds);
        return NO_CELLS;
    }
    let range = cells_of(view, bounds);
    if cell_count(range) > MOST_CELLS {
        add_large(view, order);
        return NO_CELLS;
    }
    return range;
}

/// One thread a polygon and view.
@compute @workgroup_size(64)
fn fill_cells(@builtin(global_invocation_id) id: vec3u, @builtin(local_invocation_index) local: u32) {
    let range = cells_left(id.y, id.x);
    let before = atomicAdd(&wanted, cell_count(range));
    workgroupBarrier();
    if local == 0u {
        first_entry = atomicAdd(&cells[0], atomicLoad(&wanted));
    }
    add_to_cells(id.y, id.x, range, workgroupUniformLoad(&first_entry) + before);
}
