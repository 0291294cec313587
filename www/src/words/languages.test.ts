import { expect, it } from "vitest";
import { addressIn, chosen, languageOf } from "./languages";

it("knows a language by any of its codes", () => {
  expect(["en-GB", "de-AT", "DE", "es-419", "ja-JP", "zh-TW", "zh-Hant-HK", "zh", "pseudo"].map(languageOf)).toEqual(["en", "de", "de", "es", "ja", "zh-Hant", "zh-Hant", "zh-Hant", "pseudo"]);
  expect(["fr", "", "den", "zh-CN", "zh-Hans", "constructor"].map(languageOf)).toEqual([null, null, null, null, null, null]);
});

it("asks the address, then what was chosen, then the browser, and passes by what it has not", () => {
  expect(chosen("es", "de", ["ja"])).toBe("es");
  expect(chosen("fr", "de", ["ja"])).toBe("de");
  expect(chosen(null, "nonsense", ["fr-FR", "ja"])).toBe("ja");
  expect(chosen(null, null, ["zh-CN", "zh"])).toBe("zh-Hant");
  expect(chosen(null, null, ["fr"])).toBe("en");
  expect(chosen(null, null, [])).toBe("en");
});

it("asks for a language by the address, and for none", () => {
  expect(addressIn("https://a.example/b/?c=d#w=AB", "de")).toBe("https://a.example/b/?c=d&lng=de#w=AB");
  expect(addressIn("https://a.example/b/?lng=ja&c=d#w=AB", "es")).toBe("https://a.example/b/?c=d&lng=es#w=AB");
  expect(addressIn("https://a.example/b/?lng=ja#w=AB", null)).toBe("https://a.example/b/#w=AB");
});
