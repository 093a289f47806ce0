#include <cstdlib>
#include <fstream>
#include <iostream>
#include "rt.hh"

static std::istream& operator>>(std::istream& in, Vec& a) { return in >> a[0] >> a[1] >> a[2]; }

World parse(const std::string& path) {
  World world = {};
  std::ifstream in(path);
  std::string word;
  double skip;
  bool level = false;
  while (in >> word) {
    if (word == "eye") in >> world.eye;
    else if (word == "look") in >> world.look;
    else if (word == "up") in >> world.up;
    else if (word == "d") in >> world.d;
    else if (word == "bounds") in >> world.left >> world.bottom >> world.right >> world.top;
    else if (word == "res") in >> world.width >> world.height;
    else if (word == "ambient") in >> world.ambient;
    else if (word == "recursionLevel") level = bool(in >> world.recursion);
    else if (word == "light") {
      Light light;
      in >> light.pos >> skip >> light.color;
      world.lights.push_back(light);
    } else if (word == "sphere") {
      Sphere s;
      in >> s.center >> s.radius >> s.m.ka >> s.m.kd >> s.m.ks >> s.m.kr;
      for (int k = 0; k < 3; k++) in >> skip;  // opacity
      world.spheres.push_back(s);
    } else {
      std::cerr << "do not know '" << word << "'\n";
      std::exit(1);
    }
  }
  if (!level) std::exit(1);
  return world;
}
