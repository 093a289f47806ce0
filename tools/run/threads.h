#pragma once

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "properties/run_control.h"
#include "scene/interruption.h"
#include "scene/plan/plan.h"

namespace raycheck::tools {

/// Calls work() in an arena of as many threads as `control` has.
template <class Work>
void on_threads(const properties::RunControl& control, const Work& work) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(control.threads));
  tbb::task_arena(control.threads).execute(work);
}

/// A loop that runs on the threads of `control`, which must outlive it. It throws
/// scene::Interrupted on an interrupt.
inline scene::ForEach for_each_on(const properties::RunControl& control) {
  return [&control](std::size_t count, const std::function<void(std::size_t)>& body) {
    on_threads(control, [&] {
      tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
        const scene::Interruptible interruptible(control.interrupted);
        body(k);
      });
    });
  };
}

/// Calls make(k) for every k in [0, count) on the threads of `control`, and take(result) one after
/// the other in the order of k, so that the outcome does not depend on the number of threads. At
/// most `most_made` results are made or wait to be taken at a time, by default twice the number of
/// threads: a make() that takes long stops the other threads once the rest of them wait. Stops
/// early on an interrupt; if that occurs inside make(), its result is not taken. Other exceptions
/// of make and take pass through.
template <class Result, class Make, class Take>
void in_order(std::int64_t count, const properties::RunControl& control, const Make& make,
              const Take& take, std::optional<std::size_t> most_made = {}) {
  std::int64_t next = 0;
  const auto number = [&](tbb::flow_control& flow) -> std::int64_t {
    if (next == count || control.interrupted()) {
      flow.stop();
      return 0;
    }
    return next++;
  };
  using Shared = std::shared_ptr<Result>;
  const auto made = [&](std::int64_t k) {
    const scene::Interruptible interruptible(control.interrupted);
    return std::make_shared<Result>(make(k));
  };
  try {
    on_threads(control, [&] {
      tbb::parallel_pipeline(
          most_made.value_or(2 * static_cast<std::size_t>(control.threads)),
          tbb::make_filter<void, std::int64_t>(tbb::filter_mode::serial_in_order, number) &
              tbb::make_filter<std::int64_t, Shared>(tbb::filter_mode::parallel, made) &
              tbb::make_filter<Shared, void>(tbb::filter_mode::serial_in_order,
                                             [&](const Shared& result) { take(*result); }));
    });
  } catch (const scene::Interrupted&) {
    // Keep the results taken so far.
  }
}

}  // namespace raycheck::tools
