//! The rasteriser against stored scenes with exact coverage and gradient (float64 integration over 987 points a pixel,
//! boundary integral). Files: `NAME.json` the Béziers and the gradient; `NAME.coverage` deflated u16, 65535 = 1;
//! `NAME.adjoint` deflated i16 in `adjoint_unit`, given where the outline may be.

use wire4d::raster::flatten::{FlatStroke, Subdivision};
use wire4d::raster::{BandRaster, ExactRaster, Raster};

const SCENES: [&str; 3] = ["n100_s128_x1", "n220_s256_x1", "n100_s512_x1"];

struct Reference {
    size: usize,
    control: Vec<[f32; 3]>,
    coverage: Vec<f32>,
    adjoint: Vec<f32>,
    d_control: Vec<[f32; 3]>,
}

fn load(name: &str) -> Reference {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/raster/");
    let read = |ending: &str| std::fs::read(format!("{folder}{name}.{ending}")).unwrap();
    let json: serde_json::Value = serde_json::from_slice(&read("json")).unwrap();
    let number = |value: &serde_json::Value| value.as_f64().unwrap() as f32;
    let triples = |points: &str, radius: &str| -> Vec<[f32; 3]> {
        let (points, radius) = (json[points].as_array().unwrap(), json[radius].as_array().unwrap());
        points.iter().zip(radius).map(|(p, r)| [number(&p[0]), number(&p[1]), number(r)]).collect()
    };
    let inflate = |ending: &str| miniz_oxide::inflate::decompress_to_vec(&read(ending)).unwrap();
    let pairs = |bytes: Vec<u8>| bytes.chunks(2).map(|b| [b[0], b[1]]).collect::<Vec<_>>();
    let unit = number(&json["adjoint_unit"]);
    Reference {
        size: json["size"].as_u64().unwrap() as usize,
        control: triples("bezier_points", "bezier_radius"),
        coverage: pairs(inflate("coverage")).iter().map(|&b| f32::from(u16::from_le_bytes(b)) / 65535.0).collect(),
        adjoint: pairs(inflate("adjoint")).iter().map(|&b| f32::from(i16::from_le_bytes(b)) * unit).collect(),
        d_control: triples("d_points", "d_radius"),
    }
}

/// Root mean square and worst error over edge pixels.
fn coverage_error(found: &[f32], exact: &[f32]) -> (f64, f64) {
    let edge = found.iter().zip(exact).filter(|(_, c)| (0.001..0.999).contains(*c));
    let errors: Vec<f64> = edge.map(|(a, b)| f64::from(a - b).abs()).collect();
    let square = errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64;
    (square.sqrt(), errors.iter().fold(0.0, |m, &e| e.max(m)))
}

/// Relative L2 distance and cosine of some components.
fn gradient_error(found: &[[f32; 3]], exact: &[[f32; 3]], components: std::ops::Range<usize>) -> (f64, f64) {
    let (mut difference, mut product, mut norm_found, mut norm_exact) = (0.0, 0.0, 0.0, 0.0);
    for (f, e) in found.iter().zip(exact) {
        for c in components.clone() {
            let (f, e) = (f64::from(f[c]), f64::from(e[c]));
            difference += (f - e) * (f - e);
            product += f * e;
            norm_found += f * f;
            norm_exact += e * e;
        }
    }
    ((difference / norm_exact).sqrt(), product / (norm_found * norm_exact).sqrt())
}

#[test]
fn coverage_and_both_gradients_match_the_stored_scenes() {
    let (mut raster, mut flat) = (ExactRaster::new(), FlatStroke::new());
    let (mut d_vertices, mut d_control) = (Vec::new(), Vec::new());
    for name in SCENES {
        let reference = load(name);
        flat.flatten(&reference.control, true, Subdivision::Tolerance(0.02));
        let image = raster.forward(reference.size, reference.size, flat.vertices(), &flat.strokes());
        let (rms, worst) = coverage_error(image, &reference.coverage);
        println!("{name}: {} pieces, edge rms {rms:.4}, worst {worst:.3}", flat.vertices().len());
        assert!(rms <= 0.005 && worst < 0.12, "{name}: rms {rms} worst {worst}");
        raster.backward(&reference.adjoint, &mut d_vertices);
        for form in ["vertex", "moments"] {
            match form {
                "vertex" => flat.pull_back(&d_vertices, &mut d_control),
                _ => flat.pull_back_moments(&raster, &reference.adjoint, &mut d_control),
            }
            let (points, cosine) = gradient_error(&d_control, &reference.d_control, 0..2);
            let (radius, _) = gradient_error(&d_control, &reference.d_control, 2..3);
            println!("  {form}: points {:.2}% ({cosine:.5}), radii {:.2}%", 100.0 * points, 100.0 * radius);
            assert!(points <= 0.05 && cosine > 0.998 && radius <= 0.02, "{name}, {form}: {points} {cosine} {radius}");
        }
    }
}

#[test]
fn the_plain_band_does_not_match() {
    let reference = load(SCENES[0]);
    let (mut raster, mut flat) = (BandRaster::new(), FlatStroke::new());
    flat.flatten(&reference.control, true, Subdivision::Tolerance(0.02));
    let image = raster.forward(reference.size, reference.size, flat.vertices(), &flat.strokes());
    let (rms, _) = coverage_error(image, &reference.coverage);
    assert!(rms > 0.02, "the comparison would accept the distance band: {rms}");
    let (mut d_vertices, mut d_control) = (Vec::new(), Vec::new());
    raster.backward(&reference.adjoint, &mut d_vertices);
    flat.pull_back(&d_vertices, &mut d_control);
    let (points, _) = gradient_error(&d_control, &reference.d_control, 0..2);
    assert!(points > 0.2, "the comparison would accept the distance band: {points}");
}

#[test]
fn short_beziers_need_the_moments() {
    // Béziers of one or two pieces: vertices hardly see the inner control values, moments do.
    let reference = load(SCENES[0]);
    let mut quarter = Vec::new();
    for s in 0..reference.control.len() / 3 {
        let corner = |i: usize| reference.control[(3 * s + i) % reference.control.len()];
        quarter.push([corner(0), corner(1), corner(2), corner(3)]);
    }
    assert_eq!(quarter.len(), 100);
    let (mut raster, mut flat, mut d_control) = (ExactRaster::new(), FlatStroke::new(), Vec::new());
    let subdivide = |pieces: usize| -> Vec<[f32; 3]> {
        // de Casteljau at equal parameters, which keeps the curve.
        let mut control = Vec::new();
        for corners in &quarter {
            for j in 0..pieces {
                let (a, b) = (j as f32 / pieces as f32, (j + 1) as f32 / pieces as f32);
                let blossom = |t: [f32; 3]| -> [f32; 3] {
                    std::array::from_fn(|c| {
                        let mut p = [corners[0][c], corners[1][c], corners[2][c], corners[3][c]];
                        for (level, t) in t.into_iter().enumerate() {
                            for i in 0..3 - level {
                                p[i] += t * (p[i + 1] - p[i]);
                            }
                        }
                        p[0]
                    })
                };
                control.extend([blossom([a, a, a]), blossom([a, a, b]), blossom([a, b, b])]);
            }
        }
        control
    };
    let mut fine = FlatStroke::new();
    let mut exact = Vec::new();
    let short = subdivide(4);
    fine.flatten(&short, true, Subdivision::Fixed(3));
    raster.forward(reference.size, reference.size, fine.vertices(), &fine.strokes());
    fine.pull_back_moments(&raster, &reference.adjoint, &mut exact);

    let mut d_vertices = Vec::new();
    flat.flatten(&short, true, Subdivision::Tolerance(0.02));
    raster.forward(reference.size, reference.size, flat.vertices(), &flat.strokes());
    flat.pull_back_moments(&raster, &reference.adjoint, &mut d_control);
    let (moments, _) = gradient_error(&d_control, &exact, 0..2);
    raster.backward(&reference.adjoint, &mut d_vertices);
    flat.pull_back(&d_vertices, &mut d_control);
    let (vertex, _) = gradient_error(&d_control, &exact, 0..2);
    println!("short Béziers: moments {moments:.3}, vertex form {vertex:.3}");
    assert!(moments < 0.05 && vertex > 4.0 * moments, "moments {moments}, vertex form {vertex}");
}
