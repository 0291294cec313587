/** File names out of what drawings are called. */

const MOST_CHARACTERS = 24;

/** "bird-star-bike" out of ["Bird.png", "star", "My bike!"]; "wire" where there is nothing to go by. */
export function fileStem(labels: readonly string[]): string {
  const parts = labels.map(plain).filter(Boolean);
  return parts.length ? parts.join("-") : "wire";
}

/** Letters and digits of any script, joined by dashes; no file system minds them. */
function plain(label: string): string {
  const words = label.replace(/\.\w{1,5}$/, "").normalize("NFC").toLowerCase().match(/[\p{L}\p{M}\p{N}]+/gu) ?? [];
  return [...words.join("-")].slice(0, MOST_CHARACTERS).join("").replace(/-$/, "");
}
