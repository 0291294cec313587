/** The gallery's works: each is there, whole, one piece, and says what it was made of. */

import { existsSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { fromJson } from "#sculpture/element/source";
import works from "../../gallery/works.json";
import { cards } from "./cards";
import { addressOf, fileOf, KINDS, meshOf, namesOf, picturesOf, type Work } from "./works";

const all = works as readonly Work[];
const WWW = join(import.meta.dirname, "../..");
/** What the files may take, bytes. */
const MOST_WORK = 250_000;
const MOST_INPUT = 350_000;

it("holds at least eighteen works, of all three tasks, each by a name of its own", () => {
  expect(all.length).toBeGreaterThanOrEqual(18);
  for (const task of Object.keys(KINDS)) expect(all.filter((work) => work.task === task).length).toBeGreaterThanOrEqual(4);
  for (const of of ["name", "title", "sentence"] as const) expect(new Set(all.map((work) => work[of])).size).toBe(all.length);
});

describe.each(all)("$name", (work) => {
  it("has a title and one sentence", () => {
    expect(work.name).toMatch(/^[a-z]+(-[a-z]+)*$/);
    expect(work.title).toMatch(/^\p{Lu}.{1,30}[^.]$/u);
    expect(work.sentence).toMatch(/^\p{Lu}[^.!?]{15,100}\.$/u);
    expect(work.make[0]).toBe(work.task);
  });

  it("opens as one piece of wire, with its views", () => {
    const file = join(WWW, fileOf(work));
    expect(statSync(file).size).toBeLessThanOrEqual(MOST_WORK);
    const { wire, views } = fromJson(readFileSync(file, "utf8"));
    // A spline is one piece; a chain or a bag has every knot three times.
    expect(new Set(Array.from(wire.knots)).size).toBeGreaterThan(wire.knots.length - 8);
    expect(views.length).toBeGreaterThanOrEqual(work.task === "multiview" ? picturesOf(work).length : 1);
  });

  it("says what it was made of, and that is there", () => {
    const inputs = [...picturesOf(work), ...(meshOf(work) ? [meshOf(work)!] : [])];
    expect(inputs.length + namesOf(work).length).toBeGreaterThan(0);
    for (const input of inputs) expect(statSync(join(WWW, "gallery/inputs", input)).size).toBeLessThanOrEqual(MOST_INPUT);
    const { made_with, drawings, given } = JSON.parse(readFileSync(join(WWW, fileOf(work)), "utf8")) as Record<string, { readonly task?: string } | undefined>;
    expect(made_with?.task).toBe(work.task);
    // A mesh is too large for it, and lies beside.
    if (!meshOf(work)) expect(drawings ?? given).toBeDefined();
    for (const path of new URLSearchParams(addressOf(work).split("#")[1]).getAll("open")) expect(existsSync(join(WWW, path))).toBe(true);
  });
});

it("lists works as text, never as markup", () => {
  const list = cards([{ ...all[0]!, title: "<img src=x onerror=alert(1)>", sentence: 'a "b" & <c>.' }], "#");
  expect(list).not.toMatch(/<img src=x|<c>/);
  expect(list).toContain(`href="#${all[0]!.name}"`);
});
