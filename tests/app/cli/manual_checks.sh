#!/usr/bin/env bash
# Every command of the manual, in its order, as a reader would type it:
#   manual_checks.sh CLI SOURCE_DIR WORK_DIR WINDOW_PROGRAM|none WITH_CBC
# Blocks of ```sh are run in one folder, with the programs on the PATH and the examples of the sources in
# place of the installed ones. A block has to end with 0, or with N where it begins with ```sh exit=N. Without
# the window's program its blocks, and those that paint, are left out; without CBC those that verify. The Norwegian has the same blocks (tst_manual).
source "$(dirname "$0")/cli_support.sh"
window=${4#none}
with_cbc=$5
bin=$work/bin
mkdir "$bin" flown
ln -s "$cli" "$bin/bergwatch-cli"
[ -z "$window" ] || ln -s "$window" "$bin/bergwatch"
cp -r "$source_dir/resources/scenarios" "$work/scenarios"
export PATH=$bin:$PATH QT_QPA_PLATFORM=offscreen
cd flown || exit 1

# blocks FILE: writes each block to block-K.sh and prints a line "K EXIT" for each.
blocks() {
    awk '
        /^```sh/ { ++k; wanted = match($0, /exit=[0-9]+/) ? substr($0, RSTART + 5, RLENGTH - 5) : 0
                   file = "../block-" k ".sh"; printf "" > file; print k, wanted; inside = 1; next }
        /^```/ { if (inside) close(file); inside = 0; next }
        inside { gsub("/usr/share/bergwatch/scenarios", "../scenarios"); print > file }' "$1"
}

# In the order of the manual.
chapters=$(tr '\n' ' ' <"$source_dir/widgets/manual/manual.h" |
    sed 's/.*kManualChapters{\([^}]*\)}.*/\1/' | grep -o '[a-z]*')
for chapter in $chapters; do
    blocks "$source_dir/resources/manual/en/$chapter.md" >../list.txt
    while read -r k wanted; do
        if [ -z "$window" ] && grep -Eq '^bergwatch |format brief' "../block-$k.sh"; then
            continue
        fi
        if [ "$with_cbc" != ON ] && grep -q -e --verify "../block-$k.sh"; then
            continue
        fi
        check "$chapter, block $k" exits "$wanted" bash -e "../block-$k.sh" </dev/null
    done <../list.txt
done
# What the text names is there: options, policies, formats.
commands=$(bergwatch-cli --help | awk '/^Subcommands:/ { inside = 1; next } /^[^ ]/ { inside = 0 }
    inside && /^  [a-z]/ { print $1 }')
{
    for command in $commands; do
        bergwatch-cli help "$command"
    done
    bergwatch-cli --help
    [ -z "$window" ] || bergwatch --help
} >../help.txt 2>/dev/null
[ -n "$window" ] || echo "--pictures --screenshot --at --wait --config --manual" >>../help.txt
for language in en nb; do
    check "$language: every option exists" test -z "$(cat "$source_dir/resources/manual/$language"/*.md |
        grep -oE -e '--[a-z][a-z-]+' | sort -u | grep -vE '^--version$' |
        while read -r option; do grep -q -e "$option\b" ../help.txt || echo "  no $option" | tee /dev/stderr; done)"
    check "$language: policies and formats are those of the program" python3 - "$source_dir/resources/manual/$language" <<'END'
import re, subprocess, sys
def offered(command, option, *needed): # by the error about another value: a library lays out the help
    text = subprocess.run(["bergwatch-cli", command, "file", option, "nothing", *needed],
                          capture_output=True, text=True).stderr
    return set(re.search(r"is none of (.*)", text).group(1).split(", "))
def named(chapter, section):
    text = open(f"{sys.argv[1]}/{chapter}.md", encoding="utf8").read()
    text = text[text.index("{#" + section + "}"):].split("\n## ")[0]
    cells = [row.split("|")[1] for row in text.split("\n") if row.startswith("|")][2:]
    return {word.strip("` ") for cell in cells for word in cell.split(",")}
pairs = [(named("policies", "policies"), offered("plan", "--policy")),
         (named("files", "exports"), offered("export", "--format", "--output", "file")),
         (named("files", "imports"), offered("import", "--format", "--output", "file") - {"auto"})]
for have, want in pairs:
    if have != want:
        print("  manual and program differ:", sorted(have ^ want), file=sys.stderr)
sys.exit(any(have != want for have, want in pairs))
END
done
check "there are commands" test "$checks" -ge 15
check "the import has three icebergs" \
    python3 -c 'import json; assert len(json.load(open("survey.berg"))["icebergs"]) == 3'
if [ -n "$window" ]; then
    check "the brief is a PDF" grep -q '^%PDF' brief.pdf
    check "the picture is there" test -s pictures/map.png
fi

all_checked
