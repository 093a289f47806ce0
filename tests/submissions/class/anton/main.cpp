#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>
#include "camera.hpp"

struct Ball {
  V c;
  double r;
  V ka, kd, ks, kr;
};
struct Lamp {
  V at, rgb;
};

static std::vector<Ball> balls;
static std::vector<Lamp> lamps;
static V ambient(0, 0, 0);

static const Ball* cast(const V& o, const V& d, double& s) {
  const Ball* first = nullptr;
  for (const Ball& ball : balls) {
    const V t = ball.c - o;
    const double v = t.dot(d), b = (t - v * d).norm();
    if (b > ball.r) continue;
    const double half = std::sqrt(ball.r * ball.r - b * b);
    double root = v - half;
    if (root < 0) root = v + half;
    if (root < 0 || (first && root >= s)) continue;
    s = root;
    first = &ball;
  }
  return first;
}

static V colour(const V& o, const V& d, int bounces) {
  double s, s2;
  const Ball* ball = cast(o, d, s);
  if (!ball) return V::Zero();
  const V q = o + s * d, n = (q - ball->c) / ball->r, above = q + 1e-6 * n;
  V sum = ambient.cwiseProduct(ball->ka);
  for (const Lamp& lamp : lamps) {
    const V l = (lamp.at - q).normalized();
    if (n.dot(l) <= 0) continue;
    if (cast(above, l, s2) && s2 < (lamp.at - q).norm()) continue;
    sum += n.dot(l) * lamp.rgb.cwiseProduct(ball->kd);
    const V r = 2 * n.dot(l) * n - l;
    sum += std::pow(std::max(0.0, -r.dot(d)), 16) * lamp.rgb.cwiseProduct(ball->ks);
  }
  if (bounces > 0 && !ball->kr.isZero())
    sum += ball->kr.cwiseProduct(colour(above, d - 2 * d.dot(n) * n, bounces - 1));
  return sum;
}

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "raytracer DRIVER IMAGE\n";
    return 2;
  }
  Camera camera;
  int bounces = 0;
  std::ifstream file(argv[1]);
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line);
    std::string key;
    if (!(in >> key) || key.front() == '#') continue;
    std::vector<double> n;
    for (double x; in >> x;) n.push_back(x);
    auto v = [&](int k) { return V(n.at(k), n.at(k + 1), n.at(k + 2)); };
    if (key == "camera") camera = Camera(v(0), v(3), v(6), n.at(9));
    else if (key == "bounds") camera.bounds(n.at(0), n.at(1), n.at(2), n.at(3));
    else if (key == "res") camera.resolution(n.at(0), n.at(1));
    else if (key == "recursionlevel") bounces = n.at(0);
    else if (key == "ambient") ambient = v(0);
    else if (key == "light") lamps.push_back({v(0), v(4)});
    else if (key == "sphere") balls.push_back({v(0), n.at(3), v(4), v(7), v(10), v(13)});
    else if (key != "model") throw std::runtime_error("unknown keyword " + key);
  }
  std::ofstream out(argv[2]);
  out << "P3\n" << camera.width() << " " << camera.height() << "\n255\n";
  for (int row = 0; row < camera.height(); ++row, out << "\n")
    for (int column = 0; column < camera.width(); ++column) {
      auto [start, direction] = camera.ray(column, row);
      V c = (255 * colour(start, direction, bounces)).cwiseMin(255);
      out << int(c[0]) << " " << int(c[1]) << " " << int(c[2]) << " ";
    }
}
