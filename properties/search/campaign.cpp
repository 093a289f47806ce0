#include "properties/search/campaign.h"

#include <rapidcheck.h>
#include <rapidcheck/detail/TestListenerAdapter.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <ostream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "properties/cases/case_text.h"
#include "properties/cases/random.h"
#include "properties/cases/shrink.h"

namespace raycheck::properties {
namespace {

/// Where a generated case came from.
struct Provenance {
  ChosenSource source;
  std::uint64_t seed = 0;
};

/// Cases of a source by seeds that choose() draws, shrunk by simpler() where they are to be; notes
/// where the last one came from.
template <class Choose>
rc::Gen<Case> generator(const ChosenSource& source, bool shrinks, Choose choose,
                        Provenance& noted) {
  return [=, &noted](const rc::Random& random, int) {
    rc::Random stream = random;
    noted = {source, choose(stream)};
    Case made = source.make(noted.seed);
    if (!shrinks) return rc::shrinkable::just(std::move(made));
    return rc::shrinkable::shrinkRecur(
        std::move(made), [](const Case& from) { return rc::seq::fromContainer(simpler(from)); });
  };
}

std::string replay_text(const Law& law, const Candidate& candidate, const Provenance& from) {
  char digits[17] = {};
  std::to_chars(digits, digits + 16, from.seed, 16);
  return std::string(law.name) + ":" + candidate.name + ":" + from.source.name() + ":" + digits;
}

/// How one source is asked.
struct Asking {
  ChosenSource source;
  int cases = 0;
  std::uint64_t seed = 0;  ///< Of the campaign.
  std::optional<double> max_error;
  bool strict = false;
  bool shrinks = false;
};

struct Answer {
  CampaignPart part;
  std::optional<Failure> failure;
};

/// Judges cases until one breaks the law, and shrinks that where it is to be.
template <class Choose>
Answer ask(const Law& law, const Candidate& candidate, const Asking& asking,
           const RunControl& control, Choose choose) {
  Answer answer;
  CampaignPart& part = answer.part;
  part.source = asking.source;
  Provenance noted;
  const rc::Gen<Case> cases = generator(asking.source, asking.shrinks, choose, noted);
  bool stopped = false;
  const auto property = [&] {
    if (stopped || (stopped = control.interrupted())) return;
    const Case the_case = *cases;
    Trial trial(the_case, candidate, {.max_error = asking.max_error});
    const bool judged = trial.is_judged(law.quantity);
    Verdict verdict = judged ? apply(law, trial) : Verdict(law.name);
    if (!answer.failure) {  // what follows a failure is shrinking
      ++part.counts.cases;
      part.counts.not_judged += judged ? 0 : 1;
      if (!verdict.reason_left_out().empty() && verdict.compared() == 0) {
        ++part.counts.left_out;
        part.counts.reason = verdict.reason_left_out();
      }
      part.verdict.merge(verdict);
    }
    if (verdict.holds(asking.strict)) return;
    part.replay = replay_text(law, candidate, noted);
    answer.failure = Failure{the_case, std::move(verdict), part.replay};
    RC_FAIL("");
  };
  rc::detail::TestParams params;
  params.seed = Random(asking.seed ^ asking.source.hash()).bits();
  params.maxSuccess = asking.cases;
  rc::detail::TestMetadata metadata;
  metadata.id = std::string(law.name);
  rc::detail::TestListenerAdapter silent;
  // With a map of its own RapidCheck neither reads the environment nor prints its configuration.
  const std::unordered_map<std::string, rc::detail::Reproduce> nothing_to_reproduce;
  const auto outcome =
      rc::detail::checkTestable(property, metadata, params, silent, nothing_to_reproduce);
  rc::detail::Error error;
  if (outcome.match(error)) throw std::runtime_error("RapidCheck: " + error.description);
  return answer;
}

CampaignPart run_part(const Law& law, const Candidate& candidate, const Asking& asking,
                      const RunControl& control) {
  return ask(law, candidate, asking, control, [](rc::Random& random) { return random.next(); })
      .part;
}

/// The case of a replay alone.
Answer ask_again(const Replay& replay, const Candidate& candidate, std::optional<double> max_error,
                 bool strict) {
  const Asking once = {replay.source, 1, 0, max_error, strict, true};
  return ask(*replay.law, candidate, once, {}, [seed = replay.seed](rc::Random&) { return seed; });
}

/// The k-th share of what is shared evenly, but for a remainder.
int share_of_all(int all, std::size_t shares, std::size_t k) {
  const int among = static_cast<int>(shares);
  return all / among + (static_cast<int>(k) < all % among ? 1 : 0);
}

/// The sources that a law is asked on, each with its share of the cases.
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

void CaseCounts::add(const CaseCounts& other) {
  cases += other.cases;
  left_out += other.left_out;
  not_judged += other.not_judged;
  if (!other.reason.empty()) reason = other.reason;
}

Finding CampaignResult::finding() const {
  if (std::any_of(parts.begin(), parts.end(),
                  [](const CampaignPart& part) { return part.is_broken(); })) {
    return Finding::kBroken;
  }
  if (verdict.compared() == 0 && !too_few_right()) {
    return counts.not_judged > 0 ? Finding::kNotJudged : Finding::kLeftOut;
  }
  if (verdict.count(Standing::kUndecided) > 0) return Finding::kUndecided;
  return too_few_right() ? Finding::kTooFewJudged : Finding::kHolds;
}

CampaignResult run_campaign(const Law& law, const Candidate& candidate,
                            const CampaignOptions& options, const RunControl& control) {
  CampaignResult result;
  result.level = options.level;
  const auto shares = shared_out(law, options);
  if (shares.empty()) result.counts.reason = "no source of cases has a camera";
  for (const auto& [source, share] : shares) {
    const auto severities = severities_of(source, options.level, share);
    for (std::size_t k = 0; k < severities.size(); ++k) {
      const int cases = share_of_all(share, severities.size(), k);
      CampaignPart part = run_part(
          law, candidate, {severities[k], cases, options.seed, options.max_error, options.strict},
          control);
      if (part.counts.cases == 0) return result;  // interrupted
      result.level = std::max(result.level, part.source.level());
      result.counts.add(part.counts);
      result.verdict.merge(part.verdict);
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
  }
  return result;
}

std::vector<Reach> reaches(const Law& law, const Candidate& candidate,
                           const CampaignOptions& options, const RunControl& control) {
  std::vector<Reach> found;
  for (const auto& [source, share] : shared_out(law, options)) {
    if (source.severity || !source.source->dial) continue;
    const Dial& dial = *source.source->dial;
    const int last = dial.highest_of(options.level);
    std::vector<ChosenSource> severities = severities_of(source, options.level, share);
    const int cases = std::max(kFewestOfReach, share_of_all(share, severities.size(), 0));
    if (last < dial.highest) {
      for (const int severity : some_severities(last + 1, dial.highest)) {
        severities.push_back({source.source, severity});
      }
    }
    Reach reach{source.source, {}, {}, {}};
    for (const ChosenSource& severity : severities) {
      const CampaignPart part =
          run_part(law, candidate,
                   {severity, cases, options.seed, options.max_error, options.strict}, control);
      if (part.counts.cases == 0) return found;  // interrupted
      if (part.is_broken()) {
        reach.broken_at = severity.severity;
        reach.replay = part.replay;
        break;
      }
      if (part.verdict.compared() > 0) reach.holds_to = severity.severity;
    }
    found.push_back(std::move(reach));
  }
  return found;
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

CampaignResult run_replay(const Replay& replay, const Candidate& candidate,
                          std::optional<double> max_error, bool strict) {
  Answer answer = ask_again(replay, candidate, max_error, strict);
  CampaignResult result;
  result.fewest_right = 0;
  result.level = replay.source.level();
  result.counts = answer.part.counts;
  result.verdict = answer.part.verdict;
  result.parts.push_back(std::move(answer.part));
  result.failure = std::move(answer.failure);
  return result;
}

void showValue(const Case& the_case, std::ostream& out) { out << scene_text(the_case); }

}  // namespace raycheck::properties
