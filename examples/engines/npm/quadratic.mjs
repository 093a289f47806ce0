// For solvers of quadratics: a s^2 + b s + c = 0 as textbooks print it, every operation rounded.
const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];

export function coefficients({ origin, direction }, { centre, radius }) {
  const f = origin.map((x, k) => x - centre[k]);
  return { a: dot(direction, direction), b: 2 * dot(f, direction), c: dot(f, f) - radius * radius };
}

/** The first root in front of the origin, of those that a solver found; null if there is none. */
export const chosen = (roots) => roots.filter((s) => s >= 0).sort((s, t) => s - t)[0] ?? null;
