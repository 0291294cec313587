import { msg, str } from "@lit/localize";
import { css, html, nothing, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { EngineClient } from "../../engine/client";
import type { CallName, Calls } from "../../engine/protocol";
import { size } from "../../guidance/fault";
import { count, percent } from "../../words/numbers";
import { explain } from "../../words/sentences";
import { Part } from "../../view/part";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";

export type Facts = Calls["lookAtGuidance"]["answer"];
type Kept = Calls["guidanceShelf"]["answer"][number];
type Opened = Calls["openGuidance"]["answer"];
type Source = Calls["openGuidance"]["arguments"]["from"];
type Provider = Opened["provider"];

const KINDS: Readonly<Record<Facts["kind"], string>> = {
  "guidance-v1": msg("Tells how like words a picture is"),
  "text-v1": msg("Reads words"),
  "vjp-v1": msg("Sees pictures as a diffusion model does"),
  "eps-v1": msg("Tells a diffusion model’s noise"),
  "mask-v1": msg("Finds the object in a picture"),
  "depth-v1": msg("Guesses how far away things are"),
};
const PROVIDERS: Readonly<Record<Provider, string>> = { webgpu: msg("on the graphics card"), wasm: msg("on the processor") };

/** Models from files: what one is, before it is used; what is open; and what this browser keeps. Fires `models` with what is kept or open. */
@customElement("model-shelf")
export class ModelShelf extends Part {
  @property({ attribute: false }) engine!: EngineClient;
  /** Where models should be computed. */
  @property() prefer: Provider = "wasm";
  /** The files that were chosen, and what they say of themselves. */
  @state() private chosen: { readonly from: Source; readonly facts: Facts } | null = null;
  @state() private kept: readonly Kept[] = [];
  /** Open models, one of each kind. */
  @state() private opened: readonly Opened[] = [];
  @state() private opening: { readonly name: string; readonly words: string; readonly share: number } | null = null;
  @state() private problem = "";
  @state() private keep = true;
  @query("input[type=file]") private files!: HTMLInputElement;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: 16px;
      }
      p {
        margin: 0;
        overflow-wrap: anywhere;
      }
      h3 {
        margin: 0;
        font-size: 13px;
        font-weight: 600;
        color: var(--quiet);
      }
      label {
        display: flex;
        align-items: center;
        gap: 8px;
        min-height: 32px;
      }
      ul {
        display: grid;
        gap: 16px;
        margin: 0;
        padding: 0;
        list-style: none;
      }
      .buttons {
        display: flex;
        flex-wrap: wrap;
        gap: 8px;
        margin-block-start: 8px;
      }
      progress {
        width: 100%;
        accent-color: var(--copper);
      }
      .problem {
        color: var(--error);
      }
    `,
  ];

  override render() {
    const { chosen, kept, opening, problem } = this;
    return html`<p class="small quiet">${msg("A model that judges pictures, or takes noise from them, from files on your device: its .onnx and .json, and the tokenizer or the contexts where there are some. Nothing is sent anywhere. tools/guidance makes such files.")}</p>
      ${opening ? nothing : html`<button @click=${() => this.files.click()}>${icons.file} ${msg("Choose a model…")}</button>`}
      <input type="file" multiple accept=".onnx,.json" aria-label=${msg("Model files: .onnx and .json")} hidden @change=${this.choose} />
      ${chosen && !opening ? this.choice(chosen.from, chosen.facts) : nothing}
      <div role="status">${opening ? this.progress(opening) : this.opened.map((model) => this.ready(model))}</div>
      ${this.opened.length && !opening ? html`<button class="plain" @click=${this.close}>${msg("Close it")}</button>` : nothing}
      ${problem ? html`<p class="problem" role="alert">${problem}</p>` : nothing}
      ${kept.length ? html`<h3>${msg("Kept in this browser")}</h3><ul>${kept.map((model) => this.row(model))}</ul>` : nothing}`;
  }

  private facts(facts: Facts): TemplateResult {
    return html`<p><b>${facts.name}</b></p>
      <p class="small">${msg(str`${KINDS[facts.kind]} · ${size(facts.bytes)}, and about ${size(facts.memory)} of memory while it is opened`)}</p>
      <p class="small quiet">${msg(str`Licence: ${facts.licence || msg("not said")}. From: ${facts.origin || msg("not said")}.`)}</p>
      ${facts.prompts.length ? html`<p class="small quiet">${msg(str`Prompts it knows: ${count(facts.prompts.length)}.`)}</p>` : nothing}`;
  }

  private choice(from: Source, facts: Facts): TemplateResult {
    return html`<div>
      ${this.facts(facts)}
      <label class="small"><input type="checkbox" .checked=${this.keep} @change=${(event: Event) => (this.keep = (event.target as HTMLInputElement).checked)} /> ${msg("Keep it in this browser")}</label>
      <div class="buttons">
        <button class="primary" @click=${() => this.open(from, facts, this.keep)}>${msg("Open it")}</button>
        <button class="plain" @click=${() => (this.chosen = null)}>${msg("Leave it")}</button>
      </div>
    </div>`;
  }

  private progress({ name, words, share }: NonNullable<ModelShelf["opening"]>): TemplateResult {
    return html`<p>${name}: ${words} ${share > 0 ? percent(share) : nothing}</p>
      <progress aria-label=${msg(str`Opening ${name}`)} .value=${share > 0 ? share : null} max="1"></progress>
      <button @click=${() => void this.asked("closeGuidance", {})}>${icons.stop} ${msg("Cancel")}</button>`;
  }

  private ready({ name, provider, note, unkept }: Opened): TemplateResult {
    return html`<p>${msg(str`${name} is open ${PROVIDERS[provider]}.`)}</p>
      ${[note, unkept].map((said) => (said ? html`<p class="small quiet">${said}</p>` : nothing))}`;
  }

  private row(model: Kept): TemplateResult {
    const isOpen = this.opened.some(({ sha256 }) => sha256 === model.sha256);
    const date = new Date(model.date).toLocaleDateString();
    return html`<li>
      ${this.facts(model)}
      <p class="small quiet">${msg(str`Kept on ${date}.`)}</p>
      <div class="buttons">
        <button ?disabled=${isOpen || this.opening !== null} aria-label=${msg(str`Open ${model.name}`)} @click=${() => this.open({ kept: model.sha256 }, model, false)}>${msg("Open")}</button>
        <button class="plain" aria-label=${msg(str`Delete ${model.name}`)} @click=${() => this.list(model.sha256)}>${icons.clear} ${msg("Delete")}</button>
      </div>
    </li>`;
  }

  protected override firstUpdated(): void {
    this.engine.listen((news) => {
      if (news.news === "guidance" && this.opening) this.opening = { ...this.opening, words: news.words, share: news.share };
      if (news.news === "fresh") this.forget();
    });
    void this.list(null);
  }

  private async list(drop: string | null): Promise<void> {
    this.kept = (await this.asked("guidanceShelf", { drop })) ?? this.kept;
    this.tell();
  }

  private readonly choose = async (): Promise<void> => {
    const from: Source = { files: [...(this.files.files ?? [])] };
    this.files.value = "";
    const facts = await this.asked("lookAtGuidance", { from });
    this.chosen = facts && { from, facts };
  };

  private async open(from: Source, { name }: Facts, keep: boolean): Promise<void> {
    this.opening = { name, words: "Waiting…", share: 0 };
    const opened = await this.asked("openGuidance", { from, prefer: this.prefer, keep });
    this.opening = null;
    if (!opened) return;
    this.chosen = null;
    this.opened = [...this.opened.filter(({ kind }) => kind !== opened.kind), opened];
    await this.list(null);
  }

  private readonly close = async (): Promise<void> => {
    await this.asked("closeGuidance", {});
    this.forget();
  };

  /** Nothing is open any more. */
  private forget(): void {
    this.opened = [];
    this.tell();
  }

  private tell(): void {
    const models = [...this.opened, ...this.kept.filter(({ sha256 }) => !this.opened.some((open) => open.sha256 === sha256))];
    this.dispatchEvent(new CustomEvent<readonly Facts[]>("models", { detail: models }));
  }

  /** Null where it did not work out: then it is said why. */
  private async asked<K extends CallName>(call: K, given: Calls[K]["arguments"]): Promise<Calls[K]["answer"] | null> {
    this.problem = "";
    try {
      return await this.engine.call(call, given);
    } catch (error) {
      this.problem = explain(error, msg("This"));
      return null;
    }
  }
}
