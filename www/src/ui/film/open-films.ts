/** Opens the dialog of pictures and films. */

import type { BodyShape } from "#sculpture/body";
import type { LookName } from "#sculpture/looks";
import type { ViewName } from "#sculpture/orbit";
import type { Made } from "../../state/keeping/document";
import type { StageWords } from "../shared/page-task";
import { FilmDialog } from "./film-dialog";

export interface FilmWishes {
  readonly made: Made;
  readonly body: BodyShape | null;
  readonly through: boolean;
  readonly look: LookName;
  readonly room: boolean;
  readonly dark: boolean;
  readonly views: StageWords["views"];
  /** Takes a file and the end of its name, and answers with the whole name. */
  readonly save: (made: Blob, ending: string) => string;
  /** Puts the wire into a PNG picture of it. */
  readonly carrying: (picture: Blob) => Promise<Blob>;
}

export async function openFilms({ made, views, save, carrying, ...seen }: FilmWishes): Promise<void> {
  const dialog = document.body.appendChild(new FilmDialog());
  const way = made.track?.loose ? [] : (made.track?.snapshots.map(({ wire }) => wire) ?? []);
  dialog.scenery = { ...seen, wire: made.finished.wire, way, views: Object.keys(views) as ViewName[], pose: null };
  Object.assign(dialog, { save, carrying });
  await dialog.updateComplete;
  dialog.show();
}
