#pragma once

#include "app/layout/window_part.h"
#include "core/io/import/airspace/import_airspace.h"
#include "core/io/import/maps/import_ice_chart.h"
#include "widgets/tasks/latest_task.h"

#include <QTemporaryDir>

#include <memory>
#include <optional>

namespace berg {

class ScenarioFiles;
class StartPageController;
struct ImportChoice;

/**
 * Sightings of real icebergs, ice charts and airspace from files of others or from the clipboard;
 * files dropped on the window. In flight they are reports: `reportsOf`.
 */
class SightingsImport : public WindowPart
{
    Q_OBJECT

public:
    SightingsImport(WindowContext& context, ScenarioFiles& files, StartPageController& start);

    void chooseSightings();
    void chooseAirspace();
    void chooseIceChart();
    /** Icebergs copied here or elsewhere, or a table of sightings, which the dialog reads. */
    void paste();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct AirspaceRequest
    {
        QString path;
        std::shared_ptr<const Scenario> into;
    };
    struct Airspace
    {
        QString path;
        std::shared_ptr<const Scenario> into; ///< as it was when reading began
        AirspaceResult result;
    };
    using AirspacePointer = std::shared_ptr<const Airspace>;
    [[nodiscard]] static AirspacePointer read(const AirspaceRequest& request,
                                              const std::stop_token& stop);

    struct IceChartFile
    {
        QString path;
        std::shared_ptr<const Scenario> into; ///< as it was when reading began
        std::optional<IceChartResult> result; ///< nullopt if the file is no ice chart
    };
    using IceChartPointer = std::shared_ptr<const IceChartFile>;
    [[nodiscard]] static IceChartPointer readIce(const AirspaceRequest& request,
                                                 const std::stop_token& stop);

    [[nodiscard]] bool mayImport();
    void readAirspace(const QString& path);
    void takeAirspace(const Airspace& airspace);
    void reportLeftOut(const AirspaceResult& result, const QString& summary);
    void readIceChart(const QString& path);
    void takeIceChart(const IceChartFile& file);
    void importSightings(const QString& path);
    void askSightings(const QString& path);
    void importInFlight(const QString& path);
    void askReports(const QString& path);
    void acceptImport(const ImportChoice& choice, const QString& fileName);
    void openDropped(const QString& path);

    ScenarioFiles& m_files;
    StartPageController& m_start;
    LatestTask<AirspaceRequest, AirspacePointer> m_airspace;
    LatestTask<AirspaceRequest, IceChartPointer> m_ice;
    QMetaObject::Connection m_pause; ///< until the flight pauses to take reports
    QTemporaryDir m_pasted;          ///< for the text of the clipboard
};

} // namespace berg
