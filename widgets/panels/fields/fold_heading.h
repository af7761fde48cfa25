#pragma once

#include <QToolButton>

namespace berg {

/** Title of rows that it shows and hides: checked while they are shown. */
class FoldHeading : public QToolButton
{
    Q_OBJECT

public:
    explicit FoldHeading(const QString& title, QWidget* parent = nullptr);
};

} // namespace berg
