#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>
#include "vmath.h"
using namespace std;

struct sphere_t { float3 c; float r; float3 ka, kd, ks, kr; };
struct light_t { float3 p, rgb; };

float3 eye, look, up, ambient;
float near_, l, r, b, t;
int w, h, depth;
vector<sphere_t> spheres;
vector<light_t> lights;

istream& operator>>(istream& in, float3& f) { return in >> f.x >> f.y >> f.z; }

bool read(const char* name) {
  ifstream file(name);
  string line, key;
  bool seen = false;
  while (getline(file, line)) {
    istringstream in(line);
    if (!(in >> key) || key[0] == '#') continue;
    if (key == "camera") in >> eye >> look >> up >> near_;
    else if (key == "bounds") in >> l >> r >> b >> t;
    else if (key == "res") in >> w >> h;
    else if (key == "recursionlevel") seen = bool(in >> depth);
    else if (key == "ambient") in >> ambient;
    else if (key == "light") {
      light_t light;
      float unused;
      in >> light.p >> unused >> light.rgb;
      lights.push_back(light);
    } else if (key == "sphere") {
      sphere_t s;
      in >> s.c >> s.r >> s.ka >> s.kd >> s.ks >> s.kr;
      spheres.push_back(s);
    }
    if (!in) {
      cout << "bad line: " << line << endl;
      return false;
    }
  }
  return seen;
}

int nearest(float3 o, float3 d, float& best) {
  int k = -1;
  best = 1e30f;
  for (size_t i = 0; i < spheres.size(); i++) {
    float3 oc = spheres[i].c - o;
    float v = dot(oc, d);
    float csq = dot(oc, oc);
    float disc = spheres[i].r * spheres[i].r - (csq - v * v);
    if (disc < 0.0f) continue;
    float root = sqrtf(disc);
    float s = v - root;
    if (s < 0.0f) s = v + root;
    if (s >= 0.0f && s < best) {
      best = s;
      k = (int)i;
    }
  }
  return k;
}

float3 trace(float3 o, float3 d, int level) {
  float s, s2;
  int k = nearest(o, d, s);
  if (k < 0) return make_float3(0, 0, 0);
  const sphere_t& ball = spheres[k];
  float3 q = o + s * d, n = normalize(q - ball.c);
  float3 c = ambient * ball.ka, start = q + 0.001f * n;
  for (size_t i = 0; i < lights.size(); i++) {
    float3 to = normalize(lights[i].p - q);
    float nl = dot(n, to);
    if (nl <= 0.0f || nearest(start, to, s2) >= 0) continue;
    float rv = -dot(2 * nl * n - to, d);
    c = c + nl * (ball.kd * lights[i].rgb);
    if (rv > 0) c = c + powf(rv, 16) * (ball.ks * lights[i].rgb);
  }
  if (level > 0) c = c + ball.kr * trace(start, normalize(d - 2 * dot(d, n) * n), level - 1);
  return c;
}

int main(int argc, char** argv) {
  if (argc < 3 || !read(argv[1])) return 1;
  float3 W = normalize(eye - look), U = normalize(cross(up, W)), V = cross(W, U);
  ofstream out(argv[2], ios::binary);
  out << "P6\n" << w << " " << h << "\n255\n";
  for (int j = 0; j < h; j++)
    for (int i = 0; i < w; i++) {
      float a = l + (r - l) * i / (w - 1), be = t + (b - t) * j / (h - 1);
      float3 p = eye + near_ * W + a * U + be * V;
      float3 c = trace(p, normalize(p - eye), depth);
      float f[3] = {c.x, c.y, c.z};
      for (int k = 0; k < 3; k++) out.put((char)(unsigned char)(fminf(f[k], 1.0f) * 255.0f + 0.5f));
    }
  return 0;
}
