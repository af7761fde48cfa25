#!/usr/bin/env bash
# What the command line says to who mistypes, and the help it gives: run as a stranger would.
# Use: cli_usage_checks.sh CLI SOURCE_DIR WORK_DIR
. "$2/tests/app/cli_support.sh"

cp "$source_dir/resources/scenarios/disko-bay-4.berg" four.berg
echo '{"format": "bergwatch-problem", "version": 1, "distances": [[0, 1], [1, 0]], "sigmas": [1], "mu": 1}' >problem.json
check "a run to read" exits 0 "$cli" simulate four.berg --duration 60 -q -o run
check "-q: nothing on stderr" test ! -s stderr.txt
echo '{"format": "bergwatch-scenario", "version": 1,' >broken.berg
sed 's/"sigma0_m2": [0-9.]*/"sigma0_m2": -1/' four.berg >negative.berg

# mistake CODE WORDS ARGUMENT...: ends with the code, says the words, and never more than six lines.
mistake() {
    local code=$1 words=$2
    shift 2
    check "$*" exits "$code" timeout 5 "$cli" "$@"
    check "$*: says '$words'" says "$words"
    check "$*: in a few lines" test "$(wc -l <stderr.txt)" -le 6
    check "$*: nothing on stdout" test ! -s stdout.txt
}

# --- twenty mistakes -------------------------------------------------------------------------
mistake 2 "there is no command 'simulte'; did you mean 'simulate'?" simulte four.berg
mistake 2 "there is no command 'fly'" fly four.berg
mistake 2 "there is no command 'four.berg'" four.berg
mistake 2 "bergwatch-cli: A subcommand is required"
mistake 2 "there is no option '--duraton'; did you mean '--duration'?" simulate four.berg --duraton 60
mistake 2 "there is no option '--hlep'; did you mean '--help'?" plan --hlep
mistake 2 "there is no option '--frobnicate'" plan four.berg --frobnicate
mistake 2 "bergwatch-cli plan: SCENARIO is required" plan
mistake 2 "Try 'bergwatch-cli plan --help'" plan
mistake 2 "--tau: 1,5 is not a number" plan four.berg --tau 1,5
mistake 2 "--tau: must be" plan four.berg --tau -1
mistake 2 "--backend: gurobi is none of auto, exact" plan four.berg --backend gurobi
mistake 3 "missing.berg: cannot be opened" plan missing.berg
mistake 3 "broken.berg: line 2, column 1: syntax error" plan broken.berg
mistake 3 "negative.berg: icebergs[0].sigma0_m2" plan negative.berg
mistake 3 "This is a planning problem: use 'solve'." plan problem.json
mistake 3 "This is a scenario: use 'plan', 'simulate' or 'export'." solve four.berg
mistake 3 "This is a run: use 'simulate' or 'export'." plan run/run.bergrun
mistake 2 "--output: no format has the suffix of plan.docx" export four.berg --output plan.docx
mistake 2 "run/run.bergrun: exists" export four.berg --format csv --output run/run.bergrun
mistake 1 "there is no folder nowhere" curve four.berg --output nowhere/curve.csv
mistake 3 "is not a regular file" plan run

# --- help ------------------------------------------------------------------------------------
check "help" exits 0 "$cli" help
check "help: is --help" cmp -s stdout.txt <("$cli" --help)
for command in solve plan curve simulate sweep study benchmark export validate import completion; do
    check "help: lists $command" grep -q "^  $command " <("$cli" help)
    check "help $command" exits 0 "$cli" help $command
    check "help $command: is $command --help" cmp -s stdout.txt <("$cli" $command --help)
    check "help $command: has an example" grep -q "^  bergwatch-cli $command" stdout.txt
    check "help $command: 80 columns" test "$(wc -L <stdout.txt)" -le 80
done
check "-V" test "$("$cli" -V)" = "$("$cli" --version)"
check "completion" exits 0 "$cli" completion bash
check "completion: is a script" bash -n stdout.txt
cp stdout.txt completion.bash
completes() {
    bash -c '. ./completion.bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _bergwatch_cli; echo "${COMPREPLY[@]}"' - "$@" 2>/dev/null
}
check "completion: of a command" test "$(completes bergwatch-cli sim)" = simulate
check "completion: of an option" test "$(completes bergwatch-cli plan --certi)" = --certificate
check "completion: of a file" test "$(completes bergwatch-cli plan four)" = four.berg

# --- pipes and JSON --------------------------------------------------------------------------
check "plan from a pipe" exits 0 "$cli" plan - --json <four.berg
grep -v '"seconds"' stdout.txt >piped.json
check "plan from a file" exits 0 "$cli" plan four.berg --json
check "plan from a pipe: the same" cmp -s piped.json <(grep -v '"seconds"' stdout.txt)
check "plan from a real pipe" exits 0 bash -c 'cat four.berg | "$0" plan - --json' "$cli"
check "plan from a real pipe: the same" cmp -s piped.json <(grep -v '"seconds"' stdout.txt)
check "a plan to a pipe" exits 0 "$cli" export four.berg -f csv -o -
check "a plan to a pipe: a table" grep -q , stdout.txt
check "format from the suffix" exits 0 "$cli" export four.berg -o plan.csv
check "format from the suffix: the same" cmp -s plan.csv <("$cli" export four.berg -f csv -o -)
check "--json of a failure" exits 3 "$cli" plan negative.berg --json
check "--json of a failure: findings" json 'd["error"]["kind"] == "invalid-input" and d["error"]["findings"][0]["file"] == "negative.berg" and d["error"]["findings"][0]["field"] == "icebergs[0].sigma0_m2"'
check "--json of a missing file" exits 3 "$cli" simulate missing.berg --json
check "--json of a missing file: its kind" json 'd["error"]["kind"] == "file-not-found"'
check "validate --json: the good ones too" exits 0 "$cli" validate four.berg --json
check "validate --json: valid" json 'd[-1] == {"file": "four.berg", "severity": "valid"}'

all_checked
