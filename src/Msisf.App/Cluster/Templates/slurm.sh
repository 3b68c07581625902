#!/bin/sh
@SBATCH_LINES@
# @HEAD@
# The pieces of a run as a Slurm job array: sh FILE, or sbatch FILE. Submitted again, it makes what is missing. After the array a job looks
# at all frames, submits again just those that are missing or broken, and at last merges the set. MSIS names another program to run.
set -eu

if [ -z "${MSIS:-}" ]; then MSIS=@LAUNCHER@; fi
script=@SCRIPT@ # Slurm runs a copy of it
logs=@LOGS@     # a percent sign is doubled there: sbatch has fields such as %j in the names of logs
retries=@RETRIES@
needs_patterns=@NEEDS_PATTERNS@
cd @WORKING_FOLDER@

pieces() {
    cat <<'END'
@PIECES@
END
}

# Appends the ids of a job to FILE.jobs, and leaves it in $job. A job waits for a controller that does not answer; a user is told at once.
submit() {
    tries=60
    until job=$(sbatch --parsable "$@"); do
        [ -n "${SLURM_JOB_ID:-}" ] && [ "$tries" -gt 0 ] || return 3
        tries=$((tries - 1))
        sleep 10
    done
    job=${job%%;*}
    printf '%s\n' "$job" >>"$script.jobs"
}

# submit_round ROUND [OPTION]: an array over the lines of FILE.round-ROUND, and the job that looks at what came of it.
submit_round() {
    tasks=$(wc -l <"$script.round-$1")
    submit --array="1-$((tasks))@CONCURRENCY@" --output="$logs/round-$1-%a.log" ${2:+"$2"} "$script" piece "$1"
    echo "round $1: $((tasks)) pieces, job $job"
    submit --output="$logs/check-$1.log" --dependency="afterany:$job" "$script" check "$1"
    echo "round $1: check, job $job"
}

# Cuts a list of frames (3:5,17) into lines, no more than there are pieces; one with more than 10000 frames could be too long for a command line.
cut_frames() {
    tr ',' '\n' | awk -F : -v pieces="$(pieces | wc -l)" '
        { for (step = $1 + 0; step <= $NF + 0; step++) steps[++count] = step }
        END {
            size = int((count + pieces - 1) / pieces)
            if (size > 10000) size = 10000
            for (last = 1; last <= count; last++) {
                first = last
                while (last < count && last % size != 0 && steps[last + 1] == steps[last] + 1) last++
                printf first == last ? "%d" : "%d:%d", steps[first], steps[last]
                printf last % size == 0 || last == count ? "\n" : ","
            }
        }'
}

# Leaves the exit code of the whole run in FILE.result.
finish() {
    printf '%s\n' "$1" >"$script.result.new"
    mv "$script.result.new" "$script.result"
    exit "$1"
}

export DOTNET_PROCESSOR_COUNT="${SLURM_CPUS_PER_TASK:-1}"
case ${1:-submit} in
    submit)
        rm -f "$script".jobs "$script".result "$script".missing "$script".round-*
        pieces >"$script.round-0"
        after=
        if [ "$needs_patterns" = yes ]; then
            submit --output="$logs/patterns.log" "$script" patterns
            echo "patterns: job $job"
            after=--dependency=afterany:$job # a piece makes by itself what this job may have left out
        fi
        submit_round 0 "$after"
        ;;
    patterns)
        exec "$MSIS" patterns @PATTERN_ARGUMENTS@
        ;;
    piece)
        frames=$(sed -n "${SLURM_ARRAY_TASK_ID}p" "$script.round-$2")
        exec "$MSIS" @ARGUMENTS@ @JOBS@ --frames "$frames"
        ;;
    check)
        code=0
        if [ -e @OUTPUT_FOLDER@/@MANIFEST@ ]; then
            missing=$("$MSIS" verify @OUTPUT_FOLDER@ --print-frames) || code=$?
        else
            code=5 missing=$(pieces | paste -s -d , -) # no piece ever began
        fi
        if [ "$code" -eq 0 ]; then
            "$MSIS" merge @OUTPUT_FOLDER@ @MERGE_OPTIONS@ || code=$?
            finish "$code"
        elif [ "$code" -ne 5 ] || [ -z "$missing" ]; then
            finish "$code"
        elif [ "$2" -lt "$retries" ]; then
            printf '%s\n' "$missing" | cut_frames >"$script.round-$(($2 + 1))"
            submit_round "$(($2 + 1))"
        else
            echo "not made after $retries retries: $missing"
            printf '%s\n' "$missing" >"$script.missing"
            finish 5
        fi
        ;;
esac
