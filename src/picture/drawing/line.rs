//! Polylines: length, even points, smoothing.

/// Length, px.
pub fn length(points: &[[f32; 2]]) -> f32 {
    points.windows(2).map(|w| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1])).sum()
}

/// Whether a line ends where it begins.
pub fn is_closed(points: &[[f32; 2]]) -> bool {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return false };
    points.len() > 20 && (first[0] - last[0]).hypot(first[1] - last[1]) < 2.5
}

/// Points about `step_px` apart along a line, both ends kept.
pub fn even(points: &[[f32; 2]], step_px: f32) -> Vec<[f32; 2]> {
    let total = length(points);
    if points.len() < 2 || total < 1e-6 {
        return points.to_vec();
    }
    let count = (total / step_px).round().max(1.0) as usize;
    let mut out = vec![points[0]];
    let mut behind = 0.0;
    for w in points.windows(2) {
        let piece = (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1]);
        while out.len() < count && piece > 0.0 && out.len() as f32 * total / count as f32 <= behind + piece {
            let share = (out.len() as f32 * total / count as f32 - behind) / piece;
            out.push([0, 1].map(|k| w[0][k] + share * (w[1][k] - w[0][k])));
        }
        behind += piece;
    }
    out.push(points[points.len() - 1]);
    out
}

/// Smoothed along itself by a Gaussian, points a pixel apart. Ends stay; closed lines stay closed.
pub fn smooth(points: &[[f32; 2]], sigma_px: f32) -> Vec<[f32; 2]> {
    let line = even(points, 1.0);
    let count = line.len();
    if count < 5 {
        return line;
    }
    let closed = is_closed(&line);
    let reach = ((3.0 * sigma_px).ceil() as isize).min(count as isize - 1);
    let weights: Vec<f32> = (-reach..=reach).map(|k| (-0.5 * (k as f32 / sigma_px).powi(2)).exp()).collect();
    let sum: f32 = weights.iter().sum();
    let last = count as isize - 1;
    let at = |i: isize| -> [f32; 2] {
        if closed {
            return line[i.rem_euclid(last) as usize];
        }
        // Turned about the ends, so that they stay.
        if i < 0 {
            return [0, 1].map(|k| 2.0 * line[0][k] - line[(-i) as usize][k]);
        }
        if i > last {
            return [0, 1].map(|k| 2.0 * line[count - 1][k] - line[(2 * last - i) as usize][k]);
        }
        line[i as usize]
    };
    let mut out: Vec<[f32; 2]> = (0..count as isize)
        .map(|i| {
            let mut mean = [0.0f32; 2];
            for (k, weight) in (-reach..=reach).zip(&weights) {
                let p = at(i + k);
                mean[0] += weight * p[0];
                mean[1] += weight * p[1];
            }
            mean.map(|v| v / sum)
        })
        .collect();
    if closed {
        out[count - 1] = out[0];
    }
    out
}

/// How much a line turns, radians a step of 4 px.
pub fn turning(points: &[[f32; 2]]) -> f32 {
    let coarse = even(points, 4.0);
    let angles: Vec<f32> = coarse.windows(2).map(|w| (w[1][1] - w[0][1]).atan2(w[1][0] - w[0][0])).collect();
    let turn = |w: &[f32]| {
        let d = (w[1] - w[0]).abs();
        d.min(std::f32::consts::TAU - d)
    };
    angles.windows(2).map(turn).sum::<f32>() / (angles.len().saturating_sub(1)).max(1) as f32
}
