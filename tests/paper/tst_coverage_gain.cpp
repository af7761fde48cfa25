#include "core/scenario/presets.h"
#include "core/study/study.h"

#include <QTest>

#include <algorithm>

using namespace berg;

/** What the policy coverage is for: less zeta than the paper's strategy at tau = 1. */
class TestCoverageGain : public QObject
{
    Q_OBJECT

private slots:
    void beatsThePaper()
    {
        SweepSpec spec{.taus = {1}, .policies = {PolicyKind::Visitation, PolicyKind::Coverage}};
        for (int seed = 301; seed <= 330; ++seed)
            spec.scenarios.push_back(randomScenario(seed));
        const SweepResult result = sweep(spec, {});
        double sum = 0;
        double worst = -1;
        for (std::size_t i = 0; i < spec.scenarios.size(); ++i) {
            const double change = result.rows[1].zeta_m2s[i] / result.rows[0].zeta_m2s[i] - 1;
            sum += change;
            worst = std::max(worst, change);
        }
        const double mean = sum / static_cast<double>(spec.scenarios.size());
        qInfo("mean %.2f %%, worst %.2f %%", 100 * mean, 100 * worst);
        QVERIFY(mean < -0.12);
        QVERIFY(worst < 0);
    }

    void threadsDoNotMatter()
    {
        SweepSpec spec{.policies = {PolicyKind::Coverage}, .options = {.workLimit = 20'000}};
        for (int seed = 1; seed <= 6; ++seed)
            spec.scenarios.push_back(randomScenario(seed));
        const SweepResult one = sweep(spec, {.threads = 1});
        const SweepResult four = sweep(spec, {.threads = 4});
        QVERIFY(one.rows[0].zeta_m2s == four.rows[0].zeta_m2s);
    }
};

QTEST_APPLESS_MAIN(TestCoverageGain)
#include "tst_coverage_gain.moc"
