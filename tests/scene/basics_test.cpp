// Tests reading and writing of numbers and text, interruption, and the processor's arithmetic.

#include <cfenv>
#include <thread>

#include "scene/arithmetic.h"
#include "scene/interruption.h"
#include "scene/number.h"
#include "scene/text.h"
#include "tests/testing.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace raycheck::scene {
namespace {

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

void expect_reads(std::string_view text, double expected) {
  const std::optional<double> value = parse_number(text);
  ASSERT_TRUE(value) << text;
  EXPECT_EQ(bits(*value), bits(expected)) << text << " read as " << hexfloat(*value);
}

TEST(ParseNumber, ReadsDecimalsAndHexfloatsToTheNearestDouble) {
  const std::string zeros(400, '0');
  const std::pair<std::string, double> numbers[] = {
      {"+2.5e-3", 0.0025},
      {".75", 0.75},
      {"5.", 5},
      {"1E3", 1000},
      {"0", 0.0},
      {"-0.0", -0.0},
      {"9007199254740993", 9007199254740992.0},
      {"5e-324", kSmallest},
      {"3e-324", kSmallest},
      {"-2.2250738585072011e-308", -0x0.fffffffffffffp-1022},
      {"0x1.8p+3", 12},
      {"-0X1.8P3", -12},
      {"+0x.8p1", 1},
      {"0x1.p-1", 0.5},
      {"-0x0p+0", -0.0},
      {"0x0.0000000000001p-1022", kSmallest},
      {"0x1.00000000000008p0", 1},  // ties go to even
      {"0x1.00000000000018p0", 0x1.0000000000002p0},
      {"0x1.000000000000080000000000000001p0", 0x1.0000000000001p0},
      {"1.00000000000000011102230246251565404236316680908203125", 1},
      {"1.00000000000000011102230246251565404236316680908203126", 0x1.0000000000001p0},
      {"1e99999999999999999999", kInfinity},
      {"1e-99999999999999999999", 0.0},
      {"0e99999999999999999999", 0.0},
      {"1" + zeros, kInfinity},
      {"1" + zeros + "e-400", 1},
      {"0." + zeros + "1", 0.0},
      {"0." + zeros + "1e401", 1},
      {"-0x1p99999999999999999999", -kInfinity},
      {"0x1" + zeros + "p-500", kInfinity},
      {"0x0." + zeros + "1p+500", 0.0},
      {"0x1p-99999999999999999999", 0.0},
      {"inf", kInfinity},
      {"-inf", -kInfinity}};
  for (const auto& [text, value] : numbers) expect_reads(text, value);
  ASSERT_TRUE(parse_number("nan"));
  EXPECT_TRUE(std::isnan(*parse_number("nan")));
}

TEST(ParseNumber, RefusesEverythingElse) {
  for (const char* const text :
       {"",     "-",       "+",   ".",     "+-1",   "--1",  "-+1",   "1e",   "1e+",
        "1 ",   " 1",      "1,5", "1.2.3", "0x",    "0xp1", "0x.p1", "0x-1", "0xinf",
        "0x1p", "0x1.8p+", "abc", "1f",    "1_000", "0b1",  "e5"}) {
    EXPECT_FALSE(parse_number(text)) << "'" << text << "'";
  }
  EXPECT_FALSE(parse_number(std::string_view("1\0", 2)));
}

TEST(ParseNumber, AgreesWithStrtodOnRandomDigits) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const bool is_hex = i % 2 == 0;
    std::string text = is_hex ? "0x" : "";
    const std::string_view digits = is_hex ? "0123456789abcdef" : "0123456789";
    const std::size_t count = 1 + random() % 30;
    for (std::size_t k = 0; k < count; ++k) {
      if (k == count / 2) text += '.';
      text += digits[random() % digits.size()];
    }
    const int range = is_hex ? 1200 : 380;
    text += (is_hex ? "p" : "e") +
            std::to_string(static_cast<int>(random() % static_cast<unsigned>(2 * range)) - range);
    expect_reads(text, std::strtod(text.c_str(), nullptr));
  }
}

TEST(Number, EveryDoubleReadsBackFromEachSpelling) {
  std::mt19937_64 random(2);
  std::vector<double> values = {0.0, -0.0, kSmallest, -kSmallest, kLargest, 1e300, 0.1, -12};
  while (values.size() < 20000) {
    const double value = std::bit_cast<double>(random() >> (values.size() % 3 == 0 ? 12 : 0));
    if (std::isfinite(value)) values.push_back(value);
  }
  for (const double value : values) {
    expect_reads(shortest(value), value);
    expect_reads(hexfloat(value), value);
    const std::string both = digits_and_hexfloat(value);
    const std::size_t space = both.find(' ');
    expect_reads(both.substr(0, space), value);
    expect_reads(both.substr(space + 2, both.size() - space - 3), value);
    EXPECT_EQ(bits(std::strtod(hexfloat(value).c_str(), nullptr)), bits(value));
  }
}

TEST(Number, IsSpelledAsDocumented) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(-0.0), "-0");
  EXPECT_EQ(shortest(1e300), "1e+300");
  EXPECT_EQ(hexfloat(12), "0x1.8p+3");
  EXPECT_EQ(hexfloat(-0.0), "-0x0p+0");
  EXPECT_EQ(hexfloat(kSmallest), "0x1p-1074");
  EXPECT_EQ(digits_and_hexfloat(0.1), "0.10000000000000001 (0x1.999999999999ap-4)");
  for (const auto& spell : {shortest, hexfloat, digits_and_hexfloat}) {
    EXPECT_EQ(spell(kInfinity), "inf");
    EXPECT_EQ(spell(-kInfinity), "-inf");
    EXPECT_EQ(spell(std::nan("")), "nan");
    EXPECT_EQ(spell(-std::nan("")), "nan");
  }
}

const std::string kNone = "\uFFFD";

TEST(HostileText, keeps_printable_text) {
  for (const char* text :
       {"", "plain", "M\u00fcller", "\u00a0", "\u4e2d\u6587 \U0001F600", "a\nb\tc"}) {
    EXPECT_EQ(visible(text), text);
  }
  EXPECT_EQ(visible_line("M\u00fcller"), "M\u00fcller");
}

TEST(HostileText, escapes_terminal_controls) {
  EXPECT_EQ(visible("\x1b]0;x\a"), "\\x1b]0;x\\x07");
  EXPECT_EQ(visible("a\rb\x7f"), "a\\x0db\\x7f");
  EXPECT_EQ(visible(std::string("\0", 1)), "\\x00");
  EXPECT_EQ(visible("\u009b31m"), "\\u009b31m");
  EXPECT_EQ(visible("\u202egnp.exe"), "\\u202egnp.exe");
  EXPECT_EQ(visible("\u2066\u2028"), "\\u2066\\u2028");
  EXPECT_EQ(visible_line("a\nb\tc"), "a\\x0ab\\x09c");
}

TEST(HostileText, replaces_each_byte_that_is_not_utf_8) {
  EXPECT_EQ(visible("\xff"), kNone);
  EXPECT_EQ(visible("a\xe9z"), "a" + kNone + "z");
  EXPECT_EQ(visible("\xc3"), kNone) << "ends too early";
  EXPECT_EQ(visible("\xe2\x82"), kNone + kNone) << "ends too early";
  EXPECT_EQ(visible("\xc0\xaf"), kNone + kNone) << "longer than need be";
  EXPECT_EQ(visible("\xe0\x80\xaf"), kNone + kNone + kNone) << "longer than need be";
  EXPECT_EQ(visible("\xed\xa0\x80"), kNone + kNone + kNone) << "half of a pair";
  EXPECT_EQ(visible("\xf4\x90\x80\x80"), kNone + kNone + kNone + kNone) << "beyond the last";
  EXPECT_EQ(visible("\x9b"
                    "31m"),
            kNone + "31m")
      << "a control of C1 in one byte";
}

TEST(Poll, ThrowsIfTheInnermostIsInterrupted) {
  const std::function<bool()> never = [] { return false; };
  const std::function<bool()> always = [] { return true; };
  EXPECT_NO_THROW(poll());
  {
    const Interruptible outer(always);
    EXPECT_THROW(poll(), Interrupted);
    {
      const Interruptible inner(never);
      EXPECT_NO_THROW(poll());
    }
    EXPECT_THROW(poll(), Interrupted);
    std::thread([] { EXPECT_NO_THROW(poll()); }).join();
  }
  EXPECT_NO_THROW(poll());
}

TEST(Arithmetic, FollowsIeee754) { EXPECT_EQ(arithmetic_defect(), ""); }

TEST(Arithmetic, IsCheckedForOtherRounding) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const std::string defect = arithmetic_defect();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(defect, "doubles do not round to nearest") << mode;
  }
}

#if defined(__SSE2__)
TEST(Arithmetic, IsCheckedForFlushToZero) {
  constexpr unsigned kFlushResults = 0x8000, kFlushOperands = 0x0040;
  for (const unsigned flush : {kFlushResults, kFlushOperands}) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | flush);
    const std::string defect = arithmetic_defect();
    _mm_setcsr(before);
    EXPECT_EQ(defect, "subnormal doubles are flushed to zero") << flush;
  }
}
#endif

}  // namespace
}  // namespace raycheck::scene
