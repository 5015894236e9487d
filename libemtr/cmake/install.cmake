# Installs the libraries, their headers, and the files for find_package() and pkg-config. All paths
# in those files are relative, so that the prefix may be moved.
include(CMakePackageConfigHelpers)

set(emtr_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/emtr)
set(emtr_pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
# The parts of PCL that a static build links with.
set(emtr_pcl_components common kdtree) # kdtree brings FLANN

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT license)

# ---- the C library
install(TARGETS emtr EXPORT emtrTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT dev
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
install(DIRECTORY include/emtr DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
install(EXPORT emtrTargets NAMESPACE emtr:: DESTINATION ${emtr_package_dir} COMPONENT dev)

# ---- the class
if(TARGET emtr_pcl)
  if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr") # the linker finds libemtr there by itself
    set_target_properties(emtr_pcl PROPERTIES INSTALL_RPATH $ORIGIN) # libemtr lies next to it
  endif()
  install(TARGETS emtr_pcl EXPORT emtrPclTargets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT dev
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
  install(DIRECTORY include/pcl ${EMTR_GENERATED_INCLUDE_DIR}/pcl
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
  install(EXPORT emtrPclTargets NAMESPACE emtr:: DESTINATION ${emtr_package_dir} COMPONENT dev)
endif()

# ---- find_package(emtr)
configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/emtrConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/emtrConfig.cmake
  INSTALL_DESTINATION ${emtr_package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/emtrConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/emtrConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/emtrConfigVersion.cmake
        DESTINATION ${emtr_package_dir} COMPONENT dev)

# ---- pkg-config
file(RELATIVE_PATH emtr_pc_prefix /prefix/${emtr_pkgconfig_dir} /prefix)
string(REGEX REPLACE "/$" "" emtr_pc_prefix "${emtr_pc_prefix}")
set(emtr_pc_static)
if(NOT BUILD_SHARED_LIBS)
  set(emtr_pc_parts ${emtr_pcl_components})
  list(TRANSFORM emtr_pc_parts PREPEND pcl_)
  list(JOIN emtr_pc_parts " " emtr_pc_parts)
  set(emtr_pc_libraries stdc++ ${OpenMP_CXX_LIB_NAMES})
  list(TRANSFORM emtr_pc_libraries PREPEND -l)
  list(JOIN emtr_pc_libraries " " emtr_pc_libraries)
  set(emtr_pc_static "Requires.private: ${emtr_pc_parts}\nLibs.private: ${emtr_pc_libraries}\n")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/emtr.pc.in ${CMAKE_CURRENT_BINARY_DIR}/emtr.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/emtr.pc DESTINATION ${emtr_pkgconfig_dir} COMPONENT dev)
if(TARGET emtr_pcl)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/pcl_emtr.pc.in
                 ${CMAKE_CURRENT_BINARY_DIR}/pcl_emtr.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/pcl_emtr.pc DESTINATION ${emtr_pkgconfig_dir} COMPONENT dev)
endif()
