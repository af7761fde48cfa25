#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/tracking/view_window.h"

#include <QTest>

using namespace berg;

namespace {

Point along(double angle_rad)
{
    return {std::cos(angle_rad), std::sin(angle_rad)};
}

Point anyPoint(Random& random, double extent_m)
{
    return {random.uniform(-extent_m, extent_m), random.uniform(-extent_m, extent_m)};
}

} // namespace

/** Compares the window for planners with the field of view that decides. */
class TestViewWindow : public QObject
{
    Q_OBJECT

private slots:
    void agreesWithTheFieldOfView_data()
    {
        QTest::addColumn<FovShape>("shape");
        QTest::newRow("body") << FovShape::Body;
        QTest::newRow("north") << FovShape::North;
        QTest::newRow("disk") << FovShape::Disk;
    }
    void agreesWithTheFieldOfView()
    {
        QFETCH(FovShape, shape);
        const SensorSpec sensor{.fov_m = Point(600, 400), .shape = shape};
        const ViewWindow window(sensor, 0);
        const FieldOfView view(sensor, Point::Zero(), 0); // heading east: its axes are the map's
        Random random(2);
        for (int i = 0; i < 2000; ++i) {
            const Point p_m = anyPoint(random, 400);
            const Point inAxes_m = shape == FovShape::North ? Point(p_m.y(), -p_m.x()) : p_m;
            QCOMPARE(window.contains(inAxes_m), view.contains(p_m));
            if (window.contains(inAxes_m))
                QVERIFY(inAxes_m.norm() <= window.reach_m());
        }
    }

    void crossingIsWhereThePointIsInside_data() { agreesWithTheFieldOfView_data(); }
    void crossingIsWhereThePointIsInside()
    {
        QFETCH(FovShape, shape);
        const ViewWindow window({.fov_m = Point(600, 400), .shape = shape}, 0);
        Random random(3);
        int crossed = 0;
        for (int i = 0; i < 1000; ++i) {
            const Point from_m = anyPoint(random, 700);
            const Point to_m = anyPoint(random, 700);
            const std::optional<ViewSpan> span = window.crossing(from_m, to_m);
            crossed += span ? 1 : 0;
            for (int k = 0; k <= 100; ++k) {
                const double share = k / 100.0;
                const bool inside = window.contains(from_m + share * (to_m - from_m));
                // On the edge itself, rounding decides.
                const bool nearEdge = span && (std::abs(share - span->enter) < 1e-9 ||
                                               std::abs(share - span->leave) < 1e-9);
                if (!nearEdge)
                    QCOMPARE(inside, span && share > span->enter && share < span->leave);
            }
        }
        QVERIFY(crossed > 200);
        QVERIFY(crossed < 900);
    }

    /**
     * If the whole line is inside, a narrower view sees all of it too, and every share is exactly
     * as computed.
     */
    void insideAllTheWay_data() { agreesWithTheFieldOfView_data(); }
    void insideAllTheWay()
    {
        QFETCH(FovShape, shape);
        const ViewWindow window({.fov_m = Point(600, 400), .shape = shape}, 0);
        Random random(5);
        int whole = 0;
        for (int i = 0; i < 1000; ++i) {
            const Point from_m = anyPoint(random, 400);
            const Point to_m = anyPoint(random, 400);
            const double inside_m = window.inside_m(from_m, to_m);
            if (inside_m < 0)
                continue;
            ++whole;
            QVERIFY(window.contains(from_m) && window.contains(to_m));
            const auto span = window.narrowed(inside_m * 0.999).crossing(from_m, to_m);
            QVERIFY(span && span->enter == 0 && span->leave == 1);
        }
        QVERIFY(shape == FovShape::Disk ? whole == 0 : whole > 100);
    }

    void fixedPointIsInViewThroughoutOrNever()
    {
        for (const FovShape shape : {FovShape::Body, FovShape::North, FovShape::Disk}) {
            const ViewWindow window({.fov_m = Point(600, 600), .shape = shape}, 0);
            const auto inside = window.crossing(Point(10, 10), Point(10, 10));
            QVERIFY(inside);
            QCOMPARE(inside->enter, 0.0);
            QCOMPARE(inside->leave, 1.0);
            QVERIFY(!window.crossing(Point(400, 0), Point(400, 0)));
        }
    }

    /** A point that is passed is in view right after the entry, and not before. */
    void entryIsWhereItComesIntoView_data() { agreesWithTheFieldOfView_data(); }
    void entryIsWhereItComesIntoView()
    {
        QFETCH(FovShape, shape);
        const SensorSpec sensor{.fov_m = Point(600, 400), .shape = shape};
        const ViewWindow window(sensor, 20);
        Random random(4);
        for (int i = 0; i < 300; ++i) {
            const double psi_rad = random.uniform(-kPi, kPi);
            const double offset_m =
                random.uniform(-window.largestOffset_m(), window.largestOffset_m());
            const double entry_m = window.entry_m(along(psi_rad), offset_m);
            const auto sees = [&](double before_m) {
                const Point p_m = before_m * along(psi_rad) + offset_m * along(psi_rad + kPi / 2);
                const Point axes_m =
                    shape == FovShape::North ? Point(p_m.y(), -p_m.x()) : Point(before_m, offset_m);
                return window.contains(axes_m);
            };
            QVERIFY(sees(entry_m - 0.001));
            QVERIFY(!sees(entry_m + 0.001));
        }
    }

    void marginNarrows()
    {
        const SensorSpec body{.fov_m = Point(600, 400), .shape = FovShape::Body};
        QCOMPARE(ViewWindow(body, 30).half_m(), Point(290, 170));
        QCOMPARE(ViewWindow(body, 30).largestOffset_m(), 170.0);
        QCOMPARE(ViewWindow(body, 1000).half_m(), Point(150, 100)); // half remains
        const SensorSpec north{.fov_m = Point(600, 400), .shape = FovShape::North};
        QCOMPARE(ViewWindow(north, 30).half_m(), Point(270, 170));
        QCOMPARE(ViewWindow(north, 30).largestOffset_m(), 170.0);
        const SensorSpec disk{.fov_m = Point(600, 400), .shape = FovShape::Disk};
        QCOMPARE(ViewWindow(disk, 30).largestOffset_m(), 270.0);
        QCOMPARE(viewMargin_m(0), 10.0);
        QCOMPARE(viewMargin_m(3), 90.0); // three times the deviation after 300 s
    }
};

QTEST_APPLESS_MAIN(TestViewWindow)
#include "tst_view_window.moc"
