/** Opens the dialog of pictures and films. */

import type { BodyShape } from "#sculpture/scene/body";
import type { SculptureState } from "#sculpture/element/element";
import type { LookName } from "#sculpture/scene/looks";
import type { Pose, ViewName } from "#sculpture/scene/orbit";
import type { Made } from "../../state/keeping/document";
import type { StageWords } from "../shared/page-task";
import { FilmDialog } from "./film-dialog";
import { wayOf } from "./wires";

export interface FilmWishes {
  readonly made: Made;
  readonly body: BodyShape | null;
  readonly through: boolean;
  readonly look: LookName;
  readonly room: boolean;
  readonly dark: boolean;
  readonly views: StageWords["views"];
  /** Of the stage. */
  readonly seen: Pick<SculptureState, "view" | "camera">;
  /** Takes a file and the end of its name, and answers with the whole name. */
  readonly save: (made: Blob, ending: string) => string;
  /** Puts the wire into a PNG picture of it. */
  readonly carrying: (picture: Blob) => Promise<Blob>;
}

export async function openFilms({ made, views, save, carrying, seen, ...scenery }: FilmWishes): Promise<void> {
  const dialog = document.body.appendChild(new FilmDialog());
  const names = Object.keys(views) as ViewName[];
  dialog.scenery = { ...scenery, wire: made.finished.wire, way: wayOf(made), views: names, view: names.find((name) => name === seen.view) ?? null, pose: poseOf(seen.camera) };
  Object.assign(dialog, { save, carrying });
  await dialog.updateComplete;
  dialog.show();
}

function poseOf(camera: SculptureState["camera"]): Pose | null {
  if (!camera) return null;
  const radians = (degrees: number): number => (degrees * Math.PI) / 180;
  const { azimuth, elevation, lens, reach, target } = camera;
  return { azimuthRad: radians(azimuth), elevationRad: radians(elevation), fovYRad: radians(lens), reach, target };
}
