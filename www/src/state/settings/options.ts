/** The settings of the task that is looked at: what they are, and how they change. */

import { msg, str } from "@lit/localize";
import { ICONS, USUAL_WEIGHT, type Guide, type SettingsTables, type SettingValues } from "../../engine/protocol";
import { isSettingLocked } from "../common/locks";
import { readGuide } from "./guide-pairs";
import type { Bench, Settings } from "../contract/bench";
import { tableOf } from "../contract/state";
import type { Task } from "../contract/task";
import { deskOf, withDesk } from "../keeping/document";
import { known, presetOf, problemWith } from "./values";

/** Of every task: a preset leaves them alone. */
const NOT_OF_PRESETS: readonly string[] = ["seed", "backend"];

export class Options implements Settings {
  /** From an address, until the tables say which of them there are. */
  private asked: { readonly task: string; readonly settings: SettingValues } | null = null;

  constructor(
    private readonly bench: Omit<Bench, "settings">,
    private readonly tasks: readonly Pick<Task, "name" | "keeps" | "compared">[],
  ) {}

  get all(): SettingValues {
    return deskOf(this.bench.doc).settings;
  }

  /** The value a run would take. */
  value(name: string): string {
    const table = tableOf(this.bench.store.get());
    return this.all[name] ?? (table ? presetOf(this.all, table)[name] : undefined) ?? "";
  }

  set(name: string, value: string): void {
    this.setAll({ [name]: value }, msg(str`Set ${name.replaceAll("_", " ")}`), `set ${name}`);
  }

  /** Several at once, as one step. */
  setAll(values: SettingValues, label: string, kind = ""): void {
    const table = tableOf(this.bench.store.get());
    if (Object.keys(values).some((name) => this.isLocked(name))) return;
    if (table && Object.entries(values).some(([name, value]) => problemWith(name, value, table))) return;
    const next = { ...("preset" in values ? this.besidesPreset() : this.all), ...values };
    this.put(label, table ? known(next, table) : next, kind);
  }

  /** Changes what guides the next runs; as long as nothing was said of it, there is none. */
  guideBy(change: Partial<Guide>): void {
    const { doc } = this.bench;
    const guide: Guide = { words: {}, weight: USUAL_WEIGHT, by: ICONS, ...deskOf(doc).guide, ...change };
    const isSaid = guide.by !== ICONS || guide.weight !== USUAL_WEIGHT || guide.likePicture || Object.values(guide.words).some(Boolean);
    this.bench.edit(isSaid ? msg("Guide by words") : msg("Guide by pictures alone"), withDesk(doc, doc.task, { guide: isSaid ? guide : null }), "guide");
  }

  /** A word for a view; empty for none. */
  say(view: string, word: string): void {
    this.guideBy({ words: { ...deskOf(this.bench.doc).guide?.words, [view]: word } });
  }

  reset(): void {
    this.put(msg("Reset the settings"), Object.fromEntries(Object.entries(this.all).filter(([name]) => this.isLocked(name))));
  }

  /** What an address asks for, once the core has told what there is. */
  ask(task: string, settings: SettingValues): void {
    this.asked = { task, settings };
    const { tables } = this.bench.store.get();
    if (tables) this.learn(tables);
  }

  /** What of the settings of another program's run can be had here; where it is computed is this machine's own. */
  fitting(task: string, { backend: _elsewhere, ...settings }: SettingValues): SettingValues {
    const table = this.bench.store.get().tables?.[task];
    return table ? known(settings, table) : settings;
  }

  /** What an address says is to guide; it waits for nothing. */
  askGuide(task: string, pairs: SettingValues): void {
    const { project } = this.bench;
    const guide = readGuide(pairs, this.tasks.find(({ name }) => name === task)?.compared ?? []);
    if (guide) project.replace(withDesk(project.doc, task, { guide }));
  }

  learn(tables: SettingsTables): void {
    const { store, project } = this.bench;
    for (const [task, table] of Object.entries(tables)) {
      const asked = known(this.asked?.task === task ? this.asked.settings : {}, table);
      const { settings } = deskOf(project.doc, task);
      const next = Object.keys(asked).length ? asked : known(settings, table);
      if (JSON.stringify(next) !== JSON.stringify(settings)) project.replace(withDesk(project.doc, task, { settings: next }));
    }
    this.asked = null;
    store.set({ tables });
  }

  private put(label: string, settings: SettingValues, kind = ""): void {
    const { doc } = this.bench;
    this.bench.edit(label, withDesk(doc, doc.task, { settings }), kind);
  }

  private isLocked(name: string): boolean {
    return isSettingLocked(this.bench.store.get(), name);
  }

  private besidesPreset(): SettingValues {
    const { store, doc } = this.bench;
    const keeps = this.tasks.find(({ name }) => name === doc.task)?.keeps;
    const rows = tableOf(store.get())?.rows ?? [];
    const groupOf = (name: string): string => rows.find((row) => row.name === name)?.group ?? "";
    const stays = (name: string): boolean => this.isLocked(name) || [...NOT_OF_PRESETS, ...(keeps?.settings ?? [])].includes(name) || keeps?.groups.includes(groupOf(name)) === true;
    return Object.fromEntries(Object.entries(this.all).filter(([name]) => stays(name)));
  }
}
