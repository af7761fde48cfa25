#pragma once

#include "app/layout/window_part.h"
#include "widgets/flight/export_preview.h"

#include <vector>

namespace berg {

class ChartPanel;
struct RunFile;

/** Files of what was planned or flown: exports, runs, charts. */
class ResultFiles : public WindowPart
{
    Q_OBJECT

public:
    explicit ResultFiles(WindowContext& context);

    /** Takes over the choices of another window. */
    void takeOver(const ResultFiles& other) { m_exportOptions = other.m_exportOptions; }
    void saveRun();
    /** Pauses the flight and saves the run before the window closes; returns false if it is not
     * saved. */
    [[nodiscard]] bool saveRunNow();
    void exportPlan();
    /** In that format ("brief": the page to fly by, "log": of the run) unless another is chosen. */
    void chooseExport(const std::string& formatId);
    /** The map as it is, for other programs to paste. */
    void copyPicture();

private:
    [[nodiscard]] bool isStillOf(std::uint64_t generation);
    void writeExport(const std::vector<ExportFile>& files);
    [[nodiscard]] QString runPath();
    bool writeRun(const QString& path, const RunFile& run);
    void exportChart(const ChartPanel& chart);

    ExportOptions m_exportOptions;    ///< last chosen
    std::optional<bool> m_isRunSaved; ///< result of the last request; nullopt until it is known
};

} // namespace berg
