#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <vector>
#include "../eigen/Eigen/Dense"

typedef Eigen::Vector3d Vec;

class Camera {
 public:
  Camera(Vec e, Vec l, Vec up, double dist, const std::vector<double>& bounds, int w, int h)
      : eye(e), d(dist), width(w), height(h) {
    W = (e - l).normalized();
    U = up.cross(W).normalized();
    V = W.cross(U);
    left = bounds.at(0);
    right = bounds.at(1);
    bottom = bounds.at(2);
    top = bounds.at(1);
  }
  Vec pixel(int i, int j) const {
    double a = left + (right - left) * i / (width - 1.0);
    double b = bottom + (top - bottom) * j / (height - 1.0);
    return eye + d * W + a * U + b * V;
  }
  Vec eye, U, V, W;
  double d, left, right, bottom, top;
  int width, height;
};

class Sphere {
 public:
  explicit Sphere(const std::vector<double>& n) {
    if (n.size() != 16) throw std::runtime_error("sphere lines have 16 numbers");
    center = Vec(n[0], n[1], n[2]);
    radius = n[3];
    ka = Vec(n[4], n[5], n[6]);
    kd = Vec(n[7], n[8], n[9]);
    ks = Vec(n[10], n[11], n[12]);
    kr = Vec(n[13], n[14], n[15]);
  }
  bool intersect(const Vec& L, const Vec& D, double& s) const {
    Vec T = center - L;
    double v = T.dot(D);
    double csq = T.squaredNorm();
    double disc = radius * radius - (csq - v * v);
    if (disc < 0) return false;
    double d = std::sqrt(disc);
    s = v - d;
    if (s < 0) s = v + d;
    return s >= 0;
  }
  Vec center, ka, kd, ks, kr;
  double radius;
};

std::vector<Sphere> balls;
std::vector<std::pair<Vec, Vec>> lights;
Vec ambient;

const Sphere* closest(const Vec& L, const Vec& D, double& s) {
  const Sphere* found = NULL;
  for (std::size_t k = 0; k < balls.size(); k++) {
    double t;
    if (balls[k].intersect(L, D, t) && (!found || t < s)) {
      s = t;
      found = &balls[k];
    }
  }
  return found;
}

Vec trace(const Vec& L, const Vec& D, int depth) {
  double s;
  const Sphere* ball = closest(L, D, s);
  if (!ball) return Vec(0, 0, 0);
  Vec Q = L + s * D, N = (Q - ball->center).normalized();
  Vec color = ambient.cwiseProduct(ball->ka);
  Vec start = Q + 1e-6 * N;
  for (std::size_t k = 0; k < lights.size(); k++) {
    Vec toLight = lights[k].first - Q;
    double far = toLight.norm(), t;
    toLight /= far;
    double nl = N.dot(toLight);
    if (nl < 0) continue;
    if (closest(start, toLight, t) && t < far) continue;
    Vec R = 2 * nl * N - toLight;
    color += nl * ball->kd.cwiseProduct(lights[k].second);
    color += std::pow(std::max(0.0, -R.dot(D)), 16) * ball->ks.cwiseProduct(lights[k].second);
  }
  if (depth > 0)
    color += ball->kr.cwiseProduct(trace(start, D - 2 * D.dot(N) * N, depth - 1));
  return color;
}

int main(int argc, char* argv[]) {
  try {
    std::ifstream in(argv[1]);
    std::string line, key;
    std::vector<double> eye, look, up, d, bounds, res, level(1, 0);
    while (std::getline(in, line)) {
      std::istringstream words(line);
      if (!(words >> key) || key[0] == '#') continue;
      std::vector<double> n;
      double x;
      while (words >> x) n.push_back(x);
      if (key == "eye") eye = n;
      else if (key == "look") look = n;
      else if (key == "up") up = n;
      else if (key == "d") d = n;
      else if (key == "bounds") bounds = n;
      else if (key == "res") res = n;
      else if (key == "recursionlevel") level = n;
      else if (key == "ambient") ambient = Vec(n.at(0), n.at(1), n.at(2));
      else if (key == "light") lights.push_back({Vec(n.at(0), n.at(1), n.at(2)), Vec(n.at(4), n.at(5), n.at(6))});
      else if (key == "sphere") balls.push_back(Sphere(n));
      else throw std::runtime_error("bad line: " + line);
    }
    if (lights.empty()) throw std::runtime_error("no light in the scene");
    Camera cam(Vec(eye.data()), Vec(look.data()), Vec(up.data()), d.at(0), bounds, res.at(0), res.at(1));
    std::ofstream out(argv[2]);
    out << "P3\n# ray traced\n" << cam.width << " " << cam.height << "\n255\n";
    for (int j = cam.height - 1; j >= 0; j--) {
      for (int i = 0; i < cam.width; i++) {
        Vec P = cam.pixel(i, j);
        Vec c = 255 * trace(P, (P - cam.eye).normalized(), level[0]);
        for (int k = 0; k < 3; k++) out << std::min(255, (int)c[k]) << ' ';
      }
      out << '\n';
    }
  } catch (std::exception& e) {
    std::cout << "error: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}
