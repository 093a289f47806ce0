// Writes docs/what-is-caught.md: `what_is_caught TEMPLATE [CASES] > PAGE`, with progress on stderr.
// CASES is the number of cases for injected errors.

#include <cstdio>
#include <ctime>

#include "tests/caught/page.h"

namespace {

using namespace raycheck;

template <class Row, class Find>
std::vector<caught::OfSource<Row>> on_each_source(const char* what, Find find) {
  std::vector<caught::OfSource<Row>> found;
  for (const properties::CaseSource& source : properties::case_sources()) {
    std::fprintf(stderr, "%s: %s, after %.0f s of processor time\n", what,
                 std::string(source.name).c_str(),
                 static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
    found.push_back({&source, find(source)});
  }
  return found;
}

std::vector<caught::OfSource<caught::Resolution>> small_errors(std::optional<int> cases) {
  std::vector<const caught::ErrorKind*> kinds;
  for (const caught::ErrorKind& kind : caught::error_kinds()) kinds.push_back(&kind);
  return on_each_source<caught::Resolution>("small errors", [&](const auto& source) {
    return caught::resolutions(source, cases.value_or(caught::resolution_cases(source)), kinds);
  });
}

/// A template with its marks replaced. Only tables with a mark are computed.
std::string filled(std::string text, std::optional<int> cases) {
  const std::vector<mutants::Mutant> all = mutants::all_mutants();
  std::optional<std::vector<caught::OfSource<caught::Resolution>>> kept;
  const auto errors = [&] { return kept ? *kept : *(kept = small_errors(cases)); };
  const std::map<std::string, std::function<std::string()>> parts = {
      {"degenerate", caught::degenerate_table},
      {"excused", caught::excused_table},
      {"mutants",
       [&] {
         return caught::mutant_tables(on_each_source<caught::FirstCaught>(
             "mutants", [&](const auto& source) { return caught::first_caught(source, all); }));
       }},
      {"reports", caught::reports_table},
      {"summary", [&] { return caught::summary_table(errors()); }},
      {"resolution", [&] { return caught::resolution_tables(errors()); }},
      {"severities", [&] { return caught::severity_tables(errors()); }},
  };
  for (const auto& [name, part] : parts) {
    const std::string mark = "{{" + name + "}}\n";
    const std::size_t at = text.find(mark);
    if (at != std::string::npos) text.replace(at, mark.size(), part());
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "what_is_caught TEMPLATE [CASES] > PAGE\n");
    return 2;
  }
  std::ifstream file(argv[1]);
  const auto cases = argc == 3 ? std::optional(std::stoi(argv[2])) : std::nullopt;
  std::fputs(filled({std::istreambuf_iterator<char>(file), {}}, cases).c_str(), stdout);
  return 0;
}
