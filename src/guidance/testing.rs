//! Small ONNX files for tests: the fixtures, whole or spoilt, and some that are written field by field.

use crate::protobuf::Message;
use std::fs;
use std::path::{Path, PathBuf};
use wire4d_core::{Error, Result};

pub use crate::sidecar::sha256_of as sha256;

/// `TensorProto.DataType`.
pub const FLOAT: i64 = 1;
pub const INT8: i64 = 3;
pub const INT32: i64 = 6;
pub const INT64: i64 = 7;
pub const FLOAT16: i64 = 10;

/// A file of `tests/data/guidance`.
pub fn fixture(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../tests/data/guidance").join(name)
}

/// What `open` makes of the fixture `name` and its sidecar in a folder of their own, changed by `change`.
pub fn opened<T>(
    name: &str,
    open: fn(&Path) -> Result<T>,
    change: impl FnOnce(&mut Vec<u8>, &mut String),
) -> Result<T> {
    let folder = tempfile::tempdir().unwrap();
    let [onnx, json] = ["onnx", "json"].map(|ending| format!("{name}.{ending}"));
    let (mut bytes, mut text) = (fs::read(fixture(&onnx)).unwrap(), fs::read_to_string(fixture(&json)).unwrap());
    change(&mut bytes, &mut text);
    fs::write(folder.path().join(&onnx), bytes).unwrap();
    fs::write(folder.path().join(&json), text).unwrap();
    open(&folder.path().join(&onnx))
}

/// Why `open` refuses it.
pub fn spoilt<T>(name: &str, open: fn(&Path) -> Result<T>, change: impl FnOnce(&mut Vec<u8>, &mut String)) -> Error {
    opened(name, open, change).map(|_| ()).expect_err("a spoilt file was taken")
}

/// A graph being written.
#[derive(Default)]
pub struct Writer(Message);

impl Writer {
    /// A node of `operator`; `attributes` are integers.
    pub fn node(mut self, operator: &str, inputs: &[&str], outputs: &[&str], attributes: &[(&str, i64)]) -> Writer {
        let mut node = Message::default();
        inputs.iter().for_each(|input| node.bytes(1, input.as_bytes()));
        outputs.iter().for_each(|output| node.bytes(2, output.as_bytes()));
        node.bytes(4, operator.as_bytes());
        for (name, value) in attributes {
            let mut attribute = Message::default();
            attribute.bytes(1, name.as_bytes());
            attribute.integer(3, *value);
            attribute.integer(20, 2);
            node.bytes(5, &attribute.0);
        }
        self.0.bytes(1, &node.0);
        self
    }

    /// A tensor of weights.
    pub fn weights(mut self, name: &str, kind: i64, shape: &[i64], bytes: &[u8]) -> Writer {
        let mut tensor = Message::default();
        shape.iter().for_each(|&size| tensor.integer(1, size));
        tensor.integer(2, kind);
        tensor.bytes(8, name.as_bytes());
        tensor.bytes(9, bytes);
        self.0.bytes(5, &tensor.0);
        self
    }

    /// An input (field 11) or output (field 12); a size of 0 is the batch.
    pub fn port(mut self, field: u64, name: &str, kind: i64, shape: &[i64]) -> Writer {
        let (mut sizes, mut tensor, mut either, mut port) = <[Message; 4]>::default().into();
        for &size in shape {
            let mut dimension = Message::default();
            if size == 0 {
                dimension.bytes(2, b"batch")
            } else {
                dimension.integer(1, size)
            }
            sizes.bytes(1, &dimension.0);
        }
        tensor.integer(1, kind);
        tensor.bytes(2, &sizes.0);
        either.bytes(1, &tensor.0);
        port.bytes(1, name.as_bytes());
        port.bytes(2, &either.0);
        self.0.bytes(field, &port.0);
        self
    }

    /// The whole file, opset 18.
    pub fn file(mut self) -> Vec<u8> {
        let (mut model, mut set) = (Message::default(), Message::default());
        self.0.bytes(2, b"main");
        set.integer(2, 18);
        model.integer(1, 8);
        model.bytes(7, &self.0.0);
        model.bytes(8, &set.0);
        model.0
    }
}

/// A text-v1 graph of context 8: the unit vector of (sum of ids, 512), with weights stored as int8 and float16.
pub fn text_encoder() -> Vec<u8> {
    // 64 times a scale of 1 / 64.
    let column: Vec<u8> = [64, 0].repeat(8);
    let scales = 0x2400u16.to_le_bytes().repeat(8);
    let shift = [0u16, 0x6000].map(u16::to_le_bytes).concat();
    Writer::default()
        .weights("whole", INT8, &[8, 2], &column)
        .weights("scale", FLOAT16, &[8, 1], &scales)
        .weights("shift half", FLOAT16, &[1, 2], &shift)
        .weights("axes", INT64, &[1], &1i64.to_le_bytes())
        .node("Cast", &["whole"], &["wide"], &[("to", FLOAT)])
        .node("Cast", &["scale"], &["wide scale"], &[("to", FLOAT)])
        .node("Cast", &["shift half"], &["shift"], &[("to", FLOAT)])
        .node("Mul", &["wide", "wide scale"], &["matrix"], &[])
        .node("Cast", &["ids"], &["numbers"], &[("to", FLOAT)])
        .node("MatMul", &["numbers", "matrix"], &["sums"], &[])
        .node("Add", &["sums", "shift"], &["row"], &[])
        .node("Mul", &["row", "row"], &["squares"], &[])
        .node("ReduceSum", &["squares", "axes"], &["square"], &[("keepdims", 1)])
        .node("Sqrt", &["square"], &["length"], &[])
        .node("Div", &["row", "length"], &["embedding"], &[])
        .port(11, "ids", INT32, &[0, 8])
        .port(12, "embedding", FLOAT, &[0, 2])
        .file()
}
