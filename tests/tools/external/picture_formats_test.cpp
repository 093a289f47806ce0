// The formats of a renderer's pictures: tests/candidates/written.py writes each of them.

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

const std::string kJpeg = "jpg -quality 75 -sampling-factor 2x2";

/// A renderer that ignores the requested name and writes out.FORMAT; `format` may have options of
/// ImageMagick.
std::string writing(const std::string& format, const std::string& mistake) {
  return "renderer:python3 tests/candidates/rt.py " + mistake + " {scene} out." + format;
}

std::string reasons_left_out(const json& report) { return report["left_out"].dump(); }

TEST(PictureFormats, are_read_pixel_by_pixel) {
  const json ppm = judged(kProbeScene, writing("ppm", "centres"));
  EXPECT_GT(ppm["discrepancies"], 0);
  for (const char* format : {"pfm", "bmp", "tga", "hdr", "hdr bottom-first", "exr"}) {
    if (format != std::string("pfm") && !has_imagemagick()) continue;
    const json right = judged(kProbeScene, writing(format, "right"));
    EXPECT_EQ(right["discrepancies"], 0) << format;
    EXPECT_EQ(right["quantities"][0]["cases"], 1040) << format;
    EXPECT_EQ(judged(kProbeScene, writing(format, "centres"))["worst"], ppm["worst"]) << format;
    EXPECT_GT(judged(kProbeScene, writing(format, "mirrored"))["discrepancies"], 0) << format;
  }
}

TEST(PictureFormats, that_need_a_missing_program_are_not_judged) {
  if (has_imagemagick()) GTEST_SKIP() << "ImageMagick is installed here";
  for (const char* format : {"bmp", "tga", "hdr", "exr"}) {
    const Outcome outcome = check(kProbeScene, writing(format, "centres"));
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    const json report = json::parse(outcome.out)["candidates"][0];
    EXPECT_EQ(report["discrepancies"], 0);
    expect_parts(reasons_left_out(report),
                 {"which raycheck reads by ImageMagick: install the Debian package"});
  }
}

TEST(PictureFormats, JPEG_is_judged_where_its_colours_are_clear) {
  if (!has_imagemagick()) GTEST_SKIP() << "needs the packages imagemagick, libmagickcore-*-extra";
  const json right = judged(kProbeScene, writing(kJpeg, "right"));
  EXPECT_EQ(right["discrepancies"], 0);
  EXPECT_GT(right["quantities"][0]["cases"], 700);
  EXPECT_LT(right["quantities"][0]["cases"], 1040);
  expect_parts(reasons_left_out(right),
               {"pixels whose colour is unclear, because a JPEG does not keep colours"});
  const json off = judged(kProbeScene, writing(kJpeg, "centres"));
  EXPECT_GT(off["discrepancies"], 0);
  expect_parts(off["explanations"].dump(), {"pixels are sampled at their centres"});
  for (const char* quality : {"50", "75", "90"}) {
    const std::string jpeg = "jpg -sampling-factor 2x2 -quality " + std::string(quality);
    const json campaign = printed_json(
        "properties --filter image --source crowds --source course "
        "--cases 10 --candidate '" +
        writing(jpeg, "right") + "'");
    EXPECT_EQ(campaign["failures"], 0) << quality;
    EXPECT_EQ(campaign["campaigns"][1]["quantities"][0]["wrong_by_standing"]["defect"], 0);
    EXPECT_GT(campaign["campaigns"][1]["comparisons"], 50);
  }
}

TEST(PictureFormats, JPEG_may_lose_a_sphere_of_one_pixel) {
  if (!has_imagemagick()) GTEST_SKIP() << "needs the packages imagemagick, libmagickcore-*-extra";
  const std::string scene = temporary_file("one-pixel.toml", R"([camera]
eye = [0, 0, 40]
look_at = [0, 0, 0]
up = [0, 1, 0]
near = -1
left = -1
right = 1
bottom = -1
top = 1
width = 17
height = 17
[[sphere]]
centre = [0, 0, 30]
radius = 0.8
)");
  const json right = judged(scene, writing("jpg -quality 50 -sampling-factor 2x2", "right"));
  EXPECT_EQ(right["discrepancies"], 0);
  EXPECT_LT(right["quantities"][0]["cases"], 17 * 17);
  EXPECT_GT(right["quantities"][0]["cases"], 100);
}

/// A folder with tests/candidates/written.py that every user can enter, unlike, maybe, the sources.
const std::string& folder_of_writer() {
  static const std::string kFolder = [] {
    const std::string folder = temporary_folder("writer");
    fs::copy_file(RAYCHECK_SOURCE_DIR "/tests/candidates/written.py", folder + "/written.py");
    return folder;
  }();
  return kFolder;
}

/// A renderer that writes a picture of one colour, then changes its bytes `b`.
std::string damaged(const std::string& format, const std::string& change) {
  return python_renderer("sys.path.insert(0, '" + folder_of_writer() +
                         "')\nimport random, struct, written\n"
                         "written.write([[(255, 0, 0)] * 40] * 26, 'out." +
                         format +
                         "')\n"
                         "b = bytearray(open('out." +
                         format + "', 'rb').read())\n" + change + "\nopen('out." + format +
                         "', 'wb').write(b)");
}

TEST(PictureFormats, are_bad_replies_if_they_are_damaged_or_huge) {
  const std::string noise = "b[4:] = random.Random(1).randbytes(3000)";
  const std::vector<std::pair<std::string, std::string>> huge = {
      {"pfm", "b = b.replace(b'40 26', b'400000 260000')"},
      {"bmp", "b[18:26] = struct.pack('<ii', 60000, 60000)"},
      {"tga", "b[12:16] = struct.pack('<HH', 65535, 65535)"},
      {"hdr", "b = b.replace(b'-Y 26 +X 40', b'-Y 260000 +X 400000')"},
      {"jpg", "k = b.index(b'\\xff\\xc0'); b[k+5:k+9] = struct.pack('>HH', 65500, 65500)"}};
  for (const auto& [format, size] : huge) {
    if (format != "pfm" && !has_imagemagick()) continue;
    for (const std::string& change : {std::string("b = b[:len(b) // 2]"), noise, size}) {
      const json report =
          judged(kProbeScene, damaged(format, change), "--read " + folder_of_writer());
      EXPECT_GT(report["discrepancies"], 0) << format << change;
      expect_parts(report["worst"].dump(), {"image: its "});
    }
  }
  const json other = judged(kProbeScene, damaged("tga", "b = random.Random(2).randbytes(3000)"),
                            "--read " + folder_of_writer());
  expect_parts(other["worst"].dump(), {"its picture is not a PPM (P3, P6), PNG, PFM, BMP, TGA"});
}

}  // namespace
}  // namespace raycheck::tests
