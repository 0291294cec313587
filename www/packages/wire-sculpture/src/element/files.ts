/** Where files carry what they were made from: a text beside a picture's pixels, a model's triangles, a drawing's lines. */

const PNG = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
const GLB_MAGIC = 0x46546c67;
const GLB_JSON = 0x4e4f534a;
const KEYWORD = "wire4d";

/** The JSON that a PNG, GLB, SVG or wire.json carries, unread; null where there is none. */
export function carriedBy(bytes: Uint8Array): string | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (PNG.every((byte, at) => bytes[at] === byte)) return inPng(bytes, view);
  if (bytes.length >= 20 && view.getUint32(0, true) === GLB_MAGIC) return inGlb(bytes, view);
  const text = new TextDecoder().decode(bytes).trimStart();
  if (text.startsWith("{")) return text;
  return text.startsWith("<") ? inSvg(text) : null;
}

/** An iTXt chunk: keyword 0, two bytes on compression, language 0, translated keyword 0, text. */
function inPng(bytes: Uint8Array, view: DataView): string | null {
  for (let at = PNG.length; at + 12 <= bytes.length; ) {
    const length = view.getUint32(at);
    const chunk = bytes.subarray(at + 8, at + 8 + length);
    if (latin(bytes.subarray(at + 4, at + 8)) === "iTXt" && chunk.length === length && latin(chunk.subarray(0, KEYWORD.length + 1)) === `${KEYWORD}\0`) {
      const language = chunk.indexOf(0, KEYWORD.length + 3);
      const text = language < 0 ? -1 : chunk.indexOf(0, language + 1);
      return chunk[KEYWORD.length + 1] || text < 0 ? null : new TextDecoder().decode(chunk.subarray(text + 1));
    }
    at += 12 + length;
  }
  return null;
}

function inGlb(bytes: Uint8Array, view: DataView): string | null {
  const length = view.getUint32(12, true);
  if (view.getUint32(16, true) !== GLB_JSON || 20 + length > bytes.length) return null;
  try {
    const scene = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length))) as Scene;
    const found = scene.extras?.[KEYWORD] ?? scene.asset?.extras?.[KEYWORD];
    return found && typeof found === "object" && "format" in found ? JSON.stringify(found) : null;
  } catch {
    return null;
  }
}

interface Scene {
  readonly extras?: Readonly<Record<string, unknown>>;
  readonly asset?: { readonly extras?: Readonly<Record<string, unknown>> };
}

function inSvg(text: string): string | null {
  const found = /<metadata[^>]*\sid=["']wire4d["'][^>]*>([^<]*)<\/metadata>/.exec(text)?.[1];
  const cdata = found === undefined ? /<metadata[^>]*\sid=["']wire4d["'][^>]*>\s*<!\[CDATA\[([^]*?)\]\]>/.exec(text)?.[1] : undefined;
  return found?.replace(/&(?:(lt|gt|amp|quot|apos)|#(\d+)|#x([\da-f]+));/gi, unescaped) ?? cdata ?? null;
}

const ENTITIES: Readonly<Record<string, string>> = { lt: "<", gt: ">", amp: "&", quot: '"', apos: "'" };

function unescaped(whole: string, name?: string, decimal?: string, hex?: string): string {
  if (name) return ENTITIES[name.toLowerCase()] ?? whole;
  const code = decimal ? parseInt(decimal, 10) : parseInt(hex!, 16);
  return code <= 0x10ffff ? String.fromCodePoint(code) : whole;
}

const latin = (bytes: Uint8Array): string => String.fromCharCode(...bytes);
