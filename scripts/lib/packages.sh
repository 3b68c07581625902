# shellcheck shell=bash
# Sourced after common.sh: the foreign parts that MSISF needs, and how each system names them.

# Succeeds if the part is on this machine already.
part_is_here() {
    case $1 in
        downloader) have curl || have wget ;;
        compiler) have cc || have gcc ;;
        static-openssl) compgen -G '/usr/lib/*/libcrypto.a' >/dev/null || [ -e /usr/lib64/libcrypto.a ] ;;
        lld) have ld.lld ;;
        qemu) have qemu-aarch64-static ;;
        objcopy-*) have "${1#objcopy-}-linux-gnu-objcopy" ;;
        cfitsio) library_is_here libcfitsio ;;
        astropy) python_package_is_here astropy ;;
        gdal) have gdalinfo && python_package_is_here osgeo ;;
        gdal-library) library_is_here libgdal ;;
        matplotlib) python_package_is_here matplotlib ;;
        numpy) python_package_is_here numpy ;;
        torch | zmq) python_package_is_here "$1" ;;
        pytest) python_package_is_here pytest ;;
        pip) python_package_is_here pip && python_package_is_here setuptools && python_package_is_here wheel ;;
        icu) [ "$(uname -s)" = Darwin ] || library_is_here libicuuc ;;
        certificates) certificates_are_here ;;
        php) have php && php -r 'exit(PHP_VERSION_ID >= 80200 && extension_loaded("pdo_mysql") ? 0 : 1);' ;;
        mariadbd) sbin_has mariadbd && have mariadb-install-db ;;
        octave) have octave-cli && octave-cli --eval 'pkg load instrument-control' >/dev/null 2>&1 ;;
        slurm) have sbatch && sbin_has munged && sbin_has slurmctld && sbin_has slurmd ;;
        *) have "$1" ;;
    esac
}

# Daemons: their folder is not on every user's PATH.
sbin_has() { have "$1" || [ -x "/usr/sbin/$1" ]; }

# ldconfig is not on every user's PATH; Homebrew's libraries are in its own folders.
library_is_here() {
    local known
    known=$(PATH="$PATH:/sbin:/usr/sbin" ldconfig -p 2>/dev/null) || known=''
    case $known in
        *"$1".so*) return 0 ;;
        *) compgen -G "/opt/homebrew/lib/$1*.dylib" >/dev/null || compgen -G "/usr/local/lib/$1*.dylib" >/dev/null ;;
    esac
}

# Of the system's Python: another one on the PATH has packages of its own.
python_package_is_here() {
    [ -x /usr/bin/python3 ] && /usr/bin/python3 -c "import $1" 2>/dev/null
}

# Without them every download fails, NuGet's too. Only a minimal Linux lacks them.
certificates_are_here() {
    [ "$(uname -s)" = Darwin ] || [ -s /etc/ssl/certs/ca-certificates.crt ] || [ -s /etc/pki/tls/certs/ca-bundle.crt ]
}

# package_of MANAGER PART: the package, or packages, that hold a part.
package_of() {
    case $1-$2 in
        *-downloader) echo curl ;;
        *-certificates) echo ca-certificates ;;
        apt-compiler) echo gcc libc6-dev ;;
        *-compiler) echo gcc ;;
        apt-objcopy-*) echo "binutils-${2#objcopy-}-linux-gnu" ;;
        apt-static-openssl) echo libssl-dev ;;
        *-static-openssl) echo openssl ;;
        apt-cfitsio) echo libcfitsio10 ;;
        apt-astropy) echo python3-astropy python3-numpy ;;
        apt-gdal) echo gdal-bin python3-gdal ;;
        dnf-gdal) echo gdal python3-gdal ;;
        apt-gdal-library) echo python3-gdal ;; # the library alone has its version in its name
        dnf-gdal-library) echo gdal-libs ;;
        *-gdal-library) echo gdal ;;
        apt-matplotlib) echo python3-matplotlib ;;
        dnf-astropy | dnf-matplotlib) echo "python3-$2" ;;
        pacman-astropy | pacman-matplotlib) echo "python-$2" ;;
        brew-astropy) echo astropy ;;
        brew-matplotlib) echo python-matplotlib ;;
        apt-numpy | apt-pytest | apt-torch | apt-zmq) echo "python3-$2" ;;
        apt-pip | dnf-pip) echo python3-pip python3-setuptools python3-wheel ;;
        dnf-numpy | dnf-pytest | dnf-torch | dnf-zmq) echo "python3-$2" ;;
        pacman-numpy | pacman-pytest) echo "python-$2" ;;
        pacman-pip) echo python-pip python-setuptools python-wheel ;;
        apt-icu) echo libicu-dev ;; # the run-time package alone has its version in its name
        apt-qemu) echo qemu-user-static ;;
        apt-wine) echo wine wine64 ;;
        apt-octave) echo octave octave-instrument-control ;;
        apt-xmllint) echo libxml2-utils ;;
        apt-php) echo php-cli php-mysql ;;
        # Not mariadb-server: that one starts a server, also at every boot. The tests start their own.
        apt-mariadbd) echo mariadb-server-core mariadb-client-core ;;
        # Not slurm-wlm: the tests start the daemons themselves, as whoever runs them, and need no accounting and no e-mail.
        apt-slurm) echo slurmctld slurmd slurm-client munge ;;
        dnf-slurm) echo slurm slurm-slurmctld slurm-slurmd munge ;;
        pacman-slurm) echo slurm-llnl munge ;;
        dnf-php) echo php-cli php-mysqlnd ;;
        dnf-mariadbd) echo mariadb-server ;;
        pacman-mariadbd) echo mariadb ;;
        brew-mariadbd) echo mariadb ;;
        dnf-icu) echo libicu ;;
        dnf-shellcheck) echo ShellCheck ;;
        pacman-zmq) echo python-pyzmq ;;
        *-xmllint) echo libxml2 ;;
        *) echo "$2" ;;
    esac
}

# packages_of MANAGER PART...: the same for several, in one line.
packages_of() {
    local manager=$1 part words=()
    shift
    for part in "$@"; do
        words+=("$(package_of "$manager" "$part")")
    done
    say "${words[*]}"
}

# Installs what is missing of the named parts. Fails, and has said what to do, if that is not possible.
install_parts() {
    local part missing=() packages
    for part in "$@"; do
        part_is_here "$part" || missing+=("$part")
    done
    [ ${#missing[@]} -gt 0 ] || return 0

    if have apt-get; then
        read -ra packages <<<"$(packages_of apt "${missing[@]}")"
        apt_install "${packages[@]}"
    else
        warn "please install ${missing[*]}, then run this again: $(install_command "${missing[@]}")"
        return 1
    fi
}

# What a person types where this script does not install by itself.
install_command() {
    if have dnf; then
        say "sudo dnf install $(packages_of dnf "$@")"
    elif have pacman; then
        say "sudo pacman -S $(packages_of pacman "$@")"
    elif have brew; then
        say "brew install $(packages_of brew "$@")"
    else
        say "with your system's package manager"
    fi
}

# Debian's packages start what they install, unless this file, which is seldom there, says not to.
start_policy=/usr/sbin/policy-rc.d

# without_starting COMMAND...: nothing that it installs is left running; the tests start their own daemons.
without_starting() {
    local code=0
    if [ -e "$start_policy" ]; then
        "$@"
        return
    fi
    # shellcheck disable=SC2016 # expanded by the inner shell
    printf '#!/bin/sh\nexit 101\n' | as_root sh -c 'cat >"$1" && chmod 755 "$1"' sh "$start_policy" || return
    "$@" || code=$?
    as_root rm -f "$start_policy"
    return "$code"
}

# The lists of packages are only renewed if they do not do as they are: a fresh machine has none.
apt_install() {
    local log
    log=$(mktemp)
    say "Installing with apt: $*"
    if without_starting apt_get install "$@" >"$log" 2>&1 ||
        { apt_get update >>"$log" 2>&1 && without_starting apt_get install "$@" >>"$log" 2>&1; }; then
        rm -f "$log"
        return 0
    fi
    tail -n 3 "$log" >&2
    rm -f "$log"
    warn "could not install $*. As root, run: apt-get update && apt-get install $*"
    return 1
}

# A fresh machine may still be busy with its first upgrades: wait for their lock.
apt_get() {
    local verb=$1
    shift
    [ "$verb" != install ] || set -- -y --no-install-recommends "$@"
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=120 "$verb" "$@" </dev/null
}
