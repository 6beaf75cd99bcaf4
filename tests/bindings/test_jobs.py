"""carom.jobs.map(): equal results wherever jobs are done; a file to go on from; workers that end; what is refused."""
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import carom
from carom.jobs import JobFailed

try:
    import ray
except ImportError:
    ray = None


def fall(world, seed):
    """A throw, and the hash at its end."""
    ball = world.bodies[-1]
    ball.linear_velocity = (0.1 * seed, 1 + 0.01 * seed, 0)
    for _ in range(20):
        world.step(1 / 60)
    return {"hash": f"{world.hash:016x}", "at": list(ball.position)}


def end_once(world, seed):
    """Takes its process down the first time: a file says whether that was."""
    mark = Path(os.environ["CAROM_TEST_MARK"])
    if seed == 3 and not mark.exists():
        mark.write_text("")
        os.kill(os.getpid(), signal.SIGKILL)
    return fall(world, seed)


def always_end(world, seed):
    os.kill(os.getpid(), signal.SIGKILL)


def complain(world, seed):
    if seed == 2:
        raise ValueError("two is too many")
    return seed


def no_json(world, seed):
    return {1, 2}


class Jobs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with carom.Engine() as engine, engine.world() as world:
            world.ground()
            world.body(engine.box(0.5, 0.5, 0.5), position=(1.5, 0.5, 0))
            world.body(engine.sphere(0.2), position=(0, 1, 0))
            cls.snapshot, cls.hash = world.save(whole=True), world.hash
        cls.want = carom.jobs.map(cls.snapshot, fall, range(8), on="here")

    def test_results_are_equal_wherever_jobs_are_done(self):
        self.assertEqual(len({result["hash"] for result in self.want}), 8)
        self.assertEqual(self.want, carom.jobs.map(self.snapshot, fall, range(8), on="threads", workers=3, window=2))
        self.assertEqual(self.want, carom.jobs.map(self.snapshot, fall, range(8), on="processes", workers=2))
        self.assertEqual(self.want[::-1] + self.want[:1], carom.jobs.map(self.snapshot, fall, [*range(7, -1, -1), 0]))

    @unittest.skipIf(ray is None, "Ray is not installed (pip install ray)")
    def test_on_two_nodes_of_ray_too_after_a_worker_was_killed(self):
        with tempfile.TemporaryDirectory() as folder:
            os.environ["CAROM_TEST_MARK"] = str(Path(folder) / "mark")
            path = os.pathsep.join([str(Path(__file__).parent), *filter(None, sys.path)])
            from ray.cluster_utils import Cluster
            cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
            self.addCleanup(cluster.shutdown)
            cluster.add_node(num_cpus=1)
            ray.init(address=cluster.address, log_to_driver=False, runtime_env={"env_vars": {**os.environ, "PYTHONPATH": path}})
            self.addCleanup(ray.shutdown)
            self.assertEqual(len(ray.nodes()), 2)
            self.assertEqual(self.want, carom.jobs.map(self.snapshot, end_once, range(8), on="ray"))

    def test_a_worker_that_ends_costs_its_jobs_another_try(self):
        with tempfile.TemporaryDirectory() as folder:
            os.environ["CAROM_TEST_MARK"] = str(Path(folder) / "mark")
            file = Path(folder) / "done.jsonl"
            self.assertEqual(self.want, carom.jobs.map(self.snapshot, end_once, range(8), on="processes", workers=2, file=file))
            self.assertEqual(sorted(json.loads(line)["seed"] for line in file.read_text().splitlines()), list(range(8)))  # each counts once
        with self.assertRaisesRegex(JobFailed, "its worker ended 2 times"):
            carom.jobs.map(self.snapshot, always_end, [1], on="processes", workers=1, retries=1)

    def test_it_goes_on_from_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file, seen = Path(folder) / "done.jsonl", []
            carom.jobs.map(self.snapshot, fall, range(3), file=file)
            with open(file, "ab") as lines:
                lines.write(b'{"key": "another", "seed": 4, "result": 0}\n{"key": "' + b"x" * 5)  # another's, and one that was cut off
            got = carom.jobs.map(self.snapshot, fall, range(8), file=file, progress=lambda done, total: seen.append((done, total)))
            self.assertEqual((got, len(seen), seen[-1]), (self.want, 5, (8, 8)))
            self.assertEqual(self.want, carom.jobs.map(self.snapshot, fall, range(8), file=file, progress=lambda *_: self.fail("done again")))

    def test_what_a_job_raises_names_its_seed(self):
        for on in ("here", "threads", "processes"):
            with self.subTest(on), self.assertRaisesRegex(JobFailed, "seed 2 failed: ValueError: two is too many") as raised:
                carom.jobs.map(self.snapshot, complain, range(4), on=on, workers=1)
            self.assertEqual(raised.exception.seed, 2)
        with self.assertRaisesRegex(JobFailed, "not what JSON has"):
            carom.jobs.map(self.snapshot, no_json, [0], on="here")
        with self.assertRaisesRegex(JobFailed, "Corrupt"):
            carom.jobs.map(b"no snapshot", complain, [0], on="here")

    def test_what_is_refused(self):
        for wrong, arguments in ((ValueError, {"on": "mars"}), (ValueError, {"workers": 0}), (ValueError, {"window": 0, "on": "threads"}), (ValueError, {"retries": -1})):
            with self.subTest(arguments), self.assertRaises(wrong):
                carom.jobs.map(self.snapshot, complain, [0], **arguments)
        with self.assertRaises(ValueError):
            carom.jobs.map(self.snapshot, complain, [-1])
        with self.assertRaises(TypeError):
            carom.jobs.map(self.snapshot, None, [1])


class Page(unittest.TestCase):
    def test_the_program(self):
        text = (Path(__file__).resolve().parents[2] / "src/site/docs/topics/batches.md").read_text(encoding="utf-8")
        program = re.findall(r"```python\n(.*?)```", text, re.S)[2]
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr, done.stdout), (0, "", "it stands up to a push of 1.0 m/s\n"))


if __name__ == "__main__":
    unittest.main()
