// The engines behind one face: make(scene) => { step(dt), poses() }. Each as it comes, but without damping and without sleep; a
// box that is wide and thick enough stands for a half-space where an engine has none.

const turnTo = ([x, y, z]) => {
  // from the y axis
  const w = 1 + y,
    l = Math.hypot(z, 0, -x, w);
  return l < 1e-9 ? [1, 0, 0, 0] : [z / l, 0, -x / l, w / l];
};
/** Pose of the box that stands for { p : n . p <= offset }. */
const groundPose = (scene, [x, y, z, offset]) => ({
  position: [x, y, z].map((n) => n * (offset - scene.groundHalfDepth)),
  orientation: turnTo([x, y, z]),
});

export function carom(carom) {
  return {
    name: `Carom ${carom.version}`,
    make(scene, bytes) {
      const engine = carom.engine(),
        world = engine.world();
      world.restore(bytes);
      world.setDial("sleep", 0);
      const view = world.view("pose");
      return {
        step: (dt) => world.step(dt),
        poses: () => {
          const { array, count } = view.update();
          return Array.from({ length: count }, (_, i) => Array.from(array.subarray(7 * i, 7 * i + 7)));
        },
        free: () => (view.free(), world.free(), engine.free()),
      };
    },
  };
}

export function rapier(RAPIER, name) {
  const collider = {
    half_space: (s) => RAPIER.ColliderDesc.cuboid(s.groundHalfWidth, s.groundHalfDepth, s.groundHalfWidth),
    sphere: (s, [r]) => RAPIER.ColliderDesc.ball(r),
    box: (s, p) => RAPIER.ColliderDesc.cuboid(...p),
    hull: (s, p) => RAPIER.ColliderDesc.convexHull(Float32Array.from(p)),
  };
  const xyz = ([x, y, z]) => ({ x, y, z }),
    xyzw = ([x, y, z, w]) => ({ x, y, z, w });
  return {
    name: `${name} ${RAPIER.version()}`,
    make(scene) {
      const world = new RAPIER.World({ x: 0, y: -9.81, z: 0 });
      const bodies = scene.bodies.map((b) => {
        const ground = b.solid.kind === "half_space" && groundPose(scene, b.solid.params);
        const { position, orientation } = ground || b;
        const desc = (b.moves ? RAPIER.RigidBodyDesc.dynamic() : RAPIER.RigidBodyDesc.fixed())
          .setTranslation(...position)
          .setRotation(xyzw(orientation))
          .setCanSleep(false);
        if (b.moves) desc.setLinvel(...b.velocity).setAngvel(xyz(b.spin));
        const body = world.createRigidBody(desc);
        world.createCollider(
          collider[b.solid.kind](scene, b.solid.params)
            .setDensity(b.density)
            .setFriction(scene.friction)
            .setRestitution(0),
          body,
        );
        return body;
      });
      return {
        step: (dt) => ((world.timestep = dt), world.step()),
        poses: () =>
          bodies.map((body) => {
            const p = body.translation(),
              q = body.rotation();
            return [p.x, p.y, p.z, q.x, q.y, q.z, q.w];
          }),
        free: () => world.free(),
      };
    },
  };
}

const STILL = 0,
  MOVING = 1; // layers of objects

export function jolt(Jolt, name) {
  const gone = (object, use) => {
    const result = use(object);
    Jolt.destroy(object);
    return result;
  };
  const vec = (p, use) => gone(new Jolt.Vec3(...p), use);
  const shapeOf = {
    half_space: (s) =>
      vec([s.groundHalfWidth, s.groundHalfDepth, s.groundHalfWidth], (v) => new Jolt.BoxShape(v, 0.05, null)),
    sphere: (s, [r]) => new Jolt.SphereShape(r, null),
    box: (s, p) => vec(p, (v) => new Jolt.BoxShape(v, Math.min(0.05, ...p), null)),
    hull: (s, p) =>
      gone(new Jolt.ConvexHullShapeSettings(), (settings) => {
        for (let i = 0; i < p.length; i += 3) vec(p.slice(i, i + 3), (v) => settings.mPoints.push_back(v));
        return settings.Create().Get();
      }),
  };
  return {
    name,
    make(scene) {
      const settings = new Jolt.JoltSettings(),
        pairs = new Jolt.ObjectLayerPairFilterTable(2),
        phases = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
      (pairs.EnableCollision(STILL, MOVING), pairs.EnableCollision(MOVING, MOVING));
      for (const layer of [STILL, MOVING]) phases.MapObjectToBroadPhaseLayer(layer, new Jolt.BroadPhaseLayer(layer));
      settings.mObjectLayerPairFilter = pairs;
      settings.mBroadPhaseLayerInterface = phases;
      settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(phases, 2, pairs, 2);
      const jolt = new Jolt.JoltInterface(settings);
      Jolt.destroy(settings);
      const system = jolt.GetPhysicsSystem(),
        face = system.GetBodyInterface();
      vec([0, -9.81, 0], (v) => system.SetGravity(v));
      const shapes = new Map();
      const bodies = scene.bodies.map((b) => {
        const ground = b.solid.kind === "half_space" && groundPose(scene, b.solid.params);
        const { position, orientation } = ground || b;
        const key = ground ? b : b.solid;
        if (!shapes.has(key)) {
          const shape = shapeOf[b.solid.kind](scene, b.solid.params);
          (shape.AddRef(), Jolt.castObject(shape, Jolt.ConvexShape).SetDensity(b.density), shapes.set(key, shape));
        }
        const p = new Jolt.RVec3(...position),
          q = new Jolt.Quat(...orientation);
        const desc = new Jolt.BodyCreationSettings(
          shapes.get(key),
          p,
          q,
          b.moves ? Jolt.EMotionType_Dynamic : Jolt.EMotionType_Static,
          b.moves ? MOVING : STILL,
        );
        Object.assign(desc, {
          mFriction: scene.friction,
          mRestitution: 0,
          mLinearDamping: 0,
          mAngularDamping: 0,
          mAllowSleeping: false,
        });
        if (b.moves)
          (vec(b.velocity, (v) => (desc.mLinearVelocity = v)), vec(b.spin, (v) => (desc.mAngularVelocity = v)));
        const body = face.CreateBody(desc);
        face.AddBody(body.GetID(), b.moves ? Jolt.EActivation_Activate : Jolt.EActivation_DontActivate);
        for (const object of [p, q, desc]) Jolt.destroy(object);
        return body;
      });
      return {
        step: (dt) => jolt.Step(dt, 1),
        poses: () =>
          bodies.map((body) => {
            const p = body.GetPosition(),
              at = [p.GetX(), p.GetY(), p.GetZ()],
              q = body.GetRotation();
            return [...at, q.GetX(), q.GetY(), q.GetZ(), q.GetW()];
          }),
        free: () => {
          for (const shape of shapes.values()) shape.Release();
          Jolt.destroy(jolt);
        },
      };
    },
  };
}
