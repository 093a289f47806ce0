#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>

struct P3 {
  double x, y, z;
};

static P3 sub(const P3& a, const P3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static P3 axpy(double t, const P3& a, const P3& b) { return {t * a.x + b.x, t * a.y + b.y, t * a.z + b.z}; }
static double dot(const P3& a, const P3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static P3 cross(const P3& a, const P3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static P3 unit(const P3& a) { return axpy(1 / std::sqrt(dot(a, a)), a, {0, 0, 0}); }

struct Sphere {
  P3 c;
  double r;
  double ka[3], kd[3], ks[3], kr[3];
};

struct Light {
  P3 p;
  double rgb[3];
};

static std::vector<Sphere> spheres;
static std::vector<Light> lights;
static double ambient[3];

static int find(const P3& L, const P3& U, double& s) {
  int found = -1;
  for (int k = 0; k < int(spheres.size()); ++k) {
    P3 T = sub(spheres[k].c, L);
    double v = dot(T, U);
    double cc = dot(T, T);
    double rr = spheres[k].r * spheres[k].r;
    double dd = rr - (cc - v * v);
    if (dd < 0) continue;
    double d = std::sqrt(dd);
    double t = v - d;
    if (t < 0) t = v + d;
    if (t < 0) continue;
    if (found < 0 || t < s) {
      s = t;
      found = k;
    }
  }
  return found;
}

static void trace(const P3& L, const P3& U, int depth, double* rgb) {
  double s, st;
  rgb[0] = rgb[1] = rgb[2] = 0;
  int k = find(L, U, s);
  if (k < 0) return;
  const Sphere& ball = spheres[k];
  P3 Q = axpy(s, U, L), N = unit(sub(Q, ball.c)), out = axpy(1e-6, N, Q);
  for (int c = 0; c < 3; ++c) rgb[c] = ambient[c] * ball.ka[c];
  for (const Light& l : lights) {
    P3 D = unit(sub(l.p, Q));
    double cosine = dot(N, D);
    if (cosine < 0 || find(out, D, st) >= 0) continue;
    P3 R = axpy(2 * cosine, N, {-D.x, -D.y, -D.z});
    double spec = std::pow(std::max(0.0, -dot(R, U)), 16);
    for (int c = 0; c < 3; ++c) rgb[c] += l.rgb[c] * (ball.kd[c] * cosine + ball.ks[c] * spec);
  }
  if (depth > 0) {
    double more[3];
    trace(out, unit(axpy(-2 * dot(N, U), N, U)), depth - 1, more);
    for (int c = 0; c < 3; ++c) rgb[c] += ball.kr[c] * more[c];
  }
}

int main(int argc, char* argv[]) {
  P3 eye, look, up;
  double d, left, bottom, right, top, w4;
  int width, height, depth = -1;
  std::ifstream in(argv[1]);
  std::string line, key;
  while (std::getline(in, line)) {
    std::istringstream s(line);
    if (!(s >> key)) continue;
    if (key == "eye") s >> eye.x >> eye.y >> eye.z;
    else if (key == "look") s >> look.x >> look.y >> look.z;
    else if (key == "up") s >> up.x >> up.y >> up.z;
    else if (key == "d") s >> d;
    else if (key == "bounds") s >> left >> bottom >> right >> top;
    else if (key == "res") s >> width >> height;
    else if (key == "recursionLevel") s >> depth;
    else if (key == "ambient") s >> ambient[0] >> ambient[1] >> ambient[2];
    else if (key == "light") {
      Light l;
      s >> l.p.x >> l.p.y >> l.p.z >> w4 >> l.rgb[0] >> l.rgb[1] >> l.rgb[2];
      lights.push_back(l);
    } else if (key == "sphere") {
      Sphere b;
      s >> b.c.x >> b.c.y >> b.c.z >> b.r;
      for (double* k : {b.ka, b.kd, b.ks, b.kr}) s >> k[0] >> k[1] >> k[2];
      spheres.push_back(b);
    }
    if (s.fail()) {
      std::cerr << "could not read: " << line << std::endl;
      exit(1);
    }
  }
  if (depth < 0) {
    std::cerr << "recursionLevel missing" << std::endl;
    exit(1);
  }
  P3 W = unit(sub(eye, look));
  P3 U = unit(cross(W, up));
  P3 V = cross(W, U);
  std::ofstream out(argv[2]);
  out << "P3\n" << width << " " << height << "\n" << 255 << "\n";
  for (int j = height - 1; j >= 0; --j) {
    double py = bottom + (top - bottom) * j / (height - 1);
    for (int i = 0; i < width; ++i) {
      double px = left + (right - left) * i / (width - 1), rgb[3];
      P3 P = axpy(-d, W, axpy(px, U, axpy(py, V, eye)));
      trace(P, unit(sub(P, eye)), depth, rgb);
      for (int c = 0; c < 3; ++c) out << (rgb[c] > 1 ? 255 : int(255 * rgb[c])) << " ";
    }
    out << "\n";
  }
  return 0;
}
