#ifndef RAYCHECK_API_H_
#define RAYCHECK_API_H_

/// What libraycheck lets others see; all else of it is hidden.
#define RAYCHECK_API __attribute__((visibility("default")))

#endif  // RAYCHECK_API_H_
