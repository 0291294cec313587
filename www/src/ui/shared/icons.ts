/** The page's icons: from Lucide (ISC), imported one by one, so that only those named here are in the page. */

import { html, type TemplateResult } from "lit";
import { unsafeSVG } from "lit/directives/unsafe-svg.js";
import aperture from "lucide-static/icons/aperture.svg?raw";
import leftRight from "lucide-static/icons/arrow-left-right.svg?raw";
import brush from "lucide-static/icons/brush.svg?raw";
import camera from "lucide-static/icons/camera.svg?raw";
import check from "lucide-static/icons/check.svg?raw";
import chevronDown from "lucide-static/icons/chevron-down.svg?raw";
import question from "lucide-static/icons/circle-question-mark.svg?raw";
import dices from "lucide-static/icons/dices.svg?raw";
import download from "lucide-static/icons/download.svg?raw";
import braces from "lucide-static/icons/file-braces.svg?raw";
import hammer from "lucide-static/icons/hammer.svg?raw";
import hand from "lucide-static/icons/hand.svg?raw";
import image from "lucide-static/icons/image.svg?raw";
import images from "lucide-static/icons/images.svg?raw";
import language from "lucide-static/icons/languages.svg?raw";
import link from "lucide-static/icons/link.svg?raw";
import monitor from "lucide-static/icons/monitor.svg?raw";
import moon from "lucide-static/icons/moon.svg?raw";
import pause from "lucide-static/icons/pause.svg?raw";
import pencil from "lucide-static/icons/pencil.svg?raw";
import play from "lucide-static/icons/play.svg?raw";
import redo from "lucide-static/icons/redo-2.svg?raw";
import again from "lucide-static/icons/rotate-ccw.svg?raw";
import share from "lucide-static/icons/share-2.svg?raw";
import forward from "lucide-static/icons/skip-forward.svg?raw";
import sliders from "lucide-static/icons/sliders-horizontal.svg?raw";
import square from "lucide-static/icons/square.svg?raw";
import stepForward from "lucide-static/icons/step-forward.svg?raw";
import sun from "lucide-static/icons/sun.svg?raw";
import triangle from "lucide-static/icons/triangle-alert.svg?raw";
import undo from "lucide-static/icons/undo-2.svg?raw";
import x from "lucide-static/icons/x.svg?raw";
import contrast from "lucide-static/icons/contrast.svg?raw";
import ellipsis from "lucide-static/icons/ellipsis.svg?raw";
import eraser from "lucide-static/icons/eraser.svg?raw";
import flip from "lucide-static/icons/flip-vertical-2.svg?raw";
import turnCcw from "lucide-static/icons/rotate-ccw-square.svg?raw";
import turnCw from "lucide-static/icons/rotate-cw-square.svg?raw";
import glass from "lucide-static/icons/scan-search.svg?raw";
import search from "lucide-static/icons/search.svg?raw";
import shapes from "lucide-static/icons/shapes.svg?raw";
import trash from "lucide-static/icons/trash-2.svg?raw";
import letters from "lucide-static/icons/type.svg?raw";
import wand from "lucide-static/icons/wand-sparkles.svg?raw";
import spline from "lucide-static/icons/spline.svg?raw";
import book from "lucide-static/icons/book-open.svg?raw";
import folder from "lucide-static/icons/folder-open.svg?raw";

/** Only the shapes of a file go into the page: size and colour are those of `svg.icon` in shared.ts. */
function icon(file: string): TemplateResult {
  const shapes = file.slice(file.indexOf(">", file.indexOf("<svg")) + 1, file.lastIndexOf("</svg>")).replace(/\s+/g, " ");
  return html`<svg class="icon" viewBox="0 0 24 24" aria-hidden="true">${unsafeSVG(shapes)}</svg>`;
}

export const icons = {
  run: icon(play),
  pause: icon(pause),
  step: icon(stepForward),
  stop: icon(square),
  reset: icon(again),
  newest: icon(forward),
  undo: icon(undo),
  redo: icon(redo),
  share: icon(share),
  link: icon(link),
  download: icon(download),
  file: icon(braces),
  brush: icon(brush),
  camera: icon(camera),
  picture: icon(image),
  pictures: icon(images),
  pencil: icon(pencil),
  swap: icon(leftRight),
  settings: icon(sliders),
  dice: icon(dices),
  check: icon(check),
  more: icon(chevronDown),
  close: icon(x),
  aperture: icon(aperture),
  build: icon(hammer),
  help: icon(question),
  language: icon(language),
  light: icon(sun),
  dark: icon(moon),
  system: icon(monitor),
  warning: icon(triangle),
  invert: icon(contrast),
  ellipsis: icon(ellipsis),
  eraser: icon(eraser),
  mirror: icon(flip),
  turnLeft: icon(turnCcw),
  turnRight: icon(turnCw),
  glass: icon(glass),
  hand: icon(hand),
  search: icon(search),
  shapes: icon(shapes),
  clear: icon(trash),
  type: icon(letters),
  arrange: icon(wand),
  bend: icon(spline),
  open: icon(folder),
  lesson: icon(book),
};
