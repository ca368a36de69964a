# Runs at installation: the setup files of the catkin install space, in the prefix that is installed to. Packages of /usr have
# none: what is there is found without.
if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  # catkin writes the first only to the devel space; it is the same for any space.
  foreach(file ${LAMINA_DEVEL_SPACE}/_setup_util.py ${LAMINA_CATKIN_SETUP}/env.sh)
    file(INSTALL ${file} DESTINATION ${CMAKE_INSTALL_PREFIX} USE_SOURCE_PERMISSIONS)
  endforeach()
  foreach(shell sh bash zsh)
    file(INSTALL ${LAMINA_CATKIN_SETUP}/setup.${shell} ${LAMINA_CATKIN_SETUP}/local_setup.${shell} DESTINATION ${CMAKE_INSTALL_PREFIX})
  endforeach()
  file(INSTALL ${LAMINA_DEVEL_SPACE}/etc/catkin/profile.d/50.lamina_loopback.sh DESTINATION ${CMAKE_INSTALL_PREFIX}/etc/catkin/profile.d)
  file(WRITE $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/.catkin "")
endif()
