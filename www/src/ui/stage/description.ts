/** What there is to see on the stage, for those who cannot: each view with what it shows, and the wire itself. */

import { msg, str } from "@lit/localize";
import { counted, percent } from "../../words/numbers";
import type { Made } from "../../state/studio";
import { viewWords } from "../../view/heading";

/** `labels` are those of what was given, in its order. Null where there is no wire. */
export function description(made: Made | null, labels: readonly string[]): string | null {
  if (!made) return null;
  const { measures, targets } = made.finished;
  const views = measures.views.flatMap(({ name, bent, recall_2px: recall }) => {
    const shows = bent?.recall_2px ?? recall;
    if (shows === null) return [];
    const source = targets.find(({ view }) => view.name === name)?.source ?? null;
    const what = (source !== null && labels[source]?.replace(/\.\w{1,5}$/, "").trim()) || msg("its picture");
    return [msg(str`${viewWords(name)}: ${what}, ${percent(shows)} of it shows`)];
  });
  const pieces = counted(measures.components, msg("one piece of wire"), msg(str`${measures.components} pieces of wire`));
  return msg(str`The wire in 3D: ${[pieces, ...views].join("; ")}.`);
}
