# `cpack` in the build directory makes Debian packages: libemtrX.Y with the libraries, libemtr-dev, and
# pcl-emtr with the command. Configure with -DCMAKE_INSTALL_PREFIX=/usr, which gives Debian's folders.
set(EMTR_MAINTAINER "the emtr authors <noreply@emtr.invalid>" CACHE STRING
  "Name <address> of who makes the Debian packages")
mark_as_advanced(EMTR_MAINTAINER)

set(emtr_soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT ${EMTR_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "global registration of two point clouds by EMTR-SSC")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/libemtr)

# emtr_package(component package section "description")
function(emtr_package component package section description)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  # Debian wants these two below the package's own name; a plain installation has no use for them.
  set(folder ${PROJECT_BINARY_DIR}/packages/${package})
  set(EMTR_PACKAGE ${package})
  string(TIMESTAMP EMTR_DATE "%a, %d %b %Y 00:00:00 +0000" UTC) # of SOURCE_DATE_EPOCH, if it is set
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/deb_changelog.in ${folder}/changelog @ONLY)
  file(READ ${PROJECT_SOURCE_DIR}/LICENSE EMTR_LICENSE)
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/deb_copyright.in ${folder}/copyright @ONLY)
  execute_process(COMMAND gzip -9nf ${folder}/changelog)
  install(FILES ${folder}/changelog.gz ${folder}/copyright DESTINATION share/doc/${package}
          COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

set(emtr_what "It aligns two point clouds that overlap only in part, from any pose and in
any unit, and reports when it could not.")
emtr_package(runtime libemtr${emtr_soversion} libs "${emtr_what} This package has the C
library and the class pcl::EMTRSSCRegistration for the Point Cloud Library.")
emtr_package(dev libemtr-dev libdevel "${emtr_what} This package has the
headers, and the files for find_package() of CMake and for pkg-config.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(emtr_triggers ${PROJECT_BINARY_DIR}/packages/triggers) # CPack writes none, and Debian wants one
file(WRITE ${emtr_triggers} "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${emtr_triggers})
set(CPACK_COMPONENT_DEV_DEPENDS runtime)
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS libpcl-dev) # the class needs it, the C library does not
if(EMTR_BUILD_TOOLS)
  emtr_package(command pcl-emtr science "${emtr_what} This package has the
command: it reads PCD, PLY and OBJ files, and writes the matrix, the aligned
cloud or a report.")
  set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
  set(CPACK_COMPONENT_COMMAND_DEPENDS runtime)
endif()
include(CPack)
