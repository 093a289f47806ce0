#include "tools/check/verify.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "properties/laws/law.h"
#include "scene/interruption.h"
#include "scene/number.h"
#include "scene/text.h"
#include "tools/check/generate.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::HitAnswer;
using properties::Law;
using properties::SphereHits;
using properties::Trial;

/// What a line says of the question that it names.
struct Answer {
  std::uint64_t line = 0;
  std::optional<HitAnswer> hit;
};
using Answers = std::unordered_map<std::string, Answer>;

/// Quotes a line in an error.
std::string quoted_line(std::string_view text) {
  return fmt::format("'{}'", scene::visible_line(text));
}

/// A number in a format: the decimals of a float name it, not a double.
double number(std::string_view text, scene::Precision precision) {
  const auto value = scene::parse_number(text);
  if (!value) throw std::invalid_argument(quoted_line(text) + " is not a number");
  return scene::rounded_to(precision, *value);
}

void read_answer(const std::string& text, std::uint64_t line, scene::Precision precision,
                 Answers& answers) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(std::move(word));
  if (words.empty()) return;
  Answer answer{line, {}};
  if (words.size() == 5) {
    const auto at = [&](std::size_t k) { return number(words[k], precision); };
    answer.hit = HitAnswer{at(1), {at(2), at(3), at(4)}};
  } else if (words.size() != 2 || words[1] != "miss") {
    throw std::invalid_argument("an answer is 'ID miss' or 'ID S X Y Z'");
  }
  if (!answers.emplace(words.front(), answer).second) {
    throw std::invalid_argument("it is answered twice");
  }
}

Answers read_answers(std::string text, scene::Precision precision) {
  Answers answers;
  std::istringstream lines(std::move(text));
  std::uint64_t number = 1;
  for (std::string line; std::getline(lines, line); ++number) {
    try {
      read_answer(line, number, precision, answers);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("line {}: {}", number, error.what()));
    }
  }
  return answers;
}

/// The answers to one case, by ray and sphere.
using CaseAnswers = std::map<std::pair<std::size_t, std::size_t>, std::optional<HitAnswer>>;

/// A candidate that repeats the recorded answers.
Candidate recorded(const CaseAnswers& answered, scene::Precision precision) {
  Candidate result;
  result.name = "the answers";
  result.max_error = candidate_of(kDefaultMethods).max_error;
  result.refuses = false;
  result.intersect = [&answered](Candidate::Rays rays, Candidate::Spheres spheres,
                                 const scene::Conventions&) {
    std::vector<SphereHits> lists(spheres.size());
    for (std::size_t sphere = 0; sphere < spheres.size(); ++sphere) {
      for (std::size_t ray = 0; ray < rays.size(); ++ray) {
        const auto found = answered.find({ray, sphere});
        if (found == answered.end()) {
          throw std::runtime_error(fmt::format("ray {}, sphere {}: not answered", ray, sphere));
        }
        if (found->second) lists[sphere].push_back({ray, *found->second});
      }
    }
    return lists;
  };
  return judged_in(precision, std::move(result));
}

/// The laws of single values per ray and sphere: answers hold nothing for the others.
bool is_answered(const Law& law) { return law.judges_values && law.per == properties::Per::kPair; }

void judge(const Case& asked, const CaseAnswers& answered, std::uint64_t number,
           const VerifyOptions& options, properties::Verdict& verdict) {
  const Candidate candidate = recorded(answered, options.precision);
  Trial trial(asked, candidate, {.max_error = options.max_error});
  properties::Verdict all;
  for (const Law& law : properties::laws()) {
    if (is_answered(law)) all.merge(apply(law, trial));
  }
  all.shift_rays(number * kMostRays);
  verdict.merge(std::move(all));
}

/// Takes the answers to the n-th case, and judges them.
void take_case(std::uint64_t number, Answers& answers, VerifyReport& report) {
  const VerifyOptions& options = report.options;
  const auto asked = case_asked(options.source, options.seed + number, options.precision);
  if (!asked) {
    ++report.cases_left_out;
    return;
  }
  CaseAnswers answered;
  for (const auto& [id, ray, sphere] : questions_of(*asked, report.case_id(number))) {
    if (const auto answer = answers.extract(id)) {
      answered.emplace(std::pair(ray, sphere), answer.mapped().hit);
    } else if (++report.not_answered <= kNamedMissing) {
      report.missing.push_back(id);
    }
  }
  if (answered.empty()) return;
  ++report.cases;
  report.answers += answered.size();
  judge(*asked, answered, number, options, report.candidate.verdict);
}

void require_all_taken(const Answers& answers, const VerifyReport& report) {
  const auto first =
      std::min_element(answers.begin(), answers.end(),
                       [](const auto& a, const auto& b) { return a.second.line < b.second.line; });
  if (first == answers.end()) return;
  throw std::invalid_argument(fmt::format(
      "line {}: {} was not asked: the cases are {} to {}", first->second.line,
      quoted_line(first->first), report.case_id(0), report.case_id(report.options.cases - 1)));
}

}  // namespace

std::string VerifyReport::case_id(std::uint64_t number) const {
  return tools::case_id(options.source, options.seed + number);
}

std::string VerifyReport::ray_id(std::size_t ray) const {
  return fmt::format("{}:{}", case_id(ray / kMostRays), ray_in_case(ray));
}

VerifyReport verify(std::string text, const VerifyOptions& options,
                    const properties::RunControl& control) {
  const scene::Interruptible interruptible(control.interrupted);
  VerifyReport report;
  report.options = options;
  report.candidate.name = "the answers";
  report.candidate.precision = options.precision;
  try {
    Answers answers = read_answers(std::move(text), options.precision);
    for (std::uint64_t number = 0; number < options.cases; ++number) {
      scene::poll();
      take_case(number, answers, report);
    }
    require_all_taken(answers, report);
  } catch (const scene::Interrupted&) {
    report.interrupted = true;
  }
  return report;
}

}  // namespace raycheck::tools
