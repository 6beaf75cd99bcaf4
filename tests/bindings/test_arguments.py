"""Arguments of every method, function and property of the package, found by their annotations: what is no number, or no whole one, or
no word, is refused in Python's own words, the message names the argument, and nothing has changed."""
import inspect
import math
import re
import typing
import unittest

import carom
from carom import records
from carom.body import Thing

GOOD = {"Vector": (0, 1, 0), "Rows": [(0, 1, 0)], "float": 1.0, "int": 1}  # by what an annotation begins with
GOOD_OF = {  # by name, where that is not enough
    "orientation": (0, 0, 0, 1), "orientation_a": (0, 0, 0, 1), "orientation_b": (0, 0, 0, 1), "orientations": (0, 0, 0, 1), "inertia": (1, 0, 0, 0, 1, 0, 0, 0, 1),
    "spacing": (1, 1), "triangles": [(0, 1, 2)], "vertices": [(0, 0, 0), (0, 0, 1), (1, 0, 0)], "heights": [(0, 0), (0, 0)],
    "coordinate": "twist", "axis": "turn_x", "plugin": "carom.sphere", "params": (1.0,), "points": [(0, 0, 0)], "id": "test.arguments",
    "field": "position", "effect": "gravity", "kinds": "contact", "triangle": 0, "indices": [0], "kind": "ball", "values": [(0, 1, 0)],
}


def wrong_values(annotation):
    """[(value, what it is)] that an argument of this annotation does not take."""
    values = [(object(), "an object")]
    if "Vector" in annotation or re.search(r"tuple\[(float|int|Vector)", annotation):
        values += [(("1", 0, 0, 0, 0, 0, 0, 0, 0), "text in it"), ("1", "text")]
        if "float |" not in annotation:
            values.append((5, "a single number"))
    elif "Rows" in annotation or re.search(r"(Iterable|Sequence)\[(float|Vector|int)", annotation):
        values += [([("a", "b", "c")], "rows of text"), ("abc", "text")]
    elif re.search(r"\bint\b", annotation):
        values += [(2.5, "a fraction"), (math.nan, "nan"), (2**70, "2^70")]
        if "Iterable" not in annotation:
            values.append(([1], "a list"))
        if "str" not in annotation:
            values += [("two", "text"), (b"2", "bytes")]
        if "str" not in annotation and "Word" not in annotation:
            values.append(("2", "a number in quotes"))
        if "None" not in annotation and "Word" not in annotation:
            values.append((None, "None"))
    elif "Word" in annotation:
        values += [("no such word", "another word"), (2.5, "a fraction")]
    elif re.search(r"\bfloat\b", annotation):
        values += [("x", "text"), ([1.0], "a list"), (1j, "a complex number"), (10**400, "10^400")]
        if "str" not in annotation:
            values += [("2", "a number in quotes")]
        if "None" not in annotation:
            values.append((None, "None"))
    elif is_thing(annotation):
        values += [("wood", "text"), (2.5, "a number")]
    return values


def is_thing(annotation):
    return annotation.replace(" | None", "") in ("Body", "Shape", "Material")


def is_numeric(annotation):
    return bool(re.search(r"\b(float|int|Vector|Rows|Shape|Body|Material|\w+Word)\b", annotation)) and "Callable" not in annotation


class Arguments(unittest.TestCase):
    def setUp(self):
        self.engine = carom.Engine()
        self.world = self.engine.world()
        self.addCleanup(self.engine.close)
        ground = self.world.ground()
        body = self.world.body(self.engine.sphere(1), position=(0, 3, 0))
        particles = self.world.particles(mass=1)
        if carom._values.numpy is not None:
            particles.add([(0, 9, 0)])
        self.objects = {
            "Engine": self.engine, "World": self.world, "Body": body, "Collider": body.colliders[0],
            "Material": self.world.material(), "Joint": self.world.joint("hinge", ground, body), "ForceField": self.world.force_field(),
            "Spring": self.world.spring(ground, body, 1, 2), "Particles": particles,
        }
        self.good = {"Shape": self.engine.sphere(1), "Body": body, "Material": self.objects["Material"], "Joint": self.objects["Joint"]}

    def good_of(self, name, annotation):
        if name in GOOD_OF:
            return GOOD_OF[name]
        for kind, value in {**self.good, **GOOD}.items():
            if re.search(rf"\b{kind}\b", annotation):
                return value
        return None

    def keywords_of(self, annotation):
        """{name: annotation} of the TypedDict that **about has."""
        kind = re.search(r"Unpack\[(\w+)\]", annotation)[1]
        kind = carom.bulk.BodyArguments if kind == "BodyArguments" else getattr(records, kind)
        return {key: value.__forward_arg__ if isinstance(value, typing.ForwardRef) else str(value)
                for key, value in kind.__annotations__.items()}

    def callables(self):
        """(text, function, {argument: annotation}, {argument that must be given: value})"""
        found = []
        for kind, thing in self.objects.items():
            members = {name: member for base in reversed(type(thing).__mro__) for name, member in vars(base).items()}
            for name, member in members.items():
                if isinstance(member, property) and member.fset:
                    parameter = list(inspect.signature(member.fset).parameters.values())[1]
                    found.append((f"{kind}.{name}", lambda _f=member.fset, _t=thing, **given: _f(_t, *given.values()),
                                  {name: parameter.annotation}, {}))
                elif inspect.isfunction(member) and not name.startswith("_"):
                    found.append((f"{kind}.{name}", getattr(thing, name), *self.parameters(member)))
        found.append(("Engine.__init__", carom.Engine, *self.parameters(carom.Engine.__init__)))
        for function in (carom.run, carom.tune, carom.share):
            found.append((function.__name__, function, *self.parameters(function)))
        return found

    def parameters(self, function):
        arguments, needed = {}, {}
        for name, parameter in inspect.signature(function).parameters.items():
            annotation = str(parameter.annotation)
            if name in ("self", "kinds", "what"):
                continue
            if parameter.kind is parameter.VAR_KEYWORD:
                for key, of_key in self.keywords_of(annotation).items():
                    if key != "fields":
                        arguments[key] = of_key
                continue
            arguments[name] = annotation
            if parameter.default is parameter.empty:
                needed[name] = {"world": self.world, "executor": None}.get(name, self.good_of(name, annotation))
        if function is carom.World.set_accuracy:
            needed["turn"] = 1e-3
        return arguments, needed

    def test_what_is_assigned_is_named_as_typed(self):
        """What C refuses of a property, by the property's name, not by that of an argument in C."""
        nan, seen = math.nan, []
        vectors = {"orientation": (nan, 0, 0, 1), "damping": (0, nan), "drag": (nan, 0), "resistance": (0, nan),
                   "surface_velocity": ((0, 0, 0), (0, nan, 0)), "pose": ((0, nan, 0), (0, 0, 0, 1))}
        for text, function, arguments, needed in self.callables():
            kind, name = text.partition(".")[::2]
            if needed or list(arguments) != [name] or kind == "Particles" or not re.search("float|Vector", arguments[name]):
                continue
            whole = "Vector" in arguments[name] or "tuple" in arguments[name]
            value = vectors.get(name, (0, nan, 0)) if whole else nan
            with self.assertRaises((ValueError, TypeError), msg=text) as refused:
                function(**{name: value})
            seen.append(text)
            if name != "pose":
                self.assertRegex(str(refused.exception), rf"^{name}\b", text)
        self.assertGreater(len(seen), 15, seen)

    def test_each_names_its_argument(self):
        self.assertGreater(len(self.callables()), 80)
        tried, failed = 0, []
        for text, function, arguments, needed in self.callables():
            if carom._values.numpy is None and (text.startswith("Particles.") or any(
                    "Rows" in annotation or "NDArray" in annotation for annotation in arguments.values())):
                continue
            for name, annotation in arguments.items():
                if not is_numeric(annotation):
                    continue
                for value, what in wrong_values(annotation):
                    tried += 1
                    before = self.world.save(), self.world.body_count()
                    try:
                        function(**{**needed, name: value})
                        failed.append(f"{text}({name}={what}) is taken")
                    except (TypeError, ValueError) as refused:
                        if isinstance(refused, carom.CaromError) or name not in str(refused):
                            failed.append(f"{text}({name}={what}) does not name it: {refused!r}")
                    except Exception as other:  # noqa: BLE001
                        failed.append(f"{text}({name}={what}): {other!r}")
                    if (self.world.save(), self.world.body_count()) != before:
                        failed.append(f"{text}({name}={what}) has changed the world")
        self.assertFalse(failed, "\n".join(failed))
        self.assertGreater(tried, 700)

    def test_attributes_and_dials(self):
        attributes, dials = self.objects["Body"].attributes, self.world.dials
        for mapping, name, wrong in [(attributes, "gravity_factor", "2"), (attributes, "gravity_factor", None), (attributes, "drag", (1, "2")),
                                     (attributes, "drag", "12"), (attributes, "locks", b"1"), (dials, "substeps", "3"), (dials, "substeps", None),
                                     (dials, "restitution_speed", [1]), (dials, "solver", None)]:
            before = dict(mapping)
            with self.assertRaisesRegex((TypeError, ValueError), f"^{name}"):
                mapping[name] = wrong
            self.assertEqual(dict(mapping), before)

    def test_what_counts_as_a_number_is_taken(self):
        """A whole float, a bool, a fraction of two integers, what has __index__ or __float__."""
        from decimal import Decimal
        from fractions import Fraction

        class Three:
            def __index__(self):
                return 3

        with carom.Engine(threads=2.0) as engine, engine.world(body_capacity=Three()) as world:
            world.step(Fraction(1, 60))
            body = world.body(mass=Decimal("2.5"), user=Three(), linear_damping=True)
            self.assertEqual((body.mass, body.user, body.linear_damping), (2.5, 3, 1))
            body.mass = Three()
            self.assertEqual(body.mass, 3)
            body.set_filter(category=4, mask=~1, group=-3)

    def test_rows_of_another_length(self):
        for use, said in [(lambda: self.engine.mesh([(0, 0, 0), (0, 0, 1), (1, 0, 0)], [(0, 1)]), "triangles takes rows of 3 indices, got one of 2"),
                          (lambda: self.engine.hull([(0, 0, 0), (1, 0)]), r"points\[1\] takes 3 numbers, got 2"),
                          (lambda: self.engine.height_field([(0, 0), (0, 0, 0)]), "heights"),
                          (lambda: self.objects["Material"].__class__.resistance.__set__(self.objects["Material"], (1,)), "resistance takes 2 numbers")]:
            with self.assertRaisesRegex(ValueError, said):
                use()

    def test_masks_may_be_complements(self):
        body = self.objects["Body"]
        collider = body.colliders[0]
        body.set_filter(mask=~5)
        self.assertEqual(collider.filter, (1, 2**64 - 1 - 5, 0))
        collider.set_filter(category=-1, mask=2**64 - 1)
        self.assertEqual(collider.filter[:2], (2**64 - 1, 2**64 - 1))
        body.force_field_mask = ~1
        self.assertEqual(body.force_field_mask, 2**32 - 2)
        for wrong in (2**64, -(2**63) - 1):
            with self.assertRaisesRegex(ValueError, "mask takes a whole number"):
                body.set_filter(mask=wrong)
        with self.assertRaisesRegex(ValueError, "force_field_mask takes a whole number"):
            body.force_field_mask = 2**32

    def test_threads(self):
        for wrong, told in [(-1, "got -1; type threads=1"), (2.5, "got 2.5; type threads=2"), (2**40, "got 1099511627776; type threads=1"),
                            ("2", "got '2', which is of type str; type threads=2 without quotes"), (257, "from 0 to 256"), (math.inf, "inf")]:
            with self.assertRaisesRegex((TypeError, ValueError), "threads takes a whole number from 0 to 256, .*") as caught:
                carom.Engine(threads=wrong)
            self.assertIn(told, str(caught.exception))

    def test_rays_without_direction(self):
        for zero in ((0, 0, 0), (0.0, -0.0, 0)):
            with self.assertRaisesRegex(ValueError, r"direction is \(0, 0, 0\).*type direction="):
                self.world.ray((0, 9, 0), zero)
            with self.assertRaisesRegex(ValueError, r"direction is \(0, 0, 0\)"):
                self.engine.ray_cast(self.good["Shape"], (0, 9, 0), zero)
        self.assertIsNotNone(self.world.ray((0, 9, 0), (0, -5e-324, 0)))  # a direction all the same
        with self.assertRaisesRegex(ValueError, r"axis is \(0, 0, 0\)"):
            self.world.joint("hinge", None, self.good["Body"], position=(0, 0, 0), axis=(0, 0, 0))
        if carom._values.numpy is not None:  # one bad ray spoils no other, and is told from a miss
            rows = carom._values.numpy.array([(0, -1, 0), (0, 0, 0), (0, 1, 0)], dtype=float)
            self.assertEqual(self.world.rays([(0, 9, 0)] * 3, rows).outcomes.tolist(), [1, 4, 0])
            self.assertEqual(rows[1].tolist(), [0, 0, 0])  # the caller's array is as it was
            self.assertIn(4, self.world.rays_all([(0, 9, 0)] * 3, rows).outcomes.tolist())

    def test_accuracy_without_numbers(self):
        for about in ({}, {"substeps": 4}, {"place": None, "turn": None}):
            with self.assertRaisesRegex(TypeError, r"takes place=.*turn=.*type set_accuracy\(place=1e-4, turn=1e-4\)"):
                self.world.set_accuracy(**about)
        self.assertIsNone(self.world.accuracy)
        self.world.set_accuracy(turn=1e-3)
        self.assertEqual(self.world.accuracy.turn, 1e-3)


class Said(unittest.TestCase):
    """repr(): counts, and what is gone."""

    def test_worlds_and_engines(self):
        engine = carom.Engine(threads=2)
        self.assertEqual(repr(engine), "<carom.Engine: 0 worlds, 2 threads>")
        world = engine.world()
        self.assertEqual(repr(world), "<carom.World: 0 bodies, 0 joints, at 0 s>")
        self.assertEqual(repr(engine), "<carom.Engine: 1 world, 2 threads>")
        world.joint("ball", None, world.body())
        world.body()
        world.step(0.25)
        self.assertEqual(repr(world), "<carom.World: 2 bodies, 1 joint, at 0.25 s>")
        before = world.hash
        repr(world)
        self.assertEqual(world.hash, before)
        world.close()
        self.assertEqual(repr(world), "<carom.World, closed>")
        self.assertEqual(repr(engine), "<carom.Engine: 0 worlds, 2 threads>")
        engine.close()
        self.assertEqual(repr(engine), "<carom.Engine, closed>")
        self.assertIn("jobs of the host's", repr(carom.Engine(jobs=lambda job, count: job(0, count))))

    def test_things(self):
        with carom.Engine() as engine:
            world = engine.world()
            shape, body = engine.sphere(1), world.body()
            self.assertRegex(repr(body), r"^<carom.Body 0x[0-9a-f]+: dynamic, 0 colliders>$")
            collider = body.collider(shape)
            body.type = "kinematic"
            self.assertRegex(repr(body), r"^<carom.Body 0x[0-9a-f]+: kinematic, 1 collider>$")
            things = [collider, body, world.material(), world.particles(), world.force_field(), world.joint("ball", None, world.body()),
                      world.spring(None, world.body(), 1, 1)]
            for thing in things:
                self.assertIsInstance(thing, Thing)
                self.assertIn(f"{thing.handle:#x}: ", repr(thing))
                thing.destroy()
                self.assertEqual(repr(thing), f"<carom.{type(thing).__name__} {thing.handle:#x}, destroyed>")
            other = world.body(shape)
            self.assertIn(f"{shape.handle:#x}: 4.18879 m^3>", repr(shape))
            world.close()
            self.assertRegex(repr(other), "^<carom.Body 0x[0-9a-f]+, of a closed world>$")
            shape.destroy()
            self.assertRegex(repr(shape), "^<carom.Shape 0x[0-9a-f]+, destroyed>$")
        self.assertRegex(repr(shape), "^<carom.Shape 0x[0-9a-f]+, of a closed engine>$")

    def test_in_a_call(self):
        """Of a world that is in a step, on this thread: no exception."""
        said = []

        def support(params, direction):
            if stepping:
                said.append((repr(world), repr(body)))
            return [math.copysign(1, x) for x in direction]

        stepping = False
        with carom.Engine() as engine, engine.world() as world:
            body = world.body(position=(9, 0, 0))
            world.body(engine.support_plugin(support, "test.says")())
            world.body(engine.sphere(1), position=(0, 1.9, 0))
            stepping = True
            world.step()
            self.assertTrue(said)
            self.assertEqual(set(said), {("<carom.World, in a call>", f"<carom.Body {body.handle:#x}>")})


if __name__ == "__main__":
    unittest.main()
