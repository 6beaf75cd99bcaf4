"""Events of contacts: when a ball that falls 2 m hits the ground, and how fast."""
import math

import carom

with carom.Engine() as engine, engine.world() as world:
    world.ground()
    ball = world.body(engine.sphere(0.5), position=(0, 2.5, 0))
    world.collect_events("contact", hit_speed=1)
    found = []
    for step in range(60):
        world.step(1 / 60)  # events are those of the last step
        found += [((step + 1) / 60, event) for event in world.contact_events() if event.kind == "hit"]
    at, hit = found[0]
    print(f"{len(found)} hit, after {at:.2f} s, at {hit.approach_speed:.2f} m/s")
    fall = math.sqrt(2 * 2 / 9.81)  # s
    assert len(found) == 1 and ball in (hit.body_a, hit.body_b)
    assert abs(at - fall) < 2 / 60 and abs(hit.approach_speed - 9.81 * fall) < 9.81 / 60
