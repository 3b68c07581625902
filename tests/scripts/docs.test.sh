# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

english() { python3 -B "$MSISF_TESTED_ROOT/tests/scripts/english.py" "$@"; }

links() { python3 -B "$MSISF_TESTED_ROOT/tests/scripts/links.py" "$@"; }

test_docs_links_lead_somewhere_and_every_page_is_reached() {
    need python3
    local pages
    mapfile -t pages < <(cd "$MSISF_TESTED_ROOT" && printf '%s\n' ./*.md docs/*.md tests/Msisf.Benchmarks/results/*.md input/*.md kernels/*.md output/*.md pattern-repository/*.md tests/*.md tests/golden/*.md tests/Msisf.Stress/*.md |
        grep -v -F '*' | sed 's|^\./||')
    [ "${#pages[@]}" -gt 15 ] || fail "only ${#pages[@]} pages were found"
    run links "$MSISF_TESTED_ROOT" "${pages[@]}"
    assert_code 0
}

test_docs_broken_links_are_found() {
    need python3
    cat >README.md <<'PAGE'
# A page
[good](b.md#a-heading-of-b) `[no](link.md)`
[gone](c.md)
![gone](c.png) <img src="d.png" width="1">
[gone](b.md#gone)
PAGE
    cat >b.md <<'PAGE'
## A heading, of `b`
[up](README.md)
PAGE
    touch lonely.md
    run links . README.md b.md lonely.md
    assert_code 1
    assert_same "$output" "$(printf '%s\n' 'README.md: c.md: there is no such file' 'README.md: c.png: there is no such file' \
        'README.md: d.png: there is no such file' 'README.md: b.md#gone: there is no such heading' 'lonely.md: no link leads here from README.md')"
}

test_docs_sentences_are_short_and_idiomatic() {
    need python3
    cd "$MSISF_TESTED_ROOT" || exit
    run english README.md docs/*.md 'CHANGELOG.md#Unreleased'
    assert_code 0
}

test_docs_messages_and_comments_are_idiomatic() {
    need python3
    local files
    mapfile -t files < <(find "$MSISF_TESTED_ROOT/src" -name '*.cs' -not -path '*/obj/*' -not -path '*/bin/*')
    [ "${#files[@]}" -gt 500 ] || fail "only ${#files[@]} files were found"
    run english "${files[@]}"
    assert_code 0
}

test_docs_foreign_wording_of_messages_and_comments_is_found() {
    need python3
    cat >messages.cs <<'CODE'
// A comment. Of this
// comment something counts.
/// <summary>Else <see cref="Of.X"/> counts.</summary>
throw new UsageException($"{name}: '{text}' is no "
    + $"layer of {other}. Give another one.");
string format = "is no";
string good = "This is not a layer. There is no such file.";
string late = "Of these files none is read."; // a good one, which is told elsewhere
string address = "https://else.it.is/no page";
CODE
    run english messages.cs
    assert_code 1
    assert_same "$(printf '%s\n' "$output" | cut -d : -f 2,4-)" "$(printf '%s\n' \
        "4: X: 'X' is no layer of X." '8: Of these files none is read.' '1: Of this comment something counts.' \
        '3: Else X counts.' '8: a good one, which is told elsewhere' \
        '0 of 0 sentences have more than 30 words (0.0 %, at most 3 %)')"
}

# shellcheck disable=SC2016 # backticks of Markdown
test_docs_long_sentences_and_foreign_wording_are_found() {
    need python3
    {
        echo '# A page'
        echo
        for _ in $(seq 99); do printf 'This is a short sentence with `code` in it. '; done
        # 30 words with a quantity and code as one each, then 31
        printf 'A sentence of %sten words, 5 km and `--option 7` ends here. ' "$(printf 'very %.0s' $(seq 20))"
        printf 'A sentence of %sten words, 5 km and `--option 7` ends here.\n' "$(printf 'very %.0s' $(seq 21))"
    } >good.md
    run english good.md
    assert_code 0
    assert_same "$output" '1 of 101 sentences have more than 30 words (1.0 %, at most 3 %)'
    run english --all good.md
    assert_says 'good.md:3: 31 words: A sentence of very'

    printf '\n| a cell | Of each cell the middle counts. |\n\n- The ground that stands there.\n- There is no file, and no data; stands for it.\n- Nothing else.\n' >>good.md
    printf '%s\n' '```' 'Of this block nothing counts.' '```' '- The value is no height.' '## Unreleased' 'Else it is left out.' '## 1.0' 'Else it was.' >>good.md
    run english good.md
    assert_code 1
    assert_same "$(printf '%s\n' "$output" | cut -d : -f 2,4)" "$(printf '%s\n' \
        '5: Of each cell the middle counts.' '7: The ground that stands there.' '13: The value is no height.' \
        '15: Else it is left out.' '17: Else it was.' '1 of 107 sentences have more than 30 words (0.9 %, at most 3 %)')"
    run english 'good.md#Unreleased'
    assert_code 1
    assert_same "$(printf '%s\n' "$output" | head -n 1 | cut -d : -f 2,4)" '15: Else it is left out.'
    run english 'good.md#Nowhere'
    assert_code 1
    assert_says 'there is no heading "Nowhere"'

    for _ in 1 2 3 4; do printf 'A sentence of %sten words, 5 km and `--option 7` ends here.\n' "$(printf 'very %.0s' $(seq 41))"; done >long.md
    run english long.md
    assert_code 1
    assert_says 'long.md:1: 51 words: A sentence'
}

test_docs_drawings_are_those_of_the_code() {
    need python3
    local docs=$MSISF_TESTED_ROOT/docs/drawings drawing
    python3 -B "$docs/draw.py" made
    for drawing in "$docs"/*.svg; do
        cmp "$drawing" "made/${drawing##*/}" || fail "$drawing is another one: run python3 docs/drawings/draw.py"
    done
    assert_same "$(cd made && ls)" "$(cd "$docs" && ls -- *.svg)"
}

test_docs_drawings_need_the_constants_of_the_code() {
    need python3
    mkdir -p clone/docs
    cp -R "$MSISF_TESTED_ROOT/docs/drawings" clone/docs
    mkdir clone/src
    cp -R "$MSISF_TESTED_ROOT/src/Msisf.Core" clone/src
    sed -i 's/SizeDegrees = 5;/SizeDegrees = 6;/' "$(find clone/src -name TileId.cs)"
    python3 -B clone/docs/drawings/draw.py made
    grep -q 'a tile of 6 x 6 degrees' made/selection.svg || fail 'the drawing has not followed the code'
    sed -i 's/SizeDegrees = 6;/Size = 6;/' "$(find clone/src -name TileId.cs)"
    run python3 -B clone/docs/drawings/draw.py made
    assert_code 1
    assert_says 'TileId.cs has no constant SizeDegrees'
}
