#include "tools/list/list.h"

namespace raycheck::tools {

Catalogue catalogue() {
  return {fast::pixel_ray_methods(), fast::intersect_methods(), properties::laws(),
          properties::case_sources()};
}

}  // namespace raycheck::tools
