#include "core/base/random.h"
#include "core/study/study_summary.h"
#include "tests/support/approx.h"

#include <algorithm>

using namespace berg;

namespace {

/** A study with invented outcomes. Settings: tau 0.5, 1, 2, then path. */
Study madeUp(int cases)
{
    Study study;
    study.spec = {.random = cases,
                  .taus = {0.5, 1, 2},
                  .policies = {PolicyKind::Path, PolicyKind::Visitation}};
    study.outcomes.resize(missionCount(study.spec));
    return study;
}

void setZeta(Study& study, std::size_t caseIndex, const std::vector<double>& zeta_m2s)
{
    const std::size_t settings = settingsOf(study.spec).size();
    for (std::size_t s = 0; s < zeta_m2s.size(); ++s)
        study.outcomes.at(caseIndex * settings + s) =
            MissionOutcome{.metrics = {.zeta_m2s = zeta_m2s[s]}};
}

/** Three cases with numbers to work out by hand. */
Study threeCases()
{
    Study study = madeUp(3);
    setZeta(study, 0, {110, 100, 90, 120});
    setZeta(study, 1, {190, 200, 220, 150});
    setZeta(study, 2, {400, 400, 400, 500});
    return study;
}

} // namespace

class TestStudySummary : public QObject
{
    Q_OBJECT

private slots:
    void statisticsOfEachSetting()
    {
        Study study = threeCases();
        study.outcomes[0]->metrics.visits = 4;
        study.outcomes[4]->metrics.visits = 5;
        study.outcomes[8]->metrics.visits = 9;
        study.outcomes[8]->stuck = true;
        const StudySummary summary = summarise(study, 1);
        QCOMPARE(summary.reference, std::size_t{1});
        QCOMPARE(summary.cases, (std::vector<std::size_t>{0, 1, 2}));
        QCOMPARE(summary.settings.size(), std::size_t{4});
        const SettingSummary& first = summary.settings[0];
        QVERIFY(first.setting.tau == 0.5);
        QCOMPARE(first.zeta_m2s.n, 3);
        COMPARE_NEAR(first.zeta_m2s.mean, 700.0 / 3, 1e-12);
        COMPARE_NEAR(first.zeta_m2s.median, 190, 0);
        COMPARE_NEAR(first.meanVisits, 6, 1e-15);
        COMPARE_NEAR(first.stuckShare, 1.0 / 3, 1e-15);
        const SettingSummary& last = summary.settings[3];
        QCOMPARE(last.setting, (StudySetting{.policy = PolicyKind::Path}));
        COMPARE_NEAR(last.zeta_m2s.mean, 770.0 / 3, 1e-12);
        COMPARE_NEAR(last.stuckShare, 0, 0);
    }

    /** Mean zeta: tau 0.5 and tau 1 700/3, tau 2 710/3, path 770/3; three cases decide nothing. */
    void withoutAClearWinnerAllMayBeTheBest()
    {
        const StudySummary summary = summarise(threeCases(), 1);
        QVERIFY(summary.recommendation);
        const Recommendation& found = *summary.recommendation;
        QCOMPARE(found.lowest, std::size_t{0}); // 700/3, as tau = 1; the first of a tie
        QVERIFY(!found.best);
        QVERIFY(!found.next);
        QCOMPARE(found.contenders, (std::vector<std::size_t>{0, 1, 2, 3}));
        QVERIFY(!summarise(madeUp(2), 1).recommendation);
    }

    /** Another tau of the same policy counts like any other setting. */
    void aSettingIsRecommendedThatBeatsEveryOther()
    {
        Study study = madeUp(3);
        setZeta(study, 0, {80, 100, 110, 120});
        setZeta(study, 1, {160, 201, 222, 240});
        setZeta(study, 2, {320, 400, 438, 480});
        const Recommendation found = summarise(study, 1).recommendation.value();
        QCOMPARE(found.best, std::size_t{0});
        QCOMPARE(found.next, std::size_t{1}); // closest, although of the same policy
        COMPARE_NEAR(found.relative.mean, (0.8 + 160.0 / 201 + 0.8) / 3 - 1, 1e-12);
        QCOMPARE(found.contenders, (std::vector<std::size_t>{0}));

        setZeta(study, 1, {160, 130, 222, 240}); // one case favours tau = 1
        const Recommendation open = summarise(study, 1).recommendation.value();
        QVERIFY(!open.best);
        QCOMPARE(open.contenders, (std::vector<std::size_t>{0, 1}));
    }

    /** The round tour has the lowest mean but loses to another setting case by case. */
    void theLowestMeanAloneIsNoReason()
    {
        Study study = madeUp(3);
        setZeta(study, 0, {300, 250, 260, 260});
        setZeta(study, 1, {300, 290, 280, 285});
        setZeta(study, 2, {1000, 1100, 1150, 900});
        const Recommendation found = summarise(study, 1).recommendation.value();
        QCOMPARE(found.lowest, std::size_t{3});
        QVERIFY(!found.best);
    }

    /** tau = 0 and most uncertain first often fly the same. */
    void settingsThatFlyTheSameShareTheRecommendation()
    {
        Study study = madeUp(3);
        for (std::size_t c = 0; c < 3; ++c)
            setZeta(study, c, {80.0 + double(c), 100, 110, 80.0 + double(c)});
        const Recommendation found = summarise(study, 1).recommendation.value();
        QCOMPARE(found.best, std::size_t{0});
        QCOMPARE(found.contenders, (std::vector<std::size_t>{0, 3}));
    }

    void oneCaseIsSureOfNothing()
    {
        Study study = madeUp(1);
        setZeta(study, 0, {110, 100, 90, 120});
        const Recommendation found = *summarise(study, 1).recommendation;
        QCOMPARE(found.lowest, std::size_t{2});
        QVERIFY(!found.best);
    }

    void oneSettingHasNoOther()
    {
        Study study;
        study.spec = {.random = 1, .taus = {1}, .policies = {PolicyKind::Visitation}};
        study.outcomes = {MissionOutcome{.metrics = {.zeta_m2s = 5}}};
        const Recommendation found = *summarise(study, 0).recommendation;
        QCOMPARE(found.lowest, std::size_t{0});
        QVERIFY(!found.best);
    }

    /**
     * Relative to tau = 1 the values of tau = 2 are -0.1, 0.1, 0; t(2) = 4.3027, standard error
     * 0.1/sqrt(3).
     */
    void differencesAreTakenCaseByCase()
    {
        const StudySummary summary = summarise(threeCases(), 1);
        QCOMPARE(summary.differences.size(), std::size_t{4});
        const PairedDifference& two = summary.differences[2];
        QVERIFY(two.setting.tau == 2.0);
        COMPARE_NEAR(two.relative.mean, 0, 1e-15);
        COMPARE_NEAR(two.relative.high, 4.30265272974946 * 0.1 / std::sqrt(3.0), 1e-10);
        COMPARE_NEAR(two.relative.low, -two.relative.high, 1e-15);
        COMPARE_NEAR(two.zeta_m2s.mean, 10.0 / 3, 1e-13);
        COMPARE_NEAR(two.lowerShare, 1.0 / 3, 1e-15);
        COMPARE_NEAR(two.worst, 0.1, 1e-15);
        const PairedDifference& path = summary.differences[3];
        COMPARE_NEAR(path.relative.mean, (0.2 - 0.25 + 0.25) / 3, 1e-15);
        COMPARE_NEAR(path.worst, 0.25, 1e-15);
        const PairedDifference& itself = summary.differences[1];
        QCOMPARE(itself.relative.mean, 0.0);
        QCOMPARE(itself.relative.low, 0.0);
        QCOMPARE(itself.relative.high, 0.0);
        QCOMPARE(itself.lowerShare, 0.0); // equal is not lower
    }

    /** A share of 0 does not exist: such a case counts in the absolute figures only. */
    void aReferenceOfZero()
    {
        Study study = threeCases();
        setZeta(study, 0, {110, 0, 90, 120});
        StudySummary summary = summarise(study, 1);
        COMPARE_NEAR(summary.differences[3].relative.mean, 0, 1e-15); // -0.25 and 0.25
        COMPARE_NEAR(summary.differences[3].worst, 0.25, 1e-15);
        COMPARE_NEAR(summary.differences[3].zeta_m2s.mean, (120 - 50 + 100) / 3.0, 1e-13);
        for (std::size_t c = 0; c < 3; ++c)
            setZeta(study, c, {1, 0, 0, 1});
        summary = summarise(study, 1);
        QCOMPARE(summary.differences[3].relative.mean, 0.0);
        QCOMPARE(summary.differences[3].worst, 0.0);
        COMPARE_NEAR(summary.differences[3].zeta_m2s.mean, 1, 1e-15);
    }

    void anyReference()
    {
        const StudySummary summary = summarise(threeCases(), 3);
        COMPARE_NEAR(summary.differences[1].zeta_m2s.mean, (-20 + 50 - 100) / 3.0, 1e-13);
        COMPARE_NEAR(summary.differences[3].relative.mean, 0, 0);
        COMPARE_NEAR(summary.bestTau->relative.mean, (-0.25 + 40.0 / 150 - 0.2) / 3, 1e-15);
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)summarise(threeCases(), 4));
    }

    /** Best values: 2 with 90, 0.5 with 190, and of three equal ones the smallest, 0.5 with 400. */
    void bestTauOfEachCase()
    {
        const StudySummary summary = summarise(threeCases(), 1);
        QVERIFY(summary.bestTau);
        QCOMPARE(summary.bestTau->byCase, (std::vector<double>{2, 0.5, 0.5}));
        COMPARE_NEAR(summary.bestTau->tau.mean, 1, 1e-15);
        COMPARE_NEAR(summary.bestTau->zeta_m2s.mean, 680.0 / 3, 1e-13);
        COMPARE_NEAR(summary.bestTau->relative.mean, (-0.1 - 0.05) / 3, 1e-15);
    }

    void tieOfUnorderedTaus()
    {
        Study study = madeUp(1);
        study.spec.taus = {2, 0.5, 1};
        setZeta(study, 0, {7, 7, 7, 9});
        QCOMPARE(summarise(study, 0).bestTau->byCase, (std::vector<double>{0.5}));
    }

    void oneTauIsNoChoice()
    {
        Study study = madeUp(2);
        study.spec.taus = {1};
        study.outcomes.resize(missionCount(study.spec));
        setZeta(study, 0, {1, 2});
        setZeta(study, 1, {2, 1});
        const StudySummary summary = summarise(study, 0);
        QVERIFY(!summary.bestTau);
        QCOMPARE(summary.cases.size(), std::size_t{2});
    }

    /** A case without one of the settings counts for none. */
    void incompleteCasesAreLeftOut()
    {
        Study study = madeUp(5);
        const Study three = threeCases();
        const auto at = [](std::size_t c) { return static_cast<std::ptrdiff_t>(4 * c); };
        std::copy_n(three.outcomes.begin(), 4, study.outcomes.begin() + at(0));
        std::copy_n(three.outcomes.begin() + at(1), 4, study.outcomes.begin() + at(2));
        std::copy_n(three.outcomes.begin() + at(2), 4, study.outcomes.begin() + at(4));
        setZeta(study, 1, {1, 1, 1}); // the path is missing
        const StudySummary part = summarise(study, 1);
        const StudySummary whole = summarise(three, 1);
        QCOMPARE(part.cases, (std::vector<std::size_t>{0, 2, 4}));
        QCOMPARE(part.settings[0].zeta_m2s.mean, whole.settings[0].zeta_m2s.mean);
        QCOMPARE(part.differences[3].relative.high, whole.differences[3].relative.high);
        QCOMPARE(part.bestTau->byCase, whole.bestTau->byCase);
    }

    void nothingFlown()
    {
        for (const Study& study : {madeUp(3), Study{.spec = madeUp(3).spec, .outcomes = {}}}) {
            const StudySummary summary = summarise(study, 0);
            QVERIFY(summary.cases.empty());
            QCOMPARE(summary.settings.size(), std::size_t{4});
            QCOMPARE(summary.settings[0].zeta_m2s.n, 0);
            QCOMPARE(summary.differences[1].relative.mean, 0.0);
            QCOMPARE(summary.differences[1].worst, 0.0);
            QVERIFY(!summary.bestTau);
        }
    }

    void oneCaseHasNoInterval()
    {
        Study study = madeUp(1);
        setZeta(study, 0, {110, 100, 90, 120});
        const StudySummary summary = summarise(study, 1);
        const MeanInterval& path = summary.differences[3].relative;
        COMPARE_NEAR(path.mean, 0.2, 1e-15);
        QCOMPARE(path.low, path.mean);
        QCOMPARE(path.high, path.mean);
    }

    /** There is no uncertainty: every zeta is 0, and no setting differs from another. */
    void zetaOfZero()
    {
        Study study = madeUp(2);
        setZeta(study, 0, {0, 0, 0, 0});
        setZeta(study, 1, {90, 100, 110, 120});
        const StudySummary summary = summarise(study, 1);
        COMPARE_NEAR(summary.differences[3].relative.mean, 0.1, 1e-15);
        COMPARE_NEAR(summary.bestTau->relative.mean, -0.05, 1e-15);
    }

    void usualReferences_data()
    {
        QTest::addColumn<std::vector<double>>("taus");
        QTest::addColumn<std::vector<PolicyKind>>("policies");
        QTest::addColumn<int>("expected");
        const std::vector<double> taus{0, 0.5, 1, 2};
        const std::vector<PolicyKind> both{PolicyKind::Path, PolicyKind::Visitation};
        QTest::newRow("tau = 1") << taus << both << 2;
        QTest::newRow("no tau = 1") << std::vector<double>{0, 2} << both << 0;
        QTest::newRow("policies only") << taus << std::vector{PolicyKind::Path} << 0;
    }

    void usualReferences()
    {
        QFETCH(std::vector<double>, taus);
        QFETCH(std::vector<PolicyKind>, policies);
        QFETCH(int, expected);
        const StudySpec spec{.random = 1, .taus = taus, .policies = policies};
        QCOMPARE(usualReference(spec), static_cast<std::size_t>(expected));
    }

    /** Compares with the textbook formula: sums of x and x^2, and t(19) = 2.093024 from a table. */
    void pairedIntervalByAnotherFormula()
    {
        Random random(4);
        constexpr int kCases = 20;
        Study study = madeUp(kCases);
        double sum = 0;
        double squares = 0;
        for (std::size_t c = 0; c < kCases; ++c) {
            const double base = random.uniform(1e4, 3e4);
            const double change = 0.05 + 0.02 * random.normal();
            setZeta(study, c, {base, base, base, base * (1 + change)});
            sum += change;
            squares += change * change;
        }
        const double variance = (kCases * squares - sum * sum) / (kCases * (kCases - 1.0));
        const double half = 2.093024 * std::sqrt(variance / kCases);
        const MeanInterval relative = summarise(study, 1).differences[3].relative;
        COMPARE_NEAR(relative.mean, sum / kCases, 1e-12);
        COMPARE_NEAR(relative.high, sum / kCases + half, 1e-8);
        COMPARE_NEAR(relative.low, sum / kCases - half, 1e-8);
    }

    /** Pairing matters: the same values in other pairs have the same mean but a wider interval. */
    void pairingNarrowsTheInterval()
    {
        constexpr std::size_t kCases = 12;
        Study paired = madeUp(kCases);
        Study shuffled = madeUp(kCases);
        for (std::size_t c = 0; c < kCases; ++c) {
            const double base = 1000.0 * double(c + 1);
            const double other = 1000.0 * double((c + 5) % kCases + 1);
            setZeta(paired, c, {base, base, base, base + 10 + double(c % 3)});
            setZeta(shuffled, c, {base, base, base, other + 10 + double((c + 5) % kCases % 3)});
        }
        const MeanInterval close = summarise(paired, 1).differences[3].zeta_m2s;
        const MeanInterval wide = summarise(shuffled, 1).differences[3].zeta_m2s;
        COMPARE_NEAR(close.mean, wide.mean, 1e-9);
        QVERIFY(close.high - close.low < 2);
        QVERIFY(wide.high - wide.low > 1000);
    }
};

QTEST_APPLESS_MAIN(TestStudySummary)
#include "tst_study_summary.moc"
