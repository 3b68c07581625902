# shellcheck shell=bash
# Sourced after common.sh: tries a package in a root file system that has the C library and a shell, and nothing else. Needs root.

# make_bare_root FOLDER
make_bare_root() {
    local program library
    mkdir -p "$1"/{bin,dev,proc,tmp}
    for program in sh readlink; do
        cp -L "$(command -v "$program")" "$1/bin"
    done
    # What Debian's libc6 holds: libraries for Linux on x86-64 may name these five.
    for library in /lib64/ld-linux-x86-64.so.2 /lib/x86_64-linux-gnu/lib{c.so.6,m.so.6,dl.so.2,pthread.so.0,rt.so.1}; do
        install -D -m 755 "$library" "$1$library"
    done
    mknod -m 666 "$1/dev/null" c 1 3
    mknod -m 666 "$1/dev/urandom" c 1 9
}

# within_root FOLDER COMMAND...: its processes see their own /proc, which goes with them.
within_root() {
    # shellcheck disable=SC2016 # expanded by the inner shell
    env -i PATH=/usr/bin:/bin "$(command -v unshare)" --mount --pid --fork --kill-child \
        sh -c 'mount -t proc proc "$1/proc" && cd "$1" && root=$1 && shift && exec /usr/sbin/chroot "$root" "$@"' sh "$@"
}

# try_package ROOT STARTER INSTALLATION FOLDER: draws there by command line and by server. FOLDER has the pictures that are right, and gets
# what comes of it.
try_package() {
    local root=$1 starter=$2 file address='' server code=1
    mkdir -p "$root$3/input" "$4/here"
    cp -R input/ldem input/albedo "$root$3/input"
    # shellcheck disable=SC2046 # words
    within_root "$root" "$starter" $(words_of_trial) --output-dir /tmp/out >"$4/here/stdout" 2>"$4/here/stderr" </dev/null || {
        cat "$4/here/stderr" >&2
        return 1
    }
    for file in trial.png trial.annotated.png; do
        cmp "$root/tmp/out/$file" "$4/$file" || return 1
    done

    within_root "$root" "$starter" serve --listen 127.0.0.1:0 >"$4/here/address" 2>"$4/here/stderr" </dev/null &
    server=$!
    for _ in $(seq 100); do
        read -r address <"$4/here/address" && break
        sleep 0.1
    done
    if curl -fsS "$address/v1/render" -H 'Content-Type: application/json' -o "$4/here/served.png" -d "$(request_of_trial)" &&
        cmp "$4/here/served.png" "$4/trial.png" && curl -fsS "$address/" | grep -qi '<html'; then
        code=0
    else
        cat "$4/here/stderr" >&2
    fi
    kill "$server"
    return "$code"
}

words_of_trial() {
    say "--renderer native --position -58.6,-14.5,60000 --time 2010-04-06T20:24:00Z --width 320 --height 240 --rendering-annotation \
--output-name trial --batch"
}

# The same picture.
request_of_trial() {
    say '{"position": [-58.6, -14.5, 60000], "time": "2010-04-06T20:24:00Z", "width": 320, "height": 240}'
}
