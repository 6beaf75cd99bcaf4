// Mouse, touch and pen on the picture: grab, throw, drop, delete, follow. What is done becomes an action; nothing
// else moves a body.
import * as THREE from "three";
import { rotate } from "./actions.js";

const THROW = 20; // m/s, of a ball from the camera

export class Pointer {
  /** @param page  canvas, camera, controls, picture() => Picture under the pointer, act(action), follow(body),
   * say(text) */
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

  #down(event) {
    if (event.button !== 0) return;
    const ray = this.#ray(event),
      { page } = this,
      hit = page.picture().pick(ray);
    if (this.tool === "throw") {
      const from = ray.at(1, new THREE.Vector3()).toArray();
      page.act({
        do: "spawn",
        shape: "sphere",
        params: [0.25],
        position: from,
        velocity: ray.direction.clone().multiplyScalar(THROW).toArray(),
        density: 2000,
      });
      page.controls.enabled = false;
      return;
    }
    if (!hit) return;
    const { sim } = page.picture();
    if (this.tool === "box" || this.tool === "shape") {
      page.act({
        do: "spawn",
        ...(this.tool === "shape" ? this.shape : { shape: "box", params: [0.25, 0.25, 0.25] }),
        position: [hit.point.x, hit.point.y + 1.5, hit.point.z],
      });
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
