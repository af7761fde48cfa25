#include "core/permit/daylight.h"

#include <QtTest>

using namespace berg;
using namespace std::chrono;

namespace {

constexpr LatLon kBonavista{.latitude_deg = 48.65, .longitude_deg = -53.1};
constexpr LatLon kLongyearbyen{.latitude_deg = 78.22, .longitude_deg = 15.65};

/** A time on 28 November 2026 or a day after it. */
SunTime utc(int h, int min)
{
    return sys_days(year(2026) / November / 28) + hours(h) + minutes(min);
}

std::vector<std::string> textsOf(const std::vector<Issue>& issues)
{
    std::vector<std::string> texts;
    for (const Issue& issue : issues)
        texts.push_back(issue.field + ' ' + issue.message());
    return texts;
}

using Texts = std::vector<std::string>;

} // namespace

/** Civil twilight off Bonavista on that day: 10:24 to 20:16 UTC (`tst_sun`). */
class TestDaylight : public QObject
{
    Q_OBJECT

private slots:
    void noWarningByDay()
    {
        QVERIFY(daylightIssues(0, {.takeOff = utc(10, 30),
                                   .landing = utc(20, 10),
                                   .from = kBonavista,
                                   .to = kBonavista})
                    .empty());
    }

    void flightsInTheDarkAreReported()
    {
        const FlightHours flight{
            .takeOff = utc(10, 20), .landing = utc(20, 20), .from = kBonavista, .to = kBonavista};
        QCOMPARE(textsOf(daylightIssues(1, flight)),
                 (Texts{"uavs[1] takes off in the dark, at 10:20 UTC: civil twilight begins at "
                        "10:23 UTC",
                        "uavs[1] lands in the dark, at 20:20 UTC: civil twilight ends at 20:16 "
                        "UTC"}));
        for (const Issue& issue : daylightIssues(1, flight))
            QVERIFY(issue.severity == Severity::Warning);
    }

    /** A UAV aloft has already taken off; the light was on the day before. */
    void landingAfterMidnight()
    {
        QCOMPARE(
            textsOf(daylightIssues(
                0, {.takeOff = {}, .landing = utc(26, 5), .from = kBonavista, .to = kBonavista})),
            (Texts{"uavs[0] lands in the dark, at 02:05 UTC: civil twilight ends at "
                   "2026-11-28 20:16 UTC"}));
    }

    void polarNightNamesTheNextLight()
    {
        const std::vector<Issue> issues = daylightIssues(0, {.takeOff = utc(11, 0),
                                                             .landing = utc(12, 0),
                                                             .from = kLongyearbyen,
                                                             .to = kLongyearbyen});
        QCOMPARE(issues.size(), std::size_t{2});
        QVERIFY(issues[0].message().find("begins at 2027-01-30 10:") != std::string::npos);
        QVERIFY(issues[1].message().find("ends at 2026-11-12 10:") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestDaylight)
#include "tst_daylight.moc"
