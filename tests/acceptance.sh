#!/usr/bin/env bash
# Flies the three flights for every seed and prints what they show, beside the paper's Table I.
#   tests/acceptance.sh PROGRAM OUT_DIR JOBS SEED...
# Exit status 1 when a flight does not pass. A flight that is already there is not flown again: remove OUT_DIR to start anew.
set -euo pipefail
program=$(realpath "$1"); out=$2; jobs=$3; shift 3
flights_dir=$(cd "$(dirname "$0")/../scenarios/flights" && pwd)
mkdir -p "$out"

fly_one() {
  local folder="$3/$1/seed_$2"
  [ -f "$folder/result.json" ] && return 0
  local status=0
  "$4" fly "$5/$1.yaml" --seed "$2" --out "$folder" > "$3/$1.seed_$2.log" 2>&1 || status=$?
  echo "$1 seed $2: exit $status"
}
export -f fly_one
for flight in disturbed_hover takeoff_hover_land landing; do
  for seed in "$@"; do echo "$flight $seed"; done
done | xargs -P "$jobs" -L 1 bash -c 'fly_one "$0" "$1" "$2" "$3" "$4"' | sed 's/^/  /' &
wait
