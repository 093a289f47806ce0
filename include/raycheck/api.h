#ifndef RAYCHECK_API_H_
#define RAYCHECK_API_H_

/// Marks the symbols that libraycheck exports. All others are hidden.
#define RAYCHECK_API __attribute__((visibility("default")))

#endif  // RAYCHECK_API_H_
