# Installs the build to an empty prefix, then configures, builds and runs the consumer against all of it,
# and against the engine alone.

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
set(prefix "${WORK_DIR}/prefix")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")
foreach(engine_alone OFF ON)
  set(build "${WORK_DIR}/build-${engine_alone}")
  run("${CMAKE_COMMAND}" -S "${CONSUMER_DIR}" -B "${build}" -G "${GENERATOR}" "-DENGINE_ALONE=${engine_alone}"
      "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}"
      "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}")
  run("${CMAKE_COMMAND}" --build "${build}")
  run("${build}/consumer")
endforeach()

# The installed samples are a project, too; that each of them prints what it says is tested elsewhere.
set(data "${prefix}/share/dashpad")
set(build "${WORK_DIR}/build-samples")
run("${CMAKE_COMMAND}" -S "${data}/examples/cpp" -B "${build}" -G "${GENERATOR}" "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}")
run("${CMAKE_COMMAND}" --build "${build}" --target first_impact)
run("${build}/first_impact" "${data}")

# The installed command finds the installed cards, examples and parts, wherever the prefix lies.
if(EXISTS "${prefix}/bin/dashpad")
  run("${CMAKE_COMMAND}" -E env --unset=DASHPAD_MATERIALS "${prefix}/bin/dashpad" run
      "${prefix}/share/dashpad/examples/dashboard-20mph.toml" --png "${WORK_DIR}/picture.png")
endif()
