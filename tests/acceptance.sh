#!/usr/bin/env bash
# Flies the flights for every seed and prints what they show, beside the paper's Table I.
#   tests/acceptance.sh PROGRAM OUT_DIR JOBS SEED...
# A flight in OUT_DIR that is newer than PROGRAM is not flown again. Exit status 1 when a flight did not pass or left no result.
set -euo pipefail
program=$(realpath "$1"); out=$2; jobs=$3; shift 3
scenarios=$(cd "$(dirname "$0")/../scenarios/flights" && pwd)
flights=(disturbed_hover hand_held outdoor takeoff_hover_land rectangle_pad landing)
mkdir -p "$out"

# Largest first, so that the last job is short.
for flight in "${flights[@]}"; do
  for seed in "$@"; do
    result="$out/$flight/seed_$seed/result.json"
    [ "$result" -nt "$program" ] && continue
    rm -f "$result"
    printf '%s %s\n' "$flight" "$seed"
  done
done | program=$program out=$out scenarios=$scenarios xargs -r -P "$jobs" -L 1 bash -c '
  mkdir -p "$out/$1"
  status=0
  "$program" fly "$scenarios/$1.yaml" --seed "$2" --out "$out/$1/seed_$2" > "$out/$1/seed_$2.log" 2>&1 || status=$?
  printf "%-20s seed %-3s exit %s\n" "$1" "$2" "$status"' _

# Rows: name, unit, metric, scale, the paper's hand-held, hovering and autonomous figures (Table I).
table='[
  ["XY RMSE", "mm", "estimate.xy_rmse_m", 1000, 43.1, 38.8, 33.7],
  ["Z RMSE", "mm", "estimate.z_rmse_m", 1000, 7.9, 5.7, 6.8],
  ["3D RMSE", "mm", "estimate.xyz_rmse_m", 1000, 43.8, 39.2, 34.4],
  ["roll RMSE", "deg", "estimate.roll_rmse_deg", 1, 1.4, 1.3, 1.4],
  ["pitch RMSE", "deg", "estimate.pitch_rmse_deg", 1, 1.2, 1.4, 1.5],
  ["yaw RMSE", "deg", "estimate.yaw_rmse_deg", 1, 7.2, 4.8, 2.7]]'
failed=0
for flight in "${flights[@]}"; do
  results=()
  echo
  for seed in "$@"; do
    result="$out/$flight/seed_$seed/result.json"
    if [ -f "$result" ]; then results+=("$result"); else echo "$flight seed $seed: no result"; failed=1; fi
  done
  [ ${#results[@]} -gt 0 ] || continue
  jq -rs --arg flight "$flight" --argjson table "$table" '
    def round2: . * 100 | round / 100;
    def rms: (map(. * .) | add / length | sqrt);
    def values($name): [.[].metrics[$name] // empty];
    def span($name; $unit; $scale): values($name) | if length > 0 then
      "  \($name): mean \(add / length * $scale | round2), min \(min * $scale | round2), max \(max * $scale | round2) \($unit)" else empty end;
    . as $all |
    "\($flight): \(map(select(.verdict == "pass")) | length) of \(length) passed",
    ($table[] | . as [$row, $unit, $metric, $scale, $hand, $hover, $auto] | $all | values($metric) | select(length > 0) |
      "  \($row): \(rms * $scale | round2) \($unit) (worst \(max * $scale | round2)); paper: \(
        if $flight == "disturbed_hover" then $hover elif $flight == "hand_held" then $hand elif $flight == "takeoff_hover_land" then $auto else "-" end)"),
    span("estimate.availability"; ""; 1), span("estimate.false_pads"; "frames"; 1),
    span("flight.touchdown_xy_error_m"; "mm"; 1000), span("flight.touchdown_speed_m_s"; "m/s"; 1),
    span("flight.touchdown_tilt_deg"; "deg"; 1), span("flight.touchdown_yaw_error_deg"; "deg"; 1),
    span("flight.hover_xyz_rmse_m"; "mm"; 1000), span("flight.max_xy_offset_m"; "mm"; 1000),
    (map(select(.verdict != "pass")) | .[] | "  FAILED seed \(.seed): \(.outcome), \([.checks[] | select(.pass | not) | .name] | join(", "))")
  ' "${results[@]}"
  jq -es 'all(.verdict == "pass")' "${results[@]}" > /dev/null || failed=1
done
exit $failed
