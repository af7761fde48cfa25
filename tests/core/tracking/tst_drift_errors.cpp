#include "core/base/stopped.h"
#include "core/tracking/drift_errors.h"
#include "tests/support/approx.h"

#include <QTest>

using namespace berg;

namespace {

constexpr double kHour_s = 3600;
constexpr double kLongestGap_s = 6 * kHour_s;
constexpr DriftLaw kWithCurrent{};

/** A track with a fix each hour that moves with this velocity, turning to the second one. */
PlacedTrack trackOf(int hours, const Point& first_mps, const Point& then_mps, int turnAt_h)
{
    PlacedTrack track;
    LatLon place{64, -59};
    for (int h = 0; h <= hours; ++h) {
        track.push_back({.time_s = h * kHour_s, .place = place});
        place = LocalFrame(place).toGeographic((h < turnAt_h ? first_mps : then_mps) * kHour_s);
    }
    return track;
}

ForcingAt constantCurrent(const Point& current_mps)
{
    return [current_mps](double) { return Forcing{.current_mps = current_mps}; };
}

/** Compares the predictions of the law that drifts with the current alone. */
std::vector<DriftLeadError> errorsOf(const PlacedTrack& track, const ForcingAt& forcing,
                                     const DriftErrorRules& rules = {})
{
    return driftErrors(std::span(&track, 1), kWithCurrent, forcing, rules);
}

} // namespace

class TestDriftErrors : public QObject
{
    Q_OBJECT

private slots:
    void placeBetweenFixes()
    {
        const PlacedTrack track = trackOf(10, {0, 1}, {0, 1}, 99);
        COMPARE_NEAR(LocalFrame({64, -59}).toPlane(*placeAt(track, 1800, kLongestGap_s)).y(), 1800,
                     0.1);
        QCOMPARE(placeAt(track, 0, kLongestGap_s), track.front().place);
        QCOMPARE(placeAt(track, 10 * kHour_s, kLongestGap_s), track.back().place);
        QVERIFY(!placeAt(track, -1, kLongestGap_s));
        QVERIFY(!placeAt(track, 10 * kHour_s + 1, kLongestGap_s));
        QVERIFY(!placeAt(track, 1800, 3000)); // the fixes are 3600 s apart
        QVERIFY(!placeAt({}, 0, kLongestGap_s));
    }

    void steadyDrift()
    {
        // It moves 0.3 m/s: 6.48 km in 6 h, 51.84 km in 48 h. The last velocity is right; a law
        // without wind and current is as far off as the iceberg has moved.
        const PlacedTrack track = trackOf(72, {0, 0.3}, {0, 0.3}, 99);
        const std::vector<DriftLeadError> errors = errorsOf(track, constantCurrent(Point::Zero()));
        QCOMPARE(errors.size(), 4U);
        QCOMPARE(errors[0].lead_s, 6 * kHour_s);
        QCOMPARE(errors[0].starts, 64U); // hours 3 to 66
        QCOMPARE(errors[3].starts, 22U); // hours 3 to 24
        COMPARE_NEAR(errors[0].moved_m, 6480, 0.5);
        COMPARE_NEAR(errors[3].moved_m, 51840, 0.5);
        for (const DriftLeadError& error : errors) {
            COMPARE_NEAR(error.drift_m, error.moved_m, 0.5);
            COMPARE_NEAR(error.lastVelocity_m, 0, 1);
        }
    }

    void lawOfTheRightCurrent()
    {
        const std::vector<DriftLeadError> errors =
            errorsOf(trackOf(72, {0.2, -0.1}, {0.2, -0.1}, 99), constantCurrent({0.2, -0.1}));
        for (const DriftLeadError& error : errors)
            COMPARE_NEAR(error.drift_m, 0, 5); // the steps of the track are longer
    }

    void turnSpoilsTheLastVelocity()
    {
        // From 0.2 m/s east it turns at hour 3 to 0.2 m/s north. One start only, at that hour:
        // after 6 h the last velocity is 0.2 sqrt(2) x 21600 = 6109 m off.
        const PlacedTrack track = trackOf(9, {0.2, 0}, {0, 0.2}, 3);
        const std::vector<DriftLeadError> errors =
            errorsOf(track, constantCurrent({0, 0.2}), {.leads_s = {6 * kHour_s}});
        QCOMPARE(errors.size(), 1U);
        QCOMPARE(errors[0].starts, 1U);
        COMPARE_NEAR(errors[0].drift_m, 0, 1);
        COMPARE_NEAR(errors[0].lastVelocity_m, 6109, 10); // meridians converge within 4 km
    }

    void onlyWhereAllIsKnown()
    {
        const PlacedTrack track = trackOf(30, {0, 0.3}, {0, 0.3}, 99);
        const ForcingAt tenHours = [](double time_s) {
            return time_s <= 10 * kHour_s ? std::optional(Forcing{}) : std::nullopt;
        };
        const std::vector<DriftLeadError> errors =
            errorsOf(track, tenHours, {.leads_s = {6 * kHour_s, 24 * kHour_s}});
        QCOMPARE(errors[0].starts, 2U); // hours 3 and 4
        QCOMPARE(errors[1].starts, 0U);
        QCOMPARE(errors[1].drift_m, 0.0);

        PlacedTrack gap = track;
        gap.erase(gap.begin() + 5, gap.begin() + 26); // hours 5 to 25
        QCOMPARE(errorsOf(gap, constantCurrent(Point::Zero()), {.leads_s = {kHour_s}})[0].starts,
                 2U); // hour 3 and, with the velocity from hour 26 on, hour 29
        QCOMPARE(driftErrors({}, kWithCurrent, tenHours)[0].starts, 0U);
    }

    void startsAreThinned()
    {
        const PlacedTrack track = trackOf(200, {0, 0.1}, {0, 0.1}, 999);
        const DriftErrorRules rules{.leads_s = {6 * kHour_s}, .mostStarts = 20};
        const std::vector<DriftLeadError> errors =
            errorsOf(track, constantCurrent(Point::Zero()), rules);
        QCOMPARE(errors[0].starts, 19U); // without the one at hour 0
    }

    void stops()
    {
        std::stop_source source;
        source.request_stop();
        const PlacedTrack track = trackOf(20, Point::Zero(), Point::Zero(), 0);
        QVERIFY_EXCEPTION_THROWN((void)driftErrors(std::span(&track, 1), kWithCurrent,
                                                   constantCurrent(Point::Zero()), {},
                                                   source.get_token()),
                                 Stopped);
    }
};

QTEST_APPLESS_MAIN(TestDriftErrors)
#include "tst_drift_errors.moc"
