#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

using namespace berg;

/** Aircraft profiles in scenario files. */
class TestAircraftJson : public QObject
{
    Q_OBJECT

private slots:
    void everyFieldIsRead()
    {
        const std::string file = BERG_TEST_DATA "/scenarios/every-field.berg";
        const Scenario scenario = scenarioFromJson(readFile(file), file);
        const AircraftProfile expected{.firmware = AutopilotFirmware::Px4,
                                       .airframe = Airframe::Vtol,
                                       .takeOff = TakeOffMethod::Hand,
                                       .takeOffAltitude_m = 35,
                                       .takeOffPitch_deg = 12,
                                       .end = MissionEnd::Landing,
                                       .approach_m = 450,
                                       .approachAltitude_m = 30,
                                       .approachCourse_deg = 250,
                                       .loiterRadius_m = 150,
                                       .hoverSpeed_mps = 6.5,
                                       .speedItems = false,
                                       .camera = CameraTrigger::Time,
                                       .trigger_m = 25,
                                       .trigger_s = 1.5,
                                       .gimbalDown = true};
        QVERIFY(scenario.uavs[0].aircraft == expected);
        QVERIFY(scenario.uavs[1].aircraft == AircraftProfile());
    }

    /** Files of earlier versions are written byte for byte as before. */
    void defaultProfileIsNotWritten()
    {
        Scenario scenario = test::emptySea();
        const std::string text = scenarioToJson(scenario);
        for (const char* name :
             {"firmware", "airframe", "take_off", "mission_end", "approach", "loiter_radius",
              "hover_speed", "speed_items", "camera", "trigger", "gimbal"})
            QVERIFY2(text.find(name) == std::string::npos, name);
        for (const ReadyProfile& ready : readyProfiles()) {
            scenario.uavs[0].aircraft = ready.profile;
            const Scenario read = scenarioFromJson(scenarioToJson(scenario), "text");
            QVERIFY2(read.uavs[0].aircraft == ready.profile, ready.id.data());
        }
    }
};

QTEST_APPLESS_MAIN(TestAircraftJson)
#include "tst_aircraft_json.moc"
