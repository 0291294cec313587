import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { openShareCode } from "#sculpture/share/code";
import { fragmentIn } from "./pasted";

const FIELD = new URL("../../../../tests/field/share-link/", import.meta.url);
const read = (name: string): string => readFileSync(new URL(name, FIELD), "utf8");
const code = /w=([\w-]+)/.exec(read("good.txt"))![1]!;
const LINK = `https://wire.example/app/#v=1&job=stroke&w=${code}&preset=fast&seed=3`;
const FRAGMENT = `#v=1&job=stroke&w=${code}&preset=fast&seed=3`;

describe("a pasted link", () => {
  it("opens whatever programs made of it", () => {
    openShareCode(code);
    for (const name of readdirSync(FIELD)) {
      expect(/w=([\w-]+)/.exec(fragmentIn(read(name)) ?? "")?.[1], name).toBe(code);
    }
  });

  it("keeps its settings, and nothing of the sentence round it", () => {
    const [first, second] = [code.slice(0, 60), code.slice(60)];
    const texts = [
      LINK,
      FRAGMENT,
      `<${LINK}>`,
      `Look: ${LINK}. I like it!`,
      `(see ${LINK})`,
      `[mine](${LINK})`,
      `“${LINK}”`,
      LINK.replaceAll("&", "&amp;"),
      `> https://wire.example/app/#v=1&job=stroke&w=${first}\r\n> ${second}&preset=fast&seed=3\r\n> Bye`,
      LINK.replaceAll("=", "=3D").replace(first, `${first}=\r\n`),
      LINK.replace(second, `\u200b${second}\ufeff`),
      `https://check.example/?url=${encodeURIComponent(LINK)}`,
    ];
    for (const text of texts) expect(fragmentIn(text), text.slice(0, 60)).toBe(FRAGMENT);
  });

  it("may be a code alone, or a link without one", () => {
    expect(fragmentIn(` ${code}\n`)).toBe(`#w=${code}`);
    expect(fragmentIn("<https://wire.example/#v=1&job=fill&shape=vase>")).toBe("#v=1&job=fill&shape=vase");
    expect(fragmentIn("https://wire.example/#v=1&seed=3.")).toBe("#v=1&seed=3");
  });

  it("is told from other text, and a damaged one is still one", () => {
    for (const text of ["", "hello", "a sentence with w and multiviews", "https://wire.example/", "x".repeat(2 << 20)]) expect(fragmentIn(text)).toBeNull();
    expect(fragmentIn(`https://wire.example/#w=${code.slice(0, 90)}.`)).toBe(`#w=${code.slice(0, 90)}`);
  });
});

it("keeps what guides", () => {
  expect(fragmentIn("see https://wire.example/#v=1&preset=fast&guide-front=a%20cat&guide-weight=0.5.")).toBe("#v=1&preset=fast&guide-front=a%20cat&guide-weight=0.5");
});
