# Sourced by run, check and scripts/tidy, from the top of the tree.

# packages_for run|check|package: the names in packages.txt; the others need those of "run" too.
packages_for()
{
    awk -v who="$1" '!/^#/ && NF && ($2 == "run" || $2 == who) { print $1 }' packages.txt
}

# packages_of KIND: those of that kind alone.
packages_of()
{
    awk -v who="$1" '!/^#/ && NF && $2 == who { print $1 }' packages.txt
}

# installed PACKAGE...: those of them that are installed.
installed()
{
    dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | awk '$1 == "installed" { print $2 }' || true
}

# missing PACKAGE...: those of them that are not installed.
missing()
{
    comm -23 <(printf '%s\n' "$@" | sort -u) <(installed "$@" | sort -u)
}

# as_root COMMAND...
as_root()
{
    if [[ $EUID -eq 0 ]]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        echo "This needs root, and there is no sudo. As root, call: $*" >&2
        return 1
    fi
}

# install_optional: tries to install what nobody needs; without it something is left out, which is said where it is missed.
install_optional()
{
    local wanted
    # shellcheck disable=SC2046
    mapfile -t wanted < <(missing $(packages_of optional))
    if [[ ${#wanted[@]} -gt 0 ]]; then
        echo "Installing, if it can be: ${wanted[*]}"
        as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${wanted[@]}" ||
            echo "Not installed: ${wanted[*]}. All else works without."
    fi
}

# install_packages run|check|package: installs what is missing; elsewhere than on Debian and Ubuntu it names what is needed.
install_packages()
{
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        echo "Packages are installed by this script on Debian and Ubuntu only. What is needed, by its name there:"
        packages_for "$1" | paste -sd ' '
        return
    fi
    local wanted
    # shellcheck disable=SC2046
    mapfile -t wanted < <(missing $(packages_for "$1"))
    if [[ ${#wanted[@]} -gt 0 ]]; then
        echo "Installing: ${wanted[*]}"
        as_root apt-get update -q
        as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${wanted[@]}"
    fi
    install_optional
}

# build PRESET [TARGET...]: these targets, or all. Warnings stop the build in continuous integration only, and there
# with the compiler that they are mended for.
build()
{
    local preset=$1
    shift
    local options=()
    if [[ ${CI:-} != true ]]; then
        options=(-DRASTERLENS_WERROR=OFF)
    fi
    cmake --preset "$preset" "${options[@]}"
    cmake --build --preset "$preset" --parallel "$(nproc 2>/dev/null || echo 2)" ${1:+--target "$@"}
}
