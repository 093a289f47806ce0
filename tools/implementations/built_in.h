#pragma once

#include <string>
#include <vector>

#include "tools/implementations/implementation.h"

namespace raycheck::tools {

/// The method of this name; throws std::invalid_argument naming the field and the known names.
const fast::PixelRayMethod& find_rays(const std::string& name, const char* field = "rays");
const fast::IntersectMethod& find_intersect(const std::string& name,
                                            const char* field = "intersect");

/// The pair named "RAYS/INTERSECT", or "INTERSECT" with the default ray method. Throws
/// std::invalid_argument like find_rays(), naming the field "bounds".
MethodPair find_pair(const std::string& name);

/// Every intersection method: those of fast/, then the exact methods.
std::vector<const fast::IntersectMethod*> all_intersect_methods();

properties::Candidate candidate_of(const MethodPair& pair);

Implementation built_in(const MethodPair& pair);
std::vector<Implementation> built_in(const std::vector<MethodPair>& pairs);

/// The ray and intersection methods with these names; "rays/NAME" and "intersect/NAME" name only
/// one kind, and "all" means every method. Without names: all methods of fast/. Throws
/// std::invalid_argument naming the field and the known names.
std::vector<Implementation> find_methods(const std::vector<std::string>& names);

/// Every pair, in the order of reports.
std::vector<MethodPair> all_pairs();
/// Each method once, paired with the default method of the other kind.
std::vector<MethodPair> each_method_once();

}  // namespace raycheck::tools
