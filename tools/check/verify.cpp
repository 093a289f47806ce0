#include "tools/check/verify.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <map>
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

/// The answers to one case, by ray and sphere.
struct AnsweredCase {
  explicit AnsweredCase(properties::Case its_case) : the_case(std::move(its_case)) {}

  std::size_t rays() const { return the_case.scene.rays.size(); }
  std::size_t spheres() const { return the_case.scene.spheres.size(); }
  bool is_whole() const { return hits.size() == rays() * spheres(); }

  properties::Case the_case;
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

/// Quotes a line in an error.
std::string quoted(std::string_view text) { return fmt::format("'{}'", scene::visible_line(text)); }

template <class Integer>
Integer integer(std::string_view text, int base) {
  Integer value = 0;
  const auto [at, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc() || at != text.data() + text.size()) {
    throw std::invalid_argument(quoted(text) + " is not a whole number");
  }
  return value;
}

/// A number in a format: the decimals of a float name it, not a double.
double number(std::string_view text, scene::Precision precision) {
  const auto value = scene::parse_number(text);
  if (!value) throw std::invalid_argument(quoted(text) + " is not a number");
  return scene::rounded_to(precision, *value);
}

/// What a line says.
struct Answer {
  std::string_view id;
  std::string_view source, seed, ray, sphere;  ///< The parts of the id.
  std::optional<HitAnswer> hit;
};

Answer parse_answer(std::string_view line, scene::Precision precision) {
  const auto found = split(line, " \t\r");
  Answer answer;
  answer.id = found.front();
  const auto id = split(answer.id, ":");
  if (id.size() != 4) {
    throw std::invalid_argument(quoted(answer.id) + " is no id, which is SOURCE:SEED:RAY:SPHERE");
  }
  answer.source = id[0];
  answer.seed = id[1];
  answer.ray = id[2];
  answer.sphere = id[3];
  if (found.size() == 5) {
    const auto at = [&](std::size_t k) { return number(found[k], precision); };
    answer.hit = HitAnswer{at(1), {at(2), at(3), at(4)}};
  } else if (found.size() != 2 || found[1] != "miss") {
    throw std::invalid_argument("an answer is 'ID miss' or 'ID S X Y Z'");
  }
  return answer;
}

/// The lines of a text that is read in blocks.
class Lines {
 public:
  explicit Lines(const ReadMore& more) : more_(more) {}

  /// The next line, valid until the next call; empty at the end.
  std::optional<std::string_view> next() {
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
  std::uint64_t number() const { return number_; }

 private:
  const ReadMore& more_;
  std::string text_;
  std::size_t begin_ = 0;
  bool is_over_ = false;
  std::uint64_t number_ = 0;
};

/// A candidate that repeats the recorded answers.
Candidate recorded(const AnsweredCase& answered, scene::Precision precision) {
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
  return judged_in(precision, std::move(result));
}

/// The laws of single values per ray and sphere: answers hold nothing for the others.
bool is_answered(const Law& law) { return law.judges_values && law.per == properties::Per::kPair; }

/// Judges answers as they arrive.
class Verification {
 public:
  explicit Verification(const VerifyOptions& options) : options_(options) {
    report_.source = options.source;
    report_.seed = options.seed;
    report_.top = options.top;
    report_.strict = options.strict;
    report_.cases_asked = options.cases;
    report_.candidate.precision = options.precision;
  }

  void read(std::string_view line) {
    const Answer answer = parse_answer(line, options_.precision);
    const std::uint64_t number = integer<std::uint64_t>(answer.seed, 16) - options_.seed;
    const std::pair place(integer<std::size_t>(answer.ray, 10),
                          integer<std::size_t>(answer.sphere, 10));
    if (number >= options_.cases ||
        answer.id != fmt::format("{}:{}:{}", id(number), place.first, place.second)) {
      throw std::invalid_argument(fmt::format("{} was not asked: the cases are {} to {}",
                                              quoted(answer.id), id(0), id(options_.cases - 1)));
    }
    if (number < judged_.size() && judged_[number]) {
      throw std::invalid_argument("it is answered twice");
    }
    auto at = open_.find(number);
    if (at == open_.end()) {
      auto asked = case_asked(options_.source, seed(number), options_.precision);
      if (!asked) {
        throw std::invalid_argument("unknown question: " + quoted(answer.id));
      }
      at = open_.emplace(number, AnsweredCase(*std::move(asked))).first;
      ++report_.cases;
    }
    AnsweredCase& of = at->second;
    if (place.first >= of.rays() || place.second >= of.spheres()) {
      throw std::invalid_argument("unknown question: " + quoted(answer.id));
    }
    if (!of.hits.emplace(place, answer.hit).second) {
      throw std::invalid_argument("it is answered twice");
    }
    ++report_.answers;
    if (++waiting_ > kMostWaiting) {
      throw std::invalid_argument(fmt::format(
          "{} answers wait for the rest of their cases; print the answers to a case together",
          kMostWaiting));
    }
    if (!of.is_whole()) return;
    judge(number, of);
    if (judged_.size() <= number) judged_.resize(number + 1);
    judged_[number] = true;
    waiting_ -= of.hits.size();
    open_.erase(at);
  }

  /// Cases still open lack some of their answers.
  VerifyReport finish(bool interrupted) {
    report_.interrupted = interrupted;
    if (!interrupted) {
      for (const auto& [number, answered] : open_) {
        judge(number, answered);
        name_missing(number, answered);
      }
      count_cases_missing();
    }
    report_.candidate.name = "the answers";
    return std::move(report_);
  }

 private:
  std::uint64_t seed(std::uint64_t number) const { return options_.seed + number; }
  std::string id(std::uint64_t number) const { return case_id(options_.source, seed(number)); }

  void count_cases_missing() {
    const bool may_ask_nothing = options_.precision != scene::Precision::kDouble;
    for (std::uint64_t number = 0; number < options_.cases; ++number) {
      if (report_.cases + report_.cases_left_out == options_.cases) break;
      if (!may_ask_nothing && report_.cases_missing.size() == kNamedMissing) break;
      const bool is_judged = number < judged_.size() && judged_[number];
      if (is_judged || open_.contains(number)) continue;
      scene::poll();
      if (may_ask_nothing && !case_asked(options_.source, seed(number), options_.precision)) {
        ++report_.cases_left_out;
      } else if (report_.cases_missing.size() < kNamedMissing) {
        report_.cases_missing.push_back(id(number));
      }
    }
  }

  void judge(std::uint64_t number, const AnsweredCase& answered) {
    const Candidate candidate = recorded(answered, options_.precision);
    Trial trial(answered.the_case, candidate, {.max_error = options_.max_error});
    properties::Verdict all;
    for (const Law& law : properties::laws()) {
      if (is_answered(law)) all.merge(apply(law, trial));
    }
    all.shift_rays(number * kMostRays);
    report_.candidate.verdict.merge(std::move(all));
  }

  void name_missing(std::uint64_t number, const AnsweredCase& answered) {
    for (std::size_t ray = 0; ray < answered.rays(); ++ray) {
      for (std::size_t sphere = 0; sphere < answered.spheres(); ++sphere) {
        if (answered.hits.contains({ray, sphere})) continue;
        ++report_.questions_missing;
        if (report_.questions_named.size() < kNamedMissing) {
          report_.questions_named.push_back(fmt::format("{}:{}:{}", id(number), ray, sphere));
        }
      }
    }
  }

  const VerifyOptions& options_;
  VerifyReport report_;
  std::map<std::uint64_t, AnsweredCase> open_;  ///< Cases with some questions still unanswered.
  std::size_t waiting_ = 0;                     ///< Their answers.
  std::vector<bool> judged_;
};

}  // namespace

std::string VerifyReport::ray_id(std::size_t ray) const {
  return fmt::format("{}:{}", case_id(source, seed + ray / kMostRays), ray_in_case(ray));
}

VerifyReport verify(const ReadMore& answers, const VerifyOptions& options,
                    const properties::RunControl& control) {
  const scene::Interruptible interruptible(control.interrupted);
  Verification verification(options);
  Lines lines(answers);
  try {
    while (const auto line = lines.next()) {
      if (line->find_first_not_of(" \t\r") != std::string::npos) verification.read(*line);
    }
    return verification.finish(false);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("line {}: {}", lines.number(), error.what()));
  } catch (const scene::Interrupted&) {
    return verification.finish(true);
  }
}

}  // namespace raycheck::tools
