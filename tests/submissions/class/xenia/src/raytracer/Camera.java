package raytracer;

class Camera {
  Vector3 eye, look, up;
  Vector3 u, v, w;
  double near = 1;
  double far;
  double left, bottom, right, top;
  int width, height;

  void setUp() {
    w = eye.from(look).unit();
    u = up.cross(w).unit();
    v = w.cross(u);
  }

  Vector3 pixel(int i, int j) {
    double a = left + (right - left) * i / (width - 1);
    double b = bottom + (top - bottom) * j / (height - 1);
    return Vector3.sum(eye, w.by(-near), u.by(a), v.by(b));
  }
}
