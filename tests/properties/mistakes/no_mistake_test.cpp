// Faults that are no classic mistakes: none is named for them, unless scenes of one shape alone
// have them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>

#include "properties/mistakes/picture_causes.h"
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

void move(scene::Point3& point, const FaultSizes& z) {
  point.x += z.across;
  point.y += z.up;
}

/// Other spheres than those asked for.
constexpr void (*kSpheres[])(Sphere&, const FaultSizes&) = {
    [](Sphere& s, const FaultSizes& z) { s.radius *= z.factor; },
    [](Sphere& s, const FaultSizes&) { s.radius += 0.25; },
    [](Sphere& s, const FaultSizes&) { s.radius = 1; },
    [](Sphere& s, const FaultSizes& z) { move(s.centre, z); },
    [](Sphere& s, const FaultSizes&) { s.centre.z = -s.centre.z; },
    [](Sphere& s, const FaultSizes&) { std::swap(s.centre.x, s.centre.y); },
};

/// Other scenes.
constexpr void (*kScenes[])(Scene&, FaultSizes&) = {
    [](Scene& s, FaultSizes& z) { move(s.spheres[z.random() % s.spheres.size()].centre, z); },
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
    [](Scene& s, FaultSizes& z) { move(s.camera->eye, z); },
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

constexpr std::size_t kKindsOfScenes = std::size(kScenes) + std::size(kSpheres);

std::vector<ShownPicture> shown_with_unlisted(std::size_t kind, FaultSizes sizes) {
  std::vector<ShownPicture> pictures;
  for (const Scene& asked : rubric_scenes()) {
    Scene taken = asked;
    if (kind < std::size(kScenes)) {
      kScenes[kind](taken, sizes);
    } else if (kind < kKindsOfScenes) {
      for (Sphere& sphere : taken.spheres) kSpheres[kind - std::size(kScenes)](sphere, sizes);
    }
    const Camera& camera = *asked.camera;
    const SeenImage image = {predicted({}, taken), camera.width, camera.height};
    ShownPicture shown = {asked, image.seen};
    if (kind >= kKindsOfScenes) {
      for (std::int64_t j = 0; j < camera.height; ++j) {
        for (std::int64_t i = 0; i < camera.width; ++i) {
          shown.image[static_cast<std::size_t>(j * camera.width + i)] =
              kPixels[kind - kKindsOfScenes](image, i, j, sizes);
        }
      }
    }
    pictures.push_back(std::move(shown));
  }
  return pictures;
}

TEST(UnlistedFaults, HaveNoCause) {
  constexpr std::size_t kKinds = kKindsOfScenes + std::size(kPixels);
  int wrong = 0;
  for (std::uint64_t seed = 1; seed <= kKinds; ++seed) {
    const std::vector<ShownPicture> pictures = shown_with_unlisted(seed % kKinds, sizes_of(seed));
    const Causes causes = picture_causes(pictures);
    wrong += causes.errors >= kFewestWrongPixelsOfTwo ? 1 : 0;
    EXPECT_NE(causes.kind, CauseKind::kExplained)
        << seed % kKinds << " " << seed << " " << sentence_of(causes.alternatives.front());
  }
  EXPECT_GE(wrong, 21);
}

template <class Fails>
std::optional<std::string> cause_where(const std::vector<Scene>& scenes, const Fails& fails) {
  std::vector<TriedScene> tried;
  for (const Scene& scene : scenes) tried.push_back({&scene, fails(scene)});
  const auto cause = shape_cause(tried);
  if (!cause) return {};
  for (const TriedScene& one : tried) EXPECT_EQ(cause->is(*one.scene), one.failed);
  return cause->sentence;
}

TEST(ShapeCause, IsWhatAllFailuresHaveInCommonAndNothingElse) {
  const std::vector<Scene> scenes = rubric_scenes();
  // There are high pictures, so that "not square" is not "wide".
  EXPECT_EQ(cause_where(scenes, [](const Scene& s) { return s.camera->width != s.camera->height; }),
            "it fails only where the picture is not square");
  EXPECT_EQ(cause_where(scenes,
                        [](const Scene& s) {
                          return s.camera->left != -s.camera->right ||
                                 s.camera->bottom != -s.camera->top;
                        }),
            "it fails only where the bounds are not symmetric");
  // Bounds uneven one way alone.
  std::vector<Scene> uneven = scenes;
  for (int k = 0; k < 4; ++k) {
    uneven.push_back(scenes.front());
    (k % 2 == 0 ? uneven.back().camera->left : uneven.back().camera->top) *= 0.75;
  }
  EXPECT_EQ(cause_where(uneven, [](const Scene& s) { return s.camera->left != -s.camera->right; }),
            "it fails only where left is not -right");
  EXPECT_EQ(cause_where(scenes, [](const Scene& s) { return s.camera->eye.x != 0; }),
            "it fails only where the eye is not at the origin");
  // With spheres before the image plane, or behind the eye, on the lines of rays.
  const auto has_all_behind = [](const Scene& s) {
    return s == rubric_scene("before") || s == rubric_scene("behind") || s == probe();
  };
  EXPECT_EQ(cause_where(scenes, has_all_behind),
            "it fails only where what a ray's line meets is all behind the ray's start");
  EXPECT_EQ(cause_where(scenes, [](const Scene& s) { return s.spheres.size() % 2 == 1; }),
            std::nullopt);
}

TEST(ShapeCause, NeedsBothOutcomesMoreThanOnce) {
  const std::vector<Scene> scenes = rubric_scenes();
  EXPECT_EQ(cause_where(scenes, [](const Scene&) { return true; }), std::nullopt);
  EXPECT_EQ(cause_where(scenes, [](const Scene&) { return false; }), std::nullopt);
  EXPECT_EQ(cause_where(scenes, [](const Scene& s) { return s.spheres.size() == 1; }),
            std::nullopt);
}

/// Two shapes that the scenes do not tell apart are none.
TEST(ShapeCause, IsNoneWhereTwoWouldDo) {
  std::vector<Scene> scenes = rubric_scenes();
  std::erase_if(scenes, [](const Scene& s) {
    const scene::Camera& c = *s.camera;
    return c.height > c.width || (c.left != -c.right && c.width == c.height);
  });
  EXPECT_EQ(cause_where(scenes, [](const Scene& s) { return s.camera->width > s.camera->height; }),
            std::nullopt);
}

}  // namespace
}  // namespace raycheck::properties
