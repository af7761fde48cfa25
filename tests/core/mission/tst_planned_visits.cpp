#include "core/mission/planned_visits.h"
#include "tests/support/approx.h"

#include <QtTest>

using namespace berg;

namespace {

PlanEvent patrol()
{
    PlanEvent plan;
    plan.order = {1, 0};
    plan.outlook = AimedOutlook{.sightings_s = {100, 160}};
    plan.laterVisits = {{1, 400}, {0, 500}, {1, 900}};
    return plan;
}

} // namespace

class TestPlannedVisits : public QObject
{
    Q_OBJECT

private slots:
    void visitsOfAllUavsAreMergedInTime()
    {
        PlanEvent other;
        other.uav = 1;
        other.laterVisits = {{1, 250}};
        const std::vector<std::vector<double>> visits =
            plannedVisits(std::vector{patrol(), other}, 3, 0);
        QCOMPARE(visits, (std::vector<std::vector<double>>{{160, 500}, {100, 250, 400, 900}, {}}));
    }

    void pastVisitsAreLeftOut()
    {
        const std::vector<std::vector<double>> visits =
            plannedVisits(std::vector{patrol()}, 2, 160);
        QCOMPARE(visits, (std::vector<std::vector<double>>{{160, 500}, {400, 900}}));
    }

    void planWithoutLaterVisitsIsNoPatrol()
    {
        PlanEvent plan = patrol();
        plan.laterVisits.clear();
        const std::vector<std::vector<double>> visits = plannedVisits(std::vector{plan}, 2, 0);
        QCOMPARE(visits, std::vector<std::vector<double>>(2));
        QVERIFY(!longestGap(visits, std::vector<Track>(2)));
    }

    void longestGapBeginsWithTheLastSighting()
    {
        const std::vector<std::vector<double>> visits = plannedVisits(std::vector{patrol()}, 2, 0);
        std::vector<Track> tracks(2);
        QCOMPARE(longestGap(visits, tracks), (RevisitGap{.iceberg = 1, .gap_s = 500}));
        tracks[0].seen_s = -450;
        QCOMPARE(longestGap(visits, tracks), (RevisitGap{.iceberg = 0, .gap_s = 610}));
    }
};

QTEST_APPLESS_MAIN(TestPlannedVisits)
#include "tst_planned_visits.moc"
