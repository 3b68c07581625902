# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"
. "$MSISF_TESTED_ROOT/tests/scripts/pages.sh"

# A stand-in where ffmpeg is missing: the last argument is the video's file.
make_ffmpeg() {
    make_executable bin/ffmpeg <<'FFMPEG'
#!/bin/sh
for last; do :; done
echo video >"$last"
FFMPEG
    export PATH="$PWD/bin:$PATH"
}

test_recipes_every_command_of_the_page_runs() {
    need_program_of_pages
    command -v ffmpeg >/dev/null || make_ffmpeg
    # Smaller images and fewer of them: what a page says of sizes and counts is not what is tested.
    sed -E 's/(--width|--height) ([0-9]+)[0-9]\b/\1 \2/g; s/^count: 1000/count: 4/; s/i < 24/i < 4/; s/1:12/1:2/; s/13:24/3:4/' \
        "$MSISF_TESTED_ROOT/docs/recipes.md" >recipes.md
    run run_page recipes.md "$MSISF_TESTED_ROOT"
    assert_code 0
    assert_same "$output" '10 blocks'
    local file
    for file in earth/earth.png sunset/clavius.png descent/video.mp4 pair/2.images.txt both/msisf-manifest.jsonl talk/talk.png; do
        assert_file "$file"
    done
}
