/** How the element looks. A sheet made by script: a page that allows no inline styles allows this one. */

import { tintDeclarations } from "../scene/tints";

const STYLE = `
:host {
  ${tintDeclarations()}
  --_background: var(--wire-background, transparent);
  --_ink: var(--wire-ink, light-dark(#1d1b19, #ece7df));
  --_quiet: var(--wire-quiet, light-dark(#655e55, #a79f93));
  --_line: var(--wire-line, light-dark(#d9d3c9, #34312d));
  --_raised: var(--wire-raised, light-dark(#fffdf9, #201e1b));
  --_accent: var(--wire-accent, light-dark(#b87333, #d98f52));
  --_accent-text: var(--wire-accent-text, light-dark(#8a4f1c, #e3a26c));
  --_accent-wash: var(--wire-accent-wash, light-dark(#f3e6d8, #35281c));
  --_elevation: var(--wire-elevation, 0 1px 2px light-dark(#3c2d1914, #0006), 0 6px 20px light-dark(#3c2d1912, #0000004d));
  position: relative;
  display: block;
  box-sizing: border-box;
  min-width: 0;
  overflow: hidden;
  aspect-ratio: 4 / 3;
  container-type: inline-size;
  background: var(--_background);
  color: var(--_ink);
  font: 15px/1.45 system-ui, sans-serif;
}
:host([shadow]) { --_background: var(--wire-background, var(--_wall)); }
@media (forced-colors: active) {
  :host {
    --_background: Canvas; --_ink: CanvasText; --_quiet: CanvasText; --_line: CanvasText; --_raised: Canvas;
    --_accent: Highlight; --_accent-text: CanvasText; --_accent-wash: Canvas; --_wall: Canvas;
  }
}
:host([hidden]), [hidden] { display: none !important; }
*, ::before, ::after { box-sizing: border-box; }
button, select, input { font: inherit; color: inherit; }
:focus-visible { outline: 2px solid var(--_accent); outline-offset: 2px; }
.icon { flex: none; width: 20px; height: 20px; fill: none; stroke: currentColor; stroke-width: 1.8; stroke-linecap: round; stroke-linejoin: round; }
.unseen { position: absolute; width: 1px; height: 1px; margin: 0; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
.frame { position: absolute; inset: 0; display: flex; flex-direction: column; }
.view { position: relative; flex: 1; min-height: 0; }
.view > :is(canvas, img, svg, slot) { position: absolute; inset: 0; display: block; width: 100%; height: 100%; }
.view > canvas {
  mask-image: linear-gradient(to right, #0000, #000 6%, #000 94%, #0000), linear-gradient(#0000, #000 6%, #000 94%, #0000);
  mask-composite: intersect;
}
.live.held { cursor: grab; }
.live.held:active { cursor: grabbing; }
.poster { object-fit: contain; }
.flat { padding: 5% 5% 80px; color: var(--_copper); }
.view > .away { visibility: hidden; opacity: 0; }
.poster { transition: opacity 250ms ease, visibility 250ms; }
/* The mask would take the ring as well. */
canvas:focus-visible { outline: none; }
.ring { display: none; position: absolute; inset: 4px; border: 2px solid var(--_accent); border-radius: 6px; pointer-events: none; }
.view:has(canvas:focus-visible) ~ .ring { display: block; }
.bar { position: relative; display: flex; flex: none; flex-wrap: wrap; align-items: center; justify-content: center; gap: 8px; padding: 4px 8px 16px; }
.bar:empty { display: none; }
.group { display: flex; flex: none; padding: 3px; border: 1px solid var(--_line); border-radius: 9px; background: var(--_raised); box-shadow: var(--_elevation); }
.group button {
  display: inline-flex; align-items: center; justify-content: center; min-width: 0; min-height: 32px; padding: 0 12px;
  border: 1px solid transparent; border-radius: 6px; background: none; font-size: 13px; cursor: pointer; transition: background-color 150ms ease;
}
.group button.square { flex: none; width: 32px; padding: 0; }
.group button:hover { background: color-mix(in srgb, var(--_ink) 7%, transparent); }
.views { max-width: 100%; }
.views button { min-width: 56px; }
.group button[aria-pressed="true"] { background: var(--_accent-wash); color: var(--_accent-text); font-weight: 600; }
.more { display: flex; gap: 8px; }
.group select { min-height: 32px; padding: 0 4px 0 8px; border: 0; border-radius: 6px; background: var(--_raised); font-size: 13px; cursor: pointer; }
.group input { width: 120px; min-width: 0; margin: 0 8px 0 4px; accent-color: var(--_accent); }
.toggle { display: none; }
@media (pointer: coarse) {
  .bar { padding-bottom: 8px; }
  .group :is(button, select, input) { min-height: 44px; }
  .group button.square { width: 44px; }
}
@container (max-width: 660px) {
  .views.many button { min-width: 0; padding: 0 6px; }
  .bar:has(.toggle) { flex-wrap: nowrap; }
  .toggle { display: flex; }
  .more { position: absolute; bottom: 100%; left: 0; right: 0; justify-content: center; padding: 0 8px; }
  .more .group:last-child { flex: 0 1 auto; min-width: 0; }
  .more select { min-width: 0; text-overflow: ellipsis; }
  .more:not(.open) { display: none; }
}
@container (max-width: 400px) {
  .more .group button.square { width: 38px; }
}
@container (max-width: 330px) {
  .views button { min-width: 0; padding: 0 6px; }
}
@media (forced-colors: active) {
  .group button[aria-pressed="true"] { forced-color-adjust: none; background: Highlight; color: HighlightText; }
}
.prompt {
  position: absolute; bottom: 8px; left: 50%; translate: -50%; padding: 4px 12px; border: 1px solid var(--_line); border-radius: 99px;
  background: var(--_raised); color: var(--_quiet); font-size: 13px; white-space: nowrap; pointer-events: none; transition: opacity 250ms ease;
}
.reveal { position: absolute; inset: 0; display: grid; place-content: end center; padding: 16px; border: 0; background: none; cursor: pointer; }
.reveal span { padding: 8px 16px; border: 1px solid var(--_line); border-radius: 99px; background: var(--_raised); box-shadow: var(--_elevation); font-size: 13px; }
.message { position: absolute; inset: 0; display: grid; place-content: center; margin: 0; padding: 24px; color: var(--_quiet); text-align: center; text-wrap: balance; }
.message span { max-width: 40ch; padding: 4px 12px; border-radius: 6px; background: color-mix(in srgb, var(--_raised) 88%, transparent); }
.message.low { place-content: end center; padding: 8px; font-size: 13px; pointer-events: none; }
@media (prefers-reduced-motion: reduce) {
  * { transition: none !important; }
}
`;

let sheet: CSSStyleSheet | undefined;

/** One for all. */
export function styleSheet(): CSSStyleSheet {
  if (!sheet) (sheet = new CSSStyleSheet()).replaceSync(STYLE);
  return sheet;
}
