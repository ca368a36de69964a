# Tests only have to compile fast; what is tested is compiled as it is shipped. Clang without optimisation takes a third of GCC's
# time for them, whose templates of GoogleTest, RapidCheck and Eigen GCC instantiates as slowly whatever the level.
option(LAMINA_TESTS_BY_CLANG "Compile tests by clang where it is installed and GCC compiles the rest" ON)
find_program(LAMINA_CLANG clang++)
set(LAMINA_TEST_LAUNCHER)
# Sanitizers of two compilers do not mix.
if(LAMINA_TESTS_BY_CLANG AND LAMINA_CLANG AND CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT LAMINA_SANITIZE AND NOT LAMINA_THREADS)
  set(LAMINA_TEST_LAUNCHER ${PROJECT_SOURCE_DIR}/cmake/compile-by-clang ${LAMINA_CLANG} ${CMAKE_CXX_COMPILER})
endif()

# lamina_compile_fast(target): a test's sources take little time to compile, whatever time they take to run
function(lamina_compile_fast target)
  if(LAMINA_TEST_LAUNCHER)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "${LAMINA_TEST_LAUNCHER};${CMAKE_CXX_COMPILER_LAUNCHER}")
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0>)
  else()
    # Of Boost's functions the warning is false.
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1> $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()
endfunction()
