#pragma once

#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/plan/plan_model.h"
#include "widgets/panels/plan/plan_panel.h"

#include <QSignalSpy>
#include <QTableView>

// The plan panel with test plans.

namespace berg::test {

using namespace Qt::StringLiterals;

inline std::vector<PlanRow> rowsOf(const std::vector<std::string>& ids)
{
    std::vector<PlanRow> rows;
    for (const std::string& id : ids)
        rows.push_back({.id = id,
                        .name = QString::fromStdString(id),
                        .leg_m = 1000,
                        .arrival_s = 60 * static_cast<double>(rows.size() + 1),
                        .sigma_m2 = 4,
                        .number = static_cast<int>(rows.size()) + 1});
    return rows;
}

/** Returns the plan of a single UAV. */
inline std::vector<PlanSection> planOf(std::vector<PlanRow> rows, bool isPlanned = true)
{
    return {{.uav = "uav-1", .name = {}, .isPlanned = isPlanned, .rows = std::move(rows)}};
}

inline std::vector<PlanSection> visiting(const std::vector<std::string>& ids)
{
    return planOf(rowsOf(ids));
}

/** Returns a and b of uav-1, and c, which is assigned to uav-2. */
inline std::vector<PlanSection> twoUavSections()
{
    std::vector<PlanRow> assigned = rowsOf({"c"});
    assigned.front().isAssigned = true;
    return {{.uav = "uav-1", .name = u"West"_s, .place = 0, .rows = rowsOf({"a", "b"})},
            {.uav = "uav-2", .name = u"uav-2"_s, .place = 1, .rows = std::move(assigned)}};
}

inline std::vector<std::string> manyIds()
{
    std::vector<std::string> ids;
    for (int i = 0; i < 40; ++i)
        ids.push_back(u"b%1"_s.arg(i).toStdString());
    return ids;
}

/** Puts the plan into force for all its UAVs. */
inline void setPlan(MissionSnapshot& now, Plan plan)
{
    now.plan = std::make_shared<const Plan>(std::move(plan));
    now.plans.assign(now.plan->uavs.size(), now.plan);
}

/**
 * The UAV is at (0, 0), the icebergs are estimated at (300, 400) and, drifting, (300, 1000) at time
 * 100.
 */
inline MissionSnapshot twoIcebergs(const Scenario& scenario)
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
    now.wind = WindAhead(scenario.wind_mps);
    setPlan(now, {.uavs = {{.order = {0, 1}}}});
    now.assigned = {std::nullopt, std::nullopt};
    return now;
}

/** Returns the snapshot with its icebergs at their places, without drift. */
inline MissionSnapshot standing(MissionSnapshot now)
{
    for (Track& track : now.world.tracks) {
        track.anchor_m = track.estimate_m(now.time_s);
        track.anchor_s = now.time_s;
        track.velocity_mps = Point::Zero();
    }
    return now;
}

inline Scenario twoIcebergScenario()
{
    Scenario scenario = emptySea();
    scenario.uavs.front().spec.airspeed_mps = 20;
    addIceberg(scenario, 0, 0);
    addIceberg(scenario, 0, 0).name = "Tabular";
    return scenario;
}

struct PlanPanelFixture
{
    PlanPanel panel;
    QTableView& table = child<QTableView>(panel, u"planTable"_s);
    QAbstractItemModel& model = *table.model();
    QSignalSpy hovered{&panel, &PlanPanel::hovered};
    QSignalSpy activated{&panel, &PlanPanel::activated};

    PlanPanelFixture()
    {
        panel.setLocale(QLocale::c());
        panel.resize(kDock_px, 240);
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

inline std::string lastId(const QSignalSpy& spy)
{
    return spy.back().front().value<std::string>();
}

} // namespace berg::test
