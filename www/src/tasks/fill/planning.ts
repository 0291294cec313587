/** Which curve the shape should show: the finished wire's, or, after a change that moves the lines, how they would run now. */

import type { SettingsTable, SettingValues } from "../../engine/protocol";
import type { Bench } from "../../state/contract/bench";
import { givenFor, passingOf, tableOf, type TaskState } from "../../state/contract/state";
import { deskOf, type Made } from "../../state/keeping/document";
import { presetOf } from "../../state/settings/values";
import type { Coverer } from "./coverer";
import { curveKey, lookKey, meshKey, type Cover, type Settled } from "./given";

/** How the wire that is there stands to what would be made. */
export interface PlanState {
  /** It would go another way, or look otherwise. */
  readonly stale: "way" | "look" | null;
  /** It is of the mesh that is given. */
  readonly ofThisMesh: boolean;
}

export const NO_PLAN: PlanState = { stale: null, ofThisMesh: false };

/** What a wire is made of. */
interface Keys {
  readonly mesh: string;
  readonly curve: string;
  readonly look: string;
}

const keysOf = (cover: Cover, settled: Settled): Keys => ({ mesh: meshKey(cover.mesh), curve: curveKey(cover, settled), look: lookKey(cover, settled) });

/** The settings as `value` gives them. */
function settledBy({ rows }: SettingsTable, value: (name: string) => string): Settled {
  return { value, affecting: (what) => rows.filter(({ affects }) => affects.includes(what)).map(({ name }) => value(name)) };
}

export class Planning {
  /** Of wires that were made. */
  private readonly keys = new WeakMap<Made, Keys>();
  /** What a wire from elsewhere is of: what was there when it was asked for, with the settings that came with it. */
  private awaited: { readonly cover: Cover | null; readonly settings: SettingValues | null } | null = null;

  constructor(
    private readonly bench: Bench,
    private readonly task: TaskState<Cover | null, PlanState>,
    private readonly coverer: Pick<Coverer, "follow" | "forget">,
  ) {}

  /** A wire from elsewhere is on its way; what changes from now on is the person's doing. */
  awaits(): void {
    const { doc, store } = this.bench;
    // Before there is a table, settings that are asked for are not known yet.
    this.awaited = { cover: this.cover, settings: store.get().tables && deskOf(doc, this.task.name).settings };
  }

  /** To be called after every change. */
  follow(): void {
    const { doc, busy, store, settings: chosen } = this.bench;
    const { cover } = this;
    const { name } = this.task;
    const state = store.get();
    const { settings, made } = deskOf(doc, name);
    if (!cover) this.coverer.forget();
    if (!cover || doc.task !== name || !tableOf(state)) {
      if (cover) this.coverer.follow(null);
      this.tell(NO_PLAN);
      return;
    }
    if (this.awaited && !this.awaited.settings) this.awaited = { ...this.awaited, settings };
    const now = keysOf(cover, settledBy(tableOf(state)!, (name) => chosen.value(name)));
    // A wire may be on the stage that is not in the document yet.
    const keys = state.ahead?.task === name && state.ahead.coming ? this.keysOfAwaited(now) : this.keysOfMade(now);
    const planned = keys?.curve !== now.curve;
    const known = made && this.keys.get(made);
    this.tell({ stale: planned ? "way" : keys?.look !== now.look ? "look" : null, ofThisMesh: known?.mesh === meshKey(cover.mesh) });
    this.coverer.follow({ cover, settings, curve: planned ? now.curve : null, running: busy });
  }

  /** What a wire covers; null where that is gone. */
  coverOf(made: Made): Cover | null {
    const { track } = made;
    if (track?.task === this.task.name) return track.given as Cover;
    const { cover } = this;
    const known = this.keys.get(made);
    return cover && (!known || known.mesh === meshKey(cover.mesh)) ? cover : null;
  }

  private get cover(): Cover | null {
    return givenFor(this.bench.store.get(), this.task);
  }

  private tell({ stale, ofThisMesh }: PlanState): void {
    const { store } = this.bench;
    const before = passingOf(store.get(), this.task);
    if (stale === before.stale && ofThisMesh === before.ofThisMesh) return;
    // Whoever looks back is to see how the lines would run now.
    if ((stale === "way") !== (before.stale === "way")) store.set({ lookingBack: null });
    this.bench.pass(this.task, { stale, ofThisMesh });
  }

  /** Of the finished wire. */
  private keysOfMade(now: Keys): Keys | null {
    const { made } = deskOf(this.bench.doc, this.task.name);
    if (!made) return null;
    let known = this.keys.get(made);
    if (!known) {
      const { track } = made;
      known = track ? this.keysOf(track.given as Cover, track.settings) : this.keysOfAwaited(now);
      if (!track) this.awaited = null;
      this.keys.set(made, known);
    }
    return known;
  }

  private keysOfAwaited(now: Keys): Keys {
    const { cover, settings } = this.awaited ?? {};
    return cover ? this.keysOf(cover, settings!) : now;
  }

  private keysOf(cover: Cover, settings: SettingValues): Keys {
    const table = tableOf(this.bench.store.get())!;
    const preset = presetOf(settings, table);
    return keysOf(cover, settledBy(table, (name) => settings[name] ?? preset[name] ?? ""));
  }
}
