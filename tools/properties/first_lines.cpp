#include "tools/properties/first_lines.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using properties::CampaignPart;
using properties::Finding;
using properties::Level;

void add_law(const CampaignReport& campaign, std::string& laws) {
  laws += (laws.empty() ? "" : ", ") + std::string(campaign.law->name);
}

/// Why laws are broken: "rows are upside down (20 of 20 wrong answers)". The cause that explains
/// most answers comes first, and the laws without a known cause last.
std::string causes_text(const std::vector<const CampaignReport*>& broken) {
  struct Cause {
    const properties::Explanation* best;
    std::string laws;
  };
  std::vector<Cause> causes;
  std::string unexplained;
  for (const CampaignReport* campaign : broken) {
    const auto& all = campaign->explanations;
    const auto best = std::ranges::max_element(all, {}, &properties::Explanation::explained);
    if (best == all.end() || best->explained == 0) {
      add_law(*campaign, unexplained);
      continue;
    }
    auto known = std::ranges::find_if(
        causes, [&](const Cause& cause) { return cause.best->sentence == best->sentence; });
    if (known == causes.end()) known = causes.insert(known, {&*best, ""});
    if (best->explained > known->best->explained) known->best = &*best;
    add_law(*campaign, known->laws);
  }
  if (causes.empty()) return "breaks " + unexplained;
  std::ranges::stable_sort(
      causes, [](const Cause& a, const Cause& b) { return a.best->explained > b.best->explained; });
  const bool is_all = causes.size() == 1 && unexplained.empty();
  std::string text;
  for (const auto& [best, laws] : causes) {
    text += fmt::format("{}{} (explains {}{})", text.empty() ? "" : "; ", best->sentence,
                        wrong_share_text(best->explained, best->errors, "answers"),
                        is_all ? "" : " of " + laws);
  }
  return text + (unexplained.empty() ? "" : "; unexplained: " + unexplained);
}

/// What the candidate answers where no answer is held against it: "; takes all 6 exact tangents for
/// misses". Empty if there is nothing to tell.
std::string facts_text(const std::vector<const CampaignReport*>& campaigns) {
  const auto sum = [&](properties::Fact fact) {
    properties::Answered all;
    for (const CampaignReport* campaign : campaigns) {
      all.merge(campaign->result.verdict.fact(fact));
    }
    return all;
  };
  const properties::Answered tangents = sum(properties::Fact::kTangent);
  const std::uint64_t missed = tangents.asked - tangents.right;
  std::string text;
  if (missed > 0) {
    text += fmt::format("; takes {} exact tangents for misses",
                        missed == tangents.asked && missed > 1
                            ? fmt::format("all {}", missed)
                            : fmt::format("{} of {}", missed, tangents.asked));
  }
  if (const auto at_zero = sum(properties::Fact::kMissedAtZero).asked; at_zero > 0) {
    text += fmt::format("; misses {} at s = 0 exactly", count_text(at_zero, "hit"));
  }
  return text;
}

/// The summary of an external candidate's campaigns: the mistakes that explain most errors and, if
/// known, the level up to which it is right.
std::string first_sentence(const std::vector<const CampaignReport*>& campaigns) {
  std::optional<Level> broken, held;
  std::vector<const CampaignReport*> all_broken;
  std::string open, failure;
  bool is_outside = false;
  for (const CampaignReport* campaign : campaigns) {
    if (campaign->finding == Finding::kHolds) {
      held = std::max(held.value_or(Level::kOrdinary), campaign->result.level);
    } else if (campaign->finding == Finding::kUndecided ||
               campaign->finding == Finding::kTooFewJudged) {
      add_law(*campaign, open);
    }
    is_outside = is_outside || campaign->finding == Finding::kNotJudged;
    const auto& parts = campaign->result.parts;
    if (campaign->result.failure && std::ranges::all_of(parts, &CampaignPart::failed_at_once)) {
      failure = campaign->result.failure->verdict.worst(1).front().what;
    }
    if (campaign->finding != Finding::kBroken) continue;
    all_broken.push_back(campaign);
    for (const CampaignPart& part : campaign->result.parts) {
      if (part.is_broken())
        broken = std::min(broken.value_or(Level::kExtreme), part.source.level());
    }
  }
  if (!held && !failure.empty()) return fmt::format("gives no answers: {}", failure);
  const std::string facts = facts_text(campaigns);
  if (!broken && !open.empty()) {
    return fmt::format("no law is broken, but these are undecided or too rarely judged: {}{}", open,
                       facts);
  }
  if (!broken && !held) {
    return is_outside ? "nothing judged: no case lies within the lengths that it declares"
                      : "nothing judged: it has no function that these laws test";
  }
  if (!broken) return fmt::format("right on all {} cases that were tried{}", name(*held), facts);
  const std::string right =
      *broken > Level::kOrdinary
          ? fmt::format("right on {} cases; ",
                        name(static_cast<Level>(static_cast<int>(*broken) - 1)))
          : "";
  return right + causes_text(all_broken) + facts;
}

}  // namespace

std::string name_in_rows(const PropertiesReport& report, const std::string& candidate) {
  const Implementation* its = nullptr;
  std::size_t laws = 0;
  for (const CampaignReport& one : report.campaigns) {
    if (one.candidate != candidate) continue;
    its = &one.implementation;
    ++laws;
  }
  return laws < 2 ? candidate : shown_name(report.campaigns, *its);
}

std::string first_lines(const PropertiesReport& report) {
  std::map<std::string, std::vector<const CampaignReport*>> by_candidate;
  for (const CampaignReport& campaign : report.campaigns) {
    if (!campaign.implementation.methods) by_candidate[campaign.candidate].push_back(&campaign);
  }
  std::string text;
  for (const auto& [candidate, campaigns] : by_candidate) {
    if (campaigns.size() < 2) continue;
    const std::string& own = campaigns.front()->implementation.own_name;
    text +=
        fmt::format("{}: {}\n", own.empty() ? candidate : fmt::format("{} ({})", own, candidate),
                    first_sentence(campaigns));
  }
  return text;
}

}  // namespace raycheck::tools
