package raytracer;

class Vector3 {
  double x, y, z;

  Vector3(double x, double y, double z) {
    this.x = x;
    this.y = y;
    this.z = z;
  }

  static Vector3 sum(Vector3... all) {
    Vector3 s = new Vector3(0, 0, 0);
    for (Vector3 v : all) {
      s.x += v.x;
      s.y += v.y;
      s.z += v.z;
    }
    return s;
  }

  Vector3 by(double k) { return new Vector3(k * x, k * y, k * z); }
  Vector3 by(Vector3 o) { return new Vector3(o.x * x, o.y * y, o.z * z); }
  Vector3 from(Vector3 o) { return new Vector3(x - o.x, y - o.y, z - o.z); }
  double dot(Vector3 o) { return x * o.x + y * o.y + z * o.z; }
  double length() { return Math.sqrt(this.dot(this)); }
  Vector3 unit() { return by(1.0 / length()); }
  Vector3 cross(Vector3 o) { return new Vector3(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x); }
}
