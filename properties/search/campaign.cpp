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

#include "properties/cases/case_text.h"
#include "properties/cases/shrink.h"

namespace raycheck::properties {
namespace {

/// Where a generated case came from.
struct Provenance {
  ChosenSource source;
  std::uint64_t seed = 0;
};

/// Cases of random sources and seeds, shrunk by simpler(); notes where the last one came from.
template <class Choose>
rc::Gen<Case> generator(Choose choose, Provenance& noted) {
  return [choose, &noted](const rc::Random& random, int) {
    rc::Random stream = random;
    noted = choose(stream);
    return rc::shrinkable::shrinkRecur(noted.source.make(noted.seed), [](const Case& from) {
      return rc::seq::fromContainer(simpler(from));
    });
  };
}

bool suits(const Law& law, const ChosenSource& chosen) {
  return !speaks_of_cameras(law) || chosen.source->has_camera;
}

std::string replay_text(const Law& law, const Candidate& candidate, const Provenance& from) {
  char digits[17] = {};
  std::to_chars(digits, digits + 16, from.seed, 16);
  return std::string(law.name) + ":" + candidate.name + ":" + from.source.name() + ":" + digits;
}

template <class Choose>
CampaignResult run(const Law& law, const Candidate& candidate, const CampaignOptions& options,
                   const RunControl& control, Choose choose) {
  CampaignResult result;
  Provenance noted;
  const rc::Gen<Case> cases = generator(choose, noted);
  bool stopped = false;
  const auto property = [&] {
    if (stopped || (stopped = control.interrupted())) return;
    const Case the_case = *cases;
    Trial trial(the_case, candidate, {.max_error = options.max_error});
    Verdict verdict = apply(law, trial);
    if (!result.failure) {  // what follows a failure is shrinking
      ++result.cases;
      if (!verdict.reason_left_out().empty() && verdict.compared() == 0) {
        ++result.left_out;
        result.reason = verdict.reason_left_out();
      }
      result.verdict.merge(verdict);
    }
    if (verdict.holds()) return;
    result.failure = Failure{the_case, std::move(verdict), replay_text(law, candidate, noted)};
    RC_FAIL("");
  };
  rc::detail::TestParams params;
  params.seed = options.seed;
  params.maxSuccess = options.cases;
  rc::detail::TestMetadata metadata;
  metadata.id = std::string(law.name);
  rc::detail::TestListenerAdapter silent;
  // With a map of its own RapidCheck neither reads the environment nor prints its configuration.
  const std::unordered_map<std::string, rc::detail::Reproduce> nothing_to_reproduce;
  const auto outcome =
      rc::detail::checkTestable(property, metadata, params, silent, nothing_to_reproduce);
  rc::detail::Error error;
  if (outcome.match(error)) throw std::runtime_error("RapidCheck: " + error.description);
  return result;
}

}  // namespace

CampaignResult run_campaign(const Law& law, const Candidate& candidate,
                            const CampaignOptions& options, const RunControl& control) {
  std::vector<ChosenSource> sources = options.sources;
  if (sources.empty()) {
    for (const CaseSource& source : case_sources()) sources.push_back({&source});
  }
  std::erase_if(sources, [&](const ChosenSource& source) { return !suits(law, source); });
  if (sources.empty()) {
    CampaignResult none;
    none.reason = "no source of cases has a camera";
    return none;
  }
  return run(law, candidate, options, control, [sources](rc::Random& random) {
    const ChosenSource& source = chosen_by(sources, random.next());
    return Provenance{source, random.next()};
  });
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
                          std::optional<double> max_error) {
  CampaignOptions options;
  options.cases = 1;
  options.max_error = max_error;
  const Provenance from{replay.source, replay.seed};
  return run(*replay.law, candidate, options, {}, [from](rc::Random&) { return from; });
}

void showValue(const Case& the_case, std::ostream& out) { out << scene_text(the_case); }

}  // namespace raycheck::properties
