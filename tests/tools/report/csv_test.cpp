#include "tools/report/csv.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tools/report/json.h"
#include "tools/report/table.h"

namespace raycheck::tools {
namespace {

TEST(HostileCsv, defuses_what_spreadsheets_take_for_formulas) {
  EXPECT_EQ(csv_cell("=1+1"), "\"'=1+1\"");
  EXPECT_EQ(csv_cell("+cmd|' /C calc'!A0"), "\"'+cmd|' /C calc'!A0\"");
  EXPECT_EQ(csv_cell("-2+3"), "\"'-2+3\"");
  EXPECT_EQ(csv_cell("@SUM(A1)"), "\"'@SUM(A1)\"");
  EXPECT_EQ(csv_cell("\t=1"), "\"'\t=1\"");
  EXPECT_EQ(csv_cell("\r=1"), "\"'\\x0d=1\"");
  EXPECT_EQ(csv_cell("\n=1"), "\"'\n=1\"");
  EXPECT_EQ(csv_cell("\uFF1D1"), "\"'\uFF1D1\"");
}

TEST(HostileCsv, leaves_numbers_and_plain_text) {
  for (const char* cell :
       {"", "-", "-1.5", "+2", "1e-300", "-0x1p3", "-inf", "ada", "a b", "<1e-9"}) {
    EXPECT_EQ(csv_cell(cell), cell);
  }
}

TEST(HostileCsv, quotes_what_would_end_a_cell) {
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("a;b"), "\"a;b\"");
  EXPECT_EQ(csv_cell("a\"b"), "\"a\"\"b\"");
  EXPECT_EQ(csv_cell(" a"), "\" a\"");
  EXPECT_EQ(csv_cell("\x1b\xff"), "\\x1b\uFFFD");
}

TEST(HostileCsv, is_what_every_table_has) {
  Table table({{"=heading", Table::Align::kLeft}, {"x", Table::Align::kRight}});
  table.add({"@name", "-1"});
  EXPECT_EQ(table.csv(), "\"'=heading\",x\n\"'@name\",-1\n");
}

TEST(HostileJson, is_written_of_any_bytes) {
  const std::string bytes = "a\xff\x1b\x7f\u009b\u202e\\x7f\"z";
  const std::string text = json_text({{"key", bytes}});
  EXPECT_EQ(text, "{\n  \"key\": \"a\uFFFD\\u001b\\u007f\\u009b\\u202e\\\\x7f\\\"z\"\n}\n");
  EXPECT_EQ(Json::parse(text)["key"], "a\uFFFD\x1b\x7f\u009b\u202e\\x7f\"z");
  EXPECT_EQ(json_line(Json::array({1, "\xff"})), "[1,\"\uFFFD\"]\n");
}

}  // namespace
}  // namespace raycheck::tools
