# Builds libpcl_emtr, which instantiates pcl::EMTRSSCRegistration for PCL's usual point types.
if(NOT EMTR_BUILD_PCL)
  return()
endif()

include(${CMAKE_CURRENT_LIST_DIR}/pcl_abi.cmake)

add_library(emtr_pcl src/pcl/emtr_ssc.cpp)
add_library(emtr::pcl ALIAS emtr_pcl)
set_target_properties(emtr_pcl PROPERTIES
  OUTPUT_NAME pcl_emtr
  EXPORT_NAME pcl
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} # 0.x versions promise no common ABI
  POSITION_INDEPENDENT_CODE ON
  CXX_VISIBILITY_PRESET hidden
  VISIBILITY_INLINES_HIDDEN ON)
target_include_directories(emtr_pcl PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
  $<BUILD_INTERFACE:${EMTR_GENERATED_INCLUDE_DIR}>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(emtr_pcl INTERFACE cxx_std_14)
# PCL's component registration is not linked: the class uses only its templates, and the component
# would bring VTK and Qt into every configure step.
target_link_libraries(emtr_pcl PUBLIC emtr pcl_search pcl_kdtree pcl_common
                               PRIVATE $<BUILD_INTERFACE:emtr_build>)

# FLANN's headers call LZ4 in a program that instantiates the class itself, and neither FLANN's nor
# PCL's target says so.
find_path(EMTR_FLANN_INCLUDE_DIR flann/util/serialization.h HINTS ${FLANN_INCLUDE_DIRS})
mark_as_advanced(EMTR_FLANN_INCLUDE_DIR)
if(EMTR_FLANN_INCLUDE_DIR)
  file(STRINGS ${EMTR_FLANN_INCLUDE_DIR}/flann/util/serialization.h emtr_flann_text REGEX "lz4")
  if(emtr_flann_text)
    target_link_libraries(emtr_pcl INTERFACE lz4)
  endif()
endif()
