/** Words of the guide. */

/** A view's name at the beginning of a line. */
export const said = (view: string): string => view.charAt(0).toUpperCase() + view.slice(1);

export function sizeOf(bytes: number): string {
  return bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : bytes < 1e9 ? `${(bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0)} MB` : `${(bytes / 1e9).toFixed(1)} GB`;
}
