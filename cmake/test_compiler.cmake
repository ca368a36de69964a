# Tests only have to compile fast; what is tested is compiled as it is shipped. Clang without optimisation takes a third of GCC's
# time for them, whose templates of GoogleTest, RapidCheck and Eigen GCC instantiates as slowly whatever the level.
option(LAMINA_TESTS_BY_CLANG "Compile tests by clang where it is installed and GCC compiles the rest" ON)
find_program(LAMINA_CLANG clang++)

# lamina_try_clang(): LAMINA_CLANG_WORKS, whether GCC links what clang compiles with the headers that it finds
function(lamina_try_clang)
  set(folder ${PROJECT_BINARY_DIR}/test/clang)
  file(WRITE ${folder}/tried.cpp
    "#include <filesystem>\n#include <string>\nint main() { return std::filesystem::path(std::string(1, 'a')).empty(); }\n")
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS}")
  execute_process(
    COMMAND ${LAMINA_CLANG} ${flags} -std=c++17 -Xclang -fno-pch-timestamp -c tried.cpp -o tried.o
    WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(NOT failed)
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${flags} tried.o -o tried
      WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  endif()
  if(failed)
    set(LAMINA_CLANG_WORKS OFF CACHE INTERNAL "")
  else()
    set(LAMINA_CLANG_WORKS ON CACHE INTERNAL "")
  endif()
endfunction()

set(LAMINA_TEST_LAUNCHER)
# Sanitizers, coverage and link-time optimisation of two compilers do not mix.
if(LAMINA_TESTS_BY_CLANG AND LAMINA_CLANG AND CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT CMAKE_CROSSCOMPILING
   AND NOT LAMINA_SANITIZE AND NOT LAMINA_THREADS AND NOT CMAKE_CXX_FLAGS MATCHES "-flto|--coverage|-fsanitize|-fprofile")
  lamina_try_clang()
  if(LAMINA_CLANG_WORKS)
    set(LAMINA_TEST_LAUNCHER ${PROJECT_SOURCE_DIR}/cmake/compile-by-clang ${LAMINA_CLANG} ${CMAKE_CXX_COMPILER})
  else()
    message(STATUS "tests by ${CMAKE_CXX_COMPILER}: what ${LAMINA_CLANG} compiles does not link with it")
  endif()
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
