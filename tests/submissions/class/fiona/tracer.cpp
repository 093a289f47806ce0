#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>
#include "camera.h"
#include "sphere.h"

struct light {
  vec3 at;
  double w;
  vec3 color;
};

camera cam;
vec3 ambient;
std::vector<sphere> spheres;
std::vector<light> lights;
int recursion = 0;

void load(std::ifstream in) {
  std::string key;
  double opacity, eta;
  while (in >> key) {
    if (key == "eye") in >> cam.eye;
    else if (key == "look") in >> cam.look;
    else if (key == "up") in >> cam.up;
    else if (key == "d") in >> cam.d;
    else if (key == "bounds") in >> cam.left >> cam.bottom >> cam.right >> cam.top;
    else if (key == "res") in >> cam.width >> cam.height;
    else if (key == "ambient") in >> ambient;
    else if (key == "recursionLevel") in >> recursion;
    else if (key == "light") {
      lights.emplace_back();
      in >> lights.back().at >> lights.back().w >> lights.back().color;
    } else if (key == "sphere") {
      spheres.emplace_back();
      sphere& s = spheres.back();
      in >> s.center >> s.radius >> s.ka >> s.kd >> s.ks >> s.kr >> opacity >> eta;
    } else {
      std::cerr << "line not understood: " << key << std::endl;
      std::exit(-1);
    }
  }
}

vec3 trace(const ray& r, int level) {
  double s, blocked;
  const sphere* hit = nearest(spheres, r, s);
  if (!hit) return {};
  vec3 q = r.from + r.to * s, n = normalize(q - hit->center), start = q + n * 1e-6;
  vec3 color = ambient * hit->ka;
  for (auto& l : lights) {
    vec3 to = normalize(l.at - q);
    double cosine = dot(n, to);
    if (cosine <= 0) continue;
    if (nearest(spheres, {start, to}, blocked) && blocked < length(l.at - q)) continue;
    vec3 mirror = n * (2 * cosine) - to;
    color = color + hit->kd * l.color * cosine;
    color = color + hit->ks * l.color * std::pow(std::max(0.0, -dot(mirror, r.to)), 16);
  }
  if (level > 0) color = color + hit->kr * trace({start, r.to - n * (2 * dot(n, r.to))}, level - 1);
  return color;
}

int main(int argc, char* argv[]) {
  if (argc < 3) return -1;
  load(std::ifstream(argv[1]));
  std::ofstream image(argv[2]);
  image << "P3\n" << cam.width << " " << cam.height << "\n255\n";
  for (int j = cam.height - 1; j >= 0; j--) {
    for (int i = 0; i < cam.width; i++) {
      vec3 c = trace(cam.shoot(i, j), recursion);
      for (double x : {c.x, c.y, c.z}) image << std::min(255, static_cast<int>(x * 255 + 0.5)) << " ";
    }
    image << "\n";
  }
}
