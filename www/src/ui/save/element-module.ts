/** The element's module as this site serves it. */

export const siteFolder = (): string => new URL(".", document.baseURI).href;

export const elementModule = (): string => new URL("wire-sculpture.js", siteFolder()).href;

/** Defines the element, if nothing else has. */
export async function defineElement(): Promise<void> {
  if (!customElements.get("wire-sculpture")) await import(/* @vite-ignore */ elementModule());
}
