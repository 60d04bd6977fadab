#!/usr/bin/env bash
# The tasks of this project. ./do help lists them.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
log="$root/build/do.log"
jobs="$(nproc)"

help() {
  cat <<'TEXT'
Usage: ./do TASK [arguments]

  run [CASE] [arguments]   build the command and solve CASE (default: examples/helmet-pad-10fps.toml)
  test [PRESET] [ctest arguments]
                           build and run the tests (default: release; also dev, asan-ubsan, coverage)
  bench [--record]         build and run the benchmarks; results, plots and a page go to build/bench (--record also
                           writes two tables to bench/results and updates those in bench/README.md)
  bench PROGRAM [arguments]
                           run only impact, injury, work-precision, study or report, with its own arguments
  bench rows [COMMIT]      the time of a row of a study by kind of case, if wanted beside that of another commit
  bench --check            check that the tables in bench/README.md match bench/results
  pictures                 redraw the pictures in README and docs, except those that were drawn by hand
  docs                     make the site of the documents in build/site, with all examples and the C++ API, and check
                           its links
  format                   format the C++ code with clang-format
  check-layout             check the format of the code with clang-format, and the scripts with shellcheck
  lint                     run check-layout, clang-tidy and cppcheck, and compile everything with clang 14, warnings as
                           errors; changes nothing
  coverage                 run the tests and report the lines that they cover
  fuzz [TARGET] [SECONDS]  fuzz the file readers, each for SECONDS (default: 300), or only TARGET
                           (tests/fuzz/fuzz_TARGET.cpp); failing inputs go to build/fuzz/findings
  wasm                     compile the engine for WebAssembly: build/wasm/engine.wasm.lzma, which explore puts into pages
  npm                      pack the engine, its module and its command for npm: build/npm/dashpad-VERSION.tgz
  wheel                    make the package for Python 3 and try it: build/wheel/dashpad-VERSION-py3-none-linux_x86_64.whl
  notebooks [--record]     run the notebooks in examples/notebooks; pages go to build/notebooks (--record also keeps
                           their pictures in docs/images/notebooks)
  package                  make a Debian package, an archive for any newer Linux, the sources, the wheel and the command for
                           Windows in build/package, and try those for Linux in minimal systems (as root)
  windows                  build the command for Windows with mingw-w64 and try it under wine:
                           build/windows/dashpad-VERSION-windows-x86_64.zip
  nightly                  run the tests that take hours: fits to 60 synthetic mats of known parameters, 21,000 random
                           cases compared with more accurate solutions and 200 with a second solver, the site,
                           WebAssembly, Windows, notebooks, the tests by clang 19 under sanitizers, half a minute of fuzzing
                           for each reader, and lint
  clean                    remove build/
  install-packages [GROUP...]
                           install the Debian packages in packages.txt (default: all groups)

A task first installs any missing packages that it needs. The output of a build goes to build/do.log and is
shown if the build fails.
TEXT
}

say() { printf '%s\n' "$*" >&2; }
fail() {
  say "do: $*"
  exit 1
}

# --- Packages ---

# Names of the packages in the given groups of packages.txt; of all groups without arguments.
packages_of() {
  awk -v wanted=" $* " '
    /^# [a-z]+:/ { group = substr($2, 1, length($2) - 1) }
    /^[^#]/ && NF && (wanted ~ /^ *$/ || index(wanted, " " group " ")) { print $1 }
  ' "$root/packages.txt" | sort -u
}

# Installed, or provided by an installed package (other builds of nodejs than Debian's bring npm with them).
is_installed() {
  [[ "$(dpkg-query -W -f='${Status}' "$1" 2>/dev/null)" == "install ok installed" ]] ||
    dpkg-query -W -f='${db:Status-Status} ${Provides},\n' | grep -E "^installed (.*, )?$1( \(.*\))?," >/dev/null
}


# Installs what is missing of the given groups. Without a missing package it leaves apt alone.
need_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "Not a Debian system: assuming that the packages in packages.txt are installed."
    return
  fi
  local package missing=()
  for package in $(packages_of "$@"); do
    is_installed "$package" || missing+=("$package")
  done
  if [[ ${#missing[@]} -eq 0 ]]; then return; fi

  local as_root=()
  if [[ "$(id -u)" -ne 0 ]]; then
    command -v sudo >/dev/null || fail "these packages are missing and can only be installed as root: ${missing[*]}"
    as_root=(sudo)
  fi
  say "Installing ${missing[*]} ..."
  logged "${as_root[@]}" apt-get update
  logged "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 \
    install --yes --no-install-recommends "${missing[@]}"
}

# --- Building ---

# Runs a command quietly: its output goes to the log and is shown only if it fails.
logged() {
  mkdir -p "$(dirname "$log")"
  local status=0
  "$@" >"$log" 2>&1 </dev/null || status=$?
  if [[ $status -ne 0 ]]; then
    cat "$log" >&2
    say "do: failed: $*"
    exit "$status"
  fi
}

# configure PRESET [-DOPTION=VALUE ...]: a fresh tree begins without tests and benchmarks, so that nobody needs
# their packages to run the command. What a task has switched on stays on.
configure() {
  local preset="$1" options=()
  shift
  if [[ ! -f "$root/build/$preset/CMakeCache.txt" ]]; then
    options=(-DDASHPAD_BUILD_TESTS=OFF -DDASHPAD_BUILD_BENCH=OFF)
  fi
  logged cmake -S "$root" --preset "$preset" "${options[@]}" "$@"
}

# build PRESET [TARGET...]
build() {
  local preset="$1" target targets=()
  shift
  for target in "$@"; do targets+=(--target "$target"); done
  logged cmake --build "$root/build/$preset" --parallel "$jobs" "${targets[@]}"
}

# --- Tasks ---

task_run() {
  local case="$root/examples/helmet-pad-10fps.toml"
  if [[ $# -gt 0 && "$1" != -* ]]; then
    case="$1"
    shift
  fi
  need_packages run
  say "Building the command ..."
  configure release
  build release dashpad-command
  exec "$root/build/release/app/dashpad" run "$case" "$@"
}

# At the end once more what failed within the tests, and last ctest's summary line.
summary_last() {
  awk '/tests passed, [0-9]+ tests failed out of/ { summary = $0; next }
       /^ *not ok |: Failure$|^ *error: / { failures = failures $0 "\n" }
       { print; fflush() }
       END { printf "%s", failures; if (summary) print summary }'
}

task_test() {
  local preset=release
  if [[ $# -gt 0 && "$1" != -* ]]; then
    preset="$1"
    shift
  fi
  need_packages run test format shellcheck wasm
  if [[ "$preset" == asan-ubsan ]]; then need_packages clang; fi
  say "Building the tests ..."
  configure "$preset" -DDASHPAD_BUILD_TESTS=ON
  build "$preset"
  cd "$root"
  ctest --preset "$preset" --parallel "$jobs" --no-label-summary "$@" </dev/null 2>&1 | summary_last
}

# Runs the programs of bench/ one after the other and keeps what they measure: not the names of this machine.
# bench_rows of this tree with the library of another commit, in a clone of its own.
build_rows_of() {
  local before="$root/build/before" commit
  commit="$(git -C "$root" rev-parse --verify --quiet "$1^{commit}")" || fail "no commit '$1'"
  say "Building the benchmark with $1 ..."
  [[ -e "$before" ]] || git clone --quiet --no-checkout "$root" "$before"
  git -C "$before" fetch --quiet origin
  git -C "$before" checkout --quiet --force --detach "$commit"
  cp "$root/bench/bench_rows.cpp" "$before/bench"
  (cd "$before" && cmake --preset release -DDASHPAD_BUILD_BENCH=ON && cmake --build build/release -j "$jobs" --target bench_rows) \
    >"$root/build/do.log" 2>&1 || fail "cannot be built with $1; see build/do.log"
}

task_bench() {
  need_packages run bench
  say "Building the benchmarks ..."
  configure release -DDASHPAD_BUILD_BENCH=ON
  build release dashpad-bench
  local programs="$root/build/release/bench" results="$root/build/bench" recorded="$root/bench/results" record=false
  case "${1:-all}" in
    impact | injury | work-precision | study | report)
      local program="bench_${1//-/_}"
      shift
      exec "$programs/$program" "$@"
      ;;
    rows)
      [[ $# -lt 2 ]] || build_rows_of "$2"
      exec "$programs/bench_rows" ${2:+--against "$root/build/before/build/release/bench/bench_rows"}
      ;;
    --check) exec "$programs/bench_report" "$recorded" --readme "$root/bench/README.md" --check ;;
    --record) record=true ;;
    all) ;;
    *) fail "no benchmark '$1': impact, injury, work-precision, study, rows or report" ;;
  esac
  mkdir -p "$results"
  local program
  for program in impact injury; do
    "$programs/bench_$program" --benchmark_repetitions=5 --benchmark_min_time=0.1 \
      --benchmark_enable_random_interleaving=true --benchmark_display_aggregates_only=true \
      --benchmark_out="$results/$program.json" --benchmark_out_format=json
    sed -i -e '/"host_name":/d' -e '/"executable":/d' "$results/$program.json"
  done
  "$programs/bench_work_precision" --csv "$results/work-precision.csv"
  "$programs/bench_study" --csv "$results/study.csv"
  "$programs/bench_report" "$results" --pictures "$results"
  if $record; then
    cp "$results/work-precision.csv" "$results/study.csv" "$recorded"
    "$programs/bench_report" "$recorded" --readme "$root/bench/README.md"
  fi
  say "Raw results, plots and benchmarks.html: ${results#"$root"/}"
}

# The site of the documents: what it shows of the command is printed and drawn by the command.
task_docs() {
  need_packages run docs
  task_wasm
  say "Building the command ..."
  configure release
  build release dashpad-command
  say "Making the site ..."
  python3 "$root/docs/site/build.py" --command "$root/build/release/app/dashpad" --out "$root/build/site"
  say "Open build/site/index.html; its search needs a server: python3 -m http.server --directory build/site"
}

# The pictures of the documents, by the command that users have; those of the theory, by a script that calls it.
task_pictures() {
  need_packages run pictures
  say "Building the command ..."
  configure release
  build release dashpad-command
  cd "$root"
  local dashpad="build/release/app/dashpad" images="docs/images" stills="build/pictures" law still
  "$dashpad" run examples/helmet-pad-10fps.toml --drawing "$images/helmet-pad-10fps.svg" --force >/dev/null
  "$dashpad" compare examples/dashboard-20mph.toml --picture "$images/spit1984-comparison.svg" --force >/dev/null
  for law in 9 21; do
    "$dashpad" material-test "ensolite-aac-$law" --test parabolic --strain 0.95 --rate 1,100 --explicit-1984 \
      --units us --picture "$images/figure-2-$((law == 9 ? 9 : 10)).svg" --force >/dev/null
  done
  python3 "$images/theory/draw_impact.py" "$dashpad"
  "$dashpad" validate --figures "$stills" --force >/dev/null
  for still in "$images"/validation/*.svg; do cp "$stills/$(basename "$still")" "$still"; done
  git status --short "$images"
}

# Paths of the C++ and C files, relative to the root.
cpp_files() {
  (cd "$root" && find app bench c examples include src tests windows -name '*.[ch]pp' -o -name '*.[ch]' | sort)
}

task_format() {
  need_packages format
  cd "$root"
  cpp_files | xargs -r clang-format -i
}

# Names that nobody would look for: the largest and smallest of something are max_ and min_, faults of a command line are
# errors, and a parameter is named for what it is. Comments in include/ begin with a sentence or a noun phrase.
check_names() {
  # shellcheck disable=SC2016
  cpp_files | xargs -r awk '
    FNR == 1 { in_text = 0; after_comment = 0 }
    FILENAME ~ /^include/ {
      if ($0 ~ /^[ \t]*\/\/\/? (Of|What|As|By|With|Where) [^ ]/ && !after_comment) {
        print FILENAME ":" FNR ": a comment begins with a sentence or a noun phrase"
        found = 1
      }
      after_comment = ($0 ~ /^[ \t]*\/\//)
    }
    in_text { if (/\)"/) in_text = 0; next }
    {
      code = $0
      if (code ~ /R"\(/ && code !~ /\)"/) in_text = 1
      gsub(/"([^"\\]|\\.)*"/, "", code)
      sub(/\/\/.*/, "", code)
      rule = ""
      if (code ~ /(^|[^A-Za-z0-9_])(most|least)_[a-z]/ && code !~ /least_squares|most_of_a_kind/) rule = "max_ or min_, not most_ or least_"
      if (code ~ /(^|[^A-Za-z0-9_])wrong([^A-Za-z0-9_]|$)/ && FILENAME !~ /^tests/) rule = "errors, not wrong"
      if (code ~ /([&*a-z]|[^-]>) ?of[,)]/ && code !~ /[a-z_]of[,)]|\(\*of\)/) rule = "a parameter is named for what it is, not of"
      if (rule) { print FILENAME ":" FNR ": " rule; found = 1 }
    }
    END { exit found }'
}

task_check_layout() {
  need_packages format shellcheck
  cd "$root"
  say "Checking the layout ..."
  cpp_files | xargs -r -n 100 -P "$jobs" clang-format --dry-run --Werror
  say "Checking names ..."
  check_names
  say "Running shellcheck ..."
  shellcheck ./do ./.ci/run package/*.sh tests/soak/*.sh tests/regression/*.sh
}

task_lint() {
  need_packages run test bench format lint
  cd "$root"
  task_check_layout

  # Ninja goes on from what has passed: the first time takes half an hour, later ones what has changed.
  say "Building with clang-tidy, with warnings as errors ..."
  configure lint -DDASHPAD_BUILD_TESTS=ON -DDASHPAD_BUILD_BENCH=ON
  logged cmake --build "$root/build/lint" --parallel "$jobs" -- -k 0

  # It does not read lambdas that are templates: what it says of them is told to be passed over.
  say "Running cppcheck ..."
  cppcheck --project=build/lint/compile_commands.json --file-filter="src/*" --file-filter="app/*" \
    --file-filter="*/Unity/*" \
    --enable=warning,performance,portability --inline-suppr --std=c++20 --quiet --error-exitcode=1 \
    --suppress='*:/usr/include/*' --suppress=internalAstError --suppress=syntaxError \
    --suppress=returnTempReference --suppress=useInitializationList -j "$jobs"
  say "No findings."
}

task_coverage() {
  need_packages run test coverage
  find "$root/build/coverage" -name '*.gcda' -delete 2>/dev/null || true
  task_test coverage
  mkdir -p "$root/build/coverage/report"
  gcovr --root "$root" --object-directory "$root/build/coverage" --filter "$root/include/" --filter "$root/src/" \
    --filter "$root/app/" --exclude-throw-branches --exclude-directories '.*(CompilerId|consumer).*' \
    --html-details "$root/build/coverage/report/index.html" --txt
  say "Line by line: build/coverage/report/index.html"
}

# What a target learns from one run to the next stays in build/fuzz/corpus; tests/fuzz/corpus is what is tested
# everywhere. Stops at the first target that breaks.
task_fuzz() {
  local names=() seconds=300 name
  if [[ $# -gt 0 && ! "$1" =~ ^[0-9]+$ ]]; then
    [[ -f "$root/tests/fuzz/fuzz_$1.cpp" ]] || fail "no target '$1': there is no tests/fuzz/fuzz_$1.cpp"
    names=("$1")
    shift
  else
    for name in "$root"/tests/fuzz/fuzz_*.cpp; do
      name="${name##*/fuzz_}"
      names+=("${name%.cpp}")
    done
  fi
  seconds="${1:-$seconds}"
  [[ "$seconds" =~ ^[1-9][0-9]*$ ]] || fail "not a number of seconds: '$seconds'"
  need_packages run clang
  say "Building the fuzz targets ..."
  configure fuzz
  build fuzz "${names[@]/#/fuzz_}"
  mkdir -p "$root/build/fuzz/findings"
  if [[ -w /dev/shm ]]; then export TMPDIR=/dev/shm; fi  # readers want files; in memory they take half the time
  for name in "${names[@]}"; do
    say "Fuzzing $name for $seconds s ..."
    mkdir -p "$root/build/fuzz/corpus/$name"
    "$root/build/fuzz/tests/fuzz/fuzz_$name" "$root/build/fuzz/corpus/$name" "$root/tests/fuzz/corpus/$name" \
      -max_total_time="$seconds" -max_len=8192 -timeout=10 -rss_limit_mb=4096 -print_final_stats=1 -verbosity=0 \
      -artifact_prefix="$root/build/fuzz/findings/$name-"
  done
}

# Sources of the engine of the live page, a line a batch: the headers are most of the time of a source. The first word is
# the optimisation.
wasm_batches() {
  local left_out=(
    input/disk.cpp input/measurement/measurement_file.cpp  # the disk itself: web/engine/host.cpp has functions of its own
    'input/iso_mme/\(archive\|folder\|iso_mme\|test_files\).cpp'  # a test is a folder or an archive
    'input/material_deck/\(abaqus\|deck\|include\|ls_dyna\|material\|radioss\|stated\).*'  # files that no page reads
    fit/session.cpp                  # keeps finished work on the disk
    'study/\(answers\|answers_of_store\|ranking\|run_study\|sqlite\|store.*\|study_.*\|turning_level\|worker\).cpp'
    laboratory/creep.cpp             # tests of hours
    live/live_page.cpp               # writes the page that has the engine
    margin/draws.cpp                 # no page asks for a probability
    output/svg/rendered.cpp          # librsvg
    output/text/proposal_toml.cpp    # names files beside it
    'output/.*/\(study_\([^wg]\|grid_\).*\|fall_height\|sensitivity\|material_.*\|citation.*\|bibtex\|post_impact\|filled\|test_plan\).*'
    'output/\(csv\|deck\)/.*'
  )
  # Two include themselves once for each instruction set, the third must be fast.
  local alone=(model/contact/sweep.cpp model/contact/foam_nodes.cpp quantities/portable_math.cpp)
  printf -- '-O3 %s\n' "${alone[@]}"
  (cd "$root/src" && find quantities model impact result injury case json input laboratory uncertainty study margin fit output live \
    -name '*.cpp' | sort) | grep -vx "$(printf '%s\n' "${left_out[@]}" "${alone[@]}")" |
    awk '{ folder = $0; sub("/[^/]*$", "", folder)
           printf "%s%s", folder != last || n % 12 == 0 ? (NR == 1 ? "" : "\n") (folder ~ "^(model|impact)" ? "-O3 " : "-Oz ") : " ", $0
           n = folder != last ? 1 : n + 1
           last = folder }
         END { print "" }'
}

# The cards and standards as a source of the engine.
shipped_files() {
  local file
  printf '// Made by ./do wasm.\n#include <span>\n#include <string_view>\n#include <utility>\n\nnamespace dashpad {\n'
  printf 'using File = std::pair<const char*, std::string_view>;\nstd::span<const File> shipped_files();\n'
  printf 'std::span<const File> shipped_files() {\n  static constexpr File all[]{'
  for file in "$root"/materials/*.toml "$root"/standards/*.toml; do
    printf '\n{"%s", R"toml(%s\n)toml"},' "${file#"$root"/}" "$(cat "$file")"
  done
  printf '};\n  return all;\n}\n}  // namespace dashpad\n'
}

# packed MODULE ENDING COMMAND...: packs a module, if it has changed, as small as can be.
packed() {
  local module="$root/build/wasm/$1.wasm" file="$root/build/wasm/$1.wasm.$2"
  if [[ "$module" -nt "$file" ]]; then
    "${@:3}" "$module" >"$file.new"
    mv "$file.new" "$file"
  fi
}

# Exceptions end the program, since the C++ library has none; std::filesystem::path is there, the rest of it is not.
# Highway 1.0.3 has no lanes of doubles for WebAssembly.
task_wasm() {
  need_packages wasm
  local folder="$root/build/wasm" optimisation batch source name objects="" place=0
  mkdir -p "$folder/headers" "$folder/batches"
  # Not /usr/include itself: it has the C library of this system.
  [[ -f "$folder/headers.hpp" ]] ||  # a file that is new is compiled, and all that include it
    printf '#include <%s>\n' algorithm functional ranges variant fmt/format.h dashpad/impact/solve.hpp \
      >"$folder/headers.hpp"
  for name in boost eigen3/Eigen fast_float fmt hwy nlohmann toml++; do
    ln -sfn "/usr/include/$name" "$folder/headers/${name##*/}"
  done
  logged cmake "-DSOURCE_DIR=$root" "-DTEMPLATE=$root/src/version.cpp.in" "-DOUTPUT=$folder/version.cpp" \
    "-Dversion=$(sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p' "$root/CMakeLists.txt")" "-Dcompiler=Clang 19" \
    "-Dcompiler_flags=-O3" -Dbuild_type=Release -Dsystem=wasm32-wasi -P "$root/cmake/write_version.cmake"
  shipped_files >"$folder/shipped.new"
  logged cmake "-DWEB=$root/web" "-DOUTPUT=$folder/page.new" -P "$root/cmake/embed_page.cmake"
  for name in shipped page; do
    cmp -s "$folder/$name.new" "$folder/$name.cpp" || cp "$folder/$name.new" "$folder/$name.cpp"
  done
  {
    cat <<TEXT
flags = --target=wasm32-wasi -std=c++20 -DNDEBUG -fignore-exceptions -fno-rtti -fno-math-errno -fno-trapping-math \$
  -DFMT_HEADER_ONLY -DHWY_COMPILE_ONLY_SCALAR -DBOOST_MATH_PROMOTE_DOUBLE_POLICY=false -D__s390x__ -D_LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -Wno-shorten-64-to-32 \$
  -I$root/include -I$root/src -isystem $root/web/engine/serial -isystem $folder/headers
rule compile
  command = clang++-19 \$flags \$optimisation \$define -include-pch headers\$optimisation.pch -MD -MF \$out.d -c \$in -o \$out
  depfile = \$out.d
  deps = gcc
rule precompile
  command = clang++-19 \$flags \$optimisation -x c++-header -MD -MF \$out.d -c \$in -o \$out
  depfile = \$out.d
  deps = gcc
build headers-O3.pch: precompile headers.hpp
  optimisation = -O3
build headers-Oz.pch: precompile headers.hpp
  optimisation = -Oz
rule link
  command = clang++-19 --target=wasm32-wasi -mexec-model=reactor -Wl,-z,stack-size=1048576 -Wl,--strip-all \$in \$
    -Wl,--start-lib \$libraries -Wl,--end-lib -o \$out
TEXT
    while read -r optimisation batch; do
      name="batches/$place"
      place=$((place + 1))
      for source in $batch; do printf '#include "%s"\n' "$root/src/$source"; done >"$folder/$name.new"
      cmp -s "$folder/$name.new" "$folder/$name.cpp" || cp "$folder/$name.new" "$folder/$name.cpp"
      printf 'build %s.o: compile %s.cpp | headers%s.pch\n  optimisation = %s\n' "$name" "$name" "$optimisation" "$optimisation"
      objects+=" $name.o"
    done < <(wasm_batches)
    for source in "$folder/version.cpp" "$folder/shipped.cpp" "$folder/page.cpp" "$root/web/engine/host.cpp"; do
      name="$(basename "$source" .cpp)"
      printf 'build %s.o: compile %s | headers-Oz.pch\n  optimisation = -Oz\n' "$name" "$source"
    done
    printf 'build command_host.o: compile %s | headers-Oz.pch\n  optimisation = -Oz\n  define = -DANSWER=dashpad::live::command_answer\n' \
      "$root/web/engine/host.cpp"
    # That of the command writes whole pages, documents of cards and more, which a live page does without.
    for name in engine:host command:command_host; do
      printf 'build %s.wasm: link %s.o |%s shipped.o page.o version.o\n  libraries = shipped.o page.o version.o%s\n' \
        "${name%:*}" "${name#*:}" "$objects" "$objects"
    done
  } >"$folder/build.ninja"
  say "Compiling for WebAssembly ..."
  logged ninja -C "$folder" -j "$jobs"
  # The numbers are those of code: context of four bits, no period.
  packed engine lzma xz --format=lzma --lzma1=preset=9e,lc=4,pb=0 --stdout
}

# The package of web/npm with the engine, as npm packs it: a tar with a folder "package". The same files give the same bytes.
task_npm() {
  task_wasm
  packed command gz zopfli -c
  local version folder="$root/build/npm"
  version="$(sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p' "$root/CMakeLists.txt")"
  rm -rf "$folder"
  mkdir -p "$folder/package"
  cp -R "$root/web/npm/." "$root/LICENSE" "$root/docs/case-files.md" "$root/web/engine/engine.mjs" "$folder/package"
  cp "$root/build/wasm/command.wasm.gz" "$folder/package/engine.wasm.gz"
  sed -i "s/\"version\": \"[^\"]*\"/\"version\": \"$version\"/" "$folder/package/package.json"
  chmod -R u=rwX,go=rX "$folder/package"
  chmod 755 "$folder/package/bin/dashpad.mjs"
  tar --create --sort=name --mtime=2020-01-01T00:00Z --owner=0 --group=0 --numeric-owner --directory "$folder" package |
    gzip -9 --no-name >"$folder/dashpad-$version.tgz"
  say "The package: build/npm/dashpad-$version.tgz"
}

# The package of python/ with the library, what it loads, cards and standards; tried in an environment of its own, where
# NumPy is the system's.
task_wheel() {
  need_packages run wheel
  say "Building the library and the command ..."
  configure release
  build release dashpad-shared dashpad-command
  local folder="$root/build/wheel" python=/usr/bin/python3 test
  # What setuptools leaves beside its sources would go into the next wheel.
  rm -rf "$folder" "$root/python/build" "$root"/python/*.egg-info
  mkdir -p "$folder"
  "$python" -m pip wheel --quiet --no-build-isolation --no-index --no-deps --wheel-dir "$folder" "$root/python" \
    >"$folder/log" 2>&1 || { cat "$folder/log" >&2 && return 1; }
  rm -rf "$root/python/build" "$root"/python/*.egg-info
  "$python" -m venv --system-site-packages "$folder/trial"
  "$folder/trial/bin/pip" install --quiet --no-index --no-deps "$folder"/dashpad-*.whl
  for test in package commands; do
    (cd "$folder" && env -u DASHPAD_LIBRARY -u DASHPAD_COMMAND -u PYTHONPATH "$folder/trial/bin/python" \
      "$root/python/tests/test_$test.py")
  done
  "$folder/trial/bin/dashpad" run "$root/examples/helmet-pad-10fps.toml" >"$folder/trial.txt"
  say "The package: $(cd "$root" && echo build/wheel/dashpad-*.whl)"
}

task_notebooks() {
  need_packages run notebooks
  say "Building the library and the command ..."
  configure release
  build release dashpad-shared dashpad-command
  local out="$root/build/notebooks" pictures=()
  if [[ "${1:-}" == --record ]]; then pictures=("$root/docs/images/notebooks"); fi
  rm -rf "$out"
  mkdir -p "$out" "${pictures[@]}"
  cp -R "$root/examples" "$out"  # a notebook writes a card beside itself
  PYTHONPATH="$root/python" PYTHONDONTWRITEBYTECODE=1 PYDEVD_DISABLE_FILE_VALIDATION=1 \
    /usr/bin/python3 "$root/python/run_notebooks.py" "$out/examples" "$out" "${pictures[@]}"
}

# Everything that is handed out, in build/package.
task_package() {
  need_packages run wheel wasm windows package
  task_windows
  task_wheel
  say "Building the command ..."
  configure release
  build release dashpad-command dashpad-shared
  local version packages="$root/build/package" stage="$root/build/package/stage" maintainer
  version="$(sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p' "$root/CMakeLists.txt")"
  maintainer="$(git -C "$root" log -1 --format='%an <%ae>')"
  SOURCE_DATE_EPOCH="$(git -C "$root" log -1 --format=%ct)"
  export SOURCE_DATE_EPOCH
  # shellcheck source=package/package.sh
  source "$root/package/package.sh"
  mkdir -p "$packages"
  rm -f "$packages"/*.deb "$packages"/*.tar.xz "$packages"/*.whl "$packages"/*.zip
  say "Packing ..."
  stage_files
  make_deb
  make_archive
  make_sources
  cp "$root"/build/wheel/dashpad-*.whl "$root"/build/windows/dashpad-*.zip "$packages"
  find "$packages" -maxdepth 1 \( -name '*.deb' -o -name '*.tar.xz' -o -name '*.whl' -o -name '*.zip' \) \
    -printf '  %f: %s bytes\n' | sort >&2
  try_packages
}

# The command for Windows with its folders, packed, and compared with the native one under wine. The programs that it contains
# want their licences beside it.
task_windows() {
  need_packages run windows
  task_wasm
  say "Building the command ..."
  configure release
  build release dashpad-command
  say "Building the command for Windows ..."
  configure windows
  build windows dashpad-command
  local version name folder="$root/build/windows" package
  version="$(sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p' "$root/CMakeLists.txt")"
  name="dashpad-$version-windows-x86_64"
  rm -rf "${folder:?}/$name" "$folder/$name.zip"
  mkdir -p "$folder/$name/data" "$folder/$name/licences"
  cp -R "$folder/app/dashpad.exe" "$root/materials" "$root/standards" "$root/examples" "$root/LICENSE" \
    "$root/docs/windows.md" "$root/docs/case-files.md" "$root/build/wasm/engine.wasm.lzma" "$folder/$name"
  cp -R "$root/data/validation" "$folder/$name/data"
  for package in g++-mingw-w64-x86-64-posix mingw-w64-common $(packages_of windows | grep '^lib\|json'); do
    cp -L "/usr/share/doc/$package/copyright" "$folder/$name/licences/$package.txt"
  done
  (cd "$folder" && cmake -E tar cf "$name.zip" --format=zip "--mtime=2020-01-01 00:00:00 UTC" "$name")
  say "Trying it under wine ..."
  node --no-warnings "$root/tests/windows/run.mjs" "$folder/$name.zip" "$root/build/release/app/dashpad" "$root" "$root/build/wine"
  say "The command for Windows: build/windows/$name.zip"
}

# Every step is taken, whatever the one before it said; the last lines say how each ended. What a step printed stays in
# build/nightly, and what has passed is not done again while the code is the same, so that a night that is cut off goes on
# and words in documents cost nothing.
task_nightly() {
  need_packages run test bench format lint clang
  local tests="$root/build/release/tests" ended=() failed=0 kind commit kept
  local code=(.clang-tidy CMakeLists.txt CMakePresets.json app bench c cmake data examples include materials python schema src
    standards tests web windows ':!*.md' ':!bench/results')
  commit="$(git -C "$root" describe --always --dirty --exclude='*' 2>/dev/null || echo unknown)"
  kept="$root/build/nightly/$( (cd "$root" && git ls-files --stage -- "${code[@]}") | git hash-object --stdin | head -c 12)"
  if [[ -n "$(cd "$root" && git status --porcelain -- "${code[@]}")" ]]; then
    kept="$root/build/nightly/changed"
    rm -f "$kept"/*.passed
  fi
  mkdir -p "$kept"
  step() {
    local name="${*##*/}" status=passed from=$SECONDS
    local output="$kept/${name//[ \/]/_}"
    say "--- $name"
    if [[ -e "$output.passed" ]]; then
      status="passed before, $(cat "$output.passed")"
    elif "$@" 2>&1 | tee "$output.log"; then
      echo "$((SECONDS - from)) s" >"$output.passed"
    else
      status=FAILED
      failed=$((failed + 1))
    fi
    ended+=("$name: $status, now $((SECONDS - from)) s")
  }
  (
    say "Building ..."
    configure release -DDASHPAD_BUILD_TESTS=ON
    build release count_answers compare_with_oracle mats_of_known_truth
    configure asan-ubsan -DDASHPAD_BUILD_BENCH=ON  # everything by the second clang: lint has the first
  )
  rm -f "$kept/do_docs.passed"  # the code may be the same, the documents not
  step "$root/do" docs
  step "$root/do" wasm
  step "$root/do" notebooks
  step "$root/do" windows
  step "$root/do" test asan-ubsan -LE 'page|documents|consumer|wasm'  # a browser, and other compilers' programs
  step "$root/do" lint
  step "$root/do" fuzz 30
  step "$tests/mats_of_known_truth" --least 54
  for kind in ordinary plausible; do
    step "$tests/count_answers" --kind "$kind" --cases 10000 --threads "$jobs"
  done
  step "$tests/count_answers" --kind practice --cases 1000 --threads "$jobs"
  step "$tests/compare_with_oracle" --cases 200 --threads "$jobs"
  printf '%s\n' "${ended[@]}" "nightly of $commit: $failed of ${#ended[@]} steps failed" | tee "$kept/summary"
  [[ $failed -eq 0 ]]
}

task_clean() { rm -rf "$root/build"; }

task_install_packages() { need_packages "$@"; }

task="${1:-help}"
[[ $# -eq 0 ]] || shift
case "$task" in
  run | test | bench | pictures | docs | format | check-layout | lint | coverage | fuzz | wasm | npm | wheel | windows | notebooks | package | nightly | clean | install-packages)
    "task_${task//-/_}" "$@"
    ;;
  help | -h | --help) help ;;
  *)
    help >&2
    fail "no task '$task'"
    ;;
esac
