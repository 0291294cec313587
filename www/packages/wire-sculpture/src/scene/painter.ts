/** Everything that lives on the graphics card: the tube, its three shadows and the walls they fall on. */

import type { Body } from "./body";
import { linear, NumberTexture, Program, shown, SoftTexture } from "./gl";
import type { Look } from "./looks";
import { orthographic, type Mat4, type Vec3 } from "./matrix";
import { axesOf, DIRECTIONS, type Camera } from "./orbit";
import { HASTY_SHADOW_SIZE, RINGS_A_ROW, SHADOW_FRAGMENT, SHADOW_SIZE, SOFTEN_FRAGMENT, SOFTEN_VERTEX, TUBE_FRAGMENT, TUBE_VERTEX, verticesAPiece, WALL_FRAGMENT, WALL_VERTEX } from "./shaders";
import { RING_FLOATS, type Rings } from "./tube";

/** Sides of the tube as it is seen, by how round it has to look, and as it casts a shadow. */
const FEWEST_SIDES = 6;
const MOST_SIDES = 16;
const HASTY_SIDES = 4;
const SHADOW_SIDES = 4;
/** How far a side may be from the circle, in pixels. */
const FLATNESS_PX = 0.25;
/** World units from the middle to the border of a shadow; the object fits the unit ball. */
const SHADOW_EXTENT = 1.15;
export const WALL_AWAY = 1.22;
const WALL_EXTENT = 2.6;

/** The axes of each wall: what is right, up and towards the room for somebody who looks at it. */
const WALLS: readonly { axes: readonly [Vec3, Vec3, Vec3]; brightness: number }[] = (
  [["front", 1], ["side", 0.975], ["top", 0.985]] as const
).map(([name, brightness]) => {
  const { right, up, back } = axesOf(DIRECTIONS[name]);
  return { axes: [right, up, back], brightness };
});

/** Pictures of shadows: what throws one after the other, and one a wall. */
interface Shadows {
  readonly caster: SoftTexture;
  readonly onWalls: readonly SoftTexture[];
}

export class Painter {
  /** Behind everything: red, green, blue and their share, 0 to 1, by which they are multiplied already. None by itself. */
  ground: readonly [number, number, number, number] = [0, 0, 0, 0];
  private readonly tube: Program;
  private readonly shadowTube: Program;
  private readonly soften: Program;
  private readonly wall: Program;
  private readonly rings: NumberTexture;
  /** What the wire covers, once there was any. */
  body: Body | null = null;
  private readonly shadows: Shadows;
  /** Once they were wanted. */
  private hastyShadows: Shadows | null = null;
  /** The newest on each wall. */
  private readonly onWalls: SoftTexture[];
  private ringCount = 0;
  /** Of the rings, weighted by themselves: what most of what is seen has, world units. */
  private radius = 0;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.tube = new Program(gl, TUBE_VERTEX, TUBE_FRAGMENT);
    this.shadowTube = new Program(gl, TUBE_VERTEX, SHADOW_FRAGMENT);
    this.soften = new Program(gl, SOFTEN_VERTEX, SOFTEN_FRAGMENT);
    this.wall = new Program(gl, WALL_VERTEX, WALL_FRAGMENT);
    this.rings = new NumberTexture(gl, 3 * RINGS_A_ROW);
    this.shadows = this.shadowsOf(SHADOW_SIZE);
    this.onWalls = [...this.shadows.onWalls];
  }

  private shadowsOf(size: number): Shadows {
    return { caster: new SoftTexture(this.gl, size), onWalls: WALLS.map(() => new SoftTexture(this.gl, size)) };
  }

  /** The wire to draw from now on. What follows the rings in `data` up to a whole row is sent and never drawn. */
  load({ count, data }: Rings): void {
    this.ringCount = count;
    let [sum, squares] = [0, 0];
    for (let at = 3; at < count * RING_FLOATS; at += RING_FLOATS) {
      sum += data[at]!;
      squares += data[at]! ** 2;
    }
    this.radius = sum > 0 ? squares / sum : 0;
    const rows = Math.ceil(count / RINGS_A_ROW);
    if (rows > 0) this.rings.write(data.subarray(0, rows * RINGS_A_ROW * RING_FLOATS), rows);
  }

  /** On all walls, or `hasty` and on `only` one of the three. */
  castShadows(hasty = false, only: number | null = null): void {
    const { caster, onWalls } = hasty ? (this.hastyShadows ??= this.shadowsOf(HASTY_SHADOW_SIZE)) : this.shadows;
    WALLS.forEach(({ axes }, i) => {
      if (only === null || only === i) this.castShadow(axes, caster, (this.onWalls[i] = onWalls[i]!));
    });
  }

  private castShadow(axes: readonly [Vec3, Vec3, Vec3], caster: SoftTexture, shadow: SoftTexture): void {
    const { gl, shadowTube, soften } = this;
    caster.draw(() => {
      shadowTube.use();
      gl.uniform3fv(shadowTube.at("inward"), axes[2]);
      gl.uniform1f(shadowTube.at("away"), WALL_AWAY);
      gl.enable(gl.BLEND);
      gl.blendEquation(gl.MAX);
      this.drawTube(shadowTube, orthographic(...axes, SHADOW_EXTENT), [0, 0, 0], (2 * SHADOW_EXTENT) / caster.size, false, SHADOW_SIDES);
      gl.blendEquation(gl.FUNC_ADD);
      gl.disable(gl.BLEND);
    });
    shadow.draw(() => {
      soften.use();
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, caster.texture);
      gl.uniform1i(soften.at("caster"), 0);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    });
  }

  /**
   * `back` points from the target to the eye; `through` shows the wire behind the body as well; `hasty` is for machines
   * that cannot keep up.
   */
  paint(camera: Camera, back: Vec3, look: Look, width: number, height: number, through: boolean, hasty: boolean): void {
    const { gl, tube } = this;
    gl.viewport(0, 0, width, height);
    gl.clearColor(...this.ground);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    if (look.room) this.paintWalls(camera.clipFromWorld, back, look);
    gl.enable(gl.DEPTH_TEST);
    this.body?.paint(camera, look, through);
    tube.use();
    gl.uniform3fv(tube.at("ramp"), look.ramp.flatMap(linear));
    gl.uniform3fv(tube.at("sky"), linear(look.sky));
    gl.uniform3fv(tube.at("ground"), linear(look.ground));
    gl.uniform1f(tube.at("gloss"), look.gloss);
    this.drawTube(tube, camera.clipFromWorld, camera.eye, camera.worldPerPixel, true, hasty ? HASTY_SIDES : this.sidesFor(camera));
    gl.disable(gl.DEPTH_TEST);
  }

  /** A circle of radius r and a side of its n-gon are r (1 - cos(π/n)) ≈ r π² / 2n² apart. */
  private sidesFor({ eye, worldPerPixel }: Camera): number {
    const radiusPx = this.radius / (worldPerPixel * Math.hypot(...eye));
    const sides = Math.PI * Math.sqrt(radiusPx / (2 * FLATNESS_PX));
    return Math.max(FEWEST_SIDES, Math.min(MOST_SIDES, Math.ceil(sides)));
  }

  private paintWalls(clipFromWorld: Mat4, back: Vec3, look: Look): void {
    const { gl, wall } = this;
    wall.use();
    gl.uniformMatrix4fv(wall.at("clipFromWorld"), false, clipFromWorld);
    gl.uniform1f(wall.at("away"), WALL_AWAY);
    gl.uniform1f(wall.at("extent"), WALL_EXTENT);
    gl.uniform1f(wall.at("shadowExtent"), SHADOW_EXTENT);
    gl.uniform3fv(wall.at("wall"), shown(look.wall));
    gl.uniform3fv(wall.at("lit"), shown(look.lit));
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
      gl.bindTexture(gl.TEXTURE_2D, this.onWalls[i]!.texture);
      gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    });
    gl.disable(gl.BLEND);
  }

  private drawTube(program: Program, clipFromWorld: Mat4, eye: Vec3, worldPerPixel: number, perspective: boolean, sides: number): void {
    const { gl } = this;
    if (this.ringCount < 2) return;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.rings.texture);
    gl.uniform1i(program.at("rings"), 0);
    gl.uniformMatrix4fv(program.at("clipFromWorld"), false, clipFromWorld);
    gl.uniform3fv(program.at("eye"), eye);
    gl.uniform1f(program.at("worldPerPixel"), worldPerPixel);
    gl.uniform1f(program.at("perspective"), perspective ? 1 : 0);
    gl.uniform1i(program.at("sides"), sides);
    // Seen from a random side, a prism is as wide on average as a cylinder of this share of its radius.
    gl.uniform1f(program.at("swell"), Math.PI / sides / Math.sin(Math.PI / sides));
    // Nobody sees a tube from within.
    gl.enable(gl.CULL_FACE);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, verticesAPiece(sides) * (this.ringCount - 1));
    gl.disable(gl.CULL_FACE);
  }
}
