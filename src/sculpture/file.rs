//! `wire.json`: the sculpture as text that other programs can read. Numbers survive to the last bit.

use super::{MadeWith, Sculpture};
use crate::view::{Projection, View};
use crate::wire::{Form, Wire};
use crate::{Error, Result};
use serde::{Deserialize, Serialize};

/// The name in `format`.
const FORMAT: &str = "wire4d";
/// The newest `version` this reads, and the one it writes.
pub const FORMAT_VERSION: u64 = 1;
/// No wire of 20,000 control points is longer; anything that is, is refused unread.
pub const MAX_FILE_BYTES: usize = 16 << 20;
const MAX_VIEWS: usize = 64;
const MAX_PICTURE_PX: usize = 16_384;

#[derive(Serialize)]
struct FileOut<'a> {
    format: &'static str,
    version: u64,
    #[serde(skip_serializing_if = "is_spline")]
    form: Form,
    closed: bool,
    knots: &'a [f64],
    control_points: &'a [[f64; 4]],
    views: Vec<ViewParts>,
    made_with: &'a MadeWith,
}

fn is_spline(form: &Form) -> bool {
    *form == Form::Spline
}

#[derive(Deserialize)]
struct Heading {
    format: Option<serde_json::Value>,
    version: Option<serde_json::Value>,
}

#[derive(Deserialize)]
struct FileIn {
    #[serde(default)]
    form: Form,
    closed: bool,
    knots: Vec<f64>,
    control_points: Vec<[f64; 4]>,
    #[serde(default)]
    views: Vec<ViewParts>,
    #[serde(default)]
    made_with: MadeWith,
}

#[derive(Serialize, Deserialize)]
struct ViewParts {
    name: String,
    projection: ProjectionName,
    eye: [f64; 3],
    target: [f64; 3],
    up: [f64; 3],
    #[serde(skip_serializing_if = "Option::is_none", default)]
    fov_y_rad: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none", default)]
    height_world: Option<f64>,
    width_px: usize,
    height_px: usize,
}

#[derive(Serialize, Deserialize, Clone, Copy, PartialEq)]
#[serde(rename_all = "lowercase")]
enum ProjectionName {
    Perspective,
    Orthographic,
}

impl Sculpture {
    /// The text of `wire.json`.
    pub fn to_json(&self) -> String {
        let file = FileOut {
            format: FORMAT,
            version: FORMAT_VERSION,
            form: self.wire.form(),
            closed: self.wire.closed(),
            knots: self.wire.knots(),
            control_points: self.wire.control_points(),
            views: self.views.iter().map(ViewParts::from).collect(),
            made_with: &self.made_with,
        };
        let mut text = serde_json::to_string(&file).expect("plain numbers and strings always serialise");
        text.push('\n');
        text
    }

    /// Reads the bytes of a `wire.json`; `name` is what the person calls the file.
    ///
    /// # Errors
    /// [`Error::Wire`] for what is too long, no JSON, another format, a newer version, or holds no valid wire or view.
    pub fn from_json(name: &str, bytes: &[u8]) -> Result<Sculpture> {
        let bad = |problem: String, remedy: &str| Error::wire(name, problem, remedy);
        const WRITTEN: &str = "use a wire.json that Wire4D wrote";
        if bytes.len() > MAX_FILE_BYTES {
            let problem = format!("{} MB are more than any wire takes", bytes.len() >> 20);
            return Err(bad(problem, WRITTEN));
        }
        let heading: Heading = serde_json::from_slice(bytes)
            .map_err(|error| bad(format!("is not readable as JSON ({error})"), WRITTEN))?;
        if heading.format.as_ref().and_then(|format| format.as_str()) != Some(FORMAT) {
            return Err(bad(format!("does not say \"format\": \"{FORMAT}\""), WRITTEN));
        }
        match heading.version.as_ref().and_then(|version| version.as_u64()) {
            Some(1..=FORMAT_VERSION) => {}
            Some(version) if version > FORMAT_VERSION => {
                let problem = format!("has version {version}, newer than this program reads ({FORMAT_VERSION})");
                return Err(bad(problem, "update Wire4D"));
            }
            _ => return Err(bad("has no valid version".to_owned(), WRITTEN)),
        }
        let file: FileIn = serde_json::from_slice(bytes)
            .map_err(|error| bad(format!("does not describe a wire ({error})"), WRITTEN))?;
        let wire = Wire::new(file.form, file.closed, file.knots, file.control_points).map_err(|error| match error {
            Error::Wire { problem, remedy, .. } => Error::wire(name, problem, remedy),
            other => other,
        })?;
        if file.views.len() > MAX_VIEWS {
            return Err(bad(format!("has {} views", file.views.len()), "use 64 at most"));
        }
        let views = file
            .views
            .into_iter()
            .map(|parts| {
                parts.check().map_err(|problem| {
                    let problem = format!("its view {:?} {problem}", parts.name.chars().take(40).collect::<String>());
                    bad(problem, "correct the view")
                })
            })
            .collect::<Result<_>>()?;
        Ok(Sculpture { wire, views, made_with: file.made_with })
    }
}

impl From<&View> for ViewParts {
    fn from(view: &View) -> Self {
        let (projection, fov_y_rad, height_world) = match view.projection {
            Projection::Perspective { fov_y_rad } => (ProjectionName::Perspective, Some(fov_y_rad), None),
            Projection::Orthographic { height_world } => (ProjectionName::Orthographic, None, Some(height_world)),
        };
        ViewParts {
            name: view.name.clone(),
            projection,
            eye: view.eye,
            target: view.target,
            up: view.up,
            fov_y_rad,
            height_world,
            width_px: view.width_px,
            height_px: view.height_px,
        }
    }
}

impl ViewParts {
    /// The view, or what is wrong with it.
    fn check(&self) -> Result<View, &'static str> {
        let projection = match (self.projection, self.fov_y_rad, self.height_world) {
            (ProjectionName::Perspective, Some(fov_y_rad), _) => Projection::Perspective { fov_y_rad },
            (ProjectionName::Perspective, None, _) => return Err("is perspective but has no fov_y_rad"),
            (ProjectionName::Orthographic, _, Some(height_world)) => Projection::Orthographic { height_world },
            (ProjectionName::Orthographic, _, None) => return Err("is orthographic but has no height_world"),
        };
        let view = View {
            name: self.name.clone(),
            projection,
            eye: self.eye,
            target: self.target,
            up: self.up,
            width_px: self.width_px,
            height_px: self.height_px,
        };
        check_view(&view).map(|()| view)
    }
}

/// Whether a view read from outside can be rendered; if not, what is wrong with it.
pub(crate) fn check_view(view: &View) -> Result<(), &'static str> {
    use glam::DVec3;
    const FARTHEST: f64 = 1e6;
    if view.name.len() > 200 {
        return Err("has a name longer than 200 bytes");
    }
    if [view.eye, view.target, view.up].iter().flatten().any(|c| c.is_nan() || c.abs() > FARTHEST) {
        return Err("has coordinates out of range");
    }
    let (forward, up) = (DVec3::from(view.target) - DVec3::from(view.eye), DVec3::from(view.up));
    if forward.length() < 1e-6 {
        return Err("has its eye on its target");
    }
    if up.length() < 1e-6 || forward.normalize().cross(up.normalize()).length() < 1e-6 {
        return Err("has its up direction along the line of sight");
    }
    let fits = match view.projection {
        Projection::Perspective { fov_y_rad } => fov_y_rad > 1e-3 && fov_y_rad < 3.1,
        Projection::Orthographic { height_world } => height_world > 1e-3 && height_world < FARTHEST,
    };
    if !fits {
        return Err("has a field of view out of range");
    }
    if [view.width_px, view.height_px].iter().any(|size| !(1..=MAX_PICTURE_PX).contains(size)) {
        return Err("has a picture size out of range (1 to 16384)");
    }
    Ok(())
}
