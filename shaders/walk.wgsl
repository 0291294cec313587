// Visible outline to pixels. Twin of src/core/raster/walk.rs.

const FAR: f32 = 1e30;

/// The parameter interval of an edge inside [0, size]; empty (from 1 to 0) if there is none.
fn clip(edge: Edge, size: vec2f) -> vec2f {
    var inside = vec2f(0.0, 1.0);
    for (var c = 0u; c < 2u; c++) {
        let p = edge.origin[c] + edge.start[c];
        let d = edge.along[c];
        let low = min(p, p + d);
        let high = max(p, p + d);
        if low >= 0.0 && high <= size[c] {
            continue;
        }
        if !(high >= 0.0 && low <= size[c]) || d == 0.0 {
            return vec2f(1.0, 0.0);
        }
        let t = -p / d;
        let u = (size[c] - p) / d;
        inside = vec2f(max(inside.x, min(t, u)), min(inside.y, max(t, u)));
    }
    return inside;
}

/// The part of a stretch between two parameters lies in one pixel: which area it closes off there and further right,
/// how long it is, and its middle's place along the piece.
fn cut(
    view: u32, columns: u32, start: vec2f, along: vec2f, u: f32, du: f32,
    column: i32, row: i32, low: f32, high: f32, length_px: f32,
) {
    let share = max(high - low, 0.0);
    let middle = 0.5 * (low + high);
    let into_pixel = clamp(start.x + along.x * middle - f32(column), 0.0, 1.0);
    let steps = along.y * share * f32(UNIT / 2);
    let whole = i32(steps);
    let rest = i32(steps * into_pixel);
    let beyond = select(0, rest * 2, column + 1 < i32(columns));
    visit(view, u32(row) * columns + u32(column), (whole - rest) * 2, beyond, length_px * share, u + du * middle);
}

/// Walks a stretch through the pixels of a picture `columns` wide.
fn walk(view: u32, columns: u32, start: vec2f, along: vec2f, u: f32, du: f32) {
    let rows = scene.view[view].height;
    let length_px = sqrt(along.x * along.x + along.y * along.y);
    var at = min(vec2i(start), vec2i(i32(columns), i32(rows)) - 1);
    if all(at == vec2i(start + along)) {
        cut(view, columns, start, along, u, du, at.x, at.y, 0.0, 1.0, length_px);
        return;
    }
    // Parameter of the next vertical and horizontal pixel border, and from one to the next.
    var next = vec2f(FAR);
    var pace = vec2f(FAR);
    var ahead = vec2i();
    for (var c = 0u; c < 2u; c++) {
        if along[c] != 0.0 {
            pace[c] = abs(1.0 / along[c]);
            ahead[c] = select(-1, 1, along[c] > 0.0);
            next[c] = (f32(at[c] + max(ahead[c], 0)) - start[c]) * (1.0 / along[c]);
        }
    }
    var t = 0.0;
    loop {
        let until = min(min(next.x, next.y), 1.0);
        cut(view, columns, start, along, u, du, at.x, at.y, t, until, length_px);
        if until >= 1.0 {
            break;
        }
        t = until;
        let c = select(1u, 0u, next.x < next.y);
        at[c] += ahead[c];
        next[c] += pace[c];
        if u32(at.x) >= columns || u32(at.y) >= rows {
            break;
        }
    }
}
