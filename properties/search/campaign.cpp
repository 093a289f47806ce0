#include "properties/search/campaign.h"

#include <rapidcheck/Random.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <stdexcept>

#include "properties/case.h"
#include "properties/cases/random.h"
#include "properties/cases/shrink.h"
#include "scene/interruption.h"

namespace raycheck::properties {
namespace {

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
  // What a candidate lacks is left out wherever the case lies.
  const bool judged =
      trials.of(law).is_judged(law.quantity) || !what_is_missing(law.needs, trials.of(law)).empty();
  return {judged, trials.gave_rays(), judged ? trials.apply(law) : Verdict(law.name)};
}

bool fails_always(const Verdict& verdict) {
  const std::vector<Discrepancy> worst = verdict.worst(1);
  return !worst.empty() && worst.front().failed.blame == Blame::kAnything;
}

/// A law judged on a candidate, case after case, until one breaks it.
class LawSearch {
 public:
  LawSearch(const Law& law, const Candidate& candidate, std::optional<double> max_error,
            bool strict)
      : law_(law), candidate_(candidate), max_error_(max_error), strict_(strict) {}

  CampaignPart part;
  std::optional<Failure> failure;

  /// Judges random cases of a source, as RapidCheck draws them: one stream per case, split off a
  /// common one.
  void run(const ChosenSource& source, int cases, std::uint64_t seed, const RunControl& control) {
    part.source = source;
    rc::Random all(Random(seed ^ source.hash()).bits());
    until_interrupted([&] {
      for (int k = 0; k < cases && !failure && !control.interrupted(); ++k) {
        rc::Random one = all.split();
        judge_seed(one.split().next());
      }
    });
  }
  /// Judges one case of a source, and shrinks it.
  void replay(const ChosenSource& source, std::uint64_t seed) {
    part.source = source;
    until_interrupted([&] {
      judge_seed(seed);
      shrink();
    });
  }
  /// Shrinks one case of a source that is undecided, as far as it still is.
  void replay_undecided(const ChosenSource& source, std::uint64_t seed) {
    part.source = source;
    const auto look = [&](const Case& one) {
      if (!is_of_format(one.scene, candidate_.input_format())) return false;
      Verdict verdict = verdict_on(law_, candidate_, one, max_error_).verdict;
      if (verdict.count(Standing::kUndecided) == 0) return false;
      failure = Failure{one, std::move(verdict), replay_of(seed), true};
      return true;
    };
    until_interrupted([&] {
      const auto rounded = rounded_case(source.make(seed), candidate_.input_format()).the_case;
      if (rounded && look(*rounded)) shrink_while(look);
    });
  }
  /// Judges a case, and shrinks it.
  void replay(Case the_case) {
    until_interrupted([&] {
      judge(rounded_case(std::move(the_case), candidate_.input_format()));
      shrink();
    });
  }

 private:
  template <class Work>
  void until_interrupted(const Work& work) {
    try {
      work();
    } catch (const scene::Interrupted&) {
      // The cases judged before that count.
    }
    if (!strict_) part.undecided = part.verdict.undecided();
  }

  void judge_seed(std::uint64_t seed) {
    const std::uint64_t undecided = part.verdict.count(Standing::kUndecided);
    judge(rounded_case(part.source.make(seed), candidate_.input_format()));
    if (!part.undecided_seed && part.verdict.count(Standing::kUndecided) > undecided) {
      part.undecided_seed = seed;
    }
    if (failure) part.replay = failure->replay = replay_of(seed);
  }

  std::string replay_of(std::uint64_t seed) const {
    char digits[17] = {};
    std::to_chars(digits, digits + 16, seed, 16);
    return std::string(law_.name) + ":" + candidate_.name + ":" + part.source.name() + ":" + digits;
  }

  void judge(const RoundedCase& rounded) {
    if (rounded.the_case) {
      breaks(*rounded.the_case);
      return;
    }
    ++part.counts.cases;
    ++part.counts.left_out;
    part.counts.reason = rounded.reason;
  }

  /// Whether a case breaks the law; counts those before the first that does.
  bool breaks(const Case& the_case) {
    auto [judged, given, verdict] = verdict_on(law_, candidate_, the_case, max_error_);
    const bool is_shrinking = failure.has_value();
    if (!is_shrinking) count(judged, given, verdict);
    if (verdict.holds(strict_)) return false;
    // Failing whatever is asked says nothing about a simpler case.
    if (is_shrinking && fails_always(verdict)) return false;
    if (!is_shrinking) {
      part.defects = verdict.defects(strict_);
      part.failed_at = verdict.failed_at(strict_);
    }
    failure = Failure{the_case, std::move(verdict), part.replay};
    return true;
  }

  void count(bool judged, bool given, const Verdict& verdict) {
    ++part.counts.cases;
    part.counts.given_rays += given ? 1 : 0;
    part.counts.not_judged += judged ? 0 : 1;
    if (!verdict.reason_left_out().empty() && verdict.compared() == 0) {
      ++part.counts.left_out;
      part.counts.reason = verdict.reason_left_out();
    }
    part.verdict.merge(verdict);
  }

  /// Goes on from the case that breaks the law to the first simpler one that does, too, and so on
  /// until none does.
  void shrink() {
    if (!failure) return;
    take_failed_question();
    shrink_while([this](const Case& simpler) {
      return is_of_format(simpler.scene, candidate_.input_format()) && breaks(simpler);
    });
  }

  /// `breaks` keeps a case for which it is true as the failure. Who makes no rays needs no camera:
  /// the rays that it was given take its place.
  template <class Breaks>
  void shrink_while(const Breaks& breaks) {
    const auto shrink_on = [&] {
      smallest(failure->shrunk, std::numeric_limits<int>::max(), breaks);
    };
    shrink_on();
    const Case& shrunk = failure->shrunk;
    if (!shrunk.scene.camera || candidate_.pixel_rays || candidate_.focal_rays) return;
    const auto conventions = candidate_.declared.over(shrunk.scene.conventions);
    const bool was_given = verdict_on(law_, candidate_, shrunk, max_error_).given_rays;
    const auto given = was_given ? given_rays(shrunk, conventions, candidate_.precision)
                                 : std::optional<GivenRays>();
    if (given && breaks(given->the_case)) shrink_on();
  }

  /// If the candidate fails on the case, the question in it that it fails on: found by halving,
  /// since each simpler case could run into the time limit for a reply.
  void take_failed_question() {
    const std::vector<Discrepancy> worst = failure->verdict.worst(1);
    const bool has_failed = !worst.empty() && worst.front().wrong == Wrong::kFailed;
    if (!has_failed || fails_always(failure->verdict)) return;
    FailureSearch search;
    const Verdict verdict =
        verdict_on(law_, candidate_, failure->shrunk, max_error_, &search).verdict;
    for (Discrepancy& one : verdict.worst(kKeptDiscrepancies)) {
      if (one.failed.blame != Blame::kQuestion) continue;
      failure->shrunk = {*one.failed.scene, {}};
      if (one.failed.scene->camera) {
        failure->shrunk.pixels = {one.place.pixel.value()};
      } else {
        one.place = {0, {}, one.place.sphere ? std::optional<std::size_t>(0) : std::nullopt};
      }
      failure->verdict = Verdict(law_.name);
      failure->verdict.add(one);
      return;
    }
  }

  const Law& law_;
  const Candidate& candidate_;
  std::optional<double> max_error_;
  bool strict_;
};

CampaignPart run_part(const Law& law, const Candidate& candidate, const CampaignOptions& options,
                      const std::pair<ChosenSource, int>& share, const RunControl& control) {
  LawSearch search(law, candidate, options.max_error, options.strict);
  search.run(share.first, share.second, options.seed, control);
  return std::move(search.part);
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
  const auto rounded = rounded_case(the_case, candidate.input_format()).the_case;
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
  if ((failure && !failure->is_undecided) ||
      std::any_of(parts.begin(), parts.end(),
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
  std::vector<ChosenSource> any;
  for (const CampaignPart& part : result.parts) {
    if (part.source.level() <= lowest) any.push_back(part.source);
  }
  if (broken.empty() || broken.size() == any.size()) return cases;
  for (std::size_t k = 0; k < most; ++k) {
    cases.push_back(any[k * any.size() / most].make(Random(k + 1).bits()));
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
      CampaignPart part = run_part(law, candidate, options, {severities[k], cases}, control);
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
    const std::uint64_t seed = parse_replay(first->replay).seed;
    LawSearch search(law, candidate, options.max_error, options.strict);
    search.replay(first->source, seed);
    result.failure = std::move(search.failure);
    if (!result.failure) {  // interrupted before it was judged again
      result.failure = Failure{first->source.make(seed), first->verdict, first->replay};
    }
    return result;
  }
  for (const CampaignPart& part : result.parts) {
    if (!part.undecided_seed || result.finding() != Finding::kUndecided) continue;
    LawSearch search(law, candidate, options.max_error, options.strict);
    search.replay_undecided(part.source, *part.undecided_seed);
    result.failure = std::move(search.failure);
    break;
  }
  return result;
}

Replay parse_replay(std::string_view text) {
  // A candidate's name may have colons.
  const std::size_t first = text.find(':'), last = text.rfind(':');
  const std::size_t middle = last == 0 ? last : text.rfind(':', last - 1);
  if (last == std::string_view::npos || middle <= first) {
    throw std::invalid_argument("a replay string is LAW:CANDIDATE:SOURCE:SEED, not '" +
                                std::string(text) + "'");
  }
  const std::string_view law = text.substr(0, first), seed = text.substr(last + 1);
  Replay replay{find_law(law), std::string(text.substr(first + 1, middle - first - 1)), {}, 0};
  if (replay.law == nullptr) {
    throw std::invalid_argument("no law is called '" + std::string(law) + "'");
  }
  replay.source = chosen_source(text.substr(middle + 1, last - middle - 1));
  const char* const end = seed.data() + seed.size();
  const auto [past, error] = std::from_chars(seed.data(), end, replay.seed, 16);
  if (error != std::errc{} || past != end) {
    throw std::invalid_argument("'" + std::string(seed) + "' is not a hexadecimal seed");
  }
  return replay;
}

namespace {

CampaignResult result_of(LawSearch& search) {
  CampaignResult result;
  result.fewest_right = 0;
  result.counts = search.part.counts;
  result.verdict = search.part.verdict;
  result.failure = std::move(search.failure);
  return result;
}

}  // namespace

CampaignResult run_case(const Law& law, const Candidate& candidate, const Case& the_case,
                        std::optional<double> max_error, bool strict) {
  LawSearch search(law, candidate, max_error, strict);
  search.replay(the_case);
  CampaignResult result = result_of(search);
  const std::string& left_out = result.verdict.reason_left_out();
  if (!left_out.empty()) result.counts.reason = left_out;
  return result;
}

CampaignResult run_replay(const Replay& replay, const Candidate& candidate,
                          std::optional<double> max_error, bool strict) {
  LawSearch search(*replay.law, candidate, max_error, strict);
  search.replay(replay.source, replay.seed);
  CampaignResult result = result_of(search);
  result.level = replay.source.level();
  result.parts.push_back(std::move(search.part));
  return result;
}

}  // namespace raycheck::properties
