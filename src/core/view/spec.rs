//! Views as people and files describe them: checked when read, by name or by direction in degrees.

use super::{Projection, View};
use crate::{Error, Result};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::str::FromStr;

/// Largest side of a view's picture.
pub const MAX_VIEW_PX: usize = 8192;

/// Largest distance from the origin, and largest height, that a view may have, in world units.
const MAX_WORLD: f64 = 1e6;

/// A view as wire.json has it: `projection` says which of the two sizes is there.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename = "View"))]
pub(super) struct Record {
    name: String,
    projection: Kind,
    eye: [f64; 3],
    target: [f64; 3],
    up: [f64; 3],
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    fov_y_rad: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    height_world: Option<f64>,
    width_px: usize,
    height_px: usize,
}

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename = "ProjectionKind"))]
#[serde(rename_all = "lowercase")]
enum Kind {
    Perspective,
    Orthographic,
}

impl From<View> for Record {
    fn from(view: View) -> Record {
        let (projection, fov_y_rad, height_world) = match view.projection {
            Projection::Perspective { fov_y_rad } => (Kind::Perspective, Some(fov_y_rad), None),
            Projection::Orthographic { height_world } => (Kind::Orthographic, None, Some(height_world)),
        };
        let View { name, eye, target, up, width_px, height_px, .. } = view;
        Record { name, projection, eye, target, up, fov_y_rad, height_world, width_px, height_px }
    }
}

impl TryFrom<Record> for View {
    type Error = Error;
    fn try_from(record: Record) -> Result<View> {
        let lacks = |field: &str| view_error(&record.name, &format!("has no {field}"), &format!("add its {field}"));
        let projection = match record.projection {
            Kind::Perspective => {
                Projection::Perspective { fov_y_rad: record.fov_y_rad.ok_or_else(|| lacks("fov_y_rad"))? }
            }
            Kind::Orthographic => {
                Projection::Orthographic { height_world: record.height_world.ok_or_else(|| lacks("height_world"))? }
            }
        };
        let Record { name, eye, target, up, width_px, height_px, .. } = record;
        let view = View { name, projection, eye, target, up, width_px, height_px };
        view.check()?;
        Ok(view)
    }
}

fn view_error(name: &str, problem: &str, remedy: &str) -> Error {
    Error::input(format!("view {name:?}"), problem, remedy)
}

impl View {
    /// Whether the view can be seen through: a name that can be a file's, finite numbers, an eye away from its target,
    /// an up that is not the line of sight, sizes that are positive and at most [`MAX_VIEW_PX`].
    ///
    /// # Errors
    /// [`Error::Input`] that names the view and what is wrong with it.
    pub fn check(&self) -> Result<()> {
        let fail = |problem: &str, remedy: &str| Err(view_error(&self.name, problem, remedy));
        let plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.' | ',' | '+' | ' ');
        if self.name.is_empty() || self.name.len() > 64 || self.name.starts_with('.') || !self.name.chars().all(plain) {
            return fail("has a name that cannot be a file's", "use 1 to 64 letters, digits, - and _");
        }
        let vectors = [self.eye, self.target, self.up];
        if vectors.iter().flatten().any(|x| !x.is_finite() || x.abs() > MAX_WORLD) {
            return fail("has an eye, target or up that is no plain number or far away", "use numbers below a million");
        }
        let [eye, target, up] = vectors.map(DVec3::from);
        let sight = target - eye;
        if sight.length() < 1e-9 {
            return fail("looks from where it looks to", "move its eye away from its target");
        }
        if up.length() < 1e-9 || sight.normalize().cross(up.normalize()).length() < 1e-6 {
            return fail("has an up along its line of sight", "choose an up that points sideways to it");
        }
        match self.projection {
            Projection::Orthographic { height_world } if !(height_world > 1e-9 && height_world <= MAX_WORLD) => {
                return fail("has a height that is not positive", "use a height_world near 2.2");
            }
            Projection::Perspective { fov_y_rad } if !(fov_y_rad > 1e-4 && fov_y_rad < 3.1) => {
                return fail("has an impossible field of view", "use a fov_y_rad between 0.0001 and 3.1");
            }
            _ => {}
        }
        let sizes = 1..=MAX_VIEW_PX;
        if !sizes.contains(&self.width_px) || !sizes.contains(&self.height_px) {
            return fail("has an impossible size", &format!("use 1 to {MAX_VIEW_PX} px a side"));
        }
        Ok(())
    }
}

/// What `--view` takes: `NAME` of a known view or `AZIMUTH,ELEVATION` in degrees.
#[derive(Debug, Clone, PartialEq)]
pub enum ViewSpec {
    /// A view by its name.
    Named(String),
    /// A direction to look from: azimuth 0 is the front, 90 the side; elevation 90 the top.
    Direction {
        /// Degrees about the upright axis.
        azimuth_deg: f64,
        /// Degrees above the horizon, -90 to 90.
        elevation_deg: f64,
    },
}

impl FromStr for ViewSpec {
    type Err = Error;
    fn from_str(text: &str) -> Result<ViewSpec> {
        let text = text.trim();
        if let Some((azimuth, elevation)) = text.split_once(',') {
            return direction(text, azimuth, elevation);
        }
        if text.is_empty() {
            return Err(Error::input("view", "is empty", "give a view's name or AZIMUTH,ELEVATION in degrees"));
        }
        Ok(ViewSpec::Named(text.to_owned()))
    }
}

fn direction(text: &str, azimuth: &str, elevation: &str) -> Result<ViewSpec> {
    let number = |part: &str| part.trim().parse::<f64>().ok().filter(|degrees| degrees.abs() <= 36_000.0);
    match (number(azimuth), number(elevation)) {
        (Some(azimuth_deg), Some(elevation_deg)) if elevation_deg.abs() <= 90.0 => {
            Ok(ViewSpec::Direction { azimuth_deg, elevation_deg })
        }
        _ => Err(view_error(
            text,
            "is not a direction",
            "give AZIMUTH,ELEVATION in degrees, elevation from -90 to 90, such as 30,20",
        )),
    }
}

impl ViewSpec {
    /// The view meant: one of `known` by name, else `front`, `side` or `top`, else an orthographic one of the origin
    /// from the direction, `height_world` high and `size_px` square. Known views keep their own size.
    ///
    /// # Errors
    /// [`Error::Input`] for a name nobody knows; it lists those that are.
    pub fn resolve(&self, known: &[View], height_world: f64, size_px: usize) -> Result<View> {
        match self {
            ViewSpec::Named(name) => {
                let canonical = View::canonical(height_world, size_px);
                known.iter().chain(&canonical).find(|view| view.name == *name).cloned().ok_or_else(|| {
                    let mut names: Vec<&str> = known.iter().chain(&canonical).map(|view| view.name.as_str()).collect();
                    names.sort_unstable();
                    names.dedup();
                    let remedy = format!("use one of {} or AZIMUTH,ELEVATION in degrees", names.join(", "));
                    view_error(name, "is not known", &remedy)
                })
            }
            ViewSpec::Direction { azimuth_deg, elevation_deg } => {
                let name = format!("{azimuth_deg},{elevation_deg}");
                let (azimuth, elevation) = (azimuth_deg.to_radians(), elevation_deg.to_radians());
                let view = View::orthographic(&name, azimuth, elevation, height_world, size_px);
                view.check()?;
                Ok(view)
            }
        }
    }
}

/// Splits `PICTURE@AZIMUTH,ELEVATION` into the picture's file and its direction. The file's name may hold `@` too.
///
/// # Errors
/// [`Error::Input`] if there is no `@`, no picture or no direction.
pub fn parse_placed_picture(text: &str) -> Result<(String, ViewSpec)> {
    let remedy = "give PICTURE@AZIMUTH,ELEVATION in degrees, such as cat.png@30,20";
    let fail = |problem: &str| Error::input(text, problem, remedy);
    let (picture, place) = text.rsplit_once('@').ok_or_else(|| fail("does not say where it is seen from"))?;
    let (azimuth, elevation) = place.split_once(',').ok_or_else(|| fail("has no direction after @"))?;
    if picture.is_empty() {
        return Err(fail("names no picture"));
    }
    Ok((picture.to_owned(), direction(place, azimuth, elevation).map_err(|_| fail("has no direction after @"))?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::few_cases::few_cases;
    use proptest::prelude::*;

    fn front() -> View {
        View::canonical(2.2, 256)[0].clone()
    }

    #[test]
    fn canonical_views_pass_and_each_fault_is_named() {
        for view in View::canonical(2.2, 256) {
            view.check().unwrap();
        }
        let nan = f64::NAN;
        let orthographic = |height_world| Projection::Orthographic { height_world };
        let faults: Vec<(&str, View)> = vec![
            ("file", View { name: "../up".into(), ..front() }),
            ("file", View { name: String::new(), ..front() }),
            ("plain number", View { eye: [nan, 0.0, 0.0], ..front() }),
            ("plain number", View { target: [f64::INFINITY, 0.0, 0.0], ..front() }),
            ("looks from", View { eye: [0.0; 3], ..front() }),
            ("line of sight", View { up: [0.0, 0.0, -2.0], ..front() }),
            ("line of sight", View { up: [0.0; 3], ..front() }),
            ("height", View { projection: orthographic(0.0), ..front() }),
            ("height", View { projection: orthographic(nan), ..front() }),
            ("field of view", View { projection: Projection::Perspective { fov_y_rad: 3.2 }, ..front() }),
            ("size", View { width_px: 0, ..front() }),
            ("size", View { height_px: 1 << 40, ..front() }),
        ];
        for (word, view) in faults {
            let error = view.check().unwrap_err();
            assert!(error.is_bad_input() && error.to_string().contains(word), "{word}: {error}");
        }
    }

    #[test]
    fn the_file_form_is_the_contract() {
        let text = serde_json::to_string(&front()).unwrap();
        assert_eq!(
            text,
            r#"{"name":"front","projection":"orthographic","eye":[0.0,0.0,3.0],"target":[0.0,0.0,0.0],"#.to_owned()
                + r#""up":[-0.0,1.0,-0.0],"height_world":2.2,"width_px":256,"height_px":256}"#
        );
        let perspective = View { projection: Projection::Perspective { fov_y_rad: 0.7 }, ..front() };
        let text = serde_json::to_string(&perspective).unwrap();
        assert!(text.contains(r#""projection":"perspective""#) && text.contains(r#""fov_y_rad":0.7"#), "{text}");
        assert!(!text.contains("height_world"));
        for view in View::canonical(2.2, 256).into_iter().chain([perspective]) {
            let back: View = serde_json::from_str(&serde_json::to_string(&view).unwrap()).unwrap();
            assert_eq!(back, view);
        }
        let without = text.replace("fov_y_rad", "field");
        let error = serde_json::from_str::<View>(&without).unwrap_err().to_string();
        assert!(error.contains("no fov_y_rad"), "{error}");
        let bad = text.replace("0.7", "0.0");
        assert!(serde_json::from_str::<View>(&bad).unwrap_err().to_string().contains("field of view"));
    }

    #[test]
    fn view_options_are_understood() {
        let spec: ViewSpec = "30, -20.5".parse().unwrap();
        assert_eq!(spec, ViewSpec::Direction { azimuth_deg: 30.0, elevation_deg: -20.5 });
        assert_eq!(spec.resolve(&[], 2.2, 64).unwrap().name, "30,-20.5");
        let top = "0,90".parse::<ViewSpec>().unwrap().resolve(&[], 2.2, 256).unwrap();
        assert_eq!((top.eye, top.up), (View::canonical(2.2, 256)[2].eye, View::canonical(2.2, 256)[2].up));
        let mine = View { name: "mine".into(), width_px: 99, ..front() };
        let found = "mine".parse::<ViewSpec>().unwrap().resolve(std::slice::from_ref(&mine), 2.2, 64).unwrap();
        assert_eq!(found, mine);
        let error = "back".parse::<ViewSpec>().unwrap().resolve(&[mine], 2.2, 64).unwrap_err().to_string();
        assert!(error.contains("front, mine, side, top"), "{error}");
        for bad in ["", "1,2,3", "x,y", "0,91", "nan,0", "inf,0", "1e9,0"] {
            let error = bad.parse::<ViewSpec>().unwrap_err();
            assert!(error.is_bad_input(), "{bad}: {error}");
        }
    }

    #[test]
    fn placed_pictures_are_understood() {
        let (file, spec) = parse_placed_picture("a@b.png@45,10").unwrap();
        assert_eq!((file.as_str(), spec), ("a@b.png", ViewSpec::Direction { azimuth_deg: 45.0, elevation_deg: 10.0 }));
        for bad in ["cat.png", "cat.png@", "cat.png@top", "@0,0", "cat.png@0,95"] {
            let error = parse_placed_picture(bad).unwrap_err().to_string();
            assert!(error.starts_with(bad) && error.contains("AZIMUTH"), "{error}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 200, ..few_cases() })]
        #[test]
        fn no_text_panics(text in ".{0,40}") {
            let _ = text.parse::<ViewSpec>().map(|spec| spec.resolve(&[], 2.2, 16));
            let _ = parse_placed_picture(&text);
            let _ = serde_json::from_str::<View>(&text);
        }

        #[test]
        fn a_view_that_passes_projects_to_finite_numbers(
            eye in prop::array::uniform3(-4.0..4.0f64), target in prop::array::uniform3(-1.0..1.0f64),
            up in prop::array::uniform3(-1.0..1.0f64), fov in -0.5..4.0f64, point in prop::array::uniform4(-1.0..1.0f64),
        ) {
            let view = View {
                eye, target, up, projection: Projection::Perspective { fov_y_rad: fov }, ..front()
            };
            if view.check().is_ok() {
                prop_assert!(view.camera::<f64>().project(&point).iter().all(|x| x.is_finite()));
            }
        }
    }
}
