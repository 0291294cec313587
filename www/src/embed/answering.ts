/** Answers the page that frames this one, and tells it what happens. */

import { NAME, readMessage, type Asked, type Message } from "./messages";
import type { Sculpture } from "./sculpture";

const EVENTS = ["load", "error", "view-change", "camera-change"] as const;

/** Hears only `other`, a window, while a page of `origin` is in it, and tells only that one. */
export function answering(sculpture: Sculpture, other: Window, origin: string): void {
  const tell = (what: object): void => other.postMessage({ from: NAME, ...what }, origin);
  addEventListener("message", (event) => {
    if (event.source !== other || event.origin !== origin) return;
    const message = readMessage(event.data);
    if (message) void reply(sculpture, message, tell);
  });
  for (const event of EVENTS) sculpture.addEventListener(event, ({ detail }: CustomEventInit) => tell({ event, detail: sent(detail) }));
}

async function reply(sculpture: Sculpture, { id, ...asked }: Message, tell: (what: object) => void): Promise<void> {
  let reply: object;
  try {
    reply = { answer: (await act(sculpture, asked)) ?? null };
  } catch (error) {
    reply = { problem: error instanceof Error ? error.message : "That cannot be done." };
  }
  if (id !== null) tell({ id, ...reply });
}

/** One picture after the other: each may take all the memory of a graphics card. */
let taking: Promise<unknown> = Promise.resolve();
let waiting = 0;
const MOST_WAITING = 4;

async function act(sculpture: Sculpture, asked: Asked): Promise<unknown> {
  switch (asked.call) {
    case "getState":
      return sculpture.getState();
    case "setState":
      return sculpture.setState(asked.state);
    case "flyTo":
      return sculpture.flyTo(asked.view);
    case "play":
      return sculpture.play();
    case "pause":
      return sculpture.pause();
    case "toBlob": {
      if (waiting >= MOST_WAITING) throw new Error("Pictures are being taken already; ask again when they are there.");
      waiting++;
      const picture = taking.then(() => sculpture.toBlob(asked.picture));
      taking = picture.catch(() => undefined).then(() => waiting--);
      return picture;
    }
  }
}

/** Of a detail, what another page can be sent. */
const sent = (detail: unknown): unknown => (detail === undefined || detail === null ? null : (JSON.parse(JSON.stringify(detail)) as unknown));
