# How programs and the core are linked.
include(CheckLinkerFlag)

# Names are looked up as a program starts, so that their tables may go out of memory then; and one line of what the loader has
# to move stands for many pointers.
set(LAMINA_EARLY_BINDING)
check_linker_flag(CXX -Wl,-z,now,-z,pack-relative-relocs LAMINA_LINKER_BINDS_EARLY)
if(LAMINA_LINKER_BINDS_EARLY)
  set(LAMINA_EARLY_BINDING -Wl,-z,now,-z,pack-relative-relocs)
endif()

# Debian's default linker takes four times as long for what is linked to many libraries.
check_linker_flag(CXX -fuse-ld=gold LAMINA_LINKS_FAST)

# lamina_link_fast(target): tests and benchmarks, of which there are many
function(lamina_link_fast target)
  if(LAMINA_LINKS_FAST)
    target_link_options(${target} PRIVATE -fuse-ld=gold)
  endif()
endfunction()

# A page that is touched brings fifteen others with it. Without the order the same objects are linked (tools/order-functions).
option(LAMINA_ORDERED "Put what slicing runs side by side in memory" ON)
set(LAMINA_SLICING_FUNCTIONS ${PROJECT_SOURCE_DIR}/cmake/slicing_functions.ld)
check_linker_flag(CXX -Wl,-T,${LAMINA_SLICING_FUNCTIONS} LAMINA_LINKER_ORDERS)

# lamina_order_functions(target): functions that slicing runs stand side by side in a target
function(lamina_order_functions target)
  if(NOT LAMINA_LINKER_ORDERS)
    return()
  endif()
  target_compile_options(${target} PRIVATE -ffunction-sections)
  get_target_property(type ${target} TYPE)
  if(LAMINA_ORDERED AND NOT type STREQUAL STATIC_LIBRARY)
    target_link_options(${target} PRIVATE -Wl,-T,${LAMINA_SLICING_FUNCTIONS})
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${LAMINA_SLICING_FUNCTIONS})
  endif()
endfunction()
