//! `cargo xtask VERB`: builds, serves and tests Wire4D. One module a verb; what verbs share is in `shell`, `setup`,
//! `wasm` and `page`.

mod budget;
mod build;
mod elegance;
mod figures;
mod fills;
mod gallery;
mod growth;
mod page;
mod photos;
mod picture;
mod serve;
mod setup;
mod shell;
mod speed;
mod strokes;
mod tables;
mod test;
mod tube;
mod types;
mod wasm;
mod words;
mod works;

use std::process::ExitCode;

type Result<T = (), E = Box<dyn std::error::Error>> = std::result::Result<T, E>;

struct Verb {
    name: &'static str,
    options: &'static str,
    help: &'static str,
    run: fn(&[String]) -> Result,
}

const VERBS: &[Verb] = &[
    Verb { name: "serve", options: "[--dev]", help: serve::HELP, run: serve::run },
    Verb { name: "budget", options: "[sizes|audits|run]", help: budget::HELP, run: budget::run },
    Verb { name: "build", options: "", help: build::HELP, run: build::run },
    Verb { name: "figures", options: "", help: figures::HELP, run: figures::run },
    Verb { name: "fills", options: "[shapes|styles|density]", help: fills::HELP, run: fills::run },
    Verb { name: "gallery", options: "[--before] [--preset P] [--bend B]", help: gallery::HELP, run: gallery::run },
    Verb { name: "growth", options: "", help: growth::HELP, run: growth::run },
    Verb { name: "photos", options: "[scenes|real] [NAME=VALUE]...", help: photos::HELP, run: photos::run },
    Verb { name: "speed", options: "", help: speed::HELP, run: speed::run },
    Verb { name: "strokes", options: "pictures|sheet", help: strokes::HELP, run: strokes::run },
    Verb { name: "tables", options: "[--quick] [--only NAME]", help: tables::HELP, run: tables::run },
    Verb { name: "test", options: "[rust|web|browser]", help: test::HELP, run: test::run },
    Verb { name: "types", options: "", help: types::HELP, run: types::run },
    Verb { name: "words", options: "[three] [--denoise F] [--only W]", help: words::HELP, run: words::run },
    Verb { name: "works", options: "[NAME...|posters|sheet]", help: works::HELP, run: works::run },
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some((name, options)) =
        arguments.split_first().filter(|(name, _)| !["help", "--help", "-h"].contains(&&***name))
    else {
        println!("usage: cargo xtask VERB\n");
        for verb in VERBS {
            println!("  {:<32} {}", format!("{} {}", verb.name, verb.options), verb.help);
        }
        return ExitCode::SUCCESS;
    };
    let Some(verb) = VERBS.iter().find(|verb| verb.name == name) else {
        eprintln!("xtask: there is no verb `{name}`; `cargo xtask help` lists them");
        return ExitCode::from(2);
    };
    match (verb.run)(options) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("xtask {name}: {error}");
            ExitCode::FAILURE
        }
    }
}
