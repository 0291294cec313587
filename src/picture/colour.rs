//! Colours as people see them, and the direction in which ink differs from its ground.

/// Pixels this near to the ground's colour, of the full range, are ground.
const NEAR: f32 = 0.12;

/// Share of the full range, from black to white, by which `b` is another colour than `a`; encoded values.
pub fn apart(a: [f32; 3], b: [f32; 3]) -> f32 {
    distance(a, b) / 3f32.sqrt()
}

/// Between two colours, in their own units.
pub fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f32>().sqrt()
}

/// Luma of encoded values, 0 to 1 (BT.709's weights: antialiasing mixes those values, not light).
pub fn luma([r, g, b]: [f32; 3]) -> f32 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// Oklab (Ottosson 2020), in which equal distances look equally different; black to white is 1.
pub fn oklab(rgb: [u8; 3]) -> [f32; 3] {
    oklab_of_light(rgb.map(|byte| {
        let value = f32::from(byte) / 255.0;
        if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
    }))
}

/// [`oklab`] of linear light, 0 to 1.
pub fn oklab_of_light([r, g, b]: [f32; 3]) -> [f32; 3] {
    let l = (0.412_221_46 * r + 0.536_332_55 * g + 0.051_445_995 * b).cbrt();
    let m = (0.211_903_5 * r + 0.680_699_5 * g + 0.107_396_96 * b).cbrt();
    let s = (0.088_302_46 * r + 0.281_718_85 * g + 0.629_978_7 * b).cbrt();
    [
        0.210_454_26 * l + 0.793_617_8 * m - 0.004_072_047 * s,
        1.977_998_5 * l - 2.428_592_2 * m + 0.450_593_7 * s,
        0.025_904_037 * l + 0.782_771_77 * m - 0.808_675_77 * s,
    ]
}

/// The colour that most of some pixels have: the fullest of 512 cells, and the mean of what is near to it.
pub fn dominant(colours: &[[f32; 3]]) -> [f32; 3] {
    let cell = |colour: [f32; 3]| colour.iter().fold(0, |cell, value| cell * 8 + (value * 7.99) as usize);
    let mut counts = [0u32; 512];
    colours.iter().for_each(|&colour| counts[cell(colour)] += 1);
    let fullest = (0..512).max_by_key(|&cell| counts[cell]).unwrap_or(0);
    let mut ground = mean(colours.iter().copied().filter(|&colour| cell(colour) == fullest));
    for _ in 0..3 {
        ground = mean(colours.iter().copied().filter(|&colour| apart(colour, ground) < NEAR));
    }
    ground
}

/// The mean of some colours; black if there is none.
pub fn mean(colours: impl Iterator<Item = [f32; 3]>) -> [f32; 3] {
    let (mut sums, mut count) = ([0.0f64; 3], 0usize);
    for colour in colours {
        (0..3).for_each(|c| sums[c] += f64::from(colour[c]));
        count += 1;
    }
    sums.map(|sum| (sum / count.max(1) as f64) as f32)
}
