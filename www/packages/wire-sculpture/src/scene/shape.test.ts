import { expect, it } from "vitest";
import { basis, Sampler, sampleWire, type WireShape } from "./shape";
import { buildRings, RING_FLOATS } from "./tube";

const knots = [0, 0, 0, 0, 0.7, 1.1, 2, 2, 2, 2];
const controlPoints = [0, 0, 0, 0.1, 1, 0, 0, 0.2, 1, 1, 0, 0.1, 0, 1, 1, 0.2, 0, 0, 1, 0.1, 1, 0, 1, 0.3];

it("has weights that sum to one and slopes that sum to nothing and match differences", () => {
  const [weights, slopes, before, after, unused] = Array.from({ length: 5 }, () => new Float64Array(4)) as Float64Array[];
  for (const [span, t] of [[3, 0.3], [4, 0.9], [5, 1.4]] as const) {
    basis(knots, span, t, weights!, slopes!);
    expect(weights!.reduce((a, b) => a + b)).toBeCloseTo(1, 12);
    expect(slopes!.reduce((a, b) => a + b)).toBeCloseTo(0, 12);
    basis(knots, span, t - 1e-5, before!, unused!);
    basis(knots, span, t + 1e-5, after!, unused!);
    for (let k = 0; k < 4; k++) expect(slopes![k]).toBeCloseTo((after![k]! - before![k]!) / 2e-5, 6);
  }
});

it("begins and ends an open wire at its first and last control point", () => {
  const samples = sampleWire({ closed: false, knots, controlPoints }, 5);
  expect(samples.strips).toEqual([{ first: 0, last: 15, closed: false }]);
  expect([...samples.points.subarray(0, 4)]).toEqual([0, 0, 0, Math.fround(0.05)]);
  expect([...samples.points.subarray(60, 64)].map((x) => Math.round(x * 1e6) / 1e6)).toEqual([1, 0, 1, 0.15]);
});

it("breaks where four knots are equal, and closes a closed wire", () => {
  const pieces = sampleWire({ closed: false, knots: [0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2], controlPoints: Array(32).fill(0.5) }, 4);
  expect(pieces.strips.map(({ first, last }) => [first, last])).toEqual([[0, 4], [5, 9]]);
  const loop = sampleWire({ closed: true, knots: Array.from({ length: 13 }, (_, i) => i), controlPoints }, 4);
  expect(loop.strips).toEqual([{ first: 0, last: 23, closed: true }]);
});

it("makes rings with frames at right angles, finite even where the wire stands still", () => {
  const still = { closed: false, knots, controlPoints: controlPoints.map((x, i) => (i < 16 ? [0, 0, 0, 0.1][i % 4]! : x)) };
  for (const wire of [{ closed: false, knots, controlPoints }, still]) {
    const samples = sampleWire(wire, 6);
    const { data, count } = buildRings(samples, samples.parameters);
    for (let ring = 0; ring < count; ring++) {
      const r = data.subarray(ring * RING_FLOATS, (ring + 1) * RING_FLOATS);
      expect(r.every(Number.isFinite)).toBe(true);
      expect(r[4]! * r[8]! + r[5]! * r[9]! + r[6]! * r[10]!).toBeCloseTo(0, 5);
      expect(Math.hypot(r[8]!, r[9]!, r[10]!)).toBeCloseTo(1, 5);
    }
    // Poles at both ends, so that nothing shows between strips.
    expect(data[3]).toBe(0);
    expect(data[(count - 1) * RING_FLOATS + 3]).toBe(0);
  }
});

it("samples wires that follow each other as it samples each by itself", () => {
  const sampler = new Sampler();
  const uniform = { closed: true, knots: Array.from({ length: 13 }, (_, i) => i), controlPoints };
  const moved = { ...uniform, controlPoints: controlPoints.map((x) => x + 0.1) };
  const uneven = { ...moved, knots: Array.from({ length: 13 }, (_, i) => i + (i % 6 === 4 ? 0.4 : 0)) };
  const shorter = { closed: false, knots: [0, 0, 0, 0, 1, 2, 2, 2, 2], controlPoints: controlPoints.slice(4) };
  const wires: readonly WireShape[] = [uniform, moved, uneven, { closed: false, knots, controlPoints }, shorter, uniform];
  for (const wire of wires) expect(sampler.sample(wire, 5)).toEqual(sampleWire(wire, 5));
  expect(sampler.sample(uniform, 2)).toEqual(sampleWire(uniform, 2));
});

it("gives each ring its sample's tone, and goes once round where the wire is closed", () => {
  const samples = sampleWire({ closed: true, knots: Array.from({ length: 13 }, (_, i) => i), controlPoints }, 4);
  const tones = Array.from({ length: samples.count }, (_, k) => k / 32);
  const { data, count } = buildRings(samples, tones);
  const ring = (k: number): number[] => [...data.subarray(k * RING_FLOATS, (k + 1) * RING_FLOATS)];
  expect(count).toBe(samples.count + 1);
  for (let k = 0; k < samples.count; k++) expect(ring(k)[7]).toBe(k / 32);
  // The same circle again, but no colour runs backwards over the last piece.
  expect(ring(count - 1).slice(0, 7)).toEqual(ring(0).slice(0, 7));
  expect(ring(count - 1)[7]).toBe(tones.at(-1));
});
