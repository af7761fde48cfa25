#!/bin/sh
# Prints the releases of CHANGELOG.md (standard input) as the changelog of a Debian package.
# Use: debian_changelog.sh CONTACT <CHANGELOG.md
set -eu
contact=$1
case $contact in *'<'*) ;; *) contact="$contact <>" ;; esac # the form wants an address
trailer() { [ -z "$day" ] || printf '\n -- %s  %s\n\n' "$contact" "$(LC_ALL=C date -u -R -d "$day")"; }
day=
while IFS= read -r line; do
    case $line in
        '## ['[0-9]*)
            trailer
            version=${line#*\[}
            day=${line##* - }
            printf 'bergwatch (%s) unstable; urgency=medium\n\n' "${version%%\]*}"
            ;;
        '## '*) ;;
        '- '*) [ -z "$day" ] || printf '  * %s\n' "${line#- }" ;;
        '  '*) [ -z "$day" ] || printf '    %s\n' "${line#  }" ;;
    esac
done
trailer
