// The row of loss terms, and whether it is the best: one workgroup adds everything up, in fixed order.

@compute @workgroup_size(256)
fn add_terms(@builtin(local_invocation_index) local: u32) {
    let row = now.row * (scene.views + TERMS + 1u);
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
    var strand = vec4f();
    if scene.nodes > 0u {
        for (var loss = 0u; loss < 4u; loss++) {
            var part = 0.0;
            for (var group = local; group * GROUP < scene.nodes; group += GROUP) {
                part += partials[scene.node_partial + 4u * group + loss];
            }
            strand[loss] = sum_up(part, local);
        }
    }
    if local == 0u {
        var surface = 0.0;
        if scene.planes > 0u {
            surface = partials[scene.surface_partial];
        }
        var texture_loss = 0.0;
        for (var i = 0u; i < scene.views * scene.texture_levels; i++) {
            texture_loss += partials[scene.texture_partial + i];
        }
        terms[row] = total + jerk + path + surface + texture_loss + dot(strand, vec4f(1.0));
        let others = row + scene.views;
        terms[others + TERM_JERK] = jerk;
        terms[others + TERM_LENGTH] = path;
        terms[others + TERM_SURFACE] = surface;
        terms[others + TERM_TEXTURE] = texture_loss;
        terms[others + TERM_BENDING] = strand[0];
        terms[others + TERM_TIGHTNESS] = strand[1];
        terms[others + TERM_EVENNESS] = strand[2];
        terms[others + TERM_CLEARANCE] = strand[3];
        // Whoever guides adds it.
        terms[others + TERM_GUIDANCE] = 0.0;
        terms[others + TERMS] = f32(atomicLoad(&cells[0]));
        let loss = (total + texture_loss) * now.loss_scale;
        let is_best = loss < best[0].x || now.keeps_last == 1u;
        best[0] = vec4f(select(best[0].x, loss, is_best), f32(is_best), 0.0, 0.0);
    }
}
