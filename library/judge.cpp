#include <fmt/core.h>
#include <raycheck/judge.h>

#include <stdexcept>

#include "library/conversions.h"
#include "properties/laws/law.h"
#include "properties/mistakes/causes.h"
#include "properties/search/campaign.h"
#include "scene/validate.h"
#include "tools/report/words.h"

namespace raycheck {
namespace {

using properties::CampaignResult;

/// The number of cases of a source that are searched for one to which a law applies.
constexpr std::uint64_t kTriedSeeds = 8;

const properties::Law& law_of(const std::string& name) {
  if (const properties::Law* const law = properties::find_law(name)) return *law;
  throw std::invalid_argument(
      fmt::format("law {}: unknown name; raycheck::laws() has all names", name));
}

/// Whether the source has a case to which the law applies, for this candidate.
bool has_case(const properties::Law& law, const properties::ChosenSource& source,
              const properties::Candidate& candidate) {
  for (std::uint64_t seed = 0; seed < kTriedSeeds; ++seed) {
    if (has_question(law, candidate, source.make(seed))) return true;
  }
  return false;
}

std::string counts_text(const Verdict& verdict) {
  std::string text = fmt::format("{}, {}", tools::count_text(verdict.cases, "case"),
                                 tools::count_text(verdict.comparisons, "comparison"));
  if (verdict.excused > 0) text += fmt::format(", {} excused", verdict.excused);
  return text;
}

std::string text_of(const Verdict& verdict, const properties::Law& law) {
  std::string text = fmt::format("{}: {} {} ({})\n", verdict.law, verdict.candidate,
                                 name(verdict.finding), counts_text(verdict));
  if (!verdict.reason.empty()) text += fmt::format("  {}\n", verdict.reason);
  if (!verdict.broken) return text;
  const BrokenCase& broken = *verdict.broken;
  std::string causes;
  for (const std::string& cause : broken.sentences) causes += cause + "\n";
  return text + tools::indented(tools::broken_law_text(law.sentence, broken.discrepancy, causes,
                                                       broken.replay, scene_text(broken.shrunk)),
                                "  ");
}

std::string reason_of(const CampaignResult& result) {
  const auto few = result.too_few_right();
  if (result.finding() != properties::Finding::kTooFewJudged || !few) return result.counts.reason;
  return fmt::format("{}: fewer than {} of the {} are answered right without an excuse",
                     info(few->first).name, result.fewest_right, tools::expected_text(few->second));
}

properties::TellingCases telling_of(const CampaignResult& result) {
  return [&result](std::size_t round) {
    return telling_cases(result, properties::kCasesOfACause, round);
  };
}

Verdict verdict_of(const CampaignResult& result, const properties::Law& law,
                   const properties::Candidate& candidate,
                   const properties::TellingCases& telling) {
  Verdict verdict;
  verdict.law = law.name;
  verdict.candidate = candidate.name;
  verdict.finding = static_cast<Finding>(result.finding());
  verdict.cases = static_cast<std::uint64_t>(result.counts.cases);
  verdict.comparisons = result.verdict.compared();
  verdict.excused = result.verdict.count(properties::Standing::kExcused);
  verdict.reason = reason_of(result);
  if (result.failure) {
    BrokenCase& broken = verdict.broken.emplace();
    broken.shrunk = library::case_of(result.failure->shrunk);
    broken.replay = result.failure->replay;
    for (const auto& worst : result.failure->verdict.worst(1)) {
      broken.discrepancy = tools::discrepancy_text(worst, false);
    }
    for (const properties::Explanation& one : properties::causes(law, telling, candidate)) {
      broken.sentences.push_back(one.sentence);
    }
  }
  verdict.text = text_of(verdict, law);
  return verdict;
}

static_assert(static_cast<std::size_t>(Finding::left_out) ==
              static_cast<std::size_t>(properties::Finding::kLeftOut));

}  // namespace

std::string name(Finding finding) {
  return std::string(properties::name(static_cast<properties::Finding>(finding)));
}

std::vector<Law> laws() {
  std::vector<Law> all;
  for (const properties::Law& law : properties::laws()) {
    all.push_back({std::string(law.name), std::string(law.sentence)});
  }
  return all;
}

std::vector<Check> checks(const Candidate& candidate) {
  const properties::Candidate inside = in_random_cases(library::inside(candidate));
  std::vector<Check> all;
  for (const properties::Law& law : properties::laws()) {
    for (const properties::CaseSource& source : properties::case_sources()) {
      if (is_about_cameras(law) && !source.has_camera) continue;
      if (!source.severities && source.level > inside.level) continue;
      if (!has_case(law, {&source, source.severities ? std::optional(0) : std::nullopt}, inside)) {
        continue;
      }
      all.push_back({std::string(law.name), std::string(source.name)});
    }
  }
  return all;
}

namespace {

Verdict judged(const properties::Candidate& candidate, const std::string& law_name,
               const std::string& source, const JudgeOptions& options) {
  const properties::Law& law = law_of(law_name);
  const properties::Candidate inside = in_random_cases(candidate);
  properties::CampaignOptions asked;
  if (options.cases < 1) {
    throw std::invalid_argument(fmt::format("cases = {}: must be at least 1", options.cases));
  }
  if (options.max_error && !(*options.max_error >= 0)) {
    throw std::invalid_argument(
        fmt::format("max_error = {}: must be 0 or more", *options.max_error));
  }
  asked.cases = options.cases;
  asked.seed = options.seed;
  asked.max_error = options.max_error;
  asked.strict = options.strict;
  asked.level = inside.level;
  if (!source.empty()) {
    try {
      asked.sources = {properties::chosen_source(source)};
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("source {}: {}", source, error.what()));
    }
  }
  const CampaignResult result = run_campaign(law, inside, asked);
  return verdict_of(result, law, inside, telling_of(result));
}

}  // namespace

Verdict judge(const Candidate& candidate, const std::string& law, const std::string& source,
              const JudgeOptions& options) {
  return judged(library::inside(candidate), law, source, options);
}

Verdict judge(const Candidate& candidate, const IntersectBatch& intersect, const std::string& law,
              const std::string& source, const JudgeOptions& options) {
  return judged(library::inside(candidate, &intersect), law, source, options);
}

Verdict judge_case(const Candidate& candidate, const std::string& law_name, const Case& the_case,
                   const JudgeOptions& options) {
  const properties::Law& law = law_of(law_name);
  const properties::Candidate inside = library::inside(candidate);
  const properties::Case asked = library::case_of(the_case);
  const CampaignResult result = run_case(law, inside, asked, options.max_error, options.strict);
  const auto telling = [&](std::size_t round) {
    return round == 0 ? std::vector{asked} : std::vector<properties::Case>();
  };
  return verdict_of(result, law, inside, telling);
}

Verdict replay(const Candidate& candidate, const std::string& text, const JudgeOptions& options) {
  const properties::Replay parsed = properties::parse_replay(text);
  const properties::Candidate inside = in_random_cases(library::inside(candidate));
  const CampaignResult result = run_replay(parsed, inside, options.max_error, options.strict);
  return verdict_of(result, *parsed.law, inside, telling_of(result));
}

}  // namespace raycheck
