#pragma once

#include "app/layout/window_part.h"

#include <QPointer>

class QWidget;

namespace berg {

class ManualWindow;

/** F1 opens the manual at the section about the focused widget, in dialogs as well. */
class ManualHelp : public WindowPart
{
    Q_OBJECT

public:
    explicit ManualHelp(WindowContext& context);

    void open();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QPointer<ManualWindow> m_manual; ///< the last one opened
};

} // namespace berg
