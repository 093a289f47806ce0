#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "properties/mistakes/explanation.h"
#include "properties/run_control.h"
#include "properties/trial.h"
#include "properties/verdict.h"
#include "scene/files/scene_file.h"
#include "tools/gates/baseline.h"
#include "tools/gates/gate.h"
#include "tools/implementations/implementation.h"
#include "tools/report/view.h"
#include "tools/shards/units.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// A hit that the interval of valid roots, or culling, excludes.
struct ExcludedHit {
  properties::Place place;
  double s = 0;         ///< s of the root that counts if every root >= 0 does; correctly rounded.
  double in_radii = 0;  ///< Roughly s divided by the sphere's radius; infinite for radius 0.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(place, s, in_radii);
  }
};

/// The effect of an interval or culling on the hits of a sphere.
struct ExcludedOfSphere {
  std::uint64_t hits = 0;      ///< The number of hits if every root >= 0 counts.
  std::uint64_t excluded = 0;  ///< The hits that become misses.
  std::uint64_t moved = 0;     ///< The hits that move to the other root.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(hits, excluded, moved);
  }
};

/// Compares the exact hits of a scene with an interval or culling with the hits if every root >= 0
/// counts.
struct ExcludedHits {
  std::vector<ExcludedOfSphere> spheres;
  std::vector<ExcludedHit> worst;  ///< The hits farthest along their rays, in radii.

  ExcludedOfSphere all() const;
  void merge(const ExcludedHits& other);
  template <class Archive>
  void serialize(Archive& archive) {
    archive(spheres, worst);
  }
};

inline constexpr std::size_t kKeptExcluded = 10;

struct CheckOptions {
  std::string path;
  /// The format of the file, if there are no renderers. Null: detected from the file.
  const scene::FileFormat* read_as = nullptr;
  /// Whether renderers get files in their own form. If not, in the scene's format.
  bool keeps_forms = false;
  std::vector<Implementation> implementations;
  std::optional<std::int64_t> pixels;  ///< How many pixels to judge, spread evenly; empty: all.
  std::size_t top = 10;                ///< The number of worst discrepancies to show.
  std::optional<double> max_error;     ///< A bound that replaces the documented ones.
  bool strict = false;                 ///< Whether excused or undecided answers fail, too.
};

/// A law that was not judged, and why.
struct LeftOut {
  std::string law;
  std::string reason;
  bool operator==(const LeftOut&) const = default;
};

struct CandidateReport {
  std::string name;
  std::string lasting_name;  ///< Its name in baselines (lasting_names).
  Implementation implementation;
  scene::Conventions conventions;  ///< The conventions under which it was judged.
  /// The format in which it was judged.
  scene::Precision precision = scene::Precision::kDouble;
  /// The count of scene numbers that were rounded to that format.
  std::size_t rounded_numbers = 0;
  std::size_t made_unit = 0;  ///< The count of given directions that were normalised for it.
  /// The scene about which it was asked; empty: the given scene.
  std::optional<scene::Scene> asked;
  /// Why its format cannot hold the scene, so that it was not judged; empty if it was judged.
  std::string not_asked;
  /// Whether the scene is in its stated domain. If not, its answers are not judged.
  bool inside_domain = true;
  /// Whether it makes no rays, so that it was asked about raycheck's rays.
  bool given_rays = false;
  properties::Verdict verdict;
  /// The hits that its t_min, t_max and culling exclude; empty if it declares none.
  ExcludedHits excluded;
  std::vector<LeftOut> left_out;
  std::vector<properties::Explanation> explanations;  ///< Only for external candidates.
  properties::FailureSearch search;  ///< The search for the questions on which it fails.

  /// For a candidate without defects and undecided answers: the first kind of question that was
  /// asked but never answered right without an excuse.
  std::optional<std::pair<properties::Quantity, properties::Expected>> too_few_judged() const {
    const bool is_asked = inside_domain && verdict.holds() && !is_undecided();
    return is_asked ? verdict.too_few_right(1, excludes_hits()) : std::nullopt;
  }
  bool is_undecided() const { return verdict.count(properties::Standing::kUndecided) > 0; }
  /// Whether its t_min, t_max or culling excludes a hit of the scene. Then other hits must remain.
  bool excludes_hits() const {
    return !conventions.valid.is_usual() && excluded.all().excluded > 0;
  }
  /// Whether enough was judged for a verdict, apart from undecided answers.
  bool is_judged() const { return inside_domain && verdict.compared() > 0 && !too_few_judged(); }
  /// Whether enough was judged for a verdict, and no answer is undecided.
  bool is_enough_judged() const { return is_judged() && !is_undecided(); }
};

struct CheckReport : scene::LoadedScene {
  std::string path;
  std::uint64_t rays_in_scene = 0;
  std::uint64_t rays_judged = 0;
  std::vector<CandidateReport> candidates;
  std::size_t top = 0;
  bool interrupted = false;
  bool strict = false;
  std::optional<double> max_error;  ///< A bound that replaces the documented ones.
  std::optional<Ratchet> ratchet;   ///< The comparison with a baseline, if there is one.

  /// The scene on which a candidate was asked and judged.
  const scene::Scene& scene_of(const CandidateReport& candidate) const {
    return candidate.asked ? *candidate.asked : scene;
  }
  /// The sum of a count over all candidates' verdicts.
  template <class... Arguments>
  std::uint64_t sum(std::uint64_t (properties::Verdict::*which)(Arguments...) const,
                    Arguments... arguments) const {
    std::uint64_t all = 0;
    for (const CandidateReport& one : candidates) all += (one.verdict.*which)(arguments...);
    return all;
  }
  std::uint64_t discrepancies() const { return sum(&properties::Verdict::discrepancies); }
  std::uint64_t count(properties::Standing standing) const {
    return sum(&properties::Verdict::count, standing);
  }
  std::uint64_t compared() const { return sum(&properties::Verdict::compared); }
  /// Whether no candidate has a defect or, if strict, an excused or undecided answer.
  bool holds() const;
  /// Whether enough was judged for a verdict, and every undecided answer is in the baseline.
  bool is_enough_judged() const;
};

/// Judges the candidates on a scene file. The report does not depend on the number of threads. If
/// `units` is given, judges only the shard's missing units, and returns an empty report unless the
/// shard is the whole campaign. Throws what the reader of the file throws.
CheckReport check(const CheckOptions& options, const properties::RunControl& control = {},
                  Units* units = nullptr);

std::string check_text(const CheckReport& report, const ViewOptions& options);
std::string check_json(const CheckReport& report, const ViewOptions& options);

/// A check for each quantity of each candidate.
Gate check_gate(const CheckReport& report);

inline constexpr View<CheckReport> kCheckViews[] = {
    {"text", check_text},
    {"json", check_json},
};

/// Why too little was judged for a verdict; empty if enough was judged.
std::string too_few_text(const CandidateReport& candidate);
/// What was left out, one line for each reason, with the candidate's name unless the reason holds
/// for all candidates.
std::vector<std::string> left_out_lines(const CheckReport& report);

/// Certificates of each candidate's worst discrepancies, as in check_json: one per line.
std::string check_certificates(const CheckReport& report);

/// Options of a page besides the findings of a report.
struct CheckPageOptions {
  std::vector<Selection> wanted;  ///< The selections that are shown first.
  bool is_of_methods = false;     ///< Whether panels show only the steps of the chosen methods.
};

/// The scene of a report as a page, with its worst discrepancies and largest errors beside it.
/// There is one view for all of raycheck's methods, and one for each other implementation.
ViewDocument check_document(const CheckReport& report, const CheckPageOptions& options,
                            const properties::RunControl& control);

}  // namespace raycheck::tools
