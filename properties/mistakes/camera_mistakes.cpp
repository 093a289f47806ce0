// Wrong formulas on the way from a camera to its rays.

#include <cmath>
#include <utility>

#include "fast/camera_frame.h"
#include "fast/pixel_ray.h"
#include "properties/mistakes/altered_hits.h"
#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {
namespace {

using scene::Camera;
using scene::Conventions;
using scene::Pixel;
using scene::Point3;
using scene::Ray;
using scene::Root;
using scene::Sphere;
using scene::UnitVector3;
using scene::Vector3;

template <class Triple>
double dot(const Vector3& a, const Triple& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vector3 cross(const Vector3& a, const UnitVector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vector3 scaled(double factor, const Vector3& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}
Vector3 normalised(const Vector3& v) { return scaled(1 / std::sqrt(dot(v, v)), v); }
Vector3 vector(const UnitVector3& v) { return {v.x, v.y, v.z}; }
/// An axis that may be none.
UnitVector3 axis(const Vector3& v) { return {v.x, v.y, v.z}; }

/// alpha and beta of pixels, interpolated between those of the first and the last.
class Positions {
 public:
  Positions(const Camera& camera, const Conventions& conventions)
      : columns_(static_cast<double>(camera.width - 1)),
        rows_(static_cast<double>(camera.height - 1)),
        first_(fast::plane_position(camera, conventions, {0, 0})),
        last_(fast::plane_position(camera, conventions, {camera.width - 1, camera.height - 1})) {}

  fast::PlanePosition at(const Pixel& pixel) const {
    return {between(first_.alpha, last_.alpha, static_cast<double>(pixel.i), columns_),
            between(first_.beta, last_.beta, static_cast<double>(pixel.j), rows_)};
  }

 private:
  static double between(double first, double last, double index, double most) {
    return most > 0 ? first + index / most * (last - first) : first;
  }

  double columns_, rows_;
  fast::PlanePosition first_, last_;
};

/// The formulas step by step; a mistake replaces one.
struct Formulas {
  std::function<FrameAnswer(const Camera&)> frame = [](const Camera& camera) {
    const fast::CameraFrame right = fast::camera_frame(camera);
    return FrameAnswer{right.U, right.V, right.W};
  };
  /// P from g = nW + alpha U + beta V
  std::function<Point3(const Camera&, const Vector3&)> point = [](const Camera& camera,
                                                                  const Vector3& g) {
    return Point3{camera.eye.x + g.x, camera.eye.y + g.y, camera.eye.z + g.z};
  };
  /// D from P and g
  std::function<Vector3(const Camera&, const Point3&, const Vector3&)> direction =
      [](const Camera&, const Point3&, const Vector3& g) { return normalised(g); };
};

/// Calls tell(P, g) for each pixel.
template <class Tell>
void walk(const Formulas& formulas, const Camera& camera, const Conventions& conventions,
          Candidate::Pixels pixels, const Tell& tell) {
  const FrameAnswer axes = formulas.frame(camera);
  const Positions positions(camera, conventions);
  for (const Pixel& pixel : pixels) {
    const auto [alpha, beta] = positions.at(pixel);
    const double n = camera.near;
    const Vector3 g = {n * axes.W.x + alpha * axes.U.x + beta * axes.V.x,
                       n * axes.W.y + alpha * axes.U.y + beta * axes.V.y,
                       n * axes.W.z + alpha * axes.U.z + beta * axes.V.z};
    tell(formulas.point(camera, g), g);
  }
}

Candidate with(const Formulas& formulas) {
  Candidate candidate = right_candidate();
  candidate.frame = formulas.frame;
  candidate.pixel_points = [formulas](const Camera& camera, const Conventions& conventions,
                                      Candidate::Pixels pixels) {
    std::vector<Point3> points;
    walk(formulas, camera, conventions, pixels,
         [&](const Point3& P, const Vector3&) { points.push_back(P); });
    return points;
  };
  const auto rays_from = [&formulas](scene::Origin origin) {
    return [formulas, origin](const Camera& camera, const Conventions& conventions,
                              Candidate::Pixels pixels) {
      std::vector<Ray> rays;
      walk(formulas, camera, conventions, pixels, [&](const Point3& P, const Vector3& g) {
        rays.push_back(
            {origin == scene::Origin::kPixel ? P : camera.eye, formulas.direction(camera, P, g)});
      });
      return rays;
    };
  };
  candidate.pixel_rays = rays_from(scene::Origin::kPixel);
  candidate.focal_rays = rays_from(scene::Origin::kFocal);
  return candidate;
}

Mistake of_rays(std::string sentence, Step step, const Formulas& formulas) {
  Mistake mistake = {.sentence = std::move(sentence), .step = step};
  mistake.candidate = with(formulas);
  mistake.makes_rays = true;
  return mistake;
}

/// Right axes, changed afterwards.
Mistake frame(std::string sentence, std::function<void(const Camera&, FrameAnswer&)> change) {
  Formulas formulas;
  formulas.frame = [right = formulas.frame, change = std::move(change)](const Camera& camera) {
    FrameAnswer axes = right(camera);
    change(camera, axes);
    return axes;
  };
  return of_rays(std::move(sentence), Step::kFrame, formulas);
}

void turn(UnitVector3& axis) { axis = {-axis.x, -axis.y, -axis.z}; }

std::vector<Mistake> sign_mistakes() {
  const auto turned = [](std::string sentence, bool U, bool V, bool W) {
    return frame(std::move(sentence), [=](const Camera&, FrameAnswer& axes) {
      if (U) turn(axes.U);
      if (V) turn(axes.V);
      if (W) turn(axes.W);
    });
  };
  return {turned("U has the wrong sign", true, false, false),
          turned("V has the wrong sign", false, true, false),
          turned("W has the wrong sign", false, false, true),
          turned("U and V have the wrong sign, as by U = W x up", true, true, false),
          turned("U and W have the wrong sign, as by W = A - E", true, false, true),
          turned("V and W have the wrong sign", false, true, true),
          turned("U, V and W have the wrong sign", true, true, true)};
}

Vector3 view(const Camera& camera) { return camera.eye - camera.look_at; }

std::vector<Mistake> axis_mistakes() {
  return {
      frame("V is up itself, not made perpendicular to W",
            [](const Camera& c, FrameAnswer& axes) { axes.V = axis(c.up); }),
      frame("V is up/|up|, not made perpendicular to W",
            [](const Camera& c, FrameAnswer& axes) { axes.V = axis(normalised(c.up)); }),
      frame("U and V are exchanged",
            [](const Camera&, FrameAnswer& axes) { std::swap(axes.U, axes.V); }),
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
              axes.V = axis(cross(vector(axes.W), axes.U));
            }),
      frame("the axes are not normalised: W = E - A, U = up x W, V = W x U",
            [](const Camera& c, FrameAnswer& axes) {
              axes.W = axis(view(c));
              axes.U = axis(cross(c.up, axes.W));
              axes.V = axis(cross(view(c), axes.U));
            }),
      frame("the axes are lost: all are zero", [](const Camera&, FrameAnswer& axes) { axes = {}; }),
      frame("the axes are those of the world",
            [](const Camera&, FrameAnswer& axes) {
              axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
            }),
  };
}

Mistake direction(std::string sentence,
                  std::function<Vector3(const Camera&, const Point3&, const Vector3&)> formula) {
  Formulas formulas;
  formulas.direction = std::move(formula);
  return of_rays(std::move(sentence), Step::kRay, formulas);
}

Vector3 from_world(const Point3& P) { return {P.x, P.y, P.z}; }

/// The lecture's v and d, which assume |D| = 1, used as multiples of D.
fast::Roots roots_of_unit(const Ray& ray, const Sphere& sphere) {
  const Vector3 T = sphere.centre - ray.origin;
  const double v = dot(T, ray.direction);
  const double half_chord_sq = sphere.radius * sphere.radius - (dot(T, T) - v * v);
  const double half_chord = std::sqrt(half_chord_sq);
  return {v, half_chord_sq, v - half_chord, v + half_chord};
}

/// Hits between the eye and the image plane only; s is in multiples of P - E.
Hit before_the_plane(const Ray& ray, const fast::Roots& roots, const Conventions& conventions) {
  const Hit hit = usual_choice(ray, roots, conventions);
  return hit && hit->parameter <= 1 ? hit : Hit();
}

/// Takes the image plane for the far plane.
Mistake near_for_far() {
  Mistake mistake =
      direction("only what lies between the eye and the image plane is seen: near is taken for far",
                [](const Camera&, const Point3&, const Vector3& g) { return g; });
  mistake.candidate.pixel_rays = mistake.candidate.focal_rays;
  find_hits_by(mistake, {.choose = before_the_plane});
  return mistake;
}

std::vector<Mistake> ray_mistakes() {
  Formulas without_eye;
  without_eye.point = [](const Camera&, const Vector3& g) { return Point3{g.x, g.y, g.z}; };
  without_eye.direction = [](const Camera& c, const Point3& P, const Vector3&) {
    return normalised(P - c.eye);
  };
  Mistake not_unit = direction("directions are not normalised: D = P - E",
                               [](const Camera&, const Point3&, const Vector3& g) { return g; });
  find_hits_by(not_unit, {.roots = roots_of_unit});
  const Mistake taken_for_unit = hit_mistake(
      "directions are taken for unit ones, whatever their length", {.roots = roots_of_unit});
  return {
      of_rays("E is not added: P = nW + alpha U + beta V", Step::kPixelPoint, without_eye),
      not_unit,
      taken_for_unit,
      near_for_far(),
      direction(
          "directions run from the pixel to the eye: D = (E - P)/|E - P|",
          [](const Camera&, const Point3&, const Vector3& g) { return scaled(-1, normalised(g)); }),
      direction("E is added where it should be subtracted: D = (P + E)/|P + E|",
                [](const Camera& c, const Point3& P, const Vector3&) {
                  return normalised({P.x + c.eye.x, P.y + c.eye.y, P.z + c.eye.z});
                }),
      direction(
          "E is not subtracted: D = P/|P|",
          [](const Camera&, const Point3& P, const Vector3&) { return normalised(from_world(P)); }),
      direction("all rays run straight ahead: D = -W",
                [](const Camera& c, const Point3&, const Vector3&) {
                  const UnitVector3 W = fast::camera_frame(c).W;
                  return Vector3{-W.x, -W.y, -W.z};
                }),
      direction("E is not subtracted and D not normalised: D = P",
                [](const Camera&, const Point3& P, const Vector3&) { return from_world(P); }),
  };
}

}  // namespace

std::vector<Mistake> camera_mistakes() {
  std::vector<Mistake> all = sign_mistakes();
  for (auto& more : {axis_mistakes(), ray_mistakes()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace raycheck::properties
