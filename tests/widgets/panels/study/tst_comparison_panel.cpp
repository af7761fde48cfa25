#include "core/base/solving_guard.h"
#include "tests/support/flight/fleet_flight.h"
#include "tests/support/window/comparison_builder.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/study/comparison_panel.h"
#include "widgets/panels/study/comparison_tables.h"
#include "widgets/panels/study/run_table.h"

#include <QContextMenuEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QToolButton>

using namespace berg;
using test::kPatience_ms;
using test::policy;
using namespace Qt::StringLiterals;

namespace {

struct ComparisonPanelFixture
{
    RunList list;
    ComparisonPanel panel{list};
    QTableView& runs = test::child<QTableView>(panel, u"comparedRuns"_s);
    QTableView& figures = test::child<QTableView>(panel, u"comparedFigures"_s);
    QTableView& unseen = test::child<QTableView>(panel, u"comparedIcebergs"_s);
    QPushButton& tour = test::child<QPushButton>(panel, u"compareTour"_s);
    QPushButton& cancel = test::child<QPushButton>(panel, u"cancelComparison"_s);
    QProgressBar& bar = test::child<QProgressBar>(panel, u"comparisonProgress"_s);
    NumberField& tau = test::child<NumberField>(panel, u"comparedTau"_s);
    QPushButton& fly = test::child<QPushButton>(panel, u"compareTau"_s);
    QPushButton& remove = test::child<QPushButton>(panel, u"removeComparedRun"_s);
    QLabel& state = test::child<QLabel>(panel, u"comparisonState"_s);
    QLabel& empty = test::child<QLabel>(panel, u"comparisonEmpty"_s);
    QSignalSpy finished{&list, &RunList::finished};

    explicit ComparisonPanelFixture(const QSize& size = {480, 300})
    {
        panel.setLocale(QLocale::c());
        panel.resize(size);
        panel.show();
    }
    void add(PolicyKind kind, double until_s = 1e9, int seed = 3)
    {
        list.add(test::flownRecord(test::shortScenario(seed), policy(kind), until_s));
    }
    [[nodiscard]] static QModelIndex at(const QTableView& table, int row, int column)
    {
        return table.model()->index(row, column);
    }
    [[nodiscard]] static QString text(const QTableView& table, int row, int column)
    {
        return at(table, row, column).data().toString();
    }
    [[nodiscard]] bool isBold(int row, int column) const
    {
        return at(figures, row, column).data(Qt::FontRole).value<QFont>().bold();
    }
    [[nodiscard]] int count() const { return runs.model()->rowCount(); }
    [[nodiscard]] RunMark mark(int row, int column) const
    {
        return static_cast<RunMark>(at(runs, row, column).data(Qt::UserRole).toInt());
    }
    void click(int row, int column)
    {
        const QRect cell = runs.visualRect(at(runs, row, column));
        QTest::mouseClick(runs.viewport(), Qt::LeftButton, {}, cell.center());
    }
    [[nodiscard]] bool ends() { return !finished.isEmpty() || finished.wait(kPatience_ms); }
};

} // namespace

class TestComparisonPanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void emptyPanelTeaches()
    {
        ComparisonPanelFixture f;
        QVERIFY(f.empty.isVisible());
        QVERIFY(!f.figures.isVisible());
        QVERIFY(!f.tour.isEnabled() && !f.fly.isEnabled() && !f.remove.isEnabled());
        f.panel.setScenario(test::shortScenario());
        QVERIFY(f.tour.isEnabled() && f.fly.isEnabled());
        Scenario sea = test::shortScenario();
        sea.icebergs.clear();
        f.panel.setScenario(sea);
        QVERIFY(!f.tour.isEnabled());
    }

    /** One click starts it, and nothing is solved on this thread. */
    void tourIsFlownBesideTheReference()
    {
        const FlightRecord first =
            test::flownRecord(test::shortScenario(), policy(PolicyKind::Nearest));
        const FlightRecord expected =
            test::flownRecord(test::shortScenario(), policy(PolicyKind::Tour));
        const NoBlockingScope onThisThread;
        ComparisonPanelFixture f;
        f.list.add(first);
        QVERIFY(f.tour.isVisible());
        f.tour.click();
        QVERIFY(f.bar.isVisible() && f.cancel.isVisible() && !f.tour.isVisible());
        QVERIFY(f.ends());
        QVERIFY(f.tour.isVisible() && !f.bar.isVisible());
        QCOMPARE(f.count(), 2);
        QVERIFY(f.list.other()->metrics == expected.now.metrics);
        QVERIFY(f.mark(0, RunReference) == RunMark::Chosen);
        QVERIFY(f.mark(0, RunOther) == RunMark::None);
        QVERIFY(f.mark(1, RunReference) == RunMark::Choice);
        QVERIFY(f.mark(1, RunOther) == RunMark::Chosen);
        QCOMPARE(
            f.text(f.runs, 1, RunDifference),
            percentText(expected.now.metrics.zeta_m2s, first.now.metrics.zeta_m2s, QLocale::c()));
        QVERIFY(f.text(f.runs, 0, RunDifference).isEmpty());
    }

    /** Without a run of this scenario both runs are flown. */
    void bothAreFlownFromAScenario()
    {
        ComparisonPanelFixture f;
        f.add(PolicyKind::Nearest, 60, 9); // another world
        Scenario scenario = test::shortScenario();
        scenario.planner = policy(PolicyKind::Uncertainty);
        f.panel.setScenario(scenario);
        f.tour.click();
        QVERIFY(f.ends());
        QCOMPARE(f.count(), 3);
        QCOMPARE(f.list.reference()->planner.policy, PolicyKind::Uncertainty);
        QCOMPARE(f.list.other()->planner.policy, PolicyKind::Tour);
        QVERIFY(f.mark(0, RunOther) == RunMark::None);
        QVERIFY(f.text(f.runs, 0, RunDifference).isEmpty());
    }

    void anyTauIsFlown()
    {
        ComparisonPanelFixture f;
        f.add(PolicyKind::Nearest);
        test::enter(f.tau, u"2.5"_s);
        f.fly.click();
        QVERIFY(f.ends());
        QCOMPARE(f.list.other()->planner, policy(PolicyKind::Visitation, 2.5));
    }

    void theTourIsNotComparedWithItself()
    {
        ComparisonPanelFixture f;
        f.add(PolicyKind::Tour);
        QVERIFY(!f.tour.isEnabled());
        QVERIFY(f.fly.isEnabled());
        f.add(PolicyKind::Nearest);
        QVERIFY(f.tour.isEnabled());
        f.tour.click(); // the list has it already
        QVERIFY(!f.list.isFlying());
        QCOMPARE(f.list.other()->planner.policy, PolicyKind::Tour);
    }

    void cancelComesBack()
    {
        ComparisonPanelFixture f;
        Scenario scenario = randomScenario(4, {.icebergs = 60, .size_m = {40000, 40000}});
        scenario.duration_s = 500000;
        f.panel.setScenario(scenario);
        f.tour.click();
        QVERIFY(f.cancel.isVisible());
        f.cancel.click();
        QVERIFY(f.ends());
        QVERIFY(f.tour.isVisible() && f.tour.isEnabled());
        QVERIFY(f.state.isHidden());
        QCOMPARE(f.count(), 0);
    }

    void failuresAreReported()
    {
        ComparisonPanelFixture f;
        f.list.open(u"/nowhere/a.bergrun"_s);
        QVERIFY(f.ends());
        QVERIFY(f.state.isVisible());
        QVERIFY(f.state.text().contains(u"a.bergrun"_s));
        f.panel.setScenario(test::shortScenario());
        f.tour.click();
        QVERIFY(f.state.isHidden());
        QVERIFY(f.finished.wait(kPatience_ms));
    }

    /** Runs with different numbers of UAVs are distinguished by that number. */
    void namesSayHowManyUavsThereAre()
    {
        ComparisonPanelFixture f;
        f.add(PolicyKind::Nearest, 60);
        QCOMPARE(f.text(f.runs, 0, RunName), u"Nearest first, to 01:00"_s);
        f.list.add(test::flownRecord(test::withUavs(test::shortScenario(), 2),
                                     policy(PolicyKind::Nearest), 60));
        QCOMPARE(f.text(f.runs, 0, RunName), u"Nearest first, to 01:00, one UAV"_s);
        QCOMPARE(f.text(f.runs, 1, RunName), u"Nearest first, to 01:00, 2 UAVs"_s);
    }

    void namesSayOfWhichScenarioTheyAre()
    {
        ComparisonPanelFixture f;
        f.add(PolicyKind::Nearest, 60);
        Scenario other = test::shortScenario(4);
        other.name = "Elsewhere";
        f.list.add(test::flownRecord(other, policy(PolicyKind::Nearest), 60));
        QCOMPARE(f.text(f.runs, 1, RunName), u"Nearest first, to 01:00 \u2013 Elsewhere"_s);
    }

    /** Runs may differ only at the end of their names; the tool tip has the whole name. */
    void longNamesAreCutInTheMiddle()
    {
        ComparisonPanelFixture f({260, 300});
        f.add(PolicyKind::Latency, 60);
        const QString name = f.text(f.runs, 0, RunName);
        QVERIFY(name.endsWith(u"to 01:00"_s));
        QVERIFY(f.at(f.runs, 0, RunName).data(Qt::ToolTipRole).toString().startsWith(name));
        QCOMPARE(f.runs.textElideMode(), Qt::ElideMiddle);
    }

    void clicksAndKeysChoose()
    {
        ComparisonPanelFixture f;
        f.add(PolicyKind::Nearest, 60);
        f.add(PolicyKind::Uncertainty, 60);
        f.add(PolicyKind::Path, 60);
        f.click(0, RunReference);
        QVERIFY(f.list.reference() == f.list.runs()[0]);
        f.click(1, RunOther);
        QVERIFY(f.list.other() == f.list.runs()[1]);
        f.click(2, RunName); // chooses the row and nothing else
        QVERIFY(f.list.other() == f.list.runs()[1]);
        QTest::keyClick(&f.runs, Qt::Key_B);
        QVERIFY(f.list.other() == f.list.runs()[2]);
        QTest::keyClick(&f.runs, Qt::Key_A); // the other run, so they are swapped
        QVERIFY(f.list.reference() == f.list.runs()[2] && f.list.other() == f.list.runs()[0]);
        f.click(1, RunName);
        QTest::keyClick(&f.runs, Qt::Key_Delete);
        QCOMPARE(f.count(), 2);
        f.remove.click();
        f.remove.click();
        QCOMPARE(f.count(), 0);
        QVERIFY(!f.remove.isEnabled() && f.empty.isVisible());
    }

    void tablesHoldTheFigures()
    {
        ComparisonPanelFixture f;
        f.add(PolicyKind::Nearest);
        QVERIFY(f.text(f.figures, 0, 2).isEmpty()); // nothing to compare with
        f.add(PolicyKind::Uncertainty, 200);
        f.list.setReference(0);
        const RunComparison comparison = *f.list.comparison();
        QCOMPARE(comparison.until_s, 200.0);
        const RunFigures a = figuresAt(*comparison.reference, 200);
        const RunFigures b = figuresAt(*comparison.other, 200);
        QCOMPARE(f.text(f.figures, 2, 1), QString::number(a.visits));
        QCOMPARE(f.text(f.figures, 2, 2), QString::number(b.visits));
        QCOMPARE(f.text(f.figures, 0, 3), percentText(b.zeta_m2s, a.zeta_m2s, QLocale::c()));
        const int better = a.zeta_m2s < b.zeta_m2s ? 1 : 2;
        QVERIFY(f.isBold(0, better));
        QVERIFY(!f.isBold(0, 3 - better));
        const std::size_t longest = a.longestUnseen.value();
        QCOMPARE(f.text(f.figures, 6, 1),
                 QString::fromStdString(comparison.reference->icebergs[longest].id));
        QCOMPARE(f.unseen.model()->rowCount(), static_cast<int>(a.unseen.size()));
        QCOMPARE(f.text(f.unseen, static_cast<int>(longest), 1), f.text(f.figures, 5, 1));
    }

    void percentTextIsRelative_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("text");
        QTest::newRow("more") << 108.04 << u"+8.0 %"_s;
        QTest::newRow("less") << 99.6 << u"−0.4 %"_s;
        QTest::newRow("equal") << 100.0 << u"0.0 %"_s;
        QTest::newRow("all but equal") << 99.99 << u"0.0 %"_s;
        QTest::newRow("much more") << 312.3 << u"+212 %"_s;
    }

    void percentTextIsRelative()
    {
        QFETCH(double, value);
        QFETCH(QString, text);
        QCOMPARE(percentText(value, 100, QLocale::c()), text);
        QCOMPARE(percentText(value, 0, QLocale::c()), u"–"_s);
    }

    /** The pointer does the same as the keys; a given name stays until it is removed. */
    void menuOfARun()
    {
        ComparisonPanelFixture f;
        f.add(PolicyKind::Nearest, 60);
        f.add(PolicyKind::Uncertainty, 60);
        f.add(PolicyKind::Path, 60);
        const auto menuAt = [&](int row) {
            const QPoint at = f.runs.visualRect(f.at(f.runs, row, RunName)).center();
            QContextMenuEvent event(QContextMenuEvent::Mouse, at, f.runs.mapToGlobal(at));
            QCoreApplication::sendEvent(f.runs.viewport(), &event);
            return f.runs.findChild<QMenu*>(u"runMenu"_s);
        };
        QMenu* menu = menuAt(0);
        QVERIFY(menu != nullptr);
        menu->actions()[0]->trigger();
        QVERIFY(f.list.reference() == f.list.runs()[0]);
        menu->close();
        QCoreApplication::sendPostedEvents(menu, QEvent::DeferredDelete);
        QTest::keyClick(&f.runs, Qt::Key_F2);
        auto* editor = f.runs.findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        test::enter(*editor, u" First  try "_s);
        QTRY_COMPARE(f.list.runs()[0]->name, u"First try"_s); // queued by Qt
        QCOMPARE(f.text(f.runs, 0, RunName), u"First try"_s);
        QVERIFY(f.list.reference() == f.list.runs()[0]); // still the same run
        QCOMPARE(runName(*f.list.comparison()->reference, QLocale::c()), u"First try"_s);
        f.list.rename(0, {});
        QCOMPARE(f.text(f.runs, 0, RunName), u"Nearest first, to 01:00"_s);
        menu = menuAt(2);
        menu->actions().last()->trigger();
        QCOMPARE(f.count(), 2);
    }

    void openAsksTheOwner()
    {
        ComparisonPanelFixture f;
        QSignalSpy asked(&f.panel, &ComparisonPanel::openRunRequested);
        test::child<QToolButton>(f.panel, u"openComparedRun"_s).click();
        QCOMPARE(asked.count(), 1);
    }

    void fitsItsDocks_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("besideEachOther");
        QTest::newRow("narrow") << QSize(test::kDock_px, 500) << false;
        QTest::newRow("low") << QSize(480, 210) << false; // on tabs
        QTest::newRow("wide") << QSize(900, 240) << true;
    }

    void fitsItsDocks()
    {
        QFETCH(QSize, size);
        QFETCH(bool, besideEachOther);
        const test::LongerTexts longer;
        ComparisonPanelFixture f(size);
        f.add(PolicyKind::Nearest, 60);
        f.add(PolicyKind::Uncertainty, 60);
        QVERIFY2(f.panel.minimumSizeHint().width() <= size.width() &&
                     f.panel.minimumSizeHint().height() <= size.height(),
                 qPrintable(u"%1 x %2"_s.arg(f.panel.minimumSizeHint().width())
                                .arg(f.panel.minimumSizeHint().height())));
        QCOMPARE(f.panel.size(), size);
        const auto left = [&](const QWidget& widget) {
            return widget.mapTo(&f.panel, QPoint(0, 0)).x();
        };
        QCOMPARE(left(f.figures) > left(f.runs) + 50, besideEachOther);
        QVERIFY(f.runs.columnWidth(RunName) >= 50);
        QVERIFY(!f.runs.isColumnHidden(RunZeta) && !f.runs.isColumnHidden(RunDifference));
        int columns_px = 0;
        for (int column = 0; column < RunColumnCount; ++column)
            columns_px += f.runs.columnWidth(column);
        QVERIFY(columns_px <= f.runs.viewport()->width());
        test::child<QTabWidget>(f.panel, u"comparisonTabs"_s).setCurrentWidget(&f.figures);
        QVERIFY(f.figures.columnWidth(0) >= 50);
        const int text_px = f.tour.fontMetrics().horizontalAdvance(f.tour.text());
        QVERIFY(text_px <= f.tour.width());
    }

    void themesReachEverything()
    {
        ComparisonPanelFixture f;
        f.add(PolicyKind::Nearest, 60);
        f.panel.setTheme(Theme::dark());
        const QRect cell = f.runs.visualRect(f.at(f.runs, 0, RunReference));
        f.runs.clearSelection();
        f.runs.setCurrentIndex({});
        const QImage image = f.runs.viewport()->grab(cell).toImage();
        bool marked = false;
        for (int x = 0; x < image.width(); ++x)
            marked = marked || image.pixelColor(x, image.height() / 2 - 6).rgb() ==
                                   Theme::dark().accumulated.rgb();
        QVERIFY(marked);
    }
};

QTEST_MAIN(TestComparisonPanel)
#include "tst_comparison_panel.moc"
