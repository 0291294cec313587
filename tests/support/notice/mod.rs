//! What a test says that cannot do its work here.

use std::io::Write;

/// One line on standard error. Not by `eprintln!`, which is only heard of a test that fails.
pub fn not_tested(what: &str) {
    let _ = writeln!(std::io::stderr(), "NOT TESTED: {what}");
}
