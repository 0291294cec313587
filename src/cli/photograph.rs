//! `wire4d photograph`: a picture of a wire that looks like a photograph.

use crate::{args, making, wires};
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use std::sync::atomic::Ordering;
use wire4d::files::write_whole;
use wire4d::picture::encode_colour_png;
use wire4d::{Error, Result};
use wire4d_photograph::{Arrangement, Develop, Film, Finish, Lens, Place, Setting, Sky};

/// The verb and its flags.
pub fn command() -> Command {
    let number = |name: &'static str, what: &'static str, usual: &'static str, help: &'static str| {
        Arg::new(name)
            .long(name)
            .value_name(what)
            .value_parser(value_parser!(f32))
            .allow_negative_numbers(true)
            .default_value(usual)
            .help(help)
    };
    Command::new("photograph")
        .about("A picture of a wire with real lamps and real shadows, by path tracing")
        .arg(args::wire())
        .arg(args::file("out", "PNG to write").long("out").required(true))
        .arg(
            Arg::new("place")
                .long("place")
                .value_name("PLACE")
                .value_parser(["room", "screens", "studio"])
                .help("Where the shadows fall [default: room; screens where the wire is made to be seen from elsewhere than its sides]"),
        )
        .arg(
            Arg::new("finish")
                .long("finish")
                .value_name("FINISH")
                .value_parser(["metal", "matte"])
                .default_value("metal")
                .help("Bare metal, or painted"),
        )
        .arg(
            Arg::new("size")
                .long("size")
                .value_name("WIDTHxHEIGHT")
                .default_value("1920x1080")
                .help("Size of the picture in pixels"),
        )
        .arg(
            Arg::new("passes")
                .long("passes")
                .value_name("N")
                .value_parser(value_parser!(u32).range(1..=65_536))
                .default_value("48")
                .help("Samples of each pixel: four times as many are half the noise"),
        )
        .arg(
            Arg::new("seed")
                .long("seed")
                .value_name("N")
                .value_parser(value_parser!(u32))
                .default_value("0")
                .help("The same seed gives the same picture"),
        )
        .arg(number("azimuth", "DEGREES", "42", "Where the camera is: 0 is the front, 90 the side"))
        .arg(number("elevation", "DEGREES", "28", "How far above the wire it is"))
        .arg(
            Arg::new("camera-distance")
                .long("camera-distance")
                .value_name("UNITS")
                .value_parser(value_parser!(f32))
                .help("How far away it is; the wire lies in a box of about 2 [default: so far that all shadows are seen]"),
        )
        .arg(number("view-angle", "DEGREES", "26", "How much it sees, from its picture's lower to its upper border"))
        .arg(number("aperture", "UNITS", "0", "Radius of its lens: more is sharp at the wire alone"))
        .arg(number("lamp-radius", "UNITS", "0.16", "Size of the lamps: 0 throws the sharpest shadows"))
        .arg(number("lamp-distance", "UNITS", "24", "How far they are: from farther, shadows are as a view shows the wire"))
        .arg(number("surround", "SHARE", "0.04", "Light from all round, as a share of a lamp's"))
        .arg(
            Arg::new("sky")
                .long("sky")
                .value_name("SKY")
                .value_parser(["soft", "even", "overcast"])
                .default_value("soft")
                .help("How light from all round comes: a little more from above, the same from everywhere, or as on a grey day"),
        )
        .arg(number("roughness", "SHARE", "0.42", "How blurred metal mirrors, 0 to 1"))
        .arg(number("exposure", "STOPS", "1", "Each stop doubles the light"))
        .arg(Arg::new("quiet").long("quiet").action(ArgAction::SetTrue).help("Say nothing on the way"))
}

/// Takes the photograph; Ctrl-C keeps it as it is then.
pub fn run(matches: &ArgMatches) -> Result<()> {
    let number = |name: &str| *matches.get_one::<f32>(name).expect("it has a default");
    let choice = |name: &str| matches.get_one::<String>(name).map(String::as_str);
    let made = wires::read_wire(args::path(matches, "wire"))?;
    let finish = if choice("finish") == Some("matte") { Finish::Matte } else { Finish::Metal };
    let place = match choice("place") {
        Some("screens") => Place::Screens,
        Some("studio") => Place::Studio,
        Some(_) => Place::Room,
        None => Place::fitting(&made.views),
    };
    let arrangement = Arrangement {
        place,
        finish,
        roughness: number("roughness"),
        lamp_radius: number("lamp-radius"),
        lamp_distance: number("lamp-distance"),
        surround: number("surround"),
        sky: match choice("sky") {
            Some("even") => Sky::Even,
            Some("overcast") => Sky::Overcast,
            _ => Sky::Soft,
        },
        ..Arrangement::default()
    };
    let lens = Lens {
        azimuth: number("azimuth"),
        elevation: number("elevation"),
        view_angle: number("view-angle"),
        aperture: number("aperture"),
        ..Lens::of(place, place.away(&made.views))
    };
    let distance = matches.get_one::<f32>("camera-distance").copied().unwrap_or(lens.distance);
    let lens = Lens { distance, ..lens };
    let exposure = number("exposure");
    if !(-20.0..=20.0).contains(&exposure) {
        return Err(Error::setting("exposure", format!("{exposure} stops"), "give -20 to 20"));
    }
    let size = size(choice("size").expect("it has a default"))?;
    let setting = Setting::new(&made.wire, &made.views, &arrangement)?;
    let mut film = Film::new(&lens, size, *matches.get_one("seed").expect("it has a default"))?;
    let passes = *matches.get_one::<u32>("passes").expect("it has a default");
    let (bar, stop) = (making::progress_bar(matches.get_flag("quiet")), making::stop_by_hand(|| {}));
    bar.set_length(u64::from(passes));
    bar.set_message("Exposing");
    while film.passes() < passes && !stop.load(Ordering::Relaxed) {
        film.expose(&setting);
        bar.set_position(u64::from(film.passes()));
    }
    bar.finish_and_clear();
    let out = args::path(matches, "out");
    let [width, height] = film.size();
    let png = encode_colour_png(
        &out.display().to_string(),
        [width, height],
        film.developed(Develop { exposure, calmed: true }),
    )?;
    write_whole(out, &png)?;
    println!("{}", out.display());
    Ok(())
}

fn size(text: &str) -> Result<[usize; 2]> {
    let sides = text.split_once('x').and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
    sides.ok_or_else(|| Error::setting("size", format!("{text} is no size"), "give one such as 1920x1080"))
}
