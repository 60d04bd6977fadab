# Installs the build to an empty prefix, then configures, builds and runs the consumer against it.

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
set(prefix "${WORK_DIR}/prefix")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")
run("${CMAKE_COMMAND}" -S "${CONSUMER_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
    "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}"
    "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}")
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build")
run("${WORK_DIR}/build/consumer")

# The installed command finds the installed cards, examples and parts, wherever the prefix lies.
if(EXISTS "${prefix}/bin/dashpad")
  run("${CMAKE_COMMAND}" -E env --unset=DASHPAD_MATERIALS "${prefix}/bin/dashpad" run
      "${prefix}/share/dashpad/examples/dashboard-20mph.toml" --png "${WORK_DIR}/picture.png")
endif()
