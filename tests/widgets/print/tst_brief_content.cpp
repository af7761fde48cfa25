#include "core/base/angles.h"
#include "core/earth/coordinates.h"
#include "tests/support/approx.h"
#include "tests/support/files/brief_fixtures.h"
#include "widgets/print/brief_content.h"
#include "widgets/print/printable_text.h"
#include "widgets/theme/declination.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/theme/unit_settings.h"

#include <QtTest>

#include <cmath>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

QString cell(const BriefCells& cells, BriefColumn column)
{
    return cells[placeOf(column)];
}

/** A number of the page, whose thousands are set apart. */
double number(QString text)
{
    return text.remove(QChar(0x202f)).toDouble();
}

/** East and north from one place to another nearby, by the radii of curvature of WGS 84. */
Point between_m(const LatLon& from, const LatLon& to)
{
    constexpr double kAxis_m = 6378137;
    constexpr double kEccentricity2 = 0.00669437999014;
    const double sine = std::sin(radFromDeg((from.latitude_deg + to.latitude_deg) / 2));
    const double w2 = 1 - kEccentricity2 * sine * sine;
    const double meridian_m = kAxis_m * (1 - kEccentricity2) / std::pow(w2, 1.5);
    const double parallel_m = kAxis_m / std::sqrt(w2) * std::sqrt(1 - sine * sine);
    return {radFromDeg(to.longitude_deg - from.longitude_deg) * parallel_m,
            radFromDeg(to.latitude_deg - from.latitude_deg) * meridian_m};
}

LatLon placeIn(const BriefCells& cells)
{
    const QString text =
        cell(cells, BriefColumn::Latitude) + u' ' + cell(cells, BriefColumn::Longitude);
    const auto place = parsePlace(text.toStdString());
    return std::holds_alternative<LatLon>(place) ? std::get<LatLon>(place) : LatLon{0, 0};
}

/** Seconds of "mm:ss" and "h:mm:ss". */
int seconds(const QString& clock)
{
    int time_s = 0;
    for (const QString& part : clock.split(u':'))
        time_s = 60 * time_s + part.toInt();
    return time_s;
}

} // namespace

/** Content of the flight brief. */
class TestBriefContent : public QObject
{
    Q_OBJECT

private slots:
    void cleanup() { setShownUnits({}); }

    void oneRowForEachVisitInOrder()
    {
        const BriefContent brief = briefContent(planContent(fourIcebergs()), kEnglish);
        QCOMPARE(brief.routes.size(), 1U);
        const std::vector<BriefCells>& rows = brief.routes[0].rows;
        QCOMPARE(rows.size(), 5U);
        QCOMPARE(cell(rows[0], BriefColumn::Name), u"Start"_s);
        const QStringList names{u"berg-1"_s, u"berg-4"_s, u"Tabular \"B\", grounded since May"_s,
                                u"Isbjerg Å"_s};
        for (std::size_t i = 1; i < rows.size(); ++i) {
            QCOMPARE(cell(rows[i], BriefColumn::Number), QString::number(i));
            QCOMPARE(cell(rows[i], BriefColumn::Name), names[static_cast<int>(i) - 1]);
        }
        QCOMPARE(brief.title, u"Four icebergs"_s);
        QVERIFY(brief.start.contains(u"2026-05-01 23:59:30 UTC"_s));
    }

    void placesReadBack()
    {
        const ExportContent content = planContent(fourIcebergs());
        const BriefContent brief = briefContent(content, kEnglish);
        const std::vector<Visit>& visits = content.uavs[0].visits;
        for (std::size_t i = 0; i < visits.size(); ++i) {
            const LatLon shown = placeIn(brief.routes[0].rows[i + 1]);
            const LatLon place = content.frame.toGeographic(visits[i].position_m);
            constexpr double kHalfDigit_deg = 0.00501 / 60;
            QVERIFY(std::abs(shown.latitude_deg - place.latitude_deg) < kHalfDigit_deg);
            QVERIFY(std::abs(shown.longitude_deg - place.longitude_deg) < kHalfDigit_deg);
        }
    }

    void legsMatchGeodesics()
    {
        // Away from the origin, where north of the plane is not true north.
        const ExportContent content = planContent(changed([](Scenario& s) {
            s.origin = {.latitude_deg = 70, .longitude_deg = 10};
            s.uavs[0].position_m += Point(60000, 3000);
            for (Iceberg& iceberg : s.icebergs)
                iceberg.position_m += Point(60000, 3000);
        }));
        const BriefContent brief = briefContent(content, kEnglish);
        Point from_m = content.uavs[0].uav.position_m;
        double before_s = 0;
        for (std::size_t i = 0; i < content.uavs[0].visits.size(); ++i) {
            const Visit& visit = content.uavs[0].visits[i];
            const BriefCells& row = brief.routes[0].rows[i + 1];
            const Point leg_m = between_m(content.frame.toGeographic(from_m),
                                          content.frame.toGeographic(visit.position_m));
            const double course_deg =
                std::fmod(450 - degFromRad(std::atan2(leg_m.y(), leg_m.x())), 360);
            const double shown_deg = cell(row, BriefColumn::Course).chopped(1).toDouble();
            QVERIFY(std::abs(std::remainder(shown_deg - course_deg, 360)) < 0.52);
            QVERIFY(std::abs(number(cell(row, BriefColumn::Leg)) * 1000 - leg_m.norm()) < 6);
            // No wind: at the airspeed of 22 m/s.
            QVERIFY(std::abs(seconds(cell(row, BriefColumn::LegTime)) - leg_m.norm() / 22) < 0.6);
            QVERIFY(std::abs(visit.time_s - before_s - leg_m.norm() / 22) < 0.1);
            from_m = visit.position_m;
            before_s = visit.time_s;
        }
    }

    void arrivalsAreOnTheClock()
    {
        const ExportContent content = planContent(fourIcebergs()); // from 23:59:30 on
        const BriefContent brief = briefContent(content, kEnglish);
        QCOMPARE(cell(brief.routes[0].rows[0], BriefColumn::Arrival), u"23:59:30"_s);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto time_s = static_cast<int>(std::lround(content.uavs[0].visits[i].time_s));
            QVERIFY(time_s > 30); // after midnight
            const QTime clock = QTime(23, 59, 30).addSecs(time_s);
            QCOMPARE(cell(brief.routes[0].rows[i + 1], BriefColumn::Arrival),
                     clock.toString(u"HH:mm:ss"_s) + u" +1"_s);
        }
        QCOMPARE(brief.captions.units[placeOf(BriefColumn::Arrival)], u"UTC"_s);
    }

    void timesAreRelativeWithoutAStart()
    {
        const ExportContent content = planContent(changed([](Scenario& s) { s.startUtc.clear(); }));
        const BriefContent brief = briefContent(content, kEnglish);
        QVERIFY(!brief.start.contains(u"UTC"_s));
        QCOMPARE(brief.captions.units[placeOf(BriefColumn::Arrival)], QString());
        for (std::size_t i = 0; i < 4; ++i)
            QCOMPARE(seconds(cell(brief.routes[0].rows[i + 1], BriefColumn::Arrival)),
                     static_cast<int>(std::lround(content.uavs[0].visits[i].time_s)));
    }

    void uncertaintyIsThatOfTheArrival()
    {
        const Scenario scenario = fourIcebergs();
        const ExportContent content = planContent(scenario);
        const BriefContent brief = briefContent(content, kEnglish);
        for (std::size_t i = 0; i < 4; ++i) {
            const Visit& visit = content.uavs[0].visits[i];
            const Iceberg& iceberg = scenario.icebergs[toIndex(visit.iceberg.value())];
            const double sigma_m2 =
                iceberg.sigma0_m2 + iceberg.q_m2ps * (iceberg.observed_s + visit.time_s);
            const BriefCells& row = brief.routes[0].rows[i + 1];
            QVERIFY(std::abs(number(cell(row, sigmaColumn())) / sigma_m2 - 1) < 0.006);
            QCOMPARE(cell(row, radiusColumn()), radius95Text(sigma_m2, kEnglish));
        }
    }

    /** In columns of their own, with the declination that was used. */
    void coursesByMagneticNorthAndGroundSpeeds()
    {
        const ExportContent content = planContent(fourIcebergs());
        BriefContent brief = briefContent(content, kEnglish);
        const BriefCells plain = brief.routes[0].rows[1];
        QCOMPARE(cell(plain, BriefColumn::Magnetic), QString());
        QCOMPARE(brief.captions.names[placeOf(BriefColumn::Magnetic)], QString());
        // Without wind it is the airspeed.
        COMPARE_NEAR(cell(plain, BriefColumn::GroundSpeed).toDouble(),
                     content.uavs[0].uav.spec.airspeed_mps, 0.06);
        QCOMPARE(brief.captions.units[placeOf(BriefColumn::GroundSpeed)], u"m/s"_s);
        setShownUnits({.speed = SpeedUnit::Knots, .north = NorthForm::Typed});
        setTypedDeclination(-18);
        brief = briefContent(content, kEnglish);
        const BriefCells& row = brief.routes[0].rows[1];
        QCOMPARE(brief.captions.units[placeOf(BriefColumn::Magnetic)], u"magnetic"_s);
        const int true_deg = cell(row, BriefColumn::Course).chopped(1).toInt();
        const int magnetic_deg = cell(row, BriefColumn::Magnetic).chopped(1).toInt();
        QVERIFY(std::abs(std::remainder(magnetic_deg - true_deg - 18.0, 360)) <= 1);
        COMPARE_NEAR(cell(row, BriefColumn::GroundSpeed).toDouble(),
                     content.uavs[0].uav.spec.airspeed_mps * 3600 / 1852, 0.06);
        QVERIFY(std::ranges::any_of(brief.flight, [](const BriefFact& fact) {
            return fact.caption == u"Declination"_s && fact.value == u"18.0° W"_s;
        }));
    }

    /** Place and time of the start; no sun times without a date. */
    void sunAndTwilight()
    {
        Scenario scenario = fourIcebergs();
        const auto valueOf = [&](const QString& caption) {
            for (const BriefFact& fact : briefContent(planContent(scenario), kEnglish).flight)
                if (fact.caption == caption)
                    return fact.value;
            return QString();
        };
        scenario.origin = {.latitude_deg = 48.65, .longitude_deg = -53.1};
        scenario.startUtc = "2026-11-28T15:00:00Z";
        for (Uav& uav : scenario.uavs)
            uav.position_m = Point::Zero();
        QCOMPARE(valueOf(u"Sun up, UTC"_s), u"10:59 to 19:40"_s);
        QCOMPARE(valueOf(u"Civil twilight, UTC"_s), u"10:23 to 20:16"_s);
        scenario.origin = {.latitude_deg = 78.22, .longitude_deg = 15.65};
        QCOMPARE(valueOf(u"Civil twilight, UTC"_s), u"not on this day"_s);
        const QStringList warnings = briefContent(planContent(scenario), kEnglish).warnings;
        QVERIFY(std::ranges::any_of(
            warnings, [](const QString& line) { return line.contains(u"in the dark"_s); }));
        scenario.startUtc = "2026-06-21T15:00:00Z";
        QCOMPARE(valueOf(u"Sun up, UTC"_s), u"all day"_s);
        scenario.startUtc.clear();
        QCOMPARE(valueOf(u"Sun up, UTC"_s), QString());
    }

    void homeIsTheLastRow()
    {
        const ExportContent content =
            planContent(fourIcebergs(), fourIcebergPlan(), {.returnHome = true});
        const BriefContent brief = briefContent(content, kEnglish);
        const std::vector<BriefCells>& rows = brief.routes[0].rows;
        QCOMPARE(rows.size(), 6U);
        QCOMPARE(cell(rows.back(), BriefColumn::Name), u"Home"_s);
        QCOMPARE(cell(rows.back(), BriefColumn::Number), QString());
        QCOMPARE(cell(rows.back(), sigmaColumn()), QString());
        QCOMPARE(cell(rows.back(), BriefColumn::Latitude), cell(rows[0], BriefColumn::Latitude));
        QCOMPARE(cell(rows.back(), BriefColumn::Longitude), cell(rows[0], BriefColumn::Longitude));
    }

    void legsAddUpToTheDistance_data()
    {
        QTest::addColumn<ExportScope>("what");
        QTest::newRow("order") << ExportScope::Order;
        QTest::newRow("path") << ExportScope::Path;
        QTest::newRow("track") << ExportScope::Track;
    }

    void legsAddUpToTheDistance()
    {
        QFETCH(const ExportScope, what);
        const Mission mission = flown(fourIcebergs(), 390.5); // not on the record's grid
        const ExportOptions options{.what = what};
        const ExportContent content = what == ExportScope::Track
                                          ? runContent(mission, options)
                                          : planContent(fourIcebergs(), fourIcebergPlan(), options);
        const std::vector<TimedPoint> path = pathOf(content.uavs[0]);
        double length_m = 0;
        for (std::size_t i = 1; i < path.size(); ++i)
            length_m += (path[i].position_m - path[i - 1].position_m).norm();
        const BriefContent brief = briefContent(content, kEnglish);
        double legs_m = 0;
        int times_s = 0;
        for (const BriefCells& row : brief.routes[0].rows) {
            legs_m += 1000 * number(cell(row, BriefColumn::Leg));
            times_s += seconds(cell(row, BriefColumn::LegTime));
        }
        const double rows = static_cast<double>(brief.routes[0].rows.size());
        QVERIFY(length_m > 5000);
        QVERIFY(std::abs(legs_m - length_m) < 5 * rows + 25); // distance of another half second
        QVERIFY(std::abs(times_s - path.back().time_s) <= 0.5 * rows + 0.5);
    }

    void trackListsFlownLegs()
    {
        const Mission mission = flown(fourIcebergs());
        const ExportContent content = runContent(mission);
        const BriefContent brief = briefContent(content, kEnglish);
        const std::vector<BriefCells>& rows = brief.routes[0].rows;
        const std::vector<Visit>& visits = content.uavs[0].visits;
        QVERIFY(visits.size() >= 4U);
        QCOMPARE(rows.size(), visits.size() + 2);
        QCOMPARE(cell(rows.back(), BriefColumn::Name), u"End of track"_s);
        QCOMPARE(brief.captions.names[placeOf(BriefColumn::Arrival)], u"Reached"_s);
        for (std::size_t i = 0; i < visits.size(); ++i) {
            const ExportIceberg& iceberg = content.icebergs[toIndex(visits[i].iceberg.value())];
            QCOMPARE(cell(rows[i + 1], BriefColumn::Name), printable(titleOf(iceberg.iceberg)));
            QVERIFY(std::abs(number(cell(rows[i + 1], sigmaColumn())) - iceberg.sigma_m2) <=
                    0.005 * iceberg.sigma_m2 + 1e-9);
        }
    }

    void eachUavHasItsOwnRows()
    {
        const BriefContent brief = briefContent(fleetContent(3, 20), kEnglish);
        QCOMPARE(brief.routes.size(), 3U);
        QCOMPARE(brief.routes[0].rows.size(), 8U); // its start and 7 of 20
        QCOMPARE(brief.routes[2].rows.size(), 7U);
        QCOMPARE(brief.routes[1].name, u"uav-2"_s);
        QCOMPARE(brief.uavs.size(), 4U); // with captions
        for (const QStringList& row : brief.uavs)
            QCOMPARE(row.size(), brief.uavs[0].size());
        QVERIFY(brief.uavs[2].contains(u"160 m"_s)); // 40 m above the first
        QVERIFY(brief.uavs[0].contains(u"This sortie"_s));
        QVERIFY(!briefContent(planContent(fourIcebergs()), kEnglish)
                     .uavs[0]
                     .contains(u"This sortie"_s));
    }

    void uavRowHasTheChosenOptions()
    {
        const Scenario scenario = changed([](Scenario& s) {
            s.uavs[0].spec.endurance_s = 1800;
            s.uavs[0].home_m = Point(0, 0);
        });
        const BriefContent brief = briefContent(
            planContent(
                scenario, fourIcebergPlan(),
                {.altitude_m = 250, .airspeed_mps = 25, .acceptance_m = 80, .loiterTurns = 3}),
            kEnglish);
        const QStringList& row = brief.uavs[1];
        for (const QString& value : {u"250 m"_s, u"25.0 m/s"_s, u"80.0 m"_s, u"3"_s})
            QVERIFY2(row.contains(value), qPrintable(row.join(u'|')));
        QVERIFY(brief.sorties[1].contains(u"30:00"_s));
        // U^2 / (g tan 25 degrees)
        QVERIFY2(row.contains(u"137 m"_s), qPrintable(row.join(u'|')));
        QVERIFY(row.last().startsWith(u"47° 00.00′ N"_s));
    }

    /** 4 icebergs, flown at 22 m/s: what is left beyond the reserve of 20 %, and out of contact. */
    void uavRowHasReserveAndContact()
    {
        const Scenario scenario = changed([](Scenario& s) {
            s.uavs[0].spec.endurance_s = 5000;
            s.groundStation = GroundStation{.position_m = {1e5, 1e5}, .range_m = 10};
        });
        const ExportContent content = planContent(scenario);
        const BriefContent brief = briefContent(content, kEnglish);
        const auto cellOf = [&](const QString& caption) {
            return brief.sorties[1].value(brief.sorties[0].indexOf(caption));
        };
        const double flown_s = content.uavs[0].visits.back().time_s; // back home
        QCOMPARE(cellOf(u"Reserve"_s), u"16:40"_s);
        QCOMPARE(cellOf(u"Home, above the reserve"_s), clockText(4000 - flown_s));
        QCOMPARE(cellOf(u"Out of radio range"_s), clockText(flown_s));
        QVERIFY(brief.warnings.join(u' ').contains(u"out of the range of the ground station"));
    }

    /** Two of one pad and layer: home a slot before the reserve begins. */
    void uavRowHasTheRecoverySlot()
    {
        const Scenario scenario = changed([](Scenario& s) {
            s.uavs[0].spec.endurance_s = 5000;
            s.uavs.push_back(s.uavs[0]);
            s.uavs.back().id = "second";
        });
        const ExportContent content = planContent(scenario);
        const BriefContent brief = briefContent(content, kEnglish);
        QCOMPARE(brief.sorties[1].value(brief.sorties[0].indexOf(u"Recovery slot"_s)),
                 briefClock(content, 4000 - 30));
    }

    void nauticalUnits()
    {
        const Scenario scenario = changed([](Scenario& s) { s.wind_mps = Point(0, -10); });
        const BriefContent metric = briefContent(planContent(scenario), kEnglish);
        setShownUnits({.distance = DistanceUnit::Nautical, .speed = SpeedUnit::Knots});
        const BriefContent nautical = briefContent(planContent(scenario), kEnglish);
        QCOMPARE(metric.captions.units[placeOf(BriefColumn::Leg)], u"km"_s);
        QCOMPARE(nautical.captions.units[placeOf(BriefColumn::Leg)], u"nmi"_s);
        for (std::size_t i = 1; i < 5; ++i) {
            const double km = number(cell(metric.routes[0].rows[i], BriefColumn::Leg));
            const double nmi = number(cell(nautical.routes[0].rows[i], BriefColumn::Leg));
            QVERIFY(std::abs(nmi * 1.852 - km) < 0.015);
        }
        QCOMPARE(metric.flight[0].value, u"10.0 m/s from 000°"_s);
        QCOMPARE(nautical.flight[0].value, u"19.4 kn from 000°"_s);
    }

    void windIsByTrueNorth()
    {
        const ExportContent content = planContent(changed([](Scenario& s) {
            s.origin = {.latitude_deg = 75, .longitude_deg = 0};
            s.uavs[0].position_m = Point(300000, 0);
            s.wind_mps = Point(0, -8);
        }));
        // Meridians converge: true north there lies to the left of the north of the plane.
        const LatLon place = content.frame.toGeographic(Point(300000, 0));
        const double middle_deg = (75 + place.latitude_deg) / 2;
        const double from_deg = place.longitude_deg * std::sin(radFromDeg(middle_deg));
        const QString wind = briefContent(content, kEnglish).flight[0].value;
        const double shown_deg = wind.section(u' ', -1).chopped(1).toDouble();
        QVERIFY(from_deg > 9);
        QVERIFY2(std::abs(shown_deg - from_deg) < 1, qPrintable(wind));
    }

    void numbersAreThoseOfTheLocale()
    {
        const BriefContent brief = briefContent(planContent(fourIcebergs()), kGerman);
        const BriefCells& row = brief.routes[0].rows[1];
        for (const BriefColumn column :
             {BriefColumn::Leg, sigmaColumn(), BriefColumn::Latitude, BriefColumn::Longitude})
            QVERIFY2(cell(row, column).contains(u',') && !cell(row, column).contains(u'.'),
                     qPrintable(cell(row, column)));
    }
};

QTEST_MAIN(TestBriefContent)
#include "tst_brief_content.moc"
