// g++ -O2 tracer.cpp -o tracer ; ./tracer driver.txt image.ppm
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <valarray>
#include <vector>
using namespace std;

typedef valarray<double> vec;

double dot(const vec& a, const vec& b) { return (a * b).sum(); }
double len(const vec& a) { return sqrt(dot(a, a)); }
vec norm(const vec& a) { return a / len(a); }
vec cross(const vec& a, const vec& b) {
  return vec{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Sphere { vec C, ka, kd, ks, kr, ko; double r, eta, phong; };
struct Light { vec P, B; };
vector<Sphere> S;
vector<Light> Ls;
vec eye(3), look(3), up(3), amb(3);
double d, left_, bottom_, right_, top_;
int width, height, maxDepth;

vec three(istream& in) {
  vec v(3);
  in >> v[0] >> v[1] >> v[2];
  return v;
}

void readFile(const char* name) {
  ifstream in(name);
  if (!in) { cerr << "no file " << name << endl; exit(1); }
  string w;
  while (in >> w) {
    if (w == "eye") eye = three(in);
    else if (w == "look") look = three(in);
    else if (w == "up") up = three(in);
    else if (w == "d") in >> d;
    else if (w == "bounds") in >> left_ >> bottom_ >> right_ >> top_;
    else if (w == "res") in >> height >> width;
    else if (w == "recursionLevel") in >> maxDepth;
    else if (w == "ambient") amb = three(in);
    else if (w == "light") {
      Light l;
      double dummy;
      l.P = three(in);
      in >> dummy;
      l.B = three(in);
      Ls.push_back(l);
    } else if (w == "sphere") {
      Sphere s;
      s.C = three(in);
      in >> s.r;
      s.ka = three(in);
      s.kd = three(in);
      s.ks = three(in);
      s.kr = three(in);
      s.ko = three(in);
      in >> s.eta >> s.phong;
      S.push_back(s);
    } else { cerr << "I don't know " << w << endl; exit(1); }
  }
}

// first root that is in front, or -1
double intersect(const Sphere& s, const vec& L, const vec& U) {
  vec T = s.C - L;
  double v = dot(T, U), csq = dot(T, T), disc = s.r * s.r - (csq - v * v);
  if (disc < 0) return -1;
  double r1 = v - sqrt(disc), r2 = v + sqrt(disc);
  return r1 >= 0 ? r1 : r2 >= 0 ? r2 : -1;
}

int closest(const vec& L, const vec& U, double& t) {
  int which = -1;
  for (unsigned k = 0; k < S.size(); k++) {
    double s = intersect(S[k], L, U);
    if (s >= 0 && (which < 0 || s < t)) { t = s; which = k; }
  }
  return which;
}

vec rayTrace(const vec& L, const vec& U, int depth) {
  double t, st;
  int k = closest(L, U, t);
  if (k < 0) return vec(0.0, 3);
  const Sphere& s = S[k];
  vec Q = L + t * U, N = norm(Q - s.C), c = amb * s.ka;
  for (const Light& l : Ls) {
    vec D = norm(l.P - Q);
    double nd = dot(N, D);
    if (nd <= 0) continue;
    if (closest(Q + 1e-6 * N, D, st) >= 0 && st < len(l.P - Q)) continue;
    c += s.kd * l.B * nd;
    double vr = dot(-U, 2 * nd * N - D);
    if (vr > 0) c += s.ks * l.B * pow(vr, s.phong);
  }
  if (depth > 0) c += s.kr * rayTrace(Q + 1e-6 * N, norm(U - 2 * dot(N, U) * N), depth - 1);
  return c;
}

int main(int argc, char** argv) {
  if (argc != 3) { cerr << "tracer driver image" << endl; return 1; }
  readFile(argv[1]);
  vec W = norm(eye - look), U = norm(cross(up, W)), V = cross(W, U);
  FILE* f = fopen(argv[2], "wb");
  fprintf(f, "P6\n# cs410\n%d %d\n255\n", width, height);
  for (int j = height - 1; j >= 0; j--)
    for (int i = 0; i < width; i++) {
      double px = (double)i / (width - 1) * (right_ - left_) + left_;
      double py = (double)j / (height - 1) * (top_ - bottom_) + bottom_;
      vec P = eye - d * W + px * U + py * V;
      vec c = rayTrace(P, norm(P - eye), maxDepth);
      for (int k = 0; k < 3; k++) fputc(c[k] > 1 ? 255 : (int)(c[k] * 255), f);
    }
  fclose(f);
  return 0;
}
