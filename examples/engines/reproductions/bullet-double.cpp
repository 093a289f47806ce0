// g++ case.cpp -I/usr/include/bullet -DBT_USE_DOUBLE_PRECISION -lBulletCollision-float64 -lLinearMath-float64 -o case
#include <btBulletCollisionCommon.h>
#include <cstdio>
int main() {
  btVector3 from({ox}, {oy}, {oz}), to = from + 1024 * btVector3({dx}, {dy}, {dz});
  btQuaternion none = btQuaternion::getIdentity();
  btTransform placed(none, btVector3({cx}, {cy}, {cz}));
  btSphereShape ball({r});
  btCollisionObject object;
  btCollisionWorld::ClosestRayResultCallback closest(from, to);
  btCollisionWorld::rayTestSingle(btTransform(none, from), btTransform(none, to), &object, &ball,
                                  placed, closest);
  closest.hasHit() ? std::printf("%.17g\n", 1024.0 * closest.m_closestHitFraction)
                   : std::puts("miss");
}
