#!/bin/bash
# A night of an engine: nightly.sh SUBJECT [FOLDER [SECONDS A QUERY]]
# Reports on it, compares with the last night, fuzzes each query that it answers, keeps what was found as test vectors,
# and writes one page: FOLDER/DATE/README.md. Exit code 1 if anything is new or worse since the last night.
# TOUCHSTONE is the program; EFFORT that of the report. See docs/how_to/run_in_ci.md.
set -euo pipefail
subject=$1 folder=${2:-nights} seconds=${3:-600}
touchstone=${TOUCHSTONE:-./touchstone}
night=$folder/$(date -u +%F)
last=$(find "$folder" -mindepth 2 -maxdepth 2 -name report.json 2>/dev/null | grep -v "^$night/" | sort | tail -n 1 || true)
mkdir -p "$night" "$folder/vectors"

"$touchstone" report --effort "${EFFORT:-standard}" --subjects "$subject" --out "$night" >"$night/report.txt"
worse=0
[[ -z $last ]] || "$touchstone" compare "$last" "$night/report.json" >"$night/compare.txt" || worse=$?
((worse <= 1)) || exit "$worse"

answers=$(python3 -c 'import json, sys; print(*json.load(open(sys.argv[1]))["subjects"][0]["answers"])' "$night/report.json")
for query in ${answers/pair_history/}; do
  found=0
  "$touchstone" fuzz "$query" --subject "$subject" --time "$seconds" --out "$night/found" >>"$night/fuzz.txt" || found=$?
  ((found <= 1)) || exit "$found"
done
refused=0
for case in "$night"/found/*.json; do
  [[ ! -e $case ]] || "$touchstone" vectors "$folder/vectors" --add "$case" >/dev/null 2>&1 || ((++refused))
done

{
  echo "# $subject, $(date -u +%F)"
  echo && "$touchstone" summary "$night/report.json"
  echo && echo "## Since the last night" && echo '```' && cat "$night/compare.txt" 2>/dev/null || echo "the first night"
  echo '```' && echo "## Found by fuzzing" && echo '```' && cat "$night/fuzz.txt" && echo '```'
  echo "Test vectors of all nights: $folder/vectors; $refused findings have no exact answer to keep."
} >"$night/README.md"
echo "$night/README.md"
exit "$worse"
