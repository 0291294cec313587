/// The pull's loss: one workgroup adds it up, in fixed order.
@compute @workgroup_size(256)
fn measure_surface(@builtin(local_invocation_index) local: u32) {
    var squares = 0.0;
    for (var sample = local; sample < scene.samples; sample += GROUP) {
        let off = off_plane(sample);
        squares += off * off;
    }
    squares = sum_up(squares, local);
    if local == 0u {
        partials[scene.surface_partial] = surface_share() * squares;
    }
}
