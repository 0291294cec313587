/** Attributes that are properties as well. */

const FLAGS = ["camera-controls", "controls", "auto-rotate", "shadow", "replay"] as const;
/** With what they are where they are not given. */
const TEXTS = {
  src: null,
  code: null,
  alt: null,
  poster: null,
  loading: "auto",
  reveal: "auto",
  "camera-orbit": null,
  "touch-action": "pan-y",
  "interaction-prompt": "auto",
  views: null,
  look: "copper",
  color: null,
  "width-scale": "1",
  labels: null,
} as const;

export const ATTRIBUTES: readonly string[] = [...FLAGS, ...Object.keys(TEXTS), "view"];

const camel = (name: string): string => name.replace(/-./g, (dash) => dash[1]!.toUpperCase());

/** Gives a class a property for every attribute but `view`, which a person changes as well. */
export function reflect(prototype: HTMLElement): void {
  for (const name of FLAGS) {
    Object.defineProperty(prototype, camel(name), {
      get(this: HTMLElement) {
        return this.hasAttribute(name);
      },
      set(this: HTMLElement, on: unknown) {
        this.toggleAttribute(name, !!on);
      },
    });
  }
  for (const [name, otherwise] of Object.entries(TEXTS)) {
    const number = name === "width-scale";
    Object.defineProperty(prototype, camel(name), {
      get(this: HTMLElement) {
        const text = this.getAttribute(name) ?? otherwise;
        return number ? widthScale(text) : text;
      },
      set(this: HTMLElement, value: unknown) {
        if (value === null || value === undefined) this.removeAttribute(name);
        else this.setAttribute(name, typeof value === "object" ? JSON.stringify(value) : String(value));
      },
    });
  }
}

/** A factor that leaves something to see. */
function widthScale(text: string | null): number {
  const scale = Number(text);
  return scale > 0 && scale < Infinity ? Math.max(0.05, Math.min(20, scale)) : 1;
}

/** What a page has set on an element before it was one of ours. */
export function takeOver(element: HTMLElement): void {
  for (const name of Object.keys(element)) {
    if (!hasSetter(Object.getPrototypeOf(element), name)) continue;
    const given: unknown = Reflect.get(element, name);
    Reflect.deleteProperty(element, name);
    Reflect.set(element, name, given);
  }
}

function hasSetter(prototype: object | null, name: string): boolean {
  for (let each = prototype; each; each = Object.getPrototypeOf(each) as object | null) {
    if (Object.hasOwn(each, name)) return !!Object.getOwnPropertyDescriptor(each, name)!.set;
  }
  return false;
}
