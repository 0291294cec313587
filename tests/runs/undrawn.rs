//! Views that nobody drew: something else guides them, and they are compared with nothing.

use wire4d::objective::{Guidance, Progress, Rendered};
use wire4d::optimize::Work;
use wire4d::settings::{Settings, Task};
use wire4d::tasks::Run;
use wire4d::tasks::multiview::{Drawing, Plan, plan_with};
use wire4d::view::{Image, ViewSpec};
use wire4d::{Error, Result};

const SIDE: usize = 64;
/// Weight of what guides.
const PULL: f32 = 0.5;

/// Wants the ink of one view in its upper half: the loss is the share that is not, weighted as the view is.
struct Up(usize);

impl Guidance for Up {
    fn guide<'a>(&'a mut self, views: &'a mut [Rendered], _: Progress) -> Work<'a, Result<f32>> {
        let view = &mut views[self.0];
        let weight = view.guided_weight() / view.coverage.len() as f32;
        let sign = |pixel: usize| if pixel < view.coverage.len() / 2 { -weight } else { weight };
        let loss = view.coverage.iter().enumerate().map(|(pixel, ink)| sign(pixel) * ink).sum();
        view.gradient = (0..view.coverage.len()).map(sign).collect();
        Work::Done(Ok(loss))
    }
}

fn settings(more: &[(&str, &str)]) -> Settings {
    let small = [("preset", "fast"), ("size", "64"), ("grid", "32"), ("iterations", "60"), ("backend", "cpu")];
    Task::Multiview.settings(small.iter().chain(more).copied().collect::<Vec<_>>()).unwrap()
}

fn planned(drawings: &[Drawing], others: &[&str], settings: &Settings) -> Result<Plan> {
    let others: Vec<ViewSpec> = others.iter().map(|view| view.parse().unwrap()).collect();
    plan_with(drawings, &others, settings)
}

fn disc(name: &str) -> Drawing {
    let ring = |i: usize| {
        let (x, y) = ((i % SIDE) as f64 - 31.5, (i / SIDE) as f64 - 31.5);
        if (x.hypot(y) - 22.0).abs() < 1.0 { 255 } else { 0 }
    };
    Drawing::from_ink(name, SIDE, SIDE, &(0..SIDE * SIDE).map(ring).collect::<Vec<u8>>()).unwrap()
}

/// Of the ink, the share in the upper half.
fn upper(picture: &Image) -> f32 {
    let sum = |ink: &[f32]| ink.iter().sum::<f32>();
    sum(&picture.data[..picture.data.len() / 2]) / sum(&picture.data)
}

fn run_of(plan: Plan, guided: Option<usize>) -> Run {
    let mut run = Run::start(plan, &mut |_| true).unwrap();
    if let Some(view) = guided {
        run.guide_by("up", PULL, Box::new(Up(view)));
    }
    run.step(usize::MAX).unwrap();
    run
}

#[test]
fn a_wire_without_a_drawing_starts_as_a_ring_and_goes_where_it_is_guided() {
    let settings = settings(&[]);
    let run = |guided| run_of(planned(&[], &["front", "45,20"], &settings).unwrap(), guided);
    let (free, guided) = (run(None), run(Some(1)));
    let shown = |run: &Run, view| upper(&run.draw(&run.sculpture().wire, view));
    assert!((0..2).all(|view| (shown(&free, view) - 0.5).abs() < 0.05), "nothing pulls a ring aside");
    assert!(shown(&guided, 1) > 0.7, "{}", shown(&guided, 1));
    let (made, result) = (guided.sculpture(), guided.result());
    assert!(made.wire.closed() && made.views.iter().map(|view| view.name.as_str()).eq(["front", "45,20"]));
    assert!(result.views.iter().all(|view| view.soft_iou.is_none()) && result.length_over_lines.is_none());
    assert!(result.shape.length > 0.5 && guided.session().history().rows().all(|row| row[1..3] == [0.0; 2]));
    assert!(!guided.is_compared(0) && guided.placed(0).source.is_none());
}

#[test]
fn views_are_guided_beside_drawings_and_resumed_bit_for_bit() {
    for (drawings, others, undrawn) in
        [(vec![disc("a")], ["side", "front"], 1), (vec![disc("a"), disc("b")], ["top", "side"], 2)]
    {
        let settings = settings(&[("bend", "little")]);
        let plan = || planned(&drawings, &others, &settings).unwrap();
        let whole = run_of(plan(), Some(undrawn));
        let views = whole.result().views;
        assert_eq!(views.len(), undrawn + 1, "views that are drawn already are not added");
        assert!(views[0].recall_2px.unwrap() > 0.8, "{:?}", views[0]);
        assert!(views[undrawn].soft_iou.is_none() && views[undrawn].bent.is_none());
        assert_eq!(whole.bent().unwrap().len(), views.len());
        let plain = run_of(plan(), None);
        let shown = |run: &Run| upper(&run.draw(&run.sculpture().wire, undrawn));
        assert!(shown(&whole) > shown(&plain) + 0.02, "{} and {}", shown(&whole), shown(&plain));

        let mut begun = Run::start(plan(), &mut |_| true).unwrap();
        begun.guide_by("up", PULL, Box::new(Up(undrawn)));
        begun.step(31).unwrap();
        let mut resumed = Run::resume(plan(), &begun.checkpoint(), &mut |_| true).unwrap();
        resumed.guide_by("up", PULL, Box::new(Up(undrawn)));
        resumed.step(usize::MAX).unwrap();
        assert_eq!(resumed.sculpture(), whole.sculpture());
    }
}

#[test]
fn the_papers_ball_starts_again_where_it_vanished_without_a_drawing_too() {
    let settings = settings(&[("preset", "paper"), ("iterations", "30"), ("control-points", "40")]);
    let run = run_of(planned(&[], &["front", "side", "top"], &settings).unwrap(), Some(0));
    assert!(!run.sculpture().wire.closed() && run.sculpture().wire.control_points().len() > 40, "refined");
}

#[test]
fn sides_that_nobody_knows_or_names_twice_are_refused() {
    let settings = settings(&[]);
    let refused = |drawings: &[Drawing], others: &[&str]| planned(drawings, others, &settings).map(|_| ()).unwrap_err();
    assert!(refused(&[], &["back"]).to_string().contains("back"));
    assert!(refused(&[], &["side", "90,0"]).to_string().contains("twice"));
    assert!(matches!(refused(&[disc("a")], &[]), Error::Pictures { .. }));
}
