# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"
. "$MSISF_TESTED_ROOT/tests/scripts/pages.sh"

test_first_day_every_command_of_the_page_prints_what_the_page_shows() {
    local part
    for part in povray cfitsio downloader certificates; do
        need_part "$part" part_is_here "$part"
    done
    need_program_of_pages
    export PATH="$PWD/home/.local/bin:$PATH"
    mkdir work
    cd work || exit
    run run_page "$MSISF_TESTED_ROOT/docs/first-day.md" "$MSISF_TESTED_ROOT"
    assert_code 0
    assert_says 'blocks'
    assert_file "$HOME/.local/share/man/man1/msis.1"
}

test_first_day_what_a_page_says_wrongly_is_found() {
    need_part python3 test -x /usr/bin/python3
    # shellcheck disable=SC2016 # Markdown
    printf '%s\n' '# Page' '```sh' 'echo "a  b"; echo "msis: a note" >&2; echo more >&2; exit 5' '```' 'As in' '```text' 'a  b' \
        'msis: a note' 'exit code 5' '```' '```python' 'print(1 + 1)' '```' '```json' '{' '```' '```sh clone' 'pwd' '```' >page.md
    run run_page page.md /
    assert_code 0
    assert_same "$output" '3 blocks'
    local wrong
    for wrong in 's/^a  b$/a b/' 's/^msis: a note/msis: no note/' 's/^exit code 5/exit code 4/' 's/print(1/print(x/' \
        's/^pwd/cd nowhere/'; do
        sed "$wrong" page.md >wrong.md
        run run_page wrong.md /
        assert_code 1
        assert_says 'wrong.md, line '
    done
}
