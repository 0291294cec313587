import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { openedAt, readLesson, textKeys, type Lesson } from "./lesson";

const FOLDER = join(import.meta.dirname, "../../../lessons");
const ids = readdirSync(FOLDER).filter((name) => !name.includes("."));
const json = (...path: string[]): unknown => JSON.parse(readFileSync(join(FOLDER, ...path), "utf8"));

const STEP = { id: "a", kind: "read" };
const LESSON = { version: 1, id: "x", job: "multiview", minutes: 5, steps: [STEP], sheet: [{ id: "q", lines: 2 }] };
const withStep = (step: object): unknown => ({ ...LESSON, steps: [{ ...STEP, ...step }] });

describe("every lesson that comes with the page", () => {
  it("is one of seven", () => expect(ids.length).toBe(7));

  it.each(ids)("%s is read, and lies where its name says", (id) => {
    expect(readLesson(json(id, "lesson.json")).id).toBe(id);
  });

  it.each(ids)("%s has a guess, something to do, an explanation, a teacher's note and a sheet", (id) => {
    const kinds = readLesson(json(id, "lesson.json")).steps.map(({ kind }) => kind);
    expect(kinds).toContain("predict");
    expect(kinds).toContain("explain");
    expect(kinds.some((kind) => kind === "run" || kind === "make" || kind === "try")).toBe(true);
    expect(kinds.at(-1)).toBe("wall");
  });

  it.each(ids)("%s has its files, and texts under exactly the keys that follow from its steps, in every language", (id) => {
    const lesson = readLesson(json(id, "lesson.json"));
    const files = readdirSync(join(FOLDER, id));
    expect(files).toContain("texts.en.json");
    for (const file of files.filter((file) => file.startsWith("texts."))) {
      const texts = json(id, file) as Readonly<Record<string, string>>;
      expect(Object.keys(texts).toSorted(), file).toEqual([...textKeys(lesson)].toSorted());
      expect(Object.entries(texts).filter(([, words]) => !words.trim()), file).toEqual([]);
    }
    for (const file of lesson.steps.flatMap(({ open }) => open?.files ?? [])) {
      if (file.includes("/")) expect(readFileSync(join(FOLDER, "..", file)).length).toBeGreaterThan(0);
      else expect(files).toContain(file);
    }
  });
});

it("says what is wrong with a lesson that cannot be read", () => {
  const wrong = (value: unknown): string => {
    try {
      readLesson(value);
    } catch (error) {
      return (error as Error).message;
    }
    return "";
  };
  expect(wrong(LESSON)).toBe("");
  expect(wrong({ ...LESSON, version: 2, dance: true })).toMatch(/newer Wire4D\. Reload/);
  expect(wrong(withStep({ kind: "dance" }))).toBe("“lesson: steps 1: kind” should be one of read, predict, try, run, explain, make, wall.");
  expect(wrong(withStep({ dance: true }))).toMatch(/“dance”, which is not known here/);
  expect(wrong(withStep({ view: "below" }))).toMatch(/should be one of room, front/);
  expect(wrong(withStep({ tool: "saw" }))).toMatch(/should be one of glass, hands/);
  expect(wrong(withStep({ open: { files: [] } }))).toMatch(/a list of at least 1/);
  expect(wrong(withStep({ question: { choices: ["a", "b"], right: "c" } }))).toMatch(/right answer of step “a”/);
  expect(wrong(withStep({ table: { columns: ["a", "b"], rows: [{ id: "r", values: [1] }] } }))).toMatch(/table of step “a”/);
  expect(wrong({ ...LESSON, steps: [] })).toMatch(/at least 1/);
  expect(wrong({ ...LESSON, steps: [STEP, STEP] })).toMatch(/Two steps/);
  expect(wrong({ ...LESSON, minutes: "5" })).toMatch(/a number/);
  expect(wrong({ ...LESSON, id: "../x" })).toMatch(/a name/);
  for (const value of [null, [], "x", 5, {}]) expect(wrong(value)).not.toBe("");
});

it("knows which step opened what lies on the page", () => {
  const lesson = readLesson({ ...LESSON, steps: [{ ...STEP, open: { example: true } }, { ...STEP, id: "b" }, { ...STEP, id: "c", open: { blank: true } }, { ...STEP, id: "d" }] });
  expect([0, 1, 2, 3].map((at) => openedAt(lesson, at))).toEqual([0, 0, 2, 2]);
  expect(openedAt({ ...lesson, steps: [STEP] } as unknown as Lesson, 0)).toBe(0);
});
