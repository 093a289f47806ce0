#pragma once

// The sources of cases by subject, each defined in the file of that name. Internal to the cases.

#include <span>

#include "properties/cases/case_source.h"

namespace raycheck::properties {

extern const std::span<const CaseSource> kCourseSources;   // course_cases.cpp
extern const std::span<const CaseSource> kCameraSources;   // camera_cases.cpp
extern const std::span<const CaseSource> kPixelSources;    // pixel_cases.cpp
extern const std::span<const CaseSource> kRaySources;      // ray_cases.cpp
extern const std::span<const CaseSource> kContactSources;  // contact_cases.cpp

}  // namespace raycheck::properties
