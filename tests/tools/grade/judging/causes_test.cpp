// Which mistakes explain the failures of several items together.

#include "properties/mistakes/mistakes.h"
#include "properties/run_control.h"
#include "tests/testing.h"
#include "tools/grade/judging/judge.h"

namespace raycheck::tests {
namespace {

using namespace scene;

/// The states of the items about pixels, for code with mirrored columns whose directions have this
/// second component.
std::vector<tools::ItemState> states_with(std::optional<double> second) {
  tools::Rubric rubric =
      tools::load_rubric(std::string(RAYCHECK_SOURCE_DIR) + "/examples/rubrics/lecture7.toml");
  std::erase_if(rubric.items, [](const tools::Item& item) {
    return item.name != "boundary pixels" && item.name != "pixel (0, 0)";
  });
  properties::Candidate candidate = properties::find_mistake("columns are mirrored")->candidate;
  for (auto* rays : {&candidate.pixel_rays, &candidate.focal_rays}) {
    *rays = [right = *rays, second](const Camera& camera, const Conventions& conventions,
                                    std::span<const Pixel> pixels) {
      std::vector<Ray> made = right(camera, conventions, pixels);
      for (Ray& ray : made) ray.direction.y = second.value_or(ray.direction.y);
      return made;
    };
  }
  std::vector<tools::ItemState> states;
  for (const auto& item : tools::judge(rubric, {candidate}, 1, {})) states.push_back(item.state);
  return states;
}

TEST(Causes, ThatExplainPixelsDoNotExplainRaysThatAreNotNumbers) {
  using enum tools::ItemState;
  EXPECT_EQ(states_with({}), std::vector({kFails, kFollows}));
  EXPECT_EQ(states_with(std::nan("")), std::vector({kFails, kFails}));
}

}  // namespace
}  // namespace raycheck::tests
