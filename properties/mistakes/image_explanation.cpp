#include "properties/mistakes/image_explanation.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "properties/mistakes/mistakes.h"
#include "properties/trial.h"
#include "reference/visibility/visibility.h"
#include "scene/plan/plan.h"
#include "scene/validate.h"

namespace raycheck::properties {

ImageAnswer exact_image(const scene::Scene& scene, const scene::Conventions& conventions) {
  const reference::Visibility visibility(
      scene, scene::plan_scene(scene, conventions, scene::Wanted::kNearest));
  const scene::Camera& camera = *scene.camera;
  std::vector<std::int32_t> spheres(static_cast<std::size_t>(camera.width * camera.height));
  visibility.nearest(0, camera.height, {spheres, {}, {}, {}, {}});
  ImageAnswer image(spheres.size());
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    if (spheres[k] != reference::kNoSphere) image[k] = static_cast<std::size_t>(spheres[k]);
  }
  return image;
}

bool shows_nothing(const ImageAnswer& image) {
  return std::none_of(image.begin(), image.end(), [](const auto& sphere) { return bool(sphere); });
}

namespace {

using scene::Camera;
using scene::Conventions;
using scene::Pixel;
using scene::Scene;

/// The image whose pixels are other ones'.
ImageAnswer rearranged(const ImageAnswer& image, const Camera& camera, const ChangePixel& source) {
  ImageAnswer result;
  result.reserve(image.size());
  for (const Pixel& pixel : all_pixels(camera)) {
    const auto [i, j] = source(camera, pixel);
    result.push_back(image[static_cast<std::size_t>(j * camera.width + i)]);
  }
  return result;
}

/// Whether a mistake is a right answer to another question about the same number of pixels.
bool is_exact(const Mistake& mistake, const Camera& camera) {
  if (!mistake.pixel) return mistake.camera || mistake.conventions;
  const auto [i, j] = mistake.pixel(camera, {camera.width - 1, camera.height - 1});
  return i < camera.width && j < camera.height;
}

/// The whole image as a right formula makes it of what the mistake takes for the question, exactly;
/// empty where that is no question, or the one that was asked.
std::optional<ImageAnswer> exactly(const Mistake& mistake, const Scene& asked,
                                   const ImageAnswer& truth) {
  if (mistake.pixel) return rearranged(truth, *asked.camera, mistake.pixel);
  const Scene other = mistaken(mistake, asked, asked.conventions);
  if (other == asked || !scene::defects(other).empty()) return {};
  return exact_image(other, other.conventions);
}

bool is_right(const std::optional<std::size_t>& answer, const std::optional<std::size_t>& truth) {
  return answer == truth || (answer == kSomeSphere && truth);
}

std::uint64_t errors(const ImageAnswer& image, const ImageAnswer& truth) {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < image.size(); ++k) count += is_right(image[k], truth[k]) ? 0 : 1;
  return count;
}

/// So many pixels are asked about at a time, and first of an image, evenly over it.
constexpr std::size_t kPixelsAtATime = std::size_t{1} << 14;

/// Errors among every step-th pixel as a candidate that is asked ray by ray sees them.
std::uint64_t errors(const ImageAnswer& image, const Scene& asked, const Candidate& candidate,
                     std::size_t step, std::uint64_t most) {
  const auto width = static_cast<std::size_t>(asked.camera->width);
  std::uint64_t count = 0;
  for (std::size_t next = 0; next < image.size() && count <= most;) {
    Case part = {asked, {}};
    const std::size_t first = next;
    for (; next < image.size() && part.pixels.size() < kPixelsAtATime; next += step) {
      part.pixels.push_back(
          {static_cast<std::int64_t>(next % width), static_cast<std::int64_t>(next / width)});
    }
    Trial trial(part, candidate);
    for (std::size_t k = 0; k < part.pixels.size(); ++k) {
      count += is_right(image[first + k * step], trial.nearest()[k]) ? 0 : 1;
    }
  }
  return count;
}

/// A step that walks over all columns, to at most kPixelsAtATime pixels.
std::size_t sampling_step(const ImageAnswer& image, const Camera& camera) {
  std::size_t step = (image.size() + kPixelsAtATime - 1) / kPixelsAtATime;
  while (std::gcd(step, static_cast<std::size_t>(camera.width)) != 1) ++step;
  return step;
}

/// Whether every pixel shows something, most of them what is no sphere's own.
bool has_a_background(const ImageAnswer& image) {
  const bool has_black = std::find(image.begin(), image.end(), std::nullopt) != image.end();
  const auto untold = std::count(image.begin(), image.end(), std::optional(kSomeSphere));
  return !has_black && 2 * static_cast<std::size_t>(untold) > image.size();
}

/// The best explanations so far.
class Best {
 public:
  explicit Best(std::uint64_t wrong) : wrong_(wrong), most_left_(most_unexplained(wrong)) {}

  void add(const std::string& sentence, std::uint64_t left) {
    if (left > most_left_) return;
    if (left < most_left_) found_.clear();
    most_left_ = left;
    found_.push_back({sentence, wrong_, wrong_ - left});
  }
  /// The errors that may be left by one that is better than all before.
  std::optional<std::uint64_t> most_left_by_better() const {
    if (found_.empty()) return most_left_;
    return most_left_ > 0 ? std::optional(most_left_ - 1) : std::nullopt;
  }
  std::vector<Explanation> take() { return std::move(found_); }

 private:
  std::uint64_t wrong_, most_left_;
  std::vector<Explanation> found_;
};

}  // namespace

std::vector<Explanation> explanations(const Scene& scene, const Conventions& conventions,
                                      const ImageAnswer& image) {
  const ImageAnswer truth = exact_image(scene, conventions);
  const std::uint64_t wrong = errors(image, truth);
  if (wrong == 0 || shows_nothing(image)) return {};
  if (std::adjacent_find(image.begin(), image.end(), std::not_equal_to<>()) == image.end()) {
    return {{"every pixel shows a sphere, as where directions are no numbers: axes that are lost",
             wrong, wrong}};
  }
  if (has_a_background(image)) {
    return {{"no pixel is black: where there is no sphere another colour is shown", wrong, wrong}};
  }
  Scene asked = scene;
  asked.conventions = conventions;
  Best best(wrong);
  for (const Mistake& mistake : mistakes()) {
    if (!is_exact(mistake, *asked.camera)) continue;
    if (const auto other = exactly(mistake, asked, truth)) {
      best.add(mistake.sentence, errors(image, *other));
    }
  }
  const std::optional<std::uint64_t> most = best.most_left_by_better();
  if (!most) return best.take();
  const std::size_t step = sampling_step(image, *asked.camera);
  for (const Mistake& mistake : mistakes()) {
    if (is_exact(mistake, *asked.camera)) continue;
    // Twice what an even sample of as many errors would show, and a few by chance.
    const std::uint64_t most_of_sample = 2 * *most / step + 16;
    if (step > 1 && errors(image, asked, mistake.candidate, step, most_of_sample) > most_of_sample)
      continue;
    const std::uint64_t left = errors(image, asked, mistake.candidate, 1, *most);
    if (left <= *most) best.add(mistake.sentence, left);
  }
  return best.take();
}

}  // namespace raycheck::properties
