//! Drawings, bend lists and the choice of format.

mod export_support;

use export_support as wires;
use wire4d::export::{ExportOptions, Format, SvgOptions, bend_csv, export, svg};
use wire4d::mesh::{Depths, Shape};
use wire4d::sculpture::{Sculpture, Strand, render, render_seen};
use wire4d::view::{Image, Occluder, View};
use wire4d::wire::Wire;

/// Coverage of an SVG's one path by the non-zero rule, 8 x 8 samples a pixel.
fn draw(svg: &str, width: usize, height: usize) -> Image {
    let between = |start: &str, end: &str| {
        let from = svg.find(start).unwrap() + start.len();
        &svg[from..from + svg[from..].find(end).unwrap()]
    };
    let unit: f64 = between("scale(", ")").parse().unwrap();
    let samples = 8;
    let (columns, rows) = (width * samples, height * samples);
    let mut winding = vec![0i32; columns * rows];
    let mut pen = [0i64; 2];
    for polygon in between("d=\"", "\"").split('z').filter(|polygon| !polygon.is_empty()) {
        let spaced = polygon.replace(['m', 'l'], " ").replace('-', " -");
        let numbers: Vec<i64> = spaced.split_whitespace().map(|number| number.parse().unwrap()).collect();
        let mut points = vec![];
        for step in numbers.chunks_exact(2) {
            pen = [pen[0] + step[0], pen[1] + step[1]];
            points.push(pen.map(|c| c as f64 * unit * samples as f64));
        }
        pen = [pen[0] - numbers.chunks_exact(2).skip(1).map(|s| s[0]).sum::<i64>(), pen[1]];
        pen[1] -= numbers.chunks_exact(2).skip(1).map(|s| s[1]).sum::<i64>();
        for i in 0..points.len() {
            let ([x0, y0], [x1, y1]) = (points[i], points[(i + 1) % points.len()]);
            let sign = if y1 > y0 { 1 } else { -1 };
            let (low, high) = (y0.min(y1), y0.max(y1));
            for row in (low - 0.5).ceil().max(0.0) as usize..((high - 0.5).ceil().max(0.0) as usize).min(rows) {
                let y = row as f64 + 0.5;
                let x = x0 + (x1 - x0) * (y - y0) / (y1 - y0);
                for column in (x - 0.5).ceil().clamp(0.0, columns as f64) as usize..columns {
                    winding[row * columns + column] += sign;
                }
            }
        }
    }
    let mut image = Image::new(width, height);
    for (k, _) in winding.iter().enumerate().filter(|(_, winding)| **winding != 0) {
        image.data[k / columns / samples * width + k % columns / samples] += 1.0 / (samples * samples) as f32;
    }
    image
}

fn rms(a: &Image, b: &Image) -> f64 {
    let sum: f64 = a.data.iter().zip(&b.data).map(|(a, b)| f64::from(a - b).powi(2)).sum();
    (sum / a.data.len() as f64).sqrt()
}

#[test]
fn a_drawing_shows_what_the_view_shows() {
    for (name, wire) in wires::all() {
        for view in [View::canonical(2.2, 128)[1].clone(), wires::perspective().with_size(160, 128)] {
            let text = svg(&wire, &view, None, &SvgOptions::default());
            assert!(!text.contains("NaN") && !text.contains("inf"), "{name}");
            let (drawn, shown) = (draw(&text, view.width_px, view.height_px), render(&wire, &view));
            let difference = rms(&drawn, &shown);
            assert!(difference < 0.012, "{name}, {}: differs by {difference}", view.name);
        }
    }
}

#[test]
fn the_comparison_can_fail() {
    let view = &View::canonical(2.2, 128)[1];
    let text = svg(&wires::curl(), view, None, &SvgOptions::default());
    let shown = render(&wires::curl(), view);
    assert!(rms(&draw(&text, 128, 128), &shown) < 0.012);
    let mut shifted = shown.clone();
    shifted.data.rotate_right(1);
    assert!(rms(&draw(&text, 128, 128), &shifted) > 0.02, "one pixel to the right is seen");
    let mut holed = shown.clone();
    let inked: Vec<usize> = (0..holed.data.len()).filter(|&i| holed.data[i] > 0.9).take(20).collect();
    inked.iter().for_each(|&i| holed.data[i] = 0.0);
    assert!(rms(&draw(&text, 128, 128), &holed) > 0.02, "a hole is seen");
}

/// Round and round the sphere, from pole to pole and back, and from no side the same in front and behind.
fn round_a_sphere() -> Wire {
    let at = |i: usize| {
        let turn = i as f64 / 120.0 * std::f64::consts::TAU;
        let (height, around) = (0.9 * turn.cos(), 6.0 * turn + 0.8);
        let out = (1.0 - height * height).sqrt();
        [out * around.cos(), height, out * around.sin(), 0.03]
    };
    Wire::closed_uniform((0..120).map(at).collect()).unwrap()
}

#[test]
fn a_drawing_leaves_out_what_a_solid_hides() {
    let (wire, sphere) = (round_a_sphere(), Shape::named("sphere").unwrap().mesh());
    for view in [View::canonical(2.2, 256)[0].clone(), wires::perspective().with_size(320, 256)] {
        let occluder = |view: &View| Occluder::new(Depths::render(&sphere, view).widened());
        let drawn = |occluder: Option<&Occluder>| svg(&wire, &view, occluder, &SvgOptions::default());
        let coarse = occluder(&view);
        let fine = occluder(&view.with_size(3 * view.width_px, 3 * view.height_px));
        let (text, all) = (drawn(Some(&coarse)), drawn(None));
        let shown = render_seen(&wire, &view, &coarse);
        let off = |text: &str| rms(&draw(text, view.width_px, view.height_px), &shown);
        let (same, finer, bare) = (off(&text), off(&drawn(Some(&fine))), off(&all));
        // Along the silhouette strands end elsewhere by a pixel where depths are finer.
        assert!(same < 0.03 && finer < bare / 2.0 && bare > 0.1, "{}: differs by {same}, {finer}, {bare}", view.name);
    }
}

#[test]
fn drawings_are_small_and_sized_like_the_view() {
    let view = wires::perspective();
    let text = svg(&wires::smooth(1, 220), &view, None, &SvgOptions { ground: true, ..SvgOptions::default() });
    assert!(text.starts_with("<svg ") && text.trim_end().ends_with("</svg>"));
    assert!(text.contains("viewBox=\"0 0 320 256\"") && text.contains("<rect"));
    assert!(!svg(&wires::helix(), &view, None, &SvgOptions::default()).contains("<rect"));
    assert!(text.len() < 60_000, "{} bytes", text.len());
}

/// The list's own lengths, rotations and bends, followed from its first two points, lead along its points.
#[test]
fn a_bend_list_leads_along_the_wire() {
    use glam::{DQuat, DVec3};
    for (name, wire) in wires::all() {
        let sculpture = wires::sculpture(wire);
        let text =
            String::from_utf8(export(&sculpture, Format::BendCsv, None, None, &ExportOptions::default()).unwrap());
        let text = text.unwrap();
        let rows: Vec<Vec<f64>> = text
            .lines()
            .skip(1)
            .filter(|line| line.starts_with("1,"))
            .map(|line| line.split(',').map(|field| field.parse().unwrap_or(f64::NAN)).collect())
            .collect();
        let point = |i: usize| DVec3::new(rows[i][2], rows[i][3], rows[i][4]);
        let bends = rows.iter().filter(|row| row[8] > 0.0).count();
        if rows.len() < 4 || bends < 2 || name == "closed flat" || name == "there and back" {
            continue;
        }
        let mut direction = (point(1) - point(0)).normalize();
        let mut at = point(0);
        let mut axis: Option<DVec3> = None;
        let mut last = 0.0f64;
        for i in 1..rows.len() {
            at += direction * rows[i][6];
            last = at.distance(point(i));
            assert!(last < 1.5, "{name}: point {i} of {} is {last} mm off", rows.len());
            let turned = match axis {
                Some(axis) => DQuat::from_axis_angle(direction, rows[i][7].to_radians()) * axis,
                None if i + 1 < rows.len() => direction.cross(point(i + 1) - point(i)).normalize_or(DVec3::Z),
                None => DVec3::Z,
            };
            if rows[i][8] > 0.0 {
                axis = Some(turned);
                direction = (DQuat::from_axis_angle(turned, rows[i][8].to_radians()) * direction).normalize();
            }
        }
        assert!(last < 1.5, "{name}");
    }
}

#[test]
fn a_right_angle_is_a_right_angle() {
    let corner = Strand {
        points: vec![[0.0, 0.0, 0.0, 0.1], [1.0, 0.0, 0.0, 0.1], [1.0, 1.0, 0.0, 0.1], [1.0, 1.0, 1.0, 0.1]],
        closed: false,
    };
    let text = bend_csv(&[corner], 10.0, 0.1);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 5);
    assert_eq!(lines[2], "1,2,10.000,0.000,0.000,1.000,10.000,0.00,90.00,5.000");
    assert_eq!(lines[3], "1,3,10.000,10.000,0.000,1.000,10.000,90.00,90.00,5.000");
    assert_eq!(lines[4], "1,4,10.000,10.000,10.000,1.000,10.000,0.00,0.00,");
}

#[test]
fn prints_have_the_size_and_thickness_asked_for() {
    for (name, wire) in wires::all() {
        let sculpture = wires::sculpture(wire);
        let options = ExportOptions { object_size_mm: 80.0, min_radius_mm: 0.8, ..ExportOptions::default() };
        let file = export(&sculpture, Format::Stl, None, None, &options).unwrap();
        let corner = |t: usize, k: usize, c: usize| {
            let at = 84 + 50 * t + 12 * (k + 1) + 4 * c;
            f64::from(f32::from_le_bytes(file[at..at + 4].try_into().unwrap()))
        };
        let count = (file.len() - 84) / 50;
        let extent = |c: usize| {
            let values = || (0..count).flat_map(|t| (0..3).map(move |k| (t, k))).map(|(t, k)| corner(t, k, c));
            values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min)
        };
        let longest = (0..3).map(extent).fold(0.0, f64::max);
        assert!((longest / 80.0 - 1.0).abs() < 0.05, "{name}: {longest} mm");
    }
}

#[test]
fn formats_go_by_ending() {
    for (path, format) in [
        ("a.glb", Format::Glb),
        ("out/b.STL", Format::Stl),
        ("c.obj", Format::Obj),
        ("d.svg", Format::Svg),
        ("e.bend.csv", Format::BendCsv),
        ("dir.x/wire.json", Format::WireJson),
        ("f.wire.json", Format::WireJson),
    ] {
        assert_eq!(Format::from_path(path).unwrap(), format, "{path}");
    }
    for path in ["", "glb", "a.gltf", "a.csv", "a.json", "x.glb/", "noglb", "mywire.json"] {
        let line = Format::from_path(path).unwrap_err().to_string();
        assert!(line.contains(".glb, .stl, .obj, .svg, .bend.csv, .wire.json"), "{line}");
    }
}

#[test]
fn every_format_is_written_and_bad_sizes_are_refused() {
    let sculpture = wires::sculpture(wires::trefoil());
    for (format, ending) in Format::ALL {
        let bytes = export(&sculpture, format, None, None, &ExportOptions::default()).unwrap();
        assert!(bytes.len() > 500, "{ending}");
    }
    let json = export(&sculpture, Format::WireJson, None, None, &ExportOptions::default()).unwrap();
    assert_eq!(Sculpture::from_json("wire.json", &json).unwrap(), sculpture);
    for size in [0.0, -1.0, f64::NAN, 1e9] {
        let options = ExportOptions { object_size_mm: size, ..ExportOptions::default() };
        let line = export(&sculpture, Format::Stl, None, None, &options).unwrap_err().to_string();
        assert!(line.contains("object_size_mm"), "{line}");
    }
}
