// What is small enough to be overlooked, in code that anybody would call right.

#include "tests/mutants/careful.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "properties/search/campaign.h"

namespace raycheck::mutants {
namespace {

using namespace properties;

/// Ordinary ones of all families, judged apart.
std::vector<ChosenSource> ordinary_sources() {
  std::vector<ChosenSource> result;
  for (const CaseSource& source : case_sources()) {
    result.push_back({&source, source.dial ? std::optional(0) : std::nullopt});
  }
  return result;
}

/// The first source that breaks a law with the default number of cases; empty where none does.
std::string broken_at(const Law& law, const Candidate& candidate,
                      const std::vector<ChosenSource>& sources) {
  for (const ChosenSource& source : sources) {
    CampaignOptions options;
    options.sources = {source};
    if (run_campaign(law, candidate, options).failure) return source.name();
  }
  return "";
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
    EXPECT_EQ(broken_at(law, careful_candidate("careful"), ordinary_sources()), "") << law.name;
  }
}

TEST(CarefulCode, WithASmallFaultBreaksItsLawsOnOrdinaryCases) {
  for (const auto& [name, fault, laws] : small_faults()) {
    for (const char* law : laws) {
      EXPECT_NE(broken_at(*find_law(law), careful_candidate(name, fault), ordinary_sources()), "")
          << name << ", " << law;
    }
  }
}

TEST(CarefulCode, WithABandAroundTangencyBreaksTheClassOnDemandingCases) {
  const Candidate band = careful_candidate("band-2^-20", {.band = 0x1p-20});
  const std::vector<ChosenSource> demanding = {chosen_source("tangency@7")};
  EXPECT_NE(broken_at(*find_law("class"), band, demanding), "");
  EXPECT_EQ(broken_at(*find_law("class"), careful_candidate("careful"), demanding), "");
}

}  // namespace
}  // namespace raycheck::mutants
