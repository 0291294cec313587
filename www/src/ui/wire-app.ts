import { css, html, LitElement, nothing } from "lit";
import { customElement, query, queryAll, state } from "lit/decorators.js";
import type { ExportFormat } from "../engine/protocol";
import { codeFrom } from "../state/link";
import { SLOTS, Studio, type Slot, type StudioState } from "../state/studio";
import "../view/loss-curve";
import "../view/match-panels";
import type { MatchPanels } from "../view/match-panels";
import type { DrawingPad } from "./drawing-pad";
import "./drawing-pad";
import { EXAMPLE, EXAMPLE_CODE } from "./example";
import { icons } from "./icons";
import "./run-panel";
import "./settings-panel";
import { controls } from "./shared";
import { match, verdict } from "./verdict";
import type { WireStage } from "./wire-stage";
import "./wire-stage";

/** The whole page: pads, stage and panel, and the wiring between them and the studio. */
@customElement("wire-app")
export class WireApp extends LitElement {
  private readonly studio = new Studio();
  @state() private now: StudioState = this.studio.store.get();
  @query("wire-stage") private stage!: WireStage;
  @query("match-panels") private panels!: MatchPanels;
  @queryAll("drawing-pad") private pads!: NodeListOf<DrawingPad>;
  private readonly ending = new AbortController();

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        grid-template: 56px minmax(0, 1fr) / 264px minmax(0, 1fr) 304px;
        grid-template-areas: "head head head" "pads stage side";
        height: 100%;
      }
      header {
        grid-area: head;
        display: flex;
        align-items: center;
        gap: 16px;
        padding: 0 24px;
        border-bottom: 1px solid var(--line);
      }
      h1 {
        margin: 0;
        font-size: 20px;
        font-weight: 600;
        letter-spacing: -0.01em;
      }
      h1 b {
        font-weight: 600;
        color: var(--copper-text);
      }
      header p {
        margin: 0;
        color: var(--quiet);
      }
      .pads {
        grid-area: pads;
        padding: 8px 16px 16px 24px;
        overflow: auto;
      }
      wire-stage {
        grid-area: stage;
      }
      .side {
        grid-area: side;
        display: flex;
        flex-direction: column;
        gap: 24px;
        padding: 20px 24px 24px 16px;
        overflow: auto;
      }
      section > h2 {
        margin-bottom: 8px;
      }
      .verdict {
        min-height: 57px;
        margin: 8px 0;
        font-size: 13px;
        line-height: 19px;
        color: var(--quiet);
      }
      .save {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 8px;
      }
      .save .link {
        grid-column: 1 / -1;
      }
      .problem {
        position: fixed;
        z-index: 2;
        left: 50%;
        bottom: 24px;
        display: flex;
        align-items: center;
        gap: 12px;
        width: max-content;
        max-width: min(560px, calc(100vw - 32px));
        padding: 6px 6px 6px 16px;
        border: 1px solid var(--error);
        border-radius: 6px;
        background: var(--raised);
        color: var(--error);
        box-shadow: var(--shadow);
        transform: translateX(-50%);
      }
      .problem span {
        padding: 6px 0;
      }
      .problem button {
        flex: none;
        width: 44px;
        padding: 0;
        border: 0;
        background: none;
      }
      @media (max-width: 1099px) {
        :host {
          grid-template-columns: 200px minmax(0, 1fr) 256px;
        }
        .pads {
          padding-left: 16px;
        }
        .side {
          padding-right: 16px;
        }
        header {
          padding: 0 16px;
        }
      }
      /* A phone, or a tablet held upright: the stage stays above, everything else scrolls below it. */
      @media (max-width: 819px), (max-width: 1099px) and (orientation: portrait) {
        :host {
          display: block;
          height: auto;
          padding-bottom: 32px;
        }
        header {
          height: 48px;
          border: 0;
        }
        header p {
          overflow: hidden;
          font-size: 13px;
          text-overflow: ellipsis;
          white-space: nowrap;
        }
        wire-stage {
          position: sticky;
          z-index: 1;
          top: 0;
          height: 46svh;
          min-height: 240px;
          border-bottom: 1px solid var(--line);
        }
        .pads {
          display: grid;
          grid-template-columns: repeat(3, minmax(0, 1fr));
          gap: 8px;
          padding: 8px 16px 0;
        }
        .side {
          padding: 16px;
          overflow: visible;
        }
      }
      @media (min-width: 600px) and (max-width: 1099px) and (orientation: portrait) {
        .pads {
          gap: 16px;
        }
        .side {
          display: grid;
          grid-template: "run match" auto "keep match" auto "settings match" 1fr / 1fr 1fr;
        }
        run-panel {
          grid-area: run;
        }
        .match {
          grid-area: match;
        }
      }
    `,
  ];

  override render() {
    const { pads, phase, losses, finished, targets, views, notes, rows, source, settings, problem } = this.now;
    const idle = phase === "idle";
    return html`
      <header>
        <h1>Wire<b>4D</b></h1>
        <p>Three drawings, one wire</p>
      </header>
      <wire-stage></wire-stage>
      <div class="pads" role="group" aria-label="Drawings">
        ${SLOTS.map(
          (slot) => html`<drawing-pad
            .slotName=${slot}
            .pad=${pads[slot]}
            ?locked=${!idle}
            @give=${(event: CustomEvent<File>) => void this.studio.give(slot, event.detail, event.detail.name || `The ${slot} picture`)}
            @clear=${() => this.studio.clear(slot)}
          ></drawing-pad>`,
        )}
      </div>
      <main class="side">
        <run-panel
          .state=${this.now}
          @run=${() => void this.studio.run()}
          @pause=${() => this.studio.pause()}
          @stop=${() => this.studio.stop()}
        ></run-panel>
        <section class="match">
          <h2>Match</h2>
          <match-panels
            .views=${views}
            .targets=${targets}
            .shares=${new Map(finished?.measures.views.map((view) => [view.name, match(view)]))}
          ></match-panels>
          <p class="verdict" aria-live="polite">${finished && source !== "example" ? verdict(finished) : notes.join(" ")}</p>
          <loss-curve .losses=${losses}></loss-curve>
        </section>
        <section>
          <h2>Keep it</h2>
          <div class="save">
            <button ?disabled=${!finished} @click=${() => void this.save("glb", "wire.glb")}>${icons.download} GLB</button>
            <button ?disabled=${!finished} @click=${() => void this.save("wire.json", "wire.json")}>${icons.file} wire.json</button>
            <button class="link" ?disabled=${!finished} @click=${() => void this.copyLink()}>${icons.link} Copy link</button>
          </div>
        </section>
        <section>
          <h2>Settings</h2>
          <settings-panel
            .rows=${rows}
            .values=${settings}
            ?locked=${!idle}
            @choose=${(event: CustomEvent<[string, string]>) => this.studio.set(...event.detail)}
          ></settings-panel>
        </section>
      </main>
      ${problem
        ? html`<div class="problem" role="alert">
            ${icons.warning}<span>${problem}</span>
            <button aria-label="Close this message" @click=${() => this.studio.warn("")}>${icons.close}</button>
          </div>`
        : nothing}
    `;
  }

  protected override firstUpdated(): void {
    const { signal } = this.ending;
    this.studio.store.follow((state) => (this.now = state));
    this.studio.followWire((wire) => {
      this.stage.setWire(wire);
      this.panels.setWire(wire);
    });
    addEventListener("hashchange", () => this.openLink(), { signal });
    addEventListener("paste", (event) => this.fill([...(event.clipboardData?.files ?? [])]), { signal });
    addEventListener("dragover", (event) => event.preventDefault(), { signal });
    addEventListener(
      "drop",
      (event) => {
        event.preventDefault();
        this.fill([...(event.dataTransfer?.files ?? [])]);
      },
      { signal },
    );
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.recolour(), { signal });
    if (!this.openLink()) void this.showExample();
    for (const slot of SLOTS) void this.giveExample(slot);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.ending.abort();
  }

  private openLink(): boolean {
    const code = codeFrom(location.hash);
    if (code !== null) void this.studio.open(code, "link");
    return code !== null;
  }

  private async showExample(): Promise<void> {
    const response = await fetch(EXAMPLE_CODE);
    if (response.ok) await this.studio.open((await response.text()).trim(), "example");
  }

  private async giveExample(slot: Slot): Promise<void> {
    const response = await fetch(EXAMPLE[slot]);
    if (response.ok && !this.now.pads[slot].picture) await this.studio.give(slot, await response.blob(), slot);
  }

  /** Files dropped or pasted anywhere: into the empty pads first, then from the front on. */
  private fill(files: readonly File[]): void {
    if (this.now.phase !== "idle") return;
    const order = [...SLOTS.filter((slot) => !this.now.pads[slot].picture), ...SLOTS.filter((slot) => this.now.pads[slot].picture)];
    files.slice(0, SLOTS.length).forEach((file, i) => void this.studio.give(order[i]!, file, file.name));
    if (files.length > SLOTS.length) this.studio.warn(`There are three pads; the first three of ${files.length} files were taken.`);
  }

  private async save(format: ExportFormat, name: string): Promise<void> {
    const blob = await this.studio.export(format);
    if (!blob) return;
    const anchor = document.createElement("a");
    anchor.href = URL.createObjectURL(blob);
    anchor.download = name;
    anchor.click();
    setTimeout(() => URL.revokeObjectURL(anchor.href), 10_000);
    this.studio.say(`Saved ${name}`);
  }

  private async copyLink(): Promise<void> {
    const link = await this.studio.link(location.href);
    if (!link) return;
    history.replaceState(null, "", link);
    try {
      await navigator.clipboard.writeText(link);
      this.studio.say("Link copied. It carries the whole wire.");
    } catch {
      this.studio.say("The link is in the address bar; copy it from there.");
    }
  }

  private recolour(): void {
    this.panels.recolour();
    for (const pad of this.pads) pad.paint();
  }
}
