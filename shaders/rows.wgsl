// Area sums to coverage: a running sum along each row, as a scan. Twin of src/core/raster/rows.rs.
//
// A pixel no outline runs through is wholly in or out, so the running sum r becomes one or the other there. What a run
// of pixels does to r is r + before, or, where it has such a pixel, one of two sums: which one is decided by whether
// r + before is nearer to in or to out. Such maps compose to such maps.

const GROUP: u32 = 64u;

struct Running {
    before: i32,
    /// Whether it has a pixel that no outline runs through; then what it ends in if it came there out, and in.
    whole: u32,
    from_out: i32,
    from_in: i32,
}

var<workgroup> scan: array<Running, GROUP>;

fn is_in(sum: i32) -> bool {
    return sum >= UNIT / 2;
}

fn shade(sum: i32) -> f32 {
    return clamp(f32(sum) / f32(UNIT), 0.0, 1.0);
}

fn apply(map: Running, sum: i32) -> i32 {
    if map.whole == 0u {
        return sum + map.before;
    }
    return select(map.from_out, map.from_in, is_in(sum + map.before));
}

fn then(first: Running, second: Running) -> Running {
    if first.whole == 0u {
        return Running(first.before + second.before, second.whole, second.from_out, second.from_in);
    }
    return Running(first.before, 1u, apply(second, first.from_out), apply(second, first.from_in));
}

fn of_pixel(sum: i32) -> Running {
    return Running(sum & ~TOUCHED, u32((sum & TOUCHED) == 0), 0, UNIT);
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
    var own = Running();
    for (var x = begin; x < to; x++) {
        own = then(own, of_pixel(summed[first + x]));
    }
    scan[local] = own;
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
    // Everybody has read it by then.
    workgroupBarrier();
    if local == 0u {
        summed[border] = 0;
    }
}
