# shellcheck shell=bash
# Sourced by the suites after common.sh. Results are lines of "outcome<TAB>suite<TAB>test" in the file $MSISF_RESULTS,
# so that a suite is counted by what it reports, test by test, and not by the sums that some tool prints.

# record passed|failed|skipped SUITE TEST
record() { printf '%s\t%s\t%s\n' "$1" "$2" "$3" >>"$MSISF_RESULTS"; }

# check SUITE TEST COMMAND...: a check that is one command.
check() {
    local suite=$1 test=$2
    shift 2
    if "$@"; then
        record passed "$suite" "$test"
    else
        record failed "$suite" "$test"
    fi
}

# count OUTCOME [SUITE]: how many tests of the suite, or of all, ended so.
count() {
    awk -F '\t' -v outcome="$1" -v suite="${2:-}" \
        '$1 == outcome && (suite == "" || $2 == suite) { n++ } END { print n + 0 }' "$MSISF_RESULTS"
}

# record_report SUITE FILE: every test of a trx (dotnet) or JUnit (PHPUnit) report; nothing if the file is not there.
# Attribute values cannot hold a bare '<' or '"', so one record a '<' is one element, whatever a test is named.
record_report() {
    [ -e "$2" ] || return 0
    awk -v RS='<' -v suite="$1" '
        function attribute(name) {
            return match($0, "[ \t\n]" name "=\"[^\"]*\"") ? substr($0, RSTART + length(name) + 3, RLENGTH - length(name) - 4) : ""
        }
        function plain(text) {
            gsub(/&quot;/, "\"", text); gsub(/&lt;/, "<", text); gsub(/&gt;/, ">", text)
            gsub(/&#x?[0-9A-Fa-f]+;|[\t\n]/, " ", text); gsub(/&amp;/, "\\&", text)
            return text
        }
        function flush() { if (test != "") print outcome "\t" suite "\t" test; test = "" }
        /^UnitTestResult[ \t\n]/ {
            flush(); test = plain(attribute("testName")); outcome = attribute("outcome")
            outcome = outcome == "Passed" ? "passed" : outcome == "NotExecuted" ? "skipped" : "failed"
        }
        /^Message>/ && outcome == "skipped" && test != "" { test = test " (" plain(substr($0, 9)) ")"; flush() }
        /^testcase[ \t\n]/ {
            flush(); test = plain(attribute("class") "::" attribute("name")); outcome = "passed"
        }
        /^(failure|error)[ \t\n>\/]/ { outcome = "failed" }
        /^skipped[ \t\n>\/]/ { outcome = "skipped" }
        END { flush() }
    ' "$2" >>"$MSISF_RESULTS"
}

# Names what failed and what was skipped, and ends with the one line that sums up all suites.
# Fails if a test failed, if none ran, or, with CI=true, if one was skipped: there every part must be at hand.
summarise() {
    local passed failed skipped suite
    passed=$(count passed) failed=$(count failed) skipped=$(count skipped)
    say
    while IFS= read -r suite; do
        printf '%-28s %5d passed, %d failed, %d skipped\n' "$suite" "$(count passed "$suite")" \
            "$(count failed "$suite")" "$(count skipped "$suite")"
    done < <(cut -f 2 "$MSISF_RESULTS" | awk '!seen[$0]++')
    awk -F '\t' '$1 == "skipped" { print "skipped: " $2 ": " $3 }' "$MSISF_RESULTS"
    awk -F '\t' '$1 == "failed" { print "FAILED: " $2 ": " $3 }' "$MSISF_RESULTS"
    if [ "$skipped" -gt 0 ]; then
        [ "${CI:-}" != true ] || warn 'a skipped test is a failure where CI=true'
        say "$passed passed, $failed failed, $skipped skipped"
    else
        say "$passed passed, $failed failed"
    fi
    [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ] && { [ "$skipped" -eq 0 ] || [ "${CI:-}" != true ]; }
}
