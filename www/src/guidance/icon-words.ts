/** The words of the small networks that come with the page. */

import rows from "../../../tools/iconnet/weights/words.bin?url";
import table from "../../../tools/iconnet/weights/words.json?url";
import { GuidanceError } from "./fault";
import { fetched } from "./fetching";
import { MOST_TEXT } from "./fields";
import { Words } from "./words";

const MOST_BYTES = 8e6;

/** The words that guide, most like what was typed first. */
export async function suggested(typed: string, most = 6): Promise<readonly string[]> {
  return (await wordTable()).meant(typed, most);
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
