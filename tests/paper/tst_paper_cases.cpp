#include "core/plan/names.h"
#include "core/scenario/presets.h"
#include "core/study/study.h"

#include <QtTest>

#include <cmath>

using namespace berg;

namespace {

constexpr int kScenarios = 200;

/**
 * Mean zeta of 200 random scenarios of Table 3 as an independent implementation of the same model
 * measured it, m^2 s. Its scenarios were drawn independently of ours, so its standard error is as
 * large as ours and the two means may differ by three combined standard errors.
 */
struct Reference
{
    PolicyKind policy;
    double tau;
    double mean_m2s;
    double stuckShare;
};

constexpr Reference kReference[] = {
    {PolicyKind::Visitation, 0, 113.5e3, 0.025}, {PolicyKind::Visitation, 0.5, 86.1e3, 0},
    {PolicyKind::Visitation, 1, 84.4e3, 0},      {PolicyKind::Visitation, 1.5, 87.2e3, 0.025},
    {PolicyKind::Visitation, 3, 115.0e3, 0.30},  {PolicyKind::Visitation, 5, 147.8e3, 0.50},
    {PolicyKind::Path, 0, 83.8e3, -1},           {PolicyKind::Tour, 0, 82.2e3, -1},
};

SweepSpec paperSpec(double dt_s)
{
    SweepSpec spec;
    for (int seed = 1; seed <= kScenarios; ++seed) {
        spec.scenarios.push_back(randomScenario(seed));
        spec.scenarios.back().dt_s = dt_s;
    }
    return spec;
}

const SweepRow* rowOf(const SweepResult& result, const Reference& reference)
{
    for (const SweepRow& row : result.rows)
        if (row.policy == reference.policy && row.tau.value_or(0) == reference.tau)
            return &row;
    return nullptr;
}

} // namespace

class TestPaperCases : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        SweepSpec spec = paperSpec(0.1);
        spec.taus = {0, 0.5, 1, 1.5, 3, 5};
        spec.policies = {PolicyKind::Visitation, PolicyKind::Path, PolicyKind::Tour,
                         PolicyKind::Latency};
        m_result = sweep(spec, {});
        QVERIFY(m_result.complete);
    }

    void meanZeta_data()
    {
        QTest::addColumn<int>("index");
        for (int i = 0; i < static_cast<int>(std::size(kReference)); ++i)
            QTest::addRow("%s tau %g", nameOf(kPolicyNames, kReference[i].policy).c_str(),
                          kReference[i].tau)
                << i;
    }
    void meanZeta()
    {
        QFETCH(int, index);
        const Reference& reference = kReference[index];
        const SweepRow* row = rowOf(m_result, reference);
        QVERIFY(row != nullptr);
        QCOMPARE(row->summary.n, kScenarios);
        const double allowed_m2s = 3 * std::sqrt(2.0) * row->summary.standardError;
        QVERIFY2(std::abs(row->summary.mean - reference.mean_m2s) <= allowed_m2s,
                 qPrintable(QString("%1 against %2, allowed %3")
                                .arg(row->summary.mean)
                                .arg(reference.mean_m2s)
                                .arg(allowed_m2s)));
    }

    /** "A high value for tau will result in the UAV being stuck in a loop between two points." */
    void highTauGetsStuck()
    {
        for (const Reference& reference : kReference) {
            if (reference.stuckShare < 0)
                continue;
            const double share = rowOf(m_result, reference)->stuckShare;
            // Three binomial standard deviations of the difference, and one case for shares of 0.
            const double p = reference.stuckShare;
            const double allowed = 3 * std::sqrt(2 * p * (1 - p) / kScenarios) + 1.0 / kScenarios;
            QVERIFY2(std::abs(share - p) <= allowed,
                     qPrintable(QString("tau %1: %2").arg(reference.tau).arg(share)));
        }
    }

    /** Section 6 of the paper: tau = 1 is a good choice; at the ends of the range it is not. */
    void tauOneIsGood()
    {
        const auto mean = [&](double tau) {
            return rowOf(m_result, {PolicyKind::Visitation, tau, 0, 0})->summary.mean;
        };
        for (const double tau : {0.0, 0.5, 1.5, 3.0, 5.0})
            QVERIFY(mean(1) < mean(tau));
    }

    /**
     * Paired, on the same icebergs and noise; an independent implementation measured 5.4 % less
     * than tau = 1. Two standard errors of such a difference are about a point.
     */
    void latencyIsBetterThanTauOne()
    {
        const double tauOne = rowOf(m_result, {PolicyKind::Visitation, 1, 0, 0})->summary.mean;
        const double latency = rowOf(m_result, {PolicyKind::Latency, 0, 0, 0})->summary.mean;
        const double difference = latency / tauOne - 1;
        QVERIFY2(std::abs(difference + 0.054) < 0.015, qPrintable(QString::number(difference)));
    }

    /** Halving the time step moves the mean by under 0.6 %, single cases may flip a decision. */
    void timeStepHardlyMatters()
    {
        SweepSpec spec = paperSpec(0.05);
        spec.taus = {1};
        spec.policies = {PolicyKind::Visitation};
        const SweepResult fine = sweep(spec, {});
        const double coarse = rowOf(m_result, {PolicyKind::Visitation, 1, 0, 0})->summary.mean;
        const double difference = fine.rows.at(0).summary.mean / coarse - 1;
        QVERIFY2(std::abs(difference) < 0.006, qPrintable(QString::number(difference)));
    }

private:
    SweepResult m_result;
};

QTEST_APPLESS_MAIN(TestPaperCases)
#include "tst_paper_cases.moc"
