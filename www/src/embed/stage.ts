/**
 * A room with a wire in it: three walls, on each the shadow the wire casts along that axis, and a camera that people
 * hold. Draws only when something changed. Knows control points and knots and nothing of the rest of the page.
 */

import { listen } from "./controls";
import { linear, NumberTexture, Program, shown, SoftTexture } from "./gl";
import { orthographic, type Mat4, type Vec3 } from "./matrix";
import { axesOf, HOME, Orbit, VIEW_POSES, type Pose } from "./orbit";
import { RINGS_A_ROW, SHADOW_FRAGMENT, TUBE_FRAGMENT, TUBE_VERTEX, verticesAPiece, WALL_FRAGMENT, WALL_VERTEX } from "./shaders";
import { Sampler, type WireShape } from "./shape";
import { buildRings, RING_FLOATS } from "./tube";

export type ViewName = keyof typeof VIEW_POSES;

/** Colours as `#rrggbb`. */
export interface Look {
  wall: string;
  shadow: string;
  metal: string;
  /** Light from above and from below that the metal mirrors. */
  sky: string;
  ground: string;
  /** Colour along the wire in place of metal. */
  byParameter: boolean;
  /** Off: the wire alone. */
  room: boolean;
}

/** Sides of the tube as it is seen, and as it casts a shadow. */
const SIDES = 12;
const SHADOW_SIDES = 6;
/** About as many samples in all as a screen can tell apart. */
const SAMPLES = 2600;
const SHADOW_SIZE = 512;
/** World units from the middle to the border of a shadow; the object fits the unit ball. */
const SHADOW_EXTENT = 1.15;
const WALL_AWAY = 1.22;
const WALL_EXTENT = 2.6;
const FLIGHT_MS = 650;
/** Frames that take longer than this while things move are drawn coarser, down to this share of the pixels a side. */
const SLOW_FRAME_MS = 40;
const COARSEST = 0.4;
/** The idle camera moves so slowly that half of the frames do. */
const SWAY_FRAME_MS = 30;
/** How long everything stands still before the picture is drawn at its finest again. */
const REST_MS = 250;
/** Radians the idle camera sways either way, and seconds it takes. */
const SWAY_RAD = 0.3;
const SWAY_S = 26;

/** The axes of each wall: what is right, up and towards the room for somebody who looks at it. */
const WALLS: readonly { axes: readonly [Vec3, Vec3, Vec3]; brightness: number }[] = (
  [["front", 1], ["side", 0.985], ["top", 0.992]] as const
).map(([name, brightness]) => {
  const { right, up, back } = axesOf(VIEW_POSES[name]);
  return { axes: [right, up, back], brightness };
});

export class StageUnavailable extends Error {}

export class Stage {
  private readonly gl: WebGL2RenderingContext;
  private readonly orbit = new Orbit();
  private readonly observer: ResizeObserver;
  private readonly stopListening: () => void;
  private resources!: Resources;
  private look: Look;
  private wire: WireShape | null = null;
  private ringData: Float32Array<ArrayBuffer> | undefined;
  private readonly sampler = new Sampler(SAMPLES);
  private ringCount = 0;
  private wireStale = true;
  private frame = 0;
  private lastFrameMs = 0;
  /** Share of the canvas' pixels a side that are drawn: less than 1 only while a slow machine has to keep up. */
  private fineness = 1;
  /** Whether the next frame was wanted as soon as this one was drawn, so that the time between them says something. */
  private following = false;
  private rest: ReturnType<typeof setTimeout> | undefined;
  private swaying = false;
  private swayStartMs = 0;
  private swayFrom = HOME.azimuthRad;
  private readonly still = matchMedia("(prefers-reduced-motion: reduce)");

  /** @throws StageUnavailable where the browser has no WebGL 2. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    look: Look,
    /** Called when a person takes hold of the camera. */
    private readonly onHold: () => void = () => undefined,
  ) {
    const gl = canvas.getContext("webgl2", { antialias: true, alpha: true, premultipliedAlpha: true });
    if (!gl) throw new StageUnavailable("this browser cannot draw in 3D here (WebGL 2 is missing or switched off)");
    this.gl = gl;
    this.look = look;
    this.resources = new Resources(gl);
    this.observer = new ResizeObserver(() => this.invalidate());
    this.observer.observe(canvas);
    this.stopListening = listen(canvas, {
      turn: (azimuth, elevation) => this.held(() => this.orbit.turn(azimuth, elevation)),
      zoom: (factor) => this.held(() => this.orbit.zoom(factor)),
      pan: (right, up) => this.held(() => this.orbit.pan(right, up)),
      view: (name) => this.flyTo(name),
    });
    canvas.addEventListener("webglcontextlost", this.lost);
    canvas.addEventListener("webglcontextrestored", this.restored);
    this.invalidate();
  }

  setWire(wire: WireShape | null): void {
    this.following ||= performance.now() - this.lastFrameMs < REST_MS;
    this.wire = wire;
    this.wireStale = true;
    this.invalidate();
  }

  setLook(look: Look): void {
    this.look = look;
    this.invalidate();
  }

  /** A view straight on, or the room as a whole. */
  flyTo(view: ViewName | "room"): void {
    this.swaying = false;
    const pose: Pose = view === "room" ? HOME : VIEW_POSES[view];
    this.orbit.flyTo(pose, performance.now(), this.still.matches ? 0 : FLIGHT_MS);
    this.onHold();
    this.invalidate();
  }

  /** Whether the camera sways slowly by itself; never for people who asked for less motion. */
  sway(on: boolean): void {
    if (on === this.swaying || (on && this.still.matches)) return;
    this.swaying = on;
    this.swayStartMs = performance.now();
    this.swayFrom = this.orbit.pose.azimuthRad;
    this.invalidate();
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.rest);
    this.observer.disconnect();
    this.stopListening();
    this.canvas.removeEventListener("webglcontextlost", this.lost);
    this.canvas.removeEventListener("webglcontextrestored", this.restored);
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  private readonly lost = (event: Event): void => event.preventDefault();
  private readonly restored = (): void => {
    this.resources = new Resources(this.gl);
    this.wireStale = true;
    this.invalidate();
  };

  private held(action: () => void): void {
    this.swaying = false;
    action();
    this.onHold();
    this.invalidate();
  }

  private invalidate(): void {
    this.frame ||= requestAnimationFrame(this.draw);
  }

  private readonly draw = (nowMs: number): void => {
    this.frame = 0;
    if (this.gl.isContextLost()) return;
    const sinceMs = nowMs - this.lastFrameMs;
    const moving = this.wireStale || this.orbit.flying;
    if (this.swaying && !moving && sinceMs < SWAY_FRAME_MS) {
      this.invalidate();
      return;
    }
    this.lastFrameMs = nowMs;
    this.adapt(sinceMs);
    const flying = this.orbit.advance(nowMs);
    if (this.swaying) {
      const phase = ((nowMs - this.swayStartMs) / 1000 / SWAY_S) * 2 * Math.PI;
      this.orbit.pose.azimuthRad = this.swayFrom + SWAY_RAD * Math.sin(phase);
    }
    if (this.wireStale) this.uploadWire();
    this.wireStale = false;
    this.paint();
    this.following = flying || this.swaying;
    if (this.following) this.invalidate();
  };

  /** Coarser when frames that follow each other come slowly; fine again after a rest. */
  private adapt(sinceMs: number): void {
    if (sinceMs > SLOW_FRAME_MS && this.following) {
      // Where even that does not help, at least nothing moves by itself.
      if (this.fineness === COARSEST) this.swaying = false;
      this.fineness = Math.max(COARSEST, this.fineness * 0.8);
    }
    clearTimeout(this.rest);
    if (this.fineness < 1) {
      this.rest = setTimeout(() => {
        this.fineness = 1;
        this.invalidate();
      }, REST_MS);
    }
  }

  private uploadWire(): void {
    const { resources } = this;
    if (!this.wire) {
      this.ringCount = 0;
    } else {
      const samples = this.sampler.sample(this.wire);
      const rings = buildRings(samples, samples.parameters, this.ringData);
      this.ringCount = rings.count;
      const rows = Math.ceil(rings.count / RINGS_A_ROW);
      const floats = rows * RINGS_A_ROW * RING_FLOATS;
      this.ringData = rings.data.length >= floats ? rings.data : grown(rings.data, 2 * floats);
      resources.rings.write(this.ringData.subarray(0, floats), rows);
    }
    if (!this.look.room) return;
    WALLS.forEach(({ axes }, i) => {
      resources.shadows[i]!.draw(() => {
        const { shadowTube } = resources;
        shadowTube.use();
        const worldPerPixel = (2 * SHADOW_EXTENT) / SHADOW_SIZE;
        this.drawTube(shadowTube, orthographic(...axes, SHADOW_EXTENT), [0, 0, 0], worldPerPixel, false, SHADOW_SIDES);
      });
    });
  }

  private paint(): void {
    const { gl, canvas, resources, look } = this;
    const density = Math.min(2, devicePixelRatio || 1) * this.fineness;
    const width = Math.max(1, Math.round(canvas.clientWidth * density));
    const height = Math.max(1, Math.round(canvas.clientHeight * density));
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    const camera = this.orbit.camera(width, height);
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    if (look.room) this.paintWalls(camera.clipFromWorld);
    gl.enable(gl.DEPTH_TEST);
    const { tube } = resources;
    tube.use();
    gl.uniform3fv(tube.at("metal"), linear(look.metal));
    gl.uniform3fv(tube.at("sky"), linear(look.sky));
    gl.uniform3fv(tube.at("ground"), linear(look.ground));
    gl.uniform1f(tube.at("byParameter"), look.byParameter ? 1 : 0);
    this.drawTube(tube, camera.clipFromWorld, camera.eye, camera.worldPerPixel, true, SIDES);
    gl.disable(gl.DEPTH_TEST);
  }

  private paintWalls(clipFromWorld: Mat4): void {
    const { gl, look, resources } = this;
    const { wall } = resources;
    const { back } = axesOf(this.orbit.pose);
    wall.use();
    gl.uniformMatrix4fv(wall.at("clipFromWorld"), false, clipFromWorld);
    gl.uniform1f(wall.at("away"), WALL_AWAY);
    gl.uniform1f(wall.at("extent"), WALL_EXTENT);
    gl.uniform1f(wall.at("shadowExtent"), SHADOW_EXTENT);
    gl.uniform3fv(wall.at("wall"), shown(look.wall));
    gl.uniform3fv(wall.at("shade"), shown(look.shadow));
    gl.uniform1i(wall.at("shadow"), 0);
    gl.activeTexture(gl.TEXTURE0);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    WALLS.forEach(({ axes, brightness }, i) => {
      // A wall that turns its back or its edge to the eye fades away.
      const facing = back[0] * axes[2][0] + back[1] * axes[2][1] + back[2] * axes[2][2];
      const visible = Math.max(0, Math.min(1, (facing - 0.02) / 0.16));
      if (visible === 0) return;
      gl.uniform1f(wall.at("shown"), visible * visible * (3 - 2 * visible));
      gl.uniform1f(wall.at("brightness"), brightness);
      gl.uniformMatrix3fv(wall.at("axes"), false, axes.flat());
      gl.bindTexture(gl.TEXTURE_2D, resources.shadows[i]!.texture);
      gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    });
    gl.disable(gl.BLEND);
  }

  private drawTube(
    program: Program,
    clipFromWorld: Mat4,
    eye: Vec3,
    worldPerPixel: number,
    perspective: boolean,
    sides: number,
  ): void {
    const { gl } = this;
    if (this.ringCount < 2) return;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.resources.rings.texture);
    gl.uniform1i(program.at("rings"), 0);
    gl.uniformMatrix4fv(program.at("clipFromWorld"), false, clipFromWorld);
    gl.uniform3fv(program.at("eye"), eye);
    gl.uniform1f(program.at("worldPerPixel"), worldPerPixel);
    gl.uniform1f(program.at("perspective"), perspective ? 1 : 0);
    gl.uniform1i(program.at("sides"), sides);
    // Seen from a random side, a prism is as wide on average as a cylinder of this share of its radius.
    gl.uniform1f(program.at("swell"), Math.PI / sides / Math.sin(Math.PI / sides));
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, verticesAPiece(sides) * (this.ringCount - 1));
  }
}

function grown(data: Float32Array<ArrayBuffer>, length: number): Float32Array<ArrayBuffer> {
  const larger = new Float32Array(length);
  larger.set(data);
  return larger;
}

/** Everything that lives on the graphics card, made again when the browser took it away. */
class Resources {
  readonly tube: Program;
  readonly shadowTube: Program;
  readonly wall: Program;
  readonly rings: NumberTexture;
  readonly shadows: readonly SoftTexture[];

  constructor(gl: WebGL2RenderingContext) {
    this.tube = new Program(gl, TUBE_VERTEX, TUBE_FRAGMENT);
    this.shadowTube = new Program(gl, TUBE_VERTEX, SHADOW_FRAGMENT);
    this.wall = new Program(gl, WALL_VERTEX, WALL_FRAGMENT);
    this.rings = new NumberTexture(gl, 3 * RINGS_A_ROW);
    this.shadows = WALLS.map(() => new SoftTexture(gl, SHADOW_SIZE));
  }
}
