import type { Studio } from "../../state/studio";
export function openWall(_studio: Studio): void {}
