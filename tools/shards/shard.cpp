#include "tools/shards/shard.h"

#include <fmt/core.h>

#include <charconv>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace raycheck::tools {
namespace {

/// The variables by which a scheduler says who this worker is.
struct Scheduler {
  const char* index;
  const char* first;  ///< The variable that has the least index; null: it is `least`.
  std::int64_t least;
  const char* count;  ///< Null where it does not say.
};
constexpr Scheduler kSchedulers[] = {
    {"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", 0, "SLURM_ARRAY_TASK_COUNT"},
    {"JOB_COMPLETION_INDEX", nullptr, 0, nullptr},
    {"TEST_SHARD_INDEX", nullptr, 0, "TEST_TOTAL_SHARDS"},
    {"CI_NODE_INDEX", nullptr, 1, "CI_NODE_TOTAL"}};

std::int64_t number_of(const std::string& named_by, std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc{} && end == text.data() + text.size() && number >= 0) return number;
  throw std::invalid_argument(fmt::format("{}: '{}' is not a whole number", named_by, text));
}

std::optional<std::int64_t> variable(const char* name) {
  const char* const text = name != nullptr ? std::getenv(name) : nullptr;
  if (text == nullptr) return std::nullopt;
  return number_of(name, text);
}

/// `of`: what was said otherwise.
std::optional<Shard> shard_of(const Scheduler& scheduler, std::optional<std::int64_t> of) {
  const std::optional<std::int64_t> index = variable(scheduler.index);
  const std::optional<std::int64_t> count = of ? of : variable(scheduler.count);
  if (!index || !count) return std::nullopt;
  const std::int64_t least = variable(scheduler.first).value_or(scheduler.least);
  return Shard{*index - least + 1, *count, fmt::format("{}={}", scheduler.index, *index)};
}

Shard checked(Shard shard) {
  if (shard.number >= 1 && shard.number <= shard.of) return shard;
  throw std::invalid_argument(fmt::format("{}: there is no shard {} of {}; the first is shard 1",
                                          shard.said_by, shard.number, shard.of));
}

}  // namespace

Shard chosen_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (!text.empty() && slash == std::string::npos) {
    throw std::invalid_argument(fmt::format("shard {}: give K/N, or auto/N", text));
  }
  const std::string number = text.substr(0, slash);
  std::optional<std::int64_t> of;
  if (!text.empty()) of = number_of("shard " + text, text.substr(slash + 1));
  if (!text.empty() && number != "auto") {
    return checked({number_of("shard " + text, number), *of, "shard " + text});
  }
  for (const Scheduler& scheduler : kSchedulers) {
    if (const std::optional<Shard> shard = shard_of(scheduler, of)) return checked(*shard);
  }
  if (text.empty()) return {};
  throw std::invalid_argument(
      fmt::format("shard {}: no scheduler says the number by SLURM_ARRAY_TASK_ID, "
                  "JOB_COMPLETION_INDEX, TEST_SHARD_INDEX or CI_NODE_INDEX",
                  text));
}

}  // namespace raycheck::tools
