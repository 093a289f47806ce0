#include "tools/grade/rubric/rubric.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <set>

#include "scene/files/file_text.h"
#include "scene/files/toml_fields.h"
#include "scene/invalid_input.h"
#include "scene/validate.h"
#include "tools/external/external_candidate.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;
using scene::TomlFields;
using Field = TomlFields::Field;
using Table = TomlFields::Table;

constexpr std::array<std::string_view, 3> kJudgeNames = {"spheres", "mask", "depth"};
enum class Judged { kSpheres, kMask, kDepth };
constexpr std::array<std::string_view, 2> kRaysNames = {"own", "given"};
constexpr double kMostSeconds = 86400;
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr std::int64_t kMostCases = 1000000;
constexpr std::int64_t kMostOfLimit = std::int64_t{1} << 20;
constexpr std::string_view kNotNegative = "must be 0 or more, and finite";
constexpr std::string_view kShare = "must be between 0 and 1";

class RubricReader {
 public:
  explicit RubricReader(const fs::path& path) : path_(path), fields_(path.string()) {}

  Rubric read() {
    const toml::table root = scene::parse_toml(scene::file_text(path_), path_.string());
    const Table file{root, "rubric", "", 1};
    fields_.require_known(file, {"title", "seconds", "reply_seconds", "build_seconds", "driver",
                                 "precision", "image_change", "t_threshold", "depth", "bounds",
                                 "limits", "conventions", "tolerance", "form", "item", "unjudged"});
    Rubric rubric;
    rubric.path = path_.string();
    rubric.title = given_text(file, "title", path_.stem().string());
    read_seconds(file, rubric);
    if (const auto field = fields_.optional(file, "driver")) {
      rubric.driver = read_driver(fields_, fields_.table(*field), path_.parent_path());
      if (const auto* format = rubric.driver.form.format; format->is_of_user()) {
        files_[format->path.filename().string()] = format->path;
      }
    }
    if (const auto field = fields_.optional(file, "limits")) {
      read_limits(fields_.table(*field), rubric);
    }
    fields_.choose(file, "precision", scene::kPrecisionNames, rubric.precision);
    unit_ = scene::unit_roundoff(rubric.precision);
    rubric.image_change = properties::excused_image_change(rubric.precision);
    set_between(file, "image_change", 0, kLargest, kNotNegative, rubric.image_change);
    set_between(file, "t_threshold", 0, kLargest, kNotNegative, rubric.t_threshold);
    set_between(file, "unjudged", 0, 1, kShare, rubric.unjudged);
    read_by(depth_form, file, "depth", rubric.depth);
    is_of_depths_ = rubric.depth.has_value();
    read_by(find_pair, file, "bounds", rubric.bounds);
    if (const auto field = fields_.optional(file, "conventions")) {
      const Table conventions = fields_.table(*field);
      std::vector<std::string_view> either;
      for (const auto& [key, is_either] :
           {std::pair(std::string_view("rows"), &rubric.rows_either),
            std::pair(std::string_view("samples"), &rubric.samples_either)}) {
        const auto choice = fields_.optional(conventions, key);
        const auto value = choice ? choice->node.value<std::string_view>() : std::nullopt;
        if (key == "samples" && value == "any") rubric.any_sample = true;
        *is_either = value == "either" || (key == "samples" && rubric.any_sample);
        if (*is_either) either.emplace_back(key);
      }
      scene::read_conventions(fields_, conventions, rubric.conventions, either);
      for (const scene::Defect& defect : defects(rubric.conventions.over(scene::Conventions{}))) {
        const std::string key = defect.field.substr(defect.field.find('.') + 1);
        fields_.fail(fields_.required(conventions, key), defect.what);
      }
      conventions_ = rubric.conventions;
      any_sample_ = rubric.any_sample;
      if (any_sample_ && !rubric.conventions.valid.value_or(scene::ValidRoots{}).is_usual()) {
        fields_.fail(fields_.required(conventions, "samples"),
                     "is judged only where every root >= 0 counts; leave out t_min, t_max, "
                     "interval, t_unit and culling, or give other samples");
      }
    }
    if (const auto field = fields_.optional(file, "tolerance")) tolerance_ = tolerance(*field);
    for (const Table& each : fields_.tables(file, "form")) rubric.forms.push_back(form(each));
    for (const Table& each : fields_.tables(file, "item")) rubric.items.push_back(item(each));
    if (rubric.items.empty()) fields_.fail(fields_.required(file, "item"), "has no items");
    rubric.files = files_;
    return rubric;
  }

 private:
  std::string given_text(const Table& from, std::string_view key, std::string otherwise) const {
    const auto field = fields_.optional(from, key);
    return field ? fields_.text(*field) : std::move(otherwise);
  }
  double number_between(const Field& field, double least, double most,
                        std::string_view what) const {
    const double value = fields_.number(field);
    if (!(value >= least && value <= most)) fields_.fail(field, what);
    return value;
  }
  template <class Read, class Value>
  void read_by(Read parse, const Table& from, std::string_view key, Value& value) const {
    const auto field = fields_.optional(from, key);
    if (!field) return;
    try {
      value = parse(fields_.text(*field));
    } catch (const std::invalid_argument& error) {
      fields_.fail(*field, error.what());
    }
  }
  void read_seconds(const Table& from, Rubric& rubric) const {
    for (const auto& [key, value] :
         {std::pair("seconds", &rubric.seconds), std::pair("reply_seconds", &rubric.reply_seconds),
          std::pair("build_seconds", &rubric.build_seconds)}) {
      const auto field = fields_.optional(from, key);
      if (!field) continue;
      *value = number_between(*field, 0, kMostSeconds, "must be above 0, and at most a day");
      if (*value == 0) fields_.fail(*field, "must be above 0");
    }
  }
  template <class Number>
  void set_between(const Table& from, std::string_view key, double least, double most,
                   std::string_view what, Number& value) const {
    if (const auto field = fields_.optional(from, key)) {
      value = number_between(*field, least, most, what);
    }
  }

  Tolerance tolerance(const Field& field) {
    const Table from = fields_.table(field);
    fields_.require_known(from, {"ulp", "conditioning"});
    Tolerance result;
    for (const auto& [key, value] :
         {std::pair("ulp", &result.ulp), std::pair("conditioning", &result.conditioning)}) {
      const auto given = fields_.optional(from, key);
      if (!given) continue;
      *value = number_between(*given, 0, kLargest, kNotNegative);
      if (**value * unit_ >= 1) {
        fields_.fail(*given, "allows every answer; the unit is an ulp of the rubric's precision");
      }
    }
    if (result.ulp && result.conditioning) {
      fields_.fail(field, "has both ulp and conditioning; give one");
    }
    return result;
  }

  Form form(const Table& from) {
    fields_.require_known(from, {"has", "build", "candidate", "adapter", "declares"});
    Form result{.has = fields_.text(fields_.required(from, "has")),
                .build = given_text(from, "build", ""),
                .program = {}};
    if (const auto field = fields_.optional(from, "adapter")) result.adapter = adapter_of(*field);
    const std::string usual = result.adapter ? usual_candidate(result.adapter->name) : "";
    const bool is_usual = !usual.empty() && !fields_.optional(from, "candidate");
    const auto candidate = [&] { return fields_.required(from, "candidate"); };
    result.program = is_usual ? parse_candidate(usual) : program(candidate());
    if (const auto field = fields_.optional(from, "declares")) {
      result.declares = contract_of(*field, result.program);
    }
    if (result.has.find('/') != std::string::npos) {
      fields_.fail(fields_.required(from, "has"), "must be a file name, without a folder");
    }
    const bool has_program = result.program.what.find("{program}") != std::string::npos;
    if (has_program && !result.is_built_automatically()) {
      fields_.fail(candidate(), "{program} requires build = \"auto\"");
    }
    if (result.is_built_automatically() && !(has_program && result.program.is_words())) {
      fields_.fail(candidate(), "build = \"auto\" requires {program} in a renderer: or command:");
    }
    return result;
  }

  std::string contract_of(const Field& field, const CandidateSpec& program) {
    External external;
    if (program.kind == CandidateKind::kRenderer) external.renderer.emplace();
    std::string statements = fields_.text(field);
    std::string wrong;
    try {
      declare_over(statements, external);
    } catch (const std::invalid_argument& error) {
      wrong = error.what();
    }
    if (!wrong.empty()) fields_.fail(field, wrong);
    return statements;
  }

  Adapter adapter_of(const Field& field) {
    const std::string name = fields_.text(field);
    const fs::path path = path_.parent_path() / name;
    if (name != path.filename()) fields_.fail(field, "must be a file name, without a folder");
    if (!fs::is_regular_file(path)) fields_.fail(field, "is not a file beside the rubric");
    files_[name] = path;
    return {name, scene::file_text(path)};
  }

  /// The candidate of an adapter in C, C++, Python or JavaScript; empty for others.
  static std::string usual_candidate(const std::string& adapter) {
    const std::string ending = fs::path(adapter).extension().string();
    if (ending == ".cpp" || ending == ".cc" || ending == ".c") return "source:" + adapter;
    if (ending == ".py") return "command:python3 " + adapter;
    if (ending == ".mjs" || ending == ".js") return "command:node " + adapter;
    return "";
  }

  void read_limits(const Table& from, Rubric& rubric) {
    SubmissionLimits& limits = rubric.limits;
    const std::array<std::pair<std::string_view, std::uint64_t*>, 6> whole = {
        {{"submission_mib", &limits.submission_mib},
         {"files", &limits.files},
         {"file_mib", &limits.file_mib},
         {"disk_mib", &limits.disk_mib},
         {"memory_mib", &limits.memory_mib},
         {"processes", &limits.processes}}};
    std::vector<std::string_view> known = {"seconds", "reply_seconds", "build_seconds"};
    for (const auto& [key, value] : whole) known.push_back(key);
    fields_.require_known(from, known);
    read_seconds(from, rubric);
    for (const auto& [key, value] : whole) {
      const auto field = fields_.optional(from, key);
      if (!field) continue;
      const std::int64_t given = fields_.integer(*field, "a whole number");
      if (given < 1 || given > kMostOfLimit) fields_.fail(*field, "must be 1 to 1048576");
      *value = static_cast<std::uint64_t>(given);
    }
  }

  CandidateSpec program(const Field& field) const {
    try {
      return parse_candidate(fields_.text(field));
    } catch (const CandidateError& error) {
      fields_.fail(field, error.why());
    }
  }

  void read_steps(const Table& from, Item& item) {
    const auto field = fields_.optional(from, "steps");
    if (item.credit == Credit::kSteps && !field) {
      fields_.located().fail(from.line, from.prefix + "steps",
                             "is missing: [[share, credit], ...]");
    }
    if (!field) return;
    if (item.credit != Credit::kSteps) fields_.fail(*field, "requires credit = \"steps\"");
    for (const Field& step : fields_.list(*field)) {
      const auto pair = fields_.list(step);
      if (pair.size() != 2) fields_.fail(step, "must be [share, credit]");
      item.steps.push_back(
          {number_between(pair[0], 0, 1, kShare), number_between(pair[1], 0, 1, kShare)});
    }
  }

  Item item(const Table& from) {
    fields_.require_known(
        from, {"name", "asks", "why", "hint", "points", "bonus", "credit", "steps", "requires",
               "tolerance", "visibility", "detail", "functions", "pictures"});
    Item result;
    const Field name = fields_.required(from, "name");
    result.name = fields_.text(name);
    if (result.name.empty()) fields_.fail(name, "is empty");
    if (names_.contains(result.name)) fields_.fail(name, "is already the name of an earlier item");
    result.asks = given_text(from, "asks", "");
    result.why = given_text(from, "why", "");
    result.hint = given_text(from, "hint", "");
    result.points = number_between(fields_.required(from, "points"), 0, 1e9, "must be 0 to 10^9");
    if (const auto field = fields_.optional(from, "bonus")) result.bonus = fields_.flag(*field);
    fields_.choose(from, "credit", kCreditNames, result.credit);
    read_steps(from, result);
    if (const auto field = fields_.optional(from, "requires")) {
      for (const Field& needed : fields_.list(*field)) {
        result.needs.push_back(fields_.text(needed));
        if (!names_.contains(result.needs.back())) {
          fields_.fail(needed, "is not the name of an earlier item");
        }
      }
    }
    if (!file_names_.insert(file_name(result.name)).second) {
      fields_.fail(name,
                   "has the same letters and digits as an earlier item, so their files would have "
                   "the same names");
    }
    names_.insert(result.name);
    const auto tolerance_given = fields_.optional(from, "tolerance");
    result.tolerance = tolerance_given ? tolerance(*tolerance_given) : tolerance_;
    fields_.choose(from, "visibility", kVisibilityNames, result.visibility);
    fields_.choose(from, "detail", kDetailNames, result.detail);
    if (const auto field = fields_.optional(from, "functions")) {
      result.functions = task(*field, false);
    }
    if (const auto field = fields_.optional(from, "pictures")) {
      result.pictures = task(*field, true);
    }
    if (!result.functions && !result.pictures) {
      fields_.located().fail(from.line, from.prefix + "functions",
                             "is missing, and so is pictures; give at least one of them");
    }
    return result;
  }

  ItemTask task(const Field& field, bool pictures) {
    const Table from = fields_.table(field);
    if (pictures) {
      fields_.require_known(from, {"judge", "image_change", "vary", "scenes", "sources", "cases"});
    } else {
      fields_.require_known(from, {"laws", "scenes", "sources", "cases", "rays"});
    }
    ItemTask result;
    if (pictures) {
      result.laws = properties::laws_that(
          [](const properties::Law& law) { return law.per == properties::Per::kImage; });
      Judged judged = Judged::kSpheres;
      fields_.choose(from, "judge", kJudgeNames, judged);
      if (judged == Judged::kDepth && !is_of_depths_) {
        fields_.fail(fields_.required(from, "judge"),
                     "needs the rubric's key depth, such as depth = \"distance miss inf\"");
      }
      if (judged == Judged::kDepth && any_sample_) {
        fields_.fail(fields_.required(from, "judge"),
                     "is not possible with conventions.samples = \"any\": the depth of a pixel "
                     "depends on its sample; give edges, centres or corners, or judge = \"mask\"");
      }
      if (judged == Judged::kSpheres && is_of_depths_) {
        fields_.fail(fields_.optional(from, "judge").value_or(field),
                     "needs judge = \"mask\" or \"depth\", because the rubric's key depth asks for "
                     "depth pictures, which do not show which sphere is seen");
      }
      result.masks_only = judged != Judged::kSpheres;
      result.judges_depth = judged == Judged::kDepth;
      set_between(from, "image_change", 0, 1, kShare, result.image_change);
      if (const auto vary = fields_.optional(from, "vary")) result.vary = variations(*vary);
    } else {
      const Field laws = fields_.required(from, "laws");
      for (const Field& name : fields_.list(laws)) {
        result.laws.push_back(properties::find_law(fields_.text(name)));
        if (result.laws.back() == nullptr) {
          fields_.fail(name, "is not a law; `raycheck list` shows the laws");
        }
      }
      if (result.laws.empty()) fields_.fail(laws, "is empty; give at least one law");
      fields_.choose(from, "rays", kRaysNames, result.given_rays);
    }
    if (const auto scenes = fields_.optional(from, "scenes")) {
      for (const Field& name : fields_.list(*scenes))
        result.scenes.push_back(scene_of(name, pictures));
    }
    read_sources(from, pictures, result);
    if (result.scenes.empty() && result.sources.empty()) {
      fields_.fail(field, "needs scenes or sources");
    }
    return result;
  }

  /// Reads how the scenes of an item's pictures vary with the seed.
  std::vector<properties::Variation> variations(const Field& field) const {
    const auto& names = properties::kVariationNames;
    std::vector<properties::Variation> found;
    for (const Field& each : fields_.list(field)) {
      const auto name = std::ranges::find(names, fields_.text(each));
      if (name == names.end()) {
        fields_.fail(each, fmt::format("must be one of {}", fmt::join(names, ", ")));
      }
      found.push_back(static_cast<properties::Variation>(name - names.begin()));
    }
    return found;
  }

  void read_sources(const Table& from, bool pictures, ItemTask& result) {
    if (const auto sources = fields_.optional(from, "sources")) {
      for (const Field& name : fields_.list(*sources)) {
        try {
          result.sources.push_back(properties::chosen_source(fields_.text(name)));
        } catch (const std::invalid_argument& error) {
          fields_.fail(name, std::string(error.what()) + "; `raycheck list` shows the sources");
        }
        if (pictures && !result.sources.back().source->has_camera) {
          fields_.fail(name, "has no cameras, which pictures need");
        }
      }
    }
    const auto cases = fields_.optional(from, "cases");
    if (!result.sources.empty() && !cases) fields_.required(from, "cases");
    if (!cases) return;
    const std::int64_t count = fields_.integer(*cases, "a whole number of cases");
    if (count < 1 || count > kMostCases) fields_.fail(*cases, "must be 1 to 1000000");
    if (result.sources.empty()) fields_.fail(*cases, "requires sources");
    result.cases = static_cast<int>(count);
  }

  RubricScene scene_of(const Field& field, bool pictures) {
    const std::string name = fields_.text(field);
    if (fs::path(name).is_absolute() || name.find("..") != std::string::npos) {
      fields_.fail(field, "must be a path below the rubric's folder");
    }
    const fs::path path = path_of_scene(field, name);
    const scene::Scene scene = [&] {
      try {
        return scene::load_scene(path).scene;
      } catch (const scene::SceneFileError& error) {
        fields_.fail(field, error.what());
      }
    }();
    if (pictures && !scene.camera) fields_.fail(field, "has no camera, which a picture needs");
    if (pictures && scene.camera->width > kMostGradedPixels / scene.camera->height) {
      fields_.fail(field, "has more than 65536 pixels");
    }
    const std::vector<scene::Defect> wrong = defects(conventions_.over(scene.conventions));
    if (!wrong.empty()) {
      fields_.fail(field, "contradicts the rubric's conventions: " + sentences(wrong));
    }
    files_[name] = path;
    return {name, scene};
  }

  /// The path of a scene beside the rubric or, if there is none, of that name among the scenes that
  /// come with raycheck.
  fs::path path_of_scene(const Field& field, const std::string& name) const {
    fs::path beside = path_.parent_path() / name;
    if (fs::exists(beside)) return beside;
    if (const auto shipped = shipped_scene(name)) return *shipped;
    fields_.fail(field, "is neither beside the rubric nor a scene that comes with raycheck");
  }

  fs::path path_;
  TomlFields fields_;
  Tolerance tolerance_;
  double unit_ = properties::kDoubleRoundoff;  ///< The unit of every tolerance.
  contract::DeclaredConventions conventions_;
  bool is_of_depths_ = false, any_sample_ = false;
  std::set<std::string> names_;
  std::set<std::string> file_names_;
  std::map<std::string, fs::path> files_;
};

}  // namespace

Rubric load_rubric(const fs::path& path, const std::string& dialect) {
  Rubric rubric = RubricReader(fs::exists(path) ? path : rubric_path(path)).read();
  if (dialect.empty()) return rubric;
  try {
    rubric.driver = driver_rule(dialect);
  } catch (const std::invalid_argument& error) {
    throw scene::InvalidInput("dialect", dialect, error.what());
  }
  rubric.dialect = dialect;
  return rubric;
}

}  // namespace raycheck::tools
