#!/usr/bin/env bash
# Sets up what the tests need and runs every suite. As root, or as a user with sudo; can be run again.
# The last line is "N passed, N failed" or "N passed, N failed, N skipped". A part that is missing skips its tests by
# name; with CI=true that fails the run. tests/README.md says how to run single tests, and the long ones.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/packages.sh"
. "$root/scripts/lib/dotnet.sh"
. "$root/scripts/lib/results.sh"
. "$root/scripts/lib/data.sh"
help_if_asked "$@"
[ $# -eq 0 ] || die "unknown argument $1. Usage: ./test.sh; tests/README.md says how to run single tests"
cd "$root"
require_own_folders
end_with_children

# The suites, scripts/suites/NAME.sh; of xunit each project by itself. The longest first, so that none runs alone at the
# end. A new suite is added here, and what it needs to install_parts below; a new project is found by itself.
early=('xunit Msisf.Core.Tests' 'xunit Msisf.App.Tests' 'xunit Msisf.Adapters.Tests' style) # need no published program
suites=('xunit Msisf.Stress.Tests' php scripts 'xunit Msisf.Integration.Tests' 'xunit Msisf.Viewer.Tests' 'xunit Msisf.Server.Tests' python)
for project in $(test_projects); do
    [[ " ${early[*]} ${suites[*]} " == *" $project "* ]] || suites+=("xunit $project")
done

# run_suites NUMBER SUITE...: so many at a time. Each shows its output when it has ended.
run_suites() {
    printf '%s\n' "${@:2}" | xargs -P "$1" -I '{}' bash scripts/lib/run-suite.sh '{}' || true
}

MSISF_RESULTS=$(mktemp)
export MSISF_RESULTS
trap 'rm -rf "$MSISF_RESULTS" "$MSISF_RESULTS".*' EXIT

# One compiler for all projects, also where the environment says otherwise: a fresh one for each takes twice as long.
export UseSharedCompilation=true
# Optimized, or the tests take twice as long; the assertions of debug builds stay.
build_all() { seldom_collecting check build 'dotnet build' dotnet build MSISF.sln -v quiet -nologo -p:Optimize=true; }

# While packages are unpacked the cores have little to do: where .NET is there already, the build begins beside it.
build=''
if find_dotnet && part_is_here icu && part_is_here certificates; then
    build_all &
    build=$!
fi
install_parts povray cfitsio fitsverify astropy gdal matplotlib numpy pytest torch zmq g++ pip downloader certificates xmllint shellcheck php phpunit mariadbd slurm parallel ||
    warn 'going on without them: their tests are skipped'
install_parts chromium || warn 'going on without it: the tests of the viewer are skipped'
install_parts octave || warn 'going on without it: the tests of the client in MATLAB are skipped'
ensure_dotnet
if [ -n "$build" ]; then
    wait "$build"
else
    build_all
fi
note_failed_build() {
    if [ "$(count failed build)" -gt 0 ]; then
        export MSISF_BUILD_FAILED=1
    fi
}
note_failed_build
msis=(dotnet src/Msisf.Cli/bin/Debug/net10.0/msis.dll)
fetch_data ldem || warn 'going on without the elevation model: its tests are skipped'
scripts/get-cspice.sh || warn 'going on without CSPICE: its tests are skipped'
# Before any test: one of them installs it, and images drawn before and after would differ.
fetch_data albedo || warn 'going on without a map of the reflectance'
run_suites 2 "${early[@]}" &
# What is there is built as it was; at first ahead of time, as for packages, where that can be done: a start costs a fifth, and the tests make
# hundreds.
kind=()
if [ ! -e publish/sources ] && [ "$(uname -s)-$(uname -m)" = Linux-x86_64 ] && install_parts compiler cmake static-openssl; then
    kind=(--native)
fi
seldom_collecting check build 'scripts/build.sh' scripts/build.sh "${kind[@]}"
note_failed_build
dotnet build-server shutdown --vbcscompiler >/dev/null 2>&1 || true # it would stay for ten minutes, with its memory

# Side by side, two more than there are cores: many tests wait for other programs.
say "Running ${#suites[@]} more suites side by side; each shows its output when it has ended."
# In the background, so that a signal is heard at once; with job control, or the programs under test would ignore Ctrl-C.
set -m
run_suites $(($(getconf _NPROCESSORS_ONLN) + 2)) "${suites[@]}" &
set +m
wait
for suite in "${early[@]}" "${suites[@]}"; do
    cat "$MSISF_RESULTS.$suite" >>"$MSISF_RESULTS" || record failed "$suite" 'it was not started'
done

summarise
