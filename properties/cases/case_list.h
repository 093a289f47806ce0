#ifndef RAYCHECK_PROPERTIES_CASES_CASE_LIST_H_
#define RAYCHECK_PROPERTIES_CASES_CASE_LIST_H_

// The sources of cases by subject, each defined in the file of that name. Internal to properties/.

#include "properties/cases/case_source.h"

namespace raycheck::properties {

extern const CaseSource kCourseSource;  // course_cases.cpp
extern const CaseSource kCourseBehindSource;

extern const CaseSource kCamerasSource;  // camera_cases.cpp
extern const CaseSource kPlainCamerasSource;
extern const CaseSource kCrowdsSource;
extern const CaseSource kFarCameraSource;
extern const CaseSource kCameraScaleSource;
extern const CaseSource kUpSource;

extern const CaseSource kFieldOfViewSource;  // pixel_cases.cpp
extern const CaseSource kImageSizeSource;
extern const CaseSource kNearPlaneSource;

extern const CaseSource kRaysSource;  // ray_cases.cpp
extern const CaseSource kTiesSource;
extern const CaseSource kDistanceSource;
extern const CaseSource kCoincidentSource;
extern const CaseSource kFarWorldSource;
extern const CaseSource kScaleSource;
extern const CaseSource kDirectionLengthSource;

extern const CaseSource kTangencySource;  // contact_cases.cpp
extern const CaseSource kTangentUlpsSource;
extern const CaseSource kSurfaceSource;
extern const CaseSource kInsideSource;
extern const CaseSource kHorizonSource;

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_CASES_CASE_LIST_H_
