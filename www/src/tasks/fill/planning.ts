/** Which curve the shape should show: the finished wire's, or, after a change that moves the lines, how they would run now. */

import type { WireShape } from "../../embed/shape";
import { presetOf } from "../../state/address/fragment";
import { deskOf, type Made } from "../../state/keeping/document";
import type { SettingsTable, SettingValues } from "../../engine/protocol";
import type { Coverer } from "./coverer";
import type { Options } from "../../state/settings/options";
import { tableOf, type Bench } from "../../state/contract/state";
import { curveKey, lookKey, solidKey, type Cover, type Settled } from "./given";

/** What a wire is made of. */
interface Keys {
  readonly solid: string;
  readonly curve: string;
  readonly look: string;
}

const keysOf = (cover: Cover, settled: Settled): Keys => ({ solid: solidKey(cover.solid), curve: curveKey(cover, settled), look: lookKey(cover, settled) });

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
    private readonly options: Options,
    private readonly coverer: Pick<Coverer, "follow" | "forget">,
  ) {}

  /** A wire from elsewhere is on its way; what changes from now on is the person's doing. */
  awaits(): void {
    const { doc, store } = this.bench;
    // Before there is a table, settings that are asked for are not known yet.
    this.awaited = { cover: doc.cover, settings: store.get().tables && doc.desks.fill.settings };
  }

  /** To be called after every change. `ahead`: a wire is on the stage that is not in the document yet. */
  follow(ahead: boolean): void {
    const { doc, busy, store } = this.bench;
    const { cover } = doc;
    const { settings } = doc.desks.fill;
    if (!cover) this.coverer.forget();
    if (!cover || doc.job !== "fill" || !tableOf(store.get())) {
      if (cover) this.coverer.follow(null);
      this.plan(false, false);
      return;
    }
    if (this.awaited && !this.awaited.settings) this.awaited = { ...this.awaited, settings };
    const now = keysOf(cover, settledBy(tableOf(store.get())!, (name) => this.options.value(name)));
    const made = ahead ? this.keysOfAwaited(now) : this.keysOfMade(now);
    const planned = made?.curve !== now.curve;
    this.plan(planned, !planned && made?.look !== now.look);
    this.coverer.follow({ cover, settings, curve: planned ? now.curve : null, running: busy });
  }

  /** What stands on the stage for the finished wire. */
  standIn(made: WireShape | null): WireShape | null {
    const { doc, store } = this.bench;
    const { planned, curve } = store.get();
    if (doc.job !== "fill" || !planned) return made;
    const known = doc.desks.fill.made && this.keys.get(doc.desks.fill.made);
    return curve ?? (known && doc.cover && known.solid === solidKey(doc.cover.solid) ? made : null);
  }

  /** What a wire covers; null where that is gone. */
  coverOf(made: Made): Cover | null {
    const { given } = made.track ?? {};
    if (given?.job === "fill") return given.cover;
    const { cover } = this.bench.doc;
    const known = this.keys.get(made);
    return cover && (!known || known.solid === solidKey(cover.solid)) ? cover : null;
  }

  private plan(planned: boolean, restyled: boolean): void {
    const { store } = this.bench;
    const before = store.get();
    if (planned !== before.planned || restyled !== before.restyled) store.set({ planned, restyled });
  }

  /** Of the finished wire. */
  private keysOfMade(now: Keys): Keys | null {
    const { made } = deskOf(this.bench.doc);
    if (!made) return null;
    let known = this.keys.get(made);
    if (!known) {
      const { track } = made;
      known = track?.given.job === "fill" ? this.keysOf(track.given.cover, track.settings) : this.keysOfAwaited(now);
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
