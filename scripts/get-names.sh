#!/usr/bin/env bash
# Puts the Moon's named features into input/names/names.csv, where the viewer of msis finds them:
#     scripts/get-names.sh
# Sources, the first that answers: what is there already, the IAU's Gazetteer of Planetary Nomenclature (USGS), and Debian's
# package stellarium-data where it is installed, which has the Gazetteer's names. Exit code: 0 the names are there, 1 none; the
# viewer then has the 300 largest. MSISF_NAMES_URLS: other addresses of a CSV, separated by spaces.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/download.sh"

gazetteer='https://planetarynames.wr.usgs.gov/SearchResults'
official_urls="$gazetteer?Target=16_Moon&Approval_Status=5_Approved&Is_Positive_East=true&Is_0_360=true&displayType=CSV"
stellarium=${MSISF_STELLARIUM_DATA:-/usr/share/stellarium/data}/nomenclature.dat

[ $# -eq 0 ] || die "unknown argument $1. Usage: scripts/get-names.sh"
folder=$root/input/names
names=$folder/names.csv
incoming=$folder/.incoming-$$
trap 'rm -rf "$incoming"' EXIT

# keep SOURCE: what lies in incoming is put in place if it is a list, and that ends the search.
keep() {
    if [ "$(wc -l <"$incoming/names.csv")" -lt 2 ]; then
        warn "not taken from $1: it holds no names of the Moon"
        return 0
    fi
    mv "$incoming/names.csv" "$names"
    say "The Moon's $(($(wc -l <"$names") - 1)) named features come from $1."
    exit 0
}

# of_stellarium: lines such as  Moon <TAB> 6163 <TAB> _("Tycho","crater") <TAB> AA <TAB> -43.3 <TAB> 348.7 <TAB> 85.3 ; a size of 0 is none.
of_stellarium() {
    printf 'name,diameter_km,latitude,longitude\n'
    gzip -dc "$stellarium" | awk -F '\t' '$1 == "Moon" && $7 > 0 {
        name = $3; sub(/^_\("/, "", name); sub(/",.*$/, "", name); gsub(/"/, "\"\"", name)
        printf "\"%s\",%s,%s,%s\n", name, $7, $5, $6
    }'
}

# of_gazetteer: the columns that are needed, of the CSV with a heading; a size of 0 is none.
of_gazetteer() {
    awk '
    function fields(line,    n, i, c, quoted, text) {
        n = 0; quoted = 0; text = ""
        for (i = 1; i <= length(line); i++) {
            c = substr(line, i, 1)
            if (c == "\"") quoted = !quoted
            else if (c == "," && !quoted) { field[++n] = text; text = "" }
            else text = text c
        }
        field[++n] = text
        return n
    }
    { sub(/\r$/, "") }
    !heading {
        n = fields($0)
        for (i = 1; i <= n; i++) { key = tolower(field[i]); gsub(/_/, " ", key); at[key] = i }
        heading = ("feature name" in at) && ("diameter" in at) && ("center latitude" in at) && ("center longitude" in at)
        if (heading) print "name,diameter_km,latitude,longitude"
        next
    }
    fields($0) > 3 && field[at["diameter"]] > 0 {
        printf "\"%s\",%s,%s,%s\n", field[at["feature name"]], field[at["diameter"]],
            field[at["center latitude"]], field[at["center longitude"]]
    }' "$1"
}

if [ -f "$names" ]; then
    say "The Moon's named features are in place."
    exit 0
fi
mkdir -p "$incoming"
for url in ${MSISF_NAMES_URLS:-$official_urls}; do
    if download "$url" "$incoming/gazetteer.csv"; then
        of_gazetteer "$incoming/gazetteer.csv" >"$incoming/names.csv"
        keep "$url"
    fi
done
if [ -f "$stellarium" ]; then
    of_stellarium >"$incoming/names.csv"
    keep "$stellarium"
fi
warn "no source has the names; the viewer has the 300 largest. Save the Gazetteer's list of the Moon as CSV with the columns" \
    'name, diameter_km, latitude, longitude in input/names/names.csv'
exit 1
