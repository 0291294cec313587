// Area sums to coverage: a running sum along each row, as a scan. Twin of src/core/raster/rows.rs.
//
// A pixel no outline runs through is wholly in or out, so the running sum r is rounded there. What a run of pixels
// does to r is r + before, or, once it was rounded, whole(r + before) + after; as whole(whole(x) + y) is
// whole(x) + whole(y), such maps compose to such maps.

const GROUP: u32 = 64u;

struct Running {
    before: i32,
    after: i32,
    rounded: u32,
}

var<workgroup> scan: array<Running, GROUP>;
var<workgroup> leaks: u32;

/// The nearest whole winding number.
fn whole(sum: i32) -> i32 {
    return (sum + UNIT / 2) & ~(UNIT - 1);
}

fn shade(sum: i32) -> f32 {
    return clamp(f32(abs(sum)) / f32(UNIT), 0.0, 1.0);
}

fn then(first: Running, second: Running) -> Running {
    if second.rounded == 0u {
        if first.rounded == 0u {
            return Running(first.before + second.before, 0, 0u);
        }
        return Running(first.before, first.after + second.before, 1u);
    }
    if first.rounded == 0u {
        return Running(first.before + second.before, second.after, 1u);
    }
    return Running(first.before, whole(first.after + second.before) + second.after, 1u);
}

fn apply(map: Running, sum: i32) -> i32 {
    if map.rounded == 0u {
        return sum + map.before;
    }
    return whole(sum + map.before) + map.after;
}

fn of_pixel(sum: i32) -> Running {
    return Running(sum & ~TOUCHED, 0, u32((sum & TOUCHED) == 0));
}

/// Whether no polygon's box touches a pixel.
fn is_clear(view: u32, x: u32, y: u32) -> bool {
    let query = vec4f(f32(x), f32(y), -f32(x + 1u), -f32(y + 1u));
    let range = cells_of(view, query);
    for (var row = range.z; row <= range.w; row++) {
        for (var column = range.x; column <= range.y; column++) {
            var entry = filled[head_at(view, column, row)];
            while entry != 0u {
                if boxes_touch(box_of(view, filled[entry_at(entry)]), query) {
                    return false;
                }
                entry = filled[entry_at(entry) + 1u];
            }
        }
    }
    let large = filled[LARGE_COUNTS + view];
    for (var i = 0u; i < large; i++) {
        if boxes_touch(box_of(view, filled[first_large(view) + i]), query) {
            return false;
        }
    }
    return true;
}

/// A workgroup a row and view.
@compute @workgroup_size(64)
fn finish_rows(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) local: u32) {
    let view = group.y;
    let row = group.x;
    let width = scene.view[view].width;
    if row >= scene.view[view].height {
        return;
    }
    let border = scene.pixels + scene.view[view].first_row + row;
    let first = scene.view[view].first_pixel + row * width;
    let chunk = (width + GROUP - 1u) / GROUP;
    let begin = min(local * chunk, width);
    let to = min(begin + chunk, width);
    var own = Running(0, 0, 0u);
    for (var x = begin; x < to; x++) {
        own = then(own, of_pixel(summed[first + x]));
    }
    scan[local] = own;
    if local == 0u {
        leaks = 0u;
    }
    workgroupBarrier();
    for (var reach = 1u; reach < GROUP; reach *= 2u) {
        var combined = scan[local];
        if local >= reach {
            combined = then(scan[local - reach], combined);
        }
        workgroupBarrier();
        scan[local] = combined;
        workgroupBarrier();
    }
    // What of the border is not visible is covered.
    var running = UNIT - summed[border];
    if local > 0u {
        running = apply(scan[local - 1u], running);
    }
    for (var x = begin; x < to; x++) {
        running = apply(of_pixel(summed[first + x]), running);
        coverage[first + x] = shade(running);
        summed[first + x] = 0;
    }
    // Where rounding loses a whole edge among many that nearly coincide, the row's sum stays whole behind it.
    if begin < to && to == width && coverage[first + width - 1u] >= 1.0 && is_clear(view, width - 1u, row) {
        leaks = 1u;
    }
    workgroupBarrier();
    if local == 0u {
        summed[border] = 0;
    }
    if leaks == 1u {
        for (var x = begin; x < to; x++) {
            if coverage[first + x] >= 1.0 && is_clear(view, x, row) {
                coverage[first + x] = 0.0;
            }
        }
    }
}
