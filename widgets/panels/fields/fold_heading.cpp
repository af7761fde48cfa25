#include "widgets/panels/fields/fold_heading.h"

namespace berg {

FoldHeading::FoldHeading(const QString& title, QWidget* parent) : QToolButton(parent)
{
    setText(title);
    setCheckable(true);
    setAutoRaise(true);
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    QFont strong = font();
    strong.setBold(true);
    setFont(strong);
    const auto showState = [this](bool open) {
        setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    };
    connect(this, &QToolButton::toggled, this, showState);
    showState(false);
}

} // namespace berg
