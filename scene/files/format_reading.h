#pragma once

#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/files/format.h"
#include "scene/files/format_words.h"
#include "scene/files/located_fields.h"

namespace raycheck::scene {

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

/// Matches statements of a format with the words of a file.
class FormatStatements {
 protected:
  FormatStatements(const FileFormat& format, std::string_view text, std::string_view file)
      : format_(format),
        located_(file),
        rows_(defined_rows(format, text, file)),
        words_(format.is_nested() ? words_of(rows_) : words_of(format, text)) {}

  void refuse(std::string_view keyword, std::size_t at) const;
  void warn(std::size_t at, const std::string& what);
  void warn_unknown(std::size_t at);
  /// Whether the literal words up to the first slot are there, if there is a slot.
  bool has_first_words(const FormatStatement& statement, std::size_t at) const;
  static std::string shown_part(const FormatPart& part);
  std::size_t next_line(std::size_t at) const;
  /// Where a statement that begins at a word ends; empty if its literal words are others.
  std::optional<Extent> matched(const std::vector<FormatPart>& parts, std::size_t first);
  /// Fails about a statement, whose words are its value if it is a line.
  [[noreturn]] void fail_at(std::size_t first, std::string_view what) const;
  [[noreturn]] void fail_twice(std::size_t at, std::size_t line) const;

  const FileFormat& format_;
  LocatedFields located_;
  const std::vector<NestedRow> rows_;
  std::vector<Word> words_;
  const Word* axis_ = nullptr;     ///< The word in the place of {fov_axis}.
  const Word* unknown_ = nullptr;  ///< The first unknown keyword.
  GivenSlots given_;               ///< Of the statement that is read.
  std::vector<std::string> warnings_;

 private:
  double number(std::string_view slot, std::size_t first, std::size_t at) const;
  [[noreturn]] void fail_short(const std::vector<FormatPart>& parts, std::size_t first) const;
  /// The words after the first, one space apart.
  std::string rest_of_line(std::size_t first) const;

  std::size_t numbers_ = 0;  ///< How many the statement that is read has.
  std::set<std::string_view> warned_;
};

/// Makes a camera of the slots that a file and its format give.
class FormatCamera : protected FormatStatements {
 protected:
  using FormatStatements::FormatStatements;

  Camera camera();

  std::map<std::string, Given, std::less<>> camera_;

 private:
  const std::array<double, 3>* find(std::string_view slot) const;
  /// The numbers of the first of these slots; the file must have one.
  const std::array<double, 3>& required(std::initializer_list<std::string_view> slots) const;
  /// The keyword of the statement with one of these slots.
  std::string keyword_of(std::initializer_list<std::string_view> slots) const;
  /// The number of a slot that must have a sign.
  double signed_number(std::string_view slot) const;
  /// Sets the window. If it has no area or is mirrored, but is not in the order of another format
  /// with this keyword, says so.
  void set_window(Camera& camera);
  /// Sets the window by its width or by the angle of view.
  void set_angle(Camera& camera) const;
  /// The side that a word in the place of {fov_axis} means.
  AngleSlot::Side side_of(const Word& word) const;
  /// The slot of the angle that the file or the format gives; if none does, the template's.
  std::pair<std::string_view, AngleSlot> angle_of() const;
};

}  // namespace raycheck::scene
