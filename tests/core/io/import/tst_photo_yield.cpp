#include "core/io/import/photo_yield.h"
#include "core/mission/mission_instant.h"
#include "tests/support/approx.h"
#include "tests/support/flight/mission_builder.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

/** Two minutes of the flight over four icebergs, which starts at 23:59:30. */
Mission twoMinutes()
{
    Mission mission(fourIcebergs());
    mission.advance(120);
    return mission;
}

UtcTime after(double time_s)
{
    return *parseUtc("2026-05-01T23:59:30Z") +
           std::chrono::milliseconds(std::llround(1e3 * time_s));
}

LatLon placeOf(const Point& position_m)
{
    return LocalFrame(fourIcebergs().origin).toGeographic(position_m);
}

} // namespace

class TestPhotoYield : public QObject
{
    Q_OBJECT

private slots:
    void photographsAreCounted()
    {
        const Mission mission = twoMinutes();
        const Point berg_m =
            instantAt(mission, 60).simulation.track(IcebergIndex::of(1)).estimate_m(60);
        const std::vector<Photo> photos{
            {"near.jpg", {.place = placeOf(berg_m + Point(100, 0)), .time = after(60)}},
            {"track.jpg", {.time = after(30.4)}},
            {"new-1.jpg", {.place = placeOf({-9000, 0}), .time = after(90)}},
            {"new-2.jpg", {.place = placeOf({-9000, 300}), .time = after(95)}},
            {"new-3.jpg", {.place = placeOf({-9000, 3000}), .time = after(96)}},
            {"late.jpg", {.time = after(130)}},
            {"plain.jpg", {}},
            {"timeless.jpg", {.place = placeOf(berg_m)}}};
        const PhotoYield yield = photoYield(photos, {.mission = &mission});
        QCOMPARE(yield.photos, std::size_t{8});
        QCOMPARE(yield.positioned, std::size_t{5});
        QCOMPARE(yield.onTrack, std::size_t{1});
        QCOMPARE(yield.placed.size(), std::size_t{6});
        QCOMPARE(yield.near + yield.fresh, std::size_t{6});
        QCOMPARE(yield.table.sightings.size(), std::size_t{6});
        QCOMPARE(yield.table.rejected.count, std::size_t{2});
        const auto named = [&yield](const char* name) {
            return *std::ranges::find(yield.placed, name, &PlacedPhoto::name);
        };
        QCOMPARE(named("near.jpg").iceberg, std::string("berg-2"));
        QVERIFY(!named("near.jpg").isNew && named("near.jpg").line == 1);
        QCOMPARE(named("new-1.jpg").iceberg, named("new-2.jpg").iceberg); // one overflight
        QVERIFY(named("new-3.jpg").iceberg != named("new-1.jpg").iceberg);
        QVERIFY(named("timeless.jpg").isNew); // the iceberg may have been elsewhere
        const Point uav_m = instantAt(mission, 30).simulation.uav(0).pose.position_m;
        const PlacedPhoto track = named("track.jpg");
        QVERIFY(track.isOnTrack);
        COMPARE_NEAR(track.place.latitude_deg, placeOf(uav_m).latitude_deg, 1e-9);
        COMPARE_NEAR(track.place.longitude_deg, placeOf(uav_m).longitude_deg, 1e-9);
        for (const RejectedRow& row : yield.table.rejected.first)
            QVERIFY(row.fault ==
                    (row.line == 6 ? IssueId::PhotoNotInFlight : IssueId::PhotoNoPlace));
    }

    void withoutARunAllAreNew()
    {
        const std::vector<Photo> photos{{"a.jpg", {.place = placeOf({0, 0}), .time = after(5)}},
                                        {"b.jpg", {.place = placeOf({100, 0}), .time = after(0)}},
                                        {"c.jpg", {.time = after(0)}}};
        const PhotoYield yield = photoYield(photos, {});
        QCOMPARE(yield.fresh, std::size_t{2});
        QCOMPARE(yield.newIcebergs, std::size_t{1});
        QCOMPARE(yield.placed[0].name, std::string("b.jpg")); // by time
        QVERIFY(yield.table.rejected.first.at(0).fault == IssueId::PhotoNoPlace);
        QVERIFY(photoYieldJson(yield).find("\"new_icebergs\": 1") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestPhotoYield)
#include "tst_photo_yield.moc"
