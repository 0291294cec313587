/** The gallery: a click opens a work, which plays how it was found; its address is the page's with the work's name. */

import { msg, str } from "@lit/localize";
import works from "../../gallery/works.json";
import type { WireSculpture } from "#sculpture/element/element";
import { elementWords } from "../words/element";
import { worded } from "../words/told";
import { text } from "./cards";
import { addressOf, fileOf, KINDS, meshOf, namesOf, picturesOf, type Work } from "./works";

const all = works as readonly Work[];
const find = <E extends Element>(selector: string): E => document.querySelector<E>(selector)!;
const dialog = find<HTMLDialogElement>("dialog");
const part = <E extends HTMLElement = HTMLElement>(selector: string): E => dialog.querySelector<E>(selector)!;
const kinds = find<HTMLElement>(".kinds");
const items = [...document.querySelectorAll<HTMLElement>(".cards > li")];
/** What the visitor looks through: all, or those of one kind. */
let chosen: readonly Work[] = all;

kinds.hidden = false;
kinds.addEventListener("click", ({ target }) => {
  const task = target instanceof HTMLButtonElement ? target.dataset["task"] : undefined;
  if (task !== undefined) choose(task);
});
dialog.addEventListener("close", leave);
// Beside it is outside.
dialog.addEventListener("click", ({ target }) => target === dialog && dialog.close());
addEventListener("hashchange", follow);
follow();

function choose(task: string): void {
  for (const button of kinds.querySelectorAll("button")) button.setAttribute("aria-pressed", String(button.dataset["task"] === task));
  for (const item of items) item.hidden = task !== "" && item.dataset["task"] !== task;
  chosen = all.filter((work) => task === "" || work.task === task);
  find("#count").textContent = msg(str`${chosen.length} works`);
}

/** To where the address points. */
function follow(): void {
  const work = all.find(({ name }) => `#${name}` === location.hash);
  if (work) void open(work);
  else dialog.close();
}

async function open(work: Work): Promise<void> {
  part(".kind").textContent = worded(KINDS[work.task]!);
  part("#title").textContent = worded(work.title);
  part(".sentence").textContent = worded(work.sentence);
  part(".inputs").innerHTML = inputs(work);
  part<HTMLAnchorElement>(".primary").href = addressOf(work);
  const among = chosen.includes(work) ? chosen : all;
  const at = among.indexOf(work);
  part<HTMLAnchorElement>(".before").href = `#${among.at(at - 1)!.name}`;
  part<HTMLAnchorElement>(".next").href = `#${among[(at + 1) % among.length]!.name}`;
  const sculpture = document.createElement("wire-sculpture") as WireSculpture;
  const dark = getComputedStyle(items[0]!.querySelector(".poster")!).display === "none";
  const attributes = {
    src: `./${fileOf(work)}`,
    poster: `./gallery/${work.name}${dark ? "-dark" : ""}.jpg`,
    alt: `${worded(work.title)}. ${worded(work.sentence)}`,
    "touch-action": "none",
    loading: "eager",
    "camera-controls": "",
    controls: "",
    views: "",
    shadow: "",
    replay: "",
    labels: JSON.stringify(elementWords()),
  };
  for (const [name, value] of Object.entries(attributes)) sculpture.setAttribute(name, value);
  part(".stage").replaceChildren(sculpture);
  if (!dialog.open) dialog.showModal();
  // Comes with the first work that is looked at.
  await import(/* @vite-ignore */ new URL("./wire-sculpture.js", document.baseURI).href);
}

function inputs(work: Work): string {
  const mesh = meshOf(work);
  const pictures = picturesOf(work).map((file) => `<figure><img src="./gallery/inputs/${file}" alt="${text(worded(subjectOf(file)))}" width="160" height="160"></figure>`);
  const named = namesOf(work).map((name, at) => (at === 0 && !mesh ? msg(str`the shape “${name}”`) : msg(str`the style “${name}”`)));
  const words = [...(mesh ? [msg(str`an own mesh, ${worded(subjectOf(mesh))}`)] : []), ...named].join(msg(", with "));
  return pictures.join("") + (words ? `<p>${text(words.charAt(0).toUpperCase() + words.slice(1))}.</p>` : "");
}

/** What a file shows. */
function subjectOf(file: string): string {
  return file.replace(/\.\w+$/, "").replaceAll("-", " ");
}

/** The wire is let go, and the address is the gallery's again. */
function leave(): void {
  part(".stage").replaceChildren();
  if (location.hash) history.replaceState(null, "", location.pathname + location.search);
}
