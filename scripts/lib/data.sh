# shellcheck shell=bash
# Sourced after common.sh, in the root of the repository: elevation models and maps, from the folder beside it or from NASA.

msis=(./msis) # the program; test.sh takes another build

# fetch_data ldem|albedo ARGUMENTS...: msis fetch, which looks in ../shared first.
fetch_data() {
    local from=()
    [ ! -d "../shared/$1" ] || from=(--from "../shared/$1")
    "${msis[@]}" fetch "$1" "${from[@]}" "${@:2}"
}

# get_base: puts the label of the elevation model LDEM_4 into $base: NASA's or, where no place has it, a synthetic one.
get_base() {
    base=input/ldem/LDEM_4.LBL
    if fetch_data ldem >/dev/null; then
        return
    fi
    base=input/ldem/LDEM_4_SYNTHETIC.LBL
    if [ ! -f "$base" ]; then
        say 'No place has the real elevation model: making a SYNTHETIC one.'
        "${msis[@]}" ldem synthesize --res 4 --seed 1 --batch >/dev/null
        [ -f "$base" ] || die "msis ldem synthesize ended well, but did not write $base: please report this"
    fi
    say "Going on with the SYNTHETIC model $base: its heights are invented."
}
