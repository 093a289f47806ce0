#include "scene/interruption.h"

#include <gtest/gtest.h>

#include <functional>
#include <thread>

namespace raycheck::scene {
namespace {

TEST(Poll, ThrowsWhereTheLastOneAskedSaysSo) {
  const std::function<bool()> never = [] { return false; };
  const std::function<bool()> always = [] { return true; };
  EXPECT_NO_THROW(poll());
  {
    const Interruptible outer(always);
    EXPECT_THROW(poll(), Interrupted);
    {
      const Interruptible inner(never);
      EXPECT_NO_THROW(poll());
    }
    EXPECT_THROW(poll(), Interrupted);
    std::thread([] { EXPECT_NO_THROW(poll()); }).join();
  }
  EXPECT_NO_THROW(poll());
}

}  // namespace
}  // namespace raycheck::scene
