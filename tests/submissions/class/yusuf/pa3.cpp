#include <cmath>
#include <iostream>
#include <sstream>
#include "image.h"
using namespace std;

struct Vec {
  double x, y, z;
};
Vec operator+(Vec a, Vec b) { return Vec{a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return Vec{a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(double k, Vec a) { return Vec{k * a.x, k * a.y, k * a.z}; }
double operator*(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) { return Vec{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Vec unit(Vec a) { return (1 / sqrt(a * a)) * a; }

struct Sphere {
  Vec c;
  double r;
  Color ka, kd, ks;
};
struct Light {
  Vec p;
  Color c;
};

struct Scene {
  Vec eye, look, up;
  Color ambient;
  double d, left, right, bottom, top;
  int width, height;
  vector<Sphere> spheres;
  vector<Light> lights;
};

istream& operator>>(istream& in, Vec& v) { return in >> v.x >> v.y >> v.z; }
istream& operator>>(istream& in, Color& c) { return in >> c.r >> c.g >> c.b; }

Scene parse(ifstream in) {
  Scene s;
  string line, key;
  while (getline(in, line)) {
    stringstream words(line);
    words >> key;
    if (key == "eye") words >> s.eye;
    if (key == "look") words >> s.look;
    if (key == "up") words >> s.up;
    if (key == "d") words >> s.d;
    if (key == "bounds") words >> s.left >> s.right >> s.bottom >> s.top;
    if (key == "res") words >> s.width >> s.height;
    if (key == "ambient") words >> s.ambient;
    if (key == "light") {
      Light l;
      double w;
      words >> l.p >> w >> l.c;
      s.lights.push_back(l);
    }
    if (key == "sphere") {
      Sphere b;
      words >> b.c >> b.r >> b.ka >> b.kd >> b.ks;
      s.spheres.push_back(b);
    }
    key.clear();
  }
  return s;
}

double intersect(const Sphere& s, Vec from, Vec dir) {
  Vec t = s.c - from;
  double v = t * dir, disc = s.r * s.r - (t * t - v * v);
  if (disc < 0) return -1;
  double near = v - sqrt(disc), far = v + sqrt(disc);
  return near >= 0 ? near : far;
}

Color shade(const Scene& scene, Vec from, Vec dir) {
  const Sphere* hit = 0;
  double best = 0;
  for (const Sphere& s : scene.spheres) {
    double t = intersect(s, from, dir);
    if (t >= 0 && (!hit || t < best)) best = t, hit = &s;
  }
  Color c;
  if (!hit) return c;
  Vec q = from + best * dir, n = unit(q - hit->c);
  c.r = scene.ambient.r * hit->ka.r;
  c.g = scene.ambient.g * hit->ka.g;
  c.b = scene.ambient.b * hit->ka.b;
  for (const Light& l : scene.lights) {
    double nl = n * unit(l.p - q);
    if (nl <= 0) continue;
    c.r += nl * hit->kd.r * l.c.r;
    c.g += nl * hit->kd.g * l.c.g;
    c.b += nl * hit->kd.b * l.c.b;
  }
  return c;
}

void render(const Scene& scene, Image image) {
  Vec w = unit(scene.eye - scene.look), u = unit(cross(scene.up, w)), v = cross(w, u);
  for (int y = 0; y < image.height; y++) {
    for (int x = 0; x < image.width; x++) {
      double a = scene.left + (scene.right - scene.left) * x / (image.width - 1);
      double b = scene.top + (scene.bottom - scene.top) * y / (image.height - 1);
      Vec p = scene.eye + scene.d * w + a * u + b * v;
      image.at(x, y) = shade(scene, p, unit(p - scene.eye));
    }
  }
}

int main(int argc, char** argv) {
  if (argc != 3) {
    cout << "usage: pa3 scene image" << endl;
    return 0;
  }
  Scene scene = parse(ifstream(argv[1]));
  Image image(scene.width, scene.height);
  render(scene, image);
  image.save(argv[2]);
  cout << "done" << endl;
  return 0;
}
