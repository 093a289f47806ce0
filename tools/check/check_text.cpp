#include <fmt/core.h>

#include <algorithm>

#include "scene/number.h"
#include "scene/text.h"
#include "tools/check/check.h"
#include "tools/report/table.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using properties::Quantity;
using properties::Standing;
using properties::Tally;

std::string scene_text(const CheckReport& report) {
  std::string text = scene_file_text(report.path, report.format) + ": ";
  if (report.scene.camera) {
    text += fmt::format("{} x {} pixels", report.scene.camera->width, report.scene.camera->height);
  } else {
    text += count_text(report.scene.rays.size(), "given ray");
  }
  text += ", " + count_text(report.scene.spheres.size(), "sphere");
  return text + "\n" + not_needed_text(report.not_needed) +
         conventions_text(report.scene.conventions) + "\n";
}

/// "2 missed, 1 false hit (1 excused, 1 undecided)"
std::string class_error_text(const Tally& tally) {
  std::string text;
  for (const auto& [wrong, count] : tally.wrong) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name(wrong));
  }
  std::string standings;
  for (const Standing standing : {Standing::kExcused, Standing::kUndecided, Standing::kNotJudged}) {
    if (tally.count(standing) == 0) continue;
    standings += fmt::format("{}{} {}", standings.empty() ? "" : ", ", tally.count(standing),
                             name(standing));
  }
  if (!standings.empty()) text += fmt::format(" ({})", standings);
  return text.empty() ? "0" : text;
}

/// The place of a quantity's largest error, if it has errors.
std::string worst_text(const Tally& tally, Quantity quantity) {
  std::string text;
  if (tally.worst > 0 && has_place(quantity)) text = place_text(tally.worst_place);
  if (tally.ill_conditioned > 0) {
    text += fmt::format("{}({} above the bound: ill-conditioned)", text.empty() ? "" : " ",
                        tally.ill_conditioned);
  }
  return text;
}

/// A table of a candidate's comparisons, with a row for each quantity.
std::string quantities_table(const CandidateReport& candidate) {
  Table table(
      {"quantity", ">cases", "class errors", ">median", ">max", ">bound", "unit", "worst at"});
  for (const auto& [quantity, tally] : candidate.verdict.tallies()) {
    const bool measured = !tally.errors.empty();
    table.add({quantity == Quantity::kRefusal ? "no answer" : std::string(info(quantity).name),
               std::to_string(tally.cases), measured ? "" : class_error_text(tally),
               error_text(tally.median()), error_text(tally.max()), error_text(tally.bound()),
               std::string(unit_name(quantity, candidate.precision)), worst_text(tally, quantity)});
  }
  return table.text();
}

/// The text about hits that an interval of valid roots, or culling, excludes.
std::string excluded_text(const CandidateReport& candidate) {
  if (candidate.conventions.valid.is_usual()) return "";
  const ExcludedHits& excluded = candidate.excluded;
  const ExcludedOfSphere all = excluded.all();
  std::string text = fmt::format("  {} excludes {} of {} and moves {} to the other root\n",
                                 valid_roots_text(candidate.conventions.valid), all.excluded,
                                 count_text(all.hits, "exact hit"), all.moved);
  for (std::size_t k = 0; k < excluded.spheres.size(); ++k) {
    const auto& [hits, lost, moved] = excluded.spheres[k];
    if (lost + moved == 0) continue;
    text += fmt::format("    sphere {}: {} of {} excluded, {} moved\n", k, lost, hits, moved);
  }
  for (const ExcludedHit& hit : excluded.worst) {
    text += fmt::format("    excluded: {} at s = {:.6g}\n", place_text(hit.place), hit.s);
  }
  return text;
}

std::string precision_text(const CandidateReport& candidate) {
  std::string text;
  if (candidate.made_unit > 0) {
    text = fmt::format("  takes only unit directions: {} normalised before judging\n",
                       count_text(candidate.made_unit, "direction"));
  }
  if (candidate.precision == scene::Precision::kDouble) return text;
  text += "  judged in single precision: u = 2^-24, ulp of float\n";
  if (candidate.rounded_numbers > 0) {
    text += fmt::format("  {}\n", rounded_numbers_text(candidate.rounded_numbers));
  }
  return text;
}

std::string failures_text(const properties::FailureSearch& search) {
  if (search.batches == 0) return "";
  std::string text =
      fmt::format("  failed on {}", count_text(static_cast<std::uint64_t>(search.batches),
                                               search.batches == 1 ? "batch" : "batche"));
  if (search.found == 0 && search.together == 0) {
    return text + "; no single question that fails was found\n";
  }
  text += fmt::format("; halving found {} that fail{} (at most {} are sought)",
                      count_text(static_cast<std::uint64_t>(search.found), "question"),
                      search.found == 1 ? "s" : "", properties::kMostFailuresSought);
  if (search.together > 0) {
    text += fmt::format(", {} whose halves are answered",
                        count_text(static_cast<std::uint64_t>(search.together), "part"));
  }
  if (search.not_sought > 0) {
    text += fmt::format(", {} not retried",
                        count_text(static_cast<std::uint64_t>(search.not_sought), "other failure"));
  }
  return text + "\n";
}

/// A line with the command that asks this question again; empty if there is none.
std::string replay_text(const CheckReport& report, const CandidateReport& candidate,
                        const properties::Discrepancy& discrepancy) {
  const scene::Scene& scene = *discrepancy.failed.scene;
  const auto words = [&](const std::string& what) {
    return fmt::format("  replay: raycheck {} --candidate {}\n", what,
                       single_quoted(candidate.name));
  };
  if (scene.camera) {
    if (!discrepancy.place.pixel) return "";
    return words(fmt::format("explain {} --pixel {},{}", report.path, discrepancy.place.pixel->i,
                             discrepancy.place.pixel->j));
  }
  if (scene.rays.size() != 1 || scene.spheres.size() != 1 ||
      !(scene.conventions == scene::Conventions{})) {
    return "";
  }
  const scene::Ray& ray = scene.rays.front();
  const scene::Sphere& sphere = scene.spheres.front();
  const auto listed = [](std::initializer_list<double> numbers) {
    return scene::joined(numbers, ",", scene::shortest);
  };
  return words(
      fmt::format("explain --ray {} --sphere {}",
                  listed({ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x,
                          ray.direction.y, ray.direction.z}),
                  listed({sphere.centre.x, sphere.centre.y, sphere.centre.z, sphere.radius})));
}

/// The first question that a candidate fails on, as a scene.
std::string failed_question_text(const CheckReport& report) {
  for (const CandidateReport& candidate : report.candidates) {
    for (const auto& discrepancy : candidate.verdict.worst(report.top)) {
      if (!discrepancy.failed.scene) continue;
      const std::string comment =
          fmt::format("{} fails here: {}", shown_name(report.candidates, candidate.implementation),
                      place_text(discrepancy.place));
      return "\na failing question, as a scene for `raycheck check`:\n" +
             indented(scene::write_toml(*discrepancy.failed.scene, comment), "  ") +
             replay_text(report, candidate, discrepancy);
    }
  }
  return "";
}

std::string candidate_text(const CheckReport& report, const CandidateReport& candidate) {
  const Implementation& implementation = candidate.implementation;
  const std::string& own = implementation.own_name;
  std::string text =
      "\n" + (own.empty() ? candidate.name : fmt::format("{} ({})", own, candidate.name));
  if (!implementation.isolated_by.empty()) text += "  isolated by: " + implementation.isolated_by;
  text += "\n";
  if (!implementation.bounds_of.empty() && !report.max_error) {
    text += fmt::format("  states no error bounds, so those of {} apply; --bounds chooses others\n",
                        implementation.bounds_of);
  }
  if (!(candidate.conventions == report.scene.conventions)) {
    text += fmt::format("  judged under its own conventions: {}\n",
                        conventions_text(candidate.conventions));
  }
  if (candidate.given_rays) {
    const bool is_focal = candidate.conventions.origin == scene::Origin::kFocal;
    text += fmt::format("  has no {}_ray(): is given raycheck's rays, correctly rounded\n",
                        is_focal ? "focal" : "pixel");
  }
  text += precision_text(candidate) + excluded_text(candidate) + quantities_table(candidate);
  text += indented(tolerated_text(candidate.verdict, implementation.tolerances), "  ");
  const char* const answers = implementation.draws() ? "pixels" : "answers";
  text += indented(explanations_text(candidate.explanations, answers), "  ");
  if (std::ranges::any_of(candidate.explanations, [](const properties::Explanation& one) {
        return one.sentence == properties::kTooFewErrors;
      })) {
    text += "  `raycheck properties` tries more cases\n";
  }
  return text + failures_text(candidate.search) + too_few_text(candidate);
}

struct RankedDiscrepancy {
  const CandidateReport* candidate;
  std::size_t rank;
  properties::Discrepancy discrepancy;
};

/// The worst discrepancies: defects first, and the worst of every candidate before the second worst
/// of any.
std::vector<RankedDiscrepancy> worst_of_all(const CheckReport& report) {
  std::vector<RankedDiscrepancy> ranked;
  for (const CandidateReport& candidate : report.candidates) {
    std::size_t rank = 0;
    for (const auto& discrepancy : candidate.verdict.worst(report.top)) {
      ranked.push_back({&candidate, rank++, discrepancy});
    }
  }
  std::ranges::stable_sort(ranked, [](const auto& a, const auto& b) {
    const auto key = [](const RankedDiscrepancy& one) {
      return std::pair(one.discrepancy.excuse.standing(), one.rank);
    };
    return key(a) < key(b);
  });
  ranked.resize(std::min(ranked.size(), report.top));
  return ranked;
}

}  // namespace

std::string too_few_text(const CandidateReport& candidate) {
  if (!candidate.not_asked.empty()) {
    return fmt::format("  not judged here: {}\n", candidate.not_asked);
  }
  if (!candidate.inside_domain) {
    return "  not judged here: a length of the scene lies outside the judged domain\n";
  }
  const auto too_few = candidate.too_few_judged();
  if (!too_few) return "";
  return fmt::format("  too few judged: {}: none of the {} is answered right without an excuse\n",
                     info(too_few->first).name, expected_text(too_few->second));
}

std::vector<std::string> left_out_lines(const CheckReport& report) {
  std::vector<std::string> lines;
  if (report.rays_judged < report.rays_in_scene && !report.interrupted) {
    lines.push_back(fmt::format("{} of {} pixels: only {} were selected",
                                report.rays_in_scene - report.rays_judged, report.rays_in_scene,
                                report.rays_judged));
  }
  if (report.scene.camera && report.scene.camera->far) {
    lines.emplace_back("the scene's camera.far: no quantity depends on it");
  }
  lines.emplace_back("laws that compare several answers, which `raycheck properties` tries");
  // The laws left out for one reason, for all candidates or for one.
  Grouped<std::pair<std::string, std::string>> groups;
  for (const CandidateReport& candidate : report.candidates) {
    for (const LeftOut& entry : candidate.left_out) {
      const bool all = std::ranges::all_of(report.candidates, [&](const CandidateReport& other) {
        return std::ranges::find(other.left_out, entry) != other.left_out.end();
      });
      if (all && &candidate != &report.candidates.front()) continue;
      const std::string of =
          all ? "" : shown_name(report.candidates, candidate.implementation) + ", ";
      add_to(groups, {of, entry.reason}, entry.law);
    }
  }
  for (const auto& [of, laws] : groups) {
    lines.push_back(fmt::format("{}{}: {}", of.first, scene::joined(laws), of.second));
  }
  return lines;
}

std::string check_text(const CheckReport& report, const ViewOptions& options) {
  std::string text = scene_text(report);
  if (report.interrupted) text += "INTERRUPTED: what follows covers only what was judged.\n";
  std::uint64_t failures = 0;
  for (const CandidateReport& candidate : report.candidates) {
    failures += candidate.verdict.tally(Quantity::kRefusal).cases;
  }
  const bool is_asked = std::ranges::any_of(report.candidates, [](const CandidateReport& one) {
    return one.not_asked.empty() && one.inside_domain;
  });
  const bool is_judged = is_asked && (failures == 0 || report.compared() > failures);
  text += fmt::format("{} of {} judged\n", is_judged ? report.rays_judged : 0,
                      count_text(report.rays_in_scene, "ray"));
  for (const CandidateReport& candidate : report.candidates) {
    text += candidate_text(report, candidate);
  }
  const std::uint64_t total = report.discrepancies();
  if (total > 0) {
    const std::vector<RankedDiscrepancy> ranked = worst_of_all(report);
    text += fmt::format("\nworst discrepancies, {} of {} (in all {}):\n", ranked.size(), total,
                        standings_text([&](Standing one) { return report.count(one); }));
    for (std::size_t k = 0; k < ranked.size(); ++k) {
      text += fmt::format("{:>3}. {}\n", k + 1,
                          shown_name(report.candidates, ranked[k].candidate->implementation));
      text += indented(discrepancy_text(ranked[k].discrepancy, options.colours), "     ");
    }
    text += failed_question_text(report);
  } else {
    text += report.compared() > 0 ? "\nno discrepancy\n" : "\nnothing was checked\n";
  }
  text += "\nleft out:\n";
  for (const std::string& line : left_out_lines(report)) text += "  " + line + "\n";
  return report.ratchet ? text + "\n" + ratchet_text(*report.ratchet) : text;
}

}  // namespace raycheck::tools
