/** What the page may cost, and what it costs: one table. `cargo xtask budget` prints it. */

import { runAudits } from "./audits";
import { runFilms } from "./films";
import { runPlaces } from "./places";
import { runThrottled } from "./throttled-run";
import { runWaits } from "./waits";
import { sizes } from "./sizes";

/** One line of the table. */
export interface Row {
  readonly budget: string;
  readonly limit: string;
  readonly measured: string;
  readonly ok: boolean;
}

/** Rows, and what there is to say about them below the table. */
export interface Account {
  readonly rows: readonly Row[];
  readonly notes: readonly string[];
}

const PARTS: Readonly<Record<string, () => Promise<Account>>> = { sizes, audits: runAudits, run: runThrottled, waits: runWaits, places: runPlaces, films: runFilms };

/** Measures the parts asked for, all of them by default; whether everything is within its limit. */
export async function measure(asked: readonly string[]): Promise<boolean> {
  const accounts: Account[] = [];
  for (const [part, account] of Object.entries(PARTS)) {
    if (asked.length && !asked.includes(part)) continue;
    console.error(`measuring: ${part}`);
    accounts.push(await account());
  }
  const rows = accounts.flatMap((account) => account.rows);
  console.log("\n| budget | limit | measured | ok |\n|---|---|---|---|");
  for (const { budget, limit, measured, ok } of rows) console.log(`| ${budget} | ${limit} | ${measured} | ${ok ? "yes" : "**no**"} |`);
  console.log();
  for (const note of accounts.flatMap((account) => account.notes)) console.log(note);
  return rows.every((row) => row.ok);
}
