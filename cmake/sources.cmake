# Sources by folder, compiled in batches: the headers of Eigen, Boost and the standard library are parsed once a batch.
option(LAMINA_UNITY "Compile sources of a folder together, in batches" ON)
set(LAMINA_BATCH 10 CACHE STRING "Sources of a folder that are compiled together at most")
# Half of a batch's time goes to templates that others instantiate as well: a build of everything takes a third less, a build
# after one edit several times longer.
set(LAMINA_WIDE_BATCH 0 CACHE STRING "Sources of any folders that are compiled together at most; 0: of one folder only")

# lamina_batch_sources(target files...): files of one folder as sources of a target, in batches of their own
function(lamina_batch_sources target)
  target_sources(${target} PRIVATE ${ARGN})
  if(NOT LAMINA_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  if(LAMINA_WIDE_BATCH)
    foreach(file ${ARGN})
      get_filename_component(path ${file} ABSOLUTE)
      set_property(GLOBAL APPEND_STRING PROPERTY LAMINA_SOURCES_TO_BATCH "${target} ${path}\n")
    endforeach()
    return()
  endif()
  file(RELATIVE_PATH group ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR}/${ARGV1})
  string(MAKE_C_IDENTIFIER ${group} group)
  list(LENGTH ARGN count)
  math(EXPR batches "(${count} + ${LAMINA_BATCH} - 1) / ${LAMINA_BATCH}")
  set(taken 0)
  foreach(file ${ARGN})
    math(EXPR batch "${taken} * ${batches} / ${count}")
    math(EXPR taken "${taken} + 1")
    set_source_files_properties(${file} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group}_${batch})
  endforeach()
endfunction()

# lamina_form_wide_batches(): batches of all sources that were given until now, where they are wide
function(lamina_form_wide_batches)
  get_property(sources GLOBAL PROPERTY LAMINA_SOURCES_TO_BATCH)
  if(NOT sources)
    return()
  endif()
  file(WRITE ${PROJECT_BINARY_DIR}/sources_to_batch.txt "${sources}")
  execute_process(
    COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/wide_batches.py ${LAMINA_WIDE_BATCH} ${PROJECT_BINARY_DIR}/sources_to_batch.txt
    OUTPUT_VARIABLE batches RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "cmake/wide_batches.py ended with ${failed}; expected 0")
  endif()
  string(STRIP "${batches}" batches)
  string(REPLACE "\n" ";" batches "${batches}")
  foreach(line ${batches})
    string(REGEX MATCH "^([^ ]+) ([^ ]+) (.+)$" line "${line}")
    set_source_files_properties(${CMAKE_MATCH_3} TARGET_DIRECTORY ${CMAKE_MATCH_1} PROPERTIES UNITY_GROUP ${CMAKE_MATCH_2})
  endforeach()
endfunction()

# lamina_use_modules(target): what the core loads when a target runs is built before it
function(lamina_use_modules target)
  get_property(modules GLOBAL PROPERTY LAMINA_MODULES)
  add_dependencies(${target} ${modules})
endfunction()

# lamina_compile_as_front_end(target): what only calls the core, which does the work, has to compile fast
function(lamina_compile_as_front_end target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
