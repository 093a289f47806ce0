#include <fmt/core.h>
#include <zlib.h>

#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "tools/grade/rubric/rubric_files.h"
#include "tools/grade/store/store.h"
#include "tools/report/json.h"
#include "tools/report/output_file.h"

namespace raycheck::tools {
namespace {

constexpr std::string_view kFirstLine = "raycheck answers 3";
constexpr int kQuickly = 1;  ///< zlib's level
/// More than kMostKept bytes of answers with their headers.
constexpr std::size_t kMostUnpacked = 2 * AnswerFile::kMostKept;
/// The kind written for an answer that is not a failure.
constexpr int kAnswered = -1;

/// As CBOR: of each its request's digest, its kind, seconds and text.
std::string text_of(const std::map<std::string, StoredAnswer>& answers) {
  Json all = Json::array();
  for (const auto& [request, answer] : answers) {
    const int kind = answer.failure ? static_cast<int>(*answer.failure) : kAnswered;
    all.push_back({request, kind, answer.seconds, answer.text});
  }
  std::string text;
  Json::to_cbor(all, text);
  return text;
}

std::map<std::string, StoredAnswer> answers_of(const std::string& text) {
  std::map<std::string, StoredAnswer> answers;
  if (text.empty()) return answers;
  const Json all = Json::from_cbor(text);
  for (const Json& kept : all) {
    StoredAnswer& answer = answers[kept.at(0)];
    const int kind = kept.at(1);
    if (kind != kAnswered) answer.failure = static_cast<FailureKind>(kind);
    kept.at(2).get_to(answer.seconds);
    kept.at(3).get_to(answer.text);
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
