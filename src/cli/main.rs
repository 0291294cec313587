//! The command line: `wire4d VERB …`. Errors are one line on standard error; exit status 2 for a bad input or option,
//! 1 for anything else.

mod args;
mod build;
mod fill;
mod folder;
mod guiding;
mod likeness;
mod making;
mod multiview;
mod photograph;
mod raster;
mod stroke;
mod wires;

#[cfg(test)]
#[path = "../core/few_cases.rs"]
mod few_cases;

use std::process::ExitCode;

fn main() -> ExitCode {
    // A layer of Mesa asks the desktop which card to prefer, and complains on standard error where there is none.
    // SAFETY: no other thread is there yet.
    unsafe { std::env::set_var("NODEVICE_SELECT", "1") };
    let matches = match args::command().try_get_matches() {
        Ok(matches) => matches,
        Err(error) if !error.use_stderr() => {
            // --help and --version.
            let _ = error.print();
            return ExitCode::SUCCESS;
        }
        Err(error) => return fail(&args::one_line(&error), 2),
    };
    match run(&matches) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => fail(&error.to_string(), if error.is_bad_input() { 2 } else { 1 }),
    }
}

fn run(matches: &clap::ArgMatches) -> wire4d::Result<()> {
    match matches.subcommand() {
        Some(("multiview", matches)) => multiview::run(matches),
        Some(("stroke", matches)) => stroke::run(matches),
        Some(("fill", matches)) => fill::run(matches),
        Some(("render", matches)) => wires::render(matches),
        Some(("metrics", matches)) => wires::metrics(matches),
        Some(("export", matches)) => wires::export(matches),
        Some(("share", matches)) => wires::share(matches),
        Some(("open", matches)) => wires::open(matches),
        Some(("build", matches)) => build::run(matches),
        Some(("photograph", matches)) => photograph::run(matches),
        Some(("raster", matches)) => raster::run(matches),
        Some(("device", matches)) => wires::device(matches),
        _ => unreachable!("clap asks for a known verb"),
    }
}

fn fail(message: &str, status: u8) -> ExitCode {
    eprintln!("{}", message.replace('\n', " "));
    ExitCode::from(status)
}
