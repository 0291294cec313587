/** The documentation's snippets are accepted by what compiles them. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { compileScript, parse } from "@vue/compiler-sfc";
import { compile } from "svelte/compiler";
import { transformWithOxc } from "vite";
import { describe, expect, it } from "vitest";
import { openShareCode } from "#sculpture/share/code";

const EXAMPLES = join(import.meta.dirname, "../../packages/wire-sculpture/examples");
const example = (name: string): string => readFileSync(join(EXAMPLES, name), "utf8");

describe("a framework's snippet", () => {
  it("React: compiles to an element of that name", async () => {
    // Its types are looked at with those of the page: `tsc` goes over this folder, too.
    const { code } = await transformWithOxc(example("Sculpture.tsx"), "Sculpture.tsx", { jsx: { runtime: "automatic" } });
    expect(code).toMatch(/jsxs?\("wire-sculpture"/);
    await expect(transformWithOxc(example("Sculpture.tsx").replace("/>;", ";"), "Sculpture.tsx")).rejects.toThrow();
  });

  it("Vue: compiles to an element, not to a component that is looked for", () => {
    // As Vue's plugin for Vite hands it on.
    const templateParseOptions = { isCustomElement: (tag: string) => tag === "wire-sculpture" };
    const { descriptor, errors } = parse(example("Sculpture.vue"), { templateParseOptions });
    expect(errors).toEqual([]);
    const { content } = compileScript(descriptor, { id: "x", inlineTemplate: true, templateOptions: { compilerOptions: templateParseOptions } });
    expect(content).toContain(`_createElementBlock("wire-sculpture"`);
    expect(content).toContain("onViewChange");
    expect(content).not.toContain("resolveComponent");
  });

  it("Svelte: compiles without a warning", () => {
    const { js, warnings } = compile(example("Sculpture.svelte"), { generate: "client" });
    expect(warnings).toEqual([]);
    expect(js.code).toContain("<wire-sculpture");
  });
});

it("shows a wire that there is", () => {
  for (const name of ["element.html", "iframe.html"]) {
    const [, code] = /(?:code="|#w=)([\w-]+)/.exec(example(name))!;
    expect(openShareCode(code!).wire.controlPoints.length).toBeGreaterThan(100);
  }
});
