#include "core/mission/mission.h"
#include "core/mission/revisit_intervals.h"
#include "core/presets/presets.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

using namespace berg;

namespace {

using Rows = std::vector<std::vector<IcebergSample>>;

Rows rowsOf(const Recorder& recorder)
{
    Rows rows;
    IcebergReader reader = recorder.reader();
    for (std::size_t k = 0; k < recorder.samples().size(); ++k)
        rows.push_back(reader.at(k));
    return rows;
}

/**
 * Makes a record with one sample per second; the letters mean: v in view, - not in view, . not
 * there yet.
 */
std::pair<std::vector<Sample>, Rows> recordOf(const std::string& letters)
{
    std::vector<Sample> samples;
    Rows rows;
    double sigma_m2 = 5;
    for (const char letter : letters) {
        sigma_m2 = letter == 'v' ? 0 : sigma_m2 + 1;
        samples.push_back({.time_s = static_cast<double>(samples.size())});
        rows.push_back({{.sigma_m2 = sigma_m2, .inView = letter == 'v', .active = letter != '.'}});
    }
    return {samples, rows};
}

/**
 * Counts steps out of view of each iceberg in the flying world with another rule: the longest row
 * of steps without a sighting.
 */
struct Counted
{
    std::vector<int> longest;
    std::vector<int> total;
};

Counted countedSteps(const Scenario& scenario)
{
    Mission mission(scenario, {.record = false});
    mission.advance(0);
    const int icebergs = mission.simulation().icebergCount();
    Counted counted{.longest = std::vector<int>(static_cast<std::size_t>(icebergs)),
                    .total = std::vector<int>(static_cast<std::size_t>(icebergs))};
    std::vector<int> row(static_cast<std::size_t>(icebergs));
    while (!mission.simulation().finished()) {
        std::vector<bool> before;
        for (const IcebergIndex i : mission.simulation().icebergs())
            before.push_back(mission.simulation().track(i).inView);
        mission.advance(mission.simulation().time_s() + scenario.dt_s);
        for (const IcebergIndex i : mission.simulation().icebergs()) {
            const std::size_t at = toIndex(i);
            if (before[at] && mission.simulation().track(i).inView) {
                row[at] = 0;
                continue;
            }
            ++row[at]; // the step is unseen at one of its ends at least
            ++counted.total[at];
            counted.longest[at] = std::max(counted.longest[at], row[at]);
            if (mission.simulation().track(i).inView)
                row[at] = 0;
        }
    }
    return counted;
}

} // namespace

class TestUnseen : public QObject
{
    Q_OBJECT

private slots:
    void intervalsOfWrittenRecords_data()
    {
        QTest::addColumn<QString>("letters");
        QTest::addColumn<QList<double>>("ends");
        const auto row = [](const char* name, const char* letters, const QList<double>& ends) {
            QTest::newRow(name) << QString::fromLatin1(letters) << ends;
        };
        row("never", "------", {0, 5});
        row("always", "vvvv", {});
        row("seen once", "--v--", {0, 2, 2, 4});
        row("at both ends", "v---v", {0, 4});
        row("between sightings", "vv--vv-v", {1, 4, 5, 7});
        row("at the end", "-vv", {0, 1});
        row("lost at the last instant", "vv-", {1, 2});
        row("appears", "...---v", {3, 6});
        row("appears in view", "..vv--", {3, 5});
        row("appears at the end", "....-", {});
        row("removed", "v---..", {0, 4});
        row("removed in view", "--v..", {0, 2});
        row("one sample", "-", {});
        row("nothing", "", {});
    }

    void intervalsOfWrittenRecords()
    {
        QFETCH(QString, letters);
        QFETCH(QList<double>, ends);
        const auto [samples, rows] = recordOf(letters.toStdString());
        std::vector<UnseenInterval> expected;
        for (qsizetype k = 0; k + 1 < ends.size(); k += 2)
            expected.push_back({.from_s = ends[k], .to_s = ends[k + 1]});
        const auto unseen = unseenIntervals(samples, rows);
        QCOMPARE(unseen.size(), std::size_t(letters.isEmpty() ? 0 : 1));
        if (!unseen.empty())
            QVERIFY(unseen.front() == expected);
    }

    /** A corner of the field passed over it between two samples. */
    void fallenSigmaIsASighting()
    {
        auto [samples, rows] = recordOf("v------");
        rows[4][0].sigma_m2 = 0.3;
        const auto unseen = unseenIntervals(samples, rows);
        QVERIFY((unseen.front() == std::vector<UnseenInterval>{{0, 4}, {4, 6}}));
    }

    void longestAndTotalTimeUnseen()
    {
        const std::vector<UnseenInterval> intervals{{0, 10}, {20, 50}, {60, 90}};
        QVERIFY((unseenTime(intervals) == UnseenTime{.longest_s = 30, .total_s = 70}));
        QVERIFY((unseenTime(intervals, 25) == UnseenTime{.longest_s = 10, .total_s = 15}));
        QVERIFY(unseenTime(intervals, 0) == UnseenTime{});
        QVERIFY(unseenTime({}) == UnseenTime{});
    }

    void equalsACountOfSteps_data()
    {
        QTest::addColumn<int>("seed");
        QTest::addColumn<double>("interval_s");
        for (int seed = 1; seed <= 4; ++seed) {
            QTest::addRow("each step, seed %d", seed) << seed << 0.1;
            QTest::addRow("each second, seed %d", seed) << seed << 1.0;
        }
    }

    void equalsACountOfSteps()
    {
        QFETCH(int, seed);
        QFETCH(double, interval_s);
        Scenario scenario = randomScenario(seed);
        scenario.duration_s = 600;
        scenario.planner.policy = PolicyKind::Nearest;
        scenario.icebergs[2].position_m = scenario.uavs[0].position_m; // in view at the start
        const Counted counted = countedSteps(scenario);
        Mission mission(scenario, {.sampleInterval_s = interval_s});
        mission.advance(scenario.duration_s);
        const auto unseen =
            unseenIntervals(mission.recorder().samples(), rowsOf(mission.recorder()));
        QCOMPARE(unseen.size(), counted.longest.size());
        // If every step is sampled only rounding remains; otherwise each end may differ by an
        // interval.
        const double tolerance_s = interval_s > scenario.dt_s ? 2 * interval_s : 1e-6;
        for (std::size_t i = 0; i < unseen.size(); ++i) {
            const UnseenTime time = unseenTime(unseen[i]);
            QVERIFY(std::abs(time.longest_s - counted.longest[i] * scenario.dt_s) <= tolerance_s);
            const double ends = static_cast<double>(unseen[i].size());
            QVERIFY(std::abs(time.total_s - counted.total[i] * scenario.dt_s) <=
                    std::max(1.0, ends) * tolerance_s);
        }
    }

    /** Cutting the record equals asking for an earlier time. */
    void aCutRecordAgrees()
    {
        Scenario scenario = randomScenario(7);
        scenario.duration_s = 300;
        scenario.planner.policy = PolicyKind::Nearest;
        scenario.icebergs[1].appears_s = 77;
        Mission mission(scenario);
        mission.advance(scenario.duration_s);
        const std::vector<Sample>& samples = mission.recorder().samples();
        const Rows rows = rowsOf(mission.recorder());
        const auto whole = unseenIntervals(samples, rows);
        for (std::size_t count = 1; count <= samples.size(); count += 7) {
            const auto cut = unseenIntervals({samples.data(), count}, {rows.data(), count});
            for (std::size_t i = 0; i < cut.size(); ++i)
                QVERIFY(unseenTime(cut[i]) == unseenTime(whole[i], samples[count - 1].time_s));
        }
    }
};

QTEST_APPLESS_MAIN(TestUnseen)
#include "tst_revisit_intervals.moc"
