# shellcheck shell=bash
# Sourced after common.sh: tries a package in a root file system that has the C library and a shell, and nothing else. Needs root.

# make_bare_root FOLDER
make_bare_root() {
    local program library
    mkdir -p "$1/bin"
    for program in sh readlink; do
        cp -L "$(command -v "$program")" "$1/bin"
    done
    # What Debian's libc6 holds: libraries for Linux on x86-64 may name these five.
    for library in /lib64/ld-linux-x86-64.so.2 /lib/x86_64-linux-gnu/lib{c.so.6,m.so.6,dl.so.2,pthread.so.0,rt.so.1}; do
        install -D -m 755 "$library" "$1$library"
    done
    add_devices "$1"
}

add_devices() { # ROOT
    mkdir -p "$1"/{dev,proc,tmp}
    mknod -m 666 "$1/dev/null" c 1 3
    mknod -m 666 "$1/dev/urandom" c 1 9
}

# add_python ROOT: Debian's Python with NumPy, and the libraries that these two name.
add_python() {
    local library
    install_parts numpy || die 'NumPy is needed to try the package for pip.'
    install -D -m 755 /usr/bin/python3 "$1/usr/bin/python3"
    mkdir -p "$1/usr/lib/python3/dist-packages"
    cp -a /usr/lib/python3.[0-9]* "$1/usr/lib"
    cp -aL /usr/lib/python3/dist-packages/numpy "$1/usr/lib/python3/dist-packages"
    while read -r library; do
        [ -e "$1$library" ] || install -D -m 755 "$library" "$1$library"
    done < <(find "$1/usr/lib/python3" "$1"/usr/lib/python3.*/lib-dynload "$1/usr/bin/python3" \( -name '*.so' -o -name python3 \) \
        -exec ldd {} + 2>/dev/null | sed -n 's|.*=> \(/[^ ]*\) .*|\1|p' | sort -u)
}

# What tells the kernel that programs for ARM on 64 bits run under qemu: the head of such a file, and which bits of it count.
arm_programs=':arm64:M::\x7fELF\x02\x01\x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x02\x00\xb7\x00'
arm_programs+=':\xff\xff\xff\xff\xff\xff\xff\x00\xff\xff\xff\xff\xff\xff\xff\xff\xfe\xff\xff\xff'

# within_root FOLDER COMMAND...: its processes see their own /proc, which goes with them. Programs for ARM run there, and nowhere else on
# this machine: that needs Linux 6.7.
within_root() {
    local own=() interpreter=''
    if [ -e "$1/lib/ld-linux-aarch64.so.1" ]; then
        own=(--user --map-root-user)
        interpreter=$arm_programs:$(command -v qemu-aarch64-static):FPC
    fi
    # shellcheck disable=SC2016 # expanded by the inner shell
    env -i PATH=/usr/bin:/bin INTERPRETER="$interpreter" "$(command -v unshare)" "${own[@]}" --mount --pid --fork --kill-child sh -ec '
        if [ -n "$INTERPRETER" ]; then
            mount -t binfmt_misc none "$1/proc"
            printf "%s" "$INTERPRETER" >"$1/proc/register"
        fi
        mount -t proc proc "$1/proc"
        cd "$1"
        root=$1
        shift
        exec /usr/sbin/chroot "$root" "$@"' sh "$@"
}

# try_package ROOT STARTER FOLDER FILE...: draws there by command line and by server. FOLDER has the pictures that are right, and gets what
# comes of it; the named ones have to be the same.
try_package() {
    local root=$1 starter=$2 file
    mkdir -p "$3/here"
    # shellcheck disable=SC2046 # words
    within_root "$root" "$starter" $(words_of_trial) --output-dir /tmp/out >"$3/here/stdout" 2>"$3/here/stderr" </dev/null || {
        cat "$3/here/stderr" >&2
        return 1
    }
    for file in "${@:4}"; do
        cmp "$root/tmp/out/$file" "$3/$file" || return 1
    done
    try_server "$3" within_root "$root" "$starter" serve
}

# try_server FOLDER SERVE...: SERVE starts a server, which draws the picture for a client and shows the viewer, and ends with its input.
try_server() {
    local folder=$1 address='' server hold code=1
    mkdir -p "$folder/here"
    rm -f "$folder/here"/{input,address}
    mkfifo "$folder/here/input"
    exec {hold}<>"$folder/here/input"
    "${@:2}" --listen=127.0.0.1:0 --end-with-input --max-seconds=600 >"$folder/here/address" 2>"$folder/here/stderr" <"$folder/here/input" {hold}>&- &
    server=$!
    for _ in $(seq 600); do
        read -r address <"$folder/here/address" && break
        kill -0 "$server" 2>/dev/null || break
        sleep 0.1
    done
    address=${address%$'\r'}
    if [ -n "$address" ] &&
        curl -fsS "$address/v1/render" -H 'Content-Type: application/json' -o "$folder/here/served.png" -d "$(request_of_trial)" &&
        cmp "$folder/here/served.png" "$folder/trial.png" && curl -fsS "$address/" -o "$folder/here/page.html" &&
        grep -qi '<html' "$folder/here/page.html"; then
        code=0
    else
        cat "$folder/here/stderr" >&2
    fi
    exec {hold}>&-
    wait "$server" || code=1
    return "$code"
}

words_of_trial() {
    say "--renderer native --position -58.6,-14.5,60000 --time 2010-04-06T20:24:00Z --width 320 --height 240 --rendering-annotation \
--output-name trial --batch --ephemeris builtin"
}

# The same picture.
request_of_trial() {
    say '{"position": [-58.6, -14.5, 60000], "time": "2010-04-06T20:24:00Z", "width": 320, "height": 240, "ephemeris": "builtin"}'
}
