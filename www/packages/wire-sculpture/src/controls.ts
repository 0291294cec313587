/** Mouse, touch and keys turned into turns, zooms and pans. */

import type { ViewName } from "./orbit";

export interface Holds {
  turn(azimuthRad: number, elevationRad: number): void;
  zoom(factor: number): void;
  /** By shares of the picture's half height. */
  pan(right: number, up: number): void;
  view(name: ViewName): void;
}

const RAD_PER_PX = 0.0075;
const KEY_RAD = 0.12;
const KEYS: Readonly<Record<string, (holds: Holds, shift: boolean) => void>> = {
  ArrowLeft: (holds, shift) => (shift ? holds.pan(0.1, 0) : holds.turn(-KEY_RAD, 0)),
  ArrowRight: (holds, shift) => (shift ? holds.pan(-0.1, 0) : holds.turn(KEY_RAD, 0)),
  ArrowUp: (holds, shift) => (shift ? holds.pan(0, -0.1) : holds.turn(0, KEY_RAD)),
  ArrowDown: (holds, shift) => (shift ? holds.pan(0, 0.1) : holds.turn(0, -KEY_RAD)),
  "+": (holds) => holds.zoom(1 / 1.15),
  "=": (holds) => holds.zoom(1 / 1.15),
  "-": (holds) => holds.zoom(1.15),
  "1": (holds) => holds.view("front"),
  "2": (holds) => holds.view("side"),
  "3": (holds) => holds.view("top"),
  f: (holds) => holds.view("room"),
  F: (holds) => holds.view("room"),
};

/** Starts listening; the result stops it. */
export function listen(canvas: HTMLCanvasElement, holds: Holds): () => void {
  const fingers = new Map<number, { x: number; y: number }>();
  const stop = new AbortController();
  const { signal } = stop;

  canvas.addEventListener(
    "pointerdown",
    (event) => {
      canvas.setPointerCapture(event.pointerId);
      fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    },
    { signal },
  );
  canvas.addEventListener(
    "pointermove",
    (event) => {
      const from = fingers.get(event.pointerId);
      if (!from) return;
      const moved = { x: event.clientX - from.x, y: event.clientY - from.y };
      const half = canvas.clientHeight / 2 || 1;
      const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
      if (other) {
        const before = Math.hypot(from.x - other.x, from.y - other.y);
        const after = Math.hypot(event.clientX - other.x, event.clientY - other.y);
        if (before > 10 && after > 10) holds.zoom(before / after);
        // Each finger carries half of the movement.
        holds.pan(-moved.x / half / 2, moved.y / half / 2);
      } else if (event.shiftKey || event.buttons === 2 || event.buttons === 4) {
        holds.pan(-moved.x / half, moved.y / half);
      } else {
        holds.turn(-moved.x * RAD_PER_PX, moved.y * RAD_PER_PX);
      }
      fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    },
    { signal },
  );
  const release = (event: PointerEvent): void => void fingers.delete(event.pointerId);
  canvas.addEventListener("pointerup", release, { signal });
  canvas.addEventListener("pointercancel", release, { signal });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault(), { signal });
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      holds.zoom(Math.exp(Math.max(-80, Math.min(80, event.deltaY)) * 0.0022));
    },
    { signal, passive: false },
  );
  canvas.addEventListener(
    "keydown",
    (event) => {
      const action = event.ctrlKey || event.metaKey || event.altKey ? undefined : KEYS[event.key];
      if (!action) return;
      event.preventDefault();
      action(holds, event.shiftKey);
    },
    { signal },
  );
  return () => stop.abort();
}
