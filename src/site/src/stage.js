// The three.js scene: camera, light, sky and ground, one view or two side by side. How well it is drawn falls before
// frames do.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { crowd, fit } from "./fit.js";
import { common, groundMaterial, skyDome } from "./look.js";
import { theme } from "./palette.js";

/** From best to cheapest: pixels of the picture for one of the page, side of the shadows' map, width of their edge in it. */
const QUALITY = [
  { pixels: 2, shadow: 2048, soft: 1.6 },
  { pixels: 1, shadow: 2048, soft: 1.2 },
  { pixels: 1, shadow: 1024, soft: 0 },
  { pixels: 0.7, shadow: 512, soft: 0 },
  { pixels: 0.5, shadow: 512, soft: 0 },
];
const SLOW = 28, // ms of drawing from one picture to the next: worse is drawn
  FAST = 12; // better is drawn, if it was long so
const FRAMES = 12; // that are looked at before something is changed
const HOLD = 240; // frames after which better is tried again
const FOLLOWS = 1.8, // 1/s, of the camera, at leisure
  TURNS = 2, // 1/s, behind a car
  BEHIND = 0.08; // of its distance: farther from where it should look it hurries

/** The axis that points against gravity, or nearly so; without gravity y.   @param gravity [3] m/s^2   @returns [3] */
export function upOf(gravity) {
  const most = Math.max(...gravity.map((x) => -x));
  return most > 0 ? gravity.map((x, k) => Number(k === gravity.findIndex((g) => -g === most))) : [0, 1, 0];
}

/** Does the processor draw? Then even the first picture is a cheap one. */
function software() {
  const gl = document.createElement("canvas").getContext("webgl2"),
    told = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = told ? String(gl.getParameter(told.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

export class Stage {
  /** @param covered () => px of the picture's height that tools hide, at the top */
  constructor(canvas, covered) {
    this.covered = covered;
    const cheap = software();
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !cheap, preserveDrawingBuffer: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.setScissorTest(true);
    this.scene = new THREE.Scene();
    this.scene.fog = new THREE.Fog();
    this.camera = new THREE.PerspectiveCamera(38, 1);
    this.#stand([0, 1, 0]);
    this.light = new THREE.DirectionalLight("#fff1dc");
    this.light.castShadow = true;
    this.light.shadow.bias = -0.0004;
    this.bounce = new THREE.HemisphereLight();
    this.ground = new THREE.Mesh(new THREE.CircleGeometry(1, 48), groundMaterial());
    this.ground.receiveShadow = true;
    this.ground.renderOrder = 0.5; // after what hides it
    this.heaven = { high: { value: new THREE.Color() }, horizon: { value: new THREE.Color() } };
    this.dome = skyDome(this.heaven);
    this.water = new THREE.Mesh(
      new THREE.PlaneGeometry(1, 1),
      new THREE.MeshLambertMaterial({ color: "#3b82c4", transparent: true, opacity: 0.45 }),
    );
    this.water.rotation.x = -Math.PI / 2;
    this.scene.add(this.light, this.light.target, this.bounce, this.ground, this.water, this.dome);
    this.cheap = cheap;
    this.quality = cheap ? 2 : 0;
    Object.assign(this, { slow: 0, fast: 0, wait: 0, best: 0, auto: true, drift: new THREE.Vector3() });
  }

  /** With this direction up. What turns the camera is made for one.   @param up [3] */
  #stand(up) {
    this.camera.up.fromArray(up);
    common.up.value.copy(this.camera.up);
    this.controls?.dispose();
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener("start", () => (this.auto = false));
    this.turned = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), this.camera.up);
  }

  /** Stand where the scene says, as far off as this picture asks.   @param row  camera, ground, floor, water of the index;
   *  without a camera, as of a robot's file, up is against gravity   @param pictures  of it */
  look(row, pictures) {
    const { from = [6, 5, 9], to = [0, 1, 0] } = row.camera ?? {},
      up = row.camera ? [0, 1, 0] : upOf(pictures[0].sim.world.gravity);
    if (this.camera.up.toArray().some((x, k) => x !== up[k])) this.#stand(up);
    this.direction = new THREE.Vector3(...from).sub(new THREE.Vector3(...to)).normalize().applyQuaternion(this.turned);
    this.ground.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), this.camera.up);
    this.dome.quaternion.copy(this.turned);
    this.bounce.position.copy(this.camera.up);
    this.floor = row.ground !== 0;
    this.water.visible = row.water !== undefined;
    this.water.scale.setScalar(2 * Math.max(row.ground ?? 10, 4));
    this.water.position.y = row.water ?? 0;
    this.level = (row.floor ?? 0) - 0.002; // m, of the ground that is drawn
    this.auto = true;
    this.size = undefined;
    this.best = 0; // what was too much for another scene may not be for this one
    this.#resize(pictures.length);
    this.follow(pictures, Infinity);
    this.paint();
  }

  /** The camera goes where all that belongs together is seen.   @param seconds  since it last did; Infinity: at once */
  follow(pictures, seconds) {
    if (!this.auto || !this.direction) return;
    const heading = pictures[0].sim.driver?.heading?.();
    if (heading && seconds < Infinity) {
      // Behind what is driven, as far above it as before.
      const level = new THREE.Vector3(-heading[0], 0, -heading[2]).normalize(),
        { y } = this.direction;
      level.multiplyScalar(Math.sqrt(1 - y * y)).setY(y);
      this.direction
        .lerp(level, 1 - Math.exp(-TURNS * seconds))
        .setY(y)
        .normalize();
    }
    const moving = pictures.flatMap((picture) => picture.balls(true)),
      spread = (balls) => Math.max(...balls.map((b) => Math.hypot(b[0], b[1], b[2]) + b[3]), 1e-3);
    if (this.size === undefined) {
      const box = new THREE.Box3().setFromPoints(moving.map((b) => new THREE.Vector3(b[0], b[1], b[2])));
      this.size = moving.length
        ? Math.max(box.getSize(new THREE.Vector3()).length(), 2 * moving[0][3])
        : spread([[1, 1, 1, 1]]);
      // What stands is looked at as well, if it is not much larger than what moves.
      this.standing = pictures
        .flatMap((picture) => picture.balls(false))
        .filter((b) => b[3] < 0.8 * this.size || !moving.length);
    }
    let balls = crowd(moving, this.size);
    balls = balls.concat(
      this.standing.filter((b) =>
        balls.some((m) => Math.hypot(b[0] - m[0], b[1] - m[1], b[2] - m[2]) < 1.5 * this.size),
      ),
    );
    if (!balls.length) balls = this.standing.length ? this.standing : [[0, 1, 0, 3]];
    const goal = fit(balls, this.direction, this.camera, Math.min(0.3, this.covered() / (this.h || 1)));
    const { target } = this.controls,
      now = this.camera.position.distanceTo(target);
    if (seconds === Infinity) {
      target.copy(goal.target);
      this.goal = goal.target;
      this.drift.set(0, 0, 0);
      this.#place(goal.distance);
      return;
    }
    // It does not breathe: a little too far off is good enough.
    const far = goal.distance > now || goal.distance < 0.75 * now ? goal.distance : now,
      behind = target.distanceTo(goal.target) / now,
      share = 1 - Math.exp(-FOLLOWS * seconds * (1 + (behind / BEHIND) ** 2));
    // What falls or drives is not left behind: the camera takes on its speed.
    if (seconds > 0) this.drift.lerp(goal.target.clone().sub(this.goal).divideScalar(seconds), share);
    this.goal = goal.target;
    target.addScaledVector(this.drift, seconds).lerp(goal.target, share);
    this.#place(now + (far - now) * share);
  }

  #place(distance) {
    this.camera.position.copy(this.controls.target).addScaledVector(this.direction, distance);
    this.controls.update();
  }

  /** Look at a point from where the camera stands to it.   @param point [3] */
  keep(point) {
    const to = new THREE.Vector3(...point);
    this.camera.position.add(to.clone().sub(this.controls.target));
    this.controls.target.copy(to);
  }

  paint() {
    const colours = theme();
    this.heaven.high.value.set(colours.sky);
    this.heaven.horizon.value.set(colours.horizon);
    this.scene.fog.color.set(colours.horizon);
    this.ground.material.uniforms.tint.value.set(colours.ground);
    common.line.value = colours.line;
    this.bounce.color.set(colours.above);
    this.bounce.groundColor.set(colours.below);
    this.bounce.intensity = 1.5;
    this.light.intensity = 2.1;
  }

  /** What depends on how far off the camera is: haze, lines, shadows. */
  #air() {
    const { target } = this.controls,
      far = this.camera.position.distanceTo(target),
      reach = 0.75 * far;
    Object.assign(this.camera, { near: far / 200, far: 400 * far });
    Object.assign(this.scene.fog, { near: 2.2 * far, far: 14 * far });
    this.ground.visible = this.floor;
    const { up } = this.camera;
    this.ground.position.copy(target).addScaledVector(up, this.level - target.dot(up));
    this.ground.scale.setScalar(30 * far);
    this.dome.position.copy(this.camera.position);
    this.dome.scale.setScalar(100 * far);
    common.spacing.value = 10 ** Math.round(Math.log10(far / 12));
    // From over the visitor's left shoulder: what is looked at is lit.
    const ahead = target.clone().sub(this.camera.position).projectOnPlane(up).normalize();
    this.light.position
      .copy(target)
      .addScaledVector(ahead, -0.7 * reach)
      .addScaledVector(up.clone().cross(ahead), 0.9 * reach)
      .addScaledVector(up, 1.7 * reach);
    this.light.target.position.copy(target);
    const { camera } = this.light.shadow;
    Object.assign(camera, {
      left: -reach,
      right: reach,
      top: reach,
      bottom: -reach,
      near: 0.05 * reach,
      far: 5 * reach,
    });
    camera.updateProjectionMatrix();
    this.light.shadow.normalBias = reach / 400;
  }

  /** Draw worse where pictures come too slowly, better again where they came fast for long.
   *  @param ms  from the last picture to this one, without what was computed in between */
  adapt(ms) {
    this.slow = ms > SLOW ? Math.min(this.slow, FRAMES) + 1 : Math.max(0, this.slow - 2);
    this.fast = ms < FAST ? this.fast + 1 : 0;
    ++this.wait;
    let next = this.quality;
    if (this.slow > FRAMES) this.best = next = Math.min(QUALITY.length - 1, next + 1);
    else if (this.fast > 4 * FRAMES && this.wait > HOLD) next = Math.max(this.best, next - 1);
    if (next === this.quality) return;
    Object.assign(this, { quality: next, slow: 0, fast: 0, wait: 0 });
  }

  #resize(views) {
    const w = this.canvas.clientWidth,
      h = this.canvas.clientHeight,
      { pixels, shadow, soft } = QUALITY[this.quality],
      ratio = this.quality ? pixels : Math.min(devicePixelRatio, pixels);
    if (!w || !h) return false;
    if (this.w !== w || this.h !== h || this.ratio !== ratio) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(w, h, false);
      Object.assign(this, { w, h, ratio });
    }
    if (this.light.shadow.mapSize.x !== shadow) {
      this.light.shadow.mapSize.set(shadow, shadow);
      this.light.shadow.map?.dispose();
      this.light.shadow.map = null;
    }
    common.soft.value = soft;
    this.views = views;
    this.camera.aspect = w / views / h;
    return true;
  }

  /** @param pictures  one, or two side by side */
  render(pictures) {
    if (!this.#resize(pictures.length)) return;
    this.#air();
    this.camera.updateProjectionMatrix();
    // Cheap pictures have shadows of every other one.
    this.odd = !this.odd;
    Object.assign(this.renderer.shadowMap, {
      autoUpdate: this.quality < 3 || pictures.length > 1,
      needsUpdate: this.odd,
    });
    const wide = this.w / pictures.length;
    pictures.forEach((picture, i) => {
      for (const p of pictures) p.group.visible = p === picture;
      this.renderer.setViewport(i * wide, 0, wide + (i === pictures.length - 1 ? 2 : 0), this.h);
      this.renderer.setScissor(i * wide, 0, wide + 2, this.h); // to the last pixel, however widths are rounded
      this.renderer.render(this.scene, this.camera);
    });
  }

  /** Which view a place of the canvas is in, and where in it, -1 to 1.   @param u, v  0 to 1 */
  place(u, v) {
    const n = this.views ?? 1,
      view = Math.min(n - 1, Math.floor(u * n));
    return { view, x: 2 * (u * n - view) - 1, y: 1 - 2 * v };
  }
}
