// The coverage at the levels that count, and which way lines run there.

/// A level's picture: means over blocks of the view's.
@compute @workgroup_size(64)
fn texture_floors(@builtin(global_invocation_id) id: vec3u) {
    let level = texture_levels[id.y];
    if id.x >= level.width * level.height {
        return;
    }
    let view = scene.view[view_of(id.y)];
    let side = 1u << level.halvings;
    let first = view.first_pixel + side * ((id.x / level.width) * view.width + id.x % level.width);
    var sum = 0.0;
    for (var y = 0u; y < side; y++) {
        for (var x = 0u; x < side; x++) {
            sum += coverage[first + y * view.width + x];
        }
    }
    texture[level.picture + id.x] = sum / f32(side * side);
}

/// The seven derivatives at a pixel; 0 where the filters reach beyond the picture.
fn jets_at(level: TextureLevel, x: i32, y: i32) -> array<f32, 7> {
    var jets = array<f32, 7>();
    let size = vec2i(i32(level.width), i32(level.height));
    if min(x, y) < REACH || x + REACH >= size.x || y + REACH >= size.y {
        return jets;
    }
    for (var j = -REACH; j <= REACH; j++) {
        let row = level.picture + u32((y + j) * size.x + x - REACH);
        var along = vec4f();
        for (var i = -REACH; i <= REACH; i++) {
            along += texture[row + u32(i + REACH)] * taps(i);
        }
        let down = taps(j);
        jets[0] += down.x * along.z;
        jets[1] += down.y * along.y;
        jets[2] += down.z * along.x;
        jets[3] += down.x * along.w;
        jets[4] += down.y * along.z;
        jets[5] += down.z * along.y;
        jets[6] += down.w * along.x;
    }
    return jets;
}

/// Derivatives of four pixels and the features of the pixel they become.
@compute @workgroup_size(64)
fn texture_features(@builtin(global_invocation_id) id: vec3u) {
    let level = texture_levels[id.y];
    let count = map_size(level);
    if id.x >= count {
        return;
    }
    let half = level.width / 2u;
    var sums = array<f32, 6>();
    var ink = 0.0;
    for (var p = 0u; p < 4u; p++) {
        let x = 2u * (id.x % half) + p % 2u;
        let y = 2u * (id.x / half) + p / 2u;
        let at = y * level.width + x;
        let jets = jets_at(level, i32(x), i32(y));
        for (var m = 0u; m < JETS; m++) {
            texture[level.jets + m * level.width * level.height + at] = jets[m];
        }
        for (var d = 0u; d < DIRECTIONS; d++) {
            sums[d] += respond(d, jets).z;
        }
        ink += texture[level.picture + at];
    }
    for (var d = 0u; d < DIRECTIONS; d++) {
        texture[level.maps + d * count + id.x] = 0.25 * sums[d] - sqrt(texture_given[FAINT_AMPLITUDE]);
    }
    texture[level.maps + DIRECTIONS * count + id.x] = 0.25 * ink;
}
