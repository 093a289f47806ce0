// tools/verify_certificates.py, which shares no code with raycheck, confirms certificates of the
// laws' discrepancies on random cases. The candidates are the methods, with a bound of 0 so that
// every rounding is a discrepancy, and the mutants, which are wrong in all ways.

#include "properties/candidates/fast_candidate.h"
#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "tests/mutants/mutants.h"
#include "tests/names.h"
#include "tests/tools/report/certificates.h"
#include "tools/implementations/built_in.h"
#include "tools/report/certificate.h"

namespace raycheck::tools {
namespace {

using namespace properties;

/// The number of a law's discrepancies that are examined; a law has fewer quantities.
constexpr std::size_t kMostLookedAt = 12;

std::vector<Candidate> all_candidates() {
  std::vector<Candidate> result;
  for (const MethodPair& pair : each_method_once()) {
    result.push_back(properties::fast_candidate(*pair.rays, *pair.intersect));
  }
  for (mutants::Mutant& mutant : mutants::all_mutants()) {
    result.push_back(std::move(mutant.candidate));
  }
  return result;
}

/// Adds certificates of the worst discrepancy in each quantity, for each law that judges values and
/// has this text in its name.
void certify(const Case& the_case, const Candidate& candidate, std::string_view filter,
             std::vector<Json>& certificates) {
  properties::Trial trial(the_case, candidate, {.max_error = 0});
  for (const properties::Law& law : properties::laws()) {
    if (!law.judges_values || law.name.find(filter) == law.name.npos) continue;
    std::set<properties::Quantity> certified;
    for (const auto& found : apply(law, trial).worst(kMostLookedAt)) {
      if (!certified.insert(found.quantity).second) continue;
      certificates.push_back(
          certificate(the_case.scene, trial.conventions(), found, candidate.name));
    }
  }
}

/// Certificates on cases of a source, a few for each candidate.
std::vector<Json> certificates_of(const std::vector<Candidate>& candidates,
                                  const CaseSource& source, std::uint64_t cases_each,
                                  std::string_view filter = {}) {
  std::vector<Json> certificates;
  std::uint64_t seed = 0;
  for (const Candidate& candidate : candidates) {
    for (std::uint64_t k = 0; k < cases_each; ++k) {
      certify(properties::ChosenSource{&source}.make(++seed), candidate, filter, certificates);
    }
  }
  return certificates;
}

/// The number of confirmed certificates by quantity. Only refusals, which state no value, and the
/// numbers of depth pictures may be uncertified.
std::map<std::string, int> confirmed_of(const std::vector<Json>& certificates) {
  const std::vector<std::string> lines = tests::script_lines(certificates);
  std::map<std::string, int> confirmed;
  for (std::size_t k = 0; k < certificates.size() && k < lines.size(); ++k) {
    const std::string quantity = certificates[k]["quantity"];
    if (quantity == "refusal" || quantity == "depth") {
      EXPECT_EQ(lines[k].rfind("not certified", 0), 0u) << lines[k];
      continue;
    }
    EXPECT_EQ(lines[k].rfind("confirmed", 0), 0u) << lines[k] << "\n" << certificates[k];
    ++confirmed[quantity];
  }
  return confirmed;
}

const std::vector<std::string> kOfIntersections = {
    "class", "parameter", "hit point", "sphere residual", "ray residual", "nearest sphere"};
const std::vector<std::string> kOfCameras = {"frame",     "orthonormality", "pixel point",
                                             "direction", "unit defect",    "ray origin"};

class EachSource : public testing::TestWithParam<std::string> {};

TEST_P(EachSource, HasItsDiscrepanciesConfirmedWithoutTheProgram) {
  const CaseSource* source = properties::find_case_source(GetParam());
  ASSERT_NE(source, nullptr);
  const auto confirmed =
      confirmed_of(certificates_of(all_candidates(), *source, source->has_camera ? 1 : 6));
  for (const std::string& quantity : kOfIntersections) {
    // Of a single sphere, the hit class determines the nearest sphere.
    const bool has_one_sphere = source->name == "horizon" || source->name == "from-surface";
    if (quantity == "nearest sphere" && has_one_sphere) continue;
    EXPECT_GE(confirmed.contains(quantity) ? confirmed.at(quantity) : 0, 1) << quantity;
  }
  if (!source->has_camera) return;
  for (const std::string& quantity : kOfCameras) {
    EXPECT_GE(confirmed.contains(quantity) ? confirmed.at(quantity) : 0, 4) << quantity;
  }
}

std::vector<std::string> sources_that(bool have_cameras) {
  std::vector<std::string> names;
  for (const CaseSource& source : properties::case_sources()) {
    if (source.has_camera == have_cameras) names.emplace_back(source.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(OfCameras, EachSource, testing::ValuesIn(sources_that(true)), by_name);
INSTANTIATE_TEST_SUITE_P(OfRays, EachSource, testing::ValuesIn(sources_that(false)), by_name);

TEST(Certificates, OfWrongRootsAreConfirmed) {
  std::vector<Candidate> candidates;
  for (mutants::Mutant& mutant : mutants::all_mutants()) {
    const auto& laws = mutant.caught_by;
    if (std::find(laws.begin(), laws.end(), "nearest-root") == laws.end()) continue;
    candidates.push_back(std::move(mutant.candidate));
  }
  ASSERT_GE(candidates.size(), 1u);
  for (const char* source : {"cameras", "rays"}) {
    const auto certificates =
        certificates_of(candidates, *properties::find_case_source(source), 60, "root");
    EXPECT_GE(confirmed_of(certificates)["root"], 5) << source;
  }
}

}  // namespace
}  // namespace raycheck::tools
