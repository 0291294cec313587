/** The worker that a scene can be in. */

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
    });
  } catch (error) {
    console.warn(error);
    tell({ unavailable: true });
  }
}

onmessage = ({ data }: MessageEvent<Order>) => {
  if ("open" in data) {
    open(data.open, data.look);
  } else if ("picture" in data) {
    const { picture, widthPx, heightPx } = data;
    const drawn = scene ? scene.picture(widthPx, heightPx) : Promise.reject(new Error("there is no scene"));
    drawn.then(
      (blob) => tell({ picture, blob }),
      () => tell({ picture, blob: null }),
    );
  } else if (scene) {
    perform(scene, data);
  }
};
