#include "core/presets/presets.h"
#include "core/study/statistics.h"
#include "core/study/zeta_prediction.h"
#include "tests/support/approx.h"

#include <QTest>

using namespace berg;

namespace {

Scenario shortFlight()
{
    Scenario scenario = randomScenario(2, {.icebergs = 3});
    scenario.duration_s = 120;
    scenario.planner.policy = PolicyKind::Nearest;
    return scenario;
}

} // namespace

class TestZetaPrediction : public QObject
{
    Q_OBJECT

private slots:
    /** The 5th percentile of the values 1 to 21 is the second value, the 95th the last but one. */
    void meanAndRange()
    {
        std::vector<double> drawn_m2s;
        for (int zeta = 21; zeta > 0; --zeta)
            drawn_m2s.push_back(zeta);
        const ZetaPrediction prediction = predictionOf(drawn_m2s);
        COMPARE_NEAR(prediction.mean_m2s, 11, 1e-12);
        COMPARE_NEAR(prediction.least_m2s, 2, 1e-12);
        COMPARE_NEAR(prediction.most_m2s, 20, 1e-12);
    }

    /** The prediction does not depend on the number of threads. */
    void isThatOfTheDrawnFlights()
    {
        const Scenario scenario = shortFlight();
        std::vector<double> drawn_m2s;
        for (int flight = 0; flight < kDrawnFlights; ++flight)
            drawn_m2s.push_back(drawnZeta_m2s(scenario, PolicyKind::Nearest, flight).value());
        QVERIFY(predictZeta(scenario) == predictionOf(drawn_m2s));
        QVERIFY(predictZeta(scenario, {.threads = 1}) == predictionOf(drawn_m2s));
    }

    void canBeStopped()
    {
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!predictZeta(shortFlight(), {.stop = stop.get_token()}));
    }
};

QTEST_APPLESS_MAIN(TestZetaPrediction)
#include "tst_zeta_prediction.moc"
