#pragma once

#include "widgets/model/flight_record.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QTableView;

namespace berg {

class EventModel;

/** The log of a mission; a row chosen takes one to its instant. */
class EventPanel : public QWidget
{
    Q_OBJECT

public:
    explicit EventPanel(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Follows the end of the log unless the user has scrolled away from it. */
    void showRecord(const FlightRecord& record);

signals:
    void timeChosen(double time_s);

private:
    bool m_follows = true; ///< the end of the log; not while the user reads elsewhere
    EventModel* m_model;
    QTableView* m_table;
};

} // namespace berg
