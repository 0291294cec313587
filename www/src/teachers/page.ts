/** The page for teachers: the list of lessons, and the sheets that its addresses ask for: `#sheet=ID`, `#class=LINK`. */

import { msg, str } from "@lit/localize";
import { html, render } from "lit";
import { lessonCalled, lessonIds, textsOf } from "../state/teaching/shelf";
import { codeSheet, pupilsSheet, teachersNote, type Shown } from "./sheets";

const find = <E extends HTMLElement>(selector: string): E => document.querySelector<E>(selector)!;
const page = find("#page");
const printed = find("#printed");
const list = find("ol.lessons");

addEventListener("hashchange", () => void follow());
await show();

async function show(): Promise<void> {
  const lessons = await Promise.all(lessonIds.map(shown));
  render(lessons.map(entry), list);
  list.classList.add("here");
  await follow();
}

async function shown(id: string): Promise<Shown> {
  const [lesson, texts] = await Promise.all([lessonCalled(id), textsOf(id, document.documentElement.lang)]);
  return { lesson, texts, link: new URL(`./#lesson=${id}`, location.href).href };
}

function entry({ lesson, texts }: Shown, i: number) {
  return html`<li>
    <span class="number" aria-hidden="true">${i + 1}</span>
    <h3>${texts["title"]}</h3>
    <p>${texts["about"]} ${msg(str`About ${lesson.minutes} minutes.`)}</p>
    <p class="links">
      <a href="./#lesson=${lesson.id}">${msg("Open")}<span class="unseen">: ${texts["title"]}</span></a>
      <a href="./#lesson=${lesson.id}&lock=leave">${msg("Open, locked")}<span class="unseen">: ${texts["title"]}</span></a>
      <a href="#sheet=${lesson.id}">${msg("Sheet and note to print")}<span class="unseen">: ${texts["title"]}</span></a>
    </p>
  </li>`;
}

/** What the address asks to print, or the page itself. */
async function follow(): Promise<void> {
  const pairs = new URLSearchParams(location.hash.slice(1));
  const [id, link] = [pairs.get("sheet"), pairs.get("class")];
  const sheets = id !== null && lessonIds.includes(id) ? await shown(id).then((lesson) => [pupilsSheet(lesson), teachersNote(lesson)]) : link ? [codeSheet(link)] : null;
  const came = !printed.hidden;
  page.hidden = sheets !== null;
  printed.hidden = sheets === null;
  if (sheets) {
    const acts = html`<p class="acts">
      <button class="print" @click=${() => print()}>${msg("Print")}</button>
      <a href="#lessons">${msg("All lessons")}</a>
    </p>`;
    render([acts, ...sheets], printed);
    scrollTo(0, 0);
  } else if (came) {
    // It was not there when the browser looked for it.
    document.getElementById(location.hash.slice(1) || "content")?.scrollIntoView();
  }
}
