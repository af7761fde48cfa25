#include "tests/support/approx.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/patience.h"
#include "widgets/map/paint/overview_inset.h"

#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest>

using namespace berg;

namespace {

/** The widget with all its land, as an image. */
QImage picture(OverviewInset& overview)
{
    (void)overview.grab();
    overview.finishLand();
    return overview.grab().toImage();
}

QColor colourAt(const QImage& image, const QPointF& at)
{
    return image.pixelColor(at.toPoint());
}

/** A shown one of `side_px` square. */
struct ShownInset
{
    OverviewInset overview;

    explicit ShownInset(int side_px)
    {
        overview.resize(side_px, side_px);
        overview.show();
    }
};

} // namespace

class TestOverviewInset : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { qRegisterMetaType<LatLon>(); }

    void showsTheHemisphereOfThePlace()
    {
        ShownInset shown(400);
        shown.overview.setPlace({78, 15});
        QCOMPARE(shown.overview.pole(), Pole::North);
        const Theme theme = Theme::light();
        QImage image = picture(shown.overview);
        QCOMPARE(colourAt(image, shown.overview.pixelOf({73, -41})), theme.land);
        QCOMPARE(colourAt(image, shown.overview.pixelOf({86, 170})), theme.sea);
        shown.overview.setPlace({-65, -60});
        QCOMPARE(shown.overview.pole(), Pole::South);
        image = picture(shown.overview);
        QCOMPARE(colourAt(image, shown.overview.pixelOf({-88, 40})), theme.land);
        QCOMPARE(colourAt(image, shown.overview.pixelOf({-52, 35})), theme.sea);
    }

    void greenlandIsBelowTheNorthPole()
    {
        ShownInset shown(400);
        const QPointF pole = shown.overview.pixelOf({90, 0});
        COMPARE_NEAR(pole.x(), 200, 1);
        COMPARE_NEAR(pole.y(), 200, 1);
        const QPointF greenland = shown.overview.pixelOf({72, -45});
        COMPARE_NEAR(greenland.x(), pole.x(), 1e-6);
        QVERIFY(greenland.y() > pole.y());
        QVERIFY(shown.overview.pixelOf({72, 45}).x() > pole.x());
    }

    void marksPlaceAndExtent()
    {
        ShownInset shown(400);
        const Theme theme = Theme::light();
        shown.overview.setPlace({85, 170});
        QCOMPARE(colourAt(picture(shown.overview), shown.overview.pixelOf({85, 170})), theme.uav);
        const QImage without = picture(shown.overview);
        shown.overview.setExtent({{80, 150}, {80, 190}, {70, 190}, {70, 150}});
        const QImage with = picture(shown.overview);
        QVERIFY(with != without);
        const QPointF corner = shown.overview.pixelOf({80, 150});
        QCOMPARE(colourAt(with, corner), theme.plan);
    }

    void pixelsAndPlacesAgree()
    {
        ShownInset shown(300);
        for (const LatLon place : {LatLon{80, 20}, LatLon{47, -48}, LatLon{35, 179.9}}) {
            const std::optional<LatLon> back =
                shown.overview.placeAt(shown.overview.pixelOf(place));
            QVERIFY(back.has_value());
            COMPARE_NEAR(back->latitude_deg, place.latitude_deg, 1e-9);
            COMPARE_NEAR(back->longitude_deg, place.longitude_deg, 1e-9);
        }
        QVERIFY(!shown.overview.placeAt({8, 8})); // the corner is beyond the chart
    }

    void clickPicks()
    {
        ShownInset shown(300);
        QSignalSpy picked(&shown.overview, &OverviewInset::placePicked);
        const QPoint at = shown.overview.pixelOf({60, 10}).toPoint();
        QTest::mouseClick(&shown.overview, Qt::LeftButton, {}, at);
        QCOMPARE(picked.size(), 1);
        const auto place = picked.front().front().value<LatLon>();
        COMPARE_NEAR(place.latitude_deg, 60, 1); // a pixel is 50 km
        COMPARE_NEAR(place.longitude_deg, 10, 2);
        QTest::mouseClick(&shown.overview, Qt::LeftButton, {}, {7, 7});
        QTest::mouseClick(&shown.overview, Qt::RightButton, {}, at);
        QCOMPARE(picked.size(), 1);
    }

    void navigableOneZoomsAndMoves()
    {
        ShownInset shown(300);
        shown.overview.setNavigable(true);
        const LatLon place{70, 20};
        const QPointF at = shown.overview.pixelOf(place);
        shown.overview.zoomBy(4, at);
        const QPointF zoomed = shown.overview.pixelOf(place);
        COMPARE_NEAR(zoomed.x(), at.x(), 1e-6); // stays under the cursor
        COMPARE_NEAR(zoomed.y(), at.y(), 1e-6);
        QSignalSpy picked(&shown.overview, &OverviewInset::placePicked);
        QTest::mousePress(&shown.overview, Qt::LeftButton, {}, {150, 150});
        QTest::mouseMove(&shown.overview, {190, 160});
        QTest::mouseRelease(&shown.overview, Qt::LeftButton, {}, {190, 160});
        QCOMPARE(picked.size(), 0); // a move is no pick
        COMPARE_NEAR(shown.overview.pixelOf(place).x(), at.x() + 40, 1e-6);
        shown.overview.zoomBy(1e-3, at);
        COMPARE_NEAR(shown.overview.pixelOf({90, 0}).x(), 150, 1e-6); // the whole chart again
    }

    void wheelZoomsOnlyWhenNavigable()
    {
        ShownInset shown(300);
        const QPointF before = shown.overview.pixelOf({60, 0});
        const auto turnWheel = [&] {
            QWheelEvent event({100, 100}, {100, 100}, {}, {0, 120}, Qt::NoButton, {},
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&shown.overview, &event);
        };
        turnWheel();
        QCOMPARE(shown.overview.pixelOf({60, 0}), before);
        shown.overview.setNavigable(true);
        turnWheel();
        QVERIFY(shown.overview.pixelOf({60, 0}) != before);
    }

    void cursorShowsItsPlace()
    {
        ShownInset shown(300);
        const QImage without = picture(shown.overview);
        QTest::mouseMove(&shown.overview, {150, 80});
        QTRY_VERIFY(picture(shown.overview) != without);
    }

    void mapReservesRoomForTheInset()
    {
        test::MapFixture f;
        OverviewInset overview(&f.view);
        overview.hide();
        f.view.panels().setInset(&overview);
        QVERIFY(overview.isVisible());
        QVERIFY(f.view.rect().contains(overview.geometry()));
        f.view.camera().fit();
        for (std::size_t i = 0; i < f.scenario().icebergs.size(); ++i)
            QVERIFY(!overview.geometry().contains(f.iceberg(i)));
        f.view.resize(300, 200); // too small for it
        QTRY_VERIFY(!overview.isVisible());
        f.view.resize(1000, 700);
        QTRY_VERIFY(overview.isVisible());
        f.view.panels().setInset(nullptr);
        QVERIFY(!overview.isVisible());
    }

    void mapReportsItsOutlineAndCentresOnAPlace()
    {
        test::MapFixture f;
        const LocalFrame frame(f.scenario().origin);
        const QSignalSpy changed(&f.view.camera(), &MapCamera::moved);
        const LatLon place = frame.toGeographic({60'000, 20'000});
        f.view.camera().centreOn(place);
        QCOMPARE(changed.size(), 1);
        const QPointF middle = f.view.toScreen(frame.toPlane(place));
        COMPARE_NEAR(middle.x(), 500, 1e-6);
        COMPARE_NEAR(middle.y(), 350, 1e-6);
        const std::vector<LatLon> outline = f.view.camera().outline();
        const QPointF corner = f.view.toScreen(frame.toPlane(outline.front()));
        COMPARE_NEAR(corner.x(), 0, 1e-6);
        COMPARE_NEAR(corner.y(), 0, 1e-6);
        f.view.camera().centreOn({-30, 150}); // far beyond what a scenario may hold
        QVERIFY(f.view.toWorld({500, 350}).cwiseAbs().maxCoeff() <= 1e6 * (1 + 1e-9));
    }

    void coversNoMoreThanItsDisk()
    {
        ShownInset shown(200);
        const QImage image = picture(shown.overview);
        QVERIFY(colourAt(image, {10, 10}) != Theme::light().sea);
        QVERIFY(colourAt(image, {190, 190}) != Theme::light().land);
    }
};

QTEST_MAIN(TestOverviewInset)
#include "tst_overview_inset.moc"
