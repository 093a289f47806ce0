#ifndef RAYCHECK_TESTS_SUBMISSIONS_BY_NAME_H_
#define RAYCHECK_TESTS_SUBMISSIONS_BY_NAME_H_

// For submissions that are built once with all of their mistakes: the name of the built file,
// "far_root.so" or "far_root.rt", selects one.

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#define TEXT_OF_NAMES(...) #__VA_ARGS__
/// The index of this file's name in a list of names (none, far_root, ...).
#define PLACE_BY_NAME(...) place_by_name(TEXT_OF_NAMES(__VA_ARGS__))

inline long place_by_name(const std::string& list) {
  Dl_info file;
  if (dladdr(reinterpret_cast<const void*>(&place_by_name), &file) == 0) std::abort();
  const std::string path = file.dli_fname;
  const std::size_t begin = path.rfind('/') + 1;
  const std::string name = path.substr(begin, path.find('.', begin) - begin);
  const std::size_t at = (" " + list + ",").find(" " + name + ",");
  if (at == std::string::npos) std::abort();
  return std::count(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(at), ',');
}

#endif  // RAYCHECK_TESTS_SUBMISSIONS_BY_NAME_H_
