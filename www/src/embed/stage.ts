/**
 * A room with a wire in it: three walls, on each the shadow the wire casts along that axis, and a camera that people
 * hold. Draws only when something changed. Knows control points and knots and nothing of the rest of the page.
 */

import { listen } from "./controls";
import { linear, Program, shown, SoftTexture } from "./gl";
import { orthographic, type Mat4, type Vec3 } from "./matrix";
import { axesOf, HOME, Orbit, VIEW_POSES, type Pose } from "./orbit";
import { SHADOW_FRAGMENT, TUBE_FRAGMENT, TUBE_VERTEX, WALL_FRAGMENT, WALL_VERTEX } from "./shaders";
import { sampleWire, type WireShape } from "./shape";
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

const SIDES = 14;
const SAMPLES_PER_SPAN = 7;
const SHADOW_SIZE = 512;
/** World units from the middle to the border of a shadow; the object fits the unit ball. */
const SHADOW_EXTENT = 1.15;
const WALL_AWAY = 1.22;
const WALL_EXTENT = 2.6;
const FLIGHT_MS = 650;
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
  private ringData: Float32Array | undefined;
  private ringCount = 0;
  private stale = { wire: true, picture: true };
  private frame = 0;
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
    this.wire = wire;
    this.stale.wire = true;
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
    this.observer.disconnect();
    this.stopListening();
    this.canvas.removeEventListener("webglcontextlost", this.lost);
    this.canvas.removeEventListener("webglcontextrestored", this.restored);
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  private readonly lost = (event: Event): void => event.preventDefault();
  private readonly restored = (): void => {
    this.resources = new Resources(this.gl);
    this.stale.wire = true;
    this.invalidate();
  };

  private held(action: () => void): void {
    this.swaying = false;
    action();
    this.onHold();
    this.invalidate();
  }

  private invalidate(): void {
    this.stale.picture = true;
    this.frame ||= requestAnimationFrame(this.draw);
  }

  private readonly draw = (nowMs: number): void => {
    this.frame = 0;
    if (this.gl.isContextLost()) return;
    const flying = this.orbit.advance(nowMs);
    if (this.swaying) {
      const phase = ((nowMs - this.swayStartMs) / 1000 / SWAY_S) * 2 * Math.PI;
      this.orbit.pose.azimuthRad = this.swayFrom + SWAY_RAD * Math.sin(phase);
    }
    if (this.stale.wire) this.uploadWire();
    this.paint();
    this.stale = { wire: false, picture: false };
    if (flying || this.swaying) this.invalidate();
  };

  private uploadWire(): void {
    const { gl, resources } = this;
    if (!this.wire) {
      this.ringCount = 0;
    } else {
      const rings = buildRings(sampleWire(this.wire, SAMPLES_PER_SPAN), this.ringData);
      this.ringData = rings.data;
      this.ringCount = rings.count;
      gl.bindBuffer(gl.ARRAY_BUFFER, resources.rings);
      gl.bufferData(gl.ARRAY_BUFFER, rings.data, gl.DYNAMIC_DRAW, 0, rings.count * RING_FLOATS);
    }
    if (!this.look.room) return;
    WALLS.forEach(({ axes }, i) => {
      resources.shadows[i]!.draw(() => {
        const { shadowTube } = resources;
        shadowTube.use();
        const worldPerPixel = (2 * SHADOW_EXTENT) / SHADOW_SIZE;
        this.drawTube(shadowTube, orthographic(...axes, SHADOW_EXTENT), [0, 0, 0], worldPerPixel, false);
      });
    });
  }

  private paint(): void {
    const { gl, canvas, resources, look } = this;
    const density = Math.min(2, devicePixelRatio || 1);
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
    this.drawTube(tube, camera.clipFromWorld, camera.eye, camera.worldPerPixel, true);
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
      gl.bindVertexArray(null);
      gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    });
    gl.disable(gl.BLEND);
  }

  private drawTube(program: Program, clipFromWorld: Mat4, eye: Vec3, worldPerPixel: number, perspective: boolean): void {
    const { gl } = this;
    if (this.ringCount < 2) return;
    gl.uniformMatrix4fv(program.at("clipFromWorld"), false, clipFromWorld);
    gl.uniform3fv(program.at("eye"), eye);
    gl.uniform1f(program.at("worldPerPixel"), worldPerPixel);
    gl.uniform1f(program.at("perspective"), perspective ? 1 : 0);
    gl.uniform1f(program.at("sides"), SIDES);
    gl.bindVertexArray(this.resources.tubeLayout);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 2 * (SIDES + 1), this.ringCount - 1);
    gl.bindVertexArray(null);
  }
}

/** Everything that lives on the graphics card, made again when the browser took it away. */
class Resources {
  readonly tube: Program;
  readonly shadowTube: Program;
  readonly wall: Program;
  readonly rings: WebGLBuffer;
  readonly tubeLayout: WebGLVertexArrayObject;
  readonly shadows: readonly SoftTexture[];

  constructor(gl: WebGL2RenderingContext) {
    this.tube = new Program(gl, TUBE_VERTEX, TUBE_FRAGMENT);
    this.shadowTube = new Program(gl, TUBE_VERTEX, SHADOW_FRAGMENT);
    this.wall = new Program(gl, WALL_VERTEX, WALL_FRAGMENT);
    this.rings = gl.createBuffer();
    this.tubeLayout = gl.createVertexArray();
    gl.bindVertexArray(this.tubeLayout);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.rings);
    const bytes = RING_FLOATS * 4;
    for (let location = 0; location < 6; location++) {
      // Locations 0 to 2 read a ring, 3 to 5 the one after it.
      const offset = location < 3 ? location * 16 : bytes + (location - 3) * 16;
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, 4, gl.FLOAT, false, bytes, offset);
      gl.vertexAttribDivisor(location, 1);
    }
    gl.bindVertexArray(null);
    this.shadows = WALLS.map(() => new SoftTexture(gl, SHADOW_SIZE));
  }
}
