#include "tests/support/approx.h"
#include "tests/support/panel_test.h"
#include "tests/support/scenario_builder.h"
#include "widgets/panels/plan_model.h"
#include "widgets/panels/plan_panel.h"

#include <QAbstractItemModelTester>
#include <QContextMenuEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>

#include <cmath>
#include <memory>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

std::vector<PlanRow> rowsOf(const std::vector<std::string>& ids)
{
    std::vector<PlanRow> rows;
    for (const std::string& id : ids)
        rows.push_back({.id = id,
                        .name = QString::fromStdString(id),
                        .leg_m = 1000,
                        .arrival_s = 60 * static_cast<double>(rows.size() + 1),
                        .sigma_m2 = 4});
    return rows;
}

/** The plan of the only UAV. */
std::vector<PlanSection> planOf(std::vector<PlanRow> rows, bool isHomeward = false)
{
    return {
        {.uav = "uav-1", .name = u"uav-1"_s, .isHomeward = isHomeward, .rows = std::move(rows)}};
}

std::vector<PlanSection> visiting(const std::vector<std::string>& ids)
{
    return planOf(rowsOf(ids));
}

/** a and b of uav-1, c of uav-2, for which it is kept. */
std::vector<PlanSection> twoUavs()
{
    std::vector<PlanRow> kept = rowsOf({"c"});
    kept.front().isKept = true;
    return {{.uav = "uav-1", .name = u"West"_s, .place = 0, .rows = rowsOf({"a", "b"})},
            {.uav = "uav-2", .name = u"uav-2"_s, .place = 1, .rows = std::move(kept)}};
}

std::vector<std::string> manyIds()
{
    std::vector<std::string> ids;
    for (int i = 0; i < 40; ++i)
        ids.push_back(u"b%1"_s.arg(i).toStdString());
    return ids;
}

/** UAV at (0, 0); icebergs estimated at (300, 400) and, drifting, (300, 1000) at time 100. */
MissionSnapshot twoIcebergs(const Scenario& scenario)
{
    MissionSnapshot now;
    now.time_s = 100;
    now.icebergs = scenario.icebergs;
    now.world.tracks = {{.anchor_m = Point(300, 400), .sigma_m2 = 2.5, .q_m2ps = 0.02},
                        {.anchor_m = Point(250, 900),
                         .anchor_s = 50,
                         .velocity_mps = Point(1, 2),
                         .sigma_m2 = 7,
                         .q_m2ps = 0.1}};
    now.active = {true, true};
    for (const Uav& uav : scenario.uavs) {
        now.world.uavs.push_back({.pose = {.position_m = uav.position_m}});
        now.motions.push_back(
            {.airspeed_mps = uav.spec.airspeed_mps, .wind_mps = scenario.wind_mps});
    }
    now.plan = PlanEvent{.order = {0, 1}};
    now.plans = {*now.plan};
    now.assigned = {-1, -1};
    return now;
}

Scenario twoIcebergScenario()
{
    Scenario scenario = test::emptySea();
    scenario.uavs.front().spec.airspeed_mps = 20;
    test::addIceberg(scenario, 0, 0);
    test::addIceberg(scenario, 0, 0).name = "Tabular";
    return scenario;
}

struct Fixture
{
    PlanPanel panel;
    QTableView& table = test::child<QTableView>(panel, u"planTable"_s);
    QAbstractItemModel& model = *table.model();
    QSignalSpy hovered{&panel, &PlanPanel::hovered};
    QSignalSpy activated{&panel, &PlanPanel::activated};

    Fixture()
    {
        panel.setLocale(QLocale::c());
        panel.resize(test::kDock_px, 240);
        panel.show();
    }
    [[nodiscard]] QString cell(int row, int column) const
    {
        return model.index(row, column).data().toString();
    }
    [[nodiscard]] QPoint centre(int row) const
    {
        return table.visualRect(model.index(row, PlanModel::Name)).center();
    }
    [[nodiscard]] int chosenRow() const
    {
        const QModelIndexList rows = table.selectionModel()->selectedRows();
        return rows.isEmpty() ? -1 : rows.front().row();
    }
};

std::string lastId(const QSignalSpy& spy)
{
    return spy.back().front().value<std::string>();
}

} // namespace

class TestPlanPanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { qRegisterMetaType<std::string>("std::string"); }
    void init() { test::failOnWarnings(); }

    void legsAndArrivalsInCalmAir()
    {
        const Scenario scenario = twoIcebergScenario();
        const std::vector<PlanRow> rows =
            planSections(twoIcebergs(scenario), scenario).front().rows;
        QCOMPARE(rows.size(), std::size_t{2});
        QCOMPARE(rows[0].id, "berg-1");
        QCOMPARE(rows[0].name, u"berg-1"_s);
        QCOMPARE(rows[1].name, u"Tabular"_s);
        // 3-4-5 triangle of 500 m, then 600 m due north, at 20 m/s; rounding only.
        COMPARE_NEAR(rows[0].leg_m, 500.0, 1e-9);
        COMPARE_NEAR(rows[0].arrival_s, 25.0, 1e-9);
        COMPARE_NEAR(rows[1].leg_m, 600.0, 1e-9);
        COMPARE_NEAR(rows[1].arrival_s, 55.0, 1e-9);
        QCOMPARE(rows[0].sigma_m2, 2.5);
        QCOMPARE(rows[1].sigma_m2, 7.0);
        // Eq. (22): grown by q for 25 and 55 s.
        COMPARE_NEAR(rows[0].arrivalSigma_m2, 2.5 + 0.02 * 25, 1e-9);
        COMPARE_NEAR(rows[1].arrivalSigma_m2, 7 + 0.1 * 55, 1e-9);
    }

    void windChangesTimesNotLegs()
    {
        Scenario scenario = twoIcebergScenario();
        scenario.wind_mps = Point(0, 12);
        const std::vector<PlanRow> rows =
            planSections(twoIcebergs(scenario), scenario).front().rows;
        // Leg (300, 400): along (0.6, 0.8) the wind gives 9.6, across it 7.2 m/s, so the ground
        // speed is 9.6 + sqrt(20^2 - 7.2^2). Leg due north: 20 + 12.
        const double first_s = 500 / (9.6 + std::sqrt(400 - 51.84));
        COMPARE_NEAR(rows[0].leg_m, 500.0, 1e-9);
        COMPARE_NEAR(rows[0].arrival_s, first_s, 1e-9);
        COMPARE_NEAR(rows[1].arrival_s, first_s + 600.0 / 32, 1e-9);
    }

    void noPlanNoRows()
    {
        const Scenario scenario = twoIcebergScenario();
        MissionSnapshot now = twoIcebergs(scenario);
        now.plan.reset();
        now.plans.clear();
        QVERIFY(planSections(now, scenario).front().rows.empty());
    }

    /** Each UAV flies its own order from where it is, at its own speed. */
    void everyUavHasItsSection()
    {
        Scenario scenario = twoIcebergScenario();
        scenario.uavs.push_back({.id = "uav-2", .name = "North", .position_m = Point(300, 2000)});
        scenario.uavs[1].spec.airspeed_mps = 10;
        MissionSnapshot now = twoIcebergs(scenario);
        now.plan->order = {0};
        now.plans = {*now.plan, {.uav = 1, .sameSolve = true, .order = {1}}};
        now.assigned = {-1, 1};
        const std::vector<PlanSection> sections = planSections(now, scenario);
        QCOMPARE(sections.size(), std::size_t{2});
        QCOMPARE(sections[0].rows.size(), std::size_t{1});
        QVERIFY(!sections[0].rows[0].isKept);
        COMPARE_NEAR(sections[0].lastArrival_s(), 25.0, 1e-9);
        QCOMPARE(sections[1].uav, "uav-2");
        QCOMPARE(sections[1].name, u"North"_s);
        QCOMPARE(sections[1].place, 1);
        QCOMPARE(sections[1].rows[0].name, u"Tabular"_s);
        QVERIFY(sections[1].rows[0].isKept);
        COMPARE_NEAR(sections[1].length_m(), 1000.0, 1e-9); // due south, at 10 m/s
        COMPARE_NEAR(sections[1].lastArrival_s(), 100.0, 1e-9);
        now.world.uavs[1].mode = FlightMode::Home;
        QVERIFY(planSections(now, scenario)[1].isHomeward);
        QVERIFY(planSections(now, scenario)[1].rows.empty());
    }

    void cellsHaveWordsAndUnits()
    {
        Fixture f;
        const PlanRow row{.id = "berg-7",
                          .name = u"Tabular"_s,
                          .leg_m = 1852,
                          .arrival_s = 86,
                          .sigma_m2 = 8.1,
                          .arrivalSigma_m2 = 10.25};
        f.panel.showPlan(planOf(std::vector{row}));
        QCOMPARE(f.cell(0, PlanModel::ArrivalSigma), u"10.3"_s);
        QCOMPARE(f.cell(0, PlanModel::Number), u"1"_s);
        QCOMPARE(f.cell(0, PlanModel::Name), u"Tabular"_s);
        QCOMPARE(f.cell(0, PlanModel::Leg), u"1.85 km"_s);
        QCOMPARE(f.cell(0, PlanModel::Arrival), u"in 01:26"_s);
        QCOMPARE(f.cell(0, PlanModel::Sigma), u"8.10"_s);
        QVERIFY(f.model.headerData(PlanModel::Sigma, Qt::Horizontal).toString().contains(u"m²"_s));
        const QString toolTip = f.model.index(0, PlanModel::Sigma).data(Qt::ToolTipRole).toString();
        QVERIFY2(toolTip.contains(u"2.85 m"_s), qPrintable(toolTip)); // root of 8.1
        QVERIFY2(toolTip.contains(u"10.3 m²"_s), qPrintable(toolTip));
    }

    void summaryTellsLengthEndAndZeta()
    {
        Fixture f;
        f.panel.resize(600, 240);
        const auto& summary = test::child<QLabel>(f.panel, u"planSummary"_s);
        QVERIFY(summary.text().isEmpty());
        f.panel.showPlan(visiting({"a", "b", "c"})); // 1 km each, the last in 3 min
        QCOMPARE(summary.text(), u"3.00 km, flown in 03:00"_s);
        f.panel.showOutlook(PlanOutlook{.zeta_m2s = 84423});
        QCOMPARE(summary.text().section(u'\n', 1),
                 u"ζ at the end by this plan alone: 84\u202f420 m² s"_s);
        f.panel.showPlan(planOf(std::vector<PlanRow>(), true));
        QVERIFY(test::child<QLabel>(f.panel, u"planEmpty"_s).text().contains(u"next sortie"_s));
        f.panel.showPlan({});
        f.panel.showOutlook(std::nullopt);
        QVERIFY(summary.text().isEmpty());
    }

    void summaryTellsWhatAChangeCosts()
    {
        Fixture f;
        f.panel.resize(600, 240);
        const auto& summary = test::child<QLabel>(f.panel, u"planSummary"_s);
        f.panel.showPlan(visiting({"a", "b"}));
        PlanOutlook outlook{.zeta_m2s = 5000,
                            .change =
                                PlanChange{.before = {1, 0}, .distance_m = 1234, .zeta_m2s = -567},
                            .changed_s = 83,
                            .before = u"b, a"_s};
        f.panel.showOutlook(outlook);
        QCOMPARE(summary.text().section(u'\n', 2),
                 u"Against the plan before: +1.2 km, ζ −570 m² s"_s);
        QVERIFY2(summary.toolTip().contains(u"01:23: b, a"_s), qPrintable(summary.toolTip()));
        outlook.change->distance_m = -850;
        outlook.change->zeta_m2s = 40;
        f.panel.showOutlook(outlook);
        QCOMPARE(summary.text().section(u'\n', 2),
                 u"Against the plan before: −850 m, ζ +40 m² s"_s);
    }

    void outlookOfAPartSaysUntilWhen()
    {
        Fixture f;
        f.panel.showPlan(visiting({"a"}));
        f.panel.showOutlook(PlanOutlook{.zeta_m2s = 84423, .until_s = 800, .isAimed = true});
        const auto& summary = test::child<QLabel>(f.panel, u"planSummary"_s);
        QCOMPARE(summary.text().section(u'\n', 1),
                 u"ζ at 13:20 by this plan alone: 84\u202f420 m² s"_s);
        QVERIFY(!summary.toolTip().contains(u"straight"_s));
    }

    void summaryTellsWhatNoFlightBeats()
    {
        Fixture f;
        f.panel.resize(600, 240);
        f.panel.showPlan(visiting({"a"}));
        PlanOutlook outlook{.zeta_m2s = 84423, .bound_m2s = 49870, .boundShare = 0.4};
        f.panel.showOutlook(outlook);
        const auto& summary = test::child<QLabel>(f.panel, u"planSummary"_s);
        QCOMPARE(summary.text().section(u'\n', 2),
                 u"No flight can do better than 49\u202f870 m² s (40 %…)"_s);
        outlook.bound_m2s = 51770;
        outlook.boundShare = 1;
        f.panel.showOutlook(outlook);
        QCOMPARE(summary.text().section(u'\n', 2),
                 u"No flight can do better than 51\u202f770 m² s"_s);
        QVERIFY(summary.toolTip().contains(u"proven"_s));
    }

    /** A plan with aim points may end before all are seen: no cell is empty or invented. */
    void icebergsThatThePlanDoesNotSee()
    {
        Fixture f;
        std::vector<PlanRow> rows = rowsOf({"a", "b"});
        const QString arrival = PlanModel::arrivalText(rows[0].arrival_s);
        rows[1].isSeen = false;
        rows[1].arrival_s = rows[1].leg_m = 0;
        f.panel.showPlan(planOf(rows));
        const auto text = [&](int column) { return f.model.index(1, column).data().toString(); };
        QCOMPARE(text(PlanModel::Arrival), u"later"_s);
        for (int column = 0; column < PlanModel::ColumnCount; ++column)
            QVERIFY(!text(column).isEmpty());
        QVERIFY(f.model.index(1, PlanModel::Arrival)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(u"before this iceberg"_s));
        const auto& summary = test::child<QLabel>(f.panel, u"planSummary"_s);
        QVERIFY2(summary.text().contains(arrival), qPrintable(summary.text()));
    }

    void longSummaryIsInTheToolTip()
    {
        Fixture f;
        f.panel.resize(150, 240);
        f.panel.showPlan(visiting({"a"}));
        f.panel.showOutlook(PlanOutlook{.zeta_m2s = 84423});
        const auto& summary = test::child<QLabel>(f.panel, u"planSummary"_s);
        QVERIFY(summary.text().endsWith(u'…'));
        QVERIFY2(summary.toolTip().contains(u"84\u202f420 m² s"_s), qPrintable(summary.toolTip()));
        QCOMPARE(f.panel.width(), 150);
    }

    void furtherColumnNeedsRoom()
    {
        Fixture f;
        f.panel.showPlan(visiting({"a"}));
        f.panel.resize(500, 240);
        QVERIFY(!f.table.isColumnHidden(PlanModel::ArrivalSigma));
        QVERIFY(f.table.columnWidth(PlanModel::ArrivalSigma) > 0);
        f.panel.resize(240, 240);
        QVERIFY(f.table.isColumnHidden(PlanModel::ArrivalSigma));
        f.panel.resize(500, 240);
        QVERIFY(!f.table.isColumnHidden(PlanModel::ArrivalSigma));
    }

    void onlyChangedRowsAreRedrawn()
    {
        Fixture f;
        std::vector<PlanRow> rows = rowsOf({"a", "b", "c"});
        f.panel.showPlan(planOf(rows));
        QSignalSpy reset(&f.model, &QAbstractItemModel::modelReset);
        QSignalSpy changed(&f.model, &QAbstractItemModel::dataChanged);
        rows[1].arrival_s += 0.1; // still 02:00
        f.panel.showPlan(planOf(rows));
        QCOMPARE(changed.count(), 0);
        rows[1].arrival_s += 1;
        f.panel.showPlan(planOf(rows));
        QCOMPARE(changed.count(), 1);
        QCOMPARE(changed.front().front().toModelIndex().row(), 1);
        QCOMPARE(reset.count(), 0);
    }

    void chosenRowFollowsItsIceberg()
    {
        Fixture f;
        f.panel.showPlan(visiting({"a", "b", "c"}));
        QTest::mouseClick(f.table.viewport(), Qt::LeftButton, {}, f.centre(2));
        QCOMPARE(f.activated.count(), 1);
        QCOMPARE(lastId(f.activated), "c");
        f.panel.showPlan(visiting({"b", "c", "a"}));
        QCOMPARE(f.chosenRow(), 1);
        f.panel.showPlan(visiting({"b"}));
        QCOMPARE(f.chosenRow(), -1);
        f.panel.showPlan(visiting({"c", "b"}));
        QCOMPARE(f.chosenRow(), 0);
        QCOMPARE(f.activated.count(), 1);
    }

    void scrollPositionStays()
    {
        Fixture f;
        f.panel.showPlan(visiting(manyIds()));
        QTest::mouseClick(f.table.viewport(), Qt::LeftButton, {}, f.centre(0));
        QScrollBar* bar = f.table.verticalScrollBar();
        bar->setValue(bar->maximum() / 2);
        const int at_px = bar->value();
        QVERIFY(at_px > 0);
        std::vector<std::string> ids = manyIds();
        std::rotate(ids.begin(), ids.begin() + 1, ids.end());
        f.panel.showPlan(visiting(ids)); // the chosen one is last now
        QCOMPARE(bar->value(), at_px);
        QCOMPARE(f.chosenRow(), static_cast<int>(ids.size()) - 1);
    }

    void keysWalkAndReturnActivates()
    {
        Fixture f;
        f.panel.showPlan(visiting({"a", "b", "c"}));
        f.table.setCurrentIndex(f.model.index(0, 0));
        QTest::keyClick(&f.table, Qt::Key_Down);
        f.panel.showPlan(visiting({"a", "b", "c"})); // an update does not undo the step
        QCOMPARE(f.chosenRow(), 1);
        QTest::keyClick(&f.table, Qt::Key_Return);
        QCOMPARE(f.activated.count(), 1);
        QCOMPARE(lastId(f.activated), "b");
    }

    void pointerTellsWhichIceberg()
    {
        Fixture f;
        f.panel.showPlan(visiting({"a", "b"}));
        QTest::mouseMove(f.table.viewport(), f.centre(1));
        QTRY_COMPARE(f.hovered.count(), 1);
        QCOMPARE(lastId(f.hovered), "b");
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(f.table.viewport(), &leave);
        QCOMPARE(f.hovered.count(), 2);
        QVERIFY(lastId(f.hovered).empty());
    }

    void highlightMarksOneRow()
    {
        Fixture f;
        f.panel.showPlan(visiting({"a", "b"}));
        f.panel.setHighlight("b");
        QVERIFY(!f.model.index(0, 0).data(PlanModel::HighlightRole).toBool());
        QVERIFY(f.model.index(1, 0).data(PlanModel::HighlightRole).toBool());
        f.panel.setHighlight({});
        QVERIFY(!f.model.index(1, 0).data(PlanModel::HighlightRole).toBool());
        QCOMPARE(f.hovered.count() + f.activated.count(), 0);
    }

    void emptyPlanSaysWhy()
    {
        Fixture f;
        f.panel.showPlan({});
        QVERIFY(test::child<QLabel>(f.panel, u"planEmpty"_s).isVisible());
        f.panel.showPlan(visiting({"a"}));
        QVERIFY(!test::child<QLabel>(f.panel, u"planEmpty"_s).isVisible());
    }

    void severalUavsHaveALineEach()
    {
        Fixture f;
        const QAbstractItemModelTester tester(&f.model);
        f.panel.resize(600, 240);
        f.panel.showPlan(twoUavs());
        QCOMPARE(f.model.rowCount(), 5);
        QCOMPARE(f.cell(0, PlanModel::Name), u"West"_s);
        QCOMPARE(f.cell(0, PlanModel::Leg), u"2.00 km"_s);
        QCOMPARE(f.cell(0, PlanModel::Arrival), u"in 02:00"_s);
        QCOMPARE(f.cell(0, PlanModel::Sigma), u"2 visits"_s);
        QCOMPARE(f.cell(2, PlanModel::Number), u"2"_s);
        QCOMPARE(f.cell(4, PlanModel::Number), u"1"_s); // each has an order of its own
        for (int row = 0; row < 5; ++row)
            QCOMPARE(f.model.index(row, 0).data(PlanModel::UavRole).toInt(), row < 3 ? 0 : 1);
        QCOMPARE(test::child<QLabel>(f.panel, u"planSummary"_s).text(),
                 u"3.00 km, flown in 02:00"_s);
        QTest::mouseClick(f.table.viewport(), Qt::LeftButton, {}, f.centre(3));
        QCOMPARE(lastId(f.activated), "uav-2");
        f.panel.showPlan(visiting({"a"})); // back to one
        QCOMPARE(f.model.rowCount(), 1);
        QCOMPARE(f.cell(0, PlanModel::Name), u"a"_s);
    }

    void homewardUavSaysSo()
    {
        Fixture f;
        std::vector<PlanSection> sections = twoUavs();
        sections[0].rows.clear();
        sections[0].isHomeward = true;
        f.panel.showPlan(sections);
        QCOMPARE(f.cell(0, PlanModel::Arrival), u"later"_s);
        const QString toolTip = f.model.index(0, PlanModel::Name).data(Qt::ToolTipRole).toString();
        QVERIFY2(toolTip.contains(u"on its way home"_s), qPrintable(toolTip));
    }

    void keptIcebergsHaveAPin()
    {
        Fixture f;
        f.panel.showPlan(twoUavs());
        const QModelIndex kept = f.model.index(4, PlanModel::Name);
        QVERIFY(kept.data(PlanModel::KeptRole).toBool());
        QVERIFY(!f.model.index(1, PlanModel::Name).data(PlanModel::KeptRole).toBool());
        QVERIFY(kept.data(Qt::ToolTipRole).toString().endsWith(u"Kept for uav-2"_s));
        QSignalSpy changed(&f.model, &QAbstractItemModel::dataChanged);
        std::vector<PlanSection> sections = twoUavs();
        sections[1].rows[0].isKept = false; // no text says so
        f.panel.showPlan(sections);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(changed.front().front().toModelIndex().row(), 4);
    }

    /** Events as the platform sends them while an iceberg is dragged. */
    void icebergIsDraggedToAUav()
    {
        Fixture f;
        f.panel.showPlan(twoUavs());
        QVERIFY(!f.model.flags(f.model.index(0, 0)).testFlag(Qt::ItemIsDragEnabled));
        QVERIFY(f.model.flags(f.model.index(1, 0)).testFlag(Qt::ItemIsDragEnabled));
        QSignalSpy handedOver(&f.panel, &PlanPanel::handedOver);
        const std::unique_ptr<QMimeData> data(f.model.mimeData({f.model.index(1, 0)}));
        const auto isMarked = [&](int row) {
            return f.model.index(row, 0).data(PlanModel::DropRole).toBool();
        };
        const QPoint at = f.centre(4); // any line of uav-2
        QDragEnterEvent enter(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
        QCoreApplication::sendEvent(f.table.viewport(), &enter);
        QDragMoveEvent move(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
        QCoreApplication::sendEvent(f.table.viewport(), &move);
        QVERIFY(move.isAccepted());
        QVERIFY(isMarked(3) && isMarked(4) && !isMarked(0));
        QDropEvent drop(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
        QCoreApplication::sendEvent(f.table.viewport(), &drop);
        QVERIFY(!isMarked(4));
        QCOMPARE(handedOver.count(), 1);
        QCOMPARE(handedOver.front()[0].value<std::string>(), "a");
        QCOMPARE(handedOver.front()[1].value<std::string>(), "uav-2");
        QCOMPARE(f.model.rowCount(), 5);
        QMimeData text;
        text.setText(u"a"_s);
        QVERIFY(!f.model.dropMimeData(&text, Qt::MoveAction, -1, -1, f.model.index(4, 0)));
    }

    void oneUavHasNothingToDrag()
    {
        Fixture f;
        f.panel.showPlan(visiting({"a", "b"}));
        QVERIFY(!f.model.flags(f.model.index(0, 0)).testFlag(Qt::ItemIsDragEnabled));
        QVERIFY(!f.model.flags(f.model.index(0, 0)).testFlag(Qt::ItemIsDropEnabled));
    }

    /** By the mouse for the row below it, by the menu key for the current one. */
    void menuIsForItsRow()
    {
        Fixture f;
        f.panel.showPlan(twoUavs());
        QSignalSpy menu(&f.panel, &PlanPanel::menuRequested);
        QContextMenuEvent click(QContextMenuEvent::Mouse, f.centre(2), {7, 8});
        QCoreApplication::sendEvent(f.table.viewport(), &click);
        QCOMPARE(menu.count(), 1);
        QCOMPARE(menu.back()[0].toPoint(), QPoint(7, 8));
        QCOMPARE(menu.back()[1].value<std::string>(), "b");
        QCOMPARE(lastId(f.activated), "b");
        f.table.setCurrentIndex(f.model.index(4, 0));
        QContextMenuEvent key(QContextMenuEvent::Keyboard, {}, {});
        QCoreApplication::sendEvent(&f.table, &key);
        QCOMPARE(menu.count(), 2);
        QCOMPARE(menu.back()[1].value<std::string>(), "c");
    }

    void columnsFitTheDock()
    {
        const test::LongerTexts longer;
        Fixture f;
        f.panel.showPlan(visiting(manyIds()));
        int width_px = 0;
        for (int column = 0; column < PlanModel::ColumnCount; ++column)
            width_px += f.table.columnWidth(column);
        QVERIFY(width_px <= f.table.viewport()->width());
        QVERIFY(f.table.columnWidth(PlanModel::Name) >=
                QFontMetrics(f.table.font()).horizontalAdvance(u"b39"_s));
    }
};

QTEST_MAIN(TestPlanPanel)
#include "tst_plan_panel.moc"
