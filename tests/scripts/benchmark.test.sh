# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

# what benchmark.sh writes into
results=tests/Msisf.Benchmarks/results
pages=(docs/performance docs/accuracy "$results"/performance-tables "$results"/accuracy-tables)

need_matplotlib() {
    /usr/bin/python3 -c 'import matplotlib' 2>/dev/null || {
        echo 'missing: matplotlib'
        exit 77
    }
}

# A clone whose models are there; SDK, program, benchmark and plots are stand-ins. Each line of "calls" is what the benchmark was asked.
make_benchmark_clone() {
    need povray
    export CALLS=$PWD/calls PATH="$PWD/sdk:$PATH"
    make_clone "$PWD/clone"
    cp "$MSISF_TESTED_ROOT/benchmark.sh" clone
    mkdir -p clone/tests/Msisf.Benchmarks
    cp -R "$MSISF_TESTED_ROOT/tests/Msisf.Benchmarks/plots" clone/tests/Msisf.Benchmarks
    make_model clone/input/ldem LDEM_4 IMG LBL
    make_model made LDEM IMG LBL
    : >"$CALLS"
    make_executable clone/scripts/build.sh <<'BUILD'
#!/bin/sh
echo built
BUILD
    make_executable clone/scripts/get-cspice.sh <<'CSPICE'
#!/bin/sh
exit 1
CSPICE
    make_executable sdk/dotnet <<'SDK'
#!/usr/bin/env bash
case $1 in
    --list-sdks) printf '10.0.100 [%s/sdk]\n' "$(cd "$(dirname "$0")" && pwd -P)" ;;
esac
SDK
    make_executable clone/publish/msis <<'PROGRAM'
#!/usr/bin/env bash
[ "$1" != fetch ] || exit 0
echo "msis $*" >>"$CALLS"
name=LDEM_$4_SYNTHETIC
case $4 in
    128 | 512) name=${name}_16S_18N_014_062 ;;
    polar-south) name=LDEM_80S_${6}M_SYNTHETIC ;;
esac
mkdir -p benchmark/ldem
cp ../made/LDEM.IMG "benchmark/ldem/$name.IMG"
cp ../made/LDEM.LBL "benchmark/ldem/$name.LBL"
PROGRAM
    make_executable clone/tests/Msisf.Benchmarks/bin/Release/net10.0/Msisf.Benchmarks <<'BENCHMARK'
#!/usr/bin/env bash
echo "$*" >>"$CALLS"
case $1 in
    resolutions) echo "${RESOLUTIONS:-4}" ;;
    measure)
        mkdir -p benchmark
        [ -z "${BROKEN:-}" ] || exit 1
        echo '| fresh |' >benchmark/tables.md
        printf '%s\n' 'scene,quantity,setting,median' 'sequence,rate,all frames,40' 'sequence,frames,,10' 'sequence,files,,2000000' >benchmark/figures.csv
        echo targets >benchmark/targets.csv
        printf '%s\n' 'scene,about,setting,kind,seconds_median,tiles,tiles_measured,msis_peak_bytes,povray_peak_bytes,grey_rms_levels' \
            "${SCENE:-far-4},Far,thesis,Thesis,2,40,4,1e8,1e8,0.9" "${SCENE:-far-4},Far,\"native, 1\",Native,0.3,0,0,2e8,0,0" \
            'far-512,Finest,"native, 1",Native,1,0,0,3e8,0,' 'nadir-64,Nadir,povray,PovRay,2.5,36,36,1e8,1e8,' >benchmark/front.csv
        ;;
    stress)
        mkdir -p benchmark/stress
        [ -z "${BROKEN:-}" ] || exit 1
        echo '| kepler |' >benchmark/stress/tables.md
        cp "$MSISF_TESTED_ROOT/tests/Msisf.Benchmarks/results/stress.csv" benchmark/stress
        echo times >benchmark/stress/stress_machine.csv
        echo series >benchmark/stress/stress_series.csv
        ;;
esac
BENCHMARK
    mkdir -p clone/docs
    cat >clone/tests/Msisf.Benchmarks/plots/performance.py <<'PLOTS'
import csv, pathlib, sys
scene = next(csv.DictReader(open(sys.argv[1])))["scene"]
pathlib.Path(sys.argv[2], f"front-{scene}.svg").touch()
PLOTS
    cat >clone/tests/Msisf.Benchmarks/plots/overview.py <<'PLOTS'
import pathlib, sys
for name in ("time.svg", "error.svg", "memory.svg", "summary.md", "scaling.md"):
    pathlib.Path(sys.argv[3], name).touch()
PLOTS
    cat >clone/tests/Msisf.Benchmarks/plots/accuracy.py <<'PLOTS'
import pathlib, sys
pathlib.Path(sys.argv[2], "stress_kepler_1.svg").write_text(pathlib.Path(sys.argv[1]).read_text())
PLOTS
    cat >>clone/scripts/lib/packages.sh <<'PARTS'
install_parts() { echo "parts $*" >>"$CALLS"; }
PARTS
    printf '%s\n' 'before' '<!-- benchmark.sh: begin -->' '| old |' '<!-- benchmark.sh: end -->' 'after' >page
    mkdir -p clone/docs clone/$results
    local name
    for name in "${pages[@]}"; do
        cp page "clone/$name.md"
    done
    printf '%s\n' '<!-- benchmark.sh: series begin -->' '<!-- benchmark.sh: series end -->' 'end' >>clone/docs/performance.md
    cp clone/docs/performance.md performance
}

with_real_plots() {
    need_matplotlib
    cp "$MSISF_TESTED_ROOT/tests/Msisf.Benchmarks/plots/"{performance,overview}.py clone/tests/Msisf.Benchmarks/plots
}

assert_page_untouched() {
    local name
    for name in "${pages[@]}"; do
        [ "$name" = docs/performance ] || cmp "clone/$name.md" page || fail "$name.md has changed"
    done
    cmp clone/docs/performance.md performance || fail 'docs/performance.md has changed'
    assert_same "$(cd clone/$results && echo *)" 'accuracy-tables.md performance-tables.md'
}

test_benchmark_replaces_only_the_text_between_the_marks() {
    make_benchmark_clone
    with_real_plots
    run clone/benchmark.sh
    assert_code 0
    assert_same "$(grep matplotlib "$CALLS")" 'parts povray matplotlib downloader certificates'
    assert_same "$(cat clone/$results/performance-tables.md)" \
        "$(printf '%s\n' 'before' '<!-- benchmark.sh: begin -->' '' '| fresh |' '' '<!-- benchmark.sh: end -->' 'after')"
    assert_same "$(grep -e '^| Far ' clone/docs/performance.md)" '| Far | 2.00 (scaled) | - | 0.300 | - | - | - | - |'
    assert_same "$(grep -e '^| an hour' -e '^| outputs' clone/docs/performance.md)" "$(printf '%s\n' \
        '| an hour of video | 108,000 | native | 45 min | 2.8 min | 2.7 s |' \
        '| outputs, 200 kB a frame | 8.0 MB/s | 0.080 MB/s |' '| outputs of 1e6 frames | 200 GB | 200 GB |')"
    assert_same "$(head -n 1 clone/docs/performance.md; tail -n 1 clone/docs/performance.md; grep -c -x after clone/docs/performance.md)" $'before\nend\n1'
    assert_same "$(cat clone/$results/targets.csv)" targets
    assert_same "$(cd clone/$results && echo *.csv *.svg)" \
        'figures.csv front.csv targets.csv error.svg front-far-4.svg memory.svg time.svg'
    cp -R clone/docs once
    run clone/benchmark.sh
    diff -r clone/docs once || fail 'a second run has changed something'
}

test_benchmark_page_without_marks_stays_as_it_is() {
    make_benchmark_clone
    sed -i.old '/end -->/d' clone/docs/performance.md
    cp clone/docs/performance.md page
    run clone/benchmark.sh
    assert_code 1
    assert_says 'needs the lines'
    cmp clone/docs/performance.md page || fail 'the page has changed'
}

test_benchmark_plots_of_scenes_that_are_gone_go() {
    make_benchmark_clone
    SCENE=old run clone/benchmark.sh
    assert_code 0
    run clone/benchmark.sh
    assert_code 0
    assert_same "$(cd clone/$results && ls -- front-*.svg)" front-far-4.svg
}

# The pages' figures are those of the committed CSV files, and of no other run.
test_benchmark_pages_follow_from_the_figures() {
    need_matplotlib
    local docs=$MSISF_TESTED_ROOT/docs plots=$MSISF_TESTED_ROOT/tests/Msisf.Benchmarks/plots found=$MSISF_TESTED_ROOT/$results name
    mkdir made
    /usr/bin/python3 -B "$plots/overview.py" "$found/front.csv" "$found/figures.csv" made
    /usr/bin/python3 -B "$plots/promises.py" "$found/stress.csv" made
    . "$MSISF_TESTED_ROOT/scripts/lib/common.sh"
    . "$MSISF_TESTED_ROOT/scripts/lib/benchmark.sh"
    for name in performance accuracy; do
        cp "$docs/$name.md" .
    done
    replace_block performance.md made/summary.md
    replace_block performance.md made/scaling.md series
    replace_block accuracy.md made/promises.md
    for name in performance accuracy; do
        diff "$docs/$name.md" "$name.md" || fail "docs/$name.md does not follow from $results"
    done
}

test_benchmark_models_are_made_once() {
    make_benchmark_clone
    RESOLUTIONS='4 64 128 512 20m' run clone/benchmark.sh
    assert_code 0
    RESOLUTIONS='4 64 128 512 20m' run clone/benchmark.sh
    assert_code 0
    assert_same "$(grep '^msis' "$CALLS")" "$(printf '%s\n' \
        'msis ldem synthesize --res 64 --sample-type int16 --base input/ldem/LDEM_4.LBL --seed 1 --output-dir benchmark/ldem --batch' \
        'msis ldem synthesize --res 128 --region=-16:18:14:62 --rest none --sample-type int16 --base input/ldem/LDEM_4.LBL --seed 1 --output-dir benchmark/ldem --batch' \
        'msis ldem synthesize --res 512 --region=-16:18:14:62 --rest none --sample-type int16 --base input/ldem/LDEM_4.LBL --seed 1 --output-dir benchmark/ldem --batch' \
        'msis ldem synthesize --projection polar-south --map-scale 20 --sample-type int16 --base input/ldem/LDEM_4.LBL --seed 1 --output-dir benchmark/ldem --batch')"
    assert_same "$(grep '^measure' "$CALLS" | tail -n 1)" \
        'measure --root . --folder benchmark --model input/ldem/LDEM_4.LBL --model benchmark/ldem/LDEM_64_SYNTHETIC.LBL --model benchmark/ldem/LDEM_128_SYNTHETIC_16S_18N_014_062.LBL --model benchmark/ldem/LDEM_512_SYNTHETIC_16S_18N_014_062.LBL --model benchmark/ldem/LDEM_80S_20M_SYNTHETIC.LBL'
}

test_benchmark_of_a_part_leaves_the_docs_alone() {
    make_benchmark_clone
    run clone/benchmark.sh --quick
    assert_code 0
    assert_says '| fresh |'
    assert_page_untouched
    run clone/benchmark.sh --scenes far-4,sequence
    assert_code 0
    assert_page_untouched
    assert_same "$(grep -c -e '--scenes far-4,sequence$' "$CALLS")" 2
}

test_benchmark_that_fails_leaves_the_docs_alone() {
    make_benchmark_clone
    BROKEN=yes run clone/benchmark.sh
    assert_code 1
    assert_page_untouched
}

test_benchmark_stress_replaces_tables_and_plots() {
    make_benchmark_clone
    touch clone/$results/stress_gone_1.svg clone/$results/figures.csv
    run clone/benchmark.sh --stress
    assert_code 0
    assert_same "$(grep -c '^| Bytes in which .* | 0 | 0 | ' clone/docs/accuracy.md)" 1
    assert_same "$(cat clone/$results/accuracy-tables.md)" \
        "$(printf '%s\n' 'before' '<!-- benchmark.sh: begin -->' '' '| kepler |' '' '<!-- benchmark.sh: end -->' 'after')"
    cmp clone/docs/performance.md performance || fail 'docs/performance.md has changed'
    assert_same "$(cd clone/$results && echo *.csv *.svg)" \
        'figures.csv stress.csv stress_machine.csv stress_series.csv stress_kepler_1.svg'
    assert_same "$(cat clone/$results/stress_kepler_1.svg)" series
    assert_same "$(grep -e 'povray matplotlib' -e ' slurm' -e '^stress' "$CALLS")" \
        $'parts povray matplotlib downloader certificates\nparts slurm parallel\nstress --folder benchmark/stress'
}

test_benchmark_quick_stress_leaves_the_docs_alone() {
    make_benchmark_clone
    run clone/benchmark.sh --stress --quick
    assert_code 0
    assert_says 'benchmark/stress'
    assert_file clone/benchmark/stress/stress_kepler_1.svg
    assert_page_untouched
    assert_same "$(tail -n 1 "$CALLS")" 'stress --folder benchmark/stress --quick'
}

test_benchmark_single_stress_tests_leave_the_docs_alone() {
    make_benchmark_clone
    run clone/benchmark.sh --stress --tests kills,crowd
    assert_code 0
    assert_page_untouched
    assert_same "$(tail -n 1 "$CALLS")" 'stress --folder benchmark/stress --tests kills,crowd'
}

test_benchmark_tests_without_stress_are_refused() {
    make_benchmark_clone
    run clone/benchmark.sh --tests kills
    assert_code 1
    assert_says 'it goes with --stress only'
}

test_benchmark_stress_that_fails_leaves_the_docs_alone() {
    make_benchmark_clone
    BROKEN=yes run clone/benchmark.sh --stress
    assert_code 1
    assert_page_untouched
}

test_benchmark_stress_without_matplotlib_says_what_to_install() {
    # -S: without the packages of the system
    run /usr/bin/python3 -S "$MSISF_TESTED_ROOT/tests/Msisf.Benchmarks/plots/accuracy.py" none.csv .
    assert_code 1
    assert_says 'apt-get install python3-matplotlib'
}

test_benchmark_unknown_argument_is_refused() {
    make_benchmark_clone
    run clone/benchmark.sh --fast
    assert_code 1
    assert_says 'unknown argument --fast'
    run clone/benchmark.sh --scenes
    assert_code 1
    assert_says '--scenes needs names'
    run clone/benchmark.sh --stress --scenes far-4
    assert_code 1
    assert_says '--stress goes with --quick and --tests only'
    run clone/benchmark.sh --micro --stress
    assert_code 1
    assert_says '--stress goes with --quick and --tests only'
    assert_same "$(cat "$CALLS")" ''
}

# The real thing, from the start of a process to the tables. Its figures mean nothing beside other tests.
test_benchmark_quick_run_measures() {
    need povray
    need dotnet
    [ -e "$MSISF_TESTED_ROOT/input/ldem/LDEM_4.LBL" ] || {
        echo 'missing: LDEM_4'
        exit 77
    }
    MSISF_BENCHMARK_BUILT=Debug run "$MSISF_TESTED_ROOT/benchmark.sh" --quick
    assert_code 0
    assert_says '| far, LDEM_4 | POV-Ray'\''s image, to the thesis'\''s way | at least 1.00 times |'
    assert_says '| thesis | '
    assert_says '| native, 16 | '
    [ -s "$MSISF_TESTED_ROOT/benchmark/front-quick.svg" ] || fail 'there is no plot'
    assert_says '| far, LDEM_4 | first frame, from process start | at most 150 ms |'
    assert_says '| far, LDEM_4 | further frames | at most 12.0 ms |'
    assert_says '| far, LDEM_4 | further frames, --samples auto:0.4 | at most 50.0 ms |'
    assert_says '| orbit of 20 frames | images and meta files | at least 80.0 frames/s |'
    assert_says '| and all layers, FITS | 2 |'
    assert_says '| 0, 0 of '
}

# The real thing with two of the stress tests, their tables and their plots; Msisf.Stress.Tests runs them all.
test_benchmark_quick_stress_run_keeps_all_limits() {
    need dotnet
    [ -e "$MSISF_TESTED_ROOT/input/ldem/LDEM_4.LBL" ] || {
        echo 'missing: LDEM_4'
        exit 77
    }
    . "$MSISF_TESTED_ROOT/scripts/lib/common.sh"
    . "$MSISF_TESTED_ROOT/scripts/lib/packages.sh"
    install_parts matplotlib povray || {
        echo 'missing: matplotlib or povray'
        exit 77
    }
    MSISF_BENCHMARK_BUILT=Debug run "$MSISF_TESTED_ROOT/benchmark.sh" --stress --quick --tests kepler,attitude
    assert_code 0
    assert_says 'kepler: residual, in units of the last place of the M given: '
    assert_silent_on ': missed'
    local folder=$MSISF_TESTED_ROOT/benchmark/stress
    assert_same "$(grep -c '^### kepler$' "$folder/tables.md")" 1
    assert_same "$(grep -o 'stress_[a-z0-9-]*_[0-9]*.svg' "$folder/tables.md" | sort)" "$(cd "$folder" && printf '%s\n' stress_*.svg | sort)"
}
