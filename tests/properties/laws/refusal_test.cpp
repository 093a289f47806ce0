// The law refusal asks each case of a campaign only some of its questions. A candidate that accepts
// one kind of invalid input is found nevertheless, by the default number of cases.

#include <optional>
#include <set>

#include "scene/validate.h"
#include "tests/campaigns.h"
#include "tests/mutants/mutants.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

/// What is invalid, without values that differ from case to case.
std::string kind_of(const std::vector<scene::Defect>& defects) {
  if (defects.empty()) return {};
  const auto& [field, value, what] = defects.front();
  const bool is_finite = value.find("nan") == std::string::npos &&  //
                         value.find("inf") == std::string::npos;
  return " " + field + " " + what + (is_finite ? "" : " " + value);
}
template <class... More>
std::string kind_of(const Camera& camera, const More&... /*more*/) {
  return kind_of(scene::defects(camera));
}
std::string kind_of(std::span<const Ray> rays, std::span<const Sphere> spheres,
                    const Conventions& /*conventions*/) {
  return kind_of(scene::defects(rays.front())) + kind_of(scene::defects(spheres.front()));
}

/// direct/cross, but it answers nothing if takes(a function's name and the kind of invalid input).
template <class Takes>
Candidate accepting(const Takes& takes) {
  Candidate candidate = mutants::named("accepts-one-kind");
  const auto change = [&](auto& function, const std::string& name) {
    function = [ask = function, name, takes](const auto&... asked) {
      using Answered = typename std::decay_t<decltype(ask)>::result_type;
      const std::string kind = kind_of(asked...);
      return !kind.empty() && takes(name + kind) ? Answered{} : ask.as_is(asked...);
    };
  };
  change(candidate.frame, "frame");
  change(candidate.pixel_points, "pixel_points");
  change(candidate.pixel_rays, "pixel_rays");
  change(candidate.focal_rays, "focal_rays");
  change(candidate.intersect, "intersect");
  return candidate;
}

TEST(Refusal, FindsEachKindOfAcceptedInput) {
  const auto laws = laws_named({"refusal"});
  std::set<std::string> kinds;
  const Candidate noting = accepting([&kinds](const std::string& kind) {
    kinds.insert(kind);
    return false;
  });
  const CampaignOptions options = options_of(CampaignOptions().cases, {}, Level::kOrdinary);
  const CampaignResult right = run_campaigns(laws, noting, options).front();
  EXPECT_FALSE(right.failure);
  EXPECT_GE(kinds.size(), 50u);
  // At most five questions of each case are asked, of 7 to 61.
  EXPECT_LE(right.verdict.compared(), 5u * static_cast<unsigned>(right.counts.cases));
  for (const std::string& kind : kinds) {
    const Candidate mutant = accepting([&kind](const std::string& asked) { return asked == kind; });
    const Campaigns campaigns({{laws, options}});
    std::optional<Break> found;
    for (std::size_t unit = 0; unit < campaigns.unit_count() && !found; ++unit) {
      const CampaignPart part = campaigns.run(unit, {&mutant, 1}, {}).front();
      if (part.is_broken()) found = part.breaks.front();
    }
    ASSERT_TRUE(found) << kind;
    EXPECT_EQ(found->defects.front().wrong, Wrong::kAnswered) << kind;
    if (kind != *kinds.begin()) continue;  // shrinking takes long
    EXPECT_TRUE(run_replay(parse_replay(found->replay), mutant).failure) << kind;
  }
}

}  // namespace
}  // namespace raycheck::properties
