/** What a wire.json has beside the wire: what it was made of, and how. Every other file is made from one, and opens as one. */

import type { SettingValues } from "../../engine/protocol";
import { sheetOf } from "../../engine/sheet";
import type { Packed, PackedDrawing } from "../contract/task";
import { greyPng } from "./grey-png";

type Bytes = Uint8Array<ArrayBuffer>;

export interface Carried {
  readonly task: string;
  /** With the seed; null where it has none, as after a link. */
  readonly settings: SettingValues | null;
  /** Null where it says nothing of what it was made of. */
  readonly packed: Packed | null;
}

/** The core's own writing: what of it others may have written has been checked. */
interface Fields {
  readonly made_with: { readonly task: string; readonly seed: number; readonly settings: Readonly<Record<string, unknown>> };
  readonly drawings?: readonly { readonly view: string; readonly label: string; readonly png: string }[];
  readonly given?: Packed["pairs"];
}

/** Of all drawings of a file, which is also to have room for how the wire was found. */
const MOST_BYTES = 12_000;
/** Names that people and files give may be longer. */
const MOST_CHARACTERS = 60;

const fieldsOf = (file: Bytes): Fields => JSON.parse(new TextDecoder().decode(file)) as Fields;

export async function carriedIn(file: Bytes): Promise<Carried> {
  const { made_with, drawings = [], given = {} } = fieldsOf(file);
  const { task, seed, settings } = made_with;
  const texts = Object.entries({ ...settings, seed }).map(([name, value]) => [name, String(value)] as const);
  const read = await Promise.all(drawings.map(drawing));
  const known = read.filter((drawing) => drawing !== null);
  const isAnything = known.length > 0 || Object.keys(given).length > 0;
  return { task, settings: texts.length > 1 ? Object.fromEntries(texts) : null, packed: isAnything ? { drawings: known, pairs: given } : null };
}

async function drawing({ view, label, png }: NonNullable<Fields["drawings"]>[number]): Promise<PackedDrawing | null> {
  const bytes = Uint8Array.from(atob(png), (c) => c.charCodeAt(0));
  // The core has looked at the heading only.
  const ink = await sheetOf(new Blob([bytes], { type: "image/png" })).catch(() => null);
  return ink && { view, label, ...ink };
}

/** Whether it says what it was made of. */
export function isPacked(file: Bytes): boolean {
  const { drawings, given } = fieldsOf(file);
  return drawings !== undefined || given !== undefined;
}

/** The same with what it was made of; the core has written it, and ends its text with a brace. */
export async function packedInto(file: Bytes, { drawings, pairs }: Packed): Promise<Bytes> {
  const each = Math.floor(MOST_BYTES / Math.max(1, drawings.length));
  const written = drawings.map(async (drawing) => ({
    view: drawing.view,
    label: [...drawing.label].slice(0, MOST_CHARACTERS).join(""),
    png: base64(await greyPng(drawing, each)),
  }));
  const fields = { ...(drawings.length && { drawings: await Promise.all(written) }), ...(Object.keys(pairs).length && { given: pairs }) };
  const more = JSON.stringify(fields).slice(1, -1);
  const text = new TextDecoder().decode(file).trimEnd().slice(0, -1);
  return new TextEncoder().encode(`${text}${more && ","}${more}}\n`);
}

function base64(bytes: Uint8Array): string {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text);
}
