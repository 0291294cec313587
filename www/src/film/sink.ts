/** What takes the frames of a film, one after the other, and makes a file of them. */
export interface Sink {
  /** Sees a frame before the first one is added, to know what colours there are. */
  learn?(frame: OffscreenCanvas): void;
  /** Resolves when there is room for another one: so few are ever in memory. */
  add(frame: OffscreenCanvas, index: number): Promise<void>;
  finish(): Promise<Blob>;
  /** Gives up what it holds; the film is of no use then. */
  close(): void;
}
