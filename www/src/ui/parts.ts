/**
 * The columns of the page. Each is a script of its own, since to run one with all of them keeps a slow machine from
 * answering; until it has come, its elements lie empty in their places.
 */
export async function loadParts(): Promise<void> {
  await Promise.all([import("./parts-run"), import("./parts-pictures"), import("./parts-stage")]);
}
