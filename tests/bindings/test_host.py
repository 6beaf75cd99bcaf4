"""A host's own memory and threads: asked for what is needed, given all of it back, and no bit is different."""
import contextlib
import ctypes
import gc
import io
import threading
import unittest
from concurrent.futures import ThreadPoolExecutor

import carom

LIBC = ctypes.CDLL(None)
LIBC.aligned_alloc.restype, LIBC.aligned_alloc.argtypes = ctypes.c_void_p, (ctypes.c_size_t, ctypes.c_size_t)
LIBC.free.restype, LIBC.free.argtypes = None, (ctypes.c_void_p,)


class Counted:
    """The C library's memory, with a list of what is out; refuses everything from the call numbered `broke` on."""

    def __init__(self, broke=None):
        self.out, self.calls, self.peak, self.broke = {}, 0, 0, broke
        self.lock = threading.Lock()

    def alloc(self, size, alignment):
        with self.lock:
            self.calls += 1
            if self.broke is not None and self.calls >= self.broke:
                return None
            alignment = max(alignment, 8)
            address = LIBC.aligned_alloc(alignment, -(-size // alignment) * alignment)
            self.out[address] = size, alignment
            self.peak = max(self.peak, sum(size for size, _ in self.out.values()))
            return address

    def free(self, address, size, alignment):
        with self.lock:
            assert self.out.pop(address) == (size, max(alignment, 8))
        LIBC.free(address)


def heap_hash(engine, steps=40):
    """What a heap of boxes and balls ends in, large enough for loops to be shared."""
    with engine.world() as world:
        world.ground()
        shapes = [engine.box(0.4, 0.4, 0.4), engine.sphere(0.4)]
        for i in range(600):
            world.body(shapes[i % 2], position=(i % 10 * 0.85, 0.5 + i // 100 * 0.9, i // 10 % 10 * 0.85))
        for _ in range(steps):
            world.step()
        return world.hash


class Host(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with carom.Engine() as engine:
            cls.plain = heap_hash(engine)

    def test_memory_is_the_hosts_and_goes_back(self):
        memory = Counted()
        with carom.Engine(allocator=memory) as engine:
            self.assertEqual(heap_hash(engine), self.plain)
            self.assertGreater(memory.peak, 600 * 500)  # bytes: all that grows with a scene
        gc.collect()
        self.assertEqual(memory.out, {})

    def test_what_runs_out_of_memory_says_so_and_leaks_nothing(self):
        memory = Counted()
        with carom.Engine(allocator=memory) as engine:
            heap_hash(engine, steps=1)
        for broke in (1, 2, memory.calls // 3, memory.calls - 3):
            short = Counted(broke)
            with self.assertRaises(carom.errors.OutOfMemory):
                with carom.Engine(allocator=short) as engine:
                    heap_hash(engine, steps=1)
            gc.collect()
            self.assertEqual(short.out, {}, f"memory ran out at call {broke} of {memory.calls}")

    def test_an_exception_in_an_allocator_is_no_memory(self):
        class Broken(Counted):
            def alloc(self, size, alignment):
                raise RuntimeError("no")

        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(carom.errors.OutOfMemory):
            carom.Engine(allocator=Broken())

    def test_threads_of_the_hosts_share_a_step_and_change_no_bit(self):
        seen = set()

        def noted(job):
            def part(begin, end):
                seen.add(threading.get_ident())
                job(begin, end)

            return part

        with ThreadPoolExecutor(3) as executor:
            share = carom.share(executor, 4)
            with carom.Engine(jobs=lambda job, count: share(noted(job), count)) as engine:
                self.assertEqual(heap_hash(engine), self.plain)
        self.assertGreater(len(seen), 1)

    def test_what_a_job_system_leaves_out_is_done(self):
        calls = []

        def lazy(job, count):
            calls.append(count)
            if count > 3:
                job(count // 3, count // 2)

        with carom.Engine(jobs=lazy) as engine:
            self.assertEqual(heap_hash(engine), self.plain)
        self.assertTrue(calls)

    def test_threads_and_jobs_are_one_or_the_other(self):
        with self.assertRaises(ValueError):
            carom.Engine(threads=2, jobs=lambda job, count: job(0, count))


if __name__ == "__main__":
    unittest.main()
