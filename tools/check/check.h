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

/// A hit that an interval of parameters, or culling, excludes.
struct ExcludedHit {
  properties::Place place;
  double s = 0;         ///< Of the root that counts if every root >= 0 counts; rounded.
  double in_radii = 0;  ///< About s divided by the radius; infinite for radius 0.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(place, s, in_radii);
  }
};

/// What happens to the hits of a sphere.
struct ExcludedOfSphere {
  std::uint64_t hits = 0;      ///< If every root >= 0 counts.
  std::uint64_t excluded = 0;  ///< Hits that become misses.
  std::uint64_t moved = 0;     ///< Hits that remain hits, but at the other root.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(hits, excluded, moved);
  }
};

/// The exact hits of a scene that an interval or culling excludes or changes.
struct ExcludedHits {
  std::vector<ExcludedOfSphere> spheres;
  std::vector<ExcludedHit> worst;  ///< The excluded hits farthest along their rays, in radii.

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
  /// The dialect of a driver file, if there are no renderers; empty: detected from the file.
  std::optional<scene::Dialect> dialect;
  /// Whether renderers are given files in their own form; if not, in the scene's dialect.
  bool keeps_forms = false;
  std::vector<Implementation> implementations;
  std::optional<std::int64_t> pixels;  ///< The number of pixels, spread evenly; empty: all.
  std::size_t top = 10;                ///< The number of worst discrepancies to show.
  std::optional<double> max_error;     ///< A bound that replaces the documented ones.
  bool strict = false;                 ///< Excused or undecided answers fail, too.
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
  scene::Conventions conventions;  ///< Under which it was judged.
  /// The format that it was judged in.
  scene::Precision precision = scene::Precision::kDouble;
  /// The number of numbers of the scene that had to be rounded to that format.
  std::size_t rounded_numbers = 0;
  std::size_t made_unit = 0;  ///< Directions normalised for a candidate that takes only unit ones.
  std::optional<scene::Scene> asked;  ///< The scene that it was asked about, if not the given one.
  std::string not_asked;  ///< Why it was not judged: the format cannot hold the scene; or empty.
  bool inside_domain = true;  ///< Outside its stated domain its answers are not judged.
  bool given_rays = false;    ///< It makes no rays: it is judged on rays that raycheck makes.
  properties::Verdict verdict;
  ExcludedHits excluded;  ///< By its t_min, t_max and culling; empty if it has none.
  std::vector<LeftOut> left_out;
  std::vector<properties::Explanation> explanations;  ///< Only for external candidates.
  properties::FailureSearch search;  ///< The search for questions that it fails on.

  /// If there are no defects or undecided answers: the first kind of question that was asked, but
  /// never answered right without an excuse.
  std::optional<std::pair<properties::Quantity, properties::Expected>> too_few_judged() const {
    const bool is_asked = inside_domain && verdict.holds() && !is_undecided();
    return is_asked ? verdict.too_few_right(1, excludes_hits()) : std::nullopt;
  }
  bool is_undecided() const { return verdict.count(properties::Standing::kUndecided) > 0; }
  /// Whether its t_min, t_max or culling exclude a hit of the scene: then other hits must remain.
  bool excludes_hits() const {
    return !conventions.valid.is_usual() && excluded.all().excluded > 0;
  }
  /// Whether enough was judged to exclude defects, undecided answers aside.
  bool is_judged() const { return inside_domain && verdict.compared() > 0 && !too_few_judged(); }
  /// Whether enough was judged, and nothing is undecided.
  bool is_enough_judged() const { return is_judged() && !is_undecided(); }
};

struct CheckReport {
  std::string path;
  scene::Scene scene;
  std::vector<std::string> warnings;
  std::optional<scene::Dialect> dialect;  ///< Of a driver file.
  std::vector<std::string> not_needed;    ///< Entries of the file that are only for shading.
  std::uint64_t rays_in_scene = 0;
  std::uint64_t rays_judged = 0;
  std::vector<CandidateReport> candidates;
  std::size_t top = 0;
  bool interrupted = false;
  bool strict = false;
  std::optional<double> max_error;  ///< A bound that replaces the documented ones.
  std::optional<Ratchet> ratchet;   ///< If it is compared with a baseline.

  /// The scene that a candidate was asked about, and judged by.
  const scene::Scene& scene_of(const CandidateReport& candidate) const {
    return candidate.asked ? *candidate.asked : scene;
  }
  /// A count of all candidates' verdicts together.
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
  /// Whether no candidate has a defect or, in a strict report, anything excused or undecided.
  bool holds() const;
  /// Whether enough was judged, and either decided or known to the baseline as undecided.
  bool is_enough_judged() const;
};

/// Judges the candidates on a scene file; the report does not depend on the number of threads. If
/// `units` is given, judges only the shard's missing units, and returns an empty report unless all
/// units are then present. Throws what load_scene() throws.
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

/// Why too little was judged for a verdict; empty if enough was.
std::string too_few_text(const CandidateReport& candidate);
/// A line for each reason why something was left out, with the candidate's name unless it concerns
/// all.
std::vector<std::string> left_out_lines(const CheckReport& report);

/// Certificates of each candidate's worst discrepancies, as in check_json: one per line.
std::string check_certificates(const CheckReport& report);

/// Options of a page besides the findings of a report.
struct CheckPageOptions {
  std::vector<Selection> wanted;  ///< The selections that are shown first.
  bool is_of_methods = false;     ///< Methods were chosen: panels show only their steps.
};

/// The scene of a report as a page, with its worst discrepancies and largest errors beside it: one
/// view for raycheck's methods, and one for each of the other implementations.
ViewDocument check_document(const CheckReport& report, const CheckPageOptions& options,
                            const properties::RunControl& control);

}  // namespace raycheck::tools
