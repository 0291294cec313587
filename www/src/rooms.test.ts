/** The page's rooms know only what they are meant to know. */

import { readdirSync, readFileSync } from "node:fs";
import { join, relative, resolve } from "node:path";
import { describe, expect, it } from "vitest";

const SRC = import.meta.dirname;
/** What each room may import from: itself and the rooms named. */
const MAY: Readonly<Record<string, readonly string[]>> = {
  embed: [],
  engine: ["embed"],
  state: ["engine", "embed"],
  view: ["state", "engine", "embed"],
  ui: ["view", "state", "engine", "embed"],
};

/** Also those that come later (`import("…")`) and those of workers (`new URL("…", import.meta.url)`). */
const named = (text: string): string[] => [...text.matchAll(/\b(?:from|import|URL)\s*\(?\s*"(\.[^"]+)"/g)].map((match) => match[1]!);

const imports = (file: string): string[] => named(readFileSync(file, "utf8")).map((path) => relative(SRC, resolve(file, "..", path)));

function forbidden(room: string, imported: readonly string[]): string[] {
  return imported.filter((path) => {
    const other = path.split("/")[0]!;
    return other !== room && other !== ".." && !MAY[room]!.includes(other);
  });
}

describe.each(Object.keys(MAY))("%s", (room) => {
  const files = readdirSync(join(SRC, room), { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".ts") && !name.startsWith("wasm/"));

  it("imports only from rooms below it", () => {
    expect(files.length).toBeGreaterThan(0);
    for (const file of files) expect(forbidden(room, imports(join(SRC, room, file)))).toEqual([]);
  });

  it("leaves the wasm modules to engine/core.ts and engine/model.ts", () => {
    for (const file of files) {
      if (room !== "engine" || !["core.ts", "model.ts"].includes(file)) expect(imports(join(SRC, room, file)).filter((path) => path.includes("wasm"))).toEqual([]);
    }
  });
});

it("would notice an arrow that points upward", () => {
  expect(forbidden("embed", ["embed/gl", "state/store"])).toEqual(["state/store"]);
  const text = `import { a } from "./a"; import "./b"; const c = await import("./c"); new Worker(new URL("./d.ts", import.meta.url)); type E = import("./e").E;`;
  expect(named(text)).toEqual(["./a", "./b", "./c", "./d.ts", "./e"]);
});
