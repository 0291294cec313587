/** Small choices kept in this browser; where that is blocked they last as long as the page. */

const here = new Map<string, string>();

export function remembered(name: string): string | null {
  try {
    return localStorage.getItem(`wire4d.${name}`) ?? here.get(name) ?? null;
  } catch {
    return here.get(name) ?? null;
  }
}

export function remember(name: string, value: string): void {
  here.set(name, value);
  try {
    localStorage.setItem(`wire4d.${name}`, value);
  } catch {
    // Blocked or full: `here` has it.
  }
}
