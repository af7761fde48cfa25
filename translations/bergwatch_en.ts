<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
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
        <source>Drag to give all %n selected icebergs the same drift.</source>
        <translation>
            <numerusform>Drag to set the drift of the selected iceberg.</numerusform>
            <numerusform>Drag to give all %n selected icebergs the same drift.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ImportWords</name>
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
    <message numerus="yes">
        <source>%n rows changed</source>
        <translation>
            <numerusform>%n row changed</numerusform>
            <numerusform>%n rows changed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings are more than 1000 km from the origin of this scenario. Import them into a new one, or choose others with Inside.</source>
        <translation>
            <numerusform>%n sighting is more than 1000 km from the origin of this scenario. Import it into a new one, or choose others with Inside.</numerusform>
            <numerusform>%n sightings are more than 1000 km from the origin of this scenario. Import them into a new one, or choose others with Inside.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sightings are more than 1000 km from the origin, which is in their densest group. Choose others with Inside.</source>
        <translation>
            <numerusform>%n sighting is more than 1000 km from the origin, which is in their densest group. Choose others with Inside.</numerusform>
            <numerusform>%n sightings are more than 1000 km from the origin, which is in their densest group. Choose others with Inside.</numerusform>
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
    <message numerus="yes">
        <source>%n UAV(s) taken over</source>
        <translation>
            <numerusform>%n UAV taken over</numerusform>
            <numerusform>%n UAVs taken over</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n no-fly area(s) taken over</source>
        <translation>
            <numerusform>%n no-fly area taken over</numerusform>
            <numerusform>%n no-fly areas taken over</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n UAV(s) left out: too many</source>
        <translation>
            <numerusform>%n UAV left out: too many</numerusform>
            <numerusform>%n UAVs left out: too many</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n UAV(s) left out: more than 1000 km east, west, north or south of the origin</source>
        <translation>
            <numerusform>%n UAV left out: more than 1000 km east, west, north or south of the origin</numerusform>
            <numerusform>%n UAVs left out: more than 1000 km east, west, north or south of the origin</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n area(s) left out: unreadable</source>
        <translation>
            <numerusform>%n area left out: unreadable</numerusform>
            <numerusform>%n areas left out: unreadable</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n further area(s) left out</source>
        <translation>
            <numerusform>%n further area left out</numerusform>
            <numerusform>%n further areas left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s) of the area left out</source>
        <translation>
            <numerusform>%n hole of the area left out</numerusform>
            <numerusform>%n holes of the area left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n no-fly area(s) left out: a UAV starts or lands inside, or the heights are wrong</source>
        <translation>
            <numerusform>%n no-fly area left out: a UAV starts or lands inside, or the heights are wrong</numerusform>
            <numerusform>%n no-fly areas left out: a UAV starts or lands inside, or the heights are wrong</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rally point(s) left out</source>
        <translation>
            <numerusform>%n rally point left out</numerusform>
            <numerusform>%n rally points left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n further asset(s) left out</source>
        <translation>
            <numerusform>%n further asset left out</numerusform>
            <numerusform>%n further assets left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n number(s) out of range left out</source>
        <translation>
            <numerusform>%n number out of range left out</numerusform>
            <numerusform>%n numbers out of range left out</numerusform>
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
    <name>berg::ForecastDialog</name>
    <message numerus="yes">
        <source>%n places, the table is for the middle one</source>
        <translation>
            <numerusform>%n place, which the table is for</numerusform>
            <numerusform>%n places, the table is for the middle one</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n times, from %1 to %2</source>
        <translation>
            <numerusform>%n time, from %1 to %2</numerusform>
            <numerusform>%n times, from %1 to %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::GenerateDialog</name>
    <message numerus="yes">
        <source>The scenario will have %n icebergs.</source>
        <translation>
            <numerusform>The scenario will have one iceberg.</numerusform>
            <numerusform>The scenario will have %n icebergs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::ImportIdentityView</name>
    <message numerus="yes">
        <source>%n icebergs</source>
        <translation>
            <numerusform>%n iceberg</numerusform>
            <numerusform>%n icebergs</numerusform>
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
    <name>berg::MapController</name>
    <message numerus="yes">
        <source>%n icebergs removed from this run. Undo brings them back.</source>
        <translation>
            <numerusform>%n iceberg removed from this run. Undo brings it back.</numerusform>
            <numerusform>%n icebergs removed from this run. Undo brings them back.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>berg::MapView</name>
    <message numerus="yes">
        <source>%n icebergs and the UAVs on the sea. Arrow keys move the map or the selection, plus and minus zoom, F fits. The iceberg table lists the icebergs.</source>
        <translation>
            <numerusform>%n iceberg and the UAVs on the sea. Arrow keys move the map or the selection, plus and minus zoom, F fits. The iceberg table lists the iceberg.</numerusform>
            <numerusform>%n icebergs and the UAVs on the sea. Arrow keys move the map or the selection, plus and minus zoom, F fits. The iceberg table lists the icebergs.</numerusform>
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
        <source>%n files with these names exist. Their content would be lost.</source>
        <translation>
            <numerusform>%n file with this name exists. Its content would be lost.</numerusform>
            <numerusform>%n files with these names exist. Their content would be lost.</numerusform>
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
        <source>Airspace of %1: %n areas added, %2 already present, %3 farther than 100 km, %4 left out</source>
        <translation>
            <numerusform>Airspace of %1: %n area added, %2 already present, %3 farther than 100 km, %4 left out</numerusform>
            <numerusform>Airspace of %1: %n areas added, %2 already present, %3 farther than 100 km, %4 left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n areas: a scenario can have at most %1</source>
        <translation>
            <numerusform>%n area: a scenario can have at most %1</numerusform>
            <numerusform>%n areas: a scenario can have at most %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reported %n icebergs from %1</source>
        <translation>
            <numerusform>Reported %n iceberg from %1</numerusform>
            <numerusform>Reported %n icebergs from %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Ice chart of %1: %n areas, date %2, %3 left out or far away</source>
        <translation>
            <numerusform>Ice chart of %1: %n area, date %2, %3 left out or far away</numerusform>
            <numerusform>Ice chart of %1: %n areas, date %2, %3 left out or far away</numerusform>
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
    <name>berg::StudyChart</name>
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
