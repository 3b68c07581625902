#!/usr/bin/env bash
# Suite: PHPUnit on tests/php. Started by test.sh in the repository root.
set -euo pipefail
. scripts/lib/common.sh
. scripts/lib/results.sh

[ -d tests/php ] || exit 0
if ! have phpunit; then
    record skipped php 'all tests (missing: phpunit)'
    exit 0
fi

report=$PWD/TestResults/php.xml
code=0
mkdir -p "${report%/*}"
rm -f "$report"
# A run that hangs must end before the machine's own limit ends it without a count.
within 1800 phpunit --configuration tests/php/phpunit.xml --log-junit "$report" || code=$?
record_report php "$report"
# Warnings and risky tests fail a run too, and are no failure in the report.
if [ "$code" -ne 0 ] && [ "$(count failed php)" -eq 0 ]; then
    record failed php "phpunit ended with exit code $code"
fi
