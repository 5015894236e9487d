# Counters in what is measured, and not in the tests, which would take much longer; those of several
# threads must not get lost. Whatever links the objects needs gcov's runtime.
foreach(target emtr_objects emtr_pcl emtr_command)
  if(TARGET ${target})
    target_compile_options(${target} PRIVATE --coverage -fprofile-update=atomic)
  endif()
endforeach()
foreach(target emtr emtr_pcl emtr_command)
  if(TARGET ${target})
    target_link_options(${target} PRIVATE --coverage)
  endif()
endforeach()
add_link_options(--coverage) # of the targets that come after
