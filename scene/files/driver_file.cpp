#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "scene/files/located_fields.h"
#include "scene/files/scene_file.h"
#include "scene/interruption.h"
#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::scene {
namespace {

constexpr std::string_view kSpace = " \t\v\f";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A line of a driver file that is not empty: a keyword and the words after it.
struct Entry {
  std::string keyword;
  std::vector<std::string> words;
  std::size_t line = 0;  ///< From 1.

  /// The words after the keyword, one space apart.
  std::string joined() const { return scene::joined(words, " "); }
};

/// The entries of a driver file, without comments (from # to the end of a line). All forms of line
/// ends are accepted.
std::vector<Entry> driver_entries(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<Entry> entries;
  for (std::size_t line = 1; !text.empty(); ++line) {
    poll();
    const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view rest = text.substr(0, length);
    rest = rest.substr(0, rest.find('#'));
    const std::size_t line_end = text.substr(length).starts_with("\r\n") ? 2 : 1;
    text.remove_prefix(std::min(length + line_end, text.size()));
    Entry entry{"", {}, line};
    while (rest.find_first_not_of(kSpace) != std::string_view::npos) {
      rest.remove_prefix(rest.find_first_not_of(kSpace));
      const std::string_view word = rest.substr(0, rest.find_first_of(kSpace));
      rest.remove_prefix(word.size());
      if (entry.keyword.empty()) {
        entry.keyword = word;
      } else {
        entry.words.emplace_back(word);
      }
    }
    if (!entry.keyword.empty()) entries.push_back(std::move(entry));
  }
  return entries;
}

struct Bounds {
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
  bool is_degenerate() const { return left == right || bottom == top; }
  bool is_mirrored() const { return left > right || bottom > top; }
};

constexpr std::array<const char*, 3> kBoundsOrders = {
    "left bottom right top", "left right bottom top", "left right bottom top"};

std::string called(Dialect dialect) { return "dialect " + std::string(name(dialect)); }

const char* bounds_order(Dialect dialect) {
  return kBoundsOrders[static_cast<std::size_t>(dialect)];
}

Bounds bounds_of(const std::vector<double>& numbers, Dialect dialect) {
  if (dialect == Dialect::kA) return {numbers[0], numbers[2], numbers[1], numbers[3]};
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

class DriverReader {
 public:
  explicit DriverReader(std::string_view file) : located_(file) {}

  LoadedScene read(std::string_view text, std::optional<Dialect> asked) {
    for (Entry& entry : driver_entries(text)) {
      poll();
      take(std::move(entry));
    }
    refuse_other_kind();
    loaded_.scene.conventions.rows = Rows::kTopFirst;
    loaded_.scene.camera = camera(asked);
    loaded_.not_needed = not_needed();
    located_.require_valid(loaded_.scene,
                           [this](const std::string& field) { return line_of(field); });
    return std::move(loaded_);
  }

 private:
  void take(Entry entry) {
    if (entry.keyword == "sphere") {
      const std::vector<double> numbers = numbers_of(entry, kSphereNumbers);
      sphere_lines_.push_back(entry.line);
      loaded_.scene.spheres.push_back({{numbers[0], numbers[1], numbers[2]}, numbers[3]});
      take_material(entry);
    } else if (kOfShading.contains(entry.keyword)) {
      const auto [counted, is_new] = of_shading_.try_emplace(entry.keyword, 0);
      if (is_new) first_seen_.push_back(entry.keyword);
      ++counted->second;
    } else if (!kOnce.contains(entry.keyword)) {
      warn_once(entry, "unknown keyword, ignored");
      if (unknown_.size() < kFirstWords) unknown_.emplace_back(entry.keyword, entry.line);
    } else {
      const auto [earlier, is_new] = once_.try_emplace(entry.keyword, entry);
      if (is_new) return;
      located_.fail(entry.line, entry.keyword, entry.joined(),
                    "is given twice, first on line " + std::to_string(earlier->second.line));
    }
  }

  /// A file with unknown keywords and no camera, eye, bounds or res is not a driver file.
  void refuse_other_kind() const {
    if (unknown_.empty() || once_.contains("camera") || once_.contains("eye") ||
        once_.contains("bounds") || once_.contains("res")) {
      return;
    }
    std::vector<std::string> words;
    for (const auto& [keyword, line] : unknown_) words.push_back(keyword);
    located_.fail(1, "first words", scene::joined(words),
                  "not a driver file; the name of a TOML file must end in .toml");
  }

  /// Reads the words after a sphere's centre and radius. Numbers there are the sphere's material.
  void take_material(const Entry& entry) {
    if (entry.words.size() <= kSphereNumbers) return;
    const bool are_numbers =
        std::all_of(entry.words.begin() + kSphereNumbers, entry.words.end(),
                    [](const std::string& word) { return parse_number(word).has_value(); });
    has_materials_ = has_materials_ || are_numbers;
    if (!are_numbers) warn_of_extra(entry, kSphereNumbers);
  }

  /// "ambient", "2 lights"
  std::vector<std::string> not_needed() const {
    std::vector<std::string> all;
    for (const std::string& keyword : first_seen_) {
      const int count = of_shading_.at(keyword);
      all.push_back(count == 1 ? keyword : std::to_string(count) + " " + keyword + "s");
    }
    if (has_materials_) all.emplace_back("numbers after a sphere's first 4");
    return all;
  }

  Camera camera(std::optional<Dialect> asked) {
    Camera camera;
    const Entry* const whole = find("camera");
    std::vector<double> view;
    if (whole) {
      for (const char* const keyword : {"eye", "look", "up", "d"}) {
        if (const Entry* const part = find(keyword)) {
          located_.fail(part->line, keyword, part->joined(),
                        "is already given by the camera line, line " + std::to_string(whole->line));
        }
      }
      view = numbers_of(*whole, 10);
      for (const char* const field : {"eye", "look_at", "up", "near"}) put(field, *whole);
    } else {
      view = separate_view();
    }
    camera.eye = {view[0], view[1], view[2]};
    camera.look_at = {view[3], view[4], view[5]};
    camera.up = {view[6], view[7], view[8]};
    const Dialect dialect = dialect_of(view[9], asked);
    loaded_.dialect = dialect;
    camera.near = dialect == Dialect::kA ? -view[9] : view[9];
    take_bounds(dialect, camera);
    const Entry& resolution = required("res");
    camera.width = integer(resolution, 0);
    camera.height = integer(resolution, 1);
    warn_of_extra(resolution, 2);
    put("width", resolution);
    put("height", resolution);
    return camera;
  }

  std::vector<double> separate_view() {
    std::vector<double> view;
    const std::array<std::pair<const char*, const char*>, 3> keywords_and_fields = {
        {{"eye", "eye"}, {"look", "look_at"}, {"up", "up"}}};
    for (const auto& [keyword, field] : keywords_and_fields) {
      const std::vector<double> numbers = numbers_of(required(keyword), 3);
      view.insert(view.end(), numbers.begin(), numbers.end());
      put(field, required(keyword));
    }
    if (!find("d")) {
      fail_missing("d",
                   "; it places the image plane, and its sign distinguishes dialect A (d > 0) from "
                   "dialect B (d < 0)");
    }
    view.push_back(numbers_of(required("d"), 1).front());
    put("near", required("d"));
    return view;
  }

  Dialect dialect_of(double d, std::optional<Dialect> asked) const {
    const Entry* const whole = find("camera");
    const Entry& entry = whole ? *whole : *find("d");
    const std::string value = whole ? entry.words[9] : entry.words[0];
    if (!(d > 0) && !(d < 0)) {
      located_.fail(entry.line, "d", value,
                    "must be above 0 (dialect A) or below 0 (dialects B and C)");
    }
    if (whole && d > 0) located_.fail(entry.line, "d", value, "dialect C needs d < 0");
    const Dialect decided = whole ? Dialect::kC : d > 0 ? Dialect::kA : Dialect::kB;
    if (!asked || *asked == decided) return decided;
    const std::string named = called(*asked) + " (requested by its letter or a year) ";
    if (whole) {
      located_.fail(entry.line, "camera", entry.joined(),
                    named + "has no camera line; this file is dialect C");
    }
    if (*asked == Dialect::kC) {
      located_.fail(entry.line, "d", value,
                    named + "needs a camera line instead; this file is " + called(decided));
    }
    located_.fail(
        entry.line, "d", value,
        named + "needs d " + (d > 0 ? "< 0" : "> 0") + "; this file is " + called(decided));
  }

  void take_bounds(Dialect dialect, Camera& camera) {
    const Entry& entry = required("bounds");
    const std::vector<double> numbers = numbers_of(entry, 4);
    const Bounds bounds = bounds_of(numbers, dialect);
    const Dialect other = dialect == Dialect::kA ? Dialect::kB : Dialect::kA;
    if (bounds.is_degenerate() && !bounds_of(numbers, other).is_degenerate()) {
      located_.fail(entry.line, "bounds", entry.joined(),
                    "have no area in the order of " + called(dialect) + " (" +
                        bounds_order(dialect) + "), but have one in that of " + called(other) +
                        " (" + bounds_order(other) + "): reorder the numbers; dialect " +
                        (other == Dialect::kA ? "A needs d > 0" : "B needs d < 0"));
    }
    if (bounds.is_mirrored() && !bounds_of(numbers, other).is_mirrored()) {
      warn_once(entry, "mirror the image in the order of " + called(dialect) + " (" +
                           bounds_order(dialect) + "), but not in that of " + called(other) + " (" +
                           bounds_order(other) + ")");
    }
    camera.left = bounds.left;
    camera.right = bounds.right;
    camera.bottom = bounds.bottom;
    camera.top = bounds.top;
    for (const char* const field : {"left", "right", "bottom", "top"}) put(field, entry);
  }

  const Entry* find(const std::string& keyword) const {
    const auto found = once_.find(keyword);
    return found == once_.end() ? nullptr : &found->second;
  }

  const Entry& required(const std::string& keyword) const {
    if (const Entry* const entry = find(keyword)) return *entry;
    fail_missing(keyword);
  }

  /// Names the first unknown keyword, too: it may be the missing one, misspelled.
  [[noreturn]] void fail_missing(const std::string& keyword, const std::string& why = "") const {
    if (unknown_.empty()) located_.fail(1, keyword, "is missing" + why);
    const auto& [unknown, line] = unknown_.front();
    located_.fail(line, unknown, "unknown keyword; " + keyword + " is missing" + why);
  }

  void put(const std::string& camera_field, const Entry& entry) {
    lines_["camera." + camera_field] = entry.line;
  }

  /// The line of a field; a field of a sphere ("sphere[12].radius") is on the sphere's line.
  std::optional<std::size_t> line_of(const std::string& field) const {
    const auto known = lines_.find(field);
    if (known != lines_.end()) return known->second;
    constexpr std::string_view kSphere = "sphere[";
    if (!field.starts_with(kSphere)) return std::nullopt;
    const std::string_view rest = std::string_view(field).substr(kSphere.size());
    const auto index = parse_integer(rest.substr(0, rest.find(']')));
    return sphere_lines_.at(static_cast<std::size_t>(index.value()));
  }

  const std::string& word(const Entry& entry, std::size_t index, std::size_t needed) const {
    if (index < entry.words.size()) return entry.words[index];
    located_.fail(entry.line, entry.keyword, entry.joined(),
                  "needs " + std::to_string(needed) +
                      (needed == 1 ? " number, has " : " numbers, has ") +
                      std::to_string(entry.words.size()));
  }

  std::vector<double> numbers_of(const Entry& entry, std::size_t needed) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < needed; ++i) {
      const std::string& text = word(entry, i, needed);
      const std::optional<double> number = parse_number(text);
      if (!number) fail_at(entry, i, "is not a number");
      numbers.push_back(*number);
    }
    if (entry.keyword != "sphere") warn_of_extra(entry, needed);
    return numbers;
  }

  std::int64_t integer(const Entry& entry, std::size_t index) const {
    if (const auto value = parse_integer(word(entry, index, 2))) return *value;
    fail_at(entry, index, "is not a whole number of pixels");
  }

  [[noreturn]] void fail_at(const Entry& entry, std::size_t index, std::string_view what) const {
    located_.fail(entry.line, entry.keyword + "[" + std::to_string(index) + "]", entry.words[index],
                  what);
  }

  void warn_of_extra(const Entry& entry, std::size_t needed) {
    if (entry.words.size() <= needed) return;
    warn_once(entry, "numbers after the first " +
                         (needed == 1 ? "" : std::to_string(needed) + " ") + "are ignored");
  }

  void warn_once(const Entry& entry, const std::string& what) {
    if (!warned_.insert(entry.keyword).second) return;
    if (warned_.size() > kMostWarnings) return;
    loaded_.warnings.push_back(located_.located(
        entry.line, entry.keyword, what + " (first on line " + std::to_string(entry.line) + ")"));
  }

  inline static const std::set<std::string> kOnce = {"eye",    "look", "up",    "d",
                                                     "bounds", "res",  "camera"};
  /// The course's keywords for lights and meshes.
  inline static const std::set<std::string> kOfShading = {"ambient", "light", "model",
                                                          "recursionLevel", "recursionlevel"};
  static constexpr std::size_t kSphereNumbers = 4;
  /// Most lines of a file that is not a driver file would give a warning, each for an unknown word.
  static constexpr std::size_t kMostWarnings = 20;

  LocatedFields located_;
  LoadedScene loaded_;
  std::map<std::string, std::size_t> lines_;  ///< The lines of the camera's fields.
  std::vector<std::size_t> sphere_lines_;
  std::map<std::string, int> of_shading_;
  std::vector<std::string>
      first_seen_;  ///< The keywords of of_shading_, in their order in the file.
  bool has_materials_ = false;
  std::map<std::string, Entry> once_;
  std::set<std::string> warned_;
  static constexpr std::size_t kFirstWords = 3;
  /// The first unknown keywords, and their lines.
  std::vector<std::pair<std::string, std::size_t>> unknown_;
};

}  // namespace

LoadedScene read_driver_file(std::string_view text, std::string_view file,
                             std::optional<Dialect> dialect) {
  return DriverReader(file).read(text, dialect);
}

}  // namespace raycheck::scene
