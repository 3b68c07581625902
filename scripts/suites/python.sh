#!/usr/bin/env bash
# Suite: pytest on the clients, with the program that test.sh built before. Started by test.sh in the repository root.
set -euo pipefail
. scripts/lib/common.sh
. scripts/lib/packages.sh
. scripts/lib/results.sh

[ -d clients/python ] || exit 0
for part in numpy pytest; do
    if ! part_is_here "$part"; then
        record skipped python "all tests (missing: $part)"
        exit 0
    fi
done
if [ ! -x publish/msis ] || [ -n "${MSISF_BUILD_FAILED:-}" ]; then
    record skipped python 'all tests (missing: the build)'
    exit 0
fi
if [ ! -e input/ldem/LDEM_4.LBL ]; then
    record skipped python 'all tests (missing: LDEM_4)'
    exit 0
fi

# One thread: more of them only wait for each other on small arrays.
export MSISF_PROGRAM=$PWD/msis OPENBLAS_NUM_THREADS=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p TestResults
if part_is_here zmq; then
    suites=(python cpp matlab basilisk)
else
    suites=(python cpp matlab)
    record skipped python 'all tests of clients/basilisk (missing: zmq)'
fi
for suite in "${suites[@]}"; do
    report=$PWD/TestResults/$suite.xml
    code=0
    failed=$(count failed python)
    rm -f "$report"
    (cd "clients/$suite" && within 900 /usr/bin/python3 -B -m pytest -q -p no:cacheprovider --junit-xml "$report") || code=$?
    record_report python "$report"
    if [ "$code" -ne 0 ] && [ "$(count failed python)" -eq "$failed" ]; then
        record failed python "pytest on clients/$suite ended with exit code $code"
    fi
done

# As on a computer without setuptools and wheel. Nothing is fetched, and nothing is written beside the sources.
if part_is_here pip; then
    for module in setuptools wheel; do
        mkdir -p "$work/missing/$module"
        echo 'raise ImportError("not on this computer")' >"$work/missing/$module/__init__.py"
    done
    find clients/python -not -name '*.pyc' | sort >"$work/before"
    check python 'pip install' env PYTHONPATH="$work/missing" PYTHONDONTWRITEBYTECODE=1 \
        /usr/bin/python3 -m pip install -q --disable-pip-version-check --root-user-action=ignore \
        --no-build-isolation --no-deps --no-index --target "$work/site" "$PWD/clients/python"
    find clients/python -not -name '*.pyc' | sort >"$work/after"
    check python 'pip install leaves the tree as it was' cmp "$work/before" "$work/after"
    check python 'import of the installed package' env PYTHONPATH="$work/site" \
        /usr/bin/python3 -c 'import msisf, pathlib; assert (pathlib.Path(msisf.__file__).parent / "py.typed").exists()'
else
    record skipped python 'pip install (missing: pip)'
fi
