#include "Scene.h"
#include <fstream>
#include <sstream>

bool Scene::read(const std::string& name) {
  std::ifstream file(name.c_str());
  if (!file) return false;
  std::string line, key;
  while (std::getline(file, line)) {
    std::istringstream in(line);
    in >> key;
    if (key == "eye") in >> eye;
    else if (key == "look") in >> look;
    else if (key == "up") in >> up;
    else if (key == "d") in >> d;
    else if (key == "bounds") in >> bounds[0] >> bounds[1] >> bounds[2] >> bounds[3];
    else if (key == "res") in >> res[0] >> res[1];
    else if (key == "ambient") in >> ambient;
    else if (key == "light") {
      Bulb bulb;
      double w;
      in >> bulb.position >> w >> bulb.color;
      bulbs.push_back(bulb);
    } else if (key == "sphere") {
      Ball ball;
      in >> ball.center >> ball.radius >> ball.ka >> ball.kd >> ball.ks;
      if (!in) return false;
      balls.push_back(ball);
    }
  }
  return true;
}

bool Ball::meets(const Vec3d& start, const Vec3d& dir, double& t) const {
  Vec3d toCenter = Vec3d(center).add(start, -1);
  double v = toCenter.dot(dir);
  double dsq = radius * radius - (toCenter.dot(toCenter) - v * v);
  if (dsq < 0) return false;
  t = v - std::sqrt(dsq);
  if (t < 0) t = v + std::sqrt(dsq);
  return t >= 0;
}

Vec3d Scene::color(const Vec3d& start, const Vec3d& dir) const {
  for (const Ball& ball : balls) {
    double t;
    if (!ball.meets(start, dir, t)) continue;
    Vec3d q = Vec3d(start).add(dir, t);
    Vec3d n = Vec3d(q).add(ball.center, -1).normalize();
    Vec3d sum = Vec3d(ambient).times(ball.ka);
    for (const Bulb& bulb : bulbs) {
      Vec3d l = Vec3d(bulb.position).add(q, -1).normalize();
      double cosine = n.dot(l);
      if (cosine <= 0) continue;
      sum.add(Vec3d(ball.kd).times(bulb.color), cosine);
      double shine = Vec3d(l).add(n, -2 * cosine).dot(dir);
      if (shine > 0) sum.add(Vec3d(ball.ks).times(bulb.color), std::pow(shine, 16));
    }
    return sum;
  }
  return Vec3d();
}
