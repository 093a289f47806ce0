#include <fmt/core.h>

#include "tools/grade/pages/views.h"
#include "tools/grade/pages/wording.h"
#include "tools/grade/results/statistics.h"
#include "tools/report/spelling.h"

namespace raycheck::tools {

/// A row an item: students asked, those with all points, and the points; a row a mistake: students
/// who make it; and how many could not be judged.
std::string statistics_csv(const ClassGrade& graded) {
  std::string text = "kind,name,students,full_points,share_full,median_points,points\n";
  for (const ItemStatistics& one : item_statistics(graded)) {
    text += fmt::format("item,{},{}", csv_cell(one.item->name), one.asked);
    if (one.asked == 0) {
      text += ",,,";
    } else {
      text += fmt::format(",{},{:.4f},{}", one.full,
                          static_cast<double>(one.full) / static_cast<double>(one.asked),
                          points_text(*one.median));
    }
    text += "," + points_text(one.item->points) + "\n";
  }
  for (const MistakeStatistics& one : mistake_statistics(graded)) {
    text += fmt::format("mistake,{},{},,,,\n", csv_cell(one.sentence), one.students.size());
  }
  return text + fmt::format("not judged,,{},,,,\n", submissions_that(graded, false).size());
}

}  // namespace raycheck::tools
