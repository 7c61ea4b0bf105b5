# SPDX-License-Identifier: MIT
# The Debian 12 packages that building, testing and the demo take, and those of the long runs. To be
# sourced.
packages=(
    g++ cmake make ninja-build pkg-config python3 binutils # to build, and to check what was built
    abigail-tools                                     # the binary interface against releases'
    libglm-dev libhwy-dev                             # the library
    libtinygltf-dev nlohmann-json3-dev libassimp-dev  # scenes, in the programs
    libstb-dev libpng-dev libopenexr-dev libcli11-dev # images and command lines, in the programs
    libglfw3-dev libgl-dev libopenxr-dev              # the viewers
    libgtest-dev libgmp-dev                           # the tests; exact arithmetic as the truth
    python3-cffi python3-numpy python3-pytest         # the Python module and its tests
    python3-pip python3-setuptools python3-wheel      # its wheel,
    python3-venv                                      # and where that is installed
    libembree-dev                                     # the benchmark's yardstick
    libbenchmark-dev valgrind                         # kernels one by one; instructions counted
    libopenmpi-dev openmpi-bin liblz4-dev             # several machines that render together
    libosmesa6-dev libglu1-mesa-dev                   # OpenGL itself, to compare the ports with
    doxygen help2man                                  # the site and the manual pages
)
long_packages=(
    clang libclang-rt-14-dev                          # the other compiler; fuzzing
    lintian debootstrap                               # packages judged; a bare Debian
    xvfb xauth                                        # windows that are opened
)

# install_packages PACKAGE...: those that are missing; silent if none is.
install_packages() {
    local missing=() package
    if ! command -v apt-get >/dev/null; then
        echo "No apt-get here. What the project needs, as Debian calls it: $*"
        return 0
    fi
    for package in "$@"; do
        if [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
            missing+=("$package")
        fi
    done
    if [ ${#missing[@]} -eq 0 ]; then
        return 0
    fi
    local root=()
    if [ "$(id -u)" -ne 0 ]; then
        root=(sudo)
        if ! command -v sudo >/dev/null; then
            echo "Please install as root: apt-get install ${missing[*]}" >&2
            return 1
        fi
    fi
    echo "Installing ${missing[*]}"
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q &&
        "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
            apt-get install -q -y --no-install-recommends "${missing[@]}"
}
