#!/usr/bin/env bash
# Sets up what the tests need and runs every suite. As root, or as a user with sudo; can be run again.
# The last line is "N passed, N failed" or "N passed, N failed, N skipped". A part that is missing skips its tests by
# name; with CI=true that fails the run.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/packages.sh"
. "$root/scripts/lib/dotnet.sh"
. "$root/scripts/lib/results.sh"
cd "$root"
require_own_folders

# The suites in their order: scripts/suites/NAME.sh. A new one is added here, and what it needs to install_parts below.
suites=(style scripts xunit php)

MSISF_RESULTS=$(mktemp)
export MSISF_RESULTS
trap 'rm -f "$MSISF_RESULTS"' EXIT

install_parts povray cairo cfitsio fitsverify astropy gdal matplotlib downloader certificates xmllint shellcheck php phpunit mariadbd slurm parallel ||
    warn 'going on without them: their tests are skipped'
ensure_dotnet

check build 'dotnet build' dotnet build MSISF.sln -v quiet -nologo
check build 'scripts/build.sh' scripts/build.sh
scripts/get-ldem.sh --real-only || warn 'going on without the elevation model: its tests are skipped'
scripts/get-cspice.sh || warn 'going on without CSPICE: its tests are skipped'

for suite in "${suites[@]}"; do
    say "== $suite"
    bash "scripts/suites/$suite.sh" </dev/null || record failed "$suite" 'the suite itself ended early'
done

summarise
