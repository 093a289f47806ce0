#include "tools/external/pictures/stored_picture.h"

#include <fmt/core.h>

#include <cstring>
#include <sstream>

namespace raycheck::tools {

std::string stored_text(const MadePicture& made) {
  const auto& [width, height, pixels] = made.picture;
  std::string text =
      fmt::format("{} {} {} {}\n", width, height, made.other_name.size(), made.ended.size());
  text += made.other_name + made.ended;
  text.append(reinterpret_cast<const char*>(pixels.data()), pixels.size() * sizeof(Colour));
  return text;
}

std::optional<MadePicture> stored_picture(std::string_view text) {
  const std::size_t line = text.find('\n');
  if (line == std::string_view::npos) return {};
  std::istringstream head{std::string(text.substr(0, line))};
  text.remove_prefix(line + 1);
  MadePicture made;
  std::size_t other_name = 0, ended = 0;
  head >> made.picture.width >> made.picture.height >> other_name >> ended;
  if (!head || other_name > text.size() || ended > text.size() - other_name) return {};
  made.other_name = text.substr(0, other_name);
  made.ended = text.substr(other_name, ended);
  text.remove_prefix(other_name + ended);
  made.picture.pixels.resize(text.size() / sizeof(Colour));
  const auto width = static_cast<std::size_t>(made.picture.width);
  if (made.picture.width <= 0 || made.picture.height <= 0 || text.size() % sizeof(Colour) != 0 ||
      (!text.empty() &&
       (made.picture.pixels.size() % width != 0 ||
        made.picture.pixels.size() / width != static_cast<std::size_t>(made.picture.height)))) {
    return {};
  }
  std::memcpy(made.picture.pixels.data(), text.data(), text.size());
  return made;
}

}  // namespace raycheck::tools
