#include "tools/check/verify.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "properties/laws/law.h"
#include "scene/interruption.h"
#include "scene/number.h"
#include "scene/text.h"
#include "tools/check/generate.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::HitAnswer;
using properties::Law;
using properties::SphereHits;
using properties::Trial;

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (;;) {
    const std::size_t end = line.find_first_of(" \t\r");
    if (const auto word = line.substr(0, end); !word.empty()) words.push_back(word);
    if (end == std::string_view::npos) return words;
    line.remove_prefix(end + 1);
  }
}

/// Quotes a line in an error.
std::string quoted(std::string_view text) { return fmt::format("'{}'", scene::visible_line(text)); }

/// A number in a format: the decimals of a float name it, not a double.
double number(std::string_view text, scene::Precision precision) {
  const auto value = scene::parse_number(text);
  if (!value) throw std::invalid_argument(quoted(text) + " is not a number");
  return scene::rounded_to(precision, *value);
}

/// What a line answers to a question; empty: a miss.
std::optional<HitAnswer> answer_of(std::string_view line, const std::string& id,
                                   scene::Precision precision) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.front() != id) {
    throw std::invalid_argument(
        fmt::format("{} is no answer to {}, which is the next question: questions are answered in "
                    "their order, each once",
                    quoted(words.front()), id));
  }
  if (words.size() == 2 && words[1] == "miss") return std::nullopt;
  if (words.size() != 5) throw std::invalid_argument("an answer is 'ID miss' or 'ID S X Y Z'");
  const auto at = [&](std::size_t k) { return number(words[k], precision); };
  return HitAnswer{at(1), {at(2), at(3), at(4)}};
}

/// The lines of a text that is read in blocks.
class Lines {
 public:
  explicit Lines(const ReadMore& more) : more_(more) {}

  /// The next line that is not blank, which lasts until the next call; empty at the end.
  std::optional<std::string_view> next() {
    for (;;) {
      const auto line = any();
      if (!line || line->find_first_not_of(" \t\r") != std::string::npos) return line;
    }
  }
  std::uint64_t number() const { return number_; }

 private:
  std::optional<std::string_view> any() {
    for (;;) {
      const std::size_t end = text_.find('\n', begin_);
      if (end != std::string::npos || (is_over_ && begin_ < text_.size())) {
        const std::string_view line = std::string_view(text_).substr(begin_, end - begin_);
        begin_ = end == std::string::npos ? text_.size() : end + 1;
        ++number_;
        return line;
      }
      if (is_over_) return std::nullopt;
      text_.erase(0, begin_);
      begin_ = 0;
      if (text_.size() > kMostLineBytes) {
        ++number_;
        throw std::invalid_argument(fmt::format("is longer than {} bytes", kMostLineBytes));
      }
      const std::string part = more_();
      is_over_ = part.empty();
      text_ += part;
    }
  }

  const ReadMore& more_;
  std::string text_;
  std::size_t begin_ = 0;
  bool is_over_ = false;
  std::uint64_t number_ = 0;
};

/// A candidate that says again what was answered to a case.
Candidate recorded(const std::vector<SphereHits>& answered, scene::Precision precision) {
  Candidate result;
  result.name = "the answers";
  result.max_error = candidate_of(kDefaultMethods).max_error;
  result.refuses = false;
  result.intersect = [&answered](Candidate::Rays, Candidate::Spheres, const scene::Conventions&) {
    return answered;
  };
  return judged_in(precision, std::move(result));
}

/// The answers to every ray and sphere of a case; empty where they end before, as the report says.
std::optional<std::vector<SphereHits>> read_case(Lines& lines, const properties::Case& asked,
                                                 const std::string& id, VerifyReport& report) {
  std::vector<SphereHits> answered(asked.scene.spheres.size());
  for (std::size_t ray = 0; ray < asked.scene.rays.size(); ++ray) {
    for (std::size_t sphere = 0; sphere < answered.size(); ++sphere) {
      const std::string question = question_id(id, ray, sphere);
      const auto line = lines.next();
      if (!line) {
        report.ends_before = question;
        return std::nullopt;
      }
      const auto hit = answer_of(*line, question, report.candidate.precision);
      if (hit) answered[sphere].push_back({ray, *hit});
      ++report.answers;
    }
  }
  return answered;
}

/// By the laws of single values for each ray and sphere: what else laws ask is not in the answers.
properties::Verdict verdict_on(const properties::Case& asked,
                               const std::vector<SphereHits>& answered,
                               const VerifyOptions& options) {
  const Candidate candidate = recorded(answered, options.precision);
  Trial trial(asked, candidate, {.max_error = options.max_error});
  properties::Verdict all;
  for (const Law& law : properties::laws()) {
    if (law.judges_values && law.per == properties::Per::kPair) all.merge(apply(law, trial));
  }
  return all;
}

void judge_all(Lines& lines, const VerifyOptions& options, VerifyReport& report) {
  for (std::uint64_t number = 0; number < options.cases; ++number) {
    scene::poll();
    const std::uint64_t seed = options.seed + number;
    const auto asked = case_asked(options.source, seed, options.precision);
    if (!asked) {
      ++report.cases_left_out;
      continue;
    }
    const auto answered = read_case(lines, *asked, case_id(options.source, seed), report);
    if (!answered) return;
    properties::Verdict verdict = verdict_on(*asked, *answered, options);
    verdict.shift_rays(number * kMostRays);
    report.candidate.verdict.merge(std::move(verdict));
    ++report.cases;
  }
  if (const auto line = lines.next()) {
    throw std::invalid_argument(quoted(words_of(*line).front()) +
                                " answers nothing: every question has its answer");
  }
}

}  // namespace

std::string VerifyReport::ray_id(std::size_t ray) const {
  return fmt::format("{}:{}", case_id(source, seed + ray / kMostRays), ray_in_case(ray));
}

VerifyReport verify(const ReadMore& answers, const VerifyOptions& options,
                    const properties::RunControl& control) {
  const scene::Interruptible interruptible(control.interrupted);
  VerifyReport report;
  report.source = options.source;
  report.seed = options.seed;
  report.top = options.top;
  report.strict = options.strict;
  report.cases_asked = options.cases;
  report.candidate.name = "the answers";
  report.candidate.precision = options.precision;
  Lines lines(answers);
  try {
    judge_all(lines, options, report);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("line {}: {}", lines.number(), error.what()));
  } catch (const scene::Interrupted&) {
    report.interrupted = true;
  }
  return report;
}

}  // namespace raycheck::tools
