#pragma once

#include "core/io/export/export_content.h"
#include "core/io/text/text_sink.h"

#include <span>
#include <string>
#include <string_view>

namespace berg {

/** What a user may choose about an export, besides its `ExportWhat`. */
enum class ExportOption
{
    Uav,
    Altitude,
    Airspeed,
    Acceptance,
    Loiter,
    ReturnHome
};

/** What a file of a format can hold. */
struct ExportHolds
{
    bool order = false; ///< a way as waypoints
    bool path = false;  ///< a way as a line of any number of points
    bool fleet = false; ///< several UAVs; else one file each
    bool times = false; ///< dates, so only with a start time
    bool icebergs = false;
    bool fence = false;
    bool flownOnly = false; ///< it is about a flight, whatever `ExportOptions::what` says
    bool mission = false;   ///< items for an autopilot
    bool radii = false;     ///< acceptance radius and turns over each iceberg
    bool altitude = false;  ///< of the UAVs
    bool airspeed = false;  ///< of the UAVs, besides the times it leads to
    bool wayHome = false;   ///< at the end of an order; of a path it is part of the line
    bool painted = false;   ///< a picture or a page: an `ExportPainter` makes it
    bool predicted = false; ///< zeta that was predicted before take-off

    /** Whether a file of this content depends on the option. */
    [[nodiscard]] bool dependsOn(ExportOption option, const ExportContent& content) const;
};

/** One row of the table that the command line, the file dialog and the tests share. */
struct ExportFormat
{
    std::string_view id;        ///< e.g. "plan"
    std::string_view extension; ///< without dot
    std::string_view reader;    ///< the tool it is meant for
    ExportHolds holds;
    /** Of one UAV unless it holds a fleet; null: painted. */
    void (*put)(const ExportContent&, const TextSink&) = nullptr;
    /** The table that it is, for who writes it while a run is flown again; null: none. */
    const SampleTable* table = nullptr;

    /** All that is put. */
    [[nodiscard]] std::string text(const ExportContent& content) const;

    /** `exportContent` of what a file of it is about: a whole flight is as the scenario says. */
    [[nodiscard]] ExportContent content(const ExportSource& source,
                                        const ExportOptions& options = {}) const;

    /**
     * One file of it. Throws as `exportContent`, and `Error{InvalidInput}` when there are more UAVs
     * than it holds (`exportFiles` makes one for each), Unsupported for what is painted.
     */
    [[nodiscard]] std::string write(const ExportSource& source,
                                    const ExportOptions& options = {}) const;
};

[[nodiscard]] std::span<const ExportFormat> exportFormats();
/** Null when there is no such format. */
[[nodiscard]] const ExportFormat* findExportFormat(std::string_view id);

} // namespace berg
