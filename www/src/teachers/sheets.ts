/** What is printed: a pupils' sheet, a teacher's note, a sheet with the code of a link. A page each. */

import { msg, str } from "@lit/localize";
import { html, nothing, svg, type TemplateResult } from "lit";
import type { Lesson, Texts } from "../state/lesson/lesson";
import { qrOf, type QrCode } from "../ui/save/qr";

export interface Shown {
  readonly lesson: Lesson;
  readonly texts: Texts;
  /** Of the lesson, for everybody. */
  readonly link: string;
}

export function pupilsSheet({ lesson, texts }: Shown): TemplateResult {
  return html`<article class="sheet pupils" lang=${document.documentElement.lang}>
    <h1>${texts["title"]}</h1>
    <p>${texts["about"]}</p>
    <p class="who"><span>${msg("Name")}:</span><span>${msg("Date")}:</span></p>
    <ol class="questions">
      ${lesson.sheet.map(
        ({ id, lines = 0, squares = 0 }) => html`<li>
          <p>${texts[`sheet.${id}`]}</p>
          ${squares ? html`<div class="squares">${times(squares, html`<div class="square"></div>`)}</div>` : nothing} ${times(lines, html`<div class="line"></div>`)}
        </li>`,
      )}
    </ol>
  </article>`;
}

export function teachersNote({ lesson, texts, link }: Shown): TemplateResult {
  return html`<article class="sheet note">
    <div class="aside">
      <div>
        <h1>${msg(str`${texts["title"]}: note for teachers`)}</h1>
        <p>${msg(str`About ${lesson.minutes} minutes, ${lesson.steps.length} steps.`)}</p>
        <p class="address">${link}</p>
      </div>
      ${code(link)}
    </div>
    <h2>${msg("What it is about")}</h2>
    <p>${texts["teacher.aim"]}</p>
    <h2>${msg("How to go about it")}</h2>
    <p>${texts["teacher.how"]}</p>
    <h2>${msg("Steps")}</h2>
    <ol>
      ${lesson.steps.map(({ id, question }) => html`<li>${texts[`${id}.title`]}${question ? html`<br /><i>${texts[`${id}.question`]}</i> → ${texts[`${id}.choice.${question.right}`]}` : nothing}</li>`)}
    </ol>
    <h2>${msg("Answers")}</h2>
    <p>${texts["teacher.answers"]}</p>
  </article>`;
}

export function codeSheet(link: string): TemplateResult {
  return html`<article class="sheet">
    <h1>${msg("Open this page")}</h1>
    <p>${msg("Point the camera of a tablet or phone at the code, or type the address. No account is needed.")}</p>
    ${code(link, "large")}
    <p class="address">${link}</p>
  </article>`;
}

function code(link: string, size = ""): TemplateResult | typeof nothing {
  const made = qrOf(link);
  return made ? html`<svg class="code ${size}" viewBox="0 0 ${made.side} ${made.side}" role="img" aria-label=${msg("QR code of the link")} shape-rendering="crispEdges">${modules(made)}</svg>` : nothing;
}

const modules = ({ side, path }: QrCode): TemplateResult => svg`<path fill="#fff" d="M0 0h${side}v${side}H0z" /><path fill="#000" d=${path} />` as unknown as TemplateResult;

const times = (count: number, what: TemplateResult): readonly TemplateResult[] => Array.from({ length: count }, () => what);
