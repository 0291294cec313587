//! `cargo xtask works`: makes the gallery's works again from their inputs, draws their posters and a contact sheet.
//!
//! `www/gallery/works.json` says of each work what it is called and what `wire4d` makes it of; `www/gallery/works/` holds
//! what came out; posters are drawn whenever the page is built.

mod poster;
mod sheet;
mod vector;

use crate::Result;
use crate::shell::{command, root, run as run_command, say, www};
use image::RgbImage;
use image::codecs::jpeg::JpegEncoder;
use serde_json::Value;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use wire4d_core::wire::Wire;

/// For the list of verbs.
pub const HELP: &str = "make the gallery's works again, all or those named; `posters` or `sheet` only draws them";

/// A poster, px, and the most that it may take.
const POSTER: [usize; 2] = [480, 400];
const MOST_BYTES: usize = 25_000;
/// Raised where posters of the same wires come to look different.
const POSTER_EDITION: u32 = 1;
/// Decimals of coordinates in a work's file: a hundredth of a pixel of a view of 256 px.
const DECIMALS: i32 = 4;

/// One line of works.json, as far as making it goes.
struct Work {
    name: String,
    arguments: Vec<String>,
}

/// `posters`, `sheet [WIRE.JSON]...`, or the names of works to make; all without any.
pub fn run(arguments: &[String]) -> Result {
    match arguments.split_first() {
        Some((verb, [])) if verb == "posters" => posters(),
        Some((verb, files)) if verb == "sheet" => sheet(files),
        _ => make(arguments),
    }
}

fn make(names: &[String]) -> Result {
    run_command(command("cargo").args(["build", "--release", "--bin", "wire4d"]))?;
    let works = works()?;
    if let Some(unknown) = names.iter().find(|name| works.iter().all(|work| work.name != **name)) {
        return Err(format!("works.json has no work `{unknown}`").into());
    }
    for work in works.iter().filter(|work| names.is_empty() || names.contains(&work.name)) {
        say(format!("making {}", work.name));
        let out = root().join("out/works").join(&work.name);
        std::fs::create_dir_all(out.parent().unwrap_or(&out))?;
        run_command(
            command(&root().join("target/release/wire4d").to_string_lossy())
                .current_dir(www().join("gallery/inputs"))
                .args(&work.arguments)
                .args(["--quiet", "--overwrite", "--out"])
                .arg(&out)
                .stdout(std::process::Stdio::null()),
        )?;
        std::fs::create_dir_all(www().join("gallery/works"))?;
        std::fs::write(file_of(&work.name), rounded(read(&out.join("wire.json"))?).to_string())?;
    }
    sheet(&[])
}

/// The works in the gallery's order.
fn works() -> Result<Vec<Work>> {
    let list = read(&www().join("gallery/works.json"))?;
    let text = |value: &Value| value.as_str().map(str::to_owned);
    let work = |entry: &Value| {
        let arguments = entry["make"].as_array()?.iter().map(text).collect::<Option<_>>()?;
        Some(Work { name: text(&entry["name"])?, arguments })
    };
    let works = list.as_array().and_then(|entries| entries.iter().map(work).collect::<Option<_>>());
    works.ok_or_else(|| "works.json: a work has no name, or does not say what makes it".into())
}

fn file_of(name: &str) -> PathBuf {
    www().join("gallery/works").join(format!("{name}.wire.json"))
}

/// The file with no more digits than anybody can see.
fn rounded(mut file: Value) -> Value {
    let scale = 10f64.powi(DECIMALS);
    let points = file["control_points"].as_array_mut().into_iter().flatten();
    for number in points.filter_map(Value::as_array_mut).flatten() {
        if let Some(x) = number.as_f64() {
            *number = ((x * scale).round() / scale).into();
        }
    }
    // Whole numbers without a point.
    for knot in file["knots"].as_array_mut().into_iter().flatten() {
        if let Some(x) = knot.as_f64().filter(|x| x.fract() == 0.0) {
            *knot = (x as i64).into();
        }
    }
    file
}

/// A poster of each work by day and by night in www/public/gallery, drawn only where its wire or this program is another.
pub fn posters() -> Result {
    let (folder, stamps) = (www().join("public/gallery"), root().join("out/posters"));
    std::fs::create_dir_all(&folder)?;
    std::fs::create_dir_all(&stamps)?;
    for work in works()? {
        let text = text(&file_of(&work.name))?;
        let mut hasher = DefaultHasher::new();
        (POSTER_EDITION, &text).hash(&mut hasher);
        let (stamp, fresh) = (stamps.join(&work.name), format!("{:x}", hasher.finish()));
        let paths = ["", "-dark"].map(|suffix| folder.join(format!("{}{suffix}.jpg", work.name)));
        if paths.iter().all(|path| path.is_file()) && std::fs::read_to_string(&stamp).is_ok_and(|old| old == fresh) {
            continue;
        }
        let wire: Wire = serde_json::from_str(&text)?;
        for (path, paint) in paths.iter().zip([&poster::LIGHT, &poster::DARK]) {
            std::fs::write(path, jpeg(&poster::draw(&wire, POSTER, paint))?)?;
        }
        std::fs::write(stamp, fresh)?;
        say(format!("drew {}", work.name));
    }
    Ok(())
}

/// As good as fits into a poster's bytes.
fn jpeg(picture: &RgbImage) -> Result<Vec<u8>> {
    for quality in [88, 82, 76, 70, 64, 56, 48, 40, 30] {
        let mut bytes = Vec::new();
        JpegEncoder::new_with_quality(&mut bytes, quality).encode_image(picture)?;
        if bytes.len() <= MOST_BYTES {
            return Ok(bytes);
        }
    }
    Err(format!("a poster of {MOST_BYTES} bytes would be too coarse").into())
}

/// The works on a contact sheet in docs/gallery, or any wires on one in out/.
fn sheet(files: &[String]) -> Result {
    let (files, path): (Vec<PathBuf>, _) = if files.is_empty() {
        (works()?.iter().map(|work| file_of(&work.name)).collect(), root().join("docs/gallery/works.png"))
    } else {
        (files.iter().map(PathBuf::from).collect(), root().join("out/works.png"))
    };
    let wires = files.iter().map(|file| Ok(serde_json::from_str(&text(file)?)?)).collect::<Result<Vec<Wire>>>()?;
    sheet::save(&wires, &path)
}

fn text(path: &Path) -> Result<String> {
    std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()).into())
}

fn read(path: &Path) -> Result<Value> {
    serde_json::from_str(&text(path)?).map_err(|error| format!("{}: {error}", path.display()).into())
}
