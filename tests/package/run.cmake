# Installs the build tree into an empty prefix, then configures, builds and runs the project beside
# this file against nothing but that prefix.
foreach(needed build consumer scratch generator compiler)
  if(NOT ${needed})
    message(FATAL_ERROR "give -D ${needed}=...")
  endif()
endforeach()

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${scratch})
run(${CMAKE_COMMAND} --install ${build} --prefix ${scratch}/prefix --config ${configuration})
run(${CMAKE_COMMAND} -S ${consumer} -B ${scratch}/build -G ${generator}
  -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_PREFIX_PATH=${scratch}/prefix
  -DCMAKE_BUILD_TYPE=${configuration})
run(${CMAKE_COMMAND} --build ${scratch}/build --config ${configuration})
find_program(consumer_program consumer PATHS ${scratch}/build ${scratch}/build/${configuration}
  NO_DEFAULT_PATH REQUIRED)
run(${consumer_program})
