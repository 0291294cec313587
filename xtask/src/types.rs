//! `cargo xtask types`: what the core hands to the page as JSON, as TypeScript.

use crate::Result;
use crate::shell::{command, run as run_command};

/// For the list of verbs.
pub const HELP: &str = "write what the core hands to the page as TypeScript, after a change of it";

/// The test that compares also writes.
pub fn run(_: &[String]) -> Result {
    let mut cargo = command("cargo");
    cargo.args(["test", "--package", "wire4d", "--test", "files", "page_types"]);
    run_command(cargo.env("WIRE4D_WRITE_TYPES", "1"))
}
