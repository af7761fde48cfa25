#pragma once

#include "app/window/window_part.h"
#include "widgets/model/export_preview.h"

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

    /** As last chosen in another window. */
    void takeOver(const ResultFiles& other) { m_exportOptions = other.m_exportOptions; }
    void saveRun();
    /** The same before the window goes: pauses the flight; false when it is in no file then. */
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
    std::optional<bool> m_isRunSaved; ///< the one that was asked for last; none: no answer yet
};

} // namespace berg
