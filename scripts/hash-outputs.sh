#!/usr/bin/env bash
# Prints the SHA-256 of every file that a build of msis writes in a matrix of options and scenes, and of a server's answers, so that a change
# that should leave all bytes alone can be held against the build before it.
#     scripts/hash-outputs.sh PROGRAM FOLDER     FOLDER, which must not exist, keeps the files
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/same-bytes.sh"

help_if_asked "$@"
[ $# -eq 2 ] || die 'usage: scripts/hash-outputs.sh PROGRAM FOLDER'
[ ! -e "$2" ] || die "$2: it exists. Name a new folder."
mkdir -p "$2"
program=$(cd "$(dirname "$1")" && pwd -P)/$(basename "$1")
folder=$(cd "$2" && pwd -P)
cd "$root"
hashes_of "$program" "$folder"
