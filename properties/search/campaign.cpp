#include "properties/search/campaign.h"

#include <rapidcheck/Random.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "properties/cases/random.h"
#include "properties/cases/shrink.h"
#include "properties/rounded_case.h"
#include "scene/interruption.h"

namespace raycheck::properties {
namespace {

/// Where a case comes from.
struct Provenance {
  ChosenSource source;
  std::uint64_t seed = 0;
};

std::string replay_text(const Law& law, const Candidate& candidate, const Provenance& from) {
  char digits[17] = {};
  std::to_chars(digits, digits + 16, from.seed, 16);
  return std::string(law.name) + ":" + candidate.name + ":" + from.source.name() + ":" + digits;
}

/// How one source is tried.
struct Asking {
  ChosenSource source;
  int cases = 0;
  std::uint64_t seed = 0;  ///< Of the campaign.
  std::optional<double> max_error;
  bool strict = false;
  bool shrinks = false;
};

struct CampaignAnswer {
  CampaignPart part;
  std::optional<Failure> failure;
};

/// A law's verdict on a case.
struct CaseVerdict {
  bool inside_domain = true;
  bool given_rays = false;
  Verdict verdict;
};

CaseVerdict verdict_on(const Law& law, const Candidate& candidate, const Case& the_case,
                       std::optional<double> max_error, FailureSearch* search = nullptr) {
  if (!is_problem(the_case, candidate.declared)) return {false, false, Verdict(law.name)};
  Trials trials(the_case, candidate, {.max_error = max_error, .search = search});
  const bool judged = trials.of(law).is_judged(law.quantity);
  return {judged, trials.gave_rays(), judged ? trials.apply(law) : Verdict(law.name)};
}

bool fails_in_vain(const Verdict& verdict) {
  const std::vector<Discrepancy> worst = verdict.worst(1);
  return !worst.empty() && worst.front().failed.blame == Blame::kAnything;
}

/// The question within a failed case that a candidate fails on: found by halving, since each
/// simpler case could run into the time limit for a reply.
std::optional<Failure> failed_question(const Law& law, const Candidate& candidate,
                                       const Case& the_case, const Asking& asking,
                                       const Verdict& found) {
  const std::vector<Discrepancy> worst = found.worst(1);
  if (worst.empty() || worst.front().wrong != Wrong::kFailed || fails_in_vain(found)) return {};
  FailureSearch search;
  const Verdict verdict = verdict_on(law, candidate, the_case, asking.max_error, &search).verdict;
  for (Discrepancy& one : verdict.worst(kKeptDiscrepancies)) {
    if (one.failed.blame != Blame::kQuestion) continue;
    Case question{*one.failed.scene, {}};
    if (question.scene.camera) {
      question.pixels = {one.place.pixel.value()};
    } else {
      one.place = {0, {}, one.place.sphere ? std::optional<std::size_t>(0) : std::nullopt};
    }
    Verdict of_question(law.name);
    of_question.add(one);
    return Failure{std::move(question), std::move(of_question), {}};
  }
  return {};
}

/// Judges cases, whose seeds `choose` draws, until one breaks the law, and shrinks that one if
/// wanted: to the first simpler one that fails, too, and so on until none does.
template <class Choose>
CampaignAnswer ask(const Law& law, const Candidate& candidate, const Asking& asking,
                   const RunControl& control, Choose choose) {
  CampaignAnswer answer;
  CampaignPart& part = answer.part;
  part.source = asking.source;
  const auto breaks = [&](const Case& the_case, const Provenance& from) {
    auto [judged, given, verdict] = verdict_on(law, candidate, the_case, asking.max_error);
    if (!answer.failure) {  // after a failure come shrinking steps
      ++part.counts.cases;
      part.counts.given_rays += given ? 1 : 0;
      part.counts.not_judged += judged ? 0 : 1;
      if (!verdict.reason_left_out().empty() && verdict.compared() == 0) {
        ++part.counts.left_out;
        part.counts.reason = verdict.reason_left_out();
      }
      part.verdict.merge(verdict);
    }
    if (verdict.holds(asking.strict)) return false;
    // Failing whatever is asked says nothing about a simpler case.
    if (answer.failure && fails_in_vain(verdict)) return false;
    if (!answer.failure) {
      part.replay = replay_text(law, candidate, from);
      part.defects = verdict.defects(asking.strict);
      part.failed_at = verdict.failed_at(asking.strict);
    }
    answer.failure = Failure{the_case, std::move(verdict), part.replay};
    return true;
  };
  // As RapidCheck draws them: one stream per case, split off a common one.
  rc::Random all(Random(asking.seed ^ asking.source.hash()).bits());
  try {
    for (int k = 0; k < asking.cases && !control.interrupted(); ++k) {
      rc::Random one = all.split();
      const Provenance from = {asking.source, choose(one)};
      auto [failing, reason, changed] =
          rounded_case(asking.source.make(from.seed), candidate.precision);
      if (!failing) {
        ++part.counts.cases;
        ++part.counts.left_out;
        part.counts.reason = std::move(reason);
        continue;
      }
      if (!breaks(*failing, from)) continue;
      const auto fails = [&](const Case& simpler) {
        return !control.interrupted() && is_of_format(simpler.scene, candidate.precision) &&
               breaks(simpler, from);
      };
      if (!asking.shrinks) break;
      if (auto question =
              failed_question(law, candidate, *failing, asking, answer.failure->verdict)) {
        question->replay = part.replay;
        *failing = question->shrunk;
        answer.failure = std::move(question);
      }
      smallest(*std::move(failing), std::numeric_limits<int>::max(), fails);
      break;
    }
  } catch (const scene::Interrupted&) {
    // The cases judged before that count.
  }
  if (!asking.strict) part.undecided = part.verdict.undecided();
  return answer;
}

CampaignPart run_part(const Law& law, const Candidate& candidate, const Asking& asking,
                      const RunControl& control) {
  return ask(law, candidate, asking, control,
             [](rc::Random& stream) { return stream.split().next(); })
      .part;
}

/// The case of a replay alone.
CampaignAnswer ask_again(const Replay& replay, const Candidate& candidate,
                         std::optional<double> max_error, bool strict) {
  const Asking once = {replay.source, 1, 0, max_error, strict, true};
  return ask(*replay.law, candidate, once, {}, [seed = replay.seed](rc::Random&) { return seed; });
}

/// The k-th share of `all`, split evenly up to a remainder.
int share_of_all(int all, std::size_t shares, std::size_t k) {
  const int among = static_cast<int>(shares);
  return all / among + (static_cast<int>(k) < all % among ? 1 : 0);
}

/// The sources that a law is tried on, each with its share of the cases.
std::vector<std::pair<ChosenSource, int>> shared_out(const Law& law,
                                                     const CampaignOptions& options) {
  std::vector<ChosenSource> sources = options.sources;
  if (sources.empty()) {
    for (const CaseSource& source : case_sources()) {
      if (source.dial || source.level <= options.level) sources.push_back({&source});
    }
  }
  std::erase_if(sources, [&](const ChosenSource& chosen) {
    return speaks_of_cameras(law) && !chosen.source->has_camera;
  });
  std::vector<std::pair<ChosenSource, int>> shares;
  for (const ChosenSource& source : sources) {
    const int share = share_of_all(options.cases, sources.size(), shares.size());
    shares.emplace_back(source, std::max(1, share));
  }
  return shares;
}

/// The severities that a source stands for.
std::vector<ChosenSource> severities_of(const ChosenSource& chosen, Level level, int cases) {
  if (chosen.severity || !chosen.source->dial) return {chosen};
  std::vector<ChosenSource> severities;
  const int last = chosen.source->dial->highest_of(level);
  for (const int severity : some_severities(0, last, std::min(cases, kMostSeverities))) {
    severities.push_back({chosen.source, severity});
  }
  return severities;
}

}  // namespace

bool has_question(const Law& law, const Candidate& candidate, const Case& the_case) {
  if (!is_problem(the_case, candidate.declared)) return false;
  const auto rounded = rounded_case(the_case, candidate.precision).the_case;
  if (!rounded) return false;
  return what_is_missing(law.needs, Trials(*rounded, candidate).of(law)).empty();
}

void CaseCounts::add(const CaseCounts& other) {
  cases += other.cases;
  left_out += other.left_out;
  not_judged += other.not_judged;
  given_rays += other.given_rays;
  if (!other.reason.empty()) reason = other.reason;
}

Finding CampaignResult::finding() const {
  if (failure || std::any_of(parts.begin(), parts.end(),
                             [](const CampaignPart& part) { return part.is_broken(); })) {
    return Finding::kBroken;
  }
  if (verdict.compared() == 0 && !too_few_right()) {
    return counts.not_judged > 0 ? Finding::kNotJudged : Finding::kLeftOut;
  }
  if (verdict.count(Standing::kUndecided) > 0) return Finding::kUndecided;
  return too_few_right() ? Finding::kTooFewJudged : Finding::kHolds;
}

std::vector<Case> telling_cases(const CampaignResult& result, std::size_t most) {
  std::vector<std::pair<ChosenSource, std::uint64_t>> broken;
  Level lowest = Level::kExtreme;
  for (const CampaignPart& part : result.parts) {
    if (part.is_broken()) lowest = std::min(lowest, part.source.level());
  }
  for (const CampaignPart& part : result.parts) {
    if (!part.is_broken() || part.source.level() > lowest) continue;
    broken.emplace_back(part.source, parse_replay(part.replay).seed);
  }
  std::vector<Case> cases;
  while (!broken.empty() && cases.size() < most) {
    auto& [source, seed] = broken[cases.size() % broken.size()];
    cases.push_back(source.make(seed));
    seed = Random(seed).bits();
  }
  return cases;
}

CampaignResult run_campaign(const Law& law, const Candidate& candidate,
                            const CampaignOptions& options, const RunControl& control) {
  const scene::Interruptible interruptible(control.interrupted);
  CampaignResult result;
  result.level = options.level;
  const auto& declared = candidate.declared.valid;
  result.wants_hits = declared && !declared->is_usual();
  const auto shares = shared_out(law, options);
  if (shares.empty()) result.counts.reason = "no source of cases has a camera";
  bool stopped = false;
  for (const auto& [source, share] : shares) {
    const auto severities = severities_of(source, options.level, share);
    for (std::size_t k = 0; k < severities.size() && !stopped; ++k) {
      const int cases = share_of_all(share, severities.size(), k);
      CampaignPart part = run_part(
          law, candidate, {severities[k], cases, options.seed, options.max_error, options.strict},
          control);
      stopped = part.counts.cases == 0;  // interrupted
      if (stopped) break;
      result.level = std::max(result.level, part.source.level());
      result.counts.add(part.counts);
      result.verdict.merge(part.verdict);
      part.verdict.keep_counts();
      result.parts.push_back(std::move(part));
    }
  }
  const CampaignPart* first = nullptr;
  for (const CampaignPart& part : result.parts) {
    if (!part.is_broken()) continue;
    if (first == nullptr || part.source.level() < first->source.level()) first = &part;
  }
  if (first != nullptr) {
    Replay replay = parse_replay(first->replay);
    replay.law = &law;
    result.failure = ask_again(replay, candidate, options.max_error, options.strict).failure;
    if (!result.failure) {  // interrupted before it was judged again
      result.failure = Failure{replay.source.make(replay.seed), first->verdict, first->replay};
    }
  }
  return result;
}

Replay parse_replay(std::string_view text) {
  // A candidate's name may have colons.
  const auto wrong = [&] {
    return std::invalid_argument("a replay string is LAW:CANDIDATE:SOURCE:SEED, not '" +
                                 std::string(text) + "'");
  };
  std::array<std::string_view, 4> parts;
  std::string_view rest = text;
  for (const std::size_t part : {std::size_t{3}, std::size_t{2}}) {
    const std::size_t colon = rest.rfind(':');
    if (colon == std::string_view::npos) throw wrong();
    parts[part] = rest.substr(colon + 1);
    rest = rest.substr(0, colon);
  }
  const std::size_t colon = rest.find(':');
  if (colon == std::string_view::npos) throw wrong();
  parts[0] = rest.substr(0, colon);
  parts[1] = rest.substr(colon + 1);
  Replay replay{find_law(parts[0]), std::string(parts[1]), {}, 0};
  if (replay.law == nullptr) {
    throw std::invalid_argument("no law is called '" + std::string(parts[0]) + "'");
  }
  replay.source = chosen_source(parts[2]);
  const char* const end = parts[3].data() + parts[3].size();
  const auto [last, error] = std::from_chars(parts[3].data(), end, replay.seed, 16);
  if (error != std::errc{} || last != end) {
    throw std::invalid_argument("'" + std::string(parts[3]) + "' is not a hexadecimal seed");
  }
  return replay;
}

CampaignResult run_case(const Law& law, const Candidate& candidate, const Case& the_case,
                        std::optional<double> max_error, bool strict) {
  CampaignResult result;
  result.fewest_right = 0;
  const RoundedCase rounded = rounded_case(the_case, candidate.precision);
  if (!rounded.the_case) {
    result.counts = {.cases = 1, .left_out = 1, .reason = rounded.reason};
    return result;
  }
  auto [judged, given, verdict] = verdict_on(law, candidate, *rounded.the_case, max_error);
  result.counts = {1, 0, judged ? 0 : 1, given ? 1 : 0, std::string(verdict.reason_left_out())};
  result.verdict = std::move(verdict);
  if (result.verdict.holds(strict)) return result;
  Failure failure{*rounded.the_case, result.verdict, ""};
  failure.shrunk =
      smallest(*rounded.the_case, std::numeric_limits<int>::max(), [&](const Case& simpler) {
        if (!is_of_format(simpler.scene, candidate.precision)) return false;
        Verdict of_simpler = verdict_on(law, candidate, simpler, max_error).verdict;
        if (of_simpler.holds(strict)) return false;
        failure.verdict = std::move(of_simpler);
        return true;
      });
  result.failure = std::move(failure);
  return result;
}

CampaignResult run_replay(const Replay& replay, const Candidate& candidate,
                          std::optional<double> max_error, bool strict) {
  CampaignAnswer answer = ask_again(replay, candidate, max_error, strict);
  CampaignResult result;
  result.fewest_right = 0;
  result.level = replay.source.level();
  result.counts = answer.part.counts;
  result.verdict = answer.part.verdict;
  result.parts.push_back(std::move(answer.part));
  result.failure = std::move(answer.failure);
  return result;
}

}  // namespace raycheck::properties
