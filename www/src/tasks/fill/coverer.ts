/**
 * Shows how a wire would run over the shape as it is now: soon after a change, and only the newest. A curve that nobody
 * wants any more is ended on the spot, since the worker cannot hear while it makes one.
 */

import { msg } from "@lit/localize";
import { Cancelled } from "../../engine/client";
import type { SettingValues } from "../../engine/protocol";
import type { WireShape } from "#sculpture/scene/shape";
import { explain } from "../../words/sentences";
import { meshKey, workOf, type Cover } from "./given";
import type { FillWork, FoundSurface, Mesh } from "./protocol";

export interface CoverState {
  /** Of the shape that is given; null while it is read. */
  readonly surface: FoundSurface | null;
  /** How the wire would run over that shape: as it is set now, or the one before while that is sought. */
  readonly curve: WireShape | null;
  /** How much of it is done, 0 to 1; null at rest. */
  readonly covering: number | null;
  /** Why there is none, a sentence, or empty. */
  readonly coverProblem: string;
}

export const NO_COVER: CoverState = { surface: null, curve: null, covering: null, coverProblem: "" };

/** What somebody looks at. */
export interface Wish {
  readonly cover: Cover;
  readonly settings: SettingValues;
  /** Names the curve; null where a finished wire is shown in its place. */
  readonly curve: string | null;
  /** Whether a run has the engine: then the shape alone is asked for, and nothing is ended. */
  readonly running: boolean;
}

export interface CoverEngine {
  surface(mesh: Mesh): Promise<FoundSurface>;
  curve(work: FillWork, settings: SettingValues): Promise<WireShape>;
  /** Ends what is asked, which is then refused as `Cancelled`. */
  cancel(): void;
}

/** A slider that is dragged is not to be disturbed at every step. */
const WAIT_MS = 150;

export class Coverer {
  private wish: Wish | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private working = false;
  /** The name of the curve that is being made. */
  private making = "";
  /** What is shown, or could not be. */
  private known = { mesh: "", curve: "" };
  private surfaceKnown = false;

  constructor(
    private readonly engine: CoverEngine,
    private readonly show: (state: Partial<CoverState>) => void,
  ) {}

  /** To be called after every change; null while nobody looks. */
  follow(wish: Wish | null): void {
    const before = this.wish;
    this.wish = wish;
    clearTimeout(this.timer);
    if (!wish) return;
    const mesh = meshKey(wish.cover.mesh);
    if (mesh !== this.known.mesh) {
      this.known = { mesh, curve: "" };
      this.show(NO_COVER);
      this.surfaceKnown = false;
    }
    if (this.making && this.making !== wish.curve && !wish.running) this.engine.cancel();
    if (!this.done(wish)) this.timer = setTimeout(() => void this.work(), before ? WAIT_MS : 0);
  }

  /** Nothing is given any more. */
  forget(): void {
    this.follow(null);
    if (!this.known.mesh) return;
    this.known = { mesh: "", curve: "" };
    this.show(NO_COVER);
  }

  /** How far the curve under way is. */
  hear(share: number): void {
    if (this.making) this.show({ covering: share });
  }

  private done({ curve, running }: Wish): boolean {
    return this.surfaceKnown && (running || curve === null || curve === this.known.curve);
  }

  private async work(): Promise<void> {
    if (this.working) return;
    this.working = true;
    for (let wish = this.wish; wish && !this.done(wish); wish = this.wish) await this.answer(wish);
    this.working = false;
  }

  private async answer(wish: Wish): Promise<void> {
    const mesh = meshKey(wish.cover.mesh);
    const current = (): boolean => this.known.mesh === mesh;
    try {
      if (!this.surfaceKnown) {
        const surface = await this.engine.surface(wish.cover.mesh);
        if (!current()) return;
        this.surfaceKnown = true;
        this.show({ surface, coverProblem: "" });
        return;
      }
      this.making = wish.curve!;
      this.show({ covering: 0, coverProblem: "" });
      const work = await workOf(wish.cover);
      const wanted = this.making === this.wish?.curve && !this.wish.running;
      const curve = wanted ? await this.engine.curve(work, wish.settings) : null;
      if (curve && current()) {
        this.known = { mesh, curve: wish.curve! };
        this.show({ curve });
      }
    } catch (error) {
      // What is wanted now is asked next.
      if (error instanceof Cancelled || !current()) return;
      // Not asked again until something changes.
      this.known = { mesh, curve: wish.curve ?? "" };
      this.surfaceKnown = true;
      this.show({ coverProblem: explain(error, msg("The lines over the shape")) });
    } finally {
      if (this.making) this.show({ covering: null });
      this.making = "";
    }
  }
}
