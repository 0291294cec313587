/** What the elements for one picture tell whoever placed them. */

import type { Box, MaskStroke } from "../given";

/** A picture that somebody gives, with what to call it. */
export interface Brought {
  readonly file: Blob;
  readonly name: string;
}

/** Each is a CustomEvent that bubbles out of every shadow root, with this detail. */
export interface SubjectEvents {
  give: Brought;
  "give-depth": Brought;
  "clear-depth": null;
  "clear-subject": null;
  "choose-object": { readonly object: number };
  /** The new list of strokes. */
  paint: { readonly strokes: readonly MaskStroke[] };
  /** Dragged round what is meant; null takes it away. */
  "give-box": { readonly box: Box | null };
  /** One more, on what is meant or beside it. */
  mark: { readonly mark: MaskStroke };
  "clear-marks": null;
  "open-brush": null;
}

export function tell<Kind extends keyof SubjectEvents>(from: EventTarget, kind: Kind, detail: SubjectEvents[Kind]): void {
  from.dispatchEvent(new CustomEvent(kind, { detail, bubbles: true, composed: true }));
}
