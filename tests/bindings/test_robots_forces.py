"""What acts on robots of carom.robots beside joints and tendons: friction of pairs, a fluid, adhesion, resistance of what flies; and sensors
of whole subtrees. Each beside MuJoCo or a closed form.

Needs MuJoCo 4 (pip install mujoco-core, Python 3.11), and is skipped without it.
"""
import json
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

import carom.robots

G = 9.81


def load(text, **about):
    return carom.robots.load(mujoco.MjSpec.from_string(text), **about)


def beside(robot, seconds, step=1e-5, integrator="mjINT_RK4"):
    """@return MuJoCo's data after so long, from the robot's place, which goes on as long"""
    model = robot._model
    model.opt.timestep, model.opt.integrator = step, getattr(mujoco.mjtIntegrator, integrator)
    data = mujoco.MjData(model)
    data.qpos[:], data.qvel[:], data.ctrl[:] = robot.qpos[:], robot.qvel[:], robot.ctrl[:]
    for _ in range(round(seconds / step)):
        mujoco.mj_step(model, data)
    robot.step(round(seconds / robot.dt))
    return data


class Friction(unittest.TestCase):
    def slowed(self, floor, *boxes, more=""):
        """@return friction of each box that slides on a floor, from how it slows down"""
        bodies = "".join(f'<body name="b{k}" pos="0 {k} .1"><freejoint/><geom name="box{k}" type="box" size=".1 .1 .1" {about}/></body>'
                         for k, about in enumerate(boxes))
        with load(f"""<mujoco><option timestep="0.001"/><worldbody><geom name="floor" type="plane" size="9 9 9" {floor}/>{bodies}</worldbody>{more}
                </mujoco>""") as robot:
            self.assertEqual(robot.left_out, [])
            robot.step(100)
            speeds = robot.qvel[:]
            speeds[::6] = 3
            robot.qvel[:] = speeds
            robot.step(300)
            return (3 - robot.qvel[:][::6]) / 0.3 / G

    def expect(self, found, *wanted):
        np.testing.assert_allclose(found, wanted, atol=0.01)

    def test_the_larger_number_of_two_whatever_their_dimensions(self):
        self.expect(self.slowed('friction=".7"', 'friction=".9" condim="1"', 'friction=".3" condim="1"', 'friction=".8" condim="6"'), 0.9, 0.7, 0.8)

    def test_a_higher_priority_decides_alone(self):
        self.expect(self.slowed('friction=".7"', 'friction=".2 .02 .01" condim="6" priority="1"', 'friction=".5"'), 0.2, 0.7)
        self.expect(self.slowed('friction=".6" priority="2"', 'friction=".9" priority="1"', 'friction=".1" condim="4"'), 0.6, 0.6)

    def test_pairs(self):
        pair = '<contact><pair geom1="box1" geom2="floor" friction=".35 .35 .005 .0001 .0001"/></contact>'
        self.expect(self.slowed('friction=".7"', 'friction=".5"', 'friction=".5"', more=pair), 0.7, 0.35)
        self.expect(self.slowed('friction=".7"', 'friction=".9"', 'friction=".9"', more=pair.replace(".35 .35", ".05 .05")), 0.9, 0.05)

    def test_a_ball_of_high_priority_rolls_to_a_halt(self):
        """By its own resistance to rolling, 2 cm, and not by the floor's: a = d g / (7/5 r)."""
        with load("""<mujoco><option timestep="0.001"/><worldbody><geom type="plane" size="9 9 9" friction="1 .5 .5" condim="3"/><body name="b" pos="0 0 .2">
                <freejoint/><geom size=".2" friction=".9 .001 .02" condim="6" priority="1"/></body></worldbody></mujoco>""") as robot:
            self.assertEqual(robot.left_out, [])
            robot.qvel[:] = [2, 0, 0, 0, 10, 0]
            robot.step(500)
            self.assertAlmostEqual(float(robot.qvel[0]), 2 - 0.5 * 0.02 * G / (1.4 * 0.2), delta=0.01)

    def test_a_direction_of_its_own_is_said(self):
        with load("""<mujoco><worldbody><geom name="f" type="plane" size="9 9 9"/><body><freejoint/><geom name="g" size=".2"/></body></worldbody>
                <contact><pair geom1="f" geom2="g" friction=".5 .1 .005 .0001 .0001"/></contact></mujoco>""") as robot:
            self.assertIn("differs by direction", robot.left_out[0].reason)


SWIMMERS = {
    "a box of inertia": '<body pos="0 0 1"><freejoint/><geom type="box" size=".1 .2 .3" pos=".1 0 .2"/></body>',
    "ellipsoids": """<body pos="0 0 1" euler="10 20 30"><freejoint/><geom type="capsule" size=".1 .2" pos=".1 0 .2" euler="30 0 0"
        fluidshape="ellipsoid" fluidcoef=".5 .3 1.2 .7 .8"/><body pos=".3 .1 0"><joint axis="1 1 0"/><geom type="ellipsoid" size=".1 .2 .07"
        fluidshape="ellipsoid"/><geom type="cylinder" size=".1 .05" pos=".2 0 0" fluidshape="ellipsoid"/></body></body>""",
    "both": """<body pos="0 0 1"><freejoint/><geom size=".1" fluidshape="ellipsoid"/><body pos="0 .3 0"><joint/><geom type="box" size=".1 .05 .2"
        pos="0 .1 0"/><body pos="0 .3 0"><joint type="slide" axis="1 0 1"/><geom type="box" size=".1 .05 .1" fluidshape="ellipsoid"/></body></body></body>""",
}


class Fluids(unittest.TestCase):
    def text(self, bodies, option='density="30" viscosity=".2" wind="1 -2 .5"'):
        return f'<mujoco><option timestep="1e-5" gravity="0 0 0" {option}/><worldbody>{bodies}</worldbody></mujoco>'

    def test_forces_and_motion(self):
        for name, bodies in SWIMMERS.items():
            with self.subTest(name), load(self.text(bodies)) as robot:
                self.assertEqual(robot.left_out, [])
                rng = np.random.default_rng(1)
                robot.qvel[:] = rng.normal(size=len(robot.qvel))
                start = robot.qpos[:]
                data = beside(robot, 0.05)
                self.assertLess(np.abs(robot.qpos[:] - data.qpos).max(), 2e-6)  # forces are a step's beginning's: of first order
                self.assertGreater(np.abs(robot.qpos[:] - start).max(), 1e-2)

    def test_what_falls_reaches_its_final_speed(self):
        """Of a cube of edge a: m g = density / 2 a^2 v^2."""
        with load("""<mujoco><option timestep="0.002" density="1000" integrator="Euler"/><worldbody><body><freejoint/><geom type="box" size=".1 .1 .1"
                density="3000"/></body></worldbody></mujoco>""") as robot:
            robot.step(2000)
            self.assertAlmostEqual(float(robot.qvel[2]), -(2 * 3000 * 0.2 ** 3 * G / (1000 * 0.2 ** 2)) ** 0.5, places=6)

    def test_nothing_acts_where_springs_and_dampers_are_off(self):
        with load(self.text(SWIMMERS["both"]).replace("<worldbody>", '<option><flag spring="disable" damper="disable"/></option><worldbody>', 1)) as robot:
            robot.qvel[0] = 1.0
            robot.step(10)
            self.assertAlmostEqual(float(robot.qvel[0]), 1.0, places=9)

    def test_what_is_saved_tells_of_it(self):
        with load(self.text(SWIMMERS["both"])) as robot, tempfile.TemporaryDirectory() as folder:
            names = json.loads(robot.save(Path(folder) / "fish.carom")[1].read_text(encoding="utf-8"))
            self.assertEqual(names["fluid"], {"density": 30, "viscosity": 0.2, "wind": [1, -2, 0.5]})


class Adhesion(unittest.TestCase):
    TEXT = """<mujoco><option timestep="0.002"/><worldbody><geom type="box" size="1 1 .1" pos="0 0 1.1"/><body name="b" pos="0 0 .9"><freejoint/>
        <geom type="{kind}" size="{size}" mass="3"/></body></worldbody>
        <actuator><adhesion name="glue" body="b" ctrlrange="0 1" gain="60"/></actuator></mujoco>"""

    def hangs(self, kind, size, control):
        with load(self.TEXT.format(kind=kind, size=size)) as robot:
            self.assertEqual(robot.left_out, [])
            robot.ctrl["glue"] = control
            robot.qvel[2] = 0.1  # against the ceiling
            robot.step(5)
            data = beside(robot, 0.5, 0.002, "mjINT_EULER")
            self.assertEqual(float(robot.qpos[2]) > 0.8, data.qpos[2] > 0.8)
            return float(robot.qpos[2]) > 0.8

    def test_it_holds_what_it_can_bear(self):
        for kind, size in (("box", ".1 .1 .1"), ("sphere", ".1"), ("cylinder", ".2 .1")):
            with self.subTest(kind):
                self.assertTrue(self.hangs(kind, size, 40 / 60))  # N, of 29.4
                self.assertFalse(self.hangs(kind, size, 20 / 60))

    def test_it_presses_on_the_floor(self):
        """Touch: weight and pull."""
        with load("""<mujoco><worldbody><geom type="plane" size="1 1 1"/><body name="b" pos="0 0 .1"><freejoint/><geom type="box" size=".1 .1 .1" mass="2"/>
                <site name="s" type="box" size=".2 .2 .2"/></body></worldbody><actuator><adhesion body="b" ctrlrange="0 1" gain="50"/></actuator>
                <sensor><touch name="t" site="s"/></sensor></mujoco>""") as robot:
            robot.ctrl[:] = [0.5]
            robot.step(300)
            self.assertAlmostEqual(float(robot.sensors["t"]()[0]), 2 * G + 25, delta=1e-3)


class Flying(unittest.TestCase):
    BODY = '<inertial pos="{at}" mass="2" diaginertia=".1 .2 .25"/>'

    def test_rotor_and_damping_of_a_free_joint(self):
        for about in ('armature=".5"', 'damping=".7"', 'armature=".2" damping="3"'):
            for at in ("0 0 0", ".1 .05 -.02"):
                with self.subTest(about=about, at=at), load(f"""<mujoco><option timestep="1e-5"/><worldbody><body pos="0 0 1"><joint type="free" {about}/>
                        {self.BODY.format(at=at)}<body pos=".2 0 0"><joint axis="0 1 0"/><geom size=".05" pos="0 0 .2"/></body></body></worldbody></mujoco>""",
                        dt=1e-5) as robot:
                    self.assertEqual(robot.left_out, [])
                    start = np.array([1, -2, 0.5, 1, 2, 0.5, 1])
                    robot.qvel[:] = start
                    data = beside(robot, 0.05)
                    slowed = np.abs(data.qvel - start).max() if "damping" in about else 0
                    self.assertLess(np.abs(robot.qpos[:] - data.qpos).max(), 1e-6 + robot.dt / 2 * slowed)  # dampers: of first order
                    whole = np.zeros((7, 7))
                    data.qpos[:] = robot.qpos[:]
                    mujoco.mj_forward(robot._model, data)
                    mujoco.mj_fullM(robot._model, data, whole)
                    np.testing.assert_allclose(robot.mass_matrix(), whole, atol=1e-9)  # the hinge's drift

    def test_friction_of_a_free_joint(self):
        """4 N along each axis, and 4 N m about each: 2 kg slow down by 2 m/s^2, and a body at rest stays."""
        with load("""<mujoco><option timestep="0.001" gravity="0 0 0"/><worldbody><body><joint type="free" frictionloss="4"/>
                <inertial pos="0 0 0" mass="2" diaginertia="1 1 1"/></body></worldbody></mujoco>""") as robot:
            self.assertEqual(robot.left_out, [])
            robot.qvel[:] = [3, 0, 0, 0, 0, 5]
            robot.step(1000)
            np.testing.assert_allclose(robot.qvel[:], [1, 0, 0, 0, 0, 1], atol=1e-2)
            robot.step(2000)
            np.testing.assert_allclose(robot.qvel[:], 0, atol=1e-6)


class Standing(unittest.TestCase):
    """Servos and springs bear what contacts press on, whatever their damping: once those without any bore nothing on the ground."""

    LEG = """<mujoco><option timestep="{dt}"/><worldbody><geom type="plane" size="1 1 1"/><body pos="0 0 .288"><joint type="slide" axis="0 0 1"/>
        <geom type="box" size=".05 .05 .02" mass="2.5"/><body euler="0 51.5 0"><joint name="hip" axis="0 1 0" damping="2"/>
        <geom type="capsule" size=".02" fromto="0 0 0 0 0 -.213" mass=".5" contype="0" conaffinity="0"/><body pos="0 0 -.213">
        <joint name="knee" axis="0 1 0" damping="{damping}"/><geom type="capsule" size=".02" fromto="0 0 0 0 0 -.213" mass=".2" contype="0" conaffinity="0"/>
        <geom size=".022" pos="0 0 -.213"/></body></body></body></worldbody>
        <actuator><position joint="hip" kp="100" kv="{kv}"/><position joint="knee" kp="100" kv="{kv}"/></actuator>
        <keyframe><key qpos="0 0 -1.8" ctrl="0 -1.8"/></keyframe></mujoco>"""

    def torque(self, robot, joint):
        return float(robot.joints[joint].state.torque[1])

    def test_a_leg_by_servos(self):
        """Beside statics: the knee's servo bears the load at the foot, kp times how far it gave way, within what friction of the foot changes."""
        for dt, kv, damping, dials in ((0.002, 0, 2, {}), (0.002, 1e-6, 2, {}), (0.002, 0.1, 2, {}), (0.002, 1, 2, {}), (0.002, 0, 2, dict(substeps=4)),
                                       (0.002, 0, 2, dict(solver="direct")), (0.0005, 0, 0.5, {})):
            with self.subTest(dt=dt, kv=kv, dials=dials), load(self.LEG.format(dt=dt, kv=kv, damping=damping), **dials) as robot:
                robot.reset(0)
                robot.step(round(2 / dt))
                self.assertLess(np.abs(robot.qvel[:]).max(), 1e-3)
                self.assertAlmostEqual(self.torque(robot, "knee"), 100 * (-1.8 - float(robot.qpos["knee"])), delta=0.02)
                self.assertLess(abs(float(robot.qpos["knee"]) + 1.8), 0.1)
                self.assertAlmostEqual(sum(c.normal_impulse for c in robot.world.contacts()) / dt, robot.mass * G, delta=1e-2)

    def test_a_beam_on_a_spring_and_a_prop(self):
        """A beam on a hinge with a spring of 80 N m/rad lies on a block: the block bears what the spring does not."""
        with load("""<mujoco><option timestep="0.002"/><worldbody><geom type="box" size=".1 .1 .1" pos=".9 0 -.12"/><body>
                <joint name="j" axis="0 1 0" stiffness="80" springref="-3"/><geom type="box" size=".5 .05 .02" pos=".5 0 0" mass="2"/></body></worldbody>
                </mujoco>""") as robot:
            robot.step(1000)
            self.assertAlmostEqual(float(robot.qpos["j"]), 0, delta=1e-3)
            at = [c for c in robot.world.contacts() if c.normal_impulse]
            borne = sum(c.normal_impulse * c.point[0] for c in at) / 0.002
            self.assertAlmostEqual(borne, 2 * G * 0.5 - 80 * (3 / 180 * np.pi + float(robot.qpos["j"])), delta=0.02)

    def test_a_finger_presses_on_a_wall(self):
        """A slide's servo of 500 N/m that aims 2 cm into a wall presses with 10 N; on the tip of an arm, 40 cm long, 5 N m press with 12.5 N."""
        with load("""<mujoco><option timestep="0.002" gravity="0 0 0"/><worldbody><geom type="box" size=".1 1 1" pos="1 0 0"/><body>
                <joint name="s" type="slide" axis="1 0 0"/><geom size=".1" pos=".8 0 0" mass="1"/></body></worldbody>
                <actuator><position joint="s" kp="500"/></actuator></mujoco>""") as robot:
            robot.ctrl[:] = [0.02]
            robot.step(500)
            self.assertAlmostEqual(sum(c.normal_impulse for c in robot.world.contacts()) / 0.002, 10, delta=0.05)
        with load("""<mujoco><option timestep="0.002" gravity="0 0 0"/><worldbody><geom type="box" size="1 1 .1" pos="0 0 -.15"/><body>
                <joint name="a" axis="0 1 0" damping=".5"/><geom type="capsule" size=".02" fromto="0 0 0 .4 0 0" mass=".3" contype="0" conaffinity="0"/>
                <body pos=".4 0 0"><joint name="b" axis="0 1 0" damping=".1"/><geom size=".05" mass=".2" friction="0" condim="1"/></body></body></worldbody>
                <actuator><position joint="a" kp="100"/><position joint="b" kp="20"/></actuator></mujoco>""") as robot:
            robot.ctrl["actuator 0"] = 0.05
            robot.step(1000)
            self.assertAlmostEqual(sum(c.normal_impulse for c in robot.world.contacts()) / 0.002 * 0.4, 100 * (0.05 - float(robot.qpos["a"])), delta=0.05)


class Subtrees(unittest.TestCase):
    TEXT = """<mujoco><option timestep="1e-5"/><worldbody><body name="post" pos="0 0 2"><geom size=".1" mass="3"/><body name="arm" pos=".2 0 0"><joint axis="0 1 0"/>
        <geom type="capsule" size=".03" fromto="0 0 0 .3 .1 0"/><body name="plate" pos=".3 .1 0" euler="0 30 0"><geom type="box" size=".1 .02 .05" pos="0 .1 0"/>
        <body name="tip" pos="0 .2 0"><joint type="ball"/><geom type="ellipsoid" size=".02 .03 .1" pos=".1 0 0"/></body></body></body></body>
        <body name="flyer" pos="2 0 0"><freejoint/><geom type="box" size=".1 .2 .3" pos=".05 0 0"/></body></worldbody>
        <sensor>{sensors}</sensor></mujoco>"""

    def test_of_every_body(self):
        bodies = ("world", "post", "arm", "plate", "tip", "flyer")
        sensors = "".join(f'<{kind} name="{kind} {body}" body="{body}"/>' for kind in ("subtreecom", "subtreelinvel", "subtreeangmom") for body in bodies)
        with load(self.TEXT.format(sensors=sensors)) as robot:
            self.assertEqual(robot.left_out, [])
            robot.qvel[:] = np.random.default_rng(4).normal(size=len(robot.qvel))
            data = beside(robot, 0.02)
            mujoco.mj_forward(robot._model, data)
            for k, (name, sensor) in enumerate(robot.sensors.items()):
                np.testing.assert_allclose(sensor(), data.sensordata[3 * k:3 * k + 3], atol=1e-6, err_msg=name)

    def test_touch_of_what_does_not_move(self):
        with load("""<mujoco><worldbody><geom type="plane" size="1 1 1" pos="0 0 -1"/><body name="scale" pos="0 0 .5"><geom type="box" size=".3 .3 .1"/>
                <site name="s" type="box" size=".3 .3 .11"/></body><body pos="0 0 .7"><freejoint/><geom type="box" size=".1 .1 .1" mass="3"/></body>
                <body name="bare"><site name="none" type="box" size="1 1 1"/></body></worldbody>
                <sensor><touch name="weight" site="s"/><touch name="nothing" site="none"/></sensor></mujoco>""") as robot:
            self.assertEqual(robot.left_out, [])
            robot.step(500)
            self.assertAlmostEqual(float(robot.sensors["weight"]()[0]), 3 * G, delta=1e-3)
            self.assertEqual(float(robot.sensors["nothing"]()[0]), 0.0)


if __name__ == "__main__":
    unittest.main()
