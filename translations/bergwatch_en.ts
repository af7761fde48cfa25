<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>AreaTool</name>
    <message numerus="yes">
        <source>A scenario has at most %n no-fly areas.</source>
        <translation>
            <numerusform>A scenario has at most %n no-fly area.</numerusform>
            <numerusform>A scenario has at most %n no-fly areas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>An area has at most %n corners.</source>
        <translation>
            <numerusform>An area has at most %n corner.</numerusform>
            <numerusform>An area has at most %n corners.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message numerus="yes">
        <source>Remove %n icebergs from this run?</source>
        <translation>
            <numerusform>Remove %n iceberg from this run?</numerusform>
            <numerusform>Remove %n icebergs from this run?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ErrorText</name>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… and %n more</numerusform>
            <numerusform>… and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportText</name>
    <message numerus="yes">
        <source>A file holds one UAV: %n files are written, named after the UAVs.</source>
        <translation>
            <numerusform>A file holds one UAV: %n file is written, named after the UAV.</numerusform>
            <numerusform>A file holds one UAV: %n files are written, named after the UAVs.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The path becomes %n waypoints close to it.</source>
        <translation>
            <numerusform>The path becomes %n waypoint close to it.</numerusform>
            <numerusform>The path becomes %n waypoints close to it.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs have no iceberg to visit.</source>
        <translation>
            <numerusform>%n UAV has no iceberg to visit.</numerusform>
            <numerusform>%n UAVs have no iceberg to visit.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FlightNotices</name>
    <message numerus="yes">
        <source>%1, and %n more</source>
        <translation>
            <numerusform>%1, and %n more</numerusform>
            <numerusform>%1, and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>HandleDrag</name>
    <message numerus="yes">
        <source>Change drift of %n icebergs</source>
        <translation>
            <numerusform>Change drift</numerusform>
            <numerusform>Change drift of %n icebergs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Drag gives all %n icebergs selected the same drift.</source>
        <translation>
            <numerusform>Drag sets the drift of the iceberg selected.</numerusform>
            <numerusform>Drag gives all %n icebergs selected the same drift.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ImportWords</name>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>%n UAV</numerusform>
            <numerusform>%n UAVs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n no-fly areas</source>
        <translation>
            <numerusform>%n no-fly area</numerusform>
            <numerusform>%n no-fly areas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs (too many)</source>
        <translation>
            <numerusform>%n UAV (too many)</numerusform>
            <numerusform>%n UAVs (too many)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs (more than 1000 km from the origin)</source>
        <translation>
            <numerusform>%n UAV (more than 1000 km from the origin)</numerusform>
            <numerusform>%n UAVs (more than 1000 km from the origin)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n further areas</source>
        <translation>
            <numerusform>%n further area</numerusform>
            <numerusform>%n further areas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes of the area</source>
        <translation>
            <numerusform>%n hole of the area</numerusform>
            <numerusform>%n holes of the area</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n circles of the geofence</source>
        <translation>
            <numerusform>%n circle of the geofence</numerusform>
            <numerusform>%n circles of the geofence</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n no-fly areas (a UAV starts or lands in them, or their heights are wrong)</source>
        <translation>
            <numerusform>%n no-fly area (a UAV starts or lands in it, or its heights are wrong)</numerusform>
            <numerusform>%n no-fly areas (a UAV starts or lands in them, or their heights are wrong)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rally points</source>
        <translation>
            <numerusform>%n rally point</numerusform>
            <numerusform>%n rally points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n further assets</source>
        <translation>
            <numerusform>%n further asset</numerusform>
            <numerusform>%n further assets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n numbers out of range</source>
        <translation>
            <numerusform>%n number out of range</numerusform>
            <numerusform>%n numbers out of range</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n new</source>
        <translation>
            <numerusform>%n new</numerusform>
            <numerusform>%n new</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n updated</source>
        <translation>
            <numerusform>%n updated</numerusform>
            <numerusform>%n updated</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unchanged</source>
        <translation>
            <numerusform>%n unchanged</numerusform>
            <numerusform>%n unchanged</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n left out</source>
        <translation>
            <numerusform>%n left out</numerusform>
            <numerusform>%n left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings outside the area</source>
        <translation>
            <numerusform>%n sighting outside the area</numerusform>
            <numerusform>%n sightings outside the area</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings outside the time</source>
        <translation>
            <numerusform>%n sighting outside the time</numerusform>
            <numerusform>%n sightings outside the time</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rows rejected</source>
        <translation>
            <numerusform>%n row rejected</numerusform>
            <numerusform>%n rows rejected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>InspectorRows</name>
    <message numerus="yes">
        <source>%n corners, %1</source>
        <translation>
            <numerusform>%n corner, %1</numerusform>
            <numerusform>%n corners, %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>IssueText</name>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hints</source>
        <translation>
            <numerusform>%n hint</numerusform>
            <numerusform>%n hints</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MapEdits</name>
    <message numerus="yes">
        <source>Delete %n objects</source>
        <translation>
            <numerusform>Delete %n object</numerusform>
            <numerusform>Delete %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n icebergs</source>
        <translation>
            <numerusform>Delete iceberg</numerusform>
            <numerusform>Delete %n icebergs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Cut %n icebergs</source>
        <translation>
            <numerusform>Cut iceberg</numerusform>
            <numerusform>Cut %n icebergs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Paste %n icebergs</source>
        <translation>
            <numerusform>Paste iceberg</numerusform>
            <numerusform>Paste %n icebergs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n icebergs</source>
        <translation>
            <numerusform>Duplicate iceberg</numerusform>
            <numerusform>Duplicate %n icebergs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n UAVs</source>
        <translation>
            <numerusform>Duplicate UAV</numerusform>
            <numerusform>Duplicate %n UAVs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A scenario holds at most %n UAVs.</source>
        <translation>
            <numerusform>A scenario holds at most %n UAV.</numerusform>
            <numerusform>A scenario holds at most %n UAVs.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A scenario holds at most %n icebergs.</source>
        <translation>
            <numerusform>A scenario holds at most %n iceberg.</numerusform>
            <numerusform>A scenario holds at most %n icebergs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MapTools</name>
    <message numerus="yes">
        <source>Move %n objects</source>
        <translation>
            <numerusform>Move %n object</numerusform>
            <numerusform>Move %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n icebergs</source>
        <translation>
            <numerusform>Move iceberg</numerusform>
            <numerusform>Move %n icebergs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MissionCharts</name>
    <message numerus="yes">
        <source>At %1 the most uncertain iceberg is %2: %3; %n in view.</source>
        <translation>
            <numerusform>At %1 the most uncertain iceberg is %2: %3; %n in view.</numerusform>
            <numerusform>At %1 the most uncertain iceberg is %2: %3; %n in view.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PlacingTools</name>
    <message numerus="yes">
        <source>A scenario holds at most %n icebergs.</source>
        <translation>
            <numerusform>A scenario holds at most %n iceberg.</numerusform>
            <numerusform>A scenario holds at most %n icebergs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PlanText</name>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>%n UAV</numerusform>
            <numerusform>%n UAVs</numerusform>
        </translation>
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
    <name>berg::AlarmStrip</name>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
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
    <name>berg::GenerateDialog</name>
    <message numerus="yes">
        <source>The scenario then holds %n icebergs.</source>
        <translation>
            <numerusform>The scenario then holds one iceberg.</numerusform>
            <numerusform>The scenario then holds %n icebergs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::InspectorPanel</name>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n iceberg</numerusform>
            <numerusform>%n icebergs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>%n UAV</numerusform>
            <numerusform>%n UAVs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::MapLinks</name>
    <message numerus="yes">
        <source>%n icebergs removed from this run. To undo that, look back to before it and choose Continue from here.</source>
        <translation>
            <numerusform>%n iceberg removed from this run. To undo that, look back to before it and choose Continue from here.</numerusform>
            <numerusform>%n icebergs removed from this run. To undo that, look back to before it and choose Continue from here.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::MapView</name>
    <message numerus="yes">
        <source>%n icebergs and the UAV on the sea. Arrow keys move the map or what is selected, plus and minus zoom, F fits. The table of icebergs has them in rows.</source>
        <translation>
            <numerusform>%n iceberg and the UAV on the sea. Arrow keys move the map or what is selected, plus and minus zoom, F fits. The table of icebergs has them in rows.</numerusform>
            <numerusform>%n icebergs and the UAV on the sea. Arrow keys move the map or what is selected, plus and minus zoom, F fits. The table of icebergs has them in rows.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::PlanModel</name>
    <message numerus="yes">
        <source>%n visits</source>
        <translation>
            <numerusform>%n visit</numerusform>
            <numerusform>%n visits</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::ResultFiles</name>
    <message numerus="yes">
        <source>%n files of these names are there. What is in them would be lost.</source>
        <translation>
            <numerusform>%n file of this name is there. What is in it would be lost.</numerusform>
            <numerusform>%n files of these names are there. What is in them would be lost.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Exported %n files</source>
        <translation>
            <numerusform>Exported %n file</numerusform>
            <numerusform>Exported %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::RunTable</name>
    <message numerus="yes">
        <source>%n UAVs</source>
        <translation>
            <numerusform>one UAV</numerusform>
            <numerusform>%n UAVs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::ScenarioDialogs</name>
    <message numerus="yes">
        <source>Generate %n icebergs</source>
        <translation>
            <numerusform>Generate iceberg</numerusform>
            <numerusform>Generate %n icebergs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::SightingsImport</name>
    <message numerus="yes">
        <source>Import %n icebergs from %1</source>
        <translation>
            <numerusform>Import %n iceberg from %1</numerusform>
            <numerusform>Import %n icebergs from %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Imported %n icebergs from %1</source>
        <translation>
            <numerusform>Imported %n iceberg from %1</numerusform>
            <numerusform>Imported %n icebergs from %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Airspace of %1: %n areas added, %2 there already, %3 farther than 100 km, %4 left out</source>
        <translation>
            <numerusform>Airspace of %1: %n area added, %2 there already, %3 farther than 100 km, %4 left out</numerusform>
            <numerusform>Airspace of %1: %n areas added, %2 there already, %3 farther than 100 km, %4 left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n areas: a scenario holds at most %1</source>
        <translation>
            <numerusform>%n area: a scenario holds at most %1</numerusform>
            <numerusform>%n areas: a scenario holds at most %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reported %n icebergs from %1</source>
        <translation>
            <numerusform>Reported %n iceberg from %1</numerusform>
            <numerusform>Reported %n icebergs from %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::SolveTimeChart</name>
    <message numerus="yes">
        <source>%1, %n icebergs</source>
        <translation>
            <numerusform>%1, %n iceberg</numerusform>
            <numerusform>%1, %n icebergs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::StudyPicture</name>
    <message numerus="yes">
        <source>%n cases</source>
        <translation>
            <numerusform>%n case</numerusform>
            <numerusform>%n cases</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::StudyResults</name>
    <message numerus="yes">
        <source>No clear winner over %n cases. These settings may be the best: %1.</source>
        <translation>
            <numerusform>No clear winner over %n case. These settings may be the best: %1.</numerusform>
            <numerusform>No clear winner over %n cases. These settings may be the best: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Recommended: %1. Its ζ is %2 (95 %: %3 to %4) against %5, the closest other setting, over %n cases.</source>
        <translation>
            <numerusform>Recommended: %1. Its ζ is %2 (95 %: %3 to %4) against %5, the closest other setting, over %n case.</numerusform>
            <numerusform>Recommended: %1. Its ζ is %2 (95 %: %3 to %4) against %5, the closest other setting, over %n cases.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::StudySetup</name>
    <message numerus="yes">
        <source>%n random scenarios</source>
        <translation>
            <numerusform>%n random scenario</numerusform>
            <numerusform>%n random scenarios</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::TauStrip</name>
    <message numerus="yes">
        <source>%n plans</source>
        <translation>
            <numerusform>%n plan</numerusform>
            <numerusform>%n plans</numerusform>
        </translation>
    </message>
</context>
</TS>
