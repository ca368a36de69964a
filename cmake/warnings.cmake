# One interface target with the flags that all of Lamina's own targets use.
add_library(lamina_flags INTERFACE)
target_compile_options(lamina_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow)
# GCC takes the sources of a batch for headers, in which such fields would differ from source to source.
target_compile_options(lamina_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
if(LAMINA_WERROR)
  target_compile_options(lamina_flags INTERFACE -Werror)
endif()
if(LAMINA_SANITIZE)
  target_compile_options(lamina_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer)
  target_link_options(lamina_flags INTERFACE -fsanitize=address,undefined)
  # Under the sanitizer Eigen pads what it allocates; libraries that are built without it free the same memory plainly.
  target_compile_definitions(lamina_flags INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()
if(LAMINA_FUZZ)
  target_compile_options(lamina_flags INTERFACE -fsanitize=fuzzer-no-link,address,undefined)
  target_link_options(lamina_flags INTERFACE -fsanitize=address,undefined)
endif()
# GCC warns of members that may be uninitialised where the sanitizers' own code hides that they are not; the build without
# them has this warning.
if(LAMINA_SANITIZE)
  target_compile_options(lamina_flags INTERFACE -Wno-maybe-uninitialized)
endif()
if(LAMINA_THREADS)
  target_compile_options(lamina_flags INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(lamina_flags INTERFACE -fsanitize=thread)
endif()
