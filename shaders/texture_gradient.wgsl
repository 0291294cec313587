// From the gradient of the statistics back to the coverage's.

/// The features at a place less their means.
fn centred(level: TextureLevel, at: u32) -> array<f32, 7> {
    let count = map_size(level);
    var values = array<f32, 7>();
    for (var f = 0u; f < FEATURES; f++) {
        values[f] = texture[level.maps + f * count + at] - texture[level.numbers + MEANS + f];
    }
    return values;
}

/// The covariances' gradient to each feature less its mean.
@compute @workgroup_size(64)
fn texture_pull(@builtin(global_invocation_id) id: vec3u) {
    let level = texture_levels[id.y];
    let count = map_size(level);
    if id.x >= count {
        return;
    }
    let half = level.width / 2u;
    let own = texture_given[level.weights + id.x];
    var d = array<f32, 7>();
    for (var s = 0u; s < 2u * SHIFTS; s++) {
        // The first of each pair gets it from the second one, then the other way round.
        let shift = s / 2u;
        let turned = s % 2u == 1u;
        let there = shifted(level, id.x % half, id.x / half, shift, select(1, -1, turned));
        if there == NONE {
            continue;
        }
        let weight = own * texture_given[level.weights + there];
        if weight == 0.0 {
            continue;
        }
        let values = centred(level, there);
        let grams = level.numbers + D_GRAMS + shift * FEATURES * FEATURES;
        for (var f = 0u; f < FEATURES; f++) {
            for (var g = 0u; g < FEATURES; g++) {
                let entry = select(f * FEATURES + g, g * FEATURES + f, turned);
                d[f] += weight * texture[grams + entry] * values[g];
            }
        }
    }
    for (var f = 0u; f < FEATURES; f++) {
        texture[level.d_maps + f * count + id.x] = d[f];
    }
}

/// What each pixel's weight brings a map's gradient through its mean: a workgroup a map.
@compute @workgroup_size(256)
fn texture_pull_means(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) local: u32) {
    let level = texture_levels[group.y];
    let count = map_size(level);
    var sum = 0.0;
    for (var i = local; i < count; i += GROUP) {
        sum += texture[level.d_maps + group.x * count + i];
    }
    sum = sum_up(sum, local);
    if local == 0u {
        var direct = 0.0;
        if group.x < DIRECTIONS {
            direct = texture[level.numbers + DIRECT + group.x];
        }
        texture[level.numbers + THROUGH + group.x] = (direct - sum) * level.inverse_weight;
    }
}

/// The whole gradient to a feature.
fn d_feature(level: TextureLevel, feature: u32, at: u32) -> f32 {
    return texture[level.d_maps + feature * map_size(level) + at]
        + texture[level.numbers + THROUGH + feature] * texture_given[level.weights + at];
}

/// Turns the derivatives at a pixel into the gradient to them.
@compute @workgroup_size(64)
fn texture_jets(@builtin(global_invocation_id) id: vec3u) {
    let level = texture_levels[id.y];
    let count = level.width * level.height;
    if id.x >= count {
        return;
    }
    let x = id.x % level.width;
    let y = id.x / level.width;
    let size = vec2i(i32(level.width), i32(level.height));
    let inside = min(i32(x), i32(y)) >= REACH && i32(x) + REACH < size.x && i32(y) + REACH < size.y;
    var d = array<f32, 7>();
    if inside && x / 2u < level.width / 2u && y / 2u < level.height / 2u {
        var jets = array<f32, 7>();
        for (var m = 0u; m < JETS; m++) {
            jets[m] = texture[level.jets + m * count + id.x];
        }
        let at = (y / 2u) * (level.width / 2u) + x / 2u;
        for (var direction = 0u; direction < DIRECTIONS; direction++) {
            let response = respond(direction, jets);
            let pull = 0.25 * d_feature(level, direction, at) / response.z;
            for (var m = 0u; m < JETS; m++) {
                let weight = texture_given[STEERING + direction * JETS + m];
                d[m] += weight * pull * select(response.y, response.x, m < 3u);
            }
        }
    }
    for (var m = 0u; m < JETS; m++) {
        texture[level.jets + m * count + id.x] = d[m];
    }
}

/// Gathers the gradient to a level's pixel from that to the derivatives round it.
@compute @workgroup_size(64)
fn texture_gather(@builtin(global_invocation_id) id: vec3u) {
    let level = texture_levels[id.y];
    let count = level.width * level.height;
    if id.x >= count {
        return;
    }
    let x = i32(id.x % level.width);
    let y = i32(id.x / level.width);
    var sum = 0.0;
    for (var j = max(-REACH, y - i32(level.height) + 1); j <= min(REACH, y); j++) {
        let down = taps(j);
        for (var i = max(-REACH, x - i32(level.width) + 1); i <= min(REACH, x); i++) {
            let at = level.jets + u32(y - j) * level.width + u32(x - i);
            let by_order = vec4f(
                down.z * texture[at + 2u * count] + down.w * texture[at + 6u * count],
                down.y * texture[at + count] + down.z * texture[at + 5u * count],
                down.x * texture[at] + down.y * texture[at + 4u * count],
                down.x * texture[at + 3u * count],
            );
            sum += dot(taps(i), by_order);
        }
    }
    texture[level.d_picture + id.x] = sum;
}

/// Adds all levels' gradients to that of a view's pixel.
@compute @workgroup_size(64)
fn texture_add(@builtin(global_invocation_id) id: vec3u) {
    let view = scene.view[id.y];
    if id.x >= view.width * view.height {
        return;
    }
    let x = id.x % view.width;
    let y = id.x / view.width;
    var sum = 0.0;
    for (var l = 0u; l < scene.texture_levels; l++) {
        let level = texture_levels[id.y * scene.texture_levels + l];
        let part = 1.0 / f32(1u << (2u * level.halvings));
        let fine = vec2u(x, y) >> vec2u(level.halvings);
        if fine.x < level.width && fine.y < level.height {
            sum += part * texture[level.d_picture + fine.y * level.width + fine.x];
        }
        let coarse = fine / 2u;
        if coarse.x < level.width / 2u && coarse.y < level.height / 2u {
            sum += 0.25 * part * d_feature(level, DIRECTIONS, coarse.y * (level.width / 2u) + coarse.x);
        }
    }
    pyramid[view.first_pixel + id.x] += sum;
}
