#pragma once

#include "app/layout/window_part.h"

#include <QTimer>

namespace berg {

/**
 * The bell of the desktop at each new alarm or warning above the map, and again while an alarm is
 * not acknowledged; silent where the user has chosen so.
 */
class AlarmSound : public WindowPart
{
    Q_OBJECT

public:
    explicit AlarmSound(WindowContext& context);

    [[nodiscard]] bool isOn() const { return m_isOn; }
    /** By the user's choice, which is kept. */
    void setOn(bool isOn);

private:
    void setPending(bool isPending);
    void sound() const;

    QTimer m_again;
    bool m_isOn;
    bool m_isPending = false; ///< an alarm is not acknowledged
};

} // namespace berg
