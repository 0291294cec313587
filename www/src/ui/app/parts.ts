import { LitElement } from "lit";
import type { Job } from "../../state/studio";

/**
 * The columns of the page. Each is a script of its own, since to run one with all of them keeps a slow machine from
 * answering; until it has come, its elements lie empty in their places.
 */
export async function loadParts(): Promise<void> {
  await Promise.all([import("./parts-run"), import("../../tasks/multiview/parts/parts"), import("./parts-stage")]);
}

/** What only one of the other jobs needs comes when that is first looked at. */
export async function loadPartsOf(job: Job): Promise<void> {
  if (job === "stroke") await import("../../tasks/stroke/parts/parts");
  if (job === "fill") await import("../../tasks/fill/parts/parts");
}

/** Resolves when everything below has been rendered. */
export async function rendered(root: ParentNode): Promise<void> {
  for (const element of root.querySelectorAll("*")) {
    if (!(element instanceof LitElement)) continue;
    await element.updateComplete;
    await rendered(element.renderRoot);
  }
}
