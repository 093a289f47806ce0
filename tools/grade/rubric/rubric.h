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
  kAll,    ///< All points if every case holds, else none.
  kShare,  ///< The share of the cases that hold.
  kSteps   ///< The credit of the highest step that this share reaches.
};
inline constexpr std::array<std::string_view, 3> kCreditNames = {"all", "share", "steps"};

/// From this share of the cases on, this share of the points is given.
struct CreditStep {
  double share = 0;
  double credit = 0;
};

/// When students see an item, in the words of Gradescope.
enum class Visibility { kVisible, kAfterDueDate, kAfterPublished, kHidden };
inline constexpr std::array<std::string_view, 4> kVisibilityNames = {"visible", "after_due_date",
                                                                     "after_published", "hidden"};

/// What students see of a failing case: all, their own answer but not the right one, or nothing.
enum class Detail { kFull, kActualOnly, kNothing };
inline constexpr std::array<std::string_view, 3> kDetailNames = {"full", "actual-only", "nothing"};

/// Allowed errors, in ulp and u of the rubric's precision; with neither, the rubric's `bounds`
/// apply.
struct Tolerance {
  /// Errors up to this many units (ulp, u), and classes that a relative change of the inputs by as
  /// many u may flip.
  std::optional<double> ulp;
  /// Errors up to this factor times the condition number, at least 16, in units; likewise classes
  /// that 16 times as many u may flip.
  std::optional<double> conditioning;
};

/// A scene file that an item asks about.
struct RubricScene {
  std::string name;  ///< Its name in the rubric.
  scene::Scene scene;
};

inline constexpr std::int64_t kMostGradedPixels = std::int64_t{1} << 16;
/// The most rays of a scene that functions are asked about, spread evenly.
inline constexpr std::uint64_t kMostGradedRays = 512;

/// What an item asks: the laws, and the cases to try them on.
struct ItemTask {
  std::vector<const properties::Law*> laws;
  std::vector<RubricScene> scenes;  ///< Every pixel or given ray.
  std::vector<properties::ChosenSource> sources;
  int cases = 0;                       ///< The number of random ones, from the sources in turn.
  bool masks_only = false;             ///< For pictures: whether a pixel shows a sphere, not which.
  std::optional<double> image_change;  ///< For pictures, instead of the rubric's.
  /// For pictures: how the scenes vary with the seed.
  std::vector<properties::Variation> vary = {properties::Variation::kScale,
                                             properties::Variation::kSize};
  bool given_rays = false;  ///< Cameras' rays are raycheck's, not the submission's.
};

struct Item {
  std::string name;
  std::string asks;  ///< The question, for students.
  std::string why;   ///< Its reason: what goes wrong if it fails.
  std::string hint;
  double points = 0;
  bool bonus = false;  ///< Its points are extra.
  Credit credit = Credit::kAll;
  std::vector<CreditStep> steps;
  std::vector<std::string> needs;  ///< Items that come before it and must have all points.
  Tolerance tolerance;
  Visibility visibility = Visibility::kVisible;
  Detail detail = Detail::kFull;
  std::optional<ItemTask> functions;  ///< For libraries and programs; empty: not asked.
  std::optional<ItemTask> pictures;   ///< For renderers.
};

/// A name of letters, digits and hyphens for the files of an item.
std::string file_name(std::string_view item);

/// A form of submission: a folder that contains a file with a matching name.
struct Form {
  std::string has;  ///< A name with * and ?.
  /// Shell words, run in a copy of the folder; "auto": the first way that works; empty: nothing to
  /// build.
  std::string build;
  CandidateSpec program;  ///< {file} is the file found, {program} starts what was built.

  bool is_built_automatically() const { return build == "auto"; }
};

/// How large a submission may be and what it may use, besides time.
struct SubmissionLimits {
  std::uint64_t submission_mib = 64;
  std::uint64_t files = 10000;      ///< In a submission.
  std::uint64_t file_mib = 64;      ///< The largest file that its program writes.
  std::uint64_t disk_mib = 1024;    ///< All files that its program has at a time.
  std::uint64_t memory_mib = 4096;  ///< For its program and its descendants.
  std::uint64_t processes = 64;     ///< And threads.
};

struct Rubric {
  std::string path;
  std::string title;
  properties::DeclaredConventions conventions;  ///< Override what a submission declares.
  double seconds = 120;                         ///< For all questions to a submission.
  double reply_seconds = 5;                     ///< For one reply, or one picture.
  double build_seconds = 120;
  SubmissionLimits limits;
  DriverRule driver;
  std::string dialect;  ///< The text of `driver` if not the file's own; else empty.
  double unjudged = 0;  ///< The share of the points for a submission that cannot be judged.
  /// The format that submissions are judged in, whatever they declare.
  scene::Precision precision = scene::Precision::kDouble;
  double image_change = properties::kExcusedImageChange;
  double t_threshold = 0;
  MethodPair bounds = kDefaultMethods;  ///< Their documented bounds apply to submissions.
  std::vector<Form> forms;
  std::vector<Item> items;
  /// The paths of the scene files that it names, by these names.
  std::map<std::string, std::filesystem::path> scene_files;
};

/// Reads a rubric and the scenes that it names, beside it or among those shipped with raycheck; if
/// there is no such file, the shipped rubric of that name. `dialect` replaces its [driver], see
/// driver_rule(); empty: keep it.
/// Errors: scene::SceneFileError naming file, line, field and value; std::invalid_argument naming
/// the dialect.
Rubric load_rubric(const std::filesystem::path& path, const std::string& dialect = "");

/// Their names, without ".toml", in order.
std::vector<std::string> shipped_rubrics();

/// The path of the one with this name, with or without ".toml"; empty: there is none.
std::optional<std::filesystem::path> shipped_rubric(const std::filesystem::path& name);

/// The path of a scene that one of them names; empty: there is none.
std::optional<std::filesystem::path> shipped_scene(const std::filesystem::path& name);

/// The seed of a submission: the first 64 bits of HMAC-SHA-256 of its name under a secret,
/// unpredictable without the secret.
std::uint64_t secret_seed(std::string_view secret, std::string_view name);

}  // namespace raycheck::tools
