//! Seeded value noise over space, and numbers by place.

use glam::DVec3;

/// 0 to 1 for a cell.
pub fn hash(x: i64, y: i64, z: i64, seed: u64) -> f64 {
    let mut h = seed ^ 0x9e37_79b9_7f4a_7c15;
    for v in [x, y, z] {
        h = (h ^ v as u64).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        h ^= h >> 29;
        h = h.wrapping_mul(0x94d0_49bb_1331_11eb);
        h ^= h >> 32;
    }
    (h >> 11) as f64 / (1u64 << 53) as f64
}

/// Smooth noise with features one unit large, 0 to 1.
pub fn value(p: DVec3, seed: u64) -> f64 {
    let cell = p.floor();
    let t = (p - cell) * (p - cell) * (DVec3::splat(3.0) - 2.0 * (p - cell));
    let corner = |i: i64| {
        let [x, y, z] = [i & 1, i >> 1 & 1, i >> 2 & 1];
        let weight = |bit: i64, t: f64| if bit == 1 { t } else { 1.0 - t };
        weight(x, t.x)
            * weight(y, t.y)
            * weight(z, t.z)
            * hash(cell.x as i64 + x, cell.y as i64 + y, cell.z as i64 + z, seed)
    };
    (0..8).map(corner).sum()
}

/// Four octaves of [`value`], 0 to 1.
pub fn cloud(p: DVec3, seed: u64) -> f64 {
    (0..4).map(|k| value(p * f64::from(1 << k), seed + k) * 0.5f64.powi(k as i32 + 1)).sum::<f64>() / 0.9375
}
