/** Models that are kept in this browser, each with its sidecar, by their checksum: Cache Storage keeps a file whole or not at all. */

import { GuidanceError, size } from "./fault";
import { factsOf, type Facts } from "./model";
import { readSidecar, type Sidecar } from "./sidecar";

/** A model's texts: its description, and its tokenizer or its contexts where it has them. */
export interface Texts {
  readonly sidecar: string;
  readonly tokenizer: string | null;
  readonly contexts?: string | null;
}

/** What is kept of a model besides its file. */
interface Entry extends Texts {
  /** The ONNX file's name. */
  readonly file: string;
  /** When it was kept: milliseconds since 1970. */
  readonly date: number;
}

/** A model on the shelf, for a list. */
export interface Kept extends Facts {
  readonly date: number;
}

export interface Found extends Entry {
  readonly parsed: Sidecar;
  bytes(): Promise<Uint8Array<ArrayBuffer>>;
}

const CACHE = "wire4d-guidance-v1";
/** Addresses that only name what is kept; nothing is fetched from there. */
const ENTRY = (sha256: string): string => `/wire4d-guidance/${sha256}/entry`;
const FILE = (sha256: string): string => `/wire4d-guidance/${sha256}/file`;

export class Shelf {
  /** Newest first. What cannot be read any more is dropped; a browser that keeps nothing has an empty shelf. */
  async list(): Promise<Kept[]> {
    const cache = await this.cache().catch(() => null);
    const kept: Kept[] = [];
    for (const { url } of (await cache?.keys()) ?? []) {
      const [, sha256, part] = /([0-9a-f]{64})\/(\w+)$/.exec(url) ?? [];
      if (!sha256 || part === "file") continue;
      const entry = await this.entry(sha256);
      if (entry) kept.push({ ...factsOf(entry.parsed), date: entry.date });
      else await this.drop(sha256);
    }
    return kept.sort((a, b) => b.date - a.date);
  }

  /** Null if it is not here. */
  async find(sha256: string): Promise<Found | null> {
    const cache = await this.cache().catch(() => null);
    const [entry, file] = [await this.entry(sha256), await cache?.match(FILE(sha256))];
    return entry && file ? { ...entry, bytes: async () => new Uint8Array(await file.arrayBuffer()) } : null;
  }

  /** Why it could not be kept, as a sentence; null if it is. */
  async keep(file: string, bytes: Blob, texts: Texts, sha256: string): Promise<string | null> {
    try {
      const cache = await this.cache();
      // The entry comes last: without it there is no model.
      await cache.put(FILE(sha256), new Response(bytes));
      await cache.put(ENTRY(sha256), Response.json({ file, ...texts, date: Date.now() } satisfies Entry));
      return null;
    } catch (error) {
      await this.drop(sha256).catch(() => undefined);
      const why = error instanceof DOMException && error.name === "QuotaExceededError" ? `this browser has no room for ${size(bytes.size)} more` : "this browser keeps nothing for this page";
      return `“${file}” is used without being kept, since ${why}. Delete models that you no longer need, or choose the file again next time.`;
    }
  }

  async drop(sha256: string): Promise<void> {
    const cache = await this.cache();
    await cache.delete(ENTRY(sha256));
    await cache.delete(FILE(sha256));
  }

  private async entry(sha256: string): Promise<(Entry & { readonly parsed: Sidecar }) | null> {
    try {
      const response = await (await this.cache()).match(ENTRY(sha256));
      if (!response) return null;
      const entry = (await response.json()) as Entry;
      return { ...entry, parsed: readSidecar(entry.sidecar, entry.file) };
    } catch {
      return null;
    }
  }

  private async cache(): Promise<Cache> {
    // Missing in some private windows, and without https.
    const { caches } = self as { readonly caches?: CacheStorage };
    if (!caches) throw new GuidanceError("", "This browser keeps nothing for this page.");
    return caches.open(CACHE);
  }
}
