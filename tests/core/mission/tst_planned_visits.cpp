#include "core/mission/planned_visits.h"
#include "tests/support/approx.h"

#include <QtTest>

using namespace berg;

namespace {

UavPlan patrol()
{
    UavPlan plan;
    plan.order = {1, 0};
    plan.outlook = AimedOutlook{.sightings_s = {100, 160}};
    plan.laterVisits = {{1, 400}, {0, 500}, {1, 900}};
    return plan;
}

std::vector<std::vector<double>> visitsOf(std::vector<UavPlan> uavs, std::size_t icebergs,
                                          double now_s)
{
    const std::size_t count = uavs.size();
    const auto plan = std::make_shared<const Plan>(Plan{.uavs = std::move(uavs)});
    return plannedVisits(std::vector<PlanPointer>(count, plan), icebergs, now_s);
}

} // namespace

class TestPlannedVisits : public QObject
{
    Q_OBJECT

private slots:
    void visitsOfAllUavsAreMergedInTime()
    {
        UavPlan other;
        other.uav = 1;
        other.laterVisits = {{1, 250}};
        const std::vector<std::vector<double>> visits = visitsOf({patrol(), other}, 3, 0);
        QCOMPARE(visits, (std::vector<std::vector<double>>{{160, 500}, {100, 250, 400, 900}, {}}));
    }

    void pastVisitsAreLeftOut()
    {
        const std::vector<std::vector<double>> visits = visitsOf({patrol()}, 2, 160);
        QCOMPARE(visits, (std::vector<std::vector<double>>{{160, 500}, {400, 900}}));
    }

    void planWithoutLaterVisitsIsNoPatrol()
    {
        UavPlan plan = patrol();
        plan.laterVisits.clear();
        const std::vector<std::vector<double>> visits = visitsOf({plan}, 2, 0);
        QCOMPARE(visits, std::vector<std::vector<double>>(2));
        QVERIFY(!longestGap(visits, std::vector<Track>(2)));
    }

    void longestGapBeginsWithTheLastSighting()
    {
        const std::vector<std::vector<double>> visits = visitsOf({patrol()}, 2, 0);
        std::vector<Track> tracks(2);
        QCOMPARE(longestGap(visits, tracks), (RevisitGap{.iceberg = 1, .gap_s = 500}));
        tracks[0].seen_s = -450;
        QCOMPARE(longestGap(visits, tracks), (RevisitGap{.iceberg = 0, .gap_s = 610}));
    }
};

QTEST_APPLESS_MAIN(TestPlannedVisits)
#include "tst_planned_visits.moc"
