//! The page's packages and its static build.

use crate::Result;
use crate::setup;
use crate::shell::{command, root, run, say};
use crate::wasm;
use std::path::PathBuf;
use std::process::Command;

/// The page's folder.
pub fn folder() -> PathBuf {
    root().join("www")
}

/// One of the packages' programs, run in the page's folder.
pub fn tool(script: &str) -> Command {
    let mut node = command("node");
    node.current_dir(folder()).arg(folder().join("node_modules").join(script));
    node
}

/// Installs exactly the locked packages, unless they are there already.
pub fn install_packages() -> Result {
    setup::node()?;
    let lock = std::fs::read_to_string(folder().join("package-lock.json"))?;
    let stamp = folder().join("node_modules/.wire4d-lock");
    if std::fs::read_to_string(&stamp).is_ok_and(|old| old == lock) {
        say("the page's packages are fresh");
        return Ok(());
    }
    say("installing the page's packages");
    run(command("npm").current_dir(folder()).args(["ci", "--no-fund", "--no-audit"]))?;
    std::fs::write(stamp, lock)?;
    Ok(())
}

/// Packages and wasm: what any use of the page needs.
pub fn prepare() -> Result {
    install_packages()?;
    wasm::build()
}

/// The static page in `dist/`.
pub fn bundle() -> Result {
    say("bundling the page into dist/");
    run(tool("vite/bin/vite.js").args(["build", "--logLevel", "warn"]))
}
