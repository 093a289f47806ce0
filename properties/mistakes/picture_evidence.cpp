#include "properties/mistakes/picture_evidence.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "properties/case.h"
#include "properties/failures.h"
#include "properties/mistakes/picture_causes.h"
#include "properties/mistakes/shown_picture.h"
#include "properties/sphere_choice.h"
#include "reference/visibility/visibility.h"
#include "scene/plan/plan.h"

namespace raycheck::properties {

ImageAnswer exact_image(const Scene& scene, const Conventions& conventions) {
  const reference::Visibility visibility(
      scene, scene::plan_scene(scene, conventions, scene::Wanted::kNearest));
  const Camera& camera = *scene.camera;
  std::vector<std::int32_t> spheres(static_cast<std::size_t>(camera.width * camera.height));
  visibility.nearest(0, camera.height, {spheres, {}, {}, {}, {}});
  ImageAnswer image(spheres.size());
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    if (spheres[k] != reference::kNoSphere) image[k] = static_cast<std::size_t>(spheres[k]);
  }
  return image;
}

std::optional<ShownPicture> shown_picture(Scene scene, const Candidate& candidate) {
  ShownPicture shown = {std::move(scene), {}};
  shown.depth = candidate.depth;
  const Camera& camera = *shown.scene.camera;
  shown.scene.conventions = candidate.declared.over(shown.scene.conventions);
  try {
    shown.image = candidate.image(shown.scene, shown.scene.conventions);
    if (candidate.depths) shown.depths = candidate.depths(shown.scene, shown.scene.conventions);
  } catch (const OtherSize& other) {
    shown.sides_exchanged = other.width == camera.height && other.height == camera.width;
    if (!shown.sides_exchanged) return {};
  } catch (const NoAnswer&) {
    return {};
  }
  return shown;
}

namespace {

/// The number of wrong pixels, and of right pixels, in the first sample.
constexpr std::size_t kSampled = 24;
constexpr std::size_t kSampleParts = 3;

/// The number of pixels in one call.
constexpr std::size_t kPixelsAtATime = std::size_t{1} << 8;
/// The number of pixels of a picture that are compared to find the mistakes that show in it.
constexpr std::size_t kSomePixels = std::size_t{1} << 12;

bool shows_nothing(const ImageAnswer& image) {
  return std::none_of(image.begin(), image.end(), [](const auto& sphere) { return bool(sphere); });
}

/// At most `most` of the pixels, spread evenly.
std::vector<Pixel> some_of(const std::vector<Pixel>& pixels, std::size_t most) {
  std::vector<Pixel> some;
  const std::size_t count = std::min(pixels.size(), most);
  for (std::size_t k = 0; k < count; ++k) {
    some.push_back(pixels[(2 * k + 1) * pixels.size() / (2 * count)]);
  }
  return some;
}

/// Deals these pixels out, in turn, to kSampleParts parts.
void add_parts(const std::vector<Pixel>& pixels, std::vector<std::vector<Pixel>>& parts) {
  for (std::size_t first = 0; first < std::min(kSampleParts, pixels.size()); ++first) {
    std::vector<Pixel>& part = parts.emplace_back();
    for (std::size_t k = first; k < pixels.size(); k += kSampleParts) part.push_back(pixels[k]);
  }
}

/// For each sphere, whether an image shows it somewhere; kSomeSphere and kUnclear count as the
/// sphere expected at that pixel.
std::vector<bool> shown_of(std::size_t spheres, const ImageAnswer& image,
                           const ImageAnswer& expected) {
  std::vector<bool> shown(spheres);
  for (std::size_t k = 0; k < image.size(); ++k) {
    const bool is_known = image[k] != kSomeSphere && image[k] != kUnclear;
    const auto& sphere = is_known ? image[k] : expected[k];
    if (sphere && *sphere < spheres) shown[*sphere] = true;
  }
  return shown;
}

}  // namespace

bool is_as(const std::optional<std::size_t>& shown, const std::optional<std::size_t>& expected) {
  return shown == expected || shown == kUnclear || (shown == kSomeSphere && expected);
}

std::uint64_t count_otherwise(const ImageAnswer& image, const ImageAnswer& expected) {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < image.size(); ++k) count += is_as(image[k], expected[k]) ? 0 : 1;
  return count;
}

std::uint64_t count_otherwise(const Pictures& pictures, const Fault& fault) {
  std::uint64_t count = 0;
  for (const Evidence& one : pictures) {
    const ShownPicture& shown = one.picture();
    count += count_otherwise(shown.image, predicted(fault, shown.scene));
  }
  return count;
}

bool Evidence::may_be_elsewhere_in_pixels() const {
  const Scene& scene = picture_->scene;
  // Otherwise nothing is refuted.
  if (!scene.conventions.valid.is_usual()) return false;
  const reference::ExactCamera camera(*scene.camera, scene.conventions);
  for (std::size_t k = 0; k < pixels_.size(); ++k) {
    const auto& shown = picture_->image[k];
    if (!is_as(shown, truth_[k]) &&
        !may_be_elsewhere_in_pixel(reference::ExactRay(camera, pixels_[k]), scene.spheres,
                                   scene.conventions, shown, kExcusedImageChange)) {
      return false;
    }
  }
  return true;
}

Evidence::Evidence(const ShownPicture& picture)
    : picture_(&picture),
      truth_(exact_image(picture.scene, picture.scene.conventions)),
      pixels_(all_pixels(*picture.scene.camera)),
      is_black_(shows_nothing(picture.image) && has_something_to_see()) {
  std::vector<Pixel> wrong, right;
  for (std::size_t k = 0; k < pixels_.size(); ++k) {
    (is_as(picture.image[k], truth_[k]) ? right : wrong).push_back(pixels_[k]);
  }
  all_errors_ = wrong.size();
  errors_ = count_otherwise(FaultyView({}, picture.scene), wrong, true);
  add_parts(some_of(wrong, kSampled), sample_);
  add_parts(some_of(right, kSampled), sample_);
}

bool Evidence::has_something_to_see() const { return !shows_nothing(truth_); }

bool Evidence::is_uniform() const {
  const ImageAnswer& image = picture_->image;
  return image.front() &&
         std::adjacent_find(image.begin(), image.end(), std::not_equal_to<>()) == image.end();
}

bool Evidence::has_background() const {
  const ImageAnswer& image = picture_->image;
  const bool has_black = std::find(image.begin(), image.end(), std::nullopt) != image.end();
  const auto unidentified = std::count(image.begin(), image.end(), std::optional(kSomeSphere));
  const bool is_most = 2 * static_cast<std::size_t>(unidentified) > image.size();
  return !has_black && (is_most || all_errors_ == 0);
}

const std::optional<std::size_t>& Evidence::at(const Pixel& pixel) const {
  return picture_
      ->image[static_cast<std::size_t>(pixel.j * picture_->scene.camera->width + pixel.i)];
}

std::uint64_t Evidence::count_otherwise(const FaultyView& view, const std::vector<Pixel>& pixels,
                                        bool excusing) const {
  std::vector<Pixel> otherwise = pixels;
  for (const double growth : {0.0, kExcusedImageChange, -kExcusedImageChange}) {
    const ImageAnswer seen = view.seen(otherwise, growth);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (!is_as(at(otherwise[k]), seen[k])) otherwise[kept++] = otherwise[k];
    }
    otherwise.resize(kept);
    if (!excusing || otherwise.empty()) break;
  }
  return otherwise.size();
}

std::vector<Pixel> Evidence::some_pixels() const { return some_of(pixels_, kSomePixels); }

std::uint64_t Evidence::left_of(const std::vector<Pixel>& part, const FaultyView& view) const {
  return count_otherwise(view, part, false);
}

void Evidence::tally(const FaultyView& view, Arithmetic arithmetic, DoubtTally& all) const {
  const ImageAnswer made = view.seen(pixels_);
  const auto rays = view.rays(pixels_);
  const Scene& taken = view.taken();
  std::vector<PossibleSight> sights(pixels_.size());
  for (std::size_t k = 0; k < pixels_.size(); ++k) {
    if (!rays[k]) continue;
    sights[k] =
        possible_sight(arithmetic, *rays[k], taken.spheres, taken.conventions, picture_->image[k]);
  }
  const auto doubtful = static_cast<std::size_t>(std::count_if(
      sights.begin(), sights.end(), [](const PossibleSight& one) { return one.is_doubtful; }));
  // If most pixels were in doubt, excuses would make any picture right.
  const std::vector<bool> shown = shown_of(taken.spheres.size(), picture_->image, made);
  const bool excuses = 2 * doubtful <= pixels_.size();
  for (std::size_t k = 0; k < pixels_.size(); ++k) {
    const PossibleSight& sight = sights[k];
    const bool is_wrong =
        !is_as(picture_->image[k], made[k]) &&
        ((sight.allows && !excuses) || count_otherwise(view, {pixels_[k]}, true) > 0);
    const bool is_dropped = !picture_->image[k] && made[k] && !shown[*made[k]];
    all.add(is_wrong, is_dropped, sight.allows, sight.is_doubtful, sight.radii);
  }
}

std::optional<std::uint64_t> Evidence::left(const FaultyView& view, std::uint64_t most) const {
  // A fault that explains less than half of a picture is not its cause, and a right picture
  // contradicts a fault.
  most = std::min(most, std::max<std::uint64_t>(1, errors_ / 2));
  std::uint64_t count = 0;
  for (std::size_t first = 0; first < pixels_.size(); first += kPixelsAtATime) {
    const std::size_t last = std::min(pixels_.size(), first + kPixelsAtATime);
    const auto begin = pixels_.begin();
    count += count_otherwise(
        view,
        {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last)},
        true);
    if (count > most || (is_black_ && count > 1)) return {};
  }
  return count;
}

}  // namespace raycheck::properties
