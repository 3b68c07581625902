# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"
. "$MSISF_TESTED_ROOT/scripts/lib/common.sh"
. "$MSISF_TESTED_ROOT/scripts/lib/results.sh"
export MSISF_RESULTS=$PWD/results
: >"$MSISF_RESULTS"
unset CI

test_results_trx_counts_every_test_and_gives_the_reason_of_a_skipped_one() {
    cat >report.trx <<'REPORT'
<?xml version="1.0"?><TestRun><Results>
<UnitTestResult testId="1" testName="Good(s: &quot;a&lt;b&gt; outcome=\&quot;Failed\&quot;&quot;)" duration="1" outcome="Passed" />
<UnitTestResult testId="2" testName="Bad" outcome="Failed"><Output><ErrorInfo><Message>x &lt; y</Message></ErrorInfo></Output></UnitTestResult>
<UnitTestResult testId="3" testName="Away" outcome="NotExecuted"><Output><ErrorInfo><Message>missing: PovRay</Message></ErrorInfo></Output></UnitTestResult>
<UnitTestResult testId="4" testName="Lost" outcome="Aborted" />
</Results><ResultSummary><Counters total="4" passed="1" failed="9" notExecuted="0" /></ResultSummary></TestRun>
REPORT
    record_report Suite report.trx
    assert_same "$(count passed) $(count failed) $(count skipped)" '1 2 1'
    grep -q "^skipped	Suite	Away (missing: PovRay)$" results || fail "$(cat results)"
    grep -q '^passed	Suite	Good(s: "a<b> outcome=\\"Failed\\"")$' results || fail "$(cat results)"
}

test_results_junit_counts_every_test() {
    cat >report.xml <<'REPORT'
<?xml version="1.0"?><testsuites><testsuite name="" tests="4" errors="1" failures="1" skipped="1">
<testcase name="a" class="T" assertions="1" time="0.1"/>
<testcase name="b" class="T"><failure type="E">T::b failed: &lt;skipped/&gt;</failure></testcase>
<testcase name="c with data set &quot;x&quot;" class="T"><skipped/></testcase>
<testcase name="d" class="T"><error type="E">boom</error></testcase>
</testsuite></testsuites>
REPORT
    record_report php report.xml
    assert_same "$(count passed) $(count failed) $(count skipped)" '1 2 1'
}

test_results_last_line_and_exit_code() {
    run summarise
    assert_code 1
    assert_same "${output##*$'\n'}" '0 passed, 0 failed'
    record passed A one
    run summarise
    assert_code 0
    assert_same "${output##*$'\n'}" '1 passed, 0 failed'
    record skipped B two
    run summarise
    assert_code 0
    assert_says 'skipped: B: two'
    assert_same "${output##*$'\n'}" '1 passed, 0 failed, 1 skipped'
    CI=true run summarise
    assert_code 1
    record failed B three
    run summarise
    assert_code 1
    assert_says 'FAILED: B: three'
    assert_same "${output##*$'\n'}" '1 passed, 1 failed, 1 skipped'
}

# An xunit suite of one built project, whose test host does as the stand-in for dotnet says.
run_xunit_suite() {
    mkdir -p tests/X.Tests/bin/Debug/net10.0
    echo 'Microsoft.NET.Test.Sdk' >tests/X.Tests/X.Tests.csproj
    : >tests/X.Tests/bin/Debug/net10.0/X.Tests.dll
    cp -R "$MSISF_TESTED_ROOT/scripts" .
    make_executable bin/dotnet
    PATH="$PWD/bin:$PATH" run bash scripts/suites/xunit.sh
}

test_results_test_host_that_crashes_is_a_failure() {
    run_xunit_suite <<'HOST'
#!/bin/sh
exit 134
HOST
    assert_same "$(cat results)" 'failed	X.Tests	the test host ended early, with exit code 134'
}

test_results_broken_build_skips_the_tests_of_an_earlier_one() {
    export MSISF_BUILD_FAILED=1
    run_xunit_suite <<'HOST'
#!/bin/sh
exit 0
HOST
    assert_same "$(tail -n 1 results)" 'skipped	X.Tests	all tests (missing: the build)'
}

test_results_project_without_a_test_is_a_failure() {
    run_xunit_suite <<'HOST'
#!/bin/sh
exit 0
HOST
    assert_same "$(cat results)" 'failed	X.Tests	no test was found'
}

# One suite beside others, as test.sh starts it; the suite is standard input.
run_suite() {
    mkdir -p scripts/suites
    cp -R "$MSISF_TESTED_ROOT/scripts/lib" scripts
    cat >scripts/suites/fake.sh
    run bash scripts/lib/run-suite.sh "$1"
}

test_results_of_a_suite_beside_others_go_to_a_file_of_their_own() {
    run_suite 'fake One.Tests' <<'SUITE'
. scripts/lib/results.sh
echo "tested $1"
record passed "$1" first
SUITE
    assert_code 0
    assert_says '== fake One.Tests: '
    assert_says 'tested One.Tests'
    assert_same "$(cat results)" ''
    assert_same "$(cat 'results.fake One.Tests')" 'passed	One.Tests	first'
}

test_results_of_a_suite_that_ends_early_are_a_failure() {
    run_suite fake <<'SUITE'
echo 'half done'
exit 3
SUITE
    assert_code 0
    assert_says 'half done'
    assert_same "$(cat results.fake)" 'failed	fake	the suite itself ended early'
}
