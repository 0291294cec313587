//! `cargo xtask budget`: what the page may cost a device, measured on the built page in a real browser.

use crate::Result;
use crate::page;
use crate::setup;
use crate::shell::{command, run as run_command, say, www};

pub const HELP: &str = "measure the page's sizes, Lighthouse's scores, a slowed-down run, waits, processor time and films against their limits";

/// All parts by default; a limit that does not hold is a failure.
pub fn run(options: &[String]) -> Result {
    let parts = ["sizes", "audits", "run", "waits", "places", "films"];
    if let Some(unknown) = options.iter().find(|option| !parts.contains(&option.as_str())) {
        return Err(format!("there is no part `{unknown}`; the parts are {}", parts.join(", ")).into());
    }
    let chromium = setup::chromium()?;
    page::prepare()?;
    page::bundle()?;
    say("measuring the page; other work on this machine makes all but its sizes worse");
    let mut node = command("node");
    node.current_dir(www()).arg("tests/budget/run.mjs").args(options).env("CHROMIUM", chromium);
    run_command(&mut node).map_err(|_| "a limit does not hold, or it could not be measured; see above".into())
}
