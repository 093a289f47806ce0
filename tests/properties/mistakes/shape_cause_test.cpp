#include "properties/mistakes/shape_cause.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/properties/mistakes/shown_scenes.h"

namespace raycheck::properties {
namespace {

template <class Fails>
std::optional<std::string> cause_where(const std::vector<scene::Scene>& scenes,
                                       const Fails& fails) {
  std::vector<TriedScene> tried;
  for (const scene::Scene& scene : scenes) tried.push_back({&scene, fails(scene)});
  const auto cause = shape_cause(tried);
  if (!cause) return {};
  for (const TriedScene& one : tried) EXPECT_EQ(cause->is(*one.scene), one.failed);
  return cause->sentence;
}

TEST(ShapeCause, IsWhatAllFailuresHaveInCommonAndNothingElse) {
  std::vector<scene::Scene> scenes = rubric_scenes();
  // A high picture, so that "not square" is not "wide".
  scenes.push_back(scenes.front());
  scenes.back().camera->height *= 2;
  EXPECT_EQ(cause_where(scenes,
                        [](const scene::Scene& s) { return s.camera->width != s.camera->height; }),
            "it fails only where the picture is not square");
  EXPECT_EQ(cause_where(scenes,
                        [](const scene::Scene& s) {
                          return s.camera->left != -s.camera->right ||
                                 s.camera->bottom != -s.camera->top;
                        }),
            "it fails only where the bounds are not symmetric");
  // Bounds uneven one way alone.
  std::vector<scene::Scene> uneven = scenes;
  for (int k = 0; k < 4; ++k) {
    uneven.push_back(scenes.front());
    (k % 2 == 0 ? uneven.back().camera->left : uneven.back().camera->top) *= 0.75;
  }
  EXPECT_EQ(
      cause_where(uneven, [](const scene::Scene& s) { return s.camera->left != -s.camera->right; }),
      "it fails only where left is not -right");
  EXPECT_EQ(cause_where(scenes, [](const scene::Scene& s) { return s.camera->eye.x != 0; }),
            "it fails only where the eye is not at the origin");
  // These have spheres before the image plane, or behind the eye, on the lines of rays.
  const auto has_all_behind = [&](const scene::Scene& s) {
    return &s == &scenes[7] || &s == &scenes[8] || s == probe();
  };
  EXPECT_EQ(cause_where(scenes, has_all_behind),
            "it fails only where what a ray's line meets is all behind the ray's start");
  EXPECT_EQ(cause_where(scenes, [](const scene::Scene& s) { return s.spheres.size() % 2 == 1; }),
            std::nullopt);
}

TEST(ShapeCause, NeedsBothOutcomesMoreThanOnce) {
  const std::vector<scene::Scene> scenes = rubric_scenes();
  EXPECT_EQ(cause_where(scenes, [](const scene::Scene&) { return true; }), std::nullopt);
  EXPECT_EQ(cause_where(scenes, [](const scene::Scene&) { return false; }), std::nullopt);
  EXPECT_EQ(cause_where(scenes, [](const scene::Scene& s) { return s.spheres.size() == 1; }),
            std::nullopt);
}

/// Two shapes that the scenes do not tell apart are none.
TEST(ShapeCause, IsNoneWhereTwoWouldDo) {
  std::vector<scene::Scene> scenes = rubric_scenes();
  std::erase_if(scenes, [](const scene::Scene& s) {
    return s.camera->left != -s.camera->right && s.camera->width == s.camera->height;
  });
  EXPECT_EQ(
      cause_where(scenes, [](const scene::Scene& s) { return s.camera->width > s.camera->height; }),
      std::nullopt);
}

}  // namespace
}  // namespace raycheck::properties
