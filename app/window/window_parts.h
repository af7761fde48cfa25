#pragma once

#include "app/window/alarm_sound.h"
#include "app/window/appearance_choice.h"
#include "app/window/backdrop_file.h"
#include "app/window/benchmark_controller.h"
#include "app/window/checks_view.h"
#include "app/window/comparison_view.h"
#include "app/window/context_menus.h"
#include "app/window/docks.h"
#include "app/window/flight_controls.h"
#include "app/window/flight_panels.h"
#include "app/window/flight_view.h"
#include "app/window/history_actions.h"
#include "app/window/manual_help.h"
#include "app/window/map_controller.h"
#include "app/window/menus.h"
#include "app/window/planner_view.h"
#include "app/window/preference_menus.h"
#include "app/window/result_files.h"
#include "app/window/run_summary_controller.h"
#include "app/window/scenario_dialogs.h"
#include "app/window/scenario_files.h"
#include "app/window/sightings_import.h"
#include "app/window/start_page_controller.h"
#include "app/window/status_line.h"
#include "app/window/study_controller.h"
#include "app/window/study_flights.h"
#include "app/window/unsaved_work_guard.h"

namespace berg {

/** The parts of a window, in the order of what they use. */
struct WindowParts
{
    explicit WindowParts(WindowContext& context);

    StatusLine status;
    Docks docks;
    ScenarioFiles files;
    ResultFiles results;
    StartPageController start;
    SightingsImport sightings;
    ScenarioDialogs dialogs;
    StudyController study;
    BenchmarkController solveTimes;
    StudyFlights studyFlights;
    UnsavedWorkGuard safety;
    ChecksView checks;
    ComparisonView comparison;
    PlannerView planner;
    FlightPanels flightPanels;
    FlightView flightView;
    AlarmSound sound;
    FlightControls flight;
    RunSummaryController runEnd;
    MapController mapLinks;
    BackdropFile backdrop;
    AppearanceChoice appearance;
    PreferenceMenus preferences;
    ManualHelp manual;
    HistoryActions history;
    Menus menus;
    ContextMenus contextMenus;
};

} // namespace berg
