# Runs at installation: the setup files of the catkin install space, in the prefix that is installed to. Packages of /usr have
# none: what is there is found without.
if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  foreach(name _setup_util.py env.sh)
    file(INSTALL ${LAMINA_CATKIN_SETUP}/${name} DESTINATION ${CMAKE_INSTALL_PREFIX} USE_SOURCE_PERMISSIONS)
  endforeach()
  foreach(shell sh bash zsh)
    file(INSTALL ${LAMINA_CATKIN_SETUP}/setup.${shell} ${LAMINA_CATKIN_SETUP}/local_setup.${shell} DESTINATION ${CMAKE_INSTALL_PREFIX})
  endforeach()
  file(WRITE $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/.catkin "")
endif()
