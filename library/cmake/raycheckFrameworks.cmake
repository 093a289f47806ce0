# The targets raycheck::gtest, raycheck::catch2, raycheck::doctest and raycheck::rapidcheck, for
# each test framework that is installed.
function(raycheck_framework name package)
  if(TARGET raycheck::${name})
    return()
  endif()
  find_package(${package} QUIET)
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      add_library(raycheck::${name} INTERFACE IMPORTED GLOBAL)
      target_link_libraries(raycheck::${name} INTERFACE raycheck::raycheck ${target})
      return()
    endif()
  endforeach()
endfunction()

raycheck_framework(gtest GTest GTest::gtest_main)
raycheck_framework(catch2 Catch2 Catch2::Catch2WithMain)
raycheck_framework(doctest doctest doctest::doctest)
raycheck_framework(rapidcheck rapidcheck rapidcheck)

# libFuzzer comes with clang.
if(CMAKE_CXX_COMPILER_ID MATCHES Clang AND NOT TARGET raycheck::fuzz)
  add_library(raycheck::fuzz INTERFACE IMPORTED GLOBAL)
  target_link_libraries(raycheck::fuzz INTERFACE raycheck::raycheck)
  target_compile_options(raycheck::fuzz INTERFACE -fsanitize=fuzzer)
  target_link_options(raycheck::fuzz INTERFACE -fsanitize=fuzzer)
endif()
