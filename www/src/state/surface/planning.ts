/** Which curve the shape should show: the finished wire's, or, after a change that moves the lines, how they would run now. */

import type { WireShape } from "../../embed/shape";
import { presetOf } from "../address/fragment";
import { deskOf, type Made } from "../keeping/document";
import type { Coverer } from "../run/coverer";
import type { Options } from "../settings/options";
import { tableOf, type Bench } from "../studio-state";
import { curveKey, lookKey, solidKey, type Cover } from "./cover";

/** What a wire is made of. */
interface Keys {
  readonly solid: string;
  readonly curve: string;
  readonly look: string;
}

const keysOf = (cover: Cover, value: (name: string) => string): Keys => ({ solid: solidKey(cover.solid), curve: curveKey(cover, value), look: lookKey(cover, value) });

export class Planning {
  /** Of wires that were made. One from elsewhere is of what was there when it came. */
  private readonly keys = new WeakMap<Made, Keys>();

  constructor(
    private readonly bench: Bench,
    private readonly options: Options,
    private readonly coverer: Pick<Coverer, "follow" | "forget">,
  ) {}

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
    const now = keysOf(cover, (name) => this.options.value(name));
    const made = ahead ? now : this.keysOfMade(now);
    const planned = made?.curve !== now.curve;
    this.plan(planned, !planned && made?.look !== now.look);
    this.coverer.follow(busy ? null : { cover, settings, curve: planned ? now.curve : null });
  }

  /** What stands on the stage for the finished wire. */
  standIn(made: WireShape | null): WireShape | null {
    const { doc, store } = this.bench;
    const { planned, curve } = store.get();
    if (doc.job !== "fill" || !planned) return made;
    const known = doc.desks.fill.made && this.keys.get(doc.desks.fill.made);
    return curve ?? (known && doc.cover && known.solid === solidKey(doc.cover.solid) ? made : null);
  }

  private plan(planned: boolean, restyled: boolean): void {
    const { store } = this.bench;
    const before = store.get();
    if (planned !== before.planned || restyled !== before.restyled) store.set({ planned, restyled });
  }

  /** Of the finished wire. */
  private keysOfMade(now: Keys): Keys | null {
    const { doc, store } = this.bench;
    const { made } = deskOf(doc);
    if (!made) return null;
    let known = this.keys.get(made);
    if (!known) {
      const { given, settings } = made.track ?? {};
      const table = tableOf(store.get())!;
      known = given?.job === "fill" ? keysOf(given.cover, (name) => settings![name] ?? presetOf(settings!, table)[name] ?? "") : now;
      this.keys.set(made, known);
    }
    return known;
  }
}
