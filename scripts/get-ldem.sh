#!/usr/bin/env bash
# Puts an elevation model of the Moon, images and labels, into input/ldem:
#     scripts/get-ldem.sh [--res 4|16|64|128|256|512|1024] [--float] [--real-only]
# Sources, the first that answers: what is there already, ../shared/ldem, NASA's Planetary Data System, and last
# (not with --real-only) a synthetic Moon. Exit code: 0 the real model is there, 10 a synthetic one, 1 none.
# --float takes the products in 32-bit floats, of twice the size, in place of those in steps of 0.5 m.
# From 256 px/deg on a product has many files; a run that is cut off goes on with those that are missing.
# MSISF_LDEM_URLS: other addresses of labels, separated by spaces, with {res} for what stands behind LDEM_ in the name, and {img} for
# img or float_img; the image is beside.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/download.sh"
. "$root/scripts/lib/ldem.sh"

official_urls='
    https://pds-geosciences.wustl.edu/lro/lro-l-lola-3-rdr-v1/lrolol_1xxx/data/lola_gdr/cylindrical/{img}/ldem_{res}.lbl
    https://imbrium.mit.edu/DATA/LOLA_GDR/CYLINDRICAL/{img}/LDEM_{res}.LBL'
exit_synthetic=10
usage='scripts/get-ldem.sh [--res 4|16|64|128|256|512|1024] [--float] [--real-only]'

resolution=4
real_only=''
ending=''
images=img
while [ $# -gt 0 ]; do
    case $1 in
        --res) resolution=${2:-} && shift ;;
        --float) ending=_FLOAT images=float_img ;;
        --real-only) real_only=yes ;;
        *) die "unknown argument $1. Usage: $usage" ;;
    esac
    shift || die '--res needs a number: 4, 16, 64, 128, 256, 512 or 1024'
done
products=$(products_of_resolution "$resolution" "$ending") ||
    die "--res $resolution: NASA has models of 4, 16, 64, 128, 256, 512 and 1024 pixels per degree"

synthetic=LDEM_${resolution}_SYNTHETIC # as msis ldem synthesize names it
folder=$root/input/ldem
shared=${root%/*}/shared/ldem
incoming=$folder/.incoming-$$
trap 'rm -rf "$incoming"' EXIT

fetch_from_folder() {
    cp "$1/$name.LBL" "$1/$name.IMG" "$incoming" && chmod u+w "$incoming"/*
}

# The label first: it is small, so a site that is away or has no such model costs little.
fetch_from_url() {
    local image size
    case $1 in
        *.lbl) image=${1%.lbl}.img ;;
        *) image=${1%.LBL}.IMG ;;
    esac
    download "$1" "$incoming/$name.LBL" || return 1
    size=$(image_size_of_label "$incoming/$name.LBL") || {
        warn "$1 is not the label of an elevation model"
        return 1
    }
    say "Downloading $image ($size bytes) ..."
    download "$image" "$incoming/$name.IMG"
}

# keep_from PLACE: puts what was fetched in place, if it is sound.
keep_from() {
    local fault
    fault=$(fault_of_model "$incoming" "$name")
    if [ -n "$fault" ]; then
        warn "not taken from $1: $fault"
        return 1
    fi
    mv "$incoming/$name.IMG" "$folder/$name.IMG"
    mv "$incoming/$name.LBL" "$folder/$name.LBL"
    say "The elevation model $name comes from $1."
}

# url_of TEMPLATE: the address of the label of $name; sites write all of it in small letters or in capitals.
url_of() {
    local rest=${name#LDEM_} place=$images
    case $1 in
        *.lbl) rest=${rest,,} ;;
        *) place=${images^^} ;;
    esac
    local url=${1//\{res\}/$rest}
    say "${url//\{img\}/$place}"
}

# get_product: $name, from the first source that has it; fails if none does.
get_product() {
    local present template url
    present=$(fault_of_model "$folder" "$name")
    if [ -z "$present" ]; then
        say "The elevation model $name is in place."
        return 0
    elif [ -e "$folder/$name.IMG" ]; then
        warn "input/ldem: $present; looking for the real model"
    fi
    mkdir -p "$incoming"
    if [ -e "$shared/$name.LBL" ] && fetch_from_folder "$shared" && keep_from "$shared"; then
        return 0
    fi
    for template in ${MSISF_LDEM_URLS:-$official_urls}; do
        url=$(url_of "$template")
        if fetch_from_url "$url" && keep_from "$url"; then
            return 0
        fi
    done
    return 1
}

is_complete=yes
for name in $products; do
    if ! get_product; then
        is_complete=''
        break
    fi
done
if [ -n "$is_complete" ]; then
    if is_other_version "$folder" "$name"; then
        warn "$name.IMG is not version V3.0, with which the published numbers were made: heights may differ a little"
    fi
    exit 0
fi

# A synthetic stand-in is for a first try; the fine models are too large for one.
case $resolution$ending in
    4 | 16 | 64 | 128) ;;
    *) real_only=yes ;;
esac
[ -z "$real_only" ] || die "no source has the elevation model $name. Put $name.IMG and $name.LBL into input/ldem"
if [ -n "$(fault_of_model "$folder" "$synthetic")" ]; then
    say "No source has the real elevation model $name: making a SYNTHETIC one."
    (cd "$root" && ./msis ldem synthesize --res "$resolution" --seed 1) ||
        die "no elevation model: put $name.IMG and $name.LBL from NASA's Planetary Data System into input/ldem"
    fault=$(fault_of_model "$folder" "$synthetic")
    [ -z "$fault" ] || die "msis ldem synthesize ended well, but $fault: please report this"
fi
say "Going on with the SYNTHETIC model $synthetic: its heights are invented."
exit "$exit_synthetic"
