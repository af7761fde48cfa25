#include "tests/support/window/panel_test.h"
#include "tests/support/window/study_builder.h"
#include "widgets/charts/study_chart.h"
#include "widgets/words/policy_words.h"

#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr PolicyKind kOthers[] = {PolicyKind::Path,    PolicyKind::Tour,
                                  PolicyKind::Nearest, PolicyKind::Uncertainty,
                                  PolicyKind::Latency, PolicyKind::Coverage};

/** Every policy and 41 values of tau, three cases. */
StudyPointer everything()
{
    StudySpec spec{.name = "Everything", .policies = {PolicyKind::Visitation}};
    spec.policies.insert(spec.policies.end(), std::begin(kOthers), std::end(kOthers));
    for (int k = 0; k <= 40; ++k)
        spec.taus.push_back(k / 10.0);
    std::vector<std::vector<double>> zeta_m2s(3);
    for (std::size_t c = 0; c < zeta_m2s.size(); ++c)
        for (std::size_t s = 0; s < settingsOf(spec).size(); ++s)
            zeta_m2s[c].push_back(1e5 + 1e3 * static_cast<double>((7 * s + 5 * c) % 11));
    return test::studyOf(spec, zeta_m2s);
}

struct ShownStudyChart
{
    StudyChart chart;
    explicit ShownStudyChart(StudyFigureKind kind = StudyFigureKind::Zeta,
                             const StudyPointer& result = test::fourCases(),
                             const QSize& size = {760, 360})
        : chart(kind, Theme::light())
    {
        chart.setLocale(QLocale::c());
        chart.resize(size);
        chart.show();
        chart.setResult(result);
    }
};

QStringList readoutOf(const FigureView& chart, std::size_t setting)
{
    QStringList lines;
    for (const DrawnItem& item : chart.drawing().items)
        if (item.of.id == setting)
            for (const std::string& line : item.of.readout)
                lines << QString::fromStdString(line);
    return lines;
}

} // namespace

class TestStudyChart : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void nothingFlownTeaches()
    {
        const ShownStudyChart zeta(StudyFigureKind::Zeta, nullptr);
        QVERIFY(zeta.chart.drawing().items.empty());
        QVERIFY(!zeta.chart.accessibleDescription().isEmpty());
        const ShownStudyChart differences(StudyFigureKind::Differences, nullptr);
        QVERIFY(differences.chart.drawing().items.empty());
        QVERIFY(differenceRows(StudySummary(), 10).empty());
    }

    void lessIsLowerAndTauGoesRight()
    {
        const ShownStudyChart f;
        const PlotScale& x = f.chart.drawing().x;
        const PlotScale& y = f.chart.drawing().y;
        QVERIFY(y.at(100) > y.at(120));
        QVERIFY(x.at(2) > x.at(1));
        QCOMPARE(f.chart.drawing().items.size(), std::size_t{4});
        QCOMPARE(f.chart.drawing().items[1].at.x, x.at(1));
        QCOMPARE(f.chart.drawing().items[1].at.y, y.at(108.75));
        QVERIFY(f.chart.drawing().items[3].at.x > x.at(2)); // policies beside it
    }

    void policiesAreNamedBesideTheirLines()
    {
        const ShownStudyChart f;
        QStringList names;
        for (const DrawnLabel& label : f.chart.drawing().labels)
            names << QString::fromStdString(label.text);
        QCOMPARE(names, (QStringList{u"Shortest path"_s, u"Best τ of each case"_s}));
    }

    void readoutHasNameMeanAndDifference()
    {
        const ShownStudyChart f;
        QCOMPARE(
            readoutOf(f.chart, 0),
            (QStringList{u"τ 0.00"_s, u"mean 127.5, median 110.0"_s, u"quartiles 97.50 to 140.0"_s,
                         u"+16.2 % vs τ 1.00"_s, u"stuck in 1 of 4 cases"_s}));
        QCOMPARE(readoutOf(f.chart, 1).size(), 4); // the reference is not compared with itself
        const ShownStudyChart d(StudyFigureKind::Differences);
        QCOMPARE(readoutOf(d.chart, 1).back(), u"the reference"_s);
        QVERIFY(readoutOf(d.chart, 0).contains(u"+16.2 % vs τ 1.00"_s));
        QVERIFY(readoutOf(d.chart, 3).contains(u"less in 1 of 4 cases"_s));
    }

    void arrowsWalkThroughTheSettings()
    {
        ShownStudyChart f;
        QSignalSpy chosen(&f.chart, &FigureView::itemChosen);
        QSignalSpy activated(&f.chart, &FigureView::itemActivated);
        f.chart.setFocus();
        QTest::keyClick(&f.chart, Qt::Key_Right);
        QTest::keyClick(&f.chart, Qt::Key_Right);
        QCOMPARE(*f.chart.chosen(), std::size_t{1});
        QTest::keyClick(&f.chart, Qt::Key_End);
        QCOMPARE(*f.chart.chosen(), std::size_t{3});
        QCOMPARE(chosen.count(), 3);
        QVERIFY(f.chart.accessibleDescription().startsWith(u"Shortest path"_s));
        QTest::keyClick(&f.chart, Qt::Key_Return);
        QCOMPARE(activated.front().front().value<std::size_t>(), std::size_t{3});
        QTest::keyClick(&f.chart, Qt::Key_Home);
        QCOMPARE(*f.chart.chosen(), std::size_t{0});
    }

    void clickChoosesThePointNearby()
    {
        ShownStudyChart f(StudyFigureKind::Differences);
        QSignalSpy activated(&f.chart, &FigureView::itemActivated);
        const DrawnItem item = f.chart.drawing().items.front();
        QTest::mouseClick(&f.chart, Qt::LeftButton, {}, toQt(item.at).toPoint() + QPoint(4, 3));
        QCOMPARE(activated.front().front().value<std::size_t>(), item.of.id);
        QTest::mouseClick(&f.chart, Qt::LeftButton, {}, {2, 2});
        QCOMPARE(activated.count(), 1);
    }

    void fewerSettingsForgetTheChoice()
    {
        ShownStudyChart f;
        f.chart.setChosen(3);
        f.chart.setResult(nullptr);
        QVERIFY(!f.chart.chosen());
    }

    void nothingOverlaps_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("small") << QSize(420, 200);
        QTest::newRow("as in the dock") << QSize(830, 330);
        QTest::newRow("large") << QSize(1500, 700);
    }

    void nothingOverlaps()
    {
        QFETCH(QSize, size);
        const ShownStudyChart f(StudyFigureKind::Zeta, everything(), size);
        const std::vector<DrawnLabel>& labels = f.chart.drawing().labels;
        QVERIFY(labels.size() >= 6);
        for (std::size_t a = 0; a < labels.size(); ++a) {
            QVERIFY(QRectF(f.chart.rect()).adjusted(0, -1, 0, 1).contains(toQt(labels[a].rect)));
            for (std::size_t b = a + 1; b < labels.size(); ++b)
                QVERIFY(toQt(labels[a].rect).intersected(toQt(labels[b].rect)).height() < 0.1);
        }
        for (const DrawnItem& item : f.chart.drawing().items)
            QVERIFY(f.chart.rect().contains(toQt(item.at).toPoint()));
    }

    void coloursAreSeen()
    {
        constexpr double kLineContrast = 3.0; // WCAG 2.1, 1.4.11
        for (const Theme& theme : {Theme::light(), Theme::dark()}) {
            std::vector<QColor> colours{policyColour(PolicyKind::Visitation, theme)};
            for (const PolicyKind policy : kOthers)
                colours.push_back(policyColour(policy, theme));
            for (std::size_t a = 0; a < colours.size(); ++a) {
                QVERIFY2(contrastRatio(colours[a], theme.chart) >= kLineContrast,
                         qPrintable(colours[a].name()));
                for (std::size_t b = a + 1; b < colours.size(); ++b)
                    QVERIFY(colours[a] != colours[b]);
            }
        }
    }

    void themeReachesThePicture()
    {
        ShownStudyChart f;
        const Theme dark = Theme::dark();
        f.chart.setTheme(dark);
        QCOMPARE(f.chart.grab().toImage().pixelColor(0, 0).rgb(), dark.chart.rgb());
    }
};

QTEST_MAIN(TestStudyChart)

#include "tst_study_chart.moc"
