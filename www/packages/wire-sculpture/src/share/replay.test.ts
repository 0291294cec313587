import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { crc32 } from "./base64";
import { ShareCodeError } from "./code";
import { openReplay } from "./replay";

/** A replay with what the core makes of it; long lists as SHA-256 of their doubles. */
interface Fixture {
  readonly replay: string;
  readonly wires: readonly { iteration: number; closed: boolean; points: number; points_sha256: string; knots_sha256: string }[];
}

const { replay, wires } = JSON.parse(readFileSync(join(import.meta.dirname, "../testdata/replay.json"), "utf8")) as Fixture;
const bytes = new Uint8Array(Buffer.from(replay, "base64url"));
const sha256 = (numbers: ArrayLike<number>): string => createHash("sha256").update(new Uint8Array(Float64Array.from(numbers).buffer)).digest("hex");

describe("a replay", () => {
  it("opens to the core's wires, bit for bit", () => {
    const opened = openReplay(bytes).map(({ iteration, wire: { closed, knots, controlPoints } }) => ({
      iteration,
      closed,
      points: controlPoints.length / 4,
      points_sha256: sha256(controlPoints),
      knots_sha256: sha256(knots),
    }));
    expect(opened).toEqual(wires);
    expect(new Set(wires.map(({ points }) => points)).size).toBeGreaterThan(1);
  });

  it("is refused where a byte is missing or any bit is wrong", () => {
    for (let at = 0; at < bytes.length; at++) {
      expect(() => openReplay(bytes.subarray(0, at))).toThrow(ShareCodeError);
      const flipped = Uint8Array.from(bytes);
      flipped[at]! ^= 1 << (at % 8);
      expect(() => openReplay(flipped)).toThrow(ShareCodeError);
    }
    expect(() => openReplay(new Uint8Array(50_000))).toThrow(ShareCodeError);
  });

  it("opens or is refused where its checksum is right and the rest is made up", () => {
    let refused = 0;
    for (let at = 1; at < bytes.length - 4; at += 9) {
      const forged = Uint8Array.from(bytes);
      forged[at]! ^= 0x5a;
      new DataView(forged.buffer).setUint32(forged.length - 4, crc32(forged.subarray(0, -4)), true);
      try {
        for (const { wire } of openReplay(forged)) expect(Array.from(wire.controlPoints).every(Number.isFinite)).toBe(true);
      } catch (error) {
        expect(error).toBeInstanceOf(ShareCodeError);
        refused++;
      }
    }
    expect(refused).toBeGreaterThan(0);
  }, 30_000);
});
