#!/usr/bin/env bash
# Builds the program into publish/, where ./msis starts it. Builds nothing if publish/ was made from these very sources.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/packages.sh"
. "$root/scripts/lib/dotnet.sh"
cd "$root"

# By content: a checkout changes times, and a removed file leaves no newer one behind.
fingerprint_of_sources() (
    shopt -s nullglob
    find src lib/*.dtd Directory.*.props global.json BannedSymbols.txt scripts/build.sh \
        \( -name bin -o -name obj \) -prune -o -type f -print0 |
        LC_ALL=C sort -z | xargs -0 cksum | cksum
)

fingerprint=$(fingerprint_of_sources)
if [ -x publish/msis ] && [ "$(cat publish/sources 2>/dev/null)" = "$fingerprint" ]; then
    say 'The program is up to date.'
    exit 0
fi

ensure_dotnet
say 'Building the program ...'

# Native code ahead of time is for the one system whose compiler package the lock files name. With .NET's own package beside it the
# program brings .NET along, and its first image needs two thirds of the time.
case "$(uname -s)-$(uname -m)" in
    Linux-x86_64)
        target=(-r linux-x64 -p:WithFramework=true)
        if ! dotnet restore src/Msisf.Cli "${target[@]}" -v quiet -nologo >/dev/null 2>&1; then
            say 'The package of the .NET runtime is not to be had here: msis uses the .NET of this machine and starts more slowly.'
            target=(-r linux-x64)
        fi
        ;;
    *) target=(-p:PublishReadyToRun=false) ;;
esac

# Beside publish/, so that the swap is two renames; a run that is cut off leaves the old program as it was.
fresh=$root/obj/publish-$$
old=$root/obj/published-before-$$
trap 'rm -rf "$fresh" "$old"' EXIT
# The analysers judge the sources in test.sh's build.
seldom_collecting dotnet publish src/Msisf.Cli -c Release -p:RunAnalyzers=false "${target[@]}" -o "$fresh" -v quiet -nologo ||
    die 'the build failed; the messages above say why. publish/ is as it was.'
# In a folder of its own, with libraries of its own: those of msis fit the .NET that it brings along, and the server runs on that of the machine.
seldom_collecting dotnet publish src/Msisf.Server -c Release -p:RunAnalyzers=false -p:PublishReadyToRun=false "${target[@]:0:2}" -o "$fresh/server" -v quiet -nologo ||
    die 'the build of the server failed; the messages above say why. publish/ is as it was.'
printf '%s\n' "$fingerprint" >"$fresh/sources"
printf '%s\n' "$DOTNET_ROOT" >"$fresh/dotnet-root"

trap '' INT TERM HUP
[ ! -e publish ] || mv publish "$old"
mv "$fresh" publish || { mv "$old" publish && exit 1; }
