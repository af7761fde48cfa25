#include "tests/support/window/inspector_fixture.h"
#include "widgets/panels/fields/fold_heading.h"

#include <QCheckBox>
#include <QComboBox>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** The Inspector with a UAV selected and the group of its aircraft profile open. */
struct AircraftFixture : test::InspectorFixture
{
    AircraftFixture()
    {
        selection.set({"uav-1"});
        test::child<FoldHeading>(panel, u"uavMissionGroup"_s).click();
    }
    [[nodiscard]] const AircraftProfile& aircraft() const
    {
        return document.scenario().uavs[0].aircraft;
    }
    [[nodiscard]] QComboBox& list(const QString& name) const
    {
        return test::child<QComboBox>(panel, name);
    }
    void choose(const QString& name, int choice)
    {
        list(name).setCurrentIndex(choice);
        emit list(name).activated(choice);
    }
    [[nodiscard]] bool isShown(const QString& name) const
    {
        return test::child<QWidget>(panel, name).isVisibleTo(&panel);
    }
};

} // namespace

/** The rows of the aircraft profile. */
class TestInspectorAircraft : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void readyProfilesSetAllRows()
    {
        AircraftFixture f;
        QComboBox& ready = f.list(u"uavAircraftProfile"_s);
        QCOMPARE(ready.count(), int(readyProfiles().size()) + 1);
        QCOMPARE(ready.currentIndex(), 1); // the default, after "as set below"
        for (int i = 0; i < int(readyProfiles().size()); ++i) {
            f.choose(u"uavAircraftProfile"_s, i + 1);
            QVERIFY(f.aircraft() == readyProfiles()[std::size_t(i)].profile);
            QCOMPARE(ready.currentIndex(), i + 1);
        }
        test::enter(f.number(u"uavs.take_off_altitude_m"_s), u"77"_s);
        QCOMPARE(ready.currentIndex(), 0);
        f.choose(u"uavAircraftProfile"_s, 0);
        QCOMPARE(f.aircraft().takeOffAltitude_m, 77.0);
    }

    void rowsThatDoNotMatterAreHidden()
    {
        AircraftFixture f;
        QVERIFY(f.isShown(u"uavs.take_off_pitch_deg"_s));
        QVERIFY(!f.isShown(u"uavs.approach_m"_s));
        QVERIFY(!f.isShown(u"uavs.trigger_m"_s) && !f.isShown(u"uavs.hover_speed_mps"_s));
        f.choose(u"uavs.mission_end"_s, 1);
        QVERIFY(f.aircraft().end == MissionEnd::Landing);
        QVERIFY(f.isShown(u"uavs.approach_m"_s));
        QCOMPARE(f.number(u"uavs.approach_course_deg"_s).text(), u"into the wind"_s);
        f.choose(u"uavs.camera"_s, 1);
        QVERIFY(f.isShown(u"uavs.trigger_m"_s) && !f.isShown(u"uavs.trigger_s"_s));
        f.choose(u"uavs.airframe"_s, 2);
        QVERIFY(!f.isShown(u"uavs.approach_m"_s) && !f.isShown(u"uavs.loiter_radius_m"_s));
        QVERIFY(f.isShown(u"uavs.take_off_altitude_m"_s));
        f.choose(u"uavs.take_off"_s, 1);
        QVERIFY(!f.isShown(u"uavs.take_off_altitude_m"_s));
    }

    void optionalNumbersCanBeCleared()
    {
        AircraftFixture f;
        test::enter(f.number(u"uavs.loiter_radius_m"_s), u"250"_s);
        QCOMPARE(f.aircraft().loiterRadius_m.value_or(0), 250.0);
        test::enter(f.number(u"uavs.loiter_radius_m"_s), u"0"_s);
        QVERIFY(!f.aircraft().loiterRadius_m);
        test::child<QCheckBox>(f.panel, u"uavs.gimbal_down"_s).click();
        QVERIFY(f.aircraft().gimbalDown);
    }
};

QTEST_MAIN(TestInspectorAircraft)
#include "tst_inspector_aircraft.moc"
