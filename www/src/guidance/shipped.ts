/** Networks that come with the page. */

import type { Kind } from "./contract";
import { fetched } from "./fetching";
import { textAt } from "./icon-words";
import { openModel, type Model } from "./model";
import type { Provider } from "./runtime";
import { readSidecar } from "./sidecar";

const MOST_BYTES = 16e6;

/** Where one lies. */
export interface Shipped<K extends Kind> {
  readonly kind: K;
  readonly name: string;
  readonly model: string;
  readonly sidecar: string;
  readonly prefer: Provider;
}

/** Fetches and opens one. */
export async function opened<K extends Kind>({ kind, name, model, sidecar, prefer }: Shipped<K>, progress: (share: number) => void): Promise<Model<K>> {
  const described = readSidecar(await textAt(sidecar, `${name}.json`), `${name}.json`);
  const bytes = await fetched(model, { name, most: MOST_BYTES, exactly: described.bytes, progress: (part) => progress(0.5 * part) });
  const open = await openModel({ file: name, bytes, sidecar: described }, { prefer, progress: (_, part) => progress(0.5 + 0.5 * part) });
  if (described.kind !== kind) throw new Error(`${name} is no ${kind}`);
  return open as Model<K>;
}

/** What `open` promises, asked for once; a failure is forgotten, so that the next run tries again. */
export function once<T>(open: (progress: (share: number) => void) => Promise<T>): (progress: (share: number) => void) => Promise<T> {
  let known: Promise<T> | null = null;
  return (progress) =>
    (known ??= open(progress).catch((error: unknown) => {
      known = null;
      throw error;
    }));
}
