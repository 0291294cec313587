/** The settings of the job that is looked at: what they are, and how they change. */

import type { Job, SettingsTables, SettingValues } from "../../engine/protocol";
import { known, presetOf, problemWith } from "../address/fragment";
import { deskOf, JOBS, withDesk } from "../keeping/document";
import { tableOf, type Bench } from "../contract/state";

/** Settings that say what is made, not how long it takes: a preset leaves them alone, and so it does whole groups. */
const NOT_OF_PRESETS: Readonly<Record<Job, readonly string[]>> = {
  multiview: ["seed", "backend"],
  stroke: ["seed", "backend", "control_points", "min_width", "max_width"],
  fill: ["seed", "backend"],
};
const GROUPS_NOT_OF_PRESETS: readonly string[] = ["views", "stroke", "surface"];

export class Options {
  /** From an address, until the tables say which of them there are. */
  private asked: { readonly job: Job; readonly settings: SettingValues } | null = null;

  constructor(private readonly bench: Bench) {}

  get all(): SettingValues {
    return deskOf(this.bench.doc).settings;
  }

  /** The value a run would take. */
  value(name: string): string {
    const table = tableOf(this.bench.store.get());
    return this.all[name] ?? (table ? presetOf(this.all, table)[name] : undefined) ?? "";
  }

  set(name: string, value: string): void {
    this.setAll({ [name]: value }, `Set ${name.replaceAll("_", " ")}`, `set ${name}`);
  }

  /** Several at once, as one step. */
  setAll(values: SettingValues, label: string, kind = ""): void {
    const table = tableOf(this.bench.store.get());
    if (table && Object.entries(values).some(([name, value]) => problemWith(name, value, table))) return;
    const next = { ...("preset" in values ? this.besidesPreset() : this.all), ...values };
    this.put(label, table ? known(next, table) : next, kind);
  }

  reset(): void {
    this.put("Reset the settings", {});
  }

  /** What an address asks for, once the core has told what there is. */
  ask(job: Job, settings: SettingValues): void {
    this.asked = { job, settings };
    const { tables } = this.bench.store.get();
    if (tables) this.learn(tables);
  }

  learn(tables: SettingsTables): void {
    const { store, project } = this.bench;
    for (const job of JOBS) {
      const asked = known(this.asked?.job === job ? this.asked.settings : {}, tables[job]);
      const { settings } = project.doc.desks[job];
      const next = Object.keys(asked).length ? asked : known(settings, tables[job]);
      if (JSON.stringify(next) !== JSON.stringify(settings)) project.replace(withDesk(project.doc, job, { settings: next }));
    }
    this.asked = null;
    store.set({ tables });
  }

  private put(label: string, settings: SettingValues, kind = ""): void {
    const { doc } = this.bench;
    this.bench.edit(label, withDesk(doc, doc.job, { settings }), kind);
  }

  private besidesPreset(): SettingValues {
    const { store, doc } = this.bench;
    const rows = tableOf(store.get())?.rows ?? [];
    const groupOf = (name: string): string => rows.find((row) => row.name === name)?.group ?? "";
    const stays = (name: string): boolean => NOT_OF_PRESETS[doc.job].includes(name) || GROUPS_NOT_OF_PRESETS.includes(groupOf(name));
    return Object.fromEntries(Object.entries(this.all).filter(([name]) => stays(name)));
  }
}
