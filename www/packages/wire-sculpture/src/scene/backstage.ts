/** Where the scene is: here, or in a worker, where a slow graphics card or none keeps the page from nothing. */

import type { Look } from "./looks";
import type { Scene, SceneEvents } from "./scene";

/** What the scene can be told without waiting for an answer. */
type Act = "setWire" | "pause" | "ration" | "place" | "mark" | "setBody" | "seeThrough" | "setLook" | "resize" | "keepStill" | "turn" | "zoom" | "pan" | "step" | "flyTo" | "tour" | "sway";
type ActOrder = { [K in Act]: { readonly act: K; readonly given: Parameters<Scene[K]> } }[Act];

/** To the worker: the first one opens the scene. */
export type Order =
  | { readonly open: OffscreenCanvas; readonly look: Look }
  | ActOrder
  | { readonly picture: number; readonly of: PictureOrder };

/** From the worker. */
export type Report =
  | { [K in keyof SceneEvents]: { readonly event: K; readonly given: Parameters<SceneEvents[K]> } }[keyof SceneEvents]
  | { readonly ready: true }
  | { readonly unavailable: true }
  | { readonly picture: number; readonly blob: Blob | null };

export type PictureOrder = Parameters<Scene["picture"]>;

/** A worker that has said nothing for so long has not begun. */
const SILENCE_MS = 10_000;

export interface Backstage {
  act<K extends Act>(act: K, ...given: Parameters<Scene[K]>): void;
  picture(...of: PictureOrder): Promise<Blob>;
  dispose(): void;
}

export function perform(scene: Scene, { act, given }: ActOrder): void {
  (scene[act] as (...given: unknown[]) => void)(...given);
}

/** The scene comes when it is wanted: mostly a worker has it. `unavailable` is called where the browser has no WebGL 2. */
export function inPage(canvas: HTMLCanvasElement, look: Look, events: SceneEvents, unavailable: () => void): Backstage {
  const opened = import("./scene").then(({ Scene }) => new Scene(canvas, look, events));
  opened.catch((error: unknown) => {
    console.warn(error);
    unavailable();
  });
  const whenOpen = (action: (scene: Scene) => void): void => void opened.then(action, () => undefined);
  return {
    act: (act, ...given) => whenOpen((scene) => perform(scene, { act, given } as ActOrder)),
    picture: async (...of) => (await opened).picture(...of),
    dispose: () => whenOpen((scene) => scene.dispose()),
  };
}

/** `unavailable` is called where the worker cannot draw; the canvas is of no use to anybody else then. */
export function inWorker(worker: Worker, canvas: HTMLCanvasElement, look: Look, events: SceneEvents, unavailable: () => void): Backstage {
  const waiting = new Map<number, { resolve(picture: Blob): void; reject(reason: Error): void }>();
  let pictures = 0;
  const send = (order: Order, transfer: Transferable[] = []): void => worker.postMessage(order, transfer);
  /** Nobody is left to draw what was asked for. */
  const giveUp = (): void => {
    for (const { reject } of waiting.values()) reject(undrawn());
    waiting.clear();
  };
  const fail = (): void => {
    clearTimeout(silence);
    giveUp();
    unavailable();
  };
  // Where workers are forbidden, not every browser says so.
  const silence = setTimeout(fail, SILENCE_MS);
  worker.onmessage = ({ data }: MessageEvent<Report>) => {
    clearTimeout(silence);
    if ("event" in data) {
      (events[data.event] as (given: unknown) => void)(data.given[0]);
    } else if ("unavailable" in data) {
      fail();
    } else if ("picture" in data) {
      const { resolve, reject } = waiting.get(data.picture) ?? {};
      waiting.delete(data.picture);
      if (data.blob) resolve?.(data.blob);
      else reject?.(undrawn());
    }
  };
  worker.onerror = fail;
  const offscreen = canvas.transferControlToOffscreen();
  send({ open: offscreen, look }, [offscreen]);
  return {
    act: (act, ...given) => send({ act, given } as ActOrder),
    picture: (...of) =>
      new Promise((resolve, reject) => {
        waiting.set(++pictures, { resolve, reject });
        send({ picture: pictures, of });
      }),
    dispose: () => {
      clearTimeout(silence);
      worker.terminate();
      giveUp();
    },
  };
}

const undrawn = (): Error => new Error("the picture could not be drawn");
