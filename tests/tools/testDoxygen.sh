#!/bin/sh
# The reference of the code is made without a warning. Argument: the project's folder. Exit code 77: doxygen is not installed.
command -v doxygen > /dev/null 2>&1 || { echo "skipped: doxygen is not installed"; exit 77; }
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$1" || exit 1
{ cat doc/Doxyfile; echo "OUTPUT_DIRECTORY = $work"; } | doxygen - > "$work/log" 2>&1
code=$?
cat "$work/log"
[ $code -eq 0 ] && [ ! -s "$work/log" ] && [ -f "$work/html/index.html" ]
