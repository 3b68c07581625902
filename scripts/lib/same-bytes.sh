# shellcheck shell=bash
# Sourced after common.sh: runs two builds of the program side by side, and compares all that they write, to the byte.

# Runs whose outputs cover the laws, lights, lenses, detectors, layers, exports and commands; a line each. Standard output counts as a file.
runs_to_compare() {
    local state="--fixed-state {55289,2E6,2E6,0,-0.2391176183943345,0.0990457605412876,0.3696438106143861,0.8923991008325228}"
    local low="--position -19.4,267,60000 --time 2010-04-03T00:00:00Z"
    local small="--renderer native --width 200 --height 160 --batch --output-dir out"
    cat <<RUNS
$state $small --rendering-annotation
$state $small --reflectance lambert --samples 9 --surface terrain --grid 20
$state $small --reflectance hapke:w=0.3,b0=1.2 --samples auto --bit-depth 16 --transfer linear
$state $small --reflectance lunar-lambert --shading smooth --band 415
$state $small --reflectance akimov --ephemeris builtin --aberration lt+s
$state $small --sun disc
$state --renderer native --indirect --indirect-error 0.2 --width 64 --height 64 --batch --output-dir out
$low $small --refine 7 --refine-cell 8 --layers all --layers-format npy --samples 1
$low $small --layers all --layers-compression gzip --layers-precision single --camera-model opencv,colmap,tsai,csm,isd,isd-body,pds4
$low $small --look-at horizon:45 --map equirectangular,1000 --layers depth,normal
$low $small --flow {55289,2E6,2E6,0,-0.2391176183943345,0.0990457605412876,0.3696438106143861,0.8923991008325228} --flow-format npy,flo,kitti
$low --camera lroc-wac-643 --renderer native --framelets 2 --scan-period 1.4 --motion {0,1600,0,0,0,0} --batch --output-dir out
$low --camera $PWD/input/navigation-camera.yaml --renderer native --exposure-time auto --noise-seed 3 --batch --output-dir out
--kepler-set {1.9E6,0.05,0.7,1.1,0.9,2.0} --epoch 55289 --time-interval [55289:0.001:55289.004] $small --jobs 1
--kepler-set {1.9E6,0.05,0.7,1.1,0.9,2.0} --epoch 55289 --time-interval [55289:0.001:55289.004] --dry-run --format json
--kepler-set {1.9E6,0.05,0.7,1.1,0.9,2.0} --epoch 55289 --time-interval [55289:0.001:55289.004] --dry-run --format csv
$low --batch --output-dir out --width 200 --height 160 --pattern-repos patterns
ldem synthesize --res 4 --seed 3 --output-dir out --batch
illumination --center -89,0 --size 20 --cell 2000 --time-interval [55289:1:55299] --output-dir out --batch
dataset $PWD/input/data-set.yaml --frames 1:2 --jobs 1 --output-dir out --batch
kernels $PWD/kernels/de421.bsp --format json
cameras
places --near Tycho --format json
--fov 400
--help
man
completion bash
RUNS
}

# written_by PROGRAM FOLDER WORDS...: all that a run writes into a new folder, without the lines that say how long it will take.
written_by() {
    local program=$1 folder=$2
    mkdir -p "$folder"
    (cd "$folder" && code=0 && "$program" "${@:3}" >stdout 2>stderr </dev/null || code=$? && echo "$code" >exit-code && sed -i '/ left$/d' stderr)
}

# Those that need no library of this system: GDAL, CFITSIO, POV-Ray.
runs_elsewhere() {
    runs_to_compare | grep -e '--output-dir out' |
        grep -v -e --map -e layers-compression -e --pattern-repos -e noise-seed -e ^dataset -e ^illumination
}

same_bytes() { diff -rq "$1" "$2"; }

# compare_programs RUNS PROGRAM OTHER FOLDER SAME: says which of the runs differ by SAME; fails if one does. FOLDER keeps the outputs of
# those.
compare_programs() {
    local line words count=0 differing=0
    while IFS= read -r line; do
        read -ra words <<<"$line"
        count=$((count + 1))
        written_by "$2" "$4/$count/one" "${words[@]}"
        written_by "$3" "$4/$count/other" "${words[@]}"
        if "$5" "$4/$count/one" "$4/$count/other"; then
            rm -r "${4:?}/$count"
        else
            differing=$((differing + 1))
            say "differs: msis $line"
        fi
    done < <("$1")
    say "$count runs of two builds, $differing differ."
    [ "$differing" -eq 0 ]
}
