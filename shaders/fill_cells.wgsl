fn picture_of(view: u32) -> vec4f {
    return vec4f(0.0, 0.0, -f32(scene.view[view].width), -f32(scene.view[view].height));
}

fn cell_count(range: vec4u) -> u32 {
    return (range.y - range.x + 1u) * (range.w - range.z + 1u);
}

fn add_large(view: u32, order: u32) {
    let at = atomicAdd(&cells[LARGE_COUNTS + view], 1u);
    atomicStore(&cells[first_large(view) + at], order);
}

fn add_to_cells(view: u32, order: u32, range: vec4u) {
    for (var y = range.z; y <= range.w; y++) {
        for (var x = range.x; x <= range.y; x++) {
            let entry = atomicAdd(&cells[0], 1u) + 1u;
            // The processor sees how many were wanted, makes room and starts again.
            if entry <= scene.entries {
                let head = HEADS + scene.view[view].first_cell + y * scene.view[view].columns + x;
                atomicStore(&cells[entry_at(entry)], order);
                atomicStore(&cells[entry_at(entry) + 1u], atomicExchange(&cells[head], entry));
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
            add_to_cells(view, order, range);
        }
    }
}

/// One thread a polygon and view.
@compute @workgroup_size(64)
fn fill_cells(@builtin(global_invocation_id) id: vec3u) {
    let order = id.x;
    if order >= 2u * scene.samples {
        return;
    }
    let view = id.y;
    let bounds = box_of(view, order);
    if !boxes_touch(bounds, picture_of(view)) {
        return;
    }
    if is_long(bounds) && order % 2u == 1u {
        add_in_parts(view, order, bounds);
        return;
    }
    let range = cells_of(view, bounds);
    if cell_count(range) > MOST_CELLS {
        add_large(view, order);
    } else {
        add_to_cells(view, order, range);
    }
}
