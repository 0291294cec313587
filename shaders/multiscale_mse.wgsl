// The multi-scale loss and its gradient, all views at once. Twin of src/core/objective/multiscale_mse.rs. The fine levels take a pass
// each, down and up; between the two a workgroup a view goes down and up the coarse ones, where threads are few anyway.

const GROUP: u32 = 256u;

var<workgroup> squares: array<f32, GROUP>;

/// Weight of a level's squares.
fn share(view: u32, level: u32) -> f32 {
    let size = levels[view * MOST_LEVELS + level];
    var weight = scene.view[view].weight;
    for (var l = 0u; l < level; l++) {
        weight *= now.level_ratio;
    }
    return weight / f32(size.width * size.height);
}

/// Index `i` reflected into `0..n` without repeating the border.
fn reflect_index(i: i32, n: i32) -> i32 {
    let inside = abs(i);
    return select(inside, 2 * (n - 1) - inside, inside >= n);
}

/// The symmetric 5-tap kernel exp(-x² / 2), normalised.
fn tap(k: i32) -> f32 {
    let sum = 1.0 + 2.0 * (0.60653065971 + 0.13533528324);
    return select(select(0.13533528324, 0.60653065971, abs(k) == 1), 1.0, k == 0) / sum;
}

/// A coarse pixel from the finer level.
fn coarser(fine: Level, x: u32, y: u32) -> f32 {
    if scene.gaussian == 0u {
        let upper = fine.offset + 2u * y * fine.width + 2u * x;
        let lower = upper + fine.width;
        return 0.25 * ((pyramid[upper] + pyramid[upper + 1u]) + (pyramid[lower] + pyramid[lower + 1u]));
    }
    var sum = 0.0;
    for (var j = -2; j <= 2; j++) {
        let row = fine.offset + u32(reflect_index(2 * i32(y) + j, i32(fine.height))) * fine.width;
        var along = 0.0;
        for (var i = -2; i <= 2; i++) {
            along += tap(i) * pyramid[row + u32(reflect_index(2 * i32(x) + i, i32(fine.width)))];
        }
        sum += tap(j) * along;
    }
    return sum;
}

/// How much the coarse index takes from the fine one.
fn taken(coarse: i32, fine: i32, n: i32) -> f32 {
    if coarse < 0 || coarse >= n / 2 {
        return 0.0;
    }
    var sum = 0.0;
    for (var k = -2; k <= 2; k++) {
        sum += select(0.0, tap(k), reflect_index(2 * coarse + k, n) == fine);
    }
    return sum;
}

/// What a fine pixel gets back from the coarser level.
fn finer(coarse: Level, fine: Level, x: u32, y: u32) -> f32 {
    if scene.gaussian == 0u {
        if x / 2u >= coarse.width || y / 2u >= coarse.height {
            return 0.0;
        }
        return 0.25 * pyramid[coarse.offset + (y / 2u) * coarse.width + x / 2u];
    }
    var sum = 0.0;
    for (var j = -2; j <= 2; j++) {
        let row = i32(y) / 2 + j;
        let weight = taken(row, i32(y), i32(fine.height));
        if weight == 0.0 {
            continue;
        }
        for (var i = -2; i <= 2; i++) {
            let column = i32(x) / 2 + i;
            let product = weight * taken(column, i32(x), i32(fine.width));
            if product != 0.0 {
                sum += product * pyramid[coarse.offset + u32(row) * coarse.width + u32(column)];
            }
        }
    }
    return sum;
}

/// Adds `squares` up into the first, as a tree of fixed shape.
fn add_squares(local: u32) {
    workgroupBarrier();
    for (var half = GROUP / 2u; half > 0u; half /= 2u) {
        if local < half {
            squares[local] += squares[local + half];
        }
        workgroupBarrier();
    }
}

/// Turns the difference at index `i` of a level into the gradient; coarser levels must have been turned before.
fn turn(view: u32, l: u32, i: u32) {
    let level = levels[view * MOST_LEVELS + l];
    var value = 2.0 * share(view, l) * pyramid[level.offset + i];
    if l + 1u < scene.view[view].levels {
        let coarse = levels[view * MOST_LEVELS + l + 1u];
        value += finer(coarse, level, i % level.width, i / level.width);
    }
    pyramid[level.offset + i] = value;
}

/// Makes a fine level of differences; each workgroup sums up its share of the loss.
@compute @workgroup_size(256)
fn compare(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(local_invocation_index) local: u32,
    @builtin(workgroup_id) group: vec3u,
) {
    let view = group.y;
    let l = pyramid_pass.level;
    if l >= scene.view[view].fine_levels {
        return;
    }
    let level = levels[view * MOST_LEVELS + l];
    if group.x * GROUP >= level.width * level.height {
        return;
    }
    var value = 0.0;
    if id.x < level.width * level.height {
        if l == 0u {
            value = coverage[level.offset + id.x] - target_ink[level.offset + id.x];
        } else {
            value = coarser(levels[view * MOST_LEVELS + l - 1u], id.x % level.width, id.x / level.width);
        }
        pyramid[level.offset + id.x] = value;
    }
    squares[local] = value * value;
    add_squares(local);
    if local == 0u {
        partials[level.first_partial + group.x] = share(view, l) * squares[0];
    }
}

/// The coarse levels of a view, and its loss: one workgroup.
@compute @workgroup_size(256)
fn compare_coarse(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) local: u32) {
    let view = group.y;
    let first = scene.view[view].fine_levels;
    let finest = levels[view * MOST_LEVELS];
    let last = levels[view * MOST_LEVELS + first - 1u];
    let end = last.first_partial + (last.width * last.height + GROUP - 1u) / GROUP;
    var loss = 0.0;
    for (var i = finest.first_partial + local; i < end; i += GROUP) {
        loss += partials[i];
    }
    for (var l = first; l < scene.view[view].levels; l++) {
        let level = levels[view * MOST_LEVELS + l];
        let weight = share(view, l);
        for (var i = local; i < level.width * level.height; i += GROUP) {
            let value = coarser(levels[view * MOST_LEVELS + l - 1u], i % level.width, i / level.width);
            pyramid[level.offset + i] = value;
            loss += weight * value * value;
        }
        storageBarrier();
    }
    squares[local] = loss;
    add_squares(local);
    if local == 0u {
        partials[scene.view[view].first_partial] = squares[0];
    }
    for (var l = scene.view[view].levels; l > first; l--) {
        let level = levels[view * MOST_LEVELS + l - 1u];
        for (var i = local; i < level.width * level.height; i += GROUP) {
            turn(view, l - 1u, i);
        }
        storageBarrier();
    }
}

/// Turns a fine level.
@compute @workgroup_size(256)
fn compare_vjp(@builtin(global_invocation_id) id: vec3u) {
    let view = id.y;
    let l = pyramid_pass.level;
    let level = levels[view * MOST_LEVELS + l];
    if l < scene.view[view].fine_levels && id.x < level.width * level.height {
        turn(view, l, id.x);
    }
}
