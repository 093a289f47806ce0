public record Ball(Vec center, double radius, Vec ka, Vec kd, Vec ks, Vec kr) {
  private static final double EPS = 1e-3;

  /** Where the ray enters the ball, or leaves it when it starts inside; -1 when there is no such place. */
  double hit(Vec o, Vec d) {
    Vec t = center.sub(o);
    double v = t.dot(d);
    double disc = radius * radius - t.dot(t) + v * v;
    if (disc < 0) return -1;
    double root = Math.sqrt(disc);
    double s = v - root >= 0 ? v - root : v + root;
    return s > EPS ? s : -1;
  }
}
