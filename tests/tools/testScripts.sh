#!/bin/sh
# RunFunctions and CleanFunctions do what OpenFOAM's verbs do. Argument: the project's folder.
project="$1"
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
mkdir case && cd case || exit 1
. "$project/bin/tools/RunFunctions"
. "$project/bin/tools/CleanFunctions"
failures=0
expect() { # name, wanted, found
    if [ "$2" != "$3" ]; then
        echo "$1: wanted '$2', found '$3'"
        failures=$((failures + 1))
    fi
}

mkdir system constant 0.orig
printf 'FoamFile { object controlDict; }\n// application no;\napplication   pfemFsiFoam; // x\n' > system/controlDict
expect getApplication pfemFsiFoam "$(getApplication)"
expect running "Running echo on $PWD" "$(runApplication echo one)"
expect log one "$(cat log.echo)"
expect "ran already" "echo already run on $PWD: remove log file 'log.echo' to re-run" "$(runApplication echo two)"
expect "log kept" one "$(cat log.echo)"
runApplication -append echo two > /dev/null
expect append "one two" "$(tr '\n' ' ' < log.echo | sed 's/ $//')"
runApplication -o echo three > /dev/null
expect overwrite three "$(cat log.echo)"
runApplication -s part echo four > /dev/null
expect suffix four "$(cat log.echo.part)"
runApplication sh -c 'exit 7' > /dev/null 2>&1
expect "exit code" 7 $?
restore0Dir > /dev/null && expect restore0Dir 0 "$(ls -d 0)"
isTest -a -test || expect isTest true false
notTest -a || expect notTest true false
cloneCase . ../copy > /dev/null
expect cloneCase "0 0.orig constant system" "$(cd ../copy && echo *)"
cloneCase . ../copy > /dev/null && expect "clone twice" failure success
mkdir -p -- 0.1 1e-06 5 -1 10.5 3abc 1.2.3 .0.3.tmp .5 postProcessing VTK
touch case.pvd fluid.vtu.series log.x
cleanCase > /dev/null
expect cleanCase "0 0.orig 1.2.3 3abc constant system" "$(ls -A | tr '\n' ' ' | sed 's/ $//')"
exit $failures
