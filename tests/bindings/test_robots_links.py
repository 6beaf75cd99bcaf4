"""What links of carom.robots weigh where a file says what MuJoCo refuses, and meshes: Collada, and margins of meshes.

Needs MuJoCo 4 (pip install mujoco-core, Python 3.11), and is skipped without it.
"""
import sys
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

SKIPPED = 77  # what CTest takes for skipped
try:
    import mujoco
    import numpy as np
except ImportError as why:
    print(f"skipped: {why} (pip install mujoco-core)")
    sys.exit(SKIPPED)

import carom.robots
from carom.robots import collada


def link(name, mass, moments, at="0 0 0", turn="0 0 0", mesh=""):
    xx, yy, zz, xy, xz, yz = moments
    inertial = "" if mass is None else (f'<inertial><origin xyz="{at}" rpy="{turn}"/><mass value="{mass}"/><inertia ixx="{xx}" iyy="{yy}" izz="{zz}" '
                                        f'ixy="{xy}" ixz="{xz}" iyz="{yz}"/></inertial>')
    shape = f'<collision><geometry><mesh filename="{mesh}"/></geometry></collision>' if mesh else ""
    return f'<link name="{name}">{inertial}{shape}</link>'


def joint(parent, child, kind="revolute", at="0 0 0", axis="0 0 1", turn="0 0 0"):
    return (f'<joint name="to {child}" type="{kind}"><parent link="{parent}"/><child link="{child}"/><origin xyz="{at}" rpy="{turn}"/><axis xyz="{axis}"/>'
            f'<limit lower="-3" upper="3" effort="9" velocity="9"/></joint>')


class Folder(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = Path(held.name)

    def load(self, *parts, **about):
        file = self.folder / "robot.urdf"
        file.write_text(f'<robot name="r"><link name="base"/>{"".join(parts)}</robot>', encoding="utf-8")
        return carom.robots.load(file, **about)

    def same_inertia(self, robot):
        """As MuJoCo's of the same numbers."""
        model = robot._model
        data = mujoco.MjData(model)
        robot.qpos[:] = data.qpos[:] = np.random.default_rng(2).uniform(-1, 1, model.nq)
        mujoco.mj_forward(model, data)
        whole = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, whole)
        np.testing.assert_allclose(robot.mass_matrix(), whole, rtol=1e-6, atol=1e-6 * np.abs(whole).max())
        np.testing.assert_allclose(robot.gravity_forces(), data.qfrc_bias, atol=1e-9 * max(1, np.abs(data.qfrc_bias).max()))


class Weights(Folder):
    def test_moments_that_break_the_triangle_count_as_they_are(self):
        with self.load(link("a", 2, (0.01, 0.02, 0.05, 0, 0, 0.001), "0.1 0 0", "0.3 0.2 0.1"), joint("base", "a")) as robot:
            self.assertEqual(robot.left_out, [])
            turn = np.array([[0, -0.1, 0.2], [0.1, 0, -0.3], [-0.2, 0.3, 0]])
            angle = 0.1, 0.2, 0.3  # z, y, x
            c, s = np.cos(angle), np.sin(angle)
            turn = (np.array([[c[0], -s[0], 0], [s[0], c[0], 0], [0, 0, 1]]) @ np.array([[c[1], 0, s[1]], [0, 1, 0], [-s[1], 0, c[1]]])
                    @ np.array([[1, 0, 0], [0, c[2], -s[2]], [0, s[2], c[2]]]))
            said = np.array([[0.01, 0, 0], [0, 0.02, 0.001], [0, 0.001, 0.05]])
            self.assertAlmostEqual(robot.mass_matrix()[0, 0], (turn @ said @ turn.T)[2, 2] + 2 * 0.1 ** 2, places=12)
            self.same_inertia(robot)

    def test_the_sum_of_what_is_fixed_together_counts(self):
        """A part has a moment below 0, and the link has none."""
        with self.load(link("a", 1, (0.02, 0.02, 0.02, 0, 0, 0)), link("part", 0.1, (-0.001, 0.001, 0.004, 0.0005, 0, 0), "0 0.1 0"),
                       joint("base", "a", axis="1 1 0"), joint("a", "part", "fixed", "0 0 0.1")) as robot:
            self.assertEqual(robot.left_out, [])
            self.assertAlmostEqual(robot.mass, 1.1, places=12)
            self.same_inertia(robot)

    def test_a_base_that_stands_has_no_inertia_that_matters(self):
        with self.load(link("a", 5, (-1, 0.1, 3, 0, 0, 0)), link("b", 1, (0.1, 0.1, 0.1, 0, 0, 0), "0 0.3 0"), joint("base", "a", "fixed"),
                       joint("a", "b", axis="1 0 0")) as robot:
            self.assertEqual(robot.left_out, [])
            self.same_inertia(robot)
        with self.load(link("a", 5, (-1, 0.1, 3, 0, 0, 0)), joint("base", "a", "fixed"), floating=True) as robot:
            self.assertIn("a thousandth of its largest stands in", robot.left_out[0].reason)

    def test_links_that_weigh_nothing_between_two_that_do(self):
        for axes in (("0 0 1", "1 0 0"), ("0 0 1", "1 0 0", "0 1 0"), ("0 1 0", "0 0.6 0.8", "1 0 0")):
            parts = [link("a", 3, (0.1, 0.1, 0.1, 0, 0, 0), "0 0 0.2"), joint("base", "a", axis="0 1 0")]
            before = "a"
            for k, axis in enumerate(axes[:-1]):
                parts += [link(f"v{k}", None, (0,) * 6), joint(before, f"v{k}", at="0 0 0.4" if k == 0 else "0 0 0", axis=axis)]
                before = f"v{k}"
            parts += [link("z", 2, (0.03, 0.02, 0.01, 0.001, 0, 0), "0.1 0 0.2"), joint(before, "z", axis=axes[-1])]
            with self.subTest(axes=axes), self.load(*parts) as robot:
                self.assertEqual(robot.left_out, [])
                self.assertAlmostEqual(robot.mass, 5, places=12)
                self.same_inertia(robot)

    def test_a_point_that_a_hinge_carries(self):
        with self.load(link("a", 3, (0.1, 0.1, 0.1, 0, 0, 0), "0 0 0.2"), link("p", 0.5, (0,) * 6, "0 0.3 0"), joint("base", "a", axis="0 1 0"),
                       joint("a", "p", at="0 0 0.4", axis="1 0 0")) as robot:
            self.assertEqual(robot.left_out, [])
            self.assertAlmostEqual(robot.mass, 3.5, places=12)
            self.same_inertia(robot)

    def test_what_moves_and_carries_nothing_is_said(self):
        with self.load(link("a", 3, (0.1, 0.1, 0.1, 0, 0, 0), "0 0 0.2"), link("tip", None, (0,) * 6), joint("base", "a", axis="0 1 0"),
                       joint("a", "tip", at="0 0 0.4", axis="1 0 0")) as robot:
            self.assertEqual([(left.kind, left.names) for left in robot.left_out], [("body", ("tip",))])
            self.assertIn("nothing that it carries weighs anything", robot.left_out[0].reason)


def dae(nodes, points, faces, unit="1", up="Z_UP"):
    return f"""<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit meter="{unit}"/><up_axis>{up}</up_axis></asset>
      <library_geometries><geometry id="g"><mesh><source id="p"><float_array id="f" count="{3 * len(points)}">{" ".join(str(x) for p in points for x in p)}</float_array>
      <technique_common><accessor source="#f" count="{len(points)}" stride="3"/></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
      {faces}</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s">{nodes}</visual_scene></library_visual_scenes>
      <scene><instance_visual_scene url="#s"/></scene></COLLADA>"""


BOX = [(x, y, z) for x in (-1, 1) for y in (-2, 2) for z in (-3, 3)]
SIDES = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
TRIANGLES = '<triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/><p>' + " ".join(
    f"{a} {b} {c} {a} {c} {d}" for a, b, c, d in SIDES) + "</p></triangles>"
POLYGONS = ('<polylist count="6"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="NORMAL" source="#v" offset="1"/><vcount>4 4 4 4 4 4</vcount><p>'
            + " ".join(f"{i} 0" for side in SIDES for i in side) + "</p></polylist>")
SHOWN = '<instance_geometry url="#g"/>'


class Collada(Folder):
    def corners(self, text):
        """m, each once"""
        found = collada.triangles(ElementTree.fromstring(text))
        self.assertEqual(len(found), 36)
        return np.unique(np.round(found, 6) + 0.0, axis=0)

    def left_out(self, text):
        (self.folder / "mesh.dae").write_text(text, encoding="utf-8")
        with self.load(link("a", 1, (0.1, 0.1, 0.1, 0, 0, 0), mesh="mesh.dae"), joint("base", "a")) as robot:
            return robot.left_out[0]

    def box(self, x, y, z, at=(0, 0, 0)):
        return np.array(sorted((at[0] + i * x, at[1] + j * y, at[2] + k * z) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)))

    def same(self, found, wanted):
        self.assertEqual(np.shape(found), wanted.shape, found)
        np.testing.assert_allclose(found, wanted, atol=2e-6)

    def test_triangles_and_polygons(self):
        for faces in (TRIANGLES, POLYGONS):
            self.same(self.corners(dae(f"<node>{SHOWN}</node>", BOX, faces)), self.box(1, 2, 3))

    def test_units_and_axes(self):
        self.same(self.corners(dae(f"<node>{SHOWN}</node>", BOX, TRIANGLES, unit="0.01", up="Y_UP")), self.box(0.01, 0.02, 0.03))

    def test_nodes(self):
        """Moved, then turned by 90 degrees about z, then twice as large along its own x: the last is done first."""
        steps = "<translate>10 0 0</translate><rotate>0 0 1 90</rotate><scale>2 1 1</scale>"
        self.same(self.corners(dae(f"<node>{steps}{SHOWN}</node>", BOX, TRIANGLES)), self.box(2, 2, 3, (10, 0, 0)))
        inner = f'<node><matrix>1 0 0 0  0 1 0 5  0 0 1 0  0 0 0 1</matrix>{SHOWN}</node>'
        self.same(self.corners(dae(f"<node>{steps}{inner}</node>", BOX, TRIANGLES)), self.box(2, 2, 3, (5, 0, 0)))

    def test_it_rests_where_it_is_as_high(self):
        (self.folder / "mesh.dae").write_text(dae(f"<node>{SHOWN}</node>", BOX, POLYGONS, unit="0.1"), encoding="utf-8")
        spec = mujoco.MjSpec.from_string('<mujoco><worldbody><geom type="plane" size="1 1 1"/></worldbody></mujoco>')
        spec.add_mesh(name="m", file=str(self.folder / "mesh.dae"))
        body = spec.worldbody.add_body(name="b", pos=[0, 0, 0.32])
        body.add_freejoint()
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="m")
        with carom.robots.load(spec) as robot:
            self.assertEqual(robot.left_out, [])
            self.assertAlmostEqual(robot.mass, 1000 * 0.2 * 0.4 * 0.6, delta=1e-4)  # corners are single precision
            robot.step(500)
            self.assertAlmostEqual(float(robot.pose("b")[0][2]), 0.3, delta=2e-4)

    def test_what_is_damaged_is_left_out_and_said(self):
        good = dae(f"<node>{SHOWN}</node>", BOX, TRIANGLES)
        deep = dae("<node>" * 200 + SHOWN + "</node>" * 200, BOX, TRIANGLES)
        for text, why in ((good.replace("<p>0 1", "<p>0 99"), "points at no corner"), (good.replace('url="#g"', 'url="#none"'), "no Collada that can be read"),
                          (good.replace("-1 -2 -3", "nan -2 -3"), "not finite"), (good.replace("-1 -2 -3", "x -2 -3"), "no Collada that can be read"),
                          (good.replace('offset="0"', 'offset="-7"'), "no Collada that can be read"), (deep, "deep"),
                          (good.replace(SHOWN, ""), "shows no triangles"), (good.replace(SHOWN, '<instance_node url="#s"/>'), "instance_node"),
                          (dae(f"<node>{SHOWN}</node>", BOX, POLYGONS.replace("<vcount>4", "<vcount>9")), "does not add up")):
            with self.subTest(why):
                left = self.left_out(text)
                self.assertEqual(left.kind, "geom")
                self.assertIn(why, left.reason)
        for text in (good[:300], good.replace("<asset>", "<!DOCTYPE x><asset>")):
            with self.assertRaises(carom.robots.ModelError):
                self.left_out(text)


class Margins(unittest.TestCase):
    def test_a_mesh_is_held_off_by_its_margin(self):
        spec = mujoco.MjSpec.from_string('<mujoco><worldbody><geom type="plane" size="1 1 1" margin=".01"/></worldbody></mujoco>')
        spec.add_mesh(name="m", uservert=[x / 10 for corner in BOX for x in corner])
        for k, margin in enumerate((0.0, 0.02, 0.05)):
            body = spec.worldbody.add_body(name=f"b{k}", pos=[k, 0, 0.4])
            body.add_freejoint()
            body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="m", margin=margin)
        with carom.robots.load(spec) as robot:
            self.assertEqual(robot.left_out, [])
            robot.step(500)
            for k, margin in enumerate((0.0, 0.02, 0.05)):
                self.assertAlmostEqual(float(robot.pose(f"b{k}")[0][2]), 0.3 + 0.01 + margin, delta=2e-4)

    def test_shapes_go_with_a_robot_that_fails(self):
        """Hulls of hulls are destroyed before what they are made of."""
        spec = mujoco.MjSpec.from_string('<mujoco><worldbody/><sensor><e_kinetic/></sensor></mujoco>')
        spec.add_mesh(name="m", uservert=[x / 10 for corner in BOX for x in corner])
        body = spec.worldbody.add_body(name="b")
        body.add_freejoint()
        for margin in (0.0, 0.02):
            body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="m", margin=margin)
        with carom.Engine() as engine, engine.world() as world:
            with self.assertRaises(carom.robots.ModelError):
                carom.robots.load(spec, world=world, strict=True)
            self.assertEqual(world.body_count(), 0)


if __name__ == "__main__":
    unittest.main()
