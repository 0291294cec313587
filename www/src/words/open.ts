/** Opens a page in its language, before anything else of it: texts are read once, also those that are constants. */

import { configureLocalization, type LocaleModule } from "@lit/localize";
import { remember, remembered } from "../state/common/remember";
import { localeTag, settle } from "./language";
import { addressIn, chosen, LANGUAGE_KEY, type Language } from "./languages";

/** As `plugins/words` makes them of the translations. */
interface Words extends LocaleModule {
  readonly told: readonly (readonly string[])[];
}

const LOADS = import.meta.glob<Words>(["../../words/*.json", "!../../words/told.json"], { query: "?words" });

const STORED_KEY = "language";

/** Where the language's texts cannot be had, the page is in English. */
export async function openWords(): Promise<void> {
  const wanted = chosen(new URLSearchParams(location.search).get(LANGUAGE_KEY), remembered(STORED_KEY), navigator.languages);
  if (wanted !== "en") {
    try {
      const words = await LOADS[`../../words/${wanted}.json`]!();
      const { setLocale } = configureLocalization({ sourceLocale: "en", targetLocales: [wanted], loadLocale: async () => words });
      await setLocale(wanted);
      settle(wanted, words.told);
    } catch (error) {
      console.error(error);
    }
  }
  document.documentElement.lang = localeTag();
}

/** Opens the page anew in another language, which it is to keep to. */
export function speak(language: Language): void {
  remember(STORED_KEY, language);
  // A new fragment alone would load nothing anew.
  history.replaceState(history.state, "", addressIn(location.href, null));
  location.reload();
}
