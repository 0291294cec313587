/** Whether a file carries a wire, at a glance: what it is, its bytes say, whatever it is called. */

/** A file begins with the one and has the other in it. */
const KINDS: readonly (readonly [begins: RegExp, carries: RegExp])[] = [
  [/^.PNG\r\n/s, /iTXtwire4d\0/],
  [/^glTF/, /"format"\s*:\s*"wire4d"|"wire4d"\s*:\s*\{[^{}]*"code"/],
  [/^[^<{]{0,8}</, /<metadata id="wire4d">/],
  [/^[^<{]{0,8}\{/, /"format"\s*:\s*"wire4d"/],
];
/** It stands near the beginning as it is written, and at the end where another program has moved it. */
const LOOKED_AT_BYTES = 262_144;

export async function carriesWire(file: Blob): Promise<boolean> {
  const parts = [file.slice(0, LOOKED_AT_BYTES), file.slice(Math.max(LOOKED_AT_BYTES, file.size - LOOKED_AT_BYTES))];
  const text = new TextDecoder("latin1").decode(await new Blob(parts).arrayBuffer());
  return KINDS.some(([begins, carries]) => begins.test(text) && carries.test(text));
}
