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
#include "tools/external/pictures/renderer.h"
#include "tools/implementations/built_in.h"

namespace raycheck::tools {

/// How an item's points depend on its cases.
enum class Credit {
  kAll,    ///< All points if every case holds, otherwise no points.
  kShare,  ///< Points in proportion to the share of the cases that hold.
  kSteps   ///< The credit of the highest step that the share of the cases that hold reaches.
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

/// Allowed errors, in ulp and u of the rubric's precision. If neither member is given, the rubric's
/// `bounds` apply.
struct Tolerance {
  /// Allows errors up to this many units (ulp, u), and excuses wrong hit classes that a relative
  /// change of the inputs by this many u may make right.
  std::optional<double> ulp;
  /// Allows errors up to this factor times the condition number (at least 16) in units, and excuses
  /// wrong hit classes that a change of the inputs by 16 times this factor in u may make right.
  std::optional<double> conditioning;
};

/// A scene file that an item asks about.
struct RubricScene {
  std::string name;  ///< Its name in the rubric.
  scene::Scene scene;
};

inline constexpr std::int64_t kMostGradedPixels = std::int64_t{1} << 16;
/// Functions are asked about at most this many rays of a scene, spread evenly.
inline constexpr std::uint64_t kMostGradedRays = 512;

/// What an item asks: the laws, and the cases on which they are tried.
struct ItemTask {
  std::vector<const properties::Law*> laws;
  std::vector<RubricScene> scenes;  ///< Each is asked on every pixel or given ray.
  std::vector<properties::ChosenSource> sources;
  int cases = 0;  ///< The number of random cases, from the sources in turn.
  /// For pictures: whether to judge only if a pixel shows a sphere, not which one.
  bool masks_only = false;
  bool judges_depth = false;  ///< For pictures: whether the numbers of hits are judged, too.
  std::optional<double> image_change;  ///< For pictures: replaces the rubric's.
  /// For pictures: how the scenes vary with the seed.
  std::vector<properties::Variation> vary = {properties::Variation::kScale,
                                             properties::Variation::kSize};
  bool given_rays = false;  ///< Whether to use raycheck's camera rays instead of the submission's.
};

struct Item {
  std::string name;
  std::string asks;  ///< The question, for students.
  std::string why;   ///< The reason for the question: the consequence if it fails.
  std::string hint;
  double points = 0;
  bool bonus = false;  ///< Whether its points are extra.
  Credit credit = Credit::kAll;
  std::vector<CreditStep> steps;
  /// Earlier items that must have all points before this one is asked.
  std::vector<std::string> needs;
  Tolerance tolerance;
  Visibility visibility = Visibility::kVisible;
  Detail detail = Detail::kFull;
  /// The task for libraries and programs; if empty, they are not asked.
  std::optional<ItemTask> functions;
  std::optional<ItemTask> pictures;  ///< The task for renderers; if empty, they are not asked.
};

/// The base name of an item's files: lower-case letters, digits and hyphens.
std::string file_name(std::string_view item);

/// An instructor's program that calls the functions of submissions. It is laid into each
/// submission's folder, in place of a file of its name.
struct Adapter {
  std::string name;  ///< The name of its file.
  std::string text;
};

/// A form of submission. A folder has this form if it contains a file with a matching name.
struct Form {
  std::string has;  ///< The name, with * and ? as wildcards.
  /// A shell command that is run in a copy of the folder; "auto" for the first way to build that
  /// works; empty if there is nothing to build.
  std::string build;
  /// {file} stands for the file found, {program} for the program that was built.
  CandidateSpec program;
  std::optional<Adapter> adapter = {};
  std::string declares = {};  ///< Statements of the contract that submissions have.

  bool is_built_automatically() const { return build == "auto"; }
};

/// Limits on a submission's size and resources, except time.
struct SubmissionLimits {
  std::uint64_t submission_mib = 64;
  std::uint64_t files = 10000;      ///< The number of files in a submission.
  std::uint64_t file_mib = 64;      ///< The largest file that its program may write.
  std::uint64_t disk_mib = 1024;    ///< The total size of its program's files at any time.
  std::uint64_t memory_mib = 4096;  ///< For its program and all descendants together.
  std::uint64_t processes = 64;     ///< Processes and threads.
};

struct Rubric {
  std::string path;
  std::string title;
  /// These override the conventions that a submission declares.
  properties::DeclaredConventions conventions;
  bool rows_either = false;  ///< Whether either image row may be j = 0 (rows = "either").
  /// Whether pixels may be sampled at edges, centres or corners (samples = "either").
  bool samples_either = false;
  /// Whether a picture's pixel is right if some point of its square shows what it shows (samples =
  /// "any"); functions are then judged as with "either".
  bool any_sample = false;
  double seconds = 120;      ///< For all questions to a submission.
  double reply_seconds = 5;  ///< For one reply, or one picture.
  double build_seconds = 120;
  SubmissionLimits limits;
  DriverRule driver;
  std::string dialect;  ///< The dialect that replaced the file's [driver]; or empty.
  double unjudged = 0;  ///< The share of the points that a submission gets if it cannot be judged.
  /// The precision in which submissions are judged, even if they declare another.
  scene::Precision precision = scene::Precision::kDouble;
  double image_change = properties::kExcusedImageChange;
  double t_threshold = 0;
  std::optional<DepthForm> depth = {};  ///< If renderers write depth pictures.
  /// The methods whose documented bounds apply to submissions.
  MethodPair bounds = kDefaultMethods;
  std::vector<Form> forms;
  std::vector<Item> items;
  /// The scenes and adapters that the rubric names: their paths by name.
  std::map<std::string, std::filesystem::path> files;
};

/// Reads a rubric and the scenes that it names, which lie beside it or come with raycheck. If the
/// file does not exist, reads the rubric of that name that comes with raycheck. A `dialect` that is
/// not empty replaces the rubric's [driver] (see driver_rule()).
/// Errors: scene::SceneFileError naming file, line, field and value; std::invalid_argument naming
/// the dialect, or a file that does not exist.
Rubric load_rubric(const std::filesystem::path& path, const std::string& dialect = "");

/// The path of a shipped rubric; the name may end in ".toml". Empty: there is no such rubric.
std::optional<std::filesystem::path> shipped_rubric(const std::filesystem::path& name);
/// The same. Errors: std::invalid_argument with the names of the shipped rubrics.
std::filesystem::path rubric_path(const std::filesystem::path& name);

/// The path of a scene that comes with the shipped rubrics; empty if there is no such scene.
std::optional<std::filesystem::path> shipped_scene(const std::filesystem::path& name);

/// A line for each shipped rubric: name, title, number of items.
std::string rubrics_text();

/// Copies a shipped rubric and its scenes to a folder; returns a line about what was written.
/// Errors: as rubric_path(); std::invalid_argument if a file exists already, or cannot be written.
std::string copy_rubric(const std::string& name, const std::string& out);

/// The seed of a submission: the first 64 bits of the HMAC-SHA-256 of its name under a secret,
/// unpredictable without the secret.
std::uint64_t secret_seed(std::string_view secret, std::string_view name);

}  // namespace raycheck::tools
