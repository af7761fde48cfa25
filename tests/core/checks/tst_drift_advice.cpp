#include "core/base/random.h"
#include "core/checks/drift_advice.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/finding_message.h"

#include <QTest>

#include <string>

using namespace berg;
using test::messageOf;

/** Messages about drift before the icebergs are seen. */
class TestDriftAdvice : public QObject
{
    Q_OBJECT

private slots:
    /**
     * Compares with 40,000 random points; the standard deviation of the share is at most 0.0025.
     */
    void chanceOfBeingInView_data()
    {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("sd_m");
        for (const double sd_m : {50.0, 200.0, 1000.0}) {
            QTest::addRow("rectangle, %g m", sd_m) << static_cast<int>(FovShape::Body) << sd_m;
            QTest::addRow("disk, %g m", sd_m) << static_cast<int>(FovShape::Disk) << sd_m;
        }
    }
    void chanceOfBeingInView()
    {
        QFETCH(int, shape);
        QFETCH(double, sd_m);
        const SensorSpec sensor{.fov_m = {400, 700}, .shape = static_cast<FovShape>(shape)};
        const FieldOfView view(sensor, Point::Zero(), 0);
        Random random(5, 5);
        constexpr int kDraws = 40'000;
        int seen = 0;
        for (int i = 0; i < kDraws; ++i) {
            const double x_m = sd_m * random.normal();
            seen += view.contains({x_m, sd_m * random.normal()}) ? 1 : 0;
        }
        COMPARE_NEAR(chanceInView(sensor, sd_m), static_cast<double>(seen) / kDraws, 0.0075);
        QCOMPARE(chanceInView(sensor, 0), 1.0);
        // 50 m aside in any direction makes the view smaller by that on each side.
        QCOMPARE(chanceInView(sensor, sd_m, 50),
                 chanceInView({.fov_m = {300, 600}, .shape = sensor.shape}, sd_m));
        QCOMPARE(chanceInView(sensor, sd_m, 1000), 0.0);
    }

    void icebergsSeenLongAgoAreReported()
    {
        Scenario scenario = withFittedDrift(randomScenario(3));
        scenario.icebergs[2].observed_s = 900; // 135 m
        QVERIFY(messageOf(scenario, IssueId::SeenLongAgo).empty());
        // 2 x 0.15^2 x 36000^2 x (t/T - 1 + exp(-t/T)) m^2 with t/T = 0.2, times 2.4477^2.
        scenario.icebergs[2].observed_s = 7200;
        QCOMPARE(messageOf(scenario, IssueId::SeenLongAgo),
                 std::string("2:00 h before the start; the iceberg may be 2600 m from this "
                             "position, 4 times the field of view"));
    }

    /** With a round of minutes nothing is lost, with one of an hour half of the icebergs. */
    void theNextVisitIsForetold()
    {
        Scenario scenario = withFittedDrift(randomScenario(3));
        QVERIFY(messageOf(scenario, IssueId::OutOfViewNext).empty());
        scenario.duration_s = 20'000;
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.position_m *= 5;
        QCOMPARE(messageOf(scenario, IssueId::OutOfViewNext),
                 std::string("with these drifts and a round of 52 minutes, 6 of 12 icebergs will "
                             "be out of view at the next visit"));
        scenario.observer.model = ObserverModel::Simple;
        QVERIFY(messageOf(scenario, IssueId::OutOfViewNext).empty());
    }
};

QTEST_APPLESS_MAIN(TestDriftAdvice)
#include "tst_drift_advice.moc"
