#pragma once

#include <QString>

#include <array>

class QWidget;

namespace berg {

/** Manual section about a part of the window. */
struct ManualPlace
{
    const char* widget; ///< name of the object or of its class
    const char* place;  ///< "window#plan"
};

/** Sections for context help. */
inline constexpr std::array kManualPlaces{
    ManualPlace{"mapView", "window#map"},
    ManualPlace{"findBox", "window#find"},
    ManualPlace{"alarmStrip", "window#alarms"},
    ManualPlace{"berg::PlaybackBar", "window#playback"},
    ManualPlace{"flightCard", "window#end-of-flight"},
    ManualPlace{"tradeoffDock", "window#trade-off"},
    ManualPlace{"planDock", "window#plan"},
    ManualPlace{"inspectorDock", "window#inspector"},
    ManualPlace{"paretoDock", "window#trade-offs"},
    ManualPlace{"historyDock", "window#history"},
    ManualPlace{"zetaDock", "window#charts"},
    ManualPlace{"sigmaDock", "window#charts"},
    ManualPlace{"eventsDock", "window#events"},
    ManualPlace{"comparisonChartDock", "window#comparison"},
    ManualPlace{"checksDock", "window#checks"},
    ManualPlace{"solveTimeDock", "window#solve-time"},
    ManualPlace{"startsDock", "window#starts"},
    ManualPlace{"studyDock", "window#study"},
    ManualPlace{"comparisonDock", "window#comparison"},
    ManualPlace{"icebergsDock", "window#icebergs"},
    ManualPlace{"layersDock", "window#layers"},
    ManualPlace{"messagesDock", "window#messages"},
    ManualPlace{"aircraftDock", "window#aircraft"},
    ManualPlace{"startPage", "start#start-page"},
    ManualPlace{"tour", "start#first-flight"},
    ManualPlace{"berg::ExportDialog", "window#export"},
    ManualPlace{"berg::ImportDialog", "window#import"},
    ManualPlace{"berg::OriginDialog", "window#move"},
    ManualPlace{"berg::RecoveryDialog", "window#recovery"},
    ManualPlace{"berg::WindDialog", "window#wind"},
    ManualPlace{"generateDialog", "window#generate"},
};

/** Section about the widget or its nearest listed ancestor; otherwise the manual's beginning. */
[[nodiscard]] QString manualPlaceOf(const QWidget* widget);

} // namespace berg
