# shellcheck shell=bash
# Sourced after download.sh: what a folder holds of an elevation model, judged by its PDS label.

# The official LDEM_4 V3.0 of data set LRO-L-LOLA-4-GDR-V1.0. Other versions are taken too, with a warning.
ldem_4_sha256=972d66d7f330abca62abc21aae270661516c00dd1a881ec102b94df9563656b5

# label_number FILE KEYWORD: the whole number that the label gives, or nothing.
label_number() {
    sed -n "s/^[[:space:]]*$2[[:space:]]*=[[:space:]]*\([0-9][0-9]*\).*/\1/p" "$1" | head -n 1
}

# The bytes that an image must have after its label; fails if the label does not say.
image_size_of_label() {
    local lines samples bits
    lines=$(label_number "$1" LINES)
    samples=$(label_number "$1" LINE_SAMPLES)
    bits=$(label_number "$1" SAMPLE_BITS)
    [ -n "$lines" ] && [ -n "$samples" ] && [ -n "$bits" ] || return 1
    echo $((lines * samples * bits / 8))
}

# products_of_resolution RESOLUTION ENDING: the names of NASA's products that make up a model, a line each; fails if there is none.
products_of_resolution() {
    local high wide south west latitudes
    case $1 in
        4 | 16 | 64 | 128)
            echo "LDEM_$1$2"
            return
            ;;
        256) high=90 wide=180 ;;
        512) high=45 wide=90 ;;
        1024) high=15 wide=30 ;;
        *) return 1 ;;
    esac
    for ((south = 90 - high; south >= -90; south -= high)); do
        if [ "$south" -ge 0 ]; then
            latitudes=$(printf '%02dN_%02dN' "$south" $((south + high)))
        else
            latitudes=$(printf '%02dS_%02dS' $((-south)) $((-south - high)))
        fi
        for ((west = 0; west < 360; west += wide)); do
            printf 'LDEM_%s_%s_%03d_%03d%s\n' "$1" "$latitudes" "$west" $((west + wide)) "$2"
        done
    done
}

# fault_of_model FOLDER NAME: prints what is wrong; nothing if both files are there and fit each other.
fault_of_model() {
    local image=$1/$2.IMG label=$1/$2.LBL expected size
    if [ ! -f "$image" ] || [ ! -f "$label" ]; then
        echo "$2.IMG and $2.LBL are not both there"
    elif ! expected=$(image_size_of_label "$label"); then
        echo "$2.LBL gives no LINES, LINE_SAMPLES and SAMPLE_BITS: it is not the label of an elevation model"
    elif size=$(size_of "$image") && [ "$size" != "$expected" ]; then
        echo "$2.IMG has $size bytes, but its label says $expected"
    fi
}

is_other_version() { [ "$2" = LDEM_4 ] && [ "$(sha256_of "$1/$2.IMG")" != "$ldem_4_sha256" ]; }
