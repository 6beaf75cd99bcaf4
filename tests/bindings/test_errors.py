"""Refusals name the code, what is wrong and what to do; where Python has a word for it they are that, too."""
import math
import unittest

import carom
from carom import errors


class Refusals(unittest.TestCase):
    def setUp(self):
        self.engine = carom.Engine()
        self.world = self.engine.world()
        self.addCleanup(self.engine.close)

    def test_text(self):
        with self.assertRaises(errors.OutOfRange) as caught:
            self.engine.sphere(-1)
        refused = caught.exception
        self.assertEqual(refused.code, carom.raw.CAROM_E_OUT_OF_RANGE)
        self.assertIn("radius of carom.sphere", refused.message)
        self.assertIn("-1", refused.message)
        self.assertTrue(refused.remedy)
        self.assertEqual(str(refused), f"{refused.message}. Remedy: {refused.remedy}")
        self.assertEqual(refused.argument, 3)  # params, of carom_shape_create
        self.assertIsInstance(refused, ValueError)

    def test_each_kind(self):
        body = self.world.body()
        for kind, also, use in [
            (errors.NotFinite, ValueError, lambda: self.world.body(position=(math.nan, 0, 0))),
            (errors.NotUnit, ValueError, lambda: self.world.body(orientation=(0, 0, 0, 2))),
            (errors.OutOfRange, ValueError, lambda: self.world.step(2)),
            (errors.NotFound, LookupError, lambda: self.engine.shape("no.such", ())),
            (errors.PluginPath, OSError, lambda: self.engine.load_plugin("/no/such.so")),
            (errors.UnknownEnum, ValueError, lambda: self.world.body(type=7)),
            (errors.Unsupported, NotImplementedError, lambda: body.__class__.locks.__set__(body, 1 << 20)),
            (errors.NoVolume, carom.CaromError, lambda: self.world.body(self.engine.hull([(0, 0, 0), (1, 0, 0), (0, 1, 0)]))),
        ]:
            with self.assertRaises(kind) as caught:
                use()
            self.assertIsInstance(caught.exception, also)
            self.assertIsInstance(caught.exception, carom.CaromError)
            self.assertIn("Remedy: ", str(caught.exception))

    def test_nothing_changed(self):
        before = self.world.hash, self.world.body_count()
        self.assertRaises(ValueError, self.world.body, position=(math.inf, 0, 0))
        self.assertEqual((self.world.hash, self.world.body_count()), before)

    def test_words(self):
        with self.assertRaisesRegex(ValueError, "'dynamik' is not one of .*dynamic"):
            self.world.body(type="dynamik")
        with self.assertRaisesRegex(ValueError, "solver is one of severity, .*auto, not 'fast'"):
            self.world.dials["solver"] = "fast"
        with self.assertRaisesRegex(KeyError, "no dial 'substep'; there are .*substeps"):
            self.world.dials["substep"] = 3
        with self.assertRaisesRegex(TypeError, "has no colour; it has .*gravity_factor"):
            self.world.particles(colour=3)
        with self.assertRaisesRegex(ValueError, "position takes 3 numbers, got 2"):
            self.world.body(position=(1, 2))


    def test_words_of_other_enumerations_are_none_of_this_one(self):
        for wrong in ("field_mass", "stays_awake", "disabled", "count"):
            with self.assertRaisesRegex(ValueError, "is not one of dynamic, kinematic, static$"):
                self.world.body(type=wrong)
        body = self.world.body()
        for wrong in ("read_axes", "collide", "field_length", "world_frame"):
            with self.assertRaisesRegex(ValueError, "is not one of ball, "):
                self.world.joint(wrong, None, body)

    def test_invalid_shape_has_a_witness(self):
        with self.assertRaises(errors.PluginInvalid) as caught:
            self.engine.support_plugin(lambda p, d: (d[0] ** 3, d[1], d[2]), "test.invalid_plugin")()
        direction, answer = caught.exception.witness
        self.assertEqual((len(direction), len(answer)), (3, 3))

    def test_support_that_raises_is_the_cause(self):
        with self.assertRaises(errors.PluginInvalid) as caught:
            self.engine.support_plugin(lambda p, d: 1 / 0, "test.raises")
        self.assertIsInstance(caught.exception.__cause__, ZeroDivisionError)

    def test_details_are_of_this_call(self):
        """The error object is used again; a call without details must not show those of the one before."""
        with self.assertRaises(errors.OutOfRange):
            self.engine.sphere(-1)
        with self.assertRaises(carom.CaromError) as caught:
            errors.raise_for(carom.raw.CAROM_E_BUSY, None)
        self.assertEqual(caught.exception.message, "CAROM_E_BUSY")


if __name__ == "__main__":
    unittest.main()
