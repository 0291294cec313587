//! The ten pictures of `tests/strokes`: shaded solids, line art, a glyph, an emoji, flat shapes, a busy ground.
use std::path::Path;
use wire4d::picture::read_picture;
use wire4d::settings::Task;
use wire4d::tasks::Run;
use wire4d::tasks::stroke::{Given, plan};

#[test]
fn every_picture_reads_from_the_front_and_stays_within_its_solid() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/strokes");
    let mut pictures: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    pictures.sort();
    assert_eq!(pictures.len(), 10);
    let pairs = [("backend", "cpu"), ("preset", "fast"), ("iterations", "60"), ("size", "128"), ("side-views", "2")];
    let settings = Task::Stroke.settings(pairs).unwrap();
    let mut wrong = Vec::new();
    for path in pictures {
        assert!(std::fs::metadata(&path).unwrap().len() <= 30_000);
        let plan = plan(&Given::picture(read_picture(&path).unwrap()), &settings).unwrap();
        let mut run = Run::start(plan, &mut |_| true).unwrap();
        run.step(usize::MAX).unwrap();
        let result = run.result();
        let (front, sides) = (&result.views[0], &result.views[1..]);
        let stays = sides.iter().all(|side| side.precision_2px > Some(0.95));
        if front.soft_iou < Some(0.8) || !stays || result.shape.components != 1 {
            wrong.push(format!("{}: {:?} {} parts", path.display(), result.views, result.shape.components));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
