#!/usr/bin/env bash
# Measures run time against error of both renderers, with the thesis's own way as the base line of the same run; writes what it
# found into docs/performance.md, and all tables, figures and plots into tests/Msisf.Benchmarks/results/.
# As root, or as a user with sudo. Under 20 minutes, and a quarter of an hour and 6 GB more in benchmark/ at the first run. Leave
# the machine alone meanwhile.
#     ./benchmark.sh [--quick] [--scenes NAME,...] [--micro] [--stress [--quick] [--tests NAME,...]] [--validate [LABEL...]]
# --quick: LDEM_4 only, few repeats, to see that it works. --scenes: these only (far-4, nadir-64, ..., from-nothing, sequence, descent).
# With one of the two the results stay in benchmark/, and docs/ is left alone.
# --micro: micro-benchmarks of single parts instead, into benchmark/micro/.
# --stress: the stress tests at full length instead, into docs/accuracy.md and tests/Msisf.Benchmarks/results/; with
# --quick at everyday length, with --tests only those; then docs/ is left alone.
# --validate: the comparison with a real LROC image instead, into docs/validation.md and docs/validation/, where the image is. With labels
# of real images behind it (docs/twin.md) only a line for each of them, into the table of that page.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/packages.sh"
. "$root/scripts/lib/dotnet.sh"
. "$root/scripts/lib/data.sh"
. "$root/scripts/lib/benchmark.sh"

help_if_asked "$@"
choice=()
is_partial=''
is_micro=''
is_stress=''
is_validation=''
labels=()
scenes=''
tests=''
while [ $# -gt 0 ]; do
    case $1 in
        --quick) choice+=(--quick) is_partial=yes ;;
        --scenes) [ -n "${2:-}" ] || die '--scenes needs names, separated by commas'
            scenes=$2 is_partial=yes
            choice+=(--scenes "$2")
            shift ;;
        --tests) [ -n "${2:-}" ] || die '--tests needs names, separated by commas'
            tests=$2 is_partial=yes
            choice+=(--tests "$2")
            shift ;;
        --micro) is_micro=yes ;;
        --stress) is_stress=yes ;;
        --validate) is_validation=yes
            while [ $# -gt 1 ] && [ "${2#--}" = "$2" ]; do
                labels+=("$2")
                shift
            done ;;
        *) die "unknown argument $1. Usage: ./benchmark.sh [--quick] [--scenes NAME,...] [--micro] [--stress [--quick] [--tests NAME,...]] [--validate [LABEL...]]" ;;
    esac
    shift
done
if [ -n "$is_stress" ] && [ -n "$is_micro$scenes" ]; then
    die '--stress goes with --quick and --tests only'
fi
if [ -n "$tests" ] && [ -z "$is_stress" ]; then
    die '--tests names stress tests: it goes with --stress only'
fi
if [ -n "$is_validation" ] && [ -n "$is_stress$is_micro$is_partial" ]; then
    die '--validate goes alone'
fi

cd "$root"
require_own_folders
folder=benchmark
# latitudes and longitudes that the scenes of the finest models show, and from where shadows may fall into them
fine_region=-16:18:14:62
fine_ending=16S_18N_014_062
# Figures are of Release. Tests of this script take what test.sh has built already, and name its configuration.
configuration=${MSISF_BENCHMARK_BUILT:-Release}
program=tests/Msisf.Benchmarks/bin/$configuration/net10.0/Msisf.Benchmarks

# get_model NAME: a resolution, px/deg, or m/px of a map of the south pole, as 20m; adds the model to the arguments of the run, and makes it before if it is not there.
get_model() {
    local ldem=$folder/ldem name=LDEM_$1_SYNTHETIC
    case $1 in
        4) models+=(--model "$base") ;;
        *m)
            name=LDEM_80S_${1%m}M_SYNTHETIC
            make_model "$ldem" "$name" "$base" --projection polar-south --map-scale "${1%m}"
            models+=(--model "$ldem/$name.LBL")
            ;;
        128 | 512)
            name=${name}_$fine_ending
            make_model "$ldem" "$name" "$base" --res "$1" "--region=$fine_region" --rest none
            "$program" fill "$ldem/$name.LBL"
            models+=(--model "$ldem/$name.LBL")
            ;;
        *)
            make_model "$ldem" "$name" "$base" --res "$1"
            models+=(--model "$ldem/$name.LBL")
            ;;
    esac
}

if [ -n "$is_validation" ]; then
    validate "$folder/validation" "${labels[@]}"
    exit 0
fi
install_parts povray matplotlib downloader certificates
[ -z "$is_stress" ] || install_parts slurm parallel || warn 'going on without them: what needs them is reported as not run'
scripts/build.sh
ensure_dotnet
[ -n "${MSISF_BENCHMARK_BUILT:-}" ] || dotnet build tests/Msisf.Benchmarks -c Release -p:RunAnalyzers=false -v quiet -nologo ||
    die 'the build of the benchmarks failed; the messages above say why'
get_base
scripts/get-cspice.sh >/dev/null || say 'Going on without CSPICE, with the built-in kernel reader.'
if [ -n "$is_micro" ]; then
    exec "$program" micro --artifacts "$folder/micro"
fi
if [ -n "$is_stress" ]; then
    folder=$folder/stress
    rm -rf "$folder"
    "$program" stress --folder "$folder" "${choice[@]}"
    /usr/bin/python3 tests/Msisf.Benchmarks/plots/accuracy.py "$folder/stress_series.csv" "$folder"
    if [ -n "$is_partial" ]; then
        say "The tables and plots are in $folder; docs/ is as it was."
    else
        /usr/bin/python3 -B tests/Msisf.Benchmarks/plots/promises.py "$folder/stress.csv" "$folder"
        publish_stress "$folder"
        say 'The promises are in docs/accuracy.md; tables, figures and plots in tests/Msisf.Benchmarks/results/.'
    fi
    exit 0
fi

models=()
resolutions=$("$program" resolutions "${choice[@]}")
for resolution in $resolutions; do
    get_model "$resolution"
done
"$program" measure --root . --folder "$folder" "${models[@]}" "${choice[@]}"
rm -f "$folder"/front-*.svg
/usr/bin/python3 -B tests/Msisf.Benchmarks/plots/performance.py "$folder/front.csv" "$folder"
/usr/bin/python3 -B tests/Msisf.Benchmarks/plots/overview.py "$folder/front.csv" "$folder/figures.csv" "$folder"

if [ -n "$is_partial" ]; then
    cat "$folder/tables.md"
    say "The tables and plots are in $folder/; docs/ is as it was."
else
    publish_performance "$folder"
    say 'The conclusions are in docs/performance.md; tables, figures and plots in tests/Msisf.Benchmarks/results/.'
fi
