//! The core, the reader of mesh files, the writer of files and the camera as WebAssembly, a module each: compile with SIMD, bind, optimise. Steps whose
//! input has not changed are skipped.

use crate::Result;
use crate::setup;
use crate::shell::{command, find_program, output, root, run, say, succeeds, www};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::Command;
use wasm_bindgen_cli_support::Bindgen;

const TARGET: &str = "wasm32-unknown-unknown";
const RUSTFLAGS: &str = "-C target-feature=+simd128";
/// Folder of its own: another compiler and other flags must not throw away the native build, nor it this.
const TARGET_DIR: &str = "target/web";

/// What the compiler may use: what `rustc` itself declares for this target plus SIMD.
const WASM_FEATURES: &[&str] = &[
    "--enable-simd",
    "--enable-bulk-memory",
    "--enable-sign-ext",
    "--enable-mutable-globals",
    "--enable-nontrapping-float-to-int",
    "--enable-multivalue",
    "--enable-reference-types",
];

/// What the page fetches at once, and what it fetches when somebody brings a mesh, saves, shares or builds a wire, or takes a photograph
/// of it: the crates and the names they have there.
const MODULES: [[&str; 2]; 5] = [
    ["wire4d-web", "wire4d"],
    ["wire4d-web-meshes", "wire4d_model"],
    ["wire4d-web-files", "wire4d_files"],
    ["wire4d-web-photograph", "wire4d_photograph"],
    ["wire4d-web-workshop", "wire4d_workshop"],
];

/// Builds `{.js,.d.ts,_bg.wasm}` of each module in `www/src/engine/wasm`; needs the page's packages (for wasm-opt).
pub fn build() -> Result {
    let packages = MODULES.iter().flat_map(|[package, _]| ["--package", package]);
    let mut cargo = cargo("build")?;
    run(cargo.args(packages).args(["--profile", "wasm"]))?;
    MODULES.iter().try_for_each(|[package, name]| finish(package, name))
}

/// Whether the library compiles for others as the README says that they may use it.
pub fn check_library() -> Result {
    let mut cargo = cargo("check")?;
    run(cargo.args(["--package", "wire4d", "--no-default-features", "--features", "threads", "--profile", "wasm"]))
}

/// The program that measures how iterations grow, for an engine of wasm outside a browser.
pub fn growth() -> Result<PathBuf> {
    const PACKAGE: &str = "wire4d-growth";
    const WASI: &str = "wasm32-wasip1";
    succeeds(command("rustup").args(["target", "add", WASI]));
    let mut cargo = command("cargo");
    cargo.env("RUSTFLAGS", RUSTFLAGS).args(["build", "--locked", "--package", PACKAGE, "--profile", "wasm"]);
    run(cargo.args(["--target", WASI, "--target-dir", TARGET_DIR]))?;
    Ok(root().join(TARGET_DIR).join(WASI).join("wasm").join(PACKAGE).with_extension("wasm"))
}

/// Binds and optimises a compiled module.
fn finish(package: &str, name: &str) -> Result {
    let compiled =
        root().join(TARGET_DIR).join(TARGET).join("wasm").join(package.replace('-', "_")).with_extension("wasm");
    let out_dir = www().join("src/engine/wasm");
    let stamp = out_dir.join(format!("{name}.stamp"));
    let bytes = std::fs::read(&compiled).map_err(|error| format!("cannot read {}: {error}", compiled.display()))?;
    let fingerprint = fingerprint(&bytes)?;
    if std::fs::read_to_string(&stamp).is_ok_and(|old| old == fingerprint) {
        say(format!("the wasm module {name} is fresh"));
        return Ok(());
    }
    bind(name, &compiled, &out_dir)?;
    let module = out_dir.join(format!("{name}_bg.wasm"));
    let size = |path: &Path| std::fs::metadata(path).map_or(0, |meta| meta.len() / 1000);
    let before_kb = size(&module);
    optimise(&module)?;
    say(format!("wasm module {name}: {before_kb} kB, {} kB after wasm-opt", size(&module)));
    std::fs::write(stamp, fingerprint)?;
    Ok(())
}

/// Everything the outputs depend on: the compiled module, the binder (linked into this program), and wasm-opt.
fn fingerprint(compiled: &[u8]) -> Result<String> {
    let mut hasher = DefaultHasher::new();
    compiled.hash(&mut hasher);
    WASM_FEATURES.hash(&mut hasher);
    std::fs::read(root().join("Cargo.lock"))?.hash(&mut hasher);
    std::fs::read(www().join("package-lock.json"))?.hash(&mut hasher);
    Ok(format!("{:016x}", hasher.finish()))
}

/// Cargo for wasm by the first route that works: the target of the person's own toolchain (installed, or added through
/// rustup), else Debian's compiler, which carries the standard library's source.
fn cargo(verb: &str) -> Result<Command> {
    let own = own_target_installed() || (find_program(&["rustup"]).is_some() && add_target());
    let mut cargo = if own { command("cargo") } else { debian_cargo()? };
    say(format!("{verb} for {TARGET} with {}", if own { "the toolchain at hand" } else { "Debian's compiler" }));
    cargo.env_remove("CARGO_ENCODED_RUSTFLAGS").env("RUSTFLAGS", RUSTFLAGS);
    cargo.args([verb, "--locked", "--target", TARGET, "--target-dir", TARGET_DIR]);
    if !own {
        // A nightly option; the bootstrap variable opens it on a release compiler.
        cargo.env("RUSTC_BOOTSTRAP", "1").arg("-Zbuild-std=std,panic_abort");
    }
    Ok(cargo)
}

fn own_target_installed() -> bool {
    output(command("rustc").args(["--print", "target-libdir", "--target", TARGET]))
        .is_some_and(|folder| Path::new(&folder).read_dir().is_ok_and(|mut files| files.next().is_some()))
}

fn add_target() -> bool {
    say(format!("trying `rustup target add {TARGET}`"));
    succeeds(command("rustup").args(["target", "add", TARGET])) && own_target_installed()
}

const DEBIAN_CARGO: &str = "/usr/bin/cargo";
const DEBIAN_RUSTC: &str = "/usr/bin/rustc";

fn debian_cargo() -> Result<Command> {
    if !debian_compiler_complete() {
        let packages = ["rustc-web", "cargo-web", "rust-web-src", "rust-web-llvm", "lld-22"];
        setup::install(&format!("a Rust compiler for {TARGET} (or run `rustup target add {TARGET}`)"), &packages)?;
    }
    let mut cargo = command(DEBIAN_CARGO);
    // `cargo run` through rustup leaves variables that would lead Debian's cargo back to rustup's compiler or libraries.
    for name in ["CARGO", "RUSTUP_TOOLCHAIN", "RUSTC_WRAPPER", "RUSTC_WORKSPACE_WRAPPER", "LD_LIBRARY_PATH", "RUSTDOC"]
    {
        cargo.env_remove(name);
    }
    cargo.env("RUSTC", DEBIAN_RUSTC);
    Ok(cargo)
}

/// A compiler of Debian's `-web` packages with the standard library's source and a linker for wasm.
fn debian_compiler_complete() -> bool {
    let Some(sysroot) = output(command(DEBIAN_RUSTC).env_remove("LD_LIBRARY_PATH").args(["--print", "sysroot"])) else {
        return false;
    };
    let library = PathBuf::from(sysroot).join("lib/rustlib/src/rust/library");
    Path::new(DEBIAN_CARGO).is_file()
        && library.join("std/Cargo.toml").is_file()
        && find_program(&["rust-lld"]).is_some()
}

fn bind(name: &str, compiled: &Path, out_dir: &Path) -> Result {
    say(format!("binding {name}"));
    let mut bindgen = Bindgen::new();
    bindgen.input_path(compiled).out_name(name).typescript(true).omit_default_module_path(true);
    bindgen.web(true).and_then(|bindgen| bindgen.generate(out_dir)).map_err(|error| format!("{error:#}"))?;
    Ok(())
}

fn optimise(module: &Path) -> Result {
    say("running wasm-opt");
    let wasm_opt = www().join("node_modules/binaryen/bin/wasm-opt");
    run(command("node")
        .arg(wasm_opt)
        .arg(module)
        .args(["-O3", "--one-caller-inline-max-function-size", "100"])
        .args(WASM_FEATURES)
        .arg("-o")
        .arg(module))
}
