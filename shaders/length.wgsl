// Length of the sampled polylines. Twin of src/core/objective/regularisers.rs.

const SHORTEST_STEP: f32 = 1e-12;

/// Distance from a sample to the next one of its stroke.
fn length_after(sample: u32) -> f32 {
    let next = links[sample].y;
    if next == NONE || next == sample {
        return 0.0;
    }
    return length(samples[next].xyz - samples[sample].xyz);
}

/// Gradient of the length at one sample: away from both neighbours.
fn d_length(sample: u32) -> vec3f {
    var sum = vec3f();
    for (var i = 0u; i < 2u; i++) {
        let neighbour = links[sample][i];
        if neighbour != NONE && neighbour != sample {
            let away = samples[sample].xyz - samples[neighbour].xyz;
            let distance = length(away);
            if distance > SHORTEST_STEP {
                sum += away / distance;
            }
        }
    }
    return sum;
}
