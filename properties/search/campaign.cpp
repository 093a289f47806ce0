#include "properties/search/campaign.h"

#include <rapidcheck/Random.h>

#include <algorithm>
#include <charconv>
#include <compare>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>

#include "properties/case.h"
#include "properties/cases/random.h"
#include "properties/search/law_search.h"
#include "scene/interruption.h"

namespace raycheck::properties {
namespace {

/// The k-th share of `all`, split evenly up to a remainder.
int share_of_all(int all, std::size_t shares, std::size_t k) {
  const int among = static_cast<int>(shares);
  return all / among + (static_cast<int>(k) < all % among ? 1 : 0);
}

/// The severities of a source up to a level, at most one for each case.
std::vector<ChosenSource> severities_of(const ChosenSource& chosen, Level level, int cases) {
  if (chosen.severity || !chosen.source->severities) return {chosen};
  std::vector<ChosenSource> severities;
  const int last = chosen.source->severities->highest_of(level);
  for (const int severity : some_severities(0, last, std::min(cases, kMostSeverities))) {
    severities.push_back({chosen.source, severity});
  }
  return severities;
}

/// A source and severity (0 if it has none) on which a law is tried, and the source's index among
/// all.
struct SeriesKey {
  std::size_t place;
  int severity;
  auto operator<=>(const SeriesKey&) const = default;
};
struct SeriesCases {
  ChosenSource source;
  int cases = 0;
};
using CasesOfLaw = std::map<SeriesKey, SeriesCases>;

/// Divides cases evenly among the sources of a level that suit a law, and a source's cases among
/// its severities. A series never gets fewer cases than it has.
void share_out(const Law& law, const CampaignOptions& options, Level level, CasesOfLaw& given) {
  std::vector<std::pair<std::size_t, ChosenSource>> sources;
  const auto add = [&](std::size_t place, const ChosenSource& chosen) {
    if (is_about_cameras(law) && !chosen.source->has_camera) return;
    sources.emplace_back(place, chosen);
  };
  for (std::size_t k = 0; k < options.sources.size(); ++k) add(k, options.sources[k]);
  const auto all = case_sources();
  for (std::size_t k = 0; options.sources.empty() && k < all.size(); ++k) {
    if (all[k].severities || all[k].level <= level) add(k, {&all[k]});
  }
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const auto& [place, source] = sources[k];
    const int share = std::max(1, share_of_all(options.cases, sources.size(), k));
    const auto severities = severities_of(source, level, share);
    for (std::size_t at = 0; at < severities.size(); ++at) {
      SeriesCases& its = given[{place, severities[at].severity.value_or(0)}];
      its.source = severities[at];
      its.cases = std::max(its.cases, share_of_all(share, severities.size(), at));
    }
  }
}

/// The cases of every level up to the chosen one, so that no level is easier than the one before
/// it.
CasesOfLaw cases_of(const Law& law, const CampaignOptions& options) {
  CasesOfLaw given;
  for (int level = 0; level <= static_cast<int>(options.level); ++level) {
    share_out(law, options, static_cast<Level>(level), given);
  }
  return given;
}

void lower(std::atomic<std::size_t>& unit, std::size_t to) {
  std::size_t known = unit;
  while (to < known && !unit.compare_exchange_weak(known, to)) {
  }
}

/// The seed of the streams of kUnitCases cases: a function of the series' seed and the number of
/// cases before.
std::uint64_t stream_of(std::uint64_t seed, int before) {
  const std::uint64_t first = Random(seed).bits();
  return before == 0 ? first : Random(first + static_cast<std::uint64_t>(before)).bits();
}

/// A case of a source. It is made once and rounded once for each format; it has one truth for each
/// set of conventions, and one set of answers of a candidate for all laws.
class AskedCase {
 public:
  /// `turn`: see TrialOptions.
  AskedCase(const ChosenSource& source, std::uint64_t seed, std::uint64_t turn)
      : seed_(seed), turn_(turn), made_(source.make(seed)) {}

  /// To be called for all searches of a candidate in succession, because they share its trials.
  void judge(LawSearch& search, const Candidate& candidate, std::optional<double> max_error) {
    Rounded& rounded = in(candidate.input_format());
    if (&candidate != candidate_) {
      candidate_ = &candidate;
      trials_.reset();
      const auto& the_case = rounded.rounded.the_case;
      if (the_case && is_problem(*the_case, candidate.declared)) {
        const auto conventions = candidate.declared.over(the_case->scene.conventions);
        trials_.emplace(*the_case, candidate,
                        TrialOptions{.max_error = max_error,
                                     .truth = rounded.truths->under(
                                         conventions, candidate.interface.from_inside),
                                     .turn = turn_});
      }
    }
    search.judge(seed_, rounded.rounded, trials_ ? &*trials_ : nullptr);
  }

 private:
  struct Rounded {
    RoundedCase rounded;
    std::optional<SharedTruths> truths;
  };

  Rounded& in(InputFormat format) {
    auto& kept = formats_[format];
    if (!kept) {
      kept = std::make_unique<Rounded>(Rounded{rounded_case(made_, format), {}});
      if (kept->rounded.the_case) kept->truths.emplace(*kept->rounded.the_case);
    }
    return *kept;
  }

  std::uint64_t seed_, turn_;
  Case made_;
  ByFormat<std::unique_ptr<Rounded>> formats_;
  const Candidate* candidate_ = nullptr;
  std::optional<Trials> trials_;
};

CampaignResult result_of(LawSearch& search) {
  CampaignResult result;
  result.fewest_right = 0;
  result.counts = search.part.counts;
  result.verdict = search.part.verdict;
  result.failure = std::move(search.failure);
  return result;
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

bool CampaignPart::is_new(const std::vector<DefectKind>& defects) const {
  return std::none_of(breaks.begin(), breaks.end(),
                      [&](const Break& known) { return known.defects == defects; });
}

void CampaignPart::merge(CampaignPart later) {
  counts.add(later.counts);
  verdict.merge(std::move(later.verdict));
  for (Break& one : later.breaks) {
    if (is_new(one.defects)) breaks.push_back(std::move(one));
  }
  failed_at_once = false;
  if (!undecided_seed) undecided_seed = later.undecided_seed;
  undecided.insert(undecided.end(), later.undecided.begin(), later.undecided.end());
  std::sort(undecided.begin(), undecided.end());
  undecided.erase(std::unique(undecided.begin(), undecided.end()), undecided.end());
}

void CampaignPart::close(bool strict) {
  if (!strict) undecided = verdict.undecided();
  verdict.drop_discrepancies();
}

Finding CampaignResult::finding() const {
  if ((failure && !failure->is_undecided) ||
      std::any_of(parts.begin(), parts.end(),
                  [](const CampaignPart& part) { return part.is_broken(); })) {
    return Finding::kBroken;
  }
  if (verdict.compared() == 0 && !too_few_right()) {
    return counts.not_judged > counts.left_out ? Finding::kNotJudged : Finding::kLeftOut;
  }
  if (verdict.count(Standing::kUndecided) * kComparisonsOfUndecided > verdict.compared()) {
    return Finding::kUndecided;
  }
  return too_few_right() ? Finding::kTooFewJudged : Finding::kHolds;
}

std::vector<Case> telling_cases(const CampaignResult& result, std::size_t most, std::size_t round) {
  const auto has_wrong_answer = [](const CampaignPart& part) {
    return part.is_broken() &&
           std::any_of(part.breaks.front().defects.begin(), part.breaks.front().defects.end(),
                       [](const DefectKind& kind) { return kind.wrong != Wrong::kFailed; });
  };
  std::set<Level> levels;
  for (const CampaignPart& part : result.parts) {
    if (has_wrong_answer(part)) levels.insert(part.source.level());
  }
  if (round >= 2 * levels.size()) return {};
  const Level level = *std::next(levels.begin(), static_cast<std::ptrdiff_t>(round / 2));
  if (round % 2 == 1) most *= 4;
  std::vector<std::pair<ChosenSource, std::uint64_t>> broken;
  for (const CampaignPart& part : result.parts) {
    if (!has_wrong_answer(part) || part.source.level() != level) continue;
    broken.emplace_back(part.source, parse_replay(part.breaks.front().replay).seed);
  }
  std::vector<Case> cases;
  while (!broken.empty() && cases.size() < most) {
    auto& [source, seed] = broken[cases.size() % broken.size()];
    cases.push_back(source.make(seed));
    seed = Random(seed).bits();
  }
  std::vector<ChosenSource> any;
  for (const CampaignPart& part : result.parts) {
    if (part.source.level() <= level) any.push_back(part.source);
  }
  if (broken.empty() || broken.size() == any.size()) return cases;
  for (std::size_t k = 0; k < most; ++k) {
    cases.push_back(any[k * any.size() / most].make(Random(k + 1).bits()));
  }
  return cases;
}

std::vector<ChosenSource> sources_of(const Law& law, const CampaignOptions& options) {
  std::vector<ChosenSource> sources;
  for (const auto& [key, its] : cases_of(law, options)) sources.push_back(its.source);
  return sources;
}

Campaigns::Campaigns(std::vector<LawsOfCandidate> of_candidates, bool units_are_kept)
    : candidates_(of_candidates.size()), units_are_kept_(units_are_kept) {
  std::map<SeriesKey, Series> all;
  for (std::size_t candidate = 0; candidate < candidates_.size(); ++candidate) {
    auto& [laws, options] = candidates_[candidate].asked = std::move(of_candidates[candidate]);
    for (std::size_t law = 0; law < laws.size(); ++law) {
      CampaignResult& result = candidates_[candidate].results.emplace_back();
      result.level = options.level;
      const CasesOfLaw series = cases_of(*laws[law], options);
      if (series.empty())
        result.counts.reason = "the law needs cameras, and no source that was chosen has one";
      for (const auto& [key, its] : series) {
        all[key].source = its.source;
        all[key].tried.emplace_back(candidate, law, its.cases);
      }
    }
  }
  for (auto& [key, series] : all) series_.push_back(std::move(series));
  std::int64_t pieces = 0;
  for (const Series& series : series_) pieces += (series.most() - 1) / kUnitCases + 1;
  unit_cases_ = static_cast<int>(kUnitCases * pieces_of_unit(pieces));
  for (Series& series : series_) {
    series.first_unit = unit_count_;
    unit_count_ += static_cast<std::size_t>((series.most() - 1) / unit_cases_ + 1);
  }
}

Campaigns::Unit Campaigns::unit(std::size_t number) const {
  const auto after = std::ranges::upper_bound(series_, number, {}, &Series::first_unit);
  const Series& series = *std::prev(after);
  return {series, static_cast<int>(number - series.first_unit)};
}

std::vector<CampaignPart> Campaigns::run(std::size_t number, std::span<const Candidate> candidates,
                                         const RunControl& control) const {
  const Unit here = unit(number);
  const Series& series = here.series;
  std::vector<LawSearch> searches;
  for (const Tried& tried : series.tried) {
    const auto& [laws, options] = candidates_[tried.candidate].asked;
    searches.emplace_back(*laws[tried.law], candidates[tried.candidate], options, series.source);
  }
  const auto is_over = [&](std::size_t k) {
    const OfCandidate& its = candidates_[series.tried[k].candidate];
    if (!units_are_kept_ && its.is_dropped) return true;
    if (its.asked.options.keep_going > 1) return false;
    return searches[k].part.is_broken() || (!units_are_kept_ && series.tried[k].broken_in < number);
  };
  const std::uint64_t seed = candidates_.front().asked.options.seed ^ series.source.hash();
  const int first = here.number * unit_cases_;
  for (const Candidate& candidate : candidates) candidate.begin_anew();
  rc::Random random;
  try {
    for (int k = 0; k < unit_cases_ && !control.interrupted(); ++k) {
      const int at = first + k;
      if (k % kUnitCases == 0) random = rc::Random(stream_of(seed, at / kUnitCases));
      rc::Random one = random.split();
      std::optional<AskedCase> asked;
      for (std::size_t law = 0; law < searches.size(); ++law) {
        const Tried& tried = series.tried[law];
        if (at >= tried.cases || is_over(law)) continue;
        if (!asked) {
          asked.emplace(series.source, one.split().next(),
                        series.source.hash() + static_cast<std::uint64_t>(at));
        }
        asked->judge(searches[law], candidates[tried.candidate],
                     candidates_[tried.candidate].asked.options.max_error);
      }
    }
  } catch (const scene::Interrupted&) {
    // The cases judged before the interrupt count.
  }
  std::vector<CampaignPart> parts;
  for (std::size_t k = 0; k < searches.size(); ++k) {
    CampaignPart& part = searches[k].part;
    if (part.is_broken()) lower(series.tried[k].broken_in, number);
    part.close(candidates_[series.tried[k].candidate].asked.options.strict);
    parts.push_back(std::move(part));
  }
  return parts;
}

void Campaigns::take(std::size_t number, std::vector<CampaignPart> parts) {
  const auto [series, in_series] = unit(number);
  struct InUnit {
    bool fails = false, answers = false, timed_out = false;
  };
  std::vector<InUnit> seen(candidates_.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Tried& tried = series.tried[k];
    OfCandidate& its = candidates_[tried.candidate];
    if (its.is_dropped || parts[k].counts.cases == 0) continue;
    CampaignResult& result = its.results[tried.law];
    const bool goes_on =
        in_series > 0 && !result.parts.empty() && result.parts.back().source == series.source;
    if (goes_on && result.parts.back().is_broken() && its.asked.options.keep_going <= 1) continue;
    // Only of parts that count: which others were tried depends on threads.
    auto& [fails, answers, timed_out] = seen[tried.candidate];
    timed_out |= parts[k].timed_out;
    fails |= parts[k].failed_at_once;
    answers |= !parts[k].failed_at_once && parts[k].verdict.compared() > 0;
    result.counts.add(parts[k].counts);
    result.verdict.merge(parts[k].verdict);
    parts[k].verdict.keep_counts();
    if (goes_on) {
      result.parts.back().merge(std::move(parts[k]));
      continue;
    }
    result.level = std::max(result.level, series.source.level());
    result.parts.push_back(std::move(parts[k]));
    result.parts.back().source = series.source;
  }
  for (std::size_t k = 0; k < seen.size(); ++k) {
    OfCandidate& its = candidates_[k];
    its.has_answered |= seen[k].answers;
    its.units_failed += seen[k].fails && !its.has_answered;
    its.units_timed_out += seen[k].timed_out;
    // Each request without a reply takes the whole time limit.
    const std::size_t most_timed_out = its.has_answered ? kUnitsToFail : 1;
    its.is_dropped = its.answers_nothing() || its.units_timed_out >= most_timed_out;
  }
}

CampaignResult Campaigns::finished(std::size_t number, std::size_t law,
                                   const Candidate& candidate) {
  OfCandidate& its = candidates_[number];
  const CampaignOptions& options = its.asked.options;
  const Law& asked = *its.asked.laws[law];
  CampaignResult result = std::move(its.results[law]);
  const auto& declared = candidate.declared.valid;
  result.wants_hits = declared && !declared->is_usual();
  // Empty if a candidate that timed out answers when it is asked again.
  const auto shrunk = [&](const CampaignPart& part, const Break& broken) -> std::optional<Failure> {
    const std::uint64_t seed = parse_replay(broken.replay).seed;
    LawSearch search(asked, candidate, options, part.source);
    search.replay(seed, !its.answers_nothing());
    if (search.failure) {
      search.judge_restarted();
      return *std::move(search.failure);
    }
    const bool has_failed = std::ranges::all_of(
        broken.defects, [](const DefectKind& kind) { return kind.wrong == Wrong::kFailed; });
    if (!search.interrupted && part.timed_out && has_failed) return std::nullopt;
    return Failure{.shrunk = part.source.make(seed),
                   .verdict = part.verdict,
                   .replay = broken.replay,
                   .is_of_earlier = !search.interrupted,
                   .is_shrunk = false};
  };
  std::vector<CampaignPart*> broken;
  for (CampaignPart& part : result.parts) {
    if (part.is_broken()) broken.push_back(&part);
  }
  std::stable_sort(broken.begin(), broken.end(), [](const auto* a, const auto* b) {
    return a->source.level() < b->source.level();
  });
  std::set<std::pair<const CaseSource*, std::vector<DefectKind>>> known;
  for (CampaignPart* part : broken) {
    std::erase_if(part->breaks, [&](const Break& one) {
      if (known.size() >= options.keep_going) return false;
      std::optional<Failure> failure = shrunk(*part, one);
      if (!failure) {
        ++result.counts.left_out;
        result.counts.reason = "the candidate timed out, but answers when it is asked again";
        return true;
      }
      if (!known.emplace(part->source.source, failure->verdict.defects(options.strict)).second) {
        return false;
      }
      if (result.failure) {
        result.others.push_back(*std::move(failure));
      } else {
        result.failure = std::move(failure);
      }
      return false;
    });
  }
  if (result.failure) return result;
  for (const CampaignPart& part : result.parts) {
    if (!part.undecided_seed || result.finding() != Finding::kUndecided) continue;
    LawSearch search(asked, candidate, options, part.source);
    search.replay_undecided(*part.undecided_seed);
    result.failure = std::move(search.failure);
    break;
  }
  return result;
}

CampaignResult run_campaign(const Law& law, const Candidate& candidate,
                            const CampaignOptions& options, const RunControl& control) {
  const scene::Interruptible interruptible(control.interrupted);
  Campaigns campaigns({{{&law}, options}});
  for (std::size_t unit = 0; unit < campaigns.unit_count(); ++unit) {
    campaigns.take(unit, campaigns.run(unit, {&candidate, 1}, control));
  }
  return campaigns.finished(0, 0, candidate);
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

CampaignResult run_case(const Law& law, const Candidate& candidate, const Case& the_case,
                        std::optional<double> max_error, bool strict) {
  const CampaignOptions options{.max_error = max_error, .strict = strict};
  LawSearch search(law, candidate, options, {});
  search.replay(the_case);
  CampaignResult result = result_of(search);
  const std::string& left_out = result.verdict.reason_left_out();
  if (!left_out.empty()) result.counts.reason = left_out;
  return result;
}

CampaignResult run_replay(const Replay& replay, const Candidate& candidate,
                          std::optional<double> max_error, bool strict) {
  const CampaignOptions options{.max_error = max_error, .strict = strict};
  LawSearch search(*replay.law, candidate, options, replay.source);
  search.replay(replay.seed);
  CampaignResult result = result_of(search);
  result.level = replay.source.level();
  result.parts.push_back(std::move(search.part));
  return result;
}

}  // namespace raycheck::properties
