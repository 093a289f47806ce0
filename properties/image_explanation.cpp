#include "properties/image_explanation.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "reference/visibility.h"
#include "scene/plan.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

using scene::Camera;
using scene::Conventions;
using scene::Scene;

ImageAnswer seen(const Scene& scene, const Conventions& conventions) {
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

/// Of the spheres that a pixel's ray meets the first in the file, or the last.
ImageAnswer seen_in_file_order(const Scene& scene, const Conventions& conventions, bool last) {
  const reference::Visibility visibility(
      scene, scene::plan_scene(scene, conventions, scene::Wanted::kClass));
  const Camera& camera = *scene.camera;
  ImageAnswer image(static_cast<std::size_t>(camera.width * camera.height));
  std::vector<reference::HitClass> classes(image.size());
  for (std::size_t sphere = 0; sphere < scene.spheres.size(); ++sphere) {
    visibility.classes(sphere, 0, camera.height, classes);
    for (std::size_t k = 0; k < image.size(); ++k) {
      if (classes[k] != reference::HitClass::kMiss && (last || !image[k])) image[k] = sphere;
    }
  }
  return image;
}

/// The image whose pixel (i, j) is that of another one.
template <class Source>
ImageAnswer rearranged(const ImageAnswer& image, const Camera& camera, const Source& source) {
  ImageAnswer result(image.size());
  for (std::int64_t j = 0; j < camera.height; ++j) {
    for (std::int64_t i = 0; i < camera.width; ++i) {
      const auto [from_i, from_j] = source(i, j);
      result[static_cast<std::size_t>(j * camera.width + i)] =
          image[static_cast<std::size_t>(from_j * camera.width + from_i)];
    }
  }
  return result;
}

std::uint64_t errors(const ImageAnswer& image, const ImageAnswer& truth) {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < image.size(); ++k) {
    const bool is_right = image[k] == truth[k] || (image[k] == kSomeSphere && truth[k]);
    count += is_right ? 0 : 1;
  }
  return count;
}

struct Mistake {
  std::string sentence;
  std::function<ImageAnswer()> image;
};

using Pair = std::pair<std::int64_t, std::int64_t>;

std::vector<Mistake> arrangements(const ImageAnswer& truth, const Camera& camera) {
  const std::int64_t right = camera.width - 1, top = camera.height - 1;
  const auto by = [&](auto source) {
    return [&truth, &camera, source] { return rearranged(truth, camera, source); };
  };
  std::vector<Mistake> mistakes = {
      {"rows are upside down", by([top](auto i, auto j) { return Pair(i, top - j); })},
      {"columns are mirrored", by([right](auto i, auto j) { return Pair(right - i, j); })},
      {"the image is turned by half a turn",
       by([right, top](auto i, auto j) { return Pair(right - i, top - j); })}};
  if (camera.width == camera.height) {
    mistakes.push_back(
        {"rows and columns are exchanged", by([](auto i, auto j) { return Pair(j, i); })});
  }
  return mistakes;
}

std::vector<Mistake> other_conventions(const Scene& scene, const Conventions& conventions) {
  std::vector<Mistake> mistakes;
  const auto add = [&](const std::string& sentence, const Conventions& other) {
    if (other == conventions) return;
    mistakes.push_back({sentence, [&scene, other] { return seen(scene, other); }});
  };
  Conventions other = conventions;
  other.samples = scene::Samples::kCentres;
  add("pixels are sampled at their centres", other);
  other.samples = scene::Samples::kEdges;
  add("pixels are sampled from edge to edge", other);
  other = conventions;
  other.origin = scene::Origin::kFocal;
  add("rays start at the eye, so that spheres before the image plane are seen", other);
  other.origin = scene::Origin::kPixel;
  add("rays start on the image plane, so that spheres before it are not seen", other);
  other = conventions;
  other.root = scene::Root::kSmaller;
  add("only the near root counts, so that spheres around the origin are not seen", other);
  other.root = scene::Root::kNearest;
  add("the far root counts too, so that spheres around the origin are seen", other);
  return mistakes;
}

std::vector<Mistake> other_cameras(const Scene& scene, const Conventions& conventions) {
  std::vector<Mistake> mistakes;
  const auto add = [&](const std::string& sentence, const std::function<void(Camera&)>& change) {
    Scene other = scene;
    change(*other.camera);
    if (other == scene || !scene::problems(other).empty()) return;
    mistakes.push_back({sentence, [other, conventions] { return seen(other, conventions); }});
  };
  add("top is -bottom", [](Camera& camera) { camera.top = -camera.bottom; });
  add("bottom is -top", [](Camera& camera) { camera.bottom = -camera.top; });
  add("right is -left", [](Camera& camera) { camera.right = -camera.left; });
  add("left is -right", [](Camera& camera) { camera.left = -camera.right; });
  add("top is taken from right", [](Camera& camera) { camera.top = camera.right; });
  add("the bounds of rows are those of columns", [](Camera& camera) {
    camera.bottom = camera.left;
    camera.top = camera.right;
  });
  add("W has the wrong sign, the image plane is behind the eye",
      [](Camera& camera) { camera.near = -camera.near; });
  add("up is taken for (0, 1, 0)", [](Camera& camera) { camera.up = {0, 1, 0}; });
  const auto columns = static_cast<double>(scene.camera->width - 1);
  const auto rows = static_cast<double>(scene.camera->height - 1);
  add("width and height are exchanged", [columns, rows](Camera& camera) {
    if (columns < 1 || rows < 1) return;
    camera.right = camera.left + (camera.right - camera.left) * (columns / rows);
    camera.top = camera.bottom + (camera.top - camera.bottom) * (rows / columns);
  });
  return mistakes;
}

}  // namespace

std::vector<Explanation> explanations(const Scene& scene, const Conventions& conventions,
                                      const ImageAnswer& image) {
  const ImageAnswer truth = seen(scene, conventions);
  const std::uint64_t wrong = errors(image, truth);
  if (wrong == 0) return {};
  std::vector<Mistake> mistakes = arrangements(truth, *scene.camera);
  for (auto* more : {&other_conventions, &other_cameras}) {
    const auto found = (*more)(scene, conventions);
    mistakes.insert(mistakes.end(), found.begin(), found.end());
  }
  for (const bool last : {false, true}) {
    mistakes.push_back(
        {last ? "the last sphere in the file wins" : "the first sphere in the file wins",
         [&, last] { return seen_in_file_order(scene, conventions, last); }});
  }
  std::vector<Explanation> best;
  std::uint64_t fewest =
      static_cast<std::uint64_t>(static_cast<double>(wrong) * (1 - kExplainedShare));
  for (const Mistake& mistake : mistakes) {
    const std::uint64_t left = errors(image, mistake.image());
    if (left > fewest) continue;
    if (left < fewest) best.clear();
    fewest = left;
    best.push_back({mistake.sentence, wrong, wrong - left});
  }
  return best;
}

}  // namespace raycheck::properties
