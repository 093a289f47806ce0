#ifndef RAYCHECK_SCENE_VALIDATE_H_
#define RAYCHECK_SCENE_VALIDATE_H_

#include <string>
#include <vector>

#include "scene/scene.h"

namespace raycheck::scene {

/// One reason why an input is not a problem that has an answer.
struct Problem {
  std::string field;  ///< As scene files spell it: "camera.up", "sphere[2].radius" (from 0).
  std::string value;  ///< The offending value, as it was read.
  std::string what;   ///< What is wrong with it, in words.
};

/// Everything that makes the input degenerate; empty when it is a problem with an answer.
/// E = A and "up parallel to E - A" are decided exactly, over the rationals.
std::vector<Problem> problems(const Camera& camera);
std::vector<Problem> problems(const Ray& ray);
std::vector<Problem> problems(const Sphere& sphere);
std::vector<Problem> problems(const Scene& scene);

/// Throws std::invalid_argument naming the field, its value and what is wrong, unless the input is
/// a problem with an answer.
void require_valid(const Camera& camera);
void require_valid(const Ray& ray);
void require_valid(const Sphere& sphere);
void require_valid(const Scene& scene);

}  // namespace raycheck::scene

#endif  // RAYCHECK_SCENE_VALIDATE_H_
