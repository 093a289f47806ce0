# Bundles the page's modules into one script: cmake -DFROM=folder -DTO=file.js -P bundle.cmake
#
# Starts at FROM/main.js and puts every module after those that it imports. An import is one line,
# `import { names } from "./module.js";`, and is left out, as is the word `export` at a line's
# start: the modules share one function, and no two may declare the same name.
cmake_minimum_required(VERSION 3.25)

set(bundle "")
set(done "")
set(names "")

function(add_module name path)
  if(name IN_LIST done)
    return()
  endif()
  if(name IN_LIST path)
    message(FATAL_ERROR "${FROM}/${name}.js imports itself by way of ${path}")
  endif()
  file(READ "${FROM}/${name}.js" text)
  string(REGEX MATCHALL "\nimport [^\n]*from \"\\./[a-z_]+\\.js\"" imports "\n${text}")
  foreach(import IN LISTS imports)
    string(REGEX REPLACE ".*\"\\./([a-z_]+)\\.js\"" "\\1" imported "${import}")
    add_module("${imported}" "${path};${name}")
  endforeach()
  string(REGEX REPLACE "\nimport [^\n]*" "" text "\n${text}")
  string(REGEX REPLACE "\nexport " "\n" text "${text}")
  string(REGEX MATCHALL "\n(async )?(function|const|let|class) [A-Za-z0-9_]+" found "${text}")
  foreach(declaration IN LISTS found)
    string(REGEX REPLACE ".* " "" declared "${declaration}")
    if(declared IN_LIST names)
      message(FATAL_ERROR "${FROM}/${name}.js declares ${declared}, as another module does")
    endif()
    list(APPEND names "${declared}")
  endforeach()
  if(text MATCHES "</script|<!--")
    message(FATAL_ERROR "${FROM}/${name}.js would end the script element that it is put into")
  endif()
  set(names "${names}" PARENT_SCOPE)
  set(done "${done};${name}" PARENT_SCOPE)
  set(bundle "${bundle}${text}" PARENT_SCOPE)
endfunction()

add_module(main "")
file(WRITE "${TO}" "(function () {\n\"use strict\";\n${bundle}})();\n")
