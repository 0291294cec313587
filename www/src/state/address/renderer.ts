/**
 * `?renderer=auto|webgpu|cpu` in an address says for one visit where runs are computed, whatever the setting is. It is kept
 * nowhere and goes into no link.
 */

import { msg, str } from "@lit/localize";
import type { Backend } from "../../engine/protocol";

const KEY = "renderer";
const BACKENDS: Readonly<Record<string, Backend>> = { auto: "auto", webgpu: "gpu", cpu: "cpu" };
/** More of a wrong word than this is not repeated. */
const MOST_LETTERS = 40;

export interface Renderer {
  /** Null where the setting decides. */
  readonly backend: Backend | null;
  /** What is wrong with the address; empty if nothing is. */
  readonly problem: string;
}

export function readRenderer(search: string): Renderer {
  const word = new URLSearchParams(search).get(KEY);
  if (word === null) return { backend: null, problem: "" };
  if (Object.hasOwn(BACKENDS, word)) return { backend: BACKENDS[word]!, problem: "" };
  const short = word.length > MOST_LETTERS ? `${word.slice(0, MOST_LETTERS)}…` : word;
  const known = Object.keys(BACKENDS).join(", ").replace(/, (?=\w+$)/, msg(" or "));
  return { backend: null, problem: msg(str`The address asks for the renderer “${short}”, which there is not: it may be ${known}. The setting decides instead.`) };
}

/** The word for it in an address. */
export function rendererWord(backend: Backend): string {
  return `?${KEY}=${Object.keys(BACKENDS).find((word) => BACKENDS[word] === backend)!}`;
}

/** An address without fragment, less what only this visit is to hear. */
export function forOthers(address: string): string {
  const url = new URL(address);
  url.hash = "";
  // To delete what is not there would still write the rest anew.
  if (url.searchParams.has(KEY)) url.searchParams.delete(KEY);
  return url.href;
}
