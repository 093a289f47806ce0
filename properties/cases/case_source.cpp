#include "properties/cases/case_source.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "properties/cases/case_list.h"
#include "properties/cases/random.h"

namespace raycheck::properties {

int SeverityRange::highest_of(Level level) const {
  switch (level) {
    case Level::kOrdinary:
      return ordinary;
    case Level::kDemanding:
      return demanding;
    case Level::kExtreme:
      break;
  }
  return highest;
}

Level SeverityRange::level_of(int severity) const {
  return severity <= ordinary    ? Level::kOrdinary
         : severity <= demanding ? Level::kDemanding
                                 : Level::kExtreme;
}

std::vector<int> some_severities(int first, int last, int most) {
  std::vector<int> severities;
  if (most > 1) {
    const int step = std::max(1, (last - first + most - 2) / (most - 1));
    for (int severity = first; severity < last; severity += step) severities.push_back(severity);
  }
  severities.push_back(last);
  return severities;
}

std::span<const CaseSource> case_sources() {
  static const std::vector<CaseSource> all = [] {
    std::vector<CaseSource> joined;
    for (const std::span<const CaseSource> some :
         {kCourseSources, kCameraSources, kPixelSources, kRaySources, kContactSources}) {
      joined.insert(joined.end(), some.begin(), some.end());
    }
    return joined;
  }();
  return all;
}

const CaseSource* find_case_source(std::string_view name) {
  const auto found = std::find_if(case_sources().begin(), case_sources().end(),
                                  [&](const CaseSource& source) { return source.name == name; });
  return found == case_sources().end() ? nullptr : &*found;
}

Case ChosenSource::make(std::uint64_t seed) const { return source->make(severity_of(seed), seed); }

int ChosenSource::severity_of(std::uint64_t seed) const {
  if (severity || !source->severities) return severity.value_or(0);
  Random random(~seed);  // not the random numbers that make the case
  return static_cast<int>(random.integer(0, source->severities->highest));
}

std::string ChosenSource::name() const {
  return std::string(source->name) + (severity ? "@" + std::to_string(*severity) : "");
}

std::uint64_t ChosenSource::hash() const {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char letter : name()) {
    sum = (sum ^ static_cast<unsigned char>(letter)) * 0x100000001b3;
  }
  return sum;
}

Level ChosenSource::level() const {
  if (!source->severities) return source->level;
  return source->severities->level_of(severity.value_or(source->severities->highest));
}

const ChosenSource& chosen_by(std::span<const ChosenSource> sources, std::uint64_t number) {
  const ChosenSource* chosen = nullptr;
  std::uint64_t heaviest = 0;
  for (const ChosenSource& source : sources) {
    const std::uint64_t weight = Random(number ^ source.hash()).bits();
    if (chosen == nullptr || weight > heaviest) {
      chosen = &source;
      heaviest = weight;
    }
  }
  return *chosen;
}

ChosenSource chosen_source(std::string_view name) {
  const std::size_t at = std::min(name.find('@'), name.size());
  const std::string source_name(name.substr(0, at));
  const CaseSource* const source = find_case_source(source_name);
  if (source == nullptr) {
    throw std::invalid_argument("no source of cases is called '" + source_name + "'");
  }
  if (at == name.size()) return {source};
  if (!source->severities) {
    throw std::invalid_argument("'" + source_name + "' has no severities to choose from");
  }
  const std::string_view digits = name.substr(at + 1);
  const char* const end = digits.data() + digits.size();
  int severity = -1;
  const auto [last, error] = std::from_chars(digits.data(), end, severity);
  if (error != std::errc{} || last != end || severity < 0 ||
      severity > source->severities->highest) {
    throw std::invalid_argument("severities of '" + source_name + "' are 0 to " +
                                std::to_string(source->severities->highest) + ", not '" +
                                std::string(digits) + "'");
  }
  return {source, severity};
}

}  // namespace raycheck::properties
