
#include "tests/mutants/mutants.h"

namespace raycheck::mutants {
namespace {

Vector3 scaled(double factor, const Vector3& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

double length(const Vector3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

Candidate with_guarded_W() {
  Candidate candidate = named("guarded-W");
  candidate.frame = [base = candidate.frame](const Camera& camera) {
    FrameAnswer frame = base(camera);
    const Vector3 view = camera.eye - camera.look_at;
    const Vector3 W = scaled(1 / (length(view) + 1e-6), view);
    frame.W = {W.x, W.y, W.z};
    return frame;
  };
  return candidate;
}

/// A mutant that makes points and rays for another camera or other conventions than those given.
Candidate with_inputs(std::string name, std::function<void(Camera&, Conventions&)> change) {
  Candidate candidate = named(std::move(name));
  const auto wrap = [&change](auto& function) {
    function = [base = function, change](Camera camera, Conventions by, Candidate::Pixels pixels) {
      change(camera, by);
      return base(camera, by, pixels);
    };
  };
  wrap(candidate.pixel_points);
  wrap(candidate.pixel_rays);
  wrap(candidate.focal_rays);
  return candidate;
}

/// A mutant that changes right directions; `change` gets the camera and the pixel point.
Candidate with_directions(
    std::string name, std::function<Vector3(const Camera&, const Point3&, const Vector3&)> change) {
  Candidate candidate = named(std::move(name));
  for (auto* make : {&candidate.pixel_rays, &candidate.focal_rays}) {
    *make = [base = *make, points = candidate.pixel_points, change](const Camera& camera,
                                                                    const auto&... asked) {
      std::vector<Ray> rays = base(camera, asked...);
      const std::vector<Point3> P = points(camera, asked...);
      for (std::size_t k = 0; k < rays.size(); ++k) {
        rays[k].direction = change(camera, P[k], rays[k].direction);
      }
      return rays;
    };
  }
  return candidate;
}

std::vector<Mutant> frame_mutants() {
  return {
      from_mistake("flipped-U", "U has the wrong sign", {"frame"}),
      from_mistake("left-handed-V", "V has the wrong sign", {"frame"}),
      from_mistake("unnormalised-W", "W is not normalised: W = E - A", {"frame", "look-at"}),
      {"W = (E - A)/(|E - A| + 1e-6), against a division by zero",
       {"frame", "look-at"},
       with_guarded_W()},
      from_mistake(
          "short-is-left",
          "vectors with a squared length below about 1e-9 (the limit may be larger) are not "
          "normalised: the epsilon is too large",
          {"scaling"}),
      from_mistake(
          "short-is-zero",
          "vectors with a squared length below about 1e-9 (the limit may be larger) are taken for "
          "0: the epsilon is too large",
          {"scaling"}),
      from_mistake("V-is-up", "V is up/|up|, not made perpendicular to W", {"frame", "up"}),
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
      from_mistake(
          "off-by-one", "alpha = left + i/w (right - left)",
          {"pixel-point", "bounds", "image-plane", "centre-pixel", "density", "direction"}),
      from_mistake("always-centres", "pixels are sampled at their centres",
                   {"pixel-point", "bounds", "density", "direction"}),
      {"pixels are sampled at their corners, i/w and j/h",
       {"pixel-point", "bounds", "direction"},
       with_inputs("always-corners",
                   [](Camera&, Conventions& by) { by.samples = scene::Samples::kCorners; })},
      from_mistake("upside-down", "rows are upside down",
                   {"pixel-zero-zero", "pixel-point", "bounds", "direction"}),
      from_mistake("mirrored-columns", "columns are mirrored",
                   {"pixel-zero-zero", "pixel-point", "bounds", "direction"}),
      from_mistake("near-flipped", "near has the wrong sign, the image plane is behind the eye",
                   {"pixel-point", "image-plane", "direction"}),
      from_mistake("beta-by-width", "rows are divided by the width",
                   {"pixel-point", "image-plane", "bounds"}),
      from_mistake("aspect-twice",
                   "the height is corrected for an aspect ratio that the bounds already contain",
                   {"square-pixels", "bounds", "pixel-point"}),
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
                     int exponent = 0;  // floats lose only digits, doubles keep the exponent
                     const double step = std::frexp((c.right - c.left) / steps, &exponent);
                     const auto kept = static_cast<double>(static_cast<float>(step));
                     c.right = c.left + std::ldexp(kept, exponent) * steps;
                   })},
      {"the first pixel is one ulp off, where the formula promises its bits",
       {"bounds"},
       first_pixel_one_ulp_off()},
      from_mistake("single-camera", "the camera's numbers are rounded to floats",
                   {"pixel-point", "direction"}),
      from_mistake("single-P", "P is rounded to floats", {"pixel-point"}),
      from_mistake("single-D", "D is rounded to floats", {"direction", "unit-direction"}),
      from_mistake("curved-plane", "P lies on a sphere around the eye: P = E + |near| D",
                   {"image-plane", "pixel-point", "ray-origin"}),
  };
}

std::vector<Mutant> ray_mutants() {
  return {
      from_mistake("unnormalised-D", "directions are not normalised: D = P - E",
                   {"unit-direction"}),
      {"D = g/(|g| + 1e-9), against a division by zero",
       {"unit-direction", "scaling"},
       with_directions("guarded-D",
                       [](const Camera& c, const Point3& P, const Vector3& D) {
                         const double size = length(P - c.eye);
                         return scaled(size / (size + 1e-9), D);
                       })},
      {"E is added and subtracted again: D = (P - E)/|P - E|",
       {"direction"},
       with_directions("eye-added-and-subtracted",
                       [](const Camera& c, const Point3& P, const Vector3&) {
                         const Vector3 g = P - c.eye;
                         return scaled(1 / length(g), g);
                       }),
       Level::kDemanding},
      from_mistake("backwards", "directions run from the pixel to the eye: D = (E - P)/|E - P|",
                   {"direction"}),
      from_mistake("eye-plus-point",
                   "E is added where it should be subtracted: D = (P + E)/|P + E|", {"direction"}),
      from_mistake("origin-at-eye",
                   "rays start at the eye, so that spheres before the image plane are seen",
                   {"ray-origin", "focal-and-pixel"}),
  };
}

}  // namespace

std::vector<Mutant> camera_mutants() {
  return joined({frame_mutants(), plane_mutants(), ray_mutants()});
}

}  // namespace raycheck::mutants
