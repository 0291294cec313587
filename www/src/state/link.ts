/** The address's fragment: `#w=CODE` carries a whole wire. Nothing in it is sent to any server. */

export function codeFrom(hash: string): string | null {
  return new URLSearchParams(hash.replace(/^#/, "")).get("w");
}

export function linkTo(code: string, page: string): string {
  return `${page.replace(/#.*$/, "")}#w=${code}`;
}
