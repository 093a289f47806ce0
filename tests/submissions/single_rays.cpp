// A student's rays and spheres in C++, all in `float`, right as it stands. A first line
// `#define FORM lecture` takes the lecture's d^2 = r^2 - (|T|^2 - v^2), which cancels.

#include <algorithm>
#include <cmath>
#include <raycheck/candidate.hpp>

using namespace raycheck;

#ifdef MISTAKE_BY_NAME
#include "by_name.h"
#elif !defined FORM
#define FORM careful
#endif

namespace {

enum class Form { careful, lecture };
#ifdef MISTAKE_BY_NAME
const Form kForm = static_cast<Form>(PLACE_BY_NAME(careful, lecture));
#else
constexpr Form kForm = Form::FORM;
#endif

struct Vec {
  float x, y, z;
};

Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(float k, Vec a) { return {k * a.x, k * a.y, k * a.z}; }
float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
float length(Vec a) { return std::sqrt(dot(a, a)); }
Vec normalize(Vec a) { return 1 / length(a) * a; }

float in(double x) { return static_cast<float>(x); }
Vec in(Vector a) { return {in(a.x), in(a.y), in(a.z)}; }
Vector out(Vec a) { return {a.x, a.y, a.z}; }

struct View {
  explicit View(const Camera& given) : camera(given) {
    w = normalize(in(given.eye) - in(given.look_at));
    u = normalize(cross(in(given.up), w));
    v = cross(w, u);
  }
  Camera camera;
  Vec u, v, w;
};

Frame frame(const Camera& camera) {
  const View view(camera);
  return {out(view.u), out(view.v), out(view.w)};
}

float position(double low, double high, float index, float count, Samples samples) {
  const float share = samples == Samples::centres ? (index + 0.5f) / count : index / (count - 1);
  return in(low) + share * (in(high)-in(low));
}

/// P - E
Vec to_pixel(const Camera& camera, const Conventions& asked, Pixel pixel) {
  const View view(camera);
  const float height = static_cast<float>(camera.height);
  float j = static_cast<float>(pixel.j);
  if (asked.rows == Rows::top_first) j = height - 1 - j;
  const float alpha = position(camera.left, camera.right, static_cast<float>(pixel.i),
                               static_cast<float>(camera.width), asked.samples);
  const float beta = position(camera.bottom, camera.top, j, height, asked.samples);
  return in(camera.near_plane) * view.w + alpha * view.u + beta * view.v;
}

Vector pixel_point(const Camera& camera, const Conventions& asked, Pixel pixel) {
  return out(in(camera.eye) + to_pixel(camera, asked, pixel));
}

Ray pixel_ray(const Camera& camera, const Conventions& asked, Pixel pixel) {
  const Vec g = to_pixel(camera, asked, pixel);
  return {out(in(camera.eye) + g), out(normalize(g))};
}

Ray focal_ray(const Camera& camera, const Conventions& asked, Pixel pixel) {
  return {camera.eye, out(normalize(to_pixel(camera, asked, pixel)))};
}

struct Roots {
  float smaller, larger;
};

std::optional<Roots> lecture_roots(Vec t, Vec d, float r) {
  const float v = dot(t, d);
  const float d_sq = r * r - (dot(t, t) - v * v);
  if (d_sq < 0) return {};
  return Roots{v - std::sqrt(d_sq), v + std::sqrt(d_sq)};
}

/// |T x D|^2 does not cancel where d^2 would.
std::optional<Roots> careful_roots(Vec t, Vec d, float r) {
  const Vec moment = cross(t, d);
  const float a = dot(d, d);
  const float b = dot(t, d);
  const float discriminant = a * r * r - dot(moment, moment);
  if (discriminant < 0) return {};
  const float q = b + std::copysign(std::sqrt(discriminant), b);
  const float other = q == 0 ? 0 : (length(t) - r) * (length(t) + r) / q;
  return Roots{std::min(q / a, other), std::max(q / a, other)};
}

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions& asked) {
  const Vec origin = in(ray.origin);
  const Vec d = in(ray.direction);
  const Vec t = in(sphere.centre) - origin;
  const auto roots = kForm == Form::lecture ? lecture_roots(t, d, in(sphere.radius))
                                            : careful_roots(t, d, in(sphere.radius));
  if (!roots || (roots->smaller == roots->larger && asked.tangent == Tangent::miss)) return {};
  float s = roots->smaller;
  if (s < 0 && asked.root == Root::nearest) s = roots->larger;
  if (s < 0) return {};
  return Hit{s, out(origin + s * d)};
}

std::optional<std::size_t> nearest(const Ray& ray, const std::vector<Sphere>& spheres,
                                   const Conventions& asked) {
  std::optional<std::size_t> best;
  double least = 0;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const auto hit = intersect(ray, spheres[k], asked);
    if (!hit || (best && hit->parameter >= least)) continue;
    best = k;
    least = hit->parameter;
  }
  return best;
}

}  // namespace

RAYCHECK_CANDIDATE(.frame = frame, .pixel_point = pixel_point, .pixel_ray = pixel_ray,
                   .focal_ray = focal_ray, .intersect = intersect, .nearest = nearest)
