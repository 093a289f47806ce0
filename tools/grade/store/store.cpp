#include "tools/grade/store/store.h"

#include <fmt/core.h>
#include <unistd.h>

#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "scene/invalid_input.h"
#include "tools/external/sandbox/file_tree.h"
#include "tools/report/digest.h"
#include "tools/report/json.h"
#include "tools/report/output_file.h"
#include "tools/report/packed.h"
#include "tools/report/version.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFiles = "files";       ///< The folder with the files of a build.
constexpr const char* kRecord = "made.json";  ///< The description of a build.

/// Copies a folder's regular files, but no links, with their times; returns their digests by name.
std::map<std::string, std::string> copy_files(const fs::path& from, const fs::path& to) {
  std::map<std::string, std::string> digests;
  for (const auto& entry : fs::recursive_directory_iterator(from)) {
    if (!fs::is_regular_file(entry.symlink_status())) continue;
    const std::string name = entry.path().lexically_relative(from).string();
    copy_with_time(entry.path(), to / name);
    digests[name] = file_digest(to / name);
  }
  return digests;
}

constexpr std::string_view kFirstLine = "raycheck answers 4";
/// The limits on the bytes of one program's answers, without and with their headers.
constexpr std::size_t kMostKept = std::size_t{64} << 20;
constexpr std::size_t kMostUnpacked = 2 * kMostKept;

/// The answers of one program in one compressed file. The constructor reads it; the destructor
/// writes it if there are new answers. A damaged file counts as missing. Thread-safe.
class AnswerFile : public AnswerStore {
 public:
  explicit AnswerFile(fs::path path) : path_(std::move(path)) {
    std::ifstream file(path_, std::ios::binary);
    std::string head;
    std::size_t size = 0;
    if (!std::getline(file, head) || head != kFirstLine) return;
    if (!(file >> size) || file.get() != '\n' || size > kMostUnpacked) return;
    const std::string text = unpacked({std::istreambuf_iterator<char>(file), {}}, size);
    if (text.empty()) return;
    for (const Json& kept : Json::from_cbor(text)) {
      StoredAnswer& answer = answers_[kept.at(0)];
      if (!kept.at(1).is_null()) answer.failure = static_cast<FailureKind>(kept.at(1).get<int>());
      kept.at(2).get_to(answer.seconds);
      kept.at(3).get_to(answer.text);
      bytes_ += answer.text.size();
    }
  }

  ~AnswerFile() override {
    if (!is_new_) return;
    try {
      Json all = Json::array();
      for (const auto& [request, answer] : answers_) {
        all.push_back({request, or_null(answer.failure), answer.seconds, answer.text});
      }
      std::string text;
      Json::to_cbor(all, text);
      OutputFile("out", path_)
          .write(fmt::format("{}\n{}\n", kFirstLine, text.size()) + packed(text));
    } catch (const std::exception&) {
      // An answer that is not stored is asked for again.
    }
  }

  std::optional<StoredAnswer> find(const std::string& request) const override {
    const std::lock_guard lock(mutex_);
    const auto found = answers_.find(digest({request}));
    return found == answers_.end() ? std::nullopt : std::optional(found->second);
  }

  /// Stores an answer unless all answers would exceed kMostKept bytes.
  void keep(const std::string& request, StoredAnswer answer) override {
    // Later runs cannot recognise the folders of this one.
    if (answer.failure) answer.text = without_private_folders(answer.text);
    const std::lock_guard lock(mutex_);
    if (answer.text.size() > kMostKept - bytes_) return;
    bytes_ += answer.text.size();
    is_new_ = answers_.try_emplace(digest({request}), std::move(answer)).second || is_new_;
  }

 private:
  fs::path path_;
  mutable std::mutex mutex_;
  std::map<std::string, StoredAnswer> answers_;  ///< By the digests of requests.
  std::size_t bytes_ = 0;
  bool is_new_ = false;
};

}  // namespace

bool is_executable(const fs::path& path) {
  return (fs::status(path).permissions() & fs::perms::owner_exec) != fs::perms::none;
}

std::string file_digest(const fs::path& path) {
  return digest({is_executable(path) ? "runs" : "", file_bytes(path)});
}

Store::Store(const fs::path& out) {
  const fs::path folder = out / kStoreFolder;
  builds_ = folder / "builds";
  answers_ = folder / "answers";
  std::error_code error;
  fs::create_directories(out, error);
  if (!error) fs::create_directory(folder, error);
  if (!error && !fs::is_directory(fs::symlink_status(folder))) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (!error) fs::permissions(folder, fs::perms::owner_all, error);
  for (const fs::path& part : {builds_, answers_}) {
    if (!error) fs::create_directory(part, error);
  }
  if (error) {
    throw scene::InvalidInput("out", folder.string(), error.message());
  }
}

Built Store::built(const std::string& key, const fs::path& to, const std::function<Built()>& make,
                   bool& is_stored) {
  std::mutex& alone = [&]() -> std::mutex& {
    const std::lock_guard lock(mutex_);
    return building_[key];
  }();
  const std::lock_guard lock(alone);
  if (auto known = find(key, to)) {
    is_stored = true;
    return std::move(*known);
  }
  is_stored = false;
  Built made = make();
  try {
    keep(key, to, made);
  } catch (const std::exception&) {
    // A build that is not stored is built again.
  }
  return made;
}

std::optional<Built> Store::find(const std::string& key, const fs::path& to) const {
  const fs::path folder = builds_ / key;
  if (!fs::exists(folder / kRecord)) return {};
  try {
    const Json record = Json::parse(file_bytes(folder / kRecord));
    const Json& made = record.at("made");
    if (digest({made.dump()}) != record.at("digest").get<std::string>()) return {};
    const auto digests = made.at("files").get<std::map<std::string, std::string>>();
    if (copy_files(folder / kFiles, to) == digests) {
      return Built{made.at("programs").get<std::vector<std::string>>(), made.at("words"),
                   made.at("notes").get<std::vector<std::string>>(), made.at("what"),
                   made.at("next_way")};
    }
  } catch (const std::exception&) {
    // The stored build was changed.
  }
  empty_folder(to);
  return {};
}

void Store::keep(const std::string& key, const fs::path& from, const Built& built) const {
  const fs::path folder = builds_ / key;
  const fs::path beside = fmt::format("{}.{}", folder.string(), getpid());
  fs::remove_all(beside);
  fs::create_directories(beside / kFiles);
  const Json made = {{"programs", built.programs}, {"words", built.words},
                     {"notes", built.notes},       {"what", built.what},
                     {"next_way", built.next_way}, {"files", copy_files(from, beside / kFiles)}};
  std::ofstream(beside / kRecord, std::ios::binary)
      << Json{{"made", made}, {"digest", digest({made.dump()})}}.dump() << "\n";
  fs::remove_all(folder);
  fs::rename(beside, folder);
}

std::shared_ptr<AnswerStore> Store::answers(const std::string& key) {
  const std::lock_guard lock(mutex_);
  auto& known = asked_[key];
  if (auto shared = known.lock()) return shared;
  auto made = std::make_shared<AnswerFile>(answers_ / key);
  known = made;
  return made;
}

namespace {

/// The version of the format of stored builds and answers.
constexpr std::string_view kStoreShape = "store 2";

/// As in kProgramFolders.
constexpr const char* kFolders[] = {"/usr/local/bin", "/usr/bin"};
constexpr const char* kPrograms[] = {"g++",   "gcc",  "c++",  "cc",     "clang++",
                                     "clang", "ld",   "make", "cmake",  "ninja",
                                     "javac", "java", "node", "python3"};
constexpr const char* kVersionHeaders[] = {"/usr/include/eigen3/Eigen/src/Core/util/Macros.h",
                                           "/usr/include/glm/detail/setup.hpp"};

/// A file's path, target, size and time; empty if it does not exist.
std::vector<std::string> identity(const fs::path& path) {
  std::error_code error;
  const fs::path file = fs::canonical(path, error);
  if (error) return {};
  return {path.string(), file.string(), std::to_string(fs::file_size(file, error)),
          std::to_string(fs::last_write_time(file, error).time_since_epoch().count())};
}

}  // namespace

std::string toolchain() {
  std::vector<std::string> texts = {std::string(kVersion), std::string(kStoreShape)};
  const auto add = [&](const fs::path& path) {
    for (std::string& text : identity(path)) texts.push_back(std::move(text));
  };
  for (const char* const folder : kFolders) {
    for (const char* const program : kPrograms) add(fs::path(folder) / program);
  }
  for (const char* const header : kVersionHeaders) add(header);
  return digest(texts);
}

namespace {

constexpr std::string_view kHeading =
    "# What raycheck wrote here: digests of names and contents. It replaces no other files.";

std::string digest_of(const fs::path& name, const std::string& text) {
  return digest({name.generic_string(), text});
}

/// Whether something has this name, even a dangling link.
bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

}  // namespace

OwnFiles::OwnFiles(fs::path out) : out_(std::move(out)) {
  const fs::path path = out_ / kOwnFilesList;
  if (!is_there(path)) return;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  if (!fs::is_regular_file(fs::symlink_status(path)) || !std::getline(file, line) ||
      line != kHeading) {
    throw scene::InvalidInput("out", out_.string(),
                              path.string() +
                                  " is not raycheck's list of the files that it wrote; move it "
                                  "away, or give another folder");
  }
  while (std::getline(file, line)) digests_.insert(line);
}

bool OwnFiles::is_own(const fs::path& name) const {
  const fs::path path = out_ / name;
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(path, error))) return false;
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::lock_guard lock(mutex_);
  return digests_.contains(digest_of(name, text));
}

void OwnFiles::require_own(const fs::path& name) const {
  if (!is_there(out_ / name) || is_own(name)) return;
  throw scene::InvalidInput("out", out_.string(),
                            (out_ / name).string() +
                                " was not written by raycheck, or has changed since; move it away, "
                                "or give another folder");
}

void OwnFiles::list(const std::string& digest) {
  const std::lock_guard lock(mutex_);
  if (!digests_.insert(digest).second) return;
  const fs::path path = out_ / kOwnFilesList;
  const bool is_new = !is_there(path);
  std::ofstream file(path, std::ios::binary | std::ios::app);
  if (is_new) file << kHeading << "\n";
  file << digest << "\n";
  if (!file.flush()) {
    throw std::runtime_error(fmt::format("out {}: could not be written", path.string()));
  }
}

void OwnFiles::write(const fs::path& name, const std::string& text) {
  require_own(name);
  // The file is listed before it is written, so that an interruption never leaves an unlisted file.
  list(digest_of(name, text));
  OutputFile("out", out_ / name).write(text);
}

void OwnFiles::replace(const fs::path& folder, const std::map<std::string, std::string>& files) {
  make_folder("out", out_ / folder);
  for (const auto& entry : fs::directory_iterator(out_ / folder)) {
    const std::string name = entry.path().filename();
    if (name != kRecordFile && !files.contains(name) && is_own(folder / name)) {
      fs::remove(entry.path());
    }
  }
  for (const auto& [name, text] : files) write(folder / name, text);
}

}  // namespace raycheck::tools
