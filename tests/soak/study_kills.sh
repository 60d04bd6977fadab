#!/usr/bin/env bash
# Kills a study (SIGKILL) at random moments and gives the same command again, until KILLS kills have hit. The rows
# must then be, byte for byte, those of an undisturbed run. Once as one process, once as two MPI ranks of which a
# random one is killed, the one that writes or the other.
#
# tests/soak/study_kills.sh [one|ranks|both] [ROWS] [KILLS]      default: both 100000 50; takes minutes
#
# DASHPAD names the command (default: build/release/app/dashpad). Exit code 0: all rows are equal.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
dashpad="${DASHPAD:-$root/build/release/app/dashpad}"
forms="${1:-both}" rows="${2:-100000}" kills="${3:-50}"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

exec 3>&2
fail() {
  printf 'study_kills: %s\n' "$*" >&3
  exit 1
}
[[ -x "$dashpad" ]] || fail "no command $dashpad: build it (./do run) or set DASHPAD"
[[ "$forms" == one || "$forms" == ranks || "$forms" == both ]] || fail "give one, ranks or both, not $forms"

cat >"$folder/study.toml" <<TOML
title = "Killed"
case = "$root/examples/dashboard-20mph.toml"
tolerance = 1e-2
samples = $rows
sampling = "monte-carlo"
seed = 7
responses = ["peak_force", "peak_strain", "rebound_speed", "release", "hic15"]
[factors."impactor.speed"]
distribution = "uniform"
low = "10 mph"
high = "20 mph"
[factors."pad.thickness"]
distribution = "uniform"
low = "0.9 in"
high = "1.2 in"
TOML

now() { date +%s.%N; }
# calc EXPRESSION: a number from a formula of numbers.
calc() { awk "BEGIN { printf \"%.3f\", $1 }"; }

# Each process writes its number to a file before it becomes the command.
# shellcheck disable=SC2016 # it is the inner shell that expands it
started='echo $$ > "$0/pid.${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-0}}"; exec "$@"'
one() { exec sh -c "$started" "$folder" "$@"; }
ranks() { exec mpirun --oversubscribe --allow-run-as-root -n 2 sh -c "$started" "$folder" "$@"; }

# study FORM STORE: begins or goes on. Messages are kept: those of mpirun about a killed rank are many.
study() { (
  "$1" "$dashpad" study "$folder/study.toml" --out "$folder/$2" --quiet >"$folder/out" 2>"$folder/err"
); }

# run_to_end FORM STORE: 3 says that some rows are doubtful.
run_to_end() {
  local code=0
  study "$@" || code=$?
  [[ $code -eq 0 || $code -eq 3 ]] || fail "exit code $code of an undisturbed run: $(cat "$folder/err")"
}

# rows_in STORE: reads every row that is there.
rows_in() {
  local said
  if said="$("$dashpad" study export "$folder/$1" --csv - 2>&1 >/dev/null)"; then
    echo "${said%% rows*}"
  elif [[ "$said" == *"no such file"* || "$said" == *"is empty"* ]]; then
    echo 0
  else
    fail "the store cannot be read after a kill: $said"
  fi
}

# kill_one FORM STORE SECONDS: whether a process was there to be killed.
kill_one() {
  local job code=0 victim=0 count=1 tries process
  if [[ "$1" == ranks ]]; then count=2 victim=$((RANDOM % 2)); fi
  rm -f "$folder"/pid.*
  study "$1" "$2" &
  job=$!
  while kill -0 "$job" 2>/dev/null && [[ $(cat "$folder"/pid.* 2>/dev/null | wc -l) -lt $count ]]; do sleep 0.01; done
  sleep "$3"
  kill -KILL "$(cat "$folder/pid.$victim")" 2>/dev/null || true
  # mpirun of Open MPI 4.1 may lock up in its own clean-up when a rank dies while it starts.
  for ((tries = 0; tries < 300; ++tries)); do
    kill -0 "$job" 2>/dev/null || break
    sleep 0.1
  done
  if kill -KILL "$job" 2>/dev/null; then
    stuck=$((stuck + 1))
    for process in "$folder"/pid.*; do kill -KILL "$(cat "$process")" 2>/dev/null || true; done
  fi
  wait "$job" 2>/dev/null || code=$?
  # mpirun reports the signal of the rank as a shell would.
  if [[ $code -ne 137 && $code -ne 0 && $code -ne 3 ]]; then fail "exit code $code: $(cat "$folder/err")"; fi
  [[ $code -eq 137 ]] || return 1
  killed[victim]=$((killed[victim] + 1))
}

compare() {
  "$dashpad" study export "$folder/$1" --csv - 2>/dev/null >"$folder/killed.csv"
  local lines
  lines="$(wc -l <"$folder/killed.csv")"
  [[ $((lines - 1)) -eq $rows ]] || fail "$((lines - 1)) rows instead of $rows"
  cmp "$folder/whole.csv" "$folder/killed.csv" || fail "rows differ"
  for suffix in wal shm journal; do [[ ! -e "$folder/$1-$suffix" ]] || fail "$1-$suffix was left behind"; done
}

soak() {
  local form="$1" start idle work before=0 found hits=0 store=1 begin killed=(0 0) stuck=0
  start="$(now)"
  run_to_end "$form" "$form-whole.db"
  work="$(calc "$(now) - $start")"
  cmp <("$dashpad" study export "$folder/$form-whole.db" --csv - 2>/dev/null) "$folder/whole.csv" ||
    fail "an undisturbed run as $form has other rows"
  start="$(now)"
  run_to_end "$form" "$form-whole.db"
  idle="$(calc "$(now) - $start")"
  begin="$(now)"
  while [[ $hits -lt $kills ]]; do
    # A moment in the start of the program or in the work; kills are spread over the whole study.
    if kill_one "$form" "$form-$store.db" \
      "$(calc "$RANDOM / 32768 * ($idle + 2 * ($work - $idle) / $kills)")" 2>/dev/null; then
      hits=$((hits + 1))
    else # it was over before: check it, and begin another one
      compare "$form-$store.db"
      store=$((store + 1)) before=0
      continue
    fi
    found="$(rows_in "$form-$store.db")"
    [[ $found -ge $before ]] || fail "$before rows before a kill, $found after it"
    before=$found
  done
  run_to_end "$form" "$form-$store.db"
  compare "$form-$store.db"
  printf '%s: %d kills' "$form" "$hits"
  [[ "$form" == one ]] || printf ' (%d of the writing rank, %d of the other; mpirun stuck %d times)' \
    "${killed[0]}" "${killed[1]}" "$stuck"
  printf ' over %d studies; %d rows after the last kill; in the end %d of %d rows are equal' \
    "$store" "$before" "$rows" "$rows"
  printf '; %.0f s, an undisturbed run %.1f s\n' "$(calc "$(now) - $begin")" "$work"
}

run_to_end one whole.db
"$dashpad" study export "$folder/whole.db" --csv "$folder/whole.csv" >/dev/null
if [[ "$forms" != ranks ]]; then soak one; fi
if [[ "$forms" != one ]]; then
  command -v mpirun >/dev/null || fail "mpirun is not installed"
  "$dashpad" --version | grep -q 'MPI  *supported' || fail "this dashpad was built without MPI"
  soak ranks
fi
