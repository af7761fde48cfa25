#pragma once

#include "widgets/aircraft/link_status.h"

#include <QWidget>

#include <cstdint>

class QComboBox;
class QPushButton;

namespace berg {

/** Ice that a radar tracks or AIS marks, to be reported as a sighting; hidden without any. */
class IceRow : public QWidget
{
    Q_OBJECT

public:
    explicit IceRow(QWidget* parent = nullptr);

    /** Offers the ice heard now. */
    void showIce(const LinkStatus& status);
    /** Reports are possible in flight only. */
    void setReporting(bool isPossible);

signals:
    /** Emitted with the id of the target (`TrafficTarget`) that the crew reports. */
    void iceReported(std::uint32_t id);

private:
    QComboBox* m_targets;
    QPushButton* m_report;
};

} // namespace berg
