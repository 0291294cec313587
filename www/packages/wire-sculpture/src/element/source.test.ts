import { expect, it } from "vitest";
import { fromCode, fromJson, SourceError } from "./source";
import codes from "../testdata/codes.json";

const WIRE = { format: "wire4d", version: 1, closed: false, knots: [0, 0, 0, 0, 1, 1, 1, 1], control_points: [[0, 0, 0, 0.1], [1, 0, 0, 0.1], [1, 1, 0, 0.1], [0, 1, 0, 0.1]] };
const VIEW = { name: "front", projection: "orthographic", eye: [0, 0, 3], target: [0, 0, 0], up: [0, 1, 0], height_world: 2, width_px: 256, height_px: 256 };

it("reads a wire that is written out, and the views that can be seen through", () => {
  const { wire, views, replay } = fromJson(JSON.stringify({ ...WIRE, views: [VIEW, { ...VIEW, eye: "x" }, { ...VIEW, name: "<b>" }, null] }));
  expect(Array.from(wire.controlPoints)).toEqual(WIRE.control_points.flat());
  expect(views.map(({ name }) => name)).toEqual(["front"]);
  expect(replay).toBeNull();
});

it("reads a wire that is a code, alone or in a link", () => {
  const { code } = codes[0]!;
  const { wire } = fromCode(code);
  expect(fromJson(JSON.stringify({ format: "wire4d", version: 1, code, replay: "AAEC" }))).toEqual({ wire, views: fromCode(code).views, replay: Uint8Array.of(0, 1, 2) });
  expect(fromCode(`see https://example.org/#task=stroke&w=${code}`).wire).toEqual(wire);
});

it.each([
  ["{", /damaged/],
  ["null", /holds no wire/],
  [JSON.stringify({ ...WIRE, format: "gltf" }), /holds no wire/],
  [JSON.stringify({ ...WIRE, version: 2 }), /newer Wire4D/],
  [JSON.stringify({ ...WIRE, knots: [0] }), /1 knots for 4/],
  [JSON.stringify({ ...WIRE, knots: [0, 0, 0, 0, 1, 1, 1, null] }), /incomplete/],
  [JSON.stringify({ ...WIRE, knots: [0, 0, 0, 0, -1, 1, 1, 1] }), /fall/],
  [JSON.stringify({ ...WIRE, control_points: [[0, 0, 0]] }), /incomplete/],
  [JSON.stringify({ ...WIRE, control_points: WIRE.control_points.map(() => [0, 0, 0, -1]) }), /negative width/],
  [JSON.stringify({ format: "wire4d", version: 1, code: "AAAA" }), /damaged or incomplete/],
])("says in a sentence what is wrong with %s", (text, sentence) => {
  expect(() => fromJson(text)).toThrow(sentence);
  expect(() => fromJson(text)).toThrow(SourceError);
});
