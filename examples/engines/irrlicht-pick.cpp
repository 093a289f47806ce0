// Irrlicht's ISceneCollisionManager::getRayFromScreenCoordinates, "a 3d ray which would go through
// the 2d screen coordinates", from the camera to its far plane, then
// line3d::getIntersectionWithSphere (irrlicht-float.cpp), in floats. Debian: libirrlicht-dev;
// -lIrrlicht. Source: irrlicht/ISceneCollisionManager.h. A pixel is its upper left corner (x over
// the width, by the code). Irrlicht is left-handed: its pictures of raycheck's scenes are mirrored,
// and so are its columns here. Silent on errors and on tangents; the line does not end.

#include <irrlicht/irrlicht.h>

#include <cmath>

#define SINGLE
#include "adapter.h"

using namespace raycheck;
using Point = irr::core::vector3df;

static std::optional<Hit> pick(const Camera& camera, const Conventions&, Pixel pixel,
                               const Sphere& sphere) {
  static irr::IrrlichtDevice* const device = irr::createDevice(irr::video::EDT_NULL);
  const auto width = static_cast<unsigned>(camera.width);
  device->getVideoDriver()->OnResize({width, static_cast<unsigned>(camera.height)});
  irr::scene::ISceneManager* const scene = device->getSceneManager();
  irr::scene::ICameraSceneNode* const own = scene->addCameraSceneNode(
      nullptr, to<Point, float>(camera.eye), to<Point, float>(camera.look_at));
  const auto near = static_cast<float>(-camera.near_plane);
  own->setUpVector(to<Point, float>(camera.up));
  own->setFOV(2 * std::atan(static_cast<float>(camera.top) / near));
  own->setAspectRatio(static_cast<float>(camera.right / camera.top));
  own->setNearValue(near);
  own->setFarValue(1000 * near);
  own->updateAbsolutePosition();
  own->OnRegisterSceneNode();
  own->render();
  const auto line = scene->getSceneCollisionManager()->getRayFromScreenCoordinates(
      {static_cast<int>(width - pixel.i), static_cast<int>(pixel.j)}, own);
  own->remove();
  double distance = 0;
  if (!line.getIntersectionWithSphere(to<Point, float>(sphere.centre),
                                      static_cast<float>(sphere.radius), distance)) {
    return std::nullopt;
  }
  return Hit{distance, {}};
}

RAYCHECK_CANDIDATE(.rows = Rows::top_first, .samples = Samples::corners, .origin = Origin::focal,
                   .root = Root::nearest, .tangent = Tangent::either, .pick = pick,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision, .roots = Roots::declared,
                   .valid = kLine, .returns = Returns::distance, .contract = "windows symmetric")
