// The pull to the planes that touch the surface. Twin of src/core/objective/surface.rs.

/// Signed distance of a sample from its plane.
fn off_plane(sample: u32) -> f32 {
    return dot(planes[sample].xyz, samples[sample].xyz) - planes[sample].w;
}

/// Weight of each sample's squared distance.
fn surface_share() -> f32 {
    return now.surface / f32(scene.samples);
}

/// Gradient of the pull at one sample.
fn d_surface(sample: u32) -> vec3f {
    return 2.0 * surface_share() * off_plane(sample) * planes[sample].xyz;
}
