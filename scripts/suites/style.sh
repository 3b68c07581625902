#!/usr/bin/env bash
# Suite: the form of the C# sources and of the shell scripts. Started by test.sh in the repository root.
set -euo pipefail
. scripts/lib/common.sh
. scripts/lib/results.sh

check style 'dotnet format' dotnet format MSISF.sln --verify-no-changes --no-restore

scripts=(msis quickstart.sh test.sh benchmark.sh .ci/run scripts/*.sh scripts/*/*.sh tests/scripts/*.sh)
if have shellcheck; then
    check style shellcheck shellcheck -x "${scripts[@]}"
else
    record skipped style 'shellcheck (missing: shellcheck)'
fi
