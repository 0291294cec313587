/** Sentences for people out of what programs say. */

import { Problem } from "../../engine/client";

/** The core writes "input: problem; remedy"; a page starts sentences with a capital (but leaves file names alone) and
 * ends them with a full stop. */
export function asSentence(text: string): string {
  const trimmed = text.trim();
  const ended = /[.!?]$/.test(trimmed) ? trimmed : `${trimmed}.`;
  const isFile = /^[^:]*\.\w+:/.test(ended);
  return isFile ? ended : ended.charAt(0).toUpperCase() + ended.slice(1);
}

/** What to tell a person about an error; one that was not meant for people also goes to the console. */
export function explain(error: unknown, what: string): string {
  if (error instanceof Problem) return asSentence(error.message);
  console.error(error);
  return `${what} did not work out. Nothing is lost; please try again.`;
}

export const DURING_A_RUN = "A run is under way. Wait for its end, or stop it; then open this again.";

/** What a file without a name is called. */
export const named = (name: string): string => name || "The file";

export const percent = (share: number): string => `${Math.round(100 * share)}%`;

export function timeLeft(seconds: number): string {
  return seconds < 60 ? `about ${seconds} s left` : `about ${Math.ceil(seconds / 60)} min left`;
}
