//! Drawings in views of any direction: upright, as given, each as large as the common frame allows.

use super::arrange::{Arrangement, Cutouts, Drawing, FILLED, Placement, Sharing};
use super::orientation::Orientation;
use crate::error::{Error, Result};
use crate::view::{Image, Target, View, ViewSpec};

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

/// The views of `seen_from` that none of `arrangement` is, as large as those.
///
/// # Errors
/// If one has a name that nobody knows, or two are the same side.
pub fn others(arrangement: &Arrangement, seen_from: &[ViewSpec], size_px: usize) -> Result<Vec<View>> {
    let canonical = View::canonical(arrangement.height_world, size_px);
    let mut others: Vec<View> = Vec::new();
    for spec in seen_from {
        let view = spec.resolve(&canonical, arrangement.height_world, size_px)?;
        if others.iter().any(|other| same_side(other, &view)) {
            let problem = "is asked for twice";
            return Err(Error::input(format!("view {:?}", view.name), problem, "name each side once"));
        }
        if !arrangement.targets.iter().any(|target| same_side(&target.view, &view)) {
            others.push(view);
        }
    }
    Ok(others)
}

/// Thickness of a single drawing's object, as a share of the picture's side.
const THIN: f64 = 0.04;

/// What a single drawing's object shows from its right, where it is as thin as paper: starts for two drawings and more take that
/// for the other one.
pub fn edge_on(target: &Target) -> Target {
    let right = target.view.camera::<f64>().right;
    let eye = std::array::from_fn(|axis| target.view.target[axis] + 3.0 * right[axis]);
    let view = View { name: "edge".into(), eye, ..target.view.clone() };
    let (width, height) = (target.ink.width, target.ink.height);
    let mut ink = Image::new(width, height);
    let half = (0.5 * THIN * width as f64).max(1.0);
    let is_middle = |x: usize| (x as f64 + 0.5 - 0.5 * width as f64).abs() <= half;
    ink.data.iter_mut().enumerate().filter(|(i, _)| is_middle(i % width)).for_each(|(_, ink)| *ink = 1.0);
    Target { view, ink }
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
    fn sides_without_a_drawing_are_added_as_large_as_the_others() {
        let placed = place(&[drawing("a")], &[None], 64).unwrap();
        let others = |specs: &[&str]| {
            let specs: Vec<ViewSpec> = specs.iter().map(|spec| spec.parse().unwrap()).collect();
            super::others(&placed, &specs, 64)
        };
        let found = others(&["side", "0,0", "45,20"]).unwrap();
        assert_eq!(found.iter().map(|view| view.name.as_str()).collect::<Vec<_>>(), ["side", "45,20"]);
        assert!(found.iter().all(|view| view.projection == placed.targets[0].view.projection));
        assert!(others(&["side", "90,0"]).unwrap_err().to_string().contains("twice"));
        assert!(others(&["back"]).unwrap_err().to_string().contains("back"));
    }

    #[test]
    fn two_from_one_side_or_a_fourth_without_a_side_are_refused() {
        let twice = place(&[drawing("a"), drawing("b")], &[None, Some("0,0".parse().unwrap())], 64);
        assert!(matches!(twice, Err(Error::Picture { .. })), "{twice:?}");
        let many: Vec<_> = ["a", "b", "c", "d"].map(drawing).into();
        assert!(place(&many, &[None, None, None, None], 64).is_err());
    }
}
