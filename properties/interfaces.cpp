#include "properties/interfaces.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "properties/failures.h"
#include "properties/truth.h"
#include "reference/account/nearby_valid.h"
#include "reference/exact_ray.h"

namespace raycheck::properties {
namespace {

using contract::Interface;

/// With 11 bits more than doubles have, and exponents so wide that nothing here overflows.
struct Wide {
  template <class Triple>
  explicit Wide(const Triple& v) : x(v.x), y(v.y), z(v.z) {}
  Wide(long double its_x, long double its_y, long double its_z) : x(its_x), y(its_y), z(its_z) {}
  Wide operator-(const Wide& other) const { return {x - other.x, y - other.y, z - other.z}; }
  long double dot(const Wide& other) const { return x * other.x + y * other.y + z * other.z; }
  long double x, y, z;
};

/// The inputs as they are passed, one by one.
template <class Inputs>
auto all_passed(const Inputs& inputs, const Interface& interface) {
  std::vector<std::remove_const_t<typename Inputs::element_type>> all;
  all.reserve(inputs.size());
  for (const auto& one : inputs) all.push_back(passed(one, interface));
  return all;
}

/// The end of a segment in one dimension.
double end_of(double origin, double step) {
  const double end = origin + step;
  if (end - origin == step && end - step == origin) return end;
  throw CannotBeSaid("the end of a segment, origin + direction, is not a double");
}

/// A - E in one dimension.
double view_along(double eye, double look_at) {
  const double view = look_at - eye;
  if (eye + view == look_at && look_at - view == eye) return view;
  throw CannotBeSaid("the view direction, look_at - eye, is not a double");
}

/// E + (P - E), of a candidate whose directions are P - E.
auto points_of(const Functions& functions, Precision precision) {
  const auto& make = functions.focal_rays ? functions.focal_rays : functions.pixel_rays;
  decltype(functions.pixel_points) points;
  if (!make) return points;
  points = [make, precision](const Camera& camera, const Conventions& conventions,
                             Functions::Pixels pixels) {
    const auto end = [=](double eye, double step) {
      return scene::rounded_to(precision, eye + step);
    };
    std::vector<Point3> all;
    for (const Ray& ray : make(camera, conventions, pixels)) {
      const auto& [x, y, z] = ray.direction;
      all.push_back({end(camera.eye.x, x), end(camera.eye.y, y), end(camera.eye.z, z)});
    }
    return all;
  };
  return points;
}

/// Of both roots of a line, the one that counts, with the other beside it; empty if none counts.
std::optional<HitAnswer> chosen(const HitAnswer& roots, const Ray& ray, const Sphere& sphere,
                                const Conventions& conventions) {
  const auto& [valid, root] = std::pair(conventions.valid, conventions.root);
  const double entry = roots.parameter, exit = roots.point.x;
  const auto counts = [&, exact = reference::ExactRay(ray)](double s) {
    return std::isfinite(s) && !reference::is_outside(conventions.valid, exact, sphere, s);
  };
  if (valid.culling != scene::Culling::kFrontFaces && counts(entry)) return {{entry, {}, exit}};
  const bool may_exit =
      root == scene::Root::kNearest && valid.culling != scene::Culling::kBackFaces;
  if (may_exit && counts(exit)) return {{exit, {}, entry}};
  return {};
}

/// Completes the answers about these rays, and leaves out those without a root that counts.
void complete(std::vector<SphereHits>& all, Functions::Rays rays, Functions::Spheres spheres,
              const Conventions& conventions, const Interface& interface) {
  for (std::size_t sphere = 0; sphere < std::min(all.size(), spheres.size()); ++sphere) {
    const auto is_no_hit = [&](RayHit& hit) {
      if (hit.ray >= rays.size()) return false;  // Answers reports it
      const Ray& ray = rays[hit.ray];
      if (interface.returns == Returns::kRoots) {
        const auto root = chosen(hit.hit, ray, spheres[sphere], conventions);
        if (!root) return true;
        hit.hit = *root;
      }
      hit.hit = completed(hit.hit, interface.returns, ray, spheres[sphere]);
      return false;
    };
    std::erase_if(all[sphere], is_no_hit);
  }
}

/// A function of pixels.
template <class Make, class Answer>
void adapt_pixels(Make& make, const Interface& interface, const Answer& answer) {
  if (!make) return;
  make = [make, interface, answer](const Camera& camera, const Conventions& conventions,
                                   Functions::Pixels pixels) {
    auto all = make(passed(camera, interface), conventions, all_passed(pixels, interface));
    std::ranges::for_each(all, answer);
    return all;
  };
}

}  // namespace

Ray passed(const Ray& ray, const Interface& interface) {
  if (interface.rays == contract::RayForm::kDirection) return ray;
  const auto& [origin, step] = ray;
  return {origin, {end_of(origin.x, step.x), end_of(origin.y, step.y), end_of(origin.z, step.z)}};
}

Sphere passed(const Sphere& sphere, const Interface& interface) {
  const bool is_placed =
      interface.placement == contract::Placement::kAnywhere ||
      (sphere.centre == Point3{} &&
       (interface.placement == contract::Placement::kOrigin || sphere.radius == 1));
  if (!is_placed)
    throw CannotBeSaid("the law moves the sphere to where the candidate does not accept it");
  const bool by_diameter = interface.spheres == contract::SphereSize::kDiameter;
  return {sphere.centre, by_diameter ? 2 * sphere.radius : sphere.radius};
}

Pixel passed(const Pixel& pixel, const Interface& interface) {
  const bool row_first = interface.pixels == contract::PixelOrder::kRowColumn;
  return row_first ? Pixel{pixel.j, pixel.i} : pixel;
}

Camera passed(const Camera& camera, const Interface& interface) {
  if (interface.view != contract::View::kDirection) return camera;
  Camera one = camera;
  const auto& [x, y, z] = camera.eye;
  one.look_at = {view_along(x, one.look_at.x), view_along(y, one.look_at.y),
                 view_along(z, one.look_at.z)};
  return one;
}

Ray made(const Ray& ray, const Interface& interface, Precision precision) {
  return interface.made == contract::MadeLength::kUnit ? ray : with_unit_direction(ray, precision);
}

HitAnswer completed(const HitAnswer& hit, Returns returns, const Ray& ray, const Sphere& sphere) {
  const Wide origin(ray.origin), direction(ray.direction);
  const long double a = direction.dot(direction);
  const auto projection = [&](const Point3& point) {
    return (Wide(point) - origin).dot(direction) / a;
  };
  long double s = hit.parameter;
  switch (returns) {
    case Returns::kHit:
      return hit;
    case Returns::kParameter:
    case Returns::kRoots:
      break;
    case Returns::kPoint:
      return {static_cast<double>(projection(hit.point)), hit.point};
    case Returns::kDistance:
      s /= std::sqrt(a);
      break;
    case Returns::kSquaredDistance:
      s = std::sqrt(s / a);
      break;
    case Returns::kClass:
      s = std::max(0.0L, projection(sphere.centre));
      break;
  }
  const auto along = [s](double from, double by) { return static_cast<double>(from + s * by); };
  return {static_cast<double>(s),
          {along(ray.origin.x, ray.direction.x), along(ray.origin.y, ray.direction.y),
           along(ray.origin.z, ray.direction.z)},
          hit.other_root};
}

Functions adapted(Functions functions, const Interface& interface, Precision precision) {
  Functions as_given = functions;
  if (functions.frame) {
    functions.frame = [frame = as_given.frame, interface](const Camera& camera) {
      return frame(passed(camera, interface));
    };
  }
  if (interface.made == contract::MadeLength::kImagePlane && !functions.pixel_points) {
    functions.pixel_points = points_of(functions, precision);
  }
  const auto as_is = [](const Point3& /*point*/) {};
  const auto make_unit = [interface, precision](Ray& ray) {
    ray = made(ray, interface, precision);
  };
  adapt_pixels(functions.pixel_points, interface, as_is);
  adapt_pixels(functions.pixel_rays, interface, make_unit);
  adapt_pixels(functions.focal_rays, interface, make_unit);
  if (functions.intersect) {
    functions.intersect = [intersect = as_given.intersect, interface](
                              Functions::Rays rays, Functions::Spheres spheres,
                              const Conventions& conventions) {
      std::vector<SphereHits> all =
          intersect(all_passed(rays, interface), all_passed(spheres, interface), conventions);
      complete(all, rays, spheres, conventions, interface);
      return all;
    };
  }
  if (functions.pick) {
    functions.pick = [pick = as_given.pick, interface, precision](
                         const Camera& camera, const Conventions& conventions,
                         Functions::Pixels pixels, Functions::Spheres spheres) {
      std::vector<SphereHits> all =
          pick(passed(camera, interface), conventions, all_passed(pixels, interface),
               all_passed(spheres, interface));
      const auto rays =
          rounded_rays(reference::ExactCamera(camera, conventions), pixels, precision);
      complete(all, rays, spheres, conventions, interface);
      return all;
    };
  }
  if (functions.nearest) {
    functions.nearest = [nearest = as_given.nearest, interface](Functions::Rays rays,
                                                                Functions::Spheres spheres,
                                                                const Conventions& conventions) {
      return nearest(all_passed(rays, interface), all_passed(spheres, interface), conventions);
    };
  }
  functions.by_interface = [as_given = std::move(as_given), precision](const Interface& other) {
    return adapted(as_given, other, precision);
  };
  return functions;
}

}  // namespace raycheck::properties
