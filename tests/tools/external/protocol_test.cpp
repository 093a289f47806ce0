#include "tools/external/protocol/protocol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tools/external/pictures/renderer.h"
#include "tools/report/picture_reader.h"

namespace raycheck::tools {
namespace {

template <class Body>
std::string error_of(const Body& body) {
  try {
    body();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Introduction, SaysWhatIsOfferedAndFixed) {
  const Introduction found = parse_introduction(
      "raycheck 1 mine\r\nfunction intersect\nfunction nearest\nconvention rows top-first\n"
      "convention tangent either\nready\n");
  EXPECT_EQ(found.name, "mine");
  EXPECT_EQ(found.functions, (std::set<std::string>{"intersect", "nearest"}));
  EXPECT_EQ(found.declared.rows, scene::Rows::kTopFirst);
  EXPECT_EQ(found.declared.tangent, scene::Tangent::kEither);
  EXPECT_FALSE(found.declared.samples);
  EXPECT_FALSE(found.level);
  EXPECT_EQ(found.smallest_length, 0);
}

TEST(Introduction, StatesALevelAndADomainOfLengths) {
  const Introduction found = parse_introduction(
      "raycheck 1 mine\nfunction intersect\nlevel demanding\nlengths 1e-30 0x1p100\nready\n");
  EXPECT_EQ(found.level, properties::Level::kDemanding);
  EXPECT_EQ(found.smallest_length, 1e-30);
  EXPECT_EQ(found.largest_length, 0x1p100);
}

TEST(Introduction, StatesAPrecision) {
  const auto precision = [](const std::string& line) {
    return parse_introduction("raycheck 1 mine\nfunction frame\n" + line + "ready\n").precision;
  };
  EXPECT_EQ(precision(""), scene::Precision::kDouble);
  EXPECT_EQ(precision("precision double\n"), scene::Precision::kDouble);
  EXPECT_EQ(precision("precision single\n"), scene::Precision::kSingle);
  EXPECT_NE(error_of([&] { precision("precision half\n"); }).find("no such precision"),
            std::string::npos);
}

TEST(Introduction, ThatIsNoneNamesItsLine) {
  const auto wrong = [](const std::string& text) {
    return error_of([&] { parse_introduction(text); });
  };
  EXPECT_NE(wrong("ready\n").find("introduce"), std::string::npos);
  EXPECT_NE(wrong("hello\nready\n").find("line 1"), std::string::npos);
  EXPECT_NE(wrong("raycheck 2 mine\nready\n").find("another version"), std::string::npos);
  EXPECT_NE(wrong("raycheck 1 mine\nfunction fly\nready\n").find("line 2"), std::string::npos);
  EXPECT_NE(wrong("raycheck 1 mine\nconvention rows up\nready\n").find("no such convention"),
            std::string::npos);
  EXPECT_NE(wrong("raycheck 1 mine\nlevel easy\nready\n").find("no such level"), std::string::npos);
  for (const char* lengths : {"2 1", "-1 1", "nan 1", "0 nan"}) {
    EXPECT_NE(wrong("raycheck 1 mine\nlengths " + std::string(lengths) + "\nready\n")
                  .find("no range of lengths"),
              std::string::npos)
        << lengths;
  }
  EXPECT_NE(wrong("raycheck 1 mine too\nready\n").find("too many words"), std::string::npos);
}

TEST(Reply, ReadsDecimalsHexfloatsAndWhatIsNotFinite) {
  const auto hits =
      Reply("reply a\n1 0 0x1.8p+1 1e-3 -0 nan\n0 0 2 inf -inf 5\nend a\n", "a").hits(2, 1);
  ASSERT_EQ(hits.at(0).size(), 2u);
  EXPECT_EQ(hits[0][0].ray, 0u);  // in the order of the rays
  EXPECT_EQ(hits[0][1].hit.parameter, 3);
  EXPECT_EQ(hits[0][1].hit.point.x, 1e-3);
  EXPECT_TRUE(std::isnan(hits[0][1].hit.point.z));
  EXPECT_EQ(hits[0][0].hit.point.y, -std::numeric_limits<double>::infinity());
  const auto nearest = Reply("reply a\n1\nnone\nend a\n", "a").nearest(2, 2);
  EXPECT_EQ(nearest.at(0), 1u);
  EXPECT_FALSE(nearest.at(1));
}

TEST(Reply, ThatIsNoneSaysWhy) {
  const auto wrong = [](const std::string& lines) {
    return error_of([&] { Reply("reply a\n" + lines + "end a\n", "a").hits(2, 1); });
  };
  EXPECT_EQ(wrong("0 0 1 2 3 4\n"), "");
  EXPECT_NE(wrong("0 0 1 2 3\n").find("line 2 of its reply has too few words"), std::string::npos);
  EXPECT_NE(wrong("0 0 1 2 3 4 5\n").find("too many words"), std::string::npos);
  EXPECT_NE(wrong("0 0 1 2 3 four\n").find("no number"), std::string::npos);
  EXPECT_NE(wrong("2 0 1 2 3 4\n").find("index 2 of 2"), std::string::npos);
  EXPECT_NE(wrong("-1 0 1 2 3 4\n").find("no index"), std::string::npos);
  EXPECT_NE(wrong("0 0 1 2 3 4\n0 0 1 2 3 4\n").find("two hits"), std::string::npos);
  EXPECT_NE(error_of([] { Reply("reply b\nend a\n", "a"); }).find("'reply b'"), std::string::npos);
  EXPECT_NE(error_of([] { Reply("reply a\nerror a I cannot\n", "a"); }).find("I cannot"),
            std::string::npos);
  EXPECT_NE(error_of([] { Reply("reply a\nend a\n", "a").points(1); }).find("0 lines, not 1"),
            std::string::npos);
}

TEST(Reply, EndsWithItsOwnIdAlone) {
  EXPECT_TRUE(ends_reply("end 12", "12"));
  EXPECT_TRUE(ends_reply("error 12 no", "12"));
  EXPECT_TRUE(ends_reply("end 12\r", "12"));
  EXPECT_FALSE(ends_reply("end 123", "12"));
  EXPECT_FALSE(ends_reply("end 1", "12"));
  EXPECT_FALSE(ends_reply("ends 12", "12"));
}

TEST(SphereColours, AreAllDifferentAndNoneIsBlack) {
  for (const std::size_t count : {1u, 7u, 8u, 100u, 5000u, 40000u}) {
    const auto colours = SphereColours(count).all();
    scene::Camera camera;
    camera.width = static_cast<std::int64_t>(count);
    camera.height = 1;
    const auto answer =
        image_answer({camera.width, 1, colours}, camera, scene::Rows::kBottomFirst, count);
    for (std::size_t k = 0; k < count; ++k) ASSERT_EQ(answer[k], k) << count;
  }
}

TEST(PictureReader, ReadsPpmsWithCommentsAndOtherMaxima) {
  const auto text = parse_picture("P3 # mine\n2 1\n# more\n15\n0 5 15  15 0 3\n", 100);
  EXPECT_EQ(text.width, 2);
  EXPECT_EQ(text.pixels, (std::vector<Colour>{{0, 85, 255}, {255, 0, 51}}));
  const auto binary = parse_picture("P6\n1 1\n255\nabc", 100);
  EXPECT_EQ(binary.pixels, (std::vector<Colour>{{'a', 'b', 'c'}}));
  EXPECT_EQ(parse_picture("P6\r\n1 1\r\n255\r\nabc", 100).pixels, binary.pixels);
}

TEST(PictureReader, ReadsOfAnotherSizeThanIsWantedNoMoreThanTheHeader) {
  for (const char* bytes : {"P3\n9 7\n", "P6\n9 7\n255\nabc"}) {
    const auto other = parse_picture(bytes, 100, PictureSize{7, 9});
    EXPECT_TRUE(other.has_size({9, 7})) << bytes;
    EXPECT_TRUE(other.pixels.empty()) << bytes;
    EXPECT_THROW(parse_picture(bytes, 100, PictureSize{9, 7}), PictureError) << bytes;
  }
}

TEST(PictureReader, RefusesWhatIsNoPicture) {
  for (const char* bytes : {"", "P5\n1 1\n255\na", "P3\n2 2\n255\n1 2 3\n", "P6\n2 2\n255\nabc",
                            "P3\n0 1\n255\n", "P3\n1000 1000\n255\n", "P3\n1 1\n0\n1 1 1",
                            "P3\n1 1\n9\n1 1 10", "\x89PNG nonsense", "P3"}) {
    EXPECT_THROW(parse_picture(bytes, 100), PictureError) << bytes;
  }
}

}  // namespace
}  // namespace raycheck::tools
