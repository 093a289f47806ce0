// Bullet's btCollisionWorld::rayTestSingle on a btSphereShape (in floats; bullet-double.cpp: in
// doubles, by -DBT_USE_DOUBLE_PRECISION): the closest hit, as a fraction of a segment. Debian:
// libbullet-dev; -lBulletCollision -lLinearMath. Source:
// BulletCollision/CollisionDispatch/btCollisionWorld.h. Silent on segments that start inside (the
// code returns no hit for them, and the adapter declares this), on tangents, and on its error; its
// manual calls ray tests against convex shapes iterative.

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#ifndef BT_USE_DOUBLE_PRECISION
#define SINGLE
#endif
#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const auto from = to<btVector3, btScalar>(ray.origin);
  const auto end = from + to<btVector3, btScalar>(ray.direction) * btScalar(kEnd);
  const btQuaternion none = btQuaternion::getIdentity();
  btSphereShape ball(static_cast<btScalar>(sphere.radius));
  btCollisionObject object;
  const btTransform placed(none, to<btVector3, btScalar>(sphere.centre));
  btCollisionWorld::ClosestRayResultCallback closest(from, end);
  btCollisionWorld::rayTestSingle(btTransform(none, from), btTransform(none, end), &object, &ball,
                                  placed, closest);
  if (!closest.hasHit()) return std::nullopt;
  return Hit{kEnd * closest.m_closestHitFraction, {}};
}

RAYCHECK_CANDIDATE(.root = Root::smaller, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = 0x1p-10, .largest_length = 0x1p10,
                   .precision = kPrecision, .roots = Roots::declared, .valid = kSegment,
                   .returns = Returns::parameter)
