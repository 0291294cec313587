//! Programs from outside that the verbs need: installed when we may (root on a Debian-like system), named otherwise.

use crate::Result;
use crate::shell::{command, find_program, output, run, say};
use std::path::{Path, PathBuf};

/// Installs Debian packages, or fails with the one line that would.
pub fn install(purpose: &str, packages: &[&str]) -> Result {
    let line = format!("apt-get install -y --no-install-recommends {}", packages.join(" "));
    if find_program(&["apt-get"]).is_none() {
        return Err(format!("{purpose} is missing; on Debian or Ubuntu this installs it: {line}").into());
    }
    if output(command("id").arg("-u")).as_deref() != Some("0") {
        return Err(format!("{purpose} is missing; please run: sudo {line}").into());
    }
    say(format!("installing {purpose}: {line}"));
    let apt = || {
        let mut apt = command("apt-get");
        apt.env("DEBIAN_FRONTEND", "noninteractive").arg("-qq");
        apt
    };
    run(apt().arg("update"))?;
    run(apt().args(["install", "-y", "--no-install-recommends"]).args(packages))
}

/// Node and npm, which nothing here can install in a version that is new enough.
pub fn node() -> Result {
    let version = output(command("node").arg("--version")).unwrap_or_default();
    let mut parts = version.trim_start_matches('v').split('.').map(|part| part.parse().unwrap_or(0u32));
    let (major, minor) = (parts.next().unwrap_or(0), parts.next().unwrap_or(0));
    if (major, minor) < (20, 19) || find_program(&["npm"]).is_none() {
        let found = if version.is_empty() { "none".to_owned() } else { version };
        return Err(format!("Node 20.19 or newer and npm are needed (found: {found}); see https://nodejs.org").into());
    }
    Ok(())
}

const BROWSERS: &[&str] = &["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];

/// A Chromium for the browser tests; the variable CHROMIUM overrides the search.
pub fn chromium() -> Result<PathBuf> {
    if let Some(path) = std::env::var_os("CHROMIUM") {
        let path = PathBuf::from(path);
        return if path.is_file() {
            Ok(path)
        } else {
            Err(format!("CHROMIUM is {}, and there is no such file", path.display()).into())
        };
    }
    if find_program(BROWSERS).is_none() {
        install("Chromium for the browser tests", &["chromium"])?;
    }
    find_program(BROWSERS).ok_or_else(|| "Chromium was installed but is not on the PATH; set CHROMIUM to it".into())
}

/// A software Vulkan driver, so that GPU code has a device to be tested on, and whether there is one.
pub fn software_vulkan() -> bool {
    let driver_folder = Path::new("/usr/share/vulkan/icd.d");
    let is_there = || {
        driver_folder.read_dir().is_ok_and(|mut files| {
            files.any(|file| file.is_ok_and(|file| file.file_name().to_string_lossy().starts_with("lvp_icd")))
        })
    };
    if cfg!(target_os = "linux")
        && !is_there()
        && let Err(error) = install("a software Vulkan driver", &["mesa-vulkan-drivers", "libvulkan1"])
    {
        say(format!("going on without a software Vulkan driver: {error}"));
    }
    is_there()
}
