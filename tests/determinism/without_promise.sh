#!/usr/bin/env bash
# A compiler launcher for price.sh: compiles without the flags that keep bits equal, and with $INEXACT_FLAGS
# instead.
kept=()
for word in "$@"; do
  case $word in
    -ffp-contract=off | -fno-fast-math) ;;
    *) kept+=("$word") ;;
  esac
done
# shellcheck disable=SC2086 -- a list of words
exec "${kept[@]}" $INEXACT_FLAGS
