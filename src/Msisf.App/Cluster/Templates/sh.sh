#!/bin/sh
# @HEAD@
# The pieces of a run, one after another: sh FILE. Run again, it makes what is missing. MSIS names another program to run.
set -u

if [ -z "${MSIS:-}" ]; then MSIS=@LAUNCHER@; fi
cd @WORKING_FOLDER@ || exit 2

pieces() {
    cat <<'END'
@PIECES@
END
}

worst=0
for frames in $(pieces); do
    code=0
    "$MSIS" @ARGUMENTS@ --frames "$frames" || code=$?
    [ "$code" -ne 130 ] || exit 130 # ended by the user
    [ "$code" -le "$worst" ] || worst=$code
done
exit "$worst"
