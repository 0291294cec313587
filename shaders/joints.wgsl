// How two pieces meet at a node, decided for both sides at once. Twin of src/core/raster/joints.rs.

/// The node before (0) or after (1) a node.
fn joined(view: u32, k: u32, i: u32) -> u32 {
    let other = links[k][i];
    if other == NONE || other == k || vertex_of(view, k).w == 0.0 || vertex_of(view, other).w == 0.0 {
        return NONE;
    }
    return other;
}

/// Points of a joint are relative to its node.
fn tangent_point(node: vec4f, piece: Piece, side: f32) -> vec2f {
    return node.z * side_normal(piece, side);
}

fn hard_joint(node: vec4f, before: Piece, after: Piece) -> Joint {
    var joint = Joint();
    joint.kind = HARD;
    for (var i = 0u; i < 2u; i++) {
        joint.before[i] = tangent_point(node, before, side_of(i));
        joint.after[i] = tangent_point(node, after, side_of(i));
    }
    return joint;
}

fn joint_between(node: vec4f, before: Piece, after: Piece) -> Joint {
    if !before.has_sides || !after.has_sides {
        return hard_joint(node, before, after);
    }
    let tightest = TRIM_SHARE * min(before.length, after.length) * min(before.cosine, after.cosine);
    var joint = Joint();
    joint.kind = MITRED;
    joint.shared_sides = 3u;
    for (var i = 0u; i < 2u; i++) {
        let side = side_of(i);
        let a = side_normal(before, side);
        let b = side_normal(after, side);
        let along = a.x * b.x + a.y * b.y;
        let turn = a.x * b.y - a.y * b.x;
        if along <= 0.0 || abs(turn) >= SHARPEST_MITRE {
            return hard_joint(node, before, after);
        }
        let reach = node.z / (1.0 + along);
        let extension = reach * abs(turn);
        let outer = turn * side < 0.0;
        if !outer && extension >= tightest {
            joint.kind = SOFT;
            joint.shared_sides &= ~(1u << i);
            joint.before[i] = tangent_point(node, before, side);
            joint.after[i] = tangent_point(node, after, side);
        } else {
            let meet = reach * (a + b);
            joint.before[i] = meet;
            joint.after[i] = meet;
            joint.extension[i] = select(-extension, extension, outer);
        }
    }
    return joint;
}

/// One thread a node and view.
@compute @workgroup_size(64)
fn join_pieces(@builtin(global_invocation_id) id: vec3u) {
    let k = id.x;
    if k >= scene.samples {
        return;
    }
    let view = id.y;
    let node = vertex_of(view, k);
    let previous = joined(view, k, 0u);
    let next = joined(view, k, 1u);
    var before = Piece();
    var after = Piece();
    if previous != NONE {
        before = piece_between(vertex_of(view, previous), node);
    }
    if next != NONE {
        after = piece_between(node, vertex_of(view, next));
    }
    var joint = joint_between(node, before, after);
    if node.w == 0.0 {
        joint.kind = ABSENT;
    }
    joint.previous = previous;
    joint.next = next;
    joints[view * scene.samples + k] = joint;
}
