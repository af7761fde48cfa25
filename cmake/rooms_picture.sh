#!/bin/sh
# Draws the rooms (folders with sources) of the tree and who includes whom, as SVG on standard output:
#   cmake/rooms_picture.sh > rooms.svg
# A room stands above all that it uses; what follows from other lines is left out. The test
# `rooms_picture` fails when the picture in the tree is old.
set -eu
export LC_ALL=C
cd "$(dirname "$0")/.."

find app core widgets -name '*.h' -o -name '*.cpp' | sort | xargs awk '
function room(path) { sub("/[^/]*$", "", path); return path }
function reaches(a, b, avoid,    k, through) { # from a to b by two or more steps
    for (k in uses) {
        split(k, through, SUBSEP)
        if (through[1] == a && through[2] != b && below[through[2], b]) return 1
    }
    return 0
}
FNR == 1 { here = room(FILENAME); if (!(here in lines)) order[++count] = here }
{ ++lines[here] }
/^#include "(app|core|widgets)\// {
    split($0, part, "\"")
    there = room(part[2])
    if (there != here) uses[here, there] = 1
}
END {
    for (k in uses) below[k] = 1
    for (m = 1; m <= count; ++m) # Warshall
        for (i = 1; i <= count; ++i)
            if (below[order[i], order[m]])
                for (j = 1; j <= count; ++j)
                    if (below[order[m], order[j]]) below[order[i], order[j]] = 1
    for (i = 1; i <= count; ++i) level[order[i]] = 0
    for (pass = 1; pass <= count; ++pass)
        for (k in uses) {
            split(k, end, SUBSEP)
            if (level[end[1]] <= level[end[2]] && !below[end[2], end[1]])
                level[end[1]] = level[end[2]] + 1
        }
    for (i = 1; i <= count; ++i) {
        name = order[i]
        column[name] = across[level[name]]++
        if (level[name] > top) top = level[name]
    }
    wide = 168; high = 30; gap_x = 14; gap_y = 44
    for (l = 0; l <= top; ++l) if (across[l] > most) most = across[l]
    width = most * (wide + gap_x) + gap_x
    height = (top + 1) * (high + gap_y) - gap_y + 2 * gap_x
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" font-family=\"sans-serif\" font-size=\"12\">\n", width, height
    printf "<title>Rooms of Bergwatch: each uses only what stands below it</title>\n"
    printf "<rect width=\"%d\" height=\"%d\" fill=\"#ffffff\"/>\n", width, height
    for (i = 1; i <= count; ++i) {
        name = order[i]
        n = across[level[name]]
        x[name] = (width - n * (wide + gap_x) + gap_x) / 2 + column[name] * (wide + gap_x)
        y[name] = gap_x + (top - level[name]) * (high + gap_y)
    }
    for (i = 1; i <= count; ++i)
        for (j = 1; j <= count; ++j) {
            a = order[i]; b = order[j]
            if (!((a, b) in uses) || reaches(a, b)) continue
            printf "<line x1=\"%d\" y1=\"%d\" x2=\"%d\" y2=\"%d\" stroke=\"#8a97a6\"/>\n", \
                x[a] + wide / 2, y[a] + high, x[b] + wide / 2, y[b]
        }
    for (i = 1; i <= count; ++i) {
        name = order[i]
        fill = name ~ /^core/ ? "#e3eef9" : name ~ /^widgets/ ? "#e8f4e4" : "#fbeedd"
        printf "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"4\" fill=\"%s\" stroke=\"#4a5866\"/>\n", x[name], y[name], wide, high, fill
        printf "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">%s</text>\n", x[name] + wide / 2, y[name] + 19, name
    }
    print "</svg>"
}'
