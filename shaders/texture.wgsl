// What the texture's stages share. Twin of src/core/objective/texture; a second index of a dispatch is a view's level.

const DIRECTIONS: u32 = 6u;
const FEATURES: u32 = 7u;
const SHIFTS: u32 = 5u;
const BUNDLES: u32 = 35u;
const JETS: u32 = 7u;
const REACH: i32 = 4;

// Places in `texture_given` of what src/objective/texture/packed.rs lists.
const STEERING: u32 = 20u;
const FAINT_AMPLITUDE: u32 = 62u;
const FAINT_VARIANCE: u32 = 63u;
const STEPS: u32 = 64u;

// Places among a level's numbers.
const MEANS: u32 = 0u;
const THROUGH: u32 = 7u;
const GRAMS: u32 = 14u;
const D_GRAMS: u32 = 259u;
const DIRECT: u32 = 504u;

/// Which view a level is of.
fn view_of(index: u32) -> u32 {
    return index / scene.texture_levels;
}

/// Pixels of the features' maps.
fn map_size(level: TextureLevel) -> u32 {
    return (level.width / 2u) * (level.height / 2u);
}

/// Weights of the neighbour `k` px away for orders 0 to 3.
fn taps(k: i32) -> vec4f {
    let i = u32(abs(k));
    let turn = select(1.0, -1.0, k < 0);
    return vec4f(
        texture_given[i],
        turn * texture_given[5u + i],
        texture_given[10u + i],
        turn * texture_given[15u + i],
    );
}

/// Even and odd response in a direction, and the root of their squares' sum.
fn respond(direction: u32, jets: array<f32, 7>) -> vec3f {
    let first = STEERING + direction * JETS;
    var even = 0.0;
    var odd = 0.0;
    for (var m = 0u; m < 3u; m++) {
        even += texture_given[first + m] * jets[m];
    }
    for (var m = 3u; m < JETS; m++) {
        odd += texture_given[first + m] * jets[m];
    }
    return vec3f(even, odd, sqrt(even * even + odd * odd + texture_given[FAINT_AMPLITUDE]));
}

/// The place `shift` away from (x, y), or the other way round; NONE where that is outside the maps.
fn shifted(level: TextureLevel, x: u32, y: u32, shift: u32, turn: i32) -> u32 {
    let there = vec2i(i32(x), i32(y))
        + turn * vec2i(i32(texture_given[STEPS + 2u * shift]), i32(texture_given[STEPS + 2u * shift + 1u]));
    let size = vec2i(i32(level.width / 2u), i32(level.height / 2u));
    if any(there < vec2i(0)) || any(there >= size) {
        return NONE;
    }
    return u32(there.y * size.x + there.x);
}
