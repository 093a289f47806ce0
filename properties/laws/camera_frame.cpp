#include <algorithm>
#include <limits>
#include <optional>

#include "properties/laws/law_list.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "reference/near_error.h"

namespace raycheck::properties {
namespace {

/// The largest of the axes' unit defects and mutual cosines; infinite if the frame is left-handed
/// or not finite.
scene::Measured orthonormality_error(const FrameAnswer& frame) {
  const Enclosure3 U = enclose_exactly(frame.U);
  const Enclosure3 V = enclose_exactly(frame.V);
  const Enclosure3 W = enclose_exactly(frame.W);
  if (dot(cross(U, V), W).certain_sign() != 1) return {std::numeric_limits<double>::infinity()};
  return std::max({reference::unit_defect(frame.U), reference::unit_defect(frame.V),
                   reference::unit_defect(frame.W), in_units_of_u(dot(U, V)),
                   in_units_of_u(dot(V, W)), in_units_of_u(dot(W, U))});
}

void judge_frame(Trial& trial, Verdict& verdict) {
  const FrameAnswer& got = trial.frame();
  const ExactCamera& camera = trial.exact_camera();
  const reference::DoubleDoubleFrame near = camera.frame_in_double_doubles();
  std::optional<reference::EnclosedFrame> enclosed;
  const auto exact = [&]() -> const reference::EnclosedFrame& {
    if (!enclosed) enclosed = camera.frame();
    return *enclosed;
  };
  const auto condition = [&] { return reference::condition_of_frame(camera); };
  const auto judge_axis = [&](const char* axis, const scene::UnitVector3& answer,
                              const reference::Triple<reference::DoubleDouble>& near_truth,
                              Enclosure3 reference::EnclosedFrame::*truth,
                              scene::UnitVector3 reference::RoundedFrame::*member) {
    const scene::Measured error = trial.settled(
        verdict, Quantity::kFrame, trial.bound(Quantity::kFrame),
        [&] { return reference::near_relative_error(answer, near_truth); },
        [&] { return reference::relative_error(answer, exact().*truth); });
    trial.measure(verdict, {Quantity::kFrame, {}, error}, condition, [&](Discrepancy& d) {
      d.what = d.symbol = axis;
      d.got = numbers(answer);
      d.exact = numbers(camera.rounded_frame(trial.precision()).*member);
    });
  };
  judge_axis("U", got.U, near.U, &reference::EnclosedFrame::U, &reference::RoundedFrame::U);
  judge_axis("V", got.V, near.V, &reference::EnclosedFrame::V, &reference::RoundedFrame::V);
  judge_axis("W", got.W, near.W, &reference::EnclosedFrame::W, &reference::RoundedFrame::W);
  trial.measure(verdict, {Quantity::kOrthonormality, {}, orthonormality_error(got)}, condition,
                [&](Discrepancy& d) {
                  d.what = "U, V, W";
                  for (const auto& axis : {got.U, got.V, got.W}) {
                    d.got.insert(d.got.end(), {axis.x, axis.y, axis.z});
                  }
                });
}

constexpr Law kFrameLawTable[] = {
    {"frame", "the frame is orthonormal, right-handed and equal to the camera's", Per::kScene,
     Needs::kFrame, Quantity::kFrame, judge_frame, kValues},
};

}  // namespace

constinit const std::span<const Law> kFrameLaws = kFrameLawTable;

}  // namespace raycheck::properties
