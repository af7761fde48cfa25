#!/bin/sh
# Checks the subjects of commits, one a line on standard input as `git log --format='%h %s'` prints
# them: at most 72 characters, and an imperative first word where its ending tells. Exit status 1, and
# a line for each subject that fails.
set -eu
export LC_ALL=C.UTF-8

# Imperatives that end like a past tense or a third person.
imperatives='Bias|Embed|Shed|Speed|Spread|Thread|Canvas|Alias'

awk -v imperatives="^($imperatives)\$" '
{
    subject = substr($0, index($0, " ") + 1)
    word = $2
    if (length(subject) > 72)
        print "too long (" length(subject) "): " $0
    else if (word ~ /(ed|s)$/ && word !~ /(ss|us|eed)$/ && word !~ imperatives)
        print "not imperative: " $0
    else
        next
    failed = 1
}
END { exit failed }'
