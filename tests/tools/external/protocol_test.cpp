#include "tools/external/protocol/protocol.h"

#include <png.h>

#include <algorithm>

#include "tests/testing.h"
#include "tools/external/pictures/renderer.h"
#include "tools/external/sandbox/launch.h"
#include "tools/report/picture_file.h"

namespace raycheck::tools {
namespace {

TEST(Introduction, ListsFunctionsAndConventions) {
  const Introduction found = parse_introduction(
      "raycheck 1 mine\r\nfunction intersect\nfunction nearest\nconvention rows top-first\n"
      "convention tangent either\nready\n");
  EXPECT_EQ(found.name, "mine");
  EXPECT_EQ(found.functions, (std::set<std::string>{"intersect", "nearest"}));
  EXPECT_EQ(found.declared.conventions.rows, scene::Rows::kTopFirst);
  EXPECT_EQ(found.declared.conventions.tangent, scene::Tangent::kEither);
  EXPECT_FALSE(found.declared.conventions.samples);
  EXPECT_EQ(found.declared.level, properties::Level::kOrdinary);
  EXPECT_EQ(found.declared.lengths, contract::Lengths());
}

TEST(Introduction, DeclaresLevelLengthsAndPrecision) {
  const auto stating = [](const std::string& lines) {
    return parse_introduction("raycheck 1 mine\nfunction intersect\n" + lines + "ready\n");
  };
  const Introduction found = stating("level demanding\nlengths 1e-30 0x1p100\n");
  EXPECT_EQ(found.declared.level, properties::Level::kDemanding);
  EXPECT_EQ(found.declared.lengths, (contract::Lengths{1e-30, 0x1p100}));
  EXPECT_EQ(found.declared.precision, scene::Precision::kDouble);
  EXPECT_EQ(stating("precision double\n").declared.precision, scene::Precision::kDouble);
  EXPECT_EQ(stating("precision single\n").declared.precision, scene::Precision::kSingle);
}

TEST(Introduction, ThatIsInvalidIsRefusedWithItsLine) {
  const std::string mine = "raycheck 1 mine\n";
  std::vector<std::pair<std::string, std::string>> wrong = {
      {"", "introduce"},
      {"hello\n", "line 1"},
      {"raycheck 2 mine\n", "has the version 2, not 1"},
      {mine + "function fly\n", "line 2"},
      {mine + "convention rows up\n", "not one of bottom-first"},
      {mine + "level easy\n", "not one of ordinary"},
      {mine + "precision half\n", "not one of double"},
      {"raycheck 1 mine too\n", "too many words"}};
  for (const char* lengths : {"2 1", "-1 1", "nan 1", "0 nan"}) {
    wrong.emplace_back(mine + "lengths " + lengths + "\n", "lengths = ");
  }
  for (const auto& [lines, why] : wrong) {
    const std::string said =
        thrown_by<ProtocolError>([&] { parse_introduction(lines + "ready\n"); });
    EXPECT_NE(said.find(why), std::string::npos) << lines << said;
  }
}

TEST(Reply, ReadsDecimalsHexfloatsAndNonFiniteNumbers) {
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

TEST(Reply, ThatIsInvalidIsRefusedWithAReason) {
  for (const auto& [lines, why] :
       {std::pair("0 0 1 2 3\n", "line 2 of its reply has too few words"),
        {"0 0 1 2 3 4 5\n", "too many words"},
        {"0 0 1 2 3 four\n", "not a number"},
        {"2 0 1 2 3 4\n", "index 2, which must be below 2"},
        {"-1 0 1 2 3 4\n", "negative index"},
        {"0 0 1 2 3 4\n0 0 1 2 3 4\n", "two hits"}}) {
    const std::string said = thrown_by<ProtocolError>(
        [&] { Reply("reply a\n" + std::string(lines) + "end a\n", "a").hits(2, 1); });
    EXPECT_NE(said.find(why), std::string::npos) << lines << said;
  }
  for (const auto& [reply, why] : {std::pair("reply b\nend a\n", "'reply b'"),
                                   {"reply a\nerror a I cannot\n", "I cannot"},
                                   {"reply a\nend a\n", "0 lines, not 1"}}) {
    const auto read = [&reply = reply] { Reply(reply, "a").points(1); };
    EXPECT_TRUE(has(thrown_by<ProtocolError>(read), why));
  }
}

TEST(Reply, EndsOnlyWithItsOwnId) {
  for (const char* line : {"end 12", "error 12 no", "end 12\r"})
    EXPECT_TRUE(ends_reply(line, "12"));
  for (const char* line : {"end 123", "end 1", "ends 12"}) EXPECT_FALSE(ends_reply(line, "12"));
}

TEST(SpentTime, DoesNotDependOnEarlierSums) {
  // With most of these, a sum of doubles would grow by less than 3.
  for (double before : {0.0, 0.007, 0.031, 0.111, 0.188, 1e6}) {
    SpentTime spent;
    spent.add(before);
    const SpentTime::Time start = spent.so_far();
    for (int k = 0; k < 3; ++k) spent.add(1);
    EXPECT_EQ(spent.seconds_since(start), 3) << before;
    for (double none : {-1.0, std::numeric_limits<double>::infinity()}) spent.add(none);
    EXPECT_GE(spent.seconds_since(start), 3);
  }
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

/// Highlights and reflections add white.
TEST(SphereColours, WithWhiteAddedAreNotThoseOfOtherSpheres) {
  constexpr std::size_t kPure = 9, kMixed = 8, kShown = kPure + kMixed;
  const auto mixed = [](std::uint8_t channel, std::size_t share) {
    return static_cast<std::uint8_t>(channel + (255 - channel) * share / (kMixed + 1));
  };
  for (const std::size_t count : {5u, 7u, 12u, 13u, 25u, 60u}) {
    std::vector<Colour> picture;
    const SphereColours colours(count);
    for (const Colour& colour : colours.all()) {
      picture.insert(picture.end(), kPure, colour);
      for (std::size_t k = 1; k <= kMixed; ++k) {
        picture.push_back({mixed(colour.red, k), mixed(colour.green, k), mixed(colour.blue, k)});
      }
    }
    scene::Camera camera;
    camera.width = std::ssize(picture);
    camera.height = 1;
    const auto answer =
        image_answer({camera.width, 1, picture}, camera, scene::Rows::kBottomFirst, count);
    std::size_t others = 0;
    for (std::size_t k = 0; k < picture.size(); ++k) {
      ASSERT_TRUE(answer[k].has_value());
      const bool is_own = *answer[k] == k / kShown;
      ASSERT_TRUE(is_own || k % kShown >= kPure) << count << ", " << k;
      others += is_own || *answer[k] == properties::kSomeSphere ? 0 : 1;
    }
    // The number of wrong spheres among the pixels with white added.
    EXPECT_LE(others, count <= 12 ? 0 : count * kMixed / 10) << count;
  }
}

TEST(PictureReader, ReadsPpmsWithCommentsAndOtherMaxima) {
  const auto text = parse_picture("P3 # mine\n2 1\n# more\n15\n0 5 15  15 0 3\n", 100);
  EXPECT_EQ(text.width, 2);
  EXPECT_EQ(text.pixels, (std::vector<Colour>{{0, 85, 255}, {255, 0, 51}}));
  const auto binary = parse_picture("P6\n1 1\n255\nabc", 100);
  EXPECT_EQ(binary.pixels, (std::vector<Colour>{{'a', 'b', 'c'}}));
  EXPECT_EQ(parse_picture("P6\r\n1 1\r\n255\r\nabc", 100).pixels, binary.pixels);
  // The first pixel's byte may be that of a line end.
  const auto line_end = parse_picture("P6\n1 1\n255\n\nbc\n", 100);
  EXPECT_EQ(line_end.pixels, (std::vector<Colour>{{'\n', 'b', 'c'}}));
}

TEST(PictureReader, ReadsPfmsOfBothByteOrdersFromTheBottom) {
  // Below 1 and -2, above 0.5 and NaN.
  const std::string big("\x3f\x80\0\0\xc0\0\0\0\x3f\0\0\0\x7f\xc0\0\0", 16);
  std::string little = big;
  for (std::size_t k = 0; k < little.size(); k += 4) std::reverse(&little[k], &little[k] + 4);
  const auto grey = parse_picture("Pf\n2 2\n1.0\n" + big, 100);
  EXPECT_EQ(grey.pixels, (std::vector<Colour>{{128, 128, 128}, {}, {255, 255, 255}, {}}));
  EXPECT_EQ(parse_picture("Pf\n2 2\n-1\n" + little, 100).pixels, grey.pixels);
  EXPECT_EQ(parse_picture("Pf\r\n2 2\r\n+1.0\r\n" + big, 100).pixels, grey.pixels);
  const auto colour = parse_picture("PF 1 1 -3\n" + little, 100);
  EXPECT_EQ(colour.pixels, (std::vector<Colour>{{255, 0, 128}}));
}

TEST(PictureReader, TellsTransparentPixelsFromBlackOnes) {
  const auto shown = [](std::vector<std::uint8_t> pixels) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = 3;
    image.height = 1;
    image.format = PNG_FORMAT_RGBA;
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t size = bytes.size();
    png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr);
    return parse_picture(std::string_view(bytes).substr(0, size), 100).pixels;
  };
  EXPECT_EQ(shown({9, 9, 9, 0, 0, 0, 0, 255, 200, 0, 100, 255}),
            (std::vector<Colour>{{}, {1, 1, 1}, {200, 0, 100}}));
  EXPECT_EQ(shown({9, 9, 9, 255, 0, 0, 0, 255, 200, 0, 100, 51}),
            (std::vector<Colour>{{9, 9, 9}, {}, {40, 0, 20}}));
}

TEST(PictureReader, ReadsOnlyTheHeaderIfTheSizeIsWrong) {
  for (const char* bytes : {"P3\n9 7\n", "P6\n9 7\n255\nabc", "PF\n9 7\n-1\nabc"}) {
    const auto other = parse_picture(bytes, 100, PictureSize{7, 9});
    EXPECT_TRUE(other.has_size({9, 7})) << bytes;
    EXPECT_TRUE(other.pixels.empty()) << bytes;
    EXPECT_THROW(parse_picture(bytes, 100, PictureSize{9, 7}), PictureError) << bytes;
  }
}

TEST(PictureReader, RefusesInvalidPictures) {
  for (const char* bytes :
       {"", "P5\n1 1\n255\na", "P3\n2 2\n255\n1 2 3\n", "P6\n2 2\n255\nabc", "P3\n0 1\n255\n",
        "P3\n1000 1000\n255\n", "P3\n1 1\n0\n1 1 1", "P3\n1 1\n9\n1 1 10", "\x89PNG nonsense", "P3",
        "PF\n1 1\n-1\n0123", "Pf", "Pf\n1 1\nx\n0123", "Pf\n1000 1000\n1\n0123", "BM nonsense"}) {
    EXPECT_THROW(parse_picture(bytes, 100), PictureError) << bytes;
  }
}

}  // namespace
}  // namespace raycheck::tools
