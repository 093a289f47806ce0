#include "scene/text.h"

#include <gtest/gtest.h>

#include <string>

namespace raycheck::scene {
namespace {

const std::string kNone = "\uFFFD";

TEST(HostileText, keeps_what_only_says_something) {
  for (const char* text :
       {"", "plain", "M\u00fcller", "\u00a0", "\u4e2d\u6587 \U0001F600", "a\nb\tc"}) {
    EXPECT_EQ(visible(text), text);
  }
  EXPECT_EQ(visible_line("M\u00fcller"), "M\u00fcller");
}

TEST(HostileText, spells_what_acts_on_a_terminal) {
  EXPECT_EQ(visible("\x1b]0;x\a"), "\\x1b]0;x\\x07");
  EXPECT_EQ(visible("a\rb\x7f"), "a\\x0db\\x7f");
  EXPECT_EQ(visible(std::string("\0", 1)), "\\x00");
  EXPECT_EQ(visible("\u009b31m"), "\\u009b31m");
  EXPECT_EQ(visible("\u202egnp.exe"), "\\u202egnp.exe");
  EXPECT_EQ(visible("\u2066\u2028"), "\\u2066\\u2028");
  EXPECT_EQ(visible_line("a\nb\tc"), "a\\x0ab\\x09c");
}

TEST(HostileText, has_a_mark_for_each_byte_that_is_no_utf_8) {
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

}  // namespace
}  // namespace raycheck::scene
