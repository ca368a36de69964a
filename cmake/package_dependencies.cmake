# Read by cpack before it packs: what Debian packages the installed executables and libraries need. CPack's own way asks `file`
# for the kind of each of a thousand installed headers, twice as long as all else takes.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()

file(GLOB_RECURSE installed LIST_DIRECTORIES false
  "${CPACK_TEMPORARY_DIRECTORY}/usr/bin/*" "${CPACK_TEMPORARY_DIRECTORY}/usr/lib/*")
set(binaries)
foreach(file IN LISTS installed)
  file(READ "${file}" magic LIMIT 4 HEX)
  if(magic STREQUAL "7f454c46")  # of ELF
    list(APPEND binaries "${file}")
  endif()
endforeach()

# dpkg-shlibdeps wants a package's sources around it.
set(work "${CPACK_TOPLEVEL_DIRECTORY}/dependencies")
file(WRITE "${work}/debian/control" "")
list(TRANSFORM CPACK_LAMINA_OWN_LIBRARIES PREPEND -l OUTPUT_VARIABLE own_libraries)
execute_process(COMMAND dpkg-shlibdeps ${own_libraries} --ignore-missing-info -O ${binaries}
  WORKING_DIRECTORY "${work}" OUTPUT_VARIABLE found ERROR_VARIABLE reasons RESULT_VARIABLE failed
  OUTPUT_STRIP_TRAILING_WHITESPACE)
if(failed OR NOT found MATCHES "shlibs:Depends=(.+)")
  message(FATAL_ERROR "dpkg-shlibdeps finds no packages for ${work}: ${reasons}")
endif()
string(JOIN ", " CPACK_DEBIAN_PACKAGE_DEPENDS ${CMAKE_MATCH_1} ${CPACK_DEBIAN_PACKAGE_DEPENDS})
