#include <fstream>
#include <string>
#include <vector>
#include "sphere.h"

int main(int argc, char** argv) {
  std::ifstream in(argv[1]);
  std::vector<Sphere*> spheres;
  int width = 0, height = 0;
  for (std::string key; in >> key;) {
    if (key == "res") in >> width >> height;
  }
  std::ofstream out(argv[2]);
  out << "P3 " << width << " " << height << " 255\n";
  for (int k = 0; k < width * height; k++) {
    int seen = 0;
    for (Sphere* s : spheres) seen += s.radius > 0;
    out << 255 * (seen > 0) << " 0 0\n";
  }
}
