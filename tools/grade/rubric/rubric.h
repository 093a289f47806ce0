#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/cases/case_source.h"
#include "properties/cases/varied_scene.h"
#include "properties/laws/law.h"
#include "scene/files/scene_file.h"
#include "tools/external/candidate_spec.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/implementations/built_in.h"

namespace raycheck::tools {

/// How an item's points depend on its cases.
enum class Credit {
  kAll,    ///< All points if every case holds, otherwise no points.
  kShare,  ///< The share of the cases that hold.
  kSteps   ///< The credit of the highest step that this share reaches.
};
inline constexpr std::array<std::string_view, 3> kCreditNames = {"all", "share", "steps"};

/// If at least `share` of the cases hold, `credit` of the points are given (both 0 to 1).
struct CreditStep {
  double share = 0;
  double credit = 0;
};

/// When students may see an item, in Gradescope's terms.
enum class Visibility { kVisible, kAfterDueDate, kAfterPublished, kHidden };
inline constexpr std::array<std::string_view, 4> kVisibilityNames = {"visible", "after_due_date",
                                                                     "after_published", "hidden"};

/// What students see of a failing case: everything, only their answer, or nothing.
enum class Detail { kFull, kActualOnly, kNothing };
inline constexpr std::array<std::string_view, 3> kDetailNames = {"full", "actual-only", "nothing"};

/// Allowed errors, in ulp and u of the rubric's precision; with neither, the rubric's `bounds`
/// apply.
struct Tolerance {
  /// Allows errors up to this many units (ulp, u), and excuses hit classes that a relative change
  /// of the inputs by this many u may flip.
  std::optional<double> ulp;
  /// Allows errors up to this factor times the condition number (at least 16) in units, and excuses
  /// hit classes that a change by 16 times this factor in u may flip.
  std::optional<double> conditioning;
};

/// A scene file that an item asks about.
struct RubricScene {
  std::string name;  ///< Its name in the rubric.
  scene::Scene scene;
};

inline constexpr std::int64_t kMostGradedPixels = std::int64_t{1} << 16;
/// The most rays per scene for functions, spread evenly over the scene.
inline constexpr std::uint64_t kMostGradedRays = 512;

/// What an item asks: the laws, and the cases to try them on.
struct ItemTask {
  std::vector<const properties::Law*> laws;
  std::vector<RubricScene> scenes;  ///< Every pixel or given ray.
  std::vector<properties::ChosenSource> sources;
  int cases = 0;            ///< The number of random cases, from the sources in turn.
  bool masks_only = false;  ///< For pictures: judge only whether a pixel shows a sphere, not which.
  std::optional<double> image_change;  ///< For pictures, instead of the rubric's.
  /// For pictures: how the scenes vary with the seed.
  std::vector<properties::Variation> vary = {properties::Variation::kScale,
                                             properties::Variation::kSize};
  bool given_rays = false;  ///< Use raycheck's camera rays instead of the submission's.
};

struct Item {
  std::string name;
  std::string asks;  ///< The question, for students.
  std::string why;   ///< The reason for the question: what goes wrong if it fails.
  std::string hint;
  double points = 0;
  bool bonus = false;  ///< Its points are extra.
  Credit credit = Credit::kAll;
  std::vector<CreditStep> steps;
  std::vector<std::string> needs;  ///< Earlier items that must have all points.
  Tolerance tolerance;
  Visibility visibility = Visibility::kVisible;
  Detail detail = Detail::kFull;
  std::optional<ItemTask> functions;  ///< For libraries and programs; empty: not asked.
  std::optional<ItemTask> pictures;   ///< For renderers; empty: not asked.
};

/// The base name of an item's files: lower-case letters, digits and hyphens.
std::string file_name(std::string_view item);

/// A form of submission: a folder that contains a file with a matching name.
struct Form {
  std::string has;  ///< A name with * and ?.
  /// A shell command run in a copy of the folder; "auto": the first way to build that works; empty:
  /// nothing to build.
  std::string build;
  CandidateSpec program;  ///< {file} is the file found, {program} starts what was built.

  bool is_built_automatically() const { return build == "auto"; }
};

/// Limits on a submission's size and resources, except time.
struct SubmissionLimits {
  std::uint64_t submission_mib = 64;
  std::uint64_t files = 10000;      ///< In a submission.
  std::uint64_t file_mib = 64;      ///< The largest file that its program may write.
  std::uint64_t disk_mib = 1024;    ///< The total size of its program's files at any time.
  std::uint64_t memory_mib = 4096;  ///< For its program and its descendants.
  std::uint64_t processes = 64;     ///< Processes and threads.
};

struct Rubric {
  std::string path;
  std::string title;
  properties::DeclaredConventions conventions;  ///< These override what a submission declares.
  double seconds = 120;                         ///< For all questions to a submission.
  double reply_seconds = 5;                     ///< For one reply, or one picture.
  double build_seconds = 120;
  SubmissionLimits limits;
  DriverRule driver;
  std::string dialect;  ///< The dialect that replaced the file's [driver]; or empty.
  double unjudged = 0;  ///< The share of the points for a submission that cannot be judged.
  /// The precision in which submissions are judged, whatever they declare.
  scene::Precision precision = scene::Precision::kDouble;
  double image_change = properties::kExcusedImageChange;
  double t_threshold = 0;
  MethodPair bounds = kDefaultMethods;  ///< Their documented bounds apply to submissions.
  std::vector<Form> forms;
  std::vector<Item> items;
  /// The scene files that the rubric names: their paths by name.
  std::map<std::string, std::filesystem::path> scene_files;
};

/// Reads a rubric and the scenes that it names, beside it or shipped with raycheck. If the file
/// does not exist, reads the shipped rubric of that name. A non-empty `dialect` replaces its
/// [driver], see driver_rule().
/// Errors: scene::SceneFileError naming file, line, field and value; std::invalid_argument naming
/// the dialect.
Rubric load_rubric(const std::filesystem::path& path, const std::string& dialect = "");

/// The path of a shipped rubric; the name may end in ".toml". Empty: there is no such rubric.
std::optional<std::filesystem::path> shipped_rubric(const std::filesystem::path& name);

/// The path of a scene that comes with the shipped rubrics; empty: there is no such scene.
std::optional<std::filesystem::path> shipped_scene(const std::filesystem::path& name);

/// A line for each shipped rubric: name, title, number of items.
std::string rubrics_text();

/// The text of a shipped rubric's file.
/// Errors: std::invalid_argument if there is no such rubric.
std::string rubric_file(const std::string& name);

/// Copies a shipped rubric and its scenes to a folder; returns a line about what was written.
/// Errors: as rubric_file(); std::invalid_argument if a file exists already, or cannot be written.
std::string copy_rubric(const std::string& name, const std::string& out);

/// The seed of a submission: the first 64 bits of the HMAC-SHA-256 of its name under a secret,
/// unpredictable without the secret.
std::uint64_t secret_seed(std::string_view secret, std::string_view name);

}  // namespace raycheck::tools
