# shellcheck shell=bash
# shellcheck disable=SC2154 # targets.sh sets target_levels
# Sourced by release.sh: tries the packages by what users do with them.

. "$root/scripts/lib/bare-root.sh"
. "$root/scripts/lib/same-bytes.sh"
. "$root/scripts/lib/sysroot.sh"
. "$root/scripts/lib/foreign.sh"

# test_release FOLDER VERSION SYSTEM...: FOLDER has the packages, and keeps what is wrong.
test_release() {
    local system
    find_dotnet || die '.NET is missing: run scripts/build.sh --dotnet'
    dotnet publish src/Msisf.Cli -c Release -p:RunAnalyzers=false -p:PublishReadyToRun=false -o "$1/jit" -v quiet -nologo ||
        die 'the build on .NET failed; the messages above say why.'
    # shellcheck disable=SC2046 # words
    "$1/jit/msis" $(words_of_trial) --output-dir "$1/trial" >/dev/null 2>&1
    for system in "${@:3}"; do
        read_target "$system"
        case $system in
            linux-x64)
                try_own_packages "$1" "$2"
                compare_levels "$1"
                ;;
            linux-arm64) try_arm "$1" "$2" ;;
            win-x64) try_windows "$1" "$2" ;;
            any) try_tool_of_any "$1" "$2" ;;
            *) say "missing: a machine to try $system on" ;;
        esac
    done
}

# Archive, Debian package, package for pip and .NET tool, each in a root file system of its own.
try_own_packages() {
    local name=msisf-$2-linux-x64 pictures=(trial.png trial.annotated.png) kind
    for kind in archive deb pip tool; do
        make_bare_root "$1/$kind"
    done
    mkdir "$1/archive/opt"
    tar -xzf "$1/$name.tar.gz" -C "$1/archive/opt"
    try_package "$1/archive" "/opt/$name/msis" "$1/trial" "${pictures[@]}" || die "the archive does not draw: see $1"

    dpkg-deb -x "$1/msisf_$2_amd64.deb" "$1/deb"
    try_package "$1/deb" msis "$1/trial" "${pictures[@]}" || die "the Debian package does not draw: see $1"

    add_python "$1/pip"
    unpack_wheel "$1/msisf-$2-py3-none-manylinux_2_34_x86_64.whl" "$1/pip/usr/lib/python3/dist-packages"
    try_package "$1/pip" /usr/lib/python3/dist-packages/bin/msis "$1/trial" "${pictures[@]}" || die "the package for pip does not draw: see $1"
    try_python "$1" "$1/pip"

    install_tool "$1" "$2" "$1/tool/opt"
    try_package "$1/tool" /opt/msis "$1/trial" "${pictures[@]}" || die "the .NET tool does not draw: see $1"
    # shellcheck disable=SC2046 # words
    NUGET_PACKAGES=$1/nuget DOTNET_CLI_HOME=$1 dotnet dnx msisf --yes --source "$1" $(words_of_trial) --output-dir "$1/dnx" >"$1/tool/log" 2>&1 ||
        die "dnx fails: see $1/tool/log"
    cmp "$1/dnx/trial.png" "$1/trial/trial.png" || die "dnx draws another picture: see $1"
    say 'Archive, Debian package, package for pip and .NET tool draw and serve with the C library alone.'
}

# The tool as it is on a system without a package of its own: on the .NET of the machine.
try_tool_of_any() { # FOLDER VERSION
    mkdir "$1/any"
    cp "$1/msisf.any.$2.nupkg" "$1/any"
    python3 scripts/lib/archives.py tools "$1/any" "$2" any
    install_tool "$1/any" "$2" "$1/any/opt"
    # shellcheck disable=SC2046 # words
    "$1/any/opt/msis" $(words_of_trial) --output-dir "$1/any/out" >"$1/any/log" 2>&1 || die "the .NET tool for any system fails: see $1/any/log"
    diff -rq "$1/any/out" "$1/trial" --exclude=here || die "the .NET tool for any system draws another picture: see $1"
    try_server "$1/trial" "$1/any/opt/msis" serve || die "the server of the .NET tool for any system does not draw: see $1"
    say 'The .NET tool for any system draws and serves on the .NET of this machine.'
}

# install_tool SOURCE VERSION FOLDER: from that source alone, and not from what an earlier try has left among this user's packages.
install_tool() {
    NUGET_PACKAGES=$1/nuget DOTNET_CLI_HOME=$1 dotnet tool install msisf --version "$2" --source "$1" --tool-path "$3" >"$1/tool.log" ||
        die "dotnet tool install fails: see $1/tool.log"
}

# unpack_wheel WHEEL FOLDER: as pip does for the system that the wheel is for.
unpack_wheel() {
    local platform=${1##*-none-}
    install_parts pip || die 'pip is needed to try its package.'
    /usr/bin/python3 -m pip install --quiet --root-user-action=ignore --no-index --no-deps --only-binary :all: --platform "${platform%.whl}" \
        --target "$2" "$1" || die "pip can't install $1"
}

try_python() { # FOLDER ROOT
    within_root "$2" python3 -c "$(python_trial)" || die "import msisf does not draw: see $1"
    cmp "$2/tmp/python.png" "$1/trial/trial.png" || die "import msisf draws another picture: see $1"
}

# The picture of the trial, as a client of Python gets it; on a busy machine under qemu in more than a minute.
python_trial() {
    cat <<'PYTHON'
import msisf
with msisf.Moon(serve=["--max-seconds", "600"], timeout=600) as moon:
    moon.render((-58.6, -14.5, 60000), time="2010-04-06T20:24:00Z", nadir=True, width=320, height=240).save("/tmp/python.png")
PYTHON
}

# The programs stand in this tree, so that they name the same files. Each is judged by the tests of the command line too, and writes what
# the one on .NET writes.
compare_levels() {
    local level program
    dotnet build tests/Msisf.Cli.Tests -p:Optimize=true -p:RunAnalyzers=false -v quiet -nologo || die 'the tests of the command line are not built.'
    for level in $target_levels; do
        if [ "$level" = x86-64-v4 ] && ! grep -qw avx512vl /proc/cpuinfo; then
            say "missing: a processor with AVX-512, so $level is not tried"
            continue
        fi
        program=$root/obj/programs/linux-x64/msis-$level
        MSISF_PROGRAM=$program dotnet test tests/Msisf.Cli.Tests/bin/Debug/net10.0/Msisf.Cli.Tests.dll >"$1/$level.log" ||
            die "the tests of the command line fail on $level: see $1/$level.log"
        say "$level passes the tests of the command line. $level and .NET's JIT:"
        compare_programs runs_to_compare "$1/jit/msis" "$program" "$1/$level" same_bytes || die "what differs is in $1/$level"
    done
}
