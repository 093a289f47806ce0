#include "tools/grade/results/record.h"

#include <gtest/gtest.h>

#include <limits>

#include "scene/files/scene_file.h"

namespace raycheck::tests {
namespace {

using tools::ItemGrade;
using tools::ItemReason;

tools::WrongAnswer wrong_answer() {
  return {.quantity = properties::Quantity::kParameter,
          .place = {3, scene::Pixel{3, 0}, 0},
          .part = "U",
          .wrong = properties::Wrong::kNot,
          .symbol = "s",
          .got = {0.1},
          .exact = std::vector<double>{0x1.8p+3},
          .error = std::numeric_limits<double>::infinity(),
          .condition = 2.5,
          .precision = scene::Precision::kSingle};
}

ItemGrade failing_item() {
  ItemGrade item;
  item.name = "classes";
  item.state = tools::ItemState::kFails;
  item.mistakes = {{"a", 1, 1}, {"a; and b", 4, 2, {"a", "b"}}};
  tools::FailingCase& failing = item.failing.emplace();
  failing.law = "class";
  failing.origin = {.source = "distance@3", .number = 7};
  failing.step = "direction";
  failing.answer = wrong_answer();
  failing.the_case = {scene::load_scene(RAYCHECK_SOURCE_DIR "/scene/examples/example-4.toml").scene,
                      {{1, 2}}};
  const scene::Camera& camera = *failing.the_case.scene.camera;
  const auto pixels = static_cast<std::size_t>(camera.width * camera.height);
  failing.pictures = {properties::ImageAnswer(pixels, properties::kSomeSphere),
                      properties::ImageAnswer(pixels, std::nullopt)};
  failing.answers = {.frame = properties::FrameAnswer{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                     .ray = scene::Ray{{0, 0, 0}, {0, 0, -1}},
                     .hits = {{{2, {0.1, {1, 2, 3}}}}}};
  item.first_wrong = {{.scene = "far.toml"}, wrong_answer()};
  return item;
}

TEST(Record, IsReadAsItWasWritten) {
  tools::SubmissionGrade grade;
  grade.name = "ada";
  grade.key = "d1";
  grade.program = tools::parse_candidate("command:./a");
  grade.driver.extra_lines = {"recursionlevel 0"};
  grade.notes = {"a note"};
  grade.opaque_files = {{"a.png", "picture", 12}};
  grade.refused = {"why", "said"};
  grade.seed = std::numeric_limits<std::uint64_t>::max();
  grade.items = {failing_item(), {}};
  grade.items.back().reason = {.kind = ItemReason::Kind::kNeeds, .item = "classes"};
  const std::string text = tools::json_text(record_json(grade));
  EXPECT_EQ(tools::json_text(record_json(tools::read_record(text))), text);
}

}  // namespace
}  // namespace raycheck::tests
