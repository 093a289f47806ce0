// A crash of dies.cpp in another file.

namespace elsewhere {

inline void divide(volatile int& number) {
  number = 2 / number;  // dies: in an inlined function of another file
}

}  // namespace elsewhere
