#include "core/presets/presets.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/flight/event_model.h"
#include "widgets/panels/flight/event_panel.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTableView>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

FlightRecord recordUntil(double until_s, double tau = 1)
{
    Scenario scenario = randomScenario(6, {.icebergs = 7});
    scenario.duration_s = 400;
    scenario.planner.tau = tau;
    Mission mission(scenario);
    mission.advance(until_s / 2);
    mission.intervene({.tau = 0.5});
    mission.advance(until_s);
    return recordOf(mission);
}

QString cell(const EventModel& model, int row, int column)
{
    return model.data(model.index(row, column), Qt::DisplayRole).toString();
}

} // namespace

class TestEventPanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void everyEventHasItsRow()
    {
        const FlightRecord record = recordUntil(400);
        EventModel model{QLocale::c()};
        const QAbstractItemModelTester tester(&model);
        model.setHistory(record.history, record.now.icebergs, record.scenario.uavs);
        QCOMPARE(model.rowCount(), static_cast<int>(record.history.events.size()));
        std::size_t plans = 0;
        for (int row = 0; row < model.rowCount(); ++row) {
            const MissionEvent& event = record.history.events[static_cast<std::size_t>(row)];
            QCOMPARE(model.time_s(row), event.time_s);
            QVERIFY(!cell(model, row, EventModel::What).isEmpty());
            const QString details = cell(model, row, EventModel::Details);
            QCOMPARE(details.isEmpty(), event.kind != EventKind::Planned);
            if (event.kind == EventKind::Planned) {
                const QString order = model.data(model.index(row, 0), Qt::ToolTipRole)
                                          .toString()
                                          .section(u'\n', 0, 0);
                QCOMPARE(order.split(u", "_s).size(),
                         qsizetype(record.history.plans[plans]->uavs[0].order.size()));
                ++plans;
            }
        }
        QCOMPARE(plans, record.history.plans.size());
        QVERIFY(cell(model, 0, EventModel::Details).startsWith(u"take-off"_s));
    }

    /** Each pass of an aim point makes a plan; plans that lead to the same iceberg are omitted. */
    void endsOfHoldsAreLeftOut()
    {
        FlightRecord record = recordUntil(400);
        MissionHistory& history = record.history;
        const auto add = [&](double time_s, IcebergIndex iceberg, PlanReason reason) {
            history.events.push_back({.time_s = time_s, .iceberg = iceberg, .uav = 0});
            history.plans.push_back(std::make_shared<const Plan>(
                Plan{.time_s = time_s, .uavs = {{.order = {iceberg}, .reason = reason}}}));
        };
        EventModel model{QLocale::c()};
        const QAbstractItemModelTester tester(&model);
        model.setHistory(history, record.now.icebergs, record.scenario.uavs);
        const int rows = model.rowCount();
        const IcebergIndex next = history.plans.back()->uavs[0].target().value();
        add(400.1, next, PlanReason::HoldFlown);
        add(400.2, next, PlanReason::HoldFlown);
        add(400.3, next == 0 ? IcebergIndex(1) : IcebergIndex(0), PlanReason::HoldFlown);
        model.setHistory(history, record.now.icebergs, record.scenario.uavs);
        QCOMPARE(model.rowCount(), rows + 1);
        QCOMPARE(model.time_s(rows), 400.3);
        model.setShown(history.events.size() - 1);
        QCOMPARE(model.shownRows(), rows);
        model.setShown(history.events.size());
        QCOMPARE(model.shownRows(), rows + 1);
    }

    /** A UAV with nothing to visit is planned at every step: that is listed once. */
    void uselessPlansAreListedOnce()
    {
        FlightRecord record = recordUntil(400);
        MissionHistory& history = record.history;
        const auto add = [&](double time_s, std::optional<IcebergIndex> iceberg) {
            history.events.push_back({.time_s = time_s, .iceberg = iceberg, .uav = 0});
            history.plans.push_back(std::make_shared<const Plan>(
                Plan{.time_s = time_s, .uavs = {{.reason = PlanReason::OutOfView}}}));
        };
        EventModel model{QLocale::c()};
        model.setHistory(history, record.now.icebergs, record.scenario.uavs);
        const int rows = model.rowCount();
        for (int step = 1; step <= 50; ++step)
            add(400 + 0.1 * step, std::nullopt);
        model.setHistory(history, record.now.icebergs, record.scenario.uavs);
        QCOMPARE(model.rowCount(), rows + 1);
        QCOMPARE(model.time_s(rows), 400.1);
        add(406, IcebergIndex(0));
        add(407, std::nullopt);
        model.setHistory(history, record.now.icebergs, record.scenario.uavs);
        QCOMPARE(model.rowCount(), rows + 3); // it had something to visit in between
    }

    /** A re-plan has a row for each UAV; the first one states how it was solved. */
    void fleetsListEachSolveOnce()
    {
        Scenario scenario = randomScenario(6, {.icebergs = 7});
        scenario.duration_s = 200;
        scenario.uavs.push_back(scenario.uavs.front());
        scenario.uavs[1].id = "uav-2";
        scenario.uavs[1].position_m += Point(3000, 3000);
        Mission mission(scenario);
        mission.advance(200);
        const FlightRecord record = recordOf(mission);
        EventModel model{QLocale::c()};
        model.setHistory(record.history, record.now.icebergs, record.scenario.uavs);
        QVERIFY(cell(model, 0, EventModel::What).startsWith(u"uav-1 flies to "_s));
        QVERIFY(cell(model, 1, EventModel::What).startsWith(u"uav-2 flies to "_s));
        QVERIFY(cell(model, 0, EventModel::Details).contains(u" · "_s));
        QVERIFY(!cell(model, 1, EventModel::Details).contains(u" · "_s));
    }

    /** A log grown step by step, or cut and grown differently, equals one shown at once. */
    void growsAndShrinks()
    {
        EventModel model{QLocale::c()};
        const QAbstractItemModelTester tester(&model);
        std::uint64_t rewrites = 0;
        for (FlightRecord record : {recordUntil(100), recordUntil(250), recordUntil(250),
                                    recordUntil(400, 3), recordUntil(60), FlightRecord()}) {
            record.history.rewrites = ++rewrites; // each is another run
            model.setHistory(record.history, record.now.icebergs, record.scenario.uavs);
            EventModel fresh{QLocale::c()};
            fresh.setHistory(record.history, record.now.icebergs, record.scenario.uavs);
            QCOMPARE(model.rowCount(), fresh.rowCount());
            for (int row = 0; row < model.rowCount(); ++row)
                for (int column = 0; column < model.columnCount(); ++column)
                    QCOMPARE(cell(model, row, column), cell(fresh, row, column));
        }
    }

    void whatIsAheadIsMarked()
    {
        const FlightRecord record = recordUntil(400);
        EventModel model{QLocale::c()};
        model.setHistory(record.history, record.now.icebergs, record.scenario.uavs);
        QSignalSpy changed(&model, &EventModel::dataChanged);
        model.setShown(3);
        model.setShown(3);
        QCOMPARE(changed.count(), 1);
        for (int row = 0; row < model.rowCount(); ++row)
            QCOMPARE(model.data(model.index(row, 0), EventModel::AheadRole).toBool(), row >= 3);
    }

    void aRowTakesOneToItsInstant()
    {
        EventPanel panel;
        panel.resize(500, 300);
        panel.show();
        FlightRecord record = recordUntil(400);
        panel.showRecord(record);
        auto& table = test::child<QTableView>(panel, u"eventTable"_s);
        QSignalSpy chosen(&panel, &EventPanel::timeChosen);
        const QModelIndex index = table.model()->index(table.model()->rowCount() - 2, 1);
        table.scrollTo(index);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(index).center());
        QVERIFY(chosen.count() >= 1);
        QCOMPARE(chosen.front().front().toDouble(),
                 record.history.events[static_cast<std::size_t>(index.row())].time_s);
        table.setCurrentIndex(table.model()->index(0, 0));
        table.setFocus();
        chosen.clear();
        QTest::keyClick(&table, Qt::Key_Return);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.front().front().toDouble(), 0.0);
    }
};

QTEST_MAIN(TestEventPanel)
#include "tst_event_panel.moc"
