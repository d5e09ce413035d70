# Sourced by run, check and scripts/tidy, from the top of the tree.

# packages_for run|check|package: the names in packages.txt; the others need those of "run" too.
packages_for()
{
    awk -v who="$1" '!/^#/ && NF && ($2 == "run" || $2 == who) { print $1 }' packages.txt
}

missing_packages()
{
    local installed
    # shellcheck disable=SC2046
    installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $(packages_for "$1") 2>/dev/null |
        awk '$1 == "installed" { print $2 }' || true)
    comm -23 <(packages_for "$1" | sort -u) <(sort -u <<<"$installed")
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

# install_packages run|check|package: installs what is missing; elsewhere than on Debian and Ubuntu it names what is needed.
install_packages()
{
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        echo "Packages are installed by this script on Debian and Ubuntu only. What is needed, by its name there:"
        packages_for "$1" | paste -sd ' '
        return
    fi
    local missing
    mapfile -t missing < <(missing_packages "$1")
    if [[ ${#missing[@]} -eq 0 ]]; then
        return
    fi
    echo "Installing: ${missing[*]}"
    as_root apt-get update -q
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
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
