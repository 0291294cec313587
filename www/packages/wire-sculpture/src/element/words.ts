/** What the element says, in English; `labels` has other words for any of it. */

export const WORDS = {
  /** The name of what is shown, where no `alt` gives one. */
  sculpture: "The wire in 3D",
  room: "Room",
  front: "Front",
  side: "Side",
  right: "Right",
  back: "Back",
  left: "Left",
  top: "Top",
  seenRoom: "Seen as a whole.",
  seenFront: "Seen straight from the front.",
  seenSide: "Seen straight from the side.",
  seenRight: "Seen straight from the right.",
  seenBack: "Seen straight from behind.",
  seenLeft: "Seen straight from the left.",
  seenTop: "Seen straight from above.",
  turned: "Turned by hand.",
  open: "One wire with two ends.",
  closed: "One closed wire.",
  madeFor: "It was made to be seen from:",
  keys: "Arrow keys turn it, with shift they move it, plus and minus zoom, digits show its views, F the whole.",
  lookFrom: "Look from",
  turnAndZoom: "Turn and zoom",
  turnLeft: "Turn left",
  turnRight: "Turn right",
  zoomIn: "Zoom in",
  zoomOut: "Zoom out",
  look: "Look",
  lookOfWire: "Look of the wire",
  copper: "Copper",
  steel: "Black steel",
  parameter: "Along the wire",
  width: "By width",
  shadows: "Room with the shadows",
  farSide: "Lines on the far side",
  more: "Turn, zoom and look",
  prompt: "Drag to turn",
  reveal: "Show in 3D",
  howFound: "How it was found",
  play: "Play how it was found",
  pause: "Pause",
  lost: "The graphics card is busy elsewhere. The picture comes back by itself.",
  flat: "WebGL 2 is missing or switched off here, so this is a drawing of the wire.",
} as const satisfies Readonly<Record<string, string>>;

export type Words = Readonly<Record<keyof typeof WORDS, string>>;

/** `labels` as JSON, over the English; what is no text there is left out. */
export function wordsOf(labels: string | null): Words {
  let given: unknown = null;
  try {
    given = labels && JSON.parse(labels);
  } catch {
    console.warn("wire-sculpture: `labels` is no JSON; its words are left out");
  }
  if (!given || typeof given !== "object") return WORDS;
  return { ...WORDS, ...Object.fromEntries(Object.entries(given).filter(([, text]) => typeof text === "string")) };
}
