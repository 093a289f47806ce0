#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "scene/files/format.h"
#include "scene/files/located_fields.h"
#include "scene/interruption.h"
#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::scene {
namespace {

struct Word {
  std::string_view text;
  std::size_t line;
};

std::vector<Word> words_of(const FileFormat& format, std::string_view text) {
  const std::string separators = format.separators + " \t\v\f";
  std::vector<Word> words;
  for (std::size_t line = 1; !text.empty(); ++line) {
    poll();
    const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view rest = text.substr(0, length);
    const std::size_t line_end = text.substr(length).starts_with("\r\n") ? 2 : 1;
    text.remove_prefix(std::min(length + line_end, text.size()));
    if (!format.comments.empty()) rest = rest.substr(0, rest.find(format.comments));
    for (std::size_t at = 0; (at = rest.find_first_not_of(separators, at)) != rest.npos;) {
      const std::size_t end = std::min(rest.find_first_of(separators, at), rest.size());
      words.push_back({rest.substr(at, end - at), line});
      at = end;
    }
  }
  return words;
}

/// The numbers of a slot, and the line on which they are.
struct Given {
  std::vector<double> numbers;
  std::size_t line = 1;
};
using GivenSlots = std::map<std::string, Given, std::less<>>;

class FormattedReader {
 public:
  FormattedReader(const FileFormat& format, std::string_view text, std::string_view file)
      : format_(format), located_(file), words_(words_of(format, text)) {
    for (const auto* fixed : {&format.defaults, &format.fixed}) {
      for (const auto& [slot, numbers] : *fixed) camera_[slot] = {numbers, 1};
    }
  }

  LoadedScene read() {
    for (std::size_t at = 0; at < words_.size();) {
      poll();
      at = statement(at);
    }
    if (!is_of_format_) {
      located_.fail(1, "first word", words_.empty() ? "" : words_[0].text,
                    "nothing in the file is a statement of the format " + format_.name);
    }
    LoadedScene loaded;
    loaded.format = format_.name;
    Conventions& conventions = loaded.scene.conventions;
    conventions.rows = format_.rows.value_or(conventions.rows);
    conventions.samples = format_.samples.value_or(conventions.samples);
    conventions.origin = format_.origin.value_or(conventions.origin);
    loaded.scene.spheres = std::move(spheres_);
    loaded.scene.camera = camera();
    for (const auto& [what, count] : left_out_) {
      loaded.not_needed.push_back(count == 1 ? what : std::to_string(count) + " " + what + "s");
    }
    loaded.warnings = std::move(warnings_);
    located_.require_valid(loaded.scene, [&](const std::string& field) { return line_of(field); });
    return loaded;
  }

 private:
  /// Reads the statement at a word, and returns where the next one begins.
  std::size_t statement(std::size_t at) {
    const FormatStatement* meant = nullptr;
    for (const FormatStatement& one : format_.statements) {
      if (one.parts.empty() || one.parts.front().word != words_[at].text) continue;
      if (has_first_words(one, at)) meant = &one;
      GivenSlots given;
      if (const auto end = matched(one, at, given)) {
        is_of_format_ = true;
        take(one, at, given);
        if (!format_.by_lines) return *end;
        const std::size_t next = next_line(at);
        if (*end < next) warn(at, "words after those of the format are ignored");
        return next;
      }
    }
    const auto& [keyword, line] = words_[at];
    if (meant != nullptr) {
      located_.fail(line, keyword,
                    "is not followed by what the format " + format_.name +
                        " has: " + joined(meant->parts, " ", shown_part));
    }
    if (const auto refused = format_.refused.find(keyword); refused != format_.refused.end()) {
      located_.fail(line, keyword, "cannot be read: " + refused->second);
    }
    const auto ignored = format_.ignored.find(keyword);
    if (ignored != format_.ignored.end()) {
      ++left_out_[ignored->second];
    } else if (format_.by_lines && !parse_number(keyword)) {
      if (unknown_ == nullptr) unknown_ = &words_[at];
      warn(at, "unknown keyword, ignored");
    }
    return format_.by_lines ? next_line(at) : at + 1;
  }

  /// Whether the literal words up to the first slot are there, if there is a slot.
  bool has_first_words(const FormatStatement& statement, std::size_t at) const {
    for (const FormatPart& part : statement.parts) {
      if (part.word.empty()) return true;
      if (at == words_.size() || words_[at++].text != part.word) return false;
    }
    return false;
  }
  static std::string shown_part(const FormatPart& part) {
    return part.word.empty() ? "{" + part.slot + "}" : part.word;
  }

  std::size_t next_line(std::size_t at) const {
    const std::size_t line = words_[at].line;
    while (at < words_.size() && words_[at].line == line) ++at;
    return at;
  }

  /// Where a statement that begins at a word ends; empty if its literal words are others.
  std::optional<std::size_t> matched(const FormatStatement& statement, std::size_t first,
                                     GivenSlots& given) const {
    const std::size_t end = format_.by_lines ? next_line(first) : words_.size();
    const std::vector<FormatPart>& parts = statement.parts;
    std::size_t at = first;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const auto& [word, slot, written] = parts[k];
      if (!word.empty()) {
        if (at == end || words_[at].text != word) return {};
        ++at;
      } else if (slot == "*") {
        const std::string_view next =
            k + 1 < parts.size() ? std::string_view(parts[k + 1].word) : "";
        if (next.empty() && !format_.by_lines) continue;
        // The statement of the next sphere begins with the same word.
        while (at < end && (next.empty() || words_[at].text != next)) {
          if (!format_.by_lines && words_[at].text == parts.front().word) return {};
          ++at;
        }
      } else if (const std::size_t count = numbers_of_slot(slot); count > 0) {
        Given& its = given[slot];
        its.line = words_[first].line;
        for (std::size_t n = 0; n < count; ++n, ++at) its.numbers.push_back(number(first, at, end));
      } else {
        at = std::min(at + 1, end);
      }
    }
    return at;
  }

  double number(std::size_t first, std::size_t at, std::size_t end) const {
    const auto& [keyword, line] = words_[first];
    if (at >= end) located_.fail(line, keyword, "ends before all of its numbers");
    if (const auto value = parse_number(words_[at].text)) return *value;
    located_.fail(words_[at].line,
                  std::string(keyword) + "[" + std::to_string(at - first - 1) + "]",
                  words_[at].text, "is not a number");
  }

  void take(const FormatStatement& statement, std::size_t at, GivenSlots& given) {
    if (given.contains("centre")) return take_sphere(given);
    for (auto& [slot, its] : given) {
      if (statement.is_of_sphere) continue;  // a colour
      const auto [known, is_new] = camera_.try_emplace(slot, its);
      if (is_new) continue;
      if (!format_.defaults.contains(slot)) {
        located_.fail(words_[at].line, words_[at].text,
                      "is given twice, first on line " + std::to_string(known->second.line));
      }
      known->second = its;
    }
  }

  void take_sphere(const GivenSlots& given) {
    const auto& [centre, line] = given.at("centre");
    double radius = 0;
    if (const auto found = given.find("radius"); found != given.end()) {
      radius = found->second.numbers[0];
    } else if (const auto across = given.find("diameter"); across != given.end()) {
      radius = across->second.numbers[0] / 2;
    } else if (const auto scale = given.find("scale"); scale != given.end()) {
      const std::vector<double>& by = scale->second.numbers;
      if (by[0] != by[1] || by[1] != by[2]) {
        ++left_out_["ellipsoid"];
        return;
      }
      radius = by[0];
    }
    spheres_.push_back({{centre[0], centre[1], centre[2]}, radius});
    sphere_lines_.push_back(line);
  }

  const std::vector<double>* find(std::string_view slot) const {
    const auto found = camera_.find(slot);
    return found == camera_.end() ? nullptr : &found->second.numbers;
  }

  /// The numbers of the first of these slots; the file must have one.
  const std::vector<double>& required(std::initializer_list<std::string_view> slots) const {
    for (const std::string_view slot : slots) {
      if (const auto* numbers = find(slot)) return *numbers;
    }
    const std::string missing = " is missing, which the format " + format_.name + " needs";
    const std::string keyword = keyword_of(slots);
    if (unknown_ == nullptr) located_.fail(1, keyword, missing.substr(1));
    located_.fail(unknown_->line, unknown_->text, "unknown keyword; " + keyword + missing);
  }
  /// The keyword of the statement with one of these slots.
  std::string keyword_of(std::initializer_list<std::string_view> slots) const {
    for (const FormatStatement& statement : format_.statements) {
      for (const FormatPart& part : statement.parts) {
        if (std::ranges::find(slots, part.slot) != slots.end() && !part.slot.empty()) {
          return statement.parts.front().word;
        }
      }
    }
    return std::string(*slots.begin());
  }

  Camera camera() const {
    Camera camera;
    const auto triple = [](const std::vector<double>& v, auto& to) { to = {v[0], v[1], v[2]}; };
    triple(required({"eye"}), camera.eye);
    if (const auto* view = find("view")) {
      camera.look_at = {camera.eye.x + (*view)[0], camera.eye.y + (*view)[1],
                        camera.eye.z + (*view)[2]};
    } else {
      triple(required({"look_at", "view"}), camera.look_at);
    }
    triple(required({"up"}), camera.up);
    camera.width = pixels("width");
    camera.height = pixels("height");
    const auto* distance = find("distance");
    camera.near = distance != nullptr ? -distance->front()
                  : find("near")      ? find("near")->front()
                                      : -1;
    if (format_.has_angle()) {
      set_angle(camera);
    } else {
      camera.left = required({"left"}).front();
      camera.right = required({"right"}).front();
      camera.bottom = required({"bottom"}).front();
      camera.top = required({"top"}).front();
    }
    return camera;
  }

  std::int64_t pixels(std::string_view side) const {
    const auto* both = find("size");
    const double count = (both != nullptr ? *both : required({side})).front();
    if (count == std::floor(count) && std::abs(count) < 0x1p53)
      return static_cast<std::int64_t>(count);
    const auto found = camera_.find(side);
    located_.fail(found == camera_.end() ? 1 : found->second.line, side, shortest(count),
                  "is not a whole number of pixels");
  }

  /// Sets the window by the angle of view.
  void set_angle(Camera& camera) const {
    std::vector<std::string_view> slots;
    for (const FormatStatement& statement : format_.statements) {
      for (const FormatPart& part : statement.parts) {
        if (angle_slot(part.slot)) slots.push_back(part.slot);
      }
    }
    for (const auto& [slot, numbers] : format_.fixed) {
      if (angle_slot(slot)) slots.push_back(slot);
    }
    const auto given =
        std::ranges::find_if(slots, [&](auto slot) { return find(slot) != nullptr; });
    const std::string_view slot = given == slots.end() ? slots.front() : *given;
    const auto angle = angle_slot(slot);
    const double half = std::tan(required({slot}).front() * angle->half) * std::abs(camera.near);
    const double ratio = static_cast<double>(camera.width) / static_cast<double>(camera.height);
    const bool is_vertical = angle->is_vertical(camera);
    camera.top = is_vertical ? half : half / ratio;
    camera.right = is_vertical ? half * ratio : half;
    camera.bottom = -camera.top;
    camera.left = -camera.right;
  }

  std::optional<std::size_t> line_of(const std::string& field) const {
    constexpr std::string_view kSphere = "sphere[", kCamera = "camera.";
    if (field.starts_with(kSphere)) {
      const auto index = parse_integer(
          std::string_view(field).substr(kSphere.size(), field.find(']') - kSphere.size()));
      return sphere_lines_.at(static_cast<std::size_t>(index.value()));
    }
    const auto found =
        camera_.find(std::string_view(field).substr(std::min(kCamera.size(), field.size())));
    return found == camera_.end() ? std::nullopt : std::optional(found->second.line);
  }

  void warn(std::size_t at, const std::string& what) {
    constexpr std::size_t kMostWarnings = 20;
    const auto& [keyword, line] = words_[at];
    if (!warned_.emplace(keyword).second || warned_.size() > kMostWarnings) return;
    warnings_.push_back(
        located_.located(line, keyword, what + " (first on line " + std::to_string(line) + ")"));
  }

  const FileFormat& format_;
  LocatedFields located_;
  std::vector<Word> words_;
  GivenSlots camera_;
  std::vector<Sphere> spheres_;
  std::vector<std::size_t> sphere_lines_;
  std::map<std::string, int> left_out_;
  std::vector<std::string> warnings_;
  std::set<std::string_view> warned_;
  bool is_of_format_ = false;      ///< Whether it has a statement of the format.
  const Word* unknown_ = nullptr;  ///< The first unknown keyword.
};

}  // namespace

LoadedScene read_formatted(const FileFormat& format, std::string_view text, std::string_view file) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return FormattedReader(format, text, file).read();
}

}  // namespace raycheck::scene
