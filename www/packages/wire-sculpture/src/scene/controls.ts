/** Mouse, touch and keys turned into turns, zooms and pans. */

export interface Holds {
  turn(azimuthRad: number, elevationRad: number): void;
  zoom(factor: number): void;
  /** By shares of the picture's half height. */
  pan(right: number, up: number): void;
}

/** What of a person's doings is taken; read whenever they do something. */
export interface Grip {
  /** Whether the camera is held at all. */
  readonly turns: boolean;
  /** Whether the wheel zooms, and does not scroll the page. */
  readonly wheel: boolean;
  /** Keys of their own; whether that was one. */
  key(key: string): boolean;
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
};

/** Starts listening; the result stops it. */
export function listen(canvas: HTMLCanvasElement, holds: Holds, grip: Grip): () => void {
  const fingers = new Map<number, { x: number; y: number }>();
  const stop = new AbortController();
  const { signal } = stop;

  canvas.addEventListener(
    "pointerdown",
    (event) => {
      if (!grip.turns) return;
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
  canvas.addEventListener("contextmenu", (event) => grip.turns && event.preventDefault(), { signal });
  canvas.addEventListener(
    "wheel",
    (event) => {
      // Two fingers on a touch pad come as a wheel with ctrl.
      if (!grip.turns || !(grip.wheel || event.ctrlKey)) return;
      event.preventDefault();
      holds.zoom(Math.exp(Math.max(-80, Math.min(80, event.deltaY)) * 0.0022));
    },
    { signal, passive: false },
  );
  canvas.addEventListener(
    "keydown",
    (event) => {
      if (!grip.turns || event.ctrlKey || event.metaKey || event.altKey) return;
      const action = KEYS[event.key];
      if (!action && !grip.key(event.key)) return;
      event.preventDefault();
      action?.(holds, event.shiftKey);
    },
    { signal },
  );
  return () => stop.abort();
}
