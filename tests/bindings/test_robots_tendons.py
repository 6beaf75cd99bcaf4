"""Tendons of carom.robots: what each may have beside MuJoCo or a closed form; what is left out; saved and many at once.

Needs MuJoCo 4 (pip install mujoco-core, Python 3.11), and is skipped without it.
"""
import json
import math
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

OFF = 'contype="0" conaffinity="0"'


def load(text, **about):
    return carom.robots.load(mujoco.MjSpec.from_string(text), **about)


def finger(tendon="", more="", dt=1e-5, option=""):
    """Three hinges and a slide, of which one has another zero; a tendon of three of them."""
    return f"""<mujoco><option timestep="{dt}" {option}/><worldbody>
      <body name="one" pos="0 0 1"><joint name="a" axis="0 1 0"/><geom type="capsule" size=".03" fromto="0 0 0 .3 0 0" {OFF}/>
        <body name="two" pos=".3 0 0"><joint name="b" axis="0 1 0" ref="20"/><geom type="capsule" size=".03" fromto="0 0 0 .25 .02 0" {OFF}/>
          <body name="three" pos=".25 0 0" euler="10 0 0"><joint name="c" axis="0 1 .3"/><geom type="capsule" size=".02" fromto="0 0 0 .2 0 0" {OFF}/>
            <body name="four" pos=".2 0 0"><joint name="d" type="slide" axis="1 0 .2"/><geom size=".03" {OFF}/></body></body></body></body>
      </worldbody>
      <tendon><fixed name="t" {tendon}><joint joint="a" coef=".5"/><joint joint="c" coef="-1.2"/><joint joint="d" coef="2"/></fixed></tendon>
      {more}</mujoco>"""


SHARES = np.array([0.5, 0, -1.2, 2])


def beside(text, seconds=0.03, control=None):
    """@return differences of coordinates from MuJoCo's (RK4) after so long, at the model's step and at half of it; MuJoCo's coordinates"""
    off = []
    for halves in (1, 2):
        spec = mujoco.MjSpec.from_string(text)
        with carom.robots.load(spec, dt=spec.option.timestep / halves, substeps=1) as robot:
            assert robot.left_out == [], robot.left_out
            model = robot._model
            model.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
            if control is not None:
                robot.ctrl[:] = control
            data = mujoco.MjData(model)
            data.ctrl[:] = robot.ctrl[:]
            for _ in range(round(seconds / model.opt.timestep)):
                mujoco.mj_step(model, data)
            robot.step(round(seconds / robot.dt))
            off.append(robot.qpos[:] - data.qpos)
    return off[0], off[1], data.qpos.copy()


def led_to(coarse, fine):
    """Where errors of first order lead to as the step goes to 0."""
    return float(np.abs(2 * fine - coarse).max())


class Fixed(unittest.TestCase):
    def like_mujoco(self, tendon, within, moves=1e-3, **about):
        """It agrees, and the tendon matters: without it coordinates would be off by `moves` at least."""
        coarse, fine, there = beside(finger(tendon, **about))
        self.assertLess(min(led_to(coarse, fine), float(np.abs(fine).max())), within)
        self.assertGreater(float(np.abs(there - beside(finger(**about))[2]).max()), moves)
        return float(np.abs(coarse).max() / np.abs(fine).max())

    def test_stiffness(self):
        """step() finds it midway in the step, so errors are of second order."""
        self.like_mujoco('stiffness="30" springlength="0.1"', 1e-8)

    def test_a_spring_with_slack(self):
        self.like_mujoco('stiffness="200" springlength="0.02 0.03"', 1e-7)

    def test_damping(self):
        """Errors are of first order."""
        self.assertAlmostEqual(self.like_mujoco('damping="3"', 1e-7), 2, delta=0.1)

    def test_a_damper_that_a_step_does_not_resolve(self):
        """b dt / m is 1e5: each step takes away the rate that it began with, so what is left is what weights make in one step."""
        with load(finger('damping="1e5"', dt=0.002)) as robot, load(finger(dt=0.002)) as free:
            self.assertEqual(robot.left_out, [])
            for _ in range(100):
                before = free.tendons["t"].rate
                robot.step()
                free.step()
                self.assertLess(abs(robot.tendons["t"].rate), 2.5 * abs(free.tendons["t"].rate - before))
            self.assertLess(abs(robot.tendons["t"].rate), abs(free.tendons["t"].rate) / 10)

    def test_armature(self):
        self.like_mujoco('armature="0.02"', 1e-7)

    def test_a_limit_under_a_load(self):
        """Gravity presses against it for good: it stays at its end, whose place is in MuJoCo's measure; a margin is kept off."""
        for low, high, margin in ((-0.2, 0.05, 0.0), (-0.3, 0.3, 0.02), (0.02, 0.04, 0.0), (-0.2, 0.05, 0.01)):
            with self.subTest(low=low, high=high), load(finger(f'range="{low} {high}" limited="true" margin="{margin}" ', dt=0.002)) as robot:
                self.assertEqual(robot.left_out, [])
                tendon, seen = robot.tendons["t"], []
                for _ in range(400):
                    robot.step()
                    length = tendon.length
                    self.assertAlmostEqual(length, float(SHARES @ robot.qpos[:]), places=12)
                    seen.append(length)
                seen = np.array(seen[50:] if low > 0 else seen)  # it began outside
                self.assertGreater(seen.min(), low + margin - 1e-9)
                self.assertLess(seen.max(), high - margin + 1e-9)
                self.assertTrue(np.isclose(seen, low + margin, atol=1e-9).any() or np.isclose(seen, high - margin, atol=1e-9).any())

    def test_friction(self):
        """More than weights pull: it does not move, whatever its joints do. Less: it slides, and loses friction times way."""
        with load(finger('frictionloss="50"', dt=0.002)) as robot:
            robot.step(200)
            self.assertAlmostEqual(robot.tendons["t"].length, 0, places=7)
            self.assertGreater(float(np.abs(robot.qpos[:]).max()), 0.3)
        option = 'gravity="0 0 0"'
        with load(finger('frictionloss="0.3"', dt=1e-4, option=option), substeps=1) as robot:
            robot.qvel[:] = (0, 0, 0, 1)

            def energy():
                v = robot.qvel[:]
                return float(v @ robot.mass_matrix() @ v) / 2

            before, way, last = energy(), 0.0, robot.tendons["t"].length
            for _ in range(500):
                robot.step()
                length = robot.tendons["t"].length
                way, last = way + abs(length - last), length
            self.assertGreater(way, 0.015)
            self.assertAlmostEqual((before - energy()) / (0.3 * way), 1, delta=2e-3)

    def test_of_one_joint(self):
        text = """<mujoco><option timestep="0.002"/><worldbody><body><joint name="a" axis="0 1 0"/>
            <geom type="capsule" size=".02" fromto="0 0 0 .4 0 0"/></body></worldbody>
            <tendon><fixed name="t" limited="true" range="-.1 .4"><joint joint="a" coef="-2"/></fixed></tendon></mujoco>"""
        with load(text) as robot:
            self.assertEqual(robot.left_out, [])
            robot.step(500)
            self.assertAlmostEqual(float(robot.qpos["a"]), 0.05, places=9)

    def test_where_it_is_put_it_stays(self):
        """Places, speeds and keyframes are the chain's, too: nothing jumps, and a reset leads to the same bits."""
        key = '<keyframe><key name="k" qpos="0.2 0.5 0.1 0.05" qvel="0.3 0 -1 2"/></keyframe>'
        with load(finger('range="-9 9" limited="true"', key, dt=0.002)) as robot, load(finger(more=key, dt=0.002), solver="direct") as free:
            ends = []
            for _ in range(2):
                robot.reset("k")
                free.reset("k")
                robot.step(100)
                free.step(100)
                ends.append(robot.world.read("pose").tobytes())
                np.testing.assert_allclose(robot.qpos[:], free.qpos[:], atol=1e-6)
            self.assertEqual(ends[0], ends[1])
            robot.qpos["c"] = 0.7
            [chain] = robot._tendons.chains.values()
            self.assertAlmostEqual(chain.nodes[-1].position[0], robot.tendons["t"].length, places=12)
            self.assertAlmostEqual(chain.nodes[-1].linear_velocity[0], robot.tendons["t"].rate, places=10)

    def test_weights_and_inertia_are_those_of_the_tree(self):
        with load(finger('range="-1 1" limited="true" armature="0.01"')) as robot, load(finger()) as free:
            np.testing.assert_array_equal(robot.mass_matrix(), free.mass_matrix())
            np.testing.assert_array_equal(robot.gravity_forces(), free.gravity_forces())
            self.assertEqual(robot.mass, free.mass)

    def test_the_solver_is_direct_where_a_chain_stands(self):
        """Its bodies weigh next to nothing. Where two joints are coupled, or a rope holds, the usual one stays."""
        two = '<tendon><fixed name="u"><joint joint="a" coef="1"/><joint joint="b" coef="1"/></fixed></tendon><equality><tendon tendon1="u"/></equality>'
        for text, solver in ((finger(), "auto"), (finger('stiffness="1" damping="1"'), "auto"), (finger(more=two), "auto"),
                             (finger('range="-1 1" limited="true"'), "direct"), (finger('frictionloss="1"'), "direct"), (finger('armature="1"'), "direct"),
                             (finger(more='<equality><tendon tendon1="t"/></equality>'), "direct"),
                             (hung('<spatial limited="true" range="0 9"><site site="post"/><site site="end"/></spatial>'), "auto")):
            with self.subTest(text[-200:]), load(text) as robot:
                self.assertEqual(robot.world.dials["solver"], solver)

    def test_in_a_world_that_is_there(self):
        """Refused or not, what is made is as much as before."""
        with carom.Engine() as engine, engine.world(gravity=(0, 0, -9.81), solver="direct") as world:
            robot = load(finger('range="-.2 .05" limited="true"', dt=0.002), world=world)
            robot.step(300)
            self.assertLess(robot.tendons["t"].length, 0.05 + 1e-9)
            count = world.body_count()
            with self.assertRaises(ModelError):
                load(finger('range="-.2 .05" limited="true" actuatorfrcrange="-1 1"'), world=world, strict=True)
            self.assertEqual(world.body_count(), count)


class Equal(unittest.TestCase):
    """Equalities of tendons."""

    def accelerations(self, text, rows, qpos):
        """Beside M q'' + bias = J^T p, J q'' = 0 with MuJoCo's M and bias, at rest. @param rows  J"""
        with load(text, dt=1e-5, substeps=1) as robot:
            self.assertEqual(robot.left_out, [])
            robot.qpos[:] = qpos
            model = robot._model
            data = mujoco.MjData(model)
            data.qpos[:] = qpos
            mujoco.mj_forward(model, data)
            self.assertLess(float(np.abs(data.efc_pos[:len(rows)]).max()), 1e-12)  # it is held there in MuJoCo
            mass = np.zeros((model.nv, model.nv))
            mujoco.mj_fullM(model, data, mass)
            n, k = model.nv, len(rows)
            whole = np.zeros((n + k, n + k))
            whole[:n, :n], whole[:n, n:], whole[n:, :n] = mass, rows.T, rows
            truth = np.linalg.solve(whole, np.concatenate([-data.qfrc_bias, np.zeros(k)]))[:n]
            robot.step()
            np.testing.assert_allclose(robot.qvel[:] / robot.dt, truth, rtol=0, atol=2e-5 * np.abs(truth).max())  # of what the chain weighs
            for _ in range(500):
                robot.step()
            return robot.qpos[:] - qpos

    def test_of_three_joints(self):
        text = finger(more='<equality><tendon tendon1="t" polycoef="0.03 0 0 0 0"/></equality>')
        q = np.array([0.3, 0.4, 0.1, (0.03 - 0.5 * 0.3 + 1.2 * 0.1) / 2])
        moved = self.accelerations(text, SHARES[None], q)
        self.assertAlmostEqual(float(SHARES @ moved), 0, places=9)

    def test_one_that_follows_another(self):
        more = """<tendon><fixed name="u"><joint joint="b" coef="1"/><joint joint="a" coef="0.3"/></fixed></tendon>
            <equality><tendon tendon1="t" tendon2="u" polycoef="0.01 0.7 0 0 0"/></equality>"""
        row = SHARES - 0.7 * np.array([0.3, 1, 0, 0])
        zero = np.array([0, math.radians(20), 0, 0])
        q = zero + [0.1, -0.2, 0.1, 0]
        q[3] = (0.01 - row[:3] @ (q - zero)[:3]) / row[3]
        moved = self.accelerations(finger(more=more), row[None], q)
        self.assertAlmostEqual(float(row @ moved), 0, places=9)

    def test_of_one_joint_it_locks(self):
        more = '<tendon><fixed name="u"><joint joint="b" coef="2"/></fixed></tendon><equality><tendon tendon1="u" polycoef="0.2 0 0 0 0"/></equality>'
        with load(finger(more=more, dt=0.002)) as robot:
            self.assertEqual(robot.left_out, [])
            robot.step(300)
            self.assertAlmostEqual(float(robot.qpos["b"]), 0.1 + math.radians(20), places=8)

    def test_four_legs_at_once(self):
        """Four fingers on a body that flies, each held by a tendon of three joints: for a second, from where the model was written."""
        legs = "".join(f"""<body pos="{x} {y} 0"><joint name="p{k}" axis="0 1 0"/><geom type="capsule" size=".03" fromto="0 0 0 {x} 0 0" {OFF}/>
            <body pos="{x} 0 0"><joint name="q{k}" axis="0 1 0"/><geom type="capsule" size=".03" fromto="0 0 0 0 0 -.2" {OFF}/>
            <body pos="0 0 -.2"><joint name="r{k}" axis="0 1 0"/><geom type="capsule" size=".02" fromto="0 0 0 .1 0 0" {OFF}/></body></body></body>"""
                       for k, (x, y) in enumerate(((.2, .1), (.2, -.1), (-.2, .1), (-.2, -.1))))
        tendons = "".join(f'<fixed name="t{k}">' + "".join(f'<joint joint="{j}{k}" coef=".333"/>' for j in "pqr") + "</fixed>" for k in range(4))
        held = "".join(f'<tendon tendon1="t{k}"/>' for k in range(4))
        with load(f"""<mujoco><option timestep="0.004"/><worldbody><body pos="0 0 9"><freejoint/><geom type="box" size=".2 .1 .05" {OFF}/>{legs}</body></worldbody>
                <tendon>{tendons}</tendon><equality>{held}</equality></mujoco>""") as robot:
            self.assertEqual(robot.left_out, [])
            robot.qvel["p0"], robot.qvel["q0"] = 3, -3
            robot.qvel["q2"], robot.qvel["r2"] = 5, -5
            for _ in range(250):
                robot.step()
                for k in range(4):
                    self.assertLess(abs(robot.tendons[f"t{k}"].length), 1e-8)
            self.assertGreater(abs(float(robot.qpos["q2"])), 0.2)


def hung(tendon, more="", dt=1e-5, arm="", option=""):
    """An arm whose end a spatial tendon holds to a post; a ball that flies."""
    return f"""<mujoco><option timestep="{dt}" {option}/><worldbody><site name="post" pos=".1 .2 1.6"/><site name="corner" pos="-.2 0 1.5"/>
      <body name="one" pos="0 0 1"><joint name="a" axis="0 1 0" damping="0.1"/><geom type="capsule" size=".03" fromto="0 0 0 .3 0 0" {OFF}/>
        <site name="elbow" pos=".2 .05 .02"/><site name="back" pos=".1 -.04 .02"/>
        <body name="two" pos=".3 0 0"><joint name="b" axis="0 1 .3"/><geom type="capsule" size=".03" fromto="0 0 0 .25 .02 0" {OFF}/>
          <site name="end" pos=".25 0 .03"/>{arm}</body></body>
      <body name="ball" pos=".3 .1 .6"><freejoint/><geom size=".06" {OFF}/><site name="hook" pos="0 .02 .05"/></body></worldbody>
      <tendon>{tendon}</tendon>{more}</mujoco>"""


class Spatial(unittest.TestCase):
    def like_mujoco(self, tendon, within, more="", control=None, moves=1e-4):
        coarse, fine, there = beside(hung(tendon, more), control=control)
        self.assertLess(min(led_to(coarse, fine), float(np.abs(fine).max())), within)
        self.assertGreater(float(np.abs(there - beside(hung(""))[2]).max()), moves)

    def between(self, *sites):
        return "".join(f'<pulley divisor="{site[1:]}"/>' if site.startswith("/") else f'<site site="{site}"/>' for site in sites)

    def test_springs_and_dampers(self):
        """Straight ones, soft: the world's."""
        self.like_mujoco(f'<spatial stiffness="60" springlength="0.3">{self.between("post", "end")}</spatial>', 1e-6)
        self.like_mujoco(f'<spatial stiffness="60" damping="2" springlength="0.3">{self.between("end", "hook")}</spatial>', 1e-6)
        self.like_mujoco(f'<spatial damping="2">{self.between("hook", "end")}</spatial>', 1e-6, moves=1e-5)
        self.like_mujoco(f'<spatial stiffness="90" springlength="0 0.35">{self.between("hook", "end")}</spatial>', 1e-6)

    def test_springs_that_step_finds(self):
        """Of two pieces, behind pulleys, with slack on both sides."""
        for tendon in (f'<spatial stiffness="60" damping="2" springlength="0.9">{self.between("post", "elbow", "end")}</spatial>',
                       f'<spatial stiffness="60" springlength="0.2">{self.between("corner", "post", "/2", "back", "elbow", "hook", "/3", "end", "hook")}</spatial>',
                       f'<spatial stiffness="60" springlength="0.4 0.45">{self.between("post", "end")}</spatial>'):
            self.like_mujoco(tendon, 1e-6)

    def test_actuators(self):
        tendon = f'<spatial name="t">{self.between("corner", "post", "/2", "back", "elbow", "hook", "/3", "end", "hook")}</spatial>'
        self.like_mujoco(tendon, 1e-6, '<actuator><motor tendon="t" gear="-2"/></actuator>', [3.0])
        self.like_mujoco(tendon, 1e-6, '<actuator><position tendon="t" kp="50" kv="1" gear="2"/></actuator>', [0.5])
        self.like_mujoco(f'<spatial name="t">{self.between("end", "hook")}</spatial>', 1e-6, '<actuator><motor tendon="t" ctrlrange="-3 3"/></actuator>', [-9.0])

    def test_a_limit_is_a_rope(self):
        """A ball on a string falls, then hangs: at its end to 1e-9 m, slack before."""
        text = hung(f'<spatial name="t" limited="true" range="0 1.3">{self.between("corner", "hook")}</spatial>', dt=0.002)
        with load(text) as robot:
            self.assertEqual(robot.left_out, [])
            lengths = []
            for _ in range(1500):
                robot.step()
                lengths.append(robot.tendons["t"].length)
            self.assertLess(lengths[0], 1.3)
            self.assertLess(max(lengths), 1.3 + 1e-6)
            self.assertGreater(max(lengths), 1.3 - 1e-9)

    def test_an_equality_is_a_rod(self):
        text = hung(f'<spatial name="t">{self.between("end", "hook")}</spatial>', '<equality><tendon tendon1="t" polycoef="0.02 0 0 0 0"/></equality>', dt=0.002)
        with load(text) as robot:
            self.assertEqual(robot.left_out, [])
            robot.step(50)
            for _ in range(200):
                robot.step()
                self.assertAlmostEqual(robot.tendons["t"].length, float(robot._model.tendon_length0[0]) + 0.02, delta=1e-8)

    def test_lengths_and_sensors(self):
        tendons = (f'<spatial name="t">{self.between("corner", "post", "/2", "back", "elbow", "hook", "/3", "end", "hook")}</spatial>'
                   '<fixed name="f"><joint joint="a" coef="2"/><joint joint="b" coef="-1"/></fixed>')
        sensors = '<sensor><tendonpos tendon="t"/><tendonvel tendon="t"/><tendonpos tendon="f"/><tendonvel tendon="f"/><actuatorpos actuator="m"/><actuatorvel actuator="m"/></sensor>'
        with load(hung(tendons, f'<actuator><motor name="m" tendon="t" gear="-3"/></actuator>{sensors}')) as robot:
            self.assertEqual(robot.left_out, [])
            rng = np.random.default_rng(4)
            for _ in range(5):
                q, v = robot.qpos[:] + 0.2 * rng.normal(size=len(robot.qpos)), rng.normal(size=len(robot.qvel))
                q[5:9] /= np.linalg.norm(q[5:9])
                robot.qpos[:], robot.qvel[:] = q, v
                data = mujoco.MjData(robot._model)
                data.qpos[:], data.qvel[:] = robot.qpos[:], robot.qvel[:]
                mujoco.mj_forward(robot._model, data)
                np.testing.assert_allclose([float(sensor()[0]) for sensor in robot.sensors.values()], data.sensordata, atol=1e-12)
                np.testing.assert_allclose([robot.tendons["t"].length, robot.tendons["f"].length], data.ten_length, atol=1e-12)
                np.testing.assert_allclose([robot.tendons["t"].rate, robot.tendons["f"].rate], data.ten_velocity, atol=1e-12)


class LeftOut(unittest.TestCase):
    def says(self, text, *reasons):
        with load(text) as robot:
            self.assertEqual([f"{left.kind} {left.reason}" for left in robot.left_out], list(reasons))
            robot.step()
        with self.assertRaises(ModelError):
            load(text, strict=True)

    def test_it_is_said(self):
        post, bent = '<site site="post"/><site site="end"/>', '<site site="post"/><site site="elbow"/><site site="hook"/>'
        arm = '<geom name="knob" type="sphere" size=".02" pos=".1 0 0" contype="0" conaffinity="0"/>'
        winds = '<site site="post"/><geom geom="knob"/><site site="hook"/>'
        self.says(hung(f'<spatial frictionloss="1" armature="0.1">{post}</spatial>'), "tendon friction and armature: a spatial tendon here has none")
        self.says(hung(f'<spatial limited="true" range="0 1">{bent}</spatial>'), "tendon a limit: it bends at a site that moves: a distance joint is straight")
        self.says(hung(f'<spatial stiffness="2" damping="1">{winds}</spatial>', arm=arm),
                  "tendon stiffness and damping: it winds about a geom: tendons here lead straight from site to site")
        self.says(hung(f'<spatial name="t">{winds}</spatial>', '<actuator><motor tendon="t"/></actuator><sensor><tendonpos tendon="t"/></sensor>', arm=arm),
                  "actuator its tendon winds about a geom", "sensor its tendon winds about a geom")
        self.says(hung(f'<spatial name="t">{winds}</spatial>', '<equality><tendon tendon1="t"/></equality>', arm=arm), "equality its tendon winds about a geom")
        self.says(hung(f'<spatial name="t">{bent}</spatial>', '<equality><tendon tendon1="t"/></equality>'),
                  "equality of a tendon that bends at a site that moves: a distance joint is straight")
        more = '<tendon><fixed name="u"><joint joint="b" coef="1"/></fixed></tendon><equality><tendon tendon1="t" tendon2="u" polycoef="{}"/></equality>'
        self.says(finger(more=more.format("0 1 .5 0 0")), "equality a tendon that follows another by more than a line")
        self.says(finger('actuatorfrcrange="-1 1"'), "tendon actuatorfrcrange: what pulls by it has its own forcerange alone")

    def test_options_switch_them_off(self):
        flags = "<option><flag {}='disable'/></option>"
        for what, flag in (('range="-.1 .1" limited="true"', "limit"), ('stiffness="90"', "spring"), ('damping="9"', "damper"), ('frictionloss="9"', "frictionloss"),
                           ('range="-.1 .1" limited="true" frictionloss="3"', "constraint")):
            with self.subTest(flag), load(finger(what, flags.format(flag), dt=0.002)) as robot, load(finger(dt=0.002)) as free:
                robot.step(50)
                free.step(50)
                self.assertEqual((len(robot._tendons.chains), robot.left_out), (0, []))
                np.testing.assert_array_equal(robot.qpos[:], free.qpos[:])


class Saved(unittest.TestCase):
    TEXT = finger('range="-.2 .05" limited="true" frictionloss="0.01" armature="0.001"', '<equality><tendon tendon1="u"/></equality>'
                  '<tendon><fixed name="u"><joint joint="a" coef="1"/><joint joint="b" coef="1"/><joint joint="d" coef="1"/></fixed></tendon>', dt=0.002)

    def test_another_process_goes_on_without_mujoco(self):
        with tempfile.TemporaryDirectory() as folder, load(self.TEXT) as robot:
            self.assertEqual(robot.left_out, [])
            file, beside_it = robot.save(Path(folder) / "finger.carom")
            names = json.loads(beside_it.read_text())
            self.assertEqual(names["tendons"]["t"]["shares"], {"a": 0.5, "c": -1.2, "d": 2.0})
            program = f"""
import json, sys
sys.modules["mujoco"] = None
import carom
names = json.load(open({str(beside_it)!r}))
with carom.Engine() as engine, engine.world() as world:
    world.restore(open({str(file)!r}, "rb").read())
    for _ in range(300):
        world.step(names["dt"])
    print(*map(float.hex, world.read_joints("position", [world.joints[names["joints"][name]["joint"]] for name in "abcd"])[:, 0]))
    print(world.joints[names["tendons"]["t"]["end"]].state.axis["x"])
"""
            said = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
            self.assertEqual(said.stderr, "")
            robot.step(300)
            coordinates, length = said.stdout.splitlines()
            self.assertEqual([float.fromhex(one) for one in coordinates.split()],
                             list(robot.world.read_joints("position", [robot.joints[name] for name in "abcd"])[:, 0]))
            self.assertAlmostEqual(float(length), robot.tendons["t"].length - float(robot._model.tendon_length0[0]), places=12)
            self.assertLess(robot.tendons["t"].length, 0.05 + 1e-9)

    def test_in_a_batch(self):
        """A force on the last body of a chain pulls the tendon; worlds differ by it, and equal ones are equal to the bit."""
        with load(self.TEXT) as robot:
            batch = carom.Batch(robot.world, 4)
            last = robot.tendons["t"].chain.nodes[-1]
            force = batch.column("bodies", "force", [last], when="before_step")
            place = batch.column("bodies", "position", [last], when="after_step")
            force.array[:, 0, 0] = (-20, 0, -20, 0)
            batch.step(robot.dt, 40)
            hashes = batch.hashes()
            self.assertEqual((hashes[0], hashes[1]), (hashes[2], hashes[3]))
            self.assertLess(place.array[0, 0, 0], place.array[1, 0, 0] - 0.05)
            robot.step(40)
            self.assertEqual(int(hashes[1]), robot.world.hash)


if __name__ == "__main__":
    unittest.main()
