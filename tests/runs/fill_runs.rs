//! Covering a mesh from end to end: one closed wire that stays on the surface, shows what it should and repeats itself.

use wire4d::mesh::Shape;
use wire4d::picture::Pattern;
use wire4d::settings::{Flow, Preset, Settings, Task};
use wire4d::tasks::Run;
use wire4d::tasks::fill::{self, Given, Plan, Style};
use wire4d::view::Image;

/// Coarse and small, so that a run takes a moment.
fn settings() -> Settings {
    Settings {
        curve_spacing: 0.16,
        size: 96,
        iterations: 40,
        views_at_once: 1,
        max_width: 16.0,
        style_strength: 1.0,
        ..Task::Fill.preset(Preset::Best)
    }
}

fn given(pattern: Option<Pattern>) -> Given {
    let style = |pattern: Pattern| Style { name: pattern.name().into(), ink: pattern.picture(256), tiles: true };
    Given { style: pattern.map(style), ..Given::shape(Shape::Torus) }
}

fn plan(given: &Given, settings: &Settings) -> Plan {
    fill::plan(given, settings, &mut |_| true).unwrap().expect("nobody stopped it")
}

fn finished(given: &Given, settings: &Settings) -> Run {
    let mut run = Run::start(plan(given, settings), &mut |_| true).unwrap();
    run.step(usize::MAX).unwrap();
    run
}

fn ink(picture: &Image) -> f32 {
    picture.data.iter().sum()
}

#[test]
fn one_closed_wire_stays_on_the_surface() {
    let run = finished(&given(Some(Pattern::Petals)), &settings());
    let result = run.result();
    assert!(run.sculpture().wire.closed());
    assert_eq!(result.shape.components, 1);
    let surface = result.surface.expect("a report about the surface");
    assert!(surface.drift_max < settings().visibility_bias, "{}", surface.drift_max);
    assert!(surface.drift_mean < 0.1 * surface.spacing, "{}", surface.drift_mean);
    assert!((surface.area - 8.26).abs() < 0.1, "{}", surface.area);
    assert!(run.report(Default::default(), false).task == "fill");
}

#[test]
fn the_same_seed_gives_the_same_wire_however_often_it_is_interrupted() {
    let (given, settings) = (given(Some(Pattern::Waves)), settings());
    let whole = finished(&given, &settings).sculpture().wire;
    let mut run = Run::start(plan(&given, &settings), &mut |_| true).unwrap();
    // Between two times that tangent planes are taken, and in the middle of a round of sides.
    run.step(13).unwrap();
    let saved = run.checkpoint();
    let mut resumed = Run::resume(plan(&given, &settings), &saved, &mut |_| true).unwrap();
    resumed.step(usize::MAX).unwrap();
    assert!(resumed.sculpture().wire == whole);
    assert!(finished(&given, &Settings { seed: 1, ..settings }).sculpture().wire != whole);
    let other = Settings { density: 0.9, ..self::settings() };
    assert!(Run::resume(plan(&given, &other), &saved, &mut |_| true).is_err(), "another picture is asked for");
}

#[test]
fn more_density_is_more_ink_and_what_lies_behind_does_not_show() {
    let settings = settings();
    let shown = |density: f64| {
        let run = finished(&given(None), &Settings { density, ..settings.clone() });
        ink(&run.draw(&run.sculpture().wire, 0))
    };
    let [little, much] = [0.25, 0.7].map(shown);
    assert!(much > 1.5 * little, "{little} {much}");
    let run = finished(&given(None), &Settings { hidden_lines: true, ..settings.clone() });
    let wire = run.sculpture().wire;
    let all = ink(&run.draw(&wire, 0));
    let front = ink(&finished(&given(None), &settings).draw(&wire, 0));
    assert!(front < 0.75 * all, "{front} of {all}");
}

/// How alike two pictures are where `inside` is, -1 to 1, on a scale at which lines blur into tones.
fn correlation(a: &Image, b: &Image, inside: &Image) -> f64 {
    let blurred = [a, b].map(|image| image.blurred(0.03 * image.width as f64));
    let pairs =
        || (0..a.data.len()).filter(|&i| inside.data[i] > 0.0).map(|i| [0, 1].map(|k| f64::from(blurred[k].data[i])));
    let count = pairs().count() as f64;
    let mean = [0, 1].map(|k| pairs().map(|pair| pair[k]).sum::<f64>() / count);
    let moment = |j: usize, k: usize| pairs().map(|pair| (pair[j] - mean[j]) * (pair[k] - mean[k])).sum::<f64>();
    moment(0, 1) / (moment(0, 0) * moment(1, 1)).sqrt()
}

#[test]
fn a_styles_picture_shows_and_another_does_not() {
    let settings = Settings { curve_spacing: 0.08, iterations: 160, flow: Flow::Style, ..settings() };
    let petals = finished(&given(Some(Pattern::Petals)), &settings);
    let target = &petals.targets()[0].ink;
    let likeness = |run: &Run| correlation(&run.draw(&run.sculpture().wire, 0), target, target);
    let (own, plain) = (likeness(&petals), likeness(&finished(&given(None), &settings)));
    let other = likeness(&finished(&given(Some(Pattern::Waves)), &settings));
    assert!(own > 0.3 && own > 2.5 * plain.max(other), "{own} {plain} {other}");
}

#[test]
fn covering_can_be_stopped_and_bad_settings_are_refused() {
    assert!(fill::plan(&given(None), &settings(), &mut |_| false).unwrap().is_none());
    let refused =
        |settings: Settings| fill::plan(&given(None), &settings, &mut |_| true).err().map(|error| error.to_string());
    assert!(refused(Settings { start: wire4d::settings::Start::Tree, ..settings() }).unwrap().contains("stripes"));
    let blank =
        Given { style: Some(Style { name: "blank.png".into(), ink: Image::new(64, 64), tiles: false }), ..given(None) };
    let error = fill::plan(&blank, &settings(), &mut |_| true).err().map(|error| error.to_string());
    assert!(error.is_some_and(|words| words.contains("blank.png")));
}
