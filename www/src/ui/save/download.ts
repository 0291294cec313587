/** Hands a file to the browser's downloads. */

/** Long enough for the slowest browser to begin. */
const KEPT_MS = 10_000;

export function download(blob: Blob, name: string): void {
  const anchor = document.createElement("a");
  anchor.href = URL.createObjectURL(blob);
  anchor.download = name;
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), KEPT_MS);
}
