#!/usr/bin/env bash
# Suite: the xunit projects that are named, or all of them; built by test.sh before.
set -euo pipefail
. scripts/lib/common.sh
. scripts/lib/dotnet.sh
. scripts/lib/results.sh

reports=$PWD/TestResults
seconds_a_project=1800 # a run that hangs must end before the machine's own limit ends it without a count

# run_project NAME: a host that crashes or hangs leaves a report without its tests, so its exit code counts too. The command line is tested
# as packages have it, where it is compiled ahead of time.
run_project() {
    local project=$1 assembly=tests/$1/bin/Debug/net10.0/$1.dll program=() code=0
    if [ "$project" = Msisf.Cli.Tests ] && compgen -G 'publish/msis-x86-64-*' >/dev/null; then
        program=("MSISF_PROGRAM=$PWD/msis")
    fi
    rm -f "$reports/$project.trx"
    # a broken build may leave an assembly of an earlier one, whose results would say nothing of these sources
    if [ ! -e "$assembly" ] || [ -n "${MSISF_BUILD_FAILED:-}" ]; then
        record skipped "$project" 'all tests (missing: the build)'
        return 0
    fi
    within "$seconds_a_project" env "${program[@]}" dotnet test "$assembly" --logger "trx;LogFileName=$project.trx" --results-directory "$reports" ||
        code=$?
    record_report "$project" "$reports/$project.trx"
    if [ "$code" -ne 0 ] && [ "$(count failed "$project")" -eq 0 ]; then
        record failed "$project" "the test host ended early, with exit code $code"
    elif [ "$(awk -F '\t' -v suite="$project" '$2 == suite' "$MSISF_RESULTS" | wc -l)" -eq 0 ]; then
        record failed "$project" 'no test was found'
    fi
}

if [ $# -eq 0 ]; then
    # shellcheck disable=SC2046 # names without blanks
    set -- $(test_projects)
fi
for project in "$@"; do
    run_project "$project"
done
