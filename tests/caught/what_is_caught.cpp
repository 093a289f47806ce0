// Writes docs/what-is-caught.md: `what_is_caught TEMPLATE > PAGE`. What it is doing goes to stderr.
// With a number of cases besides, injected errors are judged on so many.

#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "tests/caught/page.h"

namespace {

using namespace raycheck;

template <class Row, class Find>
std::vector<caught::OfSource<Row>> on_each_source(const char* what, Find find) {
  std::vector<caught::OfSource<Row>> found;
  for (const properties::CaseSource& source : properties::case_sources()) {
    std::fprintf(stderr, "%s: %.*s\n", what, static_cast<int>(source.name.size()),
                 source.name.data());
    found.push_back({&source, find(source)});
  }
  return found;
}

std::string filled(std::string text, int cases) {
  std::vector<const caught::ErrorKind*> kinds;
  for (const caught::ErrorKind& kind : caught::error_kinds()) kinds.push_back(&kind);
  const auto small_errors = on_each_source<caught::Resolution>("resolution", [&](const auto& source) {
    return caught::resolutions(source, cases, kinds);
  });
  const std::vector<mutants::Mutant> all = mutants::all_mutants();
  const auto mutants = on_each_source<caught::FirstCaught>(
      "mutants", [&](const auto& source) { return caught::first_caught(source, all); });
  std::fprintf(stderr, "dull candidates\n");
  const std::map<std::string, std::string> parts = {
      {"dull", caught::dull_table()},
      {"excused", caught::excused_table()},
      {"mutants", caught::mutant_tables(mutants)},
      {"summary", caught::summary_table(small_errors)},
      {"resolution", caught::resolution_tables(small_errors)},
      {"severities", caught::severity_tables(small_errors)},
  };
  for (const auto& [name, part] : parts) {
    const std::string mark = "{{" + name + "}}\n";
    const std::size_t at = text.find(mark);
    if (at != std::string::npos) text.replace(at, mark.size(), part);
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
  const int cases = argc == 3 ? std::stoi(argv[2]) : caught::kResolutionCases;
  std::fputs(filled({std::istreambuf_iterator<char>(file), {}}, cases).c_str(), stdout);
  return 0;
}
