/** The works as a list of links with their posters: written into the gallery when it is built, and below the app later. */

import { KINDS, type Work } from "./works";

/** Of a poster, px. */
const [WIDTH, HEIGHT] = [480, 400];

/** Markup; `base` is what a work's name follows in its address. */
export const cards = (works: readonly Work[], base: string): string => `<ul class="cards">${works.map((work) => card(work, base)).join("")}</ul>`;

function card({ name, task, title, sentence }: Work, base: string): string {
  const size = `width="${WIDTH}" height="${HEIGHT}"`;
  const poster = (dark: "" | "-dark"): string => `<img class="poster${dark}" src="./gallery/${name}${dark}.jpg" alt="" ${size} loading="lazy" decoding="async">`;
  return `<li data-task="${task}"><a href="${base}${name}">${poster("")}${poster("-dark")}<span class="words"><b data-words>${text(title)}</b> <i data-words>${KINDS[task]}</i> <span data-words>${text(sentence)}</span></span></a></li>`;
}

export const text = (plain: string): string => plain.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);
