"""The Python programs of the READMEs run and say what they should."""
import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def programs(page):
    return re.findall(r"```python\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.S)


PROGRAMS = programs("bindings/python/README.md")


def output_of(program):
    done = subprocess.run([sys.executable, "-X", "dev", "-c", program], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, ""), done.stderr
    return done.stdout


class Readme(unittest.TestCase):
    def test_first_program(self):
        """9 m - 0.9 m at 22 m/s: the ball's surface is at the boxes' after 8.1 / 22 = 0.37 s, in one of the two steps about."""
        self.assertLessEqual(len([line for line in PROGRAMS[0].splitlines() if line.strip()]), 15)
        said = output_of(PROGRAMS[0])
        after = float(re.search(r"hit after ([0-9.]+) s", said).group(1))
        self.assertTrue(8.1 / 22 - 1 / 60 <= after <= 8.1 / 22 + 2 / 60, said)
        self.assertLess(int(re.search(r"(\d) of 6 boxes", said).group(1)), 6)

    def test_shape_in_python(self):
        """1 m^3 of 1000 kg/m^3, at rest on half its height."""
        said = output_of(PROGRAMS[1])
        self.assertRegex(said, r"weighs 1000 kg and lies at y = (0\.49[5-9]|0\.50[0-5]) m")

    def test_state(self):
        self.assertRegex(output_of(PROGRAMS[2]), r"saved \d+ bytes; the same bits again: True")

    def test_front_page(self):
        """As its twin in C: at rest on its radius."""
        [program] = programs("README.md")
        self.assertRegex(output_of(program), r"y = (0\.49[5-9]|0\.50[0-5]) m")

    def test_topic_of_accuracy(self):
        """As its twins in C and JavaScript, and as the equation of motion: 0.78507 m."""
        [program] = programs("src/site/docs/topics/accuracy.md")
        self.assertRegex(output_of(program), r"at x = 0\.7851 m after 2 s; \d+ substeps, error 0\.")

    def test_topic_of_robots(self):
        """As its twin in C: weights of 2 kg at 0.5 and 1.5 m of the first hinge."""
        [program] = programs("src/site/docs/topics/robots.md")
        self.assertRegex(output_of(program), r"39\.2 and 9\.8 N m hold it, M = 5\.34 1\.67 0\.67 kg m\^2, after 1 s it turns at 0\.000 rad/s")

    def test_topic_of_measure(self):
        """v^2 / (2 mu g) and its derivatives; the page shows what the first program prints, but for the seconds."""
        page = "src/site/docs/topics/measure.md"
        slides, lands, fits = map(output_of, programs(page))
        shown = re.search(r"It prints .*?\n\n((?:    .*\n)+)", (ROOT / page).read_text(encoding="utf-8")).group(1)
        without = re.compile(r", \S+ s; ")
        self.assertEqual(without.sub("; ", slides), without.sub("; ", re.sub(r"^    ", "", shown, flags=re.M)))
        self.assertAlmostEqual(float(slides.split()[0]), 3**2 / (2 * 0.4 * 9.81), delta=2.6e-7)
        self.assertRegex(lands, r"after 0\.99\d+ s, 0\.1\d+ s later")
        self.assertIn(f"{3**2 / (2 * 1.3 * 9.81):.5f}", fits)

    def test_that_is_all(self):
        self.assertEqual(len(PROGRAMS), 3)


if __name__ == "__main__":
    unittest.main()
