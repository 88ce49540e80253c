#!/bin/sh
# etc/installDependencies with made-up system programs: nothing is installed here. Argument: the project's folder.
project="$1"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
failures=0
expect() { # name, wanted, found
    [ "$2" = "$3" ] && return
    echo "FAILED $1: wanted '$2', found '$3'"
    failures=$((failures + 1))
}
program() { # name; its text from stdin
    { echo '#!/bin/sh'; cat; } > "$work/bin/$1"
    chmod +x "$work/bin/$1"
}
# A system with nothing but the commands that the installer itself uses.
mkdir "$work/bin"
for name in sh tr env mkdir echo id; do ln -s "$(command -v $name)" "$work/bin/$name"; done
run() {
    (PATH="$work/bin" sh "$project/etc/installDependencies" "$@") > "$work/out" 2>&1
}

run
expect "not Debian" 1 $?
expect "its list" 1 "$(grep -c 'g++ cmake ninja-build' "$work/out")"

echo 'echo installed' | program dpkg-query
run
expect "all there" 0 $?
expect "silent" "" "$(cat "$work/out")"

# what tests need is asked for by them alone
run -list
expect "for users" 0 "$(grep -c -E '^(libgtest-dev|clang-format|codespell)$' "$work/out")"
run -tests -list
expect "for tests" 3 "$(grep -c -E '^(libgtest-dev|clang-format|codespell)$' "$work/out")"
run -test
expect "wrong option" 1 $?

# cmake and gnuplot are missing
echo 'for p; do last=$p; done; case $last in cmake | gnuplot-nox) exit 1 ;; esac; echo installed' | program dpkg-query
run
expect "no apt-get" 1 $?
echo 'echo "$@" >> '"$work"'/asked' | program apt-get
rm "$work/bin/id"
echo 'echo 0' | program id
run
expect "root" 0 $?
expect "asked for" 1 "$(grep -c 'install -y .*--no-install-recommends cmake gnuplot-nox$' "$work/asked")"
expect "updated first" "update" "$(head -n 1 "$work/asked" | grep -o 'update')"

echo 'true' | program gnuplot
rm "$work/asked"
run
expect "another gnuplot" 1 "$(grep -c 'no-install-recommends cmake$' "$work/asked")"

echo 'case "$*" in *install*) exit 100 ;; esac' | program apt-get
run
expect "apt-get fails" 1 $?
expect "its message" 1 "$(grep -c 'could not install all of: cmake' "$work/out")"

echo 'echo 1000' | program id
run
expect "neither root nor sudo" 1 $?
expect "its message" 1 "$(grep -c 'As root: apt-get install' "$work/out")"
echo 'echo sudo "$@" >> '"$work"'/asked; shift; exit 0' | program sudo
rm "$work/asked"
run
expect "by sudo" 0 $?
expect "asked sudo" 1 "$(grep -c '^sudo env .*install' "$work/asked")"
[ "$failures" -eq 0 ]
