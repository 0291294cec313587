import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import type { View } from "../scene/view";
import { crc32, fromBase64 } from "./base64";
import { codeIn, openShareCode, ShareCodeError } from "./code";

/** Codes with what `wire4d open` makes of them; long lists as SHA-256 of their doubles. */
interface Fixture {
  readonly name: string;
  readonly code: string;
  readonly closed: boolean;
  readonly seed: string;
  readonly task: string;
  readonly views: readonly View[];
  readonly points: number;
  readonly points_sha256: string;
  readonly knots_sha256: string;
  /** Where intervals are no halvings and the last bit depends on whose power of two it is. */
  readonly knots?: readonly number[];
}

const read = (file: string): unknown => JSON.parse(readFileSync(join(import.meta.dirname, "../testdata", file), "utf8"));
const older = read("codes.json") as Fixture[];
const fixtures = [...older.map((fixture) => ({ ...fixture, name: `${fixture.name}, version 1` })), ...(read("codes-2.json") as Fixture[])];
const named = (name: string): Fixture => fixtures.find((fixture) => fixture.name === name)!;
const sha256 = (numbers: ArrayLike<number>): string => createHash("sha256").update(new Uint8Array(Float64Array.from(numbers).buffer)).digest("hex");

const toBase64 = (bytes: Uint8Array): string => Buffer.from(bytes).toString("base64url");
/** A code whose checksum is right whatever its body says. */
function sealed(body: Uint8Array): string {
  const bytes = new Uint8Array(body.length + 4);
  bytes.set(body);
  new DataView(bytes.buffer).setUint32(body.length, crc32(body), true);
  return toBase64(bytes);
}
const bodyOf = (code: string): Uint8Array => fromBase64(code)!.slice(0, -4);

/** The same numbers each time (mulberry32). */
function generator(seed: number): () => number {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

describe.each(fixtures)("$name", (fixture) => {
  const { wire, views, task, seed } = openShareCode(codeIn(`https://example.org/#w=${fixture.code}`)!.code);

  it("opens to the core's wire, bit for bit", () => {
    expect(wire.closed).toBe(fixture.closed);
    expect(wire.controlPoints.length).toBe(4 * fixture.points);
    expect(sha256(wire.controlPoints)).toBe(fixture.points_sha256);
    if (fixture.knots) {
      expect(wire.knots.length).toBe(fixture.knots.length);
      fixture.knots.forEach((knot, k) => expect(wire.knots[k]).toBeCloseTo(knot, 11));
    } else {
      expect(sha256(wire.knots)).toBe(fixture.knots_sha256);
    }
  });

  it("has the core's views, task and seed", () => {
    expect(views).toEqual(fixture.views);
    expect([task, String(seed)]).toEqual([fixture.task, fixture.seed]);
  });
});

it("would notice one wrong bit", () => {
  const { controlPoints } = openShareCode(named("closed").code).wire;
  const other = Float64Array.from(controlPoints);
  other[7]! *= 1 + Number.EPSILON;
  expect(sha256(other)).not.toBe(named("closed").points_sha256);
});

it("follows the standards", () => {
  for (const [bytes, text] of [["", ""], ["f", "Zg"], ["fo", "Zm8"], ["foo", "Zm9v"], ["foobar", "Zm9vYmFy"]] as const) {
    expect(Buffer.from(fromBase64(text)!).toString()).toBe(bytes);
  }
  for (const bad of ["Z", "Zh", "Zg=", "Zm+v", "Zm9v Zg", "Zm9é", "Zm9v😀"]) expect(fromBase64(bad)).toBeNull();
  expect(crc32(new TextEncoder().encode("123456789"))).toBe(0xcbf43926);
});

it("says what is wrong, and what to do", () => {
  const body = bodyOf(named("closed").code);
  const newer = Uint8Array.from(body);
  newer[0] = 9;
  const older = Uint8Array.from(body);
  older[0] = 0;
  const cases: readonly [string, RegExp][] = [
    ["", /is empty; copy the whole/],
    ["a".repeat(90_000), /longer than any code; copy only/],
    ["no code!", /damaged or incomplete; copy the whole/],
    [sealed(new Uint8Array(0)), /damaged or incomplete/],
    [sealed(older), /damaged or incomplete/],
    [sealed(newer), /made by a newer Wire4D .*version 9.* reload the page/],
    [sealed(new Uint8Array([1])), /no valid wire|damaged/],
    [sealed(new Uint8Array([2])), /no valid wire|damaged/],
  ];
  for (const [text, sentence] of cases) {
    expect(() => openShareCode(text)).toThrow(ShareCodeError);
    expect(() => openShareCode(text)).toThrow(sentence);
  }
});

it("notices every truncation and every flipped bit", () => {
  const random = generator(1);
  for (const { code } of fixtures) {
    const bytes = fromBase64(code)!;
    for (let round = 0; round < 150; round++) {
      const cut = code.slice(0, Math.floor(random() * code.length));
      expect(() => openShareCode(cut)).toThrow(ShareCodeError);
      const flipped = Uint8Array.from(bytes);
      flipped[Math.floor(random() * bytes.length)]! ^= 1 << Math.floor(random() * 8);
      expect(() => openShareCode(toBase64(flipped))).toThrow(ShareCodeError);
    }
  }
});

it("opens or refuses what has a right checksum and a made-up body, and never hangs", () => {
  const random = generator(2);
  let refused = 0;
  for (let round = 0; round < 900; round++) {
    const body = Uint8Array.from(bodyOf(fixtures[round % fixtures.length]!.code));
    const from = 1 + Math.floor(random() * Math.min(40, body.length - 1));
    if (round % 3 === 0) for (let i = from; i < body.length; i++) body[i] = random() * 256;
    else body[from]! ^= 1 << Math.floor(random() * 8);
    try {
      const { wire, views } = openShareCode(sealed(round % 3 === 1 ? body.subarray(0, from) : body));
      // What is let through can be drawn.
      expect(Array.from(wire.controlPoints).every(Number.isFinite) && Array.from(wire.knots).every(Number.isFinite)).toBe(true);
      expect(views.length).toBeLessThanOrEqual(64);
    } catch (error) {
      expect(error).toBeInstanceOf(ShareCodeError);
      refused++;
    }
  }
  expect(refused).toBeGreaterThan(500);
}, 60_000);

it("opens 3,200 control points at once", () => {
  const { code } = named("long");
  // The best of a few, in the processor's time: the machine may be busy with something else.
  const timesMs = Array.from({ length: 8 }, () => {
    const before = process.cpuUsage();
    openShareCode(code);
    return process.cpuUsage(before).user / 1000;
  });
  expect(Math.min(...timesMs)).toBeLessThan(50);
});
