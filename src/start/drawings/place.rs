//! Drawings in views of any direction: upright, as given, each as large as the common frame allows.

use super::arrange::{Arrangement, Cutouts, Drawing, FILLED, Placement, Sharing};
use super::orientation::Orientation;
use crate::error::{Error, Result};
use crate::view::{Target, View, ViewSpec};

/// Places each drawing in the view it names, `None` taking the next of front, side and top. The object's box is a cube,
/// and drawings keep their aspect: blank paper fills what they leave.
///
/// # Errors
/// If a drawing is blank, more than three name no view, or two are seen from the same side.
pub fn place(drawings: &[Drawing], seen_from: &[Option<ViewSpec>], size_px: usize) -> Result<Arrangement> {
    let half_extents_world = [1.0 / 3f64.sqrt(); 3];
    let height_world = 2.0 * half_extents_world[0] / FILLED;
    let canonical = View::canonical(height_world, size_px);
    let mut next = canonical.iter();
    let mut targets: Vec<Target> = Vec::with_capacity(drawings.len());
    let mut placements = Vec::with_capacity(drawings.len());
    for (source, (cutout, spec)) in Cutouts::new(drawings)?.0.iter().zip(seen_from).enumerate() {
        let view = match spec {
            Some(spec) => spec.resolve(&canonical, height_world, size_px)?,
            None => next.next().cloned().ok_or_else(|| Error::Pictures {
                problem: "front, side and top are taken".into(),
                remedy: "say where the other pictures are seen from".into(),
            })?,
        };
        if targets.iter().any(|target| same_side(&target.view, &view)) {
            return Err(Error::picture(
                &drawings[source].name,
                format!("another picture is seen from {} already", view.name),
                "give it another direction",
            ));
        }
        let side = FILLED * size_px as f64;
        let (width, height) =
            if cutout.aspect() > 1.0 { (side, side / cutout.aspect()) } else { (side * cutout.aspect(), side) };
        let middle = size_px as f64 / 2.0;
        let area = [middle - width / 2.0, middle - height / 2.0, width, height];
        let ink = cutout.laid(Orientation::default(), area, size_px, size_px);
        targets.push(Target { view, ink });
        placements.push(Placement {
            source,
            orientation: Orientation::default(),
            stretch: 1.0,
            from: cutout.on_drawing(),
            onto: area.map(|px| px / size_px as f64),
        });
    }
    Ok(Arrangement { placements, half_extents_world, height_world, targets, sharing: Sharing::Height, score: 0.0 })
}

/// Whether two views look along the same direction (to a hundredth of a degree or so).
fn same_side(a: &View, b: &View) -> bool {
    let direction = |view: &View| {
        let d: [f64; 3] = std::array::from_fn(|c| view.eye[c] - view.target[c]);
        let length = d.iter().map(|x| x * x).sum::<f64>().sqrt();
        d.map(|x| x / length)
    };
    let (a, b) = (direction(a), direction(b));
    (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>() < 1e-6
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::Ink;
    use crate::start::testing::picture;

    fn drawing(name: &str) -> Drawing {
        Drawing { name: name.into(), ink: picture(|x, y| (0.2..0.8).contains(&x) && (0.4..0.6).contains(&y)) }
    }

    #[test]
    fn each_drawing_goes_where_it_is_seen_from_with_its_aspect() {
        let specs = [None, Some("45,20".parse().unwrap()), None];
        let placed = place(&[drawing("a"), drawing("b"), drawing("c")], &specs, 128).unwrap();
        let names: Vec<_> = placed.targets.iter().map(|target| target.view.name.as_str()).collect();
        assert_eq!(names, ["front", "45,20", "side"]);
        for target in &placed.targets {
            let bounds = target.ink.threshold(0.5).bounding_box().unwrap();
            assert!((bounds.width() as f64 / bounds.height() as f64 - 3.0).abs() < 0.2);
        }
    }

    #[test]
    fn two_from_one_side_or_a_fourth_without_a_side_are_refused() {
        let twice = place(&[drawing("a"), drawing("b")], &[None, Some("0,0".parse().unwrap())], 64);
        assert!(matches!(twice, Err(Error::Picture { .. })), "{twice:?}");
        let many: Vec<_> = ["a", "b", "c", "d"].map(drawing).into();
        assert!(place(&many, &[None, None, None, None], 64).is_err());
    }
}
