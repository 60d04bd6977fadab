#!/usr/bin/env bash
# What the command answers, to compare two commits with diff -r: text, JSON, CSV, pages and stills of every
# subcommand over all examples, and what it says of inputs that it refuses.
#
#   record_outputs.sh COMMAND FOLDER      COMMAND: build/release/app/dashpad; FOLDER: a new one
#
# Commit, times and processor times are taken out: they differ from run to run.
set -euo pipefail

command="$(realpath "$1")"
mkdir "$2"
into="$(realpath "$2")"
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
unset DASHPAD_MATERIALS DASHPAD_STANDARDS DASHPAD_VALIDATION_DATA

# keep NAME ARGUMENTS...: output, complaints and exit code
keep() {
  local name="$into/$1" code=0
  mkdir -p "$(dirname "$name")"
  shift
  "$command" "$@" >"$name.out" 2>"$name.err" </dev/null || code=$?
  echo "$code" >"$name.code"
}

for case in examples/*.toml tests/verification/cases/*.toml; do
  name="$(basename "$case" .toml)"
  mkdir -p "$into/run" "$into/assess" "$into/export"
  keep "check/$name" check "$case"
  keep "check/$name-us" check "$case" --units us
  keep "run/$name" run "$case" --all --json "$into/run/$name.json" --csv "$into/run/$name.csv" \
    --report "$into/run/$name.html" --drawing "$into/run/$name.svg"
  keep "run/$name-us" run "$case" --units us
  keep "run/$name-metric" run "$case" --units engineering-metric --tolerance 1e-3 --no-intervals
  keep "assess/$name" assess "$case" --standard fmvss-201-instrument-panel --standard en-1177 --keep-nose \
    --keep-speed --json "$into/assess/$name.json" --report "$into/assess/$name.html"
  keep "post-impact/$name" post-impact "$case" --other-mass "1500 kg" --json -
  keep "compare/$name" compare "$case" --json -
  keep "spit1984/$name" spit1984 "$case" --listing -
  for format in ls-dyna radioss csv iso-mme; do
    keep "export/$name-$format" export "$case" --format "$format" --points 50 --out "$into/export/$name.$format"
  done
done

for pulse in examples/pulses/*.csv; do
  name="$(basename "$pulse" .csv)"
  mkdir -p "$into/pulse"
  keep "pulse/$name" pulse "$pulse" --drop-height "1.5 m" --calibration "2 %" --all --json "$into/pulse/$name.json" \
    --csv "$into/pulse/$name.csv" --report "$into/pulse/$name.html" --picture "$into/pulse/$name.svg"
  keep "pulse/$name-compared" compare examples/helmet-pad-10fps.toml --pulse "$pulse" \
    --json "$into/pulse/$name-compared.json" --report "$into/pulse/$name-compared.html"
done

for fit in examples/fits/*.toml; do
  name="$(basename "$fit" .toml)"
  mkdir -p "$into/fit"
  keep "fit/$name" fit "$fit" --json "$into/fit/$name.json" -o "$into/fit/$name.toml" --report "$into/fit/$name.html"
done

mkdir -p "$into/study"
keep "study/run" study "examples/studies/speed-and-thickness.toml" --out "$into/study/store.db" --quiet
keep "study/summary" study summary "$into/study/store.db" --json "$into/study/summary.json" \
  --report "$into/study/summary.html"
keep "study/csv" study export "$into/study/store.db" --csv -
keep "study/replay" study replay "$into/study/store.db" 3
rm -f "$into"/study/store.db*

keep materials/all materials
keep materials/picture materials --picture "$into/materials.svg"
for card in materials/*.toml; do
  name="$(basename "$card" .toml)"
  mkdir -p "$into/material-test"
  keep "materials/$name" materials "$name"
  keep "materials/$name-us" materials "$name" --units us
  keep "material-test/$name" material-test "$name" --json "$into/material-test/$name.json" \
    --csv "$into/material-test/$name.csv" --report "$into/material-test/$name.html"
  for format in ls-dyna-{057,063,083,163} radioss-{33,62,70,90}; do
    keep "material/$name-$format" material export "$name" --format "$format" -o -
  done
done
for standard in standards/*.toml; do
  keep "standards/$(basename "$standard" .toml)" standards "$(basename "$standard" .toml)"
done
keep standards/all standards
keep validate validate --json "$into/validate.json" --report "$into/validate.html"

# Seeds of the fuzzers, sound ones and others.
for file in tests/fuzz/corpus/{case_file,material_card,standard,pulse_csv,measured_tests,material_deck,fit_file,study}/*; do
  kind="$(basename "$(dirname "$file")")"
  name="corpus/$kind-$(basename "$file")"
  case "$kind" in
    case_file) keep "$name" check "$file" ;;
    material_card) keep "$name" materials "./$file" ;;
    standard) keep "$name" standards "./$file" ;;
    pulse_csv) keep "$name" pulse "$file" ;;
    measured_tests | material_deck) keep "$name" material import "$file" -o - ;;
    fit_file) keep "$name" fit "$file" ;;
    study) keep "$name" study "$file" --out /dev/null/none ;;
  esac
done

# A line of each example left out, doubled, or with a value that is none.
broken="$(mktemp -d)"
trap 'rm -r "$broken"' EXIT
for case in examples/*.toml; do
  name="$(basename "$case" .toml)"
  while read -r line; do
    sed "${line}d" "$case" >"$broken/case.toml"
    keep "bad/$name-$line-left-out" check "$broken/case.toml"
    sed "${line}p" "$case" >"$broken/case.toml"
    keep "bad/$name-$line-twice" check "$broken/case.toml"
    sed "${line}s/=.*/= \"-1 furlong\"/" "$case" >"$broken/case.toml"
    keep "bad/$name-$line-furlong" check "$broken/case.toml"
    sed "${line}s/ *=/x =/" "$case" >"$broken/case.toml"
    keep "bad/$name-$line-misspelt" check "$broken/case.toml"
  done < <(grep -n '=' "$case" | cut -d: -f1)
done

# Each answer to a bad input in one file: thousands of small ones are slow to compare.
(cd "$into/bad" && for file in *.err; do echo "## $file $(cat "${file%.err}.code")" && cat "$file"; done) |
  sed "s#$broken/##" >"$into/bad.txt"
rm -r "$into/bad"
find "$into" -type f -exec sed -i -E -e "s#$into#FOLDER#g; s#$PWD/#SOURCE/#g; s/(commit |\()[0-9a-f]{12}(-dirty)?/\1COMMIT/" \
  -e 's/(evaluations|computed) in [0-9.]+ s(, [0-9]+ rows)?/\1/; /^Simulating the tests will take/d' \
  -e 's/"(solve_time|wall_time|processor_time|elapsed)[a-z_]*": [0-9.e+-]+/"\1": 0/; s/"commit": "[^"]*"/"commit": ""/; s/[0-9.]+ (ms|s); energy/ms; energy/' {} +
