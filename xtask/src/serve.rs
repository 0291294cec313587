//! `cargo xtask serve`: the page on this machine.

use crate::Result;
use crate::page;
use crate::shell::say;
use std::net::TcpListener;

pub const HELP: &str = "build the page and serve it on 127.0.0.1 (--dev: reload while editing)";

const FIRST_PORT: u16 = 5173;

pub fn run(options: &[String]) -> Result {
    page::prepare()?;
    let development = options.iter().any(|option| option == "--dev");
    let mut server = page::tool("vite/bin/vite.js");
    if !development {
        page::bundle()?;
        server.arg("preview");
    }
    let port = (FIRST_PORT..FIRST_PORT + 100)
        .find(|&port| TcpListener::bind(("127.0.0.1", port)).is_ok())
        .ok_or("ports 5173 to 5272 of 127.0.0.1 are all taken")?;
    server.args(["--host", "127.0.0.1", "--strictPort", "--port", &port.to_string()]);
    say(format!("serving on http://127.0.0.1:{port}/ (Ctrl-C ends it)"));
    // In place of this program, so that whoever ends it ends the server.
    #[cfg(unix)]
    return Err(std::os::unix::process::CommandExt::exec(&mut server).into());
    #[cfg(not(unix))]
    crate::shell::run(&mut server)
}
