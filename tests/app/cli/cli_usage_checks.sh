#!/usr/bin/env bash
# What the command line says to who mistypes, and the help it gives: run as a stranger would.
# Use: cli_usage_checks.sh CLI SOURCE_DIR WORK_DIR
. "$2/tests/app/cli/cli_support.sh"

cp "$source_dir/resources/scenarios/disko-bay-4.berg" four.berg
echo '{"format": "bergwatch-problem", "version": 1, "distances": [[0, 1], [1, 0]], "sigmas": [1], "mu": 1}' >problem.json
check "a run to read" exits 0 "$cli" simulate four.berg --duration 60 -q -o run
check "-q: nothing on stderr" test ! -s stderr.txt
echo '{"format": "bergwatch-scenario", "version": 1,' >broken.berg
printf 'id,latitude,longitude\na,-62.4S,54W\nb,91,54W\n' >sightings.csv
printf 'id,y,x\na,62.4S,54W\n' >columns.csv
echo '{"format": "bergwatch-problem", "version": 1, "sigma": [0, 1], "position_m": [[0, 0], [1, 0]], "toa": 2}' >unknown.json
printf 'id,latitude,longitude,length\na,62S,54W,"1,200"\n' >lengths.csv
sed 's/"sigma0_m2": [0-9.]*/"sigma0_m2": -1/' four.berg >negative.berg
printf 'TYPE: TSP\nDIMENSION: 3\nCOLOUR: red\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: UPPER_ROW\nEDGE_WEIGHT_SECTION\n1 -2\n' >few.tsp
sed 's/"policy": "visitation"/"backend": "cbc", &/' four.berg >cbc.berg

# --- mistakes --------------------------------------------------------------------------------
# tests/data/golden/mistakes.txt is a transcript: each command in it is run again, and must say the
# same on either stream and end with the same code. What it says now is left in mistakes.txt.
golden=$source_dir/tests/data/golden/mistakes.txt
grep '^\$ ' "$golden" | while IFS= read -r line; do
    printf '%s\n' "$line"
    (bergwatch-cli() { timeout 5 "$cli" "$@"; }; eval "${line#??}") 2>&1 </dev/null
    printf '[%s]\n\n' $?
done >mistakes.txt
check "mistakes: what is said" diff "$golden" mistakes.txt
check "mistakes: twenty at least" test "$(grep -c '^\[[1-9]' mistakes.txt)" -ge 20

# --- names in front of rows ------------------------------------------------------------------
sed 's/"uav-2"/"uav-ø"/g' "$source_dir/resources/scenarios/svalbard-two-uavs.berg" >wide.berg
check "plan: an id that is not ASCII" exits 0 "$cli" plan wide.berg
check "plan: its order is in line" grep -q '^uav-ø      [^ ]' stdout.txt

# --- version ---------------------------------------------------------------------------------
version=$(sed -n 's/^project(Bergwatch VERSION \([0-9.]*\) .*/\1/p' "$source_dir/CMakeLists.txt")
check "version: of the program" test "$("$cli" --version)" = "$version"
check "version: in a run" grep -q "\"program\": \"Bergwatch $version\"" run/run.bergrun
check "version: log" exits 0 "$cli" export run/run.bergrun --format log-html --output log.html
check "version: in the log" grep -q "Bergwatch $version" log.html
check "version: report" exits 0 "$cli" sweep four.berg --tau 1 --report report.html
check "version: in the report" grep -q "Bergwatch $version" report.html

# --- interventions of a run ------------------------------------------------------------------
python3 - <<'PY'
import json
run = json.load(open("run/run.bergrun"))
for name, later in (("gone", {"seen": "berg-1"}), ("assigned", {"assigned": {"iceberg": "berg-1", "uav": "uav-1"}}), ("hint", {"taux": 2, "asset": {"position_m": [0, 0], "flag": "NO"}})):
    run["interventions"] = [{"time_s": 10, "removed": "berg-1"}, {"time_s": 20, **later}]
    json.dump(run, open(name + ".bergrun", "w"))
PY
check "validate: seen after it was removed" exits 3 "$cli" validate gone.bergrun
check "validate: names run and intervention" grep -q '^gone.bergrun: interventions\[1\].seen: no iceberg "berg-1"' stderr.txt
check "validate: assigned after it was removed" exits 3 "$cli" validate assigned.bergrun
check "validate: unknown member of an intervention" exits 0 "$cli" validate hint.bergrun
check "validate: hint names it" grep -q 'hint: interventions\[1\]: .*"taux"' stderr.txt
check "validate: hint names one inside" grep -q 'hint: interventions\[1\].asset: .*"flag"' stderr.txt

# --- standard input --------------------------------------------------------------------------
printf 'id,latitude,longitude\na,69.1N,52W\n' >one.csv
check "import: --into - is standard input" exits 0 "$cli" import one.csv --into - --output into.berg <four.berg
check "import: added to it" grep -q '"berg-1"' into.berg
check "help: tells of -" grep -q 'standard input or output' <("$cli" --help)

# --- numbers ---------------------------------------------------------------------------------
# Every option that takes one, in every command, refuses what is none.
for command in solve plan curve simulate sweep benchmark export import drift; do
    others=(four.berg)
    [[ $command = benchmark || $command = drift ]] && others=()
    [[ $command = export || $command = import ]] && others+=(--output none.kml)
    options=$("$cli" "$command" --help | grep -oE '^ +(-., *)?--[a-z-]+ (FLOAT|INT)' | grep -oE -- '--[a-z-]+')
    check "$command: takes numbers" test -n "$options"
    for option in $options; do
        taus=()
        [ "$command" = sweep ] && taus=(--tau 1)
        for value in nan inf -nan 1e999 0x10 1..5 ""; do
            check "$command $option=$value" exits 2 "$cli" "$command" "${others[@]}" "${taus[@]}" "$option=$value"
            check "$command $option=$value: names it" says "$option"
        done
    done
done
for words in "sweep four.berg --tau nan" "sweep four.berg --tau 0:nan:1" "import four.berg -o none.berg --area nan,1,2,3"; do
    check "$words" exits 2 "$cli" $words
done

check "too many taus" exits 2 "$cli" sweep four.berg --tau 0:100:1e-9
check "too many taus: says so" says "--tau: with 0:100:1e-9 there are more than 100000 values"
# Each range by itself is short enough; all of them would be 2.4 GB.
check "too many taus in sum" exits 2 "$cli" sweep four.berg --tau "$(yes 0:100:0.001 | head -3000 | paste -sd,)"

for value in abc 0 1001 2x; do
    check "BERGWATCH_READ_LIMITS=$value" exits 2 env BERGWATCH_READ_LIMITS=$value "$cli" validate four.berg
    check "BERGWATCH_READ_LIMITS=$value: names it" says "BERGWATCH_READ_LIMITS"
done

# --- help ------------------------------------------------------------------------------------
check "help" exits 0 "$cli" help
check "help: is --help" cmp -s stdout.txt <("$cli" --help)
for command in solve plan curve simulate sweep study benchmark export validate import forecast drift completion; do
    check "help: lists $command" grep -q "^  $command " <("$cli" help)
    check "help $command" exits 0 "$cli" help $command
    check "help $command: is $command --help" cmp -s stdout.txt <("$cli" $command --help)
    check "help $command: has an example" grep -q "^  bergwatch-cli $command" stdout.txt
    check "help $command: 80 columns" test "$(wc -L <stdout.txt)" -le 80
done
check "help: as wide as COLUMNS" test "$(COLUMNS=110 "$cli" import --help | wc -L)" -gt 80
check "help: no wider than COLUMNS" test "$(COLUMNS=70 "$cli" import --help | wc -L)" -le 70
check "-V" test "$("$cli" -V)" = "$("$cli" --version)"
check "completion" exits 0 "$cli" completion bash
check "completion: is a script" bash -n stdout.txt
cp stdout.txt completion.bash
completes() {
    bash -c '. ./completion.bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _bergwatch_cli; echo "${COMPREPLY[@]}"' - "$@" 2>/dev/null
}
# Some versions of CLI11 take such names for one, and refuse to start.
check "options: no two differ in their dashes alone" test -z "$(sed -n 's/.*words="\(.*\)" ;;/\1/p' completion.bash |
    while read -ra names; do printf '%s\n' "${names[@]#-}" | sed 's/^-//' | sort | uniq -d; done)"
check "options: they were looked at" grep -q 'words=".*--variance-growth' completion.bash
check "completion: of a command" test "$(completes bergwatch-cli sim)" = simulate
check "completion: of an option" test "$(completes bergwatch-cli plan --certi)" = --certificate
check "completion: of a file" test "$(completes bergwatch-cli plan four)" = four.berg

# --- languages -------------------------------------------------------------------------------
# As LC_ALL, LC_MESSAGES or LANG say; such a locale need not be installed.
speaks() { # language, then what is said of a file, a field, an option, a value, a warning and a row
    local locale=$1
    told() { # name, exit code, words, command...
        local name="$locale: $1" code=$2 words=$3
        shift 3
        check "$name" exits "$code" env LC_ALL="$locale" "$cli" "$@"
        check "$name: words" says "$words"
    }
    told "a missing file" 3 "missing.berg: $2" plan missing.berg
    told "a field" 3 "negative.berg: icebergs[0].sigma0_m2: $3" plan negative.berg
    told "an option" 2 "$4" simulate four.berg --duraton 60
    told "a value" 2 "--tau: $5" plan four.berg --tau 101
    told "a hint" 0 "$6" validate "$source_dir/resources/scenarios/flemish-pass-appearing.berg"
    told "a row" 3 "sightings.csv: $7" import sightings.csv --output sightings.berg
}
speaks nb_NO.UTF-8 "kan ikke åpnes: filen eller mappen finnes ikke" "må være fra 0 til 1000000000000, ikke -1" \
    "det finnes ikke noe valg «--duraton»; mente du «--duration»?" "må være fra 0 til 100, ikke 101" \
    "tips: icebergs[2].velocity_mps: driver ut av området" "linje 2: bredden må være fra -90 til 90, minuttene under 60"
speaks da_DK "kan ikke åbnes: ingen sådan fil eller mappe" "skal være fra 0 til 1000000000000, ikke -1" \
    "der findes intet tilvalg »--duraton«; mente du »--duration«?" "skal være fra 0 til 100, ikke 101" \
    "tip: icebergs[2].velocity_mps: driver ud af området" "linje 2: "
s=$'\xc2\xa0' # a space that breaks no line
speaks fr_FR.UTF-8@euro "ne peut pas être ouvert$s: fichier ou dossier inexistant" "doit être de 0 à 1000000000000, et non -1" \
    "il n'y a pas d'option «$s--duraton$s»$s; vouliez-vous dire «$s--duration$s»$s?" "doit être de 0 à 100, et non 101" \
    "conseil: icebergs[2].velocity_mps: dérive hors de la zone" "ligne 2: "
for locale in C POSIX de_DE.UTF-8 nbx; do
    check "$locale is English" exits 3 env LC_ALL=$locale LC_MESSAGES=nb_NO.UTF-8 LANG=nb_NO.UTF-8 "$cli" plan missing.berg
    check "$locale is English: words" says "missing.berg: cannot be opened: No such file or directory"
done
check "LC_MESSAGES before LANG" exits 3 env LC_ALL= LC_MESSAGES=da LANG=fr_FR.UTF-8 "$cli" plan missing.berg
check "LC_MESSAGES before LANG: Danish" says "kan ikke åbnes"
check "options that exclude each other, in French" exits 2 env LC_ALL=fr_FR.UTF-8 "$cli" export x.berg -o x.plan --return-home --no-return-home
check "options that exclude each other, in French: words" says "--return-home exclut --no-return-home"
check "LANG alone, by its old name" exits 3 env -u LC_ALL -u LC_MESSAGES LANG=no_NO "$cli" plan missing.berg
check "LANG alone, by its old name: Norwegian" says "kan ikke åpnes"
for words in "plan missing.berg" "plan negative.berg" "simulate four.berg --duration nan" "plan four.berg --frobnicate" \
             "simulate four.berg --output run" "validate negative.berg" "plan four.berg" "import sightings.csv -o s.berg"; do
    for locale in C.UTF-8 nb_NO.UTF-8; do
        LC_ALL=$locale "$cli" $words --json 2>/dev/null | grep -v '"seconds"' >"json.$locale"
    done
    check "--json speaks English: $words" cmp json.C.UTF-8 json.nb_NO.UTF-8
    check "--json has no second language: $words" test -z "$(grep -aF '\u001f' json.nb_NO.UTF-8)"
done
check "help is English" cmp -s <(LC_ALL=nb_NO.UTF-8 "$cli" help plan) <("$cli" help plan)

# --- pipes and JSON --------------------------------------------------------------------------
check "plan from a pipe" exits 0 "$cli" plan - --json <four.berg
grep -v '"seconds"' stdout.txt >piped.json
check "plan from a file" exits 0 "$cli" plan four.berg --json
check "plan from a pipe: the same" cmp -s piped.json <(grep -v '"seconds"' stdout.txt)
check "plan from a real pipe" exits 0 bash -c 'cat four.berg | "$0" plan - --json' "$cli"
check "plan from a real pipe: the same" cmp -s piped.json <(grep -v '"seconds"' stdout.txt)
check "plan from a pipe, named last" exits 0 "$cli" plan --json - <four.berg
check "plan from a pipe, named last: the same" cmp -s piped.json <(grep -v '"seconds"' stdout.txt)
check "from pipe to pipe" exits 0 "$cli" export -f csv -o - - <four.berg
check "a plan to a pipe" exits 0 "$cli" export four.berg -f csv -o -
check "a plan to a pipe: a table" grep -q , stdout.txt
check "format from the suffix" exits 0 "$cli" export four.berg -o plan.csv
check "format from the suffix: the same" cmp -s plan.csv <("$cli" export four.berg -f csv -o -)
check "--json of a failure" exits 3 "$cli" plan negative.berg --json
check "--json of a failure: findings" json 'd["error"]["kind"] == "invalid-input" and d["error"]["findings"][0]["file"] == "negative.berg" and d["error"]["findings"][0]["field"] == "icebergs[0].sigma0_m2"'
check "--json of a missing file" exits 3 "$cli" simulate missing.berg --json
check "--json of a missing file: its kind" json 'd["error"]["kind"] == "file-not-found"'
check "--json of a mistyped line" exits 2 "$cli" simulate four.berg --duration nan --json
check "--json of a mistyped line: says which" json 'd["error"]["kind"] == "wrong-usage" and "--duration" in d["error"]["findings"][0]["message"]'
check "--json of a file in the way" exits 2 "$cli" simulate four.berg --output run --json
check "--json of a file in the way: says which" json '"exists" in d["error"]["findings"][0]["message"]'
sed 's/"airspeed_mps": *[0-9.]*/"airspeed_mps": 30.5/' "$source_dir/resources/scenarios/svalbard-two-uavs.berg" >noted.berg
check "export -q" exits 0 "$cli" export noted.berg -f plan -o noted.plan -q
check "export -q: no notes" test ! -s stderr.txt
check "-v: time and memory" exits 0 "$cli" plan four.berg -v
check "-v: time and memory told" grep -qE '^took [0-9.]+ s of processor time and [0-9]+ MB of memory$' stderr.txt
check "-t: tau" exits 0 "$cli" plan four.berg -t 1
check "validate --json: the good ones too" exits 0 "$cli" validate four.berg --json
check "validate --json: valid" json 'd[-1] == {"file": "four.berg", "severity": "valid"}'

all_checked
