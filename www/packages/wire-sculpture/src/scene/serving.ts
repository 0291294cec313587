/** What a worker does that a scene is in. */

import { perform, type Order, type Report } from "./backstage";
import { Scene } from "./scene";

let scene: Scene | null = null;

function tell(report: Report): void {
  postMessage(report);
}

function open(canvas: OffscreenCanvas, look: ConstructorParameters<typeof Scene>[1]): void {
  try {
    scene = new Scene(canvas, look, {
      view: (name) => tell({ event: "view", given: [name] }),
      lost: (lost) => tell({ event: "lost", given: [lost] }),
      camera: (pose) => tell({ event: "camera", given: [pose] }),
      drawn: () => tell({ event: "drawn", given: [] }),
    });
  } catch (error) {
    console.warn(error);
    tell({ unavailable: true });
  }
}

/** To be called once, in the worker. */
export function serve(): void {
  onmessage = hear;
  tell({ ready: true });
}

function hear({ data }: MessageEvent<Order>): void {
  if ("open" in data) {
    open(data.open, data.look);
  } else if ("picture" in data) {
    const { picture, of } = data;
    const drawn = scene ? scene.picture(...of) : Promise.reject(new Error("there is no scene"));
    drawn.then(
      (blob) => tell({ picture, blob }),
      () => tell({ picture, blob: null }),
    );
  } else if (scene) {
    perform(scene, data);
  }
}
