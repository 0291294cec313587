/** The page in its languages: which it takes, that all of it is in it, and that longer words have room. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { LANGUAGES } from "../../src/words/languages";
import { axeFaults, fits } from "./a11y";
import { ROOT, settled, shoot, visit, type VisitOptions } from "./browser";
import { openSite } from "./site";

const { browser, site } = await openSite();

const read = (path: string): Readonly<Record<string, string>> => JSON.parse(readFileSync(join(ROOT, "www", path), "utf8")) as Readonly<Record<string, string>>;
const OTHERS = Object.keys(LANGUAGES).filter((language) => language !== "en");
/** A text of the first view, in each language. */
const heading = (language: string): string => (language === "en" ? "Match" : read(`words/${language}.json`)["Match"]!);

const languageOf = (page: Page): Promise<string> => page.evaluate(() => document.documentElement.lang);
const PHONE: VisitOptions = { viewport: { width: 360, height: 740 } };

/** Its sentences and names that are not of this language's disguise, marks of formats and names aside. */
function undisguised(page: Page): Promise<readonly string[]> {
  return page.evaluate(() => {
    const found = new Set<string>();
    const note = (text: string | null): void => {
      const words = text?.trim() ?? "";
      if (/\p{L}{2}/u.test(words) && !words.includes("[")) found.add(words);
    };
    const walk = (node: Node): void => {
      if (node instanceof Text) return note(node.data);
      if (!(node instanceof Element || node instanceof ShadowRoot)) return;
      if (node instanceof Element) {
        if (["STYLE", "SCRIPT", "NOSCRIPT", "KBD"].includes(node.tagName) || node.getAttribute("lang")) return;
        for (const name of ["aria-label", "title", "placeholder", "alt"]) note(node.getAttribute(name));
        if (node.shadowRoot) walk(node.shadowRoot);
      }
      node.childNodes.forEach(walk);
    };
    walk(document.body);
    return [...found].sort();
  });
}

/** Buttons and labels whose words are cut off. */
function cutOff(page: Page): Promise<readonly string[]> {
  return page.evaluate(() => {
    const found: string[] = [];
    const walk = (node: Element | ShadowRoot): void => {
      if (node instanceof HTMLElement && ["BUTTON", "LABEL", "LEGEND", "SUMMARY", "H2"].includes(node.tagName)) {
        const { overflowX } = getComputedStyle(node);
        if (overflowX !== "visible" && node.clientWidth > 2 && node.scrollWidth > node.clientWidth + 1) found.push(node.textContent.trim());
      }
      if (node instanceof Element && node.shadowRoot) walk(node.shadowRoot);
      for (const child of node.children) walk(child);
    };
    walk(document.body);
    return found;
  });
}

it("takes the address's language, then the one chosen here, then the browser's", async () => {
  const { page, faults } = await visit(browser, site.url, { locale: "de-AT" });
  await settled(page);
  expect(await languageOf(page)).toBe("de");
  await page.getByRole("heading", { name: heading("de"), exact: true }).waitFor();

  await page.keyboard.press("?");
  await page.getByRole("combobox", { name: read("words/de.json")["Language"]! }).selectOption("ja");
  await page.getByRole("heading", { name: heading("ja"), exact: true }).waitFor();
  expect(await languageOf(page)).toBe("ja");
  await page.reload();
  await page.getByRole("heading", { name: heading("ja"), exact: true }).waitFor();

  await page.goto(`${site.url}?lng=es`);
  await page.getByRole("heading", { name: heading("es"), exact: true }).waitFor();
  await page.goto(`${site.url}?lng=klingon`);
  await page.getByRole("heading", { name: heading("ja"), exact: true }).waitFor();
  expect(faults).toEqual([]);
  await page.context().close();
});

it("is in English where the language's texts cannot be had", async () => {
  const { page } = await visit(browser, "about:blank", { locale: "es" });
  await page.route(/\/es-[^/]*\.js$/, (route) => route.abort());
  await page.goto(site.url);
  await page.getByRole("heading", { name: "Match", exact: true }).waitFor();
  expect(await languageOf(page)).toBe("en");
  await page.context().close();
});

it("says nothing that could not be translated, and has room for longer words on a phone", async () => {
  const { page, faults } = await visit(browser, `${site.url}?lng=pseudo`, PHONE);
  await settled(page);
  const look = async (state: string): Promise<void> => {
    await shoot(page, `pseudo-${state}`);
    await fits(page);
    expect([state, await cutOff(page)]).toEqual([state, []]);
    const plain = await undisguised(page);
    // Names of formats, and what examples are called in them.
    expect([state, plain.filter((words) => !/^(Wire|Wire4D|[A-Z]{3,4}|wire\.json|\d[\d.,]* (s|px))$/.test(words))]).toEqual([state, []]);
  };
  for (const tab of ["Pictures", "Run", "Settings", "Share"]) {
    await page.locator(`.tabs [role=tab]`).nth(["Pictures", "Run", "Settings", "Share"].indexOf(tab)).click();
    await look(tab.toLowerCase());
  }
  for (const task of [1, 2]) {
    await page.locator(".tasks [role=tab]").nth(task).click();
    await settled(page);
    await look(`task-${task}`);
  }
  await page.locator(".tasks [role=tab]").first().click();
  await settled(page);
  // Tabs keep keys for themselves.
  await page.evaluate(() => {
    let focused = document.activeElement;
    while (focused?.shadowRoot?.activeElement) focused = focused.shadowRoot.activeElement;
    (focused as HTMLElement).blur();
  });
  await page.keyboard.press("?");
  await page.locator("help-dialog dialog[open]").waitFor();
  await look("help");
  await page.keyboard.press("Escape");
  for (const [state, panel] of [["hands", "hands-panel"], ["glass", "glass-panel"]] as const) {
    await page.locator(".tool-buttons button").nth(state === "hands" ? 0 : 1).click();
    await page.locator(panel).waitFor();
    await settled(page);
    await look(state);
  }
  expect(faults).toEqual([]);
  await page.context().close();
});

describe.each(OTHERS)("%s", (language) => {
  it("has the first view, the page for teachers and a lesson", async () => {
    const { page, faults } = await visit(browser, `${site.url}?lng=${language}`);
    await settled(page);
    await page.getByRole("heading", { name: heading(language), exact: true }).waitFor();
    await shoot(page, `language-${language}`);
    expect(await axeFaults(page)).toEqual([]);

    const { title } = read(`lessons/views/texts.${language}.json`);
    await page.goto(`${site.url}?lng=${language}#lesson=views`);
    await page.reload();
    await page.locator("lesson-panel").getByText(title!).first().waitFor();
    await settled(page);
    await shoot(page, `language-${language}-lesson`);
    expect(await axeFaults(page)).toEqual([]);

    await page.goto(`${site.url}teachers.html?lng=${language}`);
    await page.getByRole("heading", { name: read(`words/${language}.json`)["For teachers"]!, exact: true }).waitFor();
    await page.getByRole("heading", { name: title! }).waitFor();
    await shoot(page, `language-${language}-teachers`);
    expect(faults).toEqual([]);
    await page.context().close();
  });

  it("fits a phone", async () => {
    const { page } = await visit(browser, `${site.url}?lng=${language}`, PHONE);
    await settled(page);
    for (let tab = 0; tab < 4; tab++) {
      await page.locator(".tabs [role=tab]").nth(tab).click();
      await shoot(page, `language-${language}-phone-${tab}`);
      await fits(page);
      expect(await cutOff(page)).toEqual([]);
    }
    await page.context().close();
  });
});
