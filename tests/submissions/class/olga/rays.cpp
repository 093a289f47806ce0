#include <Eigen/Dense>
#include <raycheck/candidate.hpp>

using Eigen::Vector3d;
namespace rc = raycheck;

static Vector3d eigen(const rc::Vector& v) { return {v.x, v.y, v.z}; }
static rc::Vector back(const Vector3d& v) { return {v[0], v[1], v[2]}; }

struct Axes {
  Vector3d u, v, w;
  explicit Axes(const rc::Camera& c) {
    w = (eigen(c.eye) - eigen(c.look_at)).normalized();
    u = eigen(c.up).cross(w).normalized();
    v = w.cross(u);
  }
};

rc::Frame frame(const rc::Camera& camera) {
  Axes axes(camera);
  return {back(axes.u), back(axes.v), back(axes.w)};
}

// the image plane is a distance of near in front of the eye, and W points backwards
static Vector3d offset(const rc::Camera& c, rc::Pixel p) {
  Axes axes(c);
  double a = c.left + double(p.i) / double(c.width - 1) * (c.right - c.left);
  double b = c.bottom + double(p.j) / double(c.height - 1) * (c.top - c.bottom);
  return -c.near_plane * axes.w + a * axes.u + b * axes.v;
}

rc::Vector pixel_point(const rc::Camera& camera, const rc::Conventions&, rc::Pixel pixel) {
  return back(eigen(camera.eye) + offset(camera, pixel));
}

rc::Ray pixel_ray(const rc::Camera& camera, const rc::Conventions& conventions, rc::Pixel pixel) {
  return {pixel_point(camera, conventions, pixel), back(offset(camera, pixel).normalized())};
}

std::optional<rc::Hit> intersect(const rc::Ray& ray, const rc::Sphere& sphere, const rc::Conventions&) {
  Vector3d o = eigen(ray.origin), d = eigen(ray.direction), t = eigen(sphere.centre) - o;
  double n = d.norm();
  d /= n;
  double v = t.dot(d), sq = sphere.radius * sphere.radius - (t - v * d).squaredNorm();
  if (sq < 0) return {};
  double s = v - std::sqrt(sq);
  if (s < 0) s = v + std::sqrt(sq);
  if (s < 0) return {};
  return rc::Hit{s / n, back(o + s * d)};
}

std::optional<std::size_t> nearest(const rc::Ray& ray, const std::vector<rc::Sphere>& spheres,
                                   const rc::Conventions& conventions) {
  std::optional<std::size_t> which;
  double where = 0;
  for (std::size_t k = 0; k < spheres.size(); k++) {
    std::optional<rc::Hit> hit = intersect(ray, spheres[k], conventions);
    if (hit && (!which || hit->parameter < where)) {
      which = k;
      where = hit->parameter;
    }
  }
  return which;
}

RAYCHECK_CANDIDATE(.frame = frame, .pixel_point = pixel_point, .pixel_ray = pixel_ray, .intersect = intersect,
                   .nearest = nearest)
