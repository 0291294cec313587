// Statistics of the features' maps, their distance from what is wanted and its gradient.

/// Weighted mean of a map: a workgroup each.
@compute @workgroup_size(256)
fn texture_means(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) local: u32) {
    let level = texture_levels[group.y];
    let count = map_size(level);
    var sum = 0.0;
    for (var i = local; i < count; i += GROUP) {
        sum += texture_given[level.weights + i] * texture[level.maps + group.x * count + i];
    }
    sum = sum_up(sum, local);
    if local == 0u {
        texture[level.numbers + MEANS + group.x] = sum * level.inverse_weight;
    }
}

/// Covariances of one map here with all maps a shift away: a workgroup a shift and first map.
@compute @workgroup_size(256)
fn texture_grams(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) local: u32) {
    let level = texture_levels[group.y];
    let count = map_size(level);
    let shift = group.x / FEATURES;
    let feature = group.x % FEATURES;
    let half = max(level.width / 2u, 1u);
    var sums = array<f32, 7>();
    for (var i = local; i < count; i += GROUP) {
        let there = shifted(level, i % half, i / half, shift, 1);
        if there == NONE {
            continue;
        }
        let weight = texture_given[level.weights + i] * texture_given[level.weights + there];
        if weight == 0.0 {
            continue;
        }
        let mean = texture[level.numbers + MEANS + feature];
        let here = weight * (texture[level.maps + feature * count + i] - mean);
        for (var f = 0u; f < FEATURES; f++) {
            sums[f] += here * (texture[level.maps + f * count + there] - texture[level.numbers + MEANS + f]);
        }
    }
    for (var f = 0u; f < FEATURES; f++) {
        let sum = sum_up(sums[f], local);
        if local == 0u {
            texture[level.numbers + GRAMS + group.x * FEATURES + f] = sum * texture_levels[group.y].inverse_pairs[shift];
        }
    }
}

/// A level's loss, and the gradient to its covariances and mean amplitudes: one workgroup, a thread a covariance.
@compute @workgroup_size(256)
fn texture_distance(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) local: u32) {
    let level = texture_levels[group.y];
    let faint = texture_given[FAINT_VARIANCE];
    var variances = vec2f(faint);
    for (var f = 0u; f < DIRECTIONS; f++) {
        variances.x += texture[level.numbers + GRAMS + f * (FEATURES + 1u)];
    }
    variances.y += texture[level.numbers + GRAMS + DIRECTIONS * (FEATURES + 1u)];
    let factor = level.share * now.texture * scene.view[view_of(group.y)].weight;

    let is_entry = local < BUNDLES * FEATURES;
    let first = (local / FEATURES) % FEATURES;
    let second = local % FEATURES;
    let kinds = vec2u(u32(first >= DIRECTIONS), u32(second >= DIRECTIONS));
    let variance = vec2f(variances[kinds.x], variances[kinds.y]);
    let scale = sqrt(variance.x) * sqrt(variance.y);
    var found = 0.0;
    var wanted = 0.0;
    if is_entry {
        found = texture[level.numbers + GRAMS + local] / scale;
        wanted = texture_given[level.wanted + DIRECTIONS + local];
    }
    let size = sum_up(wanted * wanted, local) + 1e-12;
    let off = found - wanted;
    let squares = sum_up(off * off, local);
    let d = factor * 2.0 * off / size;
    let through = -0.5 * d * found / variance;
    var d_variance = vec2f();
    d_variance[kinds.x] += through.x;
    d_variance[kinds.y] += through.y;
    let d_amplitudes = sum_up(d_variance.x, local);
    let d_ink = sum_up(d_variance.y, local);
    if is_entry {
        var d_gram = d / scale;
        if local < FEATURES * FEATURES && first == second {
            d_gram += select(d_amplitudes, d_ink, first >= DIRECTIONS);
        }
        let pairs = texture_levels[group.y].inverse_pairs[local / (FEATURES * FEATURES)];
        texture[level.numbers + D_GRAMS + local] = d_gram * pairs;
    }
    if local == 0u {
        var amplitude = faint;
        var wanted_size = 1e-12;
        for (var f = 0u; f < DIRECTIONS; f++) {
            amplitude += texture[level.numbers + MEANS + f];
            wanted_size += texture_given[level.wanted + f] * texture_given[level.wanted + f];
        }
        var lost = 0.0;
        var direct_squares = 0.0;
        for (var f = 0u; f < DIRECTIONS; f++) {
            let share = texture[level.numbers + MEANS + f] / amplitude;
            let beside = share - texture_given[level.wanted + f];
            direct_squares += beside * beside;
            lost += factor * 2.0 * beside / wanted_size * share;
        }
        for (var f = 0u; f < DIRECTIONS; f++) {
            let beside = texture[level.numbers + MEANS + f] / amplitude - texture_given[level.wanted + f];
            texture[level.numbers + DIRECT + f] = (factor * 2.0 * beside / wanted_size - lost) / amplitude;
        }
        // Where there is nothing to look at there is no loss.
        let loss = factor * (direct_squares / wanted_size + squares / size);
        partials[scene.texture_partial + group.y] = select(0.0, loss, level.inverse_weight > 0.0);
    }
}
