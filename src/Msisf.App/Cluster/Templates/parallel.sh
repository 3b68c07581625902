#!/bin/sh
# @HEAD@
# The pieces of a run by GNU parallel: sh FILE [JOBS]. JOBS pieces at once, by default one a core; they share the cores.
# Run again, it makes what is missing. MSIS names another program to run.
set -u

if [ -z "${MSIS:-}" ]; then MSIS=@LAUNCHER@; fi
script=$(cd "$(dirname "$0")" && pwd -P)/$(basename "$0")
cd @WORKING_FOLDER@ || exit 2

pieces() {
    cat <<'END'
@PIECES@
END
}

# parallel runs this script again for each piece: so no name passes through its quoting.
if [ "${1:-}" = --piece ]; then
    exec "$MSIS" @ARGUMENTS@ @JOBS@ --frames "$2"
fi

cores=$(nproc 2>/dev/null || getconf _NPROCESSORS_ONLN)
jobs=${1:-$cores}
case $jobs in
    '' | *[!0-9]* | 0*) echo "usage: sh $0 [JOBS]: pieces at once, a whole number from 1" >&2; exit 1 ;;
esac
command -v parallel >/dev/null || { echo "$0: GNU parallel is missing (Debian, Ubuntu: apt install parallel)" >&2; exit 3; }

threads=$((cores > jobs ? cores / jobs : 1))
export MSIS MSISF_PIECES="$script" MSISF_JOBS="$threads" DOTNET_PROCESSOR_COUNT="$threads" PARALLEL_SHELL=/bin/sh
failed=0
# shellcheck disable=SC2016 # expanded by the shell that runs the piece
pieces | parallel --joblog "$script.joblog" --resume-failed --jobs "$jobs" 'sh "$MSISF_PIECES" --piece {}' || failed=$?

unset DOTNET_PROCESSOR_COUNT
code=0
"$MSIS" verify @OUTPUT_FOLDER@ || code=$?
if [ "$code" -ne 0 ] && [ "$failed" -eq 0 ]; then
    rm -f "$script.joblog" # all pieces ended well and frames are missing all the same: next time each is looked at again
fi
exit "$code"
