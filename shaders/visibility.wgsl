// How much of a strand a solid leaves to see. Twin of src/core/view/visibility.rs.

/// Where the sigmoid's argument is cut off.
const STEEPEST: f32 = 80.0;
/// A strand less visible than this is not drawn.
const LEAST_VISIBILITY: f32 = 1e-3;

/// Visibility of what is seen at `center` (within reach) and lies `depth` before the camera.
fn visibility(view: u32, center: vec2f, depth: f32) -> f32 {
    let size = vec2f(f32(scene.view[view].width), f32(scene.view[view].height));
    if scene.view[view].steepness == 0.0 || any(center < vec2f()) || any(center >= size) {
        return 1.0;
    }
    let pixel = scene.view[view].first_pixel + u32(center.y) * scene.view[view].width + u32(center.x);
    let before = occluder_depth[pixel] - depth + scene.view[view].bias_world;
    return 1.0 / (1.0 + exp(-clamp(scene.view[view].steepness * before, -STEEPEST, STEEPEST)));
}
