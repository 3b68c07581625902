# shellcheck shell=bash
# Sourced after common.sh: runs two builds of the program side by side, and compares all that they write, to the byte.

# Runs whose outputs cover the laws, lights, lenses, detectors, layers, exports and commands; a line each. Standard output counts as a file.
runs_to_compare() {
    local state="--fixed-state {55289,2E6,2E6,0,-0.2391176183943345,0.0990457605412876,0.3696438106143861,0.8923991008325228}"
    local low="--position -19.4,267,60000 --time 2010-04-03T00:00:00Z"
    local craters=$PWD/obj/craters.csv
    awk -F, 'NR == 1 || $NF > 0' lib/places/features.csv >"$craters"
    local high="--position -19.4,267,900000 --time 2010-04-03T00:00:00Z"
    local series="--kepler-set {1.9E6,0.05,0.7,1.1,0.9,2.0} --epoch 55289 --time-interval [55289:0.001:55289.004]"
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
$series $small --jobs 1
$series --dry-run --format json
$series --dry-run --format csv
$low --camera $PWD/input/navigation-camera.yaml --renderer native --camera-model pds4,isd --map orthographic,2000 --batch --output-dir out
$low --camera $PWD/input/navigation-camera.yaml --renderer native --layers radiance-factor --layers-format npy --information pose --batch --output-dir out
$low $small --craters $craters --landmarks $craters --rendering-annotation --camera-model isis
$low $small --craters $craters --layers crater,cell --surface terrain --grid 40
$series $small --stereo 500 --flow pair --flow-format fits,npy,flo,kitti --frames 1:2 --jobs 1
$low $small --sky --layers object,mask --layers-format npy --layers-precision single
$low $small --sensitivity position-x,sun-east --layers-format npy
$low $small --sensitivity all --layers depth --map equirectangular,1500 --layers-precision single
$low --camera $PWD/cameras/lroc-nac-l.yaml --renderer native --lines 60 --motion {0,1600,0,0,0,0} --layers depth,normal --camera-model csm,pds4 --batch --output-dir out
$high --camera $PWD/cameras/lroc-nac-l.yaml --renderer native --lines 1700 --scan-period 0.005 --motion {0,1600,0,0,0,0} --layers depth,normal --camera-model csm --batch --output-dir out
$high --camera $PWD/cameras/lroc-nac-l.yaml --renderer native --lines 1700 --scan-period 0.005 --motion {0,1600,0,0,0,0} --layers depth,cell --layers-format npy --batch --output-dir out
$low --batch --output-dir out --width 200 --height 160 --pattern-repos patterns
$low --batch --output-dir out --width 200 --height 160 --pattern-repos patterns --rendering-annotation --surface terrain --camera-model opencv,csm
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

# Requests to a server: the types that are accepted, and the body; a line each.
requests_to_compare() {
    local place='"position":[-19.4,267,60000],"time":"2010-04-03T00:00:00Z","width":96,"height":80'
    cat <<REQUESTS
image/png {$place}
application/octet-stream {$place,"bit-depth":16,"transfer":"linear"}
application/x-npy {$place,"layers":["depth"]}
application/fits {$place,"layers":["depth","normal"],"layers-precision":"single"}
application/json {$place,"surface":"terrain","grid":10,"stars":true,"planets":true,"earth":true}
application/xml {$place,"grid":10}
multipart/mixed {$place,"layers":["normal","cell","mask"],"layers-format":"npy","surface":"terrain","grid":20}
multipart/mixed,application/json {$place,"camera-model":["csm","isd","opencv"],"layers":["depth"]}
REQUESTS
}

# answers_of PROGRAM FOLDER: what a server answers, without the time of the answer.
answers_of() {
    local program=$1 folder=$2 server types body count=0 address=''
    mkdir -p "$folder"
    "$program" serve --listen 127.0.0.1:0 >"$folder/log" 2>&1 &
    server=$!
    while [ -z "$address" ] && kill -0 "$server" 2>/dev/null; do
        address=$(grep -o -m 1 'http://[^ /]*' "$folder/log" || sleep 0.2)
    done
    while read -r types body; do
        count=$((count + 1))
        curl -sS -H "Accept: $types" -H 'Content-Type: application/json' -d "$body" "$address/v1/render" >"$folder/$count"
    done < <(requests_to_compare)
    kill "$server"
    wait "$server" || true
    rm "$folder/log"
}

# hashes_of PROGRAM FOLDER: prints the SHA-256 and the name of all that the runs and the server write, which is kept there.
hashes_of() (
    local line words count=0
    while IFS= read -r line; do
        read -ra words <<<"$line"
        count=$((count + 1))
        written_by "$1" "$2/$count" "${words[@]}"
    done < <(runs_to_compare)
    answers_of "$1" "$2/answers"
    cd "$2" && find . -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum
)

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
