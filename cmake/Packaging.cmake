# The Debian package that CPack makes of what app/ and resources/ install. Included last.

# What is packed, and no tests: ./setup package builds this target.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
get_property(berg_compressed GLOBAL PROPERTY berg_compressed)
add_custom_target(packed DEPENDS bergwatch-cli ${berg_compressed})
if(BERGWATCH_WITH_CBC)
  add_dependencies(packed bergwatch-cbc)
endif()
if(BERGWATCH_BUILD_GUI)
  add_dependencies(packed bergwatch)
endif()

install(FILES README.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/bergwatch)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME bergwatch)
set(CPACK_PACKAGE_VENDOR "The Bergwatch developers")
set(CPACK_PACKAGE_CONTACT "${BERGWATCH_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
# The same modes whatever the umask of whoever builds.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS fonts-dejavu-core)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS gdal-bin) # files of GIS programs
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Bergwatch plans in which order an unmanned aircraft visits drifting icebergs,
flies the plan in simulation while the icebergs drift, measures how well their
positions are known, and exports plans to ground control stations.")
include(CPack)
