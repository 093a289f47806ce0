#include "tests/fuzz/targets.h"

#include <stdlib.h>

#include "properties/search/campaign.h"
#include "properties/search/worst_case.h"
#include "scene/files/format.h"
#include "scene/files/scene_file.h"
#include "scene/text.h"
#include "scene/validate.h"
#include "tests/standard.h"
#include "tools/external/protocol/protocol.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/report/picture_file.h"
#include "tools/shards/run_units.h"

namespace raycheck::tests {
namespace {

constexpr std::string_view kId = "7";
constexpr std::size_t kCount = 3;

template <class Read>
void try_to(const Read& read) {
  try {
    read();
  } catch (const tools::ProtocolError&) {
  }
}

/// A separate folder, in which no other file lies beside the rubric.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / "raycheck-fuzz-XXXXXX") {
    if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("cannot create a folder");
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string file() const { return path_ + "/rubric.toml"; }

 private:
  std::string path_;
};

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

void require_read_back(const scene::Scene& read) {
  require(scene::defects(read).empty(), "the reader returned an invalid scene");
  require(scene::read_toml(scene::write_toml(read), "again.toml").scene == read,
          "a scene changes when it is written and read again");
}

}  // namespace

void fuzz_reply(std::string_view bytes) {
  try_to([&] { tools::parse_introduction(bytes); });
  std::size_t end = 0;
  while (end < bytes.size()) {
    const std::size_t next = bytes.find('\n', end);
    const std::string_view line = bytes.substr(end, next - end);
    end = next == std::string_view::npos ? bytes.size() : next + 1;
    if (tools::ends_reply(line, kId)) break;
  }
  try_to([&] {
    const tools::Reply reply(bytes.substr(0, end), kId);
    try_to([&] { reply.frame(); });
    try_to([&] { reply.points(kCount); });
    try_to([&] { reply.rays(kCount); });
    try_to([&] { reply.hits(kCount, kCount); });
    try_to([&] { reply.nearest(kCount, kCount); });
  });
}

void fuzz_picture(std::string_view bytes) {
  constexpr std::int64_t kMostPixels = 1 << 16;
  try {
    const tools::ReadPicture picture = tools::parse_picture(bytes, kMostPixels);
    const auto pixels = static_cast<std::size_t>(picture.width * picture.height);
    if (picture.pixels.size() != pixels) throw std::logic_error("pixels are missing");
  } catch (const tools::PictureError&) {
  }
}

void fuzz_rubric(std::string_view bytes) {
  static const Folder folder;
  std::ofstream(folder.file(), std::ios::binary) << bytes;
  try {
    tools::load_rubric(folder.file());
  } catch (const scene::SceneFileError&) {
  }
}

/// Parses the contents of a unit's file without its digest, because random bytes do not match a
/// digest.
void fuzz_unit(std::string_view bytes) {
  try {
    // The result in a unit of `properties`.
    using Result =
        std::pair<std::vector<properties::CampaignPart>, std::optional<properties::WorstCase>>;
    const std::string again = tools::to_bytes(tools::from_bytes<Result>(bytes));
    require(tools::to_bytes(tools::from_bytes<Result>(again)) == again,
            "a result changes when it is written and read again");
  } catch (const std::invalid_argument&) {
  }
}

void fuzz_toml_scene(std::string_view bytes) {
  try {
    require_read_back(scene::read_toml(bytes, "f.toml").scene);
  } catch (const scene::SceneFileError&) {
  }
  try {
    const scene::FileFormat format = scene::read_format(bytes, "f.toml");
    require_read_back(scene::read_formatted(format, "sphere 1 2 3 4\n", "f.txt").scene);
  } catch (const scene::SceneFileError&) {
  }
}

void fuzz_driver_file(std::string_view bytes) {
  const std::string shown = scene::visible(bytes);
  require(scene::visible(shown) == shown, "visible text changes when it is made visible again");
  try {
    require_read_back(scene::read_any_format(bytes, "f.txt").scene);
  } catch (const scene::SceneFileError&) {
  }
  // One of the formats, as another byte is read.
  const auto& formats = scene::formats();
  const auto format =
      std::next(formats.begin(), static_cast<std::ptrdiff_t>(bytes.size()) % std::ssize(formats));
  try {
    require_read_back(scene::read_formatted(format->second, bytes, "f.txt").scene);
  } catch (const scene::SceneFileError&) {
  }
}

}  // namespace raycheck::tests
