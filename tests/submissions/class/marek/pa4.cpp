#include "geometry.h"
#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

struct Driver {
  std::map<std::string, std::vector<double>> single;
  std::vector<Ball> balls;
  std::vector<Bulb> bulbs;

  explicit Driver(const char* path) {
    std::ifstream in(path);
    std::string line, key;
    while (std::getline(in, line)) {
      std::istringstream s(line);
      if (!(s >> key)) continue;
      std::vector<double> n;
      double x;
      while (s >> x) n.push_back(x);
      auto vec = [&n](int k) { return Vec{n.at(k), n.at(k + 1), n.at(k + 2)}; };
      if (key == "sphere") {
        if (n.size() != 17) throw std::string("wrong number of values for a sphere");
        balls.push_back({vec(0), n[3], vec(4), vec(7), vec(10), vec(13)});
      } else if (key == "light") {
        bulbs.push_back({vec(0), vec(4)});
      } else {
        single[key] = n;
      }
    }
  }

  const Ball* nearest(const Ray& ray, double& t) const {
    const Ball* best = nullptr;
    for (auto& ball : balls) {
      double s = ball.hit(ray);
      if (s >= 0 && (best == nullptr || s < t)) {
        best = &ball;
        t = s;
      }
    }
    return best;
  }

  Vec trace(const Ray& ray, int depth) const {
    double t, u;
    const Ball* ball = nearest(ray, t);
    if (!ball) return {};
    Vec q = ray.from + ray.dir * t, n = (q - ball->at).unit(), lifted = q + n * 1e-6;
    auto& a = single.at("ambient");
    Vec sum = Vec{a[0], a[1], a[2]} * ball->ka;
    for (auto& bulb : bulbs) {
      Vec l = (bulb.at - q).unit();
      double c = n % l;
      if (c < 0 || (nearest({lifted, l}, u) && u < (bulb.at - q).length())) continue;
      Vec r = n * (2 * c) - l;
      sum = sum + ball->kd * bulb.color * c;
      sum = sum + ball->ks * bulb.color * std::pow(std::max(0.0, -(r % ray.dir)), 16);
    }
    if (depth > 0) sum = sum + ball->kr * trace({lifted, ray.dir - n * (2 * (n % ray.dir))}, depth - 1);
    return sum;
  }
};

int main(int, char** argv) {
  try {
    Driver driver(argv[1]);
    auto& c = driver.single.at("camera");
    auto& bounds = driver.single.at("bounds");
    auto& res = driver.single.at("res");
    int depth = driver.single.at("recursionlevel")[0];
    Vec eye{c[0], c[1], c[2]}, look{c[3], c[4], c[5]}, up{c[6], c[7], c[8]};
    Vec w = (eye - look).unit(), u = (up ^ w).unit(), v = w ^ u;
    int width = res[0], height = res[1];
    // the image has y pointing down
    double left = bounds[0], right = bounds[1], bottom = -bounds[2], top = -bounds[3];

    std::vector<std::vector<Vec>> image(height, std::vector<Vec>(width));
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        double px = left + (right - left) * x / (width - 1.0);
        double py = top + (bottom - top) * y / (height - 1.0);
        Vec p = eye + w * c[9] + u * px + v * py;
        image[y][x] = driver.trace({p, (p - eye).unit()}, depth);
      }

    std::ofstream out(argv[2]);
    out << "P3\n" << width << ' ' << height << "\n255\n";
    auto level = [](double f) { return std::min(255, std::max(0, int(f * 256))); };
    for (auto& row : image) {
      for (auto& p : row) out << level(p.x) << ' ' << level(p.y) << ' ' << level(p.z) << "  ";
      out << '\n';
    }
  } catch (const std::string& what) {
    std::cerr << what << std::endl;
    return 1;
  }
}
