import java.io.IOException;
import java.util.List;

/** Camera rays and spheres. */
public class Rays extends RaycheckCandidate {
  static Vector add(Vector a, double k, Vector b) {
    return new Vector(a.x() + k * b.x(), a.y() + k * b.y(), a.z() + k * b.z());
  }

  static double dot(Vector a, Vector b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
  }

  static Vector cross(Vector a, Vector b) {
    return new Vector(
        a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x());
  }

  static Vector unit(Vector a) {
    double n = Math.sqrt(dot(a, a));
    return new Vector(a.x() / n, a.y() / n, a.z() / n);
  }

  @Override
  public Frame frame(Camera camera) {
    Vector w = unit(add(camera.eye(), -1, camera.lookAt()));
    Vector u = unit(cross(camera.up(), w));
    return new Frame(u, cross(w, u), w);
  }

  Vector toPixel(Camera camera, Pixel pixel) {
    Frame f = frame(camera);
    double alpha = camera.left() + (double) pixel.i() / (camera.width() - 1) * (camera.right() - camera.left());
    double beta = camera.bottom() + (double) pixel.j() / (camera.height() - 1) * (camera.top() - camera.bottom());
    Vector zero = new Vector(0, 0, 0);
    return add(add(add(zero, camera.near(), f.w()), alpha, f.u()), beta, f.v());
  }

  @Override
  public Vector pixelPoint(Camera camera, Conventions conventions, Pixel pixel) {
    return add(camera.eye(), 1, toPixel(camera, pixel));
  }

  @Override
  public Ray pixelRay(Camera camera, Conventions conventions, Pixel pixel) {
    return new Ray(pixelPoint(camera, conventions, pixel), unit(toPixel(camera, pixel)));
  }

  @Override
  public Hit intersect(Ray ray, Sphere sphere, Conventions conventions) {
    double length = Math.sqrt(dot(ray.direction(), ray.direction()));
    Vector d = unit(ray.direction());
    Vector t = add(sphere.centre(), -1, ray.origin());
    double v = dot(t, d);
    Vector foot = add(t, -v, d);
    double square = sphere.radius() * sphere.radius() - dot(foot, foot);
    if (square < 0) return null;
    double s = v - Math.sqrt(square);
    if (s < 0) s = v + Math.sqrt(square);
    if (s < 0) return null;
    return new Hit(s / length, add(ray.origin(), s, d));
  }

  @Override
  public int nearest(Ray ray, List<Sphere> spheres, Conventions conventions) {
    for (int k = 0; k < spheres.size(); k++) {
      if (intersect(ray, spheres.get(k), conventions) != null) return k;
    }
    return -1;
  }

  public static void main(String[] args) throws IOException {
    new Rays().run("leon");
  }
}
