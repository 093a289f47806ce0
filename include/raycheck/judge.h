#ifndef RAYCHECK_JUDGE_H_
#define RAYCHECK_JUDGE_H_

// Judges your code by raycheck's laws in your own process. This is fast, but a crash of your code
// ends the process. C++17; link raycheck::raycheck.
//
//     raycheck::Candidate mine("mine");
//     mine.intersect = [](const raycheck::Ray& ray, const raycheck::Sphere& sphere,
//                         const raycheck::Conventions&) -> std::optional<raycheck::Hit> { ... };
//     const raycheck::Verdict verdict = raycheck::judge(mine, "class");
//     if (!verdict.passes()) std::cerr << verdict.text;

#include <raycheck/api.h>
#include <raycheck/cases.h>
#include <raycheck/scene.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raycheck {

/// The code that is judged. Empty functions are not judged. Functions are called from one thread at
/// a time; an exception counts as a failure to answer.
struct Candidate {
  /// A candidate without functions.
  explicit Candidate(std::string its_name = "candidate") : name(std::move(its_name)) {}

  std::string name;  ///< Its name in verdicts.
  /// The conventions that it fixes; it follows the scene's in all others.
  Conventions declares;
  /// The difficulty of the cases that it must get right; unstated: ordinary.
  Level level = Level::unstated;
  /// Scenes with a nonzero length outside these bounds are not judged; both 0: 2^-960 and inf.
  double smallest_length = 0, largest_length = 0;
  /// single: cases are rounded to floats, passed as doubles; errors and bounds are counted in u and
  /// ulp of float.
  Precision precision = Precision::double_;
  /// usual: every root >= 0 counts; declared: those of declares.valid; as_asked: the scene's.
  Roots roots = Roots::usual;
  Directions directions = Directions::any;  ///< unit: it is called only with unit directions.
  Returns returns = Returns::hit;  ///< Which members of Hit are judged; the others may be anything.

  /// The camera's axes, unit and at right angles.
  std::function<Frame(const Camera&)> frame;
  /// P, a pixel's point on the image plane.
  std::function<Vector(const Camera&, const Conventions&, Pixel)> pixel_point;
  /// The ray from P along D = (P - E)/|P - E|.
  std::function<Ray(const Camera&, const Conventions&, Pixel)> pixel_ray;
  /// The ray from E along D.
  std::function<Ray(const Camera&, const Conventions&, Pixel)> focal_ray;
  /// Where a ray meets a sphere; empty if it misses. Directions need not be unit.
  std::function<std::optional<Hit>(const Ray&, const Sphere&, const Conventions&)> intersect;
  /// The index of the sphere with the least s; empty if all are missed.
  std::function<std::optional<std::size_t>(const Ray&, const std::vector<Sphere>&,
                                           const Conventions&)>
      nearest;
};

/// A law: a property that every correct candidate has.
struct Law {
  std::string name;      ///< "nearest-root"
  std::string sentence;  ///< "the root is the right one: ..."
};

/// Every law, in the order of reports.
[[nodiscard]] RAYCHECK_API std::vector<Law> laws();

/// A law and the source of its cases.
struct Check {
  std::string law;     ///< A name in laws().
  std::string source;  ///< A name in sources().
};

/// The laws that apply to a candidate, each with every source that has cases for it at the
/// candidate's level. Errors: std::invalid_argument naming what is invalid: the candidate has no
/// functions, its range of lengths is empty, or t_min > t_max.
[[nodiscard]] RAYCHECK_API std::vector<Check> checks(const Candidate& candidate);

/// The number of cases, their seed, and the errors that are allowed.
struct JudgeOptions {
  /// For each level up to the candidate's, this number is divided evenly among the sources, and
  /// within a source among its severities up to that level. A severity belongs to its own level and
  /// all harder ones, and gets the largest of its shares in these; the total may therefore exceed
  /// `cases`.
  int cases = 500;
  std::uint64_t seed = 1;  ///< The same seed gives the same cases.
  /// A bound on errors that replaces those of direct/cross, in each quantity's own unit.
  std::optional<double> max_error = {};
  bool strict = false;  ///< Excused or undecided answers break a law, too.
};

/// The outcome of a law: it holds; it is broken; too many cases stayed undecided; too few cases
/// could be judged; no case could be judged; or it does not apply to the candidate.
enum class Finding { holds, broken, undecided, too_few_judged, not_judged, left_out };
/// The finding in words: "too few judged".
[[nodiscard]] RAYCHECK_API std::string name(Finding finding);

/// The first case that breaks a law, or leaves it undecided.
struct BrokenCase {
  Case shrunk;         ///< The case made simpler: one ray or pixel, if one is enough.
  std::string replay;  ///< For replay().
  /// The given answer, the exact answer, and their distance.
  std::string discrepancy;
  /// The classic mistakes that explain the wrong answers; may be empty.
  std::vector<std::string> sentences;
};

/// A law's verdict on a candidate.
struct Verdict {
  std::string law;                      ///< Its name.
  std::string candidate;                ///< The candidate's name.
  Finding finding = Finding::left_out;  ///< The outcome.
  std::uint64_t cases = 0;              ///< Cases tried.
  std::uint64_t comparisons = 0;        ///< Answers compared with the exact ones.
  std::uint64_t excused = 0;            ///< Wrong answers that are right for inputs close by.
  std::string reason;                   ///< Why cases were left out, or too few judged.
  std::optional<BrokenCase> broken;     ///< Set if the law is broken or undecided.
  /// A report to read: the law, the discrepancy, the replay string and the shrunk scene.
  std::string text;

  /// The law was judged, and holds.
  [[nodiscard]] bool holds() const noexcept { return finding == Finding::holds; }
  /// True unless the law is broken, undecided or judged on too few cases. Also true if no case was
  /// judged (not_judged, left_out), for example because the candidate lacks the function.
  [[nodiscard]] bool passes() const noexcept {
    return finding == Finding::holds || finding == Finding::left_out ||
           finding == Finding::not_judged;
  }
};

/// Judges a candidate by a law on random cases of a source: "distance", or "distance@3" with a
/// severity. If `source` is empty, the cases come from every source of the candidate's level. The
/// same arguments give the same verdict. The error bounds are those of direct/cross, unless
/// options.max_error is set.
/// Errors: std::invalid_argument naming an unknown law or source.
[[nodiscard]] RAYCHECK_API Verdict judge(const Candidate& candidate, const std::string& law,
                                         const std::string& source = "",
                                         const JudgeOptions& options = {});

/// Intersects rays with one sphere: for each ray, whether it hits, and the hit if it does. An
/// exception counts as a failure to answer.
using IntersectBatch = std::function<void(const Ray* rays, std::size_t count, const Sphere& sphere,
                                          Hit* hits, bool* is_hit)>;

/// The same for a candidate whose function `intersect`, which must not be empty, is not called:
/// `intersect` intersects all rays of a case in one call, under the conventions that the candidate
/// declares or the defaults.
[[nodiscard]] RAYCHECK_API Verdict judge(const Candidate& candidate,
                                         const IntersectBatch& intersect, const std::string& law,
                                         const std::string& source = "",
                                         const JudgeOptions& options = {});

/// Judges a candidate by a law on one given case. Errors: std::invalid_argument if the case is not
/// valid or the law is unknown.
[[nodiscard]] RAYCHECK_API Verdict judge_case(const Candidate& candidate, const std::string& law,
                                              const Case& the_case,
                                              const JudgeOptions& options = {});

/// Judges the case of a replay string (LAW:CANDIDATE:SOURCE:SEED) again; the CANDIDATE in it is
/// ignored. Errors: std::invalid_argument if the string does not name a law, a source and a seed.
[[nodiscard]] RAYCHECK_API Verdict replay(const Candidate& candidate, const std::string& text,
                                          const JudgeOptions& options = {});

}  // namespace raycheck

#endif  // RAYCHECK_JUDGE_H_
