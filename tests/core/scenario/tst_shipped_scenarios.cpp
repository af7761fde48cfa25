#include "core/checks/validate.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"

#include <QDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <vector>

using namespace berg;

namespace {

const QString kFolder = QStringLiteral(BERG_SOURCE_DIR "/resources/scenarios");

Scenario shipped(const char* name)
{
    return loadScenario(kFolder.toStdString() + '/' + name + ".berg");
}

/** The first minutes of its flight. */
Mission start(const char* name)
{
    Mission mission(shipped(name));
    mission.advance(300);
    return mission;
}

/** Velocities that are not known and change, as fitted to a beacon. */
bool hasFittedDrift(const Scenario& s)
{
    return s.observer.model == ObserverModel::Kalman &&
           std::ranges::all_of(s.icebergs, [](const Iceberg& iceberg) {
               return iceberg.velocitySd_mps == kFittedDrift.velocitySpread_mps &&
                      iceberg.velocitySpread_mps == kFittedDrift.velocitySpread_mps &&
                      iceberg.velocityTime_s == kFittedDrift.velocityTime_s;
           });
}

/** The feature that a shipped file demonstrates. */
struct Feature
{
    const char* file;
    std::size_t icebergs;
    bool (*shows)(const Scenario&);
};

constexpr std::array<Feature, 16> kFeatures = {{
    {"grand-banks-12", 12, [](const Scenario& s) { return s == defaultScenario(); }},
    {"disko-bay-4", 4,
     [](const Scenario& s) {
         return s.origin == LatLon{.latitude_deg = 69.2, .longitude_deg = -51.5};
     }},
    {"labrador-20", 20, [](const Scenario& s) { return s.wind_mps.isZero(0); }},
    {"scoresby-sund-40", 40, [](const Scenario& s) { return s.duration_s >= 3600; }},
    {"barents-wind", 12,
     [](const Scenario& s) { return s.wind_mps.norm() == 10 && !s.current_mps.isZero(0); }},
    {"hibernia-asset", 10,
     [](const Scenario& s) {
         return s.asset && s.origin == LatLon{.latitude_deg = 46.75, .longitude_deg = -48.78};
     }},
    {"melville-bay-three-uavs", 40,
     [](const Scenario& s) {
         return s.uavs.size() == 3 && s.uavs[1].spec.altitude_m >= s.uavs[0].spec.altitude_m + 30 &&
                s.uavs[2].spec.altitude_m >= s.uavs[1].spec.altitude_m + 30;
     }},
    {"svalbard-two-uavs", 16, [](const Scenario& s) { return s.uavs.size() == 2; }},
    {"fram-strait-endurance", 14,
     [](const Scenario& s) {
         return s.uavs[0].spec.endurance_s > 0 && s.uavs[0].spec.endurance_s < s.duration_s &&
                s.area_m.size() >= 3 && s.geofence;
     }},
    {"recorded-drift", 6,
     [](const Scenario& s) {
         return std::all_of(s.icebergs.begin(), s.icebergs.end(), [&](const Iceberg& iceberg) {
             return !iceberg.track.empty() && iceberg.track.time_s.back() >= s.duration_s;
         });
     }},
    {"flemish-pass-appearing", 12,
     [](const Scenario& s) {
         return s.icebergs.back().appears_s > 0 && s.icebergs.back().appears_s < s.duration_s &&
                s.icebergs[1].observed_s > 0;
     }},
    {"bonavista-lost", 10,
     [](const Scenario& s) {
         return s.observer.model == ObserverModel::Kalman && s.observer.detection < 1;
     }},
    {"upernavik-real-drift", 12, hasFittedDrift},
    {"baffin-bay-day", 6,
     [](const Scenario& s) { return s.duration_s == 86'400 && hasFittedDrift(s); }},
    {"twillingate-clusters", 17, [](const Scenario& s) { return s.clusters; }},
    {"jones-sound-late-plans", 12,
     [](const Scenario& s) { return s.planningTime_s > 0 && s.uavs[0].spec.autopilot_s > 0; }},
}};

} // namespace

class TestShippedScenarios : public QObject
{
    Q_OBJECT

private slots:
    void shippedFilesHaveHintsOnly_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t i = 0; i < kFeatures.size(); ++i)
            QTest::newRow(kFeatures[i].file) << static_cast<int>(i);
    }
    void shippedFilesHaveHintsOnly()
    {
        QFETCH(const int, row);
        const Feature& feature = kFeatures[static_cast<std::size_t>(row)];
        const Scenario s = shipped(feature.file);
        for (const Issue& issue : validate(s))
            QVERIFY2(issue.severity == Severity::Hint, (issue.field + issue.message()).c_str());
        QVERIFY(!s.name.empty());
        QCOMPARE(s.icebergs.size(), feature.icebergs);
        QVERIFY(feature.shows(s));
    }

    /** Some features show only in flight. */
    void flightsShowTheirEvents_data()
    {
        QTest::addColumn<QList<EventKind>>("kinds");
        const auto row = [](const char* file, const QList<EventKind>& kinds) {
            QTest::newRow(file) << kinds;
        };
        row("hibernia-asset", {EventKind::Alarm});
        row("flemish-pass-appearing", {EventKind::Appeared, EventKind::Left});
        row("bonavista-lost", {EventKind::Lost, EventKind::Found});
        row("fram-strait-endurance", {EventKind::HomeBound, EventKind::Landed, EventKind::TookOff});
    }
    void flightsShowTheirEvents()
    {
        QFETCH(const QList<EventKind>, kinds);
        Mission mission(shipped(QTest::currentDataTag()));
        mission.advance(mission.scenario().duration_s);
        for (const EventKind kind : kinds)
            QVERIFY2(std::any_of(mission.events().begin(), mission.events().end(),
                                 [kind](const MissionEvent& event) { return event.kind == kind; }),
                     std::to_string(static_cast<int>(kind)).c_str());
    }

    /** Icebergs are lost and found as they drift; a day is flown in less than a second. */
    void realDriftFlightsKeepTheirFigures_data()
    {
        QTest::addColumn<double>("zeta_m2s");
        QTest::addColumn<int>("visits");
        QTest::newRow("upernavik-real-drift") << 140'215'263.3 << 48;
        QTest::newRow("baffin-bay-day") << 7'570'453'409.3 << 368;
    }
    void realDriftFlightsKeepTheirFigures()
    {
        QFETCH(const double, zeta_m2s);
        QFETCH(const int, visits);
        Mission mission(shipped(QTest::currentDataTag()));
        mission.advance(mission.scenario().duration_s);
        COMPARE_NEAR(mission.metrics().zeta_m2s / zeta_m2s, 1, 1e-8);
        QCOMPARE(mission.metrics().visits, visits);
    }

    void clustersAreFlownTo()
    {
        const Mission mission = start("twillingate-clusters");
        QVERIFY(!mission.plans().front()->uavs[0].clusters.empty());
    }

    /** Each flies its own part, and no two are near one altitude. */
    void threeUavsFly()
    {
        const Mission mission = start("melville-bay-three-uavs");
        for (int uav = 0; uav < 3; ++uav)
            QVERIFY(std::ranges::any_of(mission.events(), [uav](const MissionEvent& event) {
                return event.kind == EventKind::Reached && event.uav == uav;
            }));
        QVERIFY(!mission.simulation().fleet().closest_m());
    }

    void plansComeLate()
    {
        const Mission mission = start("jones-sound-late-plans");
        QVERIFY(std::ranges::count(mission.plans(), true, &Plan::interim) > 0);
    }

    void allFilesAreListed()
    {
        const QStringList files = QDir(kFolder).entryList({"*.berg"}, QDir::Files);
        QCOMPARE(files.size(), static_cast<qsizetype>(kFeatures.size()));
    }

    /** So that opening and saving one of them changes nothing. */
    void filesAreInTheFormTheProgramWrites()
    {
        for (const Feature& feature : kFeatures) {
            const std::string path = kFolder.toStdString() + '/' + feature.file + ".berg";
            QCOMPARE(scenarioToJson(loadScenario(path)), readFile(path));
        }
    }

    void notesSayWhatToLookAt()
    {
        for (const Feature& feature : kFeatures) {
            const Scenario s = shipped(feature.file);
            if (s == defaultScenario()) // the preset itself has none
                continue;
            const QString notes = QString::fromStdString(s.notes);
            QVERIFY2(notes.count(". ") == 1 && notes.endsWith('.'), feature.file);
            QVERIFY2(!s.startUtc.empty(), feature.file);
        }
    }

    /** Each at its own place, and the icebergs where a UAV gets to in the time there is. */
    void placesAndDistancesArePlausible()
    {
        std::vector<LatLon> origins;
        for (const Feature& feature : kFeatures) {
            const Scenario s = shipped(feature.file);
            for (const LatLon& other : origins)
                QVERIFY2(!(other == s.origin), feature.file);
            origins.push_back(s.origin);
            const double range_m = s.duration_s * s.uavs[0].spec.airspeed_mps;
            for (const Iceberg& iceberg : s.icebergs)
                QVERIFY2((iceberg.position_m - s.uavs[0].position_m).norm() < range_m,
                         feature.file);
        }
    }
};

QTEST_APPLESS_MAIN(TestShippedScenarios)
#include "tst_shipped_scenarios.moc"
