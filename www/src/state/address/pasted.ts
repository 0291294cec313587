/** The fragment of a link as people paste it, whatever e-mail, a chat or a document did to it. */

import { codeIn } from "#sculpture/share/code";

/** Ends of a value: what no link of ours has, and what a sentence puts after it. */
const VALUE = "[^\\s&<>\"'`)\\]}“”’»*]*";
const SETTINGS = new RegExp(`^(?:&[\\w-]+=${VALUE})+`);
const ALONE = new RegExp(`#v=\\d+(?:&[\\w-]+=${VALUE})*`);

/** `#v=1&w=CODE&seed=3` out of the text; null where there is no link, nor a whole code. */
export function fragmentIn(text: string): string | null {
  const found = codeIn(text);
  if (found && (found.whole || found.named)) {
    const before = /#([^\s#]*)$/.exec(unescaped(found.before))?.[1] ?? "";
    const after = SETTINGS.exec(unescaped(found.after))?.[0] ?? "";
    return `#${before}w=${found.code}${withoutStop(after)}`;
  }
  const alone = ALONE.exec(unescaped(text))?.[0];
  return alone === undefined ? null : withoutStop(alone);
}

/** Without what HTML and quoted-printable mail add. */
function unescaped(text: string): string {
  return text.replace(/&(?:amp;)+/g, "&").replace(/=3D/g, "=");
}

function withoutStop(text: string): string {
  return text.replace(/[.,;:!?]+$/, "");
}
