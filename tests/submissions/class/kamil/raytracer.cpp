// g++ -O2 raytracer.cpp -o raytracer
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <list>
#include <sstream>
#include <vector>
using namespace std;

struct Vector {
  double x, y, z;
  Vector(double x = 0, double y = 0, double z = 0) : x(x), y(y), z(z) {}
};
Vector operator+(const Vector& a, const Vector& b) { return Vector(a.x + b.x, a.y + b.y, a.z + b.z); }
Vector operator-(const Vector& a, const Vector& b) { return Vector(a.x - b.x, a.y - b.y, a.z - b.z); }
Vector operator*(double k, const Vector& a) { return Vector(k * a.x, k * a.y, k * a.z); }
Vector operator*(const Vector& a, const Vector& b) { return Vector(a.x * b.x, a.y * b.y, a.z * b.z); }
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(const Vector& a, const Vector& b) {
  return Vector(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
Vector norm(const Vector& a) { return 1 / sqrt(dot(a, a)) * a; }

struct Sphere {
  Vector c;
  double r;
  Vector ka, kd, ks, kr;
};

struct Crossing {
  double s;
  const Sphere* sphere;
  bool operator<(const Crossing& o) const { return s < o.s; }
};

list<Sphere> spheres;
list<pair<Vector, Vector> > lights;
Vector ambient;

// all points where the ray's line goes through a sphere, sorted
vector<Crossing> crossings(const Vector& start, const Vector& dir) {
  vector<Crossing> all;
  for (const Sphere& sphere : spheres) {
    Vector t = sphere.c - start;
    double v = dot(t, dir);
    double dsq = sphere.r * sphere.r - (dot(t, t) - v * v);
    if (dsq < 0) continue;
    all.push_back({v - sqrt(dsq), &sphere});
    all.push_back({v + sqrt(dsq), &sphere});
  }
  sort(all.begin(), all.end());
  return all;
}

bool firstCrossing(const Vector& start, const Vector& dir, Crossing& found) {
  vector<Crossing> all = crossings(start, dir);
  if (all.empty()) return false;
  size_t k = 0;
  while (all[k].s < 0) k = (k + 1) % all.size();
  found = all[k];
  return true;
}

Vector color(const Vector& start, const Vector& dir, int level) {
  Crossing hit;
  if (!firstCrossing(start, dir, hit)) return Vector();
  Vector q = start + hit.s * dir, n = norm(q - hit.sphere->c);
  Vector sum = ambient * hit.sphere->ka;
  for (auto& light : lights) {
    Vector l = norm(light.first - q);
    double cosine = dot(n, l);
    if (cosine <= 0) continue;
    Vector r = 2 * cosine * n - l;
    sum = sum + cosine * (hit.sphere->kd * light.second);
    sum = sum + pow(max(0.0, -dot(r, dir)), 16) * (hit.sphere->ks * light.second);
  }
  return sum;
}

istream& operator>>(istream& in, Vector& v) { return in >> v.x >> v.y >> v.z; }

int main(int argc, char** argv) {
  Vector eye, look, up;
  double d, left, right, bottom, top, one;
  int width, height, level = 0;
  if (argc < 3) return 1;
  ifstream in(argv[1]);
  string line, key;
  while (getline(in, line)) {
    istringstream s(line);
    key = "";
    s >> key;
    if (key == "eye") s >> eye;
    else if (key == "look") s >> look;
    else if (key == "up") s >> up;
    else if (key == "d") s >> d;
    else if (key == "bounds") s >> left >> right >> bottom >> top;
    else if (key == "res") s >> width >> height;
    else if (key == "recursionlevel") s >> level;
    else if (key == "ambient") s >> ambient;
    else if (key == "light") {
      pair<Vector, Vector> light;
      s >> light.first >> one >> light.second;
      lights.push_back(light);
    } else if (key == "sphere") {
      Sphere b;
      s >> b.c >> b.r >> b.ka >> b.kd >> b.ks >> b.kr;
      spheres.push_back(b);
    }
  }
  Vector w = norm(eye - look), u = norm(cross(up, w)), v = cross(w, u);
  ofstream out(argv[2]);
  out << "P3 " << width << " " << height << " 255" << endl;
  for (int j = height - 1; j >= 0; j--)
    for (int i = 0; i < width; i++) {
      Vector p = eye + d * w + (left + (right - left) * i / (width - 1)) * u + (bottom + (top - bottom) * j / (height - 1)) * v;
      Vector c = color(p, norm(p - eye), level);
      out << min(255, int(c.x * 255)) << " " << min(255, int(c.y * 255)) << " " << min(255, int(c.z * 255)) << endl;
    }
}
