#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>

#include "scene/files/located_fields.h"
#include "scene/files/scene_file.h"
#include "scene/number.h"

namespace raycheck::scene {
namespace {

constexpr std::string_view kSpace = " \t\v\f";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// One line of the file: a keyword and the words after it.
struct Entry {
  std::string keyword;
  std::vector<std::string> words;
  std::size_t line = 0;
};

struct Bounds {
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
  bool is_degenerate() const { return left == right || bottom == top; }
  bool is_mirrored() const { return left > right || bottom > top; }
};

constexpr std::array<const char*, 3> kDialectNames = {"dialect A", "dialect B", "dialect C"};
constexpr std::array<const char*, 3> kBoundsOrders = {
    "left bottom right top", "left right bottom top", "left right bottom top"};

const char* name(Dialect dialect) { return kDialectNames[static_cast<std::size_t>(dialect)]; }

const char* bounds_order(Dialect dialect) {
  return kBoundsOrders[static_cast<std::size_t>(dialect)];
}

Bounds bounds_of(const std::vector<double>& numbers, Dialect dialect) {
  if (dialect == Dialect::kA) return {numbers[0], numbers[2], numbers[1], numbers[3]};
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::string joined(const Entry& entry) {
  std::string text;
  for (const std::string& word : entry.words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::vector<Entry> entries_of(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<Entry> entries;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view rest = text.substr(0, std::min(text.find('#'), length));
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

class DriverReader {
 public:
  explicit DriverReader(std::string_view file) : located_(file) {}

  LoadedScene read(std::string_view text, std::optional<Dialect> asked) {
    for (Entry& entry : entries_of(text)) take(std::move(entry));
    loaded_.scene.conventions.rows = Rows::kTopFirst;
    loaded_.scene.camera = camera(asked);
    located_.require_valid(loaded_.scene);
    return std::move(loaded_);
  }

 private:
  void take(Entry entry) {
    if (entry.keyword == "sphere") {
      const std::vector<double> numbers = numbers_of(entry, 4);
      const std::string field = "sphere[" + std::to_string(loaded_.scene.spheres.size()) + "]";
      located_.put(field + ".centre", entry.line);
      located_.put(field + ".radius", entry.line);
      loaded_.scene.spheres.push_back({{numbers[0], numbers[1], numbers[2]}, numbers[3]});
    } else if (!kOnce.contains(entry.keyword)) {
      warn_once(entry, "unknown keyword, ignored");
    } else {
      const auto [earlier, is_new] = once_.try_emplace(entry.keyword, entry);
      if (is_new) return;
      located_.fail(entry.line, entry.keyword, joined(entry),
                    "is given twice, first on line " + std::to_string(earlier->second.line));
    }
  }

  Camera camera(std::optional<Dialect> asked) {
    Camera camera;
    const Entry* const whole = find("camera");
    std::vector<double> view;
    if (whole) {
      for (const char* const keyword : {"eye", "look", "up", "d"}) {
        if (const Entry* const part = find(keyword)) {
          located_.fail(part->line, keyword, joined(*part),
                        "contradicts the camera line, line " + std::to_string(whole->line) +
                            ", which already holds it");
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
      located_.fail(1, "d",
                    "is missing; it places the image plane, and its sign tells dialect A (d > 0) "
                    "from dialect B (d < 0)");
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
      located_.fail(entry.line, "d", value, "must be above zero (dialect A) or below (B and C)");
    }
    if (whole && d > 0) located_.fail(entry.line, "d", value, "dialect C needs d < 0");
    const Dialect decided = whole ? Dialect::kC : d > 0 ? Dialect::kA : Dialect::kB;
    if (!asked || *asked == decided) return decided;
    const std::string named = std::string(name(*asked)) + " (asked for) ";
    if (whole) {
      located_.fail(entry.line, "camera", joined(entry),
                    named + "has no camera line; this file is dialect C");
    }
    if (*asked == Dialect::kC) {
      located_.fail(entry.line, "d", value,
                    named + "needs a camera line instead; this file is " + name(decided));
    }
    located_.fail(entry.line, "d", value,
                  named + "needs d " + (d > 0 ? "< 0" : "> 0") + "; this file is " + name(decided));
  }

  void take_bounds(Dialect dialect, Camera& camera) {
    const Entry& entry = required("bounds");
    const std::vector<double> numbers = numbers_of(entry, 4);
    const Bounds bounds = bounds_of(numbers, dialect);
    const Dialect other = dialect == Dialect::kA ? Dialect::kB : Dialect::kA;
    if (bounds.is_degenerate() && !bounds_of(numbers, other).is_degenerate()) {
      located_.fail(entry.line, "bounds", joined(entry),
                    std::string("has no area in ") + name(dialect) + "'s order (" +
                        bounds_order(dialect) + "), but has in " + name(other) + "'s (" +
                        bounds_order(other) + "): reorder the numbers; dialect " +
                        (other == Dialect::kA ? "A needs d > 0" : "B needs d < 0"));
    }
    if (bounds.is_mirrored() && !bounds_of(numbers, other).is_mirrored()) {
      warn_once(entry, std::string("mirror the image in ") + name(dialect) + "'s order (" +
                           bounds_order(dialect) + "), would not in " + name(other) + "'s (" +
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
    located_.fail(1, keyword, "is missing");
  }

  void put(const std::string& camera_field, const Entry& entry) {
    located_.put("camera." + camera_field, entry.line);
  }

  const std::string& word(const Entry& entry, std::size_t index, std::size_t needed) const {
    if (index < entry.words.size()) return entry.words[index];
    located_.fail(
        entry.line, entry.keyword, joined(entry),
        "needs " + std::to_string(needed) + " numbers, has " + std::to_string(entry.words.size()));
  }

  std::vector<double> numbers_of(const Entry& entry, std::size_t needed) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < needed; ++i) {
      const std::string& text = word(entry, i, needed);
      const std::optional<double> number = parse_number(text);
      if (!number) fail_at(entry, i, "is not a number");
      numbers.push_back(*number);
    }
    warn_of_extra(entry, needed);
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
    loaded_.warnings.push_back(located_.located(
        entry.line,
        entry.keyword + ": " + what + " (first on line " + std::to_string(entry.line) + ")"));
  }

  inline static const std::set<std::string> kOnce = {"eye",    "look", "up",    "d",
                                                     "bounds", "res",  "camera"};
  LocatedFields located_;
  LoadedScene loaded_;
  std::map<std::string, Entry> once_;
  std::set<std::string> warned_;
};

}  // namespace

LoadedScene read_driver_file(std::string_view text, std::string_view file,
                             std::optional<Dialect> dialect) {
  return DriverReader(file).read(text, dialect);
}

}  // namespace raycheck::scene
