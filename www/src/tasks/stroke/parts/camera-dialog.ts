import { msg } from "@lit/localize";
import { html, LitElement, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { icons } from "../../../ui/shared/icons";
import { dialogStyle } from "../../../ui/shared/dialog-style";
import { controls } from "../../../ui/shared/shared";
import { tell } from "./subject-events";
import { cameraDialogStyle } from "./camera-dialog-style";

type Phase = "asking" | "live" | "failed";

/**
 * Takes one photo. It asks for the camera as soon as it is there, so it is to be put there by a click; the camera is let
 * go when the dialog goes. Fires `give` with the photo, and `close-camera`.
 */
@customElement("camera-dialog")
export class CameraDialog extends LitElement {
  @state() private phase: Phase = "asking";
  @state() private problem = "";
  /** Cameras by their ids, once they may be known. */
  @state() private cameras: readonly string[] = [];
  @query("dialog") private dialog!: HTMLDialogElement;
  @query("video") private video!: HTMLVideoElement;
  private stream: MediaStream | null = null;

  static override styles = [controls, dialogStyle, cameraDialogStyle];

  override render() {
    const { phase, problem, cameras } = this;
    return html`<dialog aria-labelledby="title" @close=${this.closed}>
      <div class="all">
        <h2 id="title">${msg("Take a photo")}</h2>
        <div class="view">
          <video autoplay playsinline muted ?hidden=${phase !== "live"} aria-label=${msg("What the camera sees")}></video>
          ${phase === "live" ? nothing : html`<p role=${problem ? "alert" : "status"}>${problem || msg("Waiting for the camera. The browser may ask you first.")}</p>`}
        </div>
        <p class="small quiet">${msg("The photo stays on this device: nothing is sent anywhere.")}</p>
        <div class="buttons">
          <button @click=${() => this.dialog.close()}>${msg("Cancel")}</button>
          ${cameras.length > 1 ? html`<button @click=${this.switch}>${icons.swap}${msg("Other camera")}</button>` : nothing}
          ${phase === "failed"
            ? html`<button class="primary" @click=${() => void this.start()}>${icons.reset}${msg("Try again")}</button>`
            : html`<button class="primary" ?disabled=${phase !== "live"} @click=${this.take}>${icons.camera}${msg("Take")}</button>`}
        </div>
      </div>
    </dialog>`;
  }

  protected override firstUpdated(): void {
    this.dialog.showModal();
    void this.start();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stop();
  }

  /** Shows what a camera sees: the one with this id, or the one that looks away from the person. */
  private async start(deviceId?: string): Promise<void> {
    this.stop();
    this.phase = "asking";
    this.problem = "";
    try {
      const stream = await navigator.mediaDevices.getUserMedia({ video: deviceId ? { deviceId: { exact: deviceId } } : { facingMode: "environment" } });
      // Somebody may have closed it before the browser answered.
      if (!this.isConnected || !this.dialog.open) return letGo(stream);
      this.stop();
      this.stream = stream;
      this.video.srcObject = stream;
      await this.video.play();
      for (const track of stream.getTracks()) track.addEventListener("ended", () => this.fail(msg("The camera has stopped.")));
      this.phase = "live";
      this.cameras = (await navigator.mediaDevices.enumerateDevices()).filter(({ kind }) => kind === "videoinput").map(({ deviceId }) => deviceId);
    } catch (error) {
      this.fail(refusal(error));
    }
  }

  private switch(): void {
    const now = this.stream?.getVideoTracks()[0]?.getSettings().deviceId ?? "";
    void this.start(this.cameras[(this.cameras.indexOf(now) + 1) % this.cameras.length]);
  }

  private async take(): Promise<void> {
    const { videoWidth, videoHeight } = this.video;
    if (!videoWidth || !videoHeight) return;
    const canvas = new OffscreenCanvas(videoWidth, videoHeight);
    canvas.getContext("2d")!.drawImage(this.video, 0, 0);
    const file = await canvas.convertToBlob({ type: "image/png" });
    if (!this.isConnected) return;
    tell(this, "give", { file, name: msg("Photo") });
    this.dialog.close();
  }

  private fail(problem: string): void {
    this.stop();
    this.problem = problem;
    this.phase = "failed";
  }

  private stop(): void {
    if (this.stream) letGo(this.stream);
    this.stream = null;
    if (this.hasUpdated) this.video.srcObject = null;
  }

  private closed(): void {
    this.stop();
    this.dispatchEvent(new CustomEvent("close-camera", { bubbles: true, composed: true }));
  }
}

function letGo(stream: MediaStream): void {
  for (const track of stream.getTracks()) track.stop();
}

/** Why there is no camera, and what to do. */
function refusal(error: unknown): string {
  switch (error instanceof DOMException ? error.name : "") {
    case "NotAllowedError":
    case "SecurityError":
      return msg("This page may not use the camera. Allow it in the browser's address bar and try again, or choose a picture instead.");
    case "NotFoundError":
    case "OverconstrainedError":
      return msg("There is no camera on this device. Choose a picture instead.");
    case "NotReadableError":
    case "AbortError":
      return msg("The camera is busy: another program may be using it. Close that and try again, or choose a picture instead.");
    default:
      return msg("The camera does not start. Try again, or choose a picture instead.");
  }
}
