#include "core/base/random.h"
#include "core/land/land_bytes.h"
#include "tests/support/expect_error.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <span>

using namespace berg;
using namespace std::string_literals;

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes shipped(LandDetail detail)
{
    const std::span<const std::uint8_t> bytes = landBytes(detail);
    return {bytes.begin(), bytes.end()};
}

/** One cell, 10 E to 15 E and 70 N to 75 N, with a triangle of land on its western border. */
Bytes triangle()
{
    Bytes bytes{'B', 'E', 'R', 'G', 'L', 'A', 'N', 'D', 1, 0, 10, 0, 5, 0, 1, 0, 0, 0};
    const Bytes cell{32, 38, 1, 3, 0, 20, 60, 10, 59, 10}; // zigzag: 60 is +30, 59 is -30
    bytes.insert(bytes.end(), cell.begin(), cell.end());
    return bytes;
}

/** Returns true if reading succeeds or fails with an `Error`, and all points are in their cells. */
bool isSafe(const Bytes& bytes)
{
    try {
        const LandData data(bytes, "fuzzed");
        for (const LandCell& cell : data.cells())
            for (const LandRing& ring : cell.rings)
                for (const LandPoint& point : ring) {
                    const LatLon place = data.placeOf(point);
                    if (std::abs(place.latitude_deg) > 90 || std::abs(place.longitude_deg) > 180)
                        return false;
                }
    } catch (const Error&) {
        return true;
    }
    return true;
}

} // namespace

class TestLandData : public QObject
{
    Q_OBJECT

private slots:
    void readsWhatIsWritten()
    {
        const LandData data(triangle(), "triangle");
        QCOMPARE(data.cells().size(), std::size_t{1});
        QCOMPARE(data.cellSide_deg(), 5.0);
        const LandCell& cell = data.cells().front();
        QVERIFY((data.placeOf(cell.southWest) == LatLon{70, 10}));
        QCOMPARE(cell.rings.size(), std::size_t{1});
        const LandRing& ring = cell.rings.front();
        QCOMPARE(ring.size(), std::size_t{3});
        QVERIFY((data.placeOf(ring[0]) == LatLon{71, 10}));
        QVERIFY((data.placeOf(ring[1]) == LatLon{71.5, 13}));
        QVERIFY((data.placeOf(ring[2]) == LatLon{72, 10}));
        QVERIFY(data.isCut(ring[2], ring[0]));
        QVERIFY(!data.isCut(ring[0], ring[1]));
    }

    void shippedDataAreSound_data()
    {
        QTest::addColumn<LandDetail>("detail");
        QTest::addColumn<int>("fewestPoints");
        QTest::newRow("coarse") << LandDetail::Coarse << 60'000;
        QTest::newRow("fine") << LandDetail::Fine << 400'000;
    }

    void shippedDataAreSound()
    {
        QFETCH(LandDetail, detail);
        QFETCH(int, fewestPoints);
        std::size_t points = 0;
        for (const LandCell& cell : landData(detail).cells())
            for (const LandRing& ring : cell.rings)
                points += ring.size();
        QVERIFY(points > static_cast<std::size_t>(fewestPoints));
    }

    void landAndSea_data()
    {
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        QTest::addColumn<bool>("land");
        QTest::newRow("Grand Banks") << 46.5 << -50.0 << false;
        QTest::newRow("middle of Newfoundland") << 48.7 << -56.0 << true;
        QTest::newRow("Trinity Bay") << 47.9 << -53.5 << false;
        QTest::newRow("Greenland") << 70.0 << -40.0 << true;
        QTest::newRow("Davis Strait") << 67.0 << -58.0 << false;
        QTest::newRow("South Pole") << -90.0 << 0.0 << true;
        QTest::newRow("North Pole") << 90.0 << 0.0 << false;
        QTest::newRow("Chukotka, east of 180") << 66.5 << -177.0 << true;
        QTest::newRow("the same a turn on") << 66.5 << 183.0 << true;
        QTest::newRow("Bering Sea on 180") << 60.0 << 180.0 << false;
        QTest::newRow("Cairo") << 30.0 << 31.0 << true;
        QTest::newRow("Weddell Sea") << -65.0 << -45.0 << false;
    }
    void landAndSea()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        QFETCH(bool, land);
        QCOMPARE(isOnLand({latitude_deg, longitude_deg}), land);
    }

    /** Tests places between corners, on both sides of each edge that is a coast. */
    void coastsPartLandFromSea()
    {
        const LandData data(triangle(), "triangle");
        QVERIFY(data.contains({71.5, 11}));
        QVERIFY(data.contains({71.5, 12.99}));
        QVERIFY(!data.contains({71.5, 13.01}));
        QVERIFY(!data.contains({71.0, 11}));
        QVERIFY(!data.contains({72.0, 11}));
        QVERIFY(!data.contains({71.5, 9.99})); // another cell
        QVERIFY(data.contains({71.5, 371}));
        QVERIFY(!data.contains({-71.5, 11}));
    }

    /** Cuts run along cells in both directions: a neighbouring cell continues the land. */
    void cutsHaveTwoSides()
    {
        const LandData& data = landData(LandDetail::Fine);
        std::map<std::array<std::int32_t, 4>, int> open;
        const std::int32_t turn = 360'000;
        for (const LandCell& cell : data.cells())
            for (const LandRing& ring : cell.rings) {
                LandPoint before = ring.back();
                for (const LandPoint& point : ring) {
                    const LandPoint a{before.east % turn, before.north};
                    const LandPoint b{point.east % turn, point.north};
                    before = point;
                    if (!data.isCut(a, b) || (a.north == 0 && b.north == 0))
                        continue;
                    ++open[{a.east, a.north, b.east, b.north}];
                    --open[{b.east, b.north, a.east, a.north}];
                }
            }
        const auto unmatched = std::count_if(open.begin(), open.end(),
                                             [](const auto& edge) { return edge.second != 0; });
        // At the source's antimeridian cut a few islands have coasts that do not quite meet, and a
        // coast may run along a border.
        QVERIFY(unmatched < 60);
    }

    void refusesOtherFiles_data()
    {
        QTest::addColumn<int>("at");
        QTest::addColumn<int>("value");
        QTest::addColumn<std::string>("code");
        QTest::newRow("magic") << 0 << int('X') << "WrongFormat"s;
        QTest::newRow("version") << 8 << 2 << "UnsupportedVersion"s;
        QTest::newRow("no units") << 10 << 0 << "FileUnreadable"s;
        QTest::newRow("odd cells") << 12 << 7 << "FileUnreadable"s;
        QTest::newRow("too many cells") << 14 << 2 << "FileUnreadable"s;
        QTest::newRow("row beyond the pole") << 18 << 36 << "FileUnreadable"s;
        QTest::newRow("column beyond the turn") << 19 << 72 << "FileUnreadable"s;
        QTest::newRow("too many rings") << 20 << 100 << "FileUnreadable"s;
        QTest::newRow("two points") << 21 << 2 << "FileUnreadable"s;
        QTest::newRow("point outside its cell") << 22 << 1 << "FileUnreadable"s;
    }

    void refusesOtherFiles()
    {
        QFETCH(int, at);
        QFETCH(int, value);
        QFETCH(std::string, code);
        Bytes bytes = triangle();
        bytes[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(value);
        QCOMPARE(test::codeOf([&] { LandData(bytes, "broken"); }), code);
    }

    void refusesEveryTruncation()
    {
        const Bytes whole = triangle();
        for (std::size_t length = 0; length < whole.size(); ++length)
            QVERIFY_THROWS_EXCEPTION(Error, LandData(std::span(whole).first(length), "cut"));
        Bytes longer = whole;
        longer.push_back(0);
        QVERIFY_THROWS_EXCEPTION(Error, LandData(longer, "longer"));
    }

    void damageIsAnErrorOrHarmless()
    {
        Random random(7);
        const Bytes whole = shipped(LandDetail::Coarse);
        QVERIFY(!whole.empty());
        const auto below = [&](std::size_t end) {
            return static_cast<std::size_t>(random.uniform(0, static_cast<double>(end)));
        };
        for (int round = 0; round < 200; ++round) {
            Bytes damaged = whole;
            damaged.resize(below(whole.size() / 4) + 18);
            for (int k = 0; k < 4; ++k)
                damaged[below(damaged.size())] = static_cast<std::uint8_t>(below(256));
            QVERIFY(isSafe(damaged));
            Bytes changed = triangle();
            for (int k = 0; k < 3; ++k)
                changed[below(changed.size())] = static_cast<std::uint8_t>(below(256));
            QVERIFY(isSafe(changed));
        }
    }
};

QTEST_APPLESS_MAIN(TestLandData)
#include "tst_land_data.moc"
