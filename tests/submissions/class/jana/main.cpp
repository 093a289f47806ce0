#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>
#include "sphere.h"
using namespace std;

istream& operator>>(istream& in, Vec& v) { return in >> v.x >> v.y >> v.z; }

int main(int argc, char** argv) {
  Vec eye, look, up, ambient;
  double d, left, right, bottom, top;
  int width, height, level;
  vector<Sphere> spheres;
  ifstream in(argv[1]);
  string key;
  while (in >> key) {
    if (key == "eye") in >> eye;
    else if (key == "look") in >> look;
    else if (key == "up") in >> up;
    else if (key == "d") in >> d;
    else if (key == "bounds") in >> left >> right >> bottom >> top;
    else if (key == "res") in >> width >> height;
    else if (key == "recursionlevel") in >> level;
    else if (key == "ambient") in >> ambient;
    else if (key == "sphere") {
      Sphere s;
      Vec kr;
      in >> s.center >> s.radius >> s.ka >> s.kd >> s.ks >> kr;
      spheres.push_back(s);
    } else getline(in, key);
  }
  Vec w = (eye - look).unit(), u = up.cross(w).unit(), v = w.cross(u);
  ofstream out(argv[2]);
  out << "P3\n" << width << " " << height << "\n255\n";
  for (int j = height - 1; j >= 0; j--) {
    for (int i = 0; i < width; i++) {
      double a = left + (right - left) * i / (width - 1);
      double b = bottom + (top - bottom) * j / (height - 1);
      Vec p = eye + w.scale(d) + u.scale(a) + v.scale(b);
      Vec dir = (p - eye).unit();
      Sphere* nearest = NULL;
      double best, s;
      for (Sphere& sphere : spheres) {
        if (sphere.hit(p, dir, s) && (nearest == NULL || s < best)) {
          best = s;
          nearest = &sphere;
        }
      }
      Vec c = {0, 0, 0};
      if (nearest) c = {ambient.x * nearest.ka.x, ambient.y * nearest.ka.y, ambient.z * nearest.ka.z};
      out << int(255 * c.x) << " " << int(255 * c.y) << " " << int(255 * c.z) << " ";
    }
    out << endl;
  }
}
