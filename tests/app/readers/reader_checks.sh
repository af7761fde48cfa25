# Checks that the scripts of other people's readers share; sourced. Wants `ogrinfo` to be set.
checks=0
failures=0

# same NAME EXPECTED ACTUAL: counts, and names what differs.
same() {
    checks=$((checks + 1))
    [ "$2" = "$3" ] && return
    failures=$((failures + 1))
    printf 'FAILED: %s\n  expected: %s\n  actual:   %s\n' "$1" "$2" "$3"
}

# near NAME EXPECTED ACTUAL TOLERANCE: numbers.
near() {
    checks=$((checks + 1))
    awk -v a="$2" -v b="$3" -v t="$4" \
        'BEGIN { d = a - b; exit !(a != "" && b != "" && d <= t && d >= -t) }' && return
    failures=$((failures + 1))
    printf 'FAILED: %s\n  expected: %s\n  actual:   %s\n' "$1" "$2" "$3"
}

# run COMMAND...: one that must succeed.
run() {
    "$@" >stdout.txt 2>stderr.txt && return
    checks=$((checks + 1))
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
    sed 's/^/  /' stderr.txt | head -5
}

# ask FILE SQL: the values of the only column of a query, one a line. The layer has the file's name.
ask() {
    "$ogrinfo" -q -dialect SQLite -sql "$2" "$1" | sed -n 's/^  [^=]* ([^)]*) = //p'
}

# number FILE EXPRESSION: of the scenario file, as `d`.
number() {
    python3 -c 'import json, sys; d = json.load(open(sys.argv[1])); print(eval(sys.argv[2]))' "$1" "$2"
}

# rows FILE: of a table with one header line and no line ends in its fields.
rows() { echo $(($(wc -l <"$1") - 1)); }

# field FILE ROW COLUMN: row 1 is the first below the header.
field() { sed -n "$(($2 + 1))p" "$1" | cut -d, -f"$3"; }

# all_checked: the last line of a script; fails when a check did.
all_checked() {
    echo "$checks checks, $failures failures"
    [ "$failures" -eq 0 ]
}
