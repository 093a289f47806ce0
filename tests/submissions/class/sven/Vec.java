public record Vec(double x, double y, double z) {
  Vec add(Vec o) { return new Vec(x + o.x, y + o.y, z + o.z); }
  Vec sub(Vec o) { return new Vec(x - o.x, y - o.y, z - o.z); }
  Vec mul(Vec o) { return new Vec(x * o.x, y * o.y, z * o.z); }
  Vec mul(double k) { return new Vec(k * x, k * y, k * z); }
  double dot(Vec o) { return x * o.x + y * o.y + z * o.z; }
  Vec cross(Vec o) { return new Vec(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x); }
  Vec norm() { return mul(1 / Math.sqrt(dot(this))); }
}
