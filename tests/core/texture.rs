//! Textures of styles drawn by formula: what tells them apart, what does not, and a wire that follows one.

use std::sync::Arc;
use wire4d::Error;
use wire4d::objective::{Texture, TextureOptions};
use wire4d::optimize::{
    Adam, AdamOptions, CpuEngine, Engine, Picture, Scene, SceneView, State, Step, Term, term_count, wait,
};
use wire4d::rng::Rng;
use wire4d::view::{Image, View};
use wire4d::wire::Wire;

const TAU: f64 = std::f64::consts::TAU;

/// A picture with ink where `distance` to a line is less than half of `line`, both in pixels; starts at `at`.
fn draw(size: usize, at: [f64; 2], line: f64, distance: impl Fn(f64, f64) -> f64) -> Image {
    let ink = |i: usize| {
        let (x, y) = (at[0] + (i % size) as f64 + 0.5, at[1] + (i / size) as f64 + 0.5);
        (0.5 + 0.5 * line - distance(x, y)).clamp(0.0, 1.0) as f32
    };
    Image { width: size, height: size, data: (0..size * size).map(ink).collect() }
}

/// How far `value` is from a multiple of `period`.
fn off(value: f64, period: f64) -> f64 {
    (value - (value / period).round() * period).abs()
}

fn hatching(size: usize, at: [f64; 2], line: f64) -> Image {
    draw(size, at, line, |x, y| off(0.3 * x + 0.954 * y, 8.0))
}

fn waves(size: usize, at: [f64; 2], line: f64) -> Image {
    draw(size, at, line, |x, y| {
        let slope = 10.0 * TAU / 48.0 * (TAU * x / 48.0).cos();
        off(y + 10.0 * (TAU * x / 48.0).sin(), 8.0) / slope.hypot(1.0)
    })
}

/// Petals in rings round a grid's nodes.
fn flowers(size: usize, at: [f64; 2], line: f64) -> Image {
    draw(size, at, line, |x, y| {
        let (u, v) = (x - (x / 48.0).round() * 48.0, y - (y / 48.0).round() * 48.0);
        let petal = 0.62 + 0.38 * (2.5 * v.atan2(u) + 0.7 * (x / 48.0).round()).cos().abs();
        off(u.hypot(v) / petal, 8.0) * petal
    })
}

type Style = fn(usize, [f64; 2], f64) -> Image;
const STYLES: [(&str, Style); 3] = [("hatching", hatching), ("waves", waves), ("flowers", flowers)];

fn texture(image: &Image) -> Texture {
    Texture::of("style", image, &TextureOptions::default()).unwrap()
}

#[test]
fn crops_of_a_style_are_alike_and_styles_are_not() {
    let crops = |style: Style| [[0.0, 0.0], [331.0, 217.0]].map(|at| texture(&style(256, at, 3.0)));
    let textures = STYLES.map(|(name, style)| (name, crops(style)));
    for (name, [a, b]) in &textures {
        let own = a.distance(b).max(b.distance(a));
        for (other, [c, _]) in textures.iter().filter(|(other, _)| other != name) {
            let apart = a.distance(c);
            eprintln!("{name}: another crop {own:.3}, {other} {apart:.3}");
            assert!(apart > 4.0 * own && apart > 0.3, "{name} and {other}: {apart} against {own}");
        }
    }
}

#[test]
fn thin_lines_have_the_texture_of_thick_ones() {
    for (name, style) in &STYLES[1..] {
        let thick = texture(&style(256, [0.0; 2], 3.5));
        let mut faint = style(256, [90.0, 40.0], 1.5);
        faint.data.iter_mut().for_each(|ink| *ink *= 0.6);
        let apart = thick.distance(&texture(&faint));
        let other = STYLES.iter().filter(|(other, _)| other != name);
        let least = other.map(|(_, other)| thick.distance(&texture(&other(256, [0.0; 2], 3.5)))).fold(9.0, f64::min);
        assert!(apart < 0.5 * least, "{name}: {apart}, and another style {least}");
    }
}

#[test]
fn a_motif_can_be_scaled() {
    let options = |scale| TextureOptions { scale, ..TextureOptions::default() };
    let half = waves(256, [0.0; 2], 3.0).resized(128, 128);
    let whole = texture(&waves(256, [0.0; 2], 3.0));
    let doubled = Texture::of("style", &half, &options(2.0)).unwrap();
    let larger = Texture::of("style", &waves(256, [0.0; 2], 3.0), &options(2.0)).unwrap();
    let [back, apart] = [&doubled, &larger].map(|other| whole.distance(other));
    assert!(back < 0.2 * apart, "{back} and {apart}");
    assert_eq!(larger, Texture::of("again", &waves(256, [0.0; 2], 3.0), &options(2.0)).unwrap());
}

#[test]
fn what_has_no_texture_is_refused() {
    let of = |image: &Image, options: &TextureOptions| Texture::of("petals.png", image, options);
    let good = waves(256, [0.0; 2], 3.0);
    let even = |ink: f32| Image { width: 256, height: 256, data: vec![ink; 256 * 256] };
    let rotten = Image { width: 256, height: 256, data: vec![f32::NAN; 256 * 256] };
    let short = Image { width: 256, height: 256, data: vec![0.5; 100] };
    let default = TextureOptions::default();
    for image in [even(0.0), even(1.0), rotten, short, Image::new(0, 0), waves(40, [0.0; 2], 3.0)] {
        let error = of(&image, &default).unwrap_err();
        assert!(matches!(&error, Error::Picture { name, .. } if name == "petals.png"), "{error}");
    }
    let with = |scale: f64, finest, levels| of(&good, &TextureOptions { scale, finest, levels });
    assert!(matches!(with(0.1, 1, 3), Err(Error::Picture { .. })), "too small at that scale");
    assert!(matches!(with(20.0, 1, 3), Err(Error::Picture { .. })), "too large");
    for (scale, finest, levels) in [(f64::NAN, 1, 3), (0.0, 1, 3), (1.0, 99, 3), (1.0, 1, 0), (1.0, 1, 99)] {
        assert!(matches!(with(scale, finest, levels), Err(Error::Setting { .. })), "{scale}, {finest}, {levels}");
    }
    assert_eq!(with(1.0, 1, 8).unwrap().levels(), 3, "as many levels as the picture has room for");
}

/// A line to and fro over a view, shaken a little, and what it should look like.
fn scene(style: Style, size_px: usize) -> (Scene, State) {
    let view = View::orthographic("front", 0.0, 0.0, 2.0, size_px);
    let rows = size_px / 8 - 2;
    let mut rng = Rng::new(1, 1);
    let point = |i: usize| {
        let (row, k) = (i / 10, i % 10);
        let x = (k as f64 / 9.0 - 0.5) * 1.8 * if row % 2 == 0 { 1.0 } else { -1.0 };
        let y = (row as f64 / (rows - 1) as f64 - 0.5) * 1.8;
        [x + rng.range(-0.02, 0.02), y + rng.range(-0.02, 0.02), 0.0, 0.03]
    };
    let wire = Wire::open_uniform((0..10 * rows).map(point).collect()).unwrap();
    let target = Image { width: size_px, height: size_px, data: vec![0.3; size_px * size_px] };
    let views = vec![SceneView::new(view.camera(), target, 1.0)];
    let texture = Texture::of("style", &style(256, [0.0; 2], 3.0), &TextureOptions { finest: 0, ..Default::default() });
    let scene = Scene { texture: Some(Arc::new(texture.unwrap())), ..Scene::new(&wire, 4, views) };
    let points: Vec<[f32; 4]> = wire.control_points().iter().map(|point| point.map(|c| c as f32)).collect();
    (scene, State { adam: Adam::new(points.len()), points })
}

fn step(texture: f32) -> Step {
    Step {
        rates: [0.01, 0.01, 0.0, 1e-3],
        adam: AdamOptions::default(),
        level_ratio: 1.0,
        width_bounds: [0.02, 0.06],
        texture,
        loss_scale: 1.0,
        ..Step::default()
    }
}

#[test]
fn the_engine_s_gradient_agrees_with_differences() {
    let (scene, state) = scene(waves, 96);
    let mut engine = CpuEngine::new();
    wait(engine.load(scene).done());
    let (mut terms, mut gradient) = (vec![0.0; term_count(1)], Vec::new());
    let step = step(5.0);
    engine.evaluate_now(&state.points, &step, &mut terms, &mut gradient);
    assert!(terms[Term::Texture.at(1)] > 0.1, "{terms:?}");
    let mut rng = Rng::new(2, 2);
    let (mut squares, mut off, mut off_wrong) = (0.0, 0.0, 0.0);
    for _ in 0..12 {
        let direction: Vec<[f32; 4]> =
            state.points.iter().map(|_| std::array::from_fn(|_| rng.range(-1.0, 1.0) as f32)).collect();
        let mut at = |h: f32| {
            let moved: Vec<[f32; 4]> =
                (state.points.iter().zip(&direction)).map(|(p, d)| std::array::from_fn(|c| p[c] + h * d[c])).collect();
            engine.evaluate_now(&moved, &step, &mut terms, &mut Vec::new());
            f64::from(terms[0])
        };
        let h = 4e-4;
        let slope = (at(h) - at(-h)) / f64::from(2.0 * h);
        let dot = gradient.as_flattened().iter().zip(direction.as_flattened());
        let found: f64 = dot.map(|(g, d)| f64::from(g * d)).sum();
        squares += slope * slope;
        off += (slope - found).powi(2);
        off_wrong += (slope - 1.2 * found).powi(2);
    }
    let [off, off_wrong] = [off, off_wrong].map(|off: f64| (off / squares).sqrt());
    eprintln!("off by {off:.3}, a gradient that is too large by a fifth {off_wrong:.3}");
    assert!(off < 0.06 && off_wrong > 0.1, "{off} and {off_wrong}");
}

#[test]
fn a_wire_follows_the_style_it_is_given() {
    let textures = [waves as Style, flowers].map(|style| {
        let (scene, mut state) = scene(style, 96);
        let target = scene.texture.clone().unwrap();
        let mut engine = CpuEngine::new();
        wait(engine.load(scene).done());
        let (mut terms, mut gradient) = (vec![0.0; term_count(1)], Vec::new());
        let step = step(1.0);
        let mut losses = Vec::new();
        for _ in 0..80 {
            engine.evaluate_now(&state.points, &step, &mut terms, &mut gradient);
            losses.push(terms[Term::Texture.at(1)]);
            state.step(&step, &gradient);
        }
        assert!(losses[79] < 0.6 * losses[0], "from {} to {}", losses[0], losses[79]);
        let drawn = engine.picture(Picture::Coverage, 0);
        let image = Image { width: 96, height: 96, data: drawn.to_vec() };
        let options = TextureOptions { finest: 0, ..TextureOptions::default() };
        (target, Texture::of("drawn", &image, &options).unwrap())
    });
    let [(waves, as_waves), (flowers, as_flowers)] = &textures;
    assert!(waves.distance(as_waves) < waves.distance(as_flowers), "waves");
    assert!(flowers.distance(as_flowers) < flowers.distance(as_waves), "flowers");
}
