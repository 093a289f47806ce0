#include "properties/laws/plan_claims.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace raycheck::properties {
namespace {

using scene::Bounds;
using scene::Pixel;
using scene::PixelRectangle;
using scene::SpherePlan;

/// Whole numbers of [begin, end), evenly spread, the first and the last among them.
std::vector<std::int64_t> spread(std::int64_t begin, std::int64_t end, std::int64_t most) {
  std::vector<std::int64_t> result;
  const std::int64_t count = std::min(end - begin, most);
  for (std::int64_t k = 0; k < count; ++k) {
    result.push_back(count == 1 ? begin : begin + (end - 1 - begin) * k / (count - 1));
  }
  return result;
}

void add_if_inside(const PixelRectangle& where, const Pixel& pixel, std::vector<Pixel>& pixels) {
  if (where.contains(pixel)) pixels.push_back(pixel);
}

double middle(const Bounds& x) { return x.low + (x.high - x.low) / 2; }

/// The pixel in or next to the image that a direction through the eye points at.
void add_pointed_at(const scene::EyeSpace& eye, const PixelRectangle& image,
                    const scene::Vector3& along, std::vector<Pixel>& pixels) {
  if (!(along.z > 0)) return;
  const double scale = std::abs(middle(eye.near())) / along.z;
  const double i = middle(eye.column(Bounds::exactly(along.x * scale)));
  const double j = middle(eye.row(Bounds::exactly(along.y * scale)));
  if (!(i > -2 && i < static_cast<double>(image.i_end) + 1)) return;
  if (!(j > -2 && j < static_cast<double>(image.j_end) + 1)) return;
  pixels.push_back(
      {static_cast<std::int64_t>(std::round(i)), static_cast<std::int64_t>(std::round(j))});
}

/// Roughly where a silhouette has its least and largest column and row. In the plane (U, W) the
/// tangents from the eye touch the disc of centre (u, z) and radius r at (u q -+ z r, z q +- u r)
/// q/rho^2, where rho^2 = u^2 + z^2 and q^2 = rho^2 - r^2; along V, the sphere is touched level
/// with its centre. Likewise in (V, W).
std::vector<Pixel> touched(const PlanStatement& statement, const PixelRectangle& image) {
  const scene::EyeSphere& seen = statement.said().seen;
  const scene::EyeSpace& eye = statement.plan->eye;
  const double u = middle(seen.u), v = middle(seen.v), r = middle(seen.radius);
  const double z = middle(eye.near()) < 0 ? -middle(seen.w) : middle(seen.w);
  const double across_sq = u * u + z * z, along_sq = v * v + z * z;
  const double across = std::sqrt(across_sq - r * r), along = std::sqrt(along_sq - r * r);
  std::vector<Pixel> result;
  for (const double side : {-r, r}) {
    add_pointed_at(eye, image,
                   {(u * across + z * side) * across / across_sq, v,
                    (z * across - u * side) * across / across_sq},
                   result);
    add_pointed_at(
        eye, image,
        {u, (v * along + z * side) * along / along_sq, (z * along - v * side) * along / along_sq},
        result);
  }
  return result;
}

bool is_said(const SpherePlan& a, const SpherePlan& b) {
  return a.left_out == b.left_out && a.hidden_by == b.hidden_by && a.pixels == b.pixels &&
         a.origin_inside == b.origin_inside && a.reaches_behind == b.reaches_behind;
}

}  // namespace

PlanStatements::PlanStatements(const Trial& trial)
    : pixels_(trial.pixels()), camera_(*trial.scene().camera) {
  for (const scene::Wanted wanted : kEveryWanted) {
    plans_.push_back(trial.candidate().plan(trial.scene(), trial.conventions(), wanted));
    if (plans_.back().spheres.size() != trial.scene().spheres.size()) {
      throw std::runtime_error("the plan speaks of " +
                               std::to_string(plans_.back().spheres.size()) + " spheres of " +
                               std::to_string(trial.scene().spheres.size()));
    }
  }
}

std::vector<PlanStatement> PlanStatements::of(std::size_t sphere) const {
  std::vector<PlanStatement> result;
  for (std::size_t k = 0; k < plans_.size(); ++k) {
    const PlanStatement next{kEveryWanted[k], &plans_[k], sphere};
    if (std::none_of(result.begin(), result.end(), [&](const PlanStatement& statement) {
          return is_said(statement.said(), next.said());
        })) {
      result.push_back(next);
    }
  }
  return result;
}

std::vector<Pixel> PlanStatements::inside(const PlanStatement& statement) const {
  PixelRectangle where = image();
  for (const scene::ScenePlan& plan : plans_) {
    const PixelRectangle& pixels = plan.spheres[statement.sphere].pixels;
    if (!pixels.empty() && image().contains(pixels)) where = pixels;
  }
  std::vector<Pixel> result = pixels_;
  for (const std::int64_t j : spread(where.j_begin, where.j_end, kMostInside)) {
    for (const std::int64_t i : spread(where.i_begin, where.i_end, kMostInside)) {
      result.push_back({i, j});
    }
  }
  for (const Pixel& pixel : touched(statement, image())) {
    for (const std::int64_t j : {pixel.j - 1, pixel.j, pixel.j + 1}) {
      for (const std::int64_t i : {pixel.i - 1, pixel.i, pixel.i + 1}) {
        add_if_inside(where, {i, j}, result);
      }
    }
  }
  return result;
}

std::vector<Pixel> PlanStatements::outside(const PlanStatement& statement) const {
  const PixelRectangle& inner = statement.said().pixels;
  if (inner.empty()) return inside(statement);
  std::vector<Pixel> result;
  for (const Pixel& pixel : pixels_) {
    if (!inner.contains(pixel)) result.push_back(pixel);
  }
  std::vector<std::int64_t> columns = spread(inner.i_begin - 1, inner.i_end + 1, kMostOfBorder);
  std::vector<std::int64_t> rows = spread(inner.j_begin - 1, inner.j_end + 1, kMostOfBorder);
  for (const Pixel& pixel : touched(statement, image())) {
    for (const int step : {-1, 0, 1}) {
      columns.push_back(std::clamp(pixel.i + step, inner.i_begin - 1, inner.i_end));
      rows.push_back(std::clamp(pixel.j + step, inner.j_begin - 1, inner.j_end));
    }
  }
  for (const std::int64_t i : columns) {
    add_if_inside(image(), {i, inner.j_begin - 1}, result);
    add_if_inside(image(), {i, inner.j_end}, result);
  }
  for (const std::int64_t j : rows) {
    add_if_inside(image(), {inner.i_begin - 1, j}, result);
    add_if_inside(image(), {inner.i_end, j}, result);
  }
  return result;
}

}  // namespace raycheck::properties
