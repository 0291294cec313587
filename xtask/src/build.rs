//! `cargo xtask build`: a static folder that works from any host and any subpath.

use crate::Result;
use crate::page;
use crate::shell::say;

pub const HELP: &str = "make the static page in dist/, for any host and any subpath";

pub fn run(_options: &[String]) -> Result {
    page::prepare()?;
    page::bundle()?;
    say("dist/ is ready");
    Ok(())
}
