// What is small enough to be overlooked, in code that anybody would call right.

#include "tests/mutants/careful.h"

#include <gtest/gtest.h>

#include <vector>

#include "properties/search/campaign.h"

namespace raycheck::mutants {
namespace {

using namespace properties;

/// By the default campaign of a level.
bool is_broken(const Law& law, const Candidate& candidate, Level level = Level::kOrdinary) {
  CampaignOptions options;
  options.level = level;
  return run_campaign(law, candidate, options).failure.has_value();
}

struct SmallFault {
  const char* name;
  Fault fault;
  std::vector<const char*> laws;
};

const std::vector<SmallFault>& small_faults() {
  static const std::vector<SmallFault> kFaults = {
      {"s-2^-20", {.s = 0x1p-20}, {"parameter", "backward-error"}},
      {"s-2^-46", {.s = 0x1p-46}, {"parameter"}},
      {"Q-2^-46", {.Q = 0x1p-46}, {"hit-point"}},
      {"D-2^-20", {.D = 0x1p-20}, {"direction"}},
      {"D-2^-46", {.D = 0x1p-46}, {"direction"}},
      {"epsilon-1e-3", {.epsilon = 1e-3}, {"class", "scaling"}},
      {"epsilon-1e-12", {.epsilon = 1e-12}, {"scaling"}},
  };
  return kFaults;
}

TEST(CarefulCode, BreaksNoLawOnOrdinaryCases) {
  for (const Law& law : laws()) {
    EXPECT_FALSE(is_broken(law, careful_candidate("careful"))) << law.name;
  }
}

TEST(CarefulCode, WithASmallFaultBreaksItsLawsOnOrdinaryCases) {
  for (const auto& [name, fault, laws] : small_faults()) {
    for (const char* law : laws) {
      EXPECT_TRUE(is_broken(*find_law(law), careful_candidate(name, fault))) << name << ", " << law;
    }
  }
}

TEST(CarefulCode, WithABandAroundTangencyBreaksTheClassOnDemandingCases) {
  const Law& law = *find_law("class");
  EXPECT_TRUE(
      is_broken(law, careful_candidate("band-2^-20", {.band = 0x1p-20}), Level::kDemanding));
  EXPECT_FALSE(is_broken(law, careful_candidate("careful"), Level::kOrdinary));
}

}  // namespace
}  // namespace raycheck::mutants
