vcpkg_download_distfile(ARCHIVE
  URLS "@URL@"
  FILENAME "@ARCHIVE@"
  SHA512 @SHA512@)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")

vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS FEATURES tools EMTR_BUILD_TOOLS)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS ${FEATURE_OPTIONS})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/emtr)
vcpkg_fixup_pkgconfig()
if("tools" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES pcl_emtr AUTO_CLEAN)
  file(GLOB modules "${CURRENT_PACKAGES_DIR}/lib/pcl_emtr/*")
  if(modules)
    file(INSTALL ${modules} DESTINATION "${CURRENT_PACKAGES_DIR}/tools/emtr")
  endif()
  file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib/pcl_emtr"
                      "${CURRENT_PACKAGES_DIR}/debug/lib/pcl_emtr")
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/emtr")
