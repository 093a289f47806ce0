#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "properties/quantity.h"
#include "properties/search/worst_case.h"
#include "tools/check/check.h"
#include "tools/report/words.h"
#include "tools/view/scene_view.h"

namespace raycheck::tools {
namespace {

using properties::Quantity;

/// At most this many findings of each candidate, one for each ray and sphere: its worst
/// discrepancies or, if there are none, its largest errors.
constexpr std::size_t kMostFindings = 8;
constexpr std::size_t kMostDiscrepancies = 64;

std::string method_of(const CandidateReport& candidate, Quantity quantity) {
  using properties::Stage;
  const bool is_of_rays = properties::law_of(Stage::kRays, quantity) != nullptr;
  return candidate.implementation.name_in(is_of_rays ? Stage::kRays : Stage::kIntersection);
}

/// The mistakes that explain a candidate's wrong answers, in a sentence; empty if there are none.
std::string looks_like(const std::vector<properties::Explanation>& explanations) {
  std::string text;
  for (const properties::Explanation& one : explanations) {
    if (one.explained == 0 || one.sentence == properties::kNotNumbers) continue;
    text += (text.empty() ? "Probable mistake: " : " Or: ") +
            explained_text(one.sentence, one.explained, one.errors, "answers") + ".";
  }
  return text;
}

/// A selection for a discrepancy without a place: one of the camera, or a failure.
Selection anywhere_in(const scene::Scene& scene) {
  if (!scene.camera) return {{}, std::size_t{0}, {}};
  return {scene::Pixel{scene.camera->width / 2, scene.camera->height / 2}, {}, {}};
}

std::vector<FindingView> findings_of(const CandidateReport& candidate, const scene::Scene& scene,
                                     std::size_t scene_index) {
  std::vector<FindingView> findings;
  for (const auto& one : candidate.verdict.worst(kMostDiscrepancies)) {
    Selection selection = selection_of(one.place, scene);
    const bool is_placed = is_of_ray(selection) && has_place(one.quantity);
    if (!is_placed) selection = anywhere_in(scene);
    std::string what = one.quantity == Quantity::kRefusal
                           ? discrepancy_head(one)
                           : fmt::format("{} {}", info(one.quantity).name, wrongness_text(one));
    if (one.quantity == Quantity::kNearestSphere) {
      what += fmt::format(", {} for {}", got_text(one), exact_text(one));
    }
    const auto known = std::ranges::find(findings, selection, &FindingView::selection);
    if (known != findings.end()) {
      known->sentence += "; " + what;
    } else if (findings.size() < kMostFindings) {
      findings.push_back(
          {is_placed ? fmt::format("{}: {}", place_text(one.place), what) : discrepancy_head(one),
           candidate.name, method_of(candidate, one.quantity), one.excuse.standing(), scene_index,
           selection});
    }
  }
  for (FindingView& finding : findings) finding.looks_like = looks_like(candidate.explanations);
  if (!findings.empty()) return findings;
  for (const Quantity quantity :
       {Quantity::kParameter, Quantity::kHitPoint, Quantity::kDirection, Quantity::kPixelPoint}) {
    const properties::Tally& tally = candidate.verdict.tally(quantity);
    if (!tally.max()) continue;
    const Selection selection = selection_of(tally.worst_place, scene);
    if (!is_of_ray(selection)) continue;
    findings.push_back(
        {fmt::format("largest error of {}: {} {}, {}", info(quantity).name, error_text(tally.max()),
                     unit_name(quantity, candidate.precision), place_text(tally.worst_place)),
         candidate.name, method_of(candidate, quantity), std::nullopt, scene_index, selection});
  }
  // A right picture has no errors to show.
  if (findings.empty() && candidate.verdict.compared() > 0) {
    findings.push_back({"no discrepancy", candidate.name, candidate.name, std::nullopt, scene_index,
                        anywhere_in(scene)});
  }
  return findings;
}

/// The candidates of one view: all of raycheck's methods, or one external candidate.
using Group = std::vector<const CandidateReport*>;

std::vector<Group> groups_of(const CheckReport& report) {
  std::vector<Group> groups;
  Group own;
  for (const CandidateReport& candidate : report.candidates) {
    if (candidate.implementation.methods) {
      own.push_back(&candidate);
    } else if (candidate.not_asked.empty()) {
      groups.push_back({&candidate});
    }
  }
  if (!own.empty() || groups.empty()) groups.insert(groups.begin(), own);
  return groups;
}

/// A remark after the place of the first listed discrepancy.
std::string worst_of(std::uint64_t listed, std::uint64_t all) {
  if (all == 1) return ", the only discrepancy here";
  return fmt::format(", the worst of {} discrepancies here; {} listed", all,
                     listed == 1 ? "one place is" : fmt::format("{} places are", listed));
}

/// The numbers of listed places, of discrepancies, and of largest errors.
std::string found_text(std::uint64_t listed, std::uint64_t all, std::uint64_t errors) {
  std::string text;
  if (all > 0) {
    text = fmt::format("{}, of {} {}", count_text(listed, "place"), all,
                       all == 1 ? "discrepancy" : "discrepancies");
  }
  if (errors > 0) text += (text.empty() ? "" : "; ") + count_text(errors, "largest error");
  return text.empty() ? "none" : text;
}

}  // namespace

ViewDocument check_document(const CheckReport& report, const CheckPageOptions& options,
                            const properties::RunControl& control) {
  ViewDocument document;
  document.title = std::filesystem::path(report.path).filename();
  if (report.rays_judged < report.rays_in_scene) {
    document.left_out.push_back(
        fmt::format("{}: findings cover {} of {} rays; `raycheck check --view` judges all of them",
                    document.title, report.rays_judged, report.rays_in_scene));
  }
  for (const Group& group : groups_of(report)) {
    SceneViewOptions view;
    view.name = group.size() == 1 && !group.front()->implementation.methods ? group.front()->name
                                                                            : document.title;
    view.file = shell_word(report.path);
    view.is_of_methods = options.is_of_methods;
    view.wanted = options.wanted;
    for (const CandidateReport* candidate : group) {
      show(candidate->implementation, view);
      const auto found = findings_of(*candidate, report.scene, document.scenes.size());
      document.findings.insert(document.findings.end(), found.begin(), found.end());
    }
    // Defects first, then in the order of the report.
    std::ranges::stable_sort(document.findings, [](const FindingView& a, const FindingView& b) {
      const auto rank = [](const FindingView& one) {
        return one.standing ? static_cast<int>(*one.standing)
                            : static_cast<int>(properties::kStandingCount);
      };
      return rank(a) < rank(b);
    });
    for (const FindingView& finding : document.findings) {
      if (finding.scene == document.scenes.size()) view.wanted.push_back(finding.selection);
    }
    document.scenes.push_back(view_of(report.scene, view, document.left_out, control));
  }
  const std::uint64_t total = report.discrepancies();
  const std::vector<FindingView>& findings = document.findings;
  const auto listed = static_cast<std::uint64_t>(
      std::ranges::count_if(findings, [](const auto& one) { return one.standing.has_value(); }));
  document.found = found_text(listed, total, findings.size() - listed);
  if (listed > 0) document.worst = worst_of(listed, total);
  return document;
}

}  // namespace raycheck::tools
