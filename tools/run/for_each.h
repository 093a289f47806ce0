#pragma once

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <functional>

#include "properties/run_control.h"
#include "scene/interruption.h"
#include "scene/plan/plan.h"

namespace raycheck::tools {

/// A loop that runs on the threads of `control`, which must outlive it. It throws
/// scene::Interrupted on an interrupt.
inline scene::ForEach for_each_on(const properties::RunControl& control) {
  return [&control](std::size_t count, const std::function<void(std::size_t)>& body) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(control.threads));
    tbb::task_arena arena(control.threads);
    arena.execute([&] {
      tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
        const scene::Interruptible interruptible(control.interrupted);
        body(k);
      });
    });
  };
}

}  // namespace raycheck::tools
