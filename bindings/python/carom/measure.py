"""An answer with an error bar and a slope: a question about a motion, asked at finer and finer settings.

    import carom

    def where_it_stops(trial, friction, speed):
        world = trial.world()
        wood = world.material(friction=friction)
        world.ground(material=wood)
        box = world.body(trial.engine.box(0.5, 0.5, 0.5), position=(0, 0.5, 0), linear_velocity=(speed, 0, 0), material=wood)
        trial.run(world, seconds=3)
        return box.position[0]

    print(carom.measure(where_it_stops, {"friction": 0.4, "speed": 3}))

A bar tells of numerical error alone: of steps, tolerances, softness of contacts and rounding. Whether the model is right (rigid bodies,
Coulomb's friction, the numbers that were given) it cannot tell.

How: trial k takes steps of 1/60 s / 2^k. Tolerances of the solver and of distances fall fourfold with each k, and contacts become stiffer.
Answers then differ by less and less, and the bar follows from these differences and from how fast they fall. No order beyond the second is relied
on. One more run goes another way (higher orders, more substeps); where it ends elsewhere, the bar is wider. Nothing here depends on a clock: the
same question has the same answer, to the bit.
"""
from __future__ import annotations

import math
import sys
import time
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Sequence, TextIO, Union

from ._values import number, whole
from .engine import Engine
from .errors import CaromError

if TYPE_CHECKING:
    from .body import Body
    from .world import World

    Answer = Union[float, Sequence[float]]
    Question = Callable[..., Answer]

__all__ = ["Chaotic", "Measured", "Slope", "Trial", "measure"]

FRAME = 1 / 60        # s, the step of trial 0
TRIALS = 5            # of which the last has steps of 1/960 s
SLOWEST = 1.5         # differences that fall by less count as this: what does not fall is noise
FASTEST = 4.0         # and by more as this: no more than the second order is relied on
SAFETY = 2.0          # bars over what differences say; tests/bindings/test_measure.py counts how many hold
WIDEST = 1 / 8        # of a parameter: the widest difference quotient; a parameter of 0 is moved by this
WIDTHS = 5            # that are tried, each half the one before
SHARPEST = 2.0**-46   # of a step: how finely the time of an event is looked for
KEPT = 16             # steps between states that are kept while an event is waited for
LEAST = 1e-9          # s, the shortest step that a world takes
ROUNDING = 2.0**-52   # of an answer, a substep: as if all of them went the same way
OPEN = 0.1            # of an answer: where errors grow e-fold, three trials that differ by more are no answer
SURE = math.log(1e6)  # logarithm of the growth up to which no chaos is looked for

class Chaotic(RuntimeError):
    """The answer depends on errors that nothing can lessen. lyapunov_time: s, errors grow e-fold in it; seconds: asked for; until: s, up
    to which an answer can be expected."""

    def __init__(self, rate: float, seconds: float):
        self.lyapunov_time, self.seconds, self.until = 1 / rate, seconds, math.log(1e8) / rate
        digits = rate * seconds / math.log(10)
        super().__init__(
            f"no answer: the motion is chaotic. Errors grow e-fold every {self.lyapunov_time:.2g} s (its Lyapunov time), by 10^{digits:.0f} in the "
            f"{seconds:.3g} s of the question, and its answers did not come closer to each other with finer steps. Ask about a time "
            f"before {self.until:.2g} s, or about many starts at once: a mean, or a share of them (carom.jobs.map(), carom.Batch)")


@dataclass(frozen=True)
class Slope:
    """How an answer changes with a parameter."""
    value: Any  # of the answer, over that of the parameter: as the answer, a number or a tuple
    bar: Any    # numerical error alone
    width: float  # of the difference quotient: the parameter was moved by this, up and down

    def __str__(self) -> str:
        return _pair(self.value, self.bar)


@dataclass(frozen=True)
class Measured:
    """What measure() found. An answer of several numbers has tuples for value and bar."""
    value: Any
    bar: Any                   # numerical error alone
    slopes: dict[str, Slope]
    half_cost: float           # computing that half the bar takes, over what this took
    lyapunov_time: float | None  # s, in which errors grow e-fold; None: they do not
    trials: list[Any] = field(repr=False)  # answers by level, the last is `value`
    runs: int                  # that were made in all
    seconds: float             # of computing

    def __str__(self) -> str:
        lines = [f"{_pair(self.value, self.bar)} (numerical error alone)"]
        lines += [f"  by {name}: {slope}" for name, slope in self.slopes.items()]
        lines.append(f"  {self.runs} runs, {self.seconds:.2g} s; half the bar takes {self.half_cost:.2g} times as long")
        return "\n".join(lines)


class Trial:
    """What a question is asked with: it makes the world and lets time pass, at the settings of one trial."""

    def __init__(self, engine: Engine, origin: World | None, level: int, other: bool = False, watch: bool = False):
        self.engine, self.level, self.dt = engine, level, FRAME / 2.0**level
        self._origin, self._other, self._watch = origin, other, watch
        self._worlds: list[World] = []
        self._steps, self._start = 0, None  # type: int, World | None

    def world(self, gravity: Sequence[float] | None = None, **dials: Any) -> World:
        """A new world, or where measure() got one, a copy of it: `world.counterpart(ball)` is the ball there. Its dials are the trial's.
        @param dials  that you want otherwise, in every trial"""
        world = self._origin.fork() if self._origin is not None else self.engine.world()
        self._worlds.append(world)
        if gravity is not None:
            world.gravity = gravity
        for name, value in {**_dials(self.level, self._other), **dials}.items():
            world.dials[name] = value
        world.collect_events("contact")
        return world

    def run(self, world: World, seconds: float, each: Callable[[World], object] | None = None) -> float:
        """Let time pass, in equal steps. @param each  called after each step; it ends the run by what is true
        @return s that passed"""
        seconds = number(seconds, "seconds")
        if not 0 <= seconds < math.inf:
            raise ValueError(f"run() takes seconds of at least 0, got {seconds:g}")
        steps = math.ceil(seconds / self.dt - 1e-6)
        for step in range(steps):
            self._step(world, seconds / steps)
            if each is not None and each(world):
                return (step + 1) * seconds / steps
        return seconds

    def until(self, world: World, happened: Callable[[World], object], most: float) -> float:
        """Let time pass until `happened(world)` is true, to rounding: a step that goes too far is taken back, and halved. So it may only look.
        @param most  s, after which it is given up   @return s that passed"""
        most = number(most, "most")
        if not 0 < most < math.inf:
            raise ValueError(f"until() takes most= of more than 0 s, got {most:g}")
        if happened(world):
            return 0.0
        steps, kept, at = math.ceil(most / self.dt), world.save(), 0
        for step in range(steps):
            if step % KEPT == 0:
                kept, at = world.save(), step
            self._step(world, self.dt)
            if happened(world):
                world.restore(kept)
                for _ in range(at, step):
                    world.step(self.dt)
                return step * self.dt + self._within(world, happened)
        raise ValueError(f"until(): it has not happened within most={most:g} s in a trial of steps of {self.dt:.3g} s; give it more, or look "
                         f"whether {getattr(happened, '__name__', 'the function')} can become true")

    def touches(self, world: World, body: Body, other: Body | None = None) -> bool:
        """Whether a body touched another one in the last step, or any: also where it only hit it, and was gone when the step ended. It
        needs contact events, which trial.world() turns on."""
        found = [(c.body_a, c.body_b) for c in world.contacts() if c.separation <= 0 or c.normal_impulse > 0]
        found += [(e.body_a, e.body_b) for e in world.contact_events() if e.kind != "end"]
        return any(body in pair and (other is None or other in pair) for pair in found)

    def _within(self, world: World, happened: Callable[[World], object]) -> float:
        """When in the next step it happens; the world is put there."""
        before = world.save()

        def after(seconds: float) -> bool:
            world.restore(before)
            world.step(seconds)
            return bool(happened(world))

        low, high = 0.0, self.dt
        while high - low > SHARPEST * self.dt and high > LEAST:
            middle = (low + high) / 2
            low, high = (low, middle) if after(max(middle, LEAST)) else (middle, high)
        after(max(high, LEAST))
        return high

    def _step(self, world: World, seconds: float) -> None:
        if self._watch and self._start is None:
            self._start = world.fork()
        self._steps += 1
        world.step(seconds)

    def _growth(self) -> tuple[float, float]:
        """How errors grow: e-fold at this rate, 1/s, or 0; in so many seconds. Growth is measured piece by piece, since a jump, as of an impact
        that is met a step later, would else count as a rate."""
        left, total, sensitive = self._steps, 0.0, False
        while self._start is not None and left:
            piece = self._start.measure_growth(steps=min(left, 1000000), dt=self.dt)
            total += max(math.log(max(piece.factor, 1.0)), 0.0)
            sensitive, left = sensitive or piece.sensitive, left - piece.steps
            for _ in range(piece.steps if left else 0):
                self._start.step(self.dt)
        seconds = self._steps * self.dt
        return (total / seconds, seconds) if sensitive and total > SURE else (0.0, seconds)

    def _close(self) -> None:
        for world in [*self._worlds, self._start]:
            if world is not None and not world.closed:
                world.close()


def _dials(level: int, other: bool) -> dict[str, float | str]:
    """Of a trial: all that presets set. What is an error falls with the step, or with its square.
    @param other  another way to the same answer: higher orders, more substeps, stiffer contacts"""
    fine, finer = 2.0**-level, 4.0**-level
    return {"precision": "double", "integrator": "velocity_verlet", "rotation": "splitting_6" if other else "splitting_4",
            "joint_order": 6 if other else 4, "substeps": 6 if other else 4, "solver": "auto", "sleep": "off",
            "velocity_tolerance": max(1e-5 * finer, 1e-11), "restitution_speed": 0.05 * fine, "direct_work": 1e6,
            "contact_frequency": min((90 if other else 60) / fine, 1e4), "direct_sink": 1e-3 * finer, "gjk_tolerance": max(1e-8 * finer, 1e-13)}


class _Asker:
    """Asks a question at settings and parameters, and counts."""

    def __init__(self, question: Question, world: World | None, parameters: Mapping[str, float], work: float, file: TextIO | None):
        self.question, self.world, self.parameters, self.file = question, world, dict(parameters), file
        self.engine = world.engine if world is not None else Engine()
        self.runs, self.done, self.work, self.began, self.scalar = 0, 0.0, work, time.monotonic(), True
        self.largest = 0.0  # answer, in amount
        self.growth = (0.0, 0.0)
        self.substeps = 0

    def ask(self, level: int, other: bool = False, watch: bool = False, moved: Mapping[str, float] | None = None) -> tuple[float, ...]:
        trial = Trial(self.engine, self.world, level, other, watch)
        try:
            said = self.question(trial, **{**self.parameters, **(moved or {})})
            answer = self._numbers(said)
            if watch:
                self.growth = trial._growth()
            self.substeps = max(self.substeps, 4 * trial._steps)
        finally:
            trial._close()
        self.runs, self.done = self.runs + 1, self.done + 2.0**level
        self.largest = max([self.largest, *map(abs, answer)])
        if self.file is not None:
            share = min(self.done / self.work, 1)
            left = (time.monotonic() - self.began) * (1 - share) / share
            self.file.write(f"\r[{'#' * int(24 * share):.<24}] {self.runs} runs, {left:.0f} s left ")
            self.file.flush()
        return answer

    def _numbers(self, said: Any) -> tuple[float, ...]:
        scalar = not hasattr(said, "__len__") or isinstance(said, (str, bytes))
        answer = tuple(number(x, "the question's answer") for x in ([said] if scalar else said))
        if not answer or not all(map(math.isfinite, answer)):
            raise ValueError(f"the question answered {said!r}: it must return a finite number, or a few of them")
        self.scalar = scalar
        return answer

    def shape(self, numbers: Iterable[float]) -> Any:
        """As the question answers: a number or a tuple."""
        numbers = tuple(numbers)
        return numbers[0] if self.scalar else numbers

    def close(self) -> None:
        if self.file is not None:
            self.file.write("\n")
        if self.world is None:
            self.engine.close()


def measure(question: Question, parameters: Mapping[str, float], *, world: World | None = None, trials: int = TRIALS,
            slopes: bool | Iterable[str] = True, widths: Mapping[str, float] | None = None, progress: bool | None = None,
            file: TextIO | None = None) -> Measured:
    """Ask a question about a motion: its answer with an error bar, and how it changes with each parameter.

    A question is asked some tens of times, so it must give the same for the same. What it does at certain times it may do between two
    trial.run(), and no more often than in the coarsest trial in `each`, since steps differ in length.

    @param question    function(trial, **parameters) -> a number, or a few of them: makes a world by trial.world(), lets time pass by
                       trial.run() and trial.until()
    @param parameters  numbers by name, where the answer is wanted
    @param world       trials get copies of it: World.counterpart() finds bodies of the original in a copy
    @param trials      4 to 14; each costs twice the one before, and halves the bar at least as often as not
    @param slopes      by which parameters; False: none
    @param widths      by how much a parameter may be moved at most; default an eighth of it
    @param progress    draw a line with what is done and left; None: if `file`, default sys.stderr, is a terminal
    @raise Chaotic     the answer depends on errors that nothing can lessen
    @raise ValueError, TypeError  what is wrong with the arguments or with the answer; and what the question itself raises"""
    if not callable(question):
        raise TypeError(f"question takes a function of (trial, **parameters), got {question!r}")
    if not isinstance(parameters, Mapping):
        raise TypeError(f"parameters takes numbers by name, got {parameters!r}; type parameters={{'friction': 0.4}}")
    given = {name: number(value, f"parameters[{name!r}]") for name, value in parameters.items()}
    for name, value in given.items():
        if not math.isfinite(value):
            raise ValueError(f"parameters[{name!r}] is {value}: it must be finite")
    last = whole(trials, "trials", 4, 14) - 1
    wanted = list(given) if slopes is True else [] if slopes is False else [slopes] if isinstance(slopes, str) else list(slopes)
    most = {name: number(value, f"widths[{name!r}]") for name, value in (widths or {}).items()}
    for name in [*wanted, *most]:
        if name not in given:
            raise ValueError(f"there is no parameter {name!r}; there are {', '.join(given) or 'none'}")
    for name, value in most.items():
        if not 0 < value < math.inf:
            raise ValueError(f"widths[{name!r}] is {value:g}: by how much the parameter may be moved, more than 0")
    file = sys.stderr if file is None else file
    work = 2.0 ** (last + 1) + 2.0**last + len(wanted) * (2 * WIDTHS * 2.0 ** (last - 3) + 4 * 1.75 * 2.0**last)
    asker = _Asker(question, world, given, work, file if (file.isatty() if progress is None else progress) else None)
    began = time.process_time()
    try:
        answers = [asker.ask(level, watch=level == 1) for level in range(last + 1)]
        other = asker.ask(last, other=True)
        if asker.growth[0] and any(max(trail[-3:]) - min(trail[-3:]) > OPEN * max(map(abs, trail)) for trail in zip(*answers)):
            raise Chaotic(*asker.growth)
        found = {name: _slope(asker, name, most.get(name, WIDEST * abs(given[name]) or WIDEST), last) for name in wanted}
        bars, falls = [], []
        for trail, beside in zip(zip(*answers), other):
            bar, fall = _bar(trail)
            bars.append(max(bar, SAFETY * abs(trail[-1] - beside)) + _rounding(asker, last))
            falls.append(fall)
        return Measured(value=asker.shape(answers[-1]), bar=asker.shape(bars), slopes=found, half_cost=2 ** (1 / math.log2(min(falls))),
                        lyapunov_time=1 / asker.growth[0] if asker.growth[0] else None, trials=[asker.shape(a) for a in answers],
                        runs=asker.runs, seconds=time.process_time() - began)
    finally:
        asker.close()


def _bar(trail: Sequence[float]) -> tuple[float, float]:
    """The error of the last of a row of answers, and by how much differences fall from one to the next: the least of what the last ones
    say. An earlier difference counts with what is left of it."""
    steps = [abs(b - a) for a, b in zip(trail, trail[1:])][:-4:-1]  # the last first
    ratios = [(steps[j] / steps[i]) ** (1 / (j - i)) if steps[i] else FASTEST for i in range(len(steps)) for j in range(i + 1, len(steps))]
    fall = min(max(min(ratios), SLOWEST), FASTEST)
    return SAFETY * max(step / fall**k for k, step in enumerate(steps)) / (fall - 1), fall


def _rounding(asker: _Asker, last: int) -> float:
    """What rounding leaves of an answer."""
    return ROUNDING * max(asker.largest, 2.0**-500) * max(asker.substeps << (last - 1), 16)


def _slope(asker: _Asker, name: str, widest: float, last: int) -> Slope:
    """Central differences at two widths, of which the error in the square of the width is taken out; at three trials."""
    at = asker.parameters[name]

    def quotient(level: int, width: float) -> list[float]:
        up, down = asker.ask(level, moved={name: at + width}), asker.ask(level, moved={name: at - width})
        return [(a - b) / (2 * width) for a, b in zip(up, down)]

    table: list[tuple[float, list[float]]] = []  # widths from the widest on, quotients
    coarse = last - 3
    for k in range(3 * WIDTHS):
        if len(table) == WIDTHS:
            break
        try:
            table.append((widest / 2**k, quotient(coarse, widest / 2**k)))
        except (CaromError, ArithmeticError, ValueError) as why:
            refused = why  # the parameter may not be moved that far
    if len(table) < 3:
        raise ValueError(f"the question has no answer within {widest:g} of {name} = {at:g}, so that it has no slope there: {refused} Give a smaller "
                         f"width, widths={{{name!r}: {widest / 2**(3 * WIDTHS):.3g}}}, or leave it out of slopes=") from refused
    smooth = [[(4 * fine - wide) / 3 for fine, wide in zip(table[k + 1][1], table[k][1])] for k in range(len(table) - 1)]
    apart = [[abs(a - b) for a, b in zip(smooth[k + 1], smooth[k])] for k in range(len(smooth) - 1)]
    best = min(range(len(apart)), key=lambda k: max(apart[k]))  # wider ones are bent, narrower ones noise
    width = table[best + 2][0]
    trail = []
    for level in range(last - 2, last + 1):
        narrow, wide = quotient(level, width), quotient(level, 2 * width)
        trail.append([(4 * a - b) / 3 for a, b in zip(narrow, wide)])
    rounding = _rounding(asker, last) / width
    bars = [_bar(row)[0] + bent / 4 + rounding for row, bent in zip(zip(*trail), apart[best])]  # of what is bent, a fifteenth is left
    return Slope(asker.shape(trail[-1]), asker.shape(bars), width)


def _pair(value: Any, bar: Any) -> str:
    """Two digits of the bar, and as many of the value as it leaves."""
    if isinstance(value, tuple):
        return "(" + ", ".join(_pair(v, b) for v, b in zip(value, bar)) + ")"
    if not bar > 0:
        return f"{value:.17g}"
    places = 1 - math.floor(math.log10(bar))
    if abs(value) >= 1e6 or places > 15 or places < 0:
        return f"{value:.{max(0, min(16, places + math.floor(math.log10(abs(value) or 1))))}e} +- {bar:.1e}"
    return f"{value:.{places}f} +- {bar:.{places}f}"
