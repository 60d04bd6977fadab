# For Windows, the targets that find_package() and pkg_check_modules() give elsewhere: Debian has no libraries for
# it, but headers are those of any system. They are reached through a folder of links, since /usr/include has the C
# library of Linux. windows/ has what stands in the place of some libraries, left_out() names what needs the others.

set(windows "${PROJECT_SOURCE_DIR}/windows")
set(header_links "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${header_links}")
foreach(name IN ITEMS boost CLI eigen3/Eigen fmt hwy nlohmann Random123 toml++)
  if(NOT EXISTS "/usr/include/${name}")
    message(FATAL_ERROR "/usr/include/${name} is missing: ./do install-packages windows")
  endif()
  cmake_path(GET name FILENAME link)
  file(CREATE_LINK "/usr/include/${name}" "${header_links}/${link}" SYMBOLIC)
endforeach()
set(TOMLPLUSPLUS_INCLUDE_DIR "${header_links}")
set(RANDOM123_INCLUDE_DIR "${header_links}")
set(HWY_INCLUDE_DIR "${header_links}")

foreach(target IN ITEMS Boost::headers CLI11::CLI11 Eigen3::Eigen LibArchive::LibArchive PkgConfig::LIBRSVG
                        SQLite::SQLite3 TBB::tbb fmt::fmt nlohmann_json::nlohmann_json)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE "${header_links}")
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)

# For every source. Strict C hides names of POSIX; sizes of files have 64 bits; an object may have many sections. GCC
# aligns the stack of Windows to 16 bytes only, but moves vectors of AVX as if it were 32 (its bug 54412): the
# assembler replaces such moves.
set(CMAKE_CXX_EXTENSIONS ON)
add_compile_definitions(_FILE_OFFSET_BITS=64 _USE_MATH_DEFINES __USE_MINGW_ANSI_STDIO=1)
add_compile_options("$<$<COMPILE_LANGUAGE:C,CXX>:SHELL:-Wa,-mbig-obj,-muse-unaligned-vector-move>")
include_directories(BEFORE SYSTEM "${windows}/include")

# left_out(VARIABLE): removes from a list of sources those that need SQLite, libarchive, librsvg or POSIX.
function(left_out variable)
  list(
    FILTER ${variable} EXCLUDE
    REGEX "study/(answers_of_store|ranking|run_study|sqlite|store|store_.*|stored_.*|turning_level).cpp$")
  list(FILTER ${variable} EXCLUDE REGEX "iso_mme/(archive|folder).cpp$|deck/zip_writer.cpp$|svg/rendered.cpp$")
  list(FILTER ${variable} EXCLUDE REGEX "app/(study|parts|mpi)/|app/system.cpp$")
  set(${variable} "${${variable}}" PARENT_SCOPE)
endfunction()
