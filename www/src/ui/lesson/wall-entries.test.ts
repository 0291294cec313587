import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { entriesIn, sorted, withMore } from "./wall-entries";

const code = (job: string): string => readFileSync(join(import.meta.dirname, "../../tasks", job, "example/wire.code"), "utf8").trim();
const [A, B, C] = [code("multiview"), code("stroke"), code("fill")];
const link = (code: string): string => `https://school.example/wire/#v=1&w=${code}&seed=3`;

it("takes many links at once, with the names that stand round them", () => {
  const { entries, broken } = entriesIn(`Mia: ${link(A)}\n\nJonas\n${link(B)}\n${link(C)} - 楊\n`);
  expect(broken).toBe(0);
  expect(entries).toEqual([{ name: "Mia", code: A }, { name: "Jonas", code: B }, { name: "楊", code: C }]);
});

it("counts links that are cut off, and leaves everything else alone", () => {
  expect(entriesIn(`hello\nhttps://example.org/\n${link(A.slice(0, -9))}\n${link(B)}`)).toEqual({ entries: [{ name: "", code: B }], broken: 1 });
  expect(entriesIn("")).toEqual({ entries: [], broken: 0 });
});

it("hangs a wire once, and sorts by name", () => {
  const there = withMore([{ name: "", code: A }], [{ name: "b", code: B }, { name: "a", code: C }, { name: "Ä", code: A }, { name: "", code: B }]);
  expect(there.map(({ name }) => name)).toEqual(["Ä", "b", "a"]);
  expect(sorted([...there, { name: "", code: "x" }], "de").map(({ name }) => name)).toEqual(["a", "Ä", "b", ""]);
});
