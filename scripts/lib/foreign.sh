# shellcheck shell=bash
# shellcheck disable=SC2154 # sysroot.sh sets sysroot
# Sourced after bare-root.sh, same-bytes.sh and sysroot.sh: tries the packages for other processors under qemu, those for Windows under Wine.

# make_reference FOLDER VERSION: the program for this machine, in $reference, with what the other systems have: no CSPICE.
make_reference() {
    reference=$1/reference/msisf-$2-linux-x64
    [ ! -d "$reference" ] || return 0
    mkdir "$1/reference"
    tar -xzf "$1/msisf-$2-linux-x64.tar.gz" -C "$1/reference"
    rm -rf "$reference/lib/native"
}

# make_command FILE WORDS...: a program that runs these words with its arguments.
make_command() {
    printf '#!/bin/sh\nexec %s "$@"\n' "$(printf '%q ' "${@:2}")" >"$1"
    chmod +x "$1"
}

# Messages name folders. Lines and letters of annotated pictures have other roundings, as have the checksums in the manifest.
same_outputs() { diff -rq --exclude=stderr --exclude='*.annotated.png' --exclude='*.jsonl' "$1" "$2"; }

same_numbers() { cmp "$1/exit-code" "$2/exit-code" && /usr/bin/python3 scripts/lib/same-numbers.py "$1/out" "$2/out"; }

try_arm() { # FOLDER VERSION
    local name=msisf-$2-linux-arm64 program
    install_parts qemu || die 'qemu is needed to try the package for ARM.'
    make_reference "$@"
    prepare_sysroot linux-arm64
    mkdir "$1/arm"
    tar -xzf "$1/$name.tar.gz" -C "$1/arm"
    program=$1/arm/msis
    make_command "$program" qemu-aarch64-static -L "$sysroot" "$1/arm/$name/publish/msis"
    # The server is a second start of the program, which qemu does not run by itself.
    try_server "$1/trial" "$program" msis-server || die "the server on ARM does not draw: see $1"
    try_resume "$1/arm/resumed" "$program"
    say "ARM under qemu:"
    compare_programs runs_elsewhere "$reference/msis" "$program" "$1/arm/runs" same_outputs || die "what differs is in $1/arm/runs"
    dpkg-deb -x "$1/msisf_$2_arm64.deb" "$1/arm/deb"
    diff -rq --no-dereference "$1/arm/$name/publish" "$1/arm/deb/usr/lib/msisf/publish" || die "the packages for ARM differ: see $1"
    try_pip_on_arm "$@"
}

# With Debian's Python and NumPy for ARM.
try_pip_on_arm() { # FOLDER VERSION
    local there=$1/arm/pip library
    unpack_packages arm64 "$there" dash coreutils python3-numpy
    add_devices "$there"
    for library in "$there"/usr/lib/*/{blas,lapack}/*.so.3; do # as their packages do when they are installed
        ln -s --relative "$library" "${library%/*/*}"
    done
    unpack_wheel "$1/msisf-$2-py3-none-manylinux_2_34_aarch64.whl" "$there/usr/lib/python3/dist-packages"
    try_package "$there" /usr/lib/python3/dist-packages/bin/msis "$1/trial" trial.png || die "the package for pip does not draw on ARM: see $1"
    try_python "$1" "$there"
}

try_windows() { # FOLDER VERSION
    local name=msisf-$2-win-x64 program
    install_parts wine unzip numpy || die 'Wine is needed to try the package for Windows.'
    make_reference "$@"
    mkdir "$1/windows"
    unzip -q "$1/$name.zip" -d "$1/windows"
    WINEPREFIX=$(mktemp -d)/wine # not in this tree: it has a link to the root, which other programs follow
    export WINEPREFIX WINEDEBUG=-all
    wineboot -i >/dev/null 2>&1 || die 'Wine does not start.'
    wine winecfg -v win10 >/dev/null 2>&1
    program=$1/windows/msis
    make_command "$program" wine "$1/windows/$name/msis.exe"
    try_server "$1/trial" "$program" serve || die "the server on Windows does not draw: see $1"
    try_resume "$1/windows/resumed" "$program"
    try_windows_names "$1/windows" "$program"
    try_windows_batch "$1/windows" "$program"
    try_windows_input "$1/windows" "$program"
    try_windows_wheel "$@"
    say "Windows under Wine:"
    compare_programs runs_elsewhere "$reference/msis" "$program" "$1/windows/runs" same_numbers || die "what differs is in $1/windows/runs"
    wineserver -k || true
    rm -r "${WINEPREFIX%/*}"
}

series='--kepler-set {1.9E6,0.05,0.7,1.1,0.9,2.0} --epoch 55289 --time-interval [55289:0.001:55289.011] --renderer native
    --width 128 --height 96 --batch --jobs 1 --ephemeris builtin'
single='--position -58.6,-14.5,60000 --time 2010-04-06T20:24:00Z --renderer native --width 64 --height 48 --batch --ephemeris builtin'

# try_resume FOLDER PROGRAM: killed after the second frame, and ended by Ctrl-C after the fourth, the series is finished by the next call.
try_resume() {
    local signal frames=0 run
    mkdir "$1"
    for signal in KILL INT; do
        frames=$((frames + 2))
        # shellcheck disable=SC2086 # words
        (trap - INT && exec "$2" $series --output-dir "$1") >"$1.log" 2>&1 &
        run=$!
        for _ in $(seq 1200); do
            [ "$(find "$1" -name '*.png' | wc -l)" -lt "$frames" ] || break
            sleep 0.1
        done
        kill "-$signal" "$run"
        wait "$run" 2>/dev/null || true
    done
    # shellcheck disable=SC2086 # words
    "$2" $series --output-dir "$1" >"$1.log" 2>&1 || die "a series is not resumed: see $1.log"
    "$2" verify "$1" >"$1.log" 2>&1 || die "a resumed series is not whole: see $1.log"
    [ "$(find "$1" -mindepth 1 | wc -l)" -eq $((2 * 12 + 3)) ] || die "a resumed series leaves other files: see $1"
}

# refused PROGRAM WORDS...: fails in one line, not by a bug.
refused() {
    local text
    text=$("$@" 2>&1) && die "not refused: ${*:2}"
    [[ $text = *'msis: error: '* && $text != *' bug '* ]] || die "refused otherwise: ${*:2}: $text"
}

# Reserved names, colons, folders by drive, by device path, with spaces, of more than 260 characters, names that differ in case.
try_windows_names() { # FOLDER PROGRAM
    local long name place
    long=$(printf 'd%.0s' $(seq 120))
    for name in CON nul com1.x a:b 'a?'; do
        # shellcheck disable=SC2086 # words
        refused "$2" $single --output-dir "$1/names" --output-name "$name"
    done
    for place in 'C:\users\Public\a b' '\\?\C:\users\Public\device' "C:\\$long\\$long\\$long" 'C:/users/Public/slashes'; do
        # shellcheck disable=SC2086 # words
        "$2" $single --output-dir "$place" >"$1/log" 2>&1 || die "$place can't be written to: see $1/log"
    done
    for name in Name NAME; do
        # shellcheck disable=SC2086 # words
        "$2" $single --output-dir "$1/case" --output-name "$name" >"$1/log" 2>&1 || die "names that differ in case: see $1/log"
    done
    "$2" verify "$1/case" >"$1/log" 2>&1 || die "names that differ in case: see $1/log"
}

# A script in pieces, run by the command interpreter.
try_windows_batch() { # FOLDER PROGRAM
    # shellcheck disable=SC2086 # words
    "$2" batchconvert --format bat --pieces 3 --script "$1/pieces.bat" $series --output-dir "$1/pieces" >"$1/log" 2>&1 ||
        die "no batch file: see $1/log"
    (cd "$1" && wine cmd /c pieces.bat) >"$1/log" 2>&1 || die "a batch file does not run: see $1/log"
    "$2" verify "$1/pieces" >"$1/log" 2>&1 || die "a batch file leaves frames out: see $1/log"
    [ "$(find "$1/pieces" -name '*.png' | wc -l)" -eq 12 ] || die "a batch file makes too few frames: see $1/log"
}

# What pip installs holds the program too.
try_windows_wheel() { # FOLDER VERSION
    unpack_wheel "$1/msisf-$2-py3-none-win_amd64.whl" "$1/windows/pip"
    # shellcheck disable=SC2046 # words
    wine "$1/windows/pip/msisf/_installation/msis.exe" $(words_of_trial) --output-dir "$1/windows/pip/out" >"$1/log" 2>&1 ||
        die "the program in the package for pip does not draw on Windows: see $1/log"
    cmp "$1/windows/pip/out/trial.png" "$1/trial/trial.png" || die "the package for pip draws another picture on Windows: see $1"
}

# What people write on Windows has CR LF. A detector's files are FITS, for which there is no library here.
try_windows_input() { # FOLDER PROGRAM
    sed 's/$/\r/' input/data-set.yaml >"$1/data-set.yaml"
    sed '/^detector/,$d; s/$/\r/' input/navigation-camera.yaml >"$1/camera.yaml"
    "$2" dataset "$1/data-set.yaml" --frames 1:1 --output-dir "$1/data" --batch >"$1/log" 2>&1 ||
        die "CR LF in a data set: see $1/log"
    # shellcheck disable=SC2086 # words
    "$2" --camera "$1/camera.yaml" ${single/--width 64 --height 48/} --output-dir "$1/camera" >"$1/log" 2>&1 ||
        die "CR LF in a camera file: see $1/log"
}
