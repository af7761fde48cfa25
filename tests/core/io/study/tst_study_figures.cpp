#include "core/io/study/study_figures.h"

#include <QtTest>

using namespace berg;

namespace {

/** Tau 0, 1 and 2, then the other policies, with these zeta by case and setting. */
Study studyOf(StudySpec spec, const std::vector<std::vector<double>>& zeta_m2s)
{
    Study study;
    spec.random = static_cast<int>(zeta_m2s.size());
    study.spec = std::move(spec);
    for (const std::vector<double>& oneCase : zeta_m2s)
        for (const double zeta : oneCase)
            study.outcomes.emplace_back(MissionOutcome{.metrics = {.zeta_m2s = zeta}});
    return study;
}

StudySummary fourCases()
{
    const StudySpec spec{.taus = {0, 1, 2}, .policies = {PolicyKind::Visitation, PolicyKind::Path}};
    return summarise(
        studyOf(spec,
                {{100, 80, 90, 110}, {200, 160, 150, 190}, {120, 100, 104, 100}, {90, 95, 99, 70}}),
        1);
}

/** Every policy and 41 values of tau, three cases. */
StudySummary everything()
{
    StudySpec spec;
    spec.policies.clear();
    for (const PolicyTraits& traits : kPolicyTable)
        spec.policies.push_back(traits.kind);
    spec.taus.clear();
    for (int k = 0; k <= 40; ++k)
        spec.taus.push_back(k / 10.0);
    std::vector<std::vector<double>> zeta_m2s(3);
    for (std::size_t c = 0; c < zeta_m2s.size(); ++c)
        for (std::size_t s = 0; s < settingsOf(spec).size(); ++s)
            zeta_m2s[c].push_back(1e5 + 1e3 * static_cast<double>((7 * s + 5 * c) % 11));
    return summarise(studyOf(spec, zeta_m2s), 0);
}

const PlotLine& lineOf(const Figure& figure, const std::string& key)
{
    return *std::ranges::find(figure.lines, key, &PlotLine::key);
}

std::vector<double> heightsOf(const PlotLine& line)
{
    std::vector<double> heights;
    for (const PlotPoint& point : line.points)
        heights.push_back(point.y);
    return heights;
}

} // namespace

class TestStudyFigures : public QObject
{
    Q_OBJECT

private slots:
    void zetaHasCurveBandAndPolicies()
    {
        const Figure figure = zetaFigure(fourCases(), {}, 800);
        QCOMPARE(heightsOf(lineOf(figure, "mean")), (std::vector{127.5, 108.75, 110.75}));
        QCOMPARE(heightsOf(lineOf(figure, "median"))[1], 97.5);
        QCOMPARE(figure.areas.size(), std::size_t{1});
        QCOMPARE(figure.items.size(), std::size_t{4});
        QCOMPARE(figure.items.back().at.y, 117.5);
        QCOMPARE(figure.items.back().readout.front(), std::string("path"));
        QCOMPARE(figure.labels.size(), std::size_t{2});
        QCOMPARE(figure.labels.back().end.y, (80 + 150 + 100 + 90) / 4.0); // best tau of each case
        QVERIFY(figure.rightTitles.back().find("τ = 1") != std::string::npos);
    }

    void tausAreDrawnInOrder()
    {
        const StudySpec spec{.taus = {2, 0.5, 1},
                             .policies = {PolicyKind::Visitation, PolicyKind::Path}};
        const Figure figure = zetaFigure(summarise(studyOf(spec, {{3, 2, 1, 4}}), 0), {}, 800);
        QCOMPARE(heightsOf(lineOf(figure, "mean")), (std::vector{2.0, 1.0, 3.0}));
        QCOMPARE(figure.items.front().id, std::size_t{1});
        QVERIFY(figure.areas.empty());                  // one case has no spread
        QCOMPARE(figure.labels.size(), std::size_t{1}); // its best tau is the lowest point
    }

    /** Every mark has the readout of its setting as a tooltip, in reports as in the window. */
    void marksHaveReadouts()
    {
        const Figure figure = zetaFigure(fourCases(), {}, 800);
        QCOMPARE(figure.marks.size(), std::size_t{5}); // the ring of the reference has none
        QCOMPARE(figure.marks.front().tip, std::string("τ = 0, mean 127.5, median 110.0, "
                                                       "quartiles 97.50 to 140.0, "
                                                       "+16.2 % vs τ = 1"));
    }

    void narrowFigureMarksTheLowestTauOnly()
    {
        const StudySummary all = everything();
        const std::size_t policies = kPolicyTable.size() - 1;
        QCOMPARE(zetaFigure(all, {}, 1500).marks.size(), 41 + policies + 1);
        QCOMPARE(zetaFigure(all, {}, 400).marks.size(), 1 + policies + 1);
    }

    void differencesHavePoliciesFirst()
    {
        const StudySummary summary = fourCases();
        const std::vector<std::size_t> rows = differenceRows(summary, 10);
        QCOMPARE(rows, (std::vector<std::size_t>{3, 0, 1, 2}));
        const Figure figure = differenceFigure(summary, rows, {});
        QCOMPARE(figure.items[0].at.x, 100 * ((30.0 / 80 + 30.0 / 160 + 0 - 25.0 / 95) / 4));
        QVERIFY(figure.x.least < figure.items[0].at.x);
        QCOMPARE(figure.items[2].at.x, 0.0);
        QCOMPARE(figure.items[2].readout.back(), std::string("the reference"));
        QCOMPARE(figure.items[0].readout[3], std::string("less in 1 of 4 cases"));
    }

    void manyTausAreThinned()
    {
        const StudySummary summary = everything();
        for (const std::size_t most : {8UL, 12UL, 20UL, 47UL}) {
            const std::vector<std::size_t> rows = differenceRows(summary, most);
            QVERIFY(rows.size() <= std::max<std::size_t>(most, 9));
            QVERIFY(std::ranges::count(rows, summary.reference) == 1);
        }
        QCOMPARE(differenceRows(summary, 60).size(), std::size_t{47});
    }

    void studyWithoutCasesHasNamesOnly()
    {
        QVERIFY(differenceRows({}, 10).empty());
        for (const Figure& figure :
             {zetaFigure({}, {}, 800), differenceFigure({}, {}, {}), bestTauFigure({}, {})}) {
            QVERIFY(!figure.name.empty());
            QVERIFY(figure.lines.empty() && figure.items.empty());
        }
    }
};

QTEST_APPLESS_MAIN(TestStudyFigures)
#include "tst_study_figures.moc"
