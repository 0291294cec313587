import { configureLocalization, str } from "@lit/localize";
import { generateMsgId } from "@lit/localize/internal/id-generation.js";
import { beforeAll, expect, it, vi } from "vitest";
import { settle } from "./language";
import { counted, count, decimal, listed, percent } from "./numbers";
import { told } from "./told";

const german = {
  [generateMsgId("is cut off", false)]: "ist abgeschnitten",
  [generateMsgId(["has ", " MB, more than 200"], false)]: str`hat ${0} MB, mehr als 200`,
  [generateMsgId("save it with fewer triangles", false)]: "speichere es mit weniger Dreiecken",
  [generateMsgId(["from ", " to ", ""], false)]: str`bis ${1} von ${0}`,
};

beforeAll(async () => {
  vi.stubGlobal("window", new EventTarget());
  const { setLocale } = configureLocalization({ sourceLocale: "en", targetLocales: ["de"], loadLocale: async () => ({ templates: german }) });
  await setLocale("de");
  settle("de", [["is cut off"], ["has ", " MB, more than 200"], ["save it with fewer triangles"], ["from ", " to ", ""]]);
});

it("says by clauses what the engine says", () => {
  expect(told("is cut off")).toBe("ist abgeschnitten");
  expect(told("vase.obj: has 1,234 MB, more than 200; save it with fewer triangles")).toBe("vase.obj: hat 1,234 MB, mehr als 200; speichere es mit weniger Dreiecken");
  expect(told("from here to there")).toBe("bis there von here");
});

it("leaves what it does not know as it is", () => {
  expect(told("a.png: something new; is cut off")).toBe("a.png: something new; ist abgeschnitten");
  expect(told("has (.*) no meaning [x]")).toBe("has (.*) no meaning [x]");
  expect(told("")).toBe("");
});

it("writes numbers and lists as the language does", () => {
  expect(count(12345.5)).toBe("12.345,5");
  expect(decimal(2, 2)).toBe("2,00");
  expect(percent(0.874)).toBe("87\u00a0%");
  expect(listed(["a", "b", "c"])).toBe("a, b und c");
  expect([0, 1, 2].map((number) => counted(number, "eins", "mehr"))).toEqual(["mehr", "eins", "mehr"]);
});
