/** Where the scene is: here, or in a worker, where a slow graphics card or none keeps the page from nothing. */

import type { Look } from "./looks";
import { Scene, type SceneEvents } from "./scene";

/** What the scene can be told without waiting for an answer. */
type Act = "setWire" | "mark" | "setBody" | "seeThrough" | "setLook" | "resize" | "keepStill" | "turn" | "zoom" | "pan" | "step" | "flyTo" | "tour" | "sway";
type ActOrder = { [K in Act]: { readonly act: K; readonly given: Parameters<Scene[K]> } }[Act];

/** To the worker: the first one opens the scene. */
export type Order =
  | { readonly open: OffscreenCanvas; readonly look: Look }
  | ActOrder
  | { readonly picture: number; readonly widthPx: number; readonly heightPx: number };

/** From the worker. */
export type Report =
  | { [K in keyof SceneEvents]: { readonly event: K; readonly given: Parameters<SceneEvents[K]> } }[keyof SceneEvents]
  | { readonly unavailable: true }
  | { readonly picture: number; readonly blob: Blob | null };

export interface Backstage {
  act<K extends Act>(act: K, ...given: Parameters<Scene[K]>): void;
  picture(widthPx: number, heightPx: number): Promise<Blob>;
  dispose(): void;
}

export function perform(scene: Scene, { act, given }: ActOrder): void {
  (scene[act] as (...given: unknown[]) => void)(...given);
}

/** @throws StageUnavailable where the browser has no WebGL 2. */
export function inPage(canvas: HTMLCanvasElement, look: Look, events: SceneEvents): Backstage {
  const scene = new Scene(canvas, look, events);
  return {
    act: (act, ...given) => perform(scene, { act, given } as ActOrder),
    picture: (widthPx, heightPx) => scene.picture(widthPx, heightPx),
    dispose: () => scene.dispose(),
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
    giveUp();
    unavailable();
  };
  worker.onmessage = ({ data }: MessageEvent<Report>) => {
    if ("event" in data) {
      (events[data.event] as (given: unknown) => void)(data.given[0]);
    } else if ("unavailable" in data) {
      fail();
    } else {
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
    picture: (widthPx, heightPx) =>
      new Promise((resolve, reject) => {
        waiting.set(++pictures, { resolve, reject });
        send({ picture: pictures, widthPx, heightPx });
      }),
    dispose: () => {
      worker.terminate();
      giveUp();
    },
  };
}

const undrawn = (): Error => new Error("the picture could not be drawn");
