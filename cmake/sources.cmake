# Sources by folder, compiled in batches: the headers of Eigen, Boost and the standard library are parsed once a batch.
option(LAMINA_UNITY "Compile sources of a folder together, in batches" ON)
set(LAMINA_BATCH 12 CACHE STRING "Sources that are compiled together at most")

# lamina_batch_sources(target files...): files of one folder as sources of a target, in batches of their own
function(lamina_batch_sources target)
  target_sources(${target} PRIVATE ${ARGN})
  if(NOT LAMINA_UNITY)
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
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
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
