/** The words of the small networks that come with the page. */

import rows from "../../../tools/iconnet/weights/words.bin?url";
import table from "../../../tools/iconnet/weights/words.json?url";
import { GuidanceError } from "./fault";
import { fetched } from "./fetching";
import { MOST_TEXT } from "./fields";
import { Words } from "./words";

const MOST_BYTES = 8e6;

/** What to say instead of a word that is not known. */
export const PLAINER = "Try a plainer word for it.";

/** The words that guide, most like what was typed first. */
export async function suggested(typed: string, most = 6): Promise<readonly string[]> {
  return (await wordTable()).meant(typed, most);
}

/** What a word is taken for, or that it is not known, a sentence; empty where it is in the table. */
export async function takenFor(word: string): Promise<string> {
  try {
    const [first] = await suggested(word, 1);
    if (first === undefined) return `“${word}” is no word that these networks know. ${PLAINER}`;
    return first.toLowerCase() === word.toLowerCase() ? "" : `Taken for “${first}”.`;
  } catch (error) {
    return (error as GuidanceError).message;
  }
}

let read: Promise<Words> | null = null;

/** Fetched once; a failure is forgotten. */
export function wordTable(): Promise<Words> {
  const open = async (): Promise<Words> => Words.open(await textAt(table, "words.json"), await fetched(rows, { name: "words.bin", most: MOST_BYTES }), "words.json");
  read ??= open().catch((error: unknown) => {
    read = null;
    throw error instanceof GuidanceError ? error : new GuidanceError("words.json", "The table of words could not be read. Check the connection and try again.");
  });
  return read;
}

/** A text beside the page. */
export async function textAt(url: string, name: string): Promise<string> {
  return new TextDecoder().decode(await fetched(url, { name, most: MOST_TEXT }));
}
