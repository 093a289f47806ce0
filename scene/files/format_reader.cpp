#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include "scene/files/format_reading.h"
#include "scene/interruption.h"
#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::scene {
namespace {
class FormattedReader : FormatCamera {
 public:
  FormattedReader(const FileFormat& format, std::string_view text, std::string_view file)
      : FormatCamera(format, text, file) {
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

  std::vector<Sphere> spheres_;
  std::vector<std::size_t> sphere_lines_;
  /// In the order of the file.
  std::vector<std::pair<std::string, int>> left_out_;
  std::size_t material_after_ = 0;  ///< The needed numbers of a sphere with a material.
  bool is_of_format_ = false;       ///< Whether it has a statement of the format.
};

}  // namespace

LoadedScene read_formatted(const FileFormat& format, std::string_view text, std::string_view file) {
  return FormattedReader(format, without_mark(text), file).read();
}

}  // namespace raycheck::scene
