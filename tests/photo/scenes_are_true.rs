//! What is measured against is what it claims to be.

use crate::scenes::{SIDE, photograph, twelve};

#[test]
fn scenes_are_the_same_each_time_and_show_a_whole_object_with_lines() {
    let scenes = twelve();
    assert_eq!(scenes.len(), 12);
    for scene in &scenes[5..7] {
        let photo = photograph(scene);
        assert_eq!(photo.rgb, photograph(scene).rgb, "{}", scene.name);
        let count = |lines: &[bool]| lines.iter().filter(|&&on| on).count();
        let share = count(&photo.mask) as f64 / (SIDE * SIDE) as f64;
        assert!((0.08..0.4).contains(&share), "{}: {share}", scene.name);
        let on_rim = (0..SIDE).any(|k| [k, k * SIDE, k * SIDE + SIDE - 1].iter().any(|&i| photo.mask[i]));
        assert!(!on_rim, "{} leaves the picture", scene.name);
        // An outline is at least as long as that of a disc of the same area; its pixels lie on the mask's border.
        let least = 2.0 * (std::f64::consts::PI * count(&photo.mask) as f64).sqrt();
        assert!(count(&photo.contours) as f64 > 0.9 * least, "{}", scene.name);
        assert!(count(&photo.creases) > 300, "{} has edges", scene.name);
    }
}

#[test]
fn a_mug_has_a_hole() {
    let photo = photograph(&twelve()[5]);
    let row = 290 * SIDE;
    let changes = (1..SIDE).filter(|&x| photo.mask[row + x] != photo.mask[row + x - 1]).count();
    assert_eq!(changes, 4, "cup, hole and handle");
}
