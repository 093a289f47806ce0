#include <algorithm>
#include <fstream>
#include <iostream>
#include "scene.h"
using namespace std;

Scene scene;
V3 image[2048][2048];

bool findHit(V3 L, V3 U, double& s, int& which) {
  s = 1e300;
  which = -1;
  for (size_t k = 0; k < scene.spheres.size(); ++k) {
    const Sphere& ball = scene.spheres[k];
    V3 T = ball.c - L;
    double v = dot(T, U);
    double dsq = ball.r * ball.r - (dot(T, T) - v * v);
    if (dsq < 0) continue;
    double t = v - sqrt(dsq);
    if (t < 0) t = v + sqrt(dsq);
    if (t >= 0 && t < s) {
      s = t;
      which = k;
    }
  }
  return which >= 0;
}

V3 color(V3 L, V3 U) {
  double s;
  int k;
  if (!findHit(L, U, s, k)) return V3();
  return scene.ambient * scene.spheres[k].ka;
}

int clampByte(double c) { return min(255, max(0, int(c * 255 + 0.5))); }

int main(int argc, char** argv) {
  if (argc < 3 || !scene.load(argv[1])) {
    cerr << "usage: rt DRIVER IMAGE" << endl;
    return 1;
  }
  V3 W = normalize(scene.eye - scene.look);
  V3 U = normalize(cross(scene.up, W));
  V3 V = cross(W, U);
  for (int j = 0; j < scene.height; ++j)
    for (int i = 0; i < scene.width; ++i) {
      double px = scene.left + i * (scene.right - scene.left) / (scene.width - 1);
      double py = scene.top - j * (scene.top - scene.bottom) / (scene.height - 1);
      V3 P = scene.eye + W * scene.d + U * px + V * py;
      image[j][i] = color(P, normalize(P - scene.eye));
    }
  ofstream out(argv[2]);
  out << "P3\n" << scene.width << " " << scene.height << "\n255\n";
  for (int i = 0; i < scene.width; ++i) {
    for (int j = 0; j < scene.height; ++j) {
      V3 c = image[i][j];
      out << clampByte(c.x) << " " << clampByte(c.y) << " " << clampByte(c.z) << " ";
    }
    out << "\n";
  }
  return 0;
}
