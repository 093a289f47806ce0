# One test of ctest for each suite of a program, so that a suite's tests are one process and share what they prepare:
# cmake -DPROGRAM=path -DLABEL=unit [-DLONG=...] -DTO=file -P suites.cmake. The file is for TEST_INCLUDE_FILES. LONG, a regular
# expression of names, are of label `long`; so are suites that begin with Long, those that begin with Nightly of label
# `nightly`, and of label `hostile`, too, those of attacks
# and bad luck, which are called Hostile... (or LongHostile, Attacks, DegenerateSubmission).
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
# A suite begins its line and ends with a dot; a comment may follow.
string(REGEX MATCHALL "\n[A-Za-z0-9_/]+[.]" suites "${listed}")
set(tests "")
foreach(suite IN LISTS suites)
  string(STRIP "${suite}" suite)
  string(REGEX REPLACE "[.]$" "" suite "${suite}")
  set(labels ${LABEL})
  if(suite MATCHES "^Nightly")
    list(APPEND labels nightly)
  elseif(suite MATCHES "(^|/)(Long)?Hostile|^(Attacks|DegenerateSubmission)$")
    list(APPEND labels hostile long)
  elseif(suite MATCHES "(^|/)Long" OR (LONG AND suite MATCHES "^(${LONG})(/|$)"))
    list(APPEND labels long)
  endif()
  # These take long and share nothing: their parameters are distributed to four processes.
  set(shards 0)
  set(last 0)
  if(suite MATCHES "^(Degenerate|Files|Machines)/")
    set(shards 4)
    set(last 3)
  endif()
  foreach(shard RANGE ${last})
    set(name "${suite}")
    set(environment "")
    if(shards)
      math(EXPR number "${shard} + 1")
      set(name "${suite} ${number} of ${shards}")
      set(environment " ENVIRONMENT \"GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${shard}\"")
    endif()
    string(APPEND tests "add_test([==[${name}]==] bash ${CMAKE_CURRENT_LIST_DIR}/timed.sh ${PROGRAM} --gtest_filter=${suite}.*)\n"
      "set_tests_properties([==[${name}]==] PROPERTIES LABELS \"${labels}\"${environment})\n")
  endforeach()
endforeach()
file(WRITE ${TO} "${tests}")
