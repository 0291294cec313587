// The row of loss terms, and whether it is the best: one workgroup adds everything up, in fixed order.

@compute @workgroup_size(256)
fn add_terms(@builtin(local_invocation_index) local: u32) {
    let row = now.row * (scene.views + 6u);
    var total = 0.0;
    for (var view = 0u; view < scene.views; view++) {
        var image = 0.0;
        for (var i = local; i < scene.view[view].partials; i += GROUP) {
            image += partials[scene.view[view].first_partial + i];
        }
        image = sum_up(image, local);
        total += image;
        if local == 0u {
            terms[row + 1u + view] = image;
        }
    }
    var jerk = 0.0;
    for (var span = local; span < scene.spans; span += GROUP) {
        let third = jerk_of_span(span);
        jerk += dot(jerk_weights(), third * third);
    }
    jerk = sum_up(jerk, local);
    var path = 0.0;
    if now.length > 0.0 {
        for (var sample = local; sample < scene.samples; sample += GROUP) {
            path += length_after(sample);
        }
    }
    path = now.length * sum_up(path, local);
    if local == 0u {
        var surface = 0.0;
        if scene.planes > 0u {
            surface = partials[scene.surface_partial];
        }
        var texture_loss = 0.0;
        for (var i = 0u; i < scene.views * scene.texture_levels; i++) {
            texture_loss += partials[scene.texture_partial + i];
        }
        terms[row] = total + jerk + path + surface + texture_loss;
        terms[row + scene.views + 1u] = jerk;
        terms[row + scene.views + 2u] = path;
        terms[row + scene.views + 3u] = surface;
        terms[row + scene.views + 4u] = texture_loss;
        terms[row + scene.views + 5u] = f32(atomicLoad(&cells[0]));
        let loss = (total + texture_loss) * now.loss_scale;
        let is_best = loss < best[0].x;
        best[0] = vec4f(select(best[0].x, loss, is_best), f32(is_best), 0.0, 0.0);
    }
}
