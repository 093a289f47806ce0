#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>
#include "ball.h"

using std::ifstream;
using std::istringstream;
using std::max;
using std::ofstream;
using std::runtime_error;
using std::string;
using std::vector;

struct Lamp {
  Vector3 where;
  double rgb[3];
};

vector<Ball> balls;
vector<Lamp> lamps;
double ambient[3];

int nearestBall(const Vector3& start, const Vector3& dir, double& dist) {
  int best = -1;
  for (int k = 0; k < (int)balls.size(); k++) {
    double s = balls[k].distance(start, dir);
    if (s < 0) continue;
    if (best < 0 || s < dist) {
      best = k;
      dist = s;
    }
  }
  return best;
}

void pixelColor(const Vector3& start, const Vector3& dir, int rgb[3]) {
  double dist = 0, other;
  int k = nearestBall(start, dir, dist);
  rgb[0] = rgb[1] = rgb[2] = 0;
  if (k < 0) return;
  Vector3 hit = plus(start, dir, dist);
  Vector3 normal = unit(plus(hit, balls[k].middle, -1));
  for (int c = 0; c < 3; c++) rgb[c] = (int)(ambient[c] * balls[k].ambient[c]);
  for (size_t l = 0; l < lamps.size(); l++) {
    Vector3 toLamp = unit(plus(lamps[l].where, hit, -1));
    double cosine = dot(normal, toLamp);
    if (cosine <= 0) continue;
    if (nearestBall(plus(hit, normal, 1e-6), toLamp, other) >= 0) continue;  // in the shadow
    Vector3 mirrored = plus(toLamp, normal, -2 * cosine);
    double glance = max(0.0, dot(mirrored, dir));
    for (int c = 0; c < 3; c++) {
      rgb[c] += (int)(lamps[l].rgb[c] * balls[k].diffuse[c] * cosine);
      rgb[c] += (int)(lamps[l].rgb[c] * balls[k].specular[c] * pow(glance, 16));
    }
  }
  for (int c = 0; c < 3; c++)
    if (rgb[c] > 255) rgb[c] = 255;
}

int main(int argc, char** argv) {
  Vector3 eye, look, up;
  double d = 0, bounds[4];
  int res[2];
  if (argc != 3) throw "two arguments, please";
  ifstream in(argv[1]);
  string line;
  while (getline(in, line)) {
    istringstream s(line);
    string key;
    s >> key;
    double n[16];
    int count = 0;
    while (count < 16 && s >> n[count]) count++;
    if (key == "eye") eye = make(n[0], n[1], n[2]);
    else if (key == "look") look = make(n[0], n[1], n[2]);
    else if (key == "up") up = make(n[0], n[1], n[2]);
    else if (key == "d") d = n[0];
    else if (key == "bounds") memcpy(bounds, n, sizeof bounds);
    else if (key == "res") res[0] = (int)n[0], res[1] = (int)n[1];
    else if (key == "ambient") memcpy(ambient, n, sizeof ambient);
    else if (key == "light") {
      Lamp lamp;
      lamp.where = make(n[0], n[1], n[2]);
      memcpy(lamp.rgb, n + 4, sizeof lamp.rgb);
      lamps.push_back(lamp);
    } else if (key == "sphere" && count == 16) balls.push_back(Ball(n));
    else if (key != "") throw runtime_error("I do not know the line " + line);
  }
  Vector3 w = unit(plus(eye, look, -1)), u = unit(cross(up, w)), v = cross(w, u);
  ofstream out(argv[2]);
  out << "P3 " << res[0] << " " << res[1] << " 255\n";
  for (int y = 0; y < res[1]; y++) {
    double b = bounds[3] - (bounds[3] - bounds[2]) / (res[1] - 1) * y;
    for (int x = 0; x < res[0]; x++) {
      double a = bounds[0] + (bounds[1] - bounds[0]) / (res[0] - 1) * x;
      Vector3 p = plus(plus(plus(eye, w, d), u, a), v, b);
      int rgb[3];
      pixelColor(p, unit(plus(p, eye, -1)), rgb);
      out << rgb[0] << " " << rgb[1] << " " << rgb[2] << "\n";
    }
  }
  return 0;
}
