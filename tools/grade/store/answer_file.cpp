#include <fmt/core.h>
#include <zlib.h>

#include <exception>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "tools/grade/rubric/rubric_files.h"
#include "tools/grade/store/store.h"
#include "tools/report/output_file.h"

namespace raycheck::tools {
namespace {

constexpr std::string_view kFirstLine = "raycheck answers 2";
constexpr int kQuickly = 1;  ///< zlib's level
/// More than kMostKept bytes of answers with their headers.
constexpr std::size_t kMostUnpacked = 2 * AnswerFile::kMostKept;
/// The kind written for an answer that is not a failure.
constexpr int kAnswered = -1;

/// "DIGEST KIND SECONDS SIZE", the text.
std::string text_of(const std::map<std::string, StoredAnswer>& answers) {
  std::string text;
  for (const auto& [request, answer] : answers) {
    const int kind = answer.failure ? static_cast<int>(*answer.failure) : kAnswered;
    text += fmt::format("{} {} {} {}\n", request, kind, answer.seconds, answer.text.size()) +
            answer.text;
  }
  return text;
}

std::map<std::string, StoredAnswer> answers_of(const std::string& text) {
  std::map<std::string, StoredAnswer> answers;
  std::istringstream stream(text);
  std::string request;
  int kind = 0;
  double seconds = 0;
  std::size_t size = 0;
  while (stream >> request >> kind >> seconds >> size && stream.get() == '\n' &&
         size <= text.size()) {
    StoredAnswer& answer = answers[request];
    if (kind != kAnswered) answer.failure = static_cast<FailureKind>(kind);
    answer.seconds = seconds;
    answer.text.resize(size);
    stream.read(answer.text.data(), static_cast<std::streamsize>(size));
  }
  return answers;
}

std::string packed(const std::string& text) {
  uLongf size = compressBound(text.size());
  std::string bytes(size, '\0');
  const int result = compress2(reinterpret_cast<Bytef*>(bytes.data()), &size,
                               reinterpret_cast<const Bytef*>(text.data()), text.size(), kQuickly);
  if (result != Z_OK) throw std::runtime_error("zlib: no memory");
  bytes.resize(size);
  return bytes;
}

/// Empty if these are not such bytes.
std::string unpacked(const std::string& bytes, std::size_t size) {
  std::string text(size, '\0');
  uLongf made = size;
  const int result = uncompress(reinterpret_cast<Bytef*>(text.data()), &made,
                                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  return result == Z_OK && made == size ? text : "";
}

/// The answers in a file, if it is intact.
std::map<std::string, StoredAnswer> answers_in(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head, digested;
  std::size_t size = 0;
  if (!std::getline(file, head) || head != kFirstLine) return {};
  if (!(file >> digested >> size) || file.get() != '\n' || size > kMostUnpacked) return {};
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (digest({bytes, std::to_string(size)}) != digested) return {};
  return answers_of(unpacked(bytes, size));
}

}  // namespace

AnswerFile::AnswerFile(std::filesystem::path path)
    : path_(std::move(path)), answers_(answers_in(path_)) {
  for (const auto& [request, answer] : answers_) bytes_ += answer.text.size();
}

AnswerFile::~AnswerFile() {
  if (!is_new_) return;
  try {
    const std::string text = text_of(answers_);
    const std::string bytes = packed(text);
    OutputFile("out", path_)
        .write(fmt::format("{}\n{} {}\n", kFirstLine, digest({bytes, std::to_string(text.size())}),
                           text.size()) +
               bytes);
  } catch (const std::exception&) {
    // What is not stored is asked again.
  }
}

std::optional<StoredAnswer> AnswerFile::find(const std::string& request) const {
  const std::lock_guard lock(mutex_);
  const auto found = answers_.find(digest({request}));
  return found == answers_.end() ? std::nullopt : std::optional(found->second);
}

void AnswerFile::keep(const std::string& request, StoredAnswer answer) {
  const std::lock_guard lock(mutex_);
  if (answer.text.size() > kMostKept - bytes_) return;
  bytes_ += answer.text.size();
  is_new_ = answers_.try_emplace(digest({request}), std::move(answer)).second || is_new_;
}

}  // namespace raycheck::tools
