#!/usr/bin/env bash
# Makes the archive that runs without installation, bergwatch-VERSION-linux-MACHINE.tar.xz in the build folder:
# the programs, every library they need but those that belong to the system, Qt's plug-ins, fonts, licences.
# The last line of the output is the archive's path. Needs a Debian, whose packages the libraries are of.
# Use: archive.sh BUILD_FOLDER
set -euo pipefail
build=$1
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
name=bergwatch-$version-linux-$(uname -m)
tree=$build/archive/$name
taken=$build/archive/taken # the files that were taken of the system

# The C library goes with the kernel, the others with the X server and the graphics driver.
system='^(ld-linux.*|linux-vdso|lib(c|m|dl|rt|pthread|resolv|util|anl)|libX11(-xcb)?|libX(au|dmcp|ext)|libxcb|libGL|libGLX|libGLdispatch|libdrm|libgbm)\.so'
# What Qt loads by itself: the X server and none, SVG icons and pictures, printers, keys that make one letter.
plugins=(platforms/libqxcb.so platforms/libqoffscreen.so platforms/libqminimal.so iconengines/libqsvgicon.so
         imageformats/libqsvg.so imageformats/libqjpeg.so printsupport/libcupsprintersupport.so
         platforminputcontexts/libcomposeplatforminputcontextplugin.so
         platforminputcontexts/libibusplatforminputcontextplugin.so)
# What is inside the programs without being a library beside them.
compiled_in=(libeigen3-dev nlohmann-json3-dev libcli11-dev)

rm -rf "$build/archive"
mkdir -p "$tree"/{bin,lib,plugins,licences}

take() {
    cp -L "$1" "$2"
    realpath "$1" >>"$taken"
}

# Libraries of a program or plug-in, and theirs: name, then path.
libraries() { LC_ALL=C ldd "$1" | sed -nE 's|^\t([^ ]+) => (/[^ ]+) \(.*|\1 \2|p'; }

take_libraries() {
    local library path
    while read -r library path; do
        [[ ! $library =~ $system ]] || continue
        [ ! -e "$tree/lib/$library" ] || continue
        take "$path" "$tree/lib/$library"
    done < <(libraries "$1")
    ! LC_ALL=C ldd "$1" | grep 'not found' || return 1
}

# Folder of ecCodes' definitions, if the programs read GRIB and it has any.
codes_definitions() {
    local folder=/usr/share/eccodes/definitions
    [ ! -e "$tree/lib/libeccodes.so.0" ] || [ ! -f "$folder/boot.def" ] || echo "$folder"
}

cmake --install "$build" --prefix "$tree" --strip >/dev/null
for program in "$tree"/bin/* "$tree"/libexec/bergwatch/*; do
    take_libraries "$program"
done
qt_plugins=$(qmake6 -query QT_INSTALL_PLUGINS)
for plugin in "${plugins[@]}"; do
    mkdir -p "$tree/plugins/${plugin%/*}"
    take "$qt_plugins/$plugin" "$tree/plugins/$plugin"
    take_libraries "$qt_plugins/$plugin"
done

# Run paths that come before LD_LIBRARY_PATH, which may name another Qt.
run_path() { patchelf --force-rpath --set-rpath "$1" "${@:2}"; }
run_path '$ORIGIN' "$tree"/lib/*
run_path '$ORIGIN/../lib' "$tree"/bin/*
run_path '$ORIGIN/../../lib' "$tree"/libexec/bergwatch/* "$tree"/plugins/*/*
printf '[Paths]\nPrefix = ..\nPlugins = plugins\n' >"$tree/bin/qt.conf"

# A system without a desktop may have no fonts.
mkdir -p "$tree/share/bergwatch/fonts"
for font in DejaVuSans DejaVuSans-Bold DejaVuSansMono; do
    take "/usr/share/fonts/truetype/dejavu/$font.ttf" "$tree/share/bergwatch/fonts"
done
cp "$source_dir/resources/package/archive/fonts.conf" "$tree/share/bergwatch"

# ecCodes finds what the numbers in GRIB files mean in files; those of edition 2 are 24 MB, in the archive 0.4.
definitions=$(codes_definitions)
if [ -n "$definitions" ]; then
    mkdir -p "$tree/share/bergwatch/eccodes"
    cp -rL "$definitions"/{*.def,*.table,common,grib2} "$tree/share/bergwatch/eccodes"
    realpath "$definitions/boot.def" >>"$taken"
fi

# Where /lib is /usr/lib, a package may name a file by either.
owners=$(sed -n 'p; s|^/usr/lib/|/lib/|p' "$taken" | xargs dpkg -S 2>/dev/null || true)
while read -r file; do
    sed 's/.*: //; s|^/usr||' <<<"$owners" | grep -xF "${file#/usr}" >/dev/null || { echo "no package has $file: its licence is not known" && exit 1; }
done <"$taken"
mapfile -t packages < <({
    sed 's/[:,].*//' <<<"$owners"
    printf '%s\n' "${compiled_in[@]}"
} | sort -u)
for package in "${packages[@]}"; do
    cp -L "/usr/share/doc/$package/copyright" "$tree/licences/$package"
done
# Those that the licences above refer to.
for licence in $(grep -ohE '/usr/share/common-licenses/[A-Za-z0-9.-]*[A-Za-z0-9]' "$tree"/licences/* | sort -u); do
    [ ! -f "$licence" ] || cp -L "$licence" "$tree/licences/${licence##*/}.txt"
done
{
    cat "$source_dir/resources/package/archive/LICENCES.txt"
    dpkg-query -W -f '${Package} ${Version} (source: ${source:Package} ${source:Version})\n' "${packages[@]}" | sort
} >"$tree/LICENCES.txt"
cp "$source_dir/LICENSE" "$source_dir/CHANGELOG.md" "$source_dir/README.md" "$tree"
cp "$source_dir"/resources/package/archive/{bergwatch,install.sh} "$tree"
ln -s bergwatch "$tree/bergwatch-cli"

chmod -R u=rwX,go=rX "$tree"
chmod a+x "$tree"/{bergwatch,install.sh}
tar -C "$build/archive" --sort=name --owner=0 --group=0 --numeric-owner --mtime="@${SOURCE_DATE_EPOCH:-0}" \
    -cf - "$name" | xz -T2 -3 >"$build/$name.tar.xz"
rm -rf "$tree"
echo "$build/$name.tar.xz"
