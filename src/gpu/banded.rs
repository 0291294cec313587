//! A linear map as buffers: its rows, and its columns for the way back.

use super::layout::{Row, Term};
use crate::wire::LinearMap;

/// A banded map and its transpose, the latter as a list of entries a column.
pub(super) struct Map {
    pub rows: Vec<Row>,
    pub starts: Vec<u32>,
    pub terms: Vec<Term>,
}

impl Map {
    pub fn new(map: &LinearMap<f32>) -> Map {
        let columns = map.columns();
        let mut lists = vec![Vec::new(); columns];
        for (i, row) in map.rows().iter().enumerate() {
            for (k, &weight) in row.weights.iter().enumerate() {
                lists[(row.first as usize + k) % columns].push(Term { row: i as u32, weight });
            }
        }
        let mut starts = vec![0];
        starts.extend(lists.iter().scan(0, |end, list| {
            *end += list.len() as u32;
            Some(*end)
        }));
        let rows = map.rows().iter().map(|row| Row { first: row.first, weights: row.weights }).collect();
        Map { rows, starts, terms: lists.concat() }
    }
}
