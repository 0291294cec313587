//! The page's packages and its static build.

use crate::Result;
use crate::setup;
use crate::shell::{command, run, say, www};
use crate::{wasm, works};
use std::process::Command;

/// One of the packages' programs, run in the page's folder.
pub fn tool(script: &str) -> Command {
    let mut node = command("node");
    node.current_dir(www()).arg(www().join("node_modules").join(script));
    node
}

/// Installs exactly the locked packages, unless they are there already.
pub fn install_packages() -> Result {
    setup::node()?;
    let lock = std::fs::read_to_string(www().join("package-lock.json"))?;
    let stamp = www().join("node_modules/.wire4d-lock");
    if std::fs::read_to_string(&stamp).is_ok_and(|old| old == lock) {
        say("the page's packages are fresh");
        return Ok(());
    }
    say("installing the page's packages");
    run(command("npm").current_dir(www()).args(["ci", "--no-fund", "--no-audit"]))?;
    std::fs::write(stamp, lock)?;
    Ok(())
}

/// Packages, posters and wasm: what any use of the page needs.
pub fn prepare() -> Result {
    install_packages()?;
    works::posters()?;
    wasm::build()
}

/// The static page in `dist/`.
pub fn bundle() -> Result {
    say("bundling the page into dist/");
    run(tool("vite/bin/vite.js").args(["build", "--logLevel", "warn"]))
}
