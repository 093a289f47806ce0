#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "tests/mutants/mutants.h"

namespace raycheck::mutants {
namespace {

using properties::Candidate;
using properties::FrameAnswer;
using scene::Camera;
using scene::Conventions;
using scene::Point3;
using scene::Ray;
using scene::UnitVector3;
using scene::Vector3;

Vector3 scaled(double factor, const Vector3& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

double length(const Vector3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

Vector3 normalised(const Vector3& v) { return scaled(1 / length(v), v); }

UnitVector3 unit(const Vector3& v) { return {v.x, v.y, v.z}; }

Candidate named(std::string name) {
  Candidate candidate = unmutated();
  candidate.name = std::move(name);
  return candidate;
}

/// Axes changed after the fact.
Candidate with_frame(std::string name, std::function<void(const Camera&, FrameAnswer&)> change) {
  Candidate candidate = named(std::move(name));
  candidate.frame = [base = candidate.frame, change](const Camera& camera) {
    FrameAnswer frame = base(camera);
    change(camera, frame);
    return frame;
  };
  return candidate;
}

/// Points and rays made for another camera or other conventions than those given.
Candidate with_inputs(std::string name, std::function<void(Camera&, Conventions&)> change) {
  Candidate candidate = named(std::move(name));
  const auto wrap = [&change](auto& function) {
    function = [base = function, change](Camera camera, Conventions conventions,
                                         Candidate::Pixels pixels) {
      change(camera, conventions);
      return base(camera, conventions, pixels);
    };
  };
  wrap(candidate.pixel_points);
  wrap(candidate.pixel_rays);
  wrap(candidate.focal_rays);
  return candidate;
}

/// Directions changed after the fact; `change` sees the camera and the pixel point.
Candidate with_directions(
    std::string name, std::function<Vector3(const Camera&, const Point3&, const Vector3&)> change) {
  Candidate candidate = named(std::move(name));
  const auto wrap = [&](auto& function) {
    function = [base = function, points = candidate.pixel_points, change](
                   const Camera& camera, const Conventions& conventions, Candidate::Pixels pixels) {
      std::vector<Ray> rays = base(camera, conventions, pixels);
      const std::vector<Point3> P = points(camera, conventions, pixels);
      for (std::size_t k = 0; k < rays.size(); ++k) {
        rays[k].direction = change(camera, P[k], rays[k].direction);
      }
      return rays;
    };
  };
  wrap(candidate.pixel_rays);
  wrap(candidate.focal_rays);
  return candidate;
}

Candidate points_on_a_sphere() {
  Candidate candidate = named("curved-plane");
  candidate.pixel_points = [rays = candidate.focal_rays](const Camera& camera,
                                                         const Conventions& conventions,
                                                         Candidate::Pixels pixels) {
    std::vector<Point3> points;
    for (const Ray& ray : rays(camera, conventions, pixels)) {
      const Vector3 step = scaled(std::abs(camera.near), ray.direction);
      points.push_back({camera.eye.x + step.x, camera.eye.y + step.y, camera.eye.z + step.z});
    }
    return points;
  };
  return candidate;
}

Candidate rays_from_the_eye() {
  Candidate candidate = named("origin-at-eye");
  candidate.pixel_rays = candidate.focal_rays;
  return candidate;
}

std::vector<Mutant> frame_mutants() {
  return {
      {"U = W x up: the image is mirrored",
       {"frame"},
       with_frame("flipped-U",
                  [](const Camera&, FrameAnswer& f) {
                    f.U = {-f.U.x, -f.U.y, -f.U.z};
                  })},
      {"V = U x W: the axes are left-handed",
       {"frame"},
       with_frame("left-handed-V",
                  [](const Camera&, FrameAnswer& f) {
                    f.V = {-f.V.x, -f.V.y, -f.V.z};
                  })},
      {"W = E - A is not normalised",
       {"frame", "look-at"},
       with_frame("unnormalised-W",
                  [](const Camera& c, FrameAnswer& f) { f.W = unit(c.eye - c.look_at); })},
      {"W = (E - A)/(|E - A| + 1e-6), against a division by zero",
       {"frame", "look-at"},
       with_frame("guarded-W",
                  [](const Camera& c, FrameAnswer& f) {
                    const Vector3 view = c.eye - c.look_at;
                    f.W = unit(scaled(1 / (length(view) + 1e-6), view));
                  })},
      {"V = up/|up| is not made perpendicular to W",
       {"frame", "up"},
       with_frame("V-is-up",
                  [](const Camera& c, FrameAnswer& f) { f.V = unit(normalised(c.up)); })},
  };
}

Candidate first_pixel_one_ulp_off() {
  Candidate candidate = named("one-ulp-corner");
  candidate.pixel_points = [base = candidate.pixel_points](const Camera& camera,
                                                           const Conventions& conventions,
                                                           Candidate::Pixels pixels) {
    auto points = base(camera, conventions, pixels);
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!(pixels[k] == scene::Pixel{})) continue;
      for (double* x : {&points[k].x, &points[k].y, &points[k].z})
        *x = std::nextafter(*x, HUGE_VAL);
    }
    return points;
  };
  return candidate;
}

std::vector<Mutant> plane_mutants() {
  return {
      {"alpha(i) = left + i/w (right - left)",
       {"pixel-point", "bounds", "image-plane", "centre-pixel", "density", "direction"},
       with_inputs("off-by-one", [](Camera& c, Conventions&) { ++c.width; })},
      {"pixels are sampled at their centres whatever was asked",
       {"pixel-point", "bounds", "density", "direction"},
       with_inputs("always-centres",
                   [](Camera&, Conventions& asked) { asked.samples = scene::Samples::kCentres; })},
      {"rows are upside down",
       {"pixel-zero-zero", "pixel-point", "bounds", "direction"},
       with_inputs("upside-down", [](Camera& c, Conventions&) { std::swap(c.bottom, c.top); })},
      {"columns are mirrored",
       {"pixel-zero-zero", "pixel-point", "bounds", "direction"},
       with_inputs("mirrored-columns",
                   [](Camera& c, Conventions&) { std::swap(c.left, c.right); })},
      {"the plane is at -near, behind the eye",
       {"pixel-point", "image-plane", "direction"},
       with_inputs("near-flipped", [](Camera& c, Conventions&) { c.near = -c.near; })},
      {"beta(j) divides by the width",
       {"pixel-point", "image-plane", "bounds"},
       with_inputs("beta-by-width", [](Camera& c, Conventions&) { c.height = c.width; })},
      {"the height is corrected for an aspect ratio that the bounds hold already",
       {"square-pixels", "bounds", "pixel-point"},
       with_inputs("aspect-twice",
                   [](Camera& c, Conventions&) {
                     c.top = c.bottom + (c.top - c.bottom) * static_cast<double>(c.width) /
                                            static_cast<double>(c.height);
                   })},
      {"everything is half a pixel to the right",
       {"centre-pixel", "bounds", "pixel-point"},
       with_inputs("half-a-pixel",
                   [](Camera& c, Conventions&) {
                     const double half = (c.right - c.left) / (2 * static_cast<double>(c.width));
                     c.left += half;
                     c.right += half;
                   })},
      {"the step between columns is kept in single precision",
       {"bounds", "pixel-point"},
       with_inputs("single-step",
                   [](Camera& c, Conventions&) {
                     const double steps = static_cast<double>(c.width) - 1;
                     const auto step = static_cast<float>((c.right - c.left) / steps);
                     c.right = c.left + static_cast<double>(step) * steps;
                   })},
      {"the first pixel is one ulp off, where the formula promises its bits",
       {"bounds"},
       first_pixel_one_ulp_off()},
      {"pixels lie on a sphere around the eye",
       {"image-plane", "pixel-point"},
       points_on_a_sphere()},
  };
}

std::vector<Mutant> ray_mutants() {
  return {
      {"D = P - E is not normalised",
       {"unit-direction"},
       with_directions("unnormalised-D",
                       [](const Camera& c, const Point3& P, const Vector3&) { return P - c.eye; })},
      {"D = g/(|g| + 1e-9), against a division by zero",
       {"unit-direction", "scaling"},
       with_directions("guarded-D",
                       [](const Camera& c, const Point3& P, const Vector3& D) {
                         const double size = length(P - c.eye);
                         return scaled(size / (size + 1e-9), D);
                       })},
      {"directions run from the pixel to the eye",
       {"direction"},
       with_directions("backwards", [](const Camera&, const Point3&,
                                       const Vector3& D) { return scaled(-1, D); })},
      {"D = (P + E)/|P + E|",
       {"direction"},
       with_directions("eye-plus-point",
                       [](const Camera& c, const Point3& P, const Vector3&) {
                         return normalised({P.x + c.eye.x, P.y + c.eye.y, P.z + c.eye.z});
                       })},
      {"pixel rays start at the eye", {"ray-origin", "focal-and-pixel"}, rays_from_the_eye()},
  };
}

}  // namespace

std::vector<Mutant> camera_mutants() {
  std::vector<Mutant> all = frame_mutants();
  for (auto& more : {plane_mutants(), ray_mutants()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace raycheck::mutants
