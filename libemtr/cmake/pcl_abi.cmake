# Writes pcl/registration/emtr_ssc_abi.h: how Eigen aligns and allocates under the flags of this
# build. The class compares them with the flags of a program before it uses the compiled code.

set(emtr_probe ${CMAKE_CURRENT_BINARY_DIR}/emtr_abi_probe)
set(CMAKE_TRY_COMPILE_CONFIGURATION ${CMAKE_BUILD_TYPE}) # with the flags of that type
try_compile(emtr_probe_compiled ${CMAKE_CURRENT_BINARY_DIR}
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/abi_probe.cpp
  LINK_LIBRARIES pcl_common
  CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON
  OUTPUT_VARIABLE emtr_probe_output
  COPY_FILE ${emtr_probe})
unset(CMAKE_TRY_COMPILE_CONFIGURATION)
if(NOT emtr_probe_compiled)
  message(FATAL_ERROR "A program that includes PCL and Eigen does not compile:\n${emtr_probe_output}")
endif()

file(STRINGS ${emtr_probe} emtr_probe_text REGEX "emtr_ssc_abi ")
foreach(name PCL_MAJOR PCL_MINOR MAX_ALIGN MALLOC_ALIGNED OVERALIGN)
  if(NOT emtr_probe_text MATCHES "emtr_ssc_abi ${name}=([0-9]+)")
    message(FATAL_ERROR "The compiled probe does not tell ${name}: ${emtr_probe_text}")
  endif()
  set(EMTR_SSC_ABI_${name} ${CMAKE_MATCH_1})
endforeach()

set(EMTR_GENERATED_INCLUDE_DIR ${CMAKE_CURRENT_BINARY_DIR}/include)
configure_file(${CMAKE_CURRENT_LIST_DIR}/emtr_ssc_abi.h.in
               ${EMTR_GENERATED_INCLUDE_DIR}/pcl/registration/emtr_ssc_abi.h @ONLY)
