#include "core/plan/policy/policy.h"
#include "core/study/study_summary.h"

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

StudySpec paperSpec(double dt_s)
{
    StudySpec spec;
    for (int seed = 1; seed <= kScenarios; ++seed) {
        spec.scenarios.push_back(randomScenario(seed));
        spec.scenarios.back().dt_s = dt_s;
    }
    return spec;
}

StudySummary flown(const StudySpec& spec)
{
    Study study{.spec = spec};
    fly(study);
    return summarise(study, 0);
}

const SettingSummary* rowOf(const StudySummary& summary, const Reference& reference)
{
    for (const SettingSummary& row : summary.settings)
        if (row.setting.policy == reference.policy && row.setting.tau.value_or(0) == reference.tau)
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
        StudySpec spec = paperSpec(0.1);
        spec.taus = {0, 0.5, 1, 1.5, 3, 5};
        spec.policies = {PolicyKind::Visitation, PolicyKind::Path, PolicyKind::Tour,
                         PolicyKind::Latency};
        m_summary = flown(spec);
        QCOMPARE(m_summary.cases.size(), std::size_t{kScenarios});
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
        const SettingSummary* row = rowOf(m_summary, reference);
        QVERIFY(row != nullptr);
        QCOMPARE(row->zeta_m2s.n, kScenarios);
        const double allowed_m2s = 3 * std::sqrt(2.0) * row->zeta_m2s.standardError;
        QVERIFY2(std::abs(row->zeta_m2s.mean - reference.mean_m2s) <= allowed_m2s,
                 qPrintable(QString("%1 against %2, allowed %3")
                                .arg(row->zeta_m2s.mean)
                                .arg(reference.mean_m2s)
                                .arg(allowed_m2s)));
    }

    /** "A high value for tau will result in the UAV being stuck in a loop between two points." */
    void highTauGetsStuck()
    {
        for (const Reference& reference : kReference) {
            if (reference.stuckShare < 0)
                continue;
            const double share = rowOf(m_summary, reference)->stuckShare;
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
            return rowOf(m_summary, {PolicyKind::Visitation, tau, 0, 0})->zeta_m2s.mean;
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
        const double tauOne = rowOf(m_summary, {PolicyKind::Visitation, 1, 0, 0})->zeta_m2s.mean;
        const double latency = rowOf(m_summary, {PolicyKind::Latency, 0, 0, 0})->zeta_m2s.mean;
        const double difference = latency / tauOne - 1;
        QVERIFY2(std::abs(difference + 0.054) < 0.015, qPrintable(QString::number(difference)));
    }

    /** Halving the time step moves the mean by under 0.6 %, single cases may flip a decision. */
    void timeStepHardlyMatters()
    {
        StudySpec spec = paperSpec(0.05);
        spec.taus = {1};
        spec.policies = {PolicyKind::Visitation};
        const StudySummary fine = flown(spec);
        const double coarse = rowOf(m_summary, {PolicyKind::Visitation, 1, 0, 0})->zeta_m2s.mean;
        const double difference = fine.settings.at(0).zeta_m2s.mean / coarse - 1;
        QVERIFY2(std::abs(difference) < 0.006, qPrintable(QString::number(difference)));
    }

private:
    StudySummary m_summary;
};

QTEST_APPLESS_MAIN(TestPaperCases)
#include "tst_paper_cases.moc"
