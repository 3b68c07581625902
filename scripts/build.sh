#!/usr/bin/env bash
# Builds the program into publish/, where ./msis starts it. Builds nothing if publish/ was made from these very sources.
#     scripts/build.sh             as publish/ was built; at first --dotnet
#     scripts/build.sh --dotnet    the program and the .NET that it runs on
#     scripts/build.sh --native    one program for command line and server, compiled ahead of time: starts at once and needs no .NET;
#                                  takes minutes. For processors such as this one: with AVX-512 (x86-64-v4), or with AVX2 (x86-64-v3)
#     scripts/build.sh --native-all    a program for each of these
#     scripts/build.sh --for NAME  the program of the packages for a system, e.g. win-x64, into obj/programs/NAME
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/packages.sh"
. "$root/scripts/lib/dotnet.sh"
. "$root/scripts/lib/targets.sh"
. "$root/scripts/lib/sysroot.sh"
. "$root/scripts/lib/publish.sh"
cd "$root"

help_if_asked "$@"
usage='Usage: scripts/build.sh [--dotnet | --native | --native-all | --for NAME]'
output=publish
system=''
levels=()
case "${1:-} $#" in
    ' 0') [ ! -r publish/sources ] || read -ra levels <<<"$(cut -d ' ' -f 3- publish/sources)" ;;
    '--dotnet 1') ;;
    '--native 1')
        levels=(x86-64-v3)
        ! grep -qw avx512vl /proc/cpuinfo || levels=(x86-64-v4)
        ;;
    '--native-all 1') levels=(x86-64-v3 x86-64-v4) ;;
    '--for 2')
        system=$2
        read_target "$system" || die "unknown system: $system. Choose one of: $(names_of_targets | paste -sd ' ')"
        read -ra levels <<<"$target_levels"
        output=obj/programs/$system
        ;;
    *) die "unknown arguments: $*. $usage" ;;
esac
[ ${#levels[@]} -eq 0 ] || [ "$(uname -s)-$(uname -m)" = Linux-x86_64 ] ||
    die 'programs are compiled ahead of time on Linux on x86-64 only: run scripts/build.sh --dotnet.'

# By content: a checkout changes times, and a removed file leaves no newer one behind.
fingerprint_of_sources() (
    shopt -s nullglob
    find src lib/*.dtd Directory.*.props global.json BannedSymbols.txt scripts/build.sh scripts/lib/publish.sh \
        \( -name bin -o -name obj \) -prune -o -type f -print0 |
        LC_ALL=C sort -z | xargs -0 cksum | cksum
)

fingerprint="$(fingerprint_of_sources)${levels[*]:+ ${levels[*]}}"
if [ -e "$output/sources" ] && [ "$(cat "$output/sources")" = "$fingerprint" ]; then
    say 'The program is up to date.'
    exit 0
fi

ensure_dotnet
if [ ${#levels[@]} -gt 0 ]; then
    say "Building the program ahead of time (${levels[*]}), which takes minutes ..."
else
    say "Building the program${system:+ for $system} ..."
fi

# Beside the old program, so that the swap is two renames; a run that is cut off leaves the old one as it was.
fresh=$root/obj/publish-$$
old=$root/obj/published-before-$$
trap 'rm -rf "$fresh" "$old"' EXIT
if [ ${#levels[@]} -gt 0 ]; then
    publish_native "${system:-linux-x64}" "$fresh" "${levels[@]}"
elif [ -n "$system" ]; then
    publish_with_jit "$system" "$fresh"
else
    publish_on_dotnet "$fresh"
    printf '%s\n' "$DOTNET_ROOT" >"$fresh/dotnet-root"
fi
printf '%s\n' "$fingerprint" >"$fresh/sources"

trap '' INT TERM HUP
[ -z "$system" ] || mkdir -p obj/programs
[ ! -e "$output" ] || mv "$output" "$old"
mv "$fresh" "$output" || { mv "$old" "$output" && exit 1; }
