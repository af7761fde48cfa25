#!/bin/sh
# What moc makes of all headers, one after the other: moc_all.sh MOC PROJECT HEADER...
set -eu
moc=$1
project=$2
shift 2
for header in "$@"; do
    folder=${header#"$project"/}
    "$moc" --no-notes -p "${folder%/*}" "$header"
done
