#pragma once

// The literal formulas of docs/problem.md, in numbers of sufficient precision.

#include "scene/camera.h"
#include "scene/conventions.h"
#include "scene/geometry.h"
#include "tests/reference/big_float.h"

namespace raycheck::reference {

/// U, V, W; P and D of one pixel; l, alpha and beta.
struct LectureRay {
  Big3 U, V, W, P, D;
  Big length, alpha, beta;
};

inline Big lecture_coordinate(double first, double last, std::int64_t index, std::int64_t count,
                              scene::Samples samples) {
  const Big part = samples == scene::Samples::kEdges ? Big(Big(index) / Big(count - 1))
                   : samples == scene::Samples::kCentres
                       ? Big((Big(index) + Big(1) / 2) / Big(count))
                       : Big(Big(index) / Big(count));
  return Big(first) + part * (Big(last) - Big(first));
}

inline LectureRay lecture_ray(const scene::Camera& camera, const scene::Conventions& conventions,
                              const scene::Pixel& pixel) {
  const Big3 E = big(camera.eye);
  LectureRay ray;
  ray.W = (E - big(camera.look_at)) / norm(E - big(camera.look_at));
  const Big3 u = cross(big(camera.up), ray.W);
  ray.U = u / norm(u);
  ray.V = cross(ray.W, ray.U);
  const auto samples = conventions.samples;
  ray.alpha = lecture_coordinate(camera.left, camera.right, pixel.i, camera.width, samples);
  ray.beta = conventions.rows == scene::Rows::kBottomFirst
                 ? lecture_coordinate(camera.bottom, camera.top, pixel.j, camera.height, samples)
                 : lecture_coordinate(camera.top, camera.bottom, pixel.j, camera.height, samples);
  ray.P = E + Big(camera.near) * ray.W + ray.alpha * ray.U + ray.beta * ray.V;
  ray.length = norm(ray.P - E);
  ray.D = (ray.P - E) / ray.length;
  return ray;
}

/// v, d^2, and the hits at both roots, for a unit direction.
struct LectureHit {
  Big v, d_sq;
  Big smaller() const { return v - sqrt(d_sq); }
  Big larger() const { return v + sqrt(d_sq); }
};

inline LectureHit lecture_hit(const Big3& L, const Big3& D, const scene::Sphere& sphere) {
  const Big3 T = big(sphere.centre) - L;
  const Big r(sphere.radius);
  LectureHit hit;
  hit.v = dot(T, D);
  hit.d_sq = r * r - (dot(T, T) - hit.v * hit.v);
  return hit;
}

}  // namespace raycheck::reference
