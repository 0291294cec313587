/** Files of this site, with progress, an end, and sentences for what goes wrong on the way. */

import { GuidanceError, size } from "./fault";

type Bytes = Uint8Array<ArrayBuffer>;

export interface Fetching {
  /** How people know the file. */
  readonly name: string;
  /** The most that is taken, in bytes. */
  readonly most: number;
  /** How many bytes it has, about: for progress. */
  readonly about?: number;
  /** How many bytes it has, if that is known: what comes is compared. */
  readonly exactly?: number;
  readonly signal?: AbortSignal | undefined;
  progress?(share: number): void;
}

/** The whole file, or a GuidanceError; an AbortError where `signal` said so. Nothing is asked of another site. */
export async function fetched(url: string, { name, most, exactly, about = exactly ?? most, signal, progress }: Fetching): Promise<Bytes> {
  const address = new URL(url, self.location.href);
  if (address.origin !== self.location.origin) throw new GuidanceError(name, `“${name}” lies on another site, and nothing is fetched from there. Download it and open it as a file.`);
  const broken = (what: string): GuidanceError => new GuidanceError(name, `“${name}” could not be fetched: ${what} Nothing of it was kept; check the connection and try again.`);
  const response = await fetch(address, { mode: "same-origin", signal: signal ?? null }).catch((error: unknown) => {
    throw signal?.aborted ? error : broken("there is no answer.");
  });
  if (!response.ok || !response.body) throw new GuidanceError(name, `“${name}” is not there (${response.status}). Look at its address.`);
  const parts: Bytes[] = [];
  let got = 0;
  let told = 0;
  const reader = response.body.getReader();
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      parts.push(value);
      got += value.length;
      if (got > most) throw new GuidanceError(name, `“${name}” is larger than ${size(most)}, which it may not be.`);
      const percent = Math.min(100, Math.floor((100 * got) / about));
      if (percent > told) progress?.((told = percent) / 100);
    }
  } catch (error) {
    void reader.cancel().catch(() => undefined);
    if (error instanceof GuidanceError || signal?.aborted) throw error;
    throw broken(`the connection broke after ${size(got)}.`);
  }
  if (exactly !== undefined && got < exactly) throw broken(`only ${size(got)} of ${size(exactly)} came.`);
  return joined(parts, got);
}

/** Takes the parts apart as it goes, so that a large file is not there twice. */
function joined(parts: Bytes[], length: number): Bytes {
  const whole = new Uint8Array(length);
  let at = length;
  for (let part = parts.pop(); part; part = parts.pop()) whole.set(part, (at -= part.length));
  return whole;
}
