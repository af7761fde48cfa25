#include "core/io/export/content/export_flight.h"
#include "core/io/files/run_json.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/charts/pareto_chart.h"
#include "widgets/panels/plan/plan_model.h"
#include "widgets/print/brief_content.h"
#include "widgets/print/brief_table.h"
#include "widgets/theme/quantity_text.h"

#include <QContextMenuEvent>
#include <QDropEvent>
#include <QMenu>
#include <QMimeData>
#include <QTableView>
#include <QToolButton>
#include <QUndoStack>

#include <algorithm>
#include <memory>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** West has the icebergs west of it to visit, uav-2 the others. */
Scenario twoUavs()
{
    Scenario scenario = test::MapFixture::fourIcebergs();
    scenario.planner.policy = PolicyKind::Visitation;
    scenario.uavs.front().name = "West";
    scenario.uavs.push_back(scenario.uavs.front());
    scenario.uavs[1].id = "uav-2";
    scenario.uavs[1].name.clear();
    scenario.uavs[1].position_m += Point(6000, 2000);
    scenario.uavs[1].spec.altitude_m += 40;
    return scenario;
}

QTableView& planTable(WindowFixture& w)
{
    return test::child<QTableView>(w.window(), u"planTable"_s);
}

std::optional<int> rowOf(WindowFixture& w, const std::string& id)
{
    const auto* model = qobject_cast<PlanModel*>(planTable(w).model());
    return model->rowOf(id);
}

/** The first iceberg below the line of that UAV. */
std::string firstOf(WindowFixture& w, const std::string& uav)
{
    const auto* model = qobject_cast<PlanModel*>(planTable(w).model());
    return model->idOf(model->rowOf(uav).value() + 1);
}

/** Drops the row of the iceberg onto that of the UAV, as the platform does it. */
void dragTo(WindowFixture& w, const std::string& iceberg, const std::string& uav)
{
    QTableView& table = planTable(w);
    QAbstractItemModel& model = *table.model();
    const std::unique_ptr<QMimeData> data(
        model.mimeData({model.index(rowOf(w, iceberg).value(), 0)}));
    const QModelIndex onto = model.index(rowOf(w, uav).value(), PlanModel::Name);
    table.scrollTo(onto);
    const QPoint at = table.visualRect(onto).center();
    QDragEnterEvent enter(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
    QCoreApplication::sendEvent(table.viewport(), &enter);
    QDragMoveEvent move(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
    QCoreApplication::sendEvent(table.viewport(), &move);
    QDropEvent drop(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
    QCoreApplication::sendEvent(table.viewport(), &drop);
}

bool isInOrderOf(const UavPlan& plan, IcebergIndex iceberg)
{
    return std::ranges::find(plan.order, iceberg) != plan.order.end();
}

} // namespace

/** Icebergs handed over from one UAV to another in the plan. */
class TestMainWindowPlan : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** That of the plan alone falls with tau where that of the flight rises. */
    void zetaIsPredictedOnce()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const auto predictions = [&w] {
            QStringList found;
            for (const QLabel* label : w.window().findChildren<QLabel*>())
                if (label->isVisibleTo(&w.window()))
                    for (const QString& line : label->text().split(u'\n'))
                        if (line.contains(u'ζ') && line.contains(u"m² s"_s) &&
                            !line.contains(u"bound"_s))
                            found << line;
            return found;
        };
        QVERIFY(w.until([&] { return predictions().size() == 1; }));
        QVERIFY(predictions().front().startsWith(u"Predicted ζ"_s));
        w.workspace.step();
        QVERIFY(w.until([&] {
            return predictions().filter(u"Predicted before take-off"_s).size() == 1 &&
                   predictions().filter(u"Expected ζ"_s).size() == 1;
        }));
        QCOMPARE(predictions().size(), 2);
    }

    /** The whole order as the solver weighs it in panel and chart, this sortie in plan and brief.
     */
    void lengthsSayWhatTheyAreOf()
    {
        Scenario scenario = test::MapFixture::fourIcebergs();
        scenario.planner.policy = PolicyKind::Visitation;
        scenario.wind_mps = {9, 0};
        scenario.uavs.front().spec.endurance_s = 500; // the rest of the order is for later
        const ExportContent content = // nothing is solved on this thread while there is a window
            exportContent({.scenario = scenario, .plan = planFromStart(scenario)});
        WindowFixture w(scenario);
        QVERIFY(w.until([&] {
            const TauCurve& found = w.workspace.curve().curve();
            return found.complete && !found.intervals.empty();
        }));
        const auto& chart = test::child<ParetoChart>(w.window(), {});
        const TauCurve& curve = w.workspace.curve().curve();
        const CurveInterval& present = curve.intervals.at(
            static_cast<std::size_t>(intervalAt(curve, scenario.planner.tau).value()));
        const QString whole = distanceText(present.distance_m, QLocale());
        QCOMPARE(test::child<QLabel>(w.window(), u"planDistance"_s).text(), whole);
        QCOMPARE(test::child<QLabel>(w.window(), u"planReward"_s).text(),
                 sigmaText(present.reward_m2, QLocale()));
        QVERIFY2(chart.accessibleDescription().contains(u"whole order %1,"_s.arg(whole)),
                 qUtf8Printable(chart.accessibleDescription()));
        const QString sortie = distanceText(pathTotals(content.uavs.front()).length_m, QLocale());
        QVERIFY(sortie != whole);
        QVERIFY(test::child<QLabel>(w.window(), u"planSummary"_s)
                    .toolTip()
                    .startsWith(u"This sortie: %1 with the return"_s.arg(sortie)));
        const auto& facts = briefContent(content, QLocale()).flight;
        QVERIFY(std::ranges::any_of(facts, [&](const BriefFact& fact) {
            return fact.caption == u"This sortie"_s && fact.value == sortie;
        }));
    }

    void beforeTakeOffItIsAnEdit()
    {
        WindowFixture w(twoUavs());
        const std::string iceberg = firstOf(w, "uav-1");
        dragTo(w, iceberg, "uav-2");
        QCOMPARE(w.document().undoStack()->count(), 1);
        QVERIFY(w.untilReady());
        QCOMPARE(w.workspace.assignedUavOf(iceberg), "uav-2");
        QVERIFY(rowOf(w, iceberg) > rowOf(w, "uav-2"));
        QVERIFY(planTable(w)
                    .model()
                    ->index(rowOf(w, iceberg).value(), PlanModel::Name)
                    .data(PlanModel::AssignedRole)
                    .toBool());
        w.trigger(u"undoAction"_s);
        QVERIFY(w.untilReady());
        QVERIFY(w.scenario() == twoUavs());
        QVERIFY(rowOf(w, iceberg) < rowOf(w, "uav-2"));
    }

    /** The mission keeps to it, and so does the run when it is flown again. */
    void inFlightItIsReplayed()
    {
        WindowFixture w(twoUavs());
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until(RunPhase::Paused));
        const std::string iceberg = firstOf(w, "uav-1");
        const IcebergIndex index = indexOfId(w.scenario().icebergs, iceberg).value();
        dragTo(w, iceberg, "uav-2");
        QVERIFY(w.until([&] { return w.workspace.assignedUavOf(iceberg) == "uav-2"; }));
        QVERIFY(w.until([&] { return rowOf(w, iceberg) > rowOf(w, "uav-2"); }));
        QVERIFY(w.scenario() == twoUavs());
        w.workspace.fly(kFastestRate);
        QVERIFY(w.until(RunPhase::Finished));

        const std::shared_ptr<const RunFile> run = flownRun(w);
        QCOMPARE(run->interventions.size(), std::size_t{1});
        const double time_s = run->interventions.front().time_s;
        const auto [differences, plans] = test::elsewhere([&] {
            const Mission again = replay(*run);
            return std::pair(compareRun(*run, berg::runOf(again)), again.plans());
        });
        QVERIFY(differences.empty());
        bool isVisited = false;
        for (const test::FlownPlan& plan : test::flownPlans(plans)) {
            isVisited = isVisited || (plan.uav == 1 && isInOrderOf(plan, index));
            QVERIFY(plan.uav == 1 || plan.time_s < time_s || plan.reason == PlanReason::Start ||
                    !isInOrderOf(plan, index));
        }
        QVERIFY(isVisited);
    }

    /** By keyboard and mouse, on the map as in the plan. */
    void menusHandOver()
    {
        WindowFixture w(twoUavs());
        const std::string iceberg = firstOf(w, "uav-1");
        const auto choose = [&](const QString& name, const QString& text) {
            auto& menu = test::child<QMenu>(w.window(), name);
            const auto actions = menu.actions();
            const auto it = std::ranges::find(actions, text, &QAction::text);
            QVERIFY2(it != actions.end(), qPrintable(text));
            QVERIFY((*it)->isCheckable() && !(*it)->isChecked());
            (*it)->trigger();
            menu.close();
            QTest::qWait(0); // deleted
        };
        QTableView& table = planTable(w);
        table.setCurrentIndex(table.model()->index(rowOf(w, iceberg).value(), 0));
        QContextMenuEvent key(QContextMenuEvent::Keyboard, {}, {});
        QCoreApplication::sendEvent(&table, &key);
        choose(u"planMenu"_s, u"Assign to uav-2"_s);
        QCOMPARE(w.workspace.assignedUavOf(iceberg), "uav-2");
        QVERIFY(w.untilReady());
        QTest::mouseClick(&w.map(), Qt::RightButton, {}, w.pixelOf(iceberg));
        choose(u"mapMenu"_s, u"Assign to West"_s);
        QCOMPARE(w.workspace.assignedUavOf(iceberg), "uav-1");
        QVERIFY(w.untilReady());
        QTest::mouseClick(&w.map(), Qt::RightButton, {}, w.pixelOf(iceberg));
        choose(u"mapMenu"_s, u"Any UAV may visit it"_s);
        QVERIFY(w.scenario() == twoUavs());
    }

    void refusedTauIsTakenBack_data()
    {
        QTest::addColumn<bool>("atEnd");
        QTest::newRow("looking back") << false;
        QTest::newRow("at the end") << true;
    }

    void refusedTauIsTakenBack()
    {
        QFETCH(bool, atEnd);
        Scenario scenario = test::MapFixture::fourIcebergs();
        scenario.duration_s = 100;
        WindowFixture w(scenario);
        w.workspace.fly(kFastestRate);
        QVERIFY(w.until(RunPhase::Finished));
        if (!atEnd) {
            w.workspace.seek(20);
            QVERIFY(w.until([&] { return w.record().instant.has_value(); }));
        }
        auto& slider = test::child<QSlider>(w.window(), u"tauSlider"_s);
        const int before = slider.value();
        slider.setFocus();
        QTest::keyClick(&slider, Qt::Key_PageUp);
        QTRY_COMPARE(slider.value(), before);
    }

    void selectionIsShownInOtherUnits()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.workspace.selection().set({"berg-2"});
        w.trigger(u"units/distance-nautical"_s);
        QTest::qWait(0); // another window
        QTRY_COMPARE(planTable(w).selectionModel()->selectedRows().size(), 1);
        w.trigger(u"units/distance-metric"_s);
        QTest::qWait(0);
    }

    void detailsStayUnfolded()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        test::child<QToolButton>(w.window(), u"planDetails"_s).click();
        const MainWindow next(w.workspace, w.interaction, w.settings);
        QVERIFY(test::child<QToolButton>(next, u"planDetails"_s).isChecked());
    }
};

QTEST_MAIN(TestMainWindowPlan)
#include "tst_main_window_plan.moc"
