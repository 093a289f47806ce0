#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "scene/files/format.h"
#include "scene/files/format_words.h"
#include "scene/files/located_fields.h"
#include "scene/interruption.h"
#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::scene {
namespace {

/// The numbers of a slot, the line on which they are, and the word where their statement begins.
struct Given {
  std::array<double, 3> numbers = {};
  std::size_t line = 1;
  std::size_t statement = 0;
};
/// Where a statement's words end, and those of them that a scene needs.
struct Extent {
  std::size_t all, needed;
};

constexpr std::array<std::string_view, 4> kSides = {"left", "right", "bottom", "top"};
/// The slots of a statement.
class GivenSlots {
 public:
  Given& add(std::string_view slot) { return all_.emplace_back(slot, Given()).second; }
  const Given* find(std::string_view slot) const {
    const auto known = std::ranges::find(all_, slot, [](auto& one) { return one.first; });
    return known == all_.end() ? nullptr : &known->second;
  }
  void clear() { all_.clear(); }
  const auto& all() const { return all_; }

 private:
  std::vector<std::pair<std::string_view, Given>> all_;
};

class FormattedReader {
 public:
  FormattedReader(const FileFormat& format, std::string_view text, std::string_view file)
      : format_(format),
        located_(file),
        rows_(defined_rows(format, text, file)),
        words_(format.is_nested() ? words_of(rows_) : words_of(format, text)) {
    for (const auto* fixed : {&format.defaults, &format.fixed}) {
      for (const auto& [slot, numbers] : *fixed) {
        std::ranges::copy(numbers, camera_[slot].numbers.begin());
      }
    }
  }

  LoadedScene read() {
    for (std::size_t at = 0; at < words_.size();) {
      poll();
      at = format_.is_nested() ? block(at) : statement(at);
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
    if (format_.is_left_handed) loaded.scene = mirrored(std::move(loaded.scene));
    for (const auto& [what, count] : left_out_) {
      loaded.not_needed.push_back(count == 1 ? what : std::to_string(count) + " " + what + "s");
    }
    if (material_after_ > 0) {
      loaded.not_needed.push_back("numbers after a sphere's first " +
                                  std::to_string(material_after_));
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
      if (const auto ends = matched(one.parts, at)) {
        is_of_format_ = true;
        take(one, at);
        if (!format_.by_lines) return ends->all;
        if (given_.all().empty()) {
          leave_out(words_[at].text);
        } else {
          look_after(one, at, *ends);
        }
        return next_line(at);
      }
    }
    const std::string_view keyword = words_[at].text;
    if (meant != nullptr) {
      located_.fail(words_[at].line, keyword,
                    "is not followed by what the format " + format_.name +
                        " has: " + joined(meant->parts, " ", shown_part));
    }
    refuse(keyword, at);
    if (!leave_out(keyword) && format_.by_lines && !parse_number(keyword)) warn_unknown(at);
    return format_.by_lines ? next_line(at) : at + 1;
  }
  void refuse(std::string_view keyword, std::size_t at) const {
    const auto refused = format_.refused.find(keyword);
    if (refused == format_.refused.end()) return;
    located_.fail(words_[at].line, keyword, "cannot be read: " + refused->second);
  }
  void warn_unknown(std::size_t at) {
    if (unknown_ == nullptr) unknown_ = &words_[at];
    warn(at, "unknown keyword, ignored");
  }

  /// Reads the block at a word of a nested file, and returns where the next one begins.
  std::size_t block(std::size_t first) {
    const auto found = std::ranges::find_if(format_.statements, [&](const auto& statement) {
      const bool is_read = std::ranges::any_of(
          statement.parts, [](const FormatPart& part) { return part.numbers > 0; });
      return is_read && !statement.rows.empty() && matched(statement.rows.front(), first);
    });
    std::size_t end = first + 1;
    while (end < words_.size() && !words_[end].begins) ++end;
    if (found == format_.statements.end()) {
      leave_out_row(first);
      return end;
    }
    is_of_format_ = true;
    Block its{*found, {}, {}, {}};
    for (std::size_t at = next_line(first); at < end; at = next_line(at)) read_row(its, at);
    if (!its.statement.is_of_sphere) return end;
    for (const auto& [slot, numbers] : format_.defaults) {
      if (its.slots.find(slot) == nullptr) its.slots.add(slot) = camera_.find(slot)->second;
    }
    given_ = its.slots;
    const Given* const centre = given_.find("centre");
    if (centre == nullptr) located_.fail(words_[first].line, words_[first].text, "has no centre");
    take_sphere({centre->numbers, words_[first].line, first});
    const std::string_view left_out = transform(spheres_.back(), its.transformations);
    if (left_out.empty()) return end;
    count(std::string(left_out));
    spheres_.pop_back();
    sphere_lines_.pop_back();
    return end;
  }
  struct Block {
    const FormatStatement& statement;
    GivenSlots slots;
    std::vector<Word> transformations;
    std::set<std::string, std::less<>> left_out;
  };

  void read_row(Block& block, std::size_t at) {
    const std::size_t end = next_line(at);
    if (block.statement.is_of_sphere && words_[at].text == format_.transformation) {
      while (++at < end) block.transformations.push_back(words_[at]);
      return;
    }
    for (const std::vector<FormatPart>& row : block.statement.rows) {
      const auto is_needed = [](const FormatPart& part) {
        return (part.numbers > 0 && !part.slot.starts_with("colour")) || part.slot == kAxis;
      };
      if (std::ranges::none_of(row, is_needed)) continue;
      const auto ends = matched(row, at);
      if (!ends) continue;
      look_after(block.statement, at, *ends);
      if (!block.statement.is_of_sphere) return take(block.statement, at);
      for (const auto& [slot, its] : given_.all()) {
        if (const Given* const first = block.slots.find(slot)) fail_twice(at, first->line);
        block.slots.add(slot) = its;
      }
      return;
    }
    leave_out_row(at, &block);
  }

  /// Refuses a row, or counts it as what its block (of none: "scene") and its first word, its first
  /// two words or its first are called.
  void leave_out_row(std::size_t at, Block* block = nullptr) {
    const std::string word(words_[at].text);
    std::string two = word;
    if (at + 1 < next_line(at)) two.append(" ").append(words_[at + 1].text);
    const std::string its =
        (block == nullptr ? "scene" : block->statement.rows[0][0].word) + " " + word;
    for (const std::string& one : {its, two, word}) {
      refuse(one, at);
      const auto ignored = format_.ignored.find(one);
      if (ignored == format_.ignored.end()) continue;
      if (block == nullptr || block->left_out.insert(ignored->second).second) {
        count(ignored->second);
      }
      return;
    }
    warn_unknown(at);
  }

  /// Translates and scales a ball; what it is called if it is then none that can be read.
  std::string_view transform(Sphere& ball, std::span<const Word> words) const {
    for (std::size_t k = 0; k < words.size();) {
      const Word& name = words[k++];
      std::array<double, 3> by{};
      std::size_t count = 0;
      for (; k < words.size(); ++k, ++count) {
        const auto number = parse_number(words[k].text);
        if (!number) break;
        by.at(std::min<std::size_t>(count, 2)) = *number;
      }
      const bool is_translation = name.text == "translate";
      if (is_translation || name.text == "scale") {
        if (count == 1 && !is_translation) {
          by = {by[0], by[0], by[0]};
        } else if (count != 3) {
          located_.fail(name.line, name.text, "needs 3 numbers, has " + std::to_string(count));
        }
        if (is_translation) {
          ball.centre = {ball.centre.x + by[0], ball.centre.y + by[1], ball.centre.z + by[2]};
          continue;
        }
        const double size = std::abs(by[0]);
        if (std::abs(by[1]) != size || std::abs(by[2]) != size) return "ellipsoid";
        ball.radius *= size;
        ball.centre = {0 + ball.centre.x * by[0], 0 + ball.centre.y * by[1],
                       0 + ball.centre.z * by[2]};
      } else if (!(name.text.starts_with("rotate") || name.text == "angle") ||
                 ball.centre != Point3{}) {
        return "transformed sphere";
      }
    }
    return "";
  }

  /// Counts a statement with an ignored keyword.
  bool leave_out(std::string_view keyword) {
    const auto ignored = format_.ignored.find(keyword);
    if (ignored == format_.ignored.end()) return false;
    count(ignored->second);
    return true;
  }
  void count(const std::string& what) {
    const auto known = std::ranges::find(left_out_, what, &std::pair<std::string, int>::first);
    if (known == left_out_.end()) {
      left_out_.emplace_back(what, 1);
    } else {
      ++known->second;
    }
  }

  /// Notes the words of a line that are not needed: numbers at the end of a sphere's line are its
  /// material.
  void look_after(const FormatStatement& statement, std::size_t first, const Extent& ends) {
    const std::size_t end = next_line(first);
    const std::size_t needed = ends.needed - first - 1;
    const auto is_optional = [](const FormatPart& part) { return part.written == kOptional; };
    const bool has_material = std::ranges::any_of(statement.parts, is_optional);
    if ((has_material ? ends.needed : ends.all) == end) return;
    if (has_material && are_numbers(ends.needed, end)) {
      material_after_ = needed;
    } else {
      warn(first, "numbers after the first " + (needed == 1 ? "" : std::to_string(needed) + " ") +
                      "are ignored");
    }
  }
  bool are_numbers(std::size_t at, std::size_t end) const {
    while (at < end && parse_number(words_[at].text)) ++at;
    return at == end;
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
    const std::size_t row = words_[at].row;
    while (at < words_.size() && words_[at].row == row) ++at;
    return at;
  }

  /// Where a statement that begins at a word ends; empty if its literal words are others.
  std::optional<Extent> matched(const std::vector<FormatPart>& parts, std::size_t first) {
    given_.clear();
    numbers_ = 0;
    const std::size_t end = format_.by_lines ? next_line(first) : words_.size();
    std::size_t at = first, needed = first + 1;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const auto& [word, slot, written, count] = parts[k];
      if (!word.empty()) {
        if (at == end || words_[at].text != word) return {};
        if (format_.is_nested()) first = at;  // its name is in front of it
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
      } else if (count == 0) {
        if (slot == kAxis && at < end) axis_ = &words_[at];
        at = std::min(at + 1, end);
      } else if (written == kOptional) {
        at = std::min(at + count, end);
      } else {
        Given& its = given_.add(slot);
        its.line = words_[first].line;
        its.statement = first;
        for (std::size_t n = 0; n < count; ++n, ++at, ++numbers_) {
          if (at == end) fail_short(parts, first);
          its.numbers[n] = number(slot, first, at);
        }
        needed = at;
      }
    }
    return Extent{at, needed};
  }

  double number(std::string_view slot, std::size_t first, std::size_t at) const {
    const std::string_view text = words_[at].text;
    const auto fail = [&](std::string_view what) {
      const std::string index = std::to_string(at - first - 1);
      located_.fail(words_[at].line, std::string(words_[first].text) + "[" + index + "]", text,
                    what);
    };
    const auto value = parse_number(text);
    if (is_pixels(slot) && !(parse_integer(text) && is_whole(*value))) {
      fail("is not a whole number of pixels");
    }
    if (!value) fail("is not a number");
    return *value;
  }

  [[noreturn]] void fail_short(const std::vector<FormatPart>& parts, std::size_t first) const {
    if (!format_.by_lines) {
      located_.fail(words_[first].line, words_[first].text, "ends before all of its numbers");
    }
    std::size_t needs = 0;
    for (const FormatPart& part : parts) {
      if (part.written != kOptional) needs += part.numbers;
    }
    fail_at(first, "needs " + std::to_string(needs) +
                       (needs == 1 ? " number, has " : " numbers, has ") +
                       std::to_string(numbers_));
  }

  /// Fails about a statement, whose words are its value if it is a line.
  [[noreturn]] void fail_at(std::size_t first, std::string_view what) const {
    const auto& [keyword, line, row, begins] = words_[first];
    if (!format_.by_lines) located_.fail(line, keyword, what);
    located_.fail(line, keyword, rest_of_line(first), what);
  }
  [[noreturn]] void fail_twice(std::size_t at, std::size_t line) const {
    fail_at(at, "is given twice, first on line " + std::to_string(line));
  }
  /// The words after the first, one space apart.
  std::string rest_of_line(std::size_t first) const {
    const std::span<const Word> words(
        words_.begin() + static_cast<std::ptrdiff_t>(first) + 1,
        words_.begin() + static_cast<std::ptrdiff_t>(next_line(first)));
    return joined(words, " ", &Word::text);
  }

  void take(const FormatStatement& statement, std::size_t at) {
    if (const Given* const centre = given_.find("centre")) return take_sphere(*centre);
    for (const auto& [slot, its] : given_.all()) {
      if (statement.is_of_sphere) continue;  // a colour
      const auto [known, is_new] = camera_.try_emplace(std::string(slot), its);
      if (is_new) continue;
      if (!format_.defaults.contains(slot)) {
        fail_twice(at, known->second.line);
      }
      known->second = its;
    }
  }

  void take_sphere(const Given& given) {
    const auto& [centre, line, first] = given;
    double radius = 0;
    if (const Given* const found = given_.find("radius")) {
      radius = found->numbers[0];
    } else if (const Given* const across = given_.find("diameter")) {
      radius = across->numbers[0] / 2;
    } else if (const Given* const scale = given_.find("scale")) {
      const std::array<double, 3>& by = scale->numbers;
      if (by[0] != by[1] || by[1] != by[2]) {
        count("ellipsoid");
        return;
      }
      radius = by[0];
    }
    spheres_.push_back({{centre[0], centre[1], centre[2]}, radius});
    sphere_lines_.push_back(line);
  }

  const std::array<double, 3>* find(std::string_view slot) const {
    const auto found = camera_.find(slot);
    return found == camera_.end() ? nullptr : &found->second.numbers;
  }

  /// The numbers of the first of these slots; the file must have one.
  const std::array<double, 3>& required(std::initializer_list<std::string_view> slots) const {
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
      for (const std::vector<FormatPart>& row : statement.rows) {
        std::string keyword;
        for (const FormatPart& part : row) {
          if (keyword.empty() || (format_.is_nested() && !part.word.empty())) keyword = part.word;
          if (!part.slot.empty() && std::ranges::count(slots, part.slot) > 0) return keyword;
        }
      }
    }
    return std::string(*slots.begin());
  }

  Camera camera() {
    Camera camera;
    const auto triple = [](const std::array<double, 3>& v, auto& to) { to = {v[0], v[1], v[2]}; };
    triple(required({"eye"}), camera.eye);
    if (const auto* view = find("view")) {
      camera.look_at = {camera.eye.x + (*view)[0], camera.eye.y + (*view)[1],
                        camera.eye.z + (*view)[2]};
    } else {
      triple(required({"look_at", "view"}), camera.look_at);
    }
    triple(required({"up"}), camera.up);
    camera.width = static_cast<std::int64_t>(required({"size", "width"}).front());
    camera.height = static_cast<std::int64_t>(required({"size", "height"}).front());
    if (format_.has("distance") || format_.has("near")) required({"distance", "near"});
    camera.near = find("distance") != nullptr ? -signed_number("distance")
                  : find("near") != nullptr   ? signed_number("near")
                                              : -1;
    if (format_.has_angle()) {
      set_angle(camera);
    } else {
      set_window(camera);
    }
    return camera;
  }

  /// The number of a slot that must have a sign.
  double signed_number(std::string_view slot) const {
    const double number = required({slot}).front();
    const int sign = sign_of_slot(slot);
    if (number * sign > 0) return number;
    const std::string keyword = keyword_of({slot});
    std::string what = sign > 0 ? "must be above 0" : "must be below 0";
    what += " in the format " + format_.name;
    bool is_whole = false;
    for (const auto& [name, other] : formats()) {
      for (const FormatStatement& one : other.statements) {
        if (one.keyword() != keyword || one.parts.size() != 2) continue;
        is_whole = true;
        if (sign_of_slot(one.parts[1].slot) != -sign) continue;
        what += (sign > 0 ? ", or below 0 in " : ", or above 0 in ") + name;
      }
    }
    located_.fail(camera_.find(slot)->second.line, is_whole ? keyword : slot, shortest(number),
                  what);
  }

  using Order = std::vector<std::string_view>;
  /// The order of left, right, bottom and top in a format's statement; empty if it has others.
  static Order order_of(const FileFormat& format, std::string_view keyword) {
    Order order;
    for (const FormatStatement& statement : format.statements) {
      if (statement.keyword() != keyword) continue;
      for (const FormatPart& part : statement.parts) {
        if (std::ranges::find(kSides, part.slot) != kSides.end()) order.emplace_back(part.slot);
      }
    }
    return order.size() == kSides.size() ? order : Order{};
  }

  /// Sets the window. If it has no area or is mirrored, but is not in the order of another format
  /// with this keyword, says so.
  void set_window(Camera& camera) {
    std::array<double, kSides.size()> sides{};
    for (std::size_t k = 0; k < sides.size(); ++k) sides[k] = required({kSides[k]}).front();
    std::tie(camera.left, camera.right, camera.bottom, camera.top) = std::tuple_cat(sides);
    const auto [numbers, line, first] = camera_.find("left")->second;
    const Order own = order_of(format_, words_[first].text);
    if (own.empty() || (sides[0] < sides[1] && sides[2] < sides[3])) return;
    for (const auto& [name, other] : formats()) {
      const Order order = order_of(other, words_[first].text);
      if (order.empty() || order == own) continue;
      std::array<double, kSides.size()> as_other{};
      for (std::size_t k = 0; k < sides.size(); ++k) {
        const auto place = std::ranges::find(order, kSides[k]) - order.begin();
        as_other[k] = required({own[static_cast<std::size_t>(place)]}).front();
      }
      const std::string orders =
          " in the order of the format " + format_.name + " (" + joined(own, " ") + "), but ";
      const std::string in_other = " in that of " + name + " (" + joined(order, " ") + ")";
      if (!has_area(sides) && has_area(as_other)) {
        fail_at(first, "have no area" + orders + "have one" + in_other + ": reorder the numbers");
      }
      if (is_mirrored(sides) && !is_mirrored(as_other)) {
        warn(first, "mirror the image" + orders + "not" + in_other);
      }
      return;
    }
  }
  static bool has_area(const std::array<double, 4>& sides) {
    return sides[0] != sides[1] && sides[2] != sides[3];
  }
  static bool is_mirrored(const std::array<double, 4>& sides) {
    return sides[0] > sides[1] || sides[2] > sides[3];
  }

  /// Sets the window by its width or by the angle of view.
  void set_angle(Camera& camera) const {
    const double ratio = static_cast<double>(camera.width) / static_cast<double>(camera.height);
    if (format_.has("window_width")) {
      camera.right = required({"window_width"}).front() / 2;
      camera.top = camera.right / ratio;
    } else {
      auto [slot, angle] = angle_of();
      if (axis_ != nullptr) angle.side = side_of(*axis_);
      const double half_angle = required({slot}).front() * angle.half;
      if (!(half_angle > 0 && half_angle < std::numbers::pi / 2)) {
        located_.fail(
            camera_.find(slot)->second.line, keyword_of({slot}), shortest(required({slot}).front()),
            angle.half >= 0.5 ? "must be an angle of view above 0 and below pi, in radians"
                              : "must be an angle of view above 0 and below 180 degrees");
      }
      double half = std::tan(half_angle) * std::abs(camera.near);
      if (format_.up_widens) half /= sine_between(camera.look_at - camera.eye, camera.up);
      const bool is_vertical = angle.is_vertical(camera);
      camera.top = is_vertical ? half : half / ratio;
      camera.right = is_vertical ? half * ratio : half;
    }
    camera.bottom = -camera.top;
    camera.left = -camera.right;
  }

  /// The side that a word in the place of {fov_axis} means.
  AngleSlot::Side side_of(const Word& word) const {
    for (const char* const name : {"fov", "fov_"}) {
      if (const auto angle = angle_slot(name + std::string(word.text))) return angle->side;
    }
    located_.fail(word.line, "the side of an angle of view", word.text,
                  "must be x, y, larger or smaller");
  }

  /// The slot of the angle that the file or the format gives; if none does, the template's.
  std::pair<std::string_view, AngleSlot> angle_of() const {
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
    return {slot, angle_slot(slot).value()};
  }

  std::optional<std::size_t> line_of(const std::string& field) const {
    constexpr std::string_view kSphere = "sphere[", kCamera = "camera.";
    if (field.starts_with(kSphere)) {
      const auto index = parse_integer(
          std::string_view(field).substr(kSphere.size(), field.find(']') - kSphere.size()));
      return sphere_lines_.at(static_cast<std::size_t>(index.value()));
    }
    const std::string_view name =
        std::string_view(field).substr(std::min(kCamera.size(), field.size()));
    // What is set by a slot of another name.
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kOthers = {
        {{"near", "distance"}, {"look_at", "view"}, {"width", "size"}, {"height", "size"}}};
    auto found = camera_.find(name);
    for (const auto& [of_camera, slot] : kOthers) {
      if (found == camera_.end() && name == of_camera) found = camera_.find(slot);
    }
    return found == camera_.end() ? std::nullopt : std::optional(found->second.line);
  }

  void warn(std::size_t at, const std::string& what) {
    constexpr std::size_t kMostWarnings = 20;
    const auto& [keyword, line, row, begins] = words_[at];
    if (!warned_.emplace(keyword).second || warned_.size() > kMostWarnings) return;
    warnings_.push_back(
        located_.located(line, keyword, what + " (first on line " + std::to_string(line) + ")"));
  }

  const FileFormat& format_;
  LocatedFields located_;
  const std::vector<NestedRow> rows_;
  std::vector<Word> words_;
  const Word* axis_ = nullptr;  ///< The word in the place of {fov_axis}.
  GivenSlots given_;            ///< Of the statement that is read.
  std::size_t numbers_ = 0;     ///< How many numbers it has.
  std::map<std::string, Given, std::less<>> camera_;
  std::vector<Sphere> spheres_;
  std::vector<std::size_t> sphere_lines_;
  /// In the order of the file.
  std::vector<std::pair<std::string, int>> left_out_;
  std::size_t material_after_ = 0;  ///< The needed numbers of a sphere with a material.
  std::vector<std::string> warnings_;
  std::set<std::string_view> warned_;
  bool is_of_format_ = false;      ///< Whether it has a statement of the format.
  const Word* unknown_ = nullptr;  ///< The first unknown keyword.
};

}  // namespace

LoadedScene read_formatted(const FileFormat& format, std::string_view text, std::string_view file) {
  return FormattedReader(format, without_mark(text), file).read();
}

}  // namespace raycheck::scene
