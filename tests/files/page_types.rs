//! What the page is handed as JSON is written down for it as TypeScript, and what is written down is what it is handed.

use std::any::TypeId;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use ts_rs::{Config, TS, TypeVisitor};
use wire4d::metrics::{Faults, ResultReport};
use wire4d::optimize::{Event, Place};
use wire4d::settings::{Backend, Setting};
use wire4d::tasks::Placed;
use wire4d::tasks::multiview::preview::Preview;

const HEADING: &str = "\
/** What the core hands over as JSON. Written by `cargo xtask types` from the Rust types of the same names: change those. */
";

/// Declarations by name.
#[derive(Default)]
struct Declared {
    seen: BTreeSet<TypeId>,
    texts: BTreeMap<String, String>,
}

impl TypeVisitor for Declared {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        if !self.seen.insert(TypeId::of::<T>()) {
            return;
        }
        T::visit_dependencies(self);
        T::visit_generics(self);
        // Only what is derived has a place to go to; lists and numbers have none.
        if T::output_path().is_some() {
            let config = Config::new().with_large_int("number");
            let text = format!("{}export {}", T::docs().unwrap_or_default(), T::decl(&config));
            self.texts.insert(T::ident(&config), text);
        }
    }
}

fn generated() -> String {
    let mut declared = Declared::default();
    declared.visit::<Setting>();
    declared.visit::<Backend>();
    declared.visit::<Preview>();
    declared.visit::<Placed>();
    declared.visit::<Place>();
    declared.visit::<Event>();
    declared.visit::<ResultReport>();
    declared.visit::<Faults>();
    declared.texts.into_values().fold(HEADING.to_owned(), |text, one| text + "\n" + &tidy(&one))
}

/// Comments of one line on one line, fields indented.
fn tidy(text: &str) -> String {
    let text = text.replace("/**\n * ", "/** ").replace("\n */", " */").replace(", };", ",\n};");
    let mut inside = false;
    let lines = text.lines().map(|line| {
        let indent = if inside && !line.starts_with('}') { "  " } else { "" };
        inside = (inside || line.starts_with("export ")) && !line.ends_with(';');
        format!("{indent}{}\n", line.trim_end())
    });
    lines.collect()
}

#[test]
fn the_page_knows_what_it_is_handed() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/src/engine/generated/core.ts");
    if std::env::var_os("WIRE4D_WRITE_TYPES").is_some() {
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, generated()).unwrap();
    }
    let written = std::fs::read_to_string(&path).unwrap_or_default().replace('\r', "");
    assert!(written == generated(), "{} is not what the core hands over; run `cargo xtask types`", path.display());
}
