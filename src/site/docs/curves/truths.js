// Motions that are known: by a closed form, or by their equation of motion in steps so short that all digits are right.

/** Runge and Kutta's fourth-order rule.   @param rate (state) => its derivative   @returns the state after `seconds` */
export function integrate(rate, state, seconds, steps) {
  const h = seconds / steps,
    on = (s, k, f) => s.map((x, i) => x + f * k[i]);
  for (let i = 0; i < steps; ++i) {
    const a = rate(state),
      b = rate(on(state, a, h / 2)),
      c = rate(on(state, b, h / 2)),
      d = rate(on(state, c, h));
    state = state.map((x, k) => x + (h / 6) * (a[k] + 2 * b[k] + 2 * c[k] + d[k]));
  }
  return state;
}

/** A state that is asked for at one time after the other.   @param finest s   @returns (time) => state */
export function follow(rate, state, finest) {
  let at = 0;
  return (time) => {
    const steps = Math.max(1, Math.round((time - at) / finest));
    if (time > at) state = integrate(rate, state, time - at, steps);
    at = time;
    return state;
  };
}

/** A rigid body that nothing turns: spin about its own axes (3), orientation x, y, z, w (4).   @param inertia [3] */
export function freeSpin([a, b, c]) {
  return ([p, q, r, x, y, z, w]) => [
    ((b - c) * q * r) / a,
    ((c - a) * r * p) / b,
    ((a - b) * p * q) / c,
    (w * p + y * r - z * q) / 2,
    (w * q + z * p - x * r) / 2,
    (w * r + x * q - y * p) / 2,
    (-x * p - y * q - z * r) / 2,
  ];
}

/** rad between two orientations: by the sine, which keeps small angles. */
export function between([a, b, c, d], [x, y, z, w]) {
  const turn = [d * x - a * w - b * z + c * y, d * y - b * w - c * x + a * z, d * z - c * w - a * y + b * x];
  return 2 * Math.asin(Math.min(1, Math.hypot(...turn) / (Math.hypot(a, b, c, d) * Math.hypot(x, y, z, w))));
}

/** m: height of a ball's middle that is dropped and bounces up with `keeps` times its speed.
 *  @param drop m: how far it falls first */
export function bounced(drop, keeps, radius, gravity, time) {
  const first = Math.sqrt((2 * drop) / gravity);
  if (time < first) return radius + drop - (gravity * time * time) / 2;
  let speed = keeps * gravity * first,
    at = first;
  while (speed > 1e-9 && time - at >= (2 * speed) / gravity) ((at += (2 * speed) / gravity), (speed *= keeps));
  const t = time - at;
  return radius + (speed > 1e-9 ? speed * t - (gravity * t * t) / 2 : 0);
}
