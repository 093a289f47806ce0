// g++ -std=c++17 case.cpp -lIrrlicht -o case
#include <irrlicht/irrlicht.h>
#include <cmath>
#include <cstdio>
using irr::core::vector3df;
int main() {
  irr::SIrrlichtCreationParameters made;
  made.DriverType = irr::video::EDT_NULL, made.WindowSize = {{width}, {height}}, made.LoggingLevel = irr::ELL_NONE;
  irr::scene::ISceneManager* scene = irr::createDeviceEx(made)->getSceneManager();
  auto* camera = scene->addCameraSceneNode(nullptr, vector3df({ex}, {ey}, {ez}), vector3df({ax}, {ay}, {az}));
  camera->setUpVector(vector3df({ux}, {uy}, {uz}));
  camera->setFOV(2 * std::atan(float({top}) / float({near})));
  camera->setAspectRatio({right} / {top});
  camera->setNearValue({near});
  camera->setFarValue(1000 * float({near}));
  camera->updateAbsolutePosition();
  camera->render();
  const auto line = scene->getSceneCollisionManager()->getRayFromScreenCoordinates({{width} - {i}, {j}}, camera);
  double distance;
  line.getIntersectionWithSphere(vector3df({cx}, {cy}, {cz}), {r}, distance) ? std::printf("%.17g\n", distance)
                                                                             : std::puts("miss");
}
