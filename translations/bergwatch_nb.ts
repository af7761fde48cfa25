<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nb_NO">
<context>
    <name>AreaTool</name>
    <message>
        <source>Add area</source>
        <translation>Legg til område</translation>
    </message>
    <message>
        <source>Replace area</source>
        <translation>Erstatt område</translation>
    </message>
    <message>
        <source>An area needs at least three corners. Esc cancels the drawing.</source>
        <translation>Et område trenger minst tre hjørner. Esc avbryter tegningen.</translation>
    </message>
    <message>
        <source>Click the first corner or press Enter to close the area. Backspace removes a corner, Esc cancels.</source>
        <translation>Klikk på det første hjørnet eller trykk Enter for å lukke området. Slett bakover fjerner et hjørne, Esc avbryter.</translation>
    </message>
    <message>
        <source>Click to set the next corner. Backspace removes a corner, Esc cancels.</source>
        <translation>Klikk for å sette neste hjørne. Slett bakover fjerner et hjørne, Esc avbryter.</translation>
    </message>
    <message>
        <source>Drag a corner or the middle of an edge; clicking starts a new area. Esc leaves the tool.</source>
        <translation>Dra et hjørne eller midten av en kant; et klikk begynner et nytt område. Esc forlater verktøyet.</translation>
    </message>
    <message>
        <source>Click to set the first corner of the area. Esc leaves the tool.</source>
        <translation>Klikk for å sette det første hjørnet i området. Esc forlater verktøyet.</translation>
    </message>
    <message>
        <source>Add no-fly area</source>
        <translation>Legg til flyforbudsområde</translation>
    </message>
    <message>
        <source>Click to set the first corner of a no-fly area, or drag a corner or the middle of an edge of an existing one. Esc leaves the tool.</source>
        <translation>Klikk for å sette det første hjørnet i et flyforbudsområde, eller dra et hjørne eller midten av en kant i et som finnes. Esc forlater verktøyet.</translation>
    </message>
</context>
<context>
    <name>AssetText</name>
    <message>
        <source>%1 is inside the inner ring</source>
        <translation>%1 er innenfor den indre ringen</translation>
    </message>
    <message>
        <source>%1 enters the inner ring in %2</source>
        <translation>%1 kommer inn i den indre ringen om %2</translation>
    </message>
</context>
<context>
    <name>BatteryText</name>
    <message>
        <source>about %1 left</source>
        <translation>omtrent %1 igjen</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>%1 igjen</translation>
    </message>
    <message>
        <source>way home %1</source>
        <translation>veien hjem %1</translation>
    </message>
    <message>
        <source>planned endurance left %1</source>
        <translation>planlagt utholdenhet igjen %1</translation>
    </message>
    <message>
        <source>Battery for %1, way home %2</source>
        <translation>Batteri til %1, veien hjem %2</translation>
    </message>
</context>
<context>
    <name>ChartPageText</name>
    <message>
        <source>Flown until %1</source>
        <translation>Fløyet til %1</translation>
    </message>
    <message>
        <source>Nothing was flown</source>
        <translation>Ingenting ble fløyet</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>--backends: %1 is none of %2</source>
        <translation>--backends: %1 er ingen av %2</translation>
    </message>
    <message>
        <source>solving</source>
        <translation>løser</translation>
    </message>
    <message>
        <source>interrupted: the table is incomplete</source>
        <translation>avbrutt: tabellen er ufullstendig</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>advarsel</translation>
    </message>
    <message>
        <source>hint</source>
        <translation>tips</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>%1 igjen</translation>
    </message>
    <message>
        <source>%1: %2 is not a number</source>
        <translation>%1: %2 er ikke et tall</translation>
    </message>
    <message>
        <source>interrupted, nothing written</source>
        <translation>avbrutt, ingenting ble skrevet</translation>
    </message>
    <message>
        <source>proving the curve</source>
        <translation>beviser kurven</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>merk: %1</translation>
    </message>
    <message>
        <source>--format: %1 is none of %2</source>
        <translation>--format: %1 er ingen av %2</translation>
    </message>
    <message>
        <source>--output: no format has the suffix of %1; choose one with --format: %2</source>
        <translation>--output: ingen formater har filendelsen til %1; velg ett med --format: %2</translation>
    </message>
    <message>
        <source>--format %1: the program bergwatch paints this format, but it is neither in this folder nor on the PATH</source>
        <translation>--format %1: programmet bergwatch tegner dette formatet, men det finnes verken i denne mappen eller på PATH</translation>
    </message>
    <message>
        <source>%1: %2 is not a UTC time such as 2026-05-01T12:00:00Z</source>
        <translation>%1: %2 er ikke et UTC-tidspunkt som 2026-05-01T12:00:00Z</translation>
    </message>
    <message>
        <source>--area: %1 is not SOUTH,WEST,NORTH,EAST in degrees</source>
        <translation>--area: %1 er ikke SOUTH,WEST,NORTH,EAST (sør, vest, nord, øst) i grader</translation>
    </message>
    <message>
        <source>--map: %1 is not FIELD=COLUMN with a field of %2</source>
        <translation>--map: %1 er ikke FIELD=COLUMN med et felt av %2</translation>
    </message>
    <message>
        <source>--position-error: %1 is neither a number of metres nor one of %2</source>
        <translation>--position-error: %1 er verken et antall meter eller en av %2</translation>
    </message>
    <message>
        <source>--with-tracks needs --at: tracks consist of the sightings after that time</source>
        <translation>--with-tracks trenger --at: sporene består av observasjonene etter det tidspunktet</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>og %1 til</translation>
    </message>
    <message>
        <source>and %1 more notes about icebergs</source>
        <translation>og %1 merknader til om isfjell</translation>
    </message>
    <message>
        <source>the MPI processes have different options</source>
        <translation>MPI-prosessene har ulike valg</translation>
    </message>
    <message>
        <source>%1 is none of %2</source>
        <translation>%1 er ingen av %2</translation>
    </message>
    <message>
        <source>%1 is not a whole number from %2 to %3</source>
        <translation>%1 er ikke et heltall fra %2 til %3</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 er ikke et tall</translation>
    </message>
    <message>
        <source>%1 is an input of this command; name another file</source>
        <translation>%1 er inndata for denne kommandoen: oppgi en annen fil</translation>
    </message>
    <message>
        <source>%1 is an input of this command (%2); name another file</source>
        <translation>%1 er inndata for denne kommandoen (%2): oppgi en annen fil</translation>
    </message>
    <message>
        <source>%1 is already the file of %2; name another file</source>
        <translation>%1 er allerede filen til %2: oppgi en annen fil</translation>
    </message>
    <message>
        <source>%1 and --json both need standard output</source>
        <translation>%1 og --json trenger begge standard ut</translation>
    </message>
    <message>
        <source>%1 exists; use --force to overwrite it</source>
        <translation>%1 finnes; bruk --force for å overskrive den</translation>
    </message>
    <message>
        <source>%1: %2 and %3 contradict each other. One of the two is wrong; do not use this order.</source>
        <translation>%1: %2 og %3 motsier hverandre. Én av de to er feil; ikke bruk denne rekkefølgen.</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>det er ikke nok minne</translation>
    </message>
    <message>
        <source>This is a planning problem: use &apos;solve&apos;.</source>
        <translation>Dette er et planleggingsproblem: bruk «solve».</translation>
    </message>
    <message>
        <source>This is a scenario: use &apos;plan&apos;, &apos;simulate&apos; or &apos;export&apos;.</source>
        <translation>Dette er et scenario: bruk «plan», «simulate» eller «export».</translation>
    </message>
    <message>
        <source>This is a run: use &apos;simulate&apos; or &apos;export&apos;.</source>
        <translation>Dette er en flyging: bruk «simulate» eller «export».</translation>
    </message>
    <message>
        <source>This is a study: use &apos;study&apos;.</source>
        <translation>Dette er en studie: bruk «study».</translation>
    </message>
    <message>
        <source>Name the columns of a table: --map latitude=COLUMN --map longitude=COLUMN.</source>
        <translation>Oppgi kolonnene i en tabell: --map latitude=COLUMN --map longitude=COLUMN.</translation>
    </message>
    <message>
        <source>This is not a Bergwatch file. To read sightings, use &apos;import&apos;.</source>
        <translation>Dette er ikke en Bergwatch-fil. Bruk «import» for å lese observasjoner.</translation>
    </message>
    <message>
        <source>there is no completion script for %1</source>
        <translation>det finnes ikke noe fullføringsskript for %1</translation>
    </message>
    <message>
        <source>Try &apos;%1 --help&apos;.</source>
        <translation>Prøv «%1 --help».</translation>
    </message>
    <message>
        <source>took %1 s of processor time and %2 MB of memory</source>
        <translation>brukte %1 s prosessortid og %2 MB minne</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 er tom</translation>
    </message>
    <message>
        <source>flying</source>
        <translation>flyr</translation>
    </message>
    <message>
        <source>a run file is replayed exactly as flown; --tau, --policy, --duration, --dt, --seed and --no-noise apply to scenarios only</source>
        <translation>en flygefil spilles av nøyaktig slik den ble fløyet; --tau, --policy, --duration, --dt, --seed og --no-noise gjelder bare scenarioer</translation>
    </message>
    <message>
        <source>replaying</source>
        <translation>spiller av</translation>
    </message>
    <message>
        <source>--bound does not apply to runs with reported sightings</source>
        <translation>--bound gjelder ikke flyginger med meldte observasjoner</translation>
    </message>
    <message>
        <source>--bound does not apply to runs in which the wind changed</source>
        <translation>--bound gjelder ikke flyginger der vinden endret seg</translation>
    </message>
    <message>
        <source>bounding</source>
        <translation>finner nedre grense</translation>
    </message>
    <message>
        <source>interrupted: the flight is complete, but its lower bound is missing</source>
        <translation>avbrutt: flygingen er fullført, men den nedre grensen mangler</translation>
    </message>
    <message>
        <source>incomplete: %1 of %2 missions are flown; the results use only cases with all settings</source>
        <translation>ufullstendig: %1 av %2 oppdrag er fløyet; resultatene bruker bare tilfeller med alle innstillinger</translation>
    </message>
    <message>
        <source>--reference: %1 is not POLICY[:TAU] with one of %2</source>
        <translation>--reference: %1 er ikke POLICY[:TAU] med en av %2</translation>
    </message>
    <message>
        <source>--reference: this study does not contain %1</source>
        <translation>--reference: denne studien inneholder ikke %1</translation>
    </message>
    <message>
        <source>--tau: %1 is not A:B:STEP with 0 &lt;= A &lt;= B &lt;= 100</source>
        <translation>--tau: %1 er ikke A:B:STEP med 0 &lt;= A &lt;= B &lt;= 100</translation>
    </message>
    <message>
        <source>--tau: with %1 there are more than %2 values</source>
        <translation>--tau: med %1 blir det flere enn %2 verdier</translation>
    </message>
    <message>
        <source>--policies: %1 is none of %2</source>
        <translation>--policies: %1 er ingen av %2</translation>
    </message>
    <message>
        <source>--regime needs --random N; scenario files define their own drift</source>
        <translation>--regime trenger --random N; scenariofiler bestemmer driften selv</translation>
    </message>
    <message>
        <source>name scenarios, or use --random N</source>
        <translation>oppgi scenarioer eller --random N</translation>
    </message>
    <message>
        <source>--shard: %1 is not I/N with 1 &lt;= I &lt;= N</source>
        <translation>--shard: %1 er ikke I/N med 1 &lt;= I &lt;= N</translation>
    </message>
    <message>
        <source>--shard needs --study FILE, in which the part is stored</source>
        <translation>--shard trenger --study FILE, der delen lagres</translation>
    </message>
    <message>
        <source>--shard: to write tables and reports of all shards, use &apos;study&apos;</source>
        <translation>--shard: bruk «study» for å skrive tabeller og rapporter for alle delene</translation>
    </message>
    <message>
        <source>--replace-study needs --study FILE</source>
        <translation>--replace-study trenger --study FILE</translation>
    </message>
    <message>
        <source>flying %1 missions</source>
        <translation>flyr %1 oppdrag</translation>
    </message>
    <message>
        <source>interrupted: %1 of %2 missions are stored in %3; repeat the command to continue</source>
        <translation>avbrutt: %1 av %2 oppdrag er lagret i %3; gjenta kommandoen for å fortsette</translation>
    </message>
    <message>
        <source>there is no option &apos;%1&apos;</source>
        <translation>det finnes ikke noe valg «%1»</translation>
    </message>
    <message>
        <source>there is no option &apos;%1&apos;; did you mean &apos;%2&apos;?</source>
        <translation>det finnes ikke noe valg «%1»; mente du «%2»?</translation>
    </message>
    <message>
        <source>there is no command &apos;%1&apos;</source>
        <translation>det finnes ingen kommando «%1»</translation>
    </message>
    <message>
        <source>there is no command &apos;%1&apos;; did you mean &apos;%2&apos;?</source>
        <translation>det finnes ingen kommando «%1»; mente du «%2»?</translation>
    </message>
    <message>
        <source>a command is required</source>
        <translation>en kommando mangler</translation>
    </message>
    <message>
        <source>%1 needs a value</source>
        <translation>%1 trenger en verdi</translation>
    </message>
    <message>
        <source>%1 is given more than once</source>
        <translation>%1 er oppgitt mer enn én gang</translation>
    </message>
    <message>
        <source>not expected: %1</source>
        <translation>uventet: %1</translation>
    </message>
    <message>
        <source>%1 is required</source>
        <translation>%1 mangler</translation>
    </message>
    <message>
        <source>%1 is airspace; use --format airspace with --into SCENARIO</source>
        <translation>%1 er luftrom: bruk --format airspace med --into SCENARIO</translation>
    </message>
    <message>
        <source>%1 excludes %2</source>
        <translation>%1 utelukker %2</translation>
    </message>
    <message>
        <source>--bound does not apply to runs from which an iceberg was removed</source>
        <translation>--bound gjelder ikke flyginger der et isfjell ble fjernet</translation>
    </message>
    <message>
        <source>--output: this format writes one file per UAV; choose a UAV with --uav</source>
        <translation>--output: dette formatet skriver én fil for hver UAV; velg én med --uav</translation>
    </message>
    <message>
        <source>%1: &apos;-&apos; is not possible here; give a file name</source>
        <translation>%1: «-» er ikke mulig her: oppgi et navn</translation>
    </message>
    <message>
        <source>--map: %1 is mapped twice</source>
        <translation>--map: %1 er tilordnet to ganger</translation>
    </message>
    <message>
        <source>feature %1</source>
        <translation>objekt %1</translation>
    </message>
    <message>
        <source>packet %1</source>
        <translation>pakke %1</translation>
    </message>
    <message>
        <source>--dt, --duration: the time step is longer than the duration</source>
        <translation>--dt, --duration: tidssteget er lengre enn varigheten</translation>
    </message>
    <message>
        <source>--first-seed needs --random N; scenario files have their own seeds</source>
        <translation>--first-seed trenger --random N; scenariofiler har egne startfrø</translation>
    </message>
    <message>
        <source>%1 sightings are too far from the origin of the scenario, %2; import them without --into, or choose others with --area</source>
        <translation>%1 observasjoner er for langt fra origo i scenarioet, %2: importer dem uten --into, eller velg andre med --area</translation>
    </message>
    <message>
        <source>%1 sightings are too far from the origin, %2, which lies in their densest group; choose others with --area</source>
        <translation>%1 observasjoner er for langt fra origo, %2, som ligger i den tetteste gruppen av dem: velg andre med --area</translation>
    </message>
    <message>
        <source>%1: %2 is not a position such as 64.51N,59.80W</source>
        <translation>%1: %2 er ikke en posisjon som 64.51N,59.80W</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>vind</translation>
    </message>
    <message>
        <source>gust</source>
        <translation>vindkast</translation>
    </message>
    <message>
        <source>air temperature</source>
        <translation>lufttemperatur</translation>
    </message>
    <message>
        <source>fog</source>
        <translation>tåke</translation>
    </message>
    <message>
        <source>current</source>
        <translation>strøm</translation>
    </message>
    <message>
        <source>issued %1 h before %2; get a newer forecast</source>
        <translation>utgitt %1 t før %2; hent et nyere varsel</translation>
    </message>
    <message>
        <source>is for a place %1 km away</source>
        <translation>gjelder et sted %1 km unna</translation>
    </message>
    <message>
        <source>%1: no values between %2 and %3</source>
        <translation>%1: ingen verdier mellom %2 og %3</translation>
    </message>
    <message>
        <source>--since, --until: the forecast is from %1 to %2</source>
        <translation>--since, --until: varselet går fra %1 til %2</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 trenger %2</translation>
    </message>
    <message>
        <source>the forecasts hold no wind: add one that does, or give %1</source>
        <translation>varslene inneholder ikke vind: legg til et varsel som gjør det, eller oppgi %1</translation>
    </message>
    <message>
        <source>the forecasts hold no current: add one that does, or give %1</source>
        <translation>varslene inneholder ikke strøm: legg til et varsel som gjør det, eller oppgi %1</translation>
    </message>
    <message>
        <source>--at: wind and current are not both known then; the forecast is from %1 to %2</source>
        <translation>--at: vinden eller strømmen er ikke kjent på dette tidspunktet; varselet går fra %1 til %2</translation>
    </message>
    <message>
        <source>wind and current are known for %1 h only</source>
        <translation>vind og strøm er bare kjent i %1 t</translation>
    </message>
    <message>
        <source>--latitude is required: growlers and bergy bits drift to the right of the wind in the north, to the left in the south</source>
        <translation>--latitude kreves: growlere og bergy bits driver til høyre for vinden i nord, til venstre i sør</translation>
    </message>
    <message>
        <source>%1 can be reached from the network; MAVLink is neither encrypted nor signed</source>
        <translation>%1 kan nås fra nettverket; MAVLink er verken kryptert eller signert</translation>
    </message>
    <message>
        <source>%1 ends here: it has 1 GiB</source>
        <translation>%1 slutter her: den er på 1 GiB</translation>
    </message>
    <message>
        <source>the link is broken: %1</source>
        <translation>forbindelsen er brutt: %1</translation>
    </message>
    <message>
        <source>the link is open again</source>
        <translation>forbindelsen er åpen igjen</translation>
    </message>
    <message>
        <source>packets from %1, which is not part of the link, are ignored</source>
        <translation>pakker fra %1, som ikke er en del av forbindelsen, blir ignorert</translation>
    </message>
    <message>
        <source>%1 is no telemetry log</source>
        <translation>%1 er ingen telemetrilogg</translation>
    </message>
    <message>
        <source>--uav: choose one; a link has at most %1 vehicles</source>
        <translation>--uav: velg én; en forbindelse har høyst %1 fartøyer</translation>
    </message>
    <message>
        <source>A forecast is the JSON reply of MET Norway&apos;s locationforecast or oceanforecast, NetCDF or GRIB.</source>
        <translation>Et varsel er JSON-svaret fra locationforecast eller oceanforecast hos MET Norway, NetCDF eller GRIB.</translation>
    </message>
    <message>
        <source>dew point</source>
        <translation>duggpunkt</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>sikt</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>skydekkehøyde</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>leser</translation>
    </message>
    <message>
        <source>the grid is too large and was thinned by a factor of %1 in each direction; choose a smaller area or time</source>
        <translation>gitteret er for stort og ble uttynnet med en faktor %1 i hver retning; velg et mindre område eller tidsrom</translation>
    </message>
    <message>
        <source>--format forecast needs --into, the scenario to add it to</source>
        <translation>--format forecast trenger --into, scenarioet som det legges til i</translation>
    </message>
    <message>
        <source>--format forecast accepts only --into, --at, --replace, --output, --force and --json</source>
        <translation>--format forecast godtar bare --into, --at, --replace, --output, --force og --json</translation>
    </message>
    <message>
        <source>%1 is a forecast; use --format forecast with --into SCENARIO</source>
        <translation>%1 er et varsel: bruk --format forecast med --into SCENARIO</translation>
    </message>
    <message>
        <source>photograph %1</source>
        <translation>fotografi %1</translation>
    </message>
    <message>
        <source>--run is about photographs only</source>
        <translation>--run gjelder bare fotografier</translation>
    </message>
    <message>
        <source>--format: %1 has one file, not photographs</source>
        <translation>--format: %1 har én fil, ikke fotografier</translation>
    </message>
    <message>
        <source>--uav: the run has no UAV %1</source>
        <translation>--uav: flygingen har ingen UAV %1</translation>
    </message>
    <message>
        <source>--format %1 needs --into, the scenario to add it to</source>
        <translation>--format %1 trenger --into, scenarioet som det legges til i</translation>
    </message>
    <message>
        <source>--format %1 accepts only --into, --output, --force and --json</source>
        <translation>--format %1 godtar bare --into, --output, --force og --json</translation>
    </message>
    <message>
        <source>%1 is an ice chart; use --into SCENARIO</source>
        <translation>%1 er et iskart: bruk --into SCENARIO</translation>
    </message>
    <message>
        <source>--hours, --every: more than %1 points</source>
        <translation>--hours, --every: mer enn %1 punkter</translation>
    </message>
    <message>
        <source>--hours, --every: more than %1 starts</source>
        <translation>--hours, --every: mer enn %1 starter</translation>
    </message>
    <message>
        <source>%1 is aground from hour %2 on</source>
        <translation>%1 står på grunn fra time %2</translation>
    </message>
    <message>
        <source>the forecast gives wind and current for %1 h only</source>
        <translation>varselet gir vind og strøm for bare %1 t</translation>
    </message>
</context>
<context>
    <name>ComparedRunText</name>
    <message>
        <source>%1, changed in flight, to %2</source>
        <translation>%1, endret under flyging, til %2</translation>
    </message>
    <message>
        <source>%1, changed in flight</source>
        <translation>%1, endret under flyging</translation>
    </message>
    <message>
        <source>%1, to %2</source>
        <translation>%1, til %2</translation>
    </message>
</context>
<context>
    <name>ComparisonChartText</name>
    <message>
        <source>The same ζ</source>
        <translation>Samme ζ</translation>
    </message>
    <message>
        <source>%1 ahead by %2 %</source>
        <translation>%1 leder med %2 %</translation>
    </message>
    <message>
        <source>%1 and %2: the same ζ</source>
        <translation>%1 og %2: samme ζ</translation>
    </message>
    <message>
        <source>%1 is ahead: %2 has %3 % more ζ</source>
        <translation>%1 leder: %2 har %3 % mer ζ</translation>
    </message>
    <message>
        <source>%1 is ahead: it has %3 % less ζ than %2</source>
        <translation>%1 leder: den har %3 % mindre ζ enn %2</translation>
    </message>
</context>
<context>
    <name>ComparisonText</name>
    <message>
        <source>Zeta ζ, m² s</source>
        <translation>Zeta ζ, m² s</translation>
    </message>
    <message>
        <source>Accumulated uncertainty, Eq. (24): less is better.</source>
        <translation>Samlet usikkerhet, ligning (24): mindre er bedre.</translation>
    </message>
    <message>
        <source>Mean Σσ, m²</source>
        <translation>Middel Σσ, m²</translation>
    </message>
    <message>
        <source>Mean total uncertainty of all icebergs: ζ divided by the flown time.</source>
        <translation>Gjennomsnittlig samlet usikkerhet for alle isfjell: ζ delt på den fløyne tiden.</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besøk</translation>
    </message>
    <message>
        <source>Plans</source>
        <translation>Planer</translation>
    </message>
    <message>
        <source>Number of plans made.</source>
        <translation>Antall planer som er laget.</translation>
    </message>
    <message>
        <source>Distance flown through the air.</source>
        <translation>Avstand fløyet gjennom luften.</translation>
    </message>
    <message>
        <source>Longest unseen</source>
        <translation>Lengst usett</translation>
    </message>
    <message>
        <source>Longest time for which an iceberg was out of view.</source>
        <translation>Lengste tid et isfjell var ute av syne.</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>The iceberg that was out of view for the longest time.</source>
        <translation>Isfjellet som var ute av syne lengst.</translation>
    </message>
    <message>
        <source>Unseen for %1 in total in A.</source>
        <translation>Usett i %1 til sammen i A.</translation>
    </message>
    <message>
        <source>Flown, %1</source>
        <translation>Fløyet, %1</translation>
    </message>
    <message>
        <source>%1, visits</source>
        <translation>%1, besøk</translation>
    </message>
    <message>
        <source>Icebergs that %1 reached.</source>
        <translation>Isfjell som %1 har nådd.</translation>
    </message>
    <message>
        <source>Distance that %1 has flown through the air.</source>
        <translation>Avstand som %1 har fløyet gjennom luften.</translation>
    </message>
    <message>
        <source>Icebergs reached as targets.</source>
        <translation>Isfjell som ble nådd som mål.</translation>
    </message>
</context>
<context>
    <name>CurveText</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 til %2</translation>
    </message>
    <message>
        <source>τ %1: whole order %2, proven optimal</source>
        <translation>τ %1: hele rekkefølgen %2, bevist optimal</translation>
    </message>
    <message>
        <source>τ %1: whole order %2, not proven</source>
        <translation>τ %1: hele rekkefølgen %2, ikke bevist</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Ulagrede endringer</translation>
    </message>
    <message>
        <source>Save the changes to &quot;%1&quot;?</source>
        <translation>Lagre endringene i «%1»?</translation>
    </message>
    <message>
        <source>Your changes will be lost if you don&apos;t save them.</source>
        <translation>Endringene går tapt hvis du ikke lagrer dem.</translation>
    </message>
    <message>
        <source>Your changes will be lost if you don&apos;t save them. The flight in progress ends unless you cancel.</source>
        <translation>Endringene går tapt hvis du ikke lagrer dem. Flygingen som pågår, avsluttes hvis du ikke avbryter.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Åpne</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Lagre</translation>
    </message>
    <message>
        <source>Bergwatch</source>
        <translation>Bergwatch</translation>
    </message>
    <message>
        <source>File in use</source>
        <translation>Filen er i bruk</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another window.</source>
        <translation>«%1» er åpen i et annet vindu.</translation>
    </message>
    <message>
        <source>%1 has it open. You can open a copy and save it under another name. If both windows save to this file, the last one wins.</source>
        <translation>%1 har den åpen. Du kan åpne en kopi og lagre den under et annet navn. Hvis begge vinduene lagrer til denne filen, gjelder den siste lagringen.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Åpne en kopi</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Åpne likevel</translation>
    </message>
    <message>
        <source>Overwrite the file?</source>
        <translation>Skrive over filen?</translation>
    </message>
    <message>
        <source>Overwrite &quot;%1&quot;?</source>
        <translation>Skrive over «%1»?</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Skriv over</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Lagre som …</translation>
    </message>
    <message>
        <source>File changed</source>
        <translation>Filen er endret</translation>
    </message>
    <message>
        <source>Another program has changed &quot;%1&quot;.</source>
        <translation>Et annet program har endret «%1».</translation>
    </message>
    <message>
        <source>You have no unsaved changes.</source>
        <translation>Du har ingen ulagrede endringer.</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>Åpne på nytt</translation>
    </message>
    <message>
        <source>Keep what I see</source>
        <translation>Behold det jeg ser</translation>
    </message>
    <message>
        <source>Flight under way</source>
        <translation>Flyging pågår</translation>
    </message>
    <message>
        <source>A flight has started in the meantime. End it?</source>
        <translation>En flyging har begynt i mellomtiden. Avslutte den?</translation>
    </message>
    <message>
        <source>A flight is in progress. End it?</source>
        <translation>En flyging pågår. Avslutte den?</translation>
    </message>
    <message>
        <source>The scenario can only be changed when no flight is in progress. The flight stays in the list of runs.</source>
        <translation>Scenarioet kan bare endres når ingen flyging pågår. Flygingen blir stående i listen over flyginger.</translation>
    </message>
    <message>
        <source>What has been flown so far stays in the list of runs.</source>
        <translation>Det som er fløyet til nå, blir stående i listen over flyginger.</translation>
    </message>
    <message>
        <source>End the flight</source>
        <translation>Avslutt flygingen</translation>
    </message>
    <message>
        <source>Continue flight</source>
        <translation>Fly videre</translation>
    </message>
    <message>
        <source>Unsaved run</source>
        <translation>Ulagret flyging</translation>
    </message>
    <message>
        <source>Save the run?</source>
        <translation>Lagre flygingen?</translation>
    </message>
    <message>
        <source>The flight will be lost if you don&apos;t save it.</source>
        <translation>Flygingen går tapt hvis du ikke lagrer den.</translation>
    </message>
    <message>
        <source>Save the run before the flight ends?</source>
        <translation>Lagre flygingen før den avsluttes?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Forkast</translation>
    </message>
    <message>
        <source>&amp;Save run...</source>
        <translation>&amp;Lagre flyging...</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Remove icebergs</source>
        <translation>Fjern isfjell</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n icebergs from this run?</source>
        <translation>
            <numerusform>Fjerne %n isfjell fra denne flygingen?</numerusform>
            <numerusform>Fjerne %n isfjell fra denne flygingen?</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Fjern</translation>
    </message>
    <message>
        <source>Magnetic declination</source>
        <translation>Magnetisk misvisning</translation>
    </message>
    <message>
        <source>Degrees from true to magnetic north, positive east, negative west:</source>
        <translation>Grader fra rettvisende til magnetisk nord, positivt mot øst, negativt mot vest:</translation>
    </message>
    <message>
        <source>%1: the UAV will not visit them any more.</source>
        <translation>%1: UAV-en besøker dem ikke mer.</translation>
    </message>
    <message>
        <source>Undo in flight</source>
        <translation>Angre under flyging</translation>
    </message>
    <message>
        <source>Undo &quot;%1&quot; of %2?</source>
        <translation>Angre «%1» fra %2?</translation>
    </message>
    <message>
        <source>The flight goes back to that time and continues without the change. The flight since then is discarded; &quot;Restore&quot; brings it back.</source>
        <translation>Flygingen går tilbake til den tiden og fortsetter uten endringen. Flygingen siden da forkastes; «Hent flygingen tilbake» gjenoppretter den.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Angre</translation>
    </message>
</context>
<context>
    <name>DriftArrow</name>
    <message>
        <source>The arrow shows the drift over %1. Shift snaps to steps of %2°; Esc cancels.</source>
        <translation>Pilen viser driften på %1. Skift går i trinn på %2°; Esc avbryter.</translation>
    </message>
    <message>
        <source>Heading %1</source>
        <translation>Kurs %1</translation>
    </message>
</context>
<context>
    <name>DriftTracksText</name>
    <message>
        <source>+%1 h</source>
        <translation>+%1 t</translation>
    </message>
</context>
<context>
    <name>ErrorText</name>
    <message>
        <source>There is no such file. Check the name and the folder.</source>
        <translation>Filen finnes ikke. Kontroller navnet og mappen.</translation>
    </message>
    <message>
        <source>The file cannot be read. Check that it is a file and that you have permission to read it.</source>
        <translation>Filen kan ikke leses. Kontroller at det er en fil, og at du har tillatelse til å lese den.</translation>
    </message>
    <message>
        <source>The file cannot be written. Check that the folder exists, that you have permission to write there and that the disk is not full.</source>
        <translation>Filen kan ikke skrives. Kontroller at mappen finnes, at du har tillatelse til å skrive der, og at disken ikke er full.</translation>
    </message>
    <message>
        <source>The file is too large for a Bergwatch file.</source>
        <translation>Filen er for stor til å være en fil fra Bergwatch.</translation>
    </message>
    <message>
        <source>This is not a Bergwatch file, or it is damaged at the place named.</source>
        <translation>Dette er ikke en Bergwatch-fil, eller den er skadet på stedet som er oppgitt.</translation>
    </message>
    <message>
        <source>This file is of a different type than expected here.</source>
        <translation>Filen er av en annen type enn det som ventes her.</translation>
    </message>
    <message>
        <source>The file was made by a newer version of Bergwatch. Update the program to open it.</source>
        <translation>Filen er laget av en nyere versjon av Bergwatch. Oppdater programmet for å åpne den.</translation>
    </message>
    <message>
        <source>These values are not valid. Correct them and try again.</source>
        <translation>Disse verdiene er ugyldige. Rett dem og prøv igjen.</translation>
    </message>
    <message>
        <source>This version of Bergwatch cannot do that.</source>
        <translation>Denne versjonen av Bergwatch kan ikke gjøre det.</translation>
    </message>
    <message>
        <source>The planner failed. Choose another solver.</source>
        <translation>Planleggeren mislyktes. Velg en annen løser.</translation>
    </message>
    <message>
        <source>The replay of the run differs from the recording. The file may come from another version of Bergwatch.</source>
        <translation>Avspillingen av flygingen avviker fra opptaket. Filen kan komme fra en annen versjon av Bergwatch.</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… og %n til</numerusform>
            <numerusform>… og %n til</numerusform>
        </translation>
    </message>
    <message>
        <source>The file is too large to be imported. Split it, or leave out what is not needed.</source>
        <translation>Filen er for stor til å importeres. Del den, eller utelat det som ikke trengs.</translation>
    </message>
    <message>
        <source>The file is broken. Correct it at the place named, or export it again.</source>
        <translation>Filen er ødelagt. Rett den på det oppgitte stedet, eller eksporter den på nytt.</translation>
    </message>
    <message>
        <source>Bergwatch does not recognise this file. If it is a table, choose its latitude and longitude columns below.</source>
        <translation>Bergwatch gjenkjenner ikke denne filen. Hvis det er en tabell, velger du kolonnene for bredde og lengde nedenfor.</translation>
    </message>
    <message>
        <source>Nothing of it can be used like this.</source>
        <translation>Ingenting i den kan brukes slik den er.</translation>
    </message>
</context>
<context>
    <name>EventText</name>
    <message>
        <source>Planned: next %1</source>
        <translation>Planlagt: neste er %1</translation>
    </message>
    <message>
        <source>%1 reached</source>
        <translation>%1 nådd</translation>
    </message>
    <message>
        <source>%1 in view</source>
        <translation>%1 i syne</translation>
    </message>
    <message>
        <source>%1 appeared</source>
        <translation>%1 dukket opp</translation>
    </message>
    <message>
        <source>take-off</source>
        <translation>avgang</translation>
    </message>
    <message>
        <source>iceberg reached</source>
        <translation>isfjell nådd</translation>
    </message>
    <message>
        <source>iceberg out of view again</source>
        <translation>isfjell ute av syne igjen</translation>
    </message>
    <message>
        <source>new iceberg</source>
        <translation>nytt isfjell</translation>
    </message>
    <message>
        <source>changed in flight</source>
        <translation>endret under flyging</translation>
    </message>
    <message>
        <source>%1 reported seen</source>
        <translation>%1 meldt sett</translation>
    </message>
    <message>
        <source>iceberg sighted en route</source>
        <translation>isfjell sett underveis</translation>
    </message>
    <message>
        <source>sighting overdue</source>
        <translation>observasjon uteblitt</translation>
    </message>
    <message>
        <source>The planner failed: continuing with the previous plan</source>
        <translation>Planleggeren sviktet: fortsetter med forrige plan</translation>
    </message>
    <message>
        <source>Wind changed</source>
        <translation>Vinden endret</translation>
    </message>
    <message>
        <source>The protected asset has changed</source>
        <translation>Det beskyttede objektet er endret</translation>
    </message>
    <message>
        <source>%1 has left the area</source>
        <translation>%1 har forlatt området</translation>
    </message>
    <message>
        <source>%1 is lost: not where it should be</source>
        <translation>%1 er tapt: ikke der det skulle være</translation>
    </message>
    <message>
        <source>%1 found again</source>
        <translation>%1 funnet igjen</translation>
    </message>
    <message>
        <source>Search for %1 given up</source>
        <translation>Letingen etter %1 er oppgitt</translation>
    </message>
    <message>
        <source>Returning home</source>
        <translation>På vei hjem</translation>
    </message>
    <message>
        <source>Landed</source>
        <translation>Landet</translation>
    </message>
    <message>
        <source>Took off</source>
        <translation>Tok av</translation>
    </message>
    <message>
        <source>iceberg left the area</source>
        <translation>isfjell forlot området</translation>
    </message>
    <message>
        <source>iceberg lost</source>
        <translation>isfjell tapt</translation>
    </message>
    <message>
        <source>lost iceberg found</source>
        <translation>tapt isfjell funnet</translation>
    </message>
    <message>
        <source>search given up</source>
        <translation>leting oppgitt</translation>
    </message>
    <message>
        <source>next sortie</source>
        <translation>neste tokt</translation>
    </message>
    <message>
        <source>Any UAV may visit %1</source>
        <translation>Enhver UAV kan besøke %1</translation>
    </message>
    <message>
        <source>%1 and %2 are %3 apart</source>
        <translation>%1 og %2 er %3 fra hverandre</translation>
    </message>
    <message>
        <source>%1 has nothing to visit: circling</source>
        <translation>%1 har ingenting å besøke: sirkler</translation>
    </message>
    <message>
        <source>%1 flies to %2 next</source>
        <translation>%1 flyr til %2 som neste</translation>
    </message>
    <message>
        <source>seen by another UAV</source>
        <translation>sett av en annen UAV</translation>
    </message>
    <message>
        <source>another UAV needed a plan</source>
        <translation>en annen UAV trengte en plan</translation>
    </message>
    <message>
        <source>Outside the geofence</source>
        <translation>Utenfor geogjerdet</translation>
    </message>
    <message>
        <source>Back inside the geofence</source>
        <translation>Innenfor geogjerdet igjen</translation>
    </message>
    <message>
        <source>Told to resume</source>
        <translation>Fikk beskjed om å fortsette</translation>
    </message>
    <message>
        <source>Told to return now</source>
        <translation>Fikk beskjed om å fly hjem nå</translation>
    </message>
    <message>
        <source>Told to hold here</source>
        <translation>Fikk beskjed om å holde her</translation>
    </message>
    <message>
        <source>Home cannot be reached in time</source>
        <translation>Hjem kan ikke nås i tide</translation>
    </message>
    <message>
        <source>end of hold</source>
        <translation>slutt på ventingen</translation>
    </message>
    <message>
        <source>Planned from now on by: %2</source>
        <translation>Planlegges fra nå av med: %2</translation>
    </message>
    <message>
        <source>%1 removed</source>
        <translation>%1 fjernet</translation>
    </message>
    <message>
        <source>%1 added</source>
        <translation>%1 lagt til</translation>
    </message>
    <message>
        <source>Close to another UAV: %3</source>
        <translation>Nær en annen UAV: %3</translation>
    </message>
    <message>
        <source>Previous plan kept: next %1</source>
        <translation>Forrige plan beholdt: neste er %1</translation>
    </message>
    <message>
        <source>%1 will enter the inner ring in %4</source>
        <translation>%1 vil komme inn i den indre ringen om %4</translation>
    </message>
    <message>
        <source>%1 assigned to %2</source>
        <translation>%1 tildelt %2</translation>
    </message>
    <message>
        <source>Nothing to visit now: circling</source>
        <translation>Ingenting å besøke nå: sirkler</translation>
    </message>
</context>
<context>
    <name>ExportPicture</name>
    <message>
        <source>No icebergs</source>
        <translation>Ingen isfjell</translation>
    </message>
</context>
<context>
    <name>ExportText</name>
    <message>
        <source>Mission plan</source>
        <translation>Oppdragsplan</translation>
    </message>
    <message>
        <source>Waypoint list</source>
        <translation>Veipunktliste</translation>
    </message>
    <message>
        <source>QGIS and other map programs</source>
        <translation>QGIS og andre kartprogrammer</translation>
    </message>
    <message>
        <source>Icebergs, UAVs, paths and area as features with their numbers, longitude and latitude of WGS 84.</source>
        <translation>Isfjell, UAV-er, baner og område som objekter med tallene sine, lengde og bredde i WGS 84.</translation>
    </message>
    <message>
        <source>Chart plotters, Garmin</source>
        <translation>Kartplottere, Garmin</translation>
    </message>
    <message>
        <source>Icebergs as waypoints, the order as a route, a path or what was flown as a track with times.</source>
        <translation>Isfjell som veipunkter, rekkefølgen som rute, en bane eller fløyet spor som spor med tider.</translation>
    </message>
    <message>
        <source>UAVs and icebergs moving in time over the globe, with paths, area and asset.</source>
        <translation>UAV-er og isfjell som beveger seg i tid over kloden, med baner, område og objekt.</translation>
    </message>
    <message>
        <source>The same as KML, packed into one small file.</source>
        <translation>Det samme som KML, pakket i én liten fil.</translation>
    </message>
    <message>
        <source>Paths in the colours of the UAVs, with times if the scenario has a start; icebergs with their numbers.</source>
        <translation>Baner i UAV-enes farger, med tider hvis scenarioet har en start; isfjell med tallene sine.</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Usikkerhet</translation>
    </message>
    <message>
        <source>Spreadsheets</source>
        <translation>Regneark</translation>
    </message>
    <message>
        <source>Table with the uncertainty of every iceberg over the time of the flight.</source>
        <translation>Tabell med usikkerheten til hvert isfjell over tiden i flygingen.</translation>
    </message>
    <message>
        <source>Decisions</source>
        <translation>Avgjørelser</translation>
    </message>
    <message>
        <source>Table with plans, visits and what else happened in the flight.</source>
        <translation>Tabell med planer, besøk og andre hendelser under flygingen.</translation>
    </message>
    <message>
        <source>Zeta</source>
        <translation>Zeta-kurve</translation>
    </message>
    <message>
        <source>Table with zeta over the time of the flight.</source>
        <translation>Tabell med zeta over tiden i flygingen.</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bane</translation>
    </message>
    <message>
        <source>Table of the order with legs, coordinates and arrivals; of a path or what was flown one row for each point.</source>
        <translation>Tabell over rekkefølgen med etapper, koordinater og ankomster; for en bane eller et fløyet spor én rad per punkt.</translation>
    </message>
    <message>
        <source>Autopilots</source>
        <translation>Autopiloter</translation>
    </message>
    <message>
        <source>Maps and globes</source>
        <translation>Kart og kloder</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabeller</translation>
    </message>
    <message>
        <source>Good to know</source>
        <translation>Verdt å vite</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Endret</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Utelatt</translation>
    </message>
    <message>
        <source>Map as %1</source>
        <translation>Kart som %1</translation>
    </message>
    <message>
        <source>Charts as %1</source>
        <translation>Diagrammer som %1</translation>
    </message>
    <message>
        <source>Flight brief</source>
        <translation>Flygeark</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papir</translation>
    </message>
    <message>
        <source>Drawing programs</source>
        <translation>Tegneprogrammer</translation>
    </message>
    <message>
        <source>Documents and messages</source>
        <translation>Dokumenter og meldinger</translation>
    </message>
    <message>
        <source>The map with icebergs, paths and area, light, with scale and legend.</source>
        <translation>Kartet med isfjell, baner og område, lyst, med målestokk og tegnforklaring.</translation>
    </message>
    <message>
        <source>Zeta and the uncertainty of every iceberg over the time of the flight.</source>
        <translation>Zeta og usikkerheten til hvert isfjell over tiden i flygingen.</translation>
    </message>
    <message>
        <source>Pictures and print</source>
        <translation>Bilder og utskrift</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Høyde</translation>
    </message>
    <message>
        <source>Airspeed</source>
        <translation>Flyfart</translation>
    </message>
    <message>
        <source>Acceptance radius</source>
        <translation>Passeringsradius</translation>
    </message>
    <message>
        <source>Loiter turns</source>
        <translation>Runder over isfjell</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Hva</translation>
    </message>
    <message>
        <source>Flight log</source>
        <translation>Flygelogg</translation>
    </message>
    <message>
        <source>Two or three pages: planned and flown, map, zeta against prediction, sightings, deviations.</source>
        <translation>To eller tre sider: planlagt og fløyet, kart, zeta mot forutsigelsen, observasjoner, avvik.</translation>
    </message>
    <message>
        <source>Browsers</source>
        <translation>Nettlesere</translation>
    </message>
    <message>
        <source>Page with planned and flown, zeta against prediction, all sightings and deviations.</source>
        <translation>Side med planlagt og fløyet, zeta mot forutsigelsen, alle observasjoner og avvik.</translation>
    </message>
    <message>
        <source>Return home</source>
        <translation>Fly hjem</translation>
    </message>
    <message>
        <source>Mission items as QGC WPL 110, the first row home, for Mission Planner and MAVProxy. No geofence. One file per UAV.</source>
        <translation>Oppdragselementer som QGC WPL 110 for Mission Planner og MAVProxy; første rad er hjemstedet. Uten geogjerde. Én fil per UAV.</translation>
    </message>
    <message>
        <source>To print and carry: map, order with coordinates, legs and times, wind, warnings; plus a second page if there is an operation volume.</source>
        <translation>Til å skrive ut og ta med: kart, rekkefølge med koordinater, etapper og tider, vind, advarsler; pluss en andre side hvis det finnes et operasjonsvolum.</translation>
    </message>
    <message>
        <source>Mission items from take-off to landing for the autopilot of the UAV, the geofence and a rally point at home. Also read by Mission Planner and MAVSDK. One file per UAV.</source>
        <translation>Oppdraget fra avgang til landing for autopiloten i UAV-en, geogjerdet og et samlingspunkt ved hjemstedet. Filen leses også av Mission Planner og MAVSDK. Én fil per UAV.</translation>
    </message>
    <message>
        <source>Check before the flight</source>
        <translation>Kontroller før flygingen</translation>
    </message>
    <message>
        <source>Sightings</source>
        <translation>Observasjoner</translation>
    </message>
    <message>
        <source>Ice services</source>
        <translation>Istjenester</translation>
    </message>
    <message>
        <source>Table of the sightings of the flight in the columns of the International Ice Patrol.</source>
        <translation>Tabell over observasjonene i flygingen, i kolonnene til International Ice Patrol.</translation>
    </message>
    <message>
        <source>ArcGIS and other GIS</source>
        <translation>ArcGIS og andre GIS</translation>
    </message>
    <message>
        <source>Everything on the map as zipped Shapefiles of points, lines and areas. Needs ogr2ogr (package gdal-bin).</source>
        <translation>Alt på kartet som pakkede Shapefiler med punkter, linjer og områder. Trenger ogr2ogr (pakken gdal-bin).</translation>
    </message>
    <message>
        <source>QGIS and other GIS</source>
        <translation>QGIS og andre GIS</translation>
    </message>
    <message>
        <source>Everything on the map in one layer. Needs ogr2ogr (package gdal-bin).</source>
        <translation>Alt på kartet i ett lag. Trenger ogr2ogr (pakken gdal-bin).</translation>
    </message>
    <message>
        <source>Other GIS</source>
        <translation>Andre GIS</translation>
    </message>
    <message>
        <source>CAD programs</source>
        <translation>CAD-programmer</translation>
    </message>
    <message>
        <source>A drawing in metres: places, lines and outlines in layers, without names and numbers. Needs ogr2ogr (package gdal-bin).</source>
        <translation>En tegning i meter: steder, linjer og omriss i lag, uten navn og tall. Trenger ogr2ogr (pakken gdal-bin).</translation>
    </message>
</context>
<context>
    <name>FieldNames</name>
    <message>
        <source>Time of the recorded track</source>
        <translation>Tidspunkt i det registrerte sporet</translation>
    </message>
    <message>
        <source>Place of the recorded track</source>
        <translation>Sted i det registrerte sporet</translation>
    </message>
    <message>
        <source>South</source>
        <translation>Sør</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>West</source>
        <translation>Vest</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Øst</translation>
    </message>
    <message>
        <source>Start at</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Not before</source>
        <translation>Ikke før</translation>
    </message>
    <message>
        <source>Not after</source>
        <translation>Ikke etter</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origo</translation>
    </message>
    <message>
        <source>Number of icebergs</source>
        <translation>Antall isfjell</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Område</translation>
    </message>
    <message>
        <source>Lowest speed</source>
        <translation>Laveste fart</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Høyeste fart</translation>
    </message>
    <message>
        <source>Drift direction, clockwise from north</source>
        <translation>Retningen på driften, med klokken fra nord</translation>
    </message>
    <message>
        <source>Spread to either side</source>
        <translation>Spredning til hver side</translation>
    </message>
    <message>
        <source>Smallest σ at the start</source>
        <translation>Minste σ ved start</translation>
    </message>
    <message>
        <source>Largest σ at the start</source>
        <translation>Største σ ved start</translation>
    </message>
    <message>
        <source>Growth of σ</source>
        <translation>Vekst i σ</translation>
    </message>
    <message>
        <source>Minimum distance between two icebergs</source>
        <translation>Minste avstand mellom to isfjell</translation>
    </message>
</context>
<context>
    <name>FileNames</name>
    <message>
        <source>Untitled</source>
        <translation>Uten navn</translation>
    </message>
</context>
<context>
    <name>FlightBrief</name>
    <message>
        <source>Times count from the start of the run</source>
        <translation>Tider regnes fra starten av flygingen</translation>
    </message>
    <message>
        <source>Start %1 %2 UTC</source>
        <translation>Start %1 %2 UTC</translation>
    </message>
    <message>
        <source>No wind</source>
        <translation>Ingen vind</translation>
    </message>
    <message>
        <source>%1 %2 from %3</source>
        <translation>%1 %2 fra %3</translation>
    </message>
    <message>
        <source>%1 %2 towards %3</source>
        <translation>%1 %2 mot %3</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
    <message>
        <source>Wind, true</source>
        <translation>Vind, rettvisende</translation>
    </message>
    <message>
        <source>Current, true</source>
        <translation>Strøm, rettvisende</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distanse</translation>
    </message>
    <message>
        <source>Time of flight</source>
        <translation>Flygetid</translation>
    </message>
    <message>
        <source>End, UTC</source>
        <translation>Slutt, UTC</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Slutt</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>Planned by</source>
        <translation>Planlagt etter</translation>
    </message>
    <message>
        <source>Last plan</source>
        <translation>Siste plan</translation>
    </message>
    <message>
        <source>Order of visits</source>
        <translation>Besøksrekkefølge</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>UAV</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Høyde</translation>
    </message>
    <message>
        <source>Airspeed</source>
        <translation>Flyfart</translation>
    </message>
    <message>
        <source>Turn radius</source>
        <translation>Svingradius</translation>
    </message>
    <message>
        <source>Acceptance radius</source>
        <translation>Passeringsradius</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Hjem</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Loiter turns</source>
        <translation>Runder</translation>
    </message>
    <message>
        <source>Endurance left</source>
        <translation>Utholdenhet igjen</translation>
    </message>
    <message>
        <source>Endurance</source>
        <translation>Utholdenhet</translation>
    </message>
    <message>
        <source>Positions are WGS 84. Icebergs drift: each is listed where it was when reached. Courses and distances are over ground.</source>
        <translation>Posisjonene er i WGS 84. Isfjell driver: hvert er oppgitt der det var da det ble nådd. Kurser og avstander er over grunnen.</translation>
    </message>
    <message>
        <source>Positions are WGS 84. Icebergs drift: each is listed where it is expected at arrival. Courses and distances are over ground.</source>
        <translation>Posisjonene er i WGS 84. Isfjell driver: hvert er oppgitt der det ventes ved ankomst. Kurser og avstander er over grunnen.</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>Origo %1</translation>
    </message>
    <message>
        <source>Flight brief: %1</source>
        <translation>Flygeark: %1</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>og %1 til</translation>
    </message>
    <message>
        <source>No warnings</source>
        <translation>Ingen advarsler</translation>
    </message>
    <message>
        <source>Warnings (%1)</source>
        <translation>Advarsler (%1)</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Merknader</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Startsted</translation>
    </message>
    <message>
        <source>End of track</source>
        <translation>Sporets slutt</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Lengde</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>true</source>
        <translation>rettv.</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Etappe</translation>
    </message>
    <message>
        <source>Reached</source>
        <translation>Nådd</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Ankomst</translation>
    </message>
    <message>
        <source>σ now</source>
        <translation>σ nå</translation>
    </message>
    <message>
        <source>and %1 more; export CSV for the whole list</source>
        <translation>og %1 til; eksporter CSV for hele listen</translation>
    </message>
    <message>
        <source>and %1 more UAVs; export CSV for the whole list</source>
        <translation>og %1 UAV-er til; eksporter CSV for hele listen</translation>
    </message>
    <message>
        <source>Lost, not found where expected (%1): %2</source>
        <translation>Tapt, ikke funnet der de var ventet (%1): %2</translation>
    </message>
    <message>
        <source>Search given up (%1): %2</source>
        <translation>Gitt opp etter leting (%1): %2</translation>
    </message>
    <message>
        <source>Not visited (%1): %2</source>
        <translation>Ikke fløyet til (%1): %2</translation>
    </message>
    <message>
        <source>Not in the order (%1): %2</source>
        <translation>Ikke i rekkefølgen (%1): %2</translation>
    </message>
    <message>
        <source>The order is not proven optimal: %1.</source>
        <translation>Rekkefølgen er ikke bevist optimal: %1.</translation>
    </message>
    <message>
        <source>Geofence in force: stay inside the area.</source>
        <translation>Geogjerdet gjelder: hold deg innenfor området.</translation>
    </message>
    <message>
        <source>UAVs share an altitude layer: keep them %1 apart. They do not avoid each other.</source>
        <translation>UAV-er deler et høydelag: hold dem %1 fra hverandre. De unngår ikke hverandre.</translation>
    </message>
    <message>
        <source>Nothing to visit</source>
        <translation>Ingenting å besøke</translation>
    </message>
    <message>
        <source>Solver limit reached; previous plan kept</source>
        <translation>Grensen for løseren er nådd; forrige plan er beholdt</translation>
    </message>
    <message>
        <source>Chosen one iceberg at a time</source>
        <translation>Valgt ett isfjell om gangen</translation>
    </message>
    <message>
        <source>Proven optimal</source>
        <translation>Bevist optimal</translation>
    </message>
    <message>
        <source>Within %1 % of optimal</source>
        <translation>Innenfor %1 % av optimum</translation>
    </message>
    <message>
        <source>Best order found</source>
        <translation>Beste rekkefølge funnet</translation>
    </message>
    <message>
        <source>Not planned by a solver</source>
        <translation>Ikke planlagt av en løser</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>Feil: %1</translation>
    </message>
    <message>
        <source>The planner reached its limit without an order. The UAV flies the rest of the previous plan, or to the nearest iceberg.</source>
        <translation>Planleggeren nådde grensen uten en rekkefølge. UAV-en flyr resten av forrige plan, eller til det nærmeste isfjellet.</translation>
    </message>
    <message>
        <source>Nothing to visit for %1</source>
        <translation>Ingenting å besøke for %1</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Varighet</translation>
    </message>
    <message>
        <source>%1 (%2): %3</source>
        <translation>%1 (%2): %3</translation>
    </message>
    <message>
        <source>Times do not include the loiter turns, which add %1 at each iceberg, %2 in total.</source>
        <translation>Tidene omfatter ikke rundene over isfjell, som legger til %1 ved hvert isfjell, %2 i alt.</translation>
    </message>
    <message>
        <source>With the loiter turns the endurance is too short: %1</source>
        <translation>Med rundene over isfjell er utholdenheten for kort: %1</translation>
    </message>
    <message>
        <source>Reserve</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>No-fly area: %1.</source>
        <translation>Flyforbudsområde: %1.</translation>
    </message>
    <message>
        <source>No-fly area %1: %2.</source>
        <translation>Flyforbudsområde %1: %2.</translation>
    </message>
    <message>
        <source>Stand-off from the asset: %1, %2.</source>
        <translation>Sikkerhetsavstand til objektet: %1, %2.</translation>
    </message>
    <message>
        <source>Climb and landing</source>
        <translation>Stigning og landing</translation>
    </message>
    <message>
        <source>Recovery slot</source>
        <translation>Landingsvindu</translation>
    </message>
    <message>
        <source>Out of radio range</source>
        <translation>Utenfor radiorekkevidde</translation>
    </message>
    <message>
        <source>Probability of being in view on arrival: %1</source>
        <translation>Sannsynlighet for å være i synsfeltet ved ankomst: %1</translation>
    </message>
    <message>
        <source>Straight legs that leave the geofence or cross a no-fly area: %1. The UAV flies around.</source>
        <translation>Rette etapper som forlater geogjerdet eller krysser et flyforbudsområde: %1. UAV-en flyr utenom.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 til %2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>fra %1</translation>
    </message>
    <message>
        <source>until %1</source>
        <translation>til %1</translation>
    </message>
    <message>
        <source>all day</source>
        <translation>hele døgnet</translation>
    </message>
    <message>
        <source>not on this day</source>
        <translation>ikke denne dagen</translation>
    </message>
    <message>
        <source>Sun up, UTC</source>
        <translation>Sol oppe, UTC</translation>
    </message>
    <message>
        <source>Civil twilight, UTC</source>
        <translation>Borgerlig tussmørke, UTC</translation>
    </message>
    <message>
        <source>Declination, WMM2025</source>
        <translation>Misvisning, WMM2025</translation>
    </message>
    <message>
        <source>Declination</source>
        <translation>Misvisning</translation>
    </message>
    <message>
        <source>This sortie</source>
        <translation>Dette toktet</translation>
    </message>
    <message>
        <source>Home, above the reserve</source>
        <translation>Hjemme, over reserven</translation>
    </message>
    <message>
        <source>In 1 flight of 20</source>
        <translation>I 1 av 20 flyginger</translation>
    </message>
    <message>
        <source>magnetic</source>
        <translation>magn.</translation>
    </message>
    <message>
        <source>Speed</source>
        <comment>over ground</comment>
        <translation>Fart</translation>
    </message>
    <message>
        <source>Autopilot mission: %1.</source>
        <translation>Oppdrag for autopiloten: %1.</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <comment>speed, direction</comment>
        <translation>%1 fra %2</translation>
    </message>
    <message>
        <source>%1 towards %2</source>
        <comment>speed, direction</comment>
        <translation>%1 mot %2</translation>
    </message>
    <message>
        <source>Time, UTC</source>
        <translation>Tid, UTC</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Vindkast</translation>
    </message>
    <message>
        <source>The forecast has no wind between %1 and %2: the plan uses the constant wind of the scenario.</source>
        <translation>Varselet har ingen vind mellom %1 og %2: planen bruker den faste vinden i scenarioet.</translation>
    </message>
    <message>
        <source>The forecast was issued %1 h before the flight: look for a newer one.</source>
        <translation>Varselet ble utstedt %1 t før flygingen: se etter et nyere.</translation>
    </message>
    <message>
        <source>Weather and limits</source>
        <translation>Vær og grenser</translation>
    </message>
</context>
<context>
    <name>FlightDrag</name>
    <message>
        <source>Change wind</source>
        <translation>Endre vind</translation>
    </message>
    <message>
        <source>Release to apply this wind from now on. Esc cancels.</source>
        <translation>Slipp for å bruke denne vinden fra nå av. Esc avbryter.</translation>
    </message>
    <message>
        <source>Release to keep this wind. Shift snaps to steps of %1°; Esc cancels.</source>
        <translation>Slipp for å beholde denne vinden. Skift går i trinn på %1°; Esc avbryter.</translation>
    </message>
    <message>
        <source>Release to move the asset here now. Esc cancels.</source>
        <translation>Slipp for å flytte objektet hit nå. Esc avbryter.</translation>
    </message>
    <message>
        <source>The UAV makes little headway in this wind. Esc cancels.</source>
        <translation>UAV-en kommer knapt fremover i denne vinden. Esc avbryter.</translation>
    </message>
</context>
<context>
    <name>FlightNotices</name>
    <message numerus="yes">
        <source>%1, and %n more</source>
        <translation>
            <numerusform>%1, og %n til</numerusform>
            <numerusform>%1, og %n til</numerusform>
        </translation>
    </message>
    <message>
        <source>Searching for %1</source>
        <translation>Leter etter %1</translation>
    </message>
    <message>
        <source>On the ground, takes off in %1</source>
        <translation>På bakken, tar av om %1</translation>
    </message>
    <message>
        <source>It runs again when the next plan is needed.</source>
        <translation>Den kjøres igjen når neste plan trengs.</translation>
    </message>
    <message>
        <source>The wind changed in flight.</source>
        <translation>Vinden endret seg under flygingen.</translation>
    </message>
    <message>
        <source>They fly at about the same altitude. The required separation is %1.</source>
        <translation>De flyr i omtrent samme høyde. Påkrevd avstand er %1.</translation>
    </message>
    <message>
        <source>Wind above its limit: %1, limit %2</source>
        <translation>Vind over grensen: %1, grense %2</translation>
    </message>
    <message>
        <source>Holding as ordered</source>
        <translation>Holder som beordret</translation>
    </message>
    <message>
        <source>On the ground. Choose Resume to continue</source>
        <translation>På bakken. Velg Fortsett for å fly videre</translation>
    </message>
    <message>
        <source>%1 is lost</source>
        <translation>%1 er tapt</translation>
    </message>
    <message>
        <source>%1 is lost; the search was abandoned</source>
        <translation>%1 er tapt; letingen er oppgitt</translation>
    </message>
    <message>
        <source>It was not in view where it was expected.</source>
        <translation>Det var ikke i syne der det var ventet.</translation>
    </message>
    <message>
        <source>Makes little headway: wind %1, airspeed %2</source>
        <translation>Kommer knapt fremover: vind %1, flyfart %2</translation>
    </message>
</context>
<context>
    <name>ForecastText</name>
    <message>
        <source>%1 h</source>
        <translation>%1 t</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>vind</translation>
    </message>
    <message>
        <source>gusts</source>
        <translation>vindkast</translation>
    </message>
    <message>
        <source>air temperature</source>
        <translation>lufttemperatur</translation>
    </message>
    <message>
        <source>dew point</source>
        <translation>duggpunkt</translation>
    </message>
    <message>
        <source>fog</source>
        <translation>tåke</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>sikt</translation>
    </message>
    <message>
        <source>cloud base</source>
        <translation>skybase</translation>
    </message>
    <message>
        <source>current</source>
        <translation>strøm</translation>
    </message>
    <message>
        <source>unknown source</source>
        <translation>ukjent kilde</translation>
    </message>
    <message>
        <source>time of issue unknown</source>
        <translation>ukjent utstedelsestid</translation>
    </message>
    <message>
        <source>issued %1</source>
        <translation>utstedt %1</translation>
    </message>
    <message>
        <source>issued %1, %2 after the start</source>
        <translation>utstedt %1, %2 etter starten</translation>
    </message>
    <message>
        <source>issued %1, %2 before the start</source>
        <translation>utstedt %1, %2 før starten</translation>
    </message>
    <message>
        <source>Forecast of %1, %2</source>
        <comment>source, time of issue</comment>
        <translation>Varsel fra %1, %2</translation>
    </message>
</context>
<context>
    <name>HandleDrag</name>
    <message numerus="yes">
        <source>Change drift of %n icebergs</source>
        <translation>
            <numerusform>Endre drift</numerusform>
            <numerusform>Endre driften til %n isfjell</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn UAV</source>
        <translation>Drei UAV</translation>
    </message>
    <message>
        <source>Release to keep this heading. Shift snaps to steps of %1°; Esc cancels.</source>
        <translation>Slipp for å beholde denne kursen. Skift går i trinn på %1°; Esc avbryter.</translation>
    </message>
    <message>
        <source>Add corner</source>
        <translation>Legg til hjørne</translation>
    </message>
    <message>
        <source>Move corner</source>
        <translation>Flytt hjørne</translation>
    </message>
    <message>
        <source>Release to place the corner here. Esc cancels.</source>
        <translation>Slipp for å sette hjørnet her. Esc avbryter.</translation>
    </message>
    <message numerus="yes">
        <source>Drag to give all %n selected icebergs the same drift.</source>
        <translation>
            <numerusform>Dra for å gi %n valgt isfjell denne driften.</numerusform>
            <numerusform>Dra for å gi alle de %n valgte isfjellene samme drift.</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag to set the drift of the iceberg.</source>
        <translation>Dra for å sette driften til isfjellet.</translation>
    </message>
    <message>
        <source>Drag to turn the UAV.</source>
        <translation>Dra for å dreie UAV-en.</translation>
    </message>
    <message>
        <source>Drag to move the corner. To remove it, click it and press Del.</source>
        <translation>Dra for å flytte hjørnet. Klikk på det og trykk Delete for å fjerne det.</translation>
    </message>
    <message>
        <source>Drag to add a corner here.</source>
        <translation>Dra for å legge til et hjørne her.</translation>
    </message>
    <message>
        <source>An area needs at least three corners. Delete the whole area instead.</source>
        <translation>Et område trenger minst tre hjørner. Slett hele området i stedet.</translation>
    </message>
    <message>
        <source>Without this corner the outline would cross itself.</source>
        <translation>Uten dette hjørnet ville omrisset krysse seg selv.</translation>
    </message>
    <message>
        <source>Remove corner</source>
        <translation>Fjern hjørne</translation>
    </message>
    <message>
        <source>The outline would cross itself here.</source>
        <translation>Omrisset ville krysse seg selv her.</translation>
    </message>
    <message>
        <source>Drag to change the wind from now on. In flight this cannot be undone.</source>
        <translation>Dra for å endre vinden fra nå av. Under flyging kan dette ikke angres.</translation>
    </message>
    <message>
        <source>Drag to set the wind. The arrow points downwind.</source>
        <translation>Dra for å sette vinden. Pilen peker dit vinden blåser.</translation>
    </message>
</context>
<context>
    <name>IcebergClipboard</name>
    <message>
        <source>The clipboard</source>
        <translation>Utklippstavlen</translation>
    </message>
</context>
<context>
    <name>IcebergColumnText</name>
    <message>
        <source>Iceberg</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>Name of the iceberg, or its id if it has none</source>
        <translation>Navnet på isfjellet, eller id-en hvis det ikke har noe navn</translation>
    </message>
    <message>
        <source>Uncertainty of the position now; the bar is on the scale of the map</source>
        <translation>Usikkerheten i posisjonen nå; søylen følger skalaen på kartet</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Tilstand</translation>
    </message>
    <message>
        <source>In view, next target, or its place in the visiting order</source>
        <translation>I syne, neste mål, eller plassen i besøksrekkefølgen</translation>
    </message>
    <message>
        <source>Unseen for</source>
        <translation>Usett i</translation>
    </message>
    <message>
        <source>Unseen for, s</source>
        <translation>Usett i, s</translation>
    </message>
    <message>
        <source>Time since it was last in view, or since it became known</source>
        <translation>Tiden siden det sist var i syne, eller siden det ble kjent</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Ankomst</translation>
    </message>
    <message>
        <source>Arrival in, s</source>
        <translation>Ankomst om, s</translation>
    </message>
    <message>
        <source>Time until the UAV arrives, by the present plan</source>
        <translation>Tiden til UAV-en er fremme, etter den nåværende planen</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besøk</translation>
    </message>
    <message>
        <source>Number of times it was reached as the target</source>
        <translation>Antall ganger det ble nådd som mål</translation>
    </message>
    <message>
        <source>Position east of the scenario&apos;s origin: before take-off at the start, in flight the estimate</source>
        <translation>Posisjon øst for scenarioets origo: før avgang ved starten, under flygingen estimatet</translation>
    </message>
    <message>
        <source>Position north of the scenario&apos;s origin: before take-off at the start, in flight the estimate</source>
        <translation>Posisjon nord for scenarioets origo: før avgang ved starten, under flygingen estimatet</translation>
    </message>
    <message>
        <source>Known drift; in flight it includes the current</source>
        <translation>Kjent drift; under flygingen er strømmen med</translation>
    </message>
    <message>
        <source>Direction, °</source>
        <translation>Retning, °</translation>
    </message>
    <message>
        <source>Drift direction, degrees clockwise from north</source>
        <translation>Retningen på driften, i grader med klokken fra nord</translation>
    </message>
    <message>
        <source>Last seen, s ago</source>
        <translation>Sist sett, s siden</translation>
    </message>
    <message>
        <source>Appears at, s</source>
        <translation>Dukker opp, s</translation>
    </message>
    <message>
        <source>East, %1</source>
        <translation>Øst, %1</translation>
    </message>
    <message>
        <source>North, %1</source>
        <translation>Nord, %1</translation>
    </message>
    <message>
        <source>Speed, %1</source>
        <translation>Fart, %1</translation>
    </message>
    <message>
        <source>CPA, %1</source>
        <translation>CPA, %1</translation>
    </message>
    <message>
        <source>Closest point of approach: smallest predicted distance from the asset within the next hour. A warning sign beside the name means that the iceberg will enter the inner ring</source>
        <translation>Nærmeste passering: minste forutsagte avstand fra objektet den neste timen. Et varseltegn ved navnet betyr at isfjellet kommer inn i den indre ringen</translation>
    </message>
    <message>
        <source>TCPA</source>
        <translation>TCPA</translation>
    </message>
    <message>
        <source>TCPA, s</source>
        <translation>TCPA, s</translation>
    </message>
    <message>
        <source>Time to the closest point of approach</source>
        <translation>Tid til nærmeste passering</translation>
    </message>
    <message>
        <source>UAV that plans to visit it</source>
        <translation>UAV-en som planlegger å besøke det</translation>
    </message>
    <message>
        <source>Position, in flight the estimate. Type or paste any form; a whole coordinate sets both</source>
        <translation>Posisjon, under flyging estimatet. Skriv eller lim inn en hvilken som helst form; en hel koordinat setter begge</translation>
    </message>
    <message>
        <source>Drift east, %1</source>
        <translation>Drift øst, %1</translation>
    </message>
    <message>
        <source>Known drift to the east, without the current</source>
        <translation>Kjent drift mot øst, uten strømmen</translation>
    </message>
    <message>
        <source>Drift north, %1</source>
        <translation>Drift nord, %1</translation>
    </message>
    <message>
        <source>Known drift to the north, without the current</source>
        <translation>Kjent drift mot nord, uten strømmen</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Lengde</translation>
    </message>
    <message>
        <source>95 % radius, m</source>
        <translation>95 %-radius, m</translation>
    </message>
    <message>
        <source>Radius around the present position that contains the iceberg with a probability of 95 %</source>
        <translation>Radius rundt den nåværende posisjonen som inneholder isfjellet med 95 % sannsynlighet</translation>
    </message>
</context>
<context>
    <name>IcebergPasteText</name>
    <message>
        <source>There is no text to paste.</source>
        <translation>Det er ingen tekst å lime inn.</translation>
    </message>
    <message>
        <source>Row %1 has a cell &quot;%2&quot; to the right of the last column.</source>
        <translation>Rad %1 har en celle «%2» til høyre for den siste kolonnen.</translation>
    </message>
    <message>
        <source>Row %1, column &quot;%2&quot;: &quot;%3&quot; is not a number.</source>
        <translation>Rad %1, kolonne «%2»: «%3» er ikke et tall.</translation>
    </message>
    <message>
        <source>Row %1, column &quot;%2&quot;: %3 is not from %4 to %5.</source>
        <translation>Rad %1, kolonne «%2»: %3 er ikke fra %4 til %5.</translation>
    </message>
    <message>
        <source>Nothing was pasted.</source>
        <translation>Ingenting ble limt inn.</translation>
    </message>
    <message>
        <source>Row %1, column &quot;%2&quot;, &quot;%3&quot;: %4</source>
        <translation>Rad %1, kolonne «%2», «%3»: %4</translation>
    </message>
    <message>
        <source>Row %1: %2</source>
        <translation>Rad %1: %2</translation>
    </message>
    <message>
        <source>Row %1: %2</source>
        <comment>row, fault</comment>
        <translation>Rad %1: %2</translation>
    </message>
</context>
<context>
    <name>IcebergRowText</name>
    <message>
        <source>in view</source>
        <translation>i syne</translation>
    </message>
    <message>
        <source>target</source>
        <translation>mål</translation>
    </message>
    <message>
        <source>number %1 in the order</source>
        <translation>nummer %1 i rekkefølgen</translation>
    </message>
    <message>
        <source>not in the order</source>
        <translation>ikke i rekkefølgen</translation>
    </message>
    <message>
        <source>not appeared yet</source>
        <translation>ikke der ennå</translation>
    </message>
    <message>
        <source>%1 (id %2)</source>
        <translation>%1 (id-en er %2)</translation>
    </message>
    <message>
        <source>Appears at %1</source>
        <translation>Dukker opp %1</translation>
    </message>
    <message>
        <source>It does not drift.</source>
        <translation>Det står stille.</translation>
    </message>
    <message>
        <source>now</source>
        <translation>nå</translation>
    </message>
    <message>
        <source>&gt; 1 h</source>
        <translation>&gt; 1 t</translation>
    </message>
    <message>
        <source>lost, being searched for</source>
        <translation>tapt, letes etter</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>tapt</translation>
    </message>
    <message>
        <source>search abandoned</source>
        <translation>oppgitt</translation>
    </message>
    <message>
        <source>It is still approaching after one hour; this is its distance then.</source>
        <translation>Det nærmer seg fortsatt om en time; dette er avstanden da.</translation>
    </message>
    <message>
        <source>target of %1</source>
        <translation>mål for %1</translation>
    </message>
    <message>
        <source>number %1 of %2</source>
        <translation>nummer %1 for %2</translation>
    </message>
    <message>
        <source>left or removed</source>
        <translation>borte eller fjernet</translation>
    </message>
    <message>
        <source>%1, a standard deviation of %2 m along each axis</source>
        <translation>%1, et standardavvik på %2 m langs hver akse</translation>
    </message>
</context>
<context>
    <name>ImportCells</name>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultat</translation>
    </message>
    <message>
        <source>Sightings</source>
        <translation>Observasjoner</translation>
    </message>
    <message>
        <source>Last seen, UTC</source>
        <translation>Sist sett, UTC</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alder</translation>
    </message>
    <message>
        <source>Speed, m/s</source>
        <translation>Fart, m/s</translation>
    </message>
    <message>
        <source>Direction, °</source>
        <translation>Retning, °</translation>
    </message>
    <message>
        <source>σ, m²</source>
        <translation>σ, m²</translation>
    </message>
    <message>
        <source>q, m²/s</source>
        <translation>q, m²/s</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Merknader</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linje</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grunn</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopier</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Packet</source>
        <translation>Pakke</translation>
    </message>
    <message>
        <source>Velocity from</source>
        <translation>Hastighet fra</translation>
    </message>
</context>
<context>
    <name>ImportWords</name>
    <message>
        <source>new</source>
        <translation>nytt</translation>
    </message>
    <message>
        <source>updated</source>
        <translation>oppdatert</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>uendret</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>utelatt</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Dato</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Lengde</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Fart</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Retning</translation>
    </message>
    <message>
        <source>Uncertainty σ</source>
        <translation>Usikkerhet σ</translation>
    </message>
    <message>
        <source>Growth q</source>
        <translation>Vekst q</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Utstrekning</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Halvlengde</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Område</translation>
    </message>
    <message>
        <source>Size class</source>
        <translation>Størrelsesklasse</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkninger</translation>
    </message>
    <message>
        <source>KML (Google Earth)</source>
        <translation>KML (Google Earth)</translation>
    </message>
    <message>
        <source>GeoJSON (QGIS)</source>
        <translation>GeoJSON (QGIS)</translation>
    </message>
    <message>
        <source>International Ice Patrol (CSV)</source>
        <translation>International Ice Patrol (CSV)</translation>
    </message>
    <message>
        <source>US National Ice Center (CSV)</source>
        <translation>US National Ice Center (CSV)</translation>
    </message>
    <message>
        <source>Any table (CSV)</source>
        <translation>Vilkårlig tabell (CSV)</translation>
    </message>
    <message numerus="yes">
        <source>%n new</source>
        <translation>
            <numerusform>%n nytt</numerusform>
            <numerusform>%n nye</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n updated</source>
        <translation>
            <numerusform>%n oppdatert</numerusform>
            <numerusform>%n oppdatert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unchanged</source>
        <translation>
            <numerusform>%n uendret</numerusform>
            <numerusform>%n uendret</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n left out</source>
        <translation>
            <numerusform>%n utelatt</numerusform>
            <numerusform>%n utelatt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings outside the area</source>
        <translation>
            <numerusform>%n observasjon utenfor området</numerusform>
            <numerusform>%n observasjoner utenfor området</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings outside the time</source>
        <translation>
            <numerusform>%n observasjon utenfor tidsrommet</numerusform>
            <numerusform>%n observasjoner utenfor tidsrommet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rows rejected</source>
        <translation>
            <numerusform>%n rad avvist</numerusform>
            <numerusform>%n rader avvist</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing to import</source>
        <translation>Ingenting å importere</translation>
    </message>
    <message>
        <source>%1 d %2 h</source>
        <translation>%1 d %2 t</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 t %2 min</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>MET Norway (GeoJSON)</source>
        <translation>MET Norge (GeoJSON)</translation>
    </message>
    <message>
        <source>Canadian Ice Service (CSV)</source>
        <translation>Canadian Ice Service (CSV)</translation>
    </message>
    <message>
        <source>KMZ (KML, packed)</source>
        <translation>KMZ (KML, pakket)</translation>
    </message>
    <message>
        <source>CZML (Cesium)</source>
        <translation>CZML (Cesium)</translation>
    </message>
    <message>
        <source>GPX (waypoints, routes and tracks)</source>
        <translation>GPX (veipunkter, ruter og spor)</translation>
    </message>
    <message>
        <source>QGroundControl plan</source>
        <translation>QGroundControl-plan</translation>
    </message>
    <message>
        <source>ArduPilot mission (QGC WPL)</source>
        <translation>ArduPilot-oppdrag (QGC WPL)</translation>
    </message>
    <message>
        <source>Line %1: %2 is read month first, which nothing in the file tells. Choose under Dates if the day comes first.</source>
        <translation>Linje %1: %2 leses med måneden først; ingenting i filen avgjør det. Velg under Datoer hvis dagen kommer først.</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Kilde</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>ukjent</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>posisjoner</translation>
    </message>
    <message>
        <source>file</source>
        <translation>fil</translation>
    </message>
    <message>
        <source>both</source>
        <translation>begge</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>source, age</comment>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n rows changed</source>
        <translation>
            <numerusform>%n rad endret</numerusform>
            <numerusform>%n rader endret</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings are more than 1000 km from the origin of this scenario. Import them into a new one, or choose others with Inside.</source>
        <translation>
            <numerusform>%n observasjon er mer enn 1000 km fra origo i dette scenarioet. Importer den til et nytt, eller velg andre med Innenfor.</numerusform>
            <numerusform>%n observasjoner er mer enn 1000 km fra origo i dette scenarioet. Importer dem til et nytt, eller velg andre med Innenfor.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings are more than 1000 km from the origin, which is in their densest group. Choose others with Inside.</source>
        <translation>
            <numerusform>%n observasjon er mer enn 1000 km fra origo, som ligger i den tetteste gruppen. Velg andre med Innenfor.</numerusform>
            <numerusform>%n observasjoner er mer enn 1000 km fra origo, som ligger i den tetteste gruppen av dem. Velg andre med Innenfor.</numerusform>
        </translation>
    </message>
    <message>
        <source>From the file: %1</source>
        <translation>Fra filen: %1</translation>
    </message>
    <message>
        <source>Radar and AIS of a ship (NMEA log)</source>
        <translation>Radar og AIS på et skip (NMEA-logg)</translation>
    </message>
    <message>
        <source>Photograph with GPS (JPEG)</source>
        <translation>Fotografi med GPS (JPEG)</translation>
    </message>
</context>
<context>
    <name>InspectorRows</name>
    <message>
        <source>Change drift</source>
        <translation>Endre drift</translation>
    </message>
    <message>
        <source>Change uncertainty</source>
        <translation>Endre usikkerhet</translation>
    </message>
    <message>
        <source>standard deviation %1 m</source>
        <translation>standardavvik %1 m</translation>
    </message>
    <message>
        <source> s ago</source>
        <comment>unit after a number</comment>
        <translation> s siden</translation>
    </message>
    <message>
        <source>Change name</source>
        <translation>Endre navn</translation>
    </message>
    <message>
        <source>Change position</source>
        <translation>Endre posisjon</translation>
    </message>
    <message>
        <source>stationary</source>
        <translation>står stille</translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation>Endre vind</translation>
    </message>
    <message>
        <source>no wind</source>
        <translation>vindstille</translation>
    </message>
    <message>
        <source>Change current</source>
        <translation>Endre strøm</translation>
    </message>
    <message>
        <source>Change velocity of the asset</source>
        <translation>Endre objektets hastighet</translation>
    </message>
    <message>
        <source>Removes the asset from the map.</source>
        <translation>Fjerner objektet fra kartet.</translation>
    </message>
    <message>
        <source>Remove asset</source>
        <translation>Fjern objektet</translation>
    </message>
    <message>
        <source>Removes the area from the map.</source>
        <translation>Fjerner området fra kartet.</translation>
    </message>
    <message>
        <source>Remove area</source>
        <translation>Fjern området</translation>
    </message>
    <message>
        <source>turns with the UAV</source>
        <translation>dreier med UAV-en</translation>
    </message>
    <message>
        <source>aligned with north</source>
        <translation>langs nord</translation>
    </message>
    <message>
        <source>a disk</source>
        <translation>en sirkelskive</translation>
    </message>
    <message>
        <source>by position</source>
        <translation>etter plass</translation>
    </message>
    <message>
        <source>as printed</source>
        <translation>som trykt</translation>
    </message>
    <message>
        <source>reduced</source>
        <translation>redusert</translation>
    </message>
    <message>
        <source>Change origin</source>
        <translation>Endre origo</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Lengde</translation>
    </message>
    <message>
        <source>relative times</source>
        <translation>relative tider</translation>
    </message>
    <message numerus="yes">
        <source>%n corners, %1</source>
        <translation>
            <numerusform>%n hjørne, %1</numerusform>
            <numerusform>%n hjørner, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Recorded track</source>
        <translation>Registrert spor</translation>
    </message>
    <message>
        <source>Its true motion follows this record, while the estimate follows the drift above.</source>
        <translation>Den sanne bevegelsen følger dette sporet, mens estimatet følger driften ovenfor.</translation>
    </message>
    <message>
        <source>Clear recorded track</source>
        <translation>Fjern registrert spor</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Fjern</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n punkt</numerusform>
            <numerusform>%n punkter</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 towards %2°</source>
        <translation>%1 mot %2°</translation>
    </message>
    <message>
        <source>Change home</source>
        <translation>Endre hjem</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Hjem</translation>
    </message>
    <message>
        <source>Landing place other than the start.</source>
        <translation>Annet landingssted enn starten.</translation>
    </message>
    <message>
        <source>Land where it starts</source>
        <translation>Land der den starter</translation>
    </message>
    <message>
        <source>%1 from the start</source>
        <translation>%1 fra starten</translation>
    </message>
    <message>
        <source>Observer</source>
        <translation>Observatør</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>eksakt</translation>
    </message>
    <message>
        <source>Kalman filter</source>
        <translation>Kalman-filter</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>expanding square</source>
        <translation>voksende kvadrat</translation>
    </message>
    <message>
        <source>sectors</source>
        <translation>sektorer</translation>
    </message>
    <message>
        <source>any UAV</source>
        <translation>hvilken som helst</translation>
    </message>
    <message>
        <source>Move ground station</source>
        <translation>Flytt bakkestasjonen</translation>
    </message>
    <message>
        <source>Ground station</source>
        <translation>Bakkestasjon</translation>
    </message>
    <message>
        <source>Position of the radio link to the UAVs. Its range is a ring on the map.</source>
        <translation>Posisjonen til radiosambandet med UAV-ene. Rekkevidden er en ring på kartet.</translation>
    </message>
    <message>
        <source>Change ground station</source>
        <translation>Endre bakkestasjonen</translation>
    </message>
    <message>
        <source>do not fly</source>
        <translation>fly ikke</translation>
    </message>
    <message>
        <source>flying allowed</source>
        <translation>flyging tillatt</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Omriss</translation>
    </message>
    <message>
        <source>Removes the no-fly area from the map.</source>
        <translation>Fjerner flyforbudsområdet fra kartet.</translation>
    </message>
    <message>
        <source>Remove no-fly area</source>
        <translation>Fjern flyforbudsområdet</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>No-fly area: %1</source>
        <translation>Flyforbudsområde: %1</translation>
    </message>
    <message>
        <source>No-fly area %1: %2</source>
        <translation>Flyforbudsområde %1: %2</translation>
    </message>
    <message>
        <source>Separate altitudes</source>
        <translation>Skill høydene</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Fart</translation>
    </message>
    <message>
        <source>Speed of a ship; 0 for a platform.</source>
        <translation>Fart for et skip; 0 for en plattform.</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Course over ground, clockwise from north.</source>
        <translation>Kurs over grunnen, med klokken fra nord.</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>Known drift, without the current.</source>
        <translation>Kjent drift, uten strømmen.</translation>
    </message>
    <message>
        <source>Drift towards</source>
        <translation>Driver mot</translation>
    </message>
    <message>
        <source>Drift direction, clockwise from north.</source>
        <translation>Retningen på driften, med klokken fra nord.</translation>
    </message>
    <message>
        <source>Any form; a whole coordinate sets both.</source>
        <translation>Enhver form; en hel koordinat setter begge.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vind</translation>
    </message>
    <message>
        <source>Must be below the UAV&apos;s airspeed.</source>
        <translation>Må være lavere enn UAV-ens flyfart.</translation>
    </message>
    <message>
        <source>Wind from</source>
        <translation>Vind fra</translation>
    </message>
    <message>
        <source>Direction the wind blows from, clockwise from north.</source>
        <translation>Retningen vinden blåser fra, med klokken fra nord.</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1 fra %2</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strøm</translation>
    </message>
    <message>
        <source>Carries every iceberg.</source>
        <translation>Fører med seg alle isfjell.</translation>
    </message>
    <message>
        <source>Current towards</source>
        <translation>Strøm mot</translation>
    </message>
    <message>
        <source>Direction the current flows to, clockwise from north.</source>
        <translation>Retningen strømmen går mot, med klokken fra nord.</translation>
    </message>
    <message>
        <source>Change operation</source>
        <translation>Endre operasjonen</translation>
    </message>
    <message>
        <source>Operation volume</source>
        <translation>Operasjonsvolum</translation>
    </message>
    <message>
        <source>Proposed volume for a permit application; check it with your authority. Shown on the map, in KML and GeoJSON, and on a second page of the flight brief.</source>
        <translation>Foreslått volum for en søknad om tillatelse; avklar det med myndigheten. Vises på kartet, i KML og GeoJSON, og på en andre side av flygearket.</translation>
    </message>
    <message>
        <source>Contingency volume %1 wide, %2 high
Ground-risk buffer %3
Adjacent area %4</source>
        <translation>Beredskapsvolum %1 bredt, %2 høyt
Bakkerisikobuffer %3
Tilstøtende område %4</translation>
    </message>
    <message>
        <source>Airspace %1: %2</source>
        <translation>Luftrom %1: %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>og %1 til</translation>
    </message>
    <message>
        <source>Makes airspace that the operation may enter no-fly areas, so that the UAVs stay out of it.</source>
        <translation>Gjør luftrom som operasjonen kan komme inn i, til flyforbudsområder, slik at UAV-ene holder seg utenfor.</translation>
    </message>
    <message>
        <source>Make entered airspace no-fly areas</source>
        <translation>Gjør berørt luftrom til flyforbudsområder</translation>
    </message>
    <message>
        <source>Removes all airspace. Undo restores it.</source>
        <translation>Fjerner alt luftrom. Angre henter det tilbake.</translation>
    </message>
    <message>
        <source>Remove airspace</source>
        <translation>Fjern luftrom</translation>
    </message>
    <message>
        <source>Position and course</source>
        <translation>Posisjon og kurs</translation>
    </message>
    <message>
        <source>Protection</source>
        <translation>Beskyttelse</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posisjon</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Usikkerhet</translation>
    </message>
    <message>
        <source>Size and visits</source>
        <translation>Størrelse og besøk</translation>
    </message>
    <message>
        <source>Time and place</source>
        <translation>Tid og sted</translation>
    </message>
    <message>
        <source>Wind, weather and current</source>
        <translation>Vind, vær og strøm</translation>
    </message>
    <message>
        <source>Flight rules</source>
        <translation>Flyregler</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Planlegger</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulering</translation>
    </message>
    <message>
        <source>Position and heading</source>
        <translation>Posisjon og kurs</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Fly</translation>
    </message>
    <message>
        <source>Endurance and home</source>
        <translation>Utholdenhet og hjem</translation>
    </message>
    <message>
        <source>Weather limits</source>
        <translation>Værgrenser</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % innenfor</translation>
    </message>
    <message>
        <source>When last seen, the iceberg was within this radius with a probability of 95 %: the square root of 5.99 σ₀.</source>
        <translation>Da isfjellet sist ble sett, var det innenfor denne radien med 95 % sannsynlighet: kvadratroten av 5,99 σ₀.</translation>
    </message>
    <message>
        <source>Seen by</source>
        <translation>Sett med</translation>
    </message>
    <message>
        <source>Sets the usual uncertainty of this source, also for icebergs placed later.</source>
        <translation>Setter den vanlige usikkerheten for denne kilden, også for isfjell som plasseres senere.</translation>
    </message>
    <message>
        <source>as typed</source>
        <translation>som skrevet</translation>
    </message>
    <message>
        <source>Raises UAVs until their altitudes are %1 apart, so that none has to wait for another.</source>
        <translation>Hever UAV-er til høydene er %1 fra hverandre, slik at ingen må vente på en annen.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Endre %1</translation>
    </message>
    <message>
        <source>ArduPilot, fixed wing</source>
        <translation>ArduPilot, fastvinget fly</translation>
    </message>
    <message>
        <source>ArduPilot, flying wing launched by hand</source>
        <translation>ArduPilot, flygende vinge kastet for hånd</translation>
    </message>
    <message>
        <source>ArduPilot, VTOL</source>
        <translation>ArduPilot, VTOL-fly</translation>
    </message>
    <message>
        <source>ArduPilot, multirotor</source>
        <translation>ArduPilot, multirotordrone</translation>
    </message>
    <message>
        <source>PX4, fixed wing</source>
        <translation>PX4, fastvinget fly</translation>
    </message>
    <message>
        <source>PX4, VTOL</source>
        <translation>PX4, VTOL-fly</translation>
    </message>
    <message>
        <source>PX4, multirotor</source>
        <translation>PX4, multirotordrone</translation>
    </message>
    <message>
        <source>as set below</source>
        <translation>som angitt nedenfor</translation>
    </message>
    <message>
        <source>Aircraft profile</source>
        <translation>Flyprofil</translation>
    </message>
    <message>
        <source>Sets all values of this group at once.</source>
        <translation>Setter alle verdiene i denne gruppen på én gang.</translation>
    </message>
    <message>
        <source>Choose aircraft profile</source>
        <translation>Velg flyprofil</translation>
    </message>
    <message>
        <source>by mission item</source>
        <translation>med et oppdragselement</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>for hånd</translation>
    </message>
    <message>
        <source>return to launch</source>
        <translation>fly hjem</translation>
    </message>
    <message>
        <source>landing pattern</source>
        <translation>landingsrunde</translation>
    </message>
    <message>
        <source>loiter and wait</source>
        <translation>vent i sirkel</translation>
    </message>
    <message>
        <source>not in the mission</source>
        <translation>ikke i oppdraget</translation>
    </message>
    <message>
        <source>by distance</source>
        <translation>etter avstand</translation>
    </message>
    <message>
        <source>by time</source>
        <translation>etter tid</translation>
    </message>
    <message>
        <source>fixed wing</source>
        <translation>fastvinget fly</translation>
    </message>
    <message>
        <source>VTOL</source>
        <translation>VTOL-fly</translation>
    </message>
    <message>
        <source>multirotor</source>
        <translation>multirotordrone</translation>
    </message>
    <message>
        <source>Autopilot mission</source>
        <translation>Oppdrag for autopiloten</translation>
    </message>
    <message>
        <source>Forecast</source>
        <translation>Varsel</translation>
    </message>
    <message>
        <source>Where and when it gives a quantity, it replaces the constant one below.</source>
        <translation>Der og når det gir en størrelse, erstatter det den faste nedenfor.</translation>
    </message>
    <message>
        <source>Remove forecast</source>
        <translation>Fjern varsel</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>tomt</translation>
    </message>
    <message>
        <source>%1; replaces %2</source>
        <comment>time of issue, quantities</comment>
        <translation>%1; erstatter %2</translation>
    </message>
    <message>
        <source>%1; not used before the start (UTC) is set, then it replaces %2</source>
        <comment>time of issue, quantities</comment>
        <translation>%1; brukes først når starten (UTC) er satt, og erstatter da %2</translation>
    </message>
    <message>
        <source>%1 h: %2 (1 σ: %3)</source>
        <comment>time, error, deviation</comment>
        <translation>%1 t: %2 (1 σ: %3)</translation>
    </message>
    <message>
        <source>Error of the predicted drift</source>
        <translation>Feil i den forventede driften</translation>
    </message>
</context>
<context>
    <name>InterventionText</name>
    <message>
        <source>Change policy</source>
        <translation>Endre strategi</translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation>Endre vind</translation>
    </message>
    <message>
        <source>Move asset</source>
        <translation>Flytt objektet</translation>
    </message>
    <message>
        <source>Add iceberg</source>
        <translation>Legg til isfjell</translation>
    </message>
    <message>
        <source>Report sighting</source>
        <translation>Meld observasjon</translation>
    </message>
    <message>
        <source>Remove icebergs</source>
        <translation>Fjern isfjell</translation>
    </message>
    <message>
        <source>Assign iceberg</source>
        <translation>Tildel isfjell</translation>
    </message>
    <message>
        <source>Order UAV</source>
        <translation>Gi UAV-en ordre</translation>
    </message>
    <message>
        <source>Change trade-off</source>
        <translation>Endre avveining</translation>
    </message>
    <message>
        <source>The scenario is locked in flight. Stop the flight to change it.</source>
        <translation>Scenarioet er låst under flyging. Stopp flygingen for å endre det.</translation>
    </message>
    <message>
        <source>Move home</source>
        <translation>Flytt hjem</translation>
    </message>
</context>
<context>
    <name>IssueText</name>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n feil</numerusform>
            <numerusform>%n feil</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n advarsel</numerusform>
            <numerusform>%n advarsler</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hints</source>
        <translation>
            <numerusform>%n tips</numerusform>
            <numerusform>%n tips</numerusform>
        </translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>linje %1, kolonne %2: dette er ikke gyldig JSON</translation>
    </message>
    <message>
        <source>line %1, column %2: %3: a number too large for this program</source>
        <translation>linje %1, kolonne %2: %3: et tall som er for stort for dette programmet</translation>
    </message>
    <message>
        <source>nested deeper than %1 levels</source>
        <translation>er nøstet dypere enn %1 nivåer</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>linje %1: dette er ikke gyldig XML</translation>
    </message>
    <message>
        <source>is no %1 file: must be %2, not %3</source>
        <translation>er ingen fil av typen %1: må være %2, ikke %3</translation>
    </message>
    <message>
        <source>must be &quot;%1&quot;</source>
        <translation>må være «%1»</translation>
    </message>
    <message>
        <source>must be &quot;%1&quot;, not &quot;%2&quot;</source>
        <translation>må være «%1», ikke «%2»</translation>
    </message>
    <message>
        <source>%1 is not known: this program reads %2</source>
        <translation>%1 er ukjent: dette programmet leser %2</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>mangler</translation>
    </message>
    <message>
        <source>is missing, and so is %1</source>
        <translation>mangler, og det gjør %1 også</translation>
    </message>
    <message>
        <source>must not be given beside %1</source>
        <translation>kan ikke oppgis sammen med %1</translation>
    </message>
    <message>
        <source>appears more than once</source>
        <translation>står der mer enn én gang</translation>
    </message>
    <message>
        <source>must be %1, not %2</source>
        <translation>må være %1, ikke %2</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>må være en av %1</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2, not %3</source>
        <translation>må være et heltall fra %1 til %2, ikke %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number</source>
        <translation>«%1» er ikke et tall</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number: decimals follow a point</source>
        <translation>«%1» er ikke et tall: desimaler skrives etter punktum</translation>
    </message>
    <message>
        <source>must be a finite number of at least 0</source>
        <translation>må være et endelig tall på minst 0</translation>
    </message>
    <message>
        <source>must not be below %1</source>
        <translation>kan ikke være under %1</translation>
    </message>
    <message>
        <source>must not be before %1</source>
        <translation>kan ikke være før %1</translation>
    </message>
    <message>
        <source>must rise from entry to entry</source>
        <translation>må øke fra verdi til verdi</translation>
    </message>
    <message>
        <source>must hold %1 entries, not %2</source>
        <translation>må ha %1 verdier, ikke %2</translation>
    </message>
    <message>
        <source>must hold from %1 to %2 entries, not %3</source>
        <translation>må ha fra %1 til %2 verdier, ikke %3</translation>
    </message>
    <message>
        <source>must hold at least %1 entries</source>
        <translation>må ha minst %1 verdier</translation>
    </message>
    <message>
        <source>must hold at most %1 entries, not %2</source>
        <translation>kan ha høyst %1 verdier, ikke %2</translation>
    </message>
    <message>
        <source>must not repeat an iceberg</source>
        <translation>kan ikke gjenta et isfjell</translation>
    </message>
    <message>
        <source>no iceberg &quot;%1&quot; is there at this time</source>
        <translation>det finnes ikke noe isfjell «%1» på dette tidspunktet</translation>
    </message>
    <message>
        <source>with these, the run must hold at most %1 icebergs, not %2</source>
        <translation>med disse kan flygingen ha høyst %1 isfjell, ikke %2</translation>
    </message>
    <message>
        <source>is the UAV&apos;s and must be 0</source>
        <translation>er UAV-ens og må være 0</translation>
    </message>
    <message>
        <source>must be a square matrix with one row and column per sigma</source>
        <translation>må være en kvadratisk matrise med én rad og én kolonne for hver sigma</translation>
    </message>
    <message>
        <source>must be empty or hold one entry per UAV and sigma</source>
        <translation>må være tom eller ha én verdi for hver UAV og sigma</translation>
    </message>
    <message>
        <source>must be true for one UAV at least</source>
        <translation>må være true for minst én UAV</translation>
    </message>
    <message>
        <source>is too large: the cost of a plan may exceed %1</source>
        <translation>er for stor: kostnaden av en plan kan overstige %1</translation>
    </message>
    <message>
        <source>is too small: a cost that is not 0 is less than %1</source>
        <translation>er for liten: en kostnad som ikke er 0, er under %1</translation>
    </message>
    <message>
        <source>must not be empty when random is 0</source>
        <translation>kan ikke være tom når random er 0</translation>
    </message>
    <message>
        <source>must name a policy; visitation needs taus</source>
        <translation>må oppgi en strategi; visitation trenger verdier av τ</translation>
    </message>
    <message>
        <source>must be I of N with 1 &lt;= I &lt;= N</source>
        <translation>må være I av N med 1 &lt;= I &lt;= N</translation>
    </message>
    <message>
        <source>differs: parts of one study are wanted</source>
        <translation>avviker: her trengs deler av samme studie</translation>
    </message>
    <message>
        <source>setting %1 of case %2 has two different outcomes: the parts were not flown by the same program</source>
        <translation>innstilling %1 av tilfelle %2 har to ulike utfall: delene ble ikke fløyet av samme program</translation>
    </message>
    <message>
        <source>no study is kept in this page</source>
        <translation>denne siden inneholder ingen studie</translation>
    </message>
    <message>
        <source>would become larger than %1 MiB: take fewer scenarios, or several studies</source>
        <translation>ville bli større enn %1 MiB: bruk færre scenarioer, eller flere studier</translation>
    </message>
    <message>
        <source>recorded %1, replayed %2</source>
        <translation>registrert %1, avspilt %2</translation>
    </message>
    <message>
        <source>at %1 s: recorded %2, replayed %3</source>
        <translation>ved %1 s: registrert %2, avspilt %3</translation>
    </message>
    <message>
        <source>at %1 s: the replay has another</source>
        <translation>ved %1 s: avspillingen har en annen</translation>
    </message>
    <message>
        <source>at %1 s: not reached by the replay</source>
        <translation>ved %1 s: nås ikke i avspillingen</translation>
    </message>
    <message>
        <source>solves were cut by the clock, so this run is not bound to repeat</source>
        <translation>klokken avbrøt løsninger, så denne flygingen gjentar seg ikke nødvendigvis</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>kan ikke åpnes: %1</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kan ikke leses: %1</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>kan ikke skrives: %1</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>kan ikke lages</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>er skadet</translation>
    </message>
    <message>
        <source>is of another version</source>
        <translation>er av en annen versjon</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>er ikke en vanlig fil</translation>
    </message>
    <message>
        <source>is larger than %1 MiB</source>
        <translation>er større enn %1 MiB</translation>
    </message>
    <message>
        <source>is larger than %1 MiB; %2 in the environment doubles the limits of reading</source>
        <translation>er større enn %1 MiB; %2 i miljøvariablene dobler grensene for lesing</translation>
    </message>
    <message>
        <source>holds more than %1 values; %2 in the environment doubles the limits of reading</source>
        <translation>har mer enn %1 verdier; %2 i miljøvariablene dobler grensene for lesing</translation>
    </message>
    <message>
        <source>holds more than %1 rows or features; %2 in the environment doubles the limits of reading</source>
        <translation>har mer enn %1 rader eller objekter; %2 i miljøvariablene dobler grensene for lesing</translation>
    </message>
    <message>
        <source>would take more than %1 MB of memory, the limit for a file of its size: split it, or leave out what is empty; %2 in the environment doubles the limits of reading</source>
        <translation>ville ta mer enn %1 MB minne, grensen for en fil av denne størrelsen: del den opp, eller utelat det som er tomt; %2 i miljøvariablene dobler grensene for lesing</translation>
    </message>
    <message>
        <source>there are more than %1 icebergs to choose from: narrow the area or the time; %2 in the environment doubles the limits of reading</source>
        <translation>det er flere enn %1 isfjell å velge blant: begrens området eller tiden; %2 i miljøvariablene dobler grensene for lesing</translation>
    </message>
    <message>
        <source>is an archive that cannot be read: it is cut off or damaged</source>
        <translation>er et arkiv som ikke kan leses: det er avkuttet eller skadet</translation>
    </message>
    <message>
        <source>is a compressed archive (such as XLSX) without a file *%1</source>
        <translation>er et komprimert arkiv (slik som XLSX) uten en fil *%1</translation>
    </message>
    <message>
        <source>is an archive whose entry *%1 cannot be unpacked</source>
        <translation>er et arkiv der filen *%1 ikke kan pakkes ut</translation>
    </message>
    <message>
        <source>is an archive in an archive</source>
        <translation>er et arkiv i et arkiv</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>er tom</translation>
    </message>
    <message>
        <source>is UTF-16 text; save it as UTF-8</source>
        <translation>er UTF-16-tekst; lagre den som UTF-8</translation>
    </message>
    <message>
        <source>is no text file</source>
        <translation>er ingen tekstfil</translation>
    </message>
    <message>
        <source>no import format &quot;%1&quot;; there are %2</source>
        <translation>det finnes ikke noe importformat «%1»; det finnes %2</translation>
    </message>
    <message>
        <source>columns of the format %1 cannot be mapped</source>
        <translation>kolonnene i formatet %1 kan ikke tilordnes</translation>
    </message>
    <message>
        <source>holds no sightings</source>
        <translation>inneholder ingen observasjoner</translation>
    </message>
    <message>
        <source>there is no column &quot;%1&quot;</source>
        <translation>det er ingen kolonne «%1»</translation>
    </message>
    <message>
        <source>no column holds it; name one with a mapping</source>
        <translation>ingen kolonne inneholder det; tilordne en</translation>
    </message>
    <message>
        <source>columns %1 and %2 are both called &quot;%3&quot;: rename one</source>
        <translation>kolonnene %1 og %2 heter begge «%3»: gi den ene et annet navn</translation>
    </message>
    <message>
        <source>the first line must name from 1 to %1 columns</source>
        <translation>den første linjen må navngi fra 1 til %1 kolonner</translation>
    </message>
    <message>
        <source>has %2 columns and not %1</source>
        <translation>har %2 kolonner og ikke %1</translation>
    </message>
    <message>
        <source>%1 would then be more than 1000 km east, west, north or south of the origin</source>
        <translation>%1 ville da være mer enn 1000 km øst, vest, nord eller sør for origo</translation>
    </message>
    <message>
        <source>cannot move while the scenario holds icebergs, an asset or an area</source>
        <translation>kan ikke flyttes mens scenarioet har isfjell, et objekt eller et område</translation>
    </message>
    <message>
        <source>this is not a place on the Earth</source>
        <translation>dette er ikke et sted på jorden</translation>
    </message>
    <message>
        <source>has another number of columns than the first line</source>
        <translation>har et annet antall kolonner enn den første linjen</translation>
    </message>
    <message>
        <source>a quote is opened and never closed</source>
        <translation>et anførselstegn åpnes og lukkes aldri</translation>
    </message>
    <message>
        <source>text follows a closing quote</source>
        <translation>det står tekst etter et avsluttende anførselstegn</translation>
    </message>
    <message>
        <source>has no time</source>
        <translation>har ikke noe tidspunkt</translation>
    </message>
    <message>
        <source>time cannot be read</source>
        <translation>tidspunktet kan ikke leses</translation>
    </message>
    <message>
        <source>date is not in the season</source>
        <translation>datoen er ikke i sesongen</translation>
    </message>
    <message>
        <source>has no position</source>
        <translation>har ingen posisjon</translation>
    </message>
    <message>
        <source>a number is out of range</source>
        <translation>et tall er utenfor grensene</translation>
    </message>
    <message>
        <source>id is too long</source>
        <translation>id-en er for lang</translation>
    </message>
    <message>
        <source>is no point</source>
        <translation>er ikke et punkt</translation>
    </message>
    <message>
        <source>is more than 1000 km east, west, north or south of the origin</source>
        <translation>er mer enn 1000 km øst, vest, nord eller sør for origo</translation>
    </message>
    <message>
        <source>there is no room for more</source>
        <translation>det er ikke plass til flere</translation>
    </message>
    <message>
        <source>must lie within %1 m</source>
        <translation>må ligge innenfor %1 m</translation>
    </message>
    <message>
        <source>only %1 of %2 icebergs found a place: the area is too thin</source>
        <translation>bare %1 av %2 isfjell fikk plass: området er for smalt</translation>
    </message>
    <message>
        <source>a scenario has no such file: nothing was flown</source>
        <translation>et scenario har ingen slik fil: ingenting er fløyet</translation>
    </message>
    <message>
        <source>must be above the speed of the wind</source>
        <translation>må være høyere enn vindhastigheten</translation>
    </message>
    <message>
        <source>there is no UAV %1</source>
        <translation>det finnes ingen UAV %1</translation>
    </message>
    <message>
        <source>%1 holds one UAV: choose one</source>
        <translation>%1 har plass til én UAV: velg én</translation>
    </message>
    <message>
        <source>%1 is painted, which needs the program bergwatch</source>
        <translation>%1 tegnes, og det krever programmet bergwatch</translation>
    </message>
    <message>
        <source>cannot be exported: at %1 s of the flight, later than any date</source>
        <translation>kan ikke eksporteres: ved %1 s av flygingen, senere enn noen dato</translation>
    </message>
    <message>
        <source>cannot be exported: at %1 s it is %2 m from the origin of the map, which holds %3 m</source>
        <translation>kan ikke eksporteres: ved %1 s er det %2 m fra origo i kartet, som har plass til %3 m</translation>
    </message>
    <message>
        <source>cannot be exported: its turns are not finite</source>
        <translation>kan ikke eksporteres: svingene er ikke endelige</translation>
    </message>
    <message>
        <source>the scenario cannot be planned</source>
        <translation>scenarioet kan ikke planlegges</translation>
    </message>
    <message>
        <source>this build was made without COIN-OR CBC</source>
        <translation>dette programmet er bygd uten COIN-OR CBC</translation>
    </message>
    <message>
        <source>the back end cbc cannot plan for the policy latency</source>
        <translation>løseren cbc kan ikke planlegge for strategien latency</translation>
    </message>
    <message>
        <source>%1 is not flown by this version</source>
        <translation>%1 flys ikke av denne versjonen</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>et objekt</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>en liste</translation>
    </message>
    <message>
        <source>a string</source>
        <translation>en tekst</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>et tall</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true eller false</translation>
    </message>
    <message>
        <source>two numbers</source>
        <translation>to tall</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>par av tall</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>linje %1</translation>
    </message>
    <message>
        <source>no such file or folder</source>
        <translation>filen eller mappen finnes ikke</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>ingen tillatelse</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>det er en mappe</translation>
    </message>
    <message>
        <source>part of the path is no folder</source>
        <translation>en del av stien er ingen mappe</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>disken er full</translation>
    </message>
    <message>
        <source>the quota is used up</source>
        <translation>kvoten er brukt opp</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>disken er skrivebeskyttet</translation>
    </message>
    <message>
        <source>the disk is faulty</source>
        <translation>disken har en feil</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>navnet er for langt</translation>
    </message>
    <message>
        <source>the program bergwatch-cbc is not there: %1</source>
        <translation>programmet bergwatch-cbc finnes ikke: %1</translation>
    </message>
    <message>
        <source>must be at least %1 for a run of this length and so many icebergs, not %2; %3 in the environment doubles the limits of reading</source>
        <translation>må være minst %1 for en så lang flyging med så mange isfjell, ikke %2; %3 i miljøvariablene dobler grensene for lesing</translation>
    </message>
    <message>
        <source>with the policies would be %1 settings; at most %2 fit into one study: take several</source>
        <translation>ville med strategiene gi %1 innstillinger; én studie har plass til høyst %2: bruk flere</translation>
    </message>
    <message>
        <source>would be %1 missions; at most %2 fit into one study: take several</source>
        <translation>ville bli %1 oppdrag; én studie har plass til høyst %2: bruk flere</translation>
    </message>
    <message>
        <source>names an iceberg, but the run holds none</source>
        <translation>viser til et isfjell, men flygingen har ingen</translation>
    </message>
    <message>
        <source>airspace left out: a place or an arc cannot be read</source>
        <translation>luftrom utelatt: et sted eller en bue kan ikke leses</translation>
    </message>
    <message>
        <source>is no airspace: not OpenAir, GeoJSON, KML, KMZ or CZML</source>
        <translation>er ikke luftrom: ikke OpenAir, GeoJSON, KML, KMZ eller CZML</translation>
    </message>
    <message>
        <source>holds no airspace</source>
        <translation>inneholder ikke luftrom</translation>
    </message>
    <message>
        <source>there is no folder %1</source>
        <translation>mappen %1 finnes ikke</translation>
    </message>
    <message>
        <source>%1 is no folder</source>
        <translation>%1 er ikke en mappe</translation>
    </message>
    <message>
        <source>is no folder</source>
        <translation>er ikke en mappe</translation>
    </message>
    <message>
        <source>cannot be made: %1</source>
        <translation>kan ikke lages: %1</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>kunne ikke skrives</translation>
    </message>
    <message>
        <source>none of its %1 sightings could be taken; nothing written</source>
        <translation>ingen av de %1 observasjonene kunne brukes; ingenting er skrevet</translation>
    </message>
    <message>
        <source>dates such as %1 are read month first, which nothing in the file tells: --dates day-first or month-first says how</source>
        <translation>datoer som %1 leses med måneden først; ingenting i filen avgjør det: --dates day-first eller month-first avgjør det</translation>
    </message>
    <message>
        <source>differs: this is the file of another study (--replace-study replaces it)</source>
        <translation>avviker: dette er filen til en annen studie (--replace-study erstatter den)</translation>
    </message>
    <message>
        <source>was changed by another program: each shard needs a file of its own</source>
        <translation>ble endret av et annet program: hver del trenger en egen fil</translation>
    </message>
    <message>
        <source>this plan solves no problem that could be verified or certified</source>
        <translation>denne planen løser ikke noe problem som kan kontrolleres eller sertifiseres</translation>
    </message>
    <message>
        <source>this build has no MPI (BERGWATCH_WITH_MPI): fly shards with --shard I/N</source>
        <translation>dette programmet er bygd uten MPI (BERGWATCH_WITH_MPI): fly deler med --shard I/N</translation>
    </message>
    <message>
        <source>must be UTF-8 text</source>
        <translation>må være UTF-8-tekst</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>må være et endelig tall</translation>
    </message>
    <message>
        <source>must be from %1 to %2, not %3</source>
        <translation>må være fra %1 til %2, ikke %3</translation>
    </message>
    <message>
        <source>must be above %1 and at most %2, not %3</source>
        <translation>må være over %1 og høyst %2, ikke %3</translation>
    </message>
    <message>
        <source>must be a UTC date and time such as 2024-05-01T06:00:00Z</source>
        <translation>må være en dato og et klokkeslett i UTC, som 2024-05-01T06:00:00Z</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>kan ikke være tom</translation>
    </message>
    <message>
        <source>must have from 2 to %1 entries, not %2</source>
        <translation>må ha fra 2 til %1 verdier, ikke %2</translation>
    </message>
    <message>
        <source>must be later than the entry before</source>
        <translation>må være senere enn verdien før</translation>
    </message>
    <message>
        <source>must be at most %1 where the endurance is limited, not %2</source>
        <translation>må være høyst %1 når utholdenheten er begrenset, ikke %2</translation>
    </message>
    <message>
        <source>must be inside the area, which is a geofence</source>
        <translation>må ligge innenfor området, som er et geogjerde</translation>
    </message>
    <message>
        <source>must be outside the no-fly area &quot;%1&quot;</source>
        <translation>må ligge utenfor flyforbudsområdet «%1»</translation>
    </message>
    <message>
        <source>must be outside the stand-off ring round the asset</source>
        <translation>må ligge utenfor sikkerhetsringen rundt objektet</translation>
    </message>
    <message>
        <source>drifts so fast that the UAV may not catch up with it</source>
        <translation>driver så fort at UAV-en kanskje ikke tar det igjen</translation>
    </message>
    <message>
        <source>with these drifts and a round of %1 minutes, %2 of %3 icebergs will be out of view at the next visit</source>
        <translation>med denne driften og en runde på %1 minutter er %2 av %3 isfjell utenfor synsfeltet ved neste besøk</translation>
    </message>
    <message>
        <source>is too short for the path home from the start</source>
        <translation>er for kort til veien hjem fra starten</translation>
    </message>
    <message>
        <source>is used, without a limited endurance, only when you order a return or export with the return home</source>
        <translation>brukes, uten begrenset utholdenhet, bare når du gir ordre om hjemflyging eller eksporterer med hjemflyging</translation>
    </message>
    <message>
        <source>is so near the geofence or a no-fly area that the UAV cannot take off there again and be sure to come home</source>
        <translation>er så nær geogjerdet eller et flyforbudsområde at UAV-en ikke kan ta av derfra igjen og være sikker på å komme hjem</translation>
    </message>
    <message>
        <source>this policy plans without geofence and no-fly areas; they are kept in flight</source>
        <translation>denne strategien planlegger uten geogjerde og flyforbudsområder; de overholdes under flygingen</translation>
    </message>
    <message>
        <source>the turn radius is larger than half the field of view, so that an iceberg may be missed</source>
        <translation>svingradien er større enn halve synsfeltet, så et isfjell kan bli oversett</translation>
    </message>
    <message>
        <source>is smaller than the turn radius, so that the UAV flies on and comes back</source>
        <translation>er mindre enn svingradien, så UAV-en flyr videre og kommer tilbake</translation>
    </message>
    <message>
        <source>is larger than half the field of view, so that icebergs count as reached that are not seen</source>
        <translation>er større enn halve synsfeltet, så isfjell som ikke er sett, regnes som nådd</translation>
    </message>
    <message>
        <source>lies outside the area</source>
        <translation>ligger utenfor området</translation>
    </message>
    <message>
        <source>drifts out of the area before the end of the run</source>
        <translation>driver ut av området før flygingen er slutt</translation>
    </message>
    <message>
        <source>is over before the UAV can get to the first iceberg</source>
        <translation>er slutt før UAV-en kan nå det første isfjellet</translation>
    </message>
    <message>
        <source>drifts faster than icebergs do: is the unit right?</source>
        <translation>driver fortere enn isfjell gjør: er enheten riktig?</translation>
    </message>
    <message>
        <source>no iceberg is uncertain at the start, so distance alone makes the first plan</source>
        <translation>ingen isfjell er usikre ved start, så avstanden alene avgjør den første planen</translation>
    </message>
    <message>
        <source>proving the optimum of so many icebergs can take a minute and more</source>
        <translation>å bevise optimum for så mange isfjell kan ta et minutt eller mer</translation>
    </message>
    <message>
        <source>the back end %1 proves plans of at most %2 icebergs; auto gives a plan and a bound</source>
        <translation>løseren %1 beviser planer med høyst %2 isfjell; auto gir en plan og en grense</translation>
    </message>
    <message>
        <source>the back end exact proves latency plans of several UAVs for at most %1 icebergs</source>
        <translation>løseren exact beviser latency-planer for flere UAV-er for høyst %1 isfjell</translation>
    </message>
    <message>
        <source>the MILP formulation %1 is offered for at most %2 icebergs, not for %3</source>
        <translation>MILP-formuleringen %1 tilbys for høyst %2 isfjell, ikke for %3</translation>
    </message>
    <message>
        <source>the column &quot;%1&quot; is not understood: rename it, or assign it with a mapping</source>
        <translation>kolonnen «%1» gjenkjennes ikke: gi den et annet navn, eller tilordne den</translation>
    </message>
    <message>
        <source>airspace left out: a height has no unit</source>
        <translation>luftrom utelatt: en høyde har ingen enhet</translation>
    </message>
    <message>
        <source>members that this version does not know are not used: &quot;%1&quot;</source>
        <translation>felt som denne versjonen ikke kjenner, brukes ikke: «%1»</translation>
    </message>
    <message>
        <source>feature %1</source>
        <translation>objekt %1</translation>
    </message>
    <message>
        <source>packet %1</source>
        <translation>pakke %1</translation>
    </message>
    <message>
        <source>takes off in the dark, at %1 UTC: civil twilight begins at %2 UTC</source>
        <translation>tar av i mørket, kl. %1 UTC: borgerlig tussmørke begynner kl. %2 UTC</translation>
    </message>
    <message>
        <source>lands in the dark, at %1 UTC: civil twilight ends at %2 UTC</source>
        <translation>lander i mørket, kl. %1 UTC: borgerlig tussmørke slutter kl. %2 UTC</translation>
    </message>
    <message>
        <source>the time zone &quot;%1&quot; is a name: write offsets from UTC, such as +02:00</source>
        <translation>tidssonen «%1» er et navn: skriv avvik fra UTC, som +02:00</translation>
    </message>
    <message>
        <source>there is nothing on line %1 or below it</source>
        <translation>det står ingenting på linje %1 eller under den</translation>
    </message>
    <message>
        <source>nothing tells which rows are sightings of one iceberg: choose one of these</source>
        <translation>filen sier ikke hvilke rader som er observasjoner av ett isfjell: velg ett av disse</translation>
    </message>
    <message>
        <source>icebergs: %1, greatest speed between two sightings: %2 m/s</source>
        <translation>isfjell: %1, største fart mellom to observasjoner: %2 m/s</translation>
    </message>
    <message>
        <source>is faster than 1.5 m/s or on land: check columns, units and ids, or accept it with --accept-doubtful</source>
        <translation>er raskere enn 1,5 m/s eller på land: kontroller kolonner, enheter og id-er, eller godta det med --accept-doubtful</translation>
    </message>
    <message>
        <source>has several places: each is taken as an iceberg</source>
        <translation>har flere posisjoner: hver regnes som et isfjell</translation>
    </message>
    <message>
        <source>has points beside lines or areas: only the points are taken</source>
        <translation>har punkter ved siden av linjer eller flater: bare punktene tas med</translation>
    </message>
    <message>
        <source>has areas beside lines: only the areas are taken</source>
        <translation>har flater ved siden av linjer: bare flatene tas med</translation>
    </message>
    <message>
        <source>has points or areas beside a track: only the track is taken</source>
        <translation>har punkter eller flater ved siden av et spor: bare sporet tas med</translation>
    </message>
    <message>
        <source>has the name of another track, but an iceberg cannot have drifted along both: it is taken as another iceberg</source>
        <translation>har samme navn som et annet spor, men et isfjell kan ikke ha drevet langs begge: det regnes som et annet isfjell</translation>
    </message>
    <message>
        <source>the property that names the iceberg is the same at two places at once: the ids of the features are taken instead</source>
        <translation>egenskapen som gir isfjellet navn, er den samme på to steder samtidig: objektenes id-er brukes i stedet</translation>
    </message>
    <message>
        <source>has more times than places: the times left over are not taken</source>
        <translation>har flere tider enn posisjoner: de overskytende tidene brukes ikke</translation>
    </message>
    <message>
        <source>the place can be read in more than one way: decimals follow a point</source>
        <translation>posisjonen kan leses på flere måter: desimaler skrives med punktum</translation>
    </message>
    <message>
        <source>coordinates are no degrees, and the file names no coordinate system: save it in WGS 84 (EPSG:4326)</source>
        <translation>koordinatene er ikke grader, og filen oppgir ikke noe koordinatsystem: lagre den i WGS 84 (EPSG:4326)</translation>
    </message>
    <message>
        <source>coordinates look like degrees, but the file says they are metres: save it in WGS 84 (EPSG:4326)</source>
        <translation>koordinatene ser ut som grader, men filen sier at de er meter: lagre den i WGS 84 (EPSG:4326)</translation>
    </message>
    <message>
        <source>the coordinate system &quot;%1&quot; is not known: save the file in WGS 84 (EPSG:4326)</source>
        <translation>koordinatsystemet «%1» er ukjent: lagre filen i WGS 84 (EPSG:4326)</translation>
    </message>
    <message>
        <source>is not well-formed JSON</source>
        <translation>er ikke velformet JSON</translation>
    </message>
    <message>
        <source>links to another file, which is not read: import that file as well</source>
        <translation>viser til en annen fil, som ikke leses: importer den filen også</translation>
    </message>
    <message>
        <source>the first document of the archive does not link to this one; it is read all the same</source>
        <translation>det første dokumentet i arkivet viser ikke til dette; det leses likevel</translation>
    </message>
    <message>
        <source>a document of the archive cannot be read</source>
        <translation>et dokument i arkivet kan ikke leses</translation>
    </message>
    <message>
        <source>airspace left out: it has no outline</source>
        <translation>luftrom utelatt: det mangler omriss</translation>
    </message>
    <message>
        <source>outline left out: no airspace begins above it</source>
        <translation>omriss utelatt: ikke noe luftrom begynner over det</translation>
    </message>
    <message>
        <source>airspace left out: its outline encloses nothing</source>
        <translation>luftrom utelatt: omrisset omslutter ingenting</translation>
    </message>
    <message>
        <source>airspace left out: its ceiling is not above its floor</source>
        <translation>luftrom utelatt: taket ligger ikke over gulvet</translation>
    </message>
    <message>
        <source>airspace left out: it is farther than 100 km</source>
        <translation>luftrom utelatt: det er lenger unna enn 100 km</translation>
    </message>
    <message>
        <source>airspace left out: the scenario holds as many as it can</source>
        <translation>luftrom utelatt: scenarioet har ikke plass til flere</translation>
    </message>
    <message>
        <source>airspace taken without a class</source>
        <translation>luftrom tatt med uten klasse</translation>
    </message>
    <message>
        <source>airspace taken down to the sea: its floor is missing or cannot be read</source>
        <translation>luftrom tatt med ned til havet: gulvet mangler eller kan ikke leses</translation>
    </message>
    <message>
        <source>airspace taken without end above: its ceiling is missing or cannot be read</source>
        <translation>luftrom tatt med uten øvre grense: taket mangler eller kan ikke leses</translation>
    </message>
    <message>
        <source>airspace taken with an outline round its own, which touches or crosses itself</source>
        <translation>luftrom tatt med i et større omriss: dets eget berører eller krysser seg selv</translation>
    </message>
    <message>
        <source>airspace taken with an outline round its own, which has too many corners</source>
        <translation>luftrom tatt med i et større omriss: dets eget har for mange hjørner</translation>
    </message>
    <message>
        <source>line not understood and not used</source>
        <translation>linje ikke forstått og ikke brukt</translation>
    </message>
    <message>
        <source>has no time, although other sightings of this iceberg have one</source>
        <translation>har ikke noe tidspunkt, selv om andre observasjoner av dette isfjellet har det</translation>
    </message>
    <message>
        <source>lies outside the chosen area</source>
        <translation>ligger utenfor det valgte området</translation>
    </message>
    <message>
        <source>was sighted outside the chosen time</source>
        <translation>er observert utenfor det valgte tidsrommet</translation>
    </message>
    <message>
        <source>taken without a value that cannot be read</source>
        <translation>tatt med uten en verdi som ikke kan leses</translation>
    </message>
    <message>
        <source>taken without a number that is out of range</source>
        <translation>tatt med uten et tall som er utenfor grensene</translation>
    </message>
    <message>
        <source>a range, a limit or an estimate is read as one number</source>
        <translation>et intervall, en grense eller et anslag er lest som ett tall</translation>
    </message>
    <message>
        <source>taken without its time, which cannot be read</source>
        <translation>tatt med uten tidspunktet, som ikke kan leses</translation>
    </message>
    <message>
        <source>taken without a time, which it does not have</source>
        <translation>tatt med uten tidspunkt, som mangler</translation>
    </message>
    <message>
        <source>taken without its time, which is years from all others</source>
        <translation>tatt med uten tidspunktet, som er år unna alle andre</translation>
    </message>
    <message>
        <source>its time is moved by 1024 weeks, as a GPS clock has lost count of them</source>
        <translation>tidspunktet er flyttet 1024 uker, fordi en GPS-klokke har mistet telling</translation>
    </message>
    <message>
        <source>its id is too long and is shortened</source>
        <translation>id-en er for lang og er forkortet</translation>
    </message>
    <message>
        <source>the wind must be two finite numbers</source>
        <translation>vinden må være to endelige tall</translation>
    </message>
    <message>
        <source>the area must have from 3 to %1 corners, not %2</source>
        <translation>området må ha fra 3 til %1 hjørner, ikke %2</translation>
    </message>
    <message>
        <source>the area must neither touch nor cross itself</source>
        <translation>området må verken berøre eller krysse seg selv</translation>
    </message>
    <message>
        <source>a scenario holds at most %1 no-fly areas, not %2</source>
        <translation>et scenario har høyst %1 flyforbudsområder, ikke %2</translation>
    </message>
    <message>
        <source>a scenario holds at most %1 airspace areas, not %2</source>
        <translation>et scenario har høyst %1 luftromsområder, ikke %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the id of %2 already: each iceberg and UAV needs a unique id</source>
        <translation>«%1» er allerede id-en til %2: hvert isfjell og hver UAV trenger en unik id</translation>
    </message>
    <message>
        <source>a scenario holds from 1 to %1 UAVs, not %2</source>
        <translation>et scenario har fra 1 til %1 UAV-er, ikke %2</translation>
    </message>
    <message>
        <source>a scenario holds at most %1 icebergs, not %2</source>
        <translation>et scenario har høyst %1 isfjell, ikke %2</translation>
    </message>
    <message>
        <source>must have one entry for each of the %1 times, not %2</source>
        <translation>må ha én verdi for hvert av de %1 tidspunktene, ikke %2</translation>
    </message>
    <message>
        <source>there are %1 more errors</source>
        <translation>det er %1 feil til</translation>
    </message>
    <message>
        <source>must not be longer than the run</source>
        <translation>kan ikke være lengre enn flygingen</translation>
    </message>
    <message>
        <source>needs an area to stay inside</source>
        <translation>trenger et område å holde seg innenfor</translation>
    </message>
    <message>
        <source>a geofence has at most %1 corners, not %2</source>
        <translation>et geogjerde har høyst %1 hjørner, ikke %2</translation>
    </message>
    <message>
        <source>with the geofence and the stand-off ring, the no-fly areas at the altitude of a UAV have at most %1 corners, not %2</source>
        <translation>med geogjerdet og sikkerhetsringen har flyforbudsområdene i høyden til en UAV høyst %1 hjørner, ikke %2</translation>
    </message>
    <message>
        <source>there is no UAV &quot;%1&quot; in this scenario</source>
        <translation>det er ingen UAV «%1» i dette scenarioet</translation>
    </message>
    <message>
        <source>the wind must be slower than the UAV flies: wind of %1, airspeed of %2 %3</source>
        <translation>vinden må være langsommere enn UAV-en flyr: vind på %1, flyfart på %2 %3</translation>
    </message>
    <message>
        <source>the UAV will make little headway in this wind: wind of %1, airspeed of %2 %3</source>
        <translation>UAV-en kommer knapt fremover i denne vinden: vind på %1, flyfart på %2 %3</translation>
    </message>
    <message>
        <source>must not be shorter than the time step</source>
        <translation>kan ikke være kortere enn tidssteget</translation>
    </message>
    <message>
        <source>must be above the floor of %1, not %2</source>
        <translation>må ligge over gulvet på %1, ikke %2</translation>
    </message>
    <message>
        <source>the airspace &quot;%1&quot; ends before it begins</source>
        <translation>luftrommet «%1» slutter før det begynner</translation>
    </message>
    <message>
        <source>must be longer than reserve, climb and landing together, %2, not %1</source>
        <translation>må være lengre enn reserve, stigning og landing til sammen, %2, ikke %1</translation>
    </message>
    <message>
        <source>there are no icebergs yet, so there is nothing to plan</source>
        <translation>det er ingen isfjell ennå, så det er ingenting å planlegge</translation>
    </message>
    <message>
        <source>is after the end of the run, so the iceberg is never planned</source>
        <translation>er etter slutten av flygingen, så isfjellet blir aldri planlagt</translation>
    </message>
    <message>
        <source>icebergs outside the area are not monitored; the UAV may fly beyond it</source>
        <translation>isfjell utenfor området overvåkes ikke; UAV-en kan fly utenfor det</translation>
    </message>
    <message>
        <source>is used in flight only with the Kalman filter</source>
        <translation>brukes under flygingen bare med Kalman-filteret</translation>
    </message>
    <message>
        <source>another UAV of this altitude layer starts so near that they fly apart first; let their altitudes differ by %1</source>
        <translation>en annen UAV i dette høydelaget starter så nær at de først flyr fra hverandre; gi dem høyder med %1 forskjell</translation>
    </message>
    <message>
        <source>is too short to reach the nearest iceberg and return</source>
        <translation>er for kort til å nå det nærmeste isfjellet og komme tilbake</translation>
    </message>
    <message>
        <source>for its heading, the UAV has no path home inside the geofence and outside no-fly areas from where it starts: no start is safe</source>
        <translation>med denne kursen har UAV-en ingen vei hjem innenfor geogjerdet og utenom flyforbudsområdene fra startstedet: ingen start er trygg</translation>
    </message>
    <message>
        <source>the UAV starts so near the geofence or a no-fly area, for its heading, that it cannot turn in time</source>
        <translation>UAV-en starter så nær geogjerdet eller et flyforbudsområde, med denne kursen, at den ikke rekker å svinge</translation>
    </message>
    <message>
        <source>is so near the geofence, or in a no-fly area, that the UAV cannot come as near as it has to</source>
        <translation>er så nær geogjerdet, eller i et flyforbudsområde, at UAV-en ikke kan komme så nær som den må</translation>
    </message>
    <message>
        <source>the time between two commands is too long for the UAV to follow a leg</source>
        <translation>tiden mellom to kommandoer er for lang til at UAV-en kan følge en etappe</translation>
    </message>
    <message>
        <source>must not be exceeded: wind of %1, limit %2</source>
        <translation>må ikke overskrides: vind på %1, grense %2</translation>
    </message>
    <message>
        <source>must not be exceeded: gusts of %1, limit %2</source>
        <translation>må ikke overskrides: vindkast på %1, grense %2</translation>
    </message>
    <message>
        <source>this weather brings icing at its altitude, in which the UAV must not be flown</source>
        <translation>dette været gir ising i UAV-ens høyde, og UAV-en må ikke flys i ising</translation>
    </message>
    <message>
        <source>leaves less reserve than waiting for the other UAVs of the altitude layer may take, %1; separate altitudes, or a greater reserve, avoid it</source>
        <translation>gir mindre reserve enn ventingen på de andre UAV-ene i høydelaget kan ta, %1; ulike høyder eller en større reserve hindrer det</translation>
    </message>
    <message>
        <source>keeps %1 free for a recovery slot, as other UAVs of the altitude layer land on the same pad; separate altitudes or pads avoid it</source>
        <translation>holder %1 fri til et landingsvindu, fordi andre UAV-er i høydelaget lander på samme plass; ulike høyder eller plasser hindrer det</translation>
    </message>
    <message>
        <source>with the usual errors in wind and airspeed, 1 flight in 20 uses %1 or more of the reserve to come home</source>
        <translation>med vanlige feil i vind og flyfart bruker 1 av 20 flyginger %1 eller mer av reserven for å komme hjem</translation>
    </message>
    <message>
        <source>with the usual errors in wind and airspeed, in 1 flight in 20 the wind is too strong to come home</source>
        <translation>med vanlige feil i vind og flyfart er vinden for sterk til å komme hjem i 1 av 20 flyginger</translation>
    </message>
    <message>
        <source>the plan leads out of the range of the ground station for %1</source>
        <translation>planen går utenfor bakkestasjonens rekkevidde i %1</translation>
    </message>
    <message>
        <source>the operation may enter the airspace &quot;%1&quot;, which begins at %2</source>
        <translation>operasjonen kan komme inn i luftrommet «%1», som begynner i %2</translation>
    </message>
    <message>
        <source>starts outside the area</source>
        <translation>starter utenfor området</translation>
    </message>
    <message>
        <source>lies where another iceberg lies: is it the same one?</source>
        <translation>ligger der et annet isfjell ligger: er det det samme?</translation>
    </message>
    <message>
        <source>is too far away to reach before the run ends</source>
        <translation>er for langt unna til å nås før flygingen er slutt</translation>
    </message>
    <message>
        <source>the recorded track ends before the run does; from then on the iceberg stands still</source>
        <translation>det registrerte sporet slutter før flygingen; deretter ligger isfjellet stille</translation>
    </message>
    <message>
        <source>the recorded track begins so far from the estimate that the UAV will not see the iceberg there</source>
        <translation>det registrerte sporet begynner så langt fra estimatet at UAV-en ikke ser isfjellet der</translation>
    </message>
    <message>
        <source>the asset lies inside an iceberg</source>
        <translation>objektet ligger inne i et isfjell</translation>
    </message>
    <message>
        <source>more icebergs than can be proven optimal; the plan comes with a bound</source>
        <translation>for mange isfjell til å bevise planen optimal; planen får en grense</translation>
    </message>
    <message>
        <source>this policy plans icebergs one by one; nearby icebergs are not grouped</source>
        <translation>denne strategien planlegger isfjell ett for ett; nære isfjell grupperes ikke</translation>
    </message>
    <message>
        <source>this solver cannot plan so many icebergs: choose Automatic (auto)</source>
        <translation>denne løseren kan ikke planlegge så mange isfjell: velg Automatisk (auto)</translation>
    </message>
    <message>
        <source>is of no format that Bergwatch recognises; if it is a table, name its columns for latitude and longitude; known formats: %1</source>
        <translation>har ikke et format som Bergwatch kjenner; hvis det er en tabell, oppgi kolonnene for bredde og lengde; kjente formater: %1</translation>
    </message>
    <message>
        <source>latitude must be between -90 and 90, minutes below 60</source>
        <translation>bredden må være fra -90 til 90, minuttene under 60</translation>
    </message>
    <message>
        <source>longitude must be between -180 and 360, minutes below 60</source>
        <translation>lengden må være fra -180 til 360, minuttene under 60</translation>
    </message>
    <message>
        <source>iceberg %1</source>
        <translation>isfjell %1</translation>
    </message>
    <message>
        <source>UAV %1</source>
        <translation>UAV-en %1</translation>
    </message>
    <message>
        <source>%1 h before the start; the iceberg may be %2 from this position, %3 times the field of view</source>
        <translation>%1 t før start; isfjellet kan være %2 fra denne posisjonen, %3 ganger synsfeltet</translation>
    </message>
    <message>
        <source>a file holds one UAV: %1 files are written, named after the UAVs</source>
        <translation>en fil har plass til én UAV: %1 filer skrives, med navn etter UAV-ene</translation>
    </message>
    <message>
        <source>the scenario has no start time, so the file has no dates</source>
        <translation>scenarioet har ikke noe starttidspunkt, så filen har ingen datoer</translation>
    </message>
    <message>
        <source>the geofence is left out: the format has no place for it</source>
        <translation>geogjerdet utelates: formatet har ikke plass til det</translation>
    </message>
    <message>
        <source>no-fly areas and the stand-off ring are left out: the format has no place for them</source>
        <translation>flyforbudsområder og sikkerhetsringen utelates: formatet har ikke plass til dem</translation>
    </message>
    <message>
        <source>no-fly areas have no heights: those at the altitude of the UAV are written</source>
        <translation>flyforbudsområder har ingen høyder: de i høyden til UAV-en skrives</translation>
    </message>
    <message>
        <source>%1 may draw the fence the long way round: it crosses the antimeridian</source>
        <translation>%1 kan tegne gjerdet den lange veien rundt: det krysser antimeridianen</translation>
    </message>
    <message>
        <source>the places where icebergs were reached are written, not the track</source>
        <translation>stedene der isfjell ble nådd, skrives, ikke sporet</translation>
    </message>
    <message>
        <source>the path becomes %1 waypoints within %2 m of it</source>
        <translation>banen blir %1 veipunkter innenfor %2 m fra den</translation>
    </message>
    <message>
        <source>%1 keeps acceptance radii up to %3 m: %2 m becomes %3 m</source>
        <translation>%1 lagrer passeringsradier opp til %3 m: %2 m blir %3 m</translation>
    </message>
    <message>
        <source>%1 keeps loiter radii above 255 m in steps of 10 m: %2 m becomes %3 m</source>
        <translation>%1 lagrer venteradier over 255 m i trinn på 10 m: %2 m blir %3 m</translation>
    </message>
    <message>
        <source>%1 reads the cruise speed as a whole number: %2 m/s becomes %3 m/s; the speed in the mission is exact</source>
        <translation>%1 leser marsjfarten som heltall: %2 m/s blir %3 m/s; farten i oppdraget er nøyaktig</translation>
    </message>
    <message>
        <source>the file is about the whole flight, whatever is chosen to be exported</source>
        <translation>filen handler om hele flygingen, uansett hva du velger å eksportere</translation>
    </message>
    <message>
        <source>UAVs without an iceberg to visit: %1</source>
        <translation>UAV-er uten et isfjell å besøke: %1</translation>
    </message>
    <message>
        <source>straight legs that lead out of the geofence or through a no-fly area: %1; export the path instead, which leads round</source>
        <translation>rette etapper som fører ut av geogjerdet eller gjennom et flyforbudsområde: %1; eksporter i stedet banen, som fører utenom</translation>
    </message>
    <message>
        <source>only this sortie is exported; icebergs left for later sorties: %1</source>
        <translation>bare dette toktet eksporteres; isfjell som er igjen til senere tokt: %1</translation>
    </message>
    <message>
        <source>nothing in the file depends on %1</source>
        <translation>ingenting i filen avhenger av %1</translation>
    </message>
    <message>
        <source>velocity unknown</source>
        <translation>hastigheten er ukjent</translation>
    </message>
    <message>
        <source>no time: counts as seen at the start</source>
        <translation>uten tid: regnes som sett ved start</translation>
    </message>
    <message>
        <source>velocity from the file</source>
        <translation>hastigheten er fra filen</translation>
    </message>
    <message>
        <source>velocity limited to 5 m/s per axis</source>
        <translation>hastigheten er begrenset til 5 m/s per akse</translation>
    </message>
    <message>
        <source>q estimated</source>
        <translation>q er anslått</translation>
    </message>
    <message>
        <source>q limited to 10⁶ m²/s</source>
        <translation>q er begrenset til 10⁶ m²/s</translation>
    </message>
    <message>
        <source>stationary</source>
        <translation>ligger stille</translation>
    </message>
    <message>
        <source>several sightings at one time</source>
        <translation>flere observasjoner til samme tid</translation>
    </message>
    <message>
        <source>sightings at impossible places not used</source>
        <translation>observasjoner på umulige steder er ikke brukt</translation>
    </message>
    <message>
        <source>recorded track attached</source>
        <translation>registrert spor er lagt til</translation>
    </message>
    <message>
        <source>no track: not sighted after the start</source>
        <translation>uten spor: ikke observert etter starten</translation>
    </message>
    <message>
        <source>older than what the scenario has</source>
        <translation>eldre enn det scenarioet har</translation>
    </message>
    <message>
        <source>sighted only after the start</source>
        <translation>først observert etter starten</translation>
    </message>
    <message>
        <source>more than 1000 km from the origin at the start</source>
        <translation>mer enn 1000 km fra origo ved starten</translation>
    </message>
    <message>
        <source>the scenario is full</source>
        <translation>scenarioet er fullt</translation>
    </message>
    <message>
        <source>a UAV has this id</source>
        <translation>en UAV har denne id-en</translation>
    </message>
    <message>
        <source>the file&apos;s drift contradicts the positions: not used</source>
        <translation>driften i filen motsier posisjonene: ikke brukt</translation>
    </message>
    <message>
        <source>faster than 1.5 m/s</source>
        <translation>raskere enn 1,5 m/s</translation>
    </message>
    <message>
        <source>on land</source>
        <translation>på land</translation>
    </message>
    <message numerus="yes">
        <source>%n UAV(s) taken over</source>
        <translation>
            <numerusform>%n UAV tatt med</numerusform>
            <numerusform>%n UAV-er tatt med</numerusform>
        </translation>
    </message>
    <message>
        <source>area taken over</source>
        <translation>området tatt med</translation>
    </message>
    <message>
        <source>area taken over as geofence</source>
        <translation>området tatt med som geogjerde</translation>
    </message>
    <message>
        <source>asset taken over</source>
        <translation>objektet tatt med</translation>
    </message>
    <message numerus="yes">
        <source>%n no-fly area(s) taken over</source>
        <translation>
            <numerusform>%n flyforbudsområde tatt med</numerusform>
            <numerusform>%n flyforbudsområder tatt med</numerusform>
        </translation>
    </message>
    <message>
        <source>UAVs, area and asset of the file not taken over: the scenario is in use</source>
        <translation>UAV-er, område og objekt i filen er ikke tatt med: scenarioet er i bruk</translation>
    </message>
    <message numerus="yes">
        <source>%n UAV(s) left out: too many</source>
        <translation>
            <numerusform>%n UAV utelatt: for mange</numerusform>
            <numerusform>%n UAV-er utelatt: for mange</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n UAV(s) left out: more than 1000 km east, west, north or south of the origin</source>
        <translation>
            <numerusform>%n UAV utelatt: mer enn 1000 km øst, vest, nord eller sør for origo</numerusform>
            <numerusform>%n UAV-er utelatt: mer enn 1000 km øst, vest, nord eller sør for origo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n area(s) left out: unreadable</source>
        <translation>
            <numerusform>%n uleselig område utelatt</numerusform>
            <numerusform>%n uleselige områder utelatt</numerusform>
        </translation>
    </message>
    <message>
        <source>area left out: too few or too many corners</source>
        <translation>området utelatt: for få eller for mange hjørner</translation>
    </message>
    <message>
        <source>area left out: more than 1000 km east, west, north or south of the origin</source>
        <translation>området utelatt: mer enn 1000 km øst, vest, nord eller sør for origo</translation>
    </message>
    <message>
        <source>area left out: it touches or crosses itself</source>
        <translation>området utelatt: det berører eller krysser seg selv</translation>
    </message>
    <message>
        <source>area left out: it is in several parts</source>
        <translation>området utelatt: det består av flere deler</translation>
    </message>
    <message numerus="yes">
        <source>%n further area(s) left out</source>
        <translation>
            <numerusform>%n annet område utelatt</numerusform>
            <numerusform>%n andre områder utelatt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s) of the area left out</source>
        <translation>
            <numerusform>%n hull i området utelatt</numerusform>
            <numerusform>%n hull i området utelatt</numerusform>
        </translation>
    </message>
    <message>
        <source>area is no geofence: too many corners</source>
        <translation>området er ikke noe geogjerde: for mange hjørner</translation>
    </message>
    <message>
        <source>area is no geofence: a UAV starts or lands outside</source>
        <translation>området er ikke noe geogjerde: en UAV starter eller lander utenfor</translation>
    </message>
    <message numerus="yes">
        <source>%n no-fly area(s) left out: a UAV starts or lands inside, or the heights are wrong</source>
        <translation>
            <numerusform>%n flyforbudsområde utelatt: en UAV starter eller lander i det, eller høydene er feil</numerusform>
            <numerusform>%n flyforbudsområder utelatt: en UAV starter eller lander i dem, eller høydene er feil</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rally point(s) left out</source>
        <translation>
            <numerusform>%n samlingspunkt utelatt</numerusform>
            <numerusform>%n samlingspunkter utelatt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n further asset(s) left out</source>
        <translation>
            <numerusform>%n annet objekt utelatt</numerusform>
            <numerusform>%n andre objekter utelatt</numerusform>
        </translation>
    </message>
    <message>
        <source>asset left out: more than 1000 km east, west, north or south of the origin</source>
        <translation>objektet utelatt: mer enn 1000 km øst, vest, nord eller sør for origo</translation>
    </message>
    <message numerus="yes">
        <source>%n number(s) out of range left out</source>
        <translation>
            <numerusform>%n tall utenfor grensene utelatt</numerusform>
            <numerusform>%n tall utenfor grensene utelatt</numerusform>
        </translation>
    </message>
    <message>
        <source>there is no take-off item: launch the UAV by hand and start the mission in the air</source>
        <translation>oppdraget har ikke noe avgangselement: kast UAV-en for hånd og start oppdraget i luften</translation>
    </message>
    <message>
        <source>after the last iceberg the mission returns home, %1 m that the plan does not include</source>
        <translation>etter det siste isfjellet flyr UAV-en hjem, %1 m som ikke er med i planen</translation>
    </message>
    <message>
        <source>the mission ends in an endless loiter: command the return yourself</source>
        <translation>oppdraget slutter i en ventesirkel uten ende: gi selv kommandoen om å fly hjem</translation>
    </message>
    <message>
        <source>%1 has no loiter by turns: the time that they take is written</source>
        <translation>%1 kan ikke telle runder: filen inneholder tiden som de tar</translation>
    </message>
    <message>
        <source>loiter turns are left out: a VTOL or multirotor flies over each iceberg</source>
        <translation>runder over isfjell utelates: en VTOL eller multirotor flyr over hvert isfjell</translation>
    </message>
    <message>
        <source>%1 uses the acceptance radius of its parameter %2, not that of the file</source>
        <translation>%1 bruker passeringsradien i sin parameter %2, ikke den i filen</translation>
    </message>
    <message>
        <source>%1 keeps to the fence only if its parameter %2 says so</source>
        <translation>%1 holder seg innenfor gjerdet bare hvis parameteren %2 sier det</translation>
    </message>
    <message>
        <source>the first row is home, which %1 does not have: upload the file with QGroundControl</source>
        <translation>den første raden er hjemstedet, som %1 ikke har: last opp filen med QGroundControl</translation>
    </message>
    <message>
        <source>the first iceberg is %2 m from the start, but the climb takes %1 m</source>
        <translation>det første isfjellet er %2 m fra starten, men stigningen tar %1 m</translation>
    </message>
    <message>
        <source>the first iceberg is %2 m from the start: %1 may refuse more than %3 m (MIS_DIST_1WP)</source>
        <translation>det første isfjellet er %2 m fra starten: %1 kan avvise mer enn %3 m (MIS_DIST_1WP)</translation>
    </message>
    <message>
        <source>legs of take-off, return and landing that lead out of the geofence or through a no-fly area: %1</source>
        <translation>etapper ved avgang, hjemflyging og landing som fører ut av geogjerdet eller gjennom et flyforbudsområde: %1</translation>
    </message>
    <message>
        <source>the landing approach leads over land</source>
        <translation>innflygingen går over land</translation>
    </message>
    <message>
        <source>the landing approach descends at %1°, more than the usual %2°: make it longer or lower</source>
        <translation>innflygingen går ned med %1°, mer enn de vanlige %2°: gjør den lengre eller lavere</translation>
    </message>
    <message>
        <source>waypoints within their acceptance radius of the one before, which the UAV may skip: %1</source>
        <translation>veipunkter innenfor passeringsradien sin fra det forrige, som UAV-en kan hoppe over: %1</translation>
    </message>
    <message>
        <source>the mission has %2 items; %1 holds about %3</source>
        <translation>oppdraget har %2 elementer; %1 har plass til omtrent %3</translation>
    </message>
    <message>
        <source>airspace areas that the mission enters at its altitudes: %1</source>
        <translation>luftromsområder som oppdraget kommer inn i med flygehøydene sine: %1</translation>
    </message>
    <message>
        <source>with climb, return and landing the mission takes %1 min; the endurance without reserve is %2 min</source>
        <translation>med stigning, hjemflyging og landing tar oppdraget %1 min; utholdenheten uten reserven er %2 min</translation>
    </message>
    <message>
        <source>%1 is no link: write udp:HOST:PORT to listen, udpout:HOST:PORT, tcp:HOST:PORT or serial:DEVICE:BAUD</source>
        <translation>%1 er ingen forbindelse: skriv udp:VERT:PORT for å lytte, udpout:VERT:PORT, tcp:VERT:PORT eller serial:ENHET:BAUD</translation>
    </message>
    <message>
        <source>%1 has no host: write an IPv4 address or a name</source>
        <translation>%1 har ingen vert: skriv en IPv4-adresse eller et navn</translation>
    </message>
    <message>
        <source>%1 has no port from 1 to 65535</source>
        <translation>%1 har ingen port fra 1 til 65535</translation>
    </message>
    <message>
        <source>%1 has no device: write a path such as /dev/ttyUSB0</source>
        <translation>%1 har ingen enhet: skriv en bane som /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>%1 has no baud rate of a serial port, such as 57600 or 115200</source>
        <translation>%1 har ingen baudhastighet for en serieport, som 57600 eller 115200</translation>
    </message>
    <message>
        <source>only %1 of %2 icebergs found a place at least %3 from the others: choose fewer icebergs, a smaller spacing or a larger area</source>
        <translation>bare %1 av %2 isfjell fikk plass minst %3 fra de andre: velg færre isfjell, en mindre avstand eller et større område</translation>
    </message>
    <message>
        <source>a forecast holds from 1 to %1 places, not %2</source>
        <translation>et varsel har fra 1 til %1 steder, ikke %2</translation>
    </message>
    <message>
        <source>a forecast holds at most %1 entries at all places together, not %2</source>
        <translation>et varsel har høyst %1 oppføringer for alle steder til sammen, ikke %2</translation>
    </message>
    <message>
        <source>the places must be a complete grid: rows from south to north, each from west to east</source>
        <translation>stedene må være et fullstendig rutenett: rader fra sør til nord, hver fra vest til øst</translation>
    </message>
    <message>
        <source>must have at least one entry</source>
        <translation>må ha minst én oppføring</translation>
    </message>
    <message>
        <source>a scenario with a forecast needs a start date and time</source>
        <translation>et scenario med varsel trenger dato og tid for starten</translation>
    </message>
    <message>
        <source>gives no %1 for %2 h of the run: the constant value of the scenario applies</source>
        <translation>gir ingen verdi (%1) for %2 t av kjøringen: scenarioets faste verdi gjelder</translation>
    </message>
    <message>
        <source>has a gap in %1 from %2 h to %3 h after the start: the constant value of the scenario applies</source>
        <translation>har et hull (%1) fra %2 t til %3 t etter starten: scenarioets faste verdi gjelder</translation>
    </message>
    <message>
        <source>was issued %1 h before the start</source>
        <translation>ble utgitt %1 t før starten</translation>
    </message>
    <message>
        <source>this build reads no %1: install %2 and build Bergwatch again</source>
        <translation>denne versjonen leser ikke %1: installer %2 og bygg Bergwatch på nytt</translation>
    </message>
    <message>
        <source>is GRIB of edition %1; only edition 2 is read: convert it with grib_set -s edition=2</source>
        <translation>er GRIB i utgave %1; bare utgave 2 leses: konverter filen med grib_set -s edition=2</translation>
    </message>
    <message>
        <source>holds no wind, weather or current on a grid of latitudes and longitudes</source>
        <translation>inneholder verken vind, vær eller strøm i et gitter av bredde- og lengdegrader</translation>
    </message>
    <message>
        <source>the unit &quot;%1&quot; is not understood; it must be one of %2</source>
        <translation>enheten «%1» er ukjent; den må være en av %2</translation>
    </message>
    <message>
        <source>the unit of time &quot;%1&quot; in the calendar &quot;%2&quot; is not understood</source>
        <translation>tidsenheten «%1» i kalenderen «%2» er ukjent</translation>
    </message>
    <message>
        <source>the forecast covers 180 degrees or more: choose an area</source>
        <translation>varselet dekker 180 grader eller mer: velg et område</translation>
    </message>
    <message>
        <source>the forecast has no values in the area</source>
        <translation>varselet har ingen verdier i området</translation>
    </message>
    <message>
        <source>the forecast is for another time, from %1 to %2</source>
        <translation>varselet gjelder et annet tidsrom, fra %1 til %2</translation>
    </message>
    <message>
        <source>is no NMEA sentence</source>
        <translation>er ingen NMEA-setning</translation>
    </message>
    <message>
        <source>its checksum is wrong or missing</source>
        <translation>kontrollsummen er feil eller mangler</translation>
    </message>
    <message>
        <source>a field of the sentence is missing or wrong</source>
        <translation>et felt i setningen mangler eller er feil</translation>
    </message>
    <message>
        <source>the AIS message is cut or wrong</source>
        <translation>AIS-meldingen er avkortet eller feil</translation>
    </message>
    <message>
        <source>another part of the AIS message is missing or out of order</source>
        <translation>en annen del av AIS-meldingen mangler eller kommer i feil rekkefølge</translation>
    </message>
    <message>
        <source>a radar bearing needs the ship&apos;s position within the minute before, and a relative one its heading</source>
        <translation>en radarpeiling trenger skipets posisjon i minuttet før, og en relativ peiling også kursen</translation>
    </message>
    <message>
        <source>the radar target is a ship that reports by AIS</source>
        <translation>radarmålet er et skip som melder seg med AIS</translation>
    </message>
    <message>
        <source>the data of the photograph cannot be read</source>
        <translation>dataene i fotografiet kan ikke leses</translation>
    </message>
    <message>
        <source>the photograph has no position; with its time, --run places it on the flown track</source>
        <translation>fotografiet har ingen posisjon; med tiden plasserer --run det på det fløyne sporet</translation>
    </message>
    <message>
        <source>the photograph has no position, and its time is not in the flight</source>
        <translation>fotografiet har ingen posisjon, og tiden er ikke i flygingen</translation>
    </message>
    <message>
        <source>this build reads no photographs: it was made without libexiv2</source>
        <translation>denne versjonen leser ingen fotografier: den er bygget uten libexiv2</translation>
    </message>
    <message>
        <source>sightings for an ice service need dates: give the scenario a start time</source>
        <translation>observasjoner til en istjeneste må ha datoer: gi scenarioet en starttid</translation>
    </message>
    <message>
        <source>photograph %1</source>
        <translation>fotografi %1</translation>
    </message>
    <message>
        <source>an ice chart holds at most %1 areas, not %2</source>
        <translation>et iskart har høyst %1 områder, ikke %2</translation>
    </message>
    <message>
        <source>the outlines of an ice chart hold at most %1 corners together, not %2</source>
        <translation>omrissene i et iskart har høyst %1 hjørner til sammen, ikke %2</translation>
    </message>
    <message>
        <source>an ice area needs outlines of at least 3 corners</source>
        <translation>et isområde trenger omriss med minst 3 hjørner</translation>
    </message>
    <message>
        <source>the ice chart is %1 hours older than the start: ice has moved since</source>
        <translation>iskartet er %1 timer eldre enn starten: isen har flyttet seg siden</translation>
    </message>
    <message>
        <source>is no ice chart: it has no polygons with concentrations (CT, POLY_TYPE of SIGRID-3)</source>
        <translation>er ikke et iskart: filen har ingen polygoner med konsentrasjoner (CT, POLY_TYPE i SIGRID-3)</translation>
    </message>
    <message>
        <source>holds no ice-chart area within %1 km of the scenario</source>
        <translation>inneholder ikke noe isområde innen %1 km fra scenarioet</translation>
    </message>
    <message>
        <source>is read with ogr2ogr: install gdal-bin</source>
        <translation>leses med ogr2ogr: installer gdal-bin</translation>
    </message>
    <message>
        <source>is written with ogr2ogr: install gdal-bin</source>
        <translation>skrives med ogr2ogr: installer gdal-bin</translation>
    </message>
    <message>
        <source>ogr2ogr reports: %1</source>
        <translation>ogr2ogr melder: %1</translation>
    </message>
    <message>
        <source>ogr2ogr failed without a reason (%1)</source>
        <translation>ogr2ogr mislyktes uten å oppgi en grunn (%1)</translation>
    </message>
    <message>
        <source>ogr2ogr was stopped after %1 s</source>
        <translation>ogr2ogr ble stoppet etter %1 s</translation>
    </message>
    <message>
        <source>ogr2ogr did not print GeoJSON</source>
        <translation>ogr2ogr skrev ikke GeoJSON</translation>
    </message>
    <message>
        <source>holds no features</source>
        <translation>inneholder ingen objekter</translation>
    </message>
    <message>
        <source>the archive holds several files that ogr2ogr can read: %1; unpack the one that you need</source>
        <translation>arkivet inneholder flere filer som ogr2ogr kan lese: %1; pakk ut den du trenger</translation>
    </message>
    <message>
        <source>ice area left out: its outline cannot be read</source>
        <translation>isområde utelatt: omrisset kan ikke leses</translation>
    </message>
    <message>
        <source>the times along paths and tracks are left out: the format has no place for them</source>
        <translation>tidene langs baner og spor utelates: formatet har ikke plass til dem</translation>
    </message>
    <message>
        <source>there is a Shapefile each for points, lines and areas; names of properties are cut to 10 letters, texts to 254 bytes</source>
        <translation>det er én Shapefile hver for punkter, linjer og områder; navn på egenskaper kuttes til 10 bokstaver, tekster til 254 byte</translation>
    </message>
    <message>
        <source>coordinates are metres of EPSG:%1; names, numbers and times are left out</source>
        <translation>koordinatene er meter i EPSG:%1; navn, tall og tider utelates</translation>
    </message>
    <message>
        <source>must not be exceeded: wind of %1 is forecast for %3 UTC, limit %2</source>
        <translation>må ikke overskrides: det er varslet vind på %1 kl. %3 UTC, grense %2</translation>
    </message>
    <message>
        <source>must not be exceeded: gusts of %1 are forecast for %3 UTC, limit %2</source>
        <translation>må ikke overskrides: det er varslet vindkast på %1 kl. %3 UTC, grense %2</translation>
    </message>
    <message>
        <source>visibility of %1 is forecast for %3 UTC, limit %2</source>
        <translation>det er varslet sikt på %1 kl. %3 UTC, grense %2</translation>
    </message>
    <message>
        <source>a cloud base of %1 is forecast for %3 UTC, limit %2</source>
        <translation>det er varslet skybase på %1 kl. %3 UTC, grense %2</translation>
    </message>
    <message>
        <source>icing is forecast at its altitude for %1 UTC, in which the UAV must not be flown</source>
        <translation>det er varslet ising i UAV-ens høyde kl. %1 UTC, og den skal ikke fly i ising</translation>
    </message>
    <message>
        <source>is nearly reached: %1 is forecast for %3 UTC, limit %2</source>
        <translation>er nesten nådd: %1 er varslet kl. %3 UTC, grense %2</translation>
    </message>
    <message>
        <source>cannot be checked from %1 UTC on, because the forecast does not give a value</source>
        <translation>kan ikke kontrolleres fra kl. %1 UTC, fordi varselet mangler verdien</translation>
    </message>
    <message>
        <source>cannot be checked without a forecast that gives this quantity</source>
        <translation>kan ikke kontrolleres uten et varsel som gir denne størrelsen</translation>
    </message>
</context>
<context>
    <name>LinkText</name>
    <message>
        <source>Mission</source>
        <translation>Oppdrag</translation>
    </message>
    <message>
        <source>Fence</source>
        <translation>Gjerde</translation>
    </message>
    <message>
        <source>Rally points</source>
        <translation>Samlingspunkter</translation>
    </message>
    <message>
        <source>the aircraft does not answer</source>
        <translation>luftfartøyet svarer ikke</translation>
    </message>
    <message>
        <source>the aircraft stopped answering at item %1</source>
        <translation>luftfartøyet sluttet å svare ved punkt %1</translation>
    </message>
    <message>
        <source>the aircraft refuses it (result %1)</source>
        <translation>luftfartøyet avviser det (resultat %1)</translation>
    </message>
    <message>
        <source>the aircraft requests an item that does not exist</source>
        <translation>luftfartøyet ber om et punkt som ikke finnes</translation>
    </message>
    <message>
        <source>the aircraft announces too many items</source>
        <translation>luftfartøyet melder for mange punkter</translation>
    </message>
    <message>
        <source>the numbers of items differ</source>
        <translation>antallet punkter er ulikt</translation>
    </message>
    <message>
        <source>item %1, %2</source>
        <translation>punkt %1, %2</translation>
    </message>
    <message>
        <source>Aircraft %1</source>
        <translation>Luftfartøy %1</translation>
    </message>
    <message>
        <source>Opening the link…</source>
        <translation>Åpner forbindelsen…</translation>
    </message>
    <message>
        <source>Listening</source>
        <translation>Lytter</translation>
    </message>
    <message>
        <source>No link: %1</source>
        <translation>Ingen forbindelse: %1</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>for %1 siden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
    <message>
        <source>%1: uploading, %2</source>
        <translation>%1: laster opp, %2</translation>
    </message>
    <message>
        <source>%1: reading back, %2</source>
        <translation>%1: leser tilbake, %2</translation>
    </message>
    <message>
        <source>On board: same as the plan</source>
        <translation>Om bord: samme som planen</translation>
    </message>
    <message>
        <source>On board: same as the plan. The aircraft has no rally points</source>
        <translation>Om bord: samme som planen. Luftfartøyet har ingen samlingspunkter</translation>
    </message>
    <message>
        <source>On board differs. %1: %2</source>
        <translation>Om bord avviker. %1: %2</translation>
    </message>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1 mislyktes: %2</translation>
    </message>
    <message>
        <source>heard for the first time</source>
        <translation>hørt for første gang</translation>
    </message>
    <message>
        <source>contact lost</source>
        <translation>kontakten er tapt</translation>
    </message>
    <message>
        <source>contact again</source>
        <translation>kontakt igjen</translation>
    </message>
    <message>
        <source>mode %1</source>
        <translation>modus %1</translation>
    </message>
    <message>
        <source>item %1 reached</source>
        <translation>punkt %1 nådd</translation>
    </message>
    <message>
        <source>a command was not answered</source>
        <translation>en kommando ble ikke besvart</translation>
    </message>
    <message>
        <source>command accepted</source>
        <translation>kommando godtatt</translation>
    </message>
    <message>
        <source>command refused (result %1)</source>
        <translation>kommando avvist (resultat %1)</translation>
    </message>
    <message>
        <source>Another ground station uses the same id: sending is off</source>
        <translation>En annen bakkestasjon bruker samme id: sending er av</translation>
    </message>
    <message>
        <source>Waiting for guided mode</source>
        <translation>Venter på ledet modus</translation>
    </message>
    <message>
        <source>Waiting until the mission is flown</source>
        <translation>Venter til oppdraget flys</translation>
    </message>
    <message>
        <source>Guiding from iceberg to iceberg</source>
        <translation>Leder fra isfjell til isfjell</translation>
    </message>
    <message>
        <source>Replacing the mission when the plan changes</source>
        <translation>Erstatter oppdraget når planen endres</translation>
    </message>
    <message>
        <source>The pilot has taken over: nothing is sent</source>
        <translation>Piloten har overtatt: ingenting sendes</translation>
    </message>
    <message>
        <source>Tracker %1</source>
        <translation>Sporer %1</translation>
    </message>
    <message>
        <source>command</source>
        <translation>kommando</translation>
    </message>
    <message>
        <source>altitude reference</source>
        <translation>høydereferanse</translation>
    </message>
    <message>
        <source>latitude</source>
        <translation>breddegrad</translation>
    </message>
    <message>
        <source>longitude</source>
        <translation>lengdegrad</translation>
    </message>
    <message>
        <source>altitude</source>
        <translation>høyde</translation>
    </message>
    <message>
        <source>parameter %1</source>
        <translation>parameter %1</translation>
    </message>
    <message>
        <source>Guiding begins when the flight in this window follows the aircraft</source>
        <translation>Ledingen begynner når flygingen i dette vinduet følger luftfartøyet</translation>
    </message>
    <message>
        <source>Replacing the mission begins when the flight in this window follows the aircraft</source>
        <translation>Oppdraget erstattes først når flygingen i dette vinduet følger luftfartøyet</translation>
    </message>
    <message>
        <source>Radar target %1</source>
        <translation>Radarmål %1</translation>
    </message>
</context>
<context>
    <name>Main</name>
    <message>
        <source>Write map.png, zeta.png and sigma.png of a run, or of a scenario&apos;s complete run, into &lt;folder&gt;; with --theme both also map-dark.png, zeta-dark.png and sigma-dark.png.</source>
        <translation>Skriv map.png, zeta.png og sigma.png av en flyging, eller av hele flygingen av et scenario, i &lt;mappe&gt;; med --theme both også map-dark.png, zeta-dark.png og sigma-dark.png.</translation>
    </message>
    <message>
        <source>Overwrite existing files.</source>
        <translation>Overskriv filer som finnes.</translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation>Det er ikke nok minne.</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>mappe</translation>
    </message>
    <message>
        <source>Size of each picture in pixels, e.g. 1920x1080 (default: 1600x1000 for the map, 1600x700 for the charts).</source>
        <translation>Størrelsen på hvert bilde i piksler, f.eks. 1920x1080 (standard: 1600x1000 for kartet, 1600x700 for diagrammene).</translation>
    </message>
    <message>
        <source>WxH</source>
        <comment>width x height</comment>
        <translation>BxH</translation>
    </message>
    <message>
        <source>Appearance of the pictures: light, dark or both.</source>
        <translation>Utseendet på bildene: light (lyst), dark (mørkt) eller both (begge).</translation>
    </message>
    <message>
        <source>theme</source>
        <translation>tema</translation>
    </message>
    <message>
        <source>--size: &quot;%1&quot; is not a size like 1920x1080 with sides from %2 to %3 pixels.</source>
        <translation>--size: «%1» er ikke en størrelse som 1920x1080 med sider fra %2 til %3 piksler.</translation>
    </message>
    <message>
        <source>--theme: &quot;%1&quot; is not light, dark or both.</source>
        <translation>--theme: «%1» er verken light, dark eller both.</translation>
    </message>
    <message>
        <source>--pictures: the name of a folder is missing.</source>
        <translation>--pictures: navnet på en mappe mangler.</translation>
    </message>
    <message>
        <source>Opens the window with a scenario; with --pictures it only writes pictures.</source>
        <translation>Åpner vinduet med et scenario; med --pictures skriver programmet bare bilder.</translation>
    </message>
    <message>
        <source>file</source>
        <translation>fil</translation>
    </message>
    <message>
        <source>Name one run or scenario file; %1 were named.</source>
        <translation>Oppgi én flyge- eller scenariofil; %1 ble oppgitt.</translation>
    </message>
    <message>
        <source>Bergwatch has crashed: %1</source>
        <translation>Bergwatch har krasjet: %1</translation>
    </message>
    <message>
        <source>Write a picture of the window with the scenario to &lt;file&gt;, then exit.</source>
        <translation>Skriv et bilde av vinduet med scenarioet til &lt;fil&gt;, og avslutt.</translation>
    </message>
    <message>
        <source>Fly until this time before the screenshot.</source>
        <translation>Fly til dette tidspunktet før skjermbildet.</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>sekunder</translation>
    </message>
    <message>
        <source>Store settings in &lt;file&gt; instead of your own settings file.</source>
        <translation>Lagre innstillinger i &lt;fil&gt; i stedet for din egen innstillingsfil.</translation>
    </message>
    <message>
        <source>--size: &quot;%1&quot; is not a size like 1920x1080.</source>
        <translation>--size: «%1» er ikke en størrelse som 1920x1080.</translation>
    </message>
    <message>
        <source>--theme: &quot;%1&quot; is not light or dark.</source>
        <translation>--theme: «%1» er verken light eller dark.</translation>
    </message>
    <message>
        <source>--at: &quot;%1&quot; is not a number of seconds.</source>
        <translation>--at: «%1» er ikke et antall sekunder.</translation>
    </message>
    <message>
        <source>Name at most one scenario file; %1 were named.</source>
        <translation>Oppgi høyst én scenariofil; %1 ble oppgitt.</translation>
    </message>
    <message>
        <source>The command &quot;export&quot; writes plans and flights as files, maps, charts and briefs: see &quot;bergwatch export --help&quot;.</source>
        <translation>Kommandoen «export» skriver planer og flyginger som filer, kart, diagrammer og flygeark: se «bergwatch export --help».</translation>
    </message>
    <message>
        <source>Write the manual as web pages and as PDF into &lt;folder&gt;, which has its pictures.</source>
        <translation>Skriv håndboken som nettsider og som PDF i &lt;mappe&gt;, der bildene ligger.</translation>
    </message>
    <message>
        <source>--manual takes no scenario file, --pictures or --screenshot.</source>
        <translation>--manual godtar verken scenariofil, --pictures eller --screenshot.</translation>
    </message>
    <message>
        <source>Longest wait before the screenshot for predictions and the lower bound, in seconds.</source>
        <translation>Lengste ventetid før skjermbildet på forutsigelser og nedre grense, i sekunder.</translation>
    </message>
    <message>
        <source>--wait: &quot;%1&quot; is not a number of seconds up to %2.</source>
        <translation>--wait: «%1» er ikke et antall sekunder opp til %2.</translation>
    </message>
    <message>
        <source>A scenario (.berg), run (.bergrun), study (.bergstudy) or telemetry log (.tlog).</source>
        <translation>Et scenario (.berg), en flyging (.bergrun), en studie (.bergstudy) eller en telemetrilogg (.tlog).</translation>
    </message>
</context>
<context>
    <name>ManualPages</name>
    <message>
        <source>Contents</source>
        <translation>Innhold</translation>
    </message>
    <message>
        <source>The Bergwatch manual</source>
        <translation>Håndbok for Bergwatch</translation>
    </message>
</context>
<context>
    <name>ManualText</name>
    <message>
        <source>en</source>
        <comment>folder of the manual in this language</comment>
        <translation>nb</translation>
    </message>
</context>
<context>
    <name>MapEdits</name>
    <message numerus="yes">
        <source>Delete %n icebergs</source>
        <translation>
            <numerusform>Slett isfjell</numerusform>
            <numerusform>Slett %n isfjell</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n objects</source>
        <translation>
            <numerusform>Slett %n objekt</numerusform>
            <numerusform>Slett %n objekter</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove asset</source>
        <translation>Fjern objektet</translation>
    </message>
    <message>
        <source>Remove area</source>
        <translation>Fjern området</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n icebergs</source>
        <translation>
            <numerusform>Klipp ut isfjell</numerusform>
            <numerusform>Klipp ut %n isfjell</numerusform>
        </translation>
    </message>
    <message>
        <source>There are no icebergs on the clipboard.</source>
        <translation>Det er ingen isfjell på utklippstavlen.</translation>
    </message>
    <message>
        <source>The clipboard content cannot be pasted. %1</source>
        <translation>Innholdet på utklippstavlen kan ikke limes inn. %1</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n icebergs</source>
        <translation>
            <numerusform>Lim inn isfjell</numerusform>
            <numerusform>Lim inn %n isfjell</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n icebergs</source>
        <translation>
            <numerusform>Dupliser isfjell</numerusform>
            <numerusform>Dupliser %n isfjell</numerusform>
        </translation>
    </message>
    <message>
        <source>Add iceberg</source>
        <translation>Legg til isfjell</translation>
    </message>
    <message>
        <source>Delete UAV</source>
        <translation>Slett UAV</translation>
    </message>
    <message>
        <source>The last UAV cannot be deleted: a scenario needs at least one.</source>
        <translation>Den siste UAV-en kan ikke slettes: et scenario trenger minst én.</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n UAVs</source>
        <translation>
            <numerusform>Dupliser UAV</numerusform>
            <numerusform>Dupliser %n UAV-er</numerusform>
        </translation>
    </message>
    <message>
        <source>Add UAV</source>
        <translation>Legg til UAV</translation>
    </message>
    <message>
        <source>Remove no-fly area</source>
        <translation>Fjern flyforbudsområdet</translation>
    </message>
</context>
<context>
    <name>MapLayoutText</name>
    <message>
        <source>lost</source>
        <translation>tapt</translation>
    </message>
    <message>
        <source>given up</source>
        <translation>oppgitt</translation>
    </message>
</context>
<context>
    <name>MapLegend</name>
    <message>
        <source>In view now: σ is 0</source>
        <translation>I syne nå: σ er 0</translation>
    </message>
    <message>
        <source>Plan, next leg thicker</source>
        <translation>Plan, neste etappe tykkere</translation>
    </message>
    <message>
        <source>Flown, older parts fainter</source>
        <translation>Fløyet, eldre deler svakere</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Synsfelt</translation>
    </message>
    <message>
        <source>Drift in %1</source>
        <translation>Drift på %1</translation>
    </message>
    <message>
        <source>Uncertainty σ</source>
        <translation>Usikkerhet σ</translation>
    </message>
    <message>
        <source>Appears later, with time</source>
        <translation>Dukker opp senere, med tidspunkt</translation>
    </message>
    <message>
        <source>Compared: %1</source>
        <translation>Sammenlignet: %1</translation>
    </message>
    <message>
        <source>Plan before the change</source>
        <translation>Planen før endringen</translation>
    </message>
    <message>
        <source>Seen so far</source>
        <translation>Sett hittil</translation>
    </message>
    <message>
        <source>In view</source>
        <translation>I syne</translation>
    </message>
    <message>
        <source>Appears later</source>
        <translation>Dukker opp senere</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Rute</translation>
    </message>
    <message>
        <source>Point aimed at</source>
        <translation>Punkt det siktes mot</translation>
    </message>
    <message>
        <source>Aim point</source>
        <translation>Siktepunkt</translation>
    </message>
    <message>
        <source>Former plan</source>
        <translation>Forrige plan</translation>
    </message>
    <message>
        <source>Flown</source>
        <translation>Fløyet</translation>
    </message>
    <message>
        <source>In view now</source>
        <translation>I syne nå</translation>
    </message>
    <message>
        <source>Lost: not found where expected</source>
        <translation>Tapt: ikke funnet der det var ventet</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Tapt</translation>
    </message>
    <message>
        <source>Search given up</source>
        <translation>Letingen er oppgitt</translation>
    </message>
    <message>
        <source>Given up</source>
        <translation>Oppgitt</translation>
    </message>
    <message>
        <source>95 % position circle</source>
        <translation>95 %-posisjonssirkel</translation>
    </message>
    <message>
        <source>95 % circle</source>
        <translation>95 %-sirkel</translation>
    </message>
    <message>
        <source>True position</source>
        <translation>Sann posisjon</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>Sannhet</translation>
    </message>
    <message>
        <source>Will enter inner ring</source>
        <translation>Kommer inn i indre ring</translation>
    </message>
    <message>
        <source>Enters ring</source>
        <translation>Inn i ring</translation>
    </message>
    <message>
        <source>Planned as one point</source>
        <translation>Planlagt som ett punkt</translation>
    </message>
    <message>
        <source>One point</source>
        <translation>Ett punkt</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Hjem</translation>
    </message>
    <message>
        <source>Geofence (kept if the UAV starts inside it)</source>
        <translation>Geogjerde (holdes hvis UAV-en starter innenfor)</translation>
    </message>
    <message>
        <source>Geofence</source>
        <translation>Geogjerde</translation>
    </message>
    <message>
        <source>Asset&apos;s range: more urgent inside</source>
        <translation>Objektets rekkevidde: haster mer</translation>
    </message>
    <message>
        <source>Asset&apos;s range</source>
        <translation>Rekkevidde</translation>
    </message>
    <message>
        <source>Inner ring: alarm</source>
        <translation>Indre ring: alarm</translation>
    </message>
    <message>
        <source>Inner ring</source>
        <translation>Indre ring</translation>
    </message>
    <message>
        <source>Search pattern</source>
        <translation>Letemønster</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Leting</translation>
    </message>
    <message>
        <source>UAVs too close to each other</source>
        <translation>UAV-er for nær hverandre</translation>
    </message>
    <message>
        <source>Too close</source>
        <translation>For nær</translation>
    </message>
    <message>
        <source>Assigned to the UAV of this colour</source>
        <translation>Tildelt UAV-en med denne fargen</translation>
    </message>
    <message>
        <source>Assigned to one</source>
        <translation>Tildelt én</translation>
    </message>
    <message>
        <source>Point of no return</source>
        <translation>Siste vendepunkt</translation>
    </message>
    <message>
        <source>Radio range of the ground station</source>
        <translation>Bakkestasjonens rekkevidde</translation>
    </message>
    <message>
        <source>Radio range</source>
        <translation>Radiorekkevidde</translation>
    </message>
    <message>
        <source>No-fly area</source>
        <translation>Flyforbudsområde</translation>
    </message>
    <message>
        <source>Stand-off round the asset</source>
        <translation>Sikkerhetsavstand rundt objektet</translation>
    </message>
    <message>
        <source>Stand-off</source>
        <translation>Sikkerhetsavstand</translation>
    </message>
    <message>
        <source>Close together: dot or number</source>
        <translation>Tett sammen: prikk, eller hvor mange</translation>
    </message>
    <message>
        <source>Close together</source>
        <translation>Tett sammen</translation>
    </message>
    <message>
        <source>Place to search, probability of finding</source>
        <translation>Sted å lete, sannsynlighet for funn</translation>
    </message>
    <message>
        <source>Place to search</source>
        <translation>Sted å lete</translation>
    </message>
    <message>
        <source>Airspace, for information</source>
        <translation>Luftrom, til opplysning</translation>
    </message>
    <message>
        <source>Airspace</source>
        <translation>Luftrom</translation>
    </message>
    <message>
        <source>Flight geography, proposal</source>
        <translation>Flygeografi, forslag</translation>
    </message>
    <message>
        <source>Flight geography</source>
        <translation>Flygeografi</translation>
    </message>
    <message>
        <source>Contingency volume, proposal</source>
        <translation>Beredskapsvolum, forslag</translation>
    </message>
    <message>
        <source>Contingency</source>
        <translation>Beredskap</translation>
    </message>
    <message>
        <source>Ground-risk buffer, proposal</source>
        <translation>Bakkerisikobuffer, forslag</translation>
    </message>
    <message>
        <source>Risk buffer</source>
        <translation>Risikobuffer</translation>
    </message>
    <message>
        <source>Adjacent area, proposal</source>
        <translation>Tilstøtende område, forslag</translation>
    </message>
    <message>
        <source>Adjacent area</source>
        <translation>Tilstøtende område</translation>
    </message>
    <message>
        <source>Later visit in the plan</source>
        <translation>Senere besøk i planen</translation>
    </message>
    <message>
        <source>Later visit</source>
        <translation>Senere besøk</translation>
    </message>
    <message>
        <source>Later visits of the patrol</source>
        <translation>Senere besøk i patruljen</translation>
    </message>
    <message>
        <source>Patrol</source>
        <translation>Patrulje</translation>
    </message>
    <message>
        <source>Ice free</source>
        <translation>Isfritt</translation>
    </message>
    <message>
        <source>Open water</source>
        <translation>Åpent vann</translation>
    </message>
    <message>
        <source>Ice 1–3 tenths</source>
        <translation>Is 1–3 tideler</translation>
    </message>
    <message>
        <source>Ice 4–6 tenths</source>
        <translation>Is 4–6 tideler</translation>
    </message>
    <message>
        <source>Ice 7–8 tenths</source>
        <translation>Is 7–8 tideler</translation>
    </message>
    <message>
        <source>Ice 9–10 tenths</source>
        <translation>Is 9–10 tideler</translation>
    </message>
    <message>
        <source>Fast ice</source>
        <translation>Fastis</translation>
    </message>
    <message>
        <source>Ice, concentration unknown</source>
        <translation>Is, ukjent konsentrasjon</translation>
    </message>
    <message>
        <source>no date</source>
        <comment>ice chart</comment>
        <translation>uten dato</translation>
    </message>
    <message>
        <source>Old ice chart: %1</source>
        <translation>Gammelt iskart: %1</translation>
    </message>
    <message>
        <source>Ice chart: %1</source>
        <translation>Iskart: %1</translation>
    </message>
    <message>
        <source>Old ice chart</source>
        <translation>Gammelt iskart</translation>
    </message>
    <message>
        <source>Ice chart</source>
        <translation>Iskart</translation>
    </message>
    <message>
        <source>Forecast wind, full barb 10 kn</source>
        <translation>Varslet vind, hel strek 10 kn</translation>
    </message>
    <message>
        <source>Forecast wind</source>
        <translation>Varslet vind</translation>
    </message>
    <message>
        <source>Forecast current</source>
        <translation>Varslet strøm</translation>
    </message>
    <message>
        <source>Predicted drift, circle: 1 σ</source>
        <translation>Forventet drift, sirkel: 1 σ</translation>
    </message>
    <message>
        <source>Predicted drift</source>
        <translation>Forventet drift</translation>
    </message>
</context>
<context>
    <name>MapOverlays</name>
    <message>
        <source>N</source>
        <comment>north on the compass</comment>
        <translation>N</translation>
    </message>
</context>
<context>
    <name>MapPageText</name>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Zeta ζ</source>
        <translation>Zeta ζ</translation>
    </message>
    <message>
        <source>Visits, dots on the path</source>
        <translation>Besøk, prikker på veien</translation>
    </message>
    <message>
        <source>Longest flight</source>
        <translation>Lengste flyging</translation>
    </message>
    <message>
        <source>Flight time</source>
        <translation>Flygetid</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besøk</translation>
    </message>
    <message>
        <source>This sortie</source>
        <translation>Dette toktet</translation>
    </message>
</context>
<context>
    <name>MapTipText</name>
    <message>
        <source>drifting %1 towards %2</source>
        <translation>driver %1 mot %2</translation>
    </message>
    <message>
        <source>not drifting</source>
        <translation>driver ikke</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>name, uncertainty, drift</comment>
        <translation>%1: %2, %3</translation>
    </message>
    <message>
        <source>Ice concentration %1 tenths</source>
        <translation>Iskonsentrasjon %1 tideler</translation>
    </message>
    <message>
        <source>Ice concentration unknown</source>
        <translation>Ukjent iskonsentrasjon</translation>
    </message>
    <message>
        <source>, fast ice</source>
        <translation>, fastis</translation>
    </message>
    <message>
        <source>
On the chart: %1</source>
        <translation>
På kartet: %1</translation>
    </message>
</context>
<context>
    <name>MapTools</name>
    <message>
        <source>Drag to move the map, turn the wheel to zoom. Esc leaves the tool.</source>
        <translation>Dra for å flytte kartet, bruk hjulet til å zoome. Esc forlater verktøyet.</translation>
    </message>
    <message>
        <source>Move UAV</source>
        <translation>Flytt UAV</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects</source>
        <translation>
            <numerusform>Flytt %n objekt</numerusform>
            <numerusform>Flytt %n objekter</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n icebergs</source>
        <translation>
            <numerusform>Flytt isfjell</numerusform>
            <numerusform>Flytt %n isfjell</numerusform>
        </translation>
    </message>
    <message>
        <source>Move asset</source>
        <translation>Flytt objektet</translation>
    </message>
    <message>
        <source>Move area</source>
        <translation>Flytt området</translation>
    </message>
    <message>
        <source>Move no-fly area</source>
        <translation>Flytt flyforbudsområdet</translation>
    </message>
</context>
<context>
    <name>MapWorld</name>
    <message>
        <source>PNR</source>
        <translation>PNR</translation>
    </message>
</context>
<context>
    <name>MeasureTool</name>
    <message>
        <source>Total %1</source>
        <translation>Til sammen %1</translation>
    </message>
    <message>
        <source>Click to set the next point. Enter ends the line, Backspace removes a point, Esc clears.</source>
        <translation>Klikk for å sette neste punkt. Enter avslutter linjen, Slett bakover fjerner et punkt, Esc tømmer.</translation>
    </message>
    <message>
        <source>Click to start another line. Esc clears this one.</source>
        <translation>Klikk for å begynne en ny linje. Esc fjerner denne.</translation>
    </message>
    <message>
        <source>Click points to measure the path between them: geodesic length, true bearing, time of flight.</source>
        <translation>Klikk punkter for å måle veien mellom dem: geodetisk lengde, rettvisende peiling, flygetid.</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 ved %2</translation>
    </message>
    <message>
        <source>%1 at %2 in the wind</source>
        <translation>%1 ved %2 i vinden</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>MissionCharts</name>
    <message>
        <source>iceberg reached</source>
        <translation>isfjell nådd</translation>
    </message>
    <message>
        <source>Uncertainty now and accumulated</source>
        <translation>Usikkerhet nå og oppsamlet</translation>
    </message>
    <message>
        <source>Sum of σ, m²</source>
        <translation>Sum av σ, m²</translation>
    </message>
    <message>
        <source>Sum of σ</source>
        <translation>Sum av σ</translation>
    </message>
    <message>
        <source>Uncertainty of each iceberg</source>
        <translation>Usikkerheten til hvert isfjell</translation>
    </message>
    <message>
        <source>σ, m²</source>
        <translation>σ, m²</translation>
    </message>
    <message>
        <source>Nothing flown yet. Press Space to fly the plan</source>
        <translation>Ingenting fløyet ennå. Trykk mellomrom for å fly planen</translation>
    </message>
    <message>
        <source>m²</source>
        <translation>m²</translation>
    </message>
    <message>
        <source>m² s</source>
        <translation>m² s</translation>
    </message>
    <message>
        <source>Zeta</source>
        <translation>Zeta-kurve</translation>
    </message>
    <message>
        <source>Rate of zeta, now and on average</source>
        <translation>Zetas vekst, nå og i gjennomsnitt</translation>
    </message>
    <message>
        <source>Sum of σ = dζ/dt, m²</source>
        <translation>Sum av σ = dζ/dt, m²</translation>
    </message>
    <message>
        <source>Mean since take-off</source>
        <translation>Middel siden avgang</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Middel</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Nå</translation>
    </message>
    <message>
        <source>At %1 zeta grows by %2 m² s per second; the mean since take-off is %3.</source>
        <translation>Ved %1 vokser zeta med %2 m² s per sekund; gjennomsnittet siden avgang er %3.</translation>
    </message>
    <message>
        <source>Distance flown</source>
        <translation>Fløyet avstand</translation>
    </message>
    <message>
        <source>Flown</source>
        <translation>Fløyet</translation>
    </message>
    <message>
        <source>Distance flown until %1: %2.</source>
        <translation>Avstand fløyet til %1: %2.</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>Svinghastighet</translation>
    </message>
    <message>
        <source>Turn rate, °/s, positive to the left</source>
        <translation>Svinghastighet, °/s, positiv mot venstre</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>Limit %1 °/s</source>
        <translation>Grense %1 °/s</translation>
    </message>
    <message>
        <source>Cross-track error</source>
        <translation>Sideavvik</translation>
    </message>
    <message>
        <source>Cross-track error, m, positive to the left</source>
        <translation>Sideavvik, m, positivt mot venstre</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Zeta and sum of σ</source>
        <translation>Zeta og sum av σ</translation>
    </message>
    <message>
        <source>Rate of zeta</source>
        <translation>Zetas vekst</translation>
    </message>
    <message>
        <source>σ of each iceberg</source>
        <translation>σ for hvert isfjell</translation>
    </message>
    <message>
        <source>Distance through the air, %1</source>
        <translation>Avstand gjennom luften, %1</translation>
    </message>
    <message>
        <source>Lower bound on ζ</source>
        <translation>Nedre grense for ζ</translation>
    </message>
    <message>
        <source>Weighted</source>
        <translation>Vektet</translation>
    </message>
    <message>
        <source>Weighted by priority</source>
        <translation>Vektet etter prioritet</translation>
    </message>
    <message>
        <source>Weighted by priority the sum is %1 m².</source>
        <translation>Vektet etter prioritet er summen %1 m².</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Alle %1</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Turn rate at %1: %2; limit: %3.</source>
        <translation>Svinghastighet ved %1: %2; grense: %3.</translation>
    </message>
    <message>
        <source>Cross-track error at %1: %2.</source>
        <translation>Sideavvik ved %1: %2.</translation>
    </message>
    <message>
        <source>Zeta %1</source>
        <translation>Zeta %1</translation>
    </message>
    <message>
        <source>At %1 zeta is %2 and the sum of σ %3 m².</source>
        <translation>Ved %1 er zeta %2 og summen av σ %3 m².</translation>
    </message>
    <message numerus="yes">
        <source>At %1 the most uncertain iceberg is %2: %3; %n in view.</source>
        <translation>
            <numerusform>Ved %1 er det mest usikre isfjellet %2: %3; %n i syne.</numerusform>
            <numerusform>Ved %1 er det mest usikre isfjellet %2: %3; %n i syne.</numerusform>
        </translation>
    </message>
    <message>
        <source>Zeta ζ, %1</source>
        <translation>Zeta ζ, %1</translation>
    </message>
    <message>
        <source>Wind and current</source>
        <translation>Vind og strøm</translation>
    </message>
</context>
<context>
    <name>MissionClockText</name>
    <message>
        <source>in %1</source>
        <translation>om %1</translation>
    </message>
    <message>
        <source>%1 UTC
%2 local time (%3)
%4 after the start</source>
        <translation>%1 UTC
%2 lokal tid (%3)
%4 etter start</translation>
    </message>
</context>
<context>
    <name>MissionPicture</name>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Zeta ζ</source>
        <translation>Zeta ζ</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besøk</translation>
    </message>
    <message>
        <source>No icebergs yet</source>
        <translation>Ingen isfjell ennå</translation>
    </message>
    <message>
        <source>Add icebergs with their positions to the scenario file, then draw the map again.</source>
        <translation>Legg isfjell med posisjoner inn i scenariofilen, og tegn kartet på nytt.</translation>
    </message>
    <message>
        <source>Closest so far</source>
        <translation>Nærmest hittil</translation>
    </message>
    <message>
        <source>Above the reserve</source>
        <translation>Over reserven</translation>
    </message>
    <message>
        <source>if home now</source>
        <translation>hvis hjem nå</translation>
    </message>
    <message>
        <source>Until the reserve</source>
        <translation>Til reserven</translation>
    </message>
</context>
<context>
    <name>MissionSeriesText</name>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
</context>
<context>
    <name>OperationPage</name>
    <message>
        <source>Largest speed over ground</source>
        <translation>Største fart over grunnen</translation>
    </message>
    <message>
        <source>Flight geography, height</source>
        <translation>Flygeografi, høyde</translation>
    </message>
    <message>
        <source>Contingency volume, height</source>
        <translation>Beredskapsvolum, høyde</translation>
    </message>
    <message>
        <source>Contingency volume, width</source>
        <translation>Beredskapsvolum, bredde</translation>
    </message>
    <message>
        <source>Ground-risk buffer, width</source>
        <translation>Bakkerisikobuffer, bredde</translation>
    </message>
    <message>
        <source>Adjacent area, width</source>
        <translation>Tilstøtende område, bredde</translation>
    </message>
    <message>
        <source>Flight geography: inside the geofence.</source>
        <translation>Flygeografi: innsiden av geogjerdet.</translation>
    </message>
    <message>
        <source>Flight geography: all places that a plan may reach, plus a margin of %1 m.</source>
        <translation>Flygeografi: alle steder som en plan kan nå, pluss en margin på %1 m.</translation>
    </message>
    <message>
        <source>Formulas and default constants: Digisky calculator 3.3.0, based on the guide of the Swiss FOCA; not an authority&apos;s own text.</source>
        <translation>Formler og standardverdier: kalkulatoren Digisky 3.3.0, etter veiledningen fra sveitsiske FOCA; ikke en myndighets egen tekst.</translation>
    </message>
    <message>
        <source>The outlines are in the KML, KMZ and GeoJSON exports.</source>
        <translation>Omrissene er i eksportene til KML, KMZ og GeoJSON.</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>UAV</translation>
    </message>
    <message>
        <source>Endurance</source>
        <translation>Utholdenhet</translation>
    </message>
    <message>
        <source>Reserve</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>Wind limit</source>
        <translation>Vindgrense</translation>
    </message>
    <message>
        <source>Gust limit</source>
        <translation>Vindkastgrense</translation>
    </message>
    <message>
        <source>Icing conditions</source>
        <translation>Isingsforhold</translation>
    </message>
    <message>
        <source>flown in</source>
        <translation>kan flys</translation>
    </message>
    <message>
        <source>not flown in</source>
        <translation>flys ikke</translation>
    </message>
    <message>
        <source>Made by Bergwatch from the scenario. It does not imply that the operation may be flown.</source>
        <translation>Laget av Bergwatch ut fra scenarioet. Det betyr ikke at operasjonen kan flys.</translation>
    </message>
    <message>
        <source>Checklist</source>
        <translation>Sjekkliste</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>og %1 til</translation>
    </message>
    <message>
        <source>Operation volume: proposal, to be checked with your authority</source>
        <translation>Operasjonsvolum: forslag, som må avklares med myndigheten</translation>
    </message>
    <message>
        <source>Crew</source>
        <translation>Mannskap</translation>
    </message>
    <message>
        <source>Call sign</source>
        <translation>Kallesignal</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakter</translation>
    </message>
    <message>
        <source>Command link</source>
        <translation>Kommandolink</translation>
    </message>
    <message>
        <source>Date and signatures</source>
        <translation>Dato og underskrifter</translation>
    </message>
    <message>
        <source>Visibility limit</source>
        <translation>Siktgrense</translation>
    </message>
    <message>
        <source>Ceiling limit</source>
        <translation>Skybasegrense</translation>
    </message>
</context>
<context>
    <name>PageText</name>
    <message>
        <source>Untitled</source>
        <translation>Uten navn</translation>
    </message>
    <message>
        <source>First leg at %1</source>
        <translation>Første etappe ved %1</translation>
    </message>
    <message>
        <source>First leg</source>
        <translation>Første etappe</translation>
    </message>
    <message>
        <source>Planned order at %1</source>
        <translation>Planlagt rekkefølge ved %1</translation>
    </message>
    <message>
        <source>Planned order</source>
        <translation>Planlagt rekkefølge</translation>
    </message>
    <message>
        <source>Planned path with turns at %1</source>
        <translation>Planlagt bane med svinger ved %1</translation>
    </message>
    <message>
        <source>Planned path with turns</source>
        <translation>Planlagt bane med svinger</translation>
    </message>
    <message>
        <source>Flown until %1</source>
        <translation>Fløyet til %1</translation>
    </message>
    <message>
        <source>Start %1 UTC</source>
        <translation>Start %1 UTC</translation>
    </message>
</context>
<context>
    <name>PanelText</name>
    <message>
        <source>As opened</source>
        <translation>Som åpnet</translation>
    </message>
    <message>
        <source>Click a line to go to that state; the disk marks the saved one.</source>
        <translation>Klikk på en linje for å gå til den tilstanden; disketten merker den lagrede.</translation>
    </message>
    <message>
        <source>History of edits</source>
        <translation>Endringshistorikk</translation>
    </message>
</context>
<context>
    <name>PlaceText</name>
    <message>
        <source>Labrador Sea</source>
        <translation>Labradorhavet</translation>
    </message>
    <message>
        <source>Davis Strait</source>
        <translation>Davisstredet</translation>
    </message>
    <message>
        <source>Baffin Bay</source>
        <translation>Baffinbukta</translation>
    </message>
    <message>
        <source>Disko Bay</source>
        <translation>Diskobukta</translation>
    </message>
    <message>
        <source>Melville Bay</source>
        <translation>Melvillebukta</translation>
    </message>
    <message>
        <source>Cape York</source>
        <translation>Kapp York</translation>
    </message>
    <message>
        <source>Nares Strait</source>
        <translation>Naresstredet</translation>
    </message>
    <message>
        <source>Cape Farewell</source>
        <translation>Kapp Farvel</translation>
    </message>
    <message>
        <source>Denmark Strait</source>
        <translation>Danmarkstredet</translation>
    </message>
    <message>
        <source>Scoresby Sund</source>
        <translation>Scoresbysund</translation>
    </message>
    <message>
        <source>Fram Strait</source>
        <translation>Framstredet</translation>
    </message>
    <message>
        <source>Hinlopen Strait</source>
        <translation>Hinlopenstretet</translation>
    </message>
    <message>
        <source>Bear Island</source>
        <translation>Bjørnøya</translation>
    </message>
    <message>
        <source>Barents Sea</source>
        <translation>Barentshavet</translation>
    </message>
    <message>
        <source>Franz Josef Land</source>
        <translation>Frans Josefs land</translation>
    </message>
    <message>
        <source>Novaya Zemlya</source>
        <translation>Novaja Semlja</translation>
    </message>
    <message>
        <source>Kara Sea</source>
        <translation>Karahavet</translation>
    </message>
    <message>
        <source>Laptev Sea</source>
        <translation>Laptevhavet</translation>
    </message>
    <message>
        <source>Bering Strait</source>
        <translation>Beringstredet</translation>
    </message>
    <message>
        <source>Beaufort Sea</source>
        <translation>Beauforthavet</translation>
    </message>
    <message>
        <source>North Pole</source>
        <translation>Nordpolen</translation>
    </message>
    <message>
        <source>Drake Passage</source>
        <translation>Drakestredet</translation>
    </message>
    <message>
        <source>South Georgia</source>
        <translation>Sør-Georgia</translation>
    </message>
    <message>
        <source>Weddell Sea</source>
        <translation>Weddellhavet</translation>
    </message>
    <message>
        <source>Amery Ice Shelf</source>
        <translation>Ameryisbremmen</translation>
    </message>
    <message>
        <source>Ross Sea</source>
        <translation>Rosshavet</translation>
    </message>
    <message>
        <source>McMurdo Sound</source>
        <translation>McMurdosundet</translation>
    </message>
    <message>
        <source>South Pole</source>
        <translation>Sydpolen</translation>
    </message>
    <message>
        <source>No known place has this name, and it is not a coordinate.</source>
        <translation>Ingen sted med dette navnet finnes her, og det er ingen koordinat.</translation>
    </message>
    <message>
        <source>Several places have this name.</source>
        <translation>Flere steder heter noe slikt.</translation>
    </message>
    <message>
        <source>Enter a coordinate or a place name.</source>
        <translation>En koordinat eller navnet på et sted trengs.</translation>
    </message>
    <message>
        <source>This is not a coordinate. Examples: 47° 03.2′ N 48° 06′ W, or 47.05 -48.1.</source>
        <translation>Dette er ingen koordinat. Slik som 47° 03,2′ N 48° 06′ V, eller 47,05 -48,1.</translation>
    </message>
    <message>
        <source>This is half a coordinate. Enter latitude and longitude.</source>
        <translation>Dette er en halv koordinat: både bredde og lengde trengs.</translation>
    </message>
    <message>
        <source>This coordinate is ambiguous. Add spaces and the letters N, S, E or W.</source>
        <translation>Dette kan leses på flere måter. Mellomrom og bokstavene N, S, Ø og V gjør det klart.</translation>
    </message>
    <message>
        <source>Only one half states its hemisphere. Add N, S, E or W to the other.</source>
        <translation>Bare den ene halvdelen sier hvilken halvkule den er på. Legg til N, S, Ø eller V på den andre.</translation>
    </message>
    <message>
        <source>Use a sign or a hemisphere letter, not both.</source>
        <translation>Enten et fortegn eller en bokstav sier hvilken halvkule, ikke begge.</translation>
    </message>
    <message>
        <source>Enter one latitude and one longitude.</source>
        <translation>Én bredde og én lengde trengs, ikke to av samme slag.</translation>
    </message>
    <message>
        <source>Minutes and seconds must be below 60.</source>
        <translation>Minutter og sekunder er mindre enn 60.</translation>
    </message>
    <message>
        <source>Latitude must be between 90° S and 90° N.</source>
        <translation>Bredder går fra 90° S til 90° N.</translation>
    </message>
    <message>
        <source>Longitude must be between 180° W and 180° E.</source>
        <translation>Lengder går fra 180° V til 180° Ø.</translation>
    </message>
    <message>
        <source>This position does not exist on the UTM or MGRS grid.</source>
        <translation>Det finnes ikke noe slikt sted i rutenettet UTM eller MGRS.</translation>
    </message>
    <message>
        <source>This is a longitude. Enter a latitude.</source>
        <translation>Dette er en lengde, det trengs en bredde.</translation>
    </message>
    <message>
        <source>This is a latitude. Enter a longitude.</source>
        <translation>Dette er en bredde, det trengs en lengde.</translation>
    </message>
    <message>
        <source>This is %1 from the scenario&apos;s origin; the limit is %2.</source>
        <translation>Dette er %1 fra scenarioets origo; scenarioet rekker %2.</translation>
    </message>
    <message>
        <source>Enter one angle only: a whole coordinate would move all of them to one place.</source>
        <translation>Skriv én vinkel: en hel koordinat ville sette alle på ett sted.</translation>
    </message>
    <message>
        <source>Amundsen Sea</source>
        <translation>Amundsenhavet</translation>
    </message>
    <message>
        <source>Antarctic Peninsula</source>
        <translation>Antarktishalvøya</translation>
    </message>
    <message>
        <source>Baffin Island</source>
        <translation>Baffinøya</translation>
    </message>
    <message>
        <source>Bellingshausen Sea</source>
        <translation>Bellingshausenhavet</translation>
    </message>
    <message>
        <source>Bering Sea</source>
        <translation>Beringhavet</translation>
    </message>
    <message>
        <source>Bransfield Strait</source>
        <translation>Bransfieldstredet</translation>
    </message>
    <message>
        <source>Cape Horn</source>
        <translation>Kapp Horn</translation>
    </message>
    <message>
        <source>Chukchi Sea</source>
        <translation>Tsjuktsjerhavet</translation>
    </message>
    <message>
        <source>East Siberian Sea</source>
        <translation>Østsibirhavet</translation>
    </message>
    <message>
        <source>Ellesmere Island</source>
        <translation>Ellesmereøya</translation>
    </message>
    <message>
        <source>Falkland Islands</source>
        <translation>Falklandsøyene</translation>
    </message>
    <message>
        <source>Greenland</source>
        <translation>Grønland</translation>
    </message>
    <message>
        <source>Greenland Sea</source>
        <translation>Grønlandshavet</translation>
    </message>
    <message>
        <source>Gulf of St. Lawrence</source>
        <translation>St. Lawrencegulfen</translation>
    </message>
    <message>
        <source>Hudson Bay</source>
        <translation>Hudsonbukta</translation>
    </message>
    <message>
        <source>Hudson Strait</source>
        <translation>Hudsonstredet</translation>
    </message>
    <message>
        <source>Iceland</source>
        <translation>Island</translation>
    </message>
    <message>
        <source>Iceland Sea</source>
        <translation>Islandshavet</translation>
    </message>
    <message>
        <source>Irminger Sea</source>
        <translation>Irmingerhavet</translation>
    </message>
    <message>
        <source>Lancaster Sound</source>
        <translation>Lancastersundet</translation>
    </message>
    <message>
        <source>Lincoln Sea</source>
        <translation>Lincolnhavet</translation>
    </message>
    <message>
        <source>New Siberian Islands</source>
        <translation>Nysibirøyene</translation>
    </message>
    <message>
        <source>Newfoundland</source>
        <translation>Newfoundland</translation>
    </message>
    <message>
        <source>North Cape</source>
        <translation>Nordkapp</translation>
    </message>
    <message>
        <source>North Sea</source>
        <translation>Nordsjøen</translation>
    </message>
    <message>
        <source>Norwegian Sea</source>
        <translation>Norskehavet</translation>
    </message>
    <message>
        <source>Scotia Sea</source>
        <translation>Scotiahavet</translation>
    </message>
    <message>
        <source>Severnaya Zemlya</source>
        <translation>Severnaja Semlja</translation>
    </message>
    <message>
        <source>South Orkney Islands</source>
        <translation>Sør-Orknøyene</translation>
    </message>
    <message>
        <source>South Shetland Islands</source>
        <translation>Sør-Shetlandsøyene</translation>
    </message>
    <message>
        <source>Strait of Belle Isle</source>
        <translation>Belle Isle-stredet</translation>
    </message>
    <message>
        <source>White Sea</source>
        <translation>Kvitsjøen</translation>
    </message>
    <message>
        <source>Wrangel Island</source>
        <translation>Wrangeløya</translation>
    </message>
</context>
<context>
    <name>PlacingTools</name>
    <message>
        <source>Add iceberg</source>
        <translation>Legg til isfjell</translation>
    </message>
    <message>
        <source>Change drift</source>
        <translation>Endre drift</translation>
    </message>
    <message>
        <source>Click to add an iceberg; drag to set its drift. Esc leaves the tool.</source>
        <translation>Klikk for å legge til et isfjell, dra for å sette driften. Esc forlater verktøyet.</translation>
    </message>
    <message>
        <source>Place UAV</source>
        <translation>Plasser UAV</translation>
    </message>
    <message>
        <source>Release to keep this heading. Esc cancels.</source>
        <translation>Slipp for å beholde denne kursen. Esc avbryter.</translation>
    </message>
    <message>
        <source>Move asset</source>
        <translation>Flytt objektet</translation>
    </message>
    <message>
        <source>Place asset</source>
        <translation>Plasser objektet</translation>
    </message>
    <message>
        <source>Release to place it here. Esc cancels.</source>
        <translation>Slipp for å plassere det her. Esc avbryter.</translation>
    </message>
    <message>
        <source>Click to move the asset here. Esc leaves the tool.</source>
        <translation>Klikk for å flytte objektet hit. Esc forlater verktøyet.</translation>
    </message>
    <message>
        <source>Click to place the protected asset. Esc leaves the tool.</source>
        <translation>Klikk for å plassere det beskyttede objektet. Esc forlater verktøyet.</translation>
    </message>
    <message>
        <source>Click to add an iceberg that appears here now; drag to set its drift. In flight this cannot be undone.</source>
        <translation>Klikk for å legge til et isfjell som dukker opp her nå, dra for å sette driften. Under flyging kan dette ikke angres.</translation>
    </message>
    <message>
        <source>Add UAV</source>
        <translation>Legg til UAV</translation>
    </message>
    <message>
        <source>Click to place the UAV; drag to set its heading. Ctrl+click adds another one. Esc leaves the tool.</source>
        <translation>Klikk for å plassere UAV-en, dra for å sette kursen. Ctrl+klikk legger til en ny. Esc forlater verktøyet.</translation>
    </message>
    <message>
        <source>Click to place %1; drag to set its heading. Ctrl+click adds another UAV. Esc leaves the tool.</source>
        <translation>Klikk for å plassere %1, dra for å sette kursen. Ctrl+klikk legger til en ny UAV. Esc forlater verktøyet.</translation>
    </message>
    <message>
        <source>Seen by %1.</source>
        <comment>source and its error</comment>
        <translation>Sett med %1.</translation>
    </message>
    <message>
        <source>The scenario has %1 icebergs, the most that are possible.</source>
        <translation>Scenarioet har %1 isfjell, flere er det ikke plass til.</translation>
    </message>
</context>
<context>
    <name>PlanText</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>exact</source>
        <comment>solver</comment>
        <translation>eksakt</translation>
    </message>
    <message>
        <source>search and bound</source>
        <comment>solver</comment>
        <translation>søk og grense</translation>
    </message>
    <message>
        <source>COIN-OR CBC</source>
        <comment>solver</comment>
        <translation>COIN-OR CBC</translation>
    </message>
    <message>
        <source>Solver: %1</source>
        <translation>Løser: %1</translation>
    </message>
    <message>
        <source>Status: %1</source>
        <translation>Tilstand: %1</translation>
    </message>
    <message>
        <source>Time: %1</source>
        <translation>Tid: %1</translation>
    </message>
    <message>
        <source>Objective: %1 m²</source>
        <translation>Målfunksjon: %1 m²</translation>
    </message>
    <message>
        <source>Lower bound: %1 m²</source>
        <translation>Nedre grense: %1 m²</translation>
    </message>
    <message>
        <source>Warm start from the previous plan</source>
        <translation>Startet fra forrige plan</translation>
    </message>
    <message>
        <source>Proven optimal, %1 (%2)</source>
        <translation>Bevist optimal, %1 (%2)</translation>
    </message>
    <message>
        <source>Best order so far, within %1 % of optimal</source>
        <translation>Beste rekkefølge så langt, innenfor %1 % av optimum</translation>
    </message>
    <message>
        <source>Best order so far</source>
        <translation>Beste rekkefølge så langt</translation>
    </message>
    <message>
        <source>Within %1 % of optimal, %2</source>
        <translation>Innenfor %1 % av optimum, %2</translation>
    </message>
    <message>
        <source>Best order found, %1</source>
        <translation>Beste rekkefølge funnet, %1</translation>
    </message>
    <message>
        <source>Planning…</source>
        <translation>Planlegger …</translation>
    </message>
    <message>
        <source>No plan yet</source>
        <translation>Ingen plan ennå</translation>
    </message>
    <message>
        <source>Nothing to visit now</source>
        <translation>Ingenting å besøke nå</translation>
    </message>
    <message>
        <source>Solver limit reached; flying to the nearest iceberg</source>
        <translation>Grensen for løseren er nådd; flyr til nærmeste isfjell</translation>
    </message>
    <message>
        <source>Solver limit reached; previous plan kept</source>
        <translation>Grensen for løseren er nådd; forrige plan er beholdt</translation>
    </message>
    <message>
        <source>Chosen one iceberg at a time</source>
        <translation>Valgt ett isfjell om gangen</translation>
    </message>
    <message>
        <source>Following the existing route</source>
        <translation>Følger den eksisterende ruten</translation>
    </message>
    <message>
        <source>under 1 ms</source>
        <translation>mindre enn 1 ms</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Predicted zeta: %1 m² s</source>
        <translation>Forutsagt zeta: %1 m² s</translation>
    </message>
    <message>
        <source>Objective: %1 m² s</source>
        <translation>Målfunksjon: %1 m² s</translation>
    </message>
    <message>
        <source>Lower bound: %1 m² s</source>
        <translation>Nedre grense: %1 m² s</translation>
    </message>
    <message>
        <source>by assignment</source>
        <comment>solver</comment>
        <translation>ved tilordning</translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>%n UAV</numerusform>
            <numerusform>%n UAV-er</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n isfjell</numerusform>
            <numerusform>%n isfjell</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Run complete</source>
        <translation>Flyging fullført</translation>
    </message>
    <message>
        <source>under 0.1 s</source>
        <translation>under 0,1 s</translation>
    </message>
    <message>
        <source>optimal</source>
        <comment>status</comment>
        <translation>optimal</translation>
    </message>
    <message>
        <source>not proven optimal</source>
        <comment>status</comment>
        <translation>ikke bevist optimal</translation>
    </message>
    <message>
        <source>no order found</source>
        <comment>status</comment>
        <translation>ingen rekkefølge funnet</translation>
    </message>
    <message>
        <source>No plan while the UAV returns, holds or is on the ground</source>
        <translation>Ingen plan mens UAV-en er på vei hjem, holder eller er på bakken</translation>
    </message>
    <message>
        <source>The wind is too strong to return home</source>
        <translation>Vinden er for sterk til å komme hjem</translation>
    </message>
    <message>
        <source>Home with %1 of the reserve used</source>
        <translation>Hjemme med %1 av reserven brukt</translation>
    </message>
    <message>
        <source>Home with %1 above the reserve</source>
        <translation>Hjemme med %1 over reserven</translation>
    </message>
    <message>
        <source>In 1 flight in 20 the wind is too strong to return home</source>
        <translation>I 1 av 20 flyginger er vinden for sterk til å komme hjem</translation>
    </message>
    <message>
        <source>1 flight in 20 uses %1 or more of the reserve</source>
        <translation>1 av 20 flyginger bruker %1 eller mer av reserven</translation>
    </message>
    <message>
        <source>1 flight in 20: %1 or less above the reserve</source>
        <translation>1 av 20 flyginger: %1 eller mindre over reserven</translation>
    </message>
    <message>
        <source>It follows from visit rates: how often icebergs can be visited.</source>
        <translation>Den følger av besøkshyppigheter: hvor ofte isfjell kan besøkes.</translation>
    </message>
    <message>
        <source>It follows from visit sequences: how soon icebergs can be visited one after the other.</source>
        <translation>Den følger av besøksrekkefølger: hvor raskt isfjell kan besøkes etter hverandre.</translation>
    </message>
    <message>
        <source>No plan while the UAV returns, is on the ground or holds. A new one is made when it resumes.</source>
        <translation>Ingen plan mens UAV-en er på vei hjem, på bakken eller holder. En ny plan lages når den fortsetter.</translation>
    </message>
</context>
<context>
    <name>PolicyText</name>
    <message>
        <source>Automatic</source>
        <translation>Automatisk</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Eksakt</translation>
    </message>
    <message>
        <source>COIN-OR CBC</source>
        <translation>COIN-OR CBC</translation>
    </message>
    <message>
        <source>Local search</source>
        <translation>Lokalsøk</translation>
    </message>
    <message>
        <source>One way</source>
        <comment>route</comment>
        <translation>Én vei</translation>
    </message>
    <message>
        <source>Round trip</source>
        <comment>route</comment>
        <translation>Rundtur</translation>
    </message>
</context>
<context>
    <name>QuantityText</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 km</source>
        <translation>%1 km</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 t</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 S</source>
        <comment>latitude</comment>
        <translation>%1 S</translation>
    </message>
    <message>
        <source>%1 N</source>
        <comment>latitude</comment>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 W</source>
        <comment>longitude</comment>
        <translation>%1 V</translation>
    </message>
    <message>
        <source>%1 E</source>
        <comment>longitude</comment>
        <translation>%1 Ø</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>nmi</source>
        <translation>nmi</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>km</source>
        <translation>km</translation>
    </message>
    <message>
        <source>kn</source>
        <translation>kn</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>nmi²</source>
        <translation>nmi²</translation>
    </message>
    <message>
        <source>km²</source>
        <translation>km²</translation>
    </message>
    <message>
        <source>%1 nmi</source>
        <translation>%1 nmi</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 til %2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>fra %1</translation>
    </message>
    <message>
        <source>at all heights</source>
        <translation>i alle høyder</translation>
    </message>
    <message>
        <source>%1 (%2 ft)</source>
        <translation>%1 (%2 fot)</translation>
    </message>
    <message>
        <source>not home</source>
        <translation>ikke hjemme</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>fot</translation>
    </message>
    <message>
        <source>%1 ft</source>
        <translation>%1 fot</translation>
    </message>
    <message>
        <source>%1 ft (%2)</source>
        <translation>%1 fot (%2)</translation>
    </message>
    <message>
        <source>σ %1 (95 % within %2)</source>
        <translation>σ %1 (95 % innenfor %2)</translation>
    </message>
    <message>
        <source>95 % within %2 (σ %1)</source>
        <translation>95 % innenfor %2 (σ %1)</translation>
    </message>
    <message>
        <source>m² s</source>
        <translation>m² s</translation>
    </message>
    <message>
        <source>km² s</source>
        <translation>km² s</translation>
    </message>
    <message>
        <source>%1 T / %2 M</source>
        <comment>course by true and by magnetic north</comment>
        <translation>%1 R / %2 M</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>Seed</source>
        <translation>Startfrø</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>UAV</translation>
    </message>
    <message>
        <source>Visits planned</source>
        <translation>Besøk planlagt</translation>
    </message>
    <message>
        <source>flown</source>
        <translation>fløyet</translation>
    </message>
    <message>
        <source>Time planned</source>
        <translation>Tid planlagt</translation>
    </message>
    <message>
        <source>aloft</source>
        <translation>i luften</translation>
    </message>
    <message>
        <source>Outside the flight geography</source>
        <translation>Utenfor flygeografien</translation>
    </message>
    <message>
        <source>Planned and flown</source>
        <translation>Planlagt og fløyet</translation>
    </message>
    <message>
        <source>SHA-256 of the first plan as a file of the format wpl:</source>
        <translation>SHA-256 av den første planen som fil i formatet wpl:</translation>
    </message>
    <message>
        <source>Zeta over time</source>
        <translation>Zeta over tid</translation>
    </message>
    <message>
        <source>ζ over time</source>
        <translation>ζ over tid</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>First seen</source>
        <translation>Først sett</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Sist sett</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besøk</translation>
    </message>
    <message>
        <source>Longest unseen</source>
        <translation>Lengst usett</translation>
    </message>
    <message>
        <source>σ at the end, m²</source>
        <translation>σ til slutt, m²</translation>
    </message>
    <message>
        <source>never</source>
        <translation>aldri</translation>
    </message>
    <message>
        <source>Sightings</source>
        <translation>Observasjoner</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>og %1 til</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Avvik</translation>
    </message>
    <message>
        <source>None on record.</source>
        <translation>Ingen registrert.</translation>
    </message>
    <message>
        <source>Flight log: %1</source>
        <translation>Flygelogg: %1</translation>
    </message>
    <message>
        <source>Cases in which each tau is the best</source>
        <translation>Tilfeller der hver tau er best</translation>
    </message>
    <message>
        <source>cases</source>
        <translation>tilfeller</translation>
    </message>
    <message>
        <source>τ of the lowest ζ of a case</source>
        <translation>τ med lavest ζ i et tilfelle</translation>
    </message>
    <message>
        <source>a scenario without a name</source>
        <translation>et scenario uten navn</translation>
    </message>
    <message>
        <source>%1: icebergs: %2, seed %3, %4 s in steps of %5 s</source>
        <translation>%1: isfjell: %2, startfrø %3, %4 s i steg på %5 s</translation>
    </message>
    <message>
        <source>without noise</source>
        <translation>uten støy</translation>
    </message>
    <message>
        <source>measured with noise, velocities known</source>
        <translation>målt med støy, kjente hastigheter</translation>
    </message>
    <message>
        <source>measured with noise, velocities uncertain by 0.1 m/s</source>
        <translation>målt med støy, hastigheter usikre med 0,1 m/s</translation>
    </message>
    <message>
        <source>measured with noise, unknown velocities that change like those of real icebergs</source>
        <translation>målt med støy, ukjente hastigheter som endrer seg som hos virkelige isfjell</translation>
    </message>
    <message>
        <source>Random fields: %1, seeds %2 to %3. Icebergs in each: %4, in %5 m × %6 m, drifting at up to %7 m/s</source>
        <translation>Tilfeldige felt: %1, startfrø %2 til %3. Isfjell i hvert: %4, i %5 m × %6 m, med drift opptil %7 m/s</translation>
    </message>
    <message>
        <source>initial σ of %1 to %2 m², growing by q = %3 m²/s</source>
        <translation>σ ved start %1 til %2 m², vokser med q = %3 m²/s</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Scenarioer</translation>
    </message>
    <message>
        <source>Policies</source>
        <translation>Strategier</translation>
    </message>
    <message>
        <source>the scenario’s own seed, the same for every setting</source>
        <translation>scenarioets eget startfrø, det samme for alle innstillinger</translation>
    </message>
    <message>
        <source>seeds for each scenario: %1, starting with its own, the same for every setting</source>
        <translation>startfrø for hvert scenario: %1, med dets eget først, de samme for alle innstillinger</translation>
    </message>
    <message>
        <source>%1 to %2 by %3 (%4 values)</source>
        <translation>%1 til %2 i steg på %3 (%4 verdier)</translation>
    </message>
    <message>
        <source>Random fields: %1, icebergs in each: %2</source>
        <translation>Tilfeldige felt: %1, isfjell i hvert: %2</translation>
    </message>
    <message>
        <source>Study, scenarios: %1</source>
        <translation>Studie, scenarioer: %1</translation>
    </message>
    <message>
        <source>What was flown</source>
        <translation>Det som er fløyet</translation>
    </message>
    <message>
        <source>Trade-off τ</source>
        <translation>Avveining τ</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Støy</translation>
    </message>
    <message>
        <source>Missions</source>
        <translation>Oppdrag</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maskin</translation>
    </message>
    <message>
        <source>Created</source>
        <translation>Laget</translation>
    </message>
    <message>
        <source>Last run took</source>
        <translation>Siste kjøring tok</translation>
    </message>
    <message>
        <source>How to reproduce this report</source>
        <translation>Slik gjenskaper du rapporten</translation>
    </message>
    <message>
        <source>This page contains the whole study with every scenario, seed and result, and Bergwatch opens it as a study file. To make the page again from these results:</source>
        <translation>Denne siden inneholder hele studien, med alle scenarioer, startfrø og resultater, og Bergwatch åpner den som en studiefil. Slik lages siden på nytt fra disse resultatene:</translation>
    </message>
    <message>
        <source>To fly the study again; the results depend neither on the machine nor on the number of threads:</source>
        <translation>Slik flys studien på nytt; resultatene avhenger verken av maskinen eller av antallet tråder:</translation>
    </message>
    <message>
        <source>To fly the study again with your scenario files; the results depend neither on the machine nor on the number of threads:</source>
        <translation>Slik flys studien på nytt med scenariofilene dine; resultatene avhenger verken av maskinen eller av antallet tråder:</translation>
    </message>
    <message>
        <source>ζ is the total uncertainty σ of all icebergs, integrated over the flight. Lower is better.</source>
        <translation>ζ er den samlede usikkerheten σ for alle isfjell, integrert over flygingen. Lavere er bedre.</translation>
    </message>
    <message>
        <source>There is only one case, so there is no spread to show.</source>
        <translation>Det er bare ett tilfelle, så det er ingen spredning å vise.</translation>
    </message>
    <message>
        <source>Differences are taken case by case, with the same icebergs and the same noise; the bars are 95 % intervals of the mean (Student’s t). Values left of 0 are better than the reference.</source>
        <translation>Forskjellene beregnes tilfelle for tilfelle, med de samme isfjellene og den samme støyen; strekene er 95 %-intervaller for gjennomsnittet (Students t). Verdier til venstre for 0 er bedre enn referansen.</translation>
    </message>
    <message>
        <source>Not every τ is drawn; the table contains all of them.</source>
        <translation>Ikke alle τ er tegnet; tabellen inneholder alle.</translation>
    </message>
    <message>
        <source>ζ against τ</source>
        <translation>ζ mot τ</translation>
    </message>
    <message>
        <source>Differences vs the reference</source>
        <translation>Forskjeller mot referansen</translation>
    </message>
    <message>
        <source>Best τ of each case</source>
        <translation>Beste τ i hvert tilfelle</translation>
    </message>
    <message>
        <source>The τ with the lowest ζ of a case, chosen in hindsight; it is not known before the flight. If several are equal, the smallest counts.</source>
        <translation>Den τ som gir lavest ζ i et tilfelle, valgt i etterkant; den er ikke kjent før flygingen. Hvis flere er like, teller den minste.</translation>
    </message>
    <message>
        <source>Stuck: at most two icebergs were targets in the second half of the flight.</source>
        <translation>Hengende: høyst to isfjell var mål i andre halvdel av flygingen.</translation>
    </message>
    <message>
        <source>ζ of the case and its difference vs %1.</source>
        <translation>ζ for tilfellet og forskjellen mot %1.</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Innstilling</translation>
    </message>
    <message>
        <source>Difference, m² s</source>
        <translation>Forskjell, m² s</translation>
    </message>
    <message>
        <source>Difference, %</source>
        <translation>Forskjell, %</translation>
    </message>
    <message>
        <source>Stuck</source>
        <translation>Hengende</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nei</translation>
    </message>
    <message>
        <source>ζ in m² s. Cases: %1.</source>
        <translation>ζ i m² s. Tilfeller: %1.</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Middel</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>Standardfeil</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Differences of ζ vs %1, case by case, with 95 % intervals of the mean. Worst: the largest difference of a case.</source>
        <translation>Forskjeller i ζ mot %1, tilfelle for tilfelle, med 95 %-intervaller for gjennomsnittet. Verst: den største forskjellen i et tilfelle.</translation>
    </message>
    <message>
        <source>Mean, m² s</source>
        <translation>Middel, m² s</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95 %-intervall</translation>
    </message>
    <message>
        <source>Mean, %</source>
        <translation>Middel, %</translation>
    </message>
    <message>
        <source>Cases below</source>
        <translation>Tilfeller under</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Verst</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>referanse</translation>
    </message>
    <message>
        <source>best τ of each case</source>
        <translation>beste τ i hvert tilfelle</translation>
    </message>
    <message>
        <source>Best τ of each case, chosen in hindsight</source>
        <translation>Beste τ i hvert tilfelle, valgt i etterkant</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Tilfeller</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Andel</translation>
    </message>
    <message>
        <source>One case is too few to recommend a policy. Fly more cases.</source>
        <translation>Ett tilfelle er for lite til å anbefale en strategi. Fly flere tilfeller.</translation>
    </message>
    <message>
        <source>Lowest ζ: %1, %2 m² s.</source>
        <translation>Lavest ζ: %1, %2 m² s.</translation>
    </message>
    <message>
        <source>Lowest mean ζ: %1, %2 m² s.</source>
        <translation>Lavest midlere ζ: %1, %2 m² s.</translation>
    </message>
    <message>
        <source>Lowest ζ: %1, %2 m² s, %3 against %4.</source>
        <translation>Lavest ζ: %1, %2 m² s, %3 mot %4.</translation>
    </message>
    <message>
        <source>Best τ of this case: %1.</source>
        <translation>Beste τ i dette tilfellet: %1.</translation>
    </message>
    <message>
        <source>Best τ of each case, chosen in hindsight: median %1, 80 % of the cases between %2 and %3; its mean ζ is %4 against %5.</source>
        <translation>Beste τ i hvert tilfelle, valgt i etterkant: median %1, 80 % av tilfellene mellom %2 og %3; midlere ζ er %4 mot %5.</translation>
    </message>
    <message>
        <source>Not complete.</source>
        <translation>Ikke fullstendig.</translation>
    </message>
    <message>
        <source>Missions flown: %1 of %2. The results below use only the cases that every setting has flown: %3 of %4.</source>
        <translation>Fløyne oppdrag: %1 av %2. Resultatene nedenfor bruker bare tilfellene som alle innstillinger har fløyet: %3 av %4.</translation>
    </message>
    <message>
        <source>Missions: %1. Cases: %2, each flown with every setting. Settings: %3.</source>
        <translation>Oppdrag: %1. Tilfeller: %2, hvert fløyet med alle innstillinger. Innstillinger: %3.</translation>
    </message>
    <message>
        <source>The numbers</source>
        <translation>Tallene</translation>
    </message>
    <message>
        <source>en</source>
        <translation>nb</translation>
    </message>
    <message>
        <source>Longest unseen: from when an iceberg was known of, or seen, until it was seen again, left, was removed or the record ends.</source>
        <translation>Lengst usett: fra et isfjell ble kjent eller sett, til det ble sett igjen, forlot området, ble fjernet eller opptaket slutter.</translation>
    </message>
    <message>
        <source>Planned: the first sortie of the plan before take-off, over ground in straight legs. Distances flown are through the air.</source>
        <translation>Planlagt: det første toktet i planen før avgang, over grunnen i rette etapper. Fløyne avstander er gjennom luften.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 og %2 til</translation>
    </message>
    <message>
        <source>No clear winner. These settings may be the best: %1.</source>
        <translation>Ingen klar vinner. Disse innstillingene kan være best: %1.</translation>
    </message>
    <message>
        <source>Recommended: %1, %2 against %3, the closest other setting.</source>
        <translation>Anbefalt: %1, %2 mot %3, den nærmeste andre innstillingen.</translation>
    </message>
    <message>
        <source>Took off</source>
        <translation>Tok av</translation>
    </message>
    <message>
        <source>Landed</source>
        <translation>Landet</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Til</translation>
    </message>
    <message>
        <source>Zeta flown</source>
        <translation>Zeta fløyet</translation>
    </message>
    <message>
        <source>Predicted before take-off</source>
        <translation>Forutsagt før avgang</translation>
    </message>
    <message>
        <source>Plans made</source>
        <translation>Planer laget</translation>
    </message>
    <message>
        <source>Planned by</source>
        <translation>Planlagt av</translation>
    </message>
    <message>
        <source>Distance planned</source>
        <translation>Planlagt avstand</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % innenfor</translation>
    </message>
    <message>
        <source>Something was changed in flight: the prediction was for another flight.</source>
        <translation>Noe ble endret under flygingen: forutsigelsen gjaldt en annen flyging.</translation>
    </message>
    <message>
        <source>Sum of σ, m²</source>
        <translation>Sum av σ, m²</translation>
    </message>
    <message>
        <source>iceberg reached</source>
        <translation>isfjell nådd</translation>
    </message>
    <message>
        <source>Time since the start</source>
        <translation>Tid siden start</translation>
    </message>
    <message>
        <source>Zeta over time, in the end %1.</source>
        <translation>Zeta over tid, til slutt %1.</translation>
    </message>
    <message>
        <source>Lowest: %1.</source>
        <translation>Lavest: %1.</translation>
    </message>
    <message>
        <source>Lowest: %1; of the values of τ: %2.</source>
        <translation>Lavest: %1; blant verdiene av τ: %2.</translation>
    </message>
    <message>
        <source>Band: quartiles. Dashed: median. Ring: reference.</source>
        <translation>Bånd: kvartiler. Stiplet: median. Ring: referanse.</translation>
    </message>
    <message>
        <source>Ring: reference.</source>
        <translation>Ring: referanse.</translation>
    </message>
    <message>
        <source>Mean ζ, %1</source>
        <translation>Middel ζ, %1</translation>
    </message>
    <message>
        <source>Zeta ζ, %1</source>
        <translation>Zeta ζ, %1</translation>
    </message>
    <message>
        <source>%1 vs %2</source>
        <translation>%1 mot %2</translation>
    </message>
    <message>
        <source>ζ %1 m² s</source>
        <translation>ζ %1 m² s</translation>
    </message>
    <message>
        <source>mean %1, median %2</source>
        <translation>middel %1, median %2</translation>
    </message>
    <message>
        <source>quartiles %1 to %2</source>
        <translation>kvartiler %1 til %2</translation>
    </message>
    <message>
        <source>stuck in %1 of %2 cases</source>
        <translation>hengende i %1 av %2 tilfeller</translation>
    </message>
    <message>
        <source>stuck: visits at most two icebergs in the second half</source>
        <translation>hengende: besøker høyst to isfjell i andre halvdel</translation>
    </message>
    <message>
        <source>Less ζ is better: to the left</source>
        <translation>Mindre ζ er bedre: mot venstre</translation>
    </message>
    <message>
        <source>Mean of the cases with its 95 % confidence interval</source>
        <translation>Gjennomsnittet av tilfellene med 95 % konfidensintervall</translation>
    </message>
    <message>
        <source>Difference of ζ vs %1, %</source>
        <translation>Forskjell i ζ fra %1, %</translation>
    </message>
    <message>
        <source>the reference</source>
        <translation>referansen</translation>
    </message>
    <message>
        <source>95 %: %1 to %2</source>
        <translation>95 %: %1 til %2</translation>
    </message>
    <message>
        <source>less in %1 of %2 cases</source>
        <translation>mindre i %1 av %2 tilfeller</translation>
    </message>
    <message>
        <source>worst %1</source>
        <translation>verst %1</translation>
    </message>
    <message>
        <source>Accumulated uncertainty ζ against the trade-off τ</source>
        <translation>Akkumulert usikkerhet ζ mot avveiningen τ</translation>
    </message>
    <message>
        <source>The line is the mean over the cases (%1), dashed their median; the band contains the middle half of them. Horizontal lines are the means of policies without τ.</source>
        <translation>Linjen er gjennomsnittet over tilfellene (%1), stiplet er medianen; båndet inneholder den midterste halvdelen av dem. Vannrette linjer er gjennomsnittet for strategier uten τ.</translation>
    </message>
    <message>
        <source>Weighted visiting order (published method)</source>
        <translation>Vektet besøksrekkefølge (publisert metode)</translation>
    </message>
    <message>
        <source>τ %1</source>
        <translation>τ %1</translation>
    </message>
    <message>
        <source>Weighs seeing uncertain icebergs early against path length, by τ.</source>
        <translation>Veier det å se usikre isfjell tidlig mot veiens lengde, med τ.</translation>
    </message>
    <message>
        <source>Weighted visiting order, trade-off τ %1</source>
        <translation>Vektet besøksrekkefølge, avveining τ %1</translation>
    </message>
    <message>
        <source>Shortest path, repeated</source>
        <translation>Korteste vei, gjentatt</translation>
    </message>
    <message>
        <source>Shortest path</source>
        <translation>Korteste vei</translation>
    </message>
    <message>
        <source>Flies the shortest path past all icebergs, then the next one.</source>
        <translation>Flyr den korteste veien forbi alle isfjell, så den neste.</translation>
    </message>
    <message>
        <source>Shortest round tour, repeated</source>
        <translation>Korteste rundtur, gjentatt</translation>
    </message>
    <message>
        <source>Round tour</source>
        <translation>Rundtur</translation>
    </message>
    <message>
        <source>Flies one shortest round tour again and again.</source>
        <translation>Flyr én korteste rundtur om og om igjen.</translation>
    </message>
    <message>
        <source>Nearest iceberg first</source>
        <translation>Nærmeste isfjell først</translation>
    </message>
    <message>
        <source>Nearest first</source>
        <translation>Nærmeste først</translation>
    </message>
    <message>
        <source>Flies to the nearest iceberg out of view.</source>
        <translation>Flyr til det nærmeste isfjellet ute av syne.</translation>
    </message>
    <message>
        <source>Most uncertain iceberg first</source>
        <translation>Mest usikre isfjell først</translation>
    </message>
    <message>
        <source>Most uncertain first</source>
        <translation>Mest usikre først</translation>
    </message>
    <message>
        <source>Flies to the most uncertain iceberg.</source>
        <translation>Flyr til det mest usikre isfjellet.</translation>
    </message>
    <message>
        <source>Least waiting time</source>
        <translation>Kortest ventetid</translation>
    </message>
    <message>
        <source>Least waiting</source>
        <translation>Minst venting</translation>
    </message>
    <message>
        <source>Keeps the waiting time of all icebergs short, weighted by their uncertainty.</source>
        <translation>Holder ventetiden for alle isfjell kort, vektet med usikkerheten deres.</translation>
    </message>
    <message>
        <source>Least waiting time, weighted by uncertainty</source>
        <translation>Kortest ventetid, vektet med usikkerheten</translation>
    </message>
    <message>
        <source>Best predicted coverage</source>
        <translation>Best forventet dekning</translation>
    </message>
    <message>
        <source>Best coverage</source>
        <translation>Best dekning</translation>
    </message>
    <message>
        <source>Predicts zeta for paths that pass icebergs at an offset and see several at once.</source>
        <translation>Forutsier zeta for baner som passerer isfjell på avstand og ser flere på én gang.</translation>
    </message>
    <message>
        <source>Zeta by start time</source>
        <translation>Zeta etter starttid</translation>
    </message>
    <message>
        <source>Start, UTC</source>
        <translation>Start, UTC</translation>
    </message>
    <message>
        <source>Faint: marginal or unknown weather. Hatched: no-go.</source>
        <translation>Svak farge: marginalt eller ukjent vær. Skravert: ikke fly.</translation>
    </message>
    <message>
        <source>Best start: %1 UTC.</source>
        <translation>Beste start: %1 UTC.</translation>
    </message>
    <message>
        <source>No start has weather within all limits.</source>
        <translation>Ingen start har vær innenfor alle grenser.</translation>
    </message>
    <message>
        <source>cannot be flown</source>
        <translation>kan ikke flys</translation>
    </message>
    <message>
        <source>weather: %1</source>
        <translation>vær: %1</translation>
    </message>
    <message>
        <source>go</source>
        <translation>fly</translation>
    </message>
    <message>
        <source>marginal</source>
        <translation>marginalt</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>ikke kjent</translation>
    </message>
    <message>
        <source>no-go</source>
        <translation>ikke fly</translation>
    </message>
    <message>
        <source>Forecast</source>
        <translation>Varsel</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Kilde</translation>
    </message>
    <message>
        <source>Issued</source>
        <translation>Utstedt</translation>
    </message>
    <message>
        <source>Age at take-off</source>
        <translation>Alder ved avgang</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>ukjent</translation>
    </message>
    <message>
        <source>Used in flight, at the middle of the starts of the UAVs.</source>
        <translation>Brukt under flygingen, midt mellom dronenes startsteder.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Wind, true</source>
        <translation>Vind, rettvisende</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Vindkast</translation>
    </message>
    <message>
        <source>Current, true</source>
        <translation>Strøm, rettvisende</translation>
    </message>
    <message>
        <source>No wind</source>
        <translation>Ingen vind</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1 fra %2</translation>
    </message>
    <message>
        <source>%1 towards %2</source>
        <translation>%1 mot %2</translation>
    </message>
    <message>
        <source>The forecast has no wind between %1 and %2: the flight used the constant wind of the scenario.</source>
        <translation>Varselet har ingen vind mellom %1 og %2: flygingen brukte den faste vinden i scenarioet.</translation>
    </message>
    <message>
        <source>The forecast has no current between %1 and %2: the flight used the constant current of the scenario.</source>
        <translation>Varselet har ingen strøm mellom %1 og %2: flygingen brukte den faste strømmen i scenarioet.</translation>
    </message>
</context>
<context>
    <name>SelectTool</name>
    <message>
        <source>Release to place it here. Esc cancels.</source>
        <translation>Slipp for å plassere det her. Esc avbryter.</translation>
    </message>
    <message>
        <source>Everything inside the frame is selected.</source>
        <translation>Alt innenfor rammen blir valgt.</translation>
    </message>
    <message>
        <source>Click to select, drag to move. Ctrl+click adds; drag on open water to select a box.</source>
        <translation>Klikk for å velge, dra for å flytte. Ctrl+klikk legger til; dra på åpent vann for å velge med en ramme.</translation>
    </message>
    <message>
        <source>Click to select. In flight you can drag the tip of the wind arrow and the asset.</source>
        <translation>Klikk for å velge. Under flyging kan du dra spissen av vindpilen og objektet.</translation>
    </message>
    <message>
        <source>Click to select. Choose Stop and edit to change the scenario.</source>
        <translation>Klikk for å velge. Velg Stopp og rediger for å endre scenarioet.</translation>
    </message>
</context>
<context>
    <name>SolveTimeText</name>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>CPLEX, average (paper)</source>
        <translation>CPLEX, gjennomsnitt (artikkelen)</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisk</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Eksakt</translation>
    </message>
    <message>
        <source>Local search</source>
        <translation>Lokalsøk</translation>
    </message>
    <message>
        <source>CBC, by position</source>
        <translation>CBC, etter plass</translation>
    </message>
    <message>
        <source>CBC, as printed</source>
        <translation>CBC, som trykt</translation>
    </message>
    <message>
        <source>CBC, reduced</source>
        <translation>CBC, redusert</translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>ship&apos;s radar</source>
        <translation>skipsradar</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>øyet</translation>
    </message>
    <message>
        <source>satellite</source>
        <translation>satellitt</translation>
    </message>
    <message>
        <source>camera of a UAV</source>
        <translation>kamera på en UAV</translation>
    </message>
    <message>
        <source>GPS beacon</source>
        <translation>GPS-sender</translation>
    </message>
    <message>
        <source>Argos beacon</source>
        <translation>Argos-sender</translation>
    </message>
    <message>
        <source>%1, 95 % within %2</source>
        <translation>%1, 95 % innenfor %2</translation>
    </message>
    <message>
        <source>AIS</source>
        <translation>AIS</translation>
    </message>
    <message>
        <source>aircraft</source>
        <translation>fly</translation>
    </message>
</context>
<context>
    <name>StudyTables</name>
    <message>
        <source>Best τ of each case</source>
        <translation>Beste τ i hvert tilfelle</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <comment>from, to</comment>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>referanse</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 til %2</translation>
    </message>
    <message>
        <source>The τ of lowest ζ of each case, chosen in hindsight: median %1, quartiles %2 and %3.</source>
        <translation>τ med lavest ζ i hvert tilfelle, valgt i etterkant: median %1, kvartiler %2 og %3.</translation>
    </message>
    <message>
        <source>Less than the reference in %1 of %2 cases, worst %3. On average %4 visits.</source>
        <translation>Mindre enn referansen i %1 av %2 tilfeller, verst %3. I gjennomsnitt %4 besøk.</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>hengende</translation>
    </message>
    <message>
        <source>%1 visits, %2 plans, %3 flown. Return or a double click opens this run.</source>
        <translation>%1 besøk, %2 planer, %3 fløyet. Enter eller dobbeltklikk åpner denne flygingen.</translation>
    </message>
    <message>
        <source>Random %1</source>
        <comment>scenario drawn from a seed</comment>
        <translation>Tilfeldig %1</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Innstilling</translation>
    </message>
    <message>
        <source>Mean ζ</source>
        <translation>Middel ζ</translation>
    </message>
    <message>
        <source>Median ζ</source>
        <translation>Median ζ</translation>
    </message>
    <message>
        <source>Quartiles</source>
        <translation>Kvartiler</translation>
    </message>
    <message>
        <source>vs reference</source>
        <translation>Mot referanse</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95 %-intervall</translation>
    </message>
    <message>
        <source>Best in</source>
        <translation>Best i</translation>
    </message>
    <message>
        <source>Stuck</source>
        <translation>Hengende</translation>
    </message>
    <message>
        <source>How the next iceberg is chosen.</source>
        <translation>Hvordan neste isfjell velges.</translation>
    </message>
    <message>
        <source>Accumulated uncertainty in m² s, mean of all cases: less is better.</source>
        <translation>Akkumulert usikkerhet i m² s, gjennomsnitt av alle tilfeller: mindre er bedre.</translation>
    </message>
    <message>
        <source>Half of the cases have less.</source>
        <translation>Halvparten av tilfellene har mindre.</translation>
    </message>
    <message>
        <source>A quarter of the cases has less than the first, a quarter more than the second.</source>
        <translation>En firedel av tilfellene har mindre enn den første, en firedel mer enn den andre.</translation>
    </message>
    <message>
        <source>Mean of the differences, case by case, in per cent of the reference.</source>
        <translation>Gjennomsnittet av forskjellene, tilfelle for tilfelle, i prosent av referansen.</translation>
    </message>
    <message>
        <source>Confidence interval of the mean difference by Student&apos;s t.</source>
        <translation>Konfidensintervall for den midlere forskjellen etter Students t.</translation>
    </message>
    <message>
        <source>Cases in which no other setting has less ζ.</source>
        <translation>Tilfeller der ingen annen innstilling har mindre ζ.</translation>
    </message>
    <message>
        <source>Cases that visit at most two icebergs in the second half.</source>
        <translation>Tilfeller som besøker høyst to isfjell i andre halvdel.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Tilfelle</translation>
    </message>
    <message>
        <source>Noise seed</source>
        <translation>Støyfrø</translation>
    </message>
    <message>
        <source>ζ, m² s</source>
        <translation>ζ, m² s</translation>
    </message>
    <message>
        <source>Best τ</source>
        <translation>Beste τ</translation>
    </message>
    <message>
        <source>Best of all</source>
        <translation>Best av alle</translation>
    </message>
    <message>
        <source>Name of the scenario, or the seed it was drawn from.</source>
        <translation>Navnet på scenarioet, eller startfrøet det ble trukket fra.</translation>
    </message>
    <message>
        <source>Seed of the true drift, the same for every setting.</source>
        <translation>Startfrøet for den sanne driften, det samme for hver innstilling.</translation>
    </message>
    <message>
        <source>Accumulated uncertainty of this flight: less is better.</source>
        <translation>Akkumulert usikkerhet for denne flygingen: mindre er bedre.</translation>
    </message>
    <message>
        <source>Compared with the flight of this case with the reference.</source>
        <translation>Sammenlignet med flygingen av dette tilfellet med referansen.</translation>
    </message>
    <message>
        <source>The τ with the lowest ζ in this case, in hindsight.</source>
        <translation>τ med lavest ζ i dette tilfellet, i etterkant.</translation>
    </message>
    <message>
        <source>The setting with the lowest ζ in this case.</source>
        <translation>Innstillingen med lavest ζ i dette tilfellet.</translation>
    </message>
    <message>
        <source>Visits at most two icebergs in the second half.</source>
        <translation>Besøker høyst to isfjell i andre halvdel.</translation>
    </message>
</context>
<context>
    <name>TimeChartText</name>
    <message>
        <source>Time, h:mm:ss</source>
        <translation>Tid, t:mm:ss</translation>
    </message>
    <message>
        <source>Time, mm:ss</source>
        <translation>Tid, mm:ss</translation>
    </message>
    <message>
        <source>Time, UTC</source>
        <translation>Tid, UTC</translation>
    </message>
</context>
<context>
    <name>TimeEntry</name>
    <message>
        <source>The day and month of &quot;%1&quot; are ambiguous. Type the date like 2026-11-29 12:00.</source>
        <translation>Dag og måned i «%1» kan leses på to måter. Skriv datoen som 2026-11-29 12:00.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no date. Type it like 2026-11-29 12:00.</source>
        <translation>«%1» har ingen dato. Skriv det som 2026-11-29 12:00.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a date and time. Type it like 2026-11-29 12:00 or 29 Nov 2026 12:00.</source>
        <translation>«%1» er ikke en dato med klokkeslett. Skriv det som 2026-11-29 12:00 eller 29 Nov 2026 12:00.</translation>
    </message>
</context>
<context>
    <name>WeatherChart</name>
    <message>
        <source>Wind limit %1</source>
        <translation>Vindgrense %1</translation>
    </message>
    <message>
        <source>Gust limit %1</source>
        <translation>Vindkastgrense %1</translation>
    </message>
    <message>
        <source>no wind</source>
        <translation>ingen vind</translation>
    </message>
    <message>
        <source>wind %1 from %2</source>
        <translation>vind %1 fra %2</translation>
    </message>
    <message>
        <source>gusts %1</source>
        <translation>vindkast %1</translation>
    </message>
    <message>
        <source>current %1 towards %2</source>
        <translation>strøm %1 mot %2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>ukjent</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>fra %1</translation>
    </message>
    <message>
        <source>towards %1</source>
        <translation>mot %1</translation>
    </message>
    <message>
        <source>Forecast of wind and current</source>
        <translation>Varsel om vind og strøm</translation>
    </message>
    <message>
        <source>Wind and current</source>
        <translation>Vind og strøm</translation>
    </message>
    <message>
        <source>Wind, %1</source>
        <translation>Vind, %1</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vind</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Vindkast</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strøm</translation>
    </message>
    <message>
        <source>Current, %1</source>
        <translation>Strøm, %1</translation>
    </message>
    <message>
        <source>The forecast does not cover this run</source>
        <translation>Varselet dekker ikke denne flygingen</translation>
    </message>
    <message>
        <source>Weather at %1: %2.</source>
        <translation>Vær klokken %1: %2.</translation>
    </message>
    <message>
        <source>Flown in gaps: constant wind %1</source>
        <translation>Fløyet i hull: fast vind %1</translation>
    </message>
    <message>
        <source>%1; in gaps the constant current of %2</source>
        <comment>title, speed</comment>
        <translation>%1; i hull den faste strømmen på %2</translation>
    </message>
</context>
<context>
    <name>WeatherWords</name>
    <message>
        <source>wind</source>
        <translation>vind</translation>
    </message>
    <message>
        <source>gusts</source>
        <translation>vindkast</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>sikt</translation>
    </message>
    <message>
        <source>cloud base</source>
        <translation>skybase</translation>
    </message>
    <message>
        <source>icing</source>
        <translation>ising</translation>
    </message>
    <message>
        <source>%1 UTC</source>
        <translation>%1 UTC</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Fly</translation>
    </message>
    <message>
        <source>Marginal</source>
        <translation>Marginalt</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>Ikke kjent</translation>
    </message>
    <message>
        <source>No-go</source>
        <translation>Ikke fly</translation>
    </message>
    <message>
        <source>%1 not known, limit %2</source>
        <translation>%1 ikke kjent, grense %2</translation>
    </message>
    <message>
        <source>%1 %2, limit %3</source>
        <comment>wind, its value, its limit</comment>
        <translation>%1 %2, grense %3</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a UAV and what concerns it</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2, from %3</source>
        <comment>state, reason, time</comment>
        <translation>%1: %2, fra %3</translation>
    </message>
</context>
<context>
    <name>WindText</name>
    <message>
        <source>No wind</source>
        <translation>Ingen vind</translation>
    </message>
    <message>
        <source>Wind %1
from %2, strong</source>
        <translation>Vind %1
fra %2, sterk</translation>
    </message>
    <message>
        <source>Wind %1
from %2</source>
        <translation>Vind %1
fra %2</translation>
    </message>
    <message>
        <source>Current %1
towards %2</source>
        <translation>Strøm %1
mot %2</translation>
    </message>
    <message>
        <source>The arrow points downwind. The ring is the airspeed of the slowest UAV (%1); beyond the dashed ring UAVs make little headway.</source>
        <translation>Pilen peker dit vinden blåser. Ringen er flyfarten til den langsomste UAV-en (%1); utenfor den stiplede ringen kommer UAV-er knapt fremover.</translation>
    </message>
    <message>
        <source>The small aircraft in the middle of a leg shows the heading flown there.</source>
        <translation>Det lille flyet midt på en etappe viser kursen som flys der.</translation>
    </message>
    <message>
        <source>reported</source>
        <translation>meldt</translation>
    </message>
    <message>
        <source>forecast</source>
        <translation>varslet</translation>
    </message>
    <message>
        <source>Gusts %1</source>
        <translation>Vindkast %1</translation>
    </message>
    <message>
        <source>UAVs fly in the wind that the crew has reported, and icebergs drift in the forecast.</source>
        <translation>UAV-ene flyr i vinden som mannskapet har meldt, og isfjellene driver i varselet.</translation>
    </message>
    <message>
        <source>Remove the forecast in the Inspector to set the wind yourself.</source>
        <translation>Fjern varselet i Egenskaper for å sette vinden selv.</translation>
    </message>
</context>
<context>
    <name>WorkFailureText</name>
    <message>
        <source>Not enough memory. Close other programs or choose a smaller task.</source>
        <translation>Ikke nok minne. Lukk andre programmer, eller velg en mindre oppgave.</translation>
    </message>
    <message>
        <source>Internal error: %1</source>
        <translation>Intern feil: %1</translation>
    </message>
</context>
<context>
    <name>berg::AircraftController</name>
    <message>
        <source>%1: no contact for %2</source>
        <translation>%1: ingen kontakt på %2</translation>
    </message>
    <message>
        <source>contact in %1</source>
        <translation>kontakt om %1</translation>
    </message>
    <message>
        <source>Link: sending</source>
        <translation>Forbindelse: sender</translation>
    </message>
    <message>
        <source>Link: listening</source>
        <translation>Forbindelse: lytter</translation>
    </message>
    <message>
        <source>Differs: the mission on board has changed since %1</source>
        <translation>Avviker: oppdraget om bord er endret siden %1</translation>
    </message>
    <message>
        <source>Differs: the plan has changed since %1</source>
        <translation>Avviker: planen er endret siden %1</translation>
    </message>
    <message>
        <source>On board: same as the plan of %1</source>
        <translation>Om bord: samme som planen fra %1</translation>
    </message>
    <message>
        <source>Battery: %1</source>
        <translation>Batteri: %1</translation>
    </message>
    <message>
        <source>Link: replay</source>
        <translation>Forbindelse: avspilling</translation>
    </message>
    <message>
        <source>Stop listening before you play a log.</source>
        <translation>Slutt å lytte før du spiller av en logg.</translation>
    </message>
    <message>
        <source>%1 is not a telemetry log, or its beginning is damaged.</source>
        <translation>%1 er ingen telemetrilogg, eller begynnelsen er skadd.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 kan ikke leses: %2</translation>
    </message>
    <message>
        <source>Differs: home has moved since %1</source>
        <translation>Avviker: hjem har flyttet seg siden %1</translation>
    </message>
    <message>
        <source>%1 can be reached from the network, and MAVLink does not check who sends.</source>
        <translation>%1 kan nås fra nettverket, og MAVLink kontrollerer ikke hvem som sender.</translation>
    </message>
    <message>
        <source>the mission was not replaced. Steering is off</source>
        <translation>oppdraget ble ikke erstattet. Styringen er av</translation>
    </message>
    <message>
        <source>steering is off, because sending is</source>
        <translation>styringen er av fordi det ikke sendes</translation>
    </message>
    <message>
        <source>the plan has changed meanwhile. Nothing was sent</source>
        <translation>planen er endret imens. Ingenting ble sendt</translation>
    </message>
    <message>
        <source>its UAV has no plan. Nothing was sent</source>
        <translation>UAV-en har ingen plan. Ingenting ble sendt</translation>
    </message>
    <message>
        <source>%1. The aircraft keeps its own fence</source>
        <translation>%1. Luftfartøyet beholder sitt eget gjerde</translation>
    </message>
    <message>
        <source>Telemetry logs (*.tlog *.nmea);;All files (*)</source>
        <translation>Telemetrilogger (*.tlog *.nmea);;Alle filer (*)</translation>
    </message>
</context>
<context>
    <name>berg::AircraftPanel</name>
    <message>
        <source>from %1, %2 ± %3</source>
        <translation>fra %1, %2 ± %3</translation>
    </message>
    <message>
        <source>Wind: %1</source>
        <translation>Vind: %1</translation>
    </message>
    <message>
        <source>Item %1 of %2</source>
        <translation>Punkt %1 av %2</translation>
    </message>
    <message>
        <source>Item %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>Frames lost: %1 of %2</source>
        <translation>Tapte rammer: %1 av %2</translation>
    </message>
    <message>
        <source>Listen</source>
        <translation>Lytt</translation>
    </message>
    <message>
        <source>Receives telemetry at this address. Nothing is sent.</source>
        <translation>Mottar telemetri på denne adressen. Ingenting sendes.</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Send</translation>
    </message>
    <message>
        <source>Rehearse</source>
        <translation>Øv</translation>
    </message>
    <message>
        <source>Upload</source>
        <translation>Last opp</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Sammenlign</translation>
    </message>
    <message>
        <source>Reads the mission on board and compares it with the plan.</source>
        <translation>Leser oppdraget om bord og sammenligner det med planen.</translation>
    </message>
    <message>
        <source>Fly the mission</source>
        <translation>Fly oppdraget</translation>
    </message>
    <message>
        <source>Selects the mode in which the aircraft flies the mission on board. It must be in the air.</source>
        <translation>Velger modusen der luftfartøyet flyr oppdraget om bord. Det må være i luften.</translation>
    </message>
    <message>
        <source>Use its wind</source>
        <translation>Bruk vinden</translation>
    </message>
    <message>
        <source>The mean wind of the last minute becomes the wind of the scenario.</source>
        <translation>Middelvinden det siste minuttet blir vinden i scenarioet.</translation>
    </message>
    <message>
        <source>Fly with the aircraft</source>
        <translation>Fly med luftfartøyet</translation>
    </message>
    <message>
        <source>The flight in this window follows the aircraft: charts and uncertainty show the real flight.</source>
        <translation>Flygingen i vinduet følger luftfartøyet: diagrammer og usikkerhet viser den virkelige flygingen.</translation>
    </message>
    <message>
        <source>Events of the link</source>
        <translation>Hendelser på forbindelsen</translation>
    </message>
    <message>
        <source>Address of the link</source>
        <translation>Adresse for forbindelsen</translation>
    </message>
    <message>
        <source>udp:HOST:PORT listens, udpout:HOST:PORT sends to one address; also tcp:HOST:PORT and serial:DEVICE:BAUD</source>
        <translation>udp:VERT:PORT lytter, udpout:VERT:PORT sender til én adresse; også tcp:VERT:PORT og serial:ENHET:BAUD</translation>
    </message>
    <message>
        <source>Off: not a byte is sent. On: heartbeats, requests for telemetry and what you choose below are sent.</source>
        <translation>Av: ikke en byte sendes. På: livstegn, forespørsler om telemetri og det du velger nedenfor, sendes.</translation>
    </message>
    <message>
        <source>Aircraft heard</source>
        <translation>Hørte luftfartøyer</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Luftfartøyer</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Last position</source>
        <translation>Siste posisjon</translation>
    </message>
    <message>
        <source>Flies as</source>
        <translation>Flyr som</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Styring</translation>
    </message>
    <message>
        <source>Do not steer</source>
        <translation>Ikke styr</translation>
    </message>
    <message>
        <source>Replace the mission when the plan changes</source>
        <translation>Erstatt oppdraget når planen endres</translation>
    </message>
    <message>
        <source>Guide from iceberg to iceberg</source>
        <translation>Led fra isfjell til isfjell</translation>
    </message>
    <message>
        <source>No UAV</source>
        <translation>Ingen UAV</translation>
    </message>
    <message>
        <source>The link is off.</source>
        <translation>Forbindelsen er av.</translation>
    </message>
    <message>
        <source>Listening. No aircraft has been heard yet.</source>
        <translation>Lytter. Ingen luftfartøyer er hørt ennå.</translation>
    </message>
    <message>
        <source>No position yet. Some autopilots report it only while Send is on.</source>
        <translation>Ingen posisjon ennå. Noen autopiloter melder den bare mens Send er på.</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>ingen kontakt</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>ingen ennå</translation>
    </message>
    <message>
        <source>The flight follows the aircraft</source>
        <translation>Flygingen følger luftfartøyet</translation>
    </message>
    <message>
        <source>%1  Attention: %2</source>
        <translation>%1  Obs: %2</translation>
    </message>
    <message>
        <source>No aircraft in the log so far.</source>
        <translation>Ingen luftfartøyer i loggen så langt.</translation>
    </message>
    <message>
        <source>Simulated aircraft fly from the UAVs of the scenario and send their telemetry over the network of this computer. Not while another link is open.</source>
        <translation>Simulerte luftfartøyer flyr fra UAV-ene i scenarioet og sender telemetrien sin over nettverket på denne datamaskinen. Ikke mens en annen forbindelse er åpen.</translation>
    </message>
    <message>
        <source>Uploads the plan with its fence and rally point, reads it back and compares it. If the plan has no fence, the aircraft keeps its own.</source>
        <translation>Laster opp planen med gjerdet og samlingspunktet, leser den tilbake og sammenligner. Har planen ikke noe gjerde, beholder luftfartøyet sitt eget.</translation>
    </message>
</context>
<context>
    <name>berg::AlarmStrip</name>
    <message>
        <source>Acknowledge</source>
        <translation>Bekreft</translation>
    </message>
    <message>
        <source>Removes this notice. It returns if the condition ends and occurs again.</source>
        <translation>Fjerner denne meldingen. Den kommer tilbake hvis tilstanden slutter og oppstår igjen.</translation>
    </message>
    <message>
        <source>Continue from here</source>
        <translation>Fly videre herfra</translation>
    </message>
    <message>
        <source>Discards the flight after this instant. From here you can change the trade-off and the policy and fly another path.</source>
        <translation>Forkaster flygingen etter dette øyeblikket. Herfra kan du endre avveining og strategi og fly en annen bane.</translation>
    </message>
    <message>
        <source>Back to latest</source>
        <translation>Tilbake til nyeste</translation>
    </message>
    <message>
        <source>Goes to the latest instant of the flight.</source>
        <translation>Går til det siste øyeblikket i flygingen.</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Kontroll</translation>
    </message>
    <message>
        <source>Lists all findings in the scenario.</source>
        <translation>Lister opp alle funn i scenarioet.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Gjenopprett</translation>
    </message>
    <message>
        <source>Continues the flight where it was left.</source>
        <translation>Fortsetter flygingen der den ble forlatt.</translation>
    </message>
    <message>
        <source>No alarms</source>
        <translation>Ingen alarmer</translation>
    </message>
    <message>
        <source>Cannot be planned: %1</source>
        <translation>Kan ikke planlegges: %1</translation>
    </message>
    <message>
        <source>Looking back at %1</source>
        <translation>Ser tilbake på %1</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n til</numerusform>
            <numerusform>%n til</numerusform>
        </translation>
    </message>
    <message>
        <source>Click to show it on the map.</source>
        <translation>Klikk for å vise det på kartet.</translation>
    </message>
    <message>
        <source>Acknowledged: %1</source>
        <translation>Bekreftet: %1</translation>
    </message>
    <message>
        <source>Not in flight</source>
        <translation>Ikke i luften</translation>
    </message>
</context>
<context>
    <name>berg::BackdropFile</name>
    <message>
        <source>%1 contains no points, lines or polygons</source>
        <translation>%1 inneholder ingen punkter, linjer eller polygoner</translation>
    </message>
    <message>
        <source>The background map %1 cannot be read</source>
        <translation>Bakgrunnskartet %1 kan ikke leses</translation>
    </message>
    <message>
        <source>%1 is neither GeoJSON nor KML. Convert it with a map program, such as QGIS, and choose it again.</source>
        <translation>%1 er verken GeoJSON eller KML. Konverter filen med et kartprogram, for eksempel QGIS, og velg den på nytt.</translation>
    </message>
    <message>
        <source>Maps (*.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;All files (*)</source>
        <translation>Kart (*.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;Alle filer (*)</translation>
    </message>
</context>
<context>
    <name>berg::BenchmarkController</name>
    <message>
        <source>Solve time</source>
        <translation>Løsningstid</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tabeller (*.csv);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Lagret %1</translation>
    </message>
</context>
<context>
    <name>berg::ChartPanel</name>
    <message>
        <source>Chart</source>
        <translation>Diagram</translation>
    </message>
    <message>
        <source>Quantity shown over time</source>
        <translation>Størrelsen som vises over tid</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linjer</translation>
    </message>
    <message>
        <source>Choose the lines to show</source>
        <translation>Velg linjene som vises</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Følg</translation>
    </message>
    <message>
        <source>Keep the newest minutes in view (End). The wheel zooms, the right button drags.</source>
        <translation>Hold de nyeste minuttene i syne (End). Hjulet zoomer, høyre knapp drar.</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Show everything from take-off on (Home, or a double click)</source>
        <translation>Vis alt fra avgang (Home, eller dobbeltklikk)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Eksporter …</translation>
    </message>
    <message>
        <source>Save the chart as a picture (PNG, SVG, PDF) or its numbers as CSV</source>
        <translation>Lagre diagrammet som bilde (PNG, SVG, PDF) eller tallene som CSV</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Vis alle</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-bilde (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-tegning (*.svg)</translation>
    </message>
    <message>
        <source>PDF page (*.pdf)</source>
        <translation>PDF-side (*.pdf)</translation>
    </message>
    <message>
        <source>Table of numbers (*.csv)</source>
        <translation>Talltabell (*.csv)</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Kopier bilde</translation>
    </message>
    <message>
        <source>Copy numbers</source>
        <translation>Kopier tall</translation>
    </message>
    <message>
        <source>Save picture or numbers...</source>
        <translation>Lagre bilde eller tall ...</translation>
    </message>
    <message>
        <source>Reset zoom</source>
        <translation>Tilbakestill zoom</translation>
    </message>
    <message>
        <source>Values of the lines</source>
        <translation>Linjenes verdier</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linje</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Verdi</translation>
    </message>
</context>
<context>
    <name>berg::CheckPanel</name>
    <message>
        <source>Error: must be fixed before planning</source>
        <translation>Feil: må rettes før planlegging</translation>
    </message>
    <message>
        <source>Warning: probably not intended</source>
        <translation>Advarsel: trolig ikke tilsiktet</translation>
    </message>
    <message>
        <source>Hint: good to know</source>
        <translation>Tips: greit å vite</translation>
    </message>
    <message>
        <source>No problems found</source>
        <translation>Ingen feil funnet</translation>
    </message>
    <message>
        <source>Findings about the scenario</source>
        <translation>Funn om scenarioet</translation>
    </message>
</context>
<context>
    <name>berg::ComparisonChart</name>
    <message>
        <source>Comparison of accumulated uncertainty</source>
        <translation>Sammenligning av samlet usikkerhet</translation>
    </message>
    <message>
        <source>This chart compares runs of one scenario.</source>
        <translation>Dette diagrammet sammenligner flyginger av samme scenario.</translation>
    </message>
    <message>
        <source>%1.
Less ζ is better. Plain shade: A, %2, has less. Hatched: B, %3, has less.</source>
        <translation>%1.
Mindre ζ er bedre. Jevn skygge: A, %2, har mindre. Skravert: B, %3, har mindre.</translation>
    </message>
    <message>
        <source>Time, h:mm:ss</source>
        <translation>Tid, t:mm:ss</translation>
    </message>
    <message>
        <source>Time, mm:ss</source>
        <translation>Tid, mm:ss</translation>
    </message>
    <message>
        <source>Time, UTC</source>
        <translation>Tid, UTC</translation>
    </message>
    <message>
        <source>Zeta ζ, %1</source>
        <translation>Zeta ζ, %1</translation>
    </message>
</context>
<context>
    <name>berg::ComparisonPanel</name>
    <message>
        <source>Figures of the comparison</source>
        <translation>Tall for sammenligningen</translation>
    </message>
    <message>
        <source>Longest time unseen</source>
        <translation>Lengste tid usett</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Tall</translation>
    </message>
    <message>
        <source>Unseen</source>
        <translation>Usett</translation>
    </message>
    <message>
        <source>Longest time for which each iceberg was out of view.</source>
        <translation>Lengste tid hvert isfjell var ute av syne.</translation>
    </message>
    <message>
        <source>Progress of the flight in the background</source>
        <translation>Fremdrift for flygingen i bakgrunnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>τ</source>
        <translation>τ</translation>
    </message>
    <message>
        <source>Trade-off τ to fly</source>
        <translation>Avveining τ som skal flys</translation>
    </message>
    <message>
        <source>0: most uncertain first; the larger, the shorter the route.</source>
        <translation>0: mest usikre først; jo større verdi, desto kortere rute.</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>Fly av sted</translation>
    </message>
    <message>
        <source>Flies the same scenario with this τ in the background.</source>
        <translation>Flyr samme scenario med denne τ i bakgrunnen.</translation>
    </message>
    <message>
        <source>Open run…</source>
        <translation>Åpne flyging …</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Removes the chosen run from the list.</source>
        <translation>Fjerner den valgte flygingen fra listen.</translation>
    </message>
    <message>
        <source>Flying %1: %2 of %3</source>
        <translation>Flyr %1: %2 av %3</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Åpner %1</translation>
    </message>
    <message>
        <source>The reference A is the tour itself: choose another one as A.</source>
        <translation>Referansen A er selve rundturen: velg en annen som A.</translation>
    </message>
    <message>
        <source>Flies the same scenario along the shortest closed tour through all icebergs, as in Figure 5 of the paper, in the background.</source>
        <translation>Flyr samme scenario i bakgrunnen langs den korteste lukkede rundturen gjennom alle isfjell, som i figur 5 i artikkelen.</translation>
    </message>
    <message>
        <source>Compare with the round tour</source>
        <translation>Sammenlign med rundturen</translation>
    </message>
    <message>
        <source>Runs (*.bergrun);;All files (*)</source>
        <translation>Flyginger (*.bergrun);;Alle filer (*)</translation>
    </message>
</context>
<context>
    <name>berg::ComparisonTable</name>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
</context>
<context>
    <name>berg::ContextMenus</name>
    <message>
        <source>Assign to %1</source>
        <translation>Tildel til %1</translation>
    </message>
    <message>
        <source>Any UAV may visit it</source>
        <translation>Enhver UAV kan besøke det</translation>
    </message>
    <message>
        <source>Show in the inspector</source>
        <translation>Vis i Egenskaper</translation>
    </message>
    <message>
        <source>Edit in the inspector</source>
        <translation>Rediger i Egenskaper</translation>
    </message>
    <message>
        <source>Remove asset</source>
        <translation>Fjern objektet</translation>
    </message>
    <message>
        <source>Remove area</source>
        <translation>Fjern området</translation>
    </message>
    <message>
        <source>New iceberg here</source>
        <translation>Nytt isfjell her</translation>
    </message>
    <message>
        <source>New UAV here</source>
        <translation>Ny UAV her</translation>
    </message>
    <message>
        <source>Paste here</source>
        <translation>Lim inn her</translation>
    </message>
    <message>
        <source>Ground station here</source>
        <translation>Bakkestasjon her</translation>
    </message>
    <message>
        <source>Place ground station</source>
        <translation>Plasser bakkestasjonen</translation>
    </message>
    <message>
        <source>Remove no-fly area</source>
        <translation>Fjern flyforbudsområdet</translation>
    </message>
    <message>
        <source>Copy coordinates: %1</source>
        <translation>Kopier koordinater: %1</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>Kopierte %1</translation>
    </message>
    <message>
        <source>Centre the map here</source>
        <translation>Sentrer kartet her</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>Mål herfra</translation>
    </message>
    <message>
        <source>Place asset</source>
        <translation>Plasser objektet</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Fold ut</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Fold sammen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Skjul</translation>
    </message>
    <message>
        <source>Asset here</source>
        <translation>Objekt her</translation>
    </message>
    <message>
        <source>Asset</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Område</translation>
    </message>
    <message>
        <source>No-fly area</source>
        <translation>Flyforbudsområde</translation>
    </message>
</context>
<context>
    <name>berg::Docks</name>
    <message>
        <source>Trade-off</source>
        <translation>Avveining</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Rute</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Egenskaper</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historikk</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Hendelser</translation>
    </message>
    <message>
        <source>Comparison chart</source>
        <translation>Sammenligningsdiagram</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Kontroll</translation>
    </message>
    <message>
        <source>Solve time</source>
        <translation>Løsningstid</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Sammenligning</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>Map layers</source>
        <translation>Kartlag</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldinger</translation>
    </message>
    <message>
        <source>Trade-off τ, policy, solver and route</source>
        <translation>Avveining τ, strategi, løser og rutetype</translation>
    </message>
    <message>
        <source>Pareto curve</source>
        <translation>Paretokurve</translation>
    </message>
    <message>
        <source>First chart</source>
        <translation>Første diagram</translation>
    </message>
    <message>
        <source>Second chart</source>
        <translation>Andre diagram</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Luftfartøyer</translation>
    </message>
    <message>
        <source>Start times</source>
        <translation>Starttider</translation>
    </message>
</context>
<context>
    <name>berg::EventModel</name>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Hendelse</translation>
    </message>
    <message>
        <source>How it was planned</source>
        <translation>Hvordan det ble planlagt</translation>
    </message>
    <message>
        <source>warm start</source>
        <translation>varmstart</translation>
    </message>
    <message>
        <source>previous plan kept</source>
        <translation>forrige plan beholdt</translation>
    </message>
</context>
<context>
    <name>berg::EventPanel</name>
    <message>
        <source>Events of the mission</source>
        <translation>Oppdragets hendelser</translation>
    </message>
</context>
<context>
    <name>berg::ExampleCard</name>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n isfjell</numerusform>
            <numerusform>%n isfjell</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Eksporter</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fil</translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation>&amp;Bla gjennom …</translation>
    </message>
    <message>
        <source>Name the file.</source>
        <translation>Gi filen et navn.</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>Eksporter til</translation>
    </message>
    <message>
        <source>Format of the file</source>
        <translation>Filens format</translation>
    </message>
    <message>
        <source>Not possible</source>
        <translation>Ikke mulig</translation>
    </message>
    <message>
        <source>%1, %2, to %3</source>
        <translation>%1, %2, til %3</translation>
    </message>
    <message>
        <source>The file exists. Bergwatch asks before it overwrites it.</source>
        <translation>Filen finnes. Bergwatch spør før den overskrives.</translation>
    </message>
    <message>
        <source>Working ...</source>
        <translation>Arbeider …</translation>
    </message>
    <message>
        <source>Nothing was changed or left out.</source>
        <translation>Ingenting ble endret eller utelatt.</translation>
    </message>
</context>
<context>
    <name>berg::ExportOptionsView</name>
    <message>
        <source>What was flown</source>
        <translation>Det som er fløyet</translation>
    </message>
    <message>
        <source>The whole order</source>
        <translation>Hele rekkefølgen</translation>
    </message>
    <message>
        <source>The first leg</source>
        <translation>Første etappe</translation>
    </message>
    <message>
        <source>The path with turns</source>
        <translation>Banen med svinger</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>&amp;Hva</translation>
    </message>
    <message>
        <source>All UAVs</source>
        <translation>Alle UAV-er</translation>
    </message>
    <message>
        <source>&amp;UAV</source>
        <translation>&amp;UAV</translation>
    </message>
    <message>
        <source>As in the scenario</source>
        <translation>Som i scenarioet</translation>
    </message>
    <message>
        <source>&amp;Altitude</source>
        <translation>Hø&amp;yde</translation>
    </message>
    <message>
        <source>Air&amp;speed</source>
        <translation>Flyfa&amp;rt</translation>
    </message>
    <message>
        <source>A&amp;cceptance radius</source>
        <translation>&amp;Passeringsradius</translation>
    </message>
    <message>
        <source>None: fly over</source>
        <translation>Ingen: fly over</translation>
    </message>
    <message>
        <source>&amp;Loiter turns</source>
        <translation>&amp;Runder over isfjell</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nei</translation>
    </message>
    <message>
        <source>&amp;Return home</source>
        <translation>Fly h&amp;jem</translation>
    </message>
</context>
<context>
    <name>berg::ExportPreviewView</name>
    <message>
        <source>Home</source>
        <translation>Hjem</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posisjon</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>UAV</translation>
    </message>
    <message>
        <source>Waypoints of the file</source>
        <translation>Filens veipunkter</translation>
    </message>
    <message>
        <source>Map of what is exported</source>
        <translation>Kart over det som eksporteres</translation>
    </message>
    <message>
        <source>How the file begins</source>
        <translation>Begynnelsen av filen</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Kart</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Veipunkter</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Preview of the page</source>
        <translation>Forhåndsvisning av siden</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Side</translation>
    </message>
</context>
<context>
    <name>berg::Fields</name>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Shown on the map in place of the id.</source>
        <translation>Vises på kartet i stedet for id.</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Øst</translation>
    </message>
    <message>
        <source>Position at the start, east of the scenario&apos;s origin.</source>
        <translation>Posisjon ved start, øst for scenarioets origo.</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>Position at the start, north of the scenario&apos;s origin.</source>
        <translation>Posisjon ved start, nord for scenarioets origo.</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Clockwise from north, at the start.</source>
        <translation>Med klokken fra nord, ved start.</translation>
    </message>
    <message>
        <source>Airspeed</source>
        <translation>Flyfart</translation>
    </message>
    <message>
        <source>Must exceed the wind speed.</source>
        <translation>Må være høyere enn vindhastigheten.</translation>
    </message>
    <message>
        <source>Maximum bank angle</source>
        <translation>Største krengning</translation>
    </message>
    <message>
        <source>Bank in a turn; the larger, the tighter the turns.</source>
        <translation>Krengning i sving; jo større, desto krappere svinger.</translation>
    </message>
    <message>
        <source>View along-track</source>
        <translation>Synsfelt langs</translation>
    </message>
    <message>
        <source>Extent of the field of view along the heading.</source>
        <translation>Synsfeltets utstrekning langs kursen.</translation>
    </message>
    <message>
        <source>View cross-track</source>
        <translation>Synsfelt tvers</translation>
    </message>
    <message>
        <source>Extent of the field of view across the heading.</source>
        <translation>Synsfeltets utstrekning på tvers av kursen.</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Høyde</translation>
    </message>
    <message>
        <source>Height above sea level. UAVs at least %1 apart in height may pass each other.</source>
        <translation>Høyde over havet. UAV-er med minst %1 høydeforskjell kan passere hverandre.</translation>
    </message>
    <message>
        <source>unlimited</source>
        <translation>ubegrenset</translation>
    </message>
    <message>
        <source>Endurance</source>
        <translation>Utholdenhet</translation>
    </message>
    <message>
        <source>Longest flight; the UAV is home before it ends. At 0 it lands only when ordered to return.</source>
        <translation>Lengste flyging; UAV-en er hjemme før den er slutt. Ved 0 lander den bare etter ordre om å fly hjem.</translation>
    </message>
    <message>
        <source>Home east</source>
        <translation>Hjem øst</translation>
    </message>
    <message>
        <source>Landing place, east of the scenario&apos;s origin.</source>
        <translation>Landingssted, øst for scenarioets origo.</translation>
    </message>
    <message>
        <source>Home north</source>
        <translation>Hjem nord</translation>
    </message>
    <message>
        <source>Landing place, north of the scenario&apos;s origin.</source>
        <translation>Landingssted, nord for scenarioets origo.</translation>
    </message>
    <message>
        <source>Turn-around</source>
        <translation>Bakketid</translation>
    </message>
    <message>
        <source>Time on the ground between landing and the next take-off.</source>
        <translation>Tid på bakken mellom landing og neste avgang.</translation>
    </message>
    <message>
        <source>Reserve</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>Share of the endurance that plans leave unused.</source>
        <translation>Del av utholdenheten som planer ikke bruker.</translation>
    </message>
    <message>
        <source>by percentage</source>
        <translation>etter prosent</translation>
    </message>
    <message>
        <source>Fixed reserve</source>
        <translation>Fast reserve</translation>
    </message>
    <message>
        <source>Reserve as a time, in place of the percentage.</source>
        <translation>Reserve som tid, i stedet for prosentandelen.</translation>
    </message>
    <message>
        <source>Climb</source>
        <translation>Stigning</translation>
    </message>
    <message>
        <source>Time from take-off to the flight altitude.</source>
        <translation>Tid fra avgang til flygehøyden.</translation>
    </message>
    <message>
        <source>Landing</source>
        <translation>Landing</translation>
    </message>
    <message>
        <source>Time from the flight altitude above home to the ground.</source>
        <translation>Tid fra flyhøyden, over hjemstedet, ned til bakken.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>Wind limit</source>
        <translation>Vindgrense</translation>
    </message>
    <message>
        <source>Strongest wind in which the UAV may fly.</source>
        <translation>Sterkeste vind UAV-en kan fly i.</translation>
    </message>
    <message>
        <source>Gust limit</source>
        <translation>Vindkastgrense</translation>
    </message>
    <message>
        <source>Strongest gusts in which the UAV may fly.</source>
        <translation>Sterkeste vindkast UAV-en kan fly i.</translation>
    </message>
    <message>
        <source>Icing conditions</source>
        <translation>Isingsforhold</translation>
    </message>
    <message>
        <source>Whether the UAV may fly below 0 °C in nearly saturated air.</source>
        <translation>Om UAV-en kan fly under 0 °C i nesten mettet luft.</translation>
    </message>
    <message>
        <source>each time step</source>
        <translation>hvert tidssteg</translation>
    </message>
    <message>
        <source>Autopilot rate</source>
        <translation>Autopilotens takt</translation>
    </message>
    <message>
        <source>Time between two commands of the autopilot; at 0 it commands at each time step.</source>
        <translation>Tid mellom to kommandoer fra autopiloten; ved 0 gir den én i hvert tidssteg.</translation>
    </message>
    <message>
        <source>Drift east</source>
        <translation>Drift østover</translation>
    </message>
    <message>
        <source>Known drift to the east, without the current.</source>
        <translation>Kjent drift mot øst, uten strømmen.</translation>
    </message>
    <message>
        <source>Drift north</source>
        <translation>Drift nordover</translation>
    </message>
    <message>
        <source>Known drift to the north, without the current.</source>
        <translation>Kjent drift mot nord, uten strømmen.</translation>
    </message>
    <message>
        <source>Drift error</source>
        <translation>Driftfeil</translation>
    </message>
    <message>
        <source>Standard deviation of the error of the known drift, along each axis.</source>
        <translation>Standardavvik for feilen i den kjente driften, langs hver akse.</translation>
    </message>
    <message>
        <source>Drift variation</source>
        <translation>Variasjon i drift</translation>
    </message>
    <message>
        <source>Long-term standard deviation of the drift about the current, along each axis. Example, a beacon off Canada: 0.15 m/s.</source>
        <translation>Standardavvik for driften omkring strømmen i det lange løp, langs hver akse. Eksempel, en bøye utenfor Canada: 0,15 m/s.</translation>
    </message>
    <message>
        <source>Drift time constant</source>
        <translation>Driftens tidskonstant</translation>
    </message>
    <message>
        <source>Time in which a known drift fades to that of the current. At 0 the drift is constant. Example, a beacon off Canada: 36,000 s.</source>
        <translation>Tiden det tar før en kjent drift nærmer seg strømmen. Ved 0 er driften konstant. Eksempel, en bøye utenfor Canada: 36 000 s.</translation>
    </message>
    <message>
        <source>Growth q</source>
        <translation>Vekst q</translation>
    </message>
    <message>
        <source>Growth of the uncertainty per second out of view.</source>
        <translation>Veksten i usikkerheten per sekund ute av syne.</translation>
    </message>
    <message>
        <source>Uncertainty σ₀</source>
        <translation>Usikkerhet σ₀</translation>
    </message>
    <message>
        <source>Variance of the position when it was last seen.</source>
        <translation>Variansen til posisjonen da det sist ble sett.</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Sist sett</translation>
    </message>
    <message>
        <source>Time between the last sighting and the start; σ has grown since.</source>
        <translation>Tiden mellom siste observasjon og starten; σ har vokst siden.</translation>
    </message>
    <message>
        <source>Appears at</source>
        <translation>Dukker opp</translation>
    </message>
    <message>
        <source>Run time from which the iceberg is known; 0 is the start.</source>
        <translation>Tidspunktet da isfjellet blir kjent; 0 er starten.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Halvlengde</translation>
    </message>
    <message>
        <source>Half its length. It sets the size on the map and how far outside the area the iceberg is monitored.</source>
        <translation>Halve lengden. Den bestemmer størrelsen på kartet og hvor langt utenfor området isfjellet overvåkes.</translation>
    </message>
    <message>
        <source>Visited by</source>
        <translation>Besøkes av</translation>
    </message>
    <message>
        <source>The only UAV that may visit it.</source>
        <translation>Den eneste UAV-en som kan besøke det.</translation>
    </message>
    <message>
        <source>Speed east</source>
        <translation>Fart øst</translation>
    </message>
    <message>
        <source>Speed of a ship to the east; 0 for a platform.</source>
        <translation>Et skips fart mot øst; 0 for en plattform.</translation>
    </message>
    <message>
        <source>Speed north</source>
        <translation>Fart nord</translation>
    </message>
    <message>
        <source>Speed of a ship to the north; 0 for a platform.</source>
        <translation>Et skips fart mot nord; 0 for en plattform.</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Rekkevidde</translation>
    </message>
    <message>
        <source>Distance within which icebergs matter to the asset.</source>
        <translation>Avstanden der isfjell har betydning for objektet.</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Vekt</translation>
    </message>
    <message>
        <source>Additional weight of an iceberg at the asset.</source>
        <translation>Ekstra vekt for et isfjell ved objektet.</translation>
    </message>
    <message>
        <source>half the range</source>
        <translation>halve rekkevidden</translation>
    </message>
    <message>
        <source>Inner ring</source>
        <translation>Indre ring</translation>
    </message>
    <message>
        <source>An iceberg predicted to enter it within an hour raises an alarm. At 0 it is half the range.</source>
        <translation>Et isfjell som forutsies å komme inn i den innen en time, utløser alarm. Ved 0 er den halve rekkevidden.</translation>
    </message>
    <message>
        <source>Stand-off ring</source>
        <translation>Sikkerhetsring</translation>
    </message>
    <message>
        <source>Least distance of UAVs from the asset; for a ship, from its whole track.</source>
        <translation>Minste avstand for UAV-er til objektet; for et skip, til hele sporet.</translation>
    </message>
    <message>
        <source>Stand-off ceiling</source>
        <translation>Tak for sikkerhetsringen</translation>
    </message>
    <message>
        <source>Height above which UAVs may cross the ring.</source>
        <translation>Høyden der UAV-er kan krysse over ringen.</translation>
    </message>
    <message>
        <source>Shown on the map.</source>
        <translation>Vises på kartet.</translation>
    </message>
    <message>
        <source>Corner of the no-fly area</source>
        <translation>Hjørne i flyforbudsområdet</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Gulv</translation>
    </message>
    <message>
        <source>UAVs below this height may pass under the area.</source>
        <translation>UAV-er under denne høyden kan passere under området.</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>Tak</translation>
    </message>
    <message>
        <source>UAVs above this height may pass over the area.</source>
        <translation>UAV-er over denne høyden kan passere over området.</translation>
    </message>
    <message>
        <source>Corner of the airspace</source>
        <translation>Hjørne av luftrommet</translation>
    </message>
    <message>
        <source>Start of the airspace</source>
        <translation>Luftrommets start</translation>
    </message>
    <message>
        <source>End of the airspace</source>
        <translation>Luftrommets slutt</translation>
    </message>
    <message>
        <source>Station east</source>
        <translation>Stasjon øst</translation>
    </message>
    <message>
        <source>East of the scenario&apos;s origin.</source>
        <translation>Øst for scenarioets origo.</translation>
    </message>
    <message>
        <source>Station north</source>
        <translation>Stasjon nord</translation>
    </message>
    <message>
        <source>North of the scenario&apos;s origin.</source>
        <translation>Nord for scenarioets origo.</translation>
    </message>
    <message>
        <source>Antenna height</source>
        <translation>Antennehøyde</translation>
    </message>
    <message>
        <source>Height above the sea.</source>
        <translation>Høyde over havet.</translation>
    </message>
    <message>
        <source>radio horizon</source>
        <translation>radiohorisont</translation>
    </message>
    <message>
        <source>Link range</source>
        <translation>Sambandsrekkevidde</translation>
    </message>
    <message>
        <source>Range of the link; the lowest value means the radio horizon of the antenna and the UAV&apos;s altitude.</source>
        <translation>Rekkevidden til sambandet; den laveste verdien betyr radiohorisonten for antennen og UAV-ens høyde.</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margin</translation>
    </message>
    <message>
        <source>Distance around all places of the plan, for turns and replanning. Not used with a geofence.</source>
        <translation>Avstand rundt alle steder i planen, til svinger og nye planer. Brukes ikke med geogjerde.</translation>
    </message>
    <message>
        <source>UAV size</source>
        <translation>UAV-størrelse</translation>
    </message>
    <message>
        <source>Largest dimension of a UAV; half of it is added to the ground-risk buffer.</source>
        <translation>Største mål på en UAV; halvparten legges til bakkerisikobufferen.</translation>
    </message>
    <message>
        <source>Satellite position error</source>
        <translation>Feil i satellittposisjon</translation>
    </message>
    <message>
        <source>Part of the width of the contingency volume. Source: Digisky 3.3.0, after the guide of the Swiss FOCA: 3 m.</source>
        <translation>Del av beredskapsvolumets bredde. Kilde: Digisky 3.3.0, etter veiledningen fra sveitsiske FOCA: 3 m.</translation>
    </message>
    <message>
        <source>Path-keeping error</source>
        <translation>Feil i banefølging</translation>
    </message>
    <message>
        <source>Error of the autopilot, part of the width of the contingency volume. Same source: 3 m.</source>
        <translation>Autopilotens feil, del av beredskapsvolumets bredde. Samme kilde: 3 m.</translation>
    </message>
    <message>
        <source>Map error</source>
        <translation>Kartfeil</translation>
    </message>
    <message>
        <source>Part of the width of the contingency volume. Same source: 1 m.</source>
        <translation>Del av beredskapsvolumets bredde. Samme kilde: 1 m.</translation>
    </message>
    <message>
        <source>Reaction time</source>
        <translation>Reaksjonstid</translation>
    </message>
    <message>
        <source>Time at full speed before the crew reacts. Same source: 1 s.</source>
        <translation>Tid i full fart før mannskapet reagerer. Samme kilde: 1 s.</translation>
    </message>
    <message>
        <source>Bank of the turn back</source>
        <translation>Krengning i vendingen tilbake</translation>
    </message>
    <message>
        <source>Sets the turn radius v²/(g tan bank). Same source: 30°.</source>
        <translation>Bestemmer svingradien v²/(g tan krengning). Samme kilde: 30°.</translation>
    </message>
    <message>
        <source>Height error</source>
        <translation>Høydefeil</translation>
    </message>
    <message>
        <source>Part of the height of the contingency volume. Same source: 4 m.</source>
        <translation>Del av beredskapsvolumets høyde. Samme kilde: 4 m.</translation>
    </message>
    <message>
        <source>Climb part</source>
        <translation>Stigeandel</translation>
    </message>
    <message>
        <source>Share of the speed that is climb during the reaction time. Same source: 0.707, a climb of 45°.</source>
        <translation>Andelen av farten som er stigning i reaksjonstiden. Samme kilde: 0,707, en stigning på 45°.</translation>
    </message>
    <message>
        <source>Pull-up part</source>
        <translation>Utflatingsandel</translation>
    </message>
    <message>
        <source>Height needed to level out, as a share of v²/g. Same source: 0.3.</source>
        <translation>Høyden som kreves for å flate ut, som andel av v²/g. Samme kilde: 0,3.</translation>
    </message>
    <message>
        <source>Buffer ratio</source>
        <translation>Bufferforhold</translation>
    </message>
    <message>
        <source>Width of the ground-risk buffer divided by the height of the contingency volume. Same source: 1, the 1:1 rule.</source>
        <translation>Bakkerisikobufferens bredde delt på beredskapsvolumets høyde. Samme kilde: 1, regelen 1:1.</translation>
    </message>
    <message>
        <source>Adjacent area, time</source>
        <translation>Tilstøtende område, tid</translation>
    </message>
    <message>
        <source>Flight time at full speed. Same source: 180 s.</source>
        <translation>Flytid i full fart. Samme kilde: 180 s.</translation>
    </message>
    <message>
        <source>Adjacent area, minimum</source>
        <translation>Tilstøtende område, minimum</translation>
    </message>
    <message>
        <source>Minimum width. Same source: 5 km.</source>
        <translation>Minste bredde. Samme kilde: 5 km.</translation>
    </message>
    <message>
        <source>Adjacent area, maximum</source>
        <translation>Tilstøtende område, maksimum</translation>
    </message>
    <message>
        <source>Maximum width. Same source: 35 km.</source>
        <translation>Største bredde. Samme kilde: 35 km.</translation>
    </message>
    <message>
        <source>Crew</source>
        <translation>Mannskap</translation>
    </message>
    <message>
        <source>Names printed in the flight brief. If empty, the brief has a blank line.</source>
        <translation>Navn som skrives ut på flygearket. Hvis feltet er tomt, får arket en blank linje.</translation>
    </message>
    <message>
        <source>Call sign</source>
        <translation>Kallesignal</translation>
    </message>
    <message>
        <source>Printed in the flight brief. If empty, the brief has a blank line.</source>
        <translation>Skrives ut på flygearket. Hvis feltet er tomt, får arket en blank linje.</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakter</translation>
    </message>
    <message>
        <source>Ship, air traffic service, rescue: names, numbers, frequencies.</source>
        <translation>Skip, lufttrafikktjeneste, redning: navn, numre, frekvenser.</translation>
    </message>
    <message>
        <source>Command link</source>
        <translation>Kommandolink</translation>
    </message>
    <message>
        <source>How the UAVs are commanded, and what they do if the link is lost.</source>
        <translation>Hvordan UAV-ene styres, og hva de gjør hvis sambandet faller ut.</translation>
    </message>
    <message>
        <source>Checklist</source>
        <translation>Sjekkliste</translation>
    </message>
    <message>
        <source>One item per line, printed with a box to tick.</source>
        <translation>Ett punkt per linje, skrevet ut med en rute til å krysse av.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>ikke kjent</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Vindkast</translation>
    </message>
    <message>
        <source>Speed of the gusts, compared with the limits of the UAVs.</source>
        <translation>Farten til vindkastene, sammenlignet med grensene for UAV-ene.</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Air temperature at sea level.</source>
        <translation>Luftens temperatur ved havoverflaten.</translation>
    </message>
    <message>
        <source>Dew point</source>
        <translation>Duggpunkt</translation>
    </message>
    <message>
        <source>Dew point at sea level. With the temperature it shows whether ice may form.</source>
        <translation>Duggpunkt ved havoverflaten. Sammen med temperaturen viser det om is kan dannes.</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Coordinate of the origin, in any format; a full coordinate or a place name sets both. Everything moves with it.</source>
        <translation>Origos koordinat, i en hvilken som helst form; en hel koordinat eller et stedsnavn setter begge. Alt flyttes med.</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Lengde</translation>
    </message>
    <message>
        <source>Observer</source>
        <translation>Observatør</translation>
    </message>
    <message>
        <source>Exact: a sighting gives the true position. Filter: position and velocity are estimated from noisy measurements, and icebergs can get lost.</source>
        <translation>Eksakt: en observasjon gir den sanne posisjonen. Filter: posisjon og hastighet anslås fra målinger med støy, og isfjell kan gå tapt.</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Posisjonsfeil</translation>
    </message>
    <message>
        <source>Standard deviation of a measured position, along each axis.</source>
        <translation>Standardavvik for en målt posisjon, langs hver akse.</translation>
    </message>
    <message>
        <source>Sensor interval</source>
        <translation>Sensorintervall</translation>
    </message>
    <message>
        <source>Time between two samples of the sensor, each of which measures what is in view.</source>
        <translation>Tid mellom to målinger fra sensoren; hver av dem måler det som er i syne.</translation>
    </message>
    <message>
        <source>Detection probability</source>
        <translation>Deteksjonssannsynlighet</translation>
    </message>
    <message>
        <source>Probability that one sample shows an iceberg in view.</source>
        <translation>Sannsynligheten for at én måling viser et isfjell i syne.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Leting</translation>
    </message>
    <message>
        <source>Search pattern for an iceberg that is not at its estimated position.</source>
        <translation>Letemønster for et isfjell som ikke er i den estimerte posisjonen.</translation>
    </message>
    <message>
        <source>Trade-off τ</source>
        <translation>Avveining τ</translation>
    </message>
    <message>
        <source>Formulation</source>
        <translation>Formulering</translation>
    </message>
    <message>
        <source>Integer program that COIN-OR CBC solves when it is the solver.</source>
        <translation>Heltallsprogrammet som COIN-OR CBC løser når den er valgt.</translation>
    </message>
    <message>
        <source>Planning time</source>
        <translation>Planleggingstid</translation>
    </message>
    <message>
        <source>Time to make a plan in flight; until it is ready the UAV continues with the previous plan.</source>
        <translation>Tiden det tar å lage en plan under flyging; til den er klar, fortsetter UAV-en med den forrige.</translation>
    </message>
    <message>
        <source>in view</source>
        <translation>i syne</translation>
    </message>
    <message>
        <source>Acceptance radius</source>
        <translation>Passeringsradius</translation>
    </message>
    <message>
        <source>Distance at which an iceberg counts as reached; at 0 it is reached when it is in view.</source>
        <translation>Avstanden der et isfjell regnes som nådd; ved 0 er det nådd når det er i syne.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Synsfelt</translation>
    </message>
    <message>
        <source>Shape of the area that the camera covers.</source>
        <translation>Formen på området som kameraet dekker.</translation>
    </message>
    <message>
        <source>Group nearby icebergs</source>
        <translation>Grupper nære isfjell</translation>
    </message>
    <message>
        <source>Icebergs that fit into one field of view are planned as one point, from which all are seen.</source>
        <translation>Isfjell som får plass i ett synsfelt, planlegges som ett punkt der alle er i syne.</translation>
    </message>
    <message>
        <source>Title of the scenario, shown on the map.</source>
        <translation>Tittelen på scenarioet, vist på kartet.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notater</translation>
    </message>
    <message>
        <source>Any text, stored in the file.</source>
        <translation>Valgfri tekst som lagres i filen.</translation>
    </message>
    <message>
        <source>Start (UTC)</source>
        <translation>Starttid (UTC)</translation>
    </message>
    <message>
        <source>Date and time of the start, such as 2026-11-29 12:00 or 29 Nov 2026 12:00; 1200Z keeps the date. Empty: times are relative.</source>
        <translation>Dato og klokkeslett for start, som 2026-11-29 12:00 eller 29 Nov 2026 12:00; 1200Z beholder datoen. Tomt: tidene er relative.</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Varighet</translation>
    </message>
    <message>
        <source>Length of the run, at most seven days.</source>
        <translation>Flygingens lengde, høyst sju døgn.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startfrø</translation>
    </message>
    <message>
        <source>Seed of the random drift: the same seed repeats the run.</source>
        <translation>Startfrø for den tilfeldige driften: det samme startfrøet gjentar flygingen.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Tidssteg</translation>
    </message>
    <message>
        <source>Step of the simulation; a smaller step is more exact and slower.</source>
        <translation>Steget i simuleringen; et mindre steg er mer nøyaktig og langsommere.</translation>
    </message>
    <message>
        <source>Random drift</source>
        <translation>Tilfeldig drift</translation>
    </message>
    <message>
        <source>Off: icebergs drift exactly as known.</source>
        <translation>Av: isfjell driver nøyaktig som kjent.</translation>
    </message>
    <message>
        <source>Wind east</source>
        <translation>Vind østover</translation>
    </message>
    <message>
        <source>Towards the east; must be below the UAV&apos;s airspeed.</source>
        <translation>Mot øst; må være lavere enn UAV-ens flyfart.</translation>
    </message>
    <message>
        <source>Wind north</source>
        <translation>Vind nordover</translation>
    </message>
    <message>
        <source>Towards the north; must be below the UAV&apos;s airspeed.</source>
        <translation>Mot nord; må være lavere enn UAV-ens flyfart.</translation>
    </message>
    <message>
        <source>Current east</source>
        <translation>Strøm østover</translation>
    </message>
    <message>
        <source>Carries every iceberg towards the east.</source>
        <translation>Fører alle isfjell mot øst.</translation>
    </message>
    <message>
        <source>Current north</source>
        <translation>Strøm nordover</translation>
    </message>
    <message>
        <source>Carries every iceberg towards the north.</source>
        <translation>Fører alle isfjell mot nord.</translation>
    </message>
    <message>
        <source>Corner of the area</source>
        <translation>Hjørne av området</translation>
    </message>
    <message>
        <source>Geofence</source>
        <translation>Geogjerde</translation>
    </message>
    <message>
        <source>UAVs stay inside the area if they start clear of its edge.</source>
        <translation>UAV-er som starter klar av kanten, holder seg innenfor området.</translation>
    </message>
    <message>
        <source>no separation</source>
        <translation>ikke noe avstandskrav</translation>
    </message>
    <message>
        <source>Separation</source>
        <translation>Avstand mellom UAV-er</translation>
    </message>
    <message>
        <source>Least distance between UAVs whose altitudes differ by less than %1.</source>
        <translation>Minste avstand mellom UAV-er med mindre enn %1 høydeforskjell.</translation>
    </message>
    <message>
        <source>Autopilot</source>
        <translation>Autopilotprogram</translation>
    </message>
    <message>
        <source>Firmware for which missions are exported.</source>
        <translation>Fastvaren som oppdrag eksporteres for.</translation>
    </message>
    <message>
        <source>Airframe</source>
        <translation>Flytype</translation>
    </message>
    <message>
        <source>A VTOL and a multirotor fly over icebergs without loiter circles.</source>
        <translation>En VTOL og en multirotor flyr over isfjell uten ventesirkler.</translation>
    </message>
    <message>
        <source>Take-off</source>
        <translation>Avgang</translation>
    </message>
    <message>
        <source>By mission item, or by hand: then the mission is started in the air.</source>
        <translation>Med et oppdragselement, eller for hånd: da startes oppdraget i luften.</translation>
    </message>
    <message>
        <source>Take-off altitude</source>
        <translation>Avgangshøyde</translation>
    </message>
    <message>
        <source>Height above home at which the first leg begins.</source>
        <translation>Høyden over hjemstedet der den første etappen begynner.</translation>
    </message>
    <message>
        <source>Take-off pitch</source>
        <translation>Pitchvinkel ved avgang</translation>
    </message>
    <message>
        <source>Least pitch of a fixed wing in the take-off.</source>
        <translation>Minste pitchvinkel for et fastvinget fly ved avgang.</translation>
    </message>
    <message>
        <source>End of the mission</source>
        <translation>Slutten på oppdraget</translation>
    </message>
    <message>
        <source>What the last items of an exported mission do, unless it ends over the last iceberg.</source>
        <translation>Hva de siste elementene i et eksportert oppdrag gjør, hvis det ikke slutter over det siste isfjellet.</translation>
    </message>
    <message>
        <source>Approach leg</source>
        <translation>Innflygingsetappe</translation>
    </message>
    <message>
        <source>Distance from the loiter in which the UAV descends to the landing place.</source>
        <translation>Avstand fra ventesirkelen der UAV-en går ned, til landingsstedet.</translation>
    </message>
    <message>
        <source>Approach altitude</source>
        <translation>Innflygingshøyde</translation>
    </message>
    <message>
        <source>Height above home to which the UAV descends before the approach.</source>
        <translation>Høyden over hjemstedet som UAV-en går ned til før innflygingen.</translation>
    </message>
    <message>
        <source>into the wind</source>
        <translation>mot vinden</translation>
    </message>
    <message>
        <source>Approach course</source>
        <translation>Innflygingskurs</translation>
    </message>
    <message>
        <source>Course of the approach, clockwise from north; 360 is north.</source>
        <translation>Kursen på innflygingen, med klokken fra nord; 360 er nord.</translation>
    </message>
    <message>
        <source>tightest turn</source>
        <translation>krappeste sving</translation>
    </message>
    <message>
        <source>Loiter radius</source>
        <translation>Venteradius</translation>
    </message>
    <message>
        <source>Radius of loiters in missions; never less than the tightest turn in the wind.</source>
        <translation>Radius på ventesirkler i oppdrag; aldri mindre enn den krappeste svingen i vinden.</translation>
    </message>
    <message>
        <source>Hover speed</source>
        <translation>Svevefart</translation>
    </message>
    <message>
        <source>Speed of a VTOL while it flies like a multirotor.</source>
        <translation>Farten til en VTOL mens den flyr som en multirotor.</translation>
    </message>
    <message>
        <source>Speed in the mission</source>
        <translation>Fart i oppdraget</translation>
    </message>
    <message>
        <source>Off: the autopilot flies at the speed of its own parameters.</source>
        <translation>Av: autopiloten flyr med farten i sine egne parametere.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>What triggers the camera over an iceberg; it is off between icebergs.</source>
        <translation>Hva som utløser kameraet over et isfjell; det er av mellom isfjell.</translation>
    </message>
    <message>
        <source>Trigger distance</source>
        <translation>Utløseravstand</translation>
    </message>
    <message>
        <source>Distance flown between two pictures.</source>
        <translation>Avstanden som flys mellom to bilder.</translation>
    </message>
    <message>
        <source>Trigger interval</source>
        <translation>Utløserintervall</translation>
    </message>
    <message>
        <source>Time between two pictures.</source>
        <translation>Tiden mellom to bilder.</translation>
    </message>
    <message>
        <source>Gimbal down</source>
        <translation>Gimbal ned</translation>
    </message>
    <message>
        <source>An item of the mission points the gimbal straight down.</source>
        <translation>Et element i oppdraget retter gimbalen loddrett ned.</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Tåke</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Sikt</translation>
    </message>
    <message>
        <source>Cloud base</source>
        <translation>Skybase</translation>
    </message>
    <message>
        <source>Depth of the sea</source>
        <translation>Havdybde</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengde</translation>
    </message>
    <message>
        <source>Length at the waterline. With it, wind and current carry the iceberg, and it may run aground; without it, the current alone.</source>
        <translation>Lengden i vannlinjen. Med den fører vind og strøm isfjellet, og det kan gå på grunn; uten den bare strømmen.</translation>
    </message>
    <message>
        <source>Source of the ice chart</source>
        <translation>Kilde til iskartet</translation>
    </message>
    <message>
        <source>Date of the ice chart</source>
        <translation>Dato for iskartet</translation>
    </message>
    <message>
        <source>Label of the ice</source>
        <translation>Etikett for isen</translation>
    </message>
    <message>
        <source>Ice concentration</source>
        <translation>Iskonsentrasjon</translation>
    </message>
    <message>
        <source>Fast ice</source>
        <translation>Fastis</translation>
    </message>
    <message>
        <source>Visibility limit</source>
        <translation>Siktgrense</translation>
    </message>
    <message>
        <source>Shortest visibility in which the UAV may fly; compared with the forecast.</source>
        <translation>Korteste sikt som UAV-en kan fly i; sammenlignes med varselet.</translation>
    </message>
    <message>
        <source>Ceiling limit</source>
        <translation>Skybasegrense</translation>
    </message>
    <message>
        <source>Lowest cloud base, above sea level, in which the UAV may fly; compared with the forecast.</source>
        <translation>Laveste skybase, over havet, som UAV-en kan fly i; sammenlignes med varselet.</translation>
    </message>
    <message>
        <source>Unique in the file; without it, uav-1, uav-2, ... or berg-1, berg-2, ... in the order of the file.</source>
        <translation>Entydig i filen; uten den uav-1, uav-2, ... eller berg-1, berg-2, ... i filens rekkefølge.</translation>
    </message>
    <message>
        <source>Position at the start; of an iceberg the estimate, which is the truth in the simple model.</source>
        <translation>Stedet ved starten; for et isfjell estimatet, som er sannheten i den enkle modellen.</translation>
    </message>
    <message>
        <source>Extent of the field of view along and across the heading.</source>
        <translation>Synsfelt langs og på tvers av kursen.</translation>
    </message>
    <message>
        <source>Landing place; without it, where the UAV starts.</source>
        <translation>Landingsplass; uten den der UAV-en starter.</translation>
    </message>
    <message>
        <source>Time between two commands of the autopilot; 0 means every time step. After an order to return home, a slower autopilot commands once a second.</source>
        <translation>Tid mellom to kommandoer fra autopiloten; 0 betyr hvert tidssteg. Etter en ordre om å fly hjem gir en langsommere autopilot én kommando i sekundet.</translation>
    </message>
    <message>
        <source>Drift velocity, without the current.</source>
        <translation>Driftens hastighet, uten strømmen.</translation>
    </message>
    <message>
        <source>Standard deviation of the error of the drift velocity, along each axis (Kalman observer).</source>
        <translation>Standardavviket til feilen i driftens hastighet, langs hver akse (Kalman-observatør).</translation>
    </message>
    <message>
        <source>Changing drift (Kalman observer): standard deviation with which the velocity varies about the current. A fit to a beacon gave 0.15 m/s.</source>
        <translation>Drift som endrer seg (Kalman-observatør): standardavviket som hastigheten varierer om strømmen med. En tilpasning til en drivbøye ga 0.15 m/s.</translation>
    </message>
    <message>
        <source>Changing drift (Kalman observer): time in which the velocity fades to the current (to 1/e); 0 means constant drift. A fit to a beacon gave 36000 s.</source>
        <translation>Drift som endrer seg (Kalman-observatør): tiden der hastigheten nærmer seg strømmen (til 1/e); 0 betyr konstant drift. En tilpasning til en drivbøye ga 36000 s.</translation>
    </message>
    <message>
        <source>Age of the last sighting at t = 0: adds q x age and (`velocity_sd_mps` x age)^2 to `sigma0_m2`; with changing drift the formula is that of the drift process.</source>
        <translation>Alderen på siste observasjon ved t = 0: legger q x alder og (`velocity_sd_mps` x alder)^2 til `sigma0_m2`; når driften endrer seg, gjelder formelen for driftprosessen.</translation>
    </message>
    <message>
        <source>Id of the only UAV that may visit it; empty allows any UAV.</source>
        <translation>Id til den eneste UAV-en som kan besøke det; tom tillater en hvilken som helst UAV.</translation>
    </message>
    <message>
        <source>Speed of a ship; 0 for a platform.</source>
        <translation>Farten til et skip; 0 for en plattform.</translation>
    </message>
    <message>
        <source>UAVs that start clear of the asset keep this distance, from a ship to its whole track.</source>
        <translation>UAV-er som starter klar av objektet, holder denne avstanden, for et skip til hele sporet.</translation>
    </message>
    <message>
        <source>Corners of the area.</source>
        <translation>Hjørner i området.</translation>
    </message>
    <message>
        <source>Name of the airspace.</source>
        <translation>Navnet på luftrommet.</translation>
    </message>
    <message>
        <source>Class or type of the airspace.</source>
        <translation>Klasse eller type luftrom.</translation>
    </message>
    <message>
        <source>Lower limit, above the sea.</source>
        <translation>Nedre grense, over havet.</translation>
    </message>
    <message>
        <source>Upper limit, above the sea.</source>
        <translation>Øvre grense, over havet.</translation>
    </message>
    <message>
        <source>Time from which the airspace exists; without it, always.</source>
        <translation>Tiden luftrommet finnes fra; uten den alltid.</translation>
    </message>
    <message>
        <source>Time until which the airspace exists, not before `from_utc`; without it, always.</source>
        <translation>Tiden luftrommet finnes til, ikke før `from_utc`; uten den alltid.</translation>
    </message>
    <message>
        <source>Position of the antenna.</source>
        <translation>Antennens sted.</translation>
    </message>
    <message>
        <source>Latitude of the local plane&apos;s origin.</source>
        <translation>Breddegraden til origo i det lokale planet.</translation>
    </message>
    <message>
        <source>Longitude of the local plane&apos;s origin.</source>
        <translation>Lengdegraden til origo i det lokale planet.</translation>
    </message>
    <message>
        <source>With `simple`, the estimate of an iceberg in view is the truth; with `kalman`, a filter uses noisy measurements.</source>
        <translation>Med `simple` er estimatet for et isfjell i syne sannheten; med `kalman` bruker et filter målinger med støy.</translation>
    </message>
    <message>
        <source>Policy that chooses the orders.</source>
        <translation>Regelen som velger rekkefølgene.</translation>
    </message>
    <message>
        <source>0 visits the most uncertain iceberg first; a large value gives the shortest path.</source>
        <translation>0 besøker det mest usikre isfjellet først; en stor verdi gir den korteste veien.</translation>
    </message>
    <message>
        <source>Whether the path ends over the last iceberg or returns to its start.</source>
        <translation>Om veien slutter over det siste isfjellet eller går tilbake til starten.</translation>
    </message>
    <message>
        <source>Solver of the orders.</source>
        <translation>Løseren for rekkefølgene.</translation>
    </message>
    <message>
        <source>An iceberg is reached within this distance. Without it, an iceberg is reached when it is in view; with measurements, when its estimate is in view after a sighting.</source>
        <translation>Et isfjell er nådd innenfor denne avstanden. Uten den er et isfjell nådd når det er i syne; med målinger når estimatet er i syne etter en observasjon.</translation>
    </message>
    <message>
        <source>Shape of the field of view. The diameter of a disk is `fov_m[0]`; the second number has no effect.</source>
        <translation>Formen på synsfeltet. Diameteren til en disk er `fov_m[0]`; det andre tallet er uten virkning.</translation>
    </message>
    <message>
        <source>Start time, ISO 8601 with Z; without it, times are relative.</source>
        <translation>Starttid, ISO 8601 med Z; uten den er tider relative.</translation>
    </message>
    <message>
        <source>If false, nothing is random: icebergs drift at their given velocities, and measurements detect every iceberg in view.</source>
        <translation>Hvis false, er ingenting tilfeldig: isfjell driver med de oppgitte hastighetene, og målinger oppdager hvert isfjell i syne.</translation>
    </message>
    <message>
        <source>Velocity over ground; the wind must be slower than the airspeed.</source>
        <translation>Hastighet over grunnen; vinden må være langsommere enn flyfarten.</translation>
    </message>
    <message>
        <source>Velocity over ground; the current carries every iceberg.</source>
        <translation>Hastighet over grunnen; strømmen fører med seg hvert isfjell.</translation>
    </message>
    <message>
        <source>Corners of the monitored area; an iceberg that is farther outside than its radius is no longer monitored.</source>
        <translation>Hjørnene i det overvåkede området; et isfjell som er lenger utenfor enn radien sin, overvåkes ikke lenger.</translation>
    </message>
    <message>
        <source>UAVs that start clear of the edge of `area_m` stay inside it; `validate` warns if a start leaves no safe turn or path home, but the flight is allowed.</source>
        <translation>UAV-er som starter klar av kanten av `area_m`, holder seg innenfor; `validate` advarer hvis en start ikke gir noen trygg sving eller trygg vei hjem, men flygingen er tillatt.</translation>
    </message>
    <message>
        <source>Least distance between UAVs whose altitudes differ by less than %1, after they have reached it (`validate` gives a hint if they start nearer); 0 turns separation off.</source>
        <translation>Minste avstand mellom UAV-er med mindre enn %1 høydeforskjell, etter at de har nådd den (`validate` gir et tips hvis de starter nærmere); 0 slår avstanden av.</translation>
    </message>
    <message>
        <source>Areas that UAVs stay out of if they start clear of them; with geofence and stand-off ring at most 200 corners at the altitude of a UAV.</source>
        <translation>Områder som UAV-er holder seg utenfor hvis de starter klar av dem; med geogjerde og sikkerhetsring høyst 200 hjørner i høyden til en UAV.</translation>
    </message>
    <message>
        <source>Airspace, for information: a check reports that the operation may enter it, but no UAV is kept out.</source>
        <translation>Luftrom, til opplysning: en kontroll melder at operasjonen kan komme inn i det, men ingen UAV holdes ute.</translation>
    </message>
    <message>
        <source>Content of a permit application: constants of the operation volume, and texts for the flight brief.</source>
        <translation>Innholdet i en søknad om tillatelse: konstantene i operasjonsvolumet og tekster til flygearket.</translation>
    </message>
    <message>
        <source>Protected asset.</source>
        <translation>Beskyttet objekt.</translation>
    </message>
    <message>
        <source>Missing values are not checked.</source>
        <translation>Verdier som mangler, kontrolleres ikke.</translation>
    </message>
    <message>
        <source>`{&quot;time_s&quot;: [...], &quot;position_m&quot;: [[x, y], ...]}`: true positions, instead of random drift.</source>
        <translation>`{&quot;time_s&quot;: [...], &quot;position_m&quot;: [[x, y], ...]}`: sanne posisjoner, i stedet for tilfeldig drift.</translation>
    </message>
    <message>
        <source>required</source>
        <translation>påkrevd</translation>
    </message>
    <message>
        <source>`%1` in older files.</source>
        <translation>`%1` i eldre filer.</translation>
    </message>
    <message>
        <source>Longest flight; the UAV is home before it ends. Without it, the UAV lands only when ordered to return.</source>
        <translation>Lengste flyging; UAV-en er hjemme før den er slutt. Uten den lander UAV-en bare på ordre om å fly hjem.</translation>
    </message>
    <message>
        <source>Range of the link; without it, the radio horizon of the antenna and the UAV&apos;s altitude.</source>
        <translation>Rekkevidden til sambandet; uten den radiohorisonten til antennen og høyden til UAV-en.</translation>
    </message>
    <message>
        <source>Length at the waterline: wind and current then carry the iceberg by the balance of their drags (below 15 m: the current and 2 % of the wind, turned 20 degrees), and it stands still where a `forecast` gives a depth below its draft of 1.78 L^0.71. Without it the current alone carries the iceberg.</source>
        <translation>Lengden i vannlinjen: vind og strøm fører da isfjellet etter likevekten mellom motstandene (under 15 m: strømmen og 2 % av vinden, dreid 20 grader), og det står stille der et `forecast` gir en dybde under dypgangen 1,78 L^0,71. Uten lengde fører bare strømmen isfjellet.</translation>
    </message>
    <message>
        <source>File or service that the chart comes from.</source>
        <translation>Filen eller tjenesten som iskartet kommer fra.</translation>
    </message>
    <message>
        <source>Date of the chart; without it, unknown.</source>
        <translation>Datoen for kartet; uten den er den ukjent.</translation>
    </message>
    <message>
        <source>Words or codes of the chart for the area; may be empty.</source>
        <translation>Iskartets ord eller koder for området; kan være tomt.</translation>
    </message>
    <message>
        <source>Part of the area that ice covers, in tenths; without it, unknown.</source>
        <translation>Delen av området som is dekker, i tideler; uten den er den ukjent.</translation>
    </message>
    <message>
        <source>Whether the ice is fast to a shore and does not drift.</source>
        <translation>Om isen er fast til land og ikke driver.</translation>
    </message>
    <message>
        <source>Velocity of the wind at 10 m, towards true east and north.</source>
        <translation>Vindens hastighet i 10 m, mot sann øst og nord.</translation>
    </message>
    <message>
        <source>Speed of gusts.</source>
        <translation>Farten til vindkast.</translation>
    </message>
    <message>
        <source>Temperature of the air at 2 m.</source>
        <translation>Lufttemperaturen i 2 m.</translation>
    </message>
    <message>
        <source>Dew point of the air at 2 m.</source>
        <translation>Duggpunktet til luften i 2 m.</translation>
    </message>
    <message>
        <source>Part of the area with fog.</source>
        <translation>Delen av området med tåke.</translation>
    </message>
    <message>
        <source>Visibility.</source>
        <translation>Sikten.</translation>
    </message>
    <message>
        <source>Height of the cloud base above the sea.</source>
        <translation>Skybasens høyde over havet.</translation>
    </message>
    <message>
        <source>Velocity of the current, towards true east and north.</source>
        <translation>Strømmens hastighet, mot sann øst og nord.</translation>
    </message>
    <message>
        <source>Latitude of a place of the grid.</source>
        <translation>Breddegraden til et sted i rutenettet.</translation>
    </message>
    <message>
        <source>Longitude of a place of the grid.</source>
        <translation>Lengdegraden til et sted i rutenettet.</translation>
    </message>
    <message>
        <source>Depth of the sea at the place.</source>
        <translation>Havdybden på stedet.</translation>
    </message>
    <message>
        <source>Ice chart for the map, without effect on the flight.</source>
        <translation>Iskart til kartet, uten virkning på flygingen.</translation>
    </message>
    <message>
        <source>Areas of the chart, each with `outlines_m` (needed): outline and holes, each a list of corners.</source>
        <translation>Områdene på iskartet, hvert med `outlines_m` (må finnes): omriss og hull, hvert en liste over hjørner.</translation>
    </message>
    <message>
        <source>Forecast with `source`, `issued` (UTC), `columns` (1) and `places`; needs `start_utc`.</source>
        <translation>Varsel med `source`, `issued` (UTC), `columns` (1) og `places`; trenger `start_utc`.</translation>
    </message>
    <message>
        <source>Grid of rows from south to north, each from west to east, with `columns` places.</source>
        <translation>Rutenett av rader fra sør til nord, hver fra vest til øst, med `columns` steder.</translation>
    </message>
    <message>
        <source>Values at a `time` (UTC; times rise); any may be missing.</source>
        <translation>Verdier for en `time` (UTC; tidene stiger); alle kan mangle.</translation>
    </message>
</context>
<context>
    <name>berg::FigureView</name>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Verdier</translation>
    </message>
</context>
<context>
    <name>berg::FindBox</name>
    <message>
        <source>Favourite: listed when the box is opened</source>
        <translation>Favoritt: vises når feltet åpnes</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favoritt</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Funnet</translation>
    </message>
    <message>
        <source>Move the scenario here…</source>
        <translation>Flytt scenarioet hit …</translation>
    </message>
    <message>
        <source>New scenario here</source>
        <translation>Nytt scenario her</translation>
    </message>
    <message>
        <source>Where is the new scenario? A place or coordinate</source>
        <translation>Hvor er det nye scenarioet? Et sted eller en koordinat</translation>
    </message>
    <message>
        <source>Iceberg, UAV, place, coordinate or command</source>
        <translation>Isfjell, UAV, sted, koordinat eller kommando</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Fant ingenting</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>UAV</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Kommando</translation>
    </message>
    <message>
        <source>Coordinate</source>
        <translation>Koordinat</translation>
    </message>
    <message>
        <source>Sea or bay</source>
        <translation>Hav eller bukt</translation>
    </message>
    <message>
        <source>Island or coast</source>
        <translation>Øy eller kyst</translation>
    </message>
    <message>
        <source>Cape</source>
        <translation>Nes</translation>
    </message>
    <message>
        <source>Town or station</source>
        <translation>By eller stasjon</translation>
    </message>
    <message>
        <source>Oil or gas field</source>
        <translation>Olje- eller gassfelt</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Felt</translation>
    </message>
</context>
<context>
    <name>berg::FlightCard</name>
    <message>
        <source>Run complete</source>
        <translation>Flyging fullført</translation>
    </message>
    <message>
        <source>Result of the run</source>
        <translation>Resultat av flygingen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Lukk</translation>
    </message>
    <message>
        <source>Closes this card until the next run ends.</source>
        <translation>Lukker dette kortet til neste flyging er slutt.</translation>
    </message>
    <message>
        <source>Zeta ζ</source>
        <translation>Zeta ζ</translation>
    </message>
    <message>
        <source>vs prediction</source>
        <translation>Mot forutsigelsen</translation>
    </message>
    <message>
        <source>ζ compared with the prediction for the policy before take-off.</source>
        <translation>ζ sammenlignet med forutsigelsen for strategien før avgang.</translation>
    </message>
    <message>
        <source>Lower bound</source>
        <translation>Nedre grense</translation>
    </message>
    <message>
        <source>no useful bound</source>
        <translation>ingen nyttig grense</translation>
    </message>
    <message>
        <source>Lower bound on ζ for these conditions, whatever the policy.</source>
        <translation>Nedre grense for ζ under disse forholdene, uansett strategi.</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besøk</translation>
    </message>
    <message>
        <source>Targets reached.</source>
        <translation>Mål som er nådd.</translation>
    </message>
    <message>
        <source>Longest unseen</source>
        <translation>Lengst usett</translation>
    </message>
    <message>
        <source>The iceberg that was out of view longest.</source>
        <translation>Isfjellet som var lengst ute av syne.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Sammenlign</translation>
    </message>
    <message>
        <source>Compares the run with others.</source>
        <translation>Sammenligner flygingen med andre.</translation>
    </message>
    <message>
        <source>Save run</source>
        <translation>Lagre flyging</translation>
    </message>
    <message>
        <source>Saves the run to a file.</source>
        <translation>Lagrer flygingen i en fil.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Exports the log of the run: planned and flown, sightings, deviations.</source>
        <translation>Eksporterer flygeloggen: planlagt og fløyet, observasjoner, avvik.</translation>
    </message>
    <message>
        <source>Predicted range</source>
        <translation>Forutsagt område</translation>
    </message>
    <message>
        <source>Predicted range of ζ for 90 % of flights.</source>
        <translation>Forutsagt område for ζ i 90 % av flygingene.</translation>
    </message>
    <message>
        <source>below %1 to %2</source>
        <translation>under %1 til %2</translation>
    </message>
    <message>
        <source>above %1 to %2</source>
        <translation>over %1 til %2</translation>
    </message>
    <message>
        <source>inside %1 to %2</source>
        <translation>innenfor %1 til %2</translation>
    </message>
    <message>
        <source>changed in flight</source>
        <translation>endret under flyging</translation>
    </message>
    <message>
        <source>being computed, %1 %</source>
        <translation>beregnes, %1 %</translation>
    </message>
</context>
<context>
    <name>berg::FlightView</name>
    <message>
        <source>Planning</source>
        <translation>Planlegger</translation>
    </message>
    <message>
        <source>Ready. Press Space to fly</source>
        <translation>Klar. Trykk mellomrom for å fly</translation>
    </message>
    <message>
        <source>Flying</source>
        <translation>Flyr</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Run complete</source>
        <translation>Flyging fullført</translation>
    </message>
    <message>
        <source>Cannot be planned: %1</source>
        <translation>Kan ikke planlegges: %1</translation>
    </message>
    <message>
        <source>Press I and click on the map to place an iceberg, drag to set its drift, or import sightings.</source>
        <translation>Trykk I og klikk på kartet for å plassere et isfjell, dra for å sette driften, eller importer observasjoner.</translation>
    </message>
    <message>
        <source>The plan is still being made.</source>
        <translation>Planen lages fortsatt.</translation>
    </message>
    <message>
        <source>Flight to %1 discarded</source>
        <translation>Flyging til %1 forkastet</translation>
    </message>
</context>
<context>
    <name>berg::ForecastDialog</name>
    <message>
        <source>Forecast</source>
        <translation>Varsel</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Wind from</source>
        <translation>Vind fra</translation>
    </message>
    <message>
        <source>Gust</source>
        <translation>Vindkast</translation>
    </message>
    <message>
        <source>Air, °C</source>
        <translation>Luft, °C</translation>
    </message>
    <message>
        <source>Dew point, °C</source>
        <translation>Duggpunkt, °C</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Sikt</translation>
    </message>
    <message>
        <source>Cloud base</source>
        <translation>Skyhøyde</translation>
    </message>
    <message>
        <source>Current to</source>
        <translation>Strøm mot</translation>
    </message>
    <message>
        <source>Co&amp;mbine with the present forecast</source>
        <translation>Sett sa&amp;mmen med det nåværende varselet</translation>
    </message>
    <message>
        <source>&amp;Open file...</source>
        <translation>&amp;Åpne fil …</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Fjern</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>&amp;Sett</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Kilde: %1</translation>
    </message>
    <message>
        <source>Time of issue unknown</source>
        <translation>Utgivelsestid ukjent</translation>
    </message>
    <message>
        <source>Issued %1</source>
        <translation>Utgitt %1</translation>
    </message>
    <message>
        <source>Issued %1, %2 h before the start: get a newer forecast</source>
        <translation>Utgitt %1, %2 t før start: hent et nyere varsel</translation>
    </message>
    <message>
        <source>Issued %1, %2 h before the start</source>
        <translation>Utgitt %1, %2 t før start</translation>
    </message>
    <message numerus="yes">
        <source>%n places, the table is for the middle one</source>
        <translation>
            <numerusform>%n sted, som tabellen gjelder</numerusform>
            <numerusform>%n steder, tabellen gjelder det midterste</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n times, from %1 to %2</source>
        <translation>
            <numerusform>%n tidspunkt, fra %1 til %2</numerusform>
            <numerusform>%n tidspunkter, fra %1 til %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Thinned by a factor of %1 in each direction</source>
        <translation>Uttynnet med en faktor %1 i hver retning</translation>
    </message>
    <message>
        <source>The scenario has no forecast: wind and current are constant.</source>
        <translation>Scenarioet har ikke noe varsel: vind og strøm er konstante.</translation>
    </message>
    <message>
        <source>No values of one quantity between %1 and %2</source>
        <translation>Ingen verdier for én størrelse mellom %1 og %2</translation>
    </message>
</context>
<context>
    <name>berg::GenerateDialog</name>
    <message>
        <source>Generate icebergs</source>
        <translation>Generer isfjell</translation>
    </message>
    <message>
        <source>&amp;Number</source>
        <translation>A&amp;ntall</translation>
    </message>
    <message>
        <source>The scenario&apos;s area</source>
        <translation>Scenarioets område</translation>
    </message>
    <message>
        <source>Visible part of the map</source>
        <translation>Synlig del av kartet</translation>
    </message>
    <message>
        <source>Rectangle in the middle of the map</source>
        <translation>Rektangel midt i kartet</translation>
    </message>
    <message>
        <source>&amp;Where</source>
        <translation>&amp;Hvor</translation>
    </message>
    <message>
        <source>Width of the rectangle</source>
        <translation>Rektangelets bredde</translation>
    </message>
    <message>
        <source>Height of the rectangle</source>
        <translation>Rektangelets høyde</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>S&amp;tørrelse</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>&amp;Fart</translation>
    </message>
    <message>
        <source>to</source>
        <translation>til</translation>
    </message>
    <message>
        <source>In any direction</source>
        <translation>I alle retninger</translation>
    </message>
    <message>
        <source>Around one direction</source>
        <translation>Omkring én retning</translation>
    </message>
    <message>
        <source>D&amp;rift</source>
        <translation>&amp;Drift</translation>
    </message>
    <message>
        <source>D&amp;irection</source>
        <translation>&amp;Retning</translation>
    </message>
    <message>
        <source>&amp;Uncertainty σ</source>
        <translation>&amp;Usikkerhet σ</translation>
    </message>
    <message>
        <source>&amp;Growth q</source>
        <translation>&amp;Vekst q</translation>
    </message>
    <message>
        <source>&amp;Minimum spacing</source>
        <translation>&amp;Minste avstand</translation>
    </message>
    <message>
        <source>The same seed generates the same field again.</source>
        <translation>Det samme startfrøet gir det samme feltet igjen.</translation>
    </message>
    <message>
        <source>&amp;Another</source>
        <translation>&amp;Et annet</translation>
    </message>
    <message>
        <source>Generates another random field.</source>
        <translation>Lager et nytt tilfeldig felt.</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>&amp;Startfrø</translation>
    </message>
    <message>
        <source>R&amp;eplace existing icebergs</source>
        <translation>Erst&amp;att isfjellene som er der</translation>
    </message>
    <message>
        <source>Generate</source>
        <translation>Generer</translation>
    </message>
    <message numerus="yes">
        <source>The scenario will have %n icebergs.</source>
        <translation>
            <numerusform>Scenarioet får %n isfjell.</numerusform>
            <numerusform>Scenarioet får %n isfjell.</numerusform>
        </translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>Unknown, changing within 10 h</source>
        <translation>Ukjent, endrer seg i løpet av 10 t</translation>
    </message>
    <message>
        <source>As fitted to a beacon: 0.15 m/s along each axis, in any direction. Icebergs are then measured in flight.</source>
        <translation>Som tilpasset en bøye: 0,15 m/s langs hver akse, i alle retninger. Isfjell måles da under flyging.</translation>
    </message>
</context>
<context>
    <name>berg::IceRow</name>
    <message>
        <source>Report sighting</source>
        <translation>Meld observasjon</translation>
    </message>
    <message>
        <source>Ice tracked by radar or marked by AIS</source>
        <translation>Is fulgt av radar eller merket med AIS</translation>
    </message>
    <message>
        <source>In flight: the nearest iceberg that it may be counts as seen by others; without one, a new iceberg appears.</source>
        <translation>Under flyging: det nærmeste isfjellet som det kan være, regnes som sett av andre; finnes det ikke, dukker et nytt isfjell opp.</translation>
    </message>
</context>
<context>
    <name>berg::IcebergTable</name>
    <message>
        <source>Find by name or id</source>
        <translation>Finn etter navn eller id</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>A row for each iceberg. Before take-off Return edits a cell, Ctrl+Return sets it in all rows selected, Ctrl+C and Ctrl+V exchange rows with a spreadsheet. In flight Return shows the iceberg on the map.</source>
        <translation>En rad for hvert isfjell. Før avgang endrer Enter en celle, Ctrl+Enter setter den i alle valgte rader, og Ctrl+C og Ctrl+V utveksler rader med et regneark. Under flygingen viser Enter isfjellet på kartet.</translation>
    </message>
    <message>
        <source>No iceberg has this in its name or id.</source>
        <translation>Ingen isfjell har dette i navnet eller id-en.</translation>
    </message>
    <message>
        <source>There are no icebergs in this flight.</source>
        <translation>Det er ingen isfjell i denne flygingen.</translation>
    </message>
    <message>
        <source>No icebergs yet: press I and click on the map, or copy rows of a spreadsheet (name, east, north, speed, direction, σ₀ ...) and paste them here with Ctrl+V.</source>
        <translation>Ingen isfjell ennå: trykk I og klikk på kartet, eller kopier rader fra et regneark (navn, øst, nord, fart, retning, σ₀ ...) og lim dem inn her med Ctrl+V.</translation>
    </message>
    <message>
        <source>In flight the icebergs cannot be edited. Stop the flight to paste.</source>
        <translation>Isfjellene kan ikke redigeres under flyging. Stopp flygingen for å lime inn.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopier</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Lim inn</translation>
    </message>
    <message>
        <source>Copy &quot;%1&quot;</source>
        <translation>Kopier «%1»</translation>
    </message>
    <message>
        <source>Show on the map</source>
        <translation>Vis på kartet</translation>
    </message>
</context>
<context>
    <name>berg::IcebergTableModel</name>
    <message>
        <source>Paste icebergs</source>
        <translation>Lim inn isfjell</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; is computed from others. Nothing was pasted.</source>
        <translation>Kolonnen «%1» beregnes ut fra andre. Ingenting ble limt inn.</translation>
    </message>
</context>
<context>
    <name>berg::ImportColumnsView</name>
    <message>
        <source>This format has no columns to choose.</source>
        <translation>Dette formatet har ingen kolonner å velge.</translation>
    </message>
    <message>
        <source>First rows of the file</source>
        <translation>De første radene i filen</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisk</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>Automatisk: %1</translation>
    </message>
    <message>
        <source>Line of the file that names the columns, if a title precedes it.</source>
        <translation>Linjen i filen som navngir kolonnene, hvis det står en tittel over den.</translation>
    </message>
    <message>
        <source>&amp;Header line</source>
        <translation>Overskrifts&amp;linje</translation>
    </message>
    <message>
        <source>Columns as for the last file with this header.</source>
        <translation>Kolonner som for den forrige filen med denne overskriften.</translation>
    </message>
    <message>
        <source>&amp;Forget columns</source>
        <translation>&amp;Glem kolonner</translation>
    </message>
    <message>
        <source>Headers whose columns were chosen by hand in an earlier import.</source>
        <translation>Overskrifter der kolonnene ble valgt for hånd ved en tidligere import.</translation>
    </message>
    <message>
        <source>All of them</source>
        <translation>Alle</translation>
    </message>
</context>
<context>
    <name>berg::ImportDialog</name>
    <message>
        <source>No icebergs</source>
        <translation>Ingen isfjell</translation>
    </message>
    <message>
        <source>No sighting can be imported.</source>
        <translation>Ingen observasjon kan importeres.</translation>
    </message>
    <message>
        <source>Import sightings from %1</source>
        <translation>Importer observasjoner fra %1</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>Map of what comes out</source>
        <translation>Kart over resultatet</translation>
    </message>
    <message>
        <source>+ new   * updated</source>
        <translation>+ nytt   * oppdatert</translation>
    </message>
    <message>
        <source>Icebergs of the file</source>
        <translation>Isfjellene i filen</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Kolonner</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisk</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>Automatisk: %1</translation>
    </message>
    <message>
        <source>Icebergs (%1)</source>
        <translation>Isfjell (%1)</translation>
    </message>
    <message>
        <source>Reading %1, %2 ...</source>
        <translation>Leser %1, %2 …</translation>
    </message>
    <message>
        <source>Working ...</source>
        <translation>Arbeider …</translation>
    </message>
    <message>
        <source>Im&amp;port</source>
        <translation>Im&amp;porter</translation>
    </message>
    <message>
        <source>Icebergs (first %1 of %2)</source>
        <translation>Isfjell (de første %1 av %2)</translation>
    </message>
    <message>
        <source>Import into a &amp;new scenario</source>
        <translation>Importer til et &amp;nytt scenario</translation>
    </message>
    <message>
        <source>+ appears   * reported seen</source>
        <translation>+ dukker opp   * meldt sett</translation>
    </message>
    <message>
        <source>Re&amp;port</source>
        <translation>&amp;Meld</translation>
    </message>
    <message>
        <source>Report all t&amp;he same</source>
        <translation>Meld &amp;likevel</translation>
    </message>
    <message>
        <source>Import all t&amp;he same</source>
        <translation>Importer &amp;likevel</translation>
    </message>
    <message>
        <source>Choose below which rows belong to the same iceberg.</source>
        <translation>Velg nedenfor hvilke rader som hører til samme isfjell.</translation>
    </message>
    <message>
        <source>Faster than 1.5 m/s or on land: %1. Check columns, units and ids.</source>
        <translation>Raskere enn 1,5 m/s eller på land: %1. Kontroller kolonner, enheter og id-er.</translation>
    </message>
    <message>
        <source>Velocities are uncertain, so the scenario will use the Kalman filter.</source>
        <translation>Hastighetene er usikre, så scenarioet vil bruke Kalman-filteret.</translation>
    </message>
</context>
<context>
    <name>berg::ImportIdentityView</name>
    <message>
        <source>Rows with the same “%1”</source>
        <translation>Rader med samme «%1»</translation>
    </message>
    <message>
        <source>All rows are one iceberg</source>
        <translation>Alle rader er ett isfjell</translation>
    </message>
    <message>
        <source>Each row is a separate iceberg</source>
        <translation>Hver rad er sitt eget isfjell</translation>
    </message>
    <message>
        <source>up to %1 m/s between sightings</source>
        <translation>opptil %1 m/s mellom observasjoner</translation>
    </message>
    <message>
        <source>The file does not say which rows belong to the same iceberg. Choose:</source>
        <translation>Filen sier ikke hvilke rader som hører til samme isfjell. Velg:</translation>
    </message>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n isfjell</numerusform>
            <numerusform>%n isfjell</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::ImportOptionsView</name>
    <message>
        <source>S&amp;tart at</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>Not &amp;before</source>
        <translation>Ikke f&amp;ør</translation>
    </message>
    <message>
        <source>Earlier sightings are left out.</source>
        <translation>Tidligere observasjoner utelates.</translation>
    </message>
    <message>
        <source>Not &amp;after</source>
        <translation>Ikke &amp;etter</translation>
    </message>
    <message>
        <source>Later sightings are left out.</source>
        <translation>Senere observasjoner utelates.</translation>
    </message>
    <message>
        <source>&amp;Growth q</source>
        <translation>&amp;Vekst q</translation>
    </message>
    <message>
        <source>Growth of the uncertainty if there are too few sightings to estimate it.</source>
        <translation>Veksten i usikkerheten hvis det er for få observasjoner til å anslå den.</translation>
    </message>
    <message>
        <source>This scenario</source>
        <translation>Dette scenarioet</translation>
    </message>
    <message>
        <source>A new scenario</source>
        <translation>Et nytt scenario</translation>
    </message>
    <message>
        <source>Icebergs already in this scenario are updated by their ids.</source>
        <translation>Isfjell som alt er i dette scenarioet, oppdateres etter id-ene.</translation>
    </message>
    <message>
        <source>&amp;Into</source>
        <translation>&amp;Til</translation>
    </message>
    <message>
        <source>Insi&amp;de</source>
        <translation>Inne&amp;nfor</translation>
    </message>
    <message>
        <source>Sightings outside these latitudes and longitudes are left out.</source>
        <translation>Observasjoner utenfor disse bredde- og lengdegradene utelates.</translation>
    </message>
    <message>
        <source>Visible part of the &amp;map</source>
        <translation>Synlig del av &amp;kartet</translation>
    </message>
    <message>
        <source>South</source>
        <translation>Sør</translation>
    </message>
    <message>
        <source>West</source>
        <translation>Vest</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Øst</translation>
    </message>
    <message>
        <source>With &amp;recorded tracks</source>
        <translation>Med &amp;registrerte spor</translation>
    </message>
    <message>
        <source>Sightings after the start become the true motion of an iceberg. Requires a start time.</source>
        <translation>Observasjoner etter starten blir den sanne bevegelsen til et isfjell. Krever en starttid.</translation>
    </message>
    <message>
        <source>Position &amp;error</source>
        <translation>Posis&amp;jonsfeil</translation>
    </message>
    <message>
        <source>Drift &amp;variation</source>
        <translation>Variasjon i &amp;drift</translation>
    </message>
    <message>
        <source>Standard deviation of an unknown drift along each axis. With 0 the drift counts as known and constant.</source>
        <translation>Standardavvik for en ukjent drift langs hver akse. Med 0 regnes driften som kjent og konstant.</translation>
    </message>
    <message>
        <source>Drift &amp;changes in</source>
        <translation>Driften endrer se&amp;g på</translation>
    </message>
    <message>
        <source>Time after which a known drift is no longer valid. 0 means never.</source>
        <translation>Tiden til en kjent drift ikke lenger gjelder. 0 betyr aldri.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisk</translation>
    </message>
    <message>
        <source>Month first: 12/31/2021</source>
        <translation>Måneden først: 12/31/2021</translation>
    </message>
    <message>
        <source>Day first: 31/12/2021</source>
        <translation>Dagen først: 31/12/2021</translation>
    </message>
    <message>
        <source>How to read dates such as 05/02/2021.</source>
        <translation>Hvordan datoer som 05/02/2021 skal leses.</translation>
    </message>
    <message>
        <source>Dat&amp;es</source>
        <translation>Dato&amp;er</translation>
    </message>
    <message>
        <source>UTC time that becomes the start of the scenario. Otherwise its start stays, or moves to the last sighting if that is later.</source>
        <translation>UTC-tid som blir starten på scenarioet. Ellers blir starten stående, eller den flyttes til den siste observasjonen hvis den er senere.</translation>
    </message>
    <message>
        <source>Standard deviation of a position along each axis if the file states none and no column names the source.</source>
        <translation>Standardavvik for en posisjon langs hver akse hvis filen ikke oppgir noe og ingen kolonne navngir kilden.</translation>
    </message>
    <message>
        <source>As stated in the file</source>
        <translation>Som filen sier</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Som skrevet</translation>
    </message>
    <message>
        <source>Sensor that found the positions. Rows whose column “source”, “method” or “sensor” names another source use its error.</source>
        <translation>Sensoren som fant posisjonene. Rader der kolonnen «source», «method» eller «sensor» navngir en annen kilde, bruker feilen for den.</translation>
    </message>
    <message>
        <source>Seen b&amp;y</source>
        <translation>K&amp;ilde</translation>
    </message>
</context>
<context>
    <name>berg::ImportRowsView</name>
    <message>
        <source>Rejected rows</source>
        <translation>Avviste rader</translation>
    </message>
    <message>
        <source>Rejected rows (%1)</source>
        <translation>Avviste rader (%1)</translation>
    </message>
    <message>
        <source>Rejected rows (first %1 of %2)</source>
        <translation>Avviste rader (de første %1 av %2)</translation>
    </message>
    <message>
        <source>Changed rows</source>
        <translation>Endrede rader</translation>
    </message>
    <message>
        <source>Changed rows (%1)</source>
        <translation>Endrede rader (%1)</translation>
    </message>
    <message>
        <source>Changed rows (first %1 of %2)</source>
        <translation>Endrede rader (de første %1 av %2)</translation>
    </message>
    <message>
        <source>Outside area or time</source>
        <translation>Utenfor område eller tid</translation>
    </message>
    <message>
        <source>Outside area or time (%1)</source>
        <translation>Utenfor område eller tid (%1)</translation>
    </message>
    <message>
        <source>Outside area or time (first %1 of %2)</source>
        <translation>Utenfor område eller tid (de første %1 av %2)</translation>
    </message>
</context>
<context>
    <name>berg::InspectorForm</name>
    <message>
        <source>mixed</source>
        <translation>ulike</translation>
    </message>
</context>
<context>
    <name>berg::InspectorPanel</name>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Scenarioet</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isfjell</translation>
    </message>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n isfjell</numerusform>
            <numerusform>%n isfjell</numerusform>
        </translation>
    </message>
    <message>
        <source>Only the selected icebergs are edited here.</source>
        <translation>Bare de valgte isfjellene redigeres her.</translation>
    </message>
    <message>
        <source>Edits apply to all of them.</source>
        <translation>Endringer gjelder alle.</translation>
    </message>
    <message>
        <source>UAV %1</source>
        <translation>UAV-en %1</translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>%n UAV</numerusform>
            <numerusform>%n UAV-er</numerusform>
        </translation>
    </message>
    <message>
        <source>Change id</source>
        <translation>Endre id</translation>
    </message>
    <message>
        <source>Select an object on the map to edit it.</source>
        <translation>Velg et objekt på kartet for å redigere det.</translation>
    </message>
    <message>
        <source>Asset</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Område</translation>
    </message>
    <message>
        <source>Drag its corners on the map to change it.</source>
        <translation>Dra hjørnene på kartet for å endre det.</translation>
    </message>
    <message>
        <source>Identifies the iceberg in files and lists; must be unique.</source>
        <translation>Identifiserer isfjellet i filer og lister; må være unik.</translation>
    </message>
    <message>
        <source>Identifies the UAV in files and lists; must be unique.</source>
        <translation>Identifiserer UAV-en i filer og lister; må være unik.</translation>
    </message>
    <message>
        <source>No-fly area</source>
        <translation>Flyforbudsområde</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>UAV</translation>
    </message>
</context>
<context>
    <name>berg::LayersPanel</name>
    <message>
        <source>Names</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Drift arrows</source>
        <translation>Driftpiler</translation>
    </message>
    <message>
        <source>Uncertainty rings</source>
        <translation>Usikkerhetsringer</translation>
    </message>
    <message>
        <source>Graticule</source>
        <translation>Gradnett</translation>
    </message>
    <message>
        <source>Former plan</source>
        <translation>Forrige plan</translation>
    </message>
    <message>
        <source>Swept area</source>
        <translation>Avsøkt område</translation>
    </message>
    <message>
        <source>%1: opacity in per cent</source>
        <translation>%1: dekning i prosent</translation>
    </message>
    <message>
        <source>Opacity; at the left end the layer is hidden</source>
        <translation>Dekkevne; helt til venstre er laget skjult</translation>
    </message>
    <message>
        <source>Time covered by drift arrows; arrows too long for the map are shortened and dashed</source>
        <translation>Tiden som driftpilene dekker; piler som er for lange for kartet, er forkortet og stiplet</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisk</translation>
    </message>
    <message>
        <source>Drift horizon</source>
        <translation>Drifthorisont</translation>
    </message>
    <message>
        <source>Airspace and operation volume</source>
        <translation>Luftrom og operasjonsvolum</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Bakgrunn</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Removes the background</source>
        <translation>Fjerner bakgrunnen</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Velg en fil …</translation>
    </message>
    <message>
        <source>Your own map below all layers, such as an ice chart: GeoJSON, KML, KMZ or CZML</source>
        <translation>Ditt eget kart under alle lag, for eksempel et iskart: GeoJSON, KML, KMZ eller CZML</translation>
    </message>
    <message>
        <source>Background file: %1</source>
        <translation>Bakgrunnsfil: %1</translation>
    </message>
    <message>
        <source>Compared run</source>
        <translation>Sammenlignet flyging</translation>
    </message>
    <message>
        <source>Place names</source>
        <translation>Stedsnavn</translation>
    </message>
    <message>
        <source>Ice chart</source>
        <translation>Iskart</translation>
    </message>
    <message>
        <source>Forecast wind</source>
        <translation>Varslet vind</translation>
    </message>
    <message>
        <source>Forecast current</source>
        <translation>Varslet strøm</translation>
    </message>
    <message>
        <source>Predicted drift</source>
        <translation>Forventet drift</translation>
    </message>
    <message>
        <source>Time between two marks of the predicted drift, up to 48 h</source>
        <translation>Tid mellom to merker for den forventede driften, opptil 48 t</translation>
    </message>
    <message>
        <source>every %1</source>
        <translation>hver %1</translation>
    </message>
    <message>
        <source>Marks of the drift</source>
        <translation>Merker for driften</translation>
    </message>
</context>
<context>
    <name>berg::LogRows</name>
    <message>
        <source>Write a log</source>
        <translation>Skriv en logg</translation>
    </message>
    <message>
        <source>Open a log…</source>
        <translation>Åpne en logg…</translation>
    </message>
    <message>
        <source>Plays a recorded flight (.tlog) in place of a link.</source>
        <translation>Spiller av en innspilt flyging (.tlog) i stedet for en forbindelse.</translation>
    </message>
    <message>
        <source>Part of the log that has been played</source>
        <translation>Del av loggen som er spilt av</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>Avspillingens hastighet</translation>
    </message>
    <message>
        <source>Seconds of the log that are played in each second</source>
        <translation>Sekunder av loggen som spilles av i hvert sekund</translation>
    </message>
    <message>
        <source>Writes every frame sent and received to a new file (.tlog) in the folder %1.</source>
        <translation>Skriver hver ramme som sendes og mottas, til en ny fil (.tlog) i mappen %1.</translation>
    </message>
    <message>
        <source>Log %1 has been played: %2</source>
        <translation>Loggen %1 er spilt av: %2</translation>
    </message>
    <message>
        <source>Playing log %1: %2</source>
        <translation>Spiller av loggen %1: %2</translation>
    </message>
    <message>
        <source>Damaged parts were skipped (%1).</source>
        <translation>Skadde deler ble hoppet over (%1).</translation>
    </message>
    <message>
        <source>The log cannot be written: %1 (%2)</source>
        <translation>Loggen kan ikke skrives: %1 (%2)</translation>
    </message>
    <message>
        <source>The log has reached its largest size and has ended: %1</source>
        <translation>Loggen har nådd sin største størrelse og er avsluttet: %1</translation>
    </message>
    <message>
        <source>Log: %1 (%2)</source>
        <translation>Logg: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>berg::MainWindow</name>
    <message>
        <source>Untitled</source>
        <translation>Uten navn</translation>
    </message>
</context>
<context>
    <name>berg::ManualWindow</name>
    <message>
        <source>Bergwatch manual</source>
        <translation>Håndbok for Bergwatch</translation>
    </message>
    <message>
        <source>Contents of the manual</source>
        <translation>Innholdet i håndboken</translation>
    </message>
    <message>
        <source>Text of the manual</source>
        <translation>Håndbokens tekst</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Tilbake</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Frem</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>Større tekst</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>Mindre tekst</translation>
    </message>
    <message>
        <source>Search the manual (Ctrl+F)</source>
        <translation>Søk i håndboken (Ctrl+F)</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Søk i håndboken</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Forrige</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Neste</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>Ikke funnet</translation>
    </message>
    <message>
        <source>Lines found: %1</source>
        <translation>Linjer funnet: %1</translation>
    </message>
</context>
<context>
    <name>berg::MapController</name>
    <message numerus="yes">
        <source>%n icebergs removed from this run. Undo brings them back.</source>
        <translation>
            <numerusform>%n isfjell fjernet fra denne flygingen. Angre henter det tilbake.</numerusform>
            <numerusform>%n isfjell fjernet fra denne flygingen. Angre henter dem tilbake.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::MapView</name>
    <message>
        <source>Map</source>
        <translation>Kart</translation>
    </message>
    <message numerus="yes">
        <source>%n icebergs and the UAVs on the sea. Arrow keys move the map or the selection, plus and minus zoom, F fits. The iceberg table lists the icebergs.</source>
        <translation>
            <numerusform>%n isfjell og UAV-ene på sjøen. Piltastene flytter kartet eller utvalget, pluss og minus zoomer, F viser alt. Isfjelltabellen lister opp isfjellene.</numerusform>
            <numerusform>%n isfjell og UAV-ene på sjøen. Piltastene flytter kartet eller utvalget, pluss og minus zoomer, F viser alt. Isfjelltabellen lister opp isfjellene.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fil</translation>
    </message>
    <message>
        <source>&amp;New scenario</source>
        <translation>&amp;Nytt scenario</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Åpne …</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>S&amp;tartside</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Åpne n&amp;ylige</translation>
    </message>
    <message>
        <source>&amp;Import sightings...</source>
        <translation>I&amp;mporter observasjoner …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Lagre</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Lagre &amp;som …</translation>
    </message>
    <message>
        <source>Keep a &amp;backup copy</source>
        <translation>Behold en sikkerhets&amp;kopi</translation>
    </message>
    <message>
        <source>Before the first overwrite of a file, a copy is kept as NAME.berg~</source>
        <translation>Før en fil overskrives første gang, lagres en kopi som NAVN.berg~</translation>
    </message>
    <message>
        <source>Reco&amp;ver unsaved work...</source>
        <translation>&amp;Gjenopprett ulagret arbeid …</translation>
    </message>
    <message>
        <source>There is no unsaved work to recover</source>
        <translation>Det er ikke noe ulagret arbeid å gjenopprette</translation>
    </message>
    <message>
        <source>Save r&amp;un...</source>
        <translation>Lagre flyg&amp;ing …</translation>
    </message>
    <message>
        <source>&amp;Export plan...</source>
        <translation>&amp;Eksporter plan …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Avslutt</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Rediger</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Klipp &amp;ut</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopier</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Lim inn</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>&amp;Dupliser</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Slett</translation>
    </message>
    <message>
        <source>Add UA&amp;V</source>
        <translation>Legg &amp;til UAV</translation>
    </message>
    <message>
        <source>&amp;Generate icebergs...</source>
        <translation>Generer &amp;isfjell …</translation>
    </message>
    <message>
        <source>Select &amp;all icebergs</source>
        <translation>&amp;Velg alle isfjell</translation>
    </message>
    <message>
        <source>&amp;Move the scenario…</source>
        <translation>&amp;Flytt scenarioet…</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vis</translation>
    </message>
    <message>
        <source>Chec&amp;ks</source>
        <translation>Kont&amp;roll</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Paneler</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Til&amp;bakestill oppsettet</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Fulls&amp;kjerm</translation>
    </message>
    <message>
        <source>&amp;Fit everything</source>
        <translation>&amp;Tilpass alt</translation>
    </message>
    <message>
        <source>Follo&amp;w the UAV</source>
        <translation>&amp;Følg UAV-en</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Zoom &amp;inn</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zoom &amp;ut</translation>
    </message>
    <message>
        <source>O&amp;verview</source>
        <translation>&amp;Oversiktskart</translation>
    </message>
    <message>
        <source>Swept ar&amp;ea</source>
        <translation>Avsøkt områd&amp;e</translation>
    </message>
    <message>
        <source>S&amp;how true positions</source>
        <translation>&amp;Vis sanne posisjoner</translation>
    </message>
    <message>
        <source>Shows the true positions of the icebergs beside the estimates. When off, the map shows only what an operator would see.</source>
        <translation>Viser de sanne posisjonene til isfjellene ved siden av estimatene. Når dette er av, viser kartet bare det en operatør ville se.</translation>
    </message>
    <message>
        <source>F&amp;light</source>
        <translation>F&amp;lyging</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>Fly av sted</translation>
    </message>
    <message>
        <source>&amp;Step one second</source>
        <translation>&amp;Steg på ett sekund</translation>
    </message>
    <message>
        <source>Stop and &amp;edit</source>
        <translation>Sto&amp;pp og rediger</translation>
    </message>
    <message>
        <source>Restore disc&amp;arded flight</source>
        <translation>&amp;Hent flygingen tilbake</translation>
    </message>
    <message>
        <source>Prefer s&amp;horter route</source>
        <translation>Foretrekk &amp;kortere rute</translation>
    </message>
    <message>
        <source>Prefer more un&amp;certain first</source>
        <translation>Foretrekk flere &amp;usikre først</translation>
    </message>
    <message>
        <source>Report as seen no&amp;w</source>
        <translation>&amp;Meld som sett nå</translation>
    </message>
    <message>
        <source>Win&amp;d...</source>
        <translation>&amp;Vind...</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>&amp;Raskere</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>S&amp;aktere</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Ta pause</translation>
    </message>
    <message>
        <source>Step &amp;back one second</source>
        <translation>Steg til&amp;bake ett sekund</translation>
    </message>
    <message>
        <source>Step one &amp;tick</source>
        <translation>Ett ti&amp;dssteg frem</translation>
    </message>
    <message>
        <source>Step back one t&amp;ick</source>
        <translation>Ett t&amp;idssteg tilbake</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>&amp;Neste hendelse</translation>
    </message>
    <message>
        <source>&amp;Previous event</source>
        <translation>F&amp;orrige hendelse</translation>
    </message>
    <message>
        <source>&amp;Go to time</source>
        <translation>&amp;Gå til tid</translation>
    </message>
    <message>
        <source>Bac&amp;k to latest</source>
        <translation>Tilbake til n&amp;yeste</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hjelp</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>Om&amp;visning</translation>
    </message>
    <message>
        <source>&amp;About Bergwatch</source>
        <translation>&amp;Om Bergwatch</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Verktøy</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Velg</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>UAV</translation>
    </message>
    <message>
        <source>Asset</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Område</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mål</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Panorer</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>Verk&amp;tøy</translation>
    </message>
    <message>
        <source>Zoom at the cursor</source>
        <translation>Zoom ved pekeren</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>hjulet</translation>
    </message>
    <message>
        <source>middle button, or arrow keys</source>
        <translation>midterste knapp eller piltastene</translation>
    </message>
    <message>
        <source>Nudge what is selected</source>
        <translation>Skyv det som er valgt</translation>
    </message>
    <message>
        <source>arrow keys</source>
        <translation>piltastene</translation>
    </message>
    <message>
        <source>Finish drawing, undo last point</source>
        <translation>Avslutt tegningen, angre siste punkt</translation>
    </message>
    <message>
        <source>Enter, Backspace</source>
        <translation>Enter, Slett bakover</translation>
    </message>
    <message>
        <source>Steps of 15° while an arrow is drawn</source>
        <translation>Trinn på 15° mens en pil tegnes</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Skift</translation>
    </message>
    <message>
        <source>Cancel drawing, leave tool, clear selection</source>
        <translation>Avbryt tegningen, forlat verktøyet, tøm utvalget</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Hurtigtaster</translation>
    </message>
    <message>
        <source>About Bergwatch</source>
        <translation>Om Bergwatch</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Bergwatch %1&lt;/h3&gt;&lt;p&gt;Plans and simulates UAV missions that monitor drifting icebergs.&lt;/p&gt;&lt;p&gt;Own code: MIT licence. Qt Charts: GPL 3. COIN-OR CBC: EPL. Land made with Natural Earth.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Bergwatch %1&lt;/h3&gt;&lt;p&gt;Planlegger og simulerer UAV-oppdrag som overvåker drivende isfjell.&lt;/p&gt;&lt;p&gt;Egen kode: MIT-lisens. Qt Charts: GPL 3. COIN-OR CBC: EPL. Landområdene er laget med Natural Earth.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No-fly area</source>
        <translation>Flyforbudsområde</translation>
    </message>
    <message>
        <source>&amp;Return home now</source>
        <translation>Fly h&amp;jem nå</translation>
    </message>
    <message>
        <source>Hold here</source>
        <translation>Hold her</translation>
    </message>
    <message>
        <source>Res&amp;ume</source>
        <translation>Fortsett</translation>
    </message>
    <message>
        <source>Panels on the map</source>
        <translation>Paneler på kartet</translation>
    </message>
    <message>
        <source>&amp;Title and figures</source>
        <translation>&amp;Tittel og tall</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>T&amp;egnforklaring</translation>
    </message>
    <message>
        <source>&amp;Scale bar</source>
        <translation>&amp;Målestokk</translation>
    </message>
    <message>
        <source>&amp;North arrow</source>
        <translation>&amp;Nordpil</translation>
    </message>
    <message>
        <source>&amp;Wind</source>
        <translation>&amp;Vind</translation>
    </message>
    <message>
        <source>Flight brie&amp;f...</source>
        <translation>&amp;Flygeark …</translation>
    </message>
    <message>
        <source>Copy p&amp;icture of the map</source>
        <translation>Kopier &amp;bilde av kartet</translation>
    </message>
    <message>
        <source>La&amp;youts</source>
        <translation>&amp;Arrangement</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Planlegg</translation>
    </message>
    <message>
        <source>&amp;Fly</source>
        <translation>F&amp;lyg</translation>
    </message>
    <message>
        <source>&amp;Analyse</source>
        <translation>&amp;Analyser</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>Hånd&amp;bok</translation>
    </message>
    <message>
        <source>Find or &amp;go to…</source>
        <translation>Finn eller &amp;gå til …</translation>
    </message>
    <message>
        <source>Import airspa&amp;ce...</source>
        <translation>Importer luft&amp;rom …</translation>
    </message>
    <message>
        <source>Flight &amp;log...</source>
        <translation>Flygel&amp;ogg …</translation>
    </message>
    <message>
        <source>&amp;Background map…</source>
        <translation>Eget kart so&amp;m bakgrunn …</translation>
    </message>
    <message>
        <source>Values of a chart as a table</source>
        <translation>Verdiene i et diagram som tabell</translation>
    </message>
    <message>
        <source>Keyboard &amp;shortcuts</source>
        <translation>Tastatur&amp;snarveier</translation>
    </message>
    <message>
        <source>S&amp;tudy</source>
        <translation>Stu&amp;die</translation>
    </message>
    <message>
        <source>&amp;Solve time</source>
        <translation>&amp;Løsningstid</translation>
    </message>
    <message>
        <source>Colour scale of σ</source>
        <translation>Fargeskala for σ</translation>
    </message>
    <message>
        <source>Place names</source>
        <translation>Stedsnavn</translation>
    </message>
    <message>
        <source>S&amp;ound alarms</source>
        <translation>&amp;Lyd ved alarmer</translation>
    </message>
    <message>
        <source>A sound at each new alarm, until it is acknowledged</source>
        <translation>En lyd ved hver ny alarm, til den er bekreftet</translation>
    </message>
    <message>
        <source>&amp;New icebergs seen by</source>
        <translation>&amp;Nye isfjell sett med</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Angre</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gjør om</translation>
    </message>
    <message>
        <source>I&amp;mport forecast...</source>
        <translation>Importer &amp;varsel …</translation>
    </message>
    <message>
        <source>Import ice c&amp;hart...</source>
        <translation>Im&amp;porter iskart …</translation>
    </message>
    <message>
        <source>Ice chart</source>
        <translation>Iskart</translation>
    </message>
    <message>
        <source>Forecast wind</source>
        <translation>Varslet vind</translation>
    </message>
    <message>
        <source>Forecast current</source>
        <translation>Varslet strøm</translation>
    </message>
    <message>
        <source>Start times</source>
        <translation>Starttider</translation>
    </message>
    <message>
        <source>Predicted drift</source>
        <translation>Forventet drift</translation>
    </message>
</context>
<context>
    <name>berg::MessageList</name>
    <message>
        <source>Messages</source>
        <translation>Meldinger</translation>
    </message>
</context>
<context>
    <name>berg::MissionRunner</name>
    <message>
        <source>The scenario has changed meanwhile. Nothing was exported.</source>
        <translation>Scenarioet er endret i mellomtiden. Ingenting ble eksportert.</translation>
    </message>
    <message>
        <source>The run has ended. Stop and edit to fly it differently.</source>
        <translation>Flygingen er slutt. Stopp og rediger for å fly den annerledes.</translation>
    </message>
</context>
<context>
    <name>berg::MissionWorker</name>
    <message>
        <source>There is no run to save: the scenario cannot be planned.</source>
        <translation>Det er ingen flyging å lagre: scenarioet kan ikke planlegges.</translation>
    </message>
    <message>
        <source>The replay of this run differs from the recording: %1</source>
        <translation>Avspillingen av denne flygingen avviker fra opptaket: %1</translation>
    </message>
    <message>
        <source>There is no plan to upload.</source>
        <translation>Det er ingen plan å laste opp.</translation>
    </message>
    <message>
        <source>This scenario cannot be flown. Fix the reported errors first.</source>
        <translation>Dette scenarioet kan ikke flys. Rett de meldte feilene først.</translation>
    </message>
    <message>
        <source>The flight follows real aircraft at their pace: it cannot be stepped.</source>
        <translation>Flygingen følger virkelige luftfartøyer i deres tempo: den kan ikke kjøres trinnvis.</translation>
    </message>
</context>
<context>
    <name>berg::NumberField</name>
    <message>
        <source>mixed</source>
        <translation>ulike</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read. Type it like %2.</source>
        <translation>«%1» kan ikke leses. Skriv det som %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is above the highest value. %2 was set.</source>
        <translation>«%1» er over den høyeste verdien. %2 ble satt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is below the lowest value. %2 was set.</source>
        <translation>«%1» er under den laveste verdien. %2 ble satt.</translation>
    </message>
</context>
<context>
    <name>berg::OriginDialog</name>
    <message>
        <source>Move the scenario</source>
        <translation>Flytt scenarioet</translation>
    </message>
    <message>
        <source>&amp;Origin at</source>
        <translation>&amp;Origo i</translation>
    </message>
    <message>
        <source>Move &amp;everything along with the origin</source>
        <translation>Flytt &amp;alt sammen med origo</translation>
    </message>
    <message>
        <source>&amp;Leave everything at its place on the Earth</source>
        <translation>&amp;La alt ligge der det er på jorden</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Flytt</translation>
    </message>
    <message>
        <source>Not everything can stay at its place: a scenario reaches %1 from its origin. Move everything along, or choose a nearer place.</source>
        <translation>Ikke alt kan ligge der det er: et scenario rekker %1 fra origo. Flytt alt med, eller velg et nærmere sted.</translation>
    </message>
    <message>
        <source>The origin moves to %1, %2 away. Positions, courses and drift on the Earth stay the same.</source>
        <translation>Origo flyttes til %1, %2 unna. Posisjoner, kurser og drift på jorden forblir de samme.</translation>
    </message>
    <message>
        <source>Everything moves to %1, %2 away, and keeps its position relative to the origin.</source>
        <translation>Alt flyttes til %1, %2 unna, og beholder posisjonen i forhold til origo.</translation>
    </message>
    <message>
        <source>The origin is here now.</source>
        <translation>Origo er her nå.</translation>
    </message>
</context>
<context>
    <name>berg::OverviewInset</name>
    <message>
        <source>Overview</source>
        <translation>Oversiktskart</translation>
    </message>
    <message>
        <source>Polar chart showing the location of the map. Click a place to move the map there.</source>
        <translation>Polarkart som viser hvor kartet er. Klikk på et sted for å flytte kartet dit.</translation>
    </message>
</context>
<context>
    <name>berg::ParetoChart</name>
    <message>
        <source>Distance against uncertainty reward</source>
        <translation>Avstand mot usikkerhetsgevinst</translation>
    </message>
    <message>
        <source>No icebergs to plan for</source>
        <translation>Ingen isfjell å planlegge for</translation>
    </message>
    <message>
        <source>Computing the plans for every τ</source>
        <translation>Beregner planene for alle τ</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>Uncertainty reward, m²</source>
        <translation>Usikkerhetsgevinst, m²</translation>
    </message>
    <message>
        <source>Reward, m²</source>
        <translation>Gevinst, m²</translation>
    </message>
    <message>
        <source>Most uncertain first</source>
        <translation>Mest usikre først</translation>
    </message>
    <message>
        <source>Shortest path</source>
        <translation>Korteste vei</translation>
    </message>
    <message>
        <source>Whole order, %1</source>
        <translation>Hele rekkefølgen, %1</translation>
    </message>
</context>
<context>
    <name>berg::PlaceField</name>
    <message>
        <source>Coordinate or name of a place</source>
        <translation>Koordinat eller navn på et sted</translation>
    </message>
</context>
<context>
    <name>berg::PlanModel</name>
    <message>
        <source>%1 (id %2)</source>
        <translation>%1 (id-en er %2)</translation>
    </message>
    <message>
        <source>Place in the visiting order</source>
        <translation>Plass i besøksrekkefølgen</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>Name of the iceberg</source>
        <translation>Isfjellets navn</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Etappe</translation>
    </message>
    <message>
        <source>Distance from the previous iceberg, or from the UAV</source>
        <translation>Avstand fra forrige isfjell, eller fra UAV-en</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Ankomst</translation>
    </message>
    <message>
        <source>Uncertainty of the position now</source>
        <translation>Usikkerheten i posisjonen nå</translation>
    </message>
    <message>
        <source>later</source>
        <translation>senere</translation>
    </message>
    <message>
        <source>The plan ends before this iceberg is seen.</source>
        <translation>Planen slutter før dette isfjellet blir sett.</translation>
    </message>
    <message numerus="yes">
        <source>%n visits</source>
        <translation>
            <numerusform>%n besøk</numerusform>
            <numerusform>%n besøk</numerusform>
        </translation>
    </message>
    <message>
        <source>It has no iceberg to visit.</source>
        <translation>Den har ikke noe isfjell å besøke.</translation>
    </message>
    <message>
        <source>%1, flown %2</source>
        <comment>length and end of a way</comment>
        <translation>%1, fløyet %2</translation>
    </message>
    <message>
        <source>Assigned to %1</source>
        <translation>Tildelt %1</translation>
    </message>
    <message>
        <source>In view</source>
        <translation>I syne</translation>
    </message>
    <message>
        <source>Probability that the iceberg is in view when the UAV reaches its estimate</source>
        <translation>Sannsynligheten for at isfjellet er i syne når UAV-en når estimatet</translation>
    </message>
    <message>
        <source>%1 (search)</source>
        <translation>%1 (søk)</translation>
    </message>
    <message>
        <source>Lost: searched for %1</source>
        <comment>times and chances of finding it</comment>
        <translation>Tapt: letes etter %1</translation>
    </message>
    <message>
        <source>Returning home</source>
        <translation>På vei hjem</translation>
    </message>
    <message>
        <source>σ now</source>
        <translation>σ nå</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>På bakken</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Holder</translation>
    </message>
    <message>
        <source>Uncertainty of the position on arrival</source>
        <translation>Usikkerheten i posisjonen ved ankomst</translation>
    </message>
    <message>
        <source>%1, flown by %2</source>
        <comment>length and end of a path, UTC</comment>
        <translation>%1, fløyet innen %2</translation>
    </message>
    <message>
        <source>Course over ground %1, ground speed %2</source>
        <translation>Kurs over grunnen %1, fart over grunnen %2</translation>
    </message>
    <message>
        <source>Now %1; at arrival %2, if the iceberg is not seen before</source>
        <translation>Nå %1; ved ankomst %2, hvis isfjellet ikke er sett før</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Course over ground at the start of the leg</source>
        <translation>Kurs over grunnen i begynnelsen av etappen</translation>
    </message>
    <message>
        <source>Speed</source>
        <comment>over ground</comment>
        <translation>Fart</translation>
    </message>
    <message>
        <source>Ground speed in the present wind</source>
        <translation>Fart over grunnen i den nåværende vinden</translation>
    </message>
    <message>
        <source>Arrival of the UAV</source>
        <translation>UAV-ens ankomst</translation>
    </message>
    <message>
        <source>95 % now</source>
        <translation>95 % nå</translation>
    </message>
    <message>
        <source>A later visit of the patrol, %1. Its path is planned when its turn comes.</source>
        <translation>Et senere besøk i patruljen, %1. Banen planlegges når det er dets tur.</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Igjen</translation>
    </message>
    <message>
        <source>When the patrol comes back to the iceberg</source>
        <translation>Når patruljen kommer tilbake til isfjellet</translation>
    </message>
</context>
<context>
    <name>berg::PlanPanel</name>
    <message>
        <source>There is no plan: see Checks.</source>
        <translation>Det finnes ingen plan: se Kontroll.</translation>
    </message>
    <message>
        <source>Plan: icebergs in visiting order</source>
        <translation>Plan: isfjell i besøksrekkefølge</translation>
    </message>
    <message>
        <source>Order before the change at %1: %2</source>
        <translation>Rekkefølgen før endringen ved %1: %2</translation>
    </message>
    <message>
        <source>Predicted for straight legs to the icebergs as they drift,
without sightings en route and without new plans.</source>
        <translation>Forutsagt for rette etapper til isfjellene slik de driver,
uten observasjoner underveis og uten nye planer.</translation>
    </message>
    <message>
        <source>Predicted for the path on the map, with every iceberg that comes into view
on it, without new plans.</source>
        <translation>Forutsagt for banen på kartet, med hvert isfjell som kommer i syne
på den, uten nye planer.</translation>
    </message>
    <message>
        <source>No useful lower bound on ζ</source>
        <translation>Ingen nyttig nedre grense for ζ</translation>
    </message>
    <message>
        <source>The lower bound is proven for this scenario and its random drift,
for any policy and any turn radius.</source>
        <translation>Den nedre grensen er bevist for dette scenarioet og den tilfeldige driften,
for enhver strategi og enhver svingradius.</translation>
    </message>
    <message>
        <source>Out of radio range for %1</source>
        <translation>Utenfor radiorekkevidde i %1</translation>
    </message>
    <message>
        <source>Recovery slots: %1</source>
        <translation>Landingsvinduer: %1</translation>
    </message>
    <message>
        <source>Compared with the last plan: %1</source>
        <translation>Sammenlignet med forrige plan: %1</translation>
    </message>
    <message>
        <source>The run is complete.</source>
        <translation>Flygingen er fullført.</translation>
    </message>
    <message>
        <source>This sortie: %1 with the return, flown by %2</source>
        <translation>Dette toktet: %1 med returen, ferdig %2</translation>
    </message>
    <message>
        <source>This sortie: %1 with the return, flown %2</source>
        <translation>Dette toktet: %1 med returen, fløyet %2</translation>
    </message>
    <message>
        <source>This sortie: %1, flown by %2</source>
        <translation>Dette toktet: %1, ferdig %2</translation>
    </message>
    <message>
        <source>This sortie: %1, flown %2</source>
        <translation>Dette toktet: %1, fløyet %2</translation>
    </message>
    <message>
        <source>ζ at the end: %1</source>
        <translation>ζ til slutt: %1</translation>
    </message>
    <message>
        <source>Expected ζ at %1 with this plan: %2</source>
        <translation>Forventet ζ kl. %1 med denne planen: %2</translation>
    </message>
    <message>
        <source>Expected ζ at the end with this plan: %1</source>
        <translation>Forventet ζ til slutt med denne planen: %1</translation>
    </message>
    <message>
        <source>Compared with the last plan: %1, ζ %2</source>
        <translation>Sammenlignet med forrige plan: %1, ζ %2</translation>
    </message>
    <message>
        <source>Lower bound on ζ: being computed, %1 %</source>
        <translation>Nedre grense for ζ: beregnes, %1 %</translation>
    </message>
    <message>
        <source>Lower bound on ζ: %1</source>
        <translation>Nedre grense for ζ: %1</translation>
    </message>
    <message>
        <source>The length of this sortie is over ground, up to the end of the run at most.</source>
        <translation>Lengden av dette toktet er over grunnen, høyst til slutten av flygingen.</translation>
    </message>
    <message>
        <source>Nothing to visit: there are no icebergs yet, all of them are in view, or none can be visited without using the reserve.</source>
        <translation>Ingenting å besøke: det er ingen isfjell ennå, alle er i syne, eller ingen kan besøkes uten å bruke reserven.</translation>
    </message>
    <message>
        <source>Longest time unseen: %1 (%2)</source>
        <comment>duration and iceberg</comment>
        <translation>Lengste tid usett: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>berg::PlanReadoutView</name>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>Uncertainty reward</source>
        <translation>Usikkerhetsgevinst</translation>
    </message>
    <message>
        <source>Sum of each iceberg&apos;s σ times the number of places after it in the order: larger if uncertain icebergs come early.</source>
        <translation>Summen av hvert isfjells σ ganger antallet plasser etter det i rekkefølgen: større hvis usikre isfjell kommer tidlig.</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Målfunksjon</translation>
    </message>
    <message>
        <source>Distance cost minus uncertainty reward: the objective that the solver minimises.</source>
        <translation>Avstandskostnad minus usikkerhetsgevinst: målfunksjonen som løseren minimerer.</translation>
    </message>
    <message>
        <source>Distance weight μ</source>
        <translation>Avstandsvekt μ</translation>
    </message>
    <message>
        <source>Uncertainty that one metre of path must be worth; follows from τ.</source>
        <translation>Usikkerheten som én meter vei må være verd; følger av τ.</translation>
    </message>
    <message>
        <source>%1 m²/m</source>
        <translation>%1 m²/m</translation>
    </message>
    <message>
        <source>Show the checks</source>
        <translation>Vis kontrollen</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detaljer</translation>
    </message>
    <message>
        <source>Objective and distance weight of the plan</source>
        <translation>Målfunksjon og avstandsvekt for planen</translation>
    </message>
    <message>
        <source>State of the plan: %1</source>
        <translation>Planens tilstand: %1</translation>
    </message>
    <message>
        <source>Whole order</source>
        <translation>Hele rekkefølgen</translation>
    </message>
    <message>
        <source>Planned length of the whole order through the air, with turns; in wind the mean of both directions. The solver weighs this length and the trade-off chart shows it. The plan panel shows the length of this sortie over ground.</source>
        <translation>Planlagt lengde av hele rekkefølgen gjennom luften, med svinger; i vind gjennomsnittet av begge retninger. Løseren veier denne lengden, og avveiningsdiagrammet viser den. Rutepanelet viser lengden av dette toktet over grunnen.</translation>
    </message>
</context>
<context>
    <name>berg::PlaybackBar</name>
    <message>
        <source>Fly</source>
        <translation>Fly av sted</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>Rate of the flight</source>
        <translation>Flygingens hastighet</translation>
    </message>
    <message>
        <source>Simulated seconds flown in one second</source>
        <translation>Simulerte sekunder fløyet per sekund</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>The plan is still being made.</source>
        <translation>Planen lages fortsatt.</translation>
    </message>
    <message>
        <source>This scenario cannot be flown. Fix the reported errors first.</source>
        <translation>Dette scenarioet kan ikke flys. Rett de meldte feilene først.</translation>
    </message>
    <message>
        <source>The run has ended.</source>
        <translation>Flygingen er slutt.</translation>
    </message>
    <message>
        <source>Fly again from the start (Space)</source>
        <translation>Fly på nytt fra start (mellomrom)</translation>
    </message>
    <message>
        <source>Pause the flight (Space)</source>
        <translation>Ta pause i flygingen (mellomrom)</translation>
    </message>
    <message>
        <source>Fly the plan (Space)</source>
        <translation>Fly planen (mellomrom)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Ta pause</translation>
    </message>
    <message>
        <source>Fly one second and pause</source>
        <translation>Fly ett sekund og ta pause</translation>
    </message>
    <message>
        <source>Time line of the run</source>
        <translation>Tidslinje for flygingen</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>Vist tid</translation>
    </message>
    <message>
        <source>Time shown. Type a time to look back, e.g. 3:20.</source>
        <translation>Vist tid. Skriv en tid for å se tilbake, f.eks. 3:20.</translation>
    </message>
    <message>
        <source>Length of the run</source>
        <translation>Flygingens lengde</translation>
    </message>
    <message>
        <source>Fastest</source>
        <translation>Raskest</translation>
    </message>
    <message>
        <source>Stop and edit</source>
        <translation>Stopp og rediger</translation>
    </message>
    <message>
        <source>Ends the flight and goes back to the start, where everything can be edited.</source>
        <translation>Avslutter flygingen og går tilbake til start, der alt kan redigeres.</translation>
    </message>
    <message>
        <source>The run is complete. The scenario stays locked until you stop and edit.</source>
        <translation>Flygingen er fullført. Scenarioet forblir låst til du stopper og redigerer.</translation>
    </message>
    <message>
        <source>Scenario locked in flight. τ and policy can be changed while flying; the plan follows at once.</source>
        <translation>Scenarioet er låst under flyging. τ og strategi kan endres; planen følger med straks.</translation>
    </message>
    <message>
        <source>Scenario locked</source>
        <translation>Scenarioet er låst</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time. Type it like 3:20 or 45 min.</source>
        <translation>«%1» er ikke en tid. Skriv den som 3:20 eller 45 min.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time of this run. Type it like 1215Z, 3:20 or 45 min.</source>
        <translation>«%1» er ikke et tidspunkt i denne flygingen. Skriv det som 1215Z, 3:20 eller 45 min.</translation>
    </message>
    <message>
        <source>Time shown. Type a time to look back, e.g. 1215Z, or 3:20 since the start.</source>
        <translation>Vist tid. Skriv en tid for å se tilbake, f.eks. 1215Z, eller 3:20 siden start.</translation>
    </message>
    <message>
        <source>End of the run</source>
        <translation>Slutten på flygingen</translation>
    </message>
</context>
<context>
    <name>berg::PolicyCombo</name>
    <message>
        <source>%1 %…</source>
        <translation>%1 %…</translation>
    </message>
    <message>
        <source>takes too long</source>
        <translation>tar for lang tid</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>valgt</translation>
    </message>
    <message>
        <source>ζ not predicted: takes too long</source>
        <translation>ζ ikke forutsagt: tar for lang tid</translation>
    </message>
    <message>
        <source>Predicting ζ…</source>
        <translation>Forutsier ζ…</translation>
    </message>
    <message>
        <source>Predicted before take-off: ζ %1</source>
        <translation>Forutsagt før avgang: ζ %1</translation>
    </message>
    <message>
        <source>Predicted ζ %1</source>
        <translation>Forutsagt ζ %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 til %2</translation>
    </message>
    <message>
        <source>Recommended</source>
        <translation>Anbefalt</translation>
    </message>
    <message>
        <source>%1; too slow to compare: %2</source>
        <translation>%1; for langsom til å sammenlignes: %2</translation>
    </message>
    <message>
        <source>Not predicted: flying it %1 times in advance takes more than %2.</source>
        <translation>Ikke forutsagt: å fly strategien %1 ganger på forhånd tar mer enn %2.</translation>
    </message>
    <message>
        <source>ζ is predicted before take-off by flying the mission %1 times with each policy, with drift
and sightings drawn as the scenario describes them, in the same %1 worlds: ζ is the mean of
these flights, the range that of 90 % of them. A policy is recommended if its ζ is surely lower
than that of every other one (95 % interval of the differences in the same worlds).</source>
        <translation>ζ forutsies før avgang ved å fly oppdraget %1 ganger med hver strategi, med drift og
observasjoner trukket slik scenarioet beskriver dem, i de samme %1 verdenene: ζ er gjennomsnittet av
disse flygingene, området gjelder 90 % av dem. En strategi anbefales hvis dens ζ sikkert er lavere
enn for alle andre (95 %-intervallet av forskjellene i de samme verdenene).</translation>
    </message>
    <message>
        <source>Predicting ζ: %1 %</source>
        <translation>Forutsier ζ: %1 %</translation>
    </message>
    <message>
        <source>No ζ to predict: there is no iceberg out of view.</source>
        <translation>Ingen ζ å forutsi: det er ikke noe isfjell ute av syne.</translation>
    </message>
    <message>
        <source>%1; no policy is a clear winner</source>
        <translation>%1; ingen strategi er en klar vinner</translation>
    </message>
    <message>
        <source>%1; recommended</source>
        <translation>%1; anbefalt</translation>
    </message>
    <message>
        <source>%1; recommended: %2</source>
        <translation>%1; anbefalt: %2</translation>
    </message>
</context>
<context>
    <name>berg::PreferenceMenus</name>
    <message>
        <source>&amp;Appearance</source>
        <translation>Utsee&amp;nde</translation>
    </message>
    <message>
        <source>U&amp;nits</source>
        <translation>En&amp;heter</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Språk</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Følg systemet</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lyst</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Mørkt</translation>
    </message>
    <message>
        <source>&amp;Distances</source>
        <translation>&amp;Avstander</translation>
    </message>
    <message>
        <source>Metres and kilometres</source>
        <translation>Meter og kilometer</translation>
    </message>
    <message>
        <source>Nautical miles</source>
        <translation>Nautiske mil</translation>
    </message>
    <message>
        <source>&amp;Speeds</source>
        <translation>&amp;Fart</translation>
    </message>
    <message>
        <source>Metres per second</source>
        <translation>Meter per sekund</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>Knop</translation>
    </message>
    <message>
        <source>&amp;Coordinates</source>
        <translation>&amp;Koordinater</translation>
    </message>
    <message>
        <source>Degrees and minutes, %1</source>
        <translation>Grader og minutter, %1</translation>
    </message>
    <message>
        <source>Decimal degrees, %1</source>
        <translation>Desimalgrader, %1</translation>
    </message>
    <message>
        <source>Degrees, minutes, seconds, %1</source>
        <translation>Grader, minutter, sekunder, %1</translation>
    </message>
    <message>
        <source>Speed and direction: wind from, drift towards</source>
        <translation>Fart og retning: vind fra, drift mot</translation>
    </message>
    <message>
        <source>Components east and north</source>
        <translation>Komponenter øst og nord</translation>
    </message>
    <message>
        <source>Drift and &amp;wind</source>
        <translation>Drift og &amp;vind</translation>
    </message>
    <message>
        <source>High contrast, light</source>
        <translation>Høy kontrast, lyst</translation>
    </message>
    <message>
        <source>High contrast, dark</source>
        <translation>Høy kontrast, mørkt</translation>
    </message>
    <message>
        <source>Text si&amp;ze</source>
        <translation>Tekstst&amp;ørrelse</translation>
    </message>
    <message>
        <source>Restart Bergwatch to apply the new text size.</source>
        <translation>Start Bergwatch på nytt for å bruke den nye tekststørrelsen.</translation>
    </message>
    <message>
        <source>Night (red)</source>
        <translation>Natt (rødt)</translation>
    </message>
    <message>
        <source>Automatic, from the scenario</source>
        <translation>Automatisk, etter scenarioet</translation>
    </message>
    <message>
        <source>Ends at %1 m²</source>
        <translation>Slutter ved %1 m²</translation>
    </message>
    <message>
        <source>&amp;Heights</source>
        <translation>&amp;Høyder</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Fot</translation>
    </message>
    <message>
        <source>C&amp;ourses</source>
        <translation>Kurs&amp;er</translation>
    </message>
    <message>
        <source>&amp;Times</source>
        <translation>&amp;Tider</translation>
    </message>
    <message>
        <source>UTC, if the scenario has a start time</source>
        <translation>UTC, hvis scenarioet har en starttid</translation>
    </message>
    <message>
        <source>Elapsed since the start</source>
        <translation>Tid siden start</translation>
    </message>
    <message>
        <source>&amp;Uncertainty</source>
        <translation>&amp;Usikkerhet</translation>
    </message>
    <message>
        <source>σ first, 95 % radius beside it</source>
        <translation>σ først, 95 %-radien ved siden av</translation>
    </message>
    <message>
        <source>95 % radius first, σ beside it</source>
        <translation>95 %-radien først, σ ved siden av</translation>
    </message>
    <message>
        <source>True</source>
        <translation>Rettvisende</translation>
    </message>
    <message>
        <source>True and magnetic, by the World Magnetic Model 2025</source>
        <translation>Rettvisende og magnetiske, etter World Magnetic Model 2025</translation>
    </message>
    <message>
        <source>True and magnetic, declination %1...</source>
        <translation>Rettvisende og magnetiske, misvisning %1 …</translation>
    </message>
    <message>
        <source>True and magnetic, declination entered by hand...</source>
        <translation>Rettvisende og magnetiske, innskrevet misvisning …</translation>
    </message>
</context>
<context>
    <name>berg::RecentRow</name>
    <message>
        <source>The file is gone</source>
        <translation>Filen er borte</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Remove it from this list.</source>
        <translation>Fjern den fra denne listen.</translation>
    </message>
</context>
<context>
    <name>berg::RecoveryDialog</name>
    <message>
        <source>Recovered work</source>
        <translation>Gjenopprettet arbeid</translation>
    </message>
    <message>
        <source>Bergwatch ended unexpectedly. Unsaved changes were kept. Restore them, and then save them.</source>
        <translation>Bergwatch sluttet uventet. Ulagrede endringer er tatt vare på. Gjenopprett dem, og lagre dem.</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Gjenopprett</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Forkast</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Senere</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Endret</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>ikke lagret ennå</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
</context>
<context>
    <name>berg::ResultFiles</name>
    <message>
        <source>Runs (*.bergrun);;All files (*)</source>
        <translation>Flyginger (*.bergrun);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Lagret %1</translation>
    </message>
    <message numerus="yes">
        <source>%n files with these names exist. Their content would be lost.</source>
        <translation>
            <numerusform>%n fil med dette navnet finnes. Innholdet ville gå tapt.</numerusform>
            <numerusform>%n filer med disse navnene finnes. Innholdet ville gå tapt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>Eksportert til %1</translation>
    </message>
    <message numerus="yes">
        <source>Exported %n files</source>
        <translation>
            <numerusform>Eksporterte %n fil</numerusform>
            <numerusform>Eksporterte %n filer</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture of the map copied</source>
        <translation>Bilde av kartet er kopiert</translation>
    </message>
    <message>
        <source>The run is saved as soon as the current plan is made.</source>
        <translation>Flygingen lagres så snart den nåværende planen er laget.</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Lagrer %1</translation>
    </message>
</context>
<context>
    <name>berg::RunMarkDelegate</name>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
</context>
<context>
    <name>berg::RunTable</name>
    <message>
        <source>Runs</source>
        <translation>Flyginger</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Flyging</translation>
    </message>
    <message>
        <source>ζ, m² s</source>
        <translation>ζ, m² s</translation>
    </message>
    <message>
        <source>vs A</source>
        <translation>mot A</translation>
    </message>
    <message>
        <source>The reference: click a circle, or press A.</source>
        <translation>Referansen: klikk en sirkel, eller trykk A.</translation>
    </message>
    <message>
        <source>Compared with it: click a circle, or press B.</source>
        <translation>Sammenlignes med den: klikk en sirkel, eller trykk B.</translation>
    </message>
    <message>
        <source>Zeta compared with that of A at the time both have flown.</source>
        <translation>Zeta sammenlignet med den for A ved tiden som begge har fløyet.</translation>
    </message>
    <message>
        <source>Flown runs are listed here. The button below flies this scenario along the shortest round tour for comparison.</source>
        <translation>Fløyne flyginger står her. Knappen nedenfor flyr dette scenarioet langs den korteste rundturen til sammenligning.</translation>
    </message>
    <message>
        <source>Its scenario differs from that of A: they cannot be compared.</source>
        <translation>Scenarioet er et annet enn for A: de kan ikke sammenlignes.</translation>
    </message>
    <message>
        <source>Make this run the reference A</source>
        <translation>Gjør denne flygingen til referansen A</translation>
    </message>
    <message>
        <source>Compare this run with A</source>
        <translation>Sammenlign denne flygingen med A</translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>én UAV</numerusform>
            <numerusform>%n UAV-er</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Gi nytt navn</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
</context>
<context>
    <name>berg::RunTimeLine</name>
    <message>
        <source>%1: point of no return; a later return uses the reserve</source>
        <translation>%1: siste vendepunkt; en senere hjemtur bruker av reserven</translation>
    </message>
</context>
<context>
    <name>berg::ScenarioDialogs</name>
    <message numerus="yes">
        <source>Generate %n icebergs</source>
        <translation>
            <numerusform>Generer isfjell</numerusform>
            <numerusform>Generer %n isfjell</numerusform>
        </translation>
    </message>
    <message>
        <source>Move scenario</source>
        <translation>Flytt scenarioet</translation>
    </message>
    <message>
        <source>Place the new scenario</source>
        <translation>Plasser det nye scenarioet</translation>
    </message>
    <message>
        <source>A forecast cannot be imported in flight. Stop the flight before importing.</source>
        <translation>Et varsel kan ikke importeres under flyging. Stopp flygingen før du importerer.</translation>
    </message>
    <message>
        <source>Forecasts: NetCDF, GRIB, JSON (*.nc *.nc4 *.cdf *.grib *.grib2 *.grb *.grb2 *.json);;All files (*)</source>
        <translation>Varsler: NetCDF, GRIB, JSON (*.nc *.nc4 *.cdf *.grib *.grib2 *.grb *.grb2 *.json);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Import forecast</source>
        <translation>Importer varsel</translation>
    </message>
    <message>
        <source>Remove forecast</source>
        <translation>Fjern varsel</translation>
    </message>
</context>
<context>
    <name>berg::ScenarioFiles</name>
    <message>
        <source>Scenarios (*.berg);;All files (*)</source>
        <translation>Scenarioer (*.berg);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Another Bergwatch</source>
        <translation>En annen Bergwatch</translation>
    </message>
    <message>
        <source>Bergwatch, process %1 on %2</source>
        <translation>Bergwatch, prosess %1 på %2</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Uten navn</translation>
    </message>
    <message>
        <source>New scenario</source>
        <translation>Nytt scenario</translation>
    </message>
    <message>
        <source>Opened a copy of %1</source>
        <translation>Åpnet en kopi av %1</translation>
    </message>
    <message>
        <source>Another program has changed it since you opened it. Those changes would be lost.</source>
        <translation>Et annet program har endret den siden du åpnet den. De endringene ville gå tapt.</translation>
    </message>
    <message>
        <source>%1 has it open. Changes saved there would be lost.</source>
        <translation>%1 har den åpen. Endringer som lagres der, ville gå tapt.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Lagret %1</translation>
    </message>
    <message>
        <source>Saved %1; a backup copy cannot be written to its folder</source>
        <translation>Lagret %1; en sikkerhetskopi kan ikke skrives i mappen</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Ingen filer ennå</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Leser %1</translation>
    </message>
    <message>
        <source>Scenarios, runs, studies and telemetry logs (*.berg *.bergrun *.bergstudy *.tlog);;All files (*)</source>
        <translation>Scenarioer, flyginger, studier og telemetrilogger (*.berg *.bergrun *.bergstudy *.tlog);;Alle filer (*)</translation>
    </message>
</context>
<context>
    <name>berg::ShipRows</name>
    <message>
        <source>Ship that the asset follows</source>
        <translation>Skip som objektet følger</translation>
    </message>
    <message>
        <source>The asset follows no ship</source>
        <translation>Objektet følger ikke noe skip</translation>
    </message>
    <message>
        <source>Ship with launch and home</source>
        <translation>Skip med start og hjem</translation>
    </message>
    <message>
        <source>Launch and home of the UAVs move with the ship, in the simulation and in uploads. The autopilot&apos;s own home stays where it took off.</source>
        <translation>Start og hjem for UAV-ene flytter seg med skipet, i simuleringen og i opplastinger. Autopilotens eget hjem blir der den tok av.</translation>
    </message>
    <message>
        <source>Launch and home are not on a ship</source>
        <translation>Start og hjem er ikke på et skip</translation>
    </message>
    <message>
        <source>The asset follows %1</source>
        <translation>Objektet følger %1</translation>
    </message>
    <message>
        <source>Launch and home are on %1</source>
        <translation>Start og hjem er på %1</translation>
    </message>
</context>
<context>
    <name>berg::SightingsImport</name>
    <message numerus="yes">
        <source>Import %n icebergs from %1</source>
        <translation>
            <numerusform>Importer %n isfjell fra %1</numerusform>
            <numerusform>Importer %n isfjell fra %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Imported %n icebergs from %1</source>
        <translation>
            <numerusform>Importerte %n isfjell fra %1</numerusform>
            <numerusform>Importerte %n isfjell fra %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Import airspace from %1</source>
        <translation>Importer luftrom fra %1</translation>
    </message>
    <message numerus="yes">
        <source>Airspace of %1: %n areas added, %2 already present, %3 farther than 100 km, %4 left out</source>
        <translation>
            <numerusform>Luftrom fra %1: %n område lagt til, %2 fantes fra før, %3 lenger unna enn 100 km, %4 utelatt</numerusform>
            <numerusform>Luftrom fra %1: %n områder lagt til, %2 fantes fra før, %3 lenger unna enn 100 km, %4 utelatt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n areas: a scenario can have at most %1</source>
        <translation>
            <numerusform>%n område: et scenario kan ha høyst %1</numerusform>
            <numerusform>%n områder: et scenario kan ha høyst %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Airspace cannot be imported in flight. Stop the flight before importing.</source>
        <translation>Luftrom kan ikke importeres under flyging. Stopp flygingen før du importerer.</translation>
    </message>
    <message>
        <source>Clipboard</source>
        <translation>Utklippstavle</translation>
    </message>
    <message>
        <source>The flight has continued in the meantime, so nothing was reported.</source>
        <translation>Flygingen har fortsatt i mellomtiden, så ingenting ble meldt.</translation>
    </message>
    <message numerus="yes">
        <source>Reported %n icebergs from %1</source>
        <translation>
            <numerusform>Meldte %n isfjell fra %1</numerusform>
            <numerusform>Meldte %n isfjell fra %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Airspace left out or changed</source>
        <translation>Luftrom utelatt eller endret</translation>
    </message>
    <message>
        <source>Sightings (*.csv *.txt *.geojson *.json *.kml *.kmz *.czml *.gpx *.plan *.waypoints *.nmea *.jpg *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;All files (*)</source>
        <translation>Observasjoner (*.csv *.txt *.geojson *.json *.kml *.kmz *.czml *.gpx *.plan *.waypoints *.nmea *.jpg *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Airspace (*.txt *.openair *.air *.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.zip);;All files (*)</source>
        <translation>Luftrom (*.txt *.openair *.air *.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.zip);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Ice charts (*.shp *.zip *.gpkg *.gml *.fgb *.e00 *.geojson *.json);;All files (*)</source>
        <translation>Iskart (*.shp *.zip *.gpkg *.gml *.fgb *.e00 *.geojson *.json);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Ice charts cannot be imported in flight. Stop the flight before importing.</source>
        <translation>Iskart kan ikke importeres under flyging. Stopp flygingen før du importerer.</translation>
    </message>
    <message>
        <source>Import ice chart from %1</source>
        <translation>Importer iskart fra %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>ukjent</translation>
    </message>
    <message numerus="yes">
        <source>Ice chart of %1: %n areas, date %2, %3 left out or far away</source>
        <translation>
            <numerusform>Iskart fra %1: %n område, dato %2, %3 utelatt eller langt unna</numerusform>
            <numerusform>Iskart fra %1: %n områder, dato %2, %3 utelatt eller langt unna</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::SolveTimeChart</name>
    <message>
        <source>Solution time against the number of icebergs</source>
        <translation>Løsningstid mot antall isfjell</translation>
    </message>
    <message>
        <source>Solution time</source>
        <translation>Løsningstid</translation>
    </message>
    <message>
        <source>Time for one plan, logarithmic</source>
        <translation>Tid for én plan, logaritmisk</translation>
    </message>
    <message>
        <source>Line: median. Dashed: worst. Hollow: some were cut short.</source>
        <translation>Linje: median. Stiplet: verst. Hul: noen ble avbrutt.</translation>
    </message>
    <message>
        <source>Number of icebergs</source>
        <translation>Antall isfjell</translation>
    </message>
    <message>
        <source>CPLEX, worst (paper)</source>
        <translation>CPLEX, verst (artikkelen)</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n icebergs</source>
        <translation>
            <numerusform>%1, %n isfjell</numerusform>
            <numerusform>%1, %n isfjell</numerusform>
        </translation>
    </message>
    <message>
        <source>median %1, worst %2</source>
        <translation>median er %1, verst %2</translation>
    </message>
    <message>
        <source>average %1, worst %2</source>
        <translation>gjennomsnitt %1, verst %2</translation>
    </message>
    <message>
        <source>proven: %1 of %2</source>
        <translation>bevist: %1 av %2</translation>
    </message>
</context>
<context>
    <name>berg::SolveTimePanel</name>
    <message>
        <source>Proves the optimum by dynamic programming or by the bound of Bergwatch&apos;s engine.</source>
        <translation>Beviser optimum med dynamisk programmering eller med grensen fra Bergwatchs løser.</translation>
    </message>
    <message>
        <source>Searches, and proves as much as about a second of work allows.</source>
        <translation>Søker, og beviser så mye som omtrent ett sekunds regnetid tillater.</translation>
    </message>
    <message>
        <source>COIN-OR CBC on a MILP with a variable for each leg and position. Independent of Bergwatch&apos;s engine.</source>
        <translation>COIN-OR CBC på et MILP med en variabel for hver etappe og plass. Uavhengig av Bergwatchs løser.</translation>
    </message>
    <message>
        <source>COIN-OR CBC on the MILP as the paper prints it. Slow beyond 8 icebergs.</source>
        <translation>COIN-OR CBC på MILP-et slik artikkelen trykker det. Langsom over 8 isfjell.</translation>
    </message>
    <message>
        <source>COIN-OR CBC on the few legs that the bound of Bergwatch&apos;s engine leaves.</source>
        <translation>COIN-OR CBC på de få etappene som grensen fra Bergwatchs løser lar stå igjen.</translation>
    </message>
    <message>
        <source>Icebergs, up to</source>
        <translation>Isfjell, opptil</translation>
    </message>
    <message>
        <source>Largest number of icebergs. The paper went to 20.</source>
        <translation>Største antall isfjell. Artikkelen gikk til 20.</translation>
    </message>
    <message>
        <source>Problems of each size</source>
        <translation>Problemer av hver størrelse</translation>
    </message>
    <message>
        <source>Random problems as in Table 1 of the paper, the same at every run.</source>
        <translation>Tilfeldige problemer som i tabell 1 i artikkelen, de samme hver gang.</translation>
    </message>
    <message>
        <source>Total time limit</source>
        <translation>Tidsgrense i alt</translation>
    </message>
    <message>
        <source>A solver that does not finish a size skips the larger ones.</source>
        <translation>En løser som ikke blir ferdig med en størrelse, hopper over de større.</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Fremdrift for målingen</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>Lagre CSV …</translation>
    </message>
    <message>
        <source>Saves the measured times as a table.</source>
        <translation>Lagrer de målte tidene som en tabell.</translation>
    </message>
    <message>
        <source>Measuring, about %1 left</source>
        <translation>Måler, omtrent %1 igjen</translation>
    </message>
    <message>
        <source>Start measures this machine on the problems of the paper, for comparison with the paper&apos;s times.</source>
        <translation>Start måler denne maskinen på problemene i artikkelen, for å sammenligne med tidene i artikkelen.</translation>
    </message>
    <message>
        <source>Measured in %1.</source>
        <translation>Målt på %1.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Choose a solver first.</source>
        <translation>Velg en løser først.</translation>
    </message>
    <message>
        <source>Stopped. The times measured so far are kept.</source>
        <translation>Stoppet. Tidene som er målt til nå, er beholdt.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
</context>
<context>
    <name>berg::StartChart</name>
    <message>
        <source>Zeta by start time</source>
        <translation>Zeta etter starttid</translation>
    </message>
    <message>
        <source>Press Compare to fly the scenario from each start time.</source>
        <translation>Trykk på Sammenlign for å fly scenarioet fra hver starttid.</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>Sammenligner …</translation>
    </message>
</context>
<context>
    <name>berg::StartPage</name>
    <message>
        <source>Keep watch over drifting icebergs.</source>
        <translation>Hold øye med isfjell i drift.</translation>
    </message>
    <message>
        <source>Continue with %1</source>
        <translation>Fortsett med %1</translation>
    </message>
    <message>
        <source>New scenario</source>
        <translation>Nytt scenario</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Åpne …</translation>
    </message>
    <message>
        <source>New here? Take the tour, three steps</source>
        <translation>Ny her? Ta omvisningen, tre trinn</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Omvisning</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Nylige filer</translation>
    </message>
    <message>
        <source>Show this page at the start</source>
        <translation>Vis denne siden ved start</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Eksempler</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Ingen filer ennå</translation>
    </message>
    <message>
        <source>Import sightings...</source>
        <translation>Importer observasjoner …</translation>
    </message>
</context>
<context>
    <name>berg::StartPageController</name>
    <message>
        <source>Untitled</source>
        <translation>Uten navn</translation>
    </message>
    <message>
        <source>1. Place icebergs</source>
        <translation>1. Plasser isfjell</translation>
    </message>
    <message>
        <source>2. Drag τ</source>
        <translation>2. Dra τ</translation>
    </message>
    <message>
        <source>Drag left to visit the most uncertain icebergs first, right for a shorter route. Ticks mark where another order becomes optimal.</source>
        <translation>Dra til venstre for å besøke de mest usikre isfjellene først, til høyre for en kortere rute. Merkene viser hvor en annen rekkefølge blir optimal.</translation>
    </message>
    <message>
        <source>3. Press Space</source>
        <translation>3. Trykk mellomrom</translation>
    </message>
    <message>
        <source>Press Space to fly and to pause. Drag the time line to look back. Stop and edit returns to the start.</source>
        <translation>Trykk mellomrom for å fly og ta pause. Dra tidslinjen for å se tilbake. «Stopp og rediger» går tilbake til starten.</translation>
    </message>
    <message>
        <source>After this tour, press I and click on the map to place an iceberg. Drag it to move it, double-click it to set its drift and the uncertainty of its position. The plan follows at once.</source>
        <translation>Etter denne omvisningen: trykk I og klikk på kartet for å plassere et isfjell. Dra det for å flytte det, dobbeltklikk det for å sette driften og usikkerheten i posisjonen. Planen følger med straks.</translation>
    </message>
</context>
<context>
    <name>berg::StartPanel</name>
    <message>
        <source>Starts within</source>
        <translation>Starter innen</translation>
    </message>
    <message>
        <source>Latest start after the start of the scenario</source>
        <translation>Seneste start etter starten av scenarioet</translation>
    </message>
    <message>
        <source>One every</source>
        <translation>Én hver</translation>
    </message>
    <message>
        <source>Progress of the comparison</source>
        <translation>Fremdrift i sammenligningen</translation>
    </message>
    <message>
        <source>Use this start</source>
        <translation>Bruk denne starten</translation>
    </message>
    <message>
        <source>cannot be flown</source>
        <translation>kan ikke flys</translation>
    </message>
    <message>
        <source>%1 UTC: ζ %2. %3</source>
        <comment>start, zeta, weather</comment>
        <translation>%1 UTC: ζ %2. %3</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Sammenlign</translation>
    </message>
    <message>
        <source>Flying the scenario from each start…</source>
        <translation>Flyr scenarioet fra hver start …</translation>
    </message>
    <message>
        <source>Flying the scenario from each start: %1 of %2</source>
        <comment>starts done, all</comment>
        <translation>Flyr scenarioet fra hver start: %1 av %2</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Avbrutt.</translation>
    </message>
    <message>
        <source>The scenario has no start time. Set Start (UTC) in the Inspector.</source>
        <translation>Scenarioet har ingen starttid. Sett Starttid (UTC) i Egenskaper.</translation>
    </message>
    <message>
        <source>Icebergs drift on unseen until a later start, so their estimates are older.</source>
        <translation>Isfjell driver videre uten å bli sett til en senere start, så estimatene er eldre.</translation>
    </message>
    <message>
        <source>The scenario has changed since. Compare again.</source>
        <translation>Scenarioet er endret siden. Sammenlign på nytt.</translation>
    </message>
    <message>
        <source>No start has weather within all limits. Choose a bar to see why.</source>
        <translation>Ingen start har vær innenfor alle grenser. Velg en søyle for å se hvorfor.</translation>
    </message>
    <message>
        <source>Start at %1 UTC</source>
        <translation>Start kl. %1 UTC</translation>
    </message>
</context>
<context>
    <name>berg::StatusLine</name>
    <message>
        <source>Shows the findings about the scenario.</source>
        <translation>Viser funnene om scenarioet.</translation>
    </message>
    <message>
        <source>%1   %2 E  %3 N</source>
        <comment>place, east and north of the origin</comment>
        <translation>%1   %2 Ø  %3 N</translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation>Tilstand: %1</translation>
    </message>
    <message>
        <source>Cursor: %1</source>
        <translation>Peker: %1</translation>
    </message>
    <message>
        <source>Not changed: %1</source>
        <translation>Ikke endret: %1</translation>
    </message>
</context>
<context>
    <name>berg::StudyChart</name>
    <message>
        <source>Choose what to fly and press Start, or load a figure from the paper.</source>
        <translation>Velg hva som skal flys, og trykk Start, eller last en figur fra artikkelen.</translation>
    </message>
    <message>
        <source>This chart compares each setting with a reference, case by case.</source>
        <translation>Dette diagrammet sammenligner hver innstilling med en referanse, tilfelle for tilfelle.</translation>
    </message>
    <message numerus="yes">
        <source>%n cases</source>
        <translation>
            <numerusform>%n tilfelle</numerusform>
            <numerusform>%n tilfeller</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>name of a study, how many cases</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>berg::StudyController</name>
    <message>
        <source>Studies (*.bergstudy);;All files (*)</source>
        <translation>Studier (*.bergstudy);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Studies and their reports (*.bergstudy *.json *.html);;All files (*)</source>
        <translation>Studier og rapporter om dem (*.bergstudy *.json *.html);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Reports (*.html);;All files (*)</source>
        <translation>Rapporter (*.html);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tabeller (*.csv);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Lagret %1</translation>
    </message>
    <message>
        <source>Bergwatch ended unexpectedly. This unsaved study was kept. Save it, or fly the rest.</source>
        <translation>Bergwatch sluttet uventet. Denne ulagrede studien er tatt vare på. Lagre den, eller fly resten.</translation>
    </message>
    <message>
        <source>Autosaving failed: %1</source>
        <translation>Autolagringen mislyktes: %1</translation>
    </message>
    <message>
        <source>Study: %1</source>
        <translation>Studie: %1</translation>
    </message>
</context>
<context>
    <name>berg::StudyFlights</name>
    <message>
        <source>Fly as in the study</source>
        <translation>Fly som i studien</translation>
    </message>
    <message>
        <source>Flown as in the study, which is under View, Study.</source>
        <translation>Fløyet som i studien, som ligger under Vis, Studie.</translation>
    </message>
    <message>
        <source>Fly Figure 5 of the paper</source>
        <translation>Fly figur 5 i artikkelen</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Bruk %1</translation>
    </message>
    <message>
        <source>Planned with %1</source>
        <translation>Planlagt med %1</translation>
    </message>
</context>
<context>
    <name>berg::StudyPanel</name>
    <message>
        <source>As in the paper</source>
        <translation>Som i artikkelen</translation>
    </message>
    <message>
        <source>Figure 3</source>
        <translation>Figur 3</translation>
    </message>
    <message>
        <source>Solution times by number of icebergs: opens the solve time study with the sizes of the paper.</source>
        <translation>Løsningstider etter antall isfjell: åpner studien av løsningstid med størrelsene i artikkelen.</translation>
    </message>
    <message>
        <source>Figure 4</source>
        <translation>Figur 4</translation>
    </message>
    <message>
        <source>Figure 5</source>
        <translation>Figur 5</translation>
    </message>
    <message>
        <source>ζ of this scenario for τ = 0, 0.1 … 4, and of the shortest path.</source>
        <translation>ζ for dette scenarioet med τ = 0, 0,1 … 4, og for den korteste veien.</translation>
    </message>
    <message>
        <source>Two flights of this scenario over the map: with the τ of lowest ζ, and along the shortest path.</source>
        <translation>To flyginger av dette scenarioet over kartet: med den τ som gir lavest ζ, og langs den korteste veien.</translation>
    </message>
</context>
<context>
    <name>berg::StudyResults</name>
    <message>
        <source>Compared with</source>
        <translation>Sammenlignet med</translation>
    </message>
    <message>
        <source>Reference that the other settings are compared with</source>
        <translation>Referanse som de andre innstillingene sammenlignes med</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Åpne …</translation>
    </message>
    <message>
        <source>Opens a study to view or continue it.</source>
        <translation>Åpner en studie for å vise eller fortsette den.</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Lagre …</translation>
    </message>
    <message>
        <source>Saves the study with all flights so far, also while it is running.</source>
        <translation>Lagrer studien med alle flyginger til nå, også mens den kjører.</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport …</translation>
    </message>
    <message>
        <source>Writes a page with pictures, scenarios, seeds, version and machine.</source>
        <translation>Skriver en side med bilder, scenarioer, startfrø, versjon og maskin.</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tabell …</translation>
    </message>
    <message>
        <source>Saves the numbers of all settings as CSV.</source>
        <translation>Lagrer tallene for alle innstillinger som CSV.</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Bilde …</translation>
    </message>
    <message>
        <source>Saves the picture in front (PNG, SVG, PDF).</source>
        <translation>Lagrer bildet i forgrunnen (PNG, SVG, PDF).</translation>
    </message>
    <message>
        <source>ζ against τ</source>
        <translation>ζ mot τ</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Forskjeller</translation>
    </message>
    <message>
        <source>Settings of the study</source>
        <translation>Innstillinger i studien</translation>
    </message>
    <message>
        <source>Cases of the setting chosen</source>
        <translation>Tilfeller av valgt innstilling</translation>
    </message>
    <message>
        <source>Open this run</source>
        <translation>Åpne denne flygingen</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Innstillinger</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Tilfeller</translation>
    </message>
    <message>
        <source>Cases of %1</source>
        <translation>Tilfeller av %1</translation>
    </message>
    <message>
        <source>Repeats this case exactly and shows it on the map and the time line.</source>
        <translation>Gjentar dette tilfellet nøyaktig og viser det på kartet og tidslinjen.</translation>
    </message>
    <message>
        <source>Choose a point of the picture or a setting, then a case.</source>
        <translation>Velg et punkt i bildet eller en innstilling, deretter et tilfelle.</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Bruk %1</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Bruk</translation>
    </message>
    <message>
        <source>Plans the scenario on the map with this setting.</source>
        <translation>Planlegger scenarioet på kartet med denne innstillingen.</translation>
    </message>
    <message>
        <source>Choose a point of the picture or a setting.</source>
        <translation>Velg et punkt i bildet eller en innstilling.</translation>
    </message>
    <message>
        <source>Lowest ζ: %1. One case is too few for a recommendation: fly more of them.</source>
        <translation>Lavest ζ: %1. Ett tilfelle er for lite til en anbefaling: fly flere.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 og %2 til</translation>
    </message>
    <message numerus="yes">
        <source>No clear winner over %n cases. These settings may be the best: %1.</source>
        <translation>
            <numerusform>Ingen klar vinner over %n tilfelle. Disse innstillingene kan være best: %1.</numerusform>
            <numerusform>Ingen klar vinner over %n tilfeller. Disse innstillingene kan være best: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Recommended: %1. Its ζ is %2 (95 %: %3 to %4) against %5, the closest other setting, over %n cases.</source>
        <translation>
            <numerusform>Anbefalt: %1. Dens ζ er %2 (95 %: %3 til %4) mot %5, den nærmeste andre innstillingen, over %n tilfelle.</numerusform>
            <numerusform>Anbefalt: %1. Dens ζ er %2 (95 %: %3 til %4) mot %5, den nærmeste andre innstillingen, over %n tilfeller.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::StudyRunBar</name>
    <message>
        <source>under a second</source>
        <translation>under et sekund</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>omtrent %1 s</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>omtrent %1 min</translation>
    </message>
    <message>
        <source>about %1 h</source>
        <translation>omtrent %1 t</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsett</translation>
    </message>
    <message>
        <source>Flies the missing missions of the study shown.</source>
        <translation>Flyr oppdragene som mangler i studien som vises.</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Fremdrift i studien</translation>
    </message>
    <message>
        <source>%1 missions, %2</source>
        <translation>%1 oppdrag, %2</translation>
    </message>
    <message>
        <source>%1 missions flown.</source>
        <translation>%1 oppdrag fløyet.</translation>
    </message>
    <message>
        <source>%1 of %2 missions flown.</source>
        <translation>%1 av %2 oppdrag fløyet.</translation>
    </message>
    <message>
        <source>About %1 left.</source>
        <translation>Omtrent %1 igjen.</translation>
    </message>
    <message>
        <source>The flights so far are kept.</source>
        <translation>Flygingene til nå beholdes.</translation>
    </message>
    <message>
        <source>Start study</source>
        <translation>Start studien</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
</context>
<context>
    <name>berg::StudySetup</name>
    <message>
        <source>This scenario</source>
        <translation>Dette scenarioet</translation>
    </message>
    <message>
        <source>Random scenarios</source>
        <translation>Tilfeldige scenarioer</translation>
    </message>
    <message>
        <source>Fields of icebergs as in Table 3 of the paper, one for each seed.</source>
        <translation>Isfjellfelt som i tabell 3 i artikkelen, ett for hvert startfrø.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Antall</translation>
    </message>
    <message>
        <source>Number of random scenarios.</source>
        <translation>Antall tilfeldige scenarioer.</translation>
    </message>
    <message>
        <source>First seed</source>
        <translation>Første startfrø</translation>
    </message>
    <message>
        <source>Further scenarios use the seeds that follow.</source>
        <translation>De neste scenarioene bruker startfrøene som følger.</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Isfjell</translation>
    </message>
    <message>
        <source>Number of icebergs in each random scenario.</source>
        <translation>Antall isfjell i hvert tilfeldige scenario.</translation>
    </message>
    <message>
        <source>Runs each</source>
        <translation>Flyginger av hvert</translation>
    </message>
    <message>
        <source>Flights of each scenario with different noise: the true drift is drawn again, identically for every setting.</source>
        <translation>Flyginger av hvert scenario med annen støy: den sanne driften trekkes på nytt, den samme for hver innstilling.</translation>
    </message>
    <message>
        <source>τ from</source>
        <translation>τ fra</translation>
    </message>
    <message>
        <source>Smallest trade-off τ.</source>
        <translation>Minste avveining τ.</translation>
    </message>
    <message>
        <source>to</source>
        <comment>largest tau</comment>
        <translation>til</translation>
    </message>
    <message>
        <source>Largest trade-off τ.</source>
        <translation>Største avveining τ.</translation>
    </message>
    <message>
        <source>step</source>
        <comment>of tau</comment>
        <translation>steg</translation>
    </message>
    <message>
        <source>Step between two values of τ.</source>
        <translation>Avstand mellom to verdier av τ.</translation>
    </message>
    <message numerus="yes">
        <source>%n random scenarios</source>
        <translation>
            <numerusform>%n tilfeldig scenario</numerusform>
            <numerusform>%n tilfeldige scenarioer</numerusform>
        </translation>
    </message>
    <message>
        <source>This scenario has no icebergs.</source>
        <translation>Dette scenarioet har ingen isfjell.</translation>
    </message>
    <message>
        <source>The largest τ is below the smallest.</source>
        <translation>Største τ er under minste.</translation>
    </message>
    <message>
        <source>Too many values of τ. Choose a larger step.</source>
        <translation>For mange verdier av τ. Velg et større steg.</translation>
    </message>
    <message>
        <source>Choose at least one policy.</source>
        <translation>Velg minst én strategi.</translation>
    </message>
    <message>
        <source>A study has at most %1 missions.</source>
        <translation>En studie har høyst %1 oppdrag.</translation>
    </message>
    <message>
        <source>Knowledge of the drift in random scenarios, and how icebergs are observed.</source>
        <translation>Kunnskapen om driften i tilfeldige scenarioer, og hvordan isfjell observeres.</translation>
    </message>
    <message>
        <source>As published</source>
        <translation>Som publisert</translation>
    </message>
    <message>
        <source>Velocities are known, and an iceberg in view has no uncertainty.</source>
        <translation>Hastighetene er kjent, og et isfjell i syne har ingen usikkerhet.</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Målt</translation>
    </message>
    <message>
        <source>Measurements with noise, filtered for position and velocity.</source>
        <translation>Målinger med støy, filtrert for posisjon og hastighet.</translation>
    </message>
    <message>
        <source>Unknown velocity</source>
        <translation>Ukjent hastighet</translation>
    </message>
    <message>
        <source>Measured; velocities are uncertain by 0.1 m/s along each axis.</source>
        <translation>Målt; hastighetene er usikre med 0,1 m/s langs hver akse.</translation>
    </message>
    <message>
        <source>Real drift</source>
        <translation>Virkelig drift</translation>
    </message>
    <message>
        <source>Measured; velocities are unknown and change, as observed for icebergs with beacons.</source>
        <translation>Målt; hastighetene er ukjente og endrer seg, som observert for isfjell med drivbøyer.</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
</context>
<context>
    <name>berg::TauStrip</name>
    <message>
        <source>Plans along the trade-off τ</source>
        <translation>Planer langs avveiningen τ</translation>
    </message>
    <message numerus="yes">
        <source>%n plans</source>
        <translation>
            <numerusform>%n plan</numerusform>
            <numerusform>%n planer</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. Present plan: %2</source>
        <translation>%1. Gjeldende plan: %2</translation>
    </message>
    <message>
        <source>The plans for every τ are being computed.</source>
        <translation>Planene for alle τ blir beregnet.</translation>
    </message>
</context>
<context>
    <name>berg::Tour</name>
    <message>
        <source>Skip</source>
        <translation>Hopp over</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Tilbake</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Ferdig</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Neste</translation>
    </message>
</context>
<context>
    <name>berg::TradeoffPanel</name>
    <message>
        <source>Trade-off τ</source>
        <translation>Avveining τ</translation>
    </message>
    <message>
        <source>Trade-off τ from most uncertain first to shortest path</source>
        <translation>Avveining τ fra mest usikre først til korteste vei</translation>
    </message>
    <message>
        <source>Most uncertain first</source>
        <translation>Mest usikre først</translation>
    </message>
    <message>
        <source>Shortest path</source>
        <translation>Korteste vei</translation>
    </message>
    <message>
        <source>Policy</source>
        <translation>Strategi</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Løser</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Rutetype</translation>
    </message>
    <message>
        <source>This build of Bergwatch does not include this solver.</source>
        <translation>Denne utgaven av Bergwatch inneholder ikke denne løseren.</translation>
    </message>
    <message>
        <source>The chosen policy does not use this.</source>
        <translation>Den valgte strategien bruker ikke dette.</translation>
    </message>
    <message>
        <source>Small: the most uncertain icebergs come first. Large: the path gets short. Arrow keys change τ by 0.01, Page keys by 0.25.</source>
        <translation>Liten: de mest usikre isfjellene kommer først. Stor: veien blir kort. Piltaster endrer τ med 0,01, Page-taster med 0,25.</translation>
    </message>
    <message>
        <source>Trade-off τ from 0 to 100.</source>
        <translation>Avveining τ fra 0 til 100.</translation>
    </message>
    <message>
        <source>Solver of the plan. Automatic proves small problems optimal and searches in large ones.</source>
        <translation>Løseren for planen. Automatisk beviser små problemer optimale og søker i store.</translation>
    </message>
    <message>
        <source>A one-way plan ends at the last iceberg; a round trip includes the return.</source>
        <translation>Én vei slutter ved det siste isfjellet; en rundtur omfatter også hjemturen.</translation>
    </message>
    <message>
        <source>Locked while looking back. Choose Back to latest or Continue from here to change it.</source>
        <translation>Låst mens du ser tilbake. Velg Tilbake til nyeste eller Fly videre herfra for å endre det.</translation>
    </message>
</context>
<context>
    <name>berg::UnsavedWorkGuard</name>
    <message>
        <source>Untitled</source>
        <translation>Uten navn</translation>
    </message>
    <message>
        <source>Autosaved %1</source>
        <translation>Autolagret %1</translation>
    </message>
    <message>
        <source>Autosaving failed: %1</source>
        <translation>Autolagringen mislyktes: %1</translation>
    </message>
    <message>
        <source>Unsaved work of a program that ended unexpectedly cannot be read. It is kept in this file:
%1</source>
        <translation>Ulagret arbeid fra et program som sluttet uventet, kan ikke leses. Det er tatt vare på i denne filen:
%1</translation>
    </message>
    <message>
        <source>Restored, not saved yet</source>
        <translation>Gjenopprettet, ikke lagret ennå</translation>
    </message>
    <message>
        <source>%1, in flight</source>
        <translation>%1, under flyging</translation>
    </message>
    <message>
        <source>Reading unsaved work</source>
        <translation>Leser ulagret arbeid</translation>
    </message>
</context>
<context>
    <name>berg::ValueTable</name>
    <message>
        <source>Values: %1</source>
        <translation>Verdier: %1</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopier</translation>
    </message>
    <message>
        <source>Show values as a table</source>
        <translation>Vis verdiene som tabell</translation>
    </message>
</context>
<context>
    <name>berg::WindDialog</name>
    <message>
        <source>Wind</source>
        <translation>Vind</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>&amp;Sett</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>F&amp;art</translation>
    </message>
    <message>
        <source>Blows &amp;from</source>
        <translation>Blåser &amp;fra</translation>
    </message>
    <message>
        <source>The UAV will make little headway in this wind.</source>
        <translation>UAV-en kommer knapt fremover i denne vinden.</translation>
    </message>
    <message>
        <source>Must be below the UAV&apos;s airspeed (%1).</source>
        <translation>Må være under UAV-ens flyfart (%1).</translation>
    </message>
</context>
<context>
    <name>berg::Workspace</name>
    <message>
        <source>Change trade-off</source>
        <translation>Endre avveining</translation>
    </message>
    <message>
        <source>Change policy</source>
        <translation>Endre strategi</translation>
    </message>
    <message>
        <source>Change solver</source>
        <translation>Endre løser</translation>
    </message>
    <message>
        <source>Change route</source>
        <translation>Endre rutetype</translation>
    </message>
    <message>
        <source>You are viewing an earlier instant. To change this, continue from here or go back to the latest.</source>
        <translation>Du ser på et tidligere øyeblikk. Fly videre herfra, eller gå tilbake til det nyeste, for å endre dette.</translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation>Endre vind</translation>
    </message>
    <message>
        <source>Assign iceberg</source>
        <translation>Tildel isfjell</translation>
    </message>
    <message>
        <source>The scenario was changed before take-off: nothing was flown.</source>
        <translation>Scenarioet ble endret før avgang: ingenting ble fløyet.</translation>
    </message>
    <message>
        <source>Restore flight</source>
        <translation>Hent flygingen tilbake</translation>
    </message>
    <message>
        <source>Move UAVs to their aircraft</source>
        <translation>Flytt UAV-ene til luftfartøyene</translation>
    </message>
</context>
</TS>
