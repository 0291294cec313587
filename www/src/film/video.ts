/** Frames into a video: the browser's encoder, and a muxer around what it gives. */

import { BufferTarget, EncodedPacket, EncodedVideoPacketSource, Mp4OutputFormat, Output, WebMOutputFormat } from "mediabunny";
import type { Size } from "#sculpture/film/darkroom";
import { encoderConfig, VIDEO_FPS, type Choice } from "./formats";
import type { Sink } from "./sink";

/** Frames that may wait for the encoder. */
const WAITING = 3;
const ASK_AGAIN_MS = 50;
const KEY_EVERY_S = 2;

/** The muxer's word for a codec. */
const muxed = (codec: string): "avc" | "vp9" | "av1" | "vp8" => (codec.startsWith("avc") ? "avc" : codec.startsWith("vp09") ? "vp9" : codec.startsWith("av01") ? "av1" : "vp8");

export async function openVideo(choice: Choice, size: Size): Promise<Sink> {
  const target = new BufferTarget();
  const mp4 = choice.format === "mp4";
  const output = new Output({ format: mp4 ? new Mp4OutputFormat() : new WebMOutputFormat(), target });
  const source = new EncodedVideoPacketSource(muxed(choice.codec));
  output.addVideoTrack(source, { frameRate: VIDEO_FPS });
  await output.start();

  let failure: unknown = null;
  let written = Promise.resolve();
  const fail = (error: unknown): void => void (failure ??= error);
  const encoder = new VideoEncoder({
    output: (chunk, meta) => (written = written.then(() => source.add(EncodedPacket.fromEncodedChunk(chunk), meta)).catch(fail)),
    error: fail,
  });
  encoder.configure(encoderConfig(choice, size));
  const check = (): void => {
    if (failure) throw failure;
  };

  return {
    async add(canvas, index) {
      check();
      const frame = new VideoFrame(canvas, { timestamp: Math.round((1e6 * index) / VIDEO_FPS), duration: Math.round(1e6 / VIDEO_FPS), alpha: "discard" });
      encoder.encode(frame, { keyFrame: index % (KEY_EVERY_S * VIDEO_FPS) === 0 });
      frame.close();
      while (encoder.encodeQueueSize >= WAITING && !failure) {
        await new Promise((resolve) => {
          encoder.addEventListener("dequeue", resolve, { once: true });
          // Not every browser tells.
          setTimeout(resolve, ASK_AGAIN_MS);
        });
      }
      check();
    },
    async finish() {
      await encoder.flush();
      await written;
      check();
      await output.finalize();
      encoder.close();
      return new Blob([target.buffer!], { type: mp4 ? "video/mp4" : "video/webm" });
    },
    close() {
      if (encoder.state !== "closed") encoder.close();
      if (output.state === "started") void output.cancel();
    },
  };
}
