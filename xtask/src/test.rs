//! `cargo xtask test`: every test there is, or one part of them.

use crate::Result;
use crate::page;
use crate::setup;
use crate::shell::{command, run as run_command, say};
use crate::wasm;

pub const HELP: &str = "run every test there is, or only those of one part";

pub fn run(options: &[String]) -> Result {
    let parts = ["rust", "web", "browser"];
    if let Some(unknown) = options.iter().find(|option| !parts.contains(&option.as_str())) {
        return Err(format!("there is no part `{unknown}`; the parts are {}", parts.join(", ")).into());
    }
    let wanted = |part: &str| options.is_empty() || options.iter().any(|option| option == part);
    if wanted("rust") {
        rust()?;
    }
    if wanted("web") || wanted("browser") {
        page::prepare()?;
    }
    if wanted("web") {
        web()?;
    }
    if wanted("browser") {
        browser()?;
    }
    Ok(())
}

/// The workspace's own tests; the libraries are also compiled the way the page uses them, by `page::prepare`, and here as
/// others may use them for wasm.
fn rust() -> Result {
    // The glTF validator that exported files are held against is one of them.
    page::install_packages()?;
    say("testing the core and the command line");
    let mut cargo = command("cargo");
    // This program is there already; among the others, with all that they ask of what they share, it would be compiled anew.
    cargo.args(["test", "--workspace", "--exclude", "xtask", "--locked"]).env("WIRE4D_REQUIRE_VALIDATOR", "1");
    // Where a driver could be had, a missing device is a failure.
    let device = setup::software_vulkan();
    if device {
        cargo.env("WIRE4D_REQUIRE_GPU", "1");
    }
    run_command(&mut cargo)?;
    run_command(command("cargo").args(["test", "--package", "xtask", "--locked"]))?;
    if !device {
        say("NOT TESTED: nothing on a graphics device, since there is no driver that stands in for one");
    }
    wasm::check_library()
}

/// Types and units of the page, and nothing said twice anywhere.
fn web() -> Result {
    say("looking for what is there twice");
    run_command(page::tool("jscpd/bin/jscpd").args([
        "--config",
        ".jscpd.json",
        "--exitCode",
        "1",
        "src",
        "packages",
        "../src",
        "../shaders",
        "../benches",
        "../xtask/src",
    ]))?;
    say("checking the page's types");
    run_command(page::tool("typescript/bin/tsc").arg("--noEmit"))?;
    say("testing the page's modules");
    run_command(page::tool("vitest/vitest.mjs").args(["run", "--project", "unit"]))
}

/// The built page in a real browser.
fn browser() -> Result {
    let chromium = setup::chromium()?;
    page::bundle()?;
    say(format!("testing the page in {}", chromium.display()));
    run_command(page::tool("vitest/vitest.mjs").args(["run", "--project", "browser"]).env("CHROMIUM", chromium))
}
