#!/usr/bin/env bash
# run-suite.sh 'NAME [PROJECT]': one suite, which test.sh starts beside others. Its output is shown in one piece when it
# has ended, with the seconds that it took and its processor time; its results go to a file of their own.
set -euo pipefail
. scripts/lib/common.sh
. scripts/lib/results.sh

read -r name project <<<"$1"
export MSISF_RESULTS="$MSISF_RESULTS.$1"
: >"$MSISF_RESULTS"
bash "scripts/suites/$name.sh" ${project:+"$project"} </dev/null >"$MSISF_RESULTS.log" 2>&1 ||
    record failed "${project:-$name}" 'the suite itself ended early'
times >"$MSISF_RESULTS.times"
say "== $1: $SECONDS s, processor $(tail -1 "$MSISF_RESULTS.times")"
cat "$MSISF_RESULTS.log"
