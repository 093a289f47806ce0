// Wrong formulas on the way from a camera to its rays.

#include <cmath>
#include <utility>

#include "fast/camera_frame.h"
#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {
namespace {

using scene::UnitVector3;

/// The axis may have any length.
UnitVector3 axis(const Vector3& v) { return {v.x, v.y, v.z}; }
Vector3 scaled(double factor, const Vector3& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}
Vector3 view(const Camera& camera) { return camera.eye - camera.look_at; }
void turn(UnitVector3& axis) { axis = {-axis.x, -axis.y, -axis.z}; }

/// A mistake that changes the right axes.
Mistake frame(std::string sentence, std::function<void(const Camera&, FrameAnswer&)> change) {
  return {.sentence = std::move(sentence),
          .step = Step::kFrame,
          .rays = {.frame = [change = std::move(change)](const Camera& camera) {
            const fast::CameraFrame right = fast::camera_frame(camera);
            FrameAnswer axes = {right.U, right.V, right.W};
            change(camera, axes);
            return axes;
          }}};
}

std::vector<Mistake> frame_mistakes() {
  const auto turned = [](std::string sentence, bool U, bool V, bool W) {
    return frame(std::move(sentence), [=](const Camera&, FrameAnswer& axes) {
      if (U) turn(axes.U);
      if (V) turn(axes.V);
      if (W) turn(axes.W);
    });
  };
  return {
      turned("U has the wrong sign", true, false, false),
      turned("V has the wrong sign", false, true, false),
      turned("W has the wrong sign", false, false, true),
      turned("U and V have the wrong sign, as by U = W x up", true, true, false),
      turned("U and W have the wrong sign, as by W = A - E", true, false, true),
      turned("V and W have the wrong sign", false, true, true),
      turned("U, V and W have the wrong sign", true, true, true),
      frame("V is up itself, not made perpendicular to W",
            [](const Camera& c, FrameAnswer& axes) { axes.V = axis(c.up); }),
      frame("V is up/|up|, not made perpendicular to W",
            [](const Camera& c, FrameAnswer& axes) { axes.V = axis(normalised(c.up)); }),
      frame("U and V are exchanged", [](auto&, FrameAnswer& axes) { std::swap(axes.U, axes.V); }),
      frame("W is not normalised: W = E - A",
            [](const Camera& c, FrameAnswer& axes) { axes.W = axis(view(c)); }),
      frame("W is not normalised, nor V = W x U",
            [](const Camera& c, FrameAnswer& axes) {
              axes.W = axis(view(c));
              axes.V = axis(cross(view(c), axes.U));
            }),
      frame("U is not normalised: U = up x W",
            [](const Camera& c, FrameAnswer& axes) { axes.U = axis(cross(c.up, axes.W)); }),
      frame("U is not normalised, nor V = W x U",
            [](const Camera& c, FrameAnswer& axes) {
              axes.U = axis(cross(c.up, axes.W));
              axes.V = axis(cross(axes.W, axes.U));
            }),
      frame("the axes are not normalised: W = E - A, U = up x W, V = W x U",
            [](const Camera& c, FrameAnswer& axes) {
              axes.W = axis(view(c));
              axes.U = axis(cross(c.up, axes.W));
              axes.V = axis(cross(view(c), axes.U));
            }),
      frame("the axes are lost: all are zero", [](auto&, FrameAnswer& axes) { axes = {}; }),
      frame("the axes are those of the world",
            [](auto&, FrameAnswer& axes) {
              axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
            }),
  };
}

/// The lecture's v and d, which assume |D| = 1, used as multiples of D. Computed without loss of
/// digits, since that is another mistake.
fast::Roots roots_of_unit(const Ray& ray, const Sphere& sphere) {
  fast::Roots roots = fast::kCross.roots(ray, sphere);
  const double size = norm(ray.direction), excess = size * size - 1;
  const double v = roots.axial_distance;
  if (std::abs(excess) > 1e-12) roots.half_chord_sq += v * v * excess;
  const double d = std::sqrt(roots.half_chord_sq);
  return {size * v, roots.half_chord_sq, size * v - d, size * v + d};
}

/// The roots of code that assumes |D| = 1 and computes d^2 = r^2 - |T x D|^2, and one root as
/// (|T|^2 - r^2) over the other.
fast::Roots stable_roots_of_unit(const Ray& ray, const Sphere& sphere) {
  fast::Roots roots = fast::kCross.roots(ray, sphere);
  const double size = norm(ray.direction), excess = size * size - 1;
  const double r = sphere.radius, t = norm(sphere.centre - ray.origin);
  if (std::abs(excess) > 1e-12) {
    roots.half_chord_sq -= excess * (r * r - roots.half_chord_sq);
  }
  const double v = size * roots.axial_distance, d = std::sqrt(roots.half_chord_sq);
  const double q = v >= 0 ? v + d : v - d, other = (t - r) * (t + r) / q;
  return {v, roots.half_chord_sq, v >= 0 ? other : q, v >= 0 ? q : other};
}

bool accepts_any_length(const Candidate& candidate) {
  return candidate.interface.directions == contract::Directions::kAny;
}
bool returns_distances(const Candidate& candidate) {
  return candidate.interface.returns == Returns::kDistance ||
         candidate.interface.returns == Returns::kSquaredDistance;
}

/// A mistake in code that assumes unit directions: its s is a multiple of D or a distance.
Mistake unit_mistake(std::string sentence, MakeRoots roots, bool as_distance) {
  Mistake mistake = {.sentence = std::move(sentence), .step = Step::kIntersect, .hits = {roots}};
  mistake.shows_in_pictures = false;
  if (!as_distance) {
    mistake.is_offered = [](const Candidate& c) {
      return accepts_any_length(c) && !returns_distances(c);
    };
    return mistake;
  }
  mistake.sentence += ", also in the distance that is returned";
  mistake.hits.roots = [roots](const Ray& ray, const Sphere& sphere) {
    const auto [v, half_chord_sq, smaller, larger] = roots(ray, sphere);
    return fast::Roots{v, half_chord_sq, smaller / norm(ray.direction),
                       larger / norm(ray.direction)};
  };
  mistake.is_offered = [](const Candidate& c) {
    return accepts_any_length(c) && returns_distances(c);
  };
  return mistake;
}

std::vector<Mistake> unit_mistakes() {
  std::vector<Mistake> all;
  for (const bool as_distance : {false, true}) {
    all.push_back(unit_mistake("directions are taken for unit vectors, whatever their length",
                               roots_of_unit, as_distance));
    all.push_back(unit_mistake("directions are taken for unit vectors in d^2 = r^2 - |T x D|^2",
                               stable_roots_of_unit, as_distance));
  }
  all.front().shows_in_pictures = true;
  return all;
}

/// Only hits between the eye and the image plane count; s is in multiples of P - E.
Hit before_the_plane(const Ray& ray, const fast::Roots& roots, const Conventions& conventions) {
  const Hit hit = usual_choice(ray, roots, conventions);
  return hit && hit->parameter <= 1 ? hit : Hit();
}

std::vector<Mistake> ray_mistakes() {
  const auto unchanged = [](auto&, auto&, const Vector3& g) { return g; };
  return {
      {.sentence = "E is not added: P = nW + alpha U + beta V",
       .step = Step::kPixelPoint,
       .rays = {.point =
                    [](auto&, const Vector3& g) {
                      return Point3{g.x, g.y, g.z};
                    },
                .direction = [](const Camera& c, const Point3& P,
                                auto&) { return normalised(P - c.eye); }}},
      {.sentence = "P lies on a sphere around the eye: P = E + |near| D",
       .step = Step::kPixelPoint,
       .rays = {.point =
                    [](const Camera& c, const Vector3& g) {
                      const Vector3 D = scaled(std::abs(c.near), normalised(g));
                      return Point3{c.eye.x + D.x, c.eye.y + D.y, c.eye.z + D.z};
                    }},
       .shows_in_pictures = false},
      {.sentence = "directions are not normalised: D = P - E",
       .step = Step::kRay,
       .rays = {.direction = unchanged},
       .hits = {.roots = roots_of_unit}},
      {.sentence =
           "only spheres between the eye and the image plane are seen: near is taken for far",
       .step = Step::kRay,
       .rays = {.direction = unchanged, .starts_at_eye = true},
       .hits = {.choose = before_the_plane},
       .is_offered = [](const Candidate& c) { return static_cast<bool>(c.image); }},
      {.sentence = "directions run from the pixel to the eye: D = (E - P)/|E - P|",
       .step = Step::kRay,
       .rays = {.direction = [](auto&, auto&,
                                const Vector3& g) { return scaled(-1, normalised(g)); }}},
      {.sentence = "E is added where it should be subtracted: D = (P + E)/|P + E|",
       .step = Step::kRay,
       .rays = {.direction =
                    [](const Camera& c, const Point3& P, auto&) {
                      return normalised({P.x + c.eye.x, P.y + c.eye.y, P.z + c.eye.z});
                    }}},
      {.sentence = "E is not subtracted: D = P/|P|",
       .step = Step::kRay,
       .rays = {.direction = [](auto&, const Point3& P, auto&) { return normalised(vector(P)); }}},
      {.sentence = "all rays run straight ahead: D = -W",
       .step = Step::kRay,
       .rays = {.direction = [](const Camera& c, auto&,
                                auto&) { return scaled(-1, vector(fast::camera_frame(c).W)); }}},
      {.sentence = "E is not subtracted and D not normalised: D = P",
       .step = Step::kRay,
       .rays = {.direction = [](auto&, const Point3& P, auto&) { return vector(P); }}},
  };
}

}  // namespace

std::vector<Mistake> camera_mistakes() {
  return all_of({frame_mistakes(), ray_mistakes(), unit_mistakes()});
}

}  // namespace raycheck::properties
