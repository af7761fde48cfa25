#!/bin/sh
# Puts Bergwatch, which stays in this folder, into the menus of your desktop, or takes it away again.
# Use: ./install.sh [--remove] [PREFIX]      (PREFIX: ~/.local)
set -eu
remove=no
if [ "${1:-}" = --remove ]; then
    remove=yes
    shift
fi
case ${1:-} in
    -*)
        sed -n '2,3s/^# //p' "$0"
        [ "$1" = --help ] || exit 2
        exit 0
        ;;
esac
here=$(dirname "$(readlink -f "$0")")
prefix=${1:-$HOME/.local}
mkdir -p "$prefix"
prefix=$(readlink -f "$prefix")
data=$prefix/share
desktop=$data/applications/org.bergwatch.bergwatch.desktop
mime=$data/mime/packages/bergwatch.xml

# Databases of the desktop, where it has the programs.
refresh() {
    ! command -v update-desktop-database >/dev/null || update-desktop-database -q "$data/applications" || true
    ! command -v update-mime-database >/dev/null || update-mime-database "$data/mime" 2>/dev/null || true
    ! command -v gtk-update-icon-cache >/dev/null ||
        gtk-update-icon-cache -q -f -t "$data/icons/hicolor" 2>/dev/null || true
}

cd "$here/share"
if [ "$remove" = yes ]; then
    find icons -type f | while read -r icon; do rm -f "$data/$icon"; done
    rm -f "$desktop" "$mime"
    for program in bergwatch bergwatch-cli; do
        [ "$(readlink "$prefix/bin/$program" || true)" != "$here/$program" ] || rm "$prefix/bin/$program"
    done
    refresh
    echo "Bergwatch is out of the menus. Its folder is still there: $here"
    exit 0
fi
find icons -type f | while read -r icon; do
    mkdir -p "$data/${icon%/*}"
    cp "$icon" "$data/$icon"
done
mkdir -p "$data/applications" "$data/mime/packages" "$prefix/bin"
cp mime/packages/bergwatch.xml "$mime"
# As menu entries quote a path: for their own rules, then for those of texts in such files, then for sed.
path=$(printf '%s' "$here/bergwatch" | sed -e 's/["`$\\]/\\&/g' -e 's/\\/\\\\/g' -e 's/%/%%/g' -e 's/[\\&|]/\\&/g')
sed "s|^Exec=bergwatch|Exec=\"$path\"|" applications/org.bergwatch.bergwatch.desktop >"$desktop"
for program in bergwatch bergwatch-cli; do
    if [ -e "$prefix/bin/$program" ] && [ ! -L "$prefix/bin/$program" ]; then
        echo "$prefix/bin/$program is another program and stays." >&2
    else
        ln -sf "$here/$program" "$prefix/bin/$program"
    fi
done
refresh
echo "Bergwatch is in the menus. If you move this folder, run install.sh again."
