// Programming assignment 3 - recursive ray tracer
#include <Eigen/Dense>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using Eigen::Array3d;
using Eigen::Vector3d;
using namespace std;

struct Material {
  Array3d ka, kd, ks, kr;
};

struct Sphere {
  Vector3d center;
  double radius;
  Material mat;
};

struct Light {
  Vector3d pos;
  Array3d color;
};

struct Ray {
  Vector3d L, D;
};

Vector3d eye, look, up;
double d, lft, rgt, bot, top;
int width, height, recursion = 0;
Array3d ambient(0, 0, 0);
vector<Light> lights;
vector<Sphere> spheres;

istream& operator>>(istream& in, Vector3d& v) { return in >> v[0] >> v[1] >> v[2]; }
istream& operator>>(istream& in, Array3d& v) { return in >> v[0] >> v[1] >> v[2]; }

void readDriver(const string& name) {
  ifstream file(name);
  if (!file) {
    cerr << "cannot open " << name << endl;
    exit(1);
  }
  string line;
  while (getline(file, line)) {
    stringstream ss(line);
    string word;
    if (!(ss >> word) || word[0] == '#') continue;
    if (word == "eye") ss >> eye;
    else if (word == "look") ss >> look;
    else if (word == "up") ss >> up;
    else if (word == "d") ss >> d;
    else if (word == "bounds") ss >> lft >> rgt >> bot >> top;
    else if (word == "res") ss >> width >> height;
    else if (word == "recursionlevel") ss >> recursion;
    else if (word == "ambient") ss >> ambient;
    else if (word == "light") {
      Light l;
      double w;
      ss >> l.pos >> w >> l.color;
      lights.push_back(l);
    } else if (word == "sphere") {
      Sphere s;
      ss >> s.center >> s.radius >> s.mat.ka >> s.mat.kd >> s.mat.ks >> s.mat.kr;
      if (ss.fail()) s.mat.kr = Array3d(0, 0, 0);
      spheres.push_back(s);
    }
  }
}

// returns the parameter along the ray or -1
double hitSphere(const Ray& ray, const Sphere& s) {
  Vector3d T = s.center - ray.L;
  double v = T.dot(ray.D);
  double dsq = s.radius * s.radius - (T.dot(T) - v * v);
  if (dsq < 0) return -1;
  double dd = sqrt(dsq);
  if (v - dd >= 0) return v - dd;
  if (v + dd >= 0) return v + dd;
  return -1;
}

bool nearest(const Ray& ray, double& best, const Sphere*& which) {
  best = numeric_limits<double>::infinity();
  which = nullptr;
  for (const Sphere& s : spheres) {
    double t = hitSphere(ray, s);
    if (t >= 0 && t < best) {
      best = t;
      which = &s;
    }
  }
  return which != nullptr;
}

Array3d trace(const Ray& ray, int level) {
  double t;
  const Sphere* s;
  if (!nearest(ray, t, s)) return Array3d(0, 0, 0);
  Vector3d Q = ray.L + t * ray.D;
  Vector3d N = (Q - s->center).normalized();
  Vector3d toEye = -ray.D;
  if (N.dot(toEye) < 0) N = -N;
  Array3d color = ambient * s->mat.ka;
  for (const Light& light : lights) {
    Vector3d toL = light.pos - Q;
    double dist = toL.norm();
    if (dist == 0) continue;
    toL /= dist;
    double ndotl = N.dot(toL);
    if (ndotl <= 0) continue;
    Ray shadow{Q + 1e-6 * N, toL};
    double st;
    const Sphere* blocker;
    if (nearest(shadow, st, blocker) && st < dist) continue;
    color += s->mat.kd * light.color * ndotl;
    Vector3d R = 2 * ndotl * N - toL;
    double spec = max(0.0, R.dot(toEye));
    color += s->mat.ks * light.color * pow(spec, 16);
  }
  if (level > 0 && s->mat.kr.maxCoeff() > 0) {
    Vector3d R = 2 * N.dot(toEye) * N - toEye;
    color += s->mat.kr * trace(Ray{Q + 1e-6 * N, R.normalized()}, level - 1);
  }
  return color;
}

int main(int argc, char* argv[]) {
  if (argc != 3) {
    cerr << "usage: pa3 driver.txt image.ppm" << endl;
    return 1;
  }
  readDriver(argv[1]);
  Vector3d W = (eye - look).normalized();
  Vector3d U = up.cross(W).normalized();
  Vector3d V = W.cross(U);

  vector<vector<Array3d>> image(height, vector<Array3d>(width));
  for (int i = 0; i < width; i++) {
    for (int j = 0; j < height; j++) {
      double px = i / (width - 1.0) * (rgt - lft) + lft;
      double py = j / (height - 1.0) * (bot - top) + top;
      Vector3d pixpt = eye + d * W + px * U + py * V;
      image[j][i] = trace(Ray{pixpt, (pixpt - eye).normalized()}, recursion);
    }
  }

  ofstream out(argv[2]);
  out << "P3\n" << width << " " << height << " 255\n";
  for (const auto& row : image) {
    for (const Array3d& c : row)
      for (int k = 0; k < 3; k++) out << int(round(255 * min(1.0, max(0.0, c[k])))) << " ";
    out << "\n";
  }
  return 0;
}
