/**
 * How projects were kept before tasks had names of their own in them (the first version of the browser's database): the
 * first task's drawings and desk by themselves, and what runs were given in a shape for each task. Any part may be
 * missing: it may have been kept before there was a second task, or a third.
 */

import type { Desk, Made } from "../state/keeping/document";
import type { KeptRun, Parts } from "../state/keeping/keep";
import type { Track } from "../state/keeping/track";
import type { Cover } from "./fill/given";
import type { Mesh } from "./fill/protocol";
import { NO_PAPERS, type Sheet } from "./multiview/given";
import type { Subject } from "./stroke/given";

type OldCover = { readonly solid: Mesh; readonly style: Cover["style"] };
type OldGiven =
  | { readonly job: "multiview"; readonly sheets: readonly Sheet[] }
  | { readonly job: "stroke"; readonly subject: Subject }
  | { readonly job: "fill"; readonly cover: OldCover };
/** The oldest runs were about drawings, and nothing else. */
type OldRun = Omit<Track, "task" | "given" | "snapshots"> & ({ readonly given: OldGiven } | { readonly sheets: readonly Sheet[] });
type OldMade = Omit<Made, "track"> & { readonly track: (OldRun & Pick<Track, "snapshots">) | null };
type OldDesk = Pick<Desk, "settings"> & { readonly made?: OldMade | null; readonly loose?: OldMade | null };
type OldParts = Partial<OldDesk> & { readonly job?: string; readonly stroke?: OldDesk; readonly fill?: OldDesk; readonly solid?: Mesh | null };

/** The document's parts as they are kept now; none where nothing was kept. */
export function before(old: Parts): Parts {
  const { front = null, side = null, top = null, subject = null, style = null } = old;
  const { job = "multiview", settings, made, loose, stroke, fill, solid = null } = old as OldParts;
  if (!settings) return {};
  return {
    task: job,
    "given/multiview/front": front,
    "given/multiview/side": side,
    "given/multiview/top": top,
    "given/stroke/subject": subject,
    "given/fill/mesh": solid,
    "given/fill/style": style,
    "desk/multiview": deskNow({ settings, made: made ?? null, loose: loose ?? null }),
    ...(stroke && { "desk/stroke": deskNow(stroke) }),
    ...(fill && { "desk/fill": deskNow(fill) }),
  };
}

/** A run under way, as it is kept now. */
export function runBefore(old: object): KeptRun {
  const { given, sheets, ...rest } = old as Omit<OldRun, "given"> & { readonly given?: OldGiven; readonly sheets?: readonly Sheet[] };
  return { ...rest, ...givenNow(given ?? { job: "multiview", sheets: sheets ?? [] }) };
}

function deskNow({ settings, made = null, loose = null }: OldDesk): Desk {
  return { settings, guide: null, made: madeNow(made), loose: madeNow(loose) };
}

function madeNow(made: OldMade | null): Made | null {
  return made && { ...made, track: made.track && { ...runBefore(made.track), snapshots: made.track.snapshots } };
}

function givenNow(given: OldGiven): Pick<Track, "task" | "given"> {
  switch (given.job) {
    case "multiview":
      return { task: given.job, given: { ...NO_PAPERS, ...Object.fromEntries(given.sheets.map(({ slot, paper }) => [slot, paper])) } };
    case "stroke":
      return { task: given.job, given: given.subject };
    case "fill":
      return { task: given.job, given: { mesh: given.cover.solid, style: given.cover.style } satisfies Cover };
  }
}
