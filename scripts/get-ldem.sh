#!/usr/bin/env bash
# Puts an elevation model of the Moon, image and label, into input/ldem:
#     scripts/get-ldem.sh [--res 4|16|64|128] [--real-only]
# Sources, the first that answers: what is there already, ../shared/ldem, NASA's Planetary Data System, and last
# (not with --real-only) a synthetic Moon. Exit code: 0 the real model is there, 10 a synthetic one, 1 none.
# MSISF_LDEM_URLS: other addresses of labels, separated by spaces, with {res} for the resolution; the image is beside.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/download.sh"
. "$root/scripts/lib/ldem.sh"

official_urls='
    https://pds-geosciences.wustl.edu/lro/lro-l-lola-3-rdr-v1/lrolol_1xxx/data/lola_gdr/cylindrical/img/ldem_{res}.lbl
    https://imbrium.mit.edu/DATA/LOLA_GDR/CYLINDRICAL/IMG/LDEM_{res}.LBL'
exit_synthetic=10

resolution=4
real_only=''
while [ $# -gt 0 ]; do
    case $1 in
        --res) resolution=${2:-} && shift ;;
        --real-only) real_only=yes ;;
        *) die "unknown argument $1. Usage: scripts/get-ldem.sh [--res 4|16|64|128] [--real-only]" ;;
    esac
    shift || die '--res needs a number: 4, 16, 64 or 128'
done
case $resolution in
    4 | 16 | 64 | 128) ;;
    *) die "--res $resolution: one file holds the whole Moon for 4, 16, 64 and 128 pixels per degree only" ;;
esac

name=LDEM_$resolution
synthetic=${name}_SYNTHETIC # as msis ldem synthesize names it
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

# keep_model_from PLACE: what was fetched is put in place if it is sound, and that ends the search.
keep_model_from() {
    local fault
    fault=$(fault_of_model "$incoming" "$name")
    if [ -n "$fault" ]; then
        warn "not taken from $1: $fault"
        return 0
    fi
    mv "$incoming/$name.IMG" "$folder/$name.IMG"
    mv "$incoming/$name.LBL" "$folder/$name.LBL"
    say "The elevation model $name comes from $1."
    finish_with_real_model
}

finish_with_real_model() {
    if is_other_version "$folder" "$name"; then
        warn "$name.IMG is not version V3.0, with which the published numbers were made: heights may differ a little"
    fi
    exit 0
}

present=$(fault_of_model "$folder" "$name")
if [ -z "$present" ]; then
    say "The elevation model $name is in place."
    finish_with_real_model
elif [ -e "$folder/$name.IMG" ]; then
    warn "input/ldem: $present; looking for the real model"
fi

mkdir -p "$incoming"
if [ -e "$shared/$name.LBL" ] && fetch_from_folder "$shared"; then
    keep_model_from "$shared"
fi
for url in ${MSISF_LDEM_URLS:-$official_urls}; do
    url=${url//\{res\}/$resolution}
    if fetch_from_url "$url"; then
        keep_model_from "$url"
    fi
done

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
