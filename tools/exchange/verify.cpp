#include "tools/exchange/verify.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <istream>
#include <map>
#include <stdexcept>
#include <utility>

#include "properties/laws/law.h"
#include "scene/number.h"
#include "tools/exchange/generate.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::HitAnswer;
using properties::Law;
using properties::SphereHits;
using properties::Trial;

/// The answers to one case, by ray and sphere.
struct AnsweredCase {
  properties::ChosenSource source;
  std::uint64_t seed = 0;
  std::size_t rays = 0, spheres = 0;
  std::map<std::pair<std::size_t, std::size_t>, std::optional<HitAnswer>> hits;
};

std::vector<std::string_view> split(std::string_view text, std::string_view at) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find_first_of(at);
    if (const auto part = text.substr(0, end); !part.empty()) parts.push_back(part);
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

template <class Integer>
Integer integer(std::string_view text, int base) {
  Integer value = 0;
  const auto [at, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc() || at != text.data() + text.size()) {
    throw std::invalid_argument(fmt::format("'{}' is not a whole number", text));
  }
  return value;
}

double number(std::string_view text) {
  const auto value = scene::parse_number(text);
  if (!value) throw std::invalid_argument(fmt::format("'{}' is not a number", text));
  return *value;
}

using Cases = std::vector<AnsweredCase>;

/// Adds the answer of a line to the case that its id names.
void read_answer(std::string_view line, Cases& cases, std::map<std::string, std::size_t>& known) {
  const auto found = split(line, " \t\r");
  const auto id = split(found.front(), ":");
  if (id.size() != 4) {
    throw std::invalid_argument(
        fmt::format("'{}' is no id, which is SOURCE:SEED:RAY:SPHERE", found.front()));
  }
  const std::string name = fmt::format("{}:{}", id[0], id[1]);
  const auto [at, is_new] = known.try_emplace(name, cases.size());
  if (is_new) {
    AnsweredCase& added = cases.emplace_back();
    added.source = properties::chosen_source(id[0]);
    added.seed = integer<std::uint64_t>(id[1], 16);
    if (added.source.source->has_camera) {
      throw std::invalid_argument(fmt::format("the cases of '{}' have cameras", id[0]));
    }
    const scene::Scene scene = added.source.make(added.seed).scene;
    added.rays = scene.rays.size();
    added.spheres = scene.spheres.size();
  }
  std::optional<HitAnswer> hit;
  if (found.size() == 5) {
    hit = HitAnswer{number(found[1]), {number(found[2]), number(found[3]), number(found[4])}};
  } else if (found.size() != 2 || found[1] != "miss") {
    throw std::invalid_argument("an answer is 'ID miss' or 'ID S X Y Z'");
  }
  const std::pair place(integer<std::size_t>(id[2], 10), integer<std::size_t>(id[3], 10));
  const AnsweredCase& of = cases[at->second];
  if (place.first >= of.rays || place.second >= of.spheres) {
    throw std::invalid_argument(fmt::format("there is no such question: '{}'", found.front()));
  }
  if (!cases[at->second].hits.emplace(place, hit).second) {
    throw std::invalid_argument("it is answered twice");
  }
}

/// A candidate that says again what was answered.
Candidate recorded(const AnsweredCase& answered) {
  Candidate candidate = candidate_of(kDefaultMethods);  // for its bounds
  Candidate result;
  result.name = "the answers";
  result.max_error = candidate.max_error;
  result.refuses = false;
  result.intersect = [&answered](Candidate::Rays rays, Candidate::Spheres spheres,
                                 const scene::Conventions&) {
    std::vector<SphereHits> lists(spheres.size());
    for (std::size_t sphere = 0; sphere < spheres.size(); ++sphere) {
      for (std::size_t ray = 0; ray < rays.size(); ++ray) {
        const auto found = answered.hits.find({ray, sphere});
        if (found == answered.hits.end()) {
          throw std::runtime_error(fmt::format("ray {}, sphere {}: not answered", ray, sphere));
        }
        if (found->second) lists[sphere].push_back({ray, *found->second});
      }
    }
    return lists;
  };
  return result;
}

/// The laws of single values for each ray and sphere: what else laws ask is not in the answers.
bool is_answered(const Law& law) { return law.judges_values && law.per == properties::Per::kPair; }

}  // namespace

VerifyReport verify(std::istream& answers, const VerifyOptions& options) {
  VerifyReport report;
  report.top = options.top;
  report.strict = options.strict;
  report.cases_asked = options.cases;
  Cases cases;
  std::map<std::string, std::size_t> known;
  std::uint64_t number = 0;
  for (std::string line; std::getline(answers, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      read_answer(line, cases, known);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("line {}: {}", number, error.what()));
    }
    ++report.answers;
  }
  report.cases = cases.size();
  for (const AnsweredCase& answered : cases) {
    const properties::Case the_case = answered.source.make(answered.seed);
    const Candidate candidate = recorded(answered);
    Trial trial(the_case, candidate, {.max_error = options.max_error});
    const std::size_t first = report.ids.size();
    for (const Law& law : properties::laws()) {
      if (!is_answered(law)) continue;
      properties::Verdict verdict = apply(law, trial);
      verdict.shift_rays(first);
      report.candidate.verdict.merge(std::move(verdict));
    }
    for (std::size_t ray = 0; ray < the_case.scene.rays.size(); ++ray) {
      report.ids.push_back(fmt::format("{}:{}", case_id(answered.source, answered.seed), ray));
    }
  }
  report.candidate.name = "the answers";
  report.candidate.contestant = External{};
  return report;
}

}  // namespace raycheck::tools
