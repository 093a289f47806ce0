#pragma once

// Every method of fast/, in the order of reports. The method's file in fast/methods/ describes it
// and names its source. Internal to fast/.

/// METHOD(Name): fast::kName in intersect_name.cpp.
#define RAYCHECK_INTERSECT_METHODS(METHOD) \
  METHOD(Quadratic)                        \
  METHOD(Lecture)                          \
  METHOD(StableQuadratic)                  \
  METHOD(Kahan)                            \
  METHOD(Perpendicular)                    \
  METHOD(Cross)                            \
  METHOD(Cross2)                           \
  METHOD(SingleQuadratic)                  \
  METHOD(SingleLecture)                    \
  METHOD(DoubleDouble)                     \
  METHOD(LongDouble)                       \
  METHOD(Float128)                         \
  METHOD(Robust)

/// METHOD(Name): fast::kNameRays in pixel_ray_name.cpp.
#define RAYCHECK_PIXEL_RAY_METHODS(METHOD) \
  METHOD(Lecture)                          \
  METHOD(Direct)                           \
  METHOD(Focal)                            \
  METHOD(Incremental)                      \
  METHOD(Single)
