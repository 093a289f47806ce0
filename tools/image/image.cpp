#include "tools/image/image.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "properties/case.h"
#include "scene/invalid_input.h"
#include "scene/validate.h"
#include "tools/image/image_paint.h"
#include "tools/run/threads.h"

namespace raycheck::tools {
namespace {

using reference::kNoSphere;
using reference::Visibility;

/// A band has about kFewestPixels pixels, so that its fixed cost is relatively small. It has at
/// most kMostPixels pixels, or one row, to limit the memory.
constexpr std::int64_t kFewestPixels = 1 << 16;
constexpr std::int64_t kMostPixels = 1 << 20;

/// The rows of a camera's image in bands, from the top of the picture to the bottom.
class Bands {
 public:
  Bands(const scene::Camera& camera, const scene::Conventions& conventions)
      : height_(camera.height), top_first_(conventions.rows == scene::Rows::kTopFirst) {
    constexpr std::int64_t kRows = Visibility::kBandRows;
    rows_ = kRows * std::max<std::int64_t>(1, kFewestPixels / (kRows * camera.width));
    rows_ = std::min(rows_, std::max<std::int64_t>(1, kMostPixels / camera.width));
  }

  std::int64_t count() const { return (height_ + rows_ - 1) / rows_; }
  /// Rows j of the picture's band k.
  std::pair<std::int64_t, std::int64_t> operator[](std::int64_t k) const {
    const std::int64_t j_begin = (top_first_ ? k : count() - 1 - k) * rows_;
    return {j_begin, std::min(height_, j_begin + rows_)};
  }
  bool top_first() const { return top_first_; }

 private:
  std::int64_t height_;
  std::int64_t rows_;
  bool top_first_;
};

SeenBand seen_band(const Visibility& visibility, std::int64_t width,
                   const std::pair<std::int64_t, std::int64_t>& rows, bool points) {
  SeenBand band;
  std::tie(band.j_begin, band.j_end) = rows;
  const auto pixels = static_cast<std::size_t>((band.j_end - band.j_begin) * width);
  band.sphere.resize(pixels);
  if (points) {
    for (auto* coordinate : {&band.x, &band.y, &band.z}) coordinate->resize(pixels);
  }
  band.decided_by =
      visibility.nearest(band.j_begin, band.j_end, {band.sphere, {}, band.x, band.y, band.z});
  return band;
}

/// A band of the picture, from its top line on, and its counts.
struct PaintedBand {
  std::vector<Colour> pixels;
  std::vector<std::int32_t> spheres;  ///< The spheres seen, each once.
  std::uint64_t pixels_that_see = 0;
  reference::DecidedBy decided_by;
  ErrorCounts errors;
};

PaintedBand painted(const SeenBand& band, const Painter& painter, std::int64_t width,
                    bool top_first) {
  PaintedBand result;
  result.pixels.resize(band.sphere.size());
  painter(band, result.pixels, result.errors);
  if (!top_first) flip_lines(result.pixels, width);
  for (const std::int32_t sphere : band.sphere) {
    if (sphere == kNoSphere) continue;
    ++result.pixels_that_see;
    if (result.spheres.empty() || result.spheres.back() != sphere) result.spheres.push_back(sphere);
  }
  std::ranges::sort(result.spheres);
  result.spheres.erase(std::unique(result.spheres.begin(), result.spheres.end()),
                       result.spheres.end());
  result.decided_by = band.decided_by;
  return result;
}

void count(const PaintedBand& band, std::vector<bool>& seen, ImageReport& report) {
  for (const std::int32_t sphere : band.spheres) {
    auto is_seen = seen[static_cast<std::size_t>(sphere)];
    report.spheres_seen += is_seen ? 0 : 1;
    is_seen = true;
  }
  report.pixels_that_see += band.pixels_that_see;
  report.decided_by += band.decided_by;
  if (!report.error) return;
  for (std::size_t k = 0; k < band.errors.pixels.size(); ++k) {
    report.error->pixels[k] += band.errors.pixels[k];
  }
  for (std::size_t k = 0; k < band.errors.wrong.size(); ++k) {
    report.error->wrong[k] += band.errors.wrong[k];
  }
  if (report.error->failed == 0) report.error->first_failure = band.errors.first_failure;
  report.error->failed += band.errors.failed;
}

/// For each ray, the sphere with the least s among its hits; of equal ones, the first.
std::vector<std::optional<std::size_t>> nearest_of(const std::vector<properties::SphereHits>& hits,
                                                   std::size_t rays) {
  std::vector<std::optional<std::size_t>> nearest(rays);
  std::vector<double> least(rays);
  for (std::size_t sphere = 0; sphere < hits.size(); ++sphere) {
    for (const properties::RayHit& hit : hits[sphere]) {
      std::optional<std::size_t>& known = nearest.at(hit.ray);
      if (known && least[hit.ray] <= hit.hit.parameter) continue;
      known = sphere;
      least[hit.ray] = hit.hit.parameter;
    }
  }
  return nearest;
}

using MakeRays = decltype(properties::Functions::pixel_rays);

MakeRays rounded(const MakeRays& make, scene::Precision precision) {
  if (!make || precision == scene::Precision::kDouble) return make;
  return [make, precision](const scene::Camera& camera, const scene::Conventions& conventions,
                           properties::Functions::Pixels pixels) {
    std::vector<scene::Ray> rays = make(camera, conventions, pixels);
    for (scene::Ray& ray : rays) ray = properties::rounded_ray(ray, precision);
    return rays;
  };
}

properties::Candidate completed(const Implementation& implementation, const MethodPair& methods) {
  properties::Candidate candidate = implementation.make();
  if (!candidate.intersect) {
    throw std::invalid_argument(implementation.name +
                                ": has no function intersect(), so there is no error of s");
  }
  const properties::Candidate own = candidate_of(methods);
  if (!candidate.pixel_rays && !candidate.focal_rays) {
    candidate.pixel_rays = rounded(own.pixel_rays, candidate.precision);
    candidate.focal_rays = rounded(own.focal_rays, candidate.precision);
  }
  // If the candidate makes rays from only one origin, these are used.
  if (!candidate.pixel_rays) candidate.declared.origin = scene::Origin::kFocal;
  if (!candidate.focal_rays) candidate.declared.origin = scene::Origin::kPixel;
  if (!candidate.nearest) {
    candidate.nearest = [intersect = candidate.intersect](properties::Candidate::Rays rays,
                                                          properties::Candidate::Spheres spheres,
                                                          const scene::Conventions& conventions) {
      return nearest_of(intersect(rays, spheres, conventions), rays.size());
    };
  }
  return candidate;
}

void resize(const scene::Pixel& size, scene::Scene& scene) {
  scene.camera->width = size.i;
  scene.camera->height = size.j;
  const auto problems = scene::defects(scene);
  if (!problems.empty()) {
    throw scene::InvalidInput(
        "size", fmt::format("{},{}", size.i, size.j),
        problems.front().field + " = " + problems.front().value + ": " + problems.front().what);
  }
}

/// Rounds the scene to the format of the candidate whose error is shown; returns the count of
/// changed numbers.
std::size_t round_for(const ImageOptions& options, scene::Scene& scene) {
  if (options.what != Picture::kError) return 0;
  properties::RoundedCase rounded =
      properties::rounded_scene(scene, options.implementation.input_format());
  if (!rounded.the_case) throw std::invalid_argument(options.path + ": " + rounded.reason);
  scene = std::move(rounded.the_case->scene);
  return rounded.changed;
}

void require_picture(const std::string& path, const scene::Camera& camera) {
  for (const auto& [side, pixels] :
       {std::pair("width", camera.width), std::pair("height", camera.height)}) {
    if (pixels <= kMostPictureSide) continue;
    throw std::invalid_argument(
        fmt::format("{}: camera.{} = {}: exceeds the limit of {} pixels for a picture; choose a "
                    "smaller size",
                    path, side, pixels, kMostPictureSide));
  }
}

ImageReport report_on(const ImageOptions& options, const scene::LoadedScene& loaded,
                      const PictureFile& file) {
  const scene::Scene& scene = loaded.scene;
  if (!scene.camera) {
    throw std::invalid_argument(options.path +
                                ": has given rays and no camera, so it has no picture; judge the "
                                "rays with `raycheck check`");
  }
  ImageReport report;
  report.path = options.path;
  report.file = file.path();
  report.what = options.what;
  report.warnings = loaded.warnings;
  report.format = loaded.format;
  report.not_needed = loaded.not_needed;
  report.conventions = scene.conventions;
  report.width = scene.camera->width;
  report.height = scene.camera->height;
  report.spheres = scene.spheres.size();
  if (options.what == Picture::kError) {
    const properties::Candidate candidate =
        answering_candidate(options.implementation, options.methods)();
    report.conventions = candidate.declared.over(scene.conventions);
    report.error.emplace();
    report.error->candidate = candidate.name;
    report.error->implementation = options.implementation;
    report.error->precision = candidate.precision;
    report.error->pixels.resize(kErrorSteps.size());
  }
  return report;
}

}  // namespace

std::function<properties::Candidate()> answering_candidate(const Implementation& implementation,
                                                           const MethodPair& methods) {
  return [implementation, methods] { return completed(implementation, methods); };
}

ImageReport make_image(const ImageOptions& options, PictureFile& file,
                       const properties::RunControl& control) {
  const auto start = std::chrono::steady_clock::now();
  scene::LoadedScene loaded = scene::load_scene(options.path, options.read_as);
  if (options.size && loaded.scene.camera) resize(*options.size, loaded.scene);
  const std::size_t changed = round_for(options, loaded.scene);
  ImageReport report = report_on(options, loaded, file);
  if (report.error) report.error->rounded_numbers = changed;
  report.threads = control.threads;
  require_picture(options.path, *loaded.scene.camera);
  file.start(report.width, report.height);
  scene::ScenePlan plan = scene::plan_scene(loaded.scene, report.conventions,
                                            scene::Wanted::kNearest, {}, for_each_on(control));
  const Visibility visibility(std::move(loaded.scene), std::move(plan));
  const scene::Scene& scene = visibility.scene();
  const Bands bands(*scene.camera, report.conventions);
  const bool is_of_spheres = options.what == Picture::kSphere;
  const Painter painter =
      is_of_spheres
          ? sphere_painter(scene)
          : error_painter(scene, answering_candidate(options.implementation, options.methods));
  std::vector<bool> seen(scene.spheres.size());
  std::int64_t done = 0;
  in_order<PaintedBand>(
      bands.count(), control,
      [&](std::int64_t k) {
        return painted(seen_band(visibility, report.width, bands[k], is_of_spheres), painter,
                       report.width, bands.top_first());
      },
      [&](const PaintedBand& band) {
        file.add(band.pixels);
        count(band, seen, report);
        control.progress(fmt::format("{} of {} bands", ++done, bands.count()));
      });
  report.interrupted = done < bands.count();
  if (!report.interrupted) file.place();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace raycheck::tools
