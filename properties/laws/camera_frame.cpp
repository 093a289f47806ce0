#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "properties/laws/law_list.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "reference/near_error.h"

namespace raycheck::properties {
namespace {

/// The largest of the axes' unit defects and mutual cosines; empty if the frame is not certainly
/// right-handed, or in_u() of a cosine is empty.
template <class Triple, class InU>
std::optional<scene::Measured> orthonormality_error(const FrameAnswer& frame, const Triple& U,
                                                    const Triple& V, const Triple& W,
                                                    const InU& in_u) {
  if (dot(cross(U, V), W).certain_sign() != 1) return std::nullopt;
  scene::Measured largest =
      std::max({reference::unit_defect(frame.U), reference::unit_defect(frame.V),
                reference::unit_defect(frame.W)});
  for (const auto& cosine : std::array{dot(U, V), dot(V, W), dot(W, U)}) {
    const std::optional<scene::Measured> error = in_u(cosine);
    if (!error) return std::nullopt;
    largest = std::max(largest, *error);
  }
  return largest;
}

/// Infinite if the frame is left-handed or not finite.
scene::Measured orthonormality_error(const Trial& trial, const Verdict& verdict,
                                     const FrameAnswer& frame) {
  using reference::in_double_doubles;
  return trial.settled(
      verdict, Quantity::kOrthonormality, trial.bound(Quantity::kOrthonormality),
      [&] {
        return reference::by_double_doubles([&] {
          return orthonormality_error(frame, in_double_doubles(frame.U), in_double_doubles(frame.V),
                                      in_double_doubles(frame.W), [](const auto& cosine) {
                                        return reference::narrow_error_in_u(abs(cosine));
                                      });
        });
      },
      [&] {
        return orthonormality_error(
                   frame, enclose_exactly(frame.U), enclose_exactly(frame.V),
                   enclose_exactly(frame.W),
                   [](const Enclosure& cosine) { return std::optional(in_units_of_u(cosine)); })
            .value_or(scene::Measured{std::numeric_limits<double>::infinity()});
      });
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
  trial.measure(verdict, {Quantity::kOrthonormality, {}, orthonormality_error(trial, verdict, got)},
                condition, [&](Discrepancy& d) {
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
