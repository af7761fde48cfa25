#include "widgets/panels/fields/wheel_guard.h"

#include <QEvent>
#include <QWidget>

namespace berg {
namespace {

class WheelGuard final : public QObject
{
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() != QEvent::Wheel)
            return false;
        const auto* input = qobject_cast<QWidget*>(watched);
        if (input == nullptr || input->hasFocus())
            return false;
        event->ignore();
        return true;
    }
};

} // namespace

void guardWheel(QWidget& input)
{
    input.setFocusPolicy(Qt::StrongFocus); // Qt's default also takes the focus by wheel
    input.installEventFilter(new WheelGuard(&input));
}

} // namespace berg
