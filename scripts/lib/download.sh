# shellcheck shell=bash
# Sourced after common.sh: downloads and checksums.

# download URL FILE: one try. A refused connection fails at once, a silent one after 5 s, a stalled one after 15 s.
download() {
    if have curl; then
        curl --fail --silent --show-error --location --connect-timeout 5 --speed-limit 1000 --speed-time 15 \
            --output "$2" "$1"
    elif have wget; then
        wget --no-verbose --tries=1 --connect-timeout=5 --dns-timeout=5 --read-timeout=15 --output-document="$2" "$1"
    else
        warn 'neither curl nor wget is installed'
        return 1
    fi
}

sha256_of() {
    if have sha256sum; then
        sha256sum <"$1"
    else
        shasum -a 256 <"$1"
    fi | cut -d ' ' -f 1
}

size_of() { wc -c <"$1" | tr -d ' '; }
