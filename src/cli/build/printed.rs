//! What a printer can make of a wire: the wire itself, and a jig to bend it in.

use crate::folder::Folder;
use clap::{Arg, ArgAction, ArgMatches};
use wire4d::wire::Wire;
use wire4d::{Error, Result};
use wire4d_printing::{Gauge, Part, Plate, Printer, Strands, jig, print, stl, three_mf};

/// The flags for it.
pub fn flags() -> [Arg; 3] {
    [
        Arg::new("plate").long("plate").action(ArgAction::SetTrue).help("Print the wire on a plate"),
        Arg::new("name").long("name").value_name("TEXT").help("Put a name on the plate, in raised letters"),
        Arg::new("bed-mm")
            .long("bed-mm")
            .value_name("WxDxH")
            .default_value("220x220x250")
            .help("What fits the printer: width, depth and height in mm"),
    ]
}

/// What was asked for.
pub struct Wanted {
    plate: Option<Plate>,
    printer: Printer,
}

impl Wanted {
    /// Of the flags.
    ///
    /// # Errors
    /// [`Error::Setting`] for a name that cannot be printed and a bed that is none.
    pub fn new(matches: &ArgMatches) -> Result<Wanted> {
        let plate = match matches.get_one::<String>("name") {
            Some(name) => Some(Plate::with_name(name)?),
            None => matches.get_flag("plate").then(Plate::default),
        };
        let bed = matches.get_one::<String>("bed-mm").map_or("", String::as_str);
        let sides: Option<Vec<f64>> = bed.split(['x', 'X', '×']).map(|side| side.trim().parse().ok()).collect();
        let sides = sides.and_then(|sides| <[f64; 3]>::try_from(sides).ok()).ok_or_else(|| {
            Error::setting("--bed-mm", format!("{bed:?} is not three lengths"), "give them like 220x220x250")
        })?;
        Ok(Wanted { plate, printer: Printer::with_bed(sides)? })
    }

    /// Writes print and jig, and says what they are, or why there are none: a wire may well be bent and not printed.
    pub fn write(&self, folder: &Folder, wire: &Wire, size_mm: f64, gauge_mm: f64) -> Result<Vec<String>> {
        let strands = match Strands::new(wire, size_mm, Gauge::Constant(gauge_mm)) {
            Ok(strands) => strands,
            Err(error) => return Ok(vec![format!("No print and no jig: {error}.")]),
        };
        let printed = print(&strands, self.plate.as_ref()).map(|made| {
            let said = format!("To print: one solid, {} mm at its thinnest.", made.least_thickness_mm);
            (vec![Part { name: "print".to_owned(), mesh: made.mesh }], said)
        });
        let held = jig(&strands, &self.printer).map(|made| {
            let (parts, posts) = (made.parts.len(), made.posts);
            let said = format!(
                "To bend it in: a jig of {posts} posts, in {parts} {}.",
                if parts == 1 { "part" } else { "parts" }
            );
            (made.parts, said)
        });
        let mut said = Vec::new();
        for (name, made) in [("print", printed), ("jig", held)] {
            match made {
                Ok((parts, words)) => {
                    for part in &parts {
                        folder.write(&format!("{}.stl", part.name), &stl(&part.mesh))?;
                    }
                    folder.write(&format!("{name}.3mf"), &three_mf(&parts))?;
                    said.push(words);
                }
                Err(error) => said.push(format!("No {name}: {error}.")),
            }
        }
        Ok(said)
    }
}
