#!/usr/bin/env bash
# Suite: the form of the C# sources and of the shell scripts. Started by test.sh in the repository root.
set -euo pipefail
. scripts/lib/common.sh
. scripts/lib/results.sh

# The rules of style and of the analysers are errors of the build; this is what remains of dotnet format.
# Without a second compilation of what is used often: it takes half the time.
DOTNET_TieredCompilation=0 check style 'dotnet format whitespace' dotnet format whitespace . --folder --verify-no-changes --include src/ tests/

scripts=(msis quickstart.sh test.sh benchmark.sh .ci/run scripts/*.sh scripts/*/*.sh tests/scripts/*.sh)
if have shellcheck; then
    check style shellcheck shellcheck -x "${scripts[@]}"
else
    record skipped style 'shellcheck (missing: shellcheck)'
fi
