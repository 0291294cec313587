/** Opens the gallery in its language. */

import { openWords } from "../words/open";
import { sayIn } from "../words/told";

await openWords();
sayIn(document);
await import("./page");
