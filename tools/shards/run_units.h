#pragma once

#include <fmt/core.h>

#include <cereal/types/array.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/utility.hpp>
#include <cereal/types/vector.hpp>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "properties/archive.h"
#include "properties/run_control.h"
#include "tools/run/threads.h"
#include "tools/shards/unit_archive.h"
#include "tools/shards/units.h"

namespace raycheck::tools {

/// A result as bytes, which are the same on every machine and exact for doubles.
template <class Result>
std::string to_bytes(const Result& result) {
  UnitWriter archive;
  archive(result);
  return std::move(archive.bytes);
}
/// The result from its bytes.
/// Errors: std::invalid_argument if the bytes are invalid.
template <class Result>
Result from_bytes(std::string_view bytes) {
  Result result;
  UnitReader archive(bytes);
  archive(result);
  if (!archive.is_done()) throw std::invalid_argument("extra bytes follow the result");
  return result;
}

/// Runs a campaign's units in order, like in_order(). If `units` is given, computes only the
/// shard's missing units and stores their results; take() then gets all results, or is not called
/// if the shard is not the whole campaign.
/// Domain: a result depends only on its unit.
template <class Result, class Make, class Take>
void run_units(std::int64_t count, Units* units, const properties::RunControl& control,
               const Make& make, const Take& take) {
  if (units == nullptr) return in_order<Result>(count, control, make, take);
  const std::vector<std::int64_t> mine = units->open(count);
  std::int64_t done = 0;
  in_order<Result>(
      static_cast<std::int64_t>(mine.size()), control,
      [&](std::int64_t k) {
        const std::int64_t unit = mine[static_cast<std::size_t>(k)];
        if (const auto bytes = units->read(unit)) {
          try {
            return from_bytes<Result>(*bytes);
          } catch (const std::invalid_argument& error) {
            units->refuse(unit, error.what());
          }
        }
        Result result = make(unit);
        if (!control.interrupted()) units->write(unit, to_bytes(result));
        return result;
      },
      [&](Result& result) {
        if (units->are_all()) return take(result);
        control.progress(fmt::format("{} of {} units of shard {} of {}", ++done, mine.size(),
                                     units->shard().number, units->shard().of));
      });
}

}  // namespace raycheck::tools
