// g++ case.cpp -lembree3 -o case
#include <embree3/rtcore.h>
#include <cmath>
#include <cstdio>
int main() {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* v = (float*)rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                            16, 1);
  v[0] = {cx}, v[1] = {cy}, v[2] = {cz}, v[3] = {r};
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay query = {{ox}, {oy}, {oz}, 0, {dx}, {dy}, {dz}, 0, INFINITY, ~0u};
  rtcOccluded1(scene, &context, &query);
  std::puts(query.tfar == -INFINITY ? "hit" : "miss");
}
