#!/usr/bin/env bash
# Suite: the set-up scripts themselves. Every function test_* of tests/scripts/*.test.sh runs in a shell and an empty
# folder of its own; exit code 77 means skipped, and the last line printed then says why. Two files run at a time.
# scripts.sh [FILE ...]: these files only, one after the other.
set -euo pipefail
. scripts/lib/common.sh
. scripts/lib/results.sh

export MSISF_TESTED_ROOT=$PWD

run_test() {
    local file=$1 test=$2 folder log code=0
    folder=$(mktemp -d)
    log=$folder.log
    # the folders that a test works in have a space in their path, as a user's may
    mkdir "$folder/a b"
    # shellcheck disable=SC2016 # expanded by the inner shell
    (cd "$folder/a b" && within 600 bash -euo pipefail -c '. "$1" && "$2"' "$test" "$MSISF_TESTED_ROOT/$file" "$test") \
        >"$log" 2>&1 </dev/null || code=$?
    case $code in
        0) record passed scripts "$test" ;;
        77) record skipped scripts "$test ($(tail -n 1 "$log"))" ;;
        *)
            record failed scripts "$test"
            say "--- $test ended with exit code $code:"
            cat "$log"
            ;;
    esac
    rm -rf "$folder" "$log"
}

if [ $# -eq 0 ]; then
    printf '%s\n' tests/scripts/*.test.sh | xargs -P 2 -n 1 bash scripts/suites/scripts.sh
    exit
fi
for file in "$@"; do
    while IFS= read -r test; do
        run_test "$file" "$test"
    done < <(sed -n 's/^\(test_[A-Za-z0-9_]*\)().*/\1/p' "$file")
done
