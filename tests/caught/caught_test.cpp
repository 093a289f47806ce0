// Checks parts of docs/what-is-caught.md by computing them again.

#include "fast/intersect.h"
#include "tests/caught/page.h"
#include "tests/testing.h"

namespace raycheck::caught {
namespace {

std::string page() {
  std::ifstream file(std::string(RAYCHECK_SOURCE_DIR) + "/docs/what-is-caught.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

const ErrorKind& kind_named(std::string_view name) {
  for (const ErrorKind& kind : error_kinds()) {
    if (kind.name == name) return kind;
  }
  throw std::invalid_argument("no kind of error is called " + std::string(name));
}

struct Slice {
  const char* kind;
  const char* law;
  const char* source;
};

TEST(WhatIsCaught, SmallErrorsAreAsOnThePage) {
  for (const Slice& slice : std::vector<Slice>{{"s", "parameter", "rays"},
                                               {"s", "backward-error", "ties"},
                                               {"Q", "hit-point", "ties"},
                                               {"band", "class", "tangency"},
                                               {"order", "nearest-sphere", "coincident"},
                                               {"axes", "frame", "plain-cameras"}}) {
    const ErrorKind& kind = kind_named(slice.kind);
    const properties::Law* const law = properties::find_law(slice.law);
    const ErrorKind* const kinds[] = {&kind};
    const properties::Law* const laws[] = {law};
    const properties::CaseSource& source = *properties::find_case_source(slice.source);
    const auto found = resolutions(source, resolution_cases(source), kinds, laws);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(cell_in(page(), std::string(slice.kind) + ":", {"`" + std::string(slice.law) + "`"},
                      slice.source),
              cell_of(found.front()))
        << slice.kind << ", " << slice.law << " on " << slice.source << ": ./run caught";
  }
}

TEST(WhatIsCaught, MutantsAreAsOnThePage) {
  const std::vector<mutants::Mutant> all = mutants::all_mutants();
  std::vector<mutants::Mutant> some;
  for (const mutants::Mutant& mutant : all) {
    const std::string& name = mutant.candidate.name;
    if (name == "cancelling-roots" || name == "far-root" || name == "single-parameter") {
      some.push_back(mutant);
    }
  }
  ASSERT_EQ(some.size(), 3u);
  for (const char* name : {"surface", "tangency", "far-world"}) {
    const properties::CaseSource& source = *properties::find_case_source(name);
    for (const FirstCaught& row : first_caught(source, some)) {
      EXPECT_EQ(
          cell_in(page(), "Laws of rays and spheres",
                  {"`" + row.mutant->candidate.name + "`", "`" + std::string(row.law->name) + "`"},
                  name),
          cell_of(row, source))
          << row.mutant->candidate.name << ", " << row.law->name << ": ./run caught";
    }
  }
}

class EachReport : public testing::TestWithParam<std::size_t> {};

TEST_P(EachReport, IsFoundByTheDefaultRunAsOnThePage) {
  const KnownReport& report = known_reports()[GetParam()];
  const FoundReport its = found(candidate_of(report));
  EXPECT_EQ(!its.law.empty(), report.is_found) << report.mutant;
  EXPECT_EQ(its.sentences, report.sentences) << report.mutant;
  // If a report is not found, or has no named cause, the table says what is needed for it.
  EXPECT_EQ(report.sentences.empty(), !report.needed.empty()) << report.mutant;
  const std::string line = line_of(report, its);
  EXPECT_NE(page().find("\n" + line), std::string::npos) << line << "./run caught";
}

INSTANTIATE_TEST_SUITE_P(Known, EachReport, testing::Range(std::size_t{0}, known_reports().size()));

TEST(KnownReports, AreMadeFromACandidateThatBreaksNoLaw) {
  KnownReport right{"", "", "right",
                    [](const scene::Ray& ray, const scene::Sphere& sphere,
                       const scene::Conventions& conventions) {
                      return properties::usual_choice(ray, fast::kCross.roots(ray, sphere),
                                                      conventions);
                    }};
  for (const auto precision : {scene::Precision::kDouble, scene::Precision::kSingle}) {
    right.precision = precision;
    EXPECT_EQ(found(candidate_of(right)).law, "");
  }
}

/// The text of the page comes from its template.
TEST(WhatIsCaught, IsWrittenFromItsTemplate) {
  std::ifstream file(std::string(RAYCHECK_SOURCE_DIR) + "/docs/what-is-caught.in.md");
  const std::string text = page();
  std::size_t at = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("{{", 0) == 0 || line.empty()) continue;
    const std::size_t found = text.find("\n" + line + "\n", at == 0 ? 0 : at - 1);
    if (text.rfind(line + "\n", 0) == 0 && at == 0) {
      at = line.size() + 1;
      continue;
    }
    ASSERT_NE(found, std::string::npos) << line << ": ./run caught";
    at = found + line.size() + 2;
  }
}

}  // namespace
}  // namespace raycheck::caught
