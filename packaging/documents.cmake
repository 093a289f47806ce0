# cpack runs this file before it packs: it adds the licence and the changelog, which Debian requires in
# every package, and compresses man pages.
include(${CMAKE_CURRENT_LIST_DIR}/maintainer.cmake)

file(READ ${CPACK_RAYCHECK_SOURCE_DIR}/LICENSE licence)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]*)\n" _ "${licence}")
set(holder "${CMAKE_MATCH_1}")
string(REGEX REPLACE "^.*Copyright[^\n]*\n\n" "" licence "${licence}")
string(STRIP "${licence}" licence)
string(REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REPLACE "\n" "\n " licence "${licence}")

set(ENV{LC_ALL} C.UTF-8)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # from SOURCE_DATE_EPOCH if it is set

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(tree ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)
  set(documents ${tree}/share/doc/${package})
  file(WRITE ${documents}/copyright
    "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: raycheck
Comment: Code compiled in from the headers of other libraries is under their
 licences: CGAL (LGPL-3+), Boost, Eigen, nlohmann-json and CLI11.

Files: *
Copyright: ${holder}
License: Expat

License: Expat
 ${licence}
")
  file(WRITE ${documents}/changelog
    "raycheck (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * Release ${CPACK_PACKAGE_VERSION}; see CHANGELOG.md in the sources.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}
")
  file(GLOB texts ${documents}/changelog ${tree}/share/man/man1/*.1)
  execute_process(COMMAND gzip -9nf ${texts} COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# CPack calls ldconfig in scripts, although Debian's trigger (packaging/triggers) does it, too.
set(package ${CPACK_DEBIAN_LIBRARY_PACKAGE_NAME})
file(WRITE ${CPACK_TEMPORARY_DIRECTORY}/library/usr/share/lintian/overrides/${package}
  "${package}: maintscript-calls-ldconfig *\n")
