import { describe, expect, it } from "vitest";
import { selfContainedHtml, type SelfContained } from "./self-contained";

const GIVEN: SelfContained = {
  module: "export {};",
  attributes: [["code", "AbC-_9"], ["camera-controls", true]],
  title: "A bird",
  description: "One wire that shows a bird.",
  svg: "<svg xmlns='http://www.w3.org/2000/svg'/>",
  nonce: "abcdefghijklmnop",
};
const html = (change: Partial<SelfContained> = {}): string => selfContainedHtml({ ...GIVEN, ...change });
const HOSTILE = `"><script>alert(1)</script><!--</title><img src=x onerror='alert(2)'>&`;

/** What stands between tags that may run something. */
const scripts = (text: string): string[] => [...text.matchAll(/<script\b[^>]*>([\s\S]*?)<\/script\b/gi)].map((match) => match[1]!.trim());

describe("selfContainedHtml", () => {
  it("holds the element, its wire and its script", () => {
    expect(html()).toContain(`<wire-sculpture code="AbC-_9" camera-controls></wire-sculpture>`);
    expect(scripts(html())).toEqual(["export {};"]);
    expect(html()).toContain("<title>A bird</title>");
  });

  it("makes no markup of any text", () => {
    const text = html({ title: HOSTILE, description: HOSTILE, svg: HOSTILE, attributes: [["code", HOSTILE], ["alt", HOSTILE]] });
    expect(scripts(text)).toEqual(["export {};"]);
    expect(text.match(/<(?!!doctype)[\w!/-]+/g)).toEqual(html().replace(" camera-controls", "").match(/<(?!!doctype)[\w!/-]+/g));
    expect(text).not.toContain("onerror='");
  });

  it("keeps a script whole that speaks of scripts", () => {
    const module = 'export const said = "</script><!-- <script>" + `</SCRIPT>` + /<\\/script>|<!--/u.source; const [a, b] = [1, 2]; export const less = a<b;';
    const [kept, ...rest] = scripts(html({ module }));
    expect(rest).toEqual([]);
    expect(kept).not.toContain("<!--");
    // As a browser does.
    const run = (text: string): unknown => new Function(`${text.replaceAll("export const", "var")}; return [said, less];`)();
    const [said, less] = run(kept!) as [string, boolean];
    expect(said).toMatch(/^<\/script><!-- <script><\/SCRIPT>/);
    expect(new RegExp(said.slice(said.indexOf("SCRIPT>") + 7), "u").test("</script>")).toBe(true);
    expect(less).toBe(true);
  });

  it("lets nothing run or load but its own", () => {
    const policy = /Content-Security-Policy" content="([^"]*)"/.exec(html())![1]!;
    expect(policy).toContain("default-src 'none'");
    expect(policy).toContain("script-src 'nonce-abcdefghijklmnop'");
    expect(policy).not.toMatch(/unsafe|https?:|\*/);
    // Nothing that a browser would fetch.
    expect(html()).not.toMatch(/(?:src|href)="(?!data:)/);
  });

  it("refuses a nonce that would leave its quotes", () => {
    for (const nonce of ["", "short", `abcdefghijklmnop' 'unsafe-inline`]) expect(() => html({ nonce })).toThrow(/nonce/);
  });
});
