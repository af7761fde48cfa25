#include "core/world/world.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

using namespace berg;

/** The true state: time and positions of icebergs. */
class TestWorld : public QObject
{
    Q_OBJECT

private slots:
    void wholeSecondsAreEverySoManySteps_data()
    {
        QTest::addColumn<double>("dt_s");
        QTest::addColumn<int>("stepsPerSecond");
        QTest::newRow("tenths") << 0.1 << 10;
        QTest::newRow("no part of a second") << 0.3 << 3;
        QTest::newRow("a second") << 1.0 << 1;
        QTest::newRow("longer") << 2.0 << 1;
    }
    /** Whole seconds are counted in single steps and in the jumps of a replay. */
    void wholeSecondsAreEverySoManySteps()
    {
        QFETCH(double, dt_s);
        QFETCH(int, stepsPerSecond);
        Scenario scenario = test::emptySea();
        scenario.dt_s = dt_s;
        World world(scenario);
        QVERIFY(world.isWholeSecond());
        for (int step = 1; step <= 25; ++step) {
            world.tick();
            QCOMPARE(world.isWholeSecond(), step % stepsPerSecond == 0);
            World later(scenario);
            later.goTo(step);
            QCOMPARE(later.isWholeSecond(), world.isWholeSecond());
            later.tick();
            QCOMPARE(later.isWholeSecond(), (step + 1) % stepsPerSecond == 0);
        }
    }
};

QTEST_APPLESS_MAIN(TestWorld)
#include "tst_world.moc"
