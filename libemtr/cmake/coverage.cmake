# Instruments what is measured: the library and the command. Of the tests only those of the class,
# whose headers are compiled into them; instrumenting all tests would take much longer.
foreach(target emtr_objects emtr_pcl emtr_command test_pcl_class)
  if(TARGET ${target})
    target_compile_options(${target} PRIVATE --coverage)
  endif()
endforeach()
