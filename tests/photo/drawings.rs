//! Lines drawn of the twelve photographs.

use crate::judge::PHOTOS;
use crate::photo_judge::{border, box_round, judged, mask, pixels, share_near};
use crate::scenes::SIDE;
use wire4d::picture::cut::{Cutter, Hints};
use wire4d::picture::drawing::{Budget, Kind, draw, draw_in_box};
use wire4d::view::Image;

/// What [`judged`] says of each: means of all.
fn figures(object: impl Fn(usize) -> Image) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for (k, (taken, photo)) in PHOTOS.iter().enumerate() {
        let lines = draw(photo, &object(k), Budget::default());
        let found = judged(&lines, taken);
        println!("{:20} precision, recall, outline {found:.3?}, {} lines", taken.name, lines.len());
        (0..3).for_each(|k| sums[k] += found[k] / 12.0);
    }
    println!("precision, recall, outline {sums:.3?}");
    sums
}

#[test]
fn lines_are_where_contours_and_creases_are() {
    let [precision, recall, outline] = figures(|k| mask(PHOTOS[k].0.mask.clone()).to_image());
    assert!(precision >= 0.90 && recall >= 0.87 && outline >= 0.95);
}

#[test]
fn with_a_box_alone_lines_are_nearly_as_good() {
    let [precision, recall, outline] = figures(|k| {
        let (taken, photo) = &PHOTOS[k];
        let hints = Hints { bounds: Some(box_round(&taken.mask, 0.12)), ..Hints::default() };
        Cutter::new(photo.clone()).cut(&hints).unwrap().mask
    });
    assert!(precision >= 0.82 && recall >= 0.78 && outline >= 0.95);
}

#[test]
fn a_budget_takes_what_says_most_first() {
    let (taken, photo) = &PHOTOS[9];
    let object = mask(taken.mask.clone()).to_image();
    let all = draw(photo, &object, Budget::Importance(0.0));
    let ten = draw(photo, &object, Budget::Lines(10));
    assert_eq!(ten, all[..10], "more lines are the same and then some");
    assert!(all.len() > 15 && all[0].kind == Kind::Outline);
    let inner = || all.iter().filter(|line| line.kind == Kind::Inner);
    assert!(inner().zip(inner().skip(1)).all(|(a, b)| a.importance >= b.importance));
    for line in &all {
        assert!(line.points.iter().flatten().all(|v| v.is_finite()) && line.points.len() > 1);
        let at_256 = line.width_px * 256.0 / SIDE as f32;
        assert!((3.0..=5.0).contains(&at_256) && (0.0..=1.0).contains(&line.importance));
    }
    let length = |most: f32| draw(photo, &object, Budget::Length(most)).iter().map(|line| line.length()).sum::<f32>();
    assert!(length(5.0) < length(7.0));
}

#[test]
fn nothing_is_drawn_of_nothing_and_a_box_has_no_outline() {
    let (taken, photo) = &PHOTOS[0];
    assert!(draw(photo, &Image::new(SIDE, SIDE), Budget::default()).is_empty());
    let lines = draw_in_box(photo, box_round(&taken.mask, 0.05), Budget::Lines(20));
    assert!(!lines.is_empty() && lines.iter().all(|line| line.kind == Kind::Inner));
    assert!(share_near(&border(&taken.mask), &pixels(&lines)) > 0.7, "the object's border is an edge too");
    // A mask that fills the picture has no outline either: nothing ends at the picture's rim.
    let full = Image { data: vec![1.0; SIDE * SIDE], ..Image::new(SIDE, SIDE) };
    assert!(draw(photo, &full, Budget::default()).iter().all(|line| line.kind == Kind::Inner));
}
