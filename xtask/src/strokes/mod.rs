//! `cargo xtask strokes`: draws the test pictures of the verb `stroke`, or runs it over them and shows what came of it.

mod pictures;
mod sheet;

use crate::shell::{root, say};
use crate::{Result, picture};

/// For the list of verbs.
pub const HELP: &str = "`pictures` draws tests/strokes; `sheet` runs every one and draws docs/gallery/strokes.png";

/// Options: `pictures` or `sheet`; after `sheet` anything for `wire4d stroke`.
pub fn run(arguments: &[String]) -> Result {
    match arguments.split_first() {
        Some((verb, [])) if verb == "pictures" => {
            let folder = root().join("tests/strokes");
            for (name, formula) in pictures::PICTURES {
                let path = folder.join(format!("{name}.png"));
                picture::save(&pictures::drawn(formula).into(), &path)?;
            }
            say(format!("{} pictures are in tests/strokes", pictures::PICTURES.len()));
            Ok(())
        }
        Some((verb, extra)) if verb == "sheet" => sheet::run(&pictures::PICTURES.map(|(name, _)| name), extra),
        _ => Err("say `pictures` or `sheet`".into()),
    }
}
