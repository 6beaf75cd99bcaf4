"""What a notebook shows: pictures and films of worlds, in one piece, without a change of the world."""
import base64
import json
import re
import struct
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

import carom

SVG = "{http://www.w3.org/2000/svg}"


def corners(polygon):
    return [tuple(map(float, pair.split(","))) for pair in polygon.get("points").split()]


def scene_of(film):
    return json.loads(re.search(r"^const S = (.*);$", film.page, re.M)[1])


class Notebook(unittest.TestCase):
    def setUp(self):
        self.engine = carom.Engine()
        self.addCleanup(self.engine.close)
        self.world = self.engine.world()
        self.addCleanup(self.world.close)
        self.ground = self.world.ground()

    def drawn(self, fill=None):
        root = ElementTree.fromstring(self.world.picture().svg)
        return [p for p in root.iter(f"{SVG}polygon") if fill is None or p.get("fill") == fill]

    def test_a_box_has_three_faces_to_be_seen_and_a_shadow(self):
        self.world.body(self.engine.box(0.5, 0.5, 0.5), position=(0, 3, 0))
        shadow, *faces = self.drawn()
        self.assertEqual(3, len(faces))
        self.assertEqual([4, 4, 4], [len(corners(face)) for face in faces])
        self.assertEqual("#00000030", shadow.get("fill"))
        self.assertEqual(3, len({face.get("fill") for face in faces}))  # lit unlike
        lowest = max(y for face in faces for _, y in corners(face))
        self.assertLess(lowest, max(y for _, y in corners(shadow)))  # it hovers: its shadow is below it

    def test_what_is_nearer_is_drawn_later_and_larger(self):
        ball = self.engine.sphere(0.5)
        self.world.body(ball, position=(0, 0.5, -4))
        self.world.body(ball, position=(0.5, 0.5, 4))
        far, near = (corners(p) for p in self.drawn() if p.get("stroke"))

        def width(points):
            return max(x for x, _ in points) - min(x for x, _ in points)
        self.assertGreater(width(near), 1.2 * width(far))
        self.assertGreater(max(y for _, y in near), max(y for _, y in far))

    def test_all_of_a_scene_is_within_the_picture(self):
        for shape in (self.engine.box(1, 0.2, 0.4), self.engine.cylinder(0.5, 0.5), self.engine.capsule(0.2, 0.6),
                      self.engine.hull([(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2)])):
            for at in ((-3, 1, 2), (3, 2, -2), (0, 4, 0)):
                self.world.body(shape, position=at)
        for polygon in self.drawn():
            if polygon.get("stroke"):
                for x, y in corners(polygon):
                    self.assertTrue(0 <= x <= 640 and 0 <= y <= 400, (x, y))

    def test_the_ground_is_where_it_is(self):
        self.world.body(self.engine.box(0.5, 0.5, 0.5), position=(0, 0.5, 0))
        self.assertEqual(0, scene_of(carom.film(self.world, 0.1))["floor"])
        self.ground.destroy()
        self.assertIsNone(scene_of(carom.film(self.world, 0.1))["floor"])
        self.world.ground(offset=-2)
        self.assertAlmostEqual(-2, scene_of(carom.film(self.world, 0.1))["floor"], 9)

    def test_fields_meshes_and_shapes_of_ones_own(self):
        self.ground.destroy()
        self.world.body(self.engine.height_field([[0, 0, 0], [0, 1, 0], [0, 0, 0]]), type="static")
        kind = self.engine.support_plugin(lambda p, d: tuple(p[0] if x >= 0 else -p[0] for x in d), "test.cube", params=[("h", "m", 0.1, 9)])
        self.world.body(kind(0.4), position=(1, 3, 1))
        faces = self.drawn()
        self.assertEqual(8 + 3, len(faces))  # triangles of the field, all seen from above, and three sides of the cube

    def test_counts_are_told_and_nothing_changes(self):
        one = self.world.body(self.engine.box(0.5, 0.5, 0.5), position=(0, 0.5, 0))
        two = self.world.body(self.engine.box(0.5, 0.5, 0.5), position=(0, 1.5, 0))
        self.world.joint("ball", one, two, position=(0, 1, 0))
        carom.run(self.world, 0.5)
        before = self.world.hash
        shown = self.world._repr_html_()
        self.assertEqual(before, self.world.hash)
        for text in ("bodies 3", "joints 1", f"contacts {len(self.world.contacts())}", "time 0.5 s", f"{before:016x}"):
            self.assertIn(text, shown)
        self.world.close()
        self.assertIsNone(self.world._repr_html_())

    def test_a_film_is_the_run_itself(self):
        body = self.world.body(self.engine.sphere(0.5), position=(0, 3, 0))
        twin = self.world.fork()
        self.addCleanup(twin.close)
        seen = []
        film = carom.film(self.world, 1, rate=10, each=lambda world: seen.append(body.position[1]))
        carom.run(twin, 1)
        self.assertEqual(twin.hash, self.world.hash)
        self.assertEqual(60, len(seen))
        scene = scene_of(film)
        poses = base64.b64decode(scene["poses"])
        values = struct.unpack(f"<{len(poses) // 4}f", poses)
        self.assertEqual(11 * 2 * 7, len(values))  # pictures, bodies, numbers of a pose
        for picture in range(10):
            self.assertAlmostEqual(seen[6 * picture], values[7 * (2 * picture + 1) + 1], 6)

    def test_it_asks_no_network(self):
        self.world.body(self.engine.sphere(0.5), position=(0, 3, 0))
        film = carom.film(self.world, 0.2)
        for text in (film.page, film._repr_html_(), self.world._repr_html_()):
            self.assertIsNone(re.search(r"(src|href)\s*=|import |fetch\(|url\(", text.replace("http://www.w3.org/2000/svg", "")
                                        .replace('srcdoc="', "")))
        with tempfile.TemporaryDirectory() as folder:
            film.save(Path(folder) / "film.html")
            self.world.picture().save(Path(folder) / "world.svg")
            self.assertEqual(film.page, (Path(folder) / "film.html").read_text(encoding="utf-8"))
            ElementTree.parse(Path(folder) / "world.svg")

    def test_bad_input_is_told_and_steps_nothing(self):
        before = self.world.hash
        for wrong in (dict(seconds=0), dict(seconds=1, dt=0), dict(seconds=1, rate=-1), dict(seconds=float("nan"))):
            with self.assertRaises((ValueError, TypeError)):
                carom.film(self.world, **wrong)
        self.assertEqual(before, self.world.hash)

    def test_an_empty_world_and_one_that_loses_a_body(self):
        self.assertIn("<svg", self.world.picture().svg)
        body = self.world.body(self.engine.sphere(0.5), position=(0, 3, 0))
        film = carom.film(self.world, 1, each=lambda world: world.report.time > 0.5 and body in world.bodies and body.destroy())
        values = base64.b64decode(scene_of(film)["poses"])
        last = struct.unpack("<7f", values[-28:])
        self.assertNotEqual(last[0], last[0])  # no number: it is gone


if __name__ == "__main__":
    unittest.main()
