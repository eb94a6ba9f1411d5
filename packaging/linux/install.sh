#!/bin/sh
# Puts the program under a prefix, or takes it away again:
#   ./install.sh [PREFIX]              (default: $HOME/.local)
#   ./install.sh --remove [PREFIX]
set -eu
cd "$(dirname "$0")"
remove=
if [ "${1:-}" = --remove ]; then remove=1; shift; fi
prefix="${1:-$HOME/.local}"

find bin share -type f | while read -r file; do
  if [ -n "$remove" ]; then
    rm -f "$prefix/$file"
  else
    mkdir -p "$prefix/$(dirname "$file")"
    cp "$file" "$prefix/$file"
  fi
done
if [ -n "$remove" ]; then
  for own in share/doc/spectral-explorer/LICENSES share/doc/spectral-explorer; do
    rmdir "$prefix/$own" 2>/dev/null || true
  done
  echo "Spectral Explorer is gone from $prefix."
else
  echo "Spectral Explorer is in $prefix/bin/spectral-explorer."
fi
