/** What a person drops, pastes or chooses, sorted by what can be done with it. */

import { msg, str } from "@lit/localize";

const MOST_WIRE_BYTES = 50_000_000;

export interface Sorted {
  readonly pictures: readonly File[];
  readonly wire: File | null;
  /** At most one. */
  readonly meshes: readonly File[];
  /** What was left aside and why, in a sentence, or empty. */
  readonly note: string;
}

/** What meshes come in; the last few only to hear from the core what would do instead. */
const MESH = /\.(obj|stl|ply|3mf|glb|gltf|3ds|amf|blend|dae|drc|fbx|iges|igs|off|step|stp|usdz|wrl|x3d)$/i;
const isPicture = (file: File): boolean => file.type.startsWith("image/");

/**
 * At most `room` pictures are taken, one mesh, and a wire only if there is nothing else. `folders` names what is no file
 * at all. Where meshes are `wanted`, what is no picture is taken for one.
 */
export function sortFiles(files: readonly File[], folders: readonly string[], room: number, wanted = false): Sorted {
  const isWire = (file: File): boolean => /\.json$/i.test(file.name) && file.size <= MOST_WIRE_BYTES;
  const isMoving = (file: File): boolean => /^(video|audio)\//.test(file.type);
  const wires = files.filter(isWire);
  const moving = files.filter(isMoving);
  const rest = files.filter((file) => !isWire(file) && !isMoving(file) && !folders.includes(file.name));
  const isMesh = (file: File): boolean => MESH.test(file.name) || (wanted && !isPicture(file));
  const meshes = rest.filter(isMesh);
  const pictures = rest.filter((file) => !isMesh(file));
  const notes: string[] = [];
  if (folders.length) notes.push(msg(str`${folders[0]!} is a folder; open it and drop the pictures in it.`));
  if (moving.length) notes.push(msg(str`${moving[0]!.name} is a film or sound; take a still picture of it.`));
  if (pictures.length > room) {
    const all = pictures.length;
    notes.push(room === 1 ? msg(str`One picture at a time: the first of ${all} files was taken.`) : room === 3 ? msg(str`There are three pads; the first three of ${all} files were taken.`) : msg(str`There are three pads; the first ${room} of ${all} files were taken.`));
  }
  if (meshes.length > 1) notes.push(msg(str`One mesh at a time: ${meshes[0]!.name} was taken.`));
  if (wires.length > 1) notes.push(msg(str`One wire at a time: ${wires[0]!.name} was opened.`));
  return { pictures: pictures.slice(0, room), wire: wires[0] ?? null, meshes: meshes.slice(0, 1), note: notes.join(" ") };
}
