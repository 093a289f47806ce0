#include <fstream>
#include <iostream>
#include "Scene.h"

int byte(double c) { return c >= 1 ? 255 : static_cast<int>(c * 255); }

int main(int argc, char** argv) {
  Scene scene;
  if (argc != 3 || !scene.read(argv[1])) {
    std::cerr << "usage: prog DRIVER IMAGE" << std::endl;
    return 1;
  }
  Vec3d w = Vec3d(scene.eye).add(scene.look, -1).normalize();
  Vec3d u = scene.up.cross(w).normalize();
  Vec3d v = w.cross(u);
  double left = scene.bounds[0], right = scene.bounds[1], bottom = scene.bounds[2], top = scene.bounds[3];
  std::ofstream out(argv[2]);
  out << "P3\n" << scene.res[0] << " " << scene.res[1] << "\n255\n";
  for (int row = 0; row < scene.res[1]; row++) {
    double y = top - row * (top - bottom) / (scene.res[1] - 1);
    for (int column = 0; column < scene.res[0]; column++) {
      double x = right - column * (right - left) / (scene.res[0] - 1);
      Vec3d pixel = Vec3d(scene.eye).add(w, scene.d).add(u, x).add(v, y);
      Vec3d dir = Vec3d(pixel).add(scene.eye, -1).normalize();
      Vec3d c = scene.color(pixel, dir);
      out << byte(c.x) << " " << byte(c.y) << " " << byte(c.z) << "   ";
    }
    out << "\n";
  }
  return 0;
}
