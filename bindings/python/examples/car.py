"""A car brakes: from 20 m/s on tyres of grip 1 it needs v^2 / (2 g) = 20.4 m."""
import carom

with carom.Engine() as engine, engine.world() as world:
    world.ground()
    body = world.body(position=(0, 0.6, 0), mass=1200, center=(0, 0, 0), inertia=(1600, 0, 0, 0, 1800, 0, 0, 0, 500))
    body.collider(engine.box(0.85, 0.3, 2), position=(0, 0.15, 0))
    car = carom.Vehicle(body, [{"position": (x, -0.32, z), "brake": 1e5, "slide": 1} for z in (1.3, -1.3) for x in (0.75, -0.75)])

    def frames(n, **how):
        for _ in range(n):
            car.drive(1 / 60, gear=0, **how)
            world.step(1 / 60)

    frames(120)  # it settles on its springs
    body.linear_velocity = (0, 0, 20)
    for wheel in car.wheels:
        wheel.spin = 20 / 0.33
    begin = body.position[2]
    frames(210, brake=1)
    way = body.position[2] - begin
    print(f"it brakes from 20 m/s in {way:.1f} m and stands: {abs(car.speed):.2f} m/s")
    assert abs(way - 400 / (2 * 9.81)) < 0.5 and abs(car.speed) < 1e-3
