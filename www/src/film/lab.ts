/** Where pictures and films are made: answers orders. */

import { Darkroom, type Size, type Subject } from "#sculpture/film/darkroom";
import { momentsOf } from "#sculpture/film/film";
import { fpsOf } from "./formats";
import { FILMS, secondsOf, type FilmOrder, type Order, type Preview, type Progress, type StillOrder, type Told } from "./orders";
import type { Sink } from "./sink";

/** Frames that are looked at for a GIF's colours, shares of the film. */
const TELLING = [0.02, 0.35, 0.7, 0.98];

export class Lab {
  private subject: Subject | null = null;
  /** For previews, which come one after the other. */
  private room: Darkroom | null = null;

  constructor(private readonly tell: (told: Told, transfer: Transferable[]) => void) {}

  async hear(order: Order): Promise<void> {
    if ("subject" in order) {
      this.subject = order.subject;
      this.room?.dispose();
      this.room = null;
      return;
    }
    const { id } = order;
    try {
      if (order.make === "preview") {
        const bitmap = this.preview(order);
        this.tell({ id, bitmap }, [bitmap]);
      } else {
        const blob = order.make === "still" ? await this.still(order) : await this.film(order, (progress) => this.tell({ id, progress }, []));
        this.tell({ id, blob }, []);
      }
    } catch (error) {
      console.warn(error);
      this.tell({ id, problem: error instanceof Error ? error.message : String(error) }, []);
    }
  }

  private open(size: Size): Darkroom {
    if (!this.subject) throw new Error("there is no wire");
    return new Darkroom(this.subject, size);
  }

  private preview({ of }: Preview): ImageBitmap {
    this.room ??= this.open(of.size);
    if ("film" in of) this.room.frame(FILMS[of.film], FILMS[of.film].at(of.share), of.size);
    else this.room.draw(of.from, of.size, of.ground);
    return this.room.canvas.transferToImageBitmap();
  }

  private async still({ from, size, ground }: StillOrder): Promise<Blob> {
    const room = this.open(size);
    try {
      return await room.picture(from, size, ground);
    } finally {
      room.dispose();
    }
  }

  private async film({ film, size, choice, frames = Math.round(secondsOf(film) * fpsOf(choice)) }: FilmOrder, tell: (progress: Progress) => void): Promise<Blob> {
    const room = this.open(size);
    let sink: Sink | null = null;
    try {
      sink = choice.format === "gif" ? (await import("./gif")).openGif(size) : await (await import("./video")).openVideo(choice, size);
      if (sink.learn) {
        for (const share of TELLING) {
          room.frame(FILMS[film], FILMS[film].at(share), size);
          sink.learn(room.canvas);
          await turn();
        }
      }
      const startMs = performance.now();
      let drawMs = 0;
      for (const [at, moment] of momentsOf(FILMS[film], frames).entries()) {
        const beganMs = performance.now();
        room.frame(FILMS[film], moment, size);
        room.develop();
        drawMs += performance.now() - beganMs;
        await sink.add(room.canvas, at);
        const takenMs = performance.now() - startMs;
        tell({ done: at + 1, frames, msLeft: (takenMs / (at + 1)) * (frames - at - 1), drawMs, encodeMs: takenMs - drawMs });
        await turn();
      }
      return await sink.finish();
    } finally {
      sink?.close();
      room.dispose();
    }
  }
}

/** Lets previews in between frames. */
const turn = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
