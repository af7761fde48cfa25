#include "core/earth/forecast.h"
#include "tests/support/approx.h"

#include <QTest>

using namespace berg;
using namespace std::chrono_literals;

namespace {

const ForecastTime kStart = std::chrono::sys_days{std::chrono::year{2026} / 5 / 1} + 12h;

/** Wind at hours 0, 1 and 12; current at hours 0 and 6. */
Forecast mixed()
{
    return {.source = "test",
            .issued = kStart - 30h,
            .place = {64, -59},
            .series = {{.time = kStart,
                        .wind_mps = Point(10, 0),
                        .airTemperature_degC = -2,
                        .current_mps = Point(0, 0.2)},
                       {.time = kStart + 1h, .wind_mps = Point(0, 10), .airTemperature_degC = 0},
                       {.time = kStart + 6h, .current_mps = Point(0, 0.8)},
                       {.time = kStart + 12h, .wind_mps = Point(0, 4)}}};
}

} // namespace

class TestForecast : public QObject
{
    Q_OBJECT

private slots:
    void valuesAreLinear()
    {
        const ForecastEntry half = entryAt(mixed(), kStart + 30min);
        QCOMPARE(half.time, kStart + 30min);
        QCOMPARE(half.wind_mps.value(), Point(5, 5)); // through components: slower between
        QCOMPARE(half.airTemperature_degC, -1.0);
        COMPARE_NEAR(half.current_mps.value().y(), 0.25, 1e-12); // across the entry without it
        QVERIFY(!half.gust_mps && !half.fog_percent);
        QCOMPARE(entryAt(mixed(), kStart), mixed().series[0]);
    }

    void directionsTurnTheShorterWay()
    {
        // From 350 to 10 degrees by way of north: the components to the east cancel.
        Forecast forecast = mixed();
        forecast.series[0].wind_mps = Point(-1, 5);
        forecast.series[1].wind_mps = Point(1, 5);
        QCOMPARE(entryAt(forecast, kStart + 30min).wind_mps.value(), Point(0, 5));
    }

    void nothingIsInventedOutsideAndInGaps()
    {
        const Forecast forecast = mixed();
        for (const ForecastTime time : {kStart - 1ms, kStart + 12h + 1ms}) {
            const ForecastEntry outside = entryAt(forecast, time);
            QVERIFY(std::ranges::none_of(kForecastQuantities,
                                         [&](ForecastQuantity q) { return gives(outside, q); }));
        }
        const ForecastEntry inGap = entryAt(forecast, kStart + 3h);
        QVERIFY(!inGap.wind_mps);                                        // hours 1 to 12
        QVERIFY(!inGap.airTemperature_degC);                             // over at hour 1
        COMPARE_NEAR(inGap.current_mps.value().y(), 0.5, 1e-12);         // 6 h are no gap
        QCOMPARE(entryAt(forecast, kStart + 12h).wind_mps, Point(0, 4)); // the other end
        QVERIFY(!entryAt({}, kStart).wind_mps);
    }

    void gapsAreNamed()
    {
        const std::vector<ForecastGap> gaps = gapsOf(mixed());
        QCOMPARE(gaps.size(), 1U);
        QCOMPARE(gaps[0], (ForecastGap{ForecastQuantity::Wind, kStart + 1h, kStart + 12h}));
        QCOMPARE(nameOf(gaps[0].quantity), std::string_view("wind"));
        QCOMPARE(gapsOf(mixed(), kStart + 3h, kStart + 4h), gaps);
        QVERIFY(gapsOf(mixed(), std::nullopt, kStart + 1h).empty());
        QVERIFY(gapsOf(mixed(), kStart + 12h, std::nullopt).empty());
    }

    void ageIsCounted()
    {
        QCOMPARE(ageAt_h(mixed(), kStart), 30.0);
        QCOMPARE(ageAt_h(mixed(), kStart - 31h), -1.0);
        QVERIFY(!ageAt_h({}, kStart));
    }

    void cutHasInterpolatedEnds()
    {
        const Forecast part = cut(mixed(), kStart + 30min, kStart + 3h);
        QCOMPARE(part.series.size(), 3U);
        QCOMPARE(part.series[0], entryAt(mixed(), kStart + 30min));
        QCOMPARE(part.series[1], entryAt(mixed(), kStart + 1h)); // with a current between
        QCOMPARE(part.series[2], entryAt(mixed(), kStart + 3h));
        QCOMPARE(part.source, mixed().source);
        const Forecast whole = cut(mixed(), std::nullopt, std::nullopt);
        QCOMPARE(whole.series.size(), mixed().series.size());
        QCOMPARE(cut(mixed(), kStart - 9h, kStart + 99h), whole);
        QVERIFY(cut(mixed(), kStart + 13h, std::nullopt).series.empty());
        QVERIFY(cut(mixed(), kStart + 2h, kStart + 1h).series.empty());
        QCOMPARE(cut(mixed(), kStart, kStart).series.size(), 1U);
        QVERIFY(cut({}, std::nullopt, std::nullopt).series.empty());
    }

    void newestOfEachQuantityIsCombined()
    {
        Forecast ocean = mixed();
        ocean.source = "ocean";
        ocean.issued = kStart - 2h;
        ocean.place = {65, -59};
        ocean.series = {{.time = kStart + 30min, .current_mps = Point(1, 1)}};
        const Forecast both[] = {mixed(), ocean};
        const Forecast all = combined(both);
        QCOMPARE(all.source, std::string("test, ocean"));
        QCOMPARE(all.issued, mixed().issued);
        QCOMPARE(all.place, mixed().place);
        QCOMPARE(all.series.size(), 4U); // hours 0, 0.5, 1 and 12; hour 6 had a current only
        QCOMPARE(all.series[1].current_mps, Point(1, 1));
        QVERIFY(!all.series[0].current_mps && !all.series[1].wind_mps);
        QCOMPARE(all.series[3].wind_mps, Point(0, 4));

        ocean.issued.reset(); // older than any
        const Forecast undated[] = {ocean, mixed()};
        QCOMPARE(combined(undated).series.size(), 4U);
        QCOMPARE(combined(undated).place, ocean.place);
        QCOMPARE(combined(undated).source, std::string("test"));
        QCOMPARE(combined(std::span(both, 1)).series, mixed().series);
    }
};

QTEST_APPLESS_MAIN(TestForecast)
#include "tst_forecast.moc"
