/** Sculptures from files and codes: what is there is read within bounds, and nothing of it is ever taken for markup. */

import { carriedBy } from "./files";
import { codeIn, openShareCode, ShareCodeError } from "../share/code";
import { fromBase64 } from "../share/base64";
import { isView, wireProblem } from "../share/check";
import type { WireShape } from "../scene/shape";
import type { View } from "../scene/view";

export interface Sculpture {
  readonly wire: WireShape;
  readonly views: readonly View[];
  /** How it was found, as bytes. */
  readonly replay: Uint8Array | null;
}

/** Says in a sentence why there is nothing to show. */
export class SourceError extends Error {
  override readonly name = "SourceError";
}

const MAX_BYTES = 16 * 1024 * 1024;
const VERSION = 1;
const MAX_VIEWS = 64;

/**
 * From a share code, or a link that ends in one.
 * @throws SourceError
 */
export function fromCode(text: string): Sculpture {
  try {
    const { wire, views } = openShareCode(codeIn(text)?.code ?? text.trim());
    return { wire, views, replay: null };
  } catch (error) {
    if (error instanceof ShareCodeError) throw new SourceError(error.message);
    throw error;
  }
}

/**
 * From a file: wire.json, or a PNG, GLB or SVG that the app has made.
 * @throws SourceError
 */
export async function fromFile(url: string, signal: AbortSignal): Promise<Sculpture> {
  const bytes = await fetched(url, signal);
  const text = carriedBy(bytes);
  if (text === null) throw new SourceError("This file holds no wire; a wire.json, or a picture or model saved by Wire4D, does.");
  return fromJson(text);
}

/** @throws SourceError */
export function fromJson(text: string): Sculpture {
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    throw new SourceError("What this file says of its wire is damaged; save it again.");
  }
  const { format, version, code, replay, ...file } = (json ?? {}) as Partial<Record<string, unknown>>;
  if (format !== "wire4d") throw new SourceError("This file holds no wire; a wire.json, or a picture or model saved by Wire4D, does.");
  if (typeof version !== "number" || version > VERSION) {
    throw new SourceError(`This file was made by a newer Wire4D (version ${String(version)}, this page reads ${VERSION}); a newer page shows it.`);
  }
  const { wire, views } = typeof code === "string" ? fromCode(code) : plain(file);
  return { wire, views, replay: typeof replay === "string" ? fromBase64(replay) : null };
}

/** A wire written out. */
function plain({ closed, knots, control_points: rows, views }: Partial<Record<string, unknown>>): Pick<Sculpture, "wire" | "views"> {
  const areNumbers = (list: unknown): list is number[] => Array.isArray(list) && list.every((x) => typeof x === "number");
  if (typeof closed !== "boolean" || !areNumbers(knots) || !Array.isArray(rows) || !rows.every((row) => areNumbers(row) && row.length === 4)) {
    throw new SourceError("This file's wire is incomplete; save it again.");
  }
  const wire = { closed, knots: Float64Array.from(knots), controlPoints: Float64Array.from(rows.flat() as number[]) };
  const count = rows.length;
  if (knots.length !== count + (closed ? 7 : 4)) throw new SourceError(`This file holds no valid wire (${knots.length} knots for ${count} control points); save it again.`);
  const problems = (["spline", "chain", "bag"] as const).map((form) => wireProblem(form, closed, wire.knots, wire.controlPoints));
  if (!problems.includes(null)) throw new SourceError(`This file holds no valid wire (${problems[0]}); save it again.`);
  return { wire, views: Array.isArray(views) ? views.slice(0, MAX_VIEWS).filter(isWholeView) : [] };
}

function isWholeView(view: unknown): view is View {
  const { name, projection, eye, target, up } = (view ?? {}) as Partial<Record<keyof View, unknown>>;
  const places = [eye, target, up].every((place) => Array.isArray(place) && place.length === 3 && place.every((x) => typeof x === "number"));
  return typeof name === "string" && places && (projection === "orthographic" || projection === "perspective") && isView(view as View);
}

/** The bytes at an address, refused as soon as it is clear that they are too many. */
async function fetched(url: string, signal: AbortSignal): Promise<Uint8Array> {
  let response: Response;
  try {
    response = await fetch(url, { signal });
  } catch (error) {
    if (signal.aborted) throw error;
    throw new SourceError("The sculpture could not be fetched: there is no connection, or its site does not let other pages read it.");
  }
  if (!response.ok) throw new SourceError(`The sculpture is not where it should be (status ${response.status}).`);
  const tooLarge = new SourceError("The file is larger than 16 MB, and no sculpture is.");
  if (Number(response.headers.get("content-length")) > MAX_BYTES) {
    await response.body?.cancel();
    throw tooLarge;
  }
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let length = 0;
  const reader = response.body?.getReader();
  for (let part; reader && !(part = await reader.read()).done; ) {
    length += part.value.length;
    if (length > MAX_BYTES) {
      await reader.cancel();
      throw tooLarge;
    }
    parts.push(part.value);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}
