#include "core/earth/sun.h"
#include "tests/support/approx.h"

using namespace berg;
using namespace std::chrono;

namespace {

SunTime utc(int y, unsigned m, unsigned d, int h, int min, double s = 0)
{
    return sys_days(year(y) / month(m) / day(d)) + hours(h) + minutes(min) +
           milliseconds(std::llround(1000 * s));
}

double secondsFrom(SunTime expected, const std::optional<SunTime>& found)
{
    return found ? std::abs(duration<double>(*found - expected).count()) : 1e9;
}

constexpr LatLon kGolden{.latitude_deg = 39.742476, .longitude_deg = -105.1786};
constexpr LatLon kBonavista{.latitude_deg = 48.65, .longitude_deg = -53.1};
constexpr LatLon kTromso{.latitude_deg = 69.65, .longitude_deg = 18.96};
constexpr LatLon kLongyearbyen{.latitude_deg = 78.22, .longitude_deg = 15.65};

/**
 * Tolerance: our equations neglect refraction changes with the weather, and nutation except its
 * main term.
 */
constexpr double kFew_s = 3;

} // namespace

/** Compares the sun with values published or computed by other methods. */
class TestSun : public QObject
{
    Q_OBJECT

private slots:
    /** Reda and Andreas, Solar Position Algorithm, NREL/TP-560-34302, Table A5.1. */
    void solarPositionAlgorithm()
    {
        const SunTime noon = utc(2003, 10, 17, 19, 30, 30);
        // NREL's value is topocentric.
        COMPARE_NEAR(sunElevation_deg(noon, kGolden), 39.872046, 0.002);
        QVERIFY(secondsFrom(utc(2003, 10, 17, 13, 12, 43.46),
                            sunSpan(noon, kGolden, kSunrise_deg).begin) < kFew_s);
        QVERIFY(secondsFrom(utc(2003, 10, 17, 0, 20, 19.19),
                            lastSet(utc(2003, 10, 17, 13, 0), kGolden, kSunrise_deg)) < kFew_s);
    }

    /** Values of XEphem (ephem 4.1.4) by VSOP87, with the centre of the sun at -0.833 and -6. */
    void risesAndSetsMatchXephem()
    {
        const SunSpan sun = sunSpan(utc(2026, 11, 28, 15, 0), kBonavista, kSunrise_deg);
        QVERIFY(secondsFrom(utc(2026, 11, 28, 10, 59, 47), sun.begin) < kFew_s);
        QVERIFY(secondsFrom(utc(2026, 11, 28, 19, 40, 38), sun.end) < kFew_s);
        const SunSpan twilight = sunSpan(utc(2026, 11, 28, 15, 0), kBonavista, kCivilTwilight_deg);
        QVERIFY(secondsFrom(utc(2026, 11, 28, 10, 23, 57), twilight.begin) < kFew_s);
        QVERIFY(secondsFrom(utc(2026, 11, 28, 20, 16, 27), twilight.end) < kFew_s);
        const LatLon south{.latitude_deg = -60, .longitude_deg = 170};
        const SunSpan winter = sunSpan(utc(2026, 6, 1, 0, 30), south, kSunrise_deg);
        QVERIFY(secondsFrom(utc(2026, 5, 31, 21, 25, 41), winter.begin) < kFew_s);
        QVERIFY(secondsFrom(utc(2026, 6, 1, 3, 49, 28), winter.end) < kFew_s);
    }

    void polarNightHasNoTimes()
    {
        const SunTime day = utc(2026, 11, 28, 11, 0);
        QVERIFY(sunSpan(day, kTromso, kSunrise_deg) == SunSpan{});
        const SunSpan twilight = sunSpan(day, kTromso, kCivilTwilight_deg); // by XEphem
        QVERIFY(secondsFrom(utc(2026, 11, 28, 7, 39, 30), twilight.begin) < kFew_s);
        QVERIFY(secondsFrom(utc(2026, 11, 28, 13, 23, 56), twilight.end) < kFew_s);
        QVERIFY(sunSpan(day, kLongyearbyen, kCivilTwilight_deg) == SunSpan{});
        // The sun is back in Tromso in the middle of January, twilight on Svalbard at its end.
        QCOMPARE(year_month_day(floor<days>(*nextRise(day, kTromso, kSunrise_deg))).month(),
                 January);
        const SunTime dawn = *nextRise(day, kLongyearbyen, kCivilTwilight_deg);
        QVERIFY(dawn > utc(2027, 1, 28, 0, 0) && dawn < utc(2027, 2, 1, 0, 0));
        const SunTime dusk = *lastSet(day, kLongyearbyen, kCivilTwilight_deg);
        QVERIFY(dusk > utc(2026, 11, 10, 0, 0) && dusk < utc(2026, 11, 15, 0, 0));
    }

    void polarDayHasNoTimes()
    {
        const SunSpan span = sunSpan(utc(2026, 6, 21, 3, 0), kTromso, kSunrise_deg);
        QVERIFY(!span.begin && !span.end && span.isAboveAtNoon);
        const LatLon pole{.latitude_deg = 90, .longitude_deg = 0};
        QVERIFY(sunSpan(utc(2026, 6, 21, 3, 0), pole, kSunrise_deg).isAboveAtNoon);
        QVERIFY(!sunSpan(utc(2026, 12, 21, 3, 0), pole, kCivilTwilight_deg).isAboveAtNoon);
    }

    /** The day is centred on the nearest noon of the place, wherever midnight UTC falls. */
    void daysOfThePlace()
    {
        const LatLon east{.latitude_deg = 10, .longitude_deg = 179};
        for (int hour = 0; hour < 24; ++hour) {
            const SunTime time = utc(2026, 3, 20, 0, 0) + hours(hour);
            const SunSpan span = sunSpan(time, east, kSunrise_deg);
            QVERIFY(span.begin && span.end && *span.begin < *span.end);
            QVERIFY(*span.end - *span.begin > hours(11) && *span.end - *span.begin < hours(13));
            const SunTime noon = *span.begin + (*span.end - *span.begin) / 2;
            QVERIFY(abs(time - noon) <= hours(12) + minutes(1));
            QVERIFY((sunElevation_deg(time, east) > kSunrise_deg) ==
                    (time > *span.begin && time < *span.end));
        }
    }
};

QTEST_APPLESS_MAIN(TestSun)
#include "tst_sun.moc"
