/** What the page's end of this task and its engine tell each other. */

import type { Ink } from "../../engine/protocol";

/** How ink is found in a picture. */
export interface Reading {
  /** Dark or light ink; `auto` takes a sheet, else the border's shade for ground. */
  readonly ink: "auto" | "dark" | "light";
  /** Least strength that counts as ink, above 0 up to 1, edges kept soft; 0 leaves tones as they are. */
  readonly threshold: number;
}

/** What the ink finder saw. */
export interface FoundInk extends Ink {
  readonly polarity: "dark" | "light";
  /** What a person should know of how it was found, or empty; not with what was kept before there was any. */
  readonly note?: string;
}

/** A drawing as it goes into a run: ink with the name of its pad. */
export interface Drawing extends Ink {
  readonly name: string;
}

/** What a run is of. */
export interface Work {
  readonly drawings: readonly Drawing[];
  /** Views that nothing is drawn of: words pull there. */
  readonly guided: readonly string[];
}

declare module "../../engine/protocol" {
  interface Calls {
    /** What the core sees in a picture, fitted onto the middle of a square sheet and never stretched. */
    read: { arguments: { picture: Picture; reading: Reading; sidePx: number }; answer: FoundInk };
    /** What two or three drawings come to before a run. */
    preview: { arguments: { drawings: readonly Drawing[]; settings: SettingValues }; answer: Preview };
  }
}
