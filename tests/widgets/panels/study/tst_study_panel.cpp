#include "core/base/solving_guard.h"
#include "core/study/paper_figures.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "tests/support/window/study_builder.h"
#include "tests/support/window/study_panel_fixture.h"
#include "widgets/charts/study_chart.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/study/study_panel.h"
#include "widgets/panels/study/study_results.h"
#include "widgets/panels/study/study_run_bar.h"
#include "widgets/panels/study/study_setup.h"
#include "widgets/panels/study/study_tables.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/policy_words.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>

using namespace berg;
using namespace Qt::StringLiterals;
using test::kPatience_ms;
using test::StudyPanelFixture;

namespace {

// Columns of the tables.
constexpr int kSettingName = 0;
constexpr int kSettingMean = 1;
constexpr int kSettingDifference = 4;
constexpr int kSettingBestIn = 6;
constexpr int kCaseZeta = 2;
constexpr int kCaseBestTau = 4;
constexpr int kCaseBest = 5;

} // namespace

class TestStudyPanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void fieldsBecomeTheSpec()
    {
        StudyPanelFixture f;
        f.setNumber(u"studyTauFrom"_s, u"0.5"_s);
        f.setNumber(u"studyTauTo"_s, u"1.5"_s);
        f.setNumber(u"studyTauStep"_s, u"0.5"_s);
        f.setNumber(u"studyRuns"_s, u"3"_s);
        f.setPolicies({u"visitation"_s, u"latency"_s, u"tour"_s});
        StudySpec spec = f.spec();
        QVERIFY((spec.scenarios == std::vector<Scenario>{test::quickScenario()}));
        QVERIFY((spec.taus == std::vector<double>{0.5, 1, 1.5}));
        QVERIFY((spec.policies == std::vector<PolicyKind>{PolicyKind::Visitation,
                                                          PolicyKind::Latency, PolicyKind::Tour}));
        QCOMPARE(spec.runs, 3);
        QCOMPARE(spec.random, 0);

        f.get<QRadioButton>(u"studyRandom"_s).setChecked(true);
        f.setNumber(u"studyCount"_s, u"25"_s);
        f.setNumber(u"studySeed"_s, u"1001"_s);
        f.setNumber(u"studyIcebergs"_s, u"20"_s);
        spec = f.spec();
        QVERIFY(spec.scenarios.empty());
        QCOMPARE(spec.random, 25);
        QCOMPARE(spec.firstSeed, std::int64_t{1001});
        QCOMPARE(spec.field.icebergs, 20);
        QVERIFY(spec.field.regime == FieldRegime::Published);
        auto& regime = f.get<QComboBox>(u"studyRegime"_s);
        QCOMPARE(regime.count(), static_cast<int>(kFieldRegimeNames.size()));
        regime.setCurrentIndex(3);
        spec = f.spec();
        QVERIFY(spec.field.regime == FieldRegime::FittedDrift);
        QVERIFY(validate(spec).empty());
    }

    void tausAreTheNumbersOneReads()
    {
        const std::vector<double> taus = tausBetween(0, 4, 0.1);
        QCOMPARE(taus.size(), std::size_t{41});
        for (int k = 0; k <= 40; ++k)
            QCOMPARE(taus[static_cast<std::size_t>(k)], k / 10.0);
        QCOMPARE(tausBetween(1, 1, 0.5).size(), std::size_t{1});
        QCOMPARE(tausBetween(0, 1, 0.3).back(), 0.9);
    }

    void specComesBackIntoTheFields()
    {
        StudyPanelFixture f;
        StudySpec spec = figure4(test::quickScenario());
        auto& setup = test::child<StudySetup>(f.panel, {});
        setup.showSpec(spec);
        spec.name = f.spec().name; // the figure has a title of its own
        QVERIFY(f.spec() == spec);
        StudySpec random{.random = 7, .firstSeed = 4, .taus = {0, 0.25, 0.5}, .runs = 2};
        random.policies = {PolicyKind::Visitation, PolicyKind::Coverage};
        random.field.icebergs = 9;
        random.field.regime = FieldRegime::Measured;
        setup.showSpec(random);
        random.name = f.spec().name;
        QVERIFY(f.spec() == random);
    }

    /** The fields cannot express these values, which stay until the fields are used. */
    void unevenTausAreRestored()
    {
        StudyPanelFixture f;
        StudySpec spec = figure4(test::quickScenario());
        spec.taus = {0, 0.1, 4};
        test::child<StudySetup>(f.panel, {}).showSpec(spec);
        QCOMPARE(f.spec().taus, spec.taus);
        f.setNumber(u"studyRuns"_s, u"3"_s);
        QCOMPARE(f.spec().taus, spec.taus);
        f.setNumber(u"studyTauStep"_s, u"2"_s);
        QCOMPARE(f.spec().taus, (std::vector<double>{0, 2, 4}));
    }

    void impossiblePoliciesAreShownBefore()
    {
        StudyPanelFixture f;
        QLabel& estimate = f.get<QLabel>(u"studyEstimate"_s);
        QVERIFY(estimate.text().startsWith(u"42 missions, "_s)); // 41 values of tau, one path
        QVERIFY(f.start().isEnabled());
        f.setPolicies({});
        QVERIFY(!f.start().isEnabled());
        QCOMPARE(estimate.text(), u"Choose at least one policy."_s);
        f.setPolicies({u"visitation"_s});
        f.setNumber(u"studyTauTo"_s, u"0"_s);
        f.setNumber(u"studyTauFrom"_s, u"2"_s);
        QVERIFY(!f.start().isEnabled());
        f.setPolicies({u"tour"_s}); // this policy has no tau
        QVERIFY(f.start().isEnabled());
        f.get<QRadioButton>(u"studyRandom"_s).setChecked(true);
        f.setNumber(u"studyCount"_s, u"100000"_s);
        f.setNumber(u"studyRuns"_s, u"100"_s);
        QVERIFY(!f.start().isEnabled());
        QVERIFY(estimate.text().contains(u"at most"_s));
        f.setNumber(u"studyRuns"_s, u"1"_s);
        QVERIFY(f.start().isEnabled());

        Scenario sea = test::quickScenario();
        sea.icebergs.clear();
        f.get<QRadioButton>(u"studyThis"_s).setChecked(true);
        f.panel.setScenario(sea);
        QVERIFY(!f.start().isEnabled());
        QVERIFY(!f.get<QPushButton>(u"figure4"_s).isEnabled());
    }

    void roughTimesAreRounded()
    {
        const QLocale c = QLocale::c();
        QCOMPARE(roughTimeText(0.2, c), u"under a second"_s);
        QCOMPARE(roughTimeText(12.3, c), u"about 10 s"_s);
        QCOMPARE(roughTimeText(185, c), u"about 3 min"_s);
        QCOMPARE(roughTimeText(2.2 * 3600, c), u"about 2.2 h"_s);
    }

    void figure4IsOneClick()
    {
        StudyPanelFixture f;
        f.get<QPushButton>(u"figure4"_s).click();
        QVERIFY(f.ends());
        QVERIFY(f.runner.result()->study.spec == figure4(test::quickScenario()));
        QCOMPARE(f.state(), u"42 missions flown."_s);
        QCOMPARE(f.get<StudyChart>(u"studyChart"_s).drawing().items.size(), std::size_t{42});
        QCOMPARE(f.column(u"studySettings"_s, kSettingName).size(), 42);
        const auto& bar = f.get<QProgressBar>(u"studyProgress"_s);
        QCOMPARE(bar.value(), bar.maximum());
    }

    /** Figure 4 is flown first, then not again. */
    void figure5AsksForTwoFlights()
    {
        StudyPanelFixture f;
        QSignalSpy compared(&f.panel, &StudyPanel::comparisonRequested);
        f.get<QPushButton>(u"figure5"_s).click();
        QVERIFY(f.ends());
        QCOMPARE(compared.count(), 1);
        const auto best = compared.front()[1].value<berg::PlannerSettings>();
        const auto tsp = compared.front()[2].value<berg::PlannerSettings>();
        QVERIFY(compared.front()[0].value<berg::Scenario>() == test::quickScenario());
        QCOMPARE(tsp.policy, PolicyKind::Path);
        QCOMPARE(best.policy, PolicyKind::Visitation);
        QCOMPARE(best.tau, *figure5(f.runner.result()->summary)->best.tau);
        f.get<QPushButton>(u"figure5"_s).click();
        QCOMPARE(compared.count(), 2);
        QVERIFY(!f.runner.isRunning());
    }

    void figure3IsElsewhere()
    {
        StudyPanelFixture f;
        QSignalSpy wanted(&f.panel, &StudyPanel::solveTimesRequested);
        f.get<QPushButton>(u"figure3"_s).click();
        QCOMPARE(wanted.count(), 1);
    }

    void cancelKeepsAndOffersToCarryOn()
    {
        StudyPanelFixture f;
        auto& carryOn = f.get<QPushButton>(u"carryOnStudy"_s);
        QVERIFY(!carryOn.isVisible());
        f.get<QRadioButton>(u"studyRandom"_s).setChecked(true);
        f.setNumber(u"studyCount"_s, u"20000"_s);
        f.start().click();
        QVERIFY(f.runner.isRunning());
        QCOMPARE(f.start().text(), u"Stop"_s);
        QVERIFY(!f.get<QToolButton>(u"openStudy"_s).isEnabled());
        QVERIFY(QTest::qWaitFor([&] { return f.state().contains(u"left"_s); }, kPatience_ms));
        f.start().click();
        QVERIFY(f.ends());
        QCOMPARE(f.start().text(), u"Start study"_s);
        QVERIFY(f.state().contains(u" of 840"_s)); // 20 000 scenarios, 42 settings
        QVERIFY(carryOn.isVisible());
        const std::size_t flownBefore = f.runner.flown();
        carryOn.click();
        QVERIFY(f.runner.isRunning());
        QVERIFY(QTest::qWaitFor([&] { return f.runner.flown() > flownBefore; }, kPatience_ms));
        f.start().click();
        QVERIFY(f.ends(2));
    }

    void settingsAreSorted()
    {
        StudyPanelFixture f;
        f.show(test::fourCases());
        auto& table = f.get<QTableView>(u"studySettings"_s);
        QCOMPARE(f.column(u"studySettings"_s, kSettingName),
                 (QStringList{u"τ 0.00"_s, u"τ 1.00"_s, u"τ 2.00"_s, u"Best τ of each case"_s,
                              u"Shortest path"_s}));
        table.sortByColumn(kSettingMean, Qt::AscendingOrder);
        QCOMPARE(f.column(u"studySettings"_s, kSettingMean),
                 (QStringList{u"105.0"_s, u"108.8"_s, u"110.8"_s, u"117.5"_s, u"127.5"_s}));
        table.sortByColumn(kSettingBestIn, Qt::DescendingOrder);
        QCOMPARE(f.column(u"studySettings"_s, kSettingName).front(), u"τ 1.00"_s);
        QCOMPARE(f.column(u"studySettings"_s, kSettingBestIn).front(), u"2"_s);
        QVERIFY(f.column(u"studySettings"_s, kSettingDifference).contains(u"reference"_s));
    }

    void settingIsTakenOver()
    {
        StudyPanelFixture f;
        f.show(test::fourCases());
        auto& use = f.get<QPushButton>(u"useStudySetting"_s);
        QVERIFY(!use.isEnabled());
        QSignalSpy wanted(&f.panel.results(), &StudyResults::settingRequested);
        const auto& chart = f.get<StudyChart>(u"studyChart"_s);
        QTest::mouseClick(&f.get<StudyChart>(u"studyChart"_s), Qt::LeftButton, {},
                          toQt(chart.drawing().items[2].at).toPoint());
        QVERIFY(use.text().startsWith(u"Use "_s));
        use.click();
        QCOMPARE(wanted.count(), 1);
        const auto setting = wanted.front().front().value<berg::StudySetting>();
        QCOMPARE(use.text(), u"Use "_s + settingText(setting, QLocale::c()));
    }

    void recommendedSettingIsTakenOver()
    {
        StudyPanelFixture f;
        auto& use = f.get<QPushButton>(u"useRecommendedSetting"_s);
        const auto& recommendation = f.get<QLabel>(u"studyRecommendation"_s);
        QVERIFY(!use.isVisible() && !recommendation.isVisible());
        f.show(test::clearWinner());
        QVERIFY(use.isVisible() && recommendation.isVisible());
        QVERIFY(recommendation.text().startsWith(u"Recommended: τ 2.00. Its ζ is −"_s));
        QVERIFY(recommendation.text().contains(u"against τ 1.00, the closest other setting"_s));
        QSignalSpy wanted(&f.panel.results(), &StudyResults::settingRequested);
        use.click();
        QCOMPARE(wanted.count(), 1);
        QVERIFY(wanted.front().front().value<berg::StudySetting>().tau == 2.0);
        QCOMPARE(use.text(), u"Use τ 2.00"_s);
    }

    void pointLeadsToItsCases()
    {
        StudyPanelFixture f;
        f.show(test::fourCases());
        auto& chart = f.get<StudyChart>(u"studyChart"_s);
        auto& open = f.get<QPushButton>(u"openStudyRun"_s);
        QVERIFY(!open.isEnabled());
        QSignalSpy opened(&f.panel.results(), &StudyResults::openRunRequested);
        QTest::mouseClick(&chart, Qt::LeftButton, {}, toQt(chart.drawing().items[2].at).toPoint());
        QCOMPARE(f.get<QTabWidget>(u"studyTables"_s).currentIndex(), 1);
        QCOMPARE(f.column(u"studyCases"_s, kCaseZeta),
                 (QStringList{u"90.00"_s, u"150.0"_s, u"104.0"_s, u"99.00"_s}));
        QCOMPARE(f.column(u"studyCases"_s, kCaseBestTau),
                 (QStringList{u"1.00"_s, u"2.00"_s, u"1.00"_s, u"0.00"_s}));
        QCOMPARE(f.column(u"studyCases"_s, kCaseBest).back(), u"Shortest path"_s);
        auto& cases = f.get<QTableView>(u"studyCases"_s);
        cases.sortByColumn(kCaseZeta, Qt::DescendingOrder);
        cases.selectRow(0); // the second case
        QVERIFY(open.isEnabled());
        open.click();
        const StudySpec& spec = f.runner.result()->study.spec;
        QVERIFY(opened.front().front().value<berg::Scenario>() ==
                scenarioOf(spec, 1, settingsOf(spec)[2]));
        cases.setFocus();
        QTest::keyClick(&cases, Qt::Key_Return);
        QCOMPARE(opened.count(), 2);
    }

    void chosenCaseStaysWhenMoreAreFlown()
    {
        StudyPanelFixture f;
        Study part = test::fourCases()->study;
        for (std::size_t k = 0; k < settingsOf(part.spec).size(); ++k)
            part.outcomes[k].reset(); // the first case
        f.runner.show(part);
        QTRY_VERIFY(f.runner.result() != nullptr);
        f.get<QTableView>(u"studySettings"_s).selectRow(2);
        auto& cases = f.get<QTableView>(u"studyCases"_s);
        cases.sortByColumn(kCaseZeta, Qt::AscendingOrder);
        const auto chosen = [&] {
            return cases.model()->index(cases.currentIndex().row(), kCaseZeta).data();
        };
        cases.selectRow(1);
        QCOMPARE(chosen().toString(), u"104.0"_s);
        f.runner.show(test::fourCases()->study);
        QTRY_COMPARE(cases.model()->rowCount(), 4);
        QCOMPARE(chosen().toString(), u"104.0"_s);
    }

    void pictureAndTableAgreeOnTheChoice()
    {
        StudyPanelFixture f;
        f.show(test::fourCases());
        auto& chart = f.get<StudyChart>(u"studyChart"_s);
        auto& table = f.get<QTableView>(u"studySettings"_s);
        table.selectRow(0);
        QCOMPARE(*chart.chosen(), std::size_t{0});
        chart.setFocus();
        QTest::keyClick(&chart, Qt::Key_Right);
        QCOMPARE(table.currentIndex().row(), 1);
        table.selectRow(3); // the best tau of each case is no setting
        QVERIFY(!chart.chosen());
    }

    void referenceIsChosen()
    {
        StudyPanelFixture f;
        f.show(test::fourCases());
        auto& combo = f.get<QComboBox>(u"studyReference"_s);
        QCOMPARE(combo.currentText(), u"τ 1.00"_s);
        combo.setCurrentIndex(3);
        emit combo.activated(3);
        QVERIFY(QTest::qWaitFor([&] { return f.runner.result()->summary.reference == 3; },
                                kPatience_ms));
        QCOMPARE(combo.currentText(), u"Shortest path"_s);
    }

    /** Nothing is offered that the sentence does not name. */
    void withoutAClearWinnerNothingIsOffered()
    {
        StudyPanelFixture f;
        f.show(test::fourCases());
        QCOMPARE(f.get<QLabel>(u"studyRecommendation"_s).text(),
                 u"No clear winner over 4 cases. These settings may be the best: τ 0.00, τ 1.00, "
                 u"τ 2.00, Shortest path."_s);
        QVERIFY(!f.get<QPushButton>(u"useRecommendedSetting"_s).isVisible());
    }

    void lowestOfOneCaseIsOffered()
    {
        StudyPanelFixture f;
        f.show(test::studyOf(test::quickStudy(1), {{100, 80, 90, 110}}));
        QVERIFY(f.get<QLabel>(u"studyRecommendation"_s).text().startsWith(u"Lowest ζ: τ 1.00."_s));
        QCOMPARE(f.get<QPushButton>(u"useRecommendedSetting"_s).text(), u"Use τ 1.00"_s);
    }

    void casesAreNamed()
    {
        StudySpec spec = test::quickStudy(2);
        spec.random = 3;
        spec.firstSeed = 10;
        QCOMPARE(studyCase(spec, 1).scenario, u"Quick"_s);
        QCOMPARE(studyCase(spec, 1).run, 1);
        QCOMPARE(studyCase(spec, 1).seed, seedOfRun(spec.scenarios.front().seed, 1));
        QCOMPARE(studyCase(spec, 4).scenario, u"Random 11"_s);
        QCOMPARE(studyCase(spec, 4).seed, std::int64_t{11});
        for (const std::size_t k : {0UL, 1UL, 2UL, 5UL, 7UL})
            QCOMPARE(studyCase(spec, k).seed, scenarioOf(spec, k, {}).seed);
    }

    void pictureIsWritten_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QByteArray>("start");
        QTest::newRow("PNG") << u"png"_s << QByteArray("\x89PNG");
        QTest::newRow("SVG") << u"svg"_s << QByteArray("<?xml");
        QTest::newRow("PDF") << u"pdf"_s << QByteArray("%PDF");
    }

    void pictureIsWritten()
    {
        QFETCH(QString, ending);
        QFETCH(QByteArray, start);
        StudyPanelFixture f;
        f.show(test::fourCases());
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"study."_s + ending);
        f.panel.results().writePicture(path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(bytes.startsWith(start));
        QVERIFY(bytes.size() > 4000);
    }

    void everythingIsNamedAndReached()
    {
        StudyPanelFixture f;
        f.show(test::fourCases());
        for (const NumberField* field : f.panel.findChildren<NumberField*>())
            QVERIFY2(!field->accessibleName().isEmpty() && !field->toolTip().isEmpty(),
                     qPrintable(field->objectName()));
        for (const QString& name : {u"studySettings"_s, u"studyCases"_s})
            QVERIFY(!f.get<QTableView>(name).accessibleName().isEmpty());
        for (const QToolButton* button : f.panel.findChildren<QToolButton*>())
            if (!button->text().isEmpty())
                QVERIFY(button->focusPolicy() & Qt::TabFocus);
    }

    void longTextsFitASmallWindow()
    {
        const test::LongerTexts longer;
        StudyPanelFixture f;
        constexpr QSize kSmall_px(1180, 720); // available size on a screen of 1280 x 800
        QVERIFY2(f.panel.minimumSizeHint().width() <= kSmall_px.width(),
                 QByteArray::number(f.panel.minimumSizeHint().width()).constData());
        QVERIFY2(f.panel.minimumSizeHint().height() <= kSmall_px.height(),
                 QByteArray::number(f.panel.minimumSizeHint().height()).constData());
    }

    void themeReachesEverything()
    {
        StudyPanelFixture f;
        const Theme dark = Theme::dark();
        f.panel.setTheme(dark);
        QCOMPARE(f.get<StudyChart>(u"studyChart"_s).grab().toImage().pixelColor(0, 0).rgb(),
                 dark.chart.rgb());
    }
};

QTEST_MAIN(TestStudyPanel)
#include "tst_study_panel.moc"
