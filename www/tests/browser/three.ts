/** Saved solids as three.js reads them: somebody else's loaders. */

import { Box3, Mesh, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";

export interface Solid {
  readonly triangles: number;
  /** Along x, y and z. */
  readonly extents: readonly [number, number, number];
}

const contents = (bytes: Buffer): ArrayBuffer => new Uint8Array(bytes).buffer;

const extentsOf = (box: Box3): Solid["extents"] => box.getSize(new Vector3()).toArray();

export async function solidOfGlb(bytes: Buffer): Promise<Solid> {
  const { scene } = await new GLTFLoader().parseAsync(contents(bytes), "");
  let triangles = 0;
  scene.traverse((object) => {
    if (object instanceof Mesh) triangles += (object.geometry.index ?? object.geometry.attributes["position"]).count / 3;
  });
  return { triangles, extents: extentsOf(new Box3().setFromObject(scene)) };
}

export function solidOfStl(bytes: Buffer): Solid {
  const geometry = new STLLoader().parse(contents(bytes));
  geometry.computeBoundingBox();
  return { triangles: geometry.getAttribute("position").count / 3, extents: extentsOf(geometry.boundingBox!) };
}
