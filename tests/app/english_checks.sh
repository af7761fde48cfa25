#!/bin/sh
# The checks of English find what they must and leave alone what they must.
#   english_checks.sh SOURCE_DIR
set -eu
cd "$1/cmake"

failures=0
expect() { # what, expected exit status, status
    if [ "$2" -ne "$3" ]; then
        echo "FAILED: $1: exit status $3, expected $2"
        failures=$((failures + 1))
    fi
}
subject() { # expected status, subject
    status=0
    printf '1a2b3c4 %s\n' "$2" | ./check_subjects.sh >/dev/null || status=$?
    expect "subject '$2'" "$1" "$status"
}
comment() { # expected status, line of a source
    status=0
    printf '+++ b/core/x.h\n-// Of the line that goes\n+%s\n' "$2" | ./check_english.sh >/dev/null || status=$?
    expect "comment '$2'" "$1" "$status"
}

subject 0 'Process frames of two links'
subject 0 'Feed the filter with fixes'
subject 1 'Adds a check'
subject 1 'Fixed a leak'
subject 0 "Keep a subject of seventy-two characters, which is as long as it may be."
subject 1 "Keep a subject of seventy-three characters, which is one more than it may."

comment 0 'int way = told; // The pilot decides.'
comment 0 '/** Returns nullopt if the UAV is on its way home. */'
comment 0 'const std::string what = "Of the order"; ///< shown in the status line'
comment 1 '// Of the plan in force'
comment 1 '/** What is flown. */'
comment 1 '    int place = -1; ///< none: it does not fly'
comment 1 ' * The reader is told so'

status=0
printf '+++ b/x.h\n+// What\n+// As\n' | ./check_english.sh 2 >/dev/null || status=$?
expect "two comments, two allowed" 0 "$status"
[ "$failures" -eq 0 ] && echo "All right."
exit "$((failures > 0))"
