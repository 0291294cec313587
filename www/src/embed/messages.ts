/**
 * What a page that frames `embed.html` may ask of it, and what it hears:
 *
 *     { to: "wire-sculpture", call: "flyTo", view: "side", id: 1 }          asks; answered where it has an `id`
 *     { from: "wire-sculpture", id: 1, answer: … } or { …, problem: "…" }    the answer
 *     { from: "wire-sculpture", event: "view-change", detail: { view } }    events, unasked
 */

export const NAME = "wire-sculpture";

export const VIEWS = ["front", "side", "top", "back", "left", "right", "room"] as const;
export const PICTURES = ["image/png", "image/jpeg", "image/webp"] as const;
/** Pixels a side of a picture. */
const LEAST_PX = 16;
const MOST_PX = 4096;
/** Characters of a state as JSON; the element's own is some hundred. */
const MOST_OF_STATE = 20_000;
const MOST_OF_NAME = 64;

export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly transparent: boolean;
  readonly mimeType: (typeof PICTURES)[number];
}

export type Asked =
  | { readonly call: "getState" | "play" | "pause" }
  | { readonly call: "setState"; readonly state: object }
  | { readonly call: "flyTo"; readonly view: string }
  | { readonly call: "toBlob"; readonly picture: Picture };

export type Id = number | string;
export type Message = Asked & { readonly id: Id | null };

/** What a message asks for; null for anything that is not exactly like one. Never throws. */
export function readMessage(data: unknown): Message | null {
  try {
    if (!isRecord(data) || data["to"] !== NAME) return null;
    const id = data["id"] ?? null;
    if (id !== null && !isId(id)) return null;
    const asked = readCall(data);
    return asked && { ...asked, id };
  } catch {
    return null;
  }
}

function readCall(data: Readonly<Record<string, unknown>>): Asked | null {
  const { call } = data;
  switch (call) {
    case "getState":
    case "play":
    case "pause":
      return { call };
    case "setState": {
      const state = plain(data["state"]);
      return state && { call, state };
    }
    case "flyTo": {
      const { view } = data;
      // Those of the wire have names of their own.
      return typeof view === "string" && view.length > 0 && view.length <= MOST_OF_NAME ? { call, view } : null;
    }
    case "toBlob": {
      const picture = readPicture(data);
      return picture && { call, picture };
    }
    default:
      return null;
  }
}

function readPicture({ width = 1200, height = 900, transparent = false, mimeType = "image/png" }: Readonly<Record<string, unknown>>): Picture | null {
  const known = PICTURES.find((type) => type === mimeType);
  if (!isSide(width) || !isSide(height) || typeof transparent !== "boolean" || !known) return null;
  return { width, height, transparent, mimeType: known };
}

/** A copy with nothing but what JSON has. */
function plain(value: unknown): object | null {
  if (!isRecord(value)) return null;
  const text = JSON.stringify(value);
  return text.length <= MOST_OF_STATE ? (JSON.parse(text) as object) : null;
}

const isRecord = (value: unknown): value is Readonly<Record<string, unknown>> => typeof value === "object" && value !== null && !Array.isArray(value);
const isId = (value: unknown): value is Id => (typeof value === "number" && Number.isFinite(value)) || (typeof value === "string" && value.length <= MOST_OF_NAME);
const isSide = (value: unknown): value is number => typeof value === "number" && Number.isInteger(value) && value >= LEAST_PX && value <= MOST_PX;
