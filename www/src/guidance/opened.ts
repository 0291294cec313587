/** The worker's open networks, apart from what opens them: whoever asks whether one is there need not load that. */

import type { Kind } from "./contract";
import type { Model } from "./model";
import type { Provider } from "./runtime";
import type { Tokenizer } from "./tokenizer";

export interface OpenModel {
  readonly model: Model;
  readonly tokenizer: Tokenizer | null;
  /** A text of contexts-v1, of a diffusion model. */
  readonly contexts: string | null;
  readonly prefer: Provider;
}

/** At most one of each kind. */
export const models = new Map<Kind, OpenModel>();

/** The open network of a kind, for whoever computes with it. */
export function opened<K extends Kind>(kind: K): Model<K> | null {
  return (models.get(kind)?.model ?? null) as Model<K> | null;
}
