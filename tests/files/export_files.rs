//! Drawings, bend lists and the choice of format.

use crate::export_support;

use export_support as wires;
use wire4d::export::{ExportOptions, Format, SvgOptions, bend_csv, export, lines, svg};
use wire4d::mesh::{Depths, Shape};
use wire4d::sculpture::{Sculpture, Strand, render, render_seen, strands};
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

/// Points of each path of a file of centre lines, px, and how many millimetres a px is.
fn paths(svg: &str) -> (Vec<Vec<[f64; 2]>>, f64) {
    let between = |text: &str, start: &str, end: &str| {
        let from = text.find(start).unwrap() + start.len();
        text[from..from + text[from..].find(end).unwrap()].to_owned()
    };
    let numbers = |text: &str| -> Vec<f64> {
        let spaced = text.replace(['M', 'L', 'Z'], " ");
        spaced.split_whitespace().map(|number| number.parse().unwrap()).collect()
    };
    let view_box = numbers(&between(svg, "viewBox=\"", "\""));
    let width_mm: f64 = between(svg, "width=\"", "mm\"").parse().unwrap();
    let path = |line: &str| {
        let data = between(line, "d=\"", "\"");
        let mut points: Vec<[f64; 2]> = numbers(&data).chunks_exact(2).map(|p| [p[0], p[1]]).collect();
        points.extend(data.ends_with('Z').then(|| points[0]));
        points
    };
    (svg.lines().filter(|line| line.starts_with("<path")).map(path).collect(), width_mm / view_box[2])
}

fn stroke_px(svg: &str) -> f64 {
    let from = svg.find("stroke-width=\"").unwrap() + 14;
    svg[from..from + svg[from..].find('"').unwrap()].parse().unwrap()
}

fn length(points: &[[f64; 2]]) -> f64 {
    points.windows(2).map(|ends| (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1])).sum()
}

#[test]
fn centre_lines_are_one_path_as_long_as_the_wire_looks_and_of_real_size() {
    let field = std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/field/key-and-house.wire.json")).unwrap();
    let field = Sculpture::from_json("field", &field).unwrap();
    let all = wires::all().into_iter().map(|(name, wire)| (name, wires::sculpture(wire)));
    for (name, sculpture) in all.chain([("field", field)]) {
        for view in [View::canonical(2.2, 256)[1].clone(), wires::perspective()] {
            let options = ExportOptions { object_size_mm: 120.0, ..ExportOptions::default() };
            let text = String::from_utf8(export(&sculpture, Format::Lines, Some(&view), None, &options).unwrap());
            let text = text.unwrap();
            let (paths, mm_per_px) = paths(&text);
            let camera = view.camera::<f64>();
            let mut expected = 0.0;
            let shown = strands(&sculpture.wire, 200);
            for Strand { points, closed } in &shown {
                let mut flat: Vec<[f64; 2]> =
                    points.iter().map(|p| camera.project(p)).map(|[x, y, _]| [x, y]).collect();
                flat.extend(closed.then(|| flat[0]));
                expected += length(&flat);
            }
            assert_eq!(paths.len(), shown.len(), "{name}");
            let drawn: f64 = paths.iter().map(|path| length(path)).sum();
            assert!((drawn - expected).abs() < 0.01 * expected + 1e-9, "{name}: {drawn} px of {expected}");
            let extent = |c: usize| {
                let ends = paths.iter().flatten().fold((f64::MAX, f64::MIN), |(a, b), p| (a.min(p[c]), b.max(p[c])));
                (ends.1 - ends.0) * mm_per_px
            };
            let longest = extent(0).max(extent(1)) + stroke_px(&text) * mm_per_px;
            assert!(expected < 1e-9 || (longest - 120.0).abs() < 0.1, "{name}: {longest} mm");
            let (_, lines) = text.split_once("</metadata>").unwrap();
            assert_eq!(lines.matches('Z').count(), shown.iter().filter(|strand| strand.closed).count());
        }
    }
}

#[test]
fn centre_lines_end_where_a_solid_hides_them() {
    let (wire, sphere) = (round_a_sphere(), Shape::named("sphere").unwrap().mesh());
    let view = View::canonical(2.2, 256)[0].clone();
    let occluder = Occluder::new(Depths::render(&sphere, &view).widened());
    let (bare, hidden) =
        (paths(&lines(&wire, &view, None, 100.0)).0, paths(&lines(&wire, &view, Some(&occluder), 100.0)).0);
    let sum = |paths: &[Vec<[f64; 2]>]| paths.iter().map(|path| length(path)).sum::<f64>();
    assert_eq!(bare.len(), 1);
    // Twelve turns there and back, of each of which the front half is seen.
    assert!((8..=26).contains(&hidden.len()), "{} stretches", hidden.len());
    assert!((0.42..0.62).contains(&(sum(&hidden) / sum(&bare))), "{} of {}", sum(&hidden), sum(&bare));
}

#[test]
fn centre_lines_are_as_wide_as_the_wire_where_it_has_one_width_and_blank_where_nothing_shows() {
    let view = View::canonical(2.2, 256)[0].clone();
    let stroke = |wire: &Wire| stroke_px(&lines(wire, &view, None, 100.0));
    let ring = |width: fn(f64) -> f64| {
        let point = |i: i32| f64::from(i) / 40.0 * std::f64::consts::TAU;
        let points = (0..40).map(point).map(|a| [a.cos(), a.sin(), 0.0, width(a)]);
        Wire::closed_uniform(points.collect()).unwrap()
    };
    let px = 256.0 / 2.2;
    assert!((stroke(&ring(|_| 0.04)) - 0.04 * px).abs() < 0.01);
    assert!((stroke(&ring(|a| 0.04 + 0.02 * a.sin())) - 0.02 * px).abs() < 0.05);
    // Inside the sphere.
    let small = ring(|_| 0.04).control_points().iter().map(|&[x, y, z, w]| [0.3 * x, 0.3 * y, z, w]).collect();
    let sphere = Occluder::new(Depths::render(&Shape::named("sphere").unwrap().mesh(), &view).widened());
    let blank = lines(&Wire::closed_uniform(small).unwrap(), &view, Some(&sphere), 100.0);
    assert!(blank.starts_with("<svg ") && !blank.contains("<path") && !blank.contains("NaN"), "{blank}");
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
        assert!(line.contains(".glb, .stl, .obj, .lines.svg, .svg, .bend.csv, .wire.json"), "{line}");
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
        assert!(line.contains("size in mm"), "{line}");
    }
}
