#include "core/base/random.h"
#include "tests/support/approx.h"
#include "widgets/map/paint/label_placement.h"

#include <QtTest>

#include <algorithm>
#include <iterator>

using namespace berg;

namespace {

const QRectF kArea(0, 0, 1280, 800);
const QSizeF kLabel(48, 19);
const std::vector<QRectF> kOverlays = {QRectF(12, 12, 290, 100), QRectF(12, 580, 250, 208)};

LabelSurroundings openSea()
{
    LabelSurroundings around;
    around.area = kArea;
    return around;
}

/** Labels and the disks they name, spread at random beside the overlays. */
std::vector<LabelRequest> randomRequests(int count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<LabelRequest> requests;
    while (static_cast<int>(requests.size()) < count) {
        const LabelRequest request{
            .anchor = {.centre_px = {random.uniform(60, 1220), random.uniform(60, 740)},
                       .radius_px = random.uniform(10, 26)},
            .size_px = kLabel};
        // Like the map, name nothing that lies under an overlay.
        if (std::none_of(kOverlays.begin(), kOverlays.end(),
                         [&](const QRectF& o) { return overlaps(o, request.anchor); }))
            requests.push_back(request);
    }
    return requests;
}

} // namespace

class TestLabelPlacement : public QObject
{
    Q_OBJECT

private slots:
    void lonelyLabelIsRightOfItsSymbol()
    {
        const LabelRequest request{.anchor = {.centre_px = {400, 300}, .radius_px = 15},
                                   .size_px = kLabel};
        LabelSurroundings around = openSea();
        around.disks = {request.anchor};
        const auto placed = placeLabels(std::vector{request}, around);
        QCOMPARE(placed.size(), std::size_t{1});
        QVERIFY(placed[0].rect.left() > 415);
        QVERIFY(placed[0].rect.left() < 425);
        COMPARE_NEAR(placed[0].rect.center().y(), 300, 0.5);
        QVERIFY(!placed[0].needsLeader);
    }

    void labelAtTheEdgeTurnsInside_data()
    {
        QTest::addColumn<QPointF>("anchor");
        QTest::newRow("right edge") << QPointF(1270, 400);
        QTest::newRow("left edge") << QPointF(10, 400);
        QTest::newRow("corner") << QPointF(1275, 795);
    }

    void labelAtTheEdgeTurnsInside()
    {
        QFETCH(QPointF, anchor);
        const LabelRequest request{.anchor = {.centre_px = anchor, .radius_px = 12},
                                   .size_px = kLabel};
        const auto placed = placeLabels(std::vector{request}, openSea());
        QVERIFY(kArea.contains(placed[0].rect));
    }

    void linesAreAvoidedWhenThereIsRoom()
    {
        const LabelRequest request{.anchor = {.centre_px = {400, 300}, .radius_px = 15},
                                   .size_px = kLabel};
        LabelSurroundings around = openSea();
        around.lines = {QLineF(400, 300, 700, 300)}; // through the favourite place
        const auto placed = placeLabels(std::vector{request}, around);
        COMPARE_NEAR(lengthInside(placed[0].rect, around.lines[0]), 0, 1e-9);
    }

    /** Legs sweep over a name all the time in flight; only what hides it makes it move. */
    void unobstructedLabelStays()
    {
        LabelRequest request{.anchor = {.centre_px = {400, 300}, .radius_px = 15},
                             .size_px = kLabel};
        LabelSurroundings around = openSea();
        around.disks = {request.anchor};
        request.previous = placeLabels(std::vector{request}, around)[0];
        const QRectF before = request.previous->rect;
        around.lines = {QLineF(400, 300, 700, 300)};
        QCOMPARE(placeLabels(std::vector{request}, around)[0].rect, before);
        around.disks.push_back({.centre_px = before.center(), .radius_px = 10});
        QVERIFY(placeLabels(std::vector{request}, around)[0].rect != before);
    }

    void nothingOverlaps_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("seed");
        for (const int count : {4, 12, 20, 40})
            for (int seed = 1; seed <= 10; ++seed)
                QTest::addRow("%d labels, seed %d", count, seed) << count << seed;
    }

    void nothingOverlaps()
    {
        QFETCH(int, count);
        QFETCH(int, seed);
        const auto requests = randomRequests(count, static_cast<std::uint64_t>(seed));
        LabelSurroundings around = openSea();
        around.solids = kOverlays;
        for (const LabelRequest& request : requests)
            around.disks.push_back(request.anchor);
        const auto placed = placeLabels(requests, around);
        QCOMPARE(placed.size(), requests.size());
        for (std::size_t i = 0; i < placed.size(); ++i) {
            QVERIFY(!placed[i].rect.isNull());
            QVERIFY(kArea.contains(placed[i].rect));
            QCOMPARE(placed[i].rect.size(), kLabel);
            for (const QRectF& solid : around.solids)
                QVERIFY(!placed[i].rect.intersects(solid));
            for (const LabelDisk& disk : around.disks)
                QVERIFY(!overlaps(placed[i].rect, disk));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!placed[i].rect.intersects(placed[j].rect));
        }
    }

    void crowdShowsWhatHasRoom()
    {
        const std::vector<LabelRequest> requests(
            60, {.anchor = {.centre_px = {640, 400}, .radius_px = 12}, .size_px = kLabel});
        const auto placed = placeLabels(requests, openSea());
        QCOMPARE(placed.size(), requests.size());
        std::vector<PlacedLabel> shown;
        std::copy_if(placed.begin(), placed.end(), std::back_inserter(shown),
                     [](const PlacedLabel& label) { return !label.rect.isNull(); });
        QVERIFY(shown.size() >= 10);
        QVERIFY(shown.size() < 60);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            QVERIFY(kArea.contains(shown[i].rect));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!shown[i].rect.intersects(shown[j].rect));
        }
        QVERIFY(!placed.front().rect.isNull()); // the first comes first
        QVERIFY(std::any_of(shown.begin(), shown.end(),
                            [](const PlacedLabel& label) { return label.needsLeader; }));
    }

    void symbolUnderAnOverlayIsNotNamed()
    {
        const LabelRequest request{.anchor = {.centre_px = {150, 60}, .radius_px = 12},
                                   .size_px = kLabel};
        LabelSurroundings around = openSea();
        around.solids = {QRectF(0, 0, 600, 400)};
        QVERIFY(placeLabels(std::vector{request}, around)[0].rect.isNull());
    }

    void sameInputSamePlaces()
    {
        const auto requests = randomRequests(30, 5);
        const auto first = placeLabels(requests, openSea());
        const auto second = placeLabels(requests, openSea());
        for (std::size_t i = 0; i < first.size(); ++i)
            QCOMPARE(first[i].rect, second[i].rect);
    }

    void diskAgainstRectangle()
    {
        const QRectF rect(0, 0, 10, 10);
        QVERIFY(overlaps(rect, {.centre_px = {5, 5}, .radius_px = 1}));  // inside
        QVERIFY(overlaps(rect, {.centre_px = {12, 5}, .radius_px = 2})); // touching a side
        // The corner is sqrt(2) away from (11, 11).
        QVERIFY(!overlaps(rect, {.centre_px = {11, 11}, .radius_px = 1.4}));
        QVERIFY(overlaps(rect, {.centre_px = {11, 11}, .radius_px = 1.42}));
    }

    void lengthOfALineInside()
    {
        const QRectF rect(0, 0, 10, 10);
        COMPARE_NEAR(lengthInside(rect, QLineF(-5, 5, 15, 5)), 10, 1e-12);
        COMPARE_NEAR(lengthInside(rect, QLineF(2, 2, 2, 6)), 4, 1e-12);
        COMPARE_NEAR(lengthInside(rect, QLineF(-5, -5, 15, 15)), std::sqrt(200.0), 1e-12);
        COMPARE_NEAR(lengthInside(rect, QLineF(11, 0, 11, 10)), 0, 1e-12);
        COMPARE_NEAR(lengthInside(rect, QLineF(-5, 0, -1, 10)), 0, 1e-12);
    }
};

QTEST_APPLESS_MAIN(TestLabelPlacement)
#include "tst_label_placement.moc"
