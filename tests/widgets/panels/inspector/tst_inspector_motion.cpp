#include "core/earth/geodesy.h"
#include "tests/support/approx.h"
#include "tests/support/window/inspector_fixture.h"

using namespace berg;
using namespace Qt::StringLiterals;
using test::InspectorFixture;
using test::threeIcebergs;
/** Positions, drift, wind and current in the Inspector. */
class TestInspectorMotion : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void placeIsTypedAsAngles()
    {
        InspectorFixture f;
        f.selection.set({"berg-1"});
        const LocalFrame frame(f.document.scenario().origin);
        const LatLon before = frame.toGeographic(f.iceberg(0).position_m);
        test::enter(f.line(u"icebergLatitude"_s), u"47 06.0"_s);
        LatLon at = frame.toGeographic(f.iceberg(0).position_m);
        COMPARE_NEAR(at.latitude_deg, 47.1, 1e-9);
        COMPARE_NEAR(at.longitude_deg, before.longitude_deg, 1e-9);
        QCOMPARE(f.line(u"icebergLatitude"_s).text(), u"47° 06.000′ N"_s);
        // A whole coordinate, as it is pasted, sets both.
        test::enter(f.line(u"icebergLongitude"_s), u"47.2, -48.25"_s);
        at = frame.toGeographic(f.iceberg(0).position_m);
        COMPARE_NEAR(at.latitude_deg, 47.2, 1e-9);
        COMPARE_NEAR(at.longitude_deg, -48.25, 1e-9);
        QCOMPARE(f.undoSteps(), 2);
        QTest::keyClick(&f.line(u"icebergLatitude"_s), Qt::Key_Return);
        QCOMPARE(f.undoSteps(), 2); // what is shown has fewer digits than there are
    }

    void latitudeOfSeveralIsSetTogether()
    {
        InspectorFixture f;
        f.selection.set({"berg-1", "berg-3"});
        QCOMPARE(f.line(u"icebergLatitude"_s).text(), QString());
        QCOMPARE(f.line(u"icebergLatitude"_s).placeholderText(), u"mixed"_s);
        const LocalFrame frame(f.document.scenario().origin);
        const double before_deg = frame.toGeographic(f.iceberg(2).position_m).longitude_deg;
        test::enter(f.line(u"icebergLatitude"_s), u"47.05 N"_s);
        for (const std::size_t i : {std::size_t{0}, std::size_t{2}})
            COMPARE_NEAR(frame.toGeographic(f.iceberg(i).position_m).latitude_deg, 47.05, 1e-9);
        COMPARE_NEAR(frame.toGeographic(f.iceberg(2).position_m).longitude_deg, before_deg, 1e-9);
        QCOMPARE(f.undoSteps(), 1);
    }

    /** A whole coordinate would move several icebergs to one point. */
    void wholePlaceIsForOneOnly()
    {
        InspectorFixture f;
        f.selection.set({"berg-1", "berg-3"});
        const Scenario before = f.document.scenario();
        test::enter(f.line(u"icebergLatitude"_s), u"47.1 N 48.2 W"_s);
        QVERIFY(f.document.scenario() == before);
        QCOMPARE(
            f.label(u"icebergLatitudeFault"_s).text(),
            u"Enter one angle only: a whole coordinate would move all of them to one place."_s);
    }

    void invalidPlaceIsReportedAndIgnored_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("reason");
        QTest::newRow("no angle") << u"zzz"_s
                                  << u"No known place has this name, and it is not a coordinate."_s;
        QTest::newRow("too far north") << u"91"_s << u"Latitude must be between 90° S and 90° N."_s;
        QTest::newRow("the other half") << u"48 W"_s << u"This is a longitude. Enter a latitude."_s;
        QTest::newRow("nothing") << QString() << u"Enter a coordinate or a place name."_s;
        QTest::newRow("out of reach")
            << u"20 N"_s
            << u"This is 2 990 km from the scenario's origin; the limit is 1 000 km."_s;
    }

    void invalidPlaceIsReportedAndIgnored()
    {
        QFETCH(QString, typed);
        QFETCH(QString, reason);
        InspectorFixture f;
        f.selection.set({"berg-1"});
        QLineEdit& line = f.line(u"icebergLatitude"_s);
        const QString before = line.text();
        line.setFocus();
        line.selectAll();
        QTest::keyClick(&line, Qt::Key_Delete);
        QTest::keyClicks(&line, typed);
        QVERIFY(!f.label(u"icebergLatitudeFault"_s).isVisible()); // not while it is typed
        QTest::keyClick(&line, Qt::Key_Return);
        QCOMPARE(f.label(u"icebergLatitudeFault"_s).text(), reason);
        QCOMPARE(line.text(), before);
        QCOMPARE(f.undoSteps(), 0);
    }

    void driftIsSpeedAndDirection()
    {
        InspectorFixture f;
        f.selection.set({"berg-1"});
        // 3-4-5 triangle; towards atan(0.3 / 0.4) = 36.9 degrees from north.
        QCOMPARE(f.number(u"icebergVelocitySpeed"_s).value(), 0.5);
        QCOMPARE(f.number(u"icebergVelocityDirection"_s).value(), 36.9);
        test::enter(f.number(u"icebergVelocityDirection"_s), u"90"_s);
        QCOMPARE(f.iceberg(0).velocity_mps, Point(0.5, 0));
        f.number(u"icebergVelocityDirection"_s).stepUp();
        test::enter(f.number(u"icebergVelocitySpeed"_s), u"0"_s);
        QCOMPARE(f.iceberg(0).velocity_mps, Point(0, 0));
        QVERIFY(!f.number(u"icebergVelocityDirection"_s).isVisible()); // it has none
        // Several icebergs with other speeds: only the direction is set.
        f.document.undoStack()->setIndex(0);
        f.document.edit(u"Drift"_s, [](Scenario& s) { s.icebergs[1].velocity_mps = {-2, 0}; });
        f.selection.set({"berg-1", "berg-2"});
        test::enter(f.number(u"icebergVelocityDirection"_s), u"180"_s);
        QCOMPARE(f.iceberg(0).velocity_mps, Point(0, -0.5));
        QCOMPARE(f.iceberg(1).velocity_mps, Point(0, -2));
    }

    /** A stopped iceberg continues in its former direction. */
    void speedThroughZeroKeepsTheDirection()
    {
        InspectorFixture f;
        f.selection.set({"berg-1"});
        test::enter(f.number(u"icebergVelocityDirection"_s), u"90"_s);
        test::enter(f.number(u"icebergVelocitySpeed"_s), u"0"_s);
        QCOMPARE(f.iceberg(0).velocity_mps, Point(0, 0));
        test::enter(f.number(u"icebergVelocitySpeed"_s), u"0.25"_s);
        QCOMPARE(f.iceberg(0).velocity_mps, Point(0.25, 0));
        // One that never went anywhere starts to the north; wind that was turned off comes back.
        f.selection.set({"berg-3"});
        QCOMPARE(f.iceberg(2).velocity_mps, Point(0, 0));
        test::enter(f.number(u"icebergVelocitySpeed"_s), u"0.25"_s);
        QCOMPARE(f.iceberg(2).velocity_mps, Point(0, 0.25));
        f.selection.clear();
        test::enter(f.number(u"scenarioWindSpeed"_s), u"8"_s);
        test::enter(f.number(u"scenarioWindDirection"_s), u"270"_s);
        test::enter(f.number(u"scenarioWindSpeed"_s), u"0"_s);
        test::enter(f.number(u"scenarioWindSpeed"_s), u"8"_s);
        QCOMPARE(f.document.scenario().wind_mps, Point(8, 0));
    }

    void driftIsComponentsWhereTheUserWants()
    {
        const test::UnitsInUse units(test::kComponents);
        InspectorFixture f;
        f.selection.set({"berg-1"});
        QCOMPARE(f.label(u"icebergDrift"_s).text(), u"0.50 m/s towards 037°"_s);
        test::enter(f.number(u"icebergVelocityEast"_s), u"-1.5"_s);
        QCOMPARE(f.iceberg(0).velocity_mps, Point(-1.5, 0.4));
        QVERIFY(f.panel.findChild<NumberField*>(u"icebergVelocitySpeed"_s) == nullptr);
    }

    /** Wind has the direction it comes from, current the direction it goes to. */
    void windIsFromCurrentTowards()
    {
        InspectorFixture f;
        test::enter(f.number(u"scenarioWindSpeed"_s), u"8"_s);
        test::enter(f.number(u"scenarioWindDirection"_s), u"270"_s);
        QCOMPARE(f.document.scenario().wind_mps, Point(8, 0));
        QCOMPARE(f.number(u"scenarioWindDirection"_s).value(), 270.0);
        test::enter(f.number(u"scenarioWindSpeed"_s), u"30"_s);
        QVERIFY(f.document.scenario().wind_mps.norm() < 22); // the airspeed
        test::enter(f.number(u"scenarioCurrentSpeed"_s), u"0.2"_s);
        test::enter(f.number(u"scenarioCurrentDirection"_s), u"90"_s);
        QCOMPARE(f.document.scenario().current_mps, Point(0.2, 0));
        QVERIFY(!hasErrors(f.document.issues()));
    }

    void windStaysSlowerThanTheUav()
    {
        const test::UnitsInUse units(test::kComponents);
        Scenario scenario = threeIcebergs();
        scenario.wind_mps = Point(0, 20);
        InspectorFixture f(scenario);
        NumberField& east = f.number(u"scenarioWindEast"_s);
        // sqrt(22^2 - 20^2) = 9.165, and strictly slower in steps of 0.01.
        QCOMPARE(east.maximum(), 9.16);
        east.setValue(9.16);
        f.selection.set({"uav-1"});
        NumberField& airspeed = f.number(u"uavs.airspeed_mps"_s);
        airspeed.setValue(airspeed.minimum());
        QVERIFY(!hasErrors(f.document.issues()));
    }
};

QTEST_MAIN(TestInspectorMotion)
#include "tst_inspector_motion.moc"
