#include "core/study/study_summary.h"

#include <QTest>

using namespace berg;

/** Policy coverage achieves less zeta than the paper's strategy at tau = 1. */
class TestCoverageGain : public QObject
{
    Q_OBJECT

private slots:
    void beatsThePaper()
    {
        Study study{.spec = {.random = 30,
                             .firstSeed = 301,
                             .taus = {1},
                             .policies = {PolicyKind::Visitation, PolicyKind::Coverage}}};
        QVERIFY(fly(study));
        const PairedDifference gain = summarise(study, 0).differences.at(1);
        const double mean = gain.relative.mean;
        const double worst = gain.worst;
        qInfo("mean %.2f %%, worst %.2f %%", 100 * mean, 100 * worst);
        QVERIFY(mean < -0.12);
        QVERIFY(worst < 0);
    }

    void threadsDoNotMatter()
    {
        const StudySpec spec{
            .random = 3, .field = {.icebergs = 6}, .policies = {PolicyKind::Coverage}};
        Study one{.spec = spec};
        Study four{.spec = spec};
        QVERIFY(fly(one, {.threads = 1}));
        QVERIFY(fly(four, {.threads = 4}));
        QVERIFY(one == four);
    }
};

QTEST_APPLESS_MAIN(TestCoverageGain)
#include "tst_coverage_gain.moc"
