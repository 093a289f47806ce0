#include "tools/properties/properties.h"

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

#include "properties/mistakes/causes.h"
#include "scene/interruption.h"
#include "scene/invalid_input.h"
#include "tools/implementations/built_in.h"
#include "tools/shards/run_units.h"

namespace raycheck::tools {
namespace {

using properties::CampaignOptions;
using properties::Candidate;
using properties::Law;

std::vector<const Law*> filtered_laws(const std::vector<std::string>& filters) {
  std::vector<const Law*> found;
  std::vector<bool> has_laws(filters.size());
  for (const Law& law : properties::laws()) {
    bool is_named = filters.empty();
    for (std::size_t k = 0; k < filters.size(); ++k) {
      if (law.name.find(filters[k]) == std::string_view::npos) continue;
      has_laws[k] = is_named = true;
    }
    if (is_named) found.push_back(&law);
  }
  for (std::size_t k = 0; k < filters.size(); ++k) {
    if (has_laws[k]) continue;
    throw scene::InvalidInput("filter", filters[k],
                              "no law's name contains it; `raycheck list` shows the laws");
  }
  return found;
}

/// Whether a law may give another result on this pair than on one already tried. Laws of the camera
/// do not depend on the intersection method, and laws of the intersection hardly on the ray method.
bool is_worth_asking(const Law& law, const Implementation& implementation, bool chosen_by_user) {
  if (chosen_by_user || !implementation.methods) return true;
  const MethodPair& pair = *implementation.methods;
  if (is_about_cameras(law) == is_about_intersections(law)) return true;
  return is_about_cameras(law) ? pair.intersect == kDefaultMethods.intersect
                               : pair.rays == kDefaultMethods.rays;
}

/// A candidate for campaigns. Renderers do not get the conventions of a random case, so they are
/// judged by the defaults and by those that they declare, and not at tangents.
Candidate campaigner(const Implementation& implementation) {
  Candidate candidate = in_random_cases(implementation.make());
  if (candidate.image) {
    candidate.declared = candidate.declared.over(properties::DeclaredConventions{
        scene::Rows{}, scene::Samples{}, scene::Origin{}, scene::Root{}, scene::Tangent::kEither,
        scene::ValidRoots{}});
  }
  return candidate;
}

CampaignReport report_of(const Law& law, const Implementation& implementation,
                         const Candidate& candidate, const std::string& lasting_name,
                         properties::CampaignResult result, const PropertiesOptions& options) {
  CampaignReport report = {&law, candidate.name, lasting_name, std::move(result),
                           properties::Finding::kHolds};
  report.finding = report.result.finding();
  report.precision = candidate.precision;
  report.domain = candidate;
  report.implementation = implementation;
  const auto& failure = report.result.failure;
  if (report.keeps_state()) {
    const std::uint64_t wrong = failure->verdict.count(properties::Standing::kDefect);
    report.explanations = {{std::string(properties::kKeepsState), wrong, wrong}};
  } else if (!implementation.methods && report.finding == properties::Finding::kBroken) {
    report.explanations = properties::causes(
        law,
        [&](std::size_t round) {
          return telling_cases(report.result, properties::kCasesOfACause, round);
        },
        candidate);
  }
  if (failure && !failure->is_undecided && !report.keeps_state() &&
      has_ranges(candidate, failure->verdict)) {
    report.ranges = ranges_of(law, candidate, failure->shrunk, options.max_error, options.strict);
  }
  return report;
}

/// Removes explanations of candidates that keep state between questions. They were found by asking
/// about cases again, so they are misleading.
void leave_out_sentences_about_state(std::vector<CampaignReport>& reports) {
  std::set<std::string> keep_state;
  for (const CampaignReport& report : reports) {
    if (report.keeps_state()) keep_state.insert(report.candidate);
  }
  for (CampaignReport& report : reports) {
    if (!report.keeps_state() && keep_state.contains(report.candidate)) report.explanations.clear();
  }
}

/// The result of a unit of campaigns, or of a target.
struct UnitResult {
  std::vector<properties::CampaignPart> parts;
  std::optional<properties::WorstCase> worst;
  template <class Archive>
  void serialize(Archive& archive) {
    archive(parts, worst);
  }
};

/// Reports the progress of a campaign: "12000 cases judged, 3 broken, 4 min left".
class Progress {
 public:
  Progress(std::int64_t units, const properties::RunControl& control)
      : units_(units), control_(control) {}

  void add(const std::vector<properties::CampaignPart>& parts) {
    ++done_;
    for (const properties::CampaignPart& part : parts) {
      cases_ += part.counts.cases;
      broken_ += part.is_broken() ? 1 : 0;
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    const double left =
        passed.count() * static_cast<double>(units_ - done_) / static_cast<double>(done_);
    control_.progress(fmt::format("{} cases judged, {} broken, {}", cases_, broken_,
                                  left < 90 ? fmt::format("{:.0f} s left", left)
                                            : fmt::format("{:.0f} min left", left / 60)));
  }

 private:
  std::int64_t units_, done_ = 0, cases_ = 0, broken_ = 0;
  const properties::RunControl& control_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

properties::Replay parsed_replay(const std::string& text) {
  try {
    return properties::parse_replay(text);
  } catch (const std::invalid_argument& error) {
    throw scene::InvalidInput("replay", "", error.what());
  }
}

PropertiesReport replay(const PropertiesOptions& options) {
  const properties::Replay parsed = parsed_replay(options.replay);
  std::vector<Implementation> known = options.implementations;
  for (const MethodPair& pair : all_pairs()) known.push_back(built_in(pair));
  const std::vector<std::string> names = lasting_names(known);
  for (std::size_t k = 0; k < known.size(); ++k) {
    const Candidate candidate = campaigner(known[k]);
    if (candidate.name != parsed.candidate) continue;
    PropertiesReport report;
    report.cases = 1;
    report.strict = options.strict;
    report.campaigns.push_back(
        report_of(*parsed.law, known[k], candidate, names[k],
                  run_replay(parsed, candidate, options.max_error, options.strict), options));
    return report;
  }
  throw scene::InvalidInput("replay", "", "no candidate is called '" + parsed.candidate + "'");
}

/// Runs the campaigns of all laws and candidates in one pass.
class Study {
 public:
  /// The options must outlive it.
  Study(const PropertiesOptions& options, bool units_are_kept)
      : options_(options),
        is_chosen_(!options.implementations.empty()),
        judged_(is_chosen_ ? options.implementations : built_in(each_method_once())),
        names_(lasting_names(judged_)),
        laws_(filtered_laws(options.filters)),
        candidates_([this] {
          std::vector<Candidate> own;
          for (const Implementation& one : judged_) own.push_back(campaigner(one));
          return own;
        }) {
    std::vector<properties::LawsOfCandidate> asked = ask();
    if (options.target) set_targets(asked);
    campaigns_.emplace(std::move(asked), units_are_kept);
  }

  std::vector<BorrowedBounds> borrowed() const {
    std::vector<BorrowedBounds> all;
    for (const Implementation& one : judged_) {
      if (!one.bounds_of.empty() && !options_.max_error) all.push_back({one.name, one.bounds_of});
    }
    return all;
  }

  std::vector<CorpusFinding> corpus() {
    return try_corpus(options_, laws_, judged_, candidates_.local());
  }

  void run(const properties::RunControl& control, Units* units) {
    const auto count = static_cast<std::int64_t>(campaigns_->unit_count());
    const std::int64_t all = count + std::ssize(targets_);
    Progress progress(all, control);
    std::int64_t next = 0;
    run_units<UnitResult>(
        all, units, control,
        [&](std::int64_t unit) -> UnitResult {
          const std::vector<Candidate>& own = candidates_.local();
          if (unit < count)
            return {campaigns_->run(static_cast<std::size_t>(unit), own, control), {}};
          const Target& target = targets_[static_cast<std::size_t>(unit - count)];
          return {{}, find_worst_case(own[target.candidate], target.stage, target.search, control)};
        },
        [&](UnitResult& result) {
          const std::int64_t unit = next++;
          progress.add(result.parts);
          if (unit < count) {
            campaigns_->take(static_cast<std::size_t>(unit), std::move(result.parts));
          } else {
            worst_[targets_[static_cast<std::size_t>(unit - count)].campaign] =
                std::move(result.worst);
          }
        });
  }

  /// The results of the campaigns, in the order of laws.
  std::vector<CampaignReport> finished(const properties::RunControl& control) {
    std::vector<CampaignReport> reports;
    for (const Candidate& one : candidates_.local()) one.begin_anew();
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const auto& [law, candidate, number] = order_[k];
      const Candidate& own = candidates_.local()[candidate];
      properties::CampaignResult result = campaigns_->finished(candidate, number, own);
      if (control.interrupted() && result.parts.empty()) continue;  // not reached
      if (worst_[k] && !result.failure) {
        result.failure =
            run_case(*law, own, worst_[k]->the_case, options_.max_error, options_.strict).failure;
      }
      reports.push_back(
          report_of(*law, judged_[candidate], own, names_[candidate], std::move(result), options_));
      reports.back().worst = std::move(worst_[k]);
    }
    leave_out_sentences_about_state(reports);
    return reports;
  }

 private:
  /// A campaign: its candidate, and its number among that candidate's campaigns.
  struct Campaign {
    const Law* law;
    std::size_t candidate, number;
  };
  /// A search for the worst case of a campaign's law.
  struct Target {
    std::size_t campaign, candidate;
    properties::Stage stage;
    properties::SearchOptions search;
  };

  std::vector<properties::LawsOfCandidate> ask() {
    std::vector<properties::LawsOfCandidate> asked;
    CampaignOptions campaign;
    campaign.cases = options_.cases;
    campaign.seed = options_.seed;
    campaign.max_error = options_.max_error;
    campaign.strict = options_.strict;
    campaign.sources = options_.sources;
    campaign.keep_going = options_.keep_going;
    for (const Candidate& one : candidates_.local()) {
      campaign.level = options_.level.value_or(one.level);
      asked.push_back({{}, campaign});
    }
    for (const Law* law : laws_) {
      for (std::size_t k = 0; k < judged_.size(); ++k) {
        if (!is_worth_asking(*law, judged_[k], is_chosen_)) continue;
        order_.push_back({law, k, asked[k].laws.size()});
        asked[k].laws.push_back(law);
      }
    }
    worst_.resize(order_.size());
    return asked;
  }

  /// Sets a target for every law that measures a quantity. A search has at most as many cases as
  /// SearchOptions has by default, and the same number of steps per case.
  void set_targets(const std::vector<properties::LawsOfCandidate>& asked) {
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const auto& [law, candidate, number] = order_[k];
      if (!law->stage || properties::law_of(*law->stage, law->quantity) != law) continue;
      properties::SearchOptions search;
      search.sources = sources_of(*law, asked[candidate].options);
      search.quantity = law->quantity;
      search.climb = *options_.target;
      search.steps = search.steps / search.cases * std::min(options_.cases, search.cases);
      search.cases = std::min(options_.cases, search.cases);
      search.seed = options_.seed;
      if (!search.sources.empty()) targets_.push_back({k, candidate, *law->stage, search});
    }
  }

  const PropertiesOptions& options_;
  bool is_chosen_;  ///< Whether the user has chosen the candidates.
  std::vector<Implementation> judged_;
  std::vector<std::string> names_;
  std::vector<const Law*> laws_;
  tbb::enumerable_thread_specific<std::vector<Candidate>> candidates_;
  std::vector<Campaign> order_;
  std::vector<Target> targets_;
  std::optional<properties::Campaigns> campaigns_;
  std::vector<std::optional<properties::WorstCase>> worst_;  ///< The worst case of each campaign.
};

}  // namespace

std::uint64_t PropertiesReport::count(properties::Finding finding) const {
  return static_cast<std::uint64_t>(
      std::ranges::count(campaigns, finding, &CampaignReport::finding));
}

bool PropertiesReport::holds() const {
  return failures() == 0 && std::ranges::none_of(corpus, [](const CorpusFinding& one) {
           return one.finding == properties::Finding::kBroken;
         });
}

bool PropertiesReport::is_conclusive() const {
  using properties::Finding;
  const std::uint64_t undecided = count(Finding::kUndecided);
  const bool is_decided = ratchet ? ratchet->is_conclusive : undecided == 0;
  return is_decided && count(Finding::kTooFewJudged) == 0 &&
         count(Finding::kHolds) + count(Finding::kBroken) + undecided > 0;
}

PropertiesReport run_properties(const PropertiesOptions& options,
                                const properties::RunControl& control, Units* units) {
  const scene::Interruptible interruptible(control.interrupted);
  if (!options.replay.empty()) {
    PropertiesReport report = replay(options);
    report.interrupted = control.interrupted();
    return report;
  }
  PropertiesReport report;
  report.seed = options.seed;
  report.cases = options.cases;
  report.strict = options.strict;
  report.target = options.target;
  Study study(options, units != nullptr);
  report.borrowed = study.borrowed();
  const bool reports = units == nullptr || units->are_all();
  if (reports && !options.corpus.empty()) report.corpus = study.corpus();
  study.run(control, units);
  if (reports) report.campaigns = study.finished(control);
  report.interrupted = control.interrupted();
  if (reports && !options.corpus.empty() && !report.interrupted) {
    keep_in_corpus(report, options.corpus);
  }
  return report;
}

int cases_for(const PropertiesOptions& options, double seconds,
              const properties::RunControl& control) {
  // If a campaign takes this share of the time left, the time of a larger campaign is estimated
  // from it.
  constexpr double kShare = 0.1;
  constexpr double kMargin = 0.95;
  constexpr double kMostCases = 1e9;
  const auto start = std::chrono::steady_clock::now();
  const auto passed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  PropertiesOptions tried = options;
  tried.corpus.clear();
  for (tried.cases = 1;; tried.cases *= 4) {
    const double before = passed();
    run_properties(tried, control);
    const double took = passed() - before;
    const double left = seconds - passed();
    const bool is_largest = tried.cases > kMostCases / 4;
    if (took < kShare * left && !is_largest && !control.interrupted()) continue;
    const double times = std::max(1.0, kMargin * left / took);
    return static_cast<int>(std::min(tried.cases * times, kMostCases));
  }
}

}  // namespace raycheck::tools
