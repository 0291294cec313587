/** What can be told of an ONNX file before a runtime reads it: a protobuf message, of which only the outlines are looked at. */

/** A field of a message: its number, and its value (of wire type 0) or its bytes from `start` to `end`. */
interface Field {
  readonly number: number;
  readonly value: number;
  readonly start: number;
  readonly end: number;
}

/** Of ModelProto, GraphProto and TensorProto. */
const [IR_VERSION, GRAPH, OPSET, INITIALIZER, DATA_LOCATION, EXTERNAL] = [1, 7, 8, 5, 14, 1];

export interface OnnxOutline {
  /** Whether weights lie in another file. */
  readonly external: boolean;
}

/** Null if the bytes are no whole ONNX model: another kind of file, or one that was cut off. */
export function outlineOf(bytes: Uint8Array): OnnxOutline | null {
  const found = new Map<number, Field>();
  for (const field of fields(bytes, 0, bytes.length)) {
    if (!field) return null;
    found.set(field.number, field);
  }
  const [version, graph] = [found.get(IR_VERSION)?.value ?? 0, found.get(GRAPH)];
  if (version < 1 || version > 100 || !graph || !found.has(OPSET)) return null;
  let external = false;
  for (const field of fields(bytes, graph.start, graph.end)) {
    if (!field) return null;
    if (field.number !== INITIALIZER) continue;
    for (const part of fields(bytes, field.start, field.end)) {
      if (!part) return null;
      external ||= part.number === DATA_LOCATION && part.value === EXTERNAL;
    }
  }
  return { external };
}

/** The fields of the message between two places; null, and nothing more, where it is none. */
function* fields(bytes: Uint8Array, start: number, end: number): Generator<Field | null> {
  let at = start;
  /** A whole number of seven bits a byte; NaN where it runs over the end. */
  const varint = (): number => {
    let value = 0;
    for (let scale = 1; at < end && scale < 2 ** 70; scale *= 128) {
      const byte = bytes[at++]!;
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
    return NaN;
  };
  while (at < end) {
    const tag = varint();
    const [number, wire] = [Math.floor(tag / 8), tag % 8];
    let value = 0;
    let length = 0;
    if (wire === 0) value = varint();
    else if (wire === 1) length = 8;
    else if (wire === 2) length = varint();
    else if (wire === 5) length = 4;
    else value = NaN;
    if (!(number >= 1) || Number.isNaN(value) || !(at + length <= end)) {
      yield null;
      return;
    }
    yield { number, value, start: at, end: at + length };
    at += length;
  }
}
