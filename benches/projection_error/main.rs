//! Prints the table of projection errors; with a file's name, also draws it there as an SVG.
//! `cargo bench --bench projection_error -- docs/projection-error.svg`

mod figure;

fn main() -> std::process::ExitCode {
    let columns = figure::columns(100);
    println!("pieces  bound px  largest px  mean px  drawn px  by arc length");
    for c in &columns {
        println!(
            "{:6}  {:8.5}  {:10.5}  {:7.5}  {:8.5}  {:9.2e}",
            c.pieces, c.bound_px, c.largest_px, c.mean_px, c.drawn_px, c.by_arc_length
        );
    }
    // Cargo adds --bench.
    let Some(path) = std::env::args().skip(1).find(|argument| !argument.starts_with('-')) else {
        return std::process::ExitCode::SUCCESS;
    };
    match wire4d::files::write_whole(std::path::Path::new(&path), figure::svg(&columns).as_bytes()) {
        Ok(()) => std::process::ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            std::process::ExitCode::FAILURE
        }
    }
}
