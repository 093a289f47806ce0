# Defines the target raycheck::raycheck, the library; for each test framework that is installed, raycheck::gtest
# (with GoogleTest's main), raycheck::catch2 (with Catch2's main), raycheck::doctest and raycheck::rapidcheck;
# and with clang, raycheck::fuzz (with libFuzzer's main). COMPONENTS names those that a project needs:
# find_package(raycheck REQUIRED COMPONENTS gtest).
include("${CMAKE_CURRENT_LIST_DIR}/raycheckTargets.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/raycheckFrameworks.cmake")

foreach(component IN LISTS raycheck_FIND_COMPONENTS)
  set(raycheck_${component}_FOUND OFF)
  if(TARGET raycheck::${component})
    set(raycheck_${component}_FOUND ON)
  elseif(raycheck_FIND_REQUIRED_${component})
    set(raycheck_FOUND OFF)
    set(raycheck_NOT_FOUND_MESSAGE "raycheck::${component} needs a package that is not installed")
    if(component STREQUAL fuzz)
      set(raycheck_NOT_FOUND_MESSAGE
        "raycheck::fuzz needs clang, which has libFuzzer: -DCMAKE_CXX_COMPILER=clang++")
    endif()
  endif()
endforeach()
