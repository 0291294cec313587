//! GLB files pass the Khronos glTF validator, run by Node from the page's packages.

use crate::export_support;
use crate::notice::not_tested;

use export_support as wires;
use std::path::{Path, PathBuf};
use std::process::Command;
use wire4d::export::{ExportOptions, Format, export};

/// The validator from `www/node_modules`; `npm ci` in `www` (which `cargo xtask test` does first) puts it there.
fn validator() -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/node_modules/gltf-validator");
    path.exists().then_some(path)
}

/// Errors and warnings of each file, in order.
fn validate(validator: &Path, files: &[PathBuf]) -> Vec<(u64, u64, String)> {
    const SCRIPT: &str = r#"
        const [validator, ...files] = process.argv.slice(1);
        const { validateBytes } = require(validator);
        const { readFileSync } = require('fs');
        (async () => {
            for (const file of files) {
                const report = await validateBytes(new Uint8Array(readFileSync(file)));
                const { numErrors, numWarnings, messages } = report.issues;
                console.log([numErrors, numWarnings, JSON.stringify(messages.slice(0, 3))].join('\t'));
            }
        })();
    "#;
    let output = Command::new("node").args(["-e", SCRIPT]).arg(validator).args(files).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let line = |line: &str| {
        let mut fields = line.splitn(3, '\t').map(str::to_owned);
        let mut number = || fields.next().unwrap().parse().unwrap();
        (number(), number(), fields.next().unwrap())
    };
    String::from_utf8(output.stdout).unwrap().lines().map(line).collect()
}

#[test]
fn the_validator_finds_no_error() {
    let Some(validator) = validator() else {
        // Where every tool is there (`cargo xtask test`), its absence is a failure.
        assert!(std::env::var_os("WIRE4D_REQUIRE_VALIDATOR").is_none(), "no gltf-validator in www/node_modules");
        return not_tested("GLB files by the Khronos validator: `npm ci` in www installs it");
    };
    let folder = tempfile::tempdir().unwrap();
    let mut files = vec![];
    for (name, wire) in wires::all() {
        let bytes = export(&wires::sculpture(wire), Format::Glb, None, None, &ExportOptions::default()).unwrap();
        files.push(folder.path().join(format!("{name}.glb")));
        std::fs::write(files.last().unwrap(), bytes).unwrap();
    }
    for (file, (errors, warnings, messages)) in files.iter().zip(validate(&validator, &files)) {
        assert_eq!((errors, warnings), (0, 0), "{}: {messages}", file.display());
    }

    // The sibling that must fail: an index beyond the vertices.
    let mut bytes = std::fs::read(&files[0]).unwrap();
    let end = bytes.len();
    bytes[end - 4..].copy_from_slice(&u32::MAX.to_le_bytes());
    let broken = folder.path().join("broken.glb");
    std::fs::write(&broken, bytes).unwrap();
    assert!(validate(&validator, &[broken])[0].0 > 0);
}
