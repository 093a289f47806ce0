// Students' files contain no withheld information in any notation: every number in them is compared
// with every withheld number.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// A number in a text, and the largest difference of a number that is rounded to it.
struct Written {
  std::string text;
  double value = 0;
  double half_a_digit = 0;
};

/// Numbers with fewer digits are counts, points or places.
constexpr int kFewestDigits = 3;
constexpr int kFewestDigitsOfIntegers = 5;

Written written(const std::string& text) {
  const double value = std::strtod(text.c_str(), nullptr);
  if (text.starts_with("0x")) return {text, value, 0};
  const std::string mantissa = text.substr(0, text.find('e'));
  const double power =
      mantissa.size() == text.size() ? 0 : std::strtod(text.c_str() + mantissa.size() + 1, nullptr);
  const std::size_t point = mantissa.find('.');
  const auto places = point == std::string::npos ? 0 : mantissa.size() - point - 1;
  return {text, value, 0.5 * std::pow(10, power - static_cast<double>(places))};
}

int digits_of(const std::string& text) {
  int digits = 0;
  for (const char c : text.substr(0, text.find('e'))) {
    digits += c != '.' && (c != '0' || digits > 0) ? 1 : 0;
  }
  return digits;
}

/// The numbers of a text, without signs, with enough digits to reveal something.
std::vector<Written> numbers_in(const std::string& text) {
  static const std::regex number(
      R"(0x[0-9a-f]+(\.[0-9a-f]*)?(p[-+]?[0-9]+)?|[0-9]+\.?[0-9]*(e[-+]?[0-9]+)?)",
      std::regex::icase);
  std::vector<Written> found;
  for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at) {
    const std::string one = at->str();
    const bool is_integer = one.find_first_not_of("0123456789") == std::string::npos;
    const int fewest = is_integer ? kFewestDigitsOfIntegers : kFewestDigits;
    if (one.starts_with("0x") || digits_of(one) >= fewest) found.push_back(written(one));
  }
  return found;
}

std::string without_percents(const std::string& text) {
  std::string result;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool is_code = text[k] == '%' && k + 2 < text.size() && std::isxdigit(text[k + 1]) != 0 &&
                         std::isxdigit(text[k + 2]) != 0;
    result += is_code ? static_cast<char>(std::stoi(text.substr(k + 1, 2), nullptr, 16)) : text[k];
    k += is_code ? 2 : 0;
  }
  return result;
}

/// The student's files: all of the submission's folder except the record.
std::string given_to_student(const Grading& grading, const std::string& name) {
  std::string all;
  int files = 0;
  for (const auto& entry : fs::directory_iterator(grading.path("out/" + name))) {
    if (entry.path().filename() == "result.json") continue;
    ++files;
    std::string text = entry.path().filename() == "figures.html" ? grading.figures(name).dump()
                                                                 : contents(entry.path().string());
    const std::size_t style = text.find("<style>");
    if (style != std::string::npos) text.erase(style, text.find("</style>") - style);
    all += without_percents(text) + "\n";
  }
  EXPECT_GE(files, 2) << "the page and results.json";
  return all;
}

void add_numbers(const json& list, std::vector<double>& numbers) {
  if (list.is_string()) return;  // "infinity"
  if (list.is_number()) numbers.push_back(std::abs(list.get<double>()));
  if (!list.is_array()) return;
  for (const json& hex : list) {
    numbers.push_back(std::abs(std::strtod(hex.get<std::string>().c_str(), nullptr)));
  }
}

/// A record's withheld numbers, and its harmless numbers: questions and the submission's answers.
struct Numbers {
  std::vector<double> secret, open;
};

/// `parts` of an item's record, and `keys` of their answers.
Numbers numbers_of(const json& record, const std::vector<std::string>& parts,
                   const std::vector<std::string>& keys) {
  Numbers numbers;
  std::vector<double> all;
  for (const json& item : record["items"]) {
    for (const std::string& part : parts) {
      if (item[part].is_null()) continue;
      const json& answer = item[part]["answer"];
      for (const std::string& key : keys) add_numbers(answer[key], all);
      add_numbers(answer["got"], numbers.open);
    }
    if (item["failing"].is_null()) continue;
    for (const Written& one : numbers_in(item["failing"]["scene"].get<std::string>())) {
      numbers.open.push_back(one.value);
    }
  }
  for (const double number : all) {
    const bool is_open =
        std::find(numbers.open.begin(), numbers.open.end(), number) != numbers.open.end();
    // Numbers with few binary digits may occur in any scene.
    if (!is_open && std::isfinite(number) && std::fmod(number * 64, 1) != 0) {
      numbers.secret.push_back(number);
    }
  }
  return numbers;
}

/// The withheld numbers that a number in the text reveals.
std::vector<std::string> revealed_by(const Numbers& numbers, const std::string& text) {
  std::vector<std::string> found;
  const std::vector<Written> all = numbers_in(text);
  for (const double secret : numbers.secret) {
    for (const Written& one : all) {
      if (std::find(numbers.open.begin(), numbers.open.end(), one.value) != numbers.open.end()) {
        continue;
      }
      if (one.value == secret || std::abs(one.value - secret) < one.half_a_digit) {
        found.push_back(one.text + " for " + std::to_string(secret));
        break;
      }
    }
  }
  return found;
}

/// Mistakes of submissions, and items; each submission fails some of these.
const std::vector<std::string> kMistakes = {"u_and_w_flipped", "normalize_discarded", "far_root",
                                            "float_directions", "top_from_right"};
constexpr const char* kLaws[] = {"frame",     "direction",    "unit-direction", "parameter",
                                 "hit-point", "nearest-root", "pixel-point",    "ray-origin"};

/// An item's visibility and detail.
using Shown = std::vector<std::pair<std::string, std::string>>;

struct Revealed {
  std::size_t secrets = 0;
  std::vector<std::string> revealed;
};

Revealed revealed_to_students(const std::string& format, const Shown& shown,
                              const std::vector<std::string>& parts,
                              const std::vector<std::string>& keys) {
  const Grading grading;
  std::string items;
  for (const std::string law : kLaws) {
    for (const auto& [visibility, detail] : shown) {
      const std::string how = "visibility = \"" + visibility + "\"\ndetail = \"" + detail + "\"";
      items += item_of(law + " " + visibility + " " + detail, "points = 1\n" + how,
                       functions(law, "cameras", 4));
    }
  }
  grading.grade(grading.short_rubric("", items), grading.submit_each(kMistakes, "rays.cpp"), "out",
                "--format " + format);
  Revealed all;
  for (const std::string& mistake : kMistakes) {
    const Numbers numbers = numbers_of(grading.result(mistake), parts, keys);
    const auto found = revealed_by(numbers, given_to_student(grading, mistake));
    all.secrets += numbers.secret.size();
    all.revealed.insert(all.revealed.end(), found.begin(), found.end());
  }
  return all;
}

class EachResultsFormat : public testing::TestWithParam<const char*> {};

TEST_P(EachResultsFormat, ContainsNoWithheldNumber) {
  Shown shown = {
      {"visible", "actual-only"},       {"visible", "nothing"}, {"hidden", "full"},
      {"hidden", "actual-only"},        {"hidden", "nothing"},  {"after_published", "nothing"},
      {"after_due_date", "actual-only"}};
  // Gradescope itself hides items until they are due.
  if (GetParam() != std::string("gradescope")) shown.emplace_back("after_due_date", "full");
  const Revealed all = revealed_to_students(GetParam(), shown, {"failing", "first_wrong"},
                                            {"exact", "error", "condition"});
  EXPECT_GT(all.secrets, 60u);
  EXPECT_TRUE(all.revealed.empty()) << all.revealed.size() << " of " << all.secrets
                                    << " are revealed, the first: " << all.revealed.front();
}

TEST_P(EachResultsFormat, ContainsNumbersThatAreNotWithheld) {
  const Revealed all =
      revealed_to_students(GetParam(), {{"visible", "full"}}, {"failing"}, {"exact"});
  EXPECT_GE(all.secrets, 5u);
  EXPECT_EQ(all.revealed.size(), all.secrets);
}

INSTANTIATE_TEST_SUITE_P(Formats, EachResultsFormat, testing::Values("gradescope", "prairielearn"),
                         [](const auto& the_test) { return std::string(the_test.param); });

TEST(Redaction, does_not_name_hidden_items) {
  const Grading grading;
  const std::string frame = functions("frame", "course", 4);
  const std::string items = item_of("covert", "visibility = \"hidden\"\npoints = 1", frame) +
                            item_of("open", "points = 1\nrequires = [\"covert\"]", frame);
  grading.grade(grading.short_rubric("", items),
                {grading.submit_built("mine", "rays.cpp", "u_flipped")}, "out",
                "--format prairielearn");
  EXPECT_EQ(item(grading.result("mine"), "open")["reason"]["item"], "covert");
  const std::string text = given_to_student(grading, "mine");
  EXPECT_FALSE(has(text, "covert"));
  expect_parts(text, {"left out: another item must have all points first"});
}

}  // namespace
}  // namespace raycheck::tests
