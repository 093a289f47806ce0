#include "tools/grade/judging/item_causes.h"

namespace raycheck::tools {

std::optional<properties::ShapeCause> shape_of_failures(const std::vector<ItemTrial>& trials) {
  std::vector<properties::TriedScene> tried;
  for (const ItemTrial& trial : trials) {
    for (const properties::ShownPicture& one : trial.pictures) tried.push_back({&one.scene, false});
    for (const FailedCase& one : trial.failed) {
      if (!one.shown) tried.push_back({&one.item_case.the_case.scene, true});
    }
  }
  return properties::shape_cause(tried);
}

}  // namespace raycheck::tools
