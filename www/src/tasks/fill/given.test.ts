import { expect, it } from "vitest";
import type { Affects } from "../../engine/protocol";
import { address, curveKey, lookKey, meshName, type Cover, type Settled } from "./given";

const vase: Cover = { mesh: { shape: "vase" }, style: "waves" };
const own: Cover = { mesh: { key: "k1", name: "bunny.obj", file: new Blob() }, style: null };
/** As in the core's table. */
const AFFECTS: Readonly<Record<string, readonly Affects[]>> = {
  curve_spacing: ["course", "curve"], flow: ["course", "curve"], start: ["course", "curve"], seed: ["pictures", "curve"],
  density: ["pictures", "look"], style_strength: ["pictures", "styled-look"],
  style_size: ["pictures", "styled-curve", "styled-look"], motif: ["pictures", "styled-curve", "styled-look"],
};
const settled = (changed: Readonly<Record<string, string>>): Settled => {
  const value = (name: string): string => changed[name] ?? "0";
  return { value, affecting: (what) => Object.keys(AFFECTS).filter((name) => AFFECTS[name]!.includes(what)).map(value) };
};
const key = (cover: Cover, changed: Readonly<Record<string, string>> = {}) => curveKey(cover, settled({ flow: "smooth", ...changed }));

it("tells apart what makes another curve, and nothing else", () => {
  for (const [name, value] of [["curve_spacing", "0.1"], ["flow", "along"], ["start", "tour"], ["seed", "1"]] as const) expect(key(vase, { [name]: value })).not.toBe(key(vase));
  expect(key(vase, { density: "0.9", style_size: "2" })).toBe(key(vase));
  expect(key({ ...vase, style: "petals" })).toBe(key(vase));
  expect(key({ ...vase, mesh: { shape: "knot" } })).not.toBe(key(vase));
});

it("tells apart wires that only look another way, and minds the style's settings where there is one", () => {
  const look = (cover: Cover, changed: Readonly<Record<string, string>> = {}) => lookKey(cover, settled(changed));
  const plain: Cover = { ...vase, style: null };
  for (const name of ["density", "style_strength", "motif"]) expect(look(vase, { [name]: "2" })).not.toBe(look(vase));
  expect(look({ ...vase, style: "petals" })).not.toBe(look(vase));
  expect(look(plain, { density: "2" })).not.toBe(look(plain));
  expect(look(plain, { style_strength: "2" })).toBe(look(plain));
  expect(look(vase, { curve_spacing: "2" })).toBe(look(vase));
});

it("minds the style where lines follow it", () => {
  const flow = { flow: "style" };
  expect(key({ ...vase, style: "petals" }, flow)).not.toBe(key(vase, flow));
  expect(key(vase, { ...flow, style_size: "2" })).not.toBe(key(vase, flow));
});

it("tells one file from its namesake", () => {
  const picture = (key: string): Cover => ({ ...vase, style: { key, name: "image.png", width: 1, height: 1, rgba: new Blob() } });
  expect(key(picture("p1"), { flow: "style" })).not.toBe(key(picture("p2"), { flow: "style" }));
  expect(key(own)).not.toBe(key({ ...own, mesh: { key: "k2", name: "bunny.obj", file: new Blob() } }));
});

it("puts into words what can travel", () => {
  expect(address.write(vase)).toEqual({ shape: "vase", style: "waves" });
  // A mesh of one's own stays where it is, and so does what it wears.
  expect(address.write({ ...own, style: "waves" })).toEqual({});
  expect(address.read({ shape: "vase", style: "waves" })).toEqual(vase);
  expect(address.read({ shape: "vase", style: "tartan" })).toEqual({ ...vase, style: null });
  expect(address.read({ shape: "teapot", style: "waves" })).toBeNull();
  expect([meshName(vase.mesh), meshName(own.mesh)]).toEqual(["Vase", "bunny.obj"]);
});
