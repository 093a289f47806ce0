#include "scene/files/scene_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace raycheck::scene {
namespace {

[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& reason) {
  throw SceneFileError(path.string() + ": cannot be read: " + reason);
}

std::string contents(const std::filesystem::path& path) {
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  errno = 0;
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "rb"));
  if (!file) fail_to_read(path, std::generic_category().message(errno));
  std::string text;
  std::array<char, 1 << 14> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    text.append(buffer.data(), count);
  }
  if (std::ferror(file.get())) fail_to_read(path, std::generic_category().message(errno));
  return text;
}

}  // namespace

LoadedScene load_scene(const std::filesystem::path& path, std::optional<Dialect> dialect) {
  const std::string text = contents(path);
  if (path.extension() != ".toml") return read_driver_file(text, path.string(), dialect);
  LoadedScene loaded = read_toml(text, path.string());
  if (dialect) {
    loaded.warnings.push_back(path.string() +
                              ": a dialect was asked for, but only driver files have one");
  }
  return loaded;
}

}  // namespace raycheck::scene
