#include "tests/mutants/careful.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "properties/mistakes/altered_hits.h"
#include "tests/mutants/mutants.h"

namespace raycheck::mutants {
namespace {

using properties::Candidate;
using properties::FrameAnswer;
using properties::Hit;
using properties::HitAnswer;
using scene::Camera;
using scene::Conventions;
using scene::Pixel;
using scene::Point3;
using scene::Ray;
using scene::Sphere;
using Vector = Eigen::Vector3d;

template <class Triple>
Vector in(const Triple& v) {
  return {v.x, v.y, v.z};
}
template <class Triple>
Triple out(const Vector& v) {
  return {v.x(), v.y(), v.z()};
}

FrameAnswer frame(const Camera& camera) {
  const Vector w = (in(camera.eye) - in(camera.look_at)).normalized();
  const Vector u = in(camera.up).cross(w).normalized();
  return {out<scene::UnitVector3>(u), out<scene::UnitVector3>(w.cross(u)),
          out<scene::UnitVector3>(w)};
}

double position(double low, double high, double index, double count, scene::Samples samples) {
  return samples == scene::Samples::kCentres ? low + (high - low) * ((index + 0.5) / count)
                                             : low + (high - low) * (index / (count - 1));
}

/// P - E
Vector sight(const Camera& camera, const Conventions& asked, const Pixel& pixel) {
  const auto [u, v, w] = frame(camera);
  const auto width = static_cast<double>(camera.width);
  const auto height = static_cast<double>(camera.height);
  auto row = static_cast<double>(pixel.j);
  if (asked.rows == scene::Rows::kTopFirst) row = height - 1 - row;
  const double alpha =
      position(camera.left, camera.right, static_cast<double>(pixel.i), width, asked.samples);
  const double beta = position(camera.bottom, camera.top, row, height, asked.samples);
  return camera.near * in(w) + alpha * in(u) + beta * in(v);
}

scene::Vector3 turned(const Vector& direction, double angle) {
  return out<scene::Vector3>((direction + angle * direction.unitOrthogonal()).normalized());
}

Hit intersect(const Ray& ray, const Sphere& sphere, const Conventions& asked, const Fault& fault) {
  const Vector origin = in(ray.origin), d = in(ray.direction), to = in(sphere.centre) - origin;
  const double a = d.squaredNorm(), b = to.dot(d), r = sphere.radius;
  const double impact = to.cross(d).norm() / std::sqrt(a);
  // r^2 a - |to x d|^2 does not cancel on far spheres.
  double discriminant = a * r * r - to.cross(d).squaredNorm();
  if (std::abs(impact - r) < fault.band * r) discriminant = discriminant < 0 ? 0 : -1;
  if (discriminant < 0 || (discriminant == 0 && asked.tangent == scene::Tangent::kMiss)) return {};
  const double q = b >= 0 ? b + std::sqrt(discriminant) : b - std::sqrt(discriminant);
  const double distance = to.norm();
  const double c = (distance - r) * (distance + r);
  const double one = q / a, other = q == 0 ? 0 : c / q;
  double s = std::min(one, other);
  if (s < 0 && asked.root == scene::Root::kNearest) s = std::max(one, other);
  if (s < 0 || s < fault.epsilon) return {};
  return HitAnswer{s * (1 + fault.s), out<Point3>((1 + fault.Q) * (origin + s * d))};
}

}  // namespace

Candidate careful_candidate(std::string name, const Fault& fault) {
  const Candidate plain = unmutated();
  Candidate candidate;
  candidate.name = std::move(name);
  candidate.refuses = false;
  candidate.max_error = plain.max_error;
  candidate.max_error_end_to_end = plain.max_error_end_to_end;
  candidate.frame = frame;
  candidate.pixel_points = [](const Camera& camera, const Conventions& asked,
                              Candidate::Pixels pixels) {
    std::vector<Point3> points;
    for (const Pixel& pixel : pixels) {
      points.push_back(out<Point3>(in(camera.eye) + sight(camera, asked, pixel)));
    }
    return points;
  };
  const auto rays_from = [fault](bool eye) {
    return [fault, eye](const Camera& camera, const Conventions& asked, Candidate::Pixels pixels) {
      std::vector<Ray> rays;
      for (const Pixel& pixel : pixels) {
        const Vector g = sight(camera, asked, pixel);
        rays.push_back(
            {eye ? camera.eye : out<Point3>(in(camera.eye) + g),
             fault.D == 0 ? out<scene::Vector3>(g.normalized()) : turned(g.normalized(), fault.D)});
      }
      return rays;
    };
  };
  candidate.pixel_rays = rays_from(false);
  candidate.focal_rays = rays_from(true);
  properties::answer_by(
      candidate, [fault](Candidate::Rays rays, const Sphere& sphere, const Conventions& asked) {
        std::vector<Hit> hits;
        for (const Ray& ray : rays) hits.push_back(intersect(ray, sphere, asked, fault));
        return hits;
      });
  return candidate;
}

}  // namespace raycheck::mutants
