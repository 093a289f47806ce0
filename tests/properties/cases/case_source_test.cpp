// What the sources of cases make: a generator that never gives what it is for tests nothing. The
// dials of families have tests of their own.

#include "properties/cases/case_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "properties/cases/random.h"
#include "properties/trial.h"
#include "scene/validate.h"
#include "tests/properties/cases/dial.h"

namespace raycheck::properties {
namespace {

/// Calls visit(source, severity) for every source, families at many severities.
template <class Visit>
void for_each_severity(Visit visit) {
  for (const CaseSource& source : case_sources()) {
    for (const int severity : severities(source.dial ? source.dial->highest : 0)) {
      SCOPED_TRACE(std::string(source.name) + "@" + std::to_string(severity));
      visit(source, severity);
    }
  }
}

/// How many pairs of a ray and a sphere there are, by their exact class.
struct Mixture {
  int pairs = 0;
  int hits = 0;
  int misses = 0;
  int tangents = 0;
};

Mixture count(const CaseSource& source, int severity, std::uint64_t seeds) {
  Mixture counts;
  const Candidate nobody;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Case the_case = source.make(severity, seed);
    Trial trial(the_case, nobody);
    for (std::size_t ray = 0; ray < trial.ray_count(); ++ray) {
      for (std::size_t sphere = 0; sphere < the_case.scene.spheres.size(); ++sphere) {
        ++counts.pairs;
        const auto hit_class = trial.exact_intersection(ray, sphere).hit_class;
        counts.hits += hit_class == reference::HitClass::kHit ? 1 : 0;
        counts.misses += hit_class == reference::HitClass::kMiss ? 1 : 0;
        counts.tangents += hit_class == reference::HitClass::kTangent ? 1 : 0;
      }
    }
  }
  return counts;
}

/// Rays that meet two spheres first at the same parameter.
int count_ties(const CaseSource& source, std::uint64_t seeds) {
  int ties = 0;
  const Candidate nobody;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Case the_case = ChosenSource{&source}.make(seed);
    Trial trial(the_case, nobody);
    for (std::size_t ray = 0; ray < trial.ray_count(); ++ray) {
      const auto nearest =
          trial.exact_ray(ray).nearest(the_case.scene.spheres, the_case.scene.conventions);
      ties += nearest && nearest->ties.size() > 1 ? 1 : 0;
    }
  }
  return ties;
}

TEST(CaseSource, KeepsMakingBothHitsAndMisses) {
  for_each_severity([](const CaseSource& source, int severity) {
    const Mixture counts = count(source, severity, 120);
    EXPECT_GE(counts.pairs, 120);
    EXPECT_GT(20 * (counts.hits + counts.tangents), counts.pairs);
    // Nothing but tangents is what tangent-ulps is for at its highest.
    const bool only_tangents = source.name == "tangent-ulps" && severity == source.dial->highest;
    EXPECT_GT(20 * (only_tangents ? counts.tangents : counts.misses), counts.pairs);
  });
}

TEST(CaseSource, OfTiesHasTangentsAndTies) {
  const CaseSource& source = *find_case_source("ties");
  const Mixture counts = count(source, 0, 2000);
  EXPECT_GT(10 * counts.tangents, counts.pairs);
  EXPECT_GT(count_ties(source, 2000), 100);
  EXPECT_GT(count_ties(*find_case_source("plain-cameras"), 2000), 40);
}

TEST(CaseSource, UsesEveryConvention) {
  for (const CaseSource& source : case_sources()) {
    SCOPED_TRACE(source.name);
    std::set<int> seen;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      const scene::Conventions c = ChosenSource{&source}.make(seed).scene.conventions;
      seen.insert({static_cast<int>(c.rows), 10 + static_cast<int>(c.samples),
                   30 + static_cast<int>(c.root), 40 + static_cast<int>(c.tangent)});
      if (source.name != "near-plane") seen.insert(20 + static_cast<int>(c.origin));
    }
    seen.insert({20, 21});
    EXPECT_EQ(seen, (std::set<int>{0, 1, 10, 11, 20, 21, 30, 31, 40, 41, 42}));
  }
}

TEST(AnyCase, HasEverySeverityAboutAsOften) {
  const CaseSource& source = *find_case_source("distance");
  std::vector<int> found(static_cast<std::size_t>(source.dial->highest) + 1);
  for (std::uint64_t seed = 0; seed < 1600; ++seed) {
    const Case the_case = ChosenSource{&source}.make(seed);
    for (int severity = 0; severity <= source.dial->highest; ++severity) {
      if (source.make(severity, seed).scene == the_case.scene) {
        ++found[static_cast<std::size_t>(severity)];
      }
    }
  }
  for (const int count : found) EXPECT_NEAR(count, 100, 40);
}

std::string error_of(std::string_view name) {
  try {
    chosen_source(name);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(ChosenSource, IsASourceOrOneOfItsSeverities) {
  for (const char* name : {"rays", "distance", "distance@0", "distance@15", "scale@1074"}) {
    EXPECT_EQ(chosen_source(name).name(), name);
  }
  const CaseSource& distance = *find_case_source("distance");
  EXPECT_EQ(chosen_source("distance@7").make(3).scene, distance.make(7, 3).scene);
}

TEST(ChosenSource, NamesWhatIsWrong) {
  EXPECT_EQ(error_of("moon"), "no source of cases is called 'moon'");
  EXPECT_EQ(error_of("moon@3"), "no source of cases is called 'moon'");
  EXPECT_EQ(error_of("rays@3"), "'rays' has no severities to choose from");
  for (const char* severity : {"", "-1", "16", "x", "3x", "+3", "99999999999"}) {
    EXPECT_EQ(error_of("distance@" + std::string(severity)),
              "severities of 'distance' are 0 to 15, not '" + std::string(severity) + "'");
  }
}

TEST(ChosenBy, IsEachSourceAboutAsOftenAsTheOthers) {
  std::vector<ChosenSource> all;
  for (const CaseSource& source : case_sources()) all.push_back({&source});
  constexpr std::uint64_t kMean = 1000;
  std::map<std::string, std::uint64_t> counts;
  for (std::uint64_t seed = 0; seed < kMean * all.size(); ++seed) {
    ++counts[chosen_by(all, seed).name()];
  }
  EXPECT_EQ(counts.size(), all.size());
  for (const auto& [name, count] : counts) {
    EXPECT_NEAR(static_cast<double>(count), kMean, 5 * std::sqrt(kMean)) << name;
  }
}

TEST(ChosenBy, StaysWhatItWasWhereASourceMoreIsNotChosen) {
  std::vector<ChosenSource> all;
  for (const CaseSource& source : case_sources()) all.push_back({&source});
  Random seeds(1);
  for (std::size_t added = 0; added < all.size(); ++added) {
    std::vector<ChosenSource> fewer = all;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(added));
    std::uint64_t taken_over = 0;
    constexpr std::uint64_t kSeeds = 500;
    for (std::uint64_t k = 0; k < kSeeds; ++k) {
      const std::uint64_t seed = seeds.bits();
      const ChosenSource& now = chosen_by(all, seed);
      if (now.source == all[added].source) {
        ++taken_over;
      } else {
        EXPECT_EQ(chosen_by(fewer, seed).name(), now.name());
      }
    }
    EXPECT_GT(taken_over, 0u) << all[added].name();
    EXPECT_LT(taken_over, kSeeds / 5) << all[added].name();
  }
}

}  // namespace
}  // namespace raycheck::properties
