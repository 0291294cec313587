/** The page's rooms know only what they are meant to know. */

import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join, relative, resolve } from "node:path";
import { describe, expect, it } from "vitest";

const SRC = import.meta.dirname;
/** The package with the element, which every room may use (`#sculpture/…`), and which uses none. */
const SCULPTURE = join(SRC, "../packages/wire-sculpture/src");
/** Its rooms, lowest first; `index.ts` uses all. */
const SCULPTURE_ROOMS: readonly string[] = ["scene", "share", "film", "element"];
/**
 * The rooms, lowest first: a room imports from itself and from those before it. A room may have rooms of its own, in the
 * same order. What of a task brings no elements lies in its folder and comes before `ui`; its elements lie in `parts/`.
 */
const ROOMS: readonly string[] = [
  "offline",
  "guidance",
  "film",
  "engine",
  "photograph",
  "workshop",
  "state/common",
  "words",
  "state/picture",
  "state/keeping",
  "state/lesson",
  "state/contract",
  "state/carrying",
  "state/settings",
  "state/address",
  "state/run",
  "state/opening",
  "state/teaching",
  "state/saving",
  "state/actions",
  "state",
  "view",
  "ui/shared",
  "ui/film",
  "ui/photograph",
  "ui/settings",
  "ui/guidance",
  "ui/stage",
  "ui/run",
  "ui/glass",
  "ui/hands",
  "ui/save",
  "ui/workshop",
  "ui/lesson",
  "ui/app",
  "tasks",
  "embed",
  "docs",
  "gallery",
  "teachers",
];
/** What a task's folder may know of elements: what the page wants of a task. */
const PAGE_TASK = "ui/shared/page-task";

/** Also those that come later (`import("…")`) and those of workers (`new URL("…", import.meta.url)`). */
const named = (text: string): string[] => [...text.matchAll(/\b(?:from|import|URL)\s*\(?\s*"(\.[^"]+)"/g)].map((match) => match[1]!);

/** Without those that come later. */
const atOnce = (text: string): string[] => [...text.matchAll(/\b(?:from|import)\s+"(\.[^"]+)"/g)].map((match) => match[1]!);

const files = readdirSync(SRC, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".ts") && !name.startsWith("engine/wasm/"));
const text = (file: string): string => readFileSync(join(SRC, file), "utf8");
const isTest = (file: string): boolean => /\.test\.ts$|test-bench/.test(file);
const from = (file: string, paths: readonly string[]): string[] => paths.map((path) => relative(SRC, resolve(SRC, file, "..", path.replace(/\?.*/, ""))));

/** Whether a file of the one room, by its path, may import the other file. */
function may(file: string, imported: string): boolean {
  if (imported.startsWith("..")) return true;
  const [here, there] = [file, imported].map((path) => ROOMS.findLastIndex((room) => path.startsWith(`${room}/`) && (room.includes("/") || !inside(path))));
  if (here! < 0) return true;
  if (file.startsWith("tasks/")) return mayTask(file, imported);
  return there! >= 0 && there! <= here!;
}

/** Whether a path lies in a room of a room. */
const inside = (path: string): boolean => ROOMS.some((room) => room.includes("/") && path.startsWith(`${room}/`));

const taskOf = (path: string): string | null => /^tasks\/([^/]+)\//.exec(path)?.[1] ?? null;
const isPart = (path: string): boolean => /^tasks\/[^/]+\/parts\//.test(path);

/** A task knows no other task; what of it brings no elements knows no elements, and only its engine knows the core. */
function mayTask(file: string, imported: string): boolean {
  const [own, other] = [taskOf(file), taskOf(imported)];
  if (own === null) return true;
  if (other !== null && other !== own) return false;
  if (imported.startsWith("tasks/") && other === null) return false;
  return isPart(file) || imported === PAGE_TASK || !imported.startsWith("ui/");
}

it("has a room for every file", () => {
  const rooms = new Set(ROOMS.map((room) => room.split("/")[0]!));
  expect(files.filter((file) => file.includes("/") && !rooms.has(file.split("/")[0]!))).toEqual([]);
  // A room with rooms of its own has no folder besides them.
  const stray = files.filter((file) => /^(state|ui)\/[^/]+\//.test(file) && !inside(file));
  expect(stray).toEqual([]);
});

it("imports only from rooms below", () => {
  const wrong = files.filter((file) => !isTest(file)).flatMap((file) => from(file, named(text(file))).filter((path) => !may(file, path)).map((path) => `${file} → ${path}`));
  expect(wrong).toEqual([]);
});

it("keeps the sculpture's element free of the page", () => {
  const sources = readdirSync(SCULPTURE, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".ts") && !isTest(name));
  expect(sources.length).toBeGreaterThan(20);
  const elsewhere = sources.flatMap((file) => {
    const all = [...readFileSync(join(SCULPTURE, file), "utf8").matchAll(/\b(?:from|import|URL)\s*\(?\s*"([^"\s]+)"/g)].map((match) => match[1]!);
    return all.filter((path) => relative(SCULPTURE, resolve(SCULPTURE, file, "..", path)).startsWith("..") || !path.startsWith(".")).map((path) => `${file} → ${path}`);
  });
  expect(elsewhere).toEqual([]);
  const floor = (path: string): number => (path.includes("/") ? SCULPTURE_ROOMS.indexOf(path.split("/")[0]!) : SCULPTURE_ROOMS.length);
  const upward = sources.flatMap((file) =>
    named(readFileSync(join(SCULPTURE, file), "utf8"))
      .map((path) => relative(SCULPTURE, resolve(SCULPTURE, file, "..", path)))
      .filter((path) => floor(path) < 0 || floor(path) > floor(file))
      .map((path) => `${file} → ${path}`),
  );
  expect(upward).toEqual([]);
});

it("goes round nowhere", () => {
  const graph = new Map(files.map((file) => [file, from(file, atOnce(text(file))).map((path) => (existsSync(join(SRC, `${path}.ts`)) ? `${path}.ts` : path))]));
  const done = new Set<string>();
  const circles: string[] = [];
  const walk = (file: string, way: readonly string[]): void => {
    if (way.includes(file)) circles.push([...way.slice(way.indexOf(file)), file].join(" → "));
    if (done.has(file) || way.includes(file)) return;
    for (const next of graph.get(file) ?? []) walk(next, [...way, file]);
    done.add(file);
  };
  for (const file of files) walk(file, []);
  expect(circles).toEqual([]);
});

it("leaves the wasm modules to the worker", () => {
  const knowing = files.filter((file) => from(file, named(text(file))).some((path) => path.includes("engine/wasm/")));
  expect(knowing.length).toBeGreaterThan(3);
  expect(knowing.filter((file) => !/^engine\/(core|files|mate)\.ts$|^photograph\/worker\.ts$|^tasks\/[^/]+\/engine\/[^/]+\.ts$/.test(file))).toEqual([]);
});

it("loads no element of a task before it is looked at", () => {
  const low = files.filter((file) => taskOf(file) && !isPart(file) && !isTest(file));
  expect(low.length).toBeGreaterThan(12);
  expect(low.filter((file) => from(file, atOnce(text(file))).some((path) => isPart(path) || /^ui\//.test(path) && path !== PAGE_TASK))).toEqual([]);
});

describe("a task's name", () => {
  const NAMES = ["multiview", "stroke", "fill"];
  /** A name as a string of its own, or as the key of a record. Groups of settings have like names, and so do styles, canvases and sidecars. */
  const naming = (text: string): string[] => {
    const code = text.replace(/css`[^`]*`|\/\*[^]*?\*\/|\/\/.*|readonly group: .*|GROUPS[^;]*;|\.word\("fill"/g, "");
    return NAMES.filter((name) => new RegExp(`["'\`]${name}["'\`]|[{,]\\s*${name}:|\\bdesks\\.${name}\\b|\\bgiven\\.${name}\\b`).test(code));
  };

  it("stands in its own folder and nowhere else", () => {
    const rooms = files.filter((file) => !file.startsWith("tasks/") && !isTest(file) && !file.startsWith("engine/generated/"));
    expect(rooms.flatMap((file) => naming(text(file)).map((name) => `${file}: ${name}`))).toEqual([]);
    expect(rooms.flatMap((file) => from(file, named(text(file))).filter((path) => taskOf(path)))).toEqual([]);
  });

  it("would be noticed", () => {
    expect(naming(`if (task === "fill") return;`)).toEqual(["fill"]);
    expect(naming(`const WORDS = { multiview: "Match", stroke: "Match" };`)).toEqual(["multiview", "stroke"]);
    expect(naming(`readonly group: "run" | "stroke";\n context.fill(); // "fill" \n css\`rect { fill: none; }\``)).toEqual([]);
  });
});

it("would notice an arrow that points upward", () => {
  expect(may("guidance/model.ts", "state/common/store")).toBe(false);
  expect(may("state/keeping/track.ts", "state/run/runs")).toBe(false);
  expect(may("state/studio.ts", "state/run/runs")).toBe(true);
  expect(may("ui/app/wire-app.ts", "tasks/fill/task")).toBe(false);
  expect(may("tasks/fill/task.ts", "tasks/stroke/given")).toBe(false);
  expect(may("tasks/fill/task.ts", "ui/shared/icons")).toBe(false);
  expect(may("tasks/fill/parts/shape-pad.ts", "ui/shared/icons")).toBe(true);
  const text = `import { a } from "./a"; import "./b"; const c = await import("./c"); new Worker(new URL("./d.ts", import.meta.url)); type E = import("./e").E;`;
  expect(named(text)).toEqual(["./a", "./b", "./c", "./d.ts", "./e"]);
  expect(atOnce(text)).toEqual(["./a", "./b"]);
});
