// A tracer that computes in float throughout, as one for a GPU does, and is careful: the
// discriminant from the rest of T beside the ray, roots without cancellation.

#include <cmath>
#include <raycheck/candidate.hpp>
#include <utility>

namespace {

struct float3 {
  float x = 0, y = 0, z = 0;
};

float3 to_float3(const raycheck::Vector& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
raycheck::Vector from_float3(const float3& v) { return {v.x, v.y, v.z}; }

float3 operator+(const float3& a, const float3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
float3 operator-(const float3& a, const float3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
float3 operator*(const float3& a, float s) { return {a.x * s, a.y * s, a.z * s}; }
float3 operator/(const float3& a, float s) { return {a.x / s, a.y / s, a.z / s}; }
float dot(const float3& a, const float3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
float3 cross(const float3& a, const float3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
float norm(const float3& a) { return std::sqrt(dot(a, a)); }
float3 normalize(const float3& a) { return a / norm(a); }

struct Lens {
  float3 eye, right, up, back;
  float near_plane, left, right_end, bottom, top, columns, rows;

  explicit Lens(const raycheck::Camera& c)
      : eye(to_float3(c.eye)),
        near_plane(static_cast<float>(c.near_plane)),
        left(static_cast<float>(c.left)),
        right_end(static_cast<float>(c.right)),
        bottom(static_cast<float>(c.bottom)),
        top(static_cast<float>(c.top)),
        columns(static_cast<float>(c.width)),
        rows(static_cast<float>(c.height)) {
    back = normalize(eye - to_float3(c.look_at));
    right = normalize(cross(to_float3(c.up), back));
    up = cross(back, right);
  }

  /// From the eye to the pixel.
  float3 arrow(const raycheck::Conventions& by, raycheck::Pixel pixel) const {
    const bool centres = by.samples == raycheck::Samples::centres;
    const auto share = [&](std::int64_t k, float count) {
      const auto index = static_cast<float>(k);
      return centres ? (index + 0.5F) / count : index / (count - 1);
    };
    const float across = share(pixel.i, columns), down = share(pixel.j, rows);
    const bool flipped = by.rows == raycheck::Rows::top_first;
    const float first = flipped ? top : bottom, last = flipped ? bottom : top;
    return back * near_plane + right * (left + across * (right_end - left)) +
           up * (first + down * (last - first));
  }
};

raycheck::Frame axes(const raycheck::Camera& camera) {
  const Lens lens(camera);
  return {from_float3(lens.right), from_float3(lens.up), from_float3(lens.back)};
}

raycheck::Vector point(const raycheck::Camera& camera, const raycheck::Conventions& by,
                       raycheck::Pixel pixel) {
  const Lens lens(camera);
  return from_float3(lens.eye + lens.arrow(by, pixel));
}

raycheck::Ray from_pixel(const raycheck::Camera& camera, const raycheck::Conventions& by,
                         raycheck::Pixel pixel) {
  const Lens lens(camera);
  const float3 arrow = lens.arrow(by, pixel);
  return {from_float3(lens.eye + arrow), from_float3(normalize(arrow))};
}

raycheck::Ray from_eye(const raycheck::Camera& camera, const raycheck::Conventions& by,
                       raycheck::Pixel pixel) {
  return {camera.eye, from_float3(normalize(Lens(camera).arrow(by, pixel)))};
}

std::optional<raycheck::Hit> hit(const raycheck::Ray& ray, const raycheck::Sphere& sphere,
                                 const raycheck::Conventions& by) {
  const float3 start = to_float3(ray.origin), along = to_float3(ray.direction);
  const float3 to_centre = to_float3(sphere.centre) - start;
  const auto radius = static_cast<float>(sphere.radius);
  const float size_sq = dot(along, along), ahead = dot(to_centre, along);
  const float3 beside = cross(to_centre, along);
  const float inside = radius * radius * size_sq - dot(beside, beside);
  if (inside < 0 || (inside == 0 && by.tangent == raycheck::Tangent::miss)) return std::nullopt;
  const float sum = ahead + std::copysign(std::sqrt(inside), ahead);
  const float distance = norm(to_centre);
  const float power = (distance - radius) * (distance + radius);
  float first = sum / size_sq, second = sum == 0 ? 0 : power / sum;
  if (second < first) std::swap(first, second);
  const float s = first >= 0 || by.root == raycheck::Root::smaller ? first : second;
  if (s < 0) return std::nullopt;
  return raycheck::Hit{s, from_float3(start + along * s)};
}

std::optional<std::size_t> first_hit(const raycheck::Ray& ray,
                                     const std::vector<raycheck::Sphere>& spheres,
                                     const raycheck::Conventions& by) {
  std::optional<std::size_t> best;
  double least = 0;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const auto at = hit(ray, spheres[k], by);
    if (at && (!best || at->parameter < least)) {
      best = k;
      least = at->parameter;
    }
  }
  return best;
}

}  // namespace

RAYCHECK_CANDIDATE(.name = "float-tracer", .frame = axes, .pixel_point = point,
                   .pixel_ray = from_pixel, .focal_ray = from_eye, .intersect = hit,
                   .nearest = first_hit, .precision = raycheck::Precision::single)
