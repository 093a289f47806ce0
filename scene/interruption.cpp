#include "scene/interruption.h"

namespace raycheck::scene {
namespace {

thread_local const std::function<bool()>* asked = nullptr;

}  // namespace

Interruptible::Interruptible(const std::function<bool()>& interrupted) : before_(asked) {
  asked = &interrupted;
}

Interruptible::~Interruptible() { asked = before_; }

void poll() {
  if (asked != nullptr && (*asked)()) throw Interrupted{};
}

}  // namespace raycheck::scene
