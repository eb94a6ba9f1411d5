#!/usr/bin/env bash
# What two builds of the program print over all shipped lights, byte by byte.
#
#   tests/same_output.sh OLD_PROGRAM NEW_PROGRAM
#
# Prints a line for every command whose output differs, and how many of how many did. Times are
# left out of the race, as no two runs have the same.
set -euo pipefail
old=$1 new=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
differ=0 compared=0
compare() {
  local side
  for side in old new; do
    "${!side}" "$@" 2>&1 | grep -v 'ns_per_' >"$work/$side" || true
  done
  compared=$((compared + 1))
  cmp -s "$work/old" "$work/new" || { differ=$((differ + 1)); echo "differs: $*"; }
}
# The model as a line of text, which a converted file holds.
compare_file() {
  local side
  for side in old new; do
    "${!side}" convert "$1" "$work/$side.txt" --force "${@:2}" >/dev/null 2>&1 || echo refused >"$work/$side.txt"
  done
  compared=$((compared + 1))
  cmp -s "$work/old.txt" "$work/new.txt" || { differ=$((differ + 1)); echo "differs: convert $*"; }
}
mapfile -t lights < <("$old" list --kind light --json | sed -n 's/^ *"id": "\(.*\)",\{0,1\}$/\1/p')
for light in "${lights[@]}"; do
  compare report "$light"
  compare report "$light" --json
  compare product "$light" colorchecker_ohta/red --json
  compare_file "$light" --wide-lines
done
for light in FL2 FL11 'CIE D65' paper/Mercury; do
  compare sweep "$light" --json
  compare auction "$light" --json
  compare product "$light" --set colorchecker_ohta --json
done
compare race --numbers 11,20 --json
echo "$differ of $compared differ"
test "$differ" = 0
