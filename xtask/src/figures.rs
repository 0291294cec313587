//! `cargo xtask figures`: measures the projection error and draws it for the README.

use crate::{Result, shell};

/// For the list of verbs.
pub const HELP: &str = "measure the projection error and draw docs/projection-error.svg";

/// Runs the bench that writes the figure.
pub fn run(_: &[String]) -> Result {
    let root = shell::root();
    let figure = root.join("docs/projection-error.svg");
    std::fs::create_dir_all(root.join("docs"))?;
    shell::run(shell::command("cargo").args(["bench", "--bench", "projection_error", "--"]).arg(&figure))
}
