#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A program that knows nothing of OpenRT: 3dview, a demonstration of freeglut (solids, two lights,
# text, a camera). It is fetched with Debian's source package `freeglut` (MIT licence), compiled
# unchanged with `-include openrt/gl.h`, and renders four frames off screen. Nothing is kept but
# the pictures. Needs apt-get with the network, a C compiler, a build of OpenRT.
#
#   samples/ports/foreign/run.sh BUILD PICTURES
set -euo pipefail

if [ $# -ne 2 ]; then
    echo "usage: $0 BUILD PICTURES" >&2
    exit 2
fi
root=$(cd "$(dirname "$0")/../../.." && pwd)
build=$(cd "$1" && pwd)
mkdir -p "$2"
pictures=$(cd "$2" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The system's package sources, as sources of source packages, with lists of our own.
mkdir -p "$work/sources" "$work/lists/partial" "$work/cache/archives/partial"
for file in /etc/apt/sources.list.d/*.sources; do
    if [ -e "$file" ]; then
        sed 's/^Types:.*/Types: deb-src/' "$file" >"$work/sources/$(basename "$file")"
    fi
done
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    if [ -e "$file" ]; then
        sed -n 's/^deb /deb-src /p' "$file" >"$work/sources/$(basename "$file")"
    fi
done
options=(-q -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$work/sources"
    -o "Dir::State::lists=$work/lists" -o "Dir::Cache=$work/cache")
if [ "$(id -u)" -eq 0 ]; then
    options+=(-o APT::Sandbox::User=root)
fi
cd "$work"
apt-get "${options[@]}" update >/dev/null
apt-get "${options[@]}" --download-only --tar-only source freeglut >/dev/null
tar -xf freeglut_*.orig.tar.*
program=$(echo freeglut-*/progs/demos/3dview)

# Its textures and models lie in its folder, if it has any.
cd "$program"
"${CC:-cc}" -w -I "$root/include/openrt/gl" -I "$root/include" -I "$build/include" \
    -include openrt/gl.h ./*.c -o "$work/3dview" \
    -L "$build/lib" -Wl,-rpath,"$build/lib" -lrtut -lOpenRT -lm
"$work/3dview" --rt-offscreen 4 --rt-output "$pictures/3dview-%d.png"
ls "$pictures"/3dview-*.png
