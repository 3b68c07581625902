# shellcheck shell=bash
# Sourced by the test files. A test runs in an empty folder; MSISF_TESTED_ROOT is the repository that is tested.

fail() {
    printf '%s\n' "$*"
    exit 1
}

# need COMMAND: skips the test, by name, where a program that it drives is not installed.
need() {
    command -v "$1" >/dev/null || {
        echo "missing: $1"
        exit 77
    }
}

# run COMMAND...: keeps its exit code in $code and all its output in $output.
run() {
    code=0
    output=$("$@" 2>&1) || code=$?
}

assert_code() { [ "$code" -eq "$1" ] || fail "exit code $code, expected $1. It said: $output"; }

assert_says() {
    case $output in
        *"$1"*) ;;
        *) fail "expected to read \"$1\". It said: $output" ;;
    esac
}

assert_silent_on() {
    case $output in
        *"$1"*) fail "did not expect \"$1\". It said: $output" ;;
    esac
}

assert_same() { [ "$1" = "$2" ] || fail "found \"$1\", expected \"$2\""; }

assert_file() { [ -f "$1" ] || fail "there is no $1"; }

assert_no_file() { [ ! -e "$1" ] || fail "$1 should not be there"; }

# make_executable FILE: a stand-in for a program, from standard input.
make_executable() {
    mkdir -p "$(dirname "$1")"
    cat >"$1"
    chmod +x "$1"
}

# make_clone FOLDER: what the set-up scripts see of a repository. Its neighbour ../shared does not exist.
make_clone() {
    mkdir -p "$1/input/ldem" "$1/output" "$1/src/Msisf.Cli" "$1/lib" "$1/kernels"
    (cd "$MSISF_TESTED_ROOT" && cp -R scripts msis quickstart.sh Directory.*.props global.json BannedSymbols.txt "$1")
    echo 'return 0;' >"$1/src/Msisf.Cli/Program.cs"
}

# make_model FOLDER NAME IMAGE-EXTENSION LABEL-EXTENSION: a sound model of 2 x 3 samples.
make_model() {
    mkdir -p "$1"
    printf 'twelve bytes' >"$1/$2.$3"
    printf 'PDS_VERSION_ID = "PDS3"\r\n  LINES = 2\r\n  LINE_SAMPLES = 3\r\n  SAMPLE_BITS  = 16\r\n' >"$1/$2.$4"
}
