#pragma once

#include "app/files/result_files.h"
#include "app/files/scenario_dialogs.h"
#include "app/files/scenario_files.h"
#include "app/files/sightings_import.h"
#include "app/files/start_page_controller.h"
#include "app/flight/aircraft_controller.h"
#include "app/flight/alarm_sound.h"
#include "app/flight/flight_panels.h"
#include "app/flight/flight_view.h"
#include "app/flight/run_summary_controller.h"
#include "app/layout/docks.h"
#include "app/layout/status_line.h"
#include "app/map/backdrop_file.h"
#include "app/map/map_controller.h"
#include "app/settings/appearance_choice.h"
#include "app/settings/preference_menus.h"
#include "app/study/benchmark_controller.h"
#include "app/study/study_controller.h"
#include "app/study/study_flights.h"
#include "app/window/context_menus.h"
#include "app/window/manual_help.h"
#include "app/window/menus.h"
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
    FlightPanels flightPanels;
    FlightView flightView;
    AlarmSound sound;
    RunSummaryController runEnd;
    AircraftController aircraft;
    MapController mapLinks;
    BackdropFile backdrop;
    AppearanceChoice appearance;
    PreferenceMenus preferences;
    ManualHelp manual;
    Menus menus;
    ContextMenus contextMenus;
};

} // namespace berg
