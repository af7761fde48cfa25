#include "tests/support/approx.h"
#include "tests/support/window/patience.h"
#include "tests/support/window/plan_panel_fixture.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/plan/plan_delegate.h"

#include <QContextMenuEvent>
#include <QLabel>
#include <QScrollBar>

#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;
using namespace berg::test;

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
            planSections(standing(twoIcebergs(scenario)), scenario).front().rows;
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
            planSections(standing(twoIcebergs(scenario)), scenario).front().rows;
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

    void cellsHaveWordsAndUnits()
    {
        PlanPanelFixture f;
        const PlanRow row{.id = "berg-7",
                          .name = u"Tabular"_s,
                          .leg_m = 1852,
                          .arrival_s = 86,
                          .sigma_m2 = 8.1,
                          .arrivalSigma_m2 = 10.25,
                          .number = 1};
        f.panel.showPlan(planOf(std::vector{row}));
        QCOMPARE(f.cell(0, PlanModel::ArrivalSigma), u"10.3"_s);
        QCOMPARE(f.cell(0, PlanModel::Number), u"1"_s);
        QCOMPARE(f.cell(0, PlanModel::Name), u"Tabular"_s);
        QCOMPARE(f.cell(0, PlanModel::Leg), u"1.85 km"_s);
        QCOMPARE(f.cell(0, PlanModel::Arrival), u"in 01:26"_s);
        QCOMPARE(f.cell(0, PlanModel::Sigma), u"8.10"_s);
        QCOMPARE(
            f.model.headerData(PlanModel::ArrivalSigma, Qt::Horizontal, Qt::DisplayRole).toString(),
            u"σ, m²"_s);
        QVERIFY(f.model.headerData(PlanModel::ArrivalSigma, Qt::Horizontal, Qt::ToolTipRole)
                    .toString()
                    .contains(u"on arrival"_s));
        QCOMPARE(f.model.index(0, PlanModel::ArrivalSigma).data(PlanModel::SigmaRole).toDouble(),
                 10.25);
        const QString toolTip = f.model.index(0, PlanModel::Sigma).data(Qt::ToolTipRole).toString();
        QVERIFY2(toolTip.contains(u"6.97 m"_s), qPrintable(toolTip)); // root of 5.99 by 8.1
        QVERIFY2(toolTip.contains(u"10.3 m²"_s), qPrintable(toolTip));
    }

    void summaryShowsLengthEndAndZeta()
    {
        PlanPanelFixture f;
        f.panel.resize(600, 240);
        const auto& summary = test::child<QLabel>(f.panel, u"planSummary"_s);
        QVERIFY(summary.text().isEmpty());
        f.panel.showPlan(visiting({"a", "b", "c"})); // 1 km each, the last in 3 min
        QCOMPARE(summary.text(), u"This sortie: 3.00 km, flown in 03:00"_s);
        f.panel.showOutlook(PlanOutlook{.zeta_m2s = 84423, .isInFlight = true});
        QCOMPARE(summary.text().section(u'\n', 1),
                 u"Expected ζ at the end with this plan: 84\u202f420 m² s"_s);
        f.panel.showPlan(planOf(std::vector<PlanRow>(), false));
        QVERIFY(test::child<QLabel>(f.panel, u"planEmpty"_s).text().contains(u"No plan while"_s));
        f.panel.showPlan({});
        f.panel.showOutlook(std::nullopt);
        QVERIFY(summary.text().isEmpty());
    }

    /** With several UAVs the panel shows the least margin and the longest time without contact. */
    void summaryShowsMarginsAndContact()
    {
        PlanPanelFixture f;
        f.panel.resize(600, 300);
        const auto& summary = test::child<QLabel>(f.panel, u"planSummary"_s);
        f.panel.showSorties(
            {PlannedSortie{.outlook = {.margin_s = 300, .noContact_s = 61}, .lowMargin_s = 200},
             std::nullopt, PlannedSortie{.outlook = {.margin_s = 90}, .lowMargin_s = -30}});
        QCOMPARE(summary.text(), u"Home with 01:30 above the reserve\n"
                                 "1 flight in 20 uses 00:30 or more of the reserve\n"
                                 "Out of radio range for 01:01"_s);
    }

    /** UAVs are listed in order of landing. */
    void summaryShowsTheLandingOrder()
    {
        PlanPanelFixture f;
        f.panel.resize(600, 300);
        f.panel.showSorties(
            {PlannedSortie{
                 .outlook = {.margin_s = 300}, .lowMargin_s = 200, .slot_s = 750, .uav = "second"},
             PlannedSortie{
                 .outlook = {.margin_s = 310}, .lowMargin_s = 200, .slot_s = 720, .uav = "first"}});
        QCOMPARE(test::child<QLabel>(f.panel, u"planSummary"_s).text(),
                 u"Home with 05:00 above the reserve\n"
                 "1 flight in 20: 03:20 or less above the reserve\n"
                 "Recovery slots: first 12:00, second 12:30"_s);
    }

    void summaryShowsTheCostOfAChange()
    {
        PlanPanelFixture f;
        f.panel.resize(600, 240);
        const auto& summary = test::child<QLabel>(f.panel, u"planSummary"_s);
        f.panel.showPlan(visiting({"a", "b"}));
        PlanOutlook outlook{.zeta_m2s = 5000,
                            .isInFlight = true,
                            .change =
                                PlanChange{.before = {1, 0}, .distance_m = 1234, .zeta_m2s = -567},
                            .changed_s = 83,
                            .before = u"b, a"_s};
        f.panel.showOutlook(outlook);
        QCOMPARE(summary.text().section(u'\n', 2),
                 u"Compared with the last plan: +1.2 km, ζ −570 m² s"_s);
        QVERIFY2(summary.toolTip().contains(u"01:23: b, a"_s), qPrintable(summary.toolTip()));
        outlook.change->distance_m = -850;
        outlook.change->zeta_m2s = 40;
        f.panel.showOutlook(outlook);
        QCOMPARE(summary.text().section(u'\n', 2),
                 u"Compared with the last plan: −850 m, ζ +40 m² s"_s);
        outlook.isInFlight = false; // zeta is shown with the policy, for the whole flight
        f.panel.showOutlook(outlook);
        QCOMPARE(summary.text().section(u'\n', 1), u"Compared with the last plan: −850 m"_s);
    }

    void outlookOfAPartShowsItsEnd()
    {
        PlanPanelFixture f;
        f.panel.showPlan(visiting({"a"}));
        f.panel.showOutlook(
            PlanOutlook{.zeta_m2s = 84423, .isInFlight = true, .until_s = 800, .isAimed = true});
        const auto& summary = test::child<QLabel>(f.panel, u"planSummary"_s);
        QCOMPARE(summary.text().section(u'\n', 1),
                 u"Expected ζ at 13:20 with this plan: 84\u202f420 m² s"_s);
        QVERIFY(!summary.toolTip().contains(u"straight"_s));
    }

    void summaryShowsTheLowerBound()
    {
        PlanPanelFixture f;
        f.panel.resize(600, 240);
        f.panel.showPlan(visiting({"a"}));
        PlanOutlook outlook{
            .zeta_m2s = 84423, .isInFlight = true, .bound_m2s = 49870, .boundShare = 0.4};
        f.panel.showOutlook(outlook);
        const auto& summary = test::child<QLabel>(f.panel, u"planSummary"_s);
        QCOMPARE(summary.text().section(u'\n', 2), u"Lower bound on ζ: being computed, 40 %"_s);
        outlook.bound_m2s = 51770;
        outlook.boundShare = 1;
        f.panel.showOutlook(outlook);
        QCOMPARE(summary.text().section(u'\n', 2), u"Lower bound on ζ: 51\u202f770 m² s"_s);
        QVERIFY(summary.toolTip().contains(u"proven"_s));
        QVERIFY(!summary.toolTip().contains(u"visit rates"_s));
        outlook.isBoundFromRates = true;
        f.panel.showOutlook(outlook);
        QVERIFY(summary.toolTip().contains(u"visit rates"_s));
        outlook.isBoundFromRates = false;
        f.panel.showOutlook(outlook);
        QVERIFY(summary.toolTip().contains(u"visit sequences"_s));
        outlook.bound_m2s = 0.19 * outlook.zeta_m2s; // a useless bound
        f.panel.showOutlook(outlook);
        QCOMPARE(summary.text().section(u'\n', 2), u"No useful lower bound on ζ"_s);
    }

    /** A plan with aim points may end before all are seen: no cell is empty or invented. */
    void icebergsThatThePlanDoesNotSee()
    {
        PlanPanelFixture f;
        std::vector<PlanRow> rows = rowsOf({"a", "b"});
        const QString arrival = TimesAhead{}.text(rows[0].arrival_s);
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
        PlanPanelFixture f;
        f.panel.resize(150, 240);
        f.panel.showPlan(visiting({"a"}));
        f.panel.showOutlook(PlanOutlook{.zeta_m2s = 84423, .isInFlight = true});
        const auto& summary = test::child<QLabel>(f.panel, u"planSummary"_s);
        QVERIFY(summary.text().endsWith(u'…'));
        QVERIFY2(summary.toolTip().contains(u"84\u202f420 m² s"_s), qPrintable(summary.toolTip()));
        QCOMPARE(f.panel.width(), 150);
    }

    void columnsHoldTheirTexts()
    {
        PlanPanelFixture f;
        f.panel.showPlan(planOf({{.id = "a", .leg_m = 682, .arrival_s = 11.5 * 3600},
                                 {.id = "b", .leg_m = 8880, .arrival_s = 101.9 * 3600}}));
        for (const PlanModel::Column column : {PlanModel::Leg, PlanModel::Arrival})
            for (const int row : {0, 1})
                QVERIFY2(f.table.fontMetrics().horizontalAdvance(f.cell(row, column)) <
                             f.table.columnWidth(column),
                         qPrintable(f.cell(row, column)));
    }

    void furtherColumnNeedsRoom()
    {
        PlanPanelFixture f;
        f.panel.showPlan(visiting({"a"}));
        f.panel.resize(500, 240);
        QVERIFY(!f.table.isColumnHidden(PlanModel::Sigma));
        QVERIFY(f.table.columnWidth(PlanModel::Sigma) > 0);
        f.panel.resize(240, 240);
        QVERIFY(!f.table.isColumnHidden(PlanModel::ArrivalSigma));
        QVERIFY(f.table.isColumnHidden(PlanModel::Sigma));
        f.panel.resize(500, 240);
        QVERIFY(!f.table.isColumnHidden(PlanModel::Sigma));
    }

    /** Hundreds of ids that differ only at their ends, in a run of hours, beside a scroll bar. */
    void idsAreDistinguished()
    {
        PlanPanelFixture f;
        std::vector<std::string> ids;
        for (int i = 300; i < 340; ++i)
            ids.push_back("berg-" + std::to_string(i));
        std::vector<PlanRow> rows = rowsOf(ids);
        rows.back().arrival_s = 5 * 3600.0;
        f.panel.showPlan(planOf(rows));
        constexpr int kMargins_px = 8;
        const int room_px = f.table.columnWidth(PlanModel::Name) - kMargins_px;
        const QFontMetrics metrics(f.table.font());
        QSet<QString> shown;
        for (const PlanRow& row : rows)
            shown << metrics.elidedText(row.name, f.table.textElideMode(), room_px);
        QCOMPARE(shown.size(), static_cast<qsizetype>(ids.size()));
    }

    /** Course and ground speed have columns where all others leave room, and are in tool tips. */
    void coursesAreShownWhereThereIsRoom()
    {
        PlanPanelFixture f;
        std::vector<PlanRow> rows{{.id = "a", .leg_m = 10}};
        rows[0].course = {.true_deg = 45, .declination_deg = -18, .groundSpeed_mps = 26.2};
        f.panel.showPlan(planOf(rows));
        f.panel.resize(test::kDock_px, 240);
        QVERIFY(f.table.isColumnHidden(PlanModel::Course));
        const auto& drawn = *qobject_cast<const PlanDelegate*>(f.table.itemDelegate());
        const auto below = [&](PlanModel::Column column) {
            return drawn.textBelow(f.model.index(0, column));
        };
        QCOMPARE(below(PlanModel::Name), u"045° T / 063° M"_s);
        QCOMPARE(below(PlanModel::Leg), u"26.2 m/s"_s);
        QCOMPARE(below(PlanModel::Arrival), QString());
        const int tall_px = f.table.rowHeight(0);
        f.panel.resize(700, 240);
        QCOMPARE(below(PlanModel::Name), QString());
        QCOMPARE(below(PlanModel::Leg), QString());
        QVERIFY(f.table.rowHeight(0) < tall_px);
        QVERIFY(!f.table.isColumnHidden(PlanModel::Course));
        QVERIFY(!f.table.isColumnHidden(PlanModel::GroundSpeed));
        QCOMPARE(f.cell(0, PlanModel::Course), u"045° T / 063° M"_s);
        QCOMPARE(f.cell(0, PlanModel::GroundSpeed), u"26.2 m/s"_s);
        const QString tip = f.model.index(0, PlanModel::Leg).data(Qt::ToolTipRole).toString();
        QVERIFY(tip.contains(u"063° M"_s) && tip.contains(u"26.2 m/s"_s));
    }

    /** The chance of being in view is shown if an iceberg may be missed. */
    void chanceIsShownWhenItMatters()
    {
        PlanPanelFixture f;
        f.panel.resize(600, 240);
        std::vector<PlanRow> rows{{.id = "a", .leg_m = 10, .chance = 0.9951},
                                  {.id = "b", .leg_m = 10}};
        f.panel.showPlan(planOf(rows));
        QVERIFY(f.table.isColumnHidden(PlanModel::Chance));
        rows[0].chance = 0.414;
        f.panel.showPlan(planOf(rows));
        QVERIFY(!f.table.isColumnHidden(PlanModel::Chance));
        QCOMPARE(f.cell(0, PlanModel::Chance), u"41 %"_s);
        QCOMPARE(f.cell(1, PlanModel::Chance), missingValueText()); // it depends on the aim
        f.panel.resize(test::kDock_px, 240);                        // names stay readable
        QVERIFY(!f.table.isColumnHidden(PlanModel::Chance));
        QVERIFY(f.table.isColumnHidden(PlanModel::ArrivalSigma));
        QVERIFY(f.table.columnWidth(PlanModel::Name) >= 60);
        rows[0].chance = 1;
        f.panel.showPlan(planOf(rows));
        QVERIFY(f.table.isColumnHidden(PlanModel::Chance));
        QVERIFY(!f.table.isColumnHidden(PlanModel::ArrivalSigma));
    }

    /** The view covers one standard deviation to each side on both axes. */
    void chanceOnArrival()
    {
        Scenario scenario = twoIcebergScenario();
        scenario.uavs[0].fov_m = Point(600, 600);
        MissionSnapshot now = standing(twoIcebergs(scenario));
        for (Track& track : now.world.tracks)
            track.sigma_m2 = 300.0 * 300.0;
        const std::vector<PlanRow> rows = planSections(now, scenario).front().rows;
        COMPARE_NEAR(rows[0].chance.value(), 0.6826894921 * 0.6826894921, 1e-3); // it grows by q
        QVERIFY(rows[1].chance.value() < rows[0].chance.value());
        // From the middle between the two, each is at the edge of the view or outside.
        setPlan(now, {.uavs = {{.order = {0, 1}, .clusters = {{0, 1}}}}});
        QVERIFY(planSections(now, scenario).front().rows[0].chance.value() <
                rows[0].chance.value() / 1.5);
    }

    void onlyChangedRowsAreRedrawn()
    {
        PlanPanelFixture f;
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
        PlanPanelFixture f;
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
        PlanPanelFixture f;
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
        PlanPanelFixture f;
        f.panel.showPlan(visiting({"a", "b", "c"}));
        f.table.setCurrentIndex(f.model.index(0, 0));
        QTest::keyClick(&f.table, Qt::Key_Down);
        f.panel.showPlan(visiting({"a", "b", "c"})); // an update keeps the new current row
        QCOMPARE(f.chosenRow(), 1);
        QCOMPARE(lastId(f.activated), "b"); // each step selects
        const qsizetype steps = f.activated.count();
        QTest::keyClick(&f.table, Qt::Key_Return);
        QCOMPARE(f.activated.count(), steps + 1);
        QCOMPARE(lastId(f.activated), "b");
    }

    void pointerIdentifiesTheIceberg()
    {
        PlanPanelFixture f;
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
        PlanPanelFixture f;
        f.panel.showPlan(visiting({"a", "b"}));
        f.panel.setHighlight("b");
        QVERIFY(!f.model.index(0, 0).data(PlanModel::HighlightRole).toBool());
        QVERIFY(f.model.index(1, 0).data(PlanModel::HighlightRole).toBool());
        f.panel.setHighlight({});
        QVERIFY(!f.model.index(1, 0).data(PlanModel::HighlightRole).toBool());
        QCOMPARE(f.hovered.count() + f.activated.count(), 0);
    }

    void emptyPlanShowsTheReason()
    {
        PlanPanelFixture f;
        f.panel.showPlan({});
        QVERIFY(test::child<QLabel>(f.panel, u"planEmpty"_s).isVisible());
        f.panel.showPlan(visiting({"a"}));
        QVERIFY(!test::child<QLabel>(f.panel, u"planEmpty"_s).isVisible());
    }

    /** The mouse opens the menu of the row below it, the menu key that of the current row. */
    void menuIsForItsRow()
    {
        PlanPanelFixture f;
        f.panel.showPlan(twoUavSections());
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
        PlanPanelFixture f;
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
