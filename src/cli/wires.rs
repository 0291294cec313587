//! The verbs about a wire that is there already.

use crate::args;
use clap::ArgMatches;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use wire4d::export::{self, ExportOptions, Format, Opened};
use wire4d::files::{read_at_most, write_whole};
use wire4d::mesh::Mesh;
use wire4d::metrics::ResultReport;
use wire4d::picture::{GreyDepth, read_picture, write_png};
use wire4d::raster::{SELF_CHECK_TOLERANCE, self_check};
use wire4d::sculpture::{self, Sculpture};
use wire4d::settings::Settings;
use wire4d::tasks::multiview::Drawing;
use wire4d::view::{MAX_PICTURE_PX, View, ViewSpec};
use wire4d::wire::MAX_CONTROL_POINTS;
use wire4d::{Error, Result};

/// `wire4d render`.
pub fn render(matches: &ArgMatches) -> Result<()> {
    let made = read_wire(args::path(matches, "wire"))?;
    let size = matches.get_one::<u32>("size").copied().unwrap_or(512) as usize;
    let view = view_of(&made, matches)?;
    // The view's aspect is kept; the size is that of its longer side.
    let longer = view.width_px.max(view.height_px);
    let side = |px: usize| (px * size).div_ceil(longer).max(1);
    let view = view.with_size(side(view.width_px), side(view.height_px));
    let out = args::path(matches, "out");
    let picture = match solid(matches)? {
        Some(solid) => sculpture::render_seen(&made.wire, &view, &made.hidden_by(&solid, &view)),
        None => sculpture::render(&made.wire, &view),
    };
    write_png(out, &picture, GreyDepth::Bits16)?;
    println!("{}", out.display());
    Ok(())
}

/// `wire4d metrics`.
pub fn metrics(matches: &ArgMatches) -> Result<()> {
    let made = read_wire(args::path(matches, "wire"))?;
    let targets = matches
        .get_many::<std::path::PathBuf>("targets")
        .into_iter()
        .flatten()
        .map(|path| Ok(Some(Drawing::new(&read_picture(path)?, None, &Settings::default())?.0.ink)))
        .collect::<Result<Vec<_>>>()?;
    if targets.len() > made.views.len() {
        return Err(Error::input(
            "--targets",
            format!("{} pictures for a wire with {} views", targets.len(), made.views.len()),
            "give at most one picture a view, in the views' order",
        ));
    }
    print_json(&ResultReport::measure(&made, &targets))
}

/// `wire4d export`.
pub fn export(matches: &ArgMatches) -> Result<()> {
    let to = args::path(matches, "to");
    let format = match (Format::from_path(&to.to_string_lossy())?, matches.get_flag("lines")) {
        (Format::Svg, true) => Format::Lines,
        (format, wanted) if wanted && format != Format::Lines => {
            return Err(Error::setting("--lines", "is for drawings", "leave it out, or write an .svg"));
        }
        (format, _) => format,
    };
    let made = read_wire(args::path(matches, "wire"))?;
    let (view, solid) = (view_of(&made, matches)?, solid(matches)?);
    if solid.is_some() && !format.draws_a_view() {
        return Err(Error::setting("--covers", "is for drawings", "leave it out, or write an .svg"));
    }
    let mut options = ExportOptions::default();
    if let Some(&size) = matches.get_one::<f64>("size-mm") {
        if !format.has_a_size() {
            let remedy = "leave it out, or write an .stl, a .bend.csv or an .svg with --lines";
            return Err(Error::setting("--size-mm", "is for files in millimetres", remedy));
        }
        options.object_size_mm = size;
    }
    write_whole(to, &export::export(&made, format, Some(&view), solid.as_deref(), &options)?)?;
    println!("{}", to.display());
    Ok(())
}

/// `wire4d share`.
pub fn share(matches: &ArgMatches) -> Result<()> {
    println!("{}", export::share_code(&read_wire(args::path(matches, "wire"))?));
    Ok(())
}

/// `wire4d open`.
pub fn open(matches: &ArgMatches) -> Result<()> {
    let from = matches.get_one::<String>("from").map_or("", String::as_str);
    let made = if is_file(from) { read_wire(Path::new(from))? } else { export::open_link(from)? };
    let out = args::path(matches, "out");
    write_whole(out, made.to_json().as_bytes())?;
    println!("{}", out.display());
    Ok(())
}

/// Whether a person means a file, be it there or not, rather than a link or a code.
fn is_file(text: &str) -> bool {
    let ends_like_one = [".json", ".png", ".svg", ".glb"].iter().any(|end| text.to_ascii_lowercase().ends_with(end));
    Path::new(text).exists() || (ends_like_one && !text.contains("://"))
}

/// `wire4d device`.
pub fn device(_: &ArgMatches) -> Result<()> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    println!("backend: cpu, {} with {threads} threads", std::env::consts::ARCH);
    println!("limits: {MAX_CONTROL_POINTS} control points, pictures of {MAX_PICTURE_PX} px a side");
    let difference = self_check();
    if difference > SELF_CHECK_TOLERANCE {
        return Err(Error::Output {
            name: "self-check".into(),
            problem: format!("coverage differs from the reference by {difference:.3}"),
            remedy: "this machine's arithmetic is not to be trusted; use another".into(),
        });
    }
    println!("self-check: passed, coverage within {difference:.3} of the reference");
    graphics_card()
}

/// The device that `--backend gpu` would take, its limits, and whether it computes what the processor does; and what
/// `auto` would take.
fn graphics_card() -> Result<()> {
    use wire4d::gpu::{Device, GpuEngine, Kind, Parity, self_check};
    use wire4d::optimize::wait;
    match Device::acquire(Kind::Any) {
        Err(absence) => println!("backend: gpu, none ({absence})"),
        Ok(device) => {
            println!("backend: gpu, {}", device.info());
            let limits = device.limits().map(|(name, value)| format!("{value} {name}"));
            println!("limits: {}", limits.join(", "));
            let Parity { coverage, loss, gradient, .. } = wait(self_check(&mut GpuEngine::new(&device, "")))?;
            println!(
                "self-check: passed; off the processor's by: coverage {coverage:.1e}, loss {loss:.1e}, gradient {gradient:.1e}"
            );
        }
    }
    let place = wait(wire4d::tasks::place(wire4d::settings::Backend::Auto))?;
    println!("auto: {}, {}", place.backend, place.why);
    Ok(())
}

fn print_json<T: serde::Serialize>(value: &T) -> Result<()> {
    let text = serde_json::to_string_pretty(value)
        .map_err(|error| Error::output("report", error.to_string(), "report this, it should not happen"))?;
    println!("{text}");
    Ok(())
}

/// The wire of any file that carries one.
pub fn read_wire(path: &Path) -> Result<Sculpture> {
    let name = path.display().to_string();
    let remedy = "give a wire.json, or a PNG, SVG or GLB that Wire4D saved";
    match read_at_most(path, export::MAX_CARRIER_BYTES) {
        Ok(Some(bytes)) => {
            let Opened { sculpture, notes, .. } = export::open_file(&name, &bytes)?;
            notes.iter().for_each(|note| eprintln!("{name}: {note}"));
            Ok(sculpture)
        }
        Ok(None) => Err(Error::wire(name, "is larger than any wire", remedy)),
        Err(error) => Err(Error::wire(name, format!("cannot be read ({error})"), remedy)),
    }
}

/// What the wire covers, if that was said.
fn solid(matches: &ArgMatches) -> Result<Option<Arc<Mesh>>> {
    let path = matches.get_one::<PathBuf>("covers");
    path.map(|path| Ok(crate::fill::solid(path, args::up(matches))?.mesh)).transpose()
}

fn view_of(made: &Sculpture, matches: &ArgMatches) -> Result<View> {
    let text = matches.get_one::<String>("view").map_or("front", String::as_str);
    let spec: ViewSpec = text.parse()?;
    // Directions see as much as the wire's own views do, or the unit ball.
    let (height_world, size) = made.views.first().map_or((2.2, 256), |view| match view.projection {
        wire4d::view::Projection::Orthographic { height_world } => (height_world, view.height_px),
        wire4d::view::Projection::Perspective { .. } => (2.2, view.height_px),
    });
    spec.resolve(&made.views, height_world, size)
}
