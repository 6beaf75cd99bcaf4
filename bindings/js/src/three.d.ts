// Types of carom/three. Those of three.js are described by what is used of them, so its own are not needed.
import type { Body, Carom, Engine, Source, Vector, World } from "./index.js";

/** A vector or a quaternion of three.js. */
export interface Tuple {
  toArray(): number[];
}
/** THREE.Object3D, as far as it is looked at. */
export interface ObjectLike {
  traverse(visit: (child: any) => void): void;
}
/** THREE.Mesh or THREE.InstancedMesh. */
export interface MeshLike {
  readonly isMesh: boolean;
  readonly geometry: { readonly type: string };
}

export interface PhysicsOptions {
  /** m/s^2 */
  gravity?: Vector;
  /** s, of a step; 1/60 by default */
  dt?: number;
}

export class Physics {
  constructor(carom: Carom, options?: PhysicsOptions);
  readonly carom: Carom;
  readonly engine: Engine;
  /** For all that has no method here: joints, dials, rays. */
  readonly world: World;
  readonly dt: number;
  /** A body for each mesh below that has `userData.physics = { mass, restitution, friction }`. */
  addScene(scene: ObjectLike): void;
  /** @param mass kg; 0: it does not move   @returns its body, or one for each instance */
  addMesh(mesh: MeshLike, mass?: number, restitution?: number, friction?: number): Body | Body[];
  removeMesh(mesh: MeshLike): void;
  /** At rest. */
  setMeshPosition(mesh: MeshLike, position: Tuple, index?: number, quaternion?: Tuple): void;
  setMeshVelocity(mesh: MeshLike, velocity: Tuple, index?: number): void;
  /** @param seconds  that passed   @returns steps taken */
  update(seconds: number): number;
  step(): void;
  dispose(): void;
}

export function CaromPhysics(
  options?: PhysicsOptions & {
    source?: Source;
    threads?: number | "auto";
    running?: boolean;
  },
): Promise<Physics>;
