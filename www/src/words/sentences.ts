/** Sentences for people out of what programs say. */

import { msg, str } from "@lit/localize";
import { Problem } from "../engine/client";
import { told } from "./told";

/** The core writes "input: problem; remedy"; a page starts sentences with a capital (but leaves file names alone) and
 * ends them with a full stop. */
export function asSentence(text: string): string {
  const trimmed = told(text.trim());
  const ended = /[.!?。！？]$/.test(trimmed) ? trimmed : `${trimmed}.`;
  const isFile = /^[^:]*\.\w+:/.test(ended);
  return isFile ? ended : ended.charAt(0).toUpperCase() + ended.slice(1);
}

/** What to tell a person about an error; one that was not meant for people also goes to the console. */
export function explain(error: unknown, what: string): string {
  if (error instanceof Problem) return asSentence(error.message);
  console.error(error);
  return msg(str`${what} did not work out. Nothing is lost; please try again.`);
}

export const DURING_A_RUN = msg("A run is under way. Wait for its end, or stop it; then open this again.");

/** What a file without a name is called. */
export const named = (name: string): string => name || msg("The file");

export function timeLeft(seconds: number): string {
  return seconds < 60 ? msg(str`about ${seconds} s left`) : msg(str`about ${Math.ceil(seconds / 60)} min left`);
}
