// The three.js scene: camera, light, ground, one view or two side by side.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { theme } from "./palette.js";

export class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.setScissorTest(true);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(45, 1, 0.05, 2000);
    this.controls = new OrbitControls(this.camera, canvas);
    this.light = new THREE.DirectionalLight("#ffffff", 2.4);
    this.light.castShadow = true;
    this.light.shadow.mapSize.set(2048, 2048);
    this.light.shadow.bias = -0.0005;
    this.sky = new THREE.HemisphereLight("#ffffff", "#777f8a", 1.3);
    this.ground = new THREE.Mesh(new THREE.PlaneGeometry(1, 1), new THREE.MeshStandardMaterial({ roughness: 0.95 }));
    this.ground.rotation.x = -Math.PI / 2;
    this.ground.receiveShadow = true;
    this.water = new THREE.Mesh(
      new THREE.PlaneGeometry(1, 1),
      new THREE.MeshStandardMaterial({ color: "#3b82c4", transparent: true, opacity: 0.45 }),
    );
    this.water.rotation.x = -Math.PI / 2;
    this.scene.add(this.light, this.light.target, this.sky, this.ground, this.water);
    this.grid = null;
  }

  /** Stand where the scene says. @param row  camera, ground, water of the index */
  look(row) {
    const { from = [6, 5, 9], to = [0, 1, 0] } = row.camera ?? {};
    this.camera.position.set(...from);
    this.controls.target.set(...to);
    this.controls.update();
    const wide = Math.max(row.ground ?? 10, 4);
    this.ground.visible = row.ground !== 0;
    this.ground.scale.setScalar(2 * wide);
    this.ground.position.y = -0.002;
    this.water.visible = row.water !== undefined;
    this.water.scale.setScalar(2 * wide);
    this.water.position.y = row.water ?? 0;
    const reach = Math.max(8, 1.2 * wide);
    // From over the visitor's left shoulder: what is looked at is lit.
    const ahead = [to[0] - from[0], to[2] - from[2]],
      far = Math.hypot(...ahead) || 1;
    const [x, z] = [(-0.9 * ahead[0] + 0.7 * ahead[1]) / far, (-0.9 * ahead[1] - 0.7 * ahead[0]) / far];
    this.light.position.set(to[0] + reach * x, to[1] + 2 * reach, to[2] + reach * z);
    this.light.target.position.set(...to);
    Object.assign(this.light.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, far: 6 * reach });
    this.light.shadow.camera.updateProjectionMatrix();
    this.wide = wide;
    this.paint();
  }

  paint() {
    const colours = theme();
    this.scene.background = new THREE.Color(colours.sky);
    this.ground.material.color.set(colours.ground);
    if (this.grid) (this.scene.remove(this.grid), this.grid.dispose());
    this.grid = new THREE.GridHelper(
      2 * (this.wide ?? 10),
      Math.min(60, Math.round(2 * (this.wide ?? 10))),
      colours.grid,
      colours.grid,
    );
    this.grid.visible = this.ground.visible;
    this.scene.add(this.grid);
  }

  /** @param pictures  one, or two side by side */
  render(pictures) {
    const w = this.canvas.clientWidth,
      h = this.canvas.clientHeight,
      ratio = Math.min(devicePixelRatio, 2);
    if (!w || !h) return;
    if (this.w !== w || this.h !== h || this.ratio !== ratio) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(w, h, false);
      Object.assign(this, { w, h, ratio });
    }
    const wide = w / pictures.length;
    this.camera.aspect = wide / h;
    this.camera.updateProjectionMatrix();
    pictures.forEach((picture, i) => {
      for (const p of pictures) p.group.visible = p === picture;
      this.renderer.setViewport(i * wide, 0, wide, h);
      this.renderer.setScissor(i * wide, 0, wide, h);
      this.renderer.render(this.scene, this.camera);
    });
    this.views = pictures.length;
  }

  /** Which view a place of the canvas is in, and where in it, -1 to 1.   @param u, v  0 to 1 */
  place(u, v) {
    const n = this.views ?? 1,
      view = Math.min(n - 1, Math.floor(u * n));
    return { view, x: 2 * (u * n - view) - 1, y: 1 - 2 * v };
  }

  follow(point) {
    const to = new THREE.Vector3(...point),
      shift = to.clone().sub(this.controls.target);
    this.camera.position.add(shift);
    this.controls.target.copy(to);
  }
}
