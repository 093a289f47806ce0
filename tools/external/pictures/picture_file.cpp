#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string_view>
#include <tuple>
#include <vector>

#include "tools/external/pictures/renderer.h"

namespace raycheck::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> kUsual = {"out", "output", "image", "picture", "result"};

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool is_picture(const fs::path& path) {
  const std::string ending = lower_case(path.extension().string());
  return ending == ".ppm" || ending == ".pnm" || ending == ".png";
}

/// 0 for the driver file's own name, then the usual ones in their order, then all others.
std::size_t rank(const fs::path& path, const std::string& scene) {
  const std::string stem = lower_case(path.stem().string());
  if (stem == lower_case(fs::path(scene).stem().string()) || stem == lower_case(scene)) return 0;
  return 1 +
         static_cast<std::size_t>(std::find(kUsual.begin(), kUsual.end(), stem) - kUsual.begin());
}

}  // namespace

std::optional<FoundPicture> found_picture(const fs::path& folder, const std::string& named,
                                          const std::string& scene) {
  if (fs::exists(fs::symlink_status(folder / named))) return FoundPicture{folder / named, true};
  struct Found {
    std::size_t rank;
    fs::file_time_type made;
    fs::path path;
  };
  std::vector<Found> pictures;
  // A program may leave its own folders unreadable.
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code gone;
    if (!fs::is_regular_file(entry->symlink_status(gone)) || !is_picture(entry->path())) continue;
    pictures.push_back({rank(entry->path(), scene), entry->last_write_time(gone), entry->path()});
  }
  if (pictures.empty()) return {};
  const auto best =
      std::min_element(pictures.begin(), pictures.end(), [](const Found& a, const Found& b) {
        return std::tuple(a.rank, b.made, a.path) < std::tuple(b.rank, a.made, b.path);
      });
  return FoundPicture{best->path, false};
}

std::string stored_text(const MadePicture& made) {
  const auto& [width, height, pixels] = made.picture;
  std::string text = fmt::format("{} {} {} {} {}\n", width, height, pixels.size(),
                                 made.other_name.size(), made.ended.size());
  text += made.other_name + made.ended;
  return text.append(reinterpret_cast<const char*>(pixels.data()), pixels.size() * sizeof(Colour));
}

MadePicture stored_picture(const std::string& text) {
  std::istringstream stored(text);
  MadePicture made;
  std::size_t pixels = 0, other_name = 0, ended = 0;
  stored >> made.picture.width >> made.picture.height >> pixels >> other_name >> ended;
  stored.get();
  const auto take = [&](auto& into, std::size_t size) {
    into.resize(size);
    stored.read(reinterpret_cast<char*>(into.data()),
                static_cast<std::streamsize>(size * sizeof(into[0])));
  };
  take(made.other_name, other_name);
  take(made.ended, ended);
  take(made.picture.pixels, pixels);
  return made;
}

}  // namespace raycheck::tools
