#!/bin/bash
# Leaves the fuzz targets in $OUT, each with the libraries that it needs, its options and its first inputs.
set -euo pipefail

# The preset has flags of its own. Those of the builder name another C++ library than Debian's packages are built with.
unset CFLAGS CXXFLAGS
# shellcheck disable=SC2016
cmake --preset fuzz -B "$WORK/build" -D CMAKE_BUILD_RPATH='$ORIGIN/lib'
cmake --build "$WORK/build" --target fuzzers

mkdir -p "$OUT/lib"
for target in "$WORK"/build/fuzzers/touchstone_fuzz_*; do
  cp "$target" "$OUT"
  # All libraries but those of the C library, which the machine that runs the targets has.
  ldd "$target" | awk '$3 ~ /^\// && $3 !~ /\/lib(c|m|dl|rt|pthread|resolv)\.so/ {print $3}' |
    xargs --no-run-if-empty cp --dereference --target-directory "$OUT/lib"
  name=$(basename "$target")
  if [[ $name != *_parser_* ]]; then
    printf '[libfuzzer]\nmax_len = 132\n' >"$OUT/$name.options"
  fi
done
find docs/scenes -name '*.json' -print0 |
  xargs --null python3 -m zipfile -c "$OUT/touchstone_fuzz_parser_scene_seed_corpus.zip"
