#!/usr/bin/env bash
# What the command line says in another language, as pairs {"English", "translation"} of a C++ table:
#   cmake/catalogue.sh translations/bergwatch_nb.ts > catalogue_nb.inc
# These are the contexts CommandLine, EventText, IssueText and Report without what is unfinished or
# counts. Without Qt.
set -euo pipefail
export LC_ALL=C
awk '
function text(line) { # of an element, as a C++ string
    if (!sub(/^[^>]*>/, "", line) || !sub(/<\/(source|translation)>$/, "", line)) {
        print FILENAME ":" FNR ": is not one line" > "/dev/stderr"
        failed = 1
    }
    gsub(/&lt;/, "<", line)
    gsub(/&gt;/, ">", line)
    gsub(/&quot;/, "\"", line)
    gsub(/&apos;/, "\047", line)
    gsub(/&amp;/, "\\&", line)
    gsub(/["\\]/, "\\\\&", line)
    return "\"" line "\""
}
/<name>/ { ours = /<name>(CommandLine|EventText|IssueText|Report)</ }
!ours { next }
/<message/ { single = !/numerus/ }
/<source>/ { source = $0 }
/<translation>/ && single { print "{" text(source) ", " text($0) "}," }
END { exit failed }' "$1"
