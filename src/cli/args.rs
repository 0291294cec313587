//! Verbs and flags. The flags of a run are made from the settings table.

use clap::{Arg, ArgAction, ArgGroup, ArgMatches, Command, value_parser};
use std::path::PathBuf;
use wire4d::model::Up;
use wire4d::settings::{Kind, Preset, Settings, Task};
use wire4d::{Error, Result};

/// The whole command line.
pub fn command() -> Command {
    let out_file = |help: &'static str| file("out", help).long("out").required(true);
    Command::new("wire4d")
        .args_override_self(true)
        .version(env!("CARGO_PKG_VERSION"))
        .about("Turns pictures into wire art: one continuous wire whose views show them")
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(with_settings(
            Command::new("multiview")
                .about("Two, three or more pictures to one wire that shows each from its own side")
                .arg(
                    file("pictures", "Pictures for front, side and (if given) top: PNG, JPEG or WebP")
                        .value_name("PICTURE")
                        .num_args(0..=3),
                )
                .arg(
                    Arg::new("view")
                        .long("view")
                        .value_name("PICTURE@AZIMUTH,ELEVATION")
                        .action(ArgAction::Append)
                        .allow_hyphen_values(true)
                        .help("One more picture, seen from this direction in degrees; all pictures are then placed as given"),
                )
                .arg(
                    Arg::new("neutral")
                        .long("neutral")
                        .value_name("WORDS")
                        .requires("guide")
                        .help("What the views show at first: they change as --words differ from this, patch by patch"),
                )
                .arg(out_folder())
                .arg(overwrite()),
            Task::Multiview,
        ))
        .subcommand(with_settings(
            Command::new("stroke")
                .about("One picture to a wire that shows it from the front and makes sense as it turns")
                .arg(file("picture", "The picture: PNG, JPEG or WebP").value_name("PICTURE").required(true))
                .arg(file("mask", "What of it is the object: a picture, white on black").long("mask"))
                .arg(
                    Arg::new("box")
                        .long("box")
                        .value_name("X,Y,W,H")
                        .allow_hyphen_values(true)
                        .help("A box round the object, in pixels of the picture: what is outside is ground"),
                )
                .arg(strokes("mark-object", "A stroke on the object, in pixels of the picture; two numbers are a dot; again for more"))
                .arg(strokes("mark-ground", "A stroke on what is not the object, likewise"))
                .arg(file("depth", "How near each of its pixels is: a picture of its size, light is near").long("depth"))
                .arg(
                    Arg::new("view")
                        .long("view")
                        .value_name("PICTURE@AZIMUTH,ELEVATION")
                        .action(ArgAction::Append)
                        .allow_hyphen_values(true)
                        .help("The same object from another side, a direction in degrees; its outline shapes the solid"),
                )
                .arg(
                    Arg::new("like-picture")
                        .long("like-picture")
                        .action(ArgAction::SetTrue)
                        .requires("guide")
                        .help("The sides are to be like the picture, as --guide sees both; best with other sides often, such as --new-sides 2"),
                )
                .arg(
                    file("pose", "What asks --denoise for new views of the picture, as Zero-1-to-3 knows them, in place of words")
                        .long("pose")
                        .value_name("FILE.onnx")
                        .requires("denoise"),
                )
                .arg(out_folder())
                .arg(overwrite()),
            Task::Stroke,
        ))
        .subcommand(with_settings(
            Command::new("fill")
                .about("A mesh to one closed wire that covers it, in a picture's style")
                .arg(
                    file("mesh", "The mesh: OBJ, STL, PLY, 3MF, GLB or glTF; or sphere, torus, knot, vase, creature")
                        .value_name("MESH")
                        .required(true),
                )
                .arg(up_axis())
                .arg(
                    file("style", "A picture for its look, or petals, waves, calligraphy, scales, leaves")
                        .long("style")
                        .value_name("PICTURE"),
                )
                .arg(out_folder())
                .arg(overwrite()),
            Task::Fill,
        ))
        .subcommand(
            Command::new("render")
                .about("Coverage of a wire in one view as 16-bit grey PNG, ink white")
                .arg(wire())
                .arg(view())
                .arg(covers())
                .arg(up_axis())
                .arg(
                    Arg::new("size")
                        .long("size")
                        .value_name("PIXELS")
                        .value_parser(value_parser!(u32).range(1..=8192))
                        .default_value("512")
                        .help("Side of the square picture"),
                )
                .arg(out_file("PNG to write")),
        )
        .subcommand(
            Command::new("export")
                .about("A wire as GLB, STL, OBJ, SVG, bend list (.bend.csv) or wire.json, by the file's ending")
                .arg(wire())
                .arg(file("to", "File to write").long("to").required(true))
                .arg(view())
                .arg(covers())
                .arg(
                    Arg::new("lines")
                        .long("lines")
                        .action(ArgAction::SetTrue)
                        .help("An SVG of centre lines in real size, for pen plotters and benders, not of outlines"),
                )
                .arg(
                    Arg::new("size-mm")
                        .long("size-mm")
                        .value_name("MM")
                        .value_parser(value_parser!(f64))
                        .allow_negative_numbers(true)
                        .help("Longest side: of the drawing (--lines) or the object (STL, bend list) [default: 100]"),
                )
                .arg(up_axis()),
        )
        .subcommand(
            Command::new("metrics").about("Numbers about a wire, as in a report's `result`").arg(wire()).arg(
                file("targets", "The pictures the wire's views should show, in their order")
                    .long("targets")
                    .value_name("PICTURE")
                    .num_args(1..),
            ),
        )
        .subcommand(Command::new("share").about("The wire as a short code for a link").arg(wire()))
        .subcommand(
            Command::new("open")
                .about("A link, a share code, or a PNG, SVG or GLB that carries a wire, back to wire.json")
                .arg(
                    Arg::new("from")
                        .value_name("FILE|CODE|LINK")
                        .required(true)
                        .allow_hyphen_values(true)
                        .help("What holds the wire"),
                )
                .arg(out_file("wire.json to write")),
        )
        .subcommand(
            Command::new("raster")
                .about("One 2D scene through the rasteriser, for accuracy and timing")
                .arg(file("scene", "Scene as JSON").value_name("SCENE").required(true))
                .arg(file("target", "Target coverage, for the loss").long("target").value_name("T.npy"))
                .arg(file("out", "Where to write the coverage").long("out").value_name("COVERAGE.npy"))
                .arg(file("grad", "Where to write the gradient; needs --target").long("grad").value_name("GRAD.json"))
                .arg(
                    Arg::new("repeat")
                        .long("repeat")
                        .value_name("N")
                        .value_parser(value_parser!(u32).range(1..=100_000))
                        .help("Time N runs and print the medians as one JSON line"),
                )
                .arg(
                    Arg::new("backend")
                        .long("backend")
                        .value_name("BACKEND")
                        .value_parser(["auto", "cpu", "gpu"])
                        .default_value("auto")
                        .help("What computes it"),
                ),
        )
        .subcommand(crate::build::command())
        .subcommand(crate::photograph::command())
        .subcommand(Command::new("device").about("What computes the fit, its limits and whether it checks out"))
}

pub fn file(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name).value_parser(value_parser!(PathBuf)).help(help).value_name("FILE")
}

fn strokes(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name).long(name).value_name("X,Y,X,Y").action(ArgAction::Append).allow_hyphen_values(true).help(help)
}

fn out_folder() -> Arg {
    file("out", "Folder to make for the wire, its pictures and the report").long("out").required(true)
}

pub fn overwrite() -> Arg {
    Arg::new("overwrite")
        .long("overwrite")
        .action(ArgAction::SetTrue)
        .help("Replace what an earlier run left in the folder")
}

pub fn wire() -> Arg {
    file("wire", "A wire.json").value_name("WIRE").required(true)
}

fn view() -> Arg {
    Arg::new("view")
        .long("view")
        .value_name("NAME|AZ,EL")
        .allow_hyphen_values(true)
        .default_value("front")
        .help("One of the wire's views by name, or a direction in degrees")
}

fn covers() -> Arg {
    file("covers", "The mesh or built-in shape that the wire covers: lines behind it are left out of pictures and SVGs")
        .long("covers")
        .value_name("MESH")
}

fn up_axis() -> Arg {
    Arg::new("up")
        .long("up")
        .value_name("AXIS")
        .value_parser(Up::ALL.map(Up::name))
        .help("The mesh's axis that points up [default: z for STL and 3MF, y for the others]")
}

fn with_settings(command: Command, task: Task) -> Command {
    let defaults = task.preset(Preset::Best).to_map();
    let command = task.rows().fold(command, |command, row| {
        let flag = row.name.replace('_', "-");
        let unit = if row.unit.is_empty() { String::new() } else { format!(" ({})", row.unit) };
        let default = defaults[row.name].to_string().replace('"', "");
        if row.kind == Kind::Switch {
            let no = format!("no-{flag}");
            return command.arg(Arg::new(row.name).long(flag).action(ArgAction::SetTrue).help(row.help)).arg(
                Arg::new(no.clone())
                    .long(no)
                    .action(ArgAction::SetTrue)
                    .overrides_with(row.name)
                    .help(format!("The opposite; default {}", if default == "true" { "on" } else { "off" })),
            );
        }
        let word = match row.kind {
            Kind::Choice { choices } => choices.join("|"),
            _ => "N".to_owned(),
        };
        command.arg(
            Arg::new(row.name)
                .long(flag)
                .value_name(word)
                .allow_hyphen_values(true)
                .hide(!row.kind.leaves_choice())
                .help(format!("{}{unit} [default: {default}]", row.help)),
        )
    });
    with_guidance(command, task)
        .arg(
            Arg::new("set")
                .long("set")
                .value_name("NAME=VALUE")
                .action(ArgAction::Append)
                .help("Any setting by its name"),
        )
        .arg(
            file(
                "perceptual",
                "A network whose likeness of views and pictures is reported too: a file of tools/guidance",
            )
            .long("perceptual")
            .value_name("FILE.onnx"),
        )
        .arg(Arg::new("quiet").long("quiet").action(ArgAction::SetTrue).help("No progress on the terminal"))
}

/// What says that networks guide a run. `guiding` reads it.
fn with_guidance(command: Command, task: Task) -> Command {
    let repeated =
        |name: &'static str, help: &'static str| Arg::new(name).long(name).action(ArgAction::Append).help(help);
    let number = |name: &'static str, help: &'static str| {
        let arg = Arg::new(name).long(name).value_name("N").value_parser(value_parser!(f32));
        arg.allow_negative_numbers(true).help(help)
    };
    let aims: &[&str] = if task == Task::Stroke { &["words", "like-picture", "pose"] } else { &["words"] };
    command
        .group(ArgGroup::new("network").args(["guide", "denoise"]).multiple(true))
        .group(ArgGroup::new("aim").args(aims).multiple(true))
        .arg(
            repeated(
                "guide",
                "A network that pulls views towards words: a file of tools/guidance; again for more that agree",
            )
            .value_name("FILE.onnx")
            .value_parser(value_parser!(PathBuf))
            .requires("aim"),
        )
        .arg(
            repeated(
                "words",
                "What the views are to show, as --guide or --denoise sees it; VIEW=WORDS for one view alone; again for more",
            )
            .value_name("WORDS")
            .requires("network"),
        )
        .arg(
            number("guide-weight", "Weight of what --guide says, where the comparison of pictures weighs 1; from 2 on words win over pictures")
                .default_value("0.3"),
        )
        .arg(
            Arg::new("guide-look")
                .long("guide-look")
                .value_name("LOOK")
                .value_parser(["turned", "whole", "patches"])
                .default_value("turned")
                .help("What --guide sees of a view: all of it a little turned, all of it as it is, or 4 x 4 parts"),
        )
        .arg(
            file(
                "word-table",
                "More words for --guide and --denoise, a .json with a .bin beside it [default: words.json beside the network]",
            )
            .long("word-table")
            .requires("network"),
        )
        .arg(
            file("text", "A text encoder for --words, a file of tools/guidance")
                .long("text")
                .value_name("FILE.onnx")
                .requires("network"),
        )
        .arg(
            file("denoise", "A diffusion model that pulls views towards words (score distillation): a file of tools/guidance")
                .long("denoise")
                .value_name("FILE.onnx")
                .requires("aim"),
        )
        .arg(
            file("encode", "What makes latents of pictures for --denoise, likewise; none for a model of pixels")
                .long("encode")
                .value_name("FILE.onnx")
                .requires("denoise"),
        )
        .arg(
            file("contexts", "What --denoise takes for words, where that is no single vector: a contexts-v1 file")
                .long("contexts")
                .value_name("FILE.json")
                .requires("denoise"),
        )
        .arg(number(
            "denoise-scale",
            "How much of the difference between the words and none counts [default: 100 with --encode, 3 with --pose, else 50]",
        ))
        .arg(
            number("denoise-weight", "Weight of what --denoise says, where the comparison of pictures weighs 1")
                .default_value("1"),
        )
        .arg(
            Arg::new("denoise-times")
                .long("denoise-times")
                .value_name("HOW")
                .value_parser(["falling", "dreamtime"])
                .default_value("falling")
                .help("How noisy a view is made as the fit goes on: at random below a falling limit, or one falling time"),
        )
}

/// The settings a run was given, later flags over earlier ones over the preset.
pub fn settings(matches: &ArgMatches, task: Task) -> Result<Settings> {
    let mut pairs: Vec<(String, String)> = Vec::new();
    for row in task.rows() {
        if row.kind == Kind::Switch {
            if matches.get_flag(row.name) {
                pairs.push((row.name.into(), "on".into()));
            }
            if matches.get_flag(&format!("no-{}", row.name.replace('_', "-"))) {
                pairs.push((row.name.into(), "off".into()));
            }
        } else if let Some(text) = matches.get_one::<String>(row.name) {
            pairs.push((row.name.into(), text.clone()));
        }
    }
    for pair in matches.get_many::<String>("set").into_iter().flatten() {
        let Some((name, text)) = pair.split_once('=') else {
            return Err(Error::setting(format!("--set {pair}"), "there is no = in it", "write --set NAME=VALUE"));
        };
        pairs.push((name.trim().into(), text.trim().into()));
    }
    task.settings(pairs.iter().map(|(name, text)| (name.as_str(), text.as_str())))
}

/// Which axis of a mesh points up, if that is said.
pub fn up(matches: &ArgMatches) -> Option<Up> {
    matches.get_one::<String>("up").and_then(|word| Up::named(word))
}

/// A file argument that clap guarantees.
pub fn path<'a>(matches: &'a ArgMatches, name: &str) -> &'a std::path::Path {
    matches.get_one::<PathBuf>(name).map_or(std::path::Path::new(""), PathBuf::as_path)
}

/// Clap's many-line message as one line with a remedy.
pub fn one_line(error: &clap::Error) -> String {
    let text = error.to_string();
    let first = text.split("\n\nUsage:").next().unwrap_or(&text).split("\n\nFor more").next().unwrap_or(&text);
    let line = first.split_whitespace().collect::<Vec<_>>().join(" ");
    format!("{}; see wire4d --help", line.trim_start_matches("error: "))
}
