# Instruments all that is compiled from here on, for EMTR_SANITIZE. Never part of what is installed: the
# binaries run under their sanitizer alone.
set_property(CACHE EMTR_SANITIZE PROPERTY STRINGS "" address thread)
if(NOT EMTR_SANITIZE MATCHES "^(address|thread)?$")
  message(FATAL_ERROR "EMTR_SANITIZE is '${EMTR_SANITIZE}', expected address, thread or nothing")
endif()
if(NOT EMTR_SANITIZE)
  return()
endif()
if(EMTR_BUILD_FUZZERS)
  if(NOT EMTR_SANITIZE STREQUAL "address")
    message(FATAL_ERROR "EMTR_BUILD_FUZZERS goes with EMTR_SANITIZE=address, or with none")
  endif()
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang" OR NOT CMAKE_C_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "EMTR_BUILD_FUZZERS with EMTR_SANITIZE needs Clang, whose libFuzzer drives "
                        "the targets; the compilers are ${CMAKE_C_COMPILER} and "
                        "${CMAKE_CXX_COMPILER}: set CMAKE_C_COMPILER=clang and "
                        "CMAKE_CXX_COMPILER=clang++")
  endif()
endif()

set(emtr_sanitizers ${EMTR_SANITIZE})
if(EMTR_SANITIZE STREQUAL "address")
  # Beyond the set `undefined`: numbers that do not fit where they are cast to. No check of division
  # by zero: it is defined in IEEE 754, and the engine counts on its infinities.
  set(emtr_sanitizers address,undefined,float-cast-overflow)
  # Eigen would take AddressSanitizer's malloc for an unaligned one, allocate in another way than
  # Debian's PCL, and each would free what the other made.
  add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()
add_compile_options(-fsanitize=${emtr_sanitizers} -fno-sanitize-recover=all
                    -fno-omit-frame-pointer -g1)
add_link_options(-fsanitize=${emtr_sanitizers})
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  # The programs in C need what the library in C++ was instrumented for.
  add_link_options(-fsanitize-link-c++-runtime)
  link_libraries($<$<LINK_LANGUAGE:C>:stdc++>)
endif()
if(EMTR_BUILD_FUZZERS)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
