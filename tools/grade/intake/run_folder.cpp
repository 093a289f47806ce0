// Where a renderer runs.

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "tools/external/pictures/renderer.h"
#include "tools/grade/intake/handed_in.h"
#include "tools/grade/intake/sources.h"

namespace raycheck::tools {
namespace {

constexpr std::array<std::string_view, 9> kPictureEndings = {
    ".ppm", ".pnm", ".pgm", ".pbm", ".png", ".jpg", ".jpeg", ".gif", ".bmp"};

bool is_called_a_picture(const std::string& path) {
  return std::find(kPictureEndings.begin(), kPictureEndings.end(), ending_of(path)) !=
         kPictureEndings.end();
}

/// Whether a run has another file of that name.
bool is_taken(const std::string& path) {
  const std::string top = path.substr(0, path.find('/'));
  return top == kSceneFile || top == kImageFile;
}

/// Nearer to the top first, so that a folder comes before what lies in it.
bool is_nearer(const std::string& a, const std::string& b) {
  const auto key = [](const std::string& path) {
    return std::tuple<std::ptrdiff_t, const std::string&>(std::count(path.begin(), path.end(), '/'),
                                                          path);
  };
  return key(a) < key(b);
}

}  // namespace

std::shared_ptr<const StartingFolder> run_folder(const HandedInFiles& files,
                                                 const std::vector<std::string>& folders,
                                                 std::shared_ptr<const PrivateFolder> copy) {
  const Vendored vendored = vendored_in(files);
  const auto is_left_out = [&](const std::string& path) {
    return is_taken(path) || vendored.has(path + "/");
  };
  StartingFolder start;
  std::vector<std::string> names;
  for (const std::string& folder : folders) {
    if (!is_left_out(folder)) start.folders.push_back(folder);
  }
  for (const auto& [name, file] : files) {
    if (is_left_out(name) || is_called_a_picture(name) || is_picture(file.text)) continue;
    names.push_back(name);
  }
  std::sort(start.folders.begin(), start.folders.end(), is_nearer);
  start.folders.resize(std::min(start.folders.size(), kMostInRunFolder));
  std::sort(names.begin(), names.end(), is_nearer);
  const std::set<std::string> made(start.folders.begin(), start.folders.end());
  std::size_t copied = 0;
  for (const std::string& name : names) {
    const std::size_t count = start.folders.size() + start.files.size() + start.links.size();
    if (count >= kMostInRunFolder) break;
    if (!folder_of(name).empty() && !made.contains(folder_of(name))) continue;
    const HandedInFile& file = files.at(name);
    if (file.text.size() <= kMostOfCopy && copied + file.text.size() <= kMostOfCopies) {
      copied += file.text.size();
      start.files.push_back({name, file.text, file.runs});
    } else {
      start.links.push_back(name);
    }
  }
  start.linked = std::move(copy);
  return std::make_shared<const StartingFolder>(std::move(start));
}

}  // namespace raycheck::tools
