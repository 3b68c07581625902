#!/usr/bin/env bash
# Builds the program into publish/, where ./msis starts it. Builds nothing if publish/ was made from these very sources.
#     scripts/build.sh             as publish/ was built; at first --dotnet
#     scripts/build.sh --dotnet    the program and the .NET that it runs on
#     scripts/build.sh --native    one program for command line and server, compiled ahead of time: starts at once and needs no .NET;
#                                  takes minutes. For processors with AVX2 (x86-64-v3); where this one has AVX-512 (x86-64-v4), a
#                                  second program for those beside it
#     scripts/build.sh --native-all    both of these, whatever this processor has: for packages
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/packages.sh"
. "$root/scripts/lib/dotnet.sh"
cd "$root"

help_if_asked "$@"
usage='Usage: scripts/build.sh [--dotnet | --native | --native-all]'
levels=()
case "${1:-} $#" in
    ' 0') [ ! -r publish/sources ] || read -ra levels <<<"$(cut -d ' ' -f 3- publish/sources)" ;;
    '--dotnet 1') ;;
    '--native 1')
        levels=(x86-64-v3)
        ! grep -qw avx512vl /proc/cpuinfo || levels+=(x86-64-v4)
        ;;
    '--native-all 1') levels=(x86-64-v3 x86-64-v4) ;;
    *) die "unknown arguments: $*. $usage" ;;
esac
[ ${#levels[@]} -eq 0 ] || [ "$(uname -s)-$(uname -m)" = Linux-x86_64 ] ||
    die '--native is for Linux on x86-64: run scripts/build.sh --dotnet.'

# By content: a checkout changes times, and a removed file leaves no newer one behind.
fingerprint_of_sources() (
    shopt -s nullglob
    find src lib/*.dtd Directory.*.props global.json BannedSymbols.txt scripts/build.sh \
        \( -name bin -o -name obj \) -prune -o -type f -print0 |
        LC_ALL=C sort -z | xargs -0 cksum | cksum
)

fingerprint="$(fingerprint_of_sources)${levels[*]:+ ${levels[*]}}"
if [ -x publish/msis ] && [ "$(cat publish/sources 2>/dev/null)" = "$fingerprint" ]; then
    say 'The program is up to date.'
    exit 0
fi

ensure_dotnet
if [ ${#levels[@]} -gt 0 ]; then
    say "Building the program ahead of time (${levels[*]}), which takes minutes ..."
else
    say 'Building the program ...'
fi

# Beside publish/, so that the swap is two renames; a run that is cut off leaves the old program as it was.
fresh=$root/obj/publish-$$
old=$root/obj/published-before-$$
trap 'rm -rf "$fresh" "$old"' EXIT
# linux-x64 is the one system whose compiler package the lock files name. With .NET's own package beside it the program brings .NET along,
# and its first image needs two thirds of the time.
case "${#levels[@]}-$(uname -s)-$(uname -m)" in
    0-Linux-x86_64)
        target=(-r linux-x64 -p:WithFramework=true)
        if ! dotnet restore src/Msisf.Cli "${target[@]}" -v quiet -nologo >/dev/null 2>&1; then
            say 'The package of the .NET runtime is not to be had here: msis uses the .NET of this machine and starts more slowly.'
            target=(-r linux-x64)
        fi
        ;;
    *-Linux-x86_64) target=(-r linux-x64) ;;
    *) target=(-p:PublishReadyToRun=false) ;;
esac

# publish_program PROJECT FOLDER ARGUMENTS...: the analysers judge the sources in test.sh's build.
publish_program() {
    seldom_collecting dotnet publish "src/$1" -c Release -p:RunAnalyzers=false "${@:3}" -o "$2" -v quiet -nologo ||
        die 'the build failed; the messages above say why. publish/ is as it was.'
}

# A program for each level of processors, under its name; msis is the one that runs on most. ./msis chooses.
publish_native() {
    local level
    install_parts compiler cmake static-openssl || die '--native needs them: install them, or run scripts/build.sh --dotnet.'
    for level in "${levels[@]}"; do
        publish_program Msisf.Native "$fresh/$level" "${target[@]}" -p:Native=true -p:IlcInstructionSet="$level"
        mv "$fresh/$level/msisf" "$fresh/msis-$level"
        [ -e "$fresh/wwwroot" ] || mv "$fresh/$level"/{*.so,wwwroot} "$fresh"
        rm -r "${fresh:?}/$level"
    done
    ln -s "msis-${levels[0]}" "$fresh/msis"
}

# The server in a folder of its own, with libraries of its own: those of msis fit the .NET that it brings along, and the server runs on
# that of the machine.
if [ ${#levels[@]} -gt 0 ]; then
    publish_native
else
    publish_program Msisf.Cli "$fresh" "${target[@]}"
    publish_program Msisf.Server "$fresh/server" -p:PublishReadyToRun=false "${target[@]:0:2}"
fi
printf '%s\n' "$fingerprint" >"$fresh/sources"
printf '%s\n' "$DOTNET_ROOT" >"$fresh/dotnet-root"

trap '' INT TERM HUP
[ ! -e publish ] || mv publish "$old"
mv "$fresh" publish || { mv "$old" publish && exit 1; }
