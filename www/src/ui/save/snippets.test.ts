import { describe, expect, it } from "vitest";
import { attributesOf, elementSnippet, iframeSnippet, svgSnippet, type Embedded, type Showing } from "./snippets";

const SHOWING: Showing = { look: "copper", color: null, room: true, turning: false, buttons: true, size: { width: null, height: 480 } };
const EMBEDDED: Embedded = { site: "https://example.org/wire/", code: "AbC-_9", alt: "A bird", showing: SHOWING };
const HOSTILE = `"><script>alert(1)</script>&#`;

describe("the element's snippet", () => {
  it("says only what is not so anyway", () => {
    expect(elementSnippet(EMBEDDED)).toBe(
      `<script type="module" src="https://example.org/wire/wire-sculpture.js"></script>
<wire-sculpture code="AbC-_9" alt="A bird" shadow views camera-controls style="display: block; height: 480px"></wire-sculpture>`,
    );
  });

  it("has a colour for metal only", () => {
    expect(attributesOf({ ...SHOWING, look: "steel", color: "#123456" })).toContainEqual(["color", "#123456"]);
    expect(attributesOf({ ...SHOWING, look: "width", color: "#123456" }).map(([name]) => name)).not.toContain("color");
  });
});

it("gives an iframe its choices in the fragment, which no server sees", () => {
  const showing: Showing = { ...SHOWING, look: "steel", color: "#123456", turning: true, size: { width: 640, height: 480 } };
  const snippet = iframeSnippet({ ...EMBEDDED, showing });
  const src = new URL(/src="([^"]*)"/.exec(snippet)![1]!.replaceAll("&amp;", "&"));
  expect(src.pathname).toBe("/wire/embed.html");
  expect(Object.fromEntries(new URLSearchParams(src.hash.slice(1)))).toEqual({ w: "AbC-_9", look: "steel", color: "#123456", shadow: "", "auto-rotate": "", views: "", alt: "A bird" });
  expect(snippet).toContain(`title="A bird" width="640" height="480" loading="lazy"`);
});

it("makes no markup of any text", () => {
  for (const snippet of [elementSnippet({ ...EMBEDDED, alt: HOSTILE }), iframeSnippet({ ...EMBEDDED, alt: HOSTILE }), svgSnippet(HOSTILE, HOSTILE, SHOWING.size)]) {
    expect(snippet).not.toContain("<script>");
    expect(snippet.match(/"/g)!.length % 2).toBe(0);
  }
});
