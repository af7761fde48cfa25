<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="da">
<context>
    <name>AreaTool</name>
    <message>
        <source>Add area</source>
        <translation>Tilføj område</translation>
    </message>
    <message>
        <source>Replace area</source>
        <translation>Erstat område</translation>
    </message>
    <message>
        <source>An area needs at least three corners. Esc cancels the drawing.</source>
        <translation>Et område skal have mindst tre hjørner. Esc annullerer tegningen.</translation>
    </message>
    <message>
        <source>Click the first corner or press Enter to close the area. Backspace removes a corner, Esc cancels.</source>
        <translation>Klik på det første hjørne, eller tryk på Enter for at lukke området. Backspace fjerner et hjørne, Esc annullerer.</translation>
    </message>
    <message>
        <source>Click to set the next corner. Backspace removes a corner, Esc cancels.</source>
        <translation>Klik for at sætte det næste hjørne. Backspace fjerner et hjørne, Esc annullerer.</translation>
    </message>
    <message>
        <source>Drag a corner or the middle of an edge; clicking starts a new area. Esc leaves the tool.</source>
        <translation>Træk i et hjørne eller i midten af en kant; et klik begynder et nyt område. Esc forlader værktøjet.</translation>
    </message>
    <message>
        <source>Click to set the first corner of the area. Esc leaves the tool.</source>
        <translation>Klik for at sætte områdets første hjørne. Esc forlader værktøjet.</translation>
    </message>
    <message>
        <source>Add no-fly area</source>
        <translation>Tilføj flyveforbudsområde</translation>
    </message>
    <message>
        <source>Click to set the first corner of a no-fly area, or drag a corner or the middle of an edge of an existing one. Esc leaves the tool.</source>
        <translation>Klik for at sætte det første hjørne af et flyveforbudsområde, eller træk i et hjørne eller midten af en kant på et eksisterende. Esc forlader værktøjet.</translation>
    </message>
</context>
<context>
    <name>AssetText</name>
    <message>
        <source>%1 is inside the inner ring</source>
        <translation>%1 er inden for den indre ring</translation>
    </message>
    <message>
        <source>%1 enters the inner ring in %2</source>
        <translation>%1 kommer ind i den indre ring om %2</translation>
    </message>
</context>
<context>
    <name>BatteryText</name>
    <message>
        <source>about %1 left</source>
        <translation>omkring %1 tilbage</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>%1 tilbage</translation>
    </message>
    <message>
        <source>way home %1</source>
        <translation>vejen hjem %1</translation>
    </message>
    <message>
        <source>planned endurance left %1</source>
        <translation>planlagt udholdenhed tilbage %1</translation>
    </message>
    <message>
        <source>Battery for %1, way home %2</source>
        <translation>Batteri til %1, vejen hjem %2</translation>
    </message>
</context>
<context>
    <name>ChartPageText</name>
    <message>
        <source>Flown until %1</source>
        <translation>Fløjet til %1</translation>
    </message>
    <message>
        <source>Nothing was flown</source>
        <translation>Intet blev fløjet</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>--backends: %1 is none of %2</source>
        <translation>--backends: %1 er ingen af %2</translation>
    </message>
    <message>
        <source>solving</source>
        <translation>løser</translation>
    </message>
    <message>
        <source>interrupted: the table is incomplete</source>
        <translation>afbrudt: tabellen er ufuldstændig</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>advarsel</translation>
    </message>
    <message>
        <source>hint</source>
        <translation>tip</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>%1 tilbage</translation>
    </message>
    <message>
        <source>%1: %2 is not a number</source>
        <translation>%1: %2 er ikke et tal</translation>
    </message>
    <message>
        <source>interrupted, nothing written</source>
        <translation>afbrudt, intet blev skrevet</translation>
    </message>
    <message>
        <source>proving the curve</source>
        <translation>beviser kurven</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>bemærk: %1</translation>
    </message>
    <message>
        <source>--format: %1 is none of %2</source>
        <translation>--format: %1 er ingen af %2</translation>
    </message>
    <message>
        <source>--output: no format has the suffix of %1; choose one with --format: %2</source>
        <translation>--output: intet format har filendelsen på %1; vælg et med --format: %2</translation>
    </message>
    <message>
        <source>--format %1: the program bergwatch paints this format, but it is neither in this folder nor on the PATH</source>
        <translation>--format %1: programmet bergwatch tegner dette format, men det findes hverken i denne mappe eller i PATH</translation>
    </message>
    <message>
        <source>%1: %2 is not a UTC time such as 2026-05-01T12:00:00Z</source>
        <translation>%1: %2 er ikke et UTC-tidspunkt som 2026-05-01T12:00:00Z</translation>
    </message>
    <message>
        <source>--area: %1 is not SOUTH,WEST,NORTH,EAST in degrees</source>
        <translation>--area: %1 er ikke SOUTH,WEST,NORTH,EAST (syd, vest, nord, øst) i grader</translation>
    </message>
    <message>
        <source>--map: %1 is not FIELD=COLUMN with a field of %2</source>
        <translation>--map: %1 er ikke FIELD=COLUMN med et felt af %2</translation>
    </message>
    <message>
        <source>--position-error: %1 is neither a number of metres nor one of %2</source>
        <translation>--position-error: %1 er hverken et antal meter eller en af %2</translation>
    </message>
    <message>
        <source>--with-tracks needs --at: tracks consist of the sightings after that time</source>
        <translation>--with-tracks kræver --at: spor består af observationerne efter det tidspunkt</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>og %1 mere</translation>
    </message>
    <message>
        <source>and %1 more notes about icebergs</source>
        <translation>og %1 bemærkninger mere om isbjerge</translation>
    </message>
    <message>
        <source>the MPI processes have different options</source>
        <translation>MPI-processerne har forskellige tilvalg</translation>
    </message>
    <message>
        <source>%1 is none of %2</source>
        <translation>%1 er ingen af %2</translation>
    </message>
    <message>
        <source>%1 is not a whole number from %2 to %3</source>
        <translation>%1 er ikke et helt tal fra %2 til %3</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 er ikke et tal</translation>
    </message>
    <message>
        <source>%1 is an input of this command; name another file</source>
        <translation>%1 er inddata for denne kommando: angiv en anden fil</translation>
    </message>
    <message>
        <source>%1 is an input of this command (%2); name another file</source>
        <translation>%1 er inddata for denne kommando (%2): angiv en anden fil</translation>
    </message>
    <message>
        <source>%1 is already the file of %2; name another file</source>
        <translation>%1 er allerede filen for %2: angiv en anden fil</translation>
    </message>
    <message>
        <source>%1 and --json both need standard output</source>
        <translation>%1 og --json skal begge bruge standard output</translation>
    </message>
    <message>
        <source>%1 exists; use --force to overwrite it</source>
        <translation>%1 findes; brug --force for at overskrive den</translation>
    </message>
    <message>
        <source>%1: %2 and %3 contradict each other. One of the two is wrong; do not use this order.</source>
        <translation>%1: %2 og %3 modsiger hinanden. En af de to er forkert; brug ikke denne rækkefølge.</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der er ikke hukommelse nok</translation>
    </message>
    <message>
        <source>This is a planning problem: use &apos;solve&apos;.</source>
        <translation>Dette er et planlægningsproblem: brug »solve«.</translation>
    </message>
    <message>
        <source>This is a scenario: use &apos;plan&apos;, &apos;simulate&apos; or &apos;export&apos;.</source>
        <translation>Dette er et scenarie: brug »plan«, »simulate« eller »export«.</translation>
    </message>
    <message>
        <source>This is a run: use &apos;simulate&apos; or &apos;export&apos;.</source>
        <translation>Dette er en flyvning: brug »simulate« eller »export«.</translation>
    </message>
    <message>
        <source>This is a study: use &apos;study&apos;.</source>
        <translation>Dette er et studie: brug »study«.</translation>
    </message>
    <message>
        <source>Name the columns of a table: --map latitude=COLUMN --map longitude=COLUMN.</source>
        <translation>Angiv kolonnerne i en tabel: --map latitude=COLUMN --map longitude=COLUMN.</translation>
    </message>
    <message>
        <source>This is not a Bergwatch file. To read sightings, use &apos;import&apos;.</source>
        <translation>Dette er ikke en Bergwatch-fil. Brug »import« for at læse observationer.</translation>
    </message>
    <message>
        <source>there is no completion script for %1</source>
        <translation>der findes intet fuldførelsesscript til %1</translation>
    </message>
    <message>
        <source>Try &apos;%1 --help&apos;.</source>
        <translation>Prøv »%1 --help«.</translation>
    </message>
    <message>
        <source>took %1 s of processor time and %2 MB of memory</source>
        <translation>brugte %1 s processortid og %2 MB hukommelse</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 er tom</translation>
    </message>
    <message>
        <source>flying</source>
        <translation>flyver</translation>
    </message>
    <message>
        <source>a run file is replayed exactly as flown; --tau, --policy, --duration, --dt, --seed and --no-noise apply to scenarios only</source>
        <translation>en flyvningsfil afspilles nøjagtigt, som den blev fløjet; --tau, --policy, --duration, --dt, --seed og --no-noise gælder kun scenarier</translation>
    </message>
    <message>
        <source>replaying</source>
        <translation>afspiller</translation>
    </message>
    <message>
        <source>--bound does not apply to runs with reported sightings</source>
        <translation>--bound gælder ikke flyvninger med meldte observationer</translation>
    </message>
    <message>
        <source>--bound does not apply to runs in which the wind changed</source>
        <translation>--bound gælder ikke flyvninger, hvor vinden ændrede sig</translation>
    </message>
    <message>
        <source>bounding</source>
        <translation>finder nedre grænse</translation>
    </message>
    <message>
        <source>interrupted: the flight is complete, but its lower bound is missing</source>
        <translation>afbrudt: flyvningen er fuldført, men dens nedre grænse mangler</translation>
    </message>
    <message>
        <source>incomplete: %1 of %2 missions are flown; the results use only cases with all settings</source>
        <translation>ufuldstændig: %1 af %2 missioner er fløjet; resultaterne bruger kun tilfælde med alle indstillinger</translation>
    </message>
    <message>
        <source>--reference: %1 is not POLICY[:TAU] with one of %2</source>
        <translation>--reference: %1 er ikke POLICY[:TAU] med en af %2</translation>
    </message>
    <message>
        <source>--reference: this study does not contain %1</source>
        <translation>--reference: dette studie indeholder ikke %1</translation>
    </message>
    <message>
        <source>--tau: %1 is not A:B:STEP with 0 &lt;= A &lt;= B &lt;= 100</source>
        <translation>--tau: %1 er ikke A:B:STEP med 0 &lt;= A &lt;= B &lt;= 100</translation>
    </message>
    <message>
        <source>--tau: with %1 there are more than %2 values</source>
        <translation>--tau: med %1 bliver der flere end %2 værdier</translation>
    </message>
    <message>
        <source>--policies: %1 is none of %2</source>
        <translation>--policies: %1 er ingen af %2</translation>
    </message>
    <message>
        <source>--regime needs --random N; scenario files define their own drift</source>
        <translation>--regime kræver --random N; scenariefiler bestemmer selv driften</translation>
    </message>
    <message>
        <source>name scenarios, or use --random N</source>
        <translation>angiv scenarier eller --random N</translation>
    </message>
    <message>
        <source>--shard: %1 is not I/N with 1 &lt;= I &lt;= N</source>
        <translation>--shard: %1 er ikke I/N med 1 &lt;= I &lt;= N</translation>
    </message>
    <message>
        <source>--shard needs --study FILE, in which the part is stored</source>
        <translation>--shard kræver --study FILE, hvor delen gemmes</translation>
    </message>
    <message>
        <source>--shard: to write tables and reports of all shards, use &apos;study&apos;</source>
        <translation>--shard: brug »study« for at skrive tabeller og rapporter for alle dele</translation>
    </message>
    <message>
        <source>--replace-study needs --study FILE</source>
        <translation>--replace-study kræver --study FILE</translation>
    </message>
    <message>
        <source>flying %1 missions</source>
        <translation>flyver %1 missioner</translation>
    </message>
    <message>
        <source>interrupted: %1 of %2 missions are stored in %3; repeat the command to continue</source>
        <translation>afbrudt: %1 af %2 missioner er gemt i %3; gentag kommandoen for at fortsætte</translation>
    </message>
    <message>
        <source>there is no option &apos;%1&apos;</source>
        <translation>der findes intet tilvalg »%1«</translation>
    </message>
    <message>
        <source>there is no option &apos;%1&apos;; did you mean &apos;%2&apos;?</source>
        <translation>der findes intet tilvalg »%1«; mente du »%2«?</translation>
    </message>
    <message>
        <source>there is no command &apos;%1&apos;</source>
        <translation>der findes ingen kommando »%1«</translation>
    </message>
    <message>
        <source>there is no command &apos;%1&apos;; did you mean &apos;%2&apos;?</source>
        <translation>der findes ingen kommando »%1«; mente du »%2«?</translation>
    </message>
    <message>
        <source>a command is required</source>
        <translation>en kommando mangler</translation>
    </message>
    <message>
        <source>%1 needs a value</source>
        <translation>%1 kræver en værdi</translation>
    </message>
    <message>
        <source>%1 is given more than once</source>
        <translation>%1 er angivet mere end én gang</translation>
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
        <translation>%1 er luftrum: brug --format airspace med --into SCENARIO</translation>
    </message>
    <message>
        <source>%1 excludes %2</source>
        <translation>%1 udelukker %2</translation>
    </message>
    <message>
        <source>--bound does not apply to runs from which an iceberg was removed</source>
        <translation>--bound gælder ikke flyvninger, hvor et isbjerg blev fjernet</translation>
    </message>
    <message>
        <source>--output: this format writes one file per UAV; choose a UAV with --uav</source>
        <translation>--output: dette format skriver én fil pr. drone; vælg en drone med --uav</translation>
    </message>
    <message>
        <source>%1: &apos;-&apos; is not possible here; give a file name</source>
        <translation>%1: »-« er ikke muligt her: angiv et navn</translation>
    </message>
    <message>
        <source>--map: %1 is mapped twice</source>
        <translation>--map: %1 er tilknyttet to gange</translation>
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
        <translation>--dt, --duration: tidsskridtet er længere end varigheden</translation>
    </message>
    <message>
        <source>--first-seed needs --random N; scenario files have their own seeds</source>
        <translation>--first-seed kræver --random N; scenariefiler har egne startværdier</translation>
    </message>
    <message>
        <source>%1 sightings are too far from the origin of the scenario, %2; import them without --into, or choose others with --area</source>
        <translation>%1 observationer er for langt fra scenariets origo, %2: importér dem uden --into, eller vælg andre med --area</translation>
    </message>
    <message>
        <source>%1 sightings are too far from the origin, %2, which lies in their densest group; choose others with --area</source>
        <translation>%1 observationer er for langt fra origo, %2, som ligger i den tætteste gruppe af dem: vælg andre med --area</translation>
    </message>
    <message>
        <source>%1: %2 is not a position such as 64.51N,59.80W</source>
        <translation>%1: %2 er ikke en position som 64.51N,59.80W</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>vind</translation>
    </message>
    <message>
        <source>gust</source>
        <translation>vindstød</translation>
    </message>
    <message>
        <source>air temperature</source>
        <translation>lufttemperatur</translation>
    </message>
    <message>
        <source>fog</source>
        <translation>tåge</translation>
    </message>
    <message>
        <source>current</source>
        <translation>strøm</translation>
    </message>
    <message>
        <source>issued %1 h before %2; get a newer forecast</source>
        <translation>udsendt %1 t før %2; hent en nyere prognose</translation>
    </message>
    <message>
        <source>is for a place %1 km away</source>
        <translation>gælder et sted %1 km væk</translation>
    </message>
    <message>
        <source>%1: no values between %2 and %3</source>
        <translation>%1: ingen værdier mellem %2 og %3</translation>
    </message>
    <message>
        <source>--since, --until: the forecast is from %1 to %2</source>
        <translation>--since, --until: prognosen går fra %1 til %2</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 kræver %2</translation>
    </message>
    <message>
        <source>the forecasts hold no wind: add one that does, or give %1</source>
        <translation>prognoserne indeholder ikke vind: tilføj en prognose, der gør det, eller angiv %1</translation>
    </message>
    <message>
        <source>the forecasts hold no current: add one that does, or give %1</source>
        <translation>prognoserne indeholder ikke strøm: tilføj en prognose, der gør det, eller angiv %1</translation>
    </message>
    <message>
        <source>--at: wind and current are not both known then; the forecast is from %1 to %2</source>
        <translation>--at: vinden eller strømmen er ikke kendt på dette tidspunkt; prognosen går fra %1 til %2</translation>
    </message>
    <message>
        <source>wind and current are known for %1 h only</source>
        <translation>vind og strøm er kun kendt i %1 t</translation>
    </message>
    <message>
        <source>--latitude is required: growlers and bergy bits drift to the right of the wind in the north, to the left in the south</source>
        <translation>--latitude er påkrævet: growlers og bergy bits driver til højre for vinden i nord, til venstre i syd</translation>
    </message>
    <message>
        <source>%1 can be reached from the network; MAVLink is neither encrypted nor signed</source>
        <translation>%1 kan nås fra netværket; MAVLink er hverken krypteret eller signeret</translation>
    </message>
    <message>
        <source>%1 ends here: it has 1 GiB</source>
        <translation>%1 slutter her: den fylder 1 GiB</translation>
    </message>
    <message>
        <source>the link is broken: %1</source>
        <translation>forbindelsen er brudt: %1</translation>
    </message>
    <message>
        <source>the link is open again</source>
        <translation>forbindelsen er åben igen</translation>
    </message>
    <message>
        <source>packets from %1, which is not part of the link, are ignored</source>
        <translation>pakker fra %1, som ikke er en del af forbindelsen, ignoreres</translation>
    </message>
    <message>
        <source>%1 is no telemetry log</source>
        <translation>%1 er ikke en telemetrilog</translation>
    </message>
    <message>
        <source>--uav: choose one; a link has at most %1 vehicles</source>
        <translation>--uav: vælg én; en forbindelse har højst %1 fartøjer</translation>
    </message>
    <message>
        <source>A forecast is the JSON reply of MET Norway&apos;s locationforecast or oceanforecast, NetCDF or GRIB.</source>
        <translation>En prognose er JSON-svaret fra locationforecast eller oceanforecast hos MET Norway, NetCDF eller GRIB.</translation>
    </message>
    <message>
        <source>dew point</source>
        <translation>dugpunkt</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>sigtbarhed</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>skydækkets højde</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>læser</translation>
    </message>
    <message>
        <source>the grid is too large and was thinned by a factor of %1 in each direction; choose a smaller area or time</source>
        <translation>gitteret er for stort og blev udtyndet med en faktor %1 i hver retning; vælg et mindre område eller tidsrum</translation>
    </message>
    <message>
        <source>--format forecast needs --into, the scenario to add it to</source>
        <translation>--format forecast kræver --into, scenariet, som det føjes til</translation>
    </message>
    <message>
        <source>--format forecast accepts only --into, --at, --replace, --output, --force and --json</source>
        <translation>--format forecast tillader kun --into, --at, --replace, --output, --force og --json</translation>
    </message>
    <message>
        <source>%1 is a forecast; use --format forecast with --into SCENARIO</source>
        <translation>%1 er en prognose: brug --format forecast med --into SCENARIO</translation>
    </message>
    <message>
        <source>photograph %1</source>
        <translation>fotografi %1</translation>
    </message>
    <message>
        <source>--run is about photographs only</source>
        <translation>--run gælder kun fotografier</translation>
    </message>
    <message>
        <source>--format: %1 has one file, not photographs</source>
        <translation>--format: %1 har én fil, ikke fotografier</translation>
    </message>
    <message>
        <source>--uav: the run has no UAV %1</source>
        <translation>--uav: flyvningen har ingen UAV %1</translation>
    </message>
    <message>
        <source>--format %1 needs --into, the scenario to add it to</source>
        <translation>--format %1 kræver --into, scenariet, som det føjes til</translation>
    </message>
    <message>
        <source>--format %1 accepts only --into, --output, --force and --json</source>
        <translation>--format %1 tillader kun --into, --output, --force og --json</translation>
    </message>
    <message>
        <source>%1 is an ice chart; use --into SCENARIO</source>
        <translation>%1 er et iskort: brug --into SCENARIO</translation>
    </message>
    <message>
        <source>--hours, --every: more than %1 points</source>
        <translation>--hours, --every: mere end %1 punkter</translation>
    </message>
    <message>
        <source>--hours, --every: more than %1 starts</source>
        <translation>--hours, --every: mere end %1 starter</translation>
    </message>
    <message>
        <source>%1 is aground from hour %2 on</source>
        <translation>%1 står på grund fra time %2</translation>
    </message>
    <message>
        <source>the forecast gives wind and current for %1 h only</source>
        <translation>prognosen giver kun vind og strøm for %1 t</translation>
    </message>
</context>
<context>
    <name>ComparedRunText</name>
    <message>
        <source>%1, changed in flight, to %2</source>
        <translation>%1, ændret under flyvning, til %2</translation>
    </message>
    <message>
        <source>%1, changed in flight</source>
        <translation>%1, ændret under flyvning</translation>
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
        <translation>%1 fører med %2 %</translation>
    </message>
    <message>
        <source>%1 and %2: the same ζ</source>
        <translation>%1 og %2: samme ζ</translation>
    </message>
    <message>
        <source>%1 is ahead: %2 has %3 % more ζ</source>
        <translation>%1 fører: %2 har %3 % mere ζ</translation>
    </message>
    <message>
        <source>%1 is ahead: it has %3 % less ζ than %2</source>
        <translation>%1 fører: den har %3 % mindre ζ end %2</translation>
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
        <translation>Akkumuleret usikkerhed, ligning (24): mindre er bedre.</translation>
    </message>
    <message>
        <source>Mean Σσ, m²</source>
        <translation>Middel Σσ, m²</translation>
    </message>
    <message>
        <source>Mean total uncertainty of all icebergs: ζ divided by the flown time.</source>
        <translation>Gennemsnitlig samlet usikkerhed for alle isbjerge: ζ divideret med den fløjne tid.</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besøg</translation>
    </message>
    <message>
        <source>Plans</source>
        <translation>Planer</translation>
    </message>
    <message>
        <source>Number of plans made.</source>
        <translation>Antal planer, der er lavet.</translation>
    </message>
    <message>
        <source>Distance flown through the air.</source>
        <translation>Distance fløjet gennem luften.</translation>
    </message>
    <message>
        <source>Longest unseen</source>
        <translation>Længst uset</translation>
    </message>
    <message>
        <source>Longest time for which an iceberg was out of view.</source>
        <translation>Længste tid, et isbjerg var ude af syne.</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isbjerg</translation>
    </message>
    <message>
        <source>The iceberg that was out of view for the longest time.</source>
        <translation>Det isbjerg, der var ude af syne i længst tid.</translation>
    </message>
    <message>
        <source>Unseen for %1 in total in A.</source>
        <translation>Uset i %1 i alt i A.</translation>
    </message>
    <message>
        <source>Flown, %1</source>
        <translation>Fløjet, %1</translation>
    </message>
    <message>
        <source>%1, visits</source>
        <translation>%1, besøg</translation>
    </message>
    <message>
        <source>Icebergs that %1 reached.</source>
        <translation>Isbjerge, som %1 nåede.</translation>
    </message>
    <message>
        <source>Distance that %1 has flown through the air.</source>
        <translation>Distance, som %1 har fløjet gennem luften.</translation>
    </message>
    <message>
        <source>Icebergs reached as targets.</source>
        <translation>Isbjerge, der blev nået som mål.</translation>
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
        <translation>τ %1: hele rækkefølgen %2, bevist optimal</translation>
    </message>
    <message>
        <source>τ %1: whole order %2, not proven</source>
        <translation>τ %1: hele rækkefølgen %2, ikke bevist</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Ændringer, der ikke er gemt</translation>
    </message>
    <message>
        <source>Save the changes to &quot;%1&quot;?</source>
        <translation>Skal ændringerne i »%1« gemmes?</translation>
    </message>
    <message>
        <source>Your changes will be lost if you don&apos;t save them.</source>
        <translation>Ændringerne går tabt, hvis du ikke gemmer dem.</translation>
    </message>
    <message>
        <source>Your changes will be lost if you don&apos;t save them. The flight in progress ends unless you cancel.</source>
        <translation>Ændringerne går tabt, hvis du ikke gemmer dem. Den igangværende flyvning slutter, medmindre du annullerer.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Åbn</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Gem</translation>
    </message>
    <message>
        <source>Bergwatch</source>
        <translation>Bergwatch</translation>
    </message>
    <message>
        <source>File in use</source>
        <translation>Filen er i brug</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another window.</source>
        <translation>»%1« er åben i et andet vindue.</translation>
    </message>
    <message>
        <source>%1 has it open. You can open a copy and save it under another name. If both windows save to this file, the last one wins.</source>
        <translation>%1 har den åben. Du kan åbne en kopi og gemme den under et andet navn. Hvis begge vinduer gemmer i denne fil, gælder det sidste.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Åbn en kopi</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Åbn alligevel</translation>
    </message>
    <message>
        <source>Overwrite the file?</source>
        <translation>Skal filen overskrives?</translation>
    </message>
    <message>
        <source>Overwrite &quot;%1&quot;?</source>
        <translation>Skal »%1« overskrives?</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Overskriv</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Gem som...</translation>
    </message>
    <message>
        <source>File changed</source>
        <translation>Filen er ændret</translation>
    </message>
    <message>
        <source>Another program has changed &quot;%1&quot;.</source>
        <translation>Et andet program har ændret »%1«.</translation>
    </message>
    <message>
        <source>You have no unsaved changes.</source>
        <translation>Du har ingen ændringer, der ikke er gemt.</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>Åbn den igen</translation>
    </message>
    <message>
        <source>Keep what I see</source>
        <translation>Behold det, jeg ser</translation>
    </message>
    <message>
        <source>Flight under way</source>
        <translation>Flyvning i gang</translation>
    </message>
    <message>
        <source>A flight has started in the meantime. End it?</source>
        <translation>En flyvning er begyndt i mellemtiden. Skal den afsluttes?</translation>
    </message>
    <message>
        <source>A flight is in progress. End it?</source>
        <translation>En flyvning er i gang. Skal den afsluttes?</translation>
    </message>
    <message>
        <source>The scenario can only be changed when no flight is in progress. The flight stays in the list of runs.</source>
        <translation>Scenariet kan kun ændres, når ingen flyvning er i gang. Flyvningen bliver stående på listen over flyvninger.</translation>
    </message>
    <message>
        <source>What has been flown so far stays in the list of runs.</source>
        <translation>Det, der er fløjet indtil nu, bliver stående på listen over flyvninger.</translation>
    </message>
    <message>
        <source>End the flight</source>
        <translation>Afslut flyvningen</translation>
    </message>
    <message>
        <source>Continue flight</source>
        <translation>Fortsæt flyvningen</translation>
    </message>
    <message>
        <source>Unsaved run</source>
        <translation>Ikke gemt flyvning</translation>
    </message>
    <message>
        <source>Save the run?</source>
        <translation>Gem flyvningen?</translation>
    </message>
    <message>
        <source>The flight will be lost if you don&apos;t save it.</source>
        <translation>Flyvningen går tabt, hvis du ikke gemmer den.</translation>
    </message>
    <message>
        <source>Save the run before the flight ends?</source>
        <translation>Gem flyvningen, før den afsluttes?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Forkast</translation>
    </message>
    <message>
        <source>&amp;Save run...</source>
        <translation>&amp;Gem flyvning...</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annullér</translation>
    </message>
    <message>
        <source>Remove icebergs</source>
        <translation>Fjern isbjerge</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n icebergs from this run?</source>
        <translation>
            <numerusform>Fjern %n isbjerg fra denne flyvning?</numerusform>
            <numerusform>Fjern %n isbjerge fra denne flyvning?</numerusform>
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
        <translation>Grader fra retvisende til magnetisk nord, positivt mod øst, negativt mod vest:</translation>
    </message>
    <message>
        <source>%1: the UAV will not visit them any more.</source>
        <translation>%1: dronen besøger dem ikke mere.</translation>
    </message>
    <message>
        <source>Undo in flight</source>
        <translation>Fortryd under flyvning</translation>
    </message>
    <message>
        <source>Undo &quot;%1&quot; of %2?</source>
        <translation>Fortryd »%1« fra %2?</translation>
    </message>
    <message>
        <source>The flight goes back to that time and continues without the change. The flight since then is discarded; &quot;Restore&quot; brings it back.</source>
        <translation>Flyvningen går tilbage til det tidspunkt og fortsætter uden ændringen. Flyvningen siden da kasseres; »Hent flyvningen tilbage« gendanner den.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Fortryd</translation>
    </message>
</context>
<context>
    <name>DriftArrow</name>
    <message>
        <source>The arrow shows the drift over %1. Shift snaps to steps of %2°; Esc cancels.</source>
        <translation>Pilen viser driften over %1. Skift går i trin på %2°; Esc annullerer.</translation>
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
        <translation>Filen findes ikke. Kontrollér navnet og mappen.</translation>
    </message>
    <message>
        <source>The file cannot be read. Check that it is a file and that you have permission to read it.</source>
        <translation>Filen kan ikke læses. Kontrollér, at det er en fil, og at du har tilladelse til at læse den.</translation>
    </message>
    <message>
        <source>The file cannot be written. Check that the folder exists, that you have permission to write there and that the disk is not full.</source>
        <translation>Filen kan ikke skrives. Kontrollér, at mappen findes, at du har tilladelse til at skrive i den, og at disken ikke er fuld.</translation>
    </message>
    <message>
        <source>The file is too large for a Bergwatch file.</source>
        <translation>Filen er for stor til at være en fil fra Bergwatch.</translation>
    </message>
    <message>
        <source>This is not a Bergwatch file, or it is damaged at the place named.</source>
        <translation>Dette er ikke en Bergwatch-fil, eller den er beskadiget på det angivne sted.</translation>
    </message>
    <message>
        <source>This file is of a different type than expected here.</source>
        <translation>Filen er af en anden type, end der ventes her.</translation>
    </message>
    <message>
        <source>The file was made by a newer version of Bergwatch. Update the program to open it.</source>
        <translation>Filen er lavet med en nyere version af Bergwatch. Opdatér programmet for at åbne den.</translation>
    </message>
    <message>
        <source>These values are not valid. Correct them and try again.</source>
        <translation>Værdierne er ugyldige. Ret dem, og prøv igen.</translation>
    </message>
    <message>
        <source>This version of Bergwatch cannot do that.</source>
        <translation>Denne version af Bergwatch kan ikke gøre det.</translation>
    </message>
    <message>
        <source>The planner failed. Choose another solver.</source>
        <translation>Planlæggeren fejlede. Vælg en anden løser.</translation>
    </message>
    <message>
        <source>The replay of the run differs from the recording. The file may come from another version of Bergwatch.</source>
        <translation>Afspilningen af flyvningen afviger fra optagelsen. Filen kan komme fra en anden version af Bergwatch.</translation>
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
        <translation>Filen er for stor til at blive importeret. Del den, eller udelad det, der ikke er brug for.</translation>
    </message>
    <message>
        <source>The file is broken. Correct it at the place named, or export it again.</source>
        <translation>Filen er beskadiget. Ret den på det angivne sted, eller eksportér den igen.</translation>
    </message>
    <message>
        <source>Bergwatch does not recognise this file. If it is a table, choose its latitude and longitude columns below.</source>
        <translation>Bergwatch genkender ikke denne fil. Hvis det er en tabel, så vælg kolonnerne for bredde og længde nedenfor.</translation>
    </message>
    <message>
        <source>Nothing of it can be used like this.</source>
        <translation>Intet i den kan bruges, som det er.</translation>
    </message>
</context>
<context>
    <name>EventText</name>
    <message>
        <source>Planned: next %1</source>
        <translation>Planlagt: næste er %1</translation>
    </message>
    <message>
        <source>%1 reached</source>
        <translation>%1 nået</translation>
    </message>
    <message>
        <source>%1 in view</source>
        <translation>%1 er i synsfeltet</translation>
    </message>
    <message>
        <source>%1 appeared</source>
        <translation>%1 dukkede op</translation>
    </message>
    <message>
        <source>take-off</source>
        <translation>start</translation>
    </message>
    <message>
        <source>iceberg reached</source>
        <translation>isbjerg nået</translation>
    </message>
    <message>
        <source>iceberg out of view again</source>
        <translation>isbjerg ude af syne igen</translation>
    </message>
    <message>
        <source>new iceberg</source>
        <translation>nyt isbjerg</translation>
    </message>
    <message>
        <source>changed in flight</source>
        <translation>ændret under flyvning</translation>
    </message>
    <message>
        <source>%1 reported seen</source>
        <translation>%1 meldt set</translation>
    </message>
    <message>
        <source>iceberg sighted en route</source>
        <translation>isbjerg set undervejs</translation>
    </message>
    <message>
        <source>sighting overdue</source>
        <translation>observation udeblevet</translation>
    </message>
    <message>
        <source>The planner failed: continuing with the previous plan</source>
        <translation>Planlæggeren fejlede: fortsætter med den forrige plan</translation>
    </message>
    <message>
        <source>Wind changed</source>
        <translation>Vinden ændret</translation>
    </message>
    <message>
        <source>The protected asset has changed</source>
        <translation>Det beskyttede objekt er ændret</translation>
    </message>
    <message>
        <source>%1 has left the area</source>
        <translation>%1 har forladt området</translation>
    </message>
    <message>
        <source>%1 is lost: not where it should be</source>
        <translation>%1 er mistet: ikke der, hvor det skulle være</translation>
    </message>
    <message>
        <source>%1 found again</source>
        <translation>%1 fundet igen</translation>
    </message>
    <message>
        <source>Search for %1 given up</source>
        <translation>Eftersøgningen af %1 er opgivet</translation>
    </message>
    <message>
        <source>Returning home</source>
        <translation>På vej hjem</translation>
    </message>
    <message>
        <source>Landed</source>
        <translation>Landet</translation>
    </message>
    <message>
        <source>Took off</source>
        <translation>Startet</translation>
    </message>
    <message>
        <source>iceberg left the area</source>
        <translation>isbjerg forlod området</translation>
    </message>
    <message>
        <source>iceberg lost</source>
        <translation>isbjerg mistet</translation>
    </message>
    <message>
        <source>lost iceberg found</source>
        <translation>mistet isbjerg fundet</translation>
    </message>
    <message>
        <source>search given up</source>
        <translation>eftersøgning opgivet</translation>
    </message>
    <message>
        <source>next sortie</source>
        <translation>næste togt</translation>
    </message>
    <message>
        <source>Any UAV may visit %1</source>
        <translation>Enhver drone må besøge %1</translation>
    </message>
    <message>
        <source>%1 and %2 are %3 apart</source>
        <translation>%1 og %2 er %3 fra hinanden</translation>
    </message>
    <message>
        <source>%1 has nothing to visit: circling</source>
        <translation>%1 har intet at besøge: kredser</translation>
    </message>
    <message>
        <source>%1 flies to %2 next</source>
        <translation>%1 flyver som det næste til %2</translation>
    </message>
    <message>
        <source>seen by another UAV</source>
        <translation>set af en anden drone</translation>
    </message>
    <message>
        <source>another UAV needed a plan</source>
        <translation>en anden drone havde brug for en plan</translation>
    </message>
    <message>
        <source>Outside the geofence</source>
        <translation>Uden for geohegnet</translation>
    </message>
    <message>
        <source>Back inside the geofence</source>
        <translation>Inden for geohegnet igen</translation>
    </message>
    <message>
        <source>Told to resume</source>
        <translation>Fik besked på at fortsætte</translation>
    </message>
    <message>
        <source>Told to return now</source>
        <translation>Fik besked på at vende hjem nu</translation>
    </message>
    <message>
        <source>Told to hold here</source>
        <translation>Fik besked på at vente her</translation>
    </message>
    <message>
        <source>Home cannot be reached in time</source>
        <translation>Hjemmepunktet kan ikke nås i tide</translation>
    </message>
    <message>
        <source>end of hold</source>
        <translation>slut på ventetid</translation>
    </message>
    <message>
        <source>Planned from now on by: %2</source>
        <translation>Planlægges fra nu af med: %2</translation>
    </message>
    <message>
        <source>%1 removed</source>
        <translation>%1 fjernet</translation>
    </message>
    <message>
        <source>%1 added</source>
        <translation>%1 tilføjet</translation>
    </message>
    <message>
        <source>Close to another UAV: %3</source>
        <translation>Tæt på en anden drone: %3</translation>
    </message>
    <message>
        <source>Previous plan kept: next %1</source>
        <translation>Forrige plan beholdt: næste er %1</translation>
    </message>
    <message>
        <source>%1 will enter the inner ring in %4</source>
        <translation>%1 vil komme ind i den indre ring om %4</translation>
    </message>
    <message>
        <source>%1 assigned to %2</source>
        <translation>%1 tildelt %2</translation>
    </message>
    <message>
        <source>Nothing to visit now: circling</source>
        <translation>Intet at besøge nu: kredser</translation>
    </message>
</context>
<context>
    <name>ExportPicture</name>
    <message>
        <source>No icebergs</source>
        <translation>Ingen isbjerge</translation>
    </message>
</context>
<context>
    <name>ExportText</name>
    <message>
        <source>Mission plan</source>
        <translation>Missionsplan</translation>
    </message>
    <message>
        <source>Waypoint list</source>
        <translation>Liste over rutepunkter</translation>
    </message>
    <message>
        <source>QGIS and other map programs</source>
        <translation>QGIS og andre kortprogrammer</translation>
    </message>
    <message>
        <source>Icebergs, UAVs, paths and area as features with their numbers, longitude and latitude of WGS 84.</source>
        <translation>Isbjerge, droner, baner og område som objekter med deres tal, længde og bredde i WGS 84.</translation>
    </message>
    <message>
        <source>Chart plotters, Garmin</source>
        <translation>Kortplottere, Garmin</translation>
    </message>
    <message>
        <source>Icebergs as waypoints, the order as a route, a path or what was flown as a track with times.</source>
        <translation>Isbjerge som rutepunkter, rækkefølgen som rute, en bane eller det fløjne som spor med tider.</translation>
    </message>
    <message>
        <source>UAVs and icebergs moving in time over the globe, with paths, area and asset.</source>
        <translation>Droner og isbjerge, der bevæger sig i tid over kloden, med baner, område og objekt.</translation>
    </message>
    <message>
        <source>The same as KML, packed into one small file.</source>
        <translation>Det samme som KML, pakket i én lille fil.</translation>
    </message>
    <message>
        <source>Paths in the colours of the UAVs, with times if the scenario has a start; icebergs with their numbers.</source>
        <translation>Baner i dronernes farver, med tider, hvis scenariet har et starttidspunkt; isbjerge med deres tal.</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Usikkerhed</translation>
    </message>
    <message>
        <source>Spreadsheets</source>
        <translation>Regneark</translation>
    </message>
    <message>
        <source>Table with the uncertainty of every iceberg over the time of the flight.</source>
        <translation>Tabel med hvert isbjergs usikkerhed over flyvningens tid.</translation>
    </message>
    <message>
        <source>Decisions</source>
        <translation>Beslutninger</translation>
    </message>
    <message>
        <source>Table with plans, visits and what else happened in the flight.</source>
        <translation>Tabel med planer, besøg og andre hændelser under flyvningen.</translation>
    </message>
    <message>
        <source>Zeta</source>
        <translation>Zeta-kurve</translation>
    </message>
    <message>
        <source>Table with zeta over the time of the flight.</source>
        <translation>Tabel med zeta over flyvningens tid.</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bane</translation>
    </message>
    <message>
        <source>Table of the order with legs, coordinates and arrivals; of a path or what was flown one row for each point.</source>
        <translation>Tabel over rækkefølgen med etaper, koordinater og ankomster; for en bane eller det fløjne én række pr. punkt.</translation>
    </message>
    <message>
        <source>Autopilots</source>
        <translation>Autopiloter</translation>
    </message>
    <message>
        <source>Maps and globes</source>
        <translation>Kort og glober</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabeller</translation>
    </message>
    <message>
        <source>Good to know</source>
        <translation>Værd at vide</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Ændret</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Udeladt</translation>
    </message>
    <message>
        <source>Map as %1</source>
        <translation>Kort som %1</translation>
    </message>
    <message>
        <source>Charts as %1</source>
        <translation>Diagrammer som %1</translation>
    </message>
    <message>
        <source>Flight brief</source>
        <translation>Flyvebriefing</translation>
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
        <translation>Dokumenter og meddelelser</translation>
    </message>
    <message>
        <source>The map with icebergs, paths and area, light, with scale and legend.</source>
        <translation>Kortet med isbjerge, baner og område, lyst, med målestok og signaturforklaring.</translation>
    </message>
    <message>
        <source>Zeta and the uncertainty of every iceberg over the time of the flight.</source>
        <translation>Zeta og hvert isbjergs usikkerhed over flyvningens tid.</translation>
    </message>
    <message>
        <source>Pictures and print</source>
        <translation>Billeder og udskrift</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Højde</translation>
    </message>
    <message>
        <source>Airspeed</source>
        <translation>Flyvefart</translation>
    </message>
    <message>
        <source>Acceptance radius</source>
        <translation>Acceptradius</translation>
    </message>
    <message>
        <source>Loiter turns</source>
        <translation>Kredsninger</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Hvad</translation>
    </message>
    <message>
        <source>Flight log</source>
        <translation>Flyvelog</translation>
    </message>
    <message>
        <source>Browsers</source>
        <translation>Browsere</translation>
    </message>
    <message>
        <source>Page with planned and flown, zeta against prediction, all sightings and deviations.</source>
        <translation>Side med planlagt og fløjet, zeta mod forudsigelsen, alle observationer og afvigelser.</translation>
    </message>
    <message>
        <source>Two or three pages: planned and flown, map, zeta against prediction, sightings, deviations.</source>
        <translation>To eller tre sider: planlagt og fløjet, kort, zeta mod forudsigelsen, observationer, afvigelser.</translation>
    </message>
    <message>
        <source>Return home</source>
        <translation>Flyv hjem</translation>
    </message>
    <message>
        <source>Mission items as QGC WPL 110, the first row home, for Mission Planner and MAVProxy. No geofence. One file per UAV.</source>
        <translation>Missionselementer som QGC WPL 110 til Mission Planner og MAVProxy; første række er hjemmepunktet. Uden geohegn. Én fil pr. drone.</translation>
    </message>
    <message>
        <source>To print and carry: map, order with coordinates, legs and times, wind, warnings; plus a second page if there is an operation volume.</source>
        <translation>Til at udskrive og tage med: kort, rækkefølge med koordinater, etaper og tider, vind, advarsler; plus en anden side, hvis der er et operationsvolumen.</translation>
    </message>
    <message>
        <source>Mission items from take-off to landing for the autopilot of the UAV, the geofence and a rally point at home. Also read by Mission Planner and MAVSDK. One file per UAV.</source>
        <translation>Missionen fra start til landing for dronens autopilot, geohegnet og et samlingspunkt ved hjemmepunktet. Filen læses også af Mission Planner og MAVSDK. Én fil pr. drone.</translation>
    </message>
    <message>
        <source>Check before the flight</source>
        <translation>Kontrollér før flyvningen</translation>
    </message>
    <message>
        <source>Sightings</source>
        <translation>Observationer</translation>
    </message>
    <message>
        <source>Ice services</source>
        <translation>Istjenester</translation>
    </message>
    <message>
        <source>Table of the sightings of the flight in the columns of the International Ice Patrol.</source>
        <translation>Tabel over flyvningens observationer i kolonnerne fra International Ice Patrol.</translation>
    </message>
    <message>
        <source>ArcGIS and other GIS</source>
        <translation>ArcGIS og andre GIS</translation>
    </message>
    <message>
        <source>Everything on the map as zipped Shapefiles of points, lines and areas. Needs ogr2ogr (package gdal-bin).</source>
        <translation>Alt på kortet som pakkede Shapefiler med punkter, linjer og områder. Kræver ogr2ogr (pakken gdal-bin).</translation>
    </message>
    <message>
        <source>QGIS and other GIS</source>
        <translation>QGIS og andre GIS</translation>
    </message>
    <message>
        <source>Everything on the map in one layer. Needs ogr2ogr (package gdal-bin).</source>
        <translation>Alt på kortet i ét lag. Kræver ogr2ogr (pakken gdal-bin).</translation>
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
        <translation>En tegning i meter: steder, linjer og omrids i lag, uden navne og tal. Kræver ogr2ogr (pakken gdal-bin).</translation>
    </message>
</context>
<context>
    <name>FieldNames</name>
    <message>
        <source>Time of the recorded track</source>
        <translation>Tidspunkt i det registrerede spor</translation>
    </message>
    <message>
        <source>Place of the recorded track</source>
        <translation>Sted i det registrerede spor</translation>
    </message>
    <message>
        <source>South</source>
        <translation>Syd</translation>
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
        <translation>Starttidspunkt</translation>
    </message>
    <message>
        <source>Not before</source>
        <translation>Ikke før</translation>
    </message>
    <message>
        <source>Not after</source>
        <translation>Ikke efter</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origo</translation>
    </message>
    <message>
        <source>Number of icebergs</source>
        <translation>Antal isbjerge</translation>
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
        <translation>Højeste fart</translation>
    </message>
    <message>
        <source>Drift direction, clockwise from north</source>
        <translation>Driftens retning, med uret fra nord</translation>
    </message>
    <message>
        <source>Spread to either side</source>
        <translation>Spredning til hver side</translation>
    </message>
    <message>
        <source>Smallest σ at the start</source>
        <translation>Mindste σ ved starten</translation>
    </message>
    <message>
        <source>Largest σ at the start</source>
        <translation>Største σ ved starten</translation>
    </message>
    <message>
        <source>Growth of σ</source>
        <translation>Vækst i σ</translation>
    </message>
    <message>
        <source>Minimum distance between two icebergs</source>
        <translation>Mindste afstand mellem to isbjerge</translation>
    </message>
</context>
<context>
    <name>FileNames</name>
    <message>
        <source>Untitled</source>
        <translation>Uden navn</translation>
    </message>
</context>
<context>
    <name>FlightBrief</name>
    <message>
        <source>Times count from the start of the run</source>
        <translation>Tider regnes fra flyvningens start</translation>
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
        <translation>%1 %2 mod %3</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 af %2</translation>
    </message>
    <message>
        <source>Wind, true</source>
        <translation>Vind, retvisende</translation>
    </message>
    <message>
        <source>Current, true</source>
        <translation>Strøm, retvisende</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Time of flight</source>
        <translation>Flyvetid</translation>
    </message>
    <message>
        <source>End, UTC</source>
        <translation>Slut, UTC</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Slut</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Isbjerge</translation>
    </message>
    <message>
        <source>Planned by</source>
        <translation>Planlagt efter</translation>
    </message>
    <message>
        <source>Last plan</source>
        <translation>Seneste plan</translation>
    </message>
    <message>
        <source>Order of visits</source>
        <translation>Besøgsrækkefølge</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Højde</translation>
    </message>
    <message>
        <source>Airspeed</source>
        <translation>Flyvefart</translation>
    </message>
    <message>
        <source>Turn radius</source>
        <translation>Drejeradius</translation>
    </message>
    <message>
        <source>Acceptance radius</source>
        <translation>Acceptradius</translation>
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
        <translation>Kredsninger</translation>
    </message>
    <message>
        <source>Endurance left</source>
        <translation>Resterende udholdenhed</translation>
    </message>
    <message>
        <source>Endurance</source>
        <translation>Udholdenhed</translation>
    </message>
    <message>
        <source>Positions are WGS 84. Icebergs drift: each is listed where it was when reached. Courses and distances are over ground.</source>
        <translation>Positionerne er i WGS 84. Isbjerge driver: hvert er angivet, hvor det var, da det blev nået. Kurser og distancer er over grunden.</translation>
    </message>
    <message>
        <source>Positions are WGS 84. Icebergs drift: each is listed where it is expected at arrival. Courses and distances are over ground.</source>
        <translation>Positionerne er i WGS 84. Isbjerge driver: hvert er angivet, hvor det ventes ved ankomsten. Kurser og distancer er over grunden.</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>Origo %1</translation>
    </message>
    <message>
        <source>Flight brief: %1</source>
        <translation>Flyvebriefing: %1</translation>
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
        <translation>Noter</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>End of track</source>
        <translation>Sporets slutning</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isbjerg</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Længde</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>true</source>
        <translation>retv.</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Etape</translation>
    </message>
    <message>
        <source>Reached</source>
        <translation>Nået</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Ankomst</translation>
    </message>
    <message>
        <source>σ now</source>
        <translation>σ nu</translation>
    </message>
    <message>
        <source>and %1 more; export CSV for the whole list</source>
        <translation>og %1 til; eksportér CSV for hele listen</translation>
    </message>
    <message>
        <source>and %1 more UAVs; export CSV for the whole list</source>
        <translation>og %1 droner til; eksportér CSV for hele listen</translation>
    </message>
    <message>
        <source>Lost, not found where expected (%1): %2</source>
        <translation>Mistet, ikke fundet, hvor de ventedes (%1): %2</translation>
    </message>
    <message>
        <source>Search given up (%1): %2</source>
        <translation>Opgivet efter en eftersøgning (%1): %2</translation>
    </message>
    <message>
        <source>Not visited (%1): %2</source>
        <translation>Ikke fløjet til (%1): %2</translation>
    </message>
    <message>
        <source>Not in the order (%1): %2</source>
        <translation>Ikke i rækkefølgen (%1): %2</translation>
    </message>
    <message>
        <source>The order is not proven optimal: %1.</source>
        <translation>Rækkefølgen er ikke bevist optimal: %1.</translation>
    </message>
    <message>
        <source>Geofence in force: stay inside the area.</source>
        <translation>Geohegnet gælder: bliv inden for området.</translation>
    </message>
    <message>
        <source>UAVs share an altitude layer: keep them %1 apart. They do not avoid each other.</source>
        <translation>Droner deler et højdelag: hold dem %1 fra hinanden. De undviger ikke hinanden.</translation>
    </message>
    <message>
        <source>Nothing to visit</source>
        <translation>Intet at besøge</translation>
    </message>
    <message>
        <source>Solver limit reached; previous plan kept</source>
        <translation>Løserens grænse nået; forrige plan beholdt</translation>
    </message>
    <message>
        <source>Chosen one iceberg at a time</source>
        <translation>Valgt ét isbjerg ad gangen</translation>
    </message>
    <message>
        <source>Proven optimal</source>
        <translation>Bevist optimal</translation>
    </message>
    <message>
        <source>Within %1 % of optimal</source>
        <translation>Inden for %1 % af optimum</translation>
    </message>
    <message>
        <source>Best order found</source>
        <translation>Bedste fundne rækkefølge</translation>
    </message>
    <message>
        <source>Not planned by a solver</source>
        <translation>Ikke planlagt af en løser</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>Fejl: %1</translation>
    </message>
    <message>
        <source>The planner reached its limit without an order. The UAV flies the rest of the previous plan, or to the nearest iceberg.</source>
        <translation>Planlæggeren nåede sin grænse uden en rækkefølge. Dronen flyver resten af den forrige plan eller til det nærmeste isbjerg.</translation>
    </message>
    <message>
        <source>Nothing to visit for %1</source>
        <translation>Intet at besøge for %1</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Varighed</translation>
    </message>
    <message>
        <source>%1 (%2): %3</source>
        <translation>%1 (%2): %3</translation>
    </message>
    <message>
        <source>Times do not include the loiter turns, which add %1 at each iceberg, %2 in total.</source>
        <translation>Tiderne omfatter ikke kredsningerne, som lægger %1 til ved hvert isbjerg, %2 i alt.</translation>
    </message>
    <message>
        <source>With the loiter turns the endurance is too short: %1</source>
        <translation>Med kredsningerne er udholdenheden for kort: %1</translation>
    </message>
    <message>
        <source>Reserve</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>No-fly area: %1.</source>
        <translation>Flyveforbudsområde: %1.</translation>
    </message>
    <message>
        <source>No-fly area %1: %2.</source>
        <translation>Flyveforbudsområde %1: %2.</translation>
    </message>
    <message>
        <source>Stand-off from the asset: %1, %2.</source>
        <translation>Sikkerhedsafstand til objektet: %1, %2.</translation>
    </message>
    <message>
        <source>Climb and landing</source>
        <translation>Stigning og landing</translation>
    </message>
    <message>
        <source>Recovery slot</source>
        <translation>Landingsvindue</translation>
    </message>
    <message>
        <source>Out of radio range</source>
        <translation>Uden for radiorækkevidde</translation>
    </message>
    <message>
        <source>Probability of being in view on arrival: %1</source>
        <translation>Sandsynlighed for at være i synsfeltet ved ankomsten: %1</translation>
    </message>
    <message>
        <source>Straight legs that leave the geofence or cross a no-fly area: %1. The UAV flies around.</source>
        <translation>Lige etaper, der forlader geohegnet eller krydser et flyveforbudsområde: %1. Dronen flyver udenom.</translation>
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
        <translation>ikke denne dag</translation>
    </message>
    <message>
        <source>Sun up, UTC</source>
        <translation>Sol oppe, UTC</translation>
    </message>
    <message>
        <source>Civil twilight, UTC</source>
        <translation>Borgerligt tusmørke, UTC</translation>
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
        <translation>Dette togt</translation>
    </message>
    <message>
        <source>Home, above the reserve</source>
        <translation>Hjemme, over reserven</translation>
    </message>
    <message>
        <source>In 1 flight of 20</source>
        <translation>I 1 ud af 20 flyvninger</translation>
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
        <translation>Mission til autopiloten: %1.</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <comment>speed, direction</comment>
        <translation>%1 fra %2</translation>
    </message>
    <message>
        <source>%1 towards %2</source>
        <comment>speed, direction</comment>
        <translation>%1 mod %2</translation>
    </message>
    <message>
        <source>Time, UTC</source>
        <translation>Tid, UTC</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Vindstød</translation>
    </message>
    <message>
        <source>The forecast has no wind between %1 and %2: the plan uses the constant wind of the scenario.</source>
        <translation>Prognosen har ingen vind mellem %1 og %2: planen bruger scenariets faste vind.</translation>
    </message>
    <message>
        <source>The forecast was issued %1 h before the flight: look for a newer one.</source>
        <translation>Prognosen blev udstedt %1 t før flyvningen: se efter en nyere.</translation>
    </message>
    <message>
        <source>Weather and limits</source>
        <translation>Vejr og grænser</translation>
    </message>
</context>
<context>
    <name>FlightDrag</name>
    <message>
        <source>Change wind</source>
        <translation>Ændr vind</translation>
    </message>
    <message>
        <source>Release to apply this wind from now on. Esc cancels.</source>
        <translation>Slip for at bruge denne vind fra nu af. Esc annullerer.</translation>
    </message>
    <message>
        <source>Release to keep this wind. Shift snaps to steps of %1°; Esc cancels.</source>
        <translation>Slip for at beholde denne vind. Skift går i trin på %1°; Esc annullerer.</translation>
    </message>
    <message>
        <source>Release to move the asset here now. Esc cancels.</source>
        <translation>Slip for at flytte objektet hertil nu. Esc annullerer.</translation>
    </message>
    <message>
        <source>The UAV makes little headway in this wind. Esc cancels.</source>
        <translation>Dronen kommer næsten ikke frem i denne vind. Esc annullerer.</translation>
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
        <translation>Eftersøger %1</translation>
    </message>
    <message>
        <source>On the ground, takes off in %1</source>
        <translation>På jorden, starter om %1</translation>
    </message>
    <message>
        <source>It runs again when the next plan is needed.</source>
        <translation>Den kører igen, når den næste plan er nødvendig.</translation>
    </message>
    <message>
        <source>The wind changed in flight.</source>
        <translation>Vinden ændrede sig under flyvningen.</translation>
    </message>
    <message>
        <source>They fly at about the same altitude. The required separation is %1.</source>
        <translation>De flyver i omtrent samme højde. Den krævede adskillelse er %1.</translation>
    </message>
    <message>
        <source>Wind above its limit: %1, limit %2</source>
        <translation>Vinden er over grænsen: %1, grænse %2</translation>
    </message>
    <message>
        <source>Holding as ordered</source>
        <translation>Venter som beordret</translation>
    </message>
    <message>
        <source>On the ground. Choose Resume to continue</source>
        <translation>På jorden. Vælg Fortsæt for at flyve videre</translation>
    </message>
    <message>
        <source>%1 is lost</source>
        <translation>%1 er mistet</translation>
    </message>
    <message>
        <source>%1 is lost; the search was abandoned</source>
        <translation>%1 er mistet; eftersøgningen blev opgivet</translation>
    </message>
    <message>
        <source>It was not in view where it was expected.</source>
        <translation>Det var ikke i syne, hvor det ventedes.</translation>
    </message>
    <message>
        <source>Makes little headway: wind %1, airspeed %2</source>
        <translation>Kommer næsten ikke frem: vind %1, flyvefart %2</translation>
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
        <translation>vindstød</translation>
    </message>
    <message>
        <source>air temperature</source>
        <translation>lufttemperatur</translation>
    </message>
    <message>
        <source>dew point</source>
        <translation>dugpunkt</translation>
    </message>
    <message>
        <source>fog</source>
        <translation>tåge</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>sigtbarhed</translation>
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
        <translation>ukendt kilde</translation>
    </message>
    <message>
        <source>time of issue unknown</source>
        <translation>udstedelsestid ukendt</translation>
    </message>
    <message>
        <source>issued %1</source>
        <translation>udstedt %1</translation>
    </message>
    <message>
        <source>issued %1, %2 after the start</source>
        <translation>udstedt %1, %2 efter starten</translation>
    </message>
    <message>
        <source>issued %1, %2 before the start</source>
        <translation>udstedt %1, %2 før starten</translation>
    </message>
    <message>
        <source>Forecast of %1, %2</source>
        <comment>source, time of issue</comment>
        <translation>Prognose fra %1, %2</translation>
    </message>
</context>
<context>
    <name>HandleDrag</name>
    <message numerus="yes">
        <source>Change drift of %n icebergs</source>
        <translation>
            <numerusform>Ændr drift</numerusform>
            <numerusform>Ændr drift for %n isbjerge</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn UAV</source>
        <translation>Drej drone</translation>
    </message>
    <message>
        <source>Release to keep this heading. Shift snaps to steps of %1°; Esc cancels.</source>
        <translation>Slip for at beholde denne kurs. Skift går i trin på %1°; Esc annullerer.</translation>
    </message>
    <message>
        <source>Add corner</source>
        <translation>Tilføj hjørne</translation>
    </message>
    <message>
        <source>Move corner</source>
        <translation>Flyt hjørne</translation>
    </message>
    <message>
        <source>Release to place the corner here. Esc cancels.</source>
        <translation>Slip for at sætte hjørnet her. Esc annullerer.</translation>
    </message>
    <message numerus="yes">
        <source>Drag to give all %n selected icebergs the same drift.</source>
        <translation>
            <numerusform>Træk for at give %n valgt isbjerg denne drift.</numerusform>
            <numerusform>Træk for at give alle %n valgte isbjerge samme drift.</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag to set the drift of the iceberg.</source>
        <translation>Træk for at sætte isbjergets drift.</translation>
    </message>
    <message>
        <source>Drag to turn the UAV.</source>
        <translation>Træk for at dreje dronen.</translation>
    </message>
    <message>
        <source>Drag to move the corner. To remove it, click it and press Del.</source>
        <translation>Træk for at flytte hjørnet. Klik på det, og tryk på Del for at fjerne det.</translation>
    </message>
    <message>
        <source>Drag to add a corner here.</source>
        <translation>Træk for at tilføje et hjørne her.</translation>
    </message>
    <message>
        <source>An area needs at least three corners. Delete the whole area instead.</source>
        <translation>Et område skal have mindst tre hjørner. Slet hele området i stedet.</translation>
    </message>
    <message>
        <source>Without this corner the outline would cross itself.</source>
        <translation>Uden dette hjørne ville omridset krydse sig selv.</translation>
    </message>
    <message>
        <source>Remove corner</source>
        <translation>Fjern hjørne</translation>
    </message>
    <message>
        <source>The outline would cross itself here.</source>
        <translation>Omridset ville krydse sig selv her.</translation>
    </message>
    <message>
        <source>Drag to change the wind from now on. In flight this cannot be undone.</source>
        <translation>Træk for at ændre vinden fra nu af. Under flyvning kan det ikke fortrydes.</translation>
    </message>
    <message>
        <source>Drag to set the wind. The arrow points downwind.</source>
        <translation>Træk for at sætte vinden. Pilen peger derhen, hvor vinden blæser.</translation>
    </message>
</context>
<context>
    <name>IcebergClipboard</name>
    <message>
        <source>The clipboard</source>
        <translation>Udklipsholderen</translation>
    </message>
</context>
<context>
    <name>IcebergColumnText</name>
    <message>
        <source>Iceberg</source>
        <translation>Isbjerg</translation>
    </message>
    <message>
        <source>Name of the iceberg, or its id if it has none</source>
        <translation>Isbjergets navn, eller dets id, hvis det ikke har noget navn</translation>
    </message>
    <message>
        <source>Uncertainty of the position now; the bar is on the scale of the map</source>
        <translation>Positionens usikkerhed nu; bjælken følger skalaen på kortet</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Tilstand</translation>
    </message>
    <message>
        <source>In view, next target, or its place in the visiting order</source>
        <translation>I synsfeltet, næste mål eller pladsen i besøgsrækkefølgen</translation>
    </message>
    <message>
        <source>Unseen for</source>
        <translation>Uset i</translation>
    </message>
    <message>
        <source>Unseen for, s</source>
        <translation>Uset i, s</translation>
    </message>
    <message>
        <source>Time since it was last in view, or since it became known</source>
        <translation>Tid, siden det sidst var i synsfeltet, eller siden det blev kendt</translation>
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
        <translation>Tid, til dronen er fremme, efter den nuværende plan</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besøg</translation>
    </message>
    <message>
        <source>Number of times it was reached as the target</source>
        <translation>Antal gange, det blev nået som mål</translation>
    </message>
    <message>
        <source>Position east of the scenario&apos;s origin: before take-off at the start, in flight the estimate</source>
        <translation>Position øst for scenariets origo: før start udgangspositionen, under flyvning estimatet</translation>
    </message>
    <message>
        <source>Position north of the scenario&apos;s origin: before take-off at the start, in flight the estimate</source>
        <translation>Position nord for scenariets origo: før start udgangspositionen, under flyvning estimatet</translation>
    </message>
    <message>
        <source>Known drift; in flight it includes the current</source>
        <translation>Kendt drift; under flyvning er strømmen medregnet</translation>
    </message>
    <message>
        <source>Direction, °</source>
        <translation>Retning, °</translation>
    </message>
    <message>
        <source>Drift direction, degrees clockwise from north</source>
        <translation>Driftens retning, i grader med uret fra nord</translation>
    </message>
    <message>
        <source>Last seen, s ago</source>
        <translation>Sidst set, s siden</translation>
    </message>
    <message>
        <source>Appears at, s</source>
        <translation>Dukker op ved, s</translation>
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
        <translation>Nærmeste passage: mindste forudsagte afstand fra objektet inden for den næste time. Et advarselstegn ved navnet betyder, at isbjerget kommer ind i den indre ring</translation>
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
        <translation>Tid til nærmeste passage</translation>
    </message>
    <message>
        <source>UAV that plans to visit it</source>
        <translation>Den drone, der planlægger at besøge det</translation>
    </message>
    <message>
        <source>Position, in flight the estimate. Type or paste any form; a whole coordinate sets both</source>
        <translation>Position, under flyvning estimatet. Skriv eller indsæt enhver form; en hel koordinat udfylder begge</translation>
    </message>
    <message>
        <source>Drift east, %1</source>
        <translation>Drift øst, %1</translation>
    </message>
    <message>
        <source>Known drift to the east, without the current</source>
        <translation>Kendt drift mod øst, uden strømmen</translation>
    </message>
    <message>
        <source>Drift north, %1</source>
        <translation>Drift nord, %1</translation>
    </message>
    <message>
        <source>Known drift to the north, without the current</source>
        <translation>Kendt drift mod nord, uden strømmen</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Længde</translation>
    </message>
    <message>
        <source>95 % radius, m</source>
        <translation>95 %-radius, m</translation>
    </message>
    <message>
        <source>Radius around the present position that contains the iceberg with a probability of 95 %</source>
        <translation>Radius om den nuværende position, der indeholder isbjerget med 95 % sandsynlighed</translation>
    </message>
</context>
<context>
    <name>IcebergPasteText</name>
    <message>
        <source>There is no text to paste.</source>
        <translation>Der er ingen tekst at sætte ind.</translation>
    </message>
    <message>
        <source>Row %1 has a cell &quot;%2&quot; to the right of the last column.</source>
        <translation>Række %1 har en celle »%2« til højre for den sidste kolonne.</translation>
    </message>
    <message>
        <source>Row %1, column &quot;%2&quot;: &quot;%3&quot; is not a number.</source>
        <translation>Række %1, kolonne »%2«: »%3« er ikke et tal.</translation>
    </message>
    <message>
        <source>Row %1, column &quot;%2&quot;: %3 is not from %4 to %5.</source>
        <translation>Række %1, kolonne »%2«: %3 er ikke fra %4 til %5.</translation>
    </message>
    <message>
        <source>Nothing was pasted.</source>
        <translation>Intet blev sat ind.</translation>
    </message>
    <message>
        <source>Row %1, column &quot;%2&quot;, &quot;%3&quot;: %4</source>
        <translation>Række %1, kolonne »%2«, »%3«: %4</translation>
    </message>
    <message>
        <source>Row %1: %2</source>
        <translation>Række %1: %2</translation>
    </message>
    <message>
        <source>Row %1: %2</source>
        <comment>row, fault</comment>
        <translation>Række %1: %2</translation>
    </message>
</context>
<context>
    <name>IcebergRowText</name>
    <message>
        <source>in view</source>
        <translation>i synsfeltet</translation>
    </message>
    <message>
        <source>target</source>
        <translation>mål</translation>
    </message>
    <message>
        <source>number %1 in the order</source>
        <translation>nummer %1 i rækkefølgen</translation>
    </message>
    <message>
        <source>not in the order</source>
        <translation>ikke i rækkefølgen</translation>
    </message>
    <message>
        <source>not appeared yet</source>
        <translation>ikke der endnu</translation>
    </message>
    <message>
        <source>%1 (id %2)</source>
        <translation>%1 (id&apos;et er %2)</translation>
    </message>
    <message>
        <source>Appears at %1</source>
        <translation>Dukker op ved %1</translation>
    </message>
    <message>
        <source>It does not drift.</source>
        <translation>Det ligger stille.</translation>
    </message>
    <message>
        <source>now</source>
        <translation>nu</translation>
    </message>
    <message>
        <source>&gt; 1 h</source>
        <translation>&gt; 1 t</translation>
    </message>
    <message>
        <source>lost, being searched for</source>
        <translation>mistet, eftersøges</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>mistet</translation>
    </message>
    <message>
        <source>search abandoned</source>
        <translation>opgivet</translation>
    </message>
    <message>
        <source>It is still approaching after one hour; this is its distance then.</source>
        <translation>Det nærmer sig stadig efter en time; dette er afstanden da.</translation>
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
        <translation>væk eller fjernet</translation>
    </message>
    <message>
        <source>%1, a standard deviation of %2 m along each axis</source>
        <translation>%1, en standardafvigelse på %2 m langs hver akse</translation>
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
        <translation>Observationer</translation>
    </message>
    <message>
        <source>Last seen, UTC</source>
        <translation>Sidst set, UTC</translation>
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
        <translation>Noter</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linje</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Årsag</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiér</translation>
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
        <translation>Hastighed fra</translation>
    </message>
</context>
<context>
    <name>ImportWords</name>
    <message>
        <source>new</source>
        <translation>nyt</translation>
    </message>
    <message>
        <source>updated</source>
        <translation>opdateret</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>uændret</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>udeladt</translation>
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
        <translation>Længde</translation>
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
        <translation>Usikkerhed σ</translation>
    </message>
    <message>
        <source>Growth q</source>
        <translation>Vækst q</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Udstrækning</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Halv længde</translation>
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
        <translation>Bemærkninger</translation>
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
        <translation>Vilkårlig tabel (CSV)</translation>
    </message>
    <message numerus="yes">
        <source>%n new</source>
        <translation>
            <numerusform>%n nyt</numerusform>
            <numerusform>%n nye</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n updated</source>
        <translation>
            <numerusform>%n opdateret</numerusform>
            <numerusform>%n opdateret</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unchanged</source>
        <translation>
            <numerusform>%n uændret</numerusform>
            <numerusform>%n uændret</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n left out</source>
        <translation>
            <numerusform>%n udeladt</numerusform>
            <numerusform>%n udeladt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings outside the area</source>
        <translation>
            <numerusform>%n observation uden for området</numerusform>
            <numerusform>%n observationer uden for området</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings outside the time</source>
        <translation>
            <numerusform>%n observation uden for tidsrummet</numerusform>
            <numerusform>%n observationer uden for tidsrummet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rows rejected</source>
        <translation>
            <numerusform>%n række afvist</numerusform>
            <numerusform>%n rækker afvist</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing to import</source>
        <translation>Intet at importere</translation>
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
        <translation>GPX (rutepunkter, ruter og spor)</translation>
    </message>
    <message>
        <source>QGroundControl plan</source>
        <translation>QGroundControl-plan</translation>
    </message>
    <message>
        <source>ArduPilot mission (QGC WPL)</source>
        <translation>ArduPilot-mission (QGC WPL)</translation>
    </message>
    <message>
        <source>Line %1: %2 is read month first, which nothing in the file tells. Choose under Dates if the day comes first.</source>
        <translation>Linje %1: %2 læses med måneden først; intet i filen afgør det. Vælg under Datoer, hvis dagen kommer først.</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Kilde</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>ukendt</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>positioner</translation>
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
            <numerusform>%n række ændret</numerusform>
            <numerusform>%n rækker ændret</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings are more than 1000 km from the origin of this scenario. Import them into a new one, or choose others with Inside.</source>
        <translation>
            <numerusform>%n observation er mere end 1000 km fra dette scenaries origo. Importér den til et nyt, eller vælg andre med Inden for.</numerusform>
            <numerusform>%n observationer er mere end 1000 km fra dette scenaries origo. Importér dem til et nyt, eller vælg andre med Inden for.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings are more than 1000 km from the origin, which is in their densest group. Choose others with Inside.</source>
        <translation>
            <numerusform>%n observation er mere end 1000 km fra origo, som ligger i den tætteste gruppe. Vælg andre med Inden for.</numerusform>
            <numerusform>%n observationer er mere end 1000 km fra origo, som ligger i den tætteste gruppe af dem. Vælg andre med Inden for.</numerusform>
        </translation>
    </message>
    <message>
        <source>From the file: %1</source>
        <translation>Fra filen: %1</translation>
    </message>
    <message>
        <source>Radar and AIS of a ship (NMEA log)</source>
        <translation>Radar og AIS på et skib (NMEA-log)</translation>
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
        <translation>Ændr drift</translation>
    </message>
    <message>
        <source>Change uncertainty</source>
        <translation>Ændr usikkerhed</translation>
    </message>
    <message>
        <source>standard deviation %1 m</source>
        <translation>standardafvigelse %1 m</translation>
    </message>
    <message>
        <source> s ago</source>
        <comment>unit after a number</comment>
        <translation> s siden</translation>
    </message>
    <message>
        <source>Change name</source>
        <translation>Ændr navn</translation>
    </message>
    <message>
        <source>Change position</source>
        <translation>Ændr position</translation>
    </message>
    <message>
        <source>stationary</source>
        <translation>ligger stille</translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation>Ændr vind</translation>
    </message>
    <message>
        <source>no wind</source>
        <translation>ingen vind</translation>
    </message>
    <message>
        <source>Change current</source>
        <translation>Ændr strøm</translation>
    </message>
    <message>
        <source>Change velocity of the asset</source>
        <translation>Ændr objektets hastighed</translation>
    </message>
    <message>
        <source>Removes the asset from the map.</source>
        <translation>Fjerner objektet fra kortet.</translation>
    </message>
    <message>
        <source>Remove asset</source>
        <translation>Fjern objekt</translation>
    </message>
    <message>
        <source>Removes the area from the map.</source>
        <translation>Fjerner området fra kortet.</translation>
    </message>
    <message>
        <source>Remove area</source>
        <translation>Fjern område</translation>
    </message>
    <message>
        <source>turns with the UAV</source>
        <translation>drejer med dronen</translation>
    </message>
    <message>
        <source>aligned with north</source>
        <translation>orienteret mod nord</translation>
    </message>
    <message>
        <source>a disk</source>
        <translation>en cirkelskive</translation>
    </message>
    <message>
        <source>by position</source>
        <translation>efter plads</translation>
    </message>
    <message>
        <source>as printed</source>
        <translation>som trykt</translation>
    </message>
    <message>
        <source>reduced</source>
        <translation>reduceret</translation>
    </message>
    <message>
        <source>Change origin</source>
        <translation>Ændr origo</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Længde</translation>
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
        <translation>Registreret spor</translation>
    </message>
    <message>
        <source>Its true motion follows this record, while the estimate follows the drift above.</source>
        <translation>Dets sande bevægelse følger dette spor, mens estimatet følger driften ovenfor.</translation>
    </message>
    <message>
        <source>Clear recorded track</source>
        <translation>Ryd registreret spor</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Ryd</translation>
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
        <translation>%1 mod %2°</translation>
    </message>
    <message>
        <source>Change home</source>
        <translation>Ændr hjemmepunkt</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Hjem</translation>
    </message>
    <message>
        <source>Landing place other than the start.</source>
        <translation>Et andet landingssted end starten.</translation>
    </message>
    <message>
        <source>Land where it starts</source>
        <translation>Land, hvor den starter</translation>
    </message>
    <message>
        <source>%1 from the start</source>
        <translation>%1 fra startstedet</translation>
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
        <translation>Kalmanfilter</translation>
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
        <translation>enhver drone</translation>
    </message>
    <message>
        <source>Move ground station</source>
        <translation>Flyt jordstation</translation>
    </message>
    <message>
        <source>Ground station</source>
        <translation>Jordstation</translation>
    </message>
    <message>
        <source>Position of the radio link to the UAVs. Its range is a ring on the map.</source>
        <translation>Positionen for radioforbindelsen til dronerne. Rækkevidden er en ring på kortet.</translation>
    </message>
    <message>
        <source>Change ground station</source>
        <translation>Ændr jordstation</translation>
    </message>
    <message>
        <source>do not fly</source>
        <translation>flyv ikke</translation>
    </message>
    <message>
        <source>flying allowed</source>
        <translation>flyvning tilladt</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Omrids</translation>
    </message>
    <message>
        <source>Removes the no-fly area from the map.</source>
        <translation>Fjerner flyveforbudsområdet fra kortet.</translation>
    </message>
    <message>
        <source>Remove no-fly area</source>
        <translation>Fjern flyveforbudsområde</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>No-fly area: %1</source>
        <translation>Flyveforbudsområde: %1</translation>
    </message>
    <message>
        <source>No-fly area %1: %2</source>
        <translation>Flyveforbudsområde %1: %2</translation>
    </message>
    <message>
        <source>Separate altitudes</source>
        <translation>Adskil højderne</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Fart</translation>
    </message>
    <message>
        <source>Speed of a ship; 0 for a platform.</source>
        <translation>Et skibs fart; 0 for en platform.</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Course over ground, clockwise from north.</source>
        <translation>Kurs over grunden, med uret fra nord.</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>Known drift, without the current.</source>
        <translation>Kendt drift, uden strømmen.</translation>
    </message>
    <message>
        <source>Drift towards</source>
        <translation>Driver mod</translation>
    </message>
    <message>
        <source>Drift direction, clockwise from north.</source>
        <translation>Driftens retning, med uret fra nord.</translation>
    </message>
    <message>
        <source>Any form; a whole coordinate sets both.</source>
        <translation>Enhver form; en hel koordinat udfylder begge.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vind</translation>
    </message>
    <message>
        <source>Must be below the UAV&apos;s airspeed.</source>
        <translation>Skal være lavere end dronens flyvefart.</translation>
    </message>
    <message>
        <source>Wind from</source>
        <translation>Vind fra</translation>
    </message>
    <message>
        <source>Direction the wind blows from, clockwise from north.</source>
        <translation>Den retning, vinden blæser fra, med uret fra nord.</translation>
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
        <translation>Fører alle isbjerge med sig.</translation>
    </message>
    <message>
        <source>Current towards</source>
        <translation>Strøm mod</translation>
    </message>
    <message>
        <source>Direction the current flows to, clockwise from north.</source>
        <translation>Den retning, strømmen løber mod, med uret fra nord.</translation>
    </message>
    <message>
        <source>Change operation</source>
        <translation>Ændr operation</translation>
    </message>
    <message>
        <source>Makes airspace that the operation may enter no-fly areas, so that the UAVs stay out of it.</source>
        <translation>Gør luftrum, som operationen kan komme ind i, til flyveforbudsområder, så dronerne holder sig uden for det.</translation>
    </message>
    <message>
        <source>Make entered airspace no-fly areas</source>
        <translation>Gør berørt luftrum til flyveforbudsområder</translation>
    </message>
    <message>
        <source>Removes all airspace. Undo restores it.</source>
        <translation>Fjerner alt luftrum. Fortryd henter det tilbage.</translation>
    </message>
    <message>
        <source>Remove airspace</source>
        <translation>Fjern luftrum</translation>
    </message>
    <message>
        <source>Operation volume</source>
        <translation>Operationsvolumen</translation>
    </message>
    <message>
        <source>Proposed volume for a permit application; check it with your authority. Shown on the map, in KML and GeoJSON, and on a second page of the flight brief.</source>
        <translation>Foreslået volumen til en ansøgning om tilladelse; afklar det med myndigheden. Vises på kortet, i KML og GeoJSON og på en ekstra side i flyvebriefingen.</translation>
    </message>
    <message>
        <source>Contingency volume %1 wide, %2 high
Ground-risk buffer %3
Adjacent area %4</source>
        <translation>Beredskabsvolumen %1 bredt, %2 højt
Jordrisikobuffer %3
Tilstødende område %4</translation>
    </message>
    <message>
        <source>Airspace %1: %2</source>
        <translation>Luftrum %1: %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>og %1 til</translation>
    </message>
    <message>
        <source>Position and course</source>
        <translation>Position og kurs</translation>
    </message>
    <message>
        <source>Protection</source>
        <translation>Beskyttelse</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Usikkerhed</translation>
    </message>
    <message>
        <source>Size and visits</source>
        <translation>Størrelse og besøg</translation>
    </message>
    <message>
        <source>Time and place</source>
        <translation>Tid og sted</translation>
    </message>
    <message>
        <source>Wind, weather and current</source>
        <translation>Vind, vejr og strøm</translation>
    </message>
    <message>
        <source>Flight rules</source>
        <translation>Flyveregler</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Planlægger</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulering</translation>
    </message>
    <message>
        <source>Position and heading</source>
        <translation>Position og kurs</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Fly</translation>
    </message>
    <message>
        <source>Endurance and home</source>
        <translation>Udholdenhed og hjem</translation>
    </message>
    <message>
        <source>Weather limits</source>
        <translation>Vejrgrænser</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % inden for</translation>
    </message>
    <message>
        <source>When last seen, the iceberg was within this radius with a probability of 95 %: the square root of 5.99 σ₀.</source>
        <translation>Da isbjerget sidst blev set, var det inden for denne radius med 95 % sandsynlighed: kvadratroden af 5,99 σ₀.</translation>
    </message>
    <message>
        <source>Seen by</source>
        <translation>Set med</translation>
    </message>
    <message>
        <source>Sets the usual uncertainty of this source, also for icebergs placed later.</source>
        <translation>Sætter den sædvanlige usikkerhed for denne kilde, også for isbjerge, der placeres senere.</translation>
    </message>
    <message>
        <source>as typed</source>
        <translation>som skrevet</translation>
    </message>
    <message>
        <source>Raises UAVs until their altitudes are %1 apart, so that none has to wait for another.</source>
        <translation>Hæver droner, indtil der er %1 forskel på deres højder, så ingen skal vente på en anden.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Ændr %1</translation>
    </message>
    <message>
        <source>ArduPilot, fixed wing</source>
        <translation>ArduPilot, fastvinget fly</translation>
    </message>
    <message>
        <source>ArduPilot, flying wing launched by hand</source>
        <translation>ArduPilot, flyvende vinge kastet med hånden</translation>
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
        <translation>som angivet nedenfor</translation>
    </message>
    <message>
        <source>Aircraft profile</source>
        <translation>Flyprofil</translation>
    </message>
    <message>
        <source>Sets all values of this group at once.</source>
        <translation>Sætter alle værdier i denne gruppe på én gang.</translation>
    </message>
    <message>
        <source>Choose aircraft profile</source>
        <translation>Vælg flyprofil</translation>
    </message>
    <message>
        <source>by mission item</source>
        <translation>med et missionselement</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>med hånden</translation>
    </message>
    <message>
        <source>return to launch</source>
        <translation>flyv hjem</translation>
    </message>
    <message>
        <source>landing pattern</source>
        <translation>landingsrunde</translation>
    </message>
    <message>
        <source>loiter and wait</source>
        <translation>kreds og vent</translation>
    </message>
    <message>
        <source>not in the mission</source>
        <translation>ikke i missionen</translation>
    </message>
    <message>
        <source>by distance</source>
        <translation>efter afstand</translation>
    </message>
    <message>
        <source>by time</source>
        <translation>efter tid</translation>
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
        <translation>Mission til autopiloten</translation>
    </message>
    <message>
        <source>Forecast</source>
        <translation>Prognose</translation>
    </message>
    <message>
        <source>Where and when it gives a quantity, it replaces the constant one below.</source>
        <translation>Hvor og når den giver en størrelse, erstatter den den faste nedenfor.</translation>
    </message>
    <message>
        <source>Remove forecast</source>
        <translation>Fjern prognose</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>tom</translation>
    </message>
    <message>
        <source>%1; replaces %2</source>
        <comment>time of issue, quantities</comment>
        <translation>%1; erstatter %2</translation>
    </message>
    <message>
        <source>%1; not used before the start (UTC) is set, then it replaces %2</source>
        <comment>time of issue, quantities</comment>
        <translation>%1; bruges først, når starten (UTC) er sat, og erstatter da %2</translation>
    </message>
    <message>
        <source>%1 h: %2 (1 σ: %3)</source>
        <comment>time, error, deviation</comment>
        <translation>%1 t: %2 (1 σ: %3)</translation>
    </message>
    <message>
        <source>Error of the predicted drift</source>
        <translation>Fejl i den forventede drift</translation>
    </message>
</context>
<context>
    <name>InterventionText</name>
    <message>
        <source>Change policy</source>
        <translation>Ændr strategi</translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation>Ændr vind</translation>
    </message>
    <message>
        <source>Move asset</source>
        <translation>Flyt objekt</translation>
    </message>
    <message>
        <source>Add iceberg</source>
        <translation>Tilføj isbjerg</translation>
    </message>
    <message>
        <source>Report sighting</source>
        <translation>Meld observation</translation>
    </message>
    <message>
        <source>Remove icebergs</source>
        <translation>Fjern isbjerge</translation>
    </message>
    <message>
        <source>Assign iceberg</source>
        <translation>Tildel isbjerg</translation>
    </message>
    <message>
        <source>Order UAV</source>
        <translation>Giv dronen en ordre</translation>
    </message>
    <message>
        <source>Change trade-off</source>
        <translation>Ændr afvejning</translation>
    </message>
    <message>
        <source>The scenario is locked in flight. Stop the flight to change it.</source>
        <translation>Scenariet er låst under flyvning. Stop flyvningen for at ændre det.</translation>
    </message>
    <message>
        <source>Move home</source>
        <translation>Flyt hjem</translation>
    </message>
</context>
<context>
    <name>IssueText</name>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n fejl</numerusform>
            <numerusform>%n fejl</numerusform>
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
            <numerusform>%n tip</numerusform>
            <numerusform>%n tip</numerusform>
        </translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>linje %1, kolonne %2: dette er ikke gyldig JSON</translation>
    </message>
    <message>
        <source>line %1, column %2: %3: a number too large for this program</source>
        <translation>linje %1, kolonne %2: %3: et tal, der er for stort for dette program</translation>
    </message>
    <message>
        <source>nested deeper than %1 levels</source>
        <translation>er indlejret dybere end %1 niveauer</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>linje %1: dette er ikke gyldig XML</translation>
    </message>
    <message>
        <source>is no %1 file: must be %2, not %3</source>
        <translation>er ikke en fil af typen %1: skal være %2, ikke %3</translation>
    </message>
    <message>
        <source>must be &quot;%1&quot;</source>
        <translation>skal være »%1«</translation>
    </message>
    <message>
        <source>must be &quot;%1&quot;, not &quot;%2&quot;</source>
        <translation>skal være »%1«, ikke »%2«</translation>
    </message>
    <message>
        <source>%1 is not known: this program reads %2</source>
        <translation>%1 er ukendt: dette program læser %2</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>mangler</translation>
    </message>
    <message>
        <source>is missing, and so is %1</source>
        <translation>mangler, og det gør %1 også</translation>
    </message>
    <message>
        <source>must not be given beside %1</source>
        <translation>må ikke angives sammen med %1</translation>
    </message>
    <message>
        <source>appears more than once</source>
        <translation>forekommer mere end én gang</translation>
    </message>
    <message>
        <source>must be %1, not %2</source>
        <translation>skal være %1, ikke %2</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>skal være en af %1</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2, not %3</source>
        <translation>skal være et helt tal fra %1 til %2, ikke %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number</source>
        <translation>»%1« er ikke et tal</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number: decimals follow a point</source>
        <translation>»%1« er ikke et tal: decimaler følger efter et punktum</translation>
    </message>
    <message>
        <source>must be a finite number of at least 0</source>
        <translation>skal være et endeligt tal på mindst 0</translation>
    </message>
    <message>
        <source>must not be below %1</source>
        <translation>må ikke være under %1</translation>
    </message>
    <message>
        <source>must not be before %1</source>
        <translation>må ikke være før %1</translation>
    </message>
    <message>
        <source>must rise from entry to entry</source>
        <translation>skal stige fra værdi til værdi</translation>
    </message>
    <message>
        <source>must hold %1 entries, not %2</source>
        <translation>skal have %1 værdier, ikke %2</translation>
    </message>
    <message>
        <source>must hold from %1 to %2 entries, not %3</source>
        <translation>skal have fra %1 til %2 værdier, ikke %3</translation>
    </message>
    <message>
        <source>must hold at least %1 entries</source>
        <translation>skal have mindst %1 værdier</translation>
    </message>
    <message>
        <source>must hold at most %1 entries, not %2</source>
        <translation>må højst have %1 værdier, ikke %2</translation>
    </message>
    <message>
        <source>must not repeat an iceberg</source>
        <translation>må ikke gentage et isbjerg</translation>
    </message>
    <message>
        <source>no iceberg &quot;%1&quot; is there at this time</source>
        <translation>der er intet isbjerg »%1« på dette tidspunkt</translation>
    </message>
    <message>
        <source>with these, the run must hold at most %1 icebergs, not %2</source>
        <translation>med disse må flyvningen højst have %1 isbjerge, ikke %2</translation>
    </message>
    <message>
        <source>is the UAV&apos;s and must be 0</source>
        <translation>er dronens og skal være 0</translation>
    </message>
    <message>
        <source>must be a square matrix with one row and column per sigma</source>
        <translation>skal være en kvadratisk matrix med én række og én kolonne for hver sigma</translation>
    </message>
    <message>
        <source>must be empty or hold one entry per UAV and sigma</source>
        <translation>skal være tom eller have én værdi for hver drone og sigma</translation>
    </message>
    <message>
        <source>must be true for one UAV at least</source>
        <translation>skal være true for mindst én drone</translation>
    </message>
    <message>
        <source>is too large: the cost of a plan may exceed %1</source>
        <translation>er for stor: en plans omkostning kan overstige %1</translation>
    </message>
    <message>
        <source>is too small: a cost that is not 0 is less than %1</source>
        <translation>er for lille: en omkostning, der ikke er 0, er mindre end %1</translation>
    </message>
    <message>
        <source>must not be empty when random is 0</source>
        <translation>må ikke være tom, når random er 0</translation>
    </message>
    <message>
        <source>must name a policy; visitation needs taus</source>
        <translation>skal angive en strategi; visitation kræver værdier af τ</translation>
    </message>
    <message>
        <source>must be I of N with 1 &lt;= I &lt;= N</source>
        <translation>skal være I of N med 1 &lt;= I &lt;= N</translation>
    </message>
    <message>
        <source>differs: parts of one study are wanted</source>
        <translation>afviger: her kræves dele af samme studie</translation>
    </message>
    <message>
        <source>setting %1 of case %2 has two different outcomes: the parts were not flown by the same program</source>
        <translation>indstilling %1 af tilfælde %2 har to forskellige udfald: delene er ikke fløjet med samme program</translation>
    </message>
    <message>
        <source>no study is kept in this page</source>
        <translation>denne side indeholder intet studie</translation>
    </message>
    <message>
        <source>would become larger than %1 MiB: take fewer scenarios, or several studies</source>
        <translation>ville blive større end %1 MiB: tag færre scenarier eller flere studier</translation>
    </message>
    <message>
        <source>recorded %1, replayed %2</source>
        <translation>optaget %1, afspillet %2</translation>
    </message>
    <message>
        <source>at %1 s: recorded %2, replayed %3</source>
        <translation>ved %1 s: optaget %2, afspillet %3</translation>
    </message>
    <message>
        <source>at %1 s: the replay has another</source>
        <translation>ved %1 s: afspilningen har en anden</translation>
    </message>
    <message>
        <source>at %1 s: not reached by the replay</source>
        <translation>ved %1 s: ikke nået af afspilningen</translation>
    </message>
    <message>
        <source>solves were cut by the clock, so this run is not bound to repeat</source>
        <translation>løsninger blev afbrudt af uret, så denne flyvning gentager sig ikke nødvendigvis</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>kan ikke åbnes: %1</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kan ikke læses: %1</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>kan ikke skrives: %1</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>kan ikke oprettes</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>er beskadiget</translation>
    </message>
    <message>
        <source>is of another version</source>
        <translation>er af en anden version</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>er ikke en almindelig fil</translation>
    </message>
    <message>
        <source>is larger than %1 MiB</source>
        <translation>er større end %1 MiB</translation>
    </message>
    <message>
        <source>is larger than %1 MiB; %2 in the environment doubles the limits of reading</source>
        <translation>er større end %1 MiB; %2 i miljøvariablerne fordobler grænserne for læsning</translation>
    </message>
    <message>
        <source>holds more than %1 values; %2 in the environment doubles the limits of reading</source>
        <translation>har mere end %1 værdier; %2 i miljøvariablerne fordobler grænserne for læsning</translation>
    </message>
    <message>
        <source>holds more than %1 rows or features; %2 in the environment doubles the limits of reading</source>
        <translation>har mere end %1 rækker eller objekter; %2 i miljøvariablerne fordobler grænserne for læsning</translation>
    </message>
    <message>
        <source>would take more than %1 MB of memory, the limit for a file of its size: split it, or leave out what is empty; %2 in the environment doubles the limits of reading</source>
        <translation>ville bruge mere end %1 MB hukommelse, grænsen for en fil af dens størrelse: del den, eller udelad det, der er tomt; %2 i miljøvariablerne fordobler grænserne for læsning</translation>
    </message>
    <message>
        <source>there are more than %1 icebergs to choose from: narrow the area or the time; %2 in the environment doubles the limits of reading</source>
        <translation>der er mere end %1 isbjerge at vælge imellem: indsnævr området eller tiden; %2 i miljøvariablerne fordobler grænserne for læsning</translation>
    </message>
    <message>
        <source>is an archive that cannot be read: it is cut off or damaged</source>
        <translation>er et arkiv, der ikke kan læses: det er afkortet eller beskadiget</translation>
    </message>
    <message>
        <source>is a compressed archive (such as XLSX) without a file *%1</source>
        <translation>er et komprimeret arkiv (f.eks. XLSX) uden en fil *%1</translation>
    </message>
    <message>
        <source>is an archive whose entry *%1 cannot be unpacked</source>
        <translation>er et arkiv, hvis fil *%1 ikke kan pakkes ud</translation>
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
        <translation>er UTF-16-tekst; gem den som UTF-8</translation>
    </message>
    <message>
        <source>is no text file</source>
        <translation>er ikke en tekstfil</translation>
    </message>
    <message>
        <source>no import format &quot;%1&quot;; there are %2</source>
        <translation>intet importformat »%1«; der findes %2</translation>
    </message>
    <message>
        <source>columns of the format %1 cannot be mapped</source>
        <translation>kolonner i formatet %1 kan ikke tilknyttes</translation>
    </message>
    <message>
        <source>holds no sightings</source>
        <translation>indeholder ingen observationer</translation>
    </message>
    <message>
        <source>there is no column &quot;%1&quot;</source>
        <translation>der er ingen kolonne »%1«</translation>
    </message>
    <message>
        <source>no column holds it; name one with a mapping</source>
        <translation>ingen kolonne indeholder det; tilknyt en</translation>
    </message>
    <message>
        <source>columns %1 and %2 are both called &quot;%3&quot;: rename one</source>
        <translation>kolonnerne %1 og %2 hedder begge »%3«: omdøb den ene</translation>
    </message>
    <message>
        <source>the first line must name from 1 to %1 columns</source>
        <translation>den første linje skal navngive fra 1 til %1 kolonner</translation>
    </message>
    <message>
        <source>has %2 columns and not %1</source>
        <translation>har %2 kolonner og ikke %1</translation>
    </message>
    <message>
        <source>%1 would then be more than 1000 km east, west, north or south of the origin</source>
        <translation>%1 ville da være mere end 1000 km øst, vest, nord eller syd for origo</translation>
    </message>
    <message>
        <source>cannot move while the scenario holds icebergs, an asset or an area</source>
        <translation>kan ikke flyttes, så længe scenariet har isbjerge, et objekt eller et område</translation>
    </message>
    <message>
        <source>this is not a place on the Earth</source>
        <translation>dette er ikke et sted på Jorden</translation>
    </message>
    <message>
        <source>has another number of columns than the first line</source>
        <translation>har et andet antal kolonner end den første linje</translation>
    </message>
    <message>
        <source>a quote is opened and never closed</source>
        <translation>et anførselstegn åbnes og lukkes aldrig</translation>
    </message>
    <message>
        <source>text follows a closing quote</source>
        <translation>der følger tekst efter et afsluttende anførselstegn</translation>
    </message>
    <message>
        <source>has no time</source>
        <translation>har ingen tid</translation>
    </message>
    <message>
        <source>time cannot be read</source>
        <translation>tiden kan ikke læses</translation>
    </message>
    <message>
        <source>date is not in the season</source>
        <translation>datoen er ikke i sæsonen</translation>
    </message>
    <message>
        <source>has no position</source>
        <translation>har ingen position</translation>
    </message>
    <message>
        <source>a number is out of range</source>
        <translation>et tal er uden for grænserne</translation>
    </message>
    <message>
        <source>id is too long</source>
        <translation>id&apos;et er for langt</translation>
    </message>
    <message>
        <source>is no point</source>
        <translation>er ikke et punkt</translation>
    </message>
    <message>
        <source>is more than 1000 km east, west, north or south of the origin</source>
        <translation>er mere end 1000 km øst, vest, nord eller syd for origo</translation>
    </message>
    <message>
        <source>there is no room for more</source>
        <translation>der er ikke plads til flere</translation>
    </message>
    <message>
        <source>must lie within %1 m</source>
        <translation>skal ligge inden for %1 m</translation>
    </message>
    <message>
        <source>only %1 of %2 icebergs found a place: the area is too thin</source>
        <translation>kun %1 af %2 isbjerge fandt en plads: området er for smalt</translation>
    </message>
    <message>
        <source>a scenario has no such file: nothing was flown</source>
        <translation>et scenarie har ingen sådan fil: intet blev fløjet</translation>
    </message>
    <message>
        <source>must be above the speed of the wind</source>
        <translation>skal være over vindens fart</translation>
    </message>
    <message>
        <source>there is no UAV %1</source>
        <translation>der er ingen drone %1</translation>
    </message>
    <message>
        <source>%1 holds one UAV: choose one</source>
        <translation>%1 rummer én drone: vælg én</translation>
    </message>
    <message>
        <source>%1 is painted, which needs the program bergwatch</source>
        <translation>%1 tegnes, hvilket kræver programmet bergwatch</translation>
    </message>
    <message>
        <source>cannot be exported: at %1 s of the flight, later than any date</source>
        <translation>kan ikke eksporteres: ved %1 s af flyvningen, senere end nogen dato</translation>
    </message>
    <message>
        <source>cannot be exported: at %1 s it is %2 m from the origin of the map, which holds %3 m</source>
        <translation>kan ikke eksporteres: ved %1 s er det %2 m fra origo på kortet, som rummer %3 m</translation>
    </message>
    <message>
        <source>cannot be exported: its turns are not finite</source>
        <translation>kan ikke eksporteres: dens drej er ikke endelige</translation>
    </message>
    <message>
        <source>the scenario cannot be planned</source>
        <translation>scenariet kan ikke planlægges</translation>
    </message>
    <message>
        <source>this build was made without COIN-OR CBC</source>
        <translation>dette program er bygget uden COIN-OR CBC</translation>
    </message>
    <message>
        <source>the back end cbc cannot plan for the policy latency</source>
        <translation>løseren cbc kan ikke planlægge for strategien latency</translation>
    </message>
    <message>
        <source>%1 is not flown by this version</source>
        <translation>%1 flyves ikke af denne version</translation>
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
        <translation>et tal</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true eller false</translation>
    </message>
    <message>
        <source>two numbers</source>
        <translation>to tal</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>talpar</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>linje %1</translation>
    </message>
    <message>
        <source>no such file or folder</source>
        <translation>ingen sådan fil eller mappe</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>ingen tilladelse</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>det er en mappe</translation>
    </message>
    <message>
        <source>part of the path is no folder</source>
        <translation>en del af stien er ikke en mappe</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>disken er fuld</translation>
    </message>
    <message>
        <source>the quota is used up</source>
        <translation>kvoten er brugt op</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>disken er skrivebeskyttet</translation>
    </message>
    <message>
        <source>the disk is faulty</source>
        <translation>disken er defekt</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>navnet er for langt</translation>
    </message>
    <message>
        <source>the program bergwatch-cbc is not there: %1</source>
        <translation>programmet bergwatch-cbc findes ikke: %1</translation>
    </message>
    <message>
        <source>must be at least %1 for a run of this length and so many icebergs, not %2; %3 in the environment doubles the limits of reading</source>
        <translation>skal være mindst %1 for en flyvning af denne længde og så mange isbjerge, ikke %2; %3 i miljøvariablerne fordobler grænserne for læsning</translation>
    </message>
    <message>
        <source>with the policies would be %1 settings; at most %2 fit into one study: take several</source>
        <translation>ville med strategierne blive %1 indstillinger; der er højst plads til %2 i ét studie: tag flere</translation>
    </message>
    <message>
        <source>would be %1 missions; at most %2 fit into one study: take several</source>
        <translation>ville blive %1 missioner; der er højst plads til %2 i ét studie: tag flere</translation>
    </message>
    <message>
        <source>names an iceberg, but the run holds none</source>
        <translation>angiver et isbjerg, men flyvningen har ingen</translation>
    </message>
    <message>
        <source>is no airspace: not OpenAir, GeoJSON, KML, KMZ or CZML</source>
        <translation>er ikke luftrum: ikke OpenAir, GeoJSON, KML, KMZ eller CZML</translation>
    </message>
    <message>
        <source>holds no airspace</source>
        <translation>indeholder intet luftrum</translation>
    </message>
    <message>
        <source>airspace left out: a place or an arc cannot be read</source>
        <translation>luftrum udeladt: et sted eller en bue kan ikke læses</translation>
    </message>
    <message>
        <source>there is no folder %1</source>
        <translation>mappen %1 findes ikke</translation>
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
        <translation>kan ikke oprettes: %1</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>kunne ikke skrives</translation>
    </message>
    <message>
        <source>none of its %1 sightings could be taken; nothing written</source>
        <translation>ingen af de %1 observationer kunne bruges; intet er skrevet</translation>
    </message>
    <message>
        <source>dates such as %1 are read month first, which nothing in the file tells: --dates day-first or month-first says how</source>
        <translation>datoer som %1 læses med måneden først; intet i filen afgør det: --dates day-first eller month-first afgør det</translation>
    </message>
    <message>
        <source>differs: this is the file of another study (--replace-study replaces it)</source>
        <translation>afviger: dette er filen til et andet studie (--replace-study erstatter den)</translation>
    </message>
    <message>
        <source>was changed by another program: each shard needs a file of its own</source>
        <translation>blev ændret af et andet program: hver del kræver sin egen fil</translation>
    </message>
    <message>
        <source>this plan solves no problem that could be verified or certified</source>
        <translation>denne plan løser intet problem, der kan kontrolleres eller certificeres</translation>
    </message>
    <message>
        <source>this build has no MPI (BERGWATCH_WITH_MPI): fly shards with --shard I/N</source>
        <translation>dette program er bygget uden MPI (BERGWATCH_WITH_MPI): flyv dele med --shard I/N</translation>
    </message>
    <message>
        <source>must be UTF-8 text</source>
        <translation>skal være UTF-8-tekst</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>skal være et endeligt tal</translation>
    </message>
    <message>
        <source>must be from %1 to %2, not %3</source>
        <translation>skal være fra %1 til %2, ikke %3</translation>
    </message>
    <message>
        <source>must be above %1 and at most %2, not %3</source>
        <translation>skal være over %1 og højst %2, ikke %3</translation>
    </message>
    <message>
        <source>must be a UTC date and time such as 2024-05-01T06:00:00Z</source>
        <translation>skal være en dato og et klokkeslæt i UTC, f.eks. 2024-05-01T06:00:00Z</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>må ikke være tom</translation>
    </message>
    <message>
        <source>must have from 2 to %1 entries, not %2</source>
        <translation>skal have fra 2 til %1 værdier, ikke %2</translation>
    </message>
    <message>
        <source>must be later than the entry before</source>
        <translation>skal være senere end værdien før</translation>
    </message>
    <message>
        <source>must be at most %1 where the endurance is limited, not %2</source>
        <translation>må højst være %1, når udholdenheden er begrænset, ikke %2</translation>
    </message>
    <message>
        <source>must be inside the area, which is a geofence</source>
        <translation>skal ligge inden for området, som er et geohegn</translation>
    </message>
    <message>
        <source>must be outside the no-fly area &quot;%1&quot;</source>
        <translation>skal ligge uden for flyveforbudsområdet »%1«</translation>
    </message>
    <message>
        <source>must be outside the stand-off ring round the asset</source>
        <translation>skal ligge uden for sikkerhedsringen omkring objektet</translation>
    </message>
    <message>
        <source>drifts so fast that the UAV may not catch up with it</source>
        <translation>driver så hurtigt, at dronen måske ikke kan indhente det</translation>
    </message>
    <message>
        <source>with these drifts and a round of %1 minutes, %2 of %3 icebergs will be out of view at the next visit</source>
        <translation>med denne drift og en runde på %1 minutter vil %2 af %3 isbjerge være ude af syne ved næste besøg</translation>
    </message>
    <message>
        <source>is too short for the path home from the start</source>
        <translation>er for kort til vejen hjem fra startstedet</translation>
    </message>
    <message>
        <source>is used, without a limited endurance, only when you order a return or export with the return home</source>
        <translation>bruges, uden begrænset udholdenhed, kun når du beordrer hjemflyvning eller eksporterer med hjemflyvning</translation>
    </message>
    <message>
        <source>is so near the geofence or a no-fly area that the UAV cannot take off there again and be sure to come home</source>
        <translation>er så tæt på geohegnet eller et flyveforbudsområde, at dronen ikke kan starte derfra igen og være sikker på at komme hjem</translation>
    </message>
    <message>
        <source>this policy plans without geofence and no-fly areas; they are kept in flight</source>
        <translation>denne strategi planlægger uden geohegn og flyveforbudsområder; de overholdes under flyvningen</translation>
    </message>
    <message>
        <source>the turn radius is larger than half the field of view, so that an iceberg may be missed</source>
        <translation>drejeradius er større end det halve synsfelt, så et isbjerg kan blive overset</translation>
    </message>
    <message>
        <source>is smaller than the turn radius, so that the UAV flies on and comes back</source>
        <translation>er mindre end drejeradius, så dronen flyver videre og kommer tilbage</translation>
    </message>
    <message>
        <source>is larger than half the field of view, so that icebergs count as reached that are not seen</source>
        <translation>er større end det halve synsfelt, så isbjerge, der ikke er set, tæller som nået</translation>
    </message>
    <message>
        <source>lies outside the area</source>
        <translation>ligger uden for området</translation>
    </message>
    <message>
        <source>drifts out of the area before the end of the run</source>
        <translation>driver ud af området, før flyvningen er slut</translation>
    </message>
    <message>
        <source>is over before the UAV can get to the first iceberg</source>
        <translation>er slut, før dronen kan nå frem til det første isbjerg</translation>
    </message>
    <message>
        <source>drifts faster than icebergs do: is the unit right?</source>
        <translation>driver hurtigere, end isbjerge gør: er enheden rigtig?</translation>
    </message>
    <message>
        <source>no iceberg is uncertain at the start, so distance alone makes the first plan</source>
        <translation>ingen isbjerge er usikre ved starten, så afstanden alene afgør den første plan</translation>
    </message>
    <message>
        <source>proving the optimum of so many icebergs can take a minute and more</source>
        <translation>at bevise optimum for så mange isbjerge kan tage et minut eller mere</translation>
    </message>
    <message>
        <source>the back end %1 proves plans of at most %2 icebergs; auto gives a plan and a bound</source>
        <translation>løseren %1 beviser planer med højst %2 isbjerge; auto giver en plan og en grænse</translation>
    </message>
    <message>
        <source>the back end exact proves latency plans of several UAVs for at most %1 icebergs</source>
        <translation>løseren exact beviser latency-planer for flere droner med højst %1 isbjerge</translation>
    </message>
    <message>
        <source>the MILP formulation %1 is offered for at most %2 icebergs, not for %3</source>
        <translation>MILP-formuleringen %1 tilbydes for højst %2 isbjerge, ikke for %3</translation>
    </message>
    <message>
        <source>the column &quot;%1&quot; is not understood: rename it, or assign it with a mapping</source>
        <translation>kolonnen »%1« genkendes ikke: omdøb den, eller tilknyt den</translation>
    </message>
    <message>
        <source>airspace left out: a height has no unit</source>
        <translation>luftrum udeladt: en højde har ingen enhed</translation>
    </message>
    <message>
        <source>members that this version does not know are not used: &quot;%1&quot;</source>
        <translation>felter, som denne version ikke kender, bruges ikke: »%1«</translation>
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
        <translation>starter i mørke, kl. %1 UTC: borgerligt tusmørke begynder kl. %2 UTC</translation>
    </message>
    <message>
        <source>lands in the dark, at %1 UTC: civil twilight ends at %2 UTC</source>
        <translation>lander i mørke, kl. %1 UTC: borgerligt tusmørke slutter kl. %2 UTC</translation>
    </message>
    <message>
        <source>the time zone &quot;%1&quot; is a name: write offsets from UTC, such as +02:00</source>
        <translation>tidszonen »%1« er et navn: skriv afvigelser fra UTC, som +02:00</translation>
    </message>
    <message>
        <source>there is nothing on line %1 or below it</source>
        <translation>der står intet på linje %1 eller under den</translation>
    </message>
    <message>
        <source>nothing tells which rows are sightings of one iceberg: choose one of these</source>
        <translation>filen siger ikke, hvilke rækker der er observationer af ét isbjerg: vælg en af disse</translation>
    </message>
    <message>
        <source>icebergs: %1, greatest speed between two sightings: %2 m/s</source>
        <translation>isbjerge: %1, største fart mellem to observationer: %2 m/s</translation>
    </message>
    <message>
        <source>is faster than 1.5 m/s or on land: check columns, units and ids, or accept it with --accept-doubtful</source>
        <translation>er hurtigere end 1,5 m/s eller på land: kontrollér kolonner, enheder og id&apos;er, eller acceptér det med --accept-doubtful</translation>
    </message>
    <message>
        <source>has several places: each is taken as an iceberg</source>
        <translation>har flere positioner: hver regnes som et isbjerg</translation>
    </message>
    <message>
        <source>has points beside lines or areas: only the points are taken</source>
        <translation>har punkter ved siden af linjer eller flader: kun punkterne tages med</translation>
    </message>
    <message>
        <source>has areas beside lines: only the areas are taken</source>
        <translation>har flader ved siden af linjer: kun fladerne tages med</translation>
    </message>
    <message>
        <source>has points or areas beside a track: only the track is taken</source>
        <translation>har punkter eller flader ved siden af et spor: kun sporet tages med</translation>
    </message>
    <message>
        <source>has the name of another track, but an iceberg cannot have drifted along both: it is taken as another iceberg</source>
        <translation>har samme navn som et andet spor, men et isbjerg kan ikke være drevet langs begge: det regnes som et andet isbjerg</translation>
    </message>
    <message>
        <source>the property that names the iceberg is the same at two places at once: the ids of the features are taken instead</source>
        <translation>egenskaben, der navngiver isbjerget, er den samme to steder på én gang: objekternes id&apos;er bruges i stedet</translation>
    </message>
    <message>
        <source>has more times than places: the times left over are not taken</source>
        <translation>har flere tider end positioner: de overskydende tider bruges ikke</translation>
    </message>
    <message>
        <source>the place can be read in more than one way: decimals follow a point</source>
        <translation>positionen kan læses på flere måder: decimaler skrives med punktum</translation>
    </message>
    <message>
        <source>coordinates are no degrees, and the file names no coordinate system: save it in WGS 84 (EPSG:4326)</source>
        <translation>koordinaterne er ikke grader, og filen angiver intet koordinatsystem: gem den i WGS 84 (EPSG:4326)</translation>
    </message>
    <message>
        <source>coordinates look like degrees, but the file says they are metres: save it in WGS 84 (EPSG:4326)</source>
        <translation>koordinaterne ligner grader, men filen siger, at de er meter: gem den i WGS 84 (EPSG:4326)</translation>
    </message>
    <message>
        <source>the coordinate system &quot;%1&quot; is not known: save the file in WGS 84 (EPSG:4326)</source>
        <translation>koordinatsystemet »%1« er ukendt: gem filen i WGS 84 (EPSG:4326)</translation>
    </message>
    <message>
        <source>is not well-formed JSON</source>
        <translation>er ikke velformet JSON</translation>
    </message>
    <message>
        <source>links to another file, which is not read: import that file as well</source>
        <translation>henviser til en anden fil, som ikke læses: importér også den fil</translation>
    </message>
    <message>
        <source>the first document of the archive does not link to this one; it is read all the same</source>
        <translation>arkivets første dokument henviser ikke til dette; det læses alligevel</translation>
    </message>
    <message>
        <source>a document of the archive cannot be read</source>
        <translation>et dokument i arkivet kan ikke læses</translation>
    </message>
    <message>
        <source>airspace left out: it has no outline</source>
        <translation>luftrum udeladt: det mangler omrids</translation>
    </message>
    <message>
        <source>outline left out: no airspace begins above it</source>
        <translation>omrids udeladt: intet luftrum begynder over det</translation>
    </message>
    <message>
        <source>airspace left out: its outline encloses nothing</source>
        <translation>luftrum udeladt: omridset omslutter ingenting</translation>
    </message>
    <message>
        <source>airspace left out: its ceiling is not above its floor</source>
        <translation>luftrum udeladt: loftet ligger ikke over gulvet</translation>
    </message>
    <message>
        <source>airspace left out: it is farther than 100 km</source>
        <translation>luftrum udeladt: det er længere væk end 100 km</translation>
    </message>
    <message>
        <source>airspace left out: the scenario holds as many as it can</source>
        <translation>luftrum udeladt: scenariet rummer ikke flere</translation>
    </message>
    <message>
        <source>airspace taken without a class</source>
        <translation>luftrum taget med uden klasse</translation>
    </message>
    <message>
        <source>airspace taken down to the sea: its floor is missing or cannot be read</source>
        <translation>luftrum taget med ned til havet: gulvet mangler eller kan ikke læses</translation>
    </message>
    <message>
        <source>airspace taken without end above: its ceiling is missing or cannot be read</source>
        <translation>luftrum taget med uden øvre grænse: loftet mangler eller kan ikke læses</translation>
    </message>
    <message>
        <source>airspace taken with an outline round its own, which touches or crosses itself</source>
        <translation>luftrum taget med i et større omrids: dets eget berører eller krydser sig selv</translation>
    </message>
    <message>
        <source>airspace taken with an outline round its own, which has too many corners</source>
        <translation>luftrum taget med i et større omrids: dets eget har for mange hjørner</translation>
    </message>
    <message>
        <source>line not understood and not used</source>
        <translation>linje ikke forstået og ikke brugt</translation>
    </message>
    <message>
        <source>has no time, although other sightings of this iceberg have one</source>
        <translation>har intet tidspunkt, selv om andre observationer af dette isbjerg har et</translation>
    </message>
    <message>
        <source>lies outside the chosen area</source>
        <translation>ligger uden for det valgte område</translation>
    </message>
    <message>
        <source>was sighted outside the chosen time</source>
        <translation>er observeret uden for det valgte tidsrum</translation>
    </message>
    <message>
        <source>taken without a value that cannot be read</source>
        <translation>medtaget uden en værdi, der ikke kan læses</translation>
    </message>
    <message>
        <source>taken without a number that is out of range</source>
        <translation>medtaget uden et tal, der er uden for grænserne</translation>
    </message>
    <message>
        <source>a range, a limit or an estimate is read as one number</source>
        <translation>et interval, en grænse eller et skøn er læst som ét tal</translation>
    </message>
    <message>
        <source>taken without its time, which cannot be read</source>
        <translation>medtaget uden tidspunktet, som ikke kan læses</translation>
    </message>
    <message>
        <source>taken without a time, which it does not have</source>
        <translation>medtaget uden tidspunkt, som mangler</translation>
    </message>
    <message>
        <source>taken without its time, which is years from all others</source>
        <translation>medtaget uden tidspunktet, som er år fra alle andre</translation>
    </message>
    <message>
        <source>its time is moved by 1024 weeks, as a GPS clock has lost count of them</source>
        <translation>tidspunktet er flyttet 1024 uger, fordi et GPS-ur har mistet tallet</translation>
    </message>
    <message>
        <source>its id is too long and is shortened</source>
        <translation>id&apos;et er for langt og er forkortet</translation>
    </message>
    <message>
        <source>the wind must be two finite numbers</source>
        <translation>vinden skal være to endelige tal</translation>
    </message>
    <message>
        <source>the area must have from 3 to %1 corners, not %2</source>
        <translation>området skal have fra 3 til %1 hjørner, ikke %2</translation>
    </message>
    <message>
        <source>the area must neither touch nor cross itself</source>
        <translation>området må hverken røre eller krydse sig selv</translation>
    </message>
    <message>
        <source>a scenario holds at most %1 no-fly areas, not %2</source>
        <translation>et scenarie har højst %1 flyveforbudsområder, ikke %2</translation>
    </message>
    <message>
        <source>a scenario holds at most %1 airspace areas, not %2</source>
        <translation>et scenarie rummer højst %1 luftrumsområder, ikke %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the id of %2 already: each iceberg and UAV needs a unique id</source>
        <translation>»%1« er allerede id&apos;et for %2: hvert isbjerg og hver drone skal have et unikt id</translation>
    </message>
    <message>
        <source>a scenario holds from 1 to %1 UAVs, not %2</source>
        <translation>et scenarie rummer fra 1 til %1 droner, ikke %2</translation>
    </message>
    <message>
        <source>a scenario holds at most %1 icebergs, not %2</source>
        <translation>et scenarie rummer højst %1 isbjerge, ikke %2</translation>
    </message>
    <message>
        <source>must have one entry for each of the %1 times, not %2</source>
        <translation>skal have én værdi for hver af de %1 tider, ikke %2</translation>
    </message>
    <message>
        <source>there are %1 more errors</source>
        <translation>der er %1 fejl mere</translation>
    </message>
    <message>
        <source>must not be longer than the run</source>
        <translation>må ikke være længere end flyvningen</translation>
    </message>
    <message>
        <source>needs an area to stay inside</source>
        <translation>kræver et område at holde sig inden for</translation>
    </message>
    <message>
        <source>a geofence has at most %1 corners, not %2</source>
        <translation>et geohegn har højst %1 hjørner, ikke %2</translation>
    </message>
    <message>
        <source>with the geofence and the stand-off ring, the no-fly areas at the altitude of a UAV have at most %1 corners, not %2</source>
        <translation>sammen med geohegnet og sikkerhedsringen har flyveforbudsområderne i en drones højde højst %1 hjørner, ikke %2</translation>
    </message>
    <message>
        <source>there is no UAV &quot;%1&quot; in this scenario</source>
        <translation>der er ingen drone »%1« i dette scenarie</translation>
    </message>
    <message>
        <source>the wind must be slower than the UAV flies: wind of %1, airspeed of %2 %3</source>
        <translation>vinden skal være langsommere, end dronen flyver: vind på %1, flyvefart på %2 %3</translation>
    </message>
    <message>
        <source>the UAV will make little headway in this wind: wind of %1, airspeed of %2 %3</source>
        <translation>dronen vil næsten ikke komme frem i denne vind: vind på %1, flyvefart på %2 %3</translation>
    </message>
    <message>
        <source>must not be shorter than the time step</source>
        <translation>må ikke være kortere end tidsskridtet</translation>
    </message>
    <message>
        <source>must be above the floor of %1, not %2</source>
        <translation>skal ligge over den nedre højdegrænse på %1, ikke %2</translation>
    </message>
    <message>
        <source>the airspace &quot;%1&quot; ends before it begins</source>
        <translation>luftrummet »%1« slutter, før det begynder</translation>
    </message>
    <message>
        <source>must be longer than reserve, climb and landing together, %2, not %1</source>
        <translation>skal være længere end reserve, stigning og landing tilsammen, %2, ikke %1</translation>
    </message>
    <message>
        <source>there are no icebergs yet, so there is nothing to plan</source>
        <translation>der er ingen isbjerge endnu, så der er intet at planlægge</translation>
    </message>
    <message>
        <source>is after the end of the run, so the iceberg is never planned</source>
        <translation>er efter flyvningens slutning, så isbjerget bliver aldrig planlagt</translation>
    </message>
    <message>
        <source>icebergs outside the area are not monitored; the UAV may fly beyond it</source>
        <translation>isbjerge uden for området overvåges ikke; dronen kan flyve uden for det</translation>
    </message>
    <message>
        <source>is used in flight only with the Kalman filter</source>
        <translation>bruges under flyvningen kun med Kalman-filteret</translation>
    </message>
    <message>
        <source>another UAV of this altitude layer starts so near that they fly apart first; let their altitudes differ by %1</source>
        <translation>en anden drone i dette højdelag starter så nær, at de først flyver fra hinanden; giv dem højder med %1 forskel</translation>
    </message>
    <message>
        <source>is too short to reach the nearest iceberg and return</source>
        <translation>er for kort til at nå det nærmeste isbjerg og vende tilbage</translation>
    </message>
    <message>
        <source>for its heading, the UAV has no path home inside the geofence and outside no-fly areas from where it starts: no start is safe</source>
        <translation>med sin kurs har dronen ingen vej hjem inden for geohegnet og uden om flyveforbudsområder fra sit startsted: ingen start er sikker</translation>
    </message>
    <message>
        <source>the UAV starts so near the geofence or a no-fly area, for its heading, that it cannot turn in time</source>
        <translation>dronen starter med sin kurs så tæt på geohegnet eller et flyveforbudsområde, at den ikke kan nå at dreje</translation>
    </message>
    <message>
        <source>is so near the geofence, or in a no-fly area, that the UAV cannot come as near as it has to</source>
        <translation>er så nær geohegnet, eller i et flyveforbudsområde, at dronen ikke kan komme så nær, som den skal</translation>
    </message>
    <message>
        <source>the time between two commands is too long for the UAV to follow a leg</source>
        <translation>tiden mellem to kommandoer er for lang til, at dronen kan følge en etape</translation>
    </message>
    <message>
        <source>must not be exceeded: wind of %1, limit %2</source>
        <translation>må ikke overskrides: vind på %1, grænse %2</translation>
    </message>
    <message>
        <source>must not be exceeded: gusts of %1, limit %2</source>
        <translation>må ikke overskrides: vindstød på %1, grænse %2</translation>
    </message>
    <message>
        <source>this weather brings icing at its altitude, in which the UAV must not be flown</source>
        <translation>dette vejr giver isning i dronens højde, og dronen må ikke flyves i isning</translation>
    </message>
    <message>
        <source>leaves less reserve than waiting for the other UAVs of the altitude layer may take, %1; separate altitudes, or a greater reserve, avoid it</source>
        <translation>giver mindre reserve, end det kan tage at vente på de andre droner i højdelaget, %1; forskellige højder eller en større reserve forhindrer det</translation>
    </message>
    <message>
        <source>keeps %1 free for a recovery slot, as other UAVs of the altitude layer land on the same pad; separate altitudes or pads avoid it</source>
        <translation>holder %1 fri til et landingsvindue, fordi andre droner i højdelaget lander på samme plads; forskellige højder eller pladser forhindrer det</translation>
    </message>
    <message>
        <source>with the usual errors in wind and airspeed, 1 flight in 20 uses %1 or more of the reserve to come home</source>
        <translation>med sædvanlige fejl i vind og flyvefart bruger 1 ud af 20 flyvninger %1 eller mere af reserven på at komme hjem</translation>
    </message>
    <message>
        <source>with the usual errors in wind and airspeed, in 1 flight in 20 the wind is too strong to come home</source>
        <translation>med sædvanlige fejl i vind og flyvefart er vinden for stærk til at komme hjem i 1 ud af 20 flyvninger</translation>
    </message>
    <message>
        <source>the plan leads out of the range of the ground station for %1</source>
        <translation>planen fører uden for jordstationens rækkevidde i %1</translation>
    </message>
    <message>
        <source>the operation may enter the airspace &quot;%1&quot;, which begins at %2</source>
        <translation>operationen kan komme ind i luftrummet »%1«, som begynder i %2 højde</translation>
    </message>
    <message>
        <source>starts outside the area</source>
        <translation>starter uden for området</translation>
    </message>
    <message>
        <source>lies where another iceberg lies: is it the same one?</source>
        <translation>ligger, hvor et andet isbjerg ligger: er det det samme?</translation>
    </message>
    <message>
        <source>is too far away to reach before the run ends</source>
        <translation>er for langt væk til at kunne nås, før flyvningen er slut</translation>
    </message>
    <message>
        <source>the recorded track ends before the run does; from then on the iceberg stands still</source>
        <translation>det registrerede spor slutter før flyvningen; derefter ligger isbjerget stille</translation>
    </message>
    <message>
        <source>the recorded track begins so far from the estimate that the UAV will not see the iceberg there</source>
        <translation>det registrerede spor begynder så langt fra estimatet, at dronen ikke ser isbjerget der</translation>
    </message>
    <message>
        <source>the asset lies inside an iceberg</source>
        <translation>objektet ligger inde i et isbjerg</translation>
    </message>
    <message>
        <source>more icebergs than can be proven optimal; the plan comes with a bound</source>
        <translation>for mange isbjerge til at bevise planen optimal; planen får en grænse</translation>
    </message>
    <message>
        <source>this policy plans icebergs one by one; nearby icebergs are not grouped</source>
        <translation>denne strategi planlægger isbjerge ét for ét; nære isbjerge grupperes ikke</translation>
    </message>
    <message>
        <source>this solver cannot plan so many icebergs: choose Automatic (auto)</source>
        <translation>denne løser kan ikke planlægge så mange isbjerge: vælg Automatisk (auto)</translation>
    </message>
    <message>
        <source>is of no format that Bergwatch recognises; if it is a table, name its columns for latitude and longitude; known formats: %1</source>
        <translation>har ikke et format, som Bergwatch kender; hvis det er en tabel, så angiv kolonnerne for bredde og længde; kendte formater: %1</translation>
    </message>
    <message>
        <source>latitude must be between -90 and 90, minutes below 60</source>
        <translation>bredden skal være fra -90 til 90, minutterne under 60</translation>
    </message>
    <message>
        <source>longitude must be between -180 and 360, minutes below 60</source>
        <translation>længden skal være fra -180 til 360, minutterne under 60</translation>
    </message>
    <message>
        <source>iceberg %1</source>
        <translation>isbjerg %1</translation>
    </message>
    <message>
        <source>UAV %1</source>
        <translation>Drone %1</translation>
    </message>
    <message>
        <source>%1 h before the start; the iceberg may be %2 from this position, %3 times the field of view</source>
        <translation>%1 t før starten; isbjerget kan være %2 fra denne position, %3 gange synsfeltet</translation>
    </message>
    <message>
        <source>a file holds one UAV: %1 files are written, named after the UAVs</source>
        <translation>en fil har plads til én drone: der skrives %1 filer med navn efter dronerne</translation>
    </message>
    <message>
        <source>the scenario has no start time, so the file has no dates</source>
        <translation>scenariet har intet starttidspunkt, så filen har ingen datoer</translation>
    </message>
    <message>
        <source>the geofence is left out: the format has no place for it</source>
        <translation>geohegnet udelades: formatet har ikke plads til det</translation>
    </message>
    <message>
        <source>no-fly areas and the stand-off ring are left out: the format has no place for them</source>
        <translation>flyveforbudsområder og sikkerhedsringen udelades: formatet har ikke plads til dem</translation>
    </message>
    <message>
        <source>no-fly areas have no heights: those at the altitude of the UAV are written</source>
        <translation>flyveforbudsområder har ingen højder: dem i dronens højde skrives</translation>
    </message>
    <message>
        <source>%1 may draw the fence the long way round: it crosses the antimeridian</source>
        <translation>%1 tegner muligvis hegnet den lange vej rundt: det krydser 180°-meridianen</translation>
    </message>
    <message>
        <source>the places where icebergs were reached are written, not the track</source>
        <translation>stederne, hvor isbjerge blev nået, skrives, ikke sporet</translation>
    </message>
    <message>
        <source>the path becomes %1 waypoints within %2 m of it</source>
        <translation>banen bliver til %1 rutepunkter inden for %2 m af den</translation>
    </message>
    <message>
        <source>%1 keeps acceptance radii up to %3 m: %2 m becomes %3 m</source>
        <translation>%1 gemmer acceptradier op til %3 m: %2 m bliver til %3 m</translation>
    </message>
    <message>
        <source>%1 keeps loiter radii above 255 m in steps of 10 m: %2 m becomes %3 m</source>
        <translation>%1 gemmer kredsradier over 255 m i trin på 10 m: %2 m bliver til %3 m</translation>
    </message>
    <message>
        <source>%1 reads the cruise speed as a whole number: %2 m/s becomes %3 m/s; the speed in the mission is exact</source>
        <translation>%1 læser marchfarten som et helt tal: %2 m/s bliver til %3 m/s; farten i missionen er nøjagtig</translation>
    </message>
    <message>
        <source>the file is about the whole flight, whatever is chosen to be exported</source>
        <translation>filen handler om hele flyvningen, uanset hvad du vælger at eksportere</translation>
    </message>
    <message>
        <source>UAVs without an iceberg to visit: %1</source>
        <translation>Droner uden et isbjerg at besøge: %1</translation>
    </message>
    <message>
        <source>straight legs that lead out of the geofence or through a no-fly area: %1; export the path instead, which leads round</source>
        <translation>lige etaper, der fører ud af geohegnet eller gennem et flyveforbudsområde: %1; eksportér i stedet banen, som fører udenom</translation>
    </message>
    <message>
        <source>only this sortie is exported; icebergs left for later sorties: %1</source>
        <translation>kun dette togt eksporteres; isbjerge, der er tilbage til senere togter: %1</translation>
    </message>
    <message>
        <source>nothing in the file depends on %1</source>
        <translation>intet i filen afhænger af %1</translation>
    </message>
    <message>
        <source>velocity unknown</source>
        <translation>hastighed ukendt</translation>
    </message>
    <message>
        <source>no time: counts as seen at the start</source>
        <translation>uden tid: regnes som set ved start</translation>
    </message>
    <message>
        <source>velocity from the file</source>
        <translation>hastighed fra filen</translation>
    </message>
    <message>
        <source>velocity limited to 5 m/s per axis</source>
        <translation>hastighed begrænset til 5 m/s pr. akse</translation>
    </message>
    <message>
        <source>q estimated</source>
        <translation>q anslået</translation>
    </message>
    <message>
        <source>q limited to 10⁶ m²/s</source>
        <translation>q begrænset til 10⁶ m²/s</translation>
    </message>
    <message>
        <source>stationary</source>
        <translation>ligger stille</translation>
    </message>
    <message>
        <source>several sightings at one time</source>
        <translation>flere observationer på samme tidspunkt</translation>
    </message>
    <message>
        <source>sightings at impossible places not used</source>
        <translation>observationer på umulige steder er ikke brugt</translation>
    </message>
    <message>
        <source>recorded track attached</source>
        <translation>registreret spor er tilføjet</translation>
    </message>
    <message>
        <source>no track: not sighted after the start</source>
        <translation>intet spor: ikke observeret efter starten</translation>
    </message>
    <message>
        <source>older than what the scenario has</source>
        <translation>ældre end det, scenariet har</translation>
    </message>
    <message>
        <source>sighted only after the start</source>
        <translation>først observeret efter starten</translation>
    </message>
    <message>
        <source>more than 1000 km from the origin at the start</source>
        <translation>mere end 1000 km fra origo ved starten</translation>
    </message>
    <message>
        <source>the scenario is full</source>
        <translation>scenariet er fuldt</translation>
    </message>
    <message>
        <source>a UAV has this id</source>
        <translation>en drone har dette id</translation>
    </message>
    <message>
        <source>the file&apos;s drift contradicts the positions: not used</source>
        <translation>filens drift modsiger positionerne: ikke brugt</translation>
    </message>
    <message>
        <source>faster than 1.5 m/s</source>
        <translation>hurtigere end 1,5 m/s</translation>
    </message>
    <message>
        <source>on land</source>
        <translation>på land</translation>
    </message>
    <message numerus="yes">
        <source>%n UAV(s) taken over</source>
        <translation>
            <numerusform>%n drone taget med</numerusform>
            <numerusform>%n droner taget med</numerusform>
        </translation>
    </message>
    <message>
        <source>area taken over</source>
        <translation>området taget med</translation>
    </message>
    <message>
        <source>area taken over as geofence</source>
        <translation>området taget med som geohegn</translation>
    </message>
    <message>
        <source>asset taken over</source>
        <translation>objektet taget med</translation>
    </message>
    <message numerus="yes">
        <source>%n no-fly area(s) taken over</source>
        <translation>
            <numerusform>%n flyveforbudsområde taget med</numerusform>
            <numerusform>%n flyveforbudsområder taget med</numerusform>
        </translation>
    </message>
    <message>
        <source>UAVs, area and asset of the file not taken over: the scenario is in use</source>
        <translation>droner, område og objekt i filen er ikke taget med: scenariet er i brug</translation>
    </message>
    <message numerus="yes">
        <source>%n UAV(s) left out: too many</source>
        <translation>
            <numerusform>%n drone udeladt: for mange</numerusform>
            <numerusform>%n droner udeladt: for mange</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n UAV(s) left out: more than 1000 km east, west, north or south of the origin</source>
        <translation>
            <numerusform>%n drone udeladt: mere end 1000 km øst, vest, nord eller syd for origo</numerusform>
            <numerusform>%n droner udeladt: mere end 1000 km øst, vest, nord eller syd for origo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n area(s) left out: unreadable</source>
        <translation>
            <numerusform>%n ulæseligt område udeladt</numerusform>
            <numerusform>%n ulæselige områder udeladt</numerusform>
        </translation>
    </message>
    <message>
        <source>area left out: too few or too many corners</source>
        <translation>området udeladt: for få eller for mange hjørner</translation>
    </message>
    <message>
        <source>area left out: more than 1000 km east, west, north or south of the origin</source>
        <translation>området udeladt: mere end 1000 km øst, vest, nord eller syd for origo</translation>
    </message>
    <message>
        <source>area left out: it touches or crosses itself</source>
        <translation>området udeladt: det rører eller krydser sig selv</translation>
    </message>
    <message>
        <source>area left out: it is in several parts</source>
        <translation>området udeladt: det består af flere dele</translation>
    </message>
    <message numerus="yes">
        <source>%n further area(s) left out</source>
        <translation>
            <numerusform>%n yderligere område udeladt</numerusform>
            <numerusform>%n yderligere områder udeladt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s) of the area left out</source>
        <translation>
            <numerusform>%n hul i området udeladt</numerusform>
            <numerusform>%n huller i området udeladt</numerusform>
        </translation>
    </message>
    <message>
        <source>area is no geofence: too many corners</source>
        <translation>området er ikke et geohegn: for mange hjørner</translation>
    </message>
    <message>
        <source>area is no geofence: a UAV starts or lands outside</source>
        <translation>området er ikke et geohegn: en drone starter eller lander udenfor</translation>
    </message>
    <message numerus="yes">
        <source>%n no-fly area(s) left out: a UAV starts or lands inside, or the heights are wrong</source>
        <translation>
            <numerusform>%n flyveforbudsområde udeladt: en drone starter eller lander i det, eller højderne er forkerte</numerusform>
            <numerusform>%n flyveforbudsområder udeladt: en drone starter eller lander i dem, eller højderne er forkerte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rally point(s) left out</source>
        <translation>
            <numerusform>%n samlingspunkt udeladt</numerusform>
            <numerusform>%n samlingspunkter udeladt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n further asset(s) left out</source>
        <translation>
            <numerusform>%n yderligere objekt udeladt</numerusform>
            <numerusform>%n yderligere objekter udeladt</numerusform>
        </translation>
    </message>
    <message>
        <source>asset left out: more than 1000 km east, west, north or south of the origin</source>
        <translation>objektet udeladt: mere end 1000 km øst, vest, nord eller syd for origo</translation>
    </message>
    <message numerus="yes">
        <source>%n number(s) out of range left out</source>
        <translation>
            <numerusform>%n tal uden for grænserne udeladt</numerusform>
            <numerusform>%n tal uden for grænserne udeladt</numerusform>
        </translation>
    </message>
    <message>
        <source>there is no take-off item: launch the UAV by hand and start the mission in the air</source>
        <translation>missionen har intet startelement: kast dronen med hånden, og start missionen i luften</translation>
    </message>
    <message>
        <source>after the last iceberg the mission returns home, %1 m that the plan does not include</source>
        <translation>efter det sidste isbjerg flyver dronen hjem, %1 m, som ikke er med i planen</translation>
    </message>
    <message>
        <source>the mission ends in an endless loiter: command the return yourself</source>
        <translation>missionen slutter med en kredsning uden ende: giv selv kommandoen til at flyve hjem</translation>
    </message>
    <message>
        <source>%1 has no loiter by turns: the time that they take is written</source>
        <translation>%1 kan ikke tælle kredsninger: filen indeholder den tid, de tager</translation>
    </message>
    <message>
        <source>loiter turns are left out: a VTOL or multirotor flies over each iceberg</source>
        <translation>kredsninger udelades: en VTOL eller multirotor flyver over hvert isbjerg</translation>
    </message>
    <message>
        <source>%1 uses the acceptance radius of its parameter %2, not that of the file</source>
        <translation>%1 bruger acceptradiussen i sin parameter %2, ikke den i filen</translation>
    </message>
    <message>
        <source>%1 keeps to the fence only if its parameter %2 says so</source>
        <translation>%1 holder sig kun til hegnet, hvis parameteren %2 siger det</translation>
    </message>
    <message>
        <source>the first row is home, which %1 does not have: upload the file with QGroundControl</source>
        <translation>den første række er hjemmepunktet, som %1 ikke har: upload filen med QGroundControl</translation>
    </message>
    <message>
        <source>the first iceberg is %2 m from the start, but the climb takes %1 m</source>
        <translation>det første isbjerg er %2 m fra starten, men stigningen tager %1 m</translation>
    </message>
    <message>
        <source>the first iceberg is %2 m from the start: %1 may refuse more than %3 m (MIS_DIST_1WP)</source>
        <translation>det første isbjerg er %2 m fra starten: %1 kan afvise mere end %3 m (MIS_DIST_1WP)</translation>
    </message>
    <message>
        <source>legs of take-off, return and landing that lead out of the geofence or through a no-fly area: %1</source>
        <translation>etaper ved start, hjemflyvning og landing, der fører ud af geohegnet eller gennem et flyveforbudsområde: %1</translation>
    </message>
    <message>
        <source>the landing approach leads over land</source>
        <translation>indflyvningen går over land</translation>
    </message>
    <message>
        <source>the landing approach descends at %1°, more than the usual %2°: make it longer or lower</source>
        <translation>indflyvningen går ned med %1°, mere end de sædvanlige %2°: gør den længere eller lavere</translation>
    </message>
    <message>
        <source>waypoints within their acceptance radius of the one before, which the UAV may skip: %1</source>
        <translation>rutepunkter inden for deres acceptradius fra det forrige, som dronen kan springe over: %1</translation>
    </message>
    <message>
        <source>the mission has %2 items; %1 holds about %3</source>
        <translation>missionen har %2 elementer; %1 har plads til omkring %3</translation>
    </message>
    <message>
        <source>airspace areas that the mission enters at its altitudes: %1</source>
        <translation>luftrumsområder, som missionen kommer ind i med sine flyvehøjder: %1</translation>
    </message>
    <message>
        <source>with climb, return and landing the mission takes %1 min; the endurance without reserve is %2 min</source>
        <translation>med stigning, hjemflyvning og landing tager missionen %1 min; udholdenheden uden reserven er %2 min</translation>
    </message>
    <message>
        <source>%1 is no link: write udp:HOST:PORT to listen, udpout:HOST:PORT, tcp:HOST:PORT or serial:DEVICE:BAUD</source>
        <translation>%1 er ikke en forbindelse: skriv udp:VÆRT:PORT for at lytte, udpout:VÆRT:PORT, tcp:VÆRT:PORT eller serial:ENHED:BAUD</translation>
    </message>
    <message>
        <source>%1 has no host: write an IPv4 address or a name</source>
        <translation>%1 har ingen vært: skriv en IPv4-adresse eller et navn</translation>
    </message>
    <message>
        <source>%1 has no port from 1 to 65535</source>
        <translation>%1 har ingen port fra 1 til 65535</translation>
    </message>
    <message>
        <source>%1 has no device: write a path such as /dev/ttyUSB0</source>
        <translation>%1 har ingen enhed: skriv en sti som /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>%1 has no baud rate of a serial port, such as 57600 or 115200</source>
        <translation>%1 har ingen baudhastighed for en seriel port, som 57600 eller 115200</translation>
    </message>
    <message>
        <source>only %1 of %2 icebergs found a place at least %3 from the others: choose fewer icebergs, a smaller spacing or a larger area</source>
        <translation>kun %1 af %2 isbjerge fandt en plads mindst %3 fra de andre: vælg færre isbjerge, en mindre afstand eller et større område</translation>
    </message>
    <message>
        <source>a forecast holds from 1 to %1 places, not %2</source>
        <translation>en prognose har fra 1 til %1 steder, ikke %2</translation>
    </message>
    <message>
        <source>a forecast holds at most %1 entries at all places together, not %2</source>
        <translation>en prognose har højst %1 poster for alle steder tilsammen, ikke %2</translation>
    </message>
    <message>
        <source>the places must be a complete grid: rows from south to north, each from west to east</source>
        <translation>stederne skal være et fuldstændigt gitter: rækker fra syd til nord, hver fra vest til øst</translation>
    </message>
    <message>
        <source>must have at least one entry</source>
        <translation>skal have mindst én post</translation>
    </message>
    <message>
        <source>a scenario with a forecast needs a start date and time</source>
        <translation>et scenarie med prognose kræver dato og tid for starten</translation>
    </message>
    <message>
        <source>gives no %1 for %2 h of the run: the constant value of the scenario applies</source>
        <translation>giver ingen værdi (%1) for %2 t af kørslen: scenariets faste værdi gælder</translation>
    </message>
    <message>
        <source>has a gap in %1 from %2 h to %3 h after the start: the constant value of the scenario applies</source>
        <translation>har et hul (%1) fra %2 t til %3 t efter starten: scenariets faste værdi gælder</translation>
    </message>
    <message>
        <source>was issued %1 h before the start</source>
        <translation>blev udgivet %1 t før starten</translation>
    </message>
    <message>
        <source>this build reads no %1: install %2 and build Bergwatch again</source>
        <translation>denne version læser ikke %1: installér %2 og byg Bergwatch igen</translation>
    </message>
    <message>
        <source>is GRIB of edition %1; only edition 2 is read: convert it with grib_set -s edition=2</source>
        <translation>er GRIB i udgave %1; kun udgave 2 læses: konvertér filen med grib_set -s edition=2</translation>
    </message>
    <message>
        <source>holds no wind, weather or current on a grid of latitudes and longitudes</source>
        <translation>indeholder hverken vind, vejr eller strøm i et gitter af bredde- og længdegrader</translation>
    </message>
    <message>
        <source>the unit &quot;%1&quot; is not understood; it must be one of %2</source>
        <translation>enheden »%1« er ukendt; den skal være en af %2</translation>
    </message>
    <message>
        <source>the unit of time &quot;%1&quot; in the calendar &quot;%2&quot; is not understood</source>
        <translation>tidsenheden »%1« i kalenderen »%2« er ukendt</translation>
    </message>
    <message>
        <source>the forecast covers 180 degrees or more: choose an area</source>
        <translation>prognosen dækker 180 grader eller mere: vælg et område</translation>
    </message>
    <message>
        <source>the forecast has no values in the area</source>
        <translation>prognosen har ingen værdier i området</translation>
    </message>
    <message>
        <source>the forecast is for another time, from %1 to %2</source>
        <translation>prognosen gælder et andet tidsrum, fra %1 til %2</translation>
    </message>
    <message>
        <source>is no NMEA sentence</source>
        <translation>er ingen NMEA-sætning</translation>
    </message>
    <message>
        <source>its checksum is wrong or missing</source>
        <translation>kontrolsummen er forkert eller mangler</translation>
    </message>
    <message>
        <source>a field of the sentence is missing or wrong</source>
        <translation>et felt i sætningen mangler eller er forkert</translation>
    </message>
    <message>
        <source>the AIS message is cut or wrong</source>
        <translation>AIS-meddelelsen er afkortet eller forkert</translation>
    </message>
    <message>
        <source>another part of the AIS message is missing or out of order</source>
        <translation>en anden del af AIS-meddelelsen mangler eller kommer i forkert rækkefølge</translation>
    </message>
    <message>
        <source>a radar bearing needs the ship&apos;s position within the minute before, and a relative one its heading</source>
        <translation>en radarpejling kræver skibets position i minuttet før, og en relativ pejling også kursen</translation>
    </message>
    <message>
        <source>the radar target is a ship that reports by AIS</source>
        <translation>radarmålet er et skib, der melder sig med AIS</translation>
    </message>
    <message>
        <source>the data of the photograph cannot be read</source>
        <translation>dataene i fotografiet kan ikke læses</translation>
    </message>
    <message>
        <source>the photograph has no position; with its time, --run places it on the flown track</source>
        <translation>fotografiet har ingen position; med tiden placerer --run det på det fløjne spor</translation>
    </message>
    <message>
        <source>the photograph has no position, and its time is not in the flight</source>
        <translation>fotografiet har ingen position, og tiden er ikke i flyvningen</translation>
    </message>
    <message>
        <source>this build reads no photographs: it was made without libexiv2</source>
        <translation>denne version læser ingen fotografier: den er bygget uden libexiv2</translation>
    </message>
    <message>
        <source>sightings for an ice service need dates: give the scenario a start time</source>
        <translation>observationer til en istjeneste skal have datoer: giv scenariet en starttid</translation>
    </message>
    <message>
        <source>photograph %1</source>
        <translation>fotografi %1</translation>
    </message>
    <message>
        <source>an ice chart holds at most %1 areas, not %2</source>
        <translation>et iskort har højst %1 områder, ikke %2</translation>
    </message>
    <message>
        <source>the outlines of an ice chart hold at most %1 corners together, not %2</source>
        <translation>omridsene i et iskort har højst %1 hjørner tilsammen, ikke %2</translation>
    </message>
    <message>
        <source>an ice area needs outlines of at least 3 corners</source>
        <translation>et isområde kræver omrids med mindst 3 hjørner</translation>
    </message>
    <message>
        <source>the ice chart is %1 hours older than the start: ice has moved since</source>
        <translation>iskortet er %1 timer ældre end starten: isen har flyttet sig siden</translation>
    </message>
    <message>
        <source>is no ice chart: it has no polygons with concentrations (CT, POLY_TYPE of SIGRID-3)</source>
        <translation>er ikke et iskort: filen har ingen polygoner med koncentrationer (CT, POLY_TYPE i SIGRID-3)</translation>
    </message>
    <message>
        <source>holds no ice-chart area within %1 km of the scenario</source>
        <translation>indeholder ikke noget isområde inden for %1 km af scenariet</translation>
    </message>
    <message>
        <source>is read with ogr2ogr: install gdal-bin</source>
        <translation>læses med ogr2ogr: installer gdal-bin</translation>
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
        <translation>ogr2ogr mislykkedes uden at angive en grund (%1)</translation>
    </message>
    <message>
        <source>ogr2ogr was stopped after %1 s</source>
        <translation>ogr2ogr blev stoppet efter %1 s</translation>
    </message>
    <message>
        <source>ogr2ogr did not print GeoJSON</source>
        <translation>ogr2ogr skrev ikke GeoJSON</translation>
    </message>
    <message>
        <source>holds no features</source>
        <translation>indeholder ingen objekter</translation>
    </message>
    <message>
        <source>the archive holds several files that ogr2ogr can read: %1; unpack the one that you need</source>
        <translation>arkivet indeholder flere filer, som ogr2ogr kan læse: %1; udpak den, du skal bruge</translation>
    </message>
    <message>
        <source>ice area left out: its outline cannot be read</source>
        <translation>isområde udeladt: omridset kan ikke læses</translation>
    </message>
    <message>
        <source>the times along paths and tracks are left out: the format has no place for them</source>
        <translation>tiderne langs baner og spor udelades: formatet har ikke plads til dem</translation>
    </message>
    <message>
        <source>there is a Shapefile each for points, lines and areas; names of properties are cut to 10 letters, texts to 254 bytes</source>
        <translation>der er en Shapefile hver for punkter, linjer og områder; navne på egenskaber afkortes til 10 bogstaver, tekster til 254 byte</translation>
    </message>
    <message>
        <source>coordinates are metres of EPSG:%1; names, numbers and times are left out</source>
        <translation>koordinaterne er meter i EPSG:%1; navne, tal og tider udelades</translation>
    </message>
    <message>
        <source>must not be exceeded: wind of %1 is forecast for %3 UTC, limit %2</source>
        <translation>må ikke overskrides: der er varslet vind på %1 kl. %3 UTC, grænse %2</translation>
    </message>
    <message>
        <source>must not be exceeded: gusts of %1 are forecast for %3 UTC, limit %2</source>
        <translation>må ikke overskrides: der er varslet vindstød på %1 kl. %3 UTC, grænse %2</translation>
    </message>
    <message>
        <source>visibility of %1 is forecast for %3 UTC, limit %2</source>
        <translation>der er varslet sigt på %1 kl. %3 UTC, grænse %2</translation>
    </message>
    <message>
        <source>a cloud base of %1 is forecast for %3 UTC, limit %2</source>
        <translation>der er varslet skybase på %1 kl. %3 UTC, grænse %2</translation>
    </message>
    <message>
        <source>icing is forecast at its altitude for %1 UTC, in which the UAV must not be flown</source>
        <translation>der er varslet isdannelse i UAV&apos;ens højde kl. %1 UTC, og den må ikke flyve i isdannelse</translation>
    </message>
    <message>
        <source>is nearly reached: %1 is forecast for %3 UTC, limit %2</source>
        <translation>er næsten nået: %1 er varslet kl. %3 UTC, grænse %2</translation>
    </message>
    <message>
        <source>cannot be checked from %1 UTC on, because the forecast does not give a value</source>
        <translation>kan ikke kontrolleres fra kl. %1 UTC, fordi prognosen mangler værdien</translation>
    </message>
    <message>
        <source>cannot be checked without a forecast that gives this quantity</source>
        <translation>kan ikke kontrolleres uden en prognose, der giver denne størrelse</translation>
    </message>
</context>
<context>
    <name>LinkText</name>
    <message>
        <source>Mission</source>
        <translation>Mission</translation>
    </message>
    <message>
        <source>Fence</source>
        <translation>Hegn</translation>
    </message>
    <message>
        <source>Rally points</source>
        <translation>Samlingspunkter</translation>
    </message>
    <message>
        <source>the aircraft does not answer</source>
        <translation>luftfartøjet svarer ikke</translation>
    </message>
    <message>
        <source>the aircraft stopped answering at item %1</source>
        <translation>luftfartøjet holdt op med at svare ved punkt %1</translation>
    </message>
    <message>
        <source>the aircraft refuses it (result %1)</source>
        <translation>luftfartøjet afviser det (resultat %1)</translation>
    </message>
    <message>
        <source>the aircraft requests an item that does not exist</source>
        <translation>luftfartøjet beder om et punkt, der ikke findes</translation>
    </message>
    <message>
        <source>the aircraft announces too many items</source>
        <translation>luftfartøjet melder for mange punkter</translation>
    </message>
    <message>
        <source>the numbers of items differ</source>
        <translation>antallet af punkter er forskelligt</translation>
    </message>
    <message>
        <source>item %1, %2</source>
        <translation>punkt %1, %2</translation>
    </message>
    <message>
        <source>Aircraft %1</source>
        <translation>Luftfartøj %1</translation>
    </message>
    <message>
        <source>Opening the link…</source>
        <translation>Åbner forbindelsen…</translation>
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
        <translation>%1 af %2</translation>
    </message>
    <message>
        <source>%1: uploading, %2</source>
        <translation>%1: sender, %2</translation>
    </message>
    <message>
        <source>%1: reading back, %2</source>
        <translation>%1: læser tilbage, %2</translation>
    </message>
    <message>
        <source>On board: same as the plan</source>
        <translation>Om bord: samme som planen</translation>
    </message>
    <message>
        <source>On board: same as the plan. The aircraft has no rally points</source>
        <translation>Om bord: samme som planen. Luftfartøjet har ingen samlingspunkter</translation>
    </message>
    <message>
        <source>On board differs. %1: %2</source>
        <translation>Om bord afviger. %1: %2</translation>
    </message>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1 mislykkedes: %2</translation>
    </message>
    <message>
        <source>heard for the first time</source>
        <translation>hørt for første gang</translation>
    </message>
    <message>
        <source>contact lost</source>
        <translation>kontakten er mistet</translation>
    </message>
    <message>
        <source>contact again</source>
        <translation>kontakt igen</translation>
    </message>
    <message>
        <source>mode %1</source>
        <translation>tilstand %1</translation>
    </message>
    <message>
        <source>item %1 reached</source>
        <translation>punkt %1 nået</translation>
    </message>
    <message>
        <source>a command was not answered</source>
        <translation>en kommando blev ikke besvaret</translation>
    </message>
    <message>
        <source>command accepted</source>
        <translation>kommando accepteret</translation>
    </message>
    <message>
        <source>command refused (result %1)</source>
        <translation>kommando afvist (resultat %1)</translation>
    </message>
    <message>
        <source>Another ground station uses the same id: sending is off</source>
        <translation>En anden jordstation bruger samme id: afsendelse er slået fra</translation>
    </message>
    <message>
        <source>Waiting for guided mode</source>
        <translation>Venter på ledet tilstand</translation>
    </message>
    <message>
        <source>Waiting until the mission is flown</source>
        <translation>Venter, til missionen flyves</translation>
    </message>
    <message>
        <source>Guiding from iceberg to iceberg</source>
        <translation>Leder fra isbjerg til isbjerg</translation>
    </message>
    <message>
        <source>Replacing the mission when the plan changes</source>
        <translation>Erstatter missionen, når planen ændres</translation>
    </message>
    <message>
        <source>The pilot has taken over: nothing is sent</source>
        <translation>Piloten har overtaget: intet sendes</translation>
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
        <translation>højdereference</translation>
    </message>
    <message>
        <source>latitude</source>
        <translation>breddegrad</translation>
    </message>
    <message>
        <source>longitude</source>
        <translation>længdegrad</translation>
    </message>
    <message>
        <source>altitude</source>
        <translation>højde</translation>
    </message>
    <message>
        <source>parameter %1</source>
        <translation>parameter %1</translation>
    </message>
    <message>
        <source>Guiding begins when the flight in this window follows the aircraft</source>
        <translation>Styringen begynder, når flyvningen i dette vindue følger luftfartøjet</translation>
    </message>
    <message>
        <source>Replacing the mission begins when the flight in this window follows the aircraft</source>
        <translation>Missionen erstattes først, når flyvningen i dette vindue følger luftfartøjet</translation>
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
        <translation>Skriv map.png, zeta.png og sigma.png for en flyvning, eller for hele flyvningen af et scenarie, i &lt;mappe&gt;; med --theme both også map-dark.png, zeta-dark.png og sigma-dark.png.</translation>
    </message>
    <message>
        <source>Overwrite existing files.</source>
        <translation>Overskriv filer, der findes.</translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation>Der er ikke nok hukommelse.</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>mappe</translation>
    </message>
    <message>
        <source>Size of each picture in pixels, e.g. 1920x1080 (default: 1600x1000 for the map, 1600x700 for the charts).</source>
        <translation>Hvert billedes størrelse i pixels, f.eks. 1920x1080 (standard: 1600x1000 for kortet, 1600x700 for diagrammerne).</translation>
    </message>
    <message>
        <source>WxH</source>
        <comment>width x height</comment>
        <translation>BxH</translation>
    </message>
    <message>
        <source>Appearance of the pictures: light, dark or both.</source>
        <translation>Billedernes udseende: light (lyst), dark (mørkt) eller both (begge).</translation>
    </message>
    <message>
        <source>theme</source>
        <translation>tema</translation>
    </message>
    <message>
        <source>--size: &quot;%1&quot; is not a size like 1920x1080 with sides from %2 to %3 pixels.</source>
        <translation>--size: »%1« er ikke en størrelse som 1920x1080 med sider fra %2 til %3 pixels.</translation>
    </message>
    <message>
        <source>--theme: &quot;%1&quot; is not light, dark or both.</source>
        <translation>--theme: »%1« er hverken light, dark eller both.</translation>
    </message>
    <message>
        <source>--pictures: the name of a folder is missing.</source>
        <translation>--pictures: navnet på en mappe mangler.</translation>
    </message>
    <message>
        <source>Opens the window with a scenario; with --pictures it only writes pictures.</source>
        <translation>Åbner vinduet med et scenarie; med --pictures skriver programmet kun billeder.</translation>
    </message>
    <message>
        <source>file</source>
        <translation>fil</translation>
    </message>
    <message>
        <source>Name one run or scenario file; %1 were named.</source>
        <translation>Angiv én flyvnings- eller scenariefil; %1 blev angivet.</translation>
    </message>
    <message>
        <source>Bergwatch has crashed: %1</source>
        <translation>Bergwatch er gået ned: %1</translation>
    </message>
    <message>
        <source>Write a picture of the window with the scenario to &lt;file&gt;, then exit.</source>
        <translation>Skriv et billede af vinduet med scenariet i &lt;fil&gt;, og afslut.</translation>
    </message>
    <message>
        <source>Fly until this time before the screenshot.</source>
        <translation>Flyv til dette tidspunkt før skærmbilledet.</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>sekunder</translation>
    </message>
    <message>
        <source>Store settings in &lt;file&gt; instead of your own settings file.</source>
        <translation>Gem indstillinger i &lt;fil&gt; i stedet for din egen indstillingsfil.</translation>
    </message>
    <message>
        <source>--size: &quot;%1&quot; is not a size like 1920x1080.</source>
        <translation>--size: »%1« er ikke en størrelse som 1920x1080.</translation>
    </message>
    <message>
        <source>--theme: &quot;%1&quot; is not light or dark.</source>
        <translation>--theme: »%1« er hverken light eller dark.</translation>
    </message>
    <message>
        <source>--at: &quot;%1&quot; is not a number of seconds.</source>
        <translation>--at: »%1« er ikke et antal sekunder.</translation>
    </message>
    <message>
        <source>Name at most one scenario file; %1 were named.</source>
        <translation>Angiv højst én scenariefil; %1 blev angivet.</translation>
    </message>
    <message>
        <source>The command &quot;export&quot; writes plans and flights as files, maps, charts and briefs: see &quot;bergwatch export --help&quot;.</source>
        <translation>Kommandoen »export« skriver planer og flyvninger som filer, kort, diagrammer og flyvebriefinger: se »bergwatch export --help«.</translation>
    </message>
    <message>
        <source>Write the manual as web pages and as PDF into &lt;folder&gt;, which has its pictures.</source>
        <translation>Skriv håndbogen som websider og som PDF i &lt;mappe&gt;, hvor billederne ligger.</translation>
    </message>
    <message>
        <source>--manual takes no scenario file, --pictures or --screenshot.</source>
        <translation>--manual tager hverken en scenariefil, --pictures eller --screenshot.</translation>
    </message>
    <message>
        <source>Longest wait before the screenshot for predictions and the lower bound, in seconds.</source>
        <translation>Længste ventetid før skærmbilledet på forudsigelser og nedre grænse, i sekunder.</translation>
    </message>
    <message>
        <source>--wait: &quot;%1&quot; is not a number of seconds up to %2.</source>
        <translation>--wait: »%1« er ikke et antal sekunder op til %2.</translation>
    </message>
    <message>
        <source>A scenario (.berg), run (.bergrun), study (.bergstudy) or telemetry log (.tlog).</source>
        <translation>Et scenarie (.berg), en flyvning (.bergrun), et studie (.bergstudy) eller en telemetrilog (.tlog).</translation>
    </message>
</context>
<context>
    <name>ManualPages</name>
    <message>
        <source>Contents</source>
        <translation>Indhold</translation>
    </message>
    <message>
        <source>The Bergwatch manual</source>
        <translation>Bergwatch-håndbogen</translation>
    </message>
</context>
<context>
    <name>ManualText</name>
    <message>
        <source>en</source>
        <comment>folder of the manual in this language</comment>
        <translation>en</translation>
    </message>
</context>
<context>
    <name>MapEdits</name>
    <message numerus="yes">
        <source>Delete %n objects</source>
        <translation>
            <numerusform>Slet %n objekt</numerusform>
            <numerusform>Slet %n objekter</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete UAV</source>
        <translation>Slet drone</translation>
    </message>
    <message>
        <source>Remove asset</source>
        <translation>Fjern objekt</translation>
    </message>
    <message>
        <source>Remove area</source>
        <translation>Fjern område</translation>
    </message>
    <message>
        <source>Remove no-fly area</source>
        <translation>Fjern flyveforbudsområde</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n icebergs</source>
        <translation>
            <numerusform>Slet isbjerg</numerusform>
            <numerusform>Slet %n isbjerge</numerusform>
        </translation>
    </message>
    <message>
        <source>The last UAV cannot be deleted: a scenario needs at least one.</source>
        <translation>Den sidste drone kan ikke slettes: et scenarie skal have mindst én.</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n icebergs</source>
        <translation>
            <numerusform>Klip isbjerg</numerusform>
            <numerusform>Klip %n isbjerge</numerusform>
        </translation>
    </message>
    <message>
        <source>There are no icebergs on the clipboard.</source>
        <translation>Der er ingen isbjerge i udklipsholderen.</translation>
    </message>
    <message>
        <source>The clipboard content cannot be pasted. %1</source>
        <translation>Indholdet af udklipsholderen kan ikke sættes ind. %1</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n icebergs</source>
        <translation>
            <numerusform>Sæt isbjerg ind</numerusform>
            <numerusform>Sæt %n isbjerge ind</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n icebergs</source>
        <translation>
            <numerusform>Duplikér isbjerg</numerusform>
            <numerusform>Duplikér %n isbjerge</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n UAVs</source>
        <translation>
            <numerusform>Duplikér drone</numerusform>
            <numerusform>Duplikér %n droner</numerusform>
        </translation>
    </message>
    <message>
        <source>Add UAV</source>
        <translation>Tilføj drone</translation>
    </message>
    <message>
        <source>Add iceberg</source>
        <translation>Tilføj isbjerg</translation>
    </message>
</context>
<context>
    <name>MapLayoutText</name>
    <message>
        <source>lost</source>
        <translation>mistet</translation>
    </message>
    <message>
        <source>given up</source>
        <translation>opgivet</translation>
    </message>
</context>
<context>
    <name>MapLegend</name>
    <message>
        <source>In view now: σ is 0</source>
        <translation>I synsfeltet nu: σ er 0</translation>
    </message>
    <message>
        <source>Plan, next leg thicker</source>
        <translation>Plan, næste etape tykkere</translation>
    </message>
    <message>
        <source>Flown, older parts fainter</source>
        <translation>Fløjet, ældre dele svagere</translation>
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
        <translation>Usikkerhed σ</translation>
    </message>
    <message>
        <source>Appears later, with time</source>
        <translation>Kommer senere, med tidspunkt</translation>
    </message>
    <message>
        <source>Compared: %1</source>
        <translation>Sammenlignet: %1</translation>
    </message>
    <message>
        <source>Plan before the change</source>
        <translation>Planen før ændringen</translation>
    </message>
    <message>
        <source>Seen so far</source>
        <translation>Set hidtil</translation>
    </message>
    <message>
        <source>In view</source>
        <translation>I synsfeltet</translation>
    </message>
    <message>
        <source>Appears later</source>
        <translation>Kommer senere</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Point aimed at</source>
        <translation>Punkt, der sigtes mod</translation>
    </message>
    <message>
        <source>Aim point</source>
        <translation>Sigtepunkt</translation>
    </message>
    <message>
        <source>Former plan</source>
        <translation>Forrige plan</translation>
    </message>
    <message>
        <source>Flown</source>
        <translation>Fløjet</translation>
    </message>
    <message>
        <source>In view now</source>
        <translation>I synsfeltet nu</translation>
    </message>
    <message>
        <source>Lost: not found where expected</source>
        <translation>Mistet: ikke fundet, hvor det ventedes</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Mistet</translation>
    </message>
    <message>
        <source>Search given up</source>
        <translation>Eftersøgning opgivet</translation>
    </message>
    <message>
        <source>Given up</source>
        <translation>Opgivet</translation>
    </message>
    <message>
        <source>95 % position circle</source>
        <translation>95 %-positionscirkel</translation>
    </message>
    <message>
        <source>95 % circle</source>
        <translation>95 %-cirkel</translation>
    </message>
    <message>
        <source>True position</source>
        <translation>Sand position</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>Sandhed</translation>
    </message>
    <message>
        <source>Will enter inner ring</source>
        <translation>Kommer ind i den indre ring</translation>
    </message>
    <message>
        <source>Enters ring</source>
        <translation>Ind i ringen</translation>
    </message>
    <message>
        <source>Planned as one point</source>
        <translation>Planlagt som ét punkt</translation>
    </message>
    <message>
        <source>One point</source>
        <translation>Ét punkt</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Hjem</translation>
    </message>
    <message>
        <source>Geofence (kept if the UAV starts inside it)</source>
        <translation>Geohegn (overholdes, hvis dronen starter indenfor)</translation>
    </message>
    <message>
        <source>Geofence</source>
        <translation>Geohegn</translation>
    </message>
    <message>
        <source>Asset&apos;s range: more urgent inside</source>
        <translation>Objektets rækkevidde: haster mere indenfor</translation>
    </message>
    <message>
        <source>Asset&apos;s range</source>
        <translation>Objektets rækkevidde</translation>
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
        <translation>Eftersøgningsmønster</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Eftersøgning</translation>
    </message>
    <message>
        <source>UAVs too close to each other</source>
        <translation>Droner for tæt på hinanden</translation>
    </message>
    <message>
        <source>Too close</source>
        <translation>For tæt på</translation>
    </message>
    <message>
        <source>Assigned to the UAV of this colour</source>
        <translation>Tildelt dronen med denne farve</translation>
    </message>
    <message>
        <source>Assigned to one</source>
        <translation>Tildelt én</translation>
    </message>
    <message>
        <source>Point of no return</source>
        <translation>Sidste vendepunkt</translation>
    </message>
    <message>
        <source>Radio range of the ground station</source>
        <translation>Jordstationens radiorækkevidde</translation>
    </message>
    <message>
        <source>Radio range</source>
        <translation>Radiorækkevidde</translation>
    </message>
    <message>
        <source>No-fly area</source>
        <translation>Flyveforbudsområde</translation>
    </message>
    <message>
        <source>Stand-off round the asset</source>
        <translation>Sikkerhedsafstand omkring objektet</translation>
    </message>
    <message>
        <source>Stand-off</source>
        <translation>Sikkerhedsafstand</translation>
    </message>
    <message>
        <source>Close together</source>
        <translation>Tæt sammen</translation>
    </message>
    <message>
        <source>Place to search, probability of finding</source>
        <translation>Sted at eftersøge, sandsynlighed for fund</translation>
    </message>
    <message>
        <source>Place to search</source>
        <translation>Sted at eftersøge</translation>
    </message>
    <message>
        <source>Later visit in the plan</source>
        <translation>Senere besøg i planen</translation>
    </message>
    <message>
        <source>Later visit</source>
        <translation>Senere besøg</translation>
    </message>
    <message>
        <source>Airspace, for information</source>
        <translation>Luftrum, til orientering</translation>
    </message>
    <message>
        <source>Airspace</source>
        <translation>Luftrum</translation>
    </message>
    <message>
        <source>Flight geography, proposal</source>
        <translation>Flyvegeografi, forslag</translation>
    </message>
    <message>
        <source>Flight geography</source>
        <translation>Flyvegeografi</translation>
    </message>
    <message>
        <source>Contingency volume, proposal</source>
        <translation>Beredskabsvolumen, forslag</translation>
    </message>
    <message>
        <source>Contingency</source>
        <translation>Beredskab</translation>
    </message>
    <message>
        <source>Ground-risk buffer, proposal</source>
        <translation>Jordrisikobuffer, forslag</translation>
    </message>
    <message>
        <source>Risk buffer</source>
        <translation>Risikobuffer</translation>
    </message>
    <message>
        <source>Adjacent area, proposal</source>
        <translation>Tilstødende område, forslag</translation>
    </message>
    <message>
        <source>Adjacent area</source>
        <translation>Tilstødende område</translation>
    </message>
    <message>
        <source>Close together: dot or number</source>
        <translation>Tæt sammen: prik, eller hvor mange</translation>
    </message>
    <message>
        <source>Later visits of the patrol</source>
        <translation>Senere besøg i patruljen</translation>
    </message>
    <message>
        <source>Patrol</source>
        <translation>Patrulje</translation>
    </message>
    <message>
        <source>Ice free</source>
        <translation>Isfrit</translation>
    </message>
    <message>
        <source>Open water</source>
        <translation>Åbent vand</translation>
    </message>
    <message>
        <source>Ice 1–3 tenths</source>
        <translation>Is 1–3 tiendedele</translation>
    </message>
    <message>
        <source>Ice 4–6 tenths</source>
        <translation>Is 4–6 tiendedele</translation>
    </message>
    <message>
        <source>Ice 7–8 tenths</source>
        <translation>Is 7–8 tiendedele</translation>
    </message>
    <message>
        <source>Ice 9–10 tenths</source>
        <translation>Is 9–10 tiendedele</translation>
    </message>
    <message>
        <source>Fast ice</source>
        <translation>Fastis</translation>
    </message>
    <message>
        <source>Ice, concentration unknown</source>
        <translation>Is, ukendt koncentration</translation>
    </message>
    <message>
        <source>no date</source>
        <comment>ice chart</comment>
        <translation>uden dato</translation>
    </message>
    <message>
        <source>Old ice chart: %1</source>
        <translation>Gammelt iskort: %1</translation>
    </message>
    <message>
        <source>Ice chart: %1</source>
        <translation>Iskort: %1</translation>
    </message>
    <message>
        <source>Old ice chart</source>
        <translation>Gammelt iskort</translation>
    </message>
    <message>
        <source>Ice chart</source>
        <translation>Iskort</translation>
    </message>
    <message>
        <source>Forecast wind, full barb 10 kn</source>
        <translation>Vind i prognosen, hel streg 10 kn</translation>
    </message>
    <message>
        <source>Forecast wind</source>
        <translation>Vind i prognosen</translation>
    </message>
    <message>
        <source>Forecast current</source>
        <translation>Strøm i prognosen</translation>
    </message>
    <message>
        <source>Predicted drift, circle: 1 σ</source>
        <translation>Forventet drift, cirkel: 1 σ</translation>
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
        <translation>Besøg, prikker på banen</translation>
    </message>
    <message>
        <source>Longest flight</source>
        <translation>Længste flyvning</translation>
    </message>
    <message>
        <source>Flight time</source>
        <translation>Flyvetid</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besøg</translation>
    </message>
    <message>
        <source>This sortie</source>
        <translation>Dette togt</translation>
    </message>
</context>
<context>
    <name>MapTipText</name>
    <message>
        <source>drifting %1 towards %2</source>
        <translation>driver %1 mod %2</translation>
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
        <translation>Iskoncentration %1 tiendedele</translation>
    </message>
    <message>
        <source>Ice concentration unknown</source>
        <translation>Ukendt iskoncentration</translation>
    </message>
    <message>
        <source>, fast ice</source>
        <translation>, fastis</translation>
    </message>
    <message>
        <source>
On the chart: %1</source>
        <translation>
På kortet: %1</translation>
    </message>
</context>
<context>
    <name>MapTools</name>
    <message>
        <source>Drag to move the map, turn the wheel to zoom. Esc leaves the tool.</source>
        <translation>Træk for at flytte kortet, brug hjulet til at zoome. Esc forlader værktøjet.</translation>
    </message>
    <message>
        <source>Move UAV</source>
        <translation>Flyt drone</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects</source>
        <translation>
            <numerusform>Flyt %n objekt</numerusform>
            <numerusform>Flyt %n objekter</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n icebergs</source>
        <translation>
            <numerusform>Flyt isbjerg</numerusform>
            <numerusform>Flyt %n isbjerge</numerusform>
        </translation>
    </message>
    <message>
        <source>Move asset</source>
        <translation>Flyt objekt</translation>
    </message>
    <message>
        <source>Move area</source>
        <translation>Flyt område</translation>
    </message>
    <message>
        <source>Move no-fly area</source>
        <translation>Flyt flyveforbudsområde</translation>
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
        <translation>I alt %1</translation>
    </message>
    <message>
        <source>Click to set the next point. Enter ends the line, Backspace removes a point, Esc clears.</source>
        <translation>Klik for at sætte det næste punkt. Enter afslutter linjen, Backspace fjerner et punkt, Esc rydder.</translation>
    </message>
    <message>
        <source>Click to start another line. Esc clears this one.</source>
        <translation>Klik for at begynde en ny linje. Esc rydder denne.</translation>
    </message>
    <message>
        <source>Click points to measure the path between them: geodesic length, true bearing, time of flight.</source>
        <translation>Klik på punkter for at måle vejen mellem dem: geodætisk længde, retvisende pejling, flyvetid.</translation>
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
        <translation>isbjerg nået</translation>
    </message>
    <message>
        <source>Uncertainty now and accumulated</source>
        <translation>Usikkerhed nu og akkumuleret</translation>
    </message>
    <message>
        <source>Sum of σ, m²</source>
        <translation>Sum af σ, m²</translation>
    </message>
    <message>
        <source>Sum of σ</source>
        <translation>Sum af σ</translation>
    </message>
    <message>
        <source>Uncertainty of each iceberg</source>
        <translation>Hvert isbjergs usikkerhed</translation>
    </message>
    <message>
        <source>σ, m²</source>
        <translation>σ, m²</translation>
    </message>
    <message>
        <source>Nothing flown yet. Press Space to fly the plan</source>
        <translation>Intet fløjet endnu. Tryk på mellemrum for at flyve planen</translation>
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
        <translation>Zetas vækst, nu og i gennemsnit</translation>
    </message>
    <message>
        <source>Sum of σ = dζ/dt, m²</source>
        <translation>Sum af σ = dζ/dt, m²</translation>
    </message>
    <message>
        <source>Mean since take-off</source>
        <translation>Middel siden start</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Middel</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Nu</translation>
    </message>
    <message>
        <source>At %1 zeta grows by %2 m² s per second; the mean since take-off is %3.</source>
        <translation>Ved %1 vokser zeta med %2 m² s pr. sekund; gennemsnittet siden start er %3.</translation>
    </message>
    <message>
        <source>Distance flown</source>
        <translation>Fløjet distance</translation>
    </message>
    <message>
        <source>Flown</source>
        <translation>Fløjet</translation>
    </message>
    <message>
        <source>Distance flown until %1: %2.</source>
        <translation>Distance fløjet indtil %1: %2.</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>Drejehastighed</translation>
    </message>
    <message>
        <source>Turn rate, °/s, positive to the left</source>
        <translation>Drejehastighed, °/s, positiv mod venstre</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>Limit %1 °/s</source>
        <translation>Grænse %1 °/s</translation>
    </message>
    <message>
        <source>Cross-track error</source>
        <translation>Sideafvigelse</translation>
    </message>
    <message>
        <source>Cross-track error, m, positive to the left</source>
        <translation>Sideafvigelse, m, positiv mod venstre</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Zeta and sum of σ</source>
        <translation>Zeta og sum af σ</translation>
    </message>
    <message>
        <source>Rate of zeta</source>
        <translation>Zetas vækst</translation>
    </message>
    <message>
        <source>σ of each iceberg</source>
        <translation>σ for hvert isbjerg</translation>
    </message>
    <message>
        <source>Distance through the air, %1</source>
        <translation>Distance gennem luften, %1</translation>
    </message>
    <message>
        <source>Lower bound on ζ</source>
        <translation>Nedre grænse for ζ</translation>
    </message>
    <message>
        <source>Weighted</source>
        <translation>Vægtet</translation>
    </message>
    <message>
        <source>Weighted by priority</source>
        <translation>Vægtet efter prioritet</translation>
    </message>
    <message>
        <source>Weighted by priority the sum is %1 m².</source>
        <translation>Vægtet efter prioritet er summen %1 m².</translation>
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
        <translation>Drejehastighed ved %1: %2; grænse: %3.</translation>
    </message>
    <message>
        <source>Cross-track error at %1: %2.</source>
        <translation>Sideafvigelse ved %1: %2.</translation>
    </message>
    <message>
        <source>Zeta %1</source>
        <translation>Zeta %1</translation>
    </message>
    <message>
        <source>At %1 zeta is %2 and the sum of σ %3 m².</source>
        <translation>Ved %1 er zeta %2 og summen af σ %3 m².</translation>
    </message>
    <message numerus="yes">
        <source>At %1 the most uncertain iceberg is %2: %3; %n in view.</source>
        <translation>
            <numerusform>Ved %1 er det mest usikre isbjerg %2: %3; %n i syne.</numerusform>
            <numerusform>Ved %1 er det mest usikre isbjerg %2: %3; %n i syne.</numerusform>
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
%4 efter start</translation>
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
        <translation>Besøg</translation>
    </message>
    <message>
        <source>No icebergs yet</source>
        <translation>Ingen isbjerge endnu</translation>
    </message>
    <message>
        <source>Add icebergs with their positions to the scenario file, then draw the map again.</source>
        <translation>Tilføj isbjerge med deres positioner til scenariefilen, og tegn derefter kortet igen.</translation>
    </message>
    <message>
        <source>Closest so far</source>
        <translation>Nærmest hidtil</translation>
    </message>
    <message>
        <source>Above the reserve</source>
        <translation>Over reserven</translation>
    </message>
    <message>
        <source>if home now</source>
        <translation>hvis hjem nu</translation>
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
        <translation>Største fart over grunden</translation>
    </message>
    <message>
        <source>Flight geography, height</source>
        <translation>Flyvegeografi, højde</translation>
    </message>
    <message>
        <source>Contingency volume, height</source>
        <translation>Beredskabsvolumen, højde</translation>
    </message>
    <message>
        <source>Contingency volume, width</source>
        <translation>Beredskabsvolumen, bredde</translation>
    </message>
    <message>
        <source>Ground-risk buffer, width</source>
        <translation>Jordrisikobuffer, bredde</translation>
    </message>
    <message>
        <source>Adjacent area, width</source>
        <translation>Tilstødende område, bredde</translation>
    </message>
    <message>
        <source>Flight geography: inside the geofence.</source>
        <translation>Flyvegeografi: geohegnets inderside.</translation>
    </message>
    <message>
        <source>Flight geography: all places that a plan may reach, plus a margin of %1 m.</source>
        <translation>Flyvegeografi: alle steder, som en plan kan nå, plus en margin på %1 m.</translation>
    </message>
    <message>
        <source>Formulas and default constants: Digisky calculator 3.3.0, based on the guide of the Swiss FOCA; not an authority&apos;s own text.</source>
        <translation>Formler og standardværdier: beregneren Digisky 3.3.0, efter vejledningen fra schweiziske FOCA; ikke en myndigheds egen tekst.</translation>
    </message>
    <message>
        <source>The outlines are in the KML, KMZ and GeoJSON exports.</source>
        <translation>Omridsene findes i eksporten til KML, KMZ og GeoJSON.</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
    </message>
    <message>
        <source>Endurance</source>
        <translation>Udholdenhed</translation>
    </message>
    <message>
        <source>Reserve</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>Wind limit</source>
        <translation>Vindgrænse</translation>
    </message>
    <message>
        <source>Gust limit</source>
        <translation>Vindstødsgrænse</translation>
    </message>
    <message>
        <source>Icing conditions</source>
        <translation>Isningsforhold</translation>
    </message>
    <message>
        <source>flown in</source>
        <translation>kan flyves</translation>
    </message>
    <message>
        <source>not flown in</source>
        <translation>flyves ikke</translation>
    </message>
    <message>
        <source>Made by Bergwatch from the scenario. It does not imply that the operation may be flown.</source>
        <translation>Lavet af Bergwatch ud fra scenariet. Det betyder ikke, at operationen må flyves.</translation>
    </message>
    <message>
        <source>Checklist</source>
        <translation>Tjekliste</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>og %1 til</translation>
    </message>
    <message>
        <source>Operation volume: proposal, to be checked with your authority</source>
        <translation>Operationsvolumen: forslag, skal afklares med myndigheden</translation>
    </message>
    <message>
        <source>Crew</source>
        <translation>Besætning</translation>
    </message>
    <message>
        <source>Call sign</source>
        <translation>Kaldesignal</translation>
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
        <translation>Sigtgrænse</translation>
    </message>
    <message>
        <source>Ceiling limit</source>
        <translation>Skybasegrænse</translation>
    </message>
</context>
<context>
    <name>PageText</name>
    <message>
        <source>Untitled</source>
        <translation>Uden navn</translation>
    </message>
    <message>
        <source>First leg at %1</source>
        <translation>Første etape ved %1</translation>
    </message>
    <message>
        <source>First leg</source>
        <translation>Første etape</translation>
    </message>
    <message>
        <source>Planned order at %1</source>
        <translation>Planlagt rækkefølge ved %1</translation>
    </message>
    <message>
        <source>Planned order</source>
        <translation>Planlagt rækkefølge</translation>
    </message>
    <message>
        <source>Planned path with turns at %1</source>
        <translation>Planlagt bane med drej ved %1</translation>
    </message>
    <message>
        <source>Planned path with turns</source>
        <translation>Planlagt bane med drej</translation>
    </message>
    <message>
        <source>Flown until %1</source>
        <translation>Fløjet til %1</translation>
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
        <translation>Som åbnet</translation>
    </message>
    <message>
        <source>Click a line to go to that state; the disk marks the saved one.</source>
        <translation>Klik på en linje for at gå til den tilstand; disketten viser den gemte.</translation>
    </message>
    <message>
        <source>History of edits</source>
        <translation>Ændringshistorik</translation>
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
        <translation>Davisstrædet</translation>
    </message>
    <message>
        <source>Baffin Bay</source>
        <translation>Baffin Bugt</translation>
    </message>
    <message>
        <source>Disko Bay</source>
        <translation>Disko Bugt</translation>
    </message>
    <message>
        <source>Melville Bay</source>
        <translation>Melville Bugt</translation>
    </message>
    <message>
        <source>Cape York</source>
        <translation>Kap York</translation>
    </message>
    <message>
        <source>Nares Strait</source>
        <translation>Naresstrædet</translation>
    </message>
    <message>
        <source>Cape Farewell</source>
        <translation>Kap Farvel</translation>
    </message>
    <message>
        <source>Denmark Strait</source>
        <translation>Danmarksstrædet</translation>
    </message>
    <message>
        <source>Scoresby Sund</source>
        <translation>Scoresby Sund</translation>
    </message>
    <message>
        <source>Fram Strait</source>
        <translation>Framstrædet</translation>
    </message>
    <message>
        <source>Hinlopen Strait</source>
        <translation>Hinlopenstrædet</translation>
    </message>
    <message>
        <source>Bear Island</source>
        <translation>Bjørneøen</translation>
    </message>
    <message>
        <source>Barents Sea</source>
        <translation>Barentshavet</translation>
    </message>
    <message>
        <source>Franz Josef Land</source>
        <translation>Franz Josefs Land</translation>
    </message>
    <message>
        <source>Novaya Zemlya</source>
        <translation>Novaja Zemlja</translation>
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
        <translation>Beringstrædet</translation>
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
        <translation>Drakestrædet</translation>
    </message>
    <message>
        <source>South Georgia</source>
        <translation>South Georgia</translation>
    </message>
    <message>
        <source>Weddell Sea</source>
        <translation>Weddellhavet</translation>
    </message>
    <message>
        <source>Amery Ice Shelf</source>
        <translation>Amery-isshelfen</translation>
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
        <translation>Der findes intet sted med dette navn her, og det er ikke en koordinat.</translation>
    </message>
    <message>
        <source>Several places have this name.</source>
        <translation>Flere steder hedder sådan.</translation>
    </message>
    <message>
        <source>Enter a coordinate or a place name.</source>
        <translation>Der kræves en koordinat eller et stednavn.</translation>
    </message>
    <message>
        <source>This is not a coordinate. Examples: 47° 03.2′ N 48° 06′ W, or 47.05 -48.1.</source>
        <translation>Dette er ikke en koordinat. F.eks. 47° 03,2′ N 48° 06′ V eller 47,05 -48,1.</translation>
    </message>
    <message>
        <source>This is half a coordinate. Enter latitude and longitude.</source>
        <translation>Dette er en halv koordinat: der kræves både bredde og længde.</translation>
    </message>
    <message>
        <source>This coordinate is ambiguous. Add spaces and the letters N, S, E or W.</source>
        <translation>Dette kan læses på mere end én måde. Mellemrum og bogstaverne N, S, Ø og V gør det entydigt.</translation>
    </message>
    <message>
        <source>Only one half states its hemisphere. Add N, S, E or W to the other.</source>
        <translation>Kun den ene halvdel angiver sin halvkugle. Tilføj N, S, Ø eller V til den anden.</translation>
    </message>
    <message>
        <source>Use a sign or a hemisphere letter, not both.</source>
        <translation>Enten et fortegn eller et bogstav angiver halvkuglen, ikke begge.</translation>
    </message>
    <message>
        <source>Enter one latitude and one longitude.</source>
        <translation>Der kræves én bredde og én længde, ikke to af samme slags.</translation>
    </message>
    <message>
        <source>Minutes and seconds must be below 60.</source>
        <translation>Minutter og sekunder er mindre end 60.</translation>
    </message>
    <message>
        <source>Latitude must be between 90° S and 90° N.</source>
        <translation>Bredder går fra 90° S til 90° N.</translation>
    </message>
    <message>
        <source>Longitude must be between 180° W and 180° E.</source>
        <translation>Længder går fra 180° V til 180° Ø.</translation>
    </message>
    <message>
        <source>This position does not exist on the UTM or MGRS grid.</source>
        <translation>Der er intet sådant sted i UTM- eller MGRS-nettet.</translation>
    </message>
    <message>
        <source>This is a longitude. Enter a latitude.</source>
        <translation>Dette er en længde, der kræves en bredde.</translation>
    </message>
    <message>
        <source>This is a latitude. Enter a longitude.</source>
        <translation>Dette er en bredde, der kræves en længde.</translation>
    </message>
    <message>
        <source>This is %1 from the scenario&apos;s origin; the limit is %2.</source>
        <translation>Dette er %1 fra scenariets origo; scenariet rækker %2.</translation>
    </message>
    <message>
        <source>Enter one angle only: a whole coordinate would move all of them to one place.</source>
        <translation>Skriv én vinkel: en hel koordinat ville placere alle på ét sted.</translation>
    </message>
    <message>
        <source>Amundsen Sea</source>
        <translation>Amundsenhavet</translation>
    </message>
    <message>
        <source>Antarctic Peninsula</source>
        <translation>Den Antarktiske Halvø</translation>
    </message>
    <message>
        <source>Baffin Island</source>
        <translation>Baffin Island</translation>
    </message>
    <message>
        <source>Bellingshausen Sea</source>
        <translation>Bellingshausenhavet</translation>
    </message>
    <message>
        <source>Bering Sea</source>
        <translation>Beringshavet</translation>
    </message>
    <message>
        <source>Bransfield Strait</source>
        <translation>Bransfieldstrædet</translation>
    </message>
    <message>
        <source>Cape Horn</source>
        <translation>Kap Horn</translation>
    </message>
    <message>
        <source>Chukchi Sea</source>
        <translation>Tjuktjerhavet</translation>
    </message>
    <message>
        <source>East Siberian Sea</source>
        <translation>Østsibiriske Hav</translation>
    </message>
    <message>
        <source>Ellesmere Island</source>
        <translation>Ellesmere Island</translation>
    </message>
    <message>
        <source>Falkland Islands</source>
        <translation>Falklandsøerne</translation>
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
        <translation>St. Lawrence-bugten</translation>
    </message>
    <message>
        <source>Hudson Bay</source>
        <translation>Hudsonbugten</translation>
    </message>
    <message>
        <source>Hudson Strait</source>
        <translation>Hudsonstrædet</translation>
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
        <translation>Nysibiriske Øer</translation>
    </message>
    <message>
        <source>Newfoundland</source>
        <translation>Newfoundland</translation>
    </message>
    <message>
        <source>North Cape</source>
        <translation>Nordkap</translation>
    </message>
    <message>
        <source>North Sea</source>
        <translation>Nordsøen</translation>
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
        <translation>Severnaja Zemlja</translation>
    </message>
    <message>
        <source>South Orkney Islands</source>
        <translation>South Orkney Islands</translation>
    </message>
    <message>
        <source>South Shetland Islands</source>
        <translation>South Shetland Islands</translation>
    </message>
    <message>
        <source>Strait of Belle Isle</source>
        <translation>Belle Isle-strædet</translation>
    </message>
    <message>
        <source>White Sea</source>
        <translation>Hvidehavet</translation>
    </message>
    <message>
        <source>Wrangel Island</source>
        <translation>Wrangeløen</translation>
    </message>
</context>
<context>
    <name>PlacingTools</name>
    <message>
        <source>Add iceberg</source>
        <translation>Tilføj isbjerg</translation>
    </message>
    <message>
        <source>Change drift</source>
        <translation>Ændr drift</translation>
    </message>
    <message>
        <source>Click to add an iceberg; drag to set its drift. Esc leaves the tool.</source>
        <translation>Klik for at tilføje et isbjerg, træk for at sætte dets drift. Esc forlader værktøjet.</translation>
    </message>
    <message>
        <source>Place UAV</source>
        <translation>Placér drone</translation>
    </message>
    <message>
        <source>Release to keep this heading. Esc cancels.</source>
        <translation>Slip for at beholde denne kurs. Esc annullerer.</translation>
    </message>
    <message>
        <source>Move asset</source>
        <translation>Flyt objekt</translation>
    </message>
    <message>
        <source>Place asset</source>
        <translation>Placér objekt</translation>
    </message>
    <message>
        <source>Release to place it here. Esc cancels.</source>
        <translation>Slip for at placere det her. Esc annullerer.</translation>
    </message>
    <message>
        <source>Click to move the asset here. Esc leaves the tool.</source>
        <translation>Klik for at flytte objektet hertil. Esc forlader værktøjet.</translation>
    </message>
    <message>
        <source>Click to place the protected asset. Esc leaves the tool.</source>
        <translation>Klik for at placere det beskyttede objekt. Esc forlader værktøjet.</translation>
    </message>
    <message>
        <source>Click to add an iceberg that appears here now; drag to set its drift. In flight this cannot be undone.</source>
        <translation>Klik for at tilføje et isbjerg, der dukker op her nu, træk for at sætte dets drift. Under flyvning kan det ikke fortrydes.</translation>
    </message>
    <message>
        <source>Add UAV</source>
        <translation>Tilføj drone</translation>
    </message>
    <message>
        <source>Click to place the UAV; drag to set its heading. Ctrl+click adds another one. Esc leaves the tool.</source>
        <translation>Klik for at placere dronen, træk for at sætte dens kurs. Ctrl+klik tilføjer en ny. Esc forlader værktøjet.</translation>
    </message>
    <message>
        <source>Click to place %1; drag to set its heading. Ctrl+click adds another UAV. Esc leaves the tool.</source>
        <translation>Klik for at placere %1, træk for at sætte kursen. Ctrl+klik tilføjer en ny drone. Esc forlader værktøjet.</translation>
    </message>
    <message>
        <source>Seen by %1.</source>
        <comment>source and its error</comment>
        <translation>Set med %1.</translation>
    </message>
    <message>
        <source>The scenario has %1 icebergs, the most that are possible.</source>
        <translation>Scenariet har %1 isbjerge, flere er der ikke plads til.</translation>
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
        <translation>søgning og grænse</translation>
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
        <translation>Status: %1</translation>
    </message>
    <message>
        <source>Time: %1</source>
        <translation>Tid: %1</translation>
    </message>
    <message>
        <source>Objective: %1 m²</source>
        <translation>Målfunktion: %1 m²</translation>
    </message>
    <message>
        <source>Lower bound: %1 m²</source>
        <translation>Nedre grænse: %1 m²</translation>
    </message>
    <message>
        <source>Warm start from the previous plan</source>
        <translation>Startet fra den forrige plan</translation>
    </message>
    <message>
        <source>Proven optimal, %1 (%2)</source>
        <translation>Bevist optimal, %1 (%2)</translation>
    </message>
    <message>
        <source>Best order so far, within %1 % of optimal</source>
        <translation>Bedste rækkefølge hidtil, inden for %1 % af optimum</translation>
    </message>
    <message>
        <source>Best order so far</source>
        <translation>Bedste rækkefølge hidtil</translation>
    </message>
    <message>
        <source>Within %1 % of optimal, %2</source>
        <translation>Inden for %1 % af optimum, %2</translation>
    </message>
    <message>
        <source>Best order found, %1</source>
        <translation>Bedste fundne rækkefølge, %1</translation>
    </message>
    <message>
        <source>Planning…</source>
        <translation>Planlægger…</translation>
    </message>
    <message>
        <source>No plan yet</source>
        <translation>Ingen plan endnu</translation>
    </message>
    <message>
        <source>Nothing to visit now</source>
        <translation>Intet at besøge nu</translation>
    </message>
    <message>
        <source>Solver limit reached; flying to the nearest iceberg</source>
        <translation>Løserens grænse nået; flyver til det nærmeste isbjerg</translation>
    </message>
    <message>
        <source>Solver limit reached; previous plan kept</source>
        <translation>Løserens grænse nået; forrige plan beholdt</translation>
    </message>
    <message>
        <source>Chosen one iceberg at a time</source>
        <translation>Valgt ét isbjerg ad gangen</translation>
    </message>
    <message>
        <source>Following the existing route</source>
        <translation>Følger den eksisterende rute</translation>
    </message>
    <message>
        <source>under 1 ms</source>
        <translation>under 1 ms</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Predicted zeta: %1 m² s</source>
        <translation>Forudsagt zeta: %1 m² s</translation>
    </message>
    <message>
        <source>Objective: %1 m² s</source>
        <translation>Målfunktion: %1 m² s</translation>
    </message>
    <message>
        <source>Lower bound: %1 m² s</source>
        <translation>Nedre grænse: %1 m² s</translation>
    </message>
    <message>
        <source>by assignment</source>
        <comment>solver</comment>
        <translation>ved tildeling</translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>%n drone</numerusform>
            <numerusform>%n droner</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n isbjerg</numerusform>
            <numerusform>%n isbjerge</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Run complete</source>
        <translation>Flyvning gennemført</translation>
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
        <translation>ingen rækkefølge fundet</translation>
    </message>
    <message>
        <source>No plan while the UAV returns, holds or is on the ground</source>
        <translation>Ingen plan, mens dronen vender hjem, venter eller er på jorden</translation>
    </message>
    <message>
        <source>The wind is too strong to return home</source>
        <translation>Vinden er for stærk til at komme hjem</translation>
    </message>
    <message>
        <source>Home with %1 of the reserve used</source>
        <translation>Hjemme med %1 af reserven brugt</translation>
    </message>
    <message>
        <source>Home with %1 above the reserve</source>
        <translation>Hjemme med %1 over reserven</translation>
    </message>
    <message>
        <source>In 1 flight in 20 the wind is too strong to return home</source>
        <translation>I 1 ud af 20 flyvninger er vinden for stærk til at komme hjem</translation>
    </message>
    <message>
        <source>1 flight in 20 uses %1 or more of the reserve</source>
        <translation>1 ud af 20 flyvninger bruger %1 eller mere af reserven</translation>
    </message>
    <message>
        <source>1 flight in 20: %1 or less above the reserve</source>
        <translation>1 ud af 20 flyvninger: %1 eller mindre over reserven</translation>
    </message>
    <message>
        <source>It follows from visit rates: how often icebergs can be visited.</source>
        <translation>Den følger af besøgshyppigheder: hvor ofte isbjerge kan besøges.</translation>
    </message>
    <message>
        <source>It follows from visit sequences: how soon icebergs can be visited one after the other.</source>
        <translation>Den følger af besøgsrækkefølger: hvor hurtigt isbjerge kan besøges efter hinanden.</translation>
    </message>
    <message>
        <source>No plan while the UAV returns, is on the ground or holds. A new one is made when it resumes.</source>
        <translation>Ingen plan, mens dronen er på vej hjem, på jorden eller venter. En ny laves, når den fortsætter.</translation>
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
        <translation>Lokalsøgning</translation>
    </message>
    <message>
        <source>One way</source>
        <comment>route</comment>
        <translation>Én vej</translation>
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
        <translation>i alle højder</translation>
    </message>
    <message>
        <source>%1 (%2 ft)</source>
        <translation>%1 (%2 fod)</translation>
    </message>
    <message>
        <source>not home</source>
        <translation>ikke hjemme</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>fod</translation>
    </message>
    <message>
        <source>%1 ft</source>
        <translation>%1 fod</translation>
    </message>
    <message>
        <source>%1 ft (%2)</source>
        <translation>%1 fod (%2)</translation>
    </message>
    <message>
        <source>σ %1 (95 % within %2)</source>
        <translation>σ %1 (95 % inden for %2)</translation>
    </message>
    <message>
        <source>95 % within %2 (σ %1)</source>
        <translation>95 % inden for %2 (σ %1)</translation>
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
        <translation>Startværdi</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
    </message>
    <message>
        <source>Visits planned</source>
        <translation>Besøg planlagt</translation>
    </message>
    <message>
        <source>flown</source>
        <translation>fløjet</translation>
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
        <translation>Uden for flyvegeografien</translation>
    </message>
    <message>
        <source>Planned and flown</source>
        <translation>Planlagt og fløjet</translation>
    </message>
    <message>
        <source>SHA-256 of the first plan as a file of the format wpl:</source>
        <translation>SHA-256 af den første plan som fil i formatet wpl:</translation>
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
        <translation>Isbjerg</translation>
    </message>
    <message>
        <source>First seen</source>
        <translation>Først set</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Sidst set</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besøg</translation>
    </message>
    <message>
        <source>Longest unseen</source>
        <translation>Længst uset</translation>
    </message>
    <message>
        <source>σ at the end, m²</source>
        <translation>σ ved slutningen, m²</translation>
    </message>
    <message>
        <source>never</source>
        <translation>aldrig</translation>
    </message>
    <message>
        <source>Sightings</source>
        <translation>Observationer</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>og %1 mere</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Afvigelser</translation>
    </message>
    <message>
        <source>None on record.</source>
        <translation>Ingen er registreret.</translation>
    </message>
    <message>
        <source>Flight log: %1</source>
        <translation>Flyvelog: %1</translation>
    </message>
    <message>
        <source>Cases in which each tau is the best</source>
        <translation>Tilfælde, hvor hver tau er bedst</translation>
    </message>
    <message>
        <source>cases</source>
        <translation>tilfælde</translation>
    </message>
    <message>
        <source>τ of the lowest ζ of a case</source>
        <translation>τ med lavest ζ i et tilfælde</translation>
    </message>
    <message>
        <source>a scenario without a name</source>
        <translation>et scenarie uden navn</translation>
    </message>
    <message>
        <source>%1: icebergs: %2, seed %3, %4 s in steps of %5 s</source>
        <translation>%1: isbjerge: %2, startværdi %3, %4 s i trin på %5 s</translation>
    </message>
    <message>
        <source>without noise</source>
        <translation>uden støj</translation>
    </message>
    <message>
        <source>measured with noise, velocities known</source>
        <translation>målt med støj, kendte hastigheder</translation>
    </message>
    <message>
        <source>measured with noise, velocities uncertain by 0.1 m/s</source>
        <translation>målt med støj, hastigheder usikre med 0,1 m/s</translation>
    </message>
    <message>
        <source>measured with noise, unknown velocities that change like those of real icebergs</source>
        <translation>målt med støj, ukendte hastigheder, der ændrer sig som virkelige isbjerges</translation>
    </message>
    <message>
        <source>Random fields: %1, seeds %2 to %3. Icebergs in each: %4, in %5 m × %6 m, drifting at up to %7 m/s</source>
        <translation>Tilfældige felter: %1, startværdier %2 til %3. Isbjerge i hvert: %4, i %5 m × %6 m, med drift op til %7 m/s</translation>
    </message>
    <message>
        <source>initial σ of %1 to %2 m², growing by q = %3 m²/s</source>
        <translation>σ ved starten %1 til %2 m², vokser med q = %3 m²/s</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Scenarier</translation>
    </message>
    <message>
        <source>Policies</source>
        <translation>Strategier</translation>
    </message>
    <message>
        <source>the scenario’s own seed, the same for every setting</source>
        <translation>scenariets egen startværdi, den samme for alle indstillinger</translation>
    </message>
    <message>
        <source>seeds for each scenario: %1, starting with its own, the same for every setting</source>
        <translation>startværdier for hvert scenarie: %1, først dets egen, de samme for alle indstillinger</translation>
    </message>
    <message>
        <source>%1 to %2 by %3 (%4 values)</source>
        <translation>%1 til %2 i trin på %3 (%4 værdier)</translation>
    </message>
    <message>
        <source>Random fields: %1, icebergs in each: %2</source>
        <translation>Tilfældige felter: %1, isbjerge i hvert: %2</translation>
    </message>
    <message>
        <source>Study, scenarios: %1</source>
        <translation>Studie, scenarier: %1</translation>
    </message>
    <message>
        <source>What was flown</source>
        <translation>Det fløjne</translation>
    </message>
    <message>
        <source>Trade-off τ</source>
        <translation>Afvejning τ</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Støj</translation>
    </message>
    <message>
        <source>Missions</source>
        <translation>Missioner</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 af %2</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maskine</translation>
    </message>
    <message>
        <source>Created</source>
        <translation>Lavet</translation>
    </message>
    <message>
        <source>Last run took</source>
        <translation>Sidste kørsel tog</translation>
    </message>
    <message>
        <source>How to reproduce this report</source>
        <translation>Sådan gendannes rapporten</translation>
    </message>
    <message>
        <source>This page contains the whole study with every scenario, seed and result, and Bergwatch opens it as a study file. To make the page again from these results:</source>
        <translation>Denne side indeholder hele studiet med alle scenarier, startværdier og resultater, og Bergwatch åbner den som en studiefil. Sådan laves siden igen ud fra disse resultater:</translation>
    </message>
    <message>
        <source>To fly the study again; the results depend neither on the machine nor on the number of threads:</source>
        <translation>Sådan flyves studiet igen; resultaterne afhænger hverken af maskinen eller af antallet af tråde:</translation>
    </message>
    <message>
        <source>To fly the study again with your scenario files; the results depend neither on the machine nor on the number of threads:</source>
        <translation>Sådan flyves studiet igen med dine scenariefiler; resultaterne afhænger hverken af maskinen eller af antallet af tråde:</translation>
    </message>
    <message>
        <source>ζ is the total uncertainty σ of all icebergs, integrated over the flight. Lower is better.</source>
        <translation>ζ er den samlede usikkerhed σ for alle isbjerge, integreret over flyvningen. Lavere er bedre.</translation>
    </message>
    <message>
        <source>There is only one case, so there is no spread to show.</source>
        <translation>Der er kun ét tilfælde, så der er ingen spredning at vise.</translation>
    </message>
    <message>
        <source>Differences are taken case by case, with the same icebergs and the same noise; the bars are 95 % intervals of the mean (Student’s t). Values left of 0 are better than the reference.</source>
        <translation>Forskellene beregnes tilfælde for tilfælde, med de samme isbjerge og den samme støj; stregerne er 95 %-intervaller for middelværdien (Students t). Værdier til venstre for 0 er bedre end referencen.</translation>
    </message>
    <message>
        <source>Not every τ is drawn; the table contains all of them.</source>
        <translation>Ikke alle τ er tegnet; tabellen indeholder dem alle.</translation>
    </message>
    <message>
        <source>ζ against τ</source>
        <translation>ζ mod τ</translation>
    </message>
    <message>
        <source>Differences vs the reference</source>
        <translation>Forskelle til referencen</translation>
    </message>
    <message>
        <source>Best τ of each case</source>
        <translation>Bedste τ i hvert tilfælde</translation>
    </message>
    <message>
        <source>The τ with the lowest ζ of a case, chosen in hindsight; it is not known before the flight. If several are equal, the smallest counts.</source>
        <translation>Den τ, der giver lavest ζ i et tilfælde, valgt bagefter; den er ikke kendt før flyvningen. Hvis flere er lige gode, tæller den mindste.</translation>
    </message>
    <message>
        <source>Stuck: at most two icebergs were targets in the second half of the flight.</source>
        <translation>Fastlåst: højst to isbjerge var mål i anden halvdel af flyvningen.</translation>
    </message>
    <message>
        <source>ζ of the case and its difference vs %1.</source>
        <translation>ζ for tilfældet og forskellen fra %1.</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Indstilling</translation>
    </message>
    <message>
        <source>Difference, m² s</source>
        <translation>Forskel, m² s</translation>
    </message>
    <message>
        <source>Difference, %</source>
        <translation>Forskel, %</translation>
    </message>
    <message>
        <source>Stuck</source>
        <translation>Fastlåst</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nej</translation>
    </message>
    <message>
        <source>ζ in m² s. Cases: %1.</source>
        <translation>ζ i m² s. Tilfælde: %1.</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Middel</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>Standardfejl</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Differences of ζ vs %1, case by case, with 95 % intervals of the mean. Worst: the largest difference of a case.</source>
        <translation>Forskelle i ζ fra %1, tilfælde for tilfælde, med 95 %-intervaller for middelværdien. Værst: den største forskel i et tilfælde.</translation>
    </message>
    <message>
        <source>Mean, m² s</source>
        <translation>Middel, m² s</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95 %-interval</translation>
    </message>
    <message>
        <source>Mean, %</source>
        <translation>Middel, %</translation>
    </message>
    <message>
        <source>Cases below</source>
        <translation>Tilfælde under</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Værst</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>reference</translation>
    </message>
    <message>
        <source>best τ of each case</source>
        <translation>bedste τ i hvert tilfælde</translation>
    </message>
    <message>
        <source>Best τ of each case, chosen in hindsight</source>
        <translation>Bedste τ i hvert tilfælde, valgt bagefter</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Tilfælde</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Andel</translation>
    </message>
    <message>
        <source>One case is too few to recommend a policy. Fly more cases.</source>
        <translation>Ét tilfælde er for lidt til at anbefale en strategi. Flyv flere tilfælde.</translation>
    </message>
    <message>
        <source>Lowest ζ: %1, %2 m² s.</source>
        <translation>Lavest ζ: %1, %2 m² s.</translation>
    </message>
    <message>
        <source>Lowest mean ζ: %1, %2 m² s.</source>
        <translation>Lavest gennemsnitlig ζ: %1, %2 m² s.</translation>
    </message>
    <message>
        <source>Lowest ζ: %1, %2 m² s, %3 against %4.</source>
        <translation>Lavest ζ: %1, %2 m² s, %3 mod %4.</translation>
    </message>
    <message>
        <source>Best τ of this case: %1.</source>
        <translation>Bedste τ i dette tilfælde: %1.</translation>
    </message>
    <message>
        <source>Best τ of each case, chosen in hindsight: median %1, 80 % of the cases between %2 and %3; its mean ζ is %4 against %5.</source>
        <translation>Bedste τ i hvert tilfælde, valgt bagefter: median %1, 80 % af tilfældene mellem %2 og %3; gennemsnitlig ζ er %4 mod %5.</translation>
    </message>
    <message>
        <source>Not complete.</source>
        <translation>Ikke fuldstændig.</translation>
    </message>
    <message>
        <source>Missions flown: %1 of %2. The results below use only the cases that every setting has flown: %3 of %4.</source>
        <translation>Fløjne missioner: %1 af %2. Resultaterne herunder bruger kun de tilfælde, som alle indstillinger har fløjet: %3 af %4.</translation>
    </message>
    <message>
        <source>Missions: %1. Cases: %2, each flown with every setting. Settings: %3.</source>
        <translation>Missioner: %1. Tilfælde: %2, hvert fløjet med alle indstillinger. Indstillinger: %3.</translation>
    </message>
    <message>
        <source>The numbers</source>
        <translation>Tallene</translation>
    </message>
    <message>
        <source>en</source>
        <translation>da</translation>
    </message>
    <message>
        <source>Longest unseen: from when an iceberg was known of, or seen, until it was seen again, left, was removed or the record ends.</source>
        <translation>Længst uset: fra et isbjerg blev kendt eller set, til det blev set igen, forlod området, blev fjernet eller optagelsen slutter.</translation>
    </message>
    <message>
        <source>Planned: the first sortie of the plan before take-off, over ground in straight legs. Distances flown are through the air.</source>
        <translation>Planlagt: planens første togt før start, over grunden i lige etaper. Fløjne afstande er gennem luften.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 og %2 mere</translation>
    </message>
    <message>
        <source>No clear winner. These settings may be the best: %1.</source>
        <translation>Ingen klar vinder. Disse indstillinger kan være bedst: %1.</translation>
    </message>
    <message>
        <source>Recommended: %1, %2 against %3, the closest other setting.</source>
        <translation>Anbefalet: %1, %2 mod %3, den nærmeste anden indstilling.</translation>
    </message>
    <message>
        <source>Took off</source>
        <translation>Lettet</translation>
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
        <translation>Zeta fløjet</translation>
    </message>
    <message>
        <source>Predicted before take-off</source>
        <translation>Forudsagt før start</translation>
    </message>
    <message>
        <source>Plans made</source>
        <translation>Planer lavet</translation>
    </message>
    <message>
        <source>Planned by</source>
        <translation>Planlagt efter</translation>
    </message>
    <message>
        <source>Distance planned</source>
        <translation>Distance planlagt</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % inden for</translation>
    </message>
    <message>
        <source>Something was changed in flight: the prediction was for another flight.</source>
        <translation>Noget blev ændret under flyvningen: forudsigelsen gjaldt en anden flyvning.</translation>
    </message>
    <message>
        <source>Sum of σ, m²</source>
        <translation>Sum af σ, m²</translation>
    </message>
    <message>
        <source>iceberg reached</source>
        <translation>isbjerg nået</translation>
    </message>
    <message>
        <source>Time since the start</source>
        <translation>Tid siden start</translation>
    </message>
    <message>
        <source>Zeta over time, in the end %1.</source>
        <translation>Zeta over tid, til sidst %1.</translation>
    </message>
    <message>
        <source>Lowest: %1.</source>
        <translation>Lavest: %1.</translation>
    </message>
    <message>
        <source>Lowest: %1; of the values of τ: %2.</source>
        <translation>Lavest: %1; af værdierne af τ: %2.</translation>
    </message>
    <message>
        <source>Band: quartiles. Dashed: median. Ring: reference.</source>
        <translation>Bånd: kvartiler. Stiplet: median. Ring: reference.</translation>
    </message>
    <message>
        <source>Ring: reference.</source>
        <translation>Ring: reference.</translation>
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
        <translation>%1 mod %2</translation>
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
        <translation>fastlåst i %1 af %2 tilfælde</translation>
    </message>
    <message>
        <source>stuck: visits at most two icebergs in the second half</source>
        <translation>fastlåst: besøger højst to isbjerge i anden halvdel</translation>
    </message>
    <message>
        <source>Less ζ is better: to the left</source>
        <translation>Mindre ζ er bedre: mod venstre</translation>
    </message>
    <message>
        <source>Mean of the cases with its 95 % confidence interval</source>
        <translation>Gennemsnittet af tilfældene med 95 %-konfidensinterval</translation>
    </message>
    <message>
        <source>Difference of ζ vs %1, %</source>
        <translation>Forskel i ζ til %1, %</translation>
    </message>
    <message>
        <source>the reference</source>
        <translation>referencen</translation>
    </message>
    <message>
        <source>95 %: %1 to %2</source>
        <translation>95 %: %1 til %2</translation>
    </message>
    <message>
        <source>less in %1 of %2 cases</source>
        <translation>mindre i %1 af %2 tilfælde</translation>
    </message>
    <message>
        <source>worst %1</source>
        <translation>værst %1</translation>
    </message>
    <message>
        <source>Accumulated uncertainty ζ against the trade-off τ</source>
        <translation>Akkumuleret usikkerhed ζ mod afvejningen τ</translation>
    </message>
    <message>
        <source>The line is the mean over the cases (%1), dashed their median; the band contains the middle half of them. Horizontal lines are the means of policies without τ.</source>
        <translation>Linjen er middelværdien over tilfældene (%1), stiplet er medianen; båndet indeholder den midterste halvdel af dem. Vandrette linjer er middelværdier for strategier uden τ.</translation>
    </message>
    <message>
        <source>Weighted visiting order (published method)</source>
        <translation>Vægtet besøgsrækkefølge (offentliggjort metode)</translation>
    </message>
    <message>
        <source>τ %1</source>
        <translation>τ %1</translation>
    </message>
    <message>
        <source>Weighs seeing uncertain icebergs early against path length, by τ.</source>
        <translation>Afvejer det at se usikre isbjerge tidligt mod vejens længde, med τ.</translation>
    </message>
    <message>
        <source>Weighted visiting order, trade-off τ %1</source>
        <translation>Vægtet besøgsrækkefølge, afvejning τ %1</translation>
    </message>
    <message>
        <source>Shortest path, repeated</source>
        <translation>Korteste vej, gentaget</translation>
    </message>
    <message>
        <source>Shortest path</source>
        <translation>Korteste vej</translation>
    </message>
    <message>
        <source>Flies the shortest path past all icebergs, then the next one.</source>
        <translation>Flyver den korteste vej forbi alle isbjerge, derefter den næste.</translation>
    </message>
    <message>
        <source>Shortest round tour, repeated</source>
        <translation>Korteste rundtur, gentaget</translation>
    </message>
    <message>
        <source>Round tour</source>
        <translation>Rundtur</translation>
    </message>
    <message>
        <source>Flies one shortest round tour again and again.</source>
        <translation>Flyver én korteste rundtur igen og igen.</translation>
    </message>
    <message>
        <source>Nearest iceberg first</source>
        <translation>Nærmeste isbjerg først</translation>
    </message>
    <message>
        <source>Nearest first</source>
        <translation>Nærmeste først</translation>
    </message>
    <message>
        <source>Flies to the nearest iceberg out of view.</source>
        <translation>Flyver til det nærmeste isbjerg ude af syne.</translation>
    </message>
    <message>
        <source>Most uncertain iceberg first</source>
        <translation>Mest usikre isbjerg først</translation>
    </message>
    <message>
        <source>Most uncertain first</source>
        <translation>Mest usikre først</translation>
    </message>
    <message>
        <source>Flies to the most uncertain iceberg.</source>
        <translation>Flyver til det mest usikre isbjerg.</translation>
    </message>
    <message>
        <source>Least waiting time</source>
        <translation>Korteste ventetid</translation>
    </message>
    <message>
        <source>Least waiting</source>
        <translation>Mindst ventetid</translation>
    </message>
    <message>
        <source>Keeps the waiting time of all icebergs short, weighted by their uncertainty.</source>
        <translation>Holder ventetiden for alle isbjerge kort, vægtet med deres usikkerhed.</translation>
    </message>
    <message>
        <source>Least waiting time, weighted by uncertainty</source>
        <translation>Korteste ventetid, vægtet med usikkerhed</translation>
    </message>
    <message>
        <source>Best predicted coverage</source>
        <translation>Bedste forudsagte dækning</translation>
    </message>
    <message>
        <source>Best coverage</source>
        <translation>Bedste dækning</translation>
    </message>
    <message>
        <source>Predicts zeta for paths that pass icebergs at an offset and see several at once.</source>
        <translation>Forudsiger zeta for baner, der passerer isbjerge på afstand og ser flere på én gang.</translation>
    </message>
    <message>
        <source>Zeta by start time</source>
        <translation>Zeta efter starttid</translation>
    </message>
    <message>
        <source>Start, UTC</source>
        <translation>Start, UTC</translation>
    </message>
    <message>
        <source>Faint: marginal or unknown weather. Hatched: no-go.</source>
        <translation>Svag farve: marginalt eller ukendt vejr. Skraveret: flyv ikke.</translation>
    </message>
    <message>
        <source>Best start: %1 UTC.</source>
        <translation>Bedste start: %1 UTC.</translation>
    </message>
    <message>
        <source>No start has weather within all limits.</source>
        <translation>Ingen start har vejr inden for alle grænser.</translation>
    </message>
    <message>
        <source>cannot be flown</source>
        <translation>kan ikke flyves</translation>
    </message>
    <message>
        <source>weather: %1</source>
        <translation>vejr: %1</translation>
    </message>
    <message>
        <source>go</source>
        <translation>flyv</translation>
    </message>
    <message>
        <source>marginal</source>
        <translation>marginalt</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>ikke kendt</translation>
    </message>
    <message>
        <source>no-go</source>
        <translation>flyv ikke</translation>
    </message>
    <message>
        <source>Forecast</source>
        <translation>Prognose</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Kilde</translation>
    </message>
    <message>
        <source>Issued</source>
        <translation>Udstedt</translation>
    </message>
    <message>
        <source>Age at take-off</source>
        <translation>Alder ved start</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>ukendt</translation>
    </message>
    <message>
        <source>Used in flight, at the middle of the starts of the UAVs.</source>
        <translation>Brugt under flyvningen, midt mellem dronernes startsteder.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Wind, true</source>
        <translation>Vind, retvisende</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Vindstød</translation>
    </message>
    <message>
        <source>Current, true</source>
        <translation>Strøm, retvisende</translation>
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
        <translation>%1 mod %2</translation>
    </message>
    <message>
        <source>The forecast has no wind between %1 and %2: the flight used the constant wind of the scenario.</source>
        <translation>Prognosen har ingen vind mellem %1 og %2: flyvningen brugte scenariets faste vind.</translation>
    </message>
    <message>
        <source>The forecast has no current between %1 and %2: the flight used the constant current of the scenario.</source>
        <translation>Prognosen har ingen strøm mellem %1 og %2: flyvningen brugte scenariets faste strøm.</translation>
    </message>
</context>
<context>
    <name>SelectTool</name>
    <message>
        <source>Release to place it here. Esc cancels.</source>
        <translation>Slip for at placere det her. Esc annullerer.</translation>
    </message>
    <message>
        <source>Everything inside the frame is selected.</source>
        <translation>Alt inden for rammen vælges.</translation>
    </message>
    <message>
        <source>Click to select, drag to move. Ctrl+click adds; drag on open water to select a box.</source>
        <translation>Klik for at vælge, træk for at flytte. Ctrl+klik føjer til; træk på åbent vand for at vælge med en ramme.</translation>
    </message>
    <message>
        <source>Click to select. In flight you can drag the tip of the wind arrow and the asset.</source>
        <translation>Klik for at vælge. Under flyvning kan du trække i spidsen af vindpilen og i objektet.</translation>
    </message>
    <message>
        <source>Click to select. Choose Stop and edit to change the scenario.</source>
        <translation>Klik for at vælge. Vælg Stop og redigér for at ændre scenariet.</translation>
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
        <translation>CPLEX, gennemsnit (artiklen)</translation>
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
        <translation>Lokalsøgning</translation>
    </message>
    <message>
        <source>CBC, by position</source>
        <translation>CBC, efter plads</translation>
    </message>
    <message>
        <source>CBC, as printed</source>
        <translation>CBC, som trykt</translation>
    </message>
    <message>
        <source>CBC, reduced</source>
        <translation>CBC, reduceret</translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>ship&apos;s radar</source>
        <translation>skibsradar</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>øjet</translation>
    </message>
    <message>
        <source>satellite</source>
        <translation>satellit</translation>
    </message>
    <message>
        <source>camera of a UAV</source>
        <translation>kamera på en drone</translation>
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
        <translation>%1, 95 % inden for %2</translation>
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
        <translation>Bedste τ i hvert tilfælde</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <comment>from, to</comment>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>reference</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 til %2</translation>
    </message>
    <message>
        <source>The τ of lowest ζ of each case, chosen in hindsight: median %1, quartiles %2 and %3.</source>
        <translation>Den τ, der har lavest ζ i hvert tilfælde, valgt bagefter: median %1, kvartiler %2 og %3.</translation>
    </message>
    <message>
        <source>Less than the reference in %1 of %2 cases, worst %3. On average %4 visits.</source>
        <translation>Mindre end referencen i %1 af %2 tilfælde, værst %3. I gennemsnit %4 besøg.</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>fastlåst</translation>
    </message>
    <message>
        <source>%1 visits, %2 plans, %3 flown. Return or a double click opens this run.</source>
        <translation>%1 besøg, %2 planer, %3 fløjet. Enter eller et dobbeltklik åbner denne flyvning.</translation>
    </message>
    <message>
        <source>Random %1</source>
        <comment>scenario drawn from a seed</comment>
        <translation>Tilfældigt %1</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Indstilling</translation>
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
        <translation>mod reference</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95 %-interval</translation>
    </message>
    <message>
        <source>Best in</source>
        <translation>Bedst i</translation>
    </message>
    <message>
        <source>Stuck</source>
        <translation>Fastlåst</translation>
    </message>
    <message>
        <source>How the next iceberg is chosen.</source>
        <translation>Hvordan det næste isbjerg vælges.</translation>
    </message>
    <message>
        <source>Accumulated uncertainty in m² s, mean of all cases: less is better.</source>
        <translation>Akkumuleret usikkerhed i m² s, gennemsnit af alle tilfælde: mindre er bedre.</translation>
    </message>
    <message>
        <source>Half of the cases have less.</source>
        <translation>Halvdelen af tilfældene har mindre.</translation>
    </message>
    <message>
        <source>A quarter of the cases has less than the first, a quarter more than the second.</source>
        <translation>En fjerdedel af tilfældene har mindre end den første, en fjerdedel mere end den anden.</translation>
    </message>
    <message>
        <source>Mean of the differences, case by case, in per cent of the reference.</source>
        <translation>Gennemsnittet af forskellene, tilfælde for tilfælde, i procent af referencen.</translation>
    </message>
    <message>
        <source>Confidence interval of the mean difference by Student&apos;s t.</source>
        <translation>Konfidensinterval for den gennemsnitlige forskel efter Students t.</translation>
    </message>
    <message>
        <source>Cases in which no other setting has less ζ.</source>
        <translation>Tilfælde, hvor ingen anden indstilling har mindre ζ.</translation>
    </message>
    <message>
        <source>Cases that visit at most two icebergs in the second half.</source>
        <translation>Tilfælde, der besøger højst to isbjerge i anden halvdel.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Tilfælde</translation>
    </message>
    <message>
        <source>Noise seed</source>
        <translation>Støjens startværdi</translation>
    </message>
    <message>
        <source>ζ, m² s</source>
        <translation>ζ, m² s</translation>
    </message>
    <message>
        <source>Best τ</source>
        <translation>Bedste τ</translation>
    </message>
    <message>
        <source>Best of all</source>
        <translation>Bedst af alle</translation>
    </message>
    <message>
        <source>Name of the scenario, or the seed it was drawn from.</source>
        <translation>Scenariets navn eller den startværdi, det blev trukket fra.</translation>
    </message>
    <message>
        <source>Seed of the true drift, the same for every setting.</source>
        <translation>Startværdi for den sande drift, den samme for hver indstilling.</translation>
    </message>
    <message>
        <source>Accumulated uncertainty of this flight: less is better.</source>
        <translation>Akkumuleret usikkerhed for denne flyvning: mindre er bedre.</translation>
    </message>
    <message>
        <source>Compared with the flight of this case with the reference.</source>
        <translation>Sammenlignet med dette tilfældes flyvning med referencen.</translation>
    </message>
    <message>
        <source>The τ with the lowest ζ in this case, in hindsight.</source>
        <translation>Den τ, der har den laveste ζ i dette tilfælde, bestemt bagefter.</translation>
    </message>
    <message>
        <source>The setting with the lowest ζ in this case.</source>
        <translation>Den indstilling, der har den laveste ζ i dette tilfælde.</translation>
    </message>
    <message>
        <source>Visits at most two icebergs in the second half.</source>
        <translation>Besøger højst to isbjerge i anden halvdel.</translation>
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
        <translation>Dag og måned i »%1« kan læses på to måder. Skriv datoen som 2026-11-29 12:00.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no date. Type it like 2026-11-29 12:00.</source>
        <translation>»%1« har ingen dato. Skriv det som 2026-11-29 12:00.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a date and time. Type it like 2026-11-29 12:00 or 29 Nov 2026 12:00.</source>
        <translation>»%1« er ikke en dato med klokkeslæt. Skriv det som 2026-11-29 12:00 eller 29 Nov 2026 12:00.</translation>
    </message>
</context>
<context>
    <name>WeatherChart</name>
    <message>
        <source>Wind limit %1</source>
        <translation>Vindgrænse %1</translation>
    </message>
    <message>
        <source>Gust limit %1</source>
        <translation>Vindstødsgrænse %1</translation>
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
        <translation>vindstød %1</translation>
    </message>
    <message>
        <source>current %1 towards %2</source>
        <translation>strøm %1 mod %2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>ukendt</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>fra %1</translation>
    </message>
    <message>
        <source>towards %1</source>
        <translation>mod %1</translation>
    </message>
    <message>
        <source>Forecast of wind and current</source>
        <translation>Prognose for vind og strøm</translation>
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
        <translation>Vindstød</translation>
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
        <translation>Prognosen dækker ikke denne flyvning</translation>
    </message>
    <message>
        <source>Weather at %1: %2.</source>
        <translation>Vejr kl. %1: %2.</translation>
    </message>
    <message>
        <source>Flown in gaps: constant wind %1</source>
        <translation>Fløjet i huller: fast vind %1</translation>
    </message>
    <message>
        <source>%1; in gaps the constant current of %2</source>
        <comment>title, speed</comment>
        <translation>%1; i huller den faste strøm på %2</translation>
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
        <translation>vindstød</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>sigt</translation>
    </message>
    <message>
        <source>cloud base</source>
        <translation>skybase</translation>
    </message>
    <message>
        <source>icing</source>
        <translation>isdannelse</translation>
    </message>
    <message>
        <source>%1 UTC</source>
        <translation>%1 UTC</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Flyv</translation>
    </message>
    <message>
        <source>Marginal</source>
        <translation>Marginalt</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>Ikke kendt</translation>
    </message>
    <message>
        <source>No-go</source>
        <translation>Flyv ikke</translation>
    </message>
    <message>
        <source>%1 not known, limit %2</source>
        <translation>%1 ikke kendt, grænse %2</translation>
    </message>
    <message>
        <source>%1 %2, limit %3</source>
        <comment>wind, its value, its limit</comment>
        <translation>%1 %2, grænse %3</translation>
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
fra %2, kraftig</translation>
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
mod %2</translation>
    </message>
    <message>
        <source>The arrow points downwind. The ring is the airspeed of the slowest UAV (%1); beyond the dashed ring UAVs make little headway.</source>
        <translation>Pilen peger derhen, hvor vinden blæser. Ringen er den langsomste drones flyvefart (%1); uden for den stiplede ring kommer droner næsten ikke frem.</translation>
    </message>
    <message>
        <source>The small aircraft in the middle of a leg shows the heading flown there.</source>
        <translation>Det lille fly midt på en etape viser den kurs, der flyves der.</translation>
    </message>
    <message>
        <source>reported</source>
        <translation>meldt</translation>
    </message>
    <message>
        <source>forecast</source>
        <translation>prognose</translation>
    </message>
    <message>
        <source>Gusts %1</source>
        <translation>Vindstød %1</translation>
    </message>
    <message>
        <source>UAVs fly in the wind that the crew has reported, and icebergs drift in the forecast.</source>
        <translation>Dronerne flyver i den vind, som besætningen har meldt, og isbjergene driver i prognosen.</translation>
    </message>
    <message>
        <source>Remove the forecast in the Inspector to set the wind yourself.</source>
        <translation>Fjern prognosen i Egenskaber for selv at sætte vinden.</translation>
    </message>
</context>
<context>
    <name>WorkFailureText</name>
    <message>
        <source>Not enough memory. Close other programs or choose a smaller task.</source>
        <translation>Ikke nok hukommelse. Luk andre programmer, eller vælg en mindre opgave.</translation>
    </message>
    <message>
        <source>Internal error: %1</source>
        <translation>Intern fejl: %1</translation>
    </message>
</context>
<context>
    <name>berg::AircraftController</name>
    <message>
        <source>%1: no contact for %2</source>
        <translation>%1: ingen kontakt i %2</translation>
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
        <translation>Afviger: missionen om bord er ændret siden %1</translation>
    </message>
    <message>
        <source>Differs: the plan has changed since %1</source>
        <translation>Afviger: planen er ændret siden %1</translation>
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
        <translation>Forbindelse: afspilning</translation>
    </message>
    <message>
        <source>Stop listening before you play a log.</source>
        <translation>Hold op med at lytte, før du afspiller en log.</translation>
    </message>
    <message>
        <source>%1 is not a telemetry log, or its beginning is damaged.</source>
        <translation>%1 er ikke en telemetrilog, eller begyndelsen er beskadiget.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 kan ikke læses: %2</translation>
    </message>
    <message>
        <source>Differs: home has moved since %1</source>
        <translation>Afviger: hjem har flyttet sig siden %1</translation>
    </message>
    <message>
        <source>%1 can be reached from the network, and MAVLink does not check who sends.</source>
        <translation>%1 kan nås fra netværket, og MAVLink kontrollerer ikke, hvem der sender.</translation>
    </message>
    <message>
        <source>the mission was not replaced. Steering is off</source>
        <translation>missionen blev ikke erstattet. Styringen er slået fra</translation>
    </message>
    <message>
        <source>steering is off, because sending is</source>
        <translation>styringen er slået fra, fordi der ikke sendes</translation>
    </message>
    <message>
        <source>the plan has changed meanwhile. Nothing was sent</source>
        <translation>planen er ændret imens. Intet blev sendt</translation>
    </message>
    <message>
        <source>its UAV has no plan. Nothing was sent</source>
        <translation>dens drone har ingen plan. Intet blev sendt</translation>
    </message>
    <message>
        <source>%1. The aircraft keeps its own fence</source>
        <translation>%1. Luftfartøjet beholder sit eget hegn</translation>
    </message>
    <message>
        <source>Telemetry logs (*.tlog *.nmea);;All files (*)</source>
        <translation>Telemetrilogge (*.tlog *.nmea);;Alle filer (*)</translation>
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
        <translation>Punkt %1 af %2</translation>
    </message>
    <message>
        <source>Item %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>Frames lost: %1 of %2</source>
        <translation>Mistede rammer: %1 af %2</translation>
    </message>
    <message>
        <source>Listen</source>
        <translation>Lyt</translation>
    </message>
    <message>
        <source>Receives telemetry at this address. Nothing is sent.</source>
        <translation>Modtager telemetri på denne adresse. Intet sendes.</translation>
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
        <translation>Send op</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Sammenlign</translation>
    </message>
    <message>
        <source>Reads the mission on board and compares it with the plan.</source>
        <translation>Læser missionen om bord og sammenligner den med planen.</translation>
    </message>
    <message>
        <source>Fly the mission</source>
        <translation>Flyv missionen</translation>
    </message>
    <message>
        <source>Selects the mode in which the aircraft flies the mission on board. It must be in the air.</source>
        <translation>Vælger den tilstand, hvor luftfartøjet flyver missionen om bord. Det skal være i luften.</translation>
    </message>
    <message>
        <source>Use its wind</source>
        <translation>Brug vinden</translation>
    </message>
    <message>
        <source>The mean wind of the last minute becomes the wind of the scenario.</source>
        <translation>Middelvinden i det seneste minut bliver scenariets vind.</translation>
    </message>
    <message>
        <source>Fly with the aircraft</source>
        <translation>Flyv med luftfartøjet</translation>
    </message>
    <message>
        <source>The flight in this window follows the aircraft: charts and uncertainty show the real flight.</source>
        <translation>Flyvningen i vinduet følger luftfartøjet: diagrammer og usikkerhed viser den virkelige flyvning.</translation>
    </message>
    <message>
        <source>Events of the link</source>
        <translation>Hændelser på forbindelsen</translation>
    </message>
    <message>
        <source>Address of the link</source>
        <translation>Forbindelsens adresse</translation>
    </message>
    <message>
        <source>udp:HOST:PORT listens, udpout:HOST:PORT sends to one address; also tcp:HOST:PORT and serial:DEVICE:BAUD</source>
        <translation>udp:VÆRT:PORT lytter, udpout:VÆRT:PORT sender til én adresse; også tcp:VÆRT:PORT og serial:ENHED:BAUD</translation>
    </message>
    <message>
        <source>Off: not a byte is sent. On: heartbeats, requests for telemetry and what you choose below are sent.</source>
        <translation>Fra: ikke en byte sendes. Til: livstegn, anmodninger om telemetri og det, du vælger nedenfor, sendes.</translation>
    </message>
    <message>
        <source>Aircraft heard</source>
        <translation>Hørte luftfartøjer</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Luftfartøjer</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Tilstand</translation>
    </message>
    <message>
        <source>Last position</source>
        <translation>Seneste position</translation>
    </message>
    <message>
        <source>Flies as</source>
        <translation>Flyver som</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Styring</translation>
    </message>
    <message>
        <source>Do not steer</source>
        <translation>Styr ikke</translation>
    </message>
    <message>
        <source>Replace the mission when the plan changes</source>
        <translation>Erstat missionen, når planen ændres</translation>
    </message>
    <message>
        <source>Guide from iceberg to iceberg</source>
        <translation>Led fra isbjerg til isbjerg</translation>
    </message>
    <message>
        <source>No UAV</source>
        <translation>Ingen drone</translation>
    </message>
    <message>
        <source>The link is off.</source>
        <translation>Forbindelsen er slået fra.</translation>
    </message>
    <message>
        <source>Listening. No aircraft has been heard yet.</source>
        <translation>Lytter. Intet luftfartøj er hørt endnu.</translation>
    </message>
    <message>
        <source>No position yet. Some autopilots report it only while Send is on.</source>
        <translation>Ingen position endnu. Nogle autopiloter melder den kun, mens Send er slået til.</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>ingen kontakt</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>ingen endnu</translation>
    </message>
    <message>
        <source>The flight follows the aircraft</source>
        <translation>Flyvningen følger luftfartøjet</translation>
    </message>
    <message>
        <source>%1  Attention: %2</source>
        <translation>%1  OBS: %2</translation>
    </message>
    <message>
        <source>No aircraft in the log so far.</source>
        <translation>Intet luftfartøj i loggen indtil nu.</translation>
    </message>
    <message>
        <source>Simulated aircraft fly from the UAVs of the scenario and send their telemetry over the network of this computer. Not while another link is open.</source>
        <translation>Simulerede luftfartøjer flyver fra scenariets droner og sender deres telemetri over netværket på denne computer. Ikke mens en anden forbindelse er åben.</translation>
    </message>
    <message>
        <source>Uploads the plan with its fence and rally point, reads it back and compares it. If the plan has no fence, the aircraft keeps its own.</source>
        <translation>Sender planen med dens hegn og samlingspunkt, læser den tilbage og sammenligner. Har planen intet hegn, beholder luftfartøjet sit eget.</translation>
    </message>
</context>
<context>
    <name>berg::AlarmStrip</name>
    <message>
        <source>Acknowledge</source>
        <translation>Kvittér</translation>
    </message>
    <message>
        <source>Removes this notice. It returns if the condition ends and occurs again.</source>
        <translation>Fjerner denne meddelelse. Den kommer tilbage, hvis tilstanden ophører og opstår igen.</translation>
    </message>
    <message>
        <source>Continue from here</source>
        <translation>Fortsæt herfra</translation>
    </message>
    <message>
        <source>Discards the flight after this instant. From here you can change the trade-off and the policy and fly another path.</source>
        <translation>Kasserer flyvningen efter dette øjeblik. Herfra kan du ændre afvejning og strategi og flyve en anden bane.</translation>
    </message>
    <message>
        <source>Back to latest</source>
        <translation>Tilbage til seneste</translation>
    </message>
    <message>
        <source>Goes to the latest instant of the flight.</source>
        <translation>Går til det seneste øjeblik af flyvningen.</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Kontrol</translation>
    </message>
    <message>
        <source>Lists all findings in the scenario.</source>
        <translation>Viser alle fund i scenariet.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Gendan</translation>
    </message>
    <message>
        <source>Continues the flight where it was left.</source>
        <translation>Fortsætter flyvningen, hvor den blev forladt.</translation>
    </message>
    <message>
        <source>No alarms</source>
        <translation>Ingen alarmer</translation>
    </message>
    <message>
        <source>Cannot be planned: %1</source>
        <translation>Kan ikke planlægges: %1</translation>
    </message>
    <message>
        <source>Looking back at %1</source>
        <translation>Ser tilbage på %1</translation>
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
        <translation>Klik for at vise det på kortet.</translation>
    </message>
    <message>
        <source>Acknowledged: %1</source>
        <translation>Kvitteret: %1</translation>
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
        <translation>%1 indeholder ingen punkter, linjer eller polygoner</translation>
    </message>
    <message>
        <source>The background map %1 cannot be read</source>
        <translation>Baggrundskortet %1 kan ikke læses</translation>
    </message>
    <message>
        <source>%1 is neither GeoJSON nor KML. Convert it with a map program, such as QGIS, and choose it again.</source>
        <translation>%1 er hverken GeoJSON eller KML. Konvertér filen med et kortprogram, f.eks. QGIS, og vælg den igen.</translation>
    </message>
    <message>
        <source>Maps (*.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;All files (*)</source>
        <translation>Kort (*.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;Alle filer (*)</translation>
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
        <translation>Gemte %1</translation>
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
        <translation>Størrelse vist over tid</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linjer</translation>
    </message>
    <message>
        <source>Choose the lines to show</source>
        <translation>Vælg viste linjer</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Følg</translation>
    </message>
    <message>
        <source>Keep the newest minutes in view (End). The wheel zooms, the right button drags.</source>
        <translation>Hold de nyeste minutter i syne (End). Hjulet zoomer, højre knap trækker.</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Show everything from take-off on (Home, or a double click)</source>
        <translation>Vis alt fra start og frem (Home eller dobbeltklik)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Eksportér…</translation>
    </message>
    <message>
        <source>Save the chart as a picture (PNG, SVG, PDF) or its numbers as CSV</source>
        <translation>Gem diagrammet som billede (PNG, SVG, PDF) eller dets tal som CSV</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Vis alle</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-billede (*.png)</translation>
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
        <translation>Taltabel (*.csv)</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Kopiér billede</translation>
    </message>
    <message>
        <source>Copy numbers</source>
        <translation>Kopiér tal</translation>
    </message>
    <message>
        <source>Save picture or numbers...</source>
        <translation>Gem billede eller tal...</translation>
    </message>
    <message>
        <source>Reset zoom</source>
        <translation>Nulstil zoom</translation>
    </message>
    <message>
        <source>Values of the lines</source>
        <translation>Linjernes værdier</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linje</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Værdi</translation>
    </message>
</context>
<context>
    <name>berg::CheckPanel</name>
    <message>
        <source>Error: must be fixed before planning</source>
        <translation>Fejl: skal rettes før planlægning</translation>
    </message>
    <message>
        <source>Warning: probably not intended</source>
        <translation>Advarsel: sandsynligvis ikke tilsigtet</translation>
    </message>
    <message>
        <source>Hint: good to know</source>
        <translation>Tip: godt at vide</translation>
    </message>
    <message>
        <source>No problems found</source>
        <translation>Ingen problemer fundet</translation>
    </message>
    <message>
        <source>Findings about the scenario</source>
        <translation>Fund om scenariet</translation>
    </message>
</context>
<context>
    <name>berg::ComparisonChart</name>
    <message>
        <source>Comparison of accumulated uncertainty</source>
        <translation>Sammenligning af akkumuleret usikkerhed</translation>
    </message>
    <message>
        <source>This chart compares runs of one scenario.</source>
        <translation>Dette diagram sammenligner flyvninger af samme scenarie.</translation>
    </message>
    <message>
        <source>%1.
Less ζ is better. Plain shade: A, %2, has less. Hatched: B, %3, has less.</source>
        <translation>%1.
Mindre ζ er bedre. Jævn skygge: A, %2, har mindre. Skraveret: B, %3, har mindre.</translation>
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
        <translation>Sammenligningens tal</translation>
    </message>
    <message>
        <source>Longest time unseen</source>
        <translation>Længste tid uset</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Tal</translation>
    </message>
    <message>
        <source>Unseen</source>
        <translation>Uset</translation>
    </message>
    <message>
        <source>Longest time for which each iceberg was out of view.</source>
        <translation>Længste tid, hvert isbjerg var ude af syne.</translation>
    </message>
    <message>
        <source>Progress of the flight in the background</source>
        <translation>Fremskridt for flyvningen i baggrunden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annullér</translation>
    </message>
    <message>
        <source>τ</source>
        <translation>τ</translation>
    </message>
    <message>
        <source>Trade-off τ to fly</source>
        <translation>Afvejning τ, der skal flyves</translation>
    </message>
    <message>
        <source>0: most uncertain first; the larger, the shorter the route.</source>
        <translation>0: mest usikre først; jo større, jo kortere rute.</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>Flyv</translation>
    </message>
    <message>
        <source>Flies the same scenario with this τ in the background.</source>
        <translation>Flyver samme scenarie med denne τ i baggrunden.</translation>
    </message>
    <message>
        <source>Open run…</source>
        <translation>Åbn flyvning…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Removes the chosen run from the list.</source>
        <translation>Fjerner den valgte flyvning fra listen.</translation>
    </message>
    <message>
        <source>Flying %1: %2 of %3</source>
        <translation>Flyver %1: %2 af %3</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Åbner %1</translation>
    </message>
    <message>
        <source>The reference A is the tour itself: choose another one as A.</source>
        <translation>Referencen A er selve rundturen: vælg en anden som A.</translation>
    </message>
    <message>
        <source>Flies the same scenario along the shortest closed tour through all icebergs, as in Figure 5 of the paper, in the background.</source>
        <translation>Flyver samme scenarie i baggrunden ad den korteste lukkede rundtur gennem alle isbjerge, som i figur 5 i artiklen.</translation>
    </message>
    <message>
        <source>Compare with the round tour</source>
        <translation>Sammenlign med rundturen</translation>
    </message>
    <message>
        <source>Runs (*.bergrun);;All files (*)</source>
        <translation>Flyvninger (*.bergrun);;Alle filer (*)</translation>
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
        <translation>Enhver drone må besøge det</translation>
    </message>
    <message>
        <source>Show in the inspector</source>
        <translation>Vis i Egenskaber</translation>
    </message>
    <message>
        <source>Edit in the inspector</source>
        <translation>Redigér i Egenskaber</translation>
    </message>
    <message>
        <source>Remove asset</source>
        <translation>Fjern objekt</translation>
    </message>
    <message>
        <source>Remove area</source>
        <translation>Fjern område</translation>
    </message>
    <message>
        <source>New iceberg here</source>
        <translation>Nyt isbjerg her</translation>
    </message>
    <message>
        <source>New UAV here</source>
        <translation>Ny drone her</translation>
    </message>
    <message>
        <source>Paste here</source>
        <translation>Sæt ind her</translation>
    </message>
    <message>
        <source>Ground station here</source>
        <translation>Jordstation her</translation>
    </message>
    <message>
        <source>Place ground station</source>
        <translation>Placér jordstation</translation>
    </message>
    <message>
        <source>Remove no-fly area</source>
        <translation>Fjern flyveforbudsområde</translation>
    </message>
    <message>
        <source>Copy coordinates: %1</source>
        <translation>Kopiér koordinater: %1</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>Kopierede %1</translation>
    </message>
    <message>
        <source>Centre the map here</source>
        <translation>Centrér kortet her</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>Mål herfra</translation>
    </message>
    <message>
        <source>Place asset</source>
        <translation>Placér objekt</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Fold ud</translation>
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
        <translation>Flyveforbudsområde</translation>
    </message>
</context>
<context>
    <name>berg::Docks</name>
    <message>
        <source>Trade-off</source>
        <translation>Afvejning</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Egenskaber</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historik</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Hændelser</translation>
    </message>
    <message>
        <source>Comparison chart</source>
        <translation>Sammenligningsdiagram</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Kontrol</translation>
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
        <translation>Isbjerge</translation>
    </message>
    <message>
        <source>Map layers</source>
        <translation>Kortlag</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meddelelser</translation>
    </message>
    <message>
        <source>Trade-off τ, policy, solver and route</source>
        <translation>Afvejning τ, strategi, løser og rute</translation>
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
        <translation>Andet diagram</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Luftfartøjer</translation>
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
        <translation>Hændelse</translation>
    </message>
    <message>
        <source>How it was planned</source>
        <translation>Hvordan det blev planlagt</translation>
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
        <translation>Missionens hændelser</translation>
    </message>
</context>
<context>
    <name>berg::ExampleCard</name>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n isbjerg</numerusform>
            <numerusform>%n isbjerge</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Eksport</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fil</translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation>&amp;Gennemse...</translation>
    </message>
    <message>
        <source>Name the file.</source>
        <translation>Navngiv filen.</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>Eksportér til</translation>
    </message>
    <message>
        <source>Format of the file</source>
        <translation>Filens format</translation>
    </message>
    <message>
        <source>Not possible</source>
        <translation>Ikke muligt</translation>
    </message>
    <message>
        <source>%1, %2, to %3</source>
        <translation>%1, %2, til %3</translation>
    </message>
    <message>
        <source>The file exists. Bergwatch asks before it overwrites it.</source>
        <translation>Filen findes. Bergwatch spørger, før den overskrives.</translation>
    </message>
    <message>
        <source>Working ...</source>
        <translation>Arbejder ...</translation>
    </message>
    <message>
        <source>Nothing was changed or left out.</source>
        <translation>Intet blev ændret eller udeladt.</translation>
    </message>
</context>
<context>
    <name>berg::ExportOptionsView</name>
    <message>
        <source>What was flown</source>
        <translation>Det fløjne</translation>
    </message>
    <message>
        <source>The whole order</source>
        <translation>Hele rækkefølgen</translation>
    </message>
    <message>
        <source>The first leg</source>
        <translation>Den første etape</translation>
    </message>
    <message>
        <source>The path with turns</source>
        <translation>Banen med drej</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>&amp;Hvad</translation>
    </message>
    <message>
        <source>All UAVs</source>
        <translation>Alle droner</translation>
    </message>
    <message>
        <source>&amp;UAV</source>
        <translation>&amp;Drone</translation>
    </message>
    <message>
        <source>As in the scenario</source>
        <translation>Som i scenariet</translation>
    </message>
    <message>
        <source>&amp;Altitude</source>
        <translation>Hø&amp;jde</translation>
    </message>
    <message>
        <source>Air&amp;speed</source>
        <translation>Flyvefa&amp;rt</translation>
    </message>
    <message>
        <source>A&amp;cceptance radius</source>
        <translation>&amp;Acceptradius</translation>
    </message>
    <message>
        <source>None: fly over</source>
        <translation>Ingen: flyv over</translation>
    </message>
    <message>
        <source>&amp;Loiter turns</source>
        <translation>&amp;Kredsninger</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nej</translation>
    </message>
    <message>
        <source>&amp;Return home</source>
        <translation>Fl&amp;yv hjem</translation>
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
        <translation>Isbjerg</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
    </message>
    <message>
        <source>Waypoints of the file</source>
        <translation>Filens rutepunkter</translation>
    </message>
    <message>
        <source>Map of what is exported</source>
        <translation>Kort over det, der eksporteres</translation>
    </message>
    <message>
        <source>How the file begins</source>
        <translation>Filens begyndelse</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Kort</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Rutepunkter</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Preview of the page</source>
        <translation>Forhåndsvisning af siden</translation>
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
        <translation>Vises på kortet i stedet for id&apos;et.</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Øst</translation>
    </message>
    <message>
        <source>Position at the start, east of the scenario&apos;s origin.</source>
        <translation>Position ved starten, øst for scenariets origo.</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>Position at the start, north of the scenario&apos;s origin.</source>
        <translation>Position ved starten, nord for scenariets origo.</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Clockwise from north, at the start.</source>
        <translation>Med uret fra nord, ved starten.</translation>
    </message>
    <message>
        <source>Airspeed</source>
        <translation>Flyvefart</translation>
    </message>
    <message>
        <source>Must exceed the wind speed.</source>
        <translation>Skal være over vindens fart.</translation>
    </message>
    <message>
        <source>Maximum bank angle</source>
        <translation>Største krængning</translation>
    </message>
    <message>
        <source>Bank in a turn; the larger, the tighter the turns.</source>
        <translation>Krængning i et drej; jo større, jo snævrere drej.</translation>
    </message>
    <message>
        <source>View along-track</source>
        <translation>Synsfelt på langs</translation>
    </message>
    <message>
        <source>Extent of the field of view along the heading.</source>
        <translation>Synsfeltets udstrækning langs kursen.</translation>
    </message>
    <message>
        <source>View cross-track</source>
        <translation>Synsfelt på tværs</translation>
    </message>
    <message>
        <source>Extent of the field of view across the heading.</source>
        <translation>Synsfeltets udstrækning på tværs af kursen.</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Højde</translation>
    </message>
    <message>
        <source>Height above sea level. UAVs at least %1 apart in height may pass each other.</source>
        <translation>Højde over havet. Droner med mindst %1 højdeforskel kan passere hinanden.</translation>
    </message>
    <message>
        <source>unlimited</source>
        <translation>ubegrænset</translation>
    </message>
    <message>
        <source>Endurance</source>
        <translation>Udholdenhed</translation>
    </message>
    <message>
        <source>Longest flight; the UAV is home before it ends. At 0 it lands only when ordered to return.</source>
        <translation>Længste flyvning; dronen er hjemme, før den slutter. Ved 0 lander den kun efter ordre om at flyve hjem.</translation>
    </message>
    <message>
        <source>Home east</source>
        <translation>Hjem øst</translation>
    </message>
    <message>
        <source>Landing place, east of the scenario&apos;s origin.</source>
        <translation>Landingssted, øst for scenariets origo.</translation>
    </message>
    <message>
        <source>Home north</source>
        <translation>Hjem nord</translation>
    </message>
    <message>
        <source>Landing place, north of the scenario&apos;s origin.</source>
        <translation>Landingssted, nord for scenariets origo.</translation>
    </message>
    <message>
        <source>Turn-around</source>
        <translation>Vendetid</translation>
    </message>
    <message>
        <source>Time on the ground between landing and the next take-off.</source>
        <translation>Tid på jorden mellem landing og næste start.</translation>
    </message>
    <message>
        <source>Reserve</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>Share of the endurance that plans leave unused.</source>
        <translation>Den del af udholdenheden, som planer ikke bruger.</translation>
    </message>
    <message>
        <source>by percentage</source>
        <translation>efter procentdel</translation>
    </message>
    <message>
        <source>Fixed reserve</source>
        <translation>Fast reserve</translation>
    </message>
    <message>
        <source>Reserve as a time, in place of the percentage.</source>
        <translation>Reserve som en tid i stedet for procentdelen.</translation>
    </message>
    <message>
        <source>Climb</source>
        <translation>Stigning</translation>
    </message>
    <message>
        <source>Time from take-off to the flight altitude.</source>
        <translation>Tid fra start til flyvehøjden.</translation>
    </message>
    <message>
        <source>Landing</source>
        <translation>Landing</translation>
    </message>
    <message>
        <source>Time from the flight altitude above home to the ground.</source>
        <translation>Tid fra flyvehøjden, over hjemmepunktet, til jorden.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>Wind limit</source>
        <translation>Vindgrænse</translation>
    </message>
    <message>
        <source>Strongest wind in which the UAV may fly.</source>
        <translation>Kraftigste vind, dronen må flyve i.</translation>
    </message>
    <message>
        <source>Gust limit</source>
        <translation>Vindstødsgrænse</translation>
    </message>
    <message>
        <source>Strongest gusts in which the UAV may fly.</source>
        <translation>Kraftigste vindstød, dronen må flyve i.</translation>
    </message>
    <message>
        <source>Icing conditions</source>
        <translation>Isningsforhold</translation>
    </message>
    <message>
        <source>Whether the UAV may fly below 0 °C in nearly saturated air.</source>
        <translation>Om dronen må flyve under 0 °C i næsten mættet luft.</translation>
    </message>
    <message>
        <source>each time step</source>
        <translation>hvert tidsskridt</translation>
    </message>
    <message>
        <source>Autopilot rate</source>
        <translation>Autopilotens takt</translation>
    </message>
    <message>
        <source>Time between two commands of the autopilot; at 0 it commands at each time step.</source>
        <translation>Tid mellem to kommandoer fra autopiloten; ved 0 giver den én i hvert tidsskridt.</translation>
    </message>
    <message>
        <source>Drift east</source>
        <translation>Drift mod øst</translation>
    </message>
    <message>
        <source>Known drift to the east, without the current.</source>
        <translation>Kendt drift mod øst, uden strømmen.</translation>
    </message>
    <message>
        <source>Drift north</source>
        <translation>Drift mod nord</translation>
    </message>
    <message>
        <source>Known drift to the north, without the current.</source>
        <translation>Kendt drift mod nord, uden strømmen.</translation>
    </message>
    <message>
        <source>Drift error</source>
        <translation>Driftfejl</translation>
    </message>
    <message>
        <source>Standard deviation of the error of the known drift, along each axis.</source>
        <translation>Standardafvigelse for fejlen i den kendte drift, langs hver akse.</translation>
    </message>
    <message>
        <source>Drift variation</source>
        <translation>Variation i drift</translation>
    </message>
    <message>
        <source>Long-term standard deviation of the drift about the current, along each axis. Example, a beacon off Canada: 0.15 m/s.</source>
        <translation>Standardafvigelse på lang sigt for driften omkring strømmen, langs hver akse. Eksempel, en bøje ud for Canada: 0,15 m/s.</translation>
    </message>
    <message>
        <source>Drift time constant</source>
        <translation>Driftens tidskonstant</translation>
    </message>
    <message>
        <source>Time in which a known drift fades to that of the current. At 0 the drift is constant. Example, a beacon off Canada: 36,000 s.</source>
        <translation>Den tid, det tager, før en kendt drift nærmer sig strømmen. Ved 0 er driften konstant. Eksempel, en bøje ud for Canada: 36.000 s.</translation>
    </message>
    <message>
        <source>Growth q</source>
        <translation>Vækst q</translation>
    </message>
    <message>
        <source>Growth of the uncertainty per second out of view.</source>
        <translation>Usikkerhedens vækst pr. sekund ude af syne.</translation>
    </message>
    <message>
        <source>Uncertainty σ₀</source>
        <translation>Usikkerhed σ₀</translation>
    </message>
    <message>
        <source>Variance of the position when it was last seen.</source>
        <translation>Positionens varians, da det sidst blev set.</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Sidst set</translation>
    </message>
    <message>
        <source>Time between the last sighting and the start; σ has grown since.</source>
        <translation>Tiden mellem den sidste observation og starten; σ er vokset siden.</translation>
    </message>
    <message>
        <source>Appears at</source>
        <translation>Dukker op</translation>
    </message>
    <message>
        <source>Run time from which the iceberg is known; 0 is the start.</source>
        <translation>Det tidspunkt i flyvningen, hvor isbjerget bliver kendt; 0 er starten.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Halv længde</translation>
    </message>
    <message>
        <source>Half its length. It sets the size on the map and how far outside the area the iceberg is monitored.</source>
        <translation>Halvdelen af dets længde. Den bestemmer størrelsen på kortet, og hvor langt uden for området isbjerget overvåges.</translation>
    </message>
    <message>
        <source>Visited by</source>
        <translation>Besøges af</translation>
    </message>
    <message>
        <source>The only UAV that may visit it.</source>
        <translation>Den eneste drone, der må besøge det.</translation>
    </message>
    <message>
        <source>Speed east</source>
        <translation>Fart mod øst</translation>
    </message>
    <message>
        <source>Speed of a ship to the east; 0 for a platform.</source>
        <translation>Et skibs fart mod øst; 0 for en platform.</translation>
    </message>
    <message>
        <source>Speed north</source>
        <translation>Fart mod nord</translation>
    </message>
    <message>
        <source>Speed of a ship to the north; 0 for a platform.</source>
        <translation>Et skibs fart mod nord; 0 for en platform.</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Rækkevidde</translation>
    </message>
    <message>
        <source>Distance within which icebergs matter to the asset.</source>
        <translation>Den afstand, inden for hvilken isbjerge har betydning for objektet.</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Vægt</translation>
    </message>
    <message>
        <source>Additional weight of an iceberg at the asset.</source>
        <translation>Ekstra vægt for et isbjerg ved objektet.</translation>
    </message>
    <message>
        <source>half the range</source>
        <translation>halv rækkevidde</translation>
    </message>
    <message>
        <source>Inner ring</source>
        <translation>Indre ring</translation>
    </message>
    <message>
        <source>An iceberg predicted to enter it within an hour raises an alarm. At 0 it is half the range.</source>
        <translation>Et isbjerg, der forudsiges at komme ind i den inden for en time, udløser alarm. Ved 0 er ringen den halve rækkevidde.</translation>
    </message>
    <message>
        <source>Stand-off ring</source>
        <translation>Sikkerhedsring</translation>
    </message>
    <message>
        <source>Least distance of UAVs from the asset; for a ship, from its whole track.</source>
        <translation>Mindste afstand fra droner til objektet; for et skib til hele dets spor.</translation>
    </message>
    <message>
        <source>Stand-off ceiling</source>
        <translation>Øvre grænse for ringen</translation>
    </message>
    <message>
        <source>Height above which UAVs may cross the ring.</source>
        <translation>Højde, over hvilken droner må krydse ringen.</translation>
    </message>
    <message>
        <source>Shown on the map.</source>
        <translation>Vises på kortet.</translation>
    </message>
    <message>
        <source>Corner of the no-fly area</source>
        <translation>Hjørne af flyveforbudsområdet</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Nedre højdegrænse</translation>
    </message>
    <message>
        <source>UAVs below this height may pass under the area.</source>
        <translation>Droner under denne højde må passere under området.</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>Øvre højdegrænse</translation>
    </message>
    <message>
        <source>UAVs above this height may pass over the area.</source>
        <translation>Droner over denne højde må passere over området.</translation>
    </message>
    <message>
        <source>Corner of the airspace</source>
        <translation>Hjørne af luftrummet</translation>
    </message>
    <message>
        <source>Start of the airspace</source>
        <translation>Luftrummets starttidspunkt</translation>
    </message>
    <message>
        <source>End of the airspace</source>
        <translation>Luftrummets sluttidspunkt</translation>
    </message>
    <message>
        <source>Station east</source>
        <translation>Station øst</translation>
    </message>
    <message>
        <source>East of the scenario&apos;s origin.</source>
        <translation>Øst for scenariets origo.</translation>
    </message>
    <message>
        <source>Station north</source>
        <translation>Station nord</translation>
    </message>
    <message>
        <source>North of the scenario&apos;s origin.</source>
        <translation>Nord for scenariets origo.</translation>
    </message>
    <message>
        <source>Antenna height</source>
        <translation>Antennehøjde</translation>
    </message>
    <message>
        <source>Height above the sea.</source>
        <translation>Højde over havet.</translation>
    </message>
    <message>
        <source>radio horizon</source>
        <translation>radiohorisont</translation>
    </message>
    <message>
        <source>Link range</source>
        <translation>Forbindelsens rækkevidde</translation>
    </message>
    <message>
        <source>Range of the link; the lowest value means the radio horizon of the antenna and the UAV&apos;s altitude.</source>
        <translation>Forbindelsens rækkevidde; den laveste værdi betyder radiohorisonten for antennen og dronens højde.</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>Distance around all places of the plan, for turns and replanning. Not used with a geofence.</source>
        <translation>Afstand omkring alle planens steder, til drej og nye planer. Bruges ikke med geohegn.</translation>
    </message>
    <message>
        <source>UAV size</source>
        <translation>Dronens størrelse</translation>
    </message>
    <message>
        <source>Largest dimension of a UAV; half of it is added to the ground-risk buffer.</source>
        <translation>Største mål på en drone; halvdelen lægges til jordrisikobufferen.</translation>
    </message>
    <message>
        <source>Satellite position error</source>
        <translation>Fejl i satellitposition</translation>
    </message>
    <message>
        <source>Part of the width of the contingency volume. Source: Digisky 3.3.0, after the guide of the Swiss FOCA: 3 m.</source>
        <translation>Del af beredskabsvolumenets bredde. Kilde: Digisky 3.3.0, efter vejledningen fra schweiziske FOCA: 3 m.</translation>
    </message>
    <message>
        <source>Path-keeping error</source>
        <translation>Fejl i banefølgning</translation>
    </message>
    <message>
        <source>Error of the autopilot, part of the width of the contingency volume. Same source: 3 m.</source>
        <translation>Autopilotens fejl, del af beredskabsvolumenets bredde. Samme kilde: 3 m.</translation>
    </message>
    <message>
        <source>Map error</source>
        <translation>Kortfejl</translation>
    </message>
    <message>
        <source>Part of the width of the contingency volume. Same source: 1 m.</source>
        <translation>Del af beredskabsvolumenets bredde. Samme kilde: 1 m.</translation>
    </message>
    <message>
        <source>Reaction time</source>
        <translation>Reaktionstid</translation>
    </message>
    <message>
        <source>Time at full speed before the crew reacts. Same source: 1 s.</source>
        <translation>Tid ved fuld fart, før besætningen reagerer. Samme kilde: 1 s.</translation>
    </message>
    <message>
        <source>Bank of the turn back</source>
        <translation>Krængning i drejet tilbage</translation>
    </message>
    <message>
        <source>Sets the turn radius v²/(g tan bank). Same source: 30°.</source>
        <translation>Bestemmer drejeradius v²/(g tan krængning). Samme kilde: 30°.</translation>
    </message>
    <message>
        <source>Height error</source>
        <translation>Højdefejl</translation>
    </message>
    <message>
        <source>Part of the height of the contingency volume. Same source: 4 m.</source>
        <translation>Del af beredskabsvolumenets højde. Samme kilde: 4 m.</translation>
    </message>
    <message>
        <source>Climb part</source>
        <translation>Stigeandel</translation>
    </message>
    <message>
        <source>Share of the speed that is climb during the reaction time. Same source: 0.707, a climb of 45°.</source>
        <translation>Den del af farten, der er stigning i reaktionstiden. Samme kilde: 0,707, en stigning på 45°.</translation>
    </message>
    <message>
        <source>Pull-up part</source>
        <translation>Udretningsandel</translation>
    </message>
    <message>
        <source>Height needed to level out, as a share of v²/g. Same source: 0.3.</source>
        <translation>Den højde, som udretning kræver, som andel af v²/g. Samme kilde: 0,3.</translation>
    </message>
    <message>
        <source>Buffer ratio</source>
        <translation>Bufferforhold</translation>
    </message>
    <message>
        <source>Width of the ground-risk buffer divided by the height of the contingency volume. Same source: 1, the 1:1 rule.</source>
        <translation>Jordrisikobufferens bredde divideret med beredskabsvolumenets højde. Samme kilde: 1, reglen 1:1.</translation>
    </message>
    <message>
        <source>Adjacent area, time</source>
        <translation>Tilstødende område, tid</translation>
    </message>
    <message>
        <source>Flight time at full speed. Same source: 180 s.</source>
        <translation>Flyvetid ved fuld fart. Samme kilde: 180 s.</translation>
    </message>
    <message>
        <source>Adjacent area, minimum</source>
        <translation>Tilstødende område, minimum</translation>
    </message>
    <message>
        <source>Minimum width. Same source: 5 km.</source>
        <translation>Mindste bredde. Samme kilde: 5 km.</translation>
    </message>
    <message>
        <source>Adjacent area, maximum</source>
        <translation>Tilstødende område, maksimum</translation>
    </message>
    <message>
        <source>Maximum width. Same source: 35 km.</source>
        <translation>Største bredde. Samme kilde: 35 km.</translation>
    </message>
    <message>
        <source>Crew</source>
        <translation>Besætning</translation>
    </message>
    <message>
        <source>Names printed in the flight brief. If empty, the brief has a blank line.</source>
        <translation>Navne, der trykkes i flyvebriefingen. Hvis feltet er tomt, får briefingen en blank linje.</translation>
    </message>
    <message>
        <source>Call sign</source>
        <translation>Kaldesignal</translation>
    </message>
    <message>
        <source>Printed in the flight brief. If empty, the brief has a blank line.</source>
        <translation>Trykkes i flyvebriefingen. Hvis feltet er tomt, får briefingen en blank linje.</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakter</translation>
    </message>
    <message>
        <source>Ship, air traffic service, rescue: names, numbers, frequencies.</source>
        <translation>Skib, lufttrafiktjeneste, redningstjeneste: navne, numre, frekvenser.</translation>
    </message>
    <message>
        <source>Command link</source>
        <translation>Kommandolink</translation>
    </message>
    <message>
        <source>How the UAVs are commanded, and what they do if the link is lost.</source>
        <translation>Hvordan dronerne styres, og hvad de gør, hvis forbindelsen mistes.</translation>
    </message>
    <message>
        <source>Checklist</source>
        <translation>Tjekliste</translation>
    </message>
    <message>
        <source>One item per line, printed with a box to tick.</source>
        <translation>Ét punkt pr. linje, trykt med et felt til afkrydsning.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>ikke kendt</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Vindstød</translation>
    </message>
    <message>
        <source>Speed of the gusts, compared with the limits of the UAVs.</source>
        <translation>Vindstødenes fart, sammenlignet med dronernes grænser.</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Air temperature at sea level.</source>
        <translation>Luftens temperatur ved havoverfladen.</translation>
    </message>
    <message>
        <source>Dew point</source>
        <translation>Dugpunkt</translation>
    </message>
    <message>
        <source>Dew point at sea level. With the temperature it shows whether ice may form.</source>
        <translation>Dugpunkt ved havoverfladen. Sammen med temperaturen viser det, om der kan dannes is.</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Coordinate of the origin, in any format; a full coordinate or a place name sets both. Everything moves with it.</source>
        <translation>Origos koordinat, i enhver form; en hel koordinat eller et stednavn udfylder begge. Alt flytter med.</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Længde</translation>
    </message>
    <message>
        <source>Observer</source>
        <translation>Observatør</translation>
    </message>
    <message>
        <source>Exact: a sighting gives the true position. Filter: position and velocity are estimated from noisy measurements, and icebergs can get lost.</source>
        <translation>Eksakt: en observation giver den sande position. Filter: position og hastighed estimeres ud fra målinger med støj, og isbjerge kan blive mistet.</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Positionsfejl</translation>
    </message>
    <message>
        <source>Standard deviation of a measured position, along each axis.</source>
        <translation>Standardafvigelse for en målt position, langs hver akse.</translation>
    </message>
    <message>
        <source>Sensor interval</source>
        <translation>Sensorinterval</translation>
    </message>
    <message>
        <source>Time between two samples of the sensor, each of which measures what is in view.</source>
        <translation>Tid mellem to målinger med sensoren, som hver måler det, der er i synsfeltet.</translation>
    </message>
    <message>
        <source>Detection probability</source>
        <translation>Detektionssandsynlighed</translation>
    </message>
    <message>
        <source>Probability that one sample shows an iceberg in view.</source>
        <translation>Sandsynlighed for, at én måling viser et isbjerg i synsfeltet.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Eftersøgning</translation>
    </message>
    <message>
        <source>Search pattern for an iceberg that is not at its estimated position.</source>
        <translation>Søgemønster for et isbjerg, der ikke er ved sin estimerede position.</translation>
    </message>
    <message>
        <source>Trade-off τ</source>
        <translation>Afvejning τ</translation>
    </message>
    <message>
        <source>Formulation</source>
        <translation>Formulering</translation>
    </message>
    <message>
        <source>Integer program that COIN-OR CBC solves when it is the solver.</source>
        <translation>Det heltalsprogram, COIN-OR CBC løser, når den er valgt som løser.</translation>
    </message>
    <message>
        <source>Planning time</source>
        <translation>Planlægningstid</translation>
    </message>
    <message>
        <source>Time to make a plan in flight; until it is ready the UAV continues with the previous plan.</source>
        <translation>Den tid, det tager at lave en plan under flyvning; indtil den er klar, følger dronen den forrige plan.</translation>
    </message>
    <message>
        <source>in view</source>
        <translation>i synsfeltet</translation>
    </message>
    <message>
        <source>Acceptance radius</source>
        <translation>Acceptradius</translation>
    </message>
    <message>
        <source>Distance at which an iceberg counts as reached; at 0 it is reached when it is in view.</source>
        <translation>Den afstand, hvor et isbjerg regnes som nået; ved 0 er det nået, når det er i synsfeltet.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Synsfelt</translation>
    </message>
    <message>
        <source>Shape of the area that the camera covers.</source>
        <translation>Formen på det område, kameraet dækker.</translation>
    </message>
    <message>
        <source>Group nearby icebergs</source>
        <translation>Gruppér nære isbjerge</translation>
    </message>
    <message>
        <source>Icebergs that fit into one field of view are planned as one point, from which all are seen.</source>
        <translation>Isbjerge, der er plads til i ét synsfelt, planlægges som ét punkt, hvorfra alle ses.</translation>
    </message>
    <message>
        <source>Title of the scenario, shown on the map.</source>
        <translation>Scenariets titel, vist på kortet.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Noter</translation>
    </message>
    <message>
        <source>Any text, stored in the file.</source>
        <translation>Valgfri tekst, der gemmes i filen.</translation>
    </message>
    <message>
        <source>Start (UTC)</source>
        <translation>Start (UTC)</translation>
    </message>
    <message>
        <source>Date and time of the start, such as 2026-11-29 12:00 or 29 Nov 2026 12:00; 1200Z keeps the date. Empty: times are relative.</source>
        <translation>Dato og klokkeslæt for start, som 2026-11-29 12:00 eller 29 Nov 2026 12:00; 1200Z beholder datoen. Tomt: tiderne er relative.</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Varighed</translation>
    </message>
    <message>
        <source>Length of the run, at most seven days.</source>
        <translation>Flyvningens længde, højst syv døgn.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startværdi</translation>
    </message>
    <message>
        <source>Seed of the random drift: the same seed repeats the run.</source>
        <translation>Startværdi for den tilfældige drift: den samme startværdi gentager flyvningen.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Tidsskridt</translation>
    </message>
    <message>
        <source>Step of the simulation; a smaller step is more exact and slower.</source>
        <translation>Simuleringens skridt; et mindre skridt er mere nøjagtigt og langsommere.</translation>
    </message>
    <message>
        <source>Random drift</source>
        <translation>Tilfældig drift</translation>
    </message>
    <message>
        <source>Off: icebergs drift exactly as known.</source>
        <translation>Fra: isbjerge driver nøjagtigt som kendt.</translation>
    </message>
    <message>
        <source>Wind east</source>
        <translation>Vind mod øst</translation>
    </message>
    <message>
        <source>Towards the east; must be below the UAV&apos;s airspeed.</source>
        <translation>Mod øst; skal være under dronens flyvefart.</translation>
    </message>
    <message>
        <source>Wind north</source>
        <translation>Vind mod nord</translation>
    </message>
    <message>
        <source>Towards the north; must be below the UAV&apos;s airspeed.</source>
        <translation>Mod nord; skal være under dronens flyvefart.</translation>
    </message>
    <message>
        <source>Current east</source>
        <translation>Strøm mod øst</translation>
    </message>
    <message>
        <source>Carries every iceberg towards the east.</source>
        <translation>Fører alle isbjerge mod øst.</translation>
    </message>
    <message>
        <source>Current north</source>
        <translation>Strøm mod nord</translation>
    </message>
    <message>
        <source>Carries every iceberg towards the north.</source>
        <translation>Fører alle isbjerge mod nord.</translation>
    </message>
    <message>
        <source>Corner of the area</source>
        <translation>Hjørne af området</translation>
    </message>
    <message>
        <source>Geofence</source>
        <translation>Geohegn</translation>
    </message>
    <message>
        <source>UAVs stay inside the area if they start clear of its edge.</source>
        <translation>Droner, der starter fri af kanten, bliver inden for området.</translation>
    </message>
    <message>
        <source>no separation</source>
        <translation>ingen adskillelse</translation>
    </message>
    <message>
        <source>Separation</source>
        <translation>Adskillelse</translation>
    </message>
    <message>
        <source>Least distance between UAVs whose altitudes differ by less than %1.</source>
        <translation>Mindste afstand mellem droner med mindre end %1 højdeforskel.</translation>
    </message>
    <message>
        <source>Autopilot</source>
        <translation>Autopilotprogram</translation>
    </message>
    <message>
        <source>Firmware for which missions are exported.</source>
        <translation>Den firmware, som missioner eksporteres til.</translation>
    </message>
    <message>
        <source>Airframe</source>
        <translation>Flytype</translation>
    </message>
    <message>
        <source>A VTOL and a multirotor fly over icebergs without loiter circles.</source>
        <translation>En VTOL og en multirotor flyver over isbjerge uden kredsninger.</translation>
    </message>
    <message>
        <source>Take-off</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>By mission item, or by hand: then the mission is started in the air.</source>
        <translation>Med et missionselement, eller med hånden: så startes missionen i luften.</translation>
    </message>
    <message>
        <source>Take-off altitude</source>
        <translation>Starthøjde</translation>
    </message>
    <message>
        <source>Height above home at which the first leg begins.</source>
        <translation>Højden over hjemmepunktet, hvor den første etape begynder.</translation>
    </message>
    <message>
        <source>Take-off pitch</source>
        <translation>Pitchvinkel ved start</translation>
    </message>
    <message>
        <source>Least pitch of a fixed wing in the take-off.</source>
        <translation>Mindste pitchvinkel for et fastvinget fly ved start.</translation>
    </message>
    <message>
        <source>End of the mission</source>
        <translation>Missionens slutning</translation>
    </message>
    <message>
        <source>What the last items of an exported mission do, unless it ends over the last iceberg.</source>
        <translation>Hvad de sidste elementer i en eksporteret mission gør, hvis den ikke slutter over det sidste isbjerg.</translation>
    </message>
    <message>
        <source>Approach leg</source>
        <translation>Indflyvningsetape</translation>
    </message>
    <message>
        <source>Distance from the loiter in which the UAV descends to the landing place.</source>
        <translation>Afstand fra den kredsning, hvor dronen går ned, til landingsstedet.</translation>
    </message>
    <message>
        <source>Approach altitude</source>
        <translation>Indflyvningshøjde</translation>
    </message>
    <message>
        <source>Height above home to which the UAV descends before the approach.</source>
        <translation>Højden over hjemmepunktet, som dronen går ned til før indflyvningen.</translation>
    </message>
    <message>
        <source>into the wind</source>
        <translation>mod vinden</translation>
    </message>
    <message>
        <source>Approach course</source>
        <translation>Indflyvningskurs</translation>
    </message>
    <message>
        <source>Course of the approach, clockwise from north; 360 is north.</source>
        <translation>Indflyvningens kurs, med uret fra nord; 360 er nord.</translation>
    </message>
    <message>
        <source>tightest turn</source>
        <translation>snævreste drej</translation>
    </message>
    <message>
        <source>Loiter radius</source>
        <translation>Kredsradius</translation>
    </message>
    <message>
        <source>Radius of loiters in missions; never less than the tightest turn in the wind.</source>
        <translation>Radius af kredsninger i missioner; aldrig mindre end det snævreste drej i vinden.</translation>
    </message>
    <message>
        <source>Hover speed</source>
        <translation>Svævefart</translation>
    </message>
    <message>
        <source>Speed of a VTOL while it flies like a multirotor.</source>
        <translation>En VTOL&apos;s fart, mens den flyver som en multirotor.</translation>
    </message>
    <message>
        <source>Speed in the mission</source>
        <translation>Fart i missionen</translation>
    </message>
    <message>
        <source>Off: the autopilot flies at the speed of its own parameters.</source>
        <translation>Fra: autopiloten flyver med farten i sine egne parametre.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>What triggers the camera over an iceberg; it is off between icebergs.</source>
        <translation>Hvad der udløser kameraet over et isbjerg; det er slukket mellem isbjerge.</translation>
    </message>
    <message>
        <source>Trigger distance</source>
        <translation>Udløserafstand</translation>
    </message>
    <message>
        <source>Distance flown between two pictures.</source>
        <translation>Den afstand, der flyves mellem to billeder.</translation>
    </message>
    <message>
        <source>Trigger interval</source>
        <translation>Udløserinterval</translation>
    </message>
    <message>
        <source>Time between two pictures.</source>
        <translation>Tiden mellem to billeder.</translation>
    </message>
    <message>
        <source>Gimbal down</source>
        <translation>Gimbal ned</translation>
    </message>
    <message>
        <source>An item of the mission points the gimbal straight down.</source>
        <translation>Et element i missionen retter gimbalen lodret ned.</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Tåge</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Sigtbarhed</translation>
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
        <translation>Længde</translation>
    </message>
    <message>
        <source>Length at the waterline. With it, wind and current carry the iceberg, and it may run aground; without it, the current alone.</source>
        <translation>Længden i vandlinjen. Med den fører vind og strøm isbjerget, og det kan gå på grund; uden den kun strømmen.</translation>
    </message>
    <message>
        <source>Source of the ice chart</source>
        <translation>Kilde til iskortet</translation>
    </message>
    <message>
        <source>Date of the ice chart</source>
        <translation>Dato for iskortet</translation>
    </message>
    <message>
        <source>Label of the ice</source>
        <translation>Betegnelse for isen</translation>
    </message>
    <message>
        <source>Ice concentration</source>
        <translation>Iskoncentration</translation>
    </message>
    <message>
        <source>Fast ice</source>
        <translation>Fastis</translation>
    </message>
    <message>
        <source>Visibility limit</source>
        <translation>Sigtgrænse</translation>
    </message>
    <message>
        <source>Shortest visibility in which the UAV may fly; compared with the forecast.</source>
        <translation>Korteste sigt, som UAV&apos;en må flyve i; sammenlignes med prognosen.</translation>
    </message>
    <message>
        <source>Ceiling limit</source>
        <translation>Skybasegrænse</translation>
    </message>
    <message>
        <source>Lowest cloud base, above sea level, in which the UAV may fly; compared with the forecast.</source>
        <translation>Laveste skybase over havet, som UAV&apos;en må flyve i; sammenlignes med prognosen.</translation>
    </message>
    <message>
        <source>Unique in the file; without it, uav-1, uav-2, ... or berg-1, berg-2, ... in the order of the file.</source>
        <translation>Entydig i filen; uden den uav-1, uav-2, ... eller berg-1, berg-2, ... i filens rækkefølge.</translation>
    </message>
    <message>
        <source>Position at the start; of an iceberg the estimate, which is the truth in the simple model.</source>
        <translation>Stedet ved starten; for et isbjerg estimatet, som er sandheden i den enkle model.</translation>
    </message>
    <message>
        <source>Extent of the field of view along and across the heading.</source>
        <translation>Synsfelt langs og på tværs af kursen.</translation>
    </message>
    <message>
        <source>Landing place; without it, where the UAV starts.</source>
        <translation>Landingsplads; uden den hvor dronen starter.</translation>
    </message>
    <message>
        <source>Time between two commands of the autopilot; 0 means every time step. After an order to return home, a slower autopilot commands once a second.</source>
        <translation>Tid mellem to kommandoer fra autopiloten; 0 betyder hvert tidsskridt. Efter en ordre om at flyve hjem giver en langsommere autopilot én kommando i sekundet.</translation>
    </message>
    <message>
        <source>Drift velocity, without the current.</source>
        <translation>Drivets hastighed, uden strømmen.</translation>
    </message>
    <message>
        <source>Standard deviation of the error of the drift velocity, along each axis (Kalman observer).</source>
        <translation>Standardafvigelsen af fejlen i drivets hastighed, langs hver akse (Kalman-observatør).</translation>
    </message>
    <message>
        <source>Changing drift (Kalman observer): standard deviation with which the velocity varies about the current. A fit to a beacon gave 0.15 m/s.</source>
        <translation>Drift, der ændrer sig (Kalman-observatør): standardafvigelsen, som hastigheden varierer om strømmen med. En tilpasning til en bøje gav 0.15 m/s.</translation>
    </message>
    <message>
        <source>Changing drift (Kalman observer): time in which the velocity fades to the current (to 1/e); 0 means constant drift. A fit to a beacon gave 36000 s.</source>
        <translation>Drift, der ændrer sig (Kalman-observatør): tiden, hvori hastigheden nærmer sig strømmen (til 1/e); 0 betyder konstant drift. En tilpasning til en bøje gav 36000 s.</translation>
    </message>
    <message>
        <source>Age of the last sighting at t = 0: adds q x age and (`velocity_sd_mps` x age)^2 to `sigma0_m2`; with changing drift the formula is that of the drift process.</source>
        <translation>Alderen på den seneste observation ved t = 0: lægger q x alder og (`velocity_sd_mps` x alder)^2 til `sigma0_m2`; når driften ændrer sig, gælder driftprocessens formel.</translation>
    </message>
    <message>
        <source>Id of the only UAV that may visit it; empty allows any UAV.</source>
        <translation>Id på den eneste drone, der må besøge det; tom tillader enhver drone.</translation>
    </message>
    <message>
        <source>Speed of a ship; 0 for a platform.</source>
        <translation>Et skibs fart; 0 for en platform.</translation>
    </message>
    <message>
        <source>UAVs that start clear of the asset keep this distance, from a ship to its whole track.</source>
        <translation>Droner, der starter klar af objektet, holder denne afstand, fra et skib til hele dets spor.</translation>
    </message>
    <message>
        <source>Corners of the area.</source>
        <translation>Områdets hjørner.</translation>
    </message>
    <message>
        <source>Name of the airspace.</source>
        <translation>Luftrummets navn.</translation>
    </message>
    <message>
        <source>Class or type of the airspace.</source>
        <translation>Luftrummets klasse eller type.</translation>
    </message>
    <message>
        <source>Lower limit, above the sea.</source>
        <translation>Nedre grænse, over havet.</translation>
    </message>
    <message>
        <source>Upper limit, above the sea.</source>
        <translation>Øvre grænse, over havet.</translation>
    </message>
    <message>
        <source>Time from which the airspace exists; without it, always.</source>
        <translation>Tidspunktet, luftrummet findes fra; uden det altid.</translation>
    </message>
    <message>
        <source>Time until which the airspace exists, not before `from_utc`; without it, always.</source>
        <translation>Tidspunktet, luftrummet findes til, ikke før `from_utc`; uden det altid.</translation>
    </message>
    <message>
        <source>Position of the antenna.</source>
        <translation>Antennens sted.</translation>
    </message>
    <message>
        <source>Latitude of the local plane&apos;s origin.</source>
        <translation>Breddegraden for det lokale plans origo.</translation>
    </message>
    <message>
        <source>Longitude of the local plane&apos;s origin.</source>
        <translation>Længdegraden for det lokale plans origo.</translation>
    </message>
    <message>
        <source>With `simple`, the estimate of an iceberg in view is the truth; with `kalman`, a filter uses noisy measurements.</source>
        <translation>Med `simple` er estimatet for et isbjerg i syne sandheden; med `kalman` bruger et filter målinger med støj.</translation>
    </message>
    <message>
        <source>Policy that chooses the orders.</source>
        <translation>Reglen, der vælger rækkefølgerne.</translation>
    </message>
    <message>
        <source>0 visits the most uncertain iceberg first; a large value gives the shortest path.</source>
        <translation>0 besøger det mest usikre isbjerg først; en stor værdi giver den korteste vej.</translation>
    </message>
    <message>
        <source>Whether the path ends over the last iceberg or returns to its start.</source>
        <translation>Om vejen slutter over det sidste isbjerg eller går tilbage til starten.</translation>
    </message>
    <message>
        <source>Solver of the orders.</source>
        <translation>Løseren til rækkefølgerne.</translation>
    </message>
    <message>
        <source>An iceberg is reached within this distance. Without it, an iceberg is reached when it is in view; with measurements, when its estimate is in view after a sighting.</source>
        <translation>Et isbjerg er nået inden for denne afstand. Uden den er et isbjerg nået, når det er i syne; med målinger når dets estimat er i syne efter en observation.</translation>
    </message>
    <message>
        <source>Shape of the field of view. The diameter of a disk is `fov_m[0]`; the second number has no effect.</source>
        <translation>Synsfeltets form. En disks diameter er `fov_m[0]`; det andet tal er uden virkning.</translation>
    </message>
    <message>
        <source>Start time, ISO 8601 with Z; without it, times are relative.</source>
        <translation>Starttid, ISO 8601 med Z; uden den er tider relative.</translation>
    </message>
    <message>
        <source>If false, nothing is random: icebergs drift at their given velocities, and measurements detect every iceberg in view.</source>
        <translation>Hvis false, er intet tilfældigt: isbjerge driver med de angivne hastigheder, og målinger opdager hvert isbjerg i syne.</translation>
    </message>
    <message>
        <source>Velocity over ground; the wind must be slower than the airspeed.</source>
        <translation>Hastighed over grunden; vinden skal være langsommere end flyvehastigheden.</translation>
    </message>
    <message>
        <source>Velocity over ground; the current carries every iceberg.</source>
        <translation>Hastighed over grunden; strømmen fører hvert isbjerg med sig.</translation>
    </message>
    <message>
        <source>Corners of the monitored area; an iceberg that is farther outside than its radius is no longer monitored.</source>
        <translation>Det overvågede områdes hjørner; et isbjerg, der er længere udenfor end sin radius, overvåges ikke længere.</translation>
    </message>
    <message>
        <source>UAVs that start clear of the edge of `area_m` stay inside it; `validate` warns if a start leaves no safe turn or path home, but the flight is allowed.</source>
        <translation>Droner, der starter klar af kanten af `area_m`, bliver inden for den; `validate` advarer, hvis en start ikke giver noget sikkert sving eller nogen sikker vej hjem, men flyvningen er tilladt.</translation>
    </message>
    <message>
        <source>Least distance between UAVs whose altitudes differ by less than %1, after they have reached it (`validate` gives a hint if they start nearer); 0 turns separation off.</source>
        <translation>Mindste afstand mellem droner med mindre end %1 højdeforskel, efter at de har nået den (`validate` giver et tip, hvis de starter nærmere); 0 slår afstanden fra.</translation>
    </message>
    <message>
        <source>Areas that UAVs stay out of if they start clear of them; with geofence and stand-off ring at most 200 corners at the altitude of a UAV.</source>
        <translation>Områder, som droner holder sig uden for, hvis de starter klar af dem; med geohegn og sikkerhedsring højst 200 hjørner i en drones højde.</translation>
    </message>
    <message>
        <source>Airspace, for information: a check reports that the operation may enter it, but no UAV is kept out.</source>
        <translation>Luftrum, til oplysning: en kontrol melder, at operationen kan komme ind i det, men ingen drone holdes ude.</translation>
    </message>
    <message>
        <source>Content of a permit application: constants of the operation volume, and texts for the flight brief.</source>
        <translation>Indholdet i en ansøgning om tilladelse: operationsvolumenets konstanter og tekster til flyvebriefingen.</translation>
    </message>
    <message>
        <source>Protected asset.</source>
        <translation>Beskyttet objekt.</translation>
    </message>
    <message>
        <source>Missing values are not checked.</source>
        <translation>Manglende værdier kontrolleres ikke.</translation>
    </message>
    <message>
        <source>`{&quot;time_s&quot;: [...], &quot;position_m&quot;: [[x, y], ...]}`: true positions, instead of random drift.</source>
        <translation>`{&quot;time_s&quot;: [...], &quot;position_m&quot;: [[x, y], ...]}`: sande positioner i stedet for tilfældig drift.</translation>
    </message>
    <message>
        <source>required</source>
        <translation>påkrævet</translation>
    </message>
    <message>
        <source>`%1` in older files.</source>
        <translation>`%1` i ældre filer.</translation>
    </message>
    <message>
        <source>Longest flight; the UAV is home before it ends. Without it, the UAV lands only when ordered to return.</source>
        <translation>Længste flyvning; dronen er hjemme, før den slutter. Uden den lander dronen kun efter ordre om at flyve hjem.</translation>
    </message>
    <message>
        <source>Range of the link; without it, the radio horizon of the antenna and the UAV&apos;s altitude.</source>
        <translation>Forbindelsens rækkevidde; uden den radiohorisonten for antennen og dronens højde.</translation>
    </message>
    <message>
        <source>Length at the waterline: wind and current then carry the iceberg by the balance of their drags (below 15 m: the current and 2 % of the wind, turned 20 degrees), and it stands still where a `forecast` gives a depth below its draft of 1.78 L^0.71. Without it the current alone carries the iceberg.</source>
        <translation>Længden i vandlinjen: vind og strøm fører da isbjerget efter ligevægten mellem modstandene (under 15 m: strømmen og 2 % af vinden, drejet 20 grader), og det står stille, hvor et `forecast` giver en dybde under dybgangen 1,78 L^0,71. Uden længde fører kun strømmen isbjerget.</translation>
    </message>
    <message>
        <source>File or service that the chart comes from.</source>
        <translation>Filen eller tjenesten, som iskortet kommer fra.</translation>
    </message>
    <message>
        <source>Date of the chart; without it, unknown.</source>
        <translation>Datoen for kortet; uden den er den ukendt.</translation>
    </message>
    <message>
        <source>Words or codes of the chart for the area; may be empty.</source>
        <translation>Iskortets ord eller koder for området; kan være tomt.</translation>
    </message>
    <message>
        <source>Part of the area that ice covers, in tenths; without it, unknown.</source>
        <translation>Den del af området, som is dækker, i tiendedele; uden den er den ukendt.</translation>
    </message>
    <message>
        <source>Whether the ice is fast to a shore and does not drift.</source>
        <translation>Om isen er landfast og ikke driver.</translation>
    </message>
    <message>
        <source>Velocity of the wind at 10 m, towards true east and north.</source>
        <translation>Vindens hastighed i 10 m, mod sand øst og nord.</translation>
    </message>
    <message>
        <source>Speed of gusts.</source>
        <translation>Vindstødenes fart.</translation>
    </message>
    <message>
        <source>Temperature of the air at 2 m.</source>
        <translation>Luftens temperatur i 2 m.</translation>
    </message>
    <message>
        <source>Dew point of the air at 2 m.</source>
        <translation>Luftens dugpunkt i 2 m.</translation>
    </message>
    <message>
        <source>Part of the area with fog.</source>
        <translation>Den del af området, hvor der er tåge.</translation>
    </message>
    <message>
        <source>Visibility.</source>
        <translation>Sigten.</translation>
    </message>
    <message>
        <source>Height of the cloud base above the sea.</source>
        <translation>Skybasens højde over havet.</translation>
    </message>
    <message>
        <source>Velocity of the current, towards true east and north.</source>
        <translation>Strømmens hastighed, mod sand øst og nord.</translation>
    </message>
    <message>
        <source>Latitude of a place of the grid.</source>
        <translation>Breddegraden for et sted i gitteret.</translation>
    </message>
    <message>
        <source>Longitude of a place of the grid.</source>
        <translation>Længdegraden for et sted i gitteret.</translation>
    </message>
    <message>
        <source>Depth of the sea at the place.</source>
        <translation>Havdybden på stedet.</translation>
    </message>
    <message>
        <source>Ice chart for the map, without effect on the flight.</source>
        <translation>Iskort til kortet, uden virkning på flyvningen.</translation>
    </message>
    <message>
        <source>Areas of the chart, each with `outlines_m` (needed): outline and holes, each a list of corners.</source>
        <translation>Iskortets områder, hvert med `outlines_m` (skal findes): omrids og huller, hvert en liste over hjørner.</translation>
    </message>
    <message>
        <source>Forecast with `source`, `issued` (UTC), `columns` (1) and `places`; needs `start_utc`.</source>
        <translation>Prognose med `source`, `issued` (UTC), `columns` (1) og `places`; kræver `start_utc`.</translation>
    </message>
    <message>
        <source>Grid of rows from south to north, each from west to east, with `columns` places.</source>
        <translation>Gitter af rækker fra syd til nord, hver fra vest til øst, med `columns` steder.</translation>
    </message>
    <message>
        <source>Values at a `time` (UTC; times rise); any may be missing.</source>
        <translation>Værdier for en `time` (UTC; tiderne stiger); alle kan mangle.</translation>
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
        <translation>Værdier</translation>
    </message>
</context>
<context>
    <name>berg::FindBox</name>
    <message>
        <source>Favourite: listed when the box is opened</source>
        <translation>Favorit: vises, når feltet åbnes</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favorit</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Fundet</translation>
    </message>
    <message>
        <source>Move the scenario here…</source>
        <translation>Flyt scenariet hertil…</translation>
    </message>
    <message>
        <source>New scenario here</source>
        <translation>Nyt scenarie her</translation>
    </message>
    <message>
        <source>Where is the new scenario? A place or coordinate</source>
        <translation>Hvor er det nye scenarie? Et sted eller en koordinat</translation>
    </message>
    <message>
        <source>Iceberg, UAV, place, coordinate or command</source>
        <translation>Isbjerg, drone, sted, koordinat eller kommando</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Intet fundet</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isbjerg</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
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
        <translation>Hav eller bugt</translation>
    </message>
    <message>
        <source>Island or coast</source>
        <translation>Ø eller kyst</translation>
    </message>
    <message>
        <source>Cape</source>
        <translation>Kap</translation>
    </message>
    <message>
        <source>Town or station</source>
        <translation>By eller station</translation>
    </message>
    <message>
        <source>Oil or gas field</source>
        <translation>Olie- eller gasfelt</translation>
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
        <translation>Flyvning gennemført</translation>
    </message>
    <message>
        <source>Result of the run</source>
        <translation>Flyvningens resultat</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Luk</translation>
    </message>
    <message>
        <source>Closes this card until the next run ends.</source>
        <translation>Lukker denne boks, indtil den næste flyvning slutter.</translation>
    </message>
    <message>
        <source>Zeta ζ</source>
        <translation>Zeta ζ</translation>
    </message>
    <message>
        <source>vs prediction</source>
        <translation>Mod forudsigelsen</translation>
    </message>
    <message>
        <source>ζ compared with the prediction for the policy before take-off.</source>
        <translation>ζ sammenlignet med forudsigelsen for strategien før start.</translation>
    </message>
    <message>
        <source>Lower bound</source>
        <translation>Nedre grænse</translation>
    </message>
    <message>
        <source>no useful bound</source>
        <translation>ingen brugbar grænse</translation>
    </message>
    <message>
        <source>Lower bound on ζ for these conditions, whatever the policy.</source>
        <translation>Nedre grænse for ζ under disse forhold, uanset strategi.</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besøg</translation>
    </message>
    <message>
        <source>Targets reached.</source>
        <translation>Nåede mål.</translation>
    </message>
    <message>
        <source>Longest unseen</source>
        <translation>Længst uset</translation>
    </message>
    <message>
        <source>The iceberg that was out of view longest.</source>
        <translation>Det isbjerg, der var ude af syne længst.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Sammenlign</translation>
    </message>
    <message>
        <source>Compares the run with others.</source>
        <translation>Sammenligner flyvningen med andre.</translation>
    </message>
    <message>
        <source>Save run</source>
        <translation>Gem flyvning</translation>
    </message>
    <message>
        <source>Saves the run to a file.</source>
        <translation>Gemmer flyvningen i en fil.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Exports the log of the run: planned and flown, sightings, deviations.</source>
        <translation>Eksporterer flyvningens log: planlagt og fløjet, observationer, afvigelser.</translation>
    </message>
    <message>
        <source>Predicted range</source>
        <translation>Forudsagt interval</translation>
    </message>
    <message>
        <source>Predicted range of ζ for 90 % of flights.</source>
        <translation>Forudsagt område for ζ i 90 % af flyvningerne.</translation>
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
        <translation>inden for %1 til %2</translation>
    </message>
    <message>
        <source>changed in flight</source>
        <translation>ændret under flyvning</translation>
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
        <translation>Planlægger</translation>
    </message>
    <message>
        <source>Ready. Press Space to fly</source>
        <translation>Klar. Tryk på mellemrum for at flyve</translation>
    </message>
    <message>
        <source>Flying</source>
        <translation>Flyver</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Sat på pause</translation>
    </message>
    <message>
        <source>Run complete</source>
        <translation>Flyvning gennemført</translation>
    </message>
    <message>
        <source>Cannot be planned: %1</source>
        <translation>Kan ikke planlægges: %1</translation>
    </message>
    <message>
        <source>Press I and click on the map to place an iceberg, drag to set its drift, or import sightings.</source>
        <translation>Tryk på I, og klik på kortet for at placere et isbjerg, træk for at sætte driften, eller importér observationer.</translation>
    </message>
    <message>
        <source>The plan is still being made.</source>
        <translation>Planen er stadig under udarbejdelse.</translation>
    </message>
    <message>
        <source>Flight to %1 discarded</source>
        <translation>Flyvning til %1 kasseret</translation>
    </message>
</context>
<context>
    <name>berg::ForecastDialog</name>
    <message>
        <source>Forecast</source>
        <translation>Prognose</translation>
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
        <translation>Vindstød</translation>
    </message>
    <message>
        <source>Air, °C</source>
        <translation>Luft, °C</translation>
    </message>
    <message>
        <source>Dew point, °C</source>
        <translation>Dugpunkt, °C</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Sigtbarhed</translation>
    </message>
    <message>
        <source>Cloud base</source>
        <translation>Skyhøjde</translation>
    </message>
    <message>
        <source>Current to</source>
        <translation>Strøm mod</translation>
    </message>
    <message>
        <source>Co&amp;mbine with the present forecast</source>
        <translation>Ko&amp;mbinér med den nuværende prognose</translation>
    </message>
    <message>
        <source>&amp;Open file...</source>
        <translation>&amp;Åbn fil...</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Fjern</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>&amp;Indstil</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Kilde: %1</translation>
    </message>
    <message>
        <source>Time of issue unknown</source>
        <translation>Udgivelsestid ukendt</translation>
    </message>
    <message>
        <source>Issued %1</source>
        <translation>Udgivet %1</translation>
    </message>
    <message>
        <source>Issued %1, %2 h before the start: get a newer forecast</source>
        <translation>Udgivet %1, %2 t før start: hent en nyere prognose</translation>
    </message>
    <message>
        <source>Issued %1, %2 h before the start</source>
        <translation>Udgivet %1, %2 t før start</translation>
    </message>
    <message numerus="yes">
        <source>%n places, the table is for the middle one</source>
        <translation>
            <numerusform>%n sted, som tabellen gælder</numerusform>
            <numerusform>%n steder, tabellen gælder det midterste</numerusform>
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
        <translation>Udtyndet med en faktor %1 i hver retning</translation>
    </message>
    <message>
        <source>The scenario has no forecast: wind and current are constant.</source>
        <translation>Scenariet har ingen prognose: vind og strøm er konstante.</translation>
    </message>
    <message>
        <source>No values of one quantity between %1 and %2</source>
        <translation>Ingen værdier for én størrelse mellem %1 og %2</translation>
    </message>
</context>
<context>
    <name>berg::GenerateDialog</name>
    <message>
        <source>Generate icebergs</source>
        <translation>Generér isbjerge</translation>
    </message>
    <message>
        <source>&amp;Number</source>
        <translation>&amp;Antal</translation>
    </message>
    <message>
        <source>The scenario&apos;s area</source>
        <translation>Scenariets område</translation>
    </message>
    <message>
        <source>Visible part of the map</source>
        <translation>Synlig del af kortet</translation>
    </message>
    <message>
        <source>Rectangle in the middle of the map</source>
        <translation>Rektangel midt på kortet</translation>
    </message>
    <message>
        <source>&amp;Where</source>
        <translation>&amp;Hvor</translation>
    </message>
    <message>
        <source>Width of the rectangle</source>
        <translation>Rektanglets bredde</translation>
    </message>
    <message>
        <source>Height of the rectangle</source>
        <translation>Rektanglets højde</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Størrelse</translation>
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
        <translation>I enhver retning</translation>
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
        <translation>&amp;Usikkerhed σ</translation>
    </message>
    <message>
        <source>&amp;Growth q</source>
        <translation>&amp;Vækst q</translation>
    </message>
    <message>
        <source>&amp;Minimum spacing</source>
        <translation>&amp;Mindste afstand</translation>
    </message>
    <message>
        <source>The same seed generates the same field again.</source>
        <translation>Den samme startværdi giver det samme felt igen.</translation>
    </message>
    <message>
        <source>&amp;Another</source>
        <translation>&amp;En anden</translation>
    </message>
    <message>
        <source>Generates another random field.</source>
        <translation>Genererer et andet tilfældigt felt.</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>S&amp;tartværdi</translation>
    </message>
    <message>
        <source>R&amp;eplace existing icebergs</source>
        <translation>Erstat de nuværende &amp;isbjerge</translation>
    </message>
    <message>
        <source>Generate</source>
        <translation>Generér</translation>
    </message>
    <message numerus="yes">
        <source>The scenario will have %n icebergs.</source>
        <translation>
            <numerusform>Scenariet får %n isbjerg.</numerusform>
            <numerusform>Scenariet får %n isbjerge.</numerusform>
        </translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>Unknown, changing within 10 h</source>
        <translation>Ukendt, ændrer sig inden for 10 t</translation>
    </message>
    <message>
        <source>As fitted to a beacon: 0.15 m/s along each axis, in any direction. Icebergs are then measured in flight.</source>
        <translation>Som tilpasset en bøje: 0,15 m/s langs hver akse, i enhver retning. Isbjergene måles derefter under flyvning.</translation>
    </message>
</context>
<context>
    <name>berg::IceRow</name>
    <message>
        <source>Report sighting</source>
        <translation>Meld observation</translation>
    </message>
    <message>
        <source>Ice tracked by radar or marked by AIS</source>
        <translation>Is fulgt af radar eller markeret med AIS</translation>
    </message>
    <message>
        <source>In flight: the nearest iceberg that it may be counts as seen by others; without one, a new iceberg appears.</source>
        <translation>Under flyvning: det nærmeste isbjerg, som det kan være, regnes som set af andre; findes det ikke, dukker et nyt isbjerg op.</translation>
    </message>
</context>
<context>
    <name>berg::IcebergTable</name>
    <message>
        <source>Find by name or id</source>
        <translation>Find efter navn eller id</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Isbjerge</translation>
    </message>
    <message>
        <source>A row for each iceberg. Before take-off Return edits a cell, Ctrl+Return sets it in all rows selected, Ctrl+C and Ctrl+V exchange rows with a spreadsheet. In flight Return shows the iceberg on the map.</source>
        <translation>En række for hvert isbjerg. Før start redigerer Enter en celle, Ctrl+Enter sætter den i alle valgte rækker, Ctrl+C og Ctrl+V udveksler rækker med et regneark. Under flyvning viser Enter isbjerget på kortet.</translation>
    </message>
    <message>
        <source>No iceberg has this in its name or id.</source>
        <translation>Intet isbjerg har dette i sit navn eller id.</translation>
    </message>
    <message>
        <source>There are no icebergs in this flight.</source>
        <translation>Der er ingen isbjerge i denne flyvning.</translation>
    </message>
    <message>
        <source>No icebergs yet: press I and click on the map, or copy rows of a spreadsheet (name, east, north, speed, direction, σ₀ ...) and paste them here with Ctrl+V.</source>
        <translation>Ingen isbjerge endnu: tryk på I, og klik på kortet, eller kopiér rækker fra et regneark (navn, øst, nord, fart, retning, σ₀ ...), og sæt dem ind her med Ctrl+V.</translation>
    </message>
    <message>
        <source>In flight the icebergs cannot be edited. Stop the flight to paste.</source>
        <translation>Isbjergene kan ikke redigeres under flyvning. Stop flyvningen for at sætte ind.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiér</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Sæt ind</translation>
    </message>
    <message>
        <source>Copy &quot;%1&quot;</source>
        <translation>Kopiér »%1«</translation>
    </message>
    <message>
        <source>Show on the map</source>
        <translation>Vis på kortet</translation>
    </message>
</context>
<context>
    <name>berg::IcebergTableModel</name>
    <message>
        <source>Paste icebergs</source>
        <translation>Sæt isbjerge ind</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; is computed from others. Nothing was pasted.</source>
        <translation>Kolonnen »%1« beregnes ud fra andre. Intet blev sat ind.</translation>
    </message>
</context>
<context>
    <name>berg::ImportColumnsView</name>
    <message>
        <source>This format has no columns to choose.</source>
        <translation>Dette format har ingen kolonner at vælge.</translation>
    </message>
    <message>
        <source>First rows of the file</source>
        <translation>Filens første rækker</translation>
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
        <translation>Den linje i filen, der navngiver kolonnerne, hvis en titel står over den.</translation>
    </message>
    <message>
        <source>&amp;Header line</source>
        <translation>Overskrifts&amp;linje</translation>
    </message>
    <message>
        <source>Columns as for the last file with this header.</source>
        <translation>Kolonner som for den forrige fil med denne overskrift.</translation>
    </message>
    <message>
        <source>&amp;Forget columns</source>
        <translation>&amp;Glem kolonner</translation>
    </message>
    <message>
        <source>Headers whose columns were chosen by hand in an earlier import.</source>
        <translation>Overskrifter, hvis kolonner blev valgt i hånden ved en tidligere import.</translation>
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
        <translation>Ingen isbjerge</translation>
    </message>
    <message>
        <source>No sighting can be imported.</source>
        <translation>Ingen observation kan importeres.</translation>
    </message>
    <message>
        <source>Import sightings from %1</source>
        <translation>Importér observationer fra %1</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>Map of what comes out</source>
        <translation>Kort over resultatet</translation>
    </message>
    <message>
        <source>+ new   * updated</source>
        <translation>+ nyt   * opdateret</translation>
    </message>
    <message>
        <source>Icebergs of the file</source>
        <translation>Filens isbjerge</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Isbjerge</translation>
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
        <translation>Isbjerge (%1)</translation>
    </message>
    <message>
        <source>Reading %1, %2 ...</source>
        <translation>Læser %1, %2 ...</translation>
    </message>
    <message>
        <source>Working ...</source>
        <translation>Arbejder ...</translation>
    </message>
    <message>
        <source>Im&amp;port</source>
        <translation>I&amp;mportér</translation>
    </message>
    <message>
        <source>Icebergs (first %1 of %2)</source>
        <translation>Isbjerge (de første %1 af %2)</translation>
    </message>
    <message>
        <source>Import into a &amp;new scenario</source>
        <translation>Importér i et &amp;nyt scenarie</translation>
    </message>
    <message>
        <source>+ appears   * reported seen</source>
        <translation>+ dukker op   * meldt set</translation>
    </message>
    <message>
        <source>Re&amp;port</source>
        <translation>&amp;Meld</translation>
    </message>
    <message>
        <source>Report all t&amp;he same</source>
        <translation>Meld al&amp;ligevel</translation>
    </message>
    <message>
        <source>Import all t&amp;he same</source>
        <translation>Importér al&amp;ligevel</translation>
    </message>
    <message>
        <source>Choose below which rows belong to the same iceberg.</source>
        <translation>Vælg nedenfor, hvilke rækker der hører til samme isbjerg.</translation>
    </message>
    <message>
        <source>Faster than 1.5 m/s or on land: %1. Check columns, units and ids.</source>
        <translation>Hurtigere end 1,5 m/s eller på land: %1. Kontrollér kolonner, enheder og id&apos;er.</translation>
    </message>
    <message>
        <source>Velocities are uncertain, so the scenario will use the Kalman filter.</source>
        <translation>Hastighederne er usikre, så scenariet vil bruge Kalmanfilteret.</translation>
    </message>
</context>
<context>
    <name>berg::ImportIdentityView</name>
    <message>
        <source>Rows with the same “%1”</source>
        <translation>Rækker med samme »%1«</translation>
    </message>
    <message>
        <source>All rows are one iceberg</source>
        <translation>Alle rækker er ét isbjerg</translation>
    </message>
    <message>
        <source>Each row is a separate iceberg</source>
        <translation>Hver række er sit eget isbjerg</translation>
    </message>
    <message>
        <source>up to %1 m/s between sightings</source>
        <translation>op til %1 m/s mellem observationer</translation>
    </message>
    <message>
        <source>The file does not say which rows belong to the same iceberg. Choose:</source>
        <translation>Filen siger ikke, hvilke rækker der hører til samme isbjerg. Vælg:</translation>
    </message>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n isbjerg</numerusform>
            <numerusform>%n isbjerge</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::ImportOptionsView</name>
    <message>
        <source>S&amp;tart at</source>
        <translation>&amp;Starttidspunkt</translation>
    </message>
    <message>
        <source>Not &amp;before</source>
        <translation>Ikke f&amp;ør</translation>
    </message>
    <message>
        <source>Earlier sightings are left out.</source>
        <translation>Tidligere observationer udelades.</translation>
    </message>
    <message>
        <source>Not &amp;after</source>
        <translation>Ikke &amp;efter</translation>
    </message>
    <message>
        <source>Later sightings are left out.</source>
        <translation>Senere observationer udelades.</translation>
    </message>
    <message>
        <source>&amp;Growth q</source>
        <translation>&amp;Vækst q</translation>
    </message>
    <message>
        <source>Growth of the uncertainty if there are too few sightings to estimate it.</source>
        <translation>Usikkerhedens vækst, hvis der er for få observationer til at anslå den.</translation>
    </message>
    <message>
        <source>This scenario</source>
        <translation>Dette scenarie</translation>
    </message>
    <message>
        <source>A new scenario</source>
        <translation>Et nyt scenarie</translation>
    </message>
    <message>
        <source>Icebergs already in this scenario are updated by their ids.</source>
        <translation>Isbjerge, der allerede er i dette scenarie, opdateres efter deres id&apos;er.</translation>
    </message>
    <message>
        <source>&amp;Into</source>
        <translation>&amp;Til</translation>
    </message>
    <message>
        <source>Insi&amp;de</source>
        <translation>I&amp;nden for</translation>
    </message>
    <message>
        <source>Sightings outside these latitudes and longitudes are left out.</source>
        <translation>Observationer uden for disse bredder og længder udelades.</translation>
    </message>
    <message>
        <source>Visible part of the &amp;map</source>
        <translation>Synlig del af &amp;kortet</translation>
    </message>
    <message>
        <source>South</source>
        <translation>Syd</translation>
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
        <translation>Med &amp;registrerede spor</translation>
    </message>
    <message>
        <source>Sightings after the start become the true motion of an iceberg. Requires a start time.</source>
        <translation>Observationer efter starten bliver et isbjergs sande bevægelse. Kræver et starttidspunkt.</translation>
    </message>
    <message>
        <source>Position &amp;error</source>
        <translation>&amp;Positionsfejl</translation>
    </message>
    <message>
        <source>Drift &amp;variation</source>
        <translation>Variation i &amp;drift</translation>
    </message>
    <message>
        <source>Standard deviation of an unknown drift along each axis. With 0 the drift counts as known and constant.</source>
        <translation>Standardafvigelse for en ukendt drift langs hver akse. Med 0 regnes driften for kendt og konstant.</translation>
    </message>
    <message>
        <source>Drift &amp;changes in</source>
        <translation>Driften ændrer si&amp;g på</translation>
    </message>
    <message>
        <source>Time after which a known drift is no longer valid. 0 means never.</source>
        <translation>Tid, hvorefter en kendt drift ikke længere gælder. 0 betyder aldrig.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisk</translation>
    </message>
    <message>
        <source>Month first: 12/31/2021</source>
        <translation>Måned først: 12/31/2021</translation>
    </message>
    <message>
        <source>Day first: 31/12/2021</source>
        <translation>Dag først: 31/12/2021</translation>
    </message>
    <message>
        <source>How to read dates such as 05/02/2021.</source>
        <translation>Hvordan datoer som 05/02/2021 skal læses.</translation>
    </message>
    <message>
        <source>Dat&amp;es</source>
        <translation>Dat&amp;oer</translation>
    </message>
    <message>
        <source>UTC time that becomes the start of the scenario. Otherwise its start stays, or moves to the last sighting if that is later.</source>
        <translation>UTC-tid, der bliver scenariets start. Ellers bliver starten stående, eller den flyttes til den seneste observation, hvis den er senere.</translation>
    </message>
    <message>
        <source>Standard deviation of a position along each axis if the file states none and no column names the source.</source>
        <translation>Standardafvigelse for en position langs hver akse, hvis filen ikke angiver nogen og ingen kolonne nævner kilden.</translation>
    </message>
    <message>
        <source>As stated in the file</source>
        <translation>Som filen siger</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Som skrevet</translation>
    </message>
    <message>
        <source>Sensor that found the positions. Rows whose column “source”, “method” or “sensor” names another source use its error.</source>
        <translation>Den sensor, der fandt positionerne. Rækker, hvor kolonnen »source«, »method« eller »sensor« nævner en anden kilde, bruger dens fejl.</translation>
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
        <translation>Afviste rækker</translation>
    </message>
    <message>
        <source>Rejected rows (%1)</source>
        <translation>Afviste rækker (%1)</translation>
    </message>
    <message>
        <source>Rejected rows (first %1 of %2)</source>
        <translation>Afviste rækker (de første %1 af %2)</translation>
    </message>
    <message>
        <source>Changed rows</source>
        <translation>Ændrede rækker</translation>
    </message>
    <message>
        <source>Changed rows (%1)</source>
        <translation>Ændrede rækker (%1)</translation>
    </message>
    <message>
        <source>Changed rows (first %1 of %2)</source>
        <translation>Ændrede rækker (de første %1 af %2)</translation>
    </message>
    <message>
        <source>Outside area or time</source>
        <translation>Uden for område eller tid</translation>
    </message>
    <message>
        <source>Outside area or time (%1)</source>
        <translation>Uden for område eller tid (%1)</translation>
    </message>
    <message>
        <source>Outside area or time (first %1 of %2)</source>
        <translation>Uden for område eller tid (de første %1 af %2)</translation>
    </message>
</context>
<context>
    <name>berg::InspectorForm</name>
    <message>
        <source>mixed</source>
        <translation>forskellige</translation>
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
        <translation>Scenarie</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isbjerg</translation>
    </message>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n isbjerg</numerusform>
            <numerusform>%n isbjerge</numerusform>
        </translation>
    </message>
    <message>
        <source>Only the selected icebergs are edited here.</source>
        <translation>Kun de valgte isbjerge redigeres her.</translation>
    </message>
    <message>
        <source>Edits apply to all of them.</source>
        <translation>Ændringer gælder for dem alle.</translation>
    </message>
    <message>
        <source>UAV %1</source>
        <translation>Drone %1</translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>%n drone</numerusform>
            <numerusform>%n droner</numerusform>
        </translation>
    </message>
    <message>
        <source>Change id</source>
        <translation>Ændr id</translation>
    </message>
    <message>
        <source>Select an object on the map to edit it.</source>
        <translation>Vælg et objekt på kortet for at redigere det.</translation>
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
        <translation>Træk i dets hjørner på kortet for at ændre det.</translation>
    </message>
    <message>
        <source>Identifies the iceberg in files and lists; must be unique.</source>
        <translation>Identificerer isbjerget i filer og lister; skal være unikt.</translation>
    </message>
    <message>
        <source>Identifies the UAV in files and lists; must be unique.</source>
        <translation>Identificerer dronen i filer og lister; skal være unikt.</translation>
    </message>
    <message>
        <source>No-fly area</source>
        <translation>Flyveforbudsområde</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
    </message>
</context>
<context>
    <name>berg::LayersPanel</name>
    <message>
        <source>Names</source>
        <translation>Navne</translation>
    </message>
    <message>
        <source>Drift arrows</source>
        <translation>Driftpile</translation>
    </message>
    <message>
        <source>Uncertainty rings</source>
        <translation>Usikkerhedsringe</translation>
    </message>
    <message>
        <source>Graticule</source>
        <translation>Gradnet</translation>
    </message>
    <message>
        <source>Former plan</source>
        <translation>Forrige plan</translation>
    </message>
    <message>
        <source>Swept area</source>
        <translation>Afsøgt område</translation>
    </message>
    <message>
        <source>%1: opacity in per cent</source>
        <translation>%1: dækkraft i procent</translation>
    </message>
    <message>
        <source>Opacity; at the left end the layer is hidden</source>
        <translation>Dækkraft; helt til venstre er laget skjult</translation>
    </message>
    <message>
        <source>Time covered by drift arrows; arrows too long for the map are shortened and dashed</source>
        <translation>Den tid, driftpilene dækker; pile, der er for lange til kortet, er afkortet og stiplet</translation>
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
        <translation>Luftrum og operationsvolumen</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Baggrund</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Removes the background</source>
        <translation>Fjerner baggrunden</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Vælg en fil…</translation>
    </message>
    <message>
        <source>Your own map below all layers, such as an ice chart: GeoJSON, KML, KMZ or CZML</source>
        <translation>Dit eget kort under alle lag, f.eks. et iskort: GeoJSON, KML, KMZ eller CZML</translation>
    </message>
    <message>
        <source>Background file: %1</source>
        <translation>Baggrundsfil: %1</translation>
    </message>
    <message>
        <source>Compared run</source>
        <translation>Sammenlignet flyvning</translation>
    </message>
    <message>
        <source>Place names</source>
        <translation>Stednavne</translation>
    </message>
    <message>
        <source>Ice chart</source>
        <translation>Iskort</translation>
    </message>
    <message>
        <source>Forecast wind</source>
        <translation>Vind i prognosen</translation>
    </message>
    <message>
        <source>Forecast current</source>
        <translation>Strøm i prognosen</translation>
    </message>
    <message>
        <source>Predicted drift</source>
        <translation>Forventet drift</translation>
    </message>
    <message>
        <source>Time between two marks of the predicted drift, up to 48 h</source>
        <translation>Tid mellem to mærker for den forventede drift, op til 48 t</translation>
    </message>
    <message>
        <source>every %1</source>
        <translation>hver %1</translation>
    </message>
    <message>
        <source>Marks of the drift</source>
        <translation>Mærker for driften</translation>
    </message>
</context>
<context>
    <name>berg::LogRows</name>
    <message>
        <source>Write a log</source>
        <translation>Skriv en log</translation>
    </message>
    <message>
        <source>Open a log…</source>
        <translation>Åbn en log…</translation>
    </message>
    <message>
        <source>Plays a recorded flight (.tlog) in place of a link.</source>
        <translation>Afspiller en optaget flyvning (.tlog) i stedet for en forbindelse.</translation>
    </message>
    <message>
        <source>Part of the log that has been played</source>
        <translation>Del af loggen, der er afspillet</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>Afspilningens hastighed</translation>
    </message>
    <message>
        <source>Seconds of the log that are played in each second</source>
        <translation>Sekunder af loggen, der afspilles i hvert sekund</translation>
    </message>
    <message>
        <source>Writes every frame sent and received to a new file (.tlog) in the folder %1.</source>
        <translation>Skriver hver ramme, der sendes og modtages, til en ny fil (.tlog) i mappen %1.</translation>
    </message>
    <message>
        <source>Log %1 has been played: %2</source>
        <translation>Loggen %1 er afspillet: %2</translation>
    </message>
    <message>
        <source>Playing log %1: %2</source>
        <translation>Afspiller loggen %1: %2</translation>
    </message>
    <message>
        <source>Damaged parts were skipped (%1).</source>
        <translation>Beskadigede dele blev sprunget over (%1).</translation>
    </message>
    <message>
        <source>The log cannot be written: %1 (%2)</source>
        <translation>Loggen kan ikke skrives: %1 (%2)</translation>
    </message>
    <message>
        <source>The log has reached its largest size and has ended: %1</source>
        <translation>Loggen har nået sin største størrelse og er afsluttet: %1</translation>
    </message>
    <message>
        <source>Log: %1 (%2)</source>
        <translation>Log: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>berg::MainWindow</name>
    <message>
        <source>Untitled</source>
        <translation>Uden navn</translation>
    </message>
</context>
<context>
    <name>berg::ManualWindow</name>
    <message>
        <source>Bergwatch manual</source>
        <translation>Bergwatch-håndbog</translation>
    </message>
    <message>
        <source>Contents of the manual</source>
        <translation>Håndbogens indhold</translation>
    </message>
    <message>
        <source>Text of the manual</source>
        <translation>Håndbogens tekst</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Tilbage</translation>
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
        <translation>Søg i håndbogen (Ctrl+F)</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Søg i håndbogen</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Forrige</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Næste</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>Ikke fundet</translation>
    </message>
    <message>
        <source>Lines found: %1</source>
        <translation>Linjer fundet: %1</translation>
    </message>
</context>
<context>
    <name>berg::MapController</name>
    <message numerus="yes">
        <source>%n icebergs removed from this run. Undo brings them back.</source>
        <translation>
            <numerusform>%n isbjerg fjernet fra denne flyvning. Fortryd henter det tilbage.</numerusform>
            <numerusform>%n isbjerge fjernet fra denne flyvning. Fortryd henter dem tilbage.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::MapView</name>
    <message>
        <source>Map</source>
        <translation>Kort</translation>
    </message>
    <message numerus="yes">
        <source>%n icebergs and the UAVs on the sea. Arrow keys move the map or the selection, plus and minus zoom, F fits. The iceberg table lists the icebergs.</source>
        <translation>
            <numerusform>%n isbjerg og dronerne på havet. Piletaster flytter kortet eller det valgte, plus og minus zoomer, F viser alt. Isbjergtabellen viser isbjergene.</numerusform>
            <numerusform>%n isbjerge og dronerne på havet. Piletaster flytter kortet eller det valgte, plus og minus zoomer, F viser alt. Isbjergtabellen viser isbjergene.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Filer</translation>
    </message>
    <message>
        <source>&amp;New scenario</source>
        <translation>&amp;Nyt scenarie</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Åbn...</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>S&amp;tartside</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Åbn s&amp;eneste</translation>
    </message>
    <message>
        <source>&amp;Import sightings...</source>
        <translation>&amp;Importér observationer...</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Gem</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Gem &amp;som...</translation>
    </message>
    <message>
        <source>Keep a &amp;backup copy</source>
        <translation>Behold en sikkerheds&amp;kopi</translation>
    </message>
    <message>
        <source>Before the first overwrite of a file, a copy is kept as NAME.berg~</source>
        <translation>Før en fil overskrives første gang, gemmes en kopi som NAVN.berg~</translation>
    </message>
    <message>
        <source>Reco&amp;ver unsaved work...</source>
        <translation>Gen&amp;dan ikke-gemt arbejde...</translation>
    </message>
    <message>
        <source>There is no unsaved work to recover</source>
        <translation>Der er intet ikke-gemt arbejde at gendanne</translation>
    </message>
    <message>
        <source>Save r&amp;un...</source>
        <translation>Gem fly&amp;vning...</translation>
    </message>
    <message>
        <source>&amp;Export plan...</source>
        <translation>Eks&amp;portér plan...</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Afslut</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Redigér</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>K&amp;lip</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiér</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Sæt ind</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>&amp;Duplikér</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Sl&amp;et</translation>
    </message>
    <message>
        <source>Add UA&amp;V</source>
        <translation>&amp;Tilføj drone</translation>
    </message>
    <message>
        <source>&amp;Generate icebergs...</source>
        <translation>&amp;Generér isbjerge...</translation>
    </message>
    <message>
        <source>Select &amp;all icebergs</source>
        <translation>&amp;Markér alle isbjerge</translation>
    </message>
    <message>
        <source>&amp;Move the scenario…</source>
        <translation>Flyt s&amp;cenariet…</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vis</translation>
    </message>
    <message>
        <source>Chec&amp;ks</source>
        <translation>Kont&amp;rol</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Paneler</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Nulstil layout</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Fulds&amp;kærm</translation>
    </message>
    <message>
        <source>&amp;Fit everything</source>
        <translation>&amp;Tilpas alt</translation>
    </message>
    <message>
        <source>Follo&amp;w the UAV</source>
        <translation>&amp;Følg dronen</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Zoom &amp;ind</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zoom &amp;ud</translation>
    </message>
    <message>
        <source>O&amp;verview</source>
        <translation>&amp;Oversigtskort</translation>
    </message>
    <message>
        <source>Swept ar&amp;ea</source>
        <translation>&amp;Afsøgt område</translation>
    </message>
    <message>
        <source>S&amp;how true positions</source>
        <translation>&amp;Vis sande positioner</translation>
    </message>
    <message>
        <source>Shows the true positions of the icebergs beside the estimates. When off, the map shows only what an operator would see.</source>
        <translation>Viser isbjergenes sande positioner ved siden af estimaterne. Når det er slået fra, viser kortet kun det, en operatør ville se.</translation>
    </message>
    <message>
        <source>F&amp;light</source>
        <translation>F&amp;lyvning</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>Flyv</translation>
    </message>
    <message>
        <source>&amp;Step one second</source>
        <translation>É&amp;t sekund frem</translation>
    </message>
    <message>
        <source>Stop and &amp;edit</source>
        <translation>Stop og &amp;redigér</translation>
    </message>
    <message>
        <source>Restore disc&amp;arded flight</source>
        <translation>Hent flyvningen til&amp;bage</translation>
    </message>
    <message>
        <source>Prefer s&amp;horter route</source>
        <translation>Foretræk &amp;kortere rute</translation>
    </message>
    <message>
        <source>Prefer more un&amp;certain first</source>
        <translation>Foretræk mere &amp;usikre først</translation>
    </message>
    <message>
        <source>Report as seen no&amp;w</source>
        <translation>&amp;Meld som set nu</translation>
    </message>
    <message>
        <source>Win&amp;d...</source>
        <translation>&amp;Vind...</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>&amp;Hurtigere</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>L&amp;angsommere</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Step &amp;back one second</source>
        <translation>Ét sekund ti&amp;lbage</translation>
    </message>
    <message>
        <source>Step one &amp;tick</source>
        <translation>Ét tids&amp;skridt frem</translation>
    </message>
    <message>
        <source>Step back one t&amp;ick</source>
        <translation>Ét tidsskr&amp;idt tilbage</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>&amp;Næste hændelse</translation>
    </message>
    <message>
        <source>&amp;Previous event</source>
        <translation>Forri&amp;ge hændelse</translation>
    </message>
    <message>
        <source>&amp;Go to time</source>
        <translation>Gå til ti&amp;d</translation>
    </message>
    <message>
        <source>Bac&amp;k to latest</source>
        <translation>Tilbage til s&amp;eneste</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hjælp</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Rundvisning</translation>
    </message>
    <message>
        <source>&amp;About Bergwatch</source>
        <translation>&amp;Om Bergwatch</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Værktøjer</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Vælg</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isbjerg</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
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
        <translation>Panorér</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>Værk&amp;tøjer</translation>
    </message>
    <message>
        <source>Zoom at the cursor</source>
        <translation>Zoom ved markøren</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>hjulet</translation>
    </message>
    <message>
        <source>middle button, or arrow keys</source>
        <translation>midterste knap eller piletaster</translation>
    </message>
    <message>
        <source>Nudge what is selected</source>
        <translation>Skub det valgte</translation>
    </message>
    <message>
        <source>arrow keys</source>
        <translation>piletaster</translation>
    </message>
    <message>
        <source>Finish drawing, undo last point</source>
        <translation>Afslut tegningen, fortryd sidste punkt</translation>
    </message>
    <message>
        <source>Enter, Backspace</source>
        <translation>Enter, Backspace</translation>
    </message>
    <message>
        <source>Steps of 15° while an arrow is drawn</source>
        <translation>Trin på 15°, mens en pil tegnes</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Skift</translation>
    </message>
    <message>
        <source>Cancel drawing, leave tool, clear selection</source>
        <translation>Annullér tegningen, forlad værktøjet, ryd markeringen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Genvejstaster</translation>
    </message>
    <message>
        <source>About Bergwatch</source>
        <translation>Om Bergwatch</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Bergwatch %1&lt;/h3&gt;&lt;p&gt;Plans and simulates UAV missions that monitor drifting icebergs.&lt;/p&gt;&lt;p&gt;Own code: MIT licence. Qt Charts: GPL 3. COIN-OR CBC: EPL. Land made with Natural Earth.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Bergwatch %1&lt;/h3&gt;&lt;p&gt;Planlægger og simulerer dronemissioner, der overvåger drivende isbjerge.&lt;/p&gt;&lt;p&gt;Egen kode: MIT-licens. Qt Charts: GPL 3. COIN-OR CBC: EPL. Landområder lavet med Natural Earth.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No-fly area</source>
        <translation>Flyveforbudsområde</translation>
    </message>
    <message>
        <source>&amp;Return home now</source>
        <translation>Flyv h&amp;jem nu</translation>
    </message>
    <message>
        <source>Hold here</source>
        <translation>Vent her</translation>
    </message>
    <message>
        <source>Res&amp;ume</source>
        <translation>F&amp;ortsæt</translation>
    </message>
    <message>
        <source>Panels on the map</source>
        <translation>Paneler på kortet</translation>
    </message>
    <message>
        <source>&amp;Title and figures</source>
        <translation>&amp;Titel og tal</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>&amp;Signaturforklaring</translation>
    </message>
    <message>
        <source>&amp;Scale bar</source>
        <translation>&amp;Målestok</translation>
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
        <translation>Flyvebrie&amp;fing...</translation>
    </message>
    <message>
        <source>Copy p&amp;icture of the map</source>
        <translation>Kopiér &amp;billede af kortet</translation>
    </message>
    <message>
        <source>La&amp;youts</source>
        <translation>La&amp;yout</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Planlæg</translation>
    </message>
    <message>
        <source>&amp;Fly</source>
        <translation>&amp;Flyv</translation>
    </message>
    <message>
        <source>&amp;Analyse</source>
        <translation>&amp;Analysér</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>Hånd&amp;bog</translation>
    </message>
    <message>
        <source>Find or &amp;go to…</source>
        <translation>Find eller &amp;gå til…</translation>
    </message>
    <message>
        <source>Import airspa&amp;ce...</source>
        <translation>Importér luft&amp;rum...</translation>
    </message>
    <message>
        <source>Flight &amp;log...</source>
        <translation>Flyve&amp;log...</translation>
    </message>
    <message>
        <source>&amp;Background map…</source>
        <translation>&amp;Baggrundskort…</translation>
    </message>
    <message>
        <source>Values of a chart as a table</source>
        <translation>Et diagrams værdier som tabel</translation>
    </message>
    <message>
        <source>Keyboard &amp;shortcuts</source>
        <translation>Tastatur&amp;genveje</translation>
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
        <translation>Farveskala for σ</translation>
    </message>
    <message>
        <source>Place names</source>
        <translation>Stednavne</translation>
    </message>
    <message>
        <source>S&amp;ound alarms</source>
        <translation>L&amp;yd ved alarmer</translation>
    </message>
    <message>
        <source>A sound at each new alarm, until it is acknowledged</source>
        <translation>En lyd ved hver ny alarm, indtil den er kvitteret</translation>
    </message>
    <message>
        <source>&amp;New icebergs seen by</source>
        <translation>&amp;Nye isbjerge set med</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Fortryd</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Omgør</translation>
    </message>
    <message>
        <source>I&amp;mport forecast...</source>
        <translation>I&amp;mportér prognose...</translation>
    </message>
    <message>
        <source>Import ice c&amp;hart...</source>
        <translation>Imp&amp;ortér iskort...</translation>
    </message>
    <message>
        <source>Ice chart</source>
        <translation>Iskort</translation>
    </message>
    <message>
        <source>Forecast wind</source>
        <translation>Vind i prognosen</translation>
    </message>
    <message>
        <source>Forecast current</source>
        <translation>Strøm i prognosen</translation>
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
        <translation>Meddelelser</translation>
    </message>
</context>
<context>
    <name>berg::MissionRunner</name>
    <message>
        <source>The scenario has changed meanwhile. Nothing was exported.</source>
        <translation>Scenariet er ændret i mellemtiden. Intet blev eksporteret.</translation>
    </message>
    <message>
        <source>The run has ended. Stop and edit to fly it differently.</source>
        <translation>Flyvningen er slut. Stop og redigér for at flyve den på en anden måde.</translation>
    </message>
</context>
<context>
    <name>berg::MissionWorker</name>
    <message>
        <source>There is no run to save: the scenario cannot be planned.</source>
        <translation>Der er ingen flyvning at gemme: scenariet kan ikke planlægges.</translation>
    </message>
    <message>
        <source>The replay of this run differs from the recording: %1</source>
        <translation>Afspilningen af denne flyvning afviger fra optagelsen: %1</translation>
    </message>
    <message>
        <source>There is no plan to upload.</source>
        <translation>Der er ingen plan at sende op.</translation>
    </message>
    <message>
        <source>This scenario cannot be flown. Fix the reported errors first.</source>
        <translation>Dette scenarie kan ikke flyves. Ret de meldte fejl først.</translation>
    </message>
    <message>
        <source>The flight follows real aircraft at their pace: it cannot be stepped.</source>
        <translation>Flyvningen følger virkelige luftfartøjer i deres tempo: den kan ikke køres trinvist.</translation>
    </message>
</context>
<context>
    <name>berg::NumberField</name>
    <message>
        <source>mixed</source>
        <translation>forskellige</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read. Type it like %2.</source>
        <translation>»%1« kan ikke læses. Skriv det som %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is above the highest value. %2 was set.</source>
        <translation>»%1« er over den højeste værdi. %2 blev sat.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is below the lowest value. %2 was set.</source>
        <translation>»%1« er under den laveste værdi. %2 blev sat.</translation>
    </message>
</context>
<context>
    <name>berg::OriginDialog</name>
    <message>
        <source>Move the scenario</source>
        <translation>Flyt scenariet</translation>
    </message>
    <message>
        <source>&amp;Origin at</source>
        <translation>&amp;Origo ved</translation>
    </message>
    <message>
        <source>Move &amp;everything along with the origin</source>
        <translation>Flyt &amp;alt sammen med origo</translation>
    </message>
    <message>
        <source>&amp;Leave everything at its place on the Earth</source>
        <translation>&amp;Lad alt blive, hvor det er på Jorden</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Flyt</translation>
    </message>
    <message>
        <source>Not everything can stay at its place: a scenario reaches %1 from its origin. Move everything along, or choose a nearer place.</source>
        <translation>Ikke alt kan blive, hvor det er: et scenarie rækker %1 fra sit origo. Flyt alt med, eller vælg et nærmere sted.</translation>
    </message>
    <message>
        <source>The origin moves to %1, %2 away. Positions, courses and drift on the Earth stay the same.</source>
        <translation>Origo flyttes til %1, %2 væk. Positioner, kurser og drift på Jorden forbliver de samme.</translation>
    </message>
    <message>
        <source>Everything moves to %1, %2 away, and keeps its position relative to the origin.</source>
        <translation>Alt flyttes til %1, %2 væk, og beholder sin position i forhold til origo.</translation>
    </message>
    <message>
        <source>The origin is here now.</source>
        <translation>Origo er her nu.</translation>
    </message>
</context>
<context>
    <name>berg::OverviewInset</name>
    <message>
        <source>Overview</source>
        <translation>Oversigtskort</translation>
    </message>
    <message>
        <source>Polar chart showing the location of the map. Click a place to move the map there.</source>
        <translation>Polarkort, der viser kortets placering. Klik på et sted for at flytte kortet dertil.</translation>
    </message>
</context>
<context>
    <name>berg::ParetoChart</name>
    <message>
        <source>Distance against uncertainty reward</source>
        <translation>Distance mod usikkerhedsgevinst</translation>
    </message>
    <message>
        <source>No icebergs to plan for</source>
        <translation>Ingen isbjerge at planlægge for</translation>
    </message>
    <message>
        <source>Computing the plans for every τ</source>
        <translation>Beregner planerne for hver τ</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>Uncertainty reward, m²</source>
        <translation>Usikkerhedsgevinst, m²</translation>
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
        <translation>Korteste vej</translation>
    </message>
    <message>
        <source>Whole order, %1</source>
        <translation>Hele rækkefølgen, %1</translation>
    </message>
</context>
<context>
    <name>berg::PlaceField</name>
    <message>
        <source>Coordinate or name of a place</source>
        <translation>Koordinat eller stednavn</translation>
    </message>
</context>
<context>
    <name>berg::PlanModel</name>
    <message>
        <source>%1 (id %2)</source>
        <translation>%1 (id&apos;et er %2)</translation>
    </message>
    <message>
        <source>Place in the visiting order</source>
        <translation>Plads i besøgsrækkefølgen</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Isbjerg</translation>
    </message>
    <message>
        <source>Name of the iceberg</source>
        <translation>Isbjergets navn</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Etape</translation>
    </message>
    <message>
        <source>Distance from the previous iceberg, or from the UAV</source>
        <translation>Distance fra det forrige isbjerg eller fra dronen</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Ankomst</translation>
    </message>
    <message>
        <source>Uncertainty of the position now</source>
        <translation>Positionens usikkerhed nu</translation>
    </message>
    <message>
        <source>later</source>
        <translation>senere</translation>
    </message>
    <message>
        <source>The plan ends before this iceberg is seen.</source>
        <translation>Planen slutter, før dette isbjerg ses.</translation>
    </message>
    <message numerus="yes">
        <source>%n visits</source>
        <translation>
            <numerusform>%n besøg</numerusform>
            <numerusform>%n besøg</numerusform>
        </translation>
    </message>
    <message>
        <source>It has no iceberg to visit.</source>
        <translation>Den har intet isbjerg at besøge.</translation>
    </message>
    <message>
        <source>%1, flown %2</source>
        <comment>length and end of a way</comment>
        <translation>%1, fløjet %2</translation>
    </message>
    <message>
        <source>Assigned to %1</source>
        <translation>Tildelt %1</translation>
    </message>
    <message>
        <source>In view</source>
        <translation>I synsfeltet</translation>
    </message>
    <message>
        <source>Probability that the iceberg is in view when the UAV reaches its estimate</source>
        <translation>Sandsynlighed for, at isbjerget er i synsfeltet, når dronen når estimatet af det</translation>
    </message>
    <message>
        <source>%1 (search)</source>
        <translation>%1 (eftersøgning)</translation>
    </message>
    <message>
        <source>Lost: searched for %1</source>
        <comment>times and chances of finding it</comment>
        <translation>Mistet: eftersøges %1</translation>
    </message>
    <message>
        <source>Returning home</source>
        <translation>På vej hjem</translation>
    </message>
    <message>
        <source>σ now</source>
        <translation>σ nu</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>På jorden</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Venter</translation>
    </message>
    <message>
        <source>Uncertainty of the position on arrival</source>
        <translation>Positionens usikkerhed ved ankomsten</translation>
    </message>
    <message>
        <source>%1, flown by %2</source>
        <comment>length and end of a path, UTC</comment>
        <translation>%1, fløjet inden %2</translation>
    </message>
    <message>
        <source>Course over ground %1, ground speed %2</source>
        <translation>Kurs over grunden %1, fart over grunden %2</translation>
    </message>
    <message>
        <source>Now %1; at arrival %2, if the iceberg is not seen before</source>
        <translation>Nu %1; ved ankomst %2, hvis isbjerget ikke er set før</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Course over ground at the start of the leg</source>
        <translation>Kurs over grunden i begyndelsen af etapen</translation>
    </message>
    <message>
        <source>Speed</source>
        <comment>over ground</comment>
        <translation>Fart</translation>
    </message>
    <message>
        <source>Ground speed in the present wind</source>
        <translation>Fart over grunden i den nuværende vind</translation>
    </message>
    <message>
        <source>Arrival of the UAV</source>
        <translation>Dronens ankomst</translation>
    </message>
    <message>
        <source>95 % now</source>
        <translation>95 % nu</translation>
    </message>
    <message>
        <source>A later visit of the patrol, %1. Its path is planned when its turn comes.</source>
        <translation>Et senere besøg i patruljen, %1. Banen planlægges, når det er dets tur.</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Igen</translation>
    </message>
    <message>
        <source>When the patrol comes back to the iceberg</source>
        <translation>Hvornår patruljen vender tilbage til isbjerget</translation>
    </message>
</context>
<context>
    <name>berg::PlanPanel</name>
    <message>
        <source>There is no plan: see Checks.</source>
        <translation>Der er ingen plan: se Kontrol.</translation>
    </message>
    <message>
        <source>Plan: icebergs in visiting order</source>
        <translation>Plan: isbjerge i besøgsrækkefølge</translation>
    </message>
    <message>
        <source>Order before the change at %1: %2</source>
        <translation>Rækkefølge før ændringen ved %1: %2</translation>
    </message>
    <message>
        <source>Predicted for straight legs to the icebergs as they drift,
without sightings en route and without new plans.</source>
        <translation>Forudsagt for lige etaper til isbjergene, som de driver,
uden observationer undervejs og uden nye planer.</translation>
    </message>
    <message>
        <source>Predicted for the path on the map, with every iceberg that comes into view
on it, without new plans.</source>
        <translation>Forudsagt for banen på kortet, med hvert isbjerg, der kommer i syne
undervejs, uden nye planer.</translation>
    </message>
    <message>
        <source>No useful lower bound on ζ</source>
        <translation>Ingen brugbar nedre grænse for ζ</translation>
    </message>
    <message>
        <source>The lower bound is proven for this scenario and its random drift,
for any policy and any turn radius.</source>
        <translation>Den nedre grænse er bevist for dette scenarie og dets tilfældige drift,
for enhver strategi og enhver drejeradius.</translation>
    </message>
    <message>
        <source>Out of radio range for %1</source>
        <translation>Uden for radiorækkevidde i %1</translation>
    </message>
    <message>
        <source>Recovery slots: %1</source>
        <translation>Landingsvinduer: %1</translation>
    </message>
    <message>
        <source>Compared with the last plan: %1</source>
        <translation>Sammenlignet med den forrige plan: %1</translation>
    </message>
    <message>
        <source>The run is complete.</source>
        <translation>Flyvningen er gennemført.</translation>
    </message>
    <message>
        <source>This sortie: %1 with the return, flown by %2</source>
        <translation>Dette togt: %1 med hjemturen, færdig %2</translation>
    </message>
    <message>
        <source>This sortie: %1 with the return, flown %2</source>
        <translation>Dette togt: %1 med hjemturen, fløjet %2</translation>
    </message>
    <message>
        <source>This sortie: %1, flown by %2</source>
        <translation>Dette togt: %1, færdig %2</translation>
    </message>
    <message>
        <source>This sortie: %1, flown %2</source>
        <translation>Dette togt: %1, fløjet %2</translation>
    </message>
    <message>
        <source>ζ at the end: %1</source>
        <translation>ζ til sidst: %1</translation>
    </message>
    <message>
        <source>Expected ζ at %1 with this plan: %2</source>
        <translation>Forventet ζ ved %1 med denne plan: %2</translation>
    </message>
    <message>
        <source>Expected ζ at the end with this plan: %1</source>
        <translation>Forventet ζ til slut med denne plan: %1</translation>
    </message>
    <message>
        <source>Compared with the last plan: %1, ζ %2</source>
        <translation>Sammenlignet med den forrige plan: %1, ζ %2</translation>
    </message>
    <message>
        <source>Lower bound on ζ: being computed, %1 %</source>
        <translation>Nedre grænse for ζ: beregnes, %1 %</translation>
    </message>
    <message>
        <source>Lower bound on ζ: %1</source>
        <translation>Nedre grænse for ζ: %1</translation>
    </message>
    <message>
        <source>The length of this sortie is over ground, up to the end of the run at most.</source>
        <translation>Længden af dette togt er over grunden, højst til flyvningen slutter.</translation>
    </message>
    <message>
        <source>Nothing to visit: there are no icebergs yet, all of them are in view, or none can be visited without using the reserve.</source>
        <translation>Intet at besøge: der er ingen isbjerge endnu, alle er i syne, eller ingen kan besøges uden at bruge reserven.</translation>
    </message>
    <message>
        <source>Longest time unseen: %1 (%2)</source>
        <comment>duration and iceberg</comment>
        <translation>Længste tid uset: %1 (%2)</translation>
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
        <translation>Usikkerhedsgevinst</translation>
    </message>
    <message>
        <source>Sum of each iceberg&apos;s σ times the number of places after it in the order: larger if uncertain icebergs come early.</source>
        <translation>Summen af hvert isbjergs σ gange antallet af pladser efter det i rækkefølgen: større, hvis usikre isbjerge kommer tidligt.</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Målfunktion</translation>
    </message>
    <message>
        <source>Distance cost minus uncertainty reward: the objective that the solver minimises.</source>
        <translation>Afstandsomkostning minus usikkerhedsgevinst: den målfunktion, løseren minimerer.</translation>
    </message>
    <message>
        <source>Distance weight μ</source>
        <translation>Afstandsvægt μ</translation>
    </message>
    <message>
        <source>Uncertainty that one metre of path must be worth; follows from τ.</source>
        <translation>Den usikkerhed, som én meter vej skal være værd; følger af τ.</translation>
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
        <translation>Planens målfunktion og afstandsvægt</translation>
    </message>
    <message>
        <source>State of the plan: %1</source>
        <translation>Planens tilstand: %1</translation>
    </message>
    <message>
        <source>Whole order</source>
        <translation>Hele rækkefølgen</translation>
    </message>
    <message>
        <source>Planned length of the whole order through the air, with turns; in wind the mean of both directions. The solver weighs this length and the trade-off chart shows it. The plan panel shows the length of this sortie over ground.</source>
        <translation>Planlagt længde af hele rækkefølgen gennem luften, med drej; i vind middel af begge retninger. Løseren vejer denne længde, og afvejningsdiagrammet viser den. Planpanelet viser længden af dette togt over grunden.</translation>
    </message>
</context>
<context>
    <name>berg::PlaybackBar</name>
    <message>
        <source>Fly</source>
        <translation>Flyv</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Trin</translation>
    </message>
    <message>
        <source>Rate of the flight</source>
        <translation>Flyvningens hastighed</translation>
    </message>
    <message>
        <source>Simulated seconds flown in one second</source>
        <translation>Simulerede sekunder fløjet på ét sekund</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>The plan is still being made.</source>
        <translation>Planen er stadig under udarbejdelse.</translation>
    </message>
    <message>
        <source>This scenario cannot be flown. Fix the reported errors first.</source>
        <translation>Dette scenarie kan ikke flyves. Ret de meldte fejl først.</translation>
    </message>
    <message>
        <source>The run has ended.</source>
        <translation>Flyvningen er slut.</translation>
    </message>
    <message>
        <source>Fly again from the start (Space)</source>
        <translation>Flyv igen fra starten (mellemrum)</translation>
    </message>
    <message>
        <source>Pause the flight (Space)</source>
        <translation>Sæt flyvningen på pause (mellemrum)</translation>
    </message>
    <message>
        <source>Fly the plan (Space)</source>
        <translation>Flyv planen (mellemrum)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Fly one second and pause</source>
        <translation>Flyv ét sekund, og hold pause</translation>
    </message>
    <message>
        <source>Time line of the run</source>
        <translation>Flyvningens tidslinje</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>Vist tid</translation>
    </message>
    <message>
        <source>Time shown. Type a time to look back, e.g. 3:20.</source>
        <translation>Vist tid. Skriv en tid for at se tilbage, f.eks. 3:20.</translation>
    </message>
    <message>
        <source>Length of the run</source>
        <translation>Flyvningens længde</translation>
    </message>
    <message>
        <source>Fastest</source>
        <translation>Hurtigst</translation>
    </message>
    <message>
        <source>Stop and edit</source>
        <translation>Stop og redigér</translation>
    </message>
    <message>
        <source>Ends the flight and goes back to the start, where everything can be edited.</source>
        <translation>Afslutter flyvningen og går tilbage til starten, hvor alt kan redigeres.</translation>
    </message>
    <message>
        <source>The run is complete. The scenario stays locked until you stop and edit.</source>
        <translation>Flyvningen er gennemført. Scenariet forbliver låst, indtil du vælger Stop og redigér.</translation>
    </message>
    <message>
        <source>Scenario locked in flight. τ and policy can be changed while flying; the plan follows at once.</source>
        <translation>Scenariet er låst under flyvning. τ og strategi kan ændres; planen følger straks med.</translation>
    </message>
    <message>
        <source>Scenario locked</source>
        <translation>Scenariet er låst</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time. Type it like 3:20 or 45 min.</source>
        <translation>»%1« er ikke en tid. Skriv den som 3:20 eller 45 min.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time of this run. Type it like 1215Z, 3:20 or 45 min.</source>
        <translation>»%1« er ikke et tidspunkt i denne flyvning. Skriv det som 1215Z, 3:20 eller 45 min.</translation>
    </message>
    <message>
        <source>Time shown. Type a time to look back, e.g. 1215Z, or 3:20 since the start.</source>
        <translation>Vist tid. Skriv en tid for at se tilbage, f.eks. 1215Z eller 3:20 siden starten.</translation>
    </message>
    <message>
        <source>End of the run</source>
        <translation>Flyvningens afslutning</translation>
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
        <translation>tager for lang tid</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>valgt</translation>
    </message>
    <message>
        <source>ζ not predicted: takes too long</source>
        <translation>ζ ikke forudsagt: tager for lang tid</translation>
    </message>
    <message>
        <source>Predicting ζ…</source>
        <translation>Forudsiger ζ…</translation>
    </message>
    <message>
        <source>Predicted before take-off: ζ %1</source>
        <translation>Forudsagt før start: ζ %1</translation>
    </message>
    <message>
        <source>Predicted ζ %1</source>
        <translation>Forudsagt ζ %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 til %2</translation>
    </message>
    <message>
        <source>Recommended</source>
        <translation>Anbefalet</translation>
    </message>
    <message>
        <source>%1; too slow to compare: %2</source>
        <translation>%1; for langsom til sammenligning: %2</translation>
    </message>
    <message>
        <source>Not predicted: flying it %1 times in advance takes more than %2.</source>
        <translation>Ikke forudsagt: at flyve den %1 gange på forhånd tager mere end %2.</translation>
    </message>
    <message>
        <source>ζ is predicted before take-off by flying the mission %1 times with each policy, with drift
and sightings drawn as the scenario describes them, in the same %1 worlds: ζ is the mean of
these flights, the range that of 90 % of them. A policy is recommended if its ζ is surely lower
than that of every other one (95 % interval of the differences in the same worlds).</source>
        <translation>ζ forudsiges før start ved at flyve missionen %1 gange med hver strategi, med drift og
observationer trukket, som scenariet beskriver dem, i de samme %1 verdener: ζ er middel af
disse flyvninger, området gælder 90 % af dem. En strategi anbefales, hvis dens ζ med sikkerhed er lavere
end for alle andre (95 %-intervallet af forskellene i de samme verdener).</translation>
    </message>
    <message>
        <source>Predicting ζ: %1 %</source>
        <translation>Forudsiger ζ: %1 %</translation>
    </message>
    <message>
        <source>No ζ to predict: there is no iceberg out of view.</source>
        <translation>Ingen ζ at forudsige: intet isbjerg er ude af syne.</translation>
    </message>
    <message>
        <source>%1; no policy is a clear winner</source>
        <translation>%1; ingen strategi er en klar vinder</translation>
    </message>
    <message>
        <source>%1; recommended</source>
        <translation>%1; anbefalet</translation>
    </message>
    <message>
        <source>%1; recommended: %2</source>
        <translation>%1; anbefalet: %2</translation>
    </message>
</context>
<context>
    <name>berg::PreferenceMenus</name>
    <message>
        <source>&amp;Appearance</source>
        <translation>Uds&amp;eende</translation>
    </message>
    <message>
        <source>U&amp;nits</source>
        <translation>En&amp;heder</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprog</translation>
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
        <translation>&amp;Afstande</translation>
    </message>
    <message>
        <source>Metres and kilometres</source>
        <translation>Meter og kilometer</translation>
    </message>
    <message>
        <source>Nautical miles</source>
        <translation>Sømil</translation>
    </message>
    <message>
        <source>&amp;Speeds</source>
        <translation>&amp;Fart</translation>
    </message>
    <message>
        <source>Metres per second</source>
        <translation>Meter pr. sekund</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>Knob</translation>
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
        <translation>Decimalgrader, %1</translation>
    </message>
    <message>
        <source>Degrees, minutes, seconds, %1</source>
        <translation>Grader, minutter, sekunder, %1</translation>
    </message>
    <message>
        <source>Speed and direction: wind from, drift towards</source>
        <translation>Fart og retning: vind fra, drift mod</translation>
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
        <source>Text si&amp;ze</source>
        <translation>Tekstst&amp;ørrelse</translation>
    </message>
    <message>
        <source>High contrast, light</source>
        <translation>Høj kontrast, lyst</translation>
    </message>
    <message>
        <source>High contrast, dark</source>
        <translation>Høj kontrast, mørkt</translation>
    </message>
    <message>
        <source>Restart Bergwatch to apply the new text size.</source>
        <translation>Start Bergwatch igen for at bruge den nye tekststørrelse.</translation>
    </message>
    <message>
        <source>Night (red)</source>
        <translation>Nat (rødt)</translation>
    </message>
    <message>
        <source>Automatic, from the scenario</source>
        <translation>Automatisk, efter scenariet</translation>
    </message>
    <message>
        <source>Ends at %1 m²</source>
        <translation>Slutter ved %1 m²</translation>
    </message>
    <message>
        <source>&amp;Heights</source>
        <translation>&amp;Højder</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Fod</translation>
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
        <translation>UTC, hvis scenariet har et starttidspunkt</translation>
    </message>
    <message>
        <source>Elapsed since the start</source>
        <translation>Tid siden start</translation>
    </message>
    <message>
        <source>&amp;Uncertainty</source>
        <translation>&amp;Usikkerhed</translation>
    </message>
    <message>
        <source>σ first, 95 % radius beside it</source>
        <translation>σ først, 95 %-radius ved siden af</translation>
    </message>
    <message>
        <source>95 % radius first, σ beside it</source>
        <translation>95 %-radius først, σ ved siden af</translation>
    </message>
    <message>
        <source>True</source>
        <translation>Retvisende</translation>
    </message>
    <message>
        <source>True and magnetic, by the World Magnetic Model 2025</source>
        <translation>Retvisende og magnetiske, efter World Magnetic Model 2025</translation>
    </message>
    <message>
        <source>True and magnetic, declination %1...</source>
        <translation>Retvisende og magnetiske, misvisning %1 …</translation>
    </message>
    <message>
        <source>True and magnetic, declination entered by hand...</source>
        <translation>Retvisende og magnetiske, indtastet misvisning …</translation>
    </message>
</context>
<context>
    <name>berg::RecentRow</name>
    <message>
        <source>The file is gone</source>
        <translation>Filen er væk</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Remove it from this list.</source>
        <translation>Fjern den fra denne liste.</translation>
    </message>
</context>
<context>
    <name>berg::RecoveryDialog</name>
    <message>
        <source>Recovered work</source>
        <translation>Gendannet arbejde</translation>
    </message>
    <message>
        <source>Bergwatch ended unexpectedly. Unsaved changes were kept. Restore them, and then save them.</source>
        <translation>Bergwatch sluttede uventet. Ændringer, der ikke var gemt, blev bevaret. Gendan dem, og gem dem derefter.</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Gendan</translation>
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
        <translation>Ændret</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>ikke gemt endnu</translation>
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
        <translation>Flyvninger (*.bergrun);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Gemte %1</translation>
    </message>
    <message numerus="yes">
        <source>%n files with these names exist. Their content would be lost.</source>
        <translation>
            <numerusform>%n fil med dette navn findes. Dens indhold ville gå tabt.</numerusform>
            <numerusform>%n filer med disse navne findes. Deres indhold ville gå tabt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>Eksporterede %1</translation>
    </message>
    <message numerus="yes">
        <source>Exported %n files</source>
        <translation>
            <numerusform>Eksporterede %n fil</numerusform>
            <numerusform>Eksporterede %n filer</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture of the map copied</source>
        <translation>Billede af kortet kopieret</translation>
    </message>
    <message>
        <source>The run is saved as soon as the current plan is made.</source>
        <translation>Flyvningen gemmes, så snart den nuværende plan er lavet.</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Gemmer %1</translation>
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
        <translation>Flyvninger</translation>
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
        <translation>Flyvning</translation>
    </message>
    <message>
        <source>ζ, m² s</source>
        <translation>ζ, m² s</translation>
    </message>
    <message>
        <source>vs A</source>
        <translation>mod A</translation>
    </message>
    <message>
        <source>The reference: click a circle, or press A.</source>
        <translation>Referencen: klik på en cirkel, eller tryk på A.</translation>
    </message>
    <message>
        <source>Compared with it: click a circle, or press B.</source>
        <translation>Sammenlignes med den: klik på en cirkel, eller tryk på B.</translation>
    </message>
    <message>
        <source>Zeta compared with that of A at the time both have flown.</source>
        <translation>Zeta sammenlignet med A&apos;s på det tidspunkt, begge har fløjet til.</translation>
    </message>
    <message>
        <source>Flown runs are listed here. The button below flies this scenario along the shortest round tour for comparison.</source>
        <translation>Gennemførte flyvninger står her. Knappen nedenfor flyver dette scenarie ad den korteste rundtur til sammenligning.</translation>
    </message>
    <message>
        <source>Its scenario differs from that of A: they cannot be compared.</source>
        <translation>Scenariet er et andet end A&apos;s: de kan ikke sammenlignes.</translation>
    </message>
    <message>
        <source>Make this run the reference A</source>
        <translation>Gør denne flyvning til referencen A</translation>
    </message>
    <message>
        <source>Compare this run with A</source>
        <translation>Sammenlign denne flyvning med A</translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>én drone</numerusform>
            <numerusform>%n droner</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Omdøb</translation>
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
        <translation>%1: sidste vendepunkt; en senere hjemtur bruger af reserven</translation>
    </message>
</context>
<context>
    <name>berg::ScenarioDialogs</name>
    <message numerus="yes">
        <source>Generate %n icebergs</source>
        <translation>
            <numerusform>Generér isbjerg</numerusform>
            <numerusform>Generér %n isbjerge</numerusform>
        </translation>
    </message>
    <message>
        <source>Move scenario</source>
        <translation>Flyt scenariet</translation>
    </message>
    <message>
        <source>Place the new scenario</source>
        <translation>Placér det nye scenarie</translation>
    </message>
    <message>
        <source>A forecast cannot be imported in flight. Stop the flight before importing.</source>
        <translation>En prognose kan ikke importeres under flyvning. Stop flyvningen, før du importerer.</translation>
    </message>
    <message>
        <source>Forecasts: NetCDF, GRIB, JSON (*.nc *.nc4 *.cdf *.grib *.grib2 *.grb *.grb2 *.json);;All files (*)</source>
        <translation>Prognoser: NetCDF, GRIB, JSON (*.nc *.nc4 *.cdf *.grib *.grib2 *.grb *.grb2 *.json);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Import forecast</source>
        <translation>Importér prognose</translation>
    </message>
    <message>
        <source>Remove forecast</source>
        <translation>Fjern prognose</translation>
    </message>
</context>
<context>
    <name>berg::ScenarioFiles</name>
    <message>
        <source>Scenarios (*.berg);;All files (*)</source>
        <translation>Scenarier (*.berg);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Another Bergwatch</source>
        <translation>En anden Bergwatch</translation>
    </message>
    <message>
        <source>Bergwatch, process %1 on %2</source>
        <translation>Bergwatch, proces %1 på %2</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Uden navn</translation>
    </message>
    <message>
        <source>New scenario</source>
        <translation>Nyt scenarie</translation>
    </message>
    <message>
        <source>Opened a copy of %1</source>
        <translation>Åbnede en kopi af %1</translation>
    </message>
    <message>
        <source>Another program has changed it since you opened it. Those changes would be lost.</source>
        <translation>Et andet program har ændret den, siden du åbnede den. De ændringer ville gå tabt.</translation>
    </message>
    <message>
        <source>%1 has it open. Changes saved there would be lost.</source>
        <translation>%1 har den åben. Ændringer, der gemmes der, ville gå tabt.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Gemte %1</translation>
    </message>
    <message>
        <source>Saved %1; a backup copy cannot be written to its folder</source>
        <translation>Gemte %1; en sikkerhedskopi kan ikke skrives i dens mappe</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Ingen filer endnu</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Læser %1</translation>
    </message>
    <message>
        <source>Scenarios, runs, studies and telemetry logs (*.berg *.bergrun *.bergstudy *.tlog);;All files (*)</source>
        <translation>Scenarier, flyvninger, studier og telemetrilogge (*.berg *.bergrun *.bergstudy *.tlog);;Alle filer (*)</translation>
    </message>
</context>
<context>
    <name>berg::ShipRows</name>
    <message>
        <source>Ship that the asset follows</source>
        <translation>Skib, som objektet følger</translation>
    </message>
    <message>
        <source>The asset follows no ship</source>
        <translation>Objektet følger intet skib</translation>
    </message>
    <message>
        <source>Ship with launch and home</source>
        <translation>Skib med start og hjem</translation>
    </message>
    <message>
        <source>Launch and home of the UAVs move with the ship, in the simulation and in uploads. The autopilot&apos;s own home stays where it took off.</source>
        <translation>Start og hjem for UAV&apos;erne flytter sig med skibet, i simuleringen og i uploads. Autopilotens eget hjem bliver, hvor den lettede.</translation>
    </message>
    <message>
        <source>Launch and home are not on a ship</source>
        <translation>Start og hjem er ikke på et skib</translation>
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
            <numerusform>Importér %n isbjerg fra %1</numerusform>
            <numerusform>Importér %n isbjerge fra %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Imported %n icebergs from %1</source>
        <translation>
            <numerusform>Importerede %n isbjerg fra %1</numerusform>
            <numerusform>Importerede %n isbjerge fra %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Import airspace from %1</source>
        <translation>Importér luftrum fra %1</translation>
    </message>
    <message numerus="yes">
        <source>Airspace of %1: %n areas added, %2 already present, %3 farther than 100 km, %4 left out</source>
        <translation>
            <numerusform>Luftrum fra %1: %n område tilføjet, %2 fandtes allerede, %3 længere væk end 100 km, %4 udeladt</numerusform>
            <numerusform>Luftrum fra %1: %n områder tilføjet, %2 fandtes allerede, %3 længere væk end 100 km, %4 udeladt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n areas: a scenario can have at most %1</source>
        <translation>
            <numerusform>%n område: et scenarie kan højst have %1</numerusform>
            <numerusform>%n områder: et scenarie kan højst have %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Airspace cannot be imported in flight. Stop the flight before importing.</source>
        <translation>Luftrum kan ikke importeres under flyvning. Stop flyvningen, før du importerer.</translation>
    </message>
    <message>
        <source>Clipboard</source>
        <translation>Udklipsholder</translation>
    </message>
    <message>
        <source>The flight has continued in the meantime, so nothing was reported.</source>
        <translation>Flyvningen er fortsat i mellemtiden, så intet blev meldt.</translation>
    </message>
    <message numerus="yes">
        <source>Reported %n icebergs from %1</source>
        <translation>
            <numerusform>Meldte %n isbjerg fra %1</numerusform>
            <numerusform>Meldte %n isbjerge fra %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Airspace left out or changed</source>
        <translation>Luftrum udeladt eller ændret</translation>
    </message>
    <message>
        <source>Sightings (*.csv *.txt *.geojson *.json *.kml *.kmz *.czml *.gpx *.plan *.waypoints *.nmea *.jpg *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;All files (*)</source>
        <translation>Observationer (*.csv *.txt *.geojson *.json *.kml *.kmz *.czml *.gpx *.plan *.waypoints *.nmea *.jpg *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Airspace (*.txt *.openair *.air *.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.zip);;All files (*)</source>
        <translation>Luftrum (*.txt *.openair *.air *.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.zip);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Ice charts (*.shp *.zip *.gpkg *.gml *.fgb *.e00 *.geojson *.json);;All files (*)</source>
        <translation>Iskort (*.shp *.zip *.gpkg *.gml *.fgb *.e00 *.geojson *.json);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Ice charts cannot be imported in flight. Stop the flight before importing.</source>
        <translation>Iskort kan ikke importeres under flyvning. Stop flyvningen, før du importerer.</translation>
    </message>
    <message>
        <source>Import ice chart from %1</source>
        <translation>Importer iskort fra %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>ukendt</translation>
    </message>
    <message numerus="yes">
        <source>Ice chart of %1: %n areas, date %2, %3 left out or far away</source>
        <translation>
            <numerusform>Iskort fra %1: %n område, dato %2, %3 udeladt eller langt væk</numerusform>
            <numerusform>Iskort fra %1: %n områder, dato %2, %3 udeladt eller langt væk</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::SolveTimeChart</name>
    <message>
        <source>Solution time against the number of icebergs</source>
        <translation>Løsningstid mod antallet af isbjerge</translation>
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
        <translation>Linje: median. Stiplet: værst. Hul: nogle blev afbrudt.</translation>
    </message>
    <message>
        <source>Number of icebergs</source>
        <translation>Antal isbjerge</translation>
    </message>
    <message>
        <source>CPLEX, worst (paper)</source>
        <translation>CPLEX, værst (artiklen)</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n icebergs</source>
        <translation>
            <numerusform>%1, %n isbjerg</numerusform>
            <numerusform>%1, %n isbjerge</numerusform>
        </translation>
    </message>
    <message>
        <source>median %1, worst %2</source>
        <translation>median %1, værst %2</translation>
    </message>
    <message>
        <source>average %1, worst %2</source>
        <translation>gennemsnit %1, værst %2</translation>
    </message>
    <message>
        <source>proven: %1 of %2</source>
        <translation>bevist: %1 af %2</translation>
    </message>
</context>
<context>
    <name>berg::SolveTimePanel</name>
    <message>
        <source>Proves the optimum by dynamic programming or by the bound of Bergwatch&apos;s engine.</source>
        <translation>Beviser optimum ved dynamisk programmering eller ved Bergwatch-løserens grænse.</translation>
    </message>
    <message>
        <source>Searches, and proves as much as about a second of work allows.</source>
        <translation>Søger, og beviser så meget, som omtrent et sekunds beregning tillader.</translation>
    </message>
    <message>
        <source>COIN-OR CBC on a MILP with a variable for each leg and position. Independent of Bergwatch&apos;s engine.</source>
        <translation>COIN-OR CBC på et MILP med en variabel for hver etape og plads. Uafhængig af Bergwatchs løser.</translation>
    </message>
    <message>
        <source>COIN-OR CBC on the MILP as the paper prints it. Slow beyond 8 icebergs.</source>
        <translation>COIN-OR CBC på MILP&apos;et, som artiklen trykker det. Langsom ud over 8 isbjerge.</translation>
    </message>
    <message>
        <source>COIN-OR CBC on the few legs that the bound of Bergwatch&apos;s engine leaves.</source>
        <translation>COIN-OR CBC på de få etaper, som Bergwatch-løserens grænse lader tilbage.</translation>
    </message>
    <message>
        <source>Icebergs, up to</source>
        <translation>Isbjerge, op til</translation>
    </message>
    <message>
        <source>Largest number of icebergs. The paper went to 20.</source>
        <translation>Største antal isbjerge. Artiklen gik til 20.</translation>
    </message>
    <message>
        <source>Problems of each size</source>
        <translation>Problemer af hver størrelse</translation>
    </message>
    <message>
        <source>Random problems as in Table 1 of the paper, the same at every run.</source>
        <translation>Tilfældige problemer som i artiklens tabel 1, de samme hver gang.</translation>
    </message>
    <message>
        <source>Total time limit</source>
        <translation>Tidsgrænse i alt</translation>
    </message>
    <message>
        <source>A solver that does not finish a size skips the larger ones.</source>
        <translation>En løser, der ikke bliver færdig med en størrelse, springer de større over.</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Målingens fremskridt</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>Gem CSV…</translation>
    </message>
    <message>
        <source>Saves the measured times as a table.</source>
        <translation>Gemmer de målte tider som en tabel.</translation>
    </message>
    <message>
        <source>Measuring, about %1 left</source>
        <translation>Måler, omtrent %1 tilbage</translation>
    </message>
    <message>
        <source>Start measures this machine on the problems of the paper, for comparison with the paper&apos;s times.</source>
        <translation>Start måler denne maskine på artiklens problemer til sammenligning med artiklens tider.</translation>
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
        <translation>Vælg en løser først.</translation>
    </message>
    <message>
        <source>Stopped. The times measured so far are kept.</source>
        <translation>Stoppet. De tider, der er målt indtil nu, er beholdt.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
</context>
<context>
    <name>berg::StartChart</name>
    <message>
        <source>Zeta by start time</source>
        <translation>Zeta efter starttid</translation>
    </message>
    <message>
        <source>Press Compare to fly the scenario from each start time.</source>
        <translation>Tryk på Sammenlign for at flyve scenariet fra hver starttid.</translation>
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
        <translation>Hold øje med drivende isbjerge.</translation>
    </message>
    <message>
        <source>Continue with %1</source>
        <translation>Fortsæt med %1</translation>
    </message>
    <message>
        <source>New scenario</source>
        <translation>Nyt scenarie</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Åbn...</translation>
    </message>
    <message>
        <source>New here? Take the tour, three steps</source>
        <translation>Ny her? Tag rundvisningen, tre trin</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundvisning</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Seneste filer</translation>
    </message>
    <message>
        <source>Show this page at the start</source>
        <translation>Vis denne side ved opstart</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Eksempler</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Ingen filer endnu</translation>
    </message>
    <message>
        <source>Import sightings...</source>
        <translation>Importér observationer...</translation>
    </message>
</context>
<context>
    <name>berg::StartPageController</name>
    <message>
        <source>Untitled</source>
        <translation>Uden navn</translation>
    </message>
    <message>
        <source>1. Place icebergs</source>
        <translation>1. Placér isbjerge</translation>
    </message>
    <message>
        <source>2. Drag τ</source>
        <translation>2. Træk τ</translation>
    </message>
    <message>
        <source>Drag left to visit the most uncertain icebergs first, right for a shorter route. Ticks mark where another order becomes optimal.</source>
        <translation>Træk til venstre for at besøge de mest usikre isbjerge først, til højre for en kortere rute. Mærkerne viser, hvor en anden rækkefølge bliver optimal.</translation>
    </message>
    <message>
        <source>3. Press Space</source>
        <translation>3. Tryk på mellemrum</translation>
    </message>
    <message>
        <source>Press Space to fly and to pause. Drag the time line to look back. Stop and edit returns to the start.</source>
        <translation>Tryk på mellemrum for at flyve og holde pause. Træk tidslinjen for at se tilbage. Stop og redigér går tilbage til starten.</translation>
    </message>
    <message>
        <source>After this tour, press I and click on the map to place an iceberg. Drag it to move it, double-click it to set its drift and the uncertainty of its position. The plan follows at once.</source>
        <translation>Efter denne rundvisning: tryk på I, og klik på kortet for at placere et isbjerg. Træk det for at flytte det, dobbeltklik på det for at sætte dets drift og positionens usikkerhed. Planen følger straks med.</translation>
    </message>
</context>
<context>
    <name>berg::StartPanel</name>
    <message>
        <source>Starts within</source>
        <translation>Starter inden for</translation>
    </message>
    <message>
        <source>Latest start after the start of the scenario</source>
        <translation>Seneste start efter scenariets start</translation>
    </message>
    <message>
        <source>One every</source>
        <translation>Én hver</translation>
    </message>
    <message>
        <source>Progress of the comparison</source>
        <translation>Sammenligningens fremdrift</translation>
    </message>
    <message>
        <source>Use this start</source>
        <translation>Brug denne start</translation>
    </message>
    <message>
        <source>cannot be flown</source>
        <translation>kan ikke flyves</translation>
    </message>
    <message>
        <source>%1 UTC: ζ %2. %3</source>
        <comment>start, zeta, weather</comment>
        <translation>%1 UTC: ζ %2. %3</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuller</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Sammenlign</translation>
    </message>
    <message>
        <source>Flying the scenario from each start…</source>
        <translation>Flyver scenariet fra hver start …</translation>
    </message>
    <message>
        <source>Flying the scenario from each start: %1 of %2</source>
        <comment>starts done, all</comment>
        <translation>Flyver scenariet fra hver start: %1 af %2</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulleret.</translation>
    </message>
    <message>
        <source>The scenario has no start time. Set Start (UTC) in the Inspector.</source>
        <translation>Scenariet har ingen starttid. Angiv Start (UTC) i Egenskaber.</translation>
    </message>
    <message>
        <source>Icebergs drift on unseen until a later start, so their estimates are older.</source>
        <translation>Isfjelde driver videre uden at blive set indtil en senere start, så estimaterne er ældre.</translation>
    </message>
    <message>
        <source>The scenario has changed since. Compare again.</source>
        <translation>Scenariet er ændret siden. Sammenlign igen.</translation>
    </message>
    <message>
        <source>No start has weather within all limits. Choose a bar to see why.</source>
        <translation>Ingen start har vejr inden for alle grænser. Vælg en søjle for at se hvorfor.</translation>
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
        <translation>Viser fundene om scenariet.</translation>
    </message>
    <message>
        <source>%1   %2 E  %3 N</source>
        <comment>place, east and north of the origin</comment>
        <translation>%1   %2 Ø  %3 N</translation>
    </message>
    <message>
        <source>Cursor: %1</source>
        <translation>Markør: %1</translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation>Tilstand: %1</translation>
    </message>
    <message>
        <source>Not changed: %1</source>
        <translation>Ikke ændret: %1</translation>
    </message>
</context>
<context>
    <name>berg::StudyChart</name>
    <message>
        <source>Choose what to fly and press Start, or load a figure from the paper.</source>
        <translation>Vælg, hvad der skal flyves, og tryk på Start, eller indlæs en figur fra artiklen.</translation>
    </message>
    <message>
        <source>This chart compares each setting with a reference, case by case.</source>
        <translation>Dette diagram sammenligner hver indstilling med en reference, tilfælde for tilfælde.</translation>
    </message>
    <message numerus="yes">
        <source>%n cases</source>
        <translation>
            <numerusform>%n tilfælde</numerusform>
            <numerusform>%n tilfælde</numerusform>
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
        <translation>Studier og deres rapporter (*.bergstudy *.json *.html);;Alle filer (*)</translation>
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
        <translation>Gemte %1</translation>
    </message>
    <message>
        <source>Bergwatch ended unexpectedly. This unsaved study was kept. Save it, or fly the rest.</source>
        <translation>Bergwatch sluttede uventet. Dette studie, der ikke var gemt, blev bevaret. Gem det, eller flyv resten.</translation>
    </message>
    <message>
        <source>Autosaving failed: %1</source>
        <translation>Automatisk lagring mislykkedes: %1</translation>
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
        <translation>Flyv som i studiet</translation>
    </message>
    <message>
        <source>Flown as in the study, which is under View, Study.</source>
        <translation>Fløjet som i studiet, der findes under Vis, Studie.</translation>
    </message>
    <message>
        <source>Fly Figure 5 of the paper</source>
        <translation>Flyv figur 5 i artiklen</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Brug %1</translation>
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
        <translation>Som i artiklen</translation>
    </message>
    <message>
        <source>Figure 3</source>
        <translation>Figur 3</translation>
    </message>
    <message>
        <source>Solution times by number of icebergs: opens the solve time study with the sizes of the paper.</source>
        <translation>Løsningstider efter antal isbjerge: åbner studiet af løsningstid med artiklens størrelser.</translation>
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
        <translation>ζ for dette scenarie med τ = 0, 0,1 … 4 og for den korteste vej.</translation>
    </message>
    <message>
        <source>Two flights of this scenario over the map: with the τ of lowest ζ, and along the shortest path.</source>
        <translation>To flyvninger af dette scenarie over kortet: med den τ, der giver lavest ζ, og ad den korteste vej.</translation>
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
        <translation>Reference, som de andre indstillinger sammenlignes med</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Åbn…</translation>
    </message>
    <message>
        <source>Opens a study to view or continue it.</source>
        <translation>Åbner et studie for at se eller fortsætte det.</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Gem…</translation>
    </message>
    <message>
        <source>Saves the study with all flights so far, also while it is running.</source>
        <translation>Gemmer studiet med alle flyvninger indtil nu, også mens det kører.</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Writes a page with pictures, scenarios, seeds, version and machine.</source>
        <translation>Skriver en side med billeder, scenarier, startværdier, version og maskine.</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tabel…</translation>
    </message>
    <message>
        <source>Saves the numbers of all settings as CSV.</source>
        <translation>Gemmer tallene for alle indstillinger som CSV.</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Billede…</translation>
    </message>
    <message>
        <source>Saves the picture in front (PNG, SVG, PDF).</source>
        <translation>Gemmer det forreste billede (PNG, SVG, PDF).</translation>
    </message>
    <message>
        <source>ζ against τ</source>
        <translation>ζ mod τ</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Forskelle</translation>
    </message>
    <message>
        <source>Settings of the study</source>
        <translation>Studiets indstillinger</translation>
    </message>
    <message>
        <source>Cases of the setting chosen</source>
        <translation>Tilfælde for den valgte indstilling</translation>
    </message>
    <message>
        <source>Open this run</source>
        <translation>Åbn denne flyvning</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Indstillinger</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Tilfælde</translation>
    </message>
    <message>
        <source>Cases of %1</source>
        <translation>Tilfælde for %1</translation>
    </message>
    <message>
        <source>Repeats this case exactly and shows it on the map and the time line.</source>
        <translation>Gentager dette tilfælde nøjagtigt og viser det på kortet og tidslinjen.</translation>
    </message>
    <message>
        <source>Choose a point of the picture or a setting, then a case.</source>
        <translation>Vælg et punkt i billedet eller en indstilling, derefter et tilfælde.</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Brug %1</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Brug</translation>
    </message>
    <message>
        <source>Plans the scenario on the map with this setting.</source>
        <translation>Planlægger scenariet på kortet med denne indstilling.</translation>
    </message>
    <message>
        <source>Choose a point of the picture or a setting.</source>
        <translation>Vælg et punkt i billedet eller en indstilling.</translation>
    </message>
    <message>
        <source>Lowest ζ: %1. One case is too few for a recommendation: fly more of them.</source>
        <translation>Laveste ζ: %1. Ét tilfælde er for lidt til en anbefaling: flyv flere.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 og %2 mere</translation>
    </message>
    <message numerus="yes">
        <source>No clear winner over %n cases. These settings may be the best: %1.</source>
        <translation>
            <numerusform>Ingen klar vinder i %n tilfælde. Disse indstillinger kan være bedst: %1.</numerusform>
            <numerusform>Ingen klar vinder i %n tilfælde. Disse indstillinger kan være bedst: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Recommended: %1. Its ζ is %2 (95 %: %3 to %4) against %5, the closest other setting, over %n cases.</source>
        <translation>
            <numerusform>Anbefalet: %1. Dens ζ er %2 (95 %: %3 til %4) mod %5, den nærmeste anden indstilling, i %n tilfælde.</numerusform>
            <numerusform>Anbefalet: %1. Dens ζ er %2 (95 %: %3 til %4) mod %5, den nærmeste anden indstilling, i %n tilfælde.</numerusform>
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
        <translation>Fortsæt</translation>
    </message>
    <message>
        <source>Flies the missing missions of the study shown.</source>
        <translation>Flyver de missioner, der mangler i det viste studie.</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Studiets fremskridt</translation>
    </message>
    <message>
        <source>%1 missions, %2</source>
        <translation>%1 missioner, %2</translation>
    </message>
    <message>
        <source>%1 missions flown.</source>
        <translation>%1 missioner fløjet.</translation>
    </message>
    <message>
        <source>%1 of %2 missions flown.</source>
        <translation>%1 af %2 missioner fløjet.</translation>
    </message>
    <message>
        <source>About %1 left.</source>
        <translation>Omtrent %1 tilbage.</translation>
    </message>
    <message>
        <source>The flights so far are kept.</source>
        <translation>Flyvningerne indtil nu bevares.</translation>
    </message>
    <message>
        <source>Start study</source>
        <translation>Start studie</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
</context>
<context>
    <name>berg::StudySetup</name>
    <message>
        <source>This scenario</source>
        <translation>Dette scenarie</translation>
    </message>
    <message>
        <source>Random scenarios</source>
        <translation>Tilfældige scenarier</translation>
    </message>
    <message>
        <source>Fields of icebergs as in Table 3 of the paper, one for each seed.</source>
        <translation>Felter af isbjerge som i tabel 3 i artiklen, ét for hver startværdi.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Antal</translation>
    </message>
    <message>
        <source>Number of random scenarios.</source>
        <translation>Antal tilfældige scenarier.</translation>
    </message>
    <message>
        <source>First seed</source>
        <translation>Første startværdi</translation>
    </message>
    <message>
        <source>Further scenarios use the seeds that follow.</source>
        <translation>De næste scenarier bruger de startværdier, der følger.</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Isbjerge</translation>
    </message>
    <message>
        <source>Number of icebergs in each random scenario.</source>
        <translation>Antal isbjerge i hvert tilfældigt scenarie.</translation>
    </message>
    <message>
        <source>Runs each</source>
        <translation>Flyvninger af hvert</translation>
    </message>
    <message>
        <source>Flights of each scenario with different noise: the true drift is drawn again, identically for every setting.</source>
        <translation>Flyvninger af hvert scenarie med anden støj: den sande drift trækkes igen, den samme for hver indstilling.</translation>
    </message>
    <message>
        <source>τ from</source>
        <translation>τ fra</translation>
    </message>
    <message>
        <source>Smallest trade-off τ.</source>
        <translation>Mindste afvejning τ.</translation>
    </message>
    <message>
        <source>to</source>
        <comment>largest tau</comment>
        <translation>til</translation>
    </message>
    <message>
        <source>Largest trade-off τ.</source>
        <translation>Største afvejning τ.</translation>
    </message>
    <message>
        <source>step</source>
        <comment>of tau</comment>
        <translation>trin</translation>
    </message>
    <message>
        <source>Step between two values of τ.</source>
        <translation>Trin mellem to værdier af τ.</translation>
    </message>
    <message numerus="yes">
        <source>%n random scenarios</source>
        <translation>
            <numerusform>%n tilfældigt scenarie</numerusform>
            <numerusform>%n tilfældige scenarier</numerusform>
        </translation>
    </message>
    <message>
        <source>This scenario has no icebergs.</source>
        <translation>Dette scenarie har ingen isbjerge.</translation>
    </message>
    <message>
        <source>The largest τ is below the smallest.</source>
        <translation>Den største τ er under den mindste.</translation>
    </message>
    <message>
        <source>Too many values of τ. Choose a larger step.</source>
        <translation>For mange værdier af τ. Vælg et større trin.</translation>
    </message>
    <message>
        <source>Choose at least one policy.</source>
        <translation>Vælg mindst én strategi.</translation>
    </message>
    <message>
        <source>A study has at most %1 missions.</source>
        <translation>Et studie har højst %1 missioner.</translation>
    </message>
    <message>
        <source>Knowledge of the drift in random scenarios, and how icebergs are observed.</source>
        <translation>Kendskabet til driften i tilfældige scenarier, og hvordan isbjerge observeres.</translation>
    </message>
    <message>
        <source>As published</source>
        <translation>Som offentliggjort</translation>
    </message>
    <message>
        <source>Velocities are known, and an iceberg in view has no uncertainty.</source>
        <translation>Hastighederne er kendt, og et isbjerg i synsfeltet har ingen usikkerhed.</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Målt</translation>
    </message>
    <message>
        <source>Measurements with noise, filtered for position and velocity.</source>
        <translation>Målinger med støj, filtreret for position og hastighed.</translation>
    </message>
    <message>
        <source>Unknown velocity</source>
        <translation>Ukendt hastighed</translation>
    </message>
    <message>
        <source>Measured; velocities are uncertain by 0.1 m/s along each axis.</source>
        <translation>Målt; hastighederne er usikre med 0,1 m/s langs hver akse.</translation>
    </message>
    <message>
        <source>Real drift</source>
        <translation>Virkelig drift</translation>
    </message>
    <message>
        <source>Measured; velocities are unknown and change, as observed for icebergs with beacons.</source>
        <translation>Målt; hastighederne er ukendte og ændrer sig, som observeret for isbjerge med bøjer.</translation>
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
        <translation>Planer langs afvejningen τ</translation>
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
        <translation>%1. Nuværende plan: %2</translation>
    </message>
    <message>
        <source>The plans for every τ are being computed.</source>
        <translation>Planerne for hver τ beregnes.</translation>
    </message>
</context>
<context>
    <name>berg::Tour</name>
    <message>
        <source>Skip</source>
        <translation>Spring over</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Tilbage</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 af %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Færdig</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Næste</translation>
    </message>
</context>
<context>
    <name>berg::TradeoffPanel</name>
    <message>
        <source>Trade-off τ</source>
        <translation>Afvejning τ</translation>
    </message>
    <message>
        <source>Trade-off τ from most uncertain first to shortest path</source>
        <translation>Afvejning τ fra mest usikre først til korteste vej</translation>
    </message>
    <message>
        <source>Most uncertain first</source>
        <translation>Mest usikre først</translation>
    </message>
    <message>
        <source>Shortest path</source>
        <translation>Korteste vej</translation>
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
        <translation>Rute</translation>
    </message>
    <message>
        <source>This build of Bergwatch does not include this solver.</source>
        <translation>Denne udgave af Bergwatch indeholder ikke denne løser.</translation>
    </message>
    <message>
        <source>The chosen policy does not use this.</source>
        <translation>Den valgte strategi bruger ikke dette.</translation>
    </message>
    <message>
        <source>Small: the most uncertain icebergs come first. Large: the path gets short. Arrow keys change τ by 0.01, Page keys by 0.25.</source>
        <translation>Lille: de mest usikre isbjerge kommer først. Stor: ruten bliver kort. Piletaster ændrer τ med 0,01, Page-taster med 0,25.</translation>
    </message>
    <message>
        <source>Trade-off τ from 0 to 100.</source>
        <translation>Afvejning τ fra 0 til 100.</translation>
    </message>
    <message>
        <source>Solver of the plan. Automatic proves small problems optimal and searches in large ones.</source>
        <translation>Planens løser. Automatisk beviser små problemer optimale og søger i store.</translation>
    </message>
    <message>
        <source>A one-way plan ends at the last iceberg; a round trip includes the return.</source>
        <translation>En plan for én vej slutter ved det sidste isbjerg; en rundtur omfatter hjemturen.</translation>
    </message>
    <message>
        <source>Locked while looking back. Choose Back to latest or Continue from here to change it.</source>
        <translation>Låst, mens du ser tilbage. Vælg Tilbage til seneste eller Fortsæt herfra for at ændre det.</translation>
    </message>
</context>
<context>
    <name>berg::UnsavedWorkGuard</name>
    <message>
        <source>Untitled</source>
        <translation>Uden navn</translation>
    </message>
    <message>
        <source>Autosaved %1</source>
        <translation>Gemte %1 automatisk</translation>
    </message>
    <message>
        <source>Autosaving failed: %1</source>
        <translation>Automatisk lagring mislykkedes: %1</translation>
    </message>
    <message>
        <source>Unsaved work of a program that ended unexpectedly cannot be read. It is kept in this file:
%1</source>
        <translation>Ikke-gemt arbejde fra et program, der sluttede uventet, kan ikke læses. Det er bevaret i denne fil:
%1</translation>
    </message>
    <message>
        <source>Restored, not saved yet</source>
        <translation>Gendannet, ikke gemt endnu</translation>
    </message>
    <message>
        <source>%1, in flight</source>
        <translation>%1, under flyvning</translation>
    </message>
    <message>
        <source>Reading unsaved work</source>
        <translation>Læser ikke gemt arbejde</translation>
    </message>
</context>
<context>
    <name>berg::ValueTable</name>
    <message>
        <source>Show values as a table</source>
        <translation>Vis værdier som tabel</translation>
    </message>
    <message>
        <source>Values: %1</source>
        <translation>Værdier: %1</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiér</translation>
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
        <translation>&amp;Indstil</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>F&amp;art</translation>
    </message>
    <message>
        <source>Blows &amp;from</source>
        <translation>Blæser &amp;fra</translation>
    </message>
    <message>
        <source>The UAV will make little headway in this wind.</source>
        <translation>Dronen vil næsten ikke komme frem i denne vind.</translation>
    </message>
    <message>
        <source>Must be below the UAV&apos;s airspeed (%1).</source>
        <translation>Skal være under dronens flyvefart (%1).</translation>
    </message>
</context>
<context>
    <name>berg::Workspace</name>
    <message>
        <source>Change trade-off</source>
        <translation>Ændr afvejning</translation>
    </message>
    <message>
        <source>Change policy</source>
        <translation>Ændr strategi</translation>
    </message>
    <message>
        <source>Change solver</source>
        <translation>Ændr løser</translation>
    </message>
    <message>
        <source>Change route</source>
        <translation>Ændr rute</translation>
    </message>
    <message>
        <source>You are viewing an earlier instant. To change this, continue from here or go back to the latest.</source>
        <translation>Du ser på et tidligere øjeblik. Fortsæt herfra, eller gå tilbage til det seneste for at ændre dette.</translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation>Ændr vind</translation>
    </message>
    <message>
        <source>Assign iceberg</source>
        <translation>Tildel isbjerg</translation>
    </message>
    <message>
        <source>The scenario was changed before take-off: nothing was flown.</source>
        <translation>Scenariet blev ændret før start: intet blev fløjet.</translation>
    </message>
    <message>
        <source>Restore flight</source>
        <translation>Hent flyvningen tilbage</translation>
    </message>
    <message>
        <source>Move UAVs to their aircraft</source>
        <translation>Flyt dronerne til deres luftfartøjer</translation>
    </message>
</context>
</TS>
