/** Protobuf, written by hand: the outlines of an ONNX file, for tests. */

const varint = (value: number): number[] => (value < 128 ? [value] : [(value % 128) + 128, ...varint(Math.floor(value / 128))]);

export const number = (field: number, value: number): number[] => [...varint(field * 8), ...varint(value)];

export function message(field: number, bytes: readonly number[] | string): number[] {
  const inner = typeof bytes === "string" ? [...new TextEncoder().encode(bytes)] : bytes;
  return [...varint(field * 8 + 2), ...varint(inner.length), ...inner];
}

/** A model of one weight, which lies in another file. */
export function withoutWeights(): Uint8Array<ArrayBuffer> {
  const location = message(13, [...message(1, "location"), ...message(2, "weights.bin")]);
  const tensor = [...number(1, 4), ...number(2, 1), ...message(8, "w"), ...location, ...number(14, 1)];
  const graph = [...message(2, "graph"), ...message(5, tensor)];
  return Uint8Array.from([...number(1, 8), ...message(7, graph), ...message(8, number(2, 18))]);
}
