import { msg, str } from "@lit/localize";
import { css, html, LitElement, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { explain } from "../../words/sentences";
import { counted } from "../../words/numbers";
import { dialogHeadStyle, dialogStyle } from "../shared/dialog-style";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";
import { entriesIn, sorted, withMore, type Entry } from "./wall-entries";
import { elementWords } from "../../words/element";

const KEPT = "wire4d.wall";

/** The wires of a class, side by side on this screen alone: they are kept as long as this tab, and nothing is sent. */
@customElement("wire-wall")
export class WireWall extends LitElement {
  @state() private entries: readonly Entry[] = kept();
  @state() private said = "";
  @state() private full = false;
  @query("dialog") private dialog!: HTMLDialogElement;
  @query("textarea") private field!: HTMLTextAreaElement;
  @query("input[type=file]") private photos!: HTMLInputElement;

  static override styles = [
    controls,
    dialogStyle,
    dialogHeadStyle,
    css`
      dialog {
        width: min(1280px, 100vw - 32px);
        height: calc(100dvh - 32px);
        max-width: none;
        overflow: auto;
      }
      header > div {
        display: flex;
        flex-wrap: wrap;
        justify-content: end;
        gap: 8px;
      }
      .body {
        display: grid;
        gap: 16px;
        padding: 8px 24px 24px;
      }
      .taking {
        display: grid;
        grid-template-columns: minmax(0, 1fr) auto;
        align-items: end;
        gap: 8px;
      }
      .taking label {
        grid-column: 1 / -1;
      }
      .acts {
        display: flex;
        flex-wrap: wrap;
        gap: 8px;
      }
      textarea {
        min-height: 72px;
        padding: 8px;
        border: 1px solid var(--line-strong);
        border-radius: 6px;
        background: var(--paper);
        color: inherit;
        font: inherit;
        resize: vertical;
      }
      p {
        margin: 0;
      }
      [role="status"] {
        min-height: 21px;
      }
      ul {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(min(300px, 100%), 1fr));
        gap: 16px;
        margin: 0;
        padding: 0;
        list-style: none;
      }
      li {
        overflow: hidden;
        border: 1px solid var(--line);
        border-radius: 6px;
        background: var(--paper);
      }
      wire-sculpture {
        display: block;
        width: 100%;
        aspect-ratio: 4 / 3;
      }
      .name {
        display: flex;
        align-items: center;
        gap: 8px;
        padding: 4px 4px 4px 12px;
        padding-inline: 12px 4px;
      }
      .name b {
        flex: 1;
        min-width: 0;
        overflow-wrap: anywhere;
        font-weight: 600;
      }
      .full .taking,
      .full .name button {
        display: none;
      }
      @media (max-width: 559px) {
        dialog {
          width: 100vw;
          height: 100dvh;
          max-height: none;
          border: 0;
          border-radius: 0;
        }
        .body {
          padding-inline: 16px;
        }
        .taking {
          grid-template-columns: minmax(0, 1fr);
        }
      }
    `,
  ];

  override render() {
    const { entries, full } = this;
    return html`<dialog class=${full ? "full" : ""} aria-labelledby="title" data-keys @fullscreenchange=${this.look}>
      <header>
        <h1 id="title">${msg("The wall")}</h1>
        <div>
          ${document.fullscreenEnabled ? html`<button @click=${this.fill}>${full ? msg("Leave full screen") : msg("Full screen")}</button>` : nothing}
          <button class="plain square" aria-label=${msg("Close the wall")} @click=${() => this.dialog.close()}>${icons.close}</button>
        </div>
      </header>
      <div class="body">
        <div class="taking">
          <label for="links">${msg("Paste the links of your class, one a line. A name may stand before each.")}</label>
          <textarea id="links" rows="3" placeholder=${msg("Mia: https://…")} @paste=${this.pasted}></textarea>
          <div class="acts">
            <button class="primary" @click=${this.hang}>${msg("Hang them up")}</button>
            <button @click=${() => this.photos.click()}>${icons.camera} ${msg("Scan a code")}</button>
            <input type="file" accept="image/*" capture="environment" multiple hidden tabindex="-1" aria-label=${msg("Photos of codes")} @change=${this.scan} />
          </div>
          <p class="small quiet">${msg("The wires stay on this screen: nothing is sent, and they are gone when this tab is closed.")}</p>
        </div>
        <p role="status">${this.said}</p>
        ${entries.length
          ? html`<div class="acts">
              <button @click=${() => this.put(sorted(entries, document.documentElement.lang))}>${msg("Sort by name")}</button>
              <button @click=${() => this.put([])}>${icons.clear} ${msg("Take all down")}</button>
            </div>`
          : nothing}
        <ul>
          ${repeat(entries, ({ code }) => code, (entry, i) => this.entry(entry, i))}
        </ul>
      </div>
    </dialog>`;
  }

  show(): void {
    if (!this.dialog.open) this.dialog.showModal();
    // Comes with the first wall that is looked at.
    void import(/* @vite-ignore */ new URL("./wire-sculpture.js", document.baseURI).href).catch((error: unknown) => (this.said = explain(error, msg("The wall"))));
  }

  private entry({ name, code }: Entry, i: number) {
    const shown = name || msg(str`Wire ${i + 1}`);
    return html`<li>
      <wire-sculpture code=${code} alt=${msg(str`The wire of ${shown}`)} views="front side top" labels=${JSON.stringify(elementWords())} camera-controls shadow></wire-sculpture>
      <div class="name">
        <b>${shown}</b>
        <button class="plain square" aria-label=${msg(str`Take down ${shown}`)} @click=${() => this.put(this.entries.filter((other) => other.code !== code))}>${icons.close}</button>
      </div>
    </li>`;
  }

  private readonly pasted = (event: Event): void => event.stopPropagation();

  private readonly hang = (): void => {
    if (this.take(this.field.value)) this.field.value = "";
  };

  private readonly scan = async (): Promise<void> => {
    const files = [...(this.photos.files ?? [])];
    this.photos.value = "";
    this.said = msg("Looking for codes…");
    try {
      const { scanned } = await import("./scan");
      const texts = await Promise.all(files.map((file) => scanned(file).catch(() => null)));
      if (texts.every((text) => text === null)) this.said = msg("No code was found. Take the photo from nearer and straight from the front, or paste the link.");
      else this.take(texts.filter((text) => text !== null).join("\n"));
    } catch (error) {
      this.said = explain(error, msg("The scan"));
    }
  };

  /** True where anything came of it. */
  private take(text: string): boolean {
    const { entries, broken } = entriesIn(text);
    const hung = counted(entries.length, msg("One wire hangs up."), msg(str`${entries.length} wires hang up.`));
    const left = broken === 0 ? "" : counted(broken, msg("One link is cut off or damaged: ask for it again."), msg(str`${broken} links are cut off or damaged: ask for them again.`));
    this.said = entries.length + broken === 0 ? msg("There is no wire in that. Paste the whole links.") : [entries.length ? hung : "", left].filter(Boolean).join(" ");
    if (entries.length === 0) return false;
    this.put(withMore(this.entries, entries));
    return true;
  }

  private put(entries: readonly Entry[]): void {
    this.entries = entries;
    try {
      sessionStorage.setItem(KEPT, JSON.stringify(entries));
    } catch {
      // Full or blocked: it is on the screen.
    }
  }

  private readonly fill = (): void => void (document.fullscreenElement ? document.exitFullscreen() : this.dialog.requestFullscreen());

  private readonly look = (): void => void (this.full = document.fullscreenElement !== null);
}

/** What hung here before the page was loaded anew. */
function kept(): readonly Entry[] {
  try {
    const entries = JSON.parse(sessionStorage.getItem(KEPT) ?? "[]") as readonly Entry[];
    return entries.filter(({ name, code }) => typeof name === "string" && typeof code === "string");
  } catch {
    return [];
  }
}

export async function openWall(): Promise<void> {
  const wall = document.querySelector<WireWall>("wire-wall") ?? document.body.appendChild(new WireWall());
  await wall.updateComplete;
  wall.show();
}
