//! What a file should answer to inputs made by a formula: whether this runtime computes it rightly.

use crate::graph::{Feed, Graph, Port};
use crate::noise;
use serde::Deserialize;
use std::collections::BTreeMap;
use wire4d_core::{Error, Result};

/// A sidecar's self-test.
#[derive(Debug, Clone, Deserialize)]
pub struct SelfTest {
    batch: usize,
    tolerance: Tolerance,
    cases: Vec<Case>,
}

#[derive(Debug, Clone, Copy, Deserialize)]
struct Tolerance {
    relative: f64,
    absolute: f64,
    cosine: f64,
}

#[derive(Debug, Clone, Deserialize)]
struct Case {
    name: String,
    inputs: BTreeMap<String, Fill>,
    outputs: BTreeMap<String, Expected>,
}

/// How an input is made.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(tag = "fill", rename_all = "lowercase")]
enum Fill {
    Uniform { seed: u32 },
    Signed { seed: u32 },
    Unit { seed: u32 },
    Constant { value: f32 },
    Count { first: i32 },
}

/// What is known of an output.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
enum Expected {
    /// All of it.
    Values { values: Vec<f64> },
    /// Its length, and its sketch.
    Sketch { l2: f64, sketch: Vec<f64> },
}

impl SelfTest {
    /// Runs all cases.
    ///
    /// # Errors
    /// [`Error::Input`] for a self-test that says too little, [`Error::Guidance`] for answers that are off.
    pub fn check(&self, graph: &Graph) -> Result<()> {
        if self.cases.is_empty() || !(1..=8).contains(&self.batch) {
            return Err(malformed(graph, "has no case".into()));
        }
        self.cases.iter().try_for_each(|case| self.check_case(case, graph))
    }

    fn check_case(&self, case: &Case, graph: &Graph) -> Result<()> {
        let feeds = graph.inputs().into_iter().map(|port| {
            let fill = case.inputs.get(port.name).ok_or_else(|| malformed(graph, format!("fills no {}", port.name)))?;
            Ok(fill.feed(port, self.batch))
        });
        let answers = graph.run(feeds.collect::<Result<Vec<_>>>()?, self.batch)?;
        for (port, answer) in graph.outputs().iter().zip(&answers) {
            let expected = case.outputs.get(port.name);
            let expected = expected.ok_or_else(|| malformed(graph, format!("expects no {}", port.name)))?;
            if let Some(off) = expected.off(answer, &self.tolerance) {
                let problem =
                    format!("is not computed rightly here: {} of its self-test '{}' {off}", port.name, case.name);
                return Err(Error::guidance(graph.name(), problem, "go on without it, or export it as fp32"));
            }
        }
        Ok(())
    }
}

fn malformed(graph: &Graph, problem: String) -> Error {
    Error::input(graph.name(), format!("the sidecar's self-test {problem}"), "export the file again")
}

impl Fill {
    fn feed(self, port: &Port, batch: usize) -> Feed<'static> {
        let (count, width) = (port.count(batch), port.width());
        match self {
            Fill::Uniform { seed } => noise::uniform(seed, count).into(),
            Fill::Signed { seed } => noise::signed(seed, count).into(),
            Fill::Unit { seed } => noise::unit_rows(seed, count, width).into(),
            Fill::Constant { value } => vec![value; count].into(),
            Fill::Count { first } => (0..count).map(|i| first + (i % width) as i32).collect::<Vec<_>>().into(),
        }
    }
}

impl Expected {
    /// How `found` is off, if it is.
    fn off(&self, found: &[f32], tolerance: &Tolerance) -> Option<String> {
        match self {
            Expected::Values { values } => {
                let most = values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
                let allowed = tolerance.absolute + tolerance.relative * most;
                let offs = found.iter().zip(values).map(|(&a, b)| (f64::from(a) - b).abs());
                // Not `f64::max`: what is no number is to show.
                let off = offs.fold(0.0, |most, off| if off <= most { most } else { off });
                let fine = found.len() == values.len() && off <= allowed;
                (!fine).then(|| format!("is off by {off:.3}, and {allowed:.3} is allowed"))
            }
            Expected::Sketch { l2, sketch } => {
                let (length, found) = (noise::length(found), noise::sketch(found));
                let off = (length - l2).abs();
                if off.is_nan() || off > tolerance.relative * l2 {
                    return Some(format!("has length {length:.5}, and {l2:.5} is expected"));
                }
                let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
                let cosine = dot(&found, sketch) / (dot(&found, &found) * dot(sketch, sketch)).sqrt();
                let fine = found.len() == sketch.len() && cosine >= tolerance.cosine;
                (!fine).then(|| format!("points elsewhere: its cosine with what is expected is {cosine:.5}"))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOLERANCE: Tolerance = Tolerance { relative: 0.01, absolute: 0.001, cosine: 0.9995 };

    #[test]
    fn answers_that_are_off_are_told() {
        let few = Expected::Values { values: vec![1.0, -2.0] };
        assert_eq!(few.off(&[1.01, -2.0], &TOLERANCE), None);
        assert!(few.off(&[1.03, -2.0], &TOLERANCE).is_some());
        assert!(few.off(&[1.0], &TOLERANCE).is_some());
        assert!(few.off(&[1.0, f32::NAN], &TOLERANCE).is_some());

        let values = noise::signed(9, 5000);
        let many = Expected::Sketch { l2: noise::length(&values), sketch: noise::sketch(&values) };
        assert_eq!(many.off(&values, &TOLERANCE), None);
        let changed = |change: fn(usize, f32) -> f32| -> Vec<f32> {
            values.iter().enumerate().map(|(i, &value)| change(i, value)).collect()
        };
        assert_eq!(many.off(&changed(|_, value| value * 1.005), &TOLERANCE), None);
        assert!(many.off(&changed(|_, value| value * 1.02), &TOLERANCE).is_some());
        assert!(many.off(&changed(|_, value| -value), &TOLERANCE).is_some());
        assert!(many.off(&changed(|i, value| if i < 200 { -value } else { value }), &TOLERANCE).is_some());
        assert!(many.off(&changed(|i, value| if i == 7 { f32::NAN } else { value }), &TOLERANCE).is_some());
        let mut swapped = values.clone();
        swapped.swap_with_slice(&mut values[2500..].iter().chain(&values[..2500]).copied().collect::<Vec<_>>());
        assert!(many.off(&swapped, &TOLERANCE).is_some());
    }
}
