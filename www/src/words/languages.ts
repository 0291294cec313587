/** The languages of the page, and which of them somebody gets. */

/** By their codes (BCP 47), each by its own name; English, in which the texts are written, first. */
export const LANGUAGES = { en: "English", de: "Deutsch", es: "Español", ja: "日本語", "zh-Hant": "繁體中文" } as const;

/** `pseudo` is English in disguise: longer, and with marks on its letters. It shows texts that are not translated, and places that are too narrow. */
export type Language = keyof typeof LANGUAGES | "pseudo";

/** The one that a code asks for (`de-AT` is German); null where the page has none. */
export function languageOf(code: string): Language | null {
  const asked = code.trim().toLowerCase();
  if (asked === "pseudo") return "pseudo";
  // There is one Chinese, in the script of Taiwan and Hong Kong: it is not given to who asked for the other.
  if (/^zh-(hans|cn|sg)\b/.test(asked)) return null;
  const spoken = asked.split("-")[0]!;
  return (Object.keys(LANGUAGES) as (keyof typeof LANGUAGES)[]).find((language) => language.split("-")[0] === spoken) ?? null;
}

/** What an address asks with: `?lng=de`. */
export const LANGUAGE_KEY = "lng";

/** The address of a page in a language; null leaves it to whoever opens it. */
export function addressIn(address: string, language: Language | null): string {
  const url = new URL(address);
  // To delete what is not there would still write the rest anew.
  if (url.searchParams.has(LANGUAGE_KEY)) url.searchParams.delete(LANGUAGE_KEY);
  if (language) url.searchParams.set(LANGUAGE_KEY, language);
  return url.href;
}

/** What the address asks for goes before what was chosen here once, and that before what the browser likes best. */
export function chosen(address: string | null, stored: string | null, liked: readonly string[]): Language {
  for (const code of [address, stored, ...liked]) {
    const language = code === null ? null : languageOf(code);
    if (language) return language;
  }
  return "en";
}
