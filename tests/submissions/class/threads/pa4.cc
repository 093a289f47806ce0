// PA4, multithreaded. Build with "make all". ./PA4 driver out.ppm [threads]
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>
using namespace std;

struct Vec {
  double v[3] = {0, 0, 0};
  double operator[](int k) const { return v[k]; }
  double& operator[](int k) { return v[k]; }
};
Vec operator+(const Vec& a, const Vec& b) { return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}}; }
Vec operator-(const Vec& a, const Vec& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }
Vec operator*(double k, const Vec& a) { return {{k * a[0], k * a[1], k * a[2]}}; }
double operator*(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec cross(const Vec& a, const Vec& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
Vec norm(const Vec& a) { return (1 / sqrt(a * a)) * a; }
istream& operator>>(istream& in, Vec& a) { return in >> a[0] >> a[1] >> a[2]; }

struct Ball { Vec c; double r; Vec ka, kd, ks; };
struct Lamp { Vec p; double w; Vec e; };

Vec eye, look, up, ambient;
double d, l, r, b, t;
int width, height, depth = 0;
vector<Ball> balls;
vector<Lamp> lamps;
vector<unsigned char> image;

void load(const char* file) {
  map<string, function<void(istream&)>> read;
  read["camera"] = [](istream& in) { in >> eye >> look >> up >> d; };
  read["bounds"] = [](istream& in) { in >> l >> r >> b >> t; };
  read["res"] = [](istream& in) { in >> width >> height; };
  read["recursionlevel"] = [](istream& in) { in >> depth; };
  read["ambient"] = [](istream& in) { in >> ambient; };
  read["light"] = [](istream& in) {
    Lamp x;
    in >> x.p >> x.w >> x.e;
    lamps.push_back(x);
  };
  read["sphere"] = [](istream& in) {
    Ball x;
    Vec kr;
    double more, ko;
    in >> x.c >> x.r >> x.ka >> x.kd >> x.ks >> kr >> ko >> more;
    if (!in || in >> more) exit(2);
    balls.push_back(x);
  };
  ifstream in(file);
  if (!in) {
    cerr << "no such file: " << file << endl;
    exit(1);
  }
  string text, word;
  while (getline(in, text)) {
    istringstream words(text);
    if (words >> word && read.count(word)) read[word](words);
  }
}

Vec colour(const Vec& L, const Vec& D) {
  const Ball* front = nullptr;
  double best = 0;
  for (const Ball& ball : balls) {
    Vec T = ball.c - L;
    double v = T * D;
    double dd = ball.r * ball.r - (T * T - v * v);
    if (dd < 0) continue;
    double s = v - sqrt(dd);
    if (s < 0) s = v + sqrt(dd);
    if (s < 0) continue;
    if (!front || s < best) {
      front = &ball;
      best = s;
    }
  }
  Vec c;
  if (!front) return c;
  Vec Q = L + best * D;
  Vec N = norm(Q - front->c);
  if (N * D > 0) N = -1 * N;
  for (int k = 0; k < 3; k++) c[k] = ambient[k] * front->ka[k];
  for (const Lamp& lamp : lamps) {
    Vec toLamp = norm(lamp.p - lamp.w * Q);
    double cosine = N * toLamp;
    if (cosine <= 0) continue;
    double shine = pow(max(0.0, -1 * ((2 * cosine * N - toLamp) * D)), 16);
    for (int k = 0; k < 3; k++) c[k] += lamp.e[k] * (front->kd[k] * cosine + front->ks[k] * shine);
  }
  return c;
}

void rows(int from, int to) {
  Vec w = norm(eye - look);
  Vec u = norm(cross(up, w));
  Vec v = norm(up);
  unsigned char* p = &image[3 * width * from];
  for (int j = from; j < to; j++)
    for (int i = 0; i < width; i++) {
      double x = l + i * (r - l) / (width - 1);
      double y = t - j * (t - b) / (height - 1);
      Vec P = eye + d * w + x * u + y * v;
      Vec c = colour(P, norm(P - eye));
      for (int k = 0; k < 3; k++) *p++ = (unsigned char)min(255.0, 255 * c[k] + 0.5);
    }
}

int main(int argc, char** argv) {
  if (argc < 3) {
    cerr << "PA4 driver out.ppm [threads]" << endl;
    return 1;
  }
  load(argv[1]);
  int n = argc > 3 ? atoi(argv[3]) : 4;
  image.resize(3 * width * height);

  int band = height / n;
  vector<thread> crew;
  for (int k = 0; k < n; k++) crew.emplace_back(rows, k * band, (k + 1) * band);
  for (thread& x : crew) x.join();

  ofstream out(argv[2], ios::binary);
  out << "P6 " << width << " " << height << " 255\n";
  out.write((const char*)image.data(), image.size());
}
