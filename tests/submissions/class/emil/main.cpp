#include <Eigen/Dense>
#include <fstream>
#include <future>
#include <iostream>
#include <sstream>
#include <vector>

using Eigen::Vector3d;

struct Material {
  Vector3d ambient, diffuse, specular, mirror;
};

struct Sphere {
  Vector3d center;
  double radius;
  Material material;
};

struct PointLight {
  Vector3d position, color;
};

struct Ray {
  Vector3d origin, direction;
};

class Tracer {
 public:
  void load(const char* path);
  Vector3d pixel(int i, int j) const;
  int width = 0, height = 0;

 private:
  const Sphere* nearest(const Ray& ray, double& t) const;
  Vector3d trace(const Ray& ray, int depth) const;

  Vector3d eye_, look_, up_, ambient_ = Vector3d::Zero();
  double d_, left_, right_, bottom_, top_;
  int depth_ = 0;
  std::vector<Sphere> spheres_;
  std::vector<PointLight> lights_;
};

static Vector3d get(std::istringstream& in) {
  double x, y, z;
  if (!(in >> x >> y >> z)) throw std::runtime_error("three numbers expected");
  return {x, y, z};
}

void Tracer::load(const char* path) {
  std::ifstream file(path);
  std::string line, key;
  while (std::getline(file, line)) {
    std::istringstream in(line);
    if (!(in >> key)) continue;
    if (key == "camera") eye_ = get(in), look_ = get(in), up_ = get(in), in >> d_;
    else if (key == "bounds") in >> left_ >> right_ >> bottom_ >> top_;
    else if (key == "res") in >> width >> height;
    else if (key == "recursionlevel") in >> depth_;
    else if (key == "ambient") ambient_ = get(in);
    else if (key == "light") {
      PointLight light;
      light.position = get(in);
      double w;
      in >> w;
      light.color = get(in);
      lights_.push_back(light);
    } else if (key == "sphere") {
      Sphere s;
      s.center = get(in);
      in >> s.radius;
      s.material = Material{get(in), get(in), get(in), get(in)};
      double eta;
      if (get(in), !(in >> eta) || in >> eta) throw std::runtime_error("20 numbers expected");
      spheres_.push_back(s);
    }
  }
}

const Sphere* Tracer::nearest(const Ray& ray, double& t) const {
  const Sphere* result = nullptr;
  for (const Sphere& s : spheres_) {
    const Vector3d T = s.center - ray.origin;
    const double v = T.dot(ray.direction), d2 = s.radius * s.radius - (T.dot(T) - v * v);
    if (d2 < 0) continue;
    const double d = std::sqrt(d2), candidate = v - d >= 0 ? v - d : v + d;
    if (candidate >= 0 && (!result || candidate < t)) {
      t = candidate;
      result = &s;
    }
  }
  return result;
}

Vector3d Tracer::trace(const Ray& ray, int depth) const {
  double t, shadow;
  const Sphere* s = nearest(ray, t);
  if (!s) return Vector3d::Zero();
  const Vector3d q = ray.origin + t * ray.direction, n = (q - s->center).normalized();
  const Vector3d start = q + 1e-6 * n;
  Vector3d color = ambient_.cwiseProduct(s->material.ambient);
  for (const PointLight& light : lights_) {
    const Vector3d way = light.position - q, l = way.normalized();
    const double cosine = n.dot(l);
    if (cosine <= 0 || (nearest({start, l}, shadow) && shadow < way.norm())) continue;
    const double shine = std::max(0.0, -(2 * cosine * n - l).dot(ray.direction));
    color += light.color.cwiseProduct(cosine * s->material.diffuse + std::pow(shine, 16) * s->material.specular);
  }
  if (depth == 0) return color;
  const Vector3d r = ray.direction - 2 * ray.direction.dot(n) * n;
  return color + s->material.mirror.cwiseProduct(trace({start, r.normalized()}, depth - 1));
}

Vector3d Tracer::pixel(int i, int j) const {
  const Vector3d w = (eye_ - look_).normalized(), u = up_.cross(w).normalized(), v = w.cross(u);
  const double aspect = double(width) / height;
  const double x = (left_ + (right_ - left_) * i / (width - 1)) * aspect;
  const double y = top_ + (bottom_ - top_) * j / (height - 1);
  const Vector3d p = eye_ + d_ * w + x * u + y * v;
  return trace({p, (p - eye_).normalized()}, depth_);
}

int main(int argc, char** argv) {
  if (argc != 3) return std::cerr << "usage: rt driver image\n", 1;
  Tracer tracer;
  tracer.load(argv[1]);
  std::vector<std::future<std::string>> rows;
  for (int j = 0; j < tracer.height; ++j)
    rows.push_back(std::async([&tracer, j] {
      std::ostringstream row;
      for (int i = 0; i < tracer.width; ++i) {
        const Vector3d c = tracer.pixel(i, j);
        for (int k = 0; k < 3; ++k) row << std::min(255L, std::lround(c[k] * 255)) << ' ';
      }
      return row.str();
    }));
  std::ofstream out(argv[2]);
  out << "P3\n" << tracer.width << ' ' << tracer.height << "\n255\n";
  for (auto& row : rows) out << row.get() << '\n';
}
