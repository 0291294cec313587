import { LitElement } from "lit";

/**
 * The columns of the page. Each is a script of its own, since to run one with all of them keeps a slow machine from
 * answering; until it has come, its elements lie empty in their places.
 */
export async function loadParts(): Promise<void> {
  await Promise.all([import("./parts-run"), import("./parts-stage")]);
}

/** Resolves when everything below has been rendered. */
export async function rendered(root: ParentNode): Promise<void> {
  for (const element of root.querySelectorAll("*")) {
    if (!(element instanceof LitElement)) continue;
    await element.updateComplete;
    await rendered(element.renderRoot);
  }
}
