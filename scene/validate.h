#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace raycheck::scene {

/// A defect of an input that makes its rays or intersections meaningless.
struct Defect {
  std::string field;  ///< As scene files spell it: "camera.up", "sphere[2].radius" (from 0).
  std::string value;  ///< The value, as it was read.
  std::string what;   ///< What is wrong with the value, in words.
};

/// All defects of the input; empty if it is valid. Whether E = A or up is parallel to E - A is
/// decided exactly, over the rationals.
std::vector<Defect> defects(const Camera& camera);
std::vector<Defect> defects(const Camera& camera, const Conventions& conventions);
std::vector<Defect> defects(const Ray& ray);
std::vector<Defect> defects(const Sphere& sphere);
std::vector<Defect> defects(const Conventions& conventions);
std::vector<Defect> defects(const Scene& scene);
/// All defects of the scene under these conventions instead of its own.
std::vector<Defect> defects(const Scene& scene, const Conventions& conventions);

/// One line for each defect: the field, the value and what is wrong.
std::string sentences(const std::vector<Defect>& defects);

/// Throws std::invalid_argument with the text of sentences(), unless the input is valid.
void require_valid(const Camera& camera);
void require_valid(const Ray& ray);
void require_valid(const Sphere& sphere);
void require_valid(const Scene& scene);
void require_valid(const Scene& scene, const Conventions& conventions);
void require_valid(const Conventions& conventions);

bool is_valid(const Camera& camera, const Conventions& conventions);
std::invalid_argument refusal(const Camera& camera, const Conventions& conventions);
/// Inline, so that a thrown exception has one function fewer to unwind.
inline void require_valid(const Camera& camera, const Conventions& conventions) {
  if (!is_valid(camera, conventions)) throw refusal(camera, conventions);
}

}  // namespace raycheck::scene
