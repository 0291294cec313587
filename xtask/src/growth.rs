//! `cargo xtask growth`: how an iteration grows with pictures, views and points, natively and as wasm.

use crate::{Result, shell, wasm};

/// For the list of verbs.
pub const HELP: &str = "measure how an iteration grows with pictures, views and points, natively and in wasm";

/// What grows, to how much, milliseconds.
struct Row {
    name: String,
    value: f64,
    ms: f64,
}

/// Prints a row a case: milliseconds on one thread, and the exponent from the row before (1 is linear).
pub fn run(_: &[String]) -> Result {
    let native = rows(shell::command("cargo").args(["run", "--release", "--package", "wire4d-growth"]))?;
    let module = wasm::growth()?;
    let wasi = "const [module] = process.argv.slice(1); \
        const wasi = new (require('wasi').WASI)({ version: 'preview1' }); \
        WebAssembly.instantiate(require('fs').readFileSync(module), wasi.getImportObject()).then(({ instance }) => process.reallyExit(wasi.start(instance)));";
    let web = rows(shell::command("node").args(["--no-warnings", "--eval", wasi, "--"]).arg(module))?;
    println!(
        "| what grows | to | native, ms an iteration | exponent | wasm, ms | exponent |\n|---|---|---|---|---|---|"
    );
    for (at, (row, in_wasm)) in native.iter().zip(&web).enumerate() {
        let exponent = |rows: &[Row]| match at.checked_sub(1).map(|before| &rows[before]) {
            Some(before) if before.name == row.name => {
                format!("{:.2}", (rows[at].ms / before.ms).ln() / (row.value / before.value).ln())
            }
            _ => "–".into(),
        };
        let (here, there) = (exponent(&native), exponent(&web));
        println!("| {} | {} | {:.2} | {here} | {:.2} | {there} |", row.name, row.value, row.ms, in_wasm.ms);
    }
    Ok(())
}

fn rows(program: &mut std::process::Command) -> Result<Vec<Row>> {
    let output = program.stderr(std::process::Stdio::inherit()).output()?;
    if !output.status.success() {
        return Err(format!("the measuring program failed ({})", output.status).into());
    }
    let printed = String::from_utf8_lossy(&output.stdout);
    let row = |line: &str| {
        let mut parts = line.split('\t');
        let name = parts.next()?.to_owned();
        Some(Row { name, value: parts.next()?.parse().ok()?, ms: parts.next()?.parse().ok()? })
    };
    Ok(printed.lines().filter_map(row).collect())
}
