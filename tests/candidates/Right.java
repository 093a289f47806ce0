/** A candidate that is right, in Java: intersections and the nearest sphere. */
public class Right extends RaycheckCandidate {
  private static Vector minus(Vector a, Vector b) {
    return new Vector(a.x() - b.x(), a.y() - b.y(), a.z() - b.z());
  }
  private static double dot(Vector a, Vector b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
  }
  private static Vector cross(Vector a, Vector b) {
    return new Vector(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
        a.x() * b.y() - a.y() * b.x());
  }

  @Override
  public Hit intersect(Ray ray, Sphere sphere, Conventions asked) {
    Vector d = ray.direction(), to = minus(sphere.centre(), ray.origin()), moment = cross(to, d);
    double a = dot(d, d), b = dot(to, d), r = sphere.radius();
    double discriminant = a * r * r - dot(moment, moment);
    if (discriminant < 0 || (discriminant == 0 && asked.tangent().equals("miss"))) return null;
    double q = b >= 0 ? b + Math.sqrt(discriminant) : b - Math.sqrt(discriminant);
    double distance = Math.sqrt(dot(to, to));
    double one = q / a, other = q == 0 ? 0 : (distance - r) * (distance + r) / q;
    double s = Math.min(one, other);
    if (s < 0 && asked.root().equals("nearest")) s = Math.max(one, other);
    if (s < 0) return null;
    Vector o = ray.origin();
    return new Hit(s, new Vector(o.x() + s * d.x(), o.y() + s * d.y(), o.z() + s * d.z()));
  }

  @Override
  public int nearest(Ray ray, java.util.List<Sphere> spheres, Conventions asked) {
    int found = -1;
    double least = 0;
    for (int k = 0; k < spheres.size(); ++k) {
      Hit hit = intersect(ray, spheres.get(k), asked);
      if (hit == null || (found >= 0 && hit.s() >= least)) continue;
      found = k;
      least = hit.s();
    }
    return found;
  }

  public static void main(String[] arguments) throws java.io.IOException {
    new Right().run("right");
  }
}
