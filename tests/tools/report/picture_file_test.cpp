#include "tools/report/picture_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/tools/program.h"
#include "tests/tools/report/picture.h"

namespace raycheck::tests {
namespace {

using tools::Colour;
using tools::PictureFile;

TEST(PictureFile, WritesLinesFromTheTop) {
  for (const char* extension : {".png", ".ppm"}) {
    const std::string path = temporary_file("lines" + std::string(extension), "");
    PictureFile file("--out", path);
    file.start(3, 4);
    std::vector<Colour> pixels;
    for (std::uint8_t k = 0; k < 12; ++k) {
      pixels.push_back({k, static_cast<std::uint8_t>(10 * k), static_cast<std::uint8_t>(255 - k)});
    }
    file.add(std::span(pixels).first(3));
    file.add(std::span(pixels).subspan(3));
    file.place();
    const ReadPicture picture = read_picture(path);
    EXPECT_EQ(picture.width, 3);
    EXPECT_EQ(picture.height, 4);
    ASSERT_EQ(picture.pixels.size(), pixels.size());
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      EXPECT_EQ(picture.pixels[k],
                (std::array<std::uint8_t, 3>{pixels[k].red, pixels[k].green, pixels[k].blue}));
    }
    std::filesystem::remove(path);
  }
}

TEST(PictureFile, TurnsWhatLibpngRefusesIntoAnException) {
  const std::string path = temporary_file("refused.png", "an older picture");
  {
    PictureFile file("--out", path);
    file.start(3, 4);
    try {
      file.place();
      FAIL() << "a picture without lines was written";
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("libpng: No IDATs"), std::string::npos)
          << error.what();
    }
  }
  EXPECT_EQ(contents(path), "an older picture");
  std::filesystem::remove(path);
}

TEST(PictureFile, LeavesNothingWhereItWasNotPlaced) {
  const std::string path = temporary_file("unplaced.ppm", "");
  std::filesystem::remove(path);
  {
    PictureFile file("--out", path);
    file.start(1, 2);
    file.add(std::vector<Colour>(1));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace raycheck::tests
