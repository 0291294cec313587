import { createHash } from "node:crypto";
import { expect, it } from "vitest";
import { Words } from "./words";

const WORDS = ["cat", "cats", "dog", "puppy", "leaf", "box", "flower", "flowerpot", "Butterfly", "light bulb", "car", "nothing"];
const ROWS = [[100, 10, 0], [99, 12, 0], [90, 40, 0], [88, 45, 0], [0, 100, 0], [0, 0, 100], [0, 90, 20], [0, 80, 60], [10, 80, -20], [0, -20, 100], [-50, 0, 90], [0, 0, 0]];
const RAW = new Uint8Array(Int8Array.from(ROWS.flat()).buffer);

const sha256 = (bytes: Uint8Array): string => createHash("sha256").update(bytes).digest("hex");
const json = (change: object = {}, bytes = RAW): string => JSON.stringify({ kind: "word-table-v1", embed: 3, sha256: sha256(bytes), words: WORDS, ...change });
const words = await Words.open(json(), RAW, "x.words.json");

it("gives unit vectors, with scales behind the rows or without", async () => {
  expect(Math.hypot(...words.vector("Cat")!)).toBeCloseTo(1, 6);
  expect([...words.vector("leaf")!]).toEqual([0, 1, 0]);
  expect(words.vector("unicorn")).toBeNull();
  expect(words.vector("nothing")).toBeNull();
  const scaled = new Uint8Array([...RAW, ...new Uint8Array(Float32Array.from(WORDS, (_, i) => i + 1).buffer)]);
  expect((await Words.open(json({}, scaled), scaled, "x.words.json")).vector("dog")).toEqual(words.vector("dog"));
});

it("guesses what was meant", () => {
  expect(words.meant("cat")[0]).toBe("cat");
  expect(words.meant("cat")[1]).toBe("cats");
  expect(words.meant("dogs")[0]).toBe("dog");
  expect(words.meant("leaves")[0]).toBe("leaf");
  expect(words.meant("boxes")[0]).toBe("box");
  expect(words.meant("puppies")[0]).toBe("puppy");
  expect(words.meant("flow")).toEqual(["flower", "flowerpot"]);
  expect(words.meant("  BUTTERFLIES ")).toEqual(["Butterfly"]);
  expect(words.meant("buterfly")[0]).toBe("Butterfly");
  expect(words.meant("flwoer")[0]).toBe("flower");
  expect(words.meant("light  bulb")[0]).toBe("light bulb");
  // Of two letters, every other word would do.
  expect(words.meant("xx")).toEqual([]);
  expect(words.meant("")).toEqual([]);
  expect(words.meant("c", 1)).toHaveLength(1);
});

it("refuses what is no table", async () => {
  const WRONG: readonly [string, Uint8Array<ArrayBuffer>, RegExp][] = [
    ["{", RAW, /not JSON/],
    [json({ kind: "prompts-v1" }), RAW, /'kind'/],
    [json({ embed: 1e9 }), RAW, /'embed'/],
    [json({ words: WORDS.map(() => 7) }), RAW, /'words' must be texts/],
    [json(), RAW.slice(1), /have 35 bytes and should have 36/],
    [json(), RAW.map((byte) => byte ^ 1), /another file, or are damaged/],
  ];
  for (const [text, bytes, said] of WRONG) await expect(Words.open(text, bytes, "x.words.json")).rejects.toThrow(said);
});
