#pragma once

#include "app/dialogs/interaction.h"
#include "core/io/import/import_scenario_forecast.h"
#include "widgets/tasks/latest_task.h"

#include <QDialog>

#include <memory>
#include <optional>

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace berg {

/**
 * Shows the forecast of a scenario, reads another from a file on a thread of its own, cut to the
 * scenario's area and the time of its run, or removes it.
 */
class ForecastDialog : public QDialog
{
    Q_OBJECT

public:
    explicit ForecastDialog(ForecastOffer offer, QWidget* parent = nullptr);

    /** Reads a file and shows what would be set. */
    void read(const QString& path);
    /** Returns the forecast that is shown, or that none is left. */
    [[nodiscard]] ForecastChoice choice() const { return {.forecast = m_shown}; }

private:
    struct Request
    {
        QString path;
        std::shared_ptr<const Scenario> scenario;
    };
    /** Progress of reading, or its end with the reading. */
    struct Message
    {
        double share = 0;
        std::shared_ptr<const ForecastReading> reading;
    };

    void openFile();
    void takeMessage(const Message& message);
    void end(const std::optional<WorkFailure>& failure);
    /** Makes the result of the reading, with or without the present forecast. */
    void combine();
    void showShown();
    void showTable(const Forecast& forecast);
    [[nodiscard]] QString summary(const ForecastField& field) const;

    ForecastOffer m_offer;
    QString m_path;
    std::shared_ptr<const ForecastReading> m_reading; ///< null before a file was read
    std::optional<ForecastField> m_shown;
    std::vector<ForecastGap> m_gaps;
    QLabel* m_summary = nullptr;
    QLabel* m_note = nullptr;
    QTableWidget* m_table = nullptr;
    QProgressBar* m_progress = nullptr;
    QCheckBox* m_combine = nullptr;
    QPushButton* m_remove = nullptr;
    QPushButton* m_set = nullptr;
    /** Last member: its thread ends before the others are destroyed. */
    LatestTask<Request, Message> m_task;
};

} // namespace berg
