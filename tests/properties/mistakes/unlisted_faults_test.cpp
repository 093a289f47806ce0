// Faults that are no classic mistakes: none is named for them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "tests/properties/mistakes/shown_scenes.h"

namespace raycheck::properties {
namespace {

using scene::Camera;
using scene::Scene;
using scene::Sphere;

/// The sizes of a fault.
struct FaultSizes {
  std::mt19937_64 random;
  double factor, across, up, share;
  std::int64_t pixels;
};

double between(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

FaultSizes sizes_of(std::uint64_t seed) {
  FaultSizes sizes{std::mt19937_64(seed), 0, 0, 0, 0, 0};
  sizes.factor = between(sizes.random, 1.1, 2);
  sizes.across = between(sizes.random, -1, 1);
  sizes.up = between(sizes.random, -1, 1);
  sizes.share = between(sizes.random, 0.05, 0.4);
  sizes.pixels = 1 + static_cast<std::int64_t>(sizes.random() % 3);
  return sizes;
}

using ChangeScene = void (*)(Scene&, FaultSizes&);

void each(Scene& scene, const std::function<void(Sphere&)>& change) {
  for (Sphere& sphere : scene.spheres) change(sphere);
}

/// Other scenes than those asked for.
constexpr ChangeScene kScenes[] = {
    [](Scene& s, FaultSizes& z) {
      Sphere& one = s.spheres[z.random() % s.spheres.size()];
      one.centre.x += z.across;
      one.centre.y += z.up;
    },
    [](Scene& s, FaultSizes&) { each(s, [](Sphere& one) { one.radius *= 2; }); },
    [](Scene& s, FaultSizes& z) { each(s, [&](Sphere& one) { one.radius *= z.factor; }); },
    [](Scene& s, FaultSizes&) { each(s, [](Sphere& one) { one.radius += 0.25; }); },
    [](Scene& s, FaultSizes&) { each(s, [](Sphere& one) { one.radius = 1; }); },
    [](Scene& s, FaultSizes& z) {
      each(s, [&](Sphere& one) {
        one.centre.x += z.across;
        one.centre.y += z.up;
      });
    },
    [](Scene& s, FaultSizes&) { each(s, [](Sphere& one) { one.centre.z = -one.centre.z; }); },
    [](Scene& s, FaultSizes&) {
      each(s, [](Sphere& one) { std::swap(one.centre.x, one.centre.y); });
    },
    [](Scene& s, FaultSizes&) { s.spheres.pop_back(); },
    [](Scene& s, FaultSizes&) { s.spheres.front().radius = 0; },
    [](Scene& s, FaultSizes& z) {
      Camera& c = *s.camera;
      for (double* bound : {&c.left, &c.right, &c.bottom, &c.top}) *bound *= z.factor;
    },
    [](Scene& s, FaultSizes& z) { s.camera->near *= z.factor; },
    [](Scene& s, FaultSizes& z) { s.camera->top *= z.factor; },
    [](Scene& s, FaultSizes& z) {
      s.camera->left += z.across;
      s.camera->right += z.across;
    },
    [](Scene& s, FaultSizes& z) {
      s.camera->eye.x += z.across;
      s.camera->eye.y += z.up;
    },
    [](Scene& s, FaultSizes& z) { s.camera->eye.z += z.factor; },
    [](Scene& s, FaultSizes& z) { s.camera->up.x += z.factor; },
    [](Scene& s, FaultSizes& z) { s.camera->look_at.x += z.factor * s.camera->near; },
};

struct SeenImage {
  ImageAnswer seen;
  std::int64_t width, height;

  std::optional<std::size_t> at(std::int64_t i, std::int64_t j) const {
    if (i < 0 || j < 0 || i >= width || j >= height) return {};
    return seen[static_cast<std::size_t>(j * width + i)];
  }
};

using Shows = std::optional<std::size_t> (*)(const SeenImage&, std::int64_t, std::int64_t,
                                             FaultSizes&);

/// Other pixels than those seen.
constexpr Shows kPixels[] = {
    [](const auto& its, auto i, auto j, auto& z) {
      return between(z.random, 0, 1) < z.share ? std::nullopt : its.at(i, j);
    },
    [](const auto& its, auto i, auto j, auto& z) { return its.at(i + z.pixels, j); },
    [](const auto& its, auto i, auto j, auto& z) { return its.at(i, j - z.pixels); },
    [](const auto& its, auto i, auto j, auto&) { return j % 2 == 0 ? its.at(i, j) : std::nullopt; },
    [](const auto& its, auto i, auto j, auto&) { return its.at(i / 2 * 2, j / 2 * 2); },
    [](const auto& its, auto i, auto j, auto&) {
      return i + j < its.width ? its.at(i, j) : std::nullopt;
    },
    [](const auto& its, auto i, auto j, auto&) {
      return its.at(2 * i - its.width / 2, 2 * j - its.height / 2);
    },
};

std::vector<ShownPicture> shown_by(std::size_t kind, FaultSizes sizes) {
  std::vector<ShownPicture> pictures;
  for (const Scene& asked : rubric_scenes()) {
    Scene taken = asked;
    if (kind < std::size(kScenes)) kScenes[kind](taken, sizes);
    const Camera& camera = *asked.camera;
    const SeenImage image = {predicted({}, taken), camera.width, camera.height};
    ShownPicture shown = {asked, image.seen};
    if (kind >= std::size(kScenes)) {
      for (std::int64_t j = 0; j < camera.height; ++j) {
        for (std::int64_t i = 0; i < camera.width; ++i) {
          shown.image[static_cast<std::size_t>(j * camera.width + i)] =
              kPixels[kind - std::size(kScenes)](image, i, j, sizes);
        }
      }
    }
    pictures.push_back(std::move(shown));
  }
  return pictures;
}

TEST(UnlistedFaults, HaveNoCause) {
  constexpr std::size_t kKinds = std::size(kScenes) + std::size(kPixels);
  int wrong = 0;
  for (std::uint64_t seed = 1; seed <= kKinds; ++seed) {
    const std::vector<ShownPicture> pictures = shown_by(seed % kKinds, sizes_of(seed));
    const Causes causes = picture_causes(pictures);
    wrong += causes.errors >= kFewestWrongPixelsOfTwo ? 1 : 0;
    EXPECT_NE(causes.kind, CauseKind::kExplained)
        << seed % kKinds << " " << seed << " " << sentence_of(causes.alternatives.front());
  }
  EXPECT_GE(wrong, 22);
}

}  // namespace
}  // namespace raycheck::properties
