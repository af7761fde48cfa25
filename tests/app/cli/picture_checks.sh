#!/usr/bin/env bash
# Pictures and screenshots go through the gate for all that is written, before any work.
# Use: picture_checks.sh BERGWATCH SOURCE_DIR WORK_DIR
. "$2/tests/app/cli/cli_support.sh"
bergwatch=$1
export QT_QPA_PLATFORM=offscreen
scenario=small.berg
python3 - "$source_dir/resources/scenarios/grand-banks-12.berg" <<'P'
import json, sys
scenario = json.load(open(sys.argv[1]))
scenario["icebergs"] = scenario["icebergs"][:4]
scenario["duration_s"] = 120
json.dump(scenario, open("small.berg", "w"))
P
pictures() { "$bergwatch" --pictures "$@"; }

for option in --help --help-all; do
    check "$option opens no window" exits 0 timeout 60 "$bergwatch" $option
    check "$option: names --pictures" grep -q -e --pictures stdout.txt
    check "$option: names the dark pictures" grep -q -e zeta-dark.png stdout.txt
done

check "pictures" exits 0 pictures out $scenario
check "pictures: three files" test "$(ls out | tr '\n' ' ')" = "map.png sigma.png zeta.png "
echo mine >out/zeta.png
rm out/map.png
check "pictures that exist" exits 2 pictures out $scenario
check "pictures that exist: says so" says "--pictures: out/zeta.png exists; use --force to overwrite it"
check "pictures that exist: as before" test "$(cat out/zeta.png)" = mine
check "pictures that exist: no other one" test ! -e out/map.png
check "other pictures beside them" exits 0 pictures out --theme dark --force $scenario
check "--force overwrites" test "$(head -c 4 out/zeta.png | tail -c 3)" = PNG
echo mine >out/zeta-dark.png
check "one of both themes exists" exits 2 pictures out --theme both $scenario
check "one of both themes exists: says so" says "out/map.png exists"
check "no folder for pictures" exits 1 pictures $scenario/out $scenario
check "no folder for pictures: says so" says "$scenario is no folder"
check "a file in place of the folder" exits 1 pictures $scenario $scenario
check "a file in place of the folder: says so" says "  is no folder"
cp $scenario map.png
check "the input is to be overwritten" exits 2 pictures . --force map.png
check "the input is to be overwritten: says so" says "./map.png is an input of this command"
check "the input is as before" cmp -s $scenario map.png
ln -s ../$scenario out/link
mkdir linked && ln -s ../$scenario linked/sigma.png
check "the input behind a link" exits 2 pictures linked --force $scenario
check "the input behind a link: nothing else" test "$(ls linked)" = sigma.png
if [ "$(id -u)" -ne 0 ]; then
    mkdir locked && chmod a-w locked
    check "a folder that takes nothing" exits 1 pictures locked $scenario
    chmod u+w locked
fi
check "a disk that is full" exits 1 env sh -c 'ulimit -f 1; trap "" XFSZ; exec "$@"' sh "$bergwatch" --pictures full $scenario
check "a disk that is full: no file" test -z "$(ls -A full 2>/dev/null)"

check "a screenshot" exits 0 "$bergwatch" --screenshot shot.png $scenario
check "a screenshot: a picture" test "$(head -c 4 shot.png | tail -c 3)" = PNG
check "a screenshot that exists" exits 2 "$bergwatch" --screenshot shot.png $scenario
check "a screenshot that exists: says so" says "--screenshot: shot.png exists; use --force to overwrite it"
check "a screenshot again" exits 0 "$bergwatch" --screenshot shot.png --force $scenario
check "a screenshot that waits" exits 0 "$bergwatch" --screenshot shot.png --force --wait 1 $scenario
check "a screenshot that waits for what" exits 2 "$bergwatch" --screenshot shot.png --force --wait long $scenario
check "a screenshot that waits for what: says so" says '--wait: "long" is not a number of seconds'
cp $scenario own.berg
check "a screenshot over its scenario" exits 2 "$bergwatch" --screenshot own.berg --force own.berg
check "a screenshot over its scenario: as before" cmp -s $scenario own.berg
for beside in $scenario "--pictures out" "--screenshot shot.png"; do
    check "the manual beside $beside" exits 2 "$bergwatch" --manual manual $beside
    check "the manual beside $beside: says so" says "--manual takes no scenario file, --pictures or --screenshot"
done
check "a screenshot into no folder" exits 1 "$bergwatch" --screenshot none/shot.png $scenario

all_checked
