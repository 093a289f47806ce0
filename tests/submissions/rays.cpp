// A student's rays and spheres in C++, correct by default. A first line `#define MISTAKE u_flipped`
// adds the mistake of that name; `#define NUMBER float` computes in floats.

#include <algorithm>
#include <cmath>
#include <raycheck/candidate.hpp>

#ifndef NUMBER
#define NUMBER double
#endif
#ifndef PRECISION
#define PRECISION double_
#endif

using namespace raycheck;

#ifdef MISTAKE_BY_NAME
#include "by_name.h"
#elif !defined MISTAKE
#define MISTAKE none
#endif

namespace {

#define MISTAKES                                                                                   \
  none, width_height, top_from_right, top_is_minus_bottom, u_flipped, u_and_w_flipped,             \
      no_test_for_t, first_sphere_wins, normalize_discarded, by_discriminant, eye_plus_point,      \
      axes_dropped, float_directions, near_root_only, far_root, upside_down, mirrored, cancelling, \
      near_negated, centre_behind
enum class Mistake { MISTAKES };

#ifdef MISTAKE_BY_NAME
bool has(Mistake mistake) {
  static const auto made = static_cast<Mistake>(PLACE_BY_NAME(MISTAKES));
  return mistake == made;
}
#else
constexpr bool has(Mistake mistake) { return mistake == Mistake::MISTAKE; }
#endif

using Number = NUMBER;
struct Vec {
  Number x = 0, y = 0, z = 0;
};

Number in(double x) { return static_cast<Number>(x); }
Vec in(const Vector& a) { return {in(a.x), in(a.y), in(a.z)}; }
Vector out(Vec a) { return {a.x, a.y, a.z}; }

Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(Number k, Vec a) { return {k * a.x, k * a.y, k * a.z}; }
Number dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Number length(Vec a) { return std::hypot(a.x, a.y, a.z); }
Vec normalize(Vec a) {
  const Number l = length(a);
  return {a.x / l, a.y / l, a.z / l};
}
Vec to_float(Vec a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

/// A camera and its axes.
struct View {
  explicit View(const Camera& given) : camera(given) {
    w = normalize(in(camera.eye) - in(camera.look_at));
    if (has(Mistake::u_and_w_flipped)) w = normalize(in(camera.look_at) - in(camera.eye));
    u = normalize(cross(in(camera.up), w));
    if (has(Mistake::u_flipped)) u = normalize(cross(w, in(camera.up)));
    // An up vector near W makes U inaccurate.
    v = normalize(cross(w, u));
    u = cross(v, w);
    if (has(Mistake::top_from_right)) camera.top = camera.right;
    if (has(Mistake::top_is_minus_bottom)) camera.top = -camera.bottom;
    if (has(Mistake::axes_dropped)) u = v = w = {};
  }

  Camera camera;
  Vec u, v, w;
};

Frame frame(const Camera& camera) {
  const View view(camera);
  return {out(view.u), out(view.v), out(view.w)};
}

Number position(double low, double high, Number index, Number count, Samples samples) {
  const Number share =
      samples == Samples::centres ? (index + Number(0.5)) / count : index / (count - 1);
  return in(low) + share * (in(high)-in(low));
}

/// P - E, without rounding P.
Vec to_pixel(const View& view, const Conventions& asked, Pixel pixel) {
  const Camera& camera = view.camera;
  const auto width = static_cast<Number>(camera.width);
  const auto height = static_cast<Number>(camera.height);
  auto i = static_cast<Number>(pixel.i);
  auto j = static_cast<Number>(pixel.j);
  if ((asked.rows == Rows::top_first) != has(Mistake::upside_down)) j = height - 1 - j;
  if (has(Mistake::mirrored)) i = width - 1 - i;
  const Number across = has(Mistake::width_height) ? height : width;
  const Number down = has(Mistake::width_height) ? width : height;
  const Number alpha = position(camera.left, camera.right, i, across, asked.samples);
  const Number beta = position(camera.bottom, camera.top, j, down, asked.samples);
  const Number near = has(Mistake::near_negated) ? -in(camera.near_plane) : in(camera.near_plane);
  return near * view.w + alpha * view.u + beta * view.v;
}

Vec direction(Vec eye, Vec point, Vec g) {
  if (has(Mistake::normalize_discarded)) {
    const Vec d = point - eye;
    normalize(d);
    return d;
  }
  if (has(Mistake::eye_plus_point)) return normalize(eye + point);
  const Vec d = normalize(g);
  return has(Mistake::float_directions) ? to_float(d) : d;
}

Vector pixel_point(const Camera& camera, const Conventions& asked, Pixel pixel) {
  return out(in(camera.eye) + to_pixel(View(camera), asked, pixel));
}

Ray pixel_ray(const Camera& camera, const Conventions& asked, Pixel pixel) {
  const Vec g = to_pixel(View(camera), asked, pixel);
  const Vec eye = in(camera.eye), point = eye + g;
  return {out(point), out(direction(eye, point, g))};
}

Ray focal_ray(const Camera& camera, const Conventions& asked, Pixel pixel) {
  const Vec g = to_pixel(View(camera), asked, pixel);
  const Vec eye = in(camera.eye);
  return {camera.eye, out(direction(eye, eye + g, g))};
}

struct Roots {
  Number smaller, larger;
  Number d_sq;  // the square of half the chord, for unit directions
};

/// a s^2 - 2 b s + c = 0; this discriminant does not cancel on far spheres.
std::optional<Roots> roots(const Ray& ray, const Sphere& sphere) {
  const Vec t = in(sphere.centre) - in(ray.origin), d = in(ray.direction);
  const Number r = in(sphere.radius);
  if (has(Mistake::normalize_discarded) || has(Mistake::cancelling)) {
    // The lecture's formula, for unit directions.
    const Number v = dot(t, d), d_sq = r * r - (dot(t, t) - v * v);
    if (d_sq < 0) return {};
    return Roots{v - std::sqrt(d_sq), v + std::sqrt(d_sq), d_sq};
  }
  const Vec moment = cross(t, d);
  const Number a = dot(d, d);
  const Number b = dot(t, d);
  const Number discriminant = a * r * r - dot(moment, moment);
  if (discriminant < 0) return {};
  const Number q = b + std::copysign(std::sqrt(discriminant), b);
  const Number c = (length(t) - r) * (length(t) + r);
  const Number one = q / a;
  const Number other = q == 0 ? 0 : c / q;
  return Roots{std::min(one, other), std::max(one, other), discriminant / a};
}

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions& asked) {
  const auto found = roots(ray, sphere);
  if (!found || (found->d_sq == 0 && asked.tangent == Tangent::miss)) return {};
  if (has(Mistake::centre_behind) && found->smaller + found->larger < 0) return {};
  Number s = found->smaller;
  const bool may_be_larger =
      asked.root == Root::nearest && !has(Mistake::near_root_only) && !has(Mistake::no_test_for_t);
  if ((s < 0 && may_be_larger) || has(Mistake::far_root)) s = found->larger;
  if (s < 0 && !has(Mistake::no_test_for_t)) return {};
  return Hit{s, out(in(ray.origin) + s * in(ray.direction))};
}

std::optional<std::size_t> nearest(const Ray& ray, const std::vector<Sphere>& spheres,
                                   const Conventions& asked) {
  std::optional<std::size_t> best;
  double least = 0;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const auto hit = intersect(ray, spheres[k], asked);
    if (!hit) continue;
    if (has(Mistake::first_sphere_wins)) return k;
    const double key =
        has(Mistake::by_discriminant) ? -roots(ray, spheres[k])->d_sq : hit->parameter;
    if (best && key >= least) continue;
    best = k;
    least = key;
  }
  return best;
}

}  // namespace

RAYCHECK_CANDIDATE(.frame = frame, .pixel_point = pixel_point, .pixel_ray = pixel_ray,
                   .focal_ray = focal_ray, .intersect = intersect, .nearest = nearest,
                   .precision = Precision::PRECISION)
