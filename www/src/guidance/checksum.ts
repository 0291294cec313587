import { GuidanceError } from "./fault";

/** Lower-case hexadecimal. A GuidanceError where the browser computes none. */
export async function sha256Of(bytes: Uint8Array<ArrayBuffer>, file: string): Promise<string> {
  // Browsers have it only where nobody can change a page on its way.
  const { subtle } = crypto as { readonly subtle?: SubtleCrypto };
  if (!subtle) throw new GuidanceError(file, "A model can only be checked on a page that was opened with https. Open this one so.");
  return Array.from(new Uint8Array(await subtle.digest("SHA-256", bytes)), (byte) => byte.toString(16).padStart(2, "0")).join("");
}
