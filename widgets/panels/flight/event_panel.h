#pragma once

#include "widgets/flight/flight_record.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QTableView;

namespace berg {

class EventModel;

/** The event log of a mission; choosing a row goes to its instant. */
class EventPanel : public QWidget
{
    Q_OBJECT

public:
    explicit EventPanel(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Shows the log and follows its end unless the user has scrolled away from it. */
    void showRecord(const FlightRecord& record);

signals:
    void timeChosen(double time_s);

private:
    bool m_follows = true; ///< whether the view follows the end of the log
    EventModel* m_model;
    QTableView* m_table;
};

} // namespace berg
