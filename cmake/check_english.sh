#!/bin/sh
# Counts comments in changed lines that break the house's English, in the output of
# `git diff -U0` on standard input: comments that lean on the line above ("Of the plan in force"),
# values told by a colon ("none: it does not"), and words that CONTRIBUTING.md replaces.
#   check_english.sh [LIMIT]
# Prints the lines found. Exit status 1 if there are more than LIMIT (default 0).
set -eu
export LC_ALL=C.UTF-8

# Phrases that are right although a pattern below finds them.
exceptions='What-if|As-flown|by the way|in no way|halfway|one way|way home|two-way|right of way|giving way|give way|gives way|way back|way out|under way|How many'

awk -v limit="${1:-0}" -v exceptions="$exceptions" '
/^\+\+\+ / { file = substr($0, 7); next }
/^\+/ {
    line = substr($0, 2)
    if (line !~ /\/\/|^ *\/?\*/) next
    comment = line
    if (!sub(/^.*\/\/+<? */, "", comment)) sub(/^ *\/?\*+ */, "", comment)
    gsub(exceptions, "", comment)
    if (comment ~ /^(Of|What|Who|Whose|Where|So many|As|The same|Likewise)( |$)/ ||
        comment ~ /(^|[ ;(])(none|empty|nothing|null): / ||
        comment ~ /(^|[^a-zA-Z])(tell|tells|told|way|ways|thing|things)([^a-zA-Z]|$)/) {
        print file ": " line
        ++found
    }
}
END { exit found > limit }'
