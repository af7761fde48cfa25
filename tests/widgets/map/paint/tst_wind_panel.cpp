#include "core/base/angles.h"
#include "tests/support/approx.h"
#include "tests/support/window/map_builder.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/map_layouts.h"
#include "tests/support/window/panel_test.h"
#include "widgets/document/wind.h"
#include "widgets/map/paint/map_legs.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/paint/map_paths.h"
#include "widgets/map/paint/wind_panel.h"
#include "widgets/theme/unit_settings.h"

#include <QHelpEvent>
#include <QSignalSpy>
#include <QToolTip>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

constexpr double kAirspeed_mps = 22;
const QRectF kPanel(100, 50, 110, 130);

MapAir airOf(double speed_mps, double from_deg)
{
    return {.wind_mps = windOf(speed_mps, from_deg), .limit_mps = kAirspeed_mps};
}

MapPicture windyPicture(const MapAir& air)
{
    MapPicture picture = randomPicture(12);
    picture.air = air;
    return picture;
}

/** A map before take-off, and where the tip of its wind is. */
struct WindFixture : MapFixture
{
    [[nodiscard]] MapLayout layout()
    {
        MapScene scene;
        scene.setRect(QRectF(view.rect()));
        scene.setPicture(withScenario(plainPicture(), scenario()));
        scene.setView(view.view());
        return scene.layout();
    }
    [[nodiscard]] QPoint tip() { return windTip(layout().wind, berg::airOf(scenario())).toPoint(); }
};

} // namespace

/** The panel of wind and current, and the wind dragged in it before take-off. */
class TestWindPanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnWarnings(); }
    void cleanup() { berg::setShownUnits({}); }

    void directionsAreThoseOfForecasts()
    {
        QVERIFY(windOf(10, 0).isApprox(Point(0, -10))); // from the north it blows to the south
        QVERIFY(windOf(10, 270).isApprox(Point(10, 0)));
        COMPARE_NEAR(windFrom_deg({3, 4}), 180 + degFromRad(std::atan2(3, 4)), 1e-9);
        QCOMPARE(windFrom_deg(Point::Zero()), 0.0);
        QCOMPARE(fastestWind_mps(22, 0.5), 21.5);
        QCOMPARE(fastestWind_mps(22.3, 0.5), 22.0);
        QCOMPARE(fastestWind_mps(0.2, 0.5), 0.0);
    }

    void slowestUavSetsTheLimit()
    {
        Scenario scenario = emptySea();
        scenario.uavs.push_back(scenario.uavs.front());
        scenario.uavs.back().spec.airspeed_mps = 17;
        QCOMPARE(berg::airOf(scenario).limit_mps, 17.0);
        scenario.uavs.clear();
        QCOMPARE(berg::airOf(scenario).limit_mps, 0.0);
    }

    void windTextHasSpeedAndDirection_data()
    {
        QTest::addColumn<double>("speed_mps");
        QTest::addColumn<QString>("text");
        QTest::newRow("calm") << 0.0 << u"No wind"_s;
        QTest::newRow("wind") << 8.0 << u"Wind 8.0 m/s from 250°"_s;
        QTest::newRow("just not strong") << 15.3 << u"Wind 15.3 m/s from 250°"_s;
        QTest::newRow("strong") << 15.5 << u"Wind 15.5 m/s from 250°, strong"_s; // 0.7 x 22 = 15.4
    }

    void windTextHasSpeedAndDirection()
    {
        QFETCH(double, speed_mps);
        QFETCH(QString, text);
        QCOMPARE(windText(airOf(speed_mps, 250), kLocale), text);
    }

    void textsFollowTheUnits()
    {
        setShownUnits({.speed = SpeedUnit::Knots});
        const double tenKnots_mps = 10 * 1852.0 / 3600;
        QCOMPARE(windText(airOf(tenKnots_mps, 90), kLocale), u"Wind 10.0 kn from 090°"_s);
    }

    /** Every whole step can be dragged to, and comes out as it went in. */
    void tipAndWindAreTheSame()
    {
        for (double speed_mps = 6; speed_mps < kAirspeed_mps; speed_mps += 0.5)
            for (double from_deg = 0; from_deg < 360; from_deg += 5) {
                const MapAir air = airOf(speed_mps, from_deg);
                const Point back = windAtTip(kPanel, air, windTip(kPanel, air), false);
                QVERIFY2(back == air.wind_mps,
                         qPrintable(u"%1 from %2"_s.arg(speed_mps).arg(from_deg)));
            }
    }

    void windStaysBelowTheAirspeed_data()
    {
        QTest::addColumn<SpeedUnit>("unit");
        QTest::addColumn<double>("fastest_mps");
        QTest::newRow("m/s") << SpeedUnit::MetresPerSecond << 21.5;
        QTest::newRow("knots") << SpeedUnit::Knots << 42 * 1852.0 / 3600;
    }

    void windStaysBelowTheAirspeed()
    {
        QFETCH(SpeedUnit, unit);
        QFETCH(double, fastest_mps);
        setShownUnits({.speed = unit});
        const MapAir air = airOf(0, 0);
        for (const QPointF& away : {QPointF(0, 500), QPointF(-300, 20), QPointF(47, 47)}) {
            const Point wind_mps = windAtTip(kPanel, air, windTip(kPanel, air) + away, false);
            COMPARE_NEAR(wind_mps.norm(), fastest_mps, 0.001); // components to the millimetre
            QVERIFY(wind_mps.norm() < kAirspeed_mps);
        }
        QVERIFY(windAtTip(kPanel, air, windTip(kPanel, air) + QPointF(0.2, 0), false).isZero(0));
    }

    void largeStepsOfDirection()
    {
        const MapAir air = airOf(12, 250);
        const Point wind_mps = windAtTip(kPanel, air, windTip(kPanel, air), true);
        COMPARE_NEAR(windFrom_deg(wind_mps), 255, 0.01);
    }

    void panelIsThereWhenThereIsSomethingToShow()
    {
        const Theme theme = Theme::light();
        const QRectF rect(0, 0, 1000, 700);
        const auto isShown = [&](const MapAir& air, bool offers) {
            const MapStyle style{.theme = theme, .locale = kLocale, .isLive = offers};
            return !arrangeMap(windyPicture(air), style, rect).wind.isNull();
        };
        QVERIFY(!isShown(airOf(0, 0), false));
        QVERIFY(isShown(airOf(0, 0), true));
        QVERIFY(isShown(airOf(8, 250), false));
        QVERIFY(isShown({.current_mps = {0.1, 0}, .limit_mps = kAirspeed_mps}, false));
        QVERIFY(!isShown({}, true)); // nothing flies
        // On a small map there is no room for what blows nothing.
        const MapStyle style{.theme = theme, .locale = kLocale, .isLive = true};
        const QRectF small(0, 0, 560, 400);
        QVERIFY(arrangeMap(windyPicture(airOf(0, 0)), style, small).wind.isNull());
        QVERIFY(!arrangeMap(windyPicture(airOf(8, 250)), style, small).wind.isNull());
    }

    void panelIsClearOfTheOthers_data()
    {
        QTest::addColumn<QSize>("size");
        for (const QSize& size : {QSize(960, 445), QSize(1280, 800), QSize(1000, 700)})
            QTest::addRow("%dx%d", size.width(), size.height()) << size;
    }

    void panelIsClearOfTheOthers()
    {
        QFETCH(QSize, size);
        MapAir air = airOf(21.5, 250);
        air.current_mps = {0.12, 0.18};
        const MapLayout layout = layoutOf(windyPicture(air), size);
        QVERIFY(!layout.wind.isNull());
        const std::vector<QRectF> overlays = layout.overlays();
        for (std::size_t i = 0; i < overlays.size(); ++i) {
            QVERIFY(layout.rect.contains(overlays[i]));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!overlays[i].intersects(overlays[j]));
        }
        QVERIFY(layout.wind.contains(windTip(layout.wind, air)));
        for (const LabelDisk& disk : layout.icebergs)
            QVERIFY(!overlaps(layout.wind, disk));
    }

    /** Otherwise the tip would move away from the cursor during a drag. */
    void panelKeepsItsSize()
    {
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = kLocale, .isLive = true};
        const QSizeF calm = windPanelSize(airOf(0, 0), style);
        for (const double speed_mps : {0.5, 8.0, 16.0, 21.5})
            QCOMPARE(windPanelSize(airOf(speed_mps, 123), style), calm);
    }

    void strongWindHasAnotherColour()
    {
        const Theme theme = Theme::light();
        const auto countOf = [&](double speed_mps, const QColor& colour) {
            QImage image(300, 200, QImage::Format_RGB32);
            image.fill(theme.sea);
            QPainter painter(&image);
            painter.setRenderHint(QPainter::Antialiasing);
            paintWindPanel(painter, kPanel, airOf(speed_mps, 270),
                           {.theme = theme, .locale = kLocale});
            painter.end();
            int count = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    count += image.pixelColor(x, y) == colour ? 1 : 0;
            return count;
        };
        QCOMPARE(countOf(15, theme.uav), 0);
        QVERIFY(countOf(16, theme.uav) > 20);
    }

    /** With the nose there, the UAV comes along the leg over ground. */
    void headingMarksHoldTheCourse()
    {
        MapPicture picture = windyPicture(airOf(8, 250));
        const MapLayout layout = layoutOf(picture, {1600, 1200});
        const std::vector<QLineF> marks = headingMarks(picture, layout, 0);
        const std::vector<QPolygonF> legs = planLegs(picture, layout, 0);
        QVERIFY(!marks.empty() && marks.size() <= 3);
        std::size_t found = 0;
        for (const QLineF& mark : marks) {
            const Point air_mps = kAirspeed_mps * Point(mark.dx(), -mark.dy()) / mark.length();
            const Point ground_mps = air_mps + picture.air.wind_mps;
            for (const QPolygonF& leg : legs) {
                const QLineF line(leg.isEmpty() ? QPointF() : leg.front(),
                                  leg.isEmpty() ? QPointF() : leg.back());
                if (QLineF(line.center(), mark.p1()).length() > 1e-6)
                    continue;
                const Point course = Point(line.dx(), -line.dy()) / line.length();
                COMPARE_NEAR(cross(course, ground_mps), 0, 1e-9);
                QVERIFY(course.dot(ground_mps) > 0);
                ++found;
            }
        }
        QCOMPARE(found, marks.size());
        picture.air.wind_mps = Point::Zero();
        QVERIFY(headingMarks(picture, layout, 0).empty());
    }

    void dragFromCalmIsOneUndoStep()
    {
        WindFixture map;
        const Scenario before = map.scenario();
        const QPoint from = map.tip();
        map.press(from);
        for (int i = 1; i <= 15; ++i)
            map.move(from + QPoint(i, 0));
        map.release(from + QPoint(15, 0));
        QCOMPARE(map.undoCount(), 1);
        QCOMPARE(map.document.undoStack()->undoText(), u"Change wind"_s);
        // 15 of 34 pixels of 22 m/s are 9.7, half a metre a second the step; the tip is rounded.
        QVERIFY(map.scenario().wind_mps == Point(9.5, 0) ||
                map.scenario().wind_mps == Point(10, 0));
        QVERIFY(map.selection.isEmpty());
        QCOMPARE(map.tip().y(), from.y());
        QVERIFY(std::abs(map.tip().x() - from.x() - 15) <= 1);
        map.drag(map.tip(), from); // back to calm
        QVERIFY(map.scenario().wind_mps.isZero(0));
        map.document.undoStack()->setIndex(0);
        QVERIFY(map.scenario() == before);
    }

    void escCancelsTheDrag_data()
    {
        QTest::addColumn<bool>("byKey");
        QTest::newRow("Esc") << true;
        QTest::newRow("dropped outside") << false;
    }

    void escCancelsTheDrag()
    {
        QFETCH(bool, byKey);
        WindFixture map;
        const Scenario before = map.scenario();
        const QPoint from = map.tip();
        map.drag(from, from + QPoint(-10, 12), {}, false);
        QVERIFY(!(map.scenario() == before));
        if (byKey)
            QTest::keyClick(&map.view, Qt::Key_Escape);
        map.release(QPoint(-30, 300));
        QVERIFY(map.scenario() == before);
        QCOMPARE(map.undoCount(), 0);
    }

    void strongWindIsAWarningButNoError()
    {
        WindFixture map;
        QSignalSpy said(&map.view.tools(), &MapToolbox::statusText);
        const QPoint from = map.tip();
        map.drag(from, QPoint(500, 600), {}, false);
        QVERIFY(said.last().at(0).toString().startsWith(u"The UAV makes little headway"_s));
        map.release(QPoint(500, 600));
        QVERIFY(!hasErrors(map.document.issues()));
        QVERIFY(map.scenario().wind_mps.norm() >= kStrongWindShare * kAirspeed_mps);
        QVERIFY(std::any_of(map.document.issues().begin(), map.document.issues().end(),
                            [](const Issue& issue) { return issue.field == "wind_mps"; }));
    }

    void panelHasAToolTip()
    {
        WindFixture map;
        QSignalSpy said(&map.view.tools(), &MapToolbox::statusText);
        map.move(map.tip() - QPoint(80, 0));
        map.move(map.tip());
        QVERIFY(!said.isEmpty());
        QVERIFY(said.last().at(0).toString().startsWith(u"Drag to set the wind"_s));
        map.document.edit(u"Wind"_s, [](Scenario& s) {
            s.wind_mps = windOf(8, 250);
            s.current_mps = {0, 0.2};
        });
        const QString text = windToolTip(berg::airOf(map.scenario()), kLocale);
        QVERIFY(text.startsWith(u"Wind 8.0 m/s from 250°\nCurrent 0.20 m/s towards 000°\n"_s));
        QVERIFY(text.contains(u"22 m/s"_s));
    }
};

QTEST_MAIN(TestWindPanel)
#include "tst_wind_panel.moc"
