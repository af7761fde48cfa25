#include "core/base/solving_guard.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"

#include <QtTest>

#include <stdexcept>
#include <thread>

using namespace berg;

class TestSolvingGuard : public QObject
{
    Q_OBJECT

private slots:
    void forbidsPlanningAndFlyingOnItsThread()
    {
        const Scenario scenario = randomScenario(1, {.icebergs = 3});
        Mission mission(scenario);
        {
            const NoBlockingScope guard;
            QVERIFY_THROWS_EXCEPTION(std::logic_error, mission.advance(1));
            QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)planFromStart(scenario));
            QCOMPARE(mission.simulation().time_s(), 0.0);
        }
        QCOMPARE(mission.advance(1), AdvanceStatus::Reached);
    }

    void endsWithTheLastOne()
    {
        const NoBlockingScope outer;
        {
            const NoBlockingScope inner;
        }
        QVERIFY_THROWS_EXCEPTION(std::logic_error, requireSolvingAllowed());
    }

    void otherThreadsAreFree()
    {
        const NoBlockingScope guard;
        double flown_s = 0;
        std::thread([&flown_s] {
            Mission mission(randomScenario(1, {.icebergs = 3}));
            mission.advance(2);
            flown_s = mission.simulation().time_s();
        }).join();
        QCOMPARE(flown_s, 2.0);
    }
};

QTEST_APPLESS_MAIN(TestSolvingGuard)
#include "tst_solving_guard.moc"
