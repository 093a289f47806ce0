#include <fmt/core.h>

#include <charconv>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "scene/invalid_input.h"
#include "tools/shards/units.h"

namespace raycheck::tools {
namespace {

/// The environment variables in which a scheduler gives a worker's index and the number of workers,
/// or null.
struct Scheduler {
  const char* index;
  const char* count;
  std::int64_t least = 0;  ///< The smallest index if `first` is null.
  const char* first = nullptr;
  const char* step = nullptr;
};
constexpr Scheduler kSchedulers[] = {{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", 0,
                                      "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_STEP"},
                                     {"JOB_COMPLETION_INDEX", nullptr},
                                     {"TEST_SHARD_INDEX", "TEST_TOTAL_SHARDS"},
                                     {"CI_NODE_INDEX", "CI_NODE_TOTAL", 1}};

std::int64_t number_of(const std::string& field, const std::string& value, std::string_view text) {
  constexpr std::int64_t kMost = 1'000'000'000;
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_all = error == std::errc{} && end == text.data() + text.size();
  if (is_all && number >= 0 && number <= kMost) return number;
  throw scene::InvalidInput(field, value,
                            fmt::format("'{}' is not a whole number up to {}", text, kMost));
}

std::optional<std::int64_t> variable(const char* name) {
  const char* const text = name != nullptr ? std::getenv(name) : nullptr;
  if (text == nullptr) return std::nullopt;
  return number_of(name, "", text);
}

/// The shard that a scheduler sets; empty if its variables are not set. `of`: the number of shards
/// in --shard, if given.
std::optional<Shard> shard_of(const Scheduler& scheduler, std::optional<std::int64_t> of) {
  const std::optional<std::int64_t> index = variable(scheduler.index);
  if (!index) return std::nullopt;
  const std::string said_by = fmt::format("{}={}", scheduler.index, *index);
  const std::optional<std::int64_t> count = of ? of : variable(scheduler.count);
  if (!count) {
    throw std::invalid_argument(said_by + ": the number of shards is unknown; give --shard auto/N");
  }
  const std::int64_t first = variable(scheduler.first).value_or(scheduler.least);
  const std::int64_t step = variable(scheduler.step).value_or(1);
  if (step == 0 || (*index - first) % step != 0) {
    throw std::invalid_argument(fmt::format("{}: is not {} plus a multiple of {}={}", said_by,
                                            first, scheduler.step, step));
  }
  return Shard{(*index - first) / step + 1, *count, said_by};
}

Shard checked(Shard shard, const std::string& field, const std::string& value) {
  if (shard.number >= 1 && shard.number <= shard.of) return shard;
  throw scene::InvalidInput(field, value,
                            fmt::format("there is no shard {} of {}; shards are numbered from 1",
                                        shard.number, shard.of));
}

}  // namespace

Shard chosen_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (!text.empty() && slash == std::string::npos) {
    throw scene::InvalidInput("shard", text, "give K/N, or auto/N");
  }
  const std::string number = text.substr(0, slash);
  std::optional<std::int64_t> of;
  if (!text.empty()) of = number_of("shard", text, text.substr(slash + 1));
  if (!text.empty() && number != "auto") {
    return checked({number_of("shard", text, number), *of, "shard " + text}, "shard", text);
  }
  for (const Scheduler& scheduler : kSchedulers) {
    if (const std::optional<Shard> shard = shard_of(scheduler, of))
      return checked(*shard, shard->said_by, "");
  }
  if (text.empty()) return {};
  throw scene::InvalidInput("shard", text,
                            "auto needs a scheduler that sets SLURM_ARRAY_TASK_ID, "
                            "JOB_COMPLETION_INDEX, TEST_SHARD_INDEX or CI_NODE_INDEX");
}

}  // namespace raycheck::tools
