# Counters in what is measured, and not in all tests, which would take much longer: the class's headers
# are also compiled into its tests.
foreach(target emtr_objects emtr_pcl emtr_command test_pcl_class)
  if(TARGET ${target})
    target_compile_options(${target} PRIVATE --coverage)
  endif()
endforeach()
