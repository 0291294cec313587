//! What of an ONNX file is said otherwise, so that `rten` runs it: the arithmetic stays the same.
//!
//! - It reads no float16: such weights are widened. Every float16 is a float32.
//! - It gives no mean and deviation of a LayerNormalization, which a gradient needs: they are worked out beside it, by the
//!   formulas of ONNX's operator.
//! - It pads by no negative numbers, which take rows and columns away: those are sliced away.

use crate::protobuf::{Damaged, Field, Message, Value, fields};
use std::collections::HashMap;

/// Numbers of fields, from `onnx.proto`.
mod number {
    pub const MODEL_GRAPH: u64 = 7;
    pub const GRAPH_NODE: u64 = 1;
    pub const GRAPH_INITIALIZER: u64 = 5;
    pub const NODE_INPUT: u64 = 1;
    pub const NODE_OUTPUT: u64 = 2;
    pub const NODE_OPERATOR: u64 = 4;
    pub const NODE_ATTRIBUTE: u64 = 5;
    pub const ATTRIBUTE_NAME: u64 = 1;
    pub const ATTRIBUTE_FLOAT: u64 = 2;
    pub const ATTRIBUTE_INTEGER: u64 = 3;
    pub const ATTRIBUTE_INTEGERS: u64 = 8;
    pub const ATTRIBUTE_TYPE: u64 = 20;
    pub const TENSOR_TYPE: u64 = 2;
    pub const TENSOR_NAME: u64 = 8;
    pub const TENSOR_BYTES: u64 = 9;
}

/// `TensorProto.DataType`.
const FLOAT: i64 = 1;
const INT64: i64 = 7;
const FLOAT16: i64 = 10;

/// The model `file` holds, so that `rten` runs it.
pub fn adapt(file: &[u8]) -> Result<Vec<u8>, Damaged> {
    let mut model = Message(Vec::with_capacity(file.len()));
    for field in fields(file) {
        let field = field?;
        match field.number {
            number::MODEL_GRAPH => model.bytes(field.number, &graph(field.bytes())?),
            _ => model.0.extend_from_slice(field.whole),
        }
    }
    Ok(model.0)
}

fn graph(graph: &[u8]) -> Result<Vec<u8>, Damaged> {
    let mut changed = Message(Vec::with_capacity(graph.len()));
    let pads = small_integers(graph)?;
    for field in fields(graph) {
        let field = field?;
        match field.number {
            number::GRAPH_NODE => node(&field, &pads, &mut changed)?,
            number::GRAPH_INITIALIZER => weights(&field, &mut changed)?,
            _ => changed.0.extend_from_slice(field.whole),
        }
    }
    Ok(changed.0)
}

/// Integers of a graph's small tensors, by name: as many as a picture's pads are.
fn small_integers(graph: &[u8]) -> Result<HashMap<&str, Vec<i64>>, Damaged> {
    let mut found = HashMap::new();
    for field in fields(graph) {
        let tensor = field?;
        if tensor.number != number::GRAPH_INITIALIZER || tensor.bytes().len() > 256 {
            continue;
        }
        let parts = fields(tensor.bytes()).collect::<Result<Vec<_>, _>>()?;
        let part = |number| parts.iter().find(|part| part.number == number);
        let is_integer = part(number::TENSOR_TYPE).is_some_and(|kind| kind.integer() == INT64);
        if let (Some(name), Some(bytes), true) = (part(number::TENSOR_NAME), part(number::TENSOR_BYTES), is_integer) {
            let integers = bytes.bytes().as_chunks::<8>().0.iter().map(|&eight| i64::from_le_bytes(eight));
            found.insert(name.text(), integers.collect());
        }
    }
    Ok(found)
}

/// Adds a tensor of weights, widened if it is of float16.
fn weights(tensor: &Field, graph: &mut Message) -> Result<(), Damaged> {
    let parts = fields(tensor.bytes()).collect::<Result<Vec<_>, _>>()?;
    if !parts.iter().any(|part| part.number == number::TENSOR_TYPE && part.integer() == FLOAT16) {
        graph.0.extend_from_slice(tensor.whole);
        return Ok(());
    }
    let mut wide = Message::default();
    for part in parts {
        match part.number {
            number::TENSOR_TYPE => wide.integer(part.number, FLOAT),
            number::TENSOR_BYTES => {
                let halves = part.bytes().as_chunks::<2>().0.iter();
                let bytes: Vec<u8> = halves.flat_map(|&half| widened(u16::from_le_bytes(half)).to_le_bytes()).collect();
                wide.bytes(part.number, &bytes);
            }
            _ => wide.0.extend_from_slice(part.whole),
        }
    }
    graph.bytes(tensor.number, &wide.0);
    Ok(())
}

/// The float16 with these bits (IEEE 754: a sign, 5 bits of exponent, 10 of fraction).
fn widened(bits: u16) -> f32 {
    let (exponent, fraction) = (i32::from(bits >> 10 & 31), f32::from(bits & 1023));
    let size = match exponent {
        0 => fraction * 2f32.powi(-24),
        31 if fraction == 0.0 => f32::INFINITY,
        31 => f32::NAN,
        _ => (1024.0 + fraction) * 2f32.powi(exponent - 25),
    };
    if bits >> 15 == 1 { -size } else { size }
}

/// Adds a node, or what says the same: see above.
fn node(node: &Field, pads: &HashMap<&str, Vec<i64>>, graph: &mut Message) -> Result<(), Damaged> {
    let parts = fields(node.bytes()).collect::<Result<Vec<_>, _>>()?;
    let texts = |number| parts.iter().filter(move |part| part.number == number).map(|part| part.text());
    let inputs: Vec<&str> = texts(number::NODE_INPUT).collect();
    let outputs: Vec<&str> = texts(number::NODE_OUTPUT).collect();
    match (texts(number::NODE_OPERATOR).next(), &inputs[..], &outputs[..]) {
        (Some("LayerNormalization"), [input, ..], [_, _, ..]) => normalization(node, &parts, input, &outputs, graph),
        (Some("Pad"), [input, given, ..], [output]) if inputs.len() <= 3 => {
            let crop = pads.get(given).filter(|pads| pads.iter().all(|&pad| pad <= 0));
            match crop {
                Some(crop) => sliced(input, crop, output, graph),
                None => graph.0.extend_from_slice(node.whole),
            }
            Ok(())
        }
        _ => {
            graph.0.extend_from_slice(node.whole);
            Ok(())
        }
    }
}

/// Adds a node that takes away what pads of 0 and below would: first those before each axis, then those behind.
fn sliced(input: &str, crop: &[i64], output: &str, graph: &mut Message) {
    let (before, behind) = crop.split_at(crop.len() / 2);
    let starts: Vec<i64> = before.iter().map(|pad| -pad).collect();
    // Negative ends are counted from the end, and there is none behind all.
    let ends: Vec<i64> = behind.iter().map(|&pad| if pad < 0 { pad } else { i64::from(i32::MAX) }).collect();
    let names = ["starts", "ends"].map(|what| format!("{output}:{what}"));
    integers(graph, &names[0], starts);
    integers(graph, &names[1], ends);
    operation(graph, "Slice", &[input, &names[0], &names[1]], output);
}

/// Adds a LayerNormalization, and after it what works out its mean and one over its deviation.
fn normalization(
    node: &Field,
    parts: &[Field],
    input: &str,
    outputs: &[&str],
    graph: &mut Message,
) -> Result<(), Damaged> {
    let (mut axis, mut epsilon) = (-1, 1e-5);
    let mut normal = Message::default();
    let mut outputs_kept = 0;
    for part in parts {
        if part.number == number::NODE_ATTRIBUTE {
            read_attribute(part.bytes(), &mut axis, &mut epsilon)?;
        }
        outputs_kept += usize::from(part.number == number::NODE_OUTPUT);
        if part.number != number::NODE_OUTPUT || outputs_kept == 1 {
            normal.0.extend_from_slice(part.whole);
        }
    }
    // An axis that counts from the front tells how many there are only with the input's rank, which does not stand here.
    if axis >= 0 {
        graph.0.extend_from_slice(node.whole);
        return Ok(());
    }
    graph.bytes(number::GRAPH_NODE, &normal.0);
    let inner = |what: &str| format!("{}:{what}", outputs[0]);
    let named = |at: usize, what: &str| match outputs.get(at) {
        Some(&name) if !name.is_empty() => name.to_owned(),
        _ => inner(what),
    };
    let (mean, scale) = (named(1, "mean"), named(2, "scale"));
    let [axes, least, from_mean, squares, variance, raised, deviation] =
        ["axes", "epsilon", "from mean", "squares", "variance", "raised", "deviation"].map(inner);
    integers(graph, &axes, axis..0);
    constant(graph, &least, |attribute| {
        attribute.bytes(number::ATTRIBUTE_NAME, b"value_float");
        attribute.float(number::ATTRIBUTE_FLOAT, epsilon);
        attribute.integer(number::ATTRIBUTE_TYPE, 1);
    });
    // mean = E[x], scale = 1 / sqrt(E[(x - mean)^2] + epsilon).
    operation(graph, "ReduceMean", &[input, &axes], &mean);
    operation(graph, "Sub", &[input, &mean], &from_mean);
    operation(graph, "Mul", &[&from_mean, &from_mean], &squares);
    operation(graph, "ReduceMean", &[&squares, &axes], &variance);
    operation(graph, "Add", &[&variance, &least], &raised);
    operation(graph, "Sqrt", &[&raised], &deviation);
    operation(graph, "Reciprocal", &[&deviation], &scale);
    Ok(())
}

fn read_attribute(attribute: &[u8], axis: &mut i64, epsilon: &mut f32) -> Result<(), Damaged> {
    let parts = fields(attribute).collect::<Result<Vec<_>, _>>()?;
    let name = parts.iter().find(|part| part.number == number::ATTRIBUTE_NAME).map_or("", |part| part.text());
    for part in &parts {
        match (name, part.number, part.value) {
            ("axis", number::ATTRIBUTE_INTEGER, Value::Integer(value)) => *axis = value as i64,
            ("epsilon", number::ATTRIBUTE_FLOAT, Value::Four(bits)) => *epsilon = f32::from_bits(bits),
            _ => {}
        }
    }
    Ok(())
}

fn operation(graph: &mut Message, operator: &str, inputs: &[&str], output: &str) {
    let mut node = Message::default();
    inputs.iter().for_each(|input| node.bytes(number::NODE_INPUT, input.as_bytes()));
    node.bytes(number::NODE_OUTPUT, output.as_bytes());
    node.bytes(number::NODE_OPERATOR, operator.as_bytes());
    graph.bytes(number::GRAPH_NODE, &node.0);
}

fn integers(graph: &mut Message, output: &str, values: impl IntoIterator<Item = i64>) {
    constant(graph, output, |attribute| {
        attribute.bytes(number::ATTRIBUTE_NAME, b"value_ints");
        values.into_iter().for_each(|value| attribute.integer(number::ATTRIBUTE_INTEGERS, value));
        attribute.integer(number::ATTRIBUTE_TYPE, 7);
    });
}

fn constant(graph: &mut Message, output: &str, value: impl FnOnce(&mut Message)) {
    let (mut node, mut attribute) = (Message::default(), Message::default());
    value(&mut attribute);
    node.bytes(number::NODE_OUTPUT, output.as_bytes());
    node.bytes(number::NODE_OPERATOR, b"Constant");
    node.bytes(number::NODE_ATTRIBUTE, &attribute.0);
    graph.bytes(number::GRAPH_NODE, &node.0);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_float16_is_widened() {
        let known = [(0x3c00, 1.0), (0xc000, -2.0), (0x7bff, 65504.0), (0x0001, 5.9604645e-8), (0x3555, 0.33325195)];
        for (bits, value) in known {
            assert_eq!(widened(bits), value);
        }
        assert!(widened(0x8000).is_sign_negative() && widened(0xfc00) == f32::NEG_INFINITY && widened(0x7e00).is_nan());
        // They are in order.
        assert!((0..0x7c00).all(|bits| widened(bits) < widened(bits + 1)));
    }
}
