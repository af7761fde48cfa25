<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>AreaTool</name>
    <message>
        <source>Add area</source>
        <translation>Ajouter une zone</translation>
    </message>
    <message>
        <source>Replace area</source>
        <translation>Remplacer la zone</translation>
    </message>
    <message>
        <source>An area needs at least three corners. Esc cancels the drawing.</source>
        <translation>Une zone a besoin d&apos;au moins trois sommets. Esc annule le tracé.</translation>
    </message>
    <message>
        <source>Click the first corner or press Enter to close the area. Backspace removes a corner, Esc cancels.</source>
        <translation>Cliquez sur le premier sommet ou appuyez sur Entrée pour fermer la zone. Retour arrière retire un sommet, Esc annule.</translation>
    </message>
    <message>
        <source>Click to set the next corner. Backspace removes a corner, Esc cancels.</source>
        <translation>Cliquez pour placer le sommet suivant. Retour arrière retire un sommet, Esc annule.</translation>
    </message>
    <message>
        <source>Drag a corner or the middle of an edge; clicking starts a new area. Esc leaves the tool.</source>
        <translation>Faites glisser un sommet ou le milieu d&apos;un côté ; un clic commence une autre zone. Esc quitte l&apos;outil.</translation>
    </message>
    <message>
        <source>Click to set the first corner of the area. Esc leaves the tool.</source>
        <translation>Cliquez pour placer le premier sommet de la zone. Esc quitte l&apos;outil.</translation>
    </message>
    <message>
        <source>Add no-fly area</source>
        <translation>Ajouter une zone interdite</translation>
    </message>
    <message>
        <source>Click to set the first corner of a no-fly area, or drag a corner or the middle of an edge of an existing one. Esc leaves the tool.</source>
        <translation>Cliquez pour placer le premier sommet d&apos;une zone interdite, ou faites glisser un sommet ou le milieu d&apos;un côté d&apos;une zone existante. Esc quitte l&apos;outil.</translation>
    </message>
</context>
<context>
    <name>AssetText</name>
    <message>
        <source>%1 is inside the inner ring</source>
        <translation>%1 est dans l&apos;anneau intérieur</translation>
    </message>
    <message>
        <source>%1 enters the inner ring in %2</source>
        <translation>%1 entre dans l&apos;anneau intérieur dans %2</translation>
    </message>
</context>
<context>
    <name>BatteryText</name>
    <message>
        <source>about %1 left</source>
        <translation>encore %1 environ</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>encore %1</translation>
    </message>
    <message>
        <source>way home %1</source>
        <translation>retour %1</translation>
    </message>
    <message>
        <source>planned endurance left %1</source>
        <translation>autonomie prévue restante %1</translation>
    </message>
    <message>
        <source>Battery for %1, way home %2</source>
        <translation>Batterie pour %1, retour %2</translation>
    </message>
</context>
<context>
    <name>ChartPageText</name>
    <message>
        <source>Flown until %1</source>
        <translation>Vol effectué jusqu&apos;à %1</translation>
    </message>
    <message>
        <source>Nothing was flown</source>
        <translation>Aucun vol effectué</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>--backends: %1 is none of %2</source>
        <translation>--backends : %1 n&apos;est aucun des suivants : %2</translation>
    </message>
    <message>
        <source>solving</source>
        <translation>résolution</translation>
    </message>
    <message>
        <source>interrupted: the table is incomplete</source>
        <translation>interrompu : le tableau est incomplet</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>avertissement</translation>
    </message>
    <message>
        <source>hint</source>
        <translation>conseil</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>%1 restant</translation>
    </message>
    <message>
        <source>%1: %2 is not a number</source>
        <translation>%1 : %2 n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>interrupted, nothing written</source>
        <translation>interrompu, rien n&apos;a été écrit</translation>
    </message>
    <message>
        <source>proving the curve</source>
        <translation>démonstration de la courbe</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>remarque : %1</translation>
    </message>
    <message>
        <source>--format: %1 is none of %2</source>
        <translation>--format : %1 n&apos;est aucun des suivants : %2</translation>
    </message>
    <message>
        <source>--output: no format has the suffix of %1; choose one with --format: %2</source>
        <translation>--output : aucun format n&apos;a le suffixe de %1 ; choisissez-en un avec --format : %2</translation>
    </message>
    <message>
        <source>--format %1: the program bergwatch paints this format, but it is neither in this folder nor on the PATH</source>
        <translation>--format %1 : le programme bergwatch dessine ce format, mais il n&apos;est ni dans ce dossier ni dans PATH</translation>
    </message>
    <message>
        <source>%1: %2 is not a UTC time such as 2026-05-01T12:00:00Z</source>
        <translation>%1 : %2 n&apos;est pas une heure UTC comme 2026-05-01T12:00:00Z</translation>
    </message>
    <message>
        <source>--area: %1 is not SOUTH,WEST,NORTH,EAST in degrees</source>
        <translation>--area : %1 n&apos;est pas SOUTH,WEST,NORTH,EAST (sud, ouest, nord, est) en degrés</translation>
    </message>
    <message>
        <source>--map: %1 is not FIELD=COLUMN with a field of %2</source>
        <translation>--map : %1 n&apos;est pas FIELD=COLUMN avec un champ parmi %2</translation>
    </message>
    <message>
        <source>--position-error: %1 is neither a number of metres nor one of %2</source>
        <translation>--position-error : %1 n&apos;est ni un nombre de mètres ni l&apos;un des suivants : %2</translation>
    </message>
    <message>
        <source>--with-tracks needs --at: tracks consist of the sightings after that time</source>
        <translation>--with-tracks a besoin de --at : les traces se composent des observations postérieures à cet instant</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 de plus</translation>
    </message>
    <message>
        <source>and %1 more notes about icebergs</source>
        <translation>et %1 remarques de plus sur des icebergs</translation>
    </message>
    <message>
        <source>the MPI processes have different options</source>
        <translation>les processus MPI ont des options différentes</translation>
    </message>
    <message>
        <source>%1 is none of %2</source>
        <translation>%1 n&apos;est aucun des suivants : %2</translation>
    </message>
    <message>
        <source>%1 is not a whole number from %2 to %3</source>
        <translation>%1 n&apos;est pas un nombre entier de %2 à %3</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>%1 is an input of this command; name another file</source>
        <translation>%1 est une entrée de cette commande : nommez un autre fichier</translation>
    </message>
    <message>
        <source>%1 is an input of this command (%2); name another file</source>
        <translation>%1 est une entrée de cette commande (%2) : nommez un autre fichier</translation>
    </message>
    <message>
        <source>%1 is already the file of %2; name another file</source>
        <translation>%1 est déjà le fichier de %2 : nommez un autre fichier</translation>
    </message>
    <message>
        <source>%1 and --json both need standard output</source>
        <translation>%1 et --json ont tous deux besoin de la sortie standard</translation>
    </message>
    <message>
        <source>%1 exists; use --force to overwrite it</source>
        <translation>%1 existe ; utilisez --force pour l&apos;écraser</translation>
    </message>
    <message>
        <source>%1: %2 and %3 contradict each other. One of the two is wrong; do not use this order.</source>
        <translation>%1 : %2 et %3 se contredisent. L&apos;un des deux est faux ; n&apos;utilisez pas cet ordre.</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>il n&apos;y a pas assez de mémoire</translation>
    </message>
    <message>
        <source>This is a planning problem: use &apos;solve&apos;.</source>
        <translation>Ceci est un problème de planification : utilisez « solve ».</translation>
    </message>
    <message>
        <source>This is a scenario: use &apos;plan&apos;, &apos;simulate&apos; or &apos;export&apos;.</source>
        <translation>Ceci est un scénario : utilisez « plan », « simulate » ou « export ».</translation>
    </message>
    <message>
        <source>This is a run: use &apos;simulate&apos; or &apos;export&apos;.</source>
        <translation>Ceci est un vol : utilisez « simulate » ou « export ».</translation>
    </message>
    <message>
        <source>This is a study: use &apos;study&apos;.</source>
        <translation>Ceci est une étude : utilisez « study ».</translation>
    </message>
    <message>
        <source>Name the columns of a table: --map latitude=COLUMN --map longitude=COLUMN.</source>
        <translation>Nommez les colonnes d&apos;un tableau : --map latitude=COLUMN --map longitude=COLUMN.</translation>
    </message>
    <message>
        <source>This is not a Bergwatch file. To read sightings, use &apos;import&apos;.</source>
        <translation>Ce n&apos;est pas un fichier de Bergwatch. Pour lire des observations, utilisez « import ».</translation>
    </message>
    <message>
        <source>there is no completion script for %1</source>
        <translation>il n&apos;y a pas de script de complétion pour %1</translation>
    </message>
    <message>
        <source>Try &apos;%1 --help&apos;.</source>
        <translation>Essayez « %1 --help ».</translation>
    </message>
    <message>
        <source>took %1 s of processor time and %2 MB of memory</source>
        <translation>a pris %1 s de temps de calcul et %2 Mo de mémoire</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 est vide</translation>
    </message>
    <message>
        <source>flying</source>
        <translation>vol en cours</translation>
    </message>
    <message>
        <source>a run file is replayed exactly as flown; --tau, --policy, --duration, --dt, --seed and --no-noise apply to scenarios only</source>
        <translation>un fichier de vol est rejoué exactement comme il a été effectué ; --tau, --policy, --duration, --dt, --seed et --no-noise ne valent que pour les scénarios</translation>
    </message>
    <message>
        <source>replaying</source>
        <translation>relecture</translation>
    </message>
    <message>
        <source>--bound does not apply to runs with reported sightings</source>
        <translation>--bound ne s&apos;applique pas aux vols avec des observations signalées</translation>
    </message>
    <message>
        <source>--bound does not apply to runs in which the wind changed</source>
        <translation>--bound ne s&apos;applique pas aux vols où le vent a changé</translation>
    </message>
    <message>
        <source>bounding</source>
        <translation>recherche de la borne inférieure</translation>
    </message>
    <message>
        <source>interrupted: the flight is complete, but its lower bound is missing</source>
        <translation>interrompu : le vol est complet, mais sa borne inférieure manque</translation>
    </message>
    <message>
        <source>incomplete: %1 of %2 missions are flown; the results use only cases with all settings</source>
        <translation>incomplet : %1 missions sur %2 ont été effectuées ; les résultats n&apos;utilisent que les cas avec tous les réglages</translation>
    </message>
    <message>
        <source>--reference: %1 is not POLICY[:TAU] with one of %2</source>
        <translation>--reference : %1 n&apos;est pas POLICY[:TAU] avec l&apos;un des suivants : %2</translation>
    </message>
    <message>
        <source>--reference: this study does not contain %1</source>
        <translation>--reference : cette étude ne contient pas %1</translation>
    </message>
    <message>
        <source>--tau: %1 is not A:B:STEP with 0 &lt;= A &lt;= B &lt;= 100</source>
        <translation>--tau : %1 n&apos;est pas A:B:STEP avec 0 &lt;= A &lt;= B &lt;= 100</translation>
    </message>
    <message>
        <source>--tau: with %1 there are more than %2 values</source>
        <translation>--tau : avec %1, il y a plus de %2 valeurs</translation>
    </message>
    <message>
        <source>--policies: %1 is none of %2</source>
        <translation>--policies : %1 n&apos;est aucun des suivants : %2</translation>
    </message>
    <message>
        <source>--regime needs --random N; scenario files define their own drift</source>
        <translation>--regime a besoin de --random N ; les fichiers de scénario définissent leur propre dérive</translation>
    </message>
    <message>
        <source>name scenarios, or use --random N</source>
        <translation>nommez des scénarios ou donnez --random N</translation>
    </message>
    <message>
        <source>--shard: %1 is not I/N with 1 &lt;= I &lt;= N</source>
        <translation>--shard : %1 n&apos;est pas I/N avec 1 &lt;= I &lt;= N</translation>
    </message>
    <message>
        <source>--shard needs --study FILE, in which the part is stored</source>
        <translation>--shard a besoin de --study FILE, où la partie est conservée</translation>
    </message>
    <message>
        <source>--shard: to write tables and reports of all shards, use &apos;study&apos;</source>
        <translation>--shard : pour écrire les tableaux et rapports de toutes les parties, utilisez « study »</translation>
    </message>
    <message>
        <source>--replace-study needs --study FILE</source>
        <translation>--replace-study a besoin de --study FILE</translation>
    </message>
    <message>
        <source>flying %1 missions</source>
        <translation>%1 missions en cours</translation>
    </message>
    <message>
        <source>interrupted: %1 of %2 missions are stored in %3; repeat the command to continue</source>
        <translation>interrompu : %1 missions sur %2 sont conservées dans %3 ; répétez la commande pour continuer</translation>
    </message>
    <message>
        <source>there is no option &apos;%1&apos;</source>
        <translation>il n&apos;y a pas d&apos;option « %1 »</translation>
    </message>
    <message>
        <source>there is no option &apos;%1&apos;; did you mean &apos;%2&apos;?</source>
        <translation>il n&apos;y a pas d&apos;option « %1 » ; vouliez-vous dire « %2 » ?</translation>
    </message>
    <message>
        <source>there is no command &apos;%1&apos;</source>
        <translation>il n&apos;y a pas de commande « %1 »</translation>
    </message>
    <message>
        <source>there is no command &apos;%1&apos;; did you mean &apos;%2&apos;?</source>
        <translation>il n&apos;y a pas de commande « %1 » ; vouliez-vous dire « %2 » ?</translation>
    </message>
    <message>
        <source>a command is required</source>
        <translation>une commande est obligatoire</translation>
    </message>
    <message>
        <source>%1 needs a value</source>
        <translation>%1 a besoin d&apos;une valeur</translation>
    </message>
    <message>
        <source>%1 is given more than once</source>
        <translation>%1 est donné plus d&apos;une fois</translation>
    </message>
    <message>
        <source>not expected: %1</source>
        <translation>inattendu : %1</translation>
    </message>
    <message>
        <source>%1 is required</source>
        <translation>%1 est obligatoire</translation>
    </message>
    <message>
        <source>%1 is airspace; use --format airspace with --into SCENARIO</source>
        <translation>%1 est un fichier d&apos;espace aérien : utilisez --format airspace avec --into SCENARIO</translation>
    </message>
    <message>
        <source>%1 excludes %2</source>
        <translation>%1 exclut %2</translation>
    </message>
    <message>
        <source>--bound does not apply to runs from which an iceberg was removed</source>
        <translation>--bound ne s&apos;applique pas aux vols dont un iceberg a été retiré</translation>
    </message>
    <message>
        <source>--output: this format writes one file per UAV; choose a UAV with --uav</source>
        <translation>--output : ce format écrit un fichier par drone ; choisissez un drone avec --uav</translation>
    </message>
    <message>
        <source>%1: &apos;-&apos; is not possible here; give a file name</source>
        <translation>%1 : « - » n&apos;est pas possible ici : donnez un nom</translation>
    </message>
    <message>
        <source>--map: %1 is mapped twice</source>
        <translation>--map : %1 est associé deux fois</translation>
    </message>
    <message>
        <source>feature %1</source>
        <translation>entité %1</translation>
    </message>
    <message>
        <source>packet %1</source>
        <translation>paquet %1</translation>
    </message>
    <message>
        <source>--dt, --duration: the time step is longer than the duration</source>
        <translation>--dt, --duration : le pas de temps est plus long que la durée</translation>
    </message>
    <message>
        <source>--first-seed needs --random N; scenario files have their own seeds</source>
        <translation>--first-seed a besoin de --random N ; les fichiers de scénario ont leurs propres graines</translation>
    </message>
    <message>
        <source>%1 sightings are too far from the origin of the scenario, %2; import them without --into, or choose others with --area</source>
        <translation>%1 observations sont trop loin de l&apos;origine du scénario, %2 : importez-les sans --into, ou choisissez-en d&apos;autres par --area</translation>
    </message>
    <message>
        <source>%1 sightings are too far from the origin, %2, which lies in their densest group; choose others with --area</source>
        <translation>%1 observations sont trop loin de l&apos;origine, %2, qui est dans leur groupe le plus dense : choisissez-en d&apos;autres par --area</translation>
    </message>
    <message>
        <source>%1: %2 is not a position such as 64.51N,59.80W</source>
        <translation>%1 : %2 n&apos;est pas une position telle que 64.51N,59.80W</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>vent</translation>
    </message>
    <message>
        <source>gust</source>
        <translation>rafales</translation>
    </message>
    <message>
        <source>air temperature</source>
        <translation>température de l&apos;air</translation>
    </message>
    <message>
        <source>fog</source>
        <translation>brouillard</translation>
    </message>
    <message>
        <source>current</source>
        <translation>courant</translation>
    </message>
    <message>
        <source>issued %1 h before %2; get a newer forecast</source>
        <translation>émise %1 h avant %2 ; obtenez une prévision plus récente</translation>
    </message>
    <message>
        <source>is for a place %1 km away</source>
        <translation>concerne un lieu à %1 km de là</translation>
    </message>
    <message>
        <source>%1: no values between %2 and %3</source>
        <translation>%1 : aucune valeur entre %2 et %3</translation>
    </message>
    <message>
        <source>--since, --until: the forecast is from %1 to %2</source>
        <translation>--since, --until : la prévision va de %1 à %2</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 exige %2</translation>
    </message>
    <message>
        <source>the forecasts hold no wind: add one that does, or give %1</source>
        <translation>les prévisions ne contiennent pas de vent : ajoutez-en une qui en contient, ou donnez %1</translation>
    </message>
    <message>
        <source>the forecasts hold no current: add one that does, or give %1</source>
        <translation>les prévisions ne contiennent pas de courant : ajoutez-en une qui en contient, ou donnez %1</translation>
    </message>
    <message>
        <source>--at: wind and current are not both known then; the forecast is from %1 to %2</source>
        <translation>--at : le vent ou le courant n&apos;est pas connu à cet instant ; la prévision va de %1 à %2</translation>
    </message>
    <message>
        <source>wind and current are known for %1 h only</source>
        <translation>le vent et le courant ne sont connus que pendant %1 h</translation>
    </message>
    <message>
        <source>--latitude is required: growlers and bergy bits drift to the right of the wind in the north, to the left in the south</source>
        <translation>--latitude est requis : les bourguignons et les fragments d&apos;iceberg dérivent à droite du vent au nord, à gauche au sud</translation>
    </message>
    <message>
        <source>%1 can be reached from the network; MAVLink is neither encrypted nor signed</source>
        <translation>%1 est accessible depuis le réseau ; MAVLink n&apos;est ni chiffré ni signé</translation>
    </message>
    <message>
        <source>%1 ends here: it has 1 GiB</source>
        <translation>%1 s&apos;arrête ici : il fait 1 Gio</translation>
    </message>
    <message>
        <source>the link is broken: %1</source>
        <translation>la liaison est rompue : %1</translation>
    </message>
    <message>
        <source>the link is open again</source>
        <translation>la liaison est rétablie</translation>
    </message>
    <message>
        <source>packets from %1, which is not part of the link, are ignored</source>
        <translation>les paquets de %1, qui ne fait pas partie de la liaison, sont ignorés</translation>
    </message>
    <message>
        <source>%1 is no telemetry log</source>
        <translation>%1 n&apos;est pas un journal de télémétrie</translation>
    </message>
    <message>
        <source>--uav: choose one; a link has at most %1 vehicles</source>
        <translation>--uav : choisissez-en un ; une liaison compte au plus %1 véhicules</translation>
    </message>
    <message>
        <source>A forecast is the JSON reply of MET Norway&apos;s locationforecast or oceanforecast, NetCDF or GRIB.</source>
        <translation>Une prévision est la réponse JSON de locationforecast ou d&apos;oceanforecast de MET Norway, NetCDF ou GRIB.</translation>
    </message>
    <message>
        <source>dew point</source>
        <translation>point de rosée</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>visibilité</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>plafond nuageux</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>the grid is too large and was thinned by a factor of %1 in each direction; choose a smaller area or time</source>
        <translation>la grille est trop grande et a été réduite d&apos;un facteur %1 dans chaque direction ; choisissez une zone ou une période plus petite</translation>
    </message>
    <message>
        <source>--format forecast needs --into, the scenario to add it to</source>
        <translation>--format forecast a besoin de --into, le scénario auquel il est ajouté</translation>
    </message>
    <message>
        <source>--format forecast accepts only --into, --at, --replace, --output, --force and --json</source>
        <translation>--format forecast n&apos;accepte que --into, --at, --replace, --output, --force et --json</translation>
    </message>
    <message>
        <source>%1 is a forecast; use --format forecast with --into SCENARIO</source>
        <translation>%1 est une prévision : utilisez --format forecast avec --into SCENARIO</translation>
    </message>
    <message>
        <source>photograph %1</source>
        <translation>photographie %1</translation>
    </message>
    <message>
        <source>--run is about photographs only</source>
        <translation>--run ne concerne que les photographies</translation>
    </message>
    <message>
        <source>--format: %1 has one file, not photographs</source>
        <translation>--format : %1 a un seul fichier, pas de photographies</translation>
    </message>
    <message>
        <source>--uav: the run has no UAV %1</source>
        <translation>--uav : le vol n&apos;a pas de drone %1</translation>
    </message>
    <message>
        <source>--format %1 needs --into, the scenario to add it to</source>
        <translation>--format %1 a besoin de --into, le scénario auquel il est ajouté</translation>
    </message>
    <message>
        <source>--format %1 accepts only --into, --output, --force and --json</source>
        <translation>--format %1 n&apos;accepte que --into, --output, --force et --json</translation>
    </message>
    <message>
        <source>%1 is an ice chart; use --into SCENARIO</source>
        <translation>%1 est une carte des glaces : utilisez --into SCENARIO</translation>
    </message>
    <message>
        <source>--hours, --every: more than %1 points</source>
        <translation>--hours, --every : plus de %1 points</translation>
    </message>
    <message>
        <source>--hours, --every: more than %1 starts</source>
        <translation>--hours, --every : plus de %1 départs</translation>
    </message>
    <message>
        <source>%1 is aground from hour %2 on</source>
        <translation>%1 est échoué à partir de l&apos;heure %2</translation>
    </message>
    <message>
        <source>the forecast gives wind and current for %1 h only</source>
        <translation>la prévision ne donne le vent et le courant que pour %1 h</translation>
    </message>
</context>
<context>
    <name>ComparedRunText</name>
    <message>
        <source>%1, changed in flight, to %2</source>
        <translation>%1, modifié en vol, jusqu&apos;à %2</translation>
    </message>
    <message>
        <source>%1, changed in flight</source>
        <translation>%1, modifié en vol</translation>
    </message>
    <message>
        <source>%1, to %2</source>
        <translation>%1, jusqu&apos;à %2</translation>
    </message>
</context>
<context>
    <name>ComparisonChartText</name>
    <message>
        <source>The same ζ</source>
        <translation>Même ζ</translation>
    </message>
    <message>
        <source>%1 ahead by %2 %</source>
        <translation>%1 en avance de %2 %</translation>
    </message>
    <message>
        <source>%1 and %2: the same ζ</source>
        <translation>%1 et %2 : même ζ</translation>
    </message>
    <message>
        <source>%1 is ahead: %2 has %3 % more ζ</source>
        <translation>%1 est en avance : %2 a %3 % de ζ en plus</translation>
    </message>
    <message>
        <source>%1 is ahead: it has %3 % less ζ than %2</source>
        <translation>%1 est en avance, avec %3 % de ζ en moins que %2</translation>
    </message>
</context>
<context>
    <name>ComparisonText</name>
    <message>
        <source>Zeta ζ, m² s</source>
        <translation>Zêta ζ, m² s</translation>
    </message>
    <message>
        <source>Accumulated uncertainty, Eq. (24): less is better.</source>
        <translation>Incertitude cumulée, éq. (24) : une valeur plus faible est meilleure.</translation>
    </message>
    <message>
        <source>Mean Σσ, m²</source>
        <translation>Σσ moyen, m²</translation>
    </message>
    <message>
        <source>Mean total uncertainty of all icebergs: ζ divided by the flown time.</source>
        <translation>Incertitude totale moyenne de tous les icebergs : ζ divisé par le temps de vol.</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Visites</translation>
    </message>
    <message>
        <source>Plans</source>
        <translation>Plans</translation>
    </message>
    <message>
        <source>Number of plans made.</source>
        <translation>Nombre de plans établis.</translation>
    </message>
    <message>
        <source>Distance flown through the air.</source>
        <translation>Distance parcourue dans l&apos;air.</translation>
    </message>
    <message>
        <source>Longest unseen</source>
        <translation>Non vu, max.</translation>
    </message>
    <message>
        <source>Longest time for which an iceberg was out of view.</source>
        <translation>Durée la plus longue pendant laquelle un iceberg était hors de vue.</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Iceberg</translation>
    </message>
    <message>
        <source>The iceberg that was out of view for the longest time.</source>
        <translation>Iceberg resté le plus longtemps hors de vue.</translation>
    </message>
    <message>
        <source>Unseen for %1 in total in A.</source>
        <translation>Non vu pendant %1 au total dans A.</translation>
    </message>
    <message>
        <source>Flown, %1</source>
        <translation>Parcouru, %1</translation>
    </message>
    <message>
        <source>%1, visits</source>
        <translation>%1, visites</translation>
    </message>
    <message>
        <source>Icebergs that %1 reached.</source>
        <translation>Icebergs que %1 a atteints.</translation>
    </message>
    <message>
        <source>Distance that %1 has flown through the air.</source>
        <translation>Distance que %1 a parcourue dans l&apos;air.</translation>
    </message>
    <message>
        <source>Icebergs reached as targets.</source>
        <translation>Icebergs atteints comme cibles.</translation>
    </message>
</context>
<context>
    <name>CurveText</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>τ %1: whole order %2, proven optimal</source>
        <translation>τ %1 : ordre entier %2, optimalité prouvée</translation>
    </message>
    <message>
        <source>τ %1: whole order %2, not proven</source>
        <translation>τ %1 : ordre entier %2, non prouvé</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>Save the changes to &quot;%1&quot;?</source>
        <translation>Enregistrer les modifications de « %1 » ?</translation>
    </message>
    <message>
        <source>Your changes will be lost if you don&apos;t save them.</source>
        <translation>Vos modifications seront perdues si vous ne les enregistrez pas.</translation>
    </message>
    <message>
        <source>Your changes will be lost if you don&apos;t save them. The flight in progress ends unless you cancel.</source>
        <translation>Vos modifications seront perdues si vous ne les enregistrez pas. Le vol en cours prendra fin, sauf si vous annulez.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Bergwatch</source>
        <translation>Bergwatch</translation>
    </message>
    <message>
        <source>File in use</source>
        <translation>Fichier déjà ouvert</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another window.</source>
        <translation>« %1 » est ouvert dans une autre fenêtre.</translation>
    </message>
    <message>
        <source>%1 has it open. You can open a copy and save it under another name. If both windows save to this file, the last one wins.</source>
        <translation>%1 l&apos;a ouvert. Vous pouvez ouvrir une copie et l&apos;enregistrer sous un autre nom. Si les deux fenêtres enregistrent dans ce fichier, la dernière l&apos;emporte.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Ouvrir une copie</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Ouvrir quand même</translation>
    </message>
    <message>
        <source>Overwrite the file?</source>
        <translation>Remplacer le fichier ?</translation>
    </message>
    <message>
        <source>Overwrite &quot;%1&quot;?</source>
        <translation>Remplacer « %1 » ?</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>File changed</source>
        <translation>Fichier modifié</translation>
    </message>
    <message>
        <source>Another program has changed &quot;%1&quot;.</source>
        <translation>Un autre programme a modifié « %1 ».</translation>
    </message>
    <message>
        <source>You have no unsaved changes.</source>
        <translation>Vous n&apos;avez aucune modification non enregistrée.</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>Rouvrir le fichier</translation>
    </message>
    <message>
        <source>Keep what I see</source>
        <translation>Garder ce qui est affiché</translation>
    </message>
    <message>
        <source>Flight under way</source>
        <translation>Vol en cours</translation>
    </message>
    <message>
        <source>A flight has started in the meantime. End it?</source>
        <translation>Un vol a commencé entre-temps. Y mettre fin ?</translation>
    </message>
    <message>
        <source>A flight is in progress. End it?</source>
        <translation>Un vol est en cours. Y mettre fin ?</translation>
    </message>
    <message>
        <source>The scenario can only be changed when no flight is in progress. The flight stays in the list of runs.</source>
        <translation>Le scénario ne peut être modifié que lorsqu&apos;aucun vol n&apos;est en cours. Le vol reste dans la liste des vols.</translation>
    </message>
    <message>
        <source>What has been flown so far stays in the list of runs.</source>
        <translation>La partie déjà effectuée reste dans la liste des vols.</translation>
    </message>
    <message>
        <source>End the flight</source>
        <translation>Mettre fin au vol</translation>
    </message>
    <message>
        <source>Continue flight</source>
        <translation>Poursuivre le vol</translation>
    </message>
    <message>
        <source>Unsaved run</source>
        <translation>Vol non enregistré</translation>
    </message>
    <message>
        <source>Save the run?</source>
        <translation>Enregistrer le vol ?</translation>
    </message>
    <message>
        <source>The flight will be lost if you don&apos;t save it.</source>
        <translation>Le vol sera perdu si vous ne l&apos;enregistrez pas.</translation>
    </message>
    <message>
        <source>Save the run before the flight ends?</source>
        <translation>Enregistrer le vol avant qu&apos;il ne se termine ?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Abandonner</translation>
    </message>
    <message>
        <source>&amp;Save run...</source>
        <translation>&amp;Enregistrer le vol...</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Remove icebergs</source>
        <translation>Retirer des icebergs</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n icebergs from this run?</source>
        <translation>
            <numerusform>Retirer %n iceberg de ce vol ?</numerusform>
            <numerusform>Retirer %n icebergs de ce vol ?</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>Magnetic declination</source>
        <translation>Déclinaison magnétique</translation>
    </message>
    <message>
        <source>Degrees from true to magnetic north, positive east, negative west:</source>
        <translation>Degrés du nord vrai au nord magnétique, positifs vers l&apos;est, négatifs vers l&apos;ouest :</translation>
    </message>
    <message>
        <source>%1: the UAV will not visit them any more.</source>
        <translation>%1 : le drone ne les visite plus.</translation>
    </message>
    <message>
        <source>Undo in flight</source>
        <translation>Annuler en vol</translation>
    </message>
    <message>
        <source>Undo &quot;%1&quot; of %2?</source>
        <translation>Annuler « %1 » de %2 ?</translation>
    </message>
    <message>
        <source>The flight goes back to that time and continues without the change. The flight since then is discarded; &quot;Restore&quot; brings it back.</source>
        <translation>Le vol revient à cet instant et continue sans la modification. Le vol effectué depuis est abandonné ; « Rétablir le vol » le ramène.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
</context>
<context>
    <name>DriftArrow</name>
    <message>
        <source>The arrow shows the drift over %1. Shift snaps to steps of %2°; Esc cancels.</source>
        <translation>La flèche montre la dérive sur %1. Maj impose des pas de %2° ; Esc annule.</translation>
    </message>
    <message>
        <source>Heading %1</source>
        <translation>Cap %1</translation>
    </message>
</context>
<context>
    <name>DriftTracksText</name>
    <message>
        <source>+%1 h</source>
        <translation>+%1 h</translation>
    </message>
</context>
<context>
    <name>ErrorText</name>
    <message>
        <source>There is no such file. Check the name and the folder.</source>
        <translation>Ce fichier n&apos;existe pas. Vérifiez le nom et le dossier.</translation>
    </message>
    <message>
        <source>The file cannot be read. Check that it is a file and that you have permission to read it.</source>
        <translation>Le fichier ne peut pas être lu. Vérifiez qu&apos;il s&apos;agit d&apos;un fichier et que vous avez le droit de le lire.</translation>
    </message>
    <message>
        <source>The file cannot be written. Check that the folder exists, that you have permission to write there and that the disk is not full.</source>
        <translation>Le fichier ne peut pas être écrit. Vérifiez que le dossier existe, que vous avez le droit d&apos;y écrire et que le disque n&apos;est pas plein.</translation>
    </message>
    <message>
        <source>The file is too large for a Bergwatch file.</source>
        <translation>Le fichier est trop volumineux pour être un fichier de Bergwatch.</translation>
    </message>
    <message>
        <source>This is not a Bergwatch file, or it is damaged at the place named.</source>
        <translation>Ce n&apos;est pas un fichier Bergwatch, ou il est endommagé à l&apos;endroit indiqué.</translation>
    </message>
    <message>
        <source>This file is of a different type than expected here.</source>
        <translation>Le fichier n&apos;est pas du type attendu ici.</translation>
    </message>
    <message>
        <source>The file was made by a newer version of Bergwatch. Update the program to open it.</source>
        <translation>Le fichier provient d&apos;une version plus récente de Bergwatch. Mettez le programme à jour pour l&apos;ouvrir.</translation>
    </message>
    <message>
        <source>These values are not valid. Correct them and try again.</source>
        <translation>Ces valeurs ne sont pas valides. Corrigez-les et réessayez.</translation>
    </message>
    <message>
        <source>This version of Bergwatch cannot do that.</source>
        <translation>Cette version de Bergwatch ne peut pas le faire.</translation>
    </message>
    <message>
        <source>The planner failed. Choose another solver.</source>
        <translation>Le planificateur a échoué. Choisissez un autre solveur.</translation>
    </message>
    <message>
        <source>The replay of the run differs from the recording. The file may come from another version of Bergwatch.</source>
        <translation>La relecture du vol diffère de l&apos;enregistrement. Le fichier provient peut-être d&apos;une autre version de Bergwatch.</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… et %n de plus</numerusform>
            <numerusform>… et %n de plus</numerusform>
        </translation>
    </message>
    <message>
        <source>The file is too large to be imported. Split it, or leave out what is not needed.</source>
        <translation>Le fichier est trop volumineux pour être importé. Divisez-le ou omettez ce qui n&apos;est pas nécessaire.</translation>
    </message>
    <message>
        <source>The file is broken. Correct it at the place named, or export it again.</source>
        <translation>Le fichier est endommagé. Corrigez-le à l&apos;endroit indiqué ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>Bergwatch does not recognise this file. If it is a table, choose its latitude and longitude columns below.</source>
        <translation>Bergwatch ne reconnaît pas ce fichier. Si c&apos;est un tableau, choisissez ci-dessous ses colonnes de latitude et de longitude.</translation>
    </message>
    <message>
        <source>Nothing of it can be used like this.</source>
        <translation>Rien n&apos;y est utilisable tel quel.</translation>
    </message>
</context>
<context>
    <name>EventText</name>
    <message>
        <source>Planned: next %1</source>
        <translation>Plan établi : %1 ensuite</translation>
    </message>
    <message>
        <source>%1 reached</source>
        <translation>%1 atteint</translation>
    </message>
    <message>
        <source>%1 in view</source>
        <translation>%1 en vue</translation>
    </message>
    <message>
        <source>%1 appeared</source>
        <translation>%1 est apparu</translation>
    </message>
    <message>
        <source>take-off</source>
        <translation>décollage</translation>
    </message>
    <message>
        <source>iceberg reached</source>
        <translation>iceberg atteint</translation>
    </message>
    <message>
        <source>iceberg out of view again</source>
        <translation>iceberg de nouveau hors de vue</translation>
    </message>
    <message>
        <source>new iceberg</source>
        <translation>nouvel iceberg</translation>
    </message>
    <message>
        <source>changed in flight</source>
        <translation>modifié en vol</translation>
    </message>
    <message>
        <source>%1 reported seen</source>
        <translation>%1 signalé vu</translation>
    </message>
    <message>
        <source>iceberg sighted en route</source>
        <translation>iceberg observé en route</translation>
    </message>
    <message>
        <source>sighting overdue</source>
        <translation>observation en retard</translation>
    </message>
    <message>
        <source>The planner failed: continuing with the previous plan</source>
        <translation>Le planificateur a échoué : poursuite du plan précédent</translation>
    </message>
    <message>
        <source>Wind changed</source>
        <translation>Le vent a changé</translation>
    </message>
    <message>
        <source>The protected asset has changed</source>
        <translation>Le bien protégé a changé</translation>
    </message>
    <message>
        <source>%1 has left the area</source>
        <translation>%1 a quitté la zone</translation>
    </message>
    <message>
        <source>%1 is lost: not where it should be</source>
        <translation>%1 est perdu : il n&apos;est pas à l&apos;endroit prévu</translation>
    </message>
    <message>
        <source>%1 found again</source>
        <translation>%1 retrouvé</translation>
    </message>
    <message>
        <source>Search for %1 given up</source>
        <translation>Recherche de %1 abandonnée</translation>
    </message>
    <message>
        <source>Returning home</source>
        <translation>Retour à la base</translation>
    </message>
    <message>
        <source>Landed</source>
        <translation>Atterrissage</translation>
    </message>
    <message>
        <source>Took off</source>
        <translation>Décollage</translation>
    </message>
    <message>
        <source>iceberg left the area</source>
        <translation>iceberg sorti de la zone</translation>
    </message>
    <message>
        <source>iceberg lost</source>
        <translation>iceberg perdu</translation>
    </message>
    <message>
        <source>lost iceberg found</source>
        <translation>iceberg perdu retrouvé</translation>
    </message>
    <message>
        <source>search given up</source>
        <translation>recherche abandonnée</translation>
    </message>
    <message>
        <source>next sortie</source>
        <translation>sortie suivante</translation>
    </message>
    <message>
        <source>Any UAV may visit %1</source>
        <translation>N&apos;importe quel drone peut visiter %1</translation>
    </message>
    <message>
        <source>%1 and %2 are %3 apart</source>
        <translation>%1 et %2 sont distants de %3</translation>
    </message>
    <message>
        <source>%1 has nothing to visit: circling</source>
        <translation>%1 n&apos;a rien à visiter : vol d&apos;attente</translation>
    </message>
    <message>
        <source>%1 flies to %2 next</source>
        <translation>%1 va ensuite vers %2</translation>
    </message>
    <message>
        <source>seen by another UAV</source>
        <translation>vu par un autre drone</translation>
    </message>
    <message>
        <source>another UAV needed a plan</source>
        <translation>un autre drone avait besoin d&apos;un plan</translation>
    </message>
    <message>
        <source>Outside the geofence</source>
        <translation>Hors de la barrière virtuelle</translation>
    </message>
    <message>
        <source>Back inside the geofence</source>
        <translation>De retour dans la barrière virtuelle</translation>
    </message>
    <message>
        <source>Told to resume</source>
        <translation>Ordre reçu : reprendre</translation>
    </message>
    <message>
        <source>Told to return now</source>
        <translation>Ordre reçu : rentrer maintenant</translation>
    </message>
    <message>
        <source>Told to hold here</source>
        <translation>Ordre reçu : attendre ici</translation>
    </message>
    <message>
        <source>Home cannot be reached in time</source>
        <translation>La base ne peut pas être atteinte à temps</translation>
    </message>
    <message>
        <source>end of hold</source>
        <translation>fin de l&apos;attente</translation>
    </message>
    <message>
        <source>Planned from now on by: %2</source>
        <translation>Planifié désormais par : %2</translation>
    </message>
    <message>
        <source>%1 removed</source>
        <translation>%1 retiré</translation>
    </message>
    <message>
        <source>%1 added</source>
        <translation>%1 ajouté</translation>
    </message>
    <message>
        <source>Close to another UAV: %3</source>
        <translation>Proche d&apos;un autre drone : %3</translation>
    </message>
    <message>
        <source>Previous plan kept: next %1</source>
        <translation>Plan précédent conservé : ensuite %1</translation>
    </message>
    <message>
        <source>%1 will enter the inner ring in %4</source>
        <translation>%1 entrera dans l&apos;anneau intérieur dans %4</translation>
    </message>
    <message>
        <source>%1 assigned to %2</source>
        <translation>%1 attribué à %2</translation>
    </message>
    <message>
        <source>Nothing to visit now: circling</source>
        <translation>Rien à visiter pour l&apos;instant : vol d&apos;attente</translation>
    </message>
</context>
<context>
    <name>ExportPicture</name>
    <message>
        <source>No icebergs</source>
        <translation>Aucun iceberg</translation>
    </message>
</context>
<context>
    <name>ExportText</name>
    <message>
        <source>Mission plan</source>
        <translation>Plan de mission</translation>
    </message>
    <message>
        <source>Waypoint list</source>
        <translation>Liste de points de cheminement</translation>
    </message>
    <message>
        <source>QGIS and other map programs</source>
        <translation>QGIS et autres logiciels de cartographie</translation>
    </message>
    <message>
        <source>Icebergs, UAVs, paths and area as features with their numbers, longitude and latitude of WGS 84.</source>
        <translation>Icebergs, drones, trajectoires et zone sous forme d&apos;entités avec leurs valeurs, longitude et latitude WGS 84.</translation>
    </message>
    <message>
        <source>Chart plotters, Garmin</source>
        <translation>Traceurs de cartes, Garmin</translation>
    </message>
    <message>
        <source>Icebergs as waypoints, the order as a route, a path or what was flown as a track with times.</source>
        <translation>Les icebergs comme points de cheminement, l&apos;ordre comme route, une trajectoire ou le vol effectué comme trace horodatée.</translation>
    </message>
    <message>
        <source>UAVs and icebergs moving in time over the globe, with paths, area and asset.</source>
        <translation>Drones et icebergs en mouvement sur le globe, avec trajectoires, zone et bien protégé.</translation>
    </message>
    <message>
        <source>The same as KML, packed into one small file.</source>
        <translation>Identique au KML, compressé en un seul petit fichier.</translation>
    </message>
    <message>
        <source>Paths in the colours of the UAVs, with times if the scenario has a start; icebergs with their numbers.</source>
        <translation>Trajectoires aux couleurs des drones, avec les heures si le scénario a un début ; icebergs avec leurs valeurs.</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incertitude</translation>
    </message>
    <message>
        <source>Spreadsheets</source>
        <translation>Tableurs</translation>
    </message>
    <message>
        <source>Table with the uncertainty of every iceberg over the time of the flight.</source>
        <translation>Tableau de l&apos;incertitude de chaque iceberg au cours du vol.</translation>
    </message>
    <message>
        <source>Decisions</source>
        <translation>Décisions</translation>
    </message>
    <message>
        <source>Table with plans, visits and what else happened in the flight.</source>
        <translation>Tableau des plans, des visites et des autres événements du vol.</translation>
    </message>
    <message>
        <source>Zeta</source>
        <translation>Zêta</translation>
    </message>
    <message>
        <source>Table with zeta over the time of the flight.</source>
        <translation>Tableau de zêta au cours du vol.</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajectoire</translation>
    </message>
    <message>
        <source>Table of the order with legs, coordinates and arrivals; of a path or what was flown one row for each point.</source>
        <translation>Tableau de l&apos;ordre avec segments, coordonnées et arrivées ; pour une trajectoire ou le vol effectué, une ligne par point.</translation>
    </message>
    <message>
        <source>Autopilots</source>
        <translation>Autopilotes</translation>
    </message>
    <message>
        <source>Maps and globes</source>
        <translation>Cartes et globes</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tableaux</translation>
    </message>
    <message>
        <source>Good to know</source>
        <translation>Bon à savoir</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modifié</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Omis</translation>
    </message>
    <message>
        <source>Map as %1</source>
        <translation>Carte au format %1</translation>
    </message>
    <message>
        <source>Charts as %1</source>
        <translation>Graphiques au format %1</translation>
    </message>
    <message>
        <source>Flight brief</source>
        <translation>Fiche de vol</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Drawing programs</source>
        <translation>Logiciels de dessin</translation>
    </message>
    <message>
        <source>Documents and messages</source>
        <translation>Documents et messages</translation>
    </message>
    <message>
        <source>The map with icebergs, paths and area, light, with scale and legend.</source>
        <translation>La carte avec icebergs, trajectoires et zone, en clair, avec échelle et légende.</translation>
    </message>
    <message>
        <source>Zeta and the uncertainty of every iceberg over the time of the flight.</source>
        <translation>Zêta et l&apos;incertitude de chaque iceberg au cours du vol.</translation>
    </message>
    <message>
        <source>Pictures and print</source>
        <translation>Images et impression</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Altitude</translation>
    </message>
    <message>
        <source>Airspeed</source>
        <translation>Vitesse air</translation>
    </message>
    <message>
        <source>Acceptance radius</source>
        <translation>Rayon d&apos;acceptation</translation>
    </message>
    <message>
        <source>Loiter turns</source>
        <translation>Tours d&apos;attente</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Contenu</translation>
    </message>
    <message>
        <source>Flight log</source>
        <translation>Journal de vol</translation>
    </message>
    <message>
        <source>Browsers</source>
        <translation>Navigateurs</translation>
    </message>
    <message>
        <source>Page with planned and flown, zeta against prediction, all sightings and deviations.</source>
        <translation>Page avec le vol planifié et le vol effectué, zêta par rapport à la prévision, toutes les observations et les écarts.</translation>
    </message>
    <message>
        <source>Two or three pages: planned and flown, map, zeta against prediction, sightings, deviations.</source>
        <translation>Deux ou trois pages : vol planifié et vol effectué, carte, zêta par rapport à la prévision, observations, écarts.</translation>
    </message>
    <message>
        <source>Return home</source>
        <translation>Retour à la base</translation>
    </message>
    <message>
        <source>Mission items as QGC WPL 110, the first row home, for Mission Planner and MAVProxy. No geofence. One file per UAV.</source>
        <translation>Éléments de mission au format QGC WPL 110, la base en première ligne, pour Mission Planner et MAVProxy. Sans barrière virtuelle. Un fichier par drone.</translation>
    </message>
    <message>
        <source>To print and carry: map, order with coordinates, legs and times, wind, warnings; plus a second page if there is an operation volume.</source>
        <translation>À imprimer et à emporter : carte, ordre avec coordonnées, segments et heures, vent, avertissements ; plus une seconde page s&apos;il y a un volume opérationnel.</translation>
    </message>
    <message>
        <source>Mission items from take-off to landing for the autopilot of the UAV, the geofence and a rally point at home. Also read by Mission Planner and MAVSDK. One file per UAV.</source>
        <translation>Éléments de la mission du décollage à l&apos;atterrissage pour l&apos;autopilote du drone, barrière virtuelle et point de ralliement à la base. Le fichier est aussi lu par Mission Planner et MAVSDK. Un fichier par drone.</translation>
    </message>
    <message>
        <source>Check before the flight</source>
        <translation>À vérifier avant le vol</translation>
    </message>
    <message>
        <source>Sightings</source>
        <translation>Observations</translation>
    </message>
    <message>
        <source>Ice services</source>
        <translation>Services des glaces</translation>
    </message>
    <message>
        <source>Table of the sightings of the flight in the columns of the International Ice Patrol.</source>
        <translation>Tableau des observations du vol, dans les colonnes de l&apos;International Ice Patrol.</translation>
    </message>
    <message>
        <source>ArcGIS and other GIS</source>
        <translation>ArcGIS et autres SIG</translation>
    </message>
    <message>
        <source>Everything on the map as zipped Shapefiles of points, lines and areas. Needs ogr2ogr (package gdal-bin).</source>
        <translation>Tout ce qui est sur la carte, en Shapefiles compressés de points, de lignes et de zones. Nécessite ogr2ogr (paquet gdal-bin).</translation>
    </message>
    <message>
        <source>QGIS and other GIS</source>
        <translation>QGIS et autres SIG</translation>
    </message>
    <message>
        <source>Everything on the map in one layer. Needs ogr2ogr (package gdal-bin).</source>
        <translation>Tout ce qui est sur la carte, en une couche. Nécessite ogr2ogr (paquet gdal-bin).</translation>
    </message>
    <message>
        <source>Other GIS</source>
        <translation>Autres SIG</translation>
    </message>
    <message>
        <source>CAD programs</source>
        <translation>Logiciels de CAO</translation>
    </message>
    <message>
        <source>A drawing in metres: places, lines and outlines in layers, without names and numbers. Needs ogr2ogr (package gdal-bin).</source>
        <translation>Un dessin en mètres : lieux, lignes et contours par calques, sans noms ni nombres. Nécessite ogr2ogr (paquet gdal-bin).</translation>
    </message>
</context>
<context>
    <name>FieldNames</name>
    <message>
        <source>Time of the recorded track</source>
        <translation>Instant de la trace enregistrée</translation>
    </message>
    <message>
        <source>Place of the recorded track</source>
        <translation>Position de la trace enregistrée</translation>
    </message>
    <message>
        <source>South</source>
        <translation>Sud</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>West</source>
        <translation>Ouest</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Est</translation>
    </message>
    <message>
        <source>Start at</source>
        <translation>Début à</translation>
    </message>
    <message>
        <source>Not before</source>
        <translation>Pas avant</translation>
    </message>
    <message>
        <source>Not after</source>
        <translation>Pas après</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Number of icebergs</source>
        <translation>Nombre d&apos;icebergs</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Lowest speed</source>
        <translation>Vitesse la plus faible</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Vitesse la plus élevée</translation>
    </message>
    <message>
        <source>Drift direction, clockwise from north</source>
        <translation>Direction de la dérive, sens horaire depuis le nord</translation>
    </message>
    <message>
        <source>Spread to either side</source>
        <translation>Écart de chaque côté</translation>
    </message>
    <message>
        <source>Smallest σ at the start</source>
        <translation>Plus petit σ au début</translation>
    </message>
    <message>
        <source>Largest σ at the start</source>
        <translation>Plus grand σ au début</translation>
    </message>
    <message>
        <source>Growth of σ</source>
        <translation>Croissance de σ</translation>
    </message>
    <message>
        <source>Minimum distance between two icebergs</source>
        <translation>Distance minimale entre deux icebergs</translation>
    </message>
</context>
<context>
    <name>FileNames</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
</context>
<context>
    <name>FlightBrief</name>
    <message>
        <source>Times count from the start of the run</source>
        <translation>Les temps sont comptés depuis le début du vol</translation>
    </message>
    <message>
        <source>Start %1 %2 UTC</source>
        <translation>Début %1 %2 UTC</translation>
    </message>
    <message>
        <source>No wind</source>
        <translation>Aucun vent</translation>
    </message>
    <message>
        <source>%1 %2 from %3</source>
        <translation>%1 %2 du %3</translation>
    </message>
    <message>
        <source>%1 %2 towards %3</source>
        <translation>%1 %2 vers le %3</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Wind, true</source>
        <translation>Vent, vrai</translation>
    </message>
    <message>
        <source>Current, true</source>
        <translation>Courant, vrai</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Time of flight</source>
        <translation>Temps de vol</translation>
    </message>
    <message>
        <source>End, UTC</source>
        <translation>Fin, UTC</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Icebergs</translation>
    </message>
    <message>
        <source>Planned by</source>
        <translation>Planifié par</translation>
    </message>
    <message>
        <source>Last plan</source>
        <translation>Dernier plan</translation>
    </message>
    <message>
        <source>Order of visits</source>
        <translation>Ordre de visite</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Altitude</translation>
    </message>
    <message>
        <source>Airspeed</source>
        <translation>Vitesse air</translation>
    </message>
    <message>
        <source>Turn radius</source>
        <translation>Rayon de virage</translation>
    </message>
    <message>
        <source>Acceptance radius</source>
        <translation>Rayon d&apos;acceptation</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Loiter turns</source>
        <translation>Tours d&apos;attente</translation>
    </message>
    <message>
        <source>Endurance left</source>
        <translation>Autonomie restante</translation>
    </message>
    <message>
        <source>Endurance</source>
        <translation>Autonomie</translation>
    </message>
    <message>
        <source>Positions are WGS 84. Icebergs drift: each is listed where it was when reached. Courses and distances are over ground.</source>
        <translation>Les positions sont en WGS 84. Les icebergs dérivent : chacun est donné là où il était lorsqu&apos;il a été atteint. Routes et distances sur le fond.</translation>
    </message>
    <message>
        <source>Positions are WGS 84. Icebergs drift: each is listed where it is expected at arrival. Courses and distances are over ground.</source>
        <translation>Les positions sont en WGS 84. Les icebergs dérivent : chacun est donné là où il est attendu à l&apos;arrivée. Routes et distances sur le fond.</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>Origine %1</translation>
    </message>
    <message>
        <source>Flight brief: %1</source>
        <translation>Fiche de vol : %1</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 de plus</translation>
    </message>
    <message>
        <source>No warnings</source>
        <translation>Aucun avertissement</translation>
    </message>
    <message>
        <source>Warnings (%1)</source>
        <translation>Avertissements (%1)</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>End of track</source>
        <translation>Fin de la trace</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Iceberg</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Latitude</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Longitude</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Route</translation>
    </message>
    <message>
        <source>true</source>
        <translation>vraie</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>Reached</source>
        <translation>Atteint</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Arrivée</translation>
    </message>
    <message>
        <source>σ now</source>
        <translation>σ actuel</translation>
    </message>
    <message>
        <source>and %1 more; export CSV for the whole list</source>
        <translation>et %1 de plus ; exportez en CSV pour la liste complète</translation>
    </message>
    <message>
        <source>and %1 more UAVs; export CSV for the whole list</source>
        <translation>et %1 drones de plus ; exportez en CSV pour la liste complète</translation>
    </message>
    <message>
        <source>Lost, not found where expected (%1): %2</source>
        <translation>Perdus, non trouvés à l&apos;endroit attendu (%1) : %2</translation>
    </message>
    <message>
        <source>Search given up (%1): %2</source>
        <translation>Abandonnés après une recherche (%1) : %2</translation>
    </message>
    <message>
        <source>Not visited (%1): %2</source>
        <translation>Non rejoints (%1) : %2</translation>
    </message>
    <message>
        <source>Not in the order (%1): %2</source>
        <translation>Hors de l&apos;ordre de visite (%1) : %2</translation>
    </message>
    <message>
        <source>The order is not proven optimal: %1.</source>
        <translation>L&apos;optimalité de l&apos;ordre n&apos;est pas prouvée : %1.</translation>
    </message>
    <message>
        <source>Geofence in force: stay inside the area.</source>
        <translation>Barrière virtuelle en vigueur : rester dans la zone.</translation>
    </message>
    <message>
        <source>UAVs share an altitude layer: keep them %1 apart. They do not avoid each other.</source>
        <translation>Des drones partagent une tranche d&apos;altitude : les maintenir à %1 les uns des autres. Ils ne s&apos;évitent pas.</translation>
    </message>
    <message>
        <source>Nothing to visit</source>
        <translation>Rien à visiter</translation>
    </message>
    <message>
        <source>Solver limit reached; previous plan kept</source>
        <translation>Limite du solveur atteinte ; plan précédent conservé</translation>
    </message>
    <message>
        <source>Chosen one iceberg at a time</source>
        <translation>Choisi un iceberg à la fois</translation>
    </message>
    <message>
        <source>Proven optimal</source>
        <translation>Optimalité prouvée</translation>
    </message>
    <message>
        <source>Within %1 % of optimal</source>
        <translation>À moins de %1 % de l&apos;optimum</translation>
    </message>
    <message>
        <source>Best order found</source>
        <translation>Meilleur ordre trouvé</translation>
    </message>
    <message>
        <source>Not planned by a solver</source>
        <translation>Non planifié par un solveur</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>Erreur : %1</translation>
    </message>
    <message>
        <source>The planner reached its limit without an order. The UAV flies the rest of the previous plan, or to the nearest iceberg.</source>
        <translation>Le planificateur a atteint sa limite sans trouver d&apos;ordre. Le drone suit le reste du plan précédent, ou va à l&apos;iceberg le plus proche.</translation>
    </message>
    <message>
        <source>Nothing to visit for %1</source>
        <translation>Rien à visiter pour %1</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>%1 (%2): %3</source>
        <translation>%1 (%2) : %3</translation>
    </message>
    <message>
        <source>Times do not include the loiter turns, which add %1 at each iceberg, %2 in total.</source>
        <translation>Les temps ne comprennent pas les tours d&apos;attente, qui ajoutent %1 à chaque iceberg, %2 au total.</translation>
    </message>
    <message>
        <source>With the loiter turns the endurance is too short: %1</source>
        <translation>Avec les tours d&apos;attente, l&apos;autonomie est insuffisante : %1</translation>
    </message>
    <message>
        <source>Reserve</source>
        <translation>Réserve</translation>
    </message>
    <message>
        <source>No-fly area: %1.</source>
        <translation>Zone interdite : %1.</translation>
    </message>
    <message>
        <source>No-fly area %1: %2.</source>
        <translation>Zone interdite %1 : %2.</translation>
    </message>
    <message>
        <source>Stand-off from the asset: %1, %2.</source>
        <translation>Distance de sécurité au bien protégé : %1, %2.</translation>
    </message>
    <message>
        <source>Climb and landing</source>
        <translation>Montée et atterrissage</translation>
    </message>
    <message>
        <source>Recovery slot</source>
        <translation>Créneau d&apos;atterrissage</translation>
    </message>
    <message>
        <source>Out of radio range</source>
        <translation>Hors de portée radio</translation>
    </message>
    <message>
        <source>Probability of being in view on arrival: %1</source>
        <translation>Probabilité d&apos;être en vue à l&apos;arrivée : %1</translation>
    </message>
    <message>
        <source>Straight legs that leave the geofence or cross a no-fly area: %1. The UAV flies around.</source>
        <translation>Segments droits qui sortent de la barrière virtuelle ou traversent une zone interdite : %1. Le drone les contourne.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>à partir de %1</translation>
    </message>
    <message>
        <source>until %1</source>
        <translation>jusqu&apos;à %1</translation>
    </message>
    <message>
        <source>all day</source>
        <translation>toute la journée</translation>
    </message>
    <message>
        <source>not on this day</source>
        <translation>pas ce jour-là</translation>
    </message>
    <message>
        <source>Sun up, UTC</source>
        <translation>Soleil levé, UTC</translation>
    </message>
    <message>
        <source>Civil twilight, UTC</source>
        <translation>Crépuscule civil, UTC</translation>
    </message>
    <message>
        <source>Declination, WMM2025</source>
        <translation>Déclinaison, WMM2025</translation>
    </message>
    <message>
        <source>Declination</source>
        <translation>Déclinaison</translation>
    </message>
    <message>
        <source>This sortie</source>
        <translation>Cette sortie</translation>
    </message>
    <message>
        <source>Home, above the reserve</source>
        <translation>À la base, au-dessus de la réserve</translation>
    </message>
    <message>
        <source>In 1 flight of 20</source>
        <translation>Dans 1 vol sur 20</translation>
    </message>
    <message>
        <source>magnetic</source>
        <translation>magnét.</translation>
    </message>
    <message>
        <source>Speed</source>
        <comment>over ground</comment>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Autopilot mission: %1.</source>
        <translation>Mission de l&apos;autopilote : %1.</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <comment>speed, direction</comment>
        <translation>%1 du %2</translation>
    </message>
    <message>
        <source>%1 towards %2</source>
        <comment>speed, direction</comment>
        <translation>%1 vers le %2</translation>
    </message>
    <message>
        <source>Time, UTC</source>
        <translation>Heure, UTC</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Rafales</translation>
    </message>
    <message>
        <source>The forecast has no wind between %1 and %2: the plan uses the constant wind of the scenario.</source>
        <translation>La prévision ne donne pas de vent entre %1 et %2 : le plan utilise le vent constant du scénario.</translation>
    </message>
    <message>
        <source>The forecast was issued %1 h before the flight: look for a newer one.</source>
        <translation>La prévision a été émise %1 h avant le vol : cherchez-en une plus récente.</translation>
    </message>
    <message>
        <source>Weather and limits</source>
        <translation>Météo et limites</translation>
    </message>
</context>
<context>
    <name>FlightDrag</name>
    <message>
        <source>Change wind</source>
        <translation>Modifier le vent</translation>
    </message>
    <message>
        <source>Release to apply this wind from now on. Esc cancels.</source>
        <translation>Relâchez pour appliquer ce vent dès maintenant. Esc annule.</translation>
    </message>
    <message>
        <source>Release to keep this wind. Shift snaps to steps of %1°; Esc cancels.</source>
        <translation>Relâchez pour garder ce vent. Maj impose des pas de %1° ; Esc annule.</translation>
    </message>
    <message>
        <source>Release to move the asset here now. Esc cancels.</source>
        <translation>Relâchez pour déplacer le bien protégé ici maintenant. Esc annule.</translation>
    </message>
    <message>
        <source>The UAV makes little headway in this wind. Esc cancels.</source>
        <translation>Le drone progresse peu dans ce vent. Esc annule.</translation>
    </message>
</context>
<context>
    <name>FlightNotices</name>
    <message numerus="yes">
        <source>%1, and %n more</source>
        <translation>
            <numerusform>%1, et %n de plus</numerusform>
            <numerusform>%1, et %n de plus</numerusform>
        </translation>
    </message>
    <message>
        <source>Searching for %1</source>
        <translation>Recherche de %1</translation>
    </message>
    <message>
        <source>On the ground, takes off in %1</source>
        <translation>Au sol, décolle dans %1</translation>
    </message>
    <message>
        <source>It runs again when the next plan is needed.</source>
        <translation>Il s&apos;exécutera de nouveau lorsque le prochain plan sera nécessaire.</translation>
    </message>
    <message>
        <source>The wind changed in flight.</source>
        <translation>Le vent a changé en vol.</translation>
    </message>
    <message>
        <source>They fly at about the same altitude. The required separation is %1.</source>
        <translation>Ils volent à peu près à la même altitude. L&apos;espacement requis est de %1.</translation>
    </message>
    <message>
        <source>Wind above its limit: %1, limit %2</source>
        <translation>Vent au-dessus de la limite : %1, limite %2</translation>
    </message>
    <message>
        <source>Holding as ordered</source>
        <translation>En attente sur ordre</translation>
    </message>
    <message>
        <source>On the ground. Choose Resume to continue</source>
        <translation>Au sol. Choisissez Reprendre pour continuer</translation>
    </message>
    <message>
        <source>%1 is lost</source>
        <translation>%1 est perdu</translation>
    </message>
    <message>
        <source>%1 is lost; the search was abandoned</source>
        <translation>%1 est perdu ; la recherche a été abandonnée</translation>
    </message>
    <message>
        <source>It was not in view where it was expected.</source>
        <translation>Il n&apos;était pas en vue à l&apos;endroit attendu.</translation>
    </message>
    <message>
        <source>Makes little headway: wind %1, airspeed %2</source>
        <translation>Progresse peu : vent %1, vitesse air %2</translation>
    </message>
</context>
<context>
    <name>ForecastText</name>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>vent</translation>
    </message>
    <message>
        <source>gusts</source>
        <translation>rafales</translation>
    </message>
    <message>
        <source>air temperature</source>
        <translation>température de l&apos;air</translation>
    </message>
    <message>
        <source>dew point</source>
        <translation>point de rosée</translation>
    </message>
    <message>
        <source>fog</source>
        <translation>brouillard</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>visibilité</translation>
    </message>
    <message>
        <source>cloud base</source>
        <translation>base des nuages</translation>
    </message>
    <message>
        <source>current</source>
        <translation>courant</translation>
    </message>
    <message>
        <source>unknown source</source>
        <translation>source inconnue</translation>
    </message>
    <message>
        <source>time of issue unknown</source>
        <translation>heure d&apos;émission inconnue</translation>
    </message>
    <message>
        <source>issued %1</source>
        <translation>émise %1</translation>
    </message>
    <message>
        <source>issued %1, %2 after the start</source>
        <translation>émise %1, %2 après le départ</translation>
    </message>
    <message>
        <source>issued %1, %2 before the start</source>
        <translation>émise %1, %2 avant le départ</translation>
    </message>
    <message>
        <source>Forecast of %1, %2</source>
        <comment>source, time of issue</comment>
        <translation>Prévision de %1, %2</translation>
    </message>
</context>
<context>
    <name>HandleDrag</name>
    <message numerus="yes">
        <source>Change drift of %n icebergs</source>
        <translation>
            <numerusform>Modifier la dérive</numerusform>
            <numerusform>Modifier la dérive de %n icebergs</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn UAV</source>
        <translation>Orienter le drone</translation>
    </message>
    <message>
        <source>Release to keep this heading. Shift snaps to steps of %1°; Esc cancels.</source>
        <translation>Relâchez pour garder ce cap. Maj impose des pas de %1° ; Esc annule.</translation>
    </message>
    <message>
        <source>Add corner</source>
        <translation>Ajouter un sommet</translation>
    </message>
    <message>
        <source>Move corner</source>
        <translation>Déplacer le sommet</translation>
    </message>
    <message>
        <source>Release to place the corner here. Esc cancels.</source>
        <translation>Relâchez pour placer le sommet ici. Esc annule.</translation>
    </message>
    <message numerus="yes">
        <source>Drag to give all %n selected icebergs the same drift.</source>
        <translation>
            <numerusform>Faites glisser pour donner cette dérive à %n iceberg sélectionné.</numerusform>
            <numerusform>Faites glisser pour donner la même dérive aux %n icebergs sélectionnés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag to set the drift of the iceberg.</source>
        <translation>Faites glisser pour régler la dérive de l&apos;iceberg.</translation>
    </message>
    <message>
        <source>Drag to turn the UAV.</source>
        <translation>Faites glisser pour orienter le drone.</translation>
    </message>
    <message>
        <source>Drag to move the corner. To remove it, click it and press Del.</source>
        <translation>Faites glisser pour déplacer le sommet. Pour le retirer, cliquez dessus et appuyez sur Suppr.</translation>
    </message>
    <message>
        <source>Drag to add a corner here.</source>
        <translation>Faites glisser pour ajouter un sommet ici.</translation>
    </message>
    <message>
        <source>An area needs at least three corners. Delete the whole area instead.</source>
        <translation>Une zone a besoin d&apos;au moins trois sommets. Supprimez plutôt la zone entière.</translation>
    </message>
    <message>
        <source>Without this corner the outline would cross itself.</source>
        <translation>Sans ce sommet, le contour se croiserait.</translation>
    </message>
    <message>
        <source>Remove corner</source>
        <translation>Retirer le sommet</translation>
    </message>
    <message>
        <source>The outline would cross itself here.</source>
        <translation>Le contour se croiserait ici.</translation>
    </message>
    <message>
        <source>Drag to change the wind from now on. In flight this cannot be undone.</source>
        <translation>Faites glisser pour changer le vent dès maintenant. En vol, cela ne peut pas être annulé.</translation>
    </message>
    <message>
        <source>Drag to set the wind. The arrow points downwind.</source>
        <translation>Faites glisser pour régler le vent. La flèche pointe vers où il souffle.</translation>
    </message>
</context>
<context>
    <name>IcebergClipboard</name>
    <message>
        <source>The clipboard</source>
        <translation>Le presse-papiers</translation>
    </message>
</context>
<context>
    <name>IcebergColumnText</name>
    <message>
        <source>Iceberg</source>
        <translation>Iceberg</translation>
    </message>
    <message>
        <source>Name of the iceberg, or its id if it has none</source>
        <translation>Nom de l&apos;iceberg, ou son identifiant s&apos;il n&apos;en a pas</translation>
    </message>
    <message>
        <source>Uncertainty of the position now; the bar is on the scale of the map</source>
        <translation>Incertitude actuelle de la position ; la barre est à l&apos;échelle de la carte</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>In view, next target, or its place in the visiting order</source>
        <translation>En vue, prochaine cible, ou rang dans l&apos;ordre de visite</translation>
    </message>
    <message>
        <source>Unseen for</source>
        <translation>Non vu depuis</translation>
    </message>
    <message>
        <source>Unseen for, s</source>
        <translation>Non vu depuis, s</translation>
    </message>
    <message>
        <source>Time since it was last in view, or since it became known</source>
        <translation>Temps écoulé depuis qu&apos;il était en vue, ou depuis qu&apos;il est connu</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Arrivée</translation>
    </message>
    <message>
        <source>Arrival in, s</source>
        <translation>Arrivée dans, s</translation>
    </message>
    <message>
        <source>Time until the UAV arrives, by the present plan</source>
        <translation>Temps jusqu&apos;à l&apos;arrivée du drone, selon le plan actuel</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Visites</translation>
    </message>
    <message>
        <source>Number of times it was reached as the target</source>
        <translation>Nombre de fois où il a été atteint comme cible</translation>
    </message>
    <message>
        <source>Position east of the scenario&apos;s origin: before take-off at the start, in flight the estimate</source>
        <translation>Position à l&apos;est de l&apos;origine du scénario : avant le décollage, celle du début ; en vol, l&apos;estimation</translation>
    </message>
    <message>
        <source>Position north of the scenario&apos;s origin: before take-off at the start, in flight the estimate</source>
        <translation>Position au nord de l&apos;origine du scénario : avant le décollage, celle du début ; en vol, l&apos;estimation</translation>
    </message>
    <message>
        <source>Known drift; in flight it includes the current</source>
        <translation>Dérive connue ; en vol, le courant y est compris</translation>
    </message>
    <message>
        <source>Direction, °</source>
        <translation>Direction, °</translation>
    </message>
    <message>
        <source>Drift direction, degrees clockwise from north</source>
        <translation>Direction de la dérive, en degrés dans le sens horaire à partir du nord</translation>
    </message>
    <message>
        <source>Last seen, s ago</source>
        <translation>Dernière obs., il y a (s)</translation>
    </message>
    <message>
        <source>Appears at, s</source>
        <translation>Apparaît à, s</translation>
    </message>
    <message>
        <source>East, %1</source>
        <translation>Est, %1</translation>
    </message>
    <message>
        <source>North, %1</source>
        <translation>Nord, %1</translation>
    </message>
    <message>
        <source>Speed, %1</source>
        <translation>Vitesse, %1</translation>
    </message>
    <message>
        <source>CPA, %1</source>
        <translation>CPA, %1</translation>
    </message>
    <message>
        <source>Closest point of approach: smallest predicted distance from the asset within the next hour. A warning sign beside the name means that the iceberg will enter the inner ring</source>
        <translation>Point de rapprochement maximal (CPA) : plus petite distance prévue au bien protégé dans l&apos;heure qui vient. Un signe d&apos;avertissement à côté du nom indique que l&apos;iceberg entrera dans l&apos;anneau intérieur</translation>
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
        <translation>Temps jusqu&apos;au point de rapprochement maximal</translation>
    </message>
    <message>
        <source>UAV that plans to visit it</source>
        <translation>Drone qui prévoit de le visiter</translation>
    </message>
    <message>
        <source>Position, in flight the estimate. Type or paste any form; a whole coordinate sets both</source>
        <translation>Position, en vol l&apos;estimation. Saisissez ou collez toute forme ; une coordonnée complète règle les deux</translation>
    </message>
    <message>
        <source>Drift east, %1</source>
        <translation>Dérive est, %1</translation>
    </message>
    <message>
        <source>Known drift to the east, without the current</source>
        <translation>Dérive connue vers l&apos;est, sans le courant</translation>
    </message>
    <message>
        <source>Drift north, %1</source>
        <translation>Dérive nord, %1</translation>
    </message>
    <message>
        <source>Known drift to the north, without the current</source>
        <translation>Dérive connue vers le nord, sans le courant</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Latitude</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Longitude</translation>
    </message>
    <message>
        <source>95 % radius, m</source>
        <translation>Rayon à 95 %, m</translation>
    </message>
    <message>
        <source>Radius around the present position that contains the iceberg with a probability of 95 %</source>
        <translation>Rayon autour de la position actuelle qui contient l&apos;iceberg avec une probabilité de 95 %</translation>
    </message>
</context>
<context>
    <name>IcebergPasteText</name>
    <message>
        <source>There is no text to paste.</source>
        <translation>Il n&apos;y a aucun texte à coller.</translation>
    </message>
    <message>
        <source>Row %1 has a cell &quot;%2&quot; to the right of the last column.</source>
        <translation>Ligne %1 : la cellule « %2 » est à droite de la dernière colonne.</translation>
    </message>
    <message>
        <source>Row %1, column &quot;%2&quot;: &quot;%3&quot; is not a number.</source>
        <translation>Ligne %1, colonne « %2 » : « %3 » n&apos;est pas un nombre.</translation>
    </message>
    <message>
        <source>Row %1, column &quot;%2&quot;: %3 is not from %4 to %5.</source>
        <translation>Ligne %1, colonne « %2 » : %3 n&apos;est pas compris entre %4 et %5.</translation>
    </message>
    <message>
        <source>Nothing was pasted.</source>
        <translation>Rien n&apos;a été collé.</translation>
    </message>
    <message>
        <source>Row %1, column &quot;%2&quot;, &quot;%3&quot;: %4</source>
        <translation>Ligne %1, colonne « %2 », « %3 » : %4</translation>
    </message>
    <message>
        <source>Row %1: %2</source>
        <translation>Ligne %1 : %2</translation>
    </message>
    <message>
        <source>Row %1: %2</source>
        <comment>row, fault</comment>
        <translation>Ligne %1 : %2</translation>
    </message>
</context>
<context>
    <name>IcebergRowText</name>
    <message>
        <source>in view</source>
        <translation>en vue</translation>
    </message>
    <message>
        <source>target</source>
        <translation>cible</translation>
    </message>
    <message>
        <source>number %1 in the order</source>
        <translation>numéro %1 dans l&apos;ordre</translation>
    </message>
    <message>
        <source>not in the order</source>
        <translation>hors de l&apos;ordre</translation>
    </message>
    <message>
        <source>not appeared yet</source>
        <translation>pas encore présent</translation>
    </message>
    <message>
        <source>%1 (id %2)</source>
        <translation>%1 (identifiant %2)</translation>
    </message>
    <message>
        <source>Appears at %1</source>
        <translation>Apparaît à %1</translation>
    </message>
    <message>
        <source>It does not drift.</source>
        <translation>Il est immobile.</translation>
    </message>
    <message>
        <source>now</source>
        <translation>maintenant</translation>
    </message>
    <message>
        <source>&gt; 1 h</source>
        <translation>&gt; 1 h</translation>
    </message>
    <message>
        <source>lost, being searched for</source>
        <translation>perdu, recherché</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
    </message>
    <message>
        <source>search abandoned</source>
        <translation>abandonné</translation>
    </message>
    <message>
        <source>It is still approaching after one hour; this is its distance then.</source>
        <translation>Il se rapproche encore au bout d&apos;une heure ; voici sa distance à ce moment.</translation>
    </message>
    <message>
        <source>target of %1</source>
        <translation>cible de %1</translation>
    </message>
    <message>
        <source>number %1 of %2</source>
        <translation>numéro %1 de %2</translation>
    </message>
    <message>
        <source>left or removed</source>
        <translation>parti ou retiré</translation>
    </message>
    <message>
        <source>%1, a standard deviation of %2 m along each axis</source>
        <translation>%1, soit un écart type de %2 m selon chaque axe</translation>
    </message>
</context>
<context>
    <name>ImportCells</name>
    <message>
        <source>Id</source>
        <translation>Identifiant</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Sightings</source>
        <translation>Observations</translation>
    </message>
    <message>
        <source>Last seen, UTC</source>
        <translation>Dernière observation, UTC</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Âge</translation>
    </message>
    <message>
        <source>Speed, m/s</source>
        <translation>Vitesse, m/s</translation>
    </message>
    <message>
        <source>Direction, °</source>
        <translation>Direction, °</translation>
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
        <translation>Notes</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Raison</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Entité</translation>
    </message>
    <message>
        <source>Packet</source>
        <translation>Paquet</translation>
    </message>
    <message>
        <source>Velocity from</source>
        <translation>Vitesse d&apos;après</translation>
    </message>
</context>
<context>
    <name>ImportWords</name>
    <message>
        <source>new</source>
        <translation>nouveau</translation>
    </message>
    <message>
        <source>updated</source>
        <translation>mis à jour</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>inchangé</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>omis</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Identifiant</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Latitude</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Longitude</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Uncertainty σ</source>
        <translation>Incertitude σ</translation>
    </message>
    <message>
        <source>Growth q</source>
        <translation>Croissance q</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Size class</source>
        <translation>Classe de taille</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
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
        <translation>Patrouille internationale des glaces (CSV)</translation>
    </message>
    <message>
        <source>US National Ice Center (CSV)</source>
        <translation>US National Ice Center (CSV)</translation>
    </message>
    <message>
        <source>Any table (CSV)</source>
        <translation>Tableau quelconque (CSV)</translation>
    </message>
    <message numerus="yes">
        <source>%n new</source>
        <translation>
            <numerusform>%n nouveau</numerusform>
            <numerusform>%n nouveaux</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n updated</source>
        <translation>
            <numerusform>%n mis à jour</numerusform>
            <numerusform>%n mis à jour</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unchanged</source>
        <translation>
            <numerusform>%n inchangé</numerusform>
            <numerusform>%n inchangés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n left out</source>
        <translation>
            <numerusform>%n omis</numerusform>
            <numerusform>%n omis</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings outside the area</source>
        <translation>
            <numerusform>%n observation hors de la zone</numerusform>
            <numerusform>%n observations hors de la zone</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings outside the time</source>
        <translation>
            <numerusform>%n observation hors de la période</numerusform>
            <numerusform>%n observations hors de la période</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rows rejected</source>
        <translation>
            <numerusform>%n ligne rejetée</numerusform>
            <numerusform>%n lignes rejetées</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing to import</source>
        <translation>Rien à importer</translation>
    </message>
    <message>
        <source>%1 d %2 h</source>
        <translation>%1 j %2 h</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>MET Norway (GeoJSON)</source>
        <translation>MET Norway (GeoJSON)</translation>
    </message>
    <message>
        <source>Canadian Ice Service (CSV)</source>
        <translation>Service canadien des glaces (CSV)</translation>
    </message>
    <message>
        <source>KMZ (KML, packed)</source>
        <translation>KMZ (KML compressé)</translation>
    </message>
    <message>
        <source>CZML (Cesium)</source>
        <translation>CZML (Cesium)</translation>
    </message>
    <message>
        <source>GPX (waypoints, routes and tracks)</source>
        <translation>GPX (points de cheminement, routes et traces)</translation>
    </message>
    <message>
        <source>QGroundControl plan</source>
        <translation>Plan QGroundControl</translation>
    </message>
    <message>
        <source>ArduPilot mission (QGC WPL)</source>
        <translation>Mission ArduPilot (QGC WPL)</translation>
    </message>
    <message>
        <source>Line %1: %2 is read month first, which nothing in the file tells. Choose under Dates if the day comes first.</source>
        <translation>Ligne %1 : %2 est lu avec le mois en premier ; rien dans le fichier ne l&apos;indique. Choisissez sous « Dates » si le jour vient en premier.</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>positions</translation>
    </message>
    <message>
        <source>file</source>
        <translation>fichier</translation>
    </message>
    <message>
        <source>both</source>
        <translation>les deux</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>source, age</comment>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n rows changed</source>
        <translation>
            <numerusform>%n ligne modifiée</numerusform>
            <numerusform>%n lignes modifiées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings are more than 1000 km from the origin of this scenario. Import them into a new one, or choose others with Inside.</source>
        <translation>
            <numerusform>%n observation est à plus de 1000 km de l&apos;origine de ce scénario. Importez-la dans un nouveau, ou choisissez-en d&apos;autres avec À l&apos;intérieur.</numerusform>
            <numerusform>%n observations sont à plus de 1000 km de l&apos;origine de ce scénario. Importez-les dans un nouveau, ou choisissez-en d&apos;autres avec À l&apos;intérieur.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings are more than 1000 km from the origin, which is in their densest group. Choose others with Inside.</source>
        <translation>
            <numerusform>%n observation est à plus de 1000 km de l&apos;origine, qui est dans le groupe le plus dense. Choisissez-en d&apos;autres avec À l&apos;intérieur.</numerusform>
            <numerusform>%n observations sont à plus de 1000 km de l&apos;origine, qui est dans leur groupe le plus dense. Choisissez-en d&apos;autres avec À l&apos;intérieur.</numerusform>
        </translation>
    </message>
    <message>
        <source>From the file: %1</source>
        <translation>Du fichier : %1</translation>
    </message>
    <message>
        <source>Radar and AIS of a ship (NMEA log)</source>
        <translation>Radar et AIS d&apos;un navire (journal NMEA)</translation>
    </message>
    <message>
        <source>Photograph with GPS (JPEG)</source>
        <translation>Photographie avec GPS (JPEG)</translation>
    </message>
</context>
<context>
    <name>InspectorRows</name>
    <message>
        <source>Change drift</source>
        <translation>Modifier la dérive</translation>
    </message>
    <message>
        <source>Change uncertainty</source>
        <translation>Modifier l&apos;incertitude</translation>
    </message>
    <message>
        <source>standard deviation %1 m</source>
        <translation>écart-type %1 m</translation>
    </message>
    <message>
        <source> s ago</source>
        <comment>unit after a number</comment>
        <translation> s avant</translation>
    </message>
    <message>
        <source>Change name</source>
        <translation>Modifier le nom</translation>
    </message>
    <message>
        <source>Change position</source>
        <translation>Modifier la position</translation>
    </message>
    <message>
        <source>stationary</source>
        <translation>immobile</translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation>Modifier le vent</translation>
    </message>
    <message>
        <source>no wind</source>
        <translation>aucun vent</translation>
    </message>
    <message>
        <source>Change current</source>
        <translation>Modifier le courant</translation>
    </message>
    <message>
        <source>Change velocity of the asset</source>
        <translation>Modifier la vitesse du bien protégé</translation>
    </message>
    <message>
        <source>Removes the asset from the map.</source>
        <translation>Retire le bien protégé de la carte.</translation>
    </message>
    <message>
        <source>Remove asset</source>
        <translation>Retirer le bien protégé</translation>
    </message>
    <message>
        <source>Removes the area from the map.</source>
        <translation>Retire la zone de la carte.</translation>
    </message>
    <message>
        <source>Remove area</source>
        <translation>Retirer la zone</translation>
    </message>
    <message>
        <source>turns with the UAV</source>
        <translation>tourne avec le drone</translation>
    </message>
    <message>
        <source>aligned with north</source>
        <translation>orienté au nord</translation>
    </message>
    <message>
        <source>a disk</source>
        <translation>un disque</translation>
    </message>
    <message>
        <source>by position</source>
        <translation>par rang</translation>
    </message>
    <message>
        <source>as printed</source>
        <translation>telle qu&apos;imprimée</translation>
    </message>
    <message>
        <source>reduced</source>
        <translation>réduite</translation>
    </message>
    <message>
        <source>Change origin</source>
        <translation>Modifier l&apos;origine</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Latitude</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Longitude</translation>
    </message>
    <message>
        <source>relative times</source>
        <translation>temps relatifs</translation>
    </message>
    <message numerus="yes">
        <source>%n corners, %1</source>
        <translation>
            <numerusform>%n sommet, %1</numerusform>
            <numerusform>%n sommets, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Recorded track</source>
        <translation>Trace enregistrée</translation>
    </message>
    <message>
        <source>Its true motion follows this record, while the estimate follows the drift above.</source>
        <translation>Son mouvement réel suit cet enregistrement, alors que l&apos;estimation suit la dérive ci-dessus.</translation>
    </message>
    <message>
        <source>Clear recorded track</source>
        <translation>Effacer la trace enregistrée</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 towards %2°</source>
        <translation>%1 vers %2°</translation>
    </message>
    <message>
        <source>Change home</source>
        <translation>Modifier la base</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Landing place other than the start.</source>
        <translation>Lieu d&apos;atterrissage autre que le départ.</translation>
    </message>
    <message>
        <source>Land where it starts</source>
        <translation>Se poser au point de départ</translation>
    </message>
    <message>
        <source>%1 from the start</source>
        <translation>à %1 du départ</translation>
    </message>
    <message>
        <source>Observer</source>
        <translation>Observateur</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exact</translation>
    </message>
    <message>
        <source>Kalman filter</source>
        <translation>filtre de Kalman</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>expanding square</source>
        <translation>carré croissant</translation>
    </message>
    <message>
        <source>sectors</source>
        <translation>secteurs</translation>
    </message>
    <message>
        <source>any UAV</source>
        <translation>n&apos;importe quel drone</translation>
    </message>
    <message>
        <source>Move ground station</source>
        <translation>Déplacer la station sol</translation>
    </message>
    <message>
        <source>Ground station</source>
        <translation>Station sol</translation>
    </message>
    <message>
        <source>Position of the radio link to the UAVs. Its range is a ring on the map.</source>
        <translation>Position de la liaison radio avec les drones. Sa portée est un cercle sur la carte.</translation>
    </message>
    <message>
        <source>Change ground station</source>
        <translation>Modifier la station sol</translation>
    </message>
    <message>
        <source>do not fly</source>
        <translation>ne pas voler</translation>
    </message>
    <message>
        <source>flying allowed</source>
        <translation>vol autorisé</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Removes the no-fly area from the map.</source>
        <translation>Retire la zone interdite de la carte.</translation>
    </message>
    <message>
        <source>Remove no-fly area</source>
        <translation>Retirer la zone interdite</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>No-fly area: %1</source>
        <translation>Zone interdite : %1</translation>
    </message>
    <message>
        <source>No-fly area %1: %2</source>
        <translation>Zone interdite %1 : %2</translation>
    </message>
    <message>
        <source>Separate altitudes</source>
        <translation>Séparer les altitudes</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Speed of a ship; 0 for a platform.</source>
        <translation>Vitesse d&apos;un navire ; 0 pour une plateforme.</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Route</translation>
    </message>
    <message>
        <source>Course over ground, clockwise from north.</source>
        <translation>Route sur le fond, dans le sens horaire à partir du nord.</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dérive</translation>
    </message>
    <message>
        <source>Known drift, without the current.</source>
        <translation>Dérive connue, sans le courant.</translation>
    </message>
    <message>
        <source>Drift towards</source>
        <translation>Dérive vers</translation>
    </message>
    <message>
        <source>Drift direction, clockwise from north.</source>
        <translation>Direction de la dérive, dans le sens horaire à partir du nord.</translation>
    </message>
    <message>
        <source>Any form; a whole coordinate sets both.</source>
        <translation>Sous toute forme ; une coordonnée complète règle les deux.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vent</translation>
    </message>
    <message>
        <source>Must be below the UAV&apos;s airspeed.</source>
        <translation>Doit être inférieur à la vitesse air du drone.</translation>
    </message>
    <message>
        <source>Wind from</source>
        <translation>Vent du</translation>
    </message>
    <message>
        <source>Direction the wind blows from, clockwise from north.</source>
        <translation>Direction d&apos;où souffle le vent, dans le sens horaire à partir du nord.</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1 du %2</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Courant</translation>
    </message>
    <message>
        <source>Carries every iceberg.</source>
        <translation>Entraîne tous les icebergs.</translation>
    </message>
    <message>
        <source>Current towards</source>
        <translation>Courant vers</translation>
    </message>
    <message>
        <source>Direction the current flows to, clockwise from north.</source>
        <translation>Direction vers laquelle va le courant, dans le sens horaire à partir du nord.</translation>
    </message>
    <message>
        <source>Change operation</source>
        <translation>Modifier l&apos;opération</translation>
    </message>
    <message>
        <source>Makes airspace that the operation may enter no-fly areas, so that the UAVs stay out of it.</source>
        <translation>Convertit en zones interdites l&apos;espace aérien où l&apos;opération peut entrer, pour que les drones s&apos;en tiennent à l&apos;écart.</translation>
    </message>
    <message>
        <source>Make entered airspace no-fly areas</source>
        <translation>Convertir l&apos;espace aérien concerné en zones interdites</translation>
    </message>
    <message>
        <source>Removes all airspace. Undo restores it.</source>
        <translation>Retire tout l&apos;espace aérien. Annuler le rétablit.</translation>
    </message>
    <message>
        <source>Remove airspace</source>
        <translation>Retirer l&apos;espace aérien</translation>
    </message>
    <message>
        <source>Operation volume</source>
        <translation>Volume opérationnel</translation>
    </message>
    <message>
        <source>Proposed volume for a permit application; check it with your authority. Shown on the map, in KML and GeoJSON, and on a second page of the flight brief.</source>
        <translation>Volume proposé pour une demande d&apos;autorisation ; à vérifier avec votre autorité. Affiché sur la carte, en KML et GeoJSON, et sur une seconde page de la fiche de vol.</translation>
    </message>
    <message>
        <source>Contingency volume %1 wide, %2 high
Ground-risk buffer %3
Adjacent area %4</source>
        <translation>Volume de contingence, largeur %1, hauteur %2
Zone tampon de risque au sol %3
Zone adjacente %4</translation>
    </message>
    <message>
        <source>Airspace %1: %2</source>
        <translation>Espace aérien %1 : %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 de plus</translation>
    </message>
    <message>
        <source>Position and course</source>
        <translation>Position et route</translation>
    </message>
    <message>
        <source>Protection</source>
        <translation>Protection</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incertitude</translation>
    </message>
    <message>
        <source>Size and visits</source>
        <translation>Taille et visites</translation>
    </message>
    <message>
        <source>Time and place</source>
        <translation>Heure et lieu</translation>
    </message>
    <message>
        <source>Wind, weather and current</source>
        <translation>Vent, météo et courant</translation>
    </message>
    <message>
        <source>Flight rules</source>
        <translation>Règles de vol</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Planificateur</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Position and heading</source>
        <translation>Position et cap</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Aéronef</translation>
    </message>
    <message>
        <source>Endurance and home</source>
        <translation>Autonomie et base</translation>
    </message>
    <message>
        <source>Weather limits</source>
        <translation>Limites météo</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % dans un rayon de</translation>
    </message>
    <message>
        <source>When last seen, the iceberg was within this radius with a probability of 95 %: the square root of 5.99 σ₀.</source>
        <translation>Lors de la dernière observation, l&apos;iceberg était dans ce rayon avec une probabilité de 95 % : racine carrée de 5,99 σ₀.</translation>
    </message>
    <message>
        <source>Seen by</source>
        <translation>Observé par</translation>
    </message>
    <message>
        <source>Sets the usual uncertainty of this source, also for icebergs placed later.</source>
        <translation>Règle l&apos;incertitude usuelle de cette source, aussi pour les icebergs placés ensuite.</translation>
    </message>
    <message>
        <source>as typed</source>
        <translation>saisie</translation>
    </message>
    <message>
        <source>Raises UAVs until their altitudes are %1 apart, so that none has to wait for another.</source>
        <translation>Élève les drones jusqu&apos;à ce que leurs altitudes diffèrent de %1, afin qu&apos;aucun n&apos;ait à en attendre un autre.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Modifier : %1</translation>
    </message>
    <message>
        <source>ArduPilot, fixed wing</source>
        <translation>ArduPilot, voilure fixe</translation>
    </message>
    <message>
        <source>ArduPilot, flying wing launched by hand</source>
        <translation>ArduPilot, aile volante lancée à la main</translation>
    </message>
    <message>
        <source>ArduPilot, VTOL</source>
        <translation>ArduPilot, ADAV</translation>
    </message>
    <message>
        <source>ArduPilot, multirotor</source>
        <translation>ArduPilot, drone multirotor</translation>
    </message>
    <message>
        <source>PX4, fixed wing</source>
        <translation>PX4, voilure fixe</translation>
    </message>
    <message>
        <source>PX4, VTOL</source>
        <translation>PX4, ADAV</translation>
    </message>
    <message>
        <source>PX4, multirotor</source>
        <translation>PX4, drone multirotor</translation>
    </message>
    <message>
        <source>as set below</source>
        <translation>comme réglé ci-dessous</translation>
    </message>
    <message>
        <source>Aircraft profile</source>
        <translation>Profil de l&apos;appareil</translation>
    </message>
    <message>
        <source>Sets all values of this group at once.</source>
        <translation>Règle d&apos;un coup toutes les valeurs de ce groupe.</translation>
    </message>
    <message>
        <source>Choose aircraft profile</source>
        <translation>Choisir le profil de l&apos;appareil</translation>
    </message>
    <message>
        <source>by mission item</source>
        <translation>par un élément de la mission</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <source>return to launch</source>
        <translation>retour à la base</translation>
    </message>
    <message>
        <source>landing pattern</source>
        <translation>circuit d&apos;atterrissage</translation>
    </message>
    <message>
        <source>loiter and wait</source>
        <translation>attente en cercle</translation>
    </message>
    <message>
        <source>not in the mission</source>
        <translation>absente de la mission</translation>
    </message>
    <message>
        <source>by distance</source>
        <translation>selon la distance</translation>
    </message>
    <message>
        <source>by time</source>
        <translation>selon le temps</translation>
    </message>
    <message>
        <source>fixed wing</source>
        <translation>voilure fixe</translation>
    </message>
    <message>
        <source>VTOL</source>
        <translation>ADAV</translation>
    </message>
    <message>
        <source>multirotor</source>
        <translation>drone multirotor</translation>
    </message>
    <message>
        <source>Autopilot mission</source>
        <translation>Mission de l&apos;autopilote</translation>
    </message>
    <message>
        <source>Forecast</source>
        <translation>Prévision</translation>
    </message>
    <message>
        <source>Where and when it gives a quantity, it replaces the constant one below.</source>
        <translation>Là et quand elle donne une grandeur, elle remplace la valeur constante ci-dessous.</translation>
    </message>
    <message>
        <source>Remove forecast</source>
        <translation>Supprimer la prévision</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>vide</translation>
    </message>
    <message>
        <source>%1; replaces %2</source>
        <comment>time of issue, quantities</comment>
        <translation>%1 ; remplace %2</translation>
    </message>
    <message>
        <source>%1; not used before the start (UTC) is set, then it replaces %2</source>
        <comment>time of issue, quantities</comment>
        <translation>%1 ; inutilisée tant que le départ (UTC) n&apos;est pas fixé, puis remplace %2</translation>
    </message>
    <message>
        <source>%1 h: %2 (1 σ: %3)</source>
        <comment>time, error, deviation</comment>
        <translation>%1 h : %2 (1 σ : %3)</translation>
    </message>
    <message>
        <source>Error of the predicted drift</source>
        <translation>Erreur de la dérive prévue</translation>
    </message>
</context>
<context>
    <name>InterventionText</name>
    <message>
        <source>Change policy</source>
        <translation>Modifier la stratégie</translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation>Modifier le vent</translation>
    </message>
    <message>
        <source>Move asset</source>
        <translation>Déplacer le bien protégé</translation>
    </message>
    <message>
        <source>Add iceberg</source>
        <translation>Ajouter un iceberg</translation>
    </message>
    <message>
        <source>Report sighting</source>
        <translation>Signaler une observation</translation>
    </message>
    <message>
        <source>Remove icebergs</source>
        <translation>Retirer des icebergs</translation>
    </message>
    <message>
        <source>Assign iceberg</source>
        <translation>Attribuer l&apos;iceberg</translation>
    </message>
    <message>
        <source>Order UAV</source>
        <translation>Donner un ordre au drone</translation>
    </message>
    <message>
        <source>Change trade-off</source>
        <translation>Modifier le compromis</translation>
    </message>
    <message>
        <source>The scenario is locked in flight. Stop the flight to change it.</source>
        <translation>Le scénario est verrouillé en vol. Arrêtez le vol pour le modifier.</translation>
    </message>
    <message>
        <source>Move home</source>
        <translation>Déplacer la base</translation>
    </message>
</context>
<context>
    <name>IssueText</name>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n erreur</numerusform>
            <numerusform>%n erreurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n avertissement</numerusform>
            <numerusform>%n avertissements</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hints</source>
        <translation>
            <numerusform>%n conseil</numerusform>
            <numerusform>%n conseils</numerusform>
        </translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>ligne %1, colonne %2 : ce n&apos;est pas du JSON valide</translation>
    </message>
    <message>
        <source>line %1, column %2: %3: a number too large for this program</source>
        <translation>ligne %1, colonne %2 : %3 : un nombre trop grand pour ce programme</translation>
    </message>
    <message>
        <source>nested deeper than %1 levels</source>
        <translation>est imbriqué sur plus de %1 niveaux</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1 : ce n&apos;est pas du XML valide</translation>
    </message>
    <message>
        <source>is no %1 file: must be %2, not %3</source>
        <translation>n&apos;est pas un fichier %1 : doit être %2, et non %3</translation>
    </message>
    <message>
        <source>must be &quot;%1&quot;</source>
        <translation>doit être « %1 »</translation>
    </message>
    <message>
        <source>must be &quot;%1&quot;, not &quot;%2&quot;</source>
        <translation>doit être « %1 », et non « %2 »</translation>
    </message>
    <message>
        <source>%1 is not known: this program reads %2</source>
        <translation>%1 n&apos;est pas connu : ce programme lit %2</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>is missing, and so is %1</source>
        <translation>manque, de même que %1</translation>
    </message>
    <message>
        <source>must not be given beside %1</source>
        <translation>ne doit pas être donné en même temps que %1</translation>
    </message>
    <message>
        <source>appears more than once</source>
        <translation>apparaît plus d&apos;une fois</translation>
    </message>
    <message>
        <source>must be %1, not %2</source>
        <translation>doit être %1, et non %2</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>doit être l&apos;un des suivants : %1</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2, not %3</source>
        <translation>doit être un nombre entier de %1 à %2, et non %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number</source>
        <translation>« %1 » n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number: decimals follow a point</source>
        <translation>« %1 » n&apos;est pas un nombre : les décimales suivent un point</translation>
    </message>
    <message>
        <source>must be a finite number of at least 0</source>
        <translation>doit être un nombre fini d&apos;au moins 0</translation>
    </message>
    <message>
        <source>must not be below %1</source>
        <translation>ne doit pas être inférieur à %1</translation>
    </message>
    <message>
        <source>must not be before %1</source>
        <translation>ne doit pas être antérieur à %1</translation>
    </message>
    <message>
        <source>must rise from entry to entry</source>
        <translation>doit augmenter d&apos;une valeur à la suivante</translation>
    </message>
    <message>
        <source>must hold %1 entries, not %2</source>
        <translation>doit contenir %1 valeurs, et non %2</translation>
    </message>
    <message>
        <source>must hold from %1 to %2 entries, not %3</source>
        <translation>doit contenir de %1 à %2 valeurs, et non %3</translation>
    </message>
    <message>
        <source>must hold at least %1 entries</source>
        <translation>doit contenir au moins %1 valeurs</translation>
    </message>
    <message>
        <source>must hold at most %1 entries, not %2</source>
        <translation>doit contenir au plus %1 valeurs, et non %2</translation>
    </message>
    <message>
        <source>must not repeat an iceberg</source>
        <translation>ne doit pas répéter un iceberg</translation>
    </message>
    <message>
        <source>no iceberg &quot;%1&quot; is there at this time</source>
        <translation>il n&apos;y a pas d&apos;iceberg « %1 » à cet instant</translation>
    </message>
    <message>
        <source>with these, the run must hold at most %1 icebergs, not %2</source>
        <translation>avec ceux-ci, le vol doit contenir au plus %1 icebergs, et non %2</translation>
    </message>
    <message>
        <source>is the UAV&apos;s and must be 0</source>
        <translation>est celui du drone et doit être 0</translation>
    </message>
    <message>
        <source>must be a square matrix with one row and column per sigma</source>
        <translation>doit être une matrice carrée avec une ligne et une colonne par sigma</translation>
    </message>
    <message>
        <source>must be empty or hold one entry per UAV and sigma</source>
        <translation>doit être vide ou contenir une valeur par drone et par sigma</translation>
    </message>
    <message>
        <source>must be true for one UAV at least</source>
        <translation>doit être true pour un drone au moins</translation>
    </message>
    <message>
        <source>is too large: the cost of a plan may exceed %1</source>
        <translation>est trop grand : le coût d&apos;un plan peut dépasser %1</translation>
    </message>
    <message>
        <source>is too small: a cost that is not 0 is less than %1</source>
        <translation>est trop petit : un coût qui n&apos;est pas 0 est inférieur à %1</translation>
    </message>
    <message>
        <source>must not be empty when random is 0</source>
        <translation>ne doit pas être vide lorsque random est 0</translation>
    </message>
    <message>
        <source>must name a policy; visitation needs taus</source>
        <translation>doit nommer une stratégie ; visitation a besoin de valeurs de τ</translation>
    </message>
    <message>
        <source>must be I of N with 1 &lt;= I &lt;= N</source>
        <translation>doit être la partie I sur N, avec 1 &lt;= I &lt;= N</translation>
    </message>
    <message>
        <source>differs: parts of one study are wanted</source>
        <translation>diffère : il faut des parties d&apos;une même étude</translation>
    </message>
    <message>
        <source>setting %1 of case %2 has two different outcomes: the parts were not flown by the same program</source>
        <translation>le réglage %1 du cas %2 a deux résultats différents : les parties n&apos;ont pas été calculées par le même programme</translation>
    </message>
    <message>
        <source>no study is kept in this page</source>
        <translation>cette page ne contient aucune étude</translation>
    </message>
    <message>
        <source>would become larger than %1 MiB: take fewer scenarios, or several studies</source>
        <translation>dépasserait %1 Mio : prenez moins de scénarios, ou plusieurs études</translation>
    </message>
    <message>
        <source>recorded %1, replayed %2</source>
        <translation>enregistré %1, rejoué %2</translation>
    </message>
    <message>
        <source>at %1 s: recorded %2, replayed %3</source>
        <translation>à %1 s : enregistré %2, rejoué %3</translation>
    </message>
    <message>
        <source>at %1 s: the replay has another</source>
        <translation>à %1 s : le vol rejoué diffère</translation>
    </message>
    <message>
        <source>at %1 s: not reached by the replay</source>
        <translation>à %1 s : non atteint par le vol rejoué</translation>
    </message>
    <message>
        <source>solves were cut by the clock, so this run is not bound to repeat</source>
        <translation>des résolutions ont été interrompues par l&apos;horloge ; ce vol ne se répète donc pas forcément</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>ne peut pas être ouvert : %1</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>ne peut pas être lu : %1</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>ne peut pas être écrit : %1</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>ne peut pas être créé</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>est endommagé</translation>
    </message>
    <message>
        <source>is of another version</source>
        <translation>est d&apos;une autre version</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>n&apos;est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>is larger than %1 MiB</source>
        <translation>dépasse %1 Mio</translation>
    </message>
    <message>
        <source>is larger than %1 MiB; %2 in the environment doubles the limits of reading</source>
        <translation>dépasse %1 Mio ; %2 dans l&apos;environnement double les limites de lecture</translation>
    </message>
    <message>
        <source>holds more than %1 values; %2 in the environment doubles the limits of reading</source>
        <translation>contient plus de %1 valeurs ; %2 dans l&apos;environnement double les limites de lecture</translation>
    </message>
    <message>
        <source>holds more than %1 rows or features; %2 in the environment doubles the limits of reading</source>
        <translation>contient plus de %1 lignes ou entités ; %2 dans l&apos;environnement double les limites de lecture</translation>
    </message>
    <message>
        <source>would take more than %1 MB of memory, the limit for a file of its size: split it, or leave out what is empty; %2 in the environment doubles the limits of reading</source>
        <translation>prendrait plus de %1 Mo de mémoire, la limite pour un fichier de cette taille : divisez-le ou omettez ce qui est vide ; %2 dans l&apos;environnement double les limites de lecture</translation>
    </message>
    <message>
        <source>there are more than %1 icebergs to choose from: narrow the area or the time; %2 in the environment doubles the limits of reading</source>
        <translation>il y a plus de %1 icebergs parmi lesquels choisir : réduisez la zone ou la période ; %2 dans l&apos;environnement double les limites de lecture</translation>
    </message>
    <message>
        <source>is an archive that cannot be read: it is cut off or damaged</source>
        <translation>est une archive illisible : elle est tronquée ou endommagée</translation>
    </message>
    <message>
        <source>is a compressed archive (such as XLSX) without a file *%1</source>
        <translation>est une archive compressée (par exemple XLSX) sans fichier *%1</translation>
    </message>
    <message>
        <source>is an archive whose entry *%1 cannot be unpacked</source>
        <translation>est une archive dont l&apos;élément *%1 ne peut pas être décompressé</translation>
    </message>
    <message>
        <source>is an archive in an archive</source>
        <translation>est une archive dans une archive</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>est vide</translation>
    </message>
    <message>
        <source>is UTF-16 text; save it as UTF-8</source>
        <translation>est un texte UTF-16 ; enregistrez-le en UTF-8</translation>
    </message>
    <message>
        <source>is no text file</source>
        <translation>n&apos;est pas un fichier texte</translation>
    </message>
    <message>
        <source>no import format &quot;%1&quot;; there are %2</source>
        <translation>il n&apos;y a pas de format d&apos;importation « %1 » ; il y a %2</translation>
    </message>
    <message>
        <source>columns of the format %1 cannot be mapped</source>
        <translation>les colonnes du format %1 ne peuvent pas être associées</translation>
    </message>
    <message>
        <source>holds no sightings</source>
        <translation>ne contient aucune observation</translation>
    </message>
    <message>
        <source>there is no column &quot;%1&quot;</source>
        <translation>il n&apos;y a pas de colonne « %1 »</translation>
    </message>
    <message>
        <source>no column holds it; name one with a mapping</source>
        <translation>aucune colonne ne le contient ; associez-en une</translation>
    </message>
    <message>
        <source>columns %1 and %2 are both called &quot;%3&quot;: rename one</source>
        <translation>les colonnes %1 et %2 s&apos;appellent toutes deux « %3 » : renommez-en une</translation>
    </message>
    <message>
        <source>the first line must name from 1 to %1 columns</source>
        <translation>la première ligne doit nommer de 1 à %1 colonnes</translation>
    </message>
    <message>
        <source>has %2 columns and not %1</source>
        <translation>a %2 colonnes et non %1</translation>
    </message>
    <message>
        <source>%1 would then be more than 1000 km east, west, north or south of the origin</source>
        <translation>%1 serait alors à plus de 1000 km à l&apos;est, à l&apos;ouest, au nord ou au sud de l&apos;origine</translation>
    </message>
    <message>
        <source>cannot move while the scenario holds icebergs, an asset or an area</source>
        <translation>impossible à déplacer tant que le scénario contient des icebergs, un bien protégé ou une zone</translation>
    </message>
    <message>
        <source>this is not a place on the Earth</source>
        <translation>ce n&apos;est pas un lieu sur la Terre</translation>
    </message>
    <message>
        <source>has another number of columns than the first line</source>
        <translation>n&apos;a pas le même nombre de colonnes que la première ligne</translation>
    </message>
    <message>
        <source>a quote is opened and never closed</source>
        <translation>un guillemet est ouvert et jamais fermé</translation>
    </message>
    <message>
        <source>text follows a closing quote</source>
        <translation>du texte suit un guillemet fermant</translation>
    </message>
    <message>
        <source>has no time</source>
        <translation>n&apos;a pas d&apos;heure</translation>
    </message>
    <message>
        <source>time cannot be read</source>
        <translation>l&apos;heure est illisible</translation>
    </message>
    <message>
        <source>date is not in the season</source>
        <translation>la date n&apos;est pas dans la saison</translation>
    </message>
    <message>
        <source>has no position</source>
        <translation>n&apos;a pas de position</translation>
    </message>
    <message>
        <source>a number is out of range</source>
        <translation>un nombre est hors limites</translation>
    </message>
    <message>
        <source>id is too long</source>
        <translation>l&apos;identifiant est trop long</translation>
    </message>
    <message>
        <source>is no point</source>
        <translation>n&apos;est pas un point</translation>
    </message>
    <message>
        <source>is more than 1000 km east, west, north or south of the origin</source>
        <translation>est à plus de 1000 km à l&apos;est, à l&apos;ouest, au nord ou au sud de l&apos;origine</translation>
    </message>
    <message>
        <source>there is no room for more</source>
        <translation>il n&apos;y a plus de place</translation>
    </message>
    <message>
        <source>must lie within %1 m</source>
        <translation>doit se trouver à moins de %1 m</translation>
    </message>
    <message>
        <source>only %1 of %2 icebergs found a place: the area is too thin</source>
        <translation>seuls %1 icebergs sur %2 ont trouvé une place : la zone est trop étroite</translation>
    </message>
    <message>
        <source>a scenario has no such file: nothing was flown</source>
        <translation>un scénario n&apos;a pas de tel fichier : aucun vol n&apos;a été effectué</translation>
    </message>
    <message>
        <source>must be above the speed of the wind</source>
        <translation>doit être supérieur à la vitesse du vent</translation>
    </message>
    <message>
        <source>there is no UAV %1</source>
        <translation>il n&apos;y a pas de drone %1</translation>
    </message>
    <message>
        <source>%1 holds one UAV: choose one</source>
        <translation>%1 contient un seul drone : choisissez-en un</translation>
    </message>
    <message>
        <source>%1 is painted, which needs the program bergwatch</source>
        <translation>%1 est une image, ce qui nécessite le programme bergwatch</translation>
    </message>
    <message>
        <source>cannot be exported: at %1 s of the flight, later than any date</source>
        <translation>ne peut pas être exporté : à %1 s du vol, au-delà de toute date</translation>
    </message>
    <message>
        <source>cannot be exported: at %1 s it is %2 m from the origin of the map, which holds %3 m</source>
        <translation>ne peut pas être exporté : à %1 s, il est à %2 m de l&apos;origine de la carte, qui s&apos;étend sur %3 m</translation>
    </message>
    <message>
        <source>cannot be exported: its turns are not finite</source>
        <translation>ne peut pas être exporté : ses virages ne sont pas finis</translation>
    </message>
    <message>
        <source>the scenario cannot be planned</source>
        <translation>le scénario ne peut pas être planifié</translation>
    </message>
    <message>
        <source>this build was made without COIN-OR CBC</source>
        <translation>cette version a été compilée sans COIN-OR CBC</translation>
    </message>
    <message>
        <source>the back end cbc cannot plan for the policy latency</source>
        <translation>le solveur cbc ne peut pas planifier pour la stratégie latency</translation>
    </message>
    <message>
        <source>%1 is not flown by this version</source>
        <translation>%1 ne peut pas être exécuté par cette version</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>un tableau</translation>
    </message>
    <message>
        <source>a string</source>
        <translation>une chaîne</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>two numbers</source>
        <translation>deux nombres</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>des paires de nombres</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>no such file or folder</source>
        <translation>fichier ou dossier inexistant</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>aucune autorisation</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>c&apos;est un dossier</translation>
    </message>
    <message>
        <source>part of the path is no folder</source>
        <translation>une partie du chemin n&apos;est pas un dossier</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>the quota is used up</source>
        <translation>le quota est épuisé</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>le disque est en lecture seule</translation>
    </message>
    <message>
        <source>the disk is faulty</source>
        <translation>le disque est défectueux</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>le nom est trop long</translation>
    </message>
    <message>
        <source>the program bergwatch-cbc is not there: %1</source>
        <translation>le programme bergwatch-cbc est introuvable : %1</translation>
    </message>
    <message>
        <source>must be at least %1 for a run of this length and so many icebergs, not %2; %3 in the environment doubles the limits of reading</source>
        <translation>doit être au moins %1 pour un vol de cette durée et autant d&apos;icebergs, et non %2 ; %3 dans l&apos;environnement double les limites de lecture</translation>
    </message>
    <message>
        <source>with the policies would be %1 settings; at most %2 fit into one study: take several</source>
        <translation>donnerait, avec les stratégies, %1 réglages ; une étude en contient au plus %2 : prenez-en plusieurs</translation>
    </message>
    <message>
        <source>would be %1 missions; at most %2 fit into one study: take several</source>
        <translation>donnerait %1 missions ; une étude en contient au plus %2 : prenez-en plusieurs</translation>
    </message>
    <message>
        <source>names an iceberg, but the run holds none</source>
        <translation>nomme un iceberg, mais le vol n&apos;en contient aucun</translation>
    </message>
    <message>
        <source>is no airspace: not OpenAir, GeoJSON, KML, KMZ or CZML</source>
        <translation>n&apos;est pas un espace aérien : ni OpenAir, ni GeoJSON, KML, KMZ ou CZML</translation>
    </message>
    <message>
        <source>holds no airspace</source>
        <translation>ne contient aucun espace aérien</translation>
    </message>
    <message>
        <source>airspace left out: a place or an arc cannot be read</source>
        <translation>espace aérien omis : une position ou un arc est illisible</translation>
    </message>
    <message>
        <source>there is no folder %1</source>
        <translation>il n&apos;y a pas de dossier %1</translation>
    </message>
    <message>
        <source>%1 is no folder</source>
        <translation>%1 n&apos;est pas un dossier</translation>
    </message>
    <message>
        <source>is no folder</source>
        <translation>n&apos;est pas un dossier</translation>
    </message>
    <message>
        <source>cannot be made: %1</source>
        <translation>ne peut pas être créé : %1</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>n&apos;a pas pu être écrit</translation>
    </message>
    <message>
        <source>none of its %1 sightings could be taken; nothing written</source>
        <translation>aucune de ses %1 observations n&apos;a pu être reprise ; rien n&apos;a été écrit</translation>
    </message>
    <message>
        <source>dates such as %1 are read month first, which nothing in the file tells: --dates day-first or month-first says how</source>
        <translation>les dates telles que %1 sont lues mois d&apos;abord ; rien dans le fichier ne l&apos;indique : --dates day-first ou month-first le précise</translation>
    </message>
    <message>
        <source>differs: this is the file of another study (--replace-study replaces it)</source>
        <translation>diffère : c&apos;est le fichier d&apos;une autre étude (--replace-study le remplace)</translation>
    </message>
    <message>
        <source>was changed by another program: each shard needs a file of its own</source>
        <translation>a été modifié par un autre programme : chaque partie a besoin de son propre fichier</translation>
    </message>
    <message>
        <source>this plan solves no problem that could be verified or certified</source>
        <translation>ce plan ne résout aucun problème qui puisse être vérifié ou certifié</translation>
    </message>
    <message>
        <source>this build has no MPI (BERGWATCH_WITH_MPI): fly shards with --shard I/N</source>
        <translation>ce programme est compilé sans MPI (BERGWATCH_WITH_MPI) : jouez des parties avec --shard I/N</translation>
    </message>
    <message>
        <source>must be UTF-8 text</source>
        <translation>doit être du texte UTF-8</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>doit être un nombre fini</translation>
    </message>
    <message>
        <source>must be from %1 to %2, not %3</source>
        <translation>doit être de %1 à %2, et non %3</translation>
    </message>
    <message>
        <source>must be above %1 and at most %2, not %3</source>
        <translation>doit être supérieur à %1 et au plus %2, et non %3</translation>
    </message>
    <message>
        <source>must be a UTC date and time such as 2024-05-01T06:00:00Z</source>
        <translation>doit être une date et une heure UTC, par exemple 2024-05-01T06:00:00Z</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>ne doit pas être vide</translation>
    </message>
    <message>
        <source>must have from 2 to %1 entries, not %2</source>
        <translation>doit avoir de 2 à %1 valeurs, et non %2</translation>
    </message>
    <message>
        <source>must be later than the entry before</source>
        <translation>doit être postérieur à la valeur précédente</translation>
    </message>
    <message>
        <source>must be at most %1 where the endurance is limited, not %2</source>
        <translation>doit être au plus %1 si l&apos;autonomie est limitée, et non %2</translation>
    </message>
    <message>
        <source>must be inside the area, which is a geofence</source>
        <translation>doit se trouver dans la zone, qui est une barrière virtuelle</translation>
    </message>
    <message>
        <source>must be outside the no-fly area &quot;%1&quot;</source>
        <translation>doit se trouver hors de la zone interdite « %1 »</translation>
    </message>
    <message>
        <source>must be outside the stand-off ring round the asset</source>
        <translation>doit se trouver hors de l&apos;anneau de sécurité autour du bien protégé</translation>
    </message>
    <message>
        <source>drifts so fast that the UAV may not catch up with it</source>
        <translation>dérive si vite que le drone risque de ne pas le rattraper</translation>
    </message>
    <message>
        <source>with these drifts and a round of %1 minutes, %2 of %3 icebergs will be out of view at the next visit</source>
        <translation>avec ces dérives et un tour de %1 minutes, %2 icebergs sur %3 seront hors de vue à la visite suivante</translation>
    </message>
    <message>
        <source>is too short for the path home from the start</source>
        <translation>est insuffisante pour rentrer à la base depuis le départ</translation>
    </message>
    <message>
        <source>is used, without a limited endurance, only when you order a return or export with the return home</source>
        <translation>n&apos;est utilisé, sans autonomie limitée, que si vous ordonnez un retour ou exportez avec le retour à la base</translation>
    </message>
    <message>
        <source>is so near the geofence or a no-fly area that the UAV cannot take off there again and be sure to come home</source>
        <translation>est si proche de la barrière virtuelle ou d&apos;une zone interdite que le drone ne peut pas en redécoller en étant sûr de rentrer</translation>
    </message>
    <message>
        <source>this policy plans without geofence and no-fly areas; they are kept in flight</source>
        <translation>cette stratégie planifie sans barrière virtuelle ni zones interdites ; elles sont respectées en vol</translation>
    </message>
    <message>
        <source>the turn radius is larger than half the field of view, so that an iceberg may be missed</source>
        <translation>le rayon de virage dépasse la moitié du champ de vision ; un iceberg peut donc être manqué</translation>
    </message>
    <message>
        <source>is smaller than the turn radius, so that the UAV flies on and comes back</source>
        <translation>est inférieur au rayon de virage ; le drone continue donc et revient</translation>
    </message>
    <message>
        <source>is larger than half the field of view, so that icebergs count as reached that are not seen</source>
        <translation>dépasse la moitié du champ de vision ; des icebergs comptent donc comme atteints sans être vus</translation>
    </message>
    <message>
        <source>lies outside the area</source>
        <translation>se trouve hors de la zone</translation>
    </message>
    <message>
        <source>drifts out of the area before the end of the run</source>
        <translation>dérive hors de la zone avant la fin du vol</translation>
    </message>
    <message>
        <source>is over before the UAV can get to the first iceberg</source>
        <translation>se termine avant que le drone puisse atteindre le premier iceberg</translation>
    </message>
    <message>
        <source>drifts faster than icebergs do: is the unit right?</source>
        <translation>dérive plus vite que ne le font les icebergs : l&apos;unité est-elle correcte ?</translation>
    </message>
    <message>
        <source>no iceberg is uncertain at the start, so distance alone makes the first plan</source>
        <translation>aucun iceberg n&apos;est incertain au début ; la distance seule détermine donc le premier plan</translation>
    </message>
    <message>
        <source>proving the optimum of so many icebergs can take a minute and more</source>
        <translation>prouver l&apos;optimum pour autant d&apos;icebergs peut prendre une minute ou plus</translation>
    </message>
    <message>
        <source>the back end %1 proves plans of at most %2 icebergs; auto gives a plan and a bound</source>
        <translation>le solveur %1 prouve des plans de %2 icebergs au plus ; auto donne un plan et une borne</translation>
    </message>
    <message>
        <source>the back end exact proves latency plans of several UAVs for at most %1 icebergs</source>
        <translation>le solveur exact prouve les plans latency de plusieurs drones pour %1 icebergs au plus</translation>
    </message>
    <message>
        <source>the MILP formulation %1 is offered for at most %2 icebergs, not for %3</source>
        <translation>la formulation MILP %1 est proposée pour %2 icebergs au plus, pas pour %3</translation>
    </message>
    <message>
        <source>the column &quot;%1&quot; is not understood: rename it, or assign it with a mapping</source>
        <translation>la colonne « %1 » n&apos;est pas reconnue : renommez-la, ou associez-la</translation>
    </message>
    <message>
        <source>airspace left out: a height has no unit</source>
        <translation>espace aérien omis : une hauteur n&apos;a pas d&apos;unité</translation>
    </message>
    <message>
        <source>members that this version does not know are not used: &quot;%1&quot;</source>
        <translation>les membres que cette version ne connaît pas ne sont pas utilisés : « %1 »</translation>
    </message>
    <message>
        <source>feature %1</source>
        <translation>entité %1</translation>
    </message>
    <message>
        <source>packet %1</source>
        <translation>paquet %1</translation>
    </message>
    <message>
        <source>takes off in the dark, at %1 UTC: civil twilight begins at %2 UTC</source>
        <translation>décolle dans l&apos;obscurité, à %1 UTC : le crépuscule civil commence à %2 UTC</translation>
    </message>
    <message>
        <source>lands in the dark, at %1 UTC: civil twilight ends at %2 UTC</source>
        <translation>atterrit dans l&apos;obscurité, à %1 UTC : le crépuscule civil finit à %2 UTC</translation>
    </message>
    <message>
        <source>the time zone &quot;%1&quot; is a name: write offsets from UTC, such as +02:00</source>
        <translation>le fuseau horaire « %1 » est un nom : écrivez des décalages par rapport à UTC, comme +02:00</translation>
    </message>
    <message>
        <source>there is nothing on line %1 or below it</source>
        <translation>il n&apos;y a rien à la ligne %1 ni en dessous</translation>
    </message>
    <message>
        <source>nothing tells which rows are sightings of one iceberg: choose one of these</source>
        <translation>le fichier n&apos;indique pas quelles lignes sont des observations d&apos;un même iceberg : choisissez l&apos;une de ces options</translation>
    </message>
    <message>
        <source>icebergs: %1, greatest speed between two sightings: %2 m/s</source>
        <translation>icebergs : %1, vitesse maximale entre deux observations : %2 m/s</translation>
    </message>
    <message>
        <source>is faster than 1.5 m/s or on land: check columns, units and ids, or accept it with --accept-doubtful</source>
        <translation>est plus rapide que 1,5 m/s ou à terre : vérifiez les colonnes, les unités et les identifiants, ou acceptez-le avec --accept-doubtful</translation>
    </message>
    <message>
        <source>has several places: each is taken as an iceberg</source>
        <translation>a plusieurs positions : chacune compte comme un iceberg</translation>
    </message>
    <message>
        <source>has points beside lines or areas: only the points are taken</source>
        <translation>a des points à côté de lignes ou de surfaces : seuls les points sont pris</translation>
    </message>
    <message>
        <source>has areas beside lines: only the areas are taken</source>
        <translation>a des surfaces à côté de lignes : seules les surfaces sont prises</translation>
    </message>
    <message>
        <source>has points or areas beside a track: only the track is taken</source>
        <translation>a des points ou des surfaces à côté d&apos;une trace : seule la trace est prise</translation>
    </message>
    <message>
        <source>has the name of another track, but an iceberg cannot have drifted along both: it is taken as another iceberg</source>
        <translation>porte le nom d&apos;une autre trace, mais un iceberg ne peut pas avoir dérivé le long des deux : elle compte comme un autre iceberg</translation>
    </message>
    <message>
        <source>the property that names the iceberg is the same at two places at once: the ids of the features are taken instead</source>
        <translation>la propriété qui nomme l&apos;iceberg est la même à deux positions en même temps : les identifiants des objets sont utilisés à la place</translation>
    </message>
    <message>
        <source>has more times than places: the times left over are not taken</source>
        <translation>a plus d&apos;heures que de positions : les heures en trop ne sont pas utilisées</translation>
    </message>
    <message>
        <source>the place can be read in more than one way: decimals follow a point</source>
        <translation>la position peut être lue de plusieurs façons : les décimales suivent un point</translation>
    </message>
    <message>
        <source>coordinates are no degrees, and the file names no coordinate system: save it in WGS 84 (EPSG:4326)</source>
        <translation>les coordonnées ne sont pas en degrés, et le fichier ne nomme aucun système de coordonnées : enregistrez-le en WGS 84 (EPSG:4326)</translation>
    </message>
    <message>
        <source>coordinates look like degrees, but the file says they are metres: save it in WGS 84 (EPSG:4326)</source>
        <translation>les coordonnées ressemblent à des degrés, mais le fichier dit qu&apos;elles sont en mètres : enregistrez-le en WGS 84 (EPSG:4326)</translation>
    </message>
    <message>
        <source>the coordinate system &quot;%1&quot; is not known: save the file in WGS 84 (EPSG:4326)</source>
        <translation>le système de coordonnées « %1 » est inconnu : enregistrez le fichier en WGS 84 (EPSG:4326)</translation>
    </message>
    <message>
        <source>is not well-formed JSON</source>
        <translation>n&apos;est pas du JSON bien formé</translation>
    </message>
    <message>
        <source>links to another file, which is not read: import that file as well</source>
        <translation>renvoie à un autre fichier, qui n&apos;est pas lu : importez aussi ce fichier</translation>
    </message>
    <message>
        <source>the first document of the archive does not link to this one; it is read all the same</source>
        <translation>le premier document de l&apos;archive ne renvoie pas à celui-ci ; il est lu quand même</translation>
    </message>
    <message>
        <source>a document of the archive cannot be read</source>
        <translation>un document de l&apos;archive ne peut pas être lu</translation>
    </message>
    <message>
        <source>airspace left out: it has no outline</source>
        <translation>espace aérien omis : il n&apos;a pas de contour</translation>
    </message>
    <message>
        <source>outline left out: no airspace begins above it</source>
        <translation>contour omis : aucun espace aérien ne commence au-dessus</translation>
    </message>
    <message>
        <source>airspace left out: its outline encloses nothing</source>
        <translation>espace aérien omis : son contour n&apos;enferme rien</translation>
    </message>
    <message>
        <source>airspace left out: its ceiling is not above its floor</source>
        <translation>espace aérien omis : son plafond n&apos;est pas au-dessus de son plancher</translation>
    </message>
    <message>
        <source>airspace left out: it is farther than 100 km</source>
        <translation>espace aérien omis : il est à plus de 100 km</translation>
    </message>
    <message>
        <source>airspace left out: the scenario holds as many as it can</source>
        <translation>espace aérien omis : le scénario ne peut pas en contenir plus</translation>
    </message>
    <message>
        <source>airspace taken without a class</source>
        <translation>espace aérien repris sans classe</translation>
    </message>
    <message>
        <source>airspace taken down to the sea: its floor is missing or cannot be read</source>
        <translation>espace aérien repris jusqu&apos;à la mer : son plancher manque ou est illisible</translation>
    </message>
    <message>
        <source>airspace taken without end above: its ceiling is missing or cannot be read</source>
        <translation>espace aérien repris sans limite supérieure : son plafond manque ou est illisible</translation>
    </message>
    <message>
        <source>airspace taken with an outline round its own, which touches or crosses itself</source>
        <translation>espace aérien repris avec un contour plus grand : le sien se touche ou se croise</translation>
    </message>
    <message>
        <source>airspace taken with an outline round its own, which has too many corners</source>
        <translation>espace aérien repris avec un contour plus grand : le sien a trop de sommets</translation>
    </message>
    <message>
        <source>line not understood and not used</source>
        <translation>ligne non comprise et non utilisée</translation>
    </message>
    <message>
        <source>has no time, although other sightings of this iceberg have one</source>
        <translation>n&apos;a pas d&apos;heure, alors que d&apos;autres observations de cet iceberg en ont une</translation>
    </message>
    <message>
        <source>lies outside the chosen area</source>
        <translation>se trouve hors de la zone choisie</translation>
    </message>
    <message>
        <source>was sighted outside the chosen time</source>
        <translation>a été observé hors de la période choisie</translation>
    </message>
    <message>
        <source>taken without a value that cannot be read</source>
        <translation>pris sans une valeur illisible</translation>
    </message>
    <message>
        <source>taken without a number that is out of range</source>
        <translation>pris sans un nombre hors limites</translation>
    </message>
    <message>
        <source>a range, a limit or an estimate is read as one number</source>
        <translation>un intervalle, une limite ou une estimation est lu comme un seul nombre</translation>
    </message>
    <message>
        <source>taken without its time, which cannot be read</source>
        <translation>pris sans son heure, qui est illisible</translation>
    </message>
    <message>
        <source>taken without a time, which it does not have</source>
        <translation>pris sans heure, car elle manque</translation>
    </message>
    <message>
        <source>taken without its time, which is years from all others</source>
        <translation>pris sans son heure, qui est à des années de toutes les autres</translation>
    </message>
    <message>
        <source>its time is moved by 1024 weeks, as a GPS clock has lost count of them</source>
        <translation>son heure est déplacée de 1024 semaines, car une horloge GPS en a perdu le compte</translation>
    </message>
    <message>
        <source>its id is too long and is shortened</source>
        <translation>son identifiant est trop long et a été raccourci</translation>
    </message>
    <message>
        <source>the wind must be two finite numbers</source>
        <translation>le vent doit être donné par deux nombres finis</translation>
    </message>
    <message>
        <source>the area must have from 3 to %1 corners, not %2</source>
        <translation>la zone doit avoir de 3 à %1 sommets, et non %2</translation>
    </message>
    <message>
        <source>the area must neither touch nor cross itself</source>
        <translation>la zone ne doit ni se toucher ni se croiser elle-même</translation>
    </message>
    <message>
        <source>a scenario holds at most %1 no-fly areas, not %2</source>
        <translation>un scénario contient au plus %1 zones interdites, et non %2</translation>
    </message>
    <message>
        <source>a scenario holds at most %1 airspace areas, not %2</source>
        <translation>un scénario contient au plus %1 zones d&apos;espace aérien, et non %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the id of %2 already: each iceberg and UAV needs a unique id</source>
        <translation>« %1 » est déjà l&apos;identifiant de %2 : chaque iceberg et chaque drone a besoin d&apos;un identifiant unique</translation>
    </message>
    <message>
        <source>a scenario holds from 1 to %1 UAVs, not %2</source>
        <translation>un scénario contient de 1 à %1 drones, et non %2</translation>
    </message>
    <message>
        <source>a scenario holds at most %1 icebergs, not %2</source>
        <translation>un scénario contient au plus %1 icebergs, et non %2</translation>
    </message>
    <message>
        <source>must have one entry for each of the %1 times, not %2</source>
        <translation>doit avoir une valeur pour chacun des %1 instants, et non %2</translation>
    </message>
    <message>
        <source>there are %1 more errors</source>
        <translation>il y a %1 erreurs de plus</translation>
    </message>
    <message>
        <source>must not be longer than the run</source>
        <translation>ne doit pas dépasser la durée du vol</translation>
    </message>
    <message>
        <source>needs an area to stay inside</source>
        <translation>a besoin d&apos;une zone dans laquelle rester</translation>
    </message>
    <message>
        <source>a geofence has at most %1 corners, not %2</source>
        <translation>une barrière virtuelle a au plus %1 sommets, et non %2</translation>
    </message>
    <message>
        <source>with the geofence and the stand-off ring, the no-fly areas at the altitude of a UAV have at most %1 corners, not %2</source>
        <translation>avec la barrière virtuelle et l&apos;anneau de sécurité, les zones interdites à l&apos;altitude d&apos;un drone ont au plus %1 sommets, et non %2</translation>
    </message>
    <message>
        <source>there is no UAV &quot;%1&quot; in this scenario</source>
        <translation>il n&apos;y a pas de drone « %1 » dans ce scénario</translation>
    </message>
    <message>
        <source>the wind must be slower than the UAV flies: wind of %1, airspeed of %2 %3</source>
        <translation>le vent doit être plus lent que le drone : vent de %1, vitesse air de %2 %3</translation>
    </message>
    <message>
        <source>the UAV will make little headway in this wind: wind of %1, airspeed of %2 %3</source>
        <translation>le drone progressera peu dans ce vent : vent de %1, vitesse air de %2 %3</translation>
    </message>
    <message>
        <source>must not be shorter than the time step</source>
        <translation>ne doit pas être inférieur au pas de temps</translation>
    </message>
    <message>
        <source>must be above the floor of %1, not %2</source>
        <translation>doit être au-dessus du plancher de %1, et non %2</translation>
    </message>
    <message>
        <source>the airspace &quot;%1&quot; ends before it begins</source>
        <translation>l&apos;espace aérien « %1 » finit avant de commencer</translation>
    </message>
    <message>
        <source>must be longer than reserve, climb and landing together, %2, not %1</source>
        <translation>doit être plus long que la réserve, la montée et l&apos;atterrissage ensemble, %2, et non %1</translation>
    </message>
    <message>
        <source>there are no icebergs yet, so there is nothing to plan</source>
        <translation>il n&apos;y a pas encore d&apos;icebergs ; il n&apos;y a donc rien à planifier</translation>
    </message>
    <message>
        <source>is after the end of the run, so the iceberg is never planned</source>
        <translation>est après la fin du vol ; l&apos;iceberg n&apos;est donc jamais planifié</translation>
    </message>
    <message>
        <source>icebergs outside the area are not monitored; the UAV may fly beyond it</source>
        <translation>les icebergs hors de la zone ne sont pas surveillés ; le drone peut voler au-delà</translation>
    </message>
    <message>
        <source>is used in flight only with the Kalman filter</source>
        <translation>n&apos;est utilisé en vol qu&apos;avec le filtre de Kalman</translation>
    </message>
    <message>
        <source>another UAV of this altitude layer starts so near that they fly apart first; let their altitudes differ by %1</source>
        <translation>un autre drone de cette tranche d&apos;altitude part si près qu&apos;ils s&apos;écartent d&apos;abord ; séparez leurs altitudes de %1</translation>
    </message>
    <message>
        <source>is too short to reach the nearest iceberg and return</source>
        <translation>est trop courte pour atteindre l&apos;iceberg le plus proche et revenir</translation>
    </message>
    <message>
        <source>for its heading, the UAV has no path home inside the geofence and outside no-fly areas from where it starts: no start is safe</source>
        <translation>compte tenu de son cap, le drone n&apos;a depuis son point de départ aucun trajet vers la base à l&apos;intérieur de la barrière virtuelle et hors des zones interdites : aucun départ n&apos;est sûr</translation>
    </message>
    <message>
        <source>the UAV starts so near the geofence or a no-fly area, for its heading, that it cannot turn in time</source>
        <translation>compte tenu de son cap, le drone part si près de la barrière virtuelle ou d&apos;une zone interdite qu&apos;il ne peut pas virer à temps</translation>
    </message>
    <message>
        <source>is so near the geofence, or in a no-fly area, that the UAV cannot come as near as it has to</source>
        <translation>est si près de la barrière virtuelle, ou dans une zone interdite, que le drone ne peut pas s&apos;en approcher autant qu&apos;il le doit</translation>
    </message>
    <message>
        <source>the time between two commands is too long for the UAV to follow a leg</source>
        <translation>le temps entre deux commandes est trop long pour que le drone suive un segment</translation>
    </message>
    <message>
        <source>must not be exceeded: wind of %1, limit %2</source>
        <translation>ne doit pas être dépassée : vent de %1, limite %2</translation>
    </message>
    <message>
        <source>must not be exceeded: gusts of %1, limit %2</source>
        <translation>ne doit pas être dépassée : rafales de %1, limite %2</translation>
    </message>
    <message>
        <source>this weather brings icing at its altitude, in which the UAV must not be flown</source>
        <translation>cette météo apporte du givrage à l&apos;altitude du drone, qui ne doit pas y voler</translation>
    </message>
    <message>
        <source>leaves less reserve than waiting for the other UAVs of the altitude layer may take, %1; separate altitudes, or a greater reserve, avoid it</source>
        <translation>laisse moins de réserve que l&apos;attente des autres drones de la tranche d&apos;altitude ne peut en prendre, %1 ; des altitudes différentes ou une plus grande réserve l&apos;évitent</translation>
    </message>
    <message>
        <source>keeps %1 free for a recovery slot, as other UAVs of the altitude layer land on the same pad; separate altitudes or pads avoid it</source>
        <translation>garde %1 libre pour un créneau d&apos;atterrissage, car d&apos;autres drones de la tranche d&apos;altitude atterrissent sur la même aire ; des altitudes ou des aires différentes l&apos;évitent</translation>
    </message>
    <message>
        <source>with the usual errors in wind and airspeed, 1 flight in 20 uses %1 or more of the reserve to come home</source>
        <translation>avec les erreurs habituelles du vent et de la vitesse air, 1 vol sur 20 utilise %1 ou plus de la réserve pour rentrer à la base</translation>
    </message>
    <message>
        <source>with the usual errors in wind and airspeed, in 1 flight in 20 the wind is too strong to come home</source>
        <translation>avec les erreurs habituelles du vent et de la vitesse air, le vent est trop fort pour rentrer à la base dans 1 vol sur 20</translation>
    </message>
    <message>
        <source>the plan leads out of the range of the ground station for %1</source>
        <translation>le plan sort de la portée de la station sol pendant %1</translation>
    </message>
    <message>
        <source>the operation may enter the airspace &quot;%1&quot;, which begins at %2</source>
        <translation>l&apos;opération peut entrer dans l&apos;espace aérien « %1 », qui commence à %2</translation>
    </message>
    <message>
        <source>starts outside the area</source>
        <translation>part de l&apos;extérieur de la zone</translation>
    </message>
    <message>
        <source>lies where another iceberg lies: is it the same one?</source>
        <translation>se trouve à la position d&apos;un autre iceberg : est-ce le même ?</translation>
    </message>
    <message>
        <source>is too far away to reach before the run ends</source>
        <translation>est trop loin pour être atteint avant la fin du vol</translation>
    </message>
    <message>
        <source>the recorded track ends before the run does; from then on the iceberg stands still</source>
        <translation>la trace enregistrée se termine avant le vol ; l&apos;iceberg reste ensuite immobile</translation>
    </message>
    <message>
        <source>the recorded track begins so far from the estimate that the UAV will not see the iceberg there</source>
        <translation>la trace enregistrée commence si loin de l&apos;estimation que le drone n&apos;y verra pas l&apos;iceberg</translation>
    </message>
    <message>
        <source>the asset lies inside an iceberg</source>
        <translation>le bien protégé se trouve à l&apos;intérieur d&apos;un iceberg</translation>
    </message>
    <message>
        <source>more icebergs than can be proven optimal; the plan comes with a bound</source>
        <translation>trop d&apos;icebergs pour prouver l&apos;optimum ; le plan est accompagné d&apos;une borne</translation>
    </message>
    <message>
        <source>this policy plans icebergs one by one; nearby icebergs are not grouped</source>
        <translation>cette stratégie planifie les icebergs un par un ; les icebergs proches ne sont pas groupés</translation>
    </message>
    <message>
        <source>this solver cannot plan so many icebergs: choose Automatic (auto)</source>
        <translation>ce solveur ne peut pas planifier autant d&apos;icebergs : choisissez Automatique (auto)</translation>
    </message>
    <message>
        <source>is of no format that Bergwatch recognises; if it is a table, name its columns for latitude and longitude; known formats: %1</source>
        <translation>n&apos;est dans aucun format que Bergwatch reconnaît ; si c&apos;est un tableau, indiquez ses colonnes de latitude et de longitude ; formats connus : %1</translation>
    </message>
    <message>
        <source>latitude must be between -90 and 90, minutes below 60</source>
        <translation>la latitude doit être de -90 à 90, les minutes inférieures à 60</translation>
    </message>
    <message>
        <source>longitude must be between -180 and 360, minutes below 60</source>
        <translation>la longitude doit être de -180 à 360, les minutes inférieures à 60</translation>
    </message>
    <message>
        <source>iceberg %1</source>
        <translation>iceberg %1</translation>
    </message>
    <message>
        <source>UAV %1</source>
        <translation>Drone %1</translation>
    </message>
    <message>
        <source>%1 h before the start; the iceberg may be %2 from this position, %3 times the field of view</source>
        <translation>%1 h avant le début ; l&apos;iceberg peut être à %2 de cette position, %3 fois le champ de vision</translation>
    </message>
    <message>
        <source>a file holds one UAV: %1 files are written, named after the UAVs</source>
        <translation>un fichier contient un seul drone : %1 fichiers sont écrits, nommés d&apos;après les drones</translation>
    </message>
    <message>
        <source>the scenario has no start time, so the file has no dates</source>
        <translation>le scénario n&apos;a pas d&apos;heure de début ; le fichier n&apos;a donc pas de dates</translation>
    </message>
    <message>
        <source>the geofence is left out: the format has no place for it</source>
        <translation>la barrière virtuelle est omise : le format ne la prévoit pas</translation>
    </message>
    <message>
        <source>no-fly areas and the stand-off ring are left out: the format has no place for them</source>
        <translation>les zones interdites et l&apos;anneau de sécurité sont omis : le format ne les prévoit pas</translation>
    </message>
    <message>
        <source>no-fly areas have no heights: those at the altitude of the UAV are written</source>
        <translation>les zones interdites n&apos;ont pas de hauteurs : celles à l&apos;altitude du drone sont écrites</translation>
    </message>
    <message>
        <source>%1 may draw the fence the long way round: it crosses the antimeridian</source>
        <translation>%1 peut tracer la barrière en faisant le tour du globe : elle franchit l&apos;antiméridien</translation>
    </message>
    <message>
        <source>the places where icebergs were reached are written, not the track</source>
        <translation>les lieux où les icebergs ont été atteints sont écrits, pas la trace</translation>
    </message>
    <message>
        <source>the path becomes %1 waypoints within %2 m of it</source>
        <translation>la trajectoire devient %1 points de cheminement à moins de %2 m d&apos;elle</translation>
    </message>
    <message>
        <source>%1 keeps acceptance radii up to %3 m: %2 m becomes %3 m</source>
        <translation>%1 conserve les rayons d&apos;acceptation jusqu&apos;à %3 m : %2 m devient %3 m</translation>
    </message>
    <message>
        <source>%1 keeps loiter radii above 255 m in steps of 10 m: %2 m becomes %3 m</source>
        <translation>%1 conserve les rayons d&apos;attente supérieurs à 255 m par pas de 10 m : %2 m devient %3 m</translation>
    </message>
    <message>
        <source>%1 reads the cruise speed as a whole number: %2 m/s becomes %3 m/s; the speed in the mission is exact</source>
        <translation>%1 lit la vitesse de croisière en nombre entier : %2 m/s devient %3 m/s ; la vitesse dans la mission est exacte</translation>
    </message>
    <message>
        <source>the file is about the whole flight, whatever is chosen to be exported</source>
        <translation>le fichier porte sur tout le vol, quoi que vous choisissiez d&apos;exporter</translation>
    </message>
    <message>
        <source>UAVs without an iceberg to visit: %1</source>
        <translation>Drones sans iceberg à visiter : %1</translation>
    </message>
    <message>
        <source>straight legs that lead out of the geofence or through a no-fly area: %1; export the path instead, which leads round</source>
        <translation>segments droits qui sortent de la barrière virtuelle ou traversent une zone interdite : %1 ; exportez plutôt la trajectoire, qui les contourne</translation>
    </message>
    <message>
        <source>only this sortie is exported; icebergs left for later sorties: %1</source>
        <translation>seule cette sortie est exportée ; icebergs laissés aux sorties suivantes : %1</translation>
    </message>
    <message>
        <source>nothing in the file depends on %1</source>
        <translation>rien dans le fichier ne dépend de %1</translation>
    </message>
    <message>
        <source>velocity unknown</source>
        <translation>vitesse inconnue</translation>
    </message>
    <message>
        <source>no time: counts as seen at the start</source>
        <translation>sans heure : compte comme vu au départ</translation>
    </message>
    <message>
        <source>velocity from the file</source>
        <translation>vitesse tirée du fichier</translation>
    </message>
    <message>
        <source>velocity limited to 5 m/s per axis</source>
        <translation>vitesse limitée à 5 m/s par axe</translation>
    </message>
    <message>
        <source>q estimated</source>
        <translation>q estimé</translation>
    </message>
    <message>
        <source>q limited to 10⁶ m²/s</source>
        <translation>q limité à 10⁶ m²/s</translation>
    </message>
    <message>
        <source>stationary</source>
        <translation>stationnaire</translation>
    </message>
    <message>
        <source>several sightings at one time</source>
        <translation>plusieurs observations au même instant</translation>
    </message>
    <message>
        <source>sightings at impossible places not used</source>
        <translation>observations en des lieux impossibles, non utilisées</translation>
    </message>
    <message>
        <source>recorded track attached</source>
        <translation>trace enregistrée ajoutée</translation>
    </message>
    <message>
        <source>no track: not sighted after the start</source>
        <translation>aucune trace : pas observé après le début</translation>
    </message>
    <message>
        <source>older than what the scenario has</source>
        <translation>plus ancien que ce que contient le scénario</translation>
    </message>
    <message>
        <source>sighted only after the start</source>
        <translation>observé seulement après le début</translation>
    </message>
    <message>
        <source>more than 1000 km from the origin at the start</source>
        <translation>à plus de 1000 km de l&apos;origine au début</translation>
    </message>
    <message>
        <source>the scenario is full</source>
        <translation>le scénario est plein</translation>
    </message>
    <message>
        <source>a UAV has this id</source>
        <translation>un drone a cet identifiant</translation>
    </message>
    <message>
        <source>the file&apos;s drift contradicts the positions: not used</source>
        <translation>la dérive du fichier contredit les positions : ignorée</translation>
    </message>
    <message>
        <source>faster than 1.5 m/s</source>
        <translation>plus rapide que 1,5 m/s</translation>
    </message>
    <message>
        <source>on land</source>
        <translation>à terre</translation>
    </message>
    <message numerus="yes">
        <source>%n UAV(s) taken over</source>
        <translation>
            <numerusform>%n drone repris</numerusform>
            <numerusform>%n drones repris</numerusform>
        </translation>
    </message>
    <message>
        <source>area taken over</source>
        <translation>zone reprise</translation>
    </message>
    <message>
        <source>area taken over as geofence</source>
        <translation>zone reprise comme barrière virtuelle</translation>
    </message>
    <message>
        <source>asset taken over</source>
        <translation>bien protégé repris</translation>
    </message>
    <message numerus="yes">
        <source>%n no-fly area(s) taken over</source>
        <translation>
            <numerusform>%n zone interdite reprise</numerusform>
            <numerusform>%n zones interdites reprises</numerusform>
        </translation>
    </message>
    <message>
        <source>UAVs, area and asset of the file not taken over: the scenario is in use</source>
        <translation>drones, zone et bien protégé du fichier non repris : le scénario est en cours d&apos;utilisation</translation>
    </message>
    <message numerus="yes">
        <source>%n UAV(s) left out: too many</source>
        <translation>
            <numerusform>%n drone omis : trop nombreux</numerusform>
            <numerusform>%n drones omis : trop nombreux</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n UAV(s) left out: more than 1000 km east, west, north or south of the origin</source>
        <translation>
            <numerusform>%n drone omis : à plus de 1000 km à l&apos;est, à l&apos;ouest, au nord ou au sud de l&apos;origine</numerusform>
            <numerusform>%n drones omis : à plus de 1000 km à l&apos;est, à l&apos;ouest, au nord ou au sud de l&apos;origine</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n area(s) left out: unreadable</source>
        <translation>
            <numerusform>%n zone omise : illisible</numerusform>
            <numerusform>%n zones omises : illisibles</numerusform>
        </translation>
    </message>
    <message>
        <source>area left out: too few or too many corners</source>
        <translation>zone omise : trop peu ou trop de sommets</translation>
    </message>
    <message>
        <source>area left out: more than 1000 km east, west, north or south of the origin</source>
        <translation>zone omise : à plus de 1000 km à l&apos;est, à l&apos;ouest, au nord ou au sud de l&apos;origine</translation>
    </message>
    <message>
        <source>area left out: it touches or crosses itself</source>
        <translation>zone omise : elle se touche ou se croise elle-même</translation>
    </message>
    <message>
        <source>area left out: it is in several parts</source>
        <translation>zone omise : elle est en plusieurs parties</translation>
    </message>
    <message numerus="yes">
        <source>%n further area(s) left out</source>
        <translation>
            <numerusform>%n autre zone omise</numerusform>
            <numerusform>%n autres zones omises</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s) of the area left out</source>
        <translation>
            <numerusform>%n trou de la zone omis</numerusform>
            <numerusform>%n trous de la zone omis</numerusform>
        </translation>
    </message>
    <message>
        <source>area is no geofence: too many corners</source>
        <translation>la zone n&apos;est pas une barrière virtuelle : trop de sommets</translation>
    </message>
    <message>
        <source>area is no geofence: a UAV starts or lands outside</source>
        <translation>la zone n&apos;est pas une barrière virtuelle : un drone part ou atterrit à l&apos;extérieur</translation>
    </message>
    <message numerus="yes">
        <source>%n no-fly area(s) left out: a UAV starts or lands inside, or the heights are wrong</source>
        <translation>
            <numerusform>%n zone interdite omise : un drone y part ou y atterrit, ou les hauteurs sont fausses</numerusform>
            <numerusform>%n zones interdites omises : un drone y part ou y atterrit, ou les hauteurs sont fausses</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rally point(s) left out</source>
        <translation>
            <numerusform>%n point de ralliement omis</numerusform>
            <numerusform>%n points de ralliement omis</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n further asset(s) left out</source>
        <translation>
            <numerusform>%n autre bien protégé omis</numerusform>
            <numerusform>%n autres biens protégés omis</numerusform>
        </translation>
    </message>
    <message>
        <source>asset left out: more than 1000 km east, west, north or south of the origin</source>
        <translation>bien protégé omis : à plus de 1000 km à l&apos;est, à l&apos;ouest, au nord ou au sud de l&apos;origine</translation>
    </message>
    <message numerus="yes">
        <source>%n number(s) out of range left out</source>
        <translation>
            <numerusform>%n nombre hors limites omis</numerusform>
            <numerusform>%n nombres hors limites omis</numerusform>
        </translation>
    </message>
    <message>
        <source>there is no take-off item: launch the UAV by hand and start the mission in the air</source>
        <translation>il n&apos;y a pas d&apos;élément de décollage : lancez le drone à la main et démarrez la mission en vol</translation>
    </message>
    <message>
        <source>after the last iceberg the mission returns home, %1 m that the plan does not include</source>
        <translation>après le dernier iceberg, la mission rentre à la base, %1 m que le plan ne comprend pas</translation>
    </message>
    <message>
        <source>the mission ends in an endless loiter: command the return yourself</source>
        <translation>la mission se termine par une attente sans fin : commandez vous-même le retour</translation>
    </message>
    <message>
        <source>%1 has no loiter by turns: the time that they take is written</source>
        <translation>%1 ne compte pas les tours d&apos;attente : le fichier contient leur durée</translation>
    </message>
    <message>
        <source>loiter turns are left out: a VTOL or multirotor flies over each iceberg</source>
        <translation>les tours d&apos;attente sont omis : un ADAV ou un multirotor survole chaque iceberg</translation>
    </message>
    <message>
        <source>%1 uses the acceptance radius of its parameter %2, not that of the file</source>
        <translation>%1 utilise le rayon d&apos;acceptation de son paramètre %2, pas celui du fichier</translation>
    </message>
    <message>
        <source>%1 keeps to the fence only if its parameter %2 says so</source>
        <translation>%1 ne respecte la barrière que si son paramètre %2 le demande</translation>
    </message>
    <message>
        <source>the first row is home, which %1 does not have: upload the file with QGroundControl</source>
        <translation>la première ligne est la base, que %1 n&apos;a pas : chargez le fichier avec QGroundControl</translation>
    </message>
    <message>
        <source>the first iceberg is %2 m from the start, but the climb takes %1 m</source>
        <translation>le premier iceberg est à %2 m du départ, mais la montée prend %1 m</translation>
    </message>
    <message>
        <source>the first iceberg is %2 m from the start: %1 may refuse more than %3 m (MIS_DIST_1WP)</source>
        <translation>le premier iceberg est à %2 m du départ : %1 peut refuser plus de %3 m (MIS_DIST_1WP)</translation>
    </message>
    <message>
        <source>legs of take-off, return and landing that lead out of the geofence or through a no-fly area: %1</source>
        <translation>segments de décollage, de retour et d&apos;atterrissage qui sortent de la barrière virtuelle ou traversent une zone interdite : %1</translation>
    </message>
    <message>
        <source>the landing approach leads over land</source>
        <translation>l&apos;approche survole la terre</translation>
    </message>
    <message>
        <source>the landing approach descends at %1°, more than the usual %2°: make it longer or lower</source>
        <translation>l&apos;approche descend à %1°, plus que les %2° habituels : allongez-la ou abaissez-la</translation>
    </message>
    <message>
        <source>waypoints within their acceptance radius of the one before, which the UAV may skip: %1</source>
        <translation>points de cheminement à moins de leur rayon d&apos;acceptation du précédent, que le drone peut sauter : %1</translation>
    </message>
    <message>
        <source>the mission has %2 items; %1 holds about %3</source>
        <translation>la mission a %2 éléments ; %1 en contient environ %3</translation>
    </message>
    <message>
        <source>airspace areas that the mission enters at its altitudes: %1</source>
        <translation>espaces aériens dans lesquels la mission entre à ses altitudes : %1</translation>
    </message>
    <message>
        <source>with climb, return and landing the mission takes %1 min; the endurance without reserve is %2 min</source>
        <translation>avec montée, retour et atterrissage, la mission prend %1 min ; l&apos;autonomie sans réserve est de %2 min</translation>
    </message>
    <message>
        <source>%1 is no link: write udp:HOST:PORT to listen, udpout:HOST:PORT, tcp:HOST:PORT or serial:DEVICE:BAUD</source>
        <translation>%1 n&apos;est pas une liaison : écrivez udp:HÔTE:PORT pour écouter, udpout:HÔTE:PORT, tcp:HÔTE:PORT ou serial:PÉRIPHÉRIQUE:BAUD</translation>
    </message>
    <message>
        <source>%1 has no host: write an IPv4 address or a name</source>
        <translation>%1 n&apos;a pas d&apos;hôte : écrivez une adresse IPv4 ou un nom</translation>
    </message>
    <message>
        <source>%1 has no port from 1 to 65535</source>
        <translation>%1 n&apos;a pas de port de 1 à 65535</translation>
    </message>
    <message>
        <source>%1 has no device: write a path such as /dev/ttyUSB0</source>
        <translation>%1 n&apos;a pas de périphérique : écrivez un chemin tel que /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>%1 has no baud rate of a serial port, such as 57600 or 115200</source>
        <translation>%1 n&apos;a pas de débit de port série, tel que 57600 ou 115200</translation>
    </message>
    <message>
        <source>only %1 of %2 icebergs found a place at least %3 from the others: choose fewer icebergs, a smaller spacing or a larger area</source>
        <translation>seuls %1 icebergs sur %2 ont trouvé une place à au moins %3 des autres : choisissez moins d&apos;icebergs, un espacement plus petit ou une zone plus grande</translation>
    </message>
    <message>
        <source>a forecast holds from 1 to %1 places, not %2</source>
        <translation>une prévision comporte de 1 à %1 lieux, pas %2</translation>
    </message>
    <message>
        <source>a forecast holds at most %1 entries at all places together, not %2</source>
        <translation>une prévision comporte au plus %1 entrées pour tous les lieux ensemble, pas %2</translation>
    </message>
    <message>
        <source>the places must be a complete grid: rows from south to north, each from west to east</source>
        <translation>les lieux doivent former une grille complète : des lignes du sud au nord, chacune d&apos;ouest en est</translation>
    </message>
    <message>
        <source>must have at least one entry</source>
        <translation>doit avoir au moins une entrée</translation>
    </message>
    <message>
        <source>a scenario with a forecast needs a start date and time</source>
        <translation>un scénario avec prévision a besoin d&apos;une date et d&apos;une heure de début</translation>
    </message>
    <message>
        <source>gives no %1 for %2 h of the run: the constant value of the scenario applies</source>
        <translation>ne donne pas de valeur (%1) pendant %2 h : la valeur constante du scénario s&apos;applique</translation>
    </message>
    <message>
        <source>has a gap in %1 from %2 h to %3 h after the start: the constant value of the scenario applies</source>
        <translation>a une lacune (%1) de %2 h à %3 h après le début : la valeur constante du scénario s&apos;applique</translation>
    </message>
    <message>
        <source>was issued %1 h before the start</source>
        <translation>a été émise %1 h avant le début</translation>
    </message>
    <message>
        <source>this build reads no %1: install %2 and build Bergwatch again</source>
        <translation>cette version ne lit pas %1 : installez %2 et recompilez Bergwatch</translation>
    </message>
    <message>
        <source>is GRIB of edition %1; only edition 2 is read: convert it with grib_set -s edition=2</source>
        <translation>est du GRIB d&apos;édition %1 ; seule l&apos;édition 2 est lue : convertissez-le avec grib_set -s edition=2</translation>
    </message>
    <message>
        <source>holds no wind, weather or current on a grid of latitudes and longitudes</source>
        <translation>ne contient ni vent, ni météo, ni courant sur une grille de latitudes et de longitudes</translation>
    </message>
    <message>
        <source>the unit &quot;%1&quot; is not understood; it must be one of %2</source>
        <translation>l&apos;unité « %1 » n&apos;est pas comprise ; elle doit être l&apos;une de %2</translation>
    </message>
    <message>
        <source>the unit of time &quot;%1&quot; in the calendar &quot;%2&quot; is not understood</source>
        <translation>l&apos;unité de temps « %1 » du calendrier « %2 » n&apos;est pas comprise</translation>
    </message>
    <message>
        <source>the forecast covers 180 degrees or more: choose an area</source>
        <translation>la prévision couvre 180 degrés ou plus : choisissez une zone</translation>
    </message>
    <message>
        <source>the forecast has no values in the area</source>
        <translation>la prévision n&apos;a pas de valeurs dans la zone</translation>
    </message>
    <message>
        <source>the forecast is for another time, from %1 to %2</source>
        <translation>la prévision est pour une autre période, de %1 à %2</translation>
    </message>
    <message>
        <source>is no NMEA sentence</source>
        <translation>n&apos;est pas une phrase NMEA</translation>
    </message>
    <message>
        <source>its checksum is wrong or missing</source>
        <translation>sa somme de contrôle est fausse ou absente</translation>
    </message>
    <message>
        <source>a field of the sentence is missing or wrong</source>
        <translation>un champ de la phrase manque ou est faux</translation>
    </message>
    <message>
        <source>the AIS message is cut or wrong</source>
        <translation>le message AIS est tronqué ou faux</translation>
    </message>
    <message>
        <source>another part of the AIS message is missing or out of order</source>
        <translation>une autre partie du message AIS manque ou n&apos;est pas à sa place</translation>
    </message>
    <message>
        <source>a radar bearing needs the ship&apos;s position within the minute before, and a relative one its heading</source>
        <translation>un relèvement radar demande la position du navire dans la minute qui précède, et son cap s&apos;il est relatif</translation>
    </message>
    <message>
        <source>the radar target is a ship that reports by AIS</source>
        <translation>la cible radar est un navire signalé par l&apos;AIS</translation>
    </message>
    <message>
        <source>the data of the photograph cannot be read</source>
        <translation>les données de la photographie sont illisibles</translation>
    </message>
    <message>
        <source>the photograph has no position; with its time, --run places it on the flown track</source>
        <translation>la photographie n&apos;a pas de position ; avec son heure, --run la place sur la trace volée</translation>
    </message>
    <message>
        <source>the photograph has no position, and its time is not in the flight</source>
        <translation>la photographie n&apos;a pas de position, et son heure est hors du vol</translation>
    </message>
    <message>
        <source>this build reads no photographs: it was made without libexiv2</source>
        <translation>cette version ne lit pas les photographies : elle a été compilée sans libexiv2</translation>
    </message>
    <message>
        <source>sightings for an ice service need dates: give the scenario a start time</source>
        <translation>les observations pour un service des glaces demandent des dates : donnez une heure de départ au scénario</translation>
    </message>
    <message>
        <source>photograph %1</source>
        <translation>photographie %1</translation>
    </message>
    <message>
        <source>an ice chart holds at most %1 areas, not %2</source>
        <translation>une carte des glaces contient au plus %1 zones, et non %2</translation>
    </message>
    <message>
        <source>the outlines of an ice chart hold at most %1 corners together, not %2</source>
        <translation>les contours d&apos;une carte des glaces ont au plus %1 sommets en tout, et non %2</translation>
    </message>
    <message>
        <source>an ice area needs outlines of at least 3 corners</source>
        <translation>une zone de glace a besoin de contours d&apos;au moins 3 sommets</translation>
    </message>
    <message>
        <source>the ice chart is %1 hours older than the start: ice has moved since</source>
        <translation>la carte des glaces a %1 heures de plus que le départ : la glace s&apos;est déplacée depuis</translation>
    </message>
    <message>
        <source>is no ice chart: it has no polygons with concentrations (CT, POLY_TYPE of SIGRID-3)</source>
        <translation>n&apos;est pas une carte des glaces : il n&apos;y a pas de polygones avec des concentrations (CT, POLY_TYPE de SIGRID-3)</translation>
    </message>
    <message>
        <source>holds no ice-chart area within %1 km of the scenario</source>
        <translation>ne contient aucune zone de glace à moins de %1 km du scénario</translation>
    </message>
    <message>
        <source>is read with ogr2ogr: install gdal-bin</source>
        <translation>est lu avec ogr2ogr : installez gdal-bin</translation>
    </message>
    <message>
        <source>is written with ogr2ogr: install gdal-bin</source>
        <translation>est écrit avec ogr2ogr : installez gdal-bin</translation>
    </message>
    <message>
        <source>ogr2ogr reports: %1</source>
        <translation>ogr2ogr signale : %1</translation>
    </message>
    <message>
        <source>ogr2ogr failed without a reason (%1)</source>
        <translation>ogr2ogr a échoué sans donner de raison (%1)</translation>
    </message>
    <message>
        <source>ogr2ogr was stopped after %1 s</source>
        <translation>ogr2ogr a été arrêté après %1 s</translation>
    </message>
    <message>
        <source>ogr2ogr did not print GeoJSON</source>
        <translation>ogr2ogr n&apos;a pas produit de GeoJSON</translation>
    </message>
    <message>
        <source>holds no features</source>
        <translation>ne contient aucun objet</translation>
    </message>
    <message>
        <source>the archive holds several files that ogr2ogr can read: %1; unpack the one that you need</source>
        <translation>l&apos;archive contient plusieurs fichiers qu&apos;ogr2ogr peut lire : %1 ; décompressez celui dont vous avez besoin</translation>
    </message>
    <message>
        <source>ice area left out: its outline cannot be read</source>
        <translation>zone de glace omise : son contour est illisible</translation>
    </message>
    <message>
        <source>the times along paths and tracks are left out: the format has no place for them</source>
        <translation>les heures le long des trajectoires et des traces sont omises : le format n&apos;a pas de place pour elles</translation>
    </message>
    <message>
        <source>there is a Shapefile each for points, lines and areas; names of properties are cut to 10 letters, texts to 254 bytes</source>
        <translation>il y a un Shapefile pour les points, un pour les lignes et un pour les zones ; les noms des propriétés sont coupés à 10 lettres, les textes à 254 octets</translation>
    </message>
    <message>
        <source>coordinates are metres of EPSG:%1; names, numbers and times are left out</source>
        <translation>les coordonnées sont des mètres d&apos;EPSG:%1 ; noms, nombres et heures sont omis</translation>
    </message>
    <message>
        <source>must not be exceeded: wind of %1 is forecast for %3 UTC, limit %2</source>
        <translation>ne doit pas être dépassée : vent de %1 prévu pour %3 UTC, limite %2</translation>
    </message>
    <message>
        <source>must not be exceeded: gusts of %1 are forecast for %3 UTC, limit %2</source>
        <translation>ne doit pas être dépassée : rafales de %1 prévues pour %3 UTC, limite %2</translation>
    </message>
    <message>
        <source>visibility of %1 is forecast for %3 UTC, limit %2</source>
        <translation>une visibilité de %1 est prévue pour %3 UTC, limite %2</translation>
    </message>
    <message>
        <source>a cloud base of %1 is forecast for %3 UTC, limit %2</source>
        <translation>un plafond de %1 est prévu pour %3 UTC, limite %2</translation>
    </message>
    <message>
        <source>icing is forecast at its altitude for %1 UTC, in which the UAV must not be flown</source>
        <translation>un givrage est prévu à son altitude pour %1 UTC, dans lequel le drone ne doit pas voler</translation>
    </message>
    <message>
        <source>is nearly reached: %1 is forecast for %3 UTC, limit %2</source>
        <translation>est presque atteinte : %1 prévus pour %3 UTC, limite %2</translation>
    </message>
    <message>
        <source>cannot be checked from %1 UTC on, because the forecast does not give a value</source>
        <translation>ne peut pas être contrôlée à partir de %1 UTC, car la prévision ne donne pas de valeur</translation>
    </message>
    <message>
        <source>cannot be checked without a forecast that gives this quantity</source>
        <translation>ne peut pas être contrôlée sans une prévision qui donne cette grandeur</translation>
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
        <translation>Clôture</translation>
    </message>
    <message>
        <source>Rally points</source>
        <translation>Points de ralliement</translation>
    </message>
    <message>
        <source>the aircraft does not answer</source>
        <translation>l&apos;aéronef ne répond pas</translation>
    </message>
    <message>
        <source>the aircraft stopped answering at item %1</source>
        <translation>l&apos;aéronef a cessé de répondre à l&apos;élément %1</translation>
    </message>
    <message>
        <source>the aircraft refuses it (result %1)</source>
        <translation>l&apos;aéronef refuse (résultat %1)</translation>
    </message>
    <message>
        <source>the aircraft requests an item that does not exist</source>
        <translation>l&apos;aéronef demande un élément qui n&apos;existe pas</translation>
    </message>
    <message>
        <source>the aircraft announces too many items</source>
        <translation>l&apos;aéronef annonce trop d&apos;éléments</translation>
    </message>
    <message>
        <source>the numbers of items differ</source>
        <translation>les nombres d&apos;éléments diffèrent</translation>
    </message>
    <message>
        <source>item %1, %2</source>
        <translation>élément %1, %2</translation>
    </message>
    <message>
        <source>Aircraft %1</source>
        <translation>Aéronef %1</translation>
    </message>
    <message>
        <source>Opening the link…</source>
        <translation>Ouverture de la liaison…</translation>
    </message>
    <message>
        <source>Listening</source>
        <translation>À l&apos;écoute</translation>
    </message>
    <message>
        <source>No link: %1</source>
        <translation>Pas de liaison : %1</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>il y a %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>%1: uploading, %2</source>
        <translation>%1 : envoi, %2</translation>
    </message>
    <message>
        <source>%1: reading back, %2</source>
        <translation>%1 : relecture, %2</translation>
    </message>
    <message>
        <source>On board: same as the plan</source>
        <translation>À bord : identique au plan</translation>
    </message>
    <message>
        <source>On board: same as the plan. The aircraft has no rally points</source>
        <translation>À bord : identique au plan. L&apos;aéronef n&apos;a pas de points de ralliement</translation>
    </message>
    <message>
        <source>On board differs. %1: %2</source>
        <translation>À bord, cela diffère. %1 : %2</translation>
    </message>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1, échec : %2</translation>
    </message>
    <message>
        <source>heard for the first time</source>
        <translation>entendu pour la première fois</translation>
    </message>
    <message>
        <source>contact lost</source>
        <translation>contact perdu</translation>
    </message>
    <message>
        <source>contact again</source>
        <translation>contact rétabli</translation>
    </message>
    <message>
        <source>mode %1</source>
        <translation>mode %1</translation>
    </message>
    <message>
        <source>item %1 reached</source>
        <translation>élément %1 atteint</translation>
    </message>
    <message>
        <source>a command was not answered</source>
        <translation>une commande est restée sans réponse</translation>
    </message>
    <message>
        <source>command accepted</source>
        <translation>commande acceptée</translation>
    </message>
    <message>
        <source>command refused (result %1)</source>
        <translation>commande refusée (résultat %1)</translation>
    </message>
    <message>
        <source>Another ground station uses the same id: sending is off</source>
        <translation>Une autre station au sol utilise le même identifiant : l&apos;émission est coupée</translation>
    </message>
    <message>
        <source>Waiting for guided mode</source>
        <translation>En attente du mode guidé</translation>
    </message>
    <message>
        <source>Waiting until the mission is flown</source>
        <translation>En attente du vol de la mission</translation>
    </message>
    <message>
        <source>Guiding from iceberg to iceberg</source>
        <translation>Guidage d&apos;iceberg en iceberg</translation>
    </message>
    <message>
        <source>Replacing the mission when the plan changes</source>
        <translation>Remplacement de la mission quand le plan change</translation>
    </message>
    <message>
        <source>The pilot has taken over: nothing is sent</source>
        <translation>Le pilote a repris la main : rien n&apos;est envoyé</translation>
    </message>
    <message>
        <source>Tracker %1</source>
        <translation>Balise %1</translation>
    </message>
    <message>
        <source>command</source>
        <translation>commande</translation>
    </message>
    <message>
        <source>altitude reference</source>
        <translation>référence d&apos;altitude</translation>
    </message>
    <message>
        <source>latitude</source>
        <translation>latitude</translation>
    </message>
    <message>
        <source>longitude</source>
        <translation>longitude</translation>
    </message>
    <message>
        <source>altitude</source>
        <translation>altitude</translation>
    </message>
    <message>
        <source>parameter %1</source>
        <translation>paramètre %1</translation>
    </message>
    <message>
        <source>Guiding begins when the flight in this window follows the aircraft</source>
        <translation>Le guidage commence quand le vol de cette fenêtre suit l&apos;aéronef</translation>
    </message>
    <message>
        <source>Replacing the mission begins when the flight in this window follows the aircraft</source>
        <translation>La mission est remplacée dès que le vol de cette fenêtre suit l&apos;aéronef</translation>
    </message>
    <message>
        <source>Radar target %1</source>
        <translation>Cible radar %1</translation>
    </message>
</context>
<context>
    <name>Main</name>
    <message>
        <source>Write map.png, zeta.png and sigma.png of a run, or of a scenario&apos;s complete run, into &lt;folder&gt;; with --theme both also map-dark.png, zeta-dark.png and sigma-dark.png.</source>
        <translation>Écrire map.png, zeta.png et sigma.png d&apos;un vol, ou du vol complet d&apos;un scénario, dans &lt;dossier&gt; ; avec --theme both, aussi map-dark.png, zeta-dark.png et sigma-dark.png.</translation>
    </message>
    <message>
        <source>Overwrite existing files.</source>
        <translation>Remplacer les fichiers existants.</translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation>La mémoire est insuffisante.</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>dossier</translation>
    </message>
    <message>
        <source>Size of each picture in pixels, e.g. 1920x1080 (default: 1600x1000 for the map, 1600x700 for the charts).</source>
        <translation>Taille de chaque image en pixels, p. ex. 1920x1080 (par défaut : 1600x1000 pour la carte, 1600x700 pour les graphiques).</translation>
    </message>
    <message>
        <source>WxH</source>
        <comment>width x height</comment>
        <translation>LxH</translation>
    </message>
    <message>
        <source>Appearance of the pictures: light, dark or both.</source>
        <translation>Apparence des images : light (clair), dark (sombre) ou both (les deux).</translation>
    </message>
    <message>
        <source>theme</source>
        <translation>thème</translation>
    </message>
    <message>
        <source>--size: &quot;%1&quot; is not a size like 1920x1080 with sides from %2 to %3 pixels.</source>
        <translation>--size : « %1 » n&apos;est pas une taille comme 1920x1080 avec des côtés de %2 à %3 pixels.</translation>
    </message>
    <message>
        <source>--theme: &quot;%1&quot; is not light, dark or both.</source>
        <translation>--theme : « %1 » n&apos;est ni light, ni dark, ni both.</translation>
    </message>
    <message>
        <source>--pictures: the name of a folder is missing.</source>
        <translation>--pictures : le nom d&apos;un dossier manque.</translation>
    </message>
    <message>
        <source>Opens the window with a scenario; with --pictures it only writes pictures.</source>
        <translation>Ouvre la fenêtre sur un scénario ; avec --pictures, le programme n&apos;écrit que des images.</translation>
    </message>
    <message>
        <source>file</source>
        <translation>fichier</translation>
    </message>
    <message>
        <source>Name one run or scenario file; %1 were named.</source>
        <translation>Indiquez un seul fichier de vol ou de scénario ; %1 ont été indiqués.</translation>
    </message>
    <message>
        <source>Bergwatch has crashed: %1</source>
        <translation>Bergwatch s&apos;est arrêté brutalement : %1</translation>
    </message>
    <message>
        <source>Write a picture of the window with the scenario to &lt;file&gt;, then exit.</source>
        <translation>Écrire une image de la fenêtre avec le scénario dans &lt;fichier&gt;, puis quitter.</translation>
    </message>
    <message>
        <source>Fly until this time before the screenshot.</source>
        <translation>Jouer le vol jusqu&apos;à cet instant avant la capture d&apos;écran.</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>secondes</translation>
    </message>
    <message>
        <source>Store settings in &lt;file&gt; instead of your own settings file.</source>
        <translation>Conserver les paramètres dans &lt;fichier&gt; au lieu de votre propre fichier.</translation>
    </message>
    <message>
        <source>--size: &quot;%1&quot; is not a size like 1920x1080.</source>
        <translation>--size : « %1 » n&apos;est pas une taille comme 1920x1080.</translation>
    </message>
    <message>
        <source>--theme: &quot;%1&quot; is not light or dark.</source>
        <translation>--theme : « %1 » n&apos;est ni light ni dark.</translation>
    </message>
    <message>
        <source>--at: &quot;%1&quot; is not a number of seconds.</source>
        <translation>--at : « %1 » n&apos;est pas un nombre de secondes.</translation>
    </message>
    <message>
        <source>Name at most one scenario file; %1 were named.</source>
        <translation>Indiquez au plus un fichier de scénario ; %1 ont été indiqués.</translation>
    </message>
    <message>
        <source>The command &quot;export&quot; writes plans and flights as files, maps, charts and briefs: see &quot;bergwatch export --help&quot;.</source>
        <translation>La commande « export » écrit les plans et les vols sous forme de fichiers, cartes, graphiques et fiches : voir « bergwatch export --help ».</translation>
    </message>
    <message>
        <source>Write the manual as web pages and as PDF into &lt;folder&gt;, which has its pictures.</source>
        <translation>Écrire le manuel en pages web et en PDF dans &lt;dossier&gt;, où se trouvent les images.</translation>
    </message>
    <message>
        <source>--manual takes no scenario file, --pictures or --screenshot.</source>
        <translation>--manual n&apos;accepte ni fichier de scénario, ni --pictures, ni --screenshot.</translation>
    </message>
    <message>
        <source>Longest wait before the screenshot for predictions and the lower bound, in seconds.</source>
        <translation>Attente maximale des prévisions et de la borne inférieure avant la capture d&apos;écran, en secondes.</translation>
    </message>
    <message>
        <source>--wait: &quot;%1&quot; is not a number of seconds up to %2.</source>
        <translation>--wait : « %1 » n&apos;est pas un nombre de secondes jusqu&apos;à %2.</translation>
    </message>
    <message>
        <source>A scenario (.berg), run (.bergrun), study (.bergstudy) or telemetry log (.tlog).</source>
        <translation>Un scénario (.berg), un vol (.bergrun), une étude (.bergstudy) ou un journal de télémétrie (.tlog).</translation>
    </message>
</context>
<context>
    <name>ManualPages</name>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>The Bergwatch manual</source>
        <translation>Manuel de Bergwatch</translation>
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
            <numerusform>Supprimer %n objet</numerusform>
            <numerusform>Supprimer %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete UAV</source>
        <translation>Supprimer le drone</translation>
    </message>
    <message>
        <source>Remove asset</source>
        <translation>Retirer le bien protégé</translation>
    </message>
    <message>
        <source>Remove area</source>
        <translation>Retirer la zone</translation>
    </message>
    <message>
        <source>Remove no-fly area</source>
        <translation>Retirer la zone interdite</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n icebergs</source>
        <translation>
            <numerusform>Supprimer l&apos;iceberg</numerusform>
            <numerusform>Supprimer %n icebergs</numerusform>
        </translation>
    </message>
    <message>
        <source>The last UAV cannot be deleted: a scenario needs at least one.</source>
        <translation>Le dernier drone ne peut pas être supprimé : un scénario en a besoin d&apos;un au moins.</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n icebergs</source>
        <translation>
            <numerusform>Couper l&apos;iceberg</numerusform>
            <numerusform>Couper %n icebergs</numerusform>
        </translation>
    </message>
    <message>
        <source>There are no icebergs on the clipboard.</source>
        <translation>Il n&apos;y a pas d&apos;icebergs dans le presse-papiers.</translation>
    </message>
    <message>
        <source>The clipboard content cannot be pasted. %1</source>
        <translation>Le contenu du presse-papiers ne peut pas être collé. %1</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n icebergs</source>
        <translation>
            <numerusform>Coller un iceberg</numerusform>
            <numerusform>Coller %n icebergs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n icebergs</source>
        <translation>
            <numerusform>Dupliquer l&apos;iceberg</numerusform>
            <numerusform>Dupliquer %n icebergs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n UAVs</source>
        <translation>
            <numerusform>Dupliquer le drone</numerusform>
            <numerusform>Dupliquer %n drones</numerusform>
        </translation>
    </message>
    <message>
        <source>Add UAV</source>
        <translation>Ajouter un drone</translation>
    </message>
    <message>
        <source>Add iceberg</source>
        <translation>Ajouter un iceberg</translation>
    </message>
</context>
<context>
    <name>MapLayoutText</name>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
    </message>
    <message>
        <source>given up</source>
        <translation>abandonné</translation>
    </message>
</context>
<context>
    <name>MapLegend</name>
    <message>
        <source>In view now: σ is 0</source>
        <translation>En vue maintenant : σ vaut 0</translation>
    </message>
    <message>
        <source>Plan, next leg thicker</source>
        <translation>Plan, prochain segment plus épais</translation>
    </message>
    <message>
        <source>Flown, older parts fainter</source>
        <translation>Parcouru, parties anciennes estompées</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Champ de vision</translation>
    </message>
    <message>
        <source>Drift in %1</source>
        <translation>Dérive en %1</translation>
    </message>
    <message>
        <source>Uncertainty σ</source>
        <translation>Incertitude σ</translation>
    </message>
    <message>
        <source>Appears later, with time</source>
        <translation>Apparaît plus tard, avec son heure</translation>
    </message>
    <message>
        <source>Compared: %1</source>
        <translation>Comparé : %1</translation>
    </message>
    <message>
        <source>Plan before the change</source>
        <translation>Plan avant la modification</translation>
    </message>
    <message>
        <source>Seen so far</source>
        <translation>Vu jusqu&apos;ici</translation>
    </message>
    <message>
        <source>In view</source>
        <translation>En vue</translation>
    </message>
    <message>
        <source>Appears later</source>
        <translation>Plus tard</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Point aimed at</source>
        <translation>Point visé</translation>
    </message>
    <message>
        <source>Aim point</source>
        <translation>Point visé</translation>
    </message>
    <message>
        <source>Former plan</source>
        <translation>Ancien plan</translation>
    </message>
    <message>
        <source>Flown</source>
        <translation>Parcouru</translation>
    </message>
    <message>
        <source>In view now</source>
        <translation>En vue maintenant</translation>
    </message>
    <message>
        <source>Lost: not found where expected</source>
        <translation>Perdu : non trouvé à l&apos;endroit attendu</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Perdu</translation>
    </message>
    <message>
        <source>Search given up</source>
        <translation>Recherche abandonnée</translation>
    </message>
    <message>
        <source>Given up</source>
        <translation>Abandonné</translation>
    </message>
    <message>
        <source>95 % position circle</source>
        <translation>Cercle de position à 95 %</translation>
    </message>
    <message>
        <source>95 % circle</source>
        <translation>Cercle à 95 %</translation>
    </message>
    <message>
        <source>True position</source>
        <translation>Position réelle</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>Réalité</translation>
    </message>
    <message>
        <source>Will enter inner ring</source>
        <translation>Entrera dans l&apos;anneau intérieur</translation>
    </message>
    <message>
        <source>Enters ring</source>
        <translation>Entre dans l&apos;anneau</translation>
    </message>
    <message>
        <source>Planned as one point</source>
        <translation>Planifiés comme un seul point</translation>
    </message>
    <message>
        <source>One point</source>
        <translation>Point unique</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Geofence (kept if the UAV starts inside it)</source>
        <translation>Barrière virtuelle (respectée si le drone démarre à l&apos;intérieur)</translation>
    </message>
    <message>
        <source>Geofence</source>
        <translation>Barrière virtuelle</translation>
    </message>
    <message>
        <source>Asset&apos;s range: more urgent inside</source>
        <translation>Rayon d&apos;influence : plus urgent dedans</translation>
    </message>
    <message>
        <source>Asset&apos;s range</source>
        <translation>Rayon d&apos;influence</translation>
    </message>
    <message>
        <source>Inner ring: alarm</source>
        <translation>Anneau intérieur : alarme</translation>
    </message>
    <message>
        <source>Inner ring</source>
        <translation>Anneau intérieur</translation>
    </message>
    <message>
        <source>Search pattern</source>
        <translation>Parcours de recherche</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>UAVs too close to each other</source>
        <translation>Drones trop proches l&apos;un de l&apos;autre</translation>
    </message>
    <message>
        <source>Too close</source>
        <translation>Trop proches</translation>
    </message>
    <message>
        <source>Assigned to the UAV of this colour</source>
        <translation>Attribué au drone de cette couleur</translation>
    </message>
    <message>
        <source>Assigned to one</source>
        <translation>Attribué à un drone</translation>
    </message>
    <message>
        <source>Point of no return</source>
        <translation>Point de non-retour</translation>
    </message>
    <message>
        <source>Radio range of the ground station</source>
        <translation>Portée radio de la station sol</translation>
    </message>
    <message>
        <source>Radio range</source>
        <translation>Portée radio</translation>
    </message>
    <message>
        <source>No-fly area</source>
        <translation>Zone interdite</translation>
    </message>
    <message>
        <source>Stand-off round the asset</source>
        <translation>Distance de sécurité au bien protégé</translation>
    </message>
    <message>
        <source>Stand-off</source>
        <translation>Distance de sécurité</translation>
    </message>
    <message>
        <source>Close together</source>
        <translation>Rapprochés</translation>
    </message>
    <message>
        <source>Place to search, probability of finding</source>
        <translation>Lieu à fouiller, probabilité de découverte</translation>
    </message>
    <message>
        <source>Place to search</source>
        <translation>Lieu à fouiller</translation>
    </message>
    <message>
        <source>Later visit in the plan</source>
        <translation>Visite ultérieure du plan</translation>
    </message>
    <message>
        <source>Later visit</source>
        <translation>Visite ultérieure</translation>
    </message>
    <message>
        <source>Airspace, for information</source>
        <translation>Espace aérien, pour information</translation>
    </message>
    <message>
        <source>Airspace</source>
        <translation>Espace aérien</translation>
    </message>
    <message>
        <source>Flight geography, proposal</source>
        <translation>Géographie de vol, proposition</translation>
    </message>
    <message>
        <source>Flight geography</source>
        <translation>Géographie de vol</translation>
    </message>
    <message>
        <source>Contingency volume, proposal</source>
        <translation>Volume de contingence, proposition</translation>
    </message>
    <message>
        <source>Contingency</source>
        <translation>Contingence</translation>
    </message>
    <message>
        <source>Ground-risk buffer, proposal</source>
        <translation>Zone tampon de risque au sol, proposition</translation>
    </message>
    <message>
        <source>Risk buffer</source>
        <translation>Zone tampon</translation>
    </message>
    <message>
        <source>Adjacent area, proposal</source>
        <translation>Zone adjacente, proposition</translation>
    </message>
    <message>
        <source>Adjacent area</source>
        <translation>Zone adjacente</translation>
    </message>
    <message>
        <source>Close together: dot or number</source>
        <translation>Rapprochés : point, ou leur nombre</translation>
    </message>
    <message>
        <source>Later visits of the patrol</source>
        <translation>Visites suivantes de la patrouille</translation>
    </message>
    <message>
        <source>Patrol</source>
        <translation>Patrouille</translation>
    </message>
    <message>
        <source>Ice free</source>
        <translation>Libre de glace</translation>
    </message>
    <message>
        <source>Open water</source>
        <translation>Eau libre</translation>
    </message>
    <message>
        <source>Ice 1–3 tenths</source>
        <translation>Glace 1–3 dixièmes</translation>
    </message>
    <message>
        <source>Ice 4–6 tenths</source>
        <translation>Glace 4–6 dixièmes</translation>
    </message>
    <message>
        <source>Ice 7–8 tenths</source>
        <translation>Glace 7–8 dixièmes</translation>
    </message>
    <message>
        <source>Ice 9–10 tenths</source>
        <translation>Glace 9–10 dixièmes</translation>
    </message>
    <message>
        <source>Fast ice</source>
        <translation>Banquise côtière</translation>
    </message>
    <message>
        <source>Ice, concentration unknown</source>
        <translation>Glace, concentration inconnue</translation>
    </message>
    <message>
        <source>no date</source>
        <comment>ice chart</comment>
        <translation>sans date</translation>
    </message>
    <message>
        <source>Old ice chart: %1</source>
        <translation>Ancienne carte des glaces : %1</translation>
    </message>
    <message>
        <source>Ice chart: %1</source>
        <translation>Carte des glaces : %1</translation>
    </message>
    <message>
        <source>Old ice chart</source>
        <translation>Ancienne carte des glaces</translation>
    </message>
    <message>
        <source>Ice chart</source>
        <translation>Carte des glaces</translation>
    </message>
    <message>
        <source>Forecast wind, full barb 10 kn</source>
        <translation>Vent prévu, barbule 10 kn</translation>
    </message>
    <message>
        <source>Forecast wind</source>
        <translation>Vent prévu</translation>
    </message>
    <message>
        <source>Forecast current</source>
        <translation>Courant prévu</translation>
    </message>
    <message>
        <source>Predicted drift, circle: 1 σ</source>
        <translation>Dérive prévue, cercle : 1 σ</translation>
    </message>
    <message>
        <source>Predicted drift</source>
        <translation>Dérive prévue</translation>
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
        <translation>Temps</translation>
    </message>
    <message>
        <source>Zeta ζ</source>
        <translation>Zêta ζ</translation>
    </message>
    <message>
        <source>Visits, dots on the path</source>
        <translation>Visites, points sur la trajectoire</translation>
    </message>
    <message>
        <source>Longest flight</source>
        <translation>Vol le plus long</translation>
    </message>
    <message>
        <source>Flight time</source>
        <translation>Temps de vol</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Visites</translation>
    </message>
    <message>
        <source>This sortie</source>
        <translation>Cette sortie</translation>
    </message>
</context>
<context>
    <name>MapTipText</name>
    <message>
        <source>drifting %1 towards %2</source>
        <translation>dérive de %1 vers %2</translation>
    </message>
    <message>
        <source>not drifting</source>
        <translation>sans dérive</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>name, uncertainty, drift</comment>
        <translation>%1 : %2, %3</translation>
    </message>
    <message>
        <source>Ice concentration %1 tenths</source>
        <translation>Concentration de glace : %1 dixièmes</translation>
    </message>
    <message>
        <source>Ice concentration unknown</source>
        <translation>Concentration de glace inconnue</translation>
    </message>
    <message>
        <source>, fast ice</source>
        <translation>, banquise côtière</translation>
    </message>
    <message>
        <source>
On the chart: %1</source>
        <translation>
Sur la carte : %1</translation>
    </message>
</context>
<context>
    <name>MapTools</name>
    <message>
        <source>Drag to move the map, turn the wheel to zoom. Esc leaves the tool.</source>
        <translation>Faites glisser pour déplacer la carte, tournez la molette pour zoomer. Esc quitte l&apos;outil.</translation>
    </message>
    <message>
        <source>Move UAV</source>
        <translation>Déplacer le drone</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects</source>
        <translation>
            <numerusform>Déplacer %n objet</numerusform>
            <numerusform>Déplacer %n objets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n icebergs</source>
        <translation>
            <numerusform>Déplacer l&apos;iceberg</numerusform>
            <numerusform>Déplacer %n icebergs</numerusform>
        </translation>
    </message>
    <message>
        <source>Move asset</source>
        <translation>Déplacer le bien protégé</translation>
    </message>
    <message>
        <source>Move area</source>
        <translation>Déplacer la zone</translation>
    </message>
    <message>
        <source>Move no-fly area</source>
        <translation>Déplacer la zone interdite</translation>
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
        <translation>Total %1</translation>
    </message>
    <message>
        <source>Click to set the next point. Enter ends the line, Backspace removes a point, Esc clears.</source>
        <translation>Cliquez pour placer le point suivant. Entrée termine la ligne, Retour arrière retire un point, Esc efface.</translation>
    </message>
    <message>
        <source>Click to start another line. Esc clears this one.</source>
        <translation>Cliquez pour commencer une autre ligne. Esc efface celle-ci.</translation>
    </message>
    <message>
        <source>Click points to measure the path between them: geodesic length, true bearing, time of flight.</source>
        <translation>Cliquez des points pour mesurer le trajet entre eux : longueur géodésique, relèvement vrai, temps de vol.</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1 at %2 in the wind</source>
        <translation>%1 à %2 dans le vent</translation>
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
        <translation>iceberg atteint</translation>
    </message>
    <message>
        <source>Uncertainty now and accumulated</source>
        <translation>Incertitude actuelle et cumulée</translation>
    </message>
    <message>
        <source>Sum of σ, m²</source>
        <translation>Somme des σ, m²</translation>
    </message>
    <message>
        <source>Sum of σ</source>
        <translation>Somme des σ</translation>
    </message>
    <message>
        <source>Uncertainty of each iceberg</source>
        <translation>Incertitude de chaque iceberg</translation>
    </message>
    <message>
        <source>σ, m²</source>
        <translation>σ, m²</translation>
    </message>
    <message>
        <source>Nothing flown yet. Press Space to fly the plan</source>
        <translation>Aucun vol encore. Appuyez sur Espace pour exécuter le plan</translation>
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
        <translation>Zêta</translation>
    </message>
    <message>
        <source>Rate of zeta, now and on average</source>
        <translation>Croissance de zêta, actuelle et moyenne</translation>
    </message>
    <message>
        <source>Sum of σ = dζ/dt, m²</source>
        <translation>Somme des σ = dζ/dt, m²</translation>
    </message>
    <message>
        <source>Mean since take-off</source>
        <translation>Moyenne depuis le décollage</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Maintenant</translation>
    </message>
    <message>
        <source>At %1 zeta grows by %2 m² s per second; the mean since take-off is %3.</source>
        <translation>À %1, zêta augmente de %2 m² s par seconde ; la moyenne depuis le décollage est de %3.</translation>
    </message>
    <message>
        <source>Distance flown</source>
        <translation>Distance parcourue</translation>
    </message>
    <message>
        <source>Flown</source>
        <translation>Parcouru</translation>
    </message>
    <message>
        <source>Distance flown until %1: %2.</source>
        <translation>Distance parcourue jusqu&apos;à %1 : %2.</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>Taux de virage</translation>
    </message>
    <message>
        <source>Turn rate, °/s, positive to the left</source>
        <translation>Taux de virage, °/s, positif à gauche</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>Limit %1 °/s</source>
        <translation>Limite %1 °/s</translation>
    </message>
    <message>
        <source>Cross-track error</source>
        <translation>Écart latéral</translation>
    </message>
    <message>
        <source>Cross-track error, m, positive to the left</source>
        <translation>Écart latéral, m, positif à gauche</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Zeta and sum of σ</source>
        <translation>Zêta et somme des σ</translation>
    </message>
    <message>
        <source>Rate of zeta</source>
        <translation>Croissance de zêta</translation>
    </message>
    <message>
        <source>σ of each iceberg</source>
        <translation>σ de chaque iceberg</translation>
    </message>
    <message>
        <source>Distance through the air, %1</source>
        <translation>Distance dans l&apos;air, %1</translation>
    </message>
    <message>
        <source>Lower bound on ζ</source>
        <translation>Borne inférieure de ζ</translation>
    </message>
    <message>
        <source>Weighted</source>
        <translation>Pondéré</translation>
    </message>
    <message>
        <source>Weighted by priority</source>
        <translation>Pondéré par priorité</translation>
    </message>
    <message>
        <source>Weighted by priority the sum is %1 m².</source>
        <translation>Pondérée par priorité, la somme est de %1 m².</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Tous : %1</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tous</translation>
    </message>
    <message>
        <source>Turn rate at %1: %2; limit: %3.</source>
        <translation>Taux de virage à %1 : %2 ; limite : %3.</translation>
    </message>
    <message>
        <source>Cross-track error at %1: %2.</source>
        <translation>Écart latéral à %1 : %2.</translation>
    </message>
    <message>
        <source>Zeta %1</source>
        <translation>Zêta %1</translation>
    </message>
    <message>
        <source>At %1 zeta is %2 and the sum of σ %3 m².</source>
        <translation>À %1, zêta vaut %2 et la somme des σ %3 m².</translation>
    </message>
    <message numerus="yes">
        <source>At %1 the most uncertain iceberg is %2: %3; %n in view.</source>
        <translation>
            <numerusform>À %1, l&apos;iceberg le plus incertain est %2 : %3 ; %n en vue.</numerusform>
            <numerusform>À %1, l&apos;iceberg le plus incertain est %2 : %3 ; %n en vue.</numerusform>
        </translation>
    </message>
    <message>
        <source>Zeta ζ, %1</source>
        <translation>Zêta ζ, %1</translation>
    </message>
    <message>
        <source>Wind and current</source>
        <translation>Vent et courant</translation>
    </message>
</context>
<context>
    <name>MissionClockText</name>
    <message>
        <source>in %1</source>
        <translation>dans %1</translation>
    </message>
    <message>
        <source>%1 UTC
%2 local time (%3)
%4 after the start</source>
        <translation>%1 UTC
%2 heure locale (%3)
%4 après le début</translation>
    </message>
</context>
<context>
    <name>MissionPicture</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Zeta ζ</source>
        <translation>Zêta ζ</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Visites</translation>
    </message>
    <message>
        <source>No icebergs yet</source>
        <translation>Aucun iceberg pour l&apos;instant</translation>
    </message>
    <message>
        <source>Add icebergs with their positions to the scenario file, then draw the map again.</source>
        <translation>Ajoutez des icebergs avec leurs positions au fichier de scénario, puis redessinez la carte.</translation>
    </message>
    <message>
        <source>Closest so far</source>
        <translation>Plus proche jusqu&apos;ici</translation>
    </message>
    <message>
        <source>Above the reserve</source>
        <translation>Au-dessus de la réserve</translation>
    </message>
    <message>
        <source>if home now</source>
        <translation>si retour maintenant</translation>
    </message>
    <message>
        <source>Until the reserve</source>
        <translation>Avant la réserve</translation>
    </message>
</context>
<context>
    <name>MissionSeriesText</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
</context>
<context>
    <name>OperationPage</name>
    <message>
        <source>Largest speed over ground</source>
        <translation>Vitesse sol maximale</translation>
    </message>
    <message>
        <source>Flight geography, height</source>
        <translation>Géographie de vol, hauteur</translation>
    </message>
    <message>
        <source>Contingency volume, height</source>
        <translation>Volume de contingence, hauteur</translation>
    </message>
    <message>
        <source>Contingency volume, width</source>
        <translation>Volume de contingence, largeur</translation>
    </message>
    <message>
        <source>Ground-risk buffer, width</source>
        <translation>Zone tampon de risque au sol, largeur</translation>
    </message>
    <message>
        <source>Adjacent area, width</source>
        <translation>Zone adjacente, largeur</translation>
    </message>
    <message>
        <source>Flight geography: inside the geofence.</source>
        <translation>Géographie de vol : intérieur de la barrière virtuelle.</translation>
    </message>
    <message>
        <source>Flight geography: all places that a plan may reach, plus a margin of %1 m.</source>
        <translation>Géographie de vol : tous les lieux qu&apos;un plan peut atteindre, plus une marge de %1 m.</translation>
    </message>
    <message>
        <source>Formulas and default constants: Digisky calculator 3.3.0, based on the guide of the Swiss FOCA; not an authority&apos;s own text.</source>
        <translation>Formules et constantes par défaut : calculateur Digisky 3.3.0, d&apos;après le guide de l&apos;OFAC suisse ; pas le texte d&apos;une autorité.</translation>
    </message>
    <message>
        <source>The outlines are in the KML, KMZ and GeoJSON exports.</source>
        <translation>Les contours sont dans les exports KML, KMZ et GeoJSON.</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
    </message>
    <message>
        <source>Endurance</source>
        <translation>Autonomie</translation>
    </message>
    <message>
        <source>Reserve</source>
        <translation>Réserve</translation>
    </message>
    <message>
        <source>Wind limit</source>
        <translation>Limite de vent</translation>
    </message>
    <message>
        <source>Gust limit</source>
        <translation>Limite de rafales</translation>
    </message>
    <message>
        <source>Icing conditions</source>
        <translation>Conditions givrantes</translation>
    </message>
    <message>
        <source>flown in</source>
        <translation>vol possible</translation>
    </message>
    <message>
        <source>not flown in</source>
        <translation>pas de vol</translation>
    </message>
    <message>
        <source>Made by Bergwatch from the scenario. It does not imply that the operation may be flown.</source>
        <translation>Établi par Bergwatch à partir du scénario. Cela n&apos;implique pas que l&apos;opération puisse être effectuée.</translation>
    </message>
    <message>
        <source>Checklist</source>
        <translation>Liste de vérification</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 de plus</translation>
    </message>
    <message>
        <source>Operation volume: proposal, to be checked with your authority</source>
        <translation>Volume opérationnel : proposition à vérifier avec l&apos;autorité</translation>
    </message>
    <message>
        <source>Crew</source>
        <translation>Équipage</translation>
    </message>
    <message>
        <source>Call sign</source>
        <translation>Indicatif d&apos;appel</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Command link</source>
        <translation>Liaison de commande</translation>
    </message>
    <message>
        <source>Date and signatures</source>
        <translation>Date et signatures</translation>
    </message>
    <message>
        <source>Visibility limit</source>
        <translation>Limite de visibilité</translation>
    </message>
    <message>
        <source>Ceiling limit</source>
        <translation>Limite de plafond</translation>
    </message>
</context>
<context>
    <name>PageText</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>First leg at %1</source>
        <translation>Premier segment à %1</translation>
    </message>
    <message>
        <source>First leg</source>
        <translation>Premier segment</translation>
    </message>
    <message>
        <source>Planned order at %1</source>
        <translation>Ordre prévu à %1</translation>
    </message>
    <message>
        <source>Planned order</source>
        <translation>Ordre prévu</translation>
    </message>
    <message>
        <source>Planned path with turns at %1</source>
        <translation>Trajectoire prévue avec virages à %1</translation>
    </message>
    <message>
        <source>Planned path with turns</source>
        <translation>Trajectoire prévue avec virages</translation>
    </message>
    <message>
        <source>Flown until %1</source>
        <translation>Vol effectué jusqu&apos;à %1</translation>
    </message>
    <message>
        <source>Start %1 UTC</source>
        <translation>Début %1 UTC</translation>
    </message>
</context>
<context>
    <name>PanelText</name>
    <message>
        <source>As opened</source>
        <translation>À l&apos;ouverture</translation>
    </message>
    <message>
        <source>Click a line to go to that state; the disk marks the saved one.</source>
        <translation>Cliquez sur une ligne pour aller à cet état ; la disquette marque l&apos;état enregistré.</translation>
    </message>
    <message>
        <source>History of edits</source>
        <translation>Historique des modifications</translation>
    </message>
</context>
<context>
    <name>PlaceText</name>
    <message>
        <source>Labrador Sea</source>
        <translation>Mer du Labrador</translation>
    </message>
    <message>
        <source>Davis Strait</source>
        <translation>Détroit de Davis</translation>
    </message>
    <message>
        <source>Baffin Bay</source>
        <translation>Baie de Baffin</translation>
    </message>
    <message>
        <source>Disko Bay</source>
        <translation>Baie de Disko</translation>
    </message>
    <message>
        <source>Melville Bay</source>
        <translation>Baie de Melville</translation>
    </message>
    <message>
        <source>Cape York</source>
        <translation>Cap York</translation>
    </message>
    <message>
        <source>Nares Strait</source>
        <translation>Détroit de Nares</translation>
    </message>
    <message>
        <source>Cape Farewell</source>
        <translation>Cap Farvel</translation>
    </message>
    <message>
        <source>Denmark Strait</source>
        <translation>Détroit du Danemark</translation>
    </message>
    <message>
        <source>Scoresby Sund</source>
        <translation>Scoresby Sund</translation>
    </message>
    <message>
        <source>Fram Strait</source>
        <translation>Détroit de Fram</translation>
    </message>
    <message>
        <source>Hinlopen Strait</source>
        <translation>Détroit d&apos;Hinlopen</translation>
    </message>
    <message>
        <source>Bear Island</source>
        <translation>Île aux Ours</translation>
    </message>
    <message>
        <source>Barents Sea</source>
        <translation>Mer de Barents</translation>
    </message>
    <message>
        <source>Franz Josef Land</source>
        <translation>Terre François-Joseph</translation>
    </message>
    <message>
        <source>Novaya Zemlya</source>
        <translation>Nouvelle-Zemble</translation>
    </message>
    <message>
        <source>Kara Sea</source>
        <translation>Mer de Kara</translation>
    </message>
    <message>
        <source>Laptev Sea</source>
        <translation>Mer de Laptev</translation>
    </message>
    <message>
        <source>Bering Strait</source>
        <translation>Détroit de Béring</translation>
    </message>
    <message>
        <source>Beaufort Sea</source>
        <translation>Mer de Beaufort</translation>
    </message>
    <message>
        <source>North Pole</source>
        <translation>Pôle Nord</translation>
    </message>
    <message>
        <source>Drake Passage</source>
        <translation>Passage de Drake</translation>
    </message>
    <message>
        <source>South Georgia</source>
        <translation>Géorgie du Sud</translation>
    </message>
    <message>
        <source>Weddell Sea</source>
        <translation>Mer de Weddell</translation>
    </message>
    <message>
        <source>Amery Ice Shelf</source>
        <translation>Plateau de glace Amery</translation>
    </message>
    <message>
        <source>Ross Sea</source>
        <translation>Mer de Ross</translation>
    </message>
    <message>
        <source>McMurdo Sound</source>
        <translation>Détroit de McMurdo</translation>
    </message>
    <message>
        <source>South Pole</source>
        <translation>Pôle Sud</translation>
    </message>
    <message>
        <source>No known place has this name, and it is not a coordinate.</source>
        <translation>Aucun lieu de ce nom n&apos;existe ici, et ce n&apos;est pas une coordonnée.</translation>
    </message>
    <message>
        <source>Several places have this name.</source>
        <translation>Plusieurs lieux portent ce nom.</translation>
    </message>
    <message>
        <source>Enter a coordinate or a place name.</source>
        <translation>Une coordonnée ou le nom d&apos;un lieu est nécessaire.</translation>
    </message>
    <message>
        <source>This is not a coordinate. Examples: 47° 03.2′ N 48° 06′ W, or 47.05 -48.1.</source>
        <translation>Ce n&apos;est pas une coordonnée. Exemples : 47° 03,2′ N 48° 06′ W, ou 47,05 -48,1.</translation>
    </message>
    <message>
        <source>This is half a coordinate. Enter latitude and longitude.</source>
        <translation>C&apos;est la moitié d&apos;une coordonnée : la latitude et la longitude sont nécessaires.</translation>
    </message>
    <message>
        <source>This coordinate is ambiguous. Add spaces and the letters N, S, E or W.</source>
        <translation>Cela peut se lire de plusieurs façons. Des espaces et les lettres N, S, E et W lèvent le doute.</translation>
    </message>
    <message>
        <source>Only one half states its hemisphere. Add N, S, E or W to the other.</source>
        <translation>Une seule moitié indique son hémisphère. Ajoutez N, S, E ou W à l&apos;autre.</translation>
    </message>
    <message>
        <source>Use a sign or a hemisphere letter, not both.</source>
        <translation>L&apos;hémisphère est donné soit par un signe, soit par une lettre, mais pas les deux.</translation>
    </message>
    <message>
        <source>Enter one latitude and one longitude.</source>
        <translation>Une latitude et une longitude sont nécessaires, pas deux de la même sorte.</translation>
    </message>
    <message>
        <source>Minutes and seconds must be below 60.</source>
        <translation>Les minutes et les secondes sont inférieures à 60.</translation>
    </message>
    <message>
        <source>Latitude must be between 90° S and 90° N.</source>
        <translation>Les latitudes vont de 90° S à 90° N.</translation>
    </message>
    <message>
        <source>Longitude must be between 180° W and 180° E.</source>
        <translation>Les longitudes vont de 180° W à 180° E.</translation>
    </message>
    <message>
        <source>This position does not exist on the UTM or MGRS grid.</source>
        <translation>Ce lieu n&apos;existe pas dans la grille UTM ou MGRS.</translation>
    </message>
    <message>
        <source>This is a longitude. Enter a latitude.</source>
        <translation>C&apos;est une longitude ; une latitude est nécessaire.</translation>
    </message>
    <message>
        <source>This is a latitude. Enter a longitude.</source>
        <translation>C&apos;est une latitude ; une longitude est nécessaire.</translation>
    </message>
    <message>
        <source>This is %1 from the scenario&apos;s origin; the limit is %2.</source>
        <translation>C&apos;est à %1 de l&apos;origine du scénario, qui s&apos;étend jusqu&apos;à %2.</translation>
    </message>
    <message>
        <source>Enter one angle only: a whole coordinate would move all of them to one place.</source>
        <translation>Saisissez un seul angle : une coordonnée complète les placerait tous au même endroit.</translation>
    </message>
    <message>
        <source>Amundsen Sea</source>
        <translation>Mer d&apos;Amundsen</translation>
    </message>
    <message>
        <source>Antarctic Peninsula</source>
        <translation>Péninsule Antarctique</translation>
    </message>
    <message>
        <source>Baffin Island</source>
        <translation>Île de Baffin</translation>
    </message>
    <message>
        <source>Bellingshausen Sea</source>
        <translation>Mer de Bellingshausen</translation>
    </message>
    <message>
        <source>Bering Sea</source>
        <translation>Mer de Béring</translation>
    </message>
    <message>
        <source>Bransfield Strait</source>
        <translation>Détroit de Bransfield</translation>
    </message>
    <message>
        <source>Cape Horn</source>
        <translation>Cap Horn</translation>
    </message>
    <message>
        <source>Chukchi Sea</source>
        <translation>Mer des Tchouktches</translation>
    </message>
    <message>
        <source>East Siberian Sea</source>
        <translation>Mer de Sibérie orientale</translation>
    </message>
    <message>
        <source>Ellesmere Island</source>
        <translation>Île d&apos;Ellesmere</translation>
    </message>
    <message>
        <source>Falkland Islands</source>
        <translation>Îles Malouines</translation>
    </message>
    <message>
        <source>Greenland</source>
        <translation>Groenland</translation>
    </message>
    <message>
        <source>Greenland Sea</source>
        <translation>Mer du Groenland</translation>
    </message>
    <message>
        <source>Gulf of St. Lawrence</source>
        <translation>Golfe du Saint-Laurent</translation>
    </message>
    <message>
        <source>Hudson Bay</source>
        <translation>Baie d&apos;Hudson</translation>
    </message>
    <message>
        <source>Hudson Strait</source>
        <translation>Détroit d&apos;Hudson</translation>
    </message>
    <message>
        <source>Iceland</source>
        <translation>Islande</translation>
    </message>
    <message>
        <source>Iceland Sea</source>
        <translation>Mer d&apos;Islande</translation>
    </message>
    <message>
        <source>Irminger Sea</source>
        <translation>Mer d&apos;Irminger</translation>
    </message>
    <message>
        <source>Lancaster Sound</source>
        <translation>Détroit de Lancaster</translation>
    </message>
    <message>
        <source>Lincoln Sea</source>
        <translation>Mer de Lincoln</translation>
    </message>
    <message>
        <source>New Siberian Islands</source>
        <translation>Îles de Nouvelle-Sibérie</translation>
    </message>
    <message>
        <source>Newfoundland</source>
        <translation>Terre-Neuve</translation>
    </message>
    <message>
        <source>North Cape</source>
        <translation>Cap Nord</translation>
    </message>
    <message>
        <source>North Sea</source>
        <translation>Mer du Nord</translation>
    </message>
    <message>
        <source>Norwegian Sea</source>
        <translation>Mer de Norvège</translation>
    </message>
    <message>
        <source>Scotia Sea</source>
        <translation>Mer de Scotia</translation>
    </message>
    <message>
        <source>Severnaya Zemlya</source>
        <translation>Terre du Nord</translation>
    </message>
    <message>
        <source>South Orkney Islands</source>
        <translation>Orcades du Sud</translation>
    </message>
    <message>
        <source>South Shetland Islands</source>
        <translation>Shetland du Sud</translation>
    </message>
    <message>
        <source>Strait of Belle Isle</source>
        <translation>Détroit de Belle Isle</translation>
    </message>
    <message>
        <source>White Sea</source>
        <translation>Mer Blanche</translation>
    </message>
    <message>
        <source>Wrangel Island</source>
        <translation>Île Wrangel</translation>
    </message>
</context>
<context>
    <name>PlacingTools</name>
    <message>
        <source>Add iceberg</source>
        <translation>Ajouter un iceberg</translation>
    </message>
    <message>
        <source>Change drift</source>
        <translation>Modifier la dérive</translation>
    </message>
    <message>
        <source>Click to add an iceberg; drag to set its drift. Esc leaves the tool.</source>
        <translation>Cliquez pour ajouter un iceberg ; faites glisser pour régler sa dérive. Esc quitte l&apos;outil.</translation>
    </message>
    <message>
        <source>Place UAV</source>
        <translation>Placer le drone</translation>
    </message>
    <message>
        <source>Release to keep this heading. Esc cancels.</source>
        <translation>Relâchez pour garder ce cap. Esc annule.</translation>
    </message>
    <message>
        <source>Move asset</source>
        <translation>Déplacer le bien protégé</translation>
    </message>
    <message>
        <source>Place asset</source>
        <translation>Placer le bien protégé</translation>
    </message>
    <message>
        <source>Release to place it here. Esc cancels.</source>
        <translation>Relâchez pour le placer ici. Esc annule.</translation>
    </message>
    <message>
        <source>Click to move the asset here. Esc leaves the tool.</source>
        <translation>Cliquez pour déplacer le bien protégé ici. Esc quitte l&apos;outil.</translation>
    </message>
    <message>
        <source>Click to place the protected asset. Esc leaves the tool.</source>
        <translation>Cliquez pour placer le bien protégé. Esc quitte l&apos;outil.</translation>
    </message>
    <message>
        <source>Click to add an iceberg that appears here now; drag to set its drift. In flight this cannot be undone.</source>
        <translation>Cliquez pour ajouter un iceberg qui apparaît ici maintenant ; faites glisser pour régler sa dérive. En vol, cela ne peut pas être annulé.</translation>
    </message>
    <message>
        <source>Add UAV</source>
        <translation>Ajouter un drone</translation>
    </message>
    <message>
        <source>Click to place the UAV; drag to set its heading. Ctrl+click adds another one. Esc leaves the tool.</source>
        <translation>Cliquez pour placer le drone ; faites glisser pour régler son cap. Ctrl+clic en ajoute un autre. Esc quitte l&apos;outil.</translation>
    </message>
    <message>
        <source>Click to place %1; drag to set its heading. Ctrl+click adds another UAV. Esc leaves the tool.</source>
        <translation>Cliquez pour placer %1 ; faites glisser pour régler son cap. Ctrl+clic ajoute un autre drone. Esc quitte l&apos;outil.</translation>
    </message>
    <message>
        <source>Seen by %1.</source>
        <comment>source and its error</comment>
        <translation>Observé par : %1.</translation>
    </message>
    <message>
        <source>The scenario has %1 icebergs, the most that are possible.</source>
        <translation>Le scénario compte %1 icebergs, le maximum possible.</translation>
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
        <translation>exact</translation>
    </message>
    <message>
        <source>search and bound</source>
        <comment>solver</comment>
        <translation>recherche et borne</translation>
    </message>
    <message>
        <source>COIN-OR CBC</source>
        <comment>solver</comment>
        <translation>COIN-OR CBC</translation>
    </message>
    <message>
        <source>Solver: %1</source>
        <translation>Solveur : %1</translation>
    </message>
    <message>
        <source>Status: %1</source>
        <translation>État : %1</translation>
    </message>
    <message>
        <source>Time: %1</source>
        <translation>Temps : %1</translation>
    </message>
    <message>
        <source>Objective: %1 m²</source>
        <translation>Objectif : %1 m²</translation>
    </message>
    <message>
        <source>Lower bound: %1 m²</source>
        <translation>Borne inférieure : %1 m²</translation>
    </message>
    <message>
        <source>Warm start from the previous plan</source>
        <translation>Calculé à partir du plan précédent</translation>
    </message>
    <message>
        <source>Proven optimal, %1 (%2)</source>
        <translation>Optimalité prouvée, %1 (%2)</translation>
    </message>
    <message>
        <source>Best order so far, within %1 % of optimal</source>
        <translation>Meilleur ordre actuel, à moins de %1 % de l&apos;optimum</translation>
    </message>
    <message>
        <source>Best order so far</source>
        <translation>Meilleur ordre actuel</translation>
    </message>
    <message>
        <source>Within %1 % of optimal, %2</source>
        <translation>À moins de %1 % de l&apos;optimum, %2</translation>
    </message>
    <message>
        <source>Best order found, %1</source>
        <translation>Meilleur ordre trouvé, %1</translation>
    </message>
    <message>
        <source>Planning…</source>
        <translation>Planification…</translation>
    </message>
    <message>
        <source>No plan yet</source>
        <translation>Pas encore de plan</translation>
    </message>
    <message>
        <source>Nothing to visit now</source>
        <translation>Rien à visiter maintenant</translation>
    </message>
    <message>
        <source>Solver limit reached; flying to the nearest iceberg</source>
        <translation>Limite du solveur atteinte ; vol vers l&apos;iceberg le plus proche</translation>
    </message>
    <message>
        <source>Solver limit reached; previous plan kept</source>
        <translation>Limite du solveur atteinte ; plan précédent conservé</translation>
    </message>
    <message>
        <source>Chosen one iceberg at a time</source>
        <translation>Choisi un iceberg à la fois</translation>
    </message>
    <message>
        <source>Following the existing route</source>
        <translation>Suit la route existante</translation>
    </message>
    <message>
        <source>under 1 ms</source>
        <translation>moins de 1 ms</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Predicted zeta: %1 m² s</source>
        <translation>Zêta prévu : %1 m² s</translation>
    </message>
    <message>
        <source>Objective: %1 m² s</source>
        <translation>Objectif : %1 m² s</translation>
    </message>
    <message>
        <source>Lower bound: %1 m² s</source>
        <translation>Borne inférieure : %1 m² s</translation>
    </message>
    <message>
        <source>by assignment</source>
        <comment>solver</comment>
        <translation>par affectation</translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>%n drone</numerusform>
            <numerusform>%n drones</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n iceberg</numerusform>
            <numerusform>%n icebergs</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Run complete</source>
        <translation>Vol terminé</translation>
    </message>
    <message>
        <source>under 0.1 s</source>
        <translation>moins de 0,1 s</translation>
    </message>
    <message>
        <source>optimal</source>
        <comment>status</comment>
        <translation>optimal</translation>
    </message>
    <message>
        <source>not proven optimal</source>
        <comment>status</comment>
        <translation>optimalité non prouvée</translation>
    </message>
    <message>
        <source>no order found</source>
        <comment>status</comment>
        <translation>aucun ordre trouvé</translation>
    </message>
    <message>
        <source>No plan while the UAV returns, holds or is on the ground</source>
        <translation>Pas de plan pendant que le drone rentre, attend ou est au sol</translation>
    </message>
    <message>
        <source>The wind is too strong to return home</source>
        <translation>Le vent est trop fort pour rentrer à la base</translation>
    </message>
    <message>
        <source>Home with %1 of the reserve used</source>
        <translation>À la base avec %1 de la réserve utilisés</translation>
    </message>
    <message>
        <source>Home with %1 above the reserve</source>
        <translation>À la base avec %1 au-dessus de la réserve</translation>
    </message>
    <message>
        <source>In 1 flight in 20 the wind is too strong to return home</source>
        <translation>Dans 1 vol sur 20, le vent est trop fort pour rentrer à la base</translation>
    </message>
    <message>
        <source>1 flight in 20 uses %1 or more of the reserve</source>
        <translation>1 vol sur 20 utilise %1 ou plus de la réserve</translation>
    </message>
    <message>
        <source>1 flight in 20: %1 or less above the reserve</source>
        <translation>1 vol sur 20 : %1 ou moins au-dessus de la réserve</translation>
    </message>
    <message>
        <source>It follows from visit rates: how often icebergs can be visited.</source>
        <translation>Elle découle des fréquences de visite : à quel rythme les icebergs peuvent être visités.</translation>
    </message>
    <message>
        <source>It follows from visit sequences: how soon icebergs can be visited one after the other.</source>
        <translation>Elle découle des suites de visites : en combien de temps les icebergs peuvent être visités l&apos;un après l&apos;autre.</translation>
    </message>
    <message>
        <source>No plan while the UAV returns, is on the ground or holds. A new one is made when it resumes.</source>
        <translation>Pas de plan pendant que le drone rentre, est au sol ou attend. Un nouveau plan est établi à la reprise.</translation>
    </message>
</context>
<context>
    <name>PolicyText</name>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exact</translation>
    </message>
    <message>
        <source>COIN-OR CBC</source>
        <translation>COIN-OR CBC</translation>
    </message>
    <message>
        <source>Local search</source>
        <translation>Recherche locale</translation>
    </message>
    <message>
        <source>One way</source>
        <comment>route</comment>
        <translation>Aller simple</translation>
    </message>
    <message>
        <source>Round trip</source>
        <comment>route</comment>
        <translation>Boucle</translation>
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
        <translation>%1 h</translation>
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
        <translation>%1 W</translation>
    </message>
    <message>
        <source>%1 E</source>
        <comment>longitude</comment>
        <translation>%1 E</translation>
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
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>à partir de %1</translation>
    </message>
    <message>
        <source>at all heights</source>
        <translation>à toutes les hauteurs</translation>
    </message>
    <message>
        <source>%1 (%2 ft)</source>
        <translation>%1 (%2 pi)</translation>
    </message>
    <message>
        <source>not home</source>
        <translation>pas à la base</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>pi</translation>
    </message>
    <message>
        <source>%1 ft</source>
        <translation>%1 pi</translation>
    </message>
    <message>
        <source>%1 ft (%2)</source>
        <translation>%1 pi (%2)</translation>
    </message>
    <message>
        <source>σ %1 (95 % within %2)</source>
        <translation>σ %1 (95 % dans un rayon de %2)</translation>
    </message>
    <message>
        <source>95 % within %2 (σ %1)</source>
        <translation>95 % dans un rayon de %2 (σ %1)</translation>
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
        <translation>%1 V / %2 M</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
    </message>
    <message>
        <source>Visits planned</source>
        <translation>Visites planifiées</translation>
    </message>
    <message>
        <source>flown</source>
        <translation>effectué</translation>
    </message>
    <message>
        <source>Time planned</source>
        <translation>Temps planifié</translation>
    </message>
    <message>
        <source>aloft</source>
        <translation>en l&apos;air</translation>
    </message>
    <message>
        <source>Outside the flight geography</source>
        <translation>Hors de la géographie de vol</translation>
    </message>
    <message>
        <source>Planned and flown</source>
        <translation>Prévu et effectué</translation>
    </message>
    <message>
        <source>SHA-256 of the first plan as a file of the format wpl:</source>
        <translation>SHA-256 du premier plan en fichier au format wpl :</translation>
    </message>
    <message>
        <source>Zeta over time</source>
        <translation>Zêta dans le temps</translation>
    </message>
    <message>
        <source>ζ over time</source>
        <translation>ζ dans le temps</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Iceberg</translation>
    </message>
    <message>
        <source>First seen</source>
        <translation>Première observation</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Dernière observation</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Visites</translation>
    </message>
    <message>
        <source>Longest unseen</source>
        <translation>Plus longtemps non vu</translation>
    </message>
    <message>
        <source>σ at the end, m²</source>
        <translation>σ à la fin, m²</translation>
    </message>
    <message>
        <source>never</source>
        <translation>jamais</translation>
    </message>
    <message>
        <source>Sightings</source>
        <translation>Observations</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 de plus</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Écarts</translation>
    </message>
    <message>
        <source>None on record.</source>
        <translation>Aucun écart enregistré.</translation>
    </message>
    <message>
        <source>Flight log: %1</source>
        <translation>Journal de vol : %1</translation>
    </message>
    <message>
        <source>Cases in which each tau is the best</source>
        <translation>Cas où chaque tau est le meilleur</translation>
    </message>
    <message>
        <source>cases</source>
        <translation>cas</translation>
    </message>
    <message>
        <source>τ of the lowest ζ of a case</source>
        <translation>τ du ζ le plus bas d&apos;un cas</translation>
    </message>
    <message>
        <source>a scenario without a name</source>
        <translation>un scénario sans nom</translation>
    </message>
    <message>
        <source>%1: icebergs: %2, seed %3, %4 s in steps of %5 s</source>
        <translation>%1 : icebergs : %2, graine %3, %4 s par pas de %5 s</translation>
    </message>
    <message>
        <source>without noise</source>
        <translation>sans bruit</translation>
    </message>
    <message>
        <source>measured with noise, velocities known</source>
        <translation>mesuré avec du bruit, vitesses connues</translation>
    </message>
    <message>
        <source>measured with noise, velocities uncertain by 0.1 m/s</source>
        <translation>mesuré avec du bruit, vitesses incertaines de 0,1 m/s</translation>
    </message>
    <message>
        <source>measured with noise, unknown velocities that change like those of real icebergs</source>
        <translation>mesuré avec du bruit, vitesses inconnues qui changent comme celles d&apos;icebergs réels</translation>
    </message>
    <message>
        <source>Random fields: %1, seeds %2 to %3. Icebergs in each: %4, in %5 m × %6 m, drifting at up to %7 m/s</source>
        <translation>Champs aléatoires : %1, graines %2 à %3. Icebergs dans chacun : %4, dans %5 m × %6 m, dérivant à %7 m/s au plus</translation>
    </message>
    <message>
        <source>initial σ of %1 to %2 m², growing by q = %3 m²/s</source>
        <translation>σ initial de %1 à %2 m², croissant de q = %3 m²/s</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Scénarios</translation>
    </message>
    <message>
        <source>Policies</source>
        <translation>Stratégies</translation>
    </message>
    <message>
        <source>the scenario’s own seed, the same for every setting</source>
        <translation>la graine du scénario, la même pour tous les réglages</translation>
    </message>
    <message>
        <source>seeds for each scenario: %1, starting with its own, the same for every setting</source>
        <translation>graines par scénario : %1, d&apos;abord la sienne, les mêmes pour tous les réglages</translation>
    </message>
    <message>
        <source>%1 to %2 by %3 (%4 values)</source>
        <translation>%1 à %2 par pas de %3 (%4 valeurs)</translation>
    </message>
    <message>
        <source>Random fields: %1, icebergs in each: %2</source>
        <translation>Champs aléatoires : %1, icebergs dans chacun : %2</translation>
    </message>
    <message>
        <source>Study, scenarios: %1</source>
        <translation>Étude, scénarios : %1</translation>
    </message>
    <message>
        <source>What was flown</source>
        <translation>Le vol effectué</translation>
    </message>
    <message>
        <source>Trade-off τ</source>
        <translation>Compromis τ</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Bruit</translation>
    </message>
    <message>
        <source>Missions</source>
        <translation>Missions</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Created</source>
        <translation>Créé</translation>
    </message>
    <message>
        <source>Last run took</source>
        <translation>Durée de la dernière exécution</translation>
    </message>
    <message>
        <source>How to reproduce this report</source>
        <translation>Comment reproduire ce rapport</translation>
    </message>
    <message>
        <source>This page contains the whole study with every scenario, seed and result, and Bergwatch opens it as a study file. To make the page again from these results:</source>
        <translation>Cette page contient toute l&apos;étude, avec chaque scénario, graine et résultat, et Bergwatch l&apos;ouvre comme un fichier d&apos;étude. Pour refaire la page à partir de ces résultats :</translation>
    </message>
    <message>
        <source>To fly the study again; the results depend neither on the machine nor on the number of threads:</source>
        <translation>Pour jouer de nouveau l&apos;étude ; les résultats ne dépendent ni de la machine ni du nombre de fils d&apos;exécution :</translation>
    </message>
    <message>
        <source>To fly the study again with your scenario files; the results depend neither on the machine nor on the number of threads:</source>
        <translation>Pour jouer de nouveau l&apos;étude avec vos fichiers de scénario ; les résultats ne dépendent ni de la machine ni du nombre de fils d&apos;exécution :</translation>
    </message>
    <message>
        <source>ζ is the total uncertainty σ of all icebergs, integrated over the flight. Lower is better.</source>
        <translation>ζ est l&apos;incertitude totale σ de tous les icebergs, intégrée sur le vol. Plus il est bas, mieux c&apos;est.</translation>
    </message>
    <message>
        <source>There is only one case, so there is no spread to show.</source>
        <translation>Il n&apos;y a qu&apos;un seul cas, donc aucune dispersion à montrer.</translation>
    </message>
    <message>
        <source>Differences are taken case by case, with the same icebergs and the same noise; the bars are 95 % intervals of the mean (Student’s t). Values left of 0 are better than the reference.</source>
        <translation>Les différences sont calculées cas par cas, avec les mêmes icebergs et le même bruit ; les barres sont les intervalles à 95 % de la moyenne (t de Student). Les valeurs à gauche de 0 sont meilleures que la référence.</translation>
    </message>
    <message>
        <source>Not every τ is drawn; the table contains all of them.</source>
        <translation>Tous les τ ne sont pas dessinés ; le tableau les contient tous.</translation>
    </message>
    <message>
        <source>ζ against τ</source>
        <translation>ζ selon τ</translation>
    </message>
    <message>
        <source>Differences vs the reference</source>
        <translation>Différences par rapport à la référence</translation>
    </message>
    <message>
        <source>Best τ of each case</source>
        <translation>Meilleur τ de chaque cas</translation>
    </message>
    <message>
        <source>The τ with the lowest ζ of a case, chosen in hindsight; it is not known before the flight. If several are equal, the smallest counts.</source>
        <translation>Le τ du ζ le plus bas d&apos;un cas, choisi après coup ; il n&apos;est pas connu avant le vol. À égalité, le plus petit compte.</translation>
    </message>
    <message>
        <source>Stuck: at most two icebergs were targets in the second half of the flight.</source>
        <translation>Bloqué : deux icebergs au plus ont été des cibles dans la seconde moitié du vol.</translation>
    </message>
    <message>
        <source>ζ of the case and its difference vs %1.</source>
        <translation>ζ du cas et sa différence avec %1.</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Difference, m² s</source>
        <translation>Différence, m² s</translation>
    </message>
    <message>
        <source>Difference, %</source>
        <translation>Différence, %</translation>
    </message>
    <message>
        <source>Stuck</source>
        <translation>Bloqué</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>ζ in m² s. Cases: %1.</source>
        <translation>ζ en m² s. Cas : %1.</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>Erreur type</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Médiane</translation>
    </message>
    <message>
        <source>Differences of ζ vs %1, case by case, with 95 % intervals of the mean. Worst: the largest difference of a case.</source>
        <translation>Différences de ζ avec %1, cas par cas, avec les intervalles à 95 % de la moyenne. Pire : la plus grande différence d&apos;un cas.</translation>
    </message>
    <message>
        <source>Mean, m² s</source>
        <translation>Moyenne, m² s</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>Intervalle à 95 %</translation>
    </message>
    <message>
        <source>Mean, %</source>
        <translation>Moyenne, %</translation>
    </message>
    <message>
        <source>Cases below</source>
        <translation>Cas au-dessous</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Pire</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>référence</translation>
    </message>
    <message>
        <source>best τ of each case</source>
        <translation>meilleur τ de chaque cas</translation>
    </message>
    <message>
        <source>Best τ of each case, chosen in hindsight</source>
        <translation>Meilleur τ de chaque cas, choisi après coup</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Cas</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>One case is too few to recommend a policy. Fly more cases.</source>
        <translation>Un seul cas ne suffit pas pour recommander une stratégie. Jouez d&apos;autres cas.</translation>
    </message>
    <message>
        <source>Lowest ζ: %1, %2 m² s.</source>
        <translation>ζ le plus bas : %1, %2 m² s.</translation>
    </message>
    <message>
        <source>Lowest mean ζ: %1, %2 m² s.</source>
        <translation>ζ moyen le plus bas : %1, %2 m² s.</translation>
    </message>
    <message>
        <source>Lowest ζ: %1, %2 m² s, %3 against %4.</source>
        <translation>ζ le plus bas : %1, %2 m² s, %3 par rapport à %4.</translation>
    </message>
    <message>
        <source>Best τ of this case: %1.</source>
        <translation>Meilleur τ de ce cas : %1.</translation>
    </message>
    <message>
        <source>Best τ of each case, chosen in hindsight: median %1, 80 % of the cases between %2 and %3; its mean ζ is %4 against %5.</source>
        <translation>Meilleur τ de chaque cas, choisi après coup : médiane %1, 80 % des cas entre %2 et %3 ; son ζ moyen est à %4 de %5.</translation>
    </message>
    <message>
        <source>Not complete.</source>
        <translation>Incomplet.</translation>
    </message>
    <message>
        <source>Missions flown: %1 of %2. The results below use only the cases that every setting has flown: %3 of %4.</source>
        <translation>Missions jouées : %1 sur %2. Les résultats ci-dessous n&apos;utilisent que les cas que chaque réglage a joués : %3 sur %4.</translation>
    </message>
    <message>
        <source>Missions: %1. Cases: %2, each flown with every setting. Settings: %3.</source>
        <translation>Missions : %1. Cas : %2, chacun joué avec chaque réglage. Réglages : %3.</translation>
    </message>
    <message>
        <source>The numbers</source>
        <translation>Les nombres</translation>
    </message>
    <message>
        <source>en</source>
        <translation>fr</translation>
    </message>
    <message>
        <source>Longest unseen: from when an iceberg was known of, or seen, until it was seen again, left, was removed or the record ends.</source>
        <translation>Plus long sans vue : depuis qu&apos;un iceberg est connu, ou vu, jusqu&apos;à ce qu&apos;il soit revu, sorti, retiré ou que l&apos;enregistrement finisse.</translation>
    </message>
    <message>
        <source>Planned: the first sortie of the plan before take-off, over ground in straight legs. Distances flown are through the air.</source>
        <translation>Prévu : la première sortie du plan avant le décollage, sur le fond en segments droits. Les distances parcourues sont dans l&apos;air.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 de plus</translation>
    </message>
    <message>
        <source>No clear winner. These settings may be the best: %1.</source>
        <translation>Aucun réglage ne l&apos;emporte nettement. Les meilleurs peuvent être : %1.</translation>
    </message>
    <message>
        <source>Recommended: %1, %2 against %3, the closest other setting.</source>
        <translation>Recommandé : %1, %2 par rapport à %3, le réglage le plus proche.</translation>
    </message>
    <message>
        <source>Took off</source>
        <translation>Décollage</translation>
    </message>
    <message>
        <source>Landed</source>
        <translation>Atterrissage</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Zeta flown</source>
        <translation>Zêta du vol</translation>
    </message>
    <message>
        <source>Predicted before take-off</source>
        <translation>Prévu avant le décollage</translation>
    </message>
    <message>
        <source>Plans made</source>
        <translation>Plans établis</translation>
    </message>
    <message>
        <source>Planned by</source>
        <translation>Planifié par</translation>
    </message>
    <message>
        <source>Distance planned</source>
        <translation>Distance planifiée</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % dans un rayon de</translation>
    </message>
    <message>
        <source>Something was changed in flight: the prediction was for another flight.</source>
        <translation>Quelque chose a été modifié en vol : la prévision portait sur un autre vol.</translation>
    </message>
    <message>
        <source>Sum of σ, m²</source>
        <translation>Somme des σ, m²</translation>
    </message>
    <message>
        <source>iceberg reached</source>
        <translation>iceberg atteint</translation>
    </message>
    <message>
        <source>Time since the start</source>
        <translation>Temps depuis le début</translation>
    </message>
    <message>
        <source>Zeta over time, in the end %1.</source>
        <translation>Zêta dans le temps, à la fin %1.</translation>
    </message>
    <message>
        <source>Lowest: %1.</source>
        <translation>Le plus bas : %1.</translation>
    </message>
    <message>
        <source>Lowest: %1; of the values of τ: %2.</source>
        <translation>Le plus bas : %1 ; parmi les valeurs de τ : %2.</translation>
    </message>
    <message>
        <source>Band: quartiles. Dashed: median. Ring: reference.</source>
        <translation>Bande : quartiles. Tirets : médiane. Cercle : référence.</translation>
    </message>
    <message>
        <source>Ring: reference.</source>
        <translation>Cercle : référence.</translation>
    </message>
    <message>
        <source>Mean ζ, %1</source>
        <translation>ζ moyen, %1</translation>
    </message>
    <message>
        <source>Zeta ζ, %1</source>
        <translation>Zêta ζ, %1</translation>
    </message>
    <message>
        <source>%1 vs %2</source>
        <translation>%1 contre %2</translation>
    </message>
    <message>
        <source>ζ %1 m² s</source>
        <translation>ζ %1 m² s</translation>
    </message>
    <message>
        <source>mean %1, median %2</source>
        <translation>moyenne %1, médiane %2</translation>
    </message>
    <message>
        <source>quartiles %1 to %2</source>
        <translation>quartiles %1 à %2</translation>
    </message>
    <message>
        <source>stuck in %1 of %2 cases</source>
        <translation>bloqué dans %1 cas sur %2</translation>
    </message>
    <message>
        <source>stuck: visits at most two icebergs in the second half</source>
        <translation>bloqué : visite deux icebergs au plus dans la seconde moitié</translation>
    </message>
    <message>
        <source>Less ζ is better: to the left</source>
        <translation>Moins de ζ est meilleur : vers la gauche</translation>
    </message>
    <message>
        <source>Mean of the cases with its 95 % confidence interval</source>
        <translation>Moyenne des cas avec son intervalle de confiance à 95 %</translation>
    </message>
    <message>
        <source>Difference of ζ vs %1, %</source>
        <translation>Différence de ζ par rapport à %1, %</translation>
    </message>
    <message>
        <source>the reference</source>
        <translation>la référence</translation>
    </message>
    <message>
        <source>95 %: %1 to %2</source>
        <translation>95 % : %1 à %2</translation>
    </message>
    <message>
        <source>less in %1 of %2 cases</source>
        <translation>inférieur dans %1 cas sur %2</translation>
    </message>
    <message>
        <source>worst %1</source>
        <translation>pire %1</translation>
    </message>
    <message>
        <source>Accumulated uncertainty ζ against the trade-off τ</source>
        <translation>Incertitude cumulée ζ en fonction du compromis τ</translation>
    </message>
    <message>
        <source>The line is the mean over the cases (%1), dashed their median; the band contains the middle half of them. Horizontal lines are the means of policies without τ.</source>
        <translation>La ligne est la moyenne des cas (%1), en tirets leur médiane ; la bande contient la moitié centrale d&apos;entre eux. Les lignes horizontales sont les moyennes des stratégies sans τ.</translation>
    </message>
    <message>
        <source>Weighted visiting order (published method)</source>
        <translation>Ordre de visite pondéré (méthode publiée)</translation>
    </message>
    <message>
        <source>τ %1</source>
        <translation>τ %1</translation>
    </message>
    <message>
        <source>Weighs seeing uncertain icebergs early against path length, by τ.</source>
        <translation>Pondère par τ l&apos;observation précoce des icebergs incertains et la longueur du trajet.</translation>
    </message>
    <message>
        <source>Weighted visiting order, trade-off τ %1</source>
        <translation>Ordre de visite pondéré, compromis τ %1</translation>
    </message>
    <message>
        <source>Shortest path, repeated</source>
        <translation>Plus court chemin, répété</translation>
    </message>
    <message>
        <source>Shortest path</source>
        <translation>Plus court chemin</translation>
    </message>
    <message>
        <source>Flies the shortest path past all icebergs, then the next one.</source>
        <translation>Suit le plus court chemin passant par tous les icebergs, puis le suivant.</translation>
    </message>
    <message>
        <source>Shortest round tour, repeated</source>
        <translation>Plus court circuit, répété</translation>
    </message>
    <message>
        <source>Round tour</source>
        <translation>Circuit</translation>
    </message>
    <message>
        <source>Flies one shortest round tour again and again.</source>
        <translation>Suit sans cesse un même circuit, le plus court.</translation>
    </message>
    <message>
        <source>Nearest iceberg first</source>
        <translation>Iceberg le plus proche d&apos;abord</translation>
    </message>
    <message>
        <source>Nearest first</source>
        <translation>Plus proche d&apos;abord</translation>
    </message>
    <message>
        <source>Flies to the nearest iceberg out of view.</source>
        <translation>Va à l&apos;iceberg hors de vue le plus proche.</translation>
    </message>
    <message>
        <source>Most uncertain iceberg first</source>
        <translation>Iceberg le plus incertain d&apos;abord</translation>
    </message>
    <message>
        <source>Most uncertain first</source>
        <translation>Plus incertain d&apos;abord</translation>
    </message>
    <message>
        <source>Flies to the most uncertain iceberg.</source>
        <translation>Va à l&apos;iceberg le plus incertain.</translation>
    </message>
    <message>
        <source>Least waiting time</source>
        <translation>Temps d&apos;attente minimal</translation>
    </message>
    <message>
        <source>Least waiting</source>
        <translation>Attente minimale</translation>
    </message>
    <message>
        <source>Keeps the waiting time of all icebergs short, weighted by their uncertainty.</source>
        <translation>Garde court le temps d&apos;attente de tous les icebergs, pondéré par leur incertitude.</translation>
    </message>
    <message>
        <source>Least waiting time, weighted by uncertainty</source>
        <translation>Attente minimale, pondérée par l&apos;incertitude</translation>
    </message>
    <message>
        <source>Best predicted coverage</source>
        <translation>Meilleure couverture prévue</translation>
    </message>
    <message>
        <source>Best coverage</source>
        <translation>Meilleure couverture</translation>
    </message>
    <message>
        <source>Predicts zeta for paths that pass icebergs at an offset and see several at once.</source>
        <translation>Prévoit zêta pour des trajectoires qui passent les icebergs à distance et en voient plusieurs à la fois.</translation>
    </message>
    <message>
        <source>Zeta by start time</source>
        <translation>Zêta selon l&apos;heure de départ</translation>
    </message>
    <message>
        <source>Start, UTC</source>
        <translation>Départ, UTC</translation>
    </message>
    <message>
        <source>Faint: marginal or unknown weather. Hatched: no-go.</source>
        <translation>Pâle : météo marginale ou inconnue. Hachuré : interdit.</translation>
    </message>
    <message>
        <source>Best start: %1 UTC.</source>
        <translation>Meilleur départ : %1 UTC.</translation>
    </message>
    <message>
        <source>No start has weather within all limits.</source>
        <translation>Aucun départ n&apos;a une météo dans toutes les limites.</translation>
    </message>
    <message>
        <source>cannot be flown</source>
        <translation>ne peut pas être volé</translation>
    </message>
    <message>
        <source>weather: %1</source>
        <translation>météo : %1</translation>
    </message>
    <message>
        <source>go</source>
        <translation>favorable</translation>
    </message>
    <message>
        <source>marginal</source>
        <translation>marginale</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>no-go</source>
        <translation>interdit</translation>
    </message>
    <message>
        <source>Forecast</source>
        <translation>Prévision</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Issued</source>
        <translation>Émise</translation>
    </message>
    <message>
        <source>Age at take-off</source>
        <translation>Âge au décollage</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>Used in flight, at the middle of the starts of the UAVs.</source>
        <translation>Utilisés en vol, au milieu des points de départ des drones.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Wind, true</source>
        <translation>Vent, vrai</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Rafales</translation>
    </message>
    <message>
        <source>Current, true</source>
        <translation>Courant, vrai</translation>
    </message>
    <message>
        <source>No wind</source>
        <translation>Aucun vent</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1 du %2</translation>
    </message>
    <message>
        <source>%1 towards %2</source>
        <translation>%1 vers le %2</translation>
    </message>
    <message>
        <source>The forecast has no wind between %1 and %2: the flight used the constant wind of the scenario.</source>
        <translation>La prévision ne donne pas de vent entre %1 et %2 : le vol a utilisé le vent constant du scénario.</translation>
    </message>
    <message>
        <source>The forecast has no current between %1 and %2: the flight used the constant current of the scenario.</source>
        <translation>La prévision ne donne pas de courant entre %1 et %2 : le vol a utilisé le courant constant du scénario.</translation>
    </message>
</context>
<context>
    <name>SelectTool</name>
    <message>
        <source>Release to place it here. Esc cancels.</source>
        <translation>Relâchez pour le placer ici. Esc annule.</translation>
    </message>
    <message>
        <source>Everything inside the frame is selected.</source>
        <translation>Tout ce qui est dans le cadre est sélectionné.</translation>
    </message>
    <message>
        <source>Click to select, drag to move. Ctrl+click adds; drag on open water to select a box.</source>
        <translation>Cliquez pour sélectionner, faites glisser pour déplacer. Ctrl+clic ajoute ; faites glisser sur l&apos;eau libre pour sélectionner par un cadre.</translation>
    </message>
    <message>
        <source>Click to select. In flight you can drag the tip of the wind arrow and the asset.</source>
        <translation>Cliquez pour sélectionner. En vol, vous pouvez faire glisser la pointe de la flèche du vent et le bien protégé.</translation>
    </message>
    <message>
        <source>Click to select. Choose Stop and edit to change the scenario.</source>
        <translation>Cliquez pour sélectionner. Choisissez « Arrêter et modifier » pour modifier le scénario.</translation>
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
        <translation>CPLEX, moyenne (article)</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exact</translation>
    </message>
    <message>
        <source>Local search</source>
        <translation>Recherche locale</translation>
    </message>
    <message>
        <source>CBC, by position</source>
        <translation>CBC, par rang</translation>
    </message>
    <message>
        <source>CBC, as printed</source>
        <translation>CBC, tel qu&apos;imprimé</translation>
    </message>
    <message>
        <source>CBC, reduced</source>
        <translation>CBC, réduit</translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>ship&apos;s radar</source>
        <translation>radar de navire</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>vue</translation>
    </message>
    <message>
        <source>satellite</source>
        <translation>satellite</translation>
    </message>
    <message>
        <source>camera of a UAV</source>
        <translation>caméra d&apos;un drone</translation>
    </message>
    <message>
        <source>GPS beacon</source>
        <translation>balise GPS</translation>
    </message>
    <message>
        <source>Argos beacon</source>
        <translation>balise Argos</translation>
    </message>
    <message>
        <source>%1, 95 % within %2</source>
        <translation>%1, 95 % dans un rayon de %2</translation>
    </message>
    <message>
        <source>AIS</source>
        <translation>AIS</translation>
    </message>
    <message>
        <source>aircraft</source>
        <translation>avion</translation>
    </message>
</context>
<context>
    <name>StudyTables</name>
    <message>
        <source>Best τ of each case</source>
        <translation>Meilleur τ de chaque cas</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <comment>from, to</comment>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>référence</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>The τ of lowest ζ of each case, chosen in hindsight: median %1, quartiles %2 and %3.</source>
        <translation>Le τ de plus faible ζ de chaque cas, choisi a posteriori : médiane %1, quartiles %2 et %3.</translation>
    </message>
    <message>
        <source>Less than the reference in %1 of %2 cases, worst %3. On average %4 visits.</source>
        <translation>Inférieur à la référence dans %1 cas sur %2, pire %3. En moyenne %4 visites.</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>bloqué</translation>
    </message>
    <message>
        <source>%1 visits, %2 plans, %3 flown. Return or a double click opens this run.</source>
        <translation>%1 visites, %2 plans, %3 parcourus. Entrée ou un double-clic ouvre ce vol.</translation>
    </message>
    <message>
        <source>Random %1</source>
        <comment>scenario drawn from a seed</comment>
        <translation>Aléatoire %1</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Mean ζ</source>
        <translation>ζ moyen</translation>
    </message>
    <message>
        <source>Median ζ</source>
        <translation>ζ médian</translation>
    </message>
    <message>
        <source>Quartiles</source>
        <translation>Quartiles</translation>
    </message>
    <message>
        <source>vs reference</source>
        <translation>Écart à la réf.</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>Intervalle à 95 %</translation>
    </message>
    <message>
        <source>Best in</source>
        <translation>Meilleur dans</translation>
    </message>
    <message>
        <source>Stuck</source>
        <translation>Bloqué</translation>
    </message>
    <message>
        <source>How the next iceberg is chosen.</source>
        <translation>Comment l&apos;iceberg suivant est choisi.</translation>
    </message>
    <message>
        <source>Accumulated uncertainty in m² s, mean of all cases: less is better.</source>
        <translation>Incertitude cumulée en m² s, moyenne de tous les cas : une valeur plus faible est meilleure.</translation>
    </message>
    <message>
        <source>Half of the cases have less.</source>
        <translation>La moitié des cas en a moins.</translation>
    </message>
    <message>
        <source>A quarter of the cases has less than the first, a quarter more than the second.</source>
        <translation>Un quart des cas en a moins que le premier, un quart plus que le second.</translation>
    </message>
    <message>
        <source>Mean of the differences, case by case, in per cent of the reference.</source>
        <translation>Moyenne des différences, cas par cas, en pour cent de la référence.</translation>
    </message>
    <message>
        <source>Confidence interval of the mean difference by Student&apos;s t.</source>
        <translation>Intervalle de confiance de la différence moyenne selon la loi de Student.</translation>
    </message>
    <message>
        <source>Cases in which no other setting has less ζ.</source>
        <translation>Cas où aucun autre réglage n&apos;a un ζ plus faible.</translation>
    </message>
    <message>
        <source>Cases that visit at most two icebergs in the second half.</source>
        <translation>Cas qui visitent deux icebergs au plus dans la seconde moitié.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Cas</translation>
    </message>
    <message>
        <source>Noise seed</source>
        <translation>Graine du bruit</translation>
    </message>
    <message>
        <source>ζ, m² s</source>
        <translation>ζ, m² s</translation>
    </message>
    <message>
        <source>Best τ</source>
        <translation>Meilleur τ</translation>
    </message>
    <message>
        <source>Best of all</source>
        <translation>Meilleur de tous</translation>
    </message>
    <message>
        <source>Name of the scenario, or the seed it was drawn from.</source>
        <translation>Nom du scénario, ou graine dont il a été tiré.</translation>
    </message>
    <message>
        <source>Seed of the true drift, the same for every setting.</source>
        <translation>Graine de la dérive réelle, la même pour chaque réglage.</translation>
    </message>
    <message>
        <source>Accumulated uncertainty of this flight: less is better.</source>
        <translation>Incertitude cumulée de ce vol : une valeur plus faible est meilleure.</translation>
    </message>
    <message>
        <source>Compared with the flight of this case with the reference.</source>
        <translation>Comparé au vol de ce cas avec la référence.</translation>
    </message>
    <message>
        <source>The τ with the lowest ζ in this case, in hindsight.</source>
        <translation>Le τ de plus faible ζ dans ce cas, a posteriori.</translation>
    </message>
    <message>
        <source>The setting with the lowest ζ in this case.</source>
        <translation>Le réglage de plus faible ζ dans ce cas.</translation>
    </message>
    <message>
        <source>Visits at most two icebergs in the second half.</source>
        <translation>Visite deux icebergs au plus dans la seconde moitié.</translation>
    </message>
</context>
<context>
    <name>TimeChartText</name>
    <message>
        <source>Time, h:mm:ss</source>
        <translation>Temps, h:mm:ss</translation>
    </message>
    <message>
        <source>Time, mm:ss</source>
        <translation>Temps, mm:ss</translation>
    </message>
    <message>
        <source>Time, UTC</source>
        <translation>Heure, UTC</translation>
    </message>
</context>
<context>
    <name>TimeEntry</name>
    <message>
        <source>The day and month of &quot;%1&quot; are ambiguous. Type the date like 2026-11-29 12:00.</source>
        <translation>Le jour et le mois de « %1 » sont ambigus. Écrivez la date comme 2026-11-29 12:00.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no date. Type it like 2026-11-29 12:00.</source>
        <translation>« %1 » n&apos;a pas de date. Écrivez-le comme 2026-11-29 12:00.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a date and time. Type it like 2026-11-29 12:00 or 29 Nov 2026 12:00.</source>
        <translation>« %1 » n&apos;est pas une date avec heure. Écrivez-la comme 2026-11-29 12:00 ou 29 Nov 2026 12:00.</translation>
    </message>
</context>
<context>
    <name>WeatherChart</name>
    <message>
        <source>Wind limit %1</source>
        <translation>Limite de vent %1</translation>
    </message>
    <message>
        <source>Gust limit %1</source>
        <translation>Limite de rafales %1</translation>
    </message>
    <message>
        <source>no wind</source>
        <translation>aucun vent</translation>
    </message>
    <message>
        <source>wind %1 from %2</source>
        <translation>vent %1 du %2</translation>
    </message>
    <message>
        <source>gusts %1</source>
        <translation>rafales %1</translation>
    </message>
    <message>
        <source>current %1 towards %2</source>
        <translation>courant %1 vers le %2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>du %1</translation>
    </message>
    <message>
        <source>towards %1</source>
        <translation>vers le %1</translation>
    </message>
    <message>
        <source>Forecast of wind and current</source>
        <translation>Prévision du vent et du courant</translation>
    </message>
    <message>
        <source>Wind and current</source>
        <translation>Vent et courant</translation>
    </message>
    <message>
        <source>Wind, %1</source>
        <translation>Vent, %1</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vent</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Rafales</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Courant</translation>
    </message>
    <message>
        <source>Current, %1</source>
        <translation>Courant, %1</translation>
    </message>
    <message>
        <source>The forecast does not cover this run</source>
        <translation>La prévision ne couvre pas ce vol</translation>
    </message>
    <message>
        <source>Weather at %1: %2.</source>
        <translation>Météo à %1 : %2.</translation>
    </message>
    <message>
        <source>Flown in gaps: constant wind %1</source>
        <translation>Volé dans les lacunes : vent constant %1</translation>
    </message>
    <message>
        <source>%1; in gaps the constant current of %2</source>
        <comment>title, speed</comment>
        <translation>%1 ; dans les lacunes, le courant constant de %2</translation>
    </message>
</context>
<context>
    <name>WeatherWords</name>
    <message>
        <source>wind</source>
        <translation>vent</translation>
    </message>
    <message>
        <source>gusts</source>
        <translation>rafales</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>visibilité</translation>
    </message>
    <message>
        <source>cloud base</source>
        <translation>plafond</translation>
    </message>
    <message>
        <source>icing</source>
        <translation>givrage</translation>
    </message>
    <message>
        <source>%1 UTC</source>
        <translation>%1 UTC</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Favorable</translation>
    </message>
    <message>
        <source>Marginal</source>
        <translation>Marginale</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>Inconnue</translation>
    </message>
    <message>
        <source>No-go</source>
        <translation>Interdit</translation>
    </message>
    <message>
        <source>%1 not known, limit %2</source>
        <translation>%1 inconnu, limite %2</translation>
    </message>
    <message>
        <source>%1 %2, limit %3</source>
        <comment>wind, its value, its limit</comment>
        <translation>%1 %2, limite %3</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a UAV and what concerns it</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2, from %3</source>
        <comment>state, reason, time</comment>
        <translation>%1 : %2, à partir de %3</translation>
    </message>
</context>
<context>
    <name>WindText</name>
    <message>
        <source>No wind</source>
        <translation>Aucun vent</translation>
    </message>
    <message>
        <source>Wind %1
from %2, strong</source>
        <translation>Vent %1
du %2, fort</translation>
    </message>
    <message>
        <source>Wind %1
from %2</source>
        <translation>Vent %1
du %2</translation>
    </message>
    <message>
        <source>Current %1
towards %2</source>
        <translation>Courant %1
vers le %2</translation>
    </message>
    <message>
        <source>The arrow points downwind. The ring is the airspeed of the slowest UAV (%1); beyond the dashed ring UAVs make little headway.</source>
        <translation>La flèche pointe vers où souffle le vent. Le cercle est la vitesse air du drone le plus lent (%1) ; au-delà du cercle en tirets, les drones progressent peu.</translation>
    </message>
    <message>
        <source>The small aircraft in the middle of a leg shows the heading flown there.</source>
        <translation>Le petit avion au milieu d&apos;un segment montre le cap qui y est suivi.</translation>
    </message>
    <message>
        <source>reported</source>
        <translation>signalé</translation>
    </message>
    <message>
        <source>forecast</source>
        <translation>prévu</translation>
    </message>
    <message>
        <source>Gusts %1</source>
        <translation>Rafales %1</translation>
    </message>
    <message>
        <source>UAVs fly in the wind that the crew has reported, and icebergs drift in the forecast.</source>
        <translation>Les drones volent dans le vent signalé par l&apos;équipage, et les icebergs dérivent selon la prévision.</translation>
    </message>
    <message>
        <source>Remove the forecast in the Inspector to set the wind yourself.</source>
        <translation>Supprimez la prévision dans Propriétés pour régler le vent vous-même.</translation>
    </message>
</context>
<context>
    <name>WorkFailureText</name>
    <message>
        <source>Not enough memory. Close other programs or choose a smaller task.</source>
        <translation>Mémoire insuffisante. Fermez d&apos;autres programmes ou choisissez une tâche plus petite.</translation>
    </message>
    <message>
        <source>Internal error: %1</source>
        <translation>Erreur interne : %1</translation>
    </message>
</context>
<context>
    <name>berg::AircraftController</name>
    <message>
        <source>%1: no contact for %2</source>
        <translation>%1 : pas de contact depuis %2</translation>
    </message>
    <message>
        <source>contact in %1</source>
        <translation>contact dans %1</translation>
    </message>
    <message>
        <source>Link: sending</source>
        <translation>Liaison : émission</translation>
    </message>
    <message>
        <source>Link: listening</source>
        <translation>Liaison : écoute</translation>
    </message>
    <message>
        <source>Differs: the mission on board has changed since %1</source>
        <translation>Diffère : la mission à bord a changé depuis %1</translation>
    </message>
    <message>
        <source>Differs: the plan has changed since %1</source>
        <translation>Diffère : le plan a changé depuis %1</translation>
    </message>
    <message>
        <source>On board: same as the plan of %1</source>
        <translation>À bord : identique au plan de %1</translation>
    </message>
    <message>
        <source>Battery: %1</source>
        <translation>Batterie : %1</translation>
    </message>
    <message>
        <source>Link: replay</source>
        <translation>Liaison : lecture</translation>
    </message>
    <message>
        <source>Stop listening before you play a log.</source>
        <translation>Arrêtez l&apos;écoute avant de lire un journal.</translation>
    </message>
    <message>
        <source>%1 is not a telemetry log, or its beginning is damaged.</source>
        <translation>%1 n&apos;est pas un journal de télémétrie, ou son début est endommagé.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 ne peut pas être lu : %2</translation>
    </message>
    <message>
        <source>Differs: home has moved since %1</source>
        <translation>Diffère : la base s&apos;est déplacée depuis %1</translation>
    </message>
    <message>
        <source>%1 can be reached from the network, and MAVLink does not check who sends.</source>
        <translation>%1 est accessible depuis le réseau, et MAVLink ne vérifie pas qui envoie.</translation>
    </message>
    <message>
        <source>the mission was not replaced. Steering is off</source>
        <translation>la mission n&apos;a pas été remplacée. Le pilotage est désactivé</translation>
    </message>
    <message>
        <source>steering is off, because sending is</source>
        <translation>le pilotage est désactivé, comme l&apos;envoi</translation>
    </message>
    <message>
        <source>the plan has changed meanwhile. Nothing was sent</source>
        <translation>le plan a changé entre-temps. Rien n&apos;a été envoyé</translation>
    </message>
    <message>
        <source>its UAV has no plan. Nothing was sent</source>
        <translation>son drone n&apos;a pas de plan. Rien n&apos;a été envoyé</translation>
    </message>
    <message>
        <source>%1. The aircraft keeps its own fence</source>
        <translation>%1. L&apos;aéronef garde sa propre clôture</translation>
    </message>
    <message>
        <source>Telemetry logs (*.tlog *.nmea);;All files (*)</source>
        <translation>Journaux de télémétrie (*.tlog *.nmea);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>berg::AircraftPanel</name>
    <message>
        <source>from %1, %2 ± %3</source>
        <translation>du %1, %2 ± %3</translation>
    </message>
    <message>
        <source>Wind: %1</source>
        <translation>Vent : %1</translation>
    </message>
    <message>
        <source>Item %1 of %2</source>
        <translation>Élément %1 sur %2</translation>
    </message>
    <message>
        <source>Item %1</source>
        <translation>Élément %1</translation>
    </message>
    <message>
        <source>Frames lost: %1 of %2</source>
        <translation>Trames perdues : %1 sur %2</translation>
    </message>
    <message>
        <source>Listen</source>
        <translation>Écouter</translation>
    </message>
    <message>
        <source>Receives telemetry at this address. Nothing is sent.</source>
        <translation>Reçoit la télémétrie à cette adresse. Rien n&apos;est envoyé.</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Émettre</translation>
    </message>
    <message>
        <source>Rehearse</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>Upload</source>
        <translation>Envoyer</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Reads the mission on board and compares it with the plan.</source>
        <translation>Lit la mission à bord et la compare au plan.</translation>
    </message>
    <message>
        <source>Fly the mission</source>
        <translation>Voler la mission</translation>
    </message>
    <message>
        <source>Selects the mode in which the aircraft flies the mission on board. It must be in the air.</source>
        <translation>Choisit le mode dans lequel l&apos;aéronef vole la mission à bord. Il doit être en l&apos;air.</translation>
    </message>
    <message>
        <source>Use its wind</source>
        <translation>Utiliser son vent</translation>
    </message>
    <message>
        <source>The mean wind of the last minute becomes the wind of the scenario.</source>
        <translation>Le vent moyen de la dernière minute devient le vent du scénario.</translation>
    </message>
    <message>
        <source>Fly with the aircraft</source>
        <translation>Voler avec l&apos;aéronef</translation>
    </message>
    <message>
        <source>The flight in this window follows the aircraft: charts and uncertainty show the real flight.</source>
        <translation>Le vol de la fenêtre suit l&apos;aéronef : graphiques et incertitude montrent le vol réel.</translation>
    </message>
    <message>
        <source>Events of the link</source>
        <translation>Événements de la liaison</translation>
    </message>
    <message>
        <source>Address of the link</source>
        <translation>Adresse de la liaison</translation>
    </message>
    <message>
        <source>udp:HOST:PORT listens, udpout:HOST:PORT sends to one address; also tcp:HOST:PORT and serial:DEVICE:BAUD</source>
        <translation>udp:HÔTE:PORT écoute, udpout:HÔTE:PORT émet vers une adresse ; aussi tcp:HÔTE:PORT et serial:PÉRIPHÉRIQUE:BAUD</translation>
    </message>
    <message>
        <source>Off: not a byte is sent. On: heartbeats, requests for telemetry and what you choose below are sent.</source>
        <translation>Arrêt : aucun octet n&apos;est envoyé. Marche : signaux de présence, demandes de télémétrie et ce que vous choisissez ci-dessous sont envoyés.</translation>
    </message>
    <message>
        <source>Aircraft heard</source>
        <translation>Aéronefs entendus</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Aéronefs</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Last position</source>
        <translation>Dernière position</translation>
    </message>
    <message>
        <source>Flies as</source>
        <translation>Vole comme</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Pilotage</translation>
    </message>
    <message>
        <source>Do not steer</source>
        <translation>Ne pas piloter</translation>
    </message>
    <message>
        <source>Replace the mission when the plan changes</source>
        <translation>Remplacer la mission quand le plan change</translation>
    </message>
    <message>
        <source>Guide from iceberg to iceberg</source>
        <translation>Guider d&apos;iceberg en iceberg</translation>
    </message>
    <message>
        <source>No UAV</source>
        <translation>Aucun drone</translation>
    </message>
    <message>
        <source>The link is off.</source>
        <translation>La liaison est coupée.</translation>
    </message>
    <message>
        <source>Listening. No aircraft has been heard yet.</source>
        <translation>À l&apos;écoute. Aucun aéronef n&apos;a encore été entendu.</translation>
    </message>
    <message>
        <source>No position yet. Some autopilots report it only while Send is on.</source>
        <translation>Pas encore de position. Certains autopilotes ne la donnent que si Émettre est activé.</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>pas de contact</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>aucune encore</translation>
    </message>
    <message>
        <source>The flight follows the aircraft</source>
        <translation>Le vol suit l&apos;aéronef</translation>
    </message>
    <message>
        <source>%1  Attention: %2</source>
        <translation>%1  Attention : %2</translation>
    </message>
    <message>
        <source>No aircraft in the log so far.</source>
        <translation>Aucun aéronef dans le journal jusqu&apos;ici.</translation>
    </message>
    <message>
        <source>Simulated aircraft fly from the UAVs of the scenario and send their telemetry over the network of this computer. Not while another link is open.</source>
        <translation>Des aéronefs simulés partent des drones du scénario et envoient leur télémétrie par le réseau de cet ordinateur. Pas tant qu&apos;une autre liaison est ouverte.</translation>
    </message>
    <message>
        <source>Uploads the plan with its fence and rally point, reads it back and compares it. If the plan has no fence, the aircraft keeps its own.</source>
        <translation>Envoie le plan avec sa clôture et son point de ralliement, le relit et le compare. Si le plan n&apos;a pas de clôture, l&apos;aéronef garde la sienne.</translation>
    </message>
</context>
<context>
    <name>berg::AlarmStrip</name>
    <message>
        <source>Acknowledge</source>
        <translation>Acquitter</translation>
    </message>
    <message>
        <source>Removes this notice. It returns if the condition ends and occurs again.</source>
        <translation>Retire cet avis. Il revient si la situation cesse et se reproduit.</translation>
    </message>
    <message>
        <source>Continue from here</source>
        <translation>Continuer d&apos;ici</translation>
    </message>
    <message>
        <source>Discards the flight after this instant. From here you can change the trade-off and the policy and fly another path.</source>
        <translation>Abandonne le vol après cet instant. À partir d&apos;ici, vous pouvez modifier le compromis et la stratégie et suivre une autre trajectoire.</translation>
    </message>
    <message>
        <source>Back to latest</source>
        <translation>Revenir au dernier instant</translation>
    </message>
    <message>
        <source>Goes to the latest instant of the flight.</source>
        <translation>Va au dernier instant du vol.</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Vérifications</translation>
    </message>
    <message>
        <source>Lists all findings in the scenario.</source>
        <translation>Énumère tous les constats sur le scénario.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Continues the flight where it was left.</source>
        <translation>Reprend le vol là où il a été laissé.</translation>
    </message>
    <message>
        <source>No alarms</source>
        <translation>Aucune alarme</translation>
    </message>
    <message>
        <source>Cannot be planned: %1</source>
        <translation>Planification impossible : %1</translation>
    </message>
    <message>
        <source>Looking back at %1</source>
        <translation>Retour en arrière à %1</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n de plus</numerusform>
            <numerusform>%n de plus</numerusform>
        </translation>
    </message>
    <message>
        <source>Click to show it on the map.</source>
        <translation>Cliquez pour l&apos;afficher sur la carte.</translation>
    </message>
    <message>
        <source>Acknowledged: %1</source>
        <translation>Acquitté : %1</translation>
    </message>
    <message>
        <source>Not in flight</source>
        <translation>Pas en vol</translation>
    </message>
</context>
<context>
    <name>berg::BackdropFile</name>
    <message>
        <source>%1 contains no points, lines or polygons</source>
        <translation>%1 ne contient ni points, ni lignes, ni polygones</translation>
    </message>
    <message>
        <source>The background map %1 cannot be read</source>
        <translation>Le fond de carte %1 ne peut pas être lu</translation>
    </message>
    <message>
        <source>%1 is neither GeoJSON nor KML. Convert it with a map program, such as QGIS, and choose it again.</source>
        <translation>%1 n&apos;est ni du GeoJSON ni du KML. Convertissez-le avec un logiciel de cartographie, par exemple QGIS, et choisissez-le de nouveau.</translation>
    </message>
    <message>
        <source>Maps (*.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;All files (*)</source>
        <translation>Cartes (*.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>berg::BenchmarkController</name>
    <message>
        <source>Solve time</source>
        <translation>Temps de résolution</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tableaux (*.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
</context>
<context>
    <name>berg::ChartPanel</name>
    <message>
        <source>Chart</source>
        <translation>Graphique</translation>
    </message>
    <message>
        <source>Quantity shown over time</source>
        <translation>Grandeur affichée dans le temps</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Choose the lines to show</source>
        <translation>Courbes affichées</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Suivre</translation>
    </message>
    <message>
        <source>Keep the newest minutes in view (End). The wheel zooms, the right button drags.</source>
        <translation>Garder en vue les dernières minutes (Fin). La molette zoome, le bouton droit fait glisser.</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tout</translation>
    </message>
    <message>
        <source>Show everything from take-off on (Home, or a double click)</source>
        <translation>Tout afficher depuis le décollage (Début, ou double-clic)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Save the chart as a picture (PNG, SVG, PDF) or its numbers as CSV</source>
        <translation>Enregistrer le graphique comme image (PNG, SVG, PDF) ou ses valeurs en CSV</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout afficher</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>Image PNG (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>Dessin SVG (*.svg)</translation>
    </message>
    <message>
        <source>PDF page (*.pdf)</source>
        <translation>Page PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Table of numbers (*.csv)</source>
        <translation>Tableau de valeurs (*.csv)</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copier l&apos;image</translation>
    </message>
    <message>
        <source>Copy numbers</source>
        <translation>Copier les valeurs</translation>
    </message>
    <message>
        <source>Save picture or numbers...</source>
        <translation>Enregistrer l&apos;image ou les valeurs…</translation>
    </message>
    <message>
        <source>Reset zoom</source>
        <translation>Réinitialiser le zoom</translation>
    </message>
    <message>
        <source>Values of the lines</source>
        <translation>Valeurs des courbes</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
</context>
<context>
    <name>berg::CheckPanel</name>
    <message>
        <source>Error: must be fixed before planning</source>
        <translation>Erreur : à corriger avant de planifier</translation>
    </message>
    <message>
        <source>Warning: probably not intended</source>
        <translation>Avertissement : probablement involontaire</translation>
    </message>
    <message>
        <source>Hint: good to know</source>
        <translation>Conseil : bon à savoir</translation>
    </message>
    <message>
        <source>No problems found</source>
        <translation>Aucun problème trouvé</translation>
    </message>
    <message>
        <source>Findings about the scenario</source>
        <translation>Constats sur le scénario</translation>
    </message>
</context>
<context>
    <name>berg::ComparisonChart</name>
    <message>
        <source>Comparison of accumulated uncertainty</source>
        <translation>Comparaison de l&apos;incertitude cumulée</translation>
    </message>
    <message>
        <source>This chart compares runs of one scenario.</source>
        <translation>Ce graphique compare des vols d&apos;un même scénario.</translation>
    </message>
    <message>
        <source>%1.
Less ζ is better. Plain shade: A, %2, has less. Hatched: B, %3, has less.</source>
        <translation>%1.
Moins de ζ est meilleur. Teinte unie : A, %2, en a moins. Hachures : B, %3, en a moins.</translation>
    </message>
    <message>
        <source>Time, h:mm:ss</source>
        <translation>Temps, h:mm:ss</translation>
    </message>
    <message>
        <source>Time, mm:ss</source>
        <translation>Temps, mm:ss</translation>
    </message>
    <message>
        <source>Time, UTC</source>
        <translation>Heure, UTC</translation>
    </message>
    <message>
        <source>Zeta ζ, %1</source>
        <translation>Zêta ζ, %1</translation>
    </message>
</context>
<context>
    <name>berg::ComparisonPanel</name>
    <message>
        <source>Figures of the comparison</source>
        <translation>Valeurs de la comparaison</translation>
    </message>
    <message>
        <source>Longest time unseen</source>
        <translation>Plus longue durée hors de vue</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Unseen</source>
        <translation>Non vu</translation>
    </message>
    <message>
        <source>Longest time for which each iceberg was out of view.</source>
        <translation>Plus longue durée pendant laquelle chaque iceberg était hors de vue.</translation>
    </message>
    <message>
        <source>Progress of the flight in the background</source>
        <translation>Progression du vol en arrière-plan</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>τ</source>
        <translation>τ</translation>
    </message>
    <message>
        <source>Trade-off τ to fly</source>
        <translation>Compromis τ pour le vol</translation>
    </message>
    <message>
        <source>0: most uncertain first; the larger, the shorter the route.</source>
        <translation>0 : le plus incertain d&apos;abord ; plus la valeur est grande, plus la route est courte.</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>Lancer le vol</translation>
    </message>
    <message>
        <source>Flies the same scenario with this τ in the background.</source>
        <translation>Joue le même scénario avec ce τ en arrière-plan.</translation>
    </message>
    <message>
        <source>Open run…</source>
        <translation>Ouvrir un vol…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Removes the chosen run from the list.</source>
        <translation>Retire le vol choisi de la liste.</translation>
    </message>
    <message>
        <source>Flying %1: %2 of %3</source>
        <translation>Vol %1 : %2 sur %3</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
    <message>
        <source>The reference A is the tour itself: choose another one as A.</source>
        <translation>La référence A est le circuit lui-même : choisissez-en une autre pour A.</translation>
    </message>
    <message>
        <source>Flies the same scenario along the shortest closed tour through all icebergs, as in Figure 5 of the paper, in the background.</source>
        <translation>Joue le même scénario en arrière-plan le long du plus court circuit fermé passant par tous les icebergs, comme à la figure 5 de l&apos;article.</translation>
    </message>
    <message>
        <source>Compare with the round tour</source>
        <translation>Comparer avec le circuit</translation>
    </message>
    <message>
        <source>Runs (*.bergrun);;All files (*)</source>
        <translation>Vols (*.bergrun);;Tous les fichiers (*)</translation>
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
        <translation>Attribuer à %1</translation>
    </message>
    <message>
        <source>Any UAV may visit it</source>
        <translation>N&apos;importe quel drone peut le visiter</translation>
    </message>
    <message>
        <source>Show in the inspector</source>
        <translation>Afficher dans les propriétés</translation>
    </message>
    <message>
        <source>Edit in the inspector</source>
        <translation>Modifier dans les propriétés</translation>
    </message>
    <message>
        <source>Remove asset</source>
        <translation>Retirer le bien protégé</translation>
    </message>
    <message>
        <source>Remove area</source>
        <translation>Retirer la zone</translation>
    </message>
    <message>
        <source>New iceberg here</source>
        <translation>Nouvel iceberg ici</translation>
    </message>
    <message>
        <source>New UAV here</source>
        <translation>Nouveau drone ici</translation>
    </message>
    <message>
        <source>Paste here</source>
        <translation>Coller ici</translation>
    </message>
    <message>
        <source>Ground station here</source>
        <translation>Station sol ici</translation>
    </message>
    <message>
        <source>Place ground station</source>
        <translation>Placer la station sol</translation>
    </message>
    <message>
        <source>Remove no-fly area</source>
        <translation>Retirer la zone interdite</translation>
    </message>
    <message>
        <source>Copy coordinates: %1</source>
        <translation>Copier les coordonnées : %1</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>Copié : %1</translation>
    </message>
    <message>
        <source>Centre the map here</source>
        <translation>Centrer la carte ici</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>Mesurer à partir d&apos;ici</translation>
    </message>
    <message>
        <source>Place asset</source>
        <translation>Placer le bien protégé</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Déplier</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Replier</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Masquer</translation>
    </message>
    <message>
        <source>Asset here</source>
        <translation>Bien protégé ici</translation>
    </message>
    <message>
        <source>Asset</source>
        <translation>Bien protégé</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>No-fly area</source>
        <translation>Zone interdite</translation>
    </message>
</context>
<context>
    <name>berg::Docks</name>
    <message>
        <source>Trade-off</source>
        <translation>Compromis</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Événements</translation>
    </message>
    <message>
        <source>Comparison chart</source>
        <translation>Graphique de comparaison</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Vérifications</translation>
    </message>
    <message>
        <source>Solve time</source>
        <translation>Temps de résolution</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparaison</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Icebergs</translation>
    </message>
    <message>
        <source>Map layers</source>
        <translation>Couches de la carte</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Trade-off τ, policy, solver and route</source>
        <translation>Compromis τ, stratégie, solveur et route</translation>
    </message>
    <message>
        <source>Pareto curve</source>
        <translation>Courbe de Pareto</translation>
    </message>
    <message>
        <source>First chart</source>
        <translation>Premier graphique</translation>
    </message>
    <message>
        <source>Second chart</source>
        <translation>Second graphique</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Aéronefs</translation>
    </message>
    <message>
        <source>Start times</source>
        <translation>Heures de départ</translation>
    </message>
</context>
<context>
    <name>berg::EventModel</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>How it was planned</source>
        <translation>Mode de planification</translation>
    </message>
    <message>
        <source>warm start</source>
        <translation>démarrage à chaud</translation>
    </message>
    <message>
        <source>previous plan kept</source>
        <translation>plan précédent conservé</translation>
    </message>
</context>
<context>
    <name>berg::EventPanel</name>
    <message>
        <source>Events of the mission</source>
        <translation>Événements de la mission</translation>
    </message>
</context>
<context>
    <name>berg::ExampleCard</name>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n iceberg</numerusform>
            <numerusform>%n icebergs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation>&amp;Parcourir…</translation>
    </message>
    <message>
        <source>Name the file.</source>
        <translation>Nommez le fichier.</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>Exporter vers</translation>
    </message>
    <message>
        <source>Format of the file</source>
        <translation>Format du fichier</translation>
    </message>
    <message>
        <source>Not possible</source>
        <translation>Impossible</translation>
    </message>
    <message>
        <source>%1, %2, to %3</source>
        <translation>%1, %2, jusqu&apos;à %3</translation>
    </message>
    <message>
        <source>The file exists. Bergwatch asks before it overwrites it.</source>
        <translation>Le fichier existe. Bergwatch demande avant de l&apos;écraser.</translation>
    </message>
    <message>
        <source>Working ...</source>
        <translation>Traitement en cours…</translation>
    </message>
    <message>
        <source>Nothing was changed or left out.</source>
        <translation>Rien n&apos;a été modifié ni omis.</translation>
    </message>
</context>
<context>
    <name>berg::ExportOptionsView</name>
    <message>
        <source>What was flown</source>
        <translation>Le vol effectué</translation>
    </message>
    <message>
        <source>The whole order</source>
        <translation>L&apos;ordre complet</translation>
    </message>
    <message>
        <source>The first leg</source>
        <translation>Le premier segment</translation>
    </message>
    <message>
        <source>The path with turns</source>
        <translation>La trajectoire avec virages</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>&amp;Contenu</translation>
    </message>
    <message>
        <source>All UAVs</source>
        <translation>Tous les drones</translation>
    </message>
    <message>
        <source>&amp;UAV</source>
        <translation>&amp;Drone</translation>
    </message>
    <message>
        <source>As in the scenario</source>
        <translation>Comme dans le scénario</translation>
    </message>
    <message>
        <source>&amp;Altitude</source>
        <translation>&amp;Altitude</translation>
    </message>
    <message>
        <source>Air&amp;speed</source>
        <translation>&amp;Vitesse air</translation>
    </message>
    <message>
        <source>A&amp;cceptance radius</source>
        <translation>&amp;Rayon d&apos;acceptation</translation>
    </message>
    <message>
        <source>None: fly over</source>
        <translation>Aucun : survoler</translation>
    </message>
    <message>
        <source>&amp;Loiter turns</source>
        <translation>&amp;Tours d&apos;attente</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Oui</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Non</translation>
    </message>
    <message>
        <source>&amp;Return home</source>
        <translation>Retour à la &amp;base</translation>
    </message>
</context>
<context>
    <name>berg::ExportPreviewView</name>
    <message>
        <source>Home</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Iceberg</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
    </message>
    <message>
        <source>Waypoints of the file</source>
        <translation>Points de cheminement du fichier</translation>
    </message>
    <message>
        <source>Map of what is exported</source>
        <translation>Carte de ce qui est exporté</translation>
    </message>
    <message>
        <source>How the file begins</source>
        <translation>Début du fichier</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Points de cheminement</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Preview of the page</source>
        <translation>Aperçu de la page</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Page</translation>
    </message>
</context>
<context>
    <name>berg::Fields</name>
    <message>
        <source>Id</source>
        <translation>Identifiant</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Shown on the map in place of the id.</source>
        <translation>Affiché sur la carte à la place de l&apos;identifiant.</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Est</translation>
    </message>
    <message>
        <source>Position at the start, east of the scenario&apos;s origin.</source>
        <translation>Position au début, à l&apos;est de l&apos;origine du scénario.</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>Position at the start, north of the scenario&apos;s origin.</source>
        <translation>Position au début, au nord de l&apos;origine du scénario.</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Cap</translation>
    </message>
    <message>
        <source>Clockwise from north, at the start.</source>
        <translation>Dans le sens horaire à partir du nord, au début.</translation>
    </message>
    <message>
        <source>Airspeed</source>
        <translation>Vitesse air</translation>
    </message>
    <message>
        <source>Must exceed the wind speed.</source>
        <translation>Doit dépasser la vitesse du vent.</translation>
    </message>
    <message>
        <source>Maximum bank angle</source>
        <translation>Inclinaison maximale</translation>
    </message>
    <message>
        <source>Bank in a turn; the larger, the tighter the turns.</source>
        <translation>Inclinaison latérale en virage ; plus elle est grande, plus les virages sont serrés.</translation>
    </message>
    <message>
        <source>View along-track</source>
        <translation>Champ longitudinal</translation>
    </message>
    <message>
        <source>Extent of the field of view along the heading.</source>
        <translation>Étendue du champ de vision dans le sens du cap.</translation>
    </message>
    <message>
        <source>View cross-track</source>
        <translation>Champ transversal</translation>
    </message>
    <message>
        <source>Extent of the field of view across the heading.</source>
        <translation>Étendue du champ de vision en travers du cap.</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Altitude</translation>
    </message>
    <message>
        <source>Height above sea level. UAVs at least %1 apart in height may pass each other.</source>
        <translation>Hauteur au-dessus de la mer. Les drones séparés d&apos;au moins %1 en hauteur peuvent se croiser.</translation>
    </message>
    <message>
        <source>unlimited</source>
        <translation>illimitée</translation>
    </message>
    <message>
        <source>Endurance</source>
        <translation>Autonomie</translation>
    </message>
    <message>
        <source>Longest flight; the UAV is home before it ends. At 0 it lands only when ordered to return.</source>
        <translation>Vol le plus long ; le drone est à la base avant sa fin. À 0, il ne se pose que sur ordre de retour.</translation>
    </message>
    <message>
        <source>Home east</source>
        <translation>Base est</translation>
    </message>
    <message>
        <source>Landing place, east of the scenario&apos;s origin.</source>
        <translation>Lieu d&apos;atterrissage, à l&apos;est de l&apos;origine du scénario.</translation>
    </message>
    <message>
        <source>Home north</source>
        <translation>Base nord</translation>
    </message>
    <message>
        <source>Landing place, north of the scenario&apos;s origin.</source>
        <translation>Lieu d&apos;atterrissage, au nord de l&apos;origine du scénario.</translation>
    </message>
    <message>
        <source>Turn-around</source>
        <translation>Temps au sol</translation>
    </message>
    <message>
        <source>Time on the ground between landing and the next take-off.</source>
        <translation>Temps au sol entre l&apos;atterrissage et le décollage suivant.</translation>
    </message>
    <message>
        <source>Reserve</source>
        <translation>Réserve</translation>
    </message>
    <message>
        <source>Share of the endurance that plans leave unused.</source>
        <translation>Part de l&apos;autonomie que les plans n&apos;utilisent pas.</translation>
    </message>
    <message>
        <source>by percentage</source>
        <translation>en pourcentage</translation>
    </message>
    <message>
        <source>Fixed reserve</source>
        <translation>Réserve fixe</translation>
    </message>
    <message>
        <source>Reserve as a time, in place of the percentage.</source>
        <translation>Réserve exprimée en temps, au lieu du pourcentage.</translation>
    </message>
    <message>
        <source>Climb</source>
        <translation>Montée</translation>
    </message>
    <message>
        <source>Time from take-off to the flight altitude.</source>
        <translation>Temps du décollage à l&apos;altitude de vol.</translation>
    </message>
    <message>
        <source>Landing</source>
        <translation>Atterrissage</translation>
    </message>
    <message>
        <source>Time from the flight altitude above home to the ground.</source>
        <translation>Temps de l&apos;altitude de vol, au-dessus de la base, jusqu&apos;au sol.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Wind limit</source>
        <translation>Limite de vent</translation>
    </message>
    <message>
        <source>Strongest wind in which the UAV may fly.</source>
        <translation>Vent le plus fort dans lequel le drone peut voler.</translation>
    </message>
    <message>
        <source>Gust limit</source>
        <translation>Limite de rafales</translation>
    </message>
    <message>
        <source>Strongest gusts in which the UAV may fly.</source>
        <translation>Rafales les plus fortes dans lesquelles le drone peut voler.</translation>
    </message>
    <message>
        <source>Icing conditions</source>
        <translation>Conditions givrantes</translation>
    </message>
    <message>
        <source>Whether the UAV may fly below 0 °C in nearly saturated air.</source>
        <translation>Indique si le drone peut voler sous 0 °C dans un air presque saturé.</translation>
    </message>
    <message>
        <source>each time step</source>
        <translation>à chaque pas de temps</translation>
    </message>
    <message>
        <source>Autopilot rate</source>
        <translation>Cadence de l&apos;autopilote</translation>
    </message>
    <message>
        <source>Time between two commands of the autopilot; at 0 it commands at each time step.</source>
        <translation>Temps entre deux commandes de l&apos;autopilote ; à 0, il commande à chaque pas de temps.</translation>
    </message>
    <message>
        <source>Drift east</source>
        <translation>Dérive est</translation>
    </message>
    <message>
        <source>Known drift to the east, without the current.</source>
        <translation>Dérive connue vers l&apos;est, sans le courant.</translation>
    </message>
    <message>
        <source>Drift north</source>
        <translation>Dérive nord</translation>
    </message>
    <message>
        <source>Known drift to the north, without the current.</source>
        <translation>Dérive connue vers le nord, sans le courant.</translation>
    </message>
    <message>
        <source>Drift error</source>
        <translation>Erreur de dérive</translation>
    </message>
    <message>
        <source>Standard deviation of the error of the known drift, along each axis.</source>
        <translation>Écart-type de l&apos;erreur de la dérive connue, selon chaque axe.</translation>
    </message>
    <message>
        <source>Drift variation</source>
        <translation>Variabilité de la dérive</translation>
    </message>
    <message>
        <source>Long-term standard deviation of the drift about the current, along each axis. Example, a beacon off Canada: 0.15 m/s.</source>
        <translation>Écart-type à long terme de la dérive autour du courant, selon chaque axe. Exemple, une balise au large du Canada : 0,15 m/s.</translation>
    </message>
    <message>
        <source>Drift time constant</source>
        <translation>Constante de temps</translation>
    </message>
    <message>
        <source>Time in which a known drift fades to that of the current. At 0 the drift is constant. Example, a beacon off Canada: 36,000 s.</source>
        <translation>Temps au bout duquel une dérive connue tend vers celle du courant. À 0, la dérive est constante. Exemple, une balise au large du Canada : 36 000 s.</translation>
    </message>
    <message>
        <source>Growth q</source>
        <translation>Croissance q</translation>
    </message>
    <message>
        <source>Growth of the uncertainty per second out of view.</source>
        <translation>Croissance de l&apos;incertitude par seconde hors de vue.</translation>
    </message>
    <message>
        <source>Uncertainty σ₀</source>
        <translation>Incertitude σ₀</translation>
    </message>
    <message>
        <source>Variance of the position when it was last seen.</source>
        <translation>Variance de la position lors de la dernière observation.</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Dernière observation</translation>
    </message>
    <message>
        <source>Time between the last sighting and the start; σ has grown since.</source>
        <translation>Temps entre la dernière observation et le début ; σ a augmenté depuis.</translation>
    </message>
    <message>
        <source>Appears at</source>
        <translation>Apparaît à</translation>
    </message>
    <message>
        <source>Run time from which the iceberg is known; 0 is the start.</source>
        <translation>Instant du vol à partir duquel l&apos;iceberg est connu ; 0 est le début.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Half its length. It sets the size on the map and how far outside the area the iceberg is monitored.</source>
        <translation>La moitié de sa longueur. Elle fixe la taille sur la carte et la distance hors de la zone jusqu&apos;à laquelle l&apos;iceberg est surveillé.</translation>
    </message>
    <message>
        <source>Visited by</source>
        <translation>Visité par</translation>
    </message>
    <message>
        <source>The only UAV that may visit it.</source>
        <translation>Le seul drone qui peut le visiter.</translation>
    </message>
    <message>
        <source>Speed east</source>
        <translation>Vitesse est</translation>
    </message>
    <message>
        <source>Speed of a ship to the east; 0 for a platform.</source>
        <translation>Vitesse d&apos;un navire vers l&apos;est ; 0 pour une plateforme.</translation>
    </message>
    <message>
        <source>Speed north</source>
        <translation>Vitesse nord</translation>
    </message>
    <message>
        <source>Speed of a ship to the north; 0 for a platform.</source>
        <translation>Vitesse d&apos;un navire vers le nord ; 0 pour une plateforme.</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Rayon d&apos;influence</translation>
    </message>
    <message>
        <source>Distance within which icebergs matter to the asset.</source>
        <translation>Distance en deçà de laquelle les icebergs comptent pour le bien protégé.</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Pondération</translation>
    </message>
    <message>
        <source>Additional weight of an iceberg at the asset.</source>
        <translation>Poids supplémentaire d&apos;un iceberg près du bien protégé.</translation>
    </message>
    <message>
        <source>half the range</source>
        <translation>moitié du rayon d&apos;influence</translation>
    </message>
    <message>
        <source>Inner ring</source>
        <translation>Anneau intérieur</translation>
    </message>
    <message>
        <source>An iceberg predicted to enter it within an hour raises an alarm. At 0 it is half the range.</source>
        <translation>Un iceberg dont l&apos;entrée est prévue dans l&apos;heure déclenche une alarme. À 0, c&apos;est la moitié du rayon d&apos;influence.</translation>
    </message>
    <message>
        <source>Stand-off ring</source>
        <translation>Anneau de sécurité</translation>
    </message>
    <message>
        <source>Least distance of UAVs from the asset; for a ship, from its whole track.</source>
        <translation>Distance minimale des drones au bien protégé ; pour un navire, à toute sa route.</translation>
    </message>
    <message>
        <source>Stand-off ceiling</source>
        <translation>Plafond de sécurité</translation>
    </message>
    <message>
        <source>Height above which UAVs may cross the ring.</source>
        <translation>Hauteur au-dessus de laquelle les drones peuvent survoler l&apos;anneau.</translation>
    </message>
    <message>
        <source>Shown on the map.</source>
        <translation>Affiché sur la carte.</translation>
    </message>
    <message>
        <source>Corner of the no-fly area</source>
        <translation>Sommet de la zone interdite</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Plancher</translation>
    </message>
    <message>
        <source>UAVs below this height may pass under the area.</source>
        <translation>Les drones sous cette hauteur peuvent passer sous la zone.</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>Plafond</translation>
    </message>
    <message>
        <source>UAVs above this height may pass over the area.</source>
        <translation>Les drones au-dessus de cette hauteur peuvent survoler la zone.</translation>
    </message>
    <message>
        <source>Corner of the airspace</source>
        <translation>Sommet de l&apos;espace aérien</translation>
    </message>
    <message>
        <source>Start of the airspace</source>
        <translation>Début de l&apos;espace aérien</translation>
    </message>
    <message>
        <source>End of the airspace</source>
        <translation>Fin de l&apos;espace aérien</translation>
    </message>
    <message>
        <source>Station east</source>
        <translation>Station est</translation>
    </message>
    <message>
        <source>East of the scenario&apos;s origin.</source>
        <translation>À l&apos;est de l&apos;origine du scénario.</translation>
    </message>
    <message>
        <source>Station north</source>
        <translation>Station nord</translation>
    </message>
    <message>
        <source>North of the scenario&apos;s origin.</source>
        <translation>Au nord de l&apos;origine du scénario.</translation>
    </message>
    <message>
        <source>Antenna height</source>
        <translation>Hauteur d&apos;antenne</translation>
    </message>
    <message>
        <source>Height above the sea.</source>
        <translation>Hauteur au-dessus de la mer.</translation>
    </message>
    <message>
        <source>radio horizon</source>
        <translation>horizon radio</translation>
    </message>
    <message>
        <source>Link range</source>
        <translation>Portée de la liaison</translation>
    </message>
    <message>
        <source>Range of the link; the lowest value means the radio horizon of the antenna and the UAV&apos;s altitude.</source>
        <translation>Portée de la liaison ; la valeur la plus basse correspond à l&apos;horizon radio de l&apos;antenne et de l&apos;altitude du drone.</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Distance around all places of the plan, for turns and replanning. Not used with a geofence.</source>
        <translation>Distance autour de tous les lieux du plan, pour les virages et les nouveaux plans. Non utilisée avec une barrière virtuelle.</translation>
    </message>
    <message>
        <source>UAV size</source>
        <translation>Taille du drone</translation>
    </message>
    <message>
        <source>Largest dimension of a UAV; half of it is added to the ground-risk buffer.</source>
        <translation>Plus grande dimension d&apos;un drone ; sa moitié s&apos;ajoute à la zone tampon de risque au sol.</translation>
    </message>
    <message>
        <source>Satellite position error</source>
        <translation>Erreur de position par satellite</translation>
    </message>
    <message>
        <source>Part of the width of the contingency volume. Source: Digisky 3.3.0, after the guide of the Swiss FOCA: 3 m.</source>
        <translation>Partie de la largeur du volume de contingence. Source : Digisky 3.3.0, d&apos;après le guide de l&apos;OFAC suisse : 3 m.</translation>
    </message>
    <message>
        <source>Path-keeping error</source>
        <translation>Erreur de suivi de trajectoire</translation>
    </message>
    <message>
        <source>Error of the autopilot, part of the width of the contingency volume. Same source: 3 m.</source>
        <translation>Erreur de l&apos;autopilote, partie de la largeur du volume de contingence. Même source : 3 m.</translation>
    </message>
    <message>
        <source>Map error</source>
        <translation>Erreur de la carte</translation>
    </message>
    <message>
        <source>Part of the width of the contingency volume. Same source: 1 m.</source>
        <translation>Partie de la largeur du volume de contingence. Même source : 1 m.</translation>
    </message>
    <message>
        <source>Reaction time</source>
        <translation>Temps de réaction</translation>
    </message>
    <message>
        <source>Time at full speed before the crew reacts. Same source: 1 s.</source>
        <translation>Temps à pleine vitesse avant que l&apos;équipage ne réagisse. Même source : 1 s.</translation>
    </message>
    <message>
        <source>Bank of the turn back</source>
        <translation>Inclinaison du demi-tour</translation>
    </message>
    <message>
        <source>Sets the turn radius v²/(g tan bank). Same source: 30°.</source>
        <translation>Fixe le rayon de virage v²/(g tan inclinaison). Même source : 30°.</translation>
    </message>
    <message>
        <source>Height error</source>
        <translation>Erreur de hauteur</translation>
    </message>
    <message>
        <source>Part of the height of the contingency volume. Same source: 4 m.</source>
        <translation>Partie de la hauteur du volume de contingence. Même source : 4 m.</translation>
    </message>
    <message>
        <source>Climb part</source>
        <translation>Part de montée</translation>
    </message>
    <message>
        <source>Share of the speed that is climb during the reaction time. Same source: 0.707, a climb of 45°.</source>
        <translation>Part de la vitesse qui est montée pendant le temps de réaction. Même source : 0,707, une montée à 45°.</translation>
    </message>
    <message>
        <source>Pull-up part</source>
        <translation>Part de mise en palier</translation>
    </message>
    <message>
        <source>Height needed to level out, as a share of v²/g. Same source: 0.3.</source>
        <translation>Hauteur nécessaire à la mise en palier, en part de v²/g. Même source : 0,3.</translation>
    </message>
    <message>
        <source>Buffer ratio</source>
        <translation>Rapport de la zone tampon</translation>
    </message>
    <message>
        <source>Width of the ground-risk buffer divided by the height of the contingency volume. Same source: 1, the 1:1 rule.</source>
        <translation>Largeur de la zone tampon de risque au sol divisée par la hauteur du volume de contingence. Même source : 1, la règle 1:1.</translation>
    </message>
    <message>
        <source>Adjacent area, time</source>
        <translation>Zone adjacente, temps</translation>
    </message>
    <message>
        <source>Flight time at full speed. Same source: 180 s.</source>
        <translation>Temps de vol à pleine vitesse. Même source : 180 s.</translation>
    </message>
    <message>
        <source>Adjacent area, minimum</source>
        <translation>Zone adjacente, minimum</translation>
    </message>
    <message>
        <source>Minimum width. Same source: 5 km.</source>
        <translation>Largeur minimale. Même source : 5 km.</translation>
    </message>
    <message>
        <source>Adjacent area, maximum</source>
        <translation>Zone adjacente, maximum</translation>
    </message>
    <message>
        <source>Maximum width. Same source: 35 km.</source>
        <translation>Largeur maximale. Même source : 35 km.</translation>
    </message>
    <message>
        <source>Crew</source>
        <translation>Équipage</translation>
    </message>
    <message>
        <source>Names printed in the flight brief. If empty, the brief has a blank line.</source>
        <translation>Noms imprimés sur la fiche de vol. Si le champ est vide, la fiche a une ligne à remplir.</translation>
    </message>
    <message>
        <source>Call sign</source>
        <translation>Indicatif d&apos;appel</translation>
    </message>
    <message>
        <source>Printed in the flight brief. If empty, the brief has a blank line.</source>
        <translation>Imprimé sur la fiche de vol. Si le champ est vide, la fiche a une ligne à remplir.</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Ship, air traffic service, rescue: names, numbers, frequencies.</source>
        <translation>Navire, services de la circulation aérienne, secours : noms, numéros, fréquences.</translation>
    </message>
    <message>
        <source>Command link</source>
        <translation>Liaison de commande</translation>
    </message>
    <message>
        <source>How the UAVs are commanded, and what they do if the link is lost.</source>
        <translation>Comment les drones sont commandés, et ce qu&apos;ils font si la liaison est perdue.</translation>
    </message>
    <message>
        <source>Checklist</source>
        <translation>Liste de vérification</translation>
    </message>
    <message>
        <source>One item per line, printed with a box to tick.</source>
        <translation>Un point par ligne, imprimé avec une case à cocher.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>valeur inconnue</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Rafales</translation>
    </message>
    <message>
        <source>Speed of the gusts, compared with the limits of the UAVs.</source>
        <translation>Vitesse des rafales, comparée aux limites des drones.</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Température</translation>
    </message>
    <message>
        <source>Air temperature at sea level.</source>
        <translation>Température de l&apos;air au niveau de la mer.</translation>
    </message>
    <message>
        <source>Dew point</source>
        <translation>Point de rosée</translation>
    </message>
    <message>
        <source>Dew point at sea level. With the temperature it shows whether ice may form.</source>
        <translation>Point de rosée au niveau de la mer. Avec la température, il indique si du givre peut se former.</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Latitude</translation>
    </message>
    <message>
        <source>Coordinate of the origin, in any format; a full coordinate or a place name sets both. Everything moves with it.</source>
        <translation>Coordonnée de l&apos;origine, sous toute forme ; une coordonnée complète ou un nom de lieu règle les deux. Tout se déplace avec elle.</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Longitude</translation>
    </message>
    <message>
        <source>Observer</source>
        <translation>Observateur</translation>
    </message>
    <message>
        <source>Exact: a sighting gives the true position. Filter: position and velocity are estimated from noisy measurements, and icebergs can get lost.</source>
        <translation>Exact : une observation donne la position réelle. Filtre : la position et la vitesse sont estimées à partir de mesures bruitées, et des icebergs peuvent être perdus.</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Erreur de position</translation>
    </message>
    <message>
        <source>Standard deviation of a measured position, along each axis.</source>
        <translation>Écart-type d&apos;une position mesurée, selon chaque axe.</translation>
    </message>
    <message>
        <source>Sensor interval</source>
        <translation>Intervalle du capteur</translation>
    </message>
    <message>
        <source>Time between two samples of the sensor, each of which measures what is in view.</source>
        <translation>Temps entre deux prises du capteur ; chacune mesure ce qui est en vue.</translation>
    </message>
    <message>
        <source>Detection probability</source>
        <translation>Probabilité de détection</translation>
    </message>
    <message>
        <source>Probability that one sample shows an iceberg in view.</source>
        <translation>Probabilité qu&apos;une prise montre un iceberg en vue.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>Search pattern for an iceberg that is not at its estimated position.</source>
        <translation>Parcours de recherche d&apos;un iceberg qui n&apos;est pas à sa position estimée.</translation>
    </message>
    <message>
        <source>Trade-off τ</source>
        <translation>Compromis τ</translation>
    </message>
    <message>
        <source>Formulation</source>
        <translation>Formulation</translation>
    </message>
    <message>
        <source>Integer program that COIN-OR CBC solves when it is the solver.</source>
        <translation>Programme en nombres entiers que résout COIN-OR CBC lorsqu&apos;il est le solveur.</translation>
    </message>
    <message>
        <source>Planning time</source>
        <translation>Temps de planification</translation>
    </message>
    <message>
        <source>Time to make a plan in flight; until it is ready the UAV continues with the previous plan.</source>
        <translation>Temps nécessaire pour établir un plan en vol ; d&apos;ici là, le drone poursuit le précédent.</translation>
    </message>
    <message>
        <source>in view</source>
        <translation>en vue</translation>
    </message>
    <message>
        <source>Acceptance radius</source>
        <translation>Rayon d&apos;acceptation</translation>
    </message>
    <message>
        <source>Distance at which an iceberg counts as reached; at 0 it is reached when it is in view.</source>
        <translation>Distance à laquelle un iceberg compte comme atteint ; à 0, il est atteint lorsqu&apos;il est en vue.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Champ de vision</translation>
    </message>
    <message>
        <source>Shape of the area that the camera covers.</source>
        <translation>Forme de la zone que couvre la caméra.</translation>
    </message>
    <message>
        <source>Group nearby icebergs</source>
        <translation>Grouper les icebergs proches</translation>
    </message>
    <message>
        <source>Icebergs that fit into one field of view are planned as one point, from which all are seen.</source>
        <translation>Les icebergs qui tiennent dans un même champ de vision sont planifiés comme un seul point, d&apos;où tous sont vus.</translation>
    </message>
    <message>
        <source>Title of the scenario, shown on the map.</source>
        <translation>Titre du scénario, affiché sur la carte.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Any text, stored in the file.</source>
        <translation>Texte libre, conservé dans le fichier.</translation>
    </message>
    <message>
        <source>Start (UTC)</source>
        <translation>Début (UTC)</translation>
    </message>
    <message>
        <source>Date and time of the start, such as 2026-11-29 12:00 or 29 Nov 2026 12:00; 1200Z keeps the date. Empty: times are relative.</source>
        <translation>Date et heure du départ, par exemple 2026-11-29 12:00 ou 29 Nov 2026 12:00 ; 1200Z garde la date. Vide : les temps sont relatifs.</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Length of the run, at most seven days.</source>
        <translation>Durée du vol, sept jours au plus.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Seed of the random drift: the same seed repeats the run.</source>
        <translation>Graine de la dérive aléatoire : la même graine reproduit le vol.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Pas de temps</translation>
    </message>
    <message>
        <source>Step of the simulation; a smaller step is more exact and slower.</source>
        <translation>Pas de la simulation ; un pas plus petit est plus exact et plus lent.</translation>
    </message>
    <message>
        <source>Random drift</source>
        <translation>Dérive aléatoire</translation>
    </message>
    <message>
        <source>Off: icebergs drift exactly as known.</source>
        <translation>Désactivée : les icebergs dérivent exactement comme connu.</translation>
    </message>
    <message>
        <source>Wind east</source>
        <translation>Vent est</translation>
    </message>
    <message>
        <source>Towards the east; must be below the UAV&apos;s airspeed.</source>
        <translation>Vers l&apos;est ; doit être inférieur à la vitesse air du drone.</translation>
    </message>
    <message>
        <source>Wind north</source>
        <translation>Vent nord</translation>
    </message>
    <message>
        <source>Towards the north; must be below the UAV&apos;s airspeed.</source>
        <translation>Vers le nord ; doit être inférieur à la vitesse air du drone.</translation>
    </message>
    <message>
        <source>Current east</source>
        <translation>Courant est</translation>
    </message>
    <message>
        <source>Carries every iceberg towards the east.</source>
        <translation>Entraîne tous les icebergs vers l&apos;est.</translation>
    </message>
    <message>
        <source>Current north</source>
        <translation>Courant nord</translation>
    </message>
    <message>
        <source>Carries every iceberg towards the north.</source>
        <translation>Entraîne tous les icebergs vers le nord.</translation>
    </message>
    <message>
        <source>Corner of the area</source>
        <translation>Sommet de la zone</translation>
    </message>
    <message>
        <source>Geofence</source>
        <translation>Barrière virtuelle</translation>
    </message>
    <message>
        <source>UAVs stay inside the area if they start clear of its edge.</source>
        <translation>Les drones qui partent à l&apos;écart du bord restent dans la zone.</translation>
    </message>
    <message>
        <source>no separation</source>
        <translation>aucun espacement</translation>
    </message>
    <message>
        <source>Separation</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>Least distance between UAVs whose altitudes differ by less than %1.</source>
        <translation>Distance minimale entre drones dont les altitudes diffèrent de moins de %1.</translation>
    </message>
    <message>
        <source>Autopilot</source>
        <translation>Autopilote</translation>
    </message>
    <message>
        <source>Firmware for which missions are exported.</source>
        <translation>Micrologiciel pour lequel les missions sont exportées.</translation>
    </message>
    <message>
        <source>Airframe</source>
        <translation>Cellule</translation>
    </message>
    <message>
        <source>A VTOL and a multirotor fly over icebergs without loiter circles.</source>
        <translation>Un ADAV et un multirotor survolent les icebergs sans tours d&apos;attente.</translation>
    </message>
    <message>
        <source>Take-off</source>
        <translation>Décollage</translation>
    </message>
    <message>
        <source>By mission item, or by hand: then the mission is started in the air.</source>
        <translation>Par un élément de la mission, ou à la main : dans ce cas, la mission est démarrée en vol.</translation>
    </message>
    <message>
        <source>Take-off altitude</source>
        <translation>Altitude de décollage</translation>
    </message>
    <message>
        <source>Height above home at which the first leg begins.</source>
        <translation>Hauteur au-dessus de la base où commence le premier segment.</translation>
    </message>
    <message>
        <source>Take-off pitch</source>
        <translation>Assiette au décollage</translation>
    </message>
    <message>
        <source>Least pitch of a fixed wing in the take-off.</source>
        <translation>Assiette minimale d&apos;une voilure fixe au décollage.</translation>
    </message>
    <message>
        <source>End of the mission</source>
        <translation>Fin de la mission</translation>
    </message>
    <message>
        <source>What the last items of an exported mission do, unless it ends over the last iceberg.</source>
        <translation>Ce que font les derniers éléments d&apos;une mission exportée, sauf si elle finit au-dessus du dernier iceberg.</translation>
    </message>
    <message>
        <source>Approach leg</source>
        <translation>Segment d&apos;approche</translation>
    </message>
    <message>
        <source>Distance from the loiter in which the UAV descends to the landing place.</source>
        <translation>Distance entre l&apos;attente où le drone descend et le lieu d&apos;atterrissage.</translation>
    </message>
    <message>
        <source>Approach altitude</source>
        <translation>Altitude d&apos;approche</translation>
    </message>
    <message>
        <source>Height above home to which the UAV descends before the approach.</source>
        <translation>Hauteur au-dessus de la base à laquelle le drone descend avant l&apos;approche.</translation>
    </message>
    <message>
        <source>into the wind</source>
        <translation>face au vent</translation>
    </message>
    <message>
        <source>Approach course</source>
        <translation>Route d&apos;approche</translation>
    </message>
    <message>
        <source>Course of the approach, clockwise from north; 360 is north.</source>
        <translation>Route de l&apos;approche, dans le sens horaire depuis le nord ; 360 est le nord.</translation>
    </message>
    <message>
        <source>tightest turn</source>
        <translation>virage le plus serré</translation>
    </message>
    <message>
        <source>Loiter radius</source>
        <translation>Rayon d&apos;attente</translation>
    </message>
    <message>
        <source>Radius of loiters in missions; never less than the tightest turn in the wind.</source>
        <translation>Rayon des attentes dans les missions ; jamais inférieur au virage le plus serré dans le vent.</translation>
    </message>
    <message>
        <source>Hover speed</source>
        <translation>Vitesse en stationnaire</translation>
    </message>
    <message>
        <source>Speed of a VTOL while it flies like a multirotor.</source>
        <translation>Vitesse d&apos;un ADAV tant qu&apos;il vole comme un multirotor.</translation>
    </message>
    <message>
        <source>Speed in the mission</source>
        <translation>Vitesse dans la mission</translation>
    </message>
    <message>
        <source>Off: the autopilot flies at the speed of its own parameters.</source>
        <translation>Désactivé : l&apos;autopilote vole à la vitesse de ses propres paramètres.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>What triggers the camera over an iceberg; it is off between icebergs.</source>
        <translation>Ce qui déclenche la caméra au-dessus d&apos;un iceberg ; elle est arrêtée entre les icebergs.</translation>
    </message>
    <message>
        <source>Trigger distance</source>
        <translation>Distance de déclenchement</translation>
    </message>
    <message>
        <source>Distance flown between two pictures.</source>
        <translation>Distance parcourue entre deux photos.</translation>
    </message>
    <message>
        <source>Trigger interval</source>
        <translation>Intervalle de déclenchement</translation>
    </message>
    <message>
        <source>Time between two pictures.</source>
        <translation>Temps entre deux photos.</translation>
    </message>
    <message>
        <source>Gimbal down</source>
        <translation>Nacelle vers le bas</translation>
    </message>
    <message>
        <source>An item of the mission points the gimbal straight down.</source>
        <translation>Un élément de la mission oriente la nacelle à la verticale vers le bas.</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Brouillard</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Visibilité</translation>
    </message>
    <message>
        <source>Cloud base</source>
        <translation>Base des nuages</translation>
    </message>
    <message>
        <source>Depth of the sea</source>
        <translation>Profondeur de la mer</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Length at the waterline. With it, wind and current carry the iceberg, and it may run aground; without it, the current alone.</source>
        <translation>Longueur à la flottaison. Avec elle, le vent et le courant portent l&apos;iceberg, qui peut s&apos;échouer ; sans elle, le courant seul.</translation>
    </message>
    <message>
        <source>Source of the ice chart</source>
        <translation>Source de la carte des glaces</translation>
    </message>
    <message>
        <source>Date of the ice chart</source>
        <translation>Date de la carte des glaces</translation>
    </message>
    <message>
        <source>Label of the ice</source>
        <translation>Étiquette de la glace</translation>
    </message>
    <message>
        <source>Ice concentration</source>
        <translation>Concentration de glace</translation>
    </message>
    <message>
        <source>Fast ice</source>
        <translation>Banquise côtière</translation>
    </message>
    <message>
        <source>Visibility limit</source>
        <translation>Limite de visibilité</translation>
    </message>
    <message>
        <source>Shortest visibility in which the UAV may fly; compared with the forecast.</source>
        <translation>Plus faible visibilité dans laquelle le drone peut voler, comparée à la prévision.</translation>
    </message>
    <message>
        <source>Ceiling limit</source>
        <translation>Limite de plafond</translation>
    </message>
    <message>
        <source>Lowest cloud base, above sea level, in which the UAV may fly; compared with the forecast.</source>
        <translation>Plafond le plus bas, au-dessus de la mer, dans lequel le drone peut voler, comparé à la prévision.</translation>
    </message>
    <message>
        <source>Unique in the file; without it, uav-1, uav-2, ... or berg-1, berg-2, ... in the order of the file.</source>
        <translation>Unique dans le fichier ; sans lui, uav-1, uav-2, ... ou berg-1, berg-2, ... dans l&apos;ordre du fichier.</translation>
    </message>
    <message>
        <source>Position at the start; of an iceberg the estimate, which is the truth in the simple model.</source>
        <translation>Position au départ ; pour un iceberg, l&apos;estimation, qui est la vérité dans le modèle simple.</translation>
    </message>
    <message>
        <source>Extent of the field of view along and across the heading.</source>
        <translation>Étendue du champ de vision le long du cap et en travers.</translation>
    </message>
    <message>
        <source>Landing place; without it, where the UAV starts.</source>
        <translation>Lieu d&apos;atterrissage ; à défaut, le point de départ du drone.</translation>
    </message>
    <message>
        <source>Time between two commands of the autopilot; 0 means every time step. After an order to return home, a slower autopilot commands once a second.</source>
        <translation>Temps entre deux commandes de l&apos;autopilote ; 0 signifie à chaque pas de temps. Après un ordre de retour, un autopilote plus lent commande une fois par seconde.</translation>
    </message>
    <message>
        <source>Drift velocity, without the current.</source>
        <translation>Vitesse de dérive, sans le courant.</translation>
    </message>
    <message>
        <source>Standard deviation of the error of the drift velocity, along each axis (Kalman observer).</source>
        <translation>Écart type de l&apos;erreur de la vitesse de dérive, le long de chaque axe (observateur de Kalman).</translation>
    </message>
    <message>
        <source>Changing drift (Kalman observer): standard deviation with which the velocity varies about the current. A fit to a beacon gave 0.15 m/s.</source>
        <translation>Dérive changeante (observateur de Kalman) : écart type avec lequel la vitesse varie autour du courant. L&apos;ajustement à une balise a donné 0.15 m/s.</translation>
    </message>
    <message>
        <source>Changing drift (Kalman observer): time in which the velocity fades to the current (to 1/e); 0 means constant drift. A fit to a beacon gave 36000 s.</source>
        <translation>Dérive changeante (observateur de Kalman) : temps dans lequel la vitesse tend vers le courant (à 1/e) ; 0 signifie une dérive constante. L&apos;ajustement à une balise a donné 36000 s.</translation>
    </message>
    <message>
        <source>Age of the last sighting at t = 0: adds q x age and (`velocity_sd_mps` x age)^2 to `sigma0_m2`; with changing drift the formula is that of the drift process.</source>
        <translation>Âge de la dernière observation à t = 0 : ajoute q x âge et (`velocity_sd_mps` x âge)^2 à `sigma0_m2` ; si la dérive change, la formule est celle du processus de dérive.</translation>
    </message>
    <message>
        <source>Id of the only UAV that may visit it; empty allows any UAV.</source>
        <translation>Id du seul drone qui peut le visiter ; vide autorise tout drone.</translation>
    </message>
    <message>
        <source>Speed of a ship; 0 for a platform.</source>
        <translation>Vitesse d&apos;un navire ; 0 pour une plate-forme.</translation>
    </message>
    <message>
        <source>UAVs that start clear of the asset keep this distance, from a ship to its whole track.</source>
        <translation>Les drones qui partent à l&apos;écart du bien gardent cette distance, pour un navire à toute sa trace.</translation>
    </message>
    <message>
        <source>Corners of the area.</source>
        <translation>Sommets de la zone.</translation>
    </message>
    <message>
        <source>Name of the airspace.</source>
        <translation>Nom de l&apos;espace aérien.</translation>
    </message>
    <message>
        <source>Class or type of the airspace.</source>
        <translation>Classe ou type de l&apos;espace aérien.</translation>
    </message>
    <message>
        <source>Lower limit, above the sea.</source>
        <translation>Limite inférieure, au-dessus de la mer.</translation>
    </message>
    <message>
        <source>Upper limit, above the sea.</source>
        <translation>Limite supérieure, au-dessus de la mer.</translation>
    </message>
    <message>
        <source>Time from which the airspace exists; without it, always.</source>
        <translation>Instant à partir duquel l&apos;espace existe ; à défaut, toujours.</translation>
    </message>
    <message>
        <source>Time until which the airspace exists, not before `from_utc`; without it, always.</source>
        <translation>Instant jusqu&apos;auquel l&apos;espace existe, pas avant `from_utc` ; à défaut, toujours.</translation>
    </message>
    <message>
        <source>Position of the antenna.</source>
        <translation>Position de l&apos;antenne.</translation>
    </message>
    <message>
        <source>Latitude of the local plane&apos;s origin.</source>
        <translation>Latitude de l&apos;origine du plan local.</translation>
    </message>
    <message>
        <source>Longitude of the local plane&apos;s origin.</source>
        <translation>Longitude de l&apos;origine du plan local.</translation>
    </message>
    <message>
        <source>With `simple`, the estimate of an iceberg in view is the truth; with `kalman`, a filter uses noisy measurements.</source>
        <translation>Avec `simple`, l&apos;estimation d&apos;un iceberg en vue est la vérité ; avec `kalman`, un filtre utilise des mesures bruitées.</translation>
    </message>
    <message>
        <source>Policy that chooses the orders.</source>
        <translation>Règle qui choisit les ordres de visite.</translation>
    </message>
    <message>
        <source>0 visits the most uncertain iceberg first; a large value gives the shortest path.</source>
        <translation>0 visite d&apos;abord l&apos;iceberg le plus incertain ; une grande valeur donne le chemin le plus court.</translation>
    </message>
    <message>
        <source>Whether the path ends over the last iceberg or returns to its start.</source>
        <translation>Si le chemin finit au-dessus du dernier iceberg ou revient au départ.</translation>
    </message>
    <message>
        <source>Solver of the orders.</source>
        <translation>Solveur des ordres de visite.</translation>
    </message>
    <message>
        <source>An iceberg is reached within this distance. Without it, an iceberg is reached when it is in view; with measurements, when its estimate is in view after a sighting.</source>
        <translation>Un iceberg est atteint à moins de cette distance. Sans elle, un iceberg est atteint quand il est en vue ; avec des mesures, quand son estimation est en vue après une observation.</translation>
    </message>
    <message>
        <source>Shape of the field of view. The diameter of a disk is `fov_m[0]`; the second number has no effect.</source>
        <translation>Forme du champ de vision. Le diamètre d&apos;un disque est `fov_m[0]` ; le second nombre est sans effet.</translation>
    </message>
    <message>
        <source>Start time, ISO 8601 with Z; without it, times are relative.</source>
        <translation>Heure de départ, ISO 8601 avec Z ; sans elle, les temps sont relatifs.</translation>
    </message>
    <message>
        <source>If false, nothing is random: icebergs drift at their given velocities, and measurements detect every iceberg in view.</source>
        <translation>Si false, rien n&apos;est aléatoire : les icebergs dérivent à leurs vitesses données, et les mesures détectent chaque iceberg en vue.</translation>
    </message>
    <message>
        <source>Velocity over ground; the wind must be slower than the airspeed.</source>
        <translation>Vitesse par rapport au sol ; le vent doit être plus lent que la vitesse air.</translation>
    </message>
    <message>
        <source>Velocity over ground; the current carries every iceberg.</source>
        <translation>Vitesse par rapport au sol ; le courant emporte chaque iceberg.</translation>
    </message>
    <message>
        <source>Corners of the monitored area; an iceberg that is farther outside than its radius is no longer monitored.</source>
        <translation>Sommets de la zone surveillée ; un iceberg situé au-delà à plus de son rayon n&apos;est plus surveillé.</translation>
    </message>
    <message>
        <source>UAVs that start clear of the edge of `area_m` stay inside it; `validate` warns if a start leaves no safe turn or path home, but the flight is allowed.</source>
        <translation>Les drones qui partent à l&apos;écart du bord de `area_m` restent à l&apos;intérieur ; `validate` avertit si un départ ne laisse ni virage ni retour sûrs, mais le vol est permis.</translation>
    </message>
    <message>
        <source>Least distance between UAVs whose altitudes differ by less than %1, after they have reached it (`validate` gives a hint if they start nearer); 0 turns separation off.</source>
        <translation>Distance minimale entre les drones dont les altitudes diffèrent de moins de %1, une fois atteinte (`validate` donne un conseil s&apos;ils partent plus près) ; 0 la désactive.</translation>
    </message>
    <message>
        <source>Areas that UAVs stay out of if they start clear of them; with geofence and stand-off ring at most 200 corners at the altitude of a UAV.</source>
        <translation>Zones que les drones évitent s&apos;ils partent à l&apos;écart ; avec la barrière et l&apos;anneau de sécurité, au plus 200 sommets à l&apos;altitude d&apos;un drone.</translation>
    </message>
    <message>
        <source>Airspace, for information: a check reports that the operation may enter it, but no UAV is kept out.</source>
        <translation>Espaces aériens, pour information : un contrôle signale que l&apos;opération peut y entrer, mais aucun drone n&apos;en est écarté.</translation>
    </message>
    <message>
        <source>Content of a permit application: constants of the operation volume, and texts for the flight brief.</source>
        <translation>Contenu d&apos;une demande d&apos;autorisation : constantes du volume d&apos;opération et textes du dossier de vol.</translation>
    </message>
    <message>
        <source>Protected asset.</source>
        <translation>Bien protégé.</translation>
    </message>
    <message>
        <source>Missing values are not checked.</source>
        <translation>Les valeurs absentes ne sont pas vérifiées.</translation>
    </message>
    <message>
        <source>`{&quot;time_s&quot;: [...], &quot;position_m&quot;: [[x, y], ...]}`: true positions, instead of random drift.</source>
        <translation>`{&quot;time_s&quot;: [...], &quot;position_m&quot;: [[x, y], ...]}` : positions vraies, au lieu d&apos;une dérive aléatoire.</translation>
    </message>
    <message>
        <source>required</source>
        <translation>obligatoire</translation>
    </message>
    <message>
        <source>`%1` in older files.</source>
        <translation>`%1` dans les fichiers plus anciens.</translation>
    </message>
    <message>
        <source>Longest flight; the UAV is home before it ends. Without it, the UAV lands only when ordered to return.</source>
        <translation>Vol le plus long ; le drone est rentré avant sa fin. Sans elle, le drone n&apos;atterrit que sur ordre de retour.</translation>
    </message>
    <message>
        <source>Range of the link; without it, the radio horizon of the antenna and the UAV&apos;s altitude.</source>
        <translation>Portée de la liaison ; sans elle, l&apos;horizon radio de l&apos;antenne et de l&apos;altitude du drone.</translation>
    </message>
    <message>
        <source>Length at the waterline: wind and current then carry the iceberg by the balance of their drags (below 15 m: the current and 2 % of the wind, turned 20 degrees), and it stands still where a `forecast` gives a depth below its draft of 1.78 L^0.71. Without it the current alone carries the iceberg.</source>
        <translation>Longueur à la flottaison : vent et courant portent alors l&apos;iceberg selon l&apos;équilibre de leurs traînées (au-dessous de 15 m : le courant et 2 % du vent, tourné de 20 degrés), et il s&apos;arrête là où un `forecast` donne une profondeur inférieure à son tirant d&apos;eau de 1,78 L^0,71. Sans longueur, le courant seul porte l&apos;iceberg.</translation>
    </message>
    <message>
        <source>File or service that the chart comes from.</source>
        <translation>Fichier ou service d&apos;où vient la carte.</translation>
    </message>
    <message>
        <source>Date of the chart; without it, unknown.</source>
        <translation>Date de la carte ; sans elle, inconnue.</translation>
    </message>
    <message>
        <source>Words or codes of the chart for the area; may be empty.</source>
        <translation>Mots ou codes de la carte pour la zone ; peut être vide.</translation>
    </message>
    <message>
        <source>Part of the area that ice covers, in tenths; without it, unknown.</source>
        <translation>Part de la zone couverte de glace, en dixièmes ; sans elle, inconnue.</translation>
    </message>
    <message>
        <source>Whether the ice is fast to a shore and does not drift.</source>
        <translation>Indique si la glace est attachée à une côte et ne dérive pas.</translation>
    </message>
    <message>
        <source>Velocity of the wind at 10 m, towards true east and north.</source>
        <translation>Vitesse du vent à 10 m, vers l&apos;est et le nord vrais.</translation>
    </message>
    <message>
        <source>Speed of gusts.</source>
        <translation>Vitesse des rafales.</translation>
    </message>
    <message>
        <source>Temperature of the air at 2 m.</source>
        <translation>Température de l&apos;air à 2 m.</translation>
    </message>
    <message>
        <source>Dew point of the air at 2 m.</source>
        <translation>Point de rosée de l&apos;air à 2 m.</translation>
    </message>
    <message>
        <source>Part of the area with fog.</source>
        <translation>Part de la zone où il y a du brouillard.</translation>
    </message>
    <message>
        <source>Visibility.</source>
        <translation>Visibilité.</translation>
    </message>
    <message>
        <source>Height of the cloud base above the sea.</source>
        <translation>Hauteur de la base des nuages au-dessus de la mer.</translation>
    </message>
    <message>
        <source>Velocity of the current, towards true east and north.</source>
        <translation>Vitesse du courant, vers l&apos;est et le nord vrais.</translation>
    </message>
    <message>
        <source>Latitude of a place of the grid.</source>
        <translation>Latitude d&apos;un lieu de la grille.</translation>
    </message>
    <message>
        <source>Longitude of a place of the grid.</source>
        <translation>Longitude d&apos;un lieu de la grille.</translation>
    </message>
    <message>
        <source>Depth of the sea at the place.</source>
        <translation>Profondeur de la mer à ce lieu.</translation>
    </message>
    <message>
        <source>Ice chart for the map, without effect on the flight.</source>
        <translation>Carte des glaces à montrer sur la carte, sans effet sur le vol.</translation>
    </message>
    <message>
        <source>Areas of the chart, each with `outlines_m` (needed): outline and holes, each a list of corners.</source>
        <translation>Zones de la carte, chacune avec `outlines_m` (nécessaire) : contour et trous, chacun une liste de sommets.</translation>
    </message>
    <message>
        <source>Forecast with `source`, `issued` (UTC), `columns` (1) and `places`; needs `start_utc`.</source>
        <translation>Prévision avec `source`, `issued` (UTC), `columns` (1) et `places` ; exige `start_utc`.</translation>
    </message>
    <message>
        <source>Grid of rows from south to north, each from west to east, with `columns` places.</source>
        <translation>Grille de rangées du sud au nord, chacune d&apos;ouest en est, de `columns` lieux.</translation>
    </message>
    <message>
        <source>Values at a `time` (UTC; times rise); any may be missing.</source>
        <translation>Valeurs à un `time` (UTC ; en ordre croissant) ; chacune peut manquer.</translation>
    </message>
</context>
<context>
    <name>berg::FigureView</name>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
</context>
<context>
    <name>berg::FindBox</name>
    <message>
        <source>Favourite: listed when the box is opened</source>
        <translation>Favori : affiché à l&apos;ouverture du champ</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favori</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Trouvé</translation>
    </message>
    <message>
        <source>Move the scenario here…</source>
        <translation>Déplacer le scénario ici…</translation>
    </message>
    <message>
        <source>New scenario here</source>
        <translation>Nouveau scénario ici</translation>
    </message>
    <message>
        <source>Where is the new scenario? A place or coordinate</source>
        <translation>Où est le nouveau scénario ? Un lieu ou une coordonnée</translation>
    </message>
    <message>
        <source>Iceberg, UAV, place, coordinate or command</source>
        <translation>Iceberg, drone, lieu, coordonnée ou commande</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Rien trouvé</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Iceberg</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Coordinate</source>
        <translation>Coordonnée</translation>
    </message>
    <message>
        <source>Sea or bay</source>
        <translation>Mer ou baie</translation>
    </message>
    <message>
        <source>Island or coast</source>
        <translation>Île ou côte</translation>
    </message>
    <message>
        <source>Cape</source>
        <translation>Cap</translation>
    </message>
    <message>
        <source>Town or station</source>
        <translation>Ville ou station</translation>
    </message>
    <message>
        <source>Oil or gas field</source>
        <translation>Champ de pétrole ou de gaz</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Champ</translation>
    </message>
</context>
<context>
    <name>berg::FlightCard</name>
    <message>
        <source>Run complete</source>
        <translation>Vol terminé</translation>
    </message>
    <message>
        <source>Result of the run</source>
        <translation>Résultat du vol</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Closes this card until the next run ends.</source>
        <translation>Ferme cette fiche jusqu&apos;à la fin du prochain vol.</translation>
    </message>
    <message>
        <source>Zeta ζ</source>
        <translation>Zêta ζ</translation>
    </message>
    <message>
        <source>vs prediction</source>
        <translation>Par rapport à la prévision</translation>
    </message>
    <message>
        <source>ζ compared with the prediction for the policy before take-off.</source>
        <translation>ζ comparé à la prévision pour la stratégie avant le décollage.</translation>
    </message>
    <message>
        <source>Lower bound</source>
        <translation>Borne inférieure</translation>
    </message>
    <message>
        <source>no useful bound</source>
        <translation>pas de borne utile</translation>
    </message>
    <message>
        <source>Lower bound on ζ for these conditions, whatever the policy.</source>
        <translation>Borne inférieure de ζ dans ces conditions, quelle que soit la stratégie.</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Visites</translation>
    </message>
    <message>
        <source>Targets reached.</source>
        <translation>Cibles atteintes.</translation>
    </message>
    <message>
        <source>Longest unseen</source>
        <translation>Plus longtemps non vu</translation>
    </message>
    <message>
        <source>The iceberg that was out of view longest.</source>
        <translation>Iceberg resté le plus longtemps hors de vue.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Compares the run with others.</source>
        <translation>Compare le vol à d&apos;autres.</translation>
    </message>
    <message>
        <source>Save run</source>
        <translation>Enregistrer le vol</translation>
    </message>
    <message>
        <source>Saves the run to a file.</source>
        <translation>Enregistre le vol dans un fichier.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Exports the log of the run: planned and flown, sightings, deviations.</source>
        <translation>Exporte le journal du vol : planifié et effectué, observations, écarts.</translation>
    </message>
    <message>
        <source>Predicted range</source>
        <translation>Plage prévue</translation>
    </message>
    <message>
        <source>Predicted range of ζ for 90 % of flights.</source>
        <translation>Plage de ζ prévue pour 90 % des vols.</translation>
    </message>
    <message>
        <source>below %1 to %2</source>
        <translation>au-dessous de %1 à %2</translation>
    </message>
    <message>
        <source>above %1 to %2</source>
        <translation>au-dessus de %1 à %2</translation>
    </message>
    <message>
        <source>inside %1 to %2</source>
        <translation>entre %1 et %2</translation>
    </message>
    <message>
        <source>changed in flight</source>
        <translation>modifié en vol</translation>
    </message>
    <message>
        <source>being computed, %1 %</source>
        <translation>en cours de calcul, %1 %</translation>
    </message>
</context>
<context>
    <name>berg::FlightView</name>
    <message>
        <source>Planning</source>
        <translation>Planification</translation>
    </message>
    <message>
        <source>Ready. Press Space to fly</source>
        <translation>Prêt. Espace lance le vol</translation>
    </message>
    <message>
        <source>Flying</source>
        <translation>En vol</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
    <message>
        <source>Run complete</source>
        <translation>Vol terminé</translation>
    </message>
    <message>
        <source>Cannot be planned: %1</source>
        <translation>Planification impossible : %1</translation>
    </message>
    <message>
        <source>Press I and click on the map to place an iceberg, drag to set its drift, or import sightings.</source>
        <translation>Appuyez sur I et cliquez sur la carte pour placer un iceberg, faites glisser pour régler sa dérive, ou importez des observations.</translation>
    </message>
    <message>
        <source>The plan is still being made.</source>
        <translation>Le plan est encore en cours d&apos;élaboration.</translation>
    </message>
    <message>
        <source>Flight to %1 discarded</source>
        <translation>Vol jusqu&apos;à %1 abandonné</translation>
    </message>
</context>
<context>
    <name>berg::ForecastDialog</name>
    <message>
        <source>Forecast</source>
        <translation>Prévision</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Wind from</source>
        <translation>Vent de</translation>
    </message>
    <message>
        <source>Gust</source>
        <translation>Rafales</translation>
    </message>
    <message>
        <source>Air, °C</source>
        <translation>Air, °C</translation>
    </message>
    <message>
        <source>Dew point, °C</source>
        <translation>Point de rosée, °C</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Visibilité</translation>
    </message>
    <message>
        <source>Cloud base</source>
        <translation>Base des nuages</translation>
    </message>
    <message>
        <source>Current to</source>
        <translation>Courant vers</translation>
    </message>
    <message>
        <source>Co&amp;mbine with the present forecast</source>
        <translation>Co&amp;mbiner avec la prévision actuelle</translation>
    </message>
    <message>
        <source>&amp;Open file...</source>
        <translation>&amp;Ouvrir un fichier…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>&amp;Définir</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Source : %1</translation>
    </message>
    <message>
        <source>Time of issue unknown</source>
        <translation>Heure d&apos;émission inconnue</translation>
    </message>
    <message>
        <source>Issued %1</source>
        <translation>Émise le %1</translation>
    </message>
    <message>
        <source>Issued %1, %2 h before the start: get a newer forecast</source>
        <translation>Émise le %1, %2 h avant le début : obtenez une prévision plus récente</translation>
    </message>
    <message>
        <source>Issued %1, %2 h before the start</source>
        <translation>Émise le %1, %2 h avant le début</translation>
    </message>
    <message numerus="yes">
        <source>%n places, the table is for the middle one</source>
        <translation>
            <numerusform>%n lieu, celui du tableau</numerusform>
            <numerusform>%n lieux, le tableau est pour celui du milieu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n times, from %1 to %2</source>
        <translation>
            <numerusform>%n heure, de %1 à %2</numerusform>
            <numerusform>%n heures, de %1 à %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Thinned by a factor of %1 in each direction</source>
        <translation>Réduite d&apos;un facteur %1 dans chaque direction</translation>
    </message>
    <message>
        <source>The scenario has no forecast: wind and current are constant.</source>
        <translation>Le scénario n&apos;a pas de prévision : vent et courant sont constants.</translation>
    </message>
    <message>
        <source>No values of one quantity between %1 and %2</source>
        <translation>Aucune valeur d&apos;une grandeur entre %1 et %2</translation>
    </message>
</context>
<context>
    <name>berg::GenerateDialog</name>
    <message>
        <source>Generate icebergs</source>
        <translation>Générer des icebergs</translation>
    </message>
    <message>
        <source>&amp;Number</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>The scenario&apos;s area</source>
        <translation>La zone du scénario</translation>
    </message>
    <message>
        <source>Visible part of the map</source>
        <translation>Partie visible de la carte</translation>
    </message>
    <message>
        <source>Rectangle in the middle of the map</source>
        <translation>Rectangle au milieu de la carte</translation>
    </message>
    <message>
        <source>&amp;Where</source>
        <translation>&amp;Emplacement</translation>
    </message>
    <message>
        <source>Width of the rectangle</source>
        <translation>Largeur du rectangle</translation>
    </message>
    <message>
        <source>Height of the rectangle</source>
        <translation>Hauteur du rectangle</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>Ta&amp;ille</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>&amp;Vitesse</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>In any direction</source>
        <translation>Dans toutes les directions</translation>
    </message>
    <message>
        <source>Around one direction</source>
        <translation>Autour d&apos;une direction</translation>
    </message>
    <message>
        <source>D&amp;rift</source>
        <translation>Dé&amp;rive</translation>
    </message>
    <message>
        <source>D&amp;irection</source>
        <translation>&amp;Direction</translation>
    </message>
    <message>
        <source>&amp;Uncertainty σ</source>
        <translation>Incertit&amp;ude σ</translation>
    </message>
    <message>
        <source>&amp;Growth q</source>
        <translation>&amp;Croissance q</translation>
    </message>
    <message>
        <source>&amp;Minimum spacing</source>
        <translation>Distance &amp;minimale</translation>
    </message>
    <message>
        <source>The same seed generates the same field again.</source>
        <translation>La même graine reproduit le même champ.</translation>
    </message>
    <message>
        <source>&amp;Another</source>
        <translation>&amp;Autre</translation>
    </message>
    <message>
        <source>Generates another random field.</source>
        <translation>Génère un autre champ aléatoire.</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>&amp;Graine</translation>
    </message>
    <message>
        <source>R&amp;eplace existing icebergs</source>
        <translation>Rem&amp;placer les icebergs présents</translation>
    </message>
    <message>
        <source>Generate</source>
        <translation>Générer</translation>
    </message>
    <message numerus="yes">
        <source>The scenario will have %n icebergs.</source>
        <translation>
            <numerusform>Le scénario aura %n iceberg.</numerusform>
            <numerusform>Le scénario aura %n icebergs.</numerusform>
        </translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Unknown, changing within 10 h</source>
        <translation>Inconnue, changeant en 10 h</translation>
    </message>
    <message>
        <source>As fitted to a beacon: 0.15 m/s along each axis, in any direction. Icebergs are then measured in flight.</source>
        <translation>Ajustée sur une balise : 0,15 m/s selon chaque axe, dans toutes les directions. Les icebergs sont alors mesurés en vol.</translation>
    </message>
</context>
<context>
    <name>berg::IceRow</name>
    <message>
        <source>Report sighting</source>
        <translation>Signaler l&apos;observation</translation>
    </message>
    <message>
        <source>Ice tracked by radar or marked by AIS</source>
        <translation>Glace suivie par radar ou marquée par AIS</translation>
    </message>
    <message>
        <source>In flight: the nearest iceberg that it may be counts as seen by others; without one, a new iceberg appears.</source>
        <translation>En vol : l&apos;iceberg le plus proche que ce peut être compte comme vu par d&apos;autres ; sinon, un nouvel iceberg apparaît.</translation>
    </message>
</context>
<context>
    <name>berg::IcebergTable</name>
    <message>
        <source>Find by name or id</source>
        <translation>Rechercher par nom ou identifiant</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Icebergs</translation>
    </message>
    <message>
        <source>A row for each iceberg. Before take-off Return edits a cell, Ctrl+Return sets it in all rows selected, Ctrl+C and Ctrl+V exchange rows with a spreadsheet. In flight Return shows the iceberg on the map.</source>
        <translation>Une ligne par iceberg. Avant le décollage, Entrée modifie une cellule, Ctrl+Entrée la règle dans toutes les lignes sélectionnées, Ctrl+C et Ctrl+V échangent des lignes avec un tableur. En vol, Entrée montre l&apos;iceberg sur la carte.</translation>
    </message>
    <message>
        <source>No iceberg has this in its name or id.</source>
        <translation>Aucun iceberg n&apos;a ce texte dans son nom ou son identifiant.</translation>
    </message>
    <message>
        <source>There are no icebergs in this flight.</source>
        <translation>Il n&apos;y a aucun iceberg dans ce vol.</translation>
    </message>
    <message>
        <source>No icebergs yet: press I and click on the map, or copy rows of a spreadsheet (name, east, north, speed, direction, σ₀ ...) and paste them here with Ctrl+V.</source>
        <translation>Aucun iceberg pour l&apos;instant : appuyez sur I et cliquez sur la carte, ou copiez les lignes d&apos;un tableur (nom, est, nord, vitesse, direction, σ₀…) et collez-les ici avec Ctrl+V.</translation>
    </message>
    <message>
        <source>In flight the icebergs cannot be edited. Stop the flight to paste.</source>
        <translation>En vol, les icebergs ne peuvent pas être modifiés. Arrêtez le vol pour coller.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Co&amp;ller</translation>
    </message>
    <message>
        <source>Copy &quot;%1&quot;</source>
        <translation>Copier « %1 »</translation>
    </message>
    <message>
        <source>Show on the map</source>
        <translation>Afficher sur la carte</translation>
    </message>
</context>
<context>
    <name>berg::IcebergTableModel</name>
    <message>
        <source>Paste icebergs</source>
        <translation>Coller des icebergs</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; is computed from others. Nothing was pasted.</source>
        <translation>La colonne « %1 » est calculée à partir d&apos;autres. Rien n&apos;a été collé.</translation>
    </message>
</context>
<context>
    <name>berg::ImportColumnsView</name>
    <message>
        <source>This format has no columns to choose.</source>
        <translation>Ce format n&apos;a pas de colonnes à choisir.</translation>
    </message>
    <message>
        <source>First rows of the file</source>
        <translation>Premières lignes du fichier</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>Automatique : %1</translation>
    </message>
    <message>
        <source>Line of the file that names the columns, if a title precedes it.</source>
        <translation>Ligne du fichier qui nomme les colonnes, lorsqu&apos;un titre la précède.</translation>
    </message>
    <message>
        <source>&amp;Header line</source>
        <translation>Ligne d&apos;en-&amp;tête</translation>
    </message>
    <message>
        <source>Columns as for the last file with this header.</source>
        <translation>Colonnes comme pour le dernier fichier ayant cet en-tête.</translation>
    </message>
    <message>
        <source>&amp;Forget columns</source>
        <translation>&amp;Oublier les colonnes</translation>
    </message>
    <message>
        <source>Headers whose columns were chosen by hand in an earlier import.</source>
        <translation>En-têtes dont les colonnes ont été choisies à la main lors d&apos;une importation précédente.</translation>
    </message>
    <message>
        <source>All of them</source>
        <translation>Tous</translation>
    </message>
</context>
<context>
    <name>berg::ImportDialog</name>
    <message>
        <source>No icebergs</source>
        <translation>Aucun iceberg</translation>
    </message>
    <message>
        <source>No sighting can be imported.</source>
        <translation>Aucune observation ne peut être importée.</translation>
    </message>
    <message>
        <source>Import sightings from %1</source>
        <translation>Importer des observations de %1</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>Map of what comes out</source>
        <translation>Carte du résultat</translation>
    </message>
    <message>
        <source>+ new   * updated</source>
        <translation>+ nouveau   * mis à jour</translation>
    </message>
    <message>
        <source>Icebergs of the file</source>
        <translation>Icebergs du fichier</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Icebergs</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>Automatique : %1</translation>
    </message>
    <message>
        <source>Icebergs (%1)</source>
        <translation>Icebergs (%1)</translation>
    </message>
    <message>
        <source>Reading %1, %2 ...</source>
        <translation>Lecture de %1, %2…</translation>
    </message>
    <message>
        <source>Working ...</source>
        <translation>Traitement en cours…</translation>
    </message>
    <message>
        <source>Im&amp;port</source>
        <translation>Imp&amp;orter</translation>
    </message>
    <message>
        <source>Icebergs (first %1 of %2)</source>
        <translation>Icebergs (les %1 premiers sur %2)</translation>
    </message>
    <message>
        <source>Import into a &amp;new scenario</source>
        <translation>Importer dans un no&amp;uveau scénario</translation>
    </message>
    <message>
        <source>+ appears   * reported seen</source>
        <translation>+ apparaît   * signalé vu</translation>
    </message>
    <message>
        <source>Re&amp;port</source>
        <translation>&amp;Signaler</translation>
    </message>
    <message>
        <source>Report all t&amp;he same</source>
        <translation>Signaler &amp;quand même</translation>
    </message>
    <message>
        <source>Import all t&amp;he same</source>
        <translation>Importer &amp;quand même</translation>
    </message>
    <message>
        <source>Choose below which rows belong to the same iceberg.</source>
        <translation>Choisissez ci-dessous quelles lignes appartiennent au même iceberg.</translation>
    </message>
    <message>
        <source>Faster than 1.5 m/s or on land: %1. Check columns, units and ids.</source>
        <translation>Plus rapides que 1,5 m/s ou à terre : %1. Vérifiez les colonnes, les unités et les identifiants.</translation>
    </message>
    <message>
        <source>Velocities are uncertain, so the scenario will use the Kalman filter.</source>
        <translation>Les vitesses sont incertaines ; le scénario utilisera donc le filtre de Kalman.</translation>
    </message>
</context>
<context>
    <name>berg::ImportIdentityView</name>
    <message>
        <source>Rows with the same “%1”</source>
        <translation>Lignes ayant le même « %1 »</translation>
    </message>
    <message>
        <source>All rows are one iceberg</source>
        <translation>Toutes les lignes sont un seul iceberg</translation>
    </message>
    <message>
        <source>Each row is a separate iceberg</source>
        <translation>Chaque ligne est un iceberg distinct</translation>
    </message>
    <message>
        <source>up to %1 m/s between sightings</source>
        <translation>jusqu&apos;à %1 m/s entre observations</translation>
    </message>
    <message>
        <source>The file does not say which rows belong to the same iceberg. Choose:</source>
        <translation>Le fichier n&apos;indique pas quelles lignes appartiennent au même iceberg. Choisissez :</translation>
    </message>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n iceberg</numerusform>
            <numerusform>%n icebergs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::ImportOptionsView</name>
    <message>
        <source>S&amp;tart at</source>
        <translation>Dé&amp;but à</translation>
    </message>
    <message>
        <source>Not &amp;before</source>
        <translation>Pas a&amp;vant</translation>
    </message>
    <message>
        <source>Earlier sightings are left out.</source>
        <translation>Les observations antérieures sont omises.</translation>
    </message>
    <message>
        <source>Not &amp;after</source>
        <translation>Pas a&amp;près</translation>
    </message>
    <message>
        <source>Later sightings are left out.</source>
        <translation>Les observations postérieures sont omises.</translation>
    </message>
    <message>
        <source>&amp;Growth q</source>
        <translation>&amp;Croissance q</translation>
    </message>
    <message>
        <source>Growth of the uncertainty if there are too few sightings to estimate it.</source>
        <translation>Croissance de l&apos;incertitude si les observations sont trop peu nombreuses pour l&apos;estimer.</translation>
    </message>
    <message>
        <source>This scenario</source>
        <translation>Ce scénario</translation>
    </message>
    <message>
        <source>A new scenario</source>
        <translation>Un nouveau scénario</translation>
    </message>
    <message>
        <source>Icebergs already in this scenario are updated by their ids.</source>
        <translation>Les icebergs que ce scénario contient déjà sont mis à jour d&apos;après leurs identifiants.</translation>
    </message>
    <message>
        <source>&amp;Into</source>
        <translation>&amp;Dans</translation>
    </message>
    <message>
        <source>Insi&amp;de</source>
        <translation>À l&apos;intér&amp;ieur</translation>
    </message>
    <message>
        <source>Sightings outside these latitudes and longitudes are left out.</source>
        <translation>Les observations hors de ces latitudes et longitudes sont omises.</translation>
    </message>
    <message>
        <source>Visible part of the &amp;map</source>
        <translation>Partie visible de la ca&amp;rte</translation>
    </message>
    <message>
        <source>South</source>
        <translation>Sud</translation>
    </message>
    <message>
        <source>West</source>
        <translation>Ouest</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Est</translation>
    </message>
    <message>
        <source>With &amp;recorded tracks</source>
        <translation>Avec les &amp;traces enregistrées</translation>
    </message>
    <message>
        <source>Sightings after the start become the true motion of an iceberg. Requires a start time.</source>
        <translation>Les observations postérieures au début deviennent le mouvement réel d&apos;un iceberg. Nécessite une heure de début.</translation>
    </message>
    <message>
        <source>Position &amp;error</source>
        <translation>&amp;Erreur de position</translation>
    </message>
    <message>
        <source>Drift &amp;variation</source>
        <translation>V&amp;ariabilité de la dérive</translation>
    </message>
    <message>
        <source>Standard deviation of an unknown drift along each axis. With 0 the drift counts as known and constant.</source>
        <translation>Écart-type d&apos;une dérive inconnue selon chaque axe. Avec 0, la dérive compte comme connue et constante.</translation>
    </message>
    <message>
        <source>Drift &amp;changes in</source>
        <translation>La dérive cha&amp;nge en</translation>
    </message>
    <message>
        <source>Time after which a known drift is no longer valid. 0 means never.</source>
        <translation>Temps au bout duquel une dérive connue n&apos;est plus valable. 0 signifie jamais.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Month first: 12/31/2021</source>
        <translation>Mois en premier : 12/31/2021</translation>
    </message>
    <message>
        <source>Day first: 31/12/2021</source>
        <translation>Jour en premier : 31/12/2021</translation>
    </message>
    <message>
        <source>How to read dates such as 05/02/2021.</source>
        <translation>Sens des dates comme 05/02/2021.</translation>
    </message>
    <message>
        <source>Dat&amp;es</source>
        <translation>Date&amp;s</translation>
    </message>
    <message>
        <source>UTC time that becomes the start of the scenario. Otherwise its start stays, or moves to the last sighting if that is later.</source>
        <translation>Heure UTC qui devient le départ du scénario. Sinon le départ reste, ou passe à la dernière observation si elle est plus tardive.</translation>
    </message>
    <message>
        <source>Standard deviation of a position along each axis if the file states none and no column names the source.</source>
        <translation>Écart-type d&apos;une position le long de chaque axe lorsque le fichier n&apos;en indique pas et qu&apos;aucune colonne ne nomme la source.</translation>
    </message>
    <message>
        <source>As stated in the file</source>
        <translation>Selon le fichier</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Comme saisi</translation>
    </message>
    <message>
        <source>Sensor that found the positions. Rows whose column “source”, “method” or “sensor” names another source use its error.</source>
        <translation>Capteur qui a trouvé les positions. Les lignes dont la colonne « source », « method » ou « sensor » nomme une autre source utilisent l&apos;erreur de celle-ci.</translation>
    </message>
    <message>
        <source>Seen b&amp;y</source>
        <translation>Ori&amp;gine</translation>
    </message>
</context>
<context>
    <name>berg::ImportRowsView</name>
    <message>
        <source>Rejected rows</source>
        <translation>Lignes rejetées</translation>
    </message>
    <message>
        <source>Rejected rows (%1)</source>
        <translation>Lignes rejetées (%1)</translation>
    </message>
    <message>
        <source>Rejected rows (first %1 of %2)</source>
        <translation>Lignes rejetées (les %1 premières sur %2)</translation>
    </message>
    <message>
        <source>Changed rows</source>
        <translation>Lignes modifiées</translation>
    </message>
    <message>
        <source>Changed rows (%1)</source>
        <translation>Lignes modifiées (%1)</translation>
    </message>
    <message>
        <source>Changed rows (first %1 of %2)</source>
        <translation>Lignes modifiées (les %1 premières sur %2)</translation>
    </message>
    <message>
        <source>Outside area or time</source>
        <translation>Hors zone ou période</translation>
    </message>
    <message>
        <source>Outside area or time (%1)</source>
        <translation>Hors zone ou période (%1)</translation>
    </message>
    <message>
        <source>Outside area or time (first %1 of %2)</source>
        <translation>Hors zone ou période (les %1 premières sur %2)</translation>
    </message>
</context>
<context>
    <name>berg::InspectorForm</name>
    <message>
        <source>mixed</source>
        <translation>divers</translation>
    </message>
</context>
<context>
    <name>berg::InspectorPanel</name>
    <message>
        <source>Id</source>
        <translation>Identifiant</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Scénario</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Iceberg</translation>
    </message>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n iceberg</numerusform>
            <numerusform>%n icebergs</numerusform>
        </translation>
    </message>
    <message>
        <source>Only the selected icebergs are edited here.</source>
        <translation>Seuls les icebergs sélectionnés sont modifiés ici.</translation>
    </message>
    <message>
        <source>Edits apply to all of them.</source>
        <translation>Les modifications s&apos;appliquent à tous.</translation>
    </message>
    <message>
        <source>UAV %1</source>
        <translation>Drone %1</translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>%n drone</numerusform>
            <numerusform>%n drones</numerusform>
        </translation>
    </message>
    <message>
        <source>Change id</source>
        <translation>Modifier l&apos;identifiant</translation>
    </message>
    <message>
        <source>Select an object on the map to edit it.</source>
        <translation>Sélectionnez un objet sur la carte pour le modifier.</translation>
    </message>
    <message>
        <source>Asset</source>
        <translation>Bien protégé</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Drag its corners on the map to change it.</source>
        <translation>Faites glisser ses sommets sur la carte pour la modifier.</translation>
    </message>
    <message>
        <source>Identifies the iceberg in files and lists; must be unique.</source>
        <translation>Identifie l&apos;iceberg dans les fichiers et les listes ; doit être unique.</translation>
    </message>
    <message>
        <source>Identifies the UAV in files and lists; must be unique.</source>
        <translation>Identifie le drone dans les fichiers et les listes ; doit être unique.</translation>
    </message>
    <message>
        <source>No-fly area</source>
        <translation>Zone interdite</translation>
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
        <translation>Noms</translation>
    </message>
    <message>
        <source>Drift arrows</source>
        <translation>Flèches de dérive</translation>
    </message>
    <message>
        <source>Uncertainty rings</source>
        <translation>Cercles d&apos;incertitude</translation>
    </message>
    <message>
        <source>Graticule</source>
        <translation>Méridiens et parallèles</translation>
    </message>
    <message>
        <source>Former plan</source>
        <translation>Ancien plan</translation>
    </message>
    <message>
        <source>Swept area</source>
        <translation>Zone balayée</translation>
    </message>
    <message>
        <source>%1: opacity in per cent</source>
        <translation>%1 : opacité en pour cent</translation>
    </message>
    <message>
        <source>Opacity; at the left end the layer is hidden</source>
        <translation>Opacité ; à l&apos;extrémité gauche, la couche est masquée</translation>
    </message>
    <message>
        <source>Time covered by drift arrows; arrows too long for the map are shortened and dashed</source>
        <translation>Durée couverte par les flèches de dérive ; celles qui sont trop longues pour la carte sont raccourcies et en tirets</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Drift horizon</source>
        <translation>Horizon de dérive</translation>
    </message>
    <message>
        <source>Airspace and operation volume</source>
        <translation>Espace aérien et volume opérationnel</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fond de carte</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Removes the background</source>
        <translation>Retire le fond de carte</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Choisir un fichier…</translation>
    </message>
    <message>
        <source>Your own map below all layers, such as an ice chart: GeoJSON, KML, KMZ or CZML</source>
        <translation>Votre propre carte sous toutes les couches, par exemple une carte des glaces : GeoJSON, KML, KMZ ou CZML</translation>
    </message>
    <message>
        <source>Background file: %1</source>
        <translation>Fichier du fond de carte : %1</translation>
    </message>
    <message>
        <source>Compared run</source>
        <translation>Vol comparé</translation>
    </message>
    <message>
        <source>Place names</source>
        <translation>Noms de lieux</translation>
    </message>
    <message>
        <source>Ice chart</source>
        <translation>Carte des glaces</translation>
    </message>
    <message>
        <source>Forecast wind</source>
        <translation>Vent prévu</translation>
    </message>
    <message>
        <source>Forecast current</source>
        <translation>Courant prévu</translation>
    </message>
    <message>
        <source>Predicted drift</source>
        <translation>Dérive prévue</translation>
    </message>
    <message>
        <source>Time between two marks of the predicted drift, up to 48 h</source>
        <translation>Temps entre deux marques de la dérive prévue, jusqu&apos;à 48 h</translation>
    </message>
    <message>
        <source>every %1</source>
        <translation>tous les %1</translation>
    </message>
    <message>
        <source>Marks of the drift</source>
        <translation>Marques de la dérive</translation>
    </message>
</context>
<context>
    <name>berg::LogRows</name>
    <message>
        <source>Write a log</source>
        <translation>Écrire un journal</translation>
    </message>
    <message>
        <source>Open a log…</source>
        <translation>Ouvrir un journal…</translation>
    </message>
    <message>
        <source>Plays a recorded flight (.tlog) in place of a link.</source>
        <translation>Lit un vol enregistré (.tlog) à la place d&apos;une liaison.</translation>
    </message>
    <message>
        <source>Part of the log that has been played</source>
        <translation>Partie du journal qui a été lue</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>Vitesse de lecture</translation>
    </message>
    <message>
        <source>Seconds of the log that are played in each second</source>
        <translation>Secondes du journal lues en une seconde</translation>
    </message>
    <message>
        <source>Writes every frame sent and received to a new file (.tlog) in the folder %1.</source>
        <translation>Écrit chaque trame envoyée et reçue dans un nouveau fichier (.tlog) du dossier %1.</translation>
    </message>
    <message>
        <source>Log %1 has been played: %2</source>
        <translation>Le journal %1 a été lu : %2</translation>
    </message>
    <message>
        <source>Playing log %1: %2</source>
        <translation>Lecture du journal %1 : %2</translation>
    </message>
    <message>
        <source>Damaged parts were skipped (%1).</source>
        <translation>Des parties endommagées ont été sautées (%1).</translation>
    </message>
    <message>
        <source>The log cannot be written: %1 (%2)</source>
        <translation>Le journal ne peut pas être écrit : %1 (%2)</translation>
    </message>
    <message>
        <source>The log has reached its largest size and has ended: %1</source>
        <translation>Le journal a atteint sa taille maximale et s&apos;est terminé : %1</translation>
    </message>
    <message>
        <source>Log: %1 (%2)</source>
        <translation>Journal : %1 (%2)</translation>
    </message>
</context>
<context>
    <name>berg::MainWindow</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
</context>
<context>
    <name>berg::ManualWindow</name>
    <message>
        <source>Bergwatch manual</source>
        <translation>Manuel de Bergwatch</translation>
    </message>
    <message>
        <source>Contents of the manual</source>
        <translation>Sommaire du manuel</translation>
    </message>
    <message>
        <source>Text of the manual</source>
        <translation>Texte du manuel</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>Texte plus grand</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>Texte plus petit</translation>
    </message>
    <message>
        <source>Search the manual (Ctrl+F)</source>
        <translation>Rechercher dans le manuel (Ctrl+F)</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Rechercher dans le manuel</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>Introuvable</translation>
    </message>
    <message>
        <source>Lines found: %1</source>
        <translation>Lignes trouvées : %1</translation>
    </message>
</context>
<context>
    <name>berg::MapController</name>
    <message numerus="yes">
        <source>%n icebergs removed from this run. Undo brings them back.</source>
        <translation>
            <numerusform>%n iceberg retiré de ce vol. Annuler le ramène.</numerusform>
            <numerusform>%n icebergs retirés de ce vol. Annuler les ramène.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::MapView</name>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message numerus="yes">
        <source>%n icebergs and the UAVs on the sea. Arrow keys move the map or the selection, plus and minus zoom, F fits. The iceberg table lists the icebergs.</source>
        <translation>
            <numerusform>%n iceberg et les drones en mer. Les flèches déplacent la carte ou la sélection, plus et moins zooment, F affiche tout. Le tableau des icebergs en donne la liste.</numerusform>
            <numerusform>%n icebergs et les drones en mer. Les flèches déplacent la carte ou la sélection, plus et moins zooment, F affiche tout. Le tableau des icebergs en donne la liste.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;New scenario</source>
        <translation>&amp;Nouveau scénario</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>Page d&apos;acc&amp;ueil</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>&amp;Import sightings...</source>
        <translation>&amp;Importer des observations…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Keep a &amp;backup copy</source>
        <translation>Garder une &amp;copie de sauvegarde</translation>
    </message>
    <message>
        <source>Before the first overwrite of a file, a copy is kept as NAME.berg~</source>
        <translation>Avant qu&apos;un fichier soit remplacé pour la première fois, une copie est gardée sous NOM.berg~</translation>
    </message>
    <message>
        <source>Reco&amp;ver unsaved work...</source>
        <translation>Récu&amp;pérer le travail non enregistré…</translation>
    </message>
    <message>
        <source>There is no unsaved work to recover</source>
        <translation>Il ne reste aucun travail non enregistré à récupérer</translation>
    </message>
    <message>
        <source>Save r&amp;un...</source>
        <translation>Enregistrer le &amp;vol…</translation>
    </message>
    <message>
        <source>&amp;Export plan...</source>
        <translation>E&amp;xporter le plan…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Co&amp;uper</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Co&amp;ller</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Add UA&amp;V</source>
        <translation>A&amp;jouter un drone</translation>
    </message>
    <message>
        <source>&amp;Generate icebergs...</source>
        <translation>&amp;Générer des icebergs…</translation>
    </message>
    <message>
        <source>Select &amp;all icebergs</source>
        <translation>Sélectionner &amp;tous les icebergs</translation>
    </message>
    <message>
        <source>&amp;Move the scenario…</source>
        <translation>Déplacer le scé&amp;nario…</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>Chec&amp;ks</source>
        <translation>Véri&amp;fications</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Panneaux</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Réta&amp;blir la disposition</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Plein é&amp;cran</translation>
    </message>
    <message>
        <source>&amp;Fit everything</source>
        <translation>T&amp;out afficher</translation>
    </message>
    <message>
        <source>Follo&amp;w the UAV</source>
        <translation>&amp;Suivre le drone</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Zoom a&amp;vant</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zoom arr&amp;ière</translation>
    </message>
    <message>
        <source>O&amp;verview</source>
        <translation>Vue d&apos;ense&amp;mble</translation>
    </message>
    <message>
        <source>Swept ar&amp;ea</source>
        <translation>Zone bala&amp;yée</translation>
    </message>
    <message>
        <source>S&amp;how true positions</source>
        <translation>Afficher les positions réell&amp;es</translation>
    </message>
    <message>
        <source>Shows the true positions of the icebergs beside the estimates. When off, the map shows only what an operator would see.</source>
        <translation>Affiche les positions réelles des icebergs à côté des estimations. Désactivé, la carte n&apos;affiche que ce que verrait un opérateur.</translation>
    </message>
    <message>
        <source>F&amp;light</source>
        <translation>&amp;Vol</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>Lancer le vol</translation>
    </message>
    <message>
        <source>&amp;Step one second</source>
        <translation>Avancer d&apos;une &amp;seconde</translation>
    </message>
    <message>
        <source>Stop and &amp;edit</source>
        <translation>Arrêter et modi&amp;fier</translation>
    </message>
    <message>
        <source>Restore disc&amp;arded flight</source>
        <translation>Rétablir le v&amp;ol</translation>
    </message>
    <message>
        <source>Prefer s&amp;horter route</source>
        <translation>Préférer une route plus cour&amp;te</translation>
    </message>
    <message>
        <source>Prefer more un&amp;certain first</source>
        <translation>Préférer les plus in&amp;certains d&apos;abord</translation>
    </message>
    <message>
        <source>Report as seen no&amp;w</source>
        <translation>Si&amp;gnaler comme vu maintenant</translation>
    </message>
    <message>
        <source>Win&amp;d...</source>
        <translation>&amp;Vent…</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>Plus &amp;rapide</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>Plus &amp;lent</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Step &amp;back one second</source>
        <translation>Rec&amp;uler d&apos;une seconde</translation>
    </message>
    <message>
        <source>Step one &amp;tick</source>
        <translation>Avancer d&apos;un p&amp;as</translation>
    </message>
    <message>
        <source>Step back one t&amp;ick</source>
        <translation>Reculer d&apos;un &amp;pas</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>Événement su&amp;ivant</translation>
    </message>
    <message>
        <source>&amp;Previous event</source>
        <translation>Événe&amp;ment précédent</translation>
    </message>
    <message>
        <source>&amp;Go to time</source>
        <translation>Aller à l&apos;i&amp;nstant</translation>
    </message>
    <message>
        <source>Bac&amp;k to latest</source>
        <translation>Revenir au &amp;dernier instant</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Visite guidée</translation>
    </message>
    <message>
        <source>&amp;About Bergwatch</source>
        <translation>À &amp;propos de Bergwatch</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Iceberg</translation>
    </message>
    <message>
        <source>UAV</source>
        <translation>Drone</translation>
    </message>
    <message>
        <source>Asset</source>
        <translation>Bien protégé</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Panoramique</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Outils</translation>
    </message>
    <message>
        <source>Zoom at the cursor</source>
        <translation>Zoomer au pointeur</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>molette</translation>
    </message>
    <message>
        <source>middle button, or arrow keys</source>
        <translation>bouton du milieu, ou touches fléchées</translation>
    </message>
    <message>
        <source>Nudge what is selected</source>
        <translation>Décaler légèrement la sélection</translation>
    </message>
    <message>
        <source>arrow keys</source>
        <translation>touches fléchées</translation>
    </message>
    <message>
        <source>Finish drawing, undo last point</source>
        <translation>Terminer le tracé, annuler le dernier point</translation>
    </message>
    <message>
        <source>Enter, Backspace</source>
        <translation>Entrée, Retour arrière</translation>
    </message>
    <message>
        <source>Steps of 15° while an arrow is drawn</source>
        <translation>Pas de 15° pendant le tracé d&apos;une flèche</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Maj</translation>
    </message>
    <message>
        <source>Cancel drawing, leave tool, clear selection</source>
        <translation>Annuler le tracé, quitter l&apos;outil, effacer la sélection</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>About Bergwatch</source>
        <translation>À propos de Bergwatch</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Bergwatch %1&lt;/h3&gt;&lt;p&gt;Plans and simulates UAV missions that monitor drifting icebergs.&lt;/p&gt;&lt;p&gt;Own code: MIT licence. Qt Charts: GPL 3. COIN-OR CBC: EPL. Land made with Natural Earth.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Bergwatch %1&lt;/h3&gt;&lt;p&gt;Planifie et simule des missions de drones qui surveillent des icebergs à la dérive.&lt;/p&gt;&lt;p&gt;Code propre : licence MIT. Qt Charts : GPL 3. COIN-OR CBC : EPL. Terres réalisées avec Natural Earth.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No-fly area</source>
        <translation>Zone interdite</translation>
    </message>
    <message>
        <source>&amp;Return home now</source>
        <translation>Rentrer à la &amp;base</translation>
    </message>
    <message>
        <source>Hold here</source>
        <translation>Attendre ici</translation>
    </message>
    <message>
        <source>Res&amp;ume</source>
        <translation>R&amp;eprendre</translation>
    </message>
    <message>
        <source>Panels on the map</source>
        <translation>Panneaux sur la carte</translation>
    </message>
    <message>
        <source>&amp;Title and figures</source>
        <translation>&amp;Titre et valeurs</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>&amp;Légende</translation>
    </message>
    <message>
        <source>&amp;Scale bar</source>
        <translation>É&amp;chelle</translation>
    </message>
    <message>
        <source>&amp;North arrow</source>
        <translation>Flèche du &amp;nord</translation>
    </message>
    <message>
        <source>&amp;Wind</source>
        <translation>&amp;Vent</translation>
    </message>
    <message>
        <source>Flight brie&amp;f...</source>
        <translation>&amp;Fiche de vol…</translation>
    </message>
    <message>
        <source>Copy p&amp;icture of the map</source>
        <translation>Copier l&apos;i&amp;mage de la carte</translation>
    </message>
    <message>
        <source>La&amp;youts</source>
        <translation>&amp;Dispositions</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Planification</translation>
    </message>
    <message>
        <source>&amp;Fly</source>
        <translation>&amp;Vol</translation>
    </message>
    <message>
        <source>&amp;Analyse</source>
        <translation>&amp;Analyse</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>Find or &amp;go to…</source>
        <translation>Rec&amp;hercher ou aller à…</translation>
    </message>
    <message>
        <source>Import airspa&amp;ce...</source>
        <translation>Importer l&apos;espace &amp;aérien…</translation>
    </message>
    <message>
        <source>Flight &amp;log...</source>
        <translation>&amp;Journal de vol…</translation>
    </message>
    <message>
        <source>&amp;Background map…</source>
        <translation>Fo&amp;nd de carte…</translation>
    </message>
    <message>
        <source>Values of a chart as a table</source>
        <translation>Valeurs d&apos;un graphique en tableau</translation>
    </message>
    <message>
        <source>Keyboard &amp;shortcuts</source>
        <translation>Raccourcis &amp;clavier</translation>
    </message>
    <message>
        <source>S&amp;tudy</source>
        <translation>É&amp;tude</translation>
    </message>
    <message>
        <source>&amp;Solve time</source>
        <translation>Temps de &amp;résolution</translation>
    </message>
    <message>
        <source>Colour scale of σ</source>
        <translation>Échelle de couleurs de σ</translation>
    </message>
    <message>
        <source>Place names</source>
        <translation>Noms de lieux</translation>
    </message>
    <message>
        <source>S&amp;ound alarms</source>
        <translation>Son à c&amp;haque alarme</translation>
    </message>
    <message>
        <source>A sound at each new alarm, until it is acknowledged</source>
        <translation>Un son à chaque nouvelle alarme, jusqu&apos;à ce qu&apos;elle soit acquittée</translation>
    </message>
    <message>
        <source>&amp;New icebergs seen by</source>
        <translation>&amp;Nouveaux icebergs observés par</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>I&amp;mport forecast...</source>
        <translation>I&amp;mporter une prévision…</translation>
    </message>
    <message>
        <source>Import ice c&amp;hart...</source>
        <translation>Importer une carte des &amp;glaces…</translation>
    </message>
    <message>
        <source>Ice chart</source>
        <translation>Carte des glaces</translation>
    </message>
    <message>
        <source>Forecast wind</source>
        <translation>Vent prévu</translation>
    </message>
    <message>
        <source>Forecast current</source>
        <translation>Courant prévu</translation>
    </message>
    <message>
        <source>Start times</source>
        <translation>Heures de départ</translation>
    </message>
    <message>
        <source>Predicted drift</source>
        <translation>Dérive prévue</translation>
    </message>
</context>
<context>
    <name>berg::MessageList</name>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
</context>
<context>
    <name>berg::MissionRunner</name>
    <message>
        <source>The scenario has changed meanwhile. Nothing was exported.</source>
        <translation>Le scénario a été modifié entre-temps. Rien n&apos;a été exporté.</translation>
    </message>
    <message>
        <source>The run has ended. Stop and edit to fly it differently.</source>
        <translation>Le vol est terminé. « Arrêter et modifier » permet de le jouer autrement.</translation>
    </message>
</context>
<context>
    <name>berg::MissionWorker</name>
    <message>
        <source>There is no run to save: the scenario cannot be planned.</source>
        <translation>Il n&apos;y a aucun vol à enregistrer : le scénario ne peut pas être planifié.</translation>
    </message>
    <message>
        <source>The replay of this run differs from the recording: %1</source>
        <translation>La relecture de ce vol diffère de l&apos;enregistrement : %1</translation>
    </message>
    <message>
        <source>There is no plan to upload.</source>
        <translation>Il n&apos;y a aucun plan à envoyer.</translation>
    </message>
    <message>
        <source>This scenario cannot be flown. Fix the reported errors first.</source>
        <translation>Ce scénario ne peut pas être exécuté. Corrigez d&apos;abord les erreurs signalées.</translation>
    </message>
    <message>
        <source>The flight follows real aircraft at their pace: it cannot be stepped.</source>
        <translation>Le vol suit des aéronefs réels à leur rythme : il ne peut pas avancer pas à pas.</translation>
    </message>
</context>
<context>
    <name>berg::NumberField</name>
    <message>
        <source>mixed</source>
        <translation>divers</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read. Type it like %2.</source>
        <translation>« %1 » est illisible. Écrivez-le comme %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is above the highest value. %2 was set.</source>
        <translation>« %1 » dépasse la valeur maximale. La valeur %2 a été retenue.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is below the lowest value. %2 was set.</source>
        <translation>« %1 » est inférieur à la valeur minimale. La valeur %2 a été retenue.</translation>
    </message>
</context>
<context>
    <name>berg::OriginDialog</name>
    <message>
        <source>Move the scenario</source>
        <translation>Déplacer le scénario</translation>
    </message>
    <message>
        <source>&amp;Origin at</source>
        <translation>&amp;Origine à</translation>
    </message>
    <message>
        <source>Move &amp;everything along with the origin</source>
        <translation>&amp;Tout déplacer avec l&apos;origine</translation>
    </message>
    <message>
        <source>&amp;Leave everything at its place on the Earth</source>
        <translation>&amp;Laisser tout à sa place sur la Terre</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Déplacer</translation>
    </message>
    <message>
        <source>Not everything can stay at its place: a scenario reaches %1 from its origin. Move everything along, or choose a nearer place.</source>
        <translation>Tout ne peut pas rester à sa place : un scénario s&apos;étend jusqu&apos;à %1 de son origine. Déplacez tout avec l&apos;origine ou choisissez un lieu plus proche.</translation>
    </message>
    <message>
        <source>The origin moves to %1, %2 away. Positions, courses and drift on the Earth stay the same.</source>
        <translation>L&apos;origine se déplace à %1, à %2 d&apos;ici. Les positions, les routes et la dérive sur la Terre restent les mêmes.</translation>
    </message>
    <message>
        <source>Everything moves to %1, %2 away, and keeps its position relative to the origin.</source>
        <translation>Tout se déplace à %1, à %2 d&apos;ici, et garde sa position par rapport à l&apos;origine.</translation>
    </message>
    <message>
        <source>The origin is here now.</source>
        <translation>L&apos;origine est ici actuellement.</translation>
    </message>
</context>
<context>
    <name>berg::OverviewInset</name>
    <message>
        <source>Overview</source>
        <translation>Vue d&apos;ensemble</translation>
    </message>
    <message>
        <source>Polar chart showing the location of the map. Click a place to move the map there.</source>
        <translation>Carte polaire montrant l&apos;emplacement de la carte. Cliquez sur un lieu pour y déplacer la carte.</translation>
    </message>
</context>
<context>
    <name>berg::ParetoChart</name>
    <message>
        <source>Distance against uncertainty reward</source>
        <translation>Distance et gain sur l&apos;incertitude</translation>
    </message>
    <message>
        <source>No icebergs to plan for</source>
        <translation>Aucun iceberg à planifier</translation>
    </message>
    <message>
        <source>Computing the plans for every τ</source>
        <translation>Calcul des plans pour tous les τ</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1 ; %2</translation>
    </message>
    <message>
        <source>Uncertainty reward, m²</source>
        <translation>Gain sur l&apos;incertitude, m²</translation>
    </message>
    <message>
        <source>Reward, m²</source>
        <translation>Gain, m²</translation>
    </message>
    <message>
        <source>Most uncertain first</source>
        <translation>Plus incertain d&apos;abord</translation>
    </message>
    <message>
        <source>Shortest path</source>
        <translation>Plus court chemin</translation>
    </message>
    <message>
        <source>Whole order, %1</source>
        <translation>Ordre entier, %1</translation>
    </message>
</context>
<context>
    <name>berg::PlaceField</name>
    <message>
        <source>Coordinate or name of a place</source>
        <translation>Coordonnée ou nom d&apos;un lieu</translation>
    </message>
</context>
<context>
    <name>berg::PlanModel</name>
    <message>
        <source>%1 (id %2)</source>
        <translation>%1 (identifiant %2)</translation>
    </message>
    <message>
        <source>Place in the visiting order</source>
        <translation>Rang dans l&apos;ordre de visite</translation>
    </message>
    <message>
        <source>Iceberg</source>
        <translation>Iceberg</translation>
    </message>
    <message>
        <source>Name of the iceberg</source>
        <translation>Nom de l&apos;iceberg</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>Distance from the previous iceberg, or from the UAV</source>
        <translation>Distance depuis l&apos;iceberg précédent, ou depuis le drone</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Arrivée</translation>
    </message>
    <message>
        <source>Uncertainty of the position now</source>
        <translation>Incertitude actuelle de la position</translation>
    </message>
    <message>
        <source>later</source>
        <translation>plus tard</translation>
    </message>
    <message>
        <source>The plan ends before this iceberg is seen.</source>
        <translation>Le plan se termine avant que cet iceberg soit vu.</translation>
    </message>
    <message numerus="yes">
        <source>%n visits</source>
        <translation>
            <numerusform>%n visite</numerusform>
            <numerusform>%n visites</numerusform>
        </translation>
    </message>
    <message>
        <source>It has no iceberg to visit.</source>
        <translation>Il n&apos;a aucun iceberg à visiter.</translation>
    </message>
    <message>
        <source>%1, flown %2</source>
        <comment>length and end of a way</comment>
        <translation>%1, fin %2</translation>
    </message>
    <message>
        <source>Assigned to %1</source>
        <translation>Attribué à %1</translation>
    </message>
    <message>
        <source>In view</source>
        <translation>En vue</translation>
    </message>
    <message>
        <source>Probability that the iceberg is in view when the UAV reaches its estimate</source>
        <translation>Probabilité que l&apos;iceberg soit en vue lorsque le drone atteint sa position estimée</translation>
    </message>
    <message>
        <source>%1 (search)</source>
        <translation>%1 (recherche)</translation>
    </message>
    <message>
        <source>Lost: searched for %1</source>
        <comment>times and chances of finding it</comment>
        <translation>Perdu : recherché %1</translation>
    </message>
    <message>
        <source>Returning home</source>
        <translation>Retour à la base</translation>
    </message>
    <message>
        <source>σ now</source>
        <translation>σ actuel</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Au sol</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>En attente</translation>
    </message>
    <message>
        <source>Uncertainty of the position on arrival</source>
        <translation>Incertitude de la position à l&apos;arrivée</translation>
    </message>
    <message>
        <source>%1, flown by %2</source>
        <comment>length and end of a path, UTC</comment>
        <translation>%1, effectué à %2</translation>
    </message>
    <message>
        <source>Course over ground %1, ground speed %2</source>
        <translation>Route fond %1, vitesse sol %2</translation>
    </message>
    <message>
        <source>Now %1; at arrival %2, if the iceberg is not seen before</source>
        <translation>Maintenant %1 ; à l&apos;arrivée %2, si l&apos;iceberg n&apos;est pas vu avant</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Route</translation>
    </message>
    <message>
        <source>Course over ground at the start of the leg</source>
        <translation>Route fond au début du segment</translation>
    </message>
    <message>
        <source>Speed</source>
        <comment>over ground</comment>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Ground speed in the present wind</source>
        <translation>Vitesse sol dans le vent actuel</translation>
    </message>
    <message>
        <source>Arrival of the UAV</source>
        <translation>Arrivée du drone</translation>
    </message>
    <message>
        <source>95 % now</source>
        <translation>95 % maintenant</translation>
    </message>
    <message>
        <source>A later visit of the patrol, %1. Its path is planned when its turn comes.</source>
        <translation>Une visite ultérieure de la patrouille, %1. Sa trajectoire sera planifiée le moment venu.</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>De nouveau</translation>
    </message>
    <message>
        <source>When the patrol comes back to the iceberg</source>
        <translation>Quand la patrouille revient à l&apos;iceberg</translation>
    </message>
</context>
<context>
    <name>berg::PlanPanel</name>
    <message>
        <source>There is no plan: see Checks.</source>
        <translation>Il n&apos;y a pas de plan : voir « Vérifications ».</translation>
    </message>
    <message>
        <source>Plan: icebergs in visiting order</source>
        <translation>Plan : icebergs dans l&apos;ordre de visite</translation>
    </message>
    <message>
        <source>Order before the change at %1: %2</source>
        <translation>Ordre avant la modification à %1 : %2</translation>
    </message>
    <message>
        <source>Predicted for straight legs to the icebergs as they drift,
without sightings en route and without new plans.</source>
        <translation>Prévu pour des segments droits vers les icebergs à la dérive,
sans observations en chemin et sans nouveaux plans.</translation>
    </message>
    <message>
        <source>Predicted for the path on the map, with every iceberg that comes into view
on it, without new plans.</source>
        <translation>Prévu pour la trajectoire sur la carte, avec chaque iceberg qui entre en vue
en chemin, sans nouveaux plans.</translation>
    </message>
    <message>
        <source>No useful lower bound on ζ</source>
        <translation>Pas de borne inférieure utile de ζ</translation>
    </message>
    <message>
        <source>The lower bound is proven for this scenario and its random drift,
for any policy and any turn radius.</source>
        <translation>La borne inférieure est prouvée pour ce scénario et sa dérive aléatoire,
quels que soient la stratégie et le rayon de virage.</translation>
    </message>
    <message>
        <source>Out of radio range for %1</source>
        <translation>Hors de portée radio pendant %1</translation>
    </message>
    <message>
        <source>Recovery slots: %1</source>
        <translation>Créneaux d&apos;atterrissage : %1</translation>
    </message>
    <message>
        <source>Compared with the last plan: %1</source>
        <translation>Par rapport au plan précédent : %1</translation>
    </message>
    <message>
        <source>The run is complete.</source>
        <translation>Le vol est terminé.</translation>
    </message>
    <message>
        <source>This sortie: %1 with the return, flown by %2</source>
        <translation>Cette sortie : %1 retour compris, fin à %2</translation>
    </message>
    <message>
        <source>This sortie: %1 with the return, flown %2</source>
        <translation>Cette sortie : %1 retour compris, fin %2</translation>
    </message>
    <message>
        <source>This sortie: %1, flown by %2</source>
        <translation>Cette sortie : %1, fin à %2</translation>
    </message>
    <message>
        <source>This sortie: %1, flown %2</source>
        <translation>Cette sortie : %1, fin %2</translation>
    </message>
    <message>
        <source>ζ at the end: %1</source>
        <translation>ζ à la fin : %1</translation>
    </message>
    <message>
        <source>Expected ζ at %1 with this plan: %2</source>
        <translation>ζ attendu à %1 avec ce plan : %2</translation>
    </message>
    <message>
        <source>Expected ζ at the end with this plan: %1</source>
        <translation>ζ attendu à la fin avec ce plan : %1</translation>
    </message>
    <message>
        <source>Compared with the last plan: %1, ζ %2</source>
        <translation>Par rapport au plan précédent : %1, ζ %2</translation>
    </message>
    <message>
        <source>Lower bound on ζ: being computed, %1 %</source>
        <translation>Borne inférieure de ζ : en cours de calcul, %1 %</translation>
    </message>
    <message>
        <source>Lower bound on ζ: %1</source>
        <translation>Borne inférieure de ζ : %1</translation>
    </message>
    <message>
        <source>The length of this sortie is over ground, up to the end of the run at most.</source>
        <translation>La longueur de cette sortie est mesurée sur le fond, au plus jusqu&apos;à la fin du vol.</translation>
    </message>
    <message>
        <source>Nothing to visit: there are no icebergs yet, all of them are in view, or none can be visited without using the reserve.</source>
        <translation>Rien à visiter : il n&apos;y a pas encore d&apos;icebergs, tous sont en vue, ou aucun ne peut être visité sans utiliser la réserve.</translation>
    </message>
    <message>
        <source>Longest time unseen: %1 (%2)</source>
        <comment>duration and iceberg</comment>
        <translation>Plus longue durée sans observation : %1 (%2)</translation>
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
        <translation>Gain sur l&apos;incertitude</translation>
    </message>
    <message>
        <source>Sum of each iceberg&apos;s σ times the number of places after it in the order: larger if uncertain icebergs come early.</source>
        <translation>Somme du σ de chaque iceberg multiplié par le nombre de rangs qui le suivent dans l&apos;ordre : plus grande si les icebergs incertains viennent tôt.</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Objectif</translation>
    </message>
    <message>
        <source>Distance cost minus uncertainty reward: the objective that the solver minimises.</source>
        <translation>Coût de la distance moins gain sur l&apos;incertitude : l&apos;objectif que le solveur minimise.</translation>
    </message>
    <message>
        <source>Distance weight μ</source>
        <translation>Poids de la distance μ</translation>
    </message>
    <message>
        <source>Uncertainty that one metre of path must be worth; follows from τ.</source>
        <translation>Incertitude que doit valoir un mètre de trajet ; découle de τ.</translation>
    </message>
    <message>
        <source>%1 m²/m</source>
        <translation>%1 m²/m</translation>
    </message>
    <message>
        <source>Show the checks</source>
        <translation>Afficher les vérifications</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <source>Objective and distance weight of the plan</source>
        <translation>Objectif et poids de la distance du plan</translation>
    </message>
    <message>
        <source>State of the plan: %1</source>
        <translation>État du plan : %1</translation>
    </message>
    <message>
        <source>Whole order</source>
        <translation>Ordre entier</translation>
    </message>
    <message>
        <source>Planned length of the whole order through the air, with turns; in wind the mean of both directions. The solver weighs this length and the trade-off chart shows it. The plan panel shows the length of this sortie over ground.</source>
        <translation>Longueur prévue de l&apos;ordre entier dans l&apos;air, virages compris ; dans le vent, moyenne des deux sens. Le solveur pèse cette longueur et le graphique du compromis l&apos;affiche. Le panneau du plan affiche la longueur de cette sortie sur le fond.</translation>
    </message>
</context>
<context>
    <name>berg::PlaybackBar</name>
    <message>
        <source>Fly</source>
        <translation>Lancer</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Rate of the flight</source>
        <translation>Vitesse de déroulement du vol</translation>
    </message>
    <message>
        <source>Simulated seconds flown in one second</source>
        <translation>Secondes simulées par seconde</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>The plan is still being made.</source>
        <translation>Le plan est encore en cours d&apos;élaboration.</translation>
    </message>
    <message>
        <source>This scenario cannot be flown. Fix the reported errors first.</source>
        <translation>Ce scénario ne peut pas être exécuté. Corrigez d&apos;abord les erreurs signalées.</translation>
    </message>
    <message>
        <source>The run has ended.</source>
        <translation>Le vol est terminé.</translation>
    </message>
    <message>
        <source>Fly again from the start (Space)</source>
        <translation>Rejouer le vol depuis le début (Espace)</translation>
    </message>
    <message>
        <source>Pause the flight (Space)</source>
        <translation>Suspendre le vol (Espace)</translation>
    </message>
    <message>
        <source>Fly the plan (Space)</source>
        <translation>Exécuter le plan (Espace)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Fly one second and pause</source>
        <translation>Avancer d&apos;une seconde, puis pause</translation>
    </message>
    <message>
        <source>Time line of the run</source>
        <translation>Ligne de temps du vol</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>Instant affiché</translation>
    </message>
    <message>
        <source>Time shown. Type a time to look back, e.g. 3:20.</source>
        <translation>Instant affiché. Saisissez un temps pour y revenir, p. ex. 3:20.</translation>
    </message>
    <message>
        <source>Length of the run</source>
        <translation>Durée du vol</translation>
    </message>
    <message>
        <source>Fastest</source>
        <translation>Le plus rapide</translation>
    </message>
    <message>
        <source>Stop and edit</source>
        <translation>Arrêter et modifier</translation>
    </message>
    <message>
        <source>Ends the flight and goes back to the start, where everything can be edited.</source>
        <translation>Met fin au vol et revient au début, où tout peut être modifié.</translation>
    </message>
    <message>
        <source>The run is complete. The scenario stays locked until you stop and edit.</source>
        <translation>Le vol est terminé. Le scénario reste verrouillé jusqu&apos;à « Arrêter et modifier ».</translation>
    </message>
    <message>
        <source>Scenario locked in flight. τ and policy can be changed while flying; the plan follows at once.</source>
        <translation>Scénario verrouillé en vol. τ et la stratégie peuvent être modifiés ; le plan suit aussitôt.</translation>
    </message>
    <message>
        <source>Scenario locked</source>
        <translation>Scénario verrouillé</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time. Type it like 3:20 or 45 min.</source>
        <translation>« %1 » n&apos;est pas un temps. Écrivez-le comme 3:20 ou 45 min.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time of this run. Type it like 1215Z, 3:20 or 45 min.</source>
        <translation>« %1 » n&apos;est pas un instant de ce vol. Saisissez-le comme 1215Z, 3:20 ou 45 min.</translation>
    </message>
    <message>
        <source>Time shown. Type a time to look back, e.g. 1215Z, or 3:20 since the start.</source>
        <translation>Heure affichée. Saisissez une heure pour y revenir, p. ex. 1215Z, ou 3:20 depuis le début.</translation>
    </message>
    <message>
        <source>End of the run</source>
        <translation>Fin du vol</translation>
    </message>
</context>
<context>
    <name>berg::PolicyCombo</name>
    <message>
        <source>%1 %…</source>
        <translation>%1 %…</translation>
    </message>
    <message>
        <source>takes too long</source>
        <translation>prend trop de temps</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>choisie</translation>
    </message>
    <message>
        <source>ζ not predicted: takes too long</source>
        <translation>ζ non prévu : prend trop de temps</translation>
    </message>
    <message>
        <source>Predicting ζ…</source>
        <translation>Prévision de ζ…</translation>
    </message>
    <message>
        <source>Predicted before take-off: ζ %1</source>
        <translation>Prévu avant le décollage : ζ %1</translation>
    </message>
    <message>
        <source>Predicted ζ %1</source>
        <translation>ζ prévu %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Recommended</source>
        <translation>Recommandée</translation>
    </message>
    <message>
        <source>%1; too slow to compare: %2</source>
        <translation>%1 ; trop lente pour être comparée : %2</translation>
    </message>
    <message>
        <source>Not predicted: flying it %1 times in advance takes more than %2.</source>
        <translation>Non prévu : le jouer %1 fois à l&apos;avance prend plus de %2.</translation>
    </message>
    <message>
        <source>ζ is predicted before take-off by flying the mission %1 times with each policy, with drift
and sightings drawn as the scenario describes them, in the same %1 worlds: ζ is the mean of
these flights, the range that of 90 % of them. A policy is recommended if its ζ is surely lower
than that of every other one (95 % interval of the differences in the same worlds).</source>
        <translation>ζ est prévu avant le décollage en jouant la mission %1 fois avec chaque stratégie, avec une dérive
et des observations tirées comme le scénario les décrit, dans les mêmes %1 mondes : ζ est la moyenne de
ces vols, l&apos;intervalle celui de 90 % d&apos;entre eux. Une stratégie est recommandée si son ζ est à coup sûr
inférieur à celui de toutes les autres (intervalle à 95 % des différences dans les mêmes mondes).</translation>
    </message>
    <message>
        <source>Predicting ζ: %1 %</source>
        <translation>Prévision de ζ : %1 %</translation>
    </message>
    <message>
        <source>No ζ to predict: there is no iceberg out of view.</source>
        <translation>Pas de ζ à prévoir : aucun iceberg n&apos;est hors de vue.</translation>
    </message>
    <message>
        <source>%1; no policy is a clear winner</source>
        <translation>%1 ; aucune stratégie ne l&apos;emporte nettement</translation>
    </message>
    <message>
        <source>%1; recommended</source>
        <translation>%1 ; recommandée</translation>
    </message>
    <message>
        <source>%1; recommended: %2</source>
        <translation>%1 ; recommandée : %2</translation>
    </message>
</context>
<context>
    <name>berg::PreferenceMenus</name>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Apparence</translation>
    </message>
    <message>
        <source>U&amp;nits</source>
        <translation>&amp;Unités</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Suivre le système</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>&amp;Distances</source>
        <translation>&amp;Distances</translation>
    </message>
    <message>
        <source>Metres and kilometres</source>
        <translation>Mètres et kilomètres</translation>
    </message>
    <message>
        <source>Nautical miles</source>
        <translation>Milles marins</translation>
    </message>
    <message>
        <source>&amp;Speeds</source>
        <translation>&amp;Vitesses</translation>
    </message>
    <message>
        <source>Metres per second</source>
        <translation>Mètres par seconde</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>Nœuds</translation>
    </message>
    <message>
        <source>&amp;Coordinates</source>
        <translation>&amp;Coordonnées</translation>
    </message>
    <message>
        <source>Degrees and minutes, %1</source>
        <translation>Degrés et minutes, %1</translation>
    </message>
    <message>
        <source>Decimal degrees, %1</source>
        <translation>Degrés décimaux, %1</translation>
    </message>
    <message>
        <source>Degrees, minutes, seconds, %1</source>
        <translation>Degrés, minutes, secondes, %1</translation>
    </message>
    <message>
        <source>Speed and direction: wind from, drift towards</source>
        <translation>Vitesse et direction : d&apos;où vient le vent, vers où va la dérive</translation>
    </message>
    <message>
        <source>Components east and north</source>
        <translation>Composantes est et nord</translation>
    </message>
    <message>
        <source>Drift and &amp;wind</source>
        <translation>Dérive et v&amp;ent</translation>
    </message>
    <message>
        <source>Text si&amp;ze</source>
        <translation>Taille du te&amp;xte</translation>
    </message>
    <message>
        <source>High contrast, light</source>
        <translation>Contraste élevé, clair</translation>
    </message>
    <message>
        <source>High contrast, dark</source>
        <translation>Contraste élevé, sombre</translation>
    </message>
    <message>
        <source>Restart Bergwatch to apply the new text size.</source>
        <translation>Redémarrez Bergwatch pour appliquer la nouvelle taille du texte.</translation>
    </message>
    <message>
        <source>Night (red)</source>
        <translation>Nuit (rouge)</translation>
    </message>
    <message>
        <source>Automatic, from the scenario</source>
        <translation>Automatique, selon le scénario</translation>
    </message>
    <message>
        <source>Ends at %1 m²</source>
        <translation>Jusqu&apos;à %1 m²</translation>
    </message>
    <message>
        <source>&amp;Heights</source>
        <translation>&amp;Hauteurs</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Mètres</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pieds</translation>
    </message>
    <message>
        <source>C&amp;ourses</source>
        <translation>&amp;Routes</translation>
    </message>
    <message>
        <source>&amp;Times</source>
        <translation>He&amp;ures</translation>
    </message>
    <message>
        <source>UTC, if the scenario has a start time</source>
        <translation>UTC, si le scénario a une heure de début</translation>
    </message>
    <message>
        <source>Elapsed since the start</source>
        <translation>Temps écoulé depuis le début</translation>
    </message>
    <message>
        <source>&amp;Uncertainty</source>
        <translation>&amp;Incertitude</translation>
    </message>
    <message>
        <source>σ first, 95 % radius beside it</source>
        <translation>σ d&apos;abord, rayon à 95 % à côté</translation>
    </message>
    <message>
        <source>95 % radius first, σ beside it</source>
        <translation>Rayon à 95 % d&apos;abord, σ à côté</translation>
    </message>
    <message>
        <source>True</source>
        <translation>Vraies</translation>
    </message>
    <message>
        <source>True and magnetic, by the World Magnetic Model 2025</source>
        <translation>Vraies et magnétiques, selon le World Magnetic Model 2025</translation>
    </message>
    <message>
        <source>True and magnetic, declination %1...</source>
        <translation>Vraies et magnétiques, déclinaison %1…</translation>
    </message>
    <message>
        <source>True and magnetic, declination entered by hand...</source>
        <translation>Vraies et magnétiques, déclinaison saisie…</translation>
    </message>
</context>
<context>
    <name>berg::RecentRow</name>
    <message>
        <source>The file is gone</source>
        <translation>Le fichier a disparu</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Remove it from this list.</source>
        <translation>Retirer de cette liste.</translation>
    </message>
</context>
<context>
    <name>berg::RecoveryDialog</name>
    <message>
        <source>Recovered work</source>
        <translation>Travail récupéré</translation>
    </message>
    <message>
        <source>Bergwatch ended unexpectedly. Unsaved changes were kept. Restore them, and then save them.</source>
        <translation>Bergwatch s&apos;est terminé de façon inattendue. Les modifications non enregistrées ont été conservées. Restaurez-les, puis enregistrez-les.</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Restaurer</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Abandonner</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Plus tard</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modification</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>pas encore enregistré</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
</context>
<context>
    <name>berg::ResultFiles</name>
    <message>
        <source>Runs (*.bergrun);;All files (*)</source>
        <translation>Vols (*.bergrun);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message numerus="yes">
        <source>%n files with these names exist. Their content would be lost.</source>
        <translation>
            <numerusform>%n fichier de ce nom existe. Son contenu serait perdu.</numerusform>
            <numerusform>%n fichiers de ces noms existent. Leur contenu serait perdu.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 exporté</translation>
    </message>
    <message numerus="yes">
        <source>Exported %n files</source>
        <translation>
            <numerusform>%n fichier exporté</numerusform>
            <numerusform>%n fichiers exportés</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture of the map copied</source>
        <translation>Image de la carte copiée</translation>
    </message>
    <message>
        <source>The run is saved as soon as the current plan is made.</source>
        <translation>Le vol sera enregistré dès que le plan en cours sera établi.</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Enregistrement de %1</translation>
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
        <translation>Vols</translation>
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
        <translation>Vol</translation>
    </message>
    <message>
        <source>ζ, m² s</source>
        <translation>ζ, m² s</translation>
    </message>
    <message>
        <source>vs A</source>
        <translation>Écart à A</translation>
    </message>
    <message>
        <source>The reference: click a circle, or press A.</source>
        <translation>La référence : cliquez sur un cercle ou appuyez sur A.</translation>
    </message>
    <message>
        <source>Compared with it: click a circle, or press B.</source>
        <translation>Comparé à elle : cliquez sur un cercle ou appuyez sur B.</translation>
    </message>
    <message>
        <source>Zeta compared with that of A at the time both have flown.</source>
        <translation>Zêta comparé à celui de A au dernier instant que les deux vols ont atteint.</translation>
    </message>
    <message>
        <source>Flown runs are listed here. The button below flies this scenario along the shortest round tour for comparison.</source>
        <translation>Les vols effectués apparaissent ici. Le bouton ci-dessous joue ce scénario le long du plus court circuit, pour comparaison.</translation>
    </message>
    <message>
        <source>Its scenario differs from that of A: they cannot be compared.</source>
        <translation>Son scénario diffère de celui de A : ils ne peuvent pas être comparés.</translation>
    </message>
    <message>
        <source>Make this run the reference A</source>
        <translation>Faire de ce vol la référence A</translation>
    </message>
    <message>
        <source>Compare this run with A</source>
        <translation>Comparer ce vol avec A</translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>un drone</numerusform>
            <numerusform>%n drones</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
</context>
<context>
    <name>berg::RunTimeLine</name>
    <message>
        <source>%1: point of no return; a later return uses the reserve</source>
        <translation>%1 : point de non-retour ; un retour plus tardif utilise la réserve</translation>
    </message>
</context>
<context>
    <name>berg::ScenarioDialogs</name>
    <message numerus="yes">
        <source>Generate %n icebergs</source>
        <translation>
            <numerusform>Générer un iceberg</numerusform>
            <numerusform>Générer %n icebergs</numerusform>
        </translation>
    </message>
    <message>
        <source>Move scenario</source>
        <translation>Déplacer le scénario</translation>
    </message>
    <message>
        <source>Place the new scenario</source>
        <translation>Placer le nouveau scénario</translation>
    </message>
    <message>
        <source>A forecast cannot be imported in flight. Stop the flight before importing.</source>
        <translation>Une prévision ne peut pas être importée en vol. Arrêtez le vol avant d&apos;importer.</translation>
    </message>
    <message>
        <source>Forecasts: NetCDF, GRIB, JSON (*.nc *.nc4 *.cdf *.grib *.grib2 *.grb *.grb2 *.json);;All files (*)</source>
        <translation>Prévisions : NetCDF, GRIB, JSON (*.nc *.nc4 *.cdf *.grib *.grib2 *.grb *.grb2 *.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Import forecast</source>
        <translation>Importer une prévision</translation>
    </message>
    <message>
        <source>Remove forecast</source>
        <translation>Supprimer la prévision</translation>
    </message>
</context>
<context>
    <name>berg::ScenarioFiles</name>
    <message>
        <source>Scenarios (*.berg);;All files (*)</source>
        <translation>Scénarios (*.berg);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Another Bergwatch</source>
        <translation>Un autre Bergwatch</translation>
    </message>
    <message>
        <source>Bergwatch, process %1 on %2</source>
        <translation>Bergwatch, processus %1 sur %2</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>New scenario</source>
        <translation>Nouveau scénario</translation>
    </message>
    <message>
        <source>Opened a copy of %1</source>
        <translation>Copie de %1 ouverte</translation>
    </message>
    <message>
        <source>Another program has changed it since you opened it. Those changes would be lost.</source>
        <translation>Un autre programme l&apos;a modifié depuis que vous l&apos;avez ouvert. Ces modifications seraient perdues.</translation>
    </message>
    <message>
        <source>%1 has it open. Changes saved there would be lost.</source>
        <translation>%1 l&apos;a ouvert. Les modifications qui y sont enregistrées seraient perdues.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message>
        <source>Saved %1; a backup copy cannot be written to its folder</source>
        <translation>%1 enregistré ; une copie de sauvegarde ne peut pas être écrite dans son dossier</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Aucun fichier pour l&apos;instant</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>Scenarios, runs, studies and telemetry logs (*.berg *.bergrun *.bergstudy *.tlog);;All files (*)</source>
        <translation>Scénarios, vols, études et journaux de télémétrie (*.berg *.bergrun *.bergstudy *.tlog);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>berg::ShipRows</name>
    <message>
        <source>Ship that the asset follows</source>
        <translation>Navire que suit le bien protégé</translation>
    </message>
    <message>
        <source>The asset follows no ship</source>
        <translation>Le bien protégé ne suit aucun navire</translation>
    </message>
    <message>
        <source>Ship with launch and home</source>
        <translation>Navire portant le départ et la base</translation>
    </message>
    <message>
        <source>Launch and home of the UAVs move with the ship, in the simulation and in uploads. The autopilot&apos;s own home stays where it took off.</source>
        <translation>Le départ et la base des drones se déplacent avec le navire, dans la simulation et dans les envois. La base propre à l&apos;autopilote reste au lieu de son décollage.</translation>
    </message>
    <message>
        <source>Launch and home are not on a ship</source>
        <translation>Le départ et la base ne sont pas sur un navire</translation>
    </message>
    <message>
        <source>The asset follows %1</source>
        <translation>Le bien protégé suit %1</translation>
    </message>
    <message>
        <source>Launch and home are on %1</source>
        <translation>Le départ et la base sont sur %1</translation>
    </message>
</context>
<context>
    <name>berg::SightingsImport</name>
    <message numerus="yes">
        <source>Import %n icebergs from %1</source>
        <translation>
            <numerusform>Importer %n iceberg de %1</numerusform>
            <numerusform>Importer %n icebergs de %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Imported %n icebergs from %1</source>
        <translation>
            <numerusform>%n iceberg importé de %1</numerusform>
            <numerusform>%n icebergs importés de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Import airspace from %1</source>
        <translation>Importer l&apos;espace aérien de %1</translation>
    </message>
    <message numerus="yes">
        <source>Airspace of %1: %n areas added, %2 already present, %3 farther than 100 km, %4 left out</source>
        <translation>
            <numerusform>Espace aérien de %1 : %n zone ajoutée, %2 déjà présentes, %3 à plus de 100 km, %4 omises</numerusform>
            <numerusform>Espace aérien de %1 : %n zones ajoutées, %2 déjà présentes, %3 à plus de 100 km, %4 omises</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n areas: a scenario can have at most %1</source>
        <translation>
            <numerusform>%n zone : un scénario peut en avoir %1 au plus</numerusform>
            <numerusform>%n zones : un scénario peut en avoir %1 au plus</numerusform>
        </translation>
    </message>
    <message>
        <source>Airspace cannot be imported in flight. Stop the flight before importing.</source>
        <translation>L&apos;espace aérien ne peut pas être importé en vol. Arrêtez le vol avant d&apos;importer.</translation>
    </message>
    <message>
        <source>Clipboard</source>
        <translation>Presse-papiers</translation>
    </message>
    <message>
        <source>The flight has continued in the meantime, so nothing was reported.</source>
        <translation>Le vol a continué entre-temps, donc rien n&apos;a été signalé.</translation>
    </message>
    <message numerus="yes">
        <source>Reported %n icebergs from %1</source>
        <translation>
            <numerusform>%n iceberg de %1 signalé</numerusform>
            <numerusform>%n icebergs de %1 signalés</numerusform>
        </translation>
    </message>
    <message>
        <source>Airspace left out or changed</source>
        <translation>Espace aérien omis ou modifié</translation>
    </message>
    <message>
        <source>Sightings (*.csv *.txt *.geojson *.json *.kml *.kmz *.czml *.gpx *.plan *.waypoints *.nmea *.jpg *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;All files (*)</source>
        <translation>Observations (*.csv *.txt *.geojson *.json *.kml *.kmz *.czml *.gpx *.plan *.waypoints *.nmea *.jpg *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Airspace (*.txt *.openair *.air *.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.zip);;All files (*)</source>
        <translation>Espace aérien (*.txt *.openair *.air *.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.zip);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Ice charts (*.shp *.zip *.gpkg *.gml *.fgb *.e00 *.geojson *.json);;All files (*)</source>
        <translation>Cartes des glaces (*.shp *.zip *.gpkg *.gml *.fgb *.e00 *.geojson *.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Ice charts cannot be imported in flight. Stop the flight before importing.</source>
        <translation>Une carte des glaces ne peut pas être importée en vol. Arrêtez le vol avant d&apos;importer.</translation>
    </message>
    <message>
        <source>Import ice chart from %1</source>
        <translation>Importer la carte des glaces de %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnue</translation>
    </message>
    <message numerus="yes">
        <source>Ice chart of %1: %n areas, date %2, %3 left out or far away</source>
        <translation>
            <numerusform>Carte des glaces de %1 : %n zone, date %2, %3 omises ou éloignées</numerusform>
            <numerusform>Carte des glaces de %1 : %n zones, date %2, %3 omises ou éloignées</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::SolveTimeChart</name>
    <message>
        <source>Solution time against the number of icebergs</source>
        <translation>Temps de résolution selon le nombre d&apos;icebergs</translation>
    </message>
    <message>
        <source>Solution time</source>
        <translation>Temps de résolution</translation>
    </message>
    <message>
        <source>Time for one plan, logarithmic</source>
        <translation>Temps pour un plan, échelle logarithmique</translation>
    </message>
    <message>
        <source>Line: median. Dashed: worst. Hollow: some were cut short.</source>
        <translation>Trait plein : médiane. Tirets : pire. Symbole creux : certains calculs interrompus.</translation>
    </message>
    <message>
        <source>Number of icebergs</source>
        <translation>Nombre d&apos;icebergs</translation>
    </message>
    <message>
        <source>CPLEX, worst (paper)</source>
        <translation>CPLEX, pire (article)</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n icebergs</source>
        <translation>
            <numerusform>%1, %n iceberg</numerusform>
            <numerusform>%1, %n icebergs</numerusform>
        </translation>
    </message>
    <message>
        <source>median %1, worst %2</source>
        <translation>médiane %1, pire %2</translation>
    </message>
    <message>
        <source>average %1, worst %2</source>
        <translation>moyenne %1, pire %2</translation>
    </message>
    <message>
        <source>proven: %1 of %2</source>
        <translation>prouvés : %1 sur %2</translation>
    </message>
</context>
<context>
    <name>berg::SolveTimePanel</name>
    <message>
        <source>Proves the optimum by dynamic programming or by the bound of Bergwatch&apos;s engine.</source>
        <translation>Prouve l&apos;optimum par programmation dynamique ou par la borne du solveur de Bergwatch.</translation>
    </message>
    <message>
        <source>Searches, and proves as much as about a second of work allows.</source>
        <translation>Cherche, et prouve autant que le permet environ une seconde de calcul.</translation>
    </message>
    <message>
        <source>COIN-OR CBC on a MILP with a variable for each leg and position. Independent of Bergwatch&apos;s engine.</source>
        <translation>COIN-OR CBC sur un MILP avec une variable pour chaque segment et chaque rang. Indépendant du solveur de Bergwatch.</translation>
    </message>
    <message>
        <source>COIN-OR CBC on the MILP as the paper prints it. Slow beyond 8 icebergs.</source>
        <translation>COIN-OR CBC sur le MILP tel que l&apos;article l&apos;imprime. Lent au-delà de 8 icebergs.</translation>
    </message>
    <message>
        <source>COIN-OR CBC on the few legs that the bound of Bergwatch&apos;s engine leaves.</source>
        <translation>COIN-OR CBC sur les quelques segments que laisse la borne du solveur de Bergwatch.</translation>
    </message>
    <message>
        <source>Icebergs, up to</source>
        <translation>Icebergs, jusqu&apos;à</translation>
    </message>
    <message>
        <source>Largest number of icebergs. The paper went to 20.</source>
        <translation>Plus grand nombre d&apos;icebergs. L&apos;article allait jusqu&apos;à 20.</translation>
    </message>
    <message>
        <source>Problems of each size</source>
        <translation>Problèmes de chaque taille</translation>
    </message>
    <message>
        <source>Random problems as in Table 1 of the paper, the same at every run.</source>
        <translation>Problèmes aléatoires comme au tableau 1 de l&apos;article, les mêmes à chaque fois.</translation>
    </message>
    <message>
        <source>Total time limit</source>
        <translation>Limite de temps totale</translation>
    </message>
    <message>
        <source>A solver that does not finish a size skips the larger ones.</source>
        <translation>Un solveur qui ne termine pas une taille saute les plus grandes.</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Progression de la mesure</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>Enregistrer en CSV…</translation>
    </message>
    <message>
        <source>Saves the measured times as a table.</source>
        <translation>Enregistre les temps mesurés sous forme de tableau.</translation>
    </message>
    <message>
        <source>Measuring, about %1 left</source>
        <translation>Mesure en cours, environ %1 restant</translation>
    </message>
    <message>
        <source>Start measures this machine on the problems of the paper, for comparison with the paper&apos;s times.</source>
        <translation>« Démarrer » mesure cette machine sur les problèmes de l&apos;article, pour comparaison avec les temps de l&apos;article.</translation>
    </message>
    <message>
        <source>Measured in %1.</source>
        <translation>Mesuré en %1.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Choose a solver first.</source>
        <translation>Choisissez d&apos;abord un solveur.</translation>
    </message>
    <message>
        <source>Stopped. The times measured so far are kept.</source>
        <translation>Arrêté. Les temps mesurés jusqu&apos;ici sont gardés.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
</context>
<context>
    <name>berg::StartChart</name>
    <message>
        <source>Zeta by start time</source>
        <translation>Zêta selon l&apos;heure de départ</translation>
    </message>
    <message>
        <source>Press Compare to fly the scenario from each start time.</source>
        <translation>Appuyez sur Comparer pour voler le scénario à partir de chaque heure de départ.</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>Comparaison…</translation>
    </message>
</context>
<context>
    <name>berg::StartPage</name>
    <message>
        <source>Keep watch over drifting icebergs.</source>
        <translation>Surveillez les icebergs à la dérive.</translation>
    </message>
    <message>
        <source>Continue with %1</source>
        <translation>Continuer avec %1</translation>
    </message>
    <message>
        <source>New scenario</source>
        <translation>Nouveau scénario</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>New here? Take the tour, three steps</source>
        <translation>Première utilisation ? Suivez la visite, en trois étapes</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>Show this page at the start</source>
        <translation>Afficher cette page au démarrage</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Aucun fichier pour l&apos;instant</translation>
    </message>
    <message>
        <source>Import sightings...</source>
        <translation>Importer des observations…</translation>
    </message>
</context>
<context>
    <name>berg::StartPageController</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>1. Place icebergs</source>
        <translation>1. Placez des icebergs</translation>
    </message>
    <message>
        <source>2. Drag τ</source>
        <translation>2. Glissez τ</translation>
    </message>
    <message>
        <source>Drag left to visit the most uncertain icebergs first, right for a shorter route. Ticks mark where another order becomes optimal.</source>
        <translation>Faites glisser vers la gauche pour visiter d&apos;abord les icebergs les plus incertains, vers la droite pour une route plus courte. Les repères indiquent où un autre ordre devient optimal.</translation>
    </message>
    <message>
        <source>3. Press Space</source>
        <translation>3. Appuyez sur Espace</translation>
    </message>
    <message>
        <source>Press Space to fly and to pause. Drag the time line to look back. Stop and edit returns to the start.</source>
        <translation>Appuyez sur Espace pour lancer le vol et le mettre en pause. Faites glisser la ligne de temps pour revenir en arrière. « Arrêter et modifier » revient au début.</translation>
    </message>
    <message>
        <source>After this tour, press I and click on the map to place an iceberg. Drag it to move it, double-click it to set its drift and the uncertainty of its position. The plan follows at once.</source>
        <translation>Après cette visite, appuyez sur I et cliquez sur la carte pour placer un iceberg. Faites-le glisser pour le déplacer, double-cliquez dessus pour régler sa dérive et l&apos;incertitude de sa position. Le plan suit aussitôt.</translation>
    </message>
</context>
<context>
    <name>berg::StartPanel</name>
    <message>
        <source>Starts within</source>
        <translation>Départs dans</translation>
    </message>
    <message>
        <source>Latest start after the start of the scenario</source>
        <translation>Dernier départ après celui du scénario</translation>
    </message>
    <message>
        <source>One every</source>
        <translation>Un tous les</translation>
    </message>
    <message>
        <source>Progress of the comparison</source>
        <translation>Avancement de la comparaison</translation>
    </message>
    <message>
        <source>Use this start</source>
        <translation>Utiliser ce départ</translation>
    </message>
    <message>
        <source>cannot be flown</source>
        <translation>ne peut pas être volé</translation>
    </message>
    <message>
        <source>%1 UTC: ζ %2. %3</source>
        <comment>start, zeta, weather</comment>
        <translation>%1 UTC : ζ %2. %3</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Flying the scenario from each start…</source>
        <translation>Vol du scénario à partir de chaque départ…</translation>
    </message>
    <message>
        <source>Flying the scenario from each start: %1 of %2</source>
        <comment>starts done, all</comment>
        <translation>Vol du scénario à partir de chaque départ : %1 sur %2</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>The scenario has no start time. Set Start (UTC) in the Inspector.</source>
        <translation>Le scénario n&apos;a pas d&apos;heure de départ. Indiquez Début (UTC) dans Propriétés.</translation>
    </message>
    <message>
        <source>Icebergs drift on unseen until a later start, so their estimates are older.</source>
        <translation>Les icebergs dérivent sans être vus jusqu&apos;à un départ ultérieur, leurs estimations sont donc plus anciennes.</translation>
    </message>
    <message>
        <source>The scenario has changed since. Compare again.</source>
        <translation>Le scénario a changé depuis. Comparez à nouveau.</translation>
    </message>
    <message>
        <source>No start has weather within all limits. Choose a bar to see why.</source>
        <translation>Aucun départ n&apos;a une météo dans toutes les limites. Choisissez une barre pour voir pourquoi.</translation>
    </message>
    <message>
        <source>Start at %1 UTC</source>
        <translation>Départ à %1 UTC</translation>
    </message>
</context>
<context>
    <name>berg::StatusLine</name>
    <message>
        <source>Shows the findings about the scenario.</source>
        <translation>Affiche les constats sur le scénario.</translation>
    </message>
    <message>
        <source>%1   %2 E  %3 N</source>
        <comment>place, east and north of the origin</comment>
        <translation>%1   %2 E  %3 N</translation>
    </message>
    <message>
        <source>Cursor: %1</source>
        <translation>Pointeur : %1</translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation>État : %1</translation>
    </message>
    <message>
        <source>Not changed: %1</source>
        <translation>Non modifié : %1</translation>
    </message>
</context>
<context>
    <name>berg::StudyChart</name>
    <message>
        <source>Choose what to fly and press Start, or load a figure from the paper.</source>
        <translation>Choisissez ce qui doit être joué et appuyez sur « Démarrer l&apos;étude », ou prenez une figure de l&apos;article.</translation>
    </message>
    <message>
        <source>This chart compares each setting with a reference, case by case.</source>
        <translation>Ce graphique compare chaque réglage à une référence, cas par cas.</translation>
    </message>
    <message numerus="yes">
        <source>%n cases</source>
        <translation>
            <numerusform>%n cas</numerusform>
            <numerusform>%n cas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>name of a study, how many cases</comment>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>berg::StudyController</name>
    <message>
        <source>Studies (*.bergstudy);;All files (*)</source>
        <translation>Études (*.bergstudy);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Studies and their reports (*.bergstudy *.json *.html);;All files (*)</source>
        <translation>Études et leurs rapports (*.bergstudy *.json *.html);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Reports (*.html);;All files (*)</source>
        <translation>Rapports (*.html);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tableaux (*.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message>
        <source>Bergwatch ended unexpectedly. This unsaved study was kept. Save it, or fly the rest.</source>
        <translation>Bergwatch s&apos;est terminé de façon inattendue. Cette étude non enregistrée a été conservée. Enregistrez-la ou jouez le reste.</translation>
    </message>
    <message>
        <source>Autosaving failed: %1</source>
        <translation>Échec de l&apos;enregistrement automatique : %1</translation>
    </message>
    <message>
        <source>Study: %1</source>
        <translation>Étude : %1</translation>
    </message>
</context>
<context>
    <name>berg::StudyFlights</name>
    <message>
        <source>Fly as in the study</source>
        <translation>Jouer comme dans l&apos;étude</translation>
    </message>
    <message>
        <source>Flown as in the study, which is under View, Study.</source>
        <translation>Joué comme dans l&apos;étude, qui se trouve sous « Affichage », « Étude ».</translation>
    </message>
    <message>
        <source>Fly Figure 5 of the paper</source>
        <translation>Jouer la figure 5 de l&apos;article</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Utiliser %1</translation>
    </message>
    <message>
        <source>Planned with %1</source>
        <translation>Planifié avec %1</translation>
    </message>
</context>
<context>
    <name>berg::StudyPanel</name>
    <message>
        <source>As in the paper</source>
        <translation>Comme dans l&apos;article</translation>
    </message>
    <message>
        <source>Figure 3</source>
        <translation>Figure 3</translation>
    </message>
    <message>
        <source>Solution times by number of icebergs: opens the solve time study with the sizes of the paper.</source>
        <translation>Temps de résolution selon le nombre d&apos;icebergs : ouvre l&apos;étude des temps de résolution avec les tailles de l&apos;article.</translation>
    </message>
    <message>
        <source>Figure 4</source>
        <translation>Figure 4</translation>
    </message>
    <message>
        <source>Figure 5</source>
        <translation>Figure 5</translation>
    </message>
    <message>
        <source>ζ of this scenario for τ = 0, 0.1 … 4, and of the shortest path.</source>
        <translation>ζ de ce scénario pour τ = 0, 0,1 … 4, et du plus court chemin.</translation>
    </message>
    <message>
        <source>Two flights of this scenario over the map: with the τ of lowest ζ, and along the shortest path.</source>
        <translation>Deux vols de ce scénario sur la carte : avec le τ de plus faible ζ, et le long du plus court chemin.</translation>
    </message>
</context>
<context>
    <name>berg::StudyResults</name>
    <message>
        <source>Compared with</source>
        <translation>Comparé à</translation>
    </message>
    <message>
        <source>Reference that the other settings are compared with</source>
        <translation>Référence à laquelle les autres réglages sont comparés</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Opens a study to view or continue it.</source>
        <translation>Ouvre une étude pour la consulter ou la continuer.</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Saves the study with all flights so far, also while it is running.</source>
        <translation>Enregistre l&apos;étude avec tous les vols effectués, même pendant le calcul.</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Writes a page with pictures, scenarios, seeds, version and machine.</source>
        <translation>Écrit une page avec images, scénarios, graines, version et machine.</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tableau…</translation>
    </message>
    <message>
        <source>Saves the numbers of all settings as CSV.</source>
        <translation>Enregistre les valeurs de tous les réglages en CSV.</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Image…</translation>
    </message>
    <message>
        <source>Saves the picture in front (PNG, SVG, PDF).</source>
        <translation>Enregistre l&apos;image au premier plan (PNG, SVG, PDF).</translation>
    </message>
    <message>
        <source>ζ against τ</source>
        <translation>ζ selon τ</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Différences</translation>
    </message>
    <message>
        <source>Settings of the study</source>
        <translation>Réglages de l&apos;étude</translation>
    </message>
    <message>
        <source>Cases of the setting chosen</source>
        <translation>Cas du réglage choisi</translation>
    </message>
    <message>
        <source>Open this run</source>
        <translation>Ouvrir ce vol</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Cas</translation>
    </message>
    <message>
        <source>Cases of %1</source>
        <translation>Cas de %1</translation>
    </message>
    <message>
        <source>Repeats this case exactly and shows it on the map and the time line.</source>
        <translation>Répète exactement ce cas et le montre sur la carte et la ligne de temps.</translation>
    </message>
    <message>
        <source>Choose a point of the picture or a setting, then a case.</source>
        <translation>Choisissez un point de l&apos;image ou un réglage, puis un cas.</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Utiliser %1</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Utiliser</translation>
    </message>
    <message>
        <source>Plans the scenario on the map with this setting.</source>
        <translation>Planifie le scénario sur la carte avec ce réglage.</translation>
    </message>
    <message>
        <source>Choose a point of the picture or a setting.</source>
        <translation>Choisissez un point de l&apos;image ou un réglage.</translation>
    </message>
    <message>
        <source>Lowest ζ: %1. One case is too few for a recommendation: fly more of them.</source>
        <translation>ζ le plus bas : %1. Un seul cas ne suffit pas pour une recommandation : jouez-en d&apos;autres.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 de plus</translation>
    </message>
    <message numerus="yes">
        <source>No clear winner over %n cases. These settings may be the best: %1.</source>
        <translation>
            <numerusform>Aucun réglage ne l&apos;emporte nettement sur %n cas. Les meilleurs peuvent être : %1.</numerusform>
            <numerusform>Aucun réglage ne l&apos;emporte nettement sur %n cas. Les meilleurs peuvent être : %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Recommended: %1. Its ζ is %2 (95 %: %3 to %4) against %5, the closest other setting, over %n cases.</source>
        <translation>
            <numerusform>Recommandé : %1. Son ζ est %2 (95 % : %3 à %4) par rapport à %5, le réglage le plus proche, sur %n cas.</numerusform>
            <numerusform>Recommandé : %1. Son ζ est %2 (95 % : %3 à %4) par rapport à %5, le réglage le plus proche, sur %n cas.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::StudyRunBar</name>
    <message>
        <source>under a second</source>
        <translation>moins d&apos;une seconde</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>environ %1 s</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>environ %1 min</translation>
    </message>
    <message>
        <source>about %1 h</source>
        <translation>environ %1 h</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Flies the missing missions of the study shown.</source>
        <translation>Joue les missions qui manquent à l&apos;étude affichée.</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Progression de l&apos;étude</translation>
    </message>
    <message>
        <source>%1 missions, %2</source>
        <translation>%1 missions, %2</translation>
    </message>
    <message>
        <source>%1 missions flown.</source>
        <translation>%1 missions jouées.</translation>
    </message>
    <message>
        <source>%1 of %2 missions flown.</source>
        <translation>%1 missions jouées sur %2.</translation>
    </message>
    <message>
        <source>About %1 left.</source>
        <translation>Environ %1 restant.</translation>
    </message>
    <message>
        <source>The flights so far are kept.</source>
        <translation>Les vols effectués jusqu&apos;ici sont conservés.</translation>
    </message>
    <message>
        <source>Start study</source>
        <translation>Démarrer l&apos;étude</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
</context>
<context>
    <name>berg::StudySetup</name>
    <message>
        <source>This scenario</source>
        <translation>Ce scénario</translation>
    </message>
    <message>
        <source>Random scenarios</source>
        <translation>Scénarios aléatoires</translation>
    </message>
    <message>
        <source>Fields of icebergs as in Table 3 of the paper, one for each seed.</source>
        <translation>Champs d&apos;icebergs comme au tableau 3 de l&apos;article, un par graine.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Number of random scenarios.</source>
        <translation>Nombre de scénarios aléatoires.</translation>
    </message>
    <message>
        <source>First seed</source>
        <translation>Première graine</translation>
    </message>
    <message>
        <source>Further scenarios use the seeds that follow.</source>
        <translation>Les scénarios suivants utilisent les graines suivantes.</translation>
    </message>
    <message>
        <source>Icebergs</source>
        <translation>Icebergs</translation>
    </message>
    <message>
        <source>Number of icebergs in each random scenario.</source>
        <translation>Nombre d&apos;icebergs dans chaque scénario aléatoire.</translation>
    </message>
    <message>
        <source>Runs each</source>
        <translation>Vols par scénario</translation>
    </message>
    <message>
        <source>Flights of each scenario with different noise: the true drift is drawn again, identically for every setting.</source>
        <translation>Vols de chaque scénario avec un autre bruit : la dérive réelle est tirée de nouveau, la même pour chaque réglage.</translation>
    </message>
    <message>
        <source>τ from</source>
        <translation>τ de</translation>
    </message>
    <message>
        <source>Smallest trade-off τ.</source>
        <translation>Plus petit compromis τ.</translation>
    </message>
    <message>
        <source>to</source>
        <comment>largest tau</comment>
        <translation>à</translation>
    </message>
    <message>
        <source>Largest trade-off τ.</source>
        <translation>Plus grand compromis τ.</translation>
    </message>
    <message>
        <source>step</source>
        <comment>of tau</comment>
        <translation>pas</translation>
    </message>
    <message>
        <source>Step between two values of τ.</source>
        <translation>Pas entre deux valeurs de τ.</translation>
    </message>
    <message numerus="yes">
        <source>%n random scenarios</source>
        <translation>
            <numerusform>%n scénario aléatoire</numerusform>
            <numerusform>%n scénarios aléatoires</numerusform>
        </translation>
    </message>
    <message>
        <source>This scenario has no icebergs.</source>
        <translation>Ce scénario n&apos;a aucun iceberg.</translation>
    </message>
    <message>
        <source>The largest τ is below the smallest.</source>
        <translation>Le plus grand τ est inférieur au plus petit.</translation>
    </message>
    <message>
        <source>Too many values of τ. Choose a larger step.</source>
        <translation>Trop de valeurs de τ. Choisissez un pas plus grand.</translation>
    </message>
    <message>
        <source>Choose at least one policy.</source>
        <translation>Choisissez au moins une stratégie.</translation>
    </message>
    <message>
        <source>A study has at most %1 missions.</source>
        <translation>Une étude a au plus %1 missions.</translation>
    </message>
    <message>
        <source>Knowledge of the drift in random scenarios, and how icebergs are observed.</source>
        <translation>Connaissance de la dérive dans les scénarios aléatoires, et mode d&apos;observation des icebergs.</translation>
    </message>
    <message>
        <source>As published</source>
        <translation>Comme publié</translation>
    </message>
    <message>
        <source>Velocities are known, and an iceberg in view has no uncertainty.</source>
        <translation>Les vitesses sont connues, et un iceberg en vue n&apos;a aucune incertitude.</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>Measurements with noise, filtered for position and velocity.</source>
        <translation>Mesures bruitées, filtrées pour la position et la vitesse.</translation>
    </message>
    <message>
        <source>Unknown velocity</source>
        <translation>Vitesse inconnue</translation>
    </message>
    <message>
        <source>Measured; velocities are uncertain by 0.1 m/s along each axis.</source>
        <translation>Mesuré ; les vitesses sont incertaines de 0,1 m/s selon chaque axe.</translation>
    </message>
    <message>
        <source>Real drift</source>
        <translation>Dérive réelle</translation>
    </message>
    <message>
        <source>Measured; velocities are unknown and change, as observed for icebergs with beacons.</source>
        <translation>Mesuré ; les vitesses sont inconnues et changent, comme observé pour des icebergs équipés de balises.</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dérive</translation>
    </message>
</context>
<context>
    <name>berg::TauStrip</name>
    <message>
        <source>Plans along the trade-off τ</source>
        <translation>Plans selon le compromis τ</translation>
    </message>
    <message numerus="yes">
        <source>%n plans</source>
        <translation>
            <numerusform>%n plan</numerusform>
            <numerusform>%n plans</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. Present plan: %2</source>
        <translation>%1. Plan actuel : %2</translation>
    </message>
    <message>
        <source>The plans for every τ are being computed.</source>
        <translation>Les plans pour tous les τ sont en cours de calcul.</translation>
    </message>
</context>
<context>
    <name>berg::Tour</name>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
</context>
<context>
    <name>berg::TradeoffPanel</name>
    <message>
        <source>Trade-off τ</source>
        <translation>Compromis τ</translation>
    </message>
    <message>
        <source>Trade-off τ from most uncertain first to shortest path</source>
        <translation>Compromis τ, du plus incertain d&apos;abord au plus court chemin</translation>
    </message>
    <message>
        <source>Most uncertain first</source>
        <translation>Plus incertain d&apos;abord</translation>
    </message>
    <message>
        <source>Shortest path</source>
        <translation>Plus court chemin</translation>
    </message>
    <message>
        <source>Policy</source>
        <translation>Stratégie</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solveur</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Route</translation>
    </message>
    <message>
        <source>This build of Bergwatch does not include this solver.</source>
        <translation>Cette version de Bergwatch ne contient pas ce solveur.</translation>
    </message>
    <message>
        <source>The chosen policy does not use this.</source>
        <translation>La stratégie choisie ne l&apos;utilise pas.</translation>
    </message>
    <message>
        <source>Small: the most uncertain icebergs come first. Large: the path gets short. Arrow keys change τ by 0.01, Page keys by 0.25.</source>
        <translation>Petit : les icebergs les plus incertains viennent d&apos;abord. Grand : la route devient courte. Les flèches changent τ de 0,01, les touches Page de 0,25.</translation>
    </message>
    <message>
        <source>Trade-off τ from 0 to 100.</source>
        <translation>Compromis τ de 0 à 100.</translation>
    </message>
    <message>
        <source>Solver of the plan. Automatic proves small problems optimal and searches in large ones.</source>
        <translation>Solveur du plan. « Automatique » prouve l&apos;optimum des petits problèmes et fait une recherche dans les grands.</translation>
    </message>
    <message>
        <source>A one-way plan ends at the last iceberg; a round trip includes the return.</source>
        <translation>Un plan en aller simple se termine au dernier iceberg ; une boucle comprend le retour.</translation>
    </message>
    <message>
        <source>Locked while looking back. Choose Back to latest or Continue from here to change it.</source>
        <translation>Verrouillé pendant le retour en arrière. Choisissez Revenir au dernier instant ou Continuer d&apos;ici pour le modifier.</translation>
    </message>
</context>
<context>
    <name>berg::UnsavedWorkGuard</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>Autosaved %1</source>
        <translation>%1 enregistré automatiquement</translation>
    </message>
    <message>
        <source>Autosaving failed: %1</source>
        <translation>Échec de l&apos;enregistrement automatique : %1</translation>
    </message>
    <message>
        <source>Unsaved work of a program that ended unexpectedly cannot be read. It is kept in this file:
%1</source>
        <translation>Le travail non enregistré d&apos;un programme terminé de façon inattendue ne peut pas être lu. Il est conservé dans ce fichier :
%1</translation>
    </message>
    <message>
        <source>Restored, not saved yet</source>
        <translation>Restauré, pas encore enregistré</translation>
    </message>
    <message>
        <source>%1, in flight</source>
        <translation>%1, en vol</translation>
    </message>
    <message>
        <source>Reading unsaved work</source>
        <translation>Lecture du travail non enregistré</translation>
    </message>
</context>
<context>
    <name>berg::ValueTable</name>
    <message>
        <source>Show values as a table</source>
        <translation>Afficher les valeurs en tableau</translation>
    </message>
    <message>
        <source>Values: %1</source>
        <translation>Valeurs : %1</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
</context>
<context>
    <name>berg::WindDialog</name>
    <message>
        <source>Wind</source>
        <translation>Vent</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>&amp;Appliquer</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>&amp;Vitesse</translation>
    </message>
    <message>
        <source>Blows &amp;from</source>
        <translation>&amp;Souffle du</translation>
    </message>
    <message>
        <source>The UAV will make little headway in this wind.</source>
        <translation>Le drone progressera peu dans ce vent.</translation>
    </message>
    <message>
        <source>Must be below the UAV&apos;s airspeed (%1).</source>
        <translation>Doit être inférieur à la vitesse air du drone (%1).</translation>
    </message>
</context>
<context>
    <name>berg::Workspace</name>
    <message>
        <source>Change trade-off</source>
        <translation>Modifier le compromis</translation>
    </message>
    <message>
        <source>Change policy</source>
        <translation>Modifier la stratégie</translation>
    </message>
    <message>
        <source>Change solver</source>
        <translation>Modifier le solveur</translation>
    </message>
    <message>
        <source>Change route</source>
        <translation>Modifier la route</translation>
    </message>
    <message>
        <source>You are viewing an earlier instant. To change this, continue from here or go back to the latest.</source>
        <translation>Vous regardez un instant antérieur. Pour modifier cela, continuez d&apos;ici ou revenez au dernier instant.</translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation>Modifier le vent</translation>
    </message>
    <message>
        <source>Assign iceberg</source>
        <translation>Attribuer l&apos;iceberg</translation>
    </message>
    <message>
        <source>The scenario was changed before take-off: nothing was flown.</source>
        <translation>Le scénario a été modifié avant le décollage : aucun vol n&apos;a été effectué.</translation>
    </message>
    <message>
        <source>Restore flight</source>
        <translation>Rétablir le vol</translation>
    </message>
    <message>
        <source>Move UAVs to their aircraft</source>
        <translation>Déplacer les drones vers leurs aéronefs</translation>
    </message>
</context>
</TS>
