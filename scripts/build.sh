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

# add_mysql_connector FOLDER: puts the package MySqlConnector beside the program in FOLDER. Not every registry has it.
add_mysql_connector() {
    local files=$root/obj/mysql-$$
    if MSBUILDDISABLENODEREUSE=1 dotnet publish src/Msisf.MySql.Package -c Release -o "$files" -v quiet -nologo >/dev/null 2>&1 &&
        [ -e "$files/MySqlConnector.dll" ]; then
        rm -rf "$1/mysql"
        mv "$files" "$1/mysql"
    else
        rm -rf "$files"
        return 1
    fi
}

fingerprint=$(fingerprint_of_sources)
if [ -x publish/msis ] && [ "$(cat publish/sources 2>/dev/null)" = "$fingerprint" ]; then
    say 'The program is up to date.'
    # Made where the package was not to be had, it gets it as soon as there is one: that takes no build.
    if [ ! -e publish/mysql/MySqlConnector.dll ] && find_dotnet && add_mysql_connector publish; then
        say 'MySqlConnector has become available: msis patterns --source mysql works now.'
    fi
    exit 0
fi

ensure_dotnet
say 'Building the program ...'

# Native code ahead of time is for the one system whose compiler package the lock files name.
case "$(uname -s)-$(uname -m)" in
    Linux-x86_64) target=(-r linux-x64) ;;
    *) target=(-p:PublishReadyToRun=false) ;;
esac

# Beside publish/, so that the swap is two renames; a run that is cut off leaves the old program as it was.
fresh=$root/obj/publish-$$
old=$root/obj/published-before-$$
trap 'rm -rf "$fresh" "$old" "${server:-$fresh}"' EXIT
# The analysers judge the sources in test.sh's build.
dotnet publish src/Msisf.Cli -c Release -p:RunAnalyzers=false "${target[@]}" -o "$fresh" -v quiet -nologo ||
    die 'the build failed; the messages above say why. publish/ is as it was.'
# The server runs on the same libraries, compiled ahead of time once: only what it has beside them is added.
server=$root/obj/server-$$
dotnet publish src/Msisf.Server -c Release -p:RunAnalyzers=false -p:PublishReadyToRun=false "${target[@]:0:2}" -o "$server" -v quiet -nologo ||
    die 'the build of the server failed; the messages above say why. publish/ is as it was.'
cp -rn "$server/." "$fresh/"
rm -rf "$server"
add_mysql_connector "$fresh" ||
    say 'The package MySqlConnector is not to be had here: msis patterns --source mysql is left out (scripts/generate_pattern.php is not).'
printf '%s\n' "$fingerprint" >"$fresh/sources"
printf '%s\n' "$DOTNET_ROOT" >"$fresh/dotnet-root"

trap '' INT TERM HUP
[ ! -e publish ] || mv publish "$old"
mv "$fresh" publish || { mv "$old" publish && exit 1; }
