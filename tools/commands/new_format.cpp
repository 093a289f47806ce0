#include "tools/commands/new_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "scene/files/format.h"
#include "scene/number.h"
#include "scene/text.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

/// What keywords usually mean, besides those of the known formats: lines of a template.
constexpr std::string_view kUsual =
    "camera_position {eye}\nposition {eye}\nlocation {eye}\norigin {eye}\ncameye {eye}\n"
    "lookat {look_at}\nlook_at {look_at}\ntarget {look_at}\ncamlookat {look_at}\n"
    "direction {view}\ndir {view}\nforward {view}\nvup {up}\ncamup {up}\nfov {fovy}\n"
    "film {width} {height}\nwidth {width}\nheight {height}\nimage {width} {height}\n"
    "ball {centre} {radius}\n";

/// A line of an example: its keyword, and the words after it.
struct Line {
  std::string keyword;
  std::vector<std::string> words;
  std::size_t numbers = 0;  ///< How many of its words at the beginning are numbers.
  bool has_commas = false;
};

/// What begins comments in a text; empty if no line has one of the usual marks.
std::string comments_of(std::string_view text) {
  for (const char* const mark : {"#", "//", ";", "%"}) {
    if (text.starts_with(mark) || text.find(std::string("\n") + mark) != text.npos) return mark;
  }
  return text.find(" #") != text.npos ? "#" : "";
}

std::vector<Line> lines_of_example(std::string_view text, const std::string& comments) {
  std::vector<Line> lines;
  std::istringstream stream{std::string(scene::without_mark(text))};
  for (std::string line; std::getline(stream, line);) {
    if (!comments.empty()) line.resize(std::min(line.find(comments), line.size()));
    Line one;
    std::vector<std::string> words;
    one.has_commas = line.find(',') != std::string::npos;
    boost::split(words, line, boost::is_any_of(" \t\r,"), boost::token_compress_on);
    std::erase(words, "");
    if (words.empty() || scene::parse_number(words.front())) continue;
    one.keyword = words.front();
    one.words.assign(words.begin() + 1, words.end());
    while (one.numbers < one.words.size() && scene::parse_number(one.words[one.numbers])) {
      ++one.numbers;
    }
    lines.push_back(std::move(one));
  }
  return lines;
}

/// The slots of a statement that a scene needs, "{centre} {radius}", and how many numbers they
/// have.
struct Meaning {
  const scene::FormatStatement* statement;
  std::string slots = {};
  std::size_t numbers = 0;
};

/// The meaning of a statement; empty if a word comes before a number that is needed.
std::optional<Meaning> meaning_of(const scene::FormatStatement& statement) {
  Meaning meaning{&statement};
  bool has_word = false;
  for (std::size_t k = 1; k < statement.parts.size(); ++k) {
    const scene::FormatPart& part = statement.parts[k];
    const bool is_needed = part.numbers > 0 && !part.slot.starts_with("colour");
    if (is_needed && has_word) return {};
    has_word = has_word || !is_needed;
    if (!is_needed) continue;
    if (!meaning.slots.empty()) meaning.slots += ' ';
    meaning.slots += '{' + part.slot + (part.written.empty() ? "}" : ":" + part.written + "}");
    meaning.numbers += part.numbers;
  }
  return meaning.numbers == 0 ? std::nullopt : std::optional(meaning);
}

/// The meanings of keywords, in small letters: of the known formats, then the usual ones.
std::multimap<std::string, Meaning> meanings() {
  std::multimap<std::string, Meaning> all;
  const auto add = [&](const scene::FileFormat& format) {
    for (const scene::FormatStatement& statement : format.statements) {
      const auto meaning = meaning_of(statement);
      if (meaning) all.emplace(boost::to_lower_copy(std::string(statement.keyword())), *meaning);
    }
  };
  for (const auto& [name, format] : scene::formats()) {
    if (format.by_lines && !format.is_nested()) add(format);
  }
  static const scene::FileFormat kUsualFormat = scene::read_format(
      fmt::format("title = \"\"\ntemplate = '''\n{}'''\n", kUsual), "usual.toml");
  add(kUsualFormat);
  return all;
}

class Draft {
 public:
  explicit Draft(const std::vector<Line>& lines) : lines_(lines) {
    for (const Line& line : lines) {
      if (seen_.insert(line.keyword).second) add(line);
    }
  }

  /// The draft's lines, from `template` on; comments about what is left to do come first.
  std::pair<std::string, std::string> texts() const {
    std::string todo = todo_;
    for (const auto& [slots, what] : kNeeded) {
      const bool is_given = std::ranges::any_of(slots, [&](std::string_view slot) {
        return !slot.empty() && template_.find("{" + std::string(slot)) != std::string::npos;
      });
      if (!is_given) {
        todo += fmt::format(
            "# No line gives {}: name its numbers {{{}}}, or give them in [fixed] or [default].\n",
            what, slots.front());
      }
    }
    std::string text = "template = '''\n" + template_ + "'''\n";
    if (!ignored_.empty()) text += "[ignored]\n" + ignored_;
    return {todo, text};
  }

 private:
  void add(const Line& line) {
    static const auto kMeanings = meanings();
    const auto [first, last] = kMeanings.equal_range(boost::to_lower_copy(line.keyword));
    for (auto known = first; known != last; ++known) {
      const Meaning& meaning = known->second;
      const bool is_sphere = meaning.slots.find("{centre}") != std::string::npos;
      if (is_sphere ? line.numbers < meaning.numbers : line.numbers != meaning.numbers) continue;
      if (has_wrong_sign(*meaning.statement, scene::joined(line.words, " "))) continue;
      template_ +=
          line.keyword + " " + meaning.slots + (is_sphere ? rest(line, meaning) : "") + "\n";
      return;
    }
    const std::string known_name = name_of_ignored(line.keyword);
    ignored_ += fmt::format("{} = {}\n", toml_text(line.keyword),
                            toml_text(known_name.empty() ? line.keyword : known_name));
    if (!known_name.empty()) return;
    todo_ += fmt::format(
        "# {}: its meaning is not known. If a picture depends on it, move it from "
        "[ignored] to the template: {}\n",
        line.keyword, scene::joined(line.words, " "));
  }

  /// What a known format calls an ignored keyword; empty if none ignores it.
  static std::string name_of_ignored(const std::string& keyword) {
    for (const auto& [name, format] : scene::formats()) {
      const auto known = format.ignored.find(keyword);
      if (known != format.ignored.end()) return known->second;
    }
    return "";
  }

  /// The colour of a sphere, and the numbers after it, as the example has them.
  static std::string rest(const Line& line, const Meaning& meaning) {
    constexpr std::size_t kColour = 3;
    const std::vector<std::string> words(
        line.words.begin() + static_cast<std::ptrdiff_t>(meaning.numbers), line.words.end());
    if (words.empty()) return "";
    if (line.numbers < meaning.numbers + kColour) return " {*:" + scene::joined(words, " ") + "}";
    const std::vector<std::string> after(words.begin() + kColour, words.end());
    const bool is_255 = std::any_of(words.begin(), words.begin() + kColour, [](auto& word) {
      return scene::parse_number(word).value_or(0) > 1;
    });
    return std::string(is_255 ? " {colour255}" : " {colour}") +
           (after.empty() ? "" : " {*:" + scene::joined(after, " ") + "}");
  }

  /// What a camera needs, and the slots that give it.
  struct Needed {
    std::array<std::string_view, 4> slots;
    std::string_view what;
  };
  static constexpr Needed kNeeded[] = {
      {{"eye"}, "the eye"},
      {{"look_at", "view"}, "the view direction"},
      {{"up"}, "the up vector"},
      {{"fovy", "fovx", "left", "window_width"}, "the angle of view or the window"},
      {{"width", "size"}, "the picture's size"},
      {{"centre"}, "spheres"}};

  const std::vector<Line>& lines_;
  std::set<std::string> seen_;
  std::string template_, ignored_, todo_;
};

}  // namespace

std::string drafted_format(std::string_view title, std::string_view source, std::string_view text) {
  const std::string comments = comments_of(text);
  const std::vector<Line> lines = lines_of_example(text, comments);
  std::string plain(text);
  std::erase(plain, '\r');
  if (lines.empty() || scene::visible(plain) != plain) {
    throw scene::SceneFileError(
        fmt::format("{}: has no statements in UTF-8 from which a format can be drafted", source));
  }
  const auto* const like = scene::format_of(source, text);
  if (like != nullptr && like->is_nested()) {
    throw scene::SceneFileError(fmt::format(
        "{}: is nested, and formats are drafted only from files whose statements are lines; "
        "`raycheck list` shows whether it may be of a known format, and scene/formats/{}.toml how "
        "to "
        "write another",
        source, like->name));
  }
  const auto [todo, rest] = Draft(lines).texts();
  std::string draft = fmt::format(
      "# Drafted from {}. The slots: docs/scenes.md, Other formats.\n"
      "# Meanings are guessed: {{look_at}} or {{view}}, {{radius}} or "
      "{{diameter}}, {{fovy}} or {{fovx}}, degrees or radians.\n{}",
      scene::visible_line(source), todo);
  draft += fmt::format("title = {}\n", toml_text(std::string(title)));
  if (!comments.empty()) draft += fmt::format("comments = {}\n", toml_text(comments));
  if (std::ranges::any_of(lines, &Line::has_commas)) draft += "separators = \",\"\njoint = \",\"\n";
  return draft + rest +
         "[conventions]\nrows = \"top-first\"  # or bottom-first\nsamples = \"centres\"  # or "
         "edges, "
         "corners\norigin = \"focal\"  # or pixel\n";
}

}  // namespace raycheck::tools
