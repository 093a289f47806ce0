#include "scene.h"
#include <fstream>
#include <iostream>
using namespace std;

static istream& operator>>(istream& in, V3& v) { return in >> v.x >> v.y >> v.z; }

// sphere lines have 13 numbers, token by token
bool Scene::load(const string& file) {
  ifstream in(file.c_str());
  string key;
  while (in >> key) {
    if (key == "eye") in >> eye;
    else if (key == "look") in >> look;
    else if (key == "up") in >> up;
    else if (key == "d") in >> d;
    else if (key == "bounds") in >> left >> right >> bottom >> top;
    else if (key == "res") in >> width >> height;
    else if (key == "ambient") in >> ambient;
    else if (key == "light") {
      V3 pos, rgb;
      double w;
      in >> pos >> w >> rgb;
    } else if (key == "sphere") {
      Sphere s;
      V3 kd, ks;
      in >> s.c >> s.r >> s.ka >> kd >> ks;
      spheres.push_back(s);
    } else {
      cerr << "unknown: " << key << endl;
      return false;
    }
  }
  return !spheres.empty();
}
