// A student's rays and spheres in C++, right as it stands. A first line `#define MISTAKE u_flipped`
// makes it wrong in the one way of that name.

#include <algorithm>
#include <cmath>
#include <raycheck/candidate.hpp>

using namespace raycheck;

#ifdef MISTAKE_BY_NAME
#include "by_name.h"
#elif !defined MISTAKE
#define MISTAKE none
#endif

namespace {

#define MISTAKES                                                                              \
  none, width_height, top_from_right, top_is_minus_bottom, u_flipped, u_and_w_flipped,        \
      no_test_for_t, first_sphere_wins, normalize_discarded, by_discriminant, eye_plus_point, \
      axes_dropped, float_directions, near_root_only, far_root, upside_down, mirrored
enum class Mistake { MISTAKES };

#ifdef MISTAKE_BY_NAME
bool has(Mistake mistake) {
  static const auto made = static_cast<Mistake>(PLACE_BY_NAME(MISTAKES));
  return mistake == made;
}
#else
constexpr bool has(Mistake mistake) { return mistake == Mistake::MISTAKE; }
#endif

Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator*(double k, Vector a) { return {k * a.x, k * a.y, k * a.z}; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(Vector a) { return std::hypot(a.x, a.y, a.z); }
Vector normalize(Vector a) {
  const double l = length(a);
  return {a.x / l, a.y / l, a.z / l};
}
Vector to_float(Vector a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

/// A camera and its axes.
struct View {
  explicit View(const Camera& given) : camera(given) {
    w = normalize(camera.eye - camera.look_at);
    if (has(Mistake::u_and_w_flipped)) w = normalize(camera.look_at - camera.eye);
    u = normalize(cross(camera.up, w));
    if (has(Mistake::u_flipped)) u = normalize(cross(w, camera.up));
    // An up vector near W leaves U askew.
    v = normalize(cross(w, u));
    u = cross(v, w);
    if (has(Mistake::top_from_right)) camera.top = camera.right;
    if (has(Mistake::top_is_minus_bottom)) camera.top = -camera.bottom;
  }
  View(const View& other) : camera(other.camera) {
    if (has(Mistake::axes_dropped)) return;
    u = other.u;
    v = other.v;
    w = other.w;
  }

  Camera camera;
  Vector u, v, w;
};

View view_of(const Camera& camera) {
  const View first(camera);
  View copy = first;
  return copy;
}

Frame frame(const Camera& camera) {
  const View view = view_of(camera);
  return {view.u, view.v, view.w};
}

double position(double low, double high, double index, double count, Samples samples) {
  const double share = samples == Samples::centres ? (index + 0.5) / count : index / (count - 1);
  return low + share * (high - low);
}

/// P - E, without the rounding of P.
Vector to_pixel(const View& view, const Conventions& asked, Pixel pixel) {
  const Camera& camera = view.camera;
  const auto width = static_cast<double>(camera.width);
  const auto height = static_cast<double>(camera.height);
  auto i = static_cast<double>(pixel.i);
  auto j = static_cast<double>(pixel.j);
  if ((asked.rows == Rows::top_first) != has(Mistake::upside_down)) j = height - 1 - j;
  if (has(Mistake::mirrored)) i = width - 1 - i;
  const double across = has(Mistake::width_height) ? height : width;
  const double down = has(Mistake::width_height) ? width : height;
  const double alpha = position(camera.left, camera.right, i, across, asked.samples);
  const double beta = position(camera.bottom, camera.top, j, down, asked.samples);
  return camera.near_plane * view.w + alpha * view.u + beta * view.v;
}

Vector direction(Vector eye, Vector point, Vector g) {
  if (has(Mistake::normalize_discarded)) {
    const Vector d = point - eye;
    normalize(d);
    return d;
  }
  if (has(Mistake::eye_plus_point)) return normalize(eye + point);
  const Vector d = normalize(g);
  return has(Mistake::float_directions) ? to_float(d) : d;
}

Vector pixel_point(const Camera& camera, const Conventions& asked, Pixel pixel) {
  return camera.eye + to_pixel(view_of(camera), asked, pixel);
}

Ray pixel_ray(const Camera& camera, const Conventions& asked, Pixel pixel) {
  const Vector g = to_pixel(view_of(camera), asked, pixel);
  const Vector point = camera.eye + g;
  return {point, direction(camera.eye, point, g)};
}

Ray focal_ray(const Camera& camera, const Conventions& asked, Pixel pixel) {
  const Vector g = to_pixel(view_of(camera), asked, pixel);
  return {camera.eye, direction(camera.eye, camera.eye + g, g)};
}

struct Roots {
  double smaller, larger;
  double d_sq;  // the square of half the chord, of unit directions
};

/// The lecture's, of unit directions.
std::optional<Roots> lecture_roots(const Ray& ray, const Sphere& sphere) {
  const Vector t = sphere.centre - ray.origin;
  const double v = dot(t, ray.direction);
  const double d_sq = sphere.radius * sphere.radius - (dot(t, t) - v * v);
  if (d_sq < 0) return {};
  const double d = std::sqrt(d_sq);
  return Roots{v - d, v + d, d_sq};
}

/// a s^2 - 2 b s + c = 0; this discriminant does not cancel on far spheres.
std::optional<Roots> roots(const Ray& ray, const Sphere& sphere) {
  if (has(Mistake::normalize_discarded)) return lecture_roots(ray, sphere);
  const Vector t = sphere.centre - ray.origin;
  const Vector moment = cross(t, ray.direction);
  const double a = dot(ray.direction, ray.direction);
  const double b = dot(t, ray.direction);
  const double r = sphere.radius;
  const double discriminant = a * r * r - dot(moment, moment);
  if (discriminant < 0) return {};
  const double q = b + std::copysign(std::sqrt(discriminant), b);
  const double c = (length(t) - r) * (length(t) + r);
  const double one = q / a;
  const double other = q == 0 ? 0 : c / q;
  return Roots{std::min(one, other), std::max(one, other), discriminant / a};
}

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions& asked) {
  const auto found = roots(ray, sphere);
  if (!found || (found->d_sq == 0 && asked.tangent == Tangent::miss)) return {};
  double s = found->smaller;
  const bool may_be_larger =
      asked.root == Root::nearest && !has(Mistake::near_root_only) && !has(Mistake::no_test_for_t);
  if ((s < 0 && may_be_larger) || has(Mistake::far_root)) s = found->larger;
  if (s < 0 && !has(Mistake::no_test_for_t)) return {};
  return Hit{s, ray.origin + s * ray.direction};
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
                   .focal_ray = focal_ray, .intersect = intersect, .nearest = nearest)
