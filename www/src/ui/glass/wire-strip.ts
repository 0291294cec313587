import { msg } from "@lit/localize";
import { css, html } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import type { StudioState } from "../../state/studio";
import { Part } from "../../view/part";
import { radiusInDiameters, sampleAt } from "../../view/profile";
import { controls } from "../shared/shared";
import type { Glass } from "./glass";
import { placeWords } from "./place-words";
import { paintStrip } from "./strip-painting";

/** How far keys go, as shares of the length. */
const STEP = 0.005;
const PAGE = 0.05;

/** The wire from end to end: how tightly it bends, and how thick it is. A place on it is a place on the stage, and the other way round. */
@customElement("wire-strip")
export class WireStrip extends Part {
  @property({ attribute: false }) glass!: Glass;
  @property({ attribute: false }) state!: StudioState;
  @query("canvas") private canvas!: HTMLCanvasElement;
  private stop: () => void = () => undefined;
  private readonly resized = new ResizeObserver(() => this.requestUpdate());
  private readonly recolour = (): void => this.requestUpdate();

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        grid-template-columns: minmax(0, 1fr) auto;
        gap: 4px 12px;
        padding: 4px 16px 8px;
      }
      .along {
        grid-column: 1 / -1;
        height: 56px;
        border: 1px solid var(--line);
        border-radius: 6px;
        background: var(--raised);
        cursor: ew-resize;
        touch-action: pan-y;
      }
      canvas {
        display: block;
        width: 100%;
        height: 100%;
      }
      output {
        align-self: center;
        min-height: 36px;
        font-size: 13px;
        line-height: 18px;
        color: var(--quiet);
      }
      button {
        min-height: 36px;
        font-size: 13px;
      }
      @media (pointer: coarse) {
        button {
          min-height: 44px;
        }
      }
    `,
  ];

  override connectedCallback(): void {
    super.connectedCallback();
    this.stop = this.glass.store.follow(() => this.requestUpdate());
    addEventListener("theme-change", this.recolour);
    this.resized.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stop();
    removeEventListener("theme-change", this.recolour);
    this.resized.disconnect();
  }

  override render() {
    const { profile, at } = this.glass.store.get();
    const words = profile && at !== null ? placeWords(profile, at, this.state.views) : msg("Point at the strip or at the wire, or use the arrow keys: how it bends there, and how thick it is.");
    const now = profile && at !== null ? Math.round(100 * profile.shares[at]!) : 0;
    return html`
      <div
        class="along"
        role="slider"
        tabindex="0"
        data-keys
        aria-label=${msg("Along the wire: bends above, width below")}
        aria-valuemin="0"
        aria-valuemax="100"
        aria-valuenow=${now}
        aria-valuetext=${words}
        @keydown=${this.press}
        @pointermove=${this.point}
        @pointerdown=${this.point}
      >
        <canvas></canvas>
      </div>
      <output aria-hidden="true">${words}</output>
      <button ?disabled=${!profile?.count} @click=${this.toTightest}>${msg("Tightest bend")}</button>
    `;
  }

  protected override updated(): void {
    const { profile, at } = this.glass.store.get();
    if (!profile || this.canvas.clientWidth === 0) return;
    const style = getComputedStyle(this);
    const colour = (name: string): string => style.getPropertyValue(name);
    const forced = matchMedia("(forced-colors: active)").matches;
    paintStrip(this.canvas, profile, this.least, at, {
      bend: colour("--line-strong"),
      tight: forced ? colour("--amber") : colour("--copper"),
      width: forced ? style.color : colour("--quiet"),
      line: colour("--line"),
      ink: style.color,
    });
  }

  /** The bend radius that a run keeps to, in diameters. */
  private get least(): number {
    const { options } = this.glass.studio;
    return options.value("smooth") === "on" ? Number(options.value("bend_radius")) || 0 : 0;
  }

  private go(share: number): void {
    const { profile } = this.glass.store.get();
    if (profile?.count) this.glass.store.set({ at: sampleAt(profile, Math.max(0, Math.min(1, share))) });
  }

  private readonly point = ({ clientX }: PointerEvent): void => {
    const { left, width } = this.canvas.getBoundingClientRect();
    this.go((clientX - left) / width);
  };

  private readonly press = (event: KeyboardEvent): void => {
    const { profile, at } = this.glass.store.get();
    if (!profile?.count) return;
    const share = at === null ? 0 : profile.shares[at]!;
    const to = { ArrowRight: share + STEP, ArrowUp: share + STEP, ArrowLeft: share - STEP, ArrowDown: share - STEP, PageUp: share + PAGE, PageDown: share - PAGE, Home: 0, End: 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    this.go(to);
  };

  private readonly toTightest = (): void => {
    const { profile } = this.glass.store.get();
    if (!profile) return;
    let at = 0;
    for (let i = 1; i < profile.count; i++) if (radiusInDiameters(profile, i) < radiusInDiameters(profile, at)) at = i;
    this.glass.store.set({ at });
  };
}
