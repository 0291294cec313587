//! An ONNX graph whose inputs and outputs are those of a contract, run on the processor by `rten`.

use crate::adapt::adapt;
use rten::{DataType, Dimension, Model, NodeId, ValueOrView, ValueType};
use rten_tensor::{Tensor, TensorView};
use std::borrow::Cow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use wire4d_core::{Error, Result};

/// An input or output by name and shape.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Port {
    /// Its name.
    pub name: &'static str,
    /// Sizes; `None` is the batch, any number from 1.
    pub shape: Vec<Option<usize>>,
    /// Whether it holds int32 rather than float32.
    pub is_integer: bool,
}

impl Port {
    /// A port of float32.
    pub fn new(name: &'static str, shape: impl Into<Vec<Option<usize>>>) -> Port {
        Port { name, shape: shape.into(), is_integer: false }
    }

    /// How many numbers it has for one batch size.
    pub fn count(&self, batch: usize) -> usize {
        self.sized(batch).iter().product()
    }

    /// Numbers a row; 1 of a port without rows.
    pub fn width(&self) -> usize {
        self.shape.last().copied().flatten().unwrap_or(1)
    }

    fn sized(&self, batch: usize) -> Vec<usize> {
        self.shape.iter().map(|size| size.unwrap_or(batch)).collect()
    }

    /// As people write it: `image[batch,3,32,32]`.
    fn words(&self) -> String {
        let sizes: Vec<_> =
            self.shape.iter().map(|size| size.map_or("batch".to_owned(), |size| size.to_string())).collect();
        format!("{}[{}] {}", self.name, sizes.join(","), if self.is_integer { "int32" } else { "float32" })
    }
}

/// What goes into an input.
#[derive(Debug, Clone)]
pub enum Feed<'a> {
    /// float32.
    Floats(Cow<'a, [f32]>),
    /// int32.
    Integers(Vec<i32>),
}

impl From<Vec<f32>> for Feed<'_> {
    fn from(values: Vec<f32>) -> Self {
        Feed::Floats(values.into())
    }
}

impl<'a> From<&'a [f32]> for Feed<'a> {
    fn from(values: &'a [f32]) -> Self {
        Feed::Floats(values.into())
    }
}

impl From<Vec<i32>> for Feed<'_> {
    fn from(values: Vec<i32>) -> Self {
        Feed::Integers(values)
    }
}

/// A graph that keeps its contract by name and shape.
pub struct Graph {
    name: String,
    model: Model,
    inputs: Vec<(Port, NodeId)>,
    outputs: Vec<(Port, NodeId)>,
}

impl Graph {
    /// The graph in `file`, an ONNX file that a person knows as `name`, with these inputs and outputs and no others.
    ///
    /// # Errors
    /// [`Error::Input`] for what is no ONNX file, has operators that are unknown here, or other inputs or outputs.
    pub fn open(name: &str, file: &[u8], inputs: Vec<Port>, outputs: Vec<Port>) -> Result<Graph> {
        let fault = |problem: String, remedy: &str| Error::input(name, problem, remedy);
        let adapted = adapt(file)
            .map_err(|_| fault("is damaged, or no ONNX file".into(), "export it again with tools/guidance"))?;
        let unopened = |why: &str| {
            let remedy = "export the network with tools/guidance, or run it in the page";
            fault(format!("cannot be opened here ({why})"), remedy)
        };
        // Whoever wrote the file, a flaw of its reader must not take the run with it.
        let model = match catch_unwind(|| Model::load(adapted)) {
            Ok(model) => model.map_err(|error| unopened(&error.to_string()))?,
            Err(_) => return Err(unopened("its operators do not fit together")),
        };
        let found = |ids: &[NodeId], ports: Vec<Port>, side: &str| {
            if ids.len() != ports.len() {
                let remedy = "export the network with tools/guidance";
                return Err(fault(format!("has {} {side}s, and its kind has {}", ids.len(), ports.len()), remedy));
            }
            let place = |port: Port| match ids.iter().find(|&&id| is_port(&model, id, &port)) {
                Some(&id) => Ok((port, id)),
                None => Err(fault(format!("has no {side} {}", port.words()), "export the network with tools/guidance")),
            };
            ports.into_iter().map(place).collect::<Result<Vec<_>>>()
        };
        let inputs = found(model.input_ids(), inputs, "input")?;
        let outputs = found(model.output_ids(), outputs, "output")?;
        Ok(Graph { name: name.to_owned(), model, inputs, outputs })
    }

    /// What a person knows it by.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its inputs, in the order in which [`Graph::run`] takes them.
    pub fn inputs(&self) -> Vec<&Port> {
        self.inputs.iter().map(|(port, _)| port).collect()
    }

    /// Its outputs, in the order in which [`Graph::run`] gives them.
    pub fn outputs(&self) -> Vec<&Port> {
        self.outputs.iter().map(|(port, _)| port).collect()
    }

    /// What it answers to `feeds`, each with its port's numbers for `batch` rows.
    ///
    /// # Errors
    /// [`Error::Guidance`] where an operator fails, or an answer has another size or is not finite.
    ///
    /// # Panics
    /// If feeds are not of their ports' sizes.
    pub fn run(&self, feeds: Vec<Feed>, batch: usize) -> Result<Vec<Vec<f32>>> {
        let fault = |problem: String| Error::guidance(&self.name, problem, "go on without it, or export it again");
        let mut given: Vec<(NodeId, ValueOrView)> = Vec::with_capacity(feeds.len());
        for ((port, id), feed) in self.inputs.iter().zip(&feeds) {
            let shape = port.sized(batch);
            given.push((
                *id,
                match feed {
                    Feed::Floats(values) => TensorView::from_data(&shape, values.as_ref()).into(),
                    Feed::Integers(values) => TensorView::from_data(&shape, values.as_slice()).into(),
                },
            ));
        }
        let wanted: Vec<NodeId> = self.outputs.iter().map(|&(_, id)| id).collect();
        let run = catch_unwind(AssertUnwindSafe(|| self.model.run(given, &wanted, None)));
        let answers = run.map_err(|_| fault("fails while it runs".into()))?;
        let answers = answers.map_err(|error| fault(format!("fails while it runs ({error})")))?;
        let read = |((port, _), answer): (&(Port, NodeId), rten::Value)| {
            let tensor = Tensor::<f32>::try_from(answer).map_err(|error| fault(format!("{}: {error}", port.name)))?;
            let values = tensor.into_data();
            if values.len() != port.count(batch) {
                return Err(fault(format!("answers {} numbers as {}", values.len(), port.words())));
            }
            match values.iter().all(|value| value.is_finite()) {
                true => Ok(values),
                false => Err(fault(format!("its {} is not finite", port.name))),
            }
        };
        self.outputs.iter().zip(answers).map(read).collect()
    }
}

fn is_port(model: &Model, id: NodeId, port: &Port) -> bool {
    let Some(node) = model.node_info(id) else { return false };
    let kind = if port.is_integer { DataType::Int32 } else { DataType::Float };
    let fits = |shape: Vec<Dimension>| {
        shape.len() == port.shape.len()
            && shape.iter().zip(&port.shape).all(|(found, wanted)| match (found, wanted) {
                (Dimension::Fixed(found), Some(wanted)) => found == wanted,
                (Dimension::Symbolic(_), None) => true,
                _ => false,
            })
    };
    node.name() == Some(port.name) && node.dtype() == Some(ValueType::Tensor(kind)) && node.shape().is_some_and(fits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::few_cases::few_cases;
    use crate::testing::{FLOAT, INT64, Writer, text_encoder};
    use proptest::prelude::*;

    type Change = fn(&mut Vec<Port>, &mut Vec<Port>);

    fn ports() -> (Vec<Port>, Vec<Port>) {
        let ids = Port { is_integer: true, ..Port::new("ids", [None, Some(8)]) };
        (vec![ids], vec![Port::new("embedding", [None, Some(2)])])
    }

    #[test]
    fn a_layer_normalization_gives_its_mean_and_scale() {
        let (ones, zeros) = ([1.0f32; 4].map(f32::to_le_bytes).concat(), [0.0f32; 4].map(f32::to_le_bytes).concat());
        let file = Writer::default()
            .weights("one", FLOAT, &[4], &ones)
            .weights("zero", FLOAT, &[4], &zeros)
            .node("LayerNormalization", &["x", "one", "zero"], &["y", "mean", "scale"], &[("axis", -1)])
            .port(11, "x", FLOAT, &[0, 4])
            .port(12, "y", FLOAT, &[0, 4])
            .port(12, "mean", FLOAT, &[0, 1])
            .port(12, "scale", FLOAT, &[0, 1])
            .file();
        let outputs = vec![
            Port::new("y", [None, Some(4)]),
            Port::new("mean", [None, Some(1)]),
            Port::new("scale", [None, Some(1)]),
        ];
        let graph = Graph::open("normal.onnx", &file, vec![Port::new("x", [None, Some(4)])], outputs).unwrap();
        let answers = graph.run(vec![vec![1.0, 2.0, 3.0, 6.0, 0.0, 0.0, 0.0, 0.0].into()], 2).unwrap();
        let scale = 1.0 / (3.5f32 + 1e-5).sqrt();
        let near =
            |found: &[f32], meant: &[f32]| found.iter().zip(meant).all(|(a, b)| (a - b).abs() < 1e-4 * (1.0 + b.abs()));
        assert!(near(&answers[0], &[-2.0 * scale, -scale, 0.0, 3.0 * scale, 0.0, 0.0, 0.0, 0.0]), "{answers:?}");
        assert!(near(&answers[1], &[3.0, 0.0]) && near(&answers[2], &[scale, 1e5f32.sqrt()]), "{answers:?}");
    }

    #[test]
    fn negative_pads_take_away() {
        let pads = [0i64, -1, 0, -2].map(i64::to_le_bytes).concat();
        let file = Writer::default()
            .weights("pads", INT64, &[4], &pads)
            .node("Pad", &["x", "pads"], &["y"], &[])
            .port(11, "x", FLOAT, &[0, 5])
            .port(12, "y", FLOAT, &[0, 2])
            .file();
        let [x, y] = [("x", 5), ("y", 2)].map(|(name, width)| vec![Port::new(name, [None, Some(width)])]);
        let graph = Graph::open("pads.onnx", &file, x, y).unwrap();
        let numbers: Vec<f32> = (0u8..10).map(f32::from).collect();
        assert_eq!(graph.run(vec![numbers.into()], 2).unwrap(), [[1.0, 2.0, 6.0, 7.0]]);
    }

    #[test]
    fn other_ports_are_refused_by_name() {
        let open = |change: Change| {
            let (mut inputs, mut outputs) = ports();
            change(&mut inputs, &mut outputs);
            Graph::open("text.onnx", &text_encoder(), inputs, outputs).map(|_| ())
        };
        assert_eq!(open(|_, _| {}), Ok(()));
        let faults: [(&str, Change); 5] = [
            ("input ids[batch,8] float32", |inputs, _| inputs[0].is_integer = false),
            ("input tokens[batch,8] int32", |inputs, _| inputs[0].name = "tokens"),
            ("output embedding[batch,3]", |_, outputs| outputs[0].shape[1] = Some(3)),
            ("output embedding[2,2]", |_, outputs| outputs[0].shape[0] = Some(2)),
            ("has 1 outputs, and its kind has 2", |_, outputs| outputs.push(Port::new("loss", []))),
        ];
        for (said, change) in faults {
            let error = open(change).unwrap_err().to_string();
            assert!(error.contains(said), "{said}: {error}");
        }
        let nonsense = Graph::open("text.onnx", b"nonsense", Vec::new(), Vec::new()).map(|_| ()).unwrap_err();
        assert!(nonsense.is_bad_input(), "{nonsense}");
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 300, ..few_cases() })]
        #[test]
        fn a_file_changed_anywhere_is_refused_or_answers(at in 0usize..1000, to in any::<u8>()) {
            let mut file = text_encoder();
            let at = at % file.len();
            file[at] = to;
            let (inputs, outputs) = ports();
            if let Ok(graph) = Graph::open("text.onnx", &file, inputs, outputs) {
                let _ = graph.run(vec![vec![1; 16].into()], 2);
            }
        }
    }
}
