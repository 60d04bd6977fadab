# Writes version.cpp at build time, since the commit may have changed after the build was configured.
# Expects the values of src/version.cpp.in, SOURCE_DIR, TEMPLATE and OUTPUT. Leaves an unchanged file alone,
# so nothing is compiled again without need.

set(git_commit unknown)
if(EXISTS "${SOURCE_DIR}/COMMIT")  # of an archive of the sources (./do package)
  file(STRINGS "${SOURCE_DIR}/COMMIT" git_commit LIMIT_COUNT 1)
endif()
find_program(git git)
if(git)
  # An unpacked tarball may lie inside another project's repository, whose commit would be the wrong one.
  execute_process(
    COMMAND "${git}" -C "${SOURCE_DIR}" rev-parse --show-toplevel
    OUTPUT_VARIABLE repository
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH "${SOURCE_DIR}" source_dir)
  if(repository STREQUAL source_dir)
    execute_process(
      COMMAND "${git}" -C "${SOURCE_DIR}" --no-optional-locks describe --always --dirty --abbrev=12 --exclude=*
      OUTPUT_VARIABLE description
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(description)
      set(git_commit "${description}")
    endif()
  endif()
endif()

string(STRIP "${compiler_flags}" compiler_flags)
string(REGEX REPLACE " +" " " compiler_flags "${compiler_flags}")
string(REGEX REPLACE "([\"\\\\])" "\\\\\\1" compiler_flags "${compiler_flags}")

configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
