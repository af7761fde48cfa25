#pragma once

#include "core/io/export/content/export_content.h"
#include "core/io/text/text_sink.h"

#include <span>
#include <string>
#include <string_view>

namespace berg {

/** Options that a user may choose for an export, besides its `ExportScope`. */
enum class ExportOption
{
    Uav,
    Altitude,
    Airspeed,
    Acceptance,
    Loiter,
    ReturnHome
};

/** Content that a file of a format can hold. */
struct ExportCapabilities
{
    bool order = false; ///< a path as waypoints
    bool path = false;  ///< a path as a line of any number of points
    bool fleet = false; ///< several UAVs; otherwise there is one file per UAV
    bool times = false; ///< dates, which need a start time
    bool icebergs = false;
    bool fence = false;
    bool flownOnly = false; ///< it concerns a whole flight, regardless of `ExportOptions::what`
    bool mission = false;   ///< items of an autopilot mission
    bool radii = false;     ///< acceptance radius, and turns over each iceberg
    bool altitude = false;  ///< altitudes of the UAVs
    bool airspeed = false;  ///< airspeeds of the UAVs, besides the times that result from them
    bool legHome = false;   ///< the leg home at the end of an order; a path includes it
    bool painted = false;   ///< a figure or page made by an `ExportPainter`
    bool gis = false;       ///< written by ogr2ogr, which may be missing, with flat properties
    bool predicted = false; ///< the zeta predicted before take-off

    /** Returns true if a file of this content depends on the option. */
    [[nodiscard]] bool dependsOn(ExportOption option, const ExportContent& content) const;
};

/** Groups of formats with similar readers. */
enum class ExportGroup
{
    Autopilots,
    Maps,
    Pages, ///< images and print
    Tables
};

/** English texts about a format, which the window translates (`ExportText`). */
struct ExportWords
{
    ExportGroup group = ExportGroup::Tables;
    const char* name = "";  ///< "GPX"; %1 stands for the extension in capitals
    const char* tool = "";  ///< program or device for which the format is meant
    const char* about = ""; ///< content of a file, in sentences
};

/** Row of the table of formats that the command line, the file dialog and the tests share. */
struct ExportFormat
{
    std::string_view id;        ///< e.g. "plan"
    std::string_view extension; ///< without dot
    std::string_view reader;    ///< programs for which the format is meant
    ExportCapabilities holds;
    /** Writes the file, for one UAV unless it holds a fleet; null for painted formats. */
    void (*put)(const ExportContent&, const TextSink&) = nullptr;
    /** Table of the format, for writing it while a run is replayed; null if it is no such table. */
    const SampleTable* table = nullptr;
    ExportWords words = {};

    /**
     * Returns the whole text that `put` writes. The format must not be painted: its `put` is null.
     * Throws `Error{InvalidInput}` for a `flownOnly` format without a mission, and as its writer.
     */
    [[nodiscard]] std::string text(const ExportContent& content) const;

    /**
     * Returns the `exportContent` for a file of this format: `flownOnly` formats ignore the
     * options, but check them. Throws as `exportContent`.
     */
    [[nodiscard]] ExportContent content(const ExportSource& source,
                                        const ExportOptions& options = {}) const;

    /**
     * Returns the text of one file. Throws as `exportContent`, `Error{InvalidInput}` if there are
     * more UAVs than it holds (`exportFiles` makes one file for each), and Unsupported for painted
     * formats.
     */
    [[nodiscard]] std::string write(const ExportSource& source,
                                    const ExportOptions& options = {}) const;
};

/** Returns all formats. */
[[nodiscard]] std::span<const ExportFormat> exportFormats();
/** Returns the format with this id, or null if there is none. */
[[nodiscard]] const ExportFormat* findExportFormat(std::string_view id);

} // namespace berg
