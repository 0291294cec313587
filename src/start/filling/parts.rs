//! Parts that do not touch, joined through space.

use super::strand::{Node, Strand};

pub fn joined(lines: Vec<Strand>) -> Vec<Node> {
    lines.into_iter().max_by_key(|line| line.len()).unwrap_or_default()
}
