/**
 * What the address of `embed.html` asks for: `#w=CODE&look=steel&auto-rotate`. Its keys are the element's attributes, and `w`
 * for `code`; others are ignored, so that an older page shows what a newer one wrote.
 */

export type Attributes = Readonly<Record<string, string>>;

/** On where they are named, whatever is said after them but "off". */
const SWITCHES = ["camera-controls", "auto-rotate", "shadow", "replay"] as const;
const TEXTS = ["alt", "look", "color", "view", "views", "camera-orbit", "width-scale", "touch-action", "interaction-prompt", "loading", "reveal", "labels", "dir"] as const;
const ADDRESSES = ["src", "poster"] as const;
const OFF = ["off", "false", "0", "no"];

/** No attribute but a code has a reason to be longer. */
const MOST_CHARACTERS = 4_000;
/** As for any share code. */
const MOST_OF_CODE = 1 << 20;

/** Attributes for the element; `base` is the page's own address. Nothing that is wrong throws: it is left out. */
export function readEmbed(hash: string, base: string): Attributes {
  const pairs = new URLSearchParams(hash.replace(/^#/, "").slice(0, 2 * MOST_OF_CODE));
  const attributes: Record<string, string> = {};
  const code = pairs.get("w") ?? pairs.get("code");
  if (code !== null && code.length <= MOST_OF_CODE) attributes["code"] = code;
  // What people expect of a frame; it can be switched off.
  attributes["camera-controls"] = "";
  for (const name of SWITCHES) {
    const value = pairs.get(name);
    if (value === null) continue;
    if (OFF.includes(value)) delete attributes[name];
    else attributes[name] = "";
  }
  for (const name of TEXTS) {
    const value = pairs.get(name);
    if (value !== null && value.length <= MOST_CHARACTERS) attributes[name] = value;
  }
  for (const name of ADDRESSES) {
    const address = usable(pairs.get(name), base);
    if (address !== null) attributes[name] = address;
  }
  return attributes;
}

/** Something to fetch: never a script's address, nor a file of this device. */
function usable(text: string | null, base: string): string | null {
  if (!text || text.length > MOST_CHARACTERS || !URL.canParse(text, base)) return null;
  const url = new URL(text, base);
  return ["https:", "http:"].includes(url.protocol) && !url.username && !url.password ? url.href : null;
}

/** The page that may drive this one, `?origin=https://example.org`; null where nobody may. */
export function readOrigin(search: string): string | null {
  const text = new URLSearchParams(search).get("origin");
  if (!text || !URL.canParse(text)) return null;
  const { origin, protocol } = new URL(text);
  return ["https:", "http:"].includes(protocol) && text === origin ? origin : null;
}
