//! `wire4d build`: how to make a wire from real wire.

mod dxf;
mod printed;

use crate::folder::Folder;
use crate::{args, wires};
use clap::{Arg, ArgMatches, Command, value_parser};
use serde::Serialize;
use wire4d::Result;
use wire4d_fabrication::{BendList, Centreline, Check, Job, Metal, Paper, Step, Stock, steps};

/// The verb and its flags.
pub fn command() -> Command {
    let millimetres = |name: &'static str, usual: &'static str, help: &'static str| {
        Arg::new(name)
            .long(name)
            .value_name("MM")
            .value_parser(value_parser!(f64))
            .allow_negative_numbers(true)
            .default_value(usual)
            .help(help)
    };
    Command::new("build")
        .about("How to make a wire from real wire: whether it can be bent, how, and what it takes")
        .arg(args::wire())
        .arg(millimetres("size-mm", "200", "Longest side of the sculpture, from middle to middle of the wire"))
        .arg(millimetres("wire-mm", "1.6", "Thickness of the wire"))
        .arg(
            Arg::new("metal")
                .long("metal")
                .value_name("METAL")
                .value_parser(Metal::ALL.map(Metal::name))
                .default_value(Metal::default().name())
                .help("What the wire is made of"),
        )
        .arg(millimetres("stock-mm", "5000", "How long a piece of wire is, as you buy it"))
        .arg(
            Arg::new("paper")
                .long("paper")
                .value_name("PAPER")
                .value_parser(Paper::ALL.map(Paper::name))
                .default_value(Paper::default().name())
                .help("What is in the printer"),
        )
        .args(printed::flags())
        .arg(args::file("out", "Folder to make for what there is to know").long("out").required(true))
        .arg(args::overwrite())
        .arg(Arg::new("quiet").long("quiet").action(clap::ArgAction::SetTrue).help("Say nothing on the way"))
}

/// What build.json holds.
#[derive(Serialize)]
struct Report<'a> {
    size_mm: f64,
    stock: &'a Stock,
    metals_source: &'a str,
    said: &'a [String],
    check: &'a Check,
    bends: &'a BendList,
    steps: &'a [Step],
}

/// Checks, and writes it all into a folder.
pub fn run(matches: &ArgMatches) -> Result<()> {
    let number = |name: &str| *matches.get_one::<f64>(name).expect("it has a default");
    let metal = matches.get_one::<String>("metal").and_then(|name| Metal::named(name)).unwrap_or_default();
    let stock = Stock { metal, gauge_mm: number("wire-mm"), length_mm: number("stock-mm") };
    let paper = matches.get_one::<String>("paper").and_then(|name| Paper::named(name)).unwrap_or_default();
    let size_mm = number("size-mm");
    let wanted = printed::Wanted::new(matches)?;
    let file = args::path(matches, "wire");
    let made = wires::read_wire(file)?;
    let name = file.file_name().map_or("wire".into(), |name| name.to_string_lossy());
    let name = name.trim_end_matches(".json").trim_end_matches(".wire");
    let line = Centreline::new(&made.wire, size_mm, stock.gauge_mm)?;
    let out = args::path(matches, "out");
    let folder = Folder::claim(out, matches.get_flag("overwrite"))?;
    let check = Check::new(&made.wire, &line, &stock)?;
    let bends = BendList::new(&line, metal);
    let steps = steps(&line, &bends);
    let mut said = check.sentences(&stock);
    said.extend(wanted.write(&folder, &made.wire, size_mm, stock.gauge_mm)?);
    let report = Report {
        size_mm,
        stock: &stock,
        metals_source: Metal::SOURCE,
        said: &said,
        check: &check,
        bends: &bends,
        steps: &steps,
    };
    let job = Job { name, line: &line, stock: &stock, check: &check, bends: &bends, steps: &steps };
    let json = serde_json::to_string_pretty(&report).expect("plain numbers and words");
    folder.write("build.json", json.as_bytes())?;
    folder.write("bends.md", bends.table(&check, &stock).as_bytes())?;
    folder.write("bends.csv", bends.csv().as_bytes())?;
    folder.write("bends.dxf", &dxf::drawing(&bends))?;
    folder.write("paper.pdf", &job.pdf(paper))?;
    folder.finish()?;
    if !matches.get_flag("quiet") {
        eprintln!("{}", said.join("\n"));
    }
    println!("{}", out.join("build.json").display());
    Ok(())
}
