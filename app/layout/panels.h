#pragma once

#include <array>

class QUndoView;
class QWidget;

namespace berg {

class AircraftPanel;
class AlarmStrip;
class Announcer;
class ChartPanel;
class CheckPanel;
class ComparisonChart;
class ComparisonPanel;
class EventPanel;
class FindBox;
class LayersPanel;
class IcebergTable;
class InspectorPanel;
class MapView;
class MessageList;
class OverviewInset;
class ParetoChart;
class PlaceMark;
class PlanPanel;
class PlaybackBar;
class SolveTimePanel;
class StartPanel;
class StudyPanel;
class TradeoffPanel;
class Workspace;
struct Theme;

/** The map and the panels round it, not yet laid out; each belongs to the widget it is put in. */
struct Panels
{
    Panels(Workspace& workspace, const Theme& theme);

    void setTheme(const Theme& theme) const;
    /** Accepts a value that is being typed, as Return does. */
    void finishTyping() const;
    /** Alarms, map and playback bar. */
    [[nodiscard]] QWidget* makeCentre() const;

    MapView* map;
    PlaybackBar* playback;
    TradeoffPanel* tradeoff;
    PlanPanel* plan;
    InspectorPanel* inspector;
    std::array<ChartPanel*, 2> charts;
    ParetoChart* pareto;
    SolveTimePanel* solveTime;
    StartPanel* starts;
    StudyPanel* study;
    AlarmStrip* alarms;
    OverviewInset* overview;
    QUndoView* history;
    EventPanel* events;
    CheckPanel* checks;
    IcebergTable* icebergs;
    ComparisonPanel* comparison;
    ComparisonChart* comparisonChart;
    PlaceMark* placeMark;
    FindBox* findBox;
    LayersPanel* layers;
    MessageList* messages;
    Announcer* announcer;
    AircraftPanel* aircraft;
};

} // namespace berg
