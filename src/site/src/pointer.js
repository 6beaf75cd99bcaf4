// Mouse, touch and pen on the picture: grab, throw, drop, explode, cut, delete, follow, rays. What is done becomes an action;
// nothing else moves a body.
import * as THREE from "three";
import { rotate } from "./actions.js";

const THROW = { speed: 1.6, least: 8, most: 80, radius: 1 / 34 }; // of the camera's distance: m/s for 1 m, m for 1 m
const HEAVY = 4; // a ball weighs so many bodies of the scene
const BLAST = { reach: 0.3, speed: 0.9 }; // of the camera's distance

export class Pointer {
  /** @param page  canvas, camera, controls, picture() => Picture under the pointer, act(action), follow(body),
   * say(text), aim(ray, far): rays are cast from there */
  constructor(page) {
    Object.assign(this, { page, tool: "grab", held: null });
    const { canvas } = page;
    canvas.addEventListener("pointerdown", (e) => this.#down(e));
    canvas.addEventListener("pointermove", (e) => this.#move(e));
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"])
      canvas.addEventListener(end, () => this.#up());
  }

  #ray(event) {
    const box = this.page.canvas.getBoundingClientRect();
    return this.#rayAt((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
  }

  #rayAt(u, v) {
    const at = this.page.place(u, v);
    const caster = new THREE.Raycaster();
    caster.setFromCamera(new THREE.Vector2(at.x, at.y), this.page.camera);
    return caster.ray;
  }

  /** What is at a place of the canvas.   @param u, v  0 to 1 */
  probe(u, v) {
    const ray = this.#rayAt(u, v);
    return this.page.picture().pick(ray);
  }

  /** m: how far off the camera is from what it looks at. What is thrown is as large and fast as the scene asks. */
  #far() {
    return this.page.camera.position.distanceTo(this.page.controls.target);
  }

  /** A ball that is felt: heavier than what stands there.   @param ray  along which it flies */
  #ball(ray) {
    const far = this.#far(),
      radius = far * THROW.radius,
      { sim } = this.page.picture(),
      masses = sim.bodies.filter((b) => b.type === "dynamic").map((b) => b.mass),
      typical = masses.sort((a, b) => a - b)[masses.length >> 1] ?? 1,
      speed = Math.min(THROW.most, Math.max(THROW.least, far * THROW.speed));
    return {
      do: "spawn",
      shape: "sphere",
      params: [radius],
      position: ray.at(0.15 * far, new THREE.Vector3()).toArray(),
      velocity: ray.direction.clone().multiplyScalar(speed).toArray(),
      density: Math.min(2e4, (HEAVY * typical) / ((4 / 3) * Math.PI * radius ** 3)),
    };
  }

  #down(event) {
    if (event.button !== 0) return;
    const ray = this.#ray(event),
      { page } = this;
    if (this.tool === "rays") return void (page.aim(ray, this.#far()), (page.controls.enabled = event.pointerType === "mouse"));
    const hit = page.picture().pick(ray);
    if (this.tool === "throw") {
      page.act(this.#ball(ray));
      page.controls.enabled = false;
      return;
    }
    if (!hit) return;
    const { sim } = page.picture();
    if (this.tool === "box" || this.tool === "shape") {
      page.act({
        do: "spawn",
        ...(this.tool === "shape" ? this.shape : { shape: "box", params: Array(3).fill(this.#far() / 45) }),
        position: hit.point.clone().addScaledVector(page.camera.up, this.#far() / 8).toArray(),
      });
    } else if (this.tool === "explode") {
      const far = this.#far();
      page.act({ do: "explode", at: hit.point.toArray(), speed: BLAST.speed * far, reach: BLAST.reach * far });
    } else if (this.tool === "cut") {
      const { handle } = sim.bodies[hit.body],
        holds = ({ desc }) => desc.body_a === handle || desc.body_b === handle;
      if (sim.world.joints().some(holds)) page.act({ do: "cut", body: hit.body });
      else page.say("no joint holds this body");
    } else if (this.tool === "delete") {
      if (sim.bodies[hit.body].type === "dynamic") page.act({ do: "remove", body: hit.body });
      else page.say("only bodies that move can be deleted here");
    } else if (this.tool === "follow") {
      page.follow(hit.body);
    } else if (sim.bodies[hit.body].type === "dynamic") {
      const body = sim.bodies[hit.body],
        [x, y, z, w] = body.orientation,
        p = body.position;
      const local = rotate(
        [-x, -y, -z, w],
        hit.point.toArray().map((c, i) => c - p[i]),
      );
      const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(
        page.camera.getWorldDirection(new THREE.Vector3()).negate(),
        hit.point,
      );
      this.held = { body: hit.body, at: local, plane, to: hit.point.toArray() };
      page.canvas.setPointerCapture(event.pointerId);
    }
    page.controls.enabled = false;
  }

  #move(event) {
    if (this.tool === "rays") this.page.aim(this.#ray(event), this.#far());
    if (!this.held) return;
    const to = this.#ray(event).intersectPlane(this.held.plane, new THREE.Vector3());
    if (to) this.held.to = to.toArray();
  }

  #up() {
    this.held = null;
    this.page.controls.enabled = true;
  }

  /** The pull of this moment, as an action, or null: before each step. */
  pull(sim) {
    if (!this.held || !sim.bodies[this.held.body]) return null;
    return { do: "pull", body: this.held.body, at: this.held.at, to: this.held.to };
  }
}
