/**
 * A picture drawn aside, smooth-edged, and shown when the graphics card has finished it: a browser that has to wait for
 * a slow card would keep the whole page waiting.
 */

const SAMPLES = 4;

export class Easel {
  private readonly drawn: WebGLFramebuffer;
  private readonly resolved: WebGLFramebuffer;
  private readonly buffers: readonly { readonly buffer: WebGLRenderbuffer; readonly format: GLenum; readonly samples: number }[];
  private readonly samples: number;
  private width = 0;
  private height = 0;
  private fence: WebGLSync | null = null;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.samples = Math.min(SAMPLES, gl.getParameter(gl.MAX_SAMPLES) as number);
    const buffer = (framebuffer: WebGLFramebuffer, attachment: GLenum, format: GLenum, samples: number) => {
      const buffer = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
      return { buffer, format, samples };
    };
    this.drawn = gl.createFramebuffer();
    this.resolved = gl.createFramebuffer();
    this.buffers = [
      buffer(this.drawn, gl.COLOR_ATTACHMENT0, gl.RGBA8, this.samples),
      buffer(this.drawn, gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24, this.samples),
      buffer(this.resolved, gl.COLOR_ATTACHMENT0, gl.RGBA8, 0),
    ];
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** Runs `paint` with the easel as what is drawn on. */
  draw(width: number, height: number, paint: () => void): void {
    const { gl } = this;
    if (width !== this.width || height !== this.height) {
      for (const { buffer, format, samples } of this.buffers) {
        gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
        gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
      }
      [this.width, this.height] = [width, height];
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.drawn);
    paint();
    this.copy(this.drawn, this.resolved);
    if (this.fence) gl.deleteSync(this.fence);
    this.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  /** Whether there is a picture that has not been shown. */
  get busy(): boolean {
    return this.fence !== null;
  }

  /** Whether showing it keeps nobody waiting. */
  get ready(): boolean {
    return !!this.fence && this.gl.getSyncParameter(this.fence, this.gl.SYNC_STATUS) === this.gl.SIGNALED;
  }

  show(): void {
    const { gl, width, height } = this;
    const { canvas } = gl;
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    // Browsers empty what they have shown before the next drawing, wherever that goes: without this, it might be after the copy.
    gl.clear(gl.COLOR_BUFFER_BIT);
    this.copy(this.resolved, null);
    gl.deleteSync(this.fence);
    this.fence = null;
  }

  private copy(from: WebGLFramebuffer, to: WebGLFramebuffer | null): void {
    const { gl, width, height } = this;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }
}
