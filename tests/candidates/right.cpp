// A right candidate, as a careful student writes it, with Eigen.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <raycheck/candidate.hpp>

using namespace raycheck;

namespace {

using Vector3 = Eigen::Vector3d;

Vector3 in(const Vector& v) { return {v.x, v.y, v.z}; }
Vector out(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Frame frame(const Camera& camera) {
  const Vector3 w = (in(camera.eye) - in(camera.look_at)).normalized();
  const Vector3 u = in(camera.up).cross(w).normalized();
  return {out(u), out(w.cross(u)), out(w)};
}

double position(double first, double last, double index, double count, Samples samples) {
  const double share = samples == Samples::centres   ? (index + 0.5) / count
                       : samples == Samples::corners ? index / count
                                                     : index / (count - 1);
  return first + (last - first) * share;
}

/// P - E
Vector3 sight(const Camera& camera, const Conventions& asked, Pixel pixel) {
  const auto [u, v, w] = frame(camera);
  const double column = static_cast<double>(pixel.i);
  const double row = static_cast<double>(pixel.j);
  const double width = static_cast<double>(camera.width);
  const double height = static_cast<double>(camera.height);
  const bool top_first = asked.rows == Rows::top_first;
  const double alpha = position(camera.left, camera.right, column, width, asked.samples);
  const double beta = position(top_first ? camera.top : camera.bottom,
                               top_first ? camera.bottom : camera.top, row, height, asked.samples);
  return camera.near_plane * in(w) + alpha * in(u) + beta * in(v);
}

Vector pixel_point(const Camera& camera, const Conventions& asked, Pixel pixel) {
  return out(in(camera.eye) + sight(camera, asked, pixel));
}

Ray pixel_ray(const Camera& camera, const Conventions& asked, Pixel pixel) {
  const Vector3 g = sight(camera, asked, pixel);
  return {out(in(camera.eye) + g), out(g.normalized())};
}

Ray focal_ray(const Camera& camera, const Conventions& asked, Pixel pixel) {
  return {camera.eye, out(sight(camera, asked, pixel).normalized())};
}

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions& asked) {
  const Vector3 origin = in(ray.origin), d = in(ray.direction), to = in(sphere.centre) - origin;
  const double a = d.squaredNorm(), b = to.dot(d), r = sphere.radius;
  // r^2 a - |to x d|^2 does not cancel on far spheres.
  const double discriminant = a * r * r - to.cross(d).squaredNorm();
  if (discriminant < 0 || (discriminant == 0 && asked.tangent == Tangent::miss)) return {};
  const double q = b >= 0 ? b + std::sqrt(discriminant) : b - std::sqrt(discriminant);
  const double distance = to.norm();
  const double c = (distance - r) * (distance + r);
  const double one = q / a, other = q == 0 ? 0 : c / q;
  double s = std::min(one, other);
  if (s < 0 && asked.root == Root::nearest) s = std::max(one, other);
  if (s < 0) return {};
  return Hit{s, out(origin + s * d)};
}

std::optional<std::size_t> nearest(const Ray& ray, const std::vector<Sphere>& spheres,
                                   const Conventions& asked) {
  std::optional<std::size_t> found;
  double least = 0;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const auto hit = intersect(ray, spheres[k], asked);
    if (!hit || (found && hit->parameter >= least)) continue;
    found = k;
    least = hit->parameter;
  }
  return found;
}

}  // namespace

RAYCHECK_CANDIDATE(.frame = frame, .pixel_point = pixel_point, .pixel_ray = pixel_ray,
                   .focal_ray = focal_ray, .intersect = intersect, .nearest = nearest,
                   .contract = "corners as-asked")
